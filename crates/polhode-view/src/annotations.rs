//! What is written on a picture: overlays with their scales, labels of bodies, axes and scale.
//!
//! Arrows of one quantity have one scale in all frames of a picture: the largest value, rounded up, has the longest
//! arrow.

use crate::camera::Camera;
use crate::colors;
use crate::lengths;
use crate::overlay::{Overlay, TouchKind};
use crate::raster::canvas::{Canvas, Ink, Spot};
use crate::raster::{Picture, ground, marks};
use crate::recording::Recording;
use crate::scale::{Corner, RIM, Scale};
use polhode::spatial::DVec3;

/// Length of the longest arrow as a fraction of the picture's height.
const LONGEST_ARROW: f64 = 0.2;
/// Bodies of which names are written at the most.
const MOST_NAMES: usize = 60;

/// The largest value of each quantity that has arrows, in all frames.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Largest {
    speed: f64,
    spin: f64,
    force: f64,
}

impl Largest {
    /// That of some frames of a recording.
    pub(crate) fn of(recording: &Recording, frames: std::ops::Range<usize>) -> Self {
        let mut largest = Self::default();
        for frame in frames {
            for [speed, spin] in recording.velocities(frame) {
                largest.speed = largest.speed.max(speed.length());
                largest.spin = largest.spin.max(spin.length());
            }
            let forces = recording.touches(frame).iter().map(|touch| touch.force.length());
            largest.force = forces.fold(largest.force, f64::max);
        }
        largest
    }
}

/// What a picture is annotated with.
pub(crate) struct Annotations<'a> {
    pub(crate) recording: &'a Recording,
    pub(crate) frame: usize,
    pub(crate) camera: Camera,
    /// Corners of the box that the picture holds, m.
    pub(crate) bounds: [DVec3; 2],
    pub(crate) overlays: &'a [Overlay],
    pub(crate) largest: Largest,
    /// Where axes and scale stand.
    pub(crate) corner: Corner,
}

/// A line of the legend.
struct Key {
    color: [u8; 3],
    text: String,
}

impl Annotations<'_> {
    /// Writes on a picture.
    pub(crate) fn draw(&self, picture: &mut Picture) {
        let mut canvas = Canvas::new(picture);
        let mut keys = Vec::new();
        for overlay in self.overlays {
            keys.extend(self.overlay(&mut canvas, *overlay));
        }
        self.labels(&mut canvas);
        let has_grid = self.recording.shown().bodies.iter().any(|body| !body.shape.half_spaces.is_empty());
        let cell_m = has_grid.then(|| ground::spacing_m(self.bounds));
        Scale { camera: &self.camera, cell_m, corner: self.corner }.draw(&mut canvas);
        legend(&mut canvas, &keys);
    }

    /// Where a place is on the picture; nothing where it is behind the camera.
    fn spot(&self, canvas: &Canvas<'_>, place: DVec3) -> Option<Spot> {
        self.camera.spot(place, canvas.size())
    }

    /// Pixels of a metre in the middle of what is looked at.
    fn pixels_of_metre(&self, canvas: &Canvas<'_>) -> f64 {
        self.camera.pixels_of_metre(canvas.size()[1])
    }

    /// Draws an overlay; its lines of the legend.
    fn overlay(&self, canvas: &mut Canvas<'_>, overlay: Overlay) -> Vec<Key> {
        let (recording, frame) = (self.recording, self.frame);
        let middles = || self.middles();
        match overlay {
            Overlay::Velocities => {
                let arrows = middles().zip(recording.velocities(frame)).map(|(place, [speed, _])| (place, speed));
                let arrows: Vec<_> = arrows.collect();
                vec![self.arrows(canvas, &arrows, "velocity, m/s", colors::VELOCITY, self.largest.speed)]
            }
            Overlay::Spins => {
                let arrows: Vec<_> =
                    middles().zip(recording.velocities(frame)).map(|(place, [_, spin])| (place, spin)).collect();
                vec![self.arrows(canvas, &arrows, "angular velocity, rad/s", colors::SPIN, self.largest.spin)]
            }
            Overlay::Forces => {
                let of_kind = |kind: TouchKind| -> Vec<(DVec3, DVec3)> {
                    let own = recording.touches(frame).iter().filter(|touch| touch.kind == kind);
                    own.map(|touch| (touch.place, touch.force)).collect()
                };
                let (contacts, loads) = (of_kind(TouchKind::Contact), of_kind(TouchKind::Joint));
                let contact =
                    self.arrows(canvas, &contacts, "force at a contact, N", colors::FORCE, self.largest.force);
                let load = self.arrows(canvas, &loads, "force of a joint, N", colors::LOAD, self.largest.force);
                [(contact, contacts.is_empty()), (load, loads.is_empty())]
                    .into_iter()
                    .filter_map(|(key, is_empty)| (!is_empty).then_some(key))
                    .collect()
            }
            Overlay::Traces => {
                self.traces(canvas);
                Vec::new()
            }
            Overlay::Names => {
                self.names(canvas);
                Vec::new()
            }
        }
    }

    /// Centres of mass of the bodies that move, m.
    fn middles(&self) -> impl Iterator<Item = DVec3> + '_ {
        let shown = self.recording.shown();
        let poses = self.recording.moving_poses(self.frame);
        shown.moving.iter().zip(poses).map(|(&body, pose)| pose.transform_point(shown.bodies[body].center_of_mass))
    }

    /// Arrows from places along vectors.
    fn arrows(
        &self,
        canvas: &mut Canvas<'_>,
        arrows: &[(DVec3, DVec3)],
        what: &str,
        color: [u8; 3],
        largest: f64,
    ) -> Key {
        let full = lengths::rounded_up(largest);
        let longest_m = LONGEST_ARROW * canvas.size()[1] / self.pixels_of_metre(canvas);
        let width = 1.6 * canvas.row_px;
        for &(place, vector) in arrows {
            let tip = place + vector * (longest_m / full);
            if let (Some(from), Some(to)) = (self.spot(canvas, place), self.spot(canvas, tip)) {
                canvas.arrow([from, to], width, Ink::solid(color));
                canvas.disc(from, 0.8 * width, Ink::solid(color));
            }
        }
        let text = if largest > 0.0 {
            format!("{what}: {} is {} long", lengths::short(full), lengths::words(longest_m))
        } else {
            format!("{what}: none")
        };
        Key { color, text }
    }

    /// Where bodies have been.
    fn traces(&self, canvas: &mut Canvas<'_>) {
        let shown = self.recording.shown();
        for (place, &body) in shown.moving.iter().enumerate() {
            let path = marks::path(self.recording, &shown.bodies[body], place, self.frame);
            let ink = Ink { color: shown.color(body), opacity: 0.9 };
            let spots: Vec<_> = path.into_iter().map(|place| self.spot(canvas, place)).collect();
            for ends in spots.windows(2) {
                if let [Some(a), Some(b)] = ends {
                    canvas.line([*a, *b], 1.2 * canvas.row_px, ink);
                }
            }
        }
    }

    fn names(&self, canvas: &mut Canvas<'_>) {
        let shown = self.recording.shown();
        let poses = self.recording.moving_poses(self.frame);
        for (&body, pose) in shown.moving.iter().zip(poses).take(MOST_NAMES) {
            self.word(canvas, shown.bodies[body].middle(pose), &shown.bodies[body].name);
        }
    }

    /// The labels that the scene gives to bodies.
    fn labels(&self, canvas: &mut Canvas<'_>) {
        let shown = self.recording.shown();
        for (body, pose) in shown.bodies.iter().zip(self.recording.poses(self.frame)) {
            if let Some(label) = body.look.label.as_deref().filter(|_| body.look.opacity > 0.0) {
                self.word(canvas, body.middle(&pose), label);
            }
        }
    }

    /// Words on a plate about a place.
    fn word(&self, canvas: &mut Canvas<'_>, place: DVec3, text: &str) {
        let Some([x, y]) = self.spot(canvas, place) else { return };
        let (width, row) = (canvas.width_of(text), canvas.row_px);
        let left = x - 0.5 * width;
        let corners = [[left - 3.0 * row, y - 6.5 * row], [left + width + 3.0 * row, y + 6.5 * row]];
        canvas.plate(corners, 3.0 * row);
        canvas.words([left, y + 3.0 * row], text, Ink::solid(colors::INK));
    }
}

/// The meanings of colours on a plate, each colour once.
fn legend(canvas: &mut Canvas<'_>, keys: &[Key]) {
    if keys.is_empty() {
        return;
    }
    let (row, line) = (canvas.row_px, canvas.line_height());
    let width = keys.iter().map(|key| canvas.width_of(&key.text)).fold(0.0, f64::max);
    let rim = 0.5 * RIM * row;
    let corners = [[rim, rim], [rim + width + 24.0 * row, rim + line * keys.len() as f64 + 4.0 * row]];
    canvas.plate(corners, 4.0 * row);
    for (number, key) in keys.iter().enumerate() {
        let y = rim + line * (number as f64 + 0.5) + 2.0 * row;
        canvas.line([[rim + 5.0 * row, y], [rim + 15.0 * row, y]], 2.5 * row, Ink::solid(key.color));
        canvas.words([rim + 20.0 * row, y + 3.0 * row], &key.text, Ink::solid(colors::INK));
    }
}

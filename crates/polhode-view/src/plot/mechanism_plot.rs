//! The motion that begins in a structure: outlines at rest and a little later, with the hinges.
//!
//! It is seen along the axis about which most of it turns, across gravity, without perspective; bodies farther away are
//! drawn first. A body is drawn by the hulls of its parts. Displacements are the velocities of the motion times one
//! time, `u = (v_cm + w x (p - p_cm)) s` (m), so that the largest is a fixed part of the figure: hinges stay closed to
//! first order, and shapes are stretched by the square of the angle.

use super::ink::Ink;
use super::svg::{Anchor, Spot, Stroke, Svg, Type};
use super::text_width::{cut_to, lines_of};
use crate::mesh_library::MeshLibrary;
use crate::shown_body::ShownBody;
use crate::shown_scene::ShownScene;
use polhode::Scene;
use polhode::spatial::DVec3;
use polhode::stability::{Beginning, MovingBody};

/// Width of the figure, and its height at the least and at the most, without the texts, pixels.
const WIDTH: f64 = 860.0;
const HEIGHTS: [f64; 2] = [260.0, 700.0];
/// Room around the bodies, pixels.
const MARGIN: f64 = 40.0;
/// Room for the texts above, and for the legend below, pixels.
const TOP: f64 = 76.0;
const LEGEND: f64 = 34.0;
/// The largest displacement, as a part of the diagonal of what is drawn.
const SHIFT: f64 = 0.05;
/// The largest angle of a displacement, rad: beyond it shapes are no longer like themselves.
const TURN: f64 = 0.35;
/// Most bodies whose names are written.
const MOST_NAMES: usize = 12;
/// Rotations of the bodies whose sum is below this, rad/s, cancel: the picture is square to the fastest body then.
const LEVEL: f64 = 1e-3;

/// The motion that begins.
#[derive(Debug, Clone, Copy)]
pub struct MechanismPlot<'a> {
    /// What it is of.
    pub title: &'a str,
    /// What there is to know besides.
    pub subtitle: &'a str,
    /// The scene, at its start.
    pub scene: &'a Scene,
    /// The bodies that move.
    pub bodies: &'a [MovingBody],
    /// The places of hinges, each with the body that it is drawn to move with, world, m.
    pub hinges: &'a [HingeMark],
}

/// A hinge in a figure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HingeMark {
    /// One of its bodies.
    pub body: polhode::BodyId,
    /// Its place, world, m.
    pub place: DVec3,
}

/// From the world to the figure.
#[derive(Debug, Clone, Copy)]
struct Sight {
    right: DVec3,
    up: DVec3,
    /// Away from whoever looks.
    away: DVec3,
    /// The middle of what is drawn, right and up, m.
    middle: Spot,
    /// Pixels for a metre.
    scale: f64,
    /// Where the middle is drawn, pixels.
    place: Spot,
}

impl Sight {
    fn flat(&self, point: DVec3) -> Spot {
        [point.dot(self.right), point.dot(self.up)]
    }

    fn spot(&self, point: DVec3) -> Spot {
        let [x, y] = self.flat(point);
        [self.place[0] + (x - self.middle[0]) * self.scale, self.place[1] - (y - self.middle[1]) * self.scale]
    }
}

impl MechanismPlot<'_> {
    /// The figure as SVG.
    pub fn svg(&self) -> String {
        let mut library = MeshLibrary::default();
        let shown = ShownScene::new(self.scene, &mut library);
        let solids: Vec<Solid> = shown.bodies.iter().map(|body| Solid::of(body, &library)).collect();
        let (sight, height) = self.sight(&solids);
        let mut order: Vec<usize> = (0..solids.len()).collect();
        let depth = |body: &usize| solids[*body].middle.dot(sight.away);
        order.sort_by(|a, b| depth(b).total_cmp(&depth(a)));
        let seconds = self.seconds(&solids);
        let mut svg = Svg::new([WIDTH, height], self.title);
        draw_grounds(&mut svg, &shown, &sight, height);
        for &body in &order {
            draw(&mut svg, &solids[body], &sight, |point| point, None);
        }
        for &body in &order {
            if let Some(motion) = self.motion(body) {
                draw(&mut svg, &solids[body], &sight, |point| self.moved(motion, point, seconds), Some(ink_of(motion)));
            }
        }
        self.draw_marks(&mut svg, &solids, &sight, seconds);
        self.draw_texts(&mut svg, height);
        svg.finish()
    }

    fn motion(&self, body: usize) -> Option<&MovingBody> {
        self.bodies.iter().find(|own| own.body.index() == body)
    }

    /// A point of a body that moves, this much later.
    fn moved(&self, motion: &MovingBody, point: DVec3, seconds: f64) -> DVec3 {
        let body = self.scene.bodies().get(motion.body.index());
        let center =
            body.and_then(|body| Some(body.initial_pose().transform_point(body.mass_properties()?.center_of_mass())));
        point + motion.velocity.at(point - center.unwrap_or(point)) * seconds
    }

    /// After which time the largest displacement is as large as it is drawn.
    fn seconds(&self, solids: &[Solid]) -> f64 {
        let mut fastest = 0.0_f64;
        let mut turning = 0.0_f64;
        for motion in self.bodies {
            turning = turning.max(motion.velocity.angular.length());
            for point in solids.get(motion.body.index()).into_iter().flat_map(Solid::points) {
                fastest = fastest.max((self.moved(motion, point, 1.0) - point).length());
            }
        }
        let size = bounds(seen(solids)).map_or(1.0, |[low, high]| (high - low).length());
        let by_shift = if fastest > 0.0 { SHIFT * size / fastest } else { 0.0 };
        if turning > 0.0 { by_shift.min(TURN / turning) } else { by_shift }
    }

    /// From where it is seen, and the height of the figure.
    fn sight(&self, solids: &[Solid]) -> (Sight, f64) {
        let up = (-self.scene.gravity()).try_normalize().unwrap_or(DVec3::Z);
        let level = |vector: DVec3| vector.reject_from_normalized(up);
        // Axes that point opposite ways are one.
        let mut axis = DVec3::ZERO;
        for own in self.bodies {
            let turning = level(own.velocity.angular);
            axis += if turning.dot(axis) < 0.0 { -turning } else { turning };
        }
        let moving = self.bodies.iter().map(|own| level(own.velocity.linear));
        let fastest = moving.max_by(|a, b| a.length().total_cmp(&b.length())).unwrap_or(DVec3::ZERO);
        let along = if axis.length() > LEVEL { axis } else { fastest.cross(up) };
        let away = along.try_normalize().unwrap_or_else(|| up.any_orthonormal_vector());
        // Of both sides that from which x goes to the right.
        let away = if away.cross(up).dot(DVec3::X + 0.5 * DVec3::Y) < 0.0 { -away } else { away };
        let mut sight =
            Sight { right: away.cross(up), up, away, middle: [0.0; 2], scale: 1.0, place: [0.5 * WIDTH, 0.0] };
        let flat: Vec<Spot> = seen(solids).map(|point| sight.flat(point)).collect();
        let (low, high) = flat.iter().fold(([f64::MAX; 2], [f64::MIN; 2]), |(low, high), spot| {
            ([0, 1].map(|i| low[i].min(spot[i])), [0, 1].map(|i| high[i].max(spot[i])))
        });
        let size = [0, 1].map(|i: usize| (high[i] - low[i]).max(0.0));
        let fit = |room: f64, size: f64| if size > 0.0 { room / size } else { f64::MAX };
        let largest = fit(WIDTH - 2.0 * MARGIN, size[0]).min(fit(HEIGHTS[1] - 2.0 * MARGIN, size[1]));
        sight.scale = if largest < f64::MAX { largest } else { 1.0 };
        sight.middle = [0, 1].map(|i: usize| 0.5 * (low[i] + high[i]));
        let room = (size[1] * sight.scale + 2.0 * MARGIN).clamp(HEIGHTS[0], HEIGHTS[1]);
        sight.place[1] = TOP + 0.5 * room;
        (sight, TOP + room + LEGEND)
    }

    /// Hinges and names.
    fn draw_marks(&self, svg: &mut Svg, solids: &[Solid], sight: &Sight, seconds: f64) {
        for hinge in self.hinges {
            let motion = self.motion(hinge.body.index());
            let place = motion.map_or(hinge.place, |motion| self.moved(motion, hinge.place, seconds));
            svg.disc(sight.spot(place), 5.0, Ink::Ground);
            svg.ring(sight.spot(place), 5.0, Stroke::new(Ink::Text, 2.0));
        }
        let named = if self.bodies.len() <= MOST_NAMES { self.bodies } else { &[] };
        for motion in named {
            let number = motion.body.index();
            if let (Some(body), Some(solid)) = (self.scene.bodies().get(number), solids.get(number)) {
                let place = self.moved(motion, solid.middle, seconds);
                let kind = Type::new(11.0, Ink::Text).anchor(Anchor::Middle);
                svg.text_on_ground(sight.spot(place), body.name(), kind);
            }
        }
    }

    fn draw_texts(&self, svg: &mut Svg, height: f64) {
        let room = WIDTH - 24.0;
        svg.rectangle([0.0, 0.0], [WIDTH, TOP - 8.0], Ink::Ground, 1.0);
        svg.rectangle([0.0, height - LEGEND + 4.0], [WIDTH, height], Ink::Ground, 1.0);
        svg.text([12.0, 18.0], &cut_to(self.title, 16.0, room), Type::new(16.0, Ink::Text).bold());
        for (line, y) in lines_of(self.subtitle, 12.0, room, 2).iter().zip([39.0, 55.0]) {
            svg.text([12.0, y], line, Type::new(12.0, Ink::Faint));
        }
        let y = height - 12.0;
        let mut x = 12.0;
        for (beginning, word) in [(Beginning::Tips, "turns"), (Beginning::Slides, "moves without turning")] {
            if self.bodies.iter().any(|own| own.beginning == beginning) {
                svg.rectangle([x, y - 6.0], [x + 18.0, y + 6.0], ink(beginning), 0.5);
                svg.text([x + 24.0, y], word, Type::new(12.0, Ink::Text));
                x += 60.0 + 7.0 * word.len() as f64;
            }
        }
        if !self.hinges.is_empty() {
            svg.ring([x + 6.0, y], 5.0, Stroke::new(Ink::Text, 2.0));
            svg.text([x + 18.0, y], "hinge", Type::new(12.0, Ink::Text));
            x += 70.0;
        }
        svg.text([x, y], "displacements are not to scale", Type::new(12.0, Ink::Faint));
    }
}

/// What a body that moves is drawn in.
fn ink_of(motion: &MovingBody) -> Ink {
    ink(motion.beginning)
}

fn ink(beginning: Beginning) -> Ink {
    if beginning == Beginning::Tips { Ink::Vermilion } else { Ink::Blue }
}

/// The parts of a body in the world at the start.
#[derive(Debug)]
struct Solid {
    /// The corners of each part, m.
    parts: Vec<Vec<DVec3>>,
    middle: DVec3,
    moves: bool,
}

impl Solid {
    fn of(body: &ShownBody, library: &MeshLibrary) -> Self {
        let part = |part: &crate::tessellation::Part| {
            let mesh = library.meshes().get(part.mesh);
            let positions = mesh.map_or(&[][..], |mesh| &mesh.positions);
            positions.iter().map(|&point| body.initial.transform_point(part.point(point))).collect()
        };
        let parts = body.shape.parts.iter().map(part).collect();
        Self { parts, middle: body.middle(&body.initial), moves: body.moves }
    }

    fn points(&self) -> impl Iterator<Item = DVec3> + '_ {
        self.parts.iter().flatten().copied()
    }
}

/// A body with its points in these places: grey at rest, else in this ink.
fn draw(svg: &mut Svg, solid: &Solid, sight: &Sight, place: impl Fn(DVec3) -> DVec3, ink: Option<Ink>) {
    for part in &solid.parts {
        let outline = hull(part.iter().map(|&point| sight.spot(place(point))).collect());
        let closed: Vec<Spot> = outline.iter().chain(outline.first()).copied().collect();
        if let Some(ink) = ink {
            svg.area(&outline, ink, 0.3);
            svg.line(&closed, Stroke::new(ink, 1.4));
        } else {
            svg.area(&outline, Ink::Grid, 0.6);
            svg.line(&closed, Stroke::new(Ink::Faint, 0.7));
        }
    }
}

/// The points that the figure must hold: of bodies that can move, or of all where none can.
fn seen(solids: &[Solid]) -> impl Iterator<Item = DVec3> {
    let any_moves = solids.iter().any(|solid| solid.moves);
    solids.iter().filter(move |solid| solid.moves || !any_moves).flat_map(Solid::points)
}

/// Smallest and largest coordinates.
fn bounds(points: impl Iterator<Item = DVec3>) -> Option<[DVec3; 2]> {
    points.fold(None, |bounds, point| {
        let [low, high] = bounds.unwrap_or([point; 2]);
        Some([low.min(point), high.max(point)])
    })
}

/// The corners of the convex hull, anticlockwise seen with y up (Andrew's monotone chain).
fn hull(mut spots: Vec<Spot>) -> Vec<Spot> {
    spots.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    spots.dedup();
    if spots.len() < 3 {
        return spots;
    }
    let mut lower = chain(spots.iter().copied());
    lower.extend(chain(spots.iter().rev().copied()));
    lower
}

/// One side of a hull, from places in order, without its last corner.
fn chain(spots: impl Iterator<Item = Spot>) -> Vec<Spot> {
    let turns_right = |[a, b]: [Spot; 2], c: Spot| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) <= 0.0;
    let mut chain: Vec<Spot> = Vec::new();
    for spot in spots {
        while let [.., a, b] = chain[..]
            && turns_right([a, b], spot)
        {
            chain.pop();
        }
        chain.push(spot);
    }
    chain.pop();
    chain
}

/// Half-spaces that are seen from the side: a line.
fn draw_grounds(svg: &mut Svg, shown: &ShownScene, sight: &Sight, height: f64) {
    for body in &shown.bodies {
        for half_space in &body.shape.half_spaces {
            let normal = body.initial.rotation.rotate(half_space.normal());
            let along = sight.away.cross(normal);
            if along.length() < 0.5 {
                continue;
            }
            let far = along.normalize_or_zero() * (2.0 * WIDTH / sight.scale);
            let [center_x, center_y] = sight.middle;
            let center = sight.right * center_x + sight.up * center_y;
            let on_plane = center - normal * (normal.dot(center - body.initial.translation) - half_space.offset());
            let deep = normal * (2.0 * height / sight.scale);
            let corners = [on_plane - far, on_plane + far, on_plane + far - deep, on_plane - far - deep];
            svg.polygon(&corners.map(|point| sight.spot(point)), Ink::Grid);
            svg.line(&[on_plane - far, on_plane + far].map(|point| sight.spot(point)), Stroke::new(Ink::Faint, 1.0));
        }
    }
}

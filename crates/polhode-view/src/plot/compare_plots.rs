//! Plots of two trajectories compared: how far apart they are over time.
//!
//! | quantity | is |
//! |---|---|
//! | position | distance of the origins of a body in both, m |
//! | attitude | angle of the rotation between both attitudes, rad |
//! | velocity | length of the difference of velocities of the centres of mass, m/s |
//! | energy | of kinetic energy and that of gravity, all bodies together, J; it needs the masses of a scene |
//!
//! Where the trajectories have the estimated errors of their samples, a band around a curve of positions or attitudes
//! reaches as far as both errors together: where it reaches the foot, the difference says nothing.
//!
//! Axes are logarithmic; what does not differ is at their foot. The energies of springs and other forces are not in it,
//! for they are no matter of poses and velocities alone.

use super::axes;
use super::ink::Ink;
use super::time_chart::{AxisKind, Band, Course, Line, OVER_TIME, Panel, Stop, TimeChart};
use super::trace::Trace;
use polhode::spatial::DVec3;
use polhode::{BodyError, BodySample, Scene};
use std::collections::BTreeMap;

/// Bodies up to which each has its line; of more only the largest difference is drawn.
const MOST_LINES: usize = 7;

/// What can be plotted of two trajectories.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ComparePlot {
    /// Distance of the bodies' origins.
    Positions,
    /// Angle between their attitudes.
    Attitudes,
    /// Difference of the velocities of their centres of mass.
    Velocities,
    /// Difference of the energies of all bodies.
    Energy,
}

impl ComparePlot {
    /// All, in the order in which they are drawn.
    pub const ALL: [Self; 4] = [Self::Positions, Self::Attitudes, Self::Velocities, Self::Energy];

    const fn title(self) -> [&'static str; 2] {
        match self {
            Self::Positions => ["distance of positions, m", "m"],
            Self::Attitudes => ["angle between attitudes, rad", "rad"],
            Self::Velocities => ["difference of velocities, m/s", "m/s"],
            Self::Energy => ["difference of energy, J", "J"],
        }
    }
}

/// Quantities that every body has, in the order of [`ComparePlot::ALL`].
const OF_BODIES: usize = 3;

/// The first of them, which have errors.
const OF_ERRORS: usize = 2;

/// Differences of a body, and the largest of all bodies at the present time.
#[derive(Debug, Clone, Default)]
struct Differences {
    traces: [Trace; OF_BODIES],
    /// Of positions and attitudes; empty where errors are not known.
    bands: [Band; OF_ERRORS],
}

/// Keeps what is plotted of two trajectories.
#[derive(Debug, Clone)]
pub struct ComparePlots {
    asked: Vec<ComparePlot>,
    scene: Option<Masses>,
    /// Differences of the first bodies, by their names in the order of the file.
    bodies: Vec<(String, Differences)>,
    /// Bodies of a sample.
    count: usize,
    largest: Differences,
    energy: Trace,
    /// What has been added of the present sample.
    present: Option<Present>,
}

/// The sample that is being added.
#[derive(Debug, Clone)]
struct Present {
    t_s: f64,
    bodies: usize,
    largest: [f64; OF_BODIES],
    energies: [f64; 2],
}

impl ComparePlots {
    /// Nothing yet; energies need the masses of a scene.
    pub fn new(asked: &[ComparePlot], scene: Option<&Scene>) -> Self {
        Self {
            asked: ComparePlot::ALL.into_iter().filter(|plot| asked.contains(plot)).collect(),
            scene: scene.map(Masses::of),
            bodies: Vec::new(),
            count: 0,
            largest: Differences::default(),
            energy: Trace::default(),
            present: None,
        }
    }

    /// Adds a body at a time (s) of both trajectories, with its estimated errors where both are known; bodies of one
    /// time follow each other.
    pub fn push(&mut self, t_s: f64, body: &str, [a, b]: [&BodySample; 2], errors: Option<[BodyError; 2]>) {
        if self.present.as_ref().is_some_and(|present| present.t_s.to_bits() != t_s.to_bits()) {
            self.end_sample();
        }
        let differences = [
            (a.pose.translation - b.pose.translation).length(),
            a.pose.rotation.angle_to(b.pose.rotation),
            (a.velocity.linear - b.velocity.linear).length(),
        ];
        let energies = match &self.scene {
            Some(masses) => [a, b].map(|sample| masses.energy_j(body, sample)),
            None => [0.0; 2],
        };
        let nothing = Present { t_s, bodies: 0, largest: [0.0; OF_BODIES], energies: [0.0; 2] };
        let present = self.present.get_or_insert(nothing);
        let number = present.bodies;
        present.bodies += 1;
        for (largest, difference) in present.largest.iter_mut().zip(differences) {
            *largest = if difference.is_nan() { difference } else { largest.max(difference) };
        }
        for (sum, energy) in present.energies.iter_mut().zip(energies) {
            *sum += energy;
        }
        if number >= MOST_LINES {
            return;
        }
        if number >= self.bodies.len() {
            self.bodies.push((body.to_owned(), Differences::default()));
        }
        if let Some((_, own)) = self.bodies.get_mut(number) {
            for (trace, difference) in own.traces.iter_mut().zip(differences) {
                trace.push(t_s, difference);
            }
            let Some([a, b]) = errors else { return };
            let sums = [a.position_m + b.position_m, a.rotation_rad + b.rotation_rad];
            for (band, (difference, error)) in own.bands.iter_mut().zip(differences.into_iter().zip(sums)) {
                band.low.push(t_s, (difference - error).max(0.0));
                band.high.push(t_s, difference + error);
            }
        }
    }

    fn end_sample(&mut self) {
        let Some(Present { t_s, bodies, largest, energies: [a, b] }) = self.present.take() else { return };
        self.count = self.count.max(bodies);
        for (trace, value) in self.largest.traces.iter_mut().zip(largest) {
            trace.push(t_s, value);
        }
        self.energy.push(t_s, a - b);
    }

    /// The figure as SVG; `ended` says why comparing ended before both files did.
    pub fn svg(&mut self, [a, b]: [&str; 2], ended: Option<&str>) -> String {
        self.end_sample();
        let reached = self.largest.traces[0].samples().last().map_or(0.0, |[t_s, _]| t_s);
        let stop = ended.map(|reason| Stop { t_s: reached, reason: reason.to_owned() });
        let panels = self.asked.iter().map(|&plot| self.panel(plot)).collect();
        let (title, subtitle) = (format!("{a} compared with {b}"), "differences over time".to_owned());
        let along = OVER_TIME.to_owned();
        TimeChart { title, subtitle, along, events: Vec::new(), panels, stop }.svg()
    }

    fn panel(&self, plot: ComparePlot) -> Panel {
        let [title, unit] = plot.title();
        let with_bands = |number: usize| {
            let bands: Vec<Band> = self.bands(number);
            let note = if bands.is_empty() { "" } else { "bands: as far as the estimated errors of both reach" };
            (self.lines(number, unit), note.to_owned(), bands)
        };
        let (lines, note, bands) = match plot {
            ComparePlot::Positions => with_bands(0),
            ComparePlot::Attitudes => with_bands(1),
            ComparePlot::Velocities => (self.lines(2, unit), String::new(), Vec::new()),
            ComparePlot::Energy => {
                let label = labelled("all bodies", &self.energy, unit);
                let line = Line { label, ink: Ink::Blue, course: Course::Straight, trace: self.energy.clone() };
                let note = "kinetic energy and that of gravity; magnitude, the label has the last value".to_owned();
                (vec![line], note, Vec::new())
            }
        };
        Panel { title: title.to_owned(), note, axis: AxisKind::Logarithmic, lines, bands }
    }

    /// The bodies that each have a line.
    fn differing(&self, number: usize) -> Vec<&(String, Differences)> {
        let differ = |(_, own): &&(String, Differences)| own.traces[number].is_anything();
        if self.count > MOST_LINES { Vec::new() } else { self.bodies.iter().filter(differ).collect() }
    }

    /// The bands of the lines, in their order; none where errors are not known.
    fn bands(&self, number: usize) -> Vec<Band> {
        let bands: Vec<Band> = self.differing(number).into_iter().map(|(_, own)| own.bands[number].clone()).collect();
        if bands.iter().any(|band| band.high.is_anything()) { bands } else { Vec::new() }
    }

    /// One line a body; of many bodies the largest difference alone. Bodies that are the same throughout have none.
    fn lines(&self, number: usize, unit: &str) -> Vec<Line> {
        let line = |name: &str, ink: Ink, trace: &Trace| Line {
            label: labelled(name, trace, unit),
            ink,
            course: Course::Straight,
            trace: trace.clone(),
        };
        let own = self.differing(number);
        let largest = &self.largest.traces[number];
        if own.is_empty() {
            return vec![line(&format!("largest of {} bodies", self.count), Ink::Blue, largest)];
        }
        let inks = (0..).map(Ink::of_curve);
        own.into_iter().zip(inks).map(|((name, own), ink)| line(name, ink, &own.traces[number])).collect()
    }
}

fn labelled(name: &str, trace: &Trace, unit: &str) -> String {
    let Some([_, last]) = trace.last() else { return format!("{name}: none") };
    let value = axes::value(last, unit);
    if unit == "rad" {
        format!("{name} {value} ({})", axes::value(last.to_degrees(), "\u{b0}"))
    } else {
        format!("{name} {value}")
    }
}

/// The masses of a scene, and its gravity.
#[derive(Debug, Clone)]
struct Masses {
    gravity: DVec3,
    bodies: BTreeMap<String, polhode::spatial::MassProperties>,
}

impl Masses {
    fn of(scene: &Scene) -> Self {
        let movable = scene.bodies().iter().filter_map(|body| Some((body.name().to_owned(), *body.mass_properties()?)));
        Self { gravity: scene.gravity(), bodies: movable.collect() }
    }

    /// `m v.v / 2 + w.I w / 2 - m g.x_cm`, J; nothing for a body that no force moves.
    fn energy_j(&self, body: &str, sample: &BodySample) -> f64 {
        let Some(properties) = self.bodies.get(body) else { return 0.0 };
        let (v, w) = (sample.velocity.linear, sample.velocity.angular);
        let own = sample.pose.rotation.inverse_rotate(w);
        let center_m = sample.pose.transform_point(properties.center_of_mass());
        let rotation_j = 0.5 * own.dot(properties.inertia().matrix() * own);
        0.5 * properties.mass() * v.length_squared() + rotation_j - properties.mass() * self.gravity.dot(center_m)
    }
}

//! Curves of the joints of a run: coordinates, rates, loads and powers.

use super::axes;
use super::ink::Ink;
use super::run_plot::RunPlot;
use super::time_chart::{AxisKind, Course, Line, Panel};
use super::trace::Trace;
use polhode::scene::Coordinate;
use polhode::{JointId, JointSample};

/// The inks of curves: as many curves are drawn as there are.
const INKS: [Ink; 7] = [Ink::Blue, Ink::Vermilion, Ink::Green, Ink::Purple, Ink::Gold, Ink::Teal, Ink::Grey];

/// A curve of a joint.
#[derive(Debug, Clone)]
struct JointTrace {
    plot: RunPlot,
    joint: JointId,
    /// Whose coordinate it is, if it is one's.
    of: Option<Coordinate>,
    trace: Trace,
}

/// The curves of the joints that are asked for.
#[derive(Debug, Clone, Default)]
pub(super) struct JointTraces {
    names: Vec<String>,
    traces: Vec<JointTrace>,
}

impl JointTraces {
    /// Of joints that have these names by their handles.
    pub(super) const fn new(names: Vec<String>) -> Self {
        Self { names, traces: Vec::new() }
    }

    /// Keeps what is asked for of joints at a time, s.
    pub(super) fn push(&mut self, t_s: f64, joints: &[JointSample], asked: &[RunPlot]) {
        for sample in joints {
            for &plot in asked {
                match plot {
                    RunPlot::JointCoordinates => {
                        for (of, at) in &sample.coordinates {
                            self.keep(plot, sample.joint, Some(*of), [t_s, at.value]);
                        }
                    }
                    RunPlot::JointRates => {
                        for (of, at) in &sample.coordinates {
                            self.keep(plot, sample.joint, Some(*of), [t_s, at.rate]);
                        }
                    }
                    RunPlot::JointForces => {
                        if let Some(load) = &sample.load {
                            self.keep(plot, sample.joint, None, [t_s, load.force_n.length()]);
                        }
                    }
                    RunPlot::JointMoments => {
                        if let Some(load) = &sample.load {
                            self.keep(plot, sample.joint, None, [t_s, load.moment_n_m.length()]);
                        }
                    }
                    RunPlot::JointPowers => {
                        if let Some(power) = sample.power_w {
                            self.keep(plot, sample.joint, None, [t_s, power]);
                        }
                    }
                    _ => {}
                }
            }
        }
    }

    fn keep(&mut self, plot: RunPlot, joint: JointId, of: Option<Coordinate>, [t_s, value]: [f64; 2]) {
        let is_it = |own: &&mut JointTrace| own.plot == plot && own.joint == joint && own.of == of;
        if let Some(own) = self.traces.iter_mut().find(is_it) {
            own.trace.push(t_s, value);
            return;
        }
        if self.traces.iter().filter(|own| own.plot == plot).count() < INKS.len() {
            let mut trace = Trace::default();
            trace.push(t_s, value);
            self.traces.push(JointTrace { plot, joint, of, trace });
        }
    }

    /// The panel of a quantity of joints; none of one that is not theirs.
    pub(super) fn panel(&self, plot: RunPlot) -> Option<Panel> {
        let title = match plot {
            RunPlot::JointCoordinates => "coordinates of joints, rad or m",
            RunPlot::JointRates => "rates of joints, rad/s or m/s",
            RunPlot::JointForces => "forces in joints, N",
            RunPlot::JointMoments => "moments in joints, N m",
            RunPlot::JointPowers => "power of joints, W",
            _ => return None,
        };
        let own = self.traces.iter().filter(|own| own.plot == plot);
        let mut lines: Vec<Line> = own.zip(INKS).map(|(own, ink)| self.line(own, ink)).collect();
        let note = if lines.len() == INKS.len() { "the first seven; `--joints` writes all as CSV" } else { "" };
        if lines.is_empty() {
            let label = "joints: none".to_owned();
            lines.push(Line { label, ink: Ink::Grey, course: Course::Straight, trace: Trace::default() });
        }
        let (title, note, axis) = (title.to_owned(), note.to_owned(), AxisKind::Linear);
        Some(Panel { title, note, axis, lines, bands: Vec::new() })
    }

    fn line(&self, own: &JointTrace, ink: Ink) -> Line {
        let of_coordinate = |angle: &'static str, length: &'static str| match own.of {
            Some(Coordinate::Angle) => angle,
            _ => length,
        };
        let unit = match own.plot {
            RunPlot::JointCoordinates => of_coordinate("rad", "m"),
            RunPlot::JointRates => of_coordinate("rad/s", "m/s"),
            RunPlot::JointForces => "N",
            RunPlot::JointMoments => "N m",
            _ => "W",
        };
        let name = self.names.get(own.joint.index()).map_or("", String::as_str);
        let label =
            own.trace.last().map_or_else(|| name.to_owned(), |[_, last]| format!("{name} {}", axes::value(last, unit)));
        Line { label, ink, course: Course::Straight, trace: own.trace.clone() }
    }
}

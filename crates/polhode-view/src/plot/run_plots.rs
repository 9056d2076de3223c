//! Plots of a run over time: energy, ledger, penetration, contacts, steps and joints.
//!
//! An [`Observer`] keeps what is asked for while the run goes on, in memory that does not grow with it. A run that
//! stops early is drawn up to where it stopped.

use super::axes;
use super::event_times::EventTimes;
use super::ink::Ink;
use super::joint_traces::JointTraces;
use super::run_plot::RunPlot;
use super::time_chart::{AxisKind, Course, Line, OVER_TIME, Panel, Stop, TimeChart};
use super::trace::Trace;
use crate::penetration::{Depths, Penetration};
use polhode::{BodySample, Event, Frame, JointSample, MotionKind, Observer, Scene};

/// The quantities, in the order of [`values`].
const QUANTITIES: [Quantity; 15] = [
    Quantity::new(RunPlot::Energy, "kinetic", Ink::Blue),
    Quantity::new(RunPlot::Energy, "potential", Ink::Vermilion),
    Quantity::new(RunPlot::Energy, "total", Ink::Text),
    Quantity::new(RunPlot::Ledger, "impact", Ink::Vermilion),
    Quantity::new(RunPlot::Ledger, "friction", Ink::Gold),
    Quantity::new(RunPlot::Ledger, "rest", Ink::Purple),
    Quantity::new(RunPlot::Ledger, "damping", Ink::Green),
    Quantity::new(RunPlot::Ledger, "external work", Ink::Teal),
    Quantity::new(RunPlot::Ledger, "projection", Ink::Grey),
    Quantity::new(RunPlot::Ledger, "numerical", Ink::Blue),
    Quantity::new(RunPlot::Penetration, "largest so far", Ink::Grey),
    Quantity::new(RunPlot::Penetration, "now", Ink::Vermilion),
    Quantity::new(RunPlot::Contacts, "touching", Ink::Blue),
    Quantity::new(RunPlot::Contacts, "bearing a load", Ink::Vermilion),
    Quantity::new(RunPlot::Contacts, "bodies at rest", Ink::Green),
];

/// A quantity that every frame has.
#[derive(Debug, Clone, Copy)]
struct Quantity {
    plot: RunPlot,
    name: &'static str,
    ink: Ink,
}

impl Quantity {
    const fn new(plot: RunPlot, name: &'static str, ink: Ink) -> Self {
        Self { plot, name, ink }
    }
}

/// Keeps what is plotted of a run.
#[derive(Debug, Clone)]
pub struct RunPlots {
    title: String,
    asked: Vec<RunPlot>,
    traces: Vec<Trace>,
    joints: JointTraces,
    steps: Trace,
    /// Steps made, and the time that the last of them reached, s.
    made: u64,
    reached_s: Option<f64>,
    penetration: Penetration,
    events: EventTimes,
}

impl RunPlots {
    /// Of a scene from a time on, s; what is asked for twice is drawn once, in the order of [`RunPlot::ALL`] and
    /// [`RunPlot::OF_JOINTS`]. Joints have their numbers from 1 as names.
    pub fn new(scene: &Scene, from_s: f64, asked: &[RunPlot]) -> Self {
        Self {
            title: scene.name().to_owned(),
            asked: RunPlot::ALL.into_iter().chain(RunPlot::OF_JOINTS).filter(|plot| asked.contains(plot)).collect(),
            traces: vec![Trace::default(); QUANTITIES.len()],
            joints: JointTraces::new((1..=scene.joints().len()).map(|number| format!("joint {number}")).collect()),
            steps: Trace::default(),
            made: 0,
            reached_s: Some(from_s),
            penetration: Penetration::default(),
            events: EventTimes::new(scene.duration_s()),
        }
    }

    /// With other names of the joints, by their handles.
    #[must_use]
    pub fn with_joint_names(self, names: Vec<String>) -> Self {
        Self { joints: JointTraces::new(names), ..self }
    }

    /// The same with these alone, of those that were asked for.
    #[must_use]
    pub fn only(&self, asked: &[RunPlot]) -> Self {
        let mut fewer = self.clone();
        fewer.asked.retain(|plot| asked.contains(plot));
        fewer
    }

    /// The figure as SVG; `subtitle` says by which methods, `stopped` why a run ended before its time.
    pub fn svg(&self, subtitle: &str, stopped: Option<&str>) -> String {
        self.svg_with(Vec::new(), subtitle, stopped)
    }

    /// The same with further panels below.
    pub fn svg_with(&self, further: Vec<Panel>, subtitle: &str, stopped: Option<&str>) -> String {
        let stop = stopped.map(|reason| Stop { t_s: self.reached_s.unwrap_or_default(), reason: reason.to_owned() });
        let panels = self.asked.iter().map(|&plot| self.panel(plot)).chain(further).collect();
        let (title, subtitle, along) = (self.title.clone(), subtitle.to_owned(), OVER_TIME.to_owned());
        TimeChart { title, subtitle, along, events: self.events.rows(), panels, stop }.svg()
    }

    fn panel(&self, plot: RunPlot) -> Panel {
        if let Some(panel) = self.joints.panel(plot) {
            return panel;
        }
        let (title, note, axis) = match plot {
            RunPlot::Energy => ("energy, J", "", AxisKind::Linear),
            RunPlot::Ledger => {
                let note = "magnitudes; a label has the last value, which is positive for what was lost";
                ("ledger: where energy went, J", note, AxisKind::Logarithmic)
            }
            RunPlot::Penetration => ("penetration, m", "", AxisKind::Logarithmic),
            RunPlot::Contacts => ("contacts and bodies, number", "", AxisKind::Count),
            _ => ("length of the steps, s", "", AxisKind::Logarithmic),
        };
        let lines = if plot == RunPlot::Steps { vec![self.steps_line()] } else { self.lines(plot) };
        Panel { title: title.to_owned(), note: note.to_owned(), axis, lines, bands: Vec::new() }
    }

    fn lines(&self, plot: RunPlot) -> Vec<Line> {
        let unit = match plot {
            RunPlot::Energy | RunPlot::Ledger => "J",
            RunPlot::Penetration => "m",
            _ => "",
        };
        let own = QUANTITIES.iter().zip(&self.traces).filter(|(quantity, _)| quantity.plot == plot);
        // A term of the ledger that this run has none of says nothing; what the numbers lost is said when it is
        // nothing.
        let is_shown = |quantity: &Quantity, trace: &Trace| {
            plot != RunPlot::Ledger || quantity.name == "numerical" || trace.is_anything()
        };
        let shown = own.filter(|(quantity, trace)| is_shown(quantity, trace));
        shown
            .map(|(quantity, trace)| Line {
                label: labelled(quantity.name, trace, unit),
                ink: quantity.ink,
                course: match (plot, quantity.name) {
                    (RunPlot::Contacts, _) => Course::Steps,
                    (RunPlot::Penetration, "largest so far") => Course::Dashed,
                    _ => Course::Straight,
                },
                trace: trace.clone(),
            })
            .collect()
    }

    fn steps_line(&self) -> Line {
        let label = labelled(&format!("{} steps, last", self.made), &self.steps, "s");
        Line { label, ink: Ink::Blue, course: Course::Straight, trace: self.steps.clone() }
    }
}

/// A name and the last value.
fn labelled(name: &str, trace: &Trace, unit: &str) -> String {
    trace.last().map_or_else(|| format!("{name}: none"), |[_, last]| format!("{name} {}", axes::value(last, unit)))
}

impl Observer for RunPlots {
    fn sample(&mut self, _t: f64, _bodies: &[BodySample]) {}

    fn event(&mut self, event: &Event) {
        self.events.push(event);
    }

    fn wants_frames(&self) -> bool {
        self.asked.iter().any(|plot| *plot != RunPlot::Steps && RunPlot::ALL.contains(plot))
    }

    fn wants_joints(&self) -> bool {
        self.asked.iter().any(|plot| RunPlot::OF_JOINTS.contains(plot))
    }

    fn joints(&mut self, t_s: f64, joints: &[JointSample]) {
        self.joints.push(t_s, joints, &self.asked);
    }

    fn frame(&mut self, frame: &Frame) {
        let depths = self.penetration.of(frame);
        for (trace, value) in self.traces.iter_mut().zip(values(frame, depths)) {
            trace.push(frame.t_s, value);
        }
    }

    fn progress(&mut self, t: f64) -> polhode::Flow {
        let before = self.reached_s.replace(t).unwrap_or_default();
        if t > before {
            // A step has its length from its beginning to its end.
            self.steps.push(before, t - before);
            self.steps.push(t, t - before);
            self.made += 1;
        }
        polhode::Flow::Continue
    }
}

fn values(frame: &Frame, depths: Depths) -> [f64; QUANTITIES.len()] {
    let (energy, ledger) = (&frame.energy, &frame.ledger);
    let bearing = frame.contacts.iter().filter(|contact| contact.normal_force_n > 0.0).count();
    let at_rest = frame.motions.iter().filter(|motion| **motion == MotionKind::Rest).count();
    [
        energy.kinetic_j,
        energy.potential_j,
        energy.final_j,
        ledger.impact.value(),
        ledger.friction.value(),
        ledger.rest.value(),
        ledger.damping.value(),
        ledger.external.value(),
        ledger.projection.value(),
        ledger.numerical.value(),
        depths.largest_m,
        depths.now_m,
        frame.contacts.len() as f64,
        bearing as f64,
        at_rest as f64,
    ]
}

//! Plots of single quantities, over time or against each other: what a program has measured, by name.

use super::axes;
use super::ink::Ink;
use super::time_chart::{AxisKind, Course, Line, Panel, TimeChart};
use super::trace::{PathTrace, Trace};

/// The inks of curves, in their order.
const INKS: [Ink; 7] = [Ink::Blue, Ink::Vermilion, Ink::Green, Ink::Purple, Ink::Gold, Ink::Teal, Ink::Grey];

/// A curve of a panel.
#[derive(Debug, Clone)]
struct Curve {
    name: String,
    path: PathTrace,
}

/// A panel: curves of one unit.
#[derive(Debug, Clone)]
pub struct CurvePanel {
    title: String,
    unit: String,
    curves: Vec<Curve>,
}

impl CurvePanel {
    /// A panel with this title, of curves with these names, in a unit; empty where they have none.
    pub fn new(title: String, unit: &str, names: Vec<String>) -> Self {
        let curves = names.into_iter().map(|name| Curve { name, path: PathTrace::default() });
        Self { title, unit: unit.to_owned(), curves: curves.collect() }
    }

    /// Adds a value of the curve of this number: where it is along the axis (time, s, or a quantity), and how high.
    pub fn push(&mut self, curve: usize, [along, value]: [f64; 2]) {
        if let Some(curve) = self.curves.get_mut(curve) {
            curve.path.push(along, value);
        }
    }

    /// A cause that never acts says nothing: of several curves those are left out that are zero all the time.
    fn panel(&self) -> Panel {
        let is_shown = |(number, curve): &(usize, &Curve)| *number == 0 || curve.path.is_anything();
        let shown = self.curves.iter().enumerate().filter(is_shown);
        let line = |((_, curve), ink): ((usize, &Curve), Ink)| {
            let last = curve.path.last().map_or_else(|| "none".to_owned(), |own| axes::value(own[1], &self.unit));
            let label = format!("{} {last}", curve.name).trim_start().to_owned();
            Line { label, ink, course: Course::Straight, trace: Trace::whole(curve.path.samples()) }
        };
        Panel {
            title: if self.unit.is_empty() { self.title.clone() } else { format!("{}, {}", self.title, self.unit) },
            note: String::new(),
            axis: AxisKind::Linear,
            lines: shown.zip(INKS).map(line).collect(),
            bands: Vec::new(),
        }
    }
}

/// Panels over time, or against a quantity.
#[derive(Debug, Clone)]
pub struct Curves {
    title: String,
    /// What is along the axis, with its unit.
    along: String,
    panels: Vec<CurvePanel>,
}

impl Curves {
    /// With this title; `along` is what is along the axis, with its unit.
    pub const fn new(title: String, along: String, panels: Vec<CurvePanel>) -> Self {
        Self { title, along, panels }
    }

    /// A panel by its number.
    pub fn panel(&mut self, number: usize) -> Option<&mut CurvePanel> {
        self.panels.get_mut(number)
    }

    /// The panels, for a figure that has others too.
    pub fn panels(&self) -> Vec<Panel> {
        self.panels.iter().map(CurvePanel::panel).collect()
    }

    /// The figure as SVG; `subtitle` says by which methods, or why the run ended before its time.
    pub fn svg(&self, subtitle: &str) -> String {
        let (title, subtitle) = (self.title.clone(), subtitle.to_owned());
        TimeChart { title, subtitle, along: self.along.clone(), events: Vec::new(), panels: self.panels(), stop: None }
            .svg()
    }
}

#[cfg(test)]
mod tests {
    //! A figure names its axes and curves; what never acts is left out.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn curves_against_a_quantity_have_its_name_below_and_no_idle_ones() {
        let names = vec!["drive".to_owned(), "dry friction".to_owned(), "spring".to_owned()];
        let panel = CurvePanel::new("torque of crank".to_owned(), "N m", names);
        let mut curves = Curves::new("engine".to_owned(), "angle of crank, rad".to_owned(), vec![panel]);
        for step in 0..100 {
            let angle = f64::from(step) * 0.1;
            let panel = curves.panel(0).unwrap();
            panel.push(0, [libm::sin(angle), libm::cos(angle)]);
            panel.push(1, [angle, -0.25]);
            panel.push(2, [angle, 0.0]);
        }
        let svg = curves.svg("");
        for text in ["torque of crank, N m", "angle of crank, rad", "drive", "dry friction"] {
            assert!(svg.contains(text), "{text}");
        }
        assert!(!svg.contains("spring") && !svg.contains("time, s"));
    }
}

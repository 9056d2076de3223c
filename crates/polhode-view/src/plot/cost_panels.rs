//! Scenes side by side: error against time by every method, one large panel and a row of small ones below it that share
//! its axes, labels at the curves. Made to be understood at one glance.

use super::axes;
use super::decades::Decades;
use super::ink::Ink;
use super::label_rows::label_rows;
use super::method_style::{Style, styles};
use super::svg::{Anchor, Spot, Stroke, Svg, Type};
use super::text_width::{cut_to, text_width};

/// Width of a figure, pixels.
const WIDTH: f64 = 1000.0;
/// Room above the large panel: title, subtitle and the panel's own title, pixels.
const TOP: f64 = 84.0;
/// Room left of the plots, for the marks of the axis and its name, pixels.
const LEFT: f64 = 78.0;
/// Room on the right, pixels.
const RIGHT: f64 = 12.0;
/// Height of the large plot and of the small ones, pixels.
const LARGE: f64 = 350.0;
const SMALL: f64 = 210.0;
/// Between the rows: marks, and titles of the small panels, pixels.
const BETWEEN: f64 = 54.0;
/// Between small panels, pixels.
const GAP: f64 = 10.0;
/// Below the last row: marks and the name of the axis, pixels.
const BOTTOM: f64 = 50.0;
/// From a plot to the labels of its curves, pixels.
const LEADER: f64 = 16.0;
/// Labels take this part of a panel at the most.
const MOST_LABELS: f64 = 0.4;
/// Room around the points, decades.
const ROOM: f64 = 0.25;
/// Marks on an axis, about.
const MARKS: usize = 8;
/// An error of this size has nothing to do with the solution any more: larger ones are drawn there.
const LOST: f64 = 1.0;
/// Time as long as what is simulated.
const REAL_TIME: f64 = 1.0;
/// How much of a curve is seen that is not highlighted where others are.
const SHADED: f64 = 0.45;

/// A method: times and errors from setting to setting.
#[derive(Debug, Clone, PartialEq)]
pub struct PanelCurve {
    /// Its name.
    pub name: String,
    /// Its settings.
    pub points: Vec<PanelPoint>,
}

/// A setting of a method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PanelPoint {
    /// Time for each simulated second, s.
    pub seconds: f64,
    /// Its error.
    pub error: f64,
    /// The error that the run told of itself, where it told one: a thin line leads there where the method is
    /// highlighted.
    pub estimated: Option<f64>,
}

/// Errors between which something lies that is no error of a method.
#[derive(Debug, Clone, PartialEq)]
pub struct PanelBand {
    /// The smallest and the largest.
    pub errors: [f64; 2],
    /// What it is.
    pub text: String,
}

/// A scene.
#[derive(Debug, Clone, PartialEq)]
pub struct CostPanel {
    /// What it is of.
    pub title: String,
    /// The methods.
    pub curves: Vec<PanelCurve>,
    /// A band behind them.
    pub band: Option<PanelBand>,
}

/// Scenes side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct CostPanels {
    /// What the figure is of, as a sentence.
    pub title: String,
    /// How to read it.
    pub subtitle: String,
    /// What the axis of times shows.
    pub across: String,
    /// What the axis of errors shows.
    pub up: String,
    /// The scenes; the first has the large panel.
    pub panels: Vec<CostPanel>,
    /// Methods that stand out; where there are none, all do.
    pub highlighted: Vec<String>,
}

/// Where a panel is, and how large its text.
struct Frame {
    left: f64,
    right: f64,
    /// Right end of its labels.
    outer: f64,
    top: f64,
    foot: f64,
    text: f64,
    marker: f64,
    x: Decades,
    y: Decades,
}

impl Frame {
    fn spot(&self, seconds: f64, error: f64) -> Spot {
        [self.left + self.x.part(libm::log10(seconds)) * (self.right - self.left), self.height(error)]
    }

    fn spot_of(&self, point: &PanelPoint) -> Spot {
        self.spot(point.seconds, point.error)
    }

    fn height_of_plot(&self) -> f64 {
        self.foot - self.top
    }

    fn height(&self, error: f64) -> f64 {
        self.foot - self.y.part(libm::log10(error.min(LOST))) * (self.foot - self.top)
    }
}

impl CostPanels {
    /// The figure as SVG.
    pub fn svg(&self) -> String {
        let has_small = self.panels.len() > 1;
        let foot = TOP + LARGE + if has_small { BETWEEN + SMALL } else { 0.0 };
        let mut svg = Svg::new([WIDTH, foot + BOTTOM], &self.title);
        let room = WIDTH - 24.0;
        svg.text([12.0, 18.0], &cut_to(&self.title, 16.0, room), Type::new(16.0, Ink::Text).bold());
        svg.text([12.0, 40.0], &cut_to(&self.subtitle, 12.5, room), Type::new(12.5, Ink::Faint));
        let named = Type::new(12.5, Ink::Text).anchor(Anchor::Middle);
        svg.upward_text([18.0, 0.5 * (TOP + foot)], &self.up, named);
        svg.text([0.5 * (LEFT + WIDTH), foot + 36.0], &self.across, named);
        let names = self.names();
        let all = styles(&names);
        let style =
            |name: &str| names.iter().position(|other| *other == name).and_then(|number| all.get(number)).copied();
        for (number, panel) in self.panels.iter().enumerate() {
            self.draw_panel(&mut svg, panel, &self.frame(number), &style);
        }
        svg.finish()
    }

    /// Names of the methods, in the order in which they occur.
    fn names(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for curve in self.panels.iter().flat_map(|panel| &panel.curves) {
            if !names.contains(&curve.name.as_str()) {
                names.push(&curve.name);
            }
        }
        names
    }

    fn frame(&self, number: usize) -> Frame {
        let points = || self.panels.iter().flat_map(|panel| &panel.curves).flat_map(|curve| &curve.points);
        let x = Decades::around(points().map(|point| libm::log10(point.seconds)).chain([libm::log10(REAL_TIME)]), ROOM);
        let y =
            Decades::around(points().map(|point| libm::log10(point.error.min(LOST))).chain([libm::log10(LOST)]), ROOM);
        let small = self.panels.len().saturating_sub(1).max(1) as f64;
        let width = (WIDTH - LEFT - RIGHT - GAP * (small - 1.0)) / small;
        let (left, outer, top, height, text, marker) = match number.checked_sub(1) {
            None => (LEFT, WIDTH - RIGHT, TOP, LARGE, 12.5, 4.2),
            Some(place) => {
                let left = LEFT + (width + GAP) * place as f64;
                (left, left + width, TOP + LARGE + BETWEEN, SMALL, 10.5, 2.8)
            }
        };
        let names = self.panels.get(number).into_iter().flat_map(|panel| &panel.curves);
        let labels = names.map(|curve| text_width(&curve.name, text)).fold(0.0, f64::max) + LEADER + 4.0;
        let right = outer - labels.min(MOST_LABELS * (outer - left));
        Frame { left, right, outer, top, foot: top + height, text, marker, x, y }
    }

    fn is_seen(&self, name: &str) -> bool {
        self.highlighted.is_empty() || self.highlighted.iter().any(|seen| seen == name)
    }

    fn draw_panel(&self, svg: &mut Svg, panel: &CostPanel, frame: &Frame, style: &impl Fn(&str) -> Option<Style>) {
        let title = Type::new(frame.text + 0.5, Ink::Text).bold();
        svg.text([frame.left, frame.top - 12.0], &cut_to(&panel.title, title.size, frame.outer - frame.left), title);
        draw_axes(svg, frame);
        if let Some(band) = &panel.band {
            draw_band(svg, frame, band);
            // Said once: the small panels have the same.
            if frame.height_of_plot() >= LARGE {
                let end = frame.spot(REAL_TIME, band.errors[1]);
                let kind = Type::new(11.5, Ink::Faint).anchor(Anchor::End);
                svg.text_on_ground([end[0] - 8.0, end[1] - 9.0], &band.text, kind);
            }
        }
        // What stands out is drawn over the rest.
        let mut order: Vec<&PanelCurve> = panel.curves.iter().filter(|curve| !curve.points.is_empty()).collect();
        order.sort_by_key(|curve| self.is_seen(&curve.name));
        for curve in &order {
            let Some(Style { ink, marker }) = style(&curve.name) else { continue };
            let spots: Vec<Spot> = curve.points.iter().map(|point| frame.spot_of(point)).collect();
            let (ink, width, seen) = if self.is_seen(&curve.name) { (ink, 2.0, 0.9) } else { (Ink::Grey, 1.0, SHADED) };
            if spots.len() > 1 {
                svg.line(&spots, Stroke::new(ink, width).opacity(seen));
            }
            if !self.highlighted.is_empty() && self.is_seen(&curve.name) {
                curve.points.iter().for_each(|point| draw_estimated(svg, frame, point, ink));
            }
            for spot in spots {
                let size = if self.is_seen(&curve.name) { frame.marker } else { 0.6 * frame.marker };
                marker.draw(svg, spot, size, ink);
            }
        }
        self.draw_labels(svg, &order, frame, style);
    }

    /// Names right of the plot, as near to the ends of their curves as can be.
    fn draw_labels(
        &self,
        svg: &mut Svg,
        curves: &[&PanelCurve],
        frame: &Frame,
        style: &impl Fn(&str) -> Option<Style>,
    ) {
        let ends: Vec<Spot> =
            curves.iter().filter_map(|curve| curve.points.last()).map(|point| frame.spot_of(point)).collect();
        let wanted: Vec<f64> = ends.iter().map(|end| end[1]).collect();
        let rows = label_rows(&wanted, frame.text + 3.0, [frame.top, frame.foot]);
        for ((curve, end), row) in curves.iter().zip(ends).zip(rows) {
            let ink = style(&curve.name).map_or(Ink::Text, |style| style.ink);
            let seen = self.is_seen(&curve.name);
            let ink = if seen { ink } else { Ink::Grey };
            let x = frame.right + LEADER;
            let leader = [[end[0] + frame.marker, end[1]], [frame.right, end[1]], [x - 3.0, row]];
            svg.line(&leader, Stroke::new(ink, 0.8).opacity(if seen { 0.55 } else { 0.25 }));
            let kind = Type::new(frame.text, ink);
            let kind = if seen && !self.highlighted.is_empty() { kind.bold() } else { kind };
            svg.text_on_ground([x, row], &cut_to(&curve.name, frame.text, frame.outer - x), kind);
        }
    }
}

fn draw_axes(svg: &mut Svg, frame: &Frame) {
    let faint = Type::new(frame.text.min(11.5), Ink::Faint);
    for (part, mark) in frame.x.marks(MARKS) {
        let x = frame.left + part * (frame.right - frame.left);
        svg.line(&[[x, frame.top], [x, frame.foot]], Stroke::new(Ink::Grid, 1.0));
        axes::mark(svg, [x, frame.foot + 13.0], &mark, faint.anchor(Anchor::Middle));
    }
    for (part, mark) in frame.y.marks(MARKS) {
        let y = frame.foot - part * (frame.foot - frame.top);
        svg.line(&[[frame.left, y], [frame.right, y]], Stroke::new(Ink::Grid, 1.0));
        if frame.left <= LEFT {
            axes::mark(svg, [frame.left - 7.0, y], &mark, faint.anchor(Anchor::End));
        }
    }
    let [x, _] = frame.spot(REAL_TIME, LOST);
    svg.line(&[[x, frame.top], [x, frame.foot]], Stroke::new(Ink::Faint, 1.0).dashed(4.0, 3.0));
    svg.text_on_ground([x - 5.0, frame.foot - 9.0], "real time", faint.anchor(Anchor::End));
    let edge = [[frame.left, frame.top], [frame.left, frame.foot], [frame.right, frame.foot]];
    svg.line(&edge, Stroke::new(Ink::Faint, 1.0));
}

/// A thin line from the error of a setting to the one that it told of itself.
fn draw_estimated(svg: &mut Svg, frame: &Frame, point: &PanelPoint, ink: Ink) {
    let Some(estimated) = point.estimated.filter(|estimated| *estimated > 0.0) else { return };
    let [x, y] = frame.spot_of(point);
    let end = frame.height(estimated).min(frame.foot);
    svg.line(&[[x, y], [x, end]], Stroke::new(ink, 1.0).opacity(0.7));
    svg.line(&[[x - frame.marker, end], [x + frame.marker, end]], Stroke::new(ink, 1.4));
}

fn draw_band(svg: &mut Svg, frame: &Frame, band: &PanelBand) {
    let [low, high] = band.errors.map(|error| frame.height(error));
    // One law alone would be a band without height.
    let [low, high] = [low.max(high + 3.0), high];
    svg.rectangle([frame.left, high], [frame.right, low], Ink::Band, 0.8);
}

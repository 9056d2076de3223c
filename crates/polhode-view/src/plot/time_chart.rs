//! Panels under each other that share an axis of time, with events above them and lines labelled at their ends.

use super::axes;
use super::ink::Ink;
use super::label_rows::label_rows;
use super::scale::Scale;
use super::svg::{Anchor, Spot, Stroke, Svg, Type};
use super::text_width::{cut_to, lines_of, text_width};
use super::trace::Trace;

/// Width of a figure, pixels.
const WIDTH: f64 = 920.0;
/// Room left of the axes, pixels.
const LEFT: f64 = 74.0;
/// Room for labels right of the axes at the least and at the most, pixels.
const LABELS: [f64; 2] = [90.0, 300.0];
/// Room right of the labels, pixels.
const RIGHT: f64 = 10.0;
/// Height of a panel at the least, pixels.
const PANEL: f64 = 132.0;
/// Room between panels, with the name of the lower one, pixels.
const GAP: f64 = 34.0;
/// Height of a row of events, pixels.
const EVENT_ROW: f64 = 15.0;
/// Size of labels, pixels.
const LABEL: f64 = 11.5;
/// Height of a label, pixels.
const LABEL_ROW: f64 = 14.0;
/// From the end of the axes to a label, pixels.
const LEADER: f64 = 16.0;
/// Height of a line above the panels, pixels.
const HEAD_ROW: f64 = 18.0;
/// Lines of the reason for which a run stopped, at the most.
const STOP_LINES: usize = 3;
/// Marks on the axis of a panel, about.
const MARKS: usize = 5;
/// Places of events of a kind up to which each is drawn through all panels.
const FEW_EVENTS: usize = 60;
/// How much of all bands of a panel is seen together, where they lie over each other.
const BANDS: f64 = 0.3;
/// What is beyond a stop, of the time that was reached.
const BEYOND_STOP: f64 = 0.04;

/// What is along the axis of a run.
pub const OVER_TIME: &str = "time, s";

/// A line of a panel.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// The label at its end: its name, and its last value.
    pub label: String,
    /// Its ink.
    pub ink: Ink,
    /// How it goes from value to value.
    pub course: Course,
    /// Its values.
    pub trace: Trace,
}

/// How a line goes from value to value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Course {
    /// Straight.
    Straight,
    /// Level, then up or down: a count, or what holds up to the time of the value.
    Steps,
    /// Straight, in dashes.
    Dashed,
}

/// A band behind the lines of a panel: where a line may be.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Band {
    /// Its lower side.
    pub low: Trace,
    /// Its upper side.
    pub high: Trace,
}

/// Which kind of axis a panel has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisKind {
    /// Even.
    Linear,
    /// Even, with whole numbers.
    Count,
    /// Logarithmic, of magnitudes.
    Logarithmic,
}

/// One pair of axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// What it shows, with its unit.
    pub title: String,
    /// What there is to know besides; may be empty.
    pub note: String,
    /// Its axis.
    pub axis: AxisKind,
    /// Its lines.
    pub lines: Vec<Line>,
    /// Bands of the first of them, which have their inks.
    pub bands: Vec<Band>,
}

/// Events of a kind.
#[derive(Debug, Clone, PartialEq)]
pub struct EventRow {
    /// The kind, and how many there are.
    pub label: String,
    /// Its ink.
    pub ink: Ink,
    /// Where it is marked.
    pub reach: Reach,
    /// When, s, ascending.
    pub times_s: Vec<f64>,
}

/// Where events are marked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reach {
    /// In their row alone.
    Row,
    /// Through all panels too, unless there are many.
    Panels,
}

/// That a run ended before its time.
#[derive(Debug, Clone, PartialEq)]
pub struct Stop {
    /// When, s.
    pub t_s: f64,
    /// Why.
    pub reason: String,
}

/// Panels under each other.
#[derive(Debug, Clone, PartialEq)]
pub struct TimeChart {
    /// What it is of.
    pub title: String,
    /// What there is to know besides; may be empty.
    pub subtitle: String,
    /// What is along the axis below, with its unit.
    pub along: String,
    /// Events, one row a kind.
    pub events: Vec<EventRow>,
    /// The panels, from above.
    pub panels: Vec<Panel>,
    /// That the run ended before its time.
    pub stop: Option<Stop>,
}

/// Places of the axes.
struct Frame {
    left: f64,
    right: f64,
    time: Scale,
}

impl Frame {
    fn x(&self, t_s: f64) -> f64 {
        self.left + self.time.part(t_s) * (self.right - self.left)
    }
}

impl TimeChart {
    /// The figure as SVG.
    pub fn svg(&self) -> String {
        let room = self.label_room();
        let frame = Frame { left: LEFT, right: WIDTH - RIGHT - room - LEADER, time: self.time_axis() };
        let heights: Vec<f64> = self.panels.iter().map(height).collect();
        let head = 30.0 + HEAD_ROW * (f64::from(u8::from(!self.subtitle.is_empty())) + self.stop_lines().len() as f64);
        let events_foot = head + EVENT_ROW * self.events.len() as f64;
        let foot = events_foot + heights.iter().map(|height| GAP + height).sum::<f64>();
        let mut svg = Svg::new([WIDTH, foot + 46.0], &self.title);
        self.draw_head(&mut svg);
        let mut tops = Vec::with_capacity(heights.len());
        let mut y = events_foot;
        for height in &heights {
            tops.push([y + GAP, y + GAP + height]);
            y += GAP + height;
        }
        self.draw_stop(&mut svg, &frame, &tops);
        for (panel, &rows) in self.panels.iter().zip(&tops) {
            draw_axes(&mut svg, panel, &frame, rows);
        }
        self.draw_events(&mut svg, &frame, head, &tops);
        for (panel, &rows) in self.panels.iter().zip(&tops) {
            draw_lines(&mut svg, panel, &frame, rows);
        }
        draw_time(&mut svg, &frame, foot, &self.along);
        svg.finish()
    }

    fn draw_head(&self, svg: &mut Svg) {
        let room = WIDTH - 2.0 * RIGHT;
        svg.text([RIGHT, 18.0], &cut_to(&self.title, 16.0, room), Type::new(16.0, Ink::Text).bold());
        let mut y = 38.0;
        if !self.subtitle.is_empty() {
            svg.text([RIGHT, y], &cut_to(&self.subtitle, 12.0, room), Type::new(12.0, Ink::Faint));
            y += HEAD_ROW;
        }
        for line in self.stop_lines() {
            svg.text([RIGHT, y], &line, Type::new(12.0, Ink::Vermilion));
            y += HEAD_ROW;
        }
    }

    /// Why the run ended before its time, in lines.
    fn stop_lines(&self) -> Vec<String> {
        let Some(stop) = &self.stop else { return Vec::new() };
        lines_of(&format!("ended at t = {} s: {}", stop.t_s, stop.reason), 12.0, WIDTH - 2.0 * RIGHT, STOP_LINES)
    }

    /// From the first to the last time of anything that is drawn, and a little beyond a stop.
    fn time_axis(&self) -> Scale {
        let lines = self.panels.iter().flat_map(|panel| &panel.lines);
        let times = lines.flat_map(|line| line.trace.samples().map(|[t_s, _]| t_s));
        let events = self.events.iter().flat_map(|row| row.times_s.iter().copied());
        let stop = self.stop.iter().flat_map(|stop| [stop.t_s, stop.t_s * (1.0 + BEYOND_STOP)]);
        let all: Vec<f64> = times.chain(events).chain(stop).collect();
        Scale::linear_within(all.iter().copied())
    }

    fn label_room(&self) -> f64 {
        let lines = self.panels.iter().flat_map(|panel| panel.lines.iter().map(|line| &line.label));
        let all = lines.chain(self.events.iter().map(|row| &row.label));
        let widest = all.map(|label| text_width(label, LABEL)).fold(0.0, f64::max);
        // A whole pixel more than is needed, so that rounding cuts no label.
        (widest.ceil() + 1.0).clamp(LABELS[0], LABELS[1])
    }

    /// What was not reached is shaded.
    fn draw_stop(&self, svg: &mut Svg, frame: &Frame, tops: &[[f64; 2]]) {
        let Some(stop) = &self.stop else { return };
        let x = frame.x(stop.t_s);
        for &[top, foot] in tops {
            svg.rectangle([x, top], [frame.right, foot], Ink::Vermilion, 0.12);
            svg.line(&[[x, top], [x, foot]], Stroke::new(Ink::Vermilion, 1.2).dashed(4.0, 3.0));
        }
    }

    fn draw_events(&self, svg: &mut Svg, frame: &Frame, top: f64, tops: &[[f64; 2]]) {
        for (number, row) in self.events.iter().enumerate() {
            let y = top + EVENT_ROW * (number as f64 + 0.5) + 4.0;
            svg.line(&[[frame.left, y], [frame.right, y]], Stroke::new(Ink::Grid, 1.0));
            let places = pixels(row.times_s.iter().map(|&t_s| frame.x(t_s)));
            for &x in &places {
                svg.line(&[[x, y - 5.0], [x, y + 5.0]], Stroke::new(row.ink, 1.2));
                if row.reach == Reach::Panels && places.len() <= FEW_EVENTS {
                    for &[panel_top, foot] in tops {
                        let faint = Stroke::new(row.ink, 0.8).opacity(0.3);
                        svg.line(&[[x, panel_top], [x, foot]], faint);
                    }
                }
            }
            let room = WIDTH - RIGHT - frame.right - LEADER;
            svg.text([frame.right + LEADER, y], &cut_to(&row.label, LABEL, room), Type::new(LABEL, row.ink));
        }
    }
}

/// Places half a pixel apart at the least: those between are under those drawn.
fn pixels(places: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut kept: Vec<f64> = Vec::new();
    for x in places.filter(|x| x.is_finite()) {
        if kept.last().is_none_or(|last| (x - last).abs() >= 0.5) {
            kept.push(x);
        }
    }
    kept
}

/// A panel is as high as its labels need.
fn height(panel: &Panel) -> f64 {
    PANEL.max(LABEL_ROW * panel.lines.len() as f64)
}

fn scale(panel: &Panel) -> Scale {
    let lines = panel.lines.iter().map(|line| &line.trace);
    let values: Vec<f64> = lines.chain(panel.bands.iter().map(|band| &band.high)).flat_map(Trace::values).collect();
    match panel.axis {
        AxisKind::Linear => Scale::linear(values.into_iter()),
        AxisKind::Count => Scale::count(values.into_iter()),
        AxisKind::Logarithmic => Scale::logarithmic(values.into_iter()),
    }
}

fn draw_axes(svg: &mut Svg, panel: &Panel, frame: &Frame, [top, foot]: [f64; 2]) {
    svg.text([frame.left, top - 11.0], &panel.title, Type::new(12.5, Ink::Text).bold());
    if !panel.note.is_empty() {
        let x = frame.left + text_width(&panel.title, 12.5) + 14.0;
        let room = WIDTH - RIGHT - x;
        svg.text([x, top - 11.0], &cut_to(&panel.note, LABEL, room), Type::new(LABEL, Ink::Faint));
    }
    for (part, mark) in scale(panel).marks(MARKS) {
        let y = foot - part * (foot - top);
        svg.line(&[[frame.left, y], [frame.right, y]], Stroke::new(Ink::Grid, 1.0));
        axes::mark(svg, [frame.left - 7.0, y], &mark, Type::new(LABEL, Ink::Faint).anchor(Anchor::End));
    }
    for (part, _) in frame.time.marks(MARKS) {
        let x = frame.left + part * (frame.right - frame.left);
        svg.line(&[[x, top], [x, foot]], Stroke::new(Ink::Grid, 1.0));
    }
    svg.line(&[[frame.left, top], [frame.left, foot], [frame.right, foot]], Stroke::new(Ink::Faint, 1.0));
}

fn draw_lines(svg: &mut Svg, panel: &Panel, frame: &Frame, [top, foot]: [f64; 2]) {
    let scale = scale(panel);
    let y = |value: f64| if value.is_finite() { foot - scale.part(value) * (foot - top) } else { f64::NAN };
    for (line, band) in panel.lines.iter().zip(&panel.bands) {
        let mut around: Vec<Spot> = band.high.samples().map(|[t_s, value]| [frame.x(t_s), y(value)]).collect();
        let foremost = around.len();
        around.extend(band.low.samples().map(|[t_s, value]| [frame.x(t_s), y(value)]));
        around[foremost..].reverse();
        svg.area(&around, line.ink, BANDS / panel.bands.len() as f64);
    }
    for line in &panel.lines {
        let stroke = Stroke::new(line.ink, 1.5);
        let stroke = if line.course == Course::Dashed { stroke.dashed(5.0, 3.0) } else { stroke };
        svg.line(&course(line, |[t_s, value]| [frame.x(t_s), y(value)]), stroke);
    }
    let ends: Vec<Option<Spot>> =
        panel.lines.iter().map(|line| line.trace.last().map(|[t_s, value]| [frame.x(t_s), y(value)])).collect();
    let wanted: Vec<f64> = ends.iter().map(|end| end.map_or(foot, |end| end[1])).collect();
    let x = frame.right + LEADER;
    let room = WIDTH - RIGHT - x;
    // A label may extend half a row above and below the axes.
    let within = [top - 0.5 * LABEL_ROW, foot + 0.5 * LABEL_ROW];
    for ((line, end), row) in panel.lines.iter().zip(&ends).zip(label_rows(&wanted, LABEL_ROW, within)) {
        if let Some(end) = end {
            let leader = [*end, [frame.right + 3.0, end[1]], [x - 3.0, row]];
            svg.line(&leader, Stroke::new(line.ink, 0.7).opacity(0.6));
        }
        svg.text([x, row], &cut_to(&line.label, LABEL, room), Type::new(LABEL, line.ink));
    }
}

/// The places of a line.
fn course(line: &Line, place: impl Fn([f64; 2]) -> Spot) -> Vec<Spot> {
    let mut spots: Vec<Spot> = Vec::new();
    for sample in line.trace.samples() {
        let spot = place(sample);
        if let (Course::Steps, Some(before)) = (line.course, spots.last().copied()) {
            spots.push([spot[0], before[1]]);
        }
        spots.push(spot);
    }
    spots
}

fn draw_time(svg: &mut Svg, frame: &Frame, foot: f64, along: &str) {
    for (part, mark) in frame.time.marks(MARKS) {
        let x = frame.left + part * (frame.right - frame.left);
        svg.line(&[[x, foot], [x, foot + 4.0]], Stroke::new(Ink::Faint, 1.0));
        axes::mark(svg, [x, foot + 14.0], &mark, Type::new(LABEL, Ink::Faint).anchor(Anchor::Middle));
    }
    let middle = 0.5 * (frame.left + frame.right);
    svg.text([middle, foot + 32.0], along, Type::new(12.0, Ink::Text).anchor(Anchor::Middle));
}

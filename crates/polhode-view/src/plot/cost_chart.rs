//! Error against cost: one curve for a method, labelled at its end, with the same quantities in other units on a second
//! axis.

use super::axes;
use super::decades::Decades;
use super::ink::Ink;
use super::label_rows::label_rows;
use super::label_spots::{Area, LabelSpots};
use super::method_style::{FAMILIES, Style, family, styles};
use super::svg::{Anchor, Spot, Stroke, Svg, Type};
use super::text_width::{cut_to, text_width};

/// Width of a figure, and its height at the least, pixels.
const WIDTH: f64 = 1000.0;
const HEIGHT: f64 = 640.0;
/// Places of the axes: from the left, from above and from below, pixels.
const LEFT: f64 = 78.0;
const TOP: f64 = 120.0;
const BOTTOM: f64 = 54.0;
/// Room for an axis on the right, pixels.
const RIGHT_AXIS: f64 = 56.0;
/// Room for labels at the ends of curves at the most, pixels.
const MOST_LABEL: f64 = 190.0;
/// Size of labels, and the height of one, pixels.
const LABEL: f64 = 11.5;
const LABEL_ROW: f64 = 14.5;
/// From the curves to the column of labels, pixels.
const LEADER: f64 = 22.0;
/// Size of markers: about half of their width, pixels.
const MARKER: f64 = 4.0;
/// Ends of curves this near to the column of labels, of the width, have their label there.
const NEAR_COLUMN: f64 = 0.45;
/// Room around the points, decades.
const ROOM: f64 = 0.12;
/// Room below the error of the reference, for its name, decades.
const ROOM_BELOW: f64 = 0.5;
/// Errors above this are not drawn: nothing is right any more, and one that diverges would squeeze the rest.
const LARGEST_ERROR: f64 = 10.0;
/// Marks on an axis, about.
const MARKS: usize = 12;
/// Radius of the ring around the cheapest that reaches the target, pixels.
const RING: f64 = 9.0;
/// What the ends of thin lines at points are.
const TOLD: &str = "error that the run told";
/// Pieces that a curve is cut into so that labels keep off it, pixels.
const PIECE: f64 = 5.0;

/// What is said of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rank {
    /// Nothing.
    Plain,
    /// It is the cheapest that reaches the target.
    Cheapest,
    /// It reaches the target, and its time cannot be told from that of the cheapest.
    Tie,
}

/// A setting of a method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CostPoint {
    /// Its cost.
    pub cost: f64,
    /// Costs between which half of the measurements are.
    pub spread: [f64; 2],
    /// Its error.
    pub error: f64,
    /// The error that the run told of itself; none where it told none.
    pub estimated: Option<f64>,
    /// Whether none is better in both.
    pub on_front: bool,
    /// Whether it reaches the target.
    pub rank: Rank,
}

/// A method, from setting to setting.
#[derive(Debug, Clone, PartialEq)]
pub struct CostCurve {
    /// Its name.
    pub name: String,
    /// Its settings.
    pub points: Vec<CostPoint>,
}

/// The other units of cost and error; none where there is no such unit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct OtherUnits {
    /// Microseconds for each simulated second in one of cost.
    pub microseconds: Option<f64>,
    /// Millimetres in an error of 1.
    pub millimetres: Option<f64>,
    /// Degrees in an error of 1.
    pub degrees: Option<f64>,
}

/// An error that is asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Target {
    /// The error.
    pub error: f64,
    /// The cheapest that reaches it, and what there is to know of it.
    pub text: String,
}

/// A line across the chart at an error.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// The error.
    pub error: f64,
    /// What it is.
    pub text: String,
}

/// Error against cost.
#[derive(Debug, Clone, PartialEq)]
pub struct CostChart {
    /// What it is of.
    pub title: String,
    /// What there is to know besides.
    pub subtitle: String,
    /// What the axis of cost shows.
    pub cost: String,
    /// What the axis of errors shows.
    pub error: String,
    /// Second axes.
    pub units: OtherUnits,
    /// The error of the reference.
    pub floor: f64,
    /// Other errors to compare with.
    pub levels: Vec<Level>,
    /// The methods.
    pub curves: Vec<CostCurve>,
    /// The error that is asked for.
    pub target: Option<Target>,
}

/// A curve as it is drawn.
struct Drawn<'a> {
    curve: &'a CostCurve,
    style: Style,
    spots: Vec<(Spot, CostPoint)>,
    /// From where to where half of the measurements of a point are.
    spreads: Vec<[Spot; 2]>,
    /// The height of the error that the run of a point told of itself.
    estimates: Vec<Option<f64>>,
}

impl Drawn<'_> {
    /// The places of its line.
    fn line(&self) -> Vec<Spot> {
        self.spots.iter().map(|(spot, _)| *spot).collect()
    }
}

/// Places of the axes.
struct Frame {
    right: f64,
    /// Right end of the frame; labels are between.
    outer: f64,
    foot: f64,
    x: Decades,
    y: Decades,
}

impl Frame {
    fn spot(&self, cost: f64, error: f64) -> Spot {
        let x = LEFT + self.x.part(libm::log10(cost)) * (self.right - LEFT);
        [x, self.height(error)]
    }

    fn height(&self, error: f64) -> f64 {
        self.foot - self.y.part(libm::log10(error)) * (self.foot - TOP)
    }
}

impl CostChart {
    /// The figure as SVG.
    pub fn svg(&self) -> String {
        let frame = self.frame();
        let names: Vec<&str> = self.curves.iter().map(|curve| curve.name.as_str()).collect();
        let drawn: Vec<Drawn<'_>> = self
            .curves
            .iter()
            .zip(styles(&names))
            .map(|(curve, style)| {
                let points = || curve.points.iter().filter(|point| is_drawn(point));
                let spread = |point: &CostPoint| point.spread.map(|cost| frame.spot(cost, point.error));
                let estimate = |point: &CostPoint| {
                    let estimated = point.estimated.filter(|estimated| *estimated > 0.0);
                    estimated.map(|estimated| frame.height(estimated).clamp(TOP, frame.foot))
                };
                Drawn {
                    curve,
                    style,
                    spots: points().map(|point| (frame.spot(point.cost, point.error), *point)).collect(),
                    spreads: points().map(spread).collect(),
                    estimates: points().map(estimate).collect(),
                }
            })
            .collect();
        let mut svg = Svg::new([WIDTH, frame.foot + BOTTOM], &self.title);
        self.draw_head(&mut svg, &drawn);
        self.draw_axes(&mut svg, &frame);
        let stairs = front(&frame, &drawn);
        draw_front(&mut svg, &stairs, &drawn);
        let mut pieces: Vec<Spot> = drawn.iter().flat_map(|one| line_pieces(&one.line())).collect();
        pieces.extend(line_pieces(&stairs));
        let mut labels = LabelSpots::new(inner(&frame), markers(&drawn), pieces);
        self.draw_levels(&mut svg, &frame, &mut labels);
        for one in &drawn {
            draw_curve(&mut svg, &frame, one);
        }
        self.draw_target(&mut svg, &drawn, &mut labels);
        draw_labels(&mut svg, &frame, &drawn, &mut labels);
        svg.finish()
    }

    fn frame(&self) -> Frame {
        let points = || self.curves.iter().flat_map(|curve| &curve.points).filter(|point| is_drawn(point));
        let floor = libm::log10(self.floor);
        let floor_and_room = [floor, floor - ROOM_BELOW];
        let levels = self.levels.iter().map(|level| level.error).filter(|error| *error > 0.0);
        let target = self.target.iter().map(|target| target.error).chain(levels).map(libm::log10);
        let x = Decades::around(points().map(|point| libm::log10(point.cost)), ROOM);
        let y =
            Decades::around(points().map(|point| libm::log10(point.error)).chain(floor_and_room).chain(target), ROOM);
        let names = self.curves.iter().map(|curve| text_width(&curve.name, LABEL));
        let room = names.fold(0.0, f64::max).min(MOST_LABEL) + LEADER + 3.0 * MARKER + 6.0;
        let axes = [self.units.millimetres, self.units.degrees].iter().flatten().count() as f64;
        let outer = WIDTH - 14.0 - RIGHT_AXIS * axes;
        let foot = (HEIGHT - BOTTOM).max(TOP + LABEL_ROW * self.curves.len() as f64);
        Frame { right: outer - room, outer, foot, x, y }
    }

    fn draw_head(&self, svg: &mut Svg, drawn: &[Drawn<'_>]) {
        let room = WIDTH - 24.0;
        svg.text([12.0, 18.0], &cut_to(&self.title, 16.0, room), Type::new(16.0, Ink::Text).bold());
        svg.text([12.0, 39.0], &cut_to(&self.subtitle, 12.0, room), Type::new(12.0, Ink::Faint));
        let mut x = 12.0;
        let y = 60.0;
        let mut shown: Vec<&str> = Vec::new();
        for one in drawn.iter().filter(|one| !one.spots.is_empty()) {
            let Some(family) = family(&one.curve.name) else { continue };
            let is_single = FAMILIES.iter().any(|other| other == family && other.members.len() == 1);
            if is_single || shown.contains(&family.name) {
                continue;
            }
            shown.push(family.name);
            svg.line(&[[x, y], [x + 18.0, y]], Stroke::new(family.ink, 3.0));
            svg.text([x + 24.0, y], family.name, Type::new(LABEL, family.ink));
            x += 24.0 + text_width(family.name, LABEL) + 8.0;
        }
        svg.line(&[[x, y], [x + 22.0, y]], Stroke::new(Ink::Band, 8.0));
        svg.text([x + 28.0, y], "Pareto front", Type::new(LABEL, Ink::Text));
        x += 28.0 + text_width("Pareto front", LABEL) + 8.0;
        if drawn.iter().flat_map(|one| &one.estimates).any(Option::is_some) {
            draw_estimate(svg, [x + 6.0, y + 6.0], y - 6.0, Ink::Text);
            svg.text([x + 16.0, y], TOLD, Type::new(LABEL, Ink::Text));
            x += 16.0 + text_width(TOLD, LABEL) + 8.0;
        }
        let rank = |wanted: Rank| drawn.iter().flat_map(|one| &one.spots).any(|(_, point)| point.rank == wanted);
        for (wanted, name) in [(Rank::Cheapest, "cheapest for target"), (Rank::Tie, "tie within noise")] {
            if rank(wanted) {
                svg.ring([x + 9.0, y], 7.0, ring(wanted));
                svg.text([x + 22.0, y], name, Type::new(LABEL, Ink::Text));
                x += 22.0 + text_width(name, LABEL) + 8.0;
            }
        }
    }

    fn draw_axes(&self, svg: &mut Svg, frame: &Frame) {
        let faint = Type::new(LABEL, Ink::Faint);
        let title = Type::new(12.5, Ink::Text);
        let [across, up] = [frame.right - LEFT, frame.foot - TOP];
        for (part, mark) in frame.x.marks(MARKS) {
            let x = LEFT + part * across;
            svg.line(&[[x, TOP], [x, frame.foot]], Stroke::new(Ink::Grid, 1.0));
            axes::mark(svg, [x, frame.foot + 15.0], &mark, faint.anchor(Anchor::Middle));
        }
        for (part, mark) in frame.y.marks(MARKS) {
            let y = frame.foot - part * up;
            svg.line(&[[LEFT, y], [frame.outer, y]], Stroke::new(Ink::Grid, 1.0));
            axes::mark(svg, [LEFT - 7.0, y], &mark, faint.anchor(Anchor::End));
        }
        let middle = 0.5 * (LEFT + frame.right);
        svg.text([middle, frame.foot + 37.0], &self.cost, title.anchor(Anchor::Middle));
        svg.upward_text([18.0, 0.5 * (TOP + frame.foot)], &self.error, title.anchor(Anchor::Middle));
        if let Some(shift) = self.units.microseconds.map(libm::log10).filter(|shift| shift.is_finite()) {
            for (part, mark) in frame.x.shifted(shift).marks(MARKS) {
                let x = LEFT + part * across;
                svg.line(&[[x, TOP], [x, TOP - 4.0]], Stroke::new(Ink::Faint, 1.0));
                axes::mark(svg, [x, TOP - 12.0], &mark, faint.anchor(Anchor::Middle));
            }
            let text = "microseconds for each simulated second";
            svg.text([middle, TOP - 31.0], text, title.anchor(Anchor::Middle));
        }
        let mut x = frame.outer;
        for (unit, factor) in [("mm", self.units.millimetres), ("degrees", self.units.degrees)] {
            let Some(shift) = factor.map(libm::log10).filter(|shift| shift.is_finite()) else { continue };
            svg.line(&[[x, TOP], [x, frame.foot]], Stroke::new(Ink::Faint, 1.0));
            for (part, mark) in frame.y.shifted(shift).marks(MARKS) {
                let y = frame.foot - part * up;
                svg.line(&[[x, y], [x + 4.0, y]], Stroke::new(Ink::Faint, 1.0));
                axes::mark(svg, [x + 8.0, y], &mark, faint);
            }
            svg.text([x - 2.0, TOP - 12.0], unit, title);
            x += RIGHT_AXIS;
        }
        let edge = [[LEFT, TOP], [LEFT, frame.foot], [frame.outer, frame.foot]];
        svg.line(&edge, Stroke::new(Ink::Faint, 1.0));
        svg.line(&[[LEFT, TOP], [frame.right, TOP]], Stroke::new(Ink::Faint, 1.0));
    }

    /// The error of the reference, that of the target and others, across the frame.
    fn draw_levels(&self, svg: &mut Svg, frame: &Frame, labels: &mut LabelSpots) {
        let target = self.target.as_ref().map(|target| (target.error, format!("target {:e}", target.error), -8.0));
        let reference = Some((self.floor, "error of the reference".to_owned(), 9.0));
        let mut taken: Vec<Area> = Vec::new();
        let levels = self.levels.iter().map(|level| (level.error, level.text.clone(), -8.0));
        for (error, text, below) in reference.into_iter().chain(target).chain(levels) {
            let y = frame.height(error);
            if !y.is_finite() {
                continue;
            }
            let line = [[LEFT, y], [frame.right, y]];
            svg.line(&line, Stroke::new(Ink::Text, 1.0).dashed(5.0, 4.0).opacity(0.65));
            labels.keep_off(line_pieces(&line));
            let width = text_width(&text, LABEL);
            // A name above the upper edge would cover the marks there.
            let below = if y + below - 7.0 < TOP { 9.0 } else { below };
            let at = |x: f64| Area { from: [x, y + below - 7.0], to: [x + 8.0 + width, y + below + 7.0] };
            // On the left, but on the right if markers are there; a target below what is known of the reference has its
            // name beside that of the reference.
            let sides = [at(LEFT), at(frame.right - width - 14.0)];
            let first = if labels.has_markers(&sides[0].grown(RING)) { sides[1] } else { sides[0] };
            let beside = |other: &Area| {
                if first.from[0] > LEFT { at(other.from[0] - width - 8.0) } else { at(other.to[0]) }
            };
            let area = taken.iter().find(|other| other.overlaps(&first)).map_or(first, beside);
            labels.keep_free(area);
            svg.text_on_ground([area.from[0] + 6.0, y + below], &text, Type::new(LABEL, Ink::Faint));
            taken.push(area);
        }
    }

    /// Rings around the cheapest that reaches the target and its ties, and what there is to say of the first.
    fn draw_target(&self, svg: &mut Svg, drawn: &[Drawn<'_>], labels: &mut LabelSpots) {
        let Some(target) = &self.target else { return };
        let ranked = drawn.iter().flat_map(|one| &one.spots).filter(|(_, point)| point.rank != Rank::Plain);
        for (spot, point) in ranked {
            svg.ring(*spot, if point.rank == Rank::Cheapest { RING } else { RING - 1.0 }, ring(point.rank));
            if point.rank == Rank::Cheapest {
                let kind = Type::new(LABEL + 0.5, Ink::Text).bold();
                let width = 1.08 * text_width(&target.text, kind.size);
                // Not within its own ring.
                labels.keep_free(Area::around(*spot, [RING, RING]));
                draw_beside(svg, labels, *spot, (&target.text, width), kind);
            }
        }
    }
}

/// The area for labels beside points.
fn inner(frame: &Frame) -> Area {
    Area { from: [LEFT + 2.0, TOP + 2.0], to: [frame.right, frame.foot - 2.0] }
}

fn is_drawn(point: &CostPoint) -> bool {
    let is_positive = |number: f64| number > 0.0 && number.is_finite();
    is_positive(point.cost) && is_positive(point.error) && point.error <= LARGEST_ERROR
}

fn ring(rank: Rank) -> Stroke {
    match rank {
        Rank::Cheapest => Stroke::new(Ink::Text, 2.2),
        Rank::Tie | Rank::Plain => Stroke::new(Ink::Text, 1.2).dashed(3.0, 2.0),
    }
}

fn markers(drawn: &[Drawn<'_>]) -> Vec<Spot> {
    drawn.iter().flat_map(|one| one.spots.iter().map(|(spot, _)| *spot)).collect()
}

/// Places on a line, some pixels apart.
fn line_pieces(line: &[Spot]) -> Vec<Spot> {
    let mut pieces = Vec::new();
    for pair in line.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        let count = (libm::hypot(b[0] - a[0], b[1] - a[1]) / PIECE).ceil().min(1e3) as usize;
        let at = |number: usize, axis: usize| a[axis] + (b[axis] - a[axis]) * number as f64 / count as f64;
        pieces.extend((1..count).map(|number| [at(number, 0), at(number, 1)]));
    }
    pieces
}

/// The staircase of the best error for a cost.
fn front(frame: &Frame, drawn: &[Drawn<'_>]) -> Vec<Spot> {
    let mut spots = on_front(drawn);
    spots.sort_by(|a, b| a[0].total_cmp(&b[0]).then(b[1].total_cmp(&a[1])));
    let mut stairs: Vec<Spot> = Vec::new();
    for &spot in &spots {
        if let Some(&[_, before]) = stairs.last() {
            stairs.push([spot[0], before]);
        }
        stairs.push(spot);
    }
    if let Some(&[_, last]) = stairs.last() {
        stairs.push([frame.right, last]);
    }
    stairs
}

fn on_front(drawn: &[Drawn<'_>]) -> Vec<Spot> {
    let points = drawn.iter().flat_map(|one| &one.spots).filter(|(_, point)| point.on_front);
    points.map(|(spot, _)| *spot).collect()
}

/// The staircase behind the curves, as wide as the markers.
fn draw_front(svg: &mut Svg, stairs: &[Spot], drawn: &[Drawn<'_>]) {
    svg.line(stairs, Stroke::new(Ink::Band, 7.0));
    for spot in on_front(drawn) {
        svg.disc(spot, 9.5, Ink::Band);
    }
}

fn draw_curve(svg: &mut Svg, frame: &Frame, one: &Drawn<'_>) {
    let ink = one.style.ink;
    let line = one.line();
    if line.len() > 1 {
        svg.line(&line, Stroke::new(ink, 1.3).opacity(0.75));
    }
    for (spot, estimate) in line.iter().zip(&one.estimates) {
        if let Some(height) = estimate {
            draw_estimate(svg, *spot, *height, ink);
        }
    }
    for (spot, spread) in line.iter().zip(&one.spreads) {
        // Where the noise is within the marker there is nothing to see.
        if spread[1][0] - spread[0][0] > 2.0 * MARKER {
            let within = spread.map(|[x, y]| [x.clamp(LEFT, frame.right), y]);
            svg.line(&within, Stroke::new(ink, 0.9).opacity(0.6));
        }
        one.style.marker.draw(svg, *spot, MARKER, ink);
    }
}

/// A thin line from a point to the height of the error that its run told of itself.
fn draw_estimate(svg: &mut Svg, [x, y]: Spot, height: f64, ink: Ink) {
    svg.line(&[[x, y], [x, height]], Stroke::new(ink, 0.8).opacity(0.45));
    svg.line(&[[x - MARKER, height], [x + MARKER, height]], Stroke::new(ink, 1.2).opacity(0.6));
}

/// Writes a text beside a point, with a line to it where it is not next to it.
fn draw_beside(
    svg: &mut Svg,
    labels: &mut LabelSpots,
    spot: Spot,
    (text, width): (&str, f64),
    kind: Type,
) -> Option<()> {
    let area = labels.place(spot, [width, LABEL_ROW])?;
    let [x, y] = [0.5 * (area.from[0] + area.to[0]), 0.5 * (area.from[1] + area.to[1])];
    let near = [spot[0].clamp(area.from[0], area.to[0]), spot[1].clamp(area.from[1] + 3.0, area.to[1] - 3.0)];
    if libm::hypot(near[0] - spot[0], near[1] - spot[1]) > 17.0 {
        svg.line(&[spot, near], Stroke::new(kind.ink, 0.7).opacity(0.7));
    }
    svg.text_on_ground([x, y], text, kind.anchor(Anchor::Middle));
    Some(())
}

/// Names at the ends of the curves: in a column on the right, or beside an end that is far from it.
fn draw_labels(svg: &mut Svg, frame: &Frame, drawn: &[Drawn<'_>], labels: &mut LabelSpots) {
    let mut column: Vec<(&Drawn<'_>, Spot)> = Vec::new();
    for one in drawn {
        let Some((end, point)) = one.spots.last() else { continue };
        if one.spots.len() == 1 && point.rank == Rank::Cheapest {
            // The text beside its ring has its name.
            continue;
        }
        let is_near = frame.right - end[0] < NEAR_COLUMN * (frame.right - LEFT);
        let width = text_width(&one.curve.name, LABEL);
        let kind = Type::new(LABEL, one.style.ink);
        if is_near || draw_beside(svg, labels, *end, (&one.curve.name, width), kind).is_none() {
            column.push((one, *end));
        }
    }
    let wanted: Vec<f64> = column.iter().map(|(_, end)| end[1]).collect();
    let x = frame.right + LEADER;
    for ((one, end), row) in column.iter().zip(label_rows(&wanted, LABEL_ROW, [TOP, frame.foot])) {
        let (ink, marker) = (one.style.ink, one.style.marker);
        let leader = [[end[0] + 6.0, end[1]], [frame.right, end[1]], [x - 8.0, row]];
        svg.line(&leader, Stroke::new(ink, 0.7).opacity(0.5));
        marker.draw(svg, [x, row], MARKER, ink);
        let room = frame.outer - x - 10.0;
        svg.text_on_ground([x + 9.0, row], &cut_to(&one.curve.name, LABEL, room), Type::new(LABEL, ink));
    }
}

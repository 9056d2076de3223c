//! The figure: error against cost on logarithmic axes, one curve for every method, the Pareto front behind them.

use super::study::{Entry, Study};
use crate::failure::Failure;
use plotters::coord::Shift;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::ops::Range;

/// Width and height, pixels.
const SIZE: (u32, u32) = (980, 620);

/// Width of the legend, pixels.
const LEGEND: u32 = 210;

/// Height of a line of the legend, pixels.
const LEGEND_LINE: i32 = 22;

/// Colours that most people tell apart, also those who see fewer of them (Okabe and Ito's, without yellow).
const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(70, 70, 70),
];

/// Corners of the markers, in pixels from their place: square, triangle, diamond, triangle on its head, star. The
/// first marker is a disc. Their number and that of the colours have no common factor, so that 42 series differ.
const MARKERS: [&[(i32, i32)]; 6] = [
    &[],
    &[(-4, -4), (4, -4), (4, 4), (-4, 4)],
    &[(-5, 4), (5, 4), (0, -6)],
    &[(-6, 0), (0, -6), (6, 0), (0, 6)],
    &[(-5, -4), (5, -4), (0, 6)],
    &[(0, -7), (2, -2), (7, 0), (2, 2), (0, 7), (-2, 2), (-7, 0), (-2, -2)],
];

/// Behind the curves, as wide as the markers.
const FRONT: RGBColor = RGBColor(255, 224, 130);

/// Errors above this are not drawn: nothing is right any more, and one that diverges would squeeze the rest.
const LARGEST_ERROR: f64 = 10.0;

/// Decades that are labelled at the most.
const MOST_LABELS: i32 = 12;

/// Decades left free below the error of the reference.
const ROOM_BELOW: f64 = 0.5;

/// A place in the figure: decades of cost and of error.
type Place = (f64, f64);

/// One curve.
struct Curve<'a> {
    name: &'a str,
    places: Vec<Place>,
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Decades, Decades>>;

/// A logarithmic axis between whole powers of ten; a value on it is its logarithm.
#[derive(Debug, Clone, PartialEq)]
struct Decades(Range<f64>);

/// The figure as SVG.
///
/// # Errors
/// When it cannot be drawn.
pub(super) fn svg(study: &Study) -> Result<String, Failure> {
    let mut text = String::new();
    let drawn = {
        let root = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        draw(&root, study).and_then(|()| root.present().map_err(|error| error.to_string()))
    };
    drawn.map_err(|error| Failure::InputOutput(format!("error: cannot draw the figure: {error}")))?;
    Ok(text)
}

fn draw(root: &Area<'_>, study: &Study) -> Result<(), String> {
    let fault = |error: DrawingAreaErrorKind<_>| error.to_string();
    root.fill(&WHITE).map_err(fault)?;
    let curves = curves(study);
    let places: Vec<Place> = curves.iter().flat_map(|curve| curve.places.iter().copied()).collect();
    let floor = study.references.iter().map(|reference| reference.error.log10()).fold(f64::INFINITY, f64::min);
    // Below the line there is room for its name.
    let lowest = floor - ROOM_BELOW;
    let (x, y) = (
        Decades::around(places.iter().map(|place| place.0)),
        Decades::around(places.iter().map(|place| place.1).chain([lowest])),
    );
    let (left, right) = root.split_horizontally(SIZE.0 - LEGEND);
    let mut chart = ChartBuilder::on(&left)
        .caption(format!("{}: error against cost", study.scene), ("sans-serif", 20))
        .margin(12)
        .x_label_area_size(48)
        .y_label_area_size(64)
        .build_cartesian_2d(x.clone(), y)
        .map_err(fault)?;
    chart
        .configure_mesh()
        .bold_line_style(RGBColor(225, 225, 225))
        .light_line_style(TRANSPARENT)
        .x_desc(study.cost_unit())
        .y_desc("error: position (relative) or attitude (rad)")
        .label_style(("sans-serif", 14))
        .axis_desc_style(("sans-serif", 15))
        .draw()
        .map_err(fault)?;
    front(&mut chart, study, &x.0)?;
    if floor.is_finite() {
        let line = DashedLineSeries::new([(x.0.start, floor), (x.0.end, floor)], 6, 5, BLACK.mix(0.6).into());
        chart.draw_series(line).map_err(fault)?;
        let style = ("sans-serif", 13).into_font().color(&BLACK.mix(0.7)).pos(Pos::new(HPos::Left, VPos::Top));
        let label = EmptyElement::at((x.0.start, floor)) + Text::new("error of the reference", (6, 4), style);
        chart.draw_series([label]).map_err(fault)?;
    }
    for (number, curve) in curves.iter().enumerate() {
        let colour = COLOURS[number % COLOURS.len()];
        let line = LineSeries::new(curve.places.iter().copied(), colour.mix(0.7).stroke_width(1));
        chart.draw_series(line).map_err(fault)?;
        match MARKERS[number % MARKERS.len()] {
            [] => chart.draw_series(curve.places.iter().map(|&place| Circle::new(place, 4, colour.filled()))),
            corners => chart.draw_series(
                curve.places.iter().map(|&place| EmptyElement::at(place) + Polygon::new(corners.to_vec(), colour)),
            ),
        }
        .map_err(fault)?;
    }
    legend(&right, &curves)
}

/// The staircase of the best error for a cost, and a ring around every candidate on it.
fn front(chart: &mut Chart<'_, '_>, study: &Study, x: &Range<f64>) -> Result<(), String> {
    let fault = |error: DrawingAreaErrorKind<_>| error.to_string();
    let on_front = |entry: &&Entry| entry.outcome.as_ref().is_ok_and(|measured| measured.on_front);
    let mut places: Vec<Place> =
        study.entries.iter().filter(on_front).filter_map(|entry| place(study, entry)).collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut stairs: Vec<Place> = Vec::new();
    for &place in &places {
        if let Some(&(_, before)) = stairs.last() {
            stairs.push((place.0, before));
        }
        stairs.push(place);
    }
    if let Some(&(_, last)) = stairs.last() {
        stairs.push((x.end, last));
    }
    chart.draw_series(LineSeries::new(stairs, FRONT.stroke_width(6))).map_err(fault)?;
    chart.draw_series(places.iter().map(|&place| Circle::new(place, 10, FRONT.filled()))).map_err(fault)?;
    Ok(())
}

/// Names of the curves with their markers, from top to bottom.
fn legend(area: &Area<'_>, curves: &[Curve<'_>]) -> Result<(), String> {
    let fault = |error: DrawingAreaErrorKind<_>| error.to_string();
    let style = ("sans-serif", 14).into_font().color(&BLACK).pos(Pos::new(HPos::Left, VPos::Center));
    let mut y = 56;
    for (number, curve) in curves.iter().enumerate() {
        let colour = COLOURS[number % COLOURS.len()];
        area.draw(&PathElement::new(vec![(4, y), (32, y)], colour.mix(0.7).stroke_width(1))).map_err(fault)?;
        match MARKERS[number % MARKERS.len()] {
            [] => area.draw(&Circle::new((18, y), 4, colour.filled())),
            corners => area.draw(&(EmptyElement::at((18, y)) + Polygon::new(corners.to_vec(), colour))),
        }
        .map_err(fault)?;
        area.draw(&Text::new(curve.name.to_owned(), (42, y), style.clone())).map_err(fault)?;
        y += LEGEND_LINE;
    }
    area.draw(&PathElement::new(vec![(4, y), (32, y)], FRONT.stroke_width(6))).map_err(fault)?;
    area.draw(&Text::new("Pareto front", (42, y), style)).map_err(fault)
}

/// One curve for every series that has a place, in the order of the candidates.
fn curves(study: &Study) -> Vec<Curve<'_>> {
    let mut curves: Vec<Curve<'_>> = Vec::new();
    for entry in &study.entries {
        let Some(place) = place(study, entry) else { continue };
        let name = entry.candidate.series.as_str();
        match curves.iter_mut().find(|curve| curve.name == name) {
            Some(curve) => curve.places.push(place),
            None => curves.push(Curve { name, places: vec![place] }),
        }
    }
    curves
}

/// Where a candidate stands: at its error, but not below that of its reference.
fn place(study: &Study, entry: &Entry) -> Option<Place> {
    let error = study.known_error(entry)?;
    let cost = entry.outcome.as_ref().ok()?.cost();
    let is_drawn = cost > 0.0 && cost.is_finite() && error > 0.0 && error <= LARGEST_ERROR;
    is_drawn.then(|| (cost.log10(), error.log10()))
}

impl Decades {
    /// Whole decades around the logarithms; one decade when there are none.
    fn around(logarithms: impl Iterator<Item = f64>) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in logarithms.filter(|value| value.is_finite()) {
            low = low.min(value.floor());
            high = high.max(value.ceil());
        }
        if low > high { Self(-1.0..0.0) } else { Self(low..high.max(low + 1.0)) }
    }

    /// The decades that are labelled.
    fn labels(&self) -> Vec<f64> {
        let (low, high) = (self.0.start as i32, self.0.end as i32);
        let stride = (high - low) / MOST_LABELS + 1;
        (low..=high).filter(|decade| decade % stride == 0).map(f64::from).collect()
    }
}

impl Ranged for Decades {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (low, high): (i32, i32)) -> i32 {
        let part = (value - self.0.start) / (self.0.end - self.0.start);
        low + (part * f64::from(high - low)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _hint: Hint) -> Vec<f64> {
        self.labels()
    }

    fn range(&self) -> Range<f64> {
        self.0.clone()
    }
}

impl ValueFormatter<f64> for Decades {
    fn format(decade: &f64) -> String {
        format!("1e{}", decade.round())
    }
}

#[cfg(test)]
mod tests {
    //! Axes are whole decades, with labels that fit.
    use super::*;

    #[test]
    fn axes_are_whole_decades() {
        assert_eq!(Decades::around([-2.5, 1.2].into_iter()), Decades(-3.0..2.0));
        assert_eq!(Decades::around([-2.0].into_iter()), Decades(-2.0..-1.0));
        assert_eq!(Decades::around([f64::NAN].into_iter()), Decades(-1.0..0.0));
        assert_eq!(Decades(-2.0..1.0).labels(), [-2.0, -1.0, 0.0, 1.0]);
        assert!(Decades(-300.0..300.0).labels().len() <= MOST_LABELS as usize + 1);
    }

    #[test]
    fn series_differ_in_marker_or_colour() {
        let mut pairs: Vec<_> = (0..42).map(|i| (i % MARKERS.len(), i % COLOURS.len())).collect();
        pairs.sort_unstable();
        pairs.dedup();
        assert_eq!(pairs.len(), 42);
    }
}

//! Panels with logarithmic axes side by side, as SVG.

use polhode_view::plot::scale::{Mark, Scale};
use polhode_view::plot::svg::{Anchor, Spot, Type};
use polhode_view::plot::{Ink, Marker, Stroke, Svg, label_rows};

/// One curve.
#[derive(Debug)]
pub(super) struct Series {
    pub(super) name: &'static str,
    pub(super) places: Vec<(f64, f64)>,
}

/// One pair of axes.
#[derive(Debug)]
pub(super) struct Panel {
    pub(super) title: &'static str,
    /// What the axis across shows.
    pub(super) across: &'static str,
    pub(super) series: Vec<Series>,
}

/// Size of a panel, and the room around its axes, pixels; labels stand on the right.
const WIDTH: f64 = 360.0;
const HEIGHT: f64 = 330.0;
const LEFT: f64 = 52.0;
const RIGHT: f64 = 112.0;
const TOP: f64 = 38.0;
const BOTTOM: f64 = 48.0;

/// Size of labels and height of one, pixels.
const LABEL: f64 = 11.5;
const LABEL_ROW: f64 = 15.0;

/// Half of the width of a marker, pixels.
const MARKER: f64 = 3.6;

/// Powers of ten that are marked, about.
const MARKS: usize = 6;

/// The panels from left to right.
pub(super) fn svg(panels: &[Panel]) -> String {
    let mut svg = Svg::new([WIDTH * panels.len() as f64, HEIGHT], "separating axes and GJK: errors and times");
    for (k, panel) in panels.iter().enumerate() {
        draw(&mut svg, panel, WIDTH * k as f64);
    }
    svg.finish()
}

fn draw(svg: &mut Svg, panel: &Panel, left: f64) {
    let places = || panel.series.iter().flat_map(|series| series.places.iter());
    let (from, to, foot) = (left + LEFT, left + WIDTH - RIGHT, HEIGHT - BOTTOM);
    let (x, y) = (Scale::logarithmic(places().map(|place| place.0)), Scale::logarithmic(places().map(|place| place.1)));
    let across = |part: f64| from + part * (to - from);
    let up = |part: f64| foot - part * (foot - TOP);
    let spot = |place: &(f64, f64)| -> Spot { [across(x.part(place.0)), up(y.part(place.1))] };
    svg.text([from, 20.0], panel.title, Type::new(13.0, Ink::Text).bold());
    let title = Type::new(12.0, Ink::Text).anchor(Anchor::Middle);
    svg.text([0.5 * (from + to), HEIGHT - 12.0], panel.across, title);
    let faint = Type::new(LABEL, Ink::Faint);
    for (part, mark) in x.marks(MARKS) {
        svg.line(&[[across(part), TOP], [across(part), foot]], Stroke::new(Ink::Grid, 1.0));
        write_power(svg, [across(part), foot + 14.0], &mark, faint.anchor(Anchor::Middle));
    }
    for (part, mark) in y.marks(MARKS) {
        svg.line(&[[from, up(part)], [to, up(part)]], Stroke::new(Ink::Grid, 1.0));
        write_power(svg, [from - 6.0, up(part)], &mark, faint.anchor(Anchor::End));
    }
    svg.line(&[[from, TOP], [from, foot], [to, foot]], Stroke::new(Ink::Faint, 1.0));
    // Gaps are measured from the widest to none: the right end is not the last.
    let right_end = |series: &Series| series.places.iter().max_by(|a, b| a.0.total_cmp(&b.0)).map(&spot);
    let ends: Vec<f64> = panel.series.iter().map(|series| right_end(series).map_or(foot, |end| end[1])).collect();
    for ((k, series), row) in panel.series.iter().enumerate().zip(label_rows(&ends, LABEL_ROW, [TOP, foot])) {
        let (ink, marker) = (Ink::of_curve(k), Marker::ALL[k % Marker::ALL.len()]);
        let spots: Vec<Spot> = series.places.iter().map(spot).collect();
        svg.line(&spots, Stroke::new(ink, 1.4));
        for spot in &spots {
            marker.draw(svg, *spot, MARKER, ink);
        }
        svg.text([to + 10.0, row], series.name, Type::new(LABEL, ink));
    }
}

fn write_power(svg: &mut Svg, at: Spot, mark: &Mark, kind: Type) {
    match mark {
        Mark::Power(0) => svg.text(at, "1", kind),
        Mark::Power(exponent) => svg.power_of_ten(at, "", *exponent, kind),
        // Gaps and errors are drawn above zero.
        Mark::Number(_) | Mark::Foot { .. } => {}
    }
}

#[cfg(test)]
mod tests {
    //! Every series is drawn and named.
    use super::*;

    #[test]
    fn every_series_is_named() {
        let series = vec![Series { name: "one", places: vec![(1.0, 2.0), (10.0, 3.0)] }];
        let text = svg(&[Panel { title: "title", across: "across", series }]);
        assert!(["<svg", "title", "across", "one", "</svg>"].iter().all(|part| text.contains(part)), "{text}");
    }
}

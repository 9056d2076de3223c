//! The figure of `docs/error-estimates.md`: the error that runs tell against their true error, one mark for a run.

use polhode_cases::calibration::{Compared, FAR_TOO_LOW, Judged, TOO_HIGH, TOO_LOW, tiers};
use polhode_view::plot::svg::{Anchor, Spot, Type};
use polhode_view::plot::{Ink, Marker, Stroke, Svg};

/// Width and height, pixels.
const SIZE: [f64; 2] = [860.0, 660.0];
/// The axes, pixels: left, top, right, bottom.
const FRAME: [f64; 4] = [74.0, 62.0, 846.0, 560.0];
/// Decimal logarithms at both ends of both axes; what is beyond stands at the edge.
const DECADES: [f64; 2] = [-17.0, 2.0];
/// Decades between marks.
const MARKS: usize = 3;
/// Half of the width of a marker, pixels.
const MARKER: f64 = 3.2;
/// Sizes of labels, pixels.
const LABEL: f64 = 12.0;

/// Where a decimal logarithm is along an axis between two places.
fn along(logarithm: f64, [from, to]: [f64; 2]) -> f64 {
    let [low, high] = DECADES;
    from + (logarithm.clamp(low, high) - low) / (high - low) * (to - from)
}

/// The place of a true and a told error, by their decimal logarithms.
fn spot(truth: f64, told: f64) -> Spot {
    let [left, top, right, bottom] = FRAME;
    [along(truth, [left, right]), along(told, [bottom, top])]
}

/// The decimal logarithm; the lowest of the axes for nothing.
fn logarithm(error: f64) -> f64 {
    if error > 0.0 { error.log10() } else { DECADES[0] }
}

/// The place of a run.
fn place(compared: &Compared) -> Spot {
    spot(logarithm(compared.truth), compared.told.map_or(DECADES[0], logarithm))
}

/// The figure.
pub(super) fn svg(judged: &[Judged]) -> String {
    let title = "The error that a run tells against its true error";
    let mut svg = Svg::new(SIZE, title);
    svg.text([12.0, 20.0], title, Type::new(16.0, Ink::Text).bold());
    let below = "one mark for a run, errors in sizes of a body; right are runs within the band";
    svg.text([12.0, 42.0], below, Type::new(LABEL, Ink::Faint));
    draw_band(&mut svg);
    draw_axes(&mut svg);
    let all = tiers(judged);
    for (number, tier) in all.iter().enumerate() {
        let (ink, marker) = (Ink::of_curve(number), Marker::ALL[number % Marker::ALL.len()]);
        let own = judged.iter().filter(|one| one.tier == *tier).filter_map(Judged::compared);
        for compared in own {
            marker.draw(&mut svg, place(compared), MARKER, ink);
        }
        let x = FRAME[0] + 150.0 * number as f64;
        marker.draw(&mut svg, [x, SIZE[1] - 22.0], MARKER, ink);
        svg.text([x + 10.0, SIZE[1] - 22.0], tier.name(), Type::new(LABEL, ink));
    }
    svg.finish()
}

/// What is right: between a tenth and a hundred times the true error.
fn draw_band(svg: &mut Svg) {
    let [low, high] = DECADES;
    let edge = |factor: f64| {
        let shift = logarithm(factor);
        let from = low.max(low - shift);
        let to = high.min(high - shift);
        [spot(from, from + shift), spot(to, to + shift)]
    };
    let (lower, upper) = (edge(TOO_LOW), edge(TOO_HIGH));
    let corners = [spot(low, low), upper[0], upper[1], spot(high, high), lower[1], lower[0]];
    svg.polygon(&corners, Ink::Band);
    svg.line(&edge(1.0), Stroke::new(Ink::Faint, 1.0));
    svg.line(&edge(FAR_TOO_LOW), Stroke::new(Ink::Faint, 1.0).dashed(5.0, 4.0));
    let label = |svg: &mut Svg, at: Spot, text: &str| {
        svg.text_on_ground(at, text, Type::new(LABEL, Ink::Faint).anchor(Anchor::End));
    };
    label(svg, [upper[1][0] - 20.0, upper[1][1] + 10.0], "100 times");
    label(svg, [lower[1][0] - 4.0, lower[1][1] + 22.0], "a tenth");
    label(svg, [lower[1][0] - 4.0, lower[1][1] + 52.0], "a hundredth");
}

fn draw_axes(svg: &mut Svg) {
    let [left, top, right, bottom] = FRAME;
    let [low, high] = DECADES;
    for decade in (low as i32..=high as i32).step_by(MARKS) {
        let [x, _] = spot(f64::from(decade), low);
        let [_, y] = spot(low, f64::from(decade));
        svg.line(&[[x, top], [x, bottom]], Stroke::new(Ink::Grid, 1.0));
        svg.line(&[[left, y], [right, y]], Stroke::new(Ink::Grid, 1.0));
        svg.power_of_ten([x, bottom + 14.0], "", decade, Type::new(LABEL, Ink::Faint).anchor(Anchor::Middle));
        svg.power_of_ten([left - 8.0, y], "", decade, Type::new(LABEL, Ink::Faint).anchor(Anchor::End));
    }
    svg.line(&[[left, top], [left, bottom], [right, bottom]], Stroke::new(Ink::Faint, 1.0));
    let name = Type::new(LABEL, Ink::Text).anchor(Anchor::Middle);
    svg.text([0.5 * (left + right), bottom + 36.0], "true error (smaller ones at the left edge)", name);
    svg.upward_text([20.0, 0.5 * (top + bottom)], "told error (none at the lower edge)", name);
}

//! The figure: error against cost on logarithmic axes, one curve for every method, the Pareto front behind them.

use super::text;
use polhode_study::law::OtherLaw;
use polhode_study::options::Counting;
use polhode_study::study::{Entry, Study};
use polhode_view::plot::cost_chart::{CostChart, CostCurve, CostPoint, Level, OtherUnits, Rank, Target};

/// Microseconds in a second.
const MICRO: f64 = 1e6;

/// Millimetres in a metre.
const MILLI: f64 = 1e3;

/// The figure as SVG, with the candidate that reaches a target marked where one is asked for.
pub(super) fn svg(study: &Study, target: Option<f64>) -> String {
    let cheapest = target.and_then(|target| Some((target, study.cheapest(target)?)));
    let scales = study.references.first().map(|reference| &reference.scales);
    // A second axis in millimetres needs one length for all curves.
    let length_m = scales.map(|scales| scales.length_m).filter(|length_m| {
        study.references.iter().all(|reference| reference.scales.length_m.to_bits() == length_m.to_bits())
    });
    let microseconds = match study.counting {
        Counting::Time => study.base_seconds().map(|seconds| seconds * MICRO / study.duration_s),
        Counting::Instructions => None,
    };
    let chart = CostChart {
        title: format!("{}: error against cost", study.scene),
        subtitle: subtitle(study),
        cost: study.cost_unit(),
        error: "error: position (relative) or attitude (rad), the larger".to_owned(),
        units: OtherUnits {
            microseconds,
            millimetres: length_m.map(|length_m| length_m * MILLI),
            degrees: Some(1.0_f64.to_degrees()),
        },
        floor: study.references.iter().map(|reference| reference.error).fold(f64::INFINITY, f64::min),
        levels: study.other_laws().into_iter().map(level).collect(),
        curves: curves(study, target),
        target: target.map(|error| Target {
            error,
            text: cheapest.map_or_else(String::new, |(_, entry)| entry.candidate.name()),
        }),
    };
    chart.svg()
}

/// The difference of a law that is not the scene's.
fn level(other: OtherLaw) -> Level {
    Level { error: other.difference, text: format!("difference of law: {}", other.law.name()) }
}

/// What errors are relative to, and how long the run is.
fn subtitle(study: &Study) -> String {
    let Some(reference) = study.references.first() else { return String::new() };
    let (scales, word) = (&reference.scales, reference.kind.word());
    format!(
        "{} s simulated, reference: {word}; an error of 1 is {} m, {}, or 1 rad",
        study.duration_s,
        text::short_length(scales.length_m),
        scales.length_is
    )
}

/// One curve for every series that has a point, in the order of the candidates.
fn curves(study: &Study, target: Option<f64>) -> Vec<CostCurve> {
    let cheapest = target.and_then(|target| study.cheapest(target));
    let ties = target.map_or_else(Vec::new, |target| study.ties(target));
    let is_in = |all: &[&Entry], entry: &Entry| all.iter().any(|other| std::ptr::eq(*other, entry));
    let mut curves: Vec<CostCurve> = Vec::new();
    for entry in &study.entries {
        let (Some(error), Ok(measured)) = (study.known_error(entry), &entry.outcome) else { continue };
        let rank = match cheapest {
            Some(cheapest) if std::ptr::eq(cheapest, entry) => Rank::Cheapest,
            _ if is_in(&ties, entry) => Rank::Tie,
            _ => Rank::Plain,
        };
        let (cost, spread, estimated) = (measured.cost(), measured.spread(), measured.estimated);
        let point = CostPoint { cost, spread, error, estimated, on_front: measured.on_front, rank };
        match curves.iter_mut().find(|curve| curve.name == entry.candidate.series) {
            Some(curve) => curve.points.push(point),
            None => curves.push(CostCurve { name: entry.candidate.series.clone(), points: vec![point] }),
        }
    }
    curves
}

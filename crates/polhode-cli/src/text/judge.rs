//! What is found of a trajectory, for people, and as a picture over time.

use super::table::{Table, number};
use polhode_study::judge::{Finding, Judgement, VelocitySource};
use polhode_view::plot::Ink;
use polhode_view::plot::time_chart::{AxisKind, Course, Line, OVER_TIME, Panel, TimeChart};
use polhode_view::plot::trace::Trace;
use std::fmt::Write as _;

/// The verdict, what was broken first, and a line for each law.
pub(crate) fn page(judgement: &Judgement) -> String {
    let Judgement { trajectory, scene, tolerance, .. } = judgement;
    let broken = judgement.broken();
    let mut text = match broken.first() {
        None => {
            format!("{trajectory} keeps the laws of {scene}, to {} of sizes, speeds and energies\n", number(*tolerance))
        }
        Some(first) => {
            let names: Vec<&str> = broken.iter().map(|own| own.law.name()).collect();
            let all = if names.len() > 1 { format!("; in this order: {}", names.join(", ")) } else { String::new() };
            format!(
                "{trajectory} breaks laws of {scene}: {} first, at t = {} s{all}\n",
                first.law.name(),
                number(first.first_s.unwrap_or(f64::NAN))
            )
        }
    };
    for own in &broken {
        let _ = writeln!(text, "  {}", sentence(own));
    }
    let _ = writeln!(text, "\n{}", facts(judgement));
    let mut table = Table::default();
    table.row(["law", "kept", "worst", "allowed there", "at t, s", "bodies", "is"]);
    for own in &judgement.findings {
        if own.limit.is_infinite() {
            table.row([own.law.name(), "", "", "", "", "", "nothing to judge"]);
            continue;
        }
        let kept = if own.is_kept() { "yes".to_owned() } else { format!("no, {} times", own.broken) };
        let unit = own.law.unit();
        let [worst, limit] = [own.worst, own.limit].map(|value| format!("{} {unit}", number(value)));
        table.row([own.law.name(), &kept, &worst, &limit, &number(own.at_s), &own.bodies.join(", "), own.law.value()]);
    }
    text.push_str(&table.print());
    for note in &judgement.notes {
        let _ = writeln!(text, "note: {note}");
    }
    text
}

/// What is broken, in a line.
fn sentence(own: &Finding) -> String {
    let bodies = if own.bodies.is_empty() { String::new() } else { format!(", {}", own.bodies.join(" and ")) };
    let what = if own.what.is_empty() { String::new() } else { format!(" ({})", own.what) };
    let (worst, at, unit) = (number(own.worst), number(own.at_s), own.law.unit());
    let first = number(own.first_s.unwrap_or(f64::NAN));
    format!(
        "{}: {worst} {unit} at t = {at} s{bodies}{what}; broken from t = {first} s on, {} times",
        own.law.name(),
        own.broken
    )
}

/// What the trajectory is.
fn facts(judgement: &Judgement) -> String {
    let [from, to] = judgement.span_s.map(number);
    let mut text = format!(
        "{} samples from t = {from} s to {to} s; velocities {}",
        judgement.samples,
        judgement.velocities.words()
    );
    if judgement.velocities == VelocitySource::Differences {
        let _ = write!(text, ", known to {} m/s", number(judgement.velocity_error_m_s));
    }
    let [first, last] = judgement.energy_j.map(number);
    let _ = write!(
        text,
        "\nenergy {first} J, then {last} J; unexplained: {} J; momentum unexplained: {} N s",
        number(judgement.unexplained_energy_j),
        number(judgement.unexplained_impulse_ns)
    );
    if let Some([from, to]) = judgement.gaps_s.first() {
        let (count, from, to) = (judgement.gaps_s.len(), number(*from), number(*to));
        let _ = write!(
            text,
            "\ngaps: {count} intervals are more than twice as long as most, first from t = {from} s to {to} s"
        );
    }
    if let Some(cut_off) = &judgement.cut_off {
        let _ = write!(text, "\n{cut_off}; what stands before is judged");
    }
    if let Some(last) = judgement.truth.as_ref().and_then(|truth| truth.over_time.last()) {
        let error = last.error_m.map_or_else(|| "not known".to_owned(), |error| format!("{} m", number(error)));
        let (t, apart) = (number(last.t_s), number(last.distance_m));
        let _ = write!(
            text,
            "\nfrom the truth (a run of tier accurate): {apart} m at t = {t} s; its own error there: {error}"
        );
    }
    text.push('\n');
    text
}

/// Panels over time: each law that has something to show, those that are broken in red.
pub(crate) fn picture(judgement: &Judgement) -> String {
    let line =
        |label: String, ink, course, samples: Vec<[f64; 2]>| Line { label, ink, course, trace: Trace::of(samples) };
    let panel = |own: &Finding| {
        let unit = own.law.unit();
        let ink = if own.is_kept() { Ink::Blue } else { Ink::Vermilion };
        let label = format!("worst {} {unit}", number(own.worst));
        let magnitudes = own.over_time.iter().map(|[t, value]| [*t, value.abs()]).collect();
        let mut lines = vec![line(label, ink, Course::Straight, magnitudes)];
        if let Some(truth) = judgement.truth.as_ref().filter(|_| own.law == polhode_study::judge::Law::Truth) {
            let errors = truth.over_time.iter().filter_map(|own| Some([own.t_s, own.error_m?])).collect();
            lines.push(line("error of the run".to_owned(), Ink::Grey, Course::Dashed, errors));
        }
        let first = own.first_s.map_or_else(|| "kept".to_owned(), |t| format!("broken from t = {} s on", number(t)));
        let note = format!("{first}; {}", own.law.value());
        Panel {
            title: format!("{}, {unit}", own.law.name()),
            note,
            axis: AxisKind::Logarithmic,
            lines,
            bands: Vec::new(),
        }
    };
    let is_shown = |own: &&Finding| own.over_time.iter().any(|[_, value]| *value != 0.0);
    let panels: Vec<Panel> = judgement.findings.iter().filter(is_shown).map(panel).collect();
    let title = format!("{} judged by the laws of {}", judgement.trajectory, judgement.scene);
    let subtitle = match judgement.broken().first() {
        None => "all laws are kept".to_owned(),
        Some(first) => {
            format!("{} is broken first, at t = {} s", first.law.name(), number(first.first_s.unwrap_or(f64::NAN)))
        }
    };
    TimeChart { title, subtitle, events: Vec::new(), panels, stop: None, along: OVER_TIME.to_owned() }.svg()
}

//! The candidates when none are asked for: every integrator over steps where nothing can collide; where bodies meet,
//! the tiers over steps and tolerances, the thesis's own ways to find contact forces, and the impact laws that are not
//! the scene's.

use crate::candidate::{Candidate, change};
use polhode::scene::{ContactMethod, ImpactLaw, Integrator, Response, Tier};
use polhode::tier::TierFeature;
use polhode_scene::{Override, names};

/// Ratio of a step to the next: 2 shows the order of a method well, 4 spans five decades of error in a few runs.
const STEP_RATIO: u64 = 4;

/// Steps in a ladder.
const STEP_RUNGS: u32 = 6;

/// Steps of the coarsest rung at the least.
const FEWEST_STEPS: f64 = 20.0;

/// Steps of the coarsest rung at the most: a scene that turns faster than that needs steps that are asked for.
const MOST_COARSEST_STEPS: f64 = 1e6;

/// Largest angle turned in a step of the coarsest rung, rad: beyond it no method of fixed step is of use.
const COARSEST_ANGLE: f64 = 1.0;

/// Characters of a number in a table; one of more is shown in fewer digits.
const WIDEST: usize = 8;

/// Tolerances of error-controlled methods (dimensionless).
const TOLERANCES: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// Loosest tolerance tried where bodies meet: a looser one leaves events where they are not.
const LOOSEST_CONTACT_TOLERANCE: f64 = 1e-6;

/// Penetrations that springs are to keep, m; a tenth of one takes about three times as long.
const PENETRATIONS_M: [f64; 4] = [1e-2, 1e-3, 1e-4, 1e-5];

/// Tolerance of runs on springs (dimensionless): far below what their penetration errs by.
const SPRING_TOLERANCE: f64 = 1e-8;

/// How much longer an error-controlled run takes at the next tolerance, about: 100^(1/8), rounded up.
const TOLERANCE_GROWTH: f64 = 2.0;

/// Tolerance of runs by another impact law (dimensionless): they show the law, whose difference is far larger.
const LAW_TOLERANCE: f64 = 1e-6;

/// The key of the tier.
const TIER: &str = "method.tier";

/// The key of the tolerance.
const TOLERANCE: &str = "method.tolerance";

/// What decides about the candidates of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SceneFacts {
    /// Simulated time, s.
    pub duration_s: f64,
    /// Whether two bodies may collide.
    pub contact: bool,
    /// Whether all motion is flight in closed form.
    pub closed_form: bool,
    /// Largest angular speed of a body, rad/s.
    pub angular_speed: f64,
    /// The impact law of the scene.
    pub impact: ImpactLaw,
}

/// Which candidates are looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Range {
    /// The methods, and the impact laws beside the scene's.
    MethodsAndLaws,
    /// The methods alone: who asks for an accuracy asks for it under the law of the scene.
    Methods,
}

/// One method and the setting that is stepped through.
struct Series {
    name: &'static str,
    /// Key and value that select the method.
    selects: [&'static str; 2],
    /// What it needs besides.
    besides: Vec<(&'static str, String)>,
    stepped: &'static str,
    values: Vec<String>,
    growth: f64,
    /// Whether its first candidate too may only take its share of the time.
    is_limited: bool,
}

impl Series {
    /// A method of fixed step, over steps.
    fn by_steps(name: &'static str, selects: [&'static str; 2], steps: Vec<String>) -> Self {
        let growth = STEP_RATIO as f64;
        Self { name, selects, besides: Vec::new(), stepped: "method.step", values: steps, growth, is_limited: false }
    }

    /// A method that controls its error, over these tolerances.
    fn by_tolerances(name: &'static str, selects: [&'static str; 2], tolerances: impl Iterator<Item = f64>) -> Self {
        Self {
            name,
            selects,
            besides: Vec::new(),
            stepped: TOLERANCE,
            values: tolerances.map(|tolerance| format!("{tolerance:e}")).collect(),
            growth: TOLERANCE_GROWTH,
            is_limited: false,
        }
    }

    /// Springs, over what they give way: that is what they err by, and the tolerance must not bind.
    fn by_penetrations(name: &'static str, selects: [&'static str; 2]) -> Self {
        Self {
            name,
            selects,
            besides: vec![(TOLERANCE, format!("{SPRING_TOLERANCE:e}"))],
            stepped: "method.penalty.penetration_m",
            values: PENETRATIONS_M.map(|depth| format!("{depth:e}")).to_vec(),
            growth: STEP_RATIO as f64,
            is_limited: true,
        }
    }

    /// With another setting besides.
    fn with(mut self, key: &'static str, value: String) -> Self {
        self.besides.push((key, value));
        self
    }

    /// With no more than its share of the time for any of its candidates.
    fn limited(mut self) -> Self {
        self.is_limited = true;
        self
    }
}

/// Candidates for a scene, the cheapest of each series first. Keys in `given` are set already: a method that they
/// exclude is left out, and a setting that they fix is not stepped through.
pub fn candidates(facts: &SceneFacts, given: &[Override], range: Range) -> Vec<Candidate> {
    let value_of = |key: &str| given.iter().rev().find(|change| change.key == key).map(|change| change.value.as_str());
    let mut all = if facts.contact { with_contact(facts) } else { without_contact(facts) };
    if facts.contact && range == Range::MethodsAndLaws {
        all.extend(other_laws(facts));
    }
    let mut candidates = Vec::new();
    for series in all {
        let [key, value] = series.selects;
        let is_other =
            |key: &str, value: &str| value_of(key).is_some_and(|given| given.trim_matches(['"', '\'']) != value);
        let needs_other_tier = |(key, value): &(&str, String)| *key == TIER && is_other(key, value);
        if is_other(key, value) || series.besides.iter().any(needs_other_tier) {
            continue;
        }
        let mut base = vec![change(key, value)];
        base.extend(series.besides.iter().map(|(key, value)| change(key, value)));
        base.retain(|change| value_of(&change.key).is_none());
        if let Some(given) = value_of(series.stepped) {
            let rung = rung(series.stepped, given);
            candidates.push(Candidate { series: series.name.to_owned(), rung, changes: base, growth: None });
            continue;
        }
        for (number, value) in series.values.iter().enumerate() {
            let mut changes = base.clone();
            changes.push(change(series.stepped, value));
            let growth = (number > 0 || series.is_limited).then_some(series.growth);
            let rung = rung(series.stepped, value);
            candidates.push(Candidate { series: series.name.to_owned(), rung, changes, growth });
        }
    }
    candidates
}

fn rung(key: &str, value: &str) -> String {
    let short =
        if value.len() > WIDEST { value.parse().map_or_else(|_| value.to_owned(), shown) } else { value.to_owned() };
    format!("{} {short}", key.strip_prefix("method.").unwrap_or(key))
}

/// Every integrator: those of fixed step over steps, the error-controlled ones over tolerances; one that is a closed
/// form here needs a single step.
fn without_contact(facts: &SceneFacts) -> Vec<Series> {
    let series = |integrator: Integrator| {
        let name = names::integrator(integrator);
        let selects = ["method.integrator", name];
        if integrator.is_exact_without_loads() && facts.closed_form {
            Series::by_steps(name, selects, vec![number(facts.duration_s)])
        } else if integrator.controls_error() {
            // The step is an upper bound that must not bind.
            Series::by_tolerances(name, selects, TOLERANCES.into_iter()).with("method.step", number(facts.duration_s))
        } else {
            Series::by_steps(name, selects, steps(facts))
        }
    };
    Integrator::ALL.into_iter().map(series).collect()
}

/// Every tier: one under error control over tolerances, one of fixed steps over steps.
fn with_contact(facts: &SceneFacts) -> Vec<Series> {
    let series = |tier: Tier| {
        let (name, selects) = (tier.name(), [TIER, tier.name()]);
        if tier.facts().own_response == Some(Response::Penalty) {
            Series::by_penetrations(name, selects)
        } else if tier.facts().controls_error() {
            let tight = TOLERANCES.into_iter().filter(|&tolerance| tolerance <= LOOSEST_CONTACT_TOLERANCE);
            Series::by_tolerances(name, selects, tight)
        } else {
            Series::by_steps(name, selects, steps(facts))
        }
    };
    Tier::ALL.into_iter().map(series).chain(own_ways_of_the_thesis(facts)).collect()
}

/// The other ways of the thesis to find contact forces (section 3.4), in the tiers that take them, over steps.
fn own_ways_of_the_thesis(facts: &SceneFacts) -> impl Iterator<Item = Series> {
    let series = |tier: Tier, method: ContactMethod| {
        let selects = ["method.contact", method.name()];
        Series::by_steps(method.name(), selects, steps(facts)).with(TIER, tier.name().to_owned()).limited()
    };
    let tiers = Tier::ALL.into_iter().filter(|tier| tier.facts().takes(TierFeature::LeastForce));
    tiers.flat_map(move |tier| [ContactMethod::Heuristic, ContactMethod::Guesses].map(|method| series(tier, method)))
}

/// The impact laws that are not the scene's, each by one run of the most accurate tier.
fn other_laws(facts: &SceneFacts) -> impl Iterator<Item = Series> {
    let own = facts.impact;
    ImpactLaw::ALL.into_iter().filter(move |&law| law != own).map(|law| {
        let name = names::impact(law);
        Series::by_tolerances(name, ["method.impact", name], std::iter::once(LAW_TOLERANCE))
            .with(TIER, Tier::default().name().to_owned())
            .limited()
    })
}

/// A candidate between two of one series, the second finer than the first: with a ladder of wide rungs, the first
/// setting that reaches an error may be far better than needed. None where the setting is no number, or nothing lies
/// between.
pub fn between(coarse: &Candidate, fine: &Candidate, duration_s: f64) -> Option<Candidate> {
    let (first, second) = (coarse.changes.last()?, fine.changes.last()?);
    let values: [f64; 2] = [first.value.parse().ok()?, second.value.parse().ok()?];
    let mean = (values[0] * values[1]).sqrt();
    if coarse.series != fine.series || first.key != second.key || !(values[1] < mean && mean < values[0]) {
        return None;
    }
    let value = if first.key == "method.step" {
        number(dividing(duration_s, (duration_s / mean).round() as u64))
    } else {
        format!("{mean:.1e}")
    };
    let mut changes = coarse.changes.clone();
    *changes.last_mut()? = change(&first.key, &*value);
    let rung = rung(&first.key, &value);
    Some(Candidate { series: coarse.series.clone(), rung, changes, growth: fine.growth.map(f64::sqrt) })
}

/// Steps that divide the duration, the coarsest first, as they are written in a scene file.
pub fn steps(facts: &SceneFacts) -> Vec<String> {
    let turns = facts.angular_speed * facts.duration_s / COARSEST_ANGLE;
    // What is not a number counts as no turning.
    let turns = if turns.is_nan() { 0.0 } else { turns };
    let coarsest = round_up(turns.clamp(FEWEST_STEPS, MOST_COARSEST_STEPS)) as u64;
    (0..STEP_RUNGS).map(|rung| number(dividing(facts.duration_s, coarsest * STEP_RATIO.pow(rung)))).collect()
}

/// The smallest number of at least `duration / count` that reaches the duration in `count` steps: one that fell short
/// of it by its rounding would cost one step more.
fn dividing(duration_s: f64, count: u64) -> f64 {
    let step = duration_s / count as f64;
    if step * (count as f64) < duration_s { step.next_up() } else { step }
}

/// 1, 2 or 5 times a power of ten, not below `value`: counts of steps that a person would choose.
fn round_up(value: f64) -> f64 {
    let power = 10.0_f64.powf(value.log10().floor());
    [1.0, 2.0, 5.0].map(|digit| digit * power).into_iter().find(|&round| round >= value).unwrap_or(10.0 * power)
}

/// A number in at most four digits, to be read.
fn shown(value: f64) -> String {
    format!("{:?}", format!("{value:.3e}").parse().unwrap_or(value))
}

/// A number in the fewest digits that give the same bits when read.
fn number(value: f64) -> String {
    format!("{value:?}")
}

#[cfg(test)]
mod tests {
    //! Ladders span what the scene needs, and what is set already is left as it is.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;

    const FREE: SceneFacts = SceneFacts {
        duration_s: 100.0,
        contact: false,
        closed_form: true,
        angular_speed: 2.0,
        impact: ImpactLaw::Reflection,
    };

    #[test]
    fn the_coarsest_step_turns_by_a_radian_at_most() {
        assert_eq!(steps(&FREE)[..3], ["0.5", "0.125", "0.03125"]);
        let slow = SceneFacts { angular_speed: 0.0, ..FREE };
        assert_eq!(steps(&slow)[0], "5.0");
        for speed in [f64::NAN, f64::INFINITY, 1e300] {
            assert_eq!(steps(&SceneFacts { angular_speed: speed, ..FREE }).len(), STEP_RUNGS as usize);
        }
    }

    #[test]
    fn steps_reach_the_end_without_a_sliver() {
        for duration_s in [0.1, 0.3, 1.0 / 3.0, 1e-7, 12345.678] {
            for step in steps(&SceneFacts { duration_s, ..FREE }) {
                let step: f64 = step.parse().unwrap();
                let count = (duration_s / step).round();
                assert!(step * count >= duration_s && step * (count - 1.0) < duration_s, "{step} of {duration_s}");
            }
        }
    }

    #[test]
    fn counts_are_round() {
        assert_eq!([20.0, 21.0, 51.0, 229.0, 1e6].map(round_up), [20.0, 50.0, 100.0, 500.0, 1e6]);
    }

    #[test]
    fn every_integrator_is_a_candidate_where_nothing_collides() {
        let all = candidates(&FREE, &[], Range::Methods);
        for integrator in Integrator::ALL {
            let name = names::integrator(integrator);
            assert!(all.iter().any(|candidate| candidate.series == name), "{name}");
        }
        let exact: Vec<_> = all.iter().filter(|candidate| candidate.series == "exact").collect();
        assert_eq!(exact.len(), 1, "a closed form needs no ladder");
        assert_eq!(exact[0].value("method.step"), Some("100.0"));
    }

    #[test]
    fn what_is_given_is_not_varied() {
        let given = [change("method.integrator", "\"rk4\""), change("method.step", "0.1")];
        let all = candidates(&FREE, &given, Range::Methods);
        assert_eq!(all.len(), 1);
        assert_eq!((all[0].name().as_str(), all[0].changes.len()), ("rk4 step 0.1", 0));
        let contact = SceneFacts { contact: true, ..FREE };
        let all = candidates(&contact, &[change("method.tier", "thesis")], Range::Methods);
        // The tier has two further ways to find contact forces; the impact laws are run by another tier.
        assert!(all.iter().all(|candidate| ["thesis", "heuristic", "guesses"].contains(&candidate.series.as_str())));
        assert_eq!(all.len(), 3 * STEP_RUNGS as usize);
        let all = candidates(&contact, &[change("method.tier", "stepped")], Range::MethodsAndLaws);
        assert!(all.iter().all(|candidate| candidate.series == "stepped"));
    }
}

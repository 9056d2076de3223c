//! What candidates are compared with: the exact solution, or the finest one.
//!
//! The reference is *exact* where the plan finds that every body flies in closed form; that this is so is checked by a
//! second run in other steps, which must give the same motion. Elsewhere it is the *finest*: the tightest tolerance
//! that runs under error control, or very short steps where none does, and its own error is estimated from a run that
//! is a little coarser. Either way what is not known about the reference is shown, and no candidate's error below that
//! is claimed.

use crate::candidate::change;
use crate::difference::Scales;
use crate::ladder::SceneFacts;
use crate::source::{Completed, Source};
use polhode::scene::{ImpactLaw, Integrator};
use polhode::{Decision, Effect, Plan, Scene, Simulation};
use polhode_scene::{Override, names};
use std::fmt::Write as _;

/// Tolerances of the finest solution and of the second finest (dimensionless), the next pair where one does not run.
const FINEST: [[f64; 2]; 3] = [[1e-13, 1e-12], [1e-12, 1e-11], [1e-11, 1e-10]];

/// Steps of the finest solution in the duration at the least. Error control chooses shorter ones where they are
/// needed; many more than these would add round-off.
const FEWEST_STEPS: f64 = 200.0;

/// Steps of the finest solution without error control.
const SHORT_STEPS: f64 = 40_000.0;

/// Steps of the run that checks a closed form: a count that divides no ladder's.
const CHECKING_STEPS: f64 = 7.0;

/// Largest difference between two runs of a closed form in different steps, of angle turned and of the scene's
/// length: round-off grows with time and near a separatrix, an error of the step would be far larger.
const CLOSED_FORM_DIFFERENCE: f64 = 1e-9;

/// Round-off of a number near one: what no solution in f64 goes below, per radian turned.
const ROUND_OFF: f64 = f64::EPSILON;

/// How the reference was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// In closed form, to round-off.
    Exact,
    /// By the most accurate run.
    Finest,
}

impl Kind {
    /// The word for it.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Finest => "finest",
        }
    }
}

/// The solution that candidates of one model are compared with.
#[derive(Debug)]
pub struct Reference {
    /// How it was found.
    pub kind: Kind,
    /// The settings it was found by.
    pub method: String,
    /// What its own error is known to stay below, about: as a candidate's error is measured.
    pub error: f64,
    /// How that is known.
    pub basis: String,
    /// What errors are relative to.
    pub scales: Scales,
    /// What makes the model differ from the scene's; empty for the scene as it is.
    pub model: Vec<Override>,
    /// What decides about candidates.
    pub facts: SceneFacts,
    /// The solution.
    pub run: Completed,
}

/// Finds the reference of a model; `finest_step_s` is the smallest step of a candidate, where it is known.
///
/// # Errors
/// Why there is none, in a line.
pub fn find(
    source: &Source<'_>,
    model: &[Override],
    samples: u32,
    finest_step_s: Option<f64>,
) -> Result<Reference, String> {
    let scene = source.scene(model)?;
    let search = Search { source, model, impact: impact(source, &scene), interval: sampling(&scene, samples) };
    let mut faults = Vec::new();
    match search.exact(scene.duration_s()) {
        Ok(Some(reference)) => return Ok(reference),
        Ok(None) => {}
        Err(fault) => faults.push(fault),
    }
    for pair in attempts(&scene, finest_step_s) {
        match search.finest(pair) {
            Ok(reference) => return Ok(reference),
            Err(fault) => faults.push(fault),
        }
    }
    faults.dedup();
    Err(format!("no reference solution: {}", faults.join("; ")))
}

/// How the reference is computed.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Means {
    integrator: Option<Integrator>,
    tolerance: Option<f64>,
    step_s: f64,
}

/// What the finest solution is looked for by, each with what it is compared with, the best first.
fn attempts(scene: &Scene, finest_step_s: Option<f64>) -> Vec<[Means; 2]> {
    let finest_step_s = finest_step_s.unwrap_or(f64::INFINITY);
    let step_s = finest_step_s.min(scene.duration_s() / FEWEST_STEPS);
    let controlled = |integrator: Option<Integrator>| {
        FINEST.map(|[finest, second]| {
            let means = |tolerance, step_s| Means { integrator, tolerance: Some(tolerance), step_s };
            [means(finest, step_s), means(second, step_s / 2.0)]
        })
    };
    let mut attempts = Vec::new();
    let (contact, forces) = (scene.any_may_collide(), !scene.forces().is_empty());
    if forces || !contact {
        attempts.extend(controlled(Some(Integrator::Dop853)));
    }
    if contact {
        // Without forces bodies fly in closed form between contacts, which the tier knows by itself.
        attempts.extend(controlled(None));
    } else {
        let short_s = (finest_step_s / 2.0).min(scene.duration_s() / SHORT_STEPS);
        let means = |step_s| Means { integrator: Some(Integrator::Cf4), tolerance: None, step_s };
        attempts.push([means(short_s), means(2.0 * short_s)]);
    }
    attempts
}

/// The interval that gives this number of samples, as a change of the scene.
pub fn sampling(scene: &Scene, samples: u32) -> Override {
    change("output.interval", format!("{:?}", scene.duration_s() / f64::from(samples.max(1))))
}

/// Whether the plan says that all motion is flight in closed form.
pub fn is_closed_form(plan: &Plan, scene: &Scene) -> bool {
    let decided = |effect: Effect| plan.effects.iter().find(|decision| decision.effect == effect);
    let is = |effect, decision| decided(effect).is_some_and(|found| found.decision == decision);
    plan.integrator == Integrator::Exact
        && is(Effect::BallisticFlight, Decision::On)
        && [Effect::Contact, Effect::Joints, Effect::ForceFields].into_iter().all(|effect| is(effect, Decision::Off))
        && scene.forces().is_empty()
}

/// The impact law of the scene, which the reference shares; that of the tier when the scene as it is does not run.
fn impact(source: &Source<'_>, scene: &Scene) -> Option<ImpactLaw> {
    scene.method().impact.or_else(|| plan(source, scene).ok().map(|plan| plan.impact))
}

fn plan(source: &Source<'_>, scene: &Scene) -> Result<Plan, String> {
    Ok(Simulation::with_effects(scene, source.effects).map_err(|error| error.to_string())?.plan().clone())
}

/// What all tries for a reference have in common.
struct Search<'a> {
    source: &'a Source<'a>,
    model: &'a [Override],
    impact: Option<ImpactLaw>,
    interval: Override,
}

impl Search<'_> {
    /// A method that replaces the scene's whole table `[method]`, so that nothing of it is left in the way.
    fn method(&self, means: Means) -> String {
        let mut text = format!("tier = \"accurate\", step = {:?}", means.step_s);
        let settings = [
            ("integrator", means.integrator.map(|integrator| format!("\"{}\"", names::integrator(integrator)))),
            ("tolerance", means.tolerance.map(|tolerance| format!("{tolerance:e}"))),
            ("impact", self.impact.map(|law| format!("\"{}\"", names::impact(law)))),
        ];
        for (key, value) in settings {
            if let Some(value) = value {
                let _ = write!(text, ", {key} = {value}");
            }
        }
        text
    }

    fn scene(&self, method: &str) -> Result<Scene, String> {
        let mut changes = self.model.to_vec();
        changes.extend([change("method", format!("{{ {method} }}")), self.interval.clone()]);
        self.source.scene(&changes)
    }

    fn record(&self, method: String) -> Result<Recorded, String> {
        let scene = self.scene(&method)?;
        let run = self.source.record(&scene, None)?;
        let scales = Scales::of(&scene, &run.record);
        Ok(Recorded { method, scene, scales, run })
    }

    /// The closed form, checked by a second run in other steps; `None` where the plan knows of none.
    fn exact(&self, duration_s: f64) -> Result<Option<Reference>, String> {
        let means = |step_s| Means { integrator: Some(Integrator::Exact), tolerance: None, step_s };
        let method = self.method(means(duration_s));
        let scene = self.scene(&method)?;
        if !is_closed_form(&plan(self.source, &scene)?, &scene) {
            return Ok(None);
        }
        let first = self.record(method)?;
        let difference = first.difference(&self.record(self.method(means(duration_s / CHECKING_STEPS)))?)?;
        if difference > CLOSED_FORM_DIFFERENCE * first.scales.angle.max(1.0) {
            return Err(format!("the closed form depends on the step by {difference:.1e}"));
        }
        let (angle, round_off) = (first.scales.angle, first.round_off());
        let basis = format!(
            "round-off of {angle:.1} rad turned: {round_off:.1e}; in other steps it differs by {difference:.1e}"
        );
        Ok(Some(self.reference(Kind::Exact, round_off.max(difference), basis, first)))
    }

    /// The finest solution, and how far one that is a little coarser is from it.
    fn finest(&self, [finest, second]: [Means; 2]) -> Result<Reference, String> {
        let first = self.record(self.method(finest))?;
        let difference = first.difference(&self.record(self.method(second))?)?;
        let coarser = match second.tolerance {
            Some(tolerance) => format!("tolerance {tolerance:e} in half the step"),
            None => "twice the step".to_owned(),
        };
        let basis = format!("{coarser} differs by {difference:.1e}; an error that both share is not seen");
        Ok(self.reference(Kind::Finest, difference.max(first.round_off()), basis, first))
    }

    fn reference(&self, kind: Kind, error: f64, basis: String, recorded: Recorded) -> Reference {
        let Recorded { method, scene, scales, run } = recorded;
        let facts = SceneFacts {
            duration_s: scene.duration_s(),
            contact: scene.any_may_collide(),
            closed_form: kind == Kind::Exact,
            angular_speed: scales.angular_speed,
            impact: run.report.plan.impact,
        };
        Reference { kind, method, error, basis, scales, model: self.model.to_vec(), facts, run }
    }
}

/// A run that may become the reference.
struct Recorded {
    method: String,
    scene: Scene,
    scales: Scales,
    run: Completed,
}

impl Recorded {
    /// How far another run is from this one.
    fn difference(&self, other: &Self) -> Result<f64, String> {
        let difference = self.scales.errors(&self.run.record, &other.run.record)?.headline();
        if difference.is_nan() { Err(format!("{}: the motion is not a number", self.method)) } else { Ok(difference) }
    }

    /// What no solution in f64 goes below.
    fn round_off(&self) -> f64 {
        ROUND_OFF * self.scales.angle.max(1.0)
    }
}

#[cfg(test)]
mod tests {
    //! What the reference is looked for by.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;
    use polhode::Body;
    use polhode::contact::Shape;
    use polhode::spatial::{DVec3, Inertia, Mass, MassProperties};

    fn ball(name: &str, shape: Option<Shape>) -> Body {
        let inertia = Inertia::from_diagonal(DVec3::ONE).unwrap();
        let body = Body::movable(name, MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia));
        shape.map_or(body.clone(), |shape| body.geometry(shape.into()))
    }

    #[test]
    fn error_control_where_nothing_collides_then_short_steps() {
        let scene = Scene::builder("free").body(ball("a", None)).duration_s(8.0).build().unwrap();
        let all = attempts(&scene, None);
        let [first, second] = all[0];
        assert_eq!((first.integrator, first.tolerance), (Some(Integrator::Dop853), Some(1e-13)));
        assert!(second.tolerance > first.tolerance && second.step_s != first.step_s);
        let [short, _] = all[all.len() - 1];
        assert_eq!((short.tolerance, short.step_s), (None, 2e-4));
        let [asked, _] = attempts(&scene, Some(1e-5))[all.len() - 1];
        assert_eq!(asked.step_s, 5e-6, "finer than any candidate");
    }

    #[test]
    fn the_tier_itself_where_bodies_meet() {
        let sphere = || Some(Shape::sphere(1.0).unwrap());
        let scene = Scene::builder("two").body(ball("a", sphere())).body(ball("b", sphere())).build().unwrap();
        assert!(attempts(&scene, None).iter().flatten().all(|means| means.integrator.is_none()));
    }
}

//! A run's error as it tells it beside its true error.

use super::distance::Sizes;
use super::known::Known;
use super::setting::{in_tier, law_of, sampled};
use super::trial::{NoTrial, Trial};
use super::truth::{TrueMotion, Unknown};
use polhode::Scene;
use polhode::scene::{ImpactLaw, Tier};
use polhode::tier::TierFeature;
use polhode::{BodyId, ErrorEstimation};
use std::error::Error;
use std::time::Instant;

/// Errors below this are rounding, of a body's size.
pub const ROUNDING: f64 = 1e-13;
/// The truth must be known to this part of the error that is judged by it.
const KNOWN_TO: f64 = 1.0 / 3.0;
/// A run of fewer samples than these is too short to judge.
const FEWEST: usize = 4;

/// What came of a scene in a tier.
#[derive(Debug, Clone)]
pub struct Judged {
    /// Name of the scene.
    pub name: String,
    /// The tier.
    pub tier: Tier,
    /// What was found.
    pub finding: Finding,
    /// Time that it took, with its share of the truth, s.
    pub wall_s: f64,
}

/// What is found of a run.
#[derive(Debug, Clone, PartialEq)]
pub enum Finding {
    /// Its true error, and what it told, of a body's size.
    Compared(Compared),
    /// The truth is not known well enough: why.
    Unjudged(String),
    /// The tier does not take the scene.
    Refused(String),
    /// The scene or the run failed.
    Failed(String),
    /// It took many steps or a long time.
    Late,
}

/// Errors of a run, of a body's size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compared {
    /// The true one.
    pub truth: f64,
    /// The one told; none where none was.
    pub told: Option<f64>,
    /// Up to when it was judged, s.
    pub until_s: f64,
}

impl Compared {
    /// The told error over the true one.
    pub fn ratio(&self) -> Option<f64> {
        self.told.map(|told| told / self.truth)
    }

    /// Whether the told error is at least this part of the true one; an error of rounding needs not be told.
    pub fn is_at_least(&self, part: f64) -> bool {
        self.truth < ROUNDING || self.told.is_some_and(|told| told >= part * self.truth)
    }

    /// Whether the told error is at most so many times the true one, or that of rounding.
    pub fn is_at_most(&self, times: f64) -> bool {
        self.told.is_none_or(|told| told <= times * self.truth.max(ROUNDING))
    }
}

/// All tiers of a scene.
pub(super) fn judge(known: &Known, estimation: ErrorEstimation) -> Vec<Judged> {
    let scene = match (known.scene)().and_then(|scene| sampled(scene)) {
        Ok(scene) => scene,
        Err(error) => return known.tiers.iter().map(|&tier| failed(known, tier, error.as_ref())).collect(),
    };
    let mut truths = Truths { known, scene: &scene, estimation, made: Vec::new() };
    let judged = |&tier: &Tier| {
        let start = Instant::now();
        let finding = truths.finding(tier).unwrap_or_else(|finding| finding);
        Judged { name: known.name.clone(), tier, finding, wall_s: start.elapsed().as_secs_f64() }
    };
    known.tiers.iter().map(judged).collect()
}

fn failed(known: &Known, tier: Tier, error: &dyn Error) -> Judged {
    let finding = Finding::Failed(error.to_string().replace('\n', " "));
    Judged { name: known.name.clone(), tier, finding, wall_s: 0.0 }
}

/// A scene and its true motions, each made once.
struct Truths<'a> {
    known: &'a Known,
    scene: &'a Scene,
    estimation: ErrorEstimation,
    made: Vec<(ImpactLaw, Result<TrueMotion, Unknown>)>,
}

impl Truths<'_> {
    /// The true motion by a law of impacts.
    fn by(&mut self, law: ImpactLaw, times_s: &[f64]) -> Result<&TrueMotion, Finding> {
        if !self.made.iter().any(|(made, _)| *made == law) {
            self.made.push((law, TrueMotion::of(self.known, self.scene, law, times_s)));
        }
        let found = self.made.iter().find(|(made, _)| *made == law).map(|(_, truth)| truth.as_ref());
        found.unwrap_or(Err(&Unknown(String::new()))).map_err(|Unknown(why)| Finding::Unjudged(why.replace('\n', " ")))
    }

    /// What is found of a tier: the run of the whole scene, or of what of it is known.
    fn finding(&mut self, tier: Tier) -> Result<Finding, Finding> {
        if !tier.facts().takes(TierFeature::Friction) && has_friction(self.scene) {
            return Err(Finding::Refused("the tier has no friction".to_owned()));
        }
        let scene = in_tier(self.scene, tier, self.known.step_s);
        let trial = run(&scene, self.estimation)?;
        let sizes = Sizes::of(self.scene);
        let law = if self.known.is_by_runs() { law_of(self.scene, tier) } else { ImpactLaw::Reflection };
        let truth = self.by(law, &trial.times_s)?;
        let known = known_part(&sizes, truth, &trial)?;
        if known.last + 1 == trial.times_s.len() {
            return Ok(Finding::Compared(known.compared));
        }
        if known.last < FEWEST {
            return Err(Finding::Unjudged("the truth is not known well enough".to_owned()));
        }
        // Judged is a run that ends where the truth is lost: what it tells is of that part.
        let shorter = scene.with_duration(trial.times_s[known.last]).map_err(|e| Finding::Failed(e.to_string()))?;
        let told = run(&shorter, self.estimation)?.told.relative;
        Ok(Finding::Compared(Compared { told, ..known.compared }))
    }
}

/// Whether friction acts between any two bodies of a scene.
fn has_friction(scene: &Scene) -> bool {
    let bodies = || (0..scene.bodies().len()).map(BodyId::new);
    let rubs = |a: BodyId, b: BodyId| scene.material_between(a, b).is_ok_and(|material| material.friction() > 0.0);
    bodies().any(|a| bodies().any(|b| a < b && scene.can_collide(a, b) && rubs(a, b)))
}

fn run(scene: &Scene, estimation: ErrorEstimation) -> Result<Trial, Finding> {
    Trial::of(scene, estimation).map_err(|why| match why {
        NoTrial::Refused(why) => Finding::Refused(why.replace('\n', " ")),
        NoTrial::Failed(why) => Finding::Failed(why.replace('\n', " ")),
        NoTrial::Late => Finding::Late,
    })
}

/// The part of a run of which the truth is known.
struct KnownPart {
    /// The number of its last sample.
    last: usize,
    compared: Compared,
}

/// The samples up to the last at which the truth is known to a third of the error, before the horizon that the run
/// tells.
fn known_part(sizes: &Sizes, truth: &TrueMotion, trial: &Trial) -> Result<KnownPart, Finding> {
    let horizon_s = trial.told.horizon_s.unwrap_or(f64::INFINITY);
    let mut most = 0.0f64;
    let mut known = None;
    let truths = truth.places.iter().zip(&truth.uncertainty);
    let rows = trial.times_s.iter().zip(&trial.rows);
    let last = trial.times_s.len().saturating_sub(1);
    for (number, ((&t, row), (places, &uncertainty))) in rows.zip(truths).enumerate() {
        if t > horizon_s {
            // Beyond the horizon nothing is promised: the run is judged whole.
            return known.map(|known| KnownPart { last, ..known }).ok_or(Finding::Unjudged("no time".to_owned()));
        }
        most = most.max(sizes.largest(places, row));
        if uncertainty <= KNOWN_TO * most.max(ROUNDING) {
            let compared = Compared { truth: most, told: trial.told.relative, until_s: t };
            known = Some(KnownPart { last: number, compared });
        }
    }
    known.ok_or_else(|| Finding::Unjudged("the truth is not known well enough".to_owned()))
}

#[cfg(test)]
mod tests {
    //! What is too low and too high, and that rounding is neither.
    use super::*;

    fn compared(truth: f64, told: f64) -> Compared {
        Compared { truth, told: Some(told), until_s: 1.0 }
    }

    #[test]
    fn errors_are_told_too_low_or_too_high() {
        assert!(compared(1e-3, 1e-4).is_at_least(0.1));
        assert!(!compared(1e-3, 0.9e-4).is_at_least(0.1));
        assert!(compared(1e-3, 0.1).is_at_most(100.0));
        assert!(!compared(1e-3, 0.11).is_at_most(100.0));
    }

    #[test]
    fn rounding_needs_not_be_told() {
        assert!(Compared { truth: 0.9e-13, told: None, until_s: 1.0 }.is_at_least(0.1));
        assert!(compared(0.0, 0.9e-13).is_at_most(100.0));
        assert!(!compared(0.0, 1e-9).is_at_most(100.0));
    }
}

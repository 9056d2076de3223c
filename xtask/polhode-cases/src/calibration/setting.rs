//! The same scene by other methods: in each tier, at the tightest, and at steps that share nothing.

use polhode::Scene;
use polhode::scene::{ImpactLaw, Method, Tier};
use std::error::Error;

/// Tiers that are compared with closed forms; the tier `penalty` has a law of its own.
pub(super) const ALL_TIERS: [Tier; 5] =
    [Tier::Accurate, Tier::Stepped, Tier::Fast, Tier::Thesis, Tier::MicroCollisions];
/// Step of the tier `stepped`, s.
pub(super) const STEPPED_S: f64 = 0.002;
/// Tolerance of a run that stands for the truth.
const TIGHTEST: f64 = 1e-13;
/// Its longest step, and that of the run that shows how well it is known, s.
const TIGHTEST_S: f64 = 0.003;
const BESIDE_S: f64 = 0.0017;
/// Samples of a run.
const SAMPLES: f64 = 40.0;

/// What of a method is a law of the scene, whatever the tier.
fn laws(method: &Method) -> Method {
    Method {
        impact: method.impact,
        pulse_exponent: method.pulse_exponent,
        propagation_order: method.propagation_order,
        restitution_law: method.restitution_law,
        ..Method::default()
    }
}

/// The tier of a scene: the one that it names, or that whose response it names.
pub(super) fn tier_of(scene: &Scene) -> Tier {
    let method = scene.method();
    let of_response =
        || Tier::ALL.into_iter().find(|tier| method.response.is_some_and(|own| tier.facts().own_response == Some(own)));
    method.tier.or_else(of_response).unwrap_or_default()
}

/// The scene as a tier runs it: as it is if that is its own, else with nothing but its laws. A step (s) is that of the
/// tier `stepped`.
pub(super) fn in_tier(scene: &Scene, tier: Tier, step_s: Option<f64>) -> Scene {
    if tier_of(scene) == tier && (tier != Tier::Stepped || scene.method().step_s.is_some()) {
        return scene.clone();
    }
    let step_s = (tier == Tier::Stepped).then(|| step_s.unwrap_or(STEPPED_S));
    scene.clone().with_method(Method { tier: Some(tier), step_s, ..laws(scene.method()) })
}

/// The law of impacts that a tier takes for a scene.
pub(super) fn law_of(scene: &Scene, tier: Tier) -> ImpactLaw {
    scene.method().impact.unwrap_or(tier.facts().impact)
}

/// Which of the two runs that stand for the truth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Standard {
    /// The truth.
    Truth,
    /// The one that shows how well it is known.
    Beside,
}

/// The scene as the tier `accurate` runs it at its tightest, by this law of impacts.
pub(super) fn tightest(scene: &Scene, law: ImpactLaw, standard: Standard) -> Scene {
    let step_s = if standard == Standard::Truth { TIGHTEST_S } else { BESIDE_S };
    let method = Method {
        tier: Some(Tier::Accurate),
        tolerance: Some(TIGHTEST),
        step_s: Some(step_s),
        impact: Some(law),
        ..laws(scene.method())
    };
    scene.clone().with_method(method)
}

/// The scene, ended at the latest after so long, s.
///
/// # Errors
/// When the scene refuses it.
pub(super) fn for_so_long(scene: Scene, most_s: f64) -> Result<Scene, Box<dyn Error>> {
    let duration_s = scene.duration_s().min(most_s);
    Ok(scene.with_duration(duration_s)?)
}

/// The scene with samples to compare.
///
/// # Errors
/// When the scene refuses them.
pub(super) fn sampled(scene: Scene) -> Result<Scene, Box<dyn Error>> {
    let interval_s = scene.duration_s() / SAMPLES;
    Ok(scene.with_output_interval(interval_s)?)
}

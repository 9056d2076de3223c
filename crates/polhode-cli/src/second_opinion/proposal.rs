//! By which method a run is repeated, and in which setting of its scene.
//!
//! | the run was by | it is repeated by |
//! |---|---|
//! | the most accurate tier | the same tier in the scene turned, mirrored and with its bodies in the opposite order, |
//! | | by another integrator and with other steps |
//! | the tier of springs | the same springs by another integrator, in the scene set otherwise likewise |
//! | any other tier | the most accurate tier at its own tolerance |
//!
//! A law of contact or of impact that the scene names stays: another law is another scene, and no error. What is
//! refused gives way to the next proposal: not mirrored, then in the order of the scene, then by the integrator of the
//! plan.

use polhode::scene::{CopyError, Integrator, ListOrder, Method, Response, SceneCopy, Tier};
use polhode::spatial::{DVec3, Handedness, Isometry, Rotation};
use polhode::{RunReport, Scene};

/// The rotation vector by which a scene is turned, rad: along no axis and by no part of a turn.
const TURN: DVec3 = DVec3::new(0.61, -1.13, 0.37);

/// The longest step of the second run, as a part of that of the first (no unit): no whole number of one fits the other.
const STEP_PART: f64 = 0.37;

/// Angle by which the fastest spring swings in a step of fixed length, rad: the error of fourth order is some 1e-6 of
/// a swing.
const SWING_OF_A_STEP: f64 = 0.1;

/// How a run may be repeated.
#[derive(Debug)]
pub(super) struct Proposal {
    /// The scene with its method, set otherwise.
    pub(super) scene: Scene,
    /// How it is set.
    pub(super) copy: SceneCopy,
    /// What is done, in words.
    pub(super) told: String,
}

/// Whether no tier is more accurate.
pub(super) fn is_most_accurate(tier: Tier) -> bool {
    tier == Tier::default()
}

/// All ways in which a run may be repeated, the best first, and why one cannot be had.
pub(super) fn all(scene: &Scene, report: &RunReport) -> Vec<Result<Proposal, CopyError>> {
    let plan = &report.plan;
    let has_springs = plan.response == Response::Penalty;
    if !has_springs && !is_most_accurate(plan.tier) {
        return vec![Ok(by_most_accurate(scene))];
    }
    let own = Method { orientation: None, rotation_rate: None, coordinates: None, ..scene.method().clone() };
    let own = Method { tier: Some(plan.tier), ..own };
    let other = if has_springs { by_other_springs(&own, report) } else { by_other_steps(&own, scene, report) };
    let same = Method { integrator: None, step_s: Some(other_step(report)), ..own };
    let settings = [
        (Handedness::Mirrored, ListOrder::Reversed),
        (Handedness::Kept, ListOrder::Reversed),
        (Handedness::Mirrored, ListOrder::Kept),
        (Handedness::Kept, ListOrder::Kept),
    ];
    let with_each = |method: Method| settings.map(|(handedness, order)| (method.clone(), handedness, order));
    let propose = |(method, handedness, order): (Method, Handedness, ListOrder)| {
        let space = Isometry::new(Rotation::from_rotation_vector(TURN), DVec3::ZERO, handedness);
        let copy = SceneCopy::new(space, order);
        let told = told(&copy, &method, report);
        copy.of(&scene.clone().with_method(method)).map(|scene| Proposal { scene, copy, told })
    };
    [other, same].into_iter().flat_map(with_each).map(propose).collect()
}

/// The scene by the most accurate tier, with the laws that it names and nothing else of its method.
fn by_most_accurate(scene: &Scene) -> Proposal {
    let own = scene.method();
    let method = Method {
        tier: Some(Tier::default()),
        impact: own.impact,
        propagation_order: own.propagation_order,
        pulse_exponent: own.pulse_exponent,
        restitution_law: own.restitution_law,
        ..Method::default()
    };
    let told = format!("tier {}", Tier::default().name());
    Proposal { scene: scene.clone().with_method(method), copy: SceneCopy::default(), told }
}

/// Free motion by another integrator, held motion with other steps, both at the default tolerance.
fn by_other_steps(own: &Method, scene: &Scene, report: &RunReport) -> Method {
    let integrator = match report.plan.integrator {
        // It is the only one with error control that solves for joints.
        Integrator::Dop853 if !scene.joints().is_empty() => None,
        Integrator::Dop853 => Some(Integrator::ExactAdaptive),
        _ => Some(Integrator::Dop853),
    };
    Method { integrator, step_s: Some(other_step(report)), tolerance: None, crowding_tolerance: None, ..own.clone() }
}

/// The longest step of another run.
fn other_step(report: &RunReport) -> f64 {
    STEP_PART * report.plan.step_s
}

/// The springs by another integrator: by steps that are short against the swing of the fastest, or under error control.
fn by_other_springs(own: &Method, report: &RunReport) -> Method {
    let fastest_rad_s = report.springs.as_ref().map_or(0.0, |springs| springs.fastest_rad_s);
    match report.plan.integrator {
        Integrator::Dop853 => {
            // Where nothing has touched the quotient is infinite.
            let step_s = Some(other_step(report).min(SWING_OF_A_STEP / fastest_rad_s));
            Method { integrator: Some(Integrator::Rk4), step_s, ..own.clone() }
        }
        _ => Method { integrator: Some(Integrator::Dop853), step_s: None, tolerance: None, ..own.clone() },
    }
}

/// What a proposal does, in words.
fn told(copy: &SceneCopy, method: &Method, report: &RunReport) -> String {
    let plan = &report.plan;
    let mut parts = vec![format!("tier {}", plan.tier.name()), "the scene turned".to_owned()];
    if copy.space().handedness() == Handedness::Mirrored {
        parts.push("mirrored".to_owned());
    }
    if copy.order() == ListOrder::Reversed {
        parts.push("its bodies, joints and forces in the opposite order".to_owned());
    }
    if let Some(integrator) = method.integrator {
        parts.push(format!("integrator {} in the place of {}", integrator.name(), plan.integrator.name()));
    }
    if let Some(step_s) = method.step_s {
        parts.push(format!("steps of at most {} s in the place of {} s", crate::text::number(step_s), plan.step_s));
    }
    parts.join(", ")
}

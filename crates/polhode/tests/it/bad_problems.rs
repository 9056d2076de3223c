//! A problem that has no answer ends a run by a typed error with the names of the bodies: forces of a program that
//! become no number (in every tier), joints that contradict each other, bodies with hardly any inertia.

use crate::checks::particle;
use crate::support::{brick, floor};
use polhode::dynamics::field::{Account, Dependence, Field, Wrench};
use polhode::dynamics::{BodyState, RigidBody};
use polhode::scene::{Force, Joint, Method, PrescribedMotion, Tier};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, UnitVector, Velocity};
use polhode::tier::TierFeature;
use polhode::{Body, Scene, SceneBuilder, Simulation, SimulationError};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// A force of a program along z on the second body that forces move, from a time on.
#[derive(Debug)]
struct From {
    start_s: f64,
    force_n: f64,
}

impl Field for From {
    fn dependence(&self) -> Dependence {
        Dependence::PosesAndTime
    }

    fn account(&self) -> Account {
        Account::External
    }

    fn couples(&self) -> bool {
        false
    }

    fn add_wrenches(&self, t: f64, _bodies: &[RigidBody], _states: &[BodyState], wrenches: &mut [Wrench]) {
        if let Some(wrench) = wrenches.get_mut(1).filter(|_| t > self.start_s) {
            wrench.force.z += self.force_n;
        }
    }

    fn potential_energy(&self, _bodies: &[RigidBody], _states: &[BodyState]) -> f64 {
        0.0
    }
}

fn in_tier(tier: Tier) -> SceneBuilder {
    Scene::builder("bad").method(Method { tier: Some(tier), ..Method::default() }).duration_s(0.2)
}

fn end_of(scene: SceneBuilder) -> Result<(), SimulationError> {
    Simulation::new(&scene.build().unwrap())?.run().map(|_| ())
}

/// Two boxes that rest apart on a floor.
fn resting(tier: Tier) -> SceneBuilder {
    let [one, two] = [("one", -3.0), ("two", 3.0)].map(|(name, x)| brick(name, DVec3::ONE, DVec3::new(x, 0.0, 0.5)));
    in_tier(tier).body(floor()).body(one).body(two)
}

/// A body in flight, and one on a hinge.
fn hinged(tier: Tier) -> SceneBuilder {
    let mut scene = in_tier(tier);
    scene.add_body(particle("one", 1.0, DVec3::X * 4.0, DVec3::ZERO));
    let two = scene.add_body(particle("two", 1.0, DVec3::ZERO, DVec3::ZERO));
    scene.joint(Joint::hinge(two, DVec3::X, UnitVector::Y))
}

/// A force of a program that becomes no number within the run, on a body at rest and on one in a joint: the error names
/// the body and the force. (In tier `stepped` the body at rest lost it, and the run completed; elsewhere errors said
/// that a constant term was not finite, or a step too short.)
#[test]
fn a_force_that_becomes_no_number_names_force_and_body() {
    for tier in Tier::ALL {
        let jointed = tier.facts().takes(TierFeature::Joints).then(|| hinged(tier));
        for scene in [resting(tier)].into_iter().chain(jointed) {
            for force_n in [f64::NAN, f64::INFINITY] {
                let error = end_of(scene.clone().force(Force::Field(Arc::new(From { start_s: 0.05, force_n }))));
                let error = error.unwrap_err();
                let SimulationError::ForceNotFinite { t_s, body, force } = &error else {
                    panic!("{tier:?}: {force_n} N: {error}");
                };
                assert!(*t_s > 0.05 && *t_s < 0.1, "{tier:?}: {t_s}");
                assert_eq!((body.as_str(), error.bodies()), ("two", vec!["two"]), "{tier:?}");
                assert!(force.contains("number 0"), "{force}");
            }
        }
    }
}

/// A force whose square is no number is told as one that grows without bound.
#[test]
fn a_force_that_overflows_names_force_and_body() {
    for tier in Tier::ALL {
        let error = end_of(resting(tier).force(Force::Field(Arc::new(From { start_s: 0.05, force_n: 1e308 }))));
        let error = error.unwrap_err();
        assert!(matches!(error, SimulationError::SingularForce { .. }), "{tier:?}: {error}");
        assert_eq!(error.bodies(), ["two"], "{tier:?}: {error}");
    }
}

/// A body that joints hold to two kinematic bodies which move apart: no motion keeps both joints. (The run went on with
/// a joint open by the way between them.)
#[test]
fn joints_that_contradict_each_other_name_their_bodies() {
    for tier in [Tier::Accurate, Tier::Stepped] {
        let mut scene = in_tier(tier).gravity(DVec3::ZERO);
        let moving = |name: &str, amplitude: f64| {
            let motion = PrescribedMotion::sine(DVec3::X * amplitude, DVec3::ZERO, 1.0, FRAC_PI_2);
            Body::kinematic(name, motion.unwrap())
        };
        let [left, right] = [("left", 0.1), ("right", -0.1)].map(|(name, to)| scene.add_body(moving(name, to)));
        let middle = scene.add_body(particle("middle", 1.0, DVec3::ZERO, DVec3::ZERO));
        let scene = scene.joint(Joint::ball(middle, DVec3::X).with(right));
        // One joint alone asks for nothing that cannot be.
        end_of(scene.clone()).unwrap();
        let error = end_of(scene.joint(Joint::ball(middle, -DVec3::X).with(left))).unwrap_err();
        assert!(matches!(error, SimulationError::JointsContradict { .. }), "{error}");
        let bodies = error.bodies();
        assert!(bodies.contains(&"middle") && (bodies.contains(&"left") || bodies.contains(&"right")), "{error}");
        assert!(error.cure().is_some());
    }
}

/// Two kinematic bodies that move alike carry one between them.
#[test]
fn joints_with_bodies_that_move_alike_do_not_contradict() {
    for tier in [Tier::Accurate, Tier::Stepped] {
        let mut scene = in_tier(tier).gravity(DVec3::ZERO);
        let motion = || PrescribedMotion::sine(DVec3::X * 0.1, DVec3::ZERO, 1.0, FRAC_PI_2).unwrap();
        let [left, right] = ["left", "right"].map(|name| scene.add_body(Body::kinematic(name, motion())));
        let middle = scene.add_body(particle("middle", 1.0, DVec3::ZERO, DVec3::ZERO));
        let scene = scene.joint(Joint::ball(middle, DVec3::X).with(right));
        end_of(scene.joint(Joint::ball(middle, -DVec3::X).with(left))).unwrap();
    }
}

/// A mass without inertia is refused where it is made; one with hardly any, on a hinge, is named by the error.
#[test]
fn a_body_with_hardly_any_inertia_is_named() {
    assert!(Mass::new(0.0).is_err() && Inertia::from_diagonal(DVec3::new(0.0, 1.0, 1.0)).is_err());
    let inertia = Inertia::from_diagonal(DVec3::splat(1e-300)).unwrap();
    let mut scene = in_tier(Tier::Accurate);
    let thin =
        scene.add_body(Body::movable("thin", MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia)));
    let error = end_of(scene.joint(Joint::hinge(thin, DVec3::X, UnitVector::Y))).unwrap_err();
    assert_eq!(error.bodies(), ["thin"], "{error}");
    assert!(error.to_string().contains("thin"), "{error}");
}

/// A body that turns so fast that its rates overflow: the error of the problem of its joint names it.
#[test]
fn a_problem_that_overflows_names_its_bodies() {
    for tier in [Tier::Accurate, Tier::Stepped] {
        let mut scene = in_tier(tier);
        let spin = Velocity::new(DVec3::Z * 1e200, DVec3::Y * 1e200);
        let two = scene.add_body(particle("two", 1.0, DVec3::ZERO, DVec3::ZERO).velocity(spin));
        let error = end_of(scene.joint(Joint::hinge(two, DVec3::X, UnitVector::Y))).unwrap_err();
        assert_eq!(error.bodies(), ["two"], "{tier:?}: {error}");
    }
}

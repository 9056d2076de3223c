//! Planar motion of some bodies of a scene. Which bodies move in a plane is decided by them and by what they touch: a
//! joint, a motion or a tumbling body elsewhere changes no bit of theirs. Where a body meets one that is not in its
//! plane, both go on in space, and with them all bodies that they touch: the motion is that of space.

use crate::support::{accurate, ball, run};
use polhode::contact::Shape;
use polhode::scene::{Joint, Material, Method, Tier};
use polhode::spatial::{DVec3, Mass, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Decision, Effect, Effects, RunReport, Scene, SceneBuilder, Simulation};

const DURATION_S: f64 = 0.8;

fn is_planar(report: &RunReport) -> bool {
    let planar = report.plan.effects.iter().find(|effect| effect.effect == Effect::PlanarMotion);
    planar.is_some_and(|effect| effect.decision == Decision::On)
}

fn rough(friction: f64) -> Material {
    Material::new("rough").with_friction(friction).unwrap().with_restitution(0.2).unwrap()
}

fn brick(name: &str, place: DVec3, tip: f64) -> Body {
    let half = DVec3::new(0.2, 0.15, 0.1);
    let properties = polhode::mesh::solid_box(half * 2.0, Mass::new(2.0).unwrap()).unwrap();
    Body::movable(name, properties)
        .geometry(Shape::cuboid(half).unwrap().into())
        .pose(Pose::new(Rotation::from_rotation_vector(DVec3::Y * tip), place))
}

/// A tipped box that falls on another one, on a floor.
fn pile(method: Method, friction: f64) -> SceneBuilder {
    let material = rough(friction);
    Scene::builder("pile")
        .method(method)
        .gravity(DVec3::NEG_Z * 9.81)
        .duration_s(DURATION_S)
        .body(Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into()).material(material.clone()))
        .body(brick("lower", DVec3::new(0.0, 0.0, 0.1), 0.0).material(material.clone()))
        .body(brick("upper", DVec3::new(0.15, 0.0, 0.5), 0.3).material(material))
}

/// The same with a pendulum, a tumbling brick and a leaning block, all far away.
fn with_others(pile: SceneBuilder) -> SceneBuilder {
    let far = DVec3::new(300.0, 40.0, 2.0);
    let tumbling = Velocity::new(DVec3::new(0.3, 0.2, 1.0), DVec3::new(1.0, 2.0, 3.0));
    let lean = Rotation::from_rotation_vector(DVec3::new(0.3, 0.4, 0.5));
    let mut pile = pile;
    let bob = pile.add_body(ball("bob", 1.0, 0.1, far, DVec3::ZERO));
    pile.joint(Joint::ball(bob, far + DVec3::new(0.5, 0.3, 0.6)))
        .body(brick("tumbling", far + DVec3::Y * 9.0, 0.1).velocity(tumbling))
        .body(
            Body::fixed("block").geometry(Shape::cuboid(DVec3::splat(0.3)).unwrap().into()).pose(Pose::new(lean, -far)),
        )
}

fn stepped() -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(0.005), ..Method::default() }
}

/// The bits of the poses of the first two movable bodies at the end.
fn bits(scene: &SceneBuilder) -> Vec<u64> {
    let mut simulation = Simulation::new(&scene.clone().build().unwrap()).unwrap();
    simulation.run().unwrap();
    let poses = [1, 2].map(|body| simulation.body(polhode::BodyId::new(body)).pose);
    let numbers = |pose: &Pose| [pose.translation.to_array().to_vec(), pose.rotation.to_wxyz().to_vec()].concat();
    poses.iter().flat_map(numbers).map(f64::to_bits).collect()
}

#[test]
fn a_joint_far_away_changes_no_bit_of_a_pile() {
    for (method, friction) in [(accurate(), 0.5), (accurate(), 0.0), (stepped(), 0.5), (stepped(), 0.0)] {
        let alone = pile(method.clone(), friction);
        let others = with_others(pile(method.clone(), friction));
        let (planned, _) = run(&others.clone().build().unwrap(), Effects::Planned);
        let may_be_planar = method.tier != Some(Tier::Stepped) || friction == 0.0;
        assert_eq!(is_planar(&planned), may_be_planar, "{:?}", planned.plan.effects);
        assert_eq!(bits(&alone), bits(&others), "{method:?}, friction {friction}");
    }
}

/// A ball flies across the plane into the upper of two bricks of a pile.
fn struck_pile(method: Method, friction: f64) -> SceneBuilder {
    let aim = DVec3::new(0.2, -0.6, 0.35);
    pile(method, friction)
        .duration_s(0.5)
        .body(ball("ball", 0.7, 0.05, aim, DVec3::new(0.0, 3.0, 0.5)).material(rough(friction)))
}

#[test]
fn a_pile_that_a_ball_strikes_from_the_side_leaves_its_plane_as_in_space() {
    for friction in [0.0, 0.4] {
        let scene = struck_pile(accurate(), friction).build().unwrap();
        let (planned, _) = run(&scene, Effects::Planned);
        let (all, _) = run(&scene, Effects::All);
        assert!(!is_planar(&planned) && !planned.plan_changes.is_empty(), "{:?}", planned.plan.effects);
        let aside = planned.bodies[2].state.pose.translation.y;
        assert!(aside.abs() > 1e-2, "{aside}: the ball has pushed nothing");
        // Each impact magnifies rounding.
        for (a, b) in planned.bodies.iter().zip(&all.bodies) {
            let apart = (a.state.pose.translation - b.state.pose.translation).length();
            assert!(apart < 1e-9, "friction {friction}: {} is {apart:e} m apart", a.name);
        }
    }
}

/// In time steps the two motions agree as far as steps of that length are exact.
#[test]
fn a_pile_in_time_steps_leaves_its_plane_as_in_space() {
    let scene = struck_pile(stepped(), 0.0).build().unwrap();
    let (planned, _) = run(&scene, Effects::Planned);
    let (all, _) = run(&scene, Effects::All);
    assert!(!is_planar(&planned) && !planned.plan_changes.is_empty(), "{:?}", planned.plan.effects);
    for (a, b) in planned.bodies.iter().zip(&all.bodies) {
        let apart = (a.state.pose.translation - b.state.pose.translation).length();
        assert!(apart < 1e-6, "{} is {apart:e} m apart", a.name);
    }
}

/// A snapshot knows which bodies have left the plane.
#[test]
fn a_snapshot_after_the_plane_was_left_goes_on_with_the_same_bits() {
    for method in [accurate(), stepped()] {
        let scene = struck_pile(method, 0.0).build().unwrap();
        let mut whole = Simulation::new(&scene).unwrap();
        let mut snapshots = Vec::new();
        for stop_s in [0.05, 0.3] {
            whole.advance_to(stop_s).unwrap();
            snapshots.push(whole.snapshot());
        }
        whole.advance_to(0.5).unwrap();
        for snapshot in &snapshots {
            let mut restored = Simulation::new(&scene).unwrap();
            restored.restore(snapshot).unwrap();
            restored.advance_to(0.5).unwrap();
            for body in [1, 2, 3].map(polhode::BodyId::new) {
                assert_eq!(whole.body(body).pose, restored.body(body).pose);
            }
        }
    }
}

/// An action on a body elsewhere changes no bit of a pile.
#[test]
fn an_action_far_away_changes_no_bit_of_a_pile() {
    let scene = with_others(pile(accurate(), 0.5)).build().unwrap();
    let end = |act: fn(&mut Simulation)| {
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(0.2).unwrap();
        act(&mut simulation);
        simulation.advance_to(DURATION_S).unwrap();
        [1, 2].map(|body| simulation.body(polhode::BodyId::new(body)).pose)
    };
    let untouched = end(|_| ());
    let pushed = end(|simulation| {
        let body = simulation.body_id("tumbling").unwrap();
        simulation.apply_impulse(body, DVec3::new(0.1, 0.2, 0.3), DVec3::ZERO).unwrap();
    });
    assert_eq!(untouched, pushed);
}

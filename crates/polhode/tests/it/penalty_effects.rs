//! Springs at contacts beside what else a scene may ask for: joints, rolling friction, a grain, and faces that touch
//! side by side.

use polhode::contact::Shape;
use polhode::mesh::{solid_box, solid_sphere};
use polhode::scene::{
    FrictionEllipse, Joint, JointKind, Material, Method, PenaltyMethod, Response, SceneError, SpringDamping,
    SpringFriction, Tier,
};
use polhode::spatial::{DVec3, Mass, Pose, UnitVector, Velocity};
use polhode::{Body, BodyId, BodySample, RunReport, Scene, SceneBuilder, Simulation};

const GRAVITY: f64 = 9.81;

fn springs(penalty: PenaltyMethod) -> Method {
    Method { response: Some(Response::Penalty), tolerance: Some(1e-10), penalty: Some(penalty), ..Method::default() }
}

fn rigid() -> Method {
    Method { tier: Some(Tier::Accurate), ..Method::default() }
}

fn run(scene: SceneBuilder) -> RunReport {
    let report = Simulation::new(&scene.build().unwrap()).unwrap().run().unwrap();
    let closure = report.ledger.closure_relative();
    assert!(closure < 1e-12, "the ledger closes to {closure:e}");
    report
}

fn block(name: &str, size: DVec3, place: DVec3) -> Body {
    Body::movable(name, solid_box(size, Mass::new(1.0).unwrap()).unwrap())
        .geometry(Shape::cuboid(size).unwrap().into())
        .pose(Pose::from_translation(place))
}

fn floor(material: &Material) -> Body {
    Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into()).material(material.clone())
}

fn state(report: &RunReport, body: usize) -> BodySample {
    report.bodies[body].state
}

/// Joints are rigid: bodies that springs do not touch move as those of the tier `accurate`, joint by joint.
#[test]
fn joints_hold_as_rigid_ones() {
    let bar = DVec3::new(0.1, 0.2, 1.0);
    let joints = [
        JointKind::Ball,
        JointKind::Hinge { axis: UnitVector::X },
        JointKind::Fixed,
        JointKind::Slider { axis: UnitVector::X },
    ];
    for kind in joints {
        let scene = |method: Method| {
            let [upper, lower] = [("upper", -0.5), ("lower", -1.5)].map(|(name, z)| block(name, bar, DVec3::Z * z));
            let swing = Velocity::new(DVec3::Y * -0.5, DVec3::X * -1.0);
            let second = Velocity::new(DVec3::Y * -1.5, DVec3::X * -1.0);
            let between = Joint::new(kind, BodyId::new(1), DVec3::Z * -1.0).with(BodyId::new(0));
            let scene = Scene::builder("double pendulum").method(method).duration_s(1.0);
            scene
                .body(upper.velocity(swing))
                .body(lower.velocity(second))
                .joint(Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::X))
                .joint(between)
        };
        let [sprung, held] = [scene(springs(PenaltyMethod::default())), scene(rigid())].map(run);
        for body in 0..2 {
            let [one, other] = [&sprung, &held].map(|report| state(report, body));
            let apart = (one.pose.translation - other.pose.translation).length();
            assert!(apart < 1e-7, "{kind:?}: body {body} is {apart:e} m away");
        }
    }
}

/// A pendulum of small swing has the period `2 pi sqrt(I/(m g l))`, above a floor that it does not reach.
#[test]
fn a_pendulum_has_the_period_of_its_joint() {
    let size = DVec3::new(0.1, 0.1, 1.0);
    let inertia = (0.01 + 1.0) / 12.0 + 0.25;
    let period = 2.0 * std::f64::consts::PI * (inertia / (GRAVITY * 0.5)).sqrt();
    let rate = 1e-4;
    let own = block("rod", size, DVec3::Z * 0.6).velocity(Velocity::new(DVec3::Y * (0.5 * rate), DVec3::X * rate));
    let scene = Scene::builder("pendulum").method(springs(PenaltyMethod::default())).duration_s(period);
    let scene = scene.body(own).body(floor(&Material::new("smooth")));
    let report = run(scene.joint(Joint::ball(BodyId::new(0), DVec3::Z * 1.1)));
    let end = state(&report, 0);
    assert!((end.velocity.angular.x / rate - 1.0).abs() < 1e-6, "{:?}", end.velocity);
    assert!(end.pose.translation.y.abs() < 1e-6 * rate, "{:?}", end.pose);
}

/// A ball that rolls is slowed by `(5/7) c g/R`, where friction of rolling has the length c.
#[test]
fn rolling_friction_slows_a_ball() {
    let (radius, length, speed, duration) = (0.1, 2e-3, 1.0, 2.0);
    let felt = Material::new("felt").with_friction(0.5).unwrap().with_rotational_friction(length, 0.0).unwrap();
    for friction in [SpringFriction::Mindlin, SpringFriction::Regularised] {
        let own = Body::movable("ball", solid_sphere(radius, Mass::new(1.0).unwrap()).unwrap())
            .geometry(Shape::sphere(radius).unwrap().into())
            .material(felt.clone())
            .pose(Pose::from_translation(DVec3::Z * radius))
            .velocity(Velocity::new(DVec3::X * speed, DVec3::Y * (speed / radius)));
        let penalty = PenaltyMethod { friction: Some(friction), penetration_m: Some(1e-4), ..PenaltyMethod::default() };
        let scene = Scene::builder("rolling").method(springs(penalty)).duration_s(duration);
        let report = run(scene.body(floor(&felt)).body(own));
        let expected = speed - 5.0 / 7.0 * length * GRAVITY / radius * duration;
        let reached = state(&report, 1).velocity.linear.x;
        assert!((reached / expected - 1.0).abs() < 2e-3, "{friction:?}: {reached} instead of {expected}");
        assert!(report.ledger.friction.value() > 0.0);
    }
}

/// A ball that spins about the vertical is slowed by `5 c g/(2 R^2)`, where friction of spinning has the length c.
#[test]
fn spinning_friction_slows_a_ball() {
    let (radius, length, rate, duration) = (0.1, 1e-3, 10.0, 2.0);
    let felt = Material::new("felt").with_friction(0.5).unwrap().with_rotational_friction(0.0, length).unwrap();
    let own = Body::movable("ball", solid_sphere(radius, Mass::new(1.0).unwrap()).unwrap())
        .geometry(Shape::sphere(radius).unwrap().into())
        .material(felt.clone())
        .pose(Pose::from_translation(DVec3::Z * radius))
        .velocity(Velocity::new(DVec3::ZERO, DVec3::Z * rate));
    let penalty = PenaltyMethod { penetration_m: Some(1e-4), ..PenaltyMethod::default() };
    let scene = Scene::builder("spinning").method(springs(penalty)).duration_s(duration);
    let report = run(scene.body(floor(&felt)).body(own));
    let expected = rate - 2.5 * length * GRAVITY / (radius * radius) * duration;
    let reached = state(&report, 1).velocity.angular.z;
    assert!((reached / expected - 1.0).abs() < 2e-3, "{reached} instead of {expected}");
    assert!(report.ledger.friction.value() > 0.0);
}

/// A block on a belt gets `mu g t` until it goes with the belt, and the drive of the belt is in the ledger.
#[test]
fn a_belt_carries_a_block() {
    let rubber = Material::new("rubber").with_friction(0.5).unwrap();
    let speed = 1.0;
    for (duration, expected) in [(0.1, 0.5 * GRAVITY * 0.1), (0.6, speed)] {
        let penalty = PenaltyMethod { penetration_m: Some(1e-5), ..PenaltyMethod::default() };
        let scene = Scene::builder("belt").method(springs(penalty)).duration_s(duration);
        let belt = floor(&rubber).surface_velocity(DVec3::X * speed);
        let own = block("block", DVec3::new(0.4, 0.4, 0.02), DVec3::Z * 0.01).material(rubber.clone());
        let reached = state(&run(scene.body(belt).body(own)), 1).velocity.linear.x;
        assert!((reached / expected - 1.0).abs() < 5e-3, "{duration} s: {reached} instead of {expected}");
    }
}

/// With static friction above kinetic a block stays on a slope between both angles, and slides there by kinetic
/// friction once it does. Its weight comes at once, so that the spring along the slope bears up to twice its share at
/// first: the slope is less than half as steep as static friction holds.
#[test]
fn static_friction_holds_what_stands() {
    let (kinetic, at_rest, slope) = (0.1, 0.8, 0.25_f64);
    let rubber = Material::new("rubber").with_friction(kinetic).unwrap().with_static_friction(at_rest).unwrap();
    let down = DVec3::new(slope.sin(), 0.0, -slope.cos()) * GRAVITY;
    let end = |speed: f64| {
        let penalty = PenaltyMethod { penetration_m: Some(1e-5), ..PenaltyMethod::default() };
        let scene = Scene::builder("slope").method(springs(penalty)).gravity(down).duration_s(0.3);
        let own = block("block", DVec3::new(0.4, 0.4, 0.02), DVec3::Z * 0.01).material(rubber.clone());
        let own = own.velocity(Velocity::new(DVec3::X * speed, DVec3::ZERO));
        state(&run(scene.body(floor(&rubber)).body(own)), 1)
    };
    let stands = end(0.0);
    assert!(stands.pose.translation.x.abs() < 1e-4, "{:?}", stands.pose);
    let expected = 1.0 + (slope.sin() - kinetic * slope.cos()) * GRAVITY * 0.3;
    let slides = end(1.0).velocity.linear.x;
    assert!((slides / expected - 1.0).abs() < 5e-3, "{slides} instead of {expected}");
}

/// A block that slides across a grain goes where the tier `accurate` sends it, the nearer the slower the regularised
/// slip.
#[test]
fn a_grain_turns_a_slide() {
    let planks = Material::new("planks");
    let planks = planks.with_grain(DVec3::X, FrictionEllipse { along: 0.1, across: 0.3 }).unwrap();
    let size = DVec3::new(0.4, 0.4, 0.02);
    let slide = |method: Method| {
        let own = block("block", size, DVec3::Z * 0.01).material(Material::new("plain").with_friction(0.2).unwrap());
        let own = own.velocity(Velocity::new(DVec3::new(1.0, 1.0, 0.0), DVec3::ZERO));
        let scene = Scene::builder("planks").method(method).duration_s(0.3).body(floor(&planks)).body(own);
        state(&run(scene), 1).pose.translation
    };
    let held = slide(rigid());
    let error = |penetration: f64| {
        let penalty = PenaltyMethod {
            friction: Some(SpringFriction::Regularised),
            penetration_m: Some(penetration),
            slip_speed_m_s: Some(penetration),
            ..PenaltyMethod::default()
        };
        let apart = slide(springs(penalty)) - held;
        apart.x.hypot(apart.y)
    };
    let [soft, stiff] = [1e-3, 1e-4].map(error);
    assert!(stiff < 0.2 * soft && stiff < 1e-4, "{soft:e}, {stiff:e}");
}

/// Bricks that stand side by side under another one: their sides touch without load, and no step ends for that.
#[test]
fn sides_that_touch_end_no_steps() {
    for damping in [SpringDamping::HuntCrossley, SpringDamping::Plain] {
        let size = DVec3::new(1.0, 0.5, 0.25);
        let penalty = PenaltyMethod { damping: Some(damping), penetration_m: Some(1e-3), ..PenaltyMethod::default() };
        let method = Method { tolerance: Some(1e-8), ..springs(penalty) };
        let places = [(0.0, 0.125), (-0.5, 0.375), (0.5, 0.375), (-1.0, 0.625), (0.0, 0.625), (1.0, 0.625)];
        let bricks = places.into_iter().enumerate();
        let bricks = bricks.map(|(k, (x, z))| block(&format!("brick {k}"), size, DVec3::new(x, 0.0, z)));
        let scene = Scene::builder("bricks").method(method).duration_s(0.1).body(floor(&Material::new("ice")));
        let report = run(bricks.fold(scene, SceneBuilder::body));
        assert!(report.steps < 1000, "{damping:?}: {} steps", report.steps);
    }
}

/// What springs have not is refused: a spring along a grain, and a limit of a joint.
#[test]
fn refusals() {
    let planks = Material::new("planks").with_grain(DVec3::X, FrictionEllipse { along: 0.1, across: 0.3 }).unwrap();
    let penalty = PenaltyMethod { friction: Some(SpringFriction::Mindlin), ..PenaltyMethod::default() };
    let size = DVec3::splat(0.2);
    let scene = Scene::builder("refused").method(springs(penalty)).body(floor(&planks));
    let refused = scene
        .body(block("block", size, DVec3::Z).material(Material::new("plain").with_friction(0.2).unwrap()))
        .build()
        .unwrap_err();
    assert!(matches!(refused, SceneError::NotYetAvailable { .. }), "{refused}");
    for friction in [None, Some(SpringFriction::Regularised)] {
        let ice = match friction {
            None => planks.clone().with_static_ellipse(FrictionEllipse { along: 0.2, across: 0.3 }).unwrap(),
            Some(_) => Material::new("ice").with_friction(0.1).unwrap().with_static_friction(0.3).unwrap(),
        };
        let penalty = PenaltyMethod { friction, ..PenaltyMethod::default() };
        let scene = Scene::builder("refused").method(springs(penalty)).body(floor(&ice));
        let own = block("block", size, DVec3::Z).material(Material::new("plain").with_friction(0.1).unwrap());
        let refused = scene.body(own).build().unwrap_err();
        assert!(matches!(refused, SceneError::NotYetAvailable { .. }), "{refused}");
    }
    let rope = Joint::rope(BodyId::new(0), DVec3::Z, DVec3::Z * 2.0, 1.5).unwrap();
    let scene =
        Scene::builder("refused").method(springs(PenaltyMethod::default())).body(block("block", size, DVec3::Z));
    let refused = scene.joint(rope).build().unwrap_err();
    assert!(matches!(refused, SceneError::NotYetAvailable { .. }), "{refused}");
}

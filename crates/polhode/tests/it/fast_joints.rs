//! Joints in the tier `fast` obey mechanics to the order of its steps: pendulums keep their period, chains and linkages
//! hold together and gain no energy, limits stop and do not pull, a figure of jointed limbs comes to lie; what hangs at
//! rest bears its weight. The motion has the same bits for any number of threads and when it goes on from a snapshot.
//! What the tier does not take is refused by name.
//!
//! Oracles are closed forms (the period of a pendulum of any amplitude by the arithmetic-geometric mean) and
//! conservation of energy.

use crate::chains::chain;
use crate::checks::assert_closes;
use crate::joints::{down, inertia, rod};
use crate::snapshots::check_restored_runs;
use crate::support::{ball, brick, floor, run_even_degraded};
use crate::threads::check_threads;
use polhode::scene::{Coordinate, Drive, Freedom, Joint, JointKind, Limits, Material, Method, Motor, Strength, Tier};
use polhode::spatial::{DVec3, UnitVector};
use polhode::{BodyId, Effects, RunReport, Scene, SceneBuilder, Simulation};

const G: f64 = 9.81;

/// Length of a rod, m.
const LENGTH: f64 = 1.0;

pub(crate) fn fast(step_s: f64) -> Method {
    Method { tier: Some(Tier::Fast), step_s: Some(step_s), ..Method::default() }
}

pub(crate) fn run(scene: SceneBuilder) -> RunReport {
    let report = run_even_degraded(&scene.build().unwrap(), Effects::Planned).0;
    assert_closes(&report);
    report
}

/// The arithmetic-geometric mean.
fn agm(mut x: f64, mut y: f64) -> f64 {
    while (x - y).abs() > 1e-15 * x {
        (x, y) = (0.5 * (x + y), (x * y).sqrt());
    }
    x
}

/// Period of a pendulum of this inertia about its axis (kg m^2) and moment of weight (N m) that is let go at an angle
/// (rad), s.
fn period(inertia: f64, weight: f64, angle: f64) -> f64 {
    std::f64::consts::TAU * (inertia / weight).sqrt() / agm(1.0, (0.5 * angle).cos())
}

/// Inertia of a rod of this mass (kg) about its end, kg m^2.
fn about_end(mass: f64) -> f64 {
    inertia((mass, LENGTH)) + mass * 0.25 * LENGTH * LENGTH
}

/// A rod that is let go at an angle, at a hinge or a ball joint in the origin.
pub(crate) fn pendulum(joint: impl Fn(BodyId) -> Joint, angle: f64) -> SceneBuilder {
    let body = rod("rod", (2.0, LENGTH), down(angle) * (0.5 * LENGTH), angle);
    Scene::builder("pendulum").gravity(DVec3::Z * -G).body(body).joint(joint(BodyId::new(0)))
}

/// After a quarter of its period a pendulum is at its lowest point; how far it is from there falls at least with the
/// first power of the step.
#[test]
fn a_pendulum_keeps_its_period_to_the_order_of_the_step() {
    let angle = 1.0;
    let quarter = 0.25 * period(about_end(2.0), 2.0 * G * 0.5 * LENGTH, angle);
    let hinge = |body: BodyId| Joint::hinge(body, DVec3::ZERO, UnitVector::Y);
    let ball = |body: BodyId| Joint::ball(body, DVec3::ZERO);
    for joint in [&hinge as &dyn Fn(BodyId) -> Joint, &ball] {
        let errors: Vec<f64> = [24.0, 48.0, 96.0]
            .map(|steps| {
                let report = run(pendulum(joint, angle).method(fast(quarter / steps)).duration_s(quarter));
                assert!(report.certificate.max_joint_error_m.unwrap() < 2e-3, "{:?}", report.certificate);
                report.bodies[0].state.pose.translation.x.abs()
            })
            .to_vec();
        assert!(errors[0] < 0.02, "{errors:?}");
        assert!(errors[1] < 0.6 * errors[0] && errors[2] < 0.6 * errors[1], "{errors:?}");
    }
}

/// A pendulum that swings for ten seconds gains no energy.
#[test]
fn a_pendulum_gains_no_energy() {
    let hinge = |body: BodyId| Joint::hinge(body, DVec3::ZERO, UnitVector::Y);
    let report = run(pendulum(hinge, 1.5).method(fast(1.0 / 60.0)).duration_s(10.0));
    let change = report.energy.final_j - report.energy.initial_j;
    // The motion between the lowest and the highest point is worth 2 m g d.
    let scale = 2.0 * 2.0 * G * 0.5 * LENGTH;
    assert!(change < 0.01 * scale && change > -0.2 * scale, "{change} of {scale}: {:?}", report.ledger);
}

/// A parallelogram of two cranks and a coupler swings as a pendulum: the coupler does not turn.
#[test]
fn a_four_bar_keeps_its_period() {
    let (angle, span) = (0.8, 1.0);
    let [first, second] = [0.0, span].map(|x| DVec3::X * x);
    let arm = down(angle) * LENGTH;
    let quarter = 0.25 * period(2.0 * about_end(1.0) + LENGTH * LENGTH, G * LENGTH * (1.0 + 1.0), angle);
    let of = |steps: f64| {
        let mut scene = Scene::builder("four-bar").gravity(DVec3::Z * -G);
        for (name, place) in [("crank", first), ("rocker", second)] {
            scene = scene.body(rod(name, (1.0, LENGTH), place + arm * 0.5, angle));
        }
        // A rod along x hangs at a quarter of a turn.
        let coupler = rod("coupler", (1.0, span), first + arm + DVec3::X * (0.5 * span), std::f64::consts::FRAC_PI_2);
        let hinge = |body: usize, place: DVec3| Joint::hinge(BodyId::new(body), place, UnitVector::Y);
        scene = scene.body(coupler).joint(hinge(0, first)).joint(hinge(1, second));
        scene = scene.joint(hinge(0, first + arm).with(BodyId::new(2)));
        scene = scene.joint(hinge(1, second + arm).with(BodyId::new(2)));
        let report = run(scene.method(fast(quarter / steps)).duration_s(quarter));
        let coupler = &report.bodies[2].state.pose;
        assert!(report.certificate.max_joint_error_m.unwrap() < 5e-3, "{:?}", report.certificate);
        (coupler.translation.x - 0.5 * span).abs()
    };
    let [coarse, fine] = [of(32.0), of(64.0)];
    assert!(coarse < 0.03 && fine < 0.6 * coarse, "{coarse} {fine}");
}

/// A chain of twenty links that falls from the horizontal holds together: no joint opens by more than a twentieth of a
/// link, and no energy is made.
#[test]
fn a_chain_of_twenty_links_holds() {
    let links = [(1.0, 1.5); 20];
    let report = run(chain(Tier::Fast, &links, (1.0 / 240.0, 3.0)));
    let certificate = &report.certificate;
    assert!(certificate.max_joint_error_m.unwrap() < 5e-3, "{certificate:?}");
    let scale = 20.0 * G * 1.0;
    assert!(report.energy.final_j - report.energy.initial_j < 1e-3 * scale, "{:?}", report.energy);
}

/// Of what hangs at rest the joint bears the weight: the mean force of a step.
#[test]
fn a_joint_bears_what_hangs_at_it() {
    let scene = pendulum(|body| Joint::hinge(body, DVec3::ZERO, UnitVector::Y), 0.0).duration_s(2.0);
    let mut simulation = Simulation::new(&scene.method(fast(1.0 / 60.0)).build().unwrap()).unwrap();
    simulation.advance_to(1.0).unwrap();
    let loads = simulation.joint_loads();
    assert!((loads[0].force_n - DVec3::Z * (2.0 * G)).length() < 1e-6, "{loads:?}");
    assert!(loads[0].moment_n_m.length() < 1e-6, "{loads:?}");
}

/// A rod at a hinge with limits falls onto its limit and lies there; a stone at a rope falls freely until the rope is
/// taut.
#[test]
fn limits_stop_and_do_not_pull() {
    let limits = Limits::new(-0.5, 0.5).unwrap();
    let hinge = |body: BodyId| Joint::hinge(body, DVec3::ZERO, UnitVector::Y).with_limits(Coordinate::Angle, limits);
    let report = run(pendulum(hinge, 1.2).method(fast(1.0 / 240.0)).duration_s(3.0));
    let center = report.bodies[0].state.pose.translation * (2.0 / LENGTH);
    // It has turned by the limit, to one side.
    let turned = center.normalize().dot(down(1.2)).acos();
    assert!((turned - 0.5).abs() < 5e-3, "{turned} {center}");
    let stone = ball("stone", 1.0, 0.1, DVec3::Z * -0.5, DVec3::ZERO);
    let rope = Joint::rope(BodyId::new(0), DVec3::Z * -0.5, DVec3::ZERO, 1.5).unwrap();
    let scene = Scene::builder("rope").gravity(DVec3::Z * -G).method(fast(1.0 / 240.0)).body(stone).joint(rope);
    let free = run(scene.clone().duration_s(0.4));
    assert!((free.bodies[0].state.pose.translation.z + 0.5 + 0.5 * G * 0.16).abs() < 5e-3, "{:?}", free.bodies[0]);
    let taut = run(scene.duration_s(3.0));
    assert!((taut.bodies[0].state.pose.translation.z + 1.5).abs() < 5e-3, "{:?}", taut.bodies[0]);
}

/// A figure of a trunk, a head, arms and legs, jointed by balls and hinges with limits, above a floor.
fn ragdoll() -> SceneBuilder {
    let rough = || Material::new("rough").with_friction(0.6).unwrap();
    let mut scene = Scene::builder("ragdoll").method(fast(1.0 / 60.0)).duration_s(2.0).output_interval_s(0.5);
    scene = scene.body(floor().material(rough()));
    let limb = |name: &str, size: DVec3, at: DVec3| brick(name, size, at).material(rough());
    scene = scene.body(limb("trunk", DVec3::new(0.3, 0.2, 0.6), DVec3::Z * 1.6));
    scene = scene.body(ball("head", 0.5, 0.12, DVec3::Z * 2.05, DVec3::ZERO).material(rough()));
    scene = scene.joint(Joint::ball(BodyId::new(2), DVec3::Z * 1.92).with(BodyId::new(1)));
    let bend = Limits::new(0.0, 2.2).unwrap();
    let mut next = 3;
    for side in [-1.0, 1.0] {
        for (name, x, top, length) in [("arm", 0.21, 1.85, 0.3), ("leg", 0.1, 1.3, 0.4)] {
            let size = DVec3::new(0.1, 0.1, 0.9 * length);
            let place = |k: f64| DVec3::new(side * x, 0.0, top - length * k);
            scene = scene.body(limb(&format!("upper {name} {side}"), size, place(0.5)));
            scene = scene.body(limb(&format!("lower {name} {side}"), size, place(1.5)));
            let [upper, lower] = [next, next + 1].map(BodyId::new);
            scene = scene.joint(Joint::ball(upper, place(0.0)).with(BodyId::new(1)));
            let knee = Joint::hinge(lower, place(1.0), UnitVector::X).with(upper);
            scene = scene.joint(knee.with_limits(Coordinate::Angle, bend));
            next += 2;
        }
    }
    scene
}

/// It falls in a heap, its joints hold to a centimetre, and it lies on the floor; no energy is made.
#[test]
fn a_ragdoll_holds_together_and_lies() {
    let report = run(ragdoll().duration_s(4.0));
    let certificate = &report.certificate;
    assert!(certificate.max_joint_error_m.unwrap() < 0.01, "{certificate:?}");
    assert!(certificate.max_joint_error_rad.unwrap() < 0.1, "{certificate:?}");
    assert!(report.energy.final_j < report.energy.initial_j, "{:?}", report.energy);
    assert!(report.bodies[1].state.pose.translation.z < 0.8, "{:?}", report.bodies[1]);
    assert!(report.bodies[1].state.velocity.linear.length() < 0.5, "{:?}", report.bodies[1]);
}

/// A single fall shows little of how well joints hold where limbs hit the ground: it depends on the last bits. Of eight
/// figures, with steps that are alike, the median of the largest gap is within a sixth of what a limb at 4 m/s flies in
/// a step.
#[test]
fn joints_of_figures_that_fall_hold() {
    let gap = |figure: u32| {
        let step = (1.0 - 4e-3 * f64::from(figure)) / 60.0;
        run(ragdoll().method(fast(step)).duration_s(2.0)).certificate.max_joint_error_m.unwrap()
    };
    let mut gaps: Vec<f64> = (0..8).map(gap).collect();
    gaps.sort_by(f64::total_cmp);
    assert!(gaps[4] < 0.01, "{gaps:?}");
}

#[test]
fn threads_and_snapshots_change_no_bit() {
    let scene = ragdoll().duration_s(0.5).build().unwrap();
    check_threads(&scene);
    check_restored_runs(&scene, Effects::Planned);
}

/// What joints have beside what they hold is refused, with what is accepted.
#[test]
fn what_joints_have_besides_is_refused_by_name() {
    let hinge = |body: BodyId| Joint::hinge(body, DVec3::ZERO, UnitVector::Y);
    let refusal =
        |joint: &dyn Fn(BodyId) -> Joint| pendulum(joint, 0.5).method(fast(0.01)).build().unwrap_err().to_string();
    let motor = Freedom::default().with_motor(Motor::new(Drive::Effort(1.0)).unwrap());
    let bounces = Limits::new(-1.0, 1.0).unwrap().with_restitution(0.5).unwrap();
    let expected = [
        (refusal(&|body| hinge(body).along(Coordinate::Angle, motor)), "motor"),
        (refusal(&|body| hinge(body).with_limits(Coordinate::Angle, bounces)), "bounces"),
        (refusal(&|body| hinge(body).breaking_at(Strength::default().force(10.0).unwrap())), "strength"),
    ];
    for (message, what) in expected {
        assert!(message.contains(what) && message.contains("`stepped`"), "{message}");
    }
    let fixed = pendulum(|body| Joint::new(JointKind::Fixed, body, DVec3::ZERO), 0.5).method(fast(0.01)).build();
    assert!(fixed.is_ok(), "{fixed:?}");
}

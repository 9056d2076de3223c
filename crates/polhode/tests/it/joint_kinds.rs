//! Each kind of joint leaves free what it says, and nothing else: closed forms, and equations in the coordinates that
//! are free. All of them keep their bodies together to rounding and do no work.

use crate::checks::assert_closes;
use crate::support::{accurate, brick, run};
use polhode::dynamics::{Rk4, System};
use polhode::mesh::solid_box;
use polhode::scene::{Joint, JointKind, Method, SceneError, Tier};
use polhode::spatial::{DVec3, Mass, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, Effects, RunReport, Scene, SceneBuilder};

const G: f64 = 9.81;

fn unit(direction: DVec3) -> UnitVector {
    UnitVector::new(direction).unwrap()
}

/// A box of this mass.
fn heavy(name: &str, mass: f64, size: DVec3, center: DVec3) -> Body {
    Body::movable(name, solid_box(size, Mass::new(mass).unwrap()).unwrap()).pose(Pose::from_translation(center))
}

fn scene(name: &str) -> SceneBuilder {
    Scene::builder(name).method(accurate()).duration_s(0.8)
}

/// Runs a scene whose joints do no work.
#[track_caller]
fn held(builder: SceneBuilder) -> RunReport {
    let (report, _) = run(&builder.build().unwrap(), Effects::Planned);
    let scale = report.ledger.scale_j;
    assert!(report.ledger.numerical.value().abs() < 1e-11 * scale, "{:?}", report.ledger);
    assert!(report.ledger.projection.value().abs() < 1e-11 * scale, "{:?}", report.ledger);
    assert_closes(&report);
    report
}

/// A body on a slider falls along its axis by `g sin(slope) t^2/2`, without a rotation, although it hangs beside the
/// axis.
#[test]
fn slider_leaves_the_way_along_its_axis() {
    let axis = unit(DVec3::new(0.6, 0.48, -0.64));
    let body = brick("sledge", DVec3::new(0.2, 0.3, 0.1), DVec3::new(0.1, -0.2, 0.4));
    let report =
        held(scene("slider").body(body).joint(Joint::new(JointKind::Slider { axis }, BodyId::new(0), DVec3::ZERO)));
    let end = report.bodies[0].state;
    let fallen = axis.get() * (0.5 * 0.64 * G * report.duration_s * report.duration_s);
    assert!((end.pose.translation - DVec3::new(0.1, -0.2, 0.4) - fallen).length() < 1e-10);
    assert!(end.pose.rotation.to_rotation_vector().length() < 1e-11);
}

/// A body on a cylindrical joint falls along a vertical axis and goes on turning about it.
#[test]
fn cylindrical_joint_leaves_the_rotation_about_its_axis_and_the_way_along_it() {
    let rate = 5.0;
    let start = DVec3::new(0.3, 0.0, 0.0);
    let turning = DVec3::Z * rate;
    let body = brick("nut", DVec3::new(0.2, 0.3, 0.1), start).velocity(Velocity::new(turning.cross(start), turning));
    let axis = UnitVector::Z;
    let report =
        held(scene("nut").body(body).joint(Joint::new(JointKind::Cylindrical { axis }, BodyId::new(0), DVec3::ZERO)));
    let t = report.duration_s;
    let wanted = Rotation::from_rotation_vector(turning * t).rotate(start) - DVec3::Z * (0.5 * G * t * t);
    assert!((report.bodies[0].state.pose.translation - wanted).length() < 1e-10);
    assert!((report.bodies[0].state.velocity.angular - turning).length() < 1e-10);
}

/// A body in a sloping plane slides down it, and goes on turning about its normal; its centre is the point that slides.
#[test]
fn planar_joint_leaves_the_plane_and_the_rotation_about_its_normal() {
    let normal = unit(DVec3::new(0.6, 0.0, 0.8));
    let (turning, along) = (normal.get() * 4.0, DVec3::Y * 0.7);
    let body = brick("puck", DVec3::new(0.2, 0.3, 0.1), DVec3::ZERO).velocity(Velocity::new(along, turning));
    let report =
        held(scene("puck").body(body).joint(Joint::new(JointKind::Planar { normal }, BodyId::new(0), DVec3::ZERO)));
    let t = report.duration_s;
    let gravity = DVec3::Z * -G;
    let down = gravity - normal.get() * normal.get().dot(gravity);
    assert!((report.bodies[0].state.pose.translation - along * t - down * (0.5 * t * t)).length() < 1e-10);
    assert!((report.bodies[0].state.velocity.angular - turning).length() < 1e-10);
}

/// A bead that slides on an arm that turns freely: `r'' = r w^2`, and `(I + m r^2) w` stays.
struct TurningArm {
    /// Moment of inertia of the arm and of the bead about its own centre, kg m^2.
    inertia: f64,
    /// Of the bead, kg.
    mass: f64,
    /// kg m^2/s.
    momentum: f64,
}

impl System for TurningArm {
    type Error = std::convert::Infallible;

    fn dimension(&self) -> usize {
        3
    }

    fn derivative(&mut self, _t: f64, state: &[f64], rates: &mut [f64]) -> Result<(), Self::Error> {
        let turning = self.momentum / (self.inertia + self.mass * state[0] * state[0]);
        rates.copy_from_slice(&[state[1], state[0] * turning * turning, turning]);
        Ok(())
    }
}

/// The bead flies out along the arm that it slows down: centrifugal and Coriolis forces are those of a line that turns.
#[test]
fn slider_on_a_body_that_turns_bears_the_forces_of_its_rotation() {
    let (rate, start) = (6.0, 0.2);
    let (long, small) = (DVec3::new(1.0, 0.02, 0.02), DVec3::splat(0.04));
    let turning = DVec3::Z * rate;
    let center = DVec3::X * start;
    let scene = scene("bead on an arm")
        .gravity(DVec3::ZERO)
        .body(heavy("arm", 2.0, long, DVec3::ZERO).velocity(Velocity::new(DVec3::ZERO, turning)))
        .body(heavy("bead", 0.5, small, center).velocity(Velocity::new(turning.cross(center), turning)))
        .joint(Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::Z))
        .joint(Joint::new(JointKind::Slider { axis: UnitVector::X }, BodyId::new(1), center).with(BodyId::new(0)));
    let report = held(scene.duration_s(0.4));
    let (arm, own) = (2.0 / 12.0 * (1.0 + 4e-4), 0.5 / 6.0 * 0.0016);
    let momentum = (arm + own + 0.5 * start * start) * rate;
    let mut system = TurningArm { inertia: arm + own, mass: 0.5, momentum };
    let (steps, mut method, mut state) = (20_000, Rk4::new(3), vec![start, 0.0, 0.0]);
    let h = report.duration_s / f64::from(steps);
    for step in 0..steps {
        let Ok(()) = method.step(&mut system, h * f64::from(step), h, &mut state);
    }
    let wanted = DVec3::new(state[2].cos(), state[2].sin(), 0.0) * state[0];
    let found = report.bodies[1].state.pose.translation;
    assert!((found - wanted).length() < 1e-9, "{found:?} {wanted:?}");
}

/// Two shafts at an angle, each on a hinge, joined by a Cardan joint: `tan b = cos(angle) tan a`.
#[test]
fn universal_joint_turns_shafts_as_cardan_said() {
    let angle: f64 = 0.7;
    let other = DVec3::new(angle.cos(), 0.0, angle.sin());
    let second = DVec3::new(-angle.sin(), 0.0, angle.cos());
    let tilt = Rotation::from_rotation_vector(DVec3::Y * -angle);
    let (rate, size) = (3.0, DVec3::new(0.6, 0.1, 0.06));
    // At the start `b' = cos(angle) a'`.
    let one = heavy("one", 1.0, size, DVec3::X * -0.3).velocity(Velocity::new(DVec3::ZERO, DVec3::X * rate));
    let two = heavy("two", 1.0, size, DVec3::ZERO)
        .pose(Pose::new(tilt, other * 0.3))
        .velocity(Velocity::new(DVec3::ZERO, other * (rate * angle.cos())));
    let axes = [UnitVector::Y, unit(second)];
    let scene = scene("shafts")
        .gravity(DVec3::ZERO)
        .body(one)
        .body(two)
        .joint(Joint::hinge(BodyId::new(0), DVec3::ZERO, UnitVector::X))
        .joint(Joint::hinge(BodyId::new(1), DVec3::ZERO, unit(other)))
        .joint(Joint::new(JointKind::Universal { axes }, BodyId::new(0), DVec3::ZERO).with(BodyId::new(1)));
    let report = held(scene);
    let [one, two] = [report.bodies[0].state.pose.rotation, report.bodies[1].state.pose.rotation * tilt.inverse()];
    let turned = |rotation: Rotation, about: DVec3| {
        let vector = rotation.to_rotation_vector();
        assert!(vector.cross(about).length() < 1e-10, "{vector:?}");
        vector.dot(about)
    };
    let (a, b) = (turned(one, DVec3::X), turned(two, other));
    assert!(a.abs() > 1.0 && (b.tan() - angle.cos() * a.tan()).abs() < 1e-9 * (1.0 + a.tan().abs()), "{a} {b}");
}

/// Two halves of a box that a fixed joint holds together fly and tumble as the whole box.
#[test]
fn fixed_joint_makes_one_body_of_two() {
    let velocity = |center: DVec3| {
        let turning = DVec3::new(4.0, 0.3, -2.0);
        Velocity::new(DVec3::new(0.4, -0.2, 1.0) + turning.cross(center), turning)
    };
    let half =
        |name: &str, center: DVec3| heavy(name, 1.0, DVec3::new(0.3, 0.2, 0.1), center).velocity(velocity(center));
    let halves = scene("halves")
        .body(half("left", DVec3::X * -0.15))
        .body(half("right", DVec3::X * 0.15))
        .joint(Joint::new(JointKind::Fixed, BodyId::new(0), DVec3::new(0.02, 0.05, -0.01)).with(BodyId::new(1)));
    let two = held(halves);
    let whole = heavy("whole", 2.0, DVec3::new(0.6, 0.2, 0.1), DVec3::ZERO).velocity(velocity(DVec3::ZERO));
    let (one, _) = run(&scene("whole").body(whole).build().unwrap(), Effects::Planned);
    let whole = one.bodies[0].state.pose;
    for (body, center) in [DVec3::X * -0.15, DVec3::X * 0.15].into_iter().enumerate() {
        let found = two.bodies[body].state.pose;
        assert!((found.translation - whole.transform_point(center)).length() < 1e-9);
        let turn = (found.rotation * whole.rotation.inverse()).to_rotation_vector();
        assert!(turn.length() < 1e-9, "{turn:?}");
    }
}

/// Tier `stepped` takes every kind: a chain of all of them falls, holds together and does no work by its joints.
#[test]
fn a_chain_of_all_kinds_holds_in_both_tiers() {
    let kinds = [
        JointKind::Ball,
        JointKind::Hinge { axis: UnitVector::Y },
        JointKind::Universal { axes: [UnitVector::Y, UnitVector::Z] },
        JointKind::Fixed,
        JointKind::Slider { axis: UnitVector::X },
        JointKind::Cylindrical { axis: UnitVector::X },
        JointKind::Planar { normal: UnitVector::Z },
    ];
    for tier in [Tier::Accurate, Tier::Stepped] {
        let method = Method { tier: Some(tier), step_s: Some(2e-3), ..Method::default() };
        let mut builder = scene("chain of all kinds").method(method).duration_s(0.3);
        for (number, kind) in kinds.into_iter().enumerate() {
            let at = number as f64 * 0.2;
            let size = DVec3::new(0.18, 0.04, 0.03);
            builder = builder.body(heavy(&format!("link {number}"), 0.4, size, DVec3::X * (at + 0.1)));
            let joint = Joint::new(kind, BodyId::new(number), DVec3::X * at);
            builder = builder.joint(if number > 0 { joint.with(BodyId::new(number - 1)) } else { joint });
        }
        let (report, _) = run(&builder.build().unwrap(), Effects::Planned);
        assert!(report.ledger.impact.value().abs() < 1e-12 * report.ledger.scale_j, "{tier:?}: {:?}", report.ledger);
        assert!(report.ledger.numerical.value().abs() < 1e-10 * report.ledger.scale_j, "{tier:?}: {:?}", report.ledger);
        assert_closes(&report);
    }
}

/// Axes of a Cardan joint that are not at right angles are refused.
#[test]
fn axes_of_a_universal_joint_are_at_right_angles() {
    let axes = [UnitVector::X, unit(DVec3::new(0.1, 1.0, 0.0))];
    let body = brick("cross", DVec3::splat(0.1), DVec3::ZERO);
    let built =
        scene("skew").body(body).joint(Joint::new(JointKind::Universal { axes }, BodyId::new(0), DVec3::ZERO)).build();
    assert!(matches!(built, Err(SceneError::Joint { number: 0, .. })));
}

/// A nut on a screw that stands upright falls with `g/(1 + I/(m p^2))`, `p` the displacement for each radian, and turns
/// by its thread the way that its hand says, beyond revolutions too; its energy stays. In both tiers.
#[test]
fn a_nut_falls_on_a_screw() {
    for lead in [0.12, -0.05] {
        let pitch = lead / std::f64::consts::TAU;
        let nut = brick("nut", DVec3::new(0.3, 0.3, 0.1), DVec3::Z * 0.4);
        let properties = nut.mass_properties().unwrap();
        let (mass, moment) = (properties.mass(), properties.inertia().matrix().z_axis.z);
        let fall = 9.81 / (1.0 + moment / (mass * pitch * pitch));
        let step = Method { tier: Some(Tier::Stepped), step_s: Some(1e-3), ..Method::default() };
        for (method, allowed) in [(accurate(), 1e-11), (step, 1e-6)] {
            let kind = JointKind::Screw { axis: UnitVector::Z, lead };
            let built = Scene::builder("screw").method(method).gravity(DVec3::Z * -9.81).duration_s(4.0);
            let built = built.body(nut.clone()).joint(Joint::new(kind, BodyId::new(0), DVec3::ZERO)).build().unwrap();
            let (report, recorder) = run(&built, Effects::Planned);
            for (row, &t) in recorder.samples.iter().zip(&recorder.times_s) {
                let off = (row[0].pose.translation - DVec3::Z * (0.4 - 0.5 * fall * t * t)).length();
                assert!(off < allowed, "t = {t}: {off:e} m off");
                let spin = row[0].velocity.angular.z + fall * t / pitch;
                assert!(spin.abs() < allowed * 1e3, "t = {t}: {spin:e} rad/s off");
            }
            assert!(fall * 8.0 / pitch.abs() > 6.3, "it makes more than a revolution");
            assert_closes(&report);
        }
    }
}

//! Effects of friction besides sticking and sliding, against closed forms: a rod that jams (Painleve), laws of
//! restitution that raise the energy or reverse slip, static friction in time steps, and the warning where normal
//! forces are not unique.

use crate::checks::assert_closes;
use crate::friction::{lying, on_slope, rough, slope, sticky};
use crate::support::{accurate, floor, run};
use polhode::contact::Shape;
use polhode::scene::{Material, Method, RestitutionLaw, Tier};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use polhode::{Body, Effects, Event, EventKind, Scene};

const G: f64 = 9.81;

/// A slender rod of 1 kg and 2 m with its lower end at the origin, `angle` (rad) above the floor. The end slips with
/// `slip` (m/s) along x and sinks with `sinking` (m/s); the rod turns upwards with `rate` (rad/s).
fn rod(angle: f64, (slip, sinking): (f64, f64), rate: f64, material: &Material) -> Body {
    let inertia = Inertia::from_diagonal(DVec3::new(1e-4, 1.0 / 3.0, 1.0 / 3.0)).unwrap();
    let arm = DVec3::new(angle.cos(), 0.0, angle.sin());
    let turning = DVec3::Y * -rate;
    let velocity = DVec3::new(slip, 0.0, -sinking) + turning.cross(arm);
    Body::movable("rod", MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia))
        .geometry(Shape::points(vec![-DVec3::X, DVec3::X]).unwrap().into())
        .pose(Pose::new(Rotation::from_rotation_vector(DVec3::Y * -angle), arm))
        .velocity(Velocity::new(velocity, turning))
        .material(material.clone())
}

fn on_floor(body: Body, method: Method, material: &Material) -> Scene {
    let scene = Scene::builder("on the floor").method(method).body(body);
    scene.body(floor().material(material.clone())).duration_s(0.01).output_interval_s(0.001).build().unwrap()
}

/// Painleve's rod: pushed along at 60 degrees with a coefficient of 1.5 it has no system of finite forces. It jams: an
/// impulse stops its slip and throws it up, as large as the closed form of the path of the impact. With a coefficient
/// of 0.5 it slides on.
#[test]
fn rod_without_a_system_of_forces_jams() {
    let angle = 60f64.to_radians();
    let (sin, cos) = angle.sin_cos();
    // Collision matrix of the end over a floor: normal, coupling, along.
    let (normal, coupling, along) = (1.0 + 3.0 * cos * cos, 3.0 * sin * cos, 1.0 + 3.0 * sin * sin);
    for (friction, jams) in [(0.5, false), (1.5, true)] {
        let material = rough(friction);
        let scene = on_floor(rod(angle, (-1.0, 0.0), 1.0, &material), accurate(), &material);
        let (report, recorder) = run(&scene, Effects::Planned);
        let jam: Vec<&Event> = recorder.events.iter().filter(|event| event.kind == EventKind::Jam).collect();
        assert_eq!(jam.len(), usize::from(jams), "{:?}", recorder.events);
        assert_closes(&report);
        let Some(jam) = jam.first() else { continue };
        let stop = 1.0 / (friction * along - coupling);
        let sinking = -(normal - friction * coupling) * stop;
        let expected = stop + sinking / (normal - coupling * coupling / along);
        assert!((jam.impulse / expected - 1.0).abs() < 1e-12, "{} {expected}", jam.impulse);
        assert!(jam.t_s == 0.0 && report.crowded.is_empty(), "{report:?}");
    }
}

/// Whittaker's law (Newton's by algebra) raises the energy of a rod whose slip reverses: by the closed form, and the
/// report warns. Stronge's never does.
#[test]
fn report_warns_of_a_law_that_raises_the_energy() {
    let angle = 45f64.to_radians();
    let material = Material::new("rough").with_friction(1.0).unwrap().with_restitution(1.0).unwrap();
    for (law, gain) in [(RestitutionLaw::Whittaker, Some(0.1125)), (RestitutionLaw::Stronge, None)] {
        let method = Method { restitution_law: Some(law), ..accurate() };
        // A rod of 1 m: all lengths and speeds of the rod of 2 m by a half would do; K is that of 1 kg for both.
        let scene = on_floor(rod(angle, (0.6, 1.0), 0.0, &material), method, &material);
        let (report, _) = run(&scene, Effects::Planned);
        let lost = report.ledger.impact.value() + report.ledger.friction.value();
        match gain {
            Some(gain) => {
                assert!((lost + gain).abs() < 1e-12, "{lost}");
                assert!(report.warnings.iter().any(|warning| warning.contains("has raised the energy")));
            }
            None => assert!(lost >= 0.0 && report.warnings.is_empty(), "{lost} {:?}", report.warnings),
        }
        assert_closes(&report);
    }
}

/// Garwin's super ball: with a tangential restitution of 1 a ball without spin that falls obliquely leaves with 3/7
/// of its speed along and the spin -10/7; with 0 it rolls away at 5/7.
#[test]
fn super_ball_reverses_its_slip() {
    for (tangential_restitution, speed, spin) in [(1.0, 3.0 / 7.0, 10.0 / 7.0), (0.0, 5.0 / 7.0, 5.0 / 7.0)] {
        let material = Material::new("rubber").with_friction(10.0).unwrap().with_restitution(1.0).unwrap();
        let inertia = Inertia::from_diagonal(DVec3::splat(0.4)).unwrap();
        let ball = Body::movable("ball", MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia))
            .geometry(Shape::sphere(1.0).unwrap().into())
            .pose(Pose::from_translation(DVec3::Z * 1.005))
            .velocity(Velocity::new(DVec3::new(1.0, 0.0, -1.0), DVec3::ZERO))
            .material(material.clone());
        let restitution_law = Some(RestitutionLaw::ChatterjeeRuina { tangential_restitution });
        for tier in [Tier::Accurate, Tier::Stepped] {
            let method = Method { restitution_law, tier: Some(tier), ..Method::default() };
            let scene = Scene::builder("super ball").method(method).gravity(DVec3::ZERO).body(ball.clone());
            let scene = scene.body(floor().material(material.clone())).duration_s(0.01).build().unwrap();
            let (report, _) = run(&scene, Effects::Planned);
            let end = &report.bodies[0].state;
            let expected = Velocity::new(DVec3::new(speed, 0.0, 1.0), DVec3::Y * spin);
            assert!((end.velocity.linear - expected.linear).length() < 1e-14, "{end:?}");
            assert!((end.velocity.angular - expected.angular).length() < 1e-14, "{end:?}");
        }
    }
}

/// In time steps too a box at rest on a slope between the angles of kinetic and of static friction stays, and one that
/// slides goes on under kinetic friction.
#[test]
fn static_friction_holds_in_time_steps() {
    let angle = 0.4f64.atan();
    let material = sticky(0.5, 0.3);
    for speed in [0.0, 0.5] {
        let method = Method { tier: Some(Tier::Stepped), ..Method::default() };
        let body = lying(DVec3::new(0.4, 0.3, 0.1), 0.0, DVec3::X * speed);
        let scene = on_slope(slope(angle, 0.0), body, &material).method(method).duration_s(0.5).build().unwrap();
        let (report, _) = run(&scene, Effects::Planned);
        let end = report.bodies[0].state.velocity.linear.length();
        let expected = if speed == 0.0 { 0.0 } else { speed + 0.5 * G * (angle.sin() - 0.3 * angle.cos()) };
        assert!((end - expected).abs() < 1e-9, "{end} {expected}");
    }
}

/// Four corners of a box that slides bear forces that are not unique. The report says that the motion depends on the
/// choice where the box turns, and is silent where it slides straight.
#[test]
fn report_says_where_the_motion_depends_on_normal_forces() {
    for (turning, expected) in [(0.0, false), (3.0, true)] {
        let material = rough(0.3);
        let body = lying(DVec3::new(0.4, 0.3, 0.1), 0.2, DVec3::ZERO);
        let velocity = Velocity::new(DVec3::X, DVec3::Z * turning);
        let scene = on_slope(Rotation::IDENTITY, body.velocity(velocity), &material).duration_s(0.01).build().unwrap();
        let (report, _) = run(&scene, Effects::Planned);
        let says = report.choices.iter().any(|choice| choice.what.contains("of least norm are taken"));
        assert_eq!(says, expected, "{:?}", report.choices);
        assert!(report.warnings.is_empty(), "a choice is no defect: {:?}", report.warnings);
    }
}

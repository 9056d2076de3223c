//! Friction along and across a grain, against the closed forms of an ellipse with sliding of largest dissipation: boxes
//! that slide along and stay across, oblique slides that turn, tilted grains, static friction, and invariance under
//! rotation of everything; whose grain counts, and what is refused.

use crate::checks::assert_closes;
use crate::friction::{lying, on_slope, rough, slope};
use crate::support::{accurate, run};
use polhode::scene::{FrictionEllipse, Material, Method, Tier};
use polhode::spatial::{DVec3, Rotation};
use polhode::{Effects, Scene, SceneBuilder};

const G: f64 = 9.81;

/// A material with these coefficients along and across this direction of its body.
fn planks(along: f64, across: f64, direction: DVec3) -> Material {
    let ellipse = FrictionEllipse { along, across };
    Material::new("planks", 0.0, 0.0).expect("a material").with_grain(direction, ellipse).expect("a grain")
}

fn stepped() -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(1e-3), ..Method::default() }
}

/// A box with a grain on a slope of friction 1: the coefficients of the pair are the square roots of those of the grain.
fn sledge(turn: Rotation, velocity: DVec3, heading: f64, grain: &Material) -> SceneBuilder {
    let size = DVec3::new(0.8, 0.5, 0.1);
    let mut bodies =
        on_slope(turn, lying(size, heading, velocity), &rough(1.0)).build().expect("a scene").bodies().to_vec();
    bodies[0] = bodies[0].clone().material(grain.clone());
    bodies.into_iter().fold(Scene::builder("a sledge").method(accurate()), SceneBuilder::body)
}

/// Where a box is that slides over level ground with these coefficients, from the equations of motion by many small
/// steps of the classical Runge-Kutta method: `v' = -g M^2 v / |M v|`.
fn slid(velocity: DVec3, (along, across): (f64, f64), t: f64) -> DVec3 {
    let rate = |v: DVec3| {
        let pushed = DVec3::new(along * v.x, across * v.y, 0.0);
        -G * DVec3::new(along * pushed.x, across * pushed.y, 0.0) / pushed.length()
    };
    let count = 4000;
    let h = t / f64::from(count);
    let (mut x, mut v) = (DVec3::ZERO, velocity);
    for _ in 0..count {
        let a = rate(v);
        let b = rate(v + a * (0.5 * h));
        let c = rate(v + b * (0.5 * h));
        let d = rate(v + c * h);
        x += (v + (a + b + c) * (h / 6.0)) * h;
        v += (a + (b + c) * 2.0 + d) * (h / 6.0);
    }
    x
}

/// On a slope of 20 degrees a sledge whose runners point downhill slides with `g (sin a - mu_1 cos a)`; one that lies
/// across stays where it is. In every tier, and wherever downhill is.
#[test]
fn sledge_slides_along_its_runners_alone() {
    let (angle, along, across) = (20f64.to_radians(), 0.1, 0.6);
    let runners = planks(along * along, across * across, DVec3::X * 3.0);
    for (method, tolerance) in [(accurate(), 1e-12), (stepped(), 1e-9)] {
        for azimuth in [0.0, 0.8] {
            let turn = slope(angle, azimuth);
            let moved = |heading: f64| {
                let scene = sledge(turn, DVec3::ZERO, heading, &runners).method(method.clone()).duration_s(1.0);
                let scene = scene.output_interval_s(0.1).build().expect("a scene");
                let (report, recorder) = run(&scene, Effects::Planned);
                let (first, last) = (recorder.samples[0][0].pose, recorder.samples.last().expect("samples")[0].pose);
                (turn.inverse_rotate(last.translation - first.translation), report)
            };
            let (down, report) = moved(0.0);
            let expected = 0.5 * G * (angle.sin() - along * angle.cos());
            assert!((down - DVec3::X * expected).length() < tolerance * expected, "{down} {expected}");
            assert_closes(&report);
            assert_eq!(moved(std::f64::consts::FRAC_PI_2).0, DVec3::ZERO);
        }
    }
}

/// An oblique slide turns towards the runners as the equations of the ellipse say; the energy that friction takes is all
/// that the sledge had, and it does not turn round.
#[test]
fn oblique_slides_deflect() {
    let (along, across) = (0.2, 0.5);
    let runners = planks(along * along, across * across, DVec3::X);
    for angle in [0.3, 1.0, 1.5, -2.2] {
        let velocity = DVec3::new(f64::cos(angle), f64::sin(angle), 0.0) * 2.0;
        let scene = sledge(Rotation::IDENTITY, velocity, 0.0, &runners).duration_s(2.0).output_interval_s(0.05);
        let scene = scene.build().expect("a scene");
        let (report, recorder) = run(&scene, Effects::Planned);
        let start = recorder.samples[0][0].pose.translation;
        let rows = recorder.times.iter().zip(&recorder.samples).filter(|(t, _)| **t <= 0.3);
        let worst = rows.fold(0.0, |worst: f64, (&t, row)| {
            let moved = row[0].pose.translation - start;
            worst.max((moved - slid(velocity, (along, across), t)).length())
        });
        assert!(worst < 1e-10, "{worst:e}");
        assert!(report.bodies[0].1.velocity.is_zero(), "{:?}", report.bodies[0].1.velocity);
        assert!((report.ledger.friction.value() / 2.0 - 1.0).abs() < 1e-10, "{}", report.ledger.friction.value());
        assert_closes(&report);
    }
}

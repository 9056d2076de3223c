//! Friction along and across a grain, against the closed forms of an ellipse with sliding of largest dissipation: boxes
//! that slide along and stay across, oblique slides that turn, tilted grains, static friction, and invariance under
//! rotation of everything; whose grain counts, and what is refused.

use crate::checks::assert_closes;
use crate::friction::{lying, on_slope, rough, slope};
use crate::snapshots;
use crate::support::{accurate, run};
use polhode::scene::{FrictionEllipse, Material, Method, PairRule, SceneError, Tier};
use polhode::spatial::{DVec3, Pose, Rotation, Velocity};
use polhode::{BodyId, Effects, EventKind, Scene, SceneBuilder};

const G: f64 = 9.81;

/// A material with these coefficients along and across this direction of its body.
fn planks(along: f64, across: f64, direction: DVec3) -> Material {
    let ellipse = FrictionEllipse { along, across };
    Material::new("planks").with_grain(direction, ellipse).expect("a grain")
}

fn stepped() -> Method {
    Method { tier: Some(Tier::Stepped), step_s: Some(1e-3), ..Method::default() }
}

/// A box with a grain on a slope of friction 1: the coefficients of the pair are the square roots of those of the
/// grain.
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

/// An oblique slide turns towards the runners as the equations of the ellipse say; the energy that friction takes is
/// all that the sledge had, and it does not turn round.
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
        let rows = recorder.times_s.iter().zip(&recorder.samples).filter(|(t, _)| **t <= 0.3);
        let worst = rows.fold(0.0, |worst: f64, (&t, row)| {
            let moved = row[0].pose.translation - start;
            worst.max((moved - slid(velocity, (along, across), t)).length())
        });
        assert!(worst < 1e-10, "{worst:e}");
        assert!(report.bodies[0].state.velocity.is_zero(), "{:?}", report.bodies[0].state.velocity);
        assert!((report.ledger.friction.value() / 2.0 - 1.0).abs() < 1e-10, "{}", report.ledger.friction.value());
        assert_closes(&report);
    }
}

/// A grain that is tilted out of the plane acts along its projection, with the same coefficients; one on end gives
/// every direction the coefficient across it.
#[test]
fn tilted_grain_acts_along_its_projection() {
    let (along, across) = (0.1, 0.6);
    let turn = slope(20f64.to_radians(), 0.3);
    let down = |direction: DVec3| {
        let runners = planks(along * along, across * across, direction);
        let scene = sledge(turn, DVec3::ZERO, 0.0, &runners).duration_s(0.5).build().expect("a scene");
        let (_, recorder) = run(&scene, Effects::Planned);
        let (first, last) = (recorder.samples[0][0].pose, recorder.samples.last().expect("samples")[0].pose);
        turn.inverse_rotate(last.translation - first.translation).x
    };
    let level = down(DVec3::X);
    assert!(level > 0.1);
    for tilted in [DVec3::new(1.0, 0.0, 2.0), DVec3::new(-1.0, 0.0, 0.5)] {
        assert!((down(tilted) / level - 1.0).abs() < 1e-12);
    }
    assert_eq!(down(DVec3::Z), 0.0);
}

/// A push along the grain that static friction just bears moves nothing; a billionth more and the box slides with
/// kinetic friction. Static friction may have an ellipse of its own or be one number.
#[test]
fn static_friction_along_a_grain_is_its_own() {
    let kinetic = FrictionEllipse { along: 0.04, across: 0.36 };
    let smooth = Material::new("planks").with_grain(DVec3::X, kinetic).expect("a grain");
    let ellipse = FrictionEllipse { along: 0.09, across: 0.49 };
    let materials = [
        (smooth.clone().with_static_ellipse(ellipse).expect("an ellipse"), 0.3),
        (smooth.with_static_friction(0.64).expect("a number"), 0.8),
    ];
    for (material, limit) in materials {
        for (method, margin, tolerance) in [(accurate(), 1e-9, 1e-9), (stepped(), 0.05, 1e-3)] {
            for (share, slides) in [(1.0 - margin, false), (1.0 + margin, true)] {
                let angle = f64::atan(limit * share);
                let turn = slope(angle, 0.0);
                let scene = sledge(turn, DVec3::ZERO, 0.0, &material).method(method.clone()).duration_s(0.5);
                let (report, recorder) = run(&scene.build().expect("a scene"), Effects::Planned);
                let (first, last) = (recorder.samples[0][0].pose, recorder.samples.last().expect("samples")[0].pose);
                let moved = turn.inverse_rotate(last.translation - first.translation).x;
                let expected = if slides { 0.125 * G * (angle.sin() - 0.2 * angle.cos()) } else { 0.0 };
                assert!((moved - expected).abs() <= tolerance * expected.max(1.0), "{moved} {expected}");
                // The momentum of a body that never moves has no scale.
                if slides {
                    assert_closes(&report);
                }
            }
        }
    }
}

/// A push across the axes of the ellipse begins a slip along the normal of the ellipse, not along the push.
#[test]
fn slip_begins_along_the_normal_of_the_ellipse() {
    let (along, across) = (0.2_f64, 0.5_f64);
    let runners = planks(along * along, across * across, DVec3::X);
    let (heading, angle) = (0.6, 0.5);
    let turn = slope(angle, 0.0);
    let scene = sledge(turn, DVec3::ZERO, heading, &runners).duration_s(0.2).output_interval_s(0.02);
    let (report, recorder) = run(&scene.build().expect("a scene"), Effects::Planned);
    // With constant forces the slip keeps its direction d: g sin a down - g cos a M^2 d / |M d| = k d.
    let frame = Rotation::from_rotation_vector(DVec3::Z * heading);
    let (start, last) = (recorder.samples[0][0].pose, recorder.samples.last().expect("samples")[0].pose);
    let moved = frame.inverse_rotate(turn.inverse_rotate(last.translation - start.translation));
    let d = moved.normalize();
    let pushed = DVec3::new(along * d.x, across * d.y, 0.0);
    let friction = DVec3::new(along * pushed.x, across * pushed.y, 0.0) * (G * angle.cos() / pushed.length());
    let net = frame.inverse_rotate(DVec3::X) * (G * angle.sin()) - friction;
    assert!(net.cross(d).length() < 1e-8 * net.length(), "{net} {d}");
    assert!((moved - net * 0.02).length() < 1e-8 * moved.length(), "{moved} {net}");
    assert_closes(&report);
}

/// Turned by any rotation, gravity included, everything moves the same.
#[test]
fn directions_of_axes_do_not_matter() {
    let runners = planks(0.04, 0.25, DVec3::new(1.0, 0.4, 0.2));
    let moved = |rotation: Rotation| {
        let scene = sledge(rotation, DVec3::new(1.0, 0.8, 0.0), 0.4, &runners).duration_s(0.4);
        let scene = scene.gravity(rotation.rotate(DVec3::new(1.0, 0.3, -G))).build().expect("a scene");
        let (_, recorder) = run(&scene, Effects::Planned);
        let (first, last) = (recorder.samples[0][0].pose, recorder.samples.last().expect("samples")[0].pose);
        rotation.inverse_rotate(last.translation - first.translation)
    };
    let upright = moved(Rotation::IDENTITY);
    for axis in [DVec3::new(1.0, 2.0, -0.5), DVec3::new(-2.0, 0.3, 1.0)] {
        let turned = moved(Rotation::from_rotation_vector(axis));
        assert!((turned - upright).length() < 1e-10 * upright.length(), "{turned} {upright}");
    }
}

/// A sledge thrown on the snow: the impulse of the impact lies in the ellipse, opposes the slip as the ellipse says,
/// and costs energy.
#[test]
fn impacts_know_the_grain() {
    let (along, across) = (0.1, 0.3);
    let ball = crate::friction::round(0.4, 0.2, Velocity::new(DVec3::new(3.0, 2.0, -1.0), DVec3::ZERO));
    let ball = ball.pose(Pose::from_translation(DVec3::Z * 0.2));
    let runners = planks(along * along, across * across, DVec3::X);
    let scene = on_slope(Rotation::IDENTITY, ball, &rough(1.0)).build().expect("a scene");
    let bodies = scene.bodies().iter().cloned().enumerate();
    let bodies = bodies.map(|(index, body)| if index == 0 { body.material(runners.clone()) } else { body });
    let scene = bodies.fold(Scene::builder("thrown").method(accurate()), SceneBuilder::body).duration_s(1e-6);
    let (report, recorder) = run(&scene.output_interval_s(1e-6).build().expect("a scene"), Effects::Planned);
    assert!(recorder.events.iter().any(|event| event.kind == EventKind::Impact));
    // The slip loses 7/2 of what the centre loses. It does not stop, and dx/dy = (mu_1/mu_2)^2 x/y on the way.
    let given = report.bodies[0].state.velocity.linear - DVec3::new(3.0, 2.0, 0.0);
    let slip = DVec3::new(3.0, 2.0, 0.0) + given * 3.5;
    let expected = 3.0 * f64::powf(slip.y / 2.0, (along / across) * (along / across));
    assert!((slip.x - expected).abs() < 1e-5 && given.x < 0.0 && given.y < -0.2, "{slip} {expected}");
    assert_closes(&report);
}

/// Two grains in one contact are refused, and the message says to give the pair; a rule for the pair decides.
#[test]
fn two_grains_in_a_contact_are_refused() {
    let wood = planks(0.2, 0.4, DVec3::X);
    let scene = |other: Material| {
        let ground = on_slope(Rotation::IDENTITY, lying(DVec3::ONE, 0.0, DVec3::ZERO), &rough(1.0));
        let bodies = ground.build().expect("a scene").bodies().to_vec();
        let with = Scene::builder("two grains").body(bodies[0].clone().material(wood.clone()));
        with.body(bodies[1].clone().material(other))
    };
    let boards = Material::new("boards");
    let boards = boards.with_grain(DVec3::Y, FrictionEllipse { along: 0.1, across: 0.3 }).expect("a grain");
    let error = scene(boards.clone()).build().expect_err("whose grain is not clear");
    assert!(matches!(error, SceneError::TwoGrains { .. }) && error.to_string().contains("boards"), "{error}");
    let names = ["boards".to_owned(), "planks".to_owned()];
    let rule = PairRule::new(names).with_friction(0.3).expect("a rule");
    let decided = scene(boards.clone()).pair_rule(rule.clone()).build().expect("one number decides");
    assert_eq!(decided.material_between(BodyId::new(0), BodyId::new(1)).unwrap().grain_direction(), None);
    let ellipse = FrictionEllipse { along: 0.2, across: 0.5 };
    let decided = scene(boards).pair_rule(rule.with_grain(Some(DVec3::Y), ellipse).expect("a grain"));
    let pair = decided.build().expect("a direction decides").material_between(BodyId::new(0), BodyId::new(1)).unwrap();
    assert_eq!((pair.grain_direction(), pair.friction_ellipse()), (Some(DVec3::Y), ellipse));
}

/// Coefficients that no ellipse has are refused.
#[test]
fn impossible_ellipses_are_refused() {
    let plain = || Material::new("planks");
    for (along, across) in [(0.0, 0.5), (0.5, -0.1), (f64::NAN, 0.5), (0.5, f64::INFINITY), (1e-5, 0.5)] {
        let error = plain().with_grain(DVec3::X, FrictionEllipse { along, across });
        assert!(matches!(error, Err(SceneError::FrictionEllipse { .. })), "{along} {across}");
    }
    let ellipse = FrictionEllipse { along: 0.1, across: 0.5 };
    for direction in [DVec3::ZERO, DVec3::NAN, DVec3::X * f64::INFINITY] {
        assert!(matches!(plain().with_grain(direction, ellipse), Err(SceneError::GrainDirection { .. })));
    }
    assert!(matches!(plain().with_static_ellipse(ellipse), Err(SceneError::StaticGrain { .. })));
    let grained = plain().with_grain(DVec3::X, ellipse).expect("a grain");
    assert!(matches!(grained.with_static_friction(0.4), Err(SceneError::StaticFriction { .. })));
}

/// A run goes on from a snapshot with the same bits.
#[test]
fn run_with_a_grain_goes_on_with_the_same_bits() {
    let runners = planks(0.04, 0.25, DVec3::new(1.0, 0.4, 0.0));
    let scene = sledge(slope(0.3, 0.2), DVec3::new(0.5, 1.0, 0.0), 0.4, &runners).duration_s(0.5);
    snapshots::check_restored_runs(&scene.output_interval_s(0.05).build().expect("a scene"), Effects::Planned);
}

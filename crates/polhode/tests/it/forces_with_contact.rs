//! Forces on bodies that also touch others.

use crate::checks::{assert_closes, by, heavy_brick, max_position_error, numerical_relative, particle, root, try_run};
use crate::support::{accurate, ball, elastic, floor, run};
use polhode::contact::Shape;
use polhode::dynamics::integrator::Method as Integrator;
use polhode::scene::{Attachment, DragLaw, Force, Frame, Signal};
use polhode::spatial::{DVec3, Pose, Velocity};
use polhode::{Body, BodyId, Effects, EventKind, Geometry, Recorder, Scene, Simulation};
use std::f64::consts::TAU;

const G: f64 = 9.81;

fn push(body: usize, force: DVec3, signal: Signal) -> Force {
    Force::Applied { body: BodyId::new(body), force, torque: DVec3::ZERO, frame: Frame::World, point: None, signal }
}

fn times_of(recorder: &Recorder, kind: EventKind) -> Vec<f64> {
    recorder.events.iter().filter(|event| event.kind == kind).map(|event| event.t_s).collect()
}

/// A spring to a point below the floor pulls a box down; the box rests, and with all effects on it has the same bits.
#[test]
fn box_held_down_by_a_spring_rests() {
    let size = DVec3::new(0.5, 0.4, 0.2);
    let spring = Force::Spring {
        a: Attachment::World(DVec3::new(0.0, 0.0, -1.0)),
        b: Attachment::Body { body: BodyId::new(1), point: DVec3::new(0.0, 0.0, -0.1) },
        stiffness: 300.0,
        rest_length: 0.6,
        damping: 0.0,
    };
    let scene = Scene::builder("held")
        .method(accurate())
        .duration_s(2.0)
        .body(floor())
        .body(heavy_brick("box", 2.0, size, DVec3::Z * 0.1))
        .force(spring)
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    assert_eq!(recorder.samples[0], *recorder.samples.last().unwrap());
    assert_closes(&report);
    assert_eq!(run(&scene, Effects::All).0.bodies, report.bodies);
    let supported = report.ledger.momentum.support.value().linear.z;
    let (weight, pulled) = (2.0 * G * 2.0, 300.0 * 0.4 * 2.0);
    assert!((supported / (weight + pulled) - 1.0).abs() < 1e-12, "the floor bears weight and spring: {supported}");
    assert!((report.ledger.momentum.fields.value().linear.z + pulled).abs() < 1e-10 * pulled);
}

/// On a frictionless floor a push accelerates a box by F/m, through its centre or above it.
#[test]
fn pushed_box_slides_at_force_over_mass() {
    let size = DVec3::new(0.5, 0.4, 0.2);
    for point in [None, Some(DVec3::Z * 0.07)] {
        let force = Force::Applied {
            body: BodyId::new(1),
            force: DVec3::new(3.0, -1.0, 0.0),
            torque: DVec3::ZERO,
            frame: Frame::World,
            point,
            signal: Signal::ONE,
        };
        let scene = Scene::builder("pushed")
            .method(accurate())
            .duration_s(1.5)
            .body(floor())
            .body(heavy_brick("box", 2.0, size, DVec3::Z * 0.1))
            .force(force)
            .build()
            .unwrap();
        let first = Simulation::new(&scene).unwrap().accelerations().unwrap()[1];
        assert!((first.linear - DVec3::new(1.5, -0.5, 0.0)).length() < 1e-12, "{first:?}");
        let (report, recorder) = run(&scene, Effects::Planned);
        let worst = max_position_error(&recorder, 1, |t| DVec3::new(0.75 * t * t, -0.25 * t * t, 0.1));
        assert!(worst < 1e-12, "{worst:e}");
        let work = DVec3::new(3.0, -1.0, 0.0).dot(DVec3::new(0.75, -0.25, 0.0)) * 2.25;
        assert!((report.ledger.external.value() / work - 1.0).abs() < 1e-12);
        assert_closes(&report);
    }
}

/// A pull `b t` lifts a box at the time t0 when it exceeds the weight, not before; then `z = b (t - t0)^3/(6 m)`.
#[test]
fn growing_pull_lifts_a_box_when_it_exceeds_the_weight() {
    let (mass, growth) = (2.0, 30.0);
    let lift = mass * G / growth;
    let scene = Scene::builder("lift")
        .method(accurate())
        .duration_s(1.0)
        .body(floor())
        .body(heavy_brick("box", mass, DVec3::new(0.5, 0.4, 0.2), DVec3::Z * 0.1))
        .force(push(1, DVec3::Z * growth, Signal::polynomial(vec![0.0, 1.0]).unwrap()))
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let z = |t: f64| 0.1 + growth / (6.0 * mass) * f64::powi((t - lift).max(0.0), 3);
    let worst = max_position_error(&recorder, 1, |t| DVec3::Z * z(t));
    assert!(worst < 1e-9, "{worst:e} {:?}", recorder.events);
    let detached = times_of(&recorder, EventKind::Detach);
    assert!(!detached.is_empty() && detached.iter().all(|t| (t - lift).abs() < 1e-9), "{detached:?} {lift}");
    assert_closes(&report);
}

/// A pull that comes and goes lifts a box, lets it fall, and lifts it again. Rest ends each time the pull exceeds the
/// weight, also if the pull begins long after the box has come to rest.
#[test]
fn late_pull_wakes_a_box_at_rest() {
    let mass = 1.4;
    let pull = Signal::table(vec![(1.0, 0.0), (1.5, 2.0), (1.8, 0.0)]).unwrap();
    let scene = Scene::builder("late")
        .method(accurate())
        .duration_s(1.5)
        .body(floor())
        .body(heavy_brick("box", mass, DVec3::new(0.5, 0.4, 0.2), DVec3::Z * 0.1))
        .force(push(1, DVec3::Z * (mass * G), pull))
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let z = |t: f64| 0.1 + 4.0 * G / 6.0 * f64::powi((t - 1.25).max(0.0), 3);
    let worst = max_position_error(&recorder, 1, |t| DVec3::Z * z(t));
    assert!(worst < 1e-9, "{worst:e} {:?}", recorder.events);
    assert_closes(&report);
}

/// A ball falls through a viscous medium onto the floor and bounces: the times of the first two impacts.
#[test]
fn ball_in_drag_bounces_at_the_times_of_the_closed_form() {
    let (mass, c, e, radius, height) = (0.6, 0.8, 0.7, 0.1, 1.3);
    let scene = Scene::builder("viscous")
        .method(accurate())
        .duration_s(1.2)
        .body(floor().material(elastic(e)))
        .body(ball("ball", mass, radius, DVec3::Z * (height + radius), DVec3::ZERO).material(elastic(e)))
        .force(Force::Drag {
            body: BodyId::new(1),
            law: DragLaw::Linear,
            translational: c,
            rotational: 0.0,
            wind: DVec3::ZERO,
        })
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let (terminal, rate) = (mass * G / c, c / mass);
    let velocity = |v0: f64, t: f64| -terminal + (v0 + terminal) * (-rate * t).exp();
    let rise = |v0: f64, t: f64| -terminal * t + (v0 + terminal) * (1.0 - (-rate * t).exp()) / rate;
    let first = root(0.0, 2.0, |t| height + rise(0.0, t));
    let bounce = -e * velocity(0.0, first);
    let second = first + root(0.01, 2.0, |t| rise(bounce, t));
    let impacts = times_of(&recorder, EventKind::Impact);
    assert!((impacts[0] - first).abs() < 1e-11 && (impacts[1] - second).abs() < 1e-11, "{impacts:?} {first} {second}");
    assert!(report.certificate.max_penetration_m <= 1e-12);
    assert_closes(&report);
}

/// Two boxes, one above the other on a spring; the upper one swings, and the lower one leaves the floor when the spring
/// pulls it by its weight.
#[test]
fn lower_box_of_a_sprung_pair_lifts_when_the_spring_pulls_by_its_weight() {
    let (lower, upper, stiffness, length) = (1.1, 2.0, 200.0, 0.5);
    let size = DVec3::new(0.3, 0.3, 0.2);
    let rest = 0.2 + length - upper * G / stiffness;
    let up = 1.9;
    let scene = Scene::builder("sprung pair")
        .method(accurate())
        .duration_s(0.9)
        .body(floor())
        .body(heavy_brick("lower", lower, size, DVec3::Z * 0.1))
        .body(
            heavy_brick("upper", upper, size, DVec3::Z * (rest + 0.1))
                .velocity(Velocity::new(DVec3::Z * up, DVec3::ZERO)),
        )
        .force(Force::Spring {
            a: Attachment::Body { body: BodyId::new(1), point: DVec3::Z * 0.1 },
            b: Attachment::Body { body: BodyId::new(2), point: DVec3::Z * -0.1 },
            stiffness,
            rest_length: length,
            damping: 0.0,
        })
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let w = f64::sqrt(stiffness / upper);
    // The spring pulls by stiffness * (x - weight of the upper one / stiffness), x from its rest.
    let lift = ((lower + upper) * G / stiffness / (up / w)).asin() / w;
    let detached = times_of(&recorder, EventKind::Detach);
    assert!(!detached.is_empty() && (detached[0] - lift).abs() < 1e-9, "{detached:?} {lift}");
    let before = recorder.times_s.iter().zip(&recorder.samples).filter(|(t, _)| **t < lift);
    for (t, row) in before {
        assert!((row[1].pose.translation.z - 0.1).abs() < 1e-14, "{t}");
        let z = rest + 0.1 + up / w * (w * t).sin();
        assert!((row[2].pose.translation.z - z).abs() < 1e-10, "{t}");
    }
    // In the air the centre of mass flies.
    let flight = recorder.times_s.iter().zip(&recorder.samples).filter(|(t, _)| **t > lift && **t < lift + 0.15);
    let center = |z1: f64, z2: f64| (lower * z1 + upper * z2) / (lower + upper);
    let z0 = center(0.1, rest + 0.1 + up / w * (w * lift).sin());
    let v0 = center(0.0, up * (w * lift).cos());
    for (t, row) in flight {
        let dt = t - lift;
        let z = z0 + v0 * dt - 0.5 * G * dt * dt;
        assert!((center(row[1].pose.translation.z, row[2].pose.translation.z) - z).abs() < 1e-9, "{t}");
    }
    assert_closes(&report);
}

/// A pair of boxes joined by a spring stays at rest although the spring couples them. When a third box strikes one of
/// them, both wake.
#[test]
fn resting_box_wakes_when_its_spring_partner_is_struck() {
    let (stiffness, mass) = (500.0, 1.0);
    let size = DVec3::new(0.3, 0.3, 0.2);
    let scene = Scene::builder("struck")
        .method(accurate())
        .duration_s(1.0)
        .body(floor())
        .body(heavy_brick("a", mass, size, DVec3::new(0.0, 0.0, 0.1)))
        .body(heavy_brick("b", mass, size, DVec3::new(1.0, 0.0, 0.1)))
        .body(
            heavy_brick("c", mass, size, DVec3::new(1.9, 0.0, 0.1)).velocity(Velocity::new(DVec3::NEG_X, DVec3::ZERO)),
        )
        .pair_rule(polhode::scene::PairRule::new([String::new(), String::new()]).with_restitution(0.0).unwrap())
        .force(Force::Spring {
            a: Attachment::Body { body: BodyId::new(1), point: DVec3::ZERO },
            b: Attachment::Body { body: BodyId::new(2), point: DVec3::ZERO },
            stiffness,
            rest_length: 1.0,
            damping: 0.0,
        })
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    // Struck at 0.6 s; b and c go on at half the speed until the spring pushes them apart.
    let end = recorder.samples.last().unwrap();
    assert!(end[1].velocity.linear.length() > 0.01, "{:?} {:?}", end, recorder.events);
    let momentum: f64 = (1..4).map(|body| mass * end[body].velocity.linear.x).sum();
    assert!((momentum + 1.0).abs() < 1e-12, "{momentum}");
    assert_closes(&report);
}

/// A ball on a spring strikes a wall with e = 1. The times of its impacts are those of an oscillation that the wall
/// reflects.
#[test]
fn oscillator_strikes_a_wall_at_its_times() {
    let (mass, stiffness, radius, start, wall) = (0.5, 60.0, 0.05, 0.4, -0.23);
    let barrier = Body::fixed("wall")
        .geometry(Geometry::Shape(Shape::cuboid(DVec3::new(0.02, 1.0, 1.0)).unwrap()))
        .pose(Pose::from_translation(DVec3::X * (wall - radius - 0.01)))
        .material(elastic(1.0));
    let scene = Scene::builder("cut oscillation")
        .method(accurate())
        .gravity(DVec3::ZERO)
        .duration_s(4.0)
        .body(barrier)
        .body(ball("ball", mass, radius, DVec3::X * start, DVec3::ZERO).material(elastic(1.0)))
        .force(Force::Spring {
            a: Attachment::World(DVec3::ZERO),
            b: Attachment::Body { body: BodyId::new(1), point: DVec3::ZERO },
            stiffness,
            rest_length: 0.0,
            damping: 0.0,
        })
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let w = f64::sqrt(stiffness / mass);
    let quarter = (wall / start).acos() / w;
    let impacts = times_of(&recorder, EventKind::Impact);
    assert!(impacts.len() > 5);
    for (number, t) in impacts.iter().enumerate() {
        let expected = quarter * (2.0 * number as f64 + 1.0);
        assert!((t - expected).abs() < 1e-10, "{number}: {t} {expected}");
    }
    assert!(report.certificate.max_penetration_m <= 1e-12);
    assert!((report.energy.final_j / report.energy.initial_j - 1.0).abs() < 1e-12);
    assert_closes(&report);
}

/// A bullet meets a thin plate on springs within a step. It does not tunnel, and the impact is with the plate where the
/// springs have moved it.
#[test]
fn bullet_meets_a_sprung_plate() {
    let (mass, stiffness, thickness, speed, amplitude) = (2.0, 900.0, 1e-3, 2000.0, 0.03);
    let plate =
        heavy_brick("plate", mass, DVec3::new(thickness, 0.5, 0.5), DVec3::X * amplitude).material(elastic(1.0));
    let spring = |y: f64, z: f64| Force::Spring {
        a: Attachment::World(DVec3::new(0.0, y, z)),
        b: Attachment::Body { body: BodyId::new(0), point: DVec3::new(0.0, y, z) },
        stiffness: 0.25 * stiffness,
        rest_length: 0.0,
        damping: 0.0,
    };
    let (radius, distance) = (1e-3, 171.3);
    let mut builder = Scene::builder("bullet")
        .method(accurate())
        .gravity(DVec3::ZERO)
        .duration_s(0.1)
        .body(plate)
        .body(ball("bullet", 0.01, radius, DVec3::NEG_X * distance, DVec3::X * speed).material(elastic(1.0)));
    for (y, z) in [(0.1, 0.1), (-0.1, 0.1), (0.1, -0.1), (-0.1, -0.1)] {
        builder = builder.force(spring(y, z));
    }
    let (report, recorder) = run(&builder.build().unwrap(), Effects::Planned);
    let w = f64::sqrt(stiffness / mass);
    let gap = |t: f64| amplitude * (w * t).cos() - 0.5 * thickness - radius - (speed * t - distance);
    let expected = root(0.0, 0.1, gap);
    let impacts = times_of(&recorder, EventKind::Impact);
    assert!(impacts.len() == 1 && (impacts[0] - expected).abs() < 1e-12, "{impacts:?} {expected}");
    let before = -amplitude * w * (w * expected).sin();
    let after = speed - 2.0 * mass / (mass + 0.01) * (speed - before);
    let found = report.bodies[1].state.velocity.linear.x;
    assert!((found / after - 1.0).abs() < 1e-11, "{found} {after}");
    assert_closes(&report);
}

/// A stick that spins many turns in a step and is drawn to a wall by a spring strikes the wall with its end, at the
/// time of the closed form, and never overlaps it: with error control, and with fixed steps of an integrator that
/// rotates bodies exactly.
#[test]
fn fast_spinning_stick_on_a_spring_strikes_with_its_end() {
    let spin = 3000.0;
    let stick = heavy_brick("stick", 0.4, DVec3::new(0.6, 0.02, 0.02), DVec3::X * 0.5)
        .velocity(Velocity::new(DVec3::ZERO, DVec3::Y * spin))
        .material(elastic(1.0));
    let barrier = Body::fixed("wall")
        .geometry(Geometry::Shape(Shape::cuboid(DVec3::new(0.2, 2.0, 2.0)).unwrap()))
        .pose(Pose::from_translation(DVec3::NEG_X * 0.1))
        .material(elastic(1.0));
    let scene = Scene::builder("spinning stick")
        .method(accurate())
        .gravity(DVec3::ZERO)
        .duration_s(0.3)
        .output_interval_s(0.05)
        .body(barrier)
        .body(stick)
        .force(Force::Spring {
            a: Attachment::World(DVec3::ZERO),
            b: Attachment::Body { body: BodyId::new(1), point: DVec3::ZERO },
            stiffness: 10.0,
            rest_length: 0.0,
            damping: 0.0,
        })
        .build()
        .unwrap();
    let w = f64::sqrt(10.0 / 0.4);
    let angle = |t: f64| (spin * t).rem_euclid(TAU);
    // How far the corners reach towards the wall, m.
    let reach = |t: f64| 0.3 * angle(t).cos().abs() + 0.01 * angle(t).sin().abs();
    let gap = |t: f64| 0.5 * (w * t).cos() - reach(t);
    let step = 1e-6;
    let near = (0..300_000).map(|k| f64::from(k) * step).find(|&t| gap(t + step) <= 0.0).unwrap();
    let expected = root(near, near + step, gap);
    for method in [accurate(), by(Integrator::Exact, 0.01), by(Integrator::Exact, 0.003)] {
        let (report, recorder) = try_run(&scene.clone().with_method(method), 2_000_000).unwrap();
        let impact = times_of(&recorder, EventKind::Impact)[0];
        // In 1e-10 s the stick turns by 3e-7 rad.
        assert!((impact - expected).abs() < 1e-10, "{impact} {expected}");
        assert!(report.certificate.max_penetration_m <= 1e-12, "{:e}", report.certificate.max_penetration_m);
        assert!(numerical_relative(&report) < 1e-9, "{:e}", numerical_relative(&report));
        assert_closes(&report);
    }
}

/// A box rests on the floor above an attracting centre while another body orbits the centre by fixed steps: the first
/// stays at rest, and the second follows its orbit.
#[test]
fn body_at_rest_does_not_disturb_what_is_stepped() {
    let center = DVec3::NEG_Z * 0.5;
    let scene = |method| {
        Scene::builder("two under one point")
            .method(method)
            .gravity(DVec3::ZERO)
            .duration_s(2.0)
            .body(floor())
            .body(heavy_brick("box", 1.0, DVec3::new(0.5, 0.4, 0.2), DVec3::Z * 0.1))
            .body(particle("comet", 1.0, DVec3::new(3.0, 0.0, 1.0), DVec3::new(0.0, 1.0, 0.3)))
            .force(Force::PointGravity { center, mu: 4.0 })
            .build()
            .unwrap()
    };
    let (accurate, _) = run(&scene(accurate()), Effects::Planned);
    assert!(accurate.bodies[1].state.velocity.is_zero());
    for integrator in [Integrator::Rk4, Integrator::Exact, Integrator::Splitting6] {
        let (report, _) = try_run(&scene(by(integrator, 0.01)), 1000).unwrap();
        assert_eq!(report.bodies[1], accurate.bodies[1], "{integrator}");
        let apart = report.bodies[2].state.pose.translation - accurate.bodies[2].state.pose.translation;
        assert!(apart.length() < 1e-8, "{integrator}: {:e}", apart.length());
        assert_closes(&report);
    }
}

//! Springs at contacts that rest: static friction holds as much as statics asks, whatever springs do before they are at
//! rest; and what touches without load costs no events.

use polhode::contact::Shape;
use polhode::mesh::{solid_box, solid_sphere};
use polhode::scene::{Integrator, Material, Method, Response};
use polhode::spatial::{DVec3, Mass, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodySample, RunReport, Scene, SceneBuilder, Simulation};

const GRAVITY: f64 = 9.81;

fn springs() -> Method {
    Method { response: Some(Response::Penalty), tolerance: Some(1e-8), ..Method::default() }
}

fn run(scene: SceneBuilder) -> RunReport {
    let report = Simulation::new(&scene.build().unwrap()).unwrap().run().unwrap();
    let closure = report.ledger.closure_relative();
    assert!(closure < 1e-12, "the ledger closes to {closure:e}");
    report
}

fn rough(kinetic: f64, at_rest: f64) -> Material {
    Material::new("rough").with_friction(kinetic).unwrap().with_static_friction(at_rest).unwrap()
}

fn block(name: &str, size: DVec3, place: DVec3) -> Body {
    Body::movable(name, solid_box(size, Mass::new(1.0).unwrap()).unwrap())
        .geometry(Shape::cuboid(size).unwrap().into())
        .pose(Pose::from_translation(place))
}

fn floor(material: &Material) -> Body {
    Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into()).material(material.clone())
}

/// Gravity on a slope of this angle (rad) in the axes of the slope: down along x.
fn down(slope: f64) -> DVec3 {
    DVec3::new(slope.sin(), 0.0, -slope.cos()) * GRAVITY
}

fn end(report: &RunReport, body: usize) -> BodySample {
    report.bodies[body].state
}

/// The block on a slope that begins at a speed up the slope.
fn on_slope(slope: f64, material: &Material, size: DVec3, (speed, duration): (f64, f64), method: Method) -> BodySample {
    let own = block("block", size, DVec3::Z * (0.5 * size.z)).material(material.clone());
    let own = own.velocity(Velocity::new(DVec3::X * -speed, DVec3::ZERO));
    let scene = Scene::builder("slope").method(method).gravity(down(slope)).duration_s(duration);
    end(&run(scene.body(floor(material)).body(own)), 1)
}

/// A block that is set down stays up to the angle of static friction, whatever kinetic friction is: its corners do not
/// bear alike, and its weight comes at once. Beyond that angle it slides as kinetic friction lets it.
#[test]
fn static_friction_holds_up_to_its_angle() {
    let thousandth = |size: DVec3| 1e-3 * size.min_element();
    for (slope, kinetic, size) in [
        (0.52_f64, 0.4, DVec3::new(0.3, 0.2, 0.1)),
        (0.52, 0.1, DVec3::new(0.2, 0.2, 0.2)),
        (0.2, 0.05, DVec3::new(0.3, 0.3, 0.1)),
        (0.9, 0.6, DVec3::new(0.5, 0.1, 0.05)),
    ] {
        let holds = rough(kinetic, 1.05 * slope.tan());
        let stands = on_slope(slope, &holds, size, (0.0, 0.5), springs());
        let moved = stands.pose.translation.x.abs();
        assert!(moved < 10.0 * thousandth(size) && stands.velocity.linear.x.abs() < 1e-5, "{slope}: {moved} m");
        let gives = rough(kinetic.min(0.6 * slope.tan()), 0.8 * slope.tan());
        let slides = on_slope(slope, &gives, size, (0.0, 0.5), springs()).velocity.linear.x;
        let expected = (slope.sin() - kinetic.min(0.6 * slope.tan()) * slope.cos()) * GRAVITY * 0.5;
        // It breaks away when it has slipped by the stretch of its springs.
        assert!(slides > 0.5 * expected && slides < expected, "{slope}: {slides} of {expected} m/s");
    }
}

/// A block that slides up a slope stops after `v^2/(2 g (sin + mu cos))` and stays there, where static friction holds
/// it and kinetic friction does not.
#[test]
fn a_block_that_stops_on_a_slope_stays() {
    for (slope, kinetic, at_rest, speed) in [(0.52_f64, 0.4, 0.7, 1.0), (0.52, 0.4, 0.61, 0.4), (0.3, 0.1, 0.4, 1.0)] {
        let size = DVec3::new(0.3, 0.2, 0.1);
        let deceleration = GRAVITY * (slope.sin() + kinetic * slope.cos());
        let way = speed * speed / (2.0 * deceleration);
        let stops = on_slope(slope, &rough(kinetic, at_rest), size, (speed, speed / deceleration + 0.4), springs());
        let error = stops.pose.translation.x + way;
        assert!(error.abs() < 5e-4 && stops.velocity.linear.length() < 1e-3, "{slope}: {error} m of {way} m");
    }
}

/// Fixed steps know both coefficients too.
#[test]
fn fixed_steps_hold_by_static_friction() {
    let method = Method { integrator: Some(Integrator::Rk4), tolerance: None, ..springs() };
    let (slope, size) = (0.52_f64, DVec3::new(0.3, 0.2, 0.1));
    let stands = on_slope(slope, &rough(0.4, 0.63), size, (0.0, 0.4), method.clone());
    assert!(stands.pose.translation.x.abs() < 2e-4, "{:?}", stands.pose);
    let slides = on_slope(slope, &rough(0.4, 0.5), size, (0.0, 0.4), method).velocity.linear.x;
    let expected = (slope.sin() - 0.4 * slope.cos()) * GRAVITY * 0.4;
    assert!(slides > 0.5 * expected && slides < expected, "{slides} of {expected} m/s");
}

/// Two cards that lean on each other at an angle a from upright stand on feet whose friction is above `tan(a)/2`, which
/// statics asks.
#[test]
fn cards_that_lean_stand() {
    let size = DVec3::new(0.004, 0.2, 0.3);
    for (angle, kinetic, at_rest) in [(0.3_f64, 0.5, 1.05), (0.3, 0.8, 1.2)] {
        let asked = angle.tan() / 2.0;
        let card_stock = rough(asked * kinetic, asked * at_rest);
        let (x, z) =
            (0.5 * (size.x * angle.cos() + size.z * angle.sin()), 0.5 * (size.z * angle.cos() + size.x * angle.sin()));
        let card = |name: &str, side: f64| {
            let pose =
                Pose::new(Rotation::from_rotation_vector(DVec3::Y * (-side * angle)), DVec3::new(side * x, 0.0, z));
            block(name, size, DVec3::ZERO).pose(pose).material(card_stock.clone())
        };
        let scene = Scene::builder("cards").method(springs()).duration_s(0.5).body(floor(&card_stock));
        let report = run(scene.body(card("left", -1.0)).body(card("right", 1.0)));
        let sunk = (end(&report, 1).pose.translation.z - z).abs();
        assert!(sunk < 2e-3, "{angle}, {kinetic}, {at_rest}: {sunk} m");
    }
}

/// Two boxes stand side by side on a floor and touch without load; elsewhere a ball rolls, whose blow their springs are
/// made for. Nothing happens, with and without friction, and the run costs as many steps as its springs ask, not more.
#[test]
fn what_touches_without_load_ends_no_steps() {
    for friction in [0.0, 0.5] {
        let ice = Material::new("ice").with_friction(friction).unwrap();
        let size = DVec3::splat(0.3);
        let boxes = [("left", 0.0), ("right", 0.3)].map(|(name, x)| block(name, size, DVec3::new(x, 0.0, 0.15)));
        let ball = Body::movable("ball", solid_sphere(0.1, Mass::new(2.0).unwrap()).unwrap())
            .geometry(Shape::sphere(0.1).unwrap().into())
            .pose(Pose::from_translation(DVec3::new(-12.0, 0.0, 0.1)))
            .velocity(Velocity::new(DVec3::X * 0.3, DVec3::ZERO));
        let scene = Scene::builder("side by side").method(springs()).duration_s(1.0).body(floor(&ice)).body(ball);
        let report = run(boxes.into_iter().fold(scene, |scene, own| scene.body(own.material(ice.clone()))));
        for (body, x) in [(2, 0.0), (3, 0.3)] {
            let away = end(&report, body).pose.translation - DVec3::new(x, 0.0, 0.15);
            assert!(away.length() < 1e-4, "{friction}: {away}");
        }
        let springs = report.springs.unwrap();
        // Three bodies with steps of no less than 4 times the reciprocal frequency, of which dampers at rest make
        // shorter ones.
        assert!(report.steps as f64 <= 4.0 * springs.fastest_rad_s, "{friction}: {} steps", report.steps);
    }
}

/// A stack at rest of restitution 1 does not run out of events.
#[test]
fn a_stack_of_restitution_one_runs() {
    let rubber = Material::new("rubber").with_restitution(1.0).unwrap().with_friction(0.3).unwrap();
    let size = DVec3::splat(0.2);
    let scene = Scene::builder("stack").method(springs()).duration_s(0.5).body(floor(&rubber));
    let boxes = (0..3).map(|k| block(&format!("box {k}"), size, DVec3::Z * (0.1 + 0.2 * f64::from(k))));
    let report = run(boxes.fold(scene, |scene, own| scene.body(own.material(rubber.clone()))));
    assert!((end(&report, 3).pose.translation.z - 0.5).abs() < 2e-3, "{:?}", end(&report, 3).pose);
    assert!(!report.warnings.iter().any(|warning| warning.contains("integrator")), "{:?}", report.warnings);
}

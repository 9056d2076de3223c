//! Light bodies that carry heavy ones in the tier `accurate`: neither steps nor accuracy depend on the mass ratio.

use crate::checks::{dense_brick, heavy_brick, max_position_error};
use crate::friction::{rough, slope};
use crate::support::{accurate, floor, run};
use polhode::contact::Shape;
use polhode::spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Effects, Geometry, Recorder, RunReport, Scene, Simulation};

/// A box of 1 kg on the floor; a box of `ratio` kg, turned by `turn` (rad) about the vertical, slides on it.
fn slide(ratio: f64, turn: f64, on_top: bool) -> (RunReport, Recorder) {
    let (low, high) = (DVec3::new(1.0, 1.0, 0.5), DVec3::new(0.9, 0.7, 0.3));
    let turned = |body: Body, place: DVec3| {
        let rotation = Rotation::from_rotation_vector(DVec3::Z * turn);
        body.pose(Pose::new(rotation, place)).velocity(Velocity::new(DVec3::X * 0.05, DVec3::ZERO))
    };
    let place = DVec3::new(0.1, 0.05, 0.65);
    let scene = Scene::builder("slide")
        .method(accurate())
        .duration_s(1.0)
        .body(floor())
        .body(heavy_brick("light", 1.0, low, DVec3::Z * 0.25))
        .body(turned(heavy_brick("heavy", ratio, high, place), place));
    let top = DVec3::new(0.0, 0.0, 0.9);
    let scene = if on_top { scene.body(heavy_brick("top", 3.0, DVec3::new(0.4, 0.4, 0.2), top)) } else { scene };
    let mut recorder = Recorder::default();
    let report = Simulation::new(&scene.build().unwrap()).unwrap().run_observed(&mut recorder).unwrap();
    (report, recorder)
}

/// The rounding of the forces between a light and a heavy body is no error of the integration: it causes no further
/// steps and moves the light body by less than a nanometre. (When rounded forces were summed, ratios of 1e4 to 1e7 took
/// 102, 603, 5543 and 55,972 steps.)
#[test]
fn steps_do_not_grow_with_the_mass_ratio() {
    for (turn, on_top) in [(0.0, false), (0.4, false), (0.4, true)] {
        let alike = slide(1.0, turn, on_top).0.steps;
        for exponent in [2, 3, 4, 6, 8, 9] {
            let (report, recorder) = slide(10.0_f64.powi(exponent), turn, on_top);
            assert!(report.steps <= alike + 2, "1e{exponent}: {} steps, {alike} for equal masses", report.steps);
            let light = max_position_error(&recorder, 1, |_| DVec3::Z * 0.25);
            let heavy = max_position_error(&recorder, 2, |t| DVec3::new(0.1 + 0.05 * t, 0.05, 0.65));
            assert!(light < 1e-9 && heavy < 1e-12, "1e{exponent}: {light:e} m, {heavy:e} m");
        }
    }
}

/// On a slope without friction a box of 1 kg and a heavy one on it, turned about the normal, slide together by `g
/// sin(tilt) t^2/2`. (Contact normals that differed by the rounding of attitudes pushed the light box aside like a
/// wedge: by 1e-10 m at a ratio of 1e6, 2e-7 m at 1e9.)
#[test]
fn light_box_under_a_heavy_one_slides_down_a_slope() {
    let (low, high) = (DVec3::new(1.0, 1.0, 0.5), DVec3::new(0.9, 0.7, 0.3));
    for (tilt, turn) in [(0.35, 0.0), (0.35, 0.4), (-0.2, 1.1)] {
        let slope = Rotation::from_rotation_vector(DVec3::Y * tilt);
        let normal = UnitVector::new(slope.rotate(DVec3::Z)).unwrap();
        let place = |x: f64, y: f64, height: f64| slope.rotate(DVec3::new(x, y, 0.0)) + slope.rotate(DVec3::Z) * height;
        let ground = Body::fixed("slope").geometry(Geometry::Shape(Shape::half_space(normal)));
        let turned = slope * Rotation::from_rotation_vector(DVec3::Z * turn);
        let way = |t: f64| 0.5 * 9.81 * tilt.sin() * t * t;
        for exponent in [0, 3, 5, 6, 7, 8, 9] {
            let mass = 10.0_f64.powi(exponent);
            let light = heavy_brick("light", 1.0, low, DVec3::ZERO).pose(Pose::new(slope, place(0.0, 0.0, 0.25)));
            let heavy = heavy_brick("heavy", mass, high, DVec3::ZERO).pose(Pose::new(turned, place(0.01, 0.05, 0.65)));
            let scene = Scene::builder("slope").method(accurate()).duration_s(1.0).body(ground.clone());
            let (report, recorder) = run(&scene.body(light).body(heavy).build().unwrap(), Effects::Planned);
            assert!(report.steps <= 110, "1e{exponent}: {} steps", report.steps);
            let light = max_position_error(&recorder, 1, |t| place(way(t), 0.0, 0.25));
            let heavy = max_position_error(&recorder, 2, |t| place(0.01 + way(t), 0.05, 0.65));
            assert!(light < 1e-12 && heavy < 1e-12, "{tilt}, {turn}, 1e{exponent}: {light:e} m, {heavy:e} m");
        }
    }
}

/// Size of the boxes of a stack, m.
const FLAT: DVec3 = DVec3::new(1.0, 0.6, 0.2);

/// A stack of boxes of these masses (the lowest first) at rest on a rough slope (rad), each turned by `twist` (rad)
/// about the normal to the one below it. Whether it is at rest after the first instant, and the residual of its forces.
fn rests(masses: &[f64], (angle, azimuth, twist): (f64, f64, f64)) -> (bool, f64) {
    let (plane, material) = (slope(angle, azimuth), rough(0.5));
    let boxes = masses.iter().enumerate().map(|(level, &mass)| {
        let turned = Rotation::from_rotation_vector(DVec3::Z * (twist * level as f64));
        let pose = Pose::new(turned, DVec3::Z * (FLAT.z * (level as f64 + 0.5)));
        heavy_brick(&format!("box {level}"), mass, FLAT, DVec3::ZERO).pose(pose)
    });
    let on_plane = |body: Body| {
        let pose = *body.initial_pose();
        let pose = Pose::new(plane * pose.rotation, plane.rotate(pose.translation));
        body.pose(pose).material(material.clone())
    };
    let normal = UnitVector::new(plane.rotate(DVec3::Z)).unwrap();
    let ground = Body::fixed("ground").geometry(Shape::half_space(normal).into()).material(material.clone());
    let scene = Scene::builder("stack").method(accurate()).body(ground);
    let scene = boxes.fold(scene, |scene, body| scene.body(on_plane(body)));
    let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
    simulation.step().unwrap();
    let still = simulation.bodies().iter().all(|body| body.velocity == Velocity::ZERO);
    (still && simulation.time() >= 1e-3, simulation.frame().certificate.max_residual)
}

/// Stacks of boxes whose masses rise, fall or alternate by factors up to 1e6 are put to rest at once on slopes on which
/// the least forces leave the cones of friction. (From a ratio of 1e4 those with heavy boxes on light ones were not,
/// and stood by slow time steps; residuals were up to 8 eps times the ratio.)
#[test]
fn stacks_of_unlike_boxes_rest_on_slopes_at_once() {
    for exponent in [0, 2, 4, 6] {
        let ratio = 10.0_f64.powi(exponent);
        let rising: Vec<f64> = (0..5).map(|level| ratio.powf(0.25 * f64::from(level))).collect();
        let falling: Vec<f64> = rising.iter().rev().copied().collect();
        for masses in [rising, falling, vec![1.0, 1.0, 1.0, 1.0, ratio], vec![1.0, ratio, 1.0, ratio, 1.0]] {
            for placing in [(0.1, 0.0, 0.0), (0.25, 0.0, 0.0), (0.25, 0.6, 0.0), (0.25, 0.6, 0.1)] {
                let (rests, residual) = rests(&masses, placing);
                assert!(rests, "{masses:?} at {placing:?} stands");
                assert!(residual <= 1e-12, "{masses:?} at {placing:?}: residual {residual:e}");
            }
        }
    }
}

/// A stack with a heavy box on top stands as long as gravity through its centre of mass meets its base, to a thousandth
/// of the slope's tangent, and falls beyond, at every mass ratio.
#[test]
fn a_stack_stands_until_its_weight_leaves_the_base() {
    for exponent in [0, 2, 4, 6] {
        let masses: Vec<f64> = (0..10).map(|level| if level == 9 { 10.0_f64.powi(exponent) } else { 1.0 }).collect();
        let moment: f64 = masses.iter().enumerate().map(|(level, mass)| mass * FLAT.z * (level as f64 + 0.5)).sum();
        let limit = 0.5 * FLAT.x * masses.iter().sum::<f64>() / moment;
        for (part, stands) in [(0.999, true), (1.001, false)] {
            let (rests, _) = rests(&masses, ((part * limit).atan(), 0.0, 0.0));
            assert_eq!(rests, stands, "1e{exponent}: {part} of the slope on which it tips over");
        }
    }
}

/// Boxes of one material that lie on each other slide down a slope as one, by `g (sin - mu cos)`, and none on another,
/// whichever of them is heavy: from rest, and with a speed. (With a heavy box on light ones they slid on each other, by
/// up to 9e-4 of the way.)
#[test]
fn stacks_of_unlike_boxes_slide_as_one() {
    let (friction, duration_s): (f64, f64) = (0.3, 0.4);
    for masses in [[1.0, 1e3, 1e6], [1e6, 1e3, 1.0], [1.0, 1.0, 1e-3], [1e4, 1e-3, 1.0]] {
        for (angle, azimuth, speed) in [(0.35, 0.0, 0.0), (0.5, 0.6, 0.0), (0.5, 0.6, 0.1), (0.0, 0.2, 2.0)] {
            let (plane, material) = (slope(angle, azimuth), rough(friction));
            let normal = UnitVector::new(plane.rotate(DVec3::Z)).unwrap();
            let ground = Body::fixed("ground").geometry(Shape::half_space(normal).into()).material(material.clone());
            let scene = Scene::builder("sliding stack").method(accurate()).duration_s(duration_s).body(ground);
            let height = |level: usize| FLAT.z * (level as f64 + 0.5);
            let scene = masses.iter().enumerate().fold(scene, |scene, (level, &mass)| {
                let pose = Pose::new(plane, plane.rotate(DVec3::Z * height(level)));
                let velocity = Velocity::new(plane.rotate(DVec3::X * speed), DVec3::ZERO);
                let body = heavy_brick(&format!("box {level}"), mass, FLAT, DVec3::ZERO).pose(pose).velocity(velocity);
                scene.body(body.material(material.clone()))
            });
            let (report, recorder) = run(&scene.build().unwrap(), Effects::Planned);
            assert!(report.crowded.is_empty() && report.steps <= 60, "{masses:?}, {angle}: {} steps", report.steps);
            let acceleration = 9.81 * (angle.sin() - friction * angle.cos());
            for level in 0..masses.len() {
                let place = |t: f64| {
                    let way = speed * t + 0.5 * acceleration * t * t;
                    plane.rotate(DVec3::new(way, 0.0, height(level)))
                };
                let error = max_position_error(&recorder, level + 1, place);
                assert!(
                    error < 1e-11,
                    "{masses:?} at {angle}, {azimuth} with {speed} m/s: box {level} is off by {error:e} m"
                );
            }
        }
    }
}

/// A heavy box that falls tilted onto a light plate, on which it rocks and slides, loses energy and no number. (Steps
/// became as short as the spacing of times, and the bounds of the motion within them were infinite: the run ended in an
/// error at ratios of 1e5 and 1e6, by some units in the last place of the mass.) The heavy box's impulses cancel on the
/// plate, whose velocities they change by their rounding: the books close to that, some units in the last place for
/// each unit of the ratio of masses.
#[test]
fn a_heavy_box_that_falls_tilted_on_a_light_plate_comes_to_an_end() {
    for ratio in [1e3, 1e5, 1e6] {
        let place = DVec3::new(0.05, 0.02, 0.7);
        let tilt = Rotation::from_rotation_vector(DVec3::new(0.2, 0.1, 0.1));
        let rough = || rough(0.5);
        let scene = Scene::builder("heavy on light")
            .method(accurate())
            .duration_s(0.6)
            .body(floor().material(rough()))
            .body(dense_brick("plate", 12.5, DVec3::new(1.0, 0.8, 0.1), DVec3::Z * 0.05).material(rough()))
            .body(
                dense_brick("box", 8.0 * ratio, DVec3::splat(0.5), place)
                    .pose(Pose::new(tilt, place))
                    .material(rough()),
            );
        let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
        let heights = report.bodies.iter().map(|polhode::ReportedBody { state, .. }| state.pose.translation.z);
        assert!(heights.fold(0.0, f64::max) < place.z, "{ratio:e}: {report:?}");
        let (first, last) = (report.energy.initial_j, report.energy.final_j);
        assert!(last < first, "{ratio:e}: the energy went from {first} J to {last} J");
        let rounding = 4.0 * f64::EPSILON * ratio;
        assert!(report.ledger.closure_relative() < rounding.max(1e-12), "{ratio:e}: {:?}", report.ledger);
    }
}

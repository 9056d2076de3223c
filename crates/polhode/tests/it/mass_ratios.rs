//! Light bodies that carry heavy ones in the tier `accurate`: neither steps nor accuracy depend on the mass ratio.

use crate::checks::{heavy_brick, max_position_error};
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
    let report = Simulation::new(&scene.build().unwrap(), Effects::Planned).unwrap().run(&mut recorder).unwrap();
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

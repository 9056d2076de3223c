//! A time step whose problems are not all solved is made again as two halves: a heap of dropped boxes, one step of
//! which the solver does not solve to 1e-8, keeps that residual in every step. Failure: halves may be as hard; then the
//! better of both is taken, and what is left is told.

use crate::stepped::stepped;
use crate::support::{brick, floor};
use polhode::scene::Material;
use polhode::spatial::{DVec3, Pose, Rotation};
use polhode::{Scene, Simulation};

/// The residual that the tier promises.
const PROMISED: f64 = 1e-8;

/// So many boxes of any attitude, which fall on each other and on a floor.
fn dropped(boxes: u32, step_s: f64) -> Scene {
    let rough = Material::new("rough").with_friction(0.5).unwrap();
    let scene = Scene::builder("dropped").method(stepped(step_s)).duration_s(2.0);
    let mut scene = scene.body(floor().material(rough.clone()));
    let side = 0.6 * (f64::from(boxes) / 20.0).cbrt();
    for number in 0..boxes {
        let spread = |prime: f64| (prime.sqrt() * f64::from(number + 1)).fract() - 0.5;
        let place = DVec3::new(spread(2.0) * side, spread(3.0) * side, 0.2 + 0.2 * f64::from(number));
        let attitude = Rotation::from_rotation_vector(DVec3::new(spread(7.0), spread(11.0), spread(13.0)) * 6.0);
        let body = brick(&format!("box {number}"), DVec3::new(0.12, 0.1, 0.08), place);
        scene = scene.body(body.pose(Pose::new(attitude, place)).material(rough.clone()));
    }
    scene.build().unwrap()
}

#[test]
fn a_step_that_is_not_solved_is_solved_as_two_halves() {
    // Whole steps alone would leave 1.0e-7 and 6.7e-7.
    for (boxes, step_s) in [(20, 1.09 / 60.0), (28, 1.06 / 60.0)] {
        let report = Simulation::new(&dropped(boxes, step_s)).unwrap().run().unwrap();
        assert!(report.certificate.max_residual <= PROMISED, "{boxes} boxes: {:?}", report.certificate);
    }
}

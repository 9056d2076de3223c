//! The work-precision table: attitude error against number of steps, for every method.
//!
//! I = (1, 2, 3), p(0) = (0.4, 1.6, 1.2), T = 10 s, against the closed form. The columns are those of an independent
//! prototype of each method; agreement within a factor of two shows that the error constant is right, not only the
//! order. An error below the floor of round-off (1e-13 after ten turns) is compared with the floor.

use crate::stepping::{METHODS, Scene, method};
use crate::support::body;
use glam::DVec3;
use polhode_dynamics::{BodyState, FreeRotation};
use polhode_spatial::Rotation;

const MOMENTS: DVec3 = DVec3::new(1.0, 2.0, 3.0);
const MOMENTUM: DVec3 = DVec3::new(0.4, 1.6, 1.2);
const DURATION: f64 = 10.0;
const FLOOR: f64 = 1e-13;

/// Attitude errors (rad) at 100, 400, 1600 steps and the relative energy error at the end of 1600.
const TABLE: [(&str, [f64; 3], f64); 13] = [
    ("explicit-euler", [3.4e-1, 8.4e-2, 2.1e-2], 8e-3),
    ("semi-implicit-euler", [3.3e-1, 8.1e-2, 2.0e-2], 8e-3),
    ("implicit-gyroscopic", [3.2e-1, 8.3e-2, 2.1e-2], 8e-3),
    ("rk4", [3.4e-6, 1.4e-8, 5.5e-11], 2e-12),
    ("rkmk4", [1.6e-6, 7.7e-9, 3.2e-11], 1e-12),
    ("cf4", [4.3e-6, 1.7e-8, 6.5e-11], 1e-12),
    ("splitting", [9.8e-4, 6.2e-5, 3.8e-6], 7e-9),
    ("splitting-4 (Yoshida)", [6.6e-6, 2.6e-8, 1.0e-10], 4e-12),
    ("splitting-4", [9.7e-8, 3.8e-10, 1.4e-12], 1e-13),
    ("splitting-6", [3.7e-9, 9.2e-13, FLOOR], FLOOR),
    ("implicit-midpoint", [9.8e-3, 6.1e-4, 3.8e-5], 1e-15),
    ("moser-veselov", [1.6e-2, 1.0e-3, 6.2e-5], 3e-15),
    ("moser-veselov-4", [9.8e-6, 3.8e-8, 1.5e-10], 2e-15),
];

#[test]
fn errors_are_those_of_the_table() {
    let start = BodyState { angular_momentum: MOMENTUM, ..BodyState::default() };
    let scene = Scene::free(&body(1.0, MOMENTS), start);
    let exact = FreeRotation::new(MOMENTS, Rotation::IDENTITY, MOMENTUM).at(DURATION);
    assert_eq!(METHODS.map(|(name, _)| name), TABLE.map(|(name, ..)| name));
    for (name, errors, energy) in TABLE {
        let measured = [100, 400, 1600].map(|steps| {
            let end = scene.run(&mut *method(name), DURATION, steps);
            end[0].pose.rotation.angle_to(exact)
        });
        let before = scene.bodies[0].rotational_energy(&start);
        let end = scene.run(&mut *method(name), DURATION, 1600);
        let gain = (scene.bodies[0].rotational_energy(&end[0]) / before - 1.0).abs();
        let row = measured.map(|error| format!("{error:9.2e}")).join(" ");
        println!("{name:22} {row}  energy {gain:.1e} (table {energy:.0e})");
        for (measured, table) in measured.into_iter().zip(errors).chain([(gain, energy)]) {
            let ratio = measured.max(FLOOR) / table.max(FLOOR);
            assert!((0.5..=2.0).contains(&ratio), "{name}: {measured:e}, table {table:e}");
        }
    }
}

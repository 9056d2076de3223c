//! A spinning plate thrown up that wobbles: its axis goes round the direction of its angular momentum at the rate `L /
//! I`, I the moment about a diameter, which is twice as fast as the plate spins (Feynman's plate in the canteen).

use polhode_dynamics::{DVec3, FreeRotation, Rotation};
use std::f64::consts::PI;

fn main() {
    let moments = DVec3::new(1.0, 1.0, 2.0);
    let spin = DVec3::new(0.1, 0.0, 10.0);
    let momentum = moments * spin;
    let plate = FreeRotation::new(moments, Rotation::IDENTITY, momentum);
    let period = 2.0 * PI * moments.x / momentum.length();
    println!("the axis goes round in {period:.4} s, the plate in {:.4} s", 2.0 * PI / spin.z);
    // After half a period the axis is on the other side of the momentum, after a whole one where it was.
    let momentum = momentum.normalize();
    let opposite = momentum * (2.0 * momentum.z) - DVec3::Z;
    assert!((plate.at(0.5 * period).rotate(DVec3::Z) - opposite).length() < 1e-15);
    assert!((plate.at(period).rotate(DVec3::Z) - DVec3::Z).length() < 1e-15);
}

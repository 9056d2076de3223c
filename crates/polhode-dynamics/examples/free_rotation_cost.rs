//! A fixed amount of free rotation, for counting instructions exactly:
//! `valgrind --tool=cachegrind --cache-sim=no target/release/examples/free_rotation_cost`.
//! Prints the attitude it ends with, so that nothing is optimised away.

use polhode_dynamics::FreeRotation;
use polhode_dynamics::exact_rotation::drift;
use polhode_spatial::{DVec3, Rotation};

fn main() {
    let (moments, momentum) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.4, 1.6, 1.2));
    let mut attitude = Rotation::IDENTITY;
    // Twenty thousand short drifts by Taylor series, then as many long ones by elliptic functions.
    for h in [0.05, 5.0] {
        for _ in 0..20_000 {
            attitude = drift(moments, attitude, momentum, h);
        }
    }
    let record = FreeRotation::new(moments, attitude, momentum);
    let mut sum = 0.0;
    for k in 0..20_000 {
        sum += record.at(f64::from(k)).quaternion().w;
    }
    println!("{:?} {sum}", attitude.to_wxyz());
}

//! A hundred thousand free rotations of one kind, for counting instructions exactly:
//! `valgrind --tool=cachegrind --cache-sim=no target/release/examples/free_rotation_cost KIND H`, where H is the time
//! of one rotation (s; the body turns at about 1.3 rad/s) and KIND is
//!
//! | kind | what |
//! |---|---|
//! | `none` | the loop alone |
//! | `rk4` | a step of RK4 on (q, L), written by hand |
//! | `drift` | the exact rotation from nothing but the state |
//! | `prepare` | the record of a flight |
//! | `record` | the exact rotation from such a record |
//!
//! Prints a sum of what it computed, so that nothing is optimised away.

use polhode_dynamics::exact_rotation::drift;
use polhode_dynamics::{DVec3, FreeRotation, Rotation};
use std::hint::black_box;

#[path = "../benches/support/rk4_of_one_body.rs"]
mod rk4_of_one_body;

const COUNT: u32 = 100_000;

fn main() {
    let kind = std::env::args().nth(1).unwrap_or_else(|| "drift".into());
    let h: f64 = std::env::args().nth(2).and_then(|h| h.parse().ok()).unwrap_or(0.05);
    let (moments, momentum) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.4, 1.6, 1.2));
    let record = FreeRotation::new(moments, Rotation::IDENTITY, momentum);
    let inverse = moments.recip();
    let mut attitude = Rotation::IDENTITY;
    let mut sum = 0.0;
    for _ in 0..COUNT {
        let (a, h) = (black_box(attitude), black_box(h));
        attitude = match kind.as_str() {
            "rk4" => Rotation::renormalized(rk4_of_one_body::step(inverse, a.quaternion(), momentum, h)),
            "drift" => drift(moments, a, momentum, h),
            "prepare" => black_box(FreeRotation::new(moments, a, momentum)).at(0.0),
            "record" => black_box(&record).at(h),
            _ => a,
        };
        sum += attitude.quaternion().w;
    }
    println!("{kind} {h}: {sum}");
}

//! The survey of tests/it/random_rotations.rs at any count:
//! `cargo run --release -p polhode-dynamics --example free_rotation_survey -- COUNT [LONG_COUNT [KIND]]`.
//!
//! COUNT rotations of each kind of body with `|w| h` up to 10 (10,000 take a minute in all), LONG_COUNT with `|w| h` up
//! to 1000 (a second each: the oracle is slow). Prints the largest errors, the index of the worst case and its numbers.
#![allow(dead_code, reason = "shares the oracle of the tests, of which it needs a part")]
#![allow(clippy::unwrap_used, reason = "the oracle of the tests may")]

#[path = "../tests/it/exact_flow.rs"]
mod exact_flow;
#[path = "../tests/it/fixed_point.rs"]
mod fixed_point;
#[path = "../tests/it/random_bodies.rs"]
mod random_bodies;

use random_bodies::{KINDS, LONG, SHORT, case, long_survey, survey};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |k: usize, default: u64| arguments.get(k).and_then(|n| n.parse().ok()).unwrap_or(default);
    for kind in KINDS {
        let name = format!("{kind:?}");
        if arguments.get(2).is_some_and(|only| *only != name) {
            continue;
        }
        let worst = survey(kind, number(0, 100));
        println!(
            "{name:13} {:6} cases: attitude {:.1e} rad, momentum {:.1e}",
            worst.count, worst.attitude, worst.momentum
        );
        println!("    worst is {}: {:?}", worst.index, case(kind, worst.index, SHORT));
        let worst = long_survey(kind, number(1, 0));
        if worst.count > 0 {
            let [attitude, momentum] = worst.conditioned;
            println!(
                "    long: {} cases: attitude {attitude:.2}, momentum {momentum:.2} x 2^-53 x condition",
                worst.count
            );
            println!("    worst is {}: {:?}", worst.index, case(kind, worst.index, LONG));
        }
    }
}

//! The two ways to the exact rotation agree, on ten thousand random rotations of every kind of difficulty. They share
//! nothing but the canonical form: one sums a power series in time, the other evaluates elliptic functions.

use crate::support::cases;
use glam::DVec3;
use polhode_dynamics::FreeRotation;
use polhode_spatial::Rotation;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;

/// Longest turn that the test asks of the series; beyond it substeps would chain its rounding.
const LONGEST_SUBSTEP: f64 = 0.6;

const CASES_OF_A_KIND: u32 = 2000;

/// Attitude after `h` by the Taylor series in substeps.
fn by_taylor(moments: DVec3, momentum: DVec3, h: f64) -> Option<Rotation> {
    let fastest = FreeRotation::new(moments, Rotation::IDENTITY, momentum).angular_speed_bound();
    let steps = (fastest * h.abs() / LONGEST_SUBSTEP).ceil().max(1.0);
    let mut attitude = Rotation::IDENTITY;
    for _ in 0..steps as usize {
        attitude = FreeRotation::new(moments, attitude, momentum).at_by_taylor(h / steps)?;
    }
    Some(attitude)
}

/// A moment of each of the three, difficult in one of five ways, and a momentum.
fn rotation_of(kind: usize) -> impl Strategy<Value = (DVec3, DVec3, f64)> {
    let numbers = ([0.0..1.0f64, 0.0..1.0, 0.0..1.0], [-1.0..1.0f64, -1.0..1.0, -1.0..1.0], [0.0..1.0f64, 0.0..1.0]);
    numbers.prop_filter_map("not a body or not a rotation", move |(r, p, s)| {
        let generic = r.map(|r| 10f64.powf(2.0 * r - 1.0));
        let (moments, p) = match kind {
            // Near a sphere.
            1 => (r.map(|r| 1.0 + 1e-3f64.powf(1.0 + 3.0 * s[0]) * r), p),
            // Near a symmetric top.
            2 => ([1.0, 1.0 + 10f64.powf(-14.0 * r[0]), 0.3 + 1.6 * r[1]], p),
            // Near the middle axis, so near the separatrix.
            3 => {
                let mut order = [0, 1, 2];
                order.sort_by(|a: &usize, b| generic[*a].total_cmp(&generic[*b]));
                let mut q = [0.0; 3];
                q[order[0]] = 10f64.powf(-12.0 * s[0]);
                q[order[1]] = 1.0;
                q[order[2]] = 10f64.powf(-12.0 * s[1]);
                (generic, q)
            }
            // Near any axis.
            4 => (generic, [p[0], p[1] * 10f64.powf(-14.0 * s[0]), p[2] * 10f64.powf(-14.0 * s[1])]),
            _ => (generic, p),
        };
        let (i, p) = (DVec3::from_array(moments), DVec3::from_array(p));
        let physical = i.x + i.y >= i.z && i.y + i.z >= i.x && i.z + i.x >= i.y;
        let fastest = p.length() / i.min_element();
        let h = (10.0 * s[0] / (p / i).length()).min(30.0 / fastest);
        (physical && p.length() > 1e-3).then_some((i, p, h))
    })
}

#[test]
fn ten_thousand_random_rotations_agree() {
    let kinds = ["generic", "near-spherical", "near-symmetric", "near-separatrix", "near-axis"];
    for (kind, name) in kinds.into_iter().enumerate() {
        let worst = std::cell::Cell::new((0.0f64, 0.0f64));
        let outcome = TestRunner::new(cases(CASES_OF_A_KIND)).run(&rotation_of(kind), |(moments, momentum, h)| {
            let rotation = FreeRotation::new(moments, Rotation::IDENTITY, momentum);
            let Some(elliptic) = rotation.at_by_elliptic_functions(h) else { return Ok(()) };
            let taylor = by_taylor(moments, momentum, h);
            prop_assert!(taylor.is_some(), "the series does not converge");
            let angle = taylor.map_or(f64::NAN, |taylor| elliptic.angle_to(taylor));
            let momenta = [elliptic, taylor.unwrap_or_default()].map(|r| r.inverse_rotate(momentum));
            let difference = (momenta[0] - momenta[1]).length() / momentum.length();
            worst.set((worst.get().0.max(angle), worst.get().1.max(difference)));
            prop_assert!(angle < 1e-13, "attitudes differ by {angle:e}");
            prop_assert!(difference < 5e-14, "momenta differ by {difference:e}");
            Ok(())
        });
        assert!(outcome.is_ok(), "{name}: {outcome:?}");
        println!("{name}: attitudes within {:.1e} rad, momenta within {:.1e}", worst.get().0, worst.get().1);
    }
}

//! The exact rotation against the oracle of 30 digits, over random bodies of every kind that is hard for some method.
//!
//! Up to `|w| h = 10` the errors must stay below fixed limits; the measured ones are a tenth of them. Beyond, to
//! `|w| h = 1000`, no method in doubles can do better than what the rounding of its arguments does to the result: the
//! errors are held against the flow's own condition number. The full survey (a hundred times as many) is
//! examples/free_rotation_survey.rs.

use crate::exact_flow::flow;
use crate::random_bodies::{KINDS, Kind, case, long_survey, survey};
use glam::DVec3;
use polhode_dynamics::exact_rotation::drift;
use polhode_spatial::Rotation;

/// One in a hundred of the full survey of 10,000 cases of each kind.
const CASES_OF_A_KIND: u64 = 100;
/// One in a hundred of the full survey of 100 of each kind, for which the oracle takes its time.
const LONG_CASES_OF_A_KIND: u64 = 1;

#[test]
fn drifts_are_exact_whatever_the_body() {
    for kind in KINDS {
        let worst = survey(kind, CASES_OF_A_KIND);
        println!("{kind:?}: attitude {:.1e} rad, momentum {:.1e}", worst.attitude, worst.momentum);
        let limit = if kind == Kind::Generic { 5e-14 } else { 1e-13 };
        assert!(worst.attitude < limit, "{kind:?} {}: attitude off by {:e} rad", worst.index, worst.attitude);
        assert!(worst.momentum < 5e-14, "{kind:?}: momentum off by {:e}", worst.momentum);
    }
}

#[test]
fn long_drifts_are_as_exact_as_their_arguments() {
    for kind in KINDS {
        let worst = long_survey(kind, LONG_CASES_OF_A_KIND);
        let [attitude, momentum] = worst.conditioned;
        println!("{kind:?}: attitude {attitude:.2}, momentum {momentum:.2} x 2^-53 x condition number");
        assert!(attitude < 4.0, "{kind:?} {}: attitude off by {attitude} times", worst.index);
        assert!(momentum < 4.0, "{kind:?}: momentum off by {momentum} times");
    }
}

/// A short turn is right relative to its own size: the error of a thousandth of a radian is a thousandth of round-off.
#[test]
fn short_turns_are_exact_relative_to_their_size() {
    for kind in KINDS {
        for index in 0..CASES_OF_A_KIND {
            let case = case(kind, index, (1e-9, 1e-2));
            let DVec3 { x, y, z } = case.momentum / case.moments * case.h;
            // The turn may be quicker than at the start where a component has far to go; the largest is of its size.
            let turn = x.abs().max(y.abs()).max(z.abs());
            let truth = flow(case.moments, case.momentum, case.h);
            let error = truth.attitude_error(drift(case.moments, Rotation::IDENTITY, case.momentum, case.h));
            assert!(error < 8.0 * f64::EPSILON * turn, "{kind:?} {index}: {error:e} rad of {turn:e}");
        }
    }
}

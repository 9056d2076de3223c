//! What historical and approximate methods are known to err by, each with its reason: values that are expected of them.
//!
//! Such a row says what the method errs by, and passes when it errs as stated: a method of the thesis that were exact
//! all of a sudden would be another method. It is no defect of the project, which is why it does not stand in
//! `known.rs`.

use polhode_cases::row::{Row, Tolerance};

/// A row of a method that errs.
#[derive(Debug)]
struct Finding {
    case: &'static str,
    /// What the row's quantity begins with.
    quantity: &'static str,
    /// What it errs by, in the unit of the row.
    error: f64,
    reason: &'static str,
}

/// How exactly a method errs as stated (relative).
const AS_STATED: Tolerance = Tolerance::Relative(1e-2);

/// Why the thesis's heuristic finds other accelerations than the laws of contact.
const LEAST_FORCE_ERRS: &str = "the heuristic of the thesis: least force sits at the wrong contacts where a pile falls \
                                (errata E15), and the bound of its certificate says so";

/// Why the force that micro-collisions tell is not the weight at every time.
const COLLISIONS_IN_TURN: &str = "\
    forces are means of impulses over the last step, and what rests collides every second step or third: twice the \
    weight in the one, none in the other";

/// All of them.
const FINDINGS: &[Finding] = &[
    Finding {
        case: "rest by every way",
        quantity: "RC-04, 6-diamond without sides: accelerations: least-force",
        error: 2.247_933,
        reason: LEAST_FORCE_ERRS,
    },
    Finding {
        case: "rest by every way",
        quantity: "RC-04, 6-diamond without sides: accelerations: heuristic",
        error: 2.247_933,
        reason: LEAST_FORCE_ERRS,
    },
    Finding {
        case: "rest by every way",
        quantity: "RC-06, staircase s=0.4, n=5: accelerations: least-force",
        error: 0.883_583,
        reason: LEAST_FORCE_ERRS,
    },
    Finding {
        case: "rest by every way",
        quantity: "RC-06, staircase s=0.4, n=5: accelerations: heuristic",
        error: 0.883_583,
        reason: LEAST_FORCE_ERRS,
    },
    Finding {
        case: "rest by every way",
        quantity: "RC-01, 2-diamond: movement, m: tier penalty",
        error: 2.683e-3,
        reason: "three levels of springs give way, each by less than the stated penetration, and the top moves by the \
                 sum. Dampers of 35 times the critical strength, which springs at rest do not have any more, hid that \
                 for these 0.2 s",
    },
    Finding {
        case: "rest by every way",
        quantity: "RC-05, overhang of 3, 1 cm inside: movement, m: tier penalty",
        error: 4.055e-2,
        reason: "within a centimetre of its edge the whole stack stands on the springs of one side: they give way by \
                 the stated penetration, the others hardly, and the stack leans by some forty of them at its end",
    },
    Finding {
        case: "rest by every way",
        quantity: "RC-07, beam on pillars: sum of forces / weight: tier micro",
        error: 1.0,
        reason: COLLISIONS_IN_TURN,
    },
    Finding {
        case: "rest by every way",
        quantity: "RC-15, cubes: forces / weight of the top: tier micro",
        error: 0.418_260,
        reason: COLLISIONS_IN_TURN,
    },
    Finding {
        case: "rest by every way",
        quantity: "RC-17, table: force and moments / weight: tier micro",
        error: 1.0,
        reason: COLLISIONS_IN_TURN,
    },
];

/// Gives those of `rows` that are findings the values that are expected of them.
pub(crate) fn state(rows: &mut [Row]) {
    for row in rows {
        let is_of = |finding: &&Finding| row.case == finding.case && row.quantity.starts_with(finding.quantity);
        if let Some(finding) = FINDINGS.iter().find(is_of) {
            row.must_find(finding.error, AS_STATED, finding.reason);
        }
    }
}

#[cfg(test)]
mod tests {
    //! A method that errs as stated passes; one that errs more, or not at all, does not.
    use super::*;
    use polhode_cases::row::Verdict;

    #[test]
    fn a_method_errs_as_stated_or_fails() {
        let finding = &FINDINGS[0];
        let verdict = |error: f64| {
            let mut rows = [Row::at_most(finding.case, finding.quantity, 1e-9, error)];
            state(&mut rows);
            rows[0].verdict
        };
        let found = [finding.error, 2.0 * finding.error, 0.0, f64::NAN].map(verdict);
        assert_eq!(found, [Verdict::Ok, Verdict::Fails, Verdict::Fails, Verdict::Fails]);
    }
}

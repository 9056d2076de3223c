//! What unit impulses along the rows of contacts do, with all joints held.

use super::part::Part;
use crate::error::ResponseError;

/// For a unit impulse (1 N s) along each of some rows.
#[derive(Debug, Clone)]
pub(super) struct UnitReactions {
    /// The impulses of all rows, those of joints included, N s.
    pub(super) impulses: Vec<Vec<f64>>,
    /// The changes of velocity of all rows, m/s.
    pub(super) changes: Vec<Vec<f64>>,
}

impl UnitReactions {
    /// Along some rows of a part.
    pub(super) fn of(part: &mut Part, rows: impl Iterator<Item = usize>) -> Result<Self, ResponseError> {
        let (joints, zero) = (part.joints(), vec![0.0; part.contacts.rows()]);
        let (mut impulses, mut changes) = (Vec::new(), Vec::new());
        for row in rows {
            let mut unit = zero.clone();
            unit[row] = 1.0;
            let mut change = part.after(&zero, &unit);
            if !joints.is_empty() {
                let held = part.solve(&joints, &change, None)?;
                unit.iter_mut().zip(&held.impulses).for_each(|(total, impulse)| *total += impulse);
                change = part.after(&change, &held.impulses);
                if !held.is_solved {
                    part.not_solved();
                }
            }
            impulses.push(unit);
            changes.push(change);
        }
        Ok(Self { impulses, changes })
    }
}

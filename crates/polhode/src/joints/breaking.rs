//! Joints of the world that may break. Those that have broken hold nothing any more (`released.rs`).

use crate::constraint::ConstraintId;
use crate::joints::bilateral::{Bilateral, Reaction};
use crate::model::{Joints, Model};
use crate::scene::Strength;

impl Joints {
    /// Whether any joint of the scene may break.
    pub(crate) fn may_break(&self) -> bool {
        !self.breakable.is_empty()
    }

    /// Whether any joint of these bodies may break.
    pub(crate) fn may_break_among(&self, bodies: &[usize]) -> bool {
        self.may_break() && self.joints_among(bodies).any(|joint| self.breakable.contains(&joint.number()))
    }
}

/// The load at which a joint breaks; none of one that nothing breaks.
pub(crate) fn strength_of(model: &Model, joint: usize) -> Option<Strength> {
    model.scene.joints().get(joint)?.strength()
}

/// The joints that impulses of an impact (N s) break.
pub(crate) fn broken_by(model: &Model, impulses: &[(Bilateral, Reaction)]) -> Vec<usize> {
    let is_broken = |(of, impulse): &(Bilateral, Reaction)| match of.id {
        ConstraintId::Joint { joint, .. } => {
            let most = strength_of(model, joint)?.greatest_impulse();
            (impulse.force.length() >= most).then_some(joint)
        }
        _ => None,
    };
    if model.joints.may_break() { impulses.iter().filter_map(is_broken).collect() } else { Vec::new() }
}

//! The modes of a contact between two events: whether it sticks or slides, and whether its rotations are held or turn.

use super::friction_mode::FrictionMode;
use super::turn::RotationModes;

/// The modes of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct ContactModes {
    /// Whether it sticks or slides. None for a contact without friction, and where that is to be found from its forces.
    pub(crate) friction: Option<FrictionMode>,
    /// Its rotations, likewise.
    pub(crate) rotation: RotationModes,
}

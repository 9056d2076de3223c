//! A contact at one time with what of its forces statics leaves open.

use crate::report::frame::ContactView;

/// A contact that touches, and which of its forces are not unique.
///
/// Motion and resultants are unique; of single forces that statics does not determine (four legs on a floor) those of
/// least norm are told.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ContactSample {
    /// The contact, with its forces.
    pub view: ContactView,
    /// Whether other forces along normals hold the bodies as well.
    pub is_normal_open: bool,
    /// The same of friction.
    pub is_friction_open: bool,
}

impl ContactSample {
    /// What of it is not unique, in a word or three; empty where all is.
    pub const fn not_unique(&self) -> &'static str {
        match (self.is_normal_open, self.is_friction_open) {
            (false, false) => "",
            (true, false) => "normal",
            (false, true) => "friction",
            (true, true) => "normal and friction",
        }
    }
}

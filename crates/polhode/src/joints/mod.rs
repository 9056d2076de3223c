//! The joints of a model: whom they hold, what acts along their coordinates, and how they end.
//!
//! What a joint is stands in `constraint`; the functions here need the bodies of the model as well.
//!
//! | module | holds |
//! |---|---|
//! | `held`, `bilateral` | whom bilateral constraints hold, and their rows |
//! | `motors`, `soft_rows`, `joint_power` | motors and springs along coordinates, as rows, and what they give |
//! | `efforts` | what acts along coordinates, by its cause |
//! | `turns` | revolutions of angles |
//! | `ties` | gears and prescribed motions |
//! | `joint_contacts`, `joint_friction` | stops and dry friction: contacts at joints |
//! | `joint_error` | how far joints are from what they keep |
//! | `breaking`, `released`, `added` | joints that break, let go, or are added by a program |

pub(crate) mod added;
pub(crate) mod bilateral;
pub(crate) mod breaking;
pub(crate) mod efforts;
pub(crate) mod held;
pub(crate) mod joint_contacts;
pub(crate) mod joint_error;
pub(crate) mod joint_friction;
pub(crate) mod joint_power;
pub(crate) mod motors;
pub(crate) mod released;
pub(crate) mod soft_rows;
pub(crate) mod ties;
pub(crate) mod turns;

//! Identities: what bodies, joints, contacts and their parts are called in all of the crate.
//!
//! | module | holds |
//! |---|---|
//! | `body_id` | [`BodyId`](crate::BodyId): the handle of a body |
//! | `joint_id` | [`JointId`](crate::JointId): the handle of a joint |
//! | `contact_id` | `ContactId`: which bodies touch, and by what |
//! | `coordinate_id` | `CoordinateId`: a coordinate of a joint |
//! | `stop_id` | `StopId`: a stop of a joint |

pub(crate) mod body_id;
pub(crate) mod contact_id;
pub(crate) mod coordinate_id;
pub(crate) mod joint_id;
pub(crate) mod stop_id;

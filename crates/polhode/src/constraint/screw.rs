//! A screw: an axis of two bodies that stays one, and a displacement along it that goes with the rotation about it
//! (`thread.rs`).

use super::kept::Kept;
use super::thread::Thread;
use polhode_spatial::{DVec3, Rotation};

/// What a screw with this axis (unit vector, world) and lead (m for each revolution) keeps between bodies with these
/// attitudes.
pub(crate) fn kept((axis, lead): (DVec3, f64), attitudes: (Rotation, Rotation)) -> Kept {
    let (first, second) = axis.any_orthonormal_pair();
    let kept = Kept::along([first, second], attitudes.1).with_rotation([(axis, first), (axis, second)], attitudes);
    kept.with_thread(Thread::new((axis, lead), attitudes))
}

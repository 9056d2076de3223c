//! Forces in a space set otherwise.

use super::error::CopyError;
use crate::identity::body_id::BodyId;
use crate::scene::force::{Attachment, Force};
use polhode_dynamics::field::Frame;
use polhode_spatial::Isometry;

/// Force number `place` in a space set otherwise, on bodies of other numbers.
pub(super) fn moved(
    place: usize,
    force: &Force,
    space: &Isometry,
    number: impl Fn(BodyId) -> BodyId,
) -> Result<Force, CopyError> {
    let handedness = space.handedness();
    let attachment = |end: Attachment| match end {
        Attachment::World(point) => Attachment::World(space.point(point)),
        Attachment::Body { body, point } => Attachment::Body { body: number(body), point: handedness.vector(point) },
    };
    match *force {
        Force::PointGravity { center, mu } => Ok(Force::PointGravity { center: space.point(center), mu }),
        Force::MutualGravity { constant } => Ok(Force::MutualGravity { constant }),
        Force::Applied { body, force, torque, frame, point, ref signal } => {
            let (force, torque) = match frame {
                Frame::World => (space.vector(force), space.axial(torque)),
                Frame::Body => (handedness.vector(force), handedness.axial(torque)),
            };
            let point = point.map(|point| handedness.vector(point));
            Ok(Force::Applied { body: number(body), force, torque, frame, point, signal: signal.clone() })
        }
        Force::Drag { body, law, translational, rotational, wind } => {
            Ok(Force::Drag { body: number(body), law, translational, rotational, wind: space.vector(wind) })
        }
        Force::Spring { a, b, stiffness, rest_length, damping } => {
            Ok(Force::Spring { a: attachment(a), b: attachment(b), stiffness, rest_length, damping })
        }
        Force::Field(_) => Err(CopyError::Field(place)),
    }
}

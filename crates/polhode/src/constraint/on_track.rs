//! A joint on a track: what it keeps, and its stops. Free are the displacement along the curve and what of the body
//! does not turn with it.

use super::kept::Kept;
use super::stop::Stop;
use super::track::Guide;
use super::track_frame::Followed;
use crate::scene::{Follows, Joint, JointKind, TrackEnds, TrackHold};
use polhode_spatial::curve::Curve;
use polhode_spatial::{Rotation, UnitVector};
use std::sync::Arc;

/// The track of a joint whose second body has this attitude at the start; none of another kind, or of a track that does
/// not exist.
pub(crate) fn guide(joint: &Joint, tracks: &[Arc<Curve>], attitude: Rotation) -> Option<Guide> {
    let JointKind::Track { track, hold, .. } = joint.kind() else { return None };
    let towards = match hold {
        TrackHold::OneSide(side) => Some(side.towards.get()),
        TrackHold::Both(_) | TrackHold::Springs(_) => None,
    };
    Some(Guide::new(tracks.get(track.index())?, joint.anchor(), attitude, towards))
}

/// What of a body with this attitude at the start follows its track.
fn followed(guide: &Guide, follows: Follows, attitude: Rotation) -> Option<Followed> {
    let (up, rows) = match follows {
        Follows::Point => return None,
        Follows::Tangent => (None, 2),
        Follows::Frame { up } => (up, 3),
    };
    let reference = up.map_or(guide.plane_normal(), UnitVector::get);
    Some(Followed::new(reference, &guide.start(), attitude, rows))
}

/// What a track keeps of the motion of its body on another one with these attitudes at the start.
pub(crate) fn kept(guide: Option<&Arc<Guide>>, hold: TrackHold, (a, b): (Rotation, Rotation)) -> Kept {
    match (guide, hold) {
        (Some(guide), TrackHold::Both(follows)) => Kept::track(guide, followed(guide, follows, a)),
        (Some(guide), TrackHold::OneSide(_)) => Kept::along([guide.plane_normal()], b),
        (_, TrackHold::Springs(_)) | (None, _) => Kept::nothing(),
    }
}

/// The stops of a track: its side, and its ends.
pub(crate) fn stops(guide: &Arc<Guide>, kind: JointKind) -> Vec<Stop> {
    let JointKind::Track { hold, ends, .. } = kind else { return Vec::new() };
    let side = match hold {
        TrackHold::OneSide(side) => Some(Stop::one_side(guide, side.restitution)),
        TrackHold::Both(_) | TrackHold::Springs(_) => None,
    };
    let at_ends = match ends {
        TrackEnds::Stops(restitution) => guide.ends().map(|ends| Stop::at_ends(guide, ends, restitution)),
        TrackEnds::Free | TrackEnds::Straight => None,
    };
    side.into_iter().chain(at_ends.into_iter().flatten()).collect()
}

/// Whether a track holds nothing beyond its ends.
pub(crate) fn lets_go_at_ends(kind: JointKind) -> bool {
    matches!(kind, JointKind::Track { ends: TrackEnds::Free, .. })
}

/// How a track holds its body; none of another kind.
pub(crate) fn hold(kind: JointKind) -> Option<TrackHold> {
    if let JointKind::Track { hold, .. } = kind { Some(hold) } else { None }
}

//! Joints on tracks at the start: whether the track can hold the body as asked, and that the anchor lies on it.
//!
//! Within the digits of a file the anchor is moved onto the track, or of a track with one side into its plane; more is
//! refused.

use super::track::LEAST_SINE;
use super::{Follows, Joint, JointKind, OneSide, Scene, SceneError, TrackEnds, TrackHold, TrackSprings};
use polhode_spatial::DVec3;
use polhode_spatial::curve::{Curve, CurvePlane, CurvePoint};
use polhode_spatial::rounding;
use std::sync::Arc;

/// Places of a track at which its direction is compared with the one that is up.
const PLACES_ALONG: u32 = 1000;

impl Scene {
    /// The curves that bodies can be held to.
    pub fn tracks(&self) -> &[Arc<Curve>] {
        &self.tracks
    }

    /// Moves the anchors of joints onto their tracks, within the digits of a file.
    ///
    /// # Errors
    /// When one is farther off, or a track cannot hold a body as asked.
    pub(crate) fn place_on_tracks(&mut self) -> Result<(), SceneError> {
        let placed = self.joints.iter().enumerate().map(|(number, joint)| self.placed_on_track(number, joint));
        self.joints = placed.collect::<Result<_, _>>()?;
        Ok(())
    }

    /// A joint with its anchor on its track, if it has one.
    pub(crate) fn placed_on_track(&self, number: usize, joint: &Joint) -> Result<Joint, SceneError> {
        let JointKind::Track { track, hold, ends } = joint.kind() else { return Ok(*joint) };
        let refused = |reason| SceneError::Joint { number, reason };
        let curve =
            self.tracks.get(track.index()).ok_or_else(|| refused("it is on a track that the scene does not have"))?;
        if let TrackEnds::Stops(restitution) = ends
            && !(0.0..=1.0).contains(&restitution)
        {
            return Err(refused("the restitution at the ends of its track is not from 0 to 1"));
        }
        let anchor = joint.anchor();
        if !anchor.is_finite() {
            return Err(refused("its anchor has a component that is not finite: finite numbers are needed"));
        }
        let foot = curve.nearest(anchor);
        let is_beyond = !curve.is_closed() && !(0.0..=curve.length()).contains(&foot.arc);
        let way = anchor - foot.point;
        let off = |how, distance: f64| SceneError::OffTrack {
            number,
            how,
            distance_mm: 1e3 * distance,
            most_mm: 1e3 * rounding::DIGITS_OF_A_FILE * curve.length(),
        };
        if is_beyond && ends != TrackEnds::Straight {
            let beyond = (-foot.arc).max(foot.arc - curve.length());
            if beyond > rounding::DIGITS_OF_A_FILE * curve.length() {
                return Err(off("beyond an end of its track", beyond));
            }
        }
        match hold {
            TrackHold::Both(follows) => {
                check_frame(curve, follows, ends).map_err(refused)?;
                let distance = way.length();
                if distance > rounding::DIGITS_OF_A_FILE * curve.length() {
                    return Err(off("off its track", distance));
                }
                Ok(joint.at(foot.point))
            }
            TrackHold::OneSide(side) => {
                check_one_side(joint, side).map_err(refused)?;
                let across = normals(curve, &foot, side).ok_or_else(|| {
                    refused(
                        "its track has one side but lies in no plane, or the side points along the track or out of its \
                         plane: a curve in a plane, with a direction in that plane across the track, is needed",
                    )
                })?;
                let (beside, height) = (across.normal.dot(way), across.up.dot(way));
                let most = rounding::DIGITS_OF_A_FILE * curve.length();
                if beside.abs() > most {
                    return Err(off("beside the plane of its track", beside.abs()));
                }
                if height < -most {
                    return Err(off("on the wrong side of its track", -height));
                }
                let height = if height <= most { 0.0 } else { height };
                Ok(joint.at(if height == 0.0 { foot.point } else { anchor - across.normal * beside }))
            }
            TrackHold::Springs(springs) => {
                check_springs(joint, springs).map_err(refused)?;
                Ok(*joint)
            }
        }
    }
}

/// Directions at a place of a track with one side, unit vectors.
struct Across {
    normal: DVec3,
    /// To its side.
    up: DVec3,
}

fn normals(curve: &Curve, foot: &CurvePoint, side: OneSide) -> Option<Across> {
    /// Sine of the least angle between the side and the track (no unit, 1e-6 to 0.1): less is a mistake.
    const LEAST_SIDE: f64 = 1e-3;
    let towards = side.towards.get();
    let normal = match curve.plane() {
        CurvePlane::Plane(normal) => normal.get(),
        CurvePlane::Straight => foot.tangent.cross(towards).try_normalize()?,
        CurvePlane::None => return None,
    };
    let up = normal.cross(foot.tangent);
    let along = up.dot(towards);
    (along.abs() > LEAST_SIDE).then(|| Across { normal, up: up * along.signum() })
}

/// Whether a body can turn with a curve.
fn check_frame(curve: &Curve, follows: Follows, ends: TrackEnds) -> Result<(), &'static str> {
    let reference = match (follows, curve.plane()) {
        (Follows::Point, _) => return Ok(()),
        (Follows::Frame { up: Some(up) }, _) => Some(up.get()),
        (Follows::Frame { up: None }, CurvePlane::None) => {
            return Err("it is to follow the frame of a track in no plane: a direction that is up is needed");
        }
        (Follows::Tangent | Follows::Frame { up: None }, _) => None,
    };
    let bends_at_ends = || {
        [0.0, curve.length()]
            .iter()
            .any(|&arc| curve.at(arc).curvature.length() * curve.length() > rounding::DIGITS_OF_A_FILE)
    };
    let goes_on_straight = ends == TrackEnds::Straight && !curve.is_closed();
    if curve.curvature_jump().is_some() || (goes_on_straight && bends_at_ends()) {
        return Err(
            "the curvature of its track jumps, so that a body that turns with it would begin to turn at once: a \
             clothoid between the parts is needed, or a joint at each of two points of the body in the place of one \
             that follows the tangent",
        );
    }
    let is_along = |reference: DVec3| {
        let mut arcs = (0..=PLACES_ALONG).map(|k| curve.length() * f64::from(k) / f64::from(PLACES_ALONG));
        arcs.any(|arc| reference.cross(curve.at(arc).tangent).length() < LEAST_SINE)
    };
    if reference.is_some_and(is_along) {
        return Err(
            "the direction that is up is along its track at some place: one that is nowhere along it is needed",
        );
    }
    Ok(())
}

fn check_one_side(joint: &Joint, side: OneSide) -> Result<(), &'static str> {
    let own = joint.kind().coordinates().iter().filter_map(|&coordinate| joint.freedom(coordinate));
    if own.into_iter().any(|own| own.has_forces() || own.limits().is_some()) {
        return Err(
            "its track has one side and something acts along it: friction alone can act along a track that lets go",
        );
    }
    if (0.0..=1.0).contains(&side.restitution) {
        Ok(())
    } else {
        Err("the restitution of its track is not from 0 to 1")
    }
}

fn check_springs(joint: &Joint, springs: TrackSprings) -> Result<(), &'static str> {
    let TrackSprings { stiffness, damping, reach } = springs;
    if !(stiffness > 0.0 && stiffness.is_finite()) {
        return Err("the stiffness of its track is not a finite number above 0");
    }
    if !(damping >= 0.0 && damping.is_finite()) {
        return Err("the damping of its track is not a finite number of at least 0");
    }
    if reach.is_nan() || reach <= 0.0 {
        return Err("the reach of the springs of its track is not above 0");
    }
    let own = joint.kind().coordinates().iter().filter_map(|&coordinate| joint.freedom(coordinate));
    if own.into_iter().any(|own| own.friction().is_some()) {
        return Err("its track holds by springs and has friction: friction acts on a track that holds by a constraint");
    }
    Ok(())
}

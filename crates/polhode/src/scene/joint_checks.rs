//! Checks of a joint of a scene: that its bodies exist and can be held, and what acts along its coordinates. Whether
//! its bodies part at the start `constraint/at_start.rs` says; whether the tier solves for it, `tier/scene_checks.rs`.

use super::{Coordinate, Joint, JointKind, Scene, SceneError};
use polhode_spatial::rounding;

/// How far a distance at the start may be beyond its limit, relative to itself: rounding of the anchors (no unit, 1e-15
/// to 1e-9).
const START_AT_LIMIT: f64 = 1e-12;

impl Scene {
    /// Joints between bodies, or of bodies with the world.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// Checks one joint: that its bodies exist and can be held, and what acts along its coordinates.
    pub(crate) fn check_joint(&self, number: usize, joint: &Joint) -> Result<(), SceneError> {
        let refused = |reason| SceneError::Joint { number, reason };
        if let Some(unknown) = joint.bodies().find(|&body| body >= self.bodies.len()) {
            return Err(SceneError::UnknownBody(unknown));
        }
        if joint.other() == Some(joint.body()) {
            return Err(refused("it holds a body at itself: two bodies, or one and the world, are needed"));
        }
        if !(joint.anchor().is_finite() && joint.other_anchor().is_finite()) {
            return Err(refused("its anchor has a component that is not finite: finite numbers are needed"));
        }
        let mut bodies = joint.bodies().map(|body| &self.bodies[body]);
        if bodies.all(|body| body.is_fixed() || body.motion().is_some()) {
            return Err(refused("forces move none of its bodies: one at least must be movable"));
        }
        if let JointKind::Universal { axes: [first, second] } = joint.kind()
            && first.get().dot(second.get()).abs() > rounding::DIGITS_OF_A_FILE
        {
            return Err(refused(
                "its axes are not at right angles: two axes whose directions are perpendicular are needed",
            ));
        }
        if let JointKind::Screw { lead, .. } = joint.kind()
            && !(lead != 0.0 && lead.is_finite())
        {
            return Err(refused("its lead is zero or not finite: a displacement for each revolution is needed"));
        }
        check_limits(number, joint)?;
        let is_none = |&coordinate: &Coordinate| {
            let friction = joint.freedom(coordinate).and_then(|own| own.friction());
            friction.is_some_and(|friction| friction.effort() == 0.0 && friction.arm() == 0.0)
        };
        if joint.kind().coordinates().iter().any(is_none) {
            return Err(refused("its friction has neither an effort nor a bearing: one of both is needed"));
        }
        let is_driven = joint.bodies().any(|body| self.bodies[body].motion().is_some());
        let has_forces = |&coordinate: &Coordinate| joint.freedom(coordinate).is_some_and(|own| own.has_forces());
        if is_driven && joint.kind().coordinates().iter().any(has_forces) {
            return Err(SceneError::NotYetAvailable {
                what: format!("a spring, damper or motor of joint {number} on a kinematic body"),
                instead: "one between bodies that forces move, or to the world".to_owned(),
            });
        }
        Ok(())
    }
}

/// Checks the limits of a joint: that it has such coordinates, and that they are within their limits at the start.
fn check_limits(number: usize, joint: &Joint) -> Result<(), SceneError> {
    let refused = |reason| SceneError::Joint { number, reason };
    let own = joint.kind().coordinates();
    for coordinate in Coordinate::ALL {
        let Some(freedom) = joint.freedom(coordinate) else { continue };
        if !own.contains(&coordinate) {
            return Err(refused(
                "something acts along a coordinate that it does not leave free: a hinge has an angle, a slider a \
                 displacement, a cylindrical joint both, a rope a distance",
            ));
        }
        let Some(limits) = freedom.limits() else { continue };
        let (lower, upper) = (limits.lower(), limits.upper());
        // An angle is known up to whole revolutions.
        if coordinate == Coordinate::Angle && upper - lower >= 2.0 * std::f64::consts::PI {
            return Err(refused(
                "its angle has no range below one revolution: two limits less than 2 pi apart are needed",
            ));
        }
        let start = match coordinate {
            Coordinate::Angle | Coordinate::Displacement => 0.0,
            Coordinate::Distance => (joint.anchor() - joint.other_anchor()).length(),
        };
        let rounding = START_AT_LIMIT * start;
        if !(lower - rounding..=upper + rounding).contains(&start) {
            let (name, unit) = (coordinate.name(), coordinate.unit());
            return Err(SceneError::JointBeyondLimits { number, coordinate: name, unit, start, lower, upper });
        }
    }
    match joint.kind() {
        JointKind::Rod { to } if to == joint.anchor() => {
            Err(refused("its anchors are one point: a rod between two points is needed, or a ball joint"))
        }
        JointKind::Rope { .. } if joint.limits(Coordinate::Distance).is_none() => {
            Err(refused("it has no length: limits of its distance are needed"))
        }
        _ => Ok(()),
    }
}

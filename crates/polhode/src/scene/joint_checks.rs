//! Checks of the joints of a scene: that their bodies exist and can be held, that they do not part at the start, and that the
//! method solves for them.

use super::{Body, Integrator, Joint, JointKind, Scene, SceneError, Tier};
use polhode_spatial::Velocity;

/// Relative velocity at a joint at the start, relative to the speeds of its bodies there: more than rounding of a file's digits
/// is a contradiction (no unit, 1e-12 to 1e-6).
const JOINT_VELOCITY_RELATIVE: f64 = 1e-9;

impl Scene {
    /// Joints between bodies, or of bodies with the world.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// Checks the joints: that their bodies exist and can be held, and do not leave them at the start.
    ///
    /// # Errors
    /// With the first joint that is refused.
    pub(super) fn check_joints(&self) -> Result<(), SceneError> {
        for (number, joint) in self.joints.iter().enumerate() {
            let refused = |reason| SceneError::Joint { number, reason };
            if let Some(unknown) = joint.bodies().find(|&body| body >= self.bodies.len()) {
                return Err(SceneError::UnknownBody(unknown));
            }
            if joint.other() == Some(joint.body()) {
                return Err(refused("it holds a body at itself: two bodies, or one and the world, are needed"));
            }
            if !joint.anchor().is_finite() {
                return Err(refused("its anchor has a component that is not finite: finite numbers are needed"));
            }
            let mut bodies = joint.bodies().map(|body| &self.bodies[body]);
            if joint.bodies().any(|body| self.bodies[body].motion().is_some()) {
                return Err(refused("it holds a body with a prescribed motion, which is not yet available"));
            }
            if bodies.all(Body::is_fixed) {
                return Err(refused("forces move none of its bodies: one at least must be movable"));
            }
            self.check_joint_velocity(number, joint)?;
        }
        Ok(())
    }

    /// Checks that the method solves for joints.
    ///
    /// # Errors
    /// When its tier or its integrator does not.
    pub(super) fn check_joint_method(&self) -> Result<(), SceneError> {
        if self.joints.is_empty() {
            return Ok(());
        }
        match (self.method.tier.unwrap_or(Tier::Accurate), self.method.integrator) {
            (Tier::Thesis, _) => Err(SceneError::JointsInTier { tier: "thesis" }),
            (Tier::Stepped, _) | (Tier::Accurate, None | Some(Integrator::Dop853 | Integrator::Rk4)) => Ok(()),
            (Tier::Accurate, Some(integrator)) => {
                Err(SceneError::JointsWithIntegrator { integrator: integrator.name() })
            }
        }
    }

    fn check_joint_velocity(&self, number: usize, joint: &Joint) -> Result<(), SceneError> {
        let velocity = |body: usize| {
            let own = &self.bodies[body];
            let Some(properties) = own.mass_properties() else { return Velocity::ZERO };
            let Velocity { linear, angular } = *own.initial_velocity();
            let center = own.initial_pose().transform_point(properties.center_of_mass());
            let linear = own.pivot_point().map_or(linear, |pivot| angular.cross(center - pivot));
            Velocity::new(linear + angular.cross(joint.anchor() - center), angular)
        };
        let [one, two] = [velocity(joint.body()), joint.other().map_or(Velocity::ZERO, velocity)];
        let speed = one.linear.length() + two.linear.length();
        let apart = (one.linear - two.linear).length();
        if apart > JOINT_VELOCITY_RELATIVE * speed {
            return Err(SceneError::JointMoves { number, apart_m_s: apart });
        }
        let turning = one.angular - two.angular;
        let across = match joint.kind() {
            JointKind::Ball => 0.0,
            JointKind::Hinge { axis } => axis.get().cross(turning).length(),
        };
        if across > JOINT_VELOCITY_RELATIVE * (one.angular.length() + two.angular.length()) {
            return Err(SceneError::JointTurns { number, across_rad_s: across });
        }
        Ok(())
    }
}

//! Checks of the joints of a scene: that their bodies exist and can be held, that they do not part at the start, and
//! that the method solves for them.

use super::{
    Coordinate, Freedom, Integrator, IntegratorChoice, Joint, JointKind, Response, Scene, SceneError, Tier, TierFeature,
};
use crate::constraint::joint::{HeldBody, ModelJoint};
use crate::constraint::row::RowKind;
use polhode_spatial::rounding;
use polhode_spatial::{Motion, Pose, Velocity};

/// How far a distance at the start may be beyond its limit, relative to itself: rounding of the anchors (no unit, 1e-15
/// to 1e-9).
const START_AT_LIMIT: f64 = 1e-12;

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
            self.check_joint(number, joint)?;
            self.check_joint_velocity(number, joint)?;
        }
        Ok(())
    }

    /// Takes a joint that a program adds to a simulation by this tier, between bodies as they are then. Returns it at
    /// its place: of a track on it.
    ///
    /// # Errors
    /// As [`SceneBuilder::build`](super::SceneBuilder::build), but that its bodies may move as it does not allow: it
    /// stops them.
    pub(crate) fn take_joint(&mut self, joint: &Joint, tier: Tier) -> Result<Joint, SceneError> {
        let number = self.joints.len();
        self.check_joint(number, joint)?;
        let placed = self.placed_on_track(number, joint)?;
        self.joints.push(placed);
        self.check_joints_in(tier)?;
        self.check_coordinates()?;
        self.check_motions()?;
        if tier.facts().own_response == Some(Response::Penalty) {
            self.check_springs()?;
        }
        Ok(placed)
    }

    /// Checks one joint: that its bodies exist and can be held, and what acts along its coordinates.
    fn check_joint(&self, number: usize, joint: &Joint) -> Result<(), SceneError> {
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

    /// Checks that the method solves for joints.
    ///
    /// # Errors
    /// When its tier or its integrator does not.
    pub(super) fn check_joint_method(&self) -> Result<(), SceneError> {
        if self.joints.is_empty() { Ok(()) } else { self.check_joints_in(self.method.named_tier().unwrap_or_default()) }
    }

    /// Checks that a tier solves for joints.
    fn check_joints_in(&self, tier: Tier) -> Result<(), SceneError> {
        let tier = tier.facts();
        match self.method.integrator {
            _ if !tier.takes(TierFeature::Joints) => {
                let instead = Tier::names_with(TierFeature::Joints);
                Err(SceneError::JointsInTier { tier: tier.name, instead })
            }
            _ if !tier.takes(TierFeature::AllOfJoints) => self.check_plain_joints(tier.name),
            None | Some(Integrator::Dop853 | Integrator::Rk4) => Ok(()),
            // A tier with an integrator of its own refuses all others.
            Some(_) if matches!(tier.integrator_choice, IntegratorChoice::Tier { .. }) => Ok(()),
            Some(integrator) => Err(SceneError::JointsWithIntegrator { integrator: integrator.name() }),
        }
    }

    /// Checks that joints have nothing beside what they hold, and limits of their coordinates.
    ///
    /// # Errors
    /// With the first joint that has.
    fn check_plain_joints(&self, tier: &str) -> Result<(), SceneError> {
        let instead = || {
            let tiers = Tier::names_with(TierFeature::AllOfJoints);
            format!(
                "joints without it (they hold, and their coordinates have limits without restitution), or tier {tiers}"
            )
        };
        let refuse = |what: String| Err(SceneError::NotYetAvailable { what, instead: instead() });
        if !self.gears.is_empty() || !self.coordinate_motions.is_empty() {
            return refuse(format!("a gear or a prescribed motion of a joint with tier = \"{tier}\""));
        }
        for (number, joint) in self.joints.iter().enumerate() {
            let has = |of: &dyn Fn(&Freedom) -> bool| {
                joint
                    .kind()
                    .coordinates()
                    .iter()
                    .filter_map(|&coordinate| joint.freedom(coordinate))
                    .any(|own| of(&own))
            };
            let found = [
                (matches!(joint.kind(), JointKind::Track { .. }), "a track"),
                (joint.bodies().any(|body| self.bodies[body].motion().is_some()), "a kinematic member"),
                (joint.strength().is_some(), "a strength"),
                (has(&|own| own.has_forces()), "a spring, damper or motor"),
                (has(&|own| own.friction().is_some()), "friction"),
                (has(&|own| own.limits().is_some_and(|limits| limits.restitution() > 0.0)), "a limit that bounces"),
            ];
            if let Some((_, what)) = found.into_iter().find(|(is_there, _)| *is_there) {
                return refuse(format!("joint {number} with {what} in tier = \"{tier}\""));
            }
        }
        Ok(())
    }

    /// The pose of the moving frame of a body at the start, and its velocity.
    pub(super) fn motion_at_start(&self, body: usize) -> (Pose, Velocity) {
        let own = &self.bodies[body];
        if let Some(motion) = own.motion() {
            let trajectory = motion.from_pose(&motion.initial_pose(own.initial_pose()));
            return (trajectory.pose(0.0), trajectory.velocity(0.0));
        }
        let Some(properties) = own.mass_properties() else { return (Pose::IDENTITY, Velocity::ZERO) };
        let Velocity { linear, angular } = *own.initial_velocity();
        let center = properties.center_of_mass();
        let pose = *own.initial_pose() * Pose::from_translation(center);
        let linear = own.pivot_point().map_or(linear, |pivot| angular.cross(pose.translation - pivot));
        (pose, Velocity::new(linear, angular))
    }

    /// The speed (m/s) and rate of turning (rad/s) that the digits of a velocity at the start are relative to: its own,
    /// or the greatest of a prescribed motion in the run.
    pub(super) fn speeds_for_rounding(&self, body: usize) -> [f64; 2] {
        let own = &self.bodies[body];
        if let Some(motion) = own.motion() {
            let bounds = motion.from_pose(&motion.initial_pose(own.initial_pose())).bounds(0.0, self.duration_s);
            return [bounds.speed, bounds.angular_speed];
        }
        let (_, velocity) = self.motion_at_start(body);
        [velocity.linear.length(), velocity.angular.length()]
    }

    /// A joint as it is at the start, whose rows of rotation have the length 1 m.
    pub(super) fn joint_at_start(&self, number: usize, joint: &Joint) -> ModelJoint {
        let held = |body: usize| match &self.bodies[body] {
            own if own.motion().is_some() => HeldBody::Kinematic(self.motion_at_start(body).0),
            own if own.mass_properties().is_some() => HeldBody::Movable(self.motion_at_start(body).0),
            _ => HeldBody::Fixed,
        };
        ModelJoint::new((number, joint), &self.tracks, held, 1.0)
    }

    /// Checks that the velocities at the start are what a joint leaves free: the rates of its rows are zero to
    /// rounding.
    fn check_joint_velocity(&self, number: usize, joint: &Joint) -> Result<(), SceneError> {
        let motion = |body: usize| self.motion_at_start(body);
        let world_joint = self.joint_at_start(number, joint);
        let (mut apart, mut across) = (0.0, 0.0);
        for row in world_joint.rows_at(motion).rows {
            match row.kind {
                RowKind::Along(_) | RowKind::Helix { .. } | RowKind::Tied { .. } => {
                    apart = libm::hypot(apart, row.rate);
                }
                RowKind::About(_) | RowKind::Turning { .. } => across = libm::hypot(across, row.rate),
            }
        }
        let (mut speed, mut turning) = (0.0, 0.0);
        for body in world_joint.bodies().chain(world_joint.driver()) {
            // The parts of the velocity at the anchor may cancel.
            let [linear, angular] = self.speeds_for_rounding(body);
            speed += linear + angular * (joint.anchor() - motion(body).0.translation).length();
            turning += angular;
        }
        if apart > rounding::DIGITS_OF_A_FILE * speed {
            return Err(SceneError::JointMoves { number, apart_m_s: apart });
        }
        if across > rounding::DIGITS_OF_A_FILE * turning {
            return Err(SceneError::JointTurns { number, across_rad_s: across });
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

//! Checks of the gears of a scene and of the prescribed motions of its joints: that their joints have such coordinates,
//! and that the velocities at the start agree with them.

use crate::identity::joint_id::JointId;
use crate::scene::{Coordinate, CoordinateMotion, Gear, GearEnd, Scene, SceneError};
use polhode_spatial::Motion;
use polhode_spatial::rounding;

/// The rate of a coordinate at the start, with the sum of the speeds that it is a difference of, rad/s or m/s.
struct StartRate {
    rate: f64,
    speeds: f64,
}

impl Scene {
    /// Gears between joints.
    pub fn gears(&self) -> &[Gear] {
        &self.gears
    }

    /// The coordinates of joints that follow a prescribed motion.
    pub fn driven_coordinates(&self) -> impl Iterator<Item = (JointId, Coordinate)> + '_ {
        let own = self.coordinate_motions.iter();
        own.map(|(end, _)| (end.joint, end.coordinate.unwrap_or(Coordinate::Angle)))
    }

    /// Checks gears and prescribed motions.
    ///
    /// # Errors
    /// With the first that is refused.
    pub(crate) fn check_ties(&self) -> Result<(), SceneError> {
        for (number, gear) in self.gears.iter().enumerate() {
            self.check_gear(number, gear)?;
        }
        for (place, (end, motion)) in self.coordinate_motions.iter().enumerate() {
            let twice = self.coordinate_motions[..place].iter().any(|(other, _)| other == end);
            self.check_coordinate_motion(end, motion, twice)?;
        }
        Ok(())
    }

    fn check_gear(&self, number: usize, gear: &Gear) -> Result<(), SceneError> {
        let refused = |reason| SceneError::Gear { number, reason };
        let [first, second] = gear.ends().map(|end| {
            let joint = self.joints.get(end.joint.index()).ok_or(refused("it names a joint that does not exist"))?;
            let own = joint.kind().coordinates();
            match (end.coordinate, own) {
                (None, [one]) => Ok((end, *one)),
                (Some(named), _) if own.contains(&named) => Ok((end, named)),
                (None, [_, _, ..]) => Err(refused(
                    "a joint of it has two coordinates: name the one that it takes hold \
                    of",
                )),
                _ => Err(refused(
                    "a joint of it does not have such a coordinate: a hinge or a screw has an angle, a slider a \
                     displacement, a cylindrical joint both, a rope a distance",
                )),
            }
        });
        let (first, second) = (first?, second?);
        if (first.0.joint, first.1) == (second.0.joint, second.1) {
            return Err(refused("it couples a coordinate to itself: two different ones are needed"));
        }
        let rate = |(end, coordinate): (GearEnd, Coordinate)| self.rate_at_start(end, coordinate);
        let (Some(first), Some(second)) = (rate(first), rate(second)) else { return Ok(()) };
        let needed = gear.ratio() * second.rate;
        let speeds = first.speeds + gear.ratio().abs() * second.speeds;
        if (first.rate - needed).abs() > rounding::DIGITS_OF_A_FILE * speeds {
            return Err(SceneError::GearRate { number, found: first.rate, needed });
        }
        Ok(())
    }

    fn check_coordinate_motion(&self, end: &GearEnd, motion: &CoordinateMotion, twice: bool) -> Result<(), SceneError> {
        let joint = end.joint.index();
        let refused = |reason| SceneError::CoordinateMotion { joint, reason };
        let own = self.joints.get(joint).ok_or_else(|| refused("the joint does not exist"))?;
        let coordinate = end.coordinate.unwrap_or(Coordinate::Angle);
        if !own.kind().coordinates().contains(&coordinate) {
            return Err(refused(
                "it does not have that coordinate: a hinge or a screw has an angle, a slider a displacement, a \
                 cylindrical joint both",
            ));
        }
        if twice {
            return Err(refused("the coordinate has two of them: one is needed"));
        }
        if own.limits(coordinate).is_some() {
            return Err(refused("the coordinate has limits, which it could only contradict: leave one of them out"));
        }
        if motion.along_x().jump_between(0.0, self.duration_s).is_some() {
            return Err(refused(
                "its rate jumps within the run, which would take an infinite force: `monotone` or `spline` \
                 interpolation is needed",
            ));
        }
        let pose = motion.along_x().initial_pose(&polhode_spatial::Pose::IDENTITY);
        let trajectory = motion.along_x().from_pose(&pose);
        let (needed, greatest) = (trajectory.velocity(0.0).linear.x, trajectory.bounds(0.0, self.duration_s).speed);
        let Some(StartRate { rate: found, speeds }) = self.rate_at_start(*end, coordinate) else { return Ok(()) };
        if (found - needed).abs() > rounding::DIGITS_OF_A_FILE * (speeds + greatest) {
            return Err(SceneError::CoordinateRate { joint, found, needed });
        }
        Ok(())
    }

    fn rate_at_start(&self, end: GearEnd, coordinate: Coordinate) -> Option<StartRate> {
        let joint = self.joints.get(end.joint.index())?;
        let at_start = self.joint_at_start(end.joint.index(), joint);
        let rate = at_start.rate_of(Some(coordinate), |body| self.motion_at_start(body))?;
        let speed = |body: usize| {
            let [linear, turning] = self.speeds_for_rounding(body);
            match coordinate {
                Coordinate::Angle => turning,
                _ => linear + turning * (joint.anchor() - self.motion_at_start(body).0.translation).length(),
            }
        };
        let speeds = joint.bodies().filter(|&body| !self.bodies[body].is_fixed()).map(speed).sum();
        Some(StartRate { rate, speeds })
    }
}

//! Steering: what a program has a kinematic body do.
//!
//! A body with a prescribed motion follows its scene's motion until a program steers it; from then on it follows what
//! the program says, until the program says something else:
//!
//! | command at time t0 | motion from t0 on |
//! |---|---|
//! | velocity v, w | `p = p0 + v (t - t0)`, `R = exp(w (t - t0)) R0` |
//! | pose (R1, p1) within T | p and rotation vector of degree five in `(t - t0)/T`, then the body stands still |
//!
//! p: position of the body's own origin, m; R: its orientation; v, w: velocity (m/s) and angular velocity (rad/s),
//! world; (R0, p0): the pose at t0. The polynomials begin with the velocity and the acceleration that the body has, and
//! end with none, so that a program may give a new target before the last one is reached and the velocity never jumps.
//! From rest they are the motion of a table of two samples (`p0`, `p1`) with
//! [`Interpolation::Spline`](crate::scene::Interpolation::Spline). The rotation takes the shorter way, which is one of
//! two for half a turn.
//!
//! A velocity that is set acts at once. Bodies that the body touches are struck if it now moves towards them: they get
//! an impulse, as by any impact, and the ledger books its work as that of the kinematic body. To set bodies in motion
//! without an impact, give a pose. Bodies that joints hold to it take its velocity at once, by an impulse that the
//! ledger books as the program's.

use crate::action_error::ActionError;
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::model::prescribed;
use crate::model::steered::{Goal, Steered};
use crate::run::simulation::Simulation;
use crate::solve::projection::{Removal, project_velocities};
use polhode_spatial::{Pose, Velocity};

/// What a kinematic body does from now on ([`Simulation::set_motion`]).
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Steering {
    /// It moves with this velocity of its own origin and this angular velocity, both constant in the world.
    Velocity(Velocity),
    /// It moves to a pose of its own origin, where it then stands still.
    Pose {
        /// The pose, world.
        pose: Pose,
        /// How long the motion takes, s.
        within_s: f64,
    },
}

impl Steering {
    /// It stands still from now on.
    pub const HALT: Self = Self::Velocity(Velocity::ZERO);
}

impl Simulation {
    /// Steers a kinematic body from the present on, in place of the motion of its scene. The motion lasts until it is
    /// set again. Forces do not change it; the ledger books its work on other bodies as external work.
    ///
    /// ```
    /// use polhode::prelude::*;
    /// // A lift of 0.2 m, on which a crate stands, goes up by 2 m within 4 s.
    /// let still = PrescribedMotion::constant_velocity(Velocity::ZERO)?;
    /// let lift = Body::kinematic("lift", still).geometry(Shape::cuboid(DVec3::new(2.0, 2.0, 0.2))?.into());
    /// let load = Body::movable("load", polhode::mesh::solid_box(DVec3::ONE, Mass::new(50.0)?)?)
    ///     .geometry(Shape::cuboid(DVec3::ONE)?.into())
    ///     .pose(Pose::from_translation(DVec3::Z * 0.6));
    /// let scene = Scene::builder("lift").body(lift).body(load).duration_s(5.0).build()?;
    /// let mut simulation = Simulation::new(&scene)?;
    /// let [lift, load] = ["lift", "load"].map(|name| simulation.body_id(name));
    /// let (lift, load) = (lift.ok_or("no lift")?, load.ok_or("no load")?);
    /// let up = Pose::from_translation(DVec3::Z * 2.0);
    /// simulation.set_motion(lift, Steering::Pose { pose: up, within_s: 4.0 })?;
    /// let report = simulation.run()?;
    /// assert!((simulation.body(load).pose.translation.z - 2.6).abs() < 1e-12);
    /// assert!((report.ledger.external.value() - 50.0 * 9.81 * 2.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// For a removed body and one that is not kinematic, for numbers that are not finite, for a time that is not
    /// positive, and for a motion that is too fast ([`ActionError`]).
    pub fn set_motion(&mut self, body: BodyId, steering: Steering) -> Result<(), SimulationError> {
        let index = self.kinematic(body)?;
        let steered = self.steered(index, steering)?;
        let driven = self.core.model.joints.driven_by(index);
        let concerned: Vec<usize> = driven.iter().copied().chain([index]).collect();
        self.act(&concerned, &[index], "set_motion", |simulation| {
            let state = simulation.core.model.steer(index, steered, simulation.core.t);
            let state = state.map_err(|source| ActionError::Motion { body: simulation.name(index), source })?;
            simulation.tier.states_mut()[index] = state;
            simulation.take_along(&driven)
        })?;
        self.repeat_beside(|beside| beside.set_motion(body, steering));
        Ok(())
    }

    /// Gives bodies that joints hold to a steered one the velocities that its new velocity asks for, at once: an
    /// impulse of the program.
    fn take_along(&mut self, driven: &[usize]) -> Result<(), SimulationError> {
        if driven.is_empty() {
            return Ok(());
        }
        let (core, states) = (&mut self.core, self.tier.states_mut());
        let before = core.accounts.books.balance(&core.model, states, driven);
        project_velocities(&core.model, states, driven, (&[], &[], &[]), Removal::Complete)
            .map_err(|source| SimulationError::of_response(core.t, source))?;
        let after = core.accounts.books.balance(&core.model, states, driven);
        core.accounts.books.program(before, after);
        Ok(())
    }

    /// The motion of a kinematic body that is steered from the present on, checked.
    fn steered(&self, index: usize, steering: Steering) -> Result<Steered, ActionError> {
        let (t, model) = (self.core.t, &self.core.model);
        let now = prescribed::prescribed_state(model, index, t).unwrap_or(self.tier.state(&self.core, index));
        let goal = match steering {
            Steering::Velocity(velocity) => {
                self.finite(index, "the velocity", velocity.linear)?;
                self.finite(index, "the angular velocity", velocity.angular)?;
                None
            }
            Steering::Pose { pose, within_s } => {
                if !pose.is_finite() {
                    return Err(ActionError::NotFinite { body: self.name(index), what: "the pose" });
                }
                // A time that rounding adds to nothing is none.
                if !(within_s.is_finite() && t + within_s > t) {
                    return Err(ActionError::Time { body: self.name(index), within_s, now_s: t });
                }
                Some(Goal { until_s: t + within_s, pose })
            }
        };
        let (velocity, acceleration) = match steering {
            Steering::Velocity(velocity) => (velocity, crate::report::acceleration::Acceleration::default()),
            Steering::Pose { .. } => {
                let (linear, angular) = prescribed::prescribed_acceleration(model, index, t);
                (model.velocity(index, &now), crate::report::acceleration::Acceleration { linear, angular })
            }
        };
        let steered = Steered { from_s: t, pose: now.pose, velocity, acceleration, goal };
        let checked = steered.trajectory();
        checked.map_err(|source| ActionError::Motion { body: self.name(index), source })?;
        Ok(steered)
    }
}

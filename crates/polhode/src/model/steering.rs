//! Kinematic bodies of the world that a program steers.

use super::Model;
use super::steered::Steered;
use crate::model::prescribed_state::state_at;
use crate::scene::MotionError;
use crate::snapshot::{SnapshotError, content};
use polhode_dynamics::BodyState;

impl Model {
    /// Steers a kinematic body from `t` (s) on. Returns its state.
    ///
    /// # Errors
    /// When the motion is too fast; nothing has changed then.
    pub(crate) fn steer(&mut self, body: usize, steered: Steered, t: f64) -> Result<BodyState, MotionError> {
        let trajectory = steered.trajectory()?;
        let state = state_at(&trajectory, t);
        self.bodies[body].trajectory = Some(trajectory);
        self.steered.insert(body, steered);
        Ok(state)
    }

    /// The motions that a program has given kinematic bodies, as plain numbers.
    pub(crate) fn steered(&self) -> Vec<content::Steered> {
        self.steered.iter().map(|(&body, steered)| steered.save(body)).collect()
    }

    /// Replaces all motions that a program has given; bodies without one follow that of the scene again.
    ///
    /// # Errors
    /// When one is of a body that is not kinematic, or is no motion.
    pub(crate) fn replace_steered(&mut self, saved: &[content::Steered]) -> Result<(), SnapshotError> {
        for body in std::mem::take(&mut self.steered).into_keys() {
            self.bodies[body].trajectory = self.scene.bodies()[body].trajectory();
        }
        for own in saved {
            let refused = SnapshotError::Invalid("a body that the program steers has a motion that no run has");
            if !self.prescribed.contains(&own.body) {
                return Err(refused);
            }
            let steered = Steered::restored(own)?;
            self.steer(own.body, steered, steered.from_s).map_err(|_| refused)?;
        }
        Ok(())
    }
}

//! What a tier does: it advances the bodies of a scene to a time or to their first event.
//!
//! One file or folder for each tier; none knows another. A tier may have computed the motion beyond the present: what
//! it says of the bodies is asked for at a time.

use crate::accounting::Accounts;
use crate::core::Core;
use crate::frame::{ContactView, IslandView, MotionKind, PivotView};
use crate::observer::{BodySample, Observer};
use crate::snapshot::content;
use crate::{Acceleration, SimulationError};
use polhode_dynamics::BodyState;

/// Why a tier has stopped to advance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reached {
    /// The limit of time.
    Limit,
    /// The end of a step before that limit.
    StepEnd,
    /// An event; all that happens at its instant has been resolved.
    Event,
}

/// A set of methods with one promise.
///
/// What has a body here is that of a tier which books every step when it makes it, and whose bodies all stand at the
/// present between two steps.
pub(crate) trait Tier: std::fmt::Debug {
    /// Advances the present (`core.t`) to `limit_s`, or to the first event before, and tells the observer the samples
    /// and events on the way.
    ///
    /// # Errors
    /// See [`SimulationError`].
    fn advance(
        &mut self,
        core: &mut Core,
        limit_s: f64,
        observer: &mut dyn Observer,
    ) -> Result<Reached, SimulationError>;

    /// The longest time (s) after which the caller wants to be asked again, while nothing happens.
    fn stride(&self, core: &Core) -> f64;

    /// States of all bodies at the present.
    fn states(&self, core: &Core) -> Vec<BodyState>;

    /// State of one body at the present: the same bits as in [`Tier::states`], at a cost that does not grow with the
    /// number of bodies that do not move with it.
    fn state(&self, core: &Core, body: usize) -> BodyState;

    /// One body at the present, as it is reported.
    fn sample(&self, core: &Core, body: usize) -> BodySample {
        core.world.sample(body, &self.state(core, body))
    }

    /// All bodies at the present, as they are reported.
    fn samples(&self, core: &Core) -> Vec<BodySample> {
        self.states(core).iter().enumerate().map(|(body, state)| core.world.sample(body, state)).collect()
    }

    /// Books into `accounts`, which are a copy, what has been going on since it was last booked, up to the present.
    ///
    /// # Errors
    /// When states cannot be evaluated.
    fn book_present(&mut self, _core: &Core, _accounts: &mut Accounts) -> Result<(), SimulationError> {
        Ok(())
    }

    /// Accelerations of all bodies at the present, under the contact forces of the present.
    ///
    /// # Errors
    /// When the forces cannot be found.
    fn accelerations(&mut self, core: &mut Core) -> Result<Vec<Acceleration>, SimulationError>;

    /// Contacts that touch at `t` (s), a time within the present steps, when the bodies have these states; a force that
    /// cannot be found is NaN.
    fn contacts(&self, core: &Core, t: f64, states: &[BodyState]) -> Vec<ContactView>;

    /// What the pivots bear at `t` (s), when the bodies have these states; nothing from a tier that does not find it.
    fn pivots(&self, _core: &Core, _t: f64, _states: &[BodyState]) -> Vec<PivotView> {
        Vec::new()
    }

    /// How each body moves.
    fn motions(&self, core: &Core) -> Vec<MotionKind>;

    /// Bodies that move together, and those that rest together.
    fn islands(&self, core: &Core) -> Vec<IslandView>;

    /// Brings some bodies, and all that their motion concerns, to the present, so that a program may change them.
    ///
    /// # Errors
    /// When their states cannot be evaluated.
    fn interrupt(&mut self, _core: &mut Core, _bodies: &[usize]) -> Result<(), SimulationError> {
        Ok(())
    }

    /// The states of the present, to be changed for bodies that have been interrupted.
    fn states_mut(&mut self) -> &mut [BodyState];

    /// Goes on from the changed states of the bodies that have been interrupted; the poses of `moved` are new.
    ///
    /// # Errors
    /// When an impact or the contact forces cannot be solved.
    fn resume(&mut self, _core: &mut Core, _moved: &[usize]) -> Result<(), SimulationError> {
        Ok(())
    }

    /// A body has been added to the world, with this state.
    fn add_body(&mut self, core: &Core, state: BodyState);

    /// A body is about to be removed from the world; it has been interrupted.
    fn remove_body(&mut self, body: usize);

    /// Number of pairs that touch.
    fn touching_pairs(&self) -> usize;

    /// What the tier goes on from, as plain data.
    fn save(&self) -> content::Tier;
}

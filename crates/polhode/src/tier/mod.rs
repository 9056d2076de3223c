//! The interface of a tier: it advances the bodies of a scene to a time or to the first event before it.
//!
//! Each tier has a folder of its own, and none imports another. A tier may have computed the motion beyond the present,
//! so that its queries are about the present time or take a time.
//!
//! | module | holds |
//! |---|---|
//! | `facts` | [`TierFacts`]: what a tier is; `list`: those of each tier |
//! | `settings` | the method of a scene, completed by the defaults of its tier |
//! | `scene_checks` | builds a scene, and holds it against its tier |
//! | `scene_copies` | builds a scene set otherwise |
//! | `method_checks`, `coordinates` | whether the tier has what the method, and reduced coordinates, ask for |
//! | `choice` | which tier runs a scene that names none, by what it would cost |
//! | `core` | `Core`: world, settings, present time and accounts, on which all tiers work |
//! | `executor` | [`Executor`](crate::Executor): who computes islands that do not depend on each other |
//! | `promise` | holds a run to the promise of its tier |
//! | `joint_samples` | the joints of a simulation at one time |
//! | `sampling` | samples and frames between two events |
//! | `sample_penetration` | penetration of samples, measured by the distance of shapes |
//! | `fixed_steps` | what tiers of fixed steps share |
//! | `free_stage` | impulse and work of fields over a step of an integrator |
//! | `smooth_rates` | rates of flat states without contact forces |

pub(crate) mod choice;
mod coordinates;
pub(crate) mod core;
pub(crate) mod executor;
pub(crate) mod facts;
pub(crate) mod fixed_steps;
pub(crate) mod free_stage;
pub(crate) mod joint_samples;
mod list;
mod method_checks;
mod promise;
mod sample_penetration;
pub(crate) mod sampling;
mod scene_checks;
mod scene_copies;
pub(crate) mod settings;
pub(crate) mod smooth_rates;

pub use facts::{ErrorOrder, FlightRecords, IntegratorChoice, StepLength, TierFacts, TierFeature};

use crate::accounting::Accounts;
use crate::error::SimulationError;
use crate::model::reported;
use crate::report::acceleration::Acceleration;
use crate::report::frame::{ContactView, IslandView, JointView, MotionKind, PivotView};
use crate::report::observer::{BodySample, Observer};
use crate::report::run_report::RunReport;
use crate::snapshot::content;
use crate::tier::core::Core;
use polhode_dynamics::BodyState;

/// Why a tier has stopped advancing.
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
/// The default methods here are right for a tier that books every step when it makes it, and whose states are all those
/// of the present between two steps.
pub(crate) trait Tier: std::fmt::Debug + Send {
    /// Advances the present (`core.t`) to `limit_s`, or to the first event before it, and gives the observer the
    /// samples and events on the way.
    ///
    /// # Errors
    /// See [`SimulationError`].
    fn advance(
        &mut self,
        core: &mut Core,
        limit_s: f64,
        observer: &mut dyn Observer,
    ) -> Result<Reached, SimulationError>;

    /// Length (s) of a step of [`Simulation::step`](crate::Simulation::step) when no event ends it earlier.
    fn stride(&self, core: &Core) -> f64;

    /// States of all bodies at the present.
    fn states(&self, core: &Core) -> Vec<BodyState>;

    /// State of one body at the present, with the same bits as in [`Tier::states`]. Its cost depends only on the bodies
    /// of the same island.
    fn state(&self, core: &Core, body: usize) -> BodyState;

    /// One body at the present, as it is reported.
    fn sample(&self, core: &Core, body: usize) -> BodySample {
        reported::sample(&core.model, body, &self.state(core, body))
    }

    /// All bodies at the present, as they are reported.
    fn samples(&self, core: &Core) -> Vec<BodySample> {
        self.states(core).iter().enumerate().map(|(body, state)| reported::sample(&core.model, body, state)).collect()
    }

    /// Books the motion since the last booking, up to the present, into `accounts`, which are a copy.
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

    /// Forces of the pivots at `t` (s), when the bodies have these states; empty for a tier that does not compute them.
    fn pivots(&self, _core: &Core, _t: f64, _states: &[BodyState]) -> Vec<PivotView> {
        Vec::new()
    }

    /// What the joints do at `t` (s), when the bodies have these states; empty for a tier that does not compute it.
    fn joint_loads(&self, _core: &Core, _t: f64, _states: &[BodyState]) -> Vec<JointView> {
        Vec::new()
    }

    /// How each body moves.
    fn motions(&self, core: &Core) -> Vec<MotionKind>;

    /// Bodies that move together, and those that rest together.
    fn islands(&self, core: &Core) -> Vec<IslandView>;

    /// Ends the present steps of these bodies, and of all bodies that move with them, at the present time, so that a
    /// program may change their states.
    ///
    /// # Errors
    /// When their states cannot be evaluated.
    fn interrupt(&mut self, _core: &mut Core, _bodies: &[usize]) -> Result<(), SimulationError> {
        Ok(())
    }

    /// States of the present. Only those of interrupted bodies may be changed.
    fn states_mut(&mut self) -> &mut [BodyState];

    /// Starts new steps from the changed states of the interrupted bodies. The poses of `moved` have changed.
    ///
    /// # Errors
    /// When an impact or the contact forces cannot be solved.
    fn resume(&mut self, _core: &mut Core, _moved: &[usize]) -> Result<(), SimulationError> {
        Ok(())
    }

    /// Takes up a body that has been added to the world, with this state.
    fn add_body(&mut self, core: &Core, state: BodyState);

    /// Drops a body, which has been interrupted and is about to be removed from the world.
    fn remove_body(&mut self, body: usize);

    /// Drops what it knows of contacts and loads that are there no more, after a joint of this pair of bodies, which
    /// have been interrupted, was added to the world or taken away.
    fn change_joint(&mut self, _core: &mut Core, _pair: (usize, usize)) {}

    /// Number of pairs that touch.
    fn touching_pairs(&self) -> usize;

    /// Writes what only this tier measures into the report of a run.
    fn fill(&self, _report: &mut RunReport) {}

    /// The data from which the tier continues, for a snapshot.
    fn save(&self) -> content::Tier;
}

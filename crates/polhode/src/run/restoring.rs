//! Snapshots of a simulation, and simulations that continue from them.

use crate::accounting::Accounts;
use crate::accounting::last_sample::LastSample;
use crate::error::SimulationError;
use crate::error_estimate::references::References;
use crate::joints::{added, motors, released, turns};
use crate::model::Model;
use crate::model::plane_of_motion::PlanarBodies;
use crate::report::run_report::PlanChange;
use crate::run::engines;
use crate::run::simulation::Simulation;
use crate::scene::Integrator;
use crate::scene::effects::Effects;
use crate::snapshot::content::{self, Content};
use crate::snapshot::{self, Snapshot, SnapshotError};
use crate::tier::core::Core;
use crate::tier::settings::Settings;
use polhode_response::Memory;

impl Simulation {
    /// A snapshot: everything from which [`Simulation::restore`] continues the run with the same bits.
    ///
    /// It holds a hash of the scene, not the scene itself.
    pub fn snapshot(&self) -> Snapshot {
        Snapshot::new(self.content())
    }

    /// The content of a snapshot.
    pub(crate) fn content(&self) -> Content {
        let change = |change: &PlanChange| content::PlanChange {
            t_s: change.t_s,
            action: change.action.clone(),
            changes: change.changes.clone(),
        };
        Content {
            scene: self.scene.name().to_owned(),
            scene_hash: snapshot::scene_hash(added::scene_and_joints(&self.core.model)),
            all_effects: self.core.effects == Effects::All,
            t: self.core.t,
            ended: self.ended,
            applied: self.core.model.forces.applied(),
            steered: self.core.model.steered(),
            motors: self.core.model.joints.motors(),
            released: self.core.model.joints.released.keys().copied().collect(),
            turns: self.core.model.joints.turns(),
            in_plane: self.core.model.planar.bodies().collect(),
            integrator: self.core.settings.integrator.name().to_owned(),
            plan: self.plan.save(&self.plan_at_start),
            plan_changes: self.plan_changes.iter().map(change).collect(),
            accounts: self.core.accounts.save(),
            tier: self.tier.save(),
            work: self.core.work,
            error: self.save_references(),
        }
    }

    /// Restores a snapshot of a simulation of the same scene, with the same effects, the same bodies added and
    /// removed, and the same joints added. The motion, samples, events and report that follow have the same bits as
    /// those that followed the snapshot, but for the estimated error: how long references are followed depends on what
    /// a run keeps in memory. The scene may have another duration: a run that has ended goes on to a longer one.
    ///
    /// # Errors
    /// When the snapshot is of another scene or other effects, or contradicts itself; the simulation is then as it was.
    pub fn restore(&mut self, snapshot: &Snapshot) -> Result<(), SimulationError> {
        let content = snapshot.content_for(added::scene_and_joints(&self.core.model), self.core.effects)?;
        let mut restored = self.twin(content, self.core.settings)?;
        restored.references = self.restored_references(&content.error)?;
        *self = restored;
        Ok(())
    }

    /// The simulation of the same scene, with these settings, that continues from this content, without its references.
    ///
    /// # Errors
    /// When the content contradicts itself.
    fn twin(&self, content: &Content, settings: Settings) -> Result<Self, SimulationError> {
        self.twin_by(content, settings, (self.core.model.clone(), self.planar_at_start.clone()))
    }

    /// The same with a model that has another method, and bodies that were planar at its start.
    ///
    /// # Errors
    /// When the content contradicts itself.
    pub(super) fn twin_by(
        &self,
        content: &Content,
        mut settings: Settings,
        (mut model, planar_at_start): (Model, PlanarBodies),
    ) -> Result<Self, SimulationError> {
        model.replace_applied(&content.applied)?;
        model.replace_steered(&content.steered)?;
        // Joints that have let go have motors too.
        released::replace_released(&mut model, &[])?;
        motors::replace_motors(&mut model, &content.motors)?;
        released::replace_released(&mut model, &content.released)?;
        turns::replace_turns(&mut model, &content.turns)?;
        model.planar = planar_at_start.restored(&content.in_plane);
        settings.integrator = Integrator::from_name(&content.integrator)
            .map_err(|_| SnapshotError::Invalid("it names an integrator that does not exist"))?;
        let plan = self.plan_at_start.restored(content.plan.as_ref(), settings.integrator)?;
        let accounts = Accounts::restored(&content.accounts, model.bodies.len(), settings.promise)?;
        let memory = Memory::default();
        let (executor, last_sample) = (self.core.executor.clone(), LastSample::default());
        let (effects, t, work, stated_depth_m) = (self.core.effects, content.t, content.work, f64::INFINITY);
        let mut core =
            Core { model, settings, effects, t, accounts, memory, executor, stated_depth_m, work, last_sample };
        let tier = engines::restored(&mut core, &content.tier)?;
        // The steps that are made again have been counted.
        core.accounts.step_errors = content.accounts.step_errors;
        // A scene with a longer duration goes on.
        let ended = content.ended && core.t >= self.scene.duration_s();
        let change = |change: &content::PlanChange| PlanChange {
            t_s: change.t_s,
            action: change.action.clone(),
            changes: change.changes.clone(),
        };
        Ok(Self {
            scene: self.scene.clone(),
            plan,
            core,
            tier,
            plan_changes: content.plan_changes.iter().map(change).collect(),
            plan_at_start: self.plan_at_start.clone(),
            planar_at_start,
            ended,
            references: References::default(),
        })
    }
}

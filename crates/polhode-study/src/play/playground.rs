//! The scene that runs.

use super::error::PlayError;
use super::grab::Grab;
use super::timeline::{Action, Kept, Timeline};
use polhode::scene::Material;
use polhode::spatial::{DVec3, Pose};
use polhode::{
    Acceleration, Body, BodyId, BodySample, ContactView, RunHash, RunReport, Scene, Simulation, SimulationError,
    Stability,
};
use polhode_scene::{GivenFiles, LoadedScene, Override, load_with_files};

/// The longest step while a body is held, s (1/240 to 1/30): the force of the spring is constant in it.
const HELD_STEP_S: f64 = 1.0 / 120.0;

/// A scene that runs while somebody plays with it.
#[derive(Debug)]
pub struct Playground {
    loaded: LoadedScene,
    simulation: Simulation,
    hash: RunHash,
    timeline: Timeline,
    grab: Option<Grab>,
}

impl Playground {
    /// Reads a scene, with these values changed, and prepares its run.
    ///
    /// # Errors
    /// When the scene is refused, or bodies overlap at its start.
    pub fn new(origin: &str, text: &str, files: GivenFiles, changes: &[Override]) -> Result<Self, PlayError> {
        let loaded = load_with_files(origin, text, files, changes)?;
        Self::of(loaded)
    }

    /// Prepares the run of a scene that has been read.
    ///
    /// # Errors
    /// When bodies overlap at its start, or forces there are not finite.
    pub fn of(loaded: LoadedScene) -> Result<Self, PlayError> {
        let simulation = match Simulation::new(&loaded.scene) {
            Ok(simulation) => simulation,
            Err(SimulationError::Scene(error)) => return Err(loaded.explain(error).into()),
            Err(error) => return Err(error.into()),
        };
        Ok(Self { loaded, simulation, hash: RunHash::default(), timeline: Timeline::default(), grab: None })
    }

    /// The scene as it was read.
    pub fn loaded(&self) -> &LoadedScene {
        &self.loaded
    }

    /// Time reached, s.
    pub fn time(&self) -> f64 {
        self.simulation.time()
    }

    /// How many steps have been made.
    pub fn steps(&self) -> u64 {
        self.timeline.steps()
    }

    /// Whether the end of the scene's duration has been reached.
    pub fn has_ended(&self) -> bool {
        self.simulation.has_ended()
    }

    /// Whether nobody has acted: the strict hash is then that of the scene.
    pub fn is_untouched(&self) -> bool {
        self.timeline.is_untouched()
    }

    /// The strict hash of the run so far, and of how many samples it is.
    pub fn hash(&self) -> &RunHash {
        &self.hash
    }

    /// Poses and velocities of all bodies.
    pub fn bodies(&self) -> Vec<BodySample> {
        self.simulation.bodies()
    }

    /// The simulation.
    pub(super) fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// The scene as it was read.
    pub fn scene(&self) -> &Scene {
        &self.loaded.scene
    }

    /// Accelerations of all bodies.
    pub(super) fn accelerations(&mut self) -> Result<Vec<Acceleration>, PlayError> {
        Ok(self.simulation.accelerations()?)
    }

    /// The contacts that touch, with their forces.
    pub fn contacts(&self) -> Vec<ContactView> {
        self.simulation.contacts()
    }

    /// How far the bodies at rest are from moving.
    ///
    /// # Errors
    /// When rows cannot be made of the contacts.
    pub fn stability(&self) -> Result<Stability, PlayError> {
        Ok(self.simulation.stability()?)
    }

    /// The report of the run up to the present.
    ///
    /// # Errors
    /// When what holds at present cannot be measured.
    pub fn report(&mut self) -> Result<RunReport, PlayError> {
        Ok(self.simulation.report_so_far()?)
    }

    /// Makes a step; the time reached, s. While a body is held the step is short.
    ///
    /// # Errors
    /// When the engine ends the run.
    pub fn step(&mut self) -> Result<f64, PlayError> {
        if self.timeline.wants_snapshot() {
            self.keep();
        }
        let Some(grab) = self.grab else { return self.advance(None) };
        if let Some(own) = self.body(grab.body)?.mass_properties().copied() {
            let [force_n, torque_nm] = grab.load(&own, &self.simulation.body(grab.body), HELD_STEP_S);
            self.act(Action::Load { body: grab.body, force_n, torque_nm })?;
        }
        self.advance(Some(HELD_STEP_S))
    }

    /// Holds a body at a point of the world, m.
    ///
    /// # Errors
    /// When there is no such body, or forces do not move it.
    pub fn grab(&mut self, body: usize, point_m: DVec3) -> Result<(), PlayError> {
        let id = BodyId::new(body);
        let own = self.body(id)?;
        if own.is_fixed() || own.motion().is_some() {
            return Err(PlayError::Fixed { name: own.name().to_owned() });
        }
        self.release()?;
        let pose = self.simulation.body(id).pose;
        self.grab = Some(Grab { body: id, point_m: pose.inverse_transform_point(point_m), hand_m: point_m });
        Ok(())
    }

    /// Moves the hand to a point of the world, m.
    pub fn pull(&mut self, hand_m: DVec3) {
        if let Some(grab) = self.grab.as_mut().filter(|_| hand_m.is_finite()) {
            grab.hand_m = hand_m;
        }
    }

    /// The spring that holds a body, and its force at present, N; none while none is held.
    pub fn held(&self) -> Option<(Grab, DVec3)> {
        let grab = self.grab?;
        let own = self.loaded.scene.bodies().get(grab.body.index())?.mass_properties()?;
        let [force_n, _] = grab.load(own, &self.simulation.body(grab.body), HELD_STEP_S);
        Some((grab, force_n))
    }

    /// Lets go of the body that is held.
    ///
    /// # Errors
    /// When the engine refuses it.
    pub fn release(&mut self) -> Result<(), PlayError> {
        let Some(grab) = self.grab.take() else { return Ok(()) };
        self.act(Action::Load { body: grab.body, force_n: DVec3::ZERO, torque_nm: DVec3::ZERO })
    }

    /// Pushes a body at a point (m, world) by an impulse (N s).
    ///
    /// # Errors
    /// When there is no such body, forces do not move it, or a number is not finite.
    pub fn push(&mut self, body: usize, point_m: DVec3, impulse_ns: DVec3) -> Result<(), PlayError> {
        let body = BodyId::new(body);
        self.body(body)?;
        self.act(Action::Push { body, impulse_ns, point_m })
    }

    /// Moves a body by so much, m: a second copy of a scene that begins almost alike.
    ///
    /// # Errors
    /// When the body is none, fixed, or held in its place.
    pub fn shift(&mut self, body: usize, by_m: DVec3) -> Result<(), PlayError> {
        let body = BodyId::new(body);
        self.body(body)?;
        self.act(Action::Shift { body, by_m })
    }

    /// Gives all materials another coefficient of friction, kinetic and static, from now on.
    ///
    /// # Errors
    /// When it is negative, or the tier has no friction.
    pub fn set_friction(&mut self, friction: f64) -> Result<(), PlayError> {
        self.set_materials(|own| Ok(own.with_friction(friction)?))
    }

    /// Gives all materials another coefficient of restitution, from now on.
    ///
    /// # Errors
    /// When it is outside [0, 1], or the tier cannot do it.
    pub fn set_restitution(&mut self, restitution: f64) -> Result<(), PlayError> {
        self.set_materials(|own| Ok(own.with_restitution(restitution)?))
    }

    fn set_materials(&mut self, change: impl Fn(Material) -> Result<Material, PlayError>) -> Result<(), PlayError> {
        let changed = self.materials().into_iter().map(change).collect::<Result<Vec<_>, _>>()?;
        changed.into_iter().try_for_each(|material| self.act(Action::Material(Box::new(material))))
    }

    /// The materials of the bodies at present, each once.
    pub fn materials(&self) -> Vec<Material> {
        let mut found: Vec<Material> = Vec::new();
        for material in self.simulation.materials() {
            if found.iter().all(|own| own.name() != material.name()) {
                found.push(material.clone());
            }
        }
        found
    }

    /// Goes back to the end of the last step at or before a time (s) that has passed; the time reached, s. What
    /// followed is forgotten, with its actions, and nobody holds a body.
    ///
    /// # Errors
    /// When the time has not been reached, or a snapshot is refused.
    pub fn rewind(&mut self, t_s: f64) -> Result<f64, PlayError> {
        let now_s = self.time();
        if !(t_s.is_finite() && t_s >= 0.0 && t_s <= now_s) {
            return Err(PlayError::Time { t_s, now_s });
        }
        self.return_to(self.timeline.steps_until(t_s))?;
        if let Some(body) = self.timeline.loaded_body() {
            self.act(Action::Load { body, force_n: DVec3::ZERO, torque_nm: DVec3::ZERO })?;
        }
        Ok(self.time())
    }

    /// As [`Playground::rewind`], and on to the time where the step that passed it was longer than a picture lasts:
    /// what bodies at rest do in one step takes as long as they rest.
    ///
    /// # Errors
    /// As [`Playground::rewind`].
    pub fn rewind_to(&mut self, t_s: f64) -> Result<f64, PlayError> {
        let left_s = t_s - self.rewind(t_s)?;
        if left_s > HELD_STEP_S { self.advance(Some(left_s)) } else { Ok(self.time()) }
    }

    /// Goes back to the state after so many steps.
    fn return_to(&mut self, steps: u64) -> Result<(), PlayError> {
        if steps == self.timeline.steps() {
            return Ok(());
        }
        self.grab = None;
        let Some(kept) = self.timeline.kept_before(steps).cloned() else { return Ok(()) };
        for material in &kept.materials {
            self.simulation.set_material(material)?;
        }
        self.simulation.restore(&kept.snapshot)?;
        self.hash.return_to(kept.hash);
        for step in kept.step..steps {
            let (within_s, actions) = self.timeline.made(step);
            actions.iter().try_for_each(|action| self.apply(action))?;
            self.make(within_s)?;
        }
        self.timeline.forget_after(steps);
        Ok(())
    }

    fn body(&self, body: BodyId) -> Result<&Body, PlayError> {
        let bodies = self.loaded.scene.bodies();
        bodies.get(body.index()).ok_or(PlayError::Body { index: body.index(), bodies: bodies.len() })
    }

    fn keep(&mut self) {
        let materials = self.materials();
        let (step, snapshot, hash) = (self.timeline.steps(), self.simulation.snapshot(), self.hash.place());
        self.timeline.keep(Kept { step, snapshot, hash, materials });
    }

    fn act(&mut self, action: Action) -> Result<(), PlayError> {
        if self.timeline.steps() == 0 && self.timeline.wants_snapshot() {
            self.keep();
        }
        self.apply(&action)?;
        self.timeline.act(action);
        Ok(())
    }

    fn apply(&mut self, action: &Action) -> Result<(), PlayError> {
        let simulation = &mut self.simulation;
        match action {
            Action::Load { body, force_n, torque_nm } => simulation.set_force(*body, *force_n, *torque_nm)?,
            Action::Push { body, impulse_ns, point_m } => simulation.apply_impulse(*body, *impulse_ns, *point_m)?,
            Action::Shift { body, by_m } => {
                let pose = simulation.body(*body).pose;
                simulation.set_pose(*body, Pose::new(pose.rotation, pose.translation + *by_m))?;
            }
            Action::Material(material) => simulation.set_material(material)?,
        }
        Ok(())
    }

    fn advance(&mut self, within_s: Option<f64>) -> Result<f64, PlayError> {
        let t_s = self.make(within_s)?;
        self.timeline.step(t_s, within_s);
        Ok(t_s)
    }

    fn make(&mut self, within_s: Option<f64>) -> Result<f64, PlayError> {
        let made = match within_s {
            Some(within_s) => self.simulation.step_within(within_s, &mut self.hash)?,
            None => self.simulation.step_observed(&mut self.hash)?,
        };
        Ok(made.t_s)
    }
}

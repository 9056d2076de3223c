//! A simulation in the hand: one thread uses it at a time, and the interpreter is free while it computes.

use crate::actions::{Driven, velocity_of};
use crate::arguments;
use crate::errors;
use crate::loaded::Loaded;
use crate::views::{BodyState, Contact, Coordinate, Energy, JointLoad, StepOutcome};
use polhode::{BodyId, BodySample, Effects, Flow, JointId, Observer, SimulationError, Steering};
use polhode_scene::{LoadedScene, scene_report_json};
use pyo3::exceptions::{PyRuntimeError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use std::sync::{Arc, Mutex, TryLockError};
use std::time::{Duration, Instant};

/// How long Ctrl-C may go unseen, and what it costs to look for it is nothing beside that.
const LOOK_EVERY: Duration = Duration::from_millis(50);

/// A scene that Python advances in time, asks and changes.
#[pyclass(frozen, subclass, module = "polhode._polhode")]
#[derive(Debug)]
pub(crate) struct Simulation {
    loaded: Arc<LoadedScene>,
    pub(crate) joint_names: Vec<String>,
    held: Mutex<Held>,
}

/// What one thread uses at a time.
#[derive(Debug)]
pub(crate) struct Held {
    pub(crate) simulation: polhode::Simulation,
    /// The names of all bodies by their numbers; those of removed ones are empty.
    pub(crate) body_names: Vec<String>,
}

impl Held {
    /// The number of a body that is given by its name or its number.
    pub(crate) fn body(&self, given: &Bound<'_, PyAny>) -> PyResult<BodyId> {
        let names: Vec<&str> = self.body_names.iter().map(String::as_str).collect();
        let present: Vec<&str> = names.iter().copied().filter(|name| !name.is_empty()).collect();
        match arguments::index_of("body", given, &names) {
            Ok(index) if names.get(index).is_some_and(|name| !name.is_empty()) => Ok(BodyId::new(index)),
            Ok(index) => Err(errors::unknown_name(given.py(), "body", &index.to_string(), &present)),
            Err(error) => Err(error),
        }
    }

    fn name(&self, body: BodyId) -> String {
        self.body_names.get(body.index()).cloned().unwrap_or_default()
    }
}

/// Looks for signals while a simulation advances.
struct Watch {
    looked: Instant,
    raised: Option<PyErr>,
}

impl Observer for Watch {
    fn sample(&mut self, _t_s: f64, _bodies: &[BodySample]) {}

    fn wants_samples(&self) -> bool {
        false
    }

    fn progress(&mut self, _t_s: f64) -> Flow {
        if self.looked.elapsed() < LOOK_EVERY {
            return Flow::Continue;
        }
        self.looked = Instant::now();
        self.raised = errors::raised_by_signal();
        if self.raised.is_some() { Flow::Stop } else { Flow::Continue }
    }
}

/// Advances under a watch; what a handler of a signal has raised is raised.
fn watched<T>(
    held: &mut Held,
    advance: impl FnOnce(&mut polhode::Simulation, &mut Watch) -> Result<T, SimulationError>,
) -> Result<PyResult<T>, SimulationError> {
    let mut watch = Watch { looked: Instant::now(), raised: None };
    let done = advance(&mut held.simulation, &mut watch)?;
    Ok(watch.raised.map_or(Ok(done), Err))
}

impl Simulation {
    /// Lets a thread use it, while the interpreter is free.
    pub(crate) fn using<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut Held) -> Result<T, SimulationError> + Send,
    ) -> PyResult<T> {
        let done = py.detach(|| {
            self.held
                .try_lock()
                .map(|mut held| work(&mut held))
                .map_err(|error| matches!(error, TryLockError::WouldBlock))
        });
        match done {
            Ok(done) => done.map_err(|error| errors::simulation(py, &self.loaded, error)),
            Err(is_busy) => Err(refused(py, is_busy)),
        }
    }

    /// Asks it something that needs Python and takes no time.
    pub(crate) fn asking<T>(&self, py: Python<'_>, ask: impl FnOnce(&Held) -> PyResult<T>) -> PyResult<T> {
        match self.held.try_lock() {
            Ok(held) => ask(&held),
            Err(error) => Err(refused(py, matches!(error, TryLockError::WouldBlock))),
        }
    }

    /// The number of a joint that is given by its name or its number.
    pub(crate) fn joint(&self, given: &Bound<'_, PyAny>) -> PyResult<JointId> {
        let names: Vec<&str> = self.joint_names.iter().map(String::as_str).collect();
        let index = arguments::index_of("joint", given, &names)?;
        if index < names.len() {
            return Ok(JointId::new(index));
        }
        Err(errors::unknown_name(given.py(), "joint", &index.to_string(), &names))
    }

    /// The coordinate that is meant of a joint: the one of this name, or its first.
    pub(crate) fn coordinate_of(
        &self,
        py: Python<'_>,
        joint: JointId,
        name: Option<&str>,
    ) -> PyResult<polhode::scene::Coordinate> {
        let joints = self.loaded.scene.joints();
        let own = joints.get(joint.index()).map_or(&[][..], |joint| joint.kind().coordinates());
        let found = match name {
            None => own.first(),
            Some(name) => own.iter().find(|coordinate| coordinate.name() == name),
        };
        let names: Vec<&str> = own.iter().map(|coordinate| coordinate.name()).collect();
        found.copied().ok_or_else(|| errors::unknown_name(py, "coordinate", name.unwrap_or("(the first)"), &names))
    }
}

/// Why it cannot be used now.
fn refused(py: Python<'_>, is_busy: bool) -> PyErr {
    if is_busy {
        return errors::busy(py);
    }
    PyRuntimeError::new_err(
        "this simulation broke off in the middle of a step, which is a bug: it can no longer be used",
    )
}

pub(crate) fn state(sample: &BodySample) -> BodyState {
    BodyState {
        position: sample.pose.translation.to_array(),
        orientation: sample.pose.rotation.to_wxyz(),
        velocity: sample.velocity.linear.to_array(),
        angular_velocity: sample.velocity.angular.to_array(),
    }
}

#[pymethods]
impl Simulation {
    #[new]
    fn new(py: Python<'_>, loaded: &Loaded, all_effects: bool) -> PyResult<Self> {
        let loaded = Arc::clone(&loaded.scene);
        let effects = if all_effects { Effects::All } else { Effects::Planned };
        let made = py.detach(|| polhode::Simulation::with_effects(&loaded.scene, effects));
        let simulation = made.map_err(|error| errors::simulation(py, &loaded, error))?;
        let body_names = loaded.scene.bodies().iter().map(|body| body.name().to_owned()).collect();
        let joint_names = loaded.joint_names();
        Ok(Self { loaded, joint_names, held: Mutex::new(Held { simulation, body_names }) })
    }

    /// Time reached, s.
    #[getter]
    fn time(&self, py: Python<'_>) -> PyResult<f64> {
        self.asking(py, |held| Ok(held.simulation.time()))
    }

    /// Whether the end of the scene's duration has been reached.
    #[getter]
    fn has_ended(&self, py: Python<'_>) -> PyResult<bool> {
        self.asking(py, |held| Ok(held.simulation.has_ended()))
    }

    /// Names of the bodies, without those that were removed.
    #[getter]
    fn body_names(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        let present = |held: &Held| held.body_names.iter().filter(|name| !name.is_empty()).cloned().collect();
        self.asking(py, |held| Ok(present(held)))
    }

    /// Names of the joints.
    #[getter]
    fn joint_names(&self) -> Vec<String> {
        self.joint_names.clone()
    }

    /// Makes one step, which ends at the first event in it.
    fn step(&self, py: Python<'_>) -> PyResult<StepOutcome> {
        let done = self.using(py, |held| held.simulation.step())?;
        Ok(StepOutcome { t: done.t_s, is_event: done.is_event() })
    }

    /// Advances exactly to a time, s. Ctrl-C ends it after a step.
    fn advance_to(&self, py: Python<'_>, t: f64) -> PyResult<()> {
        self.using(py, |held| watched(held, |simulation, watch| simulation.advance_to_observed(t, watch)))?
    }

    /// Runs to the end of the scene's duration; the report, as JSON. Ctrl-C ends it after a step.
    fn run_to_end(&self, py: Python<'_>) -> PyResult<String> {
        let begun = Instant::now();
        let report =
            self.using(py, |held| watched(held, |simulation, watch| simulation.run_observed(watch).map(Box::new)))??;
        Ok(scene_report_json(&self.loaded, &report, begun.elapsed().as_secs_f64()).to_string())
    }

    /// Pose and velocity of a body.
    fn body(&self, py: Python<'_>, body: &Bound<'_, PyAny>) -> PyResult<BodyState> {
        self.asking(py, |held| Ok(state(&held.simulation.body(held.body(body)?))))
    }

    /// Poses and velocities of all bodies, by their names.
    fn bodies<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let given = PyDict::new(py);
        self.asking(py, |held| {
            for (name, sample) in held.body_names.iter().zip(held.simulation.bodies()) {
                if !name.is_empty() {
                    given.set_item(name, state(&sample))?;
                }
            }
            Ok(given)
        })
    }

    /// Contacts that touch, with their forces.
    fn contacts(&self, py: Python<'_>) -> PyResult<Vec<Contact>> {
        self.using(py, |held| {
            let views = held.simulation.contacts();
            Ok(views.iter().map(|view| contact(held, view)).collect())
        })
    }

    /// Forces and moments of the joints.
    fn joint_loads(&self, py: Python<'_>) -> PyResult<Vec<JointLoad>> {
        let views = self.using(py, |held| Ok(held.simulation.joint_loads()))?;
        let load = |view: &polhode::JointView| JointLoad {
            joint: self.joint_names.get(view.joint.index()).cloned().unwrap_or_default(),
            point: view.point_m.to_array(),
            force: view.force_n.to_array(),
            torque: view.moment_n_m.to_array(),
        };
        Ok(views.iter().map(load).collect())
    }

    /// A coordinate of a joint: the one of this name, or its first.
    #[pyo3(signature = (joint, coordinate=None))]
    fn coordinate(&self, py: Python<'_>, joint: &Bound<'_, PyAny>, coordinate: Option<&str>) -> PyResult<Coordinate> {
        let id = self.joint(joint)?;
        let coordinate = self.coordinate_of(py, id, coordinate)?;
        let found = self.asking(py, |held| Ok(held.simulation.coordinate(id, coordinate)))?;
        let gone =
            || errors::plain(py, "ActionError", "the joint was removed with a body: it has no coordinate any more");
        let found = found.ok_or_else(gone)?;
        Ok(Coordinate { value: found.value, rate: found.rate })
    }

    /// The islands: the names of bodies that move together or rest together.
    fn islands(&self, py: Python<'_>) -> PyResult<Vec<Vec<String>>> {
        self.asking(py, |held| {
            let islands = held.simulation.islands();
            Ok(islands.iter().map(|island| island.bodies.iter().map(|&body| held.name(body)).collect()).collect())
        })
    }

    /// Energies.
    fn energy(&self, py: Python<'_>) -> PyResult<Energy> {
        let energy = self.using(py, |held| Ok(held.simulation.energy()))?;
        let (kinetic, potential, total, initial) =
            (energy.kinetic_j, energy.potential_j, energy.final_j, energy.initial_j);
        Ok(Energy { kinetic, potential, total, initial })
    }

    /// How far the bodies at rest are from moving, as JSON.
    fn stability_json(&self, py: Python<'_>) -> PyResult<String> {
        let stability = self.using(py, |held| held.simulation.stability())?;
        Ok(polhode_scene::stability_json(&self.loaded.scene, &stability).to_string())
    }

    /// Everything from which `restore` continues with the same bits.
    fn snapshot(&self, py: Python<'_>) -> PyResult<Snapshot> {
        self.using(py, |held| Ok(Snapshot { snapshot: held.simulation.snapshot() }))
    }

    /// Continues from a snapshot of a simulation of the same scene.
    fn restore(&self, py: Python<'_>, snapshot: &Snapshot) -> PyResult<()> {
        self.using(py, |held| held.simulation.restore(&snapshot.snapshot))
    }

    /// Applies a force (N) at the centre of mass of a body and a torque (N m) until they are set again.
    #[pyo3(signature = (body, force=None, torque=None))]
    fn set_force(
        &self,
        py: Python<'_>,
        body: &Bound<'_, PyAny>,
        force: Option<&Bound<'_, PyAny>>,
        torque: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let force = arguments::vector_or_zero("force", force)?;
        let torque = arguments::vector_or_zero("torque", torque)?;
        let body = self.body_id_of(py, body)?;
        self.using(py, |held| held.simulation.set_force(body, force, torque))
    }

    /// Applies an impulse (N s) to a body at a point (m, world).
    fn apply_impulse(
        &self,
        py: Python<'_>,
        body: &Bound<'_, PyAny>,
        impulse: &Bound<'_, PyAny>,
        point: &Bound<'_, PyAny>,
    ) -> PyResult<()> {
        let (impulse, point) = (arguments::vector("impulse", impulse)?, arguments::vector("point", point)?);
        let body = self.body_id_of(py, body)?;
        self.using(py, |held| held.simulation.apply_impulse(body, impulse, point))
    }

    /// Sets the velocity of the centre of mass of a body (m/s) and its angular velocity (rad/s).
    #[pyo3(signature = (body, velocity=None, angular_velocity=None))]
    fn set_velocity(
        &self,
        py: Python<'_>,
        body: &Bound<'_, PyAny>,
        velocity: Option<&Bound<'_, PyAny>>,
        angular_velocity: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let velocity = velocity_of(velocity, angular_velocity)?;
        let body = self.body_id_of(py, body)?;
        self.using(py, |held| held.simulation.set_velocity(body, velocity))
    }

    /// Sets the pose of a body: position of its origin (m) and orientation (w, x, y, z).
    #[pyo3(signature = (body, position, orientation=None))]
    fn set_pose(
        &self,
        py: Python<'_>,
        body: &Bound<'_, PyAny>,
        position: &Bound<'_, PyAny>,
        orientation: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let pose = arguments::pose(position, orientation)?;
        let body = self.body_id_of(py, body)?;
        self.using(py, |held| held.simulation.set_pose(body, pose))
    }

    /// Steers a kinematic body by a velocity from now on; none halts it.
    #[pyo3(signature = (body, velocity=None, angular_velocity=None))]
    fn steer(
        &self,
        py: Python<'_>,
        body: &Bound<'_, PyAny>,
        velocity: Option<&Bound<'_, PyAny>>,
        angular_velocity: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let velocity = velocity_of(velocity, angular_velocity)?;
        let body = self.body_id_of(py, body)?;
        self.using(py, |held| held.simulation.set_motion(body, Steering::Velocity(velocity)))
    }

    /// Steers a kinematic body to a pose that it reaches within a time, s.
    #[pyo3(signature = (body, position, orientation=None, *, within))]
    fn steer_to(
        &self,
        py: Python<'_>,
        body: &Bound<'_, PyAny>,
        position: &Bound<'_, PyAny>,
        orientation: Option<&Bound<'_, PyAny>>,
        within: f64,
    ) -> PyResult<()> {
        let pose = arguments::pose(position, orientation)?;
        let body = self.body_id_of(py, body)?;
        self.using(py, |held| held.simulation.set_motion(body, Steering::Pose { pose, within_s: within }))
    }

    /// Gives a coordinate of a joint the motor that a dictionary describes, or none.
    fn give_motor(
        &self,
        py: Python<'_>,
        joint: &Bound<'_, PyAny>,
        coordinate: Option<&str>,
        driven: &Bound<'_, PyAny>,
    ) -> PyResult<()> {
        let driven: Driven = driven.extract().map_err(|_| PyTypeError::new_err("a motor is given by numbers"))?;
        let (joint, motor) = (self.joint(joint)?, driven.motor()?);
        let coordinate = self.coordinate_of(py, joint, coordinate)?;
        self.using(py, |held| held.simulation.set_motor(joint, coordinate, motor))
    }

    /// Adds the first body of a scene.
    fn add_first_body(&self, py: Python<'_>, loaded: &Loaded) -> PyResult<()> {
        let Some(body) = loaded.scene.scene.bodies().first() else {
            return Err(errors::plain(py, "ActionError", "there is no body to add"));
        };
        self.using(py, |held| {
            let id = held.simulation.add_body(body.clone())?;
            held.body_names.resize(id.index(), String::new());
            held.body_names.push(body.name().to_owned());
            Ok(())
        })
    }

    /// Removes a body. Those that rested on it are no longer supported.
    fn remove_body(&self, py: Python<'_>, body: &Bound<'_, PyAny>) -> PyResult<()> {
        let body = self.body_id_of(py, body)?;
        self.using(py, |held| {
            held.simulation.remove_body(body)?;
            if let Some(name) = held.body_names.get_mut(body.index()) {
                name.clear();
            }
            Ok(())
        })
    }
}

impl Simulation {
    fn body_id_of(&self, py: Python<'_>, body: &Bound<'_, PyAny>) -> PyResult<BodyId> {
        self.asking(py, |held| held.body(body))
    }
}

fn contact(held: &Held, view: &polhode::ContactView) -> Contact {
    Contact {
        body_a: held.name(view.body_a),
        body_b: held.name(view.body_b),
        point: view.point_m.to_array(),
        normal: view.normal.to_array(),
        separation: view.separation_m,
        normal_force: view.normal_force_n,
        friction: view.friction_n.to_array(),
    }
}

/// A simulation at one time.
#[pyclass(frozen, module = "polhode._polhode")]
#[derive(Debug)]
pub(crate) struct Snapshot {
    snapshot: polhode::Snapshot,
}

#[pymethods]
impl Snapshot {
    /// The snapshot in these bytes.
    #[staticmethod]
    fn from_bytes(py: Python<'_>, bytes: &[u8]) -> PyResult<Self> {
        let snapshot = polhode::Snapshot::from_bytes(bytes).map_err(|error| errors::snapshot(py, &error))?;
        Ok(Self { snapshot })
    }

    /// The snapshot as bytes, with a version and a checksum.
    fn to_bytes<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, &self.snapshot.to_bytes())
    }

    /// Name of the scene.
    #[getter]
    fn scene(&self) -> &str {
        self.snapshot.scene()
    }

    /// Simulated time, s.
    #[getter]
    fn time(&self) -> f64 {
        self.snapshot.time()
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.snapshot == other.snapshot
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let read = py.get_type::<Self>().getattr("from_bytes")?;
        Ok((read, (self.to_bytes(py),)).into_pyobject(py)?.into_any())
    }

    fn __repr__(&self) -> String {
        format!("Snapshot(scene={:?}, time={})", self.scene(), self.time())
    }
}

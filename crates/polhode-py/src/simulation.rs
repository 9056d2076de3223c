//! A simulation in the hand: one thread uses it at a time, and the interpreter is free while it computes.

use crate::actions::{Driven, velocity_of};
use crate::arguments;
use crate::errors;
use crate::loaded::Loaded;
use crate::recording::{EventColumns, event_columns};
use crate::views::{BodyState, Contact, Coordinate, Energy, JointLoad, Momentum, StepOutcome};
use polhode::scene::{Joint, JointKind};
use polhode::{BodyId, BodySample, Effects, Event, Flow, JointId, Observer, OneThread, SimulationError, Steering};
use polhode_scene::{LoadedScene, certificate_json, scene_report_json};
use polhode_study::Threads;
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
    held: Mutex<Held>,
}

/// What one thread uses at a time.
#[derive(Debug)]
pub(crate) struct Held {
    pub(crate) simulation: polhode::Simulation,
    /// The names of all bodies by their numbers; those of removed ones are empty.
    pub(crate) body_names: Vec<String>,
    /// The names and kinds of all joints by their numbers.
    joints: Vec<(String, JointKind)>,
    /// The events so far, where they are kept.
    events: Option<Vec<Event>>,
}

/// The number of what is given by its name or its number; names of what was removed are empty.
fn present(kind: &str, given: &Bound<'_, PyAny>, names: &[&str]) -> PyResult<usize> {
    let known: Vec<&str> = names.iter().copied().filter(|name| !name.is_empty()).collect();
    match arguments::index_of(kind, given, names, &known)? {
        index if names.get(index).is_some_and(|name| !name.is_empty()) => Ok(index),
        index => Err(errors::unknown_name(given.py(), kind, &index.to_string(), &known)),
    }
}

impl Held {
    /// The number of a body that is given by its name or its number.
    pub(crate) fn body(&self, given: &Bound<'_, PyAny>) -> PyResult<BodyId> {
        let names: Vec<&str> = self.body_names.iter().map(String::as_str).collect();
        present("body", given, &names).map(BodyId::new)
    }

    /// The number of a joint that is given by its name or its number.
    fn joint(&self, given: &Bound<'_, PyAny>) -> PyResult<JointId> {
        present("joint", given, &self.joint_names()).map(JointId::new)
    }

    /// The names of all joints by their numbers; those of joints that hold nothing any more are empty.
    fn joint_names(&self) -> Vec<&str> {
        let is_there = |number: usize| self.simulation.has_joint(JointId::new(number));
        let joints = self.joints.iter().enumerate();
        joints.map(|(number, (name, _))| if is_there(number) { name.as_str() } else { "" }).collect()
    }

    /// The coordinate that is meant of a joint: the one of this name, or its first.
    fn coordinate(&self, py: Python<'_>, joint: JointId, name: Option<&str>) -> PyResult<polhode::scene::Coordinate> {
        let own = self.joints.get(joint.index()).map_or(&[][..], |(_, kind)| kind.coordinates());
        let found = match name {
            None => own.first(),
            Some(name) => own.iter().find(|coordinate| coordinate.name() == name),
        };
        let names: Vec<&str> = own.iter().map(|coordinate| coordinate.name()).collect();
        found.copied().ok_or_else(|| errors::unknown_name(py, "coordinate", name.unwrap_or("(the first)"), &names))
    }

    fn name(&self, body: BodyId) -> String {
        self.body_names.get(body.index()).cloned().unwrap_or_default()
    }
}

/// Looks for signals while a simulation advances, and keeps its events where they are kept.
struct Watch<'a> {
    looked: Instant,
    raised: Option<PyErr>,
    events: Option<&'a mut Vec<Event>>,
}

impl Observer for Watch<'_> {
    fn event(&mut self, event: &Event) {
        if let Some(events) = &mut self.events {
            events.push(*event);
        }
    }

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
    advance: impl FnOnce(&mut polhode::Simulation, &mut Watch<'_>) -> Result<T, SimulationError>,
) -> Result<PyResult<T>, SimulationError> {
    let mut watch = Watch { looked: Instant::now(), raised: None, events: held.events.as_mut() };
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
    fn new(py: Python<'_>, loaded: &Loaded, all_effects: bool, keep_events: bool) -> PyResult<Self> {
        let loaded = Arc::clone(&loaded.scene);
        let effects = if all_effects { Effects::All } else { Effects::Planned };
        let made = py.detach(|| polhode::Simulation::with_effects(&loaded.scene, effects));
        let simulation = made.map_err(|error| errors::simulation(py, &loaded, error))?;
        let body_names = loaded.scene.bodies().iter().map(|body| body.name().to_owned()).collect();
        let kinds = loaded.scene.joints().iter().map(Joint::kind);
        let joints = loaded.joint_names().into_iter().zip(kinds).collect();
        let events = keep_events.then(Vec::new);
        Ok(Self { loaded, held: Mutex::new(Held { simulation, body_names, joints, events }) })
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

    /// Names of the joints, without those that hold nothing any more.
    #[getter]
    fn joint_names(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        let present = |held: &Held| {
            let names = held.joint_names().into_iter();
            names.filter(|name| !name.is_empty()).map(str::to_owned).collect()
        };
        self.asking(py, |held| Ok(present(held)))
    }

    /// Makes one step, of at most `dt` (s) where that is given, which ends at the first event in it.
    #[pyo3(signature = (dt=None))]
    fn step(&self, py: Python<'_>, dt: Option<f64>) -> PyResult<StepOutcome> {
        let done = self.using(py, |held| {
            watched(held, |simulation, watch| match dt {
                None => simulation.step_observed(watch),
                Some(dt) => simulation.step_within(dt, watch),
            })
        })??;
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
        let (views, names) = self.using(py, |held| {
            let names: Vec<String> = held.joints.iter().map(|(name, _)| name.clone()).collect();
            Ok((held.simulation.joint_loads(), names))
        })?;
        let load = |view: &polhode::JointView| JointLoad {
            joint: names.get(view.joint.index()).cloned().unwrap_or_default(),
            point: view.point_m.to_array(),
            force: view.force_n.to_array(),
            torque: view.moment_n_m.to_array(),
        };
        Ok(views.iter().map(load).collect())
    }

    /// A coordinate of a joint: the one of this name, or its first.
    #[pyo3(signature = (joint, coordinate=None))]
    fn coordinate(&self, py: Python<'_>, joint: &Bound<'_, PyAny>, coordinate: Option<&str>) -> PyResult<Coordinate> {
        let found = self.asking(py, |held| {
            let id = held.joint(joint)?;
            Ok(held.simulation.coordinate(id, held.coordinate(py, id, coordinate)?))
        })?;
        let gone = || errors::plain(py, "ActionError", "the joint holds nothing any more: it has no coordinate");
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

    /// Momentum of all bodies.
    fn momentum(&self, py: Python<'_>) -> PyResult<Momentum> {
        let momentum = self.using(py, |held| Ok(held.simulation.momentum()))?;
        Ok(Momentum { linear: momentum.linear.to_array(), angular: momentum.angular.to_array() })
    }

    /// The report and the certificate of what was computed so far, as JSON.
    fn told_json(&self, py: Python<'_>) -> PyResult<(String, String)> {
        let report = self.using(py, |held| held.simulation.report_so_far().map(Box::new))?;
        let text = scene_report_json(&self.loaded, &report, 0.0).to_string();
        Ok((text, certificate_json(&report).to_string()))
    }

    /// The events so far as columns, with the names of all bodies by their numbers; none where they are not kept.
    fn event_columns<'py>(&self, py: Python<'py>) -> PyResult<Option<(Vec<String>, EventColumns<'py>)>> {
        self.asking(py, |held| {
            let samples = held.simulation.bodies().len();
            let mut names = held.body_names.clone();
            names.resize(samples, String::new());
            held.events.as_ref().map(|events| Ok((names, event_columns(py, events)?))).transpose()
        })
    }

    /// How far the bodies at rest are from moving, as JSON.
    fn stability_json(&self, py: Python<'_>) -> PyResult<String> {
        let stability = self.using(py, |held| {
            held.simulation.set_executor(Arc::new(Threads::of_machine()));
            let stability = held.simulation.stability();
            held.simulation.set_executor(Arc::new(OneThread));
            stability
        })?;
        Ok(polhode_scene::stability_json(&self.loaded.scene, &stability).to_string())
    }

    /// Everything from which `restore` continues with the same bits.
    fn snapshot(&self, py: Python<'_>) -> PyResult<Snapshot> {
        self.using(py, |held| Ok(Snapshot { snapshot: held.simulation.snapshot() }))
    }

    /// Continues from a snapshot of a simulation of the same scene.
    fn restore(&self, py: Python<'_>, snapshot: &Snapshot) -> PyResult<()> {
        self.using(py, |held| {
            held.simulation.restore(&snapshot.snapshot)?;
            if let Some(events) = &mut held.events {
                let t = held.simulation.time();
                events.retain(|event| event.t_s <= t);
            }
            Ok(())
        })
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
        let motor = driven.motor()?;
        let (joint, coordinate) = self.asking(py, |held| {
            let joint = held.joint(joint)?;
            Ok((joint, held.coordinate(py, joint, coordinate)?))
        })?;
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

    /// Adds the first joint of a scene, between bodies of this one that have the names of its bodies there.
    fn add_first_joint(&self, py: Python<'_>, loaded: &Loaded) -> PyResult<()> {
        let (scene, name) = (&loaded.scene.scene, loaded.scene.joint_names().into_iter().next());
        let (Some(joint), Some(name)) = (scene.joints().first(), name) else {
            return Err(errors::plain(py, "ActionError", "there is no joint to add"));
        };
        let bodies = scene.bodies();
        let of_name = |held: &Held, id: BodyId| {
            let name = bodies.get(id.index()).map_or("", polhode::Body::name);
            held.body_names.iter().position(|own| own == name).map_or(id, BodyId::new)
        };
        let done = self.using(py, |held| {
            let joint = joint.of(of_name(held, joint.body()), joint.other().map(|other| of_name(held, other)));
            let added = held.simulation.add_joint(joint);
            Ok(added.map(|_| held.joints.push((name, joint.kind()))))
        })?;
        done.map_err(|error| errors::action(py, &self.loaded, error))
    }

    /// Removes a joint: what it held moves on without it.
    fn remove_joint(&self, py: Python<'_>, joint: &Bound<'_, PyAny>) -> PyResult<()> {
        let joint = self.asking(py, |held| held.joint(joint))?;
        self.using(py, |held| held.simulation.remove_joint(joint))
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

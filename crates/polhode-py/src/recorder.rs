//! The observer that keeps what a run tells, in columns.

use crate::job::Watch;
use crate::telling::Telling;
use polhode::scene::Coordinate;
use polhode::{BodyError, BodySample, Energy, ErrorEstimation, Event, Flow, Frame, JointSample, Observer, Scene};
use std::collections::TryReserveError;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Numbers of a body in a sample: position, orientation, velocity, angular velocity.
pub(crate) const OF_BODY: usize = 13;
/// Numbers of the estimated error of a body in a sample: position, rotation.
pub(crate) const OF_ERROR: usize = 2;
/// Numbers of a joint in a sample: value and rate of each coordinate, force, moment, power.
pub(crate) const OF_JOINT: usize = 2 * Coordinate::ALL.len() + 7;
/// Numbers of the energy in a sample: kinetic, potential.
pub(crate) const OF_ENERGY: usize = 2;

/// What a run has told: each list has the numbers of one sample after those of another.
#[derive(Debug, Default)]
pub(crate) struct Columns {
    pub(crate) times: Vec<f64>,
    pub(crate) states: Vec<f64>,
    /// Not a number where an error is not known; empty where none is.
    pub(crate) errors: Vec<f64>,
    pub(crate) energies: Vec<f64>,
    pub(crate) joints: Vec<f64>,
    pub(crate) events: Vec<Event>,
    /// Whether nothing more is kept: who asked for the run has taken the rest and gone.
    is_closed: bool,
}

impl Columns {
    /// Room for all samples of a scene, so that no list ever moves.
    ///
    /// # Errors
    /// When there is no memory for them.
    pub(crate) fn for_scene(scene: &Scene, has_joints: bool) -> Result<Self, TryReserveError> {
        // The first sample is t = 0, the last the duration, whether or not it is a multiple of the interval.
        let samples = (scene.duration_s() / scene.output_interval_s()) as usize + 2;
        let joints = if has_joints { scene.joints().len() } else { 0 };
        let mut columns = Self::default();
        columns.times.try_reserve_exact(samples)?;
        columns.states.try_reserve_exact(samples.saturating_mul(scene.bodies().len() * OF_BODY))?;
        if scene.method().error.unwrap_or_default() != ErrorEstimation::Off {
            columns.errors.try_reserve_exact(samples.saturating_mul(scene.bodies().len() * OF_ERROR))?;
        }
        columns.energies.try_reserve_exact(samples.saturating_mul(OF_ENERGY))?;
        columns.joints.try_reserve_exact(samples.saturating_mul(joints * OF_JOINT))?;
        Ok(columns)
    }

    /// Takes what has been kept, and keeps nothing more. Of a sample that is not complete nothing is given.
    pub(crate) fn close(&mut self, [bodies, joints]: [usize; 2]) -> Self {
        let mut taken = std::mem::replace(self, Self { is_closed: true, ..Self::default() });
        let complete = |length: usize, of_one: usize| length.checked_div(of_one).unwrap_or(usize::MAX);
        let samples = (taken.times.len())
            .min(complete(taken.states.len(), bodies * OF_BODY))
            .min(taken.energies.len() / OF_ENERGY)
            .min(complete(taken.joints.len(), joints * OF_JOINT));
        taken.times.truncate(samples);
        taken.states.truncate(samples * bodies * OF_BODY);
        // The errors of samples are told later than these.
        if !taken.errors.is_empty() {
            taken.errors.resize(samples * bodies * OF_ERROR, f64::NAN);
        }
        taken.energies.truncate(samples * OF_ENERGY);
        taken.joints.truncate(samples * joints * OF_JOINT);
        taken
    }
}

/// What the thread of a run and the one that waits for it share.
#[derive(Debug)]
pub(crate) struct Shared {
    columns: Mutex<Columns>,
}

impl Shared {
    pub(crate) fn new(columns: Columns) -> Arc<Self> {
        Arc::new(Self { columns: Mutex::new(columns) })
    }

    pub(crate) fn columns(&self) -> MutexGuard<'_, Columns> {
        self.columns.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Keeps samples, energies, joints and events of a run.
#[derive(Debug)]
pub(crate) struct Recorder<'a> {
    pub(crate) shared: Arc<Shared>,
    /// Whether joints are kept: what they bear costs a solve at each sample.
    pub(crate) has_joints: bool,
    pub(crate) watch: &'a Watch,
    pub(crate) duration_s: f64,
    /// What pages and plots tell, where that is kept too.
    pub(crate) telling: Option<Telling>,
}

impl Observer for Recorder<'_> {
    fn sample(&mut self, t_s: f64, bodies: &[BodySample]) {
        if let Some(telling) = &mut self.telling {
            telling.sample(t_s, bodies);
        }
        let mut columns = self.shared.columns();
        if columns.is_closed {
            return;
        }
        columns.times.push(t_s);
        for body in bodies {
            columns.states.extend(body.pose.translation.to_array());
            columns.states.extend(body.pose.rotation.to_wxyz());
            columns.states.extend(body.velocity.linear.to_array());
            columns.states.extend(body.velocity.angular.to_array());
        }
    }

    fn wants_energies(&self) -> bool {
        true
    }

    fn energy(&mut self, _t_s: f64, energy: &Energy) {
        let mut columns = self.shared.columns();
        if !columns.is_closed {
            columns.energies.extend([energy.kinetic_j, energy.potential_j]);
        }
    }

    fn wants_errors(&self) -> bool {
        true
    }

    fn errors(&mut self, t_s: f64, errors: Option<&[BodyError]>) {
        if let Some(telling) = &mut self.telling {
            telling.errors(t_s, errors);
        }
        let mut columns = self.shared.columns();
        if let Some(errors) = errors.filter(|_| !columns.is_closed) {
            columns.errors.extend(errors.iter().flat_map(|error| [error.position_m, error.rotation_rad]));
        }
    }

    fn wants_frames(&self) -> bool {
        self.telling.is_some()
    }

    fn frame(&mut self, frame: &Frame) {
        if let Some(telling) = &mut self.telling {
            telling.frame(frame);
        }
    }

    fn wants_joints(&self) -> bool {
        self.has_joints || self.telling.as_ref().is_some_and(Observer::wants_joints)
    }

    fn joints(&mut self, t_s: f64, joints: &[JointSample]) {
        if let Some(telling) = &mut self.telling {
            telling.joints(t_s, joints);
        }
        let mut columns = self.shared.columns();
        if columns.is_closed || !self.has_joints {
            return;
        }
        for joint in joints {
            for coordinate in Coordinate::ALL {
                let found = joint.coordinates.iter().find(|(own, _)| *own == coordinate).map(|(_, found)| found);
                columns.joints.extend(found.map_or([f64::NAN; 2], |found| [found.value, found.rate]));
            }
            let load = joint.load.map(|load| [load.force_n.to_array(), load.moment_n_m.to_array()]);
            columns.joints.extend(load.unwrap_or([[f64::NAN; 3]; 2]).as_flattened());
            columns.joints.push(joint.power_w.unwrap_or(f64::NAN));
        }
    }

    fn event(&mut self, event: &Event) {
        if let Some(telling) = &mut self.telling {
            telling.event(event);
        }
        let mut columns = self.shared.columns();
        if !columns.is_closed {
            columns.events.push(*event);
        }
    }

    fn progress(&mut self, t_s: f64) -> Flow {
        if let Some(telling) = &mut self.telling {
            telling.progress(t_s);
        }
        self.watch.reached(t_s, self.duration_s)
    }
}

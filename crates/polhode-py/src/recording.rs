//! What a run has told, as arrays of numpy.
//!
//! Each column is moved into its array when that is first asked for, so that numpy is loaded no earlier, and nothing is
//! copied.

use crate::drawn::Drawn;
use crate::recorder::{Columns, OF_BODY, OF_ENERGY, OF_ERROR, OF_JOINT};
use crate::telling::Unread;
use numpy::ndarray::{Array2, Dimension};
use numpy::{PyArray, PyArray1, PyArray2, PyArrayDyn, PyArrayMethods};
use polhode::{Effects, Event};
use polhode_scene::LoadedScene;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use std::sync::{Arc, Mutex, PoisonError};

/// A column: numbers until it is first asked for, an array from then on.
struct Column {
    numbers: Mutex<Vec<f64>>,
    shape: Shape,
    array: PyOnceLock<Py<PyAny>>,
}

/// How the numbers of a column are arranged.
#[derive(Debug, Clone, Copy)]
enum Shape {
    /// One number for each sample.
    Line,
    /// So many samples of so many numbers.
    Table(usize, usize),
}

impl Column {
    fn new(numbers: Vec<f64>, shape: Shape) -> Self {
        Self { numbers: Mutex::new(numbers), shape, array: PyOnceLock::new() }
    }

    /// The array, which cannot be written to.
    fn array(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        let make = || {
            let numbers = std::mem::take(&mut *self.numbers.lock().unwrap_or_else(PoisonError::into_inner));
            match self.shape {
                Shape::Line => Ok(sealed(PyArray1::from_vec(py, numbers))),
                Shape::Table(samples, width) => {
                    let table = Array2::from_shape_vec((samples, width), numbers);
                    let table = table.map_err(|error| PyRuntimeError::new_err(format!("a column is torn: {error}")))?;
                    Ok(sealed(PyArray2::from_owned_array(py, table)))
                }
            }
        };
        self.array.get_or_try_init(py, make).map(|array| array.clone_ref(py))
    }

    /// Reads the numbers, wherever they are.
    fn read<T>(&self, py: Python<'_>, read: impl FnOnce(&[f64]) -> T) -> PyResult<T> {
        let Some(array) = self.array.get(py) else {
            return Ok(read(&self.numbers.lock().unwrap_or_else(PoisonError::into_inner)));
        };
        let array = array.bind(py).cast::<PyArrayDyn<f64>>()?.readonly();
        Ok(read(array.as_slice()?))
    }
}

/// The array without leave to write to it, nor to what is a part of it.
fn sealed<D: Dimension>(array: Bound<'_, PyArray<f64, D>>) -> Py<PyAny> {
    drop(array.readwrite().make_nonwriteable());
    array.into_any().unbind()
}

/// What a run has told.
#[pyclass(frozen, module = "polhode._polhode")]
pub(crate) struct Recording {
    times: Column,
    states: Column,
    /// None of a run whose errors are not known.
    errors: Option<Column>,
    energies: Column,
    joints: Column,
    events: Vec<Event>,
    /// Names of the bodies, in the order of their numbers.
    #[pyo3(get)]
    body_names: Vec<String>,
    /// Names of the joints of which the run has told.
    #[pyo3(get)]
    joint_names: Vec<String>,
    /// The report as JSON; none of a run that has none.
    #[pyo3(get)]
    report: Option<String>,
    /// The certificate as JSON; none of a run that has no report.
    #[pyo3(get)]
    certificate: Option<String>,
    /// The limits of the promise that were exceeded, as JSON.
    #[pyo3(get)]
    broken: String,
    /// Why the run has ended before its time: an exception, or none.
    #[pyo3(get)]
    failure: Option<Py<PyAny>>,
    pub(crate) source: Source,
    /// All plots, from when they were first drawn.
    drawn: Mutex<Option<Arc<Drawn>>>,
    /// The page, where the run was asked to keep it and nobody has asked for it yet.
    page: Mutex<Option<Unread>>,
}

/// From what the same run can be made again, to the same bits.
#[derive(Debug)]
pub(crate) struct Source {
    pub(crate) scene: Arc<LoadedScene>,
    pub(crate) effects: Effects,
    /// Whether it was ended before its time by who asked for it.
    pub(crate) is_cut: bool,
}

/// How a run has ended.
#[derive(Debug, Default)]
pub(crate) struct Ending {
    pub(crate) report: Option<String>,
    pub(crate) certificate: Option<String>,
    pub(crate) broken: String,
    pub(crate) failure: Option<Py<PyAny>>,
}

impl Recording {
    pub(crate) fn new(columns: Columns, names: [Vec<String>; 2], ending: Ending, source: Source) -> Self {
        let [body_names, joint_names] = names;
        let Columns { times, states, errors, energies, joints, events, .. } = columns;
        let Ending { report, certificate, broken, failure } = ending;
        let samples = times.len();
        let table = |width: usize| Shape::Table(samples, width);
        Self {
            times: Column::new(times, Shape::Line),
            states: Column::new(states, table(body_names.len() * OF_BODY)),
            errors: (!errors.is_empty()).then(|| Column::new(errors, table(body_names.len() * OF_ERROR))),
            energies: Column::new(energies, table(OF_ENERGY)),
            joints: Column::new(joints, table(joint_names.len() * OF_JOINT)),
            events,
            body_names,
            joint_names,
            report,
            certificate,
            broken,
            failure,
            source,
            drawn: Mutex::default(),
            page: Mutex::default(),
        }
    }

    /// All plots, where they have been drawn.
    pub(crate) fn drawn(&self) -> Option<Arc<Drawn>> {
        self.drawn.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Keeps a page that nobody has asked for yet.
    pub(crate) fn keep_page(&self, page: Unread) {
        *self.page.lock().unwrap_or_else(PoisonError::into_inner) = Some(page);
    }

    /// The page with frames at least this far apart (s), where the run has kept it: once.
    pub(crate) fn take(&self, least_s: f64) -> Option<Unread> {
        let mut page = self.page.lock().unwrap_or_else(PoisonError::into_inner);
        page.take_if(|page| page.is_of(&self.source.scene, least_s))
    }

    /// Keeps all plots.
    pub(crate) fn keep(&self, drawn: Drawn) -> Arc<Drawn> {
        let drawn = Arc::new(drawn);
        *self.drawn.lock().unwrap_or_else(PoisonError::into_inner) = Some(Arc::clone(&drawn));
        drawn
    }

    /// Reads times (s) and states: so many numbers for each body and sample.
    pub(crate) fn read<T>(&self, py: Python<'_>, read: impl FnOnce(&[f64], &[f64]) -> T) -> PyResult<T> {
        self.times.read(py, |times| self.states.read(py, |states| read(times, states)))?
    }
}

#[pymethods]
impl Recording {
    /// Times of the samples, s: (N,).
    fn times(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.times.array(py)
    }

    /// States of the bodies: (N, 13 times the number of bodies).
    fn states(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.states.array(py)
    }

    /// Estimated errors of the bodies: (N, 2 times the number of bodies), not a number where one is not known; none of
    /// a run of which none is known.
    fn errors(&self, py: Python<'_>) -> PyResult<Option<Py<PyAny>>> {
        self.errors.as_ref().map(|errors| errors.array(py)).transpose()
    }

    /// Kinetic and potential energies, J: (N, 2).
    fn energies(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.energies.array(py)
    }

    /// Coordinates, loads and powers of the joints: (N, 13 times the number of joints).
    fn joints(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.joints.array(py)
    }

    /// Of each event: its kind, the numbers of its bodies (-1 where there is no second one), and time, point, normal,
    /// impulse and change of energy as a row of nine numbers.
    fn events<'py>(&self, py: Python<'py>) -> PyResult<EventColumns<'py>> {
        event_columns(py, &self.events)
    }
}

/// Events in columns.
pub(crate) fn event_columns<'py>(py: Python<'py>, events: &[Event]) -> PyResult<EventColumns<'py>> {
    let number = |event: &Event| event.body_b.map_or(-1, |body| body.index() as i64);
    let kinds = events.iter().map(|event| event.kind.word()).collect();
    let bodies = events.iter().flat_map(|event| [event.body_a.index() as i64, number(event)]).collect();
    let numbers = events.iter().flat_map(|event| {
        let (p, n) = (event.point, event.normal);
        [event.t_s, p.x, p.y, p.z, n.x, n.y, n.z, event.impulse, event.energy_change_j]
    });
    let bodies = PyArray1::from_vec(py, bodies).reshape([events.len(), 2])?;
    Ok((kinds, bodies, PyArray1::from_vec(py, numbers.collect()).reshape([events.len(), 9])?))
}

/// Kinds, bodies and numbers of events.
pub(crate) type EventColumns<'py> = (Vec<&'static str>, Bound<'py, PyArray2<i64>>, Bound<'py, PyArray2<f64>>);

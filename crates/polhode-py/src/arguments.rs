//! What Python gives: vectors, bodies and joints, checked.

use crate::errors;
use polhode::spatial::{DVec3, Pose, Rotation};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyString;

/// The numbers of any sequence of that many numbers: a tuple, a list or an array of numpy.
pub(crate) fn numbers<const N: usize>(what: &str, given: &Bound<'_, PyAny>) -> PyResult<[f64; N]> {
    let refused = || PyTypeError::new_err(format!("{what}: {N} numbers are needed, found {}", shown(given)));
    let mut numbers = [0.0; N];
    let mut count = 0;
    if given.is_instance_of::<PyString>() {
        return Err(refused());
    }
    for element in given.try_iter().map_err(|_| refused())? {
        let number = element?.extract::<f64>().map_err(|_| refused())?;
        if let Some(place) = numbers.get_mut(count) {
            *place = number;
        }
        count += 1;
        if count > N {
            break;
        }
    }
    match numbers.iter().find(|number| !number.is_finite()) {
        _ if count != N => Err(refused()),
        Some(number) => Err(PyValueError::new_err(format!("{what}: finite numbers are needed, found {number}"))),
        None => Ok(numbers),
    }
}

/// A vector.
pub(crate) fn vector(what: &str, given: &Bound<'_, PyAny>) -> PyResult<DVec3> {
    numbers::<3>(what, given).map(DVec3::from_array)
}

/// A vector; zero when none is given.
pub(crate) fn vector_or_zero(what: &str, given: Option<&Bound<'_, PyAny>>) -> PyResult<DVec3> {
    given.map_or(Ok(DVec3::ZERO), |given| vector(what, given))
}

/// An orientation from a quaternion w, x, y, z.
pub(crate) fn rotation(given: &Bound<'_, PyAny>) -> PyResult<Rotation> {
    let wxyz = numbers::<4>("orientation", given)?;
    Rotation::from_wxyz(wxyz).map_err(|error| PyValueError::new_err(format!("orientation: {error}")))
}

/// A pose from a position and a quaternion.
pub(crate) fn pose(position: &Bound<'_, PyAny>, orientation: Option<&Bound<'_, PyAny>>) -> PyResult<Pose> {
    let translation = vector("position", position)?;
    let rotation = orientation.map_or(Ok(Rotation::IDENTITY), rotation)?;
    Ok(Pose::new(rotation, translation))
}

/// The number that one of some names is given by: the name itself, or the number. An error tells those that are known.
pub(crate) fn index_of(kind: &str, given: &Bound<'_, PyAny>, names: &[&str], known: &[&str]) -> PyResult<usize> {
    let py = given.py();
    // A body or joint of a scene that is built stands for its name.
    let name = given.extract::<String>().or_else(|_| given.getattr("name")?.extract::<String>());
    if let Ok(name) = name {
        let found = names.iter().position(|own| **own == name && !name.is_empty());
        return found.ok_or_else(|| errors::unknown_name(py, kind, &name, known));
    }
    let refused =
        || PyTypeError::new_err(format!("{kind}: a name or a number of at least 0 is needed, found {}", shown(given)));
    given.extract::<usize>().map_err(|_| refused())
}

/// What was given, as a message shows it.
pub(crate) fn shown(given: &Bound<'_, PyAny>) -> String {
    let text = given.repr().map_or_else(|_| "what cannot be shown".to_owned(), |text| text.to_string());
    let mut short: String = text.chars().take(MOST_SHOWN).collect();
    if short.len() < text.len() {
        short.push_str(" ...");
    }
    short
}

/// Most characters of a value in a message.
const MOST_SHOWN: usize = 80;

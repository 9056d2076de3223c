//! Meshes and robots from their files.

use crate::errors;
use crate::views::Finding;
use numpy::ndarray::Array2;
use numpy::{PyArray, PyArray2};
use polhode::spatial::DVec3;
use polhode_scene::format::MATERIAL_KEYS;
use polhode_scene::robot::{self, RobotCoordinate};
use polhode_scene::{MeshFileError, SceneFileError, read_mesh};
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;

/// Vertices and triangles.
type Mesh<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<i64>>);

/// The vertices of a mesh file, (V, 3) in its own unit, and its triangles, (T, 3).
#[pyfunction]
pub(crate) fn mesh_of_file<'py>(py: Python<'py>, path: &Bound<'py, PyAny>) -> PyResult<Mesh<'py>> {
    let path: PathBuf = path.extract()?;
    let mesh = py.detach(|| read_mesh(&path)).map_err(|error| match error {
        MeshFileError::Read { .. } => PyOSError::new_err(error.to_string()),
        other => errors::value(other),
    })?;
    let vertices = mesh.vertices().iter().flat_map(DVec3::to_array).collect();
    let triangles = mesh.triangles().iter().flatten().map(|&corner| i64::from(corner)).collect();
    Ok((table(py, mesh.vertices().len(), vertices)?, table(py, mesh.triangles().len(), triangles)?))
}

/// An array of rows of three.
fn table<T: numpy::Element>(py: Python<'_>, rows: usize, numbers: Vec<T>) -> PyResult<Bound<'_, PyArray2<T>>> {
    let table = Array2::from_shape_vec((rows, 3), numbers).map_err(errors::value)?;
    Ok(PyArray::from_owned_array(py, table))
}

/// What stands in the file of a robot: its name, links, joints and findings.
#[pyfunction]
pub(crate) fn robot_of_file<'py>(py: Python<'py>, path: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyDict>> {
    let path: PathBuf = path.extract()?;
    let file = py.detach(|| robot::read_robot(&path, &[]));
    let file = file.map_err(|error| errors::scene(py, &SceneFileError::from(error)))?;
    let links: Vec<(&str, Option<f64>)> = file
        .robot
        .links
        .iter()
        .map(|link| (link.name.as_str(), link.inertial.as_ref().map(|inertial| inertial.mass)))
        .collect();
    let name_of = |link: usize| links.get(link).map_or("", |(name, _)| *name);
    let joints = file.robot.joints.iter().map(|joint| {
        let told = PyDict::new(py);
        told.set_item("name", &joint.name)?;
        told.set_item("kind", joint.kind.name())?;
        told.set_item("parent", name_of(joint.parent))?;
        told.set_item("child", name_of(joint.child))?;
        let coordinates = joint.coordinates.iter().map(|own| coordinate(py, own)).collect::<PyResult<Vec<_>>>()?;
        told.set_item("coordinates", coordinates)?;
        Ok(told)
    });
    let actuators = file.robot.actuators.iter().map(|own| {
        let [lower, upper] = own.control_range.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        let told = PyDict::new(py);
        told.set_item("name", &own.name)?;
        told.set_item("kind", &own.kind)?;
        told.set_item("joint", &own.joint)?;
        told.set_item("gear", own.gear)?;
        told.set_item("control_range", (lower, upper))?;
        Ok(told)
    });
    let keyframes: Vec<&str> = file.robot.keyframes.iter().map(|own| own.name.as_str()).collect();
    let told = PyDict::new(py);
    told.set_item("actuators", actuators.collect::<PyResult<Vec<_>>>()?)?;
    told.set_item("keyframes", keyframes)?;
    told.set_item("joints", joints.collect::<PyResult<Vec<_>>>()?)?;
    told.set_item("name", &file.robot.name)?;
    told.set_item("links", links)?;
    told.set_item("findings", file.findings.iter().map(finding).collect::<Vec<_>>())?;
    Ok(told)
}

/// The keys of a material in a scene file.
#[pyfunction]
pub(crate) fn material_keys() -> Vec<&'static str> {
    MATERIAL_KEYS.to_vec()
}

/// A coordinate of a joint of a robot.
fn coordinate<'py>(py: Python<'py>, own: &RobotCoordinate) -> PyResult<Bound<'py, PyDict>> {
    let [lower, upper] = own.limits.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
    let told = PyDict::new(py);
    told.set_item("name", &own.name)?;
    for (key, number) in [
        ("lower", lower),
        ("upper", upper),
        ("reference", own.reference),
        ("damping", own.damping),
        ("friction", own.friction),
        ("stiffness", own.stiffness),
        ("rest", own.rest),
        ("effort_limit", own.effort_limit.as_ref().map_or(f64::INFINITY, |limit| limit.most)),
    ] {
        told.set_item(key, number)?;
    }
    Ok(told)
}

/// What is impossible in the file of a robot, or simulated otherwise than it says: of its masses, inertias, meshes and
/// links too.
#[pyfunction]
pub(crate) fn doctor(py: Python<'_>, path: &Bound<'_, PyAny>) -> PyResult<Vec<Finding>> {
    let path: PathBuf = path.extract()?;
    let found = py.detach(|| match polhode_scene::load_with(&path, &[]) {
        Ok(loaded) => {
            let examined = loaded.examine_robots();
            Ok(loaded.findings().chain(&examined).map(finding).collect())
        }
        Err(SceneFileError::Robot(error)) if !error.findings().is_empty() => {
            Ok(error.findings().iter().map(finding).collect())
        }
        Err(error) => Err(error),
    });
    found.map_err(|error| errors::scene(py, &error))
}

fn finding(found: &robot::Finding) -> Finding {
    Finding {
        file: found.place.file.display().to_string(),
        line: found.place.line,
        column: found.place.column,
        severity: found.severity().name().to_owned(),
        subject: found.subject.clone(),
        what: found.defect.to_string(),
        cure: found.cure(),
    }
}

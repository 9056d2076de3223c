//! Parts of the library as functions of arrays.

use crate::{arguments, errors};
use numpy::ndarray::Array2;
use numpy::{AllowTypeChange, PyArray2, PyArrayLike1, PyArrayLike2};
use polhode::dynamics::FreeRotation;
use polhode::mesh::{Amount, TriangleMesh};
use polhode::spatial::{DVec3, Density, Inertia, Mass, Rotation};
use polhode_scene::{Filling, MeshReport};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

/// Something that is no array of the kind that is needed.
fn unfit(what: &str, needed: &str, given: &Bound<'_, PyAny>) -> PyErr {
    PyTypeError::new_err(format!("{what}: {needed} is needed, found {}", arguments::shown(given)))
}

/// Attitudes of a free rotation at some times, s: (N, 4).
///
/// The moments are those about the axes of the body, kg m^2; the angular velocity is in the world, rad/s; the
/// orientation is that at t = 0.
#[pyfunction]
#[pyo3(signature = (moments, angular_velocity, times, orientation=None))]
pub(crate) fn rotate_free<'py>(
    py: Python<'py>,
    moments: &Bound<'py, PyAny>,
    angular_velocity: &Bound<'py, PyAny>,
    times: &Bound<'py, PyAny>,
    orientation: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let moments = arguments::vector("moments", moments)?;
    Inertia::from_diagonal(moments).map_err(|error| errors::value(format!("moments: {error}")))?;
    let angular_velocity = arguments::vector("angular_velocity", angular_velocity)?;
    let start = orientation.map_or(Ok(Rotation::IDENTITY), arguments::rotation)?;
    let times: PyArrayLike1<'_, f64, AllowTypeChange> =
        times.extract().map_err(|_| unfit("times", "an array of numbers of shape (N,)", times))?;
    let times = times.as_array();
    if let Some(time) = times.iter().find(|time| !time.is_finite()) {
        return Err(errors::value(format!("times: finite numbers are needed, found {time}")));
    }
    let attitudes = py.detach(|| {
        let momentum = start.rotate(start.inverse_rotate(angular_velocity) * moments);
        let rotation = FreeRotation::new(moments, start, momentum);
        let attitudes = times.iter().flat_map(|&time| rotation.at(time).to_wxyz()).collect();
        Array2::from_shape_vec((times.len(), 4), attitudes)
    });
    Ok(PyArray2::from_owned_array(py, attitudes.map_err(errors::value)?))
}

/// Diagnosis and mass properties of a mesh, as JSON.
#[pyfunction]
pub(crate) fn mesh_report(
    py: Python<'_>,
    vertices: &Bound<'_, PyAny>,
    triangles: &Bound<'_, PyAny>,
    mass: Option<f64>,
    density: Option<f64>,
    is_hollow: bool,
) -> PyResult<String> {
    let vertices: PyArrayLike2<'_, f64, AllowTypeChange> =
        vertices.extract().map_err(|_| unfit("vertices", "an array of numbers of shape (V, 3)", vertices))?;
    let triangles: PyArrayLike2<'_, i64> =
        triangles.extract().map_err(|_| unfit("triangles", "an array of whole numbers of shape (T, 3)", triangles))?;
    let (vertices, triangles) = (vertices.as_array(), triangles.as_array());
    for (what, shape) in [("vertices", vertices.shape()), ("triangles", triangles.shape())] {
        if shape[1] != 3 {
            return Err(errors::value(format!("{what}: an array of shape (N, 3) is needed, found {shape:?}")));
        }
    }
    let amount = match (mass, density) {
        (Some(mass), None) => Mass::new(mass).map(Amount::Mass),
        (None, Some(density)) => Density::new(density).map(Amount::Density),
        _ => return Err(errors::value("exactly one of mass (kg) and density (kg/m^3) is needed")),
    };
    let amount = amount.map_err(errors::value)?;
    let index = |&index: &i64| {
        u32::try_from(index).map_err(|_| errors::value(format!("triangles: {index} is the number of no vertex")))
    };
    let corners: Vec<u32> = triangles.iter().map(index).collect::<PyResult<_>>()?;
    let points: Vec<f64> = vertices.iter().copied().collect();
    let filling = if is_hollow { Filling::Hollow } else { Filling::Solid };
    py.detach(|| {
        let points = points.as_chunks().0.iter().map(|&point| DVec3::from_array(point)).collect();
        let mesh = TriangleMesh::new(points, corners.as_chunks().0.to_vec()).map_err(errors::value)?;
        let report = MeshReport::new(mesh, filling, amount);
        if let Err(error) = &report.mass_properties {
            return Err(errors::value(error));
        }
        Ok(report.to_json().to_string())
    })
}

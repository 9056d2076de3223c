//! Contacts as arrays: forces of friction and impacts, of a Delassus matrix.
//!
//! Python has checked kinds and shapes of arrays (`_contacts.py`); what else a problem must be, the library says.

use crate::errors;
use numpy::ndarray::{Array1, Array2};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use polhode::response::friction::{FrictionProblem, FrictionSettings, FrictionSolution, Redundancy, solve_friction};
use polhode::response::{
    ComplementaritySolver, ContactProblem, ImpactProblem, ImpactSettings, Law, MultipleFrictionalImpact,
    MultipleImpactSettings, ResponseError, check_delassus,
};
use polhode::scene::{ImpactLaw, PulseExponent, RestitutionLaw};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Rows of a contact in space.
const IN_SPACE: usize = 3;

/// Contacts with friction: matrix, velocities without reactions, coefficients and rows of each.
struct Contacts {
    matrix: Vec<f64>,
    free: Vec<f64>,
    friction: Vec<f64>,
    rows: usize,
}

impl Contacts {
    fn of(
        matrix: &Bound<'_, PyArray2<f64>>,
        free: &Bound<'_, PyArray1<f64>>,
        friction: &Bound<'_, PyArray1<f64>>,
    ) -> Self {
        let matrix = matrix.readonly().as_array().iter().copied().collect();
        let [free, friction] = [numbers_of(free), numbers_of(friction)];
        let rows = free.len().checked_div(friction.len()).unwrap_or(IN_SPACE);
        Self { matrix, free, friction, rows }
    }

    fn problem(&self) -> Result<FrictionProblem, ResponseError> {
        let laws = self.friction.iter().map(|&friction| Law::Cone { rows: self.rows, friction }).collect();
        check_delassus(self.free.len(), &self.matrix)?;
        FrictionProblem::from_dense(laws, &self.matrix, self.free.clone())
    }

    /// One line for each contact.
    fn lines<'py>(&self, py: Python<'py>, numbers: Vec<f64>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let lines = Array2::from_shape_vec((self.friction.len(), self.rows), numbers);
        Ok(PyArray2::from_owned_array(py, lines.map_err(errors::value)?))
    }
}

/// The numbers of an array.
fn numbers_of(array: &Bound<'_, PyArray1<f64>>) -> Vec<f64> {
    array.readonly().as_array().iter().copied().collect()
}

/// Forces of contacts with friction; `start` are those of a similar problem.
#[pyfunction]
#[pyo3(name = "solve_friction")]
pub(crate) fn friction<'py>(
    py: Python<'py>,
    matrix: &Bound<'py, PyArray2<f64>>,
    free: &Bound<'py, PyArray1<f64>>,
    coefficients: &Bound<'py, PyArray1<f64>>,
    start: Option<&Bound<'py, PyArray1<f64>>>,
) -> PyResult<Bound<'py, PyDict>> {
    let contacts = Contacts::of(matrix, free, coefficients);
    let start: Option<Vec<f64>> = start.map(numbers_of);
    let solved = py.detach(|| solved(&contacts, start)).map_err(errors::value)?;
    let told = PyDict::new(py);
    told.set_item("impulses", contacts.lines(py, solved.reactions)?)?;
    told.set_item("velocities", contacts.lines(py, solved.velocities)?)?;
    told.set_item("contacts", solved.statuses.iter().map(|status| status.name()).collect::<Vec<_>>())?;
    told.set_item("status", solved.report.status.name())?;
    told.set_item("residual", solved.report.residual)?;
    told.set_item("method", solved.report.method.name())?;
    told.set_item("iterations", solved.report.iterations())?;
    // Normal reactions alone.
    let squeeze: Vec<f64> = solved.squeeze.iter().step_by(contacts.rows).copied().collect();
    told.set_item("squeeze", (!squeeze.is_empty()).then(|| PyArray1::from_vec(py, squeeze)))?;
    Ok(told)
}

/// Reactions that do not depend on the order of the contacts, where many share a load: those from no reactions at
/// first.
fn solved(contacts: &Contacts, start: Option<Vec<f64>>) -> Result<FrictionSolution, ResponseError> {
    let settings = FrictionSettings { redundancy: Redundancy::LeastNorm, ..FrictionSettings::default() };
    let start = start.unwrap_or_else(|| vec![0.0; contacts.free.len()]);
    solve_friction(&contacts.problem()?, Some(&start), &settings)
}

/// The laws of an impact, by their names in a scene.
#[derive(FromPyObject)]
pub(crate) struct Laws {
    #[pyo3(item)]
    law: String,
    #[pyo3(item)]
    restitution_law: Option<String>,
    #[pyo3(item)]
    tangential_restitution: Option<f64>,
    #[pyo3(item)]
    pulse_exponent: Option<String>,
}

/// The one of this name.
fn named<T: Copy>(key: &str, name: &str, all: &[T], name_of: impl Fn(T) -> &'static str) -> PyResult<T> {
    let names: Vec<&str> = all.iter().map(|&one| name_of(one)).collect();
    let found = all.iter().copied().find(|&one| name_of(one) == name);
    found.ok_or_else(|| errors::value(format!("{key}={name:?}: one of {} is needed", names.join(", "))))
}

impl Laws {
    fn of_impact(&self) -> PyResult<ImpactLaw> {
        named("law", &self.law, &ImpactLaw::ALL, ImpactLaw::name)
    }

    fn exponent(&self) -> PyResult<PulseExponent> {
        let name = self.pulse_exponent.as_deref();
        name.map_or(Ok(PulseExponent::default()), |name| {
            named("pulse_exponent", name, &PulseExponent::ALL, PulseExponent::name)
        })
    }

    fn of_single_contact(&self) -> PyResult<RestitutionLaw> {
        let law = match &self.restitution_law {
            Some(name) => named("restitution_law", name, &RestitutionLaw::ALL, RestitutionLaw::name)?,
            None => self.of_impact()?.of_single_contact(),
        };
        match (law, self.tangential_restitution) {
            (RestitutionLaw::ChatterjeeRuina { .. }, Some(tangential_restitution)) => {
                Ok(RestitutionLaw::ChatterjeeRuina { tangential_restitution })
            }
            (law, None) => Ok(law),
            (law, Some(_)) => Err(errors::value(format!(
                "tangential_restitution beside restitution_law={:?}: {:?} alone has it",
                law.name(),
                RestitutionLaw::ChatterjeeRuina { tangential_restitution: 0.0 }.name()
            ))),
        }
    }
}

/// An impact at contacts without friction.
#[pyfunction]
pub(crate) fn impact_without_friction<'py>(
    py: Python<'py>,
    matrix: &Bound<'py, PyArray2<f64>>,
    before: &Bound<'py, PyArray1<f64>>,
    restitution: &Bound<'py, PyArray1<f64>>,
    laws: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyDict>> {
    let laws: Laws = laws.extract()?;
    let law = laws.of_impact()?.of_rows(laws.exponent()?);
    let [before, restitution] = [numbers_of(before), numbers_of(restitution)];
    let matrix: Vec<f64> = matrix.readonly().as_array().iter().copied().collect();
    let outcome = py.detach(|| {
        check_delassus(before.len(), &matrix)?;
        let contacts = rows_of(before.len(), matrix)?;
        let delassus = contacts.delassus();
        let settings = ImpactSettings::default();
        let problem = ImpactProblem {
            contacts: &contacts,
            delassus: &delassus,
            u_before: &before,
            restitution: &restitution,
            settings: &settings,
        };
        law.resolve(&problem, &mut ComplementaritySolver::new(settings.solver))
    });
    let outcome = outcome.map_err(errors::value)?;
    let told = PyDict::new(py);
    told.set_item("impulses", PyArray1::from_owned_array(py, Array1::from_vec(outcome.impulses)))?;
    told.set_item("velocities", PyArray1::from_owned_array(py, Array1::from_vec(outcome.velocities_after)))?;
    told.set_item("energy_change", outcome.energy_change)?;
    told.set_item("status", outcome.status.name())?;
    told.set_item("residual", outcome.residual)?;
    Ok(told)
}

/// One row that pushes for each coordinate of a body whose inverse mass is the matrix.
fn rows_of(size: usize, matrix: Vec<f64>) -> Result<ContactProblem, ResponseError> {
    let mut contacts = ContactProblem::new(size.max(1), matrix)?;
    let mut row = vec![0.0; size];
    for place in 0..size {
        row[place] = 1.0;
        contacts.push_row(&[(0, &row)])?;
        row[place] = 0.0;
    }
    Ok(contacts)
}

/// An impact at contacts with friction.
#[pyfunction]
pub(crate) fn impact_with_friction<'py>(
    py: Python<'py>,
    matrix: &Bound<'py, PyArray2<f64>>,
    before: &Bound<'py, PyArray1<f64>>,
    restitution: &Bound<'py, PyArray1<f64>>,
    coefficients: &Bound<'py, PyArray1<f64>>,
    laws: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyDict>> {
    let laws: Laws = laws.extract()?;
    let (several, single) = (laws.of_impact()?.of_contacts_with_friction(laws.exponent()?), laws.of_single_contact()?);
    let contacts = Contacts::of(matrix, before, coefficients);
    let restitution = numbers_of(restitution);
    let outcome = py.detach(|| {
        let impact = MultipleFrictionalImpact {
            contacts: &contacts.problem()?,
            restitution: &restitution,
            stand_for_several: &[],
            law: several,
            single,
            settings: &MultipleImpactSettings::default(),
        };
        impact.resolve()
    });
    let outcome = outcome.map_err(errors::value)?;
    let told = PyDict::new(py);
    told.set_item("impulses", contacts.lines(py, outcome.impulses)?)?;
    told.set_item("velocities", contacts.lines(py, outcome.velocities_after)?)?;
    told.set_item("energy_change", outcome.energy_change)?;
    told.set_item("status", outcome.status.name())?;
    told.set_item("residual", outcome.residual)?;
    Ok(told)
}

//! The least forces with which all contacts hold while some of them slide.
//!
//! Where normal forces are not unique, bodies whose contacts slide in different directions move as the choice says. The
//! motion between events takes the least forces; those at one instant are the same, if they push everywhere and lie in
//! the cones of the contacts that stick. A contact that slides and whose normal force would press it less by its own
//! friction (`G_nn - mu G_nt <= 0`, Painleve) is left to the cone problem.

use super::assembly::Assembly;
use crate::collision::contact_set::Touch;
use crate::scene::FrictionEllipse;
use crate::world::World;
use polhode_dynamics::BodyState;
use polhode_response::{Delassus, ResponseError, SlidingRow, least_norm_sliding_forces, motion_depends_on_choice};
use std::ops::Range;

/// Friction of a contact among the rows of an assembly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum RowFriction {
    /// It has none.
    Frictionless,
    /// It sticks up to these coefficients: two rows along tangents.
    Sticks(FrictionEllipse),
    /// It slides with this coefficient: one row along what friction opposes.
    Slides(f64),
}

impl RowFriction {
    /// How many rows along tangents.
    fn rows(self) -> usize {
        match self {
            Self::Frictionless => 0,
            Self::Sticks(_) => 2,
            Self::Slides(_) => 1,
        }
    }
}

/// The least forces with which all contacts hold.
#[derive(Debug, Clone, Default)]
pub(crate) struct LeastSlidingForces {
    /// Of all rows, N.
    pub(crate) forces: Vec<f64>,
    /// Whether other forces that hold all contacts as well would move the bodies in another way.
    pub(crate) motion_depends_on_choice: bool,
}

/// Forces (N) of all rows of `assembly`, whose contacts have this friction and whose rows have these constant terms
/// (m/s^2); none if they are not an answer. `rounding` is what an acceleration of zero may be (m/s^2) for these forces.
///
/// # Errors
/// When a number is not finite.
pub(crate) fn least_sliding_forces(
    (world, states, contacts): (&World, &[BodyState], &[Touch]),
    assembly: &Assembly,
    constants: &[f64],
    friction: &[RowFriction],
    rounding: impl Fn(&Delassus, &[f64]) -> f64,
) -> Result<Option<LeastSlidingForces>, ResponseError> {
    let first_tangent = assembly.first_tangent();
    // Rows that are held first, then those along which contacts slide.
    let mut order: Vec<usize> = (0..first_tangent).collect();
    let mut slides = Vec::new();
    let mut sticks: Vec<(usize, Range<usize>, FrictionEllipse)> = Vec::new();
    let mut first = first_tangent;
    for (normal, &friction) in friction.iter().enumerate() {
        match friction {
            RowFriction::Frictionless => {}
            RowFriction::Sticks(ellipse) => {
                sticks.push((normal, order.len()..order.len() + 2, ellipse));
                order.extend(first..first + 2);
            }
            RowFriction::Slides(coefficient) => slides.push((normal, first, coefficient)),
        }
        first += friction.rows();
    }
    let held = order.len();
    order.extend(slides.iter().map(|&(_, row, _)| row));
    let normals = contacts.iter().map(|touch| (touch.id, touch.kinematics.geometry));
    let mut ordered = Assembly::new(world, states, assembly.bodies(), normals)?;
    let tangents = order.iter().filter_map(|row| assembly.tangents().get(row.checked_sub(first_tangent)?)).copied();
    ordered.push_tangents(states, tangents)?;
    let delassus = ordered.problem.delassus();
    let sliding = slides.iter().enumerate();
    let sliding = sliding.map(|(k, &(normal, _, coefficient))| SlidingRow { normal, tangent: held + k, coefficient });
    let sliding: Vec<SlidingRow> = sliding.collect();
    let wedges = |row: &SlidingRow| {
        delassus.get(row.normal, row.normal) <= row.coefficient * delassus.get(row.normal, row.tangent)
    };
    if sliding.iter().any(wedges) {
        return Ok(None);
    }
    let held_constants: Vec<f64> = order.iter().take(held).map(|&row| constants[row]).collect();
    let forces = least_norm_sliding_forces(&delassus, &held_constants, &sliding)?;
    let pulls = forces.iter().take(contacts.len()).any(|&force| force < 0.0);
    let slips = sticks
        .iter()
        .any(|(normal, rows, ellipse)| ellipse.length(&forces[rows.clone()]) > ellipse.largest() * forces[*normal]);
    let accelerations = delassus.times(&forces)?;
    let left = accelerations.iter().zip(&held_constants).fold(0.0, |most: f64, (w, b)| most.max((w + b).abs()));
    if pulls || slips || left > rounding(&delassus, &forces) {
        return Ok(None);
    }
    let mut of_rows = vec![0.0; forces.len()];
    for (&row, &force) in order.iter().zip(&forces) {
        of_rows[row] = force;
    }
    let motion_depends_on_choice = motion_depends_on_choice(&delassus, held, &sliding)?;
    Ok(Some(LeastSlidingForces { forces: of_rows, motion_depends_on_choice }))
}

//! The least forces with which all contacts hold while some of them slide.
//!
//! Where normal forces are not unique and contacts slide in different directions, the motion depends on the forces that
//! are taken. Between events they are those of least norm, within the cones of contacts that stick (`solve/stage.rs`).
//! At one instant the same forces are taken where they exist. Where the friction of a sliding contact presses it more
//! than its normal force lifts it (`G_nn - mu G_nt <= 0`, Painleve), the cone problem decides.

use super::contacts::{Contact, Contacts, Part};
use super::terms::{STICKING_ACCELERATION, Terms, rounding_of};
use crate::error::ResponseError;
use crate::friction::BlocksSolution;
use crate::least_in_cones::least_forces_in_cones;
use crate::least_norm_hold::LeastNormForces;
use crate::report::{Method, SolverReport};
use crate::sliding::{SlidingRow, least_norm_sliding_forces, motion_depends_on_choice};
use crate::solve::answer::Choice;
use crate::solve::matrix;

/// The rows of a problem in the order that [`least_norm_sliding_forces`] asks for.
struct RowOrder {
    /// Rows that are held, then those along which contacts slide.
    order: Vec<usize>,
    /// The place of each row in it.
    places: Vec<usize>,
    /// How many are held.
    held: usize,
    sliding: Vec<SlidingRow>,
}

impl RowOrder {
    /// Rows along normals and of joints first, then those along which contacts stick, then those along which they move.
    fn new(rows: usize, contacts: &Contacts) -> Self {
        let mut is_bounded = vec![false; rows];
        contacts.all.iter().flat_map(Contact::bounded_rows).for_each(|row| is_bounded[row] = true);
        let mut order: Vec<usize> = (0..rows).filter(|&row| !is_bounded[row]).collect();
        let parts = || contacts.all.iter().flat_map(|contact| contact.parts.iter().map(move |part| (contact, part)));
        order.extend(parts().filter(|(_, part)| part.sticks()).flat_map(|(_, part)| part.rows.iter().copied()));
        let held = order.len();
        order.extend(parts().filter(|(_, part)| part.slides).flat_map(|(_, part)| part.rows.iter().copied()));
        let mut places = vec![0; rows];
        order.iter().enumerate().for_each(|(place, &row)| places[row] = place);
        let sliding_row = |(contact, part): (&Contact, &Part)| {
            let tangent = *part.rows.first().filter(|_| part.slides)?;
            let [normal, tangent] = [contact.normal, tangent].map(|row| places[row]);
            Some(SlidingRow { normal, tangent, coefficient: part.friction })
        };
        let sliding = parts().filter_map(sliding_row).collect();
        Self { order, places, held, sliding }
    }

    /// Numbers in the order of the problem, from those in this order.
    fn in_rows(&self, values: &[f64]) -> Vec<f64> {
        let mut of_rows = vec![0.0; self.order.len()];
        self.order.iter().zip(values).for_each(|(&row, &value)| of_rows[row] = value);
        of_rows
    }

    /// Numbers in this order, from those in the order of the problem.
    fn in_order(&self, of_rows: &[f64]) -> Vec<f64> {
        self.order.iter().map(|&row| of_rows[row]).collect()
    }
}

/// Forces with which every contact holds, and whether the motion depends on which are taken.
#[derive(Debug)]
pub(super) struct HoldingWhileSliding {
    pub(super) solved: BlocksSolution,
    pub(super) choice: Choice,
}

/// The least forces with which all contacts hold, some of which slide; none if they are not an answer.
///
/// # Errors
/// When a number is not finite.
pub(super) fn all_hold(terms: Terms<'_>) -> Result<Option<HoldingWhileSliding>, ResponseError> {
    let contacts = Contacts::of(terms.rows, terms.blocks);
    let order = RowOrder::new(terms.rows.len(), &contacts);
    let RowOrder { held, ref sliding, .. } = order;
    let ordered = terms.rows.with_rows(&order.order);
    let delassus = matrix::of(&ordered)?;
    let wedges = |row: &SlidingRow| {
        delassus.get(row.normal, row.normal) <= row.coefficient * delassus.get(row.normal, row.tangent)
    };
    if sliding.iter().any(wedges) {
        return Ok(None);
    }
    let constants = order.in_order(terms.constants);
    let LeastNormForces { mut forces, loads } =
        least_norm_sliding_forces(&ordered, &delassus, &constants[..held], sliding)?;
    let mut of_rows = order.in_rows(&forces);
    if !contacts.obey(&of_rows) {
        let cones = contacts.cones(|row| order.places[row]);
        let Some(mut found) = least_forces_in_cones(&delassus, held, sliding, &cones, &forces)? else {
            return Ok(None);
        };
        if loads.is_some() {
            // What these forces miss is rounding of the heaviest bodies, and would move the lightest.
            let left = ordered.accelerations(&constants, &found)?;
            let change = least_norm_sliding_forces(&ordered, &delassus, &left[..held], sliding)?.forces;
            found.iter_mut().zip(&change).for_each(|(force, change)| *force += change);
        }
        of_rows = order.in_rows(&found);
        if !contacts.obey(&of_rows) {
            return Ok(None);
        }
        forces = found;
    }
    // The products of the matrix lose what forces that cancel on light bodies leave.
    let accelerations = if loads.is_some() {
        ordered.accelerations(&constants, &forces)?
    } else {
        delassus.times(&forces)?.iter().zip(&constants).map(|(w, b)| w + b).collect()
    };
    let left = accelerations.iter().take(held).fold(0.0, |most: f64, w| most.max(w.abs()));
    if left > STICKING_ACCELERATION * terms.scale() + rounding_of(&delassus, &forces) {
        return Ok(None);
    }
    let pushing = (forces.as_slice(), contacts.all.len());
    let depends = motion_depends_on_choice(&delassus, held, sliding, pushing)?;
    // What is held is at zero up to rounding.
    let mut velocities = order.in_rows(&accelerations);
    order.order[..held].iter().for_each(|&row| velocities[row] = 0.0);
    let report = SolverReport { method: Method::ActiveSet, ..SolverReport::default() };
    let (statuses, parts) = (contacts.statuses(), contacts.statuses_of_parts());
    let solved = BlocksSolution { reactions: of_rows, velocities, statuses, parts, report };
    let choice = if depends { Choice::DecidesMotion } else { Choice::Idle };
    Ok(Some(HoldingWhileSliding { solved, choice }))
}

//! The least forces with which all contacts hold while some of them slide.
//!
//! Where normal forces are not unique and contacts slide in different directions, the motion depends on the forces that
//! are taken. Between events they are those of least norm, within the cones of contacts that stick
//! (`accurate/held_forces.rs`). At one instant the same forces are taken where they exist. Where the friction of a
//! sliding contact presses it more than its normal force lifts it (`G_nn - mu G_nt <= 0`, Painleve), the cone problem
//! decides.

use crate::collision::touch::Touch;
use crate::model::Model;
use crate::rows::assembly::Assembly;
use crate::rows::friction_blocks::push_contact;
use crate::scene::FrictionEllipse;
use polhode_dynamics::BodyState;
use polhode_response::{
    Blocks, Delassus, Law, LeastNormForces, ResponseError, SlidingRow, least_forces_in_cones,
    least_norm_sliding_forces, motion_depends_on_choice,
};
use polhode_spatial::DVec3;
use std::ops::Range;

/// A tangential force exceeds what friction bears from this much above it on, relative to it (no unit, 1e-11 to 1e-10):
/// bodies of one material that slide together hold each other with forces exactly at the limit, and errors of steps
/// must not decide whether they slide on each other.
const EXCEEDED: f64 = 5e-11;

/// A moment of tangential forces about the centre of pressure counts as none below this part of what they could have
/// (no unit, 1e-12 to 1e-6).
const NO_MOMENT: f64 = 1e-9;

/// Normals whose components differ by less count as equal (no unit, 1e-14 to 1e-9): the rounding of attitudes.
const SHARED_NORMAL: f64 = 1e-10;

/// Whether a tangential force is more than friction bears (both N).
pub(crate) fn exceeds_friction(tangential: f64, limit: f64) -> bool {
    tangential > limit * (1.0 + EXCEEDED)
}

/// Friction of a contact among the rows of an assembly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum RowFriction {
    /// It has none.
    Frictionless,
    /// It sticks up to these coefficients, with so many rows along tangents.
    Sticks { ellipse: FrictionEllipse, rows: usize },
    /// It slides with this coefficient: one row along what friction opposes.
    Slides(f64),
}

impl RowFriction {
    /// How many rows along tangents.
    fn rows(self) -> usize {
        match self {
            Self::Frictionless => 0,
            Self::Sticks { rows, .. } => rows,
            Self::Slides(_) => 1,
        }
    }
}

/// What bounds the friction of a contact that sticks.
struct Sticks {
    /// Its row along the normal.
    normal: usize,
    /// Its rows along tangents.
    tangents: Range<usize>,
    ellipse: FrictionEllipse,
}

/// Whether no normal force of so many contacts pulls, and none of those that stick exceeds its friction.
fn obey(contacts: usize, sticks: &[Sticks], forces: &[f64]) -> bool {
    let pulls = forces.iter().take(contacts).any(|&force| force < 0.0);
    let slips = sticks.iter().any(|Sticks { normal, tangents, ellipse }| {
        exceeds_friction(ellipse.length(&forces[tangents.clone()]), ellipse.largest() * forces[*normal])
    });
    !pulls && !slips
}

/// The rows of an assembly in the order that [`least_norm_sliding_forces`] asks for.
struct RowOrder {
    /// Rows that are held, then those along which contacts slide.
    order: Vec<usize>,
    /// How many are held.
    held: usize,
    sliding: Vec<SlidingRow>,
    sticks: Vec<Sticks>,
}

impl RowOrder {
    /// That of contacts with this friction, whose rows along tangents follow `first_tangent`.
    fn new(first_tangent: usize, friction: &[RowFriction]) -> Self {
        let mut order: Vec<usize> = (0..first_tangent).collect();
        let mut slides = Vec::new();
        let mut sticks: Vec<Sticks> = Vec::new();
        let mut first = first_tangent;
        for (normal, &friction) in friction.iter().enumerate() {
            match friction {
                RowFriction::Frictionless => {}
                RowFriction::Sticks { ellipse, rows } => {
                    sticks.push(Sticks { normal, tangents: order.len()..order.len() + rows, ellipse });
                    order.extend(first..first + rows);
                }
                RowFriction::Slides(coefficient) => {
                    slides.push((first, SlidingRow { normal, tangent: 0, coefficient }));
                }
            }
            first += friction.rows();
        }
        let held = order.len();
        let mut sliding = Vec::with_capacity(slides.len());
        for (row, slide) in slides {
            sliding.push(SlidingRow { tangent: order.len(), ..slide });
            order.push(row);
        }
        Self { order, held, sliding, sticks }
    }
}

/// The blocks of so many contacts, of which these stick and all others only push.
fn blocks_of(contacts: usize, sticks: &[Sticks]) -> Blocks {
    let mut blocks = Blocks::default();
    let mut sticks = sticks.iter().peekable();
    for normal in 0..contacts {
        match sticks.next_if(|own| own.normal == normal) {
            Some(own) => push_contact(&mut blocks, own.ellipse, normal, own.tangents.clone()),
            None => blocks.push(Law::Push, [normal]),
        }
    }
    blocks
}

/// A contact that sticks, with its rows along tangents among the forces.
#[derive(Debug)]
struct StickingContact {
    contact: usize,
    rows: Range<usize>,
    tangents: Vec<DVec3>,
}

/// Shares the tangential force of each pair of bodies among its contacts in proportion to their normal forces, where
/// they have one normal and the force has no moment about the centre of pressure: least forces are shared evenly, and
/// would leave the cones of contacts with small normal forces although those of all contacts together can bear the
/// force.
fn share_by_pressure(contacts: &[Touch], sticking: &[StickingContact], forces: &mut [f64]) {
    let pair = |one: &StickingContact| (contacts[one.contact].id.a, contacts[one.contact].id.b);
    for of_pair in sticking.chunk_by(|x, y| pair(x) == pair(y)) {
        let geometry = |one: &StickingContact| &contacts[one.contact].kinematics.geometry;
        let Some(n) = of_pair.first().map(|first| geometry(first).normal) else { continue };
        let pressure: f64 = of_pair.iter().map(|one| forces[one.contact]).sum();
        let is_flush = |one: &StickingContact| {
            forces[one.contact] >= 0.0 && (geometry(one).normal - n).abs().max_element() <= SHARED_NORMAL
        };
        if of_pair.len() < 2 || pressure <= 0.0 || !of_pair.iter().all(is_flush) {
            continue;
        }
        let along = |one: &StickingContact, forces: &[f64]| {
            one.tangents.iter().zip(&forces[one.rows.clone()]).map(|(tangent, force)| *tangent * *force).sum::<DVec3>()
        };
        let center = of_pair.iter().map(|one| geometry(one).point * (forces[one.contact] / pressure)).sum::<DVec3>();
        let total: DVec3 = of_pair.iter().map(|one| along(one, forces)).sum();
        let arm = |one: &StickingContact| geometry(one).point - center;
        let moment: f64 = of_pair.iter().map(|one| n.dot(arm(one).cross(along(one, forces)))).sum();
        let largest = of_pair.iter().map(|one| arm(one).length()).fold(0.0, f64::max) * total.length();
        if moment.abs() > NO_MOMENT * largest {
            continue;
        }
        for one in of_pair {
            let own = total * (forces[one.contact] / pressure);
            for (row, tangent) in one.rows.clone().zip(&one.tangents) {
                forces[row] = tangent.dot(own);
            }
        }
    }
}

/// The least forces with which all contacts hold.
#[derive(Debug, Clone, Default)]
pub(crate) struct LeastSlidingForces {
    /// Of all rows, N.
    pub(crate) forces: Vec<f64>,
    /// Of all rows, m/s^2.
    pub(crate) accelerations: Vec<f64>,
    /// Whether other forces that hold all contacts as well would move the bodies in another way.
    pub(crate) motion_depends_on_choice: bool,
}

/// Forces (N) of all rows of `assembly`, whose contacts have this friction and whose rows have these constant terms
/// (m/s^2); none if they are not an answer. `rounding` is what an acceleration of zero may be (m/s^2) for these forces.
///
/// # Errors
/// When a number is not finite.
pub(crate) fn least_sliding_forces(
    (model, states, contacts): (&Model, &[BodyState], &[Touch]),
    assembly: &Assembly,
    constants: &[f64],
    friction: &[RowFriction],
    rounding: impl Fn(&Delassus, &[f64]) -> f64,
) -> Result<Option<LeastSlidingForces>, ResponseError> {
    let first_tangent = assembly.first_tangent();
    let RowOrder { order, held, sliding, sticks } = RowOrder::new(first_tangent, friction);
    let normals = contacts.iter().map(|touch| (touch.id, touch.kinematics.geometry));
    let mut ordered = Assembly::new(model, states, assembly.bodies(), normals)?;
    let tangents = order.iter().filter_map(|row| assembly.tangents().get(row.checked_sub(first_tangent)?)).copied();
    ordered.push_tangents(states, tangents)?;
    let delassus = ordered.problem.delassus();
    let wedges = |row: &SlidingRow| {
        delassus.get(row.normal, row.normal) <= row.coefficient * delassus.get(row.normal, row.tangent)
    };
    if sliding.iter().any(wedges) {
        return Ok(None);
    }
    let constants: Vec<f64> = order.iter().map(|&row| constants[row]).collect();
    let LeastNormForces { mut forces, loads } =
        least_norm_sliding_forces(&ordered.problem, &delassus, &constants[..held], &sliding)?;
    let tangent = |row: usize| order[row].checked_sub(first_tangent).and_then(|k| assembly.tangents().get(k));
    let patches = sticks.iter().map(|Sticks { normal, tangents: rows, .. }| {
        let tangents = rows.clone().filter_map(tangent).map(|row| row.along.normal).collect();
        StickingContact { contact: *normal, rows: rows.clone(), tangents }
    });
    share_by_pressure(contacts, &patches.collect::<Vec<_>>(), &mut forces);
    if !obey(contacts.len(), &sticks, &forces) {
        if loads.is_some() {
            return Ok(None);
        }
        let blocks = blocks_of(contacts.len(), &sticks);
        match least_forces_in_cones(&delassus, held, &sliding, &blocks, &forces)? {
            Some(found) if obey(contacts.len(), &sticks, &found) => forces = found,
            _ => return Ok(None),
        }
    }
    // The products of the matrix lose what forces that cancel on light bodies leave.
    let accelerations = if loads.is_some() {
        ordered.problem.accelerations(&constants, &forces)?
    } else {
        delassus.times(&forces)?.iter().zip(&constants).map(|(w, b)| w + b).collect()
    };
    let left = accelerations.iter().take(held).fold(0.0, |most: f64, w| most.max(w.abs()));
    if left > rounding(&delassus, &forces) {
        return Ok(None);
    }
    let (mut of_rows, mut left_of_rows) = (vec![0.0; forces.len()], vec![0.0; forces.len()]);
    for ((&row, &force), &left) in order.iter().zip(&forces).zip(&accelerations) {
        (of_rows[row], left_of_rows[row]) = (force, left);
    }
    let loads = (forces.as_slice(), contacts.len());
    let motion_depends_on_choice = motion_depends_on_choice(&delassus, held, &sliding, loads)?;
    Ok(Some(LeastSlidingForces { forces: of_rows, accelerations: left_of_rows, motion_depends_on_choice }))
}

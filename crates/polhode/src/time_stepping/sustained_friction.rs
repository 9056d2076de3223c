//! Friction of sustained contacts over a step, at velocity level.
//!
//! In the middle of the step, after a free flight of h/2, let `u-` be the slip of a contact before the impulses and `u+`
//! after them, `a` the part of its rate that is not due to contacts. The slip at the end is `u+ + r` with `r = h/2 a`.
//! Coulomb's law holds for that slip and the impulses of the step: it is zero where `|p_t| <= mu p_n` can make it zero, and
//! opposite to `p_t = -mu p_n u / |u|` otherwise. A body that rests on a slope ends exactly where it began: `u- = r`,
//! `u+ = -r`, and the ways of both halves of the step cancel.
//!
//! Impulses that stick do the work `p_t.(u- + u+)/2 = -(|u-|^2 - |r|^2) / 2G`. So that none is gained, `r` is shortened to
//! the length of `u-` where it is longer. Static and kinetic friction are not distinguished: the kinetic coefficient acts.

use crate::collision::contact_set::ContactId;
use crate::interaction::assembly::{Assembly, TangentRow};
use crate::interaction::friction_blocks::FrictionBlocks;
use crate::world::World;
use polhode_contact::{ContactGeometry, ContactKinematics};
use polhode_dynamics::BodyState;
use polhode_response::friction::{FrictionBlock, FrictionSettings};
use polhode_response::{Delassus, ResponseError, SolverReport};
use polhode_spatial::DVec3;

/// The largest residual of a step's problem that counts as solved (no unit, 1e-9 to 1e-5). The terms of contacts that depend
/// on each other, as the four corners of a box, contradict each other by such a share where a body turns or gaps differ:
/// reactions that satisfy the law to rounding then let a corner slip or part by that share of the speed that gravity gives in
/// a step. Within a step of 1e-3 s that is a way of some 1e-11 m.
const ACCEPTED_RESIDUAL: f64 = 1e-6;

/// Sweeps of the last resort: what they leave the error estimate of a stretch contains.
const LAST_SWEEPS: u32 = 100;

/// Friction of a contact in the middle of a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct TangentialRow {
    /// Coefficient of kinetic friction.
    coefficient: f64,
    /// Rows along both tangents.
    along: [TangentRow; 2],
    /// `u-` along the tangents, m/s.
    slip: [f64; 2],
    /// `r` along the tangents, m/s.
    half_change: [f64; 2],
}

impl TangentialRow {
    /// That of a contact in these states; its rates of slip are not known yet. None without friction.
    pub(super) fn of(
        world: &World,
        states: &[BodyState],
        id: ContactId,
        kinematics: &ContactKinematics,
    ) -> Option<Self> {
        let coefficient = world.friction_of(id.a, id.b)?.sliding;
        let terms = world.tangential_kinematics(states, id)?;
        let along = terms.basis.map(|tangent| TangentRow::new(id, &kinematics.geometry, &terms, tangent));
        let slip = terms.basis.map(|tangent| tangent.dot(terms.slip_velocity));
        Some(Self { coefficient, along, slip, half_change: [0.0; 2] })
    }

    /// The rows along both tangents.
    pub(super) fn along(&self) -> [TangentRow; 2] {
        self.along
    }

    /// The same with the rates of its slip without contact forces, m/s^2, over a step of `h` (s).
    pub(super) fn with_rates(self, rates: [f64; 2], h: f64) -> Self {
        let whole = Self { half_change: rates.map(|rate| 0.5 * h * rate), ..self };
        let share = whole.share();
        Self { half_change: whole.half_change.map(|change| share * change), ..self }
    }

    /// `r` as a vector, m/s.
    pub(super) fn half_change(&self) -> DVec3 {
        self.along.iter().zip(self.half_change).map(|(row, change)| row.along.normal * change).sum()
    }

    /// The same with the part of this `r` (m/s) along its tangents.
    pub(super) fn with_half_change(self, change: DVec3) -> Self {
        let change = self.along.map(|row| row.along.normal.dot(change));
        Self { half_change: change, ..self }
    }

    /// The longest part of `r` that gains no energy (no unit, at most 1).
    pub(super) fn share(&self) -> f64 {
        let [before, length] = [self.slip, self.half_change].map(|[x, y]| libm::hypot(x, y));
        if length > before { before / length } else { 1.0 }
    }

    fn constants(&self) -> [f64; 2] {
        [self.slip[0] + self.half_change[0], self.slip[1] + self.half_change[1]]
    }
}

/// A contact with friction and its impulse along the tangents, N s.
#[derive(Debug, Clone, Copy)]
pub(super) struct TangentialImpulse {
    row: TangentialRow,
    impulse: [f64; 2],
}

impl TangentialImpulse {
    /// Impulses on A along tangents, which stand in the place of the normal.
    pub(super) fn parts(&self) -> impl Iterator<Item = (ContactId, &ContactGeometry, f64)> + Clone {
        self.row.along.iter().zip(self.impulse).map(|(row, impulse)| (row.id, &row.along, impulse))
    }

    /// Energy lost to friction, J: `-p.(u- + u+)/2` with the slip after all impulses, m/s.
    pub(super) fn lost_j(&self, slip: DVec3) -> f64 {
        let along = self.row.along.iter().zip(self.row.slip).zip(self.impulse);
        along.map(|((row, before), impulse)| -0.5 * impulse * (before + row.along.normal.dot(slip))).sum()
    }

    /// The contact.
    pub(super) fn id(&self) -> ContactId {
        self.row.along[0].id
    }
}

/// Impulses of contacts, some of them with friction.
#[derive(Debug)]
pub(super) struct FrictionalImpulses {
    /// Along the normals, N s.
    pub(super) normal: Vec<f64>,
    pub(super) tangential: Vec<TangentialImpulse>,
    pub(super) report: SolverReport,
}

/// Solves for the impulses of contacts whose normal rows `assembly` holds, with these constant terms (m/s).
///
/// # Errors
/// When a number is not finite.
pub(super) fn solve(
    mut assembly: Assembly,
    states: &[BodyState],
    mut constants: Vec<f64>,
    friction: &[Option<TangentialRow>],
) -> Result<FrictionalImpulses, ResponseError> {
    let mut blocks = FrictionBlocks::default();
    for (normal, friction) in friction.iter().enumerate() {
        let first = assembly.problem.len();
        assembly.push_tangents(states, friction.iter().flat_map(TangentialRow::along))?;
        constants.extend(friction.iter().flat_map(TangentialRow::constants));
        let tangents = first..assembly.problem.len();
        let coefficient = friction.map_or(0.0, |friction| friction.coefficient);
        let block = FrictionBlock::Contact { rows: 1 + tangents.len(), friction: coefficient };
        blocks.push(block, std::iter::once(normal).chain(tangents));
    }
    let delassus: Delassus = assembly.problem.delassus();
    let settings =
        FrictionSettings { acceptance: ACCEPTED_RESIDUAL, last_sweeps: LAST_SWEEPS, ..FrictionSettings::default() };
    let solved = blocks.solve(&delassus, &constants, None, &settings)?;
    let (normal, along) = solved.reactions.split_at(friction.len().min(solved.reactions.len()));
    let pairs = friction.iter().flatten().zip(along.as_chunks::<2>().0);
    let tangential = pairs.map(|(&row, &impulse)| TangentialImpulse { row, impulse }).collect();
    Ok(FrictionalImpulses { normal: normal.to_vec(), tangential, report: solved.report })
}

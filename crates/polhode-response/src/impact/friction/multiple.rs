//! An impact with friction at several contacts.
//!
//! The contacts are the blocks of a [`FrictionProblem`] whose constant terms are the velocities before. Contacts that
//! do not move each other are struck on their own: one contact alone by the law of a single contact, whose path through
//! slip, stick and reversal is exact; several by [`MultipleImpactLaw`]. A contact that resists rotations is struck by
//! the cone problem of several contacts, also alone: its path has laws of slip for its rolling and its spinning as
//! well.

use super::law::{MultipleImpactLaw, RestitutionLaw};
use super::multiple_outcome::MultipleImpact;
use super::part::{CONE_ENERGY_ROUNDING, Part, Struck, energy};
use super::pulse::strike_by_springs;
use super::sequence::strike_in_order;
use super::simultaneous::strike_together;
use super::without_collision::strike_without_collision;
use crate::error::{ResponseError, check_finite, check_length};
use crate::friction::{FrictionProblem, FrictionSettings, Redundancy};
use crate::impact::ImpactStatus;
use polhode_spatial::DisjointSets;

/// The residual of an impact's cone problem that counts as solved (no unit, 1e-12 to 1e-9): coefficients of restitution
/// are known to three digits.
const ACCEPTED: f64 = 1e-10;

/// Most impulses for each contact where a sequence takes the place of a cone problem that was not solved: sequences at
/// contacts that share bodies may go on for long, and what is left is stopped at once.
const IMPULSES_IN_PLACE: usize = 100;

/// Tolerances and limits of impacts at several contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MultipleImpactSettings {
    /// A contact approaches when `u_n < -threshold * max |u_n-|` over the contacts that approach at first (no unit).
    pub threshold: f64,
    /// Most impulses of a sequence.
    pub limit: usize,
    /// Settings of the cone problems.
    pub solver: FrictionSettings,
}

impl Default for MultipleImpactSettings {
    fn default() -> Self {
        Self {
            threshold: 1e-12,
            limit: 100_000,
            solver: FrictionSettings {
                acceptance: ACCEPTED,
                redundancy: Redundancy::LeastNorm,
                ..FrictionSettings::default()
            },
        }
    }
}

/// An impact with friction at several contacts.
///
/// ```
/// use polhode_response::friction::FrictionProblem;
/// use polhode_response::{Law, MultipleFrictionalImpact, MultipleImpactSettings, ImpactStatus};
/// // A box of 1 kg and 1 m falls flat on two corners, in a plane, at 1 m/s down and 0.2 m/s along. Rows: normal and
/// // tangent of the left corner, then of the right one; inertia 1/6 kg m^2, arms (-1/2, -1/2) and (1/2, -1/2).
/// let row = |x: f64, y: f64, moment: f64| [x, y, 6.0_f64.sqrt() * moment];
/// let rows = [row(0.0, 1.0, -0.5), row(1.0, 0.0, 0.5), row(0.0, 1.0, 0.5), row(1.0, 0.0, 0.5)];
/// let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
/// let matrix: Vec<f64> = rows.iter().flat_map(|a| rows.map(|b| dot(*a, b))).collect();
/// let corner = Law::Cone { rows: 2, friction: 0.5 };
/// let contacts = FrictionProblem::from_dense(vec![corner, corner], &matrix, vec![-1.0, 0.2, -1.0, 0.2])?;
/// let impact = MultipleFrictionalImpact {
///     contacts: &contacts,
///     restitution: &[0.5, 0.5],
///     stand_for_several: &[],
///     law: Default::default(),
///     single: Default::default(),
///     settings: &MultipleImpactSettings::default(),
/// };
/// let outcome = impact.resolve()?;
/// assert_eq!(outcome.status, ImpactStatus::Separated);
/// assert!((outcome.velocities_after[1]).abs() < 1e-12 && outcome.energy_change < 0.0);
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct MultipleFrictionalImpact<'a> {
    /// Contacts and joints; the constant terms are the velocities before, m/s.
    pub contacts: &'a FrictionProblem,
    /// Restitution of each block, from 0 to 1; that of a joint is not used.
    pub restitution: &'a [f64],
    /// Blocks (ascending) that stand for several contacts each, as a contact and its mirror image in a plane: they are
    /// struck as several contacts are, also where there is no other.
    pub stand_for_several: &'a [usize],
    /// How contacts that move each other share the impact.
    pub law: MultipleImpactLaw,
    /// The law where one contact is struck alone.
    pub single: RestitutionLaw,
    /// Tolerances and limits.
    pub settings: &'a MultipleImpactSettings,
}

impl MultipleFrictionalImpact<'_> {
    /// Resolves the impact.
    ///
    /// # Errors
    /// When a list has the wrong length, or a number is not finite or out of its range.
    pub fn resolve(&self) -> Result<MultipleImpact, ResponseError> {
        self.by_groups(|part, group, struck| self.strike(part, group, struck))
    }

    /// Resolves a jam: contacts that touch and slide, and for which no finite forces satisfy Coulomb's law (Painleve).
    /// `free_accelerations` are those of all rows without contact forces, m/s^2; the contacts that they press together
    /// are struck, without restitution, by the impulses that steps of time tend to as they become shorter. Nothing
    /// happens where finite forces exist.
    ///
    /// # Errors
    /// Those of [`resolve`](Self::resolve).
    pub fn without_collision(&self, free_accelerations: &[f64]) -> Result<MultipleImpact, ResponseError> {
        check_length("free accelerations", self.contacts.rows(), free_accelerations.len())?;
        check_finite("free accelerations", free_accelerations)?;
        self.by_groups(|part, group, struck| {
            let accelerations: Vec<f64> =
                group.iter().flat_map(|&block| self.contacts.range(block)).map(|row| free_accelerations[row]).collect();
            let single = (!self.stands_for_several(group)).then_some(self.single);
            strike_without_collision(part, struck, &accelerations, single)
        })
    }

    fn check(&self) -> Result<(), ResponseError> {
        check_length("restitution", self.contacts.len(), self.restitution.len())?;
        if let Some((row, &value)) = self.restitution.iter().enumerate().find(|(_, e)| !(0.0..=1.0).contains(*e)) {
            return Err(ResponseError::Restitution { row, value });
        }
        let value = self.settings.threshold;
        if !(0.0..1.0).contains(&value) {
            return Err(ResponseError::Setting { field: "threshold", accepted: "at least 0 and below 1", value });
        }
        self.settings.solver.check()
    }

    /// Strikes each group of blocks that move each other, and adds up.
    fn by_groups(
        &self,
        strike: impl Fn(&mut Part, &[usize], &mut Struck) -> Result<(), ResponseError>,
    ) -> Result<MultipleImpact, ResponseError> {
        self.check()?;
        let (rows, blocks) = (self.contacts.rows(), self.contacts.len());
        let before = self.contacts.constant();
        let mut outcome = MultipleImpact {
            impulses: vec![0.0; rows],
            velocities_after: before.to_vec(),
            normal_work: vec![0.0; blocks],
            friction_work: vec![0.0; blocks],
            ..MultipleImpact::default()
        };
        for group in groups(self.contacts) {
            let mut part = Part::of(self.contacts, self.restitution, &group, self.settings.solver)?;
            let mut struck = Struck::nothing(&part, part.contacts.constant());
            stop_joints(&mut part, &mut struck)?;
            strike(&mut part, &group, &mut struck)?;
            self.book(&group, &part, &struck, &mut outcome);
        }
        let (change, size) = energy(&outcome.impulses, before, &outcome.velocities_after);
        outcome.energy_change = change;
        outcome.energy_rises |= change > CONE_ENERGY_ROUNDING * size;
        Ok(outcome)
    }

    /// Whether one of the blocks of a group stands for several contacts.
    fn stands_for_several(&self, group: &[usize]) -> bool {
        group.iter().any(|block| self.stand_for_several.binary_search(block).is_ok())
    }

    /// Strikes blocks that move each other, if they approach.
    fn strike(&self, part: &mut Part, group: &[usize], struck: &mut Struck) -> Result<(), ResponseError> {
        let contacts = part.touching();
        let approach = contacts.iter().map(|&block| -struck.velocities[part.normal_row(block)]).fold(0.0, f64::max);
        if approach <= 0.0 {
            return Ok(());
        }
        part.tolerance = self.settings.threshold * approach;
        part.status = part.status.max(ImpactStatus::Separated);
        let resist_rotations = contacts.iter().any(|&block| part.contacts.blocks()[block].resists_rotation());
        if let (MultipleImpactLaw::Pulse(exponent), true) = (self.law, contacts.len() > 1 || resist_rotations) {
            return strike_by_springs(part, struck, exponent, self.settings.limit);
        }
        let in_order = matches!(self.law, MultipleImpactLaw::Sequence | MultipleImpactLaw::Pulse(_));
        let are_several = contacts.len() > 1 || self.stands_for_several(group);
        let together = !in_order && (are_several || resist_rotations);
        if together && strike_together(part, struck)? {
            return Ok(());
        }
        let mut limit = self.settings.limit;
        if together {
            part.status = part.status.max(ImpactStatus::StruckInOrder);
            limit = limit.min(IMPULSES_IN_PLACE * contacts.len());
        }
        strike_in_order(part, struck, self.single, limit)
    }

    fn book(&self, group: &[usize], part: &Part, struck: &Struck, outcome: &mut MultipleImpact) {
        for (place, &block) in group.iter().enumerate() {
            for (from, to) in part.contacts.range(place).zip(self.contacts.range(block)) {
                outcome.impulses[to] = struck.impulses[from];
                outcome.velocities_after[to] = struck.velocities[from];
            }
            outcome.normal_work[block] = struck.normal_work[place];
            outcome.friction_work[block] = struck.friction_work[place];
        }
        outcome.energy_rises |= struck.energy_rises;
        outcome.applications += struck.applications;
        outcome.solves += part.solves;
        outcome.residual = outcome.residual.max(part.residual);
        outcome.status = outcome.status.max(part.status);
    }
}

/// Takes the motion of joints out of the velocities: joints that move and contacts that rebound, struck together, could
/// raise the energy.
fn stop_joints(part: &mut Part, struck: &mut Struck) -> Result<(), ResponseError> {
    if !part.joints_move(&struck.velocities) {
        return Ok(());
    }
    let stopping = part.solve(&part.joints(), &struck.velocities, None)?;
    let mut after = part.after(&struck.velocities, &stopping.impulses);
    part.hold_joints(&mut after);
    struck.add(part, &stopping.impulses, after);
    part.status = part.status.max(ImpactStatus::Separated);
    if !stopping.is_solved {
        part.not_solved();
    }
    Ok(())
}

/// Blocks that move each other, each group and the groups in the order of the blocks.
fn groups(contacts: &FrictionProblem) -> Vec<Vec<usize>> {
    let count = contacts.len();
    let mut sets = DisjointSets::new(count);
    for block in 0..count {
        for entry in contacts.matrix().blocks(block) {
            if entry.values.iter().any(|value| *value != 0.0) {
                sets.join(block, entry.column);
            }
        }
    }
    let mut groups: Vec<Vec<usize>> = Vec::new();
    let mut group_of = vec![None; count];
    for block in 0..count {
        let first = sets.smallest(block);
        let group = *group_of[first].get_or_insert_with(|| {
            groups.push(Vec::new());
            groups.len() - 1
        });
        groups[group].push(block);
    }
    groups
}

//! An impact with friction at one contact.

use super::algebraic;
use super::collision_matrix::{CollisionMatrix, power_of_two};
use super::coulomb::Coulomb;
use super::law::RestitutionLaw;
use super::outcome::{FrictionalImpact, FrictionalImpactStatus};
use super::path::{Path, PathEnd};
use super::phase::ImpactPhase;
use super::plane;
use super::restitution::{Measure, Restitution};
use crate::dense::kernels::compensated_dot;
use crate::error::{ResponseError, check_finite};
use polhode_spatial::rounding;

/// An impact with friction at one contact.
///
/// ```
/// use polhode_response::{CollisionMatrix, RestitutionLaw, PhaseKind, SingleFrictionalImpact};
/// // A rod of 1 kg and 1 m at 45 degrees falls on its lower end, at 1 m/s down and 0.6 m/s sideways (case IM-07).
/// let impact = SingleFrictionalImpact {
///     collision: CollisionMatrix::planar(2.5, -1.5, 2.5)?,
///     velocity_before: [-1.0, 0.6, 0.0],
///     friction: 0.5,
///     restitution: 0.5,
///     law: RestitutionLaw::Stronge,
/// };
/// let outcome = impact.resolve()?;
/// let kinds: Vec<PhaseKind> = outcome.phases.iter().map(|phase| phase.kind).collect();
/// assert_eq!(kinds, [PhaseKind::Slip, PhaseKind::Reversal]);
/// assert!((outcome.impulse[0] - 0.601_543_527_729_936_3).abs() < 1e-14);
/// assert!(outcome.energy_change < 0.0);
/// # Ok::<(), polhode_response::ResponseError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SingleFrictionalImpact {
    /// The collision matrix of the contact, 1/kg.
    pub collision: CollisionMatrix,
    /// Velocity of A over B before: normal (negative while approaching), first tangent, second tangent, m/s.
    pub velocity_before: [f64; 3],
    /// Coefficient of friction (no unit), at least 0.
    pub friction: f64,
    /// Coefficient of restitution `e`, from 0 to 1.
    pub restitution: f64,
    /// The law.
    pub law: RestitutionLaw,
}

impl SingleFrictionalImpact {
    /// Resolves the impact. A contact that does not approach but jams at its slip (Painleve) has an impact as well,
    /// without a collision.
    ///
    /// # Errors
    /// When a number is not finite, or a coefficient is out of its range.
    pub fn resolve(&self) -> Result<FrictionalImpact, ResponseError> {
        self.check()?;
        let (matrix, mass_scale) = self.collision.over_power_of_two();
        let speed = self.velocity_before.iter().fold(0.0, |most: f64, u| most.max(u.abs()));
        let coulomb = Coulomb { matrix, friction: self.friction };
        let speed_scale = power_of_two(speed);
        let before = self.velocity_before.map(|u| u / speed_scale);
        if !strikes(&coulomb, before) {
            return Ok(FrictionalImpact { velocity_after: self.velocity_before, ..FrictionalImpact::default() });
        }
        let scale = Scale { speed: speed_scale, impulse: speed_scale / mass_scale };
        let outcome = match self.law {
            RestitutionLaw::Stronge => self.along_path(&coulomb, before, Measure::Work),
            RestitutionLaw::Poisson => self.along_path(&coulomb, before, Measure::Impulse),
            RestitutionLaw::Newton => self.along_path(&coulomb, before, Measure::Velocity),
            RestitutionLaw::Whittaker => match algebraic::whittaker(&coulomb, before, self.restitution) {
                Some(impulse) => booked(&coulomb, before, impulse),
                // Slip before that jams: no impulse against it ends the approach.
                None => self.along_path(&coulomb, before, Measure::Velocity),
            },
            // Algebra on a velocity without approach gives no impulse: a jam is followed along its path.
            RestitutionLaw::ChatterjeeRuina { .. } if before[0] >= 0.0 => {
                self.along_path(&coulomb, before, Measure::Work)
            }
            RestitutionLaw::ChatterjeeRuina { tangential_restitution } => {
                let coefficients = [self.restitution, tangential_restitution];
                booked(&coulomb, before, algebraic::chatterjee_ruina(&coulomb, before, coefficients))
            }
        };
        let outcome = scale.of(&outcome, before);
        Ok(if is_finite(&outcome) {
            outcome
        } else {
            let status = FrictionalImpactStatus::NotSolved;
            FrictionalImpact { velocity_after: self.velocity_before, status, ..FrictionalImpact::default() }
        })
    }

    fn check(&self) -> Result<(), ResponseError> {
        check_finite("velocity before", &self.velocity_before)?;
        if !(self.friction >= 0.0 && self.friction.is_finite()) {
            return Err(ResponseError::Friction { contact: 0, friction: self.friction });
        }
        if !(0.0..=1.0).contains(&self.restitution) {
            return Err(ResponseError::Restitution { row: 0, value: self.restitution });
        }
        match self.law {
            RestitutionLaw::ChatterjeeRuina { tangential_restitution: value } if !(-1.0..=1.0).contains(&value) => {
                Err(ResponseError::TangentialRestitution { contact: 0, value })
            }
            _ => Ok(()),
        }
    }

    /// By following the path of the impact.
    fn along_path(&self, coulomb: &Coulomb, before: [f64; 3], measure: Measure) -> FrictionalImpact {
        let restitution = Restitution { measure, coefficient: self.restitution, approach: -before[0] };
        let path = Path::follow(coulomb, before, &restitution);
        FrictionalImpact {
            impulse: [path.normal_impulse, path.tangential_impulse[0], path.tangential_impulse[1]],
            velocity_after: [path.normal_velocity, path.slip[0], path.slip[1]],
            phases: path.phases,
            compression_impulse: path.compression,
            normal_work: path.normal_work,
            friction_work: path.friction_work,
            status: match path.end {
                PathEnd::Complete => FrictionalImpactStatus::Separated,
                PathEnd::Wedged => FrictionalImpactStatus::Wedged,
                PathEnd::Inconsistent | PathEnd::Unfinished => FrictionalImpactStatus::NotSolved,
            },
            ..FrictionalImpact::default()
        }
    }
}

/// Whether nothing overflowed.
fn is_finite(outcome: &FrictionalImpact) -> bool {
    let numbers = [outcome.impulse, outcome.velocity_after];
    numbers.as_flattened().iter().all(|x| x.is_finite()) && outcome.energy_change.is_finite()
}

/// Whether there is an impact: the contact approaches, or touches and jams.
fn strikes(coulomb: &Coulomb, before: [f64; 3]) -> bool {
    let jams = || plane::direction([before[1], before[2]]).is_some_and(|d| coulomb.normal_rate(d) < 0.0);
    before[0] < 0.0 || (before[0] == 0.0 && jams())
}

/// The outcome of a law that gives the impulse alone.
fn booked(coulomb: &Coulomb, before: [f64; 3], impulse: [f64; 3]) -> FrictionalImpact {
    let change = coulomb.matrix.times(impulse);
    let entries = coulomb.matrix.entries();
    let mut after = [0, 1, 2].map(|k| before[k] + change[k]);
    for (k, velocity) in after.iter_mut().enumerate() {
        let terms: f64 = entries[k].iter().zip(&impulse).map(|(entry, p)| (entry * p).abs()).sum();
        // Rounding of zero becomes zero.
        if velocity.abs() <= rounding::FEW_TERMS * (before[k].abs() + terms) {
            *velocity = 0.0;
        }
    }
    let mean = [0, 1, 2].map(|k| 0.5 * (before[k] + after[k]));
    FrictionalImpact {
        impulse,
        velocity_after: after,
        normal_work: impulse[0] * mean[0],
        friction_work: impulse[1] * mean[1] + impulse[2] * mean[2],
        status: FrictionalImpactStatus::Separated,
        ..FrictionalImpact::default()
    }
}

/// Units that the outcome is computed in, powers of two: m/s, N s.
#[derive(Debug, Clone, Copy)]
struct Scale {
    speed: f64,
    impulse: f64,
}

impl Scale {
    /// Books the energy of an outcome in these units and returns it in SI units.
    fn of(self, outcome: &FrictionalImpact, before: [f64; 3]) -> FrictionalImpact {
        let work = self.speed * self.impulse;
        let mean = [0, 1, 2].map(|k| 0.5 * (before[k] + outcome.velocity_after[k]));
        let change = compensated_dot(&outcome.impulse, &mean);
        let size: f64 =
            (0..3).map(|k| 0.5 * outcome.impulse[k].abs() * (before[k].abs() + outcome.velocity_after[k].abs())).sum();
        let phase = |phase: &ImpactPhase| ImpactPhase {
            normal_impulse: phase.normal_impulse * self.impulse,
            slip_after: phase.slip_after.map(|slip| slip * self.speed),
            ..*phase
        };
        FrictionalImpact {
            impulse: outcome.impulse.map(|p| p * self.impulse),
            velocity_after: outcome.velocity_after.map(|u| u * self.speed),
            phases: outcome.phases.iter().map(phase).collect(),
            compression_impulse: outcome.compression_impulse * self.impulse,
            normal_work: outcome.normal_work * work,
            friction_work: outcome.friction_work * work,
            energy_change: change * work,
            energy_rises: change > rounding::HUNDREDS_OF_TERMS * size,
            status: outcome.status,
        }
    }
}

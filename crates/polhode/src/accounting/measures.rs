//! Measured values that are compared with the promised limits: the worst over the run, with bodies and time.

use super::long_steps::LongSteps;
use super::numerical_loss::{FixedStep, LEFT_BY_SHORTER_STEP, NumericalLoss};
use super::occurrences::Occurrences;
use crate::identity::body_id::BodyId;
use crate::model::{Model, reported, tolerances};
use crate::report::broken_promise::BrokenPromise;
use crate::report::ledger::Ledger;
use crate::report::run_report::{Certificate, PairAt};
use crate::snapshot::{SnapshotError, content};
use polhode_spatial::CompensatedSum;

/// Limits of the whole scene.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Limits {
    /// Energy that projections may remove or add, relative to the energy of the scene.
    pub(crate) projection_energy_relative: f64,
    /// Energy that projections in stretches of crowded events may remove or add, relative to the energy of the scene.
    pub(crate) crowd_projection_relative: f64,
    /// Energy that the integrator may lose or gain, relative to the energy of the scene; infinite without a promise.
    pub(crate) numerical_relative: f64,
    /// Energy that ended bounces may take beyond their own, and that lifts onto higher faces may give, relative to the
    /// energy of the scene.
    pub(crate) replaced_relative: f64,
    /// Lower bound for the energy scale of the scene, J, for runs with hardly any energy.
    pub(crate) smallest_energy_j: f64,
    /// The fixed step of the method; none under error control.
    pub(crate) step: Option<FixedStep>,
    /// What would help, in words.
    pub(crate) remedy: &'static str,
}

impl Limits {
    /// What would help against a length beyond its limit, in words: with fixed steps also a step that may do, since
    /// what a step leaves falls at least with its length.
    fn shorter_step(&self, measure: &Measure) -> String {
        let remedy = self.remedy;
        match self.step {
            Some(FixedStep { step_s, .. }) => {
                format!("{remedy}; a step of {:.0e} s may do", LEFT_BY_SHORTER_STEP * step_s / measure.ratio())
            }
            None => remedy.to_owned(),
        }
    }
}

/// A value measured for a pair of bodies.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Measure {
    /// s.
    pub(crate) t: f64,
    pub(crate) pair: (usize, usize),
    pub(crate) value: f64,
    /// The promised limit for the pair, in the same unit; infinite without a promise.
    pub(crate) allowed: f64,
}

impl Measure {
    /// The value in units of its limit.
    pub(crate) fn ratio(&self) -> f64 {
        self.value / self.allowed
    }

    /// That it exceeded its limit, in words.
    fn broken(&self, what: String) -> BrokenPromise {
        BrokenPromise::exceeding(what, self.value, self.allowed).at(self.t)
    }

    fn at(&self) -> PairAt {
        PairAt { t_s: self.t, body_a: BodyId::new(self.pair.0), body_b: BodyId::new(self.pair.1) }
    }
}

/// The worst of one quantity over a run.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Worst {
    /// The largest value.
    largest: f64,
    /// The value with the largest ratio to its limit; among values without a limit the largest.
    worst: Option<Measure>,
}

impl Worst {
    /// Records a measure; values that are not positive are ignored.
    pub(crate) fn note(&mut self, measure: Measure) {
        // NaN is detected by the check of states.
        if measure.value.is_nan() || measure.value <= 0.0 {
            return;
        }
        self.largest = self.largest.max(measure.value);
        let rank = |m: &Measure| (m.ratio(), m.value);
        if self.worst.is_none_or(|worst| rank(&measure) > rank(&worst)) {
            self.worst = Some(measure);
        }
    }

    fn at(&self) -> Option<PairAt> {
        self.worst.map(|worst| worst.at())
    }

    fn of_limit(&self) -> f64 {
        self.worst.map_or(0.0, |worst| worst.ratio())
    }

    /// The worst, if it exceeds its limit.
    fn exceeded(&self) -> Option<Measure> {
        self.worst.filter(|worst| worst.ratio() > 1.0)
    }
}

impl Worst {
    fn save(&self) -> content::Worst {
        let save = |&Measure { t, pair, value, allowed }: &Measure| content::Measure { t, pair, value, allowed };
        content::Worst { largest: self.largest, worst: self.worst.as_ref().map(save) }
    }

    fn restored(saved: &content::Worst, bodies: usize) -> Result<Self, SnapshotError> {
        let worst = saved.worst.map(|content::Measure { t, pair, value, allowed }| Measure { t, pair, value, allowed });
        if worst.is_some_and(|worst| worst.pair.0.max(worst.pair.1) >= bodies) {
            return Err(SnapshotError::Invalid("a measure is of a body that the scene does not have"));
        }
        Ok(Self { largest: saved.largest, worst })
    }
}

/// All measures that are compared with promised limits.
#[derive(Debug, Clone, Default)]
pub(crate) struct Measures {
    /// m.
    pub(crate) penetration: Worst,
    /// That of the samples alone, m.
    pub(crate) sample_penetration: Worst,
    /// Displacement by one projection, m.
    pub(crate) projection: Worst,
    /// Change of energy by one projection, J.
    pub(crate) projection_energy: Worst,
    /// Violation of Coulomb's law, relative to the largest force of the problem.
    pub(crate) friction: Worst,
    /// Residual of the solution of a problem (natural map, relative); its pair means nothing.
    pub(crate) residual: Worst,
    /// Defect of Newton's law by the loads that are told of a step, relative to the sum of its terms; its pair means
    /// nothing.
    pub(crate) loads: Worst,
    /// Whether a joint has been measured.
    pub(crate) has_joints: bool,
    /// Distance of a joint from what it keeps, m.
    pub(crate) joint_gap: Worst,
    /// The same of its rotations, rad.
    pub(crate) joint_rotation: Worst,
    /// Energy removed by all projections except lifts and those of overlaps at the start, J.
    pub(crate) drift_energy: CompensatedSum,
    /// Change of energy by one lift onto a higher face, J.
    pub(crate) lifts: Worst,
    /// Energy removed by all of these, J.
    pub(crate) lifts_sum: CompensatedSum,
    /// Change of energy by the projections of one time step of a stretch of crowded events, J.
    pub(crate) crowd_projection: Worst,
    /// Energy removed by all of these, J.
    pub(crate) crowd_projection_sum: CompensatedSum,
    /// Energy that the end of bounces at one instant took beyond that of the bounces, J.
    pub(crate) ended_bounces: Worst,
    /// The same of all instants, J.
    pub(crate) ended_bounces_sum: CompensatedSum,
    /// Problems that were not solved to their tolerance.
    pub(crate) unsolved: Occurrences,
    /// What the integrator lost or gained.
    pub(crate) numerical: NumericalLoss,
    /// Fixed steps that were too long.
    pub(crate) long_steps: LongSteps,
}

impl Measures {
    /// Records the penetration of a sample: it counts for the run too.
    pub(crate) fn note_sample(&mut self, measure: Measure) {
        self.sample_penetration.note(measure);
        self.penetration.note(measure);
    }

    /// The measures as plain data.
    pub(super) fn save(&self) -> content::Measures {
        content::Measures {
            penetration: self.penetration.save(),
            sample_penetration: self.sample_penetration.save(),
            projection: self.projection.save(),
            projection_energy: self.projection_energy.save(),
            friction: self.friction.save(),
            residual: self.residual.save(),
            loads: self.loads.save(),
            has_joints: self.has_joints,
            joint_gap: self.joint_gap.save(),
            joint_rotation: self.joint_rotation.save(),
            drift_energy: self.drift_energy.parts(),
            lifts: self.lifts.save(),
            lifts_sum: self.lifts_sum.parts(),
            crowd_projection: self.crowd_projection.save(),
            crowd_projection_sum: self.crowd_projection_sum.parts(),
            ended_bounces: self.ended_bounces.save(),
            ended_bounces_sum: self.ended_bounces_sum.parts(),
            unsolved: self.unsolved.save(),
            numerical: self.numerical.save(),
            long_steps: self.long_steps.save(),
        }
    }

    /// The measures of a scene with this many bodies.
    ///
    /// # Errors
    /// When one is of a body that does not exist.
    pub(super) fn restored(saved: &content::Measures, bodies: usize) -> Result<Self, SnapshotError> {
        Ok(Self {
            penetration: Worst::restored(&saved.penetration, bodies)?,
            sample_penetration: Worst::restored(&saved.sample_penetration, bodies)?,
            projection: Worst::restored(&saved.projection, bodies)?,
            projection_energy: Worst::restored(&saved.projection_energy, bodies)?,
            friction: Worst::restored(&saved.friction, bodies)?,
            residual: Worst::restored(&saved.residual, bodies)?,
            loads: Worst::restored(&saved.loads, bodies)?,
            has_joints: saved.has_joints,
            joint_gap: Worst::restored(&saved.joint_gap, bodies)?,
            joint_rotation: Worst::restored(&saved.joint_rotation, bodies)?,
            drift_energy: CompensatedSum::from_parts(saved.drift_energy),
            lifts: Worst::restored(&saved.lifts, bodies)?,
            lifts_sum: CompensatedSum::from_parts(saved.lifts_sum),
            crowd_projection: Worst::restored(&saved.crowd_projection, bodies)?,
            crowd_projection_sum: CompensatedSum::from_parts(saved.crowd_projection_sum),
            ended_bounces: Worst::restored(&saved.ended_bounces, bodies)?,
            ended_bounces_sum: CompensatedSum::from_parts(saved.ended_bounces_sum),
            unsolved: Occurrences::restored(&saved.unsolved),
            numerical: NumericalLoss::restored(&saved.numerical),
            long_steps: LongSteps::restored(&saved.long_steps, bodies)
                .ok_or(SnapshotError::Invalid("a step is of a body that the scene does not have"))?,
        })
    }

    /// Writes what was measured into the certificate.
    pub(crate) fn fill(&self, ledger: &Ledger, certificate: &mut Certificate) {
        certificate.max_numerical_relative = self.numerical.relative();
        certificate.max_penetration_m = self.penetration.largest;
        certificate.max_penetration_of_limit = self.penetration.of_limit();
        certificate.max_penetration_at = self.penetration.at();
        certificate.max_sample_penetration_m = self.sample_penetration.largest;
        certificate.max_sample_penetration_of_limit = self.sample_penetration.of_limit();
        certificate.max_sample_penetration_at = self.sample_penetration.at();
        certificate.max_projection_m = self.projection.largest;
        certificate.max_projection_of_limit = self.projection.of_limit();
        certificate.max_projection_at = self.projection.at();
        let [located, crowded] = [&self.projection_energy, &self.crowd_projection];
        let larger = if crowded.largest > located.largest { crowded } else { located };
        certificate.max_projection_j = larger.largest;
        certificate.max_projection_relative = relative(larger.largest, ledger);
        certificate.max_projection_j_at = larger.at();
        certificate.max_ended_bounces_j = self.ended_bounces.largest;
        certificate.max_ended_bounces_at = self.ended_bounces.at();
        certificate.ended_bounces_j = self.ended_bounces_sum.value();
        certificate.max_residual = self.residual.largest;
        certificate.max_residual_of_limit = self.residual.of_limit();
        certificate.max_load_defect = self.loads.largest;
        certificate.max_load_defect_of_limit = self.loads.of_limit();
        certificate.max_joint_error_m = self.has_joints.then_some(self.joint_gap.largest);
        certificate.max_joint_error_of_limit = self.joint_gap.of_limit().max(self.joint_rotation.of_limit());
        certificate.max_joint_error_at = self.joint_gap.at();
        certificate.max_joint_error_rad = self.has_joints.then_some(self.joint_rotation.largest);
        certificate.max_friction_violation = self.friction.largest;
        certificate.max_friction_violation_of_limit = self.friction.of_limit();
        certificate.max_friction_violation_at = self.friction.at();
    }

    /// The limits that were exceeded.
    pub(crate) fn exceeded(&self, model: &Model, ledger: &Ledger, limits: &Limits) -> Vec<BrokenPromise> {
        let mut exceeded: Vec<BrokenPromise> = self.lengths_exceeded(model, limits).collect();
        exceeded.extend(self.energies_exceeded(model, ledger, limits));
        if let Some(worst) = self.friction.exceeded() {
            let (value, allowed, names) = (worst.value, worst.allowed, names(model, &worst));
            let what = format!(
                "friction of {names} exceeded Coulomb's law by {value:e} of the largest force, the promised limit is \
                 {allowed:e}"
            );
            exceeded.push(worst.broken(what).of(worst.pair).cured_by(limits.remedy));
        }
        if let Some(worst) = self.residual.exceeded() {
            let what = format!(
                "a problem of contacts or joints was solved to a residual of {:e}, the promised limit is {:e}: its \
                 forces are wrong by about that part of the largest",
                worst.value, worst.allowed
            );
            exceeded.push(worst.broken(what).cured_by(limits.remedy));
        }
        if let Some(worst) = self.loads.exceeded() {
            exceeded.push(worst.broken(format!(
                "the forces of contacts, joints and fields that a step tells are off Newton's law of a body by {:e} of \
                 them; the promised limit is {:e}: what it tells of loads is wrong by that",
                worst.value, worst.allowed
            )));
        }
        exceeded.extend(self.unsolved.list().iter().map(|unsolved| BrokenPromise::unsolved(unsolved.to_string())));
        exceeded
    }

    /// Overlaps, gaps of joints and displacements by projections beyond their limits.
    fn lengths_exceeded<'a>(
        &'a self,
        model: &'a Model,
        limits: &'a Limits,
    ) -> impl Iterator<Item = BrokenPromise> + 'a {
        let measured = [
            (&self.penetration, "", "overlapped by", "m"),
            (&self.joint_gap, "a joint of ", "was open by", "m"),
            (&self.joint_rotation, "a joint of ", "was turned off what it keeps by", "rad"),
            (&self.projection, "a projection of ", "moved a body by", "m"),
        ];
        measured.into_iter().filter_map(move |(quantity, whose, what, unit)| {
            let worst = quantity.exceeded()?;
            let Measure { pair, value, allowed, .. } = worst;
            let of_size = if unit == "m" {
                format!(", {:.1e} of the size of the smaller one", value / tolerances::pair_size(model, pair.0, pair.1))
            } else {
                String::new()
            };
            let names = names(model, &worst);
            let what = format!(
                "{whose}{names} {what} {value:.3e} {unit}{of_size}; the promised limit is {allowed:.3e} {unit}"
            );
            Some(worst.broken(what).of(pair).cured_by(limits.shorter_step(&worst)))
        })
    }

    /// Energies beyond their limits.
    fn energies_exceeded(&self, model: &Model, ledger: &Ledger, limits: &Limits) -> Vec<BrokenPromise> {
        let scale = ledger.scale_j.max(limits.smallest_energy_j);
        let beyond = |sum: f64, relative: f64, worst: &Worst| {
            let allowed = relative * scale;
            worst.worst.filter(|_| sum.abs() > allowed).map(|worst| (worst, names(model, &worst), allowed))
        };
        let broken = |what: String, sum: f64, limit: f64, worst: &Measure| {
            BrokenPromise::exceeding(what, sum.abs(), limit).at(worst.t).of(worst.pair)
        };
        let mut exceeded = Vec::new();
        let sum = self.drift_energy.value();
        if let Some((worst, names, allowed)) = beyond(sum, limits.projection_energy_relative, &self.projection_energy) {
            let (did, size) = if sum < 0.0 { ("gave", -sum) } else { ("took", sum) };
            let what = format!(
                "projections {did} {size:e} J in all, the largest, of {names}, changed {:e} J; the promised limit is \
                 {allowed:e} J",
                worst.value
            );
            exceeded.push(broken(what, sum, allowed, &worst).cured_by(limits.remedy));
        }
        let sum = self.lifts_sum.value();
        if let Some((worst, names, allowed)) = beyond(sum, limits.replaced_relative, &self.lifts) {
            let what = format!(
                "lifting bodies onto faces that are higher by less than the touch distance gave {:e} J in all, most of \
                 it, {:e} J, to {names}; the limit is {allowed:e} J",
                -sum, worst.value
            );
            exceeded.push(broken(what, sum, allowed, &worst));
        }
        let sum = self.crowd_projection_sum.value();
        if let Some((worst, names, allowed)) = beyond(sum, limits.crowd_projection_relative, &self.crowd_projection) {
            let what = format!(
                "projections in stretches of crowded events took {sum:e} J in all, those of one time step, the largest \
                 of {names}, {:e} J; the promised limit is {allowed:e} J",
                worst.value
            );
            exceeded.push(broken(what, sum, allowed, &worst).cured_by("a smaller method.crowding_tolerance may do"));
        }
        exceeded.extend(self.numerical.exceeded(limits.numerical_relative, limits.step));
        let sum = self.ended_bounces_sum.value().max(0.0);
        if let Some((worst, names, allowed)) = beyond(sum, limits.replaced_relative, &self.ended_bounces) {
            let what = format!(
                "ending bounces took {sum:e} J beyond the energy of the bounces, most of it from {names}, {:e} J; the \
                 limit is {allowed:e} J",
                worst.value
            );
            exceeded.push(broken(what, sum, allowed, &worst));
        }
        exceeded
    }
}

/// The bodies of a measure, as warnings name them.
fn names(model: &Model, measure: &Measure) -> String {
    reported::pair_names(model, measure.pair.0, measure.pair.1)
}

/// Energy relative to the largest of the run.
fn relative(energy_j: f64, ledger: &Ledger) -> f64 {
    if energy_j == 0.0 { 0.0 } else { energy_j / ledger.scale_j }
}

#[cfg(test)]
mod tests {
    use super::{Measure, Worst};

    fn measure(t: f64, pair: (usize, usize), value: f64, allowed: f64) -> Measure {
        Measure { t, pair, value, allowed }
    }

    /// The large pair penetrates deeper, but within its limit. The small pair exceeds its limit and is the one named.
    #[test]
    fn each_pair_is_compared_with_its_own_limit() {
        let mut worst = Worst::default();
        worst.note(measure(0.5, (0, 1), 1e-10, 1e-9));
        worst.note(measure(0.75, (2, 3), 1e-11, 1e-12));
        worst.note(measure(1.0, (0, 1), 2e-10, 1e-9));
        assert!(worst.exceeded().is_some_and(|exceeded| (exceeded.t, exceeded.pair) == (0.75, (2, 3))), "{worst:?}");
        assert_eq!(worst.largest, 2e-10);
        assert!((worst.of_limit() - 10.0).abs() < 1e-12);
    }

    /// A value without a limit never exceeds it; NaN and values that are not positive are ignored.
    #[test]
    fn a_value_without_a_limit_never_exceeds_it() {
        let mut worst = Worst::default();
        worst.note(measure(0.0, (0, 1), f64::NAN, 1.0));
        worst.note(measure(0.0, (0, 1), -1.0, 1.0));
        assert!(worst.at().is_none());
        worst.note(measure(0.0, (0, 1), 5.0, f64::INFINITY));
        worst.note(measure(1.0, (0, 2), 7.0, f64::INFINITY));
        assert!(worst.exceeded().is_none());
        assert_eq!((worst.largest, worst.of_limit(), worst.at().map(|at| at.t_s)), (7.0, 0.0, Some(1.0)));
    }
}

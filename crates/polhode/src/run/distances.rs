//! How far a run is from its references, and what that says of its errors (`crate::error_estimate` has the formulas).

use crate::error_estimate::references::{Reference, References};
use crate::report::observer::BodySample;
use crate::report::run_error::{BodyError, ReferenceKind};
use crate::run::simulation::Simulation;
use polhode_spatial::DVec3;

/// Distances of the past fade within this part of the time that a reference has run (no unit, 0.05 to 0.5).
const FADES_WITHIN: f64 = 0.2;

/// The error of time steps in crowded events, in distances from a run with steps twice as long (no unit, 1 to 3).
const CROWDED_WEIGHT: f64 = 2.0;

/// Roundings of the run, each as large as that of the start of a disturbed run, that add up (no unit, 1 to 30).
const ROUNDINGS: f64 = 10.0;

/// The part of the tolerance of a step that the errors of all steps come to at least (no unit, 0.01 to 1).
const PART_OF_TOLERANCE: f64 = 0.3;

/// Rounding of a position, of its coordinates, and of an attitude, of the angle that a body has turned by (no unit).
const ROUNDING_OF_PLACES: f64 = 8.0 * f64::EPSILON;

/// What a disturbed run says at a comparison.
struct Amplification {
    /// By how much a difference has grown since the last one.
    growth: f64,
    /// How far two runs a rounding apart are from each other; empty where none runs.
    distances: Vec<BodyError>,
}

impl Simulation {
    /// Notes how far the run is from its references at the present, and what that says of its errors.
    pub(super) fn note_distances(&mut self) {
        let samples = self.tier.samples(&self.core);
        let sizes: Vec<f64> = self.core.model.bodies.iter().map(|body| body.size).collect();
        let amplification = self.note_disturbed(&samples, &sizes);
        self.note_others(&samples, &sizes);
        let Some(errors) = self.errors_by_references(amplification.growth, samples.len()) else { return };
        let errors = self.bounded(errors, &amplification, (&samples, &sizes));
        self.references.course.note(self.core.t, errors, &sizes, self.core.settings.promise.error);
    }

    /// Notes how far a disturbed run is from its partner: another one, the run by other steps, or the run itself.
    fn note_disturbed(&mut self, samples: &[BodySample], sizes: &[f64]) -> Amplification {
        let t = self.core.t;
        let running = &self.references.running;
        let none = Amplification { growth: 1.0, distances: Vec::new() };
        let Some(reference) = running.iter().find(|own| own.kind == ReferenceKind::Disturbed) else { return none };
        let others = samples_of(&reference.run);
        let partner = reference.partner.as_deref().or(self.references.by_steps().map(|own| &*own.run));
        let distances = match partner.filter(|_| !self.disturbs_itself(self.references.effort)) {
            Some(partner) => distances(&samples_of(partner), &others),
            None => distances(samples, &others),
        };
        let (largest, covered_s) = (largest(&distances, sizes), t - reference.begun_s);
        let course = &mut self.references.course;
        let known = course.of_mut(ReferenceKind::Disturbed);
        (known.largest, known.covered_s) = (known.largest.max(largest), covered_s);
        Amplification { growth: course.growth.note(t, largest), distances }
    }

    /// Notes how far the other references are from the run.
    fn note_others(&mut self, samples: &[BodySample], sizes: &[f64]) {
        let (t, is_crowded) = (self.core.t, self.core.accounts.has_crowded());
        let References { running, course, .. } = &mut self.references;
        let since_s = t - course.compared_s;
        for reference in running.iter_mut().filter(|own| own.kind != ReferenceKind::Disturbed) {
            let distances = distances(samples, &samples_of(&reference.run));
            let known = course.of_mut(reference.kind);
            known.largest = known.largest.max(largest(&distances, sizes));
            let way_s = t - reference.begun_s;
            known.covered_s = if reference.is_whole { way_s } else { known.covered_s + since_s.min(way_s) };
            let fade = (1.0 - since_s / (FADES_WITHIN * way_s)).max(0.0);
            let weight = weight(reference, is_crowded);
            reference.since.resize(distances.len(), BodyError::default());
            for (since, distance) in reference.since.iter_mut().zip(&distances) {
                *since = since.times(fade).max(distance.times(weight));
            }
        }
    }

    /// What the references say of the errors of so many bodies, where the motion has amplified earlier ones by
    /// `growth`; none before anything is known.
    fn errors_by_references(&mut self, growth: f64, bodies: usize) -> Option<Vec<BodyError>> {
        let References { running, course, .. } = &mut self.references;
        let since_s = self.core.t - course.compared_s;
        for reference in running.iter_mut() {
            reference.base.iter_mut().for_each(|base| *base = base.times(growth));
        }
        let of_kind = |kind| running.iter().find(|own| own.kind == kind);
        let by_method = of_kind(ReferenceKind::OtherMethod).filter(|own| own.is_whole);
        let by_steps = of_kind(ReferenceKind::OtherSteps);
        let piece = running.iter().find(|own| own.is_piece_by_method()).map(Reference::errors);
        let by_pieces = piece.or_else(|| course.pieces.grown(growth, since_s, bodies));
        // A whole run by another method is better than any by other steps.
        let errors = match (by_method, by_steps) {
            (Some(whole), _) => whole.errors(),
            (None, Some(steps)) => larger(by_pieces.as_ref(), steps.errors()),
            (None, None) if course.errors.is_empty() && by_pieces.is_none() => return None,
            (None, None) => larger(by_pieces.as_ref(), course.grown(growth, since_s, bodies)),
        };
        course.pieces.errors = by_pieces.unwrap_or_default();
        Some(errors)
    }

    /// The same errors, none below what rounding, and the local errors of steps, make of it, and none above the way
    /// that a body has come.
    fn bounded(
        &self,
        errors: Vec<BodyError>,
        amplification: &Amplification,
        (samples, sizes): (&[BodySample], &[f64]),
    ) -> Vec<BodyError> {
        let (t, accounts, starts) = (self.core.t, &self.core.accounts, &self.references.course.start);
        // The errors of steps under error control add up to a part of a tolerance where they cancel, as a run beside
        // this one shows; where none accompanies all of it, they are known by themselves alone, and may not.
        let is_accompanied =
            self.references.running.iter().any(|own| own.is_whole && own.kind != ReferenceKind::Disturbed);
        let parts = if is_accompanied { PART_OF_TOLERANCE } else { accounts.step_errors.max(PART_OF_TOLERANCE) };
        let controlled = accounts.certificate.max_step_error.map_or(0.0, |_| self.core.settings.tolerance);
        let local = accounts.crowded.errors().max(parts * controlled);
        let of_body = |(body, error): (usize, BodyError)| {
            let (sample, size) = (&samples[body], sizes[body]);
            let start = starts.get(body).map_or(sample.pose.translation, |at| DVec3::from_array(*at));
            let way = (sample.pose.translation - start).length() + size;
            let most = BodyError::new(way, std::f64::consts::PI);
            let of_steps = BodyError::new(local * size, 0.0);
            let amplified = amplification.distances.get(body).copied().unwrap_or_default().times(ROUNDINGS);
            error.min(most).max(rounding(sample, size, t)).max(of_steps).max(amplified)
        };
        errors.into_iter().enumerate().map(of_body).collect()
    }
}

/// The bodies of a run at its present.
fn samples_of(run: &Simulation) -> Vec<BodySample> {
    run.tier.samples(&run.core)
}

/// How far the bodies of two runs are apart.
fn distances(one: &[BodySample], other: &[BodySample]) -> Vec<BodyError> {
    one.iter().zip(other).map(|(a, b)| distance(a, b)).collect()
}

/// The largest distance, of the size of a body.
fn largest(distances: &[BodyError], sizes: &[f64]) -> f64 {
    distances.iter().zip(sizes).map(|(own, &size)| own.of_size(size)).fold(0.0, f64::max)
}

/// What the distance from a reference is multiplied by. Where time steps pass crowded events, their error is larger
/// than that of all else.
fn weight(reference: &Reference<Simulation>, is_crowded: bool) -> f64 {
    if is_crowded && reference.kind == ReferenceKind::OtherSteps { CROWDED_WEIGHT } else { reference.weight }
}

/// The larger errors of both.
fn larger(one: Option<&Vec<BodyError>>, other: Vec<BodyError>) -> Vec<BodyError> {
    let Some(one) = one else { return other };
    one.iter().zip(other).map(|(a, b)| a.max(b)).collect()
}

/// How far a body is from where another run has it.
fn distance(one: &BodySample, other: &BodySample) -> BodyError {
    let apart = (one.pose.translation - other.pose.translation).length();
    BodyError::new(apart, one.pose.rotation.angle_to(other.pose.rotation))
}

/// What rounding alone may have done to a body of this size (m) until `t` (s).
fn rounding(sample: &BodySample, size: f64, t: f64) -> BodyError {
    let speed = sample.velocity.linear.length();
    let turn = sample.velocity.angular.length();
    let way = sample.pose.translation.abs().max_element() + speed * t + size;
    BodyError::new(ROUNDING_OF_PLACES * way, ROUNDING_OF_PLACES * (1.0 + turn * t))
}

//! The judgement: all laws, at all samples.

use super::error::JudgeError;
use super::given::{Given, VelocitySource};
use super::interval::{Interval, OfGroup, Verdict};
use super::law::{AtTime, Finding, Law};
use super::observed::{Middle, Observed, Observer, ROUNDING};
use super::start;
use super::truth::Truth;
use polhode::{BodyId, Evaluation, Scene};

/// Intervals in which a body must float, one after the other: at the top of a bounce it is still for one (no unit, 2 to
/// 5).
const FLOATS_FOR: usize = 3;

/// What is asked of a judgement.
#[derive(Debug, Clone, Copy)]
pub struct Question<'a> {
    /// What is nothing, of sizes, speeds and energies (no unit).
    pub tolerance: f64,
    /// The scene with the method of the truth; none where no distance from it is wanted.
    pub truth: Option<&'a Scene>,
}

/// What is found of a trajectory.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// What the trajectory is called.
    pub trajectory: String,
    /// What the scene is called.
    pub scene: String,
    /// What was nothing.
    pub tolerance: f64,
    /// First and last time, s.
    pub span_s: [f64; 2],
    /// How many samples.
    pub samples: usize,
    /// Where velocities come from.
    pub velocities: VelocitySource,
    /// What differences leave unknown of velocities at most, m/s.
    pub velocity_error_m_s: f64,
    /// Intervals that are longer than the others, s.
    pub gaps_s: Vec<[f64; 2]>,
    /// Where the file is cut off.
    pub cut_off: Option<String>,
    /// Energy at the first and at the last sample, J.
    pub energy_j: [f64; 2],
    /// Energy that was gained (below zero: lost) and that nothing in the scene explains, from the first sample to the
    /// last, J.
    pub unexplained_energy_j: f64,
    /// Linear (N s) and angular momentum about the world's origin (N m s) that nothing explains, summed.
    pub unexplained_impulse_ns: f64,
    /// Why a law could not be judged, or not everywhere.
    pub notes: Vec<String>,
    /// What is found of each law, in their order.
    pub findings: Vec<Finding>,
    /// The distance from the truth, where it was wanted.
    pub truth: Option<Truth>,
}

impl Judgement {
    /// Whether all laws are kept.
    pub fn is_kept(&self) -> bool {
        self.findings.iter().all(Finding::is_kept)
    }

    /// The laws that are broken, in the order in which they are first.
    pub fn broken(&self) -> Vec<&Finding> {
        let mut all: Vec<&Finding> = self.findings.iter().filter(|own| !own.is_kept()).collect();
        all.sort_by(|a, b| a.first_s.unwrap_or(f64::INFINITY).total_cmp(&b.first_s.unwrap_or(f64::INFINITY)));
        all
    }

    /// What is found of a law.
    pub fn finding(&self, law: Law) -> Option<&Finding> {
        self.findings.iter().find(|own| own.law == law)
    }
}

/// Judges a trajectory by the laws of a scene.
///
/// # Errors
/// When its units are not those of the scene, or the scene cannot be evaluated in its states.
pub fn judge(given: &Given, scene: &Scene, question: Question<'_>) -> Result<Judgement, JudgeError> {
    let Question { tolerance, truth } = question;
    if !(tolerance > 0.0 && tolerance < 1.0) {
        return Err(JudgeError::Tolerance(tolerance));
    }
    start::check(given, scene)?;
    let mut court = Court::new(given, scene, tolerance)?;
    court.hear()?;
    court.floating.end(&mut court.findings, court.intervals);
    let sizes: Vec<f64> = court.sizes();
    let truth = truth.map(|scene| Truth::of(scene, given, &sizes));
    if let Some(own) = &truth {
        court.add_truth(own, &sizes);
    }
    let last = given.times_s.len() - 1;
    let worst_error = |row: &Vec<f64>| row.iter().copied().fold(0.0, f64::max);
    Ok(Judgement {
        trajectory: given.name.clone(),
        scene: scene.name().to_owned(),
        tolerance,
        span_s: [given.times_s[0], given.times_s[last]],
        samples: given.times_s.len(),
        velocities: given.velocities,
        velocity_error_m_s: given.errors.iter().map(worst_error).fold(0.0, f64::max),
        gaps_s: given.gaps(),
        cut_off: given.cut_off.clone(),
        energy_j: court.energy_j,
        unexplained_energy_j: court.gained_j,
        unexplained_impulse_ns: court.impulse_ns,
        notes: court.notes,
        findings: court.findings,
        truth,
    })
}

/// Bodies that float, until it is known whether they do.
#[derive(Debug, Default)]
struct Floating {
    /// By body: since which intervals in a row.
    pending: std::collections::BTreeMap<BodyId, Vec<AtTime>>,
}

impl Floating {
    /// Bodies that float in an interval.
    fn note(&mut self, now: Vec<(BodyId, AtTime)>, findings: &mut [Finding]) {
        self.pending.retain(|body, _| now.iter().any(|(own, _)| own == body));
        for (body, value) in now {
            let own = self.pending.entry(body).or_default();
            own.push(value);
            if own.len() >= FLOATS_FOR {
                own.drain(..).for_each(|value| add(findings, Law::Floating, value));
                // What has floated long enough goes on to.
                own.extend((1..FLOATS_FOR).map(|_| nothing()));
            }
        }
    }

    /// The end of a trajectory of so many intervals.
    fn end(&mut self, findings: &mut [Finding], intervals: usize) {
        for own in self.pending.values_mut().filter(|own| own.len() >= intervals) {
            own.drain(..).for_each(|value| add(findings, Law::Floating, value));
        }
    }
}

/// A place that has been told already.
fn nothing() -> AtTime {
    AtTime { t_s: f64::NAN, value: 0.0, limit: 0.0, bodies: Vec::new(), what: "" }
}

fn add(findings: &mut [Finding], law: Law, value: AtTime) {
    if let Some(own) = findings.iter_mut().find(|own| own.law == law).filter(|_| !value.t_s.is_nan()) {
        own.add(value);
    }
}

/// What is gathered while a trajectory is gone through.
struct Court<'a> {
    observer: Observer<'a>,
    findings: Vec<Finding>,
    floating: Floating,
    intervals: usize,
    energy_j: [f64; 2],
    /// The largest energy so far, J: what its rounding and its tolerance are relative to.
    scale_j: f64,
    /// The largest sum of the magnitudes of its parts, J.
    parts_j: f64,
    gained_j: f64,
    /// What errors of integrals hide of it, J.
    hidden_j: f64,
    /// What differences leave unknown of the energy of the first and of the present sample, J.
    unsure_j: [f64; 2],
    impulse_ns: f64,
    /// Intervals in which the energy is not known.
    unknown: usize,
    notes: Vec<String>,
}

impl<'a> Court<'a> {
    fn new(given: &'a Given, scene: &'a Scene, tolerance: f64) -> Result<Self, JudgeError> {
        let evaluation = Evaluation::new(scene)?;
        let mut notes = Vec::new();
        if !evaluation.is_of_samples() {
            notes.push("carriages of tracks are not in a trajectory: what holds bodies to tracks is not judged".into());
        }
        Ok(Self {
            observer: Observer { scene, given, tolerance, evaluation },
            findings: Law::ALL.map(Finding::of).to_vec(),
            floating: Floating::default(),
            intervals: given.times_s.len() - 1,
            energy_j: [0.0; 2],
            scale_j: 0.0,
            parts_j: 0.0,
            gained_j: 0.0,
            hidden_j: 0.0,
            unsure_j: [0.0; 2],
            impulse_ns: 0.0,
            unknown: 0,
            notes,
        })
    }

    fn sizes(&self) -> Vec<f64> {
        let size = |body| self.observer.evaluation.movable(BodyId::new(body)).map_or(0.0, |own| own.size_m);
        (0..self.observer.scene.bodies().len()).map(size).collect()
    }

    fn add(&mut self, law: Law, value: AtTime) {
        add(&mut self.findings, law, value);
    }

    fn hear(&mut self) -> Result<(), JudgeError> {
        let mut last: Option<Observed> = None;
        for place in 0..self.observer.given.times_s.len() {
            let now = self.observer.observed(place)?;
            self.at_sample(place, &now);
            self.parts_j = self.parts_j.max(now.energy.scale_j);
            if let Some(before) = &last {
                let middle = self.observer.middle(place)?;
                self.between(place, [before, &now], &middle)?;
            } else {
                self.energy_j = [now.energy.kinetic_j + now.energy.potential_j; 2];
                self.add_energy(now.t_s);
            }
            last = Some(now);
        }
        if self.unknown > 0 {
            let (unknown, all) = (self.unknown, self.intervals);
            self.notes.push(format!(
                "energy: not judged in {unknown} of {all} intervals, in which belts or moved bodies may give any"
            ));
        }
        Ok(())
    }

    /// Penetration, joints and prescribed motions.
    fn at_sample(&mut self, place: usize, now: &Observed) {
        let t_s = now.t_s;
        for pair in &now.near {
            let limit = self.observer.touch_m(pair);
            if pair.points.iter().all(|own| own.slip_m_s.is_some()) && pair.separation_m < 0.0 {
                let bodies = pair.bodies.map(|own| self.observer.name(own)).to_vec();
                self.add(Law::Penetration, AtTime { t_s, value: -pair.separation_m, limit, bodies, what: "" });
            }
        }
        // Whether a joint that may break has done so stands in no sample.
        let joints = self.observer.scene.joints();
        let may_break =
            |own: &polhode::HeldState| own.joint.is_some_and(|joint| joints[joint.index()].strength().is_some());
        for own in now.held.iter().filter(|own| !may_break(own)) {
            let states = || own.bodies.iter().filter_map(|body| now.movable.get(body.index())?.as_ref());
            let size = states().map(|own| own.size_m).fold(0.0, f64::max);
            let far = states().map(|own| own.center_m.length()).fold(size, f64::max);
            let mut bodies = own.bodies.map(|own| self.observer.name(own)).to_vec();
            bodies.dedup();
            let limit = self.observer.tolerance * size + ROUNDING * far;
            let value = own.apart_m + own.turned_rad * size;
            self.add(Law::Joints, AtTime { t_s, value, limit, bodies, what: "" });
        }
        let given = self.observer.given;
        for (number, body) in self.observer.scene.bodies().iter().enumerate() {
            let place_now = given.samples[place][number].pose;
            let wanted = match (body.is_fixed(), body.motion()) {
                (_, Some(_)) => self.observer.evaluation.prescribed(BodyId::new(number)).map(|own| own.pose),
                (true, None) => Some(*body.initial_pose()),
                (false, None) => None,
            };
            let Some(wanted) = wanted else { continue };
            let size = self.sizes().into_iter().fold(0.0, f64::max);
            let apart = (place_now.translation - wanted.translation).length();
            let value = apart + place_now.rotation.angle_to(wanted.rotation) * size;
            let limit = self.observer.tolerance * size + ROUNDING * (size + wanted.translation.length());
            let bodies = vec![body.name().to_owned()];
            self.add(Law::Motion, AtTime { t_s, value, limit, bodies, what: "" });
        }
    }

    fn between(&mut self, place: usize, ends: [&Observed; 2], middle: &Middle) -> Result<(), JudgeError> {
        let interval = Interval { observer: &self.observer, place, ends, middle };
        let acted = interval.acted()?;
        let [work, hidden] = interval.integral([ends[0].power_w, middle.power_w, ends[1].power_w]);
        let unknown_j = self.energy_unknown(place, ends);
        let [before, after] = ends.map(|own| own.energy.kinetic_j + own.energy.potential_j);
        self.scale_j = self
            .scale_j
            .max(ends[1].energy.kinetic_j + (ends[1].energy.potential_j - ends[0].energy.potential_j).abs());
        self.energy_j[1] = after;
        let change = after - before - work;
        let [least, most] = acted.taken_j;
        let excess = change - change.clamp(-most.max(least), -least);
        if acted.is_driven {
            self.unknown += 1;
        } else {
            self.gained_j += excess;
            self.hidden_j += hidden + acted.hidden_j;
        }
        self.unsure_j[1] = unknown_j;
        if place == 1 {
            self.unsure_j[0] = unknown_j;
        }
        let t_s = ends[1].t_s;
        self.add_energy(t_s);
        if self.observer.evaluation.is_of_samples() {
            self.add_groups(t_s, ends[1].t_s - ends[0].t_s, acted.groups);
        }
        self.add_velocities(place, ends, &acted.struck);
        Ok(())
    }

    /// What differences leave unknown of the energy of a sample, J.
    fn energy_unknown(&self, place: usize, ends: [&Observed; 2]) -> f64 {
        let of = |(body, own): (usize, &Option<polhode::MovableState>)| {
            let Some(own) = own else { return 0.0 };
            let speed = own.velocity.linear.length() + own.velocity.angular.length() * own.size_m;
            let error = self.observer.given.velocity_error(place, body);
            own.mass_kg * error * (speed + error)
        };
        ends[1].movable.iter().enumerate().map(of).sum()
    }

    fn add_energy(&mut self, t_s: f64) {
        let rounding = ROUNDING * self.parts_j.max(self.scale_j);
        let limit =
            self.observer.tolerance * self.scale_j + rounding + self.hidden_j + self.unsure_j[0] + self.unsure_j[1];
        let (value, what) = (self.gained_j, if self.gained_j < 0.0 { "lost" } else { "gained" });
        self.add(Law::Energy, AtTime { t_s, value, limit, bodies: Vec::new(), what });
    }

    fn add_groups(&mut self, t_s: f64, h: f64, groups: Vec<OfGroup>) {
        let mut floating = Vec::new();
        for own in groups {
            let OfGroup { verdict, force_n: [value, limit], body, other } = own;
            let mut bodies = vec![self.observer.name(body)];
            bodies.extend(other.map(|(other, _)| self.observer.name(other)));
            let (law, what) = match verdict {
                Verdict::Explained => continue,
                Verdict::Slides => (Law::Friction, "slides, and friction does not act as it does on what slides"),
                Verdict::OutsideCone => (Law::Friction, "needs more friction than there is"),
                Verdict::Pulls => (Law::Contact, "a contact pulls"),
                Verdict::Apart => (Law::Contact, "a force, though nothing touches"),
                Verdict::Nothing => (Law::Momentum, ""),
                Verdict::Floats => {
                    let height = other.map_or(0.0, |(_, apart)| apart);
                    floating.push((body, AtTime { t_s, value: height, limit: 0.0, bodies, what: "" }));
                    continue;
                }
            };
            if matches!(verdict, Verdict::Nothing | Verdict::Apart) {
                self.impulse_ns += value * h;
            }
            self.add(law, AtTime { t_s, value, limit, bodies, what });
        }
        self.floating.note(floating, &mut self.findings);
    }

    /// Velocities against the rates of poses, but those of bodies that may have struck others between the samples.
    fn add_velocities(&mut self, place: usize, ends: [&Observed; 2], struck: &[BodyId]) {
        let given = self.observer.given;
        if given.velocities == VelocitySource::Differences {
            return;
        }
        let h = ends[1].t_s - ends[0].t_s;
        for (number, (a, b)) in ends[0].movable.iter().zip(&ends[1].movable).enumerate() {
            let (Some(a), Some(b)) = (a, b) else { continue };
            if struck.contains(&BodyId::new(number)) {
                continue;
            }
            let rate = (b.center_m - a.center_m) / h;
            let off = (rate - (a.velocity.linear + b.velocity.linear) * 0.5).length();
            let rows = place.saturating_sub(2)..(place + 2).min(given.samples.len());
            let velocity = |row: usize| given.samples[row][number].velocity;
            let changes = rows.clone().zip(rows.skip(1)).map(|(one, next)| {
                let (one, next) = (velocity(one), velocity(next));
                [(next.linear - one.linear).length(), (next.angular - one.angular).length()]
            });
            let most = changes.fold([0.0_f64; 2], |most, own| [most[0].max(own[0]), most[1].max(own[1])]);
            let fall = h * self.observer.scene.gravity().length();
            let rounding = ROUNDING * (b.center_m.length() / h + b.velocity.linear.length());
            let limit = 0.5 * most[0].max(fall) + rounding + self.observer.tolerance * b.velocity.linear.length();
            let bodies = vec![self.observer.name(BodyId::new(number))];
            self.add(Law::Velocities, AtTime { t_s: ends[1].t_s, value: off, limit, bodies: bodies.clone(), what: "" });
            let [from, to] = [place - 1, place].map(|row| given.samples[row][number].pose.rotation);
            let turned = (to * from.inverse()).to_rotation_vector() / h;
            let mean = (a.velocity.angular + b.velocity.angular) * 0.5;
            if mean.length() * h > 1.0 || turned.length() * h > 1.0 {
                continue;
            }
            let bound = most[1] + h * mean.length_squared() * h * mean.length() + ROUNDING / h;
            let (off, limit) = ((turned - mean).length(), bound + self.observer.tolerance * mean.length());
            let degrees = (mean * (std::f64::consts::PI / 180.0) - turned).length() <= limit;
            let what =
                if degrees && off > limit { "angular velocities look like degrees a second" } else { "of rotation" };
            let (value, limit) = (off * b.size_m, limit * b.size_m);
            self.add(Law::Velocities, AtTime { t_s: ends[1].t_s, value, limit, bodies, what });
        }
    }

    fn add_truth(&mut self, truth: &Truth, sizes: &[f64]) {
        let size = sizes.iter().copied().fold(0.0, f64::max);
        for own in &truth.over_time {
            let Some(error) = own.error_m else { continue };
            let bodies = vec![self.observer.name(BodyId::new(own.body))];
            let limit = self.observer.tolerance * size + error;
            self.add(Law::Truth, AtTime { t_s: own.t_s, value: own.distance_m, limit, bodies, what: "" });
        }
        if let Some(why) = &truth.ended {
            self.notes.push(format!("truth: {why}"));
        }
    }
}

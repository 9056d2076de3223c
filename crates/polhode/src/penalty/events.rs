//! Where a step has to end: contacts that begin, end, cease to press, turn, stick or slide, and points that leave their
//! features.
//!
//! A step freezes which springs there are and their modes, with laws that are continued smoothly past the change of a
//! mode. Each change has a signal that is positive while nothing happens. Along the dense output of a step all signals
//! are looked at in [`LOOKS`] equal parts.
//!
//! | signal | what happens where it becomes negative | force that the frozen step misses |
//! |---|---|---|
//! | separation of features that do not touch | a contact begins | that of its spring |
//! | overlap | it ends | its continued force |
//! | force of spring and damper, or minus it | the damper would pull; it pushes again | the same |
//! | rate of the overlap, or minus it | it is greatest, or least | `int T k_t'/k_t dt` of a held spring, else none |
//! | mu_s F_n - T | the tangential spring gives way | `T - mu F_n` |
//! | speed of giving way | it holds | `int k_t (speed) dt` |
//! | slip that is left before friction is kinetic | it becomes so | `(mu_s - mu) F_n`, and its damper |
//! | margin within its features, beyond rounding | the point leaves | that of its spring, and of overlaps without one |
//!
//! A missed force counts beyond what the rounding of positions makes of the spring's force anyway.
//!
//! **Which changes end a step.** The impulse of the missed force over the rest of the step is the error of a step that
//! goes on: `dv = (sum over looks) F dt tr(1/M)`, `dx = dv h`, with the trace of the inverse mass at the point of
//! contact, which bounds it in every direction. A change ends the step where that is at least its share of what the
//! step may err by anyway, one part for each signal's contact. It is located by bisection on the dense output, and the
//! step is repeated with that length. Every other change is made at the end of the step, where it is as good as on
//! time: contacts without load open and close by roundings and end no step, and neither does a greatest overlap. So do
//! points without load that leave their features and come back (sides of boxes that slide past each other, unloaded):
//! nothing is missed until other features of the pair overlap. Such changes cannot crowd: the force after a change
//! grows at most at the rate `k v`, so that a missed impulse worth the tolerance e of the speed takes a time of
//! `sqrt(2 e)/w`; where a plain damper makes the force jump by `c v`, a time of `e m/c`. The border of overlap holds no
//! sliding mode: forces jump there in the second derivative of the overlap, and it is crossed at a rate.
//!
//! How it fails: two changes of one signal within a part of a step pass unseen.

use super::contact::{ContactSpring, Evaluated, Grip, Push};
use super::laws::Laws;
use super::system::SpringSystem;
use crate::collision::contact_set;
use crate::identity::contact_id::ContactId;
use crate::model::tolerances;
use polhode_dynamics::DenseStep;
use polhode_response::penalty::{Damping, NormalSpring};
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

/// Parts of a step at whose ends signals are looked at (4 to 32).
const LOOKS: u32 = 8;

/// Halvings of a part of a step: to the rounding of a time within it.
const HALVINGS: u32 = 52;

/// Part of a step over which the rate of the normal force is taken (1e-5 to 1e-2): its error is of the square.
const TIME_DIFFERENCE: f64 = 1e-4;

/// Signals of a spring.
const SIGNALS: usize = 6;

/// What happens.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Happening {
    /// Features begin to touch.
    Begin(ContactId),
    /// A contact ends.
    End(ContactId),
    /// It ceases to press, or presses again.
    Press(ContactId),
    /// Its overlap is greatest or least.
    Turn(ContactId),
    /// Its tangential spring gives way, or holds.
    Grip(ContactId),
    /// Its friction becomes kinetic.
    Weaken(ContactId),
    /// The point leaves its features: others may take their place.
    Leave(ContactId),
}

impl Happening {
    fn id(self) -> ContactId {
        match self {
            Self::Begin(id)
            | Self::End(id)
            | Self::Press(id)
            | Self::Turn(id)
            | Self::Grip(id)
            | Self::Weaken(id)
            | Self::Leave(id) => id,
        }
    }
}

/// What a step may err by.
#[derive(Debug, Clone, Copy)]
pub(super) struct Allowed {
    /// m and m/s, the least of all bodies.
    pub(super) position: f64,
    pub(super) velocity: f64,
}

/// A change that is made at the end of the step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Passed {
    pub(super) what: Happening,
    /// When it was (s), and the rate of the overlap then (m/s).
    pub(super) t_s: f64,
    pub(super) rate: f64,
}

/// The greatest overlap (m) and normal force (N) of a spring in a step.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Peak {
    pub(super) depth: f64,
    pub(super) force: f64,
}

/// What is seen along a step.
#[derive(Debug, Default)]
pub(super) struct Seen {
    /// The change that ends the step, and when (s).
    pub(super) first: Option<(f64, Happening)>,
    /// Those that are made at its end, of a step that none ends.
    pub(super) passed: Vec<Passed>,
    /// Of every spring, up to the end of the step.
    pub(super) peaks: Vec<Peak>,
}

/// A spring at a look.
#[derive(Debug, Clone, Copy, Default)]
struct Motion {
    depth: f64,
    rate: f64,
    force: f64,
}

/// A signal at a look, and the force that the frozen mode misses (N); of one that grows with time, its rate (N/s).
#[derive(Debug, Clone, Copy)]
struct Signal {
    value: f64,
    missed: f64,
    missed_rate: f64,
    /// What the rounding of positions makes of the force (N).
    rounding: f64,
}

impl Signal {
    fn of(value: f64, missed: f64) -> Self {
        Self { value, missed, missed_rate: 0.0, rounding: 0.0 }
    }

    const NONE: Self = Self { value: f64::INFINITY, missed: 0.0, missed_rate: 0.0, rounding: 0.0 };
}

/// A look at a step.
#[derive(Debug)]
struct Look {
    t: f64,
    signals: Vec<Signal>,
    motions: Vec<Motion>,
}

/// Looks along a step.
#[derive(Debug)]
pub(super) struct Looking<'a, 'b> {
    pub(super) system: &'a mut SpringSystem<'b>,
    pub(super) dense: &'a DenseStep,
    pub(super) laws: &'a Laws,
    /// Features that may begin to touch.
    pub(super) candidates: &'a [ContactId],
    pub(super) allowed: Allowed,
    /// What has happened at the start of the step already, without time passing.
    pub(super) done: &'a [Happening],
    /// What does not advance time, s.
    pub(super) shortest: f64,
}

/// Springs of features that have met in the step; none of those that have no law.
type Begun = BTreeMap<ContactId, Option<NormalSpring>>;

impl Looking<'_, '_> {
    /// What is seen along the step.
    pub(super) fn seen(&mut self) -> Seen {
        let watched = self.watched();
        let looks = self.looks();
        let first = self.first_that_counts(&watched, &looks);
        let passed = if first.is_none() { self.passed(&watched, &looks) } else { Vec::new() };
        let until = first.map_or(f64::INFINITY, |(t, _)| t);
        Seen { first, passed, peaks: self.peaks(&looks, until) }
    }

    fn watched(&self) -> Vec<Happening> {
        let springs = self.system.springs.iter().flat_map(|spring| of_spring(spring.id));
        springs.chain(self.candidates.iter().flat_map(|&id| [Happening::Begin(id), Happening::Leave(id)])).collect()
    }

    fn looks(&mut self) -> Vec<Look> {
        let (t0, h) = (self.dense.t0(), self.dense.h());
        let mut begun = BTreeMap::new();
        let time = |look: u32| if look == LOOKS { t0 + h } else { t0 + h * (f64::from(look) / f64::from(LOOKS)) };
        (0..=LOOKS).map(|look| self.look(time(look), &mut begun)).collect()
    }

    /// All signals at a time (s), in the order of [`Looking::watched`].
    fn look(&mut self, t: f64, begun: &mut Begun) -> Look {
        let flat = self.at(t);
        let springs = self.system.springs;
        let mut signals = Vec::with_capacity(SIGNALS * springs.len() + self.candidates.len());
        let mut motions = Vec::with_capacity(springs.len());
        let mut sliding = Vec::new();
        let mut left = Vec::new();
        for index in 0..springs.len() {
            let spring = self.system.spring(&flat, index);
            let Some(at) = self.system.evaluated(&spring) else {
                signals.extend([Signal::NONE; SIGNALS]);
                motions.push(Motion::default());
                continue;
            };
            motions.push(Motion { depth: at.depth, rate: at.rate, force: spring.normal_force(&at) });
            let rounding = self.rounding_of(spring.id, &spring.normal, &at) * with_friction(&spring);
            for what in of_spring(spring.id) {
                if matches!(what, Happening::Grip(_)) && spring.slides() {
                    sliding.push((signals.len(), spring, at));
                }
                let signal = self.at_look(what, &spring, &at);
                if matches!(what, Happening::Leave(_)) && signal.value < 0.0 {
                    left.push((signals.len(), spring.id));
                }
                signals.push(Signal { rounding, ..signal });
            }
        }
        for &id in self.candidates {
            let [beginning, leaving] = self.beginning(id, begun);
            if leaving.value < 0.0 {
                left.push((signals.len() + 1, id));
            }
            signals.extend([beginning, leaving]);
        }
        for (place, id) in left {
            signals[place].missed += self.unseen(id, begun);
        }
        for (place, spring, at) in sliding {
            let speed = self.gripping(t, &spring, &at);
            let missed_rate = spring.tangential.stiffness(at.depth) * (-speed).max(0.0);
            signals[place] = Signal { value: speed, missed: 0.0, missed_rate, ..signals[place] };
        }
        Look { t, signals, motions }
    }

    /// The signal of a spring at a look; of one that slides and may hold again it is found when all others are.
    fn at_look(&self, what: Happening, spring: &ContactSpring, at: &Evaluated) -> Signal {
        match what {
            Happening::Begin(_) => Signal::NONE,
            Happening::End(_) => ending(spring, at),
            Happening::Press(_) => pressing(spring, at),
            Happening::Turn(_) => turning(spring, at),
            Happening::Leave(id) => self.leaving(id, at, spring.normal_force(at).abs() * with_friction(spring)),
            Happening::Grip(_) => holding(spring, at),
            Happening::Weaken(_) => weakening(spring, at),
        }
    }

    /// The margin of a point within its features, and the force of its spring (N), which it loses there.
    fn leaving(&self, id: ContactId, at: &Evaluated, force: f64) -> Signal {
        let rounding = tolerances::rounding(self.system.model, self.system.states, id.a, id.b);
        let value = at.kinematics.geometry.margin + rounding;
        Signal::of(value, if value < 0.0 { force } else { 0.0 })
    }

    /// Of features that do not touch: their separation and margin.
    fn beginning(&self, id: ContactId, begun: &mut Begun) -> [Signal; 2] {
        let (model, states) = (self.system.model, &*self.system.states);
        let Some(at) = Evaluated::new(model, states, id, false) else { return [Signal::NONE; 2] };
        let leaving = self.leaving(id, &at, 0.0);
        let beginning = Signal::of(-at.depth, self.force_of_begun(id, &at, begun));
        let spring = begun.get(&id).copied().flatten();
        let rounding = spring.map_or(0.0, |spring| self.rounding_of(id, &spring, &at));
        [Signal { rounding, ..beginning }, leaving]
    }

    /// What the rounding of positions makes of the force of a normal spring (N).
    fn rounding_of(&self, id: ContactId, spring: &NormalSpring, at: &Evaluated) -> f64 {
        let rounding = tolerances::rounding(self.system.model, self.system.states, id.a, id.b);
        spring.slope(at.depth.max(rounding)) * rounding
    }

    /// Force of a contact that has no spring yet (N), none where it does not overlap.
    fn force_of_begun(&self, id: ContactId, at: &Evaluated, begun: &mut Begun) -> f64 {
        if at.depth <= 0.0 {
            return 0.0;
        }
        let (model, states) = (self.system.model, &*self.system.states);
        let spring = *begun.entry(id).or_insert_with(|| {
            let law = self.laws.of_contact(model, states, (id, &at.kinematics.geometry), at.rate);
            law.ok().map(|law| law.normal)
        });
        // A contact without a law is refused where it begins.
        spring.map_or(f64::INFINITY, |spring| spring.force(at.depth, at.rate))
    }

    /// Force of the contacts of a pair that overlap and are neither springs nor watched (N): features that a point has
    /// come to which has left its own.
    fn unseen(&self, id: ContactId, begun: &mut Begun) -> f64 {
        let (model, states) = (self.system.model, &*self.system.states);
        let is_known = |found: &ContactId| {
            self.candidates.contains(found) || self.system.springs.iter().any(|spring| spring.id == *found)
        };
        let contacts = contact_set::contacts_of_pair(model, states, id.a, id.b, 0.0).into_iter();
        let unknown = contacts.filter(|found| !is_known(&found.id));
        unknown.map(|found| self.force_of_begun(found.id, &Evaluated::of(found.kinematics), begun)).sum()
    }

    /// The first change that ends the step, and when (s).
    fn first_that_counts(&mut self, watched: &[Happening], looks: &[Look]) -> Option<(f64, Happening)> {
        let mut first: Option<(f64, Happening)> = None;
        for (place, &what) in watched.iter().enumerate() {
            let Some((from, to)) = self.due(what, place, looks) else { continue };
            if !self.counts(what, place, looks) {
                continue;
            }
            let t = if from == to { from } else { self.locate(what, from, to) };
            // A signal that is zero but for rounding crosses again as soon as time has advanced by its rounding.
            if t - self.dense.t0() <= self.shortest && self.is_decided(what) {
                continue;
            }
            if first.is_none_or(|(earlier, _)| t < earlier) {
                first = Some((t, what));
            }
        }
        first
    }

    /// Between which times a signal becomes negative first; the start twice where it is so from there on, and has not
    /// been heeded.
    fn due(&self, what: Happening, place: usize, looks: &[Look]) -> Option<(f64, f64)> {
        let value = |look: &Look| look.signals.get(place).map_or(f64::INFINITY, |signal| signal.value);
        looks.windows(2).enumerate().find_map(|(part, pair)| {
            let [before, after] = pair else { return None };
            let (known, now) = (value(before), value(after));
            // A point that has left its features leaves them once; a change that has been made where the step begins is
            // not made again.
            let is_known = if part == 0 && known <= 0.0 {
                !matches!(what, Happening::Leave(_)) && !self.is_decided(what)
            } else {
                known >= 0.0
            };
            let is_due = now < 0.0 && is_known;
            is_due.then_some((before.t, if known <= 0.0 { before.t } else { after.t }))
        })
    }

    /// Whether a change has been made at the start of the step already and is not to be made again. Where both modes of
    /// a spring contradict themselves, it slides, and pushes.
    fn is_decided(&self, what: Happening) -> bool {
        let spring = || self.system.springs.iter().find(|spring| spring.id == what.id());
        let would_be_last = match what {
            Happening::Grip(_) => spring().is_some_and(ContactSpring::slides),
            Happening::Press(_) => spring().is_some_and(|spring| spring.push == Push::On),
            _ => true,
        };
        would_be_last && self.done.contains(&what)
    }

    /// Whether a change that is not made would be an error that the step may not have.
    fn counts(&mut self, what: Happening, place: usize, looks: &[Look]) -> bool {
        let (mut impulse, mut grown) = (0.0, 0.0);
        for pair in looks.windows(2) {
            let [before, after] = pair else { continue };
            let Some(signal) = after.signals.get(place) else { continue };
            let dt = after.t - before.t;
            grown += signal.missed_rate * dt;
            impulse += (signal.missed + grown - signal.rounding).max(0.0) * dt;
        }
        if impulse == 0.0 {
            return false;
        }
        self.at(self.dense.t0());
        let change = impulse * self.inverse_mass(what.id());
        let share = (self.system.springs.len() + self.candidates.len()) as f64;
        let is_within = |change: f64, allowed: f64| change * share < allowed;
        !(is_within(change, self.allowed.velocity) && is_within(change * self.dense.h(), self.allowed.position))
    }

    /// Trace of the inverse mass at the point of a contact, 1/kg: more than that along any direction.
    fn inverse_mass(&self, id: ContactId) -> f64 {
        let Some(at) = Evaluated::new(self.system.model, self.system.states, id, false) else { return f64::INFINITY };
        let of_body = |body: usize| {
            let Some(rigid) = &self.system.model.bodies[body].rigid else { return 0.0 };
            let state = &self.system.states[body];
            let inverse = rigid.inverse_inertia_world(state.pose.rotation);
            let along = |direction: DVec3| {
                let arm = (at.point - state.pose.translation).cross(direction);
                rigid.inverse_mass() + arm.dot(inverse * arm)
            };
            along(DVec3::X) + along(DVec3::Y) + along(DVec3::Z)
        };
        of_body(id.a) + of_body(id.b)
    }

    /// The changes that are made at the end of a step which none of them ends.
    fn passed(&mut self, watched: &[Happening], looks: &[Look]) -> Vec<Passed> {
        let Some(last) = looks.last() else { return Vec::new() };
        let mut passed = Vec::new();
        for (place, (&what, signal)) in watched.iter().zip(&last.signals).enumerate() {
            let id = what.id();
            let least = match what {
                // Contacts that overlap where a step begins get their springs then.
                Happening::Begin(_) | Happening::Leave(_) => continue,
                Happening::End(_) => -tolerances::rounding(self.system.model, self.system.states, id.a, id.b),
                _ => 0.0,
            };
            if signal.value >= least || signal.value.is_nan() {
                continue;
            }
            let mut of = Passed { what, t_s: last.t, rate: 0.0 };
            if matches!(what, Happening::End(_)) {
                let crossed = self.due(what, place, looks).filter(|(from, to)| from != to);
                of.t_s = crossed.map_or(self.dense.t0(), |(from, to)| self.locate(what, from, to));
                self.at(of.t_s);
                of.rate = Evaluated::new(self.system.model, self.system.states, id, false).map_or(0.0, |at| at.rate);
            }
            passed.push(of);
        }
        passed
    }

    /// Greatest overlaps and forces of springs up to a time (s).
    fn peaks(&mut self, looks: &[Look], until: f64) -> Vec<Peak> {
        let springs = self.system.springs;
        let mut peaks = vec![Peak::default(); springs.len()];
        for (index, spring) in springs.iter().enumerate() {
            let Some(peak) = peaks.get_mut(index) else { continue };
            for pair in looks.windows(2) {
                let [before, after] = pair else { continue };
                let (Some(x), Some(y)) = (before.motions.get(index), after.motions.get(index)) else { continue };
                if before.t > until {
                    break;
                }
                peak.include(x.depth, x.force);
                // At constant acceleration the overlap grows by less than this before it turns.
                let deepest = x.depth + x.rate * (after.t - before.t);
                if x.rate > 0.0 && y.rate <= 0.0 && deepest > spring.passage.deepest.max(peak.depth) {
                    let (t, [depth, force]) = self.turn_between(index, before.t, after.t);
                    if t <= until {
                        peak.include(depth, force);
                    }
                }
            }
        }
        peaks
    }

    /// Where the overlap of a spring is greatest (s), with the overlap (m) and the normal force (N) there.
    fn turn_between(&mut self, index: usize, from: f64, to: f64) -> (f64, [f64; 2]) {
        let mut at_time = |t: f64| {
            let flat = self.at(t);
            let spring = self.system.spring(&flat, index);
            self.system.evaluated(&spring).map(|at| (at.rate, [at.depth, spring.normal_force(&at)]))
        };
        let t = bisected(from, to, |t| at_time(t).map_or(f64::INFINITY, |(rate, _)| rate));
        (t, at_time(t).map_or([0.0; 2], |(_, found)| found))
    }

    /// Where in an interval (s) a signal becomes negative: the first time at which it is.
    fn locate(&mut self, what: Happening, from: f64, to: f64) -> f64 {
        bisected(from, to, |t| self.signal(what, t))
    }

    /// The springs and bodies at a time within the step.
    fn at(&mut self, t: f64) -> Vec<f64> {
        let mut flat = vec![0.0; self.dense.dimension()];
        self.dense.evaluate(t, &mut flat);
        self.system.set_states(t, &flat);
        flat
    }

    fn signal(&mut self, what: Happening, t: f64) -> f64 {
        let flat = self.at(t);
        let id = what.id();
        match (what, Evaluated::new(self.system.model, self.system.states, id, false)) {
            (Happening::Begin(_), at) => return at.map_or(f64::INFINITY, |at| -at.depth),
            (Happening::Leave(_), at) => return at.map_or(f64::INFINITY, |at| self.leaving(id, &at, 0.0).value),
            _ => {}
        }
        let place = self.system.springs.iter().position(|spring| spring.id == id);
        let Some(index) = place else { return f64::INFINITY };
        let spring = self.system.spring(&flat, index);
        let Some(at) = self.system.evaluated(&spring) else { return f64::INFINITY };
        match what {
            Happening::Begin(_) | Happening::Leave(_) | Happening::End(_) => at.depth,
            Happening::Press(_) => pressing(&spring, &at).value,
            Happening::Turn(_) => turning(&spring, &at).value,
            Happening::Grip(_) if spring.slides() => self.gripping(t, &spring, &at),
            Happening::Grip(_) => holding(&spring, &at).value,
            Happening::Weaken(_) => weakening(&spring, &at).value,
        }
    }

    /// The speed at which a spring gives way that slides, m/s.
    fn gripping(&mut self, t: f64, spring: &ContactSpring, at: &Evaluated) -> f64 {
        let stiffness = spring.tangential.stiffness(at.depth);
        if stiffness <= 0.0 {
            return f64::INFINITY;
        }
        let limit_rate = self.rate_of_normal_force(t, spring) * spring.limit(1.0);
        let falling = spring.tangential.relative_rate(at.depth, at.rate).min(0.0);
        let shrinking = (limit_rate - spring.limit(spring.normal_force(at)) * falling) / stiffness;
        at.slip.dot(spring.vector.normalize_or_zero()) - shrinking
    }

    /// Rate of the normal force of a spring at a time in the step, N/s.
    fn rate_of_normal_force(&mut self, t: f64, spring: &ContactSpring) -> f64 {
        let (t0, h) = (self.dense.t0(), self.dense.h());
        let (from, to) = ((t - TIME_DIFFERENCE * h).max(t0), (t + TIME_DIFFERENCE * h).min(t0 + h));
        let mut force = |t: f64| {
            self.at(t);
            self.system.evaluated(spring).map_or(0.0, |at| spring.normal_force(&at))
        };
        let (before, after) = (force(from), force(to));
        if to > from { (after - before) / (to - from) } else { 0.0 }
    }
}

impl Peak {
    fn include(&mut self, depth: f64, force: f64) {
        self.depth = self.depth.max(depth);
        self.force = self.force.max(force);
    }
}

/// The first time (s) in an interval at which a signal is negative that is so at its end.
fn bisected(from: f64, to: f64, mut signal: impl FnMut(f64) -> f64) -> f64 {
    let (mut low, mut high) = (from, to);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if signal(middle) < 0.0 { high = middle } else { low = middle }
    }
    high
}

/// What is watched of a spring, in the order of its signals.
fn of_spring(id: ContactId) -> [Happening; SIGNALS] {
    let of_normal = [Happening::End(id), Happening::Press(id), Happening::Turn(id), Happening::Leave(id)];
    let [end, press, turn, leave] = of_normal;
    [end, press, turn, leave, Happening::Grip(id), Happening::Weaken(id)]
}

/// The overlap.
fn ending(spring: &ContactSpring, at: &Evaluated) -> Signal {
    let continued = if at.depth < 0.0 { spring.normal_force(at).abs() } else { 0.0 };
    Signal::of(at.depth, continued * with_friction(spring))
}

/// Positive while a spring that presses goes on, or one that does not.
fn pressing(spring: &ContactSpring, at: &Evaluated) -> Signal {
    let force = spring.normal.continued(at.depth, at.rate);
    let pushing = match spring.normal.damping() {
        Damping::Plain(0.0) => return Signal::NONE,
        Damping::HuntCrossley(a) => 1.0 + a * at.rate,
        Damping::Plain(_) => force,
    };
    let signed = if spring.push == Push::Off { -pushing } else { pushing };
    let is_missed = at.depth >= 0.0 && signed < 0.0;
    Signal::of(signed, if is_missed { force.abs() * with_friction(spring) } else { 0.0 })
}

/// Rate of the overlap, or minus it.
fn turning(spring: &ContactSpring, at: &Evaluated) -> Signal {
    let value = if spring.loading { at.rate } else { -at.rate };
    let is_wrong = value < 0.0 && spring.grip == Grip::Stick;
    let rate = if is_wrong { spring.tangential.relative_rate(at.depth, at.rate).abs() } else { 0.0 };
    Signal { missed_rate: spring.vector.length() * rate, ..Signal::of(value, 0.0) }
}

/// Coulomb's limit less the force of a tangential spring that holds, N; infinite where none holds.
fn holding(spring: &ContactSpring, at: &Evaluated) -> Signal {
    let (Grip::Stick, Some(friction)) = (spring.grip, spring.friction) else { return Signal::NONE };
    let (normal, held) = (spring.normal_force(at), spring.vector.length());
    let value = spring.limit(normal) - held;
    Signal::of(value, if value < 0.0 { (held - friction.sliding * normal).max(0.0) } else { 0.0 })
}

/// What is left of the slip after which static friction is kinetic, m; infinite where none is followed.
fn weakening(spring: &ContactSpring, at: &Evaluated) -> Signal {
    let (Grip::Yield, Some(friction)) = (spring.grip, spring.friction) else { return Signal::NONE };
    let value = spring.holding.weakening - spring.slipped;
    let more = (friction.at_rest - friction.sliding) * spring.normal_force(at).max(0.0);
    let more = more + spring.holding.damper * at.slip.length();
    Signal::of(value, if value < 0.0 { more } else { 0.0 })
}

/// The force of a contact in units of its normal force, at most.
fn with_friction(spring: &ContactSpring) -> f64 {
    1.0 + spring.friction.map_or(0.0, |friction| friction.at_rest)
}

//! Where a step has to end: contacts that begin, end, cease to press, turn, stick or slide.
//!
//! Each has a signal that is positive while nothing happens. Along the dense output of a step all signals are looked at in
//! [`LOOKS`] equal parts; the first that becomes negative is located by bisection on the dense output, and the step is
//! repeated with that length. Forces are continuous where a contact ends, turns, sticks or slides, so that the error of the
//! location counts in its square; where a plain damper makes the force begin with a jump, it is that of the dense
//! output times the jump.
//!
//! | signal | what happens where it becomes negative |
//! |---|---|
//! | separation of features that do not touch | a contact begins |
//! | overlap | it ends |
//! | force of spring and damper, or minus it | the damper would pull; it pushes again |
//! | rate of the overlap, or minus it | the overlap is greatest, or least |
//! | mu_s F_n - T | the tangential spring gives way |
//! | speed of giving way | it holds |
//!
//! How it fails: two changes of one signal within a part of a step pass unseen.

use super::contact::{ContactSpring, Evaluated, Grip};
use super::system::SpringSystem;
use crate::collision::contact_id::ContactId;
use polhode_dynamics::DenseStep;
use polhode_response::penalty::{Damping, Growth};

/// Parts of a step at whose ends signals are looked at (4 to 32).
const LOOKS: u32 = 8;

/// Halvings of a part of a step: to the rounding of a time within it.
const HALVINGS: u32 = 52;

/// Part of a step over which the rate of the normal force is taken (1e-5 to 1e-2): its error is of the square.
const TIME_DIFFERENCE: f64 = 1e-4;

/// A turn counts when the rate changes by more than this part of the rate of approach (1e-9 to 1e-3).
const TURN_RELATIVE: f64 = 1e-6;

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
}

/// Looks along a step.
#[derive(Debug)]
pub(super) struct Looking<'a, 'b> {
    pub(super) system: &'a mut SpringSystem<'b>,
    pub(super) dense: &'a DenseStep,
    /// Features that may begin to touch.
    pub(super) candidates: &'a [ContactId],
    /// A speed at which a contact is at rest, m/s.
    pub(super) resting_speed: f64,
    /// What has happened at the start of the step already, without time passing.
    pub(super) done: &'a [Happening],
}

impl Looking<'_, '_> {
    /// The first thing to happen in the step, and when (s).
    pub(super) fn first(&mut self) -> Option<(f64, Happening)> {
        let watched = self.watched();
        let (t0, h) = (self.dense.t0(), self.dense.h());
        let mut before = self.signals(t0);
        let mut from = t0;
        for look in 1..=LOOKS {
            let to = if look == LOOKS { t0 + h } else { t0 + h * (f64::from(look) / f64::from(LOOKS)) };
            let after = self.signals(to);
            let mut first: Option<(f64, Happening)> = None;
            for ((known, now), &what) in before.iter().zip(&after).zip(&watched) {
                let is_due = *now < 0.0 && (*known >= 0.0 || (look == 1 && !self.done.contains(&what)));
                if is_due && self.counts(what, *known, *now) {
                    let t = if *known <= 0.0 { from } else { self.locate(what, from, to) };
                    if first.is_none_or(|(earlier, _)| t < earlier) {
                        first = Some((t, what));
                    }
                }
            }
            if first.is_some() {
                return first;
            }
            (before, from) = (after, to);
        }
        None
    }

    /// All signals at a time (s), in the order of [`Looking::watched`].
    fn signals(&mut self, t: f64) -> Vec<f64> {
        let flat = self.at(t);
        let springs = self.system.springs;
        let mut signals = Vec::with_capacity(4 * springs.len() + self.candidates.len());
        let mut sliding = Vec::new();
        for index in 0..springs.len() {
            let spring = self.system.spring(&flat, index);
            let Some(at) = self.system.evaluated(&spring) else {
                signals.extend([f64::INFINITY; 4]);
                continue;
            };
            let turning = if spring.loading { at.rate } else { -at.rate };
            signals.extend([at.depth, pressing(&spring, &at), turning, holding(&spring, &at)]);
            if spring.grip == Grip::Slide {
                sliding.push((signals.len() - 1, spring, at));
            }
        }
        for &id in self.candidates {
            signals.push(self.separation(id));
        }
        for (place, spring, at) in sliding {
            signals[place] = self.gripping(t, &spring, &at);
        }
        signals
    }

    fn separation(&self, id: ContactId) -> f64 {
        Evaluated::new(self.system.world, self.system.states, id, false).map_or(f64::INFINITY, |at| -at.depth)
    }

    fn watched(&self) -> Vec<Happening> {
        let springs = self.system.springs.iter().flat_map(|spring| {
            let id = spring.id;
            [Happening::End(id), Happening::Press(id), Happening::Turn(id), Happening::Grip(id)]
        });
        springs.chain(self.candidates.iter().map(|&id| Happening::Begin(id))).collect()
    }

    /// Whether a change of a signal is more than rounding.
    fn counts(&self, what: Happening, before: f64, now: f64) -> bool {
        let Happening::Turn(id) = what else { return true };
        let own = self.system.springs.iter().find(|spring| spring.id == id);
        let approach = own.map_or(0.0, |spring| spring.passage.approach);
        before - now > TURN_RELATIVE * approach.max(self.resting_speed)
    }

    /// Where in an interval (s) a signal becomes negative: the first time at which it is.
    fn locate(&mut self, what: Happening, from: f64, to: f64) -> f64 {
        let (mut low, mut high) = (from, to);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if self.signal(what, middle) < 0.0 { high = middle } else { low = middle }
        }
        high
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
        let id = match what {
            Happening::Begin(id) => return self.separation(id),
            Happening::End(id) | Happening::Press(id) | Happening::Turn(id) | Happening::Grip(id) => id,
        };
        let place = self.system.springs.iter().position(|spring| spring.id == id);
        let Some(index) = place else { return f64::INFINITY };
        let spring = self.system.spring(&flat, index);
        let Some(at) = self.system.evaluated(&spring) else { return f64::INFINITY };
        match what {
            Happening::End(_) => at.depth,
            Happening::Press(_) => pressing(&spring, &at),
            Happening::Turn(_) if spring.loading => at.rate,
            Happening::Turn(_) => -at.rate,
            _ => self.gripping(t, &spring, &at),
        }
    }

    /// Coulomb's limit less the force of a spring that holds, N; the speed at which one gives way that slides, m/s.
    fn gripping(&mut self, t: f64, spring: &ContactSpring, at: &Evaluated) -> f64 {
        if spring.grip != Grip::Slide {
            return holding(spring, at);
        }
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

/// Coulomb's limit less the force of a tangential spring that holds, N; infinite where none holds.
fn holding(spring: &ContactSpring, at: &Evaluated) -> f64 {
    match spring.grip {
        Grip::Free | Grip::Cut | Grip::Slide => f64::INFINITY,
        Grip::Stick => spring.limit(spring.normal_force(at)) - spring.vector.length(),
    }
}

/// Positive while a spring that presses goes on, or one that does not.
fn pressing(spring: &ContactSpring, at: &Evaluated) -> f64 {
    let pushing = match (spring.normal.damping(), spring.normal.growth()) {
        (Damping::Plain(0.0), _) => return f64::INFINITY,
        (Damping::HuntCrossley(a), _) => 1.0 + a * at.rate,
        (Damping::Plain(_), Growth::Linear | Growth::Hertz) => spring.normal.unclipped(at.depth, at.rate),
    };
    if spring.presses { pushing } else { -pushing }
}

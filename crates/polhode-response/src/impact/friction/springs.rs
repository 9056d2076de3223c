//! Contacts as springs, while the bodies stand still (Liu, Zhao and Brogliato), with Coulomb's friction.
//!
//! In the indentation `d_i` of contact `i` and the variable `s` in which its force runs,
//!
//! `d_i' = -c_i u_i`, `p_n,i' = K d_i^eta`, `u = u- + G p`, with `c_i = 1` while it closes and `1/e_i^2` while it
//! opens,
//!
//! and friction `|p_t,i'| <= mu_i p_n,i'`: against the slip where there is one, and otherwise the least that holds the
//! contact, if any does (`held_slip.rs`). `u` in m/s, `p` in N s, `G` in 1/kg; `K` (the same at all contacts) and the
//! unit of `s` cancel. With `E_i = K d_i^(1 + eta)/(1 + eta)` this is `dp_i/dp_j = (E_i/E_j)^(eta/(1 + eta))`, without
//! the start from 0/0.
//!
//! The work that a contact takes while it closes is `W_i`, what it gives back `e_i^2 W_i`, and friction gives none: the
//! energy changes by `-sum_i (1 - e_i^2) W_i` and the work of friction. One contact alone, whatever `eta`, follows
//! Routh's path to Stronge's end. Normal forces are never asked to be what they cannot: a jam (Painleve) compresses the
//! spring until the slip ends.
//!
//! Method: Dormand and Prince's pair of orders 5 and 4, steps by the estimated error ([`STEP_ERROR`]) in pieces: where
//! a contact begins, turns, opens, stops slipping or starts to, a piece ends, found by the secant within its bracket to
//! rounding. It ends
//!
//! - when all contacts are open and none approaches;
//! - when what they store, and may still take, is below the energy of an approach that is over ([`SPENT`]);
//! - when loaded contacts neither move nor are moved: bodies at rest between others, whose springs hold each other.
//!
//! How it fails: bodies between others that keep all energy are compressed without end, and a body that is far lighter
//! than those around it nearly so. Beyond a number of compressions that the caller gives the walk stops, and says so.
//!
//! Source: Liu, Zhao and Brogliato 2008 and 2009 (friction); Dormand and Prince 1980.

use super::held_slip::HeldSlip;
use super::plane::{self, Tangent};
use super::spring_contact::SpringContact;
use crate::tolerances::LEAST_CHANGE;

/// The exponent of the springs of the contacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum PulseExponent {
    /// `eta = 1`: force in proportion to indentation.
    Linear,
    /// `eta = 3/2`: Hertz, for curved surfaces.
    #[default]
    Hertz,
}

impl PulseExponent {
    /// All exponents.
    pub const ALL: [Self; 2] = [Self::Linear, Self::Hertz];

    /// The name used in scenes and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Hertz => "hertz",
        }
    }

    /// Force of an indentation, in units of `K`; no force where the bodies are apart.
    fn force(self, indentation: f64) -> f64 {
        let indentation = indentation.max(0.0);
        match self {
            Self::Linear => indentation,
            Self::Hertz => indentation * indentation.sqrt(),
        }
    }

    /// Energy of an indentation, in units of `K`.
    fn energy(self, indentation: f64) -> f64 {
        let share = match self {
            Self::Linear => 0.5,
            Self::Hertz => 0.4,
        };
        share * self.force(indentation) * indentation.max(0.0)
    }
}

/// Error of a step, in units of the indentation that the approach reaches (no unit, 1e-13 to 1e-9).
const STEP_ERROR: f64 = 1e-12;

/// An approach below this part of the first one is over, and a slip has stopped (no unit): above the error of the
/// steps. In space the direction of a slip turns ever faster towards its end.
const SPENT: f64 = 1e-10;

/// The same at a contact without restitution (no unit, 1e-6 to 1e-3): it would go on in ever smaller compressions,
/// which a stop without restitution has as their limit.
const END_WITHOUT_REBOUND: f64 = 1e-4;

/// Restitution below this gives nothing back (no unit): the springs that open would be `1/e^2` times as stiff.
const NO_REBOUND: f64 = 2e-2;

/// A contact that starts to slip has the direction that its loads ask for, not that of its slip, up to this part of the
/// first approach (no unit, 1e-7 to 1e-5): before, the two differ by the rounding of a slip that is hardly there.
const STARTED_SLIP: f64 = 1e-6;

/// Shortest step, in units of the time of a pulse (no unit): error control would go on below it where forces begin.
const SHORTEST_PULSE_STEP: f64 = 1e-13;

/// First step and longest one, in the same units: a pulse takes about 3.
const FIRST_PULSE_STEP: f64 = 1e-3;
const LONGEST_PULSE_STEP: f64 = 0.1;

/// By how much a step may become longer or shorter than the one before (no unit), and its margin.
const STEP_GROWTH: [f64; 2] = [0.1, 5.0];
const STEP_MARGIN: f64 = 0.9;

/// Steps for each compression that is allowed (100 to 1000): one takes 50 to 150. Light bodies that have come to rest
/// between heavy ones are followed in steps of their own time, without being compressed.
const STEPS_FOR_COMPRESSION: usize = 300;

/// Most rounds of the search for the end of a piece: bisection alone would take 50.
const SEARCH_ROUNDS: usize = 100;

/// Coefficients of the stages of Dormand and Prince, and the difference of the two answers.
const STAGES: [&[f64]; 6] = [
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
const DIFFERENCE: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];

/// Whether a spring is loaded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Load {
    Apart,
    Closing,
    Opening,
}

/// Whether a contact slips.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Slip {
    /// It has no friction.
    Free,
    /// It slips; the direction at the start of the step.
    Slips(Tangent),
    /// It sticks, or hardly slips yet.
    Held,
}

/// What a contact does in a piece.
#[derive(Debug, Clone, Copy)]
struct Mode {
    load: Load,
    slip: Slip,
}

/// The springs of all contacts, in units of the largest approach and of the largest inverse mass along a normal.
#[derive(Debug)]
pub(crate) struct Springs {
    exponent: PulseExponent,
    contacts: Vec<SpringContact>,
    /// `G` of all rows in these units, row-major.
    matrix: Vec<f64>,
    /// Velocities before over the largest approach.
    from: Vec<f64>,
    /// Unit of impulses, N s.
    impulse_unit: f64,
    /// Unit of velocities, m/s.
    approach: f64,
}

/// What the springs did.
#[derive(Debug)]
pub(crate) struct Sprung {
    /// Of all rows, N s.
    pub(crate) impulses: Vec<f64>,
    /// Works of the normal impulse and of friction of each contact, J.
    pub(crate) works: Vec<[f64; 2]>,
    /// Whether each contact has friction and does not slip at the end.
    pub(crate) sticks: Vec<bool>,
    /// Whether everything was spent.
    pub(crate) ended: bool,
}

impl Springs {
    /// Of the rows of contacts, row-major `matrix` (1/kg) with the joints held, and velocities before (m/s). None where
    /// nothing can be moved, or nothing approaches.
    pub(crate) fn of(
        mut contacts: Vec<SpringContact>,
        mut matrix: Vec<f64>,
        mut from: Vec<f64>,
        exponent: PulseExponent,
    ) -> Option<Self> {
        let rows = from.len();
        let approach = contacts.iter().fold(0.0, |most: f64, contact| most.max(-from[contact.row]));
        let largest = contacts.iter().fold(0.0, |most: f64, contact| most.max(matrix[contact.row * (rows + 1)]));
        let impulse_unit = approach / largest;
        if !(impulse_unit > 0.0 && impulse_unit.is_finite()) {
            return None;
        }
        for entry in &mut matrix {
            *entry /= largest;
        }
        for u in &mut from {
            *u /= approach;
        }
        for contact in &mut contacts {
            if contact.restitution < NO_REBOUND {
                contact.restitution = 0.0;
            }
        }
        Some(Self { exponent, contacts, matrix, from, impulse_unit, approach })
    }

    /// Lets the springs spend what they take, with this many compressions at most.
    pub(crate) fn run(&self, most_compressions: usize) -> Sprung {
        let mut walk = Walk::new(self);
        let ended = walk.go(most_compressions);
        let (count, rows) = (self.contacts.len(), self.from.len());
        let energy_unit = self.impulse_unit * self.approach;
        let work = |of: usize, contact: usize| walk.state[count * (1 + of) + rows + contact] * energy_unit;
        Sprung {
            impulses: walk.state[count..count + rows].iter().map(|p| p * self.impulse_unit).collect(),
            works: (0..count).map(|contact| [work(0, contact), work(1, contact)]).collect(),
            sticks: self.contacts.iter().map(|contact| slip_of(contact, &walk.velocities) == Slip::Held).collect(),
            ended,
        }
    }

    /// Velocities of all rows after impulses, into `velocities`.
    fn put_velocities(&self, impulses: &[f64], velocities: &mut [f64]) {
        self.put_changes(impulses, velocities);
        velocities.iter_mut().zip(&self.from).for_each(|(change, from)| *change += from);
    }

    /// `G p`, into `changes`.
    fn put_changes(&self, impulses: &[f64], changes: &mut [f64]) {
        for (line, change) in self.matrix.chunks_exact(self.from.len()).zip(changes) {
            *change = line.iter().zip(impulses).map(|(entry, p)| entry * p).sum::<f64>();
        }
    }

    /// Kinetic energy that a contact which approaches with `u` may take, in the units here.
    fn of_approach(&self, contact: &SpringContact, u: f64) -> f64 {
        let inverse_mass = self.matrix[contact.row * (self.from.len() + 1)];
        if inverse_mass > 0.0 { 0.5 * u.min(0.0) * u.min(0.0) / inverse_mass } else { 0.0 }
    }
}

/// How far the springs have come. The state: indentations, impulses of all rows, works of normals and of friction.
struct Walk<'a> {
    springs: &'a Springs,
    state: Vec<f64>,
    velocities: Vec<f64>,
    modes: Vec<Mode>,
    held: HeldSlip,
    compressions: usize,
    /// Rates of the stages of a step, their state, and its velocities: kept for their room.
    stages: Vec<Vec<f64>>,
    at_stage: (Vec<f64>, Vec<f64>),
}

/// A step that was tried.
struct Tried {
    state: Vec<f64>,
    velocities: Vec<f64>,
    error: f64,
}

impl<'a> Walk<'a> {
    fn new(springs: &'a Springs) -> Self {
        let (velocities, size) = (springs.from.clone(), 3 * springs.contacts.len() + springs.from.len());
        let apart = |contact: &SpringContact| Mode { load: Load::Apart, slip: slip_of(contact, &velocities) };
        let mut walk = Self {
            springs,
            state: vec![0.0; size],
            modes: springs.contacts.iter().map(apart).collect(),
            velocities,
            held: HeldSlip::of(springs.contacts.len()),
            compressions: 0,
            stages: vec![vec![0.0; size]; DIFFERENCE.len()],
            at_stage: (vec![0.0; size], vec![0.0; springs.from.len()]),
        };
        walk.change_modes();
        walk
    }

    /// Returns whether everything was spent.
    fn go(&mut self, most_compressions: usize) -> bool {
        let mut length = FIRST_PULSE_STEP;
        for _ in 0..most_compressions.saturating_mul(STEPS_FOR_COMPRESSION) {
            if self.is_over() {
                return true;
            }
            if self.compressions > most_compressions {
                return false;
            }
            let tried = self.step(length);
            let relative = tried.error / STEP_ERROR;
            if relative <= 1.0 || length <= SHORTEST_PULSE_STEP {
                let taken = if self.inside(&tried) < 0.0 { self.shortened(tried, length) } else { tried };
                self.state = taken.state;
                self.velocities = taken.velocities;
                self.change_modes();
            }
            let factor = if relative > 0.0 { STEP_MARGIN * libm::pow(relative, -0.2) } else { STEP_GROWTH[1] };
            let factor = if factor.is_finite() { factor.clamp(STEP_GROWTH[0], STEP_GROWTH[1]) } else { STEP_GROWTH[0] };
            length = (length * factor).clamp(SHORTEST_PULSE_STEP, LONGEST_PULSE_STEP);
        }
        false
    }

    /// Rates of the state, into `rates`; `velocities` is room.
    fn rates(&mut self, state: &[f64], velocities: &mut [f64], rates: &mut [f64]) {
        let springs = self.springs;
        let (count, rows) = (springs.contacts.len(), springs.from.len());
        springs.put_velocities(&state[count..count + rows], velocities);
        rates.fill(0.0);
        let (indentations, rest) = rates.split_at_mut(count);
        let (growth, works) = rest.split_at_mut(rows);
        let mut any_held = false;
        for (i, (contact, mode)) in springs.contacts.iter().zip(&self.modes).enumerate() {
            if mode.load == Load::Apart {
                continue;
            }
            let (u, e) = (velocities[contact.row], contact.restitution);
            indentations[i] = if mode.load == Load::Opening { -u / (e * e) } else { -u };
            let force = springs.exponent.force(state[i]);
            growth[contact.row] = force;
            let direction = match mode.slip {
                Slip::Free => continue,
                Slip::Held => {
                    any_held |= force > 0.0;
                    continue;
                }
                Slip::Slips(first) if contact.tangents == 1 => first,
                Slip::Slips(first) => plane::direction(contact.slip(velocities)).unwrap_or(first),
            };
            for k in 0..contact.tangents {
                growth[contact.row + 1 + k] = -contact.friction * force * direction[k];
            }
        }
        if any_held {
            let held = |i: usize| self.modes[i].slip == Slip::Held;
            self.held.solve(&springs.contacts, held, &springs.matrix, growth);
        }
        for (i, contact) in springs.contacts.iter().enumerate() {
            works[i] = growth[contact.row] * velocities[contact.row];
            let along = (1..=contact.tangents).map(|k| growth[contact.row + k] * velocities[contact.row + k]);
            works[count + i] = along.sum();
        }
    }

    /// One step of a length.
    fn step(&mut self, length: f64) -> Tried {
        let mut rates = std::mem::take(&mut self.stages);
        let (mut next, mut velocities) = std::mem::take(&mut self.at_stage);
        next.copy_from_slice(&self.state);
        self.rates(&next, &mut velocities, &mut rates[0]);
        for (stage, weights) in STAGES.iter().enumerate() {
            for (i, to) in next.iter_mut().enumerate() {
                let sum: f64 = weights.iter().zip(&rates).map(|(weight, rate)| weight * rate[i]).sum();
                *to = self.state[i] + length * sum;
            }
            self.rates(&next, &mut velocities, &mut rates[stage + 1]);
        }
        let (count, rows) = (self.springs.contacts.len(), self.springs.from.len());
        let error = |i: usize| DIFFERENCE.iter().zip(&rates).map(|(weight, rate)| weight * rate[i]).sum::<f64>();
        let worst = (0..count + rows).map(|i| (length * error(i)).abs()).fold(0.0, f64::max);
        self.stages = rates;
        // The last stage is at the end of the step.
        self.at_stage = (next.clone(), velocities.clone());
        Tried { state: next, velocities, error: worst }
    }

    /// How far all contacts are within their modes: negative where one is beyond.
    fn inside(&self, tried: &Tried) -> f64 {
        let contacts = self.springs.contacts.iter().zip(&self.modes).enumerate();
        let within = |(i, (contact, mode)): (usize, (&SpringContact, &Mode))| {
            let u = tried.velocities[contact.row];
            let load = match mode.load {
                Load::Apart => return u + spent(contact),
                Load::Closing => -u,
                Load::Opening => u.min(tried.state[i]),
            };
            let slip = contact.slip(&tried.velocities);
            load.min(match mode.slip {
                Slip::Free => f64::INFINITY,
                Slip::Held => STARTED_SLIP - plane::length(slip),
                Slip::Slips(first) if contact.tangents == 1 => plane::dot(slip, first),
                Slip::Slips(first) => plane::dot(slip, first).min(plane::length(slip) - SPENT),
            })
        };
        contacts.map(within).fold(f64::INFINITY, f64::min)
    }

    /// The step to where the first contact leaves its mode, within one of a length that goes beyond.
    fn shortened(&mut self, beyond: Tried, length: f64) -> Tried {
        let start = Tried { state: self.state.clone(), velocities: self.velocities.clone(), error: 0.0 };
        let (mut low, mut high) = ((0.0, self.inside(&start).max(0.0)), (length, self.inside(&beyond)));
        let mut taken = beyond;
        for round in 0..SEARCH_ROUNDS {
            if high.0 - low.0 <= LEAST_CHANGE * length {
                break;
            }
            let secant = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
            let between = secant > low.0 && secant < high.0 && round % 3 != 2;
            let middle = if between { secant } else { 0.5 * (low.0 + high.0) };
            if middle <= low.0 || middle >= high.0 {
                break;
            }
            let tried = self.step(middle);
            let inside = self.inside(&tried);
            if inside < 0.0 {
                (high, taken) = ((middle, inside), tried);
            } else {
                low = (middle, inside);
            }
        }
        taken
    }

    /// Changes the modes of contacts that have left theirs.
    fn change_modes(&mut self) {
        for (i, contact) in self.springs.contacts.iter().enumerate() {
            let (u, mode) = (self.velocities[contact.row], &mut self.modes[i]);
            mode.load = match mode.load {
                Load::Closing if u > 0.0 && contact.restitution > 0.0 => Load::Opening,
                Load::Closing if u > 0.0 => Load::Apart,
                Load::Opening if self.state[i] <= 0.0 => Load::Apart,
                Load::Opening if u < 0.0 => {
                    self.compressions += 1;
                    Load::Closing
                }
                other => other,
            };
            if mode.load == Load::Apart {
                self.state[i] = 0.0;
                if u < -spent(contact) {
                    *mode = Mode { load: Load::Closing, slip: slip_of(contact, &self.velocities) };
                    self.compressions += 1;
                }
                continue;
            }
            let slip = contact.slip(&self.velocities);
            let speed = plane::length(slip);
            mode.slip = match mode.slip {
                Slip::Slips(first) if contact.tangents == 1 && plane::dot(slip, first) <= 0.0 => Slip::Held,
                Slip::Slips(_) if contact.tangents > 1 && speed <= SPENT => Slip::Held,
                Slip::Held if speed < STARTED_SLIP && !(speed > 2.0 * SPENT && self.held.sticks(i)) => Slip::Held,
                Slip::Free => Slip::Free,
                Slip::Slips(_) | Slip::Held => plane::direction(slip).map_or(Slip::Held, Slip::Slips),
            };
        }
    }

    /// Whether nothing more can happen.
    fn is_over(&mut self) -> bool {
        let springs = self.springs;
        let loaded = |mode: &&Mode| mode.load != Load::Apart;
        if self.modes.iter().all(|mode| mode.load == Load::Apart) {
            return true;
        }
        let at_stake = springs.contacts.iter().zip(&self.modes).enumerate().map(|(i, (contact, mode))| {
            let given_back = if mode.load == Load::Opening { contact.restitution * contact.restitution } else { 1.0 };
            given_back * springs.exponent.energy(self.state[i])
                + springs.of_approach(contact, self.velocities[contact.row])
        });
        if at_stake.sum::<f64>() <= SPENT * SPENT {
            return true;
        }
        let speeds = springs.contacts.iter().zip(&self.modes).filter(|(_, mode)| loaded(mode));
        let fastest = speeds.map(|(contact, _)| self.velocities[contact.row].abs()).fold(0.0, f64::max);
        fastest <= SPENT && self.forces_hold_each_other()
    }

    /// Whether the forces of the springs move no loaded contact.
    fn forces_hold_each_other(&mut self) -> bool {
        let springs = self.springs;
        let (count, rows) = (springs.contacts.len(), springs.from.len());
        let (state, mut rates, mut changes) = (self.state.clone(), vec![0.0; self.state.len()], vec![0.0; rows]);
        self.rates(&state, &mut changes, &mut rates);
        springs.put_changes(&rates[count..count + rows], &mut changes);
        let own = |contact: &SpringContact| springs.matrix[contact.row * (rows + 1)] * rates[count + contact.row];
        let largest = springs.contacts.iter().map(own).fold(0.0, f64::max);
        let loaded = springs.contacts.iter().zip(&self.modes).filter(|(_, mode)| mode.load != Load::Apart);
        largest > 0.0 && loaded.map(|(contact, _)| changes[contact.row].abs()).fold(0.0, f64::max) <= SPENT * largest
    }
}

/// Whether a contact with these velocities of all rows slips.
fn slip_of(contact: &SpringContact, velocities: &[f64]) -> Slip {
    if !contact.has_friction() {
        return Slip::Free;
    }
    let slip = contact.slip(velocities);
    let slips = plane::length(slip) > SPENT;
    if slips { plane::direction(slip).map_or(Slip::Held, Slip::Slips) } else { Slip::Held }
}

/// An approach of a contact that is over, in units of the first one.
fn spent(contact: &SpringContact) -> f64 {
    if contact.restitution > 0.0 { SPENT } else { END_WITHOUT_REBOUND }
}

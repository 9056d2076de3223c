//! What a time step did.

use crate::accounting::books::Books;
use crate::collision::contact_set::ContactId;
use polhode_contact::ContactGeometry;
use polhode_spatial::DVec3;

/// What kind of impulse a contact gave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum ImpulseKind {
    /// Of an impact: bodies approached faster than a contact that lasts.
    Impact {
        /// Change of kinetic energy, J.
        energy_change_j: f64,
    },
    /// Of the forces of a contact that lasts, over the whole step.
    Sustained,
}

/// The impulse of one contact in a step. Only sums of impulses on a body, and the motion, are unique.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactImpulse {
    /// When, s.
    pub(crate) t: f64,
    pub(crate) id: ContactId,
    /// Where, when the impulse acted; its separation among the rest.
    pub(crate) geometry: ContactGeometry,
    /// On A along the normal, N s.
    pub(crate) impulse: f64,
    pub(crate) kind: ImpulseKind,
}

/// What one or more steps of some bodies did.
#[derive(Debug, Clone)]
pub(crate) struct TimeStepReport {
    /// All impulses that are not zero, in order of time.
    pub(crate) impulses: Vec<ContactImpulse>,
    /// Energy and momentum by account: to be entered in the books of the run ([`Books::enter`]).
    pub(crate) books: Books,
    /// Pairs in contact at the end, ascending: they carry an impulse, or lie on each other at rest.
    pub(crate) touching: Vec<(usize, usize)>,
    /// Largest overlap before it was moved out, m.
    pub(crate) max_penetration_m: f64,
    /// Largest overlap that was left, m.
    pub(crate) left_penetration_m: f64,
    /// Largest displacement of a body by moving overlap out, m.
    pub(crate) max_projection_m: f64,
    /// Largest residual of the problems solved (natural map, relative).
    pub(crate) residual: f64,
    /// How often something was approximated: an answer of a fallback solver, a law that was given up.
    pub(crate) fallbacks: u64,
    /// Contacts that took part in the problems, the most of any step.
    pub(crate) contacts: usize,
    /// Steps made.
    pub(crate) steps: u64,
    /// Whether every body stands exactly where it stood, at zero velocity.
    pub(crate) at_rest: bool,
}

impl TimeStepReport {
    /// Nothing done yet; moments about a point (m).
    pub(crate) fn new(about: DVec3) -> Self {
        Self {
            impulses: Vec::new(),
            books: Books::blank(about),
            touching: Vec::new(),
            max_penetration_m: 0.0,
            left_penetration_m: 0.0,
            max_projection_m: 0.0,
            residual: 0.0,
            fallbacks: 0,
            contacts: 0,
            steps: 0,
            at_rest: false,
        }
    }

    /// Adds what a later step did.
    pub(crate) fn append(&mut self, later: Self) {
        self.at_rest = later.at_rest && (self.steps == 0 || self.at_rest);
        self.impulses.extend(later.impulses);
        self.books.enter(&later.books);
        self.touching = later.touching;
        self.max_penetration_m = self.max_penetration_m.max(later.max_penetration_m);
        self.left_penetration_m = later.left_penetration_m;
        self.max_projection_m = self.max_projection_m.max(later.max_projection_m);
        self.residual = self.residual.max(later.residual);
        self.fallbacks += later.fallbacks;
        self.contacts = self.contacts.max(later.contacts);
        self.steps += later.steps;
    }
}

//! Report of a time step.

use crate::accounting::books::Books;
use crate::accounting::told_loads::ToldLoads;
use crate::identity::contact_id::ContactId;
use crate::solve::cone_violation::ConeViolation;
use polhode_contact::ContactGeometry;
use polhode_spatial::DVec3;

/// Kind of a contact impulse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum ImpulseKind {
    /// Of an impact: bodies approached faster than in a sustained contact.
    Impact {
        /// Change of kinetic energy, J.
        energy_change_j: f64,
    },
    /// Of the forces of a sustained contact, over the whole step.
    Sustained,
}

/// The impulse of one contact in a step. Only sums of impulses on a body, and the motion, are unique.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactImpulse {
    /// When, s.
    pub(crate) t: f64,
    pub(crate) id: ContactId,
    /// Contact geometry when the impulse acted, including the separation.
    pub(crate) geometry: ContactGeometry,
    /// On A along the normal, N s.
    pub(crate) impulse: f64,
    /// On A in the tangent plane, world, N s, of friction.
    pub(crate) friction: DVec3,
    pub(crate) kind: ImpulseKind,
}

/// Report of one or more steps of some bodies.
#[derive(Debug, Clone)]
pub(crate) struct TimeStepReport {
    /// All impulses that are not zero, in order of time.
    pub(crate) impulses: Vec<ContactImpulse>,
    /// Energy and momentum by account: to be entered in the books of the run ([`Books::enter`]).
    pub(crate) books: Books,
    /// Pairs in contact at the end, ascending: those with an impulse, or at rest on each other.
    pub(crate) touching: Vec<(usize, usize)>,
    /// Largest penetration before its removal, m.
    pub(crate) max_penetration_m: f64,
    /// The contact of that penetration; none when none penetrated.
    pub(crate) deepest: Option<ContactId>,
    /// Largest penetration after its removal, m.
    pub(crate) left_penetration_m: f64,
    /// Largest displacement of a body by the removal of penetration, m.
    pub(crate) max_projection_m: f64,
    /// Largest residual of the problems solved (natural map, relative).
    pub(crate) residual: f64,
    /// How far forces and impulses are from Coulomb's law, the largest of any step.
    pub(crate) cone_violation: Option<ConeViolation>,
    /// Number of approximations: removals of overlaps that a fallback solved, impact laws that did not finish.
    pub(crate) fallbacks: u64,
    /// Factorisations in the velocities of bodies (`polhode_response::solve::step`).
    pub(crate) factorisations: u64,
    /// Whether a law of restitution has raised the energy of an impact.
    pub(crate) raises_energy: bool,
    /// Number of contacts in the problems, the largest of any step.
    pub(crate) contacts: usize,
    /// What joints have been given.
    pub(crate) told: ToldLoads,
    /// How far what is told of forces is from Newton's law, the largest of any body and step (no unit;
    /// `told_loads.rs`).
    pub(crate) newton_residual: f64,
    /// Steps made.
    pub(crate) steps: u64,
    /// Whether every body is exactly at its initial pose, at zero velocity.
    pub(crate) at_rest: bool,
    /// Contacts whose slip passes through zero within the step, so that it must be made in two parts.
    pub(crate) stops: Vec<Stop>,
}

/// A contact that comes to rest within a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stop {
    pub(crate) id: ContactId,
    /// When, as a part of the step (0 to 1).
    pub(crate) part: f64,
}

impl TimeStepReport {
    /// An empty report; moments about a point (m).
    pub(crate) fn new(about: DVec3) -> Self {
        Self {
            impulses: Vec::new(),
            books: Books::blank(about),
            touching: Vec::new(),
            max_penetration_m: 0.0,
            deepest: None,
            stops: Vec::new(),
            left_penetration_m: 0.0,
            max_projection_m: 0.0,
            residual: 0.0,
            cone_violation: None,
            fallbacks: 0,
            factorisations: 0,
            raises_energy: false,
            contacts: 0,
            told: ToldLoads::default(),
            newton_residual: 0.0,
            steps: 0,
            at_rest: false,
        }
    }

    /// Adds the report of a later step.
    pub(crate) fn append(&mut self, later: Self) {
        self.at_rest = later.at_rest && (self.steps == 0 || self.at_rest);
        self.impulses.extend(later.impulses);
        self.books.enter(&later.books);
        self.touching = later.touching;
        if later.max_penetration_m > self.max_penetration_m {
            (self.max_penetration_m, self.deepest) = (later.max_penetration_m, later.deepest);
        }
        self.left_penetration_m = later.left_penetration_m;
        self.max_projection_m = self.max_projection_m.max(later.max_projection_m);
        self.residual = self.residual.max(later.residual);
        self.cone_violation = ConeViolation::larger(self.cone_violation, later.cone_violation);
        self.fallbacks += later.fallbacks;
        self.factorisations += later.factorisations;
        self.raises_energy |= later.raises_energy;
        self.contacts = self.contacts.max(later.contacts);
        self.told.append(later.told);
        self.newton_residual = self.newton_residual.max(later.newton_residual);
        self.steps += later.steps;
    }
}

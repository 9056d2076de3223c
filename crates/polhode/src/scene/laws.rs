//! The choices of a method: laws of impacts, of contact forces and of bodies that touch, integrators, broad phases.
//!
//! What a tier is (`crate::tier`) is said in these words, so that they stand below both tiers and methods.

pub use polhode_contact::BroadPhaseMethod;
pub use polhode_dynamics::integrator::{Method as Integrator, Orientation, RotationRate};

/// The coordinates in which bodies that joints hold are integrated in the tier `accurate`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Coordinates {
    /// Position and attitude of each body; reactions hold joints.
    #[default]
    Maximal,
    /// The coordinates of the joints, of trees of ball joints, hinges and sliders.
    Reduced,
}

impl Coordinates {
    /// The name in scenes.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Maximal => "maximal",
            Self::Reduced => "reduced",
        }
    }
}

/// The law that determines the impulses of an impact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ImpactLaw {
    /// One contact after the other until none approaches (thesis 3.3).
    Propagation,
    /// All contacts at once after Newton and Moreau (thesis 3.4, end).
    Simultaneous,
    /// Generalised reflection after Smith et al.: it keeps the symmetry of a scene, and momentum passes through chains
    /// of bodies.
    Reflection,
}

impl ImpactLaw {
    /// The name used in scenes and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Propagation => "propagation",
            Self::Simultaneous => "simultaneous",
            Self::Reflection => "reflection",
        }
    }
}

/// How the forces of resting contacts are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ContactMethod {
    /// The thesis's linear programme of least total force, with its guesses of which contacts open and bear no force.
    LeastForce,
    /// The exact complementarity problem by the active set.
    ActiveSet,
}

impl ContactMethod {
    /// The name used in scenes and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::LeastForce => "least-force",
            Self::ActiveSet => "active-set",
        }
    }
}

/// How bodies that touch act on each other. The members by impulses are models that the thesis tries first (section 3.3) and
/// rejects: they are wrong, each in its own way, and only the tier `thesis` has them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Response {
    /// By forces that keep contacts from closing, and by impulses where bodies approach.
    #[default]
    Constraint,
    /// By impulses alone, where bodies approach. Between two steps a resting body falls freely: it sinks.
    Impulse,
    /// By impulses where bodies approach, after which bodies that overlap are moved apart. Lifting a body gives it
    /// energy: it never comes to rest.
    ImpulseProjection,
    /// By impulses at every contact that overlaps, whether the bodies approach or separate. An impulse at a contact
    /// that separates pulls: bodies stay caught in each other.
    ImpulseUnconditional,
    /// By springs and dampers where bodies overlap: the tier `penalty` has them.
    Penalty,
}

impl Response {
    /// The name used in scenes and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Constraint => "constraint",
            Self::Impulse => "impulse",
            Self::ImpulseProjection => "impulse-projection",
            Self::ImpulseUnconditional => "impulse-unconditional",
            Self::Penalty => "penalty",
        }
    }
}

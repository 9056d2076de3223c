//! The choices of a method: laws of impacts, of contact forces and of bodies that touch, integrators, broad phases.
//!
//! What a tier is (`crate::tier`) is said in these words, so that they stand below both tiers and methods.

pub use polhode_contact::BroadPhaseMethod;
pub use polhode_dynamics::integrator::{Method as Integrator, Orientation, RotationRate};
pub use polhode_response::impact::PulseExponent;
use polhode_response::{MultipleImpactLaw, RestitutionLaw, impact};

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
    /// A compression and an expansion of all contacts (Poisson; Glocker and Pfeiffer).
    Poisson,
    /// Each contact gives back a part of the work that it took (Stronge).
    Energetic,
    /// The contacts as springs that spend their energy (Liu, Zhao and Brogliato); without friction.
    Pulse,
}

impl ImpactLaw {
    /// All laws.
    pub const ALL: [Self; 6] =
        [Self::Reflection, Self::Propagation, Self::Simultaneous, Self::Poisson, Self::Energetic, Self::Pulse];

    /// The name used in scenes and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Propagation => "propagation",
            Self::Simultaneous => "simultaneous",
            Self::Reflection => "reflection",
            Self::Poisson => "poisson",
            Self::Energetic => "energetic",
            Self::Pulse => "pulse",
        }
    }

    /// What it says of rows without friction; the exponent is that of the springs of [`ImpactLaw::Pulse`].
    pub const fn of_rows(self, exponent: PulseExponent) -> impact::ImpactLaw {
        match self {
            Self::Propagation => impact::ImpactLaw::Propagation,
            Self::Simultaneous => impact::ImpactLaw::Simultaneous,
            Self::Reflection => impact::ImpactLaw::Reflection,
            Self::Poisson => impact::ImpactLaw::Poisson,
            Self::Energetic => impact::ImpactLaw::Energetic,
            Self::Pulse => impact::ImpactLaw::Pulse(exponent),
        }
    }

    /// How contacts with friction share an impact by it.
    pub const fn of_contacts_with_friction(self, exponent: PulseExponent) -> MultipleImpactLaw {
        match self {
            Self::Propagation => MultipleImpactLaw::Sequence,
            Self::Pulse => MultipleImpactLaw::Pulse(exponent),
            _ => MultipleImpactLaw::Simultaneous,
        }
    }

    /// The law of a contact with friction that is struck alone, where none is chosen.
    pub const fn of_single_contact(self) -> RestitutionLaw {
        if matches!(self, Self::Poisson) { RestitutionLaw::Poisson } else { RestitutionLaw::Stronge }
    }
}

/// Which of several contacts that approach [`ImpactLaw::Propagation`] strikes first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum PropagationOrder {
    /// The first by the numbers of its bodies and of its features.
    #[default]
    Key,
    /// The one that overlaps most, or is least far apart.
    Depth,
    /// In an order drawn anew for each impact, from this seed and the velocities before.
    Random {
        /// The seed.
        seed: u64,
    },
}

impl PropagationOrder {
    /// The name used in scenes and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Key => "key",
            Self::Depth => "depth",
            Self::Random { .. } => "random",
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
    /// The thesis's heuristic of section 3.4 in its three stages, each told: no contact vanishes; those that the forces
    /// of least sum open do; those forces themselves.
    Heuristic,
    /// The guesses of section 3.4: which contacts vanish is tried, one set after the other, until forces fit.
    Guesses,
    /// One contact after the other, with impulses of the step before to begin with.
    SequentialImpulses,
    /// The same, with steps of nonsmooth nonlinear conjugate gradients between several sweeps.
    ConjugateGradients,
}

impl ContactMethod {
    /// The name used in scenes and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::LeastForce => "least-force",
            Self::ActiveSet => "active-set",
            Self::Heuristic => "heuristic",
            Self::Guesses => "guesses",
            Self::SequentialImpulses => "sequential-impulses",
            Self::ConjugateGradients => "nncg",
        }
    }
}

/// How bodies that touch act on each other. The members by impulses are models that the thesis tries first (section
/// 3.3) and rejects: they are wrong, each in its own way, and the tier `thesis` has them. Without a tier
/// [`Response::Impulse`] asks for the tier `micro-collisions`, in which it holds bodies up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Response {
    /// By forces that keep contacts from closing, and by impulses where bodies approach.
    #[default]
    Constraint,
    /// By impulses alone, where bodies approach. In the tier `thesis` a resting body falls freely between two steps: it
    /// sinks.
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

    /// Whether it is one of the models by impulses that the thesis tries first.
    pub(crate) const fn is_by_impulses(self) -> bool {
        matches!(self, Self::Impulse | Self::ImpulseProjection | Self::ImpulseUnconditional)
    }
}

//! Impacts with friction.
//!
//! The impulse `p = (p_n, p_t)` of a contact is in Coulomb's cone, `|p_t| <= mu p_n`, and opposes the slip `u_t`. In
//! the short time of an impact the slip may turn, stop and reverse, so that a law on the velocities before and after is
//! not enough: the velocity is followed as the normal impulse grows (Routh 1905; Keller 1986), and with friction the
//! three measures of restitution (Newton, Poisson, Stronge) differ. Newton's may raise the energy, Stronge's never
//! does, which is why it is the default here.
//!
//! | module | holds |
//! |---|---|
//! | `law` | [`RestitutionLaw`]: Stronge, Poisson, Newton, Whittaker, Chatterjee and Ruina |
//! | `single` | [`SingleFrictionalImpact`]: an impact at one contact |
//! | `outcome`, `phase` | [`FrictionalImpact`]: what it did; slip, stick, reversal, jam |
//! | `multiple` | [`MultipleFrictionalImpact`]: an impact at several contacts |
//! | `multiple_outcome` | [`MultipleImpact`]: what it did |
//! | `simultaneous`, `sequence`, `pulse` | struck together, one at a time, as springs ([`MultipleImpactLaw`]) |
//! | `springs`, `spring_contact`, `held_slip` | contacts as springs with friction, and which of them stick |
//! | `reversal` | micro-collisions of contacts that stick reverse the slip too (Mirtich) |
//! | `reactions` | what unit impulses at a contact do with joints held |
//! | `without_collision` | impacts of contacts that jam, at one or several |
//! | `part` | contacts that move each other, and their cone problems |
//! | `sliding` | [`SlidingContact`]: whether a contact that slides has a finite force (Painleve) |
//! | `collision_matrix` | [`CollisionMatrix`]: velocity by impulse at a contact |
//! | `coulomb` | Coulomb's law as rates in the normal impulse |
//! | `path` | the path of an impact through its phases |
//! | `straight`, `turning` | its pieces: in closed form, and as Taylor series where slip turns |
//! | `restitution` | compression and restitution: where an impact ends |
//! | `algebraic` | Whittaker's law, Chatterjee and Ruina's |
//! | `plane`, `root` | vectors of the tangent plane; zeros of functions |

mod algebraic;
mod collision_matrix;
mod coulomb;
mod held_slip;
mod law;
mod multiple;
mod multiple_outcome;
mod outcome;
mod part;
mod path;
mod phase;
mod plane;
pub(crate) mod pulse;
mod reactions;
mod restitution;
pub(crate) mod reversal;
mod root;
mod sequence;
mod simultaneous;
mod single;
mod sliding;
pub(crate) mod spring_contact;
pub(crate) mod springs;
mod straight;
mod turning;
mod without_collision;

pub use collision_matrix::CollisionMatrix;
pub use law::{MultipleImpactLaw, RestitutionLaw};
pub use multiple::{MultipleFrictionalImpact, MultipleImpactSettings};
pub use multiple_outcome::MultipleImpact;
pub use outcome::{FrictionalImpact, FrictionalImpactStatus};
pub use phase::{ImpactPhase, PhaseKind};
pub use single::SingleFrictionalImpact;
pub use sliding::{SlidingContact, SlidingForce};
pub use springs::PulseExponent;

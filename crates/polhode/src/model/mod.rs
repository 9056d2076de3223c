//! The scene as the engine sees it: bodies in their moving frames, and the forces on them.
//!
//! | module | holds |
//! |---|---|
//! | `bodies` | `Model`: all bodies and the scene they come from; bodies added and removed |
//! | `body` | `ModelBody`: one body in its moving frame |
//! | `carriages` | kinematic bodies that carry prescribed motions of joints |
//! | `joints` | `Joints`: what holds bodies together, and whom |
//! | `surfaces` | `Surfaces`: whether bodies collide, and what friction does |
//! | `fields` | `Forces`: the force fields over the movable bodies |
//! | `forces` | force fields, and the forces that a program applies |
//! | `field_index` | which fields act on which bodies |
//! | `energy` | energies, and the centre of mass at the start |
//! | `rates` | how fast fields and rotations change the motion |
//! | `tolerances` | the distances that count as touch, overlap and rounding |
//! | `steered`, `steering` | motions that a program has given kinematic bodies |
//! | `prescribed`, `prescribed_state` | states of kinematic bodies as functions of time |
//! | `pivot_form` | how a body is held at its pivot |
//! | `plane_of_motion` | the plane of a planar motion |
//! | `states_of` | the states of some bodies among those of all |
//! | `body_queries` | [`BodyQueries`](crate::BodyQueries): nearest body, rays, overlaps, distances |
//! | `work` | what a run has computed, counted |
//! | `narrow_phase` | contacts and separation of a pair of shapes, computed with the memory of the pair |
//! | `envelope` | the distance from a body within which contacts are looked for |
//! | `concerned` | the names of the bodies that an error concerns |
//! | `reported` | bodies as samples and reports show them |

mod bodies;
mod body;
pub(crate) mod body_queries;
mod carriages;
mod concerned;
mod energy;
pub(crate) mod envelope;
mod field_index;
mod fields;
mod forces;
mod joints;
pub(crate) mod narrow_phase;
pub(crate) mod pivot_form;
pub(crate) mod plane_of_motion;
pub(crate) mod prescribed;
pub(crate) mod prescribed_state;
pub(crate) mod rates;
pub(crate) mod reported;
pub(crate) mod states_of;
pub(crate) mod steered;
mod steering;
mod surfaces;
pub(crate) mod tolerances;
pub(crate) mod work;

pub(crate) use bodies::Model;
pub(crate) use body::ModelBody;
pub(crate) use fields::Forces;
pub(crate) use forces::Loads;
pub(crate) use joints::Joints;
pub(crate) use rates::{Rates, largest_eigenvalue};
pub(crate) use tolerances::{INITIAL_OVERLAP_RELATIVE, TOUCH_RELATIVE};

/// Threads may share a model.
const _: () = {
    const fn is_shared<T: Send + Sync>() {}
    is_shared::<Model>();
};

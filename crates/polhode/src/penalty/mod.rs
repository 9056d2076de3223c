//! The tier `penalty`: springs and dampers where bodies overlap (thesis 3.1, "Penalty Methods").
//!
//! Bodies interpenetrate, and a contact pushes with a force that grows with the overlap; friction is a second spring in
//! the tangent plane. Nothing is solved for. Stiffness follows from a stated penetration, weights and speeds or from
//! elastic moduli, damping from restitution, so that nothing is tuned (`laws`).
//!
//! Bodies that may meet within a longest step form a group, which DOP853 integrates under error control with the set of
//! its springs frozen; a step ends where a contact begins, ends, turns, sticks or slides (`stepping`). An integrator of
//! fixed steps that the scene names is used literally (`fixed`).
//!
//! The ledger: elastic energy of springs is potential energy, dampers are booked as damping, slip and micro-slip as
//! friction. What a contact holds when its features change under load is booked as the error of the integrator.
//!
//! | module | holds |
//! |---|---|
//! | `facts` | what the tier is |
//! | `expected` | weights and blows that a contact must be expected to bear |
//! | `laws` | springs of a pair from materials, weights and speeds |
//! | `contact` | one contact: its springs, its mode, its force in a state |
//! | `system` | the equations of motion of a group with its springs |
//! | `events` | where a step has to end |
//! | `change_modes` | contacts that begin, end, stick, slide |
//! | `run` | a group on its way: contacts, booking, measures |
//! | `stepping` | a group over a longest step under error control |
//! | `fixed` | the same by fixed steps |
//! | `implicit` | the implicit midpoint rule of these |
//! | `groups` | which bodies may meet |
//! | `measures` | penetration, restitution and stiffness asked and reached |
//! | `engine` | a run, and queries at the present |
//! | `saved` | springs as plain data |

mod change_modes;
mod contact;
mod engine;
mod events;
mod expected;
pub(crate) mod facts;
mod fixed;
mod groups;
mod implicit;
mod laws;
pub(crate) mod measures;
mod run;
mod saved;
mod stepping;
mod system;

pub(crate) use engine::PenaltyEngine;

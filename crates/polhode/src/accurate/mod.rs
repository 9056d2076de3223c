//! The tier `accurate`.
//!
//! Bodies in flight follow their flight records in closed form. Bodies with held contacts are integrated by DOP853 with
//! the contact forces solved for at every stage, under error control, or by the classical method of order 4 at a fixed
//! step. Time advances from event to event: an impact (a pair closes), or a change of contacts (a force reaches zero, a
//! corner passes an edge). Each is located, and everything that happens at that instant to the affected bodies is
//! resolved before they continue. For all other bodies, steps, contacts and located impacts remain valid.
//!
//! | module | holds |
//! |---|---|
//! | `facts` | what the tier is: its name, defaults, promise, and what it takes |
//! | `tier` | the event loop, and queries at the present |
//! | `engine` | the bodies, and how each moves |
//! | `agenda` | times of what is due: ends of steps, impacts, renewals of boxes |
//! | `island` | bodies that move together, and their present step |
//! | `constrained_step`, `constrained_stepping`, `stage_method` | held contacts: a step by DOP853 or RK4 on `system` |
//! | `held_forces` | forces of contacts and bilateral constraints at a stage of a step |
//! | `free_stepping` | a step by the integrator of free motion: that of the scene or of the plan |
//! | `locate`, `penetration` | location of contact changes: how long the active set is valid |
//! | `state_cache` | the states of all bodies at the last observation |
//! | `present_crowds` | states of crowded bodies that a program reads one by one |
//! | `near_pairs`, `impact_search` | pairs that may meet, and their impacts |
//! | `instant`, `events` | an event, the affected bodies, and their motion afterwards |
//! | `resolve`, `hold` | resolution of an instant, and the active contacts |
//! | `lifting`, `ending_bounces`, `ending_slips` | bodies that pass onto a higher face; ends of tiny bounces, slips |
//! | `jam`, `turning` | impacts without a collision; rotations that friction of rolling and spinning holds |
//! | `joint_breaks` | when joints break |
//! | `contact_change` | what changes at the contacts of an island at the end of its active set |
//! | `contacts` | the touching contacts at their last evaluation |
//! | `load_views` | forces of pivots, forces and moments of joints, for programs |
//! | `pace` | whether time advances: stalls and crowded events |
//! | `crowding`, `crowd_parts`, `crowd_step` | time steps through stretches of crowded events |
//! | `start` | the first instant |
//! | `program` | changes that a program makes between two steps |
//! | `present` | the state of a body and the contacts that touch, at the present |
//! | `projection` | projection of held contacts onto zero separation |
//! | `saved` | conversion of a run to plain data and back |
//! | `motions` | the states of all bodies, and how each moves until the next event |
//! | `schedule` | what is due, and between whom |
//! | `step_search` | the first time within a step at which its active set ceases to be valid |
//! | `reduced_step` | a step of an island in reduced coordinates |
//! | `sampled_poses` | poses of samples within steps |
//! | `flat_positions` | closed loops whose bars come to lie in one line: steps that pass there |
//! | `motor_bounds` | where a motor reaches its bound or leaves it |
//! | `track_ends` | bodies that run off the ends of their tracks |

mod agenda;
mod constrained_step;
mod constrained_stepping;
mod contact_change;
mod contacts;
mod crowd_parts;
mod crowd_step;
mod crowding;
mod ending_bounces;
mod ending_slips;
mod engine;
mod events;
pub(crate) mod facts;
mod flat_positions;
mod free_stepping;
mod held_forces;
mod hold;
mod impact_search;
mod instant;
mod island;
mod jam;
mod joint_breaks;
mod lifting;
mod load_views;
mod locate;
mod motions;
mod motor_bounds;
mod near_pairs;
mod pace;
mod penetration;
mod present;
mod present_crowds;
mod program;
mod projection;
mod reduced_step;
mod resolve;
mod sampled_poses;
mod saved;
mod schedule;
mod stage_method;
mod start;
mod state_cache;
mod step_search;
mod system;
mod tier;
mod track_ends;
mod turning;

pub(crate) use engine::Engine;

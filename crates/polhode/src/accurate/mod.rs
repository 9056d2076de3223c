//! The tier `accurate`.
//!
//! Bodies in flight follow their flight records in closed form. Bodies with held contacts are integrated by DOP853
//! with the contact forces solved for at every stage, under error control, or by the classical method of order 4 at a
//! fixed step. Time advances from event to event: an impact (a pair closes), or a change of contacts (a force reaches
//! zero, a corner passes an edge). Each is located, and everything that happens at that instant to the bodies it concerns
//! is resolved before they go on. Bodies that it does not concern are left alone: their steps, their contacts and the
//! impacts found for them stay.
//!
//! | module | holds |
//! |---|---|
//! | `tier` | the loop over what is due, and what is asked of the bodies at the present |
//! | `engine` | the bodies, and how each moves |
//! | `agenda` | what is due when |
//! | `island` | bodies that move together, and their present step |
//! | `constrained_step`, `constrained_stepping`, `stage_method` | a step with held contacts, and how it is made: by DOP853 or RK4 over `system` |
//! | `free_stepping` | a step by the integrator that the scene asks for |
//! | `locate`, `penetration` | when held contacts cease to be the right ones |
//! | `looked` | the states of all bodies when they were last looked at |
//! | `near_pairs`, `impact_search` | pairs that may meet, and their impacts |
//! | `instant`, `events` | an event, whom it concerns, and how they go on |
//! | `resolve`, `hold` | what happens at an instant, and which contacts hold |
//! | `contacts` | the contacts that touched when their bodies were last looked at |
//! | `pivot_views` | what pivots bear at the present |
//! | `pace` | whether time advances |
//! | `crowding`, `crowd_step` | stretches of time in which events crowd, passed by time steps |
//! | `start` | the first instant |
//! | `program` | what a program does to bodies between two steps |
//! | `present` | the state of a body and the contacts that touch, at the present |
//! | `together` | held contacts are put exactly together |
//! | `saved` | what a run goes on from, as plain data and back |

mod agenda;
mod constrained_step;
mod constrained_stepping;
mod contacts;
mod crowd_step;
mod crowding;
mod engine;
mod events;
mod free_stepping;
mod hold;
mod impact_search;
mod instant;
mod island;
mod locate;
mod looked;
mod near_pairs;
mod pace;
mod penetration;
mod pivot_views;
mod present;
mod program;
mod resolve;
mod saved;
mod stage_method;
mod start;
mod system;
mod tier;
mod together;

pub(crate) use engine::Engine;

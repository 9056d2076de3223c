//! Random mechanisms and small piles, each made from a seed: joints of all kinds, closed loops, limits, motors,
//! springs, dry friction, gears, prescribed motions, tracks, contacts, belts and bodies of prescribed motion, over
//! short pieces.
//!
//! They are given to several tiers, which must agree (`xtask/polhode-oracles/src/judge/tiers.rs`,
//! `xtask/polhode-cases/src/cases/tiers_agree`). `cargo xtask judge --tiers --write SEED FILE.toml` writes one as a
//! scene file. Bodies are small numbers of bars without a shape, with the inertia of masses at random places, at random
//! attitudes; in piles they are boxes and balls. The start of what joints hold is made consistent by the projection of
//! random velocities onto what the joints allow (`velocities`).
//!
//! | module | holds |
//! |---|---|
//! | `model` | the scene as plain data |
//! | `placement` | how a scene is set in the world: turned, moved, in another order, started a little elsewhere |
//! | `written` | the scene file |
//! | `velocities` | velocities that joints allow |
//! | `build` | what all kinds are built with |
//! | `generate` | the scene of a seed, and the list of kinds |
//! | `kinds` | the kinds, one file per group |

mod build;
pub mod generate;
mod kinds;
pub mod model;
pub mod placement;
mod velocities;
mod written;

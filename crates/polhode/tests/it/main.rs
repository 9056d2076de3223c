//! Tests of the facade: statements of physics about whole scenes.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

mod diamonds;
mod flight;
mod impacts;
mod invariance;
mod support;
mod table_edge;

//! The engine in a page: what `polhode_study::play` does, called from a script.
//!
//! Built for `wasm32-unknown-unknown` by `cargo xtask playground`, and put into the page by `polhode play`. The target
//! has no files, threads or clock, and the engine needs none. Numbers go over as arrays, reports as the text of JSON.
//! Errors are thrown as JSON: `{ "message": ..., "places": [{ "line", "column", "words" }] }`.
//!
//! | module | holds |
//! |---|---|
//! | `playground` | [`Playground`] |
//! | `fault` | errors as JSON |
//! | `files` | files that were dropped on the page |

mod fault;
mod files;
mod playground;

pub use playground::Playground;

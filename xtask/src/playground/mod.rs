//! The playground: the engine for pages is built, and what is committed of it is run.
//!
//! What is built is committed, as the viewer's bundle is, so that the program can be built without the target and its
//! tools. Its bytes depend on the version of the compiler, and change with every line of the engine; what must hold is
//! that it does what the sources do. The check therefore runs the committed engine, by node and in Chromium, and
//! compares the strict hashes of shipped scenes with the golden ones. A change of a bit, and a change of what crosses
//! the border between page and engine, shows; one that changes neither need not be built anew.
//!
//! | module | holds |
//! |---|---|
//! | `build` | the command that builds it |
//! | `step` | the step of a verification that runs it |

mod build;
mod step;

pub(crate) use build::run;
pub(crate) use step::{NAME, check};

/// Where what is built is committed.
const DIST: &str = "crates/polhode-view/viewer/dist";

/// The engine there, packed.
const ENGINE: &str = "engine.wasm.lzma";

/// The page's side of the engine there.
const BINDINGS: &str = "engine.js";

/// Largest size of the packed engine, bytes: a page of 2 MB holds it with all scripts.
const LARGEST_ENGINE: u64 = 450_000;

/// Largest size of a page, bytes.
const LARGEST_PAGE: u64 = 2_000_000;

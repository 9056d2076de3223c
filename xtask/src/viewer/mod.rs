//! The viewer of pages, looked at in a real browser, and its bundle.
//!
//! Pages that the program writes for shipped scenes, and synthetic ones, are opened in Chromium without a window. What
//! is checked of them stands beside the viewer (`crates/polhode-view/viewer/test`); here each kind of check becomes a
//! row, which names what fails. Where node, npm, the viewer's packages or a browser are missing, a row is skipped and
//! says what to install.
//!
//! | module | holds |
//! |---|---|
//! | `node` | node, npm, the viewer's packages, and the browser |
//! | `bundle` | whether the committed bundle is what its sources build to |
//! | `pages` | the pages that the program writes |
//! | `browser` | what the checks in the browser found |
//! | `step` | the step of a verification |

mod browser;
mod bundle;
mod node;
mod pages;
mod step;

pub(crate) use node::Node;
pub(crate) use step::{NAME, check, record};

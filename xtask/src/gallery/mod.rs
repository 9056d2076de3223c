//! The gallery of shipped scenes: `cargo xtask gallery`, and the check that what is committed of it is fresh.
//!
//! Committed are the stills (`docs/gallery`) and the document that shows them (`docs/gallery.md`); the page with its
//! viewers is built. The stills come from the software rasteriser and the runs of the shipped scenes, both of which
//! give the same bits on every machine, so that they are compared pixel by pixel.
//!
//! | module | holds |
//! |---|---|
//! | `command` | the command: page, viewers, stills and document |
//! | `check` | rows of `cargo xtask verify` |
//! | `selection` | which stills there are, and which show the videos of the thesis |
//! | `picture` | drawing a still, writing it and reading it back |
//! | `shown` | the shipped scenes with their runs |
//! | `groups` | the scenes in groups |
//! | `moving` | the moving picture of a group |
//! | `figures` | what a run took and how exact it was |
//! | `viewer_page` | pages that play one scene, or two beside each other |
//! | `page` | the page of the gallery |
//! | `document` | the document with the stills |

mod check;
mod command;
mod document;
mod figures;
mod groups;
mod moving;
mod page;
mod picture;
mod selection;
mod shown;
mod viewer_page;

pub(crate) use check::{CASE, check};
pub(crate) use command::{Options, run};

//! `cargo xtask atlas`: measures every entry of the atlas, and writes `docs/atlas.md` from what is recorded.
//!
//! It fails where a number is another one than that recorded; `--record` takes those that are found. The same numbers
//! are rows of `cargo xtask verify --only atlas`, with whether the page is what the command writes.
//!
//! | module | holds |
//! |---|---|
//! | `command` | the command |
//! | `page` | the page |
//! | `check` | whether page and sources are as they must be |

mod check;
mod command;
mod page;

pub(crate) use check::{PAGE_CASE, check_page};
pub(crate) use command::{Options, run};

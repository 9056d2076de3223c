//! README and book as a reader meets them: what they print is run, and where they link to exists.
//!
//! A fenced block is run by its language, in a folder of its page that holds the files of the page's earlier blocks. A
//! line that ends with the name of a file between backticks and a colon, as in "`fall.toml`:", makes the next block
//! that file.
//!
//! | language | what happens |
//! |---|---|
//! | `toml` | a scene is loaded and planned; one without `format` is completed by it; `Cargo.toml` is read as TOML |
//! | `sh` | each line is run by the shell, with the built program as `polhode`, and must succeed |
//! | `console` | the same for lines that begin with `$ `; what stands below is printed, `...` standing for anything |
//! | `rust` | compiled and run by rustdoc (`examples.rs` takes the pages in) |
//! | `python` | run by python3 where it has the modules that the block imports |
//! | `text`, `json`, `csv`, `xml` | shown only |
//!
//! | module | holds |
//! |---|---|
//! | `page` | pages and their blocks |
//! | `scenes` | blocks of scenes |
//! | `commands` | blocks of commands |
//! | `python` | blocks of Python |
//! | `programs` | blocks of Rust, and the built book |
//! | `links` | links to files and headings |
//! | `selections` | cases that documents tell to run |
//! | `step` | the step of a verification |

mod commands;
mod links;
mod page;
mod programs;
mod python;
mod scenes;
mod selections;
mod step;

pub(crate) use step::{NAME, check};

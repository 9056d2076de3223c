//! Features of libraries that some program or test of the workspace asks for, asked for by every build.
//!
//! Cargo compiles a library once for each set of features that a command asks of it, and all that depends on it as
//! often. `cargo xtask`, the tests, the program and the Python package are built by a command each. This crate has no
//! code: with it, all of them ask the same of every library that they share, and each crate is compiled once.
//!
//! `cargo xtask verify --only house` tells what is missing.

use anstyle as _;
use getrandom as _;
use libc as _;
use num_complex as _;
use num_integer as _;

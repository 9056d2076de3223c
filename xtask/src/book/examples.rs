//! The programs in README and book: rustdoc compiles and runs them. Nothing else is in this library.

#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/book/using-one-crate.md")]
struct UsingOneCrate;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/book/robots.md")]
struct Robots;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/book/golden-trajectories.md")]
struct GoldenTrajectories;

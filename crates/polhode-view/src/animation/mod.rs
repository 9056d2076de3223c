//! Moving pictures, frame by frame, so that one is in memory.
//!
//! | module | holds |
//! |---|---|
//! | [`pace`] | which frames, and how long each is shown |
//! | [`gif`], `palette` | GIF: 256 colours, opened everywhere |
//! | [`apng`] | animated PNG: every colour, larger |
//! | [`webp`] | animated WebP without loss |

pub mod apng;
pub mod gif;
pub mod pace;
mod palette;
pub mod webp;

pub use apng::write_apng;
pub use gif::write_gif;
pub use pace::{FPS, Pace, Watcher};
pub use webp::write_webp;

//! A software rasteriser: depth by a z-buffer, Lambert's light with shadow, anti-aliasing by samples.
//!
//! Every pixel is the mean of 3 x 3 samples. The picture is made in bands of rows, so that few samples are in memory.
//!
//! | module | holds |
//! |---|---|
//! | [`scene_triangles`] | triangles, lines and planes in the world |
//! | [`projection`] | from the world to samples, with what is too near cut off |
//! | [`depth_buffer`] | what is nearest at each sample of a band |
//! | [`shadow_map`] | what the lamp sees |
//! | [`marks`] | bodies too small to be seen, and the paths that they have come |
//! | [`ground`] | planes with a grid |
//! | [`paint`] | colours, with how much of them is seen |
//! | [`canvas`], `glyphs` | lines and words on a picture |
//! | `processors` | work on all processors, with the same result |
//! | [`picture`] | the picture, and how it is made |

pub mod canvas;
pub mod depth_buffer;
mod glyphs;
pub mod ground;
pub mod marks;
pub mod paint;
pub mod picture;
mod processors;
pub mod projection;
pub mod scene_triangles;
pub mod shadow_map;

pub use marks::Marks;
pub use picture::{Picture, PictureSize, draw};
pub use scene_triangles::SceneTriangles;

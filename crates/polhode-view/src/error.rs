//! Why something cannot be shown.

use polhode::spatial::DVec3;
use std::io;
use thiserror::Error;

/// Why something cannot be shown.
#[derive(Debug, Error)]
pub enum ViewError {
    /// The scene has no bodies.
    #[error("the scene `{0}` has no bodies: there is nothing to show")]
    NoBodies(String),
    /// The motion has no frames.
    #[error("the motion has no frames: there is nothing to show")]
    NoFrames,
    /// A frame is of another number of bodies than the scene.
    #[error("a frame has {found} bodies, and the scene has {needed}")]
    BodyCount {
        /// Bodies of the frame.
        found: usize,
        /// Bodies of the scene.
        needed: usize,
    },
    /// A pose or a velocity is not finite.
    #[error("t = {t_s} s: a number of body `{body}` is not finite")]
    NotFinite {
        /// When, s.
        t_s: f64,
        /// Which body.
        body: String,
    },
    /// A camera that does not look anywhere.
    #[error("a camera at {eye} m that looks at {target} m: two different places with finite coordinates are needed")]
    CameraPlace {
        /// Where it is, m.
        eye: DVec3,
        /// Where it looks, m.
        target: DVec3,
    },
    /// A picture's width or height.
    #[error("a picture of {width} x {height} pixels: 1 to {most} pixels each way are possible")]
    PictureSize {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
        /// The most of either.
        most: u32,
    },
    /// A binary glTF file holds at most 4 GiB.
    #[error("the model has {bytes} bytes, and a .glb file holds at most 4294967295: ask for fewer frames")]
    ModelTooLarge {
        /// Bytes.
        bytes: usize,
    },
    /// Whoever watched the drawing has stopped it.
    #[error("drawing was stopped after {drawn} of {frames} frames")]
    Stopped {
        /// Frames drawn.
        drawn: usize,
        /// Frames of the motion.
        frames: usize,
    },
    /// A picture could not be put into its format.
    #[error("the picture could not be encoded: {0}")]
    Encoding(String),
    /// Writing failed.
    #[error("{0}")]
    Write(#[from] io::Error),
}

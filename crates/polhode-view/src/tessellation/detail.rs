//! How fine round shapes are.

/// Segments of a circle when few bodies are shown.
const FINE: u32 = 48;
/// Segments of a circle when hundreds of bodies are shown.
const MEDIUM: u32 = 24;
/// Segments of a circle when thousands are: 16 are 512 triangles a sphere.
const COARSE: u32 = 16;
/// Bodies from which on circles are of medium fineness.
const MANY: usize = 200;
/// Bodies from which on circles are coarse.
const VERY_MANY: usize = 1000;

/// How fine round shapes are: segments of a circle, a multiple of four.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Detail(u32);

impl Detail {
    /// With at least this many segments to a circle (4 to 1024), rounded up to a multiple of four.
    pub fn new(segments: u32) -> Self {
        Self(segments.clamp(4, 1024).next_multiple_of(4))
    }

    /// Fit for so many bodies.
    pub fn for_bodies(count: usize) -> Self {
        Self(match count {
            0..MANY => FINE,
            MANY..VERY_MANY => MEDIUM,
            _ => COARSE,
        })
    }

    /// Segments of a circle.
    pub fn segments(self) -> u32 {
        self.0
    }
}

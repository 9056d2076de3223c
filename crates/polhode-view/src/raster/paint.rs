//! Paints: colours with how much of them is seen.
//!
//! What is seen through is drawn at some of the nine samples of a pixel only: no order of drawing matters.

use crate::colors::{self, Color};

/// Samples of a pixel each way.
pub(crate) const SAMPLES: u32 = 3;
/// In which order the samples of a pixel are covered.
const ORDER: [u8; 9] = [0, 5, 7, 6, 2, 3, 4, 8, 1];

/// A colour, with how much of it is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Paint {
    /// As light.
    pub color: Color,
    /// Samples of a pixel that it covers.
    covers: u8,
}

impl Paint {
    /// Whether it covers a sample.
    pub(crate) fn covers(&self, x: usize, y: usize) -> bool {
        let side = SAMPLES as usize;
        ORDER[(y % side) * side + x % side] < self.covers
    }

    /// Whether it throws a shadow: what is hardly seen does not.
    pub(crate) fn is_solid(&self) -> bool {
        2 * usize::from(self.covers) > ORDER.len()
    }
}

/// The paints of a picture, each once.
#[derive(Debug, Clone, Default)]
pub struct Paints(Vec<([u8; 3], Paint)>);

impl Paints {
    /// The number of a colour (sRGB) of which so much is seen, 0 to 1.
    pub(crate) fn number_of(&mut self, srgb: [u8; 3], opacity: f64) -> u16 {
        // At least one sample: what is not seen at all is not drawn.
        let covers = (opacity * ORDER.len() as f64).round().max(1.0) as u8;
        let known = self.0.iter().position(|(own, paint)| *own == srgb && paint.covers == covers);
        let number = known.unwrap_or_else(|| {
            self.0.push((srgb, Paint { color: colors::linear(srgb), covers }));
            self.0.len() - 1
        });
        // More colours than that are not told apart.
        u16::try_from(number).unwrap_or(u16::MAX)
    }

    /// The paint of this number.
    pub(crate) fn get(&self, number: u16) -> Option<&Paint> {
        self.0.get(usize::from(number)).map(|(_, paint)| paint)
    }
}

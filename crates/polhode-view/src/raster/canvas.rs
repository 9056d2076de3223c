//! Lines, discs and words that are drawn on a picture. A pixel is covered by what lies within half a pixel of it.

use super::glyphs::{self, ADVANCE, BASE, ROWS};
use super::picture::Picture;
use crate::colors;

/// A place on a picture: pixels across and down.
pub type Spot = [f64; 2];

/// Width of the strokes of letters, as a fraction of a row of a letter.
const STROKE: f64 = 1.15;
/// Rows of a letter in a picture of a row of pixels, and the least size of a row, pixels.
const ROW: f64 = 1.0 / 480.0;
const LEAST_ROW_PX: f64 = 1.0;

/// How much of the plate behind words is seen.
const PLATE: f64 = 0.8;

/// How a thing is painted.
#[derive(Debug, Clone, Copy)]
pub struct Ink {
    /// Red, green and blue, sRGB.
    pub color: [u8; 3],
    /// How much of it is seen, 0 to 1.
    pub opacity: f64,
}

impl Ink {
    /// A colour of which all is seen.
    pub fn solid(color: [u8; 3]) -> Self {
        Self { color, opacity: 1.0 }
    }
}

/// A picture that is drawn on.
#[derive(Debug)]
pub struct Canvas<'a> {
    picture: &'a mut Picture,
    /// Size of a row of letters, pixels.
    pub row_px: f64,
}

impl<'a> Canvas<'a> {
    /// On this picture.
    pub fn new(picture: &'a mut Picture) -> Self {
        let row_px = (f64::from(picture.size.height()) * ROW).max(LEAST_ROW_PX);
        Self { picture, row_px }
    }

    /// Width and height, pixels.
    pub fn size(&self) -> Spot {
        [self.picture.size.width(), self.picture.size.height()].map(f64::from)
    }

    /// Paints the pixels between two corners as much as `covered` says of the middle of each.
    fn paint(&mut self, [low, high]: [Spot; 2], ink: Ink, covered: impl Fn(Spot) -> f64) {
        let (width, height) = (self.picture.size.width() as usize, self.picture.size.height() as usize);
        // A conversion to whole numbers saturates, and makes zero of what is no number.
        let range =
            |low: f64, high: f64, most: usize| (low.floor() as usize)..(high.ceil().max(0.0) as usize).min(most);
        for y in range(low[1], high[1], height) {
            for x in range(low[0], high[0], width) {
                let part = ink.opacity * covered([x as f64 + 0.5, y as f64 + 0.5]).clamp(0.0, 1.0);
                if part > 0.0 {
                    for (channel, own) in ink.color.iter().enumerate() {
                        let value = &mut self.picture.rgb[3 * (y * width + x) + channel];
                        *value = (f64::from(*value) + (f64::from(*own) - f64::from(*value)) * part).round() as u8;
                    }
                }
            }
        }
    }

    /// A line with round ends.
    pub fn line(&mut self, [a, b]: [Spot; 2], width: f64, ink: Ink) {
        let half = 0.5 * width;
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let square = dx * dx + dy * dy;
        let room = half + 1.0;
        let corners = [[a[0].min(b[0]) - room, a[1].min(b[1]) - room], [a[0].max(b[0]) + room, a[1].max(b[1]) + room]];
        self.paint(corners, ink, |[x, y]| {
            let along = if square > 0.0 { ((x - a[0]) * dx + (y - a[1]) * dy) / square } else { 0.0 };
            let along = along.clamp(0.0, 1.0);
            half + 0.5 - libm::hypot(x - a[0] - along * dx, y - a[1] - along * dy)
        });
    }

    /// A disc.
    pub fn disc(&mut self, center: Spot, radius: f64, ink: Ink) {
        self.line([center, center], 2.0 * radius, ink);
    }

    /// A plate with round corners between two corners, on which words are read.
    pub fn plate(&mut self, [low, high]: [Spot; 2], round: f64) {
        let ink = Ink { color: colors::PLATE, opacity: PLATE };
        let inner = |value: f64, low: f64, high: f64| value.clamp(low + round, (high - round).max(low + round));
        self.paint([low, high], ink, |[x, y]| {
            let (dx, dy) = (x - inner(x, low[0], high[0]), y - inner(y, low[1], high[1]));
            round + 0.5 - libm::hypot(dx, dy)
        });
    }

    /// An arrow with its head at the second place.
    pub fn arrow(&mut self, [a, b]: [Spot; 2], width: f64, ink: Ink) {
        let length = libm::hypot(b[0] - a[0], b[1] - a[1]);
        if length <= 0.0 || !length.is_finite() {
            return;
        }
        let (u, v) = ((b[0] - a[0]) / length, (b[1] - a[1]) / length);
        let head = (5.0 * width).min(0.5 * length);
        let neck = [b[0] - u * head, b[1] - v * head];
        self.line([a, neck], width.min(0.5 * head), ink);
        let half = 0.45 * head;
        let corners = [[b[0] - head, b[1] - head], [b[0] + head, b[1] + head]];
        self.paint(corners, ink, |[x, y]| {
            let (along, across) = ((b[0] - x) * u + (b[1] - y) * v, ((x - b[0]) * v - (y - b[1]) * u).abs());
            // Inside of the slanted sides and before the neck.
            let side = (half * along / head - across) / libm::hypot(1.0, half / head);
            (side + 0.5).min(head - along + 0.5)
        });
    }

    /// Words that begin here and stand on a line.
    pub fn words(&mut self, [x, y]: Spot, text: &str, ink: Ink) {
        let row = self.row_px;
        for (place, letter) in text.chars().enumerate() {
            let left = x + ADVANCE * row * place as f64;
            let spot = |[column, at]: [usize; 2]| [left + row * column as f64, y + row * (at as f64 - BASE)];
            for stroke in glyphs::strokes(letter) {
                self.line(stroke.map(spot), STROKE * row, ink);
            }
        }
    }

    /// How wide words are, pixels.
    pub fn width_of(&self, text: &str) -> f64 {
        let letters = text.chars().count() as f64;
        (ADVANCE * letters - 1.0).max(0.0) * self.row_px
    }

    /// From one line of words to the next, pixels.
    pub fn line_height(&self) -> f64 {
        (ROWS as f64 + 3.0) * self.row_px
    }
}

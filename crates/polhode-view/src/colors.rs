//! Colours of pictures, models and pages: what moves, what stands, the ground, and lines.

use polhode::scene::COLORS;

/// Red, green and blue as light: linear, 0 to 1.
pub(crate) type Color = [f64; 3];

/// How many of the first colours bodies that move have in turn.
const IN_TURN: usize = 7;
/// Name of the colour of bodies that do not move.
const STANDING: &str = "grey";

/// What is behind all, the ground, lines on the ground, edges of bodies, and joints, as sRGB: those of a light page
/// (`viewer/viewer.css`).
pub(crate) const STAGE: [u8; 3] = [0xee, 0xf1, 0xf4];
pub(crate) const GROUND: [u8; 3] = [0xdd, 0xe2, 0xe7];
pub(crate) const GRID: [u8; 3] = [0x8e, 0x98, 0xa4];
pub(crate) const EDGE: [u8; 3] = [0x23, 0x2a, 0x33];
pub(crate) const FIXTURE: [u8; 3] = [0x4a, 0x54, 0x60];
/// Words, and what they stand on.
pub(crate) const INK: [u8; 3] = [0x1b, 0x20, 0x27];
pub(crate) const PLATE: [u8; 3] = [0xff, 0xff, 0xff];
/// Arrows of velocities, angular velocities, forces of contacts and of joints, as pages have them
/// (`viewer/src/colours.js`).
pub(crate) const VELOCITY: [u8; 3] = [0x26, 0x77, 0xdd];
pub(crate) const SPIN: [u8; 3] = [0xe0, 0x7f, 0x00];
pub(crate) const FORCE: [u8; 3] = [0xd8, 0x33, 0x4a];
pub(crate) const LOAD: [u8; 3] = [0xa0, 0x20, 0xa8];

/// The colour of a body by its place among those that move; of one that does not, without; sRGB.
pub(crate) fn of_place(place: Option<usize>) -> [u8; 3] {
    let standing = || COLORS.iter().find(|(name, _)| *name == STANDING);
    place.map_or_else(standing, |place| COLORS.get(place % IN_TURN)).map_or(FIXTURE, |(_, color)| *color)
}

/// `#rrggbb`.
pub(crate) fn hexadecimal([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// sRGB as light.
pub(crate) fn linear(srgb: [u8; 3]) -> Color {
    srgb.map(|channel| {
        let c = f64::from(channel) / 255.0;
        if c <= 0.04045 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) }
    })
}

/// Steps of light of which the value in sRGB is kept: at the darkest a step is a fifth of one of sRGB.
const STEPS: usize = 1 << 14;

/// Light as sRGB, from a table.
#[derive(Debug, Clone)]
pub(crate) struct Encoding(Vec<u8>);

impl Default for Encoding {
    fn default() -> Self {
        let of_step = |step: usize| {
            let c = step as f64 / (STEPS - 1) as f64;
            let c = if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * libm::pow(c, 1.0 / 2.4) - 0.055 };
            (255.0 * c).round() as u8
        };
        Self((0..STEPS).map(of_step).collect())
    }
}

impl Encoding {
    /// Light as sRGB.
    pub(crate) fn srgb(&self, light: Color) -> [u8; 3] {
        light.map(|channel| self.0[(channel.clamp(0.0, 1.0) * (STEPS - 1) as f64).round() as usize])
    }
}

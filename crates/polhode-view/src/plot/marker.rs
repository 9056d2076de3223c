//! Markers of points.

use super::ink::Ink;
use super::svg::{Spot, Svg};

/// The shape of a marker.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Marker {
    /// A disc.
    Disc,
    /// A square.
    Square,
    /// A triangle that points up.
    Triangle,
    /// A diamond.
    Diamond,
    /// A triangle that points down.
    Inverted,
    /// A star of four points.
    Star,
    /// A cross of two bars.
    Cross,
}

impl Marker {
    /// All, in the order in which they are taken.
    pub const ALL: [Self; 7] =
        [Self::Disc, Self::Square, Self::Triangle, Self::Diamond, Self::Inverted, Self::Star, Self::Cross];

    /// Corners, of its size.
    const fn corners(self) -> &'static [Spot] {
        match self {
            Self::Disc => &[],
            Self::Square => &[[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]],
            Self::Triangle => &[[-1.1, 0.85], [1.1, 0.85], [0.0, -1.15]],
            Self::Diamond => &[[-1.25, 0.0], [0.0, -1.25], [1.25, 0.0], [0.0, 1.25]],
            Self::Inverted => &[[-1.1, -0.85], [1.1, -0.85], [0.0, 1.15]],
            Self::Star => {
                &[[0.0, -1.5], [0.4, -0.4], [1.5, 0.0], [0.4, 0.4], [0.0, 1.5], [-0.4, 0.4], [-1.5, 0.0], [-0.4, -0.4]]
            }
            Self::Cross => &[
                [-0.4, -1.2],
                [0.4, -1.2],
                [0.4, -0.4],
                [1.2, -0.4],
                [1.2, 0.4],
                [0.4, 0.4],
                [0.4, 1.2],
                [-0.4, 1.2],
                [-0.4, 0.4],
                [-1.2, 0.4],
                [-1.2, -0.4],
                [-0.4, -0.4],
            ],
        }
    }

    /// Draws it: half of its width is about `size` (pixels).
    pub fn draw(self, svg: &mut Svg, [x, y]: Spot, size: f64, ink: Ink) {
        match self.corners() {
            [] => svg.disc([x, y], size, ink),
            corners => {
                let spots: Vec<Spot> = corners.iter().map(|[dx, dy]| [x + size * dx, y + size * dy]).collect();
                svg.polygon(&spots, ink);
            }
        }
    }
}

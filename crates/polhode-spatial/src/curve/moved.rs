//! Curves turned, shifted and mirrored: each formula with its points and vectors moved.

use super::error::CurveError;
use super::piece::{Piece, Stretch};
use super::piecewise::{Curve, CurvePlane};
use crate::Isometry;

impl Curve {
    /// The same curve in a space set otherwise.
    ///
    /// # Errors
    /// When its points are too far away for it to keep its form.
    pub fn moved(&self, space: &Isometry) -> Result<Self, CurveError> {
        let stretches = self.stretches.iter().map(|own| Stretch { piece: own.piece.moved(space), ..own.clone() });
        let plane = match self.plane() {
            CurvePlane::Plane(normal) => CurvePlane::Plane(space.axis(normal)),
            other => other,
        };
        Self::new(stretches.collect(), space.point(self.spans[0].start), self.is_closed, Some(plane))
    }
}

impl Piece {
    fn moved(&self, space: &Isometry) -> Self {
        let (point, vector) = (|p| space.point(p), |v| space.vector(v));
        match *self {
            Self::Bend { heading, left, curvature, curvature_rate } => {
                Self::Bend { heading: vector(heading), left: vector(left), curvature, curvature_rate }
            }
            Self::Helix { center, x, y, axis, radius, advance } => {
                let (x, y, axis) = (vector(x), vector(y), vector(axis));
                Self::Helix { center: point(center), x, y, axis, radius, advance }
            }
            Self::Polynomial(ref coefficients) => {
                let moved = |(power, &own)| if power == 0 { point(own) } else { vector(own) };
                Self::Polynomial(coefficients.iter().enumerate().map(moved).collect())
            }
            Self::Wave { start, along, up, amplitude, wavenumber } => {
                Self::Wave { start: point(start), along: vector(along), up: vector(up), amplitude, wavenumber }
            }
            Self::Cycloid { lowest, along, up, radius } => {
                Self::Cycloid { lowest: point(lowest), along: vector(along), up: vector(up), radius }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

    use super::*;
    use crate::curve::{Bend, Coil, SplineEnds};
    use crate::{Handedness, Rotation, UnitVector};
    use glam::DVec3;

    /// A place of the image is the image of the place, and a helix has changed hands.
    #[test]
    fn places_are_the_images_of_places() {
        let turn = Rotation::from_rotation_vector(DVec3::new(0.4, 1.0, -0.6));
        let space = Isometry::new(turn, DVec3::new(1.0, -2.0, 0.5), Handedness::Mirrored);
        let bends = [Bend { length: 1.0, curvature: [0.0, 1.0] }, Bend { length: 0.5, curvature: [1.0, 1.0] }];
        let curves = [
            Curve::helix(DVec3::X, UnitVector::Z, DVec3::Y, Coil { advance: 0.3, turns: 2.0 }),
            Curve::path(DVec3::Y, UnitVector::X, DVec3::Z, &bends),
            Curve::spline(&[DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.5)], SplineEnds::Open),
        ];
        for curve in curves.map(Result::unwrap) {
            let image = curve.moved(&space).unwrap();
            assert!((image.length() - curve.length()).abs() < 1e-14);
            for part in [0.0, 0.3, 0.9] {
                let (own, other) = (curve.at(part * curve.length()), image.at(part * curve.length()));
                assert!((other.point - space.point(own.point)).length() < 1e-14);
                assert!((other.curvature - space.vector(own.curvature)).length() < 1e-12);
            }
        }
    }
}

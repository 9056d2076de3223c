//! How far shapes reach: balls whose convex hull holds a shape, its bounding box and its support.

use super::Shape;
use crate::bounding::Bounds;
use glam::DVec3;
use polhode_spatial::Pose;

impl Shape {
    /// Calls `visit` with balls (centre and radius, m) whose convex hull holds the shape; none for a half-space.
    pub(crate) fn for_each_ball(&self, visit: &mut dyn FnMut(DVec3, f64)) {
        match self {
            Self::HalfSpace(_) => {}
            Self::Cylinder(c) => {
                let half = c.axis * c.half_height;
                visit(c.center - half, c.radius);
                visit(c.center + half, c.radius);
            }
            Self::Cone(c) => {
                visit(c.base, c.radius);
                visit(c.apex(), 0.0);
            }
            Self::Torus(t) => visit(t.center, t.major + t.minor),
            Self::Compound(c) => c.parts.iter().for_each(|part| part.for_each_ball(visit)),
            _ => {
                let (centers, radius) = self.centers();
                for &center in centers {
                    visit(center, radius);
                }
            }
        }
    }

    /// A box around the shape at a pose, m; empty for a half-space.
    pub(crate) fn bounds_at(&self, pose: &Pose) -> Bounds {
        match self {
            Self::TriangleMesh(m) => turned(m.bounds(), pose),
            Self::Compound(c) => turned(c.tree.bounds(), pose),
            _ => {
                let mut bounds = Bounds::EMPTY;
                self.for_each_ball(&mut |center, radius| {
                    let place = pose.transform_point(center);
                    bounds = bounds.union(Bounds { min: place - radius, max: place + radius });
                });
                bounds
            }
        }
    }
}

/// A box around a turned box.
pub(crate) fn turned(bounds: Bounds, pose: &Pose) -> Bounds {
    let rotation = pose.rotation.to_matrix();
    let half = 0.5 * (bounds.max - bounds.min);
    let center = pose.transform_point(bounds.min + half);
    let reach = rotation.x_axis.abs() * half.x + rotation.y_axis.abs() * half.y + rotation.z_axis.abs() * half.z;
    Bounds { min: center - reach, max: center + reach }
}

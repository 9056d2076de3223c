//! Meshes of the scenes that friction holds in the suite: what rolls, and a stone of an arch. Lengths in m.

use super::meshes::{Made, on_circle, polygon};
use glam::DVec3;
use polhode::mesh::{Cone, ConvexHull, Cylinder, Refinement, Sphere};
use std::f64::consts::{PI, TAU};

/// A cylinder about z of diameter and height 1, a prism of few sides.
pub(super) fn coin() -> Made {
    Ok(Cylinder::new(0.5, 1.0)?.mesh(Refinement::COARSEST)?.into_mesh())
}

/// A ball of radius 1 of 320 triangles.
pub(super) fn ball() -> Made {
    Ok(Sphere::new(1.0)?.mesh(Refinement::new(2)?)?.into_mesh())
}

/// A cone about z of radius 0.05 and height 0.1, its apex towards +z, its origin a quarter of its height above the
/// base.
pub(super) fn cone() -> Made {
    Ok(Cone::new(0.05, 0.1)?.mesh(Refinement::COARSEST)?.into_mesh())
}

/// The hull of two circles of radius 1, each in a plane across that of the other and through its centre: an oloid.
pub(super) fn oloid() -> Made {
    let on_circles = (0..32).flat_map(|corner| {
        let [along, across] = on_circle(1.0, TAU * f64::from(corner) / 32.0);
        [DVec3::new(along - 0.5, across, 0.0), DVec3::new(0.5 - along, 0.0, across)]
    });
    Ok(ConvexHull::of(&on_circles.collect::<Vec<_>>())?.into_solid().into_solid().into_mesh())
}

/// The hull of two half circles of radius 1 across each other, back to back: a sphericon, which like a Goemboec
/// balances on few of its points.
pub(super) fn sphericon() -> Made {
    let on_arcs = (0..=16).flat_map(|corner| {
        let [forth, across] = on_circle(1.0, PI * (f64::from(corner) / 16.0 - 0.5));
        // Ends of the arcs lie in the plane of the other one's ends.
        let forth = if corner % 16 == 0 { 0.0 } else { forth };
        [DVec3::new(forth, across, 0.0), DVec3::new(-forth, 0.0, across)]
    });
    Ok(ConvexHull::of(&on_arcs.collect::<Vec<_>>())?.into_solid().into_solid().into_mesh())
}

/// Stones of the arch.
pub(super) const STONES: u32 = 25;
/// How much narrower a stone is than its share of the half circle, degrees.
const JOINT: f64 = 0.01;

/// A stone of a half circle of radius 5 m to 6 m about z, its middle on the x axis.
pub(super) fn stone() -> Made {
    let half = (180.0 / f64::from(STONES) - JOINT) / 360.0 * PI;
    let outline = [on_circle(5.0, half), on_circle(5.0, -half), on_circle(6.0, -half), on_circle(6.0, half)];
    polygon(&outline, 0.5)
}

//! A body as it is shown, and the ends of what connects bodies.

use crate::tessellation::Parts;
use polhode::scene::BodyLook;
use polhode::spatial::{DVec3, Pose};

/// A body as it is shown.
#[derive(Debug, Clone)]
pub struct ShownBody {
    /// Its name.
    pub name: String,
    /// Whether it may move, by forces or as prescribed.
    pub moves: bool,
    /// Mass, kg, when forces move it.
    pub mass_kg: Option<f64>,
    /// Centre of mass in the body's frame, m.
    pub center_of_mass: DVec3,
    /// Principal moments of inertia, ascending, kg m^2.
    pub principal_moments: Option<DVec3>,
    /// `R_PB`, scalar first: from the body's axes to the principal ones.
    pub principal_axes: [f64; 4],
    /// What is drawn.
    pub shape: Parts,
    /// Smallest and largest coordinates of the parts in the body's frame, m.
    pub bounds: Option<[DVec3; 2]>,
    /// Its colour, words and how much of it is seen.
    pub look: BodyLook,
    /// Pose at the start.
    pub initial: Pose,
}

impl ShownBody {
    /// Largest distance of its parts from its origin, m.
    pub fn reach_m(&self) -> f64 {
        self.bounds.map_or(0.0, |[low, high]| low.abs().max(high.abs()).length())
    }

    /// The middle of the box around its parts in a pose, in the world, m; its origin where it has none.
    pub fn middle(&self, pose: &Pose) -> DVec3 {
        self.bounds.map_or(pose.translation, |[low, high]| pose.transform_point(0.5 * (low + high)))
    }

    /// Length of the diagonal of the box around its parts, m.
    pub fn size_m(&self) -> f64 {
        self.bounds.map_or(0.0, |[low, high]| (high - low).length())
    }
}

/// An end of a joint.
#[derive(Debug, Clone, Copy)]
pub struct JointEnd {
    /// Number of the body; none of an end in the world.
    pub body: Option<usize>,
    /// In the frame of the body, or in the world, m.
    pub point: DVec3,
}

//! Two algorithms for the separation of two convex polyhedra: the separating-axis test and GJK.
//!
//! For overlapping bodies both give the depth of penetration over all axes. For bodies apart GJK gives the Euclidean
//! distance, and the separating-axis test the largest separation over the normals of faces and pairs of edges, which is
//! less than the distance where a vertex is nearest to an edge or a vertex. The time of the separating-axis test grows
//! as the product of the numbers of edges, that of GJK as the sum of the numbers of vertices.

use crate::Shape;
use crate::narrow_phase::axis::axis_search::AxisSearch;
use crate::narrow_phase::axis::separating_axis::search_axes;
use crate::narrow_phase::dispatch::workspace::Workspace;
use crate::query::distance;
use crate::shape::polyhedron::ConvexPolyhedron;
use glam::DVec3;
use polhode_spatial::Pose;

/// The algorithm for the separation of two convex polyhedra.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum ConvexMethod {
    /// Every face normal and every pair of edges that may separate is tried.
    #[default]
    SeparatingAxis,
    /// The algorithm of Gilbert, Johnson and Keerthi finds the nearest features; the distance is then computed from
    /// them in closed form.
    Gjk,
}

impl ConvexMethod {
    /// All methods.
    pub const ALL: [Self; 2] = [Self::SeparatingAxis, Self::Gjk];

    /// Name in benchmark tables and files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::SeparatingAxis => "separating-axis",
            Self::Gjk => "gjk",
        }
    }
}

/// Separation (m, negative when the bodies overlap) and the unit vector from B to A along which it was measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Separation {
    /// Separation, m.
    pub distance: f64,
    /// Unit vector from B to A, world.
    pub normal: DVec3,
}

/// The separation of two polyhedra by a method. For other pairs both methods give [`distance()`]. None when a pose is
/// not finite or no distance exists.
///
/// ```
/// use polhode_contact::{ConvexMethod, DVec3, Pose, Shape, Workspace, separation_by};
/// let brick = Shape::cuboid(DVec3::ONE)?;
/// let above = Pose::from_translation(DVec3::Z * 1.5);
/// for method in ConvexMethod::ALL {
///     let found = separation_by(method, &mut Workspace::default(), &brick, &above, &brick, &Pose::IDENTITY);
///     assert!(found.is_some_and(|found| found.distance == 0.5 && found.normal == DVec3::Z));
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn separation_by(
    method: ConvexMethod,
    workspace: &mut Workspace,
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
) -> Option<Separation> {
    if !(pose_a.is_finite() && pose_b.is_finite()) {
        return None;
    }
    if let (ConvexMethod::SeparatingAxis, Shape::Convex(a), Shape::Convex(b)) = (method, shape_a, shape_b) {
        return Some(along_best_axis(&mut workspace.pair().search, [a, b], [pose_a, pose_b]));
    }
    let found = distance(shape_a, pose_a, shape_b, pose_b).ok()?;
    Some(Separation { distance: found.distance, normal: found.normal })
}

/// Largest separation over the axes, and that axis.
fn along_best_axis(search: &mut AxisSearch, polyhedra: [&ConvexPolyhedron; 2], poses: [&Pose; 2]) -> Separation {
    let axes = search_axes(search, polyhedra, poses, f64::INFINITY);
    let crossed = axes.crossed_edges(polyhedra, poses);
    let ([a, b], [pose_a, pose_b]) = (polyhedra, poses);
    let (nearly_parallel, out_of_a) = axes.along_nearly_parallel;
    let others = axes.face_separation().max(nearly_parallel);
    if let Some(crossed) = crossed.filter(|crossed| crossed.separation > others) {
        return Separation { distance: crossed.separation, normal: crossed.normal };
    }
    if nearly_parallel > axes.face_separation() {
        return Separation { distance: nearly_parallel, normal: -pose_a.rotation.rotate(out_of_a) };
    }
    let face = |polyhedron: &ConvexPolyhedron, pose: &Pose, face: u32| {
        polyhedron.faces.get(face as usize).map_or(DVec3::Z, |f| pose.rotation.rotate(f.normal))
    };
    let normal = if axes.face_a.separation >= axes.face_b.separation {
        -face(a, pose_a, axes.face_a.face)
    } else {
        face(b, pose_b, axes.face_b.face)
    };
    Separation { distance: axes.face_separation(), normal }
}

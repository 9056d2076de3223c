//! Approximate decomposition: convex parts, a correct volume error, and no dependence on units.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use crate::support::{Random, l_prism};
use polhode_contact::{ApproximateError, ApproximateSettings, approximate_decomposition};
use polhode_mesh::{ConvexHull, SolidMesh, TriangleMesh, box_mesh, convexity};
use polhode_spatial::DVec3;

/// Two boxes side by side, [0, 2] x [0, 1] and [0, 1] x [1, 3], one metre high, as one mesh.
fn l_shape() -> SolidMesh {
    l_prism([[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]], 1.0)
}

/// The parts of an L are convex and their volume is what is stated; the hull of the whole would be a quarter too large.
#[test]
fn l_shape_is_nearly_filled() {
    let solid = l_shape();
    let found = approximate_decomposition(&solid, ApproximateSettings::default()).unwrap();
    println!("L: {} parts, volume error {:e}", found.parts.len(), found.volume_error);
    let volume: f64 = found.parts.iter().map(|part| part.volume_integrals().volume).sum();
    assert!((volume / 4.0 - 1.0 - found.volume_error).abs() < 1e-14);
    // One voxel is 1/64 of three metres; a few layers of voxels along the cuts count twice.
    assert!(found.parts.len() >= 2 && found.volume_error.abs() < 0.1);
    for part in &found.parts {
        assert_eq!(convexity(part.solid()).excess, 0.0);
    }
}

/// A solid in kilometres or micrometres gives the same parts; a void is filled, which the volume error shows.
#[test]
fn voids_and_units() {
    let solid = l_shape();
    let at = |scale: f64| {
        let scaled = SolidMesh::new(solid.mesh().scaled(scale).unwrap()).unwrap();
        let found = approximate_decomposition(&scaled, ApproximateSettings::default()).unwrap();
        (found.parts.len(), found.volume_error)
    };
    let (parts, error) = at(1.0);
    for scale in [1e-6, 1e3] {
        let (other_parts, other_error) = at(scale);
        assert_eq!(other_parts, parts);
        assert!((other_error - error).abs() < 1e-9);
    }
    let brick = box_mesh(DVec3::ONE).unwrap().into_mesh();
    let void = brick.scaled(0.5).unwrap().flipped();
    let vertices = [brick.vertices(), void.vertices()].concat();
    let triangles =
        brick.triangles().iter().copied().chain(void.triangles().iter().map(|t| t.map(|i| i + 8))).collect();
    let hollow = SolidMesh::new(TriangleMesh::new(vertices, triangles).unwrap()).unwrap();
    let found = approximate_decomposition(&hollow, ApproximateSettings::default()).unwrap();
    println!("hollow box: {} parts, volume error {:e}", found.parts.len(), found.volume_error);
    // An eighth of the box is void.
    assert!((found.volume_error - 1.0 / 7.0).abs() < 0.05);
}

/// Settings out of their ranges are refused, those at the ends of the ranges are not.
#[test]
fn settings() {
    let solid = l_shape();
    let with = |concavity, resolution, max_parts| {
        approximate_decomposition(&solid, ApproximateSettings { concavity, resolution, max_parts })
    };
    assert!(matches!(with(f64::NAN, 64, 16), Err(ApproximateError::Concavity(_))));
    assert!(matches!(with(-0.1, 64, 16), Err(ApproximateError::Concavity(_))));
    assert_eq!(with(0.1, 7, 16), Err(ApproximateError::Resolution(7)));
    assert_eq!(with(0.1, 1 << 20, 16), Err(ApproximateError::Resolution(1 << 20)));
    assert_eq!(with(0.1, 64, 0), Err(ApproximateError::MaxParts(0)));
    for (concavity, max_parts) in [(0.0, 4096), (1.0, 1), (0.0, 1), (1.0, 4096)] {
        assert!(with(concavity, 8, max_parts).is_ok());
    }
}

/// The hull of polhode-mesh agrees with that of parry3d: same number of vertices and volume for random points.
#[test]
fn hulls_agree_with_the_library() {
    let mut random = Random(1);
    for count in [10, 100, 1000] {
        let points: Vec<DVec3> = (0..count).map(|_| random.vector()).collect();
        let own = ConvexHull::of(&points).unwrap();
        let (vertices, triangles) = parry3d::transformation::try_convex_hull(&points).unwrap();
        let theirs = SolidMesh::new(TriangleMesh::new(vertices, triangles).unwrap()).unwrap();
        assert_eq!(own.sources().len(), theirs.mesh().vertices().len());
        let (own, theirs) = (own.solid().volume_integrals().volume, theirs.volume_integrals().volume);
        assert!((own / theirs - 1.0).abs() < 1e-14, "{count} points: {own} and {theirs}");
    }
}

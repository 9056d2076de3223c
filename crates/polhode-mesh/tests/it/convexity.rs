//! Convexity is measured in metres, and rounding does not count as a dent.

use crate::shapes::{L_SHAPE, PYRAMID, deformed, icosphere, joined, mesh, solid, torus};
use polhode_mesh::{SolidMesh, TriangleMesh, box_mesh, convexity};
use polhode_spatial::{DVec3, Pose, Rotation};
use proptest::prelude::*;

fn is_convex(mesh: TriangleMesh) -> bool {
    convexity(&SolidMesh::new(mesh).unwrap()).is_convex()
}

/// The L's face y = 1 has the vertices at y = 3 two metres in front of it, its face x = 1 those at x = 2 one metre.
#[test]
fn excess_of_the_l_shape_is_two_metres() {
    let shape = solid(L_SHAPE);
    let found = convexity(&shape);
    assert!(!found.is_convex());
    assert!((found.excess - 2.0).abs() < 1e-13, "{found:?}");
    let (vertex, triangle) = found.worst.unwrap();
    assert_eq!(shape.mesh().vertices()[vertex as usize].y, 3.0);
    assert!(shape.mesh().corners(shape.mesh().triangles()[triangle as usize]).iter().all(|corner| corner.y == 1.0));
}

#[test]
fn named_shapes() {
    let pyramid = convexity(&solid(PYRAMID));
    assert_eq!((pyramid.excess, pyramid.worst), (0.0, None));
    assert!(is_convex(icosphere(4)));
    assert!(!is_convex(torus(16, 8)));
    // Two convex parts, and a void, are not convex.
    let sphere = icosphere(1);
    assert!(!is_convex(joined(&[&sphere, &sphere.translated(DVec3::X * 3.0).unwrap()])));
    assert!(!is_convex(joined(&[&sphere, &sphere.scaled(0.5).unwrap().flipped()])));
}

/// A far vertex that no triangle uses is no part of the shape.
#[test]
fn unused_vertices_do_not_count() {
    let sphere = icosphere(1);
    let mut vertices = sphere.vertices().to_vec();
    vertices.push(DVec3::splat(100.0));
    assert!(is_convex(TriangleMesh::new(vertices, sphere.triangles().to_vec()).unwrap()));
}

/// Triangles too thin to know their own plane do not spoil the answer.
#[test]
fn slivers() {
    let sliver =
        b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 1e-9 0 1\nv 0.999999999 0 1\n\
        f 1 4 3 2\nf 8 5 9 10 6 7\nf 1 2 6 10 9 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    let turned = Pose::new(Rotation::from_rotation_vector(DVec3::new(0.3, -1.0, 0.7)), DVec3::new(5.0, 6.0, 7.0));
    assert!(is_convex(mesh(sliver).in_frame(&turned).unwrap()));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// An affine image of a convex solid is convex, wherever it lies: also a box, whose faces are pairs of coplanar
    /// triangles, a million sizes away.
    #[test]
    fn affine_images_stay_convex(
        (x, y, z) in (0.01..3.0f64, 0.01..3.0f64, 0.01..3.0f64),
        (u, v, w) in (-3.0..3.0f64, -3.0..3.0f64, -3.0..3.0f64),
        distance in 0.0..1e6f64,
    ) {
        let turned = Pose::new(Rotation::from_rotation_vector(DVec3::new(u, v, w)), DVec3::new(u, v, w) * distance);
        let brick = box_mesh(DVec3::new(x, y, z)).unwrap().into_mesh();
        prop_assert!(is_convex(brick.in_frame(&turned).unwrap()));
        let ellipsoid = deformed(&icosphere(2), |p| p * DVec3::new(x, y, z)).unwrap();
        prop_assert!(is_convex(ellipsoid.in_frame(&turned).unwrap()));
    }

    /// The measure equals the plain maximum over all faces and vertices.
    #[test]
    fn equals_the_plain_maximum(radii in prop::collection::vec(0.5..1.5f64, 42)) {
        let sphere = icosphere(1);
        let vertices: Vec<DVec3> = sphere.vertices().iter().zip(radii).map(|(&v, radius)| v * radius).collect();
        let solid = SolidMesh::new(TriangleMesh::new(vertices.clone(), sphere.triangles().to_vec()).unwrap()).unwrap();
        let mut largest = 0.0f64;
        for [a, b, c] in solid.mesh().corner_positions() {
            let normal = (b - a).cross(c - a).normalize();
            largest = vertices.iter().fold(largest, |l, &v| l.max(normal.dot(v - a)));
        }
        prop_assert!((convexity(&solid).excess - largest).abs() < 1e-12);
    }

    /// One vertex of a sphere pushed in makes a dent, however shallow it is above the tolerance.
    #[test]
    fn a_dent_is_found(vertex in 0usize..42, depth in -6.0..-0.5f64) {
        let sphere = icosphere(1);
        let mut vertices = sphere.vertices().to_vec();
        // Neighbours of a vertex of this mesh lie at most 0.16 below it, so this is below all their planes.
        vertices[vertex] *= 0.8 - 10f64.powf(depth);
        prop_assert!(!is_convex(TriangleMesh::new(vertices, sphere.triangles().to_vec()).unwrap()));
    }
}

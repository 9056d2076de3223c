//! Solids whose exact decomposition cuts off slivers: a step beside a tower whose top is not quite level with the other
//! step's, so that the plane of one top cuts a wedge off the other. Whatever its thickness, the solid has a shape; what
//! is kept of it has its extent; and it does not depend on the place, attitude and scale of the mesh.

use polhode_contact::mesh::{SolidMesh, TriangleMesh};
use polhode_contact::{Pose, Shape, aabb_of};
use polhode_spatial::{DVec3, Rotation};

/// A tower of height 2 between two steps of height 1, of depth 1; the outer border of the left step is `rise` higher at
/// the back than in front, m.
fn tower(rise: f64, scale: f64, pose: &Pose) -> SolidMesh {
    let profile = [(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0), (1.0, 1.0), (0.0, 1.0)];
    let front = profile.iter().map(|&(x, z)| DVec3::new(x, 0.0, z));
    let back = profile.iter().map(|&(x, z)| DVec3::new(x, 1.0, if (x, z) == (0.0, 1.0) { z + rise } else { z }));
    let vertices = front.chain(back).map(|p| pose.transform_point(scale * p)).collect();
    // Three boxes' fronts, two triangles each.
    let caps = [[0, 1, 2], [0, 2, 3], [0, 3, 6], [0, 6, 7], [6, 3, 4], [6, 4, 5]];
    let mut triangles: Vec<[u32; 3]> = caps.to_vec();
    triangles.extend(caps.map(|[a, b, c]| [c + 8, b + 8, a + 8]));
    for i in 0..8 {
        let j = (i + 1) % 8;
        triangles.extend([[j, i, i + 8], [j, i + 8, j + 8]]);
    }
    SolidMesh::new(TriangleMesh::new(vertices, triangles).expect("a mesh")).expect("a solid")
}

#[test]
fn a_solid_with_slivers_of_any_thickness_has_a_shape() {
    let turned = Rotation::from_rotation_vector(DVec3::new(0.4, -0.3, 0.9));
    for pose in [Pose::IDENTITY, Pose { rotation: turned, translation: DVec3::new(0.3, -2.0, 0.7) }] {
        for scale in [1e-3, 0.37, 1.0, 250.0] {
            for exponent in 4..17 {
                for factor in [1.0, 3.0, -2.0] {
                    let rise = factor * 10.0_f64.powi(-exponent);
                    let placed = Pose { translation: scale * pose.translation, ..pose };
                    let solid = tower(rise, scale, &placed);
                    let shape = Shape::solid(&solid).unwrap_or_else(|error| panic!("{rise} {scale}: {error}"));
                    // What is left out is thinner than 1e-9 of the size.
                    let (found, mesh) = (aabb_of(&shape, &Pose::IDENTITY).expect("a box"), solid.mesh().bounds());
                    let off = (found.max() - mesh.max).abs().max((found.min() - mesh.min).abs()).max_element();
                    assert!(off <= 4e-9 * scale, "{rise} {scale}: {off}");
                }
            }
        }
    }
}

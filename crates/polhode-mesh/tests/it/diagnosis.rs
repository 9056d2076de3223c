//! Every defect is found with its number and its first place, and a mesh without any is accepted.

use crate::shapes::{L_SHAPE, PYRAMID, icosphere, joined, mesh, torus};
use polhode_mesh::{
    Defect, DefectKind, Location, MeshError, SolidMesh, TriangleMesh, box_mesh, diagnose, hollow_mass_properties,
};
use polhode_spatial::{DVec3, Mass, Pose, Rotation};
use proptest::prelude::*;

/// The only defect of a mesh.
#[track_caller]
fn only(mesh: &TriangleMesh) -> Defect {
    let diagnosis = diagnose(mesh);
    assert_eq!(diagnosis.defects.len(), 1, "{diagnosis:?}");
    diagnosis.defects[0]
}

fn cube() -> TriangleMesh {
    box_mesh(DVec3::splat(2.0)).unwrap().into_mesh()
}

/// The mesh with its triangles replaced.
fn with_triangles(mesh: &TriangleMesh, f: impl FnOnce(&mut Vec<[u32; 3]>)) -> TriangleMesh {
    let mut triangles = mesh.triangles().to_vec();
    f(&mut triangles);
    TriangleMesh::new(mesh.vertices().to_vec(), triangles).unwrap()
}

#[test]
fn sound_meshes_have_no_defects() {
    for sound in [cube(), mesh(L_SHAPE), mesh(PYRAMID), icosphere(3), torus(16, 8)] {
        assert_eq!(diagnose(&sound).defects, []);
        assert!(SolidMesh::new(sound).is_ok());
    }
}

#[test]
fn a_missing_triangle_leaves_three_open_edges() {
    // Triangle 0 of a box is (0, 4, 6); the neighbour across 0-6 is triangle 1, which runs from 0 to 6.
    let open = with_triangles(&cube(), |triangles| {
        triangles.remove(0);
    });
    let defect = only(&open);
    assert_eq!((defect.kind, defect.count), (DefectKind::OpenEdge, 3));
    assert_eq!(defect.location, Location::Edge { from: 0, to: 6, triangle: 0 });
    assert_eq!(defect.to_string(), "3 open edges, first: edge 0-6 of triangle 0");
    let error = SolidMesh::new(open).unwrap_err();
    assert_eq!(error, MeshError::NotSolid(vec![defect]));
    assert_eq!(
        error.to_string(),
        "the mesh bounds no solid: 3 open edges, first: edge 0-6 of triangle 0 (indices count from 0)"
    );
}

#[test]
fn a_reversed_triangle_has_three_edges_of_inconsistent_winding() {
    let wrong = with_triangles(&cube(), |triangles| triangles[5].swap(0, 1));
    let defect = only(&wrong);
    assert_eq!((defect.kind, defect.count), (DefectKind::InconsistentWinding, 3));
    assert!(!diagnose(&wrong).is_solid());
}

#[test]
fn a_fin_makes_a_non_manifold_edge() {
    let mut vertices = cube().vertices().to_vec();
    vertices.push(DVec3::new(0.0, 0.0, 5.0));
    let mut triangles = cube().triangles().to_vec();
    triangles.push([4, 6, 8]);
    let fin = TriangleMesh::new(vertices, triangles).unwrap();
    let diagnosis = diagnose(&fin);
    let non_manifold = diagnosis.get(DefectKind::NonManifoldEdge).unwrap();
    assert_eq!((non_manifold.count, non_manifold.location), (1, Location::Edge { from: 4, to: 6, triangle: 0 }));
    assert_eq!(diagnosis.get(DefectKind::OpenEdge).unwrap().count, 2);
}

#[test]
fn an_inside_out_mesh_is_inverted() {
    let defect = only(&cube().flipped());
    assert_eq!(defect.kind, DefectKind::Inverted);
    assert_eq!(defect.location, Location::Component { first_triangle: 0, triangles: 12, volume: -8.0 });
}

/// Orientation is judged component by component: the total volume of this mesh is positive.
#[test]
fn one_inside_out_part_of_several_is_found() {
    let small = cube().scaled(0.1).unwrap();
    let parts = joined(&[
        &cube(),
        &small.translated(DVec3::X * 5.0).unwrap().flipped(),
        &small.translated(DVec3::X * 9.0).unwrap(),
    ]);
    let defect = only(&parts);
    assert_eq!((defect.kind, defect.count), (DefectKind::Inverted, 1));
    assert!(matches!(defect.location, Location::Component { first_triangle: 12, triangles: 12, .. }));
}

/// A part inside the bounding box of another, but not inside it, is no void: here in the notch of the L, touching it,
/// and in the hole of a torus.
#[test]
fn a_bounding_box_is_not_the_body() {
    let block = cube().scaled(0.5).unwrap().translated(DVec3::new(1.5, 1.5, 0.5)).unwrap();
    let parts = joined(&[&mesh(L_SHAPE), &block]);
    assert!(diagnose(&parts).is_solid());
    for (turn, distance) in [(0.3, 0.0), (1.0, 10.0), (-2.0, 1e6)] {
        let rotation = Rotation::from_rotation_vector(DVec3::new(turn, 2.0 * turn, -turn));
        let moved = parts.in_frame(&Pose::new(rotation, DVec3::new(1.0, -2.0, 0.7) * distance)).unwrap();
        assert!(diagnose(&moved).is_solid());
    }
    let ball = icosphere(1).scaled(0.2).unwrap();
    assert!(diagnose(&joined(&[&torus(32, 16), &ball])).is_solid());
    assert_eq!(only(&joined(&[&torus(32, 16), &ball.flipped()])).kind, DefectKind::Inverted);
}

/// Shells in shells: material, void, material, void. Each level needs the other direction.
#[test]
fn nested_shells_alternate() {
    let shell = |radius: f64| icosphere(1).scaled(radius).unwrap();
    let nested = joined(&[&shell(1.0), &shell(4.0), &shell(3.0).flipped(), &shell(2.0), &shell(1.5).flipped()]);
    assert!(diagnose(&nested).is_solid());
    // A void that faces outward would be counted as material twice.
    let doubled = joined(&[&shell(4.0), &shell(3.0)]);
    let defect = only(&doubled);
    assert_eq!((defect.kind, defect.count), (DefectKind::Inverted, 1));
    assert!(matches!(defect.location, Location::Component { first_triangle: 80, .. }));
}

/// Harmless defects are reported and do not prevent a solid.
#[test]
fn harmless_defects() {
    let mut vertices = cube().vertices().to_vec();
    vertices.extend([DVec3::splat(9.0), vertices[3]]);
    let mut triangles = cube().triangles().to_vec();
    triangles.push([2, 2, 5]);
    let untidy = TriangleMesh::new(vertices, triangles).unwrap();
    let lines: Vec<String> = diagnose(&untidy).defects.iter().map(ToString::to_string).collect();
    assert_eq!(
        lines,
        [
            "1 degenerate triangle, first: triangle 12",
            "2 unused vertices, first: vertex 8",
            "1 duplicate vertex, first: vertex 9, which repeats vertex 3",
        ]
    );
    assert!(SolidMesh::new(untidy).is_ok());
}

/// A triangle on a line is degenerate at any size and anywhere; a sliver whose height is a thousand roundings is not.
#[test]
fn degenerate_is_relative_to_rounding() {
    let triangle = |height: f64, at: f64, scale: f64| {
        let p = [DVec3::new(at, 0.0, 0.0), DVec3::new(at + 1.0, 0.0, 0.0), DVec3::new(at + 0.5, height, 0.0)];
        TriangleMesh::new(p.map(|p| p * scale).to_vec(), vec![[0, 1, 2]]).unwrap()
    };
    for scale in [1e-200, 1.0, 1e200] {
        assert!(diagnose(&triangle(0.0, 0.0, scale)).get(DefectKind::DegenerateTriangle).is_some());
        assert!(diagnose(&triangle(1e-12, 0.0, scale)).get(DefectKind::DegenerateTriangle).is_none());
        assert!(diagnose(&triangle(1e-12, 1e6, scale)).get(DefectKind::DegenerateTriangle).is_some());
    }
}

/// A doubled sheet is closed but encloses nothing, in any orientation and wherever it is.
#[test]
fn a_flat_closed_surface_has_no_volume() {
    for p in [[0.0, 0.0, 0.0], [0.1, 0.7, -0.3], [1e5, 3.3, 0.1]] {
        let sheet =
            [DVec3::ZERO, DVec3::new(1.0, 0.1, 0.3), DVec3::new(0.2, 1.1, -0.4)].map(|v| v + DVec3::from_array(p));
        let mesh = TriangleMesh::new(sheet.to_vec(), vec![[0, 1, 2], [2, 1, 0]]).unwrap();
        assert!(matches!(SolidMesh::new(mesh.clone()), Err(MeshError::NoVolume { .. })));
        assert!(hollow_mass_properties(&mesh, Mass::new(1.0).unwrap()).is_ok());
    }
}

#[test]
fn unreadable_meshes_are_refused() {
    let line = vec![DVec3::ZERO, DVec3::X];
    assert_eq!(TriangleMesh::new(line.clone(), vec![]), Err(MeshError::Empty));
    assert_eq!(
        TriangleMesh::new(line.clone(), vec![[0, 1, 1], [0, 1, 2]]),
        Err(MeshError::IndexOutOfRange { triangle: 1, index: 2, vertices: 2 })
    );
    let bad = vec![DVec3::ZERO, DVec3::new(0.0, f64::NAN, 0.0)];
    assert!(matches!(TriangleMesh::new(bad, vec![[0, 1, 1]]), Err(MeshError::NotFinite { index: 1, .. })));
    let cube = cube();
    assert!(matches!(cube.translated(DVec3::splat(f64::INFINITY)), Err(MeshError::NotFinite { .. })));
    assert_eq!(cube.scaled(0.0), Err(MeshError::Factor(0.0)));
    assert!(matches!(cube.scaled(f64::MAX).unwrap().scaled(2.0), Err(MeshError::NotFinite { .. })));
    let point = TriangleMesh::new(line, vec![[0, 0, 0]]).unwrap();
    assert_eq!(hollow_mass_properties(&point, Mass::new(1.0).unwrap()), Err(MeshError::NoArea(0.0)));
}

/// Coordinates near the ends of f64 give errors, never a panic or NaN.
#[test]
fn extreme_sizes_are_refused() {
    for scale in [1e-300, 1e-110, 1e110, 1e307] {
        let result = SolidMesh::new(cube().scaled(scale).unwrap());
        assert!(result.is_err() || result.is_ok_and(|solid| solid.volume_integrals().volume.is_finite()));
        let hollow = hollow_mass_properties(&cube().scaled(scale).unwrap(), Mass::new(1.0).unwrap());
        assert!(hollow.is_err() || hollow.is_ok_and(|body| body.inertia().matrix().is_finite()));
    }
}

proptest! {
    /// Whatever triangles are drawn among a few vertices, diagnosis answers, and what it calls a solid has a volume
    /// or is flat.
    #[test]
    fn any_mesh_is_diagnosed(
        points in prop::collection::vec((-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64), 4..7),
        triangles in prop::collection::vec((0u32..4, 0u32..4, 0u32..4), 1..12),
    ) {
        let points = points.into_iter().map(|(x, y, z)| DVec3::new(x, y, z)).collect();
        let mesh = TriangleMesh::new(points, triangles.into_iter().map(|(a, b, c)| [a, b, c]).collect()).unwrap();
        let diagnosis = diagnose(&mesh);
        prop_assert_eq!(&diagnosis, &diagnose(&mesh));
        match SolidMesh::new(mesh) {
            Ok(solid) => prop_assert!(diagnosis.is_solid() && solid.volume_integrals().volume > 0.0),
            Err(MeshError::NotSolid(_)) => prop_assert!(!diagnosis.is_solid()),
            Err(error) => prop_assert!(matches!(error, MeshError::NoVolume { .. }), "{}", error),
        }
    }

    /// Dropping or reversing any one triangle of a solid is always found, at that triangle's edges.
    #[test]
    fn every_single_fault_is_found(index in 0usize..80) {
        let sphere = icosphere(1);
        let open = with_triangles(&sphere, |triangles| {
            triangles.remove(index);
        });
        prop_assert_eq!(diagnose(&open).get(DefectKind::OpenEdge).map(|d| d.count), Some(3));
        let wrong = with_triangles(&sphere, |triangles| triangles[index].swap(1, 2));
        prop_assert_eq!(diagnose(&wrong).get(DefectKind::InconsistentWinding).map(|d| d.count), Some(3));
        prop_assert!(SolidMesh::new(wrong).is_err());
    }
}

//! Construction of polyhedra: hulls, meshes, boxes, and invalid input.

use crate::support::{Random, cuboid, prism_points};
use polhode_contact::{ConvexPolyhedron, Shape, ShapeError, Sphere};
use polhode_mesh::{SolidMesh, TriangleMesh};
use polhode_spatial::{DVec3, UnitVector};
use proptest::prelude::*;

/// Checks Euler's formula, outward normals, and the faces of edges.
fn check(p: &ConvexPolyhedron) {
    assert_eq!(p.vertices().len() + p.face_count(), p.edges().len() + 2);
    let size = p.size();
    for face in p.faces() {
        assert!((face.normal.length() - 1.0).abs() < 1e-14);
        for v in p.vertices() {
            assert!(face.normal.dot(*v) - face.offset <= 1e-9 * size);
        }
        for (i, &v) in face.vertices.iter().enumerate() {
            let edge = &p.edges()[face.edges[i] as usize];
            let next = face.vertices[(i + 1) % face.vertices.len()];
            assert!(edge.vertices == [v, next] || edge.vertices == [next, v]);
        }
    }
    for edge in p.edges() {
        let [left, right] = edge.faces.map(|f| p.face(f as usize).expect("a face").normal);
        assert!(left.cross(right).dot(edge.direction) > 0.0);
    }
}

/// Prisms have two faces with all corners and a side for each edge; a grid of points keeps its eight corners.
#[test]
fn hulls() {
    for sides in [3, 4, 5, 8, 32, 100] {
        for size in [1e-6, 1.0, 1e4] {
            let p = ConvexPolyhedron::from_points(&prism_points(sides, size, size)).expect("a prism");
            check(&p);
            assert_eq!((p.face_count(), p.vertices().len()), (sides as usize + 2, 2 * sides as usize));
        }
    }
    let grid: Vec<DVec3> =
        (0..1000).map(|i| DVec3::new(f64::from(i % 10), f64::from(i / 10 % 10), f64::from(i / 100))).collect();
    let p = ConvexPolyhedron::from_points(&grid).expect("a box");
    assert_eq!((p.face_count(), p.edges().len(), p.vertices().len()), (6, 12, 8));
    // A thin plate, which a hull with an absolute tolerance would take for flat.
    let plate: Vec<DVec3> = p.vertices().iter().map(|v| *v * DVec3::new(1.0, 1.0, 1e-6)).collect();
    check(&ConvexPolyhedron::from_points(&plate).expect("a plate"));
    // Duplicate points, exact or nearly so, become one vertex.
    let twice: Vec<DVec3> = p.vertices().iter().flat_map(|&v| [v, v, v + DVec3::splat(1e-12)]).collect();
    let p = ConvexPolyhedron::from_points(&twice).expect("a box");
    assert_eq!((p.face_count(), p.edges().len(), p.vertices().len()), (6, 12, 8));
    let mut random = Random(17);
    let ball: Vec<DVec3> = (0..400).map(|_| random.direction()).collect();
    let p = ConvexPolyhedron::from_points(&ball).expect("a ball of triangles");
    check(&p);
    assert_eq!(p.vertices().len(), 400);
}

/// A box as a triangle mesh, its faces cut into many triangles, is the box; a dented mesh is refused.
#[test]
fn meshes() {
    let corner = |i: u32| DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2 & 1));
    let mut vertices: Vec<DVec3> = (0..8).map(corner).collect();
    // The top is a fan about its middle.
    vertices.push(DVec3::new(0.5, 0.5, 1.0));
    let loops = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1]];
    let mut triangles: Vec<[u32; 3]> = loops.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    triangles.extend([[4, 5, 8], [5, 7, 8], [7, 6, 8], [6, 4, 8]]);
    let solid = |vertices: Vec<DVec3>| {
        SolidMesh::new(TriangleMesh::new(vertices, triangles.clone()).expect("a mesh")).expect("a solid")
    };
    let p = ConvexPolyhedron::from_mesh(&solid(vertices.clone())).expect("a box");
    check(&p);
    assert_eq!((p.face_count(), p.edges().len(), p.vertices().len()), (6, 12, 8));
    vertices[8].z = 0.9;
    let dented = ConvexPolyhedron::from_mesh(&solid(vertices.clone()));
    assert!(matches!(dented, Err(ShapeError::NotConvex { .. })), "{dented:?}");
    vertices[8].z = 1.1;
    let roof = ConvexPolyhedron::from_mesh(&solid(vertices)).expect("a box with a roof");
    check(&roof);
    assert_eq!((roof.face_count(), roof.vertices().len()), (9, 9));
}

/// A box's normals are exact, and moving it keeps them.
#[test]
fn boxes() {
    let Shape::Convex(p) = cuboid(0.3, 0.7, 1.1).translated(DVec3::new(0.1, 0.2, 0.3)).expect("moved") else {
        panic!("a box is a polyhedron")
    };
    check(&p);
    let normals: Vec<DVec3> = p.faces().map(|f| f.normal).collect();
    assert_eq!(normals, [DVec3::NEG_X, DVec3::X, DVec3::NEG_Y, DVec3::Y, DVec3::NEG_Z, DVec3::Z]);
    assert_eq!(p.face(1).expect("a face").offset, 0.15 + 0.1);
}

/// Invalid input gives an error that names the value.
#[test]
fn refusals() {
    assert!(matches!(Shape::cuboid(DVec3::new(1.0, 0.0, 1.0)), Err(ShapeError::TooSmall { value: 0.0, .. })));
    assert!(matches!(Shape::cuboid(DVec3::new(1.0, f64::NAN, 1.0)), Err(ShapeError::NotFinite { .. })));
    assert!(matches!(Shape::cuboid(DVec3::new(1.0, 1.0, 1e-12)), Err(ShapeError::Flat { .. })));
    assert!(matches!(Shape::sphere(-1.0), Err(ShapeError::TooSmall { value: -1.0, .. })));
    assert!(Sphere::new(DVec3::splat(f64::INFINITY), 1.0).is_err());
    assert!(matches!(Shape::points(vec![]), Err(ShapeError::TooFewPoints { .. })));
    assert!(Shape::half_space(UnitVector::X).translated(DVec3::splat(f64::NAN)).is_err());
    let flat: Vec<DVec3> = (0..9).map(|i| DVec3::new(f64::from(i % 3), f64::from(i / 3), 1.0)).collect();
    assert!(matches!(ConvexPolyhedron::from_points(&flat), Err(ShapeError::Flat { .. })));
    assert!(matches!(ConvexPolyhedron::from_points(&[DVec3::ONE; 5]), Err(ShapeError::Flat { .. })));
    assert!(ConvexPolyhedron::from_points(&[DVec3::ZERO, DVec3::X, DVec3::splat(f64::NAN), DVec3::Y]).is_err());
    let tetrahedron = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    let faces = |f: &[[u32; 3]]| f.iter().map(|l| l.to_vec()).collect::<Vec<_>>();
    let build = |f: &[[u32; 3]]| ConvexPolyhedron::from_faces(tetrahedron.clone(), faces(f));
    assert!(build(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]).is_ok());
    // Inside out, open, with inconsistent orientation, with an index out of range.
    assert!(matches!(build(&[[0, 1, 2], [0, 3, 1], [1, 3, 2], [0, 2, 3]]), Err(ShapeError::NotConvex { .. })));
    assert!(matches!(build(&[[0, 2, 1], [0, 1, 3], [1, 2, 3]]), Err(ShapeError::NotClosed { .. })));
    assert!(matches!(build(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 2, 3]]), Err(ShapeError::NotClosed { .. })));
    assert!(matches!(build(&[[0, 2, 1], [0, 1, 9], [1, 2, 3], [0, 3, 2]]), Err(ShapeError::NotClosed { .. })));
    let twice = build(&[[0, 2, 2], [0, 1, 3], [1, 2, 3], [0, 3, 2]]).expect_err("a vertex twice in a row").to_string();
    assert!(twice.contains("the same vertex twice in a row"), "{twice}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    /// Whatever points come (many on a coarse lattice, so that coplanar, collinear and equal points abound), the hull
    /// is a proper polyhedron that contains them, or an error; never a panic.
    #[test]
    fn hull_of_anything(
        points in prop::collection::vec((0_i32..5, 0_i32..5, 0_i32..4), 0..40),
        scale in prop::sample::select(vec![1e-9, 1.0, 1e7]),
    ) {
        let point = |(x, y, z)| DVec3::new(f64::from(x), f64::from(y), f64::from(z)) * scale;
        let points: Vec<DVec3> = points.into_iter().map(point).collect();
        if let Ok(p) = ConvexPolyhedron::from_points(&points) {
            check(&p);
        } else {
            // Only flat sets may fail.
            let first = points.first().copied().unwrap_or_default();
            let spans = points.iter().flat_map(|a| points.iter().map(move |b| (*a - first).cross(*b - first))).any(|n| {
                points.iter().any(|c| n.dot(*c - first).abs() > 1e-6 * scale * scale * scale)
            });
            prop_assert!(!spans, "{points:?}");
        }
    }
}

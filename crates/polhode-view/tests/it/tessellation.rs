//! Surfaces are closed, face outwards, and have the area and volume of their shapes.

use polhode::Geometry;
use polhode::contact::{ConvexPolyhedron, Shape};
use polhode::mesh::{Refinement, Torus, box_mesh};
use polhode::spatial::{DVec3, Pose, Rotation, UnitVector};
use polhode_view::MeshLibrary;
use polhode_view::surface_mesh::SurfaceMesh;
use polhode_view::tessellation::{Detail, parts_of, triangles};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// The parts of a shape as one surface in the body's frame.
fn surface(shape: &Geometry, segments: u32) -> SurfaceMesh {
    let mut library = MeshLibrary::default();
    let parts = parts_of(shape, Detail::new(segments), &mut library);
    let mut all = SurfaceMesh::default();
    for part in &parts.parts {
        let mesh = &library.meshes()[part.mesh];
        let first = all.positions.len() as u32;
        all.positions.extend(mesh.positions.iter().map(|&p| part.point(p)));
        all.normals.extend(mesh.normals.iter().map(|&n| part.normal(n)));
        all.triangles.extend(mesh.triangles.iter().map(|corners| corners.map(|corner| corner + first)));
    }
    all
}

fn area(mesh: &SurfaceMesh) -> f64 {
    mesh.corner_positions().map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length()).sum()
}

fn volume(mesh: &SurfaceMesh) -> f64 {
    mesh.corner_positions().map(|[a, b, c]| a.cross(b).dot(c) / 6.0).sum()
}

/// Every edge is run along once in each direction, with vertices in one place joined.
fn assert_closed(mesh: &SurfaceMesh) {
    let [low, high] = mesh.bounds().unwrap();
    let unit = 1e-9 * (high - low).length();
    let key = |p: DVec3| ((p - low) / unit).to_array().map(|x| x.round() as i64);
    let mut edges: BTreeMap<_, i32> = BTreeMap::new();
    for corners in mesh.corner_positions() {
        for k in 0..3 {
            let (a, b) = (key(corners[k]), key(corners[(k + 1) % 3]));
            assert_ne!(a, b, "a triangle has an edge without length");
            *edges.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
        }
    }
    assert!(edges.values().all(|&sum| sum == 0));
}

/// Normals are of unit length and lie on the outer side of their triangles.
fn assert_outward(mesh: &SurfaceMesh) {
    for corners in &mesh.triangles {
        let [a, b, c] = corners.map(|corner| mesh.positions[corner as usize]);
        let face = (b - a).cross(c - a).normalize();
        for corner in corners {
            let normal = mesh.normals[*corner as usize];
            assert!((normal.length() - 1.0).abs() < 1e-12);
            assert!(normal.dot(face) > 0.0, "{normal} {face}");
        }
    }
}

/// Closed, outward, and nearer to the closed forms by the square of the number of segments.
fn assert_shape(shape: Shape, expected_area: f64, expected_volume: f64) {
    let shape = Geometry::Shape(shape);
    let [coarse, fine] = [24, 96].map(|segments| surface(&shape, segments));
    let error = |mesh: &SurfaceMesh| {
        assert_closed(mesh);
        assert_outward(mesh);
        [(area(mesh) / expected_area - 1.0).abs(), (volume(mesh) / expected_volume - 1.0).abs()]
    };
    let (coarse, fine) = (error(&coarse), error(&fine));
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        assert!(coarse < 0.08 && fine < 0.005, "{coarse} {fine}");
        assert!(fine < 1e-12 || (14.0..18.0).contains(&(coarse / fine)), "{coarse} {fine}");
    }
}

#[test]
fn round_shapes() {
    let (r, h) = (0.5, 1.25);
    assert_shape(Shape::sphere(r).unwrap(), 4.0 * PI * r * r, 4.0 / 3.0 * PI * r * r * r);
    assert_shape(Shape::cylinder(r, h).unwrap(), 2.0 * PI * r * (r + h), PI * r * r * h);
    assert_shape(Shape::cone(r, h).unwrap(), PI * r * (r + r.hypot(h)), PI * r * r * h / 3.0);
    assert_shape(
        Shape::capsule(r, h).unwrap(),
        2.0 * PI * r * h + 4.0 * PI * r * r,
        PI * r * r * h + 4.0 / 3.0 * PI * r * r * r,
    );
    let (major, minor) = (0.75, 0.25);
    assert_shape(
        Shape::torus(major, minor).unwrap(),
        4.0 * PI * PI * major * minor,
        2.0 * PI * PI * major * minor * minor,
    );
}

#[test]
fn shapes_in_any_place() {
    let pose = Pose::new(Rotation::from_rotation_vector(DVec3::new(3.0, -0.5, 1.0)), DVec3::new(0.3, -2.0, 1.0));
    let (r, h) = (0.5, 1.25);
    let placed = |shape: Shape| shape.placed(&pose).unwrap();
    assert_shape(placed(Shape::cone(r, h).unwrap()), PI * r * (r + r.hypot(h)), PI * r * r * h / 3.0);
    assert_shape(placed(Shape::cylinder(r, h).unwrap()), 2.0 * PI * r * (r + h), PI * r * r * h);
    assert_shape(placed(Shape::torus(1.0, 0.25).unwrap()), PI * PI, PI * PI / 8.0);
    // An axis that points down exactly.
    let down = Pose::new(Rotation::from_rotation_vector(DVec3::X * PI), DVec3::ZERO);
    assert_shape(Shape::cone(r, h).unwrap().placed(&down).unwrap(), PI * r * (r + r.hypot(h)), PI * r * r * h / 3.0);
}

#[test]
fn polyhedra() {
    let size = DVec3::new(1.0, 0.5, 0.25);
    let box_shape = Shape::cuboid(size).unwrap();
    let (a, v) = (2.0 * (size.x * size.y + size.y * size.z + size.z * size.x), size.x * size.y * size.z);
    let turned = Pose::new(Rotation::from_rotation_vector(DVec3::new(0.4, 0.5, 0.6)), DVec3::ONE);
    for shape in [box_shape.clone(), box_shape.placed(&turned).unwrap()] {
        assert_shape(shape, a, v);
    }
    let corners: Vec<_> = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|axis| [axis, -axis]).collect();
    let octahedron = Shape::convex(ConvexPolyhedron::from_points(&corners).unwrap());
    assert_shape(octahedron, 4.0 * 3.0_f64.sqrt(), 4.0 / 3.0);
    let compound = Shape::compound(vec![box_shape.clone(), box_shape.placed(&turned).unwrap()]).unwrap();
    assert_shape(compound, 2.0 * a, 2.0 * v);
}

/// Many bodies of one form share a mesh; boxes and balls of any size too.
#[test]
fn meshes_are_shared() {
    let mut library = MeshLibrary::default();
    for size in [0.5, 1.0, 2.0] {
        for shape in [Shape::cuboid(DVec3::splat(size)), Shape::sphere(size), Shape::cylinder(size, 1.0)] {
            parts_of(&Geometry::Shape(shape.unwrap()), Detail::new(16), &mut library);
        }
    }
    assert_eq!(library.meshes().len(), 3);
    let plane = Geometry::Shape(Shape::half_space(UnitVector::Z));
    let parts = parts_of(&plane, Detail::new(16), &mut library);
    assert_eq!((parts.parts.len(), parts.half_spaces.len()), (0, 1));
}

/// A surface of triangles is smooth where it bends little and sharp where it bends much.
#[test]
fn surfaces_of_triangles() {
    let torus = Torus::new(1.0, 0.25).unwrap().mesh(Refinement::new(5).unwrap()).unwrap();
    let mesh = triangles::surface(torus.mesh().vertices(), torus.mesh().triangles());
    assert_closed(&mesh);
    assert_outward(&mesh);
    assert_eq!((mesh.lines.len(), mesh.positions.len()), (0, torus.mesh().vertices().len()));
    let cuboid = box_mesh(DVec3::ONE).unwrap();
    let mesh = triangles::surface(cuboid.mesh().vertices(), cuboid.mesh().triangles());
    assert_closed(&mesh);
    assert_outward(&mesh);
    assert_eq!((mesh.lines.len(), mesh.positions.len()), (12, 24));
}

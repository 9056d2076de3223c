//! Derivatives of the separation of every pair of elements of round shapes, by the same finite differences as those of
//! polyhedra.

use crate::derivatives::check_at;
use crate::support::{Random, cuboid, prism};
use polhode_contact::{ContactFeature, Shape, Side, SurfaceFeature};
use polhode_spatial::{DVec3, UnitVector};

/// Number of random poses for each pair. It is large because a rim crosses an edge twice at few of them.
pub(crate) const POSES: u32 = 200;

fn moved(shape: Result<Shape, polhode_contact::ShapeError>, by: DVec3) -> Shape {
    shape.and_then(|shape| shape.translated(by)).expect("a shape")
}

/// Every pair of elements, in both orders.
#[test]
fn of_every_pair_of_elements() {
    let mut random = Random(4321);
    each_pair_of_elements(|name, feature, a, b| check_at(POSES, name, feature, a, b, &mut random));
}

/// Calls `visit` with every pair of elements, in both orders.
pub(crate) fn each_pair_of_elements(mut visit: impl FnMut(&str, ContactFeature, &Shape, &Shape)) {
    use SurfaceFeature::{Cap, Edge, Face, Rim, RimEntry, RimExit, Side as Lateral, Sphere, Vertex};
    let capsule = moved(Shape::capsule(0.1, 0.6), DVec3::new(0.1, -0.05, 0.2));
    let cylinder = moved(Shape::cylinder(0.3, 0.5), DVec3::new(-0.1, 0.05, 0.1));
    let cone = moved(Shape::cone(0.3, 0.5), DVec3::new(0.05, 0.15, -0.1));
    let ring = moved(Shape::torus(0.3, 0.1), DVec3::new(0.05, -0.1, 0.1));
    let (cube, hexagon) = (cuboid(0.5, 0.4, 0.3), prism(6, 0.3, 0.4));
    let ball = moved(Shape::sphere(0.2), DVec3::new(-0.1, 0.2, 0.1));
    let cloud = Shape::points(vec![DVec3::new(0.3, 0.2, 0.1), DVec3::new(-0.2, 0.1, 0.4)]).expect("points");
    let up = UnitVector::new(DVec3::new(0.2, 0.3, 0.9)).expect("up");
    let floor = moved(Ok(Shape::half_space(up)), DVec3::Z * 0.3);
    let cases: [(&Shape, SurfaceFeature, &Shape, SurfaceFeature); 46] = [
        (&cylinder, Rim(0), &floor, Face(0)),
        (&cylinder, Vertex(3), &floor, Face(0)),
        (&cone, Vertex(0), &floor, Face(0)),
        (&cone, Rim(0), &cube, Face(2)),
        (&capsule, Cap(1), &cube, Face(2)),
        (&capsule, Cap(0), &hexagon, Edge(3)),
        (&capsule, Cap(0), &hexagon, Vertex(3)),
        (&capsule, Lateral(0), &hexagon, Edge(5)),
        (&capsule, Lateral(0), &hexagon, Vertex(5)),
        (&capsule, Lateral(0), &capsule, Lateral(0)),
        (&capsule, Lateral(0), &capsule, Cap(1)),
        (&capsule, Cap(0), &capsule, Cap(1)),
        (&capsule, Lateral(0), &cylinder, Lateral(0)),
        (&capsule, Lateral(0), &cylinder, Rim(1)),
        (&capsule, Cap(0), &cylinder, Rim(1)),
        (&capsule, Cap(0), &cylinder, Face(1)),
        (&capsule, Cap(0), &cone, Lateral(0)),
        (&capsule, Lateral(0), &cone, Lateral(0)),
        (&capsule, Lateral(0), &cone, Vertex(0)),
        (&cylinder, Lateral(0), &cube, Edge(4)),
        (&cylinder, Rim(1), &cube, Edge(4)),
        (&cylinder, Rim(1), &cube, Vertex(4)),
        (&cylinder, Face(1), &cube, Vertex(4)),
        (&cylinder, Lateral(0), &cylinder, Rim(1)),
        (&cylinder, Rim(0), &cylinder, Rim(1)),
        (&cylinder, Rim(0), &cylinder, Face(0)),
        (&cylinder, Rim(0), &cone, Lateral(0)),
        (&cylinder, Rim(0), &cone, Vertex(0)),
        (&cylinder, RimExit(1), &cube, Edge(4)),
        (&cylinder, RimEntry(1), &cube, Edge(2)),
        (&cylinder, RimExit(1), &cone, RimExit(0)),
        (&cone, Lateral(0), &cone, Lateral(0)),
        (&cone, Lateral(0), &cube, Edge(7)),
        (&cone, Lateral(0), &cube, Vertex(7)),
        (&cone, Lateral(0), &ball, Sphere),
        (&cone, Vertex(0), &ball, Sphere),
        (&cylinder, Rim(0), &ball, Sphere),
        (&cloud, Vertex(1), &cone, Lateral(0)),
        (&ring, Rim(0), &floor, Face(0)),
        (&ring, Rim(0), &hexagon, Edge(3)),
        (&ring, RimExit(0), &hexagon, Edge(5)),
        (&ring, Rim(0), &hexagon, Vertex(3)),
        (&ring, Rim(0), &cube, Face(1)),
        (&ring, Rim(0), &ring, Rim(0)),
        (&ring, Rim(0), &cone, Lateral(0)),
        (&ring, Vertex(5), &cylinder, Face(0)),
    ];
    for (first, feature, second, other) in cases {
        let name = format!("{feature:?} of {first:?}, {other:?} of {second:?}");
        visit(&name, ContactFeature::Elements { a: feature, b: other }, first, second);
        visit(&name, ContactFeature::Elements { a: other, b: feature }, second, first);
    }
}

/// The same for contacts whose names are those of polyhedra.
#[test]
fn of_contacts_named_as_those_of_polyhedra() {
    let mut random = Random(8765);
    let capsule = moved(Shape::capsule(0.1, 0.6), DVec3::new(0.1, -0.05, 0.2));
    let cylinder = moved(Shape::cylinder(0.3, 0.5), DVec3::new(-0.1, 0.05, 0.1));
    let cone = moved(Shape::cone(0.3, 0.5), DVec3::new(0.05, 0.15, -0.1));
    let cube = cuboid(0.5, 0.4, 0.3);
    let cap = ContactFeature::Smooth { center_of: Side::B, center: 1, against: SurfaceFeature::Face(3) };
    check_at(POSES, "cap on a face", cap, &cube, &capsule, &mut random);
    let sample = ContactFeature::VertexFace { vertex_of: Side::A, vertex: 11, face: 1 };
    check_at(POSES, "sample point on a face", sample, &cylinder, &cube, &mut random);
    let apex = ContactFeature::VertexFace { vertex_of: Side::B, vertex: 0, face: 0 };
    check_at(POSES, "apex on a disc", apex, &cylinder, &cone, &mut random);
    let corner = ContactFeature::VertexFace { vertex_of: Side::A, vertex: 2, face: 1 };
    check_at(POSES, "corner on a disc", corner, &cube, &cylinder, &mut random);
}

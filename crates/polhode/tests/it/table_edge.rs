//! Case RC-10 and Video 10 of the thesis: a box slides off the edge of a table.

use crate::support::{accurate, brick, run};
use polhode::contact::Shape;
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use polhode::{Body, Effects, EventKind, Geometry, Scene};
use std::f64::consts::FRAC_PI_2;

/// Tipping begins when the centre of mass passes the edge; the box leaves when the edge force has fallen to zero.
#[test]
fn box_leaves_the_table_when_the_edge_force_is_zero() {
    let table = Body::fixed("table")
        .geometry(Geometry::Shape(Shape::cuboid(DVec3::new(4.0, 2.0, 1.0)).unwrap()))
        .pose(Pose::from_translation(DVec3::new(-2.0, 0.0, -0.5)));
    let slider = brick("box", DVec3::new(1.0, 0.5, 0.5), DVec3::new(-0.5, 0.0, 0.25))
        .velocity(Velocity::new(DVec3::X, DVec3::ZERO));
    let scene =
        Scene::builder("box-off-table").method(accurate()).duration_s(1.0).body(table).body(slider).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let detached: Vec<_> = recorder.events.iter().filter(|event| event.kind == EventKind::Detach).collect();
    assert_eq!(detached.len(), 4, "{:?}", recorder.events);
    assert!((detached[0].t_s - 0.5).abs() < 1e-9, "{}", detached[0].t_s);
    assert!((detached[3].t_s - 0.5 - 0.406_228_978_0).abs() < 2e-9, "{}", detached[3].t_s);
    assert!(report.ledger.closure_relative() < 1e-12);
}

/// A box with its centre in the origin, as a mesh of twelve triangles.
fn plate_mesh(half: DVec3) -> Shape {
    let corner = |k: usize| {
        let sign = |bit: usize| if (k >> bit) & 1 == 1 { 1.0 } else { -1.0 };
        DVec3::new(sign(0), sign(1), sign(2)) * half
    };
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Shape::triangle_mesh((0..8).map(corner).collect(), triangles).unwrap()
}

/// A capsule or cylinder that lies along the edge of a table slides over it without friction. It holds on to the edge
/// with its whole length until the edge would have to pull. By energy, `v^2 = v0^2 + 2 g r (1 - cos b)` at the angle
/// `b` about the edge, and the force is zero where `v^2 = g r cos b`: its horizontal velocity is `sqrt(g r cos^3 b)`
/// from there on, and it does not turn. The edge may be one of a box, of a mesh, or of parts of a compound.
#[test]
fn a_body_that_lies_along_an_edge_holds_on_to_it_until_the_edge_would_have_to_pull() {
    let (g, radius, speed): (f64, f64, f64) = (9.81, 0.03, 0.2);
    let cosine = (speed * speed + 2.0 * g * radius) / (3.0 * g * radius);
    let leaves_with = (g * radius * cosine * cosine * cosine).sqrt();
    let part = |y: f64| Shape::cuboid(DVec3::new(2.0, 1.0, 0.2)).unwrap().translated(DVec3::Y * y).unwrap();
    let tables = [
        Shape::cuboid(DVec3::new(2.0, 2.0, 0.2)).unwrap(),
        plate_mesh(DVec3::new(1.0, 1.0, 0.1)),
        Shape::compound(vec![part(-0.5), part(0.5)]).unwrap(),
    ];
    let rollers = [Shape::capsule(radius, 0.1).unwrap(), Shape::cylinder(radius, 0.1).unwrap()];
    for (shape, table) in rollers.iter().flat_map(|shape| tables.iter().map(move |table| (shape, table))) {
        let table = Body::fixed("table")
            .geometry(Geometry::Shape(table.clone()))
            .pose(Pose::from_translation(DVec3::new(0.0, 0.0, -0.1)));
        let inertia = Inertia::from_diagonal(DVec3::new(4e-4, 4e-4, 1.35e-4)).unwrap();
        let lying = Rotation::from_rotation_vector(DVec3::X * FRAC_PI_2);
        let roller = Body::movable("roller", MassProperties::new(Mass::new(0.3).unwrap(), DVec3::ZERO, inertia))
            .geometry(Geometry::Shape(shape.clone()))
            .pose(Pose::new(lying, DVec3::new(0.99, 0.0, radius)))
            .velocity(Velocity::new(DVec3::new(speed, 0.05, 0.0), DVec3::ZERO));
        let builder = Scene::builder("over-an-edge").method(accurate()).duration_s(0.3);
        let (report, _) = run(&builder.body(table).body(roller).build().unwrap(), Effects::Planned);
        let velocity = report.bodies[1].state.velocity;
        assert!((velocity.linear.x - leaves_with).abs() < 1e-9, "{shape:?}: {velocity:?}, {leaves_with}");
        assert!((velocity.linear.y - 0.05).abs() < 1e-12, "{shape:?}: {velocity:?}");
        assert!(velocity.angular.length() < 1e-9, "{shape:?}: {velocity:?}");
    }
}

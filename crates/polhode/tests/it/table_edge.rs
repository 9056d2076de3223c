//! Case RC-10 and Video 10 of the thesis: a box slides off the edge of a table.

use crate::support::{accurate, brick, run};
use polhode::contact::Shape;
use polhode::spatial::{DVec3, Pose, Velocity};
use polhode::{Body, Effects, EventKind, Geometry, Scene};

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
    assert!((detached[0].t - 0.5).abs() < 1e-9, "{}", detached[0].t);
    assert!((detached[3].t - 0.5 - 0.406_228_978_0).abs() < 2e-9, "{}", detached[3].t);
    assert!(report.ledger.closure_relative() < 1e-12);
}

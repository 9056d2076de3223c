//! Planar motion: when the plan chooses it, and that it agrees with motion in space.

use crate::checks::{assert_closes, heavy_brick};
use crate::support::{accurate, elastic, run};
use polhode::contact::{ConvexPolyhedron, Shape};
use polhode::spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Decision, Effect, Effects, RunReport, Scene, SceneBuilder};

/// Rotates a world so that neither its vertical nor the normal of the plane of motion is a coordinate axis.
fn turned() -> Rotation {
    Rotation::from_rotation_vector(DVec3::new(0.4, -0.3, 0.8))
}

/// A box over a floor in a world turned by `world`, tipped about its own y axis by `tip`, after a turn about its z axis
/// by `twist`.
fn landing(world: Rotation, twist: f64, tip: f64, velocity: Velocity) -> SceneBuilder {
    let up = UnitVector::new(world.rotate(DVec3::Z)).unwrap();
    let own = Rotation::from_rotation_vector(DVec3::Z * twist) * Rotation::from_rotation_vector(DVec3::Y * tip);
    let pose = Pose::new(world * own, world.rotate(DVec3::Z * 0.4));
    let velocity = Velocity::new(world.rotate(velocity.linear), world.rotate(velocity.angular));
    Scene::builder("landing")
        .method(accurate())
        .gravity(world.rotate(DVec3::NEG_Z * 9.81))
        .duration_s(1.0)
        .body(Body::fixed("floor").geometry(Shape::half_space(up).into()).material(elastic(0.5)))
        .body(
            heavy_brick("box", 1.7, DVec3::new(0.4, 0.3, 0.2), DVec3::ZERO)
                .pose(pose)
                .velocity(velocity)
                .material(elastic(0.5)),
        )
}

fn is_planar(report: &RunReport) -> bool {
    let planar = report.plan.effects.iter().find(|effect| effect.effect == Effect::PlanarMotion);
    planar.is_some_and(|effect| effect.decision == Decision::On)
}

/// A box turned about the vertical by 30 degrees and tipped about its own axis moves in a plane that is no coordinate
/// plane, also in a rotated world. Its motion and its events are those of motion in space.
#[test]
fn box_in_a_tilted_plane_moves_as_in_space() {
    for (world, velocity) in [
        (Rotation::IDENTITY, DVec3::ZERO),
        (turned(), DVec3::ZERO),
        // Along the plane: the box's x axis after its twist.
        (turned(), DVec3::new((30.0_f64).to_radians().cos(), (30.0_f64).to_radians().sin(), 0.0) * 0.7),
    ] {
        let velocity = Velocity::new(velocity, DVec3::ZERO);
        let scene = landing(world, 30.0_f64.to_radians(), 0.35, velocity).build().unwrap();
        let (planned, found) = run(&scene, Effects::Planned);
        let (all, reference) = run(&scene, Effects::All);
        assert!(is_planar(&planned) && !is_planar(&all), "{:?}", planned.plan.effects);
        let (a, b) = (planned.bodies[1].state, all.bodies[1].state);
        assert!((a.pose.translation - b.pose.translation).length() < 1e-12, "{a:?} {b:?}");
        assert!(a.pose.rotation.angle_to(b.pose.rotation) < 1e-12, "{a:?} {b:?}");
        assert_eq!(found.events.len(), reference.events.len());
        for (x, y) in found.events.iter().zip(&reference.events) {
            // Each impact of the rattling magnifies the error of those before, by the ratio of the speeds.
            assert!(x.kind == y.kind && (x.t_s - y.t_s).abs() < 1e-11, "{x:?} {y:?}");
        }
        assert_closes(&planned);
    }
}

/// The plan chooses motion in space for a velocity of a nanometre a second out of the plane, or a turn of a nanoradian
/// out of it.
#[test]
fn motion_slightly_out_of_the_plane_is_in_space() {
    let along = Velocity::new(DVec3::X, DVec3::ZERO);
    assert!(is_planar(&run(&landing(Rotation::IDENTITY, 0.0, 0.35, along).build().unwrap(), Effects::Planned).0));
    let aside = Velocity::new(DVec3::new(1.0, 1e-9, 0.0), DVec3::ZERO);
    assert!(!is_planar(&run(&landing(Rotation::IDENTITY, 0.0, 0.35, aside).build().unwrap(), Effects::Planned).0));
    assert!(!is_planar(&run(&landing(Rotation::IDENTITY, 1e-9, 0.35, along).build().unwrap(), Effects::Planned).0));
    let spinning = Velocity::new(DVec3::ZERO, DVec3::new(0.0, 1.0, 1e-9));
    assert!(!is_planar(&run(&landing(Rotation::IDENTITY, 0.0, 0.35, spinning).build().unwrap(), Effects::Planned).0));
}

/// Fixed bodies count too: a step in the floor that is not symmetric about the plane of the box moves the box out of
/// it, and the plan chooses motion in space.
#[test]
fn asymmetric_fixed_body_makes_motion_in_space() {
    for (y, planar) in [(0.0, true), (1e-7, false)] {
        let block = Body::fixed("block")
            .geometry(Shape::cuboid(DVec3::new(0.2, 0.2, 0.1)).unwrap().into())
            .pose(Pose::from_translation(DVec3::new(0.1, y, 0.05)))
            .material(elastic(0.5));
        let scene = landing(Rotation::IDENTITY, 0.0, 0.3, Velocity::ZERO).body(block).build().unwrap();
        let (planned, _) = run(&scene, Effects::Planned);
        assert_eq!(is_planar(&planned), planar, "{y}");
        let (all, _) = run(&scene, Effects::All);
        let (a, b) = (planned.bodies[1].state, all.bodies[1].state);
        assert!((a.pose.translation - b.pose.translation).length() < 1e-11, "{y}: {a:?} {b:?}");
    }
}

/// A stack of boxes and a ball beside it, all in one plane.
#[test]
fn several_bodies_in_one_plane_move_as_in_space() {
    let size = DVec3::new(0.4, 0.3, 0.2);
    let tipped = Rotation::from_rotation_vector(DVec3::Y * 0.25);
    let scene = landing(Rotation::IDENTITY, 0.0, 0.35, Velocity::ZERO)
        .duration_s(1.0)
        .body(
            heavy_brick("second", 0.8, size, DVec3::ZERO)
                .pose(Pose::new(tipped, DVec3::new(0.15, 0.0, 0.9)))
                .material(elastic(0.3)),
        )
        .body(crate::support::ball("ball", 0.5, 0.1, DVec3::new(-0.6, 0.0, 0.5), DVec3::X).material(elastic(0.3)))
        .build()
        .unwrap();
    let (planned, found) = run(&scene, Effects::Planned);
    let (all, reference) = run(&scene, Effects::All);
    assert!(is_planar(&planned));
    // Every impact magnifies the rounding errors; the first half second holds three impacts.
    let half = found.times_s.iter().position(|&t| t >= 0.5).unwrap();
    for (a, b) in found.samples[half].iter().zip(&reference.samples[half]) {
        assert!((a.pose.translation - b.pose.translation).length() < 1e-11, "{a:?} {b:?}");
    }
    assert_closes(&planned);
    assert_closes(&all);
}

/// A regular tetrahedron, edge 1 m, on its base.
fn pyramid() -> ConvexPolyhedron {
    let (apex, base) = (0.375_f64.sqrt(), -(1.0_f64 / 24.0).sqrt());
    let (inner, outer) = ((1.0_f64 / 12.0).sqrt(), (1.0_f64 / 3.0).sqrt());
    let vertices = vec![
        DVec3::new(-0.5, inner, base),
        DVec3::new(0.5, inner, base),
        DVec3::new(0.0, -outer, base),
        DVec3::new(0.0, 0.0, apex),
    ];
    let faces = vec![vec![0, 1, 2], vec![1, 0, 3], vec![2, 1, 3], vec![0, 2, 3]];
    ConvexPolyhedron::from_faces(vertices, faces).unwrap()
}

/// A pyramid falls on the tip of another, tips over it, and a corner of its base comes to lie on an edge of the other,
/// in the plane of motion. Two edges meet at that corner, mirror images of each other, and either may be taken for the
/// nearest one. With neither may the corner pass through.
#[test]
fn a_corner_in_the_plane_of_motion_lands_as_in_space() {
    let properties = polhode::mesh::solid_box(DVec3::ONE, polhode::spatial::Mass::new(1.0).unwrap()).unwrap();
    for mirrored in [1.0, -1.0] {
        let half_turn =
            Rotation::from_rotation_vector(DVec3::Z * if mirrored > 0.0 { 0.0 } else { std::f64::consts::PI });
        let offset = DVec3::new(0.0, -0.1, 0.5) * DVec3::new(1.0, mirrored, 1.0);
        let scene = Scene::builder("pyramids")
            .method(accurate())
            .gravity(DVec3::NEG_Z * 9.8)
            .duration_s(1.0)
            .body(
                Body::fixed("below")
                    .geometry(Shape::convex(pyramid()).into())
                    .pose(Pose::new(half_turn, DVec3::Z * -0.5)),
            )
            .body(
                Body::movable("above", properties)
                    .geometry(Shape::convex(pyramid()).into())
                    .pose(Pose::new(half_turn, offset)),
            )
            .build()
            .unwrap();
        let (planned, found) = run(&scene, Effects::Planned);
        let (all, reference) = run(&scene, Effects::All);
        assert!(is_planar(&planned) && !is_planar(&all), "{:?}", planned.plan.effects);
        let impacts = |events: &[polhode::Event]| -> Vec<f64> {
            events.iter().filter(|event| event.kind == polhode::EventKind::Impact).map(|event| event.t_s).collect()
        };
        let (impacts, expected) = (impacts(&found.events), impacts(&reference.events));
        assert!(expected.len() >= 2, "{expected:?}");
        assert!((impacts[1] - expected[1]).abs() < 1e-11, "{impacts:?}, in space {expected:?}");
        let shape = Shape::convex(pyramid());
        for sample in &found.samples {
            let separation = polhode::contact::separation(&shape, &sample[0].pose, &shape, &sample[1].pose);
            assert!(separation > -2e-12, "{separation:e}");
        }
    }
}

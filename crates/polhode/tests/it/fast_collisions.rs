//! The tier `fast` where an impact is that of more than one row: a bounce of bodies that joints hold, friction without
//! restitution, seams of flush tiles, floors that are accelerated, and limits in loops.
//!
//! Oracles: the impact of bodies that are held together in closed form, the tier `accurate`, to the order of the step,
//! and Coulomb's law.

use crate::fast_joints::fast;
use crate::support::{ball, brick, floor};
use polhode::contact::Shape;
use polhode::scene::{Coordinate, Joint, Limits, Material, Method, PrescribedMotion, Tier};
use polhode::spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, Geometry, RunReport, Scene, SceneBuilder, Simulation};

fn material(friction: f64, restitution: f64) -> Material {
    Material::new("m").with_friction(friction).unwrap().with_restitution(restitution).unwrap()
}

fn accurate() -> Method {
    Method { tier: Some(Tier::Accurate), ..Method::default() }
}

fn run(scene: SceneBuilder) -> RunReport {
    Simulation::new(&scene.build().unwrap()).unwrap().run().unwrap()
}

fn place(report: &RunReport, body: usize) -> DVec3 {
    report.bodies[body].state.pose.translation
}

/// A ball with another one welded on top of it falls upright on a floor: both leave at `-e` times the speed of
/// approach, whatever hangs on the one that is struck.
#[test]
fn what_a_joint_holds_bounces_with_what_is_struck() {
    for (restitution, above) in [(0.5, 1.0), (1.0, 1.0), (1.0, 30.0), (0.8, 1000.0), (0.0, 5.0)] {
        let own = |name: &str, mass: f64, z: f64| {
            ball(name, mass, 0.1, DVec3::Z * z, DVec3::Z * -2.0).material(material(0.0, restitution))
        };
        let scene = Scene::builder("two balls").method(fast(1.0 / 60.0)).duration_s(0.2).gravity(DVec3::ZERO);
        let scene = scene.body(floor().material(material(0.0, restitution))).body(own("low", 1.0, 0.2));
        let scene = scene.body(own("high", above, 0.5));
        let weld = Joint::new(polhode::scene::JointKind::Fixed, BodyId::new(1), DVec3::Z * 0.3).with(BodyId::new(2));
        let report = run(scene.joint(weld));
        for body in [1, 2] {
            let speed = report.bodies[body].state.velocity.linear.z;
            assert!((speed - 2.0 * restitution).abs() < 1e-4, "{restitution}, {above} kg: {speed}");
        }
    }
}

/// Two rods on a hinge, one of which hits a rough floor with its end: as in the tier `accurate`, the better the shorter
/// the step is.
#[test]
fn a_jointed_rod_that_hits_a_rough_floor_moves_as_in_the_accurate_tier() {
    let end = |method: Method, (friction, restitution): (f64, f64)| {
        let rod = |name: &str, at: f64| {
            let own = brick(name, DVec3::new(0.5, 0.08, 0.06), DVec3::ZERO).material(material(friction, restitution));
            let turn = Rotation::from_rotation_vector(DVec3::Y * 0.5);
            own.pose(Pose::new(turn, turn.rotate(DVec3::X * at) + DVec3::Z * 0.6))
                .velocity(Velocity::new(DVec3::new(0.4, 0.2, -2.0), DVec3::ZERO))
        };
        let joint_at = Rotation::from_rotation_vector(DVec3::Y * 0.5).rotate(DVec3::X * 0.3) + DVec3::Z * 0.6;
        let scene = Scene::builder("rods").method(method).duration_s(0.13);
        let scene =
            scene.body(floor().material(material(friction, restitution))).body(rod("a", 0.0)).body(rod("b", 0.6));
        let hinge = Joint::hinge(BodyId::new(1), joint_at, UnitVector::Y).with(BodyId::new(2));
        place(&run(scene.joint(hinge).no_contact([1, 2].map(BodyId::new))), 1)
    };
    for of in [(0.0, 0.5), (0.3, 0.5), (0.9, 0.0), (0.0, 0.0)] {
        let exact = end(accurate(), of);
        for step_s in [0.004, 0.001] {
            let error = (end(fast(step_s), of) - exact).length();
            assert!(error < 3.0 * step_s, "{of:?} {step_s}: {error} m");
        }
    }
}

/// A brick that hits a rough floor with a corner or flat, without restitution: slip turns, and may end, along the
/// impulse.
#[test]
fn friction_of_an_impact_without_restitution_is_that_of_the_whole_impact() {
    let end = |method: Method, turn: DVec3, friction: f64| {
        let own = brick("brick", DVec3::new(0.4, 0.3, 0.2), DVec3::ZERO).material(material(friction, 0.0));
        let own = own.pose(Pose::new(Rotation::from_rotation_vector(turn), DVec3::Z * 0.35));
        let own = own.velocity(Velocity::new(DVec3::new(-1.5, 0.4, -3.0), DVec3::ZERO));
        let scene = Scene::builder("brick").method(method).duration_s(0.07);
        run(scene.body(floor().material(material(friction, 0.0))).body(own)).bodies[1].state.velocity
    };
    for turn in [DVec3::ZERO, DVec3::new(0.3, 0.6, 1.0), DVec3::new(-0.8, 0.2, 0.4)] {
        for friction in [0.3, 0.8] {
            let exact = end(accurate(), turn, friction);
            let found = end(fast(0.0005), turn, friction);
            let error = (found.linear - exact.linear).length() + 0.2 * (found.angular - exact.angular).length();
            assert!(error < 0.02, "{turn} {friction}: {found:?}, not {exact:?}");
        }
    }
}

/// Tiles of this length side by side, whose upper sides are one plane.
fn tiles(length: f64, count: u32, turn: Rotation) -> SceneBuilder {
    let mut scene = Scene::builder("tiles").method(fast(1.0 / 60.0)).duration_s(1.0);
    for k in 0..count {
        let center = turn.rotate(DVec3::new(length * (f64::from(k) + 0.5), 0.0, -0.1));
        let shape = Geometry::Shape(Shape::cuboid(DVec3::new(length, 2.0, 0.2)).unwrap());
        let tile = Body::fixed(format!("tile {k}")).geometry(shape).pose(Pose::new(turn, center));
        scene = scene.body(tile.material(material(0.0, 0.0)));
    }
    scene
}

/// What slides over flush tiles does not trip at their seams, whatever it is and however they are turned about the
/// vertical.
#[test]
fn flush_tiles_are_one_surface() {
    let shapes = [
        (Shape::cylinder(0.08, 0.05).unwrap(), 0.025),
        (Shape::cuboid(DVec3::new(0.12, 0.1, 0.06)).unwrap(), 0.03),
        (Shape::sphere(0.05).unwrap(), 0.05),
    ];
    for (shape, height) in shapes {
        for angle in [0.0, 0.7] {
            let turn = Rotation::from_rotation_vector(DVec3::Z * angle);
            for count in [3, 8] {
                let own = brick("puck", DVec3::splat(0.1), DVec3::ZERO).geometry(Geometry::Shape(shape.clone()));
                let own = own.pose(Pose::new(turn, turn.rotate(DVec3::new(0.15, 0.1, height))));
                let along = turn.rotate(DVec3::X);
                let own = own.velocity(Velocity::new(along * 1.1, DVec3::Z * 0.4)).material(material(0.0, 0.0));
                let report = run(tiles(2.0 / f64::from(count), count, turn).body(own));
                let body = count as usize;
                let speed = report.bodies[body].state.velocity.linear;
                assert!((speed - along * 1.1).length() < 1e-6, "{shape:?} {count} {angle}: {speed}");
                assert!((place(&report, body).z - height).abs() < 1e-3, "{shape:?} {count}: {}", place(&report, body));
            }
        }
    }
}

/// The foot of a wall that stands on the floor is a wall: a box that slides against it stops.
#[test]
fn a_wall_on_the_floor_is_no_seam() {
    for below in [0.0, 0.05] {
        let slab = Geometry::Shape(Shape::cuboid(DVec3::new(4.0, 4.0, 0.2)).unwrap());
        let ground = Body::fixed("ground").geometry(slab).pose(Pose::from_translation(DVec3::Z * -0.1));
        let wall = Geometry::Shape(Shape::cuboid(DVec3::new(0.2, 2.0, 0.5 + below)).unwrap());
        let at = DVec3::new(0.6, 0.0, 0.5 * (0.5 - below));
        let wall = Body::fixed("wall").geometry(wall).pose(Pose::from_translation(at)).material(material(0.0, 0.0));
        let own = brick("box", DVec3::splat(0.2), DVec3::Z * 0.1).material(material(0.0, 0.0));
        let own = own.velocity(Velocity::new(DVec3::X * 2.0, DVec3::ZERO));
        let scene = Scene::builder("wall").method(fast(1.0 / 60.0)).duration_s(1.0);
        let report = run(scene.body(ground.material(material(0.0, 0.0))).body(wall).body(own));
        assert!((place(&report, 2) - DVec3::new(0.4, 0.0, 0.1)).length() < 2e-3, "{}", place(&report, 2));
        assert!(report.bodies[2].state.velocity.linear.length() < 1e-3, "{:?}", report.bodies[2].state);
    }
}

/// Friction on a floor that is accelerated is `mu` times what presses there: the surface that a contact sees does not
/// change within a substep.
#[test]
fn a_floor_that_falls_away_gives_no_more_friction_than_its_load() {
    let end = |method: Method| {
        let motion = PrescribedMotion::sine(DVec3::Z * 0.03, DVec3::ZERO, 2.0, 0.0).unwrap();
        let slab = Geometry::Shape(Shape::cuboid(DVec3::new(4.0, 4.0, 0.2)).unwrap());
        let ground = Body::kinematic("ground", motion).geometry(slab).pose(Pose::from_translation(DVec3::Z * -0.1));
        let own = brick("box", DVec3::new(0.3, 0.3, 0.1), DVec3::Z * 0.05).material(material(0.7, 0.0));
        let rise = 0.03 * 2.0 * std::f64::consts::TAU;
        let own = own.velocity(Velocity::new(DVec3::new(0.0, 1.0, rise), DVec3::ZERO));
        let scene = Scene::builder("floor").method(method).duration_s(0.1);
        place(&run(scene.body(ground.material(material(0.7, 0.0))).body(own)), 1)
    };
    let exact = end(accurate());
    let errors = [0.004, 0.001].map(|step_s| (end(fast(step_s)) - exact).length());
    assert!(errors[0] < 2e-3 && errors[1] < 0.4 * errors[0], "{errors:?}");
}

/// A four-bar that comes to a limit of its crank goes on as in the tier `accurate`.
#[test]
fn a_loop_that_comes_to_a_limit_moves_as_in_the_accurate_tier() {
    let end = |method: Method| {
        let links = [(DVec3::ZERO, DVec3::new(0.1, 0.0, 0.4)), (DVec3::new(0.1, 0.0, 0.4), DVec3::new(0.7, 0.0, 0.5))];
        let links = [links[0], links[1], (links[1].1, DVec3::new(0.6, 0.0, 0.0))];
        let mut scene = Scene::builder("four-bar").method(method).duration_s(0.5);
        for (k, (from, to)) in links.into_iter().enumerate() {
            let length = (to - from).length();
            let own = brick(&format!("link {k}"), DVec3::new(length, 0.05, 0.05), DVec3::ZERO);
            let along = (to - from) / length;
            let turn = Rotation::from_rotation_vector(DVec3::Y * libm::atan2(-along.z, along.x));
            scene = scene.body(own.pose(Pose::new(turn, (from + to) * 0.5)));
        }
        let hinge = |body: usize, at: DVec3| Joint::hinge(BodyId::new(body), at, UnitVector::Y);
        let stop = Limits::new(-0.2, 0.2).unwrap();
        scene = scene.joint(hinge(0, links[0].0).with_limits(Coordinate::Angle, stop));
        scene = scene.joint(hinge(1, links[1].0).with(BodyId::new(0)));
        scene = scene.joint(hinge(2, links[2].0).with(BodyId::new(1))).joint(hinge(2, links[2].1));
        place(&run(scene.no_contact([0, 1, 2].map(BodyId::new))), 1)
    };
    let exact = end(accurate());
    for step_s in [0.004, 0.001] {
        let error = (end(fast(step_s)) - exact).length();
        assert!(error < 2.0 * step_s, "{step_s}: {error} m");
    }
}

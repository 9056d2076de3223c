//! The tier `fast` keeps what holds a scene together: what has parts lies on what is below it, whatever the gap that it
//! falls through; symmetric blows turn
//! nothing; a smooth level floor gives no horizontal momentum; a load stays on a turntable to the order of the
//! substeps; joints hold whatever hangs on them;
//!
//! Oracles: statics, symmetry, and the circle of a body that is carried. The last substep of a fall is not followed
//! exactly, so that heights have the order of a step.

use crate::fast_joints::{fast, run};
use crate::support::{ball, brick, floor};
use polhode::contact::Shape;
use polhode::scene::{Joint, JointKind, Material, PrescribedMotion};
use polhode::spatial::{DVec3, Pose, Velocity};
use polhode::{Body, BodyId, Geometry, RunReport, Scene, SceneBuilder};

const STEP_S: f64 = 1.0 / 60.0;

fn material(friction: f64, restitution: f64) -> Material {
    Material::new("m").with_friction(friction).unwrap().with_restitution(restitution).unwrap()
}

fn place(report: &RunReport, body: usize) -> DVec3 {
    report.bodies[body].state.pose.translation
}

/// Two cuboids side by side, as one body of mass one.
fn dumbbell(center: DVec3) -> Body {
    let part = |x: f64| Shape::cuboid(DVec3::splat(0.1)).unwrap().translated(DVec3::X * x).unwrap();
    let shape = Shape::compound(vec![part(-0.1), part(0.1)]).unwrap();
    brick("dumbbell", DVec3::new(0.3, 0.1, 0.1), center).geometry(Geometry::Shape(shape))
}

/// A square of two triangles in the plane `z = 0`: an open mesh.
fn sheet(half: f64) -> Shape {
    let corner = |x: f64, y: f64| DVec3::new(x * half, y * half, 0.0);
    let corners = vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    Shape::triangle_mesh(corners, vec![[0, 1, 2], [0, 2, 3]]).unwrap()
}

/// A compound on a floor, and a box on an open mesh, lie where they should however far above they begin.
#[test]
fn what_has_parts_falls_through_no_floor() {
    for gap in [0.0, 0.004, 0.02, 0.1, 0.7] {
        let scene = || Scene::builder("fall").method(fast(STEP_S)).duration_s(1.2);
        let compound = scene().body(floor()).body(dumbbell(DVec3::Z * (0.05 + gap)));
        let on_mesh = scene().body(Body::fixed("sheet").geometry(Geometry::Shape(sheet(1.0)))).body(brick(
            "box",
            DVec3::splat(0.1),
            DVec3::new(0.1, 0.2, 0.05 + gap),
        ));
        for scene in [compound, on_mesh] {
            let height = place(&run(scene), 1).z;
            assert!((height - 0.05).abs() < 1e-3, "from {gap}: {height}");
        }
    }
}

/// Bodies that land flat do not turn, with any restitution, shape and speed.
#[test]
fn a_symmetric_blow_turns_nothing() {
    let sizes = [DVec3::splat(0.4), DVec3::new(0.6, 0.3, 0.1), DVec3::new(1.0, 0.7, 0.02), DVec3::new(0.1, 0.1, 0.5)];
    for (size, restitution) in sizes.into_iter().flat_map(|size| [0.0, 0.5, 1.0].map(|e| (size, e))) {
        for speed in [0.0, 5.0] {
            let body = brick("body", size, DVec3::Z * (0.5 * size.z + 0.3)).material(material(0.5, restitution));
            let body = body.velocity(Velocity::new(DVec3::Z * -speed, DVec3::ZERO));
            let scene = Scene::builder("flat").method(fast(STEP_S)).duration_s(0.35);
            let report = run(scene.body(floor().material(material(0.5, restitution))).body(body));
            let velocity = report.bodies[1].state.velocity;
            assert!(velocity.angular.length() < 1e-9, "{size} {restitution} {speed}: {velocity:?}");
            assert!(velocity.linear.with_z(0.0).length() < 1e-6, "{size} {restitution} {speed}: {velocity:?}");
        }
    }
}

/// What rests or slides on a smooth level floor, a half-space or a table, gets no horizontal momentum; a smooth stack
/// stands.
#[test]
fn a_smooth_level_floor_gives_no_horizontal_momentum() {
    let table = || {
        let shape = Shape::cuboid(DVec3::new(3.0, 3.0, 0.2)).unwrap();
        Body::fixed("table").geometry(Geometry::Shape(shape)).pose(Pose::from_translation(DVec3::Z * -0.1))
    };
    for (count, below) in [(1, floor()), (1, table()), (5, floor()), (5, table())] {
        let mut scene = Scene::builder("smooth").method(fast(STEP_S)).duration_s(3.0);
        scene = scene.body(below.material(material(0.0, 0.0)));
        for k in 0..count {
            let center = DVec3::Z * (0.1 + 0.2 * f64::from(k));
            scene = scene.body(brick(&format!("b{k}"), DVec3::splat(0.2), center).material(material(0.0, 0.0)));
        }
        let report = run(scene);
        for k in 1..=count as usize {
            let place = place(&report, k);
            assert!(place.with_z(0.0).length() < 1e-9, "{count} {k}: {place}");
        }
    }
}

/// A load on a turntable: how far it is from where it is carried to.
fn off_the_circle(substeps: u32) -> f64 {
    let (rate, duration) = (2.0_f64, 1.0);
    let turning = PrescribedMotion::constant_velocity(Velocity::new(DVec3::ZERO, DVec3::Z * rate)).unwrap();
    let disc = Shape::cylinder(2.0, 0.2).unwrap();
    let table =
        Body::kinematic("table", turning).geometry(Geometry::Shape(disc)).pose(Pose::from_translation(DVec3::Z * -0.1));
    let load = brick("load", DVec3::splat(0.1), DVec3::new(1.0, 0.0, 0.05));
    let load = load.velocity(Velocity::new(DVec3::Y * rate, DVec3::Z * rate));
    let method = polhode::scene::Method { substeps: Some(substeps), ..fast(STEP_S) };
    let scene = Scene::builder("turntable").method(method).duration_s(duration);
    let report = run(scene.body(table.material(material(0.5, 0.0))).body(load.material(material(0.5, 0.0))));
    let (sine, cosine) = (rate * duration).sin_cos();
    (place(&report, 1) - DVec3::new(cosine, sine, 0.05)).with_z(0.0).length()
}

/// Where a load is on a moving surface is found anew in each substep: the error falls with these.
#[test]
fn a_load_stays_on_a_turntable_to_the_order_of_the_substeps() {
    let errors = [2, 4, 8, 16].map(off_the_circle);
    assert!(errors[1] < 5e-3, "{errors:?}");
    assert!(errors.windows(2).all(|pair| pair[1] < 0.65 * pair[0]), "{errors:?}");
}

/// Links in a row of this kind, with a load at the end; along x, so that welded ones bear it as a beam, or down.
fn hung(links: u32, load: f64, kind: JointKind, along: DVec3) -> SceneBuilder {
    let mut scene = Scene::builder("hung").method(fast(STEP_S)).duration_s(1.0);
    for k in 0..links {
        let center = along * (0.1 + 0.2 * f64::from(k));
        scene = scene.body(brick(&format!("link {k}"), DVec3::splat(0.05) + along.abs() * 0.1, center));
    }
    let end = 0.2 * f64::from(links);
    scene = scene.body(ball("load", load, 0.1, along * (end + 0.1), DVec3::ZERO));
    for k in 0..=links as usize {
        let joint = Joint::new(kind, BodyId::new(k), along * (0.2 * k as f64));
        scene = scene.joint(if k == 0 { joint } else { joint.with(BodyId::new(k - 1)) });
    }
    scene
}

/// Joints that close no loop hold what hangs on them at large ratios of masses.
#[test]
fn a_heavy_load_hangs_on_light_links() {
    for (links, load) in [(2, 2000.0), (8, 100.0)] {
        let down = hung(links, load, JointKind::Ball, -DVec3::Z);
        let beam = hung(links, load, JointKind::Fixed, DVec3::X);
        for scene in [down, beam] {
            let report = run(scene);
            let open = report.certificate.max_joint_error_m.unwrap();
            assert!(open < 1e-6, "{links} links, {load} kg: {open}");
        }
    }
}

//! Planar motion with friction: bodies that slide, tip, fall and roll in a plane move there as they do in space, in any
//! attitude of the world and in its mirror image; and bodies that leave the plane, or may be wedged out of it, are left
//! in space.
//!
//! In the plane Coulomb's cone is an interval, and a contact stands for its mirror image too. That changes the numbers
//! that are solved for, and must not change the motion: 1e-12 of positions (m) and attitudes (rad) over a second.

use crate::checks::{assert_closes, heavy_brick};
use crate::support::{accurate, ball, run};
use polhode::contact::{ConvexPolyhedron, Shape};
use polhode::scene::Material;
use polhode::spatial::{DVec3, Mass, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Decision, Effect, Effects, EventKind, Recorder, RunReport, Scene, SceneBuilder, Simulation};

/// Most that positions (m) and attitudes (rad) may differ after a second.
const SAME: f64 = 1e-12;

/// Neither the vertical nor the normal of the plane is a coordinate axis.
fn turned() -> Rotation {
    Rotation::from_rotation_vector(DVec3::new(0.4, -0.3, 0.8))
}

fn rough(friction: f64, restitution: f64) -> Material {
    Material::new("rough").with_friction(friction).unwrap().with_restitution(restitution).unwrap()
}

/// A box of 0.4 x 0.3 x 0.2 m, the middle edge along the normal of the plane, tipped by an angle in the plane.
fn cube(name: &str, place: DVec3, tip: f64, velocity: Velocity) -> Body {
    heavy_brick(name, 1.7, DVec3::new(0.4, 0.3, 0.2), DVec3::ZERO)
        .pose(Pose::new(Rotation::from_rotation_vector(DVec3::Y * tip), place))
        .velocity(velocity)
}

fn along(speed: f64) -> Velocity {
    Velocity::new(DVec3::X * speed, DVec3::ZERO)
}

/// Bodies of the plane y = 0 over a floor, in a world that is turned and, if asked for, mirrored in x = 0.
#[derive(Debug, Clone, Copy)]
struct View {
    turn: Rotation,
    mirror: f64,
}

const PLAIN: View = View { turn: Rotation::IDENTITY, mirror: 1.0 };

impl View {
    fn point(&self, x: DVec3) -> DVec3 {
        self.turn.rotate(x * DVec3::new(self.mirror, 1.0, 1.0))
    }

    /// A rotation about y, seen in a mirror, has the other sense.
    fn axial(&self, w: DVec3) -> DVec3 {
        self.turn.rotate(w * DVec3::new(1.0, self.mirror, self.mirror))
    }

    fn body(&self, body: Body, place: DVec3, tip: f64, velocity: Velocity) -> Body {
        let own = Rotation::from_rotation_vector(DVec3::Y * (tip * self.mirror));
        body.pose(Pose::new(self.turn * own, self.point(place)))
            .velocity(Velocity::new(self.point(velocity.linear), self.axial(velocity.angular)))
    }

    fn over_floor(&self, slope: f64, material: &Material) -> SceneBuilder {
        let up = UnitVector::new(self.turn.rotate(DVec3::Z)).unwrap();
        let gravity = self.point(DVec3::new(slope.sin(), 0.0, -slope.cos()) * 9.81);
        let floor = Body::fixed("floor").geometry(Shape::half_space(up).into()).material(material.clone());
        Scene::builder("plane").method(accurate()).gravity(gravity).duration_s(1.0).body(floor)
    }
}

/// What moves, and how: bodies with their place, tip and velocity in the plane.
struct Motion {
    name: &'static str,
    slope: f64,
    material: Material,
    bodies: Vec<(Body, DVec3, f64, Velocity)>,
}

impl Motion {
    fn scene(&self, view: View) -> Scene {
        let scene = view.over_floor(self.slope, &self.material);
        let bodies = self.bodies.iter().cloned();
        let bodies = bodies.map(|(body, place, tip, velocity)| view.body(body, place, tip, velocity));
        bodies.fold(scene, |scene, body| scene.body(body.material(self.material.clone()))).build().unwrap()
    }
}

fn one(name: &'static str, material: Material, slope: f64, place: DVec3, tip: f64, velocity: Velocity) -> Motion {
    let body = cube("box", DVec3::ZERO, 0.0, Velocity::ZERO);
    Motion { name, slope, material, bodies: vec![(body, place, tip, velocity)] }
}

fn wheel(name: &str, mass: f64, radius: f64, width: f64) -> Body {
    let shape = Shape::Cylinder(
        polhode::contact::Cylinder::new(DVec3::ZERO, UnitVector::new(DVec3::Y).unwrap(), radius, width).unwrap(),
    );
    let across = mass * (radius * radius / 4.0 + width * width / 12.0);
    let inertia =
        polhode::spatial::Inertia::from_diagonal(DVec3::new(across, mass * radius * radius / 2.0, across)).unwrap();
    let properties = polhode::spatial::MassProperties::new(Mass::new(mass).unwrap(), DVec3::ZERO, inertia);
    Body::movable(name, properties).geometry(shape.into())
}

fn motions() -> Vec<Motion> {
    let flat = DVec3::Z * 0.1;
    let standing = DVec3::Z * 0.2;
    let upright = std::f64::consts::FRAC_PI_2;
    let spin = |w: f64| DVec3::Y * w;
    let resisting = rough(0.5, 0.0).with_rotational_friction(0.004, 0.01).unwrap();
    let held = rough(0.3, 0.0).with_static_friction(0.5).unwrap();
    let stack = |name: &str| cube(name, DVec3::ZERO, 0.0, Velocity::ZERO);
    vec![
        one("slides and stops", rough(0.3, 0.0), 0.0, flat, 0.0, along(1.2)),
        one("slides up a slope, stops and slides back", rough(0.2, 0.0), 0.4, flat, 0.0, along(-1.5)),
        one("stops on a slope that static friction holds", held, 0.4, flat, 0.0, along(-1.0)),
        one("stumbles and tips over", rough(0.8, 0.0), 0.0, standing, upright, along(3.0)),
        one("stumbles and does not fall", rough(0.6, 0.0), 0.0, standing, upright, along(1.5)),
        one("falls on an edge and slips", rough(0.1, 0.0), 0.0, DVec3::Z * 0.5, 0.5, along(0.4)),
        one("falls on an edge and bounces", rough(0.4, 0.3), 0.0, DVec3::Z * 0.4, 0.7, along(0.3)),
        Motion {
            name: "a ball slides, then rolls",
            slope: 0.0,
            material: rough(0.3, 0.0),
            bodies: vec![(ball("ball", 0.5, 0.1, DVec3::ZERO, DVec3::ZERO), flat, 0.0, along(1.0))],
        },
        Motion {
            name: "a ball and a wheel roll and are slowed",
            slope: 0.1,
            material: resisting,
            bodies: vec![
                (ball("ball", 0.5, 0.1, DVec3::ZERO, DVec3::ZERO), flat, 0.0, Velocity::new(DVec3::X * 0.5, spin(5.0))),
                (wheel("wheel", 0.7, 0.1, 0.05), flat - DVec3::X, 0.0, Velocity::new(DVec3::X * -0.4, spin(-4.0))),
            ],
        },
        Motion {
            name: "a box slides off another one, which it drags along",
            slope: 0.0,
            material: rough(0.3, 0.0),
            bodies: vec![
                (stack("below"), flat, 0.0, Velocity::ZERO),
                (stack("above"), DVec3::new(-0.05, 0.0, 0.3), 0.0, along(1.6)),
            ],
        },
    ]
}

fn is_planar(report: &RunReport) -> bool {
    let planar = report.plan.effects.iter().find(|effect| effect.effect == Effect::PlanarMotion);
    planar.is_some_and(|effect| effect.decision == Decision::On)
}

fn plan_is_planar(scene: &Scene) -> bool {
    let simulation = Simulation::new(scene).unwrap();
    let mut effects = simulation.plan().effects.iter();
    effects.any(|effect| effect.effect == Effect::PlanarMotion && effect.decision == Decision::On)
}

fn why_not(report: &RunReport) -> String {
    let planar = report.plan.effects.iter().find(|effect| effect.effect == Effect::PlanarMotion);
    planar.map(|effect| effect.fact.clone()).unwrap_or_default()
}

/// The largest differences of positions (m) and attitudes (rad) at all samples.
fn differences(a: &Recorder, b: &Recorder) -> (f64, f64) {
    assert_eq!(a.samples.len(), b.samples.len());
    let pairs = || a.samples.iter().zip(&b.samples).flat_map(|(a, b)| a.iter().zip(b));
    let place = pairs().map(|(a, b)| (a.pose.translation - b.pose.translation).length()).fold(0.0, f64::max);
    (place, pairs().map(|(a, b)| a.pose.rotation.angle_to(b.pose.rotation)).fold(0.0, f64::max))
}

#[test]
fn bodies_slide_tip_fall_and_roll_in_the_plane_as_in_space() {
    for motion in motions() {
        for turn in [Rotation::IDENTITY, turned()] {
            let scene = motion.scene(View { turn, ..PLAIN });
            let (planned, found) = run(&scene, Effects::Planned);
            let (all, reference) = run(&scene, Effects::All);
            assert!(is_planar(&planned) && !is_planar(&all), "{}: {}", motion.name, why_not(&planned));
            let (place, attitude) = differences(&found, &reference);
            assert!(place < SAME && attitude < SAME, "{}: {place:e} m, {attitude:e} rad", motion.name);
            // One event of a contact on the plane's side may be two of it and its image in space, at the same instant.
            let kinds = |events: &[polhode::Event]| -> Vec<EventKind> {
                events.iter().map(|event| event.kind).filter(|kind| *kind == EventKind::Impact).collect()
            };
            assert_eq!(kinds(&found.events).is_empty(), kinds(&reference.events).is_empty(), "{}", motion.name);
            assert_closes(&planned);
            let [a, b] = [&planned, &all].map(|report| report.ledger.friction.value());
            let energy = all.ledger.initial_j.abs().max(1.0);
            assert!((a - b).abs() < 1e-11 * energy, "{}: friction took {a} J, in space {b} J", motion.name);
        }
    }
}

/// A turned world has the turned motion, and a mirrored one the mirror image.
#[test]
fn the_plane_may_lie_anywhere() {
    for motion in motions() {
        let (plain, reference) = run(&motion.scene(PLAIN), Effects::Planned);
        for view in [View { turn: turned(), ..PLAIN }, View { mirror: -1.0, ..PLAIN }] {
            let (planned, found) = run(&motion.scene(view), Effects::Planned);
            assert!(is_planar(&plain) && is_planar(&planned), "{}", motion.name);
            for (a, b) in found.samples.iter().zip(&reference.samples) {
                for (a, b) in a.iter().zip(b) {
                    let apart = (a.pose.translation - view.point(b.pose.translation)).length();
                    assert!(apart < SAME, "{}: {apart:e} m", motion.name);
                }
            }
        }
    }
}

/// A spin about another axis than the normal of the plane, a push across it and a floor that is steeper on one side
/// lead out of the plane: the plan leaves them in space.
#[test]
fn what_leaves_the_plane_is_in_space() {
    let material = rough(0.3, 0.0);
    let flat = DVec3::Z * 0.1;
    let cases = [
        ("spins", Velocity::new(DVec3::X, DVec3::Z * 1e-9)),
        ("rolls", Velocity::new(DVec3::X, DVec3::X * 1e-9)),
        ("moves across", Velocity::new(DVec3::new(1.0, 1e-9, 0.0), DVec3::Y)),
    ];
    for (name, velocity) in cases {
        let scene = one("box", material.clone(), 0.0, flat + DVec3::Z, 0.3, velocity).scene(PLAIN);
        assert!(!plan_is_planar(&scene), "{name}");
    }
}

/// Edges of two pyramids may touch with normals that lean out of the plane, between which friction wedges bodies: with
/// friction they are simulated in space from where they meet, without it in the plane.
#[test]
fn bodies_that_may_be_wedged_are_in_space() {
    let points = [(1.0, 0.0), (-0.5, 0.8), (-0.5, -0.8)].map(|(x, y)| DVec3::new(x, y, -0.25));
    let points: Vec<DVec3> = points.into_iter().chain([DVec3::Z * 0.75]).collect();
    let shape = Shape::convex(ConvexPolyhedron::from_points(&points).unwrap());
    for (friction, planar) in [(0.0, true), (0.4, false)] {
        let material = rough(friction, 0.0);
        let inertia = polhode::spatial::Inertia::from_diagonal(DVec3::splat(0.1)).unwrap();
        let properties = polhode::spatial::MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia);
        let above = Body::movable("above", properties).geometry(shape.clone().into());
        let scene = Scene::builder("pyramids")
            .method(accurate())
            .gravity(DVec3::NEG_Z * 9.81)
            .duration_s(0.5)
            .body(Body::fixed("below").geometry(shape.clone().into()).material(material.clone()))
            .body(above.pose(Pose::from_translation(DVec3::new(0.2, 0.0, 2.0))).material(material));
        let scene = scene.build().unwrap();
        let (report, found) = run(&scene, Effects::Planned);
        assert_eq!(is_planar(&report), planar, "{friction}: {}", why_not(&report));
        assert!(found.events.iter().any(|event| event.kind == EventKind::Impact));
        let [planned, all] =
            [report, run(&scene, Effects::All).0].map(|report| report.bodies[1].state.pose.translation);
        assert!((planned - all).length() < SAME, "{friction}: {planned:?}, in space {all:?}");
    }
}

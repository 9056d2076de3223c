//! Bits do not depend on the units of length and time.
//!
//! With lengths times `4^k` and times times `2^k` accelerations stay, and every number of a run is multiplied by a
//! power of two, exactly: a norm or a threshold that adds newtons to newton metres, or metres to anything else, would
//! show.

use crate::support::{accurate, floor, run_even_degraded};
use polhode::contact::Shape;
use polhode::scene::{Material, Method, Tier};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use polhode::{Body, Effects, Scene};

/// Powers of the scaled copies.
const POWERS: [i32; 3] = [-3, 1, 4];

/// The units of a copy: lengths and times that those of the scene are multiplied by.
#[derive(Debug, Clone, Copy)]
struct Units {
    length: f64,
    time: f64,
}

impl Units {
    fn of(power: i32) -> Self {
        Self { length: 4.0_f64.powi(power), time: 2.0_f64.powi(power) }
    }

    /// A velocity in m/s and rad/s of the scene.
    fn velocity(self, linear: DVec3, angular: DVec3) -> Velocity {
        Velocity::new(linear * (self.length / self.time), angular / self.time)
    }

    /// A body of 1.5 kg with this shape of the scene's units.
    fn body(self, name: &str, shape: Shape, moments: DVec3) -> Body {
        let inertia = Inertia::from_diagonal(moments * (self.length * self.length)).unwrap();
        Body::movable(name, MassProperties::new(Mass::new(1.5).unwrap(), DVec3::ZERO, inertia)).geometry(shape.into())
    }
}

/// Friction with a length of rolling and one of spinning (m, of the scene's units).
fn felt(units: Units, friction: f64, restitution: f64, rolling: f64, spinning: f64) -> Material {
    let felt = Material::new("felt").with_friction(friction).unwrap().with_restitution(restitution).unwrap();
    felt.with_rotational_friction(rolling * units.length, spinning * units.length).unwrap()
}

/// Asserts that copies of a scene in other units have its bits, in a tier.
#[track_caller]
fn assert_same_bits(tier: Tier, duration_s: f64, bodies: impl Fn(Units) -> Vec<Body>) {
    let ends = |units: Units| {
        let step_s = Some(0.01 * units.time);
        let builder = Scene::builder("in other units")
            .method(Method { tier: Some(tier), step_s, ..accurate() })
            .duration_s(duration_s * units.time)
            .output_interval_s(duration_s * units.time);
        let scene = bodies(units).into_iter().fold(builder, polhode::SceneBuilder::body).build().unwrap();
        let (report, _) = run_even_degraded(&scene, Effects::Planned);
        let numbers = report.bodies.iter().flat_map(|polhode::ReportedBody { state: body, .. }| {
            let place = body.pose.translation / units.length;
            let linear = body.velocity.linear * (units.time / units.length);
            let angular = body.velocity.angular * units.time;
            let rotation = body.pose.rotation.to_wxyz();
            [place, linear, angular].into_iter().flat_map(|v| v.to_array()).chain(rotation).collect::<Vec<f64>>()
        });
        numbers.collect::<Vec<f64>>()
    };
    let own = ends(Units::of(0));
    for power in POWERS {
        assert_eq!(ends(Units::of(power)), own, "4^{power}");
    }
}

/// Balls that roll, spin and bounce against friction of rolling and spinning.
#[test]
fn balls_with_friction_of_rolling_have_the_same_bits() {
    for tier in [Tier::Accurate, Tier::Stepped] {
        for (e, height) in [(0.0, 0.2), (0.5, 0.45)] {
            assert_same_bits(tier, 0.5, |units| {
                let radius = 0.2 * units.length;
                let shape = Shape::sphere(radius).unwrap();
                let moments = DVec3::splat(0.4 * 1.5 * 0.04);
                let ball = units
                    .body("ball", shape, moments)
                    .pose(Pose::from_translation(DVec3::Z * (height * units.length)))
                    .velocity(units.velocity(DVec3::new(1.0, 0.3, 0.0), DVec3::new(2.0, -1.0, 3.0)));
                let material = felt(units, 0.3, e, 0.004, 0.01);
                vec![ball.material(material.clone()), floor().material(material)]
            });
        }
    }
}

/// A body of many points that lands and tumbles, with friction of rolling at its impacts.
#[test]
fn tumbling_body_with_friction_of_rolling_has_the_same_bits() {
    let points =
        [(0.10, -0.05, 0.04), (-0.05, -0.06, -0.07), (-0.05, 0.08, -0.04), (0.03, 0.01, -0.06), (0.1, -0.01, -0.06)];
    for tier in [Tier::Accurate, Tier::Stepped] {
        assert_same_bits(tier, 0.25, |units| {
            let points = points.iter().map(|&(x, y, z)| DVec3::new(x, y, z) * units.length).collect();
            let turned = Rotation::from_rotation_vector(DVec3::new(0.5, 1.0, -0.3));
            let body = units
                .body("body", Shape::points(points).unwrap(), DVec3::new(0.0063, 0.0064, 0.007))
                .pose(Pose::new(turned, DVec3::Z * (0.17 * units.length)))
                .velocity(units.velocity(DVec3::ZERO, DVec3::new(0.34, 4.1, 2.2)));
            let material = felt(units, 0.04, 0.0, 0.0005, 0.0);
            vec![body.material(material.clone()), floor().material(material)]
        });
    }
}

/// Boxes that slide on each other and stop, without friction of rolling.
#[test]
fn sliding_boxes_have_the_same_bits() {
    for tier in [Tier::Accurate, Tier::Stepped] {
        assert_same_bits(tier, 0.4, |units| {
            let rough = Material::new("rough").with_friction(0.35).unwrap().with_restitution(0.2).unwrap();
            let size = DVec3::new(0.5, 0.4, 0.125);
            let one = |name: &str, z: f64, speed: f64| {
                let shape = Shape::cuboid(size * units.length).unwrap();
                let squares = size * size;
                let sums = DVec3::new(squares.y + squares.z, squares.x + squares.z, squares.x + squares.y);
                units
                    .body(name, shape, sums * (1.5 / 12.0))
                    .pose(Pose::from_translation(DVec3::new(0.0, 0.0, z) * units.length))
                    .velocity(units.velocity(DVec3::X * speed, DVec3::ZERO))
                    .material(rough.clone())
            };
            vec![one("lower", 0.0625, 0.5), one("upper", 0.1875, 1.0), floor().material(rough.clone())]
        });
    }
}

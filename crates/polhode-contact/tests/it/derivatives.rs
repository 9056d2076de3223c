//! The first and second time derivatives of the separation of every kind of contact, against finite differences of
//! eighth order along motions that accelerate and whose spin changes direction, at separations that are not zero.

use crate::support::{Flight, Random, ball, cuboid, floor, prism};
use polhode_contact::{ContactFeature, Shape, Side, SurfaceFeature, evaluate, kinematics};
use polhode_spatial::{DVec3, Motion, Pose, Rotation, UnitVector, Velocity};

/// `R(t) = exp(first t) exp(second t) R_0`: angular velocity `first + exp(first t) second`, and its rate at zero
/// `first x second`.
pub(crate) struct Path {
    start: Pose,
    linear: DVec3,
    acceleration: DVec3,
    first: DVec3,
    second: DVec3,
}

impl Path {
    pub(crate) fn random(random: &mut Random) -> Self {
        Self {
            start: random.pose(1.0),
            linear: random.vector(),
            acceleration: random.vector(),
            first: random.vector() * 1.5,
            second: random.vector() * 1.5,
        }
    }

    pub(crate) fn pose(&self, t: f64) -> Pose {
        let turn = Rotation::from_rotation_vector(self.first * t) * Rotation::from_rotation_vector(self.second * t);
        let place = self.start.translation + self.linear * t + self.acceleration * (0.5 * t * t);
        Pose::new(turn * self.start.rotation, place)
    }

    pub(crate) fn velocity(&self) -> Velocity {
        Velocity::new(self.linear, self.first + self.second)
    }

    pub(crate) fn velocity_at(&self, t: f64) -> Velocity {
        let second = Rotation::from_rotation_vector(self.first * t).rotate(self.second);
        Velocity::new(self.linear + self.acceleration * t, self.first + second)
    }

    /// Acceleration of the body's point at an arm from the centre of mass, without the centripetal part.
    pub(crate) fn given_acceleration(&self, arm: DVec3) -> DVec3 {
        self.acceleration + self.first.cross(self.second).cross(arm)
    }
}

/// Weights of the central difference of eighth order for the first derivative.
pub(crate) const FIRST: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];

/// Central differences of eighth order for the first and the second derivative.
fn differences(f: impl Fn(f64) -> f64, h: f64) -> (f64, f64) {
    const SECOND: [f64; 4] = [8.0 / 5.0, -1.0 / 5.0, 8.0 / 315.0, -1.0 / 560.0];
    let (mut first, mut second) = (0.0, -205.0 / 72.0 * f(0.0));
    for (k, (c1, c2)) in FIRST.iter().zip(SECOND).enumerate() {
        let s = h * (k + 1) as f64;
        let (after, before) = (f(s), f(-s));
        first += c1 * (after - before);
        second += c2 * (after + before);
    }
    (first / h, second / (h * h))
}

/// Asserts that the rate of a contact's separation at time zero is the difference quotient along two flights.
pub(crate) fn assert_rate(feature: ContactFeature, [a, b]: [&Shape; 2], flights: &[Flight; 2]) {
    let separation = |t: f64| {
        let [pose_a, pose_b] = flights.map(|flight| flight.pose(t));
        evaluate(feature, a, &pose_a, b, &pose_b).expect("the contact").separation
    };
    let ([pose_a, pose_b], [v_a, v_b]) = (flights.map(|flight| flight.pose(0.0)), flights.map(|f| f.velocity(0.0)));
    let exact = kinematics(feature, a, &pose_a, &v_a, b, &pose_b, &v_b).expect("the contact");
    let h = 1e-5;
    let rate = (separation(h) - separation(-h)) / (2.0 * h);
    assert!((rate - exact.separation_rate).abs() < 1e-6 * (1.0 + rate.abs()), "{feature:?}");
}

fn check(name: &str, feature: ContactFeature, shape_a: &Shape, shape_b: &Shape, random: &mut Random) {
    check_at(60, name, feature, shape_a, shape_b, random);
}

/// Checks at this many random poses, of which more than 20 must have the contact.
pub(crate) fn check_at(
    poses: u32,
    name: &str,
    feature: ContactFeature,
    shape_a: &Shape,
    shape_b: &Shape,
    random: &mut Random,
) {
    let mut checked = 0;
    for _ in 0..poses {
        let (a, b) = (Path::random(random), Path::random(random));
        let (pose_a, pose_b) = (a.pose(0.0), b.pose(0.0));
        let Some(k) = kinematics(feature, shape_a, &pose_a, &a.velocity(), shape_b, &pose_b, &b.velocity()) else {
            continue;
        };
        let geometry = k.geometry;
        assert_eq!(Some(geometry), evaluate(feature, shape_a, &pose_a, shape_b, &pose_b));
        let chi =
            |t: f64| evaluate(feature, shape_a, &a.pose(t), shape_b, &b.pose(t)).map_or(f64::NAN, |g| g.separation);
        let ((coarse, coarser), (first, second)) = (differences(chi, 0.02), differences(chi, 0.01));
        // Near parallel edges, and near the feature itself, the separation is too curved for finite differences, which
        // three steps show (two may agree by chance).
        let (middle, middles) = differences(chi, 0.014);
        let doubt = (coarse - first).abs().max((middle - first).abs());
        let doubts = (coarser - second).abs().max((middles - second).abs());
        if !(doubt < 1e-8 * (1.0 + first.abs()) && doubts < 1e-6 * (1.0 + second.abs())) {
            continue;
        }
        checked += 1;
        let error = (k.separation_rate - first).abs();
        assert!(error < doubt + 1e-12 * (1.0 + first.abs()), "{name}: {} {first}", k.separation_rate);
        let relative = a.given_acceleration(geometry.point - pose_a.translation)
            - b.given_acceleration(geometry.point - pose_b.translation);
        let predicted = geometry.normal.dot(relative) + k.acceleration_bias;
        assert!((predicted - second).abs() < doubts + 1e-10 * (1.0 + second.abs()), "{name}: {predicted} {second}");
        // The rate is that of the contact point taken on both bodies.
        let at_point =
            a.velocity().at(geometry.point - pose_a.translation) - b.velocity().at(geometry.point - pose_b.translation);
        assert!((geometry.normal.dot(at_point) - k.separation_rate).abs() < 1e-13);
    }
    assert!(checked > 20, "{name}: only {checked}");
}

/// Every kind of contact, in both orders.
#[test]
fn of_every_kind() {
    let mut random = Random(1234);
    each_kind(|name, feature, a, b| check(name, feature, a, b, &mut random));
}

/// Calls `visit` with every kind of contact of polyhedra, clouds, spheres and half-spaces, in both orders.
pub(crate) fn each_kind(mut visit: impl FnMut(&str, ContactFeature, &Shape, &Shape)) {
    let (cube, hexagon) = (cuboid(0.5, 0.4, 0.3), prism(6, 0.3, 0.4));
    let moved = |s: Shape, by: DVec3| s.translated(by).expect("moved");
    let cube = moved(cube, DVec3::new(0.1, -0.05, 0.2));
    let other_ball = moved(ball(0.1), DVec3::new(0.2, 0.1, 0.0));
    let ball = moved(ball(0.2), DVec3::new(-0.1, 0.2, 0.1));
    let cloud = Shape::points(vec![DVec3::new(0.3, 0.2, 0.1), DVec3::new(-0.2, 0.1, 0.4)]).expect("points");
    let floor = moved(Shape::half_space(UnitVector::new(DVec3::new(0.2, 0.3, 0.9)).expect("up")), DVec3::Z * 0.3);
    let smooth = |side, center, against| ContactFeature::Smooth { center_of: side, center, against };
    let vertex = |side, vertex, face| ContactFeature::VertexFace { vertex_of: side, vertex, face };
    for side in [Side::A, Side::B] {
        let cases: [(&str, ContactFeature, &Shape, &Shape); 9] = [
            ("vertex-face", vertex(side, 3, 2), &hexagon, &cube),
            ("vertex-half-space", vertex(side, 6, 0), &cube, &floor),
            ("point-face", vertex(side, 1, 3), &cloud, &cube),
            ("sphere-face", smooth(side, 0, SurfaceFeature::Face(4)), &ball, &cube),
            ("sphere-half-space", smooth(side, 0, SurfaceFeature::Face(0)), &ball, &floor),
            ("sphere-edge", smooth(side, 0, SurfaceFeature::Edge(7)), &ball, &hexagon),
            ("sphere-vertex", smooth(side, 0, SurfaceFeature::Vertex(5)), &ball, &cube),
            ("point-edge", smooth(side, 1, SurfaceFeature::Edge(2)), &cloud, &cube),
            ("point-sphere", smooth(side, 1, SurfaceFeature::Sphere), &cloud, &ball),
        ];
        for (name, feature, owner, other) in cases {
            let (a, b) = if side == Side::A { (owner, other) } else { (other, owner) };
            visit(name, feature, a, b);
        }
    }
    visit("sphere-sphere", ContactFeature::SphereSphere, &ball, &other_ball);
    for (edge_a, edge_b) in [(0, 0), (3, 7), (11, 14), (6, 2)] {
        visit("edge-edge", ContactFeature::EdgeEdge { edge_a, edge_b }, &cube, &hexagon);
    }
}

/// There is no contact of parallel edges, which have no common perpendicular, or of features that the shapes do not
/// have.
#[test]
fn without_meaning() {
    let cube = cuboid(1.0, 1.0, 1.0);
    let above = Pose::from_translation(DVec3::Z * 3.0);
    let same_edge = ContactFeature::EdgeEdge { edge_a: 2, edge_b: 2 };
    assert_eq!(evaluate(same_edge, &cube, &above, &cube, &Pose::IDENTITY), None);
    for feature in [
        ContactFeature::EdgeEdge { edge_a: 12, edge_b: 0 },
        ContactFeature::VertexFace { vertex_of: Side::A, vertex: 8, face: 0 },
        ContactFeature::VertexFace { vertex_of: Side::B, vertex: 0, face: 6 },
        ContactFeature::SphereSphere,
    ] {
        assert_eq!(evaluate(feature, &cube, &above, &cube, &Pose::IDENTITY), None);
    }
}

/// The margin of a vertex is its distance from the face's border, that of a crossing its distance from the edges' ends.
#[test]
fn margins() {
    let cube = cuboid(1.0, 1.0, 1.0);
    let at = |x: f64, y: f64| Pose::from_translation(DVec3::new(x, y, 1.0));
    let corner = ContactFeature::VertexFace { vertex_of: Side::A, vertex: 0, face: 5 };
    let margin = |x, y| evaluate(corner, &cube, &at(x, y), &cube, &Pose::IDENTITY).map(|g| g.margin);
    assert_eq!(margin(0.5, 0.25), Some(0.25));
    assert_eq!(margin(1.25, 0.25), Some(-0.25));
    let floor = floor();
    let on_floor = ContactFeature::VertexFace { vertex_of: Side::A, vertex: 0, face: 0 };
    let g = evaluate(on_floor, &cube, &at(0.0, 0.0), &floor, &Pose::IDENTITY).expect("a contact");
    assert_eq!((g.margin, g.separation, g.normal), (f64::INFINITY, 0.5, DVec3::Z));
}

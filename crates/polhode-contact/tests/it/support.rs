//! Random numbers, shapes, poses and motions for the tests.

use polhode_contact::{ContactFeature, ConvexPolyhedron, Shape, TangentialKinematics, kinematics_with_tangential};
use polhode_mesh::{SolidMesh, TriangleMesh};
use polhode_spatial::{DVec3, Motion, MotionBounds, Pose, Rotation, SplitMix64, UnitVector, Velocity};

/// Random numbers from a fixed seed, so that a failing case can be reproduced; the field is the state of the generator.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// Uniform in [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        let mut numbers = SplitMix64::new(self.0);
        let unit = numbers.uniform();
        self.0 = numbers.seed();
        unit
    }

    /// Uniform between two numbers.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// In the cube [-1, 1]^3.
    pub(crate) fn vector(&mut self) -> DVec3 {
        DVec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0))
    }

    /// Uniform on the unit sphere.
    pub(crate) fn direction(&mut self) -> DVec3 {
        loop {
            let v = self.vector();
            if (0.1..=1.0).contains(&v.length()) {
                return v.normalize();
            }
        }
    }

    /// Any rotation.
    pub(crate) fn rotation(&mut self) -> Rotation {
        Rotation::from_rotation_vector(self.direction() * self.between(0.0, std::f64::consts::PI))
    }

    /// Any rotation, with a translation in the cube [-reach, reach]^3.
    pub(crate) fn pose(&mut self, reach: f64) -> Pose {
        Pose::new(self.rotation(), self.vector() * reach)
    }
}

/// A box.
pub(crate) fn cuboid(x: f64, y: f64, z: f64) -> Shape {
    Shape::cuboid(DVec3::new(x, y, z)).expect("a box with positive sizes")
}

/// Vertices of an upright prism with a regular base: the lower ring, then the upper one.
pub(crate) fn prism_points(sides: u32, radius: f64, height: f64) -> Vec<DVec3> {
    let ring = |z: f64| {
        (0..sides).map(move |k| {
            let angle = f64::from(k) / f64::from(sides) * std::f64::consts::TAU;
            DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), z)
        })
    };
    ring(-0.5 * height).chain(ring(0.5 * height)).collect()
}

/// An upright prism with a regular base.
pub(crate) fn prism(sides: u32, radius: f64, height: f64) -> Shape {
    hull(&prism_points(sides, radius, height))
}

/// The convex hull of points that span a volume.
pub(crate) fn hull(points: &[DVec3]) -> Shape {
    Shape::convex(ConvexPolyhedron::from_points(points).expect("the points span a volume"))
}

/// A ball about the origin.
pub(crate) fn ball(radius: f64) -> Shape {
    Shape::sphere(radius).expect("a positive radius")
}

/// A capsule about z.
pub(crate) fn capsule(radius: f64, height: f64) -> Shape {
    Shape::capsule(radius, height).expect("positive lengths")
}

/// A cylinder about z.
pub(crate) fn cylinder(radius: f64, height: f64) -> Shape {
    Shape::cylinder(radius, height).expect("positive lengths")
}

/// A cone about z.
pub(crate) fn cone(radius: f64, height: f64) -> Shape {
    Shape::cone(radius, height).expect("positive lengths")
}

/// A torus about z.
pub(crate) fn ring(major: f64, minor: f64) -> Shape {
    Shape::torus(major, minor).expect("a torus with a hole")
}

/// All points with z <= 0.
pub(crate) fn floor() -> Shape {
    Shape::half_space(UnitVector::Z)
}

/// An L-shaped prism from z = 0 to `height`: its outline in x and y, anticlockwise, whose first four corners and whose
/// first, fourth, fifth and sixth are those of two rectangles.
pub(crate) fn l_prism(outline: [[f64; 2]; 6], height: f64) -> SolidMesh {
    let vertices = [0.0, height].iter().flat_map(|&z| outline.map(|[x, y]| DVec3::new(x, y, z))).collect();
    let base = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]];
    let mut triangles: Vec<[u32; 3]> = base.iter().flat_map(|&[a, b, c]| [[a, c, b], [a + 6, b + 6, c + 6]]).collect();
    for i in 0..6 {
        let j = (i + 1) % 6;
        triangles.extend([[i, j, j + 6], [i, j + 6, i + 6]]);
    }
    SolidMesh::new(TriangleMesh::new(vertices, triangles).expect("a mesh")).expect("a closed mesh")
}

/// Distance of a point from a segment.
pub(crate) fn off_segment([p, q]: [DVec3; 2], x: DVec3) -> f64 {
    let along = q - p;
    x.distance(p + along * ((x - p).dot(along) / along.length_squared()).clamp(0.0, 1.0))
}

/// Rotation about the z axis, rad.
pub(crate) fn yaw(angle: f64) -> Rotation {
    Rotation::from_rotation_vector(DVec3::Z * angle)
}

/// A pose rotated about an axis through its own origin (rad).
pub(crate) fn turned(axis: DVec3, angle: f64, place: DVec3) -> Pose {
    Pose::new(Rotation::from_rotation_vector(axis * angle), place)
}

/// A pose without rotation.
pub(crate) fn at(x: f64, y: f64, z: f64) -> Pose {
    Pose::from_translation(DVec3::new(x, y, z))
}

/// Constant acceleration of the centre of mass; a spin that precesses: `R(t) = exp(precession t) exp(spin t) R_0`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Flight {
    pub(crate) start: Pose,
    /// Velocity at time zero, without the precession.
    pub(crate) velocity: Velocity,
    pub(crate) acceleration: DVec3,
    pub(crate) precession: DVec3,
}

impl Flight {
    /// Without acceleration and precession.
    pub(crate) fn new(start: Pose, linear: DVec3, angular: DVec3) -> Self {
        let velocity = Velocity::new(linear, angular);
        Self { start, velocity, acceleration: DVec3::ZERO, precession: DVec3::ZERO }
    }
}

impl Motion for Flight {
    fn pose(&self, t: f64) -> Pose {
        let spin = Rotation::from_rotation_vector(self.velocity.angular * t);
        let turn = Rotation::from_rotation_vector(self.precession * t) * spin;
        let path = self.velocity.linear * t + self.acceleration * (0.5 * t * t);
        Pose::new(turn * self.start.rotation, self.start.translation + path)
    }

    fn velocity(&self, t: f64) -> Velocity {
        let spin = Rotation::from_rotation_vector(self.precession * t).rotate(self.velocity.angular);
        Velocity::new(self.velocity.linear + self.acceleration * t, self.precession + spin)
    }

    fn bounds(&self, t0: f64, t1: f64) -> MotionBounds {
        let speed = |t: f64| (self.velocity.linear + self.acceleration * t).length();
        MotionBounds {
            speed: speed(t0).max(speed(t1)),
            acceleration: self.acceleration.length(),
            angular_speed: self.precession.length() + self.velocity.angular.length(),
            angular_acceleration: self.precession.length() * self.velocity.angular.length(),
        }
    }
}

/// The tangential terms of a contact alone.
pub(crate) fn tangential(
    feature: ContactFeature,
    shape_a: &Shape,
    pose_a: &Pose,
    velocity_a: &Velocity,
    shape_b: &Shape,
    pose_b: &Pose,
    velocity_b: &Velocity,
) -> Option<TangentialKinematics> {
    kinematics_with_tangential(feature, shape_a, pose_a, velocity_a, shape_b, pose_b, velocity_b).map(|both| both.1)
}

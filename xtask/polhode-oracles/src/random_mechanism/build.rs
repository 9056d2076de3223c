//! What all kinds of mechanisms are built with: bars, boxes and balls, joints, words of what acts along their
//! coordinates.

use super::model::{Coordinate, Joint, JointKind, Keys, Mechanism, Member, Role, Value};
use crate::random::Random;
use glam::{DQuat, DVec3};

/// A mechanism being built.
pub(super) struct Build {
    pub(super) random: Random,
    pub(super) scene: Mechanism,
    /// Gears, as rows of the velocities at the start.
    pub(super) gears: Vec<[(usize, Coordinate, f64); 2]>,
}

impl Build {
    /// A body that forces move, without a shape: masses at random places about the middle of two points, at any
    /// attitude.
    pub(super) fn bar(&mut self, a: DVec3, b: DVec3) -> usize {
        let random = &mut self.random;
        let length = (b - a).length().max(0.1);
        let mass = random.between(0.3, 3.0);
        // Second moments of mass along the principal axes: any three above zero are those of a body.
        let second = random.vector(0.005, 0.12) * (mass * length * length);
        let inertia = DVec3::new(second.y + second.z, second.x + second.z, second.x + second.y);
        let member = Member {
            name: format!("b{}", self.scene.bodies.len()),
            size: length,
            shape: None,
            role: Role::Free(mass, Some(inertia)),
            position: 0.5 * (a + b) + random.vector(-0.15, 0.15) * length,
            orientation: attitude(random),
            velocity: random.vector(-1.0, 1.0) * length,
            angular_velocity: random.vector(-2.0, 2.0),
            material: None,
            more: Vec::new(),
            is_loose: false,
        };
        self.add(member)
    }

    /// A body with a shape of this size, m: key and value, in its own frame.
    pub(super) fn solid(&mut self, shape: String, size: f64, position: DVec3, orientation: DQuat) -> usize {
        let member = Member {
            name: format!("b{}", self.scene.bodies.len()),
            size,
            shape: Some(shape),
            role: Role::Free(self.random.between(0.3, 3.0), None),
            position,
            orientation,
            velocity: DVec3::ZERO,
            angular_velocity: DVec3::ZERO,
            material: None,
            more: Vec::new(),
            is_loose: false,
        };
        self.add(member)
    }

    pub(super) fn add(&mut self, member: Member) -> usize {
        self.scene.bodies.push(member);
        self.scene.bodies.len() - 1
    }

    pub(super) fn body(&mut self, number: usize) -> &mut Member {
        &mut self.scene.bodies[number]
    }

    /// A material: friction, static friction, restitution.
    pub(super) fn material(&mut self, friction: f64, static_friction: f64, restitution: f64) -> usize {
        self.scene.materials.push(format!(
            "friction = {friction:?}\nstatic_friction = {static_friction:?}\nrestitution = {restitution:?}"
        ));
        self.scene.materials.len() - 1
    }

    /// A joint without anything that acts along its coordinates.
    pub(super) fn joint(&mut self, kind: JointKind, bodies: &[usize], anchor: DVec3, axes: &[DVec3]) -> usize {
        let length = if kind == JointKind::Screw {
            self.random.one_of(&[-1.0, 1.0]) * self.random.between(0.05, 0.4)
        } else {
            0.0
        };
        let joint = Joint {
            name: format!("j{}", self.scene.joints.len()),
            kind,
            bodies: bodies.to_vec(),
            anchors: vec![anchor],
            axes: axes.to_vec(),
            length,
            keys: Keys::new(),
            rate: None,
        };
        self.scene.joints.push(joint);
        self.scene.joints.len() - 1
    }

    /// A rod, or a rope of this length.
    pub(super) fn line(&mut self, kind: JointKind, bodies: &[usize], ends: [DVec3; 2], length: f64) -> usize {
        let number = self.joint(kind, bodies, ends[0], &[]);
        let joint = &mut self.scene.joints[number];
        (joint.anchors, joint.length) = (ends.to_vec(), length);
        number
    }

    /// Adds words to what acts along a coordinate of a joint.
    pub(super) fn act(&mut self, joint: usize, coordinate: Coordinate, words: &str) {
        let keys = &mut self.scene.joints[joint].keys;
        let key = coordinate.key();
        if let Some((_, Value::Text(text))) = keys.iter_mut().find(|(own, _)| *own == key) {
            *text = format!("{}, {words} }}", text.strip_suffix(" }").unwrap_or(text));
        } else {
            keys.push((key, Value::Text(format!("{{ {words} }}"))));
        }
    }

    /// The inertia that a coordinate of a joint has to do with, in orders of magnitude: that of its first body about
    /// the anchor, kg m^2, or its mass, kg.
    pub(super) fn inertia(&self, joint: usize, coordinate: Coordinate) -> f64 {
        let joint = &self.scene.joints[joint];
        let body = &self.scene.bodies[joint.bodies[0]];
        let Role::Free(mass, _) = body.role else { return 1.0 };
        match coordinate {
            Coordinate::Angle => {
                mass * (body.size * body.size / 10.0 + (body.position - joint.anchors[0]).length_squared())
            }
            Coordinate::Displacement => mass,
        }
    }

    /// A spring, a damper or both, of which a coordinate swings with some rad/s.
    pub(super) fn spring(&mut self, joint: usize, coordinate: Coordinate) {
        let inertia = self.inertia(joint, coordinate);
        let rate = self.random.between(2.0, 12.0);
        let (stiffness, rest) = (inertia * rate * rate, self.random.between(-0.3, 0.3));
        let damping = inertia * rate * self.random.between(0.05, 1.0);
        let words = match self.random.below(3) {
            0 => format!("stiffness = {stiffness:?}, rest = {rest:?}"),
            1 => format!("damping = {damping:?}"),
            _ => format!("stiffness = {stiffness:?}, rest = {rest:?}, damping = {damping:?}"),
        };
        self.act(joint, coordinate, &words);
    }

    /// The coordinates of a joint.
    pub(super) fn coordinates(&self, joint: usize) -> &'static [Coordinate] {
        self.scene.joints[joint].kind.coordinates()
    }

    /// Removes the velocities of all bodies that forces move: the scene starts from rest, but for what drives it.
    pub(super) fn at_rest(&mut self) {
        for body in self.scene.bodies.iter_mut().filter(|body| body.is_free()) {
            (body.velocity, body.angular_velocity) = (DVec3::ZERO, DVec3::ZERO);
        }
    }

    /// A body that does not move, with a shape.
    pub(super) fn fixed(&mut self, shape: String, position: DVec3, orientation: DQuat, material: usize) -> usize {
        let number = self.solid(shape, 1.0, position, orientation);
        let body = self.body(number);
        (body.role, body.material) = (Role::Fixed, Some(material));
        number
    }
}

/// Any attitude.
pub(super) fn attitude(random: &mut Random) -> DQuat {
    DQuat::from_axis_angle(random.direction(), random.between(0.0, std::f64::consts::TAU)).normalize()
}

/// Two directions at right angles to this one and to each other.
pub(super) fn across(axis: DVec3) -> [DVec3; 2] {
    let (u, v) = axis.normalize().any_orthonormal_pair();
    [u, v]
}

/// A number as a scene file has it.
pub(super) fn text(number: f64) -> Value {
    Value::Text(format!("{number:?}"))
}

//! Velocities that the joints of a mechanism allow: random ones are projected onto them.
//!
//! Each joint gives rows `J v = r` over the velocities `v` of the centres (m/s, in parts of a length) and the angular
//! velocities of the bodies that forces move; `r` holds what bodies of prescribed motion and prescribed rates do. The
//! rows are made orthonormal by the modified Gram-Schmidt method, twice each; a row of which nothing is left depends on
//! the others and is dropped. Then `v <- v - sum q (q.v - r)`. Exact to rounding over the smallest part that is kept of
//! a row.

use super::model::{Coordinate, Joint, JointKind, Mechanism};
use glam::DVec3;

/// A row of which less than this part is left depends on the others (no unit, 1e-12 to 1e-6).
const DEPENDENT: f64 = 1e-8;

/// Velocities below this are rounding of zero, m/s or rad/s: of a body that joints hold fast.
const STILL: f64 = 1e-13;

/// A row and its right-hand side.
#[derive(Debug, Clone)]
struct Row {
    entries: Vec<f64>,
    right: f64,
}

/// What a row multiplies of one body: velocity of a point of it, and angular velocity.
#[derive(Debug, Clone, Copy)]
struct Part {
    body: usize,
    point: DVec3,
    linear: DVec3,
    angular: DVec3,
}

impl Mechanism {
    /// Makes the velocities of the bodies that forces move ones that the joints allow. Further rows are those of gears:
    /// sums of coordinates of joints, by number, that stay zero.
    pub(super) fn make_consistent(&mut self, gears: &[[(usize, Coordinate, f64); 2]]) {
        let mut rows = Vec::new();
        for joint in &self.joints {
            self.rows_of(joint, &mut rows);
        }
        for gear in gears {
            let mut parts = Vec::new();
            for &(joint, coordinate, factor) in gear {
                parts.extend(coordinate_parts(&self.joints[joint], coordinate, factor));
            }
            rows.push(self.row(&parts, 0.0));
        }
        let mut basis: Vec<Row> = Vec::new();
        for mut row in rows {
            let length = norm(&row.entries);
            for _ in 0..2 {
                for other in &basis {
                    let part = dot(&row.entries, &other.entries);
                    row.entries.iter_mut().zip(&other.entries).for_each(|(own, theirs)| *own -= part * theirs);
                    row.right -= part * other.right;
                }
            }
            let left = norm(&row.entries);
            if left > DEPENDENT * length {
                row.entries.iter_mut().for_each(|entry| *entry /= left);
                row.right /= left;
                basis.push(row);
            }
        }
        let mut v: Vec<f64> =
            self.bodies.iter().flat_map(|b| [b.velocity.to_array(), b.angular_velocity.to_array()].concat()).collect();
        for (number, body) in self.bodies.iter().enumerate() {
            if !body.is_free() {
                v[6 * number..6 * number + 6].fill(0.0);
            }
        }
        for _ in 0..2 {
            for row in &basis {
                let off = dot(&row.entries, &v) - row.right;
                v.iter_mut().zip(&row.entries).for_each(|(v, entry)| *v -= off * entry);
            }
        }
        for (body, v) in self.bodies.iter_mut().zip(v.chunks_exact(6)).filter(|(body, _)| body.is_free()) {
            let clean = |x: f64| if x.abs() < STILL { 0.0 } else { x };
            body.velocity = DVec3::new(clean(v[0]), clean(v[1]), clean(v[2]));
            body.angular_velocity = DVec3::new(clean(v[3]), clean(v[4]), clean(v[5]));
        }
    }

    /// A row from its parts; what belongs to bodies that forces do not move goes to the right.
    fn row(&self, parts: &[Part], right: f64) -> Row {
        let mut row = Row { entries: vec![0.0; 6 * self.bodies.len()], right };
        for part in parts {
            let body = &self.bodies[part.body];
            // linear . (v + w x r) + angular . w
            let turning = (part.point - body.position).cross(part.linear) + part.angular;
            if body.is_free() {
                let entries = [part.linear.to_array(), turning.to_array()].concat();
                let own = &mut row.entries[6 * part.body..6 * part.body + 6];
                own.iter_mut().zip(entries).for_each(|(own, entry)| *own += entry);
            } else {
                row.right -= part.linear.dot(body.velocity) + turning.dot(body.angular_velocity);
            }
        }
        row
    }

    fn rows_of(&self, joint: &Joint, rows: &mut Vec<Row>) {
        let axis = joint.axes.first().copied().unwrap_or(DVec3::Z).normalize();
        let across = axis.any_orthonormal_pair();
        let all = [axis, across.0, across.1];
        let mut hold = |linear: DVec3, angular: DVec3, right: f64| {
            rows.push(self.row(&relative(joint, linear, angular), right));
        };
        let (linear, angular): (&[DVec3], &[DVec3]) = match joint.kind {
            JointKind::Hinge => (&all, &all[1..]),
            JointKind::Fixed => (&all, &all),
            JointKind::Slider => (&all[1..], &all),
            JointKind::Cylindrical | JointKind::Screw => (&all[1..], &all[1..]),
            JointKind::Planar => (&all[..1], &all[1..]),
            JointKind::Ball | JointKind::Universal => (&all, &[]),
            JointKind::Track => (&all[1..], if joint.is_at_rest() { &all } else { &[] }),
            JointKind::Rod | JointKind::Rope => (&[], &[]),
        };
        for &direction in linear {
            hold(direction, DVec3::ZERO, 0.0);
        }
        for &direction in angular {
            hold(DVec3::ZERO, direction, 0.0);
        }
        match joint.kind {
            JointKind::Universal => hold(DVec3::ZERO, joint.axes[0].cross(joint.axes[1]), 0.0),
            JointKind::Screw => hold(axis, axis * (-joint.length / std::f64::consts::TAU), 0.0),
            JointKind::Track if joint.is_at_rest() => hold(axis, DVec3::ZERO, 0.0),
            _ => {}
        }
        if joint.kind == JointKind::Rod || joint.is_taut() {
            let line = joint.anchors[0] - joint.anchors[1];
            rows.push(self.row(&relative(joint, line, DVec3::ZERO), 0.0));
        }
        if let Some((coordinate, rate)) = joint.rate {
            rows.push(self.row(&coordinate_parts(joint, coordinate, 1.0), rate));
        }
    }
}

impl Joint {
    /// Whether a body on a track follows its tangent or its frame: it starts from rest.
    fn is_at_rest(&self) -> bool {
        self.keys.iter().any(|(key, _)| *key == "follows")
    }

    /// Whether a rope is as long as the distance of its ends.
    fn is_taut(&self) -> bool {
        self.kind == JointKind::Rope && self.length <= (self.anchors[0] - self.anchors[1]).length() * (1.0 + DEPENDENT)
    }
}

/// What a row of a joint multiplies: the first body less the second.
fn relative(joint: &Joint, linear: DVec3, angular: DVec3) -> Vec<Part> {
    let last = joint.anchors.len() - 1;
    let part = |number: usize, sign: f64| Part {
        body: joint.bodies[number],
        point: joint.anchors[number.min(last)],
        linear: sign * linear,
        angular: sign * angular,
    };
    let mut parts = vec![part(0, 1.0)];
    if joint.bodies.len() > 1 {
        parts.push(part(1, -1.0));
    }
    parts
}

/// The rate of a coordinate of a joint, times a factor.
fn coordinate_parts(joint: &Joint, coordinate: Coordinate, factor: f64) -> Vec<Part> {
    let axis = if joint.kind == JointKind::Rope || joint.kind == JointKind::Rod {
        (joint.anchors[0] - joint.anchors[1]).normalize()
    } else {
        joint.axes[0].normalize()
    };
    match coordinate {
        Coordinate::Angle => relative(joint, DVec3::ZERO, axis * factor),
        Coordinate::Displacement => relative(joint, axis * factor, DVec3::ZERO),
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

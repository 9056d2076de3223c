//! Accelerations of the joints of a tree by articulated inertias.
//!
//! Motions are (angular, linear at the centre of mass), forces (moment about the centre of mass, force), in world axes.
//! With the motion `A_P` of the parent, that of the child is `X A_P + S u' + c`: `X` carries it from one centre of mass
//! to the other, the columns `S` are what the joint leaves free, `c` is what velocities add.
//!
//! 1. From the root, velocities (`moving.rs`), `c`, and `p`: what a body would need to keep its velocity, less what
//!    acts on it.
//! 2. From the leaves, with the inertia `I` of a body and all that it carries: `U = I S`, `D = S^T U`, and the parent
//!    receives `X^T (I - U D^-1 U^T) X` and `X^T (p + (I - U D^-1 U^T) c - U D^-1 S^T p)`.
//! 3. From the root, `u' = -D^-1 (S^T p + U^T (X A_P + c))`.
//!
//! A joint that nothing drives bears no force along `S`: springs, dampers and motors act on both bodies and are part of
//! `p`. Failure: a body without inertia along a free motion gives numbers that are not finite, and the step is refused.
//! Source: Featherstone 2008, chapter 7.

use super::moving::Moving;
use super::tree::{Node, Tree};
use crate::constraint::tree_joint::FreeMotionOfJoint;
use crate::model::{Loads, Model};
use polhode_dynamics::RigidBody;
use polhode_spatial::{DMat3, DVec3};

/// Angular and linear part: a motion, or a moment and a force.
#[derive(Debug, Clone, Copy, Default)]
struct Twofold {
    angular: DVec3,
    linear: DVec3,
}

impl Twofold {
    fn dot(&self, other: &Self) -> f64 {
        self.angular.dot(other.angular) + self.linear.dot(other.linear)
    }

    fn plus(&self, other: &Self, factor: f64) -> Self {
        Self { angular: self.angular + other.angular * factor, linear: self.linear + other.linear * factor }
    }
}

/// A symmetric inertia in three blocks: `moment = a alpha + b acceleration`, `force = b^T alpha + c acceleration`.
#[derive(Debug, Clone, Copy)]
struct Inertia {
    a: DMat3,
    b: DMat3,
    c: DMat3,
}

// The default of a matrix is one, not zero.
impl Default for Inertia {
    fn default() -> Self {
        Self { a: DMat3::ZERO, b: DMat3::ZERO, c: DMat3::ZERO }
    }
}

impl Inertia {
    fn times(&self, motion: &Twofold) -> Twofold {
        Twofold {
            angular: self.a * motion.angular + self.b * motion.linear,
            linear: self.b.transpose() * motion.angular + self.c * motion.linear,
        }
    }

    /// Less `factor x y^T`.
    fn less(&mut self, factor: f64, x: &Twofold, y: &Twofold) {
        self.a -= outer(x.angular * factor, y.angular);
        self.b -= outer(x.angular * factor, y.linear);
        self.c -= outer(x.linear * factor, y.linear);
    }

    /// As that of a body at the other end of `away` (m), from there to here.
    fn carried(&self, away: DVec3) -> Self {
        let d = cross_matrix(away);
        let b = self.b + d * self.c;
        Self { a: self.a - self.b * d + d * (self.b.transpose() - self.c * d), b, c: self.c }
    }

    fn add(&mut self, other: &Self) {
        self.a += other.a;
        self.b += other.b;
        self.c += other.c;
    }
}

fn outer(x: DVec3, y: DVec3) -> DMat3 {
    DMat3::from_cols(x * y.x, x * y.y, x * y.z)
}

/// The matrix of `d x`.
fn cross_matrix(d: DVec3) -> DMat3 {
    DMat3::from_cols(DVec3::new(0.0, d.z, -d.y), DVec3::new(-d.z, 0.0, d.x), DVec3::new(d.y, -d.x, 0.0))
}

/// A body on the way.
#[derive(Debug, Clone, Copy, Default)]
struct Link {
    inertia: Inertia,
    /// `p`.
    bias: Twofold,
    /// `c`.
    drift: Twofold,
    /// `S` and `U`, of which as many columns count as the joint has speeds.
    free: [Twofold; 3],
    against: [Twofold; 3],
    /// `D^-1`.
    inverse: DMat3,
    acceleration: Twofold,
}

/// The passes, with their memory.
#[derive(Debug, Default)]
pub(crate) struct Articulated {
    moving: Vec<Moving>,
    links: Vec<Link>,
}

/// Force and moment about a point that the world exerts.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct SupportOfTree {
    pub(crate) force: DVec3,
    pub(crate) moment: DVec3,
}

impl Articulated {
    /// The rates of the flat state of a tree under these loads on its bodies, and what the world exerts on it, with
    /// moments about `about` (m, world).
    pub(crate) fn rates(
        &mut self,
        (model, tree): (&Model, &Tree),
        loads: &Loads,
        flat: &[f64],
        rates: &mut [f64],
        about: DVec3,
    ) -> SupportOfTree {
        tree.moving(flat, &mut self.moving);
        tree.coordinate_rates(flat, &self.moving, rates);
        self.links.clear();
        for (node, own) in tree.nodes.iter().zip(&self.moving) {
            let parent = node.parent.map(|parent| self.moving[parent]);
            self.links.push(link(model, loads, (node, own), (parent, &flat[node.u()])));
        }
        let support = self.inwards(tree, about);
        self.outwards(tree, rates);
        support
    }

    /// From the leaves.
    fn inwards(&mut self, tree: &Tree, about: DVec3) -> SupportOfTree {
        let mut support = SupportOfTree::default();
        for (place, node) in tree.nodes.iter().enumerate().rev() {
            if node.joint.is_none() {
                continue;
            }
            let speeds = node.speeds();
            let link = &mut self.links[place];
            for column in 0..speeds {
                link.against[column] = link.inertia.times(&link.free[column]);
            }
            link.inverse = if speeds == 1 {
                DMat3::from_diagonal(DVec3::new(link.free[0].dot(&link.against[0]).recip(), 0.0, 0.0))
            } else {
                let entry = |i: usize, j: usize| link.free[i].dot(&link.against[j]);
                let column = |j: usize| DVec3::new(entry(0, j), entry(1, j), entry(2, j));
                DMat3::from_cols(column(0), column(1), column(2)).inverse()
            };
            let (mut inertia, mut bias) = (link.inertia, link.bias);
            for i in 0..speeds {
                for j in 0..speeds {
                    let factor = link.inverse.col(j)[i];
                    inertia.less(factor, &link.against[i], &link.against[j]);
                    bias = bias.plus(&link.against[i], -factor * link.free[j].dot(&link.bias));
                }
            }
            bias = bias.plus(&inertia.times(&link.drift), 1.0);
            let own = &self.moving[place];
            if let Some(parent) = node.parent {
                let moment = bias.angular + own.away.cross(bias.linear);
                let target = &mut self.links[parent];
                target.inertia.add(&inertia.carried(own.away));
                target.bias = target.bias.plus(&Twofold { angular: moment, linear: bias.linear }, 1.0);
            } else {
                // The world does not move: all that the joint exerts on the child is this.
                support.force += bias.linear;
                support.moment += bias.angular + (own.pose.translation - about).cross(bias.linear);
            }
        }
        support
    }

    /// From the roots.
    fn outwards(&mut self, tree: &Tree, rates: &mut [f64]) {
        for (place, node) in tree.nodes.iter().enumerate() {
            let u = node.u();
            if node.joint.is_none() {
                let link = &mut self.links[place];
                link.acceleration = solved(&link.inertia, &link.bias);
                rates[u.start..u.start + 3].copy_from_slice(&link.acceleration.linear.to_array());
                rates[u.start + 3..u.end].copy_from_slice(&link.acceleration.angular.to_array());
                continue;
            }
            let carried = node.parent.map_or_else(Twofold::default, |parent| {
                let Twofold { angular, linear } = self.links[parent].acceleration;
                Twofold { angular, linear: linear + angular.cross(self.moving[place].away) }
            });
            let link = &mut self.links[place];
            let mut acceleration = carried.plus(&link.drift, 1.0);
            let right: [f64; 3] =
                std::array::from_fn(|i| link.free[i].dot(&link.bias) + link.against[i].dot(&acceleration));
            let speeds = node.speeds();
            for i in 0..speeds {
                let rate = -(0..speeds).map(|j| link.inverse.col(j)[i] * right[j]).sum::<f64>();
                rates[u.start + i] = rate;
                acceleration = acceleration.plus(&link.free[i], rate);
            }
            link.acceleration = acceleration;
        }
    }
}

/// `A` with `I A + p = 0`: by the inverse of `c`, which is positive definite, and that of what is left of `a`.
fn solved(inertia: &Inertia, bias: &Twofold) -> Twofold {
    let inverse = inertia.c.inverse();
    let coupled = inertia.b * inverse;
    let left = inertia.a - coupled * inertia.b.transpose();
    let angular = left.inverse() * (coupled * bias.linear - bias.angular);
    Twofold { angular, linear: -(inverse * (bias.linear + inertia.b.transpose() * angular)) }
}

/// A body with its own inertia, the free motions of its joint, and what velocities and loads add.
fn link(model: &Model, loads: &Loads, (node, own): (&Node, &Moving), (parent, u): (Option<Moving>, &[f64])) -> Link {
    let mut link = Link::default();
    let Some(rigid) = &model.bodies[node.body].rigid else { return link };
    let load = loads.of(node.body);
    let w = own.velocity.angular;
    let momentum = |axis: DVec3| rigid.angular_momentum_at(own.pose.rotation, axis);
    link.inertia.a = DMat3::from_cols(momentum(DVec3::X), momentum(DVec3::Y), momentum(DVec3::Z));
    link.inertia.c = DMat3::from_diagonal(DVec3::splat(rigid.mass()));
    link.bias.angular = w.cross(momentum(w)) - load.torque;
    link.bias.linear = -(load.force + model.free_acceleration(node.body) * RigidBody::mass(rigid));
    let Some(joint) = &node.joint else { return link };
    let about = |axis: DVec3| Twofold { angular: axis, linear: own.arm.cross(axis) };
    let by = parent.map_or(DVec3::ZERO, |parent| parent.velocity.angular);
    // Centripetal accelerations of the anchor about the parent, and of the child about its anchor.
    let of_parent = by.cross(by.cross(own.parent_arm));
    match joint.free {
        FreeMotionOfJoint::Ball => {
            link.free = [about(DVec3::X), about(DVec3::Y), about(DVec3::Z)];
            link.drift.linear = of_parent - w.cross(w.cross(own.arm));
        }
        FreeMotionOfJoint::Hinge => {
            link.free[0] = about(own.axis);
            link.drift.angular = by.cross(own.axis) * u[0];
            link.drift.linear = of_parent - link.drift.angular.cross(own.arm) - w.cross(w.cross(own.arm));
        }
        FreeMotionOfJoint::Slider => {
            link.free[0] = Twofold { angular: DVec3::ZERO, linear: own.axis };
            link.drift.linear = by.cross(by.cross(own.away)) + by.cross(own.axis) * (2.0 * u[0]);
        }
    }
    link
}

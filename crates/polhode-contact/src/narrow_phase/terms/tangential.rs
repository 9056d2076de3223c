//! Tangential terms of a contact: basis of its tangent plane, slip, and the rate of the slip.
//!
//! At the contact point `p` with unit normal `n` (from B to A), `r = p - c` the arms from the centres of mass, the slip
//! is the tangential part of the velocity of A's material point relative to B's:
//!
//! `u_T = P V`,  `P = 1 - n n^T`,  `V = v_A + w_A x r_A - v_B - w_B x r_B`  (m/s).
//!
//! Its derivative is taken along the motion of the contact: the contact point moves over both bodies at `p'` and the
//! normal turns at `n'`, both linear in the velocities. From
//! `V' = v_A' + w_A' x r_A + w_A x (p' - v_A) - (the same of B)` and `P' = -n' n^T - n (n')^T` follows
//!
//! `u_T' = P (v_A' + w_A' x r_A - v_B' - w_B' x r_B) + bias`,
//! `bias = P (w_A x (p' - v_A) - w_B x (p' - v_B)) - (n.V) n' - (n'.V) n`  (m/s^2).
//!
//! This extends thesis 3.4 from the normal to the tangent plane; the normal part of the same `V'` is `chi''`:
//! `n.(w_A x (p' - v_A) - w_B x (p' - v_B)) + n'.V` is the bias of equation (18) with erratum E18.
//!
//! `p'` and `n'` come from the kinds of contacts (`evaluate.rs`, `crossed_edges.rs`, `stationary.rs`); for two smooth
//! surfaces they are what the contact equations give (docs/REFERENCES.md, Montana 1988), in world axes and at any
//! separation. The rates of the point are relative to each centre of mass, so that a common velocity of both bodies
//! costs no digits.
//!
//! Fails where the contact point may jump (edges nearly parallel, a rim that lies almost flat): there `p'` grows
//! without bound, and so does the bias.

use crate::TangentialKinematics;
use glam::DVec3;
use polhode_spatial::Velocity;

/// Cosine between the normal and the x axis above which the y axis is projected instead, because the projection of the
/// x axis on the tangent plane is short (an angle below 25.8 degrees). No common normal (30, 45 or 60 degrees between
/// two axes, the diagonal of a cube) lies at this border. The shortest projection is the lesser of c and sqrt(1 - c^2),
/// here 0.43, and a basis is right to a few roundings. Range: 0.3 to 0.95.
const NEAR_AXIS_COSINE: f64 = 0.9;

/// Two unit vectors `t_1`, `t_2` perpendicular to a unit vector and to each other, `t_1 x t_2 = n`.
///
/// `t_1` is the x axis projected on the plane perpendicular to `normal`, or the y axis where the normal is within 26
/// degrees of the x axis. For `normal` = z the basis is x and y. No continuous field of tangents exists on the sphere;
/// this one is smooth except on the two circles of normals where the axes change; elsewhere it turns by at most about 2
/// rad for each rad of the normal.
///
/// Symmetries, exact to the bit: the basis of `-normal` is `t_1, -t_2` (the bodies swapped), and the basis of a normal
/// mirrored in a coordinate plane is the mirror image of `t_1` and `t_2`, up to the sign of each. Under other rotations
/// of the world the basis does not turn with the tangent plane.
///
/// `normal` must be of unit length. For other vectors the result has no meaning; for a vector that is not finite it is
/// NaN.
pub fn tangent_basis(normal: DVec3) -> [DVec3; 2] {
    let axis = if normal.x.abs() <= NEAR_AXIS_COSINE { DVec3::X } else { DVec3::Y };
    let projected = axis - normal * normal.dot(axis);
    let first = projected / projected.length();
    [first, normal.cross(first)]
}

/// The normal and the point of a contact, with their rates. In pairs A comes first.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactMotion {
    /// `n`.
    pub(crate) normal: DVec3,
    /// `n'`, 1/s.
    pub(crate) normal_rate: DVec3,
    /// `r_A` and `r_B`, m.
    pub(crate) arms: [DVec3; 2],
    /// `p' - v_A` and `p' - v_B`, m/s.
    pub(crate) point_rates: [DVec3; 2],
}

impl ContactMotion {
    pub(crate) fn tangential(&self, a: &Velocity, b: &Velocity) -> TangentialKinematics {
        let Self { normal: n, normal_rate, arms: [arm_a, arm_b], point_rates: [from_a, from_b] } = *self;
        let velocity = (a.linear - b.linear) + (a.angular.cross(arm_a) - b.angular.cross(arm_b));
        let carried = a.angular.cross(from_a) - b.angular.cross(from_b);
        let rate = n.dot(velocity);
        let slip_velocity = velocity - n * rate;
        TangentialKinematics {
            basis: tangent_basis(n),
            slip_velocity,
            acceleration_bias: (carried - n * n.dot(carried)) - normal_rate * rate - n * normal_rate.dot(slip_velocity),
            point_velocity: a.linear + from_a,
            normal_rate,
        }
    }
}

//! What a rigid body is to dynamics: its mass and its inertia about the point that its motion splits at.
//!
//! A free body's moving frame C has its origin at the centre of mass. A pivoted body turns about a point that is held
//! fixed in the world: its frame has the origin there, its inertia is about it (`I + m (|r|^2 1 - r r^T)`, r the arm
//! from the pivot to the centre of mass), no force moves it (its inverse mass is zero), its velocity is zero, and
//! `2 T = w . L` holds all of its kinetic energy.
//!
//! `w = R I^-1 R^T L` (thesis 3.3, below equation 4), `2 T = m |v|^2 + w . L`. Inverses are formed through principal
//! axes, where they are three divisions: elimination on the matrix of a needle would lose the digits of its small
//! moment. Assumes that the mass properties are about the centre of mass, which [`MassProperties`] grants; a moment
//! whose reciprocal overflows (below 1e-308 kg m^2) gives infinite rates, which the next check of a state reports.

use crate::BodyState;
use glam::{DMat3, DVec3};
use polhode_spatial::{Inertia, MassProperties, Pose, PrincipalAxes, Rotation, Velocity};

/// Mass and inertia of a body, with their inverses. The frame C has the axes of the body and its origin at the centre
/// of mass, or at the pivot.
#[derive(Debug, Clone, Copy, PartialEq)]
// In this order: what velocities and energies are made from stands together, at the front.
#[repr(C)]
pub struct RigidBody {
    /// `R_BP` that belongs to `moments`; exactly the identity when the inertia is diagonal in body axes.
    axes: Rotation,
    /// Principal moments in the order of `axes`, kg m^2.
    moments: DVec3,
    /// `p_CBcm`, m, in body axes.
    arm: DVec3,
    mass: f64,
    inverse_mass: f64,
    inertia: DMat3,
    inverse_inertia: DMat3,
    principal: PrincipalAxes,
}

impl RigidBody {
    /// From mass properties; only the inertia about the centre of mass and the mass are used.
    pub fn new(properties: &MassProperties) -> Self {
        let mass = properties.mass();
        Self::from_parts(mass, 1.0 / mass, DVec3::ZERO, properties.inertia())
    }

    /// The body held at a point that stays fixed in the world, `pivot_in_body` (`p_BQ`, m, from the origin of the frame
    /// that the mass properties are in): a top, a pendulum, a rotor on gimbals. Finite numbers are assumed; others
    /// give states that are not finite.
    ///
    /// A [`crate::Flight`] of it is true only where gravity has no torque: no arm, or no gravity.
    pub fn pivoted(properties: &MassProperties, pivot_in_body: DVec3) -> Self {
        let arm = properties.center_of_mass() - pivot_in_body;
        let inertia = properties.inertia().shifted_from_center_of_mass(properties.mass(), arm);
        Self::from_parts(properties.mass(), 0.0, arm, &inertia)
    }

    fn from_parts(mass: f64, inverse_mass: f64, arm: DVec3, inertia: &Inertia) -> Self {
        let principal = inertia.principal_axes();
        let inertia = inertia.matrix();
        // Sorting the moments of a diagonal inertia turns the axes by a right angle, whose quaternion is rounded; a
        // spin about a body axis would then no longer be one exactly. So a diagonal inertia keeps the body's axes.
        let diagonal = inertia.x_axis.y == 0.0 && inertia.x_axis.z == 0.0 && inertia.y_axis.z == 0.0;
        let (moments, axes) = if diagonal {
            (DVec3::new(inertia.x_axis.x, inertia.y_axis.y, inertia.z_axis.z), Rotation::IDENTITY)
        } else {
            (principal.moments(), principal.rotation())
        };
        Self {
            mass,
            inverse_mass,
            arm,
            inertia,
            inverse_inertia: matrix_from_principal(axes, moments.recip()),
            principal,
            moments,
            axes,
        }
    }

    /// Mass, kg.
    pub const fn mass(&self) -> f64 {
        self.mass
    }

    /// Reciprocal of the mass, 1/kg: what a force at the frame's origin moves. Zero for a pivoted body.
    pub const fn inverse_mass(&self) -> f64 {
        self.inverse_mass
    }

    /// Whether the body turns about a fixed pivot.
    pub const fn is_pivoted(&self) -> bool {
        self.inverse_mass == 0.0
    }

    /// `p_CBcm`, m, in body axes: from the pivot to the centre of mass; zero for a free body.
    pub const fn arm(&self) -> DVec3 {
        self.arm
    }

    /// Position of the centre of mass, m, world.
    pub fn center_of_mass_position(&self, state: &BodyState) -> DVec3 {
        if self.arm == DVec3::ZERO {
            return state.pose.translation;
        }
        state.pose.translation + state.pose.rotation.rotate(self.arm)
    }

    /// Velocity of the centre of mass, m/s, world: without the angular velocity, which only a body with an arm needs
    /// for it.
    pub fn center_of_mass_linear_velocity(&self, state: &BodyState) -> DVec3 {
        if self.arm == DVec3::ZERO { state.linear_velocity } else { self.center_of_mass_velocity(state).linear }
    }

    /// Velocity of the centre of mass and angular velocity.
    pub fn center_of_mass_velocity(&self, state: &BodyState) -> Velocity {
        let velocity = self.velocity(state);
        Velocity::new(velocity.at(state.pose.rotation.rotate(self.arm)), velocity.angular)
    }

    /// `I_BBcm_B` (about the pivot of a pivoted body), kg m^2, in body axes.
    pub const fn inertia(&self) -> DMat3 {
        self.inertia
    }

    /// Inverse of the inertia, 1/(kg m^2), in body axes.
    pub const fn inverse_inertia(&self) -> DMat3 {
        self.inverse_inertia
    }

    /// Principal moments in ascending order, and their axes.
    pub const fn principal(&self) -> &PrincipalAxes {
        &self.principal
    }

    /// Principal moments, kg m^2, in the order of [`RigidBody::axes`] (which need not be ascending).
    pub const fn moments(&self) -> DVec3 {
        self.moments
    }

    /// `R_BP` of the principal axes that the dynamics computes in: the identity when the inertia is diagonal in body
    /// axes, else that of [`RigidBody::principal`].
    pub const fn axes(&self) -> Rotation {
        self.axes
    }

    /// The inverse of the generalised mass of linear and angular velocities in world axes (6x6, row by row) of the body
    /// turned by `rotation` (`R_WB`).
    pub fn inverse_mass_block(&self, rotation: Rotation) -> [f64; 36] {
        let mut block = [0.0; 36];
        let inverse_inertia = self.inverse_inertia_world(rotation);
        for i in 0..3 {
            block[i * 6 + i] = self.inverse_mass();
            for j in 0..3 {
                block[(3 + i) * 6 + 3 + j] = inverse_inertia.col(j)[i];
            }
        }
        block
    }

    /// `R I^-1 R^T`, 1/(kg m^2), in world axes, of the body turned by `rotation` (`R_WB`).
    pub fn inverse_inertia_world(&self, rotation: Rotation) -> DMat3 {
        matrix_from_principal(rotation * self.axes, self.moments.recip())
    }

    /// Angular velocity `w_WB`, rad/s, in world axes.
    pub fn angular_velocity(&self, state: &BodyState) -> DVec3 {
        self.angular_velocity_at(state.pose.rotation, state.angular_momentum)
    }

    /// Angular velocity `w_WB = R I^-1 R^T L`, rad/s, of the body turned by `rotation` (`R_WB`) with angular momentum
    /// `L` (kg m^2/s, about the centre of mass, world axes).
    pub fn angular_velocity_at(&self, rotation: Rotation, angular_momentum: DVec3) -> DVec3 {
        let in_body = rotation.inverse_rotate(angular_momentum);
        // Every contact and every stage of a step asks for it, and most bodies are given in principal axes.
        if self.axes == Rotation::IDENTITY {
            return rotation.rotate(in_body / self.moments);
        }
        let in_principal = self.axes.inverse_rotate(in_body);
        rotation.rotate(self.axes.rotate(in_principal / self.moments))
    }

    /// Angular momentum `L = R I R^T w`, kg m^2/s, in world axes.
    pub fn angular_momentum_at(&self, rotation: Rotation, angular_velocity: DVec3) -> DVec3 {
        let in_principal = self.axes.inverse_rotate(rotation.inverse_rotate(angular_velocity));
        rotation.rotate(self.axes.rotate(in_principal * self.moments))
    }

    /// Velocity of the frame's origin (the centre of mass, or the pivot: zero) and angular velocity.
    pub fn velocity(&self, state: &BodyState) -> Velocity {
        Velocity::new(state.linear_velocity, self.angular_velocity(state))
    }

    /// The state at `pose` (`X_WC`) with `velocity`; of a pivoted body the angular velocity alone is taken.
    pub fn at_velocity(&self, pose: Pose, velocity: Velocity) -> BodyState {
        BodyState {
            pose,
            linear_velocity: if self.is_pivoted() { DVec3::ZERO } else { velocity.linear },
            angular_momentum: self.angular_momentum_at(pose.rotation, velocity.angular),
        }
    }

    /// Kinetic energy of the motion of the frame's origin, J: zero for a pivoted body.
    pub fn translational_energy(&self, state: &BodyState) -> f64 {
        0.5 * self.mass * state.linear_velocity.length_squared()
    }

    /// Kinetic energy of the rotation, `w . L / 2`, J.
    pub fn rotational_energy(&self, state: &BodyState) -> f64 {
        // As a sum of squares in principal axes: no term can cancel another.
        let p = self.axes.inverse_rotate(state.pose.rotation.inverse_rotate(state.angular_momentum));
        0.5 * p.dot(p / self.moments)
    }

    /// Kinetic energy, J.
    pub fn kinetic_energy(&self, state: &BodyState) -> f64 {
        self.translational_energy(state) + self.rotational_energy(state)
    }
}

/// `R diag(values) R^T`, symmetric to the last bit.
fn matrix_from_principal(rotation: Rotation, values: DVec3) -> DMat3 {
    let r = rotation.to_matrix();
    let m = r * DMat3::from_diagonal(values) * r.transpose();
    (m + m.transpose()) * 0.5
}

//! From contacts and bodies to the rows that the response crate solves.
//!
//! Generalised velocity of a body: (v of the centre of mass, w), world axes; inverse mass `diag(1/m 1, I^-1)`. The row
//! of a contact is `(n, r_A x n)` for A and `-(n, r_B x n)` for B, with r from the centre of mass to the point
//! (thesis 3.4, equations 15-18). Immovable bodies have no entry (erratum E17).

use crate::interaction::contact_set::ContactId;
use crate::world::World;
use polhode_contact::{ContactGeometry, ContactKinematics};
use polhode_dynamics::BodyState;
use polhode_response::{ContactProblem, ResponseError};
use polhode_spatial::DVec3;

/// Width of a body's generalised velocity in space.
const WIDTH: usize = 6;

/// Contacts of a group of bodies, assembled.
#[derive(Debug)]
pub(crate) struct Assembly {
    pub(crate) problem: ContactProblem,
    /// Movable bodies, in the order of the problem's blocks.
    bodies: Vec<usize>,
}

impl Assembly {
    /// Rows of `contacts` over `bodies` (movable, ascending).
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn new(
        world: &World,
        states: &[BodyState],
        bodies: &[usize],
        contacts: impl Iterator<Item = (ContactId, ContactGeometry)>,
    ) -> Result<Self, ResponseError> {
        let mut inverse_masses = Vec::with_capacity(bodies.len() * WIDTH * WIDTH);
        for &body in bodies {
            push_inverse_mass(&mut inverse_masses, world, states, body);
        }
        let mut problem = ContactProblem::new(WIDTH, inverse_masses)?;
        for (id, geometry) in contacts {
            let block = |body: usize, sign: f64| {
                let index = bodies.binary_search(&body).ok()?;
                let normal = geometry.normal * sign;
                let moment = (geometry.point - states[body].pose.translation).cross(normal);
                Some((index, [normal.x, normal.y, normal.z, moment.x, moment.y, moment.z]))
            };
            match (block(id.a, 1.0), block(id.b, -1.0)) {
                (Some((a, row_a)), Some((b, row_b))) => problem.push_row(&[(a, &row_a), (b, &row_b)]),
                (Some((body, row)), None) | (None, Some((body, row))) => problem.push_row(&[(body, &row)]),
                (None, None) => problem.push_row(&[]),
            }?;
        }
        Ok(Self { problem, bodies: bodies.to_vec() })
    }

    /// Generalised accelerations without contact forces: gravity, and `-I^-1 (w x L)`.
    pub(crate) fn free_accelerations(&self, world: &World, states: &[BodyState]) -> Vec<f64> {
        let mut out = Vec::with_capacity(self.bodies.len() * WIDTH);
        for &body in &self.bodies {
            let state = &states[body];
            let angular = world.bodies[body].rigid.as_ref().map_or(DVec3::ZERO, |rigid| {
                let w = rigid.angular_velocity(state);
                let inverse = rigid.inverse_inertia_world(state.pose.rotation);
                -(inverse * w.cross(state.angular_momentum))
            });
            push(&mut out, world.gravity(), angular);
        }
        out
    }

    /// Constant terms of the relative accelerations of the contacts: `b = J a_free + bias`.
    ///
    /// # Errors
    /// When `free` has the wrong length.
    pub(crate) fn acceleration_constants<'a>(
        &self,
        free: &[f64],
        kinematics: impl Iterator<Item = &'a ContactKinematics>,
    ) -> Result<Vec<f64>, ResponseError> {
        let mut b = self.problem.row_velocities(free)?;
        for (constant, k) in b.iter_mut().zip(kinematics) {
            *constant += k.acceleration_bias;
        }
        Ok(b)
    }

    /// Splits a vector of generalised columns into (body, linear, angular).
    pub(crate) fn split<'a>(&'a self, columns: &'a [f64]) -> impl Iterator<Item = (usize, DVec3, DVec3)> + 'a {
        self.bodies
            .iter()
            .zip(columns.chunks_exact(WIDTH))
            .map(|(&body, c)| (body, DVec3::new(c[0], c[1], c[2]), DVec3::new(c[3], c[4], c[5])))
    }
}

/// Applies impulses (N s) along the normals of contacts to the momenta of their bodies (thesis, equations 10-13).
pub(crate) fn apply_impulses<'a>(
    world: &World,
    states: &mut [BodyState],
    impulses: impl Iterator<Item = (ContactId, &'a ContactGeometry, f64)>,
) {
    for (id, geometry, impulse) in impulses {
        for (body, signed) in [(id.a, impulse), (id.b, -impulse)] {
            if let Some(rigid) = &world.bodies[body].rigid {
                let state = &mut states[body];
                let vector = geometry.normal * signed;
                state.linear_velocity += vector * rigid.inverse_mass();
                state.angular_momentum += (geometry.point - state.pose.translation).cross(vector);
            }
        }
    }
}

fn push(out: &mut Vec<f64>, linear: DVec3, angular: DVec3) {
    out.extend([linear.x, linear.y, linear.z, angular.x, angular.y, angular.z]);
}

/// Appends the 6 x 6 inverse mass of a movable body.
fn push_inverse_mass(out: &mut Vec<f64>, world: &World, states: &[BodyState], body: usize) {
    let start = out.len();
    out.resize(start + WIDTH * WIDTH, 0.0);
    let Some(rigid) = &world.bodies[body].rigid else { return };
    let block = &mut out[start..];
    let inverse_inertia = rigid.inverse_inertia_world(states[body].pose.rotation);
    for i in 0..3 {
        block[i * WIDTH + i] = rigid.inverse_mass();
        for j in 0..3 {
            block[(3 + i) * WIDTH + 3 + j] = inverse_inertia.col(j)[i];
        }
    }
}

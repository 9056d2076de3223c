//! Parts of a crowd (`crowding.rs`): the bodies that may touch each other within a time step make it together, and each
//! part has a step length of its own.
//!
//! With one length for all, a contact that begins to slide somewhere would shorten the steps of every body of a pile. A
//! part is divided further where its step has to be shorter: fewer bodies can meet within it.
//!
//! Two bodies may touch within `h` (s) if their separation is at most
//!
//! `d + 2 h (|v_A - v_B| + |w_A| r_A + |w_B| r_B + g h)`,
//!
//! `d` touch distance (m), `v` velocities (m/s), `w` angular velocities (rad/s), `r` sizes (m; zero for a sphere, which
//! reaches nowhere else by turning), `g` gravity (m/s^2). Impulses within the step may double a velocity.
//!
//! Limit: a faster impulse may drive a body into another part within the step. The search for impacts of different
//! islands finds this, and the steps of both parts end there.

use super::crowd_step::Crowd;
use crate::collision::contact_kinematics;
use crate::model::{Model, prescribed, tolerances};
use polhode_contact::{Shape, separation};
use polhode_dynamics::BodyState;
use polhode_spatial::{DisjointSets, Velocity};
use std::collections::BTreeMap;

/// Safety factor on the distance that a body may travel within a step: impulses may double a speed.
pub(super) const SWEEP_FACTOR: f64 = 2.0;

/// Bodies of a crowd that make a time step together.
#[derive(Debug)]
pub(super) struct CrowdPart {
    /// Movable bodies, ascending.
    pub(super) bodies: Vec<usize>,
    /// The pairs that may touch within its step, ascending.
    pub(super) pairs: Vec<(usize, usize)>,
    /// Its stretch, with the length of the step.
    pub(super) crowd: Crowd,
    /// How many lengths of this step have been refused.
    pub(super) refused: usize,
}

impl CrowdPart {
    /// The parts into which it falls in these states within its step, in the order of their first bodies.
    pub(super) fn divided(self, model: &Model, states: &[BodyState]) -> Vec<Self> {
        let Self { bodies, mut pairs, crowd, refused } = self;
        let place = |body: usize| bodies.binary_search(&body).ok();
        pairs.retain(|&pair| may_touch_within(model, states, pair, crowd.step_s));
        let mut sets = DisjointSets::new(bodies.len());
        let coupled = |&body: &usize| model.couplings_of(body).flatten().map(move |&other| (body, other));
        for (a, b) in pairs.iter().copied().chain(bodies.iter().flat_map(coupled)) {
            if let (Some(a), Some(b)) = (place(a), place(b)) {
                sets.join(a, b);
            }
        }
        let mut parts: BTreeMap<usize, Self> = BTreeMap::new();
        for (index, &body) in bodies.iter().enumerate() {
            let nobody = || Self { bodies: Vec::new(), pairs: Vec::new(), crowd, refused };
            parts.entry(sets.smallest(index)).or_insert_with(nobody).bodies.push(body);
        }
        for pair in pairs {
            let member = place(pair.0).or_else(|| place(pair.1));
            if let Some(part) = member.and_then(|index| parts.get_mut(&sets.smallest(index))) {
                part.pairs.push(pair);
            }
        }
        parts.into_values().collect()
    }
}

/// Whether two bodies in these states may touch within `h` (s). Bodies without a shape, and those whose motion is
/// prescribed, always may.
pub(super) fn may_touch_within(model: &Model, states: &[BodyState], (a, b): (usize, usize), h: f64) -> bool {
    if !model.joints.joint_contacts_of_pair((a, b)).is_empty() {
        return true;
    }
    let Some((shape_a, shape_b)) = contact_kinematics::shapes(model, a, b) else { return true };
    if [a, b].iter().any(|&body| prescribed::trajectory(model, body).is_some()) {
        return true;
    }
    let turn = |shape: &Shape, velocity: Velocity, body: usize| match shape {
        Shape::Sphere(_) => 0.0,
        _ => velocity.angular.length() * model.bodies[body].size,
    };
    let [velocity_a, velocity_b] = [a, b].map(|body| model.velocity(body, &states[body]));
    let speed = (velocity_a.linear - velocity_b.linear).length()
        + turn(shape_a, velocity_a, a)
        + turn(shape_b, velocity_b, b)
        + model.gravity().length() * h;
    let way = tolerances::touch_distance(model, states, a, b) + SWEEP_FACTOR * h * speed;
    separation(shape_a, &states[a].pose, shape_b, &states[b].pose) <= way
}

#[cfg(test)]
mod tests {
    //! A crowd falls into the parts whose bodies may touch each other within the step, and no pair is lost.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use crate::model::pivot_form::PivotRows;
    use crate::scene::Material;
    use crate::scene::{Body, Scene};
    use polhode_mesh::solid_sphere;
    use polhode_spatial::{DVec3, Mass, Pose, UnitVector};

    /// Radius of a ball, and the gaps between neighbours of a row, m.
    const RADIUS_M: f64 = 0.1;
    const GAP_M: f64 = 1e-3;

    /// Balls on a floor in a row, which move along it with these speeds (m/s).
    fn row_of_balls(speeds: &[f64], friction: f64) -> (Model, Vec<BodyState>) {
        let material = Material::new("rubber").with_friction(friction).unwrap();
        let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into());
        let mut scene = Scene::builder("row").body(floor.material(material.clone()));
        for (k, &speed) in speeds.iter().enumerate() {
            let place = DVec3::new((2.0 * RADIUS_M + GAP_M) * k as f64, 0.0, RADIUS_M);
            let ball = solid_sphere(RADIUS_M, Mass::new(1.0).unwrap()).unwrap();
            let ball = Body::movable(format!("ball {k}"), ball).geometry(Shape::sphere(RADIUS_M).unwrap().into());
            let velocity = Velocity::new(DVec3::X * speed, DVec3::ZERO);
            scene = scene.body(ball.pose(Pose::from_translation(place)).velocity(velocity).material(material.clone()));
        }
        Model::new(&scene.build().unwrap(), PivotRows::default()).unwrap()
    }

    /// The bodies and the number of pairs of each part of the row within `h` (s).
    fn parts(speeds: &[f64], friction: f64, h: f64) -> Vec<(Vec<usize>, usize)> {
        let (model, states) = row_of_balls(speeds, friction);
        let bodies: Vec<usize> = (1..=speeds.len()).collect();
        let pairs = (0..=speeds.len()).flat_map(|a| (a + 1..=speeds.len()).map(move |b| (a, b))).collect();
        let crowd = Crowd { until: 1.0, step_s: h, number: 0, spare_error: 0.0 };
        let whole = CrowdPart { bodies, pairs, crowd, refused: 0 };
        whole.divided(&model, &states).into_iter().map(|part| (part.bodies, part.pairs.len())).collect()
    }

    /// Balls that may meet within the step stay together; a shorter step parts them, and each keeps its floor.
    #[test]
    fn shorter_steps_make_smaller_parts() {
        let speeds = [1.0, 0.0, 0.0, -10.0];
        assert_eq!(parts(&speeds, 0.5, 1e-3), [(vec![1, 2], 3), (vec![3, 4], 3)]);
        assert_eq!(parts(&speeds, 0.5, 1e-4), [(vec![1], 1), (vec![2], 1), (vec![3, 4], 3)]);
        assert_eq!(parts(&speeds, 0.5, 1e-6), [1, 2, 3, 4].map(|ball| (vec![ball], 1)));
    }

    /// Balls that move together do not approach each other, however fast they are.
    #[test]
    fn bodies_with_one_velocity_are_apart() {
        assert_eq!(parts(&[30.0, 30.0], 0.5, 1e-3), [(vec![1], 1), (vec![2], 1)]);
    }

    /// Friction changes no part.
    #[test]
    fn crowds_without_friction_fall_into_the_same_parts() {
        let speeds = [1.0, 0.0, 0.0, -10.0];
        for h in [1e-3, 1e-4, 1e-6] {
            assert_eq!(parts(&speeds, 0.0, h), parts(&speeds, 0.5, h));
        }
    }
}

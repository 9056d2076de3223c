//! Kinematic bodies in the model: states and accelerations that are functions of time.
//!
//! The moving frame of a kinematic body is its own frame. Its state holds pose and velocity of its own origin. Since
//! the body has no inertia, the state holds its angular velocity (rad/s, world) in the place of the angular momentum.
//! States of kinematic bodies must be set at every time at which contacts are evaluated ([`Model::prescribe`]).
//!
//! A kinematic body contributes known terms to the rows of its contacts. With the arm r from its origin to the contact
//! point, and the sign + for body A and - for body B:
//!
//! ```text
//! chi'  = J v + sum +-n.(v + w x r)               chi'' = J a + bias + sum +-n.(a + alpha x r)
//! ```
//!
//! where the sums are over the kinematic bodies of the contact. [`polhode_contact::kinematics`] includes the term of
//! `chi'`, and all of `bias`, from the velocities in the states; [`Model::prescribed_acceleration_of`] is the term of
//! `chi''`. The kinematic body does work on the other body: a contact force f has the power `-f` times the term of
//! `chi'` ([`Model::prescribed_rate_of`]), an impulse p does the work `-p` times that term. The ledger books it as
//! external work. The change of energy that an impact law reports is computed from relative velocities and does not
//! include this work.

use crate::identity::contact_id::ContactId;
use crate::model::Model;
use crate::model::prescribed_state::state_at;
use crate::scene::Trajectory;
use polhode_contact::ContactGeometry;
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, Motion};

/// Motion of the moving frame of a kinematic body; none for other bodies.
pub(crate) fn trajectory(model: &Model, body: usize) -> Option<&Trajectory> {
    model.bodies[body].trajectory.as_ref()
}

/// State of a kinematic body at `t` (s); none for other bodies.
pub(crate) fn prescribed_state(model: &Model, body: usize, t: f64) -> Option<BodyState> {
    trajectory(model, body).map(|trajectory| state_at(trajectory, t))
}

/// Sets the states of all kinematic bodies to those at `t` (s).
pub(crate) fn prescribe(model: &Model, t: f64, states: &mut [BodyState]) {
    for &body in &model.prescribed {
        if let (Some(trajectory), Some(state)) = (trajectory(model, body), states.get_mut(body)) {
            *state = state_at(trajectory, t);
        }
    }
}

/// Sets the states of the kinematic members of these pairs, and of those that joints hold, to those at `t` (s).
pub(crate) fn prescribe_members(model: &Model, pairs: &[(usize, usize)], t: f64, states: &mut [BodyState]) {
    for body in prescribed_members(model, pairs).chain(model.joints.drivers.iter().copied()) {
        if let Some(state) = prescribed_state(model, body, t) {
            states[body] = state;
        }
    }
}

/// Whether all kinematic members of these pairs, and those that joints hold to these bodies, stand still from
/// `from` to `to` (s).
pub(crate) fn members_stand_still(
    model: &Model,
    bodies: &[usize],
    pairs: &[(usize, usize)],
    (from, to): (f64, f64),
) -> bool {
    prescribed_members(model, pairs)
        .chain(model.joints.drivers_of(bodies))
        .all(|body| stands_still(model, body, from, to))
}

/// The kinematic members of these pairs; a body in several pairs is repeated.
fn prescribed_members<'a>(model: &'a Model, pairs: &'a [(usize, usize)]) -> impl Iterator<Item = usize> + 'a {
    let pairs = if model.prescribed.is_empty() { &[] } else { pairs };
    pairs.iter().flat_map(|&(a, b)| [a, b]).filter(|&body| trajectory(model, body).is_some())
}

/// Bound on the speed from `t` to `t + h` (s) of the points of a kinematic body in the region that another body
/// occupies at `t`, m/s; zero for other bodies.
pub(crate) fn prescribed_speed_at(
    model: &Model,
    body: usize,
    other: usize,
    states: &[BodyState],
    (t, h): (f64, f64),
) -> f64 {
    trajectory(model, body).map_or(0.0, |trajectory| {
        let bounds = trajectory.bounds(t, t + h);
        let distance = (states[other].pose.translation - states[body].pose.translation).length();
        bounds.speed + bounds.angular_speed * (distance + model.bodies[other].size)
    })
}

/// Prescribed acceleration of a kinematic body's own origin (m/s^2) and angular acceleration (rad/s^2) at `t` (s),
/// world; zero for other bodies.
pub(crate) fn prescribed_acceleration(model: &Model, body: usize, t: f64) -> (DVec3, DVec3) {
    trajectory(model, body).map_or((DVec3::ZERO, DVec3::ZERO), |trajectory| {
        let acceleration = trajectory.acceleration(t);
        (acceleration.linear, acceleration.angular)
    })
}

/// The first time strictly between `from` and `to` (s, `from < to`) at which the motion of a kinematic body of
/// these contacts, or of one that joints hold to these bodies, is not smooth.
pub(crate) fn prescribed_corner_between(
    model: &Model,
    bodies: &[usize],
    contacts: &[ContactId],
    (from, to): (f64, f64),
) -> Option<f64> {
    if model.prescribed.is_empty() {
        return None;
    }
    let members = contacts.iter().flat_map(|id| [id.a, id.b]).chain(model.joints.drivers_of(bodies));
    members.filter_map(|body| trajectory(model, body)?.corner_between(from, to)).reduce(f64::min)
}

/// Whether a kinematic body stands still from `from` to `to` (s), so that bodies may rest on it; true for other
/// bodies.
pub(crate) fn stands_still(model: &Model, body: usize, from: f64, to: f64) -> bool {
    trajectory(model, body).is_none_or(|trajectory| {
        let bounds = trajectory.bounds(from, to);
        bounds.speed == 0.0 && bounds.angular_speed == 0.0
    })
}

/// The first time after `t` (s) at which the motion of a kinematic body is not smooth; infinite when there is none.
pub(crate) fn next_corner(model: &Model, body: usize, t: f64) -> f64 {
    let corner = trajectory(model, body).and_then(|trajectory| trajectory.corner_between(t, f64::INFINITY));
    corner.unwrap_or(f64::INFINITY)
}

/// Whether bodies may rest on this one from `t` (s): on a kinematic body if it stands still until the next time at
/// which its motion is not smooth, on one whose surface moves never, on any other body always.
pub(crate) fn allows_rest(model: &Model, body: usize, t: f64) -> bool {
    let stands = !model.surfaces.are_driven() || model.scene.bodies()[body].velocity_of_surface() == DVec3::ZERO;
    stands && stands_still(model, body, t, next_corner(model, body, t).next_down())
}

/// Term of prescribed velocities in the rate of a contact's separation, m/s.
pub(crate) fn prescribed_rate_of(
    model: &Model,
    states: &[BodyState],
    id: ContactId,
    geometry: &ContactGeometry,
) -> f64 {
    prescribed_term(model, states, id, geometry, |body| {
        let velocity = model.velocity(body, &states[body]);
        (velocity.linear, velocity.angular)
    })
}

/// Work of kinematic bodies on the others by impulses p (N s) along contact normals, J; from forces (N) instead of
/// impulses, their power, W.
pub(crate) fn prescribed_work<'a>(
    model: &Model,
    states: &[BodyState],
    impulses: impl Iterator<Item = (ContactId, &'a ContactGeometry, f64)>,
) -> f64 {
    impulses.map(|(id, geometry, p)| -p * prescribed_rate_of(model, states, id, geometry)).sum()
}

/// Term of prescribed accelerations at `t` (s) in the second derivative of a contact's separation, m/s^2.
pub(crate) fn prescribed_acceleration_of(
    model: &Model,
    t: f64,
    states: &[BodyState],
    id: ContactId,
    geometry: &ContactGeometry,
) -> f64 {
    prescribed_term(model, states, id, geometry, |body| prescribed_acceleration(model, body, t))
}

/// `sum +-n.(linear + angular x r)` over the kinematic bodies of a contact.
fn prescribed_term(
    model: &Model,
    states: &[BodyState],
    id: ContactId,
    geometry: &ContactGeometry,
    rates: impl Fn(usize) -> (DVec3, DVec3),
) -> f64 {
    if model.prescribed.is_empty() {
        return 0.0;
    }
    let members = [(id.a, 1.0), (id.b, -1.0)].into_iter().filter(|&(body, _)| trajectory(model, body).is_some());
    members
        .map(|(body, sign)| {
            let (linear, angular) = rates(body);
            let arm = geometry.point - states[body].pose.translation;
            sign * geometry.normal.dot(linear + angular.cross(arm))
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::contact_kinematics;
    use crate::collision::contact_set;
    use crate::collision::touch::Touch;
    use crate::identity::contact_id::Feature;
    use crate::model::pivot_form::PivotRows;
    use crate::model::reported;
    use crate::rows::assembly::Assembly;
    use crate::rows::groups::Group;
    use crate::scene::{
        Body, Geometry, ImpactLaw, Interpolation, MotionTable, PrescribedMotion, SampledOrientations, Scene,
    };
    use crate::solve::impact::strike_group;
    use polhode_contact::Shape;
    use polhode_dynamics::Flight;
    use polhode_response::Memory;
    use polhode_response::impact::ImpactSettings;
    use polhode_spatial::Velocity;
    use polhode_spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector};
    use std::error::Error;

    type TestResult = Result<(), Box<dyn Error>>;

    const TABLE: usize = 0;
    const BODY: usize = 1;

    fn motions() -> Result<[PrescribedMotion; 3], Box<dyn Error>> {
        let screw = Velocity::new(DVec3::new(0.3, -0.2, 0.5), DVec3::new(0.8, 1.5, -0.6));
        let turns = [DVec3::ZERO, DVec3::new(0.4, 0.9, 0.0), DVec3::new(-0.3, 1.0, 0.8), DVec3::new(0.0, 0.2, 1.5)];
        let table = MotionTable {
            times_s: vec![-0.4, 0.1, 0.7, 1.2],
            positions_m: Some(vec![DVec3::ZERO, DVec3::X * 0.2, DVec3::new(0.1, -0.3, 0.4), DVec3::Z]),
            orientations: Some(SampledOrientations::RotationVectors(turns.to_vec())),
            interpolation: Interpolation::Spline,
        };
        Ok([
            PrescribedMotion::constant_velocity(screw)?,
            PrescribedMotion::sine(DVec3::new(0.2, 0.1, 0.3), DVec3::new(0.2, -0.5, 0.4), 1.3, 0.6)?,
            PrescribedMotion::table(&table)?,
        ])
    }

    /// A kinematic body of this shape, and a body in free flight of the other shape with three different moments.
    fn model(motion: PrescribedMotion, shape: Shape, other: Shape) -> Result<(Model, Vec<BodyState>), Box<dyn Error>> {
        let inertia = Inertia::from_diagonal(DVec3::new(0.2, 0.3, 0.4))?;
        let flying = Body::movable("body", MassProperties::new(Mass::new(2.0)?, DVec3::ZERO, inertia))
            .geometry(Geometry::Shape(other))
            .pose(Pose::new(Rotation::from_rotation_vector(DVec3::new(0.4, -0.3, 1.0)), DVec3::new(0.2, 0.3, 1.9)))
            .velocity(Velocity::new(DVec3::new(0.5, 0.1, -0.7), DVec3::new(1.0, -2.0, 0.5)));
        let table = Body::kinematic("table", motion).geometry(Geometry::Shape(shape));
        let scene = Scene::builder("kinematic").body(table).body(flying).build()?;
        Ok(Model::new(&scene, PivotRows::default())?)
    }

    /// States at `t`: of the kinematic body as prescribed, of the other one in free flight.
    fn states_at(model: &Model, start: &[BodyState], t: f64) -> Vec<BodyState> {
        let mut states = start.to_vec();
        if let Some(rigid) = &model.bodies[BODY].rigid {
            states[BODY] = Flight::new(rigid, 0.0, &start[BODY], model.gravity()).state(t);
        }
        prescribe(model, t, &mut states);
        states
    }

    /// Differences of the separation agree with its derivatives: the first with that of polhode-contact, the second
    /// with `J a_free + bias` plus the term of the kinematic body. Faces, edges, spheres and half-spaces; the kinematic
    /// body is A or B.
    #[test]
    fn separations_of_prescribed_bodies() -> TestResult {
        let cuboid = || Shape::cuboid(DVec3::new(1.5, 1.0, 0.8));
        let ball = || Shape::sphere(0.4);
        let shapes = [
            (cuboid()?, cuboid()?),
            (cuboid()?, ball()?),
            (ball()?, cuboid()?),
            (Shape::half_space(UnitVector::Z), cuboid()?),
        ];
        let (mut contacts, mut with_b) = (0, 0);
        for motion in motions()? {
            for (shape, other) in &shapes {
                let (model, start) = model(motion.clone(), shape.clone(), other.clone())?;
                for t in [0.2, 0.3, 0.5] {
                    let states = states_at(&model, &start, t);
                    for (a, b) in [(TABLE, BODY), (BODY, TABLE)] {
                        for touch in contact_set::contacts_of_pair(&model, &states, a, b, 10.0) {
                            check_derivatives(&model, &start, touch.id, t)?;
                            contacts += 1;
                            with_b += usize::from(b == TABLE);
                        }
                    }
                }
            }
        }
        assert!(contacts > 60 && with_b > 30, "{contacts} {with_b}");
        Ok(())
    }

    fn check_derivatives(model: &Model, start: &[BodyState], id: ContactId, t: f64) -> TestResult {
        let h = 3e-4;
        let separation = |t: f64| {
            let kinematics = contact_kinematics::kinematics(model, &states_at(model, start, t), id);
            kinematics.map(|k| k.geometry.separation).ok_or("no contact")
        };
        let (near, far) =
            ([separation(t - h)?, separation(t + h)?], [separation(t - 2.0 * h)?, separation(t + 2.0 * h)?]);
        let rate = (8.0 * (near[1] - near[0]) - (far[1] - far[0])) / (12.0 * h);
        let second = (16.0 * (near[0] + near[1]) - (far[0] + far[1]) - 30.0 * separation(t)?) / (12.0 * h * h);

        let states = states_at(model, start, t);
        let kinematics = contact_kinematics::kinematics(model, &states, id).ok_or("no contact")?;
        let assembly = Assembly::new(model, &states, &[BODY], [(id, kinematics.geometry)].into_iter())?;
        let free = assembly.free_accelerations(model, &states, &model.loads(t, &states));
        let b = assembly.acceleration_constants(model, t, &states, &free, [(id, &kinematics)].into_iter())?;
        // The error of the differences is 1e-15/h^2 and a sixth derivative times h^4.
        assert!((kinematics.separation_rate - rate).abs() < 1e-8, "{id:?} {} {rate}", kinematics.separation_rate);
        assert!((b[0] - second).abs() < 1e-6, "{id:?} {} {second}", b[0]);

        // The rate of separation is the sum of the movable body's part and the kinematic body's term.
        let velocity = model.velocity(BODY, &states[BODY]);
        let columns = [velocity.linear.to_array(), velocity.angular.to_array()].concat();
        let moved = assembly.problem.row_velocities(&columns)?[0];
        let prescribed = prescribed_rate_of(model, &states, id, &kinematics.geometry);
        assert!((moved + prescribed - kinematics.separation_rate).abs() < 1e-12);
        Ok(())
    }

    /// In an impact with a kinematic body the change of the movable body's energy is the energy change that the law
    /// reports plus the work of the prescribed motion, `-p` times its term of the rate of separation.
    #[test]
    fn work_of_a_prescribed_motion_in_an_impact() -> TestResult {
        let settings = ImpactSettings::default();
        for motion in motions()? {
            let (model, start) = model(motion, Shape::cuboid(DVec3::new(1.5, 1.0, 0.8))?, Shape::sphere(0.4)?)?;
            let mut states = states_at(&model, &start, 0.3);
            states[BODY].linear_velocity = DVec3::new(0.3, 0.2, -9.0);
            let contacts = contact_set::contacts_of_pair(&model, &states, TABLE, BODY, 10.0);
            let touches: Vec<Touch> = contacts.into_iter().map(Touch::from).collect();
            let group = Group { bodies: vec![BODY], contacts: vec![0] };
            let term = prescribed_rate_of(&model, &states, touches[0].id, &touches[0].kinematics.geometry);
            let before = model.energies(BODY, &states[BODY]).0;
            let law = ImpactLaw::Simultaneous;
            let solver = &mut Memory::default();
            let outcome = strike_group(&model, &mut states, &group, &touches, law, &settings, solver)?.outcome;
            let gained = model.energies(BODY, &states[BODY]).0 - before;
            let work = -outcome.impulses[0] * term;
            assert!(
                outcome.impulses[0] > 1.0 && outcome.energy_change < -1.0 && work.abs() > 0.1,
                "{outcome:?} {work}"
            );
            assert!((gained - outcome.energy_change - work).abs() < 1e-12 * before, "{gained} {outcome:?} {work}");
            // Without restitution the contact neither opens nor closes afterwards.
            let after = contact_kinematics::kinematics(&model, &states, touches[0].id).ok_or("no contact")?;
            assert!(after.separation_rate.abs() < 1e-12);
        }
        Ok(())
    }

    /// At the start a kinematic body has the pose and velocity of its motion at t = 0, not the centre of its
    /// oscillation; and it is not among the movable bodies.
    #[test]
    fn states_follow_the_motion() -> TestResult {
        for motion in motions()? {
            let trajectory = motion.from_pose(&motion.initial_pose(&Pose::IDENTITY));
            let (model, states) = model(motion, Shape::sphere(0.4)?, Shape::sphere(0.4)?)?;
            assert_eq!((model.prescribed.as_slice(), model.movable.as_slice()), (&[TABLE][..], &[BODY][..]));
            for t in [0.0, 0.35, 3.0] {
                let now = states_at(&model, &states, t);
                let sample = reported::sample(&model, TABLE, &now[TABLE]);
                assert_eq!((sample.pose, sample.velocity), (trajectory.pose(t), trajectory.velocity(t)));
                assert_eq!(model.velocity(TABLE, &now[TABLE]), trajectory.velocity(t));
                assert_eq!(prescribed_state(&model, TABLE, t), Some(now[TABLE]));
                assert_eq!(prescribed_acceleration(&model, TABLE, t).0, trajectory.acceleration(t).linear);
            }
            assert_eq!(states[TABLE], states_at(&model, &states, 0.0)[TABLE]);
            assert_eq!(
                (prescribed_state(&model, BODY, 0.0), model.energies(TABLE, &states[TABLE])),
                (None, (0.0, 0.0))
            );
            assert_eq!(prescribed_acceleration(&model, BODY, 0.0), (DVec3::ZERO, DVec3::ZERO));
        }
        Ok(())
    }

    fn first_feature(model: &Model) -> Result<Feature, Box<dyn Error>> {
        let states = [TABLE, BODY].map(|body| BodyState::at_rest(Pose::from_translation(DVec3::Z * body as f64)));
        let touches = contact_set::contacts_of_pair(model, &states, TABLE, BODY, 10.0);
        Ok(touches.first().ok_or("no contact")?.id.feature)
    }

    /// The motion of a table is not smooth at its samples, and stands still after the last one.
    #[test]
    fn corners_and_standstill() -> TestResult {
        let [screw, _, table] = motions()?;
        let (model, _) = model(table, Shape::sphere(0.4)?, Shape::sphere(0.4)?)?;
        let touching = [ContactId { a: TABLE, b: BODY, feature: first_feature(&model)? }];
        assert_eq!(prescribed_corner_between(&model, &[], &touching, (0.0, 2.0)), Some(0.1));
        assert_eq!(prescribed_corner_between(&model, &[], &touching, (1.2, f64::INFINITY)), None);
        assert_eq!(prescribed_corner_between(&model, &[], &[], (0.0, 2.0)), None);
        assert!(!stands_still(&model, TABLE, 1.0, 2.0) && stands_still(&model, TABLE, 1.2, f64::INFINITY));
        assert!(stands_still(&model, BODY, 0.0, 2.0));
        let (model, _) = self::model(screw, Shape::sphere(0.4)?, Shape::sphere(0.4)?)?;
        assert!(!stands_still(&model, TABLE, 5.0, 6.0));
        Ok(())
    }
}

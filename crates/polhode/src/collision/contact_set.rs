//! The contacts that touch now, with their identities.
//!
//! A contact is known by its bodies and features, so that its status survives from one event to the next while its
//! geometry is always evaluated afresh. Between events the set is frozen; at an event it is detected again.

use crate::prescribed_state;
use crate::world::{TOUCH_RELATIVE, World};
use polhode_contact::{ContactFeature, ContactKinematics, Manifold, Shape, counterpart, separation};
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, Velocity};

/// Vertices that meet within this fraction of touch are treated alike from both sides; a contact that has left its
/// face by the whole of it is given up, so that the two rules do not undo each other.
const COUNTERPART_FRACTION: f64 = 0.25;

/// Identity of a contact point: two bodies (by number, A before B) and the features that meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct ContactId {
    pub(crate) a: usize,
    pub(crate) b: usize,
    pub(crate) feature: ContactFeature,
}

/// What becomes of a touching contact until the next event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Hold {
    /// It stays: its relative acceleration along the normal is zero and a force may act.
    Held,
    /// It opens, or moves apart: no force acts.
    Open,
}

/// A contact that touches now.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Touch {
    pub(crate) id: ContactId,
    pub(crate) kinematics: ContactKinematics,
    pub(crate) hold: Hold,
    /// Whether `hold` is a decision that was made; a contact that has just been found has none.
    pub(crate) known: bool,
}

impl World {
    /// What `read` makes of the contacts of two bodies with a separation of at most `reach` (m), as
    /// [`polhode_contact::near_manifold`] gives them; none for a body without a shape.
    pub(crate) fn manifold_of<T>(
        &self,
        states: &[BodyState],
        (a, b): (usize, usize),
        reach: f64,
        read: impl FnOnce(&Manifold) -> T,
    ) -> Option<T> {
        let (shape_a, shape_b) = self.shapes(a, b)?;
        let placed = ((shape_a, &states[a].pose), (shape_b, &states[b].pose));
        Some(self.narrow_phase.read((a, b), placed, (reach, self.bodies.len()), read))
    }

    /// The signed separation of two bodies, m, found afresh and at any distance: what a pair is judged by when it is
    /// placed, by a scene or a program, or looked at where a step began, far from the poses that the memory is of. None
    /// for a body without a shape.
    pub(crate) fn separation_afresh(&self, states: &[BodyState], a: usize, b: usize) -> Option<f64> {
        let (shape_a, shape_b) = self.shapes(a, b)?;
        Some(separation(shape_a, &states[a].pose, shape_b, &states[b].pose))
    }

    /// The shapes of a pair that may collide.
    pub(crate) fn shapes(&self, a: usize, b: usize) -> Option<(&Shape, &Shape)> {
        Some((self.bodies[a].shape.as_ref()?, self.bodies[b].shape.as_ref()?))
    }

    /// Velocity of a body's moving frame; zero for one that never moves.
    pub(crate) fn velocity(&self, index: usize, state: &BodyState) -> Velocity {
        match (&self.bodies[index].rigid, &self.bodies[index].trajectory) {
            (Some(rigid), _) => rigid.velocity(state),
            (None, Some(_)) => prescribed_state::velocity_of(state),
            (None, None) => Velocity::ZERO,
        }
    }

    /// Geometry, approach and acceleration terms of a contact at the given states; none when its features no longer
    /// define a contact (edges have become parallel).
    pub(crate) fn kinematics(&self, states: &[BodyState], id: ContactId) -> Option<ContactKinematics> {
        self.kinematics_in_space(states, id).map(|kinematics| self.in_plane(kinematics))
    }

    /// A contact as it acts in planar motion: it stands for its mirror image too, and together they act in the plane.
    fn in_plane(&self, mut kinematics: ContactKinematics) -> ContactKinematics {
        if let Some(plane) = &self.plane {
            let geometry = &mut kinematics.geometry;
            geometry.point = plane.project_point(geometry.point);
            geometry.normal = plane.project_vector(geometry.normal);
        }
        kinematics
    }

    fn kinematics_in_space(&self, states: &[BodyState], id: ContactId) -> Option<ContactKinematics> {
        let (shape_a, shape_b) = self.shapes(id.a, id.b)?;
        let (state_a, state_b) = (&states[id.a], &states[id.b]);
        polhode_contact::kinematics(
            id.feature,
            shape_a,
            &state_a.pose,
            &self.velocity(id.a, state_a),
            shape_b,
            &state_b.pose,
            &self.velocity(id.b, state_b),
        )
    }

    /// From the plane of a planar motion to a contact point that stands for its mirror image too, m; none for a point
    /// that is its own image, and where there is no plane.
    pub(crate) fn mirrored(&self, states: &[BodyState], id: ContactId) -> Option<DVec3> {
        let plane = self.plane?;
        let height = plane.height(self.kinematics_in_space(states, id)?.geometry.point);
        let distance = COUNTERPART_FRACTION * TOUCH_RELATIVE * self.pair_size(id.a, id.b);
        (height.abs() > distance).then(|| plane.normal() * height)
    }

    /// Whether a contact point stands for itself in planar motion, and not its mirror image among the `found` for it.
    /// Where two images separate equally well, collision detection may name one of them alone, on either side.
    fn is_counted(&self, point: DVec3, found: &[Touch], distance: f64) -> bool {
        let Some(plane) = &self.plane else { return true };
        let height = plane.height(point);
        if height >= -distance {
            return true;
        }
        let image = point - plane.normal() * (2.0 * height);
        let mut points = found.iter().map(|other| other.kinematics.geometry.point);
        points.all(|other| (other - image).length() > distance / COUNTERPART_FRACTION)
    }

    /// Contacts of one pair with a separation of at most `reach` (m), sorted by feature. They come as [`Hold::Open`].
    pub(crate) fn contacts_of_pair(&self, states: &[BodyState], a: usize, b: usize, reach: f64) -> Vec<Touch> {
        self.pair(states, a, b, reach).1
    }

    /// The separation of one pair, m, as far as it is within reach, and its contacts as [`Self::contacts_of_pair`]
    /// gives them: two bodies may overlap more than any contact tells.
    pub(crate) fn pair(&self, states: &[BodyState], a: usize, b: usize, reach: f64) -> (f64, Vec<Touch>) {
        let Some((shape_a, shape_b)) = self.shapes(a, b) else { return (f64::INFINITY, Vec::new()) };
        let (pose_a, pose_b) = (&states[a].pose, &states[b].pose);
        let read = |found: &Manifold| {
            (found.separation, found.contacts.iter().map(|contact| contact.feature).collect::<Vec<_>>())
        };
        let Some((separation, mut features)) = self.manifold_of(states, (a, b), reach, read) else {
            return (f64::INFINITY, Vec::new());
        };
        let distance = COUNTERPART_FRACTION * TOUCH_RELATIVE * self.pair_size(a, b);
        for i in 0..features.len() {
            features.extend(counterpart(features[i], shape_a, pose_a, shape_b, pose_b, distance));
        }
        features.sort_unstable();
        features.dedup();
        let found: Vec<Touch> = features
            .into_iter()
            .filter_map(|feature| {
                let id = ContactId { a, b, feature };
                Some(Touch { id, kinematics: self.kinematics_in_space(states, id)?, hold: Hold::Open, known: false })
            })
            .collect();
        let is_counted = |touch: &&Touch| self.is_counted(touch.kinematics.geometry.point, &found, distance);
        let in_motion = |touch: &Touch| Touch { kinematics: self.in_plane(touch.kinematics), ..*touch };
        // A contact that has left its features is none, also where collision detection keeps it as the last of its
        // pair.
        let border = -TOUCH_RELATIVE * self.pair_size(a, b);
        let within = |touch: &Touch| {
            let geometry = &touch.kinematics.geometry;
            geometry.separation <= reach && geometry.margin >= border
        };
        (separation, found.iter().filter(is_counted).map(in_motion).filter(within).collect())
    }
}

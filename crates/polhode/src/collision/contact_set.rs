//! The contacts of a pair of bodies, with identity, geometry and time derivatives.
//!
//! Bodies and features identify a contact, so that its status is kept from one event to the next while its geometry is
//! evaluated anew in every state. Between events the set of contacts is frozen; at an event it is detected again.

use super::contact_modes::ContactModes;
use super::friction_mode::{FrictionCoefficients, RotationalFriction};
use super::turn::Turn;
use crate::collision::{moving_surfaces, passing};
use crate::constraint::{joint_contacts, joint_friction};
use crate::identity::contact_id::{ContactId, Feature};
use crate::model::plane_of_motion::PlaneOfMotion;
use crate::model::{Model, TOUCH_RELATIVE, prescribed_state, tolerances};
use crate::scene::{FrictionEllipse, GrainOf};
use polhode_contact::{ContactKinematics, Manifold, Shape, TangentialKinematics, counterpart, separation};
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, Velocity};

/// Fraction of the touch distance within which two vertices count as meeting, so that a contact of either with a face
/// of the other body is found. A contact is dropped only when it has left its face by the whole touch distance, so that
/// the two rules do not alternate.
const COUNTERPART_FRACTION: f64 = 0.25;

/// The sine of the angle between a grain and the normal of a contact below which it stands on end (no unit, 1e-12 to
/// 1e-6): the direction of its projection would be rounding.
const GRAIN_ON_END: f64 = 1e-9;

/// Whether a touching contact is active until the next event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Hold {
    /// It is active: a force keeps its relative acceleration along the normal at zero.
    Held,
    /// It opens or separates: no force acts.
    Open,
}

/// A contact as collision detection finds it. It is smaller than a [`Touch`]: most are looked at once, and dropped.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FoundContact {
    pub(crate) id: ContactId,
    pub(crate) kinematics: ContactKinematics,
}

/// A pair of bodies that are near each other.
#[derive(Debug)]
pub(crate) struct Pair {
    /// m; infinite when it exceeds the reach. It may be more negative than that of any contact.
    pub(crate) separation: f64,
    /// Sorted by feature.
    pub(crate) contacts: Vec<FoundContact>,
    /// Whether contacts with the plane of a face took the place of some at which the bodies would collide.
    pub(crate) is_passing: bool,
}

impl Pair {
    /// Bodies beyond the reach.
    const fn far() -> Self {
        Self { separation: f64::INFINITY, contacts: Vec::new(), is_passing: false }
    }
}

/// A touching contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Touch {
    pub(crate) id: ContactId,
    pub(crate) kinematics: ContactKinematics,
    pub(crate) hold: Hold,
    /// Whether `hold` has been decided; it has not for a contact that has just been found.
    pub(crate) known: bool,
    /// Whether its features define a contact in the present states; where they do not, `kinematics` are of states
    /// before.
    pub(crate) is_defined: bool,
    pub(crate) modes: ContactModes,
}

impl Touch {
    /// An active contact.
    pub(crate) fn held(id: ContactId, kinematics: ContactKinematics, modes: ContactModes) -> Self {
        Self { id, kinematics, hold: Hold::Held, known: true, is_defined: true, modes }
    }
}

/// A contact that has just been found is open until its status is decided.
impl From<FoundContact> for Touch {
    fn from(FoundContact { id, kinematics }: FoundContact) -> Self {
        Self { id, kinematics, hold: Hold::Open, known: false, is_defined: true, modes: ContactModes::default() }
    }
}

impl Touch {
    /// Its rotations that friction holds at zero.
    pub(crate) fn held_turns(&self) -> impl Iterator<Item = (ContactId, Turn)> {
        let id = self.id;
        self.modes.rotation.held().map(move |turn| (id, turn))
    }
}

/// Passes the manifold of two bodies (contacts with a separation of at most `reach`, m, as
/// [`polhode_contact::near_manifold`] gives them) to `read` and returns its result; none for a body without a
/// shape.
pub(crate) fn manifold_of<T>(
    model: &Model,
    states: &[BodyState],
    (a, b): (usize, usize),
    reach: f64,
    read: impl FnOnce(&Manifold) -> T,
) -> Option<T> {
    let (shape_a, shape_b) = shapes(model, a, b)?;
    let placed = ((shape_a, &states[a].pose), (shape_b, &states[b].pose));
    Some(model.narrow_phase.read((a, b), placed, (reach, model.bodies.len()), read))
}

/// The signed separation of two bodies, m, at any distance, computed without the memory of the pair. It is for
/// poses far from those in the memory: bodies that a scene or a program has placed, and states at the start of a
/// step. None for a body without a shape.
pub(crate) fn separation_without_memory(model: &Model, states: &[BodyState], a: usize, b: usize) -> Option<f64> {
    let (shape_a, shape_b) = shapes(model, a, b)?;
    Some(separation(shape_a, &states[a].pose, shape_b, &states[b].pose))
}

/// The shapes of two bodies; none when one has no shape.
pub(crate) fn shapes(model: &Model, a: usize, b: usize) -> Option<(&Shape, &Shape)> {
    Some((model.bodies[a].shape.as_ref()?, model.bodies[b].shape.as_ref()?))
}

/// Velocity of the moving frame of a body; zero for a fixed body.
pub(crate) fn velocity(model: &Model, index: usize, state: &BodyState) -> Velocity {
    match (&model.bodies[index].rigid, &model.bodies[index].trajectory) {
        (Some(rigid), _) => rigid.velocity(state),
        (None, Some(_)) => prescribed_state::velocity_of(state),
        (None, None) => Velocity::ZERO,
    }
}

/// Geometry of a contact, rate of its separation and bias of its acceleration in these states; none when its
/// features no longer define a contact (edges have become parallel).
pub(crate) fn kinematics(model: &Model, states: &[BodyState], id: ContactId) -> Option<ContactKinematics> {
    kinematics_in_space(model, states, id).map(|kinematics| in_plane(model, kinematics))
}

/// A contact as it acts in planar motion: it represents its mirror image too, and the resultant of both acts in the
/// plane.
fn in_plane(model: &Model, mut kinematics: ContactKinematics) -> ContactKinematics {
    if let Some(plane) = &model.plane {
        let geometry = &mut kinematics.geometry;
        geometry.point = plane.project_point(geometry.point);
        geometry.normal = plane.project_vector(geometry.normal);
    }
    kinematics
}

pub(super) fn kinematics_in_space(model: &Model, states: &[BodyState], id: ContactId) -> Option<ContactKinematics> {
    let feature = match id.feature {
        Feature::Shapes(feature) => feature,
        Feature::Stop(_) | Feature::JointFriction(_) => {
            return joint_contacts::joint_contact_kinematics(model, states, id);
        }
    };
    let (shape_a, shape_b) = shapes(model, id.a, id.b)?;
    let (state_a, state_b) = (&states[id.a], &states[id.b]);
    polhode_contact::kinematics(
        feature,
        shape_a,
        &state_a.pose,
        &velocity(model, id.a, state_a),
        shape_b,
        &state_b.pose,
        &velocity(model, id.b, state_b),
    )
}

/// The coefficients of friction of a contact; none without friction.
pub(crate) fn friction_of(model: &Model, id: ContactId) -> Option<FrictionCoefficients> {
    match id.feature {
        Feature::Shapes(_) => friction_of_surfaces(model, (id.a, id.b)),
        Feature::Stop(_) => None,
        Feature::JointFriction(of) => model.joints.friction_of_joint(of),
    }
}

fn friction_of_surfaces(model: &Model, (a, b): (usize, usize)) -> Option<FrictionCoefficients> {
    if !model.has_friction() {
        return None;
    }
    let material = model.scene.pair_material(a, b);
    let coefficients =
        FrictionCoefficients { at_rest: material.static_ellipse(), sliding: material.friction_ellipse() };
    let resists_rotation = model.surfaces.have_rotational_friction() && rotational_friction_of(model, a, b).is_some();
    (coefficients.at_rest.largest() > 0.0 || resists_rotation).then_some(coefficients)
}

/// The coefficients of friction of a contact whose tangents are these; none without friction. Where the grain
/// stands on end, every direction is across it.
pub(crate) fn friction_at(
    model: &Model,
    states: &[BodyState],
    id: ContactId,
    basis: [DVec3; 2],
) -> Option<FrictionCoefficients> {
    let coefficients = friction_of(model, id)?;
    if !model.surfaces.have_grain() || grain_in_plane(model, states, id, basis).is_some() {
        return Some(coefficients);
    }
    let across = |ellipse: FrictionEllipse| FrictionEllipse::circle(ellipse.across);
    Some(FrictionCoefficients { at_rest: across(coefficients.at_rest), sliding: across(coefficients.sliding) })
}

/// The direction of the grain of a contact in its tangent plane (unit vector, world); none without a grain, and
/// where it stands on end.
fn grain_in_plane(model: &Model, states: &[BodyState], id: ContactId, basis: [DVec3; 2]) -> Option<DVec3> {
    let grain = model.scene.pair_material(id.a, id.b).grain()?;
    let body = if grain.of == GrainOf::Second { id.b } else { id.a };
    let direction = states[body].pose.rotation.rotate(grain.direction);
    let [x, y] = basis.map(|tangent| tangent * tangent.dot(direction));
    let in_plane = x + y;
    let length = in_plane.length();
    (length > GRAIN_ON_END).then(|| in_plane / length)
}

/// The friction of rolling and spinning of two bodies; none without either.
pub(crate) fn rotational_friction_of(model: &Model, a: usize, b: usize) -> Option<RotationalFriction> {
    if !model.surfaces.have_rotational_friction() || !model.joints.joint_contacts_of_pair((a, b)).is_empty() {
        return None;
    }
    let material = model.scene.pair_material(a, b);
    let lengths = RotationalFriction { rolling: material.rolling_friction(), spinning: material.spinning_friction() };
    (lengths.rolling > 0.0 || lengths.spinning > 0.0).then_some(lengths)
}

/// The angular velocity of A relative to B, rad/s.
pub(crate) fn relative_rotation(model: &Model, states: &[BodyState], id: ContactId) -> DVec3 {
    velocity(model, id.a, &states[id.a]).angular - velocity(model, id.b, &states[id.b]).angular
}

/// Slip of a contact and the terms of its derivative, in motion in space; none as for [`Self::kinematics`]. Of
/// contacts with a grain the first tangent is along it; in planar motion it lies in the plane.
pub(crate) fn tangential_kinematics(
    model: &Model,
    states: &[BodyState],
    id: ContactId,
) -> Option<TangentialKinematics> {
    let feature = match id.feature {
        Feature::Shapes(feature) => feature,
        Feature::Stop(_) => return None,
        Feature::JointFriction(of) => return joint_friction::friction_slip(model, states, of),
    };
    let (shape_a, shape_b) = shapes(model, id.a, id.b)?;
    let (state_a, state_b) = (&states[id.a], &states[id.b]);
    let (velocity_a, velocity_b) = (velocity(model, id.a, state_a), velocity(model, id.b, state_b));
    let (a, b) = ((shape_a, &state_a.pose, &velocity_a), (shape_b, &state_b.pose, &velocity_b));
    let found = polhode_contact::kinematics_with_tangential(feature, a.0, a.1, a.2, b.0, b.1, b.2);
    let mut terms = found.map(|(_, terms)| terms)?;
    if model.surfaces.are_driven() {
        moving_surfaces::add_surface_slip(model, states, id, &mut terms);
    }
    if model.surfaces.have_grain()
        && let Some(along) = grain_in_plane(model, states, id, terms.basis)
    {
        let [x, y] = terms.basis;
        terms.basis = [along, x.cross(y).cross(along)];
    }
    if let Some(plane) = &model.plane {
        let [x, y] = terms.basis;
        terms.basis = plane.tangents(x.cross(y));
        // Rounding may leave a slip out of the plane, which would turn the direction of one that ends.
        terms.slip_velocity = terms.basis[0] * terms.basis[0].dot(terms.slip_velocity);
    }
    Some(terms)
}

/// In planar motion: the vector from the plane to a contact point that represents its mirror image too, m. None for
/// a point that is its own image, and in motion in space.
pub(crate) fn mirrored(model: &Model, states: &[BodyState], id: ContactId) -> Option<DVec3> {
    let plane = model.plane?;
    let height = plane.height(kinematics_in_space(model, states, id)?.geometry.point);
    let distance = COUNTERPART_FRACTION * TOUCH_RELATIVE * tolerances::pair_size(model, id.a, id.b);
    (height.abs() > distance).then(|| plane.normal() * height)
}

/// Contacts of one pair with a separation of at most `reach` (m), sorted by feature.
pub(crate) fn contacts_of_pair(
    model: &Model,
    states: &[BodyState],
    a: usize,
    b: usize,
    reach: f64,
) -> Vec<FoundContact> {
    pair(model, states, a, b, reach).contacts
}

/// The separation of one pair, m, and its contacts as [`Self::contacts_of_pair`] gives them.
pub(crate) fn pair(model: &Model, states: &[BodyState], a: usize, b: usize, reach: f64) -> Pair {
    if let Some(stops) = pair_of_joint_contacts(model, states, (a, b), reach) {
        return stops;
    }
    let found = manifold_with_counterparts(model, states, (a, b), reach);
    found.map_or_else(Pair::far, |found| pair_of(model, states, (a, b), reach, found))
}

/// [`Self::pair`] where the bodies, or one of their contacts, penetrate by more than `depth` (m); none elsewhere.
pub(crate) fn penetrating_pair(
    model: &Model,
    states: &[BodyState],
    (a, b): (usize, usize),
    reach: f64,
    depth: f64,
) -> Option<Pair> {
    let penetrates = |separation: f64| separation < -depth;
    if let Some(stops) = pair_of_joint_contacts(model, states, (a, b), reach) {
        return penetrates(stops.separation).then_some(stops);
    }
    let (separation, contacts) = manifold_with_counterparts(model, states, (a, b), reach)?;
    let is_deep = contacts.iter().any(|contact| penetrates(contact.kinematics.geometry.separation));
    (is_deep || penetrates(separation)).then(|| pair_of(model, states, (a, b), reach, (separation, contacts)))
}

/// The contacts at the joints of two bodies; none of bodies without them.
fn pair_of_joint_contacts(model: &Model, states: &[BodyState], pair: (usize, usize), reach: f64) -> Option<Pair> {
    if !model.joints.has_joint_contacts() || model.joints.joint_contacts_of_pair(pair).is_empty() {
        return model.joints.lost_joint_contacts(pair).then(Pair::far);
    }
    let contacts = joint_contacts::joint_contacts_within(model, states, pair, reach).into_iter();
    let contacts: Vec<FoundContact> =
        contacts.map(|found| FoundContact { kinematics: in_plane(model, found.kinematics), ..found }).collect();
    let separations = contacts.iter().map(|found| found.kinematics.geometry.separation);
    Some(Pair { separation: separations.fold(f64::INFINITY, f64::min), contacts, is_passing: false })
}

fn pair_of(
    model: &Model,
    states: &[BodyState],
    (a, b): (usize, usize),
    reach: f64,
    (separation, mut contacts): (f64, Vec<FoundContact>),
) -> Pair {
    let passing = passing::take_place_of_collisions(model, states, (a, b), &mut contacts);
    let is_passing = !passing.is_empty();
    let contacts = within(model, (a, b), reach, contacts, &passing);
    Pair { separation, contacts, is_passing }
}

/// The separation of one pair, m, and its contacts with a separation of at most `reach` (m) by the poses of its
/// bodies alone: also those at which the bodies pass each other.
pub(crate) fn pair_at_poses(model: &Model, states: &[BodyState], a: usize, b: usize, reach: f64) -> Pair {
    if let Some(stops) = pair_of_joint_contacts(model, states, (a, b), reach) {
        return stops;
    }
    let Some((separation, contacts)) = manifold_with_counterparts(model, states, (a, b), reach) else {
        return Pair::far();
    };
    Pair { separation, contacts: within(model, (a, b), reach, contacts, &[]), is_passing: false }
}

/// Separation (m) and contacts of one pair, sorted by feature; none when its separation exceeds `reach` (m).
fn manifold_with_counterparts(
    model: &Model,
    states: &[BodyState],
    (a, b): (usize, usize),
    reach: f64,
) -> Option<(f64, Vec<FoundContact>)> {
    let (shape_a, shape_b) = shapes(model, a, b)?;
    let (pose_a, pose_b) = (&states[a].pose, &states[b].pose);
    let read =
        |found: &Manifold| (found.separation, found.contacts.iter().map(|contact| contact.feature).collect::<Vec<_>>());
    let (separation, mut features) = manifold_of(model, states, (a, b), reach, read)?;
    let distance = COUNTERPART_FRACTION * TOUCH_RELATIVE * tolerances::pair_size(model, a, b);
    for i in 0..features.len() {
        features.extend(counterpart(features[i], shape_a, pose_a, shape_b, pose_b, distance));
    }
    features.sort_unstable();
    features.dedup();
    let found = features.into_iter().filter_map(|feature| {
        let id = ContactId { a, b, feature: Feature::Shapes(feature) };
        Some(FoundContact { id, kinematics: kinematics_in_space(model, states, id)? })
    });
    Some((separation, found.collect()))
}

/// Those of the contacts of one pair that are within `reach` (m) and on their features, or among `passing`
/// (ascending); in planar motion, those that are counted.
fn within(
    model: &Model,
    (a, b): (usize, usize),
    reach: f64,
    found: Vec<FoundContact>,
    passing: &[Feature],
) -> Vec<FoundContact> {
    // A contact that has left its features is dropped, even if collision detection keeps it as the last one of its
    // pair.
    let border = -TOUCH_RELATIVE * tolerances::pair_size(model, a, b);
    let within = |contact: &FoundContact| {
        let geometry = &contact.kinematics.geometry;
        geometry.separation <= reach
            && (geometry.margin >= border || passing.binary_search(&contact.id.feature).is_ok())
    };
    let Some(plane) = &model.plane else { return found.into_iter().filter(within).collect() };
    let distance = COUNTERPART_FRACTION * TOUCH_RELATIVE * tolerances::pair_size(model, a, b);
    let is_counted = |contact: &&FoundContact| is_counted(plane, contact.kinematics.geometry.point, &found, distance);
    let in_motion =
        |contact: &FoundContact| FoundContact { kinematics: in_plane(model, contact.kinematics), ..*contact };
    found.iter().filter(is_counted).map(in_motion).filter(within).collect()
}

/// Whether a contact point is kept in planar motion. One below the plane is left out when its mirror image is among
/// `found`; it is kept when collision detection has found it alone, which may happen where both images have the same
/// separation.
fn is_counted(plane: &PlaneOfMotion, point: DVec3, found: &[FoundContact], distance: f64) -> bool {
    let height = plane.height(point);
    if height >= -distance {
        return true;
    }
    let image = point - plane.normal() * (2.0 * height);
    let mut points = found.iter().map(|other| other.kinematics.geometry.point);
    points.all(|other| (other - image).length() > distance / COUNTERPART_FRACTION)
}

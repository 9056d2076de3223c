//! The contacts that may act within a step, with their kinematics at its start.

use super::drift;
use crate::collision::touch::{FoundContact, Touch};
use crate::collision::{contact_kinematics, contact_set, covered_borders, friction, passing};
use crate::identity::contact_id::ContactId;
use crate::joints::joint_contacts;
use crate::model::states_of::{set_states, states_of};
use crate::model::{Model, prescribed, tolerances};
use crate::rows::assembly::free_acceleration;
use crate::solve::joint_reactions::JointReactions;
use polhode_contact::{ContactKinematics, Shape};
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// A contact counts as sustained, and its restitution as zero, when it approaches more slowly than gravity and fields
/// make its bodies approach within this many steps: a bounce at that speed lasts less than two steps and cannot be
/// resolved. At least one step is needed, so that a body comes to rest after falling for one step. More steps would
/// lose bounces that could be resolved.
pub(super) const RESTING_STEPS: f64 = 2.0;

/// Bodies that travel less than this fraction of the smaller size in a step will touch at the features that are nearest
/// now. It is the touch distance.
const STANDING_RELATIVE: f64 = 1e-11;

/// Safety factor on the distance within which contacts are detected: impulses of other contacts may double a speed.
const REACH_FACTOR: f64 = 2.0;

/// Cosine of the angle by which the normal of a contact turns at most within a step (no unit, 0.2 to 0.8): what turns
/// by a radian in a step is warned of.
const NORMAL_OF_ONE_CONTACT: f64 = 0.5;

/// The length of a step, and the height of bounces that it need not resolve.
#[derive(Debug, Clone, Copy)]
pub(super) struct Span {
    /// Its length, s.
    pub(super) h: f64,
    /// Largest height of a bounce that need not be resolved, relative to the size of the smaller body; infinite where
    /// only the step length decides.
    pub(super) unseen_bounce: f64,
}

/// A contact within reach of a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct NearContact {
    pub(super) id: ContactId,
    /// At the start of the step.
    pub(super) kinematics: ContactKinematics,
    /// `chi''` there without contact forces, m/s^2.
    pub(super) acceleration: f64,
    /// Speed of approach up to which the contact counts as sustained, m/s.
    pub(super) resting_speed: f64,
    /// Speed of approach up to which its bounces are lower than those that need be resolved, m/s; zero where only the
    /// step length decides.
    pub(super) unseen_speed: f64,
    /// Whether it closes at the end of the step, where it will bounce. Nothing presses it before; what its time is
    /// wrong by, it penetrates.
    pub(super) is_awaited: bool,
    /// By how much less than its gap it may approach within the step, m (`repeated.rs`).
    pub(super) kept_off: f64,
}

impl NearContact {
    /// Whether the contact touches, or is so close that a step of `h` (s) cannot distinguish it from a touching one.
    pub(super) fn touches(&self, h: f64, touch_distance: f64) -> bool {
        self.kinematics.geometry.separation <= touch_distance.max(self.resting_speed * h)
    }

    /// Lets the contact approach by so much less (m) within the step. Returns whether that changes anything.
    pub(super) fn keep_off(&mut self, less: f64) -> bool {
        let changes = self.kept_off < self.kinematics.geometry.separation;
        self.kept_off += less;
        changes
    }

    /// Whether these kinematics later in the step are those of the same contact: its normal has hardly turned. Where a
    /// rim or a vertex has passed an edge, the direction from one to the other is no normal of the surfaces.
    pub(super) fn is_same(&self, later: &ContactKinematics) -> bool {
        let (before, after) = (self.kinematics.geometry.normal, later.geometry.normal);
        before.dot(after) >= NORMAL_OF_ONE_CONTACT * before.length() * after.length()
    }

    /// Whether the contact would be stopped within a step of `h` (s) by the problem in its middle, and leave an overlap
    /// of more than this (m).
    pub(super) fn overlaps_in_middle(&self, h: f64, allowed: f64) -> bool {
        let rate = self.kinematics.separation_rate;
        rate < 0.0 && self.kinematics.geometry.separation.max(0.0) + 0.5 * h * rate < -allowed
    }

    /// The time to an impact within a step of `h` (s), s: if the contact closes before its end, faster than a sustained
    /// contact.
    pub(super) fn impact_time(&self, h: f64) -> Option<f64> {
        let is_fast = self.kinematics.separation_rate < -self.resting_speed;
        self.closing_time().filter(|&time| is_fast && time < h)
    }

    /// Whether the impact law acts on the contact at the start of a step of `h`: it closes within `instant` (s), or it
    /// closes later in the step and has restitution. Without restitution it would be stopped before it touches, and so
    /// is one whose bounce would be too low to be seen: of bodies that lean on each other each such bounce makes the
    /// next step shorter.
    pub(super) fn is_struck(&self, model: &Model, h: f64, instant: f64) -> bool {
        let bounces = || joint_contacts::restitution_of(model, self.id) > 0.0;
        let is_seen = self.kinematics.separation_rate < -self.unseen_speed;
        self.impact_time(h).is_some_and(|time| is_seen && (time <= instant || bounces()))
    }

    /// The time from now at which the gap closes in flight, s, `gap + u s + a s^2/2 = 0`; none when it does not.
    pub(super) fn closing_time(&self) -> Option<f64> {
        let gap = self.kinematics.geometry.separation.max(0.0);
        let (u, a) = (self.kinematics.separation_rate, self.acceleration);
        let discriminant = u * u - 2.0 * a * gap;
        // The smaller root without cancellation; NaN gives none.
        let root = (discriminant >= 0.0).then(|| -u + discriminant.sqrt())?;
        (root > 0.0).then(|| 2.0 * gap / root)
    }
}

/// Linear and angular accelerations without contact forces of some bodies, ascending.
#[derive(Debug)]
pub(super) struct FreeAccelerations<'a> {
    model: &'a Model,
    /// When, s.
    t: f64,
    bodies: &'a [usize],
    values: Vec<(DVec3, DVec3)>,
}

impl<'a> FreeAccelerations<'a> {
    /// Under gravity and the fields at `t`.
    pub(super) fn with_fields(model: &'a Model, t: f64, states: &[BodyState], bodies: &'a [usize]) -> Self {
        let loads = model.loads_on(t, states, bodies);
        let values = bodies.iter().map(|&body| free_acceleration(model, states, &loads, body)).collect();
        Self { model, t, bodies, values }
    }

    fn of(&self, body: usize) -> (DVec3, DVec3) {
        self.bodies.binary_search(&body).map_or((DVec3::ZERO, DVec3::ZERO), |index| self.values[index])
    }

    /// `chi''` of a contact under these accelerations, m/s^2.
    pub(super) fn relative(&self, states: &[BodyState], id: ContactId, kinematics: &ContactKinematics) -> f64 {
        let geometry = &kinematics.geometry;
        let at_point = |body: usize| {
            let (linear, angular) = self.of(body);
            linear + angular.cross(geometry.point - states[body].pose.translation)
        };
        let relative = geometry.normal.dot(id.relative(at_point)) + kinematics.acceleration_bias;
        relative + prescribed::prescribed_acceleration_of(self.model, self.t, states, id, geometry)
    }

    /// Largest linear acceleration, m/s^2.
    fn largest(&self) -> f64 {
        self.values.iter().fold(0.0, |most, (linear, _)| linear.length().max(most))
    }
}

/// A contact at the present states with the relative velocity of the bodies at its point, `n.(v_A - v_B)`, as its rate.
/// The rate of the separation differs from it if the contact point is very close to the end of a rim or an edge. The
/// change of energy by impulses is exact only in the relative velocity.
pub(super) fn kinematics_at_point(model: &Model, states: &[BodyState], id: ContactId) -> Option<ContactKinematics> {
    contact_kinematics::kinematics(model, states, id)
        .map(|kinematics| with_rate_at_point(model, states, id, kinematics))
}

/// A contact with the rate of separation at its point, m/s.
pub(super) fn with_rate_at_point(
    model: &Model,
    states: &[BodyState],
    id: ContactId,
    kinematics: ContactKinematics,
) -> ContactKinematics {
    let point = kinematics.geometry.point;
    let at_point = |body: usize| {
        let velocity = model.velocity(body, &states[body]);
        velocity.linear + velocity.angular.cross(point - states[body].pose.translation)
    };
    ContactKinematics { separation_rate: kinematics.geometry.normal.dot(id.relative(at_point)), ..kinematics }
}

/// The contacts of `pairs` that may close within `h` seconds, sorted: those within reach now, and those at which the
/// bodies would penetrate at the end of their flight. While bodies are apart, the features that will meet need not be
/// the nearest ones yet (the nearest points of two edges may lie beyond their ends).
pub(super) fn near_contacts(
    model: &Model,
    states: &mut [BodyState],
    bodies: &[usize],
    pairs: &[(usize, usize)],
    t: f64,
    span: Span,
) -> Vec<NearContact> {
    let h = span.h;
    prescribed::prescribe_members(model, pairs, t, states);
    let mut near = contacts_within_reach(model, states, bodies, pairs, t, span);
    remove_covered_borders(model, states, &mut near);
    let pairs: Vec<_> = pairs.iter().copied().filter(|&pair| may_change_features(model, states, pair, h)).collect();
    if pairs.is_empty() {
        foresee_with_joints(model, states, bodies, &mut near, t);
        return near;
    }
    let start = states_of(states, bodies);
    for (&body, state) in bodies.iter().zip(&start) {
        states[body] = drift(model, body, state, h);
    }
    prescribed::prescribe_members(model, &pairs, t + h, states);
    let mut ahead = Vec::new();
    for &(a, b) in &pairs {
        let reach = tolerances::touch_distance(model, states, a, b);
        ahead.extend(contact_set::contacts_of_pair(model, states, a, b, reach).into_iter().map(|touch| touch.id));
    }
    set_states(states, bodies, &start);
    prescribed::prescribe_members(model, &pairs, t, states);
    ahead.retain(|id| near.binary_search_by(|contact| contact.id.cmp(id)).is_err());
    let free = FreeAccelerations::with_fields(model, t, states, bodies);
    for id in ahead {
        let Some(kinematics) = kinematics_at_point(model, states, id) else { continue };
        // Features that already penetrate are not those at which the bodies will meet.
        // Nor are those at a border that the bodies pass.
        if kinematics.geometry.separation >= -tolerances::touch_distance(model, states, id.a, id.b)
            && !passing::pass_each_other(model, states, id, &kinematics)
        {
            near.push(near_contact(model, states, &free, id, kinematics, span));
        }
    }
    near.sort_by_key(|contact| contact.id);
    foresee_with_joints(model, states, bodies, &mut near, t);
    near
}

/// Takes the accelerations that joints give, too, where a contact of bodies that they hold may bounce: the time of its
/// impact follows from it.
pub(super) fn foresee_with_joints(
    model: &Model,
    states: &[BodyState],
    bodies: &[usize],
    near: &mut [NearContact],
    t: f64,
) {
    let held = model.joints.held_among(bodies);
    let may_bounce = |contact: &NearContact| {
        contact.kinematics.separation_rate < -contact.resting_speed
            && contact.id.members().any(|(body, _)| held.binary_search(&body).is_ok())
            && joint_contacts::restitution_of(model, contact.id) > 0.0
    };
    if held.is_empty() || !near.iter().any(may_bounce) {
        return;
    }
    let of_bouncing = near.iter().filter(|contact| may_bounce(contact)).flat_map(|contact| contact.id.members());
    let mut members: Vec<usize> =
        of_bouncing.map(|(body, _)| body).filter(|body| held.binary_search(body).is_ok()).collect();
    members.sort_unstable();
    members.dedup();
    let members = model.joints.with_jointed(members);
    let loads = model.loads_on(t, states, &members);
    let Ok(reactions) = JointReactions::solve(model, (t, states), &members, &loads) else { return };
    let Ok(given) = reactions.assembly.problem.response(&reactions.forces) else { return };
    let mut free = FreeAccelerations::with_fields(model, t, states, bodies);
    for (body, linear, angular) in reactions.assembly.split(&given) {
        if let Ok(place) = bodies.binary_search(&body) {
            let (own_linear, own_angular) = &mut free.values[place];
            *own_linear += linear;
            *own_angular += angular;
        }
    }
    for contact in near.iter_mut().filter(|contact| may_bounce(contact)) {
        contact.acceleration = free.relative(states, contact.id, &contact.kinematics);
    }
}

/// Marks the contacts of bodies that joints hold which bounce at the end of a step of `h` (s), where `left` (s) are
/// left of the whole one. Those of bodies in flight close there to rounding, or are closed by what presses them.
pub(super) fn await_impacts(model: &Model, near: &mut [NearContact], (h, left): (f64, f64), instant: f64) {
    for contact in near {
        let closes = contact.impact_time(left).is_some_and(|time| time > instant && (time - h).abs() <= instant);
        let is_held = contact.id.members().any(|(body, _)| model.joints.is_held_by_rows(body));
        contact.is_awaited = closes && is_held && joint_contacts::restitution_of(model, contact.id) > 0.0;
    }
}

/// Removes the touching contacts at borders that other touching bodies cover: whether a surface is of one body or of
/// several that are flush makes no difference.
fn remove_covered_borders(model: &Model, states: &[BodyState], near: &mut Vec<NearContact>) {
    if !near.iter().any(|contact| covered_borders::may_be_at_border(model, contact.id)) {
        return;
    }
    let is_touching = |contact: &&NearContact| {
        contact.kinematics.geometry.separation <= tolerances::touch_distance(model, states, contact.id.a, contact.id.b)
    };
    let all: Vec<Touch> = near.iter().filter(is_touching).map(touch).collect();
    let mut left = all.clone();
    covered_borders::remove_covered_borders(model, states, &mut left);
    if left.len() < all.len() {
        let is_in = |touches: &[Touch], id: ContactId| touches.binary_search_by(|touch| touch.id.cmp(&id)).is_ok();
        near.retain(|contact| !is_in(&all, contact.id) || is_in(&left, contact.id));
    }
}

/// A contact as the other tiers know it.
pub(super) fn touch(contact: &NearContact) -> Touch {
    Touch::from(FoundContact { id: contact.id, kinematics: contact.kinematics })
}

/// Whether the features at which two bodies meet may change within a step of `h` (s). They do not for two spheres, nor
/// for a polyhedron and a half-space, whose vertices are all within reach, nor for bodies that hardly move.
pub(super) fn may_change_features(model: &Model, states: &[BodyState], (a, b): (usize, usize), h: f64) -> bool {
    let Some((shape_a, shape_b)) = contact_kinematics::shapes(model, a, b) else { return false };
    let is_simple = |shape: &Shape| matches!(shape, Shape::HalfSpace(_));
    let is_sphere = |shape: &Shape| matches!(shape, Shape::Sphere(_));
    let is_polyhedral = |shape: &Shape| matches!(shape, Shape::Convex(_) | Shape::Sphere(_) | Shape::Points(_));
    if (is_simple(shape_a) && is_polyhedral(shape_b)) || (is_simple(shape_b) && is_polyhedral(shape_a)) {
        return false;
    }
    if is_sphere(shape_a) && is_sphere(shape_b) {
        return false;
    }
    let travel = h * (tolerances::point_speed(model, states, a) + tolerances::point_speed(model, states, b));
    travel > STANDING_RELATIVE * tolerances::pair_size(model, a, b)
}

/// As [`near_contacts`], only those within reach now.
fn contacts_within_reach(
    model: &Model,
    states: &[BodyState],
    bodies: &[usize],
    pairs: &[(usize, usize)],
    t: f64,
    span: Span,
) -> Vec<NearContact> {
    let h = span.h;
    let free = FreeAccelerations::with_fields(model, t, states, bodies);
    let speed = bodies.iter().fold(0.0, |most, &body| tolerances::point_speed(model, states, body).max(most));
    let reach = REACH_FACTOR * h * (speed + free.largest() * h);
    let mut near = Vec::new();
    for &(a, b) in pairs {
        let driven =
            [(a, b), (b, a)].map(|(body, other)| prescribed::prescribed_speed_at(model, body, other, states, (t, h)));
        let reach =
            reach + REACH_FACTOR * h * (driven[0] + driven[1]) + tolerances::touch_distance(model, states, a, b);
        for touch in contact_set::contacts_of_pair(model, states, a, b, reach) {
            let kinematics = with_rate_at_point(model, states, touch.id, touch.kinematics);
            near.push(near_contact(model, states, &free, touch.id, kinematics, span));
        }
    }
    near.sort_by_key(|contact| contact.id);
    near
}

pub(super) fn near_contact(
    model: &Model,
    states: &[BodyState],
    free: &FreeAccelerations<'_>,
    id: ContactId,
    kinematics: ContactKinematics,
    span: Span,
) -> NearContact {
    let pressing = [id.a, id.b].map(|body| if model.bodies[body].moves() { free.of(body).0.length() } else { 0.0 });
    let driven = prescribed::prescribed_acceleration_of(model, free.t, states, id, &kinematics.geometry).abs();
    let pressing = pressing[0].max(pressing[1]) + driven;
    // The speed of a fall from the height of a bounce that need not be resolved.
    let unseen = (2.0 * pressing * span.unseen_bounce * tolerances::pair_size(model, id.a, id.b)).sqrt();
    NearContact {
        id,
        kinematics,
        acceleration: free.relative(states, id, &kinematics),
        resting_speed: (RESTING_STEPS * span.h * pressing).min(unseen),
        unseen_speed: if unseen.is_finite() { unseen } else { 0.0 },
        is_awaited: false,
        kept_off: 0.0,
    }
}

/// The speeds of slip of contacts at the start of a step, m/s; zero without friction.
pub(super) fn slips_at_start(model: &Model, states: &[BodyState], near: &[NearContact]) -> Vec<f64> {
    let slip = |near: &NearContact| {
        friction::friction_of(model, near.id)?;
        Some(contact_kinematics::tangential_kinematics(model, states, near.id)?.slip_velocity.length())
    };
    near.iter().map(|near| slip(near).unwrap_or(0.0)).collect()
}

//! Where bodies touch or may touch within a step, as faces with points that are fixed to both bodies.
//!
//! The contacts of a pair with nearly one normal form a patch of at most four points. Each point is kept as two
//! anchors, one in the frame of each body: its separation at other poses is `n . (x_A - x_B)`, exact for a corner that
//! slides on a face. As long as two bodies with flat faces have hardly moved relative to each other ([`KEPT_RELATIVE`])
//! their patches are kept, and nothing is searched: in a stack that stands the narrow phase costs a few dozen
//! operations for each pair. Round bodies are searched at every movement, since their point of contact wanders over
//! them.
//!
//! Patches are part of the state of a run: which poses they were found at decides their anchors. Failure: patches of
//! bodies whose faces are strongly curved over the reach are flat.

use crate::collision::contact_kinematics;
use crate::model::{Model, tolerances};
use polhode_contact::{
    Aabb, Contact, ContactFeature, ContactGeometry, Manifold, PairMemory, Shape, Side, Workspace, clipped_manifold,
    near_manifold_with,
};
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, Pose};
use smallvec::SmallVec;

/// Movement of two bodies relative to each other for which their patches are kept, relative to the size of the smaller
/// one (no unit, 1e-5 to 1e-3): a corner is then taken that far from where it is, along its face.
const KEPT_RELATIVE: f64 = 2e-4;

/// Contacts up to this distance are found besides those that the bodies may reach in a step, relative to the size of
/// the smaller body (no unit, 1e-3 to 1e-1): so that patches need not be searched as soon as one body moves a little.
const MARGIN_RELATIVE: f64 = 1e-2;

/// Distance within which points of two searches are one, relative to the size of the smaller body (no unit, 1e-3 to
/// 1e-1).
const SAME_PLACE_RELATIVE: f64 = 2e-2;

/// How much farther than needed patches are searched, so that they last (no unit).
const REACH_TO_SPARE: f64 = 1.5;

/// Contacts of one normal whose surfaces lie at other heights by more than this, relative to the size of the smaller
/// body, are patches of their own (no unit, 1e-3 to 5e-2): friction acts in the plane of a patch.
const ONE_LEVEL_RELATIVE: f64 = 1e-2;

/// Cosine of the angle between the normals of contacts of one patch: some two degrees.
const ONE_NORMAL_COSINE: f64 = 0.9994;

/// Most points of a patch.
pub(crate) const PATCH_POINTS: usize = 4;

/// A point of a patch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PatchPoint {
    pub(crate) feature: ContactFeature,
    /// In the frames of the bodies, m.
    pub(crate) on_a: DVec3,
    pub(crate) on_b: DVec3,
    /// Impulse of the last substep on A along the normal, N s.
    pub(crate) normal_impulse: f64,
    /// Impulse of friction of the last substep on A, world, N s.
    pub(crate) friction_impulse: DVec3,
    /// Mean force of the last step on A: along the normal (N), and of friction, world (N).
    pub(crate) normal_force: f64,
    pub(crate) friction_force: DVec3,
}

impl Default for PatchPoint {
    /// At the origins of both bodies, without impulses.
    fn default() -> Self {
        Self {
            feature: ContactFeature::SphereSphere,
            on_a: DVec3::ZERO,
            on_b: DVec3::ZERO,
            normal_impulse: 0.0,
            friction_impulse: DVec3::ZERO,
            normal_force: 0.0,
            friction_force: DVec3::ZERO,
        }
    }
}

impl PatchPoint {
    /// That of a contact of bodies at these poses, without impulses.
    fn of(contact: &Contact, (pose_a, pose_b): (&Pose, &Pose)) -> Self {
        let geometry = &contact.geometry;
        let half = geometry.normal * (0.5 * geometry.separation);
        Self {
            feature: contact.feature,
            on_a: pose_a.inverse_transform_point(geometry.point + half),
            on_b: pose_b.inverse_transform_point(geometry.point - half),
            ..Self::default()
        }
    }

    /// Takes the impulses and forces of another point.
    fn take(&mut self, known: &Self) {
        (self.normal_impulse, self.friction_impulse) = (known.normal_impulse, known.friction_impulse);
        (self.normal_force, self.friction_force) = (known.normal_force, known.friction_force);
    }
}

/// Points with one normal.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Patch {
    /// From B to A, in the frame of the body that has the faces of the pair ([`PairPatches::normal`]).
    pub(crate) normal: DVec3,
    points: [PatchPoint; PATCH_POINTS],
    count: usize,
}

impl Patch {
    /// One from a snapshot; none with too many points.
    pub(crate) fn restored(normal: DVec3, known: &[PatchPoint]) -> Option<Self> {
        let mut points = [*known.first()?; PATCH_POINTS];
        points.get_mut(..known.len())?.copy_from_slice(known);
        Some(Self { normal, points, count: known.len() })
    }

    /// Becomes that of these contacts of bodies at these poses, with its normal in the frame of one of them.
    fn set(&mut self, contacts: &[&Contact], normal: DVec3, (poses, base): ((&Pose, &Pose), Side)) {
        let of = if base == Side::A { poses.0 } else { poses.1 };
        self.normal = of.rotation.inverse_rotate(normal);
        self.count = contacts.len().min(PATCH_POINTS);
        for (point, contact) in self.points.iter_mut().zip(contacts) {
            *point = PatchPoint::of(contact, poses);
        }
    }

    /// Its points.
    pub(crate) fn points(&self) -> &[PatchPoint] {
        &self.points[..self.count]
    }

    /// Keeps the points at some places, in their order.
    pub(crate) fn retain(&mut self, is_kept: impl Fn(usize) -> bool) {
        let mut count = 0;
        for place in 0..self.count {
            if is_kept(place) {
                self.points.swap(count, place);
                count += 1;
            }
        }
        self.count = count;
    }

    /// Whether a point of it pressed in the last step.
    pub(crate) fn presses(&self) -> bool {
        self.points().iter().any(|point| point.normal_force > 0.0)
    }

    /// Its points, to be changed.
    pub(crate) fn points_mut(&mut self) -> &mut [PatchPoint] {
        &mut self.points[..self.count]
    }
}

/// At which relative pose patches were found, and how far was searched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FoundAt {
    /// That of the smaller body in the frame of the larger one.
    pub(crate) pose: Pose,
    /// m.
    pub(crate) reach: f64,
    /// Lower bound of the distance where there is no patch, m.
    pub(crate) separation: f64,
}

/// The patches of a pair of bodies whose boxes are near each other.
#[derive(Debug, Clone)]
pub(crate) struct PairPatches {
    pub(crate) a: usize,
    pub(crate) b: usize,
    /// Coefficients (no unit).
    pub(crate) friction: f64,
    pub(crate) restitution: f64,
    /// Movement for which patches are kept, m; zero for round bodies.
    kept: f64,
    /// Size of the smaller body, m.
    size: f64,
    /// Whether a body is a compound or a mesh: beyond the reach of a search their distance is not known, but that it is
    /// larger.
    has_parts: bool,
    smaller: Side,
    /// The body in whose frame normals are kept: the one that impulses do not move, else the larger one. A load that
    /// rocks on a floor has the normal of the
    /// floor.
    base: Side,
    found_at: Option<FoundAt>,
    /// Of polyhedra that are searched.
    memory: Option<Box<PairMemory>>,
    pub(crate) patches: Vec<Patch>,
    /// Whether the bodies pressed on each other in the last step.
    pub(crate) presses: bool,
}

impl PairPatches {
    /// Nothing known yet of a pair.
    pub(crate) fn new(model: &Model, (a, b): (usize, usize)) -> Self {
        let material = model.scene.pair_material(a, b);
        let is_flat = |body: usize| {
            model.bodies[body]
                .shape
                .as_ref()
                .is_some_and(|shape| matches!(shape, Shape::Convex(_) | Shape::HalfSpace(_)))
        };
        let size = tolerances::pair_size(model, a, b);
        let smaller = if size == model.bodies[a].size { Side::A } else { Side::B };
        let base = match [a, b].map(|body| model.bodies[body].moves()) {
            [false, true] => Side::A,
            [true, false] => Side::B,
            _ => smaller.other(),
        };
        let is_composite = |body: usize| {
            let shape = model.bodies[body].shape.as_ref();
            shape.is_some_and(|shape| matches!(shape, Shape::Compound(_) | Shape::TriangleMesh(_)))
        };
        Self {
            a,
            b,
            friction: if model.has_friction() { material.friction() } else { 0.0 },
            restitution: material.restitution(),
            kept: if is_flat(a) && is_flat(b) { KEPT_RELATIVE * size } else { 0.0 },
            size,
            smaller,
            base,
            has_parts: is_composite(a) || is_composite(b),
            found_at: None,
            memory: None,
            patches: Vec::new(),
            presses: false,
        }
    }

    /// Where its patches were found.
    pub(crate) fn found_at(&self) -> Option<FoundAt> {
        self.found_at
    }

    /// The pair with the patches of a snapshot.
    pub(crate) fn with_patches(mut self, found_at: Option<FoundAt>, patches: Vec<Patch>) -> Self {
        (self.found_at, self.patches) = (found_at, patches);
        self.presses = self.patches.iter().any(Patch::presses);
        self
    }

    /// The normal of a patch in these states, from B to A.
    pub(crate) fn normal(&self, states: &[BodyState], patch: &Patch) -> DVec3 {
        let base = if self.base == Side::A { self.a } else { self.b };
        states[base].pose.rotation.rotate(patch.normal)
    }

    /// Where a point of a patch is in these states.
    pub(crate) fn geometry(&self, states: &[BodyState], patch: &Patch, point: &PatchPoint) -> ContactGeometry {
        let normal = self.normal(states, patch);
        let [a, b] =
            [(self.a, point.on_a), (self.b, point.on_b)].map(|(body, at)| states[body].pose.transform_point(at));
        ContactGeometry { point: (a + b) * 0.5, normal, separation: normal.dot(a - b), margin: f64::INFINITY }
    }

    /// Where impulses act on the way from the point on A to that on B (no unit): on the surface of the one body that
    /// forces move, where it will meet the other, else in the middle, as where bodies overlap. A lever of half a gap
    /// more would give a ball that is still apart too much spin.
    pub(crate) fn acting_part(&self, model: &Model, separation: f64) -> f64 {
        match [self.a, self.b].map(|body| model.bodies[body].moves()) {
            [true, false] if separation > 0.0 => 0.0,
            [false, true] if separation > 0.0 => 1.0,
            _ => 0.5,
        }
    }

    /// Brings the patches to these states, for bodies that may approach each other by `travel` (m) in the coming step.
    pub(crate) fn renew(&mut self, model: &Model, states: &[BodyState], travel: f64, tools: &mut Tools) {
        let (pose_a, pose_b) = (&states[self.a].pose, &states[self.b].pose);
        let now = match self.smaller {
            Side::A => pose_b.relative(pose_a),
            Side::B => pose_a.relative(pose_b),
        };
        let reach = MARGIN_RELATIVE * self.size + travel;
        if self.are_kept(&now, reach) {
            return;
        }
        let Some((shape_a, shape_b)) = contact_kinematics::shapes(model, self.a, self.b) else {
            self.presses = false;
            return self.patches.clear();
        };
        let far = REACH_TO_SPARE * reach;
        let (a, b) = ((shape_a, pose_a), (shape_b, pose_b));
        if !clipped_manifold(a, b, (far, self.base), &mut tools.found) {
            let memory = match (shape_a, shape_b) {
                (Shape::Convex(_), Shape::Convex(_)) => self.memory.get_or_insert_default(),
                _ => &mut tools.no_memory,
            };
            near_manifold_with(&mut tools.workspace, memory, a, b, far, &mut tools.found);
        }
        let found = tools.found.separation;
        let separation = if self.has_parts && found > far { far } else { found };
        self.found_at = Some(FoundAt { pose: now, reach: far, separation });
        tools.before.clear();
        for patch in &self.patches {
            tools.before.extend_from_slice(patch.points());
        }
        let poses = ((pose_a, pose_b), self.base);
        make_patches(&mut self.patches, &tools.found.contacts, poses, ONE_LEVEL_RELATIVE * self.size);
        if !tools.before.is_empty() {
            self.take_impulses(&tools.before);
        }
        self.presses = self.patches.iter().any(Patch::presses);
    }

    /// Whether the patches still hold at a relative pose.
    fn are_kept(&self, now: &Pose, reach: f64) -> bool {
        let Some(found) = &self.found_at else { return false };
        let [before, after] = [&found.pose, now].map(|pose| pose.rotation.quaternion());
        let turn = (before.x * after.w - before.w * after.x - before.y * after.z + before.z * after.y).abs()
            + (before.y * after.w - before.w * after.y - before.z * after.x + before.x * after.z).abs()
            + (before.z * after.w - before.w * after.z - before.x * after.y + before.y * after.x).abs();
        let movement = (now.translation - found.pose.translation).length() + 2.0 * turn * self.size;
        if self.patches.is_empty() {
            // Bodies that are apart stay so until they have come nearer; a movement that is not finite keeps nothing.
            return found.separation - movement > reach;
        }
        movement <= self.kept && reach <= found.reach
    }

    /// The impulses of points that were there before: by their features, and those of other features at the same place
    /// (where edges of two faces nearly coincide, rounding says which of them makes the corner).
    fn take_impulses(&mut self, before: &[PatchPoint]) {
        let near = SAME_PLACE_RELATIVE * self.size;
        let mut left: FewContacts<&PatchPoint> = before.iter().collect();
        let mut new: FewContacts<&mut PatchPoint> = FewContacts::new();
        for point in self.patches.iter_mut().flat_map(Patch::points_mut) {
            match left.iter().position(|known| known.feature == point.feature) {
                Some(place) => point.take(left.swap_remove(place)),
                None => new.push(point),
            }
        }
        for point in new {
            let is_near = |known: &&PatchPoint| {
                (known.on_a - point.on_a).length().min((known.on_b - point.on_b).length()) <= near
            };
            if let Some(place) = left.iter().position(is_near) {
                point.take(left.swap_remove(place));
            }
        }
    }
}

/// Buffers of a search.
#[derive(Debug, Default)]
pub(crate) struct Tools {
    workspace: Workspace,
    found: Manifold,
    /// Shapes other than polyhedra remember nothing.
    no_memory: Box<PairMemory>,
    /// The points that a pair had before.
    before: Vec<PatchPoint>,
}

/// A list that is rarely longer than two patches.
type FewContacts<T> = SmallVec<[T; 2 * PATCH_POINTS]>;

/// Brings patches to these contacts, in the order of their first ones. Those of a patch have one normal, and lie in one
/// plane of body A or of body B, to `level` (m).
fn make_patches(patches: &mut Vec<Patch>, contacts: &[Contact], poses: ((&Pose, &Pose), Side), level: f64) {
    let is_along = |first: &Contact, contact: &Contact| {
        let (normal, apart) = (first.geometry.normal, first.geometry.separation);
        let higher = normal.dot(contact.geometry.point - first.geometry.point);
        // Half of the separation lies on either side of the point.
        let farther = 0.5 * (contact.geometry.separation - apart);
        contact.geometry.normal.dot(normal) >= ONE_NORMAL_COSINE
            && (higher + farther).abs().min((higher - farther).abs()) <= level
    };
    let mut made = 0;
    // Patches that are there already are written over: most pairs have as many as before.
    let mut put = |group: &[&Contact], normal: DVec3| {
        if made == patches.len() {
            patches.push(Patch::default());
        }
        patches[made].set(group, normal, poses);
        made += 1;
    };
    if let [only] = contacts {
        if is_along(only, only) {
            put(&[only], only.geometry.normal);
        }
        return patches.truncate(made);
    }
    let mut left: FewContacts<&Contact> = contacts.iter().collect();
    while let Some(&first) = left.first() {
        let mut group: FewContacts<&Contact> =
            left.iter().copied().filter(|contact| is_along(first, contact)).collect();
        if group.is_empty() {
            break;
        }
        left.retain(|contact| !is_along(first, contact));
        reduce(&mut group, first.geometry.normal);
        put(&group, first.geometry.normal);
    }
    patches.truncate(made);
}

/// Leaves four contacts of a group: of those in front, the deepest, the farthest from it, and the two farthest from
/// their line on both sides.
fn reduce(group: &mut FewContacts<&Contact>, normal: DVec3) {
    if group.len() <= PATCH_POINTS {
        return;
    }
    keep_those_in_front(group, normal);
    let place = |contact: &&Contact| contact.geometry.point;
    let deepest =
        (0..group.len()).min_by(|&i, &j| group[i].geometry.separation.total_cmp(&group[j].geometry.separation));
    let first = deepest.unwrap_or(0);
    let origin = place(&group[first]);
    let most = |value: &dyn Fn(&&Contact) -> f64| {
        (0..group.len()).max_by(|&i, &j| value(&group[i]).total_cmp(&value(&group[j])))
    };
    let second = most(&|contact| (place(contact) - origin).length_squared()).unwrap_or(0);
    let line = normal.cross(place(&group[second]) - origin);
    let third = most(&|contact| line.dot(place(contact) - origin)).unwrap_or(0);
    let fourth = most(&|contact| -line.dot(place(contact) - origin)).unwrap_or(0);
    let mut chosen = [first, second, third, fourth].to_vec();
    chosen.sort_unstable();
    chosen.dedup();
    *group = chosen.into_iter().map(|number| group[number]).collect();
}

/// Drops contacts behind others: those that lie higher above another one than aside of it, such as the upper corners of
/// a flat body whose speed along the floor makes the search reach that far. They bear nothing unless the body turns by
/// more than 45 degrees, and would take the places of the corners below them.
fn keep_those_in_front(group: &mut FewContacts<&Contact>, normal: DVec3) {
    let is_behind = |contact: &&Contact, other: &&Contact| {
        let between = contact.geometry.point - other.geometry.point;
        let aside = between - normal * normal.dot(between);
        contact.geometry.separation - other.geometry.separation > aside.length()
    };
    let all = group.clone();
    group.retain(|contact| !all.iter().any(|other| is_behind(contact, other)));
}

/// The boxes of bodies, large enough to last for some steps, and the pairs whose boxes meet.
#[derive(Debug)]
pub(crate) struct LastingBoxes {
    fat: Vec<Option<Aabb>>,
    broad_phase: Box<dyn polhode_contact::BroadPhase>,
    packed: Vec<Aabb>,
    bodies: Vec<usize>,
    found: Vec<(u32, u32)>,
    /// Pairs that may collide, ascending.
    pub(crate) pairs: Vec<(usize, usize)>,
}

/// How much larger than needed a box is, relative to the size of its body (no unit): the smaller, the fewer pairs; the
/// larger, the longer it lasts.
const ROOM_RELATIVE: f64 = 0.05;

impl LastingBoxes {
    /// No boxes yet.
    pub(crate) fn new(method: polhode_contact::BroadPhaseMethod) -> Self {
        Self {
            fat: Vec::new(),
            broad_phase: method.build(),
            packed: Vec::new(),
            bodies: Vec::new(),
            found: Vec::new(),
            pairs: Vec::new(),
        }
    }

    /// Finds the pairs of bodies that may touch in a step in which body `k` moves by at most `travel(k)` (m). Returns
    /// whether they may be others than before.
    ///
    /// # Errors
    /// When there are more bodies than the broad phase can number.
    pub(crate) fn renew(
        &mut self,
        model: &Model,
        states: &[BodyState],
        travel: impl Fn(usize) -> f64,
    ) -> Result<bool, polhode_contact::BroadPhaseError> {
        let mut is_new = self.fat.len() != states.len();
        self.fat.resize(states.len(), None);
        for (body, state) in states.iter().enumerate() {
            let Some(shape) = &model.bodies[body].shape else {
                is_new |= self.fat[body].take().is_some();
                continue;
            };
            let size = model.bodies[body].size;
            let margin = MARGIN_RELATIVE * size + travel(body);
            let around =
                |margin: f64| polhode_contact::aabb_of(shape, &state.pose).and_then(|aabb| aabb.inflated(margin));
            let needed = around(margin).unwrap_or(Aabb::UNBOUNDED);
            if self.fat[body].as_ref().is_some_and(|fat| fat.encloses(&needed)) {
                continue;
            }
            self.fat[body] = Some(needed.inflated(ROOM_RELATIVE * size + travel(body)).unwrap_or(Aabb::UNBOUNDED));
            is_new = true;
        }
        if !is_new {
            return Ok(false);
        }
        self.packed.clear();
        self.bodies.clear();
        for (body, fat) in self.fat.iter().enumerate() {
            if let Some(fat) = fat {
                self.packed.push(*fat);
                self.bodies.push(body);
            }
        }
        self.broad_phase.pairs(&self.packed, &mut self.found)?;
        let bodies = &self.bodies;
        let pairs = self.found.iter().map(|&(i, j)| (bodies[i as usize], bodies[j as usize]));
        self.pairs.clear();
        self.pairs.extend(pairs.filter(|&(a, b)| model.scene.may_collide(a, b)));
        Ok(true)
    }

    /// Whether one of these bodies is no more within its box: pairs may be missing.
    pub(crate) fn has_left(&self, model: &Model, states: &[BodyState], of: impl Fn(usize) -> bool) -> bool {
        let has_left = |(body, fat): (usize, &Option<Aabb>)| {
            let (Some(fat), Some(shape)) = (fat, &model.bodies[body].shape) else { return false };
            if !of(body) {
                return false;
            }
            polhode_contact::aabb_of(shape, &states[body].pose).is_ok_and(|now| !fat.encloses(&now))
        };
        self.fat.iter().enumerate().any(has_left)
    }

    /// Drops the box of a body.
    pub(crate) fn forget(&mut self, body: usize) {
        if let Some(fat) = self.fat.get_mut(body) {
            *fat = None;
        }
    }
}

/// Brings the records of pairs to a new list of pairs, ascending; those that are no longer near are dropped. `spare`
/// keeps the memory of the list before.
pub(crate) fn follow_pairs(
    model: &Model,
    (records, spare): (&mut Vec<PairPatches>, &mut Vec<PairPatches>),
    pairs: &[(usize, usize)],
) {
    std::mem::swap(records, spare);
    let mut old = spare.drain(..);
    records.reserve(pairs.len());
    for &pair in pairs {
        let mut known = old.as_slice().first().map(|record| (record.a, record.b));
        while known.is_some_and(|known| known < pair) {
            old.next();
            known = old.as_slice().first().map(|record| (record.a, record.b));
        }
        let kept = if known == Some(pair) { old.next() } else { None };
        records.push(kept.unwrap_or_else(|| PairPatches::new(model, pair)));
    }
}

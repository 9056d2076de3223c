//! The narrow phase of many bodies, kept from step to step.
//!
//! [`NarrowPhase::update`] gives the contacts of all pairs of a broad phase at the poses of now, the same bit for bit as
//! [`manifold()`](crate::manifold()) would. From the step before it keeps, for each pair, which features need not be
//! searched (`coherence.rs`), the identities of the contacts with a value of the caller's for each (the impulse for a warm
//! start), and all buffers: once these are large enough, a step allocates nothing. Pairs that end leave their buffers to
//! pairs that begin.

use crate::narrow_phase::dispatch::coherence::Coherence;
use crate::narrow_phase::dispatch::manifold::{manifold_into, near_manifold_into};
use crate::narrow_phase::dispatch::workspace::Workspace;
use crate::narrow_phase::pair::measure::Placed;
use crate::narrow_phase::pair::polyhedra::along_axes;
use crate::{Contact, ContactFeature, Manifold, SeparatingAxis, Shape};
use polhode_spatial::Pose;
use thiserror::Error;

/// Why pairs cannot be updated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum NarrowPhaseError {
    /// The pairs are not in ascending order.
    #[error("pair {index} is ({}, {}), after ({}, {}): pairs must be sorted, each once", pair.0, pair.1, before.0, before.1)]
    NotSorted {
        /// Place of the pair in the list.
        index: usize,
        /// The pair.
        pair: (u32, u32),
        /// The one before it.
        before: (u32, u32),
    },
}

/// What is kept of a pair.
#[derive(Debug, Clone)]
struct Record<T> {
    manifold: Manifold,
    /// Values of the caller's, one for each contact.
    data: Vec<T>,
    /// Features of the contacts of the step before, and their values.
    previous: Vec<ContactFeature>,
    previous_data: Vec<T>,
    coherence: Coherence,
}

/// Narrow phase with memory. `T` is what the caller keeps with each contact; a new contact has `T::default()`.
///
/// ```
/// use polhode_contact::{DVec3, NarrowPhase, Pose, Shape, UnitVector};
/// let shapes = [Shape::half_space(UnitVector::Z), Shape::cuboid(DVec3::ONE)?];
/// let mut poses = [Pose::IDENTITY, Pose::from_translation(DVec3::Z * 0.5)];
/// let mut narrow_phase = NarrowPhase::<f64>::default();
/// narrow_phase.update(&[(0, 1)], 1e-3, |body| (&shapes[body as usize], &poses[body as usize]))?;
/// narrow_phase.data_mut(0, 1)[2] = 7.0;
/// poses[1].translation.x += 0.25;
/// narrow_phase.update(&[(0, 1)], 1e-3, |body| (&shapes[body as usize], &poses[body as usize]))?;
/// let pair = narrow_phase.pairs().next().ok_or("no pair")?;
/// assert_eq!((pair.manifold.contacts.len(), pair.data), (4, &[0.0, 0.0, 7.0, 0.0][..]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct NarrowPhase<T = ()> {
    records: Vec<Record<T>>,
    /// Pairs of the last update, sorted, each with the place of its record.
    active: Vec<((u32, u32), usize)>,
    /// Pairs of the update before that are no longer given, sorted.
    ended: Vec<((u32, u32), usize)>,
    /// Records that no pair uses.
    free: Vec<usize>,
    /// Buffer for the next list of pairs.
    merged: Vec<((u32, u32), usize)>,
    workspace: Workspace,
}

impl<T> Default for NarrowPhase<T> {
    fn default() -> Self {
        Self {
            records: Vec::new(),
            active: Vec::new(),
            ended: Vec::new(),
            free: Vec::new(),
            merged: Vec::new(),
            workspace: Workspace::default(),
        }
    }
}

/// A pair of bodies and its contacts.
#[derive(Debug, Clone, Copy)]
pub struct PairContacts<'a, T> {
    /// The bodies A and B, by index.
    pub bodies: (u32, u32),
    /// The contacts. Beyond the reach the separation is a lower bound that exceeds the reach, and the axis may be
    /// [`SeparatingAxis::None`]; within it everything is as [`manifold()`](crate::manifold()) gives it.
    pub manifold: &'a Manifold,
    /// The caller's values, one for each contact.
    pub data: &'a [T],
    previous: &'a [ContactFeature],
}

/// What became of a contact in the last update.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactChange {
    /// It is new.
    Begun(ContactFeature),
    /// It was there before.
    Persisted(ContactFeature),
    /// It is no longer there.
    Ended(ContactFeature),
}

impl<'a, T> PairContacts<'a, T> {
    /// What became of each contact of now and of the step before, sorted by feature.
    pub fn changes(&self) -> impl Iterator<Item = ContactChange> + use<'a, T> {
        let mut now = self.manifold.contacts.iter().map(|contact| contact.feature).peekable();
        let mut before = self.previous.iter().copied().peekable();
        std::iter::from_fn(move || match (now.peek().copied(), before.peek().copied()) {
            (Some(new), Some(old)) if new == old => {
                before.next();
                now.next().map(ContactChange::Persisted)
            }
            (Some(new), Some(old)) if old < new => before.next().map(ContactChange::Ended),
            (None, _) => before.next().map(ContactChange::Ended),
            (Some(_), _) => now.next().map(ContactChange::Begun),
        })
    }
}

impl<T: Copy + Default> NarrowPhase<T> {
    /// Finds all contacts with a separation of at most `reach` (m) of these pairs, which are sorted and each there once.
    /// `placed` gives a body's shape and its pose `X_WC`. When another shape takes a body's index, say so beforehand
    /// ([`Self::forget`]).
    ///
    /// # Errors
    /// When the pairs are not sorted; nothing has changed then.
    pub fn update<'s>(
        &mut self,
        pairs: &[(u32, u32)],
        reach: f64,
        placed: impl Fn(u32) -> (&'s Shape, &'s Pose),
    ) -> Result<(), NarrowPhaseError> {
        if let Some(at) = pairs.windows(2).position(|two| two[0] >= two[1]) {
            return Err(NarrowPhaseError::NotSorted { index: at + 1, pair: pairs[at + 1], before: pairs[at] });
        }
        self.match_records(pairs);
        for &((a, b), at) in &self.active {
            let ((shape_a, pose_a), (shape_b, pose_b)) = (placed(a), placed(b));
            let (a, b) = (Placed { shape: shape_a, pose: pose_a }, Placed { shape: shape_b, pose: pose_b });
            let record = &mut self.records[at];
            record.turn_over();
            find(&mut self.workspace, &mut record.coherence, a, b, reach, &mut record.manifold);
            record.carry_data();
        }
        Ok(())
    }

    /// Gives every pair its record, in one walk over the sorted lists of before and of now.
    fn match_records(&mut self, pairs: &[(u32, u32)]) {
        self.free.extend(self.ended.drain(..).map(|(_, at)| at));
        self.merged.clear();
        let mut old = self.active.iter().copied().peekable();
        for &pair in pairs {
            while let Some(gone) = old.next_if(|(key, _)| *key < pair) {
                self.ended.push(gone);
            }
            let known = old.next_if(|(key, _)| *key == pair).map(|(_, at)| at);
            let at = known.unwrap_or_else(|| fresh(&mut self.records, &mut self.free));
            self.merged.push((pair, at));
        }
        self.ended.extend(old);
        std::mem::swap(&mut self.active, &mut self.merged);
        for &(_, at) in &self.ended {
            self.records[at].turn_over();
            self.records[at].manifold.set_empty(f64::NAN, SeparatingAxis::None);
            self.records[at].data.clear();
        }
    }

    /// Another shape has taken this index: contacts that the body had are forgotten, without being told as ended.
    pub fn forget(&mut self, body: u32) {
        for &((a, b), at) in &self.active {
            if a == body || b == body {
                self.records[at].clear();
            }
        }
    }

    /// Forgets everything but the buffers.
    pub fn clear(&mut self) {
        self.free.extend(self.ended.drain(..).chain(self.active.drain(..)).map(|(_, at)| at));
    }
}

impl<T> NarrowPhase<T> {
    /// The pairs of the last update, sorted.
    pub fn pairs(&self) -> impl Iterator<Item = PairContacts<'_, T>> {
        self.active.iter().map(|&(bodies, at)| self.records[at].view(bodies))
    }

    /// The pairs of the update before that the last one did not get, sorted: their contacts have ended.
    pub fn ended_pairs(&self) -> impl Iterator<Item = PairContacts<'_, T>> {
        self.ended.iter().map(|&(bodies, at)| self.records[at].view(bodies))
    }

    /// One pair of the last update.
    pub fn pair(&self, a: u32, b: u32) -> Option<PairContacts<'_, T>> {
        self.place(a, b).map(|at| self.records[at].view((a, b)))
    }

    /// The caller's values of a pair, one for each contact; none when there is no such pair.
    pub fn data_mut(&mut self, a: u32, b: u32) -> &mut [T] {
        match self.place(a, b) {
            Some(at) => &mut self.records[at].data,
            None => &mut [],
        }
    }

    /// All pairs with the caller's values to be changed, sorted.
    pub fn for_each_mut(&mut self, mut visit: impl FnMut((u32, u32), &Manifold, &mut [T])) {
        for &(bodies, at) in &self.active {
            let record = &mut self.records[at];
            visit(bodies, &record.manifold, &mut record.data);
        }
    }

    fn place(&self, a: u32, b: u32) -> Option<usize> {
        let found = self.active.binary_search_by_key(&(a, b), |&(bodies, _)| bodies);
        found.ok().map(|k| self.active[k].1)
    }
}

/// Place of a record without memory of another pair.
fn fresh<T>(records: &mut Vec<Record<T>>, free: &mut Vec<usize>) -> usize {
    if let Some(at) = free.pop() {
        records[at].clear();
        return at;
    }
    records.push(Record {
        manifold: Manifold::default(),
        data: Vec::new(),
        previous: Vec::new(),
        previous_data: Vec::new(),
        coherence: Coherence::default(),
    });
    records.len() - 1
}

impl<T> Record<T> {
    fn clear(&mut self) {
        self.manifold.set_empty(f64::NAN, SeparatingAxis::None);
        self.data.clear();
        self.previous.clear();
        self.previous_data.clear();
        self.coherence.forget();
    }

    /// What was of now is of the step before.
    fn turn_over(&mut self) {
        self.previous.clear();
        self.previous.extend(self.manifold.contacts.iter().map(|contact| contact.feature));
        std::mem::swap(&mut self.data, &mut self.previous_data);
    }

    fn view(&self, bodies: (u32, u32)) -> PairContacts<'_, T> {
        PairContacts { bodies, manifold: &self.manifold, data: &self.data, previous: &self.previous }
    }
}

impl<T: Copy + Default> Record<T> {
    /// Every contact takes the value it had before; both lists are sorted by feature.
    fn carry_data(&mut self) {
        let contacts = &self.manifold.contacts;
        let same = |(feature, contact): (&ContactFeature, &Contact)| *feature == contact.feature;
        if self.previous.len() == contacts.len() && self.previous.iter().zip(contacts).all(same) {
            std::mem::swap(&mut self.data, &mut self.previous_data);
            return;
        }
        self.data.clear();
        let mut before = self.previous.iter().zip(&self.previous_data).peekable();
        for contact in &self.manifold.contacts {
            while before.next_if(|(feature, _)| **feature < contact.feature).is_some() {}
            let same = before.next_if(|(feature, _)| **feature == contact.feature);
            self.data.push(same.map_or_else(T::default, |(_, value)| *value));
        }
    }
}

/// What is remembered of one pair from one query to the next, for callers that keep their own pairs. It must be forgotten
/// ([`Default`]) when another shape stands for one of the two.
#[derive(Debug, Clone, Default)]
pub struct PairMemory {
    coherence: Coherence,
}

/// As [`near_manifold`](crate::near_manifold), the same bit for bit within the reach, with buffers that the caller keeps and
/// with what is remembered of the pair; beyond the reach the separation of polyhedra is a lower bound that exceeds it.
pub fn near_manifold_with(
    workspace: &mut Workspace,
    memory: &mut PairMemory,
    (shape_a, pose_a): (&Shape, &Pose),
    (shape_b, pose_b): (&Shape, &Pose),
    reach: f64,
    found: &mut Manifold,
) {
    if let (Shape::Convex(_), Shape::Convex(_)) = (shape_a, shape_b) {
        let (a, b) = (Placed { shape: shape_a, pose: pose_a }, Placed { shape: shape_b, pose: pose_b });
        return find(workspace, &mut memory.coherence, a, b, reach, found);
    }
    near_manifold_into(workspace, shape_a, pose_a, shape_b, pose_b, reach, found);
}

/// The contacts of a pair, with the help of what is known of it.
fn find(
    workspace: &mut Workspace,
    coherence: &mut Coherence,
    a: Placed<'_>,
    b: Placed<'_>,
    reach: f64,
    found: &mut Manifold,
) {
    let (Shape::Convex(polyhedron_a), Shape::Convex(polyhedron_b)) = (a.shape, b.shape) else {
        return manifold_into(workspace, a.shape, a.pose, b.shape, b.pose, reach, found);
    };
    if !(a.pose.is_finite() && b.pose.is_finite()) {
        coherence.forget();
        return found.set_empty(f64::NAN, SeparatingAxis::None);
    }
    let x_ab = a.pose.relative(b.pose);
    if let Some(separation) = coherence.apart(polyhedron_a, polyhedron_b, &x_ab, reach) {
        return found.set_empty(separation, SeparatingAxis::None);
    }
    let buffers = workspace.pair();
    let axes = coherence.search(&mut buffers.search, polyhedron_a, polyhedron_b, &x_ab, reach);
    along_axes(buffers, (polyhedron_a, a), (polyhedron_b, b), (&axes, Some(&mut coherence.region)), reach, found);
}

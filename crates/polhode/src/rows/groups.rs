//! Groups: bodies connected by contacts and joints, or by forces between them.
//!
//! Immovable bodies transmit no motion between contacts, so they do not connect bodies. Groups and their members are
//! ordered by the indices of bodies, so that results do not depend on the order of detection.

use crate::model::Model;
use polhode_spatial::DisjointSets;

/// Bodies connected by contacts, and those contacts.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Group {
    /// Movable bodies, ascending.
    pub(crate) bodies: Vec<usize>,
    /// Indices of the contacts, ascending.
    pub(crate) contacts: Vec<usize>,
}

/// The groups that `contacts` (index of the contact, body A, body B) form, with all bodies that joints connect to
/// theirs.
pub(crate) fn groups(model: &Model, contacts: impl Iterator<Item = (usize, usize, usize)>) -> Vec<Group> {
    joined(model, contacts, &[])
}

/// The groups that `contacts` and the force fields that couple bodies form among `bodies`, each of which is in one.
pub(crate) fn coupled_groups(
    model: &Model,
    contacts: impl Iterator<Item = (usize, usize, usize)>,
    bodies: &[usize],
) -> Vec<Group> {
    joined(model, contacts, bodies)
}

/// Groups by contacts, of `bodies` also by couplings. The work depends on the bodies in question alone.
fn joined(model: &Model, contacts: impl Iterator<Item = (usize, usize, usize)>, bodies: &[usize]) -> Vec<Group> {
    let contacts: Vec<_> = contacts.collect();
    let moves = |body: &usize| model.bodies[*body].moves();
    let mut members: Vec<usize> = contacts.iter().flat_map(|&(_, a, b)| [a, b]).filter(moves).collect();
    members.extend_from_slice(bodies);
    members.sort_unstable();
    members.dedup();
    let members = model.joints.with_jointed(members);
    let mut belongs = bodies.to_vec();
    belongs.sort_unstable();
    let place = |body: usize| members.binary_search(&body).ok();
    let mut sets = DisjointSets::new(members.len());
    let mut join = |a: usize, b: usize| {
        if let (Some(a), Some(b)) = (place(a), place(b)) {
            sets.join(a, b);
        }
    };
    for together in model.couplings_among(&belongs) {
        let mut coupled = together.iter().copied().filter(|body| belongs.binary_search(body).is_ok());
        let Some(first) = coupled.next() else { continue };
        coupled.for_each(|body| join(first, body));
    }
    for joint in model.joints.joints_among(&members) {
        if let [a, b] = joint.bodies().collect::<Vec<_>>()[..] {
            join(a, b);
        }
    }
    for tie in model.joints.ties_among(&members) {
        let together = tie.bodies();
        together.iter().skip(1).for_each(|&body| join(together[0], body));
    }
    for &(_, a, b) in &contacts {
        join(a, b);
    }
    let mut slot: Vec<Option<usize>> = vec![None; members.len()];
    let mut groups: Vec<Group> = Vec::new();
    for (index, &body) in members.iter().enumerate() {
        let group = *slot[sets.smallest(index)].get_or_insert_with(|| {
            groups.push(Group::default());
            groups.len() - 1
        });
        groups[group].bodies.push(body);
    }
    for (contact, a, b) in contacts {
        let member = if model.bodies[a].moves() { a } else { b };
        let group = place(member).and_then(|index| slot[sets.smallest(index)]);
        if let Some(group) = group {
            groups[group].contacts.push(contact);
        }
    }
    groups
}

//! Groups: bodies connected by contacts, or by forces between them.
//!
//! Immovable bodies carry no motion from one contact to another and so connect nothing. Groups and their members are
//! ordered by body number, so that results do not depend on how they were found.

use crate::world::World;

/// Bodies connected by contacts, and those contacts.
#[derive(Debug, Clone, Default)]
pub(crate) struct Group {
    /// Movable bodies, ascending.
    pub(crate) bodies: Vec<usize>,
    /// Indices of the contacts, ascending.
    pub(crate) contacts: Vec<usize>,
}

/// The groups that `contacts` (index of the contact, body A, body B) form.
pub(crate) fn groups(world: &World, contacts: impl Iterator<Item = (usize, usize, usize)>) -> Vec<Group> {
    joined(world, contacts, &[], &[])
}

/// The groups that `contacts` and the force fields that couple bodies form among `bodies`, each of which is in one.
pub(crate) fn coupled_groups(
    world: &World,
    contacts: impl Iterator<Item = (usize, usize, usize)>,
    bodies: &[usize],
) -> Vec<Group> {
    joined(world, contacts, bodies, &world.couplings)
}

/// Groups by contacts, of `bodies` also by couplings.
fn joined(
    world: &World,
    contacts: impl Iterator<Item = (usize, usize, usize)>,
    bodies: &[usize],
    couplings: &[Vec<usize>],
) -> Vec<Group> {
    let contacts: Vec<_> = contacts.collect();
    let mut parent: Vec<usize> = (0..world.bodies.len()).collect();
    for together in couplings {
        let mut members = together.iter().copied().filter(|body| bodies.contains(body));
        let Some(first) = members.next() else { continue };
        for body in members {
            let (root_a, root_b) = (root(&mut parent, first), root(&mut parent, body));
            parent[root_a.max(root_b)] = root_a.min(root_b);
        }
    }
    for &(_, a, b) in &contacts {
        if world.bodies[a].moves() && world.bodies[b].moves() {
            let (root_a, root_b) = (root(&mut parent, a), root(&mut parent, b));
            // The smaller number is the root, which makes the order of groups that of their first bodies.
            parent[root_a.max(root_b)] = root_a.min(root_b);
        }
    }
    let mut slot: Vec<Option<usize>> = vec![None; world.bodies.len()];
    let mut touched = vec![false; world.bodies.len()];
    for &body in bodies {
        touched[body] = true;
    }
    for &(_, a, b) in &contacts {
        touched[a] |= world.bodies[a].moves();
        touched[b] |= world.bodies[b].moves();
    }
    let mut groups: Vec<Group> = Vec::new();
    for body in (0..world.bodies.len()).filter(|&body| touched[body]) {
        let root = root(&mut parent, body);
        let index = *slot[root].get_or_insert_with(|| {
            groups.push(Group::default());
            groups.len() - 1
        });
        groups[index].bodies.push(body);
    }
    for (contact, a, b) in contacts {
        let member = if world.bodies[a].moves() { a } else { b };
        if let Some(index) = slot[root(&mut parent, member)] {
            groups[index].contacts.push(contact);
        }
    }
    groups
}

/// Representative of a body's group, with path halving.
fn root(parent: &mut [usize], mut body: usize) -> usize {
    while parent[body] != body {
        parent[body] = parent[parent[body]];
        body = parent[body];
    }
    body
}

//! The order in which unknowns are eliminated so that few new couplings arise: minimum degree.
//!
//! Contacts with the same neighbours (all those between the same two bodies) are one node from the start. Of the
//! remaining nodes the one with the fewest unknowns beside it comes next, the first of equal ones; its neighbours
//! become neighbours of each other. In chains and piles cost grows about linearly with the contacts. Source: George and
//! Liu 1989.
//!
//! Then children are put right before their parents in the elimination tree, which changes no fill, and nodes that
//! follow each other with nearly the same couplings are joined into fronts: their rows are eliminated in one dense
//! matrix. Source: Liu 1990 (elimination tree), Ashcraft and Grimes 1989 (supernodes).

use crate::friction::block_matrix::BlockMatrix;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// How much larger a front may be than that of its first node alone (no unit, 1.1 to 1.5): zeros that are carried along
/// against entries that are copied from front to front.
const MOST_GROWTH: f64 = 1.25;

/// Nodes in the order of their elimination.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct EliminationOrder {
    /// The blocks of each node, ascending.
    pub(crate) nodes: Vec<Vec<usize>>,
    /// The node of each block.
    pub(crate) node_of: Vec<usize>,
    /// The nodes of each front, which follow each other; fronts in the order of their elimination.
    pub(crate) fronts: Vec<Range<usize>>,
    /// Nodes of later fronts that each front is coupled with when its turn comes, ascending.
    pub(crate) later: Vec<Vec<usize>>,
}

impl EliminationOrder {
    /// The order for the blocks of a matrix.
    pub(crate) fn of(matrix: &BlockMatrix) -> Self {
        let groups = groups(matrix);
        let mut group_of = vec![0; matrix.len()];
        for (group, blocks) in groups.iter().enumerate() {
            for &block in blocks {
                group_of[block] = group;
            }
        }
        let weights: Vec<usize> =
            groups.iter().map(|blocks| blocks.iter().map(|&block| matrix.size(block)).sum()).collect();
        let beside = |group: usize| {
            let neighbours = groups[group].first().map_or(&[][..], |&block| matrix.neighbours(block));
            let mut beside: Vec<usize> = neighbours.iter().map(|&block| group_of[block]).collect();
            beside.sort_unstable();
            beside.dedup();
            beside.retain(|&other| other != group);
            beside
        };
        let (sequence, cliques) = minimum_degree((0..groups.len()).map(beside).collect(), &weights);
        let mut turn = vec![0; groups.len()];
        for (node, &group) in sequence.iter().enumerate() {
            turn[group] = node;
        }
        let in_turn = |clique: Vec<usize>| ascending(clique.into_iter().map(|group| turn[group]));
        let later: Vec<Vec<usize>> = cliques.into_iter().map(in_turn).collect();
        let sequence_of_nodes = children_before_parents(&later);
        let mut place = vec![0; sequence_of_nodes.len()];
        for (node, &old) in sequence_of_nodes.iter().enumerate() {
            place[old] = node;
        }
        let moved = |old: &usize| ascending(later[*old].iter().map(|&other| place[other]));
        let later: Vec<Vec<usize>> = sequence_of_nodes.iter().map(moved).collect();
        let nodes: Vec<Vec<usize>> = sequence_of_nodes.iter().map(|&old| groups[sequence[old]].clone()).collect();
        let mut node_of = vec![0; matrix.len()];
        for (node, blocks) in nodes.iter().enumerate() {
            for &block in blocks {
                node_of[block] = node;
            }
        }
        let weights: Vec<usize> =
            nodes.iter().map(|blocks| blocks.iter().map(|&block| matrix.size(block)).sum()).collect();
        let fronts = fronts(&later, &weights);
        let later = fronts.iter().map(|front| later[front.end - 1].clone()).collect();
        Self { nodes, node_of, fronts, later }
    }
}

fn ascending(nodes: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut nodes: Vec<usize> = nodes.collect();
    nodes.sort_unstable();
    nodes
}

/// The nodes with those of each branch of the elimination tree one after the other, and the parent right after its
/// child with the most couplings. `later` are the couplings of each with later ones; its parent is the first of them.
fn children_before_parents(later: &[Vec<usize>]) -> Vec<usize> {
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); later.len()];
    let mut waiting = Vec::new();
    for (node, later) in later.iter().enumerate().rev() {
        match later.first() {
            Some(&parent) => children[parent].push(node),
            None => waiting.push(node),
        }
    }
    // From behind: a parent, then the branch of its child with the most couplings, and so on.
    waiting.reverse();
    let mut sequence = Vec::with_capacity(later.len());
    while let Some(node) = waiting.pop() {
        sequence.push(node);
        children[node].sort_by_key(|&child| (later[child].len(), child));
        waiting.append(&mut children[node]);
    }
    sequence.reverse();
    sequence
}

/// Nodes that follow each other with nearly the same couplings; `weights` are their unknowns.
fn fronts(later: &[Vec<usize>], weights: &[usize]) -> Vec<Range<usize>> {
    let size = |nodes: &mut dyn Iterator<Item = usize>| nodes.map(|node| weights[node]).sum::<usize>();
    let mut fronts: Vec<Range<usize>> = Vec::new();
    // Rows of the first node of the front alone.
    let mut least = 0;
    for node in 0..later.len() {
        // What a child is coupled with its parent is coupled with, too.
        let is_parent = |last: usize| later[last].first() == Some(&node);
        let own = |first: usize| size(&mut (first..=node).chain(later[node].iter().copied()));
        match fronts.last_mut() {
            Some(front) if is_parent(front.end - 1) && own(front.start) as f64 <= MOST_GROWTH * least as f64 => {
                front.end = node + 1;
            }
            _ => {
                fronts.push(node..node + 1);
                least = own(node);
            }
        }
    }
    fronts
}

/// Blocks with the same neighbours, in the order of the first of each.
fn groups(matrix: &BlockMatrix) -> Vec<Vec<usize>> {
    let mut group_of: BTreeMap<&[usize], usize> = BTreeMap::new();
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for block in 0..matrix.len() {
        let group = *group_of.entry(matrix.neighbours(block)).or_insert(groups.len());
        if group == groups.len() {
            groups.push(Vec::new());
        }
        groups[group].push(block);
    }
    groups
}

/// Nodes by minimum degree, and the neighbours that each has left in its turn; `beside` are those of each at first,
/// ascending.
pub(crate) fn minimum_degree(mut beside: Vec<Vec<usize>>, weights: &[usize]) -> (Vec<usize>, Vec<Vec<usize>>) {
    let degree = |neighbours: &[usize]| neighbours.iter().map(|&other| weights[other]).sum::<usize>();
    let mut degrees: Vec<usize> = beside.iter().map(|neighbours| degree(neighbours)).collect();
    let mut waiting: BTreeSet<(usize, usize)> = degrees.iter().enumerate().map(|(node, &d)| (d, node)).collect();
    let mut sequence = Vec::with_capacity(beside.len());
    let mut cliques = Vec::with_capacity(beside.len());
    let (mut merged, mut known) = (Vec::new(), Vec::new());
    while let Some((_, node)) = waiting.pop_first() {
        sequence.push(node);
        let clique = std::mem::take(&mut beside[node]);
        if clique.iter().all(|other| known.binary_search(other).is_ok()) {
            // Those beside it are neighbours of each other already, as of nodes with the same neighbours.
            for &other in &clique {
                beside[other].retain(|&third| third != node);
                waiting.remove(&(degrees[other], other));
                degrees[other] -= weights[node];
                waiting.insert((degrees[other], other));
            }
            known.clone_from(&clique);
            cliques.push(clique);
            continue;
        }
        for &other in &clique {
            merge(&beside[other], &clique, &mut merged);
            merged.retain(|&third| third != other && third != node);
            std::mem::swap(&mut beside[other], &mut merged);
            waiting.remove(&(degrees[other], other));
            degrees[other] = degree(&beside[other]);
            waiting.insert((degrees[other], other));
        }
        known.clone_from(&clique);
        cliques.push(clique);
    }
    (sequence, cliques)
}

/// The union of two ascending lists.
fn merge(a: &[usize], b: &[usize], union: &mut Vec<usize>) {
    union.clear();
    let (mut i, mut j) = (0, 0);
    while i < a.len() && j < b.len() {
        let next = a[i].min(b[j]);
        i += usize::from(a[i] == next);
        j += usize::from(b[j] == next);
        union.push(next);
    }
    union.extend_from_slice(&a[i..]);
    union.extend_from_slice(&b[j..]);
}

#[cfg(test)]
mod tests {
    //! A chain is eliminated from its ends without new couplings, and contacts of the same bodies are one node.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn a_chain_is_eliminated_from_its_ends() {
        let links = (0..5).flat_map(|k| [(k, k + 1, vec![0.1]), (k + 1, k, vec![0.1])]);
        let diagonal = (0..6).map(|k| (k, k, vec![1.0]));
        let matrix = BlockMatrix::from_blocks(&[1; 6], links.chain(diagonal).collect()).unwrap();
        let order = EliminationOrder::of(&matrix);
        assert_eq!(order.nodes, [[0], [1], [2], [3], [4], [5]]);
    }

    #[test]
    fn what_is_coupled_with_all_is_eliminated_by_weight() {
        let beside = |node: usize| (0..4).filter(|&other| other != node).collect();
        let (sequence, cliques) = minimum_degree((0..4).map(beside).collect(), &[1, 3, 1, 2]);
        assert_eq!(sequence, [1, 3, 0, 2]);
        assert_eq!(cliques, [vec![0, 2, 3], vec![0, 2], vec![2], vec![]]);
    }

    #[test]
    fn contacts_of_the_same_bodies_are_one_node() {
        let all = (0..4).flat_map(|i| (0..4).map(move |j| (i, j, vec![1.0])));
        let matrix = BlockMatrix::from_blocks(&[1; 4], all.collect()).unwrap();
        assert_eq!(EliminationOrder::of(&matrix).nodes, [[0, 1, 2, 3]]);
    }
}

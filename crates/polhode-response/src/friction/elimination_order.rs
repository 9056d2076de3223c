//! The order in which unknowns are eliminated so that few new couplings arise: minimum degree.
//!
//! Contacts with the same neighbours (all those between the same two bodies) are one node from the start. Of the remaining nodes
//! the one with the fewest unknowns beside it comes next, the first of equal ones; its neighbours become neighbours of each
//! other. In chains and piles cost grows about linearly with the contacts. Source: George and Liu 1989.

use crate::friction::block_matrix::BlockMatrix;
use std::collections::{BTreeMap, BTreeSet};

/// Nodes in the order of their elimination.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct EliminationOrder {
    /// The blocks of each node, ascending.
    pub(crate) nodes: Vec<Vec<usize>>,
    /// The node of each block.
    pub(crate) node_of: Vec<usize>,
    /// Later nodes that each is coupled with when its turn comes, ascending.
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
        let in_turn = |clique: Vec<usize>| {
            let mut later: Vec<usize> = clique.into_iter().map(|group| turn[group]).collect();
            later.sort_unstable();
            later
        };
        let later = cliques.into_iter().map(in_turn).collect();
        let nodes: Vec<Vec<usize>> = sequence.iter().map(|&group| groups[group].clone()).collect();
        let mut node_of = vec![0; matrix.len()];
        for (node, blocks) in nodes.iter().enumerate() {
            for &block in blocks {
                node_of[block] = node;
            }
        }
        Self { nodes, node_of, later }
    }
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

/// Nodes by minimum degree, and the neighbours that each has left in its turn; `beside` are those of each at first, ascending.
fn minimum_degree(mut beside: Vec<Vec<usize>>, weights: &[usize]) -> (Vec<usize>, Vec<Vec<usize>>) {
    let degree = |neighbours: &[usize]| neighbours.iter().map(|&other| weights[other]).sum::<usize>();
    let mut degrees: Vec<usize> = beside.iter().map(|neighbours| degree(neighbours)).collect();
    let mut waiting: BTreeSet<(usize, usize)> = degrees.iter().enumerate().map(|(node, &d)| (d, node)).collect();
    let mut sequence = Vec::with_capacity(beside.len());
    let mut cliques = Vec::with_capacity(beside.len());
    let mut merged = Vec::new();
    while let Some((_, node)) = waiting.pop_first() {
        sequence.push(node);
        let clique = std::mem::take(&mut beside[node]);
        for &other in &clique {
            merge(&beside[other], &clique, &mut merged);
            merged.retain(|&third| third != other && third != node);
            std::mem::swap(&mut beside[other], &mut merged);
            waiting.remove(&(degrees[other], other));
            degrees[other] = degree(&beside[other]);
            waiting.insert((degrees[other], other));
        }
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
    fn contacts_of_the_same_bodies_are_one_node() {
        let all = (0..4).flat_map(|i| (0..4).map(move |j| (i, j, vec![1.0])));
        let matrix = BlockMatrix::from_blocks(&[1; 4], all.collect()).unwrap();
        assert_eq!(EliminationOrder::of(&matrix).nodes, [[0, 1, 2, 3]]);
    }
}

//! A static tree of axis-aligned boxes: finds the boxes that overlap a given one, or visits the nearest first.
//!
//! Each node is split into halves of equal number at the median of the boxes' centres along its longest side, ties by
//! index. So any input, also coincident boxes, gives a balanced tree, and the same one on every machine.

use super::aabb::Aabb;

/// Boxes in a leaf.
const LEAF: usize = 4;

#[derive(Debug, Clone, Copy, PartialEq)]
struct Node {
    bounds: Aabb,
    /// Index of the first item of a leaf, or of the second child of an inner node (the first child follows the node).
    link: u32,
    /// Number of items, zero for an inner node.
    count: u32,
}

/// The tree.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct BoxTree {
    nodes: Vec<Node>,
    items: Vec<u32>,
}

impl BoxTree {
    pub(crate) fn new(boxes: &[Aabb]) -> Self {
        let mut tree = Self::default();
        let mut items: Vec<u32> = (0..boxes.len() as u32).collect();
        if !items.is_empty() {
            tree.grow(boxes, &mut items, 0);
        }
        tree.items = items;
        tree
    }

    fn grow(&mut self, boxes: &[Aabb], items: &mut [u32], first: u32) {
        let bounds = items.iter().fold(Aabb::EMPTY, |b, &i| b.merged(&boxes[i as usize]));
        let index = self.nodes.len();
        self.nodes.push(Node { bounds, link: first, count: items.len() as u32 });
        if items.len() <= LEAF {
            items.sort_unstable();
            return;
        }
        let extent = bounds.max - bounds.min;
        let axis = if extent.x >= extent.y.max(extent.z) { 0 } else { 1 + usize::from(extent.z > extent.y) };
        let center = |i: u32| boxes[i as usize].min[axis] + boxes[i as usize].max[axis];
        let half = items.len() / 2;
        items.select_nth_unstable_by(half, |&i, &j| center(i).total_cmp(&center(j)).then(i.cmp(&j)));
        let (left, right) = items.split_at_mut(half);
        self.grow(boxes, left, first);
        let second = self.nodes.len() as u32;
        self.grow(boxes, right, first + half as u32);
        self.nodes[index] = Node { bounds, link: second, count: 0 };
    }

    /// The box around all; empty when there are none.
    pub(crate) fn bounds(&self) -> Aabb {
        self.nodes.first().map_or(Aabb::EMPTY, |node| node.bounds)
    }

    /// Calls `visit` with the items of every leaf that overlaps a box, in no stated order; single items of such a leaf
    /// need not overlap it.
    pub(crate) fn overlaps(&self, with: &Aabb, visit: &mut impl FnMut(u32)) {
        self.passing(&|bounds| bounds.overlaps(with), visit);
    }

    /// Calls `visit` with the items of every leaf for whose box `passes` is true. It must be monotone: a box inside one
    /// that does not pass must not pass either.
    pub(crate) fn passing(&self, passes: &impl Fn(&Aabb) -> bool, visit: &mut impl FnMut(u32)) {
        // The recursion is as deep as the tree: at most 32 levels.
        self.descend(0, passes, visit);
    }

    fn descend(&self, at: usize, passes: &impl Fn(&Aabb) -> bool, visit: &mut impl FnMut(u32)) {
        let Some(node) = self.nodes.get(at) else { return };
        if !passes(&node.bounds) {
            return;
        }
        if node.count > 0 {
            self.items[node.link as usize..(node.link + node.count) as usize].iter().for_each(|&item| visit(item));
            return;
        }
        self.descend(at + 1, passes, visit);
        self.descend(node.link as usize, passes, visit);
    }

    /// The least value of `measure` over the items and `start`, by branch and bound, nearest boxes first. `measure` is
    /// given an item and the least value so far. `bound` is a lower bound of the values in a box; boxes with a bound
    /// above both the least value found and `floor` are skipped.
    pub(crate) fn least(
        &self,
        start: f64,
        floor: f64,
        bound: &impl Fn(&Aabb) -> f64,
        measure: &mut impl FnMut(u32, f64) -> f64,
    ) -> f64 {
        match self.nodes.first() {
            Some(root) => self.least_in(0, bound(&root.bounds), start, floor, bound, measure),
            None => start,
        }
    }

    fn least_in(
        &self,
        at: usize,
        near: f64,
        mut best: f64,
        floor: f64,
        bound: &impl Fn(&Aabb) -> f64,
        measure: &mut impl FnMut(u32, f64) -> f64,
    ) -> f64 {
        let Some(node) = self.nodes.get(at) else { return best };
        if near > best.max(floor) {
            return best;
        }
        if node.count > 0 {
            for &item in &self.items[node.link as usize..(node.link + node.count) as usize] {
                best = best.min(measure(item, best));
            }
            return best;
        }
        let (first, second) = (at + 1, node.link as usize);
        let of = |at: usize| self.nodes.get(at).map_or(f64::INFINITY, |node| bound(&node.bounds));
        let (near_first, near_second) = (of(first), of(second));
        let order = [(first, near_first), (second, near_second)];
        let order = if near_second < near_first { [order[1], order[0]] } else { order };
        for (child, near) in order {
            best = self.least_in(child, near, best, floor, bound, measure);
        }
        best
    }
}

//! A binary tree of boxes about the triangles (or points) of a body: which of them are near a box, or near those of
//! another body.
//!
//! It is built once, in the body's frame; where the body is placed, the boxes are fitted again and the branches stay.

use glam::DVec3;

/// A box by its lowest and highest corner, m.
pub(super) type Bounds = (DVec3, DVec3);

/// Items of a leaf.
const LEAF: usize = 4;

/// The box about some points.
pub(super) fn bounds(points: impl IntoIterator<Item = DVec3>) -> Bounds {
    points.into_iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)))
}

fn joined(a: Bounds, b: Bounds) -> Bounds {
    (a.0.min(b.0), a.1.max(b.1))
}

/// Whether two boxes are no farther apart than `slack` along every axis, m.
pub(super) fn are_near(a: Bounds, b: Bounds, slack: f64) -> bool {
    (a.0 - b.1).max(b.0 - a.1).max_element() <= slack
}

/// A branch with the items from `first` to before `end`; its first child stands behind it.
#[derive(Debug, Clone)]
struct Node {
    bounds: Bounds,
    first: usize,
    end: usize,
    /// None of a leaf.
    second_child: Option<usize>,
}

/// The tree.
#[derive(Debug, Clone, Default)]
pub(super) struct BoxTree {
    nodes: Vec<Node>,
    items: Vec<usize>,
    /// Of the items, in the order of the leaves.
    boxes: Vec<Bounds>,
}

impl BoxTree {
    /// Of items with these boxes.
    pub(super) fn new(boxes: &[Bounds]) -> Self {
        let mut tree = Self { nodes: Vec::new(), items: (0..boxes.len()).collect(), boxes: Vec::new() };
        if !boxes.is_empty() {
            tree.branch(boxes, 0, boxes.len());
            tree.fit(|item| boxes[item]);
        }
        tree
    }

    /// Halves the items by the middles of their boxes along the longest axis, until few are left.
    fn branch(&mut self, boxes: &[Bounds], first: usize, end: usize) {
        let at = self.nodes.len();
        self.nodes.push(Node { bounds: (DVec3::INFINITY, DVec3::NEG_INFINITY), first, end, second_child: None });
        if end - first <= LEAF {
            return;
        }
        let middle = |item: usize| boxes[item].0 + boxes[item].1;
        let (low, high) = bounds(self.items[first..end].iter().map(|&item| middle(item)));
        let axis = (0..3).max_by(|&i, &j| (high - low)[i].total_cmp(&(high - low)[j])).unwrap_or_default();
        self.items[first..end].sort_by(|&i, &j| middle(i)[axis].total_cmp(&middle(j)[axis]));
        let half = first.midpoint(end);
        self.branch(boxes, first, half);
        self.nodes[at].second_child = Some(self.nodes.len());
        self.branch(boxes, half, end);
    }

    /// Fits all boxes to those of the items.
    pub(super) fn fit(&mut self, of_item: impl Fn(usize) -> Bounds) {
        self.boxes.clear();
        self.boxes.extend(self.items.iter().map(|&item| of_item(item)));
        for at in (0..self.nodes.len()).rev() {
            let node = &self.nodes[at];
            let bounds = if let Some(second) = node.second_child {
                joined(self.nodes[at + 1].bounds, self.nodes[second].bounds)
            } else {
                self.boxes[node.first..node.end].iter().copied().reduce(joined).unwrap_or(node.bounds)
            };
            self.nodes[at].bounds = bounds;
        }
    }

    /// The box about everything; none of nothing.
    pub(super) fn bounds(&self) -> Option<Bounds> {
        self.nodes.first().map(|root| root.bounds)
    }

    /// Whether a place is no farther than `slack` (m) from the box about everything.
    pub(super) fn is_near(&self, place: DVec3, slack: f64) -> bool {
        self.bounds().is_some_and(|bounds| are_near(bounds, (place, place), slack))
    }

    /// The items that are no farther than `slack` (m) from a box.
    pub(super) fn near(&self, of: Bounds, slack: f64) -> Vec<usize> {
        let mut found = Vec::new();
        let mut open: Vec<usize> = self.nodes.first().map(|_| 0).into_iter().collect();
        while let Some(at) = open.pop() {
            let node = &self.nodes[at];
            if !are_near(node.bounds, of, slack) {
                continue;
            }
            if let Some(second) = node.second_child {
                open.extend([at + 1, second]);
            } else {
                let leaf = (node.first..node.end).filter(|&k| are_near(self.boxes[k], of, slack));
                found.extend(leaf.map(|k| self.items[k]));
            }
        }
        found
    }

    /// The pairs of items of two trees that are no farther apart than `slack`, m.
    pub(super) fn near_pairs(&self, other: &Self, slack: f64) -> Vec<[usize; 2]> {
        let mut found = Vec::new();
        let mut open = if self.nodes.is_empty() || other.nodes.is_empty() { Vec::new() } else { vec![[0, 0]] };
        while let Some([a, b]) = open.pop() {
            let (node, beside) = (&self.nodes[a], &other.nodes[b]);
            if !are_near(node.bounds, beside.bounds, slack) {
                continue;
            }
            let is_larger = node.end - node.first >= beside.end - beside.first;
            match (node.second_child, beside.second_child) {
                (Some(second), None) => open.extend([[a + 1, b], [second, b]]),
                (Some(second), Some(_)) if is_larger => open.extend([[a + 1, b], [second, b]]),
                (_, Some(second)) => open.extend([[a, b + 1], [a, second]]),
                (None, None) => {
                    let pairs = (node.first..node.end).flat_map(|i| (beside.first..beside.end).map(move |j| [i, j]));
                    let near = pairs.filter(|&[i, j]| are_near(self.boxes[i], other.boxes[j], slack));
                    found.extend(near.map(|[i, j]| [self.items[i], other.items[j]]));
                }
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    //! Against a search of everything.
    use super::*;
    use crate::random::Random;

    #[test]
    fn all_near_boxes_are_found() {
        let mut random = Random(5);
        let mut boxes = |count: usize| -> Vec<Bounds> {
            let corner = |random: &mut Random| (random.vector(0.0, 10.0), random.vector(0.0, 1.0));
            (0..count).map(|_| corner(&mut random)).map(|(low, extent)| (low, low + extent)).collect()
        };
        let (first, second) = (boxes(70), boxes(30));
        let (tree, other) = (BoxTree::new(&first), BoxTree::new(&second));
        let pairs = tree.near_pairs(&other, 0.1);
        for (j, &of) in second.iter().enumerate() {
            let near = tree.near(of, 0.1);
            for (i, &found) in first.iter().enumerate() {
                let expected = are_near(found, of, 0.1);
                assert_eq!([near.contains(&i), pairs.contains(&[i, j])], [expected; 2], "{found:?} {of:?}");
            }
        }
    }
}

//! Sweep and prune: boxes in the order of their lower bounds on one axis.
//!
//! Two boxes overlap only if their intervals on the axis do. In the order of the sweep each box is tested on the other
//! two axes against the boxes that begin before it ends (docs/REFERENCES.md, Cohen et al. 1995). The order is kept from
//! call to call and brought up to date by insertion sort, in a time proportional to how much it has changed. The axis
//! is the one along which the centres vary most; another one is taken when its variance is clearly larger. It is fast
//! for boxes spread over a plane or a line; in a ball of n boxes each interval overlaps about n^(2/3) others.

use super::pair_collector::{PairCollector, PairSearch};
use crate::Aabb;
use crate::shape::LARGEST_LENGTH;
use glam::DVec3;

/// The axis is changed when the variance along another one is larger by this factor: a change costs a full sort.
const AXIS_CHANGE: f64 = 1.5;

/// Insertion sort is abandoned for a full sort after this many moves per box.
const MOST_MOVES_PER_BOX: usize = 16;

/// One box in the order of the sweep.
#[derive(Debug, Clone, Copy)]
struct Swept {
    /// Bounds on the axis of the sweep.
    low: f64,
    high: f64,
    /// Bounds on the two others.
    across_low: [f64; 2],
    across_high: [f64; 2],
    number: u32,
}

/// Sweep and prune along one axis.
#[derive(Debug, Default)]
pub(crate) struct SweepAndPrune {
    /// Numbers of the boxes in the order of the last call.
    order: Vec<u32>,
    axis: usize,
    swept: Vec<Swept>,
}

impl PairSearch for SweepAndPrune {
    fn search(&mut self, boxes: &[Aabb], found: &mut PairCollector) {
        self.choose_axis(boxes);
        self.renumber(boxes.len());
        let axis = self.axis;
        self.swept.clear();
        self.swept.extend(self.order.iter().map(|&number| swept(&boxes[number as usize], axis, number)));
        if !insertion_sort(&mut self.swept) {
            self.swept.sort_unstable_by(|a, b| a.low.total_cmp(&b.low).then(a.number.cmp(&b.number)));
        }
        for (place, swept) in self.order.iter_mut().zip(&self.swept) {
            *place = swept.number;
        }
        for (place, first) in self.swept.iter().enumerate() {
            for second in self.swept[place + 1..].iter().take_while(|second| second.low <= first.high) {
                let meets = |k: usize| {
                    first.across_low[k] <= second.across_high[k] && second.across_low[k] <= first.across_high[k]
                };
                if meets(0) && meets(1) {
                    found.push(first.number, second.number);
                }
            }
        }
    }
}

impl SweepAndPrune {
    fn choose_axis(&mut self, boxes: &[Aabb]) {
        let limit = DVec3::splat(LARGEST_LENGTH);
        let center = |aabb: &Aabb| 0.5 * (aabb.min().clamp(-limit, limit) + aabb.max().clamp(-limit, limit));
        let share = 1.0 / boxes.len().max(1) as f64;
        let mean = boxes.iter().map(|aabb| center(aabb) * share).sum::<DVec3>();
        let variance = boxes
            .iter()
            .map(|aabb| {
                let d = center(aabb) - mean;
                d * d * share
            })
            .sum::<DVec3>();
        let best = (0..3).fold(0, |best, axis| if variance[axis] > variance[best] { axis } else { best });
        if variance[best] > AXIS_CHANGE * variance[self.axis] {
            self.axis = best;
        }
    }

    /// Adapts the order to the number of boxes: removes those that no longer exist, appends new ones.
    fn renumber(&mut self, count: usize) {
        self.order.retain(|&number| (number as usize) < count);
        let known = self.order.len();
        self.order.extend((known..count).map(|number| number as u32));
    }
}

fn swept(aabb: &Aabb, axis: usize, number: u32) -> Swept {
    let (min, max) = (aabb.min(), aabb.max());
    let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    Swept { low: min[axis], high: max[axis], across_low: [min[u], min[v]], across_high: [max[u], max[v]], number }
}

/// Sorts by the lower bound, or gives up when too much has changed.
fn insertion_sort(swept: &mut [Swept]) -> bool {
    let mut moves_left = MOST_MOVES_PER_BOX * swept.len();
    for i in 1..swept.len() {
        let moving = swept[i];
        let mut place = i;
        while place > 0 && swept[place - 1].low > moving.low {
            if moves_left == 0 {
                swept[place] = moving;
                return false;
            }
            moves_left -= 1;
            swept[place] = swept[place - 1];
            place -= 1;
        }
        swept[place] = moving;
    }
    true
}

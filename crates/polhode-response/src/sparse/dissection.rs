//! Nested dissection of the graph of bodies: an order of elimination for large piles.
//!
//! From a body at the border the others are counted in levels of distance; those of the narrowest level near the
//! middle that have neighbours beyond it part the graph in two, and are eliminated after both, each of which is
//! parted in the same way. Small parts are left to minimum degree. All choices go by the lowest index, so that the
//! order is the same everywhere. Sources: George 1973; Gibbs, Poole and Stockmeyer 1976 (the body at the border).

use crate::friction::elimination_order::minimum_degree;

/// Parts of at most so many bodies are eliminated by minimum degree (8 to 64).
const SMALL_PART: usize = 16;

/// Times that the search for a body at the border goes on from the farthest one.
const BORDER_SEARCHES: usize = 4;

/// The order of elimination; `beside` are the neighbours of each body, ascending.
pub(crate) fn dissected(beside: &[Vec<usize>]) -> Vec<usize> {
    let mut dissection = Dissection { beside, part_of: vec![0; beside.len()], parts: 1, level: vec![0; beside.len()] };
    // From behind: separators before the parts that they part.
    let mut order = Vec::with_capacity(beside.len());
    let mut waiting = vec![(0..beside.len()).collect::<Vec<usize>>()];
    while let Some(part) = waiting.pop() {
        if part.len() <= SMALL_PART {
            order.extend(dissection.by_degree(&part).into_iter().rev());
            continue;
        }
        let (separator, parts) = dissection.parted(&part);
        order.extend(separator.into_iter().rev());
        waiting.extend(parts);
    }
    order.reverse();
    order
}

#[derive(Debug)]
struct Dissection<'a> {
    beside: &'a [Vec<usize>],
    /// Which part each body is in; bodies of separators are in none of those that are parted further.
    part_of: Vec<usize>,
    parts: usize,
    level: Vec<usize>,
}

impl Dissection<'_> {
    /// Minimum degree within a part.
    fn by_degree(&self, part: &[usize]) -> Vec<usize> {
        let own = |body: usize| part.binary_search(&body).ok();
        let beside = part.iter().map(|&body| self.beside[body].iter().filter_map(|&other| own(other)).collect());
        let (order, _) = minimum_degree(beside.collect(), &vec![1; part.len()]);
        order.into_iter().map(|place| part[place]).collect()
    }

    /// A separator and the parts that it leaves, each ascending.
    fn parted(&mut self, part: &[usize]) -> (Vec<usize>, Vec<Vec<usize>>) {
        let own = self.next_part(part);
        let mut reached = self.levels(part[0], own);
        if reached.len() < part.len() {
            // Not connected: no separator is needed.
            let rest = self.next_part(&reached);
            let left = part.iter().copied().filter(|&body| self.part_of[body] != rest).collect();
            reached.sort_unstable();
            return (Vec::new(), vec![reached, left]);
        }
        for _ in 0..BORDER_SEARCHES {
            let Some(&farthest) = reached.last() else { break };
            let depth = self.level[farthest];
            let other = self.levels(farthest, own);
            let deeper = other.last().is_some_and(|&last| self.level[last] > depth);
            reached = other;
            if !deeper {
                break;
            }
        }
        let middle = self.narrowest(&reached);
        let goes_on = |body: usize| {
            let beyond = |other: &&usize| self.part_of[**other] == own && self.level[**other] > self.level[body];
            self.beside[body].iter().find(beyond).is_some()
        };
        let (mut separator, mut near, mut far) = (Vec::new(), Vec::new(), Vec::new());
        for &body in part {
            let target = match self.level[body].cmp(&middle) {
                std::cmp::Ordering::Greater => &mut far,
                std::cmp::Ordering::Equal if goes_on(body) => &mut separator,
                _ => &mut near,
            };
            target.push(body);
        }
        if far.is_empty() || near.is_empty() {
            // As in a clique: nothing is gained by parting it.
            return (self.by_degree(part), Vec::new());
        }
        (separator, vec![near, far])
    }

    /// The level with the fewest bodies among those near the middle; `reached` are the bodies of a part by their level.
    fn narrowest(&self, reached: &[usize]) -> usize {
        let at = |place: usize| self.level[reached[place.min(reached.len() - 1)]];
        let (first, last) = (at(reached.len() * 2 / 5), at(reached.len() * 3 / 5));
        let size = |level: usize| reached.iter().filter(|&&body| self.level[body] == level).count();
        (first..=last).min_by_key(|&level| (size(level), level)).unwrap_or(first)
    }

    /// Bodies of a part by their distance from one of them.
    fn levels(&mut self, from: usize, own: usize) -> Vec<usize> {
        const FAR: usize = usize::MAX;
        for (level, part) in self.level.iter_mut().zip(&self.part_of) {
            if *part == own {
                *level = FAR;
            }
        }
        let mut reached = vec![from];
        self.level[from] = 0;
        let mut next = 0;
        while next < reached.len() {
            let body = reached[next];
            next += 1;
            for &other in &self.beside[body] {
                if self.part_of[other] == own && self.level[other] == FAR {
                    self.level[other] = self.level[body] + 1;
                    reached.push(other);
                }
            }
        }
        reached
    }

    /// Makes a part of these bodies.
    fn next_part(&mut self, bodies: &[usize]) -> usize {
        self.parts += 1;
        for &body in bodies {
            self.part_of[body] = self.parts;
        }
        self.parts
    }
}

#[cfg(test)]
mod tests {
    //! Every body has one turn, whatever the graph.
    use super::*;

    fn has_every_body_once(beside: &[Vec<usize>]) {
        let mut order = dissected(beside);
        order.sort_unstable();
        assert_eq!(order, (0..beside.len()).collect::<Vec<usize>>());
    }

    #[test]
    fn every_body_has_one_turn() {
        let grid = |columns: usize, rows: usize| -> Vec<Vec<usize>> {
            let near =
                |a: usize, b: usize| (a % columns).abs_diff(b % columns) + (a / columns).abs_diff(b / columns) == 1;
            (0..columns * rows).map(|a| (0..columns * rows).filter(|&b| near(a, b)).collect()).collect()
        };
        has_every_body_once(&grid(12, 9));
        has_every_body_once(&grid(100, 1));
        // No coupling at all, two parts, and a clique.
        has_every_body_once(&vec![Vec::new(); 80]);
        let mut parts = grid(10, 5);
        parts.extend(grid(10, 5).into_iter().map(|list| list.into_iter().map(|body| body + 50).collect()));
        has_every_body_once(&parts);
        has_every_body_once(&(0..60).map(|a| (0..60).filter(|&b| b != a).collect()).collect::<Vec<_>>());
    }
}

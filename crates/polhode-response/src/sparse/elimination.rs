//! The order in which bodies are eliminated, and where the factors then have entries: all that depends on the graph
//! alone.
//!
//! Bodies are coupled that share a block of rows. The body with the fewest neighbours left comes next, the first of
//! equal ones, and its neighbours become neighbours of each other (minimum degree): trees of joints are eliminated
//! from their leaves to their roots without a new coupling, small piles with few. In large piles nested dissection
//! may leave fewer: the order that takes fewer products of blocks is taken. As long as the graph stays the same, so
//! does this. Sources: George and Liu 1989; Liu 1990 (the couplings of an order from those of the bodies before it).

use crate::friction::elimination_order::minimum_degree;
use crate::sparse::dissection::dissected;
use crate::sparse::problem::{BodyProblem, RowBlock};
use std::ops::Range;

/// The order of bodies and the places of blocks.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Elimination {
    /// The pairs of bodies of every block of rows: what it was made for.
    pairs: Vec<[u32; 2]>,
    bodies: usize,
    /// The turn of each body.
    turns: Vec<usize>,
    /// The body of each turn.
    order: Vec<usize>,
    /// Where the couplings of each turn with later ones begin; one more than turns.
    starts: Vec<usize>,
    /// The later turns, ascending within each.
    later: Vec<u32>,
    /// Where each block of rows couples its two bodies.
    places: Vec<Option<Coupling>>,
}

/// Where two bodies are coupled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Coupling {
    /// Which of the couplings.
    pub(crate) at: usize,
    /// Whether the first body of the rows comes in the later turn.
    pub(crate) first_is_later: bool,
}

/// From so many bodies on nested dissection is tried (50 to 200).
const LEAST_DISSECTED: usize = 100;

/// The place of rows without a second body that moves.
const NO_BODY: u32 = u32::MAX;

impl Elimination {
    /// For the graph of a problem.
    pub fn of(problem: &BodyProblem) -> Self {
        let bodies = problem.movable_bodies();
        let mut beside: Vec<Vec<usize>> = vec![Vec::new(); bodies];
        let pairs: Vec<[u32; 2]> = problem.blocks.iter().map(pair).collect();
        for &[a, b] in pairs.iter().filter(|pair| pair[1] != NO_BODY) {
            beside[a as usize].push(b as usize);
            beside[b as usize].push(a as usize);
        }
        for list in &mut beside {
            list.sort_unstable();
            list.dedup();
        }
        let (by_degree, _) = minimum_degree(beside.clone(), &vec![1; bodies]);
        let mut couplings = Couplings::of(by_degree, &beside);
        if bodies >= LEAST_DISSECTED {
            let other = Couplings::of(dissected(&beside), &beside);
            if other.products() < couplings.products() {
                couplings = other;
            }
        }
        let Couplings { order, turns, starts, later } = couplings;
        let mut elimination = Self { pairs, bodies, turns, order, starts, later, places: Vec::new() };
        elimination.places = elimination.pairs.iter().map(|pair| elimination.coupling(*pair)).collect();
        elimination
    }

    fn coupling(&self, [a, b]: [u32; 2]) -> Option<Coupling> {
        if b == NO_BODY {
            return None;
        }
        let (a, b) = (self.turns[a as usize], self.turns[b as usize]);
        let range = self.range(a.min(b));
        let place = self.later[range.clone()].binary_search(&(a.max(b) as u32)).ok()?;
        Some(Coupling { at: range.start + place, first_is_later: a > b })
    }

    /// Whether it fits the problem: the same bodies, coupled by the same rows.
    pub fn fits(&self, problem: &BodyProblem) -> bool {
        self.bodies == problem.movable_bodies()
            && self.pairs.len() == problem.blocks.len()
            && self.pairs.iter().zip(&problem.blocks).all(|(own, block)| *own == pair(block))
    }

    /// Bodies that move.
    pub fn bodies(&self) -> usize {
        self.bodies
    }

    /// Blocks of a factor, those of the diagonal included.
    pub fn factor_blocks(&self) -> usize {
        self.bodies + self.later.len()
    }

    /// Products of two blocks that one factorisation of a symmetric matrix takes; one that is not symmetric takes
    /// twice as many.
    pub fn block_products(&self) -> usize {
        (0..self.bodies).map(|turn| self.range(turn).len()).map(|later| later * (later + 1) / 2).sum()
    }

    /// Couplings.
    pub(crate) fn couplings(&self) -> usize {
        self.later.len()
    }

    /// Couplings of a turn with later ones.
    pub(crate) fn range(&self, turn: usize) -> Range<usize> {
        self.starts[turn]..self.starts[turn + 1]
    }

    /// The later turn of each coupling.
    pub(crate) fn later(&self) -> &[u32] {
        &self.later
    }

    /// The turn of a body.
    pub(crate) fn turn(&self, body: usize) -> usize {
        self.turns[body]
    }

    /// The body of each turn.
    pub(crate) fn order(&self) -> &[usize] {
        &self.order
    }

    /// Where a block of rows couples its two bodies.
    pub(crate) fn place(&self, block: usize) -> Option<Coupling> {
        self.places[block]
    }
}

/// An order and the couplings that it leads to.
#[derive(Debug)]
struct Couplings {
    order: Vec<usize>,
    turns: Vec<usize>,
    starts: Vec<usize>,
    later: Vec<u32>,
}

impl Couplings {
    /// Of an order; `beside` are the neighbours of each body.
    fn of(order: Vec<usize>, beside: &[Vec<usize>]) -> Self {
        let mut turns = vec![0; order.len()];
        for (turn, &body) in order.iter().enumerate() {
            turns[body] = turn;
        }
        let (mut starts, mut later) = (vec![0], Vec::<u32>::new());
        // Those before each turn whose first later one it is: their other couplings become its own.
        let mut children: Vec<Vec<usize>> = vec![Vec::new(); order.len()];
        for (turn, &body) in order.iter().enumerate() {
            let first = later.len();
            later.extend(beside[body].iter().map(|&other| turns[other] as u32).filter(|&other| other as usize > turn));
            for child in std::mem::take(&mut children[turn]) {
                let range: Range<usize> = starts[child] + 1..starts[child + 1];
                later.extend_from_within(range);
            }
            later[first..].sort_unstable();
            let mut kept = first;
            for place in first..later.len() {
                if place == first || later[place] != later[kept - 1] {
                    later[kept] = later[place];
                    kept += 1;
                }
            }
            later.truncate(kept);
            if let Some(&parent) = later.get(first) {
                children[parent as usize].push(turn);
            }
            starts.push(later.len());
        }
        Self { order, turns, starts, later }
    }

    /// Products of two blocks that a factorisation takes.
    fn products(&self) -> usize {
        self.starts.windows(2).map(|pair| pair[1] - pair[0]).map(|later| later * (later + 1) / 2).sum()
    }
}

fn pair(block: &RowBlock) -> [u32; 2] {
    let mut pair = [NO_BODY; 2];
    for (target, side) in pair.iter_mut().zip(block.movable()) {
        *target = side.node as u32;
    }
    pair
}

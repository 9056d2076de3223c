//! A census of solves: which method answered, which were tried, and what the next ones of the chain would have given.
//!
//! This module exists with the feature `census` alone, for `cargo xtask census`. Each public solver tells it of every
//! solve: who asked (file and line), how large the problem is, the answer, its residual and its cost. Of some it also
//! asks what the chain finds without the method that answered, without that and the next, and so on. Nothing that a
//! solver returns depends on it.
//!
//! The table is a global of the process, which the product has none of: solvers are called from everywhere, and none of
//! them is to carry a table through its arguments for the sake of a census. Without the feature there is no table.
//!
//! | module | holds |
//! |---|---|
//! | `conversions` | problems of all solvers as [text](crate::problem_text) |

mod conversions;

use crate::problem_text::ProblemText;
use crate::report::SolverStatus;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::panic::Location;
use std::sync::{Mutex, PoisonError};

/// The first solves of each kind, and then one of so many, are asked what the next methods would give.
const ALWAYS_ASKED: u64 = 16;
const ASKED_OF: u64 = 64;

/// Problems of more rows are not solved again, nor kept.
const MOST_ROWS: usize = 1000;

/// Motions that differ by more, relative to the largest velocity, are other motions (no unit).
const OTHER_MOTION: f64 = 1e-6;

/// The finest classes of residuals: a quarter of a power of ten.
const CLASSES_A_DECADE: f64 = 4.0;

/// Which chain of methods.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Chain {
    /// [`ComplementaritySolver`](crate::ComplementaritySolver).
    ActiveSet,
    /// [`solve_friction`](crate::friction::solve_friction).
    Friction,
    /// [`BodySolver`](crate::sparse::BodySolver).
    Bodies,
    /// [`LeastNormHold`](crate::LeastNormHold) and [`least_norm_forces`](crate::least_norm_forces()).
    LeastNorm,
    /// [`least_norm_sliding_forces`](crate::least_norm_sliding_forces).
    LeastNormSliding,
    /// [`least_forces_in_cones`](crate::least_forces_in_cones).
    LeastInCones,
    /// [`HeldForest`](crate::sparse::HeldForest).
    Forest,
    /// [`Structure`](crate::friction::Structure) and the balance of forces in bodies.
    Limit,
    /// The heuristic, guesses and linear programme of the thesis.
    Thesis,
}

impl Chain {
    /// All chains.
    pub const ALL: &'static [Self] = &[
        Self::ActiveSet,
        Self::Friction,
        Self::Bodies,
        Self::LeastNorm,
        Self::LeastNormSliding,
        Self::LeastInCones,
        Self::Forest,
        Self::Limit,
        Self::Thesis,
    ];

    /// Its name in words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::ActiveSet => "active set",
            Self::Friction => "friction",
            Self::Bodies => "bodies",
            Self::LeastNorm => "least norm",
            Self::LeastNormSliding => "least norm sliding",
            Self::LeastInCones => "least in cones",
            Self::Forest => "forest",
            Self::Limit => "limit analysis",
            Self::Thesis => "thesis",
        }
    }
}

/// How large a problem is.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Size {
    /// Bodies that move; 0 where only a matrix is known.
    pub bodies: usize,
    /// Rows.
    pub rows: usize,
    /// Blocks with friction.
    pub cones: usize,
}

/// What a chain has found.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// The method that answered.
    pub method: &'static str,
    /// All that were tried.
    pub tried: Vec<&'static str>,
    /// How it ended.
    pub status: SolverStatus,
    /// The residual that decides.
    pub residual: f64,
    /// Factorisations, iterations and pivots.
    pub cost: usize,
    /// Velocities (accelerations) of the rows.
    pub motion: Vec<f64>,
}

/// Solves of one kind.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Kind {
    /// File of who asked.
    pub file: &'static str,
    /// Line there.
    pub line: u32,
    /// The chain.
    pub chain: Chain,
    /// The method that answered.
    pub method: &'static str,
    /// All that were tried.
    pub tried: Vec<&'static str>,
}

/// What another method gave.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Other {
    /// How many times it was the next to answer.
    pub count: u64,
    /// Accepted.
    pub accepted: u64,
    /// Accepted with a residual that is not larger, or within the tolerance.
    pub as_good: u64,
    /// Accepted with another motion.
    pub moved: u64,
    /// The worst residual of those accepted.
    pub worst: f64,
    /// Sum of the costs.
    pub cost: u64,
}

/// Methods of a chain that are left out together, to see what the others find.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeftOut {
    /// The chain.
    pub chain: Chain,
    /// The names of the methods.
    pub methods: Vec<String>,
}

/// What a chain finds without some of its methods, in solves that tried some of them.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Without {
    /// Solves.
    pub count: u64,
    /// Those that are solved with all methods.
    pub solved_before: u64,
    /// Those of them that are solved without.
    pub still_solved: u64,
    /// Those with a residual that is not larger, or within the tolerance.
    pub as_good: u64,
    /// Those that are solved without and were not before.
    pub newly_solved: u64,
    /// Costs with all methods, and without.
    pub cost: [u64; 2],
}

/// A problem that was kept.
#[derive(Debug, Clone, PartialEq)]
pub struct Kept {
    /// The residual of the answer.
    pub residual: f64,
    /// Status, cost and scene, a line each.
    pub facts: Vec<(&'static str, String)>,
    /// The problem.
    pub problem: ProblemText,
}

/// What is known of solves of one kind.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Counted {
    /// How many.
    pub count: u64,
    /// How many were not solved.
    pub unsolved: u64,
    /// How many residuals are in each class, by [`class_of`].
    pub residuals: BTreeMap<i32, u64>,
    /// The largest residual, and the scene where it was.
    pub worst: f64,
    /// That scene.
    pub worst_in: String,
    /// Sum of the costs.
    pub cost: u64,
    /// The most rows, cones and bodies.
    pub most: Size,
    /// Solves that were asked what the next methods give.
    pub asked: u64,
    /// Those of them that were solved.
    pub asked_solved: u64,
    /// Those of these that some other method solves.
    pub others_accepted: u64,
    /// Those that some other method solves as well.
    pub others_as_good: u64,
    /// Cost of the answers that were asked.
    pub asked_cost: u64,
    /// The methods that answered next, by how many were left out before.
    pub next: BTreeMap<(u8, &'static str), Other>,
    /// What is found without sets of methods, by their numbers.
    pub without: BTreeMap<usize, Without>,
    /// Scenes.
    pub scenes: BTreeSet<String>,
    /// Problems.
    pub kept: Vec<Kept>,
}

/// All that has been counted.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    /// The kinds of solves.
    pub kinds: BTreeMap<Kind, Counted>,
    /// Problems that are kept of each kind.
    keep: usize,
    /// Methods that are left out together.
    pub sets: Vec<LeftOut>,
}

static TABLE: Mutex<Table> = Mutex::new(Table { kinds: BTreeMap::new(), keep: 0, sets: Vec::new() });

thread_local! {
    static SCENE: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Keeps so many problems of each kind: half of them the first ones, the others those of the largest residuals.
pub fn keep_problems(keep: usize) {
    TABLE.lock().unwrap_or_else(PoisonError::into_inner).keep = keep;
}

/// Asks of each kind of solve what its chain finds without these methods.
pub fn leave_out(sets: Vec<LeftOut>) {
    TABLE.lock().unwrap_or_else(PoisonError::into_inner).sets = sets;
}

/// Names the scene of the solves that follow on this thread.
pub fn set_scene(name: &str) {
    SCENE.with_borrow_mut(|scene| name.clone_into(scene));
}

/// What has been counted since the last call.
pub fn take() -> Table {
    let mut table = TABLE.lock().unwrap_or_else(PoisonError::into_inner);
    let (keep, sets) = (table.keep, table.sets.clone());
    std::mem::replace(&mut *table, Table { kinds: BTreeMap::new(), keep, sets })
}

/// The class of a residual: four for each power of ten.
pub fn class_of(residual: f64) -> i32 {
    if residual > 0.0 { (CLASSES_A_DECADE * libm::log10(residual)).ceil() as i32 } else { i32::MIN }
}

/// The largest residual of a class.
pub fn residual_of(class: i32) -> f64 {
    if class == i32::MIN { 0.0 } else { libm::exp10(f64::from(class) / CLASSES_A_DECADE) }
}

/// Notes a solve. `enough` is the residual that the chain strives for; `again` gives what it finds without the methods
/// of these names, none where nothing else is left.
#[track_caller]
pub(crate) fn note(
    chain: Chain,
    size: Size,
    answer: &Answer,
    enough: f64,
    mut again: impl FnMut(&[&str]) -> Option<Answer>,
    problem: impl FnOnce() -> ProblemText,
) {
    let caller = Location::caller();
    let (file, line) = (caller.file(), caller.line());
    let kind = Kind { file, line, chain, method: answer.method, tried: answer.tried.clone() };
    let scene = SCENE.with_borrow(Clone::clone);
    let (is_asked, keeps, sets) = {
        let mut table = TABLE.lock().unwrap_or_else(PoisonError::into_inner);
        let (keep, sets) = (table.keep, table.sets.clone());
        let counted = table.kinds.entry(kind.clone()).or_default();
        counted.add(size, answer, &scene);
        let is_small = size.rows <= MOST_ROWS && answer.tried.contains(&answer.method);
        let is_asked = counted.count <= ALWAYS_ASKED || counted.count.is_multiple_of(ASKED_OF);
        (is_small && is_asked, size.rows <= MOST_ROWS && counted.would_keep(keep, answer.residual), sets)
    };
    // The table is free meanwhile.
    let (mut others, mut without) = (Vec::new(), vec![answer.method]);
    if is_asked {
        // Each answer is by a method that has not answered yet.
        while let Some(other) = again(&without).filter(|other| !without.contains(&other.method)) {
            without.push(other.method);
            others.push(other);
        }
    }
    let mut by_sets = Vec::new();
    for (number, set) in sets.iter().enumerate().filter(|_| is_asked) {
        let names: Vec<&str> = set.methods.iter().map(String::as_str).collect();
        if set.chain == chain && answer.tried.iter().any(|tried| names.contains(tried)) {
            by_sets.push((number, again(&names)));
        }
    }
    let problem = keeps.then(problem);
    let mut table = TABLE.lock().unwrap_or_else(PoisonError::into_inner);
    let keep = table.keep;
    let counted = table.kinds.entry(kind).or_default();
    if is_asked {
        counted.compare(answer, &others, enough);
        for (set, other) in by_sets {
            counted.compare_set(set, answer, other.as_ref(), enough);
        }
    }
    if let Some(problem) = problem {
        let facts = vec![
            ("status", answer.status.name().to_owned()),
            ("residual", format!("{:?}", answer.residual)),
            ("cost", answer.cost.to_string()),
            ("scene", scene),
        ];
        counted.keep(keep, Kept { residual: answer.residual, facts, problem });
    }
}

/// Notes a solve of a method that has no other after it, and whose problem is not kept.
#[track_caller]
pub(crate) fn note_single(chain: Chain, size: Size, method: &'static str, status: SolverStatus, residual: f64) {
    let answer = Answer { method, tried: vec![method], status, residual, cost: 1, motion: Vec::new() };
    let caller = Location::caller();
    let (file, line) = (caller.file(), caller.line());
    let kind = Kind { file, line, chain, method, tried: answer.tried.clone() };
    let scene = SCENE.with_borrow(Clone::clone);
    let mut table = TABLE.lock().unwrap_or_else(PoisonError::into_inner);
    table.kinds.entry(kind).or_default().add(size, &answer, &scene);
}

impl Counted {
    fn add(&mut self, size: Size, answer: &Answer, scene: &str) {
        self.count += 1;
        self.unsolved += u64::from(answer.status != SolverStatus::Solved);
        *self.residuals.entry(class_of(answer.residual)).or_default() += 1;
        if self.count == 1 || answer.residual > self.worst || answer.residual.is_nan() {
            self.worst = answer.residual;
            scene.clone_into(&mut self.worst_in);
        }
        self.cost += answer.cost as u64;
        let most = &mut self.most;
        *most = Size {
            bodies: most.bodies.max(size.bodies),
            rows: most.rows.max(size.rows),
            cones: most.cones.max(size.cones),
        };
        if !self.scenes.contains(scene) {
            self.scenes.insert(scene.to_owned());
        }
    }

    fn compare(&mut self, answer: &Answer, others: &[Answer], enough: f64) {
        let is_solved = answer.status == SolverStatus::Solved;
        self.asked += 1;
        self.asked_solved += u64::from(is_solved);
        self.asked_cost += answer.cost as u64;
        let is_accepted = |other: &Answer| other.status == SolverStatus::Solved;
        let is_as_good = |other: &Answer| is_accepted(other) && other.residual <= answer.residual.max(enough);
        self.others_accepted += u64::from(is_solved && others.iter().any(is_accepted));
        self.others_as_good += u64::from(is_solved && others.iter().any(is_as_good));
        for (level, found) in (1..).zip(others) {
            let other = self.next.entry((level, found.method)).or_default();
            other.count += 1;
            other.cost += found.cost as u64;
            other.as_good += u64::from(is_as_good(found));
            if is_accepted(found) {
                other.accepted += 1;
                other.worst = other.worst.max(found.residual);
                other.moved += u64::from(apart(&answer.motion, &found.motion) > OTHER_MOTION);
            }
        }
    }

    fn compare_set(&mut self, set: usize, answer: &Answer, other: Option<&Answer>, enough: f64) {
        let own = self.without.entry(set).or_default();
        let was_solved = answer.status == SolverStatus::Solved;
        let is_solved = other.is_some_and(|other| other.status == SolverStatus::Solved);
        let is_as_good = other.is_some_and(|other| other.residual <= answer.residual.max(enough));
        own.count += 1;
        own.solved_before += u64::from(was_solved);
        own.still_solved += u64::from(was_solved && is_solved);
        own.as_good += u64::from(was_solved && is_solved && is_as_good);
        own.newly_solved += u64::from(!was_solved && is_solved);
        own.cost[0] += answer.cost as u64;
        own.cost[1] += other.map_or(0, |other| other.cost) as u64;
    }

    fn would_keep(&self, keep: usize, residual: f64) -> bool {
        self.kept.len() < keep || self.least_kept(keep).is_some_and(|place| residual > self.kept[place].residual)
    }

    /// Of those that are kept for their residuals, the one with the least.
    fn least_kept(&self, keep: usize) -> Option<usize> {
        let by_residual = |a: &usize, b: &usize| self.kept[*a].residual.total_cmp(&self.kept[*b].residual);
        (keep.div_ceil(2)..self.kept.len()).min_by(by_residual)
    }

    fn keep(&mut self, keep: usize, kept: Kept) {
        if self.kept.len() < keep {
            self.kept.push(kept);
        } else if let Some(place) = self.least_kept(keep) {
            self.kept[place] = kept;
        }
    }
}

/// The largest difference, relative to the largest velocity.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    let largest = |of: &mut dyn Iterator<Item = f64>| of.fold(0.0, |most: f64, value| most.max(value.abs()));
    let size = largest(&mut a.iter().copied()).max(largest(&mut b.iter().copied()));
    let difference = largest(&mut a.iter().zip(b).map(|(a, b)| a - b));
    if difference == 0.0 { 0.0 } else { difference / size }
}

#[cfg(test)]
mod tests {
    //! Solves are counted under who asked, with what the next methods gave.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use crate::{ContactProblem, SolverSettings, WarmStart, solve_complementarity};

    #[test]
    fn a_solve_is_counted_under_the_line_that_asked_with_what_the_next_methods_give() {
        let mut problem = ContactProblem::new(3, vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 3.0]).unwrap();
        for x in [-1.0, 0.0, 1.0] {
            problem.push_row(&[(0, &[0.0, 1.0, x])]).unwrap();
        }
        let (delassus, settings) = (problem.delassus(), SolverSettings::default());
        set_scene("a beam on pillars");
        keep_problems(1);
        let start = WarmStart::new(vec![0, 2]);
        let line = line!() + 1;
        let solution = solve_complementarity(&problem, &delassus, &[-9.81; 3], Some(&start), &settings).unwrap();
        let table = take();
        let (kind, counted) = table.kinds.iter().find(|(kind, _)| kind.file == file!() && kind.line == line).unwrap();
        assert_eq!((kind.chain, kind.method), (Chain::ActiveSet, "warm-start"));
        assert_eq!(solution.report.tried.to_string(), "warm-start");
        assert_eq!((counted.count, counted.unsolved, counted.asked, counted.others_as_good), (1, 0, 1, 1));
        assert_eq!(counted.next.first_key_value().unwrap().0, &(1, "active-set"));
        assert_eq!(counted.scenes, BTreeSet::from(["a beam on pillars".to_owned()]));
        assert_eq!(counted.kept[0].problem.blocks.len(), 3);
    }

    #[test]
    fn the_class_of_a_residual_is_the_least_quarter_of_a_decade_above_it() {
        for residual in [1e-16, 3e-9, 0.5, 7.0] {
            let class = class_of(residual);
            assert!(residual_of(class) >= residual * (1.0 - 1e-12) && residual_of(class - 1) < residual);
        }
        assert_eq!(residual_of(class_of(0.0)), 0.0);
    }
}

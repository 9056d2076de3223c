//! A thousand problems that runs of scenes met (fixtures/problems), each solved by the one entry and judged by the laws
//! of its blocks, as [`law_left`](crate::law_left) writes them down on its own.
//!
//! Each problem has its facts in its file: its name, what it is of (heap, loops, joints, friction), what was asked and
//! in which scene. `unsolved` is why there is no answer today, `order` what else the order of its blocks changes.

use crate::law_left::{left, size, velocities};
use polhode_response::problem_text::ProblemText;
use polhode_response::{Answer, Ask, Law, Memory, Question, RowProblem, SolverStatus, solve};
use std::collections::BTreeMap;

/// The largest part of a law that an answer may leave (no unit), as in the census.
const ACCEPTED: f64 = 1e-8;

/// The same of velocities where many contacts are solved for in impulses: heavy bodies hide those of light ones.
const ACCEPTED_OF_LIGHT_BODIES: f64 = 1e-5;

/// Motions that differ by more, relative to the largest velocity without reactions, are other motions (no unit).
const OTHER_MOTION: f64 = 1e-6;

/// What masses and forces are multiplied by: a power of two, which rounds nothing.
const HEAVIER: f64 = 1_048_576.0;

/// Most contacts whose forces are sought by the guesses of the thesis: guesses double with each.
const MOST_GUESSED: usize = 10;

/// The problems, a file for each thing that was asked, and how many are in it.
const FILES: [(&str, usize); 7] = [
    (include_str!("../../../../fixtures/problems/displacement.txt"), 78),
    (include_str!("../../../../fixtures/problems/impact.txt"), 209),
    (include_str!("../../../../fixtures/problems/instant.txt"), 149),
    (include_str!("../../../../fixtures/problems/rest.txt"), 125),
    (include_str!("../../../../fixtures/problems/stage.txt"), 29),
    (include_str!("../../../../fixtures/problems/step.txt"), 382),
    (include_str!("../../../../fixtures/problems/thesis.txt"), 1),
];

/// A problem with what is known of it.
pub(crate) struct Kept {
    facts: BTreeMap<String, String>,
    pub(crate) problem: ProblemText,
}

impl Kept {
    pub(crate) fn fact(&self, word: &str) -> &str {
        self.facts.get(word).map_or("", String::as_str)
    }

    pub(crate) fn name(&self) -> &str {
        self.fact("name")
    }

    fn answer(&self) -> Answer {
        self.answer_of(&self.problem)
    }

    /// What the entry says to a problem with the question of this one.
    fn answer_of(&self, problem: &ProblemText) -> Answer {
        let (rows, blocks, constants) = problem.problem().unwrap();
        let known = Question { blocks: Some(&blocks), constants: &constants, ..Question::default() };
        let asked = |ask: Ask<'_>, known| {
            let problem = RowProblem { rows: &rows, joints: 0..0, known };
            solve(&problem, ask, &mut Memory::default()).unwrap()
        };
        match self.fact("asked") {
            "Displacement" => asked(Ask::Displacement { accuracy: ACCEPTED }, known),
            // The impulses with which all that approaches stops are those of a step.
            "Impact" | "Step" => asked(Ask::Step, known),
            "Rest" => {
                // Accelerations of the bodies that give the rows those of the problem.
                let held = asked(Ask::HoldAll, Question { constants: &constants, ..Question::default() });
                let free: Vec<f64> = rows.response(&held.reactions).unwrap().iter().map(|own| -own).collect();
                asked(Ask::Rest { free: &free }, known)
            }
            "Stage" => asked(Ask::Stage, known),
            _ => asked(Ask::Instant, known),
        }
    }

    /// Whether an answer is right, in velocities, or in impulses of contacts between bodies of different masses.
    fn is_right(&self, answer: &Answer) -> bool {
        let left = left(&self.problem, &answer.reactions);
        self.is_right_in_velocities(answer) || (left.impulses <= ACCEPTED && left.rates <= ACCEPTED_OF_LIGHT_BODIES)
    }

    /// Whether it is right in velocities.
    fn is_right_in_velocities(&self, answer: &Answer) -> bool {
        let friction = self.problem.blocks.iter().filter_map(|block| block.law.friction()).fold(0.0, f64::max);
        // What is left of a slip may turn up in the normal as well, times the coefficient.
        left(&self.problem, &answer.reactions).rates <= ACCEPTED * (1.0 + friction)
    }
}

pub(crate) fn all() -> Vec<Kept> {
    let texts = FILES.iter().flat_map(|(file, _)| file.split("\n\n"));
    let kept = texts.map(|text| {
        let (problem, facts) = ProblemText::read(text.trim_start()).unwrap();
        Kept { facts: facts.into_iter().collect(), problem }
    });
    kept.collect()
}

/// Counts words.
fn counted<'a>(words: impl Iterator<Item = &'a str>) -> Vec<(&'a str, usize)> {
    let mut counts = BTreeMap::new();
    words.for_each(|word| *counts.entry(word).or_default() += 1);
    counts.into_iter().collect()
}

#[test]
fn the_set_holds_joints_loops_heaps_and_impacts_with_friction_and_without() {
    for (file, expected) in FILES {
        let first = file.lines().nth(3);
        assert_eq!(file.lines().filter(|line| *line == "polhode-problem 1").count(), expected, "{first:?}");
    }
    let all = all();
    assert_eq!(
        counted(all.iter().flat_map(|kept| kept.fact("kind").split(' '))),
        [("friction", 532), ("frictionless", 441), ("heap", 292), ("joints", 83), ("loops", 98)]
    );
    assert_eq!(all.iter().map(Kept::name).collect::<std::collections::BTreeSet<_>>().len(), all.len(), "names");
}

/// What is said to be solved is right, and all is solved but what is known by name, each with its reason.
#[test]
fn problems_of_runs_are_answered_by_their_laws_or_told() {
    let all = all();
    let mut in_impulses_alone = 0;
    for kept in &all {
        let answer = kept.answer();
        let is_solved = answer.report.status == SolverStatus::Solved;
        let unsolved = kept.fact("unsolved");
        assert_eq!(is_solved, unsolved.is_empty(), "{}: {unsolved}: {:?}", kept.name(), answer.report);
        let left = left(&kept.problem, &answer.reactions);
        assert!(!is_solved || kept.is_right(&answer), "{}: {left:?}, {:?}", kept.name(), answer.report);
        in_impulses_alone += usize::from(is_solved && !kept.is_right_in_velocities(&answer));
    }
    assert_eq!(in_impulses_alone, 3, "answers that are right in impulses, and nearly so in velocities");
    assert_eq!(
        counted(all.iter().map(|kept| kept.fact("unsolved"))),
        [
            ("", 917),
            ("constant terms are rounding, and contradict each other", 11),
            ("no forces satisfy the law (Painleve)", 2),
            ("no method finds reactions with friction", 25),
            ("rows that hold contradict each other", 10),
            ("rows that hold nearly contradict each other", 3),
            ("the answer is right, and not as exact as is asked for", 5)
        ]
    );
}

/// The motion follows from rows and laws, not from the order in which they are told. Where Coulomb's law has several
/// motions, the order may choose among them.
#[test]
fn the_order_of_blocks_changes_no_motion_but_of_problems_known_by_name() {
    let all = all();
    for kept in all.iter().filter(|kept| kept.fact("unsolved").is_empty()) {
        let mut reversed = kept.problem.clone();
        reversed.blocks.reverse();
        let (first, again) = (kept.answer(), kept.answer_of(&reversed));
        let backwards = velocities(&reversed, &again.reactions);
        let (mut expected, mut end) = (Vec::new(), backwards.len());
        for block in &kept.problem.blocks {
            expected.extend_from_slice(&backwards[end - block.rows.len()..end]);
            end -= block.rows.len();
        }
        let own = velocities(&kept.problem, &first.reactions);
        let apart = own.iter().zip(&expected).fold(0.0, |most: f64, (own, other)| most.max((own - other).abs()));
        let is_same = apart <= OTHER_MOTION * size(&kept.problem) && again.report.status == SolverStatus::Solved;
        assert_eq!(is_same, kept.fact("order").is_empty(), "{}: {apart:e}, {:?}", kept.name(), again.report);
    }
    assert_eq!(
        counted(all.iter().map(|kept| kept.fact("order"))),
        [("", 942), ("has several motions", 24), ("is not solved when its blocks are reversed", 7)]
    );
}

/// Bodies that are all a million times as heavy do the same, to the last bit, under as many times the forces.
#[test]
fn masses_and_forces_of_problems_of_runs_may_be_of_any_size() {
    for kept in all() {
        let mut heavier = kept.problem.clone();
        heavier.inverse_masses.iter_mut().flatten().for_each(|mass| *mass /= HEAVIER);
        heavier.blocks.iter_mut().flat_map(|block| &mut block.rows).for_each(|row| row.compliance /= HEAVIER);
        let (light, heavy) = (kept.answer(), kept.answer_of(&heavier));
        assert_eq!(light.report.status, heavy.report.status, "{}", kept.name());
        let scaled: Vec<f64> = light.reactions.iter().map(|own| own * HEAVIER).collect();
        assert_eq!(scaled, heavy.reactions, "{}", kept.name());
    }
}

/// Problems of pushes alone, asked as the thesis solves them: by its linear programmes and by its guesses. What they
/// find bears the contacts.
#[test]
fn pushes_of_runs_are_borne_by_the_forces_of_the_thesis() {
    let mut solved = [0; 2];
    for kept in all() {
        let pushes = kept.problem.blocks.len();
        if pushes > MOST_GUESSED || !kept.problem.blocks.iter().all(|block| block.law == Law::Push) {
            continue;
        }
        let (rows, _, constants) = kept.problem.problem().unwrap();
        for (ask, solved) in [Ask::LeastForce, Ask::Guesses].into_iter().zip(&mut solved) {
            let answer = solve(&RowProblem::new(&rows, &constants), ask, &mut Memory::default()).unwrap();
            if answer.report.status == SolverStatus::Solved {
                *solved += 1;
                assert!(kept.is_right(&answer), "{} {ask:?}: {answer:?}", kept.name());
            }
        }
    }
    assert_eq!(solved, [163, 170]);
}

/// What presses a bearing is given by a soft row, which is read with its compliance.
#[test]
fn what_presses_a_bearing_is_read_with_its_compliance() {
    let text = "polhode-problem 1\nwidth 1\nbody 0.5\nblock cone 2 0.25\nrow -2 0.5 0 0 0\nrow 3 0 0 0 1\n";
    let (rows, blocks, constants) = ProblemText::read(text).unwrap().0.problem().unwrap();
    assert_eq!(rows.compliances(), [(0, 0.5)]);
    let known = Question { blocks: Some(&blocks), constants: &constants, ..Question::default() };
    let asked = RowProblem { rows: &rows, joints: 0..0, known };
    let found = solve(&asked, Ask::Step, &mut Memory::default()).unwrap();
    assert_eq!(found.reactions, [4.0, -1.0]);
}

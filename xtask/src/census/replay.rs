//! Problems of files solved again, by each chain from nothing: whether one chain would do for all. A file may hold
//! several, with an empty line between two.
//!
//! Chains with friction accept the same residual here, though each measures its own: the chain of rows that in units of
//! velocity, the chain of bodies that in units of impulse. Problems whose answer was that there is none count as not
//! solved.

use polhode_response::friction::FrictionSettings;
use polhode_response::problem_text::ProblemText;
use polhode_response::sparse::{BodySettings, BodySolver};
use polhode_response::{Blocks, ContactProblem, SolverReport, SolverSettings, SolverStatus, solve_complementarity};
use std::collections::BTreeMap;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// In a second.
const MICROSECONDS: f64 = 1e6;

/// Chains, as they stand in the table.
const CHAINS: [&str; 3] = ["active set", "friction", "bodies"];

/// The residual that chains with friction accept (no unit): that of heaps.
const ACCEPTED: f64 = 1e-8;

/// What a chain has done.
#[derive(Debug, Clone, Copy, Default)]
struct Done {
    taken: u32,
    solved: u32,
    worst: f64,
    microseconds: f64,
}

impl Done {
    /// Whether it has solved the problem.
    fn add(&mut self, report: Option<SolverReport>, seconds: f64) -> bool {
        let Some(report) = report else { return false };
        self.taken += 1;
        self.microseconds += MICROSECONDS * seconds;
        if report.status == SolverStatus::Solved {
            self.solved += 1;
            self.worst = self.worst.max(report.residual);
        }
        report.status == SolverStatus::Solved
    }
}

/// Problems of one kind.
#[derive(Debug, Clone, Copy, Default)]
struct Line {
    count: u32,
    chains: [Done; CHAINS.len()],
    by_friction_alone: u32,
    by_bodies_alone: u32,
    by_none: u32,
}

impl Line {
    /// Solves a problem by each chain.
    fn add(&mut self, problem: &ProblemText) -> Result<(), Box<dyn Error>> {
        self.count += 1;
        let (rows, blocks, constants) = problem.problem()?;
        let mut is_solved = [false; CHAINS.len()];
        for (place, done) in self.chains.iter_mut().enumerate() {
            let start = Instant::now();
            let report = solved(CHAINS[place], &rows, &blocks, &constants);
            is_solved[place] = done.add(report, start.elapsed().as_secs_f64());
        }
        let [_, by_friction, by_bodies] = is_solved;
        self.by_friction_alone += u32::from(by_friction && !by_bodies);
        self.by_bodies_alone += u32::from(by_bodies && !by_friction);
        self.by_none += u32::from(is_solved == [false; CHAINS.len()]);
        Ok(())
    }
}

/// Solves all problems of a folder and prints a table.
pub(super) fn run(folder: &Path) -> Result<(), Box<dyn Error>> {
    let mut table: BTreeMap<[String; 2], Line> = BTreeMap::new();
    let mut paths: Vec<_> =
        std::fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<Result<_, std::io::Error>>()?;
    paths.sort();
    let is_text = |path: &PathBuf| path.extension().is_some_and(|extension| extension == "txt");
    for path in paths.into_iter().filter(is_text) {
        let file = std::fs::read_to_string(&path)?;
        for text in file.split("\n\n") {
            let read = ProblemText::read(text.trim_start());
            let (problem, facts) = read.map_err(|error| format!("{}: {error}", path.display()))?;
            let fact = |word: &str| facts.iter().find(|(own, _)| own == word).map(|(_, fact)| fact.clone());
            let of = [fact("asked"), fact("chain").or_else(|| fact("kind"))].map(Option::unwrap_or_default);
            table.entry(of).or_default().add(&problem)?;
        }
    }
    let chains = CHAINS.map(|chain| format!("{chain}: solved of taken, worst, us"));
    println!(
        "| asked for | solved by, or of | problems | {} | friction alone, bodies alone, none |",
        chains.join(" | ")
    );
    println!("|---|---|---|---|---|---|---|");
    for ([ask, chain], line) in table {
        let cells = line.chains.map(|done| {
            let mean = done.microseconds / f64::from(done.taken.max(1));
            format!("{} of {}, {:.1e}, {mean:.0}", done.solved, done.taken, done.worst)
        });
        let Line { count, by_friction_alone, by_bodies_alone, by_none, .. } = line;
        let cells = cells.join(" | ");
        println!("| {ask} | {chain} | {count} | {cells} | {by_friction_alone}, {by_bodies_alone}, {by_none} |");
    }
    Ok(())
}

/// What a chain says; none where it does not take the problem.
fn solved(chain: &str, rows: &ContactProblem, blocks: &Blocks, constants: &[f64]) -> Option<SolverReport> {
    match chain {
        "friction" => {
            let settings = FrictionSettings { acceptance: ACCEPTED, ..FrictionSettings::default() };
            Some(blocks.solve(&rows.delassus(), constants, None, &settings).ok()?.report)
        }
        "bodies" => {
            let mut solver = BodySolver::default();
            let settings = BodySettings { acceptance: ACCEPTED, ..BodySettings::default() };
            let system = (&mut solver, &settings);
            Some(blocks.solve_in_bodies(rows, constants, None, system).ok()?.0.report)
        }
        _ => {
            let is_smooth = blocks.laws().iter().all(|law| !law.pushes() || law.rows() == 1);
            let settings = SolverSettings::default();
            let solve = || solve_complementarity(rows, &rows.delassus(), constants, None, &settings).ok();
            is_smooth.then(solve).flatten().map(|solution| solution.report)
        }
    }
}

//! Steps of a verification: what runs beside what, and how long each takes.
//!
//! Steps that build run one after the other, the cheapest first: the compiler of a chain of crates leaves processors
//! idle, and cargo makes a second build wait. All others run beside them and beside each other, one on each processor.
//! Steps that show how long something takes, or how much memory, run alone when these are done. Rows come in the order
//! of the steps, whichever ends first.

use crate::{findings, known};
use polhode_cases::Company;
use polhode_cases::row::Row;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// Slowest steps that the table names.
const SLOWEST: usize = 10;

/// A step: it gives rows under a name.
pub(crate) struct Step<'a> {
    name: String,
    company: Company,
    rows: Box<dyn Fn() -> Vec<Row> + Sync + Send + 'a>,
}

/// What a step gave, and how long it took, s.
struct Done {
    rows: Vec<Row>,
    seconds: f64,
}

impl<'a> Step<'a> {
    /// A step of this name.
    pub(crate) fn new(
        name: impl Into<String>,
        company: Company,
        rows: impl Fn() -> Vec<Row> + Sync + Send + 'a,
    ) -> Self {
        Self { name: name.into(), company, rows: Box::new(rows) }
    }

    /// Runs it, and says its name, time and number of failures on stderr.
    fn run(&self) -> Done {
        let start = Instant::now();
        let mut rows = (self.rows)();
        findings::state(&mut rows);
        known::mark(&mut rows);
        let seconds = start.elapsed().as_secs_f64();
        let failures = rows.iter().filter(|row| row.verdict.fails_the_run()).count();
        let failed = if failures == 0 { String::new() } else { format!(", {failures} of {} rows fail", rows.len()) };
        eprintln!("{} ... {seconds:.1} s{failed}", self.name);
        Done { rows, seconds }
    }
}

/// Runs all steps; gives their rows, and those that say which steps took longest.
pub(crate) fn run(steps: &[Step<'_>]) -> Vec<Row> {
    let done: Vec<Mutex<Option<Done>>> = steps.iter().map(|_| Mutex::new(None)).collect();
    let finish = |number: usize| {
        let result = steps[number].run();
        if let Ok(mut place) = done[number].lock() {
            *place = Some(result);
        }
    };
    let of = |company: Company| -> Vec<usize> {
        (0..steps.len()).filter(|&number| steps[number].company == company).collect()
    };
    let (builds, beside) = (of(Company::Build), of(Company::Beside));
    let next = AtomicUsize::new(0);
    let finish_beside = || {
        while let Some(&number) = beside.get(next.fetch_add(1, Ordering::Relaxed)) {
            finish(number);
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(finish_beside);
        }
        for &number in &builds {
            finish(number);
        }
        finish_beside();
    });
    for number in of(Company::Alone) {
        finish(number);
    }
    let (mut rows, mut times) = (Vec::new(), Vec::new());
    for (step, done) in steps.iter().zip(done) {
        match done.into_inner().ok().flatten() {
            Some(done) => {
                times.push((done.seconds, step.name.as_str()));
                rows.extend(done.rows);
            }
            None => rows.push(Row::broken(&step.name, "runs", "it broke off: a bug, whatever the input was")),
        }
    }
    rows.extend(slowest(times));
    rows
}

/// The steps that took longest, for information.
fn slowest(mut times: Vec<(f64, &str)>) -> impl Iterator<Item = Row> {
    times.sort_by(|a, b| b.0.total_cmp(&a.0));
    times
        .into_iter()
        .take(SLOWEST)
        .map(|(seconds, name)| Row::info("slowest", name, "", (10.0 * seconds).round() / 10.0))
}

#[cfg(test)]
mod tests {
    //! Rows stand in the order of their steps, whatever runs beside what, and the slowest are named. No build runs
    //! beside another, and nothing beside what runs alone.
    use super::*;
    use std::time::Duration;

    #[test]
    fn rows_stand_in_the_order_of_their_steps() {
        let step = |name: &'static str, company, milliseconds| {
            Step::new(name, company, move || {
                std::thread::sleep(Duration::from_millis(milliseconds));
                vec![Row::exact(name, "runs", true, true)]
            })
        };
        let steps = [
            step("a", Company::Beside, 30),
            step("b", Company::Alone, 0),
            step("c", Company::Beside, 0),
            step("d", Company::Build, 0),
        ];
        let rows = run(&steps);
        let cases: Vec<&str> = rows.iter().map(|row| row.case.as_str()).collect();
        assert_eq!(&cases[..4], ["a", "b", "c", "d"]);
        assert_eq!((cases[4], rows[4].quantity.as_str()), ("slowest", "a"));
    }

    #[test]
    fn no_build_runs_beside_another_and_nothing_beside_what_runs_alone() {
        let (running, building) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let step = |company| {
            let (running, building) = (&running, &building);
            Step::new("a step", company, move || {
                let others = running.fetch_add(1, Ordering::SeqCst);
                let builds = if company == Company::Build { building.fetch_add(1, Ordering::SeqCst) } else { 0 };
                std::thread::sleep(Duration::from_millis(5));
                let alone = company != Company::Alone || (others == 0 && running.load(Ordering::SeqCst) == 1);
                if company == Company::Build {
                    building.fetch_sub(1, Ordering::SeqCst);
                }
                running.fetch_sub(1, Ordering::SeqCst);
                vec![Row::exact("a step", "keeps to its company", true, builds == 0 && alone)]
            })
        };
        let companies =
            [Company::Alone, Company::Build, Company::Beside, Company::Build, Company::Beside, Company::Alone];
        let steps: Vec<Step<'_>> = companies.into_iter().map(step).collect();
        assert!(run(&steps).iter().all(|row| !row.verdict.fails_the_run()));
    }
}

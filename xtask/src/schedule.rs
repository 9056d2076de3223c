//! Steps of a verification: what runs beside what, and how long each takes.
//!
//! Steps that build or measure time run alone, one after the other; all others run beside each other, one on each processor.
//! Rows come in the order of the steps, whichever ends first.

use crate::known;
use crate::row::Row;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// Slowest steps that the table names.
const SLOWEST: usize = 10;

/// Whether other steps may run at the same time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Company {
    /// It needs the whole machine: it builds with all processors, or shows how long something takes.
    Alone,
    /// Others run beside it.
    Beside,
}

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
        known::mark(&mut rows);
        let seconds = start.elapsed().as_secs_f64();
        let failures = rows.iter().filter(|row| row.verdict.fails_the_run()).count();
        let failed = if failures == 0 { String::new() } else { format!(", {failures} of {} rows fail", rows.len()) };
        eprintln!("{} ... {seconds:.1} s{failed}", self.name);
        Done { rows, seconds }
    }
}

/// Runs all steps; their rows, and those that say which steps took longest.
pub(crate) fn run(steps: &[Step<'_>]) -> Vec<Row> {
    let done: Vec<Mutex<Option<Done>>> = steps.iter().map(|_| Mutex::new(None)).collect();
    let finish = |number: usize| {
        let result = steps[number].run();
        if let Ok(mut place) = done[number].lock() {
            *place = Some(result);
        }
    };
    let of = |company: Company| (0..steps.len()).filter(move |&number| steps[number].company == company);
    for number in of(Company::Alone) {
        finish(number);
    }
    let beside: Vec<usize> = of(Company::Beside).collect();
    let next = AtomicUsize::new(0);
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                while let Some(&number) = beside.get(next.fetch_add(1, Ordering::Relaxed)) {
                    finish(number);
                }
            });
        }
    });
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
    //! Rows stand in the order of their steps, those that run alone or beside each other alike, and the slowest are named.
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
            step("d", Company::Beside, 0),
        ];
        let rows = run(&steps);
        let cases: Vec<&str> = rows.iter().map(|row| row.case.as_str()).collect();
        assert_eq!(&cases[..4], ["a", "b", "c", "d"]);
        assert_eq!((cases[4], rows[4].quantity.as_str()), ("slowest", "a"));
    }
}

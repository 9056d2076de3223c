//! Progress of long work, on stderr: a bar on a terminal, elsewhere a line every ten seconds.
//!
//! The work only leaves behind where it is. A thread of its own reads that and tells it, so that a step that takes minutes
//! is not silent either. What is printed on stdout never depends on it.

use crate::failure;
use crate::verbosity::{self, Verbosity};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::fmt::Write as _;
use std::io::IsTerminal;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Between two lines where stderr is no terminal.
const BETWEEN_LINES: Duration = Duration::from_secs(10);

/// Between two drawings of the bar.
const BETWEEN_DRAWINGS: Duration = Duration::from_millis(200);

/// Between two looks at the energies of a run, which cost a report.
const BETWEEN_LOOKS: Duration = Duration::from_secs(2);

/// Parts that the bar divides a duration into.
const PARTS: f64 = 1000.0;

/// What is being done.
#[derive(Debug, Clone, Copy)]
enum Work {
    /// Something that is not counted.
    Named(&'static str),
    /// A run between two times, s.
    Run { from_s: f64, to_s: f64, energy_error: Option<f64> },
    /// A number of parts.
    Parts { what: &'static str, count: usize },
}

/// Where the work is: read by the thread that tells it.
#[derive(Debug)]
struct Shared {
    /// The work and when it began; nothing when all is done.
    work: Mutex<Option<(Work, Instant)>>,
    ended: Condvar,
    /// Bits of the time reached (s), or the number of parts done.
    reached: AtomicU64,
    /// Whether the energies should be looked at.
    wants_look: AtomicBool,
}

/// Progress of what a command does.
#[derive(Debug)]
pub(crate) struct Progress {
    shared: Arc<Shared>,
    bar: Option<ProgressBar>,
    teller: Option<JoinHandle<()>>,
}

impl Progress {
    /// Of work that has just begun.
    pub(crate) fn new(what: &'static str) -> Self {
        let shared = Arc::new(Shared {
            work: Mutex::new(Some((Work::Named(what), Instant::now()))),
            ended: Condvar::new(),
            reached: AtomicU64::new(0),
            wants_look: AtomicBool::new(false),
        });
        if verbosity::asked() == Verbosity::Quiet {
            return Self { shared, bar: None, teller: None };
        }
        let bar = std::io::stderr().is_terminal().then(new_bar);
        let (own, drawn) = (Arc::clone(&shared), bar.clone());
        let teller = std::thread::Builder::new().spawn(move || own.tell(drawn.as_ref())).ok();
        Self { shared, bar, teller }
    }

    /// Goes over to a run between two times, s.
    pub(crate) fn run(&self, from_s: f64, to_s: f64) {
        self.advance(from_s);
        self.begin(Work::Run { from_s, to_s, energy_error: None });
    }

    /// Goes over to work of `count` parts, which may turn out to be fewer.
    pub(crate) fn phase(&self, what: &'static str, count: usize) {
        self.shared.reached.store(0, Ordering::Relaxed);
        self.begin(Work::Parts { what, count });
    }

    fn begin(&self, work: Work) {
        *self.shared.work() = Some((work, Instant::now()));
    }

    /// The time reached, s.
    pub(crate) fn advance(&self, t_s: f64) {
        self.shared.reached.store(t_s.to_bits(), Ordering::Relaxed);
    }

    /// One part is done.
    pub(crate) fn part_done(&self) {
        self.shared.reached.fetch_add(1, Ordering::Relaxed);
    }

    /// Whether it is time to look at the energies of the run.
    pub(crate) fn wants_look(&self) -> bool {
        self.shared.wants_look.load(Ordering::Relaxed)
    }

    /// What integration has lost or made of the energy so far, of the largest energy.
    pub(crate) fn look(&self, error: f64) {
        self.shared.wants_look.store(false, Ordering::Relaxed);
        if let Some((Work::Run { energy_error, .. }, _)) = &mut *self.shared.work() {
            *energy_error = Some(error);
        }
    }

    /// Writes a note to stderr, above the bar.
    pub(crate) fn note(&self, message: &str) {
        match &self.bar {
            Some(bar) => bar.suspend(|| failure::note(message)),
            None => failure::note(message),
        }
    }

    /// All is done.
    pub(crate) fn clear(&mut self) {
        *self.shared.work() = None;
        self.shared.ended.notify_all();
        if let Some(teller) = self.teller.take() {
            let _ = teller.join();
        }
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.clear();
    }
}

impl Shared {
    fn work(&self) -> MutexGuard<'_, Option<(Work, Instant)>> {
        self.work.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Tells where the work is until it is done.
    fn tell(&self, bar: Option<&ProgressBar>) {
        let pause = if bar.is_some() { BETWEEN_DRAWINGS } else { BETWEEN_LOOKS };
        let (mut looked, mut told) = (Instant::now(), Instant::now());
        let mut work = self.work();
        while let Some((present, since)) = *work {
            if looked.elapsed() >= BETWEEN_LOOKS {
                self.wants_look.store(true, Ordering::Relaxed);
                looked = Instant::now();
            }
            let reached = self.reached.load(Ordering::Relaxed);
            if let Some(bar) = bar {
                bar.set_position((PARTS * present.fraction(reached)) as u64);
                bar.set_message(present.line(reached, since.elapsed()));
            } else if told.elapsed() >= BETWEEN_LINES {
                failure::note(&format!("progress: {}", present.line(reached, since.elapsed())));
                told = Instant::now();
            }
            work = self.ended.wait_timeout(work, pause).unwrap_or_else(PoisonError::into_inner).0;
        }
    }
}

impl Work {
    /// How much of it is done, from 0 to 1.
    fn fraction(&self, reached: u64) -> f64 {
        match *self {
            Self::Named(_) => 0.0,
            Self::Run { from_s, to_s, .. } => (f64::from_bits(reached) - from_s) / (to_s - from_s),
            Self::Parts { count, .. } => reached as f64 / count.max(1) as f64,
        }
    }

    /// Where it is, in a line.
    fn line(&self, reached: u64, elapsed: Duration) -> String {
        let wall_s = elapsed.as_secs_f64();
        match *self {
            Self::Named(what) => format!("{what}, {}", time(wall_s)),
            Self::Parts { what, count } => format!("{what}: {reached} of {count}, {}", time(wall_s)),
            Self::Run { from_s, to_s, energy_error } => {
                let (t, rate) = (f64::from_bits(reached), (f64::from_bits(reached) - from_s) / wall_s);
                let mut line = format!("t = {t:.6} of {to_s} s after {}", time(wall_s));
                if rate > 0.0 {
                    let _ = write!(line, ", {rate:.3} s/s, about {} left", time((to_s - t) / rate));
                } else {
                    line.push_str(", the first step has not ended yet");
                }
                if let Some(error) = energy_error {
                    let _ = write!(line, ", energy error {error:.1e}");
                }
                line
            }
        }
    }
}

/// A time of waiting in a unit that suits it.
fn time(seconds: f64) -> String {
    const UNITS: [(f64, &str); 4] = [(31_557_600.0, "years"), (86_400.0, "days"), (3600.0, "h"), (60.0, "min")];
    match UNITS.iter().find(|(unit, _)| seconds >= 2.0 * unit) {
        Some((unit, name)) if seconds / unit < 1000.0 => format!("{:.1} {name}", seconds / unit),
        Some((unit, name)) => format!("{:.1e} {name}", seconds / unit),
        None => format!("{seconds:.0} s"),
    }
}

fn new_bar() -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(PARTS as u64), ProgressDrawTarget::stderr());
    match ProgressStyle::with_template("{wide_bar} {msg}") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

#[cfg(test)]
mod tests {
    //! What a line of progress says.
    use super::*;

    #[test]
    fn a_run_says_rate_and_time_left() {
        let work = Work::Run { from_s: 0.0, to_s: 10.0, energy_error: Some(1.5e-12) };
        let line = work.line(2.0_f64.to_bits(), Duration::from_secs(20));
        assert_eq!(line, "t = 2.000000 of 10 s after 20 s, 0.100 s/s, about 80 s left, energy error 1.5e-12");
        let line = work.line(0.0_f64.to_bits(), Duration::from_secs(300));
        assert!(line.contains("after 5.0 min, the first step has not ended yet"), "{line}");
    }

    #[test]
    fn times_have_units() {
        assert_eq!([59.0, 7300.0, 1e6].map(time), ["59 s", "2.0 h", "11.6 days"]);
        assert_eq!(time(1e13), "3.2e5 years");
    }
}

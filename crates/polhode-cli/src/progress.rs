//! Progress of long work, on stderr: a bar on a terminal, elsewhere a line every ten seconds.
//!
//! The work only leaves behind where it is. A thread of its own reads that and tells it, so that a step that takes
//! minutes is not silent either. What is printed on stdout never depends on it.

use crate::text::number;
use crate::verbosity::{self, Verbosity};
use crate::{failure, terminal};
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

/// Shortest and longest bar, columns with its brackets: a shorter one says nothing, a longer one no more.
const BAR: (usize, usize) = (10, 42);

/// Digits of the time reached, counted from the first one of the duration: a slow run still moves.
const DIGITS: usize = 7;

/// Durations outside of these, s, are written as powers of ten.
const PLAIN_S: (f64, f64) = (1e-3, 1e9);

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
    /// Events since the time was reached: an instant with many is crowded.
    events: AtomicU64,
    /// Whether the energies should be looked at.
    wants_look: AtomicBool,
}

/// Progress of what a command does.
#[derive(Debug)]
pub(crate) struct Progress {
    shared: Arc<Shared>,
    teller: Option<JoinHandle<()>>,
}

/// How progress is told.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Telling {
    /// One line that is drawn again, on a terminal.
    Drawn,
    /// A line now and then.
    Lines,
}

impl Progress {
    /// Of work that has just begun.
    pub(crate) fn new(what: &'static str) -> Self {
        Self::told(what, if terminal::width().is_some() { Telling::Drawn } else { Telling::Lines })
    }

    /// Of work that has just begun and prints to a terminal meanwhile, where nothing should be drawn.
    pub(crate) fn in_lines(what: &'static str) -> Self {
        Self::told(what, Telling::Lines)
    }

    fn told(what: &'static str, telling: Telling) -> Self {
        let shared = Arc::new(Shared {
            work: Mutex::new(Some((Work::Named(what), Instant::now()))),
            ended: Condvar::new(),
            reached: AtomicU64::new(0),
            events: AtomicU64::new(0),
            wants_look: AtomicBool::new(false),
        });
        if verbosity::asked() == Verbosity::Quiet {
            return Self { shared, teller: None };
        }
        let own = Arc::clone(&shared);
        let teller = std::thread::Builder::new().spawn(move || own.tell(telling)).ok();
        Self { shared, teller }
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
        let before = self.shared.reached.swap(t_s.to_bits(), Ordering::Relaxed);
        if before != t_s.to_bits() {
            self.shared.events.store(0, Ordering::Relaxed);
        }
    }

    /// An event has been found at the time reached, or behind it.
    pub(crate) fn happened(&self) {
        self.shared.events.fetch_add(1, Ordering::Relaxed);
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

    /// All is done.
    pub(crate) fn clear(&mut self) {
        *self.shared.work() = None;
        self.shared.ended.notify_all();
        if let Some(teller) = self.teller.take() {
            let _ = teller.join();
            terminal::erase();
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
    fn tell(&self, telling: Telling) {
        let pause = if telling == Telling::Drawn { BETWEEN_DRAWINGS } else { BETWEEN_LOOKS };
        let (mut looked, mut told) = (Instant::now(), Instant::now());
        let mut past = Past::default();
        let mut work = self.work();
        while work.is_some() {
            // What is over at once is not told.
            work = self.ended.wait_timeout(work, pause).unwrap_or_else(PoisonError::into_inner).0;
            let Some((present, since)) = *work else { break };
            if looked.elapsed() >= BETWEEN_LOOKS {
                self.wants_look.store(true, Ordering::Relaxed);
                looked = Instant::now();
            }
            let reached = self.reached.load(Ordering::Relaxed);
            let seen = past.seen(since, since.elapsed(), present.done(reached), self.events.load(Ordering::Relaxed));
            let parts = present.parts(reached, since.elapsed(), &seen);
            // The width is asked for every time: a terminal can be resized.
            if telling == Telling::Drawn {
                terminal::draw(&drawn(present.fraction(reached), &parts, terminal::width().unwrap_or_default()));
            } else if told.elapsed() >= BETWEEN_LINES {
                failure::note(&format!("progress: {}", joined(&parts)));
                told = Instant::now();
            }
        }
    }
}

/// A part of what is told: where the least room is, only those of the lowest ranks stay.
#[derive(Debug, Clone)]
struct Part {
    rank: u8,
    text: String,
}

/// All parts in a line.
fn joined<'a>(parts: impl IntoIterator<Item = &'a Part>) -> String {
    parts.into_iter().map(|part| part.text.as_str()).collect::<Vec<_>>().join(", ")
}

/// What is drawn on a terminal of so many columns: a bar, where it is known how much is done, and the parts that fit
/// behind it. The last column stays free, where some terminals would begin another line.
fn drawn(fraction: Option<f64>, parts: &[Part], width: usize) -> String {
    let room = width.saturating_sub(1);
    let shortest = if fraction.is_some() { BAR.0 + 1 } else { 0 };
    let most = parts.iter().map(|part| part.rank).max().unwrap_or_default();
    let up_to = |rank: u8| joined(parts.iter().filter(|part| part.rank <= rank));
    let fits = |text: &String| text.chars().count() + shortest <= room;
    let Some(text) = (0..=most).rev().map(up_to).find(fits) else {
        // No room for a bar.
        return up_to(0).chars().take(room).collect();
    };
    let Some(fraction) = fraction else { return text };
    let inner = (room - text.chars().count() - 1).min(BAR.1) - "[]".len();
    // A quotient that is no number, as of a duration of 0, is a beginning; the cast takes it and what is below as 0.
    let done = ((inner as f64 * fraction) as usize).min(inner);
    format!("[{}{}] {text}", "#".repeat(done), "-".repeat(inner - done))
}

impl Work {
    /// How much of it is done, from 0 to 1, if that is known.
    fn fraction(&self, reached: u64) -> Option<f64> {
        match *self {
            Self::Named(_) => None,
            Self::Run { from_s, to_s, .. } => Some((f64::from_bits(reached) - from_s) / (to_s - from_s)),
            Self::Parts { count, .. } => Some(reached as f64 / count.max(1) as f64),
        }
    }

    /// By how much a run has gone on, s; 0 of other work.
    fn done(&self, reached: u64) -> f64 {
        match *self {
            Self::Run { from_s, .. } => f64::from_bits(reached) - from_s,
            Self::Named(_) | Self::Parts { .. } => 0.0,
        }
    }

    /// Where it is, in the order in which it is told.
    fn parts(&self, reached: u64, elapsed: Duration, seen: &Seen) -> Vec<Part> {
        let wall_s = elapsed.as_secs_f64();
        let part = |rank: u8, text: String| Part { rank, text };
        let after = part(4, format!("after {}", time(wall_s)));
        match *self {
            Self::Named(what) => vec![part(0, what.to_owned()), after],
            Self::Parts { what, count } => vec![part(0, format!("{what}: {reached} of {count}")), after],
            Self::Run { from_s, to_s, energy_error } => {
                let (t, rate) = (f64::from_bits(reached), (f64::from_bits(reached) - from_s) / wall_s);
                let mut parts = vec![part(0, format!("t = {} of {to_s} s", time_reached(t, to_s))), after];
                if let Some(events) = seen.crowd {
                    parts.push(part(1, format!("a crowded instant: {events} events in it so far")));
                }
                if rate > 0.0 {
                    let rate: f64 = format!("{rate:.2e}").parse().unwrap_or(rate);
                    parts.push(part(2, format!("{} s/s", number(rate))));
                    parts.extend(seen.rate().map(|rate| part(1, format!("about {} left", time((to_s - t) / rate)))));
                } else if seen.crowd.is_none() {
                    parts.push(part(1, "the first step has not ended yet".to_owned()));
                }
                let error = |error: f64| if error == 0.0 { "0".to_owned() } else { format!("{error:.1e}") };
                parts.extend(energy_error.map(|found| part(3, format!("energy error {}", error(found)))));
                parts
            }
        }
    }
}

/// Where the work was when it was looked at before.
#[derive(Debug, Default)]
struct Past {
    /// When the work began.
    since: Option<Instant>,
    /// Wall time since then and simulated time since then, s.
    looks: Vec<[f64; 2]>,
}

/// What several looks at a run show.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
struct Seen {
    /// Simulated time for wall time in the two halves of the wall time; none at the first look.
    rates: Option<[f64; 2]>,
    /// Events at the time reached, where it was the same at the look before and there are some.
    crowd: Option<u64>,
}

impl Past {
    /// Of a run that has gone on by a time (s), with so many events at the time reached.
    fn seen(&mut self, since: Instant, elapsed: Duration, done_s: f64, events: u64) -> Seen {
        if self.since != Some(since) {
            *self = Self { since: Some(since), looks: Vec::new() };
        }
        let now = [elapsed.as_secs_f64(), done_s];
        let is_same = self.looks.last().is_some_and(|last| last[1] == done_s);
        let middle = self.looks.iter().rev().find(|look| look[0] <= 0.5 * now[0]);
        let rates = middle.map(|at| [at[1] / at[0], (now[1] - at[1]) / (now[0] - at[0])]);
        self.looks.push(now);
        Seen { rates, crowd: (is_same && events > 0).then_some(events) }
    }
}

impl Seen {
    /// The rate of what is left, if that can be told: that of the latter half, where it is no more than twice or half
    /// of that of the first. A run that has just begun, or that goes over to other work, tells none.
    fn rate(&self) -> Option<f64> {
        self.rates.filter(|[first, latter]| (0.5 * first..=2.0 * first).contains(latter)).map(|[_, latter]| latter)
    }
}

/// A time of a run of this duration, s, in as many digits as it needs to be seen to move.
fn time_reached(t_s: f64, duration_s: f64) -> String {
    if !(PLAIN_S.0..PLAIN_S.1).contains(&duration_s) {
        return format!("{t_s:.prec$e}", prec = DIGITS - 1);
    }
    let whole = (duration_s as u64).to_string().len();
    format!("{t_s:.prec$}", prec = DIGITS.saturating_sub(whole))
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

#[cfg(test)]
mod tests {
    //! What a line of progress says.
    use super::*;

    fn run(reached_s: f64, to_s: f64, after_s: u64) -> (Option<f64>, Vec<Part>) {
        let work = Work::Run { from_s: 0.0, to_s, energy_error: Some(1.5e-12) };
        let reached = reached_s.to_bits();
        let seen = Seen { rates: Some([reached_s / after_s as f64; 2]), crowd: None };
        (work.fraction(reached), work.parts(reached, Duration::from_secs(after_s), &seen))
    }

    #[test]
    fn a_run_says_rate_and_time_left() {
        let (_, parts) = run(2.0, 10.0, 20);
        assert_eq!(joined(&parts), "t = 2.00000 of 10 s, after 20 s, 0.1 s/s, about 80 s left, energy error 1.5e-12");
        let (_, parts) = run(0.0, 10.0, 300);
        assert!(joined(&parts).contains("after 5.0 min, the first step has not ended yet"));
    }

    /// What is drawn always fits, and what matters most stays longest: the time reached, then the time left, then the
    /// rate, then the error, then the time that has passed.
    #[test]
    fn narrow_terminals_get_less() {
        let (fraction, parts) = run(2.0, 10.0, 20);
        let line = |width| drawn(fraction, &parts, width);
        assert_eq!(
            line(120),
            "[#######------------------------------] \
             t = 2.00000 of 10 s, after 20 s, 0.1 s/s, about 80 s left, energy error 1.5e-12"
        );
        assert_eq!(line(80), "[#--------] t = 2.00000 of 10 s, 0.1 s/s, about 80 s left, energy error 1.5e-12");
        assert_eq!(line(60), "[##---------] t = 2.00000 of 10 s, 0.1 s/s, about 80 s left");
        assert_eq!(line(50), "[##--------] t = 2.00000 of 10 s, about 80 s left");
        assert_eq!(line(40), "[###--------------] t = 2.00000 of 10 s");
        assert_eq!(line(20), "t = 2.00000 of 10 s");
        assert_eq!((line(10).as_str(), line(1).as_str(), line(0).as_str()), ("t = 2.000", "", ""));
        for width in 0..300 {
            assert!(line(width).chars().count() <= width.saturating_sub(1), "{}", line(width));
        }
    }

    /// A bar stays a bar at the ends, beyond them, and for what is no number.
    #[test]
    fn bars_at_their_ends() {
        let parts = [Part { rank: 0, text: "x".to_owned() }];
        for (fraction, bar) in [
            (0.0, "[--------] x"),
            (1.0, "[########] x"),
            (1.5, "[########] x"),
            (-1.0, "[--------] x"),
            (f64::NAN, "[--------] x"),
            (f64::INFINITY, "[########] x"),
        ] {
            assert_eq!(drawn(Some(fraction), &parts, 13), bar);
        }
        assert_eq!(drawn(Some(0.5), &[], 13), "[####-----] ");
        assert_eq!(drawn(None, &parts, 80), "x");
    }

    #[test]
    fn a_sweep_says_how_many_are_done() {
        let work = Work::Parts { what: "errors", count: 40 };
        let line = drawn(work.fraction(10), &work.parts(10, Duration::from_secs(30), &Seen::default()), 46);
        assert_eq!(line, "[###-----------] errors: 10 of 40, after 30 s");
    }

    #[test]
    fn times_have_as_many_digits_as_move() {
        assert_eq!(time_reached(2.0, 3600.0), "2.000");
        assert_eq!(time_reached(0.25, 0.5), "0.250000");
        assert_eq!(time_reached(2e-10, 1e-9), "2.000000e-10");
        assert_eq!(time_reached(1e12, 1e15), "1.000000e12");
    }

    /// A run that begins slowly and goes on a hundred times as fast tells no time that is left until both halves agree.
    #[test]
    fn what_begins_slowly_does_not_take_for_ever() {
        let since = Instant::now();
        let mut past = Past::default();
        let mut look = |after_s: u64, done_s: f64| past.seen(since, Duration::from_secs(after_s), done_s, 7);
        assert_eq!(look(2, 0.001).rate(), None);
        assert_eq!(look(4, 0.5).rate(), None, "the latter half is far faster");
        assert_eq!(look(8, 1.5).rate(), Some(0.25));
        assert_eq!(look(9, 1.5).crowd, Some(7), "the same time again");
        assert_eq!(look(10, 1.6).crowd, None);
    }

    #[test]
    fn a_crowded_instant_says_so() {
        let work = Work::Run { from_s: 0.0, to_s: 2.0, energy_error: None };
        let seen = Seen { rates: None, crowd: Some(1234) };
        let line = joined(&work.parts(0.5_f64.to_bits(), Duration::from_secs(10), &seen));
        assert_eq!(line, "t = 0.500000 of 2 s, after 10 s, a crowded instant: 1234 events in it so far, 0.05 s/s");
    }

    #[test]
    fn times_have_units() {
        assert_eq!([59.0, 7300.0, 1e6].map(time), ["59 s", "2.0 h", "11.6 days"]);
        assert_eq!(time(1e13), "3.2e5 years");
    }
}

//! How fast time advances for a body from event to event.
//!
//! Several events may fall on one instant, and some degenerate contacts have two answers that undo each other there at the
//! level of rounding. Events that do not let time advance are counted for each body; after [`STALL_LIMIT`] of them what is
//! still found wrong is tolerated for a time that grows with every try (backoff). Steps also become short for good reasons
//! (an event at which forces jump is approached by some sixty steps, each a part of the one before), but never hundreds
//! of them in a row: where a contact cannot be followed, because its place jumps or because bodies touch where no contact is
//! found, a run would go on for ever. And where bounces accumulate at many contacts of a pile, time does advance, but ever
//! more slowly. Such events crowd: they are not located one by one (`crowding.rs`). The counts travel with the bodies, so
//! that one island's trouble is not another's.

use crate::snapshot::content;

/// An event that lets time advance by less than this fraction of the longest step is one of the same instant.
const INSTANT_RELATIVE: f64 = 1e-9;

/// Events of the same instant after which what is still found wrong is tolerated for a moment.
const STALL_LIMIT: u32 = 16;

/// The first such moment lasts this many times as long as an instant, each further one this many times the one before.
const BACKOFF_FACTOR: f64 = 8.0;

/// Time has advanced when it has by this fraction of the longest step: far above what the approach to one event or its
/// resolution takes, and what a contact whose place jumps lets through in [`MOST_STEPS`] (at most some 1e-6).
const ADVANCE_RELATIVE: f64 = 1e-4;

/// Steps without an advance of time that are too many: many times those that approach an event.
const MOST_STEPS: u64 = 256;

/// Steps over which their mean length is taken: at a contact whose place turns ever faster, as that of a ball that settles in
/// a ring, every step advances, and yet a run would take for ever.
const MEAN_OF_STEPS: u64 = 2048;

/// The same of bodies that have been through a stretch of crowded events.
const MEAN_OF_STEPS_AGAIN: u64 = 256;

/// Mean length of these steps below which they crowd, as a fraction of the longest step: a turn of a contact's place takes
/// some ten of them.
const MEAN_RELATIVE: f64 = 1e-4;

/// Whether a time is too short to be a step, s.
pub(super) fn is_instant(dt: f64, longest_step_s: f64) -> bool {
    dt <= INSTANT_RELATIVE * longest_step_s
}

/// The same of bodies that have been through a stretch of crowded events: what crowds there again need not be found out
/// at length.
const MOST_STEPS_AGAIN: u64 = 128;

/// Events of an island within one longest step that are too many to be located one by one: some ten times those of a pile
/// that is followed with ease.
const MOST_EVENTS: u64 = 256;

/// The same of bodies that have been through a stretch of crowded events.
const MOST_EVENTS_AGAIN: u64 = 32;

/// The pace of one body, or of an island: that of its slowest.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Pace {
    /// When the present step began: at an event or at the end of a step, s.
    pub(super) since: f64,
    /// How many events in a row have not let time advance.
    stalls: u32,
    /// Events since a whole step was made.
    events: u64,
    /// When time last advanced, s.
    advanced_at: f64,
    /// Steps since then.
    steps: u64,
    /// How often something wrong has been tolerated since then.
    backoffs: u32,
    /// Events within the present window of one longest step, and its start, s.
    window_events: u64,
    window_start: f64,
    /// Steps of which the mean length is to be taken, and the start of the first, s.
    mean_steps: u64,
    mean_start: f64,
    /// Whether events have crowded before.
    has_crowded: bool,
}

/// Time no longer advances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct NoAdvance {
    /// Steps made in vain.
    pub(super) steps: u64,
    /// How far they advanced, s.
    pub(super) advanced_s: f64,
}

impl Pace {
    /// At the start of a run or of a body's life, `t` (s).
    pub(super) fn starting_at(t: f64) -> Self {
        Self { since: t, advanced_at: t, window_start: t, mean_start: t, ..Self::default() }
    }

    /// After a time step of a stretch of crowded events that ends at `t` (s).
    pub(super) fn after_stretch(t: f64) -> Self {
        Self { has_crowded: true, ..Self::starting_at(t) }
    }

    /// The pace as plain data.
    pub(super) fn save(&self) -> content::Pace {
        let Self {
            since,
            stalls,
            events,
            advanced_at,
            steps,
            backoffs,
            window_events,
            window_start,
            mean_steps,
            mean_start,
            has_crowded,
        } = *self;
        content::Pace {
            since,
            stalls,
            events,
            advanced_at,
            steps,
            backoffs,
            window_events,
            window_start,
            mean_steps,
            mean_start,
            has_crowded,
        }
    }

    /// The pace of such data.
    pub(super) fn restored(saved: &content::Pace) -> Self {
        let content::Pace {
            since,
            stalls,
            events,
            advanced_at,
            steps,
            backoffs,
            window_events,
            window_start,
            mean_steps,
            mean_start,
            has_crowded,
        } = *saved;
        Self {
            since,
            stalls,
            events,
            advanced_at,
            steps,
            backoffs,
            window_events,
            window_start,
            mean_steps,
            mean_start,
            has_crowded,
        }
    }

    /// Whether the present instant has been resolved so often that what is still found wrong is tolerated until
    /// [`Self::retry_time`].
    pub(super) fn is_backing_off(&self) -> bool {
        self.stalls >= STALL_LIMIT
    }

    /// Whether backing off has begun with the last event.
    pub(super) fn begins_to_back_off(&self) -> bool {
        self.stalls == STALL_LIMIT
    }

    /// Whether an event at `t` comes without time having advanced.
    pub(super) fn is_stall(&self, t: f64, longest_step_s: f64) -> bool {
        is_instant(t - self.since, longest_step_s)
    }

    /// When what is tolerated is looked at again, s: soon, for a contact that does close then penetrates.
    pub(super) fn retry_time(&self, longest_step_s: f64) -> f64 {
        let growth = libm::pow(BACKOFF_FACTOR, f64::from(self.backoffs + 1));
        self.since + longest_step_s * (INSTANT_RELATIVE * growth).min(1.0)
    }

    /// A step ends at `t`, at an event or not.
    ///
    /// # Errors
    /// When too many steps have not advanced time.
    pub(super) fn note_end(&mut self, t: f64, ends: StepEnd, longest_step_s: f64) -> Result<(), NoAdvance> {
        if self.is_backing_off() {
            self.backoffs += 1;
        }
        if !self.is_stall(t, longest_step_s) {
            self.stalls = 0;
        } else if ends != StepEnd::AsPlanned {
            self.stalls += 1;
        }
        self.events = match ends {
            StepEnd::AsPlanned => 0,
            // A body in flight makes no steps of its own: a longest step without an event counts as one.
            _ if t - self.since >= longest_step_s => 1,
            _ => self.events + 1,
        };
        self.since = t;
        if t - self.window_start >= longest_step_s {
            (self.window_start, self.window_events) = (t, 0);
        }
        self.window_events += u64::from(ends == StepEnd::AtEvent);
        let most = if self.has_crowded { MOST_EVENTS_AGAIN } else { MOST_EVENTS };
        if self.window_events > most {
            return Err(NoAdvance { steps: self.window_events, advanced_s: t - self.window_start });
        }
        let advanced_s = t - self.advanced_at;
        if advanced_s >= ADVANCE_RELATIVE * longest_step_s {
            (self.advanced_at, self.steps, self.backoffs) = (t, 0, 0);
            return Ok(());
        }
        self.steps += 1;
        let most = if self.has_crowded { MOST_STEPS_AGAIN } else { MOST_STEPS };
        if self.steps < most { Ok(()) } else { Err(NoAdvance { steps: self.steps, advanced_s }) }
    }

    /// Takes a step with held contacts that ends at `t` into the mean of their lengths.
    ///
    /// # Errors
    /// When they are too short on the mean.
    pub(super) fn note_mean_step(&mut self, t: f64, longest_step_s: f64) -> Result<(), NoAdvance> {
        self.mean_steps += 1;
        let (steps, advanced_s) = (self.mean_steps, t - self.mean_start);
        if steps < if self.has_crowded { MEAN_OF_STEPS_AGAIN } else { MEAN_OF_STEPS } {
            return Ok(());
        }
        (self.mean_steps, self.mean_start) = (0, t);
        if advanced_s < MEAN_RELATIVE * longest_step_s * steps as f64 {
            return Err(NoAdvance { steps, advanced_s });
        }
        Ok(())
    }

    /// Events since a whole step was made.
    pub(super) fn events(&self) -> u64 {
        self.events
    }

    /// The slower of two paces, for bodies that go on together from the same instant.
    pub(super) fn slower(self, other: Self) -> Self {
        let slowest = if other.steps > self.steps { other } else { self };
        Self {
            since: self.since.max(other.since),
            stalls: self.stalls.max(other.stalls),
            events: self.events.max(other.events),
            backoffs: self.backoffs.max(other.backoffs),
            window_events: self.window_events.max(other.window_events),
            window_start: self.window_start.max(other.window_start),
            mean_steps: self.mean_steps.max(other.mean_steps),
            mean_start: self.mean_start.max(other.mean_start),
            has_crowded: self.has_crowded || other.has_crowded,
            ..slowest
        }
    }
}

/// How a step ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum StepEnd {
    /// At an event.
    AtEvent,
    /// At an impact that loses nothing: such impacts do not accumulate, however many there are.
    AtElasticImpact,
    /// Where it was meant to.
    AsPlanned,
}

//! How fast time advances for a body from event to event.
//!
//! Several events may fall on one instant, and some degenerate contacts have two answers that undo each other there at the
//! level of rounding. Events that do not let time advance are counted for each body; after [`STALL_LIMIT`] of them what is
//! still found wrong is tolerated for a time that grows with every try (backoff). Steps also become short for good reasons
//! (an event at which forces jump is approached by some sixty steps, each a part of the one before), but never thousands
//! of them in a row: where a contact cannot be followed, because its place jumps or because bodies touch where no contact is
//! found, a run would go on for ever. The counts travel with the bodies, so that one island's trouble is not another's.

use crate::snapshot::content;

/// An event that lets time advance by less than this fraction of the longest step is one of the same instant.
const INSTANT_RELATIVE: f64 = 1e-9;

/// Events of the same instant after which what is still found wrong is tolerated for a moment.
const STALL_LIMIT: u32 = 16;

/// The first such moment lasts this many times as long as an instant, each further one this many times the one before.
const BACKOFF_FACTOR: f64 = 8.0;

/// Time has advanced when it has by this fraction of the longest step: far above what the approach to one event or its
/// resolution takes, and what a contact whose place jumps lets through in [`MOST_STEPS`] (some 1e-6).
const ADVANCE_RELATIVE: f64 = 1e-4;

/// Steps without an advance of time that are too many: many times those that approach an event.
const MOST_STEPS: u64 = 1024;

/// Whether a time is too short to be a step, s.
pub(super) fn is_instant(dt: f64, longest_step_s: f64) -> bool {
    dt <= INSTANT_RELATIVE * longest_step_s
}

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
        Self { since: t, advanced_at: t, ..Self::default() }
    }

    /// The pace as plain data.
    pub(super) fn save(&self) -> content::Pace {
        let Self { since, stalls, events, advanced_at, steps, backoffs } = *self;
        content::Pace { since, stalls, events, advanced_at, steps, backoffs }
    }

    /// The pace of such data.
    pub(super) fn restored(saved: &content::Pace) -> Self {
        let content::Pace { since, stalls, events, advanced_at, steps, backoffs } = *saved;
        Self { since, stalls, events, advanced_at, steps, backoffs }
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
        } else if ends == StepEnd::AtEvent {
            self.stalls += 1;
        }
        self.events = match ends {
            StepEnd::AsPlanned => 0,
            // A body in flight makes no steps of its own: a longest step without an event counts as one.
            StepEnd::AtEvent if t - self.since >= longest_step_s => 1,
            StepEnd::AtEvent => self.events + 1,
        };
        self.since = t;
        let advanced_s = t - self.advanced_at;
        if advanced_s >= ADVANCE_RELATIVE * longest_step_s {
            (self.advanced_at, self.steps, self.backoffs) = (t, 0, 0);
            return Ok(());
        }
        self.steps += 1;
        if self.steps < MOST_STEPS { Ok(()) } else { Err(NoAdvance { steps: self.steps, advanced_s }) }
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
            ..slowest
        }
    }
}

/// How a step ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum StepEnd {
    /// At an event.
    AtEvent,
    /// Where it was meant to.
    AsPlanned,
}

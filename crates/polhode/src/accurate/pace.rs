//! Progress of time from event to event, for each body; detection of stalls and crowded events.
//!
//! Stalls: several events may occur at one instant, and at a degenerate contact, rounding may make the same contact
//! change repeat for ever. Events without an advance of time are counted for each body. After [`STALL_LIMIT`] of them
//! the body backs off: remaining violations of contact conditions are tolerated for a time that grows with every retry.
//! Among bodies with friction, whose law such violations would break, the events count as crowded instead.
//!
//! Crowded events: events follow each other so closely that time advances too slowly, similar to Zeno behaviour. Steps
//! may become short for a good reason (some sixty shrinking steps approach an event at which forces jump), but not
//! hundreds in a row. That happens where a contact cannot be followed, because its point jumps or because bodies touch
//! where no contact is found. Where bounces accumulate at many contacts of a pile, time advances ever more slowly.
//! Crowded events are not located one by one (`crowding.rs`). The counts belong to the bodies, so that islands do not
//! influence each other.

pub(super) use crate::snapshot::content::Pace;

/// An event after less than this fraction of the longest step belongs to the same instant.
const INSTANT_RELATIVE: f64 = 1e-9;

/// Events of the same instant after which remaining violations are tolerated (backoff).
const STALL_LIMIT: u32 = 16;

/// The first backoff lasts this many instants, each further one this many times as long as the one before.
const BACKOFF_FACTOR: f64 = 8.0;

/// Time has advanced if it grew by this fraction of the longest step. That is far above the approach to one event, and
/// above the advance in [`MOST_STEPS`] at a contact whose point jumps (at most some 1e-6).
const ADVANCE_RELATIVE: f64 = 1e-4;

/// Most steps without an advance of time: several times as many as approach an event.
const MOST_STEPS: u64 = 256;

/// [`MOST_STEPS`] where a contact slides. A slip that stays slow, because the forces hardly exceed friction, makes the
/// equations stiff: friction turns it at the rate `mu g / |u_T|`, which every step must follow. A slip that stops takes
/// some ten steps.
const MOST_SLIDING_STEPS: u64 = 16;

/// Number of steps for the mean step length. At a contact whose point moves around ever faster, as when a ball settles
/// in a ring, every step advances, but the run would never end.
const MEAN_OF_STEPS: u64 = 2048;

/// [`MEAN_OF_STEPS`] for bodies that have passed a stretch of crowded events.
const MEAN_OF_STEPS_AGAIN: u64 = 256;

/// Mean step length below which events count as crowded, as a fraction of the longest step. One revolution of a contact
/// point takes some ten steps.
const MEAN_RELATIVE: f64 = 1e-4;

/// [`MEAN_OF_STEPS`] where a contact slides, see [`MOST_SLIDING_STEPS`].
const MEAN_OF_SLIDING_STEPS: u64 = 32;

/// [`MEAN_OF_SLIDING_STEPS`] for bodies that have passed a stretch of crowded events.
const MEAN_OF_SLIDING_STEPS_AGAIN: u64 = 16;

/// Mean length of steps with contacts that slide below which time steps follow, as a fraction of the longest step. A
/// slip that stops takes some ten steps, of which the first are long.
const MEAN_SLIDING_RELATIVE: f64 = 1e-3;

/// Most events of an island within one longest step that are located one by one: some ten times those of an ordinary
/// pile.
const MOST_EVENTS: u64 = 256;

/// Whether a time (s) is too short to be a step.
pub(super) fn is_instant(dt: f64, longest_step_s: f64) -> bool {
    dt <= instant(longest_step_s)
}

/// The longest time (s) that is no step.
pub(super) fn instant(longest_step_s: f64) -> f64 {
    INSTANT_RELATIVE * longest_step_s
}

/// Time no longer advances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct NoAdvance {
    /// Number of steps without sufficient advance.
    pub(super) steps: u64,
    /// Advance of time in these steps, s.
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

    /// Time of the last event or end of a step, s.
    pub(super) fn started_at(&self) -> f64 {
        self.since
    }

    /// Whether the present instant has been resolved so often that remaining violations are tolerated until
    /// [`Self::retry_time`].
    pub(super) fn is_backing_off(&self) -> bool {
        self.stalls >= STALL_LIMIT
    }

    /// Whether backing off has begun with the last event.
    pub(super) fn begins_to_back_off(&self) -> bool {
        self.stalls == STALL_LIMIT
    }

    /// That events repeat at one instant, at `t` (s).
    pub(super) fn stalled(&self, t: f64) -> NoAdvance {
        NoAdvance { steps: u64::from(self.stalls), advanced_s: t - self.advanced_at }
    }

    /// Whether an event at `t` belongs to the present instant: time has not advanced.
    pub(super) fn is_stall(&self, t: f64, longest_step_s: f64) -> bool {
        is_instant(t - self.since, longest_step_s)
    }

    /// When tolerated violations are checked again, s: soon, because a contact that really closes penetrates meanwhile.
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
        } else if !ends.is_planned() {
            self.stalls += 1;
        }
        self.events = match ends {
            StepEnd::AsPlanned | StepEnd::AsPlannedSliding => 0,
            // A body in free flight makes no steps: a longest step without an event counts as a whole step.
            _ if t - self.since >= longest_step_s => 1,
            _ => self.events + 1,
        };
        self.since = t;
        if t - self.window_start >= longest_step_s {
            (self.window_start, self.window_events) = (t, 0);
        }
        self.window_events += u64::from(ends == StepEnd::AtEvent);
        let most = if self.has_crowded { MOST_EVENTS / 8 } else { MOST_EVENTS };
        if self.window_events > most {
            return Err(NoAdvance { steps: self.window_events, advanced_s: t - self.window_start });
        }
        let advanced_s = t - self.advanced_at;
        if advanced_s >= ADVANCE_RELATIVE * longest_step_s {
            (self.advanced_at, self.steps, self.backoffs) = (t, 0, 0);
            return Ok(());
        }
        self.steps += 1;
        let most = match (ends, self.has_crowded) {
            (StepEnd::AsPlannedSliding, _) => MOST_SLIDING_STEPS,
            (_, true) => MOST_STEPS / 2,
            (_, false) => MOST_STEPS,
        };
        if self.steps < most { Ok(()) } else { Err(NoAdvance { steps: self.steps, advanced_s }) }
    }

    /// Adds a step with held contacts that ends at `t` to the mean step length.
    ///
    /// # Errors
    /// When the mean step length is too small.
    pub(super) fn note_mean_step(&mut self, t: f64, longest_step_s: f64) -> Result<(), NoAdvance> {
        let count = if self.has_crowded { MEAN_OF_STEPS_AGAIN } else { MEAN_OF_STEPS };
        self.note_mean_of(count, t, MEAN_RELATIVE * longest_step_s)
    }

    /// The same for a step in which a held contact slides.
    ///
    /// # Errors
    /// When the mean step length is too small.
    pub(super) fn note_mean_sliding_step(&mut self, t: f64, longest_step_s: f64) -> Result<(), NoAdvance> {
        let count = if self.has_crowded { MEAN_OF_SLIDING_STEPS_AGAIN } else { MEAN_OF_SLIDING_STEPS };
        self.note_mean_of(count, t, MEAN_SLIDING_RELATIVE * longest_step_s)
    }

    /// Counts a step that ends at `t`. After `count` of them their mean length must be at least `least_s`.
    fn note_mean_of(&mut self, count: u64, t: f64, least_s: f64) -> Result<(), NoAdvance> {
        self.mean_steps += 1;
        let (steps, advanced_s) = (self.mean_steps, t - self.mean_start);
        if steps < count {
            return Ok(());
        }
        (self.mean_steps, self.mean_start) = (0, t);
        if advanced_s < least_s * steps as f64 { Err(NoAdvance { steps, advanced_s }) } else { Ok(()) }
    }

    /// Events since a whole step was made.
    pub(super) fn events(&self) -> u64 {
        self.events
    }

    /// The slower of two paces, for bodies that continue in one island from the same instant.
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
    /// At an impact without loss of energy, after a bounce that can be seen: such impacts do not accumulate.
    AtElasticImpact,
    /// At its planned end.
    AsPlanned,
    /// At its planned end, with a contact that slides.
    AsPlannedSliding,
}

impl StepEnd {
    /// Whether no event ended the step.
    const fn is_planned(self) -> bool {
        matches!(self, Self::AsPlanned | Self::AsPlannedSliding)
    }
}

//! When events happened, by kind, in bounded memory.

use super::ink::Ink;
use super::time_chart::{EventRow, Reach};
use polhode::{Event, EventKind};

/// Events of a kind closer than this, of the duration, are drawn as one.
const RESOLUTION: f64 = 1.0 / 16384.0;

/// Kinds with their names and inks, in the order in which they are drawn.
const KINDS: [(EventKind, &str, Ink); 6] = [
    (EventKind::Impact, "impact", Ink::Vermilion),
    (EventKind::ContactBegin, "contact begins", Ink::Blue),
    (EventKind::ContactEnd, "contact ends", Ink::Purple),
    (EventKind::Detach, "contact opens", Ink::Gold),
    (EventKind::Rest, "comes to rest", Ink::Green),
    (EventKind::Wake, "begins to move", Ink::Teal),
];

/// Events of the kinds.
#[derive(Debug, Clone, Default)]
pub(crate) struct EventTimes {
    apart_s: f64,
    kinds: [Kind; KINDS.len()],
}

#[derive(Debug, Clone, Default)]
struct Kind {
    count: u64,
    times_s: Vec<f64>,
}

impl EventTimes {
    /// Of a run of this duration, s.
    pub(crate) fn new(duration_s: f64) -> Self {
        Self { apart_s: RESOLUTION * duration_s, kinds: Default::default() }
    }

    /// Adds an event.
    pub(crate) fn push(&mut self, event: &Event) {
        let Some(number) = KINDS.iter().position(|(kind, ..)| *kind == event.kind) else { return };
        let Some(kind) = self.kinds.get_mut(number) else { return };
        kind.count += 1;
        if kind.times_s.last().is_none_or(|last| event.t_s - last >= self.apart_s) {
            kind.times_s.push(event.t_s);
        }
    }

    /// The kinds of which there are any.
    pub(crate) fn rows(&self) -> Vec<EventRow> {
        let seen = KINDS.iter().zip(&self.kinds).filter(|(_, kind)| kind.count > 0);
        seen.map(|((of, name, ink), kind)| EventRow {
            label: format!("{name} \u{d7} {}", kind.count),
            ink: *ink,
            // Impacts are where curves jump.
            reach: if *of == EventKind::Impact { Reach::Panels } else { Reach::Row },
            times_s: kind.times_s.clone(),
        })
        .collect()
    }
}

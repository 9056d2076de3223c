//! Events in words, for the time line of a page.

use polhode::spatial::DVec3;
use polhode::{BodyId, Event, EventKind};
use serde::Serialize;

/// Events that a page lists at the most: what comes later is counted.
const MOST_EVENTS: usize = 2000;

/// An event in words.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ListedEvent {
    /// When, s.
    pub t: f64,
    /// Which kind.
    pub kind: &'static str,
    /// Numbers of its bodies.
    pub bodies: Vec<usize>,
    /// What happens.
    pub text: String,
}

/// The events of a run. Those of several contact points of the same bodies at one time are one.
#[derive(Debug, Default)]
pub struct EventList {
    events: Vec<ListedEvent>,
    further: u64,
}

impl EventList {
    /// Adds an event of these bodies.
    pub fn add(&mut self, event: &Event, name: impl Fn(BodyId) -> String) {
        let bodies: Vec<usize> = std::iter::once(event.body_a).chain(event.body_b).map(BodyId::index).collect();
        let kind = event.kind.word();
        let same_time = self.events.iter().rev().take_while(|listed| listed.t == event.t_s);
        if same_time.into_iter().any(|listed| listed.kind == kind && listed.bodies == bodies) {
            return;
        }
        if self.events.len() >= MOST_EVENTS {
            self.further += 1;
            return;
        }
        let a = name(event.body_a);
        let b = event.body_b.map_or_else(|| "something".to_owned(), name);
        let text = match event.kind {
            EventKind::Impact => format!("{a} and {b} collide"),
            EventKind::ContactBegin => format!("{a} and {b} begin to touch"),
            EventKind::ContactEnd => format!("{a} and {b} cease to touch"),
            EventKind::Rest => format!("{a} comes to rest"),
            EventKind::Wake => format!("{a} begins to move"),
            // Without a contact it is the end of a track.
            EventKind::Detach if event.normal == DVec3::ZERO => format!("{a} leaves the track"),
            EventKind::Detach => format!("a contact of {a} and {b} opens"),
            EventKind::Stick => format!("a contact of {a} and {b} sticks"),
            EventKind::Slide => format!("a contact of {a} and {b} begins to slide"),
            EventKind::Jam => format!("a contact of {a} and {b} jams"),
            EventKind::Break if event.body_b.is_none() => format!("a joint of {a} breaks"),
            EventKind::Break => format!("a joint of {a} and {b} breaks"),
            other => format!("{a} and {b}: {}", other.word()),
        };
        self.events.push(ListedEvent { t: event.t_s, kind, bodies, text });
    }

    /// All that are listed; the last one says how many are not.
    pub fn into_events(mut self) -> Vec<ListedEvent> {
        if let Some(last) = self.events.last()
            && self.further > 0
        {
            let text = format!("{} further events are not listed", self.further);
            self.events.push(ListedEvent { t: last.t, kind: "further", bodies: Vec::new(), text });
        }
        self.events
    }
}

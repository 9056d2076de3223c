//! Pairs of bodies that may meet, each with the time of its impact.
//!
//! Every body that may collide has a box around its motion: over the present step of its island, or, in flight, up to the
//! next renewal of all flights' boxes, which lies on a grid of time that no event shifts. Pairs whose boxes meet are
//! searched for their impact by conservative advancement on their true motion, which is never late, and the answer is kept
//! until the motion of one of them changes. Pairs held together by a contact are watched by the location of contact
//! changes; of those that are fast, the parts that are clear of each other are searched too: between two looks they could
//! go through each other.

use super::agenda::Due;
use super::engine::{Engine, Mode};
use super::island::Step;
use super::locate::DIP_SAMPLES;
use crate::SimulationError;
use crate::collision::boxes::Boxes;
use crate::core::Core;
use crate::snapshot::{SnapshotError, content};
use polhode_contact::{ImpactSearch, time_of_further_impact, time_of_impact};
use polhode_dynamics::Flight;
use polhode_spatial::{Motion, Still};
use std::collections::BTreeMap;

/// How far bodies that are held together may go between two looks at them, relative to the smaller of their sizes, before
/// their other parts are searched.
const FAST: f64 = 0.01;

/// Bodies with new boxes from which on the broad phase finds the pairs of all at once.
const MANY_NEW_BOXES: usize = 32;

/// What is known of a pair that may meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Watch {
    /// The search covers times up to here, s.
    until: f64,
    /// The first impact found, s; infinite when there is none.
    impact: f64,
}

/// The pairs of bodies that may meet.
#[derive(Debug)]
pub(super) struct NearPairs {
    boxes: Boxes,
    watches: BTreeMap<(usize, usize), Watch>,
    /// Partners of each body, ascending.
    partners: Vec<Vec<usize>>,
    /// When the boxes of flights end, s.
    pub(super) flight_end: f64,
}

impl NearPairs {
    /// No pairs yet, of this many bodies.
    pub(super) fn new(core: &Core, bodies: usize) -> Self {
        let boxes = Boxes::new(&core.settings, bodies);
        Self { boxes, watches: BTreeMap::new(), partners: vec![Vec::new(); bodies], flight_end: f64::NEG_INFINITY }
    }

    /// The pairs as plain data.
    pub(super) fn save(&self) -> content::NearPairs {
        let watch =
            |(&(a, b), &Watch { until, impact }): (&(usize, usize), &Watch)| content::Watch { a, b, until, impact };
        content::NearPairs {
            boxes: self.boxes.save(),
            watches: self.watches.iter().map(watch).collect(),
            partners: self.partners.clone(),
            flight_end: self.flight_end,
        }
    }

    /// The pairs of such data.
    ///
    /// # Errors
    /// When they are of bodies that there are not.
    pub(super) fn restored(core: &Core, saved: &content::NearPairs) -> Result<Self, SnapshotError> {
        let bodies = core.world.bodies.len();
        let is_list = |(body, list): (usize, &Vec<usize>)| {
            list.is_sorted_by(|x, y| x < y) && list.iter().all(|&other| other < bodies && other != body)
        };
        if saved.partners.len() != bodies || !saved.partners.iter().enumerate().all(is_list) {
            return Err(SnapshotError::Invalid("the lists of bodies that may meet are not those of its bodies"));
        }
        let mut watches = BTreeMap::new();
        for &content::Watch { a, b, until, impact } in &saved.watches {
            if a >= b || b >= bodies {
                return Err(SnapshotError::Invalid("a pair that may meet is not one of its bodies"));
            }
            watches.insert((a, b), Watch { until, impact });
        }
        let boxes = Boxes::restored(&core.world, &core.settings, &saved.boxes)?;
        Ok(Self { boxes, watches, partners: saved.partners.clone(), flight_end: saved.flight_end })
    }

    /// The impacts found: when (s) and of whom.
    pub(super) fn impacts(&self) -> impl Iterator<Item = (f64, (usize, usize))> {
        self.watches.iter().map(|(&pair, watch)| (watch.impact, pair))
    }

    /// The bodies that may meet `body`, ascending.
    pub(super) fn partners(&self, body: usize) -> &[usize] {
        &self.partners[body]
    }
}

/// A pair in order.
fn ordered(a: usize, b: usize) -> (usize, usize) {
    (a.min(b), a.max(b))
}

/// Motion of a body until its step ends.
pub(super) enum BodyMotion<'a> {
    /// In flight.
    Flight(&'a Flight),
    /// Over a step of its island.
    Within(&'a dyn Motion),
    /// At rest.
    Still(Still),
}

impl BodyMotion<'_> {
    pub(super) fn get(&self) -> &dyn Motion {
        match self {
            Self::Flight(flight) => *flight,
            Self::Within(motion) => *motion,
            Self::Still(still) => still,
        }
    }
}

impl Engine {
    /// Motion of a body.
    pub(super) fn motion(&self, body: usize) -> BodyMotion<'_> {
        let still = || BodyMotion::Still(Still(self.states[body].pose));
        match &self.tracks[body].mode {
            Mode::Fixed | Mode::Rest => still(),
            Mode::Flight(flight) => BodyMotion::Flight(flight),
            Mode::Constrained | Mode::Stepped => match self.island_of(body).map(|island| &island.step) {
                Some(Step::Constrained(step)) => {
                    step.motion(body).map_or_else(still, |motion| BodyMotion::Within(motion))
                }
                Some(Step::Free(step)) => {
                    step.body_motion(body).map_or_else(still, |motion| BodyMotion::Within(motion))
                }
                Some(Step::Waiting(_)) | None => still(),
            },
        }
    }

    /// When the motion of a body that is known now ends, s.
    fn known_until(&self, body: usize) -> f64 {
        match &self.tracks[body].mode {
            Mode::Fixed | Mode::Rest => f64::INFINITY,
            Mode::Flight(_) => self.near.flight_end,
            Mode::Constrained | Mode::Stepped => self.island_of(body).map_or(f64::INFINITY, |island| island.due),
        }
    }

    /// The first time on the grid of the flights' boxes after `t`, s.
    fn next_flight_end(core: &Core, t: f64) -> f64 {
        let step = core.settings.step_s;
        let next = ((t / step).floor() + 1.0) * step;
        // The quotient may round to the cell below.
        if next > t { next } else { next + step }
    }

    /// Sees to it that the boxes of flights that begin at `t` have an end.
    pub(super) fn begin_flight_boxes(&mut self, core: &Core, t: f64) {
        if self.near.flight_end <= t && core.world.may_collide_at_all() {
            self.near.flight_end = Self::next_flight_end(core, t);
            self.agenda.add(self.near.flight_end, Due::FlightBoxes);
        }
    }

    /// Renews the boxes of all bodies in flight at `t`, the end of the ones before, and what follows from them.
    ///
    /// # Errors
    /// When a search does not end.
    pub(super) fn renew_flight_boxes(&mut self, core: &mut Core, t: f64) -> Result<(), SimulationError> {
        let flies = |engine: &Self, body: usize| matches!(engine.tracks[body].mode, Mode::Flight(_));
        let collides = |body: usize| core.world.bodies[body].shape.is_some();
        let flying: Vec<usize> = (0..self.tracks.len()).filter(|&body| collides(body) && flies(self, body)).collect();
        if flying.is_empty() {
            // The next flight that begins sets an end anew.
            self.near.flight_end = f64::NEG_INFINITY;
            return Ok(());
        }
        self.near.flight_end = Self::next_flight_end(core, t);
        self.agenda.add(self.near.flight_end, Due::FlightBoxes);
        self.renew_boxes(core, &flying, t)?;
        self.search_pairs(core, &flying, t, Search::Ended)
    }

    /// Sets new boxes of these bodies, whose motions are known from `t` on, and finds the pairs that they make.
    ///
    /// # Errors
    /// When there are more bodies than the broad phase can number.
    pub(super) fn renew_boxes(&mut self, core: &Core, bodies: &[usize], t: f64) -> Result<(), SimulationError> {
        if !core.world.may_collide_at_all() {
            return Ok(());
        }
        let mut near = std::mem::replace(&mut self.near.boxes, Boxes::new(&core.settings, 0));
        for &body in bodies {
            let interval = match &self.tracks[body].mode {
                Mode::Fixed | Mode::Rest => (t, t),
                Mode::Flight(_) => (t, self.near.flight_end),
                Mode::Constrained | Mode::Stepped => self.island_of(body).map_or((t, t), |own| (own.t, own.end())),
            };
            let margin = core.world.touch_distance(&self.states, body, body);
            near.set(&core.world, body, self.motion(body).get(), interval, margin);
        }
        let mut found: Vec<(usize, Vec<usize>)> = bodies.iter().map(|&body| (body, Vec::new())).collect();
        let moves = |body: usize| !matches!(self.tracks[body].mode, Mode::Fixed | Mode::Rest);
        if bodies.len() < MANY_NEW_BOXES {
            for (body, partners) in &mut found {
                let own = moves(*body);
                near.near(&core.world, *body, |other| {
                    if own || moves(other) {
                        partners.push(other);
                    }
                });
            }
        } else {
            near.all_pairs(&core.world, |a, b| {
                if !(moves(a) || moves(b)) {
                    return;
                }
                for (body, other) in [(a, b), (b, a)] {
                    if let Ok(place) = bodies.binary_search(&body) {
                        found[place].1.push(other);
                    }
                }
            })?;
            found.iter_mut().for_each(|(_, partners)| partners.sort_unstable());
        }
        self.near.boxes = near;
        for (body, partners) in found {
            self.replace_partners(body, partners);
        }
        Ok(())
    }

    /// Gives a body new partners; pairs that are no longer near are forgotten.
    fn replace_partners(&mut self, body: usize, partners: Vec<usize>) {
        let before = std::mem::replace(&mut self.near.partners[body], partners);
        for other in before {
            if self.near.partners[body].binary_search(&other).is_err() {
                self.forget_watch(body, other);
                if let Ok(place) = self.near.partners[other].binary_search(&body) {
                    self.near.partners[other].remove(place);
                }
            }
        }
        for k in 0..self.near.partners[body].len() {
            let other = self.near.partners[body][k];
            if let Err(place) = self.near.partners[other].binary_search(&body) {
                self.near.partners[other].insert(place, body);
            }
        }
    }

    /// Takes a body out of all pairs.
    pub(super) fn remove_from_pairs(&mut self, body: usize) {
        self.near.boxes.clear(body);
        self.replace_partners(body, Vec::new());
    }

    fn forget_watch(&mut self, a: usize, b: usize) {
        let pair = ordered(a, b);
        if let Some(watch) = self.near.watches.remove(&pair) {
            self.agenda.remove(watch.impact, Due::Impact(pair.0, pair.1));
        }
    }

    /// Searches the pairs of these bodies for impacts after `t`.
    ///
    /// # Errors
    /// When a search does not end.
    pub(super) fn search_pairs(
        &mut self,
        core: &Core,
        bodies: &[usize],
        t: f64,
        search: Search,
    ) -> Result<(), SimulationError> {
        for &body in bodies {
            for k in 0..self.near.partners[body].len() {
                let other = self.near.partners[body][k];
                // A pair of two of these bodies is searched once.
                if other < body && bodies.binary_search(&other).is_ok() {
                    continue;
                }
                let (a, b) = ordered(body, other);
                if search == Search::Ended && self.near.watches.get(&(a, b)).is_some_and(|watch| watch.until > t) {
                    continue;
                }
                self.search_pair(core, a, b, t)?;
            }
        }
        Ok(())
    }

    /// Searches one pair for its impact after `t`.
    fn search_pair(&mut self, core: &Core, a: usize, b: usize, t: f64) -> Result<(), SimulationError> {
        self.forget_watch(a, b);
        let until = self.known_until(a).min(self.known_until(b));
        if until <= t || !until.is_finite() {
            return Ok(());
        }
        let impact = self.first_impact(core, (a, b), (t, until))?.unwrap_or(f64::INFINITY);
        self.near.watches.insert((a, b), Watch { until, impact });
        self.agenda.add(impact, Due::Impact(a, b));
        Ok(())
    }

    /// The time of the first impact of a pair in `(start, end]`.
    fn first_impact(
        &self,
        core: &Core,
        (a, b): (usize, usize),
        (start, end): (f64, f64),
    ) -> Result<Option<f64>, SimulationError> {
        let Some((shape_a, shape_b)) = core.world.shapes(a, b) else { return Ok(None) };
        let (motion_a, motion_b) = (self.motion(a), self.motion(b));
        let (motion_a, motion_b) = (motion_a.get(), motion_b.get());
        let search = match self.are_held(a, b) {
            false => time_of_impact,
            true if is_fast(core, [(a, motion_a), (b, motion_b)], (start, end)) => time_of_further_impact,
            true => return Ok(None),
        };
        let found =
            search(shape_a, motion_a, shape_b, motion_b, start, end, &ImpactSearch::default()).map_err(|source| {
                SimulationError::ImpactSearch {
                    t: start,
                    body_a: core.world.bodies[a].name.clone(),
                    body_b: core.world.bodies[b].name.clone(),
                    source,
                }
            })?;
        let longest = core.settings.step_s;
        Ok(found.map(|t| {
            let pace = self.pace_of(core, &[a, b]);
            if pace.is_backing_off() && pace.is_stall(t, longest) { pace.retry_time(longest).min(end) } else { t }
        }))
    }

    /// Whether a contact holds two bodies together.
    fn are_held(&self, a: usize, b: usize) -> bool {
        let island = self.island_of(a).or_else(|| self.island_of(b));
        island.is_some_and(|island| {
            let first = island.held.partition_point(|id| (id.a, id.b) < (a, b));
            island.held.get(first).is_some_and(|id| (id.a, id.b) == (a, b))
        })
    }
}

/// Which pairs are searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Search {
    /// All: the motion of their bodies is new.
    All,
    /// Those whose search has come to its end.
    Ended,
}

/// Whether two bodies go so far between two of the looks by which their contacts are watched that they could go through
/// each other.
fn is_fast(core: &Core, bodies: [(usize, &dyn Motion); 2], (start, end): (f64, f64)) -> bool {
    let speed = bodies.map(|(body, motion)| {
        let bounds = motion.bounds(start, end);
        bounds.speed + bounds.angular_speed * core.world.bodies[body].size
    });
    let between = (end - start) / f64::from(DIP_SAMPLES);
    (speed[0] + speed[1]) * between > FAST * core.world.pair_size(bodies[0].0, bodies[1].0)
}

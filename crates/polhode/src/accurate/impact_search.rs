//! The search for impacts of the pairs of bodies that may meet.
//!
//! Every body that may collide has a bounding box of its motion: over the present step of its island, or, in free
//! flight or on a prescribed path, up to the next renewal of all such boxes, at times on a fixed grid. If the boxes of
//! a pair overlap, conservative advancement on their exact motion searches for an impact. The result is kept until the
//! motion of one of the bodies changes. The impact found is never late, except for pairs that touch where the search
//! begins: such a pair may separate and meet again between two evaluations of the search. Pairs with a held contact are
//! checked by the location of contact changes. If they move fast, parts that are apart from each other are searched
//! too, because they could pass through each other between two checks.

use super::agenda::Due;
use super::island::Step;
use super::locate::PENETRATION_CHECKS;
use super::motions::{Mode, Motions};
use super::near_pairs::Watch;
use super::penetration::PENETRATING_RELATIVE;
use super::schedule::Schedule;
use crate::collision::boxes::Boxes;
use crate::collision::contact_kinematics;
use crate::error::SimulationError;
use crate::model::{prescribed, reported, tolerances};
use crate::tier::core::Core;
use polhode_contact::{Aabb, ImpactError, ImpactSearch, Shape, separation, time_of_further_impact, time_of_impact};
use polhode_dynamics::Flight;
use polhode_spatial::{Motion, Still};

/// Distance that bodies in held contact may travel between two checks, relative to the smaller size, before their other
/// parts are searched.
const FAST: f64 = 0.01;

/// How often a search is restarted where its evaluations were used up. Close to touch a search advances by ever smaller
/// steps; one that starts there takes longer steps.
const SEARCHES_FROM_TOUCH: u32 = 8;

/// Number of bodies with new boxes from which the broad phase finds all pairs at once.
const MANY_NEW_BOXES: usize = 32;

/// A pair in order.
fn ordered(a: usize, b: usize) -> (usize, usize) {
    (a.min(b), a.max(b))
}

/// Motion of a body until its step ends.
pub(super) enum BodyMotion<'a> {
    /// In flight.
    Flight(&'a Flight),
    /// Over a step of its island, or as prescribed.
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

impl Motions {
    /// Motion of a body.
    pub(super) fn motion<'a>(&'a self, core: &'a Core, body: usize) -> BodyMotion<'a> {
        let still = || BodyMotion::Still(Still(self.states[body].pose));
        match &self.tracks[body].mode {
            Mode::Fixed | Mode::Rest => still(),
            Mode::Prescribed => prescribed::trajectory(&core.model, body)
                .map_or_else(still, |trajectory| BodyMotion::Within(trajectory)),
            Mode::Flight(flight) => BodyMotion::Flight(flight),
            Mode::Constrained | Mode::Stepped | Mode::Crowded(_) => match self.island_of(body).map(|own| &own.step) {
                Some(Step::Constrained(step)) => {
                    step.motion(body).map_or_else(still, |motion| BodyMotion::Within(motion))
                }
                Some(Step::Free(step)) => {
                    step.body_motion(body).map_or_else(still, |motion| BodyMotion::Within(motion))
                }
                Some(Step::Crowd(step)) => {
                    let place = self.island_of(body).and_then(|own| own.bodies.binary_search(&body).ok());
                    place.and_then(|place| step.motion(place)).map_or_else(still, |motion| BodyMotion::Within(motion))
                }
                Some(Step::Waiting(_)) | None => still(),
            },
        }
    }

    /// Whether the time steps of one crowd handle this pair.
    fn is_within_crowd(&self, core: &Core, a: usize, b: usize) -> bool {
        let crowded = |body: usize| matches!(self.tracks[body].mode, Mode::Crowded(_));
        let given = |body: usize| !core.model.bodies[body].moves();
        match (crowded(a), crowded(b)) {
            (true, true) => self.tracks[a].island == self.tracks[b].island,
            (true, false) => given(b),
            (false, true) => given(a),
            (false, false) => false,
        }
    }

    /// Whether a body does not move over an interval (s).
    fn is_still(&self, core: &Core, body: usize, (start, end): (f64, f64)) -> bool {
        match &self.tracks[body].mode {
            Mode::Fixed | Mode::Rest => true,
            Mode::Prescribed => prescribed::stands_still(&core.model, body, start, end),
            Mode::Flight(_) | Mode::Constrained | Mode::Stepped | Mode::Crowded(_) => false,
        }
    }

    /// Whether two bodies penetrate measurably at `t` (s) if they continue their present motion.
    fn penetrates_at(&self, core: &Core, (a, b): (usize, usize), t: f64) -> bool {
        let [pose_a, pose_b] = [a, b].map(|body| self.motion(core, body).get().pose(t));
        contact_kinematics::shapes(&core.model, a, b).is_some_and(|(shape_a, shape_b)| {
            separation(shape_a, &pose_a, shape_b, &pose_b)
                < -PENETRATING_RELATIVE * tolerances::pair_size(&core.model, a, b)
        })
    }

    /// The time of the first impact of a pair in `(start, end]`.
    fn first_impact(
        &self,
        core: &Core,
        (a, b): (usize, usize),
        (start, end): (f64, f64),
    ) -> Result<Option<f64>, SimulationError> {
        let Some((shape_a, shape_b)) = contact_kinematics::shapes(&core.model, a, b) else { return Ok(None) };
        let (motion_a, motion_b) = (self.motion(core, a), self.motion(core, b));
        let (motion_a, motion_b) = (motion_a.get(), motion_b.get());
        let is_held = self.are_held(a, b);
        let search = match is_held {
            false => time_of_impact,
            true if is_fast(core, [(a, motion_a), (b, motion_b)], (start, end)) => time_of_further_impact,
            true => return Ok(None),
        };
        let failed = |source| SimulationError::ImpactSearch {
            t_s: start,
            body_a: core.model.bodies[a].name.clone(),
            body_b: core.model.bodies[b].name.clone(),
            source,
        };
        let has_parts =
            [shape_a, shape_b].iter().any(|shape| matches!(shape, Shape::Compound(_) | Shape::TriangleMesh(_)));
        let (mut from, mut left) = (start, if is_held || has_parts { 0 } else { SEARCHES_FROM_TOUCH });
        loop {
            match search(shape_a, motion_a, shape_b, motion_b, from, end, &ImpactSearch::default()) {
                // The search has found no impact up to `t`, but close to touch it takes ever smaller steps. It is
                // restarted at `t`, except for held pairs and for bodies of several parts, of which only the parts
                // searched are known to be apart.
                Err(ImpactError::EvaluationLimit { t, .. }) if t > from && left > 0 => {
                    (from, left) = (t, left - 1);
                }
                found => return found.map_err(failed),
            }
        }
    }

    /// Whether a contact holds two bodies together.
    fn are_held(&self, a: usize, b: usize) -> bool {
        let island = self.island_of(a).or_else(|| self.island_of(b));
        island.is_some_and(|island| {
            let first = island.active.held().partition_point(|id| (id.a, id.b) < (a, b));
            island.active.held().get(first).is_some_and(|id| (id.a, id.b) == (a, b))
        })
    }
}

impl Schedule {
    /// The time up to which the motion of a body is known, s.
    fn known_until(&self, motions: &Motions, body: usize) -> f64 {
        match &motions.tracks[body].mode {
            Mode::Fixed | Mode::Rest => f64::INFINITY,
            Mode::Flight(_) | Mode::Prescribed => self.near.flight_end,
            Mode::Constrained | Mode::Stepped | Mode::Crowded(_) => {
                motions.island_of(body).map_or(f64::INFINITY, |island| island.due)
            }
        }
    }

    /// The first time on the grid of the flights' boxes at least half a step after `t`, s: a shorter search would soon
    /// have to be repeated.
    fn next_flight_end(core: &Core, t: f64) -> f64 {
        let step = core.settings.step_s;
        let next = ((t / step + 0.5).floor() + 1.0) * step;
        // The quotient may be rounded down, which would give a time that is not after t.
        if next > t { next } else { next + step }
    }

    /// The time up to which the boxes of kinematic bodies are valid, s; infinite without such bodies.
    pub(super) fn end_of_kinematic_boxes(&self, core: &Core, t: f64) -> f64 {
        let bounds = !core.model.prescribed.is_empty() && self.near.flight_end > t;
        if bounds { self.near.flight_end } else { f64::INFINITY }
    }

    /// Sets the end of validity of the boxes of flights and kinematic bodies that begin at `t`.
    pub(super) fn begin_flight_boxes(&mut self, core: &Core, t: f64) {
        if self.near.flight_end <= t && core.model.surfaces.may_collide() {
            self.near.flight_end = Self::next_flight_end(core, t);
            self.agenda.add(self.near.flight_end, Due::FlightBoxes);
        }
    }

    /// Renews the boxes of all bodies in flight and of kinematic bodies at `t`, the end of the previous boxes, with
    /// their pairs and impacts.
    ///
    /// # Errors
    /// When a search does not end.
    pub(super) fn renew_flight_boxes(
        &mut self,
        core: &mut Core,
        motions: &Motions,
        t: f64,
    ) -> Result<(), SimulationError> {
        let flies = |body: usize| matches!(motions.tracks[body].mode, Mode::Flight(_) | Mode::Prescribed);
        let collides = |body: usize| core.model.bodies[body].shape.is_some();
        let flying: Vec<usize> = (0..motions.tracks.len()).filter(|&body| collides(body) && flies(body)).collect();
        if flying.is_empty() {
            // The next flight that begins sets a new end.
            self.near.flight_end = f64::NEG_INFINITY;
            return Ok(());
        }
        self.near.flight_end = Self::next_flight_end(core, t);
        self.agenda.add(self.near.flight_end, Due::FlightBoxes);
        self.renew_boxes(core, motions, &flying, t)?;
        self.search_pairs(core, motions, &flying, t, Search::Ended)
    }

    /// Sets new boxes of these bodies, whose motions are known from `t` on, and finds the pairs with overlapping boxes.
    ///
    /// # Errors
    /// When there are more bodies than the broad phase can number.
    pub(super) fn renew_boxes(
        &mut self,
        core: &Core,
        motions: &Motions,
        bodies: &[usize],
        t: f64,
    ) -> Result<(), SimulationError> {
        if !core.model.surfaces.may_collide() {
            return Ok(());
        }
        let mut near = std::mem::replace(&mut self.near.boxes, Boxes::new(core.settings.broad_phase, 0));
        // The boxes of a crowd remain those of its collection (`gather`).
        for &body in bodies.iter().filter(|&&body| !matches!(motions.tracks[body].mode, Mode::Crowded(_))) {
            let interval = match &motions.tracks[body].mode {
                Mode::Fixed | Mode::Rest => (t, t),
                Mode::Flight(_) | Mode::Prescribed => (t, self.near.flight_end),
                Mode::Constrained | Mode::Stepped | Mode::Crowded(_) => {
                    motions.island_of(body).map_or((t, t), |own| (own.t, own.end()))
                }
            };
            let margin = tolerances::touch_distance(&core.model, &motions.states, body, body);
            near.set(&core.model, body, motions.motion(core, body).get(), interval, margin);
        }
        // Pairs of a body and its partner; sorted below.
        let mut found: Vec<(usize, usize)> = Vec::new();
        let moves = |body: usize| !matches!(motions.tracks[body].mode, Mode::Fixed | Mode::Rest);
        if bodies.len() < MANY_NEW_BOXES {
            for &body in bodies {
                let own = moves(body);
                near.near(&core.model, body, |other| {
                    if own || moves(other) {
                        found.push((body, other));
                    }
                });
            }
        } else {
            near.all_pairs(&core.model, |a, b| {
                if moves(a) || moves(b) {
                    let both = [(a, b), (b, a)].into_iter();
                    found.extend(both.filter(|(body, _)| bodies.binary_search(body).is_ok()));
                }
            })?;
        }
        found.sort_unstable();
        self.near.boxes = near;
        for &body in bodies {
            let start = found.partition_point(|&(first, _)| first < body);
            let end = found.partition_point(|&(first, _)| first <= body);
            let own = &found[start..end];
            // Most bodies in flight have no partner and had none: nothing changes for them.
            if !(own.is_empty() && self.near.partners[body].is_empty()) {
                self.replace_partners(body, own.iter().map(|&(_, other)| other).collect());
            }
        }
        Ok(())
    }

    /// Replaces the partners of a body and removes pairs that are no longer near.
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

    /// Removes a body from all pairs.
    pub(super) fn remove_from_pairs(&mut self, body: usize) {
        self.near.boxes.put(body, None);
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
        core: &mut Core,
        motions: &Motions,
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
                self.search_pair(core, motions, (a, b), t)?;
            }
        }
        Ok(())
    }

    /// Searches one pair for its impact after `t`.
    fn search_pair(
        &mut self,
        core: &mut Core,
        motions: &Motions,
        (a, b): (usize, usize),
        t: f64,
    ) -> Result<(), SimulationError> {
        self.forget_watch(a, b);
        if motions.is_within_crowd(core, a, b) {
            return Ok(());
        }
        let until = self.known_until(motions, a).min(self.known_until(motions, b));
        if until <= t || !until.is_finite() {
            return Ok(());
        }
        if motions.is_still(core, a, (t, until)) && motions.is_still(core, b, (t, until)) {
            self.near.watches.insert((a, b), Watch { until, impact: f64::INFINITY });
            return Ok(());
        }
        let found = motions.first_impact(core, (a, b), (t, until))?;
        let (pace, longest) = (motions.pace_of(core, &[a, b]), core.settings.step_s);
        let impact = match found {
            Some(found) => {
                let retry = pace.retry_time(longest).min(until);
                let is_postponed = pace.is_backing_off() && pace.is_stall(found, longest);
                if is_postponed && !motions.penetrates_at(core, (a, b), retry) {
                    let names = reported::pair_names(&core.model, a, b);
                    core.accounts.tolerate(found, format!("an impact of {names} was postponed for a short time"));
                    retry
                } else {
                    found
                }
            }
            None => f64::INFINITY,
        };
        self.near.watches.insert((a, b), Watch { until, impact });
        self.agenda.add(impact, Due::Impact(a, b));
        Ok(())
    }

    /// Sets the box of a body.
    pub(super) fn set_box(&mut self, body: usize, aabb: Option<Aabb>) {
        self.near.boxes.put(body, aabb);
    }

    /// Bodies that may collide with `body` and whose boxes overlap its box.
    pub(super) fn near_boxes(&self, core: &Core, body: usize) -> Vec<usize> {
        let mut found = Vec::new();
        self.near.boxes.near(&core.model, body, |other| found.push(other));
        found
    }
}

/// Which pairs are searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Search {
    /// All: the motion of their bodies is new.
    All,
    /// Those whose search interval has ended.
    Ended,
}

/// Whether two bodies travel so far between two checks of their contacts that they could pass through each other.
fn is_fast(core: &Core, bodies: [(usize, &dyn Motion); 2], (start, end): (f64, f64)) -> bool {
    let speed = bodies.map(|(body, motion)| {
        let bounds = motion.bounds(start, end);
        bounds.speed + bounds.angular_speed * core.model.bodies[body].size
    });
    let between = (end - start) / f64::from(PENETRATION_CHECKS);
    (speed[0] + speed[1]) * between > FAST * tolerances::pair_size(&core.model, bodies[0].0, bodies[1].0)
}

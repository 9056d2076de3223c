//! One throw: from a random attitude, at rest, to what became of it.
//!
//! On a plane a throw ends when the body rests, or before: when its energy no longer suffices to tip it off the face
//! that it lies on ([`Facets::held_on`](super::facets::Facets::held_on)) and no later impact can be the strongest. With
//! the energy E (J) above that of rest on the face the momentum is at most `sqrt(2 m E)`, and an impulse turns it round
//! at most: `J <= 2 sqrt(2 m E)`. In any other scene a throw ends when the body rests.

use super::attitude::attitude;
use super::contact_time::{ContactLaw, OverTime};
use super::setting::Setting;
use polhode::spatial::{DMat3, DVec3};
use polhode::{BodyId, BodySample, Event, EventKind, Observer, Outcome, Simulation, SimulationError};

/// What became of a throw.
#[derive(Debug, Clone, PartialEq)]
pub enum Fate {
    /// It came to rest on this face.
    Rests(usize),
    /// It came to rest on no face alone: several surfaces hold it, or it lies on an edge.
    Leans,
    /// It still moved when the time had run out.
    Moves,
    /// It was not computed, or not as the method promises: why.
    Failed(String),
}

impl Fate {
    /// The word for it in tables.
    pub const fn word(&self) -> &'static str {
        match self {
            Self::Rests(_) => "rests",
            Self::Leans => "leans",
            Self::Moves => "moves",
            Self::Failed(_) => "failed",
        }
    }
}

/// An instant at which the body is struck.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blow {
    /// When, s.
    pub t_s: f64,
    /// The sum of all normal impulses on the body at this instant, N s.
    pub impulse_ns: f64,
    /// The greatest deceleration of the centre of mass over the time of the contact, m/s^2; none without a law.
    pub deceleration: Option<f64>,
    /// How long the point that is struck hardest touches, s; none without a law.
    pub time_s: Option<f64>,
}

/// A throw.
#[derive(Debug, Clone, PartialEq)]
pub struct Throw {
    /// Its number.
    pub number: u64,
    /// The attitude in which it was let go: w, x, y, z, body to world.
    pub attitude: [f64; 4],
    /// What became of it.
    pub fate: Fate,
    /// When that was decided, s.
    pub end_s: f64,
    /// Instants at which it was struck.
    pub blows: u64,
    /// The strongest by its impulse; none where it was never struck.
    pub strongest: Option<Blow>,
    /// The greatest deceleration, m/s^2, and the time of that contact, s; none without a law of the contact.
    pub hardest: Option<Blow>,
}

/// What is the same for all throws.
#[derive(Debug, Clone)]
pub(super) struct Thrower<'a> {
    pub(super) setting: &'a Setting,
    pub(super) law: Option<ContactLaw>,
    pub(super) seed: u64,
}

impl Thrower<'_> {
    /// A throw; none where it was stopped.
    pub(super) fn thrown(&self, number: u64, is_stopped: &(dyn Fn() -> bool + Sync)) -> Option<Throw> {
        let attitude = attitude(self.seed, number);
        let mut flight = Flight { blows: 0, strongest: None, hardest: None, end_s: 0.0 };
        let fate = match self.setting.begun(attitude) {
            Err(error) => Fate::Failed(error.to_string()),
            Ok((mut simulation, body)) => match self.fly(&mut simulation, body, &mut flight, is_stopped) {
                Ok(fate) => fate?,
                Err(error) => Fate::Failed(error.to_string()),
            },
        };
        let Flight { blows, strongest, hardest, end_s } = flight;
        Some(Throw { number, attitude: attitude.to_wxyz(), fate, end_s, blows, strongest, hardest })
    }

    fn fly(
        &self,
        simulation: &mut Simulation,
        body: BodyId,
        flight: &mut Flight,
        is_stopped: &(dyn Fn() -> bool + Sync),
    ) -> Result<Option<Fate>, SimulationError> {
        let mut fate = None;
        let mut seen = Seen { body, impacts: Vec::new(), rests: false, has_news: false };
        while fate.is_none() && !simulation.has_ended() {
            if is_stopped() {
                return Ok(None);
            }
            simulation.step_observed(&mut seen)?;
            let sample = simulation.body(body);
            self.add_blows(flight, &mut seen.impacts, body, &sample);
            flight.end_s = simulation.time();
            let has_stopped = flight.blows > 0 && sample.velocity.is_zero();
            if seen.rests || has_stopped {
                fate = Some(self.at_rest(simulation, body, &sample));
            } else if std::mem::take(&mut seen.has_news) {
                let trapped = self.trapped(&sample);
                let decided = trapped.filter(|(_, left_j)| self.is_past_its_strongest(flight, *left_j));
                fate = decided.map(|(facet, _)| Fate::Rests(facet));
            }
        }
        let report = simulation.report_so_far()?;
        if report.outcome == Outcome::Degraded {
            let reason = report.warnings.first().map_or("the run has not kept its promise", String::as_str);
            return Ok(Some(Fate::Failed(reason.to_owned())));
        }
        let at_end = || self.trapped(&simulation.body(body)).map(|(facet, _)| Fate::Rests(facet));
        Ok(Some(fate.or_else(at_end).unwrap_or(Fate::Moves)))
    }

    /// The face that it can no longer leave, on a plane, and its energy above that of rest there, J.
    fn trapped(&self, sample: &BodySample) -> Option<(usize, f64)> {
        let plane_m = self.setting.plane_m()?;
        let properties = self.setting.properties();
        let (up, weight_n) = (self.setting.up(), properties.mass() * self.setting.gravity());
        let center = sample.pose.transform_point(properties.center_of_mass());
        let spin = sample.pose.rotation.inverse_rotate(sample.velocity.angular);
        let turning = 0.5 * spin.dot(properties.inertia().matrix() * spin);
        let kinetic = 0.5 * properties.mass() * sample.velocity.linear.length_squared() + turning;
        let height_m = center.dot(up) - plane_m + kinetic / weight_n;
        let facets = self.setting.facets();
        let facet = facets.held_on(sample.pose.rotation.inverse_rotate(-up), height_m)?;
        Some((facet, weight_n * (height_m - facets.list()[facet].height_m)))
    }

    /// Whether no later impact can be stronger than the strongest so far, with this energy left, J.
    fn is_past_its_strongest(&self, flight: &Flight, left_j: f64) -> bool {
        let most = 2.0 * (2.0 * self.setting.properties().mass() * left_j.max(0.0)).sqrt();
        flight.strongest.is_some_and(|blow| most <= blow.impulse_ns)
    }

    /// What it rests on: the face that is towards all that presses on it. What lies within the tilt that the face
    /// survives is the face: between are rounding, the softness of a method, and slopes.
    fn at_rest(&self, simulation: &Simulation, body: BodyId, sample: &BodySample) -> Fate {
        let facets = self.setting.facets();
        let mut presses = if self.setting.is_on_plane() { Vec::new() } else { presses(simulation, body) };
        if presses.is_empty() {
            presses.push(-self.setting.up());
        }
        let on = |press: DVec3| {
            let down = sample.pose.rotation.inverse_rotate(press);
            let nearest = facets.nearest(down)?;
            let own = facets.list().get(nearest)?;
            let angle = libm::atan2(own.normal.cross(down).length(), own.normal.dot(down));
            (angle < own.tilt_rad).then_some(nearest)
        };
        let first = presses.first().and_then(|&press| on(press));
        match first {
            Some(facet) if presses.iter().all(|&press| on(press) == first) => Fate::Rests(facet),
            _ => Fate::Leans,
        }
    }

    /// Adds the instants of some impacts.
    fn add_blows(&self, flight: &mut Flight, impacts: &mut Vec<Event>, body: BodyId, sample: &BodySample) {
        for instant in impacts.chunk_by(|a, b| a.t_s == b.t_s) {
            let blow = self.blow(instant, body, sample);
            flight.blows += 1;
            if flight.strongest.is_none_or(|strongest| blow.impulse_ns > strongest.impulse_ns) {
                flight.strongest = Some(blow);
            }
            let hardness = |blow: Blow| blow.deceleration.unwrap_or_default();
            if blow.deceleration.is_some() && flight.hardest.is_none_or(|hardest| hardness(blow) > hardness(hardest)) {
                flight.hardest = Some(blow);
            }
        }
        impacts.clear();
    }

    /// The impacts of one instant together.
    fn blow(&self, instant: &[Event], body: BodyId, sample: &BodySample) -> Blow {
        let properties = self.setting.properties();
        let rotation = sample.pose.rotation.to_matrix();
        let inverse_inertia = rotation * properties.inertia().matrix().inverse() * rotation.transpose();
        let center = sample.pose.transform_point(properties.center_of_mass());
        let t_s = instant.first().map_or(0.0, |event| event.t_s);
        let (mut impulse, mut force) = (DVec3::ZERO, DVec3::ZERO);
        let mut longest: Option<OverTime> = None;
        for (place, event) in instant.iter().enumerate() {
            let direction = if event.body_a == body { event.normal } else { -event.normal };
            impulse += direction * event.impulse;
            // A law may strike a point several times in one instant: it is one contact.
            let is_same = |other: &Event| other.point == event.point;
            if instant[..place].iter().any(is_same) {
                continue;
            }
            let sum: f64 = instant.iter().filter(|other| is_same(other)).map(|other| other.impulse).sum();
            let mass = effective_mass(properties.mass(), &inverse_inertia, event.point - center, direction);
            if let Some(over) = self.law.filter(|_| sum > 0.0).map(|law| law.over_time(sum, mass)) {
                force += direction * over.force_n;
                longest = longest.filter(|longest| longest.force_n >= over.force_n).or(Some(over));
            }
        }
        let deceleration = longest.map(|_| force.length() / properties.mass());
        Blow { t_s, impulse_ns: impulse.length(), deceleration, time_s: longest.map(|longest| longest.time_s) }
    }
}

/// The mass (kg) that a body opposes to an impulse at an arm (m) from its centre of mass along a unit vector.
fn effective_mass(mass: f64, inverse_inertia: &DMat3, arm: DVec3, along: DVec3) -> f64 {
    let turn = arm.cross(along);
    1.0 / (1.0 / mass + turn.dot(*inverse_inertia * turn))
}

/// The directions out of a body in which it presses on what holds it.
fn presses(simulation: &Simulation, body: BodyId) -> Vec<DVec3> {
    let contacts = simulation.contacts();
    let own = contacts.iter().filter(|contact| contact.body_a == body || contact.body_b == body);
    let loaded = own.filter(|contact| contact.normal_force_n != 0.0);
    loaded.map(|contact| if contact.body_a == body { -contact.normal } else { contact.normal }).collect()
}

/// What a throw is measured by while it goes on.
#[derive(Debug, Clone)]
struct Flight {
    blows: u64,
    strongest: Option<Blow>,
    hardest: Option<Blow>,
    end_s: f64,
}

/// What happened to the body in a step.
struct Seen {
    body: BodyId,
    impacts: Vec<Event>,
    rests: bool,
    has_news: bool,
}

impl Observer for Seen {
    fn sample(&mut self, _t_s: f64, _bodies: &[BodySample]) {}

    fn wants_samples(&self) -> bool {
        false
    }

    fn event(&mut self, event: &Event) {
        if event.body_a != self.body && event.body_b != Some(self.body) {
            return;
        }
        self.has_news = true;
        match event.kind {
            EventKind::Impact | EventKind::Jam if event.impulse != 0.0 => self.impacts.push(*event),
            EventKind::Rest => self.rests = true,
            EventKind::Wake => self.rests = false,
            _ => {}
        }
    }
}

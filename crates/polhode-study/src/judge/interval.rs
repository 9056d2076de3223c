//! What must have acted between two samples.
//!
//! | symbol | is |
//! |---|---|
//! | `P` | `m (v_1 - v_0) - int F dt`, N s: what contacts and joints must have given |
//! | `L` | the same of moments, about the moving centre of mass or about its place in the middle, N m s |
//! | `S`, `T` | the integral by Simpson's rule and by that of trapezoids |
//! | its error | `(S - T)^2 / (h max)`: Simpson's error is of the square of the order of the other one's |
//!
//! Contacts and joints are taken where they are at both samples: what moves along a straight line between them lies
//! between both. What does not is off by the distance of the middle from that line, which is allowed for; of the two
//! points for moments the one is taken for which that is less.

use super::error::JudgeError;
use super::observed::{Middle, Observed, Observer, ROUNDING};
use super::reactions::{Ends, Left, Needs, Reaction};
use polhode::dynamics::field::Wrench;
use polhode::spatial::DVec3;
use polhode::{BodyId, HeldState, MovableState, NearPair, NearPoint};
use std::collections::BTreeMap;

/// Two bodies near each other at an end of the interval.
#[derive(Debug, Clone, Default)]
struct Meeting<'a> {
    ends: [Option<&'a NearPair>; 2],
    middle: Option<&'a NearPair>,
}

/// Which law of contacts is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Asked {
    /// Coulomb's: what slides bears all of its friction, against the slip.
    Coulomb,
    /// A force within the cone.
    Cones,
    /// A force that pushes.
    Pushes,
    /// Any force.
    Any,
}

/// How contacts of a group end up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Verdict {
    /// All is explained.
    Explained,
    /// A contact slides with less than its friction, or not against its slip.
    Slides,
    /// Friction gives more than it can.
    OutsideCone,
    /// A contact pulls.
    Pulls,
    /// A force that nothing gives, near a body that could if it touched.
    Apart,
    /// A force that nothing gives.
    Nothing,
    /// At rest above what should hold it, for this interval.
    Floats,
}

/// What is found of a group of bodies.
#[derive(Debug, Clone)]
pub(super) struct OfGroup {
    pub(super) verdict: Verdict,
    /// The mean force that is not explained, and what is allowed, N.
    pub(super) force_n: [f64; 2],
    pub(super) body: BodyId,
    /// The other body: that it should touch, and how far it is, m.
    pub(super) other: Option<(BodyId, f64)>,
}

/// What is found of an interval.
#[derive(Debug, Clone, Default)]
pub(super) struct Acted {
    pub(super) groups: Vec<OfGroup>,
    /// Energy that contacts take, J: at least and at most; infinite where it is not known.
    pub(super) taken_j: [f64; 2],
    /// Whether what acts from outside may give energy.
    pub(super) is_driven: bool,
    /// Energy of what is left of impulses within what is allowed, J.
    pub(super) hidden_j: f64,
    /// Bodies that may have struck others, at times of which samples say nothing.
    pub(super) struck: Vec<BodyId>,
}

/// Two samples, and the middle between them.
pub(super) struct Interval<'a> {
    pub(super) observer: &'a Observer<'a>,
    /// The number of the second one.
    pub(super) place: usize,
    pub(super) ends: [&'a Observed; 2],
    pub(super) middle: &'a Middle,
}

impl<'a> Interval<'a> {
    fn length_s(&self) -> f64 {
        self.ends[1].t_s - self.ends[0].t_s
    }

    /// The integral of a quantity, and its error.
    pub(super) fn integral(&self, [from, middle, to]: [f64; 3]) -> [f64; 2] {
        let h = self.length_s();
        let (simpson, trapezoid) = (h * (from + 4.0 * middle + to) / 6.0, 0.5 * h * (from + to));
        let most = h * from.abs().max(middle.abs()).max(to.abs());
        [simpson, if most > 0.0 { (simpson - trapezoid).powi(2) / most } else { 0.0 }]
    }

    fn integral_of(&self, of: [DVec3; 3]) -> (DVec3, f64) {
        let [x, y, z] = [0, 1, 2].map(|axis: usize| self.integral(of.map(|own| own[axis])));
        (DVec3::new(x[0], y[0], z[0]), x[1] + y[1] + z[1])
    }

    /// What is found of all groups.
    ///
    /// # Errors
    /// When impulses cannot be found.
    pub(super) fn acted(&self) -> Result<Acted, JudgeError> {
        let meetings = self.meetings();
        let mut acted = Acted::default();
        for group in self.groups(&meetings) {
            let own = Group::of(self, &group, &meetings);
            own.judge(&mut acted).map_err(|source| JudgeError::Reactions { t_s: self.ends[1].t_s, source })?;
        }
        Ok(acted)
    }

    fn meetings(&self) -> BTreeMap<[BodyId; 2], Meeting<'a>> {
        let mut found: BTreeMap<[BodyId; 2], Meeting<'a>> = BTreeMap::new();
        for (end, observed) in self.ends.iter().enumerate() {
            for pair in &observed.near {
                found.entry(pair.bodies).or_default().ends[end] = Some(pair);
            }
        }
        for pair in &self.middle.near {
            found.entry(pair.bodies).or_default().middle = Some(pair);
        }
        found
    }

    fn movable(&self, body: BodyId) -> Option<[&'a MovableState; 2]> {
        let of = |end: usize| self.ends[end].movable.get(body.index())?.as_ref();
        Some([of(0)?, of(1)?])
    }

    /// Bodies that act on each other, or may.
    fn groups(&self, meetings: &BTreeMap<[BodyId; 2], Meeting<'a>>) -> Vec<Vec<BodyId>> {
        let count = self.ends[0].movable.len();
        let mut parent: Vec<usize> = (0..count).collect();
        let root = |parent: &[usize], mut own: usize| {
            while parent[own] != own {
                own = parent[own];
            }
            own
        };
        let met =
            meetings.iter().filter(|(_, own)| self.touches(own) || self.may_strike(own)).map(|(own, _)| own.to_vec());
        let held = self
            .ends
            .iter()
            .flat_map(|own| &own.held)
            .map(|own| own.rows.iter().flatten().map(|(body, ..)| *body).collect::<Vec<_>>());
        for bodies in met.chain(held) {
            let moving: Vec<usize> =
                bodies.into_iter().filter(|own| self.movable(*own).is_some()).map(BodyId::index).collect();
            for pair in moving.windows(2) {
                let (a, b) = (root(&parent, pair[0]), root(&parent, pair[1]));
                parent[a.max(b)] = a.min(b);
            }
        }
        let mut groups: BTreeMap<usize, Vec<BodyId>> = BTreeMap::new();
        for body in (0..count).map(BodyId::new).filter(|own| self.movable(*own).is_some()) {
            groups.entry(root(&parent, body.index())).or_default().push(body);
        }
        groups.into_values().collect()
    }

    /// Whether bodies touch at an end.
    fn touches(&self, meeting: &Meeting<'_>) -> bool {
        meeting.ends.iter().any(|own| self.touches_at(*own))
    }

    fn touches_at(&self, own: Option<&NearPair>) -> bool {
        own.is_some_and(|pair| pair.separation_m <= self.observer.touch_m(pair))
    }

    /// Whether bodies may strike each other between the ends: those that do not touch at both, or touch at other places
    /// than they could have slid or rolled to.
    fn may_strike(&self, meeting: &Meeting<'a>) -> bool {
        let [a, b] = meeting.ends.each_ref().map(|own| self.touches_at(*own));
        if a && b {
            return meeting.ends[0].zip(meeting.ends[1]).is_some_and(|(a, b)| self.touches_elsewhere(a, b));
        }
        a || b || !self.is_still(meeting)
    }

    /// Whether a pair has more or fewer points at the second end, or points or normals that none could have come to.
    fn touches_elsewhere(&self, a: &'a NearPair, b: &'a NearPair) -> bool {
        let speed: f64 = a.bodies.iter().map(|body| self.speeds(*body).into_iter().fold(0.0, f64::max)).sum();
        let way = speed * self.length_s() + self.observer.touch_m(a);
        let is_far = |(one, other): (&NearPoint, &NearPoint)| {
            (one.point_m - other.point_m).length() > way || (one.normal - other.normal).length() * a.size_m > way
        };
        let touching = |pair: &'a NearPair| -> Vec<&'a NearPoint> {
            pair.points.iter().filter(|own| own.separation_m <= self.observer.touch_m(pair)).collect()
        };
        let (first, second) = (touching(a), touching(b));
        first.len() != second.len() || first.into_iter().zip(second).any(is_far)
    }

    /// Whether bodies stay apart: they could come no nearer by the speeds that they have.
    fn is_still(&self, meeting: &Meeting<'_>) -> bool {
        let [Some(a), Some(b)] = meeting.ends else { return false };
        let gap = a.separation_m.min(b.separation_m);
        let speeds = a
            .bodies
            .iter()
            .map(|body| self.speeds(*body))
            .fold([0.0; 2], |sum, own| [sum[0] + own[0], sum[1] + own[1]]);
        (a.separation_m - b.separation_m).abs() < gap && (speeds[0] + speeds[1]) * self.length_s() < gap
    }

    /// How fast points of a body are at both ends, m/s.
    fn speeds(&self, body: BodyId) -> [f64; 2] {
        match self.movable(body) {
            Some(states) => states.map(|own| own.velocity.linear.length() + own.velocity.angular.length() * own.size_m),
            None => self.observer.given.samples[self.place - 1..=self.place]
                .first_chunk()
                .map_or([0.0; 2], |rows: &[Vec<_>; 2]| {
                    rows.each_ref().map(|row| row[body.index()].velocity.linear.length())
                }),
        }
    }
}

/// Bodies that act on each other.
struct Group<'a, 'b> {
    interval: &'b Interval<'a>,
    bodies: &'b [BodyId],
    /// Their states at both ends.
    of_bodies: Vec<[&'a MovableState; 2]>,
    meetings: Vec<&'b Meeting<'a>>,
    /// Joints at both ends, and in the middle.
    held: [Vec<&'a HeldState>; 3],
}

/// The points that moments are about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum About {
    /// The centre of mass, where it is.
    Moving,
    /// Its place in the middle.
    Middle,
}

impl<'a, 'b> Group<'a, 'b> {
    fn of(interval: &'b Interval<'a>, bodies: &'b [BodyId], meetings: &'b BTreeMap<[BodyId; 2], Meeting<'a>>) -> Self {
        let has = |body: &BodyId| bodies.binary_search(body).is_ok();
        let meetings = meetings.iter().filter(|(own, _)| own.iter().any(has)).map(|(_, own)| own);
        let held = [&interval.ends[0].held, &interval.middle.held, &interval.ends[1].held];
        let held = held.map(|all| {
            all.iter().filter(|own| own.rows.iter().flatten().any(|(body, ..)| has(body))).collect::<Vec<_>>()
        });
        let of_bodies = bodies.iter().filter_map(|body| interval.movable(*body)).collect();
        Self { interval, bodies, of_bodies, meetings: meetings.collect(), held }
    }

    fn judge(&self, acted: &mut Acted) -> Result<(), polhode::response::ResponseError> {
        let about = if self.bend(About::Moving) <= self.bend(About::Middle) { About::Moving } else { About::Middle };
        let (needs, mut allowed) = self.needs(about);
        allowed += self.scale() * self.bend(about) * self.leverage();
        let strikes = self.strikes();
        self.note_energy(acted);
        if strikes {
            acted.struck.extend_from_slice(self.bodies);
        }
        let floating = self.meetings.iter().find(|own| !self.interval.touches(own) && self.interval.is_still(own));
        let mut verdict = Verdict::Explained;
        let limit = allowed + self.turned();
        let left = needs.left(&self.reactions(Asked::Coulomb, about), limit)?;
        let (most, mut worst) = left.largest(&needs);
        self.note_friction(acted, &left, about);
        if most <= limit {
            acted.hidden_j += self.energy_of(most);
        }
        let mut beyond = most;
        if !strikes && most > limit {
            verdict = Verdict::Slides;
            let kinds =
                [(Asked::Cones, Verdict::OutsideCone), (Asked::Pushes, Verdict::Pulls), (Asked::Any, Verdict::Nothing)];
            for (asked, other) in kinds {
                let own = needs.left(&self.reactions(asked, about), allowed)?;
                let (most, body) = own.largest(&needs);
                if most <= allowed {
                    break;
                }
                (verdict, beyond, worst) = (other, most, body);
            }
        }
        let body = self.bodies[worst];
        let mut other = None;
        if verdict == Verdict::Nothing {
            let pair = floating.and_then(|own| own.ends[1]).filter(|pair| pair.bodies.contains(&body));
            if let Some(pair) = pair {
                let [a, b] = pair.bodies;
                (verdict, other) = (Verdict::Floats, Some((if a == body { b } else { a }, pair.separation_m)));
            } else {
                let nearest = self.interval.observer.evaluation.nearest(body);
                let size = self.states(worst)[1].size_m;
                other = nearest.filter(|(_, apart)| *apart > 0.0 && *apart <= size);
                if let Some((_, apart)) = other {
                    let way = self.interval.speeds(body).iter().sum::<f64>() * self.interval.length_s();
                    verdict = if way < apart { Verdict::Floats } else { Verdict::Apart };
                }
            }
        }
        let per_speed = self.states(worst)[1].mass_kg / self.interval.length_s();
        acted.groups.push(OfGroup { verdict, force_n: [beyond * per_speed, limit * per_speed], body, other });
        Ok(())
    }

    /// The energy that a change of velocity of each body by this may be (m/s), J.
    fn energy_of(&self, change: f64) -> f64 {
        let of = |(number, body): (usize, &BodyId)| {
            let speed = self.interval.speeds(*body).into_iter().fold(0.0, f64::max);
            self.states(number)[1].mass_kg * change * (speed + change)
        };
        self.bodies.iter().enumerate().map(of).sum()
    }

    fn states(&self, number: usize) -> [&'a MovableState; 2] {
        self.of_bodies[number]
    }

    /// The largest change of velocity by loads or by the motion itself, m/s: what tolerances are relative to.
    fn scale(&self) -> f64 {
        let h = self.interval.length_s();
        let of = |number: usize| {
            let [a, b] = self.states(number);
            let load = a.load.force.length().max(b.load.force.length()) / a.mass_kg;
            h * load
                + (b.velocity.linear - a.velocity.linear).length()
                + (b.velocity.angular - a.velocity.angular).length() * a.size_m
        };
        (0..self.bodies.len()).map(of).fold(0.0, f64::max)
    }

    /// What bodies need, and which velocity is nothing, m/s.
    fn needs(&self, about: About) -> (Needs, f64) {
        let mut needs = Needs::default();
        let h = self.interval.length_s();
        let mut allowed = self.interval.observer.tolerance * self.scale();
        for (number, body) in self.bodies.iter().enumerate() {
            let [a, b] = self.states(number);
            let middle = self.interval.middle.movable.get(body.index()).and_then(Option::as_ref).unwrap_or(a);
            let all = [a, middle, b];
            let (given, error) = self.interval.integral_of(all.map(|own| own.load.force));
            let center = middle.center_m;
            let moment = |own: &MovableState| {
                let Wrench { force, torque } = own.load;
                match about {
                    About::Moving => torque,
                    About::Middle => torque + (own.center_m - center).cross(force),
                }
            };
            let (turned, turn_error) = self.interval.integral_of(all.map(moment));
            let momentum = |own: &MovableState| match about {
                About::Moving => own.angular_momentum,
                About::Middle => {
                    own.angular_momentum + (own.center_m - center).cross(own.velocity.linear * own.mass_kg)
                }
            };
            let inverse = 1.0 / a.mass_kg;
            needs.masses.push((inverse, b.inverse_inertia));
            needs.sizes.push(a.size_m);
            let change = (b.velocity.linear - a.velocity.linear) * a.mass_kg;
            needs.impulses.push([change - given, momentum(b) - momentum(a) - turned]);
            let trace = b.inverse_inertia.x_axis.x + b.inverse_inertia.y_axis.y + b.inverse_inertia.z_axis.z;
            let far = 1.0 + b.center_m.length() / a.size_m.max(f64::MIN_POSITIVE);
            let speed = self.interval.speeds(*body).into_iter().fold(0.0, f64::max);
            let place = self.interval.place;
            let unknown: f64 = [place - 1, place]
                .map(|place| self.interval.observer.given.velocity_error(place, body.index()))
                .into_iter()
                .sum();
            let rounding = ROUNDING * (speed + far * h * a.load.force.length() * inverse);
            allowed += error * inverse + turn_error * trace * a.size_m + unknown + rounding;
        }
        (needs, allowed)
    }

    /// What the moment of a force with an arm of 1 m does, in speeds of points for the speed that the force gives, 1/m.
    fn leverage(&self) -> f64 {
        let of = |number: usize| {
            let [a, _] = self.states(number);
            let inverse = a.inverse_inertia;
            a.mass_kg * a.size_m * (inverse.x_axis.x + inverse.y_axis.y + inverse.z_axis.z)
        };
        (0..self.bodies.len()).map(of).fold(0.0, f64::max)
    }

    /// The centre of mass that moments are about at an end (0, 1) or in the middle.
    fn center(&self, body: BodyId, about: About, state: Option<&MovableState>) -> Option<DVec3> {
        match about {
            About::Moving => state.map(|own| own.center_m),
            About::Middle => self.interval.middle.movable.get(body.index())?.as_ref().map(|own| own.center_m),
        }
    }

    /// How far points at which forces act are from straight lines, m.
    fn bend(&self, about: About) -> f64 {
        let times: [&[Option<MovableState>]; 3] =
            [&self.interval.ends[0].movable, &self.interval.middle.movable, &self.interval.ends[1].movable];
        let mut most: f64 = 0.0;
        for own in self.meetings.iter().filter(|own| self.interval.touches(own)) {
            let ([Some(a), Some(b)], Some(middle)) = (own.ends, own.middle) else { continue };
            if a.points.len() != middle.points.len() || b.points.len() != middle.points.len() {
                continue;
            }
            for body in a.bodies {
                let arms = |time: usize, point: &NearPoint| {
                    let state = times[time].get(body.index())?.as_ref();
                    Some(point.point_m - self.center(body, about, state)?)
                };
                for ((a, m), b) in a.points.iter().zip(&middle.points).zip(&b.points) {
                    let (Some(a), Some(m), Some(b)) = (arms(0, a), arms(1, m), arms(2, b)) else { continue };
                    most = most.max(off_line([a, m, b]));
                }
            }
        }
        for ((a, m), b) in self.held[0].iter().zip(&self.held[1]).zip(&self.held[2]) {
            for ((a, m), b) in a.rows.iter().flatten().zip(m.rows.iter().flatten()).zip(b.rows.iter().flatten()) {
                let arm = |time: usize, (body, force, moment): &(BodyId, DVec3, DVec3)| {
                    let state = times[time].get(body.index()).and_then(Option::as_ref);
                    let shift = state.and_then(|own| Some(own.center_m - self.center(*body, about, Some(own))?));
                    *moment + shift.unwrap_or(DVec3::ZERO).cross(*force)
                };
                let turned = ((a.1 + b.1) * 0.5 - m.1).length();
                most = most.max(((arm(0, a) + arm(2, b)) * 0.5 - arm(1, m)).length()).max(turned);
            }
        }
        most
    }

    /// What turning of the slip hides of friction, m/s.
    fn turned(&self) -> f64 {
        let mut most: f64 = 0.0;
        for own in &self.meetings {
            let [Some(a), Some(b)] = own.ends else { continue };
            for (a, b) in a.points.iter().zip(&b.points) {
                let (Some(a), Some(b)) = (a.slip_m_s, b.slip_m_s) else { continue };
                let (Some(a), Some(b)) = (a.try_normalize(), b.try_normalize()) else { continue };
                most = most.max(1.0 - (0.5 * (1.0 + a.dot(b))).max(0.0).sqrt());
            }
        }
        most * self.scale()
    }

    /// Whether something acts at a joint that is not asked for: a stop, friction, what moves its other body.
    fn has_unknown_joints(&self) -> bool {
        self.meetings.iter().flat_map(|own| own.ends).flatten().any(is_joint)
    }

    /// What can act, by a law.
    fn reactions(&self, asked: Asked, about: About) -> Vec<Reaction> {
        let mut all = Vec::new();
        for meeting in self.meetings.iter().filter(|own| self.interval.touches(own)) {
            let same = meeting.ends[0].zip(meeting.ends[1]).filter(|(a, b)| is_same(a, b));
            for end in if same.is_some() { 1..2 } else { 0..2 } {
                let Some(pair) = meeting.ends[end].filter(|own| self.interval.touches_at(Some(*own))) else { continue };
                self.of_pair((asked, about), (end, pair), &mut all);
            }
        }
        for (end, held) in [(0, &self.held[0]), (1, &self.held[2])] {
            for row in held.iter().flat_map(|own| &own.rows) {
                let entries = row.iter().filter_map(|(body, force, moment)| {
                    let number = self.bodies.binary_search(body).ok()?;
                    let own = self.states(number)[end];
                    let shift = own.center_m - self.center(*body, about, Some(own))?;
                    Some((number, [*force, *moment + shift.cross(*force)]))
                });
                all.push(Reaction::Row(entries.collect()));
            }
        }
        all
    }

    fn of_pair(&self, (asked, about): (Asked, About), (end, pair): (usize, &NearPair), all: &mut Vec<Reaction>) {
        let material = self.interval.observer.material(pair);
        let moves = |point: DVec3| -> Ends {
            let mut ends = pair.bodies.map(|body| {
                let number = self.bodies.binary_search(&body).ok()?;
                Some((number, point - self.center(body, about, Some(self.states(number)[end]))?))
            });
            // A joint with the world has its contacts between its body and itself.
            if pair.bodies[0] == pair.bodies[1] {
                ends[1] = None;
            }
            ends
        };
        let resists = material.rolling_friction() > 0.0 || material.spinning_friction() > 0.0;
        for point in &pair.points {
            let (ends, normal) = (moves(point.point_m), point.normal);
            let Some(slip) = point.slip_m_s else {
                all.extend(any_wrench(ends, Kind::All));
                continue;
            };
            // Friction along and across a grain is held against the larger of both.
            let ellipses = [material.static_ellipse(), material.friction_ellipse()];
            let friction = ellipses.into_iter().flat_map(|own| [own.along, own.across]).fold(0.0, f64::max);
            all.push(match asked {
                Asked::Coulomb if material.grain_direction().is_none() && self.slides(pair, slip) => {
                    let direction = normal - slip.normalize_or_zero() * material.friction();
                    Reaction::Along { ends, direction }
                }
                Asked::Coulomb | Asked::Cones => Reaction::Cone { ends, normal, friction },
                Asked::Pushes => Reaction::Push { ends, normal },
                Asked::Any => {
                    all.extend(any_wrench(ends, Kind::Forces));
                    continue;
                }
            });
            if resists {
                all.extend(any_wrench(ends, Kind::Moments));
            }
        }
    }

    /// Whether a contact slides.
    fn slides(&self, pair: &NearPair, slip: DVec3) -> bool {
        let speed = pair.bodies.iter().flat_map(|body| self.interval.speeds(*body)).fold(0.0, f64::max);
        let unknown: f64 = pair
            .bodies
            .iter()
            .map(|body| {
                let given = self.interval.observer.given;
                let errors =
                    [self.interval.place - 1, self.interval.place].map(|at| given.velocity_error(at, body.index()));
                errors[0].max(errors[1])
            })
            .sum();
        slip.length() > self.interval.observer.tolerance * (self.scale() + speed) + ROUNDING * speed + unknown
    }

    /// Whether bodies of the group may strike each other between the ends.
    fn strikes(&self) -> bool {
        self.meetings.iter().any(|own| self.interval.may_strike(own))
    }

    /// Whether contacts take or give energy that is not known.
    fn note_energy(&self, acted: &mut Acted) {
        let observer = self.interval.observer;
        let is_unknown = self.strikes() || self.has_unknown_joints();
        let pairs = || self.meetings.iter().filter(|own| self.interval.touches(own) || self.interval.may_strike(own));
        let losing = pairs().flat_map(|own| own.ends).flatten().any(|pair| {
            let material = observer.material(pair);
            let rubs = material.static_friction() > 0.0 || material.friction() > 0.0;
            is_joint(pair) || material.restitution() < 1.0 || rubs
        });
        let resists = pairs().flat_map(|own| own.ends).flatten().any(|pair| {
            let material = observer.material(pair);
            let of_rotation = material.rolling_friction() > 0.0 || material.spinning_friction() > 0.0;
            of_rotation || material.grain_direction().is_some()
        });
        if (is_unknown && losing) || resists {
            acted.taken_j[1] = f64::INFINITY;
        }
        let held = || self.held.iter().flatten();
        acted.is_driven |= observer.evaluation.has_prescribed_coordinates() && held().next().is_some();
        let bodies = pairs().flat_map(|own| own.ends).flatten().flat_map(|pair| pair.bodies);
        acted.is_driven |= bodies.chain(held().flat_map(|own| own.bodies)).any(|body| {
            let own = observer.scene.bodies().get(body.index());
            own.is_some_and(|own| own.motion().is_some() || own.velocity_of_surface() != DVec3::ZERO)
        });
    }

    /// What friction takes: at least something only where no strike is part of the impulses.
    fn note_friction(&self, acted: &mut Acted, left: &Left, about: About) {
        let (mut number, strikes) = (0, self.strikes());
        for meeting in self.meetings.iter().filter(|own| self.interval.touches(own)) {
            let all = meeting.ends.iter().flatten().flat_map(|own| &own.points).filter_map(|own| own.slip_m_s);
            let (least, most) = all.fold((f64::INFINITY, 0.0_f64), |(least, most), slip| {
                (least.min(slip.length()), most.max(slip.length()))
            });
            let same = meeting.ends[0].zip(meeting.ends[1]).filter(|(a, b)| is_same(a, b));
            for end in if same.is_some() { 1..2 } else { 0..2 } {
                let Some(pair) = meeting.ends[end].filter(|own| self.interval.touches_at(Some(*own))) else { continue };
                let friction = self.interval.observer.material(pair).friction();
                let mut own = Vec::new();
                self.of_pair((Asked::Coulomb, about), (end, pair), &mut own);
                for reaction in &own {
                    let impulse = left.impulses.get(number).copied().unwrap_or(0.0);
                    number += 1;
                    if matches!(reaction, Reaction::Along { .. }) {
                        acted.taken_j[0] += if strikes { 0.0 } else { friction * impulse * least };
                        acted.taken_j[1] += friction * impulse * most;
                    } else if most > 0.0 && matches!(reaction, Reaction::Cone { .. }) {
                        acted.taken_j[1] += friction * impulse * most;
                    }
                }
            }
        }
    }
}

/// What can act at a joint or against turning.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Forces,
    Moments,
    All,
}

/// Impulses of both signs between two bodies.
fn any_wrench(ends: Ends, kind: Kind) -> Vec<Reaction> {
    let mut all = Vec::new();
    for axis in DVec3::AXES {
        let row = |of: &dyn Fn(DVec3, f64) -> [DVec3; 2]| {
            let entries = ends.into_iter().zip([1.0, -1.0]);
            Reaction::Row(entries.filter_map(|(end, sign)| Some((end?.0, of(end?.1, sign)))).collect())
        };
        if kind != Kind::Moments {
            all.push(row(&|arm, sign| [axis * sign, arm.cross(axis * sign)]));
        }
        if kind != Kind::Forces {
            all.push(row(&|_, sign| [DVec3::ZERO, axis * sign]));
        }
    }
    all
}

/// How far the middle of three is from the line through the others, m.
fn off_line([a, middle, b]: [DVec3; 3]) -> f64 {
    let off = middle - (a + b) * 0.5;
    let along = (b - a).try_normalize().filter(|_| (b - a).length() > 2.0 * off.length());
    along.map_or(off.length(), |along| off.reject_from_normalized(along).length())
}

/// Whether bodies touch at the stop, the bearing or the motor of a joint.
fn is_joint(pair: &NearPair) -> bool {
    pair.points.iter().any(|own| own.slip_m_s.is_none())
}

/// Whether two samples have the same contacts, to the bit: bodies at rest.
fn is_same(a: &NearPair, b: &NearPair) -> bool {
    a.points == b.points
}

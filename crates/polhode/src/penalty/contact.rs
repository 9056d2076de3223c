//! One contact: its springs, the mode that they are in, and its force in a state.
//!
//! d is the overlap (m), u the slip of A over B (m/s), T = -F_t the force of the tangential spring on B (N).
//!
//! ```text
//! F_n = normal spring (d, d')                                  never pulls
//! stick:  T' = k_t u + T min(k_t'/k_t, 0) + n x n' x T         force T + c u,  |T + c u| <= mu_s F_n
//! yield:  T' = k_t s' + ..,  force T + c s' = mu F_n e           e along T + c u,  |T + c u| > mu_s F_n
//! slide:  T = mu F_n e,  e' = k_t/(mu F_n) (u - (u.e) e)         where c = 0, as long as u.e > (mu F_n' - mu F_n min(k_t'/k_t, 0))/k_t
//! regularised:  T = mu F_n u/sqrt(u^2 + u_s^2)                 along a grain: T = F_n (mu^2 u/|mu u|) |u|/sqrt(u^2 + u_s^2), mu a matrix
//! rolling, spinning:  M = -c F_n w/sqrt(w^2 + w_s^2)           w the part of the relative rotation across, along the normal
//! ```
//!
//! While the normal force falls the stiffness k_t of Mindlin falls, and the spring gives up force in proportion; while it rises
//! the force stays. Either way the elastic energy T^2/(2 k_t) never rises but by work of slip: what it loses, `T^2 |k_t'|/(2 k_t^2)`,
//! is friction in the annulus of micro-slip. (The common `T = k_t s` creates energy when it is loaded at small and unloaded at
//! large normal force.) e is the direction of T; the tangent vectors are carried along with the normal.
//!
//! **At rest.** A load that comes at once, or a body that stops, swings a spring without damping to twice
//! what statics asks and more. A spring that holds has a damper c there, critical for the mass that the contact bears (`laws`) and in proportion to the normal force: what bears nothing damps nothing. Spring and damper in
//! parallel, and a slider in series with both: what passes through the slider is their sum, which Coulomb's law bounds. Where
//! spring and damper would bear more, the slider takes the rest of the slip, `u - s' = (abs(T + c u) - mu F_n)/c`, along the force, and the damper has the rate of the spring
//! s' alone. Force and rates are continuous where a contact begins to yield and where it holds again, so that
//! neither needs a mode, and fixed steps and error-controlled ones follow one law.
//!
//! Static friction becomes kinetic with the speed of the slider: `mu = mu_k + (mu_s - mu_k) exp(-(l/v_0)^2)` with `l = (|T + c u| - mu_s F_n)/c` (the curve of Stribeck),
//! `v_0 = sqrt(g d)`, at which weight alone compresses springs. What does not slide has mu_s, however its points share their load.
//!
//! The tangential force acts at the middle of the overlap of two bodies that move, so that momentum is kept; against a body
//! that forces do not move it acts on the undeformed surface of the other one, whose lever is that of the rigid body.
//! Source: docs/REFERENCES.md, Mindlin and Deresiewicz; Johnson. How it fails: features that no longer define a contact
//! give no force.

use super::laws::{ContactLaw, Coulomb, Holding, Resistance};
use crate::collision::contact_id::ContactId;
use crate::world::World;
use polhode_contact::ContactKinematics;
use polhode_dynamics::BodyState;
use polhode_response::penalty::{Growth, NormalSpring, TangentialSpring};
use polhode_spatial::DVec3;

/// Numbers of a spring: its vector.
pub(super) const SPRING: usize = 3;

/// What the normal spring does at present.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Push {
    /// A step under error control has frozen that it pushes: its law is continued smoothly past where it would pull.
    On,
    /// The same, that it would pull: no force.
    Off,
    /// A fixed step does not know: the law as it is, which never pulls.
    Cut,
}

/// What friction does at present.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Grip {
    /// No friction, or regularised: there is no tangential spring.
    Free,
    /// The tangential spring holds; `vector` is T.
    Stick,
    /// It gives way against its damper; `vector` is T.
    Yield,
    /// It gives way and has no damper; `vector` is the direction e.
    Slide,
    /// A fixed step does not know: `vector` is T of a spring that holds or yields; without a damper the force is cut to Coulomb's limit.
    Cut,
}

/// What is measured of a contact from its begin to its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Passage {
    pub(super) begun_s: f64,
    /// Rate of approach at the begin, m/s.
    pub(super) approach: f64,
    /// m.
    pub(super) deepest: f64,
    /// N.
    pub(super) hardest: f64,
    /// Whether no other contact acted on its bodies meanwhile.
    pub(super) alone: bool,
}

/// A contact whose bodies overlap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ContactSpring {
    pub(super) id: ContactId,
    pub(super) normal: NormalSpring,
    pub(super) tangential: TangentialSpring,
    pub(super) holding: Holding,
    pub(super) friction: Option<Coulomb>,
    pub(super) resistance: Option<Resistance>,
    pub(super) restitution: f64,
    /// Effective mass along the normal at the begin, kg.
    pub(super) mass: f64,
    pub(super) push: Push,
    /// Whether the overlap grows.
    pub(super) loading: bool,
    pub(super) grip: Grip,
    /// T or e, by `grip`.
    pub(super) vector: DVec3,
    pub(super) passage: Passage,
}

/// A contact in a state.
#[derive(Debug, Clone, Copy)]
pub(super) struct Evaluated {
    pub(super) kinematics: ContactKinematics,
    /// m and m/s.
    pub(super) depth: f64,
    pub(super) rate: f64,
    /// u, m/s; zero without friction.
    pub(super) slip: DVec3,
    pub(super) normal_rate: DVec3,
    /// Direction and coefficient of sliding friction along a grain; none without one.
    pub(super) grained: Option<(DVec3, f64)>,
    /// Angular velocity of A relative to B, rad/s; zero where nothing resists it.
    pub(super) rotation: DVec3,
    /// Where the forces act.
    pub(super) point: DVec3,
}

/// The forces of a contact, and what they do.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Force {
    /// On A, N.
    pub(super) on_a: DVec3,
    /// Along the normal, N.
    pub(super) normal: f64,
    /// On A, in the tangent plane, N.
    pub(super) tangential: DVec3,
    /// Of friction of rolling and spinning, on A, N m.
    pub(super) moment: DVec3,
    /// Power taken by the damper, W.
    pub(super) damping: f64,
    /// Power taken by friction, W: of a contact that slides or is cut with what its spring takes up.
    pub(super) friction: f64,
    /// Rate of `ContactSpring::vector`.
    pub(super) vector_rate: DVec3,
}

impl Force {
    /// With the force on B in the tangent plane (N), the power that friction takes of it (W) and the rate of the vector, and the power of a damper (W).
    fn with_tangential(self, (on_b, power, vector_rate): (DVec3, f64, DVec3), damping: f64) -> Self {
        Self {
            on_a: self.on_a - on_b,
            tangential: -on_b,
            friction: self.friction + power,
            damping: self.damping + damping,
            vector_rate,
            ..self
        }
    }
}

impl ContactSpring {
    /// A contact that begins at `t` (s) in this state.
    pub(super) fn begun(id: ContactId, law: ContactLaw, at: &Evaluated, t: f64) -> Self {
        let passage = Passage { begun_s: t, approach: at.rate, deepest: at.depth.max(0.0), hardest: 0.0, alone: true };
        let mut spring = Self {
            id,
            normal: law.normal,
            tangential: law.tangential,
            holding: law.holding,
            friction: law.friction,
            resistance: law.resistance,
            restitution: law.restitution,
            mass: law.mass,
            push: Push::On,
            loading: at.rate >= 0.0,
            grip: Grip::Free,
            vector: DVec3::ZERO,
            passage,
        };
        if law.friction.is_some_and(|friction| friction.slip_speed.is_none()) {
            spring.grip = Grip::Stick;
            if spring.is_damped() {
                if spring.beyond_static(at) > 0.0 {
                    spring.grip = Grip::Yield;
                }
            } else if spring.slides_from_the_begin(at) {
                spring.grip = Grip::Slide;
                spring.vector = at.slip.normalize_or_zero();
            }
        }
        spring
    }

    /// Whether its tangential spring has a damper.
    pub(super) fn is_damped(&self) -> bool {
        self.holding.damper > 0.0 && self.holding.load > 0.0
    }

    /// c under a normal force (N), N s/m.
    fn damper(&self, normal: f64) -> f64 {
        self.holding.damper * (normal / self.holding.load).max(0.0)
    }

    /// That of a spring that yields: its force tends to that of the slider no faster than it would swing.
    fn yielding_damper(&self, normal: f64) -> f64 {
        self.damper(normal).max(SLOWEST_YIELD * self.holding.damper)
    }

    /// The force of spring and damper on B if the contact held, N.
    fn trial(&self, at: &Evaluated, normal: f64) -> DVec3 {
        in_plane(self.vector, at.kinematics.geometry.normal) + at.slip * self.damper(normal)
    }

    /// What that is beyond static friction, N.
    pub(super) fn beyond_static(&self, at: &Evaluated) -> f64 {
        let normal = self.normal_force(at);
        let at_rest = self.friction.map_or(0.0, |friction| friction.at_rest);
        self.trial(at, normal).length() - at_rest * normal
    }

    /// Coulomb's limit where a damped spring is beyond static friction by a force (N), under a normal force (N): N.
    pub(super) fn yielding_limit(&self, beyond: f64, normal: f64) -> f64 {
        self.friction.map_or(0.0, |friction| {
            let ratio = beyond / (self.yielding_damper(normal) * self.holding.kinetic_from);
            let left = if ratio == 0.0 { 1.0 } else { libm::exp(-ratio * ratio) };
            (friction.sliding + (friction.at_rest - friction.sliding) * left) * normal
        })
    }

    /// The tangential force on B of a spring with a damper (N), and the rate at which it is stretched (m/s): of the mode.
    fn damped(&self, at: &Evaluated, normal: f64) -> (DVec3, DVec3) {
        let trial = self.trial(at, normal);
        // A fixed step knows contacts that do not press: they are not stretched.
        if self.grip == Grip::Cut && normal <= 0.0 {
            return (DVec3::ZERO, trial / -self.yielding_damper(normal));
        }
        let beyond = self.beyond_static(at);
        if self.grip == Grip::Stick || (self.grip == Grip::Cut && beyond <= 0.0) {
            return (trial, at.slip);
        }
        let (along, limit) = (trial.normalize_or_zero(), self.yielding_limit(beyond, normal));
        let slider = (trial.length() - limit) / self.yielding_damper(normal);
        (along * limit, at.slip - along * slider)
    }

    /// Whether it slips.
    pub(super) fn slips(&self) -> bool {
        matches!(self.grip, Grip::Yield | Grip::Slide)
    }

    /// Whether friction takes up more than slip, so that the elastic energy of its spring is part of what it takes.
    pub(super) fn gives_way(&self) -> bool {
        self.slips() || self.grip == Grip::Cut
    }

    /// Its numbers in a flat state.
    pub(super) fn numbers(&self) -> [f64; SPRING] {
        self.vector.to_array()
    }

    /// The same contact with its numbers of a flat state.
    pub(super) fn with_numbers(&self, numbers: &[f64]) -> Self {
        let Some(&vector) = numbers.first_chunk::<SPRING>() else { return *self };
        Self { vector: DVec3::from_array(vector), ..*self }
    }

    /// Whether the tangential force would grow faster than Coulomb's limit from the instant at which both are zero.
    fn slides_from_the_begin(&self, at: &Evaluated) -> bool {
        let Some(friction) = self.friction else { return false };
        // What both have become at a small overlap, which the bodies reach at the present speeds, decides.
        let depth = SMALL_DEPTH * self.normal.impact_depth(self.mass, at.rate.abs());
        if depth <= 0.0 || at.rate <= 0.0 {
            return at.slip.length() > 0.0;
        }
        let power = match self.normal.growth() {
            Growth::Linear => 1.0,
            Growth::Hertz => 1.5,
        };
        let tangential = self.tangential.stiffness(depth) * at.slip.length() * depth / (power * at.rate);
        tangential > friction.at_rest * self.normal.unclipped(depth, at.rate)
    }

    /// Coulomb's limit at a normal force (N), N: of the mode.
    pub(super) fn limit(&self, normal: f64) -> f64 {
        let coefficient = |friction: Coulomb| match self.grip {
            Grip::Stick | Grip::Cut => friction.at_rest,
            Grip::Free | Grip::Yield | Grip::Slide => friction.sliding,
        };
        self.friction.map_or(0.0, |friction| coefficient(friction) * normal)
    }

    /// The normal force in a state, N: of the mode, negative where a step goes on past the end of the push.
    pub(super) fn normal_force(&self, at: &Evaluated) -> f64 {
        match self.push {
            Push::On => self.normal.continued(at.depth, at.rate),
            Push::Off => 0.0,
            Push::Cut => self.normal.force(at.depth, at.rate),
        }
    }

    /// Elastic energy in a state, J.
    pub(super) fn energy(&self, at: &Evaluated) -> f64 {
        self.normal.energy(at.depth) + self.tangential_energy(at)
    }

    /// Elastic energy of the tangential spring, J.
    pub(super) fn tangential_energy(&self, at: &Evaluated) -> f64 {
        let force = match self.grip {
            Grip::Free => return 0.0,
            Grip::Stick | Grip::Yield => self.vector.length(),
            Grip::Cut if self.is_damped() => self.vector.length(),
            Grip::Slide => self.limit(self.normal_force(at)),
            Grip::Cut => self.vector.length().min(self.limit(self.normal_force(at))),
        };
        self.tangential.energy(at.depth, force)
    }

    /// The forces in a state.
    pub(super) fn force(&self, at: &Evaluated) -> Force {
        let normal = self.normal_force(at);
        let damping = (normal - self.normal.elastic_force(at.depth)) * at.rate;
        let n = at.kinematics.geometry.normal;
        let moment = self.resistance.map_or(DVec3::ZERO, |own| own.moment(normal, (at.rotation, n)));
        let resisted = -moment.dot(at.rotation);
        let along = Force { on_a: n * normal, normal, moment, damping, friction: resisted, ..Force::default() };
        let Some(friction) = self.friction else { return along };
        let slip = at.slip;
        if self.is_damped() && self.grip != Grip::Free {
            let spring = in_plane(self.vector, n);
            let (force, stretching) = self.damped(at, normal);
            let damping = (force - spring).dot(stretching);
            let power = if self.gives_way() { force.dot(slip) - damping } else { self.micro_slip(at) };
            return along.with_tangential((force, power, self.held_rate(at, stretching, spring)), damping);
        }
        let (spring, power, vector_rate) = match self.grip {
            Grip::Free => {
                let speed = friction.slip_speed.unwrap_or(0.0);
                let size = (slip.length_squared() + speed * speed).sqrt();
                let (along, coefficient) = match at.grained {
                    Some((direction, coefficient)) => (direction * slip.length(), coefficient),
                    None => (slip, friction.sliding),
                };
                let spring = if size > 0.0 { along * (coefficient * normal / size) } else { DVec3::ZERO };
                (spring, spring.dot(slip), DVec3::ZERO)
            }
            Grip::Stick => {
                let spring = in_plane(self.vector, n);
                (spring, self.micro_slip(at), self.held_rate(at, slip, spring))
            }
            Grip::Cut => {
                let held = in_plane(self.vector, n);
                let spring = held.clamp_length_max(self.limit(normal));
                (spring, spring.dot(slip), self.held_rate(at, slip, held))
            }
            Grip::Yield | Grip::Slide => {
                let direction = in_plane(self.vector, n).normalize_or_zero();
                let limit = self.limit(normal);
                let spring = direction * limit;
                (spring, spring.dot(slip), self.turning_rate(at, direction, limit))
            }
        };
        along.with_tangential((spring, power, vector_rate), 0.0)
    }

    /// T' of a spring that is stretched at a rate (m/s).
    fn held_rate(&self, at: &Evaluated, stretching: DVec3, spring: DVec3) -> DVec3 {
        stretching * self.tangential.stiffness(at.depth) + spring * self.falling(at) + transport(at, spring)
    }

    /// `k_t'/k_t` while the overlap falls, and zero while it grows, 1/s: of the mode.
    pub(super) fn falling(&self, at: &Evaluated) -> f64 {
        let rate = self.tangential.relative_rate(at.depth, at.rate);
        match (self.push, self.loading) {
            (Push::Cut, _) => rate.min(0.0),
            (Push::On | Push::Off, true) => 0.0,
            (Push::On | Push::Off, false) => rate,
        }
    }

    /// Power of micro-slip, W: what the elastic energy of a spring that holds loses as its stiffness changes.
    fn micro_slip(&self, at: &Evaluated) -> f64 {
        let rate = self.tangential.relative_rate(at.depth, at.rate);
        let rate = match (self.push, self.loading) {
            (Push::Cut, _) => rate.abs(),
            (Push::On | Push::Off, true) => rate,
            (Push::On | Push::Off, false) => -rate,
        };
        self.tangential.energy(at.depth, self.vector.length()) * rate
    }

    /// e' of a spring that slides: it turns towards the slip, the faster the shorter it is.
    fn turning_rate(&self, at: &Evaluated, direction: DVec3, limit: f64) -> DVec3 {
        let across = at.slip - direction * at.slip.dot(direction);
        // In planar motion what is across is rounding, which a short spring would blow up.
        let is_rounding = across.length() <= ACROSS_ROUNDING * at.slip.length();
        if is_rounding || limit <= 0.0 {
            return transport(at, direction);
        }
        let fastest = FASTEST_TURN * self.frequency(self.passage.deepest.max(at.depth)) / at.slip.length();
        across * (self.tangential.stiffness(at.depth) / limit).min(fastest) + transport(at, direction)
    }
}

/// Part of the expected depth at which the begin of a contact is judged (1e-9 to 1e-3).
const SMALL_DEPTH: f64 = 1e-6;

/// Part of the critical damper that a yielding spring relaxes by at least (0.2 to 1): with a half it does so at its frequency at most, which every step follows.
const SLOWEST_YIELD: f64 = 0.5;

/// The direction of sliding turns towards the slip at most at this multiple of the frequency of the normal spring (1 to 20): a spring
/// that is all but empty would turn at once, which no step could follow.
const FASTEST_TURN: f64 = 4.0;

/// Slip across the direction of sliding that is rounding, relative to the slip (1e-15 to 1e-12).
const ACROSS_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The part of a vector in the tangent plane.
fn in_plane(vector: DVec3, normal: DVec3) -> DVec3 {
    vector - normal * normal.dot(vector)
}

/// Rate of a tangent vector that is carried along with the normal.
fn transport(at: &Evaluated, vector: DVec3) -> DVec3 {
    at.kinematics.geometry.normal.cross(at.normal_rate).cross(vector)
}

impl Evaluated {
    /// A contact of which the motion along the normal alone is known.
    pub(super) fn of(kinematics: ContactKinematics) -> Self {
        let (depth, rate) = (-kinematics.geometry.separation, -kinematics.separation_rate);
        let point = kinematics.geometry.point;
        let (slip, normal_rate, rotation) = (DVec3::ZERO, DVec3::ZERO, DVec3::ZERO);
        Self { kinematics, depth, rate, slip, normal_rate, grained: None, rotation, point }
    }

    /// A contact in these states; none where its features no longer define one.
    pub(super) fn new(world: &World, states: &[BodyState], id: ContactId, with_slip: bool) -> Option<Self> {
        let kinematics = world.kinematics(states, id)?;
        let geometry = &kinematics.geometry;
        let point = acting_point(world, id, &kinematics);
        let mut evaluated = Self { point, ..Self::of(kinematics) };
        if world.has_rotational_friction() {
            evaluated.rotation = world.relative_rotation(states, id);
        }
        if with_slip {
            let terms = world.tangential_kinematics(states, id)?;
            let turning = world.relative_rotation(states, id).cross(point - geometry.point);
            evaluated.slip = terms.slip_velocity + in_plane(turning, geometry.normal);
            evaluated.normal_rate = terms.normal_rate;
            if world.has_grain()
                && let Some(coefficients) = world.friction_at(states, id, terms.basis)
            {
                let along = evaluated.slip.try_normalize().unwrap_or(terms.basis[0]);
                evaluated.grained = Some(coefficients.sliding.opposed(terms.basis, along));
            }
        }
        Some(evaluated)
    }
}

/// Where the forces of a contact act: in the middle of the overlap, or on the undeformed surface of the one body that forces
/// move.
fn acting_point(world: &World, id: ContactId, kinematics: &ContactKinematics) -> DVec3 {
    let geometry = &kinematics.geometry;
    let moves = |body: usize| world.bodies[body].rigid.is_some();
    // The point of A is half the separation from the middle, along the normal from B to A.
    let towards_a = geometry.normal * (0.5 * geometry.separation);
    match (moves(id.a), moves(id.b)) {
        (true, false) => geometry.point + towards_a,
        (false, true) => geometry.point - towards_a,
        _ => geometry.point,
    }
}

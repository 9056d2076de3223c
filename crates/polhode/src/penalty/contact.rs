//! One contact: its springs, the mode that they are in, and its force in a state.
//!
//! d is the overlap (m), u the slip of A over B (m/s), T = -F_t the force of the tangential spring on B (N).
//!
//! ```text
//! F_n = normal spring (d, d')                                  never pulls
//! stick:  T' = k_t u + T min(k_t'/k_t, 0) + n x n' x T         |T| <= mu_s F_n,  force T + c u
//! yield, slide:  T = mu_s F_n e, then T = mu F_n e,  e' = k_t/(mu F_n) (u - (u.e) e)
//!               while u.e > (mu F_n' - mu F_n min(k_t'/k_t, 0))/k_t
//! regularised:  T = mu F_n u/sqrt(u^2 + u_s^2)
//!               along a grain: T = F_n (mu^2 u/|mu u|) |u|/sqrt(u^2 + u_s^2), mu a matrix
//! rolling, spinning:  M = -c F_n w/sqrt(w^2 + w_s^2)   w: relative rotation across, along the normal
//! ```
//!
//! While the normal force falls the stiffness k_t of Mindlin falls, and the spring gives up force in proportion; while
//! it rises the force stays. Either way the elastic energy T^2/(2 k_t) never rises but by work of slip: what it loses,
//! `T^2 |k_t'|/(2 k_t^2)`, is friction in the annulus of micro-slip. (The common `T = k_t s` creates energy when it is
//! loaded at small and unloaded at large normal force.) e is the direction of T; the tangent vectors are carried along
//! with the normal.
//!
//! **At rest.** A load that comes at once, or a body that stops, swings a spring without damping to twice
//! what statics asks and more. A spring that holds has a damper c there, critical for the mass that the contact bears
//! (`laws`), and gives way where the spring alone, whose stretch then creeps to that of statics from one side, reaches
//! mu_s F_n: the damper is gone with the motion, as in models of bristles. Points of one body slip a little before all
//! of them hold as much as they can: static friction mu_s acts on (`Yield`), with the damper, until a point has slipped
//! as far as its spring stretches, and kinetic friction mu (`Slide`) until the slip ends. By the damper a load that
//! exceeds static friction by a part e breaks a contact away after some `(2/w)/e`, w the frequency of its spring.
//!
//! The tangential force acts at the middle of the overlap of two bodies that move, so that momentum is kept; against a
//! body that forces do not move it acts on the undeformed surface of the other one, whose lever is that of the rigid
//! body. Source: docs/REFERENCES.md, Mindlin and Deresiewicz; Johnson. How it fails: features that no longer define a
//! contact give no force.

use super::laws::{ContactLaw, Coulomb, Holding, Resistance};
use crate::collision::{contact_kinematics, friction};
use crate::identity::contact_id::ContactId;
use crate::model::Model;
use polhode_contact::ContactKinematics;
use polhode_dynamics::BodyState;
use polhode_response::penalty::{Growth, NormalSpring, TangentialSpring};
use polhode_spatial::DVec3;
use polhode_spatial::rounding;

/// Numbers of a spring: its vector, and how far it has slipped.
pub(super) const SPRING: usize = 4;

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
    /// It gives way under static friction: it has not slipped far; `vector` is the direction e.
    Yield,
    /// It gives way; `vector` is the direction e.
    Slide,
    /// A fixed step does not know: `vector` is T of a spring that holds, and the force is cut to Coulomb's limit at
    /// rest.
    Cut,
    /// The same of one that gave way in the step before: to Coulomb's limit of sliding.
    CutSliding,
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
    /// How far a spring has slipped since it gave way, m, until its friction is kinetic.
    pub(super) slipped: f64,
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
    /// With the force on B in the tangent plane (N), the power that friction takes of it (W) and the rate of the
    /// vector, and the power of a damper (W).
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
            slipped: 0.0,
            passage,
        };
        if law.friction.is_some_and(|friction| friction.slip_speed.is_none()) {
            spring.grip = Grip::Stick;
            // A slip that the damper of a spring that holds would stop at once is none.
            if at.slip.length() > spring.holding.stopped && spring.slides_from_the_begin(at) {
                spring.grip = Grip::Slide;
                spring.vector = at.slip.normalize_or_zero();
            }
        }
        spring
    }

    /// What it does when it gives way.
    pub(super) fn giving_way(&self) -> Grip {
        if self.holding.weakening > 0.0 { Grip::Yield } else { Grip::Slide }
    }

    /// Whether it slides in a direction of its own.
    pub(super) fn slides(&self) -> bool {
        matches!(self.grip, Grip::Yield | Grip::Slide)
    }

    /// Rate of the slip that is followed (m/s).
    pub(super) fn slipping(&self, at: &Evaluated) -> f64 {
        if self.grip == Grip::Yield { at.slip.dot(self.vector.normalize_or_zero()) } else { 0.0 }
    }

    /// Its numbers in a flat state.
    pub(super) fn numbers(&self) -> [f64; SPRING] {
        let [x, y, z] = self.vector.to_array();
        [x, y, z, self.slipped]
    }

    /// The same contact with its numbers of a flat state.
    pub(super) fn with_numbers(&self, numbers: &[f64]) -> Self {
        let Some(&[x, y, z, slipped]) = numbers.first_chunk::<SPRING>() else { return *self };
        Self { vector: DVec3::new(x, y, z), slipped, ..*self }
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
            Grip::Stick | Grip::Yield | Grip::Cut => friction.at_rest,
            _ => friction.sliding,
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
            Grip::Stick => self.vector.length(),
            Grip::Yield | Grip::Slide => self.limit(self.normal_force(at)),
            Grip::Cut | Grip::CutSliding => self.vector.length().min(self.limit(self.normal_force(at))),
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
        let damper = slip * self.holding.damper;
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
                let held = (spring + damper, self.micro_slip(at), self.sticking_rate(at, spring));
                return along.with_tangential(held, damper.dot(slip));
            }
            Grip::Cut | Grip::CutSliding => {
                let held = in_plane(self.vector, n);
                let spring = (held + damper).clamp_length_max(self.limit(normal));
                (spring, spring.dot(slip), self.sticking_rate(at, held))
            }
            Grip::Yield | Grip::Slide => {
                let direction = in_plane(self.vector, n).normalize_or_zero();
                let limit = self.limit(normal);
                let spring = direction * limit;
                let rate = self.turning_rate(at, direction, limit);
                if self.grip == Grip::Yield {
                    return along.with_tangential((spring + damper, spring.dot(slip), rate), damper.dot(slip));
                }
                (spring, spring.dot(slip), rate)
            }
        };
        along.with_tangential((spring, power, vector_rate), 0.0)
    }

    /// T' of a spring that holds.
    fn sticking_rate(&self, at: &Evaluated, spring: DVec3) -> DVec3 {
        at.slip * self.tangential.stiffness(at.depth) + spring * self.falling(at) + transport(at, spring)
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
        let is_rounding = across.length() <= rounding::DOZENS_OF_TERMS * at.slip.length();
        if is_rounding || limit <= 0.0 {
            return transport(at, direction);
        }
        let fastest = FASTEST_TURN * self.frequency(self.passage.deepest.max(at.depth)) / at.slip.length();
        across * (self.tangential.stiffness(at.depth) / limit).min(fastest) + transport(at, direction)
    }
}

/// Part of the expected depth at which the begin of a contact is judged (1e-9 to 1e-3).
const SMALL_DEPTH: f64 = 1e-6;

/// The direction of sliding turns towards the slip at most at this multiple of the frequency of the normal spring (1 to
/// 20): a spring that is all but empty would turn at once, which no step could follow.
const FASTEST_TURN: f64 = 4.0;

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
    pub(super) fn new(model: &Model, states: &[BodyState], id: ContactId, with_slip: bool) -> Option<Self> {
        let kinematics = contact_kinematics::kinematics(model, states, id)?;
        let geometry = &kinematics.geometry;
        let point = acting_point(model, id, &kinematics);
        let mut evaluated = Self { point, ..Self::of(kinematics) };
        if model.surfaces.have_rotational_friction() {
            evaluated.rotation = contact_kinematics::relative_rotation(model, states, id);
        }
        if with_slip {
            let terms = contact_kinematics::tangential_kinematics(model, states, id)?;
            let turning = contact_kinematics::relative_rotation(model, states, id).cross(point - geometry.point);
            evaluated.slip = terms.slip_velocity + in_plane(turning, geometry.normal);
            evaluated.normal_rate = terms.normal_rate;
            if model.surfaces.have_grain()
                && let Some(coefficients) = friction::friction_at(model, states, id, terms.basis)
            {
                let along = evaluated.slip.try_normalize().unwrap_or(terms.basis[0]);
                evaluated.grained = Some(coefficients.sliding.opposed(terms.basis, along));
            }
        }
        Some(evaluated)
    }
}

/// Where the forces of a contact act: in the middle of the overlap, or on the undeformed surface of the one body that
/// forces move.
fn acting_point(model: &Model, id: ContactId, kinematics: &ContactKinematics) -> DVec3 {
    let geometry = &kinematics.geometry;
    let moves = |body: usize| model.bodies[body].rigid.is_some();
    // The point of A is half the separation from the middle, along the normal from B to A.
    let towards_a = geometry.normal * (0.5 * geometry.separation);
    match (moves(id.a), moves(id.b)) {
        (true, false) => geometry.point + towards_a,
        (false, true) => geometry.point - towards_a,
        _ => geometry.point,
    }
}

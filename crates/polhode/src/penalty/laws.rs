//! The springs of a pair of bodies: from the knobs of the scene, the materials, and what a contact must be expected to
//! bear.
//!
//! **Linear.** The overlap is not to be deeper than the stated penetration d, [`STATED_DEPTH_RELATIVE`] of the smallest
//! body that moves when the scene gives none: `k d^2/2 = E + W d` with the energy E and the weight W of
//! [`super::expected`], shared by the points of the pair that are within d of touching when the contact begins.
//!
//! **Hertz.** `k = (4/3) E* sqrt(R)` from moduli and radii (`polhode_response::penalty`).
//!
//! **Damping** from the restitution of the pair, exact for a lone impact: the effective mass along the normal and, for
//! Hunt and Crossley, the speed of approach are taken when the contact begins. Below the speed `sqrt(g d)`, at which
//! weight alone compresses a spring, that speed is taken: a contact at rest has no approach. A restitution below what a
//! damper reaches gets the strongest damping that is used (`Relation::reachable`).
//!
//! **At rest.** A contact that begins slower than `v_0 = sqrt(g d)` bounces no higher than its weight compresses it, so
//! that its damping has no restitution to meet: it is at most critical: the ratio 1 of a plain damper,
//! `a = 2 sqrt(k' m)/F` of Hunt and Crossley's, with the force F and the slope k' of the spring under the weight that
//! it is made for (at d/2), or under that of m where its stiffness is given. For a restitution of 0.01 and a body alone
//! it would be 35 times as strong, and in a stack more: a rate of decay by which explicit steps are that much shorter
//! while nothing moves.
//!
//! **Holding.** A tangential spring that holds a contact at rest, or one whose static friction is above kinetic, is
//! damped critically, `c = 2 sqrt(k_t m)`: m is the mass that the contact bears, its share of W/g, or its effective
//! mass where that is more. Static friction becomes kinetic after a slip of `mu_s F/k_t`, the stretch at which the
//! spring gives way under the load F of the normal damping at rest.
//!
//! Source: docs/REFERENCES.md, Hunt and Crossley. How it fails: a stiffness that is not finite is refused when the
//! contact begins.

use super::expected::{blows, burden, load_on, reduced_mass};
use crate::collision::contact_set;
use crate::collision::turn::Turn;
use crate::identity::contact_id::ContactId;
use crate::model::tolerances::STATED_DEPTH_RELATIVE;
use crate::model::{Model, tolerances};
use crate::scene::spring_checks::elastic_pair;
use crate::scene::{PenaltyMethod, SceneError, SpringLaw};
use polhode_contact::{ContactGeometry, Shape};
use polhode_dynamics::BodyState;
use polhode_response::penalty::{Damping, Growth, NormalSpring, Relation, SpringError, TangentialSpring};
use polhode_spatial::DVec3;

/// Poisson's ratio of a material that gives none, for the ratio of tangential to normal stiffness of linear springs (0
/// to 0.5: the ratio of stiffnesses goes from 1 to 2/3).
const POISSON_RATIO: f64 = 0.3;

/// The speed of slip of regularised friction when none is given, relative to the speed of the scene.
const SLIP_SPEED_RELATIVE: f64 = 1e-3;

/// What the springs of a run follow from.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Laws {
    pub(super) method: PenaltyMethod,
    /// The penetration that linear springs are to keep, m, and that errors are measured by.
    pub(super) depth_m: f64,
    /// Greatest speed at which two bodies of the scene are expected to meet, m/s.
    pub(super) speed: f64,
    /// Square of the speed with which each body may strike others, (m/s)^2.
    pub(super) blows: Vec<f64>,
}

/// Coefficients of friction of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Coulomb {
    pub(super) at_rest: f64,
    pub(super) sliding: f64,
    /// Of regularised friction, m/s; none for a tangential spring.
    pub(super) slip_speed: Option<f64>,
}

/// Friction of rolling and spinning of a contact, regularised: `M = -c F_n w/sqrt(w^2 + w_s^2)` for each part of the
/// rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Resistance {
    /// c of rolling and of spinning, m.
    pub(super) rolling: f64,
    pub(super) spinning: f64,
    /// w_s, rad/s.
    pub(super) rate: f64,
}

impl Resistance {
    /// The moment on A under a normal force (N), of a relative rotation (rad/s) about a normal, N m.
    pub(super) fn moment(&self, normal_force: f64, (rotation, normal): (DVec3, DVec3)) -> DVec3 {
        let of = |turn: Turn, length: f64| {
            let part = turn.part(rotation, normal);
            let size = (part.length_squared() + self.rate * self.rate).sqrt();
            if size > 0.0 { part * (-length * normal_force / size) } else { DVec3::ZERO }
        };
        of(Turn::Rolling, self.rolling) + of(Turn::Spinning, self.spinning)
    }
}

/// What a tangential spring has while it holds.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Holding {
    /// c of its damper, N s/m.
    pub(super) damper: f64,
    /// How far it slips before static friction becomes kinetic, m: zero where both are one.
    pub(super) weakening: f64,
    /// The slip that its damper stops by a force of less than static friction of the load at rest, m/s; zero where both
    /// coefficients are one.
    pub(super) stopped: f64,
}

/// The springs of a contact that begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ContactLaw {
    pub(super) normal: NormalSpring,
    pub(super) tangential: TangentialSpring,
    pub(super) holding: Holding,
    pub(super) friction: Option<Coulomb>,
    pub(super) resistance: Option<Resistance>,
    pub(super) restitution: f64,
    /// Effective mass along the normal, kg.
    pub(super) mass: f64,
}

impl Laws {
    /// Those of a run that begins with these states.
    pub(super) fn new(model: &Model, method: PenaltyMethod, states: &[BodyState]) -> Self {
        let moving = || model.movable.iter().copied().filter(|&body| model.bodies[body].moves());
        let smallest = moving().map(|body| model.bodies[body].size).filter(|size| *size > 0.0);
        let smallest = smallest.fold(f64::INFINITY, f64::min);
        let depth = if smallest.is_finite() { STATED_DEPTH_RELATIVE * smallest } else { STATED_DEPTH_RELATIVE };
        let blows = blows(model, states);
        let mut speeds: Vec<f64> = blows.iter().map(|square| square.sqrt()).collect();
        speeds.sort_by(|x, y| y.total_cmp(x));
        let speed = speeds.iter().take(2).sum();
        Self { method, depth_m: method.penetration_m.unwrap_or(depth), speed, blows }
    }

    /// Takes in a body that a program adds.
    pub(super) fn add_body(&mut self, speed: f64) {
        self.blows.push(speed * speed);
    }

    /// A speed (m/s) below which a contact is at rest: weight alone compresses springs at `sqrt(g d)`.
    pub(super) fn resting_speed(&self, model: &Model) -> f64 {
        (model.gravity().length() * self.depth_m).sqrt()
    }

    /// Speed of slip of regularised friction, m/s.
    fn slip_speed(&self, model: &Model) -> f64 {
        let own = SLIP_SPEED_RELATIVE * self.speed.max(self.resting_speed(model));
        self.method.slip_speed_m_s.unwrap_or(if own > 0.0 { own } else { SLIP_SPEED_RELATIVE })
    }

    /// What resists rolling and spinning at a contact: the speed of slip of regularised friction is that of a rotation
    /// at the length of the pair.
    fn resistance(&self, model: &Model, id: ContactId) -> Option<Resistance> {
        let [rolling, spinning] = [Turn::Rolling, Turn::Spinning].map(|turn| turn.friction(model, (id.a, id.b)));
        let rate = self.slip_speed(model) / tolerances::turning_length(model, id.a, id.b);
        (rolling.is_some() || spinning.is_some()).then(|| Resistance {
            rolling: rolling.unwrap_or(0.0),
            spinning: spinning.unwrap_or(0.0),
            rate,
        })
    }

    /// The springs of a contact that begins at this rate of approach (m/s).
    ///
    /// # Errors
    /// When bodies have no moduli or radii of curvature, or the stiffness is not finite.
    pub(super) fn of_contact(
        &self,
        model: &Model,
        states: &[BodyState],
        (id, geometry): (ContactId, &ContactGeometry),
        approach: f64,
    ) -> Result<ContactLaw, SceneError> {
        let material = model.scene.pair_material(id.a, id.b);
        let mass = effective_mass(model, states, id, geometry);
        let refused = |source: SpringError| SceneError::SpringRestitution {
            materials: [id.a, id.b].map(|body| model.bodies[body].name.clone()),
            source,
        };
        let (spring, tangential) = self.elastic(model, states, (id, geometry), approach)?;
        let relation = self.method.relation();
        let number = relation.number_for(relation.reachable(material.restitution())).map_err(refused)?;
        let resting_speed = self.resting_speed(model);
        let rests = approach < resting_speed;
        let normal = match relation {
            Relation::Plain => spring.with_plain_damping(if rests { number.min(1.0) } else { number }, mass),
            Relation::HuntCrossley => {
                let speed = approach.max(resting_speed);
                let a = if speed > 0.0 { number / speed } else { 0.0 };
                let a = if rests { a.min(self.critical_at_rest(model, &spring, mass)) } else { a };
                spring.with_damping(Damping::HuntCrossley(a))
            }
        };
        let at_rest = material.static_ellipse().largest();
        let friction = (at_rest > 0.0).then(|| Coulomb {
            at_rest,
            sliding: material.friction_ellipse().largest(),
            slip_speed: self.method.is_regularised(&material).then(|| self.slip_speed(model)),
        });
        let resistance = self.resistance(model, id);
        let own = friction.filter(|own| own.slip_speed.is_none() && (rests || own.at_rest > own.sliding));
        let holding = own.map_or_else(Holding::default, |own| {
            let depth = self.depth_at_rest(model, &normal, mass);
            let stiffness = tangential.stiffness(depth);
            let borne = self.borne_mass(model, states, (id, geometry)).max(mass);
            let is_weaker = stiffness > 0.0 && own.at_rest > own.sliding;
            let weakening = if is_weaker { own.at_rest * normal.elastic_force(depth) / stiffness } else { 0.0 };
            let damper = 2.0 * (stiffness * borne).sqrt();
            let stopped = if weakening > 0.0 { weakening * stiffness / damper } else { 0.0 };
            Holding { damper, weakening, stopped }
        });
        let restitution = material.restitution();
        Ok(ContactLaw { normal, tangential, holding, friction, resistance, restitution, mass })
    }

    /// The mass that may rest on one of the points of a pair, kg; zero without gravity.
    fn borne_mass(&self, model: &Model, states: &[BodyState], (id, geometry): (ContactId, &ContactGeometry)) -> f64 {
        let gravity = model.gravity().length();
        if gravity <= 0.0 {
            return 0.0;
        }
        load_on(model, states, id) / (gravity * self.sharing(model, states, (id, geometry)))
    }

    /// Overlap (m) of a contact that carries what its spring is made for, or its own weight.
    fn depth_at_rest(&self, model: &Model, spring: &NormalSpring, mass: f64) -> f64 {
        let is_made_for_load = spring.growth() == Growth::Linear && self.method.stiffness_n_m.is_none();
        let own_weight = || spring.static_depth(mass * model.gravity().length());
        if is_made_for_load { 0.5 * self.depth_m } else { own_weight() }
    }

    /// The factor `a` (s/m) of Hunt and Crossley's damper with which a contact that carries what its spring is made for
    /// is critically damped.
    fn critical_at_rest(&self, model: &Model, spring: &NormalSpring, mass: f64) -> f64 {
        let depth = self.depth_at_rest(model, spring, mass);
        2.0 * (spring.slope(depth) * mass).sqrt() / spring.elastic_force(depth)
    }

    /// Stiffness of a linear spring, N/m.
    fn stiffness(
        &self,
        model: &Model,
        states: &[BodyState],
        (id, geometry): (ContactId, &ContactGeometry),
        approach: f64,
    ) -> f64 {
        let [load, energy] = burden(model, states, id, (approach, self.speed), &self.blows);
        let needed = NormalSpring::stiffness_for(Growth::Linear, self.depth_m, load, energy);
        // Without weight and speed anything keeps bodies apart: a spring that a mass swings on once a second.
        let needed = if needed > 0.0 { needed } else { reduced_mass(model, id) };
        needed / self.sharing(model, states, (id, geometry))
    }

    /// The number of points of a pair within the stated penetration of touching.
    fn sharing(&self, model: &Model, states: &[BodyState], (id, geometry): (ContactId, &ContactGeometry)) -> f64 {
        let reach = geometry.separation.max(0.0) + self.depth_m;
        let points = contact_set::contacts_of_pair(model, states, id.a, id.b, reach).into_iter();
        let sharing = points.filter(|point| point.kinematics.geometry.separation <= reach).count();
        sharing.max(1) as f64
    }

    /// Springs without damping.
    fn elastic(
        &self,
        model: &Model,
        states: &[BodyState],
        (id, geometry): (ContactId, &ContactGeometry),
        approach: f64,
    ) -> Result<(NormalSpring, TangentialSpring), SceneError> {
        let materials = model.scene.pair_materials(id.a, id.b);
        let names = || [id.a, id.b].map(|body| model.bodies[body].name.clone());
        let refused = |source: SpringError| SceneError::SpringRestitution { materials: names(), source };
        match self.method.law.unwrap_or_default() {
            SpringLaw::Hertz => {
                let pair = elastic_pair(materials[0], materials[1])?;
                let radius = effective_radius(model, id)
                    .ok_or_else(|| SceneError::HertzShape { body: model.bodies[id.a].name.clone() })?;
                let spring = NormalSpring::elastic(Growth::Hertz, pair.hertz_stiffness(radius)).map_err(refused)?;
                Ok((spring, TangentialSpring::mindlin(&pair, radius)))
            }
            SpringLaw::Linear => {
                let stiffness = self.method.stiffness_n_m;
                let stiffness = stiffness.unwrap_or_else(|| self.stiffness(model, states, (id, geometry), approach));
                let spring = NormalSpring::elastic(Growth::Linear, stiffness).map_err(refused)?;
                let ratios =
                    materials.iter().filter_map(|material| material.elastic_constants().map(|[_, ratio]| ratio));
                let poisson =
                    ratios.fold(None, |known: Option<f64>, own| Some(known.map_or(own, |known| known.max(own))));
                Ok((spring, TangentialSpring::beside_linear(stiffness, poisson.unwrap_or(POISSON_RATIO))))
            }
        }
    }
}

/// Effective mass along the normal of a contact, `1/(n . (sum 1/m + I^-1 (r x n) x r) n)`, kg.
fn effective_mass(model: &Model, states: &[BodyState], id: ContactId, geometry: &ContactGeometry) -> f64 {
    let of_body = |body: usize| {
        let Some(rigid) = &model.bodies[body].rigid else { return 0.0 };
        let state = &states[body];
        let arm: DVec3 = (geometry.point - state.pose.translation).cross(geometry.normal);
        rigid.inverse_mass() + arm.dot(rigid.inverse_inertia_world(state.pose.rotation) * arm)
    };
    let inverse = of_body(id.a) + of_body(id.b);
    if inverse > 0.0 { 1.0 / inverse } else { 1.0 }
}

/// Effective radius of curvature, m: of balls; what is not a ball is flat. None without a ball.
fn effective_radius(model: &Model, id: ContactId) -> Option<f64> {
    let curvature = |body: usize| match &model.bodies[body].shape {
        Some(Shape::Sphere(ball)) => 1.0 / ball.radius(),
        _ => 0.0,
    };
    let sum = curvature(id.a) + curvature(id.b);
    (sum > 0.0).then(|| 1.0 / sum)
}

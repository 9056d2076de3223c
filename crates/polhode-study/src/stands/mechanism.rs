//! The motion that begins: which body moves how, and where the hinges are.
//!
//! Two bodies A and B that touch at points p with normals n (from B to A) part at the rate
//!
//! ```text
//! c(p) = n . (v_A(p) - v_B(p)),     v(p) = v_cm + w x (p - p_cm)
//! ```
//!
//! (m/s, of a motion whose fastest body moves at 1 m/s). Where some points of a pair part and others stay closed, the
//! two turn about those that stay: these are a hinge (Heyman 1966). Limit analysis lets what slides part by the angle
//! of friction, so that a pair that slides has no hinge unless it also turns.

use polhode::spatial::DVec3;
use polhode::stability::MovingBody;
use polhode::{BodyId, ContactView, Scene, Stability};
use std::collections::BTreeMap;

/// Points of a pair that part this slowly against the fastest of them, or against the fastest body, stay closed (no
/// unit, 1e-4 to 1e-2): the tolerance of the analysis is far below.
const CLOSED_RELATIVE: f64 = 1e-3;

/// When a motion begins.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Begins {
    /// Now: nothing holds the bodies.
    Now,
    /// When every body is pushed more than this part of its weight in this direction.
    AtPush {
        /// The direction (unit vector, world).
        direction: DVec3,
        /// The part (no unit).
        of_weight: f64,
    },
}

/// Two bodies that turn about points at which they touch.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Hinge {
    /// The two bodies.
    pub bodies: [BodyId; 2],
    /// The points that stay closed, world, m.
    pub points_m: Vec<DVec3>,
}

impl Hinge {
    /// The middle of its points, m.
    pub fn middle_m(&self) -> DVec3 {
        self.points_m.iter().copied().sum::<DVec3>() / self.points_m.len().max(1) as f64
    }
}

/// The motion that begins.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Mechanism {
    /// When.
    pub begins: Begins,
    /// The bodies that move, the fastest first.
    pub bodies: Vec<MovingBody>,
    /// Where they turn about each other, in the order of the bodies.
    pub hinges: Vec<Hinge>,
}

impl Mechanism {
    /// The motion of bodies that nothing holds, which touched like this before it. None where none moves.
    pub(super) fn now(scene: &Scene, bodies: &[MovingBody], contacts: &[ContactView]) -> Option<Self> {
        Self::of(scene, Begins::Now, bodies, contacts)
    }

    fn of(scene: &Scene, begins: Begins, bodies: &[MovingBody], contacts: &[ContactView]) -> Option<Self> {
        let hinges = hinges(scene, bodies, contacts);
        (!bodies.is_empty()).then(|| Self { begins, bodies: bodies.to_vec(), hinges })
    }
}

/// The motion that begins at the least push of bodies that are held, which touch like this at the start. None where no
/// push moves them.
pub fn mechanism_at_push(scene: &Scene, stability: &Stability, contacts: &[ContactView]) -> Option<Mechanism> {
    let push = stability.worst_push()?;
    let of_weight = push.of_weight.filter(|part| part.is_finite())?;
    Mechanism::of(scene, Begins::AtPush { direction: push.direction, of_weight }, &push.begins, contacts)
}

/// The hinges between bodies that move like this.
fn hinges(scene: &Scene, bodies: &[MovingBody], contacts: &[ContactView]) -> Vec<Hinge> {
    let motions: BTreeMap<BodyId, &MovingBody> = bodies.iter().map(|own| (own.body, own)).collect();
    let velocity = |body: BodyId, point: DVec3| {
        let of = |own: &&MovingBody| Some(own.velocity.at(point - center_m(scene, body)?));
        motions.get(&body).and_then(of).unwrap_or(DVec3::ZERO)
    };
    let mut pairs: BTreeMap<[BodyId; 2], Vec<(DVec3, f64)>> = BTreeMap::new();
    for own in contacts {
        let rate = own.normal.dot(velocity(own.body_a, own.point_m) - velocity(own.body_b, own.point_m));
        pairs.entry([own.body_a, own.body_b]).or_default().push((own.point_m, rate));
    }
    let hinge = |(bodies, points): ([BodyId; 2], Vec<(DVec3, f64)>)| {
        let fastest = points.iter().fold(0.0_f64, |most, (_, rate)| most.max(*rate));
        let closed = points.iter().filter(|(_, rate)| *rate <= CLOSED_RELATIVE * fastest).map(|(point, _)| *point);
        let points_m: Vec<DVec3> = closed.collect();
        (fastest > CLOSED_RELATIVE && !points_m.is_empty()).then_some(Hinge { bodies, points_m })
    };
    pairs.into_iter().filter_map(hinge).collect()
}

/// Where the centre of mass of a body is at the start, m.
fn center_m(scene: &Scene, body: BodyId) -> Option<DVec3> {
    let body = scene.bodies().get(body.index())?;
    Some(body.initial_pose().transform_point(body.mass_properties()?.center_of_mass()))
}

//! Which tier runs a scene that names none: the most accurate one, unless its estimated processor time is more than a
//! user waits for.
//!
//! The processor time of tier `accurate` for bodies that tumble in a heap is estimated by
//!
//! `T = C r^p s`,
//!
//! with the rows of contacts `r` that all of them would have at once (no unit), the time `s` (s) in which they move
//! ([`MOVING_S`]), and the constants of a fit ([`SECONDS_OF_A_ROW`], [`GROWTH`]). A body counts
//! [`CONTACTS_OF_ROUND`] contacts if it is round and [`CONTACTS_OF_FLAT`] if not, each of one row, and of three with
//! friction. Source: measured on drops of balls and of boxes into a bin, with friction and without;
//! `cargo xtask tier-costs` measures them again and prints the fit. Heaps of boxes take up to twice as long as
//! estimated, balls without friction a tenth, and another machine differs besides: the estimate tells minutes from
//! hours.
//!
//! A scene keeps tier `accurate` whatever the estimate where it asks for what only this tier has (a tolerance, an
//! integrator), and where all of its bodies are certified at rest at the start, which costs nothing until something
//! touches them.
//!
//! Failure: none; what is neither a heap nor at rest, as many balls that never meet, is estimated too high, and a scene
//! may name its tier.

use super::facts::TierFeature;
use crate::scene::{Body, Geometry, Scene, Tier};
use polhode_contact::Shape;

/// Processor time that a user waits for, s.
const PATIENCE_S: f64 = 60.0;

/// For how long bodies count as moving, s: two metres of fall take 0.6 s, and settling about as long again. The
/// duration does not count, so that a run that is continued beyond its end stays in its tier.
const MOVING_S: f64 = 2.0;

/// Processor time for a second of a heap with one row of contacts, s: the fit of `cargo xtask tier-costs`.
const SECONDS_OF_A_ROW: f64 = 0.002;

/// How the processor time grows with the rows (no unit): the exponent of the fit.
const GROWTH: f64 = 1.6;

/// Contacts of a round body in a heap: it rests on three others, and each contact is that of two bodies.
const CONTACTS_OF_ROUND: f64 = 3.0;

/// Contacts of a body with flat faces or edges in a heap: the corners of faces, and edges that cross.
const CONTACTS_OF_FLAT: f64 = 6.0;

/// Rows of a contact with friction: its normal and two tangents.
const ROWS_WITH_FRICTION: f64 = 3.0;

/// A tier, and why it is taken.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TierChoice {
    pub(crate) tier: Tier,
    pub(crate) reason: String,
}

/// What is known about a scene before it begins.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Candidate {
    /// This tier, whatever is found at the start.
    Decided(TierChoice),
    /// The first where all bodies are certified at rest at the start, else the second.
    IfAllRest(TierChoice, TierChoice),
}

/// The tier of a scene.
pub(crate) fn choose(scene: &Scene) -> Candidate {
    let default = Tier::default();
    let decided = |tier, reason: String| Candidate::Decided(TierChoice { tier, reason });
    if let Some(tier) = scene.method().tier {
        return decided(tier, "the scene names it".to_owned());
    }
    if let (Some(tier), Some(response)) = (scene.method().named_tier(), scene.method().response) {
        return decided(tier, format!("the scene asks for response = \"{}\"", response.name()));
    }
    let estimate = Estimate::of(scene);
    if estimate.seconds() <= PATIENCE_S {
        return decided(default, format!("the most accurate: {}", estimate.in_words()));
    }
    let faster = Tier::Stepped;
    if let Some(key) = scene.method().first_of_default_tier() {
        let reason = format!("the scene gives {key}, which this tier keeps; {}", estimate.in_words());
        return decided(default, reason);
    }
    if !takes_all_of(scene, faster) {
        let reason = format!("the scene has what tier `{}` does not take; {}", faster.name(), estimate.in_words());
        return decided(default, reason);
    }
    let faster = TierChoice {
        tier: faster,
        reason: format!(
            "{}, more than {PATIENCE_S} s, in tier `{}`: name that tier, or run a part, to have it all the same",
            estimate.in_words(),
            default.name()
        ),
    };
    if scene.bodies().iter().any(moves_at_start) {
        return Candidate::Decided(faster);
    }
    let resting = "the most accurate: all bodies are certified at rest at the start, and cost nothing until something \
                   touches them";
    Candidate::IfAllRest(TierChoice { tier: default, reason: resting.to_owned() }, faster)
}

/// Whether a body that forces move has a velocity, or a motion carries it.
fn moves_at_start(body: &Body) -> bool {
    let velocity = body.initial_velocity();
    body.motion().is_some() || (!body.is_fixed() && (velocity.linear.length() > 0.0 || velocity.angular.length() > 0.0))
}

/// Whether a tier takes the joints, pivots and friction of a scene.
fn takes_all_of(scene: &Scene, tier: Tier) -> bool {
    let has_pivots = scene.bodies().iter().any(|body| body.pivot_point().is_some());
    let facts = tier.facts();
    (!has_pivots || facts.takes(TierFeature::PivotRows))
        && (scene.joints().is_empty() || facts.takes(TierFeature::AllOfJoints))
        && (!scene.colliding().have_friction() || facts.takes(TierFeature::Friction))
}

/// The processor time of a scene in tier `accurate`.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Estimate {
    /// Bodies that forces move and that may touch others.
    bodies: usize,
    /// Rows of contacts that they would have at once.
    rows: f64,
}

impl Estimate {
    fn of(scene: &Scene) -> Self {
        let colliding = scene.colliding();
        let rows_of_contact = if colliding.have_friction() { ROWS_WITH_FRICTION } else { 1.0 };
        let contacts = |body: &Body| match body.shape() {
            None => 0.0,
            Some(Geometry::Shape(Shape::Sphere(_) | Shape::Capsule(_) | Shape::Torus(_))) => CONTACTS_OF_ROUND,
            Some(_) => CONTACTS_OF_FLAT,
        };
        let moving = scene.bodies().iter().filter(|body| !body.is_fixed() && body.motion().is_none());
        let of_bodies: Vec<f64> = moving.map(contacts).filter(|contacts| *contacts > 0.0).collect();
        let rows = if colliding.count > 0 { rows_of_contact * of_bodies.iter().sum::<f64>() } else { 0.0 };
        Self { bodies: of_bodies.len(), rows }
    }

    /// Of processor time.
    fn seconds(&self) -> f64 {
        SECONDS_OF_A_ROW * libm::pow(self.rows, GROWTH) * MOVING_S
    }

    fn in_words(&self) -> String {
        if self.rows == 0.0 {
            return "no two bodies may touch".to_owned();
        }
        let Self { bodies, rows } = self;
        format!(
            "estimated at {} s of processor time if all of {bodies} bodies tumble in a heap for {MOVING_S} s, with \
             some {rows} rows of contact",
            two_digits(self.seconds())
        )
    }
}

/// A number to two digits, as words show it.
fn two_digits(value: f64) -> String {
    if value >= 10.0 { format!("{value:.0}") } else { format!("{value:.2}") }
}

#[cfg(test)]
mod tests {
    //! A scene that names its tier has it; a few bodies, or any number that never touch, have the most accurate one;
    //! many that tumble have the one whose time they end in, unless the scene asks for what only the other has.
    #![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use crate::scene::{Material, Method, SceneBuilder};
    use polhode_mesh::solid_box;
    use polhode_spatial::{DVec3, Mass, Pose, UnitVector, Velocity};

    fn heap(boxes: u32, velocity: DVec3, method: Method) -> Scene {
        let material = Material::new("rough").with_friction(0.5).unwrap();
        let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into()).material(material.clone());
        let scene = Scene::builder("heap").method(method).duration_s(10.0).gravity(DVec3::Z * -9.81).body(floor);
        let fall = |number: u32| {
            let body = Body::movable(number.to_string(), solid_box(DVec3::ONE, Mass::new(1.0).unwrap()).unwrap());
            body.geometry(Shape::cuboid(DVec3::ONE).unwrap().into())
                .pose(Pose::from_translation(DVec3::Z * (1.0 + 2.0 * f64::from(number))))
                .velocity(Velocity::new(velocity, DVec3::ZERO))
                .material(material.clone())
        };
        (0..boxes).map(fall).fold(scene, SceneBuilder::body).build().unwrap()
    }

    fn tier(scene: &Scene) -> Tier {
        match choose(scene) {
            Candidate::Decided(choice) | Candidate::IfAllRest(_, choice) => choice.tier,
        }
    }

    #[test]
    fn the_estimate_decides_unless_the_scene_does() {
        let plain = Method::default;
        assert_eq!(tier(&heap(3, DVec3::ZERO, plain())), Tier::Accurate);
        assert_eq!(tier(&heap(200, DVec3::ZERO, plain())), Tier::Stepped);
        let named = Method { tier: Some(Tier::Accurate), ..plain() };
        assert_eq!(tier(&heap(200, DVec3::ZERO, named)), Tier::Accurate);
        let exact = Method { tolerance: Some(1e-9), ..plain() };
        assert_eq!(tier(&heap(200, DVec3::ZERO, exact)), Tier::Accurate);
    }

    /// Bodies at rest are asked for their rest first; one that moves may wake all others.
    #[test]
    fn only_a_scene_at_rest_may_be_certified_at_rest() {
        let candidate = |velocity| choose(&heap(200, velocity, Method::default()));
        assert!(matches!(candidate(DVec3::ZERO), Candidate::IfAllRest(..)));
        assert!(matches!(candidate(DVec3::X), Candidate::Decided(_)));
    }

    /// The time grows with the rows as the fit says.
    #[test]
    fn the_estimate_is_that_of_the_fit() {
        let estimate = Estimate { bodies: 20, rows: 360.0 };
        let expected = MOVING_S * SECONDS_OF_A_ROW * libm::pow(360.0, GROWTH);
        assert!((estimate.seconds() / expected - 1.0).abs() < 1e-12);
    }
}

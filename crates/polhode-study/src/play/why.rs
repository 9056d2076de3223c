//! Why a body moves as it does: the forces on it, how much of its friction each contact uses, and what would have to
//! change for bodies at rest to move.
//!
//! The forces on a body add up to `m a` (N). A contact with the normal force N (N) and friction T (N) holds without
//! slipping as long as T lies in the cone `|T| <= mu N`; it needs a coefficient of `|T| / N` (no unit). Springs, drag
//! and other fields of the scene are what is left of the sum. In tiers of fixed steps contact forces are the mean of
//! the last step.

use super::error::PlayError;
use super::playground::Playground;
use polhode::spatial::DVec3;
use polhode::{BodyId, ContactView};
use polhode_scene::stability_json;
use serde_json::{Value, json};

/// Friction used above this part of the cone is all of it (no unit, 0.99 to 1): forces are good to the residual of
/// their solve.
const ALL_OF_CONE: f64 = 1.0 - 1e-6;

/// A force on a body.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceOn {
    /// What exerts it, in words.
    pub from: String,
    /// Where, world, m.
    pub point_m: DVec3,
    /// The force, world, N.
    pub force_n: DVec3,
    /// Of a contact: its cone of friction.
    pub cone: Option<Cone>,
}

/// The cone of friction of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// The normal, away from what exerts the force.
    pub normal: DVec3,
    /// Force along it, N.
    pub normal_force_n: f64,
    /// Friction, N.
    pub friction_n: f64,
    /// Coefficient of friction there (no unit).
    pub coefficient: f64,
}

impl Cone {
    /// The coefficient of friction that is needed (no unit); none where nothing presses.
    pub fn needed(&self) -> Option<f64> {
        (self.normal_force_n > 0.0).then(|| self.friction_n / self.normal_force_n)
    }

    /// Whether all friction is used, so that it slips or is about to.
    pub fn is_used_up(&self) -> bool {
        self.needed().is_some_and(|needed| needed >= ALL_OF_CONE * self.coefficient)
    }
}

impl Playground {
    /// The forces on a body at present, and `m a` (N), to which they add up.
    ///
    /// # Errors
    /// When there is no such body, or contact forces cannot be found.
    pub fn forces_on(&mut self, body: usize) -> Result<(Vec<ForceOn>, DVec3), PlayError> {
        let id = BodyId::new(body);
        let scene = self.scene().clone();
        let bodies = scene.bodies();
        let own = bodies.get(body).ok_or(PlayError::Body { index: body, bodies: bodies.len() })?;
        let name = |body: BodyId| bodies.get(body.index()).map_or("a body", polhode::Body::name).to_owned();
        let Some(mass) = own.mass_properties().filter(|_| !own.is_fixed() && own.motion().is_none()) else {
            return Err(PlayError::Fixed { name: own.name().to_owned() });
        };
        let center_m = self.bodies()[body].pose.transform_point(mass.center_of_mass());
        let weight = scene.gravity() * mass.mass();
        let mut forces =
            vec![ForceOn { from: "its weight".to_owned(), point_m: center_m, force_n: weight, cone: None }];
        forces.extend(self.contacts().iter().filter_map(|view| self.contact_on(id, view, &name)));
        let simulation = self.simulation();
        for pivot in simulation.pivots().iter().filter(|pivot| pivot.body == id) {
            let from = "its pivot".to_owned();
            forces.push(ForceOn { from, point_m: pivot.point_m, force_n: pivot.force_n, cone: None });
        }
        let names = self.loaded().joint_names();
        for load in simulation.joint_loads() {
            let Some(joint) = scene.joints().get(load.joint.index()) else { continue };
            let sign = if joint.body() == id { 1.0 } else { -1.0 };
            if joint.body() == id || joint.other() == Some(id) {
                let from = names.get(load.joint.index()).cloned().unwrap_or_default();
                forces.push(ForceOn { from, point_m: load.point_m, force_n: load.force_n * sign, cone: None });
            }
        }
        if let Some((grab, force_n)) = self.held().filter(|(grab, _)| grab.body == id) {
            let point_m = grab.held_m(&self.bodies()[body].pose);
            forces.push(ForceOn { from: "your hand".to_owned(), point_m, force_n, cone: None });
        }
        let accelerations = self.accelerations()?;
        let total = accelerations.get(body).map_or(DVec3::ZERO, |own| own.linear * mass.mass());
        Ok((forces, total))
    }

    /// The force of a contact on a body; none where the contact is of others, or carries nothing.
    fn contact_on(&self, id: BodyId, view: &ContactView, name: &dyn Fn(BodyId) -> String) -> Option<ForceOn> {
        let (other, sign) = match (view.body_a == id, view.body_b == id) {
            (true, _) => (view.body_b, 1.0),
            (_, true) => (view.body_a, -1.0),
            _ => return None,
        };
        let material = self.simulation().material_between(view.body_a, view.body_b)?;
        let cone = Cone {
            normal: view.normal * sign,
            normal_force_n: view.normal_force_n,
            friction_n: view.friction_n.length(),
            coefficient: material.static_friction(),
        };
        let force_n = (view.normal * view.normal_force_n + view.friction_n) * sign;
        Some(ForceOn { from: name(other), point_m: view.point_m, force_n, cone: Some(cone) })
    }

    /// The forces on a body as one JSON object, with a sentence for each contact.
    ///
    /// # Errors
    /// As [`Playground::forces_on`].
    pub fn why_json(&mut self, body: usize) -> Result<Value, PlayError> {
        let (forces, total) = self.forces_on(body)?;
        let one = |force: &ForceOn| {
            let cone = force.cone.map(|cone| {
                json!({
                    "normal": cone.normal.to_array(),
                    "normal_force_n": cone.normal_force_n,
                    "friction_n": cone.friction_n,
                    "coefficient": cone.coefficient,
                    "needed": cone.needed(),
                })
            });
            json!({
                "from": force.from,
                "point": force.point_m.to_array(),
                "force": force.force_n.to_array(),
                "cone": cone,
                "words": force.cone.and_then(|cone| words(&force.from, &cone)),
            })
        };
        let known: DVec3 = forces.iter().map(|force| force.force_n).sum();
        Ok(json!({
            "t": self.time(),
            "body": body,
            "name": self.scene().bodies()[body].name(),
            "forces": forces.iter().map(one).collect::<Vec<_>>(),
            "mass_times_acceleration": total.to_array(),
            "others": (total - known).to_array(),
        }))
    }

    /// How far the bodies at rest are from moving, as one JSON object.
    ///
    /// # Errors
    /// When rows cannot be made of the contacts.
    pub fn margins_json(&self) -> Result<Value, PlayError> {
        Ok(stability_json(self.scene(), &self.stability()?))
    }
}

/// What a contact does, and what would have to change; none where nothing presses.
fn words(other: &str, cone: &Cone) -> Option<String> {
    let needed = cone.needed()?;
    let Cone { normal_force_n, friction_n, coefficient, .. } = *cone;
    let carried = format!("{other} presses with {normal_force_n:.3} N");
    Some(if coefficient == 0.0 {
        format!("{carried}, without friction: nothing holds it sideways")
    } else if cone.is_used_up() {
        format!("{carried}; friction of {friction_n:.3} N is all that {coefficient} allows: it slips")
    } else {
        let part = 100.0 * needed / coefficient;
        format!(
            "{carried}; friction of {friction_n:.3} N is {part:.0} % of what {coefficient} allows: here it would slip \
             if the coefficient fell below {needed:.3}"
        )
    })
}

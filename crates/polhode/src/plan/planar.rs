//! Planar motion: finds out whether the motion of a scene stays in a plane.
//!
//! Let one plane be a plane of mirror symmetry of every body, shape and mass, and of velocities, gravity and fixed
//! bodies. The motion of frictionless bodies is unique (erratum E14), and the mirror image of a motion is a motion too.
//! So the motion is its own mirror image and stays in the plane. Each body then has two velocity components in the
//! plane and one angular velocity about its normal, and of two contacts that are mirror images of each other one
//! suffices: an answer to the thesis's "under what conditions we can model a simulation using the 2D equations". In
//! space the same motion takes twice the contacts and twice the unknowns, and rounding may lead out of the plane, which
//! an unstable motion amplifies.
//!
//! With friction a motion need not be unique. The mirror image of Coulomb's law is the same law: where the motion is
//! unique it keeps its symmetry, and where it is not, the plane has one of the motions that space has. A contact and
//! its mirror image slip alike, along the plane; their forces across it cancel, and their cones become one interval
//! (`collision/slip_directions.rs`). That asks for normals in the plane: bodies that rub are half-spaces, balls beside
//! convex bodies, or prisms along the normal of the plane, since two edges of other bodies may touch with normals that
//! lean out of it, where friction wedges bodies in ways that one interval does not have.
//!
//! Assumption: the laws treat all contacts of an instant alike. Propagation, which strikes one contact after the other,
//! breaks the mirror symmetry; so do the forces of a linear programme. Fails: never; a scene without such a plane is
//! simulated in space.

use crate::collision::moving_surfaces;
use crate::model::plane_of_motion::PlaneOfMotion;
use crate::model::{Model, ModelBody};
use crate::scene::settings::Settings;
use crate::scene::tier_facts::TierFeature;
use crate::scene::{ContactMethod, ImpactLaw, Integrator, IntegratorChoice, Response};
use polhode_contact::{Shape, is_prism_along, mirror_defect};
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, UnitVector};

/// Largest defect of symmetry, relative to the size of the quantity measured: the rounding of poses and mass
/// properties.
const SYMMETRY_RELATIVE: f64 = 32.0 * f64::EPSILON;

/// Whether the motion of a scene is planar, with the measured fact that decides it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PlanarFinding {
    pub(crate) plane: Option<PlaneOfMotion>,
    pub(crate) fact: String,
}

impl PlanarFinding {
    pub(crate) fn off(fact: impl Into<String>) -> Self {
        Self { plane: None, fact: fact.into() }
    }
}

/// Looks for a plane of symmetry of the scene in these states.
pub(crate) fn find(model: &Model, states: &[BodyState], settings: &Settings) -> PlanarFinding {
    if !model.bodies.iter().any(ModelBody::moves) {
        return PlanarFinding::off("no body moves");
    }
    if !model.prescribed.is_empty() {
        return PlanarFinding::off("the motion of a body is prescribed, and its symmetry is not examined");
    }
    if settings.response == Response::Penalty {
        return PlanarFinding::off("springs at two mirror images of a contact are not one spring");
    }
    if model.has_friction() && !settings.takes(TierFeature::PlanarFriction) {
        return PlanarFinding::off("contacts have friction, which this tier solves for in space");
    }
    if model.has_friction() && model.surfaces.have_grain() {
        return PlanarFinding::off("friction has a grain, and its symmetry is not examined");
    }
    if model.has_loads() {
        return PlanarFinding::off("force fields, pivots or joints act on bodies, and their symmetry is not examined");
    }
    let keeps_symmetry =
        matches!(settings.integrator, Integrator::Exact | Integrator::ExactAdaptive | Integrator::Dop853);
    let is_own = matches!(settings.tier.facts().integrator_choice, IntegratorChoice::Tier { .. });
    if !is_own && !keeps_symmetry {
        return PlanarFinding::off(
            "the integrator that the scene names may not keep the symmetry: bodies move in space",
        );
    }
    let by_forces_alike = matches!(settings.contact, ContactMethod::ActiveSet | ContactMethod::Guesses);
    if settings.impact == ImpactLaw::Propagation || !by_forces_alike {
        return PlanarFinding::off(
            "the impact law or the contact method does not treat all contacts alike, which breaks the symmetry",
        );
    }
    let mut nearest: Option<Defect> = None;
    for normal in candidates(model, states) {
        let defect = measure(model, states, normal);
        if defect.relative <= SYMMETRY_RELATIVE {
            let fact = format!(
                "every body is its own mirror image in the plane with normal ({}, {}, {}), with a relative defect of \
                 {:.1e} (limit {:.1e})",
                normal.x, normal.y, normal.z, defect.relative, SYMMETRY_RELATIVE
            );
            if let Some(fact) = leaning_contacts(model, states, normal) {
                return PlanarFinding::off(fact);
            }
            let offset = plane_offset(model, states, normal);
            return PlanarFinding { plane: Some(PlaneOfMotion::new(normal, offset)), fact };
        }
        if nearest.as_ref().is_none_or(|n| defect.relative < n.relative) {
            nearest = Some(defect);
        }
    }
    let nearest = nearest.map_or_else(|| "no plane to try".to_owned(), |d| d.to_string());
    PlanarFinding::off(format!("no mirror plane: {nearest}"))
}

/// The largest defect of symmetry in a plane.
#[derive(Debug, Clone, PartialEq)]
struct Defect {
    relative: f64,
    what: String,
}

impl std::fmt::Display for Defect {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} (relative defect {:.1e}, limit {:.1e})", self.what, self.relative, SYMMETRY_RELATIVE)
    }
}

/// Normals to try: the axis of the first spin, or, when no body spins, the axes of the world and of the first movable
/// body.
fn candidates(model: &Model, states: &[BodyState]) -> Vec<DVec3> {
    let spinning = (0..states.len()).map(|i| model.velocity(i, &states[i]).angular).find(|w| *w != DVec3::ZERO);
    if let Some(axis) = spinning {
        let axis = axis.normalize_or_zero();
        // Normalising a spin about an axis of the world gives that axis to the last bit.
        return if axis == DVec3::ZERO { Vec::new() } else { vec![axis] };
    }
    let mut normals = vec![DVec3::Y, DVec3::X, DVec3::Z];
    if let Some(state) = states.iter().zip(&model.bodies).find(|(_, body)| body.moves()).map(|(state, _)| state) {
        normals.extend([DVec3::Y, DVec3::X, DVec3::Z].map(|axis| state.pose.rotation.rotate(axis)));
    }
    normals
}

/// Offset of the plane, m: the plane passes through the first movable body.
fn plane_offset(model: &Model, states: &[BodyState], normal: DVec3) -> f64 {
    let first = states.iter().zip(&model.bodies).find(|(_, body)| body.moves());
    first.map_or(0.0, |(state, _)| normal.dot(state.pose.translation))
}

/// The largest defect of symmetry in the plane with this normal: of the motions, and of the shapes where the motions
/// have none.
fn measure(model: &Model, states: &[BodyState], normal: DVec3) -> Defect {
    let offset = plane_offset(model, states, normal);
    let mut worst = Defect { relative: 0.0, what: String::new() };
    let mut note = |defect: f64, size: f64, what: &dyn Fn() -> String| {
        let relative = if defect == 0.0 { 0.0 } else { defect / size };
        let relative = if relative.is_nan() { f64::INFINITY } else { relative };
        if relative > worst.relative {
            worst = Defect { relative, what: what() };
        }
    };
    let gravity = model.gravity();
    note(gravity.dot(normal).abs(), gravity.length(), &|| "gravity is not parallel to the plane".to_owned());
    for (number, (body, state)) in model.bodies.iter().zip(states).enumerate() {
        let height = normal.dot(state.pose.translation) - offset;
        if let Some(rigid) = &body.rigid {
            let extent = body.size + state.pose.translation.abs().max_element();
            note(height.abs(), extent, &|| format!("{} is not centred on the plane", body.name));
            let velocity = rigid.velocity(state);
            let speed = velocity.linear.length();
            note(velocity.linear.dot(normal).abs(), speed, &|| format!("{} moves out of the plane", body.name));
            let spin = velocity.angular;
            note(spin.cross(normal).length(), spin.length(), &|| {
                format!("{} does not turn about the normal of the plane", body.name)
            });
            let axis = state.pose.rotation.inverse_rotate(normal);
            let moment = rigid.inertia() * axis;
            note(moment.cross(axis).length(), rigid.moments().max_element(), &|| {
                format!("the normal is not a principal axis of {}", body.name)
            });
        }
        let surface = moving_surfaces::surface_velocity(model, states, number);
        note(surface.dot(normal).abs(), surface.length(), &|| {
            format!("the surface of {} moves out of the plane", body.name)
        });
    }
    if worst.relative > SYMMETRY_RELATIVE {
        return worst;
    }
    let mut note = |defect: f64, size: f64, body: &ModelBody| {
        if defect > worst.relative * size {
            let what = format!("the shape of {} is not its own mirror image", body.name);
            worst = Defect { relative: defect / size, what };
        }
    };
    for (body, state) in model.bodies.iter().zip(states) {
        if let Some(shape) = &body.shape {
            let height = normal.dot(state.pose.translation) - offset;
            let axis = UnitVector::new(state.pose.rotation.inverse_rotate(normal));
            let offset = if body.moves() { 0.0 } else { -height };
            let defect = axis.map_or(f64::INFINITY, |axis| mirror_defect(shape, axis, offset));
            let size = if body.size == 0.0 { 1.0 } else { body.size };
            note(defect, size, body);
        }
    }
    worst
}

/// A body by where the normals of its contacts may point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    /// Nothing touches it, or every contact has its own normal.
    HalfSpace,
    Ball,
    /// The same in every plane parallel to the plane of motion.
    Prism,
    Convex,
    Other,
}

impl Form {
    /// That of a body with this normal of the plane of motion in its frame.
    fn of(shape: Option<&Shape>, axis: DVec3) -> Self {
        match shape {
            None | Some(Shape::HalfSpace(_)) => Self::HalfSpace,
            Some(Shape::Sphere(_)) => Self::Ball,
            Some(shape) if UnitVector::new(axis).is_ok_and(|axis| is_prism_along(shape, axis)) => Self::Prism,
            Some(Shape::Convex(_) | Shape::Capsule(_) | Shape::Cylinder(_) | Shape::Cone(_)) => Self::Convex,
            Some(_) => Self::Other,
        }
    }

    /// Whether normals of contacts with a body of another form lie in the plane of symmetry of both.
    fn keeps_normals(self, other: Self) -> bool {
        match (self, other) {
            (Self::HalfSpace, _) | (_, Self::HalfSpace) | (Self::Prism, Self::Prism) => true,
            (Self::Ball, other) | (other, Self::Ball) => other != Self::Other,
            _ => false,
        }
    }
}

/// Why normals of contacts with friction may lean out of the plane with this normal; none where they do not.
fn leaning_contacts(model: &Model, states: &[BodyState], normal: DVec3) -> Option<String> {
    if !model.has_friction() {
        return None;
    }
    let form = |(body, state): (&ModelBody, &BodyState)| {
        Form::of(body.shape.as_ref(), state.pose.rotation.inverse_rotate(normal))
    };
    let forms: Vec<Form> = model.bodies.iter().zip(states).map(form).collect();
    // Pairs of prisms, and with half-spaces, are most: they are not looked at one by one.
    let others = (0..forms.len()).filter(|&a| matches!(forms[a], Form::Convex | Form::Other));
    let rub = |a: usize, b: usize| {
        let material = model.scene.pair_material(a, b);
        material.static_ellipse().largest().max(material.rolling_friction()).max(material.spinning_friction()) > 0.0
    };
    let leans = |&(a, b): &(usize, usize)| {
        !forms[a].keeps_normals(forms[b])
            && (model.bodies[a].moves() || model.bodies[b].moves())
            && model.scene.may_collide(a, b)
            && rub(a, b)
    };
    let mut pairs = others.flat_map(|a| (0..forms.len()).filter(move |&b| b != a).map(move |b| (a, b)));
    let (a, b) = pairs.find(leans)?;
    let (a, b) = (&model.bodies[a].name, &model.bodies[b].name);
    Some(format!("{a} and {b} rub, and where they touch the normal may lean out of the plane of their symmetry"))
}

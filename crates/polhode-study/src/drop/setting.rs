//! What is thrown, on what, and from where.
//!
//! Where all that a body can meet is one fixed plane across gravity, it collides with its convex hull: a plane touches
//! nothing else of it, and the motion is that of the body itself. Such a plane loses no energy to the scene, so that
//! a body whose energy no longer suffices to tip it has come to rest as far as its face is concerned. In any other
//! scene the body keeps its shape, and a throw ends when it rests.

use super::error::DropError;
use super::facets::Facets;
use polhode::contact::{ConvexPolyhedron, Shape, aabb_of};
use polhode::scene::Material;
use polhode::spatial::rounding::DIGITS_OF_A_FILE;
use polhode::spatial::{DVec3, MassProperties, Pose, Rotation};
use polhode::{Body, BodyId, Effects, ErrorEstimation, Geometry, Scene, Simulation, SimulationError};

/// How long a throw may take, in times that the body needs to fall by the height and its own size (no unit): a body
/// that bounces and rolls comes to rest in some ten.
const LONGEST: f64 = 100.0;

/// The floor that a body falls on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Plane {
    /// Its number in the scene.
    body: usize,
    /// How far it is along its normal, m.
    offset_m: f64,
}

/// What the thrown body meets.
#[derive(Debug, Clone)]
enum Ground {
    /// One plane across gravity.
    Plane(Plane),
    /// A scene that holds the body.
    Own(BodyId),
    /// A scene that the body is added to.
    Added,
}

/// What the caller asks of a throw.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Start {
    /// Clearance of the lowest point above what it falls on, m; without it the size of the body.
    pub height_m: Option<f64>,
    /// Where the centre of mass begins, m; without it above the middle.
    pub place: Option<DVec3>,
    /// How long a throw may take, s; without it a hundred times as long as the fall.
    pub longest_s: Option<f64>,
}

/// What is thrown, on what, and from where.
#[derive(Debug, Clone)]
pub struct Setting {
    scene: Scene,
    /// As it collides.
    body: Body,
    /// As it was given.
    drawn: Body,
    properties: MassProperties,
    ground: Ground,
    facets: Facets,
    effects: Effects,
    /// Against gravity.
    up: DVec3,
    gravity: f64,
    height_m: f64,
    place: DVec3,
}

impl Setting {
    /// The body of this name of a scene is thrown; without a name the only one that forces move.
    ///
    /// # Errors
    /// When there is no such body, it has no faces, or nothing falls.
    pub fn of_scene(scene: &Scene, name: Option<&str>, effects: Effects, start: Start) -> Result<Self, DropError> {
        let id = chosen(scene, name)?;
        let body = &scene.bodies()[id.index()];
        if scene.joints().iter().any(|joint| joint.body() == id || joint.other() == Some(id)) {
            return Err(DropError::Held { body: body.name().to_owned(), by: "a joint" });
        }
        Self::new(scene.clone(), body.clone(), Some(id), (effects, start))
    }

    /// A body is added to a scene, and thrown there.
    ///
    /// # Errors
    /// When the body has no faces, or nothing falls.
    pub fn onto(scene: &Scene, body: Body, effects: Effects, start: Start) -> Result<Self, DropError> {
        Self::new(scene.clone(), body, None, (effects, start))
    }

    fn new(
        scene: Scene,
        body: Body,
        own: Option<BodyId>,
        (effects, start): (Effects, Start),
    ) -> Result<Self, DropError> {
        let gravity = scene.gravity().length();
        let Some(up) = (-scene.gravity()).try_normalize() else { return Err(DropError::Weightless) };
        let name = || body.name().to_owned();
        if body.pivot_point().is_some() {
            return Err(DropError::Held { body: name(), by: "a pivot" });
        }
        let Some(properties) = body.mass_properties().copied() else {
            return Err(DropError::Held { body: name(), by: "the scene, which fixes or moves it" });
        };
        let points = points_of(&body)?;
        let refused = |source| DropError::Shape { body: name(), source };
        let hull = ConvexPolyhedron::from_points(&points).map_err(refused)?;
        let facets = Facets::new(&hull, properties.center_of_mass());
        let height_m = positive("the height (m)", start.height_m.unwrap_or(facets.size_m()))?;
        let fall_s = (2.0 * (height_m + facets.size_m()) / gravity).sqrt();
        let longest_s = positive("the longest time (s)", start.longest_s.unwrap_or(LONGEST * fall_s))?;
        let plane = plane_below(&scene, own, up);
        let (ground, shape) = match (plane, own, body.shape()) {
            (Some(plane), _, _) => (Ground::Plane(plane), Some(Shape::convex(hull).into())),
            (None, own, shape) => {
                // A mesh is decomposed once, and not for every throw.
                let shape = match shape {
                    Some(Geometry::Mesh(mesh)) => Some(Shape::solid(mesh).map_err(refused)?.into()),
                    shape => shape.cloned(),
                };
                (own.map_or(Ground::Added, Ground::Own), shape)
            }
        };
        let place = match (start.place, &ground, own) {
            (Some(place), _, _) => place,
            (None, Ground::Own(_), Some(_)) => body.initial_pose().transform_point(properties.center_of_mass()),
            _ => up * (top_of(&scene, own, up) + height_m + facets.radius_m()),
        };
        let scene = scene.with_duration(longest_s)?.with_output_interval(longest_s)?;
        let drawn = body.clone();
        let body = shape.map_or(body.clone(), |shape| body.geometry(shape));
        Ok(Self { scene, body, drawn, properties, ground, facets, effects, up, gravity, height_m, place })
    }

    /// The faces of the thrown body.
    pub fn facets(&self) -> &Facets {
        &self.facets
    }

    /// The thrown body.
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// The thrown body as it was given, to throw it elsewhere.
    pub fn into_body(self) -> Body {
        self.drawn
    }

    /// Mass properties of the thrown body, in its own frame.
    pub fn properties(&self) -> &MassProperties {
        &self.properties
    }

    /// The scene that it falls on.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Whether it falls on one plane.
    pub fn is_on_plane(&self) -> bool {
        matches!(self.ground, Ground::Plane(_))
    }

    /// Clearance of its lowest point at the start, m, where it falls on a plane.
    pub fn height_m(&self) -> f64 {
        self.height_m
    }

    /// Against gravity, a unit vector.
    pub(super) fn up(&self) -> DVec3 {
        self.up
    }

    /// Acceleration of gravity, m/s^2.
    pub(super) fn gravity(&self) -> f64 {
        self.gravity
    }

    /// The height of the plane along `up`, m.
    pub(super) fn plane_m(&self) -> Option<f64> {
        match &self.ground {
            Ground::Plane(plane) => Some(plane.offset_m),
            Ground::Own(_) | Ground::Added => None,
        }
    }

    /// The material of the contact between the body and what it meets: on a plane that of the pair, else its own.
    pub(super) fn contact_material(&self) -> Material {
        match &self.ground {
            Ground::Plane(plane) => self.combined(plane.body),
            Ground::Own(_) | Ground::Added => self.body.made_of().clone(),
        }
    }

    /// Elastic constants of the body and of what it falls on: without a plane, of the body twice.
    pub(super) fn elastic(&self) -> [Option<[f64; 2]>; 2] {
        let own = self.body.made_of().elastic_constants();
        match &self.ground {
            Ground::Plane(plane) => [own, self.scene.bodies()[plane.body].made_of().elastic_constants()],
            Ground::Own(_) | Ground::Added => [own, own],
        }
    }

    fn combined(&self, floor: usize) -> Material {
        let own = self
            .scene
            .body_id(self.body.name())
            .and_then(|body| self.scene.material_between(body, BodyId::new(floor)).ok());
        own.unwrap_or_else(|| self.body.made_of().combined(self.scene.bodies()[floor].made_of()))
    }

    /// The pose in which it is let go, in an attitude.
    pub(super) fn pose(&self, attitude: Rotation) -> Pose {
        let center = match &self.ground {
            Ground::Plane(plane) => {
                let reach = self.facets.reach_m(attitude.inverse_rotate(-self.up));
                let along = self.place - self.up * self.place.dot(self.up);
                along + self.up * (plane.offset_m + self.height_m + reach)
            }
            Ground::Own(_) | Ground::Added => self.place,
        };
        Pose::new(attitude, center - attitude.rotate(self.properties.center_of_mass()))
    }

    /// A simulation in which it is let go, at rest, in an attitude.
    ///
    /// # Errors
    /// When it overlaps something, or the scene cannot begin.
    pub(super) fn begun(&self, attitude: Rotation) -> Result<(Simulation, BodyId), SimulationError> {
        let pose = self.pose(attitude);
        let started = |scene: &Scene| {
            Ok::<_, SimulationError>(Simulation::with_effects(scene, self.effects)?.estimating(ErrorEstimation::Off))
        };
        match &self.ground {
            Ground::Plane(_) => {
                let scene = self.with_plane(pose)?;
                Ok((started(&scene)?, BodyId::new(1)))
            }
            Ground::Own(body) => {
                let mut simulation = started(&self.scene)?;
                simulation.set_pose(*body, pose)?;
                Ok((simulation, *body))
            }
            Ground::Added => {
                let mut simulation = started(&self.scene)?;
                let body = simulation.add_body(self.body.clone().pose(pose))?;
                Ok((simulation, body))
            }
        }
    }

    /// The scene with the body in a pose: of a plane these two alone; of another scene, the body added to it.
    ///
    /// # Errors
    /// When the scene is refused.
    fn with_plane(&self, pose: Pose) -> Result<Scene, SimulationError> {
        let Ground::Plane(plane) = &self.ground else { return Ok(self.scene.clone()) };
        let material = self.contact_material();
        let floor = self.scene.bodies()[plane.body].clone().material(material.clone());
        let body = self.body.clone().pose(pose).velocity(polhode::spatial::Velocity::ZERO).material(material);
        let built = Scene::builder(self.scene.name())
            .duration_s(self.scene.duration_s())
            .output_interval_s(self.scene.output_interval_s())
            .gravity(self.scene.gravity())
            .method(self.scene.method().clone())
            .body(floor)
            .body(body)
            .build()?;
        Ok(built)
    }

    /// A picture's scene: the body as it is drawn, on one of its faces, on a floor.
    ///
    /// # Errors
    /// When the scene is refused.
    pub fn at_rest(&self, facet: usize) -> Result<Scene, DropError> {
        let normal = self.facets.list().get(facet).map_or(DVec3::Z, |facet| facet.normal);
        let height = self.facets.list().get(facet).map_or(0.0, |facet| facet.height_m);
        let attitude = Rotation::renormalized(polhode::spatial::DQuat::from_rotation_arc(normal, -DVec3::Z));
        let center = DVec3::Z * height - attitude.rotate(self.properties.center_of_mass());
        let floor = Body::fixed("floor").geometry(Shape::half_space(polhode::spatial::UnitVector::Z).into());
        let body = self.drawn.clone().renamed("body").pose(Pose::new(attitude, center));
        Ok(Scene::builder(self.body.name()).body(floor).body(body).build()?)
    }
}

/// The body that is thrown.
fn chosen(scene: &Scene, name: Option<&str>) -> Result<BodyId, DropError> {
    let movable = || scene.bodies().iter().enumerate().filter(|(_, body)| !body.is_fixed());
    let accepted = || {
        let names: Vec<&str> = movable().map(|(_, body)| body.name()).collect();
        if names.is_empty() { "none".to_owned() } else { names.join(", ") }
    };
    let refused = |what: String| DropError::Body { what, accepted: accepted() };
    match name {
        Some(name) => {
            let found = movable().find(|(_, body)| body.name() == name);
            found
                .map(|(number, _)| BodyId::new(number))
                .ok_or_else(|| refused(format!("{} has no body {name} that could be thrown", scene.name())))
        }
        None => match movable().map(|(number, _)| number).collect::<Vec<_>>()[..] {
            [only] => Ok(BodyId::new(only)),
            _ => Err(refused(format!("{}: which body is thrown is not said", scene.name()))),
        },
    }
}

/// The corners of a body, of which its hull is made, in its frame.
fn points_of(body: &Body) -> Result<Vec<DVec3>, DropError> {
    let mut points = Vec::new();
    match body.shape() {
        Some(Geometry::Mesh(mesh)) => points.extend_from_slice(mesh.mesh().vertices()),
        Some(Geometry::Shape(shape)) => gather(body, shape, &mut points)?,
        None => return Err(DropError::Shapeless { body: body.name().to_owned() }),
    }
    Ok(points)
}

fn gather(body: &Body, shape: &Shape, points: &mut Vec<DVec3>) -> Result<(), DropError> {
    let round = |shape| Err(DropError::Round { body: body.name().to_owned(), shape });
    match shape {
        Shape::Convex(polyhedron) => points.extend_from_slice(polyhedron.vertices()),
        Shape::Points(cloud) => points.extend_from_slice(cloud.points()),
        Shape::TriangleMesh(mesh) => points.extend_from_slice(mesh.vertices()),
        Shape::Compound(compound) => compound.parts().iter().try_for_each(|part| gather(body, part, points))?,
        Shape::Sphere(_) => return round("a sphere"),
        Shape::Capsule(_) => return round("a capsule"),
        Shape::Cylinder(_) => return round("a cylinder"),
        Shape::Cone(_) => return round("a cone"),
        Shape::Torus(_) => return round("a torus"),
        _ => return Err(DropError::Shapeless { body: body.name().to_owned() }),
    }
    Ok(())
}

/// The only thing that a body can meet, where it is a plane across gravity, and nothing but gravity acts.
fn plane_below(scene: &Scene, own: Option<BodyId>, up: DVec3) -> Option<Plane> {
    let mut others = (0..scene.bodies().len()).filter(|&number| own.is_none_or(|own| own.index() != number));
    let (floor, more) = (others.next()?, others.next());
    let body = &scene.bodies()[floor];
    let Some(Geometry::Shape(Shape::HalfSpace(half_space))) = body.shape() else { return None };
    let is_bare = scene.forces().is_empty() && scene.joints().is_empty() && body.motion().is_none();
    let is_still = body.velocity_of_surface() == DVec3::ZERO;
    let normal = body.initial_pose().rotation.rotate(half_space.normal());
    let is_level = normal.dot(up) > 0.0 && normal.cross(up).length() <= DIGITS_OF_A_FILE;
    let meets = own.is_none_or(|own| scene.can_collide(own, BodyId::new(floor)));
    let offset_m = half_space.offset() + normal.dot(body.initial_pose().translation);
    (more.is_none() && is_bare && is_still && is_level && meets).then_some(Plane { body: floor, offset_m })
}

/// How high the bodies of a scene reach along `up`, m: planes where they meet the axis through the origin.
fn top_of(scene: &Scene, own: Option<BodyId>, up: DVec3) -> f64 {
    let height = |body: &Body| match body.shape()? {
        Geometry::Shape(Shape::HalfSpace(half_space)) => {
            let normal = body.initial_pose().rotation.rotate(half_space.normal());
            let rise = normal.dot(up);
            let offset = half_space.offset() + normal.dot(body.initial_pose().translation);
            (rise > 0.0).then(|| offset / rise)
        }
        Geometry::Shape(shape) => {
            let bounds = aabb_of(shape, body.initial_pose()).ok()?;
            let (middle, half) = (0.5 * (bounds.min() + bounds.max()), 0.5 * (bounds.max() - bounds.min()));
            Some(middle.dot(up) + half.dot(up.abs()))
        }
        Geometry::Mesh(mesh) => {
            let heights = mesh.mesh().vertices().iter().map(|&p| body.initial_pose().transform_point(p).dot(up));
            Some(heights.fold(f64::NEG_INFINITY, f64::max))
        }
    };
    let others = scene.bodies().iter().enumerate().filter(|(number, _)| own.is_none_or(|own| own.index() != *number));
    others.filter_map(|(_, body)| height(body)).fold(f64::NEG_INFINITY, f64::max).max(0.0)
}

fn positive(what: &'static str, value: f64) -> Result<f64, DropError> {
    let is_accepted = value.is_finite() && value > 0.0;
    if is_accepted { Ok(value) } else { Err(DropError::Number { what, value, accepted: "a positive, finite number" }) }
}

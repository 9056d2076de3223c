//! Geometric queries about the bodies of a simulation at its present time: the nearest body, overlaps, rays, distances.
//!
//! Bodies without a shape, and meshes of bodies that may not
//! collide, are not found.

use crate::identity::body_id::BodyId;
use crate::model::Model;
use polhode_contact::{Aabb, ClosestPoints, QueryError, QueryScene, Ray, RayHit, Shape, SurfacePoint, distance};
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, Pose};

/// The bodies of a simulation at one time ([`Simulation::queries`](crate::Simulation::queries)).
///
/// ```
/// use polhode::contact::{Ray, Shape};
/// use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, UnitVector};
/// use polhode::{Body, Geometry, Scene, Simulation};
/// let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, Inertia::from_diagonal(DVec3::splat(0.1))?);
/// let ball = Body::movable("ball", properties).geometry(Geometry::Shape(Shape::sphere(0.5)?));
/// let floor = Body::fixed("floor").geometry(Geometry::Shape(Shape::half_space(UnitVector::Z)));
/// let scene = Scene::builder("drop").duration_s(1.0).body(floor);
/// let scene = scene.body(ball.pose(Pose::from_translation(DVec3::Z * 3.0))).build()?;
/// let mut simulation = Simulation::new(&scene)?;
/// simulation.run()?;
///
/// let queries = simulation.queries()?;
/// let ray = Ray::new(DVec3::Z * 9.0, UnitVector::new(-DVec3::Z)?)?;
/// let (body, hit) = queries.first_hit(&ray, 100.0).ok_or("a miss")?;
/// assert_eq!(queries.name(body), Some("ball"));
/// assert!((hit.distance - 8.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct BodyQueries<'a> {
    scene: QueryScene<'a>,
    /// For each member of the query scene: the index of its body, ascending, its shape, and the pose of its moving
    /// frame.
    members: Vec<(usize, &'a Shape, Pose)>,
    names: Vec<&'a str>,
}

impl<'a> BodyQueries<'a> {
    pub(crate) fn new(model: &'a Model, states: &[BodyState]) -> Result<Self, QueryError> {
        let placed = model.bodies.iter().zip(states).enumerate();
        let members: Vec<(usize, &Shape, Pose)> =
            placed.filter_map(|(body, (own, state))| Some((body, own.shape.as_ref()?, state.pose))).collect();
        let scene = QueryScene::new(members.iter().map(|(_, shape, pose)| (*shape, *pose)))?;
        Ok(Self { scene, members, names: model.bodies.iter().map(|body| body.name.as_str()).collect() })
    }

    /// Name of a body.
    pub fn name(&self, body: BodyId) -> Option<&'a str> {
        self.names.get(body.index()).copied()
    }

    /// The body of this name.
    pub fn body_id(&self, name: &str) -> Option<BodyId> {
        self.names.iter().position(|own| *own == name).map(BodyId::new)
    }

    /// The body nearest to a point (world, m), and the nearest point of its surface.
    ///
    /// # Errors
    /// When the point is not finite.
    pub fn nearest(&self, point: DVec3) -> Result<Option<(BodyId, SurfacePoint)>, QueryError> {
        Ok(self.scene.nearest(point)?.map(|(member, found)| (self.body(member), found)))
    }

    /// The body that a ray hits first within a distance (m), and the hit.
    pub fn first_hit(&self, ray: &Ray, max_distance: f64) -> Option<(BodyId, RayHit)> {
        self.scene.first_hit(ray, max_distance).map(|(member, hit)| (self.body(member), hit))
    }

    /// All bodies that a ray hits within a distance (m), sorted by distance.
    pub fn all_hits(&self, ray: &Ray, max_distance: f64) -> Vec<(BodyId, RayHit)> {
        self.scene.all_hits(ray, max_distance).into_iter().map(|(member, hit)| (self.body(member), hit)).collect()
    }

    /// All bodies that overlap or touch a shape at a pose, ascending.
    ///
    /// # Errors
    /// When the pose is not finite.
    pub fn overlapping(&self, shape: &Shape, pose: &Pose) -> Result<Vec<BodyId>, QueryError> {
        Ok(self.scene.overlapping(shape, pose)?.into_iter().map(|member| self.body(member)).collect())
    }

    /// All bodies that overlap or touch a box along the world's axes, ascending.
    ///
    /// # Errors
    /// When the box is flat or unbounded.
    pub fn overlapping_box(&self, aabb: &Aabb) -> Result<Vec<BodyId>, QueryError> {
        Ok(self.scene.overlapping_box(aabb)?.into_iter().map(|member| self.body(member)).collect())
    }

    /// Distance of two bodies and their closest points; nothing when one has no shape.
    ///
    /// # Errors
    /// For two half-spaces.
    pub fn distance(&self, body_a: BodyId, body_b: BodyId) -> Result<Option<ClosestPoints>, QueryError> {
        let (Some(a), Some(b)) = (self.member(body_a.index()), self.member(body_b.index())) else { return Ok(None) };
        distance(a.1, &a.2, b.1, &b.2).map(Some)
    }

    fn body(&self, member: usize) -> BodyId {
        BodyId::new(self.members.get(member).map_or(member, |(body, ..)| *body))
    }

    fn member(&self, body: usize) -> Option<&(usize, &'a Shape, Pose)> {
        let index = self.members.binary_search_by_key(&body, |(body, ..)| *body).ok()?;
        self.members.get(index)
    }
}

//! Queries against many bodies: the nearest to a point, those that overlap, those hit by a ray.
//!
//! A tree of bounding boxes selects the candidates; the results are computed from the shapes. Bodies are named by their
//! index, and of equal results the lowest index is taken, so that no result depends on the tree.

use super::closest_point::{SurfacePoint, closest_point};
use super::error::QueryError;
use super::overlap::overlap;
use super::pieces::{box_distance, entry_distance};
use super::ray_cast::{Ray, RayHit, ray_cast};
use crate::Shape;
use crate::bounding::BoxTree;
use crate::bounding::aabb::Aabb;
use crate::bounding::around_shape::aabb_of;
use glam::DVec3;
use polhode_spatial::Pose;

/// Bodies at fixed poses, for queries.
///
/// ```
/// use polhode_contact::{DVec3, Pose, QueryScene, Ray, Shape, UnitVector};
/// let (brick, ball) = (Shape::cuboid(DVec3::ONE)?, Shape::sphere(0.5)?);
/// let scene = QueryScene::new([(&brick, Pose::IDENTITY), (&ball, Pose::from_translation(DVec3::Z * 3.0))])?;
/// let ray = Ray::new(DVec3::Z * 9.0, UnitVector::new(-DVec3::Z)?)?;
/// let hits: Vec<(usize, f64)> = scene.all_hits(&ray, 100.0).iter().map(|(body, hit)| (*body, hit.distance)).collect();
/// assert_eq!(hits, [(1, 5.5), (0, 8.5)]);
/// assert_eq!(scene.nearest(DVec3::Z * 2.0)?.map(|(body, _)| body), Some(1));
/// assert_eq!(scene.overlapping(&ball, &Pose::from_translation(DVec3::Z * 0.9))?, [0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct QueryScene<'a> {
    bodies: Vec<(&'a Shape, Pose)>,
    /// Bodies with a finite box, ascending.
    bounded: Vec<usize>,
    /// Boxes of the bounded bodies.
    boxes: Vec<Aabb>,
    tree: BoxTree,
    unbounded: Vec<usize>,
}

impl<'a> QueryScene<'a> {
    /// From shapes and their poses.
    ///
    /// # Errors
    /// When a pose is not finite, or there are more than 2^32 - 1 bodies.
    pub fn new(bodies: impl IntoIterator<Item = (&'a Shape, Pose)>) -> Result<Self, QueryError> {
        let bodies: Vec<(&Shape, Pose)> = bodies.into_iter().collect();
        if u32::try_from(bodies.len()).is_err() {
            return Err(QueryError::TooManyBodies { count: bodies.len(), limit: u32::MAX as usize });
        }
        if bodies.iter().any(|(_, pose)| !pose.is_finite()) {
            return Err(QueryError::NotFinite { what: "a pose" });
        }
        let (bounded, unbounded): (Vec<usize>, Vec<usize>) =
            (0..bodies.len()).partition(|&i| bounds_of(bodies[i].0, &bodies[i].1).is_finite());
        let boxes: Vec<Aabb> = bounded.iter().map(|&i| bounds_of(bodies[i].0, &bodies[i].1)).collect();
        let tree = BoxTree::new(&boxes);
        Ok(Self { bodies, bounded, boxes, tree, unbounded })
    }

    /// How many bodies there are.
    pub fn len(&self) -> usize {
        self.bodies.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// The body with the least signed distance from a point, and the nearest point of its surface; none without bodies.
    /// Of several bodies that contain the point it is the one in which the point is deepest.
    ///
    /// # Errors
    /// When the point is not finite.
    pub fn nearest(&self, point: DVec3) -> Result<Option<(usize, SurfacePoint)>, QueryError> {
        let mut best: Option<(usize, SurfacePoint)> = None;
        let offer = |best: &mut Option<(usize, SurfacePoint)>, body: usize| -> Result<(), QueryError> {
            let (shape, pose) = &self.bodies[body];
            let found = closest_point(shape, pose, point)?;
            let beats =
                |(other, other_found): (usize, SurfacePoint)| (found.distance, body) < (other_found.distance, other);
            if best.is_none_or(beats) {
                *best = Some((body, found));
            }
            Ok(())
        };
        for &body in &self.unbounded {
            offer(&mut best, body)?;
        }
        // Boxes that contain the point are always searched: their bound is zero, but the signed distance inside is
        // negative.
        let here = Aabb::of_point(point);
        let mut failed = None;
        let start = best.map_or(f64::INFINITY, |(_, found)| found.distance);
        self.tree.least(start, 0.0, &|bounds| box_distance(bounds, &here), &mut |item, least| {
            if box_distance(&self.boxes[item as usize], &here) <= least.max(0.0)
                && let Err(error) = offer(&mut best, self.bounded[item as usize])
            {
                failed = Some(error);
            }
            best.map_or(f64::INFINITY, |(_, found)| found.distance)
        });
        if let Some(error) = failed {
            return Err(error);
        }
        if best.is_none() && !point.is_finite() {
            return Err(QueryError::NotFinite { what: "the point" });
        }
        Ok(best)
    }

    /// All bodies that overlap a shape, ascending; touch counts ([`overlap`]).
    ///
    /// # Errors
    /// When the pose is not finite.
    pub fn overlapping(&self, shape: &Shape, pose: &Pose) -> Result<Vec<usize>, QueryError> {
        if !pose.is_finite() {
            return Err(QueryError::NotFinite { what: "the pose" });
        }
        let wanted = bounds_of(shape, pose);
        let mut found = Vec::new();
        self.visit(&|bounds| bounds.overlaps(&wanted), &mut |body| {
            let (other, other_pose) = &self.bodies[body];
            if overlap(other, other_pose, shape, pose) {
                found.push(body);
            }
        });
        found.sort_unstable();
        Ok(found)
    }

    /// All bodies that overlap an axis-aligned box, ascending; touch counts.
    ///
    /// # Errors
    /// When the box is flat or unbounded.
    pub fn overlapping_box(&self, aabb: &Aabb) -> Result<Vec<usize>, QueryError> {
        let shape = Shape::cuboid(aabb.max() - aabb.min()).map_err(|_| QueryError::FlatBox)?;
        self.overlapping(&shape, &Pose::from_translation(aabb.middle()))
    }

    /// The first body that a ray hits within `max_distance` (m, may be infinite), and the hit; of bodies at the same
    /// distance the lowest index.
    pub fn first_hit(&self, ray: &Ray, max_distance: f64) -> Option<(usize, RayHit)> {
        let mut best: Option<(usize, RayHit)> = None;
        let offer = |best: &mut Option<(usize, RayHit)>, body: usize| {
            let (shape, pose) = &self.bodies[body];
            let limit = best.map_or(max_distance, |(_, hit)| hit.distance);
            if let Some(hit) = ray_cast(shape, pose, ray, limit)
                && best.is_none_or(|(other, first)| (hit.distance, body) < (first.distance, other))
            {
                *best = Some((body, hit));
            }
        };
        for &body in &self.unbounded {
            offer(&mut best, body);
        }
        // A missed box has an infinite bound; the limit must be finite to exclude it.
        let limit = max_distance.min(f64::MAX);
        let bound = |bounds: &Aabb| entry_distance(bounds, ray.origin(), ray.direction()).unwrap_or(f64::INFINITY);
        let nearest = |best: &Option<(usize, RayHit)>| best.map_or(limit, |(_, hit)| hit.distance);
        self.tree.least(nearest(&best), 0.0, &bound, &mut |item, least| {
            if bound(&self.boxes[item as usize]) <= least {
                offer(&mut best, self.bounded[item as usize]);
            }
            nearest(&best)
        });
        best
    }

    /// All bodies that a ray hits within `max_distance` (m), each with its first hit, sorted by distance and then by
    /// index.
    pub fn all_hits(&self, ray: &Ray, max_distance: f64) -> Vec<(usize, RayHit)> {
        let mut hits = Vec::new();
        let passes = |bounds: &Aabb| {
            entry_distance(bounds, ray.origin(), ray.direction()).is_some_and(|enter| enter <= max_distance)
        };
        self.visit(&passes, &mut |body| {
            let (shape, pose) = &self.bodies[body];
            hits.extend(ray_cast(shape, pose, ray, max_distance).map(|hit| (body, hit)));
        });
        hits.sort_by(|(i, p), (j, q)| p.distance.total_cmp(&q.distance).then(i.cmp(j)));
        hits
    }

    /// Calls `visit` with every unbounded body and every body for whose box `passes` is true.
    fn visit(&self, passes: &impl Fn(&Aabb) -> bool, visit: &mut impl FnMut(usize)) {
        self.unbounded.iter().for_each(|&body| visit(body));
        self.tree.passing(passes, &mut |item| {
            let body = self.bounded[item as usize];
            if passes(&self.boxes[item as usize]) {
                visit(body);
            }
        });
    }
}

/// The box around a shape at a finite pose; unbounded for a half-space.
fn bounds_of(shape: &Shape, pose: &Pose) -> Aabb {
    aabb_of(shape, pose).unwrap_or(Aabb::UNBOUNDED)
}

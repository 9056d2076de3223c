//! The same questions to many bodies at once: nearest, overlapping, hit by a ray.
//!
//! A tree of bounding boxes, split in the middle of the longest side by the order of the boxes' centres, tells which
//! bodies may answer; every answer comes from the shapes. Bodies are named by their index, and of equal answers the lowest
//! index is taken, so that nothing depends on the tree.

use super::QueryError;
use super::closest_point::{SurfacePoint, closest_point};
use super::overlap::overlap;
use super::pieces::bounds;
use super::ray_cast::{Ray, RayHit, ray_cast};
use crate::{Aabb, Shape};
use glam::DVec3;
use polhode_spatial::Pose;

/// Bodies at rest for questions.
///
/// ```
/// use polhode_contact::{QueryScene, Ray, Shape};
/// use polhode_spatial::{DVec3, Pose, UnitVector};
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
    boxes: Vec<Bounds>,
    nodes: Vec<Node>,
    /// Bounded bodies in the order of the leaves.
    order: Vec<usize>,
    unbounded: Vec<usize>,
}

#[derive(Debug, Clone, Copy)]
struct Bounds {
    low: DVec3,
    high: DVec3,
}

#[derive(Debug, Clone, Copy)]
struct Node {
    bounds: Bounds,
    /// Range of the order below this node.
    first: usize,
    last: usize,
    /// The two children; a leaf has none.
    children: Option<[usize; 2]>,
}

/// Most bodies of a leaf.
const LEAF: usize = 4;

impl Bounds {
    const NONE: Self = Self { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    fn joined(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Distance of a point, m; 0 inside.
    fn distance(&self, point: DVec3) -> f64 {
        (self.low - point).max(point - self.high).max(DVec3::ZERO).length()
    }

    fn overlaps(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }

    /// Where a ray enters, m; nothing for a miss.
    fn entered(&self, ray: &Ray) -> Option<f64> {
        let (mut enter, mut leave): (f64, f64) = (0.0, f64::INFINITY);
        for axis in 0..3 {
            let (from, rate) = (ray.origin()[axis], ray.direction()[axis]);
            if rate == 0.0 {
                if from < self.low[axis] || from > self.high[axis] {
                    return None;
                }
                continue;
            }
            let (s, t) = ((self.low[axis] - from) / rate, (self.high[axis] - from) / rate);
            enter = enter.max(s.min(t));
            leave = leave.min(s.max(t));
        }
        // Rounding of the quotients must not lose a body whose box is flat.
        (enter <= leave * (1.0 + SLACK)).then_some(enter * (1.0 - SLACK))
    }
}

/// Relative rounding of the quotients of a ray and a box, with room.
const SLACK: f64 = 8.0 * f64::EPSILON;

impl<'a> QueryScene<'a> {
    /// From shapes and their poses.
    ///
    /// # Errors
    /// When a pose is not finite, or there are more bodies than 2^32.
    pub fn new(bodies: impl IntoIterator<Item = (&'a Shape, Pose)>) -> Result<Self, QueryError> {
        let bodies: Vec<(&Shape, Pose)> = bodies.into_iter().collect();
        if u32::try_from(bodies.len()).is_err() {
            return Err(QueryError::TooManyBodies { count: bodies.len(), limit: u32::MAX as usize });
        }
        if bodies.iter().any(|(_, pose)| !pose.is_finite()) {
            return Err(QueryError::NotFinite { what: "a pose" });
        }
        let boxes: Vec<Bounds> =
            bodies.iter().map(|(shape, pose)| bounds(shape, pose)).map(|(low, high)| Bounds { low, high }).collect();
        let (order, unbounded) =
            (0..bodies.len()).partition(|&i| boxes[i].low.is_finite() && boxes[i].high.is_finite());
        let mut scene = Self { bodies, boxes, nodes: Vec::new(), order, unbounded };
        if !scene.order.is_empty() {
            scene.split(0, scene.order.len());
        }
        Ok(scene)
    }

    /// How many bodies there are.
    pub fn len(&self) -> usize {
        self.bodies.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// The body whose surface or inside is nearest to a point, and the nearest place of its surface; nothing without
    /// bodies. Among bodies that contain the point that in which it is deepest.
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
        let mut stack: Vec<usize> = (0..self.nodes.len().min(1)).collect();
        while let Some(index) = stack.pop() {
            let node = &self.nodes[index];
            // A body that contains the point may be deeper than any box tells: boxes around the point are always opened.
            let nearest = |bounds: &Bounds| bounds.distance(point);
            let beyond = |best: &Option<(usize, SurfacePoint)>, bounds: &Bounds| {
                let nearest = nearest(bounds);
                nearest > 0.0 && best.is_some_and(|(_, found)| nearest > found.distance.max(0.0))
            };
            if beyond(&best, &node.bounds) {
                continue;
            }
            if let Some([left, right]) = node.children {
                let nearer_first = nearest(&self.nodes[left].bounds) <= nearest(&self.nodes[right].bounds);
                stack.extend(if nearer_first { [right, left] } else { [left, right] });
                continue;
            }
            for &body in &self.order[node.first..node.last] {
                if !beyond(&best, &self.boxes[body]) {
                    offer(&mut best, body)?;
                }
            }
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
        let (low, high) = bounds(shape, pose);
        let wanted = Bounds { low, high };
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

    /// All bodies that overlap a box along the world's axes, ascending; touch counts.
    ///
    /// # Errors
    /// When the box is flat or unbounded.
    pub fn overlapping_box(&self, aabb: &Aabb) -> Result<Vec<usize>, QueryError> {
        let shape = Shape::cuboid(aabb.max() - aabb.min()).map_err(|_| QueryError::FlatBox)?;
        self.overlapping(&shape, &Pose::from_translation(0.5 * aabb.min() + 0.5 * aabb.max()))
    }

    /// The body that a ray meets first, and where; of bodies met at one distance the lowest index.
    pub fn first_hit(&self, ray: &Ray, max_distance: f64) -> Option<(usize, RayHit)> {
        let mut best: Option<(usize, RayHit)> = None;
        let offer = |best: &mut Option<(usize, RayHit)>, body: usize| {
            let (shape, pose) = &self.bodies[body];
            let reach = best.map_or(max_distance, |(_, hit)| hit.distance);
            if let Some(hit) = ray_cast(shape, pose, ray, reach)
                && best.is_none_or(|(other, first)| (hit.distance, body) < (first.distance, other))
            {
                *best = Some((body, hit));
            }
        };
        for &body in &self.unbounded {
            offer(&mut best, body);
        }
        let mut stack: Vec<usize> = (0..self.nodes.len().min(1)).collect();
        while let Some(index) = stack.pop() {
            let node = &self.nodes[index];
            let reach = best.map_or(max_distance, |(_, hit)| hit.distance);
            if !node.bounds.entered(ray).is_some_and(|enter| enter <= reach) {
                continue;
            }
            match node.children {
                Some([left, right]) => {
                    let enters = |child: usize| self.nodes[child].bounds.entered(ray).unwrap_or(f64::INFINITY);
                    stack.extend(if enters(left) <= enters(right) { [right, left] } else { [left, right] });
                }
                None => self.order[node.first..node.last].iter().for_each(|&body| offer(&mut best, body)),
            }
        }
        best
    }

    /// All bodies that a ray meets, each where it meets it first, sorted by distance and then by index.
    pub fn all_hits(&self, ray: &Ray, max_distance: f64) -> Vec<(usize, RayHit)> {
        let mut hits = Vec::new();
        self.visit(&|bounds| bounds.entered(ray).is_some_and(|enter| enter <= max_distance), &mut |body| {
            let (shape, pose) = &self.bodies[body];
            hits.extend(ray_cast(shape, pose, ray, max_distance).map(|hit| (body, hit)));
        });
        hits.sort_by(|(i, p), (j, q)| p.distance.total_cmp(&q.distance).then(i.cmp(j)));
        hits
    }

    /// Calls `visit` with every body whose box, and those of all nodes above it, pass.
    fn visit(&self, passes: &dyn Fn(&Bounds) -> bool, visit: &mut dyn FnMut(usize)) {
        self.unbounded.iter().for_each(|&body| visit(body));
        let mut stack: Vec<usize> = (0..self.nodes.len().min(1)).collect();
        while let Some(index) = stack.pop() {
            let node = &self.nodes[index];
            if !passes(&node.bounds) {
                continue;
            }
            if let Some(children) = node.children {
                stack.extend(children);
            } else {
                let below = self.order[node.first..node.last].iter();
                below.filter(|&&body| passes(&self.boxes[body])).for_each(|&body| visit(body));
            }
        }
    }

    /// Makes the node of a range of the order, and those below it.
    fn split(&mut self, first: usize, last: usize) -> usize {
        let below = self.order[first..last].iter().map(|&body| self.boxes[body]);
        let bounds = below.fold(Bounds::NONE, Bounds::joined);
        let index = self.nodes.len();
        self.nodes.push(Node { bounds, first, last, children: None });
        if last - first > LEAF {
            let extent = bounds.high - bounds.low;
            let axis = (0..3).fold(0, |best, axis| if extent[axis] > extent[best] { axis } else { best });
            let middle = |body: &usize| 0.5 * self.boxes[*body].low[axis] + 0.5 * self.boxes[*body].high[axis];
            let mut sorted = self.order[first..last].to_vec();
            sorted.sort_by(|p, q| middle(p).total_cmp(&middle(q)).then(p.cmp(q)));
            self.order[first..last].copy_from_slice(&sorted);
            let half = first.midpoint(last);
            let children = [self.split(first, half), self.split(half, last)];
            self.nodes[index].children = Some(children);
        }
        index
    }
}

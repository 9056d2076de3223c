//! Compounds: bodies of several parts that are fixed to each other.

use super::error::ShapeError;
use super::kinds::{Compound, FirstElements, Shape};
use super::point_cloud::EXACT_SIZE_LIMIT;
use crate::bounding::BoxTree;
use crate::bounding::aabb::Aabb;
use glam::DVec3;
use polhode_spatial::Pose;

/// Numbers reserved for a curved part in each kind of feature: more than any such shape has.
const CURVED_ELEMENTS: usize = 2 * crate::shape::circle::RIM_POINTS as usize;

impl Compound {
    /// From parts, each in the body's frame; a compound among them is replaced by its parts.
    ///
    /// # Errors
    /// When there is no part, one is a half-space or a triangle mesh, which must be a body of their own, or there are
    /// more than 2^32 - 1 vertices.
    pub fn new(parts: Vec<Shape>) -> Result<Self, ShapeError> {
        let mut flat = Vec::with_capacity(parts.len());
        for part in parts {
            match part {
                Shape::Compound(inner) => flat.extend(inner.parts),
                Shape::HalfSpace(_) => return Err(ShapeError::NotAPart { what: "a half-space" }),
                Shape::TriangleMesh(_) => return Err(ShapeError::NotAPart { what: "a triangle mesh" }),
                part => flat.push(part),
            }
        }
        if flat.is_empty() {
            return Err(ShapeError::NoPart { what: "parts" });
        }
        let first = numbered(&flat)?;
        let boxes: Vec<Aabb> = flat.iter().map(|part| part.bounds_at(&Pose::IDENTITY)).collect();
        // Searches ask for these lengths at every evaluation: they are computed once.
        let size = size_of(&flat);
        let radius = flat.iter().map(Shape::radius).fold(0.0, f64::max);
        let least_part_size = flat.iter().map(Shape::size).filter(|s| *s > 0.0).fold(f64::INFINITY, f64::min);
        Ok(Self { parts: flat, first, tree: BoxTree::new(&boxes), size, radius, least_part_size })
    }

    /// The parts, in the body's frame.
    pub fn parts(&self) -> &[Shape] {
        &self.parts
    }

    pub(super) fn placed(&self, pose: &Pose) -> Result<Self, ShapeError> {
        Self::new(self.parts.iter().map(|part| part.placed(pose)).collect::<Result<_, _>>()?)
    }

    /// The largest distance between two points, m; curved parts are replaced by balls around them.
    pub(super) const fn size(&self) -> f64 {
        self.size
    }

    /// The part that owns a feature, its shape, and the feature's number within it. `of` selects the kind of feature.
    pub(crate) fn owner(&self, number: u32, of: impl Fn(&FirstElements) -> u32) -> Option<(usize, &Shape, u32)> {
        // A part without such features has the same first number as the next part; the last of them owns the feature.
        let part = self.first.partition_point(|first| of(first) <= number).checked_sub(1)?;
        Some((part, self.parts.get(part)?, number - of(&self.first[part])))
    }
}

/// First numbers of the features of every kind, one part after the other.
fn numbered(parts: &[Shape]) -> Result<Vec<FirstElements>, ShapeError> {
    let mut totals = [0_usize; 3];
    let mut first = Vec::with_capacity(parts.len() + 1);
    for part in parts.iter().map(Some).chain([None]) {
        let [vertex, edge, face] = totals;
        let limit = u32::MAX as usize;
        if vertex.max(edge).max(face) >= limit {
            return Err(ShapeError::TooManyPoints { count: vertex.max(edge).max(face), limit });
        }
        first.push(FirstElements { vertex: vertex as u32, edge: edge as u32, face: face as u32 });
        let counts = match part {
            None => [0; 3],
            Some(Shape::Convex(p)) => [p.vertices().len(), p.edges().len(), p.face_count()],
            Some(Shape::Sphere(_)) => [1, 0, 0],
            Some(Shape::Points(c)) => [c.points().len(), 0, 0],
            Some(_) => [CURVED_ELEMENTS; 3],
        };
        totals = [totals[0] + counts[0], totals[1] + counts[1], totals[2] + counts[2]];
    }
    Ok(first)
}

fn size_of(parts: &[Shape]) -> f64 {
    let mut balls: Vec<(DVec3, f64, usize)> = Vec::new();
    for (index, part) in parts.iter().enumerate() {
        part.for_each_ball(&mut |center, radius| balls.push((center, radius, index)));
    }
    let mut largest = parts.iter().map(Shape::size).fold(0.0, f64::max);
    if balls.len() > EXACT_SIZE_LIMIT {
        let bounds = balls.iter().fold(Aabb::EMPTY, |b, &(c, r, _)| b.merged(&Aabb { min: c - r, max: c + r }));
        return largest.max((bounds.max - bounds.min).length());
    }
    for (i, &(center, radius, part)) in balls.iter().enumerate() {
        for &(other, other_radius, other_part) in &balls[i + 1..] {
            if part != other_part {
                largest = largest.max(center.distance(other) + radius + other_radius);
            }
        }
    }
    largest
}

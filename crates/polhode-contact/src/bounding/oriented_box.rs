//! Oriented bounding boxes.

use super::axis_aligned_box::ROUNDING_ULPS;
use super::extent::extents;
use crate::Shape;
use glam::{DMat3, DVec3};
use polhode_spatial::{Pose, Rotation};

/// At most so many orientations are tried for one shape; of more, every second, third, ... is.
const MOST_ORIENTATIONS: usize = 400;

/// A box that contains a shape and stands in any direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrientedBox {
    /// Its centre and axes.
    pose: Pose,
    half_size: DVec3,
}

impl OrientedBox {
    /// A box about a shape, in the shape's frame; none for a half-space. Of the boxes along the axes of the frame, flush
    /// with a face and one of its edges, or along the axes of round shapes and of parts, it is the smallest. The
    /// smallest box of all has an edge of the hull on each of two sides, but not always a face (docs/REFERENCES.md,
    /// O'Rourke 1985), so that it may be somewhat smaller.
    pub fn of(shape: &Shape) -> Option<Self> {
        if let Shape::HalfSpace(_) = shape {
            return None;
        }
        let mut orientations = vec![Rotation::IDENTITY];
        collect_orientations(shape, &mut orientations);
        let stride = orientations.len().div_ceil(MOST_ORIENTATIONS);
        let boxes = orientations.into_iter().step_by(stride.max(1)).map(|rotation| Self::along(shape, rotation));
        // Flat boxes have no volume; their area tells which is smaller.
        let size = |candidate: &Self| (candidate.volume(), candidate.half_area());
        boxes.reduce(|best, next| if size(&next) < size(&best) { next } else { best })
    }

    /// The box about a shape along the axes of a frame.
    fn along(shape: &Shape, rotation: Rotation) -> Self {
        let (low, high) = extents(shape, &rotation.to_matrix());
        Self::between(rotation, low, high)
    }

    /// From the lower and upper bounds along the axes of a frame, with the rounding of coordinates of their size.
    fn between(rotation: Rotation, low: DVec3, high: DVec3) -> Self {
        let rounding = ROUNDING_ULPS * f64::EPSILON * low.abs().max(high.abs()).max_element();
        let center = rotation.rotate(0.5 * (low + high));
        Self { pose: Pose::new(rotation, center), half_size: 0.5 * (high - low) + rounding }
    }

    /// Centre, m.
    pub const fn center(&self) -> DVec3 {
        self.pose.translation
    }

    /// The box's axes.
    pub const fn rotation(&self) -> Rotation {
        self.pose.rotation
    }

    /// Half of each edge, m.
    pub const fn half_size(&self) -> DVec3 {
        self.half_size
    }

    /// Volume, m^3.
    pub fn volume(&self) -> f64 {
        8.0 * self.half_size.x * self.half_size.y * self.half_size.z
    }

    fn half_area(&self) -> f64 {
        let h = self.half_size;
        h.x * h.y + h.y * h.z + h.z * h.x
    }

    /// Whether the point (m) is in the box; a point outside by rounding counts.
    pub fn contains(&self, point: DVec3) -> bool {
        let rounding = self.rounding(point.abs().max_element());
        let local = self.pose.rotation.inverse_rotate(point - self.pose.translation);
        local.abs().cmple(self.half_size + rounding).all()
    }

    /// Whether the boxes share a point, by the separating-axis test with the fifteen axes of two boxes
    /// (docs/REFERENCES.md, Gottschalk 1996). An axis separates only by more than rounding, so that boxes that touch
    /// are never called apart; also cross products of almost parallel edges, which are only rounding, then separate
    /// nothing.
    pub fn overlaps(&self, other: &Self) -> bool {
        let between = other.pose.translation - self.pose.translation;
        let (a, b) = (self.pose.rotation.to_matrix(), other.pose.rotation.to_matrix());
        let reach =
            |axes: &DMat3, half: DVec3, axis: DVec3| (0..3).map(|k| half[k] * axes.col(k).dot(axis).abs()).sum::<f64>();
        let rounding = self.rounding(other.pose.translation.abs().max_element()) + other.rounding(0.0);
        let separates = |axis: DVec3| {
            between.dot(axis).abs() > reach(&a, self.half_size, axis) + reach(&b, other.half_size, axis) + rounding
        };
        let faces = (0..3).flat_map(|k| [a.col(k), b.col(k)]);
        let edges = (0..9).map(|k| a.col(k / 3).cross(b.col(k % 3)));
        !faces.chain(edges).any(separates)
    }

    /// A box that contains both: along the axes of one of them, whichever is smaller.
    pub fn merged(&self, other: &Self) -> Self {
        let (first, second) = (self.enclosing(other), other.enclosing(self));
        if second.volume() < first.volume() { second } else { first }
    }

    /// The box of the shape at a pose.
    pub fn transformed(&self, pose: &Pose) -> Self {
        let moved = *pose * self.pose;
        let rounding = ROUNDING_ULPS * f64::EPSILON * (moved.translation.abs().max_element() + self.half_size.length());
        Self { pose: moved, half_size: self.half_size + rounding }
    }

    /// The eight corners, m.
    pub fn corners(&self) -> [DVec3; 8] {
        std::array::from_fn(|k| {
            let sign = |bit: usize| if k >> bit & 1 == 0 { -1.0 } else { 1.0 };
            self.pose.transform_point(self.half_size * DVec3::new(sign(0), sign(1), sign(2)))
        })
    }

    /// The box along this one's axes that contains both.
    fn enclosing(&self, other: &Self) -> Self {
        let center = self.pose.translation;
        let locals = other.corners().map(|corner| self.pose.rotation.inverse_rotate(corner - center));
        let fold = |init: DVec3, pick: fn(DVec3, DVec3) -> DVec3| locals.iter().fold(init, |bound, &p| pick(bound, p));
        let (low, high) = (fold(-self.half_size, DVec3::min), fold(self.half_size, DVec3::max));
        let local = Self::between(Rotation::IDENTITY, low, high);
        let rounding = self.rounding(other.pose.translation.abs().max_element());
        let center = center + self.pose.rotation.rotate(local.pose.translation);
        Self { pose: Pose::new(self.pose.rotation, center), half_size: local.half_size + rounding }
    }

    /// What a computation with this box and a coordinate may err, m.
    fn rounding(&self, coordinate: f64) -> f64 {
        let own = self.pose.translation.abs().max_element() + self.half_size.length();
        ROUNDING_ULPS * f64::EPSILON * (own + coordinate)
    }
}

/// Orientations that suit the shape.
fn collect_orientations(shape: &Shape, orientations: &mut Vec<Rotation>) {
    match shape {
        Shape::Convex(polyhedron) => {
            let vertices = polyhedron.vertices();
            for face in polyhedron.faces() {
                let ring = face.vertices;
                for (k, &start) in ring.iter().enumerate() {
                    let end = ring[(k + 1) % ring.len()];
                    let edge = vertices[end as usize] - vertices[start as usize];
                    orientations.extend(frame(face.normal, edge));
                }
            }
        }
        Shape::TriangleMesh(mesh) => {
            for triangle in &mesh.triangles {
                let [p, q, r] = triangle.map(|vertex| mesh.vertices[vertex as usize]);
                orientations.extend(frame((q - p).cross(r - p), q - p));
            }
        }
        Shape::Points(cloud) => orientations.extend(spread(&cloud.points)),
        Shape::Capsule(c) => orientations.extend(about(c.ends[1] - c.ends[0])),
        Shape::Cylinder(c) => orientations.extend(about(c.axis)),
        Shape::Cone(c) => orientations.extend(about(c.axis)),
        Shape::Torus(t) => orientations.extend(about(t.axis)),
        Shape::Compound(c) => c.parts.iter().for_each(|part| collect_orientations(part, orientations)),
        Shape::Sphere(_) | Shape::HalfSpace(_) => {}
    }
}

/// The frame with its z axis along `z` and its x axis in the half-plane of `x`; none when they do not span a plane.
fn frame(z: DVec3, x: DVec3) -> Option<Rotation> {
    let z = z.try_normalize()?;
    let x = (x - z * x.dot(z)).try_normalize()?;
    let rotation = Rotation::from_matrix(&DMat3::from_cols(x, z.cross(x), z));
    rotation.is_finite().then_some(rotation)
}

/// A frame with its z axis along `axis`.
fn about(axis: DVec3) -> Option<Rotation> {
    frame(axis, axis.any_orthogonal_vector())
}

/// The frame along the longest chord from the point farthest from the first, and across it to the farthest point.
fn spread(points: &[DVec3]) -> Option<Rotation> {
    let farthest =
        |measure: &dyn Fn(DVec3) -> f64| points.iter().copied().max_by(|&p, &q| measure(p).total_cmp(&measure(q)));
    let first = *points.first()?;
    let a = farthest(&|p| p.distance_squared(first))?;
    let b = farthest(&|p| p.distance_squared(a))?;
    let axis = (b - a).try_normalize()?;
    let c = farthest(&|p| (p - a).cross(axis).length_squared())?;
    frame(axis, c - a).or_else(|| about(axis))
}

//! Whether a shape is its own mirror image.
//!
//! Bodies that are symmetric in one plane and move parallel to it keep this symmetry: the engine checks the shapes of a
//! planar motion with this module. A point x has the image `x - 2 (n.x - d) n` in the plane `n.x = d`.

use crate::Shape;
use crate::shape::circle::Circle;
use crate::shape::round::circles;
use glam::DVec3;
use polhode_spatial::UnitVector;

/// Largest cosine between perpendicular directions: the rounding of two rotated unit vectors.
const PERPENDICULAR: f64 = 4.0 * f64::EPSILON;

/// How far the shape is from being its own mirror image in the plane `normal . x = offset` (m) of its frame: the
/// largest distance of the image of a vertex, point or centre from the nearest one of the shape, m; for a half-space
/// infinity, unless its plane is perpendicular to the mirror plane. Zero for a symmetric shape, to the rounding of its
/// coordinates.
pub fn mirror_defect(shape: &Shape, normal: UnitVector, offset: f64) -> f64 {
    let n = normal.get();
    let image = |x: DVec3| x - n * (2.0 * (n.dot(x) - offset));
    if let Shape::HalfSpace(half_space) = shape {
        let along = half_space.normal().dot(n).abs();
        return if along <= PERPENDICULAR { 0.0 } else { f64::INFINITY };
    }
    if let Shape::TriangleMesh(mesh) = shape {
        return mesh
            .joined
            .iter()
            .flatten()
            .map(|&v| mesh.vertices[v as usize])
            .map(|p| mesh.distance_to_vertex(image(p)))
            .fold(0.0, f64::max);
    }
    let own = circles(shape);
    if !own.is_empty() {
        return circles_defect(shape, &own, n, image);
    }
    // The image of each part must be one of the parts; curved parts are compared by the balls whose hull contains them.
    let mut balls: Vec<(DVec3, f64)> = Vec::new();
    shape.for_each_ball(&mut |center, radius| balls.push((center, radius)));
    let distance = |x: DVec3, radius: f64| {
        let apart = |&(p, r): &(DVec3, f64)| (p - x).length().max((r - radius).abs());
        balls.iter().map(apart).fold(f64::INFINITY, f64::min)
    };
    balls.iter().map(|&(p, radius)| distance(image(p), radius)).fold(0.0, f64::max)
}

/// The same for a shape with circles: the image of each must be a circle of the shape. The axis of a rim has a sign
/// (outwards), that of a torus has none.
fn circles_defect(shape: &Shape, own: &[Circle], n: DVec3, image: impl Fn(DVec3) -> DVec3) -> f64 {
    let turned = |a: DVec3| if n.dot(a).abs() <= PERPENDICULAR { a } else { a - n * (2.0 * n.dot(a)) };
    let two_sided = shape.is_ring();
    let distance = |circle: &Circle, axis: DVec3| {
        let aligned = (circle.axis - axis).length();
        let aligned = if two_sided { aligned.min((circle.axis + axis).length()) } else { aligned };
        if aligned <= PERPENDICULAR { 0.0 } else { circle.radius * aligned }
    };
    let defect = |circle: &Circle| {
        let (center, axis) = (image(circle.center), turned(circle.axis));
        let nearest = own.iter().map(|other| (other.center - center).length() + distance(other, axis));
        nearest.fold(f64::INFINITY, f64::min)
    };
    own.iter().map(defect).fold(0.0, f64::max)
}

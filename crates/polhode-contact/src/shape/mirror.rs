//! Whether a shape is its own mirror image.
//!
//! Bodies that are symmetric in one plane and move parallel to it keep this symmetry: the engine checks the shapes of a
//! planar motion with this module. A point x has the image `x - 2 (n.x - d) n` in the plane `n.x = d`.

use crate::Shape;
use crate::shape::circle::Circle;
use crate::shape::round::circles;
use glam::DVec3;
use polhode_spatial::UnitVector;
use polhode_spatial::rounding;

/// How far the shape is from being its own mirror image in the plane `normal . x = offset` (m) of its frame: the
/// largest distance of the image of a vertex, point or centre from the nearest one of the shape, m; for a half-space
/// infinity, unless its plane is perpendicular to the mirror plane. Zero for a symmetric shape, to the rounding of its
/// coordinates.
pub fn mirror_defect(shape: &Shape, normal: UnitVector, offset: f64) -> f64 {
    let n = normal.get();
    let image = |x: DVec3| x - n * (2.0 * (n.dot(x) - offset));
    if let Shape::HalfSpace(half_space) = shape {
        let along = half_space.normal().dot(n).abs();
        return if along <= rounding::FEW_TERMS { 0.0 } else { f64::INFINITY };
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
    let mut balls: Vec<Ball> = Vec::new();
    shape.for_each_ball(&mut |center, radius| balls.push(Ball { center, radius }));
    let sorted = SortedBalls::new(balls);
    let defects = sorted.balls.iter().map(|ball| sorted.least_distance(&Ball { center: image(ball.center), ..*ball }));
    defects.fold(0.0, f64::max)
}

/// A ball of a shape, m.
#[derive(Debug, Clone, Copy)]
struct Ball {
    center: DVec3,
    radius: f64,
}

impl Ball {
    /// How far another ball is from being this one, m: the larger of the distance of the centres and the difference of
    /// the radii.
    fn distance(&self, other: &Self) -> f64 {
        (self.center - other.center).length().max((self.radius - other.radius).abs())
    }
}

/// Balls, sorted along the axis in which their centres lie farthest apart: a ball that is farther away along the axis
/// than the nearest one known cannot be nearer.
struct SortedBalls {
    balls: Vec<Ball>,
    axis: usize,
}

impl SortedBalls {
    fn new(mut balls: Vec<Ball>) -> Self {
        let centers = || balls.iter().map(|ball| ball.center);
        let least = centers().fold(DVec3::INFINITY, DVec3::min);
        let most = centers().fold(DVec3::NEG_INFINITY, DVec3::max);
        let axis = (most - least).max_position();
        balls.sort_by(|p, q| p.center[axis].total_cmp(&q.center[axis]));
        Self { balls, axis }
    }

    /// The least distance of any of the balls from one, m; infinite when there are none.
    fn least_distance(&self, ball: &Ball) -> f64 {
        let place = ball.center[self.axis];
        let (below, above) = self.balls.split_at(self.balls.partition_point(|other| other.center[self.axis] < place));
        let mut least = f64::INFINITY;
        for other in above {
            if other.center[self.axis] - place > least {
                break;
            }
            least = least.min(other.distance(ball));
        }
        for other in below.iter().rev() {
            if place - other.center[self.axis] > least {
                break;
            }
            least = least.min(other.distance(ball));
        }
        least
    }
}

/// The same for a shape with circles: the image of each must be a circle of the shape. The axis of a rim has a sign
/// (outwards), that of a torus has none.
fn circles_defect(shape: &Shape, own: &[Circle], n: DVec3, image: impl Fn(DVec3) -> DVec3) -> f64 {
    let turned = |a: DVec3| if n.dot(a).abs() <= rounding::FEW_TERMS { a } else { a - n * (2.0 * n.dot(a)) };
    let two_sided = shape.is_ring();
    let distance = |circle: &Circle, axis: DVec3| {
        let aligned = (circle.axis - axis).length();
        let aligned = if two_sided { aligned.min((circle.axis + axis).length()) } else { aligned };
        if aligned <= rounding::FEW_TERMS { 0.0 } else { circle.radius * aligned }
    };
    let defect = |circle: &Circle| {
        let (center, axis) = (image(circle.center), turned(circle.axis));
        let nearest = own.iter().map(|other| (other.center - center).length() + distance(other, axis));
        nearest.fold(f64::INFINITY, f64::min)
    };
    own.iter().map(defect).fold(0.0, f64::max)
}

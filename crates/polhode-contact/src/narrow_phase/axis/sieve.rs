//! Exclusion of elements of a polyhedron that cannot have the best axis of a pair. Most cannot, and each costs a
//! search.
//!
//! Gilbert's method (docs/REFERENCES.md, Gilbert 1966) iterates over points `z` of the Minkowski difference A - B
//! towards the origin. `U = |z|` is an upper bound of the distance of the bodies. When the bodies are separated, the
//! two deciding elements are at most `U` apart. When the bodies overlap, they are no farther apart than the overlap
//! along any axis that is already known. So only elements within this distance of the other body's box can decide.
//!
//! When the bodies are separated, elements that reach far towards the other body are tried first.

use crate::narrow_phase::axis::body::Body;
use crate::{Shape, SurfaceFeature};
use glam::DVec3;

/// Number of steps of Gilbert's method. The bound need not be sharp.
const STEPS: usize = 16;

/// Fraction of a polyhedron's size: features within it of the support point towards the other body are tried first.
const NEAR_PART: f64 = 0.05;

/// Which elements are tried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Pass {
    /// Elements that reach far towards the other body.
    Near,
    /// All elements that can decide.
    All,
}

/// The box of the other body, inflated by the bound of the distance.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    low: DVec3,
    high: DVec3,
    /// Direction towards the other body, and the least height along it that is near.
    toward: DVec3,
    near: f64,
}

/// The bounds that are known before elements are searched.
pub(crate) struct Sieve {
    a: Option<Bounds>,
    b: Option<Bounds>,
}

impl Sieve {
    /// `known` is the separation along some axis, `slack` a bound of its rounding (m).
    pub(crate) fn new(a: &Body<'_>, b: &Body<'_>, known: f64, slack: f64) -> Self {
        let is_polyhedron = |body: &Body<'_>| body.point.is_none() && matches!(body.shape, Shape::Convex(_));
        if !(is_polyhedron(a) || is_polyhedron(b)) {
            return Self { a: None, b: None };
        }
        let z = nearest_difference(a, b);
        let bound = z.length().max(-known) + slack;
        let of = |body: &Body<'_>, other: &Body<'_>, toward: DVec3| {
            is_polyhedron(body).then(|| {
                let high = DVec3::new(other.support(DVec3::X), other.support(DVec3::Y), other.support(DVec3::Z));
                let low =
                    DVec3::new(other.support(DVec3::NEG_X), other.support(DVec3::NEG_Y), other.support(DVec3::NEG_Z));
                let near = body.support(toward) - NEAR_PART * body.shape.size();
                Bounds { low: -low - bound, high: high + bound, toward, near }
            })
        };
        let direction = z.try_normalize().unwrap_or(DVec3::Z);
        Self { a: of(a, b, -direction), b: of(b, a, direction) }
    }

    /// Whether it excludes nothing, so that one pass is enough.
    pub(crate) const fn is_empty(&self) -> bool {
        self.a.is_none() && self.b.is_none()
    }

    pub(crate) fn keeps_of_a(&self, body: &Body<'_>, feature: SurfaceFeature, pass: Pass) -> bool {
        self.a.is_none_or(|bounds| bounds.keeps(body, feature, pass))
    }

    pub(crate) fn keeps_of_b(&self, body: &Body<'_>, feature: SurfaceFeature, pass: Pass) -> bool {
        self.b.is_none_or(|bounds| bounds.keeps(body, feature, pass))
    }
}

impl Bounds {
    fn keeps(&self, body: &Body<'_>, feature: SurfaceFeature, pass: Pass) -> bool {
        let Shape::Convex(polyhedron) = body.shape else { return true };
        let ends = match feature {
            SurfaceFeature::Vertex(vertex) => [vertex; 2],
            SurfaceFeature::Edge(edge) => match polyhedron.edges.get(edge as usize) {
                Some(edge) => edge.vertices,
                None => return false,
            },
            _ => return true,
        };
        let [p, q] = ends.map(|v| body.pose.transform_point(polyhedron.vertices[v as usize]));
        let near = pass == Pass::All || self.toward.dot(p).max(self.toward.dot(q)) >= self.near;
        near && p.min(q).cmple(self.high).all() && p.max(q).cmpge(self.low).all()
    }
}

/// Whether the separation along every normal `o` of an element of a polyhedron is certainly less than `best` (m). These
/// normals are `o = sum alpha_i n_i`, `n_i` those of its faces. For any point `q` of the other body the separation is
/// at most `o.(q - p) = sum alpha_i n_i.(q - p)`, and `sum alpha_i >= 1`, so that it is at most the largest
/// `n_i.(q - p)` when that is negative. `q` is the other body's lowest point over one of the faces.
pub(crate) fn is_worse(body: &Body<'_>, feature: SurfaceFeature, other: &Body<'_>, best: f64) -> bool {
    let Shape::Convex(polyhedron) = body.shape else { return false };
    let (point, faces): (u32, &[u32]) = match feature {
        SurfaceFeature::Vertex(vertex) => (vertex, polyhedron.faces_at.of(vertex as usize)),
        SurfaceFeature::Edge(edge) => match polyhedron.edges.get(edge as usize) {
            Some(edge) => (edge.vertices[0], &edge.faces),
            None => return true,
        },
        _ => return false,
    };
    let normal = |face: u32| body.pose.rotation.rotate(polyhedron.faces[face as usize].normal);
    let point = body.pose.transform_point(polyhedron.vertices[point as usize]);
    let least = faces.iter().take(2).map(|&lowest_over| {
        let from = other.support_point(-normal(lowest_over)) - point;
        faces.iter().map(|&face| normal(face).dot(from)).fold(f64::NEG_INFINITY, f64::max)
    });
    least.fold(f64::INFINITY, f64::min) < best.min(0.0)
}

/// A point of the Minkowski difference of two bodies near the origin.
fn nearest_difference(a: &Body<'_>, b: &Body<'_>) -> DVec3 {
    let difference = |n: DVec3| a.support_point(-n) - b.support_point(n);
    let mut z = difference(a.pose.translation - b.pose.translation);
    for _ in 0..STEPS {
        let Some(n) = z.try_normalize() else { break };
        let step = difference(n) - z;
        let along = -z.dot(step) / step.length_squared();
        // `along` is NaN when the step is zero: then z is the nearest point.
        if along.is_nan() || along <= 0.0 {
            break;
        }
        z += step * along.min(1.0);
    }
    z
}

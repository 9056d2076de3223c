//! The nearest points of two segments, in closed form.

use crate::clearance::PARALLEL_SINE;
use crate::shape::nearer_point::is_nearer;
use crate::shape::support::farthest;
use crate::shape::support::unit;
use crate::shape::triangle::on_segment;
use glam::DVec3;

/// Nearest points of two segments, their distance (m), and the unit vector from the second to the first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NearestPoints {
    pub(crate) on_a: DVec3,
    pub(crate) on_b: DVec3,
    pub(crate) distance: f64,
    pub(crate) normal: DVec3,
}

impl NearestPoints {
    fn between((on_a, on_b): (DVec3, DVec3)) -> Self {
        Self { on_a, on_b, distance: on_a.distance(on_b), normal: unit(on_a - on_b) }
    }
}

/// The nearest of five pairs: each of the four ends with the other segment, and the nearest points of the two lines.
/// Segments that intersect have the common perpendicular as their normal, with an arbitrary sign.
///
/// The nearest points of two lines are uncertain by epsilon over the sine of the angle, but only along the lines, where
/// the distance is stationary. Each is projected once more onto the other segment; the error of the distance is then
/// epsilon times the lengths at any angle.
pub(crate) fn nearest_points(a: [DVec3; 2], b: [DVec3; 2]) -> NearestPoints {
    let (along_a, along_b) = (a[1] - a[0], b[1] - b[0]);
    let cross = along_a.cross(along_b);
    let square = cross.length_squared();
    let on = |s: [DVec3; 2], p: DVec3| on_segment(s[0], s[1], p).0;
    let (middle_a, middle_b) = (0.5 * (a[0] + a[1]), 0.5 * (b[0] + b[1]));
    let between = middle_b - middle_a;
    let lengths = along_a.length() + along_b.length() + between.length();
    let support = |n: DVec3| n.dot(farthest(&b, n) - farthest(&a, -n));
    let nearer = |found: &NearestPoints, other: &NearestPoints| {
        is_nearer((found.distance, found.normal), (other.distance, other.normal), lengths, support)
    };
    let ends = [(a[0], on(b, a[0])), (a[1], on(b, a[1])), (on(a, b[0]), b[0]), (on(a, b[1]), b[1])];
    let mut best = NearestPoints::between(ends[0]);
    for pair in &ends[1..] {
        let found = NearestPoints::between(*pair);
        if nearer(&found, &best) {
            best = found;
        }
    }
    if square > 0.0 {
        // Relative to the midpoints, where rounding is least.
        let place = between.cross(along_b).dot(cross) / square;
        let first = middle_a + along_a * place.clamp(-0.5, 0.5);
        let on_b = on(b, first);
        let on_a = on(a, on_b);
        let mut crossing = NearestPoints::between((on_a, on_b));
        let inner = on_a != a[0] && on_a != a[1] && on_b != b[0] && on_b != b[1];
        if inner && square > PARALLEL_SINE * PARALLEL_SINE * along_a.length_squared() * along_b.length_squared() {
            crossing.normal = unit(if between.dot(cross) > 0.0 { -cross } else { cross });
        }
        if !nearer(&best, &crossing) {
            best = crossing;
        }
    }
    if best.normal == DVec3::ZERO {
        best.normal = unit((if along_a == DVec3::ZERO { along_b } else { along_a }).any_orthogonal_vector());
    }
    best
}

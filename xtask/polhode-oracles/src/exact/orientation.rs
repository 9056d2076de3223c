//! On which side of a plane a point lies, without rounding.

use super::dyadic::ExactVector;
use glam::DVec3;

/// Rounding of the determinant in units of epsilon times the sum of the sizes of its products: three differences, two
/// products and five sums, doubled.
const ROUNDING_ULPS: f64 = 16.0;

/// Sign of `((b - a) x (c - a)) . (d - a)`: 1 when `d` is on the side from which `a`, `b`, `c` run anticlockwise, 0
/// when the four lie in one plane. In f64 where that is certain, exactly elsewhere.
pub(super) fn orientation([a, b, c]: [DVec3; 3], d: DVec3) -> i32 {
    let (u, v, w) = (b - a, c - a, d - a);
    let value = u.cross(v).dot(w);
    let (p, q) = (u.abs(), v.abs());
    let products = DVec3::new(p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x).dot(w.abs());
    let bound = ROUNDING_ULPS * f64::EPSILON * products;
    if value.abs() > bound {
        return if value > 0.0 { 1 } else { -1 };
    }
    // With every product zero nothing was rounded; and two points that are one lie in a plane with any others.
    if products == 0.0 || b == c || b == d || c == d {
        return 0;
    }
    let [a, b, c, d] = [a, b, c, d].map(ExactVector::from);
    (&b - &a).cross(&(&c - &a)).dot(&(&d - &a)).signum()
}

#[cfg(test)]
mod tests {
    //! Signs that f64 loses.
    use super::*;

    #[test]
    fn a_point_off_a_plane_by_one_rounding_is_seen() {
        // The plane is x = y.
        let corners = [DVec3::new(0.1, 0.1, 0.0), DVec3::new(0.3, 0.3, 0.0), DVec3::new(0.7, 0.7, 1.0)];
        let sign = |x: f64| orientation(corners, DVec3::new(x, 0.9, 0.0));
        assert_eq!([sign(0.9_f64.next_down()), sign(0.9), sign(0.9_f64.next_up())], [-1, 0, 1]);
        assert_eq!(orientation([DVec3::ZERO, DVec3::X, DVec3::Y], DVec3::new(0.3, 1e300, 0.0)), 0);
        assert_eq!(orientation([DVec3::ZERO, DVec3::X, DVec3::Y], DVec3::new(0.3, 0.7, 1e-300)), 1);
    }
}

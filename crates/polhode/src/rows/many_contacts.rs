//! Which contacts of a pair stand for many.
//!
//! The rim of a dense mesh that lies on a plane has hundreds of contacts, and a problem of `n` contacts costs `n^2` to
//! `n^3` operations, although two bodies move relative to each other in six ways. Of a pair of few contacts all take
//! part in a time step, or in an impact with friction, from the beginning. Of a pair of many those begin that lie
//! furthest out in 26 directions; then the contact that closes most is added until none does. What is left out carries
//! no impulse and does not close: the impulses solve the whole problem of a step or of an impact without restitution.
//! With restitution contacts that are left out separate, or stay together, at a speed that is not asked for. The
//! directions are fixed, so that two halves of a step begin with the contacts of the whole.
//!
//! Assumption: where impulses are not unique, any of them will do. A load that all contacts could share is then shared
//! by those furthest out. The motion depends on that only where a body turns while it slides flat.

use polhode_spatial::DVec3;

/// Of some contact points (m) those furthest out in the directions from the middle of a cube to its faces, edges and
/// corners.
pub(crate) fn furthest_out(points: &[(usize, DVec3)]) -> Vec<usize> {
    let signs = || [-1.0, 0.0, 1.0].into_iter();
    let directions = signs().flat_map(|x| signs().flat_map(move |y| signs().map(move |z| DVec3::new(x, y, z))));
    let mut found: Vec<usize> = directions
        .filter(|direction| *direction != DVec3::ZERO)
        .filter_map(|direction| {
            let reach = points.iter().map(|&(index, point)| (index, direction.dot(point)));
            reach.reduce(|best, next| if next.1 > best.1 { next } else { best }).map(|(index, _)| index)
        })
        .collect();
    found.sort_unstable();
    found.dedup();
    found
}

#[cfg(test)]
mod tests {
    //! The points furthest out stand for a rim, and for a face whose inner points bear nothing.
    use super::*;

    /// Of a rim of 720 points 8 are left, one in each direction of its plane; of a square grid the corners and the
    /// first of each side.
    #[test]
    fn a_rim_is_left_with_a_point_in_each_direction_of_its_plane() {
        let rim = (0..720).map(|k| {
            let (y, x) = (f64::from(k) * std::f64::consts::PI / 360.0).sin_cos();
            DVec3::new(x, y, 0.0)
        });
        let found = furthest_out(&rim.enumerate().collect::<Vec<_>>());
        assert_eq!(found, [0, 90, 180, 270, 360, 450, 540, 630]);
        let grid = (0..11).flat_map(|x| (0..11).map(move |y| DVec3::new(f64::from(x), f64::from(y), 0.0)));
        let found = furthest_out(&grid.enumerate().collect::<Vec<_>>());
        assert_eq!(found, [0, 10, 110, 120]);
    }
}

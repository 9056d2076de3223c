//! What points reach: the outermost one in each of many directions.
//!
//! A camera that holds these points holds all that were added, but for less than 3 % of their size: a circle reaches
//! `r (1 - cos(a / 2))` farther than its outermost points in directions `a` apart. Those along the axes are among the
//! directions, so that the box around all is exact.

use polhode::spatial::{DVec3, Pose};

/// Directions have whole coordinates of at most this size: 98 of them, at most 27 degrees apart.
const GRID: i32 = 2;

/// The outermost points in many directions, m.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Extent {
    /// By direction: how far the outermost point is along it, and the point.
    outermost: Vec<(f64, DVec3)>,
    directions: Vec<DVec3>,
}

/// One direction of each line through the whole points of a cube, both ways.
fn directions() -> Vec<DVec3> {
    let range = || -GRID..=GRID;
    let all = range().flat_map(|x| range().flat_map(move |y| range().map(move |z| [x, y, z])));
    // Without those that are twice another one.
    let is_own = |[x, y, z]: &[i32; 3]| x % 2 != 0 || y % 2 != 0 || z % 2 != 0;
    all.filter(is_own).map(|whole| DVec3::from_array(whole.map(f64::from))).collect()
}

impl Extent {
    /// Of nothing.
    pub fn new() -> Self {
        Self::default()
    }

    /// Of points.
    pub fn of(points: impl IntoIterator<Item = DVec3>) -> Self {
        let mut extent = Self::new();
        points.into_iter().for_each(|point| extent.add(point));
        extent
    }

    /// Adds a point.
    pub fn add(&mut self, point: DVec3) {
        if self.directions.is_empty() {
            self.directions = directions();
            self.outermost = vec![(f64::NEG_INFINITY, DVec3::ZERO); self.directions.len()];
        }
        for (direction, outermost) in self.directions.iter().zip(&mut self.outermost) {
            let reach = direction.dot(point);
            if reach > outermost.0 {
                *outermost = (reach, point);
            }
        }
    }

    /// Adds the corners of a box (its smallest and largest coordinates) at a pose.
    pub fn add_box(&mut self, corners: [DVec3; 2], pose: &Pose) {
        box_corners(corners).for_each(|corner| self.add(pose.transform_point(corner)));
    }

    /// Adds what another one holds.
    pub fn add_all(&mut self, other: &Self) {
        other.points().for_each(|point| self.add(point));
    }

    /// The outermost points, some of them more than once.
    pub fn points(&self) -> impl Iterator<Item = DVec3> + '_ {
        self.outermost.iter().map(|(_, point)| *point)
    }

    /// Smallest and largest coordinates; none of nothing.
    pub fn bounds(&self) -> Option<[DVec3; 2]> {
        let mut points = self.points();
        let first = points.next()?;
        Some(points.fold([first; 2], |[low, high], p| [low.min(p), high.max(p)]))
    }

    /// Length of the diagonal of the box around all, m.
    pub fn size_m(&self) -> f64 {
        self.bounds().map_or(0.0, |[low, high]| (high - low).length())
    }
}

/// The eight corners of a box.
pub fn box_corners(corners: [DVec3; 2]) -> impl Iterator<Item = DVec3> {
    (0..8).map(move |corner| {
        let pick = |axis: usize| corners[corner >> axis & 1][axis];
        DVec3::new(pick(0), pick(1), pick(2))
    })
}

#[cfg(test)]
mod tests {
    //! The box around all points is exact, and a ball of points reaches hardly beyond the outermost ones.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn directions_differ() {
        let all = directions();
        assert_eq!(all.len(), 98);
        let is_same = |a: &DVec3, b: &DVec3| a.normalize().distance(b.normalize()) < 1e-9;
        assert!(all.iter().enumerate().all(|(i, a)| all[..i].iter().all(|b| !is_same(a, b))));
    }

    #[test]
    fn a_circle_reaches_hardly_beyond_its_outermost_points() {
        let circle = (0..1000).map(|i| f64::from(i) * 0.006_283_185_307);
        let circle: Vec<DVec3> = circle.map(|a| DVec3::new(libm::cos(a), 0.3, libm::sin(a))).collect();
        let extent = Extent::of(circle.iter().copied());
        assert!((extent.bounds().unwrap()[1].x - 1.0).abs() < 1e-12);
        for along in &circle {
            let along = DVec3::new(along.x, 0.0, along.z);
            let reach = extent.points().map(|p| p.dot(along)).fold(0.0, f64::max);
            assert!(reach > 0.97, "{reach}");
        }
    }
}

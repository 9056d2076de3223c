//! A convex block: corners and faces in the world, centre of mass and weight.

use glam::DVec3;

/// A convex block in the world.
#[derive(Debug, Clone)]
pub struct Block {
    /// Its corners, m.
    pub(super) corners: Vec<DVec3>,
    /// Corners of each face by number, anticlockwise seen from outside.
    pub(super) faces: Vec<Vec<usize>>,
    /// Centre of mass, m.
    pub(super) center: DVec3,
    /// Mass, kg; none for a block that is fixed.
    pub(super) mass_kg: Option<f64>,
}

/// Corners of the faces of a box whose corner number is `4 x + 2 y + z`, each 0 on the lower side and 1 on the upper.
const BOX_FACES: [[usize; 4]; 6] = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];

impl Block {
    /// A block of these corners and faces.
    pub fn new(corners: Vec<DVec3>, faces: Vec<Vec<usize>>, center: DVec3, mass_kg: Option<f64>) -> Self {
        Self { corners, faces, center, mass_kg }
    }

    /// A box with these edges, along three orthogonal unit vectors.
    pub fn cuboid(center: DVec3, edges: DVec3, axes: [DVec3; 3], mass_kg: Option<f64>) -> Self {
        let half = 0.5 * edges;
        let side = |number: usize, bit: usize| if number & bit == 0 { -1.0 } else { 1.0 };
        let corner = |number: usize| {
            center
                + axes[0] * (side(number, 4) * half.x)
                + axes[1] * (side(number, 2) * half.y)
                + axes[2] * (side(number, 1) * half.z)
        };
        let faces = BOX_FACES.iter().map(|face| face.to_vec()).collect();
        Self::new((0..8).map(corner).collect(), faces, center, mass_kg)
    }

    /// The places of the corners of a face, m.
    pub(super) fn loop_of(&self, face: &[usize]) -> Vec<DVec3> {
        face.iter().filter_map(|&corner| self.corners.get(corner).copied()).collect()
    }

    /// The largest distance of a corner from the centre of mass, m.
    pub(super) fn radius(&self) -> f64 {
        self.corners.iter().map(|corner| (*corner - self.center).length()).fold(0.0, f64::max)
    }
}

/// Outward unit normal of a polygon (Newell's sum over its sides).
pub(super) fn normal_of(polygon: &[DVec3]) -> DVec3 {
    let sides = polygon.iter().zip(polygon.iter().cycle().skip(1));
    sides.map(|(from, to)| from.cross(*to)).sum::<DVec3>().normalize_or_zero()
}

#[cfg(test)]
mod tests {
    //! The faces of a box point outwards.
    use super::*;

    #[test]
    fn faces_of_a_box_point_outwards() {
        let center = DVec3::new(3.0, -1.0, 2.0);
        let block = Block::cuboid(center, DVec3::new(1.0, 2.0, 3.0), [DVec3::X, DVec3::Y, DVec3::Z], Some(1.0));
        for face in &block.faces {
            let polygon = block.loop_of(face);
            let middle = polygon.iter().sum::<DVec3>() / 4.0;
            assert!(normal_of(&polygon).dot(middle - center) > 0.4, "{face:?}");
        }
    }
}

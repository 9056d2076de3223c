//! A structure of prisms on level ground, as a scene and as blocks of the programme.

use glam::DVec3;
use polhode::contact::{ConvexPolyhedron, Shape};
use polhode::scene::Material;
use polhode::spatial::{DMat3, Inertia, Mass, MassProperties, Pose, UnitVector};
use polhode::{Body, Scene};
use polhode_oracles::statics::{Block, Friction};
use std::error::Error;

/// Edges of the block that stands for the ground in the programme, m: larger than any structure.
const GROUND: DVec3 = DVec3::new(40.0, 40.0, 2.0);

/// Corners of the faces of a prism of four sides: 0 to 3 in front (towards -y), 4 to 7 behind them.
const FACES: [[usize; 4]; 6] = [[0, 1, 2, 3], [7, 6, 5, 4], [1, 0, 4, 5], [2, 1, 5, 6], [3, 2, 6, 7], [0, 3, 7, 4]];

/// A structure of prisms along y.
#[derive(Debug, Clone)]
pub(super) struct Built {
    friction: f64,
    material: Material,
    bodies: Vec<Body>,
    blocks: Vec<Block>,
}

impl Built {
    /// Nothing yet, on the ground z = 0, with this friction between all bodies.
    pub(super) fn on_the_ground(friction: f64) -> Result<Self, Box<dyn Error>> {
        let material = Material::new("stone").with_friction(friction)?;
        let ground = Body::fixed("ground").geometry(Shape::half_space(UnitVector::Z).into());
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        let block = Block::cuboid(DVec3::Z * (-0.5 * GROUND.z), GROUND, axes, None);
        Ok(Self { friction, bodies: vec![ground.material(material.clone())], blocks: vec![block], material })
    }

    /// Adds a prism with these corners in the plane y = 0, in order, m, and this depth along y (m) and density
    /// (kg/m^3).
    pub(super) fn prism(
        &mut self,
        name: &str,
        mut profile: [DVec3; 4],
        depth: f64,
        density: f64,
    ) -> Result<(), Box<dyn Error>> {
        if section(&profile).0 < 0.0 {
            profile.reverse();
        }
        let (area, center, moments) = section(&profile);
        let mass = density * depth * area;
        let [xx, zz, xz] = moments.map(|moment| density * depth * moment);
        let across = mass * depth * depth / 12.0;
        let inertia = DMat3::from_cols(
            DVec3::new(zz + across, 0.0, -xz),
            DVec3::new(0.0, xx + zz, 0.0),
            DVec3::new(-xz, 0.0, xx + across),
        );
        let at = |y: f64| profile.map(|corner| corner + DVec3::Y * y);
        let corners: Vec<DVec3> = at(-0.5 * depth).into_iter().chain(at(0.5 * depth)).collect();
        let faces: Vec<Vec<usize>> = FACES.iter().map(|face| face.to_vec()).collect();
        let own = corners.iter().map(|corner| *corner - center).collect();
        let shape = ConvexPolyhedron::from_faces(
            own,
            faces.iter().map(|face| face.iter().map(|&c| c as u32).collect()).collect(),
        )?;
        let properties = MassProperties::new(Mass::new(mass)?, DVec3::ZERO, Inertia::new(inertia)?);
        let body = Body::movable(name, properties).geometry(Shape::convex(shape).into());
        self.bodies.push(body.pose(Pose::from_translation(center)).material(self.material.clone()));
        self.blocks.push(Block::new(corners, faces, center, Some(mass)));
        Ok(())
    }

    /// Its scene.
    pub(super) fn scene(&self) -> Result<Scene, Box<dyn Error>> {
        let bodies = self.bodies.iter().cloned();
        Ok(bodies.fold(Scene::builder("structure"), polhode::SceneBuilder::body).build()?)
    }

    /// Its blocks for the programme.
    pub(super) fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// Friction of the programme, `part` of that of the scene.
    pub(super) fn friction(&self, part: f64) -> Friction {
        Friction::Coefficient(part * self.friction)
    }
}

/// Area (m^2, negative where the corners go clockwise seen from -y), centroid (m), and the integrals of `x^2`, `z^2`
/// and `x z` about the centroid (m^4) of a polygon in the plane y = 0, summed over triangles from its first corner.
fn section(profile: &[DVec3; 4]) -> (f64, DVec3, [f64; 3]) {
    let origin = profile[0];
    let (mut area, mut first, mut second) = (0.0, DVec3::ZERO, [0.0; 3]);
    for sides in profile[1..].windows(2) {
        let (p, q) = (sides[0] - origin, sides[1] - origin);
        let part = 0.5 * (p.x * q.z - p.z * q.x);
        area += part;
        first += (p + q) * (part / 3.0);
        let integral = |i: f64, j: f64, k: f64, l: f64| part / 12.0 * (2.0 * (i * k + j * l) + i * l + j * k);
        second[0] += integral(p.x, q.x, p.x, q.x);
        second[1] += integral(p.z, q.z, p.z, q.z);
        second[2] += integral(p.x, q.x, p.z, q.z);
    }
    let from_origin = first / area;
    let moved = [from_origin.x * from_origin.x, from_origin.z * from_origin.z, from_origin.x * from_origin.z];
    let central = [0, 1, 2].map(|k| second[k] - area * moved[k]);
    (area, origin + from_origin, central)
}

#[cfg(test)]
mod tests {
    //! A rectangle's section, whichever way round its corners are given.
    use super::*;

    #[test]
    fn section_of_a_rectangle() {
        let corners = [(1.0, 1.0), (4.0, 1.0), (4.0, 3.0), (1.0, 3.0)].map(|(x, z)| DVec3::new(x, 0.0, z));
        let (area, center, [xx, zz, xz]) = section(&corners);
        assert_eq!((area, center), (6.0, DVec3::new(2.5, 0.0, 2.0)));
        assert!((xx - 2.0 * 27.0 / 12.0).abs() < 1e-14 && (zz - 3.0 * 8.0 / 12.0).abs() < 1e-14 && xz.abs() < 1e-14);
        let mut turned = corners;
        turned.reverse();
        assert_eq!(section(&turned).0, -6.0);
    }
}

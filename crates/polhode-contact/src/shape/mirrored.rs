//! The mirror image of a shape in the plane x = 0 of its frame.
//!
//! Loops of faces and triangles run the other way round then, so that they are anticlockwise seen from outside again.
//! Vertices, faces and edges keep their numbers.

use super::error::ShapeError;
use super::{Capsule, Compound, Cone, Cylinder, HalfSpace, Shape, Sphere, Torus, TriangleMesh, topology};
use crate::ConvexPolyhedron;
use glam::DVec3;
use polhode_spatial::Handedness;

fn image(x: DVec3) -> DVec3 {
    Handedness::Mirrored.vector(x)
}

impl Shape {
    /// The image of the shape in a mirror in the plane x = 0 of its frame.
    ///
    /// ```
    /// use polhode_contact::{Shape, DVec3};
    /// let points = Shape::points(vec![DVec3::new(1.0, 2.0, 3.0)])?;
    /// assert_eq!(points.mirrored()?, Shape::points(vec![DVec3::new(-1.0, 2.0, 3.0)])?);
    /// # Ok::<(), polhode_contact::ShapeError>(())
    /// ```
    ///
    /// # Errors
    /// When the image of a triangle mesh or of a compound is none, which that of a shape that was made is not.
    pub fn mirrored(&self) -> Result<Self, ShapeError> {
        match self {
            Self::Convex(polyhedron) => Ok(Self::Convex(polyhedron.mirrored())),
            Self::Sphere(s) => Ok(Self::Sphere(Sphere { center: image(s.center), ..*s })),
            Self::HalfSpace(h) => Ok(Self::HalfSpace(HalfSpace { normal: image(h.normal), ..*h })),
            Self::Points(cloud) => Self::points(cloud.points.iter().map(|&p| image(p)).collect()),
            Self::Capsule(c) => Ok(Self::Capsule(Capsule { ends: c.ends.map(image), ..*c })),
            Self::Cylinder(c) => Ok(Self::Cylinder(Cylinder { center: image(c.center), axis: image(c.axis), ..*c })),
            Self::Cone(c) => Ok(Self::Cone(Cone { base: image(c.base), axis: image(c.axis), ..*c })),
            Self::Torus(t) => Ok(Self::Torus(Torus { center: image(t.center), axis: image(t.axis), ..*t })),
            Self::TriangleMesh(mesh) => {
                let vertices = mesh.vertices().iter().map(|&vertex| image(vertex)).collect();
                TriangleMesh::new(vertices, mesh.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect())
                    .map(Self::TriangleMesh)
            }
            Self::Compound(compound) => {
                let parts = compound.parts().iter().map(Self::mirrored).collect::<Result<_, _>>()?;
                Compound::new(parts).map(Self::Compound)
            }
        }
    }
}

impl ConvexPolyhedron {
    /// The image of the polyhedron in a mirror in the plane x = 0 of its frame.
    pub fn mirrored(&self) -> Self {
        let mut mirrored = self.clone();
        mirrored.vertices.iter_mut().for_each(|vertex| *vertex = image(*vertex));
        for face in &mut mirrored.faces {
            face.normal = image(face.normal);
            let corners = face.first..face.first + face.count;
            mirrored.corner_vertices[corners.clone()].reverse();
            // An edge stands at the corner at which it begins: the last but one is the first now.
            let (edges, sides) = (&mut mirrored.corner_edges, &mut mirrored.corner_sides);
            edges[corners.clone()].reverse();
            edges[corners.clone()].rotate_left(1);
            sides[corners.clone()].reverse();
            sides[corners].rotate_left(1);
        }
        mirrored.corner_sides.iter_mut().for_each(|side| *side = image(*side));
        for edge in &mut mirrored.edges {
            edge.vertices.reverse();
            edge.direction = -image(edge.direction);
        }
        topology::complete_edges(&mut mirrored);
        mirrored
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

    use super::*;

    /// A polyhedron without a plane of symmetry.
    fn wedge() -> ConvexPolyhedron {
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.1], [0.0, 2.0, 0.0], [0.2, 0.3, 1.5], [0.9, 1.1, 0.4]];
        ConvexPolyhedron::from_points(&points.map(DVec3::from_array)).unwrap()
    }

    /// The image is the polyhedron that the images of the faces make, to rounding, and its own image is the first one.
    #[test]
    fn image_is_that_of_the_faces() {
        let (own, image) = (wedge(), wedge().mirrored());
        assert_eq!(image.mirrored(), own);
        let loops = image.faces().map(|face| face.vertices.to_vec()).collect();
        let made = ConvexPolyhedron::from_faces(image.vertices().to_vec(), loops).unwrap();
        for (a, b) in image.faces().zip(made.faces()) {
            assert!((a.normal - b.normal).length() < 1e-15 && (a.offset - b.offset).abs() < 1e-15);
            for ((a_edge, a_side), (b_edge, b_side)) in a.edges.iter().zip(a.sides).zip(b.edges.iter().zip(b.sides)) {
                let ends = |edges: &[crate::Edge], edge: u32| {
                    let mut ends = edges[edge as usize].vertices;
                    ends.sort_unstable();
                    ends
                };
                assert_eq!(ends(image.edges(), *a_edge), ends(made.edges(), *b_edge));
                assert!((*a_side - *b_side).length() < 1e-15);
            }
        }
        for edge in image.edges() {
            let [from, to] = edge.vertices.map(|v| image.vertices()[v as usize]);
            assert!(((to - from) / edge.length - edge.direction).length() < 1e-15);
            let first = image.face(edge.faces[0] as usize).unwrap();
            let place = first.vertices.iter().position(|&v| v == edge.vertices[0]).unwrap();
            assert_eq!(first.vertices[(place + 1) % first.vertices.len()], edge.vertices[1]);
        }
    }
}

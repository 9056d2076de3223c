//! A mesh that is being read: vertices, and faces that become triangles when all vertices are known.

use crate::polygon::{MOST_CLIPPED_CORNERS, Triangulation, is_plain_fan, triangulate};
use crate::read_error::{Place, ReadError, ReadErrorKind};
use crate::triangle_mesh::TriangleMesh;
use glam::DVec3;

/// What has been read so far.
#[derive(Debug, Default)]
pub(crate) struct MeshBuilder {
    vertices: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    polygons: Vec<Polygon>,
    /// First and latest corner of the face that is being read, and their number.
    first: u32,
    latest: u32,
    corners: usize,
}

/// A face of more than three corners; its fan stands among the triangles.
#[derive(Debug, Clone, Copy)]
struct Polygon {
    first_triangle: usize,
    corners: usize,
    place: Place,
}

impl MeshBuilder {
    /// With room for what the header claims and the rest of the file can hold.
    pub(crate) fn with_room_for(vertices: usize, triangles: usize) -> Self {
        Self { vertices: Vec::with_capacity(vertices), triangles: Vec::with_capacity(triangles), ..Self::default() }
    }

    /// Number of vertices.
    pub(crate) fn vertices(&self) -> usize {
        self.vertices.len()
    }

    #[inline]
    pub(crate) fn vertex(&mut self, position: [f64; 3], place: Place) -> Result<(), ReadError> {
        if self.vertices.len() >= u32::MAX as usize {
            return Err(ReadError { place, kind: ReadErrorKind::TooManyVertices });
        }
        self.vertices.push(DVec3::from_array(position));
        Ok(())
    }

    /// The next corner of the face that is being read.
    #[inline]
    pub(crate) fn corner(&mut self, index: u32) {
        match self.corners {
            0 => self.first = index,
            1 => {}
            _ => self.triangles.push([self.first, self.latest, index]),
        }
        self.latest = index;
        self.corners += 1;
    }

    /// The face that is being read has no more corners.
    #[inline]
    pub(crate) fn end_face(&mut self, place: Place) -> Result<(), ReadError> {
        let corners = std::mem::take(&mut self.corners);
        if corners < 3 {
            return Err(ReadError { place, kind: ReadErrorKind::TooFewVertices(corners) });
        }
        if corners > 3 {
            self.polygons.push(Polygon { first_triangle: self.triangles.len() - (corners - 2), corners, place });
        }
        Ok(())
    }

    /// The mesh; `end` is the end of the file.
    pub(crate) fn finish(mut self, end: Place) -> Result<TriangleMesh, ReadError> {
        if self.triangles.is_empty() {
            return Err(ReadError { place: end, kind: ReadErrorKind::Empty { vertices: self.vertices.len() } });
        }
        for polygon in std::mem::take(&mut self.polygons) {
            self.cut(polygon)?;
        }
        TriangleMesh::new(self.vertices, self.triangles).map_err(|error| ReadError { place: end, kind: error.into() })
    }

    /// Replaces the fan of a polygon where it is wrong.
    fn cut(&mut self, polygon: Polygon) -> Result<(), ReadError> {
        let range = polygon.first_triangle..polygon.first_triangle + polygon.corners - 2;
        let Some(fan) = self.triangles.get_mut(range) else { return Ok(()) };
        // An index out of range is refused when the mesh is made.
        let position = |index: u32| self.vertices.get(index as usize).copied();
        if is_plain_fan(fan.iter().map(|triangle| triangle.map(|index| position(index).unwrap_or(DVec3::NAN)))) {
            return Ok(());
        }
        let mut corners: Vec<u32> = Vec::with_capacity(polygon.corners);
        corners.extend(fan.first().into_iter().flat_map(|&[a, b, _]| [a, b]));
        corners.extend(fan.iter().map(|&[_, _, c]| c));
        let positions: Option<Vec<DVec3>> = corners.iter().map(|&index| position(index)).collect();
        let Some(positions) = positions else { return Ok(()) };
        match triangulate(&positions) {
            Triangulation::Fan => Ok(()),
            Triangulation::Ears(ears) => {
                for (triangle, ear) in fan.iter_mut().zip(ears) {
                    *triangle = ear.map(|corner| corners[corner]);
                }
                Ok(())
            }
            Triangulation::TooLarge => {
                let kind = ReadErrorKind::LargeFace { corners: polygon.corners, limit: MOST_CLIPPED_CORNERS };
                Err(ReadError { place: polygon.place, kind })
            }
        }
    }
}

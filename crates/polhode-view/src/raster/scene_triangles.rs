//! What is drawn, in the world.

use super::paint::Paints;
use crate::colors;
use crate::mesh_library::MeshLibrary;
use crate::recording::Recording;
use crate::surface_mesh::SurfaceMesh;
use crate::tessellation::Part;
use crate::tessellation::tube::tube;
use polhode::spatial::{DVec3, Pose};

/// A triangle in the world.
#[derive(Debug, Clone, Copy)]
pub struct Triangle {
    /// Corners, m.
    pub corners: [DVec3; 3],
    /// Unit normals at the corners.
    pub normals: [DVec3; 3],
    /// Number of its paint.
    pub paint: u16,
}

/// A line in the world.
#[derive(Debug, Clone, Copy)]
pub struct Segment {
    /// Ends, m.
    pub ends: [DVec3; 2],
    /// Number of its paint.
    pub paint: u16,
}

/// A plane in the world.
#[derive(Debug, Clone, Copy)]
pub struct Plane {
    /// Unit normal.
    pub normal: DVec3,
    /// `normal . x` of its points, m.
    pub offset_m: f64,
}

/// All that is drawn of one frame.
#[derive(Debug, Clone, Default)]
pub struct SceneTriangles {
    pub(crate) triangles: Vec<Triangle>,
    pub(crate) segments: Vec<Segment>,
    pub(crate) planes: Vec<Plane>,
    pub(crate) paints: Paints,
}

impl SceneTriangles {
    /// Those of a frame of a recording.
    pub fn of_frame(recording: &Recording, frame: usize) -> Self {
        let mut all = Self::default();
        let (shown, poses) = (recording.shown(), recording.poses(frame));
        for (number, (body, pose)) in shown.bodies.iter().zip(&poses).enumerate() {
            if body.look.opacity <= 0.0 {
                continue;
            }
            let opacity = body.look.opacity;
            let surface = all.paints.number_of(shown.color(number), opacity);
            let line = all.paints.number_of(colors::EDGE, opacity);
            for part in &body.shape.parts {
                all.add_part(recording.meshes(), part, pose, [surface, line]);
            }
            for half_space in &body.shape.half_spaces {
                let normal = pose.rotation.rotate(half_space.normal());
                let offset_m = half_space.offset() + normal.dot(pose.translation);
                all.planes.push(Plane { normal, offset_m });
            }
        }
        all.add_fixtures(recording, &poses);
        all
    }

    /// Joints, tracks and springs.
    fn add_fixtures(&mut self, recording: &Recording, poses: &[Pose]) {
        let shown = recording.shown();
        let paint = self.paints.number_of(colors::FIXTURE, 1.0);
        let pose_of = |body: Option<usize>| body.and_then(|body| poses.get(body)).copied().unwrap_or(Pose::IDENTITY);
        let is_seen = |body: Option<usize>| {
            body.and_then(|body| shown.bodies.get(body)).is_none_or(|body| body.look.opacity > 0.0)
        };
        for fixture in shown.fixtures.parts.iter().filter(|fixture| is_seen(fixture.body)) {
            self.add_part(recording.meshes(), &fixture.part, &pose_of(fixture.body), [paint; 2]);
        }
        for link in &shown.fixtures.links {
            let ends = link.ends.map(|end| pose_of(end.body).transform_point(end.point));
            let points = link.points(ends, shown.up());
            self.add_mesh(&tube(&points, link.radius_m), &Part::of(0), &Pose::IDENTITY, [paint; 2]);
        }
    }

    fn add_part(&mut self, meshes: &MeshLibrary, part: &Part, pose: &Pose, paints: [u16; 2]) {
        if let Some(mesh) = meshes.meshes().get(part.mesh) {
            self.add_mesh(mesh, part, pose, paints);
        }
    }

    /// A mesh in its place, with the paints of its surface and of its lines.
    fn add_mesh(&mut self, mesh: &SurfaceMesh, part: &Part, pose: &Pose, [paint, line]: [u16; 2]) {
        let place = |&p: &DVec3| pose.transform_point(part.point(p));
        let positions: Vec<DVec3> = mesh.positions.iter().map(place).collect();
        let normals: Vec<DVec3> = mesh.normals.iter().map(|&n| pose.rotation.rotate(part.normal(n))).collect();
        let at = |list: &[DVec3], corners: [u32; 3]| corners.map(|corner| list[corner as usize]);
        let triangle =
            |&corners: &[u32; 3]| Triangle { corners: at(&positions, corners), normals: at(&normals, corners), paint };
        self.triangles.extend(mesh.triangles.iter().map(triangle));
        let segment = |ends: &[u32; 2]| Segment { ends: ends.map(|end| positions[end as usize]), paint: line };
        self.segments.extend(mesh.lines.iter().map(segment));
    }
}

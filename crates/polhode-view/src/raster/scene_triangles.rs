//! What is drawn, in the world.

use crate::colors::{self, Color};
use crate::recording::Recording;
use polhode::spatial::{DVec3, Pose};

/// A triangle in the world.
#[derive(Debug, Clone, Copy)]
pub struct Triangle {
    /// Corners, m.
    pub corners: [DVec3; 3],
    /// Unit normals at the corners.
    pub normals: [DVec3; 3],
    /// Number of its colour.
    pub color: u16,
}

/// A line in the world.
#[derive(Debug, Clone, Copy)]
pub struct Segment {
    /// Ends, m.
    pub ends: [DVec3; 2],
    /// Number of its colour.
    pub color: u16,
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
    pub(crate) colors: Vec<Color>,
    /// Around all triangles, m.
    pub(crate) bounds: Option<[DVec3; 2]>,
}

impl SceneTriangles {
    /// Those of a frame of a recording.
    pub fn of_frame(recording: &Recording, frame: usize) -> Self {
        let mut all = Self::default();
        let shown = recording.shown();
        for (number, pose) in recording.poses(frame).iter().enumerate() {
            all.colors.push(colors::body(shown.moving.iter().position(|&moving| moving == number)));
            all.add_body(recording, number, pose);
        }
        all
    }

    fn add_body(&mut self, recording: &Recording, number: usize, pose: &Pose) {
        let body = &recording.shown().bodies[number];
        let color = (number % usize::from(u16::MAX)) as u16;
        for part in &body.shape.parts {
            let mesh = &recording.meshes().meshes()[part.mesh];
            let place = |&p: &DVec3| pose.transform_point(part.point(p));
            let positions: Vec<DVec3> = mesh.positions.iter().map(place).collect();
            let normals: Vec<DVec3> = mesh.normals.iter().map(|&n| pose.rotation.rotate(part.normal(n))).collect();
            for &p in &positions {
                let [low, high] = self.bounds.unwrap_or([p; 2]);
                self.bounds = Some([low.min(p), high.max(p)]);
            }
            let at = |list: &[DVec3], corners: [u32; 3]| corners.map(|corner| list[corner as usize]);
            self.triangles.extend(mesh.triangles.iter().map(|&corners| Triangle {
                corners: at(&positions, corners),
                normals: at(&normals, corners),
                color,
            }));
            self.segments
                .extend(mesh.lines.iter().map(|ends| Segment { ends: ends.map(|end| positions[end as usize]), color }));
        }
        for half_space in &body.shape.half_spaces {
            let normal = pose.rotation.rotate(half_space.normal());
            let offset_m = half_space.offset() + normal.dot(pose.translation);
            self.planes.push(Plane { normal, offset_m });
        }
    }
}

//! Shapes as the judge knows them: unions of convex cores, each thickened by a margin, and rings, which are circles
//! thickened by a margin.
//!
//! A sphere is a point, a capsule a segment, a torus a circle, each with the radius as margin; boxes and polyhedra are
//! hulls, cylinders and cones are themselves, all without margin.

use crate::random_scene::model::{Form, Triangles};
use glam::{DMat3, DQuat, DVec3};

/// A core in its own frame, m.
#[derive(Debug, Clone)]
pub(super) enum Core {
    /// The origin.
    Point,
    /// From -z to z, of this half length.
    Segment(f64),
    /// About z in the plane z = 0, of this radius.
    Circle(f64),
    /// About z, of this radius and half height.
    Cylinder(f64, f64),
    /// About z, of this radius, from the base at the first height to the apex at the second.
    Cone(f64, f64, f64),
    /// Below the plane through the origin with this outward unit normal.
    HalfSpace(DVec3),
    /// A convex polyhedron.
    Hull(Hull),
}

/// A convex polyhedron.
#[derive(Debug, Clone)]
pub(super) struct Hull {
    pub(super) vertices: Vec<DVec3>,
    pub(super) triangles: Vec<[usize; 3]>,
    /// Outward unit normals of the triangles.
    pub(super) normals: Vec<DVec3>,
}

/// A core with its margin, in the frame of its body.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    pub(super) core: Core,
    pub(super) margin: f64,
    pub(super) position: DVec3,
    pub(super) orientation: DQuat,
}

/// A piece in the world.
#[derive(Debug, Clone)]
pub(super) struct Placed {
    /// A hull has the vertices and normals of the world, relative to `center`.
    pub(super) core: Core,
    pub(super) margin: f64,
    pub(super) center: DVec3,
    pub(super) rotation: DMat3,
    /// Radius of a sphere about the centre that holds the piece, m; infinite for a half-space.
    pub(super) reach: f64,
}

impl Hull {
    fn new(solid: &Triangles) -> Self {
        let normal = |&[a, b, c]: &[usize; 3]| {
            let v = &solid.vertices;
            (v[b] - v[a]).cross(v[c] - v[a]).normalize_or_zero()
        };
        Self {
            vertices: solid.vertices.clone(),
            triangles: solid.triangles.clone(),
            normals: solid.triangles.iter().map(normal).collect(),
        }
    }

    fn cuboid(size: DVec3) -> Self {
        let corner = |k: usize| {
            let sign = |bit: usize| if k & bit == 0 { -0.5 } else { 0.5 };
            DVec3::new(sign(1), sign(2), sign(4)) * size
        };
        let triangles = vec![
            [0, 2, 3],
            [0, 3, 1],
            [4, 5, 7],
            [4, 7, 6],
            [0, 1, 5],
            [0, 5, 4],
            [2, 6, 7],
            [2, 7, 3],
            [0, 4, 6],
            [0, 6, 2],
            [1, 3, 7],
            [1, 7, 5],
        ];
        Self::new(&Triangles { vertices: (0..8).map(corner).collect(), triangles })
    }
}

impl Core {
    fn reach(&self) -> f64 {
        match self {
            Self::Point => 0.0,
            Self::Segment(half) => *half,
            Self::Circle(radius) => *radius,
            Self::Cylinder(radius, half) => radius.hypot(*half),
            Self::Cone(radius, base, apex) => radius.hypot(*base).max(*apex),
            Self::HalfSpace(_) => f64::INFINITY,
            Self::Hull(hull) => hull.vertices.iter().map(|vertex| vertex.length()).fold(0.0, f64::max),
        }
    }
}

/// The pieces of a shape.
pub(super) fn pieces(form: &Form) -> Vec<Piece> {
    let one =
        |core: Core, margin: f64| vec![Piece { core, margin, position: DVec3::ZERO, orientation: DQuat::IDENTITY }];
    match form {
        Form::HalfSpace(normal) => one(Core::HalfSpace(*normal), 0.0),
        Form::Cuboid(size) => one(Core::Hull(Hull::cuboid(*size)), 0.0),
        Form::Sphere(radius) => one(Core::Point, *radius),
        Form::Cylinder(radius, height) => one(Core::Cylinder(*radius, 0.5 * height), 0.0),
        Form::Cone(radius, height) => one(Core::Cone(*radius, -0.25 * height, 0.75 * height), 0.0),
        Form::Capsule(radius, height) => one(Core::Segment(0.5 * height), *radius),
        Form::Torus(major, minor) => one(Core::Circle(*major), *minor),
        Form::Convex(solid) => one(Core::Hull(Hull::new(solid)), 0.0),
        Form::Mesh(_, solids) => solids.iter().flat_map(|solid| one(Core::Hull(Hull::new(solid)), 0.0)).collect(),
        Form::Compound(parts) => parts
            .iter()
            .flat_map(|part| {
                pieces(&part.form).into_iter().map(move |piece| Piece {
                    position: part.position + part.orientation * piece.position,
                    orientation: part.orientation * piece.orientation,
                    ..piece
                })
            })
            .collect(),
    }
}

impl Piece {
    /// In the world, where its body is at this pose.
    pub(super) fn placed(&self, position: DVec3, orientation: DQuat) -> Placed {
        let rotation = DMat3::from_quat(orientation) * DMat3::from_quat(self.orientation);
        let turned = |v: &DVec3| rotation * *v;
        let core = match &self.core {
            Core::Hull(hull) => Core::Hull(Hull {
                vertices: hull.vertices.iter().map(turned).collect(),
                triangles: hull.triangles.clone(),
                normals: hull.normals.iter().map(turned).collect(),
            }),
            Core::HalfSpace(normal) => Core::HalfSpace(rotation * *normal),
            core => core.clone(),
        };
        Placed {
            core,
            margin: self.margin,
            center: position + orientation * self.position,
            rotation,
            reach: self.core.reach() + self.margin,
        }
    }
}

impl Placed {
    /// The axis z of the core, in the world.
    pub(super) fn axis(&self) -> DVec3 {
        self.rotation.z_axis
    }

    /// The largest product of a point of the core, relative to the centre, with a direction of the world.
    pub(super) fn support(&self, direction: DVec3) -> f64 {
        let along = direction.dot(self.axis());
        let across = || (direction - self.axis() * along).length();
        match &self.core {
            Core::Point => 0.0,
            Core::Segment(half) => half * along.abs(),
            Core::Circle(radius) => radius * across(),
            Core::Cylinder(radius, half) => half * along.abs() + radius * across(),
            Core::Cone(radius, base, apex) => (apex * along).max(base * along + radius * across()),
            Core::HalfSpace(normal) => {
                if (direction - *normal).length() < PARALLEL {
                    0.0
                } else {
                    f64::INFINITY
                }
            }
            Core::Hull(hull) => hull.vertices.iter().map(|v| v.dot(direction)).fold(f64::NEG_INFINITY, f64::max),
        }
    }
}

/// Unit vectors nearer than this are one direction (no unit): rounding of a rotation.
const PARALLEL: f64 = 1e-14;

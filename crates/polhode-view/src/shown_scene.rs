//! What is shown of a scene: its bodies as parts.

use crate::mesh_library::MeshLibrary;
use crate::tessellation::parts::equivalent_ellipsoid;
use crate::tessellation::{Detail, Parts, parts_of};
use polhode::scene::{Force, Joint, JointKind};
use polhode::spatial::{DVec3, MassProperties, Pose};
use polhode::{Body, BodyId, Scene};
use std::collections::BTreeSet;

/// A body as it is shown.
#[derive(Debug, Clone)]
pub struct ShownBody {
    /// Its name.
    pub name: String,
    /// Whether it may move, by forces or as prescribed.
    pub moves: bool,
    /// Mass, kg, when forces move it.
    pub mass_kg: Option<f64>,
    /// Centre of mass in the body's frame, m.
    pub center_of_mass: DVec3,
    /// Principal moments of inertia, ascending, kg m^2.
    pub principal_moments: Option<DVec3>,
    /// `R_PB`, scalar first: from the body's axes to the principal ones.
    pub principal_axes: [f64; 4],
    /// What is drawn.
    pub shape: Parts,
    /// Smallest and largest coordinates of the parts in the body's frame, m.
    pub bounds: Option<[DVec3; 2]>,
    /// Pose at the start.
    pub initial: Pose,
}

impl ShownBody {
    /// Largest distance of its parts from its origin, m.
    pub fn reach_m(&self) -> f64 {
        self.bounds.map_or(0.0, |[low, high]| low.abs().max(high.abs()).length())
    }

    /// The middle of the box around its parts in a pose, in the world, m; its origin where it has none.
    pub fn middle(&self, pose: &Pose) -> DVec3 {
        self.bounds.map_or(pose.translation, |[low, high]| pose.transform_point(0.5 * (low + high)))
    }

    /// Length of the diagonal of the box around its parts, m.
    pub fn size_m(&self) -> f64 {
        self.bounds.map_or(0.0, |[low, high]| (high - low).length())
    }
}

/// A joint as it is shown.
#[derive(Debug, Clone, Copy)]
pub struct ShownJoint {
    /// Whether it is a rod or a rope, drawn as a line between its ends.
    pub is_link: bool,
    /// Where it holds its bodies.
    pub ends: [JointEnd; 2],
}

/// An end of a joint.
#[derive(Debug, Clone, Copy)]
pub struct JointEnd {
    /// Number of the body; none of an end in the world.
    pub body: Option<usize>,
    /// In the frame of the body, or in the world, m.
    pub point: DVec3,
}

/// A scene as it is shown.
#[derive(Debug, Clone)]
pub struct ShownScene {
    /// Its name.
    pub name: String,
    /// Acceleration of gravity, m/s^2.
    pub gravity: DVec3,
    /// Simulated time, s.
    pub duration_s: f64,
    /// Its bodies, in the order of the scene.
    pub bodies: Vec<ShownBody>,
    /// Numbers of the bodies that may move, ascending.
    pub moving: Vec<usize>,
    /// Points that attract all bodies, m.
    pub centers: Vec<DVec3>,
    /// Its joints, in the order of the scene.
    pub joints: Vec<ShownJoint>,
    /// The chords of the curves that its bodies are held to, as links.
    pub tracks: Vec<ShownJoint>,
}

impl ShownScene {
    /// What is shown of a scene; its meshes go into the library.
    pub fn new(scene: &Scene, library: &mut MeshLibrary) -> Self {
        let detail = Detail::for_bodies(scene.bodies().len());
        let bodies: Vec<ShownBody> = scene.bodies().iter().map(|body| shown(body, detail, library)).collect();
        let moving = bodies.iter().enumerate().filter(|(_, body)| body.moves).map(|(number, _)| number).collect();
        let centers = scene.forces().iter().filter_map(|force| match force {
            Force::PointGravity { center, .. } => Some(*center),
            _ => None,
        });
        Self {
            name: scene.name().to_owned(),
            gravity: scene.gravity(),
            duration_s: scene.duration_s(),
            bodies,
            moving,
            centers: centers.collect(),
            joints: scene.joints().iter().map(|joint| shown_joint(scene, joint)).collect(),
            tracks: shown_tracks(scene),
        }
    }
}

fn shown_joint(scene: &Scene, joint: &Joint) -> ShownJoint {
    ShownJoint {
        is_link: matches!(joint.kind(), JointKind::Rod { .. } | JointKind::Rope { .. }),
        ends: [end(scene, Some(joint.body()), joint.anchor()), end(scene, joint.other(), joint.other_anchor())],
    }
}

/// Chords of tracks, once for each body that a track is fixed in.
fn shown_tracks(scene: &Scene) -> Vec<ShownJoint> {
    let mut drawn = BTreeSet::new();
    let mut chords = Vec::new();
    for joint in scene.joints() {
        let JointKind::Track { track, .. } = joint.kind() else { continue };
        let Some(curve) = scene.tracks().get(track.index()) else { continue };
        if !drawn.insert((track, joint.other())) {
            continue;
        }
        for pair in curve.polyline().windows(2) {
            chords.push(ShownJoint {
                is_link: true,
                ends: [pair[0], pair[1]].map(|place| end(scene, joint.other(), place)),
            });
        }
    }
    chords
}

fn end(scene: &Scene, body: Option<BodyId>, place: DVec3) -> JointEnd {
    let body = body.map(BodyId::index);
    let pose = body.and_then(|body| scene.bodies().get(body)).map(|body| *body.initial_pose());
    JointEnd { body, point: pose.map_or(place, |pose| pose.inverse_transform_point(place)) }
}

fn shown(body: &Body, detail: Detail, library: &mut MeshLibrary) -> ShownBody {
    let properties = body.mass_properties();
    let shape = match (body.shape(), properties) {
        (Some(geometry), _) => parts_of(geometry, detail, library),
        (None, Some(properties)) => equivalent_ellipsoid(properties, detail, library),
        (None, None) => Parts::default(),
    };
    let principal = properties.map(MassProperties::principal_axes);
    ShownBody {
        name: body.name().to_owned(),
        moves: !body.is_fixed() || body.motion().is_some(),
        mass_kg: properties.map(MassProperties::mass),
        center_of_mass: properties.map_or(DVec3::ZERO, MassProperties::center_of_mass),
        principal_moments: principal.map(|axes| axes.moments()),
        principal_axes: principal.map_or([1.0, 0.0, 0.0, 0.0], |axes| axes.rotation().inverse().to_wxyz()),
        bounds: bounds(&shape, library),
        initial: *body.initial_pose(),
        shape,
    }
}

/// The box around the parts.
fn bounds(shape: &Parts, library: &MeshLibrary) -> Option<[DVec3; 2]> {
    let mut all: Option<[DVec3; 2]> = None;
    for part in &shape.parts {
        for &vertex in &library.meshes()[part.mesh].positions {
            let p = part.point(vertex);
            all = Some(all.map_or([p; 2], |[low, high]| [low.min(p), high.max(p)]));
        }
    }
    all
}

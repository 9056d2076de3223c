//! What is shown of a scene: its bodies as parts.

use crate::camera::{FROM, Viewpoint};
use crate::colors;
use crate::fixtures::Fixtures;
use crate::mesh_library::MeshLibrary;
use crate::planar;
use crate::shown_body::ShownBody;
use crate::tessellation::parts::equivalent_ellipsoid;
use crate::tessellation::{Detail, Parts, parts_of};
use polhode::scene::{Appearance, BodyLook, Force};
use polhode::spatial::{DVec3, MassProperties};
use polhode::{Body, Scene};

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
    /// How many joints it has.
    pub joints: usize,
    /// What is drawn of joints, springs and tracks.
    pub fixtures: Fixtures,
    /// From where its file wants it shown.
    pub viewpoint: Viewpoint,
    /// Corners of a box that pictures hold, m; without it what is there.
    pub frame: Option<[DVec3; 2]>,
    /// Direction towards the camera when nobody says another.
    pub usual_from: DVec3,
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
            fixtures: Fixtures::new(scene, &bodies, library),
            bodies,
            moving,
            centers: centers.collect(),
            joints: scene.joints().len(),
            viewpoint: Viewpoint::default(),
            frame: None,
            usual_from: planar::square_on(scene).unwrap_or(FROM),
        }
    }

    /// Shows it as its file wants it.
    pub fn show_as(&mut self, appearance: &Appearance) {
        self.viewpoint = Viewpoint { standpoint: appearance.standpoint, target: appearance.look_at };
        self.frame = appearance.frame;
        for (body, look) in &appearance.bodies {
            if let Some(shown) = self.bodies.get_mut(body.index()) {
                shown.look = look.clone();
            }
        }
    }

    /// Colour of a body: its own, one of the palette by its place among those that move, or that of what stands; sRGB.
    pub fn color(&self, body: usize) -> [u8; 3] {
        let own = self.bodies.get(body).and_then(|shown| shown.look.color);
        own.unwrap_or_else(|| colors::of_place(self.moving.binary_search(&body).ok()))
    }

    /// The direction against gravity; z without any.
    pub fn up(&self) -> DVec3 {
        (-self.gravity).try_normalize().unwrap_or(DVec3::Z)
    }
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
        look: BodyLook::default(),
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

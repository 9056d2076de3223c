//! Animated models: binary glTF 2.0 (`.glb`).
//!
//! Every body is a node with its parts as children, every part a node with a mesh. A body that moves has an animation
//! of its position and its orientation, linear between frames. Players turn a body from one orientation to the next by
//! the shortest way, which is the wrong one from half a turn on: a body that turns fast has more orientations between
//! two frames. glTF has y up: a root node turns the world. A half-space is a square as large as what is shown needs.
//! Source: docs/REFERENCES.md, glTF 2.0.

use crate::colors;
use crate::error::ViewError;
use crate::recording::Recording;
use crate::surface_mesh::SurfaceMesh;
use crate::tessellation::{Part, polyhedron};
use polhode::contact::ConvexPolyhedron;
use polhode::spatial::{DQuat, DVec3, Pose, Rotation};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::io::Write;

/// `glTF`.
const MAGIC: u32 = 0x4654_6C67;
/// `JSON`.
const JSON_CHUNK: u32 = 0x4E4F_534A;
/// `BIN`.
const BINARY_CHUNK: u32 = 0x004E_4942;
/// glTF's names of component types and uses of buffers.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
/// Half the side of the square that a half-space is, in sizes of what is shown.
const GROUND_HALF_SIDE: f64 = 3.0;
/// Thickness of that square, as a fraction of its side.
const GROUND_THICKNESS: f64 = 1e-3;

/// Writes a recording as an animated model.
///
/// # Errors
/// When the recording has no frame or the model is too large, and those of writing.
pub fn write_glb(recording: &Recording, mut out: impl Write) -> Result<(), ViewError> {
    if recording.times().is_empty() {
        return Err(ViewError::NoFrames);
    }
    let mut model = Model::default();
    model.add_bodies(recording);
    model.add_animation(recording);
    let mut json = model.json(&recording.shown().name).to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let binary = model.binary;
    let total = 12 + 8 + json.len() + if binary.is_empty() { 0 } else { 8 + binary.len() };
    let length = |bytes: usize| u32::try_from(bytes).map_err(|_| ViewError::ModelTooLarge { bytes: total });
    for word in [MAGIC, 2, length(total)?, length(json.len())?, JSON_CHUNK] {
        out.write_all(&word.to_le_bytes())?;
    }
    out.write_all(&json)?;
    if !binary.is_empty() {
        for word in [length(binary.len())?, BINARY_CHUNK] {
            out.write_all(&word.to_le_bytes())?;
        }
        out.write_all(&binary)?;
    }
    out.flush()?;
    Ok(())
}

/// The lists of a glTF file.
#[derive(Default)]
struct Model {
    binary: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    meshes: Vec<Value>,
    materials: Vec<Value>,
    nodes: Vec<Value>,
    /// Nodes of the bodies, in the order of the scene.
    bodies: Vec<usize>,
    channels: Vec<Value>,
    samplers: Vec<Value>,
    /// Accessors of a surface: positions, normals, triangles.
    surfaces: BTreeMap<usize, [usize; 3]>,
    /// Meshes by surface and material.
    colored: BTreeMap<(usize, usize), usize>,
    /// Materials by colour.
    painted: BTreeMap<[u8; 3], usize>,
}

impl Model {
    /// Adds numbers to the buffer; the number of their accessor.
    fn add_floats(&mut self, kind: &str, rows: &[Vec<f32>], target: Option<u32>) -> usize {
        let width = rows.first().map_or(0, Vec::len);
        let bound = |pick: fn(f32, f32) -> f32| -> Vec<f32> {
            (0..width).map(|i| rows.iter().map(|row| row[i]).reduce(pick).unwrap_or_default()).collect()
        };
        let (low, high) = (bound(f32::min), bound(f32::max));
        let bytes: Vec<u8> = rows.iter().flatten().flat_map(|number| number.to_le_bytes()).collect();
        let view = self.add_view(&bytes, target);
        self.accessors.push(json!({
            "bufferView": view, "componentType": FLOAT, "count": rows.len(), "type": kind, "min": low, "max": high,
        }));
        self.accessors.len() - 1
    }

    fn add_view(&mut self, bytes: &[u8], target: Option<u32>) -> usize {
        let mut view = json!({ "buffer": 0, "byteOffset": self.binary.len(), "byteLength": bytes.len() });
        if let Some(target) = target {
            view["target"] = json!(target);
        }
        // All numbers have four bytes, so that every offset is a multiple of four.
        self.binary.extend_from_slice(bytes);
        self.views.push(view);
        self.views.len() - 1
    }

    /// Positions, normals and triangles of a surface, each once.
    fn surface(&mut self, number: usize, mesh: &SurfaceMesh) -> [usize; 3] {
        if let Some(&accessors) = self.surfaces.get(&number) {
            return accessors;
        }
        let rows = |vectors: &[DVec3]| vectors.iter().map(|&v| triple(v)).collect::<Vec<_>>();
        let positions = self.add_floats("VEC3", &rows(&mesh.positions), Some(ARRAY_BUFFER));
        // Rounded to 32 bits and of unit length still.
        let normals = self.add_floats("VEC3", &rows(&mesh.normals), Some(ARRAY_BUFFER));
        let bytes: Vec<u8> = mesh.triangles.iter().flatten().flat_map(|corner| corner.to_le_bytes()).collect();
        let view = self.add_view(&bytes, Some(ELEMENT_ARRAY_BUFFER));
        let most = mesh.triangles.iter().flatten().max().copied().unwrap_or_default();
        let least = mesh.triangles.iter().flatten().min().copied().unwrap_or_default();
        self.accessors.push(json!({
            "bufferView": view, "componentType": UNSIGNED_INT, "count": 3 * mesh.triangles.len(), "type": "SCALAR",
            "min": [least], "max": [most],
        }));
        let accessors = [positions, normals, self.accessors.len() - 1];
        self.surfaces.insert(number, accessors);
        accessors
    }

    /// The mesh of a surface in a colour.
    fn mesh(&mut self, number: usize, surface: &SurfaceMesh, color: [u8; 3]) -> usize {
        let material = self.material(color);
        if let Some(&mesh) = self.colored.get(&(number, material)) {
            return mesh;
        }
        let [positions, normals, indices] = self.surface(number, surface);
        self.meshes.push(json!({ "primitives": [{
            "attributes": { "POSITION": positions, "NORMAL": normals }, "indices": indices, "material": material,
        }] }));
        self.colored.insert((number, material), self.meshes.len() - 1);
        self.meshes.len() - 1
    }

    fn material(&mut self, color: [u8; 3]) -> usize {
        if let Some(&material) = self.painted.get(&color) {
            return material;
        }
        let [r, g, b] = colors::linear(color);
        self.materials.push(json!({ "pbrMetallicRoughness": {
            "baseColorFactor": [r, g, b, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.8,
        }, "doubleSided": true }));
        self.painted.insert(color, self.materials.len() - 1);
        self.materials.len() - 1
    }

    fn add_node(&mut self, node: Value) -> usize {
        self.nodes.push(node);
        self.nodes.len() - 1
    }

    fn add_bodies(&mut self, recording: &Recording) {
        let shown = recording.shown();
        let ground = recording.meshes().meshes().len();
        let [low, high] = recording.framing().bounds();
        let size = (high - low).length();
        for (number, (body, pose)) in shown.bodies.iter().zip(recording.poses(0)).enumerate() {
            let color = shown.color(number);
            let mut children = Vec::new();
            let is_seen = body.look.opacity > 0.0;
            for part in body.shape.parts.iter().filter(|_| is_seen) {
                let surface = &recording.meshes().meshes()[part.mesh];
                // A part that is too small to be drawn has no triangles.
                if surface.triangles.is_empty() {
                    continue;
                }
                let mesh = self.mesh(part.mesh, surface, color);
                children.push(self.add_node(part_node(part, mesh)));
            }
            for half_space in &body.shape.half_spaces {
                let Some(slab) = slab() else { continue };
                let mesh = self.mesh(ground, &slab, color);
                let side = 2.0 * GROUND_HALF_SIDE * size;
                let normal = half_space.normal();
                // The place of its plane that lies under the middle of what is shown.
                let center = pose.inverse_transform_point(0.5 * (low + high));
                let top = center - normal * (normal.dot(center) - half_space.offset());
                let part = Part {
                    mesh,
                    position: top - normal * (0.5 * GROUND_THICKNESS * side),
                    orientation: turned_from_z(normal),
                    scale: DVec3::new(side, side, GROUND_THICKNESS * side),
                };
                children.push(self.add_node(part_node(&part, mesh)));
            }
            let mut node = placed(&pose);
            node.insert("name".to_owned(), json!(body.name));
            if !children.is_empty() {
                node.insert("children".to_owned(), json!(children));
            }
            let node = self.add_node(Value::Object(node));
            self.bodies.push(node);
        }
    }

    /// Positions and orientations over time of all bodies that move at all.
    fn add_animation(&mut self, recording: &Recording) {
        // Times must ascend as numbers of 32 bits too, and begin with no less than zero.
        let mut frames: Vec<usize> = Vec::new();
        for (frame, &t) in recording.times().iter().enumerate() {
            let is_later = frames.last().is_none_or(|&last| (t as f32) > recording.times()[last] as f32);
            if t >= 0.0 && is_later {
                frames.push(frame);
            }
        }
        if frames.len() < 2 {
            return;
        }
        let times: Vec<f32> = frames.iter().map(|&frame| recording.times()[frame] as f32).collect();
        let mut shared = None;
        for (place, &body) in recording.shown().moving.iter().enumerate() {
            let poses: Vec<&Pose> = frames.iter().map(|&frame| &recording.moving_poses(frame)[place]).collect();
            let translations: Vec<Vec<f32>> = poses.iter().map(|pose| triple(pose.translation)).collect();
            let turns = orientations(recording, &frames, place);
            let turn_times: Vec<f32> = turns.iter().map(|(t, _)| *t).collect();
            let rotations = continuous(turns.iter().map(|(_, rotation)| *rotation));
            for (path, kind, rows, own) in
                [("translation", "VEC3", translations, &times), ("rotation", "VEC4", rotations, &turn_times)]
            {
                if rows.windows(2).all(|pair| pair[0] == pair[1]) {
                    continue;
                }
                let input = match shared {
                    Some(input) if *own == times => input,
                    _ => {
                        let input = self.add_floats("SCALAR", &own.iter().map(|&t| vec![t]).collect::<Vec<_>>(), None);
                        if *own == times {
                            shared = Some(input);
                        }
                        input
                    }
                };
                let output = self.add_floats(kind, &rows, None);
                self.samplers.push(json!({ "input": input, "output": output, "interpolation": "LINEAR" }));
                let target = json!({ "node": self.bodies[body], "path": path });
                self.channels.push(json!({ "sampler": self.samplers.len() - 1, "target": target }));
            }
        }
    }

    fn json(&mut self, name: &str) -> Value {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let root = json!({ "name": "z is up", "rotation": [-half, 0.0, 0.0, half], "children": self.bodies });
        let root = self.add_node(root);
        let mut all = Map::new();
        all.insert("asset".to_owned(), json!({ "version": "2.0", "generator": "polhode" }));
        all.insert("scene".to_owned(), json!(0));
        all.insert("scenes".to_owned(), json!([{ "name": name, "nodes": [root] }]));
        let mut add = |key: &str, list: &mut Vec<Value>| {
            if !list.is_empty() {
                all.insert(key.to_owned(), Value::Array(std::mem::take(list)));
            }
        };
        add("nodes", &mut self.nodes);
        add("meshes", &mut self.meshes);
        add("materials", &mut self.materials);
        add("accessors", &mut self.accessors);
        add("bufferViews", &mut self.views);
        if !self.channels.is_empty() {
            let animation = json!({ "name": "motion", "channels": self.channels, "samplers": self.samplers });
            all.insert("animations".to_owned(), json!([animation]));
        }
        if !self.binary.is_empty() {
            all.insert("buffers".to_owned(), json!([{ "byteLength": self.binary.len() }]));
        }
        Value::Object(all)
    }
}

/// A pose as the properties of a node.
fn placed(pose: &Pose) -> Map<String, Value> {
    let mut node = Map::new();
    node.insert("translation".to_owned(), json!(triple(pose.translation)));
    node.insert("rotation".to_owned(), json!(xyzw(pose.rotation.to_wxyz())));
    node
}

fn part_node(part: &Part, mesh: usize) -> Value {
    let mut node = placed(&Pose::new(part.orientation, part.position));
    node.insert("scale".to_owned(), json!(triple(part.scale)));
    node.insert("mesh".to_owned(), json!(mesh));
    Value::Object(node)
}

/// A box of edge 1, for planes.
fn slab() -> Option<SurfaceMesh> {
    ConvexPolyhedron::cuboid(DVec3::ONE).ok().map(|cuboid| polyhedron::surface(&cuboid))
}

/// The shortest rotation of z into a unit vector.
fn turned_from_z(normal: DVec3) -> Rotation {
    let cross = DVec3::Z.cross(normal);
    let q = DQuat::from_xyzw(cross.x, cross.y, cross.z, 1.0 + normal.z);
    // Straight down there is no shortest one: half a turn about x.
    if q.length_squared() > f64::EPSILON {
        Rotation::renormalized(q)
    } else {
        Rotation::renormalized(DQuat::from_xyzw(1.0, 0.0, 0.0, 0.0))
    }
}

/// Largest angle from one orientation to the next, rad: well below half a turn, so that the shortest way is the right
/// one.
const LARGEST_TURN: f64 = 2.0;

/// Orientations between two frames at the most: a body that turns faster than they show is a blur at any rate.
const MOST_BETWEEN: f64 = 64.0;

/// Times (s) and orientations of a body that moves: in the frames, and between them where it turns fast.
fn orientations(recording: &Recording, frames: &[usize], place: usize) -> Vec<(f32, Rotation)> {
    let mut list: Vec<(f32, Rotation)> = Vec::with_capacity(frames.len());
    let mut add = |t: f64, rotation: Rotation| {
        if list.last().is_none_or(|&(last, _)| t as f32 > last) {
            list.push((t as f32, rotation));
        }
    };
    for pair in frames.windows(2) {
        let [start, end] = [pair[0], pair[1]].map(|frame| recording.turning(frame, place));
        let (t, h) = (recording.times()[pair[0]], recording.times()[pair[1]] - recording.times()[pair[0]]);
        add(t, start.rotation);
        let parts = (start.angle_to(&end, h) / LARGEST_TURN).ceil().min(MOST_BETWEEN);
        for part in 1..parts as usize {
            let s = part as f64 / parts;
            // One that rounds to the time of the next frame would take its place.
            if ((t + s * h) as f32) < (t + h) as f32 {
                add(t + s * h, start.towards(&end, h, s));
            }
        }
    }
    if let Some(&last) = frames.last() {
        add(recording.times()[last], recording.turning(last, place).rotation);
    }
    list
}

/// Quaternions of which each is the nearer of the two that are the same rotation.
fn continuous(rotations: impl Iterator<Item = Rotation>) -> Vec<Vec<f32>> {
    let mut last = [1.0, 0.0, 0.0, 0.0];
    rotations
        .map(|rotation| {
            let q = rotation.to_wxyz();
            let dot: f64 = q.iter().zip(last).map(|(a, b)| a * b).sum();
            last = if dot < 0.0 { q.map(|component| -component) } else { q };
            xyzw(last).to_vec()
        })
        .collect()
}

/// Scalar last, as glTF has it.
fn xyzw([w, x, y, z]: [f64; 4]) -> [f32; 4] {
    [x, y, z, w].map(|component| component as f32)
}

fn triple(vector: DVec3) -> Vec<f32> {
    vector.to_array().map(|number| number as f32).to_vec()
}

//! Models: the structure of a binary glTF file.

use polhode::contact::Shape;
use polhode::mesh::solid_box;
use polhode::spatial::{DVec3, Mass, Pose, UnitVector, Velocity};
use polhode::{Body, Scene, Simulation};
use polhode_view::Recording;
use polhode_view::glb::write_glb;
use serde_json::Value;

/// A brick that falls and spins, one that rests, and the floor.
fn model() -> (Value, Vec<u8>, usize) {
    let brick = |name: &str, place: DVec3| {
        Body::movable(name, solid_box(DVec3::ONE, Mass::new(2.0).unwrap()).unwrap())
            .geometry(Shape::cuboid(DVec3::ONE).unwrap().into())
            .pose(Pose::from_translation(place))
    };
    let spin = Velocity { linear: DVec3::ZERO, angular: DVec3::new(1.0, 7.0, 0.5) };
    let scene = Scene::builder("model")
        .body(Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into()))
        .body(brick("resting", DVec3::Z * 0.5))
        .body(brick("spinning", DVec3::new(3.0, 0.0, 20.0)).velocity(spin))
        .build()
        .unwrap();
    written(&scene)
}

/// The model of a run: its description, its numbers, and the number of frames.
fn written(scene: &Scene) -> (Value, Vec<u8>, usize) {
    let mut recording = Recording::new(scene, 0.0).unwrap();
    Simulation::new(scene).unwrap().run_observed(&mut recording).unwrap();
    recording.end().unwrap();
    let mut bytes = Vec::new();
    write_glb(&recording, &mut bytes).unwrap();
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!(&bytes[..4], b"glTF");
    assert_eq!((word(4), word(8)), (2, bytes.len()));
    let json_end = 20 + word(12);
    assert_eq!((&bytes[16..20], json_end % 4), (&b"JSON"[..], 0));
    let binary = word(json_end);
    assert_eq!((&bytes[json_end + 4..json_end + 8], binary % 4), (&b"BIN\0"[..], 0));
    assert_eq!(json_end + 8 + binary, bytes.len());
    let json = serde_json::from_slice(&bytes[20..json_end]).unwrap();
    (json, bytes[json_end + 8..].to_vec(), recording.times().len())
}

/// The rows of an accessor.
fn rows(json: &Value, binary: &[u8], accessor: usize) -> Vec<Vec<f32>> {
    let accessor = &json["accessors"][accessor];
    let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
    let (offset, length) =
        (view["byteOffset"].as_u64().unwrap() as usize, view["byteLength"].as_u64().unwrap() as usize);
    let width = match accessor["type"].as_str().unwrap() {
        "SCALAR" => 1,
        "VEC3" => 3,
        _ => 4,
    };
    let is_float = accessor["componentType"] == 5126;
    let numbers: Vec<f32> = binary[offset..offset + length]
        .chunks_exact(4)
        .map(|four| {
            let four = four.try_into().unwrap();
            if is_float { f32::from_le_bytes(four) } else { u32::from_le_bytes(four) as f32 }
        })
        .collect();
    assert_eq!(numbers.len(), width * accessor["count"].as_u64().unwrap() as usize);
    numbers.chunks_exact(width).map(<[f32]>::to_vec).collect()
}

#[test]
fn accessors_say_what_they_hold() {
    let (json, binary, _) = model();
    assert_eq!(json["buffers"][0]["byteLength"].as_u64().unwrap() as usize, binary.len());
    for accessor in 0..json["accessors"].as_array().unwrap().len() {
        let rows = rows(&json, &binary, accessor);
        for (key, pick) in [("min", f32::min as fn(f32, f32) -> f32), ("max", f32::max)] {
            let bound = json["accessors"][accessor][key].as_array().unwrap();
            for (i, value) in bound.iter().enumerate() {
                let found = rows.iter().map(|row| row[i]).reduce(pick).unwrap();
                assert_eq!(value.as_f64().unwrap() as f32, found, "{accessor} {key} {i}");
            }
        }
    }
}

/// What moves is animated, what rests is not; times ascend, quaternions are of unit length and do not jump.
#[test]
fn animation() {
    let (json, binary, frames) = model();
    let channels = json["animations"][0]["channels"].as_array().unwrap();
    let node = |channel: &Value| channel["target"]["node"].as_u64().unwrap() as usize;
    assert!(channels.iter().all(|channel| json["nodes"][node(channel)]["name"] == "spinning"));
    assert_eq!(channels.len(), 2);
    for channel in channels {
        let sampler = &json["animations"][0]["samplers"][channel["sampler"].as_u64().unwrap() as usize];
        let input = rows(&json, &binary, sampler["input"].as_u64().unwrap() as usize);
        let output = rows(&json, &binary, sampler["output"].as_u64().unwrap() as usize);
        assert_eq!((input.len(), output.len()), (frames, frames));
        assert!(input.windows(2).all(|pair| pair[0][0] < pair[1][0]));
        if channel["target"]["path"] == "rotation" {
            let dot = |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f32>();
            assert!(output.iter().all(|q| (dot(q, q) - 1.0).abs() < 1e-6));
            assert!(output.windows(2).all(|pair| dot(&pair[0], &pair[1]) > 0.9));
        } else {
            let last = output.last().unwrap();
            assert!((last[2] - (20.0 - 0.5 * 9.81)).abs() < 1e-5, "{last:?}");
        }
    }
}

/// The two bricks share the numbers of their surface.
#[test]
fn surfaces_are_shared() {
    let (json, ..) = model();
    let meshes = json["meshes"].as_array().unwrap();
    let positions = |mesh: usize| meshes[mesh]["primitives"][0]["attributes"]["POSITION"].clone();
    assert_eq!(meshes.len(), 3, "floor and two colours");
    assert_eq!(positions(1), positions(2));
    assert_eq!(json["asset"]["version"], "2.0");
}

/// A body that turns by more than half a turn from frame to frame turns forwards in a player, which takes the shortest
/// way from one orientation to the next: the turns between them add up to all that it has turned. (Before, a player
/// turned it backwards.)
#[test]
fn fast_bodies_turn_forwards() {
    let (spin, duration_s) = (250.0, 0.5);
    let brick = Body::movable("bar", solid_box(DVec3::new(1.0, 0.2, 0.1), Mass::new(1.0).unwrap()).unwrap())
        .geometry(Shape::cuboid(DVec3::new(1.0, 0.2, 0.1)).unwrap().into())
        .velocity(Velocity { linear: DVec3::ZERO, angular: DVec3::Z * spin });
    let scene = Scene::builder("fast").duration_s(duration_s).output_interval_s(1.0 / 60.0).gravity(DVec3::ZERO);
    let (json, binary, frames) = written(&scene.body(brick).build().unwrap());
    let channel = json["animations"][0]["channels"]
        .as_array()
        .unwrap()
        .iter()
        .find(|channel| channel["target"]["path"] == "rotation");
    let sampler = &json["animations"][0]["samplers"][channel.unwrap()["sampler"].as_u64().unwrap() as usize];
    let [times, turns] = ["input", "output"].map(|key| rows(&json, &binary, sampler[key].as_u64().unwrap() as usize));
    assert!(times.len() == turns.len() && turns.len() > 2 * frames, "{} {frames}", turns.len());
    assert!(times.windows(2).all(|pair| pair[0][0] < pair[1][0]));
    let mut turned = 0.0;
    for pair in turns.windows(2) {
        let [[x0, y0, z0, w0], [x1, y1, z1, w1]] =
            [&pair[0], &pair[1]].map(|q| [q[0], q[1], q[2], q[3]].map(f64::from));
        let cosine = x0 * x1 + y0 * y1 + z0 * z1 + w0 * w1;
        // Of the shortest way; its sense is that of the z component of q1 q0^-1.
        let sine = w0 * z1 - z0 * w1 + x0 * y1 - y0 * x1;
        turned += 2.0 * libm::atan2(sine * cosine.signum(), cosine.abs());
    }
    assert!((turned - spin * duration_s).abs() < 1e-3, "{turned}");
}

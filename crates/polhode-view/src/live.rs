//! What a page shows of a scene that it runs itself: the bodies and meshes of a page, without a motion.

use crate::mesh_library::MeshLibrary;
use crate::page::{self, VERSION};
use crate::shown_scene::ShownScene;
use polhode::Scene;
use serde_json::{Value, json};

/// The scene as a page shows it at its start.
pub fn scene_json(scene: &Scene, title: &str, description: &str) -> Value {
    let mut meshes = MeshLibrary::default();
    let shown = ShownScene::new(scene, &mut meshes);
    let initial = scene.bodies().iter().map(|body| page::pose_json(body.initial_pose()));
    let run = json!({
        "name": scene.name(),
        "duration_s": scene.duration_s(),
        "bodies": shown.bodies.iter().map(page::body_json).collect::<Vec<_>>(),
        "joints": shown.joints.iter().chain(&shown.tracks).map(page::joint_json).collect::<Vec<_>>(),
        "initial": initial.collect::<Vec<_>>(),
        "frames": { "count": 0, "times": "", "moving": shown.moving },
    });
    json!({
        "version": VERSION,
        "title": title,
        "description": description,
        "gravity": scene.gravity().to_array(),
        "meshes": meshes.meshes().iter().map(page::mesh_json).collect::<Vec<_>>(),
        "runs": [run],
    })
}

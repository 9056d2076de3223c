//! What a page shows of a scene that it runs itself: the bodies and meshes of a page, without a motion.

use crate::extent::Extent;
use crate::mesh_library::MeshLibrary;
use crate::page::{self, VERSION};
use crate::shown_scene::ShownScene;
use polhode::Scene;
use polhode::scene::Appearance;
use serde_json::{Value, json};

/// The scene as a page shows it at its start; the camera holds what moves as it stands then.
pub fn scene_json(scene: &Scene, appearance: &Appearance, title: &str, description: &str) -> Value {
    let mut meshes = MeshLibrary::default();
    let mut shown = ShownScene::new(scene, &mut meshes);
    shown.show_as(appearance);
    let initial: Vec<_> = scene.bodies().iter().map(|body| *body.initial_pose()).collect();
    let mut run = page::described(&shown, Extent::new(), &initial);
    run["name"] = json!(scene.name());
    run["duration_s"] = json!(scene.duration_s());
    run["frames"] = json!({ "count": 0, "times": "", "moving": shown.moving });
    json!({
        "version": VERSION,
        "title": title,
        "description": description,
        "gravity": scene.gravity().to_array(),
        "look": page::look_json(),
        "meshes": meshes.meshes().iter().map(page::mesh_json).collect::<Vec<_>>(),
        "runs": [run],
    })
}

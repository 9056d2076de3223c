//! Scenes whose motion is known from the tier `accurate` at its tightest: random mechanisms and contacts, scenes that
//! were reported, and those that ship.

use super::answers;
use super::known::{Copy, Known, MakeScene, Truth};
use super::setting::{for_so_long, tier_of};
use glam::{DQuat, DVec3};
use polhode::Scene;
use polhode::scene::Tier;
use polhode::spatial::{Pose, Rotation};
use polhode_oracles::random::Random;
use polhode_oracles::random_mechanism::generate;
use polhode_oracles::random_mechanism::placement::Placement;
use polhode_oracles::random_scene;
use polhode_oracles::random_scene::copies::SceneCopy;
use std::error::Error;
use std::path::{Path, PathBuf};

/// Random mechanisms, and random scenes of contacts.
const MECHANISMS: u64 = 120;
const CONTACTS: u64 = 60;
/// The tier `fast` takes one mechanism in so many.
const FAST_OF: u64 = 3;
/// The piece of a random scene of contacts that is computed, s.
const PIECE_S: f64 = 0.3;
/// The piece of a scene that ships or was reported, s.
const SHIPPED_S: f64 = 1.0;
/// Shorter pieces (s) of scenes that the tier `accurate` takes seconds for at its tightest.
const SHORTER_S: [(&str, f64); 24] = [
    ("andrews-squeezer", 0.03),
    ("bricard", 0.3),
    ("car", 0.2),
    ("carried-by-a-turntable", 0.3),
    ("carton-with-content", 0.2),
    ("cubes-2x1x2-hit", 0.1),
    ("cubes-2x2x2-hit", 0.05),
    ("diamond-4-collapsing", 0.3),
    ("diamond-5", 0.1),
    ("diamond-5-asymmetric", 0.1),
    ("dice27", 0.2),
    ("dominoes-that-bounce", 0.2),
    ("dropped-bricks", 0.2),
    ("fast-pyramid", 0.05),
    ("hanging-bridge", 0.2),
    ("n-four-bar", 0.3),
    ("pile-that-hangs", 0.3),
    ("push-rough", 0.2),
    ("quadruped", 0.3),
    ("ragdoll", 0.2),
    ("ragdoll-on-stairs", 0.3),
    ("random-bearing-friction-three-cranks", 0.1),
    ("rods-6", 0.05),
    ("rods-10", 0.02),
];
/// A seed of contacts that crowd, and the piece of it that is computed, s.
const CROWDED: (u64, f64) = (18, 0.1);

/// All of them, of the workspace in this folder; random ones of a draw.
pub(super) fn all(root: &Path, draw: u64) -> Vec<Known> {
    let mut all: Vec<Known> = (MECHANISMS * draw..MECHANISMS * (draw + 1)).map(mechanism).collect();
    all.extend((CONTACTS * draw..CONTACTS * (draw + 1)).map(contacts));
    all.extend(files(root, "fixtures/reported", "reported"));
    all.extend(files(root, "fixtures/scenes", "shipped"));
    all
}

/// A pose as the oracles have it.
fn pose_of((position, orientation): (DVec3, DQuat)) -> Pose {
    Pose::new(Rotation::renormalized(orientation), position)
}

/// The random mechanism of a seed.
fn mechanism(seed: u64) -> Known {
    let scene = generate::scene(seed);
    let placement = generate::other_placement(seed);
    let make = move |placement: Placement| -> MakeScene {
        Box::new(move || {
            let text = generate::scene(seed).written(&placement, Tier::Accurate.name(), None);
            Ok(polhode_scene::load_text("random mechanism", &text, &[])?.scene)
        })
    };
    let undone = move |row: &mut Vec<Pose>| {
        if placement.is_reversed {
            row.reverse();
        }
        for pose in row {
            *pose = pose_of(placement.undone(pose.translation, pose.rotation.quaternion()));
        }
    };
    let mut tiers = vec![Tier::Accurate, Tier::Stepped];
    tiers.extend(seed.is_multiple_of(FAST_OF).then_some(Tier::Fast));
    Known {
        name: format!("mechanism/{seed} {}", scene.kind),
        scene: make(Placement::AS_IS),
        truth: Truth::Run(Some(Copy { scene: make(placement), undone: Box::new(undone) })),
        tiers,
        step_s: Some(scene.step),
    }
}

/// The random scene of contacts of a seed.
fn contacts(seed: u64) -> Known {
    let angle = Random(seed).between(0.1, 3.0);
    let make = move |copy: SceneCopy| -> MakeScene { Box::new(move || piece(seed, copy)) };
    let undone = move |row: &mut Vec<Pose>| {
        let back = DQuat::from_rotation_z(-angle);
        for pose in row {
            *pose = pose_of((back * pose.translation, back * pose.rotation.quaternion()));
        }
    };
    let turned = Copy { scene: make(SceneCopy::Turned(angle)), undone: Box::new(undone) };
    Known {
        name: format!("contacts/{seed}"),
        scene: make(SceneCopy::Moved(DVec3::ZERO)),
        truth: Truth::Run(Some(turned)),
        tiers: vec![Tier::Accurate, Tier::Stepped],
        step_s: None,
    }
}

/// The first piece of a random scene of contacts, with its meshes.
fn piece(seed: u64, copy: SceneCopy) -> Result<Scene, Box<dyn Error>> {
    let mut model = random_scene::generate::scene(seed);
    // What this law gives depends on the order of contacts, which tiers and copies do not share.
    model.impact = model.impact.filter(|law| *law != "propagation");
    let written = copy.of(&model).written("random");
    let folder = tempfile::tempdir()?;
    for (name, mesh) in &written.meshes {
        std::fs::write(folder.path().join(name), mesh)?;
    }
    let origin = folder.path().join("random.toml");
    let scene = polhode_scene::load_text(&origin.display().to_string(), &written.text, &[])?.scene;
    for_so_long(scene, if seed == CROWDED.0 { CROWDED.1 } else { PIECE_S })
}

/// The scene files of a folder.
fn files(root: &Path, folder: &str, source: &str) -> Vec<Known> {
    let entries = std::fs::read_dir(root.join(folder)).into_iter().flatten().flatten();
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    paths.sort();
    paths.into_iter().map(|path| file(path, source)).collect()
}

/// A scene file, by its own tier and by those that estimate errors of others best.
fn file(path: PathBuf, source: &str) -> Known {
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let mut tiers = vec![Tier::Accurate, Tier::Stepped];
    let loaded = polhode_scene::load(&path).ok();
    // Springs have a law of their own, which no other tier computes.
    let own = loaded.as_ref().map(tier_of).filter(|own| *own != Tier::Penalty && !tiers.contains(own));
    tiers.extend(own);
    let answer = loaded.as_ref().and_then(|scene| answers::motion(&stem, scene));
    let truth = answer.map_or(Truth::Run(None), Truth::Motion);
    let most_s = SHORTER_S.iter().find(|(name, _)| *name == stem).map_or(SHIPPED_S, |(_, most_s)| *most_s);
    let scene: MakeScene = Box::new(move || for_so_long(polhode_scene::load(&path)?, most_s));
    Known { name: format!("{source}/{stem}"), scene, truth, tiers, step_s: None }
}

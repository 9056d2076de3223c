//! A scene that several tiers compute: a random mechanism, or a piece of a random scene of contacts.

use glam::{DQuat, DVec3};
use polhode_oracles::judge::tiers::DISTURBED;
use polhode_oracles::random::Random;
use polhode_oracles::random_mechanism::generate;
use polhode_oracles::random_mechanism::model::Mechanism;
use polhode_oracles::random_mechanism::placement::Placement;
use polhode_oracles::random_scene;
use polhode_oracles::random_scene::copies::SceneCopy;
use polhode_oracles::random_scene::model::Model;
use polhode_scene::Override;
use std::error::Error;
use std::path::Path;

/// The piece of a random scene of contacts that is computed, s, and its longest fixed step, s.
const PIECE_S: f64 = 0.3;
const STEP_S: f64 = 0.002;
/// Time between samples in longest steps of tiers of fixed steps: the same instants for every step.
const STEPS_A_SAMPLE: f64 = 10.0;
/// The same between events, where steps are longer.
const SMOOTH_STEPS_A_SAMPLE: f64 = 5.0;

/// How a scene is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Copy {
    /// As it is.
    None,
    /// Set otherwise in the world.
    Placed,
    /// Started a little elsewhere.
    Disturbed,
}

/// A scene.
#[derive(Debug)]
pub(super) enum Subject {
    Mechanism(Box<Mechanism>),
    Scene(Box<Model>),
}

/// A scene file with its meshes, and what is set besides.
#[derive(Debug)]
pub(super) struct Text {
    pub(super) toml: String,
    pub(super) meshes: Vec<(String, String)>,
    pub(super) overrides: Vec<Override>,
}

impl Text {
    /// Writes the files into a folder; the overrides stand in a comment.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub(super) fn write(&self, path: &Path) -> Result<(), Box<dyn Error>> {
        let sets = self.overrides.iter().map(|set| format!("# --set {}={}\n", set.key, set.value));
        std::fs::write(path, sets.collect::<String>() + &self.toml)?;
        for (name, mesh) in &self.meshes {
            std::fs::write(path.with_file_name(name), mesh)?;
        }
        Ok(())
    }
}

impl Subject {
    /// The mechanism of a seed, or its scene of contacts.
    pub(super) fn of(seed: u64, is_scene: bool) -> Self {
        if is_scene {
            let mut model = random_scene::generate::scene(seed);
            // What this law gives depends on the order of contacts, which tiers and copies do not share.
            model.impact = model.impact.filter(|law| *law != "propagation");
            Self::Scene(Box::new(model))
        } else {
            Self::Mechanism(Box::new(generate::scene(seed)))
        }
    }

    pub(super) fn seed(&self) -> u64 {
        match self {
            Self::Mechanism(scene) => scene.seed,
            Self::Scene(model) => model.seed,
        }
    }

    pub(super) fn kind(&self) -> &'static str {
        match self {
            Self::Mechanism(scene) => scene.kind,
            Self::Scene(_) => "random contacts",
        }
    }

    pub(super) fn is_smooth(&self) -> bool {
        matches!(self, Self::Mechanism(scene) if scene.is_smooth)
    }

    /// The longest step of tiers of fixed steps, s.
    pub(super) fn step_s(&self) -> f64 {
        match self {
            Self::Mechanism(scene) => scene.step,
            Self::Scene(_) => STEP_S,
        }
    }

    fn duration_s(&self) -> f64 {
        match self {
            Self::Mechanism(scene) => scene.duration,
            Self::Scene(model) => model.duration.min(PIECE_S),
        }
    }

    /// The sizes of the bodies, m; infinite of those that forces do not move.
    pub(super) fn sizes(&self) -> Vec<f64> {
        match self {
            Self::Mechanism(scene) => {
                scene.bodies.iter().map(|body| if body.is_free() { body.size } else { f64::INFINITY }).collect()
            }
            Self::Scene(model) => {
                let size = |body: &random_scene::model::Body| {
                    if body.is_free() { body.form.reach() } else { f64::INFINITY }
                };
                model.bodies.iter().map(size).collect()
            }
        }
    }

    /// The name of a body.
    pub(super) fn name(&self, body: usize) -> &str {
        match self {
            Self::Mechanism(scene) => scene.bodies.get(body).map_or("", |body| &body.name),
            Self::Scene(model) => model.bodies.get(body).map_or("", |body| &body.name),
        }
    }

    fn placement(&self) -> Placement {
        generate::other_placement(self.seed())
    }

    fn scene_copy(&self, copy: Copy) -> SceneCopy {
        match copy {
            Copy::None => SceneCopy::Moved(DVec3::ZERO),
            Copy::Placed => SceneCopy::Turned(Random(self.seed()).between(0.1, 3.0)),
            Copy::Disturbed => SceneCopy::Disturbed(DISTURBED),
        }
    }

    /// The scene file for a tier and a step, s (none: as the plan has it).
    pub(super) fn text(&self, copy: Copy, tier: &str, step_s: Option<f64>) -> Text {
        let set = |key: &str, value: String| Override::new("the judge of tiers", key, value);
        let steps = if self.is_smooth() { SMOOTH_STEPS_A_SAMPLE } else { STEPS_A_SAMPLE };
        let interval = set("output.interval", format!("{:?}", steps * self.step_s()));
        match self {
            Self::Mechanism(scene) => {
                let text = match copy {
                    Copy::None => scene.written(&Placement::AS_IS, tier, step_s),
                    Copy::Placed => scene.written(&self.placement(), tier, step_s),
                    Copy::Disturbed => scene.disturbed(DISTURBED).written(&Placement::AS_IS, tier, step_s),
                };
                Text { toml: text, meshes: Vec::new(), overrides: vec![interval] }
            }
            Self::Scene(model) => {
                let written = self.scene_copy(copy).of(model).written("random");
                let mut overrides = vec![interval, set("method.tier", format!("\"{tier}\""))];
                overrides.push(set("duration", format!("{:?}", self.duration_s())));
                overrides.extend(step_s.map(|step_s| set("method.step", format!("{step_s:?}"))));
                Text { toml: written.text, meshes: written.meshes, overrides }
            }
        }
    }

    /// The poses of a copy, in the order and the place of the scene as it is.
    pub(super) fn undone(&self, copy: Copy, row: &mut [(DVec3, DQuat)]) {
        match (self, copy) {
            (Self::Mechanism(_), Copy::Placed) => {
                let placement = self.placement();
                if placement.is_reversed {
                    row.reverse();
                }
                for pose in row.iter_mut() {
                    *pose = placement.undone(pose.0, pose.1);
                }
            }
            (Self::Scene(_), Copy::Placed) => {
                let SceneCopy::Turned(angle) = self.scene_copy(copy) else { return };
                let back = DQuat::from_rotation_z(-angle);
                for pose in row.iter_mut() {
                    *pose = (back * pose.0, back * pose.1);
                }
            }
            _ => {}
        }
    }
}

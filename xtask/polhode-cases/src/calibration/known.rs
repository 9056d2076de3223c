//! A scene whose motion is known, by whatever means.

use glam::DVec3;
use polhode::Scene;
use polhode::scene::Tier;
use polhode::spatial::{Pose, Rotation};
use std::error::Error;
use std::fmt;

/// A scene whose motion is known.
pub struct Known {
    /// Its source and what it is, with a slash between.
    pub name: String,
    /// Makes the scene.
    pub(super) scene: MakeScene,
    /// What is known of its motion.
    pub(super) truth: Truth,
    /// The tiers whose runs are compared with it.
    pub(super) tiers: Vec<Tier>,
    /// Step of the tier `stepped`, s; none for that of all.
    pub(super) step_s: Option<f64>,
}

impl fmt::Debug for Known {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Known").field("name", &self.name).field("tiers", &self.tiers).finish_non_exhaustive()
    }
}

/// Makes a scene when it is asked for, so that a list of all costs nothing.
pub(super) type MakeScene = Box<dyn Fn() -> Result<Scene, Box<dyn Error>> + Send + Sync>;

/// Where bodies are after a time, s.
pub(super) type Motion = Box<dyn Fn(f64) -> Vec<Place> + Send + Sync>;

/// Takes the poses of all bodies of a copy to those of the scene as it is.
pub(super) type Undo = Box<dyn Fn(&mut Vec<Pose>) + Send + Sync>;

/// What is known of a motion.
pub(super) enum Truth {
    /// The places of some bodies at any time, from a closed form or a reference.
    Motion(Motion),
    /// Nothing moves.
    Still,
    /// What the tier `accurate` computes at its tightest; how well it is known shows a copy of the scene.
    Run(Option<Copy>),
}

/// The same scene set otherwise in the world.
pub(super) struct Copy {
    /// Makes it.
    pub(super) scene: MakeScene,
    /// Takes the poses of all its bodies to those of the scene as it is, in its order.
    pub(super) undone: Undo,
}

/// What is known of where a body is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// The number of the body.
    pub(super) body: usize,
    /// Of its origin, m.
    pub(super) position: Option<DVec3>,
    /// Its attitude.
    pub(super) attitude: Option<Rotation>,
}

impl Place {
    /// The origin of a body is here.
    pub(super) fn at(body: usize, position: DVec3) -> Self {
        Self { body, position: Some(position), attitude: None }
    }

    /// A body has this pose.
    pub(super) fn pose(body: usize, pose: Pose) -> Self {
        Self { body, position: Some(pose.translation), attitude: Some(pose.rotation) }
    }
}

impl Known {
    /// A scene with a motion that is known at any time.
    pub(super) fn motion(
        name: String,
        scene: Scene,
        tiers: &[Tier],
        motion: impl Fn(f64) -> Vec<Place> + Send + Sync + 'static,
    ) -> Self {
        let scene: MakeScene = Box::new(move || Ok(scene.clone()));
        Self { name, scene, truth: Truth::Motion(Box::new(motion)), tiers: tiers.to_vec(), step_s: None }
    }

    /// Whether its motion is known from runs, which have a law of impacts.
    pub(super) fn is_by_runs(&self) -> bool {
        matches!(self.truth, Truth::Run(_))
    }

    /// A source whose scenes could not be made.
    pub(super) fn failed(source: &str, why: String) -> Self {
        let scene: MakeScene = Box::new(move || Err(why.clone().into()));
        Self {
            name: format!("{source}/its scenes"),
            scene,
            truth: Truth::Still,
            tiers: vec![Tier::Accurate],
            step_s: None,
        }
    }

    /// A scene in which nothing moves.
    pub(super) fn still(name: String, scene: Scene, tiers: &[Tier]) -> Self {
        let scene: MakeScene = Box::new(move || Ok(scene.clone()));
        Self { name, scene, truth: Truth::Still, tiers: tiers.to_vec(), step_s: None }
    }
}

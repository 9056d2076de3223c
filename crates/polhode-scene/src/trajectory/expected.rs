//! What a scene expects of the samples of its trajectory.

use crate::output::COLUMNS;
use crate::trajectory_rows::{FIRST_NUMBER, NUMBERS};
use glam::DVec3;
use polhode::spatial::{Pose, Rotation, Velocity};
use polhode::{BodyError, BodySample, Scene};
use std::collections::BTreeMap;

/// Names that an error lists at the most.
const MOST_NAMES: usize = 8;

/// The bodies of a scene, and the time that has been reached.
#[derive(Debug)]
pub(super) struct Expected {
    scene: String,
    names: Vec<String>,
    number_of: BTreeMap<String, usize>,
    last_s: f64,
}

impl Expected {
    pub(super) fn new(scene: &Scene) -> Self {
        let names: Vec<String> = scene.bodies().iter().map(|body| body.name().to_owned()).collect();
        let number_of = names.iter().enumerate().map(|(number, name)| (name.clone(), number)).collect();
        Self { scene: scene.name().to_owned(), names, number_of, last_s: f64::NEG_INFINITY }
    }

    /// Number of bodies of a sample.
    pub(super) fn count(&self) -> usize {
        self.names.len()
    }

    /// Name of a body.
    pub(super) fn name(&self, number: usize) -> &str {
        self.names.get(number).map_or("", String::as_str)
    }

    /// The time of the next sample, s, which must come after the last one.
    ///
    /// # Errors
    /// Why it is none, in words.
    pub(super) fn time(&mut self, t: f64) -> Result<f64, String> {
        if t.is_finite() && t > self.last_s {
            self.last_s = t;
            return Ok(t);
        }
        let after = if self.last_s.is_finite() { format!("t = {:?} s", self.last_s) } else { "nothing".to_owned() };
        Err(format!("t = {t:?} s does not follow the time before it, {after}: times must be finite and ascend"))
    }

    /// The number of a body of this name.
    ///
    /// # Errors
    /// That there is none, in words.
    pub(super) fn body(&self, name: &str) -> Result<usize, String> {
        self.number_of.get(name).copied().ok_or_else(|| {
            let known: Vec<_> = self.names.iter().take(MOST_NAMES).map(|name| format!("`{name}`")).collect();
            let more = if self.names.len() > MOST_NAMES { ", ..." } else { "" };
            let list = known.join(", ");
            format!("scene `{}` has no body `{name}`; its bodies are {list}{more}: is it another scene's?", self.scene)
        })
    }

    /// The state of a body from the numbers `px` to `wz`.
    ///
    /// # Errors
    /// Why they are none, in words.
    pub(super) fn state(&self, number: usize, numbers: [f64; NUMBERS]) -> Result<BodySample, String> {
        let name = self.name(number);
        if let Some(place) = numbers.iter().position(|number| !number.is_finite()) {
            let column = COLUMNS[FIRST_NUMBER + place];
            return Err(format!("column {column} of body `{name}` is {}: it must be finite", numbers[place]));
        }
        let [px, py, pz, qw, qx, qy, qz, vx, vy, vz, wx, wy, wz] = numbers;
        let rotation = Rotation::from_wxyz([qw, qx, qy, qz]).map_err(|error| format!("body `{name}`: {error}"))?;
        let velocity = Velocity { linear: DVec3::new(vx, vy, vz), angular: DVec3::new(wx, wy, wz) };
        Ok(BodySample { pose: Pose::new(rotation, DVec3::new(px, py, pz)), velocity })
    }
}

/// A sample.
#[derive(Debug)]
pub(super) struct Sample {
    /// When it was taken, s.
    pub(super) t_s: f64,
    /// All bodies in the order of the scene.
    pub(super) bodies: Vec<BodySample>,
    /// Their estimated errors; none where one of them is not known.
    pub(super) errors: Option<Vec<BodyError>>,
}

/// What an error says of a file that ends too early.
pub(super) const CUT_OFF: &str = "the file is cut off: write it again";

//! The trajectory, in memory; velocities from differences of poses where it has none.
//!
//! | symbol | is |
//! |---|---|
//! | `v_i` | slope at `t_i` of the parabola through three samples, m/s |
//! | its error | `h^2 x'''/6`, a sixth of the second difference of `v`, twice as much at the ends |

use super::error::JudgeError;
use polhode::spatial::{DVec3, MassProperties, Velocity};
use polhode::{BodySample, Scene};
use polhode_scene::TrajectoryReader;
use polhode_scene::trajectory::Velocities;
use std::path::Path;

/// Where velocities come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum VelocitySource {
    /// They are given.
    Given,
    /// Differences of poses.
    Differences,
}

impl VelocitySource {
    /// In words.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Given => "as given",
            Self::Differences => "from differences of the poses",
        }
    }
}

/// A trajectory: samples of all bodies of a scene.
#[derive(Debug, Clone)]
pub struct Given {
    /// What it is called.
    pub name: String,
    /// s, ascending.
    pub times_s: Vec<f64>,
    /// All bodies, in the order of the scene.
    pub samples: Vec<Vec<BodySample>>,
    /// Where velocities come from.
    pub velocities: VelocitySource,
    /// What differences leave unknown of velocities, for each sample and body, m/s; empty where they are given.
    pub(super) errors: Vec<Vec<f64>>,
    /// Where the file is cut off, in words.
    pub cut_off: Option<String>,
}

impl Given {
    /// Reads a file.
    ///
    /// # Errors
    /// When it cannot be read, is not of the scene, or has one sample.
    pub fn read(path: &Path, scene: &Scene) -> Result<Self, JudgeError> {
        let mut reader = TrajectoryReader::open_with(path, scene, Velocities::MayBeAbsent)?;
        let (mut times_s, mut samples) = (Vec::new(), Vec::new());
        while let Some((t_s, bodies)) = reader.next_sample()? {
            times_s.push(t_s);
            samples.push(bodies);
        }
        let name = path.display().to_string();
        let velocities = if reader.has_velocities() { VelocitySource::Given } else { VelocitySource::Differences };
        let cut_off = reader.cut_off().map(ToString::to_string);
        Self { name, times_s, samples, velocities, errors: Vec::new(), cut_off }.completed(scene)
    }

    /// A trajectory in memory: samples of all bodies of the scene, in its order.
    ///
    /// # Errors
    /// When there is one sample.
    pub fn new(
        name: impl Into<String>,
        scene: &Scene,
        samples: impl IntoIterator<Item = (f64, Vec<BodySample>)>,
        velocities: VelocitySource,
    ) -> Result<Self, JudgeError> {
        let (times_s, samples) = samples.into_iter().unzip();
        let (name, errors, cut_off) = (name.into(), Vec::new(), None);
        Self { name, times_s, samples, velocities, errors, cut_off }.completed(scene)
    }

    fn completed(mut self, scene: &Scene) -> Result<Self, JudgeError> {
        if self.times_s.len() < 2 {
            return Err(JudgeError::OneSample(self.name));
        }
        if self.velocities == VelocitySource::Differences {
            for (body, own) in scene.bodies().iter().enumerate() {
                let center = own.mass_properties().map_or(DVec3::ZERO, MassProperties::center_of_mass);
                let velocities: Vec<Velocity> =
                    (0..self.times_s.len()).map(|place| self.slope(place, body, center)).collect();
                self.samples.iter_mut().zip(velocities).for_each(|(row, velocity)| row[body].velocity = velocity);
            }
            self.errors = (0..self.times_s.len()).map(|place| self.errors_at(scene, place)).collect();
        }
        Ok(self)
    }

    /// The slope of the parabola through three samples; of two the difference.
    fn slope(&self, place: usize, body: usize, center: DVec3) -> Velocity {
        let last = self.times_s.len() - 1;
        let between = |from: usize, to: usize| {
            let h = self.times_s[to] - self.times_s[from];
            let [a, b] = [from, to].map(|place| &self.samples[place][body].pose);
            let turned = b.rotation * a.rotation.inverse();
            let linear = (b.transform_point(center) - a.transform_point(center)) / h;
            (h, Velocity { linear, angular: turned.to_rotation_vector() / h })
        };
        let first = place.clamp(1, last.max(2) - 1) - 1;
        if last < 2 {
            return between(0, 1).1;
        }
        let ((h_1, one), (h_2, two)) = (between(first, first + 1), between(first + 1, first + 2));
        // The slope is linear in time, and one and two are those in the middles of the two intervals.
        let at = self.times_s[place] - (self.times_s[first] + 0.5 * h_1);
        let part = at / (0.5 * (h_1 + h_2));
        let along = |a: DVec3, b: DVec3| a + (b - a) * part;
        Velocity { linear: along(one.linear, two.linear), angular: along(one.angular, two.angular) }
    }

    fn errors_at(&self, scene: &Scene, place: usize) -> Vec<f64> {
        let last = self.times_s.len() - 1;
        let near = place.clamp(1, last.max(2) - 1);
        let at_end = if near == place { 1.0 } else { 2.0 };
        let of_body = |(body, own): (usize, &polhode::Body)| {
            let size = own
                .mass_properties()
                .map_or(0.0, |own| (own.principal_axes().moments().max_element() / own.mass()).sqrt());
            let Some(rows) = self.samples.get(near - 1..=near + 1) else { return f64::INFINITY };
            let [a, b, c] = [0, 1, 2].map(|row: usize| rows[row][body].velocity);
            let second = (a.linear - b.linear * 2.0 + c.linear).length()
                + size * (a.angular - b.angular * 2.0 + c.angular).length();
            at_end * second / 6.0
        };
        scene.bodies().iter().enumerate().map(of_body).collect()
    }

    /// What is not known of a velocity, m/s.
    pub(super) fn velocity_error(&self, place: usize, body: usize) -> f64 {
        self.errors.get(place).and_then(|row| row.get(body)).copied().unwrap_or(0.0)
    }

    /// Intervals that are longer than twice the usual one (the median), s: from and to.
    pub fn gaps(&self) -> Vec<[f64; 2]> {
        let mut lengths: Vec<f64> = self.times_s.windows(2).map(|pair| pair[1] - pair[0]).collect();
        lengths.sort_by(f64::total_cmp);
        let usual = lengths[lengths.len() / 2];
        self.times_s.windows(2).filter(|pair| pair[1] - pair[0] > 2.0 * usual).map(|pair| [pair[0], pair[1]]).collect()
    }
}

//! What the scene says of each sample: energy, loads, what touches, what joints keep.

use super::error::JudgeError;
use super::given::Given;
use polhode::scene::Material;
use polhode::spatial::{DVec3, Pose, Rotation, Velocity};
use polhode::{BodyId, BodySample, Evaluation, HeldState, MovableState, NearPair, Scene, StateEnergy};

/// Rounding of a number that is the result of a few operations (no unit).
pub(super) const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A sample, with what the scene says of it.
#[derive(Debug, Clone)]
pub(super) struct Observed {
    pub(super) t_s: f64,
    pub(super) energy: StateEnergy,
    pub(super) power_w: f64,
    /// By body; none where no force moves it.
    pub(super) movable: Vec<Option<MovableState>>,
    pub(super) near: Vec<NearPair>,
    pub(super) held: Vec<HeldState>,
}

/// The middle of an interval, on the cubics through poses and velocities of its ends.
#[derive(Debug, Clone)]
pub(super) struct Middle {
    pub(super) power_w: f64,
    pub(super) movable: Vec<Option<MovableState>>,
    pub(super) near: Vec<NearPair>,
    pub(super) held: Vec<HeldState>,
}

/// A scene in the states of a trajectory.
pub(super) struct Observer<'a> {
    pub(super) scene: &'a Scene,
    pub(super) given: &'a Given,
    pub(super) tolerance: f64,
    pub(super) evaluation: Evaluation,
}

impl Observer<'_> {
    /// How far bodies come in an interval at most, from rest or from their speeds, relative to the smallest of them.
    pub(super) fn reach(&self, place: usize) -> f64 {
        let times = &self.given.times_s;
        let before = place.checked_sub(1).map(|one| times[place] - times[one]);
        let after = times.get(place + 1).map(|next| next - times[place]);
        let h = before.into_iter().chain(after).fold(0.0, f64::max);
        let rows = place.saturating_sub(1)..(place + 2).min(times.len());
        let (mut fastest, mut smallest) = (0.0_f64, f64::INFINITY);
        for (number, body) in self.scene.bodies().iter().enumerate() {
            let Some(own) = self.evaluation.movable(BodyId::new(number)) else {
                let motion = self.evaluation.prescribed(BodyId::new(number));
                fastest = fastest.max(motion.map_or(0.0, |own| own.velocity.linear.length()));
                continue;
            };
            if body.shape().is_some() {
                smallest = smallest.min(own.size_m);
            }
            for row in rows.clone() {
                let velocity = self.given.samples[row][number].velocity;
                fastest = fastest.max(velocity.linear.length() + velocity.angular.length() * own.size_m);
            }
        }
        let way = 2.0 * fastest * h + 0.5 * self.scene.gravity().length() * h * h;
        if smallest.is_finite() { (way / smallest).max(self.tolerance) } else { self.tolerance }
    }

    /// What the scene says of a sample.
    ///
    /// # Errors
    /// When it cannot be evaluated there.
    pub(super) fn observed(&mut self, place: usize) -> Result<Observed, JudgeError> {
        let t_s = self.given.times_s[place];
        self.evaluation.place(t_s, &self.given.samples[place])?;
        let near = self.evaluation.near(self.reach(place))?;
        let own = &self.evaluation;
        Ok(Observed {
            t_s,
            energy: own.energy(),
            power_w: own.power_w(),
            movable: self.movable(),
            near,
            held: own.held(),
        })
    }

    fn movable(&self) -> Vec<Option<MovableState>> {
        (0..self.scene.bodies().len()).map(|body| self.evaluation.movable(BodyId::new(body))).collect()
    }

    /// The middle of the interval that ends at this sample.
    ///
    /// # Errors
    /// When the scene cannot be evaluated there.
    pub(super) fn middle(&mut self, place: usize) -> Result<Middle, JudgeError> {
        let (from, to) = (self.given.times_s[place - 1], self.given.times_s[place]);
        let rows = [&self.given.samples[place - 1], &self.given.samples[place]];
        let centers: Vec<DVec3> = (self.scene.bodies().iter())
            .map(|body| body.mass_properties().map_or(DVec3::ZERO, polhode::prelude::MassProperties::center_of_mass))
            .collect();
        let states: Vec<BodySample> = (rows[0].iter().zip(rows[1]).zip(&centers))
            .map(|((a, b), center)| between(a, b, to - from, *center))
            .collect();
        self.evaluation.place(0.5 * (from + to), &states)?;
        let near = self.evaluation.near(self.reach(place))?;
        Ok(Middle { power_w: self.evaluation.power_w(), movable: self.movable(), near, held: self.evaluation.held() })
    }

    /// The distance within which two bodies count as touching, m.
    pub(super) fn touch_m(&self, pair: &NearPair) -> f64 {
        self.tolerance * pair.size_m + pair.rounding_m
    }

    /// The materials of two bodies together; without friction and restitution where the scene has none.
    pub(super) fn material(&self, pair: &NearPair) -> Material {
        let [a, b] = pair.bodies;
        self.scene.material_between(a, b).unwrap_or_else(|_| Material::new(""))
    }

    /// The name of a body.
    pub(super) fn name(&self, body: BodyId) -> String {
        self.scene.bodies().get(body.index()).map_or_else(String::new, |body| body.name().to_owned())
    }
}

/// The state in the middle of an interval of this length (s), by cubic polynomials through places and velocities of
/// both ends; rotations by their rotation vector `r` from the first end, `r' = w - r x w/2 + r x (r x w)/12` and back
/// `w = r' + r x r'/2 + r x (r x r')/6`.
fn between(a: &BodySample, b: &BodySample, h: f64, center: DVec3) -> BodySample {
    let [from, to] = [a, b].map(|own| own.pose.transform_point(center));
    let linear = (from + to) * 0.5 + (a.velocity.linear - b.velocity.linear) * (h / 8.0);
    let turn = (b.pose.rotation * a.pose.rotation.inverse()).to_rotation_vector();
    let w = b.velocity.angular;
    let rates = [a.velocity.angular, w - turn.cross(w) * 0.5 + turn.cross(turn.cross(w)) / 12.0];
    let half = turn * 0.5 + (rates[0] - rates[1]) * (h / 8.0);
    let rotation = Rotation::from_rotation_vector(half) * a.pose.rotation;
    let rate = turn * (1.5 / h) - (rates[0] + rates[1]) * 0.25;
    let velocity = Velocity {
        linear: (to - from) * (1.5 / h) - (a.velocity.linear + b.velocity.linear) * 0.25,
        angular: rate + half.cross(rate) * 0.5 + half.cross(half.cross(rate)) / 6.0,
    };
    BodySample { pose: Pose::new(rotation, linear - rotation.rotate(center)), velocity }
}

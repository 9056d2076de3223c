//! The error of a run: how far its bodies are from those of the reference, at the same times.
//!
//! | symbol | is |
//! |---|---|
//! | position | largest distance of a body's origin from the reference's, of the scene's length |
//! | attitude | largest angle between a body's attitude and the reference's, rad |
//! | error | the larger of the two: what a candidate is judged by |
//! | estimated | the error that a run tells of itself, in the measures of position and attitude |
//! | velocity | largest of dv and l dw at the end, of the largest v and l w of the run; l is the body's size |
//! | energy | what the integrator lost or made over smooth stages (`D_numerical`), of the largest energy of the run |
//!
//! The scene's length is the largest distance a body travels, or the largest radius of gyration where that is more.

use polhode::{BodySample, Recorder, RunError, RunReport, Scene};

/// What errors are relative to.
#[derive(Debug, Clone, PartialEq)]
pub struct Scales {
    /// The scene's length, m.
    pub length_m: f64,
    /// What that is.
    pub length_is: &'static str,
    /// The largest speed, m/s: of a centre of mass, or of a point at a body's radius of gyration.
    pub speed_m_s: f64,
    /// Largest angular speed, rad/s.
    pub angular_speed: f64,
    /// Largest angle that a body turns through, rad: its angular speed over the whole run.
    pub angle: f64,
    /// Radius of gyration of every body, m; `None` for those that never move.
    sizes: Vec<Option<f64>>,
}

/// How far a run is from the reference.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Errors {
    /// Of positions over the whole run, relative.
    pub position: f64,
    /// Of attitudes over the whole run, rad.
    pub attitude: f64,
    /// Of positions at the end, relative.
    pub final_position: f64,
    /// Of attitudes at the end, rad.
    pub final_attitude: f64,
    /// Of velocities at the end, relative.
    pub final_velocity: f64,
}

impl Errors {
    /// The number that a candidate is judged by; NaN when one of the two is.
    pub fn headline(&self) -> f64 {
        worst(self.position, self.attitude)
    }
}

/// The larger of two; NaN when one is.
pub fn worst(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// `D_numerical`, relative to the largest energy of the run.
pub fn energy_error(report: &RunReport) -> f64 {
    let lost = report.ledger.numerical.value().abs();
    if lost == 0.0 { 0.0 } else { lost / report.ledger.scale_j }
}

impl Scales {
    /// Of a scene, from its reference trajectory.
    pub fn of(scene: &Scene, reference: &Recorder) -> Self {
        let sizes: Vec<_> = scene.bodies().iter().map(radius_of_gyration).collect();
        let size = sizes.iter().flatten().copied().fold(0.0, f64::max);
        let (mut travelled, mut speed_m_s, mut angular_speed) = (0.0_f64, 0.0_f64, 0.0_f64);
        let mut angles = vec![0.0_f64; sizes.len()];
        let mut before = 0.0;
        for (&t, row) in reference.times_s.iter().zip(&reference.samples) {
            for (body, sample) in movable(&sizes, row) {
                let start = reference.samples[0][body].pose.translation;
                let (v, w) = (sample.velocity.linear.length(), sample.velocity.angular.length());
                travelled = travelled.max((sample.pose.translation - start).length());
                speed_m_s = speed_m_s.max(v).max(w * sizes[body].unwrap_or(0.0));
                angular_speed = angular_speed.max(w);
                angles[body] += w * (t - before);
            }
            before = t;
        }
        let (length_m, length_is) = if travelled > size {
            (travelled, "the largest distance a body travels")
        } else {
            (size, "the largest radius of gyration of a body")
        };
        let angle = angles.into_iter().fold(0.0, f64::max);
        Self { length_m, length_is, speed_m_s, angular_speed, angle, sizes }
    }

    /// The length of the scene in sizes of its smallest body that moves; at least 1.
    pub fn lengths_of_smallest_body(&self) -> f64 {
        let size = self.sizes.iter().flatten().copied().filter(|size| *size > 0.0).fold(f64::INFINITY, f64::min);
        if size.is_finite() { (self.length_m / size).max(1.0) } else { 1.0 }
    }

    /// How far `run` is from `reference`.
    ///
    /// # Errors
    /// When the two are not about the same bodies at the same times.
    pub fn errors(&self, reference: &Recorder, run: &Recorder) -> Result<Errors, String> {
        if reference.times_s != run.times_s {
            let (a, b) = (reference.times_s.len(), run.times_s.len());
            return Err(format!("its {b} samples are not at the times of the reference's {a}"));
        }
        let mut errors = Errors::default();
        for (row, other) in reference.samples.iter().zip(&run.samples) {
            (errors.final_position, errors.final_attitude, errors.final_velocity) = (0.0, 0.0, 0.0);
            for ((body, a), b) in movable(&self.sizes, row).zip(movable(&self.sizes, other).map(|(_, b)| b)) {
                let size = self.sizes[body].unwrap_or(0.0);
                let position = relative((a.pose.translation - b.pose.translation).length(), self.length_m);
                let attitude = a.pose.rotation.angle_to(b.pose.rotation);
                let linear = (a.velocity.linear - b.velocity.linear).length();
                let angular = (a.velocity.angular - b.velocity.angular).length() * size;
                errors.final_position = worst(errors.final_position, position);
                errors.final_attitude = worst(errors.final_attitude, attitude);
                let velocity = relative(worst(linear, angular), self.speed_m_s);
                errors.final_velocity = worst(errors.final_velocity, velocity);
            }
            errors.position = worst(errors.position, errors.final_position);
            errors.attitude = worst(errors.attitude, errors.final_attitude);
        }
        Ok(errors)
    }
}

impl Scales {
    /// The error that a run tells of itself: the largest one of any body, and those at the end. None where it tells
    /// none.
    pub fn estimated(&self, error: &RunError) -> Option<f64> {
        let largest = error.largest?.error;
        let all = std::iter::once(&largest).chain(&error.bodies);
        Some(all.map(|error| worst(relative(error.position_m, self.length_m), error.rotation_rad)).fold(0.0, worst))
    }
}

/// Bodies of a row that can move.
fn movable<'a>(sizes: &'a [Option<f64>], row: &'a [BodySample]) -> impl Iterator<Item = (usize, &'a BodySample)> {
    row.iter().enumerate().filter(|(body, _)| sizes.get(*body).is_some_and(Option::is_some))
}

/// Radius of gyration about the axis of the largest moment, m.
fn radius_of_gyration(body: &polhode::Body) -> Option<f64> {
    let properties = body.mass_properties()?;
    Some((properties.principal_axes().moments().max_element() / properties.mass()).sqrt())
}

/// `value / scale`; zero when nothing differs, whatever the scale.
fn relative(value: f64, scale: f64) -> f64 {
    if value == 0.0 { 0.0 } else { value / scale }
}

#[cfg(test)]
mod tests {
    //! Errors of trajectories that are written down, so that the answer is known.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;
    use polhode::Body;
    use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, Velocity};

    fn scene() -> Scene {
        let inertia = Inertia::from_diagonal(DVec3::new(4.0, 5.0, 8.0)).unwrap();
        let body = Body::movable("a", MassProperties::new(Mass::new(2.0).unwrap(), DVec3::ZERO, inertia));
        Scene::builder("test").body(Body::fixed("floor")).body(body).build().unwrap()
    }

    /// The floor at rest, and a body that travels to x, turned by an angle.
    fn run(x: f64, angle: f64) -> Recorder {
        let rest = BodySample { pose: Pose::IDENTITY, velocity: Velocity::ZERO };
        let turned = Pose { translation: DVec3::X * x, rotation: Rotation::from_rotation_vector(DVec3::Z * angle) };
        let velocity = Velocity { linear: DVec3::X * x, angular: DVec3::ZERO };
        let moved = BodySample { pose: turned, velocity };
        Recorder { times_s: vec![0.0, 1.0], samples: vec![vec![rest, rest], vec![rest, moved]], ..Recorder::default() }
    }

    #[test]
    fn the_scene_s_length_is_what_is_larger() {
        let far = Scales::of(&scene(), &run(10.0, 0.0));
        assert_eq!((far.length_m, far.length_is), (10.0, "the largest distance a body travels"));
        let near = Scales::of(&scene(), &run(1.0, 0.0));
        assert_eq!((near.length_m, near.length_is), (2.0, "the largest radius of gyration of a body"));
    }

    #[test]
    fn errors_are_the_largest_differences() {
        let reference = run(10.0, 1.0);
        let scales = Scales::of(&scene(), &reference);
        let errors = scales.errors(&reference, &run(11.0, 1.25)).unwrap();
        assert!((errors.position - 0.1).abs() < 1e-15 && (errors.attitude - 0.25).abs() < 1e-15);
        assert!((errors.final_velocity - 0.1).abs() < 1e-15);
        assert_eq!(errors.headline(), errors.attitude);
        assert_eq!(scales.errors(&reference, &reference).unwrap(), Errors::default());
    }

    #[test]
    fn what_is_not_a_number_is_the_worst() {
        let reference = run(10.0, 1.0);
        let scales = Scales::of(&scene(), &reference);
        assert!(scales.errors(&reference, &run(f64::NAN, 1.0)).unwrap().headline().is_nan());
        assert!(worst(f64::NAN, 1.0).is_nan() && worst(1.0, f64::NAN).is_nan());
    }

    #[test]
    fn other_times_are_refused() {
        let reference = run(10.0, 1.0);
        let mut run = run(10.0, 1.0);
        run.times_s[1] = 2.0;
        assert!(Scales::of(&scene(), &reference).errors(&reference, &run).is_err());
    }
}

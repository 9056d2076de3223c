//! Time steps under error control, by halving: for a stretch of time in which events crowd.
//!
//! A step of h is compared with two of h/2 from the same state. The largest displacement between the two, relative to the size
//! of each body, estimates the error of the longer one; the two halves are kept. Between changes of contact it is
//! of order h^3 and per second of order h^2; where a contact changes within the step it is of order h, and the step shrinks
//! until it passes, or stands at its floor, where it goes on and says what the error was.

use super::projection::displacement;
use super::report::TimeStepReport;
use super::step::TimeStepper;
use crate::world::World;
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;

/// The next step aims at this fraction of what is allowed.
const SAFETY: f64 = 0.8;

/// A step grows by no more than this factor from one to the next.
const LARGEST_GROWTH: f64 = 4.0;

/// No step is shorter than this fraction of the stretch, whatever the floor: ten million steps end too.
const SHORTEST_RELATIVE: f64 = 1e-7;

/// A step that was refused shrinks at least and at most by these factors.
const SHRINKING: (f64, f64) = (0.1, 0.5);

/// A stretch of time and what is asked of its steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stretch {
    /// From, s.
    pub(crate) t: f64,
    /// To, s.
    pub(crate) end: f64,
    /// The step tried first, and the longest, s.
    pub(crate) first_step_s: f64,
    /// The shortest step: there it goes on whatever the error, s.
    pub(crate) floor_s: f64,
    /// Estimated error per second that is allowed, relative to the size of each body (1/s).
    pub(crate) tolerance: f64,
}

/// What a stretch did.
#[derive(Debug, Clone)]
pub(crate) struct StretchReport {
    /// What its steps did together.
    pub(crate) steps: TimeStepReport,
    /// Sum of the estimated errors of all steps, relative to the size of each body.
    pub(crate) error: f64,
    /// Largest estimated error per second of any step (1/s).
    pub(crate) worst_rate: f64,
    /// Shortest step, s.
    pub(crate) shortest_s: f64,
    /// Steps that went on at the floor with a larger error than allowed.
    pub(crate) at_floor: u64,
    /// The step that would come next, s.
    pub(crate) next_step_s: f64,
}

impl TimeStepper {
    /// Advances by one step of `h` (s) and by two halves, keeps the halves, and estimates the error of the whole: the largest
    /// displacement between the two, relative to the size of the body.
    ///
    /// # Errors
    /// As [`TimeStepper::advance`]; the states are unchanged then.
    pub(crate) fn advance_with_estimate(
        &mut self,
        world: &World,
        states: &mut [BodyState],
        bodies: &[usize],
        pairs: &[(usize, usize)],
        (t, h): (f64, f64),
    ) -> Result<(TimeStepReport, f64), ResponseError> {
        let start: Vec<BodyState> = bodies.iter().map(|&body| states[body]).collect();
        let carried = self.carried.clone();
        self.advance(world, states, bodies, pairs, (t, h)).inspect_err(|_| restore(states, bodies, &start))?;
        let whole: Vec<BodyState> = bodies.iter().map(|&body| states[body]).collect();
        restore(states, bodies, &start);
        self.carried = carried;
        let mut report = self.advance(world, states, bodies, pairs, (t, 0.5 * h));
        if let Ok(first) = &mut report {
            let second = self.advance(world, states, bodies, pairs, (t + 0.5 * h, 0.5 * h));
            let second = second.inspect_err(|_| restore(states, bodies, &start))?;
            first.append(second);
        }
        let report = report.inspect_err(|_| restore(states, bodies, &start))?;
        let error = |(&body, whole): (&usize, &BodyState)| {
            let apart = displacement(world, body, whole, &states[body]);
            let size = world.bodies[body].size;
            if size > 0.0 { apart / size } else { apart }
        };
        let estimate = bodies.iter().zip(&whole).map(error).fold(0.0, f64::max);
        Ok((report, estimate))
    }

    /// Advances over a stretch by such steps, each as long as the tolerance allows. `pairs` are all that may touch within the
    /// whole stretch.
    ///
    /// # Errors
    /// As [`TimeStepper::advance`]; the states are those that had been reached.
    pub(crate) fn stretch(
        &mut self,
        world: &World,
        states: &mut [BodyState],
        bodies: &[usize],
        pairs: &[(usize, usize)],
        stretch: &Stretch,
    ) -> Result<StretchReport, ResponseError> {
        // Two steps that both lose a bounce agree: bounces that are higher than what is allowed must be followed.
        self.unseen_bounce = stretch.tolerance;
        let report = self.controlled(world, states, bodies, pairs, stretch);
        self.unseen_bounce = f64::INFINITY;
        report
    }

    fn controlled(
        &mut self,
        world: &World,
        states: &mut [BodyState],
        bodies: &[usize],
        pairs: &[(usize, usize)],
        stretch: &Stretch,
    ) -> Result<StretchReport, ResponseError> {
        let mut report = StretchReport {
            steps: TimeStepReport::new(self.about),
            error: 0.0,
            worst_rate: 0.0,
            shortest_s: f64::INFINITY,
            at_floor: 0,
            next_step_s: stretch.first_step_s,
        };
        let floor = stretch.floor_s.max(SHORTEST_RELATIVE * (stretch.end - stretch.t));
        let mut t = stretch.t;
        let mut h = stretch.first_step_s.max(floor);
        while t < stretch.end {
            let left = stretch.end - t;
            // A sliver at the end would be a step of its own.
            let length = if h >= left - floor { left } else { h };
            let start: Vec<BodyState> = bodies.iter().map(|&body| states[body]).collect();
            let carried = self.carried.clone();
            let (made, error) = self.advance_with_estimate(world, states, bodies, pairs, (t, length))?;
            let allowed = stretch.tolerance * length;
            let is_small = error <= allowed;
            let ratio = if error > 0.0 { SAFETY * (allowed / error).sqrt() } else { LARGEST_GROWTH };
            // At the floor the last step, which takes the sliver with it, is accepted too.
            if !is_small && h > floor && length > floor {
                restore(states, bodies, &start);
                self.carried = carried;
                h = (length * ratio.clamp(SHRINKING.0, SHRINKING.1)).max(floor);
                continue;
            }
            report.at_floor += u64::from(!is_small);
            report.steps.append(made);
            report.error += error;
            report.worst_rate = report.worst_rate.max(error / length);
            report.shortest_s = report.shortest_s.min(length);
            t = if length >= left { stretch.end } else { t + length };
            // A last step that was cut short says nothing against the step that was meant.
            let grown = (length * ratio.clamp(SHRINKING.1, LARGEST_GROWTH)).max(floor);
            h = if length < h { h.max(grown) } else { grown }.min(stretch.first_step_s.max(floor));
        }
        report.next_step_s = h;
        Ok(report)
    }
}

fn restore(states: &mut [BodyState], bodies: &[usize], saved: &[BodyState]) {
    for (&body, state) in bodies.iter().zip(saved) {
        states[body] = *state;
    }
}

#[cfg(test)]
mod tests {
    //! Stretches keep their tolerance where the motion lets them, and always get through.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::{Stretch, StretchReport};
    use crate::scene::{ImpactLaw, Material};
    use crate::time_stepping::TimeStepper;
    use crate::world::World;
    use crate::{Body, Scene};
    use polhode_contact::Shape;
    use polhode_dynamics::BodyState;
    use polhode_spatial::{DVec3, Inertia, Mass, MassProperties, Pose, UnitVector, Velocity};

    const STRETCH: Stretch = Stretch { t: 0.0, end: 0.5, first_step_s: 1e-3, floor_s: 1e-7, tolerance: 1e-6 };

    fn ball(name: &str, radius: f64, place: DVec3, velocity: DVec3) -> Body {
        let inertia = Inertia::from_diagonal(DVec3::splat(0.4 * radius * radius)).unwrap();
        Body::movable(name, MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia))
            .geometry(Shape::sphere(radius).unwrap().into())
            .pose(Pose::from_translation(place))
            .velocity(Velocity::new(velocity, DVec3::ZERO))
            .material(Material::new("m", 0.0, 0.5).unwrap())
    }

    fn plane(name: &str, normal: DVec3) -> Body {
        Body::fixed(name).geometry(Shape::half_space(UnitVector::new(normal).unwrap()).into())
    }

    fn go(scene: &Scene, stretch: &Stretch) -> (World, Vec<BodyState>, StretchReport) {
        let (world, mut states) = World::new(scene).unwrap();
        let pairs: Vec<_> = scene.colliding_pairs().collect();
        let mut stepper = TimeStepper::new(ImpactLaw::Reflection, DVec3::ZERO, 4);
        let report = stepper.stretch(&world, &mut states, &world.movable, &pairs, stretch).unwrap();
        (world, states, report)
    }

    /// A ball that slides down a dome: the estimate is an estimate of what the stretch is wrong by, and both are within
    /// what was asked.
    #[test]
    fn sliding_ball_keeps_the_tolerance() {
        let dome = Body::fixed("dome").geometry(Shape::sphere(1.0).unwrap().into());
        let start = DVec3::new(0.3_f64.sin(), 0.0, 0.3_f64.cos()) * 1.1;
        let scene = Scene::builder("dome").body(dome).body(ball("ball", 0.1, start, DVec3::ZERO)).build().unwrap();
        let stretch = Stretch { end: 0.3, ..STRETCH };
        let (_, states, report) = go(&scene, &stretch);
        let fine = go(&scene, &Stretch { tolerance: 1e-8, ..stretch }).1;
        let error = (states[1].pose.translation - fine[1].pose.translation).length() / 0.2;
        assert!(error < 1e-6 && report.error <= 1e-6 * 0.3 && report.at_floor == 0, "{error:e} {report:?}");
    }

    /// A ball whose bounces accumulate in a corner of two planes at once comes to rest in it, in few steps, touching both.
    #[test]
    fn bounces_that_accumulate_in_a_corner_end() {
        let sides = [DVec3::new(1.0, 0.0, 1.3), DVec3::new(-0.7, 0.0, 1.0)];
        let scene = Scene::builder("corner").body(plane("a", sides[0])).body(plane("b", sides[1]));
        let scene = scene.body(ball("ball", 0.1, DVec3::new(0.02, 0.0, 0.3), DVec3::ZERO)).build().unwrap();
        let (world, states, report) = go(&scene, &Stretch { end: 1.5, ..STRETCH });
        let apart = |plane: usize| world.pair(&states, plane, 2, 1.0).0;
        assert!(apart(0).abs() < 1e-12 && apart(1).abs() < 1e-12, "{:e} {:e}", apart(0), apart(1));
        assert!(states[2].linear_velocity.length() < 1e-9, "{:?}", states[2]);
        assert!(report.steps.steps < 1_000_000 && report.steps.left_penetration_m < 1e-12, "{report:?}");
    }

    /// Bounces higher than what is allowed are followed, however long the step: a ball is where the closed form has it.
    #[test]
    fn bounces_are_not_lost_to_long_steps() {
        let scene = Scene::builder("bounce").body(plane("floor", DVec3::Z));
        let scene = scene.body(ball("ball", 0.1, DVec3::Z * 0.15, DVec3::ZERO)).build().unwrap();
        let fall = (2.0 * 0.05 / 9.81_f64).sqrt();
        // The third bounce, of eight times less speed.
        let (speed, start) = (9.81 * fall / 8.0, fall * 2.5);
        let s = 0.2 * fall;
        let (_, states, report) = go(&scene, &Stretch { end: start + s, first_step_s: 0.02, ..STRETCH });
        let height = 0.1 + speed * s - 0.5 * 9.81 * s * s;
        let error = (states[1].pose.translation.z - height) / 0.2;
        assert!(error.abs() < 1e-6, "{error:e} {report:?}");
    }

    /// At its floor a stretch goes on, and says how wrong it was.
    #[test]
    fn floor_is_passed_and_reported() {
        let scene = Scene::builder("floor").body(plane("floor", DVec3::Z));
        let scene = scene.body(ball("ball", 0.1, DVec3::Z * 0.2, DVec3::X)).build().unwrap();
        let stretch = Stretch { floor_s: 1e-3, tolerance: 1e-15, ..STRETCH };
        let (_, states, report) = go(&scene, &stretch);
        assert!(report.at_floor > 0 && report.worst_rate > 1e-15 && report.steps.steps <= 6000, "{report:?}");
        assert!(states[1].is_finite());
    }
}

//! How far bodies are from a run of the scene, and how well that is known.

use super::given::Given;
use polhode::{ErrorEstimation, Scene, Simulation};
use polhode_scene::{Override, names};

/// The change that makes a scene its truth: the most accurate methods, with the impact law that it names.
pub fn truth_of(scene: &Scene) -> Override {
    let impact = scene.method().impact;
    let law = impact.map_or_else(String::new, |law| format!(", impact = \"{}\"", names::impact(law)));
    Override::new("judge", "method", format!("{{ tier = \"accurate\"{law} }}"))
}

/// How far bodies are from the truth at a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TruthAt {
    /// s.
    pub t_s: f64,
    /// The largest distance of a body, and of the angle times its size, m.
    pub distance_m: f64,
    /// What the run tells of its own error there, m; none where it tells none.
    pub error_m: Option<f64>,
    /// Which body, by its number.
    pub body: usize,
}

/// The distance from a run of the scene over time.
#[derive(Debug, Clone, PartialEq)]
pub struct Truth {
    /// By sample.
    pub over_time: Vec<TruthAt>,
    /// Why it ends before the trajectory, where it does.
    pub ended: Option<String>,
}

impl Truth {
    /// Runs `scene`, which is the scene with the method of the truth, to the times of a trajectory; `sizes` of the
    /// bodies in m.
    pub(super) fn of(scene: &Scene, given: &Given, sizes: &[f64]) -> Self {
        let mut truth = Self { over_time: Vec::new(), ended: None };
        truth.ended = truth.run(scene, given, sizes).err();
        truth
    }

    fn run(&mut self, scene: &Scene, given: &Given, sizes: &[f64]) -> Result<(), String> {
        let told = |error: polhode::SimulationError| error.to_string();
        let mut simulation = Simulation::new(scene).map_err(told)?.estimating(ErrorEstimation::Quick);
        for (&t_s, samples) in given.times_s.iter().zip(&given.samples) {
            if t_s < 0.0 {
                return Err(format!("the trajectory begins at t = {t_s} s, before the scene"));
            }
            simulation.advance_to(t_s).map_err(told)?;
            let errors = simulation.error().bodies;
            let of_body = |(body, (own, truth)): (usize, (&polhode::BodySample, &polhode::BodySample))| {
                let size = sizes[body];
                let apart = (own.pose.translation - truth.pose.translation).length();
                let turned = own.pose.rotation.angle_to(truth.pose.rotation);
                let error = errors.get(body).map(|error| error.position_m + error.rotation_rad * size);
                TruthAt { t_s, distance_m: apart + turned * size, error_m: error, body }
            };
            let bodies = simulation.bodies();
            let all = samples.iter().zip(&bodies).enumerate().map(of_body);
            let beyond = |own: &TruthAt| own.distance_m - own.error_m.unwrap_or(0.0);
            self.over_time.extend(all.max_by(|a, b| beyond(a).total_cmp(&beyond(b))));
        }
        Ok(())
    }
}

//! The true motion of a scene at the samples of its runs, and how well it is known.

use super::distance::{Sizes, places};
use super::known::{Copy, Known, Place, Truth};
use super::setting::{Standard, for_so_long, sampled, tightest};
use super::trial::{NoTrial, Trial};
use polhode::scene::ImpactLaw;
use polhode::spatial::Pose;
use polhode::{ErrorEstimation, Scene};
use std::error::Error;

/// The true motion at samples.
#[derive(Debug)]
pub(super) struct TrueMotion {
    /// The places of bodies at each sample.
    pub(super) places: Vec<Vec<Place>>,
    /// The largest distance so far of two runs that both stand for the truth, of a body's size; zero for what is known.
    pub(super) uncertainty: Vec<f64>,
}

/// Why the truth is not known.
#[derive(Debug, Clone)]
pub(super) struct Unknown(pub(super) String);

impl TrueMotion {
    /// Of a scene (as it is compared) by a law of impacts, at these times (s).
    ///
    /// # Errors
    /// When the truth does not run.
    pub(super) fn of(known: &Known, scene: &Scene, law: ImpactLaw, times_s: &[f64]) -> Result<Self, Unknown> {
        let exact = |places: Vec<Vec<Place>>| {
            let uncertainty = vec![0.0; places.len()];
            Self { places, uncertainty }
        };
        match &known.truth {
            Truth::Motion(motion) => Ok(exact(times_s.iter().map(|&t| motion(t)).collect())),
            Truth::Still => {
                let start: Vec<Pose> = scene.bodies().iter().map(|body| *body.initial_pose()).collect();
                Ok(exact(vec![places(&start); times_s.len()]))
            }
            Truth::Run(copy) => Self::of_runs(scene, copy.as_ref(), law),
        }
    }

    /// From a run at the tightest, and one beside it: of a copy where there is one, by other steps everywhere.
    fn of_runs(scene: &Scene, copy: Option<&Copy>, law: ImpactLaw) -> Result<Self, Unknown> {
        let truth = standard(scene, law, Standard::Truth)?;
        let beside = match copy {
            None => standard(scene, law, Standard::Beside)?.rows,
            Some(copy) => {
                let placed = copied(copy, scene).map_err(|error| Unknown(format!("its copy: {error}")))?;
                let mut rows = standard(&placed, law, Standard::Beside)?.rows;
                for row in &mut rows {
                    (copy.undone)(row);
                }
                rows
            }
        };
        let sizes = Sizes::of(scene);
        let mut most = 0.0f64;
        let uncertainty = truth.rows.iter().zip(&beside).map(|(a, b)| {
            most = most.max(sizes.between(a, b));
            most
        });
        let uncertainty = uncertainty.collect();
        Ok(Self { places: truth.rows.iter().map(|row| places(row)).collect(), uncertainty })
    }
}

/// The copy of a scene, for as long.
fn copied(copy: &Copy, scene: &Scene) -> Result<Scene, Box<dyn Error>> {
    sampled(for_so_long((copy.scene)()?, scene.duration_s())?)
}

/// A run that stands for the truth.
fn standard(scene: &Scene, law: ImpactLaw, standard: Standard) -> Result<Trial, Unknown> {
    Trial::of(&tightest(scene, law, standard), ErrorEstimation::Off).map_err(|why| {
        Unknown(match why {
            NoTrial::Refused(why) => format!("accurate does not take it: {why}"),
            NoTrial::Failed(why) => format!("accurate at its tightest fails: {why}"),
            NoTrial::Late => "accurate at its tightest takes very many steps".to_owned(),
        })
    })
}

//! Other ways to the mass properties, set beside the exact result.

use crate::failure::Failure;
use crate::mesh_args::MeshArgs;
use crate::progress::Progress;
use crate::text;
use polhode::mesh::{
    Amount, Estimate, MonteCarlo, MonteCarloEstimate, PointLocator, ReferencePointCost, SolidMesh, TriangleMesh,
    compare_reference_points, compare_reference_points_hollow, solid_mass_properties,
};
use polhode::spatial::MassProperties;
use serde_json::{Value, json};
use std::cell::Cell;
use std::time::Instant;

/// Points between two counts of progress.
const MILLION: u64 = 1_000_000;

/// What was asked for beside the report.
#[derive(Default)]
pub(super) struct Studies {
    reference_points: Option<Vec<ReferencePointCost>>,
    monte_carlo: Option<MonteCarloStudy>,
}

/// An estimate beside the exact result.
struct MonteCarloStudy {
    estimate: MonteCarloEstimate,
    volume_m3: f64,
    exact: MassProperties,
    /// Times of the estimate and of the exact integrals, s.
    times_s: [f64; 2],
}

impl MonteCarloStudy {
    fn of(points: MonteCarlo, mesh: TriangleMesh, amount: Amount, progress: &Progress) -> Result<Self, Failure> {
        let solid = SolidMesh::new(mesh)?;
        let start = Instant::now();
        let estimate = estimate(&solid, points, amount, progress)?;
        let estimate_s = start.elapsed().as_secs_f64();
        let start = Instant::now();
        let volume_m3 = polhode::mesh::VolumeIntegrals::of(solid.mesh()).volume;
        let exact_s = start.elapsed().as_secs_f64();
        let exact = solid_mass_properties(&solid, amount)?;
        Ok(Self { estimate, volume_m3, exact, times_s: [estimate_s, exact_s] })
    }

    fn to_json(&self) -> Value {
        let number = |estimate: &Estimate| json!({"value": estimate.value, "standard_error": estimate.standard_error});
        let numbers = |estimates: &[Estimate]| estimates.iter().map(number).collect::<Vec<_>>();
        json!({
            "samples": self.estimate.samples,
            "inside": self.estimate.inside,
            "wall_s": self.times_s[0],
            "exact_wall_s": self.times_s[1],
            "volume_m3": number(&self.estimate.volume),
            "mass_kg": number(&self.estimate.mass),
            "center_of_mass_m": numbers(&self.estimate.center_of_mass),
            "inertia_xx_yy_zz_yz_xz_xy_kg_m2": numbers(&self.estimate.inertia),
        })
    }
}

/// The estimate, with progress in millions of points.
fn estimate(
    solid: &SolidMesh,
    points: MonteCarlo,
    amount: Amount,
    progress: &Progress,
) -> Result<MonteCarloEstimate, Failure> {
    progress.phase("millions of Monte Carlo points", points.samples().div_ceil(MILLION) as usize);
    let (locator, drawn) = (PointLocator::new(solid), Cell::new(0_u64));
    let contains = |point| {
        drawn.set(drawn.get() + 1);
        if drawn.get() % MILLION == 0 {
            progress.part_done();
        }
        locator.contains(point)
    };
    Ok(points.estimate_region(solid.mesh().bounds(), contains, amount)?)
}

impl Studies {
    pub(super) fn of(
        args: &MeshArgs,
        mesh: &TriangleMesh,
        amount: Amount,
        progress: &Progress,
    ) -> Result<Self, Failure> {
        let compare = if args.hollow { compare_reference_points_hollow } else { compare_reference_points };
        let reference_points = args.studies.compare_reference_points.then(|| compare(mesh));
        let monte_carlo = args
            .studies
            .monte_carlo
            .map(|samples| {
                let points = MonteCarlo::new(samples, args.studies.seed)?;
                MonteCarloStudy::of(points, mesh.clone(), amount, progress)
            })
            .transpose()?;
        Ok(Self { reference_points, monte_carlo })
    }

    pub(super) fn add_to_json(&self, value: &mut Value) {
        if let Some(costs) = &self.reference_points {
            let cost = |cost: &ReferencePointCost| {
                json!({
                    "reference": cost.reference.name(),
                    "measure": cost.measure,
                    "measure_error": cost.measure_error,
                    "centroid_m": cost.centroid.to_array(),
                    "centroid_error_m": cost.centroid_error_m,
                    "second_moment_error": cost.second_moment_error,
                })
            };
            value["reference_points"] = costs.iter().map(cost).collect();
        }
        if let Some(study) = &self.monte_carlo {
            value["monte_carlo"] = study.to_json();
        }
    }

    pub(super) fn text(&self, args: &MeshArgs) -> String {
        let mut page = String::new();
        if let Some(costs) = &self.reference_points {
            page.push('\n');
            page.push_str(&text::reference_points(costs, if args.hollow { "area, m^2" } else { "volume, m^3" }));
        }
        if let Some(study) = &self.monte_carlo {
            page.push('\n');
            page.push_str(&text::monte_carlo(&study.estimate, study.volume_m3, &study.exact, study.times_s));
        }
        page
    }
}

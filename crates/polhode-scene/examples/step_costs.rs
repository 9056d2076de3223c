//! What the steps of a scene cost: times and factorisations, as distributions.
//!
//! `cargo run --release -p polhode-scene --example step_costs -- SCENE...` prints for each scene file the time of a
//! step (median, 99 % of them, largest), the factorisations of a step (the same), the largest residual, and the time of
//! the first step, which starts from nothing.

use polhode::{ErrorEstimation, Simulation};
use polhode_scene::load;
use std::error::Error;
use std::path::Path;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "scene,bodies,steps,prepared_s,first_s,median_s,most_of_99_s,largest_s,\
         first,median,most_of_99,largest,residual,end"
    );
    for path in std::env::args().skip(1) {
        measure(Path::new(&path))?;
    }
    Ok(())
}

fn measure(path: &Path) -> Result<(), Box<dyn Error>> {
    let scene = load(path)?;
    let begun = Instant::now();
    let mut simulation = Simulation::new(&scene)?.estimating(ErrorEstimation::Off);
    let prepared = begun.elapsed().as_secs_f64();
    let (mut times, mut counts) = (Vec::new(), Vec::new());
    let mut last = 0;
    let end = loop {
        if simulation.time() >= scene.duration_s() {
            break "completed".to_owned();
        }
        let begun = Instant::now();
        if let Err(error) = simulation.step() {
            break error.to_string();
        }
        times.push(begun.elapsed().as_secs_f64());
        let so_far = simulation.frame().certificate.factorisations;
        counts.push((so_far - last) as f64);
        last = so_far;
    };
    let residual = simulation.frame().certificate.max_residual;
    let first = |values: &[f64]| values.first().copied().unwrap_or(f64::NAN);
    let (first_time, first_count) = (first(&times), first(&counts));
    let [times, counts] = [times, counts].map(sorted);
    let at = |values: &[f64], part: f64| {
        let place = (part * values.len().saturating_sub(1) as f64) as usize;
        values.get(place).copied().unwrap_or(f64::NAN)
    };
    println!(
        "{},{},{},{prepared:.4},{first_time:.4},{:.4},{:.4},{:.4},{first_count},{},{},{},{residual:.1e},{end}",
        path.display(),
        scene.bodies().len(),
        times.len(),
        at(&times, 0.5),
        at(&times, 0.99),
        at(&times, 1.0),
        at(&counts, 0.5),
        at(&counts, 0.99),
        at(&counts, 1.0),
    );
    Ok(())
}

fn sorted(mut values: Vec<f64>) -> Vec<f64> {
    values.sort_by(f64::total_cmp);
    values
}

//! `cargo xtask tier-costs`: the processor time of heaps in the tiers, and the fit from which the plan estimates it.
//!
//! Balls and boxes fall into a bin from random places, with friction 0.5 and without, in more and more. Printed are the
//! time of a simulated second (s) in tier `accurate` and in tier `stepped`, and of tier `accurate` the constants of
//! `T = C r^p` by least squares of the logarithms, with the rows of contacts `r` that the plan counts
//! (`crates/polhode/src/tier/choice.rs`). A run that takes longer than `--limit` is stopped, and its time is that of
//! the part that it has done, over the time simulated.
//!
//! Failure: times are those of this machine while nothing else runs on it.

use clap::Args;
use polhode::{BodySample, ErrorEstimation, Flow, Observer, Simulation};
use std::error::Error;
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Contacts that the plan counts for a ball and for a box, and rows of one with friction.
const CONTACTS: [(&str, f64); 2] = [("sphere", 3.0), ("box", 6.0)];
const ROWS_WITH_FRICTION: f64 = 3.0;

/// Edge of the cube that each body of a drop has to itself, m: a box of 0.2 m in any attitude, and some air.
const CELL_M: f64 = 0.45;

/// Numbers of bodies and longest time of a run.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Numbers of bodies.
    #[arg(long, value_delimiter = ',', default_values_t = [5, 10, 20, 40])]
    bodies: Vec<u32>,
    /// Longest time of a run, s.
    #[arg(long, default_value_t = 60.0)]
    limit: f64,
}

/// Stops a run at a time of the clock.
struct Limited {
    end: Instant,
    reached_s: f64,
}

impl Observer for Limited {
    fn sample(&mut self, _t_s: f64, _bodies: &[BodySample]) {}

    fn wants_samples(&self) -> bool {
        false
    }

    fn progress(&mut self, t_s: f64) -> Flow {
        self.reached_s = t_s;
        if Instant::now() < self.end { Flow::Continue } else { Flow::Stop }
    }
}

/// One point of the fit.
pub(crate) struct Measured {
    /// Rows, or what else the time grows with.
    pub(crate) rows: f64,
    /// Time, s.
    pub(crate) seconds: f64,
}

/// Measures and prints.
pub(crate) fn run(options: &Options) -> Result<ExitCode, Box<dyn Error>> {
    println!(
        "{:>6}  {:7} {:>8} {:>6} {:>12} {:>12}",
        "bodies", "shape", "friction", "rows", "accurate, s", "stepped, s"
    );
    let mut measured = Vec::new();
    for &bodies in &options.bodies {
        for (shape, contacts) in CONTACTS {
            for friction in [0.0, 0.5] {
                let each = if friction > 0.0 { ROWS_WITH_FRICTION } else { 1.0 };
                let rows = f64::from(bodies) * contacts * each;
                let text = heap(shape, bodies, friction);
                let seconds = |tier| seconds_of(&text, tier, options.limit);
                let (accurate, stepped) = (seconds("accurate")?, seconds("stepped")?);
                println!("{bodies:>6}  {shape:7} {friction:>8} {rows:>6} {accurate:>12.3} {stepped:>12.3}");
                measured.push(Measured { rows, seconds: accurate });
            }
        }
    }
    let (factor, power) = fit(&measured);
    println!("accurate: T = {factor:.2e} r^{power:.2} for each simulated second");
    Ok(ExitCode::SUCCESS)
}

/// `C` and `p` of `T = C r^p` by least squares of the logarithms.
pub(crate) fn fit(measured: &[Measured]) -> (f64, f64) {
    let count = measured.len() as f64;
    let points: Vec<(f64, f64)> = measured.iter().map(|one| (one.rows.ln(), one.seconds.ln())).collect();
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let slope = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum::<f64>()
        / points.iter().map(|point| (point.0 - x) * (point.0 - x)).sum::<f64>();
    ((y - slope * x).exp(), slope)
}

/// Time of a simulated second, s.
fn seconds_of(text: &str, tier: &str, limit: f64) -> Result<f64, Box<dyn Error>> {
    let scene = polhode_scene::load_text("heap", &format!("method.tier = \"{tier}\"\n{text}"), &[])?.scene;
    let mut simulation = Simulation::new(&scene)?.estimating(ErrorEstimation::Off);
    let start = Instant::now();
    let mut limited = Limited { end: start + Duration::from_secs_f64(limit), reached_s: 0.0 };
    simulation.run_observed(&mut limited)?;
    Ok(start.elapsed().as_secs_f64() / limited.reached_s.max(f64::MIN_POSITIVE))
}

/// The text of a scene of bodies that fall into a bin, for a second.
fn heap(shape: &str, bodies: u32, friction: f64) -> String {
    let width = CELL_M * (f64::from(bodies) / 2.0).cbrt().max(1.0);
    let height = f64::from(bodies) * CELL_M.powi(3) / (width * width) * 1.05 + 0.5;
    let shape = if shape == "box" { "shape.box.size = [0.2, 0.2, 0.2]" } else { "shape.sphere.radius = 0.1" };
    let plane = |name: &str, normal: [i32; 3], position: [f64; 3]| {
        format!(
            "[[bodies]]\nname = \"{name}\"\nfixed = true\nshape.half_space.normal = {normal:?}\n\
             position = {position:?}\nmaterial = \"m\"\n"
        )
    };
    let walls = [
        plane("floor", [0, 0, 1], [0.0; 3]),
        plane("left", [1, 0, 0], [0.0; 3]),
        plane("right", [-1, 0, 0], [width, 0.0, 0.0]),
        plane("front", [0, 1, 0], [0.0; 3]),
        plane("back", [0, -1, 0], [0.0, width, 0.0]),
    ];
    format!(
        "format = 1\nname = \"heap\"\nduration = 1.0\n[materials.m]\nfriction = {friction:?}\nrestitution = 0.2\n{}\
         [[arrays]]\nname = \"body\"\n{shape}\ndensity = 1000\nposition = [0, 0, 0.05]\nmaterial = \"m\"\n\
         layout.drop = {{ count = {bodies}, size = [{width:.3}, {width:.3}, {height:.3}], seed = 1 }}\n",
        walls.concat()
    )
}

#[cfg(test)]
mod tests {
    //! The fit of a power law is that law.
    use super::*;

    #[test]
    fn a_power_law_is_found_again() {
        let law = |rows: f64| Measured { rows, seconds: 0.003 * rows.powf(1.5) };
        let (factor, power) = fit(&[10.0, 40.0, 90.0, 700.0].map(law));
        assert!((factor / 0.003 - 1.0).abs() < 1e-12 && (power - 1.5).abs() < 1e-12, "{factor} {power}");
    }
}

//! `cargo xtask chain-costs`: the time of a step of chains, against their length.
//!
//! Rods hang from the world and from each other by hinges or ball joints, deflected and at rest at first. Printed is
//! the time of a step for each length and tier, and the exponent `p` of `T = C n^p`: between each length and the one
//! before, and by least squares over all of them. The tier `accurate` makes the steps that its error control asks for,
//! at most of that length: the longer a chain the more, since its upper links are taut and swing faster. The time is
//! that of one of them, with all stages of the integrator.
//!
//! The time is the least one of some runs of as many steps, so that what else runs on the machine counts little. A
//! length whose first run takes longer than `--limit` is the last one of its tier.
//!
//! Failure: times are those of this machine; long chains leave its caches, which raises the exponent of times above
//! that of the work.

use crate::tier_costs::{Measured, fit};
use clap::Args;
use polhode::{ErrorEstimation, Simulation};
use std::error::Error;
use std::fmt::Write as _;
use std::process::ExitCode;
use std::time::Instant;

/// Length of a rod, m, and the angle at which the chain hangs, rad.
const ROD_M: f64 = 0.1;
const DEFLECTION: f64 = 0.3;

/// Length of a step, s: that of a controller of robots.
const STEP_S: f64 = 1e-3;

/// Lengths, and how they are measured.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Numbers of links.
    #[arg(long, value_delimiter = ',', default_values_t = [100, 300, 1000, 3000, 10_000])]
    links: Vec<u32>,
    /// Tiers; `reduced` is the tier accurate in reduced coordinates.
    #[arg(long, value_delimiter = ',', default_values_t = ["stepped", "accurate", "reduced"].map(str::to_owned))]
    tiers: Vec<String>,
    /// Joints: hinge or ball.
    #[arg(long, default_value = "hinge")]
    joint: String,
    /// Length of a step, s.
    #[arg(long, default_value_t = STEP_S)]
    step: f64,
    /// Steps of a run.
    #[arg(long, default_value_t = 8)]
    steps: u32,
    /// Runs, of which the fastest counts.
    #[arg(long, default_value_t = 5)]
    runs: u32,
    /// The longest time of a run, s.
    #[arg(long, default_value_t = 20.0)]
    limit: f64,
}

/// Measures and prints.
pub(crate) fn run(options: &Options) -> Result<ExitCode, Box<dyn Error>> {
    println!("| tier | links | a step, ms | a link in a step, us | exponent |");
    println!("|---|---|---|---|---|");
    for tier in &options.tiers {
        let mut measured: Vec<Measured> = Vec::new();
        for &links in &options.links {
            let (seconds, first) = seconds_of_step(&chain(links, tier, options), options)?;
            let own = Measured { rows: f64::from(links), seconds };
            let exponent =
                measured.last().map_or_else(|| "-".to_owned(), |last| format!("{:.2}", exponent(last, &own)));
            println!("| {tier} | {links} | {:.3} | {:.2} | {exponent} |", 1e3 * seconds, 1e6 * seconds / own.rows);
            measured.push(own);
            if first > options.limit {
                break;
            }
        }
        if measured.len() > 1 {
            println!("| {tier} | all | | | {:.2} |", fit(&measured).1);
        }
    }
    Ok(ExitCode::SUCCESS)
}

fn exponent(last: &Measured, next: &Measured) -> f64 {
    (next.seconds / last.seconds).ln() / (next.rows / last.rows).ln()
}

/// The least time of a step that was made, s, and the time of the first run.
fn seconds_of_step(text: &str, options: &Options) -> Result<(f64, f64), Box<dyn Error>> {
    let scene = polhode_scene::load_text("chain", text, &[])?.scene;
    let (mut least, mut first) = (f64::INFINITY, 0.0);
    for run in 0..options.runs.max(1) {
        let mut simulation = Simulation::new(&scene)?.estimating(ErrorEstimation::Off);
        let start = Instant::now();
        let report = simulation.run()?;
        let seconds = start.elapsed().as_secs_f64();
        least = f64::min(least, seconds / report.steps.max(1) as f64);
        if run == 0 {
            first = seconds;
        }
        if seconds > options.limit {
            break;
        }
    }
    Ok((least, first))
}

/// The text of the scene of a chain.
fn chain(links: u32, tier: &str, options: &Options) -> String {
    let duration = f64::from(options.steps) * options.step;
    let tier = if tier == "reduced" { "accurate\"\ncoordinates = \"reduced" } else { tier };
    let mut text = format!(
        "format = 1\nname = \"chain\"\nduration = {duration:?}\n[method]\ntier = \"{tier}\"\nstep = {:?}\n[output]\n\
         interval = {duration:?}\n",
        options.step
    );
    let (x, z) = (ROD_M * DEFLECTION.sin(), -ROD_M * DEFLECTION.cos());
    let inertia = ROD_M * ROD_M / 12.0;
    for link in 0..links {
        let (top, centre) = (f64::from(link), f64::from(link) + 0.5);
        let bodies = if link == 0 { "[\"0\"]".to_owned() } else { format!("[\"{link}\", \"{}\"]", link - 1) };
        let axis = if options.joint == "hinge" { ", axis = [0, 1, 0]" } else { "" };
        // Writing to a string does not fail.
        let _ = write!(
            text,
            "[[bodies]]\nname = \"{link}\"\nmass = 1\ninertia = [{inertia:?}, {inertia:?}, {:?}]\n\
             position = [{:?}, 0, {:?}]\nrotation_vector = [0, {:?}, 0]\n\
             [[joints]]\ntype.{} = {{ bodies = {bodies}, anchor = [{:?}, 0, {:?}]{axis} }}\n",
            0.05 * inertia,
            centre * x,
            centre * z,
            -DEFLECTION,
            options.joint,
            top * x,
            top * z,
        );
    }
    text
}

#[cfg(test)]
mod tests {
    //! The chain is a scene, and hangs together.
    #![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn the_chain_is_a_scene() {
        let options = Options {
            links: Vec::new(),
            tiers: Vec::new(),
            joint: "ball".to_owned(),
            step: STEP_S,
            steps: 2,
            runs: 1,
            limit: 1.0,
        };
        for tier in ["stepped", "accurate", "reduced"] {
            let (seconds, first) = seconds_of_step(&chain(5, tier, &options), &options).unwrap();
            assert!(seconds > 0.0 && first > 0.0);
        }
    }
}

//! How many factorisations the solver in the velocities of bodies takes for pyramids of cubes, and how far it comes.
//!
//! `cargo run -p polhode-response --example factorisations` prints the table; a word after `--` chooses the lines
//! that hold it, as in `-- random`, `-- cost` prints what one factorisation costs, and `-- rows 20` solves one
//! pyramid at rest, whose instructions a profiler counts. `TOLERANCE=1e-8` before it asks for fewer digits than 1e-12.

#![allow(clippy::unwrap_used, reason = "a scene that cannot be built is a mistake here")]

#[path = "../tests/it/body_scenes.rs"]
#[allow(dead_code, reason = "the tests use more of it")]
mod body_scenes;

use body_scenes::{BodyScene, pyramid, tower};
use polhode_response::sparse::{BodySettings, BodySolution, BodySolver, Elimination};

fn main() {
    match std::env::args().nth(1).as_deref() {
        Some("cost") => print_costs(),
        Some("rows") => print_one(std::env::args().nth(2).and_then(|rows| rows.parse().ok()).unwrap_or(20)),
        only => print_factorisations(only.unwrap_or_default()),
    }
}

fn print_factorisations(only: &str) {
    println!("{:32} residual  balanced  factorisations, the same warm, tried", "pyramid of boxes");
    for (name, scene) in scenes().iter().filter(|(name, _)| name.contains(only)) {
        let cold = solved(scene, None);
        let again = solved(scene, Some(&cold.reactions)).report.factorisations;
        let report = cold.report;
        println!(
            "{name:32} {:8.1e}  {:8.1e}  {:3} {again:3}  {}",
            report.residual, report.balanced_residual, report.factorisations, report.tried
        );
    }
}

fn solved(scene: &BodyScene, start: Option<&[f64]>) -> BodySolution {
    let mut settings = BodySettings::default();
    if let Some(tolerance) = std::env::var("TOLERANCE").ok().and_then(|text| text.parse().ok()) {
        settings.tolerance = tolerance;
    }
    BodySolver::default().solve(&scene.problem(), start, &settings).unwrap()
}

fn scenes() -> Vec<(String, BodyScene)> {
    let mut scenes = Vec::new();
    for rows in [5, 10, 20] {
        let plain = pyramid(rows, 0.5);
        let boxes = plain.masses.len();
        for top in [1.0, 1e3, 1e6] {
            let mut rest = plain.clone();
            rest.masses[boxes - 1] = top;
            rest.pull(0.0);
            let (mut pushed, mut hit) = (rest.clone(), rest.clone());
            pushed.velocities[boxes - 1][0] += 0.1;
            hit.velocities[boxes / 2][0] += 1.0;
            for (what, scene) in [("rest", rest), ("top pushed", pushed), ("middle hit", hit)] {
                scenes.push((format!("{boxes}, top {top:.0} kg, {what}"), scene));
            }
        }
        for angle in [20.0_f64, 30.0] {
            let mut tilted = plain.clone();
            tilted.pull(angle.to_radians());
            scenes.push((format!("{boxes}, tilted by {angle}"), tilted));
        }
        for seed in 1..4 {
            let mut random = plain.clone();
            random.pull(0.0).shake(0.3, seed);
            scenes.push((format!("{boxes}, random {seed}"), random));
        }
    }
    for top in [1.0, 1e3, 1e6] {
        let mut heavy = tower(10, 0.5);
        heavy.masses[9] = top;
        heavy.pull(0.3);
        scenes.push((format!("tower of 10, top {top:.0} kg"), heavy));
    }
    scenes
}

fn print_one(rows: usize) {
    let mut scene = pyramid(rows, 0.5);
    let report = solved(scene.pull(0.0), None).report;
    println!("{} boxes, {} factorisations", scene.masses.len(), report.factorisations);
}

fn print_costs() {
    println!("pyramid of boxes: blocks of the factor and products of blocks, in all and for each box");
    for rows in [5, 10, 20, 40, 80, 160] {
        let elimination = Elimination::of(&pyramid(rows, 0.5).problem());
        let boxes = elimination.bodies();
        let (blocks, products) = (elimination.factor_blocks(), elimination.block_products());
        let each = |count: usize| count as f64 / boxes as f64;
        println!("{boxes:6}: {blocks:7} ({:5.2}), {products:8} ({:6.1})", each(blocks), each(products));
    }
}

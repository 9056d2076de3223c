//! Heaps with friction in the tier `stepped`: how exactly the problem of each step is solved, and by how many
//! factorisations.
//!
//! Boxes and balls fall into a bin; a wall and a pyramid stand at first and are pushed; a heavy box is dropped on light
//! ones. Forces are not unique, so that rows judge the residual of the problems, their factorisations, what overlap is
//! left, and what the removal of overlaps does to the energy: all as the run tells them.

use super::{CaseResult, Context};
use crate::row::Row;
use polhode::{ErrorEstimation, Simulation};

const CASE: &str = "heaps";

/// Residual of the problem of any step (natural map, relative).
const RESIDUAL: f64 = 1e-8;

/// Factorisations of the first step of a pile that is pushed, where this is reached; elsewhere it is what is aimed at.
const COLD: f64 = 25.0;
/// Heaps whose first step takes more: contacts open, close, stick and slide in it.
const LONGER_FIRST_STEPS: [&str; 2] = ["40 boxes", "1e6 kg on nine"];

/// Factorisations that 99 of 100 steps of a settling heap may take, where this is reached; elsewhere it is what is
/// aimed at. While bodies meet, contacts open, close, stick and slide in every step, so that the interior point begins
/// anew (20 to 50 factorisations); the warm start serves steps in which nothing changes.
const SETTLING: u64 = 4;

/// Heaps in which more steps than that take more.
const LONGER_STEPS: [&str; 4] = ["60 balls", "40 boxes", "pyramid of 55, pushed", "1e6 kg on nine"];

/// The part of steps that may take more.
const FEW_STEPS: f64 = 0.01;

/// Overlap that may be left at the end of a step, relative to the size.
const OVERLAP: f64 = 1e-12;

/// Steps of a run.
const STEPS: usize = 60;

const HEAD: &str = "format = 1\nduration = 10.0\n[method]\ntier = \"stepped\"\nstep = 0.016666666666666666\n\
    [materials.rough]\n\
                    friction = 0.5\n[[bodies]]\nname = \"floor\"\nfixed = true\nmaterial = \"rough\"\n\
                    shape.half_space.normal = [0, 0, 1]\n";

/// A body that stands, to be pushed or to be pressed.
const BOX: &str = "shape.box.size = [1, 1, 1]\nmass = 1.0\nmaterial = \"rough\"\n";

/// Walls of a bin `2 half` m wide, and what falls into it.
fn bin(half: f64, falling: &str) -> String {
    let wall = |(name, x, y): (&str, i32, i32)| {
        let (px, py) = (-half * f64::from(x), -half * f64::from(y));
        format!(
            "[[bodies]]\nname = \"{name}\"\nfixed = true\nmaterial = \"rough\"\nposition = [{px:.3}, {py:.3}, 0.0]\n\
             shape.half_space.normal = [{x}, {y}, 0]\n"
        )
    };
    let walls = [("west", 1, 0), ("south", 0, 1), ("east", -1, 0), ("north", 0, -1)].map(wall).concat();
    format!(
        "{HEAD}{walls}[[arrays]]\nname = \"fallen\"\n{falling}position = [-1.8, -1.8, 0.0]\nmass = 1.0\n\
         material = \"rough\"\n"
    )
}

/// Boxes in a pyramid of some rows, whose top is thrown down the side.
fn pushed_pyramid(rows: usize) -> String {
    let top = rows as f64 - 0.5;
    let edge = 0.5 * (rows as f64 - 1.0) * 1.1;
    format!(
        "{HEAD}[[arrays]]\nname = \"stone\"\nlayout.pyramid = {{ base = {rows}, spacing = [1.1, 1.0] }}\n\
         position = [0.0, 0.0, 0.5]\n{BOX}[[bodies]]\nname = \"ball\"\nposition = [{edge:.3}, 0.0, {:.3}]\n\
         velocity = [1.0, 0.2, -3.0]\nshape.sphere.radius = 0.5\nmass = 2.0\nmaterial = \"rough\"\n",
        top + 1.2
    )
}

/// A box of a thousand tonnes that slides on light ones.
fn heavy_on_light() -> String {
    format!(
        "{HEAD}[[arrays]]\nname = \"light\"\nlayout.grid = {{ counts = [3, 3, 1], spacing = [1.2, 1.2, 1.0] }}\n\
         position = [-1.2, -1.2, 0.5]\n{BOX}[[bodies]]\nname = \"heavy\"\nposition = [0.0, 0.0, 1.5]\n\
         velocity = [0.5, 0.1, 0.0]\nshape.box.size = [4, 4, 1]\nmass = 1e6\nmaterial = \"rough\"\n"
    )
}

/// What a run of some steps told.
struct Told {
    residual: f64,
    /// Of each step.
    factorisations: Vec<u64>,
    overlap_m: f64,
}

fn told(text: &str) -> Result<Told, Box<dyn std::error::Error>> {
    let scene = polhode_scene::load_text("heap.toml", text, &[])?.scene;
    let mut simulation = Simulation::new(&scene)?.estimating(ErrorEstimation::Off);
    let (mut factorisations, mut before) = (Vec::new(), 0);
    for _ in 0..STEPS {
        simulation.step()?;
        let now = simulation.frame().certificate.factorisations;
        factorisations.push(now - before);
        before = now;
    }
    let certificate = simulation.frame().certificate;
    Ok(Told { residual: certificate.max_residual, factorisations, overlap_m: certificate.max_penetration_m })
}

/// All rows.
pub(super) fn rows(_: &Context) -> CaseResult {
    let balls = bin(2.0, "layout.drop = { count = 60, size = [3.6, 3.6, 8], seed = 3 }\nshape.sphere.radius = 0.4\n");
    let boxes =
        bin(2.0, "layout.drop = { count = 40, size = [3.6, 3.6, 14], seed = 3 }\nshape.box.size = [0.8, 0.7, 0.6]\n");
    let mut rows = Vec::new();
    let scenes = [
        ("60 balls", balls),
        ("40 boxes", boxes),
        ("pyramid of 55, pushed", pushed_pyramid(10)),
        ("1e6 kg on nine", heavy_on_light()),
    ];
    for (name, text) in scenes {
        let told = told(&text)?;
        let more = told.factorisations.iter().filter(|&&of_step| of_step > SETTLING).count();
        let cold = told.factorisations.iter().find(|&&of_step| of_step > 0).copied().unwrap_or(0);
        rows.push(Row::at_most(CASE, &format!("{name}: largest residual"), RESIDUAL, told.residual));
        let quantity = format!("{name}: factorisations, first step with any");
        rows.push(if LONGER_FIRST_STEPS.contains(&name) {
            Row::info(CASE, &quantity, COLD, cold as f64)
        } else {
            Row::at_most(CASE, &quantity, COLD, cold as f64)
        });
        let part = more as f64 / STEPS as f64;
        let quantity = format!("{name}: part of steps with more than {SETTLING}");
        rows.push(if LONGER_STEPS.contains(&name) {
            Row::info(CASE, &quantity, FEW_STEPS, part)
        } else {
            Row::at_most(CASE, &quantity, FEW_STEPS, part)
        });
        rows.push(Row::at_most(CASE, &format!("{name}: overlap, m"), OVERLAP, told.overlap_m));
    }
    Ok(rows)
}

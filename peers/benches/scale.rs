//! Heaps, walls and towers with friction: polhode's tier `stepped` (or `--tier NAME`) beside rapier3d-f64, in one
//! process on one thread, from the same states.
//!
//! ```text
//! cargo bench --manifest-path peers/Cargo.toml --bench scale \
//!     [-- [--tier NAME] [--seconds S] [--svg FILE] [--growth] [NAME ...]]
//! ```
//!
//! Both make the steps of a scene (`support/scale/scenes.rs`) until there are as many as it has, or until polhode has
//! taken the seconds allowed (60); rapier then makes as many. The table is in Markdown; its columns:
//!
//! | column | what |
//! |---|---|
//! | `polhode` | to prepare the run (contacts and rest are found then), and the time of a step with its defaults |
//! | `rapier` | the time of a step with its defaults (4 substeps; bodies fall asleep), and where nothing falls asleep |
//! | `ratio` | medians / 99th percentiles, to each of them |
//! | `penetration` | the deepest overlap at the end of every tenth step |
//! | `drift` | the largest displacement of a body from its start to the end; only where the scene can stand |
//! | `residual` | of each engine's own impulses, by one judge (`support/scale/judge.rs`), every tenth step |
//! | `factorisations` | of polhode in a step; with the largest residual that it tells itself |
//!
//! Rapier's residual, penetration and drift are those of a run with its Coulomb friction at each point and without
//! sleep. `--growth` measures how the time of a step of polhode grows with the bodies, instead.

#[path = "support/scale/mod.rs"]
mod support;

use polhode::Certificate;
use polhode::scene::Tier;
use std::time::Instant;
use support::judge::{Depths, judge};
use support::measured::{Measured, quantile};
use support::ours::Ours;
use support::peer::{Peer, Settings};
use support::scenes::{Scene, growing, scenes};
use support::table::{Compared, HEAD, figure};

/// Steps between two that are judged.
const JUDGED_EVERY: usize = 10;

/// Seconds of computing that polhode may take for a scene.
const SECONDS: f64 = 60.0;

fn of_ours(scene: &Scene, (tier, seconds): (Tier, f64)) -> Result<(Measured, Certificate), String> {
    let begin = Instant::now();
    let mut run = Ours::new(scene, tier)?;
    let mut measured = Measured { start: begin.elapsed().as_secs_f64(), ..Measured::default() };
    let mut depths = Depths::new(scene);
    let (mut total, mut before) = (0.0, run.certificate().factorisations);
    for step in 1..=scene.steps {
        let time = run.step()?;
        measured.times.push(time);
        total += time;
        let factorisations = run.certificate().factorisations;
        measured.factorisations.push((factorisations - before) as f64);
        before = factorisations;
        if step % JUDGED_EVERY == 0 || total > seconds {
            let bodies = run.bodies();
            let verdict = judge(scene, &bodies, &run.contacts(), scene.step);
            measured.look(scene, &mut depths, &bodies, verdict);
        }
        if total > seconds {
            break;
        }
    }
    Ok((measured, run.certificate()))
}

fn of_peer(scene: &Scene, settings: Settings, steps: usize) -> Measured {
    let mut run = Peer::new(scene, settings);
    let (mut measured, mut depths) = (Measured::default(), Depths::new(scene));
    for step in 1..=steps {
        measured.times.push(run.step());
        if settings == Settings::Judged && (step % JUDGED_EVERY == 0 || step == steps) {
            let bodies = run.bodies();
            let verdict = judge(scene, &bodies, &run.contacts(), scene.step * run.substep());
            measured.look(scene, &mut depths, &bodies, verdict);
        }
    }
    measured
}

fn compare(scene: Scene, (tier, seconds): (Tier, f64)) -> Result<Compared, String> {
    let (ours, own) = of_ours(&scene, (tier, seconds))?;
    let steps = ours.times.len();
    let of = |settings| of_peer(&scene, settings, steps);
    let [defaults, awake, judged] = [Settings::Defaults, Settings::Awake, Settings::Judged].map(of);
    Ok(Compared { scene, ours, own, defaults, awake, judged })
}

/// Prints how the median time of a step grows, and the exponents between the least and the largest scene.
fn growth(tier: Tier, seconds: f64) -> Result<(), String> {
    for (kind, scenes) in growing() {
        let mut points = Vec::new();
        for scene in scenes {
            let (measured, _) = of_ours(&scene, (tier, seconds))?;
            let (bodies, time) = (scene.members.len() as f64, quantile(&measured.times, 0.5));
            println!(
                "{kind}: {bodies} bodies, {} contacts, start {:.3} s, median step {:.3} s of {}, factorisations {}",
                measured.contacts,
                measured.start,
                time,
                measured.times.len(),
                measured.factorisations(0.5)
            );
            points.push((bodies, time, measured.start));
        }
        if let [(least, first, begun), .., (most, last, ended)] = points[..] {
            let over = f64::ln(most / least);
            println!(
                "{kind}: exponents of a step {:.2}, of the start {:.2}",
                (last / first).ln() / over,
                (ended / begun).ln() / over
            );
        }
    }
    Ok(())
}

fn main() {
    let (mut names, mut seconds, mut svg, mut grows) = (Vec::new(), SECONDS, None, false);
    let mut tier = Tier::Stepped;
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--bench" => {}
            "--tier" => tier = arguments.next().and_then(|name| Tier::from_name(&name)).unwrap_or(tier),
            "--growth" => grows = true,
            "--seconds" => seconds = arguments.next().and_then(|text| text.parse().ok()).unwrap_or(SECONDS),
            "--svg" => svg = arguments.next(),
            _ => names.push(argument),
        }
    }
    if grows {
        if let Err(error) = growth(tier, seconds) {
            println!("{error}");
        }
        return;
    }
    println!("{HEAD}");
    let mut compared = Vec::new();
    for scene in scenes() {
        if !names.is_empty() && !names.iter().any(|name| scene.name.starts_with(name.as_str())) {
            continue;
        }
        let name = scene.name;
        match compare(scene, (tier, seconds)) {
            Ok(one) => {
                println!("{}", one.row());
                compared.push(one);
            }
            Err(error) => println!("{name}: {error}"),
        }
    }
    if let Some(file) = svg
        && let Err(error) = std::fs::write(&file, figure(&compared))
    {
        println!("{file}: {error}");
    }
}

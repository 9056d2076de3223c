//! Real time beside rapier3d-f64: both engines take turns, step by step, so that a machine that is busy with other work
//! slows both alike.
//!
//! ```text
//! cargo bench --manifest-path peers/Cargo.toml --bench turns [-- [--tier NAME] [--steps N] [--no-look] [NAME ...]]
//! ```
//!
//! Scenes and judge are those of the bench `scale`; one thread, substeps of both by default four, nothing asleep in
//! rapier. Each of the first `--steps` steps (90) is timed; after every tenth one the bodies are looked at. Columns:
//!
//! | column | what |
//! |---|---|
//! | `step` | median times of polhode and of rapier, ms, and their ratio; that ratio of the last third of the steps |
//! | `overlap` | the largest: polhode; rapier with one friction for a face (its default); with friction at each point |
//! | `drift` | the largest displacement from the start to the end, of the same three; only where the scene can stand |
//! | `residual` | median, by the judge of both: polhode; rapier with friction at each point |
//!
//! `--no-look` leaves out the looks, and the third run. `--alone ours` and `--alone rapier` make the steps of one
//! engine: for counts of instructions.

// Of the helpers that it shares with the bench `scale` it uses a part.
#![allow(dead_code)]

#[path = "support/scale/mod.rs"]
mod support;

use polhode::scene::Tier;
use support::judge::{Depths, judge};
use support::measured::{Measured, quantile};
use support::ours::Ours;
use support::peer::{Peer, Settings};
use support::scenes::{Scene, scenes};

/// Steps between two looks.
const LOOK_EVERY: usize = 10;

/// Steps of a scene.
const STEPS: usize = 90;

/// What is asked.
struct Asked {
    tier: Tier,
    steps: usize,
    looks: bool,
    alone: Option<String>,
    names: Vec<String>,
}

impl Asked {
    fn of_arguments() -> Self {
        let mut asked = Self { tier: Tier::Fast, steps: STEPS, looks: true, alone: None, names: Vec::new() };
        let mut arguments = std::env::args().skip(1);
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--bench" => {}
                "--tier" => {
                    asked.tier = arguments.next().and_then(|name| Tier::from_name(&name)).unwrap_or(asked.tier);
                }
                "--steps" => asked.steps = arguments.next().and_then(|text| text.parse().ok()).unwrap_or(STEPS),
                "--no-look" => asked.looks = false,
                "--alone" => asked.alone = arguments.next(),
                _ => asked.names.push(argument),
            }
        }
        asked
    }
}

/// A row of the table.
fn compare(scene: &Scene, asked: &Asked) -> Result<String, String> {
    let mut ours = Ours::new(scene, asked.tier)?;
    let mut peers = vec![Peer::new(scene, Settings::Awake)];
    if asked.looks {
        peers.push(Peer::new(scene, Settings::Judged));
    }
    let mut depths = Depths::new(scene);
    let mut measured = [Measured::default(), Measured::default(), Measured::default()];
    for step in 1..=asked.steps {
        measured[0].times.push(ours.step()?);
        for (peer, measured) in peers.iter_mut().zip(&mut measured[1..]) {
            measured.times.push(peer.step());
        }
        if asked.looks && (step % LOOK_EVERY == 0 || step == asked.steps) {
            let bodies = ours.bodies();
            let verdict = judge(scene, &bodies, &ours.contacts(), scene.step);
            measured[0].look(scene, &mut depths, &bodies, verdict);
            for (peer, measured) in peers.iter().zip(&mut measured[1..]) {
                let bodies = peer.bodies();
                let verdict = judge(scene, &bodies, &peer.contacts(), scene.step * peer.substep());
                measured.look(scene, &mut depths, &bodies, verdict);
            }
        }
    }
    let late = asked.steps * 2 / 3;
    let [own, peer, judged] = &measured;
    let ratio = |from: usize| quantile(&own.times[from..], 0.5) / quantile(&peer.times[from..], 0.5);
    let three = |of: &dyn Fn(&Measured) -> f64, factor: f64| {
        measured.iter().map(|one| format!("{:.3}", of(one) * factor)).collect::<Vec<_>>().join("; ")
    };
    let drift = if scene.stands { three(&|one| one.drift, 1.0) } else { "-".to_owned() };
    Ok(format!(
        "| {} | {} | {:.3}; {:.3}; **{:.3}**; {:.3} | {} | {drift} | {:.1e}; {:.1e} |",
        scene.name,
        asked.steps,
        own.milliseconds(0.5),
        peer.milliseconds(0.5),
        ratio(0),
        ratio(late),
        three(&|one| one.penetration, 1e3),
        own.residual(0.5),
        judged.residual(0.5),
    ))
}

/// The steps of one engine.
fn alone(scene: &Scene, asked: &Asked, engine: &str) -> Result<(), String> {
    if engine == "rapier" {
        let mut peer = Peer::new(scene, Settings::Awake);
        (0..asked.steps).for_each(|_| {
            peer.step();
        });
        return Ok(());
    }
    let mut ours = Ours::new(scene, asked.tier)?;
    (0..asked.steps).try_for_each(|_| ours.step().map(|_| ()))
}

fn main() {
    let asked = Asked::of_arguments();
    println!(
        "| scene | steps | step, ms: polhode; rapier; ratio; of the last third | overlap, mm | drift, m | \
        residual |\n|---|---|---|---|---|---|"
    );
    for scene in scenes() {
        if !asked.names.iter().any(|name| scene.name == name) {
            continue;
        }
        let answer = match &asked.alone {
            Some(engine) => alone(&scene, &asked, engine).map(|()| scene.name.to_owned()),
            None => compare(&scene, &asked),
        };
        println!("{}", answer.unwrap_or_else(|error| format!("{}: {error}", scene.name)));
    }
}

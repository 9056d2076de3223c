//! Heaps, walls and towers with friction: polhode's tier `stepped` beside rapier3d-f64, in one process on one thread, from the
//! same states.
//!
//! `cargo bench --manifest-path peers/Cargo.toml --bench scale [-- [--seconds S] [--svg FILE] [NAME ...]]`
//!
//! Both make the steps of a scene (`support/scale/scenes.rs`) until there are as many as it has, or until polhode has taken the
//! seconds allowed (60); rapier then makes as many. Columns:
//!
//! | column | what |
//! |---|---|
//! | `median`, `99 %` | time of a step, ms, with the defaults of each (rapier: 4 substeps, bodies fall asleep) |
//! | `awake` | the median of rapier where nothing falls asleep |
//! | `ratio` | of polhode to rapier with its defaults: medians, 99th percentiles |
//! | `penetration` | the deepest overlap at the end of every tenth step, m |
//! | `drift` | the largest displacement of a body from its start to the end, m; only where the scene can stand |
//! | `residual` | of each engine's own impulses, judged by one function (`support/scale/judge.rs`): median and largest of the steps judged |
//!
//! Rapier's residual and penetration are those of a run with its Coulomb friction at each point and without sleep.

#[path = "support/scale/mod.rs"]
mod support;

use support::judge::{Depths, Moved, Verdict, judge};
use support::ours::Ours;
use support::peer::{Peer, Settings};
use support::scenes::{Scene, scenes};

/// Steps between two that are judged.
const JUDGED_EVERY: usize = 10;

/// Seconds of computing that polhode may take for a scene.
const SECONDS: f64 = 60.0;

/// What was measured of one engine.
#[derive(Debug, Clone, Default)]
struct Measured {
    /// s.
    times: Vec<f64>,
    penetration: f64,
    drift: f64,
    residuals: Vec<f64>,
    contacts: usize,
    carried: f64,
}

impl Measured {
    fn quantile(&self, part: f64) -> f64 {
        quantile(&self.times, part) * 1e3
    }

    fn look(&mut self, scene: &Scene, depths: &mut Depths, bodies: &[Moved], verdict: Verdict) {
        self.penetration = self.penetration.max(depths.deepest(scene, bodies));
        self.residuals.push(verdict.residual);
        (self.contacts, self.carried) = (verdict.contacts, verdict.carried);
        let moved = bodies.iter().zip(&scene.members);
        self.drift = moved.map(|(body, from)| from.pose.translation.distance(body.pose.translation)).fold(0.0, f64::max);
    }
}

fn quantile(values: &[f64], part: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let place = (part * sorted.len() as f64).ceil() as usize;
    sorted.get(place.saturating_sub(1)).copied().unwrap_or(f64::NAN)
}

fn of_ours(scene: &Scene, seconds: f64) -> Result<(Measured, f64), String> {
    let mut run = Ours::new(scene)?;
    let (mut measured, mut depths) = (Measured::default(), Depths::new(scene));
    let mut total = 0.0;
    for step in 1..=scene.steps {
        let time = run.step()?;
        measured.times.push(time);
        total += time;
        if step % JUDGED_EVERY == 0 || total > seconds {
            let bodies = run.bodies();
            let verdict = judge(scene, &bodies, &run.contacts(), scene.step);
            measured.look(scene, &mut depths, &bodies, verdict);
        }
        if total > seconds {
            break;
        }
    }
    Ok((measured, run.own_residual()))
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

fn compare(scene: &Scene, seconds: f64) -> Result<(), String> {
    let (ours, own) = of_ours(scene, seconds)?;
    let steps = ours.times.len();
    let [defaults, awake, judged] =
        [Settings::Defaults, Settings::Awake, Settings::Judged].map(|settings| of_peer(scene, settings, steps));
    let [median, last] = [0.5, 0.99].map(|part| [ours.quantile(part), defaults.quantile(part)]);
    println!("{}: {} bodies, {steps} of {} steps of {:.4} s", scene.name, scene.members.len(), scene.steps, scene.step);
    println!("  ratio of medians {:.2}, of 99th percentiles {:.2}", median[0] / median[1], last[0] / last[1]);
    let drift = |measured: &Measured| if scene.stands { format!("{:.1e}", measured.drift) } else { "-".to_owned() };
    let row = |name: &str, [median, last]: [f64; 2], of: &Measured| {
        let [middle, largest] = [0.5, 1.0].map(|part| quantile(&of.residuals, part));
        println!(
            "  {name:8} median {median:9.3} ms, 99 % {last:9.3} ms, penetration {:.1e} m, drift {} m, residual {middle:.1e} (largest {largest:.1e}), {} contacts, carried {:.4}",
            of.penetration,
            drift(of),
            of.contacts,
            of.carried
        );
    };
    row("polhode", [median[0], last[0]], &ours);
    row("rapier", [median[1], last[1]], &judged);
    println!("  rapier awake: median {:.3} ms; polhode's own largest residual {own:.1e}", awake.quantile(0.5));
    Ok(())
}

fn main() {
    let mut names = Vec::new();
    let mut seconds = SECONDS;
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--bench" => {}
            "--seconds" => seconds = arguments.next().and_then(|text| text.parse().ok()).unwrap_or(SECONDS),
            _ => names.push(argument),
        }
    }
    for scene in scenes() {
        if !names.is_empty() && !names.iter().any(|name| scene.name.starts_with(name.as_str())) {
            continue;
        }
        if let Err(error) = compare(&scene, seconds) {
            println!("{}: {error}", scene.name);
        }
    }
}

//! `polhode cost SCENE --broad-phase`: what each way to find pairs that may touch costs on the scene.
//!
//! The scene runs once, by its own method; the boxes of its bodies at the samples of that run are then given to every
//! broad phase, one sample after the other, as a simulation would. All must find the same pairs.

use super::text::ratio;
use crate::failure::Failure;
use crate::text::{Table, number};
use polhode::contact::{Aabb, BroadPhaseMethod, aabb_of};
use polhode::spatial::Pose;
use polhode::{BodyId, BodySample, Geometry, Scene};
use polhode_scene::Override;
use polhode_study::Source;
use polhode_study::timing::{Effort, median};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::hint::black_box;
use std::time::Instant;

/// What was measured.
#[derive(Debug)]
pub(crate) struct BroadPhaseStudy {
    scene: String,
    /// Bodies with a shape.
    boxes: usize,
    /// Samples of the run.
    samples: usize,
    /// Pairs that each broad phase found, over all samples.
    pairs: usize,
    /// Those of them that may collide, over all samples.
    collidable: usize,
    rows: Vec<Row>,
}

/// One broad phase.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Row {
    method: BroadPhaseMethod,
    /// Time of one sample, s: median over the rounds.
    seconds: f64,
    /// Relative to the first method, the default: median over the rounds.
    ratio: f64,
    rounds: usize,
}

impl BroadPhaseStudy {
    /// Runs the scene and times every broad phase on it.
    ///
    /// # Errors
    /// When the scene is refused, its run fails, no body has a shape, or two broad phases find different pairs.
    pub(super) fn run(source: &Source<'_>, samples: u32, effort: Effort) -> Result<Self, Failure> {
        let duration_s = source.loaded()?.scene.duration_s();
        let interval = (duration_s / f64::from(samples)).to_string();
        let scene = source.scene(&[Override::new("broad-phase study".to_owned(), "output.interval", &interval)]);
        let scene = scene.map_err(|reason| check(&reason))?;
        let run = source.record(&scene, None).map_err(|reason| check(&reason))?;
        let (frames, colliders) = frames(&scene, &run.record.samples);
        let boxes = frames.first().map_or(0, Vec::len);
        if boxes == 0 {
            return Err(check("no body of the scene has a shape: there are no pairs to find"));
        }
        let found = pairs(&frames)?;
        let body = |collider: u32| BodyId::new(colliders[collider as usize]);
        let may_collide = |&(i, j): &(u32, u32)| scene.can_collide(body(i), body(j));
        let collidable = found.iter().flatten().filter(|pair| may_collide(pair)).count();
        let pairs = found.iter().map(Vec::len).sum();
        let rows = rows(&time(&frames, effort), frames.len());
        Ok(Self { scene: scene.name().to_owned(), boxes, samples: frames.len(), pairs, collidable, rows })
    }

    /// The table for people.
    pub(super) fn page(&self) -> String {
        let mut table = Table::default();
        table.row(["broad phase", "time of a call", "relative", "rounds"]);
        for row in &self.rows {
            let time = format!("{:.3} us", row.seconds * 1e6);
            table.row([row.method.name(), &time, &ratio(row.ratio), &row.rounds.to_string()]);
        }
        format!("scene {}\n\n{}\n{}", self.scene, self.notes(), table.print())
    }

    /// What the numbers mean.
    fn notes(&self) -> String {
        let all = self.boxes * (self.boxes - 1) / 2;
        let mean = |count: usize| number(count as f64 / self.samples as f64);
        let mut lines = Table::default();
        lines.row(["boxes", &format!("{} bodies with a shape, at {} samples of the run", self.boxes, self.samples)]);
        lines.row([
            "pairs",
            &format!("{all} of all boxes; {} of boxes that meet, mean over the samples", mean(self.pairs)),
        ]);
        lines.row(["", &format!("{} of them of bodies that may collide", mean(self.collidable))]);
        lines.row(["results", "the same pairs from every broad phase, so the same motion"]);
        lines.print()
    }

    /// The table as CSV.
    pub(super) fn csv(&self) -> String {
        let mut text = "broad_phase,time_s,time_ratio,rounds,boxes,samples,pairs,collidable_pairs\n".to_owned();
        for row in &self.rows {
            let (name, time, ratio, rounds) = (row.method.name(), row.seconds, row.ratio, row.rounds);
            let Self { boxes, samples, pairs, collidable, .. } = self;
            let _ = writeln!(text, "{name},{time:?},{ratio:?},{rounds},{boxes},{samples},{pairs},{collidable}");
        }
        text
    }

    /// Everything as JSON.
    pub(super) fn json(&self) -> Value {
        let row = |row: &Row| {
            let (name, rounds) = (row.method.name(), row.rounds);
            json!({ "broad_phase": name, "time_s": row.seconds, "time_ratio": row.ratio, "rounds": rounds })
        };
        json!({
            "scene": self.scene,
            "boxes": self.boxes,
            "samples": self.samples,
            "pairs": self.pairs,
            "collidable_pairs": self.collidable,
            "broad_phases": self.rows.iter().map(row).collect::<Vec<_>>(),
        })
    }

    /// The table as a page that needs nothing else.
    pub(super) fn html(&self) -> String {
        let scene = super::html::escaped(&self.scene);
        let mut rows = String::new();
        for row in &self.rows {
            let (name, time, ratio) = (row.method.name(), format!("{:.3}", row.seconds * 1e6), ratio(row.ratio));
            let _ = writeln!(rows, "<tr><td>{name}</td><td class=\"n\">{time}</td><td class=\"n\">{ratio}</td></tr>");
        }
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n\
             <title>{scene}: what broad phases cost</title>\n\
             <style>{}</style>\n<h1>{scene}: what broad phases cost</h1>\n<pre>{}</pre>\n<table>\n\
             <thead><tr><th>broad phase</th><th>time of a call, us</th><th>relative</th></tr></thead>\n\
             <tbody>\n{rows}</tbody>\n</table>\n</html>\n",
            super::html::STYLE,
            super::html::escaped(&self.notes())
        )
    }
}

/// Boxes of all bodies with a shape at every sample, and the numbers of these bodies.
fn frames(scene: &Scene, samples: &[Vec<BodySample>]) -> (Vec<Vec<Aabb>>, Vec<usize>) {
    let shapes: Vec<_> = scene
        .bodies()
        .iter()
        .enumerate()
        .filter_map(|(body, entry)| match entry.shape() {
            Some(Geometry::Shape(shape)) => Some((body, shape)),
            _ => None,
        })
        .collect();
    let aabb = |sample: &[BodySample], body: usize, shape| {
        let pose = sample.get(body).map_or(Pose::IDENTITY, |sample| sample.pose);
        aabb_of(shape, &pose).unwrap_or(Aabb::UNBOUNDED)
    };
    let frame = |sample: &Vec<BodySample>| shapes.iter().map(|&(body, shape)| aabb(sample, body, shape)).collect();
    (samples.iter().map(frame).collect(), shapes.iter().map(|&(body, _)| body).collect())
}

/// The pairs of every sample, which all methods must agree on.
fn pairs(frames: &[Vec<Aabb>]) -> Result<Vec<Vec<(u32, u32)>>, Failure> {
    let mut agreed: Option<Vec<Vec<(u32, u32)>>> = None;
    for method in BroadPhaseMethod::ALL {
        let mut broad_phase = method.build();
        let mut found = vec![Vec::new(); frames.len()];
        for (boxes, pairs) in frames.iter().zip(&mut found) {
            broad_phase.pairs(boxes, pairs).map_err(|error| check(&error.to_string()))?;
        }
        match &agreed {
            None => agreed = Some(found),
            Some(agreed) if *agreed == found => {}
            Some(_) => return Err(check(&format!("{method} finds other pairs than {}", BroadPhaseMethod::default()))),
        }
    }
    Ok(agreed.unwrap_or_default())
}

/// Times of all samples together, s: for every method, for every round. Methods take turns, so that what slows the
/// machine slows all of them.
fn time(frames: &[Vec<Aabb>], effort: Effort) -> Vec<Vec<f64>> {
    let mut broad_phases: Vec<_> = BroadPhaseMethod::ALL.iter().map(|method| (method.build(), Vec::new())).collect();
    let mut times = vec![Vec::new(); broad_phases.len()];
    let mut total_s = 0.0;
    // The first round fills memory and caches.
    for round in 0..=effort.most_rounds {
        if round > effort.fewest_rounds && total_s > effort.enough_s * times.len() as f64 {
            break;
        }
        for ((broad_phase, pairs), times) in broad_phases.iter_mut().zip(&mut times) {
            let started = Instant::now();
            for boxes in frames {
                // An error has been reported by the comparison of the pairs.
                let _ = black_box(broad_phase.pairs(black_box(boxes), pairs));
            }
            let taken_s = started.elapsed().as_secs_f64();
            if round > 0 {
                times.push(taken_s);
                total_s += taken_s;
            }
        }
    }
    times
}

fn rows(times: &[Vec<f64>], samples: usize) -> Vec<Row> {
    let base = times.first().cloned().unwrap_or_default();
    let row = |(method, times): (BroadPhaseMethod, &Vec<f64>)| {
        let ratios: Vec<_> = times.iter().zip(&base).map(|(time, base)| time / base).collect();
        let seconds = median(times).unwrap_or(f64::NAN) / samples as f64;
        Row { method, seconds, ratio: median(&ratios).unwrap_or(f64::NAN), rounds: times.len() }
    };
    BroadPhaseMethod::ALL.into_iter().zip(times).map(row).collect()
}

fn check(message: &str) -> Failure {
    Failure::Check(format!("error: {message}"))
}

#[cfg(test)]
mod tests {
    //! Ratios are those of the same round; no clock is read.
    use super::*;

    #[test]
    fn ratios_are_of_the_same_round() {
        let times = vec![vec![1.0, 2.0, 8.0], vec![3.0, 6.0, 24.0]];
        let rows = rows(&times, 4);
        assert_eq!(rows[0], Row { method: BroadPhaseMethod::Bvh, seconds: 0.5, ratio: 1.0, rounds: 3 });
        assert_eq!((rows[1].seconds, rows[1].ratio), (1.5, 3.0));
    }
}

//! What the rows of a sweep say together.

use super::band::{Band, Share};
use super::design::{Mixing, Part, STEPS};
use super::plan::Sweep;
use super::run::Row;
use super::sensitivity::{self, Indices, Judge, MOST_JUDGED, Method, OfKey};
use super::varied::Varied;
use blake2::digest::consts::U32;
use blake2::{Blake2b, Digest};
use std::collections::BTreeMap;

/// Rows, as far as they have come, in their order.
#[derive(Debug, Clone)]
pub struct Gathered<'a> {
    sweep: &'a Sweep,
    hash: Blake2b<U32>,
    rows: u64,
    next: u64,
    is_whole: bool,
    outcomes: BTreeMap<String, u64>,
    /// Of each measure, rows before those of the draws.
    before: Vec<Vec<f64>>,
    /// Of each measure, all rows of draws: the draw, and what belongs to it.
    draws: Vec<Vec<f64>>,
    /// The values of the first draws.
    judges: Vec<Vec<String>>,
    largest_error: f64,
    reason: Option<String>,
}

/// A measure over the runs.
#[derive(Debug, Clone, PartialEq)]
pub struct OfMeasure {
    /// Its name.
    pub name: String,
    /// Its values in the draws, in their order; NaN where a run has none.
    pub values: Vec<f64>,
    /// Mean, deviation, quantiles; none where no run has it.
    pub band: Option<Band>,
    /// What it hangs on, in a sweep of what is uncertain that has all its rows.
    pub indices: Option<Indices>,
}

/// What a sweep has found.
#[derive(Debug, Clone, PartialEq)]
pub struct Findings {
    /// How many rows there are.
    pub rows: u64,
    /// How many of them are draws, or points of a grid.
    pub draws: u64,
    /// How these ended.
    pub shares: Vec<Share>,
    /// The measures.
    pub measures: Vec<OfMeasure>,
    /// The largest error that a run told of itself, of a body's size; NaN where none is known.
    pub largest_error: f64,
    /// Why the first run that failed or is degraded is so.
    pub reason: Option<String>,
    /// BLAKE2b-256 of the bytes of the table, as its file has them.
    pub table_hash: String,
}

impl<'a> Gathered<'a> {
    /// No row yet; `digest` is that of the sweep.
    pub fn new(sweep: &'a Sweep, digest: &str) -> Self {
        let of_measures = || sweep.measures.iter().map(|_| Vec::new()).collect();
        Self {
            sweep,
            hash: Blake2b::new().chain_update(sweep.head(digest)),
            rows: 0,
            next: 0,
            is_whole: true,
            outcomes: BTreeMap::new(),
            before: of_measures(),
            draws: of_measures(),
            judges: Vec::new(),
            largest_error: f64::NAN,
            reason: None,
        }
    }

    /// The next row.
    pub fn add(&mut self, row: &Row) {
        self.hash.update(format!("{}\n", row.line()));
        self.is_whole &= row.run == self.next;
        (self.rows, self.next) = (self.rows + 1, row.run + 1);
        self.largest_error = self.largest_error.max(row.error);
        if self.reason.is_none() && !row.reason.is_empty() {
            self.reason = Some(format!("run {}: {}", row.run, row.reason));
        }
        let part = self.sweep.part(row.run);
        if let Part::Draw(draw) = part {
            *self.outcomes.entry(row.outcome.clone()).or_default() += 1;
            if (draw as usize) < MOST_JUDGED && self.sweep.design.is_some() {
                self.judges.push(row.values[1..].to_vec());
            }
        }
        let is_before = matches!(part, Part::Middle | Part::Step { .. } | Part::Node(_));
        let of = if is_before { &mut self.before } else { &mut self.draws };
        of.iter_mut().zip(&row.measured).for_each(|(own, value)| own.push(*value));
    }

    /// How many rows there are.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// How many draws, or points of a grid, came to their end, degraded ones among them.
    pub fn completed(&self) -> u64 {
        self.outcomes.iter().filter(|(outcome, _)| *outcome != "failed").map(|(_, count)| count).sum()
    }

    /// What they say.
    pub fn findings(&self) -> Findings {
        let draws = self.outcomes.values().sum();
        let share = |(outcome, count): (&String, &u64)| Share::new(outcome, *count, draws);
        let hash = self.hash.clone().finalize();
        Findings {
            rows: self.rows,
            draws,
            shares: self.outcomes.iter().map(share).collect(),
            measures: (0..self.draws.len()).map(|number| self.of_measure(number)).collect(),
            largest_error: self.largest_error,
            reason: self.reason.clone(),
            table_hash: hash.iter().fold(String::new(), |text, byte| text + &format!("{byte:02x}")),
        }
    }

    fn of_measure(&self, number: usize) -> OfMeasure {
        let keys = self.sweep.varied.len();
        let each = self.sweep.design.as_ref().map_or(1, |design| design.of_draw(keys) as usize);
        let values: Vec<f64> = self.draws[number].iter().copied().step_by(each).collect();
        let name = self.sweep.measures[number].column.clone();
        OfMeasure { name, band: Band::of(&values), indices: self.indices(number, &values), values }
    }

    /// What a measure hangs on.
    fn indices(&self, number: usize, values: &[f64]) -> Option<Indices> {
        let design = self.sweep.design.as_ref().filter(|_| self.is_whole && self.rows == self.sweep.runs())?;
        let (varied, before) = (&self.sweep.varied, &self.before[number]);
        let first_node = 1 + 2 * STEPS * design.stepped().len();
        let (method, pairs) = if !design.nodes().is_empty() {
            let judges: Vec<Judge> = self.judges.iter().cloned().zip(values.iter().copied()).collect();
            sensitivity::by_nodes(varied, design, &before[first_node..], &judges)
        } else if design.mixing() == Mixing::Saltelli {
            sensitivity::by_mixed(&self.draws[number], varied.len())
        } else {
            (Method::None("they were not asked for".to_owned()), Vec::new())
        };
        let of_key = |(key, own): (usize, &Varied)| {
            let pair = pairs.get(key);
            let derivative = design.stepped().iter().position(|stepped| *stepped == key).and_then(|place| {
                let at = |step: usize, way: usize| {
                    let run = 1 + 2 * STEPS * place + 2 * step + way;
                    let value = self.sweep.values(run as u64)[key].parse().unwrap_or(f64::NAN);
                    [value, before[run]]
                };
                sensitivity::derivative(own, &std::array::from_fn(|step| [at(step, 0), at(step, 1)]))
            });
            let [first, total] = [0, 1].map(|which| pair.map(|pair| pair[which]));
            OfKey { key: own.key.clone(), first, total, derivative }
        };
        Some(Indices { method, keys: varied.iter().enumerate().map(of_key).collect() })
    }
}

//! Which runs a sweep has: values of lists combined, draws first, and what is measured of each.

use super::design::{Design, Part};
use super::distribution::Drawing as _;
use super::error::SweepError;
use super::measure::{Measure, Measured};
use super::scene::SweepScene;
use super::varied::{Acts, Values, Varied};
use crate::candidate::change;
use polhode::spatial::DVec3;
use polhode_scene::{LoadedScene, Override, StartPose};
use std::num::NonZeroU64;
use std::ops::Range;

/// Runs of a sweep at the most: a table of a few columns fills a gigabyte.
pub(crate) const MOST_RUNS: u64 = 10_000_000;

/// Values of a list that are checked at most: every one of a list that a person has written.
const MOST_CHECKED: usize = 200;

/// Columns that every table has before what is measured, and after what is varied.
const OUTCOME: &str = "outcome";
const ERROR: &str = "error";
/// What errors name as the place of a body that is moved.
const ORIGIN: &str = "study";
/// The first and the last column.
const RUN: &str = "run";
/// The second column, of a sweep of what is uncertain: what a row is for.
const PART: &str = "part";
const REASON: &str = "reason";

/// Which runs there are, and what is measured of each.
#[derive(Debug, Clone)]
pub struct Sweep {
    pub(super) varied: Vec<Varied>,
    /// Bodies that are moved and turned.
    poses: Vec<StartPose>,
    /// What the runs of a sweep of what is uncertain are for.
    pub(super) design: Option<Design>,
    seed: u64,
    pub(super) measures: Vec<Measure>,
    runs: u64,
}

impl Sweep {
    /// All combinations of the values of lists; where a distribution is among what is varied, so many draws of each of
    /// them.
    ///
    /// # Errors
    /// When a key is given twice, there are too many runs, or the number of draws does not fit what is varied.
    pub fn new(
        varied: Vec<Varied>,
        draws: Option<NonZeroU64>,
        seed: u64,
        measures: Vec<Measure>,
    ) -> Result<Self, SweepError> {
        check_columns(&varied, &measures)?;
        let is_drawn = varied.iter().any(|own| matches!(own.values, Values::Drawn(_)));
        let draws = match (draws, is_drawn) {
            (Some(draws), true) => draws.get(),
            (None, true) => return Err(SweepError::Draws("a value is drawn: --random N says how often".to_owned())),
            (Some(draws), false) if draws.get() > 1 => {
                let what =
                    "nothing is drawn, and all runs would be the same: vary a key by a distribution, as 0.1..0.8";
                return Err(SweepError::Draws(format!("--random {draws}: {what}")));
            }
            (_, false) => 1,
        };
        let points = varied.iter().map(|own| match &own.values {
            Values::Listed(values) => values.len() as u64,
            Values::Drawn(_) => 1,
        });
        let runs = accepted(points.clone().try_fold(draws, u64::checked_mul))?;
        Ok(Self { varied, poses: Vec::new(), design: None, seed, measures, runs })
    }

    /// A sweep of values that are all drawn, by a design.
    pub(super) fn designed(
        (varied, poses): (Vec<Varied>, Vec<StartPose>),
        design: Design,
        draws: Option<NonZeroU64>,
        (seed, measures): (u64, Vec<Measure>),
    ) -> Result<Self, SweepError> {
        check_columns(&varied, &measures)?;
        let Some(draws) = draws else {
            return Err(SweepError::Draws("the scene has uncertain values: --random N says how often".to_owned()));
        };
        let of_draws = draws.get().checked_mul(design.of_draw(varied.len()));
        let runs = accepted(of_draws.and_then(|own| own.checked_add(design.before_draws())))?;
        Ok(Self { varied, poses, design: Some(design), seed, measures, runs })
    }

    /// What is varied.
    pub fn varied(&self) -> &[Varied] {
        &self.varied
    }

    /// Whether it draws what the scene says is uncertain.
    pub fn is_uncertain(&self) -> bool {
        self.design.is_some()
    }

    /// Whether a value is drawn.
    pub fn is_drawn(&self) -> bool {
        self.varied.iter().any(|own| matches!(own.values, Values::Drawn(_)))
    }

    /// The seed of the draws.
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// Columns of a row between its number and its outcome.
    pub(super) fn leading(&self) -> usize {
        self.varied.len() + usize::from(self.design.is_some())
    }

    /// What a run is for, in a sweep of what is uncertain; a draw in another one.
    pub(super) fn part(&self, run: u64) -> Part {
        self.design.as_ref().map_or(Part::Draw(run), |design| design.part(run, self.varied.len()))
    }

    /// How many runs there are.
    pub fn runs(&self) -> u64 {
        self.runs
    }

    /// The runs of one of so many shards, counted from 1: a block, so that the tables of all shards in their order are
    /// the table.
    ///
    /// # Errors
    /// When there is no such shard.
    pub fn shard(&self, number: u64, of: u64) -> Result<Range<u64>, SweepError> {
        if number == 0 || number > of {
            return Err(SweepError::Shard(format!("{number}/{of}")));
        }
        let at = |shard: u64| (u128::from(self.runs) * u128::from(shard) / u128::from(of)) as u64;
        Ok(at(number - 1)..at(number))
    }

    /// What the table has of a run before its outcome: in a sweep of what is uncertain what it is for; its values.
    pub(super) fn leading_cells(&self, run: u64) -> Vec<String> {
        let part = self.design.as_ref().map(|_| self.part(run).word().to_owned());
        part.into_iter().chain(self.values(run)).collect()
    }

    /// The values of a run, as a scene has them, in the order in which the keys are varied.
    pub fn values(&self, run: u64) -> Vec<String> {
        if let Some(design) = &self.design {
            return design.values(&self.varied, self.seed, run);
        }
        let points: u64 = self.varied.iter().map(|own| own.values.count()).product();
        let mut point = run % points;
        let mut values: Vec<String> = self
            .varied
            .iter()
            .rev()
            .map(|own| match &own.values {
                Values::Drawn(drawn) => drawn.draw(self.seed, run, &own.key),
                Values::Listed(values) => {
                    let count = values.len() as u64;
                    let value = values[(point % count) as usize].clone();
                    point /= count;
                    value
                }
            })
            .collect();
        values.reverse();
        values
    }

    /// The changes of a run.
    pub fn changes(&self, run: u64) -> Vec<Override> {
        self.changes_of(self.values(run))
    }

    /// The changes that values of all keys are.
    fn changes_of(&self, values: Vec<String>) -> Vec<Override> {
        let mut moved = vec![[DVec3::ZERO; 2]; self.poses.len()];
        let mut changes = Vec::with_capacity(values.len());
        for (own, value) in self.varied.iter().zip(values) {
            let number = || value.parse().unwrap_or(f64::NAN);
            match &own.acts {
                Acts::Sets => changes.push(change(&own.key, value)),
                Acts::Shifts(bodies, axis) => bodies.iter().for_each(|body| moved[*body][0][*axis] = number()),
                Acts::Turns(bodies, axis) => bodies.iter().for_each(|body| moved[*body][1][*axis] = number()),
            }
        }
        let of_poses = self.poses.iter().zip(moved).flat_map(|(pose, [shift, turn])| pose.moved(shift, turn, ORIGIN));
        changes.extend(of_poses);
        changes
    }

    /// The names of the columns of the table.
    pub fn columns(&self) -> Vec<String> {
        let keys = self.varied.iter().map(|own| own.key.clone());
        let measures = self.measures.iter().map(|own| own.column.clone());
        let owned = |text: &str| text.to_owned();
        [owned(RUN)]
            .into_iter()
            .chain(self.design.as_ref().map(|_| owned(PART)))
            .chain(keys)
            .chain([OUTCOME, ERROR].map(owned))
            .chain(measures)
            .chain([owned(REASON)])
            .collect()
    }

    /// The names of what is measured.
    pub fn measures(&self) -> impl Iterator<Item = &str> {
        self.measures.iter().map(|own| own.column.as_str())
    }

    /// Checks, before anything is computed, that the scene takes the values of lists (200 of a longer one), and the
    /// middle of every distribution, each beside the first values of the other keys, and that it has what is measured.
    ///
    /// # Errors
    /// When it does not.
    pub fn check(&self, scene: &SweepScene<'_>) -> Result<(), SweepError> {
        let middle: Vec<String> = self.varied.iter().map(|own| own.values.middle()).collect();
        let loaded = scene.loaded(&self.changes_of(middle))?;
        self.measured_of(&loaded)?;
        if self.design.is_some() {
            return Ok(());
        }
        let first: Vec<Override> = self.varied.iter().map(|own| change(&own.key, own.values.middle())).collect();
        for (place, own) in self.varied.iter().enumerate() {
            let Values::Listed(values) = &own.values else { continue };
            let stride = values.len().div_ceil(MOST_CHECKED).max(1);
            for value in values.iter().step_by(stride).skip(1).chain(values.last()) {
                let mut changes = first.clone();
                changes[place] = change(&own.key, value);
                scene.loaded(&changes)?;
            }
        }
        Ok(())
    }

    /// What is measured, of a scene.
    pub(super) fn measured_of(&self, loaded: &LoadedScene) -> Result<Vec<Measured>, SweepError> {
        self.measures.iter().map(|own| own.of_scene(loaded)).collect()
    }

    /// What makes it this sweep and no other, in words; the number of draws does not.
    pub(super) fn told(&self) -> String {
        format!("{:?}", (self.seed, &self.varied, &self.poses, &self.design, &self.measures))
    }
}

/// The columns have different names.
fn check_columns(varied: &[Varied], measures: &[Measure]) -> Result<(), SweepError> {
    let mut columns: Vec<&str> = vec![RUN, PART, OUTCOME, ERROR, REASON];
    let keys = varied.iter().map(|own| own.key.as_str());
    for column in keys.chain(measures.iter().map(|own| own.column.as_str())) {
        if columns.contains(&column) {
            return Err(SweepError::Column(column.to_owned()));
        }
        columns.push(column);
    }
    Ok(())
}

/// A number of runs within the limits.
fn accepted(runs: Option<u64>) -> Result<u64, SweepError> {
    runs.filter(|runs| (1..=MOST_RUNS).contains(runs)).ok_or_else(|| {
        let runs = runs.map_or_else(|| "too many".to_owned(), |runs| runs.to_string());
        SweepError::Runs { runs, most: MOST_RUNS }
    })
}

impl Values {
    fn count(&self) -> u64 {
        match self {
            Self::Listed(values) => values.len() as u64,
            Self::Drawn(_) => 1,
        }
    }

    /// The first value of a list, or the middle of a distribution.
    pub(super) fn middle(&self) -> String {
        match self {
            Self::Listed(values) => values.first().cloned().unwrap_or_default(),
            Self::Drawn(drawn) => drawn.at(0.5),
        }
    }
}

#[cfg(test)]
mod tests {
    //! The runs of a sweep are all combinations, the first rows of more draws are those of fewer, and shards divide
    //! them.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;

    fn sweep(varied: &[&str], draws: u64) -> Result<Sweep, SweepError> {
        let varied = varied.iter().map(|text| Varied::parse(text).unwrap()).collect();
        Sweep::new(varied, NonZeroU64::new(draws), 1, vec![Measure::parse("top=max(b.position[2])")])
    }

    #[test]
    fn all_combinations_the_last_key_fastest() {
        let own = sweep(&["a=1,2", "b=x,y,z"], 0).unwrap();
        let all: Vec<String> = (0..own.runs()).map(|run| own.values(run).join(" ")).collect();
        assert_eq!(all, ["1 x", "1 y", "1 z", "2 x", "2 y", "2 z"]);
        assert_eq!(own.columns(), ["run", "a", "b", "outcome", "error", "top", "reason"]);
    }

    #[test]
    fn the_first_rows_of_more_draws_are_those_of_fewer() {
        let [few, many] = [3, 10].map(|draws| sweep(&["a=1,2", "b=normal(0, 1)"], draws).unwrap());
        assert_eq!((few.runs(), many.runs()), (6, 20));
        assert!((0..6).all(|run| few.values(run) == many.values(run)));
        assert!(few.values(0)[1] != few.values(2)[1]);
    }

    #[test]
    fn shards_divide_the_runs() {
        let own = sweep(&["a=1..2:10"], 0).unwrap();
        let mut next = 0;
        for number in 1..=4 {
            let shard = own.shard(number, 4).unwrap();
            assert_eq!(shard.start, next);
            next = shard.end;
        }
        assert_eq!(next, 10);
        assert!(own.shard(0, 4).is_err() && own.shard(5, 4).is_err() && own.shard(1, 0).is_err());
    }

    #[test]
    fn mistakes_are_told() {
        assert!(sweep(&["a=1,2", "a=3"], 0).is_err(), "a key twice");
        assert!(sweep(&["top=1,2"], 0).is_err(), "a key with the name of a measure");
        assert!(sweep(&["a=1,2"], 5).is_err(), "draws of nothing");
        assert!(sweep(&["a=1..2"], 0).is_err(), "no number of draws");
        assert!(sweep(&["a=1..2"], 1_000_000_000).is_err(), "too many");
        assert!(
            sweep(&["a=1..2:100000", "b=1..2:100000", "c=1..2:100000", "d=1..2:100000"], 0).is_err(),
            "far too many"
        );
    }
}

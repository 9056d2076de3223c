//! Shares of runs whose error is told too low or too high.

use super::judged::{Compared, Finding, Judged};
use polhode::scene::Tier;

/// A told error of at least this part of the true one is not too low, and one of at least [`FAR_TOO_LOW`] not far.
pub const TOO_LOW: f64 = 0.1;
/// Below this part it is far too low.
pub const FAR_TOO_LOW: f64 = 0.01;
/// Above so many times the true error it is too high.
pub const TOO_HIGH: f64 = 100.0;
/// What of the runs may not be too low, far too low, or too high.
pub const GOALS: [f64; 3] = [0.99, 1.0, 0.9];

/// Shares of some runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shares {
    /// Runs that are compared.
    pub compared: usize,
    /// Of those, the ones that tell no error.
    pub untold: usize,
    /// Parts that are not told too low, far too low, and too high.
    pub met: [f64; 3],
}

impl Shares {
    /// Of these runs.
    pub fn of<'a>(judged: impl Iterator<Item = &'a Judged>) -> Self {
        let all: Vec<&Compared> = judged.filter_map(Judged::compared).collect();
        let count = all.len();
        let part = |is_met: &dyn Fn(&Compared) -> bool| {
            if count == 0 { 1.0 } else { all.iter().filter(|one| is_met(one)).count() as f64 / count as f64 }
        };
        let met = [
            part(&|one| one.is_at_least(TOO_LOW)),
            part(&|one| one.is_at_least(FAR_TOO_LOW)),
            part(&|one| one.is_at_most(TOO_HIGH)),
        ];
        Self { compared: count, untold: all.iter().filter(|one| one.told.is_none()).count(), met }
    }
}

impl Judged {
    /// Its errors, where they could be compared.
    pub fn compared(&self) -> Option<&Compared> {
        if let Finding::Compared(compared) = &self.finding { Some(compared) } else { None }
    }

    /// How many times too low or too high what it tells is; 1 where it is neither.
    fn fault(&self) -> f64 {
        let Some(compared) = self.compared() else { return 1.0 };
        if !compared.is_at_least(TOO_LOW) {
            return compared.told.map_or(f64::INFINITY, |told| compared.truth / told);
        }
        if compared.is_at_most(TOO_HIGH) { 1.0 } else { compared.ratio().unwrap_or(1.0) / TOO_HIGH }
    }
}

/// The tiers that some runs are of, the most accurate first.
pub fn tiers(judged: &[Judged]) -> Vec<Tier> {
    Tier::ALL.into_iter().filter(|tier| judged.iter().any(|one| one.tier == *tier)).collect()
}

/// The runs that tell their errors worst, the worst first.
pub fn worst(judged: &[Judged], count: usize) -> Vec<&Judged> {
    let mut faulty: Vec<&Judged> = judged.iter().filter(|one| one.fault() > 1.0).collect();
    // What tells nothing at all stands last: it does not mislead.
    let key = |one: &Judged| if one.fault().is_finite() { one.fault() } else { 0.0 };
    faulty.sort_by(|a, b| key(b).total_cmp(&key(a)).then_with(|| a.name.cmp(&b.name)));
    faulty.truncate(count);
    faulty
}

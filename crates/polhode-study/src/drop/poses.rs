//! All throws together: the faces on which a body comes to rest, and how often.
//!
//! Of n throws k come to rest on a face: its share is `p = k/n`, with the standard error `sqrt(p (1 - p)/n)` of a
//! binomial distribution. Where k is 0 or n the error is that of one throw more that had ended otherwise.

use super::contact_time::ContactLaw;
use super::error::DropError;
use super::setting::Setting;
use super::throw::{Blow, Fate, Throw, Thrower};
use crate::sweep::MOST_RUNS;
use crate::threads::in_order;
use std::num::NonZeroUsize;

/// What is asked of the throws.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Throws {
    /// How many.
    pub count: u64,
    /// Seed of the attitudes: the attitude of a throw depends on it and on the number of the throw alone.
    pub seed: u64,
    /// Throws at a time; the result is the same for any number.
    pub workers: NonZeroUsize,
    /// Radius to which corners and edges are rounded, m: with it impacts have a duration.
    pub corner_radius_m: Option<f64>,
}

/// A quantity over all throws.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Spread {
    /// How many throws have it.
    pub count: u64,
    /// Its mean.
    pub mean: f64,
    /// The largest.
    pub most: f64,
    /// The number of the throw that has the largest.
    pub throw: u64,
    /// The sum of the squared deviations from the mean (Welford 1962).
    squares: f64,
}

impl Spread {
    fn add(&mut self, throw: u64, value: f64) {
        self.count += 1;
        let before = value - self.mean;
        self.mean += before / self.count as f64;
        self.squares += before * (value - self.mean);
        if self.count == 1 || value > self.most {
            (self.most, self.throw) = (value, throw);
        }
    }

    /// The standard error of the mean; none of one throw.
    pub fn standard_error(&self) -> Option<f64> {
        let count = self.count as f64;
        (self.count > 1).then(|| (self.squares / (count - 1.0) / count).sqrt())
    }
}

/// What has become of all throws.
#[derive(Debug, Clone, PartialEq)]
pub struct RestPoses {
    /// How many throws there were.
    pub throws: u64,
    /// How many came to rest on each face, in the order of [`Facets::list`](super::Facets::list).
    pub on: Vec<u64>,
    /// How many came to rest on no face alone.
    pub leaning: u64,
    /// How many still moved when their time had run out.
    pub moving: u64,
    /// How many failed.
    pub failed: u64,
    /// The first that failed, and why.
    pub reason: Option<(u64, String)>,
    /// The largest impulse of each throw, N s.
    pub impulse_ns: Spread,
    /// The greatest deceleration of each throw, m/s^2.
    pub deceleration: Spread,
    /// The blow with the greatest impulse, and that with the greatest deceleration.
    pub strongest: Option<Blow>,
    /// The hardest of all.
    pub hardest: Option<Blow>,
    /// When throws came to rest, s.
    pub end_s: Spread,
}

impl RestPoses {
    /// Throws the body of a setting. `take` is given each throw, in their order.
    ///
    /// # Errors
    /// When there are none or too many throws, contacts have no law over time, `take` fails, or it is stopped.
    pub fn of(
        setting: &Setting,
        throws: &Throws,
        is_stopped: &(dyn Fn() -> bool + Sync),
        mut take: impl FnMut(&Throw) -> Result<(), DropError>,
    ) -> Result<Self, DropError> {
        let Throws { count, seed, workers, corner_radius_m } = *throws;
        if !(1..=MOST_RUNS).contains(&count) {
            return Err(DropError::Throws { throws: count, most: MOST_RUNS });
        }
        let law = corner_radius_m.map(|radius_m| law(setting, radius_m)).transpose()?;
        let thrower = Thrower { setting, law, seed };
        let mut all = Self::none(setting);
        let thrown = |number| if is_stopped() { None } else { thrower.thrown(number, is_stopped) };
        in_order(0..count, workers, thrown, |throw: Throw| {
            all.add(&throw);
            take(&throw)
        })?;
        if all.throws < count { Err(DropError::Stopped { done: all.throws, all: count }) } else { Ok(all) }
    }

    fn none(setting: &Setting) -> Self {
        Self {
            throws: 0,
            on: vec![0; setting.facets().list().len()],
            leaning: 0,
            moving: 0,
            failed: 0,
            reason: None,
            impulse_ns: Spread::default(),
            deceleration: Spread::default(),
            strongest: None,
            hardest: None,
            end_s: Spread::default(),
        }
    }

    fn add(&mut self, throw: &Throw) {
        self.throws += 1;
        match &throw.fate {
            Fate::Rests(facet) => {
                if let Some(count) = self.on.get_mut(*facet) {
                    *count += 1;
                }
            }
            Fate::Leans => self.leaning += 1,
            Fate::Moves => self.moving += 1,
            Fate::Failed(why) => {
                self.failed += 1;
                self.reason.get_or_insert_with(|| (throw.number, why.clone()));
                return;
            }
        }
        if !matches!(throw.fate, Fate::Moves) {
            self.end_s.add(throw.number, throw.end_s);
        }
        if let Some(blow) = throw.strongest {
            self.impulse_ns.add(throw.number, blow.impulse_ns);
            if self.impulse_ns.throw == throw.number {
                self.strongest = Some(blow);
            }
        }
        if let Some((blow, deceleration)) = throw.hardest.and_then(|blow| Some((blow, blow.deceleration?))) {
            self.deceleration.add(throw.number, deceleration);
            if self.deceleration.throw == throw.number {
                self.hardest = Some(blow);
            }
        }
    }

    /// The share of all throws that some are.
    pub fn share(&self, count: u64) -> f64 {
        count as f64 / self.throws as f64
    }

    /// Its standard error.
    pub fn standard_error(&self, count: u64) -> f64 {
        let throws = self.throws as f64;
        let count = (count as f64).clamp(1.0_f64.min(0.5 * throws), (throws - 1.0).max(0.5 * throws));
        let share = count / throws;
        (share * (1.0 - share) / throws).sqrt()
    }
}

fn law(setting: &Setting, radius_m: f64) -> Result<ContactLaw, DropError> {
    let materials = setting.elastic();
    if materials.iter().all(Option::is_none) {
        return Err(DropError::Rigid);
    }
    if !(radius_m.is_finite() && radius_m > 0.0) {
        let (what, accepted) = ("the radius of corners (m)", "a positive, finite number");
        return Err(DropError::Number { what, value: radius_m, accepted });
    }
    Ok(ContactLaw::new(materials, radius_m, setting.contact_material().restitution())?)
}

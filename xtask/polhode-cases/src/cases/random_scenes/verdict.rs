//! The verdict on one random scene: how its run ends, which laws it breaks, and which copies are other runs.

use super::compare::{self, DISTURBED};
use super::trial::{Ending, Trial};
use glam::DVec3;
use polhode::Effects;
use polhode_oracles::judge::{Finding, judge};
use polhode_oracles::random::Random;
use polhode_oracles::random_scene::copies::SceneCopy;
use polhode_oracles::random_scene::model::Model;
use polhode_oracles::random_scene::reader;
use std::error::Error;
use std::fmt;
use std::path::Path;

/// How many kinds of copies are run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Copies {
    /// One, which goes round with the seed.
    One,
    /// All.
    All,
}

/// What is found about a scene.
#[derive(Debug)]
pub struct Verdict {
    /// The seed of the scene.
    pub seed: u64,
    ending: Ending,
    laws: Vec<Finding>,
    /// Copies that are other runs, in words.
    copies: Vec<String>,
    /// Copies that are other runs since one of the two has told that its laws allow several motions.
    told: Vec<String>,
    /// Steps of the run.
    pub steps: u64,
    /// Wall time of the run, s.
    pub wall_s: f64,
}

impl Verdict {
    /// Of a scene.
    ///
    /// # Errors
    /// When files cannot be written.
    pub fn of(model: &Model, copies: Copies) -> Result<Self, Box<dyn Error>> {
        let trial = Trial::of(model, Effects::Planned, None)?;
        let mut verdict = Self {
            seed: model.seed,
            ending: trial.ending.clone(),
            laws: Vec::new(),
            copies: Vec::new(),
            told: Vec::new(),
            steps: trial.steps,
            wall_s: trial.wall_s,
        };
        if trial.ending == Ending::Completed {
            verdict.laws = judge(model, &trial.track);
            verdict.compare(model, &trial, copies)?;
        }
        Ok(verdict)
    }

    /// Of a scene file, without copies.
    ///
    /// # Errors
    /// When it cannot be read, or the judge does not know what is in it.
    pub fn of_file(path: &Path) -> Result<Self, Box<dyn Error>> {
        let text = std::fs::read_to_string(path)?;
        let mut model = reader::model(&text)?;
        let trial = Trial::of_text(path, &text, Effects::Planned, None);
        model.interval = trial.track.times.get(1).copied().unwrap_or_default();
        let laws = if trial.ending == Ending::Completed { judge(&model, &trial.track) } else { Vec::new() };
        let (steps, wall_s) = (trial.steps, trial.wall_s);
        Ok(Self { seed: 0, ending: trial.ending, laws, copies: Vec::new(), told: Vec::new(), steps, wall_s })
    }

    fn compare(&mut self, model: &Model, trial: &Trial, copies: Copies) -> Result<(), Box<dyn Error>> {
        let mut random = Random(model.seed);
        let turned = SceneCopy::Turned(random.between(0.1, 3.0));
        let power = random.one_of(&[-3, -1, 2, 5]);
        let scaled = SceneCopy::Scaled { power, mass_power: random.one_of(&[-2, 0, 3]) };
        let moved = SceneCopy::Moved(DVec3::new(0.25, -0.5, 0.0));
        let kind = model.seed % 6;
        let is_run = |number: u64| copies == Copies::All || kind == number;
        if is_run(0) {
            self.same_bits(model, trial, scaled)?;
        }
        if is_run(1) {
            let pause = random.between(0.1, 0.9) * model.duration;
            self.paused(model, trial, pause)?;
        }
        if kind < 2 && copies == Copies::One {
            return Ok(());
        }
        let disturbance = SceneCopy::Disturbed(DISTURBED);
        let disturbed = Trial::of(&disturbance.of(model), Effects::Planned, None)?;
        let grown = compare::differences(model, disturbance, &trial.track, &disturbed.track);
        let mut hold = |name: &str, copy: SceneCopy, other: &Trial| {
            let found = compare::differences(model, copy, &trial.track, &other.track);
            let is_crowded = trial.track.account.is_crowded || other.track.account.is_crowded;
            let choices = [trial, other].map(|run| run.track.account.first_choice_s);
            if let Some((sample, apart)) = compare::departure(&found, &grown, is_crowded) {
                let (t, grown) = (trial.track.times[sample], grown[sample]);
                let what = format!("{name}: {apart:.1e} at t = {t} s (disturbed {grown:.1e})");
                let is_told = choices.into_iter().flatten().any(|choice_s| choice_s <= t);
                if is_told { self.told.push(what) } else { self.copies.push(what) }
            }
            match (&other.ending, &trial.ending) {
                (one, two) if one == two => {}
                (Ending::Refused(why), _) => self.copies.push(format!("{name}: refused: {}", first_line(why))),
                (Ending::Panicked, _) => self.copies.push(format!("{name}: panics")),
                _ => {}
            }
        };
        for (number, copy) in [(2, SceneCopy::Mirrored), (3, turned), (4, moved)] {
            if is_run(number) {
                hold(copy.name(), copy, &Trial::of(&copy.of(model), Effects::Planned, None)?);
            }
        }
        if is_run(5) {
            let all = Trial::of(model, Effects::All, None)?;
            hold("all effects", SceneCopy::Disturbed(0.0), &all);
        }
        Ok(())
    }

    /// A copy in other units has the same bits.
    fn same_bits(&mut self, model: &Model, trial: &Trial, copy: SceneCopy) -> Result<(), Box<dyn Error>> {
        let other = Trial::of(&copy.of(model), Effects::Planned, None)?;
        let found = compare::differences(model, copy, &trial.track, &other.track);
        if let Some(sample) = found.iter().position(|&apart| apart > 0.0) {
            let (t, last) = (trial.track.times[sample], found.last().copied().unwrap_or_default());
            self.copies.push(format!("{copy:?}: {:.1e} at t = {t} s, {last:.1e} at the end", found[sample]));
        }
        if found.len() < trial.track.times.len() || matches!(other.ending, Ending::Refused(_) | Ending::Panicked) {
            self.copies.push(format!("{copy:?}: ends otherwise: {:?}", other.ending));
        }
        Ok(())
    }

    /// A run that is paused, kept and continued has the same bits.
    fn paused(&mut self, model: &Model, trial: &Trial, pause: f64) -> Result<(), Box<dyn Error>> {
        let other = Trial::of(model, Effects::Planned, Some(pause))?;
        let found = compare::differences(model, SceneCopy::Disturbed(0.0), &trial.track, &other.track);
        let is_other = found.iter().any(|&apart| apart > 0.0) || found.len() < trial.track.times.len();
        if is_other {
            let last = found.last().copied().unwrap_or_default();
            self.copies.push(format!("paused at t = {pause} s: {last:.1e} at the end, {:?}", other.ending));
        }
        Ok(())
    }

    /// Whether it ends well, breaks no law, and its copies are the same runs.
    pub fn is_right(&self) -> bool {
        self.ending == Ending::Completed && self.laws.is_empty() && self.copies.is_empty()
    }

    /// Whether it ends well and breaks a law.
    pub(super) fn breaks_a_law(&self) -> bool {
        !self.laws.is_empty()
    }

    /// Whether a copy of it is another run, which was told.
    pub(super) fn is_one_of_several(&self) -> bool {
        !self.told.is_empty()
    }

    /// Whether a copy of it is another run.
    pub(super) fn differs(&self) -> bool {
        !self.copies.is_empty()
    }

    /// Whether it panics.
    pub(super) fn panics(&self) -> bool {
        self.ending == Ending::Panicked
    }

    /// Whether the scene is not taken.
    pub(super) fn is_refused(&self) -> bool {
        matches!(self.ending, Ending::Refused(_))
    }

    /// Whether it ends degraded or with an error.
    pub(super) fn fails(&self) -> bool {
        matches!(self.ending, Ending::Degraded(_) | Ending::Failed(_))
    }

    /// Whether it takes very many steps.
    pub(super) fn is_slow(&self) -> bool {
        matches!(self.ending, Ending::Slow(_))
    }

    /// Whether it takes long on this machine.
    pub(super) fn is_late(&self) -> bool {
        matches!(self.ending, Ending::Late(_))
    }
}

fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {:.1} s, {} steps: ", self.seed, self.wall_s, self.steps)?;
        match &self.ending {
            Ending::Completed => write!(f, "completed")?,
            Ending::Degraded(why) => write!(f, "degraded: {}", first_line(why))?,
            Ending::Failed(why) => write!(f, "failed: {}", first_line(why))?,
            Ending::Refused(why) => write!(f, "refused: {}", why.replace('\n', " "))?,
            Ending::Slow(why) => write!(f, "slow: {why}")?,
            Ending::Late(why) => write!(f, "late: {why}")?,
            Ending::Panicked => write!(f, "panics")?,
        }
        for Finding { law, what, of_limit } in &self.laws {
            write!(f, "; {law} ({of_limit:.1e} of its limit): {what}")?;
        }
        self.told.iter().try_for_each(|copy| write!(f, "; copy {copy}, as told"))?;
        self.copies.iter().try_for_each(|copy| write!(f, "; copy {copy}"))
    }
}

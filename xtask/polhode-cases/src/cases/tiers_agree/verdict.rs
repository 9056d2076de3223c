//! The opinions of the tiers on one scene.

use super::subject::{Copy, Subject};
use super::trial::{Ending, Trial};
use polhode_oracles::judge::tiers::Standard;
use std::fmt;

/// Distance of copies that is allowed in runs with stretches of crowded events, in which errors of 1e-6 are allowed and
/// told, in bodies.
const CROWDED: f64 = 1e-4;
/// Distance of copies of runs by fixed steps, in bodies.
const STEPPED_COPY: f64 = 1e-8;
/// Copies as near as this are one motion to rounding, in bodies: warnings of accuracy are then needless.
const ROUNDING: f64 = 1e-12;
/// The longest step of the tier `fast`, in those of `stepped`.
pub(super) const FAST_STEPS: f64 = 5.0;
/// What the tier `fast` promises: overlap and gap of joints in parts of the smallest body.
const FAST_OVERLAP: f64 = 0.1;
const FAST_GAP: f64 = 1e-2;
/// Rows of steps: halves of the longest one; further ones where the first three do not agree.
const HALVES: [i32; 4] = [0, 1, 2, 4];
const FIRST_HALVES: usize = 3;

/// What is found of a tier on a scene.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Opinion {
    /// Right; the order of the error, where it is known.
    Right(f64),
    /// The run said itself that it is not to be trusted, or failed.
    Told(String),
    /// It ended well and is wrong.
    Wrong(String),
    /// It ended well, and the same scene set otherwise in the world is another motion.
    Differs(String),
    /// Not judged: why.
    Unjudged(String),
    /// The tier does not take such a scene.
    Refused(String),
    /// Ended after many steps or a long time.
    Late,
    /// Not asked for.
    None,
}

/// Takes the opinion on one tier.
pub(super) type OfTier = fn(&Verdict) -> &Opinion;

/// The tiers that are judged.
pub(super) const TIERS: [(&str, OfTier); 3] =
    [("accurate", |v| &v.accurate), ("stepped", |v| &v.stepped), ("fast", |v| &v.fast)];

/// What is found of a scene.
#[derive(Debug)]
pub(super) struct Verdict {
    pub(super) seed: u64,
    pub(super) kind: &'static str,
    pub(super) accurate: Opinion,
    pub(super) stepped: Opinion,
    pub(super) fast: Opinion,
    /// Warnings of the accurate run.
    pub(super) warnings: Vec<String>,
    /// Whether the accurate run warned or was degraded although its copies are one motion to rounding.
    pub(super) is_needless: bool,
    pub(super) seconds: f64,
}

impl Verdict {
    /// The opinions on a scene.
    pub(super) fn of(subject: &Subject, with_fast: bool) -> Self {
        let mut verdict = Self {
            seed: subject.seed(),
            kind: subject.kind(),
            accurate: Opinion::None,
            stepped: Opinion::None,
            fast: Opinion::None,
            warnings: Vec::new(),
            is_needless: false,
            seconds: 0.0,
        };
        let accurate = verdict.run(subject, Copy::None, "accurate", None);
        verdict.warnings.clone_from(&accurate.warnings);
        let early = match &accurate.ending {
            Ending::Completed | Ending::Degraded(_) => None,
            ending => Some(ended(ending)),
        };
        if let Some(opinion) = early {
            verdict.accurate = opinion;
            return verdict;
        }
        let disturbed = verdict.run(subject, Copy::Disturbed, "accurate", None);
        let copy = verdict.run(subject, Copy::Placed, "accurate", None);
        let standard = Standard::new(subject.sizes(), accurate.poses.clone(), &disturbed.poses);
        verdict.accurate = of_accurate(subject, &accurate, &copy, &standard);
        verdict.is_needless = (!accurate.warnings.is_empty() || !accurate.is_well())
            && copy.poses.rows.len() == accurate.poses.rows.len()
            && standard.distance(&copy.poses) < ROUNDING;
        if !matches!(verdict.accurate, Opinion::Right(_)) {
            verdict.stepped = Opinion::Unjudged("the accurate run is no standard".to_owned());
            return verdict;
        }
        verdict.stepped = verdict.of_steps(subject, &standard, "stepped", subject.step_s());
        if with_fast {
            verdict.fast = verdict.of_steps(subject, &standard, "fast", FAST_STEPS * subject.step_s());
        }
        verdict
    }

    fn run(&mut self, subject: &Subject, copy: Copy, tier: &str, step_s: Option<f64>) -> Trial {
        let trial = Trial::of(subject, copy, tier, step_s);
        self.seconds += trial.seconds;
        trial
    }

    /// The opinion on a tier of fixed steps.
    fn of_steps(&mut self, subject: &Subject, standard: &Standard, tier: &str, longest_s: f64) -> Opinion {
        let is_fast = tier == "fast";
        let is_smooth = subject.is_smooth() && !is_fast;
        let mut runs: Vec<(f64, Trial)> = Vec::new();
        let mut told = None;
        let mut found = None;
        for (number, halves) in HALVES.into_iter().enumerate() {
            let step_s = longest_s * 0.5_f64.powi(halves);
            let trial = self.run(subject, Copy::None, tier, Some(step_s));
            match &trial.ending {
                Ending::Completed => {
                    if is_fast && let Some(broken) = broken_promise(&trial, &subject.sizes()) {
                        return Opinion::Wrong(format!("step {step_s} s: {broken}"));
                    }
                    runs.push((step_s, trial));
                }
                Ending::Degraded(why) | Ending::Failed(why) => {
                    told.get_or_insert_with(|| format!("step {step_s} s: {}", first_line(why)));
                }
                ending => return ended(ending),
            }
            if number + 1 < FIRST_HALVES {
                continue;
            }
            let poses: Vec<_> = runs.iter().map(|(step_s, trial)| (*step_s, &trial.poses)).collect();
            if poses.len() < 2 {
                break;
            }
            let Some(convergence) = standard.convergence(&poses) else {
                return Opinion::Unjudged("beyond the horizon at once".to_owned());
            };
            let is_right = convergence.is_right(is_smooth);
            found = Some((convergence, is_right));
            if is_right {
                break;
            }
        }
        let Some((convergence, is_right)) = found else { return Opinion::Told(told.unwrap_or_default()) };
        let order = convergence.order();
        if !is_right {
            let errors: Vec<String> = convergence.errors.iter().map(|(h, e)| format!("{h}: {e:.2e}")).collect();
            return Opinion::Wrong(format!(
                "distance of {} from accurate by step: {}; bound {:.1e}, growth {:.1}, order {order:.2}, {} samples",
                subject.name(convergence.body),
                errors.join(", "),
                convergence.bound,
                convergence.growth,
                convergence.judged
            ));
        }
        if let Some(told) = told {
            return Opinion::Told(told);
        }
        if is_fast { Opinion::Right(order) } else { self.of_copy(subject, standard, &runs[0], order) }
    }

    /// The opinion on the copy of a run by fixed steps.
    fn of_copy(&mut self, subject: &Subject, standard: &Standard, run: &(f64, Trial), order: f64) -> Opinion {
        let (step_s, original) = run;
        let copy = self.run(subject, Copy::Placed, "stepped", Some(*step_s));
        if !copy.is_well() {
            return Opinion::Differs(format!("set otherwise in the world it ends otherwise: {:?}", copy.ending));
        }
        let disturbed = self.run(subject, Copy::Disturbed, "stepped", Some(*step_s));
        let own = Standard::new(subject.sizes(), original.poses.clone(), &disturbed.poses);
        match (
            standard.with(original.poses.clone()).departure(&copy.poses, STEPPED_COPY),
            own.departure(&copy.poses, STEPPED_COPY),
        ) {
            (Some(_), Some((sample, far, body))) => Opinion::Differs(format!(
                "set otherwise in the world {} is {far:.1e} off at sample {sample}",
                subject.name(body)
            )),
            _ => Opinion::Right(order),
        }
    }
}

/// The opinion on a run that gave no motion.
fn ended(ending: &Ending) -> Opinion {
    match ending {
        Ending::Refused(why) => Opinion::Refused(why.replace('\n', " ")),
        Ending::Late => Opinion::Late,
        Ending::Panicked => Opinion::Wrong("a panic".to_owned()),
        Ending::Failed(why) | Ending::Degraded(why) => Opinion::Told(first_line(why).to_owned()),
        Ending::Completed => Opinion::None,
    }
}

fn of_accurate(subject: &Subject, accurate: &Trial, copy: &Trial, standard: &Standard) -> Opinion {
    if let Ending::Degraded(why) = &accurate.ending {
        return Opinion::Told(first_line(why).to_owned());
    }
    if copy.poses.rows.len() < accurate.poses.rows.len() {
        return Opinion::Differs(format!("set otherwise in the world it ends otherwise: {:?}", copy.ending));
    }
    let floor = if accurate.is_crowded || copy.is_crowded { CROWDED } else { 0.0 };
    let Some((sample, far, body)) = standard.departure(&copy.poses, floor) else {
        return Opinion::Right(f64::INFINITY);
    };
    let off = format!("set otherwise in the world {} is {far:.1e} off at sample {sample}", subject.name(body));
    let warned = accurate.warnings.iter().find(|warning| warning.contains("depends on that choice")).cloned();
    match accurate.choices.first().map(ToString::to_string).or(warned) {
        Some(why) => Opinion::Told(format!("{off}; {why}")),
        None => Opinion::Differs(off),
    }
}

/// What a run of the tier `fast` has broken of its promise.
fn broken_promise(trial: &Trial, sizes: &[f64]) -> Option<String> {
    let smallest = sizes.iter().copied().fold(f64::INFINITY, f64::min);
    let overlap = trial.certificate.max_penetration_m.max(trial.certificate.max_sample_penetration_m) / smallest;
    let gap = trial.certificate.max_joint_error_m.unwrap_or_default() / smallest;
    let broken = |what: &str, part: f64, most: f64| {
        (part > most).then(|| format!("{what} of {part:.2e} of the smallest body, more than {most}"))
    };
    broken("an overlap", overlap, FAST_OVERLAP).or_else(|| broken("a joint gap", gap, FAST_GAP))
}

fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}

impl Opinion {
    /// Whether it ended well and is wrong, or another motion set otherwise.
    pub(super) fn is_wrong(&self) -> bool {
        matches!(self, Self::Wrong(_) | Self::Differs(_))
    }

    /// One word for it.
    pub(super) fn word(&self) -> &'static str {
        match self {
            Self::Right(_) => "right",
            Self::Told(_) => "told",
            Self::Wrong(_) => "wrong",
            Self::Differs(_) => "differs",
            Self::Unjudged(_) => "unjudged",
            Self::Refused(_) => "refused",
            Self::Late => "late",
            Self::None => "-",
        }
    }
}

impl fmt::Display for Opinion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.word())?;
        match self {
            Self::Right(order) if order.is_finite() => write!(f, " (order {order:.2})"),
            Self::Told(why) | Self::Wrong(why) | Self::Differs(why) | Self::Unjudged(why) | Self::Refused(why) => {
                write!(f, ": {why}")
            }
            _ => Ok(()),
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} ({:.2} s)", self.seed, self.kind, self.seconds)?;
        for (tier, of_tier) in TIERS {
            let opinion = of_tier(self);
            if !matches!(opinion, Opinion::Right(_) | Opinion::None) {
                write!(f, "\n    {tier} {opinion}")?;
            }
        }
        Ok(())
    }
}

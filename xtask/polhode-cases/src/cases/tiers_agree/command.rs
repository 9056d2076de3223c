//! The command that judges tiers by each other: a line for each scene that is not right, and a table by kind.

use super::subject::{Copy, Subject};
use super::verdict::{FAST_STEPS, Opinion, TIERS, Verdict};
use super::{ALL, Choice, FAST_OF_ALL, FEW, verdicts};
use clap::Args;
use polhode_oracles::random_mechanism::generate::KINDS;
use std::collections::BTreeMap;
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

/// What the command takes.
#[derive(Debug, Args)]
#[allow(clippy::struct_excessive_bools, reason = "each is a switch of the command line")]
pub struct Options {
    /// Tiers are judged by each other; the only kind of judgement so far.
    #[arg(long)]
    tiers: bool,
    /// First seed.
    #[arg(long, default_value_t = 0)]
    first: u64,
    /// Number of seeds.
    #[arg(long)]
    count: Option<u64>,
    /// As many as a full verification judges.
    #[arg(long)]
    full: bool,
    /// Only kinds whose name contains this.
    #[arg(long)]
    kind: Option<String>,
    /// Pieces of the random scenes of contacts in the place of mechanisms.
    #[arg(long)]
    scenes: bool,
    /// Look at the tier `fast` at every scene.
    #[arg(long)]
    fast: bool,
    /// Print the warnings of accurate runs, and how often they come.
    #[arg(long)]
    warnings: bool,
    /// Print what is right, too.
    #[arg(long)]
    all: bool,
    /// Threads.
    #[arg(long, default_value_t = 1)]
    threads: usize,
    /// Write the scene of a seed to a file instead, for the tier stepped at the longest step.
    #[arg(long, num_args = 2, value_names = ["SEED", "FILE"])]
    write: Vec<String>,
    /// The tier that is written.
    #[arg(long, default_value = "stepped")]
    tier: String,
    /// Write the scene as it is set otherwise in the world.
    #[arg(long)]
    placed: bool,
}

/// Runs the command.
///
/// # Errors
/// When a file cannot be written.
pub fn run(options: &Options) -> Result<ExitCode, Box<dyn Error>> {
    if let [seed, file] = options.write.as_slice() {
        let subject = Subject::of(seed.parse()?, options.scenes);
        let step_s = match options.tier.as_str() {
            "accurate" => None,
            "fast" => Some(FAST_STEPS * subject.step_s()),
            _ => Some(subject.step_s()),
        };
        let copy = if options.placed { Copy::Placed } else { Copy::None };
        subject.text(copy, &options.tier, step_s).write(&PathBuf::from(file))?;
        return Ok(ExitCode::SUCCESS);
    }
    if !options.tiers {
        return Err("say what is judged: --tiers".into());
    }
    let count = options.count.unwrap_or(if options.full { ALL } else { FEW });
    let is_meant = |seed: &u64| {
        let kind = KINDS[(seed % KINDS.len() as u64) as usize].name;
        options.scenes || options.kind.as_ref().is_none_or(|word| kind.contains(word.as_str()))
    };
    let choice = Choice {
        seeds: (options.first..options.first + count).filter(is_meant).collect(),
        is_scene: options.scenes,
        fast_of: if options.fast {
            1
        } else if options.full {
            FAST_OF_ALL
        } else {
            0
        },
    };
    let found = verdicts(&choice, options.threads, |verdict| {
        let opinions = [&verdict.accurate, &verdict.stepped, &verdict.fast];
        if options.all || opinions.into_iter().any(|opinion| !matches!(opinion, Opinion::Right(_) | Opinion::None)) {
            println!("{verdict}");
        }
    });
    table(&found);
    if options.warnings {
        warnings(&found);
    }
    Ok(ExitCode::SUCCESS)
}

/// The table by kind.
fn table(verdicts: &[Verdict]) {
    let words = ["right", "told", "wrong", "differs", "unjudged", "refused", "late"];
    println!("{:30} {:>5} {:>7}  right/told/wrong/differs/unjudged/refused/late", "kind", "count", "s");
    let mut kinds: BTreeMap<&str, Vec<&Verdict>> = BTreeMap::new();
    for verdict in verdicts {
        kinds.entry(verdict.kind).or_default().push(verdict);
        kinds.entry("~ all").or_default().push(verdict);
    }
    for (kind, all) in kinds {
        let seconds: f64 = all.iter().map(|v| v.seconds).sum();
        let counts = TIERS.map(|(tier, opinion)| {
            let counts = words.map(|word| all.iter().filter(|v| opinion(v).word() == word).count().to_string());
            let mut orders: Vec<f64> = all
                .iter()
                .filter_map(|v| if let Opinion::Right(order) = opinion(v) { Some(*order) } else { None })
                .filter(|order| order.is_finite())
                .collect();
            orders.sort_by(f64::total_cmp);
            let order = orders.get(orders.len() / 2).map_or(String::new(), |order| format!(" order {order:.2}"));
            format!("{tier} {}{order}", counts.join("/"))
        });
        println!("{kind:30} {:5} {seconds:7.2}  {}", all.len(), counts.join("; "));
    }
    let needless = verdicts.iter().filter(|v| v.is_needless).count();
    println!("accurate warns or is degraded although copies agree to rounding: {needless}");
}

/// Warnings without their numbers and names, and how often they come.
fn warnings(verdicts: &[Verdict]) {
    let mut found: BTreeMap<String, Vec<(u64, bool)>> = BTreeMap::new();
    for verdict in verdicts {
        for warning in &verdict.warnings {
            let mut quoted = false;
            let words: String = warning
                .chars()
                .filter(|c| {
                    quoted ^= *c == '"';
                    !quoted && !c.is_ascii_digit()
                })
                .take(160)
                .collect();
            found.entry(words).or_default().push((verdict.seed, verdict.is_needless));
        }
    }
    let warned = verdicts.iter().filter(|v| !v.warnings.is_empty()).count();
    println!("{warned} of {} accurate runs warn", verdicts.len());
    for (words, seeds) in found {
        let needless: Vec<u64> = seeds.iter().filter(|(_, is_needless)| *is_needless).map(|(seed, _)| *seed).collect();
        let all: Vec<u64> = seeds.iter().map(|(seed, _)| *seed).take(6).collect();
        println!("{:4} ({} needless: {needless:?}; all {all:?}) {words}", seeds.len(), needless.len());
    }
}

//! Tiers as second opinions on each other: random mechanisms and small piles are computed by the tier `accurate`, and
//! by the tiers of fixed steps at steps h, h/2 and h/4, which must go to the accurate motion with the order that they
//! promise.
//!
//! The accurate run itself must be that of the same scene turned, moved and with its bodies in another order. How far
//! apart runs may be is measured by one that starts a little elsewhere. What a run says of itself counts: one that is
//! degraded is not wrong. The judge is `xtask/polhode-oracles/src/judge/tiers.rs`, the scenes are
//! `xtask/polhode-oracles/src/random_mechanism` and `xtask/polhode-oracles/src/random_scene`.
//!
//! | module | holds |
//! |---|---|
//! | `command` | the command that judges tiers by each other |
//! | `subject` | a scene that several tiers compute |
//! | `trial` | one run of a scene by one tier |
//! | `verdict` | the opinions of the tiers on one scene |

mod command;
mod subject;
mod trial;
mod verdict;

use super::context::Amount;
use super::{CaseResult, Context};
use crate::row::Row;
pub use command::{Options, run};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use subject::Subject;
use verdict::{Opinion, TIERS, Verdict};

const CASE: &str = "tiers agree";
/// Mechanisms of a plain run, and of a full one.
const FEW: u64 = 200;
const ALL: u64 = 5000;
/// Of so many the tier `fast` is looked at as well: one in this number of a plain run, and of a full one. No divisor of
/// the number of kinds, so that all of them come.
const FAST_OF_FEW: u64 = 3;
const FAST_OF_ALL: u64 = 9;

/// What is judged.
#[derive(Debug, Clone)]
struct Choice {
    seeds: Vec<u64>,
    is_scene: bool,
    /// The tier `fast` is looked at where the place in the row is a multiple of this; zero: nowhere.
    fast_of: u64,
}

/// The verdicts on some seeds, by one thread for each processor; `each` is called as they come.
fn verdicts(choice: &Choice, threads: usize, each: impl Fn(&Verdict) + Sync) -> Vec<Verdict> {
    let next = AtomicU64::new(0);
    let all: Mutex<Vec<Verdict>> = Mutex::default();
    std::thread::scope(|scope| {
        for _ in 0..threads.max(1) {
            scope.spawn(|| {
                loop {
                    let place = next.fetch_add(1, Ordering::Relaxed);
                    let Some(&seed) = choice.seeds.get(place as usize) else { break };
                    let with_fast = choice.fast_of > 0 && place.is_multiple_of(choice.fast_of);
                    let verdict = Verdict::of(&Subject::of(seed, choice.is_scene), with_fast);
                    each(&verdict);
                    if let Ok(mut all) = all.lock() {
                        all.push(verdict);
                    }
                }
            });
        }
    });
    let mut verdicts = all.into_inner().unwrap_or_default();
    verdicts.sort_by_key(|verdict| verdict.seed);
    verdicts
}

/// Tiers are held against each other.
#[allow(clippy::unnecessary_wraps, reason = "cases give a result")]
pub(super) fn rows(context: &Context) -> CaseResult {
    let (count, fast_of) = match context.amount {
        Amount::Full => (ALL, FAST_OF_ALL),
        Amount::Part => (FEW, FAST_OF_FEW),
    };
    let choice = Choice { seeds: (0..count).collect(), is_scene: false, fast_of };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let verdicts = verdicts(&choice, threads, |verdict| {
        if [&verdict.accurate, &verdict.stepped, &verdict.fast].into_iter().any(Opinion::is_wrong) {
            eprintln!("{CASE}: {verdict}");
        }
    });
    let mut rows = Vec::new();
    for (tier, opinion) in TIERS {
        let number = |word: &str| verdicts.iter().filter(|v| opinion(v).word() == word).count();
        let asked = verdicts.len() - number("-");
        for (word, what) in [("wrong", "wrong and well"), ("differs", "other motions set otherwise in the world")] {
            if tier != "fast" || word == "wrong" {
                let named = format!("{tier}: {what}, of {asked} mechanisms");
                rows.push(Row::at_most(CASE, &named, 0.0, number(word) as f64));
            }
        }
        let told = [number("right"), number("told"), number("unjudged"), number("refused"), number("late")];
        let told = told.map(|number| number as f64);
        rows.push(Row::info(CASE, &format!("{tier}: right, told, unjudged, refused, late, of {asked}"), "", told));
    }
    let refused = verdicts.iter().filter(|v| v.accurate.word() == "refused").count() as f64;
    rows.push(Row::at_most(CASE, &format!("refused by accurate, of {count} mechanisms"), 0.0, refused));
    let needless = verdicts.iter().filter(|v| v.is_needless).count() as f64;
    rows.push(Row::info(CASE, "accurate: warns or is degraded, and copies agree to 1e-12", "", needless));
    rows.push(Row::info(
        CASE,
        "time that the runs take, one after the other, s",
        "",
        verdicts.iter().map(|v| v.seconds).sum::<f64>(),
    ));
    Ok(rows)
}

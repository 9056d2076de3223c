//! Golden trajectories: one snapshot for each scene that the project ships.
//!
//! A snapshot (`fixtures/golden/<scene>.snap`, written and read by insta) holds about twenty samples of all bodies,
//! the final energies, the number of events of each kind, and a strict hash of all bits of all samples and events.
//! Numbers are compared within the tolerance that stands, with its reason, in the description of the snapshot; the
//! hash is compared exactly, so that a change of a single bit shows.
//!
//! | module | holds |
//! |---|---|
//! | `trajectory` | a run as readable text |
//! | `comparator` | two texts compared number by number |
//! | `still` | pictures of scenes, compared pixel by pixel |

mod comparator;
mod still;
mod trajectory;

pub(crate) use still::{GoldenStill, STILLS};
pub(crate) use trajectory::number as short_number;

use comparator::{Comparison, DEFAULT_DESCRIPTION, ToleranceComparator};
use polhode::Effects;
use polhode_cases::row::{Row, Tolerance};
use polhode_cases::snapshot_environment::is_blessed;
use polhode_cases::{CaseResult, Context, Run, guarded};
use std::error::Error;
use std::path::Path;
use strict_hash::{hash_words, strict_hash};

/// Folder of the snapshots in the workspace.
const FOLDER: &str = "fixtures/golden";

/// Name of the case for a scene.
pub(crate) fn case_name(scene: &str) -> String {
    format!("golden {scene}")
}

/// The strict hash in the snapshot of a scene.
///
/// # Errors
/// When there is no snapshot, or no hash in it.
pub(crate) fn stored_hash(root: &Path, scene: &str) -> Result<u64, Box<dyn Error>> {
    let file = root.join(FOLDER).join(format!("{scene}.snap"));
    let snapshot = insta::Snapshot::from_file(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    let words = snapshot.as_text().map(ToString::to_string).as_deref().and_then(trajectory::hash_in);
    let hash = words.and_then(|words| u64::from_str_radix(&words, 16).ok());
    Ok(hash.ok_or_else(|| format!("{} has no strict hash: bless it anew", file.display()))?)
}

/// Runs a scene twice and compares it with its snapshot; under `--bless` the snapshot is rewritten.
pub(crate) fn check(context: &Context, scene: &str) -> Vec<Row> {
    let case = case_name(scene);
    guarded(&case, || compare(context, scene, &case))
}

fn compare(context: &Context, scene: &str, case: &str) -> CaseResult {
    let first = context.shipped.run(scene)?;
    let second = Run::of(&first.scene, Effects::Planned)?;
    let hash = strict_hash(&first.record);
    let again = strict_hash(&second.record);
    let mut rows = vec![Row::exact(case, "same bits when run twice", hash_words(hash), hash_words(again))];
    let folder = context.root.join(FOLDER);
    let comparison = snapshot(&folder, scene, &trajectory::text(&first, hash))?;
    let blessed = is_blessed();
    rows.extend(match comparison {
        None if blessed => vec![Row::info(case, "written for the first time", "", "")],
        None => {
            vec![Row::broken(case, "snapshot", "missing: run cargo xtask verify --bless and look at what it writes")]
        }
        Some(found) if blessed => blessed_rows(case, &found),
        Some(found) => judged_rows(case, &found, hash),
    });
    Ok(rows)
}

fn blessed_rows(case: &str, found: &Comparison) -> Vec<Row> {
    let change = found.mismatch.clone().unwrap_or_else(|| found.place.clone());
    vec![Row::info(case, "largest change, of max(1, |number|)", 0.0, found.error), Row::info(case, "where", "", change)]
}

fn judged_rows(case: &str, found: &Comparison, hash: u64) -> Vec<Row> {
    let trajectory = if let Some(mismatch) = &found.mismatch {
        Row::broken(case, "trajectory", mismatch.clone())
    } else {
        let tolerance = Tolerance::Absolute(found.tolerance);
        let mut row = Row::compared(case, "trajectory: largest difference", 0.0, found.error, tolerance);
        row.note = (found.error > 0.0).then(|| format!("at {}", found.place));
        row
    };
    let stored = found.hash.clone().unwrap_or_else(|| "none".to_owned());
    vec![trajectory, Row::exact(case, "strict hash", stored, hash_words(hash))]
}

/// Compares with the snapshot of this name, or writes it; `None` when there is none.
fn snapshot(folder: &Path, scene: &str, text: &str) -> Result<Option<Comparison>, Box<dyn Error>> {
    let file = folder.join(format!("{scene}.snap"));
    let old = file.exists().then(|| insta::Snapshot::from_file(&file)).transpose()?;
    let description = old.as_ref().and_then(|old| old.metadata().description()).unwrap_or(DEFAULT_DESCRIPTION);
    let comparator = ToleranceComparator::default();
    let result = comparator.result();
    let mut settings = insta::Settings::new();
    settings.set_snapshot_path(folder);
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_description(description);
    settings.set_comparator(Box::new(comparator));
    settings.bind(|| insta::assert_snapshot!(scene, text));
    let found = result.lock().map_err(|_| "the comparison of the snapshot broke off")?.take();
    Ok(found)
}

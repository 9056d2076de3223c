//! Rules of the house: what docs/ARCHITECTURE.md promises and a compiler does not check.
//!
//! Each rule is one row, `0` violations being right; the violations themselves go to stderr with file and line.
//!
//! | module | holds |
//! |---|---|
//! | `counts` | the command: how much of the house there is, and the rule that it does not grow |
//! | `count` | one count, and what all are made with |
//! | `circles` | files of a crate that import each other |
//! | `imports` | which files of a crate import which |
//! | `layers` | arrows between crates; which crates are the core |
//! | `rooms` | which rooms of the facade a room may import |
//! | `third_party` | libraries that stay in their private module |
//! | `rules` | rules about one source file at a time |
//! | `one_dependency` | the rule that an example names its own crate alone |
//! | `one_build` | the rule that every build asks the same features of a library |
//! | `kinds_of_joint` | no kind of joint is named outside of the folder of constraints |
//! | `kinds_of_tier` | no kind of tier is named outside of the folders of tiers |
//! | `module_tables` | every module stands in the table of its room |
//! | `tolerances` | no two tolerances of one name with two values |
//! | `unused_dependencies` | dependencies that nothing names |
//! | `docs` | rules about documents and manifests |
//! | `rust_source` | a source file, with code told from comments and tests |
//! | `project_file` | the files of the project |
//! | `violation` | a place that breaks a rule |

mod circles;
mod count;
mod counts;
mod docs;
mod imports;
mod kinds_of_joint;
mod kinds_of_tier;
mod layers;
mod module_tables;
mod one_build;
mod one_dependency;
mod project_file;
mod rooms;
mod rules;
mod rust_source;
mod third_party;
mod tolerances;
mod unused_dependencies;
mod violation;

use crate::table;
use clap::Args;
use polhode_cases::row::Row;
use project_file::{ProjectFile, project_files};
use rust_source::RustSource;
use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use violation::Violation;

/// What of the house is told.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Count what the design limits, instead of checking the rules.
    #[arg(long)]
    counts: bool,
    /// Print JSON instead of a table.
    #[arg(long)]
    json: bool,
}

/// Runs the command: the counts, or the rules as `verify --only house` does.
///
/// # Errors
/// When the files cannot be read, or a list that the counts are made from does not hold.
pub(crate) fn run(options: &Options, root: &Path) -> Result<ExitCode, Box<dyn Error>> {
    if !options.counts {
        let rows = check(root);
        print!("{}", if options.json { table::json(&rows)? } else { table::render(&rows) });
        let failed = rows.iter().any(|row| row.verdict.fails_the_run());
        return Ok(if failed { ExitCode::FAILURE } else { ExitCode::SUCCESS });
    }
    let sources = rust_sources(&project_files(root)?);
    counts::lists_hold(&sources)?;
    let counts = counts::counts(&sources);
    print!("{}", if options.json { serde_json::to_string_pretty(&counts)? } else { counts::table(&counts) });
    Ok(ExitCode::SUCCESS)
}

/// Checks every rule.
pub(crate) fn check(root: &Path) -> Vec<Row> {
    let files = match project_files(root) {
        Ok(files) => files,
        Err(error) => return vec![Row::broken("house", "files of the project", error)],
    };
    let sources = rust_sources(&files);
    let mut rows = vec![row("arrows between crates", &layers::check(root))];
    rows.push(row("every build asks the same features of a library", &one_build::check(root)));
    rows.push(row("circles of files that import each other", &circles::check(&sources)));
    rows.push(row("parry3d and clarabel stay in their private module", &third_party::check(&sources)));
    rows.extend(rules::ALL.iter().map(|rule| row(rule.name, &rule.check(&sources))));
    rows.push(row("every module stands in the table of its room", &module_tables::check(&sources)));
    rows.push(row("rooms import only what they may", &rooms::check(&sources)));
    rows.push(row("kinds of joint named outside of their folder", &kinds_of_joint::check(&sources)));
    rows.push(row("kinds of tier named outside of their folders", &kinds_of_tier::check(&sources)));
    rows.push(row("no two tolerances of one name with two values", &tolerances::check(&sources)));
    let counts = counts::counts(&sources);
    rows.push(row("no count of the house has grown", &counts::check(&files, &sources, &counts)));
    rows.extend(counts.iter().filter_map(|count| Some(row(&count.goal_in_words(), &count.beyond_goal()?))));
    rows.push(row("every dependency is named by code", &unused_dependencies::check(&files, &sources)));
    rows.push(row("crates follow the lints of the workspace", &docs::lints(&files)));
    rows.push(row("paths named in the documents exist", &docs::paths_exist(&files, root)));
    rows.push(row("sources cited in modules stand in REFERENCES.md", &docs::citations(&files, &sources)));
    rows.push(row("lines of Python of at most 120 columns", &docs::python_lines(&files)));
    rows.push(row("no path of a machine in a file", &docs::machine_paths(&files)));
    rows
}

fn rust_sources(files: &[ProjectFile]) -> Vec<RustSource> {
    files.iter().filter(|file| file.is_rust()).map(|file| RustSource::new(&file.path, &file.text)).collect()
}

/// One rule as a row; its violations go to stderr.
fn row(rule: &str, violations: &[Violation]) -> Row {
    for violation in violations {
        eprintln!("\n  {}: {}", violation.place, violation.what);
    }
    Row::exact("house", rule, 0, violations.len() as u64)
}

#[cfg(test)]
mod tests {
    //! The house keeps its own rules; the same check that `verify` makes.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn sources_of_this_program_keep_the_rules() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let files = project_files(root).unwrap();
        let own: Vec<RustSource> = files
            .iter()
            .filter(|file| file.path.starts_with("xtask/") && file.is_rust())
            .map(|file| RustSource::new(&file.path, &file.text))
            .collect();
        assert!(!own.is_empty());
        for rule in rules::ALL {
            assert_eq!(rule.check(&own), vec![], "{}", rule.name);
        }
    }
}

//! `cargo xtask verify`: everything that a release needs, in an order that finds cheap mistakes first.
//!
//! 1. rules of the house (seconds), 2. formatting, lints, documentation and tests by cargo, 3. validation cases,
//! 4. README and book, the Python package, the gallery, 5. golden trajectories and pictures, 6. the viewer in a
//!    browser.
//!
//! Every step runs even when an earlier one failed, so that one run shows everything that is
//! wrong; cases and golden trajectories run beside the builds and each other (`schedule.rs`). Progress goes to stderr,
//! the table (or, with `--json`, the array) to stdout. `--quick` is for between two edits: formatting, rules, unit
//! tests, one case of each kind and the golden trajectories.

use crate::schedule::{self, Step};
use crate::table::{self, Counts};
use crate::{atlas, book, commands, gallery, golden, house, known, playground, python, viewer};
use clap::Args;
use polhode_cases::atlas::{Entry, Record};
use polhode_cases::row::Row;
use polhode_cases::snapshot_environment::in_snapshot_environment;
use polhode_cases::{self as cases, Amount, Company, Context};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Name of the rules of the house, as of a case.
const HOUSE: &str = "house";
/// Exit code when a row fails.
pub(crate) const EXIT_FAILED: u8 = 1;
/// Exit code when the command cannot be understood or run.
pub(crate) const EXIT_USAGE: u8 = 2;

/// What to verify and how to print it.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Rewrite golden trajectories and pictures and print the largest change of each.
    #[arg(long)]
    bless: bool,
    /// Run only the cases whose name contains PATTERN (whatever the case of its letters), and nothing of cargo's.
    #[arg(long, value_name = "PATTERN")]
    only: Option<String>,
    /// Print the rows as JSON instead of a table.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    extent: Extent,
}

/// How much is run.
#[derive(Debug, Args)]
#[group(multiple = false)]
struct Extent {
    /// Run random cases at full count instead of 1 % of it.
    #[arg(long)]
    full: bool,
    /// Run what takes a minute: rules, formatting, unit tests, one case of each kind, golden trajectories.
    #[arg(long, conflicts_with = "only")]
    quick: bool,
}

impl Options {
    /// Whether all steps run, each with the rows that it has.
    fn is_of_everything(&self) -> bool {
        self.only.is_none() && !self.extent.quick && !self.bless
    }
}

/// Runs the command.
///
/// # Errors
/// When it cannot start: no case of that name, no reference values, no workspace.
pub(crate) fn run(options: &Options) -> Result<ExitCode, Box<dyn Error>> {
    let root = workspace_root()?;
    if let Some(code) = in_snapshot_environment(options.bless)? {
        return Ok(code);
    }
    let amount = if options.extent.full { Amount::Full } else { Amount::Part };
    let context = Context::new(&root, amount)?;
    let scenes = context.shipped.names()?;
    let (groups, record) = (polhode_cases::atlas::groups(&root)?, Record::read(&root)?);
    let atlas = Atlas { entries: groups.iter().flat_map(|group| &group.entries).collect(), record };
    let steps = steps(options, &root, &context, (&scenes, &atlas));
    if steps.is_empty() {
        return Err(no_such_case(options, &names(&scenes, &atlas)).into());
    }
    let mut rows = schedule::run(&steps);
    if options.is_of_everything() {
        rows.push(known::all_mark_a_row(&rows, amount));
    }
    print(&rows, options)?;
    let failed = rows.iter().any(|row| row.verdict.fails_the_run());
    Ok(if failed { ExitCode::from(EXIT_FAILED) } else { ExitCode::SUCCESS })
}

/// The entries of the atlas, and what was found of them last.
struct Atlas<'a> {
    entries: Vec<&'a Entry>,
    record: Record,
}

/// What is run with these options, in the order of the rows.
fn steps<'a>(
    options: &Options,
    root: &'a Path,
    context: &'a Context,
    (scenes, atlas): (&'a [String], &'a Atlas<'a>),
) -> Vec<Step<'a>> {
    let selected =
        |name: &str| options.only.as_ref().is_none_or(|pattern| name.to_lowercase().contains(&pattern.to_lowercase()));
    let mut steps = Vec::new();
    if !options.bless {
        if selected(HOUSE) {
            steps.push(Step::new(HOUSE, Company::Build, || house::check(root)));
        }
        if options.only.is_none() {
            let checks = if options.extent.quick { commands::QUICK_CHECKS } else { commands::CHECKS };
            steps.extend(checks.iter().map(|check| Step::new(check.name(), Company::Build, || vec![check.run(root)])));
        }
        let runs = |name: &str| selected(name) && (!options.extent.quick || cases::QUICK.contains(&name));
        steps.extend(
            cases::ALL
                .iter()
                .filter(|case| runs(case.name))
                .map(|case| Step::new(case.name, cases::company(case.name), || case.run(context))),
        );
    }
    if !options.bless && selected(book::NAME) && !options.extent.quick {
        steps.push(Step::new(book::NAME, Company::Build, || book::check(context, &names(scenes, atlas))));
    }
    if !options.bless && selected(python::NAME) && !options.extent.quick {
        steps.push(Step::new(python::NAME, Company::Build, || python::check(context)));
    }
    if !options.bless && selected(gallery::CASE) {
        steps.push(Step::new(gallery::CASE, Company::Beside, || gallery::check(context)));
    }
    if !options.bless && !options.extent.quick {
        steps.extend(of_atlas(context, atlas, selected));
    }
    let goldens = scenes.iter().map(|scene| (scene, golden::case_name(scene))).filter(|(_, name)| selected(name));
    steps.extend(goldens.map(|(scene, name)| Step::new(name, Company::Beside, || golden::check(context, scene))));
    let stills = golden::STILLS.iter().filter(|still| selected(&still.case_name()));
    steps.extend(stills.map(|still| Step::new(still.case_name(), Company::Beside, || still.check(context))));
    if selected(viewer::NAME) && !options.extent.quick {
        let look = if options.bless { viewer::record } else { viewer::check };
        steps.push(Step::new(viewer::NAME, Company::Build, move || look(context)));
    }
    if !options.bless && selected(playground::NAME) && !options.extent.quick {
        steps.push(Step::new(playground::NAME, Company::Build, || playground::check(context)));
    }
    steps
}

/// The entries of the atlas, and its page.
fn of_atlas<'a>(context: &'a Context, atlas: &'a Atlas<'a>, selected: impl Fn(&str) -> bool) -> Vec<Step<'a>> {
    let named = atlas.entries.iter().map(|entry| (entry, case_of_atlas(entry)));
    let mut steps: Vec<Step<'a>> = named
        .filter(|(_, name)| selected(name))
        .map(|(entry, name)| {
            let rows = || polhode_cases::atlas::check(entry, &atlas.record, context);
            Step::new(name, Company::Beside, rows)
        })
        .collect();
    if selected(atlas::PAGE_CASE) {
        steps.push(Step::new(atlas::PAGE_CASE, Company::Beside, || atlas::check_page(context)));
    }
    steps
}

fn case_of_atlas(entry: &Entry) -> String {
    format!("{} {}", polhode_cases::atlas::CASE, entry.name)
}

fn no_such_case(options: &Options, names: &[String]) -> String {
    let pattern = options.only.as_deref().unwrap_or_default();
    format!("no case contains \"{pattern}\"; the cases are: {}", names.join(", "))
}

/// The names of all that `--only` can select.
fn names(scenes: &[String], atlas: &Atlas<'_>) -> Vec<String> {
    let cases = [HOUSE, book::NAME, python::NAME, gallery::CASE]
        .into_iter()
        .chain(cases::ALL.iter().map(|case| case.name))
        .map(str::to_owned);
    let goldens = scenes.iter().map(|scene| golden::case_name(scene));
    let stills = golden::STILLS.iter().map(golden::GoldenStill::case_name);
    let results = atlas.entries.iter().map(|entry| case_of_atlas(entry)).chain([atlas::PAGE_CASE.to_owned()]);
    let pages = [viewer::NAME, playground::NAME].map(str::to_owned);
    cases.chain(results).chain(goldens).chain(stills).chain(pages).collect()
}

fn print(rows: &[Row], options: &Options) -> Result<(), Box<dyn Error>> {
    let counts = Counts::of(rows);
    if options.json {
        println!("{}", table::json(rows)?);
        eprintln!("{}\n{}", counts.summary_line(), counts.closing_line());
    } else {
        print!("{}", table::render(rows));
        println!("{}\n{}", counts.summary_line(), counts.closing_line());
    }
    Ok(())
}

/// The folder of the workspace: that of this program's manifest, one up.
pub(crate) fn workspace_root() -> Result<PathBuf, Box<dyn Error>> {
    let manifest =
        std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from);
    Ok(manifest.parent().ok_or("the manifest of xtask has no folder above it")?.to_owned())
}

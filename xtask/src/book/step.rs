//! The step of a verification that reads README and book.

use super::commands::{self, Shell};
use super::page::{Block, Page, pages_in};
use super::{links, programs, python, scenes, selections};
use polhode_cases::row::Row;
use polhode_cases::{CaseResult, Context, guarded};
use std::collections::BTreeSet;
use std::error::Error;
use std::path::{Path, PathBuf};

/// Name of the step, as of a case.
pub(crate) const NAME: &str = "book";
/// The first page that anyone reads.
const README: &str = "README.md";
/// The Python package of the project.
const PACKAGE: &str = "polhode";
/// What else stands beside it.
const CHANGELOG: &str = "CHANGELOG.md";
/// Folder of all documents, which is the source of the book.
const DOCUMENTS: &str = "docs";
/// Folder of the pages whose blocks are run; the others are references with tests of their own, or written by commands.
const BOOK: &str = "docs/book";
/// Files of the workspace that commands of a page name.
const SHIPPED: [&str; 2] = ["fixtures/scenes", "fixtures/meshes"];

/// Runs what README and book print, and follows their links; `names` are those of all that can be verified.
pub(crate) fn check(context: &Context, names: &[String]) -> Vec<Row> {
    guarded(NAME, || rows(context, names))
}

fn rows(context: &Context, names: &[String]) -> CaseResult {
    let root = &context.root;
    let program = context.program.path(root)?;
    let build_folder = program.parent().ok_or("the program lies in no folder")?.join(NAME);
    let mut run = vec![Page::read(root, README)?];
    for path in pages_in(root, BOOK)? {
        run.push(Page::read(root, &path)?);
    }
    let (mut rows, mut shells) = (Vec::new(), Vec::new());
    for page in &run {
        let shell = Shell { root, program: program.to_owned(), folder: page_folder(root, page, &build_folder)? };
        rows.push(run_page(page, &shell)?);
        shells.push(shell);
    }
    rows.push(run_python(&run, &shells));
    let in_rust = run.iter().flat_map(Page::blocks).filter(is("rust")).count();
    rows.push(programs::rust(NAME, root, in_rust)?);
    let documents = documents(root)?;
    let (broken, count) = links::broken(root, &documents);
    rows.push(judged(&format!("{count} links of all documents lead somewhere"), &broken));
    let (faults, count) = selections::of_nothing(&documents, names);
    rows.push(judged(&format!("{count} selections of cases in all documents select some"), &faults));
    rows.push(programs::mdbook(NAME, root, program)?);
    Ok(rows)
}

fn is(language: &str) -> impl Fn(&Block) -> bool {
    move |block| block.language == language
}

/// An empty folder for a page, with the shipped files that it speaks of.
fn page_folder(root: &Path, page: &Page, build_folder: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let folder = build_folder.join(page.path.replace(['/', '.'], "-"));
    if folder.exists() {
        std::fs::remove_dir_all(&folder)?;
    }
    std::fs::create_dir_all(&folder)?;
    for shipped in SHIPPED.iter().filter(|_| page.text.contains("fixtures/")) {
        std::fs::create_dir_all(folder.join(shipped))?;
        for entry in std::fs::read_dir(root.join(shipped))? {
            let entry = entry?;
            if entry.file_type()?.is_file() {
                std::fs::copy(entry.path(), folder.join(shipped).join(entry.file_name()))?;
            }
        }
    }
    Ok(folder)
}

/// Runs the scenes and commands of a page, in order.
fn run_page(page: &Page, shell: &Shell<'_>) -> Result<Row, Box<dyn Error>> {
    let (mut planned, mut ran, mut faults) = (0, 0, Vec::new());
    for block in page.blocks() {
        if let Some(file) = &block.file {
            std::fs::write(shell.folder.join(file), &block.text)?;
        }
        let done = match block.language.as_str() {
            "toml" => scenes::plan(&block, &shell.folder).map(|()| planned += 1),
            "sh" | "console" => commands::run(&block, shell).map(|count| ran += count),
            "rust" | "python" | "text" | "json" | "csv" | "xml" => Ok(()),
            other => Err(format!("no block is of language \"{other}\": see xtask/src/book/mod.rs").into()),
        };
        faults.extend(done.err().map(|error| format!("{}:{}: {error}", page.path, block.line)));
    }
    let quantity = format!("{}: {planned} scenes load, {ran} commands do as printed", page.path);
    Ok(judged(&quantity, &faults))
}

/// Runs the blocks of Python of all pages, where their modules are here. Those of the package itself are run by its
/// tests.
fn run_python(pages: &[Page], shells: &[Shell<'_>]) -> Row {
    let blocks: Vec<(&Page, &Shell<'_>, Block)> = pages
        .iter()
        .zip(shells)
        .flat_map(|(page, shell)| page.blocks().into_iter().filter(is("python")).map(move |block| (page, shell, block)))
        .filter(|(_, _, block)| !python::imports(block).contains(PACKAGE))
        .collect();
    let quantity = format!("{} programs in Python run", blocks.len());
    let modules: BTreeSet<String> = blocks.iter().flat_map(|(_, _, block)| python::imports(block)).collect();
    let missing: Vec<String> = modules.into_iter().filter(|module| !python::has(module)).collect();
    if !missing.is_empty() {
        return Row::skipped(NAME, &quantity, &format!("python3 has no {}: pip install it", missing.join(", ")));
    }
    let faults: Vec<String> = blocks
        .iter()
        .filter_map(|(page, shell, block)| {
            python::run(block, shell).err().map(|error| format!("{}: {error}", page.path))
        })
        .collect();
    judged(&quantity, &faults)
}

/// All documents: README and changelog, those of the book and beside it, and the README of each crate.
fn documents(root: &Path) -> Result<Vec<Page>, Box<dyn Error>> {
    let mut paths = vec![README.to_owned(), CHANGELOG.to_owned()];
    paths.extend(pages_in(root, DOCUMENTS)?);
    let mut crates: Vec<PathBuf> = std::fs::read_dir(root.join("crates"))?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<_, _>>()?;
    crates.sort();
    paths.extend(
        crates.iter().map(|path| format!("crates/{}/{README}", path.file_name().unwrap_or_default().to_string_lossy())),
    );
    paths.iter().map(|path| Page::read(root, path)).collect()
}

/// A row that fails with the first fault; all go to stderr.
fn judged(quantity: &str, faults: &[String]) -> Row {
    for fault in faults {
        eprintln!("{fault}");
    }
    Row::exact(NAME, quantity, 0_u64, faults.len() as u64)
}

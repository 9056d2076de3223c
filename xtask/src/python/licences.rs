//! The licence texts of what a wheel and the page of the playground contain: of crates that are compiled into it, of
//! the viewer and of Rust's own library.

use polhode_cases::cargo::cargo;
use polhode_cases::row::Row;
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Software that contains that of others.
struct Product {
    /// The package that it is made of.
    package: &'static str,
    /// What it is called.
    name: &'static str,
    /// The file of the licences.
    file: &'static str,
}

/// The wheel, and the page of the playground.
const PRODUCTS: [Product; 2] = [
    Product { package: "polhode-py", name: "the wheel", file: "crates/polhode-py/LICENSES-THIRD-PARTY.txt" },
    Product {
        package: "polhode-web",
        name: "the playground",
        file: "crates/polhode-view/viewer/dist/LICENSES-ENGINE.txt",
    },
];
/// What the bundle of the viewer contains, in its own file.
const VIEWER: &str = "crates/polhode-view/viewer/dist/LICENSES.txt";
/// How names of files with a licence begin.
const BEGINNINGS: [&str; 5] = ["LICENSE", "LICENCE", "COPYING", "NOTICE", "UNLICENSE"];
/// Parts of the names of files that are not needed where the text of MIT is there, as another one to choose.
const OTHER_CHOICES: [&str; 5] = ["APACHE", "ZLIB", "UNLICENSE", "COPYING", "0BSD"];
/// The licence whose text is the same wherever it is used: a crate that has none of its own is told by that of others.
const APACHE: &str = "Apache-2.0";
/// How the text of it begins.
const APACHE_TEXT: &str = "Apache License";
/// What to do about another file.
const WRITE: &str = "differs: run `cargo xtask licences` and commit the file";
/// What stands above the texts.
const HEAD: &str = "\
polhode is under the licence in LICENSE. What follows are the licences of other software that it contains here, \
on one platform or
another: crates that are compiled into it, the viewer of its pages, and the standard library of Rust. Where a crate \
may be used under
one of several licences, this is the one that is chosen. Made by `cargo xtask licences`.
";
/// The licence of Rust's own library.
const RUST: &str = "\
The standard library of Rust is under MIT or Apache-2.0, copyright The Rust Project Developers; both texts stand above.
https://github.com/rust-lang/rust/blob/master/COPYRIGHT
";
/// Between two texts.
const RULE: &str = "--------------------------------------------------------------------------------";

/// What is read of the output of `cargo metadata`.
#[derive(Debug, Deserialize)]
struct Metadata {
    packages: Vec<Package>,
}

/// A crate.
#[derive(Debug, Deserialize)]
struct Package {
    name: String,
    version: String,
    license: Option<String>,
    manifest_path: PathBuf,
    /// Where it comes from; none of a crate of this workspace.
    source: Option<String>,
}

/// Writes the files.
///
/// # Errors
/// When cargo cannot be asked, or a crate has no text.
pub(crate) fn run(root: &Path) -> Result<ExitCode, Box<dyn Error>> {
    for Product { package, file, .. } in &PRODUCTS {
        fs::write(root.join(file), text(root, packages(root, package)?)?)?;
        println!("{file}");
    }
    Ok(ExitCode::SUCCESS)
}

/// Whether the files are what they would be now.
pub(super) fn rows(case: &str, root: &Path) -> Vec<Row> {
    PRODUCTS.iter().map(|product| row(case, root, product)).collect()
}

fn row(case: &str, root: &Path, product: &Product) -> Row {
    let quantity = &format!("licences of what {} contains are current", product.name);
    let packages = match packages(root, product.package) {
        Ok(packages) => packages,
        // Cargo has sources of other platforms only after it has asked its registry for them.
        Err(reason) => return Row::skipped(case, quantity, &reason.to_string()),
    };
    match text(root, packages) {
        Err(reason) => Row::broken(case, quantity, reason.to_string()),
        Ok(text) => {
            let is_same =
                fs::read_to_string(root.join(product.file)).is_ok_and(|own| own.replace("\r\n", "\n") == text);
            Row::exact(case, quantity, "same text", if is_same { "same text" } else { WRITE })
        }
    }
}

/// All texts, each once, with the crates that it is of.
fn text(root: &Path, packages: Vec<Package>) -> Result<String, Box<dyn Error>> {
    let mut of_text: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut without_text = Vec::new();
    for package in packages {
        let own = texts(&package)?;
        if own.is_empty() {
            without_text.push(package);
            continue;
        }
        for text in own {
            of_text.entry(text).or_default().insert(told(&package));
        }
    }
    let mut apache = of_text.iter_mut().find(|(text, _)| text.trim_start().starts_with(APACHE_TEXT));
    for package in without_text {
        match &mut apache {
            Some((_, crates)) if package.license.as_ref().is_some_and(|license| license.contains(APACHE)) => {
                crates.insert(told(&package));
            }
            _ => return Err(format!("{}: its sources have no text of a licence", told(&package)).into()),
        }
    }
    let mut sorted: Vec<(Vec<String>, String)> =
        of_text.into_iter().map(|(text, crates)| (crates.into_iter().collect(), text)).collect();
    sorted.push((vec!["the viewer of pages".to_owned()], normal(&fs::read_to_string(root.join(VIEWER))?)));
    sorted.sort();
    sorted.push((vec!["the standard library of Rust".to_owned()], RUST.to_owned()));
    let mut all = HEAD.to_owned();
    for (crates, text) in sorted {
        write!(all, "\n{RULE}\n{}\n{RULE}\n\n{text}", crates.join("\n"))?;
    }
    Ok(all)
}

/// How a crate is told.
fn told(package: &Package) -> String {
    let license = package.license.as_deref().unwrap_or("see its text").replace('/', " OR ");
    format!("{} {} ({license})", package.name, package.version)
}

/// The crates of others that are compiled into a product, on any platform.
fn packages(root: &Path, product: &str) -> Result<Vec<Package>, Box<dyn Error>> {
    let tree = said(
        root,
        &["tree", "--package", product, "--edges", "normal,no-proc-macro", "--target", "all", "--prefix", "none"],
    )?;
    let contained: BTreeSet<String> = tree
        .lines()
        .filter_map(|line| {
            let mut words = line.split_whitespace();
            Some(format!("{} {}", words.next()?, words.next()?.trim_start_matches('v')))
        })
        .collect();
    let metadata: Metadata = serde_json::from_str(&said(root, &["metadata", "--format-version", "1"])?)?;
    let is_contained = |package: &Package| contained.contains(&format!("{} {}", package.name, package.version));
    Ok(metadata.packages.into_iter().filter(|package| package.source.is_some() && is_contained(package)).collect())
}

/// What a command of cargo prints.
fn said(root: &Path, arguments: &[&str]) -> Result<String, Box<dyn Error>> {
    let output = cargo(root).args(arguments).arg("--locked").output()?;
    if !output.status.success() {
        return Err(format!("cargo {}: {}", arguments[0], String::from_utf8_lossy(&output.stderr).trim()).into());
    }
    Ok(String::from_utf8(output.stdout)?)
}

/// The texts in the sources of a crate: that of MIT where it may be chosen, and what holds besides.
fn texts(package: &Package) -> Result<Vec<String>, Box<dyn Error>> {
    let folder = package.manifest_path.parent().ok_or("a manifest stands in a folder")?;
    let mut files: Vec<(String, PathBuf)> = fs::read_dir(folder)?
        .filter_map(Result::ok)
        .filter(|entry| entry.path().is_file())
        .map(|entry| (entry.file_name().to_string_lossy().to_uppercase(), entry.path()))
        .filter(|(name, _)| BEGINNINGS.iter().any(|beginning| name.starts_with(beginning)))
        .collect();
    files.sort();
    if files.iter().any(|(name, _)| name.contains("MIT")) {
        files.retain(|(name, _)| !OTHER_CHOICES.iter().any(|other| name.contains(other)));
    }
    files.iter().map(|(_, path)| Ok(normal(&fs::read_to_string(path)?))).collect()
}

/// A text with ends of lines of one kind, and none that are empty at its ends.
fn normal(text: &str) -> String {
    let lines: Vec<&str> = text.trim_start_matches('\u{feff}').lines().map(str::trim_end).collect();
    format!("{}\n", lines.join("\n").trim_matches('\n'))
}

//! Arrows between crates: the only dependencies allowed, read from `cargo metadata`.

use super::violation::Violation;
use polhode_cases::cargo::cargo;
use serde::Deserialize;
use std::path::{Path, PathBuf};

/// Crates of the core, and the elastic body that it is compared with: no input, output, clock, thread or global.
pub(super) const CORE: [&str; 7] = [
    "polhode-spatial",
    "polhode-mesh",
    "polhode-dynamics",
    "polhode-contact",
    "polhode-response",
    "polhode",
    "polhode-elastic",
];

/// A crate and the crates of the workspace that it may depend on, whether for use, for building or for tests.
#[derive(Debug)]
struct Layer {
    name: &'static str,
    may_use: &'static [&'static str],
}

/// The layers, leaf first; docs/ARCHITECTURE.md draws them.
const LAYERS: &[Layer] = &[
    Layer { name: "polhode-spatial", may_use: &[] },
    Layer { name: "polhode-mesh", may_use: &["polhode-spatial"] },
    Layer { name: "polhode-dynamics", may_use: &["polhode-spatial"] },
    Layer { name: "polhode-contact", may_use: &["polhode-spatial", "polhode-mesh"] },
    Layer { name: "polhode-response", may_use: &["polhode-spatial"] },
    Layer {
        name: "polhode",
        may_use: &["polhode-spatial", "polhode-mesh", "polhode-dynamics", "polhode-contact", "polhode-response"],
    },
    Layer { name: "polhode-elastic", may_use: &["polhode-spatial"] },
    Layer { name: "polhode-scene", may_use: &["polhode"] },
    Layer { name: "polhode-study", may_use: &["polhode", "polhode-scene"] },
    Layer { name: "polhode-view", may_use: &["polhode"] },
    Layer {
        name: "polhode-cli",
        may_use: &["polhode", "polhode-elastic", "polhode-scene", "polhode-study", "polhode-view"],
    },
    Layer { name: "polhode-py", may_use: &["polhode", "polhode-scene", "polhode-study", "polhode-view", "one-build"] },
    Layer { name: "polhode-web", may_use: &["polhode", "polhode-scene", "polhode-study", "polhode-view"] },
    Layer { name: "one-build", may_use: &[] },
    Layer { name: "strict-hash", may_use: &["polhode", "polhode-scene"] },
    Layer { name: "polhode-oracles", may_use: &["polhode-spatial", "polhode", "polhode-scene"] },
    Layer {
        name: "polhode-cases",
        may_use: &[
            "polhode-spatial",
            "polhode-mesh",
            "polhode-dynamics",
            "polhode-contact",
            "polhode-response",
            "polhode",
            "polhode-study",
            "polhode-elastic",
            "polhode-scene",
            "strict-hash",
            "polhode-oracles",
        ],
    },
    Layer {
        name: "xtask",
        may_use: &[
            "polhode-spatial",
            "polhode-contact",
            "polhode-response",
            "polhode",
            "polhode-scene",
            "polhode-view",
            "polhode-cli",
            "one-build",
            "strict-hash",
            "polhode-oracles",
            "polhode-cases",
        ],
    },
];

/// Crates of development, on which no other depends.
const DEVELOPMENT: [&str; 3] = ["xtask", "polhode-cases", "polhode-oracles"];

/// Libraries that exactly one crate may name; crates of development may hold them against that crate.
const SINGLE_USER: [(&str, &str); 2] = [("parry3d", "polhode-contact"), ("clarabel", "polhode-response")];

/// Libraries that a further crate may name for its benches and tests alone, to be held against.
const DEVELOPMENT_USER: [(&str, &str); 1] = [("parry3d", "polhode-mesh")];

/// What is read of the output of `cargo metadata` (The Cargo Book, cargo-metadata(1), format version 1). The crate
/// `cargo_metadata` asks other features of serde than the program does: each library would be compiled twice.
#[derive(Debug, Deserialize)]
struct Metadata {
    packages: Vec<Package>,
}

/// A crate of the workspace.
#[derive(Debug, Deserialize)]
struct Package {
    name: String,
    manifest_path: PathBuf,
    dependencies: Vec<Dependency>,
}

/// A dependency as its manifest declares it.
#[derive(Debug, Deserialize)]
struct Dependency {
    name: String,
    /// The name under which the crate knows it, when it is another one.
    rename: Option<String>,
    /// `dev`, `build`, or nothing for a dependency of the crate itself.
    kind: Option<String>,
}

/// Every dependency between crates of the workspace that is not an arrow of the layers.
pub(super) fn check(root: &Path) -> Vec<Violation> {
    match metadata(root) {
        Ok(metadata) => check_metadata(&metadata),
        Err(error) => vec![Violation::in_file("Cargo.toml", error)],
    }
}

fn check_metadata(metadata: &Metadata) -> Vec<Violation> {
    let mut violations = Vec::new();
    for package in &metadata.packages {
        let name = package.name.as_str();
        let place = format!("crate {name}");
        let Some(layer) = LAYERS.iter().find(|layer| layer.name == name) else {
            violations.push(Violation::in_file(place, "has no place among the layers: add it to them"));
            continue;
        };
        let folder = package.manifest_path.parent().and_then(|folder| folder.file_name()).unwrap_or_default();
        if folder != name {
            let folder = folder.display();
            violations
                .push(Violation::in_file(&place, format!("lies in folder {folder}: folder and crate share a name")));
        }
        for dependency in &package.dependencies {
            let used = dependency.name.as_str();
            if LAYERS.iter().any(|other| other.name == used) && !layer.may_use.contains(&used) {
                violations.push(Violation::in_file(&place, format!("must not depend on {used}")));
            }
            let known_as = dependency.rename.as_deref().unwrap_or(used);
            for (library, user) in SINGLE_USER.into_iter().filter(|_| !DEVELOPMENT.contains(&name)) {
                let for_development =
                    dependency.kind.as_deref() == Some("dev") && DEVELOPMENT_USER.contains(&(library, name));
                if known_as == library && name != user && !for_development {
                    violations
                        .push(Violation::in_file(&place, format!("must not depend on {library}: only {user} may")));
                }
            }
        }
    }
    violations
}

/// What `cargo metadata` says about the workspace.
fn metadata(root: &Path) -> Result<Metadata, String> {
    let mut command = cargo(root);
    command.args(["metadata", "--no-deps", "--format-version", "1"]);
    let output = command.output().map_err(|error| format!("cargo metadata: {error}"))?;
    if !output.status.success() {
        return Err(format!("cargo metadata: {}", String::from_utf8_lossy(&output.stderr)));
    }
    serde_json::from_slice(&output.stdout).map_err(|error| format!("cargo metadata: {error}"))
}

//! Arrows between crates: the only dependencies allowed, read from `cargo metadata`.

use super::violation::Violation;
use crate::commands;
use std::path::Path;

/// Crates of the core: no input, output, clock, thread or global.
pub(super) const CORE: [&str; 6] =
    ["polhode-spatial", "polhode-mesh", "polhode-dynamics", "polhode-contact", "polhode-response", "polhode"];

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
    Layer { name: "polhode-scene", may_use: &["polhode"] },
    Layer { name: "polhode-view", may_use: &["polhode"] },
    Layer { name: "polhode-cli", may_use: &["polhode", "polhode-scene", "polhode-view"] },
    Layer {
        name: "xtask",
        may_use: &[
            "polhode-spatial",
            "polhode-mesh",
            "polhode-dynamics",
            "polhode-contact",
            "polhode-response",
            "polhode",
            "polhode-scene",
            "polhode-view",
            "polhode-cli",
        ],
    },
];

/// Libraries that exactly one crate may name; xtask, which nobody depends on, may hold them against that crate.
const SINGLE_USER: [(&str, &str); 2] = [("parry3d", "polhode-contact"), ("clarabel", "polhode-response")];

/// Libraries that a further crate may name for its benches and tests alone, to be held against.
const DEVELOPMENT_USER: [(&str, &str); 1] = [("parry3d", "polhode-mesh")];

/// Every dependency between crates of the workspace that is not an arrow of the layers.
pub(super) fn check(root: &Path) -> Vec<Violation> {
    match metadata(root) {
        Ok(metadata) => check_metadata(&metadata),
        Err(error) => vec![Violation::in_file("Cargo.toml", error)],
    }
}

fn check_metadata(metadata: &cargo_metadata::Metadata) -> Vec<Violation> {
    let mut violations = Vec::new();
    for package in &metadata.packages {
        let name = package.name.to_string();
        let place = format!("crate {name}");
        let Some(layer) = LAYERS.iter().find(|layer| layer.name == name) else {
            violations.push(Violation::in_file(place, "has no place among the layers: add it to them"));
            continue;
        };
        let folder = package.manifest_path.parent().and_then(|folder| folder.file_name()).unwrap_or_default();
        if folder != name {
            violations
                .push(Violation::in_file(&place, format!("lies in folder {folder}: folder and crate share a name")));
        }
        for dependency in &package.dependencies {
            let used = dependency.name.as_str();
            if LAYERS.iter().any(|other| other.name == used) && !layer.may_use.contains(&used) {
                violations.push(Violation::in_file(&place, format!("must not depend on {used}")));
            }
            let known_as = dependency.rename.as_deref().unwrap_or(used);
            for (library, user) in SINGLE_USER.into_iter().filter(|_| name != "xtask") {
                let for_development = dependency.kind == cargo_metadata::DependencyKind::Development
                    && DEVELOPMENT_USER.contains(&(library, name.as_str()));
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
fn metadata(root: &Path) -> Result<cargo_metadata::Metadata, String> {
    let mut command = cargo_metadata::MetadataCommand::new();
    command.current_dir(root).no_deps();
    if let Some(program) = commands::cargo(root).get_program().to_str() {
        command.cargo_path(program);
    }
    command.exec().map_err(|error| error.to_string())
}

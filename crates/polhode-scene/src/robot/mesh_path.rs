//! Where the meshes of a robot file are: names relative to the file, `file://`, and `package://` of ROS.
//!
//! A package is a folder of its name. It is looked for in the folders that the scene names, then beside the robot file
//! and in each folder above it.

use crate::files::Files;
use std::path::{Path, PathBuf};

/// Most folders above a robot file that are looked at.
const HIGHEST: usize = 16;

/// Where to look for meshes.
#[derive(Debug, Clone)]
pub(super) struct MeshPaths {
    /// Where files are.
    files: Files,
    /// The folder of the robot file.
    folder: PathBuf,
    /// Folders that hold packages.
    packages: Vec<PathBuf>,
}

impl MeshPaths {
    /// For a robot file.
    pub(super) fn new(files: Files, file: &Path, packages: &[PathBuf]) -> Self {
        Self { files, folder: file.parent().map(Path::to_owned).unwrap_or_default(), packages: packages.to_vec() }
    }

    /// Where files are.
    pub(super) fn files(&self) -> Files {
        self.files
    }

    /// The folder of the robot file.
    pub(super) fn folder(&self) -> &Path {
        &self.folder
    }

    /// The file of this name, if there is one.
    pub(super) fn find(&self, name: &str) -> Option<PathBuf> {
        let inside = name.strip_prefix("package://").or_else(|| name.strip_prefix("model://"));
        if let Some(inside) = inside.map(|inside| inside.trim_start_matches('/')) {
            return self.in_package(inside);
        }
        let path = Path::new(name.strip_prefix("file://").unwrap_or(name));
        let path = if path.is_absolute() { path.to_owned() } else { self.folder.join(path) };
        self.files.holds(&path).then_some(path)
    }

    /// `PACKAGE/path` in a folder that holds the package, or that is the package.
    fn in_package(&self, inside: &str) -> Option<PathBuf> {
        let absolute = std::path::absolute(&self.folder).unwrap_or_else(|_| self.folder.clone());
        let above = absolute.ancestors().take(HIGHEST).map(Path::to_owned);
        let (package, rest) = inside.split_once('/')?;
        let mut folders = self.packages.iter().cloned().chain(above);
        folders.find_map(|folder| {
            let held = folder.join(inside);
            let is_package = folder.file_name().is_some_and(|own| own == package);
            let own = is_package.then(|| folder.join(rest));
            std::iter::once(held).chain(own).find(|path| self.files.holds(path))
        })
    }
}

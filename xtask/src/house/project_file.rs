//! The files of the project, as git knows them.

use std::path::Path;

/// A file that belongs to the project.
#[derive(Debug)]
pub(super) struct ProjectFile {
    /// Path relative to the workspace, with forward slashes.
    pub(super) path: String,
    /// What it holds.
    pub(super) text: String,
}

impl ProjectFile {
    /// Whether it is a source file of Rust.
    pub(super) fn is_rust(&self) -> bool {
        Path::new(&self.path).extension().is_some_and(|extension| extension == "rs")
    }
}

/// All files that git knows or would add, with their text; files that are not text are left out.
pub(super) fn project_files(root: &Path) -> Result<Vec<ProjectFile>, String> {
    let output = std::process::Command::new("git")
        .args(["ls-files", "--cached", "--others", "--exclude-standard"])
        .current_dir(root)
        .output()
        .map_err(|error| format!("git ls-files: {error}"))?;
    if !output.status.success() {
        return Err(format!("git ls-files: {}", String::from_utf8_lossy(&output.stderr).trim()));
    }
    let mut paths: Vec<String> = String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect();
    paths.sort();
    paths.dedup();
    // A path that git knows and that is gone from the folder has been deleted and not yet been committed.
    let read = |path: String| std::fs::read_to_string(root.join(&path)).ok().map(|text| ProjectFile { path, text });
    Ok(paths.into_iter().filter_map(read).collect())
}

//! Whether the committed bundle of the viewer is what its sources build to.

use super::node::{Node, complaint};
use polhode_cases::CaseResult;
use polhode_cases::row::Row;

/// Files that a build of the viewer writes.
const FILES: [&str; 5] = ["viewer.js", "play.js", "worker.js", "loader.js", "LICENSES.txt"];
/// What to do about another bundle.
const BUILD: &str = "differs: run `npm run build` in crates/polhode-view/viewer and commit dist/";

/// Builds the viewer into a folder of its own, and compares byte by byte.
pub(super) fn rows(case: &str, node: &Node) -> CaseResult {
    let built = tempfile::tempdir()?;
    let output = node.script("build.mjs").arg(built.path()).output()?;
    if !output.status.success() {
        return Ok(vec![Row::broken(case, "the bundle is what its sources build to", complaint(&output))]);
    }
    let mut rows = Vec::new();
    for file in FILES {
        let same = std::fs::read(node.folder().join("dist").join(file))? == std::fs::read(built.path().join(file))?;
        let quantity = format!("dist/{file} is what the sources build to");
        rows.push(Row::exact(case, &quantity, "same bytes", if same { "same bytes" } else { BUILD }));
    }
    Ok(rows)
}

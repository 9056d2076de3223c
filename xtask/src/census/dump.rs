//! Problems as files: one each, in the format of `polhode_response::problem_text`.

use super::asks::Ask;
use polhode_response::census::Table;
use std::error::Error;
use std::path::Path;

/// Writes all that were kept; returns how many files.
pub(super) fn write(table: &Table, folder: &Path) -> Result<usize, Box<dyn Error>> {
    std::fs::create_dir_all(folder)?;
    let mut files = 0;
    for (kind, counted) in &table.kinds {
        let ask = Ask::of(kind.file);
        for kept in &counted.kept {
            let mut facts = vec![
                ("asked", ask.to_string()),
                ("caller", format!("{}:{}", kind.file, kind.line)),
                ("chain", kind.chain.name().to_owned()),
                ("answered", kind.method.to_owned()),
                ("tried", kind.tried.join(" ")),
                ("as-often", counted.count.to_string()),
            ];
            facts.extend(kept.facts.iter().cloned());
            let name = format!("{ask}-{}-{}-{files:05}.txt", kind.chain.name(), kind.method).to_lowercase();
            std::fs::write(folder.join(name.replace([' ', '/'], "-")), kept.problem.written(&facts))?;
            files += 1;
        }
    }
    Ok(files)
}

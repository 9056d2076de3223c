//! What programs that were killed have left behind, as the next run of the same output finds it.

use crate::failure;
use polhode_scene::LeftBehind;

/// Says what has become of temporary files that nobody writes to any more.
pub(crate) fn note(files: &[LeftBehind]) {
    for file in files {
        let found = file.temporary.display();
        failure::remark(&match &file.kept {
            Some(kept) => {
                format!(
                    "note: {found}, which a killed program left behind, is now {}: what it had computed",
                    kept.display()
                )
            }
            None => format!("note: {found}, which a killed program left behind, was of no use and is removed"),
        });
    }
}

//! What other engines give: errors computed from their recorded states, as the table beside these tells them.

use std::error::Error;
use std::path::Path;

/// The table, from the root of the workspace; the states stand beside it.
const TABLE: &str = "peers/recorded/README.md";

/// How the lines of this engine begin, and the one that a result is held against.
const OWN: &str = "polhode";
const OWN_MOST_ACCURATE: &str = "polhode, accurate";

/// A line of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct PeerRun {
    /// The scene, as docs/peers.md calls it.
    pub scene: String,
    /// The engine with its version, and its settings.
    pub engine: String,
    /// The error, or why there is none.
    pub error: String,
}

impl PeerRun {
    /// Whether it is of this engine.
    pub fn is_own(&self) -> bool {
        self.engine.starts_with(OWN)
    }

    /// Whether it is that which results are held against.
    pub fn is_most_accurate_own(&self) -> bool {
        self.engine == OWN_MOST_ACCURATE
    }

    /// The error as a number.
    pub fn number(&self) -> Option<f64> {
        self.error.parse().ok()
    }
}

/// All lines of the table.
///
/// # Errors
/// When it cannot be read.
pub fn peer_runs(root: &Path) -> Result<Vec<PeerRun>, Box<dyn Error>> {
    let text = std::fs::read_to_string(root.join(TABLE)).map_err(|error| format!("{TABLE}: {error}"))?;
    let line = |line: &str| {
        let mut cells = line.strip_prefix('|')?.split('|').map(|cell| cell.trim().to_owned());
        Some(PeerRun { scene: cells.next()?, engine: cells.next()?, error: cells.next()? })
    };
    // Below the header and the line under it.
    Ok(text.lines().filter(|line| line.starts_with('|')).skip(2).filter_map(line).collect())
}

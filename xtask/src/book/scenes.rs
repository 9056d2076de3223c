//! Blocks of TOML: scenes are loaded and planned.

use super::page::Block;
use polhode::Simulation;
use std::error::Error;
use std::path::Path;

/// The manifest of a reader's own package.
const MANIFEST: &str = "Cargo.toml";
/// What every scene begins with.
const FORMAT: &str = "format = 1\n";

/// Loads and plans the scene of a block, whose file, if it has one, stands in `folder`.
pub(super) fn plan(block: &Block, folder: &Path) -> Result<(), Box<dyn Error>> {
    if block.file.as_deref() == Some(MANIFEST) {
        block.text.parse::<toml::Table>()?;
        return Ok(());
    }
    let name = block.file.as_deref().unwrap_or("block.toml");
    let whole = if block.text.contains("format =") { block.text.clone() } else { format!("{FORMAT}{}", block.text) };
    let loaded = polhode_scene::load_text(&folder.join(name).to_string_lossy(), &whole, &[])?;
    if !loaded.scene.bodies().is_empty() {
        Simulation::new(&loaded.scene)?;
    }
    Ok(())
}

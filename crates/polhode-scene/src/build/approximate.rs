//! Few convex parts that nearly fill a mesh: `shape.mesh.approximate`.

use super::fault::{Fault, positive};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::ApproximateEntry;
use polhode::ApproximateParts;
use polhode::contact::{ApproximateSettings, Shape, approximate_decomposition};
use polhode::mesh::{ConvexSolid, DecompositionSettings, SolidMesh, convex_decomposition};

/// The parts as a shape, and how well they fill the solid; `path` is that of the entry. Where the exact parts are no
/// more, they are taken.
pub(super) fn parts(
    mesh: &SolidMesh,
    entry: &ApproximateEntry,
    path: &KeyPath,
) -> Result<(Shape, ApproximateParts), Fault> {
    let limit = entry.error.map(|error| positive(error, &path.key("error"))).transpose()?;
    let usual = ApproximateSettings::default();
    let settings = ApproximateSettings { max_parts: entry.parts.unwrap_or(usual.max_parts), ..usual };
    let refused = |error| (path.clone(), Refusal::Approximate(error));
    let found = approximate_decomposition(mesh, settings).map_err(refused)?;
    let max_parts = found.parts.len().max(1);
    let settings = DecompositionSettings { max_parts, ..DecompositionSettings::default() };
    let (solids, volume_error): (Vec<ConvexSolid>, f64) = match convex_decomposition(mesh, settings) {
        Ok(exact) if exact.unresolved == 0 && exact.parts.len() <= max_parts => (exact.parts, exact.volume_error),
        _ => (found.parts, found.volume_error),
    };
    if let Some(limit) = limit.filter(|&limit| volume_error.abs() > limit) {
        let refusal = Refusal::ApproximateVolume { parts: solids.len(), found: volume_error, limit };
        return Err((path.key("error"), refusal));
    }
    let shape = Shape::of_convex_parts(&solids).map_err(|error| (path.clone(), error.into()))?;
    Ok((shape, ApproximateParts { parts: solids.len(), volume_error }))
}

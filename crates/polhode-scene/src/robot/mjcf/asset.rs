//! `<asset>`: meshes by name.

use super::super::element::Element;
use super::super::finding::RobotDefect;
use super::super::mesh_path::MeshPaths;
use super::super::reading::Reading;
use super::compiler::Compiler;
use super::defaults::Defaults;
use super::frame;
use glam::DVec3;
use polhode::spatial::Pose;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A mesh.
#[derive(Debug, Clone)]
pub(super) struct MeshAsset {
    /// As the file names it.
    pub(super) file: String,
    /// Where it is, if it was found.
    pub(super) path: Option<PathBuf>,
    /// What its coordinates are multiplied by.
    pub(super) scale: DVec3,
    /// The frame in the mesh that is that of a geometry.
    pub(super) reference: Pose,
}

/// The meshes of a file.
pub(super) fn meshes(
    root: &Element,
    (compiler, defaults): (&Compiler, &Defaults),
    paths: &MeshPaths,
    reading: &mut Reading,
) -> BTreeMap<String, MeshAsset> {
    let mut meshes = BTreeMap::new();
    for element in root.all("asset").flat_map(|asset| asset.all("mesh")) {
        let full = defaults.applied(element, None);
        let Some(file) = full.attribute("file") else {
            reading.ignore(element, "<mesh> without a file", "meshes are read from files");
            continue;
        };
        let path = Path::new(file);
        let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        let name = full.attribute("name").map_or(stem, str::to_owned);
        let subject = format!("mesh `{name}`");
        let scale = reading.vector(&full, "scale", &subject).unwrap_or(DVec3::ONE);
        if scale.abs().min_element() == 0.0 {
            reading.refuse(element, subject, RobotDefect::Size { what: "scale", value: 0.0 });
            continue;
        }
        let own = if compiler.strips_path { path.file_name().map_or(path, Path::new) } else { path };
        let full_name = Path::new(&compiler.mesh_folder).join(own);
        let translation = reading.vector(&full, "refpos", &subject).unwrap_or_default();
        let mut turned = Element::clone(&full);
        let quaternion = full.attribute("refquat").map(str::to_owned);
        if let Some(quaternion) = quaternion {
            turned.set_default("quat", &quaternion);
        }
        let reference = Pose::new(frame::orientation(&turned, compiler, &subject, reading), translation);
        let found = paths.find(&full_name.to_string_lossy());
        meshes.insert(name, MeshAsset { file: file.to_owned(), path: found, scale, reference });
    }
    meshes
}

//! Meshes out: the format follows the ending, and a file appears when it is complete.

use crate::failure::Failure;
use crate::mesh_args::{MeshEncoding, MeshOutputArgs};
use polhode::mesh::{Encoding, MeshFormat, TriangleMesh, format};
use polhode_scene::AtomicFile;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Where and how to write.
pub(super) struct MeshOutput {
    path: PathBuf,
    format: MeshFormat,
    encoding: Encoding,
}

impl MeshOutput {
    /// What is asked for, checked before the work.
    pub(super) fn of(args: &MeshOutputArgs) -> Result<Option<Self>, Failure> {
        let Some(path) = args.output.clone() else { return Ok(None) };
        let Some(format) = MeshFormat::of_path(&path) else {
            let (file, list) = (path.display(), MeshFormat::LIST);
            return Err(Failure::Usage(format!("error: {file}: the ending of a mesh file names its format: {list}")));
        };
        let encoding = match args.encoding {
            Some(MeshEncoding::Text) => Encoding::Text,
            Some(MeshEncoding::Binary) => Encoding::Binary,
            None => format.exact_encoding(),
        };
        Ok(Some(Self { path, format, encoding }))
    }

    /// Writes one mesh under the name given.
    pub(super) fn write(&self, mesh: &TriangleMesh) -> Result<(), Failure> {
        self.write_to(&self.path, mesh)
    }

    /// Writes each mesh under the name given with its number before the ending.
    pub(super) fn write_parts<'a>(&self, parts: impl Iterator<Item = &'a TriangleMesh>) -> Result<(), Failure> {
        let stem = self.path.file_stem().unwrap_or_default().to_string_lossy();
        for (index, part) in parts.enumerate() {
            let name = format!("{stem}-{}.{}", index + 1, self.format.ending());
            self.write_to(&self.path.with_file_name(name), part)?;
        }
        Ok(())
    }

    fn write_to(&self, path: &Path, mesh: &TriangleMesh) -> Result<(), Failure> {
        let bytes = format::write(mesh, self.format, self.encoding)
            .map_err(|error| Failure::Usage(format!("error: {}: {error}", path.display())))?;
        let written = || -> io::Result<()> {
            let mut file = AtomicFile::create(path)?;
            file.write_all(&bytes)?;
            file.commit()
        };
        written().map_err(|error| Failure::InputOutput(format!("error: cannot write {}: {error}", path.display())))
    }
}

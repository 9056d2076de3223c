//! Meshes that bodies share.

use crate::surface_mesh::SurfaceMesh;
use std::collections::BTreeMap;

/// What a mesh is of: the kind of shape and the bits of the numbers that it depends on.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct MeshKey {
    kind: &'static str,
    numbers: Vec<u64>,
}

impl MeshKey {
    /// A shape of a kind with these numbers.
    pub fn new(kind: &'static str, numbers: impl IntoIterator<Item = f64>) -> Self {
        Self { kind, numbers: numbers.into_iter().map(f64::to_bits).collect() }
    }
}

/// Meshes, each one once.
#[derive(Debug, Clone, Default)]
pub struct MeshLibrary {
    meshes: Vec<SurfaceMesh>,
    by_key: BTreeMap<MeshKey, usize>,
}

impl MeshLibrary {
    /// The number of the mesh of this key, which is made if it is not there yet.
    pub fn number_of(&mut self, key: MeshKey, make: impl FnOnce() -> SurfaceMesh) -> usize {
        let meshes = &mut self.meshes;
        *self.by_key.entry(key).or_insert_with(|| {
            meshes.push(make());
            meshes.len() - 1
        })
    }

    /// All meshes, in the order of their numbers.
    pub fn meshes(&self) -> &[SurfaceMesh] {
        &self.meshes
    }
}

//! Files of meshes, robots and tables that were dropped on the page. They stay in the page's memory until it is closed.

use polhode_scene::GivenFiles;

/// Files by name.
#[derive(Debug, Default)]
pub(crate) struct Files {
    files: Vec<(&'static str, &'static [u8])>,
}

impl Files {
    /// Adds a file, in the place of another one of its name.
    pub(crate) fn add(&mut self, name: &str, bytes: Vec<u8>) {
        self.files.retain(|(own, _)| *own != name);
        self.files.push((String::leak(name.to_owned()), Vec::leak(bytes)));
    }

    /// All of them.
    pub(crate) fn given(&self) -> GivenFiles {
        Vec::leak(self.files.clone())
    }
}

//! A scene that has been read, with its names.

use crate::errors;
use polhode_scene::{LoadedScene, Override, SceneFileError, load_text, load_with};
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;

/// Where a scene comes from: it can be read again.
#[derive(Debug, Clone)]
pub(crate) enum Source {
    File(PathBuf),
    Text { origin: String, text: String },
}

/// A scene that has been read; `polhode.Scene` and paths become one.
#[pyclass(frozen, module = "polhode._polhode")]
#[derive(Debug)]
pub(crate) struct Loaded {
    source: Source,
    changes: Vec<Override>,
    pub(crate) scene: Arc<LoadedScene>,
}

/// A change of a scene: the name of the argument that asks for it, the key, and the value as TOML.
type Change = (String, String, String);

#[pymethods]
impl Loaded {
    /// The scene of a file.
    #[staticmethod]
    fn file(py: Python<'_>, path: PathBuf, changes: Vec<Change>) -> PyResult<Self> {
        Self::read(py, Source::File(path), changes)
    }

    /// The scene of a text; `origin` is what errors call it.
    #[staticmethod]
    fn text(py: Python<'_>, origin: String, text: String, changes: Vec<Change>) -> PyResult<Self> {
        Self::read(py, Source::Text { origin, text }, changes)
    }

    /// Name of the scene.
    #[getter]
    fn name(&self) -> &str {
        self.scene.scene.name()
    }

    /// Duration, s.
    #[getter]
    fn duration(&self) -> f64 {
        self.scene.scene.duration_s()
    }

    /// Names of the bodies, in the order of the scene.
    #[getter]
    fn body_names(&self) -> Vec<&str> {
        self.scene.scene.bodies().iter().map(polhode::Body::name).collect()
    }

    /// Names of the joints, in the order of the scene.
    #[getter]
    fn joint_names(&self) -> Vec<String> {
        self.scene.joint_names()
    }

    /// How to read it again: a name of a static method, and its arguments.
    fn source(&self) -> (&'static str, Vec<String>, Vec<Change>) {
        let changes = self.changes.iter().map(|own| (own.origin.clone(), own.key.clone(), own.value.clone())).collect();
        match &self.source {
            Source::File(path) => ("file", vec![path.display().to_string()], changes),
            Source::Text { origin, text } => ("text", vec![origin.clone(), text.clone()], changes),
        }
    }
}

impl Loaded {
    /// What reads the scene again, with other changes, and the changes that it has.
    pub(crate) fn reader(&self) -> (Source, Vec<Override>) {
        (self.source.clone(), self.changes.clone())
    }

    fn read(py: Python<'_>, source: Source, changes: Vec<Change>) -> PyResult<Self> {
        let changes: Vec<Override> =
            changes.into_iter().map(|(origin, key, value)| Override::new(origin, key, value)).collect();
        let scene = py.detach(|| source.load(&changes)).map_err(|error| errors::scene(py, &error))?;
        Ok(Self { source, changes, scene: Arc::new(scene) })
    }
}

impl Source {
    /// The scene with these changes.
    pub(crate) fn load(&self, changes: &[Override]) -> Result<LoadedScene, SceneFileError> {
        match self {
            Self::File(path) => load_with(path, changes),
            Self::Text { origin, text } => load_text(origin, text, changes),
        }
    }
}

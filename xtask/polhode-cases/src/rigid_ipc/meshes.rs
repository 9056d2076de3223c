//! Mesh files of the suite, brought to the size that a scene asks for.

use super::error::ImportError;
use super::points;
use super::table::Table;
use glam::DVec3;
use polhode::mesh::{Bounds, Repair, RepairOptions, SolidMesh, TriangleMesh, obj, repair};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Name of the folder of mesh files.
const FOLDER: &str = "meshes";

/// The form of a body.
#[derive(Debug)]
pub(super) struct Placed {
    /// Name of the mesh file without its ending, or what a body without one is called.
    pub(super) stem: String,
    pub(super) form: Form,
}

/// What the form of a body is made of, at its full size.
#[derive(Debug)]
pub(super) enum Form {
    Mesh {
        /// File of the result, beside the scene.
        file: String,
        /// What the coordinates of that file are multiplied by.
        scale: Option<f64>,
        mesh: TriangleMesh,
    },
    /// Corners without edges and faces.
    Points(Vec<DVec3>),
}

/// Where mesh files come from and where they go.
#[derive(Debug)]
pub(super) struct Meshes<'a> {
    scene: &'a Path,
    folder: Option<&'a Path>,
    /// Files of the result: name and content.
    pub(super) written: BTreeMap<String, String>,
    /// What was mended.
    pub(super) notes: Vec<String>,
}

impl<'a> Meshes<'a> {
    /// For a scene file; `folder` holds the meshes when it is given.
    pub(super) fn new(scene: &'a Path, folder: Option<&'a Path>) -> Self {
        Self { scene, folder, written: BTreeMap::new(), notes: Vec::new() }
    }

    /// The form of a body: read, scaled by `scale` or to `dimensions`; a mesh is put among the files of the result.
    pub(super) fn of_body(&mut self, body: &mut Table<'_>) -> Result<Placed, ImportError> {
        let Some(name) = body.text("mesh")? else {
            let positions = points::of_scene(body)?;
            return Ok(Placed { stem: "points".to_owned(), form: scaled_points(body, positions)? });
        };
        let path = self.find(name).ok_or_else(|| ImportError::NoMesh {
            path: self.scene.to_owned(),
            key: body.key("mesh"),
            mesh: name.to_owned(),
        })?;
        let stem = path.file_stem().map_or_else(|| "body".to_owned(), |stem| stem.to_string_lossy().into_owned());
        if let Some(positions) = points::of_file(&path, body)? {
            return Ok(Placed { stem, form: scaled_points(body, positions)? });
        }
        let mesh = self.closed(polhode_scene::read_mesh(&path)?, body)?;
        let factors = factors(body, &mesh.bounds())?;
        let form = self.scaled(body, &stem, &mesh, factors)?;
        Ok(Placed { stem, form })
    }

    /// A mesh with its coordinates multiplied by these factors.
    fn scaled(
        &mut self,
        body: &Table<'_>,
        stem: &str,
        mesh: &TriangleMesh,
        factors: DVec3,
    ) -> Result<Form, ImportError> {
        if factors == DVec3::splat(factors.x) {
            let file = self.keep(stem, mesh);
            let scaled = mesh.scaled(factors.x).map_err(|source| self.refused(body, source))?;
            return Ok(Form::Mesh { file, scale: (factors.x != 1.0).then_some(factors.x), mesh: scaled });
        }
        let vertices = mesh.vertices().iter().map(|&vertex| vertex * factors).collect();
        let scaled =
            TriangleMesh::new(vertices, mesh.triangles().to_vec()).map_err(|source| self.refused(body, source))?;
        let file = self.keep(&format!("{stem}-scaled"), &scaled);
        Ok(Form::Mesh { file, scale: None, mesh: scaled })
    }

    /// The mesh with the corners that it repeats joined, when that makes it a solid: exporters part a mesh along seams
    /// that are none in space. A mesh that stays open is left as it is; only ground may be.
    fn closed(&mut self, mesh: TriangleMesh, body: &Table<'_>) -> Result<TriangleMesh, ImportError> {
        if SolidMesh::new(mesh.clone()).is_ok() {
            return Ok(mesh);
        }
        let (mended, report) = repair(&mesh, &RepairOptions::default()).map_err(|source| self.refused(body, source))?;
        // A hole that is filled is a guess at the form; a joined corner is not.
        let only_joined = report.steps.iter().all(|step| step.repair == Repair::Weld);
        if !report.after.is_solid() || !only_joined {
            return Ok(mesh);
        }
        self.notes.extend(report.steps.iter().map(|step| format!("{}: {step}", body.key("mesh"))));
        Ok(mended)
    }

    fn refused(&self, body: &Table<'_>, source: polhode::mesh::MeshError) -> ImportError {
        ImportError::Mesh { path: self.scene.to_owned(), key: body.key("mesh"), source }
    }

    /// Puts a mesh among the files of the result; the same mesh is kept once, another one of that name gets a number.
    fn keep(&mut self, stem: &str, mesh: &TriangleMesh) -> String {
        let text = obj::write(mesh);
        let mut number = 1;
        loop {
            let file = if number == 1 { format!("{stem}.obj") } else { format!("{stem}-{number}.obj") };
            match self.written.get(&file) {
                Some(other) if *other != text => number += 1,
                _ => {
                    self.written.insert(file.clone(), text);
                    return file;
                }
            }
        }
    }

    /// The file: in the folder given, beside the scene, or in the nearest folder `meshes` above it that has it.
    fn find(&self, name: &str) -> Option<PathBuf> {
        if let Some(folder) = self.folder {
            return Some(folder.join(name)).filter(|path| path.is_file());
        }
        let beside = self.scene.parent().map(|folder| folder.join(name));
        // The ancestors of a relative path end at the folder that one is in.
        let whole = std::path::absolute(self.scene).unwrap_or_else(|_| self.scene.to_owned());
        let above = whole.ancestors().skip(1).map(|folder| folder.join(FOLDER).join(name));
        beside.into_iter().chain(above).find(|path| path.is_file())
    }
}

fn scaled_points(body: &mut Table<'_>, mut positions: Vec<DVec3>) -> Result<Form, ImportError> {
    let factors = factors(body, &Bounds::of(positions.iter().copied()))?;
    for position in &mut positions {
        *position *= factors;
    }
    Ok(Form::Points(positions))
}

/// Factors of the three coordinates. `dimensions` wins over `scale` and counts a direction without extent as 1 m long,
/// both as in the suite's reader.
fn factors(body: &mut Table<'_>, bounds: &Bounds) -> Result<DVec3, ImportError> {
    let scale = match body.value("scale") {
        None => DVec3::ONE,
        Some(value) => match value.as_f64() {
            Some(number) => DVec3::splat(number),
            None => body.vector("scale")?.unwrap_or(DVec3::ONE),
        },
    };
    let (key, factors) = match body.vector("dimensions")? {
        None => ("scale", scale),
        Some(dimensions) => {
            let extent = (bounds.max - bounds.min).to_array().map(|extent| if extent == 0.0 { 1.0 } else { extent });
            ("dimensions", dimensions / DVec3::from_array(extent))
        }
    };
    if factors.min_element() > 0.0 && factors.is_finite() {
        Ok(factors)
    } else {
        Err(body.refuse(key, "must be positive numbers"))
    }
}

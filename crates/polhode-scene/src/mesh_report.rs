//! What is wrong with a mesh, and its mass properties.

use crate::report::triple;
use glam::{DMat3, DVec3};
use polhode::mesh::{
    Amount, Diagnosis, MeshError, Repair, SolidMesh, SurfaceIntegrals, TriangleMesh, diagnose, hollow_mass_properties,
    solid_mass_properties,
};
use polhode::spatial::MassProperties;
use serde_json::{Value, json};

/// What a mesh is filled with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Filling {
    /// Matter throughout; needs a mesh that bounds a solid.
    Solid,
    /// Matter in the surface alone.
    Hollow,
}

/// Diagnosis and mass properties of a mesh.
#[derive(Debug, Clone)]
pub struct MeshReport {
    /// Number of vertices.
    pub vertices: usize,
    /// Number of triangles.
    pub triangles: usize,
    /// Extent along the axes, m.
    pub size_m: DVec3,
    /// What is wrong.
    pub diagnosis: Diagnosis,
    /// Area, m^2.
    pub area_m2: f64,
    /// Volume, m^3, when the mesh bounds a solid.
    pub volume_m3: Option<f64>,
    /// Mass properties, or why there are none.
    pub mass_properties: Result<MassProperties, MeshError>,
}

impl MeshReport {
    /// Of a mesh with so much matter.
    pub fn new(mesh: TriangleMesh, filling: Filling, amount: Amount) -> Self {
        let diagnosis = diagnose(&mesh);
        let (vertices, triangles) = (mesh.vertices().len(), mesh.triangles().len());
        let (low, high) = mesh
            .vertices()
            .iter()
            .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), &vertex| (low.min(vertex), high.max(vertex)));
        let size_m = (high - low).max(DVec3::ZERO);
        let area_m2 = SurfaceIntegrals::of(&mesh).area;
        let hollow = hollow_mass_properties(&mesh, amount);
        let solid = SolidMesh::new(mesh);
        let volume_m3 = solid.as_ref().ok().map(|solid| solid.volume_integrals().volume);
        let mass_properties = match filling {
            Filling::Hollow => hollow,
            Filling::Solid => solid.and_then(|solid| solid_mass_properties(&solid, amount)),
        };
        Self { vertices, triangles, size_m, diagnosis, area_m2, volume_m3, mass_properties }
    }

    /// The report as JSON. What there is none of is `null`; matrices are lists of rows, and the columns of
    /// `principal_axes` are the axes.
    pub fn to_json(&self) -> Value {
        let properties = self.mass_properties.as_ref().ok();
        let axes = properties.map(MassProperties::principal_axes);
        let defects: Vec<_> = self
            .diagnosis
            .defects
            .iter()
            .map(|defect| {
                json!({
                    "kind": defect.kind.name(),
                    "count": defect.count,
                    "where": defect.location.to_string(),
                    "repair": defect.repair().map(Repair::name),
                })
            })
            .collect();
        json!({
            "vertices": self.vertices,
            "triangles": self.triangles,
            "size_m": triple(self.size_m),
            "volume_m3": self.volume_m3,
            "area_m2": self.area_m2,
            "mass_kg": properties.map(MassProperties::mass),
            "center_of_mass_m": properties.map(|p| triple(p.center_of_mass())),
            "inertia_kg_m2": properties.map(|p| rows(&p.inertia().matrix())),
            "principal_moments_kg_m2": axes.map(|axes| triple(axes.moments())),
            "principal_axes": axes.map(|axes| rows(&axes.rotation().to_matrix())),
            "defects": defects,
        })
    }
}

fn rows(matrix: &DMat3) -> [[f64; 3]; 3] {
    matrix.transpose().to_cols_array_2d()
}

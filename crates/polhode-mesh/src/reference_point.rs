//! What the choice of the reference point costs in accuracy: the thesis's sums as it writes them.
//!
//! Thesis 3.2 splits a solid into tetrahedra between a reference point and the triangles, and names three choices: the
//! origin of the model ("often a good choice"), the average of the vertices ("a better choice"), the centre of mass.
//! Here its sums are formed plainly, and the second moment is shifted to the centre of mass by the theorem of parallel
//! axes. In exact arithmetic the point does not matter; in f64 the error grows with the cube (volume) to the fifth
//! power (inertia) of its distance in sizes of the body (erratum E5), which is what [`compare_reference_points`] shows.
//! Results are for comparison; [`VolumeIntegrals::of`] and [`SurfaceIntegrals::of`] choose a point themselves.

use crate::{SurfaceIntegrals, TriangleMesh, VolumeIntegrals};
use glam::{DMat3, DVec3};

/// The point that tetrahedra are taken from, or positions on a surface measured from.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum ReferencePoint {
    /// The origin of the mesh's coordinates.
    Origin,
    /// The average of the vertices that triangles use.
    VertexAverage,
    /// The centre of mass, as the compensated sums give it.
    CenterOfMass,
    /// A point of one's own, m.
    At(DVec3),
}

impl ReferencePoint {
    /// The choices that the thesis names, in its order.
    pub const NAMED: [Self; 3] = [Self::Origin, Self::VertexAverage, Self::CenterOfMass];

    /// In words.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Origin => "origin",
            Self::VertexAverage => "average of the vertices",
            Self::CenterOfMass => "centre of mass",
            Self::At(_) => "given point",
        }
    }

    fn position(self, mesh: &TriangleMesh, center_of_mass: DVec3) -> DVec3 {
        match self {
            Self::Origin => DVec3::ZERO,
            Self::VertexAverage => vertex_average(mesh),
            Self::CenterOfMass => center_of_mass,
            Self::At(point) => point,
        }
    }
}

/// What one choice gives, and how far it is from the compensated sums.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReferencePointCost {
    /// The choice.
    pub reference: ReferencePoint,
    /// Volume (m^3) or area (m^2) by the plain sums.
    pub measure: f64,
    /// Centroid by the plain sums, m.
    pub centroid: DVec3,
    /// Second moment about it by the plain sums, m^5 or m^4.
    pub second_moment: DMat3,
    /// Error of the measure, relative.
    pub measure_error: f64,
    /// Error of the centroid, m.
    pub centroid_error_m: f64,
    /// Largest error of an element of the second moment, relative to its largest element.
    pub second_moment_error: f64,
}

/// The named choices for a solid.
pub fn compare_reference_points(mesh: &TriangleMesh) -> Vec<ReferencePointCost> {
    let exact = VolumeIntegrals::of(mesh);
    let exact = Moments { measure: exact.volume, centroid: exact.centroid, second: exact.second_moment };
    ReferencePoint::NAMED.into_iter().map(|reference| cost(mesh, reference, &exact, &TETRAHEDRON)).collect()
}

/// The named choices for a hollow body.
pub fn compare_reference_points_hollow(mesh: &TriangleMesh) -> Vec<ReferencePointCost> {
    let exact = SurfaceIntegrals::of(mesh);
    let exact = Moments { measure: exact.area, centroid: exact.centroid, second: exact.second_moment };
    ReferencePoint::NAMED.into_iter().map(|reference| cost(mesh, reference, &exact, &TRIANGLE)).collect()
}

/// The plain sums about one reference point, for a solid.
pub fn plain_volume_integrals(mesh: &TriangleMesh, reference: ReferencePoint) -> VolumeIntegrals {
    let position = reference.position(mesh, VolumeIntegrals::of(mesh).centroid);
    let Moments { measure, centroid, second } = plain(mesh, position, &TETRAHEDRON);
    VolumeIntegrals { volume: measure, centroid, second_moment: second }
}

/// The formulas for a simplex with the corners b, c, d.
struct Formulas {
    /// Of the triangle.
    weight: fn([DVec3; 3]) -> f64,
    /// `measure / sum w`, `int r / sum w s`, `int r r^T / sum w (s s^T + ...)`.
    factors: [f64; 3],
}

const TETRAHEDRON: Formulas =
    Formulas { weight: |[b, c, d]| b.dot(c.cross(d)), factors: [1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0] };
const TRIANGLE: Formulas =
    Formulas { weight: |[b, c, d]| (c - b).cross(d - b).length(), factors: [0.5, 1.0 / 6.0, 1.0 / 24.0] };

/// Measure, centroid, second moment about it.
struct Moments {
    measure: f64,
    centroid: DVec3,
    second: DMat3,
}

fn plain(mesh: &TriangleMesh, reference: DVec3, formulas: &Formulas) -> Moments {
    let outer = |v: DVec3| DMat3::from_cols(v * v.x, v * v.y, v * v.z);
    let (mut weight, mut first, mut second) = (0.0, DVec3::ZERO, DMat3::ZERO);
    for corners in mesh.corner_positions() {
        let [b, c, d] = corners.map(|p| p - reference);
        let (w, s) = ((formulas.weight)([b, c, d]), b + c + d);
        weight += w;
        first += w * s;
        second += (outer(s) + outer(b) + outer(c) + outer(d)) * w;
    }
    let measure = weight * formulas.factors[0];
    let shift = first * formulas.factors[1] / measure;
    Moments { measure, centroid: reference + shift, second: second * formulas.factors[2] - outer(shift) * measure }
}

fn cost(mesh: &TriangleMesh, reference: ReferencePoint, exact: &Moments, formulas: &Formulas) -> ReferencePointCost {
    let found = plain(mesh, reference.position(mesh, exact.centroid), formulas);
    let largest = |m: DMat3| m.to_cols_array().into_iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    ReferencePointCost {
        reference,
        measure: found.measure,
        centroid: found.centroid,
        second_moment: found.second,
        measure_error: (found.measure / exact.measure - 1.0).abs(),
        centroid_error_m: found.centroid.distance(exact.centroid),
        second_moment_error: largest(found.second - exact.second) / largest(exact.second),
    }
}

/// The average of the vertices that triangles use, each counted once.
fn vertex_average(mesh: &TriangleMesh) -> DVec3 {
    let mut used = vec![false; mesh.vertices().len()];
    for &index in mesh.triangles().iter().flatten() {
        used[index as usize] = true;
    }
    let (mut sum, mut count) = (DVec3::ZERO, 0.0);
    for (&vertex, _) in mesh.vertices().iter().zip(used).filter(|(_, used)| *used) {
        sum += vertex;
        count += 1.0;
    }
    sum / count
}

//! Meshes with known properties, and comparisons.

use polhode_mesh::{MeshError, SolidMesh, TriangleMesh, obj};
use polhode_spatial::{DMat3, DVec3, Density, MassProperties};
use std::collections::BTreeMap;

pub(crate) const L_SHAPE: &[u8] = include_bytes!("../../../../fixtures/meshes/l-shape.obj");
pub(crate) const PYRAMID: &[u8] = include_bytes!("../../../../fixtures/meshes/pyramid.obj");

/// A density of one.
pub(crate) fn unit_density() -> Density {
    Density::new(1.0).unwrap()
}

/// A mesh from the text of an OBJ file.
pub(crate) fn mesh(text: &[u8]) -> TriangleMesh {
    obj::read(text).unwrap()
}

/// A solid from the text of an OBJ file.
pub(crate) fn solid(text: &[u8]) -> SolidMesh {
    SolidMesh::new(mesh(text)).unwrap()
}

/// Several meshes as one, without joining vertices.
pub(crate) fn joined(parts: &[&TriangleMesh]) -> TriangleMesh {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for part in parts {
        let base = vertices.len() as u32;
        vertices.extend_from_slice(part.vertices());
        triangles.extend(part.triangles().iter().map(|t| t.map(|index| index + base)));
    }
    TriangleMesh::new(vertices, triangles).unwrap()
}

/// The mesh with its vertices moved.
pub(crate) fn deformed(mesh: &TriangleMesh, f: impl Fn(DVec3) -> DVec3) -> Result<TriangleMesh, MeshError> {
    TriangleMesh::new(mesh.vertices().iter().map(|&v| f(v)).collect(), mesh.triangles().to_vec())
}

/// The icosahedron in the unit sphere, its triangles split into four `level` times with new vertices on the sphere.
pub(crate) fn icosphere(level: usize) -> TriangleMesh {
    let g = f64::midpoint(1.0, 5f64.sqrt());
    let mut vertices: Vec<DVec3> = [-1.0, 1.0]
        .iter()
        .flat_map(|&s| [-g, g].map(|t| [DVec3::new(0.0, s, t), DVec3::new(s, t, 0.0), DVec3::new(t, 0.0, s)]))
        .flatten()
        .map(DVec3::normalize)
        .collect();
    let edge = 1.2 * vertices[0].distance(*nearest(&vertices, 0));
    let mut triangles = Vec::new();
    for a in 0..12u32 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                let [p, q, r] = [a, b, c].map(|i| vertices[i as usize]);
                if p.distance(q) < edge && q.distance(r) < edge && r.distance(p) < edge {
                    let is_outward = (q - p).cross(r - p).dot(p) > 0.0;
                    triangles.push(if is_outward { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    assert_eq!(triangles.len(), 20);
    for _ in 0..level {
        triangles = split_in_four(&mut vertices, &triangles);
    }
    TriangleMesh::new(vertices, triangles).unwrap()
}

fn nearest(points: &[DVec3], index: usize) -> &DVec3 {
    let distance = |i: usize| points[i].distance(points[index]);
    let best = (0..points.len()).filter(|&i| i != index).min_by(|&i, &j| distance(i).total_cmp(&distance(j)));
    &points[best.unwrap()]
}

fn split_in_four(vertices: &mut Vec<DVec3>, triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut middles = BTreeMap::new();
    let mut middle = |i: u32, j: u32| {
        *middles.entry((i.min(j), i.max(j))).or_insert_with(|| {
            vertices.push((vertices[i as usize] + vertices[j as usize]).normalize());
            vertices.len() as u32 - 1
        })
    };
    let mut result = Vec::new();
    for &[a, b, c] in triangles {
        let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
        result.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    result
}

/// A torus about z with radii 1 and 1/4: `n` corners around the axis, `m` around the tube.
pub(crate) fn torus(n: u32, m: u32) -> TriangleMesh {
    let angle = |i: u32, n: u32| 2.0 * std::f64::consts::PI * f64::from(i) / f64::from(n);
    let mut vertices = Vec::new();
    let mut triangles = Vec::new();
    for i in 0..n {
        for j in 0..m {
            let (u, v) = (angle(i, n), angle(j, m));
            let rho = 1.0 + 0.25 * v.cos();
            vertices.push(DVec3::new(rho * u.cos(), rho * u.sin(), 0.25 * v.sin()));
            let at = |i: u32, j: u32| (i % n) * m + j % m;
            triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
            triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    TriangleMesh::new(vertices, triangles).unwrap()
}

/// Whether two numbers agree to `tolerance` times `scale`.
#[track_caller]
pub(crate) fn assert_near(found: f64, expected: f64, scale: f64, tolerance: f64) {
    let error = (found - expected).abs() / scale;
    assert!(error <= tolerance, "found {found}, expected {expected}: relative error {error:e}, allowed {tolerance:e}");
}

/// Whether two numbers agree to a relative tolerance.
#[track_caller]
pub(crate) fn assert_relative(found: f64, expected: f64, tolerance: f64) {
    assert_near(found, expected, expected.abs(), tolerance);
}

/// Whether two vectors agree, relative to `scale`.
#[track_caller]
pub(crate) fn assert_vector(found: DVec3, expected: DVec3, scale: f64, tolerance: f64) {
    let error = (found - expected).length() / scale;
    assert!(error <= tolerance, "found {found}, expected {expected}: relative error {error:e}, allowed {tolerance:e}");
}

/// Whether two matrices agree, relative to the largest element expected.
#[track_caller]
pub(crate) fn assert_matrix(found: DMat3, expected: DMat3, tolerance: f64) {
    let largest = |m: DMat3| m.to_cols_array().into_iter().fold(0.0f64, |l, x| l.max(x.abs()));
    let error = largest(found - expected) / largest(expected);
    assert!(error <= tolerance, "found {found}, expected {expected}: relative error {error:e}, allowed {tolerance:e}");
}

/// Whether two sets of mass properties agree: masses and inertias relative to themselves, centres to `size`.
#[track_caller]
pub(crate) fn assert_same_body(found: &MassProperties, expected: &MassProperties, size: f64, tolerance: f64) {
    assert_relative(found.mass(), expected.mass(), tolerance);
    assert_vector(found.center_of_mass(), expected.center_of_mass(), size, tolerance);
    assert_matrix(found.inertia().matrix(), expected.inertia().matrix(), tolerance);
}

/// A symmetric matrix from its elements xx, yy, zz, xy, xz, yz.
pub(crate) fn symmetric([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> DMat3 {
    DMat3::from_cols(DVec3::new(xx, xy, xz), DVec3::new(xy, yy, yz), DVec3::new(xz, yz, zz))
}

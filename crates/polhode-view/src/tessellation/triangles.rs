//! Surfaces of triangles: smooth where they bend little, sharp where they bend much.

use crate::surface_mesh::SurfaceMesh;
use polhode::spatial::DVec3;
use std::collections::BTreeMap;

/// Cosine of the bend between two triangles above which the surface counts as smooth there (30 degrees).
const CREASE_COSINE: f64 = 0.866_025_403_784_438_6;

/// The surface of triangles, anticlockwise seen from outside; vertices in one place are joined.
pub fn surface(vertices: &[DVec3], triangles: &[[u32; 3]]) -> SurfaceMesh {
    let joined = joined(vertices, triangles);
    // Twice the area times the normal: large triangles count for more.
    let areas: Vec<DVec3> = joined
        .iter()
        .map(|corners| {
            let [a, b, c] = corners.map(|corner| vertices[corner as usize]);
            (b - a).cross(c - a)
        })
        .collect();
    let units: Vec<DVec3> = areas.iter().map(|area| area.try_normalize().unwrap_or(DVec3::Z)).collect();
    let mut around: Vec<Vec<usize>> = vec![Vec::new(); vertices.len()];
    for (triangle, corners) in joined.iter().enumerate() {
        for &corner in corners {
            around[corner as usize].push(triangle);
        }
    }
    let mut mesh = SurfaceMesh::default();
    let mut known: BTreeMap<(u32, [u64; 3]), u32> = BTreeMap::new();
    for (triangle, corners) in joined.iter().enumerate() {
        let corner = |corner: u32| {
            let smooth = around[corner as usize].iter().filter(|&&u| units[u].dot(units[triangle]) > CREASE_COSINE);
            let sum: DVec3 = smooth.map(|&u| areas[u]).sum();
            let normal = sum.try_normalize().unwrap_or(units[triangle]);
            let key = (corner, normal.to_array().map(f64::to_bits));
            *known.entry(key).or_insert_with(|| mesh.add_vertex(vertices[corner as usize], normal))
        };
        let corners = corners.map(corner);
        mesh.triangles.push(corners);
    }
    mesh.lines = lines(&joined, &units, &mesh.triangles);
    mesh
}

/// Triangles by the first vertex that stands in each place.
fn joined(vertices: &[DVec3], triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut first: BTreeMap<[u64; 3], u32> = BTreeMap::new();
    // Adding zero makes a negative zero positive.
    let key = |vertex: u32| (vertices[vertex as usize] + DVec3::ZERO).to_array().map(f64::to_bits);
    let join = |vertex: u32, first: &mut BTreeMap<_, _>| *first.entry(key(vertex)).or_insert(vertex);
    let joined = triangles.iter().map(|corners| corners.map(|corner| join(corner, &mut first)));
    joined.collect()
}

/// Sharp edges and borders.
fn lines(joined: &[[u32; 3]], units: &[DVec3], drawn: &[[u32; 3]]) -> Vec<[u32; 2]> {
    let mut edges: BTreeMap<(u32, u32), Vec<(usize, usize)>> = BTreeMap::new();
    for (triangle, corners) in joined.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            edges.entry((a.min(b), a.max(b))).or_default().push((triangle, k));
        }
    }
    let sharp = edges.values().filter(|at| match at[..] {
        [(t, _), (u, _)] => units[t].dot(units[u]) <= CREASE_COSINE,
        _ => true,
    });
    sharp.filter_map(|at| at.first()).map(|&(t, k)| [drawn[t][k], drawn[t][(k + 1) % 3]]).collect()
}

//! Convex polyhedra from points and from triangles: triangles of one plane become one face.
//!
//! The hull of points is the exact one of polhode-mesh ([`ConvexHull`]), in which planes that differ only by rounding
//! have separate faces; here such faces are merged.
//!
//! Each face is grown from the largest remaining triangle (the seed) over neighbours all of whose vertices lie in the
//! seed's plane, so that a sliver between two faces joins one of them and never merges the two. Vertices inside a face
//! or inside an edge are removed.

use crate::bounding::aabb::Aabb;
use crate::shape::error::{ShapeError, check_point};
use crate::shape::point_cloud::largest_distance;
use crate::shape::polyhedron::ConvexPolyhedron;
use crate::shape::topology;
use glam::DVec3;
use polhode_mesh::{ConvexHull, HullError};
use polhode_spatial::rounding;
use std::collections::BTreeMap;

/// The convex hull of some points: the exact one of polhode-mesh, its faces merged up to the tolerance for plane faces.
pub(crate) fn from_points(points: &[DVec3]) -> Result<ConvexPolyhedron, ShapeError> {
    if points.len() < 4 {
        return Err(ShapeError::TooFewPoints { count: points.len(), limit: 4 });
    }
    points.iter().try_for_each(|&p| check_point("point", p))?;
    let points = welded(points);
    let limit = rounding::DIGITS_OF_A_FILE * largest_distance(&points);
    let hull = ConvexHull::of(&points).map_err(|error| match error {
        HullError::TooManyPoints(count) => ShapeError::TooManyPoints { count, limit: u32::MAX as usize / 8 },
        _ => ShapeError::Flat { thickness: 0.0, limit },
    })?;
    let mesh = hull.solid().mesh();
    let thickness = thickness(mesh.vertices(), mesh.triangles());
    if thickness < limit {
        return Err(ShapeError::Flat { thickness, limit });
    }
    from_triangles(mesh.vertices(), mesh.triangles())
}

/// The exact hull of some points with its faces as they are, none merged, for points that are known within `rounding`
/// (m). Slivers whose faces differ by less than the tolerance for plane faces have no other.
///
/// # Errors
/// [`ShapeError::Flat`] for a hull that is thinner than the tolerances, and when it fails its checks.
pub(crate) fn exact(points: &[DVec3], rounding: f64) -> Result<ConvexPolyhedron, ShapeError> {
    let Ok(hull) = ConvexHull::of(points) else {
        let limit = (rounding::DIGITS_OF_A_FILE * largest_distance(points)).max(rounding);
        return Err(ShapeError::Flat { thickness: 0.0, limit });
    };
    topology::build_within(hull.solid().mesh().vertices().to_vec(), hull.faces().to_vec(), rounding)
}

/// The least extent of a hull across one of its triangles, m.
fn thickness(vertices: &[DVec3], triangles: &[[u32; 3]]) -> f64 {
    let across = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|v| vertices[v as usize]);
        // A triangle whose corners are collinear to rounding has no normal.
        let normal = (b - a).cross(c - a).try_normalize()?;
        Some(vertices.iter().map(|&v| normal.dot(a - v)).fold(0.0, f64::max))
    };
    triangles.iter().filter_map(across).fold(f64::INFINITY, f64::min)
}

/// The points without those that are nearer to an earlier kept one than the tolerance for plane faces.
fn welded(points: &[DVec3]) -> Vec<DVec3> {
    let around = Aabb::of_points(points.iter().copied());
    let tolerance = 0.5 * rounding::DIGITS_OF_A_FILE * (around.max - around.min).max_element();
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&i, &j| points[i].x.total_cmp(&points[j].x).then(i.cmp(&j)));
    let mut kept: Vec<usize> = Vec::with_capacity(points.len());
    for i in order {
        let beside = kept.iter().rev().take_while(|&&k| points[i].x - points[k].x <= tolerance);
        if !beside.into_iter().any(|&k| points[i].distance(points[k]) <= tolerance) {
            kept.push(i);
        }
    }
    kept.sort_unstable();
    kept.into_iter().map(|i| points[i]).collect()
}

/// A convex polyhedron from outward triangles that close a surface.
pub(crate) fn from_triangles(vertices: &[DVec3], triangles: &[[u32; 3]]) -> Result<ConvexPolyhedron, ShapeError> {
    vertices.iter().try_for_each(|&v| check_point("vertex", v))?;
    let fail = |reason| {
        let edges = triangles.len() * 3 / 2;
        Err(ShapeError::NotClosed { vertices: vertices.len(), edges, faces: triangles.len(), reason })
    };
    if triangles.iter().flatten().any(|&v| v as usize >= vertices.len()) {
        return fail("a triangle names a vertex that does not exist");
    }
    let mut owner: BTreeMap<(u32, u32), usize> = BTreeMap::new();
    for (index, triangle) in triangles.iter().enumerate() {
        for edge in directed_edges(*triangle) {
            if owner.insert(edge, index).is_some() {
                return fail("two triangles run along an edge in the same direction");
            }
        }
    }
    let (region, regions) = grow_regions(vertices, triangles, &owner);
    let mut members = vec![Vec::new(); regions];
    for (triangle, &region) in triangles.iter().zip(&region) {
        members[region].push(*triangle);
    }
    let mut loops = Vec::with_capacity(regions);
    for (index, members) in members.into_iter().enumerate() {
        let border: BTreeMap<u32, u32> = members
            .into_iter()
            .flat_map(directed_edges)
            .filter(|&(a, b)| owner.get(&(b, a)).is_none_or(|&other| region[other] != index))
            .collect();
        match chain(&border) {
            Some(corners) => loops.push(corners),
            None => return fail("the border of a plane part is not one loop"),
        }
    }
    build_reduced(vertices, loops)
}

fn directed_edges([a, b, c]: [u32; 3]) -> [(u32, u32); 3] {
    [(a, b), (b, c), (c, a)]
}

/// Region of every triangle, and how many regions there are.
fn grow_regions(
    vertices: &[DVec3],
    triangles: &[[u32; 3]],
    owner: &BTreeMap<(u32, u32), usize>,
) -> (Vec<usize>, usize) {
    let corners = |t: usize| triangles[t].map(|v| vertices[v as usize]);
    let area = |t: usize| {
        let [a, b, c] = corners(t);
        (b - a).cross(c - a)
    };
    // Well above the rounding of computed coordinates, well below what a vertex may be off the plane of its face.
    let tolerance = 0.1 * rounding::DIGITS_OF_A_FILE * largest_distance(vertices);
    let mut seeds: Vec<usize> = (0..triangles.len()).collect();
    seeds.sort_by(|&i, &j| area(j).length_squared().total_cmp(&area(i).length_squared()).then(i.cmp(&j)));
    let mut region = vec![usize::MAX; triangles.len()];
    let mut regions = 0;
    for seed in seeds {
        if region[seed] != usize::MAX {
            continue;
        }
        let normal = area(seed).normalize_or_zero();
        let origin = corners(seed)[0];
        let mut front = vec![seed];
        region[seed] = regions;
        while let Some(triangle) = front.pop() {
            for (a, b) in directed_edges(triangles[triangle]) {
                let Some(&next) = owner.get(&(b, a)) else { continue };
                let plane = corners(next).iter().all(|&v| normal.dot(v - origin).abs() <= tolerance);
                // A triangle with an opposite normal belongs to the other side of a plate, however thin.
                if region[next] == usize::MAX && plane && normal.dot(area(next)) >= 0.0 {
                    region[next] = regions;
                    front.push(next);
                }
            }
        }
        regions += 1;
    }
    (region, regions)
}

/// The single closed loop of successors; none when they form several.
fn chain(border: &BTreeMap<u32, u32>) -> Option<Vec<u32>> {
    let (&start, _) = border.first_key_value()?;
    let mut corners = vec![start];
    let mut next = *border.get(&start)?;
    while next != start {
        corners.push(next);
        next = *border.get(&next)?;
        if corners.len() > border.len() {
            return None;
        }
    }
    (corners.len() == border.len()).then_some(corners)
}

/// Removes the vertices that belong to fewer than three faces and renumbers the rest in their old order.
fn build_reduced(vertices: &[DVec3], mut loops: Vec<Vec<u32>>) -> Result<ConvexPolyhedron, ShapeError> {
    let mut uses = vec![0_usize; vertices.len()];
    for &vertex in loops.iter().flatten() {
        uses[vertex as usize] += 1;
    }
    let mut number = vec![u32::MAX; vertices.len()];
    let mut kept = Vec::new();
    for (vertex, &count) in uses.iter().enumerate() {
        if count >= 3 {
            number[vertex] = kept.len() as u32;
            kept.push(vertices[vertex]);
        }
    }
    for corners in &mut loops {
        corners.retain(|&v| uses[v as usize] >= 3);
        for vertex in corners.iter_mut() {
            *vertex = number[*vertex as usize];
        }
        // Loops start at their lowest vertex and are sorted, so that the numbers of faces do not depend on how the hull
        // was built.
        let first = corners.iter().enumerate().min_by_key(|(_, v)| **v).map_or(0, |(i, _)| i);
        corners.rotate_left(first);
    }
    loops.sort_unstable();
    topology::build(kept, loops)
}

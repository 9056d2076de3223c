//! Exact convex decomposition: parts that are convex and add up to the whole, on named solids and on random ones.

use super::mass_properties::l_prism;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::{DMat3, DVec3};
use polhode::mesh::{
    ConvexHull, Decomposition, DecompositionSettings, SolidMesh, TriangleMesh, convex_decomposition, convexity,
};
use polhode_oracles::random::Random;
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Name of the case.
const CASE: &str = "mesh decomposition";
/// How far sums over the parts may be from the whole, relative to it.
const ADDITIVITY: f64 = 1e-12;
/// Random solids of the full run.
const RANDOM_SOLIDS: usize = 10_000;

/// L-shaped prism, torus, hollow ball, and random star-shaped solids with and without a void.
pub(super) fn convex_parts(context: &Context) -> CaseResult {
    let ball = |n: u32, radius: f64| star(n, |_| radius);
    let hollow = joined(&ball(6, 1.0)?, &ball(4, 0.5)?.flipped())?;
    let named = [
        ("L-shape", l_prism(DVec3::ZERO)?),
        ("torus of 24 x 12", SolidMesh::new(torus(24, 12)?)?),
        ("hollow ball", SolidMesh::new(hollow)?),
    ];
    let mut rows = Vec::new();
    for (name, solid) in &named {
        let found = convex_decomposition(solid, DecompositionSettings::default())?;
        rows.push(Row::at_most(
            CASE,
            &format!("{name}: volume, inertia of the parts, relative"),
            ADDITIVITY,
            worst(solid, &found),
        ));
        rows.push(Row::info(
            CASE,
            &format!("{name}: parts, of reflex edges"),
            found.reflex_edges as f64,
            found.parts.len() as f64,
        ));
    }
    let count = context.amount.of(RANDOM_SOLIDS);
    let (mut largest, mut dents, mut parts) = (0.0f64, 0, 0);
    let mut random = Random(1);
    for index in 0..count {
        let outer = star(4, |_| random.between(0.6, 1.4))?;
        let mesh =
            if index % 2 == 0 { outer } else { joined(&outer, &star(3, |_| random.between(0.1, 0.3))?.flipped())? };
        let solid = SolidMesh::new(mesh)?;
        let found = convex_decomposition(&solid, DecompositionSettings::default())?;
        // A NaN must not be lost, as it would be by `max`.
        let error = worst(&solid, &found);
        largest = if largest >= error { largest } else { error };
        dents += found.parts.iter().filter(|part| !convexity(part.solid()).is_convex()).count() + found.unresolved;
        parts += found.parts.len();
    }
    let quantity = format!("{count} random solids: volume, inertia of the parts, relative");
    rows.push(Row::at_most(CASE, &quantity, ADDITIVITY, largest));
    rows.push(Row::exact(CASE, &format!("{count} random solids: parts that are not convex"), 0.0, dents as f64));
    rows.push(Row::info(CASE, &format!("{count} random solids: parts in all"), count as f64, parts as f64));
    Ok(rows)
}

/// The largest relative error of volume and inertia of the parts together, about the centre of mass of the whole.
fn worst(solid: &SolidMesh, found: &Decomposition) -> f64 {
    let whole = solid.volume_integrals();
    let (mut volume, mut second) = (0.0, DMat3::ZERO);
    for part in &found.parts {
        let integrals = part.volume_integrals();
        let d = integrals.centroid - whole.centroid;
        volume += integrals.volume;
        second += integrals.second_moment + DMat3::from_cols(d * d.x, d * d.y, d * d.z) * integrals.volume;
    }
    let largest = |m: DMat3| m.to_cols_array().into_iter().fold(0.0f64, |l, x| if l >= x.abs() { l } else { x.abs() });
    let of_inertia = largest(second - whole.second_moment) / largest(whole.second_moment);
    let of_volume = (volume / whole.volume - 1.0).abs();
    if of_volume >= of_inertia { of_volume } else { of_inertia }
}

/// A star-shaped solid over a sphere of n + 1 rings of 2 n points, with a radius for each point.
fn star(n: u32, mut radius: impl FnMut(DVec3) -> f64) -> Result<TriangleMesh, Box<dyn Error>> {
    let mut directions = vec![DVec3::NEG_Z, DVec3::Z];
    for i in 1..n {
        for j in 0..2 * n {
            let latitude = FRAC_PI_2 * (2.0 * f64::from(i) / f64::from(n) - 1.0);
            let longitude = TAU * f64::from(j) / f64::from(2 * n);
            let (cos, sin) = (latitude.cos(), latitude.sin());
            directions.push(DVec3::new(cos * longitude.cos(), cos * longitude.sin(), sin));
        }
    }
    // The triangles of a convex hull of directions close the sphere, and so they close the star.
    let hull = ConvexHull::of(&directions)?;
    let sphere = hull.solid().mesh();
    let vertices = sphere.vertices().iter().map(|&v| v * radius(v)).collect();
    Ok(TriangleMesh::new(vertices, sphere.triangles().to_vec())?)
}

/// A torus about z with radii 1 and 1/4: n corners around the axis, m around the tube.
fn torus(n: u32, m: u32) -> Result<TriangleMesh, Box<dyn Error>> {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for (i, j) in (0..n).flat_map(|i| (0..m).map(move |j| (i, j))) {
        let (u, v) = (TAU * f64::from(i) / f64::from(n), TAU * f64::from(j) / f64::from(m));
        let rho = 1.0 + 0.25 * v.cos();
        vertices.push(DVec3::new(rho * u.cos(), rho * u.sin(), 0.25 * v.sin()));
        let at = |i: u32, j: u32| (i % n) * m + j % m;
        triangles.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
        triangles.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
    Ok(TriangleMesh::new(vertices, triangles)?)
}

/// Two meshes as one.
fn joined(first: &TriangleMesh, second: &TriangleMesh) -> Result<TriangleMesh, Box<dyn Error>> {
    let base = first.vertices().len() as u32;
    let vertices = [first.vertices(), second.vertices()].concat();
    let moved = second.triangles().iter().map(|triangle| triangle.map(|index| index + base));
    Ok(TriangleMesh::new(vertices, first.triangles().iter().copied().chain(moved).collect())?)
}

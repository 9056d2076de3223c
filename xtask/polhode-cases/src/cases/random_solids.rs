//! Laws that the mass properties of every solid obey, on random closed meshes: convex, star-shaped, with a void.

use super::{CaseResult, Context};
use crate::row::Row;
use glam::{DMat3, DVec3};
use polhode::mesh::{
    Cuboid, HalfBall, Refinement, SolidMesh, Sphere, SurfaceIntegrals, Torus, TriangleMesh, VolumeIntegrals,
    solid_mass_properties,
};
use polhode::spatial::{Density, Pose, Rotation};
use polhode_oracles::random::Random;
use std::error::Error;

const CASE: &str = "random solids";
/// Factors that lengths are scaled by.
const SCALES: [f64; 2] = [1e-4, 1e4];
/// Random meshes of a full run.
const MESHES: usize = 10_000;

/// Worst errors so far.
#[derive(Default)]
struct Worst {
    triangle_inequality: f64,
    rotation: f64,
    splitting: f64,
    /// A million sizes away, against the same rounded coordinates moved back, which is exact.
    far: f64,
    /// A million sizes away: change of the volume, in units of what moving the surface by one rounding makes.
    far_rounding: f64,
    scaling: f64,
}

/// Triangle inequality, invariance under rotation, distance and scale, additivity under splitting by a plane.
pub(super) fn laws(context: &Context) -> CaseResult {
    /// Of rotation and splitting, relative.
    const ROUNDING: f64 = 1e-12;
    let count = context.amount.of(MESHES);
    let sphere = Sphere::new(1.0)?.mesh(Refinement::new(1)?)?.into_mesh();
    let (mut random, mut worst) = (Random(1), Worst::default());
    for number in 0..count {
        let mesh = random_mesh(&mut random, &sphere, number % 3)?;
        check(&mut random, &mesh, &mut worst)?;
    }
    let named = |law: &str| format!("{law} ({MESHES} meshes with --full)");
    Ok(vec![
        Row::at_most(
            CASE,
            &named("excess of a moment over the sum of the others, relative"),
            0.0,
            worst.triangle_inequality,
        ),
        Row::at_most(CASE, &named("rotation: change of volume and inertia, relative"), ROUNDING, worst.rotation),
        Row::at_most(CASE, &named("two halves less the whole, relative"), ROUNDING, worst.splitting),
        Row::at_most(
            CASE,
            &named("a million sizes away: change but for rounding of coordinates, relative"),
            ROUNDING,
            worst.far,
        ),
        Row::at_most(
            CASE,
            &named("a million sizes away: change of volume, by what rounding can make"),
            1.0,
            worst.far_rounding,
        ),
        Row::at_most(CASE, &named("scaled by 1e-4 and 1e4: change, relative"), ROUNDING, worst.scaling),
    ])
}

/// Bodies as people have them, moved a million sizes away, turned, and scaled: as at home to 1e-9.
pub(super) fn moved(context: &Context) -> CaseResult {
    const ASKED: f64 = 1e-9;
    /// Places and attitudes of each body at full count.
    const PLACES: usize = 1000;
    let places = context.amount.of(PLACES);
    let level = Refinement::new(2)?;
    let bodies = [
        ("box", Cuboid::new(DVec3::new(1.0, 2.0, 3.0))?.mesh(level)?),
        ("ball", Sphere::new(1.0)?.mesh(level)?),
        ("torus", Torus::new(1.0, 0.25)?.mesh(level)?),
        ("half-ball", HalfBall::new(1.0)?.mesh(level)?),
    ];
    let mut random = Random(2);
    let mut rows = Vec::new();
    for (name, solid) in bodies {
        let (mesh, home) = (solid.mesh(), solid.volume_integrals());
        let size = mesh.bounds().diagonal();
        let mut worst = 0.0_f64;
        for _ in 0..places {
            let turn = Rotation::from_rotation_vector(random.vector(-3.0, 3.0));
            let away = random.vector(-1.0, 1.0).normalize_or(DVec3::X) * 1e6 * size;
            for factor in SCALES.into_iter().chain([1.0]) {
                let far = mesh.in_frame(&Pose::new(turn, away))?.scaled(factor)?;
                let found = VolumeIntegrals::of(&far);
                let back = turn.inverse().to_matrix();
                let cube = factor * factor * factor;
                let second = back * found.second_moment * back.transpose() * (1.0 / (cube * factor * factor));
                let center = (found.centroid / factor - away - turn.rotate(home.centroid)).length() / size;
                let volume = (found.volume / (home.volume * cube) - 1.0).abs();
                for error in [volume, center, relative(second, home.second_moment)] {
                    keep(&mut worst, error);
                }
            }
        }
        let quantity =
            format!("{name}, {places} times: turned, a million sizes away, scaled by 1e-4 to 1e4: change, relative");
        rows.push(Row::at_most("moved meshes", &quantity, ASKED, worst));
    }
    Ok(rows)
}

/// An ellipsoid's mesh (convex), one with random radii (star-shaped), or that with a void inside.
fn random_mesh(random: &mut Random, sphere: &TriangleMesh, kind: usize) -> Result<TriangleMesh, Box<dyn Error>> {
    let stretch = random.vector(0.1, 3.0);
    let turn = Rotation::from_rotation_vector(random.vector(-3.0, 3.0));
    let smallest = 0.3;
    let outer: Vec<DVec3> = sphere
        .vertices()
        .iter()
        .map(|&v| turn.rotate(v * stretch) * if kind == 0 { 1.0 } else { random.between(smallest, 2.0) })
        .collect();
    if kind < 2 {
        return Ok(TriangleMesh::new(outer, sphere.triangles().to_vec())?);
    }
    // Between the vertices a star-shaped surface comes closer to its middle than they do, but not by half.
    let void = outer.iter().zip(sphere.vertices()).map(|(_, &v)| turn.rotate(v * stretch) * (0.3 * smallest));
    let first = outer.len() as u32;
    let inward = sphere.triangles().iter().map(|&[a, b, c]| [a + first, c + first, b + first]);
    let triangles = sphere.triangles().iter().copied().chain(inward).collect();
    Ok(TriangleMesh::new(outer.iter().copied().chain(void).collect(), triangles)?)
}

fn check(random: &mut Random, mesh: &TriangleMesh, worst: &mut Worst) -> Result<(), Box<dyn Error>> {
    let body = solid_mass_properties(&SolidMesh::new(mesh.clone())?, Density::new(1.0)?)?;
    let moments = body.principal_axes().moments();
    keep(&mut worst.triangle_inequality, (moments.z - moments.x - moments.y) / moments.z);
    let whole = VolumeIntegrals::of(mesh);
    let turn = Rotation::from_rotation_vector(random.vector(-3.0, 3.0));
    let back = turn.inverse().to_matrix();
    let difference = |moved: &VolumeIntegrals| {
        let second = back * moved.second_moment * back.transpose();
        ((moved.volume / whole.volume - 1.0).abs()).max(relative(second, whole.second_moment))
    };
    let turned = mesh.in_frame(&Pose::new(turn, DVec3::ZERO))?;
    keep(&mut worst.rotation, difference(&VolumeIntegrals::of(&turned)));
    let away = random.vector(-1.0, 1.0).normalize_or(DVec3::X) * 1e6 * mesh.bounds().diagonal();
    let far = turned.translated(away)?;
    let home = VolumeIntegrals::of(&far.translated(-away)?);
    let found = VolumeIntegrals::of(&far);
    let center = (found.centroid - away - home.centroid).length() / far.bounds().largest_coordinate();
    let sums = (found.volume / home.volume - 1.0).abs().max(relative(found.second_moment, home.second_moment));
    keep(&mut worst.far, sums);
    keep(&mut worst.far, center);
    let rounding = f64::EPSILON * far.bounds().largest_coordinate() * SurfaceIntegrals::of(mesh).area;
    keep(&mut worst.far_rounding, (found.volume - whole.volume).abs() / rounding);
    for factor in SCALES {
        let scaled = VolumeIntegrals::of(&mesh.scaled(factor)?);
        let cube = factor * factor * factor;
        let volume = (scaled.volume / (whole.volume * cube) - 1.0).abs();
        let second = relative(scaled.second_moment * (1.0 / (cube * factor * factor)), whole.second_moment);
        keep(&mut worst.scaling, volume);
        keep(&mut worst.scaling, second);
    }
    let normal = random.vector(-1.0, 1.0).normalize_or(DVec3::X);
    // A point of the convex hull, so that there is something on either side.
    let vertices = mesh.vertices();
    let vertex = vertices[random.between(0.0, vertices.len() as f64) as usize % vertices.len()];
    let through = whole.centroid.lerp(vertex, random.between(0.0, 0.9));
    let [above, below] = [normal, -normal].map(|normal| half(mesh, normal, through));
    let sum = joined(&VolumeIntegrals::of(&above?), &VolumeIntegrals::of(&below?));
    let error = (sum.volume / whole.volume - 1.0).abs().max(relative(sum.second_moment, whole.second_moment));
    keep(&mut worst.splitting, error);
    Ok(())
}

/// Keeps the larger error; one that is not a number stays.
fn keep(worst: &mut f64, error: f64) {
    if error > *worst || error.is_nan() {
        *worst = error;
    }
}

/// Largest difference of elements, relative to the largest element.
fn relative(found: DMat3, expected: DMat3) -> f64 {
    let largest = |m: DMat3| {
        m.to_cols_array().into_iter().fold(0.0_f64, |l, x| if l > x.abs() || l.is_nan() { l } else { x.abs() })
    };
    largest(found - expected) / largest(expected)
}

/// The union of two disjoint solids.
fn joined(a: &VolumeIntegrals, b: &VolumeIntegrals) -> VolumeIntegrals {
    let volume = a.volume + b.volume;
    let arm = b.centroid - a.centroid;
    let outer = DMat3::from_cols(arm * arm.x, arm * arm.y, arm * arm.z);
    VolumeIntegrals {
        volume,
        centroid: a.centroid + arm * (b.volume / volume),
        second_moment: a.second_moment + b.second_moment + outer * (a.volume * b.volume / volume),
    }
}

/// What of the solid lies on the side of a plane that `normal` points to: its triangles cut off at the plane, and a fan
/// over the cut from a point of the plane. Signs make the fan right for any cut, of several outlines and with holes.
fn half(mesh: &TriangleMesh, normal: DVec3, through: DVec3) -> Result<TriangleMesh, Box<dyn Error>> {
    let mut corners: Vec<[DVec3; 3]> = Vec::new();
    for triangle in mesh.corner_positions() {
        let height = triangle.map(|p| normal.dot(p - through));
        let (mut kept, mut cut) = (Vec::new(), [None; 2]);
        for i in 0..3 {
            let j = (i + 1) % 3;
            if height[i] >= 0.0 {
                kept.push(triangle[i]);
            }
            if (height[i] >= 0.0) != (height[j] >= 0.0) {
                let at = triangle[i].lerp(triangle[j], height[i] / (height[i] - height[j]));
                kept.push(at);
                // The outline of the half leaves through the first point and comes back through the second.
                cut[usize::from(height[i] < 0.0)] = Some(at);
            }
        }
        if let [first, rest @ ..] = &kept[..] {
            corners.extend(rest.windows(2).map(|pair| [*first, pair[0], pair[1]]));
        }
        if let [Some(out), Some(back)] = cut {
            corners.push([through, back, out]);
        }
    }
    let triangles = (0..corners.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    Ok(TriangleMesh::new(corners.into_iter().flatten().collect(), triangles)?)
}

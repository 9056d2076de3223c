//! Mass properties of a torus of a million triangles: against a plain pass that sums areas, and against parry3d.
//!
//! Asked: at most twice the time of the plain pass, and no longer than parry3d. Accuracy far from the origin is printed
//! for both before the timings start.

use criterion::{Criterion, criterion_group, criterion_main};
use parry3d::mass_properties::MassProperties as ParryProperties;
use parry3d::math::Vector;
use polhode_mesh::{Refinement, SurfaceIntegrals, Torus, TriangleMesh, VolumeIntegrals};
use polhode_spatial::DVec3;
use std::hint::black_box;

/// What anybody would write: positions of the corners, a cross product, a square root, a sum.
fn plain_area(mesh: &TriangleMesh) -> f64 {
    let vertices = mesh.vertices();
    let mut sum = 0.0;
    for &[a, b, c] in mesh.triangles() {
        let (a, b, c) = (vertices[a as usize], vertices[b as usize], vertices[c as usize]);
        sum += 0.5 * (b - a).cross(c - a).length();
    }
    sum
}

fn parry_vertices(mesh: &TriangleMesh) -> Vec<Vector> {
    mesh.vertices().iter().map(|v| Vector::new(v.x, v.y, v.z)).collect()
}

/// The mesh with its coordinates rounded to multiples of 2^-26, so that it can be moved away without rounding.
fn snapped(mesh: &TriangleMesh) -> TriangleMesh {
    let grid = f64::from(1 << 26);
    let vertices = mesh.vertices().iter().map(|&v| (v * grid).round() / grid).collect();
    TriangleMesh::new(vertices, mesh.triangles().to_vec()).expect("a mesh")
}

/// Errors of volume and sum of moments of the mesh moved away by `offset`, relative, ours and parry3d's, against ours
/// at home.
fn print_accuracy(mesh: &TriangleMesh, offset: DVec3) {
    let far = mesh.translated(offset).expect("finite");
    let home = VolumeIntegrals::of(mesh);
    let ours = VolumeIntegrals::of(&far);
    let trace = |m: &VolumeIntegrals| m.second_moment.x_axis.x + m.second_moment.y_axis.y + m.second_moment.z_axis.z;
    let parry = ParryProperties::from_trimesh(1.0, &parry_vertices(&far), far.triangles());
    let moments = parry.principal_inertia();
    println!(
        "{offset:?}: relative error of the volume: ours {:.1e}, parry3d {:.1e}; of the sum of moments: ours {:.1e}, \
         parry3d {:.1e}",
        (ours.volume / home.volume - 1.0).abs(),
        (parry.mass() / home.volume - 1.0).abs(),
        (trace(&ours) / trace(&home) - 1.0).abs(),
        ((moments.x + moments.y + moments.z) / (2.0 * trace(&home)) - 1.0).abs(),
    );
}

fn mass_properties(criterion: &mut Criterion) {
    let torus = Torus::new(1.0, 0.25).expect("a torus");
    let mesh = torus.mesh(Refinement::new(6).expect("a level")).expect("a mesh").into_mesh();
    println!("{} triangles", mesh.triangles().len());
    for distance in [0.0, 1e3, 1e6] {
        print_accuracy(&snapped(&mesh), DVec3::new(1.0, -2.0, 3.0) * distance);
    }
    let vertices = parry_vertices(&mesh);
    let mut group = criterion.benchmark_group("torus of 1e6 triangles");
    group.sample_size(20);
    group.bench_function("plain pass that sums areas", |b| b.iter(|| plain_area(black_box(&mesh))));
    group.bench_function("solid", |b| b.iter(|| VolumeIntegrals::of(black_box(&mesh))));
    group.bench_function("hollow", |b| b.iter(|| SurfaceIntegrals::of(black_box(&mesh))));
    group.bench_function("parry3d from_trimesh", |b| {
        b.iter(|| ParryProperties::from_trimesh(1.0, black_box(&vertices), black_box(mesh.triangles())));
    });
    group.finish();
}

criterion_group!(benches, mass_properties);
criterion_main!(benches);

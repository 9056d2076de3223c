//! How fast mesh files are read, and OBJ beside tobj (in f64, triangulating) on the same bytes in the same run.
//!
//! The files are generated: a bumpy sphere of quads with round-trip digits, once with positions alone and once with
//! texture coordinates and normals. `READERS_MB` in the environment sets the size of the OBJ files in 10^6 bytes (20).

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use polhode_mesh::{Encoding, MeshFormat, format, obj};
use std::fmt::Write;
use std::hint::black_box;

/// Size of the files when none is asked for, 10^6 bytes.
const DEFAULT_MB: usize = 20;

/// What stands in a generated file.
#[derive(Clone, Copy, PartialEq)]
enum Content {
    Positions,
    Everything,
}

/// An OBJ file of about `bytes` bytes.
fn generated(bytes: usize, content: Content) -> Vec<u8> {
    // A vertex and its quad take about 90 bytes, and 230 with everything.
    let per_vertex = if content == Content::Positions { 90 } else { 230 };
    let n = ((bytes / per_vertex) as f64).sqrt() as usize;
    let mut text = String::with_capacity(bytes + bytes / 4);
    for i in 0..n {
        for j in 0..n {
            let (u, v) = (std::f64::consts::PI * i as f64 / n as f64, 2.0 * std::f64::consts::PI * j as f64 / n as f64);
            let r = 1.0 + 0.1 * (7.0 * u).sin() * (5.0 * v).cos();
            let (x, y, z) = (u.sin() * v.cos(), u.sin() * v.sin(), u.cos());
            let _ = writeln!(text, "v {} {} {}", r * x, r * y, r * z);
            if content == Content::Everything {
                let _ = writeln!(text, "vt {:.6} {:.6}\nvn {x:.6} {y:.6} {z:.6}", u / 4.0, v / 7.0);
            }
        }
    }
    for i in 0..n - 1 {
        for j in 0..n - 1 {
            let corners = [i * n + j, (i + 1) * n + j, (i + 1) * n + j + 1, i * n + j + 1].map(|index| index + 1);
            let [a, b, c, d] = corners;
            let _ = match content {
                Content::Positions => writeln!(text, "f {a} {b} {c} {d}"),
                Content::Everything => writeln!(text, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c} {d}/{d}/{d}"),
            };
        }
    }
    text.into_bytes()
}

/// What tobj makes of the same bytes: numbers of vertices and triangles.
fn tobj_counts(bytes: &[u8]) -> (usize, usize) {
    let options = tobj::LoadOptions { triangulate: true, ..tobj::LoadOptions::default() };
    let mut rest = bytes;
    let (models, _) =
        tobj::load_obj_buf(&mut rest, &options, |_| Ok(<(Vec<tobj::Material>, _)>::default())).expect("sound");
    let mesh = &models[0].mesh;
    (mesh.positions.len() / 3, mesh.indices.len() / 3)
}

fn readers(criterion: &mut Criterion) {
    let megabytes = std::env::var("READERS_MB").ok().and_then(|text| text.parse().ok()).unwrap_or(DEFAULT_MB);
    for (name, content) in [("positions", Content::Positions), ("everything", Content::Everything)] {
        let bytes = generated(megabytes * 1_000_000, content);
        let mesh = obj::read(&bytes).expect("sound");
        assert_eq!(tobj_counts(&bytes), (mesh.vertices().len(), mesh.triangles().len()));
        let mut group = criterion.benchmark_group(format!("obj {name}"));
        group.sample_size(10).throughput(Throughput::Bytes(bytes.len() as u64));
        group.bench_function("polhode", |b| b.iter(|| obj::read(black_box(&bytes))));
        group.bench_function("tobj", |b| b.iter(|| tobj_counts(black_box(&bytes))));
        group.finish();
        if content == Content::Positions {
            others(criterion, &mesh);
        }
    }
}

/// The other formats, of the same mesh.
fn others(criterion: &mut Criterion, mesh: &polhode_mesh::TriangleMesh) {
    let mut group = criterion.benchmark_group("others");
    group.sample_size(10);
    for (format, encoding) in [
        (MeshFormat::Off, Encoding::Text),
        (MeshFormat::Ply, Encoding::Text),
        (MeshFormat::Ply, Encoding::Binary),
        (MeshFormat::Stl, Encoding::Text),
        (MeshFormat::Stl, Encoding::Binary),
    ] {
        let bytes = format::write(mesh, format, encoding).expect("fits");
        group.throughput(Throughput::Bytes(bytes.len() as u64));
        group.bench_function(format!("{format} {encoding:?}"), |b| {
            b.iter_batched(|| (), |()| format::read(black_box(&bytes), format), BatchSize::PerIteration);
        });
    }
    group.finish();
}

criterion_group!(benches, readers);
criterion_main!(benches);

//! Convex polyhedra whose faces are known: affine images of prisms, pyramids, octahedra and icosahedra; and two that
//! are not convex, an angle and a channel, with their convex pieces.

use super::model::{Form, Triangles};
use crate::random::Random;
use glam::{DMat3, DVec3};
use std::f64::consts::TAU;

/// A convex polyhedron of about this size, m.
pub(super) fn convex(random: &mut Random, size: f64) -> Form {
    let solid = match random.below(4) {
        0 => prism(3 + random.below(5)),
        1 => pyramid(3 + random.below(4)),
        2 => octahedron(),
        _ => icosahedron(),
    };
    let stretch = DMat3::from_diagonal(random.vector(0.5, 1.0) * (0.5 * size));
    let shear = DMat3::from_cols(
        DVec3::X,
        DVec3::new(random.between(-0.3, 0.3), 1.0, 0.0),
        DVec3::new(random.between(-0.3, 0.3), random.between(-0.3, 0.3), 1.0),
    );
    let vertices = solid.vertices.iter().map(|&vertex| shear * (stretch * vertex)).collect();
    Form::Convex(Triangles { vertices, triangles: solid.triangles })
}

/// An angle or a channel of about this size, m, as one mesh.
pub(super) fn not_convex(random: &mut Random, size: f64) -> Form {
    let (wide, thick, tall) =
        (size * random.between(0.7, 1.0), size * random.between(0.15, 0.3), size * random.between(0.5, 1.0));
    let length = size * random.between(0.3, 1.0);
    // Outlines in x and z, anticlockwise seen from +y downwards; the mesh is extruded along y.
    let (outline, blocks): (Vec<[f64; 2]>, Vec<[[f64; 2]; 2]>) = if random.below(2) == 0 {
        (
            vec![[0.0, 0.0], [wide, 0.0], [wide, thick], [thick, thick], [thick, tall], [0.0, tall]],
            vec![[[0.0, 0.0], [wide, thick]], [[0.0, 0.0], [thick, tall]]],
        )
    } else {
        (
            vec![
                [0.0, 0.0],
                [wide, 0.0],
                [wide, tall],
                [wide - thick, tall],
                [wide - thick, thick],
                [thick, thick],
                [thick, tall],
                [0.0, tall],
            ],
            vec![[[0.0, 0.0], [wide, thick]], [[0.0, 0.0], [thick, tall]], [[wide - thick, 0.0], [wide, tall]]],
        )
    };
    let shift = DVec3::new(-0.5 * wide, -0.5 * length, -0.5 * tall);
    let caps: Vec<[usize; 3]> = if outline.len() == 6 {
        vec![[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]]
    } else {
        vec![[0, 1, 4], [0, 4, 5], [1, 2, 3], [1, 3, 4], [0, 5, 6], [0, 6, 7]]
    };
    let pieces = blocks
        .iter()
        .map(|[low, high]| {
            let corners = [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]];
            extruded(&corners, &[[0, 1, 2], [0, 2, 3]], length, shift)
        })
        .collect();
    Form::Mesh(extruded(&outline, &caps, length, shift), pieces)
}

/// An outline in x and z, anticlockwise seen against y, drawn along y.
fn extruded(outline: &[[f64; 2]], caps: &[[usize; 3]], length: f64, shift: DVec3) -> Triangles {
    let count = outline.len();
    let ring = |y: f64| outline.iter().map(move |[x, z]| DVec3::new(*x, y, *z) + shift);
    let vertices = ring(0.0).chain(ring(length)).collect();
    let mut triangles = Vec::new();
    for &[a, b, c] in caps {
        triangles.extend([[a, b, c], [a + count, c + count, b + count]]);
    }
    for a in 0..count {
        let b = (a + 1) % count;
        triangles.extend([[a, a + count, b + count], [a, b + count, b]]);
    }
    Triangles { vertices, triangles }
}

fn prism(sides: usize) -> Triangles {
    let ring = |z: f64| {
        (0..sides).map(move |k| {
            let angle = k as f64 / sides as f64 * TAU;
            DVec3::new(libm::cos(angle), libm::sin(angle), z)
        })
    };
    let mut triangles = Vec::new();
    for k in 1..sides - 1 {
        triangles.extend([[0, k + 1, k], [sides, sides + k, sides + k + 1]]);
    }
    for a in 0..sides {
        let b = (a + 1) % sides;
        triangles.extend([[a, b, b + sides], [a, b + sides, a + sides]]);
    }
    Triangles { vertices: ring(-1.0).chain(ring(1.0)).collect(), triangles }
}

fn pyramid(sides: usize) -> Triangles {
    let prism = prism(sides);
    let mut vertices = prism.vertices[..sides].to_vec();
    vertices.push(DVec3::Z);
    let mut triangles: Vec<[usize; 3]> = (1..sides - 1).map(|k| [0, k + 1, k]).collect();
    triangles.extend((0..sides).map(|a| [a, (a + 1) % sides, sides]));
    Triangles { vertices, triangles }
}

fn octahedron() -> Triangles {
    let vertices = vec![DVec3::X, DVec3::Y, DVec3::NEG_X, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];
    let triangles = (0..4).flat_map(|k| [[k, (k + 1) % 4, 4], [(k + 1) % 4, k, 5]]).collect();
    Triangles { vertices, triangles }
}

fn icosahedron() -> Triangles {
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let unit = 1.0 / golden.hypot(1.0);
    let mut vertices = Vec::new();
    for [a, b] in [[1.0, golden], [-1.0, golden], [1.0, -golden], [-1.0, -golden]] {
        vertices.extend([DVec3::new(0.0, a, b), DVec3::new(a, b, 0.0), DVec3::new(b, 0.0, a)].map(|v| v * unit));
    }
    let mut triangles = Vec::new();
    // Three vertices at the shortest distance from each other are a face.
    let is_edge = |a: usize, b: usize| ((vertices[a] - vertices[b]).length() - 2.0 * unit).abs() < 0.1;
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if is_edge(a, b) && is_edge(b, c) && is_edge(a, c) {
                    let outwards = (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]).dot(vertices[a]) > 0.0;
                    triangles.push(if outwards { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    Triangles { vertices, triangles }
}

//! Meshes of our own for the scenes written after the suite's descriptions, y up. Lengths in m.

use super::chains::{LINK, TUBE};
use glam::DVec3;
use polhode::mesh::{Ellipsoid, MeshError, Refinement, Torus, TriangleMesh, box_mesh};
use std::error::Error;
use std::f64::consts::TAU;

pub(super) type Made = Result<TriangleMesh, Box<dyn Error>>;

/// A cube of edge 1 about the origin.
pub(super) fn cube() -> Made {
    Ok(box_mesh(DVec3::ONE)?.into_mesh())
}

/// A square of edge 10 at y = 0, seen from above, of `cells` by `cells` squares of two triangles each.
pub(super) fn plane(cells: u32) -> Made {
    let side = cells + 1;
    let at = |index: u32| 10.0 * (f64::from(index) / f64::from(cells) - 0.5);
    let vertices = (0..side * side).map(|index| DVec3::new(at(index / side), 0.0, at(index % side))).collect();
    let mut triangles = Vec::new();
    for row in 0..cells {
        for column in 0..cells {
            let [a, b] = [row * side + column, row * side + column + 1];
            let [c, d] = [a + side, b + side];
            triangles.extend([[a, b, c], [b, d, c]]);
        }
    }
    Ok(TriangleMesh::new(vertices, triangles)?)
}

/// A tetrahedron; its corners in any order.
fn tetrahedron(corners: [DVec3; 4]) -> Result<TriangleMesh, MeshError> {
    let [a, b, c, d] = corners;
    let mesh = TriangleMesh::new(corners.to_vec(), vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])?;
    Ok(if (b - a).cross(c - a).dot(d - a) > 0.0 { mesh } else { mesh.flipped() })
}

/// A corner of a cube: three edges of length 1 along the axes, at the origin.
pub(super) fn corner() -> Made {
    Ok(tetrahedron([DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z])?)
}

/// A regular tetrahedron of edge 1 with its lowest edge along x and its highest along z, about the origin.
pub(super) fn crossed() -> Made {
    let height = 0.25 * 2.0_f64.sqrt();
    let low = |x: f64| DVec3::new(x, -height, 0.0);
    let high = |z: f64| DVec3::new(0.0, height, z);
    Ok(tetrahedron([low(0.5), low(-0.5), high(0.5), high(-0.5)])?)
}

/// A regular tetrahedron of edge 1 that stands on a face, about its centre of mass.
pub(super) fn pyramid() -> Made {
    let (apex, base) = (0.375_f64.sqrt(), -(1.0_f64 / 24.0).sqrt());
    let (inner, outer) = ((1.0_f64 / 12.0).sqrt(), (1.0_f64 / 3.0).sqrt());
    let at = |x: f64, z: f64| DVec3::new(x, base, z);
    Ok(tetrahedron([at(-0.5, inner), at(0.5, inner), at(0.0, -outer), DVec3::Y * apex])?)
}

/// A square pyramid of base 1 and height 3 with its apex up: a spike.
pub(super) fn spike() -> Made {
    let base = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)].map(|(x, z)| DVec3::new(x, 0.0, z));
    let mut vertices = base.to_vec();
    vertices.push(DVec3::Y * 3.0);
    let triangles = vec![[0, 1, 2], [0, 2, 3], [1, 0, 4], [2, 1, 4], [3, 2, 4], [0, 3, 4]];
    Ok(TriangleMesh::new(vertices, triangles)?)
}

/// A roof of base 1 by 2 and height 3 with its ridge along z: a wedge.
pub(super) fn wedge() -> Made {
    prism(&[[-0.5, 0.0], [0.5, 0.0], [0.0, 3.0]], &[[0, 1, 2]], 1.0)
}

/// A block of 2 by 1 by 4 with a groove along its top, 1 wide and half as deep: a crack.
pub(super) fn crack() -> Made {
    let outline =
        [[-1.0, -0.5], [0.0, -0.5], [1.0, -0.5], [1.0, 0.5], [0.5, 0.5], [0.0, 0.0], [-0.5, 0.5], [-1.0, 0.5]];
    let inside = [[0, 1, 6], [0, 6, 7], [1, 5, 6], [1, 4, 5], [1, 2, 4], [2, 3, 4]];
    prism(&outline, &inside, 2.0)
}

/// A block whose top is as large as the base of a cube of edge 1 and whose sides lean outwards: cliffs all around.
pub(super) fn cliff() -> Made {
    let ring = |half: f64, y: f64| {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, z)| DVec3::new(half * x, y, half * z))
    };
    let vertices = [ring(0.75, -0.5), ring(0.5, 0.5)].concat();
    let mut triangles = vec![[0, 1, 2], [0, 2, 3], [4, 6, 5], [4, 7, 6]];
    for corner in 0..4 {
        let next = (corner + 1) % 4;
        triangles.extend([[corner, corner + 4, next], [next, corner + 4, next + 4]]);
    }
    Ok(TriangleMesh::new(vertices, triangles)?)
}

/// A block whose flat top is parted by edges into eight triangles about its centre, where a cube's corners come to lie
/// on them: internal edges.
pub(super) fn internal_edges() -> Made {
    let top = [(-1.0, -1.0), (0.0, -1.0), (1.0, -1.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (-1.0, 1.0), (-1.0, 0.0)];
    let ring = |y: f64| top.map(|(x, z)| DVec3::new(x, y, z));
    let mut vertices = [ring(-0.5), ring(0.5)].concat();
    vertices.extend([DVec3::Y * -0.5, DVec3::Y * 0.5]);
    let mut triangles = Vec::new();
    for corner in 0..8 {
        let next = (corner + 1) % 8;
        triangles.extend([[corner, next, 16], [next + 8, corner + 8, 17]]);
        triangles.extend([[corner, corner + 8, next], [next, corner + 8, next + 8]]);
    }
    Ok(TriangleMesh::new(vertices, triangles)?)
}

/// An ellipsoid of semi-axes 1, 0.5 and 0.25 as a mesh of triangles.
pub(super) fn ellipsoid() -> Made {
    Ok(Ellipsoid::new(DVec3::new(1.0, 0.5, 0.25))?.mesh(Refinement::new(2)?)?.into_mesh())
}

/// A ring about z: 16 segments of 8 faces.
pub(super) fn link() -> Made {
    Ok(Torus::new(LINK, TUBE)?.mesh(Refinement::COARSEST)?.into_mesh())
}

/// A beam of 15 by 1 by 1 with a groove across it below its middle, 0.3 deep, for a knife.
pub(super) fn beam() -> Made {
    let upper = [-7.5, -0.3, 0.0, 0.3, 7.5].map(|x| [x, 0.5]);
    let lower = [[-7.5, -0.5], [-0.3, -0.5], [0.0, -0.2], [0.3, -0.5], [7.5, -0.5]];
    band(&upper, &lower, Ends::Open, 0.5)
}

/// A wedge with its edge along z in the groove of the beam.
pub(super) fn knife() -> Made {
    prism(&[[-0.2, -1.7], [0.2, -1.7], [0.0, -0.2]], &[[0, 1, 2]], 1.0)
}

/// Teeth of a gear.
const TEETH: u32 = 12;
/// Radius of a gear where its teeth mesh, m.
const PITCH_RADIUS: f64 = 1.0;
/// How far teeth reach beyond that and gaps fall short of it, m.
const TOOTH: f64 = 0.12;
/// Of the pitch, half of what a tooth takes at its root and at its tip.
const HALF_TOOTH: [f64; 2] = [8.0 / 30.0, 4.0 / 30.0];
/// Radius of a gear's bore, and that of the pin in it, m.
const BORE: [f64; 2] = [0.3, 0.296];

/// A gear about z: twelve teeth with straight sides.
pub(super) fn gear() -> Made {
    let pitch = TAU / f64::from(TEETH);
    let mut outer = Vec::new();
    for tooth in 0..TEETH {
        let [root, tip] = HALF_TOOTH;
        for (offset, radius) in [(-root, -TOOTH), (-tip, TOOTH), (tip, TOOTH), (root, -TOOTH)] {
            outer.push(on_circle(PITCH_RADIUS + radius, (f64::from(tooth) + offset) * pitch));
        }
    }
    let inner: Vec<[f64; 2]> = outer.iter().map(|&[x, y]| [x, y].map(|c| c * BORE[0] / libm::hypot(x, y))).collect();
    band(&inner, &outer, Ends::Joined, 0.25)
}

/// What a gear turns about.
pub(super) fn pin() -> Made {
    let outline: Vec<[f64; 2]> = (0..24).map(|corner| on_circle(BORE[1], TAU * f64::from(corner) / 24.0)).collect();
    polygon(&outline, 0.5)
}

/// A bar along y with teeth towards +x that mesh with those of the gear: its pitch line is x = 0.
pub(super) fn rack() -> Made {
    let pitch = PITCH_RADIUS * TAU / f64::from(TEETH);
    let mut teeth = Vec::new();
    for tooth in 0..6 {
        let [root, tip] = HALF_TOOTH;
        for (offset, x) in [(-root, -TOOTH), (-tip, TOOTH), (tip, TOOTH), (root, -TOOTH)] {
            teeth.push([x, (f64::from(tooth) + offset) * pitch]);
        }
    }
    let back: Vec<[f64; 2]> = teeth.iter().map(|&[_, y]| [-0.39, y]).collect();
    band(&back, &teeth, Ends::Open, 0.25)
}

pub(super) fn on_circle(radius: f64, angle: f64) -> [f64; 2] {
    let (sine, cosine) = libm::sincos(angle);
    [radius * cosine, radius * sine]
}

/// The prism over a convex polygon that goes round anticlockwise seen from +z.
pub(super) fn polygon(outline: &[[f64; 2]], half: f64) -> Made {
    let fan: Vec<[u32; 3]> = (2..outline.len() as u32).map(|corner| [0, corner - 1, corner]).collect();
    prism(outline, &fan, half)
}

/// Whether a band ends or closes on itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ends {
    Open,
    Joined,
}

/// The prism over a band between two lines of as many corners, whose rungs part it into quadrangles. Seen from +z the
/// band is on the right of the first line.
pub(super) fn band(left: &[[f64; 2]], right: &[[f64; 2]], ends: Ends, half: f64) -> Made {
    let count = left.len() as u32;
    let at = |z: f64| left.iter().chain(right).map(move |&[x, y]| DVec3::new(x, y, z));
    let vertices: Vec<DVec3> = at(half).chain(at(-half)).collect();
    let (behind, rungs) = (2 * count, if ends == Ends::Joined { count } else { count - 1 });
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    let mut quadrangle = |[a, b, c, d]: [u32; 4]| triangles.extend([[a, b, c], [a, c, d]]);
    for rung in 0..rungs {
        let next = (rung + 1) % count;
        let (l, m, r, q) = (rung, next, rung + count, next + count);
        quadrangle([l, r, q, m]);
        quadrangle([l + behind, m + behind, q + behind, r + behind]);
        quadrangle([l, m, m + behind, l + behind]);
        quadrangle([r, r + behind, q + behind, q]);
    }
    if ends == Ends::Open {
        let (l, r) = (0, count);
        quadrangle([l, l + behind, r + behind, r]);
        let (l, r) = (count - 1, 2 * count - 1);
        quadrangle([l, r, r + behind, l + behind]);
    }
    Ok(TriangleMesh::new(vertices, triangles)?)
}

/// The solid between an outline in the plane of x and y and its copy, `half` before and behind it. The outline goes
/// round anticlockwise seen from +z, and `inside` fills it with triangles that go round alike.
pub(super) fn prism(outline: &[[f64; 2]], inside: &[[u32; 3]], half: f64) -> Made {
    let count = outline.len() as u32;
    let at = |z: f64| outline.iter().map(move |&[x, y]| DVec3::new(x, y, z));
    let vertices = at(-half).chain(at(half)).collect();
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for &[a, b, c] in inside {
        triangles.extend([[a, c, b], [a + count, b + count, c + count]]);
    }
    for corner in 0..count {
        let next = (corner + 1) % count;
        triangles.extend([[corner, next, next + count], [corner, next + count, corner + count]]);
    }
    Ok(TriangleMesh::new(vertices, triangles)?)
}

#[cfg(test)]
mod tests {
    //! All are closed and consistently oriented, with the volumes of their forms.
    use super::*;
    use polhode::mesh::SolidMesh;

    #[test]
    fn solids_enclose_their_volumes() {
        let regular = 2.0_f64.sqrt() / 12.0;
        let [root, tip] = HALF_TOOTH;
        let outside = TOOTH * (12.0 * tip - 5.0 * (1.0 - 2.0 * root));
        let rack_area = (0.39 * (5.0 + 2.0 * root) + outside) * TAU / 12.0;
        // Triangles from the axis to each side of the outlines, which are 4, 8, 4 and 14 degrees wide.
        let sine = |degrees: f64| libm::sin(degrees * TAU / 360.0);
        let ring = |r: f64, s: f64| 6.0 * (2.0 * r * s * sine(4.0) + s * s * sine(8.0) + r * r * sine(14.0));
        let gear_area = ring(PITCH_RADIUS - TOOTH, PITCH_RADIUS + TOOTH) - ring(BORE[0], BORE[0]);
        for (name, mesh, volume) in [
            ("cube", cube(), 1.0),
            ("corner", corner(), 1.0 / 6.0),
            ("crossed", crossed(), regular),
            ("pyramid", pyramid(), regular),
            ("spike", spike(), 1.0),
            ("wedge", wedge(), 3.0),
            ("crack", crack(), 8.0 - 1.0),
            ("cliff", cliff(), (2.25 + 1.5 + 1.0) / 3.0),
            ("internal edges", internal_edges(), 4.0),
            ("beam", beam(), 15.0 - 0.09),
            ("knife", knife(), 0.6),
            ("rack", rack(), 0.5 * rack_area),
            ("gear", gear(), 0.5 * gear_area),
        ] {
            let solid = SolidMesh::new(mesh.expect("a mesh")).expect("a solid");
            let measured = solid.volume_integrals().volume;
            assert!((measured - volume).abs() < 1e-14, "{name}: {measured}, expected {volume}");
        }
        assert_eq!(plane(64).expect("a mesh").triangles().len(), 8192);
    }
}

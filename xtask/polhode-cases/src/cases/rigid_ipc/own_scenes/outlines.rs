//! Meshes of the scenes in the plane: outlines and what lies between two lines, as prisms along z. Lengths in m.

use super::meshes::{Ends, Made, band, on_circle, polygon, prism};
use std::f64::consts::TAU;

/// Half of how far bodies that move reach along z; what holds them reaches twice as far.
const HALF: f64 = 0.5;
/// Half of how far a frame reaches along z.
const FRAME_HALF: f64 = 1.0;

/// A regular octagon with corners at 0.5 m; one of them on the x axis.
pub(super) fn octagon() -> Made {
    let corners: Vec<[f64; 2]> = (0..8).map(|corner| on_circle(0.5, TAU * f64::from(corner) / 8.0)).collect();
    polygon(&corners, HALF)
}

/// A frame about the origin: half of its width and height inside, and how thick it is.
pub(super) fn frame(half: [f64; 2], wall: f64) -> Made {
    let corners = |more: f64| {
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| [x * (half[0] + more), y * (half[1] + more)])
    };
    band(&corners(0.0), &corners(wall), Ends::Joined, FRAME_HALF)
}

/// Width of a tooth of the saw that a square falls on, m.
const SAW_PITCH: f64 = 0.08;
/// Height of its teeth's tips and of the gaps' ground above its flat side, m.
const SAW_HEIGHTS: [f64; 2] = [1.0, 0.2];

/// A saw of `count` teeth from the origin along x, their tips up, with sides that are upright on the left.
pub(super) fn saw(count: u32) -> Made {
    let [tip, root] = SAW_HEIGHTS;
    let at = |index: u32| SAW_PITCH * f64::from(index);
    // Seen from +z anticlockwise: the flat side from left to right, then roots and tips from right to left.
    let mut outline: Vec<[f64; 2]> = (0..=count).map(|index| [at(index), 0.0]).collect();
    for tooth in (0..count).rev() {
        outline.extend([[at(tooth + 1), root], [at(tooth), tip]]);
    }
    outline.push([0.0, root]);
    let flat = |index: u32| index;
    let root = |tooth: u32| count + 1 + 2 * (count - 1 - tooth);
    let (tip, first) = (|tooth: u32| root(tooth) + 1, 3 * count + 1);
    let mut inside = Vec::new();
    for tooth in 0..count {
        let before = if tooth == 0 { first } else { root(tooth - 1) };
        inside.push([flat(tooth), flat(tooth + 1), root(tooth)]);
        inside.push([flat(tooth), root(tooth), before]);
        inside.push([before, root(tooth), tip(tooth)]);
    }
    prism(&outline, &inside, HALF)
}

/// Height of what the teeth of interlocking saws stand on, m.
const BACK: f64 = 1.0;

/// A saw of `count` teeth of width and height 1 from the origin along x, tips up, on a bar.
pub(super) fn teeth(count: u32) -> Made {
    let corners = (0..=2 * count).map(|index| (0.5 * f64::from(index), f64::from(index % 2)));
    let (upper, lower): (Vec<[f64; 2]>, Vec<[f64; 2]>) = corners.map(|(x, y)| ([x, y], [x, -BACK])).unzip();
    band(&upper, &lower, Ends::Open, HALF)
}

/// A box open above, 8 m wide and 10 m deep inside, whose walls go on outwards at 45 degrees: a funnel.
pub(super) fn funnel() -> Made {
    let (out, wall) = (5.0 * 2.0_f64.sqrt(), 0.5 * 2.0_f64.sqrt());
    let inner = [[4.0 + out, 10.5 + out], [4.0, 10.5], [4.0, 0.5]];
    let outer = [[4.0 + out + wall, 10.5 + out - wall], [5.0, 11.5 - 2.0 * wall], [5.0, -0.5]];
    let both = |half: [[f64; 2]; 3]| {
        let [top, rim, ground] = half;
        [[-top[0], top[1]], [-rim[0], rim[1]], [-ground[0], ground[1]], ground, rim, top]
    };
    band(&both(inner), &both(outer), Ends::Open, FRAME_HALF)
}

/// A V whose two legs are 1.4 m high and become thinner upwards.
pub(super) fn vee() -> Made {
    let inner = [[-0.45, 1.5], [0.0, 0.24], [0.45, 1.5]];
    let outer = [[-0.5, 1.5], [0.0, 0.1], [0.5, 1.5]];
    band(&inner, &outer, Ends::Open, HALF)
}

/// A wheel of radius 2 with a round hole of radius 1, both of 25 sides.
pub(super) fn wheel() -> Made {
    let circle =
        |radius: f64| (0..25).map(|corner| on_circle(radius, TAU * f64::from(corner) / 25.0)).collect::<Vec<_>>();
    band(&circle(1.0), &circle(2.0), Ends::Joined, HALF)
}

#[cfg(test)]
mod tests {
    //! All are closed and consistently oriented, with the volumes of their outlines.
    use super::*;
    use polhode::mesh::SolidMesh;

    #[test]
    fn prisms_enclose_the_area_of_their_outlines() {
        let sine = |part: f64| libm::sin(TAU * part);
        for (name, mesh, volume) in [
            ("octagon", octagon(), 8.0 * 0.125 * sine(0.125)),
            ("frame", frame([2.0, 1.0], 0.5), 2.0 * (5.0 * 3.0 - 4.0 * 2.0)),
            ("saw", saw(100), 100.0 * SAW_PITCH * 0.6),
            ("teeth", teeth(10), 10.0 * (0.5 + BACK)),
            ("vee", vee(), 0.7 - 0.45 * 1.26),
            ("wheel", wheel(), 12.5 * 3.0 * sine(0.04)),
        ] {
            let solid = SolidMesh::new(mesh.expect("a mesh")).expect("a solid");
            let measured = solid.volume_integrals().volume;
            assert!((measured - volume).abs() < 1e-13, "{name}: {measured}, expected {volume}");
        }
        assert!(SolidMesh::new(funnel().expect("a mesh")).is_ok());
    }
}

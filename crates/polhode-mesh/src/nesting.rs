//! Which components of a mesh face the wrong way, given which lie inside which.
//!
//! A closed component of a sound solid parts winding number 0 (outside) from 1 (material). Let w be the winding number
//! of all other closed components at a point of it: an outer surface (positive volume) needs w = 0, the surface of a
//! void (negative volume) needs w = 1. So a lone component of negative volume is inside out, and so is one of positive
//! volume inside another: its material would count twice.
//!
//! The winding number is the sum of the signed solid angles of the triangles over 4 pi (docs/REFERENCES.md, Van
//! Oosterom and Strackee 1983): `tan(omega / 2) = a . (b x c) / (abc + (a . b) c + (b . c) a + (c . a) b)`. It is exact
//! to rounding away from the surface. A point on the surface of another component, where parts touch, has half a
//! winding number: the triangle it lies on is given the angle 0 between its two sides. Then another point decides, the
//! clearest of a few. Cost: components times the triangles of the components whose bounding boxes hold them.

use crate::surface_integrals::triangle_area;
use crate::topology::{Component, Topology};
use crate::triangle_mesh::{Bounds, COORDINATE_ROUNDING, TriangleMesh};
use crate::volume_integrals::{signed_volume, volume_rounding};
use glam::DVec3;
use std::f64::consts::PI;

/// How many points of a component are looked at before the clearest winding number is taken.
const PROBES: usize = 8;

/// How far (dimensionless) a winding number may be from an integer and still be clear. Half a unit is the worst; a
/// point on a smooth part of another surface gives exactly that.
const CLEAR: f64 = 0.1;

/// Distance from the plane of a triangle, in roundings of the coordinates, within which a point counts as on it: parts
/// that touch were made by a few operations each.
const TOUCH_ROUNDINGS: f64 = 16.0;

/// A closed component that is inside out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct InvertedComponent {
    /// Its first triangle.
    pub(crate) first_triangle: u32,
    /// Number of its triangles.
    pub(crate) triangles: usize,
    /// Its signed volume, m^3.
    pub(crate) volume: f64,
}

/// A closed component with its extent.
struct Shell<'a> {
    component: &'a Component,
    bounds: Bounds,
    volume: f64,
}

/// The closed components that face the wrong way, ordered by their first triangle.
pub(crate) fn inverted_components(mesh: &TriangleMesh, topology: &Topology) -> Vec<InvertedComponent> {
    let shells: Vec<Shell<'_>> = topology
        .components
        .iter()
        .filter(|component| component.is_closed)
        .filter_map(|component| Shell::of(mesh, component))
        .collect();
    shells
        .iter()
        .zip(inverted(mesh, &shells))
        .filter(|&(_, is_inverted)| is_inverted)
        .map(|(shell, _)| InvertedComponent {
            first_triangle: shell.component.triangles.first().copied().unwrap_or_default(),
            triangles: shell.component.triangles.len(),
            volume: shell.volume,
        })
        .collect()
}

/// The closed components to be turned round so that none is inverted: judged by how many others lie around each, in
/// whatever direction those run now.
pub(crate) fn misdirected_components<'a>(mesh: &TriangleMesh, topology: &'a Topology) -> Vec<&'a Component> {
    let closed = topology.components.iter().filter(|component| component.is_closed);
    let shells: Vec<Shell<'_>> = closed.filter_map(|component| Shell::of(mesh, component)).collect();
    let mut misdirected = Vec::new();
    for (index, holders) in holders(&shells) {
        let shell = &shells[index];
        let around = holders.iter().filter(|&&holder| winding_around(mesh, shell, &[holder]) != 0).count();
        if (shell.volume > 0.0) != around.is_multiple_of(2) {
            misdirected.push(shell.component);
        }
    }
    misdirected
}

impl<'a> Shell<'a> {
    /// None for a component that is flat to rounding (or overflows): it has no inside and cannot face the wrong way.
    fn of(mesh: &TriangleMesh, component: &'a Component) -> Option<Self> {
        let bounds = Bounds::of(corners(mesh, component).flatten());
        let volume = signed_volume(corners(mesh, component), bounds.center());
        let area = corners(mesh, component).map(triangle_area).sum();
        (volume.abs() > volume_rounding(area, bounds.largest_coordinate())).then_some(Self {
            component,
            bounds,
            volume,
        })
    }
}

fn corners<'a>(mesh: &'a TriangleMesh, component: &'a Component) -> impl Iterator<Item = [DVec3; 3]> + 'a {
    component.triangles.iter().map(|&triangle| mesh.corners(mesh.triangles()[triangle as usize]))
}

/// Which shells are inverted.
fn inverted(mesh: &TriangleMesh, shells: &[Shell<'_>]) -> Vec<bool> {
    let mut result = vec![false; shells.len()];
    for (index, holders) in holders(shells) {
        let shell = &shells[index];
        let winding = winding_around(mesh, shell, &holders);
        result[index] = if shell.volume > 0.0 { winding != 0 } else { winding != 1 };
    }
    result
}

/// For each shell the others whose bounding boxes hold its own, found in one sweep along x: only they can wind around
/// it.
fn holders<'s, 'a>(shells: &'s [Shell<'a>]) -> Vec<(usize, Vec<&'s Shell<'a>>)> {
    let mut order: Vec<usize> = (0..shells.len()).collect();
    // Where two begin together, the one that ends later comes first, so that it is open when the other is met.
    order.sort_by(|&i, &j| {
        let (a, b) = (&shells[i].bounds, &shells[j].bounds);
        a.min.x.total_cmp(&b.min.x).then(b.max.x.total_cmp(&a.max.x)).then(i.cmp(&j))
    });
    let mut result = Vec::with_capacity(shells.len());
    let mut open: Vec<usize> = Vec::new();
    for &index in &order {
        let shell = &shells[index];
        open.retain(|&other| shells[other].bounds.max.x >= shell.bounds.min.x);
        let holds = |other: &Bounds| other.contains(shell.bounds.min) && other.contains(shell.bounds.max);
        result.push((index, open.iter().map(|&other| &shells[other]).filter(|other| holds(&other.bounds)).collect()));
        open.push(index);
    }
    result
}

/// Winding number of `others` around `shell`.
fn winding_around(mesh: &TriangleMesh, shell: &Shell<'_>, others: &[&Shell<'_>]) -> i64 {
    if others.is_empty() {
        return 0;
    }
    let largest_coordinate =
        others.iter().fold(0.0f64, |largest, other| largest.max(other.bounds.largest_coordinate()));
    let touch = TOUCH_ROUNDINGS * COORDINATE_ROUNDING * largest_coordinate;
    let (mut clearest, mut distance) = (0, f64::INFINITY);
    for [a, b, c] in corners(mesh, shell.component).take(PROBES) {
        // The middle of a triangle, because other components are more likely to be touched at vertices.
        let point = (a + b + c) / 3.0;
        let triangles = others.iter().flat_map(|other| corners(mesh, other.component));
        let winding = triangles.map(|triangle| solid_angle(triangle, point, touch)).sum::<f64>() / (4.0 * PI);
        let nearest = winding.round();
        if (winding - nearest).abs() < distance {
            (clearest, distance) = (nearest as i64, (winding - nearest).abs());
        }
        if distance < CLEAR {
            break;
        }
    }
    clearest
}

/// Signed solid angle of a triangle seen from `point`, sr; positive when it is seen from behind, that is from inside;
/// 0 from within `touch` (m) of its plane.
pub(crate) fn solid_angle(corners: [DVec3; 3], point: DVec3, touch: f64) -> f64 {
    let [a, b, c] = corners.map(|p| p - point);
    let cross = (b - a).cross(c - a);
    let six_volume = a.dot(cross);
    if six_volume.abs() <= touch * cross.length() {
        return 0.0;
    }
    let (la, lb, lc) = (a.length(), b.length(), c.length());
    2.0 * libm::atan2(six_volume, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb)
}

//! Round shapes of standard size, about z.

use super::detail::Detail;
use super::revolution::{Line, ProfilePoint, revolve};
use crate::surface_mesh::SurfaceMesh;
use std::f64::consts::{PI, TAU};

/// The sphere of radius 1 about the origin, with its equator and two circles through the poles as lines.
pub fn unit_sphere(detail: Detail) -> SurfaceMesh {
    revolve(&[arc(detail, 0.0, 0..=half_circle(detail))], Line::Drawn, detail)
}

/// The cylinder of radius 1 and height 1 about the origin.
pub fn unit_cylinder(detail: Detail) -> SurfaceMesh {
    let side = vec![rim([1.0, -0.5], [1.0, 0.0]), rim([1.0, 0.5], [1.0, 0.0])];
    let top = vec![plain([1.0, 0.5], [0.0, 1.0]), plain([0.0, 0.5], [0.0, 1.0])];
    revolve(&[disc(-0.5), side, top], Line::Absent, detail)
}

/// The cone with a base of radius 1 about the origin and its apex at height 1. Its `normals` are those of this cone;
/// scaled they become those of any other.
pub fn unit_cone(detail: Detail) -> SurfaceMesh {
    let normal = [std::f64::consts::FRAC_1_SQRT_2; 2];
    let side = vec![rim([1.0, 0.0], normal), plain([0.0, 1.0], normal)];
    revolve(&[disc(0.0), side], Line::Absent, detail)
}

/// The capsule of radius 1 about the segment of this half-length along z.
pub fn capsule(half_length: f64, detail: Detail) -> SurfaceMesh {
    let quarter = half_circle(detail) / 2;
    let mut profile = arc(detail, -half_length, 0..=quarter);
    profile.extend(arc(detail, half_length, quarter..=2 * quarter));
    revolve(&[profile], Line::Drawn, detail)
}

/// The torus about the circle of radius 1, with a tube of this radius; its outermost circle is drawn as a line, and
/// four circles around the tube.
pub fn torus(minor: f64, detail: Detail) -> SurfaceMesh {
    let count = half_circle(detail);
    let profile = (0..=count).map(|i| {
        // From the innermost circle down, out, up and back, so that the tube is on the left.
        let (sin, cos) = if i == count { (0.0, 1.0) } else { libm::sincos(TAU * f64::from(i) / f64::from(count)) };
        let line = if 2 * i == count { Line::Drawn } else { Line::Absent };
        ProfilePoint { place: [1.0 - minor * cos, -minor * sin], normal: [-cos, -sin], line }
    });
    revolve(&[profile.collect()], Line::Drawn, detail)
}

/// Segments from pole to pole: even.
fn half_circle(detail: Detail) -> u32 {
    detail.segments() / 2
}

/// Points of the half-circle of radius 1 from the lowest point up, about the given height.
fn arc(detail: Detail, height: f64, range: std::ops::RangeInclusive<u32>) -> Vec<ProfilePoint> {
    let count = half_circle(detail);
    let point = |i: u32| {
        let (sin, cos) = libm::sincos(PI * f64::from(i) / f64::from(count));
        // The poles lie on the axis exactly.
        let sin = if i == 0 || i == count { 0.0 } else { sin };
        let line = if 2 * i == count { Line::Drawn } else { Line::Absent };
        ProfilePoint { place: [sin, height - cos], normal: [sin, -cos], line }
    };
    range.map(point).collect()
}

/// A disc of radius 1 that faces down.
fn disc(height: f64) -> Vec<ProfilePoint> {
    vec![plain([0.0, height], [0.0, -1.0]), plain([1.0, height], [0.0, -1.0])]
}

fn rim(place: [f64; 2], normal: [f64; 2]) -> ProfilePoint {
    ProfilePoint { place, normal, line: Line::Drawn }
}

fn plain(place: [f64; 2], normal: [f64; 2]) -> ProfilePoint {
    ProfilePoint { place, normal, line: Line::Absent }
}

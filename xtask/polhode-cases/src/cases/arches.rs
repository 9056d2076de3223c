//! FC-13: semicircular arches of stones whose joints do not slip, at their least thickness.
//!
//! Joints are radial, or vertical: then a stone is what stands of the ring between two vertical planes.
//!
//! A stone is a sector of the ring of mean radius 1 m and thickness t, as heavy as its area. An arch cut at its crown,
//! at its springings and at an angle `b` on both sides of the crown falls on five hinges; the angle at which it must be
//! thickest is that at which an arch of one piece breaks (Milankovitch 1907).

use super::bodies::half_space;
use super::motion::zero;
use super::rough_plane::{is_in_equilibrium, rough, threshold};
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::contact::{ConvexPolyhedron, Shape};
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, UnitVector};
use polhode::{Body, Scene};
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};

/// Friction that lets no joint slip.
const ROUGH: f64 = 10.0;

/// Depth of the stones, m.
const DEPTH: f64 = 0.2;

/// The stone between two angles from the crown, rad, positive to the right.
fn stone(name: String, from: f64, to: f64, thickness: f64) -> Result<Body, Box<dyn Error>> {
    let (inner, outer) = (1.0 - 0.5 * thickness, 1.0 + 0.5 * thickness);
    let half = 0.5 * (to - from);
    let radial = |angle: f64| DVec3::new(angle.sin(), 0.0, angle.cos());
    // Centroid of a sector of a ring.
    let distance = 2.0 / 3.0 * (outer.powi(3) - inner.powi(3)) / (outer * outer - inner * inner) * half.sin() / half;
    let center = radial(0.5 * (from + to)) * distance;
    let corners = [radial(from) * inner, radial(from) * outer, radial(to) * outer, radial(to) * inner];
    block(name, corners, (half * (outer * outer - inner * inner), center))
}

/// A stone with these corners in the plane of the arch, clockwise as one looks along y, and this mass (kg) and centre
/// of mass.
fn block(name: String, corners: [DVec3; 4], (mass, center): (f64, DVec3)) -> Result<Body, Box<dyn Error>> {
    let mut points = Vec::new();
    for y in [-0.5 * DEPTH, 0.5 * DEPTH] {
        points.extend(corners.map(|corner| corner + DVec3::Y * y - center));
    }
    let faces = vec![
        vec![3, 2, 1, 0],
        vec![5, 6, 7, 4],
        vec![1, 5, 4, 0],
        vec![2, 6, 5, 1],
        vec![3, 7, 6, 2],
        vec![0, 4, 7, 3],
    ];
    // Statics does not ask for the moments; any will do.
    let properties =
        MassProperties::new(Mass::new(mass)?, DVec3::ZERO, Inertia::from_diagonal(DVec3::splat(0.1 * mass))?);
    Ok(Body::movable(name, properties)
        .geometry(Shape::convex(ConvexPolyhedron::from_faces(points, faces)?).into())
        .pose(Pose::from_translation(center))
        .material(rough(ROUGH)?))
}

/// The part of a disc of this radius (m) above the level and within `x` (m) of its middle: area, m^2, and its moment
/// about the vertical through the middle, m^3. Of that to the right alone the moment is positive.
fn under_a_circle(radius: f64, x: f64) -> [f64; 2] {
    let x = x.min(radius);
    let height = (radius * radius - x * x).sqrt();
    let area = 0.5 * (x * height + radius * radius * x.atan2(height));
    [area, (radius.powi(3) - height.powi(3)) / 3.0]
}

/// The stone of an arch with vertical joints between two distances from the crown, m; the last ends at the ground.
/// `side` is 1 to the right of the crown, and -1 to the left.
fn upright_stone(side: f64, [from, to]: [f64; 2], thickness: f64) -> Result<Body, Box<dyn Error>> {
    let (inner, outer) = (1.0 - 0.5 * thickness, 1.0 + 0.5 * thickness);
    let between = |radius: f64| {
        let ([near, near_moment], [far, far_moment]) = (under_a_circle(radius, from), under_a_circle(radius, to));
        [far - near, far_moment - near_moment]
    };
    let ([ring, ring_moment], [hole, hole_moment]) = (between(outer), between(inner));
    let area = ring - hole;
    // Moment about the level: half the square of the height of each circle over its width.
    let square = |radius: f64, x: f64| {
        let x = x.min(radius);
        0.5 * (radius * radius * x - x * x * x / 3.0)
    };
    let level = |radius: f64| square(radius, to) - square(radius, from);
    let center = DVec3::new(side * (ring_moment - hole_moment), 0.0, level(outer) - level(inner)) / area;
    let at = |radius: f64, x: f64| {
        let x = x.min(radius);
        DVec3::new(side * x, 0.0, (radius * radius - x * x).sqrt())
    };
    let mut corners = [at(inner, from), at(outer, from), at(outer, to), at(inner, to)];
    if side < 0.0 {
        corners.reverse();
    }
    block(format!("stone {side} {from}"), corners, (area, center))
}

/// The least thickness of an arch with vertical joints, cut at the crown and at this distance (m) on both sides of it,
/// m.
fn upright_cut_at(distance: f64) -> Result<f64, Box<dyn Error>> {
    let arch = |thickness: f64| -> Result<Scene, Box<dyn Error>> {
        let mut scene = Scene::builder("arch");
        for side in [-1.0, 1.0] {
            for ends in [[0.0, distance], [distance, 2.0]] {
                scene = scene.body(upright_stone(side, ends, thickness)?);
            }
        }
        Ok(scene.body(half_space("ground", UnitVector::Z).material(rough(ROUGH)?)).build()?)
    };
    threshold(0.2, 0.02, |thickness| is_in_equilibrium(&arch(thickness)?))
}

/// That of an arch with vertical joints that may break anywhere, m, and the distance (m) of that joint from the crown:
/// the top of the parabola through three of them.
fn upright() -> Result<[f64; 2], Box<dyn Error>> {
    const MIDDLE: f64 = 0.78;
    const SPACING: f64 = 0.02;
    let [low, middle, high] = [-SPACING, 0.0, SPACING].map(|shift| upright_cut_at(MIDDLE + shift));
    let (low, middle, high) = (low?, middle?, high?);
    let (slope, bend) = (0.5 * (high - low), high - 2.0 * middle + low);
    Ok([middle - 0.5 * slope * slope / bend, MIDDLE - SPACING * slope / bend])
}

/// An arch with joints at these angles from the crown, rad.
fn arch(joints: &[f64], thickness: f64) -> Result<Scene, Box<dyn Error>> {
    let mut scene = Scene::builder("arch");
    for (index, ends) in joints.windows(2).enumerate() {
        scene = scene.body(stone(format!("stone {index}"), ends[0], ends[1], thickness)?);
    }
    Ok(scene.body(half_space("ground", UnitVector::Z).material(rough(ROUGH)?)).build()?)
}

/// The least thickness at which an arch with these joints stands, m.
fn least_thickness(joints: &[f64]) -> Result<f64, Box<dyn Error>> {
    threshold(0.2, 0.02, |thickness| is_in_equilibrium(&arch(joints, thickness)?))
}

/// That of an arch cut at the crown and at this angle on both sides of it, m.
fn cut_at(angle: f64) -> Result<f64, Box<dyn Error>> {
    least_thickness(&[-FRAC_PI_2, -angle, 0.0, angle, FRAC_PI_2])
}

/// The derivative of [`cut_at`], by central differences of two spacings.
fn change_at(angle: f64) -> Result<f64, Box<dyn Error>> {
    const SPACING: f64 = 0.01;
    let difference =
        |h: f64| -> Result<f64, Box<dyn Error>> { Ok((cut_at(angle + h)? - cut_at(angle - h)?) / (2.0 * h)) };
    Ok((4.0 * difference(SPACING)? - difference(2.0 * SPACING)?) / 3.0)
}

/// Least thicknesses of arches of equal stones, and of an arch that may break anywhere.
pub(super) fn fc_13(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let hinge = zero([0.9, 1.0], change_at)?;
    let mut rows = vec![reference.row(
        "FC-13",
        "monolithic t/R, hinge angle from crown (deg)",
        [cut_at(hinge)?, hinge.to_degrees()],
    )?];
    for stones in [8u32, 9, 16, 20, 21] {
        let joints: Vec<f64> = (0..=stones).map(|k| PI * f64::from(k) / f64::from(stones) - FRAC_PI_2).collect();
        let quantity = format!("{stones} equal voussoirs: critical t/R");
        rows.push(reference.row("FC-13", &quantity, least_thickness(&joints)?)?);
    }
    let [thickness, distance] = upright()?;
    rows.push(reference.row("FC-13", "vertical joints: t/R", thickness)?);
    rows.push(Row::info("FC-13", "vertical joints: distance of the hinge from the crown, m", "", distance));
    Ok(rows)
}

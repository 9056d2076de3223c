//! FC-13: semicircular arches of stones with radial joints that do not slip, at their least thickness.
//!
//! A stone is a sector of the ring of mean radius 1 m and thickness t, as heavy as its area. An arch cut at its crown,
//! at its springings and at an angle `b` on both sides of the crown falls on five hinges; the angle at which it must be
//! thickest is that at which an arch of one piece breaks (Milankovitch 1907).

use super::bodies::half_space;
use super::motion::zero;
use super::rough_plane::{is_in_equilibrium, rough, threshold};
use super::{CaseResult, Context};
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
    let mut points = Vec::new();
    for y in [-0.5 * DEPTH, 0.5 * DEPTH] {
        for corner in [radial(from) * inner, radial(from) * outer, radial(to) * outer, radial(to) * inner] {
            points.push(corner + DVec3::Y * y - center);
        }
    }
    let faces = vec![
        vec![3, 2, 1, 0],
        vec![5, 6, 7, 4],
        vec![1, 5, 4, 0],
        vec![2, 6, 5, 1],
        vec![3, 7, 6, 2],
        vec![0, 4, 7, 3],
    ];
    let mass = half * (outer * outer - inner * inner);
    // Statics does not ask for the moments; any will do.
    let properties =
        MassProperties::new(Mass::new(mass)?, DVec3::ZERO, Inertia::from_diagonal(DVec3::splat(0.1 * mass))?);
    Ok(Body::movable(name, properties)
        .geometry(Shape::convex(ConvexPolyhedron::from_faces(points, faces)?).into())
        .pose(Pose::from_translation(center))
        .material(rough(ROUGH)?))
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
    Ok(rows)
}

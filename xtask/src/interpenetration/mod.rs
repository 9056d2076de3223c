//! Whether bodies are in each other at the samples of a run: a check that shares no code with polhode-contact.
//!
//! It starts from triangle meshes (or corners without faces) and sampled poses. Every vertex is placed by the pose (and
//! rounded once); from there on:
//!
//! 1. *Depth.* A convex body is one piece, another one that moves the convex parts of its exact decomposition, another one
//!    that is fixed the triangles of its surface, corners without faces a piece each. Two pieces of two bodies whose boxes
//!    overlap must be parted by a move of at most the tolerance, which a direction proves (`depth`). This covers vertices
//!    in faces, edges through edges and faces through faces, coincident bodies and one convex body within another.
//! 2. *Within.* The marks of a body must not be inside a solid that is not convex.
//! 3. *Through.* Between two samples the marks of a body, seen from the other one, must not cross its surface: a body that
//!    is beyond a surface without a thickness, or a link that has left another, is in nothing. The straight way between
//!    the two samples is tested against each triangle by exact signs of determinants (`robust`). It is the true way only as far as
//!    bodies turn little from sample to sample: scenes of fast ones are sampled more often.
//!
//! The mark of a body is its centre of mass. A body that does not hold its own, as a ring, has the centres of its convex
//! parts and the places halfway from there to their corners.
//!
//! Tolerance: 1e-12 of the smaller of the two sizes and 4 epsilon of the largest coordinate, the bound that the project's
//! design judges penetration by. Nothing is shrunk: a depth of up to the tolerance passes.

mod depth;
mod part;
mod wide;

use crate::cases::Run;
use glam::DVec3;
use part::Part;
use polhode::mesh::{DecompositionSettings, PointLocator, SolidMesh, TriangleMesh, convex_decomposition, convexity};
use polhode::{BodySample, Scene};
use polhode_spatial::Pose;
use robust::{Coord3D, orient3d};
use std::collections::BTreeMap;
use std::error::Error;

/// What of the smaller size a depth may be.
const SIZE_RELATIVE: f64 = 1e-12;
/// What of the largest coordinate a depth may be, in units of epsilon.
const COORDINATE_ULPS: f64 = 4.0;

/// What was found.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Findings {
    /// The largest depth beyond the tolerance, m: 0 when there is none.
    pub(crate) beyond_m: f64,
    /// The largest depth relative to its tolerance, as far as it was pursued.
    pub(crate) of_tolerance: f64,
    /// Time of the first depth beyond the tolerance, s.
    pub(crate) since_s: Option<f64>,
    /// Marks found inside a solid.
    pub(crate) within: u64,
    /// Marks that went through a surface.
    pub(crate) through: u64,
    /// Pairs of pieces whose boxes overlapped.
    pub(crate) pairs: u64,
}

/// The form of a body in its own frame.
#[derive(Debug)]
pub(crate) enum Form {
    Mesh(TriangleMesh),
    /// Corners without faces.
    Points(Vec<DVec3>),
}

/// A body as the check sees it.
struct Checked {
    /// None of corners without faces.
    mesh: Option<TriangleMesh>,
    parts: Vec<Part>,
    /// Of a solid that is not convex.
    locator: Option<PointLocator>,
    /// Places inside the body, in its frame; of one that moves.
    marks: Vec<DVec3>,
    size: f64,
}

/// Checks all samples of a run. `forms` are those of the bodies, in the order of the scene.
///
/// # Errors
/// When there is not one form for each body, or one that moves has no convex parts.
pub(crate) fn check(run: &Run, forms: &[Form]) -> Result<Findings, Box<dyn Error>> {
    let scene = &run.scene;
    if forms.len() != scene.bodies().len() {
        return Err(format!("{} forms for {} bodies", forms.len(), scene.bodies().len()).into());
    }
    let pairs: Vec<(usize, usize)> = (0..forms.len())
        .flat_map(|a| (a + 1..forms.len()).map(move |b| (a, b)))
        .filter(|&(a, b)| scene.may_collide(a, b))
        .collect();
    let meets = |body: usize| pairs.iter().any(|&(a, b)| a == body || b == body);
    let mut bodies = Vec::new();
    for (index, form) in forms.iter().enumerate() {
        bodies.push(checked(scene, index, form, meets(index)).map_err(|error| format!("body {index}: {error}"))?);
    }
    let mut findings = Findings::default();
    let mut hints = BTreeMap::new();
    let mut before: Option<&Vec<BodySample>> = None;
    let mut placed: Vec<(Pose, Vec<Part>)> = Vec::new();
    for (&t, samples) in run.record.times.iter().zip(&run.record.samples) {
        place(&bodies, samples, &mut placed);
        for &(a, b) in &pairs {
            let tolerance = tolerance(&bodies, &placed, a, b);
            let hints: &mut BTreeMap<_, _> = hints.entry((a, b)).or_default();
            let found = depths(&placed[a].1, &placed[b].1, tolerance, hints, &mut findings);
            if found > tolerance {
                findings.beyond_m = findings.beyond_m.max(found);
                findings.since_s.get_or_insert(t);
            }
            for (one, other) in [(a, b), (b, a)] {
                findings.within += u64::from(is_within(&bodies, samples, one, other));
                if let Some(before) = before {
                    findings.through += u64::from(went_through(&bodies, before, samples, one, other));
                }
            }
        }
        before = Some(samples);
    }
    Ok(findings)
}

fn checked(scene: &Scene, index: usize, form: &Form, meets: bool) -> Result<Checked, Box<dyn Error>> {
    let body = &scene.bodies()[index];
    let mesh = match form {
        Form::Mesh(mesh) => mesh,
        // They have no size that a depth could be held against.
        Form::Points(points) => {
            let parts = points.iter().copied().map(Part::of_point).collect();
            return Ok(Checked { mesh: None, parts, locator: None, marks: Vec::new(), size: f64::INFINITY });
        }
    };
    let solid = SolidMesh::new(mesh.clone()).ok();
    let is_convex = solid.as_ref().is_some_and(|solid| convexity(solid).is_convex());
    let parts = match &solid {
        _ if !meets => Vec::new(),
        _ if is_convex => vec![Part::of_mesh(mesh)],
        Some(solid) if !body.is_fixed() => {
            let parts = convex_decomposition(solid, DecompositionSettings::default())?;
            parts.parts.iter().map(|part| Part::of_mesh(part.mesh())).collect()
        }
        _ if body.is_fixed() => mesh.corner_positions().map(Part::of_triangle).collect(),
        _ => return Err("an open surface that moves".into()),
    };
    let locator = solid.as_ref().filter(|_| meets && !is_convex).map(PointLocator::new);
    let center = body.mass_properties().map(polhode::spatial::MassProperties::center_of_mass);
    let holds = |center: &DVec3| locator.as_ref().is_none_or(|locator| locator.contains(*center));
    let marks = match center {
        Some(center) if holds(&center) => vec![center],
        Some(_) => parts.iter().flat_map(Part::marks).collect(),
        None => Vec::new(),
    };
    Ok(Checked { locator, marks, size: mesh.bounds().diagonal(), mesh: Some(mesh.clone()), parts })
}

/// Places all pieces; those of bodies that have not moved stay as they are.
fn place(bodies: &[Checked], samples: &[BodySample], placed: &mut Vec<(Pose, Vec<Part>)>) {
    for (index, (body, sample)) in bodies.iter().zip(samples).enumerate() {
        let at = || (sample.pose, body.parts.iter().map(|part| part.placed(&sample.pose)).collect());
        match placed.get_mut(index) {
            None => placed.push(at()),
            Some(old) if old.0 != sample.pose => *old = at(),
            Some(_) => {}
        }
    }
}

/// How deep two bodies may be in each other, m.
fn tolerance(bodies: &[Checked], placed: &[(Pose, Vec<Part>)], a: usize, b: usize) -> f64 {
    let corners = [a, b].into_iter().flat_map(|body| &placed[body].1).flat_map(|part| [part.low, part.high]);
    let largest = corners.map(|corner| corner.abs().max_element()).fold(0.0, f64::max);
    SIZE_RELATIVE * bodies[a].size.min(bodies[b].size) + COORDINATE_ULPS * f64::EPSILON * largest
}

/// The largest depth of any two pieces, m.
fn depths(
    a: &[Part],
    b: &[Part],
    tolerance: f64,
    hints: &mut BTreeMap<(usize, usize), Option<DVec3>>,
    findings: &mut Findings,
) -> f64 {
    let mut deepest = f64::NEG_INFINITY;
    let whole = part::bounds(&a.iter().flat_map(|part| [part.low, part.high]).collect::<Vec<_>>());
    for (index_b, part_b) in b.iter().enumerate() {
        if part::box_overlap(whole, (part_b.low, part_b.high)) <= tolerance {
            continue;
        }
        for (index_a, part_a) in a.iter().enumerate() {
            if part_a.box_overlap(part_b) <= tolerance {
                continue;
            }
            findings.pairs += 1;
            let hint = hints.entry((index_a, index_b)).or_default();
            let found = depth::depth(part_a, part_b, tolerance, hint);
            findings.of_tolerance = findings.of_tolerance.max(found / tolerance);
            deepest = deepest.max(found);
        }
    }
    deepest
}

/// Where the marks of a body are in the frame of another, m.
fn seen_from<'a>(
    bodies: &'a [Checked],
    samples: &'a [BodySample],
    body: usize,
    frame: usize,
) -> impl Iterator<Item = DVec3> + 'a {
    let seen = samples[frame].pose.relative(&samples[body].pose);
    bodies[body].marks.iter().map(move |&mark| seen.transform_point(mark))
}

fn is_within(bodies: &[Checked], samples: &[BodySample], body: usize, solid: usize) -> bool {
    let Some(locator) = &bodies[solid].locator else { return false };
    seen_from(bodies, samples, body, solid).any(|mark| locator.contains(mark))
}

fn went_through(bodies: &[Checked], before: &[BodySample], after: &[BodySample], body: usize, surface: usize) -> bool {
    let marks = |samples| seen_from(bodies, samples, body, surface);
    let Some(mesh) = &bodies[surface].mesh else { return false };
    let bounds = mesh.bounds();
    marks(before).zip(marks(after)).any(|(from, to)| {
        let (low, high) = (from.min(to), from.max(to));
        part::box_overlap((low, high), (bounds.min, bounds.max)) >= 0.0
            && mesh.corner_positions().any(|[a, b, c]| {
                let apart = a.min(b).min(c).cmpgt(high).any() || a.max(b).max(c).cmplt(low).any();
                !apart && crosses([from, to], [a, b, c])
            })
    })
}

/// Whether a segment goes from one side of a triangle to the other through it or its rim. Signs are exact.
fn crosses([from, to]: [DVec3; 2], [a, b, c]: [DVec3; 3]) -> bool {
    let side = |p: DVec3, q: DVec3, r: DVec3, s: DVec3| {
        orient3d(coordinates(p), coordinates(q), coordinates(r), coordinates(s))
    };
    let (start, end) = (side(a, b, c, from), side(a, b, c, to));
    if start * end >= 0.0 {
        return false;
    }
    let turns = [side(from, to, a, b), side(from, to, b, c), side(from, to, c, a)];
    turns.iter().all(|&turn| turn >= 0.0) || turns.iter().all(|&turn| turn <= 0.0)
}

fn coordinates(point: DVec3) -> Coord3D<f64> {
    Coord3D { x: point.x, y: point.y, z: point.z }
}

#[cfg(test)]
mod tests {
    //! Ways through a triangle, its rim and past it; a link that leaves another.
    use super::*;
    use polhode::mesh::{Refinement, Torus};
    use polhode_spatial::{Rotation, Velocity};

    #[test]
    fn a_way_through_a_triangle_or_its_rim_is_found_and_one_beside_it_is_not() {
        let triangle = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let down = |x: f64, y: f64| [DVec3::new(x, y, 1.0), DVec3::new(x, y, -1.0)];
        assert!(crosses(down(0.25, 0.25), triangle));
        assert!(crosses(down(0.5, 0.5), triangle));
        assert!(!crosses(down(0.75, 0.75), triangle));
        assert!(!crosses([DVec3::new(0.25, 0.25, 2.0), DVec3::new(0.25, 0.25, 1.0)], triangle));
    }

    #[test]
    fn a_link_that_leaves_another_between_two_samples_is_found_and_one_that_turns_in_it_is_not() {
        let solid = Torus::new(0.3, 0.05).and_then(|ring| ring.mesh(Refinement::COARSEST)).expect("a ring");
        let parts = convex_decomposition(&solid, DecompositionSettings::default()).expect("parts");
        let link = || Checked {
            mesh: Some(solid.mesh().clone()),
            parts: Vec::new(),
            locator: None,
            marks: parts.parts.iter().flat_map(|part| Part::of_mesh(part.mesh()).marks()).collect(),
            size: 0.7,
        };
        let links = [link(), link()];
        let sample = |x: f64, turn: f64| {
            let across = Pose::new(Rotation::from_rotation_vector(DVec3::X * turn), DVec3::X * x);
            [Pose::IDENTITY, across].map(|pose| BodySample { pose, velocity: Velocity::ZERO })
        };
        let hanging = sample(0.45, 1.5);
        assert!(went_through(&links, &hanging, &sample(0.75, 1.5), 1, 0), "the link has left");
        assert!(!went_through(&links, &hanging, &sample(0.46, 1.6), 1, 0), "the link has turned");
    }
}

//! Whether bodies are in each other at the samples of a run: a check that shares no code with what moves them.
//!
//! It starts from triangle meshes (or corners without faces) and sampled poses, and knows of bodies nothing but these:
//! no hulls, parts or distances of the crates. Every vertex is placed by the pose (and rounded once); from there on:
//!
//! 1. *Depth.* The surfaces of two bodies must not meet, or not when the corners of one of them are moved by at most
//!    the tolerance (`depth`); whether triangles meet is decided by exact signs (`crossing`). This covers vertices
//!    in faces, edges through edges, faces through faces and coincident bodies, of solids of any form.
//! 2. *Within.* The marks of a body must not be inside another solid.
//! 3. *Through.* Between two samples the marks of a body, seen from the other one, must not cross its surface: a body
//!    that is beyond a surface without a thickness, or a link that has left another, is in nothing. The straight way
//!    between the two samples is tested against each triangle. It is the true way only as far as bodies turn little
//!    from sample to sample: scenes of fast ones are sampled more often.
//!
//! The mark of a body is its centre of mass. A body that does not hold its own, as a ring, has places halfway from some
//! of its triangles to where the straight way inwards leaves it.
//!
//! Tolerance: 1e-12 of the smaller of the two sizes and 4 epsilon of the largest coordinate, the bound that the
//! project's design judges penetration by. A depth of up to the tolerance passes.
//!
//! | module | holds |
//! |---|---|
//! | `depth` | by how much corners must be moved until two surfaces do not meet |
//! | `inward` | the ways on which the corners of a solid go inwards |
//! | `surface` | a body by its triangles, placed and moved; what is inside |
//! | `crossing` | what meets what, by exact signs |
//! | `box_tree` | which triangles are near each other |

mod box_tree;
mod crossing;
mod depth;
mod inward;
mod surface;

use box_tree::bounds;
use glam::DVec3;
use polhode::mesh::TriangleMesh;
use polhode::{BodyId, BodySample, Recorder, Scene};
use std::collections::BTreeMap;
use std::error::Error;
use surface::{Placed, Surface};

/// What of the smaller size a depth may be.
const SIZE_RELATIVE: f64 = 1e-12;
/// What of the largest coordinate a depth may be, in units of epsilon.
const COORDINATE_ULPS: f64 = 4.0;

/// What was found.
#[derive(Debug, Clone, Copy, Default)]
pub struct Findings {
    /// The largest depth beyond the tolerance, m: 0 when there is none.
    pub beyond_m: f64,
    /// Time of the first depth beyond the tolerance, s.
    pub since_s: Option<f64>,
    /// Marks found inside a solid.
    pub within: u64,
    /// Marks that went through a surface.
    pub through: u64,
}

/// The form of a body in its own frame.
#[derive(Debug)]
pub enum Form {
    /// A surface of triangles.
    Mesh(TriangleMesh),
    /// Corners without faces.
    Points(Vec<DVec3>),
}

/// Checks all samples of a run. `forms` are those of the bodies, in the order of the scene.
///
/// # Errors
/// When there is not one form for each body, or one that moves is an open surface.
pub fn check(scene: &Scene, record: &Recorder, forms: &[Form]) -> Result<Findings, Box<dyn Error>> {
    if forms.len() != scene.bodies().len() {
        return Err(format!("{} forms for {} bodies", forms.len(), scene.bodies().len()).into());
    }
    let pairs: Vec<(usize, usize)> = (0..forms.len())
        .flat_map(|a| (a + 1..forms.len()).map(move |b| (a, b)))
        .filter(|&(a, b)| scene.can_collide(BodyId::new(a), BodyId::new(b)))
        .collect();
    let mut bodies = Vec::new();
    for (index, form) in forms.iter().enumerate() {
        let meets = pairs.iter().any(|&(a, b)| a == index || b == index);
        bodies.push(surface_of(scene, index, form, meets).map_err(|error| format!("body {index}: {error}"))?);
    }
    let mut findings = Findings::default();
    let mut hints = BTreeMap::new();
    let mut before: Option<&Vec<BodySample>> = None;
    let mut placed: Vec<Placed<'_>> = Vec::new();
    for (&t, samples) in record.times_s.iter().zip(&record.samples) {
        place(&bodies, samples, &mut placed);
        for &(a, b) in &pairs {
            let tolerance = tolerance(&placed[a], &placed[b]);
            let found = depth::depth(&placed[a], &placed[b], tolerance, hints.entry((a, b)).or_default());
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

fn surface_of(scene: &Scene, index: usize, form: &Form, meets: bool) -> Result<Surface, Box<dyn Error>> {
    let surface = match form {
        Form::Mesh(mesh) => Surface::of_mesh(mesh),
        Form::Points(points) => return Ok(Surface::of_points(points)),
    };
    if meets && !surface.is_solid && !scene.bodies()[index].is_fixed() {
        return Err("an open surface that moves".into());
    }
    Ok(surface)
}

/// Places all bodies; those that have not moved stay as they are.
fn place<'a>(bodies: &'a [Surface], samples: &[BodySample], placed: &mut Vec<Placed<'a>>) {
    for (index, (body, sample)) in bodies.iter().zip(samples).enumerate() {
        match placed.get_mut(index) {
            None => placed.push(Placed::new(body, sample.pose)),
            Some(old) if old.pose != sample.pose => old.move_to(sample.pose),
            Some(_) => {}
        }
    }
}

/// How deep two bodies may be in each other, m. Points have no size that a depth could be held against.
fn tolerance(a: &Placed<'_>, b: &Placed<'_>) -> f64 {
    let corners = [a, b].into_iter().filter_map(|body| body.tree.bounds()).flat_map(|(low, high)| [low, high]);
    let largest = corners.map(|corner| corner.abs().max_element()).fold(0.0, f64::max);
    let sizes = [a, b].into_iter().filter(|body| !body.surface.triangles.is_empty()).map(|body| body.surface.size);
    SIZE_RELATIVE * sizes.reduce(f64::min).unwrap_or_default() + COORDINATE_ULPS * f64::EPSILON * largest
}

/// Where the marks of a body are in the frame of another, m.
fn seen_from<'a>(
    bodies: &'a [Surface],
    samples: &'a [BodySample],
    body: usize,
    frame: usize,
) -> impl Iterator<Item = DVec3> + 'a {
    let seen = samples[frame].pose.relative(&samples[body].pose);
    bodies[body].marks.iter().map(move |&mark| seen.transform_point(mark))
}

fn is_within(bodies: &[Surface], samples: &[BodySample], body: usize, solid: usize) -> bool {
    let holder = &bodies[solid];
    holder.is_solid && seen_from(bodies, samples, body, solid).any(|mark| holder.contains(mark) != Some(false))
}

fn went_through(bodies: &[Surface], before: &[BodySample], after: &[BodySample], body: usize, surface: usize) -> bool {
    let marks = |samples| seen_from(bodies, samples, body, surface);
    let passed = &bodies[surface];
    if passed.triangles.is_empty() {
        return false;
    }
    marks(before).zip(marks(after)).any(|(from, to)| {
        let near = passed.tree.near(bounds([from, to]), 0.0);
        near.into_iter().any(|index| crossing::goes_through([from, to], passed.triangle(index)))
    })
}

#[cfg(test)]
mod tests {
    //! A link that leaves another; a body within another.
    use super::*;
    use polhode::mesh::{Refinement, Torus, box_mesh};
    use polhode_spatial::{Pose, Rotation, Velocity};

    fn samples(poses: [Pose; 2]) -> [BodySample; 2] {
        poses.map(|pose| BodySample { pose, velocity: Velocity::ZERO })
    }

    #[test]
    fn a_link_that_leaves_another_between_two_samples_is_found_and_one_that_turns_in_it_is_not() {
        let solid = Torus::new(0.3, 0.05).and_then(|ring| ring.mesh(Refinement::COARSEST)).expect("a ring");
        let links = [Surface::of_mesh(solid.mesh()), Surface::of_mesh(solid.mesh())];
        let sample = |x: f64, turn: f64| {
            samples([Pose::IDENTITY, Pose::new(Rotation::from_rotation_vector(DVec3::X * turn), DVec3::X * x)])
        };
        let hanging = sample(0.45, 1.5);
        assert!(went_through(&links, &hanging, &sample(0.75, 1.5), 1, 0), "the link has left");
        assert!(!went_through(&links, &hanging, &sample(0.46, 1.6), 1, 0), "the link has turned");
    }

    #[test]
    fn a_body_within_another_is_found_by_its_mark() {
        let cube = |edge: f64| Surface::of_mesh(box_mesh(DVec3::splat(edge)).expect("a cube").mesh());
        let cubes = [cube(3.0), cube(1.0)];
        let at = |x: f64| samples([Pose::IDENTITY, Pose::from_translation(DVec3::X * x)]);
        assert!(is_within(&cubes, &at(0.9), 1, 0));
        assert!(!is_within(&cubes, &at(2.0), 1, 0));
    }
}

//! Links that overlap at the start, but for those that a joint connects.

use super::super::assemble::{Placement, assembled};
use super::super::finding::{Findings, RobotDefect};
use super::super::model::Robot;
use polhode::contact::{Shape, aabb_of, distance};
use polhode::{Body, Geometry};
use std::collections::BTreeSet;

/// Overlap that is told, relative to the size of the smaller body (no unit, 1e-9 to 1e-2): less is touch, or rounding
/// of a file.
const TOLD: f64 = 1e-6;

/// Examines all pairs.
pub(super) fn examine(robot: &Robot, placement: &Placement, findings: &mut Findings) {
    let Ok((assembly, _)) = assembled(robot, placement, 0) else { return };
    let pair = |a: usize, b: usize| (a.min(b), a.max(b));
    let joined: BTreeSet<(usize, usize)> =
        assembly.joints.iter().filter_map(|joint| Some(pair(joint.body().index(), joint.other()?.index()))).collect();
    for (b, body_b) in assembly.bodies.iter().enumerate() {
        for (a, body_a) in assembly.bodies[..b].iter().enumerate() {
            if (body_a.is_fixed() && body_b.is_fixed()) || joined.contains(&(a, b)) {
                continue;
            }
            let Some(depth) = overlap(body_a, body_b) else { continue };
            let name = |body: &Body| {
                let prefix = format!("{}/", placement.prefix);
                body.name().strip_prefix(&prefix).unwrap_or(body.name()).to_owned()
            };
            let (own, other) = (name(body_b), name(body_a));
            let place = robot.links.iter().find(|link| link.name == own).map_or(&robot.place, |link| &link.place);
            findings.add(place, format!("link `{own}`"), RobotDefect::Overlap { other, depth });
        }
    }
}

/// How deep two bodies overlap, m, if they do.
fn overlap(a: &Body, b: &Body) -> Option<f64> {
    let (Some(Geometry::Shape(shape_a)), Some(Geometry::Shape(shape_b))) = (a.shape(), b.shape()) else { return None };
    let (pose_a, pose_b) = (a.initial_pose(), b.initial_pose());
    if !aabb_of(shape_a, pose_a).ok()?.overlaps(&aabb_of(shape_b, pose_b).ok()?) {
        return None;
    }
    let size = |shape: &Shape| if matches!(shape, Shape::HalfSpace(_)) { f64::INFINITY } else { shape.size() };
    let depth = -distance(shape_a, pose_a, shape_b, pose_b).ok()?.distance;
    (depth > TOLD * size(shape_a).min(size(shape_b))).then_some(depth)
}

//! Tracks: beads, followers, friction and stops, one-sided tracks.

use crate::random_mechanism::build::{Build, across, text};
use crate::random_mechanism::model::{Coordinate, Curve, JointKind, Value};
use glam::DVec3;
use std::f64::consts::TAU;

impl Build {
    /// A track of the first few kinds; gives a point on it, and the tangent there.
    fn any_track(&mut self, kinds: usize) -> (DVec3, DVec3) {
        let random = &mut self.random;
        let axis = random.direction();
        let [u, v] = across(axis);
        let radius = random.between(0.5, 2.0);
        let (kind, keys, point, tangent) = match random.below(kinds) {
            0 => {
                let points = vec![-2.0 * u, 2.0 * u];
                ("line", vec![("points", Value::Points(points))], u * 0.1, u)
            }
            1 => {
                let angle = random.between(0.0, TAU);
                let out = u * libm::cos(angle) + v * libm::sin(angle);
                let keys = vec![
                    ("center", Value::Point(DVec3::ZERO)),
                    ("axis", Value::Direction(axis)),
                    ("radius", text(radius)),
                ];
                ("circle", keys, out * radius, axis.cross(out))
            }
            2 => {
                let advance = random.between(0.3, 1.0);
                let keys = vec![
                    ("start", Value::Point(u * radius)),
                    ("center", Value::Point(DVec3::ZERO)),
                    ("axis", Value::Direction(axis)),
                    ("advance", text(advance)),
                    ("turns", text(3.0)),
                ];
                // One turn along it, where it is over its start.
                let tangent = (axis.cross(u) * radius * TAU + axis * advance).normalize();
                ("helix", keys, u * radius + axis * advance, tangent)
            }
            _ => {
                // The cubic spline through points that lie evenly about its middle one has the chord of its neighbours
                // there.
                let side = random.vector(-0.3, 0.3);
                let (one, two) = (u * 0.8 + side, u * 1.6 + v * random.between(-0.3, 0.3));
                let points = vec![-two, -one, DVec3::ZERO, one, two];
                // By symmetry the slope at the middle is that of the clamped or natural spline; its direction is not
                // needed.
                (
                    "spline",
                    vec![("points", Value::Points(points)), ("closed", Value::Text("false".into()))],
                    DVec3::ZERO,
                    u,
                )
            }
        };
        self.scene.tracks.push(Curve { kind, keys });
        (point, tangent)
    }

    /// A body whose point is on a track.
    fn on_track(&mut self, point: DVec3, tangent: DVec3) -> usize {
        let end = point + self.random.direction() * self.random.between(0.1, 0.4);
        let body = self.bar(point, end);
        let joint = self.joint(JointKind::Track, &[body], point, &[tangent]);
        let number = self.scene.tracks.len() - 1;
        self.scene.joints[joint].keys.push(("track", Value::Text(format!("\"t{number}\""))));
        if self.scene.tracks[number].kind == "spline" {
            self.at_rest();
        }
        joint
    }
}

/// A point of a body slides along a track.
pub(in crate::random_mechanism) fn bead(build: &mut Build) {
    let (point, tangent) = build.any_track(4);
    let joint = build.on_track(point, tangent);
    if build.random.below(2) == 0 {
        build.spring(joint, Coordinate::Displacement);
    }
    if build.random.below(3) == 0 {
        let body = build.scene.joints[joint].bodies[0];
        let at = point + build.random.direction() * 0.3;
        let end = at + build.random.direction() * 0.3;
        let rider = build.bar(at, end);
        build.joint(JointKind::Ball, &[rider, body], at, &[]);
    }
    if build.scene.tracks[0].kind == "spline" {
        // Its tangent is not known here: it starts from rest.
        build.at_rest();
    }
}

/// A body that follows the tangent or the frame of a track, from rest.
pub(in crate::random_mechanism) fn follower(build: &mut Build) {
    // Not along a spline, whose curvature has corners.
    let (point, tangent) = build.any_track(3);
    let joint = build.on_track(point, tangent);
    let follows = build.random.one_of(&["\"tangent\"", "\"frame\""]);
    build.scene.joints[joint].keys.push(("follows", Value::Text(follows.to_owned())));
    if follows == "\"frame\"" {
        // Not along the tangent anywhere of the circle or the helix: their axis; elsewhere across the line.
        let axis = build.scene.tracks[0].keys.iter().find_map(|(key, value)| match (key, value) {
            (&"axis", Value::Direction(axis)) => Some(*axis),
            _ => None,
        });
        let up = axis.unwrap_or_else(|| across(tangent)[1]);
        build.scene.joints[joint].keys.push(("up", Value::Direction(up)));
    }
    build.at_rest();
}

/// A bead with dry friction, or stops that it reaches.
pub(in crate::random_mechanism) fn rough(build: &mut Build) {
    let (point, tangent) = build.any_track(4);
    let joint = build.on_track(point, tangent);
    match build.random.below(3) {
        0 => build.limit(joint, Coordinate::Displacement),
        1 => build.joint_friction(joint, Coordinate::Displacement, true),
        _ => build.joint_friction(joint, Coordinate::Displacement, false),
    }
}

/// A body on the outside of a circle, which leaves it, or on its inside, which may land on it again.
pub(in crate::random_mechanism) fn one_sided(build: &mut Build) {
    let axis = build.random.direction();
    let axis = (axis - DVec3::Z * axis.z).normalize_or(DVec3::X);
    let radius = build.random.between(0.5, 2.0);
    let angle = build.random.between(-1.2, 1.2);
    let out = DVec3::Z * libm::cos(angle) + DVec3::Z.cross(axis) * libm::sin(angle);
    let keys = vec![("center", Value::Point(DVec3::ZERO)), ("axis", Value::Direction(axis)), ("radius", text(radius))];
    build.scene.tracks.push(Curve { kind: "circle", keys });
    let joint = build.on_track(out * radius, axis.cross(out));
    build.scene.joints[joint].keys.push(("side", Value::Direction(out)));
    let body = build.scene.joints[joint].bodies[0];
    build.body(body).velocity = axis.cross(out) * build.random.between(0.2, 1.0) * (9.81 * radius).sqrt();
}

//! Closed loops: in a plane, on a sphere, in space; with rows that depend on each other and without.

use crate::random_mechanism::build::{Build, across};
use crate::random_mechanism::model::{Coordinate, JointKind};
use glam::{DQuat, DVec3};
use std::f64::consts::TAU;

impl Build {
    /// Points of a convex polygon in the plane across a random axis, and that axis.
    fn polygon(&mut self, count: usize) -> (Vec<DVec3>, DVec3) {
        let axis = self.random.direction();
        let [u, v] = across(axis);
        let radius = self.random.between(0.3, 0.8);
        let points = (0..count)
            .map(|k| {
                let angle = TAU * (k as f64 + self.random.between(-0.25, 0.25)) / count as f64;
                (u * libm::cos(angle) + v * libm::sin(angle)) * (radius * self.random.between(0.8, 1.2))
            })
            .collect();
        (points, axis)
    }

    /// A closed chain of bodies with joints at some points; the world is the link from the last point to the first
    /// unless it floats. Gives the joints. `axes` has an axis for each point, or none for a ball.
    fn closed(&mut self, points: &[DVec3], axes: &[Option<DVec3>], floats: bool) -> Vec<usize> {
        let count = points.len();
        let bars: Vec<usize> =
            (0..count - usize::from(!floats)).map(|k| self.bar(points[k], points[(k + 1) % count])).collect();
        (0..count)
            .map(|k| {
                let before = if k == 0 { floats.then(|| bars[count - 1]) } else { bars.get(k - 1).copied() };
                let pair: Vec<usize> = bars.get(k).copied().into_iter().chain(before).collect();
                match axes[k] {
                    Some(axis) => self.joint(JointKind::Hinge, &pair, points[k], &[axis]),
                    None => self.joint(JointKind::Ball, &pair, points[k], &[]),
                }
            })
            .collect()
    }

    fn planar_loop(&mut self) -> Vec<usize> {
        let count = 4 + self.random.below(4);
        let (mut points, axis) = self.polygon(count);
        let floats = self.random.below(3) == 0;
        if self.random.below(2) == 0 {
            // The bars are in different planes: an anchor may be anywhere on its axis.
            for point in &mut points {
                *point += axis * self.random.between(-0.2, 0.2);
            }
        }
        self.closed(&points, &vec![Some(axis); count], floats)
    }
}

/// A loop of 4 to 7 bars in a plane.
pub(in crate::random_mechanism) fn planar(build: &mut Build) {
    let joints = build.planar_loop();
    some_springs(build, &joints);
}

fn some_springs(build: &mut Build, joints: &[usize]) {
    for &joint in joints {
        for &coordinate in build.coordinates(joint) {
            if build.random.below(4) == 0 {
                build.spring(joint, coordinate);
            }
        }
    }
}

/// Two to four parallel cranks of one length that bear a coupler: more joints than needed.
pub(in crate::random_mechanism) fn parallel(build: &mut Build) {
    let axis = build.random.direction();
    let [u, v] = across(axis);
    let angle = build.random.between(0.3, TAU);
    let crank = (u * libm::cos(angle) + v * libm::sin(angle)) * build.random.between(0.2, 0.6);
    let count = 2 + build.random.below(3);
    let feet: Vec<DVec3> = (0..count).map(|k| u * (0.4 * k as f64) + v * build.random.between(-0.1, 0.1)).collect();
    let coupler = build.bar(feet[0] + crank, feet[count - 1] + crank);
    for foot in feet {
        let bar = build.bar(foot, foot + crank);
        build.joint(JointKind::Hinge, &[bar], foot, &[axis]);
        build.joint(JointKind::Hinge, &[coupler, bar], foot + crank, &[axis]);
    }
}

/// A loop of four or five hinges whose axes meet in a point.
pub(in crate::random_mechanism) fn spherical(build: &mut Build) {
    let middle = build.random.direction();
    let [u, v] = across(middle);
    let count = 4 + build.random.below(2);
    let axes: Vec<DVec3> = (0..count)
        .map(|k| {
            let angle = TAU * (k as f64 + build.random.between(-0.2, 0.2)) / count as f64;
            let tilt = build.random.between(0.5, 1.1);
            (middle * libm::cos(tilt) + (u * libm::cos(angle) + v * libm::sin(angle)) * libm::sin(tilt)).normalize()
        })
        .collect();
    let points: Vec<DVec3> = axes.iter().map(|&axis| axis * build.random.between(0.3, 0.7)).collect();
    let axes: Vec<Option<DVec3>> = axes.into_iter().map(Some).collect();
    let joints = build.closed(&points, &axes, false);
    some_springs(build, &joints);
}

/// Six hinges, three of which are those of the other three after half a turn about a line (Bricard 1897): it moves
/// although it has as many rows as freedoms.
pub(in crate::random_mechanism) fn line_symmetric(build: &mut Build) {
    let half_turn = DQuat::from_axis_angle(build.random.direction(), std::f64::consts::PI);
    let mut points: Vec<DVec3> = Vec::new();
    let mut axes: Vec<DVec3> = Vec::new();
    let line = half_turn.xyz().normalize();
    let [u, v] = across(line);
    for k in 0..3 {
        let angle = TAU * (f64::from(k) + build.random.between(-0.2, 0.2)) / 6.0;
        let radius = build.random.between(0.3, 0.7);
        points.push((u * libm::cos(angle) + v * libm::sin(angle)) * radius + line * build.random.between(-0.4, 0.4));
        axes.push(build.random.direction());
    }
    let images: Vec<(DVec3, DVec3)> = points.iter().zip(&axes).map(|(&p, &a)| (half_turn * p, half_turn * a)).collect();
    for (point, axis) in images {
        points.push(point);
        axes.push(axis);
    }
    let axes: Vec<Option<DVec3>> = axes.into_iter().map(Some).collect();
    build.closed(&points, &axes, false);
}

/// A crank, a rod and a slider.
pub(in crate::random_mechanism) fn slider_crank(build: &mut Build) {
    let axis = build.random.direction();
    let [u, v] = across(axis);
    let angle = build.random.between(0.5, 2.6);
    let end = (u * libm::cos(angle) + v * libm::sin(angle)) * build.random.between(0.15, 0.3);
    let pin = u * build.random.between(0.6, 0.9) + v * build.random.between(-0.1, 0.1);
    let (crank, rod) = (build.bar(DVec3::ZERO, end), build.bar(end, pin));
    let piston = build.bar(pin, pin + u * 0.3);
    build.joint(JointKind::Hinge, &[crank], DVec3::ZERO, &[axis]);
    build.joint(JointKind::Hinge, &[rod, crank], end, &[axis]);
    let last = build.random.one_of(&[JointKind::Hinge, JointKind::Ball, JointKind::Cylindrical]);
    build.joint(last, &[piston, rod], pin, &[axis]);
    let guide = build.random.one_of(&[JointKind::Slider, JointKind::Slider, JointKind::Cylindrical]);
    let slider = build.joint(guide, &[piston], pin, &[u]);
    some_springs(build, &[slider]);
}

/// Two cranks on skew axes and a coupler between balls.
pub(in crate::random_mechanism) fn ball_coupler(build: &mut Build) {
    let feet = [DVec3::ZERO, build.random.direction() * build.random.between(0.6, 1.0)];
    let mut ends = Vec::new();
    for foot in feet {
        let axis = build.random.direction();
        let arm = across(axis)[0] * build.random.between(0.2, 0.5);
        let bar = build.bar(foot, foot + arm);
        build.joint(JointKind::Hinge, &[bar], foot, &[axis]);
        ends.push((bar, foot + arm));
    }
    let coupler = build.bar(ends[0].1, ends[1].1);
    let last = build.random.one_of(&[JointKind::Ball, JointKind::Universal]);
    build.joint(JointKind::Ball, &[coupler, ends[0].0], ends[0].1, &[]);
    let axis = build.random.direction();
    let axes = if last == JointKind::Ball { vec![] } else { vec![axis, across(axis)[1]] };
    build.joint(last, &[coupler, ends[1].0], ends[1].1, &axes);
}

/// A loop of seven hinges at random places, with random axes: one freedom.
pub(in crate::random_mechanism) fn seven_hinges(build: &mut Build) {
    let (points, _) = build.polygon(7);
    let points: Vec<DVec3> = points.into_iter().map(|p| p + build.random.direction() * 0.15).collect();
    let axes: Vec<Option<DVec3>> = (0..7).map(|_| Some(build.random.direction())).collect();
    build.closed(&points, &axes, false);
}

/// A body that hangs from two to five rods, and perhaps another one.
pub(in crate::random_mechanism) fn rods(build: &mut Build) {
    let (low, high) = (DVec3::new(-0.4, 0.0, 0.0), DVec3::new(0.4, 0.1, 0.0));
    let body = build.bar(low, high);
    for _ in 0..2 + build.random.below(4) {
        let at = low.lerp(high, build.random.unit()) + build.random.vector(-0.2, 0.2);
        let from = at + build.random.vector(-0.5, 0.5) + DVec3::Z * 0.6;
        build.line(JointKind::Rod, &[body], [at, from], 0.0);
    }
    if build.random.below(2) == 0 {
        let at = high - DVec3::Z * 0.5;
        let second = build.bar(at, at - DVec3::Z * 0.4);
        build.line(JointKind::Rod, &[second, body], [at, high], 0.0);
    }
}

/// A loop in a plane with dry friction in some of its hinges.
pub(in crate::random_mechanism) fn with_friction(build: &mut Build) {
    let joints = build.planar_loop();
    for joint in joints {
        if build.random.below(2) == 0 {
            build.joint_friction(joint, Coordinate::Angle, false);
        }
    }
}

/// A loop in a plane with a limit of a hinge.
pub(in crate::random_mechanism) fn with_limit(build: &mut Build) {
    let joints = build.planar_loop();
    let joint = joints[build.random.below(joints.len())];
    build.limit(joint, Coordinate::Angle);
}

//! Joints one after the other with nothing of mass between them are one joint: two hinges whose axes cross at right
//! angles are a universal joint, three a ball joint, and so on. Files describe such joints by parts without mass, or by
//! several joints of one body; a part without mass has no equation of motion.

use super::finding::{Findings, RobotDefect};
use super::model::{Robot, RobotCoordinate, RobotJoint, RobotJointKind};
use glam::{DMat3, DVec3};
use polhode::spatial::{Pose, UnitVector};

/// Axes of length one that are to be parallel or at right angles: their cosines from 1 and 0 (no unit, 1e-12 to 1e-6:
/// the digits of a file, and the limit of the engine for axes at right angles).
const ALONG: f64 = 1e-9;

/// Distance of axes that are to cross, relative to the largest coordinate or 1 m, whichever is more (no unit, 1e-12 to
/// 1e-6: the digits of a file).
const CROSSING: f64 = 1e-9;

/// Least volume that three axes of length one must span to be independent (no unit, 1e-3 to 0.1): at less they lose a
/// freedom.
const INDEPENDENT: f64 = 1e-2;

/// A joint between two bodies, in the frame of the model at the start.
#[derive(Debug, Clone)]
pub(super) struct Combined {
    /// What it leaves free; axes in the frame of the model.
    pub(super) kind: RobotJointKind,
    /// The point that stays, m.
    pub(super) anchor: DVec3,
    /// Numbers of the joints whose coordinates are those of the joint, in their order.
    pub(super) coordinates: Vec<usize>,
}

/// One of the joints, in the frame of the model.
#[derive(Clone, Copy)]
struct Placed {
    number: usize,
    axis: DVec3,
    anchor: DVec3,
}

/// What joints one after the other are, from the parent to the child; `poses` are those of the links.
///
/// What has no coordinate for its limits, springs or dampers is noted. `None` when they are no joint, which is noted.
pub(super) fn combined(robot: &Robot, chain: &[usize], poses: &[Pose], findings: &mut Findings) -> Option<Combined> {
    let joints: Vec<&RobotJoint> = chain.iter().filter_map(|&number| robot.joints.get(number)).collect();
    let last = *joints.last()?;
    let made = match (&joints[..], chain) {
        ([only], [number]) => Ok(alone(only, *number, poses)),
        _ => together(&joints, chain, poses),
    };
    match made {
        Ok(made) => {
            note_unlimited(&joints, chain, &made, findings);
            Some(made)
        }
        Err(why) => {
            let subject = format!("link `{}`", robot.links[last.child].name);
            findings.add(&last.place, subject, RobotDefect::Joints { count: joints.len(), why });
            None
        }
    }
}

/// The kind of a joint in the frame of the model.
fn alone(joint: &RobotJoint, number: usize, poses: &[Pose]) -> Combined {
    let pose = &poses[joint.child];
    let turned = |axis: UnitVector| UnitVector::new(pose.rotation.rotate(axis.get())).unwrap_or(axis);
    let kind = match joint.kind {
        RobotJointKind::Hinge { axis } => RobotJointKind::Hinge { axis: turned(axis) },
        RobotJointKind::Slider { axis } => RobotJointKind::Slider { axis: turned(axis) },
        RobotJointKind::Planar { normal } => RobotJointKind::Planar { normal: turned(normal) },
        other => other,
    };
    Combined { kind, anchor: pose.transform_point(joint.anchor), coordinates: vec![number] }
}

/// Several joints as one.
fn together(joints: &[&RobotJoint], chain: &[usize], poses: &[Pose]) -> Result<Combined, &'static str> {
    if joints.iter().any(|joint| matches!(joint.kind, RobotJointKind::Free)) {
        return Err("a free joint among others");
    }
    let (mut hinges, mut sliders, mut balls) = (Vec::new(), Vec::new(), Vec::new());
    for (joint, &number) in joints.iter().zip(chain) {
        let pose = &poses[joint.child];
        let anchor = pose.transform_point(joint.anchor);
        let placed = |axis: UnitVector| Placed { number, axis: pose.rotation.rotate(axis.get()), anchor };
        match joint.kind {
            RobotJointKind::Hinge { axis } => hinges.push(placed(axis)),
            RobotJointKind::Slider { axis } => sliders.push(placed(axis)),
            RobotJointKind::Ball => balls.push(placed(UnitVector::Z)),
            _ => return Err("only hinges, sliders and ball joints make one joint together"),
        }
    }
    match (&hinges[..], &sliders[..], &balls[..]) {
        ([first, second], [], []) => universal(first, second),
        ([a, b, c], [], []) => ball([a, b, c]),
        ([hinge], [slider], []) => cylindrical(hinge, slider),
        ([hinge], [a, b], []) => planar(hinge, [a, b]),
        ([a, b, c], [x, y, z], []) if ball([a, b, c]).is_ok() => free([x, y, z]),
        ([], [x, y, z], [_]) => free([x, y, z]),
        _ => Err("no kind of joint leaves these motions free"),
    }
}

/// Two hinges whose axes cross at right angles.
fn universal(first: &Placed, second: &Placed) -> Result<Combined, &'static str> {
    if first.axis.dot(second.axis).abs() > ALONG {
        return Err("the axes of two hinges are not at right angles");
    }
    let anchor = crossing(first, second).ok_or("the axes of two hinges do not cross")?;
    let axis = |placed: &Placed| UnitVector::new(placed.axis).map_err(|_| "an axis is not finite");
    // That of the child first: it is fixed in the child, the other one in the parent.
    let axes = [axis(second)?, axis(first)?];
    Ok(Combined { kind: RobotJointKind::Universal { axes }, anchor, coordinates: Vec::new() })
}

/// Three hinges whose axes meet in a point.
fn ball([a, b, c]: [&Placed; 3]) -> Result<Combined, &'static str> {
    let volume = DMat3::from_cols(a.axis, b.axis, c.axis).determinant().abs();
    if volume < INDEPENDENT || volume.is_nan() {
        return Err("the axes of three hinges lie in one plane");
    }
    // A pair that is not parallel has the point.
    let anchor = crossing(a, b).ok_or("the axes of three hinges do not meet")?;
    if off_axis(c, anchor) > allowed(anchor) {
        return Err("the axes of three hinges do not meet");
    }
    Ok(Combined { kind: RobotJointKind::Ball, anchor, coordinates: Vec::new() })
}

/// A hinge and a slider along its axis.
fn cylindrical(hinge: &Placed, slider: &Placed) -> Result<Combined, &'static str> {
    // The angle between them by its sine, which is exact for small ones.
    if hinge.axis.cross(slider.axis).length() > ALONG || hinge.axis.dot(slider.axis) < 0.0 {
        return Err("a hinge and a slider do not have one axis");
    }
    let axis = UnitVector::new(hinge.axis).map_err(|_| "an axis is not finite")?;
    let coordinates = vec![hinge.number, slider.number];
    Ok(Combined { kind: RobotJointKind::Cylindrical { axis }, anchor: hinge.anchor, coordinates })
}

/// A hinge and two sliders in the plane across its axis.
fn planar(hinge: &Placed, sliders: [&Placed; 2]) -> Result<Combined, &'static str> {
    if sliders.iter().any(|slider| slider.axis.dot(hinge.axis).abs() > ALONG) {
        return Err("two sliders are not at right angles to the axis of the hinge");
    }
    if sliders[0].axis.cross(sliders[1].axis).length() < INDEPENDENT {
        return Err("two sliders have one axis");
    }
    let normal = UnitVector::new(hinge.axis).map_err(|_| "an axis is not finite")?;
    Ok(Combined { kind: RobotJointKind::Planar { normal }, anchor: hinge.anchor, coordinates: Vec::new() })
}

/// Three sliders, and all rotations.
fn free([x, y, z]: [&Placed; 3]) -> Result<Combined, &'static str> {
    let volume = DMat3::from_cols(x.axis, y.axis, z.axis).determinant().abs();
    if volume < INDEPENDENT || volume.is_nan() {
        return Err("the axes of three sliders lie in one plane");
    }
    Ok(Combined { kind: RobotJointKind::Free, anchor: DVec3::ZERO, coordinates: Vec::new() })
}

/// How far from an axis a point may be to lie on it, m.
fn allowed(point: DVec3) -> f64 {
    CROSSING * point.abs().max_element().max(1.0)
}

/// Distance of a point from an axis, m.
fn off_axis(axis: &Placed, point: DVec3) -> f64 {
    (point - axis.anchor).cross(axis.axis).length()
}

/// The point in which two axes cross, if they do.
fn crossing(a: &Placed, b: &Placed) -> Option<DVec3> {
    if off_axis(b, a.anchor) <= allowed(a.anchor) {
        return Some(a.anchor);
    }
    let across = a.axis.cross(b.axis);
    let square = across.length_squared();
    // The point of `a` nearest to `b`.
    let along = (b.anchor - a.anchor).cross(b.axis).dot(across) / square;
    let point = a.anchor + a.axis * along;
    (point.is_finite() && off_axis(b, point) <= allowed(point)).then_some(point)
}

/// Notes the coordinates on which something acts that the joint does not keep.
fn note_unlimited(joints: &[&RobotJoint], chain: &[usize], made: &Combined, findings: &mut Findings) {
    for (joint, number) in joints.iter().zip(chain) {
        let has_coordinate = matches!(
            made.kind,
            RobotJointKind::Hinge { .. } | RobotJointKind::Slider { .. } | RobotJointKind::Cylindrical { .. }
        );
        if has_coordinate && made.coordinates.contains(number) {
            continue;
        }
        for own in joint.coordinates.iter().filter(|own| acts(own)) {
            findings.add(&own.place, format!("joint `{}`", own.name), RobotDefect::Unlimited(made.kind.name()));
        }
    }
}

/// Whether something acts along a coordinate.
fn acts(coordinate: &RobotCoordinate) -> bool {
    let constants = [coordinate.damping, coordinate.stiffness, coordinate.friction];
    coordinate.limits.is_some() || constants.iter().any(|&constant| constant != 0.0)
}

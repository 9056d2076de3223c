//! One judge for all engines: from poses, velocities, and the impulses that an engine says that it used.
//!
//! **Residual.** For a contact with unit normal `n` (on A), impulse `p` on A, friction `mu`, relative velocity `u` of
//! the bodies at the contact point after the step, and the inverse mass `w` that the pair has there along `n`,
//! Coulomb's law with Signorini's condition is a cone complementarity (De Saxce): it holds where
//! `p = P_K(p - (u + mu |u_t| n) / w)`, with `P_K` the projection onto the cone `|p_t| <= mu p_n`. The residual of a
//! step is the largest distance of both sides over its contacts, in units of the largest impulse. As the normal part of
//! `u` either the rate after the step or the gap after it over the step counts, whichever the engine has kept better:
//! some keep contacts at the level of velocities, some at that of positions. So an engine that pushes bodies apart
//! slowly is not blamed for it here; its penetration is in a column of its own.
//!
//! **Penetration.** The deepest overlap of two bodies, or of a body and a half-space, at their poses.

use super::scenes::{Form, Scene};
use polhode::contact::{Manifold, Shape, Workspace, manifold_into};
use polhode::spatial::{DMat3, DVec3, Pose};
use std::collections::BTreeMap;

/// Impulses below this fraction of the largest are not judged by themselves (no unit): an engine may leave them.
const NO_IMPULSE: f64 = 1e-12;

/// A movable body after a step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Moved {
    pub(crate) pose: Pose,
    pub(crate) linear: DVec3,
    pub(crate) angular: DVec3,
}

/// A contact with the impulse of an engine.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Judged {
    /// Movable bodies A and B; none for a half-space.
    pub(crate) bodies: [Option<usize>; 2],
    pub(crate) point: DVec3,
    /// Unit vector from B to A.
    pub(crate) normal: DVec3,
    /// On A, N s.
    pub(crate) impulse: DVec3,
    /// After the step, m; negative where the bodies overlap.
    pub(crate) gap: f64,
}

/// Contacts of a step, judged.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Verdict {
    pub(crate) residual: f64,
    pub(crate) contacts: usize,
    /// The upward impulse from half-spaces over that of all weights in the step (1 where everything rests).
    pub(crate) carried: f64,
}

/// The residual of one step of `h` (s), in which the impulses acted.
pub(crate) fn judge(scene: &Scene, bodies: &[Moved], contacts: &[Judged], h: f64) -> Verdict {
    let largest = contacts.iter().fold(0.0, |most: f64, contact| most.max(contact.impulse.length()));
    if largest == 0.0 {
        return Verdict::default();
    }
    let of = |contact: &Judged| residual_of(scene, bodies, contact, h, NO_IMPULSE * largest) / largest;
    let on_planes = contacts.iter().map(|contact| match contact.bodies {
        [Some(_), None] => contact.impulse.z,
        [None, Some(_)] => -contact.impulse.z,
        _ => 0.0,
    });
    let weight: f64 = scene.members.iter().map(|member| member.mass).sum::<f64>() * 9.81 * h;
    Verdict {
        residual: contacts.iter().map(of).fold(0.0, f64::max),
        contacts: contacts.len(),
        carried: on_planes.sum::<f64>() / weight,
    }
}

/// The distance of both sides, N s.
fn residual_of(scene: &Scene, bodies: &[Moved], contact: &Judged, h: f64, nothing: f64) -> f64 {
    let n = contact.normal;
    let mut inverse_mass = 0.0;
    let velocity = |body: Option<usize>| {
        body.map_or(DVec3::ZERO, |body| {
            let moved = &bodies[body];
            moved.linear + moved.angular.cross(contact.point - moved.pose.translation)
        })
    };
    for body in contact.bodies.into_iter().flatten() {
        let (member, pose) = (&scene.members[body], &bodies[body].pose);
        let turn = DMat3::from_quat(pose.rotation.quaternion());
        let arm = turn.transpose() * (contact.point - pose.translation).cross(n);
        inverse_mass += 1.0 / member.mass + (arm * arm / member.form.moments(member.mass)).element_sum();
    }
    let u = velocity(contact.bodies[0]) - velocity(contact.bodies[1]);
    let slip = u - n * n.dot(u);
    let (pressing, along) = (n.dot(contact.impulse), contact.impulse - n * n.dot(contact.impulse));
    let distance = |rate: f64| {
        if pressing.abs() <= nothing && rate >= 0.0 {
            return 0.0;
        }
        let wanted = pressing - (rate + scene.friction * slip.length()) / inverse_mass;
        let (normal, tangential) = into_cone(wanted, along - slip / inverse_mass, scene.friction);
        (pressing - normal).hypot((along - tangential).length())
    };
    // A contact without impulse may approach as long as its gap lasts.
    let gap_rate = contact.gap / h;
    distance(n.dot(u)).min(distance(gap_rate))
}

/// The nearest point of the cone.
fn into_cone(normal: f64, tangential: DVec3, friction: f64) -> (f64, DVec3) {
    let length = tangential.length();
    if length <= friction * normal {
        return (normal, tangential);
    }
    if friction * length <= -normal {
        return (0.0, DVec3::ZERO);
    }
    let on_edge = (normal + friction * length) / (1.0 + friction * friction);
    (on_edge, tangential * (friction * on_edge / length))
}

/// Measures penetration; it keeps its buffers.
pub(crate) struct Depths {
    shapes: Vec<Option<Shape>>,
    cell: f64,
    workspace: Workspace,
    manifold: Manifold,
}

impl Depths {
    pub(crate) fn new(scene: &Scene) -> Self {
        let shape = |form: Form| match form {
            Form::Box(edges) => Shape::cuboid(edges).ok(),
            Form::Sphere(radius) => Shape::sphere(radius).ok(),
        };
        let reach = scene.members.iter().map(|member| member.form.reach()).fold(0.0, f64::max);
        Self {
            shapes: scene.members.iter().map(|member| shape(member.form)).collect(),
            cell: 2.0 * reach,
            workspace: Workspace::default(),
            manifold: Manifold::default(),
        }
    }

    /// The deepest overlap, m.
    pub(crate) fn deepest(&mut self, scene: &Scene, bodies: &[Moved]) -> f64 {
        let mut deepest = 0.0_f64;
        for (member, moved) in scene.members.iter().zip(bodies) {
            for plane in &scene.planes {
                deepest = deepest.max(depth_in_plane(member.form, &moved.pose, plane.point, plane.normal));
            }
        }
        let mut cells: BTreeMap<[i64; 3], Vec<usize>> = BTreeMap::new();
        let cell = |moved: &Moved| (moved.pose.translation / self.cell).floor().to_array().map(|x| x as i64);
        for (body, moved) in bodies.iter().enumerate() {
            cells.entry(cell(moved)).or_default().push(body);
        }
        let mut pairs = Vec::new();
        for (body, moved) in bodies.iter().enumerate() {
            let [x, y, z] = cell(moved);
            for (i, j, k) in (-1..=1).flat_map(|i| (-1..=1).flat_map(move |j| (-1..=1).map(move |k| (i, j, k)))) {
                let others = cells.get(&[x + i, y + j, z + k]).into_iter().flatten();
                pairs.extend(others.filter(|&&other| other > body).map(|&other| (body, other)));
            }
        }
        for (a, b) in pairs {
            let (Some(shape_a), Some(shape_b)) = (&self.shapes[a], &self.shapes[b]) else { continue };
            let [pose_a, pose_b] = [&bodies[a].pose, &bodies[b].pose];
            manifold_into(&mut self.workspace, shape_a, pose_a, shape_b, pose_b, 0.0, &mut self.manifold);
            deepest = deepest.max(-self.manifold.separation);
        }
        deepest
    }
}

fn depth_in_plane(form: Form, pose: &Pose, point: DVec3, normal: DVec3) -> f64 {
    let height = normal.dot(pose.translation - point);
    match form {
        Form::Sphere(radius) => radius - height,
        Form::Box(edges) => {
            let inside = DMat3::from_quat(pose.rotation.quaternion()).transpose() * normal;
            0.5 * (inside.abs() * edges).element_sum() - height
        }
    }
}

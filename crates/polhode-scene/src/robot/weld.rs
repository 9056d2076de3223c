//! Links that fixed joints connect are one body: its mass properties are the sum of theirs.
//!
//! About the common centre of mass, `I = I_a + I_b + (m_a m_b / (m_a + m_b)) (|r|^2 1 - r r^T)`, with r from one centre
//! of mass to the other. A part may be a point or a rod, whose inertia no body by itself has; the sum must be an
//! inertia.

use super::finding::{Findings, RobotDefect};
use super::model::{Inertial, Link, Robot, RobotJointKind};
use glam::{DMat3, DVec3};
use polhode::spatial::inertia::point_inertia;
use polhode::spatial::rounding;
use polhode::spatial::{Inertia, InertiaError, Mass, MassProperties, Pose, PrincipalAxes};
use std::borrow::Cow;

/// What becomes of an inertia that no body can have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unphysical {
    /// The robot is refused.
    Refuse,
    /// It is replaced by the nearest one that a body can have, which is told.
    Repair,
}

/// Links that move as one.
#[derive(Debug, Clone)]
pub(super) struct Group {
    /// Their numbers; the first is the one nearest to the root, whose frame is that of the body.
    pub(super) links: Vec<usize>,
    /// What their masses add up to, in the frame of the first; none when they have no mass.
    pub(super) matter: Option<Matter>,
}

impl Group {
    /// The link whose frame is that of the body.
    pub(super) fn top(&self) -> usize {
        self.links.first().copied().unwrap_or(0)
    }
}

/// Mass, centre of mass and inertia about it, which may be that of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Matter {
    /// Mass, kg.
    pub(super) mass: f64,
    /// Centre of mass, m.
    pub(super) center: DVec3,
    /// Inertia about it, kg m^2.
    pub(super) inertia: DMat3,
}

impl Matter {
    fn of(own: &Inertial, pose: &Pose) -> Self {
        let frame = *pose * own.frame;
        let rotation = frame.rotation.to_matrix();
        let inertia = if own.frame.rotation == polhode::spatial::Rotation::IDENTITY && *pose == Pose::IDENTITY {
            own.inertia
        } else {
            let turned = rotation * own.inertia * rotation.transpose();
            (turned + turned.transpose()) * 0.5
        };
        Self { mass: own.mass, center: frame.translation, inertia }
    }

    /// That of mass properties.
    pub(super) fn of_properties(own: &MassProperties) -> Self {
        Self { mass: own.mass(), center: own.center_of_mass(), inertia: own.inertia().matrix() }
    }

    /// The sum of two in one frame.
    pub(super) fn plus(self, other: Self) -> Self {
        let mass = self.mass + other.mass;
        let arm = other.center - self.center;
        let reduced = self.mass * (other.mass / mass);
        Self {
            mass,
            center: self.center + arm * (other.mass / mass),
            inertia: self.inertia + other.inertia + point_inertia(reduced, arm),
        }
    }

    /// As mass properties of a body.
    ///
    /// # Errors
    /// When it has no inertia about some axis, or the sum of masses overflows.
    pub(super) fn properties(&self) -> Result<MassProperties, RobotDefect> {
        let mass = Mass::new(self.mass)?;
        let inertia = Inertia::new(self.inertia).map_err(RobotDefect::NoInertia)?;
        Ok(MassProperties::new(mass, self.center, inertia))
    }
}

/// The groups of a robot in the order of its links, and the number of the group of each link; `poses` are those of its
/// links.
pub(super) fn groups(
    robot: &Robot,
    poses: &[Pose],
    unphysical: Unphysical,
    findings: &mut Findings,
) -> (Vec<Group>, Vec<usize>) {
    let mut groups: Vec<Group> = Vec::new();
    let mut group_of = vec![0; robot.links.len()];
    let mut joints = robot.joints.iter().peekable();
    for (number, link) in robot.links.iter().enumerate() {
        // Joints are sorted by their child; the root has none.
        let joint = joints.next_if(|joint| joint.child == number);
        let held = joint.filter(|joint| matches!(joint.kind, RobotJointKind::Fixed));
        let group = held.map_or(groups.len(), |joint| group_of[joint.parent]);
        group_of[number] = group;
        if held.is_none() {
            groups.push(Group { links: Vec::new(), matter: None });
        }
        let Some(own) = groups.get_mut(group) else { continue };
        own.links.push(number);
        let Some(inertial) = checked(link, unphysical, findings) else { continue };
        let top = own.top();
        let pose = if top == number { Pose::IDENTITY } else { poses[top].relative(&poses[number]) };
        let part = Matter::of(&inertial, &pose);
        own.matter = Some(own.matter.map_or(part, |sum| sum.plus(part)));
    }
    (groups, group_of)
}

/// Notes the mass properties of links that no body can have.
pub(super) fn examine(links: &[Link], findings: &mut Findings) {
    for link in links {
        checked(link, Unphysical::Refuse, findings);
    }
}

/// The mass properties of a link, if it has any and a body can have them; what is refused is noted.
fn checked<'a>(link: &'a Link, unphysical: Unphysical, findings: &mut Findings) -> Option<Cow<'a, Inertial>> {
    let own = link.inertial.as_ref()?;
    let subject = || format!("link `{}`", link.name);
    if !(own.mass >= 0.0 && own.mass.is_finite()) {
        findings.add(&own.place, subject(), RobotDefect::Mass(own.mass));
        return None;
    }
    if own.mass == 0.0 {
        if own.inertia != DMat3::ZERO {
            let repaired =
                RobotDefect::InertiaRepaired { found: PrincipalAxes::of(&own.inertia).moments(), made: DVec3::ZERO };
            let is_refused = unphysical == Unphysical::Refuse;
            let defect = if is_refused { RobotDefect::InertiaWithoutMass } else { repaired };
            findings.add(&own.place, subject(), defect);
        }
        return None;
    }
    let Err(error) = Inertia::new(own.inertia) else { return Some(Cow::Borrowed(own)) };
    let moments = PrincipalAxes::of(&own.inertia).moments();
    if is_of_rod_or_point(moments, error) {
        return Some(Cow::Borrowed(own));
    }
    // A matrix that is singular and breaks the triangle inequality is told for the latter, which is worse.
    let breaks = moments.z - moments.x - moments.y > rounding::DIGITS_OF_A_FILE * moments.z;
    let error = match error {
        InertiaError::NotPositive(_) if breaks && moments.x >= 0.0 => InertiaError::TriangleInequality(moments),
        other => other,
    };
    let is_symmetric = !matches!(error, InertiaError::NotFinite | InertiaError::NotSymmetric { .. });
    if unphysical == Unphysical::Refuse || !is_symmetric {
        findings.add(&own.place, subject(), RobotDefect::Inertia(error));
        return None;
    }
    let inertia = nearest(&own.inertia);
    let made = PrincipalAxes::of(&inertia).moments();
    findings.add(&own.place, subject(), RobotDefect::InertiaRepaired { found: moments, made });
    Some(Cow::Owned(Inertial { inertia, ..own.clone() }))
}

/// The inertia of a body that is nearest to a matrix: that whose second moments of mass, `S = tr(I)/2 1 - I`, are those
/// of the matrix without their negative part.
fn nearest(matrix: &DMat3) -> DMat3 {
    let axes = PrincipalAxes::of(matrix);
    let (moments, rotation) = (axes.moments(), axes.rotation().to_matrix());
    let second = (DVec3::splat(0.5 * moments.element_sum()) - moments).max(DVec3::ZERO);
    let made = DVec3::splat(second.element_sum()) - second;
    let turned = rotation * DMat3::from_diagonal(made) * rotation.transpose();
    (turned + turned.transpose()) * 0.5
}

/// Whether a matrix that is no inertia of a body is that of a point or a rod: moments that are zero to rounding, none
/// negative.
fn is_of_rod_or_point(moments: DVec3, error: InertiaError) -> bool {
    if !matches!(error, InertiaError::NotPositive(_)) {
        return false;
    }
    let rounding = rounding::DIGITS_OF_A_FILE * moments.z;
    moments.x >= -rounding && moments.z >= 0.0 && moments.z - moments.x - moments.y <= rounding
}

//! From a robot to bodies and joints of a scene.
//!
//! A body is made of the links that fixed joints connect; it has the name of the one nearest to the root and its frame.
//! A part at the end of a branch that has no mass is left out. The bodies that do not move (the world, a fixed base)
//! are ground.

use super::combine::{self, Combined};
use super::drive::{self, RobotDrive};
use super::finding::{Finding, Findings, RobotDefect};
use super::joint_extras::OF_MOTORS;
use super::model::{Actuator, ClosureKind, Robot, RobotCoordinate, RobotJointKind, Root};
use super::shapes::{self, Colliding, Meshes};
use super::weld::{self, Group, Unphysical};
use super::{posture, rates};
use glam::DVec3;
use polhode::contact::Shape;
use polhode::scene::{Coordinate, CoordinateMotion, Freedom, Joint, JointFriction, JointKind, Limits, Material, Motor};
use polhode::spatial::{Pose, UnitVector, Velocity};
use polhode::{Body, BodyId};
use std::collections::{BTreeMap, BTreeSet};

/// Largest distance of the ends of a loop that counts as closed, m for each metre of the robot (no unit, 1e-9 to 1e-3:
/// the digits of a file).
const CLOSED: f64 = 1e-6;

/// What holds the root link.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Base {
    /// Nothing.
    Free,
    /// The world.
    Fixed,
}

/// Whether the links of a robot collide with each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SelfCollision {
    /// They do not.
    Off,
    /// All but those that a joint connects do.
    On,
}

/// Where and how a robot stands in a scene.
#[derive(Debug, Clone)]
pub struct Placement {
    /// What the names of its bodies begin with, followed by a slash; empty for the names of its links.
    pub prefix: String,
    /// `X_WM`: the frame of the model in the world.
    pub pose: Pose,
    /// What holds its root; by the file when absent.
    pub base: Option<Base>,
    /// Values of coordinates at the start, by the names of their joints, rad or m.
    pub configuration: BTreeMap<String, f64>,
    /// Name of the keyframe of its file in which it starts; the pose of the file when absent.
    pub keyframe: Option<String>,
    /// Controls of actuators of its file, by their names; those of the keyframe, or zero, when absent.
    pub controls: BTreeMap<String, f64>,
    /// What drives coordinates, by the names of their joints, in the place of actuators of its file.
    pub drives: BTreeMap<String, RobotDrive>,
    /// Whether its links collide with each other.
    pub self_collision: SelfCollision,
    /// What becomes of inertias that no body can have.
    pub unphysical: Unphysical,
    /// What its surface is made of.
    pub material: Material,
}

impl Placement {
    /// Of a robot that stands in the world as its file says.
    pub(super) fn of_file(unphysical: Unphysical) -> Self {
        Self {
            prefix: String::new(),
            pose: Pose::IDENTITY,
            base: None,
            configuration: BTreeMap::new(),
            keyframe: None,
            controls: BTreeMap::new(),
            drives: BTreeMap::new(),
            self_collision: SelfCollision::Off,
            unphysical,
            material: Material::default(),
        }
    }
}

/// A joint of a robot, or a coordinate of one, that bears a name in the scene.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct NamedJoint {
    pub(crate) name: String,
    /// The place of the joint among those of the robot.
    pub(crate) joint: usize,
    /// The coordinate that bears the name; none where a joint closes a loop and has none.
    pub(crate) coordinate: Option<Coordinate>,
}

/// A robot as bodies and joints.
#[derive(Debug, Default)]
pub(crate) struct Assembly {
    /// Its bodies.
    pub(crate) bodies: Vec<Body>,
    /// Its joints, with the numbers of its bodies counted from the one given.
    pub(crate) joints: Vec<Joint>,
    /// Groups of bodies that do not collide.
    pub(crate) no_contact: Vec<Vec<BodyId>>,
    /// The names of its joints in the scene.
    pub(crate) joint_names: Vec<NamedJoint>,
    /// Coordinates that follow others.
    pub(crate) gears: Vec<RobotGear>,
    /// Coordinates whose motion is prescribed: the place of the joint, which it is, and how it moves.
    pub(crate) motions: Vec<(usize, Coordinate, CoordinateMotion)>,
}

/// A coordinate of a robot that follows another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RobotGear {
    /// The place of its joint.
    pub(crate) joint: usize,
    /// That of the joint that it follows.
    pub(crate) leader: usize,
    /// Both coordinates, its own first.
    pub(crate) coordinates: [Coordinate; 2],
    /// What it moves for each unit of the other one.
    pub(crate) ratio: f64,
}

/// Why a joint that follows another one has no effect.
const NOT_THERE: &str = "one of both is no joint of the scene: it is fixed, or nothing with mass hangs at it";

/// Why an actuator of a joint that the scene drives has no effect.
const REPLACED: &str = "the scene drives the joint in its place";

/// What an assembly is made with.
struct Making<'a> {
    robot: &'a Robot,
    placement: &'a Placement,
    /// `X_ML` of the links.
    poses: Vec<Pose>,
    /// The same at the values at which the file gives its poses.
    reference: Vec<Pose>,
    values: Vec<f64>,
    /// How the links move at the start; none where they are at rest.
    velocities: Option<Vec<Velocity>>,
    /// Controls of actuators by their names.
    controls: BTreeMap<String, f64>,
    /// The names of the coordinates that something drives.
    driven: BTreeSet<String>,
    groups: Vec<Group>,
    group_of: Vec<usize>,
    /// The joint at which each group hangs.
    above: Vec<Option<usize>>,
    meshes: Meshes,
    findings: Findings,
    made: Assembly,
    /// The body of what stands around the robot.
    around: Option<BodyId>,
    /// The body of each group.
    body_of: Vec<Option<BodyId>>,
    first: usize,
}

/// Bodies and joints of a robot, whose bodies count from `first`, and what was found.
///
/// # Errors
/// All that was found, when the robot is refused.
pub(crate) fn assembled(
    robot: &Robot,
    placement: &Placement,
    first: usize,
) -> Result<(Assembly, Vec<Finding>), Vec<Finding>> {
    let mut findings = Findings::default();
    let named = placement.keyframe.as_ref();
    let keyframe = named.and_then(|name| robot.keyframes.iter().find(|own| own.name == *name));
    let as_file = || (robot.clone(), BTreeMap::new());
    let (keyed, values_of_key) = keyframe.map_or_else(as_file, |own| posture::at_keyframe(robot, own));
    let values = posture::start(&keyed, (&placement.configuration, &values_of_key), &mut findings);
    let reference = posture::poses(robot, &posture::references(robot));
    let rates = posture::rates(robot, keyframe, &placement.drives);
    let given = keyframe.and_then(|own| own.controls.as_ref()).into_iter().flatten().copied();
    let mut controls: BTreeMap<String, f64> = robot.actuator_names.iter().cloned().zip(given).collect();
    controls.extend(placement.controls.clone());
    let robot = &posture::held(&keyed, &values);
    let poses = posture::poses(robot, &values);
    let velocities = rates.map(|rates| rates::velocities(robot, &poses, &rates));
    let (groups, group_of) = weld::groups(robot, &poses, placement.unphysical, &mut findings);
    let mut above = vec![None; groups.len()];
    for (number, joint) in robot.joints.iter().enumerate() {
        if group_of[joint.parent] != group_of[joint.child] {
            above[group_of[joint.child]] = Some(number);
        }
    }
    let body_of = vec![None; groups.len()];
    let (meshes, made) = (Meshes::new(robot.source), Assembly::default());
    let mut making = Making {
        robot,
        placement,
        poses,
        reference,
        values,
        velocities,
        controls,
        driven: BTreeSet::new(),
        groups,
        group_of,
        above,
        meshes,
        findings,
        made,
        around: None,
        body_of,
        first,
    };
    making.bodies();
    making.loops();
    making.followers();
    making.not_driven();
    making.no_contact();
    let Making { findings, made, .. } = making;
    let is_refused = findings.refuse();
    let found = findings.into_sorted();
    if is_refused { Err(found) } else { Ok((made, found)) }
}

impl Making<'_> {
    fn subject(&self, group: usize) -> String {
        format!("link `{}`", self.robot.links[self.groups[group].top()].name)
    }

    /// Bodies and joints of all groups.
    fn bodies(&mut self) {
        let is_carrier = self.carriers();
        self.root();
        for group in 1..self.groups.len() {
            let has_mass = self.groups[group].matter.is_some();
            let top = self.groups[group].top();
            if !is_carrier[group] && !has_mass {
                let (subject, place) = (self.subject(group), self.robot.links[top].place.clone());
                self.findings.add(&place, subject, RobotDefect::LeftOut);
                continue;
            }
            if !has_mass {
                // What hangs at it takes its joint too.
                continue;
            }
            let Some(chain) = self.chain(group) else { continue };
            self.movable(group);
            self.joint(group, &chain);
        }
    }

    /// Which groups have mass or carry some.
    fn carriers(&self) -> Vec<bool> {
        let mut carries: Vec<bool> = self.groups.iter().map(|group| group.matter.is_some()).collect();
        // Groups stand behind those that they hang at.
        for group in (1..self.groups.len()).rev() {
            if let Some(joint) = self.above[group].filter(|_| carries[group]) {
                carries[self.group_of[self.robot.joints[joint].parent]] = true;
            }
        }
        carries
    }

    /// The joints from the nearest group with mass, or the root, to a group; none when groups without mass between them
    /// branch.
    fn chain(&mut self, group: usize) -> Option<Vec<usize>> {
        let mut chain = Vec::new();
        let mut at = group;
        while let Some(joint) = self.above[at] {
            chain.push(joint);
            at = self.group_of[self.robot.joints[joint].parent];
            if at == 0 || self.groups[at].matter.is_some() {
                chain.reverse();
                return Some(chain);
            }
            let hanging =
                self.above.iter().flatten().filter(|&&own| self.group_of[self.robot.joints[own].parent] == at);
            if hanging.count() > 1 {
                let (subject, place) = (self.subject(at), self.robot.links[self.groups[at].top()].place.clone());
                self.findings.add(&place, subject, RobotDefect::Massless);
                return None;
            }
        }
        Some(chain)
    }

    /// The root: ground, or a body that is free.
    fn root(&mut self) {
        let has_mass = self.groups[0].matter.is_some();
        let is_world = self.robot.root == Root::World || !has_mass;
        let base = self.placement.base.unwrap_or(if is_world { Base::Fixed } else { Base::Free });
        match base {
            Base::Free if self.robot.root == Root::World || !has_mass => {
                let (subject, place) = (self.subject(0), self.robot.links[0].place.clone());
                self.findings.add(&place, subject, RobotDefect::Massless);
            }
            Base::Free => self.movable(0),
            Base::Fixed => self.ground(),
        }
    }

    /// The bodies of the root when it does not move: what stands around the robot, its base, and planes.
    fn ground(&mut self) {
        let links = self.groups[0].links.clone();
        let is_world = self.robot.root == Root::World;
        let (around, base) = links.split_at(usize::from(is_world));
        let mut grounds = Vec::new();
        if !around.is_empty() {
            let mut colliding = self.colliding(around, 0);
            grounds.append(&mut colliding.grounds);
            self.around = self.fixed(colliding, around, Pose::IDENTITY, None);
        }
        if !base.is_empty() {
            let mut colliding = self.colliding(base, base[0]);
            grounds.append(&mut colliding.grounds);
            let pose = self.poses[base[0]];
            self.body_of[0] = self.fixed(colliding, base, pose, Some(base[0]));
        }
        for (number, ground) in grounds.iter().enumerate() {
            let name = if number == 0 { "ground".to_owned() } else { format!("ground-{}", number + 1) };
            let body = self.named(Body::fixed(name).geometry(Shape::half_space(UnitVector::Z).into()));
            let pose = self.placement.pose * ground.pose;
            self.made.bodies.push(body.pose(pose));
        }
    }

    /// A body that does not move, when it collides.
    fn fixed(&mut self, colliding: Colliding, links: &[usize], pose: Pose, named_by: Option<usize>) -> Option<BodyId> {
        let link = named_by.or(links.first().copied())?;
        match colliding.shape() {
            Ok(shape) => {
                let shape = shape?;
                let body = Body::fixed(self.robot.links[link].name.clone()).geometry(shape.into());
                Some(self.push(body, pose))
            }
            Err(defect) => {
                let own = &self.robot.links[link];
                self.findings.add(&own.place, format!("link `{}`", own.name), defect);
                None
            }
        }
    }

    /// What collides of these links, in the frame of link `top`.
    fn colliding(&mut self, links: &[usize], top: usize) -> Colliding {
        let mut colliding = Colliding::default();
        for &link in links {
            let own = &self.robot.links[link];
            let pose = if link == top { Pose::IDENTITY } else { self.poses[top].relative(&self.poses[link]) };
            let subject = format!("link `{}`", own.name);
            for geom in &own.collisions {
                let notes = (&mut self.meshes, &mut self.findings);
                shapes::add(&mut colliding, geom, &(pose * geom.pose), &subject, notes);
            }
        }
        colliding
    }

    /// The body of a group with mass.
    fn movable(&mut self, group: usize) {
        let (links, top) = (self.groups[group].links.clone(), self.groups[group].top());
        let (subject, place) = (self.subject(group), self.robot.links[top].place.clone());
        let Some(matter) = self.groups[group].matter else { return };
        let properties = matter.properties().map_err(|defect| self.findings.add(&place, &subject, defect)).ok();
        let colliding = self.colliding(&links, top);
        if !colliding.grounds.is_empty() {
            self.findings.add(&place, &subject, RobotDefect::NoSuchShape("plane of a part that moves"));
        }
        let shape = colliding.shape().map_err(|defect| self.findings.add(&place, &subject, defect)).ok().flatten();
        let Some(properties) = properties else { return };
        let mut body = Body::movable(self.robot.links[top].name.clone(), properties);
        if let Some(shape) = shape {
            body = body.geometry(shape.into());
        }
        let pose = self.poses[top];
        if let Some(velocities) = &self.velocities {
            let own = velocities[top];
            let center = own.at(pose.rotation.rotate(properties.center_of_mass()));
            let in_world = |vector: DVec3| self.placement.pose.rotation.rotate(vector);
            body = body.velocity(Velocity::new(in_world(center), in_world(own.angular)));
        }
        self.body_of[group] = Some(self.push(body, pose));
    }

    /// A body with its name in the scene and its material.
    fn named(&self, body: Body) -> Body {
        let name = self.name(body.name());
        body.renamed(name).material(self.placement.material.clone())
    }

    /// A name of the file as it is in the scene.
    fn name(&self, own: &str) -> String {
        let prefix = &self.placement.prefix;
        if prefix.is_empty() { own.to_owned() } else { format!("{prefix}/{own}") }
    }

    /// Coordinates that follow others become gears.
    fn followers(&mut self) {
        for own in &self.robot.followers {
            let find = |name: &str| {
                let name = self.name(name);
                let found = self.made.joint_names.iter().find(|known| known.name == name)?;
                Some((found.joint, found.coordinate?))
            };
            let is_known = self.robot.joints.iter().any(|joint| joint.name == own.leader);
            if own.is_held() && is_known {
                continue;
            }
            if let (Some((joint, first)), Some((leader, second))) = (find(&own.name), find(&own.leader)) {
                let (coordinates, ratio) = ([first, second], own.multiplier);
                self.made.gears.push(RobotGear { joint, leader, coordinates, ratio });
            } else if !is_known {
                let unknown = RobotDefect::UnknownName { kind: "joint", name: own.leader.clone() };
                self.findings.add(&own.place, format!("joint `{}`", own.name), unknown);
            } else {
                let what = format!("`{}`, which follows `{}`", own.name, own.leader);
                self.findings.add(&own.place, "robot", RobotDefect::Ignored { what, count: 1, why: NOT_THERE });
            }
        }
    }

    fn push(&mut self, body: Body, pose: Pose) -> BodyId {
        let id = BodyId::new(self.first + self.made.bodies.len());
        let body = self.named(body).pose(self.placement.pose * pose);
        self.made.bodies.push(body);
        id
    }

    /// The joint of a group with what it hangs at.
    fn joint(&mut self, group: usize, chain: &[usize]) {
        let made = combine::combined(self.robot, chain, &self.poses, &mut self.findings);
        let Some(Combined { kind, anchor, coordinates }) = made else { return };
        let Some(kind) = self.in_world(kind) else { return };
        let (Some(body), Some(&top)) = (self.body_of[group], chain.first()) else { return };
        let anchor = self.placement.pose.transform_point(anchor);
        let mut joint = Joint::new(kind, body, anchor);
        if let Some(other) = self.body_of[self.group_of[self.robot.joints[top].parent]] {
            joint = joint.with(other);
        }
        for (&coordinate, number) in kind.coordinates().iter().zip(coordinates) {
            let value = self.values[number];
            if let Some(own) = self.robot.joints[number].coordinates.first() {
                let name = self.name(&own.name);
                let named = NamedJoint { name, joint: self.made.joints.len(), coordinate: Some(coordinate) };
                self.made.joint_names.push(named);
                let (motor, motion) = self.drive(own, coordinate, number);
                let without_limits = RobotCoordinate { limits: None, ..own.clone() };
                if motion.is_some() && own.limits.is_some() {
                    self.findings.add(&own.place, format!("joint `{}`", own.name), RobotDefect::PrescribedBeyond);
                }
                let kept = if motion.is_some() { &without_limits } else { own };
                let mut acting = freedom(kept, coordinate, value, &mut self.findings);
                // The numbers of motors have been checked, and are finite.
                if let Some(motor) = motor.and_then(|motor| drive::from_start(motor, value).ok()) {
                    acting = acting.with_motor(motor);
                }
                joint = joint.along(coordinate, acting);
                self.made.motions.extend(motion.map(|motion| (self.made.joints.len(), coordinate, motion)));
            }
        }
        self.made.joints.push(joint);
    }

    /// What drives the coordinate of joint `number`: what the scene says, or else the actuators of the file.
    fn drive(
        &mut self,
        own: &RobotCoordinate,
        coordinate: Coordinate,
        number: usize,
    ) -> (Option<Motor>, Option<CoordinateMotion>) {
        let actuators: Vec<&Actuator> = self.robot.actuators.iter().filter(|actor| actor.joint == own.name).collect();
        if let Some(drive) = self.placement.drives.get(&own.name) {
            self.driven.insert(own.name.clone());
            let (motor, told) = drive::of_scene(drive, own, coordinate);
            self.findings.add_all(vec![told]);
            for actuator in actuators {
                let what = format!("<{}> `{}`", actuator.kind, actuator.name);
                let ignored = RobotDefect::Ignored { what, count: 1, why: REPLACED };
                self.findings.add(&actuator.place, format!("joint `{}`", own.name), ignored);
            }
            return (motor, drive.motion.clone());
        }
        if actuators.is_empty() {
            return (None, None);
        }
        self.driven.insert(own.name.clone());
        let inertia = rates::inertia(self.robot, &self.reference, number);
        let mut told = Vec::new();
        let motor = drive::of_actuators(&actuators, (own, coordinate), &self.controls, inertia, &mut told);
        self.findings.add_all(told);
        (motor, None)
    }

    /// Notes what bounds or drives coordinates that nothing drives.
    fn not_driven(&mut self) {
        for actuator in self.robot.actuators.iter().filter(|own| !self.driven.contains(&own.joint)) {
            let what = format!(
                "joint `{}` is none along whose coordinate something acts: it is held, part of a joint of several \
                 axes, or carries no mass",
                actuator.joint
            );
            let subject = format!("actuator `{}`", actuator.name);
            self.findings.add(&actuator.place, subject, RobotDefect::ActuatorLeftOut(what));
        }
        let coordinates = self.robot.joints.iter().flat_map(|joint| &joint.coordinates);
        let of_others = coordinates.filter(|own| !self.driven.contains(&own.name));
        let limits: Vec<_> = of_others.filter_map(|own| own.effort_limit.as_ref()).collect();
        if let Some(first) = limits.iter().min_by(|a, b| a.place.cmp(&b.place)) {
            let (what, count) = (first.what.to_owned(), limits.len());
            self.findings.add(&first.place, "robot", RobotDefect::Ignored { what, count, why: OF_MOTORS });
        }
    }

    /// The kind of joint in the engine, with its axes in the world; none where nothing is held.
    fn in_world(&self, kind: RobotJointKind) -> Option<JointKind> {
        let rotation = self.placement.pose.rotation;
        let turned = |axis: UnitVector| UnitVector::new(rotation.rotate(axis.get())).unwrap_or(axis);
        Some(match kind {
            RobotJointKind::Free => return None,
            RobotJointKind::Fixed => JointKind::Fixed,
            RobotJointKind::Ball => JointKind::Ball,
            RobotJointKind::Hinge { axis } => JointKind::Hinge { axis: turned(axis) },
            RobotJointKind::Slider { axis } => JointKind::Slider { axis: turned(axis) },
            RobotJointKind::Cylindrical { axis } => JointKind::Cylindrical { axis: turned(axis) },
            RobotJointKind::Universal { axes } => JointKind::Universal { axes: axes.map(turned) },
            RobotJointKind::Planar { normal } => JointKind::Planar { normal: turned(normal) },
        })
    }

    /// What closes loops.
    fn loops(&mut self) {
        let robot = self.robot;
        let size = self.poses.iter().map(|pose| pose.translation.abs().max_element()).fold(1.0, f64::max);
        for own in &robot.loops {
            let [a, b] = own.links;
            let in_a = own.frames[0].unwrap_or_default();
            let in_b = own.frames[1].unwrap_or_else(|| self.reference[b].relative(&(self.reference[a] * in_a)));
            let (end_a, end_b) = (self.poses[a] * in_a, self.poses[b] * in_b);
            let gap = (end_a.translation - end_b.translation).length();
            let turn = end_a.rotation.angle_to(end_b.rotation);
            let subject = format!("loop `{}`", own.name);
            if gap > CLOSED * size || gap.is_nan() {
                self.findings.add(&own.place, subject, RobotDefect::OpenLoop(gap));
            } else if own.kind == ClosureKind::Weld && (turn > CLOSED || turn.is_nan()) {
                self.findings.add(&own.place, subject, RobotDefect::TurnedLoop(turn));
            } else {
                let joint = self.made.joints.len();
                self.closure([a, b], end_a.translation, own.kind);
                if self.made.joints.len() > joint {
                    let name = self.name(&own.name);
                    self.made.joint_names.push(NamedJoint { name, joint, coordinate: None });
                }
            }
        }
    }

    fn closure(&mut self, links: [usize; 2], point: DVec3, kind: ClosureKind) {
        let [a, b] = links.map(|link| self.body_of[self.group_of[link]]);
        let moves = |body: Option<BodyId>| {
            let own = body.and_then(|id| self.made.bodies.get(id.index() - self.first));
            own.is_some_and(|body| !body.is_fixed())
        };
        let (body, other) = if moves(a) { (a, b) } else { (b, a) };
        let Some(body) = body.filter(|_| moves(a) || moves(b)) else { return };
        let kind = match kind {
            ClosureKind::Point => JointKind::Ball,
            ClosureKind::Weld => JointKind::Fixed,
        };
        let joint = Joint::new(kind, body, self.placement.pose.transform_point(point));
        self.made.joints.push(other.map_or(joint, |other| joint.with(other)));
    }

    /// Which bodies do not collide: those of the robot, but for what stands around it, unless they are asked to.
    fn no_contact(&mut self) {
        let own: Vec<BodyId> = self.body_of.iter().flatten().copied().collect();
        let is_off = self.placement.self_collision == SelfCollision::Off;
        if is_off && own.len() > 1 {
            self.made.no_contact.push(own.clone());
        }
        let apart: BTreeSet<[usize; 2]> = self.robot.apart.iter().flat_map(|&[a, b]| [[a, b], [b, a]]).collect();
        let mut told = BTreeSet::new();
        for &pair in &self.robot.apart {
            let [Some(a), Some(b)] = pair.map(|link| self.body(link)) else { continue };
            // Those of the robot are in the group of all. Bodies of several links collide unless no two of these do.
            let is_told = is_off && own.contains(&a) && own.contains(&b);
            let [links_a, links_b] = pair.map(|link| self.colliding_with(link));
            let is_apart = links_a.iter().all(|&a| links_b.iter().all(|&b| apart.contains(&[a, b])));
            if a != b && !is_told && is_apart && told.insert((a.min(b), a.max(b))) {
                self.made.no_contact.push(vec![a, b]);
            }
        }
    }

    /// The body that a link is of.
    fn body(&self, link: usize) -> Option<BodyId> {
        let is_around = link == 0 && self.robot.root == Root::World;
        if is_around { self.around } else { self.body_of[self.group_of[link]] }
    }

    /// The links with something that collides of the body that a link is of.
    fn colliding_with(&self, link: usize) -> Vec<usize> {
        let body = self.body(link);
        let links = (0..self.robot.links.len()).filter(|&other| self.body(other) == body);
        links.filter(|&other| !self.robot.links[other].collisions.is_empty()).collect()
    }
}

/// What acts along a coordinate that is at `value` at the start: the engine counts it from there.
fn freedom(own: &RobotCoordinate, coordinate: Coordinate, value: f64, findings: &mut Findings) -> Freedom {
    let mut freedom = Freedom::default();
    if let Some([lower, upper]) = own.limits {
        if coordinate == Coordinate::Angle && upper - lower >= 2.0 * std::f64::consts::PI {
            let subject = format!("joint `{}`", own.name);
            findings.add(&own.place, subject, RobotDefect::Revolution(upper - lower));
        } else if let Ok(limits) = Limits::new(lower - value, upper - value) {
            freedom = freedom.with_limits(limits);
        }
    }
    // The constants have been checked to be finite and not negative; friction of zero is none.
    freedom = freedom.with_spring(own.stiffness, own.rest - value).unwrap_or(freedom);
    freedom = freedom.with_damping(own.damping).unwrap_or(freedom);
    JointFriction::new(own.friction).map_or(freedom, |friction| freedom.with_friction(friction))
}

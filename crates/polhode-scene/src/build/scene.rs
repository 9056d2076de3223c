//! A scene: its bodies, forces, materials and method, and where an error of the whole is shown.

use super::bodies::Bodies;
use super::fault::{Fault, Faults, not_negative, positive, vector};
use super::materials::Materials;
use super::model::{self, PlacedRobot};
use super::track::Tracks;
use super::{appearance, array, body, coordinate_motion, force, gear, joint, method};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::files::SceneFolder;
use crate::format::{self, NoContactEntry, SceneFile};
use polhode::contact::ShapeError;
use polhode::scene::{Appearance, Coordinate, CoordinateMotion};
use polhode::{Body, BodyId, JointId, Scene, SceneBuilder, SceneError};

/// A scene, and the robots that are part of it.
#[derive(Debug)]
pub(crate) struct Built {
    /// The scene.
    pub(crate) scene: Scene,
    /// Its robots.
    pub(crate) robots: Vec<PlacedRobot>,
    /// How it is shown.
    pub(crate) appearance: Appearance,
}

/// The scene that a file describes; `name` is used when the file gives none.
///
/// # Errors
/// All that is refused: at least one. What is refused is replaced, so that the rest can be looked at; errors of the
/// whole are looked for when its parts are sound.
pub(crate) fn scene(file: &SceneFile, folder: &SceneFolder, name: &str) -> Result<Built, Vec<Fault>> {
    if file.format != format::VERSION {
        return Err(vec![(KeyPath::of(&["format"]), Refusal::Version(file.format))]);
    }
    let mut faults = Faults::default();
    let mut builder = times(file, Scene::builder(file.name.as_deref().unwrap_or(name)), &mut faults);
    let materials = Materials::build(&file.materials, &mut faults);
    for (index, entry) in file.pairs.iter().enumerate() {
        if let Some(rule) = faults.note(materials.pair_rule(entry, &KeyPath::element("pairs", index))) {
            builder = builder.pair_rule(rule);
        }
    }
    let mut list = Vec::with_capacity(file.bodies.len());
    for (index, entry) in file.bodies.iter().enumerate() {
        let body = faults.note(body::build(entry, &materials, folder, &KeyPath::element("bodies", index)));
        list.push(body.unwrap_or_else(|| body::stand_in(entry)));
    }
    list.extend(array::build(file, &materials, folder, &mut faults));
    let robots = model::build(file, (&materials, folder), &mut list, &mut faults);
    check_names(file, &list, &robots, &mut faults);
    if robots.len() < file.models.len() {
        // What names bodies of a robot that is refused is no error of its own.
        faults.none()?;
        return Err(Vec::new());
    }
    let bodies = Bodies::new(&list);
    for force in force::build(file, &bodies, &mut faults) {
        builder = builder.force(force);
    }
    let tracks = Tracks::build(file, &mut builder, &mut faults);
    for joint in joint::build(file, &bodies, &tracks, &mut faults) {
        builder = builder.joint(joint);
    }
    for (joint, no_contact) in robots.iter().map(|robot| (&robot.joints, &robot.no_contact)) {
        builder = joint.iter().fold(builder, |builder, &joint| builder.joint(joint));
        builder = no_contact.iter().fold(builder, |builder, group| builder.no_contact(group.iter().copied()));
    }
    builder = gear::build(file, &robots, &mut faults).into_iter().fold(builder, SceneBuilder::gear);
    for (joint, coordinate, motion) in
        coordinate_motion::build(file, &mut faults).into_iter().chain(motions(file, &robots))
    {
        builder = builder.coordinate_motion(joint, coordinate, motion);
    }
    for (index, group) in file.no_contact.iter().enumerate() {
        if let Some(group) = faults.note(no_contact(group, &bodies, &KeyPath::element("no_contact", index))) {
            builder = builder.no_contact(group);
        }
    }
    let appearance = appearance::build(file, &list, &mut faults);
    for body in list {
        builder = builder.body(body);
    }
    faults.none()?;
    match builder.build() {
        Ok(scene) => Ok(Built { scene, robots, appearance }),
        Err(error) => Err(vec![(path_of(&error, file, &robots), Refusal::Scene(error))]),
    }
}

/// The motions of joints of robots, which follow those of the file.
fn motions(file: &SceneFile, robots: &[PlacedRobot]) -> Vec<(JointId, Coordinate, CoordinateMotion)> {
    let (mut motions, mut first) = (Vec::new(), file.joints.len());
    for robot in robots {
        for (joint, coordinate, motion) in &robot.motions {
            motions.push((JointId::new(first + joint), *coordinate, motion.clone()));
        }
        first += robot.joints.len();
    }
    motions
}

/// Method, times, gravity and start.
fn times(file: &SceneFile, mut builder: SceneBuilder, faults: &mut Faults) -> SceneBuilder {
    if let Some(method) = faults.note(method::build(&file.method, &file.promise)) {
        builder = builder.method(method);
    }
    let duration = file.duration.map(|duration| positive(duration, &KeyPath::of(&["duration"])));
    if let Some(duration) = duration.and_then(|duration| faults.note(duration)) {
        builder = builder.duration_s(duration);
    }
    let interval = file.output.interval.map(|interval| positive(interval, &KeyPath::of(&["output", "interval"])));
    if let Some(interval) = interval.and_then(|interval| faults.note(interval)) {
        builder = builder.output_interval_s(interval);
    }
    let gravity = file.gravity.as_ref().map(|gravity| vector(gravity, &KeyPath::of(&["gravity"])));
    if let Some(gravity) = gravity.and_then(|gravity| faults.note(gravity)) {
        builder = builder.gravity(gravity);
    }
    let separate = file.start.separate.map(|limit| not_negative(limit, &KeyPath::of(&["start", "separate"])));
    if let Some(limit) = separate.and_then(|limit| faults.note(limit)) {
        builder = builder.start_separation_m(limit);
    }
    builder
}

/// Where an error of the whole scene is best shown: at the body or the force it names, else at the top.
pub(crate) fn path_of(error: &SceneError, file: &SceneFile, robots: &[PlacedRobot]) -> KeyPath {
    let of_robots = robots.iter().map(|robot| robot.movable).sum();
    let body = |name: &str| {
        let index = file.bodies.iter().position(|body| body.name == name);
        let of_array = || array::of_body(name, file).map(|index| KeyPath::element("arrays", index));
        let of_robot = || model::of_body(name, robots).map(|robot| KeyPath::element("models", robot));
        let found = index.map(|index| KeyPath::element("bodies", index)).or_else(of_array).or_else(of_robot);
        found.unwrap_or_else(KeyPath::root)
    };
    match error {
        SceneError::InitialOverlap(pairs) => pairs.first().map_or_else(KeyPath::root, |pair| body(&pair.body_b)),
        SceneError::TooManySamples { duration_s, interval_s } => {
            // What is farther from the usual is to blame.
            let is_long = file.duration.is_some() && *duration_s >= 1.0 / interval_s;
            KeyPath::of(if is_long { &["duration"] } else { &["output", "interval"] })
        }
        SceneError::TooManySteps { .. } => KeyPath::of(&["method", "step"]),
        SceneError::Shape { body: name, source: ShapeError::Part { .. } | ShapeError::Decomposition(_) } => {
            body(name).key("shape").key("mesh").key("file")
        }
        SceneError::NotFinite { body: name, .. }
        | SceneError::DuplicateName(name)
        | SceneError::FixedBodyMoves(name)
        | SceneError::MovingSurface(name)
        | SceneError::Shape { body: name, .. }
        | SceneError::MovingHalfSpace(name)
        | SceneError::Motion { body: name, .. } => body(name),
        SceneError::MotionJumps { body: name, .. } => body(name).key("motion").key("table").key("interpolation"),
        SceneError::FixedBodyPivots(name) | SceneError::KinematicBodyPivots(name) => body(name).key("pivot"),
        SceneError::PivotMoves { body: name, .. } | SceneError::KinematicBodyHasVelocity(name) => {
            body(name).key("velocity")
        }
        SceneError::EmptyName(index) => KeyPath::element("bodies", *index),
        SceneError::Force { force: number, .. } | SceneError::ForceOnUnknownBody { force: number, .. } => {
            force::entry_of(*number, file, of_robots)
                .map_or_else(KeyPath::root, |index| KeyPath::element("forces", index))
        }
        SceneError::IntegratorTakesNoVelocities { .. } | SceneError::JointsWithIntegrator { .. } => {
            KeyPath::of(&["method", "integrator"])
        }
        SceneError::Gear { number, .. } | SceneError::GearRate { number, .. } if *number < file.gears.len() => {
            KeyPath::element("gears", *number)
        }
        SceneError::CoordinateMotion { joint: number, .. }
        | SceneError::CoordinateRate { joint: number, .. }
        | SceneError::Joint { number, .. }
        | SceneError::JointBeyondLimits { number, .. }
        | SceneError::JointMoves { number, .. }
        | SceneError::OffTrack { number, .. }
        | SceneError::JointTurns { number, .. } => match number.checked_sub(file.joints.len()) {
            None => KeyPath::element("joints", *number),
            Some(later) => model::path_of_joint(later, robots).unwrap_or_else(KeyPath::root),
        },
        SceneError::ReducedCoordinates { .. } => KeyPath::of(&["method", "coordinates"]),
        SceneError::FrictionInTier { .. } | SceneError::JointsInTier { .. } => KeyPath::of(&["method", "tier"]),
        _ => KeyPath::root(),
    }
}

/// Every body has a name of its own; of arrays and robots the first name that is borne twice is told.
fn check_names(file: &SceneFile, bodies: &[Body], robots: &[PlacedRobot], faults: &mut Faults) {
    let mut seen = std::collections::BTreeSet::new();
    for (index, body) in file.bodies.iter().enumerate() {
        let path = KeyPath::element("bodies", index).key("name");
        if body.name.is_empty() {
            faults.add((path, SceneError::EmptyName(index).into()));
        } else if !seen.insert(body.name.as_str()) {
            faults.add((path, Refusal::DuplicateName(body.name.clone())));
        }
    }
    let mut others = bodies.iter().skip(file.bodies.len()).map(Body::name);
    if let Some(twice) = others.find(|name| !seen.insert(*name)) {
        let of_array = array::of_body(twice, file).map(|array| KeyPath::element("arrays", array).key("name"));
        // Of two robots the second one.
        let of_robot = || model::last_of_body(twice, robots).map(|robot| KeyPath::element("models", robot));
        let path = of_array.or_else(of_robot).unwrap_or_else(KeyPath::root);
        faults.add((path, Refusal::DuplicateName(twice.to_owned())));
    }
}

/// The bodies of a group that does not collide.
fn no_contact(group: &NoContactEntry, bodies: &Bodies<'_>, path: &KeyPath) -> Result<Vec<BodyId>, Fault> {
    let path = path.key("bodies");
    if group.bodies.len() < 2 {
        let accepted = "names of two or more bodies".to_owned();
        return Err((path, Refusal::Type { found: format!("length {}", group.bodies.len()), accepted }));
    }
    let number = |(index, name): (usize, &String)| Ok(bodies.get(name, &path.index(index))?.0);
    group.bodies.iter().enumerate().map(number).collect()
}

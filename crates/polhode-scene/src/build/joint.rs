//! Joints.

use super::bodies::Bodies;
use super::fault::{Fault, Faults, direction, positive, vector};
use super::track::Tracks;
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::{
    Exactly, FreedomEntry, JointEntry, JointFrictionEntry, JointKindEntry, MotorEntry, RopeEntry, SceneFile,
    StrengthEntry, Vector,
};
use polhode::BodyId;
use polhode::scene::{
    Coordinate, Drive, Freedom, FreedomError, Joint, JointFriction, JointKind, Limits, LimitsError, Motor, Strength,
};
use polhode::spatial::DVec3;

/// The joints of the file.
pub(super) fn build(file: &SceneFile, bodies: &Bodies<'_>, tracks: &Tracks<'_>, faults: &mut Faults) -> Vec<Joint> {
    let of_entry = |(index, entry): (usize, &JointEntry)| {
        let path = KeyPath::element("joints", index);
        let joint = faults.note(joint(&entry.kind, (bodies, tracks), &path.key("type")))?;
        match entry.breaks_at.as_ref().map(|own| strength(own, &path.key("breaks_at"))) {
            None => Some(joint),
            Some(strength) => faults.note(strength).map(|strength| joint.breaking_at(strength)),
        }
    };
    file.joints.iter().enumerate().filter_map(of_entry).collect()
}

/// What an entry gives: the names of its bodies, its anchor, the path of its keys, what it leaves free, and what acts
/// along that.
struct Entry<'a> {
    names: &'a [String],
    anchor: &'a Vector,
    /// Under which key the anchor is.
    anchor_path: KeyPath,
    path: KeyPath,
    kind: JointKind,
    freedoms: Vec<(Coordinate, Freedom)>,
}

impl<'a> Entry<'a> {
    fn new(names: &'a [String], anchor: &'a Vector, path: KeyPath, kind: JointKind) -> Self {
        Self { names, anchor, anchor_path: path.key("anchor"), path, kind, freedoms: Vec::new() }
    }

    /// With what acts along a coordinate, if anything does.
    fn with(mut self, coordinate: Coordinate, entry: Option<&FreedomEntry>) -> Result<Self, Fault> {
        if let Some(entry) = entry {
            let path = self.path.key(coordinate.name());
            self.freedoms.push((coordinate, freedom(entry, coordinate, &path)?));
        }
        Ok(self)
    }
}

/// The load at which a joint breaks.
fn strength(entry: &StrengthEntry, path: &KeyPath) -> Result<Strength, Fault> {
    let StrengthEntry { force, moment, impulse } = *entry;
    if force.is_none() && moment.is_none() && impulse.is_none() {
        let (what, needed) = ("the strength of a joint", "`force`, `moment` or `impulse`");
        return Err((path.clone(), Refusal::Needs { what, needed }));
    }
    let at = |key: &'static str| {
        let path = path.key(key);
        move |error: FreedomError| (path, error.into())
    };
    let mut strength = Strength::default();
    if let Some(force) = force {
        strength = strength.force(force).map_err(at("force"))?;
    }
    if let Some(moment) = moment {
        strength = strength.moment(moment).map_err(at("moment"))?;
    }
    if let Some(impulse) = impulse {
        strength = strength.impulse(impulse).map_err(at("impulse"))?;
    }
    Ok(strength)
}

/// What acts along the coordinates of the joint of an entry, with the path of its keys.
pub(super) fn freedoms<'a>(kind: &'a JointKindEntry, path: &KeyPath) -> Vec<(Coordinate, &'a FreedomEntry, KeyPath)> {
    let (name, angle, displacement) = match kind {
        JointKindEntry::Hinge(own) => ("hinge", own.angle.as_ref(), None),
        JointKindEntry::Slider(own) => ("slider", None, own.displacement.as_ref()),
        JointKindEntry::Cylindrical(own) => ("cylindrical", own.angle.as_ref(), own.displacement.as_ref()),
        JointKindEntry::Screw(own) => ("screw", own.angle.as_ref(), None),
        JointKindEntry::Track(own) => ("track", None, own.displacement.as_ref()),
        JointKindEntry::Ball(_)
        | JointKindEntry::Universal(_)
        | JointKindEntry::Fixed(_)
        | JointKindEntry::Planar(_)
        | JointKindEntry::Rod(_)
        | JointKindEntry::Rope(_) => return Vec::new(),
    };
    let both = [(Coordinate::Angle, angle), (Coordinate::Displacement, displacement)];
    let path = |coordinate: Coordinate| path.key(name).key(coordinate.name());
    both.into_iter().filter_map(|(coordinate, own)| Some((coordinate, own?, path(coordinate)))).collect()
}

fn joint(kind: &JointKindEntry, (bodies, tracks): (&Bodies<'_>, &Tracks<'_>), path: &KeyPath) -> Result<Joint, Fault> {
    let entry = entry(kind, tracks, path)?;
    let anchor = vector(entry.anchor, &entry.anchor_path)?;
    let (body, other) = pair(entry.names, bodies, &entry.path.key("bodies"))?;
    let mut joint = Joint::new(entry.kind, body, anchor);
    for (coordinate, freedom) in entry.freedoms {
        joint = joint.along(coordinate, freedom);
    }
    Ok(other.map_or(joint, |other| joint.with(other)))
}

fn entry<'a>(kind: &'a JointKindEntry, tracks: &Tracks<'_>, path: &KeyPath) -> Result<Entry<'a>, Fault> {
    let axis = |vector, path: &KeyPath| direction(vector, &path.key("axis"));
    Ok(match kind {
        JointKindEntry::Ball(own) => Entry::new(&own.bodies, &own.anchor, path.key("ball"), JointKind::Ball),
        JointKindEntry::Fixed(own) => Entry::new(&own.bodies, &own.anchor, path.key("fixed"), JointKind::Fixed),
        JointKindEntry::Hinge(own) => {
            let path = path.key("hinge");
            let kind = JointKind::Hinge { axis: axis(&own.axis, &path)? };
            Entry::new(&own.bodies, &own.anchor, path, kind).with(Coordinate::Angle, own.angle.as_ref())?
        }
        JointKindEntry::Slider(own) => {
            let path = path.key("slider");
            let kind = JointKind::Slider { axis: axis(&own.axis, &path)? };
            Entry::new(&own.bodies, &own.anchor, path, kind)
                .with(Coordinate::Displacement, own.displacement.as_ref())?
        }
        JointKindEntry::Cylindrical(own) => {
            let path = path.key("cylindrical");
            let kind = JointKind::Cylindrical { axis: axis(&own.axis, &path)? };
            let entry = Entry::new(&own.bodies, &own.anchor, path, kind);
            let entry = entry.with(Coordinate::Angle, own.angle.as_ref())?;
            entry.with(Coordinate::Displacement, own.displacement.as_ref())?
        }
        JointKindEntry::Screw(own) => {
            let path = path.key("screw");
            let kind = JointKind::Screw { axis: axis(&own.axis, &path)?, lead: own.lead };
            Entry::new(&own.bodies, &own.anchor, path, kind).with(Coordinate::Angle, own.angle.as_ref())?
        }
        JointKindEntry::Planar(own) => {
            let path = path.key("planar");
            let normal = direction(&own.normal, &path.key("normal"))?;
            Entry::new(&own.bodies, &own.anchor, path, JointKind::Planar { normal })
        }
        JointKindEntry::Universal(own) => {
            let path = path.key("universal");
            let of_axes = path.key("axes");
            let [first, second] = &own.axes.0;
            let axes = [direction(first, &of_axes.index(0))?, direction(second, &of_axes.index(1))?];
            Entry::new(&own.bodies, &own.anchor, path, JointKind::Universal { axes })
        }
        JointKindEntry::Track(own) => {
            let path = path.key("track");
            let kind = tracks.kind(own, &path)?;
            Entry::new(&own.bodies, &own.anchor, path, kind)
                .with(Coordinate::Displacement, own.displacement.as_ref())?
        }
        JointKindEntry::Rod(own) => {
            let (ends, path) = (Ends::of(&own.anchors, &path.key("rod"))?, path.key("rod"));
            Entry {
                anchor_path: ends.path,
                ..Entry::new(&own.bodies, ends.first, path, JointKind::Rod { to: ends.to })
            }
        }
        JointKindEntry::Rope(own) => {
            let (ends, path) = (Ends::of(&own.anchors, &path.key("rope"))?, path.key("rope"));
            let limits = Freedom::default().with_limits(rope_limits(own, &ends, &path)?);
            let entry = Entry::new(&own.bodies, ends.first, path, JointKind::Rope { to: ends.to });
            Entry { anchor_path: ends.path, freedoms: vec![(Coordinate::Distance, limits)], ..entry }
        }
    })
}

/// The anchors of a rod or a rope: the first one and its path, and where the second one is.
struct Ends<'a> {
    first: &'a Vector,
    path: KeyPath,
    to: DVec3,
}

impl<'a> Ends<'a> {
    fn of(Exactly([first, second]): &'a Exactly<Vector, 2>, path: &KeyPath) -> Result<Self, Fault> {
        let path = path.key("anchors");
        Ok(Self { first, to: vector(second, &path.index(1))?, path: path.index(0) })
    }
}

/// The limits of the distance that a rope allows: its length, which without that key is the distance at the start.
fn rope_limits(entry: &RopeEntry, ends: &Ends<'_>, path: &KeyPath) -> Result<Limits, Fault> {
    let length = match entry.length {
        Some(length) => positive(length, &path.key("length"))?,
        None => (vector(ends.first, &ends.path)? - ends.to).length(),
    };
    limits((f64::NEG_INFINITY, length), entry.restitution, path)
}

/// What acts along a coordinate.
fn freedom(entry: &FreedomEntry, coordinate: Coordinate, path: &KeyPath) -> Result<Freedom, Fault> {
    let mut freedom = Freedom::default();
    match entry.range {
        Some(Exactly([lower, upper])) => {
            freedom = freedom.with_limits(limits((lower, upper), entry.restitution, path)?);
        }
        None if entry.restitution != 0.0 => {
            let what = "a coordinate without a `range`";
            return Err((path.key("restitution"), Refusal::Meaningless { key: "restitution", what }));
        }
        None => {}
    }
    let refused = |error: FreedomError| (path.clone(), error.into());
    freedom = freedom.with_spring(entry.stiffness, entry.rest).map_err(refused)?;
    freedom = freedom.with_damping(entry.damping).map_err(refused)?;
    if let Some(entry) = &entry.motor {
        freedom = freedom.with_motor(motor(entry, &path.key("motor"))?);
    }
    if let Some(entry) = &entry.friction {
        freedom = freedom.with_friction(friction(entry, coordinate, &path.key("friction"))?);
    }
    Ok(freedom)
}

/// Dry friction.
fn friction(entry: &JointFrictionEntry, coordinate: Coordinate, path: &KeyPath) -> Result<JointFriction, Fault> {
    let JointFrictionEntry { effort, breakaway, coefficient, radius } = *entry;
    let refused = |error: FreedomError| (path.clone(), error.into());
    let mut friction = JointFriction::default();
    if effort.is_some() || coefficient.is_none() {
        let effort = effort.ok_or_else(|| (path.clone(), Refusal::MissingKey("effort".to_owned())))?;
        friction = JointFriction::new(effort).map_err(refused)?;
        if let Some(breakaway) = breakaway {
            friction = friction.with_breakaway(breakaway).map_err(refused)?;
        }
    } else if breakaway.is_some() {
        let what = "friction without `effort`";
        return Err((path.key("breakaway"), Refusal::Meaningless { key: "breakaway", what }));
    }
    let Some(coefficient) = coefficient else {
        let what = "friction without `coefficient`";
        return match radius {
            Some(_) => Err((path.key("radius"), Refusal::Meaningless { key: "radius", what })),
            None => Ok(friction),
        };
    };
    let radius = match (coordinate, radius) {
        (Coordinate::Angle, None) => return Err((path.clone(), Refusal::MissingKey("radius".to_owned()))),
        (Coordinate::Angle, Some(radius)) => radius,
        (_, Some(_)) => {
            let what = "a coordinate that is no angle";
            return Err((path.key("radius"), Refusal::Meaningless { key: "radius", what }));
        }
        (_, None) => 1.0,
    };
    friction.with_bearing(coefficient, radius).map_err(refused)
}

/// A motor.
pub(super) fn motor(entry: &MotorEntry, path: &KeyPath) -> Result<Motor, Fault> {
    let needed =
        |value: Option<f64>, key: &str| value.ok_or_else(|| (path.clone(), Refusal::MissingKey(key.to_owned())));
    let without = |values: &[(Option<f64>, &'static str)], what: &'static str| {
        let extra = values.iter().find(|(value, _)| value.is_some());
        extra.map_or(Ok(()), |&(_, key)| Err((path.key(key), Refusal::Meaningless { key, what })))
    };
    let MotorEntry { effort, velocity, gain, position, stiffness, damping, most } = *entry;
    let of_position = [(stiffness, "stiffness"), (damping, "damping")];
    let drive = match (effort, velocity, position) {
        (Some(effort), None, None) => {
            without(&[(gain, "gain")], "a motor of constant effort")?;
            without(&of_position, "a motor of constant effort")?;
            Drive::Effort(effort)
        }
        (None, Some(velocity), None) => {
            without(&of_position, "a servo of velocity: `gain` is its constant")?;
            Drive::Velocity { velocity, gain: needed(gain, "gain")? }
        }
        (None, None, Some(position)) => {
            without(&[(gain, "gain")], "a servo of position: `stiffness` and `damping` are its constants")?;
            let stiffness = needed(stiffness, "stiffness")?;
            Drive::Position { position, stiffness, damping: damping.unwrap_or(0.0) }
        }
        _ => return Err((path.clone(), Refusal::MotorKinds)),
    };
    let refused = |error: FreedomError| (path.clone(), error.into());
    let motor = Motor::new(drive).map_err(refused)?;
    most.map_or(Ok(motor), |most| motor.at_most(most).map_err(refused))
}

/// Limits of a coordinate.
fn limits((lower, upper): (f64, f64), restitution: f64, path: &KeyPath) -> Result<Limits, Fault> {
    let refused = |error: LimitsError| (path.clone(), error.into());
    Limits::new(lower, upper).and_then(|limits| limits.with_restitution(restitution)).map_err(refused)
}

/// The numbers of the bodies of a joint: one, and another or the world.
fn pair(names: &[String], bodies: &Bodies<'_>, path: &KeyPath) -> Result<(BodyId, Option<BodyId>), Fault> {
    let number = |index: usize, name: &String| Ok(bodies.get(name, &path.index(index))?.0);
    match names {
        [one] => Ok((number(0, one)?, None)),
        [one, other] if one == other => Err((path.index(1), Refusal::Repeated(other.clone()))),
        [one, other] => Ok((number(0, one)?, Some(number(1, other)?))),
        _ => {
            let accepted = "the names of two bodies, or of one that the world holds".to_owned();
            Err((path.clone(), Refusal::Type { found: format!("length {}", names.len()), accepted }))
        }
    }
}

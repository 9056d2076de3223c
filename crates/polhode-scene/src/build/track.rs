//! Tracks, and the joints that hold bodies to them.

use super::fault::{Fault, Faults, direction, vector};
use crate::document::KeyPath;
use crate::error::{Refusal, nearest};
use crate::format::{
    BendEntry, CircleEntry, CurveEntry, CycloidEntry, FollowsName, HelixEntry, PathEntry, SceneFile, TrackEndsName,
    TrackEntry, TrackJointEntry, Vector, WaveEntry,
};
use glam::DVec3;
use polhode::SceneBuilder;
use polhode::scene::{Follows, JointKind, OneSide, TrackEnds, TrackHold, TrackId, TrackSprings};
use polhode::spatial::curve::{Bend, Coil, Curve, CurveError, Rolling, SplineEnds, Wave};
use std::collections::BTreeMap;

/// The tracks of a file by name.
#[derive(Debug, Default)]
pub(super) struct Tracks<'a> {
    known: BTreeMap<&'a str, TrackId>,
}

impl<'a> Tracks<'a> {
    /// Adds the tracks of a file to a scene.
    pub(super) fn build(file: &'a SceneFile, builder: &mut SceneBuilder, faults: &mut Faults) -> Self {
        let mut tracks = Self::default();
        for (index, TrackEntry { name, curve: entry }) in file.tracks.iter().enumerate() {
            let path = KeyPath::element("tracks", index);
            if name.is_empty() || tracks.known.contains_key(name.as_str()) {
                let accepted = "a name of its own".to_owned();
                faults.add((path.key("name"), Refusal::Type { found: format!("the track name `{name}`"), accepted }));
                continue;
            }
            let made = curve(entry, &path.key("curve"));
            // A stand-in for one that is refused: what names it is no error of its own.
            let made = faults.note(made).map_or_else(|| TrackId::new(usize::MAX), |curve| builder.add_track(curve));
            tracks.known.insert(name, made);
        }
        tracks
    }

    fn get(&self, name: &str, path: &KeyPath) -> Result<TrackId, Fault> {
        self.known.get(name).copied().ok_or_else(|| {
            let names: Vec<&str> = self.known.keys().copied().collect();
            let known = nearest(name, &names, "none, the scene has no tracks");
            (path.clone(), Refusal::UnknownName { kind: "track", name: name.to_owned(), known })
        })
    }

    /// The kind of a joint on a track.
    pub(super) fn kind(&self, entry: &TrackJointEntry, path: &KeyPath) -> Result<JointKind, Fault> {
        let track = self.get(&entry.track, &path.key("track"))?;
        let restitution = entry.restitution.unwrap_or(0.0);
        let up = entry.up.as_ref().map(|up| direction(up, &path.key("up"))).transpose()?;
        let follows = match (entry.follows, up) {
            (FollowsName::Frame, up) => Follows::Frame { up },
            (_, Some(_)) => {
                let what = "a track without `follows = \"frame\"`";
                return Err((path.key("up"), Refusal::Meaningless { key: "up", what }));
            }
            (FollowsName::Point, None) => Follows::Point,
            (FollowsName::Tangent, None) => Follows::Tangent,
        };
        if entry.follows != FollowsName::Point && (entry.side.is_some() || entry.springs.is_some()) {
            let what = "a track with a `side` or `springs`: a joint at each of two points of the body turns it";
            return Err((path.key("follows"), Refusal::Meaningless { key: "follows", what }));
        }
        let hold = match (&entry.side, &entry.springs) {
            (Some(_), Some(_)) => {
                return Err((path.key("springs"), Refusal::Excludes { key: "springs", other: "side" }));
            }
            (Some(side), None) => {
                TrackHold::OneSide(OneSide { towards: direction(side, &path.key("side"))?, restitution })
            }
            (None, Some(springs)) => TrackHold::Springs(TrackSprings {
                stiffness: springs.stiffness,
                damping: springs.damping,
                reach: springs.reach.unwrap_or(f64::INFINITY),
            }),
            (None, None) => TrackHold::Both(follows),
        };
        let ends = match entry.ends {
            TrackEndsName::Free => TrackEnds::Free,
            TrackEndsName::Stops => TrackEnds::Stops(restitution),
            TrackEndsName::Straight => TrackEnds::Straight,
        };
        if entry.restitution.is_some() && entry.side.is_none() && entry.ends != TrackEndsName::Stops {
            let what = "a track without a `side` and without `ends = \"stops\"`";
            return Err((path.key("restitution"), Refusal::Meaningless { key: "restitution", what }));
        }
        Ok(JointKind::Track { track, hold, ends })
    }
}

/// A curve.
fn curve(entry: &CurveEntry, path: &KeyPath) -> Result<Curve, Fault> {
    let refused = |key: &'static str| {
        let path = path.key(key);
        move |error: CurveError| (path, Refusal::from(error))
    };
    match entry {
        CurveEntry::Line(own) => {
            let path = path.key("line").key("points");
            let [first, last] = &own.points.0;
            Curve::line(vector(first, &path.index(0))?, vector(last, &path.index(1))?).map_err(refused("line"))
        }
        CurveEntry::Circle(CircleEntry { center, axis, radius }) => {
            let path = path.key("circle");
            let axis = direction(axis, &path.key("axis"))?;
            let out = axis.get().any_orthonormal_vector() * *radius;
            Curve::circle(vector(center, &path.key("center"))?, axis, out).map_err(refused("circle"))
        }
        CurveEntry::Helix(HelixEntry { start, center, axis, advance, turns }) => {
            let path = path.key("helix");
            let axis = direction(axis, &path.key("axis"))?;
            let start = vector(start, &path.key("start"))?;
            let center = vector(center, &path.key("center"))?;
            // The center at the height of the start.
            let center = center + axis.get() * axis.get().dot(start - center);
            let coil = Coil { advance: *advance, turns: *turns };
            Curve::helix(center, axis, start - center, coil).map_err(refused("helix"))
        }
        CurveEntry::Path(own) => path_of(own, &path.key("path"))?.map_err(refused("path")),
        CurveEntry::Spline(own) => {
            let points = vectors(&own.points, &path.key("spline").key("points"))?;
            let ends = if own.closed { SplineEnds::Closed } else { SplineEnds::Open };
            Curve::spline(&points, ends).map_err(refused("spline"))
        }
        CurveEntry::Polynomial(own) => {
            let coefficients = vectors(&own.coefficients, &path.key("polynomial").key("coefficients"))?;
            Curve::polynomial(&coefficients, own.range.0).map_err(refused("polynomial"))
        }
        CurveEntry::Wave(WaveEntry { start, heading, up, amplitude, wavelength, length }) => {
            let path = path.key("wave");
            let heading = direction(heading, &path.key("heading"))?;
            let wave = Wave { amplitude: *amplitude, wavelength: *wavelength, length: *length };
            let (start, up) = (vector(start, &path.key("start"))?, vector(up, &path.key("up"))?);
            Curve::wave(start, heading, up, wave).map_err(refused("wave"))
        }
        CurveEntry::Cycloid(CycloidEntry { lowest, heading, up, radius, angle }) => {
            let path = path.key("cycloid");
            let heading = direction(heading, &path.key("heading"))?;
            let (lowest, up) = (vector(lowest, &path.key("lowest"))?, vector(up, &path.key("up"))?);
            let rolling = Rolling { radius: *radius, reach: *angle };
            Curve::cycloid(lowest, heading, up, rolling).map_err(refused("cycloid"))
        }
    }
}

fn vectors(entries: &[Vector], path: &KeyPath) -> Result<Vec<DVec3>, Fault> {
    entries.iter().enumerate().map(|(index, entry)| vector(entry, &path.index(index))).collect()
}

fn path_of(entry: &PathEntry, path: &KeyPath) -> Result<Result<Curve, CurveError>, Fault> {
    let heading = direction(&entry.heading, &path.key("heading"))?;
    let (start, up) = (vector(&entry.start, &path.key("start"))?, vector(&entry.up, &path.key("up"))?);
    let of_part = |(index, part): (usize, &BendEntry)| bend(part, &path.key("parts").index(index));
    let bends = entry.parts.iter().enumerate().map(of_part).collect::<Result<Vec<_>, _>>()?;
    Ok(Curve::path(start, heading, up, &bends))
}

/// A part of a path.
fn bend(entry: &BendEntry, path: &KeyPath) -> Result<Bend, Fault> {
    let excludes = |key, other| Err((path.key(key), Refusal::Excludes { key, other }));
    match (entry.length, entry.radius, entry.angle) {
        (Some(length), None, None) => {
            let curvature = entry.curvature.as_ref().map_or([0.0; 2], |curvature| curvature.0);
            Ok(Bend { length, curvature })
        }
        (None, Some(_), Some(_)) if entry.curvature.is_some() => excludes("curvature", "radius"),
        (None, Some(radius), Some(angle)) => {
            let curvature = angle.signum() / radius;
            Ok(Bend { length: radius * angle.abs(), curvature: [curvature; 2] })
        }
        (Some(_), Some(_), _) => excludes("radius", "length"),
        (Some(_), None, Some(_)) => excludes("angle", "length"),
        (None, Some(_), None) => Err((path.clone(), Refusal::MissingKey("angle".to_owned()))),
        (None, None, Some(_)) => Err((path.clone(), Refusal::MissingKey("radius".to_owned()))),
        (None, None, None) => Err((path.clone(), Refusal::MissingKey("length".to_owned()))),
    }
}

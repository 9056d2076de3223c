//! What of a scene is uncertain: entries are checked here, and that the scene takes their keys by who reads the scene.

use super::fault::{Fault, Faults, finite, not_negative, positive};
use super::placement;
use crate::document::KeyPath;
use crate::error::{Refusal, nearest};
use crate::format::{AxesEntry, BodyEntry, DrawName, LimitsEntry, SPREADS, SceneFile, UncertainEntry};
use crate::uncertain::{Distribution, Draw, RotationForm, StartPose, Uncertain};

/// The number that a key of the scene has; none where it has none.
type NumberOf<'a> = dyn Fn(&str) -> Option<f64> + 'a;

/// What is uncertain, in the order of the file.
///
/// # Errors
/// All that is refused.
pub(crate) fn build(file: &SceneFile, number_of: &NumberOf<'_>) -> Result<Vec<Uncertain>, Vec<Fault>> {
    let (mut faults, mut all) = (Faults::default(), Vec::new());
    let (mut keys, mut bodies) = (Vec::new(), Vec::new());
    for (index, entry) in file.uncertain.iter().enumerate() {
        let path = KeyPath::element("uncertain", index);
        let one = match (&entry.key, &entry.bodies) {
            (Some(_), Some(_)) => Err((path.key("bodies"), Refusal::Excludes { key: "bodies", other: "key" })),
            (None, None) => Err((path.clone(), Refusal::MissingKey("key` or `bodies".to_owned()))),
            (Some(key), None) => of_key(key, entry, &mut keys, (&path, number_of)),
            (None, Some(names)) => of_poses(names, entry, &mut bodies, (&path, file)),
        };
        all.extend(faults.note(one));
    }
    faults.none()?;
    Ok(all)
}

/// The value of a key.
fn of_key<'a>(
    key: &'a str,
    entry: &UncertainEntry,
    seen: &mut Vec<&'a str>,
    (path, number_of): (&KeyPath, &NumberOf<'_>),
) -> Result<Uncertain, Fault> {
    if seen.contains(&key) {
        let what = format!("`{key}` is uncertain twice: leave one out");
        return Err((path.key("key"), Refusal::Other(what)));
    }
    seen.push(key);
    let of_poses = [
        ("position_deviation", entry.position_deviation.is_some()),
        ("rotation_deviation", entry.rotation_deviation.is_some()),
        ("draw", entry.draw.is_some()),
    ];
    if let Some((other, _)) = of_poses.into_iter().find(|(_, is_given)| *is_given) {
        return Err((path.key(other), Refusal::Meaningless { key: other, what: "a key: it is for bodies" }));
    }
    let nominal = |given: Option<f64>, path: &KeyPath, what: &'static str| {
        given.or_else(|| number_of(key)).ok_or_else(|| {
            let why = format!("the scene has no number at `{key}`: give {what}");
            (path.clone(), Refusal::Other(why))
        })
    };
    let drawn = match kinds(entry)[..] {
        ["normal"] => {
            let (own, path) = (entry.normal.as_ref(), path.key("normal"));
            let given = own.and_then(|own| own.mean);
            let mean = finite(nominal(given, &path, "its mean")?, &path.key("mean"))?;
            let deviation = not_negative(own.map_or(0.0, |own| own.deviation), &path.key("deviation"))?;
            Distribution::Normal { mean, deviation }
        }
        ["lognormal"] => {
            let (own, path) = (entry.lognormal.as_ref(), path.key("lognormal"));
            let given = own.and_then(|own| own.median);
            let median = positive(nominal(given, &path, "its median")?, &path.key("median"))?;
            let spread = not_negative(own.map_or(0.0, |own| own.spread), &path.key("spread"))?;
            Distribution::LogNormal { median, spread }
        }
        ["uniform"] => {
            let (low, high) = limits(entry.uniform.as_ref(), &path.key("uniform"))?;
            Distribution::Uniform { low, high }
        }
        ["interval"] => {
            // Where nothing else is known, all of them are as probable as each other.
            let (low, high) = limits(entry.interval.as_ref(), &path.key("interval"))?;
            Distribution::Uniform { low, high }
        }
        ["choice"] => {
            let values: Vec<String> = entry.choice.iter().flatten().map(|own| own.0.clone()).collect();
            if values.is_empty() {
                return Err((path.key("choice"), Refusal::Other("a choice has at least one value".to_owned())));
            }
            Distribution::Choice(values)
        }
        _ => {
            let why = format!("an uncertain key has exactly one of {SPREADS}");
            return Err((path.clone(), Refusal::Other(why)));
        }
    };
    Ok(Uncertain::Key { key: key.to_owned(), drawn })
}

/// The kinds of distribution that an entry has.
fn kinds(entry: &UncertainEntry) -> Vec<&'static str> {
    let given = [
        ("normal", entry.normal.is_some()),
        ("lognormal", entry.lognormal.is_some()),
        ("uniform", entry.uniform.is_some()),
        ("interval", entry.interval.is_some()),
        ("choice", entry.choice.is_some()),
    ];
    given.into_iter().filter(|(_, is_given)| *is_given).map(|(name, _)| name).collect()
}

/// The limits of a range: the smaller one first, and apart.
fn limits(entry: Option<&LimitsEntry>, path: &KeyPath) -> Result<(f64, f64), Fault> {
    let (low, high) = entry.map_or((0.0, 0.0), |own| (own.low, own.high));
    finite(low, &path.key("low"))?;
    finite(high, &path.key("high"))?;
    if low < high {
        Ok((low, high))
    } else {
        let why = format!("the range from {low} to {high} is empty: low must be below high");
        Err((path.clone(), Refusal::Other(why)))
    }
}

/// The poses of bodies.
fn of_poses<'a>(
    names: &'a [String],
    entry: &UncertainEntry,
    seen: &mut Vec<&'a str>,
    (path, file): (&KeyPath, &SceneFile),
) -> Result<Uncertain, Fault> {
    if let Some(other) = kinds(entry).first() {
        return Err((path.key(*other), Refusal::Meaningless { key: other, what: "bodies: it is for a key" }));
    }
    let path_of_bodies = path.key("bodies");
    let mut bodies = Vec::new();
    for (index, name) in names.iter().enumerate() {
        let path = path_of_bodies.index(index);
        let Some(number) = file.bodies.iter().position(|body| body.name == *name) else {
            let known: Vec<&str> = file.bodies.iter().map(|body| body.name.as_str()).collect();
            let known = nearest(name, &known, "none: the scene has no list of bodies");
            return Err((path, Refusal::UnknownName { kind: "body of the list of bodies", name: name.clone(), known }));
        };
        if seen.contains(&name.as_str()) {
            return Err((path, Refusal::Repeated(name.clone())));
        }
        seen.push(name);
        bodies.push(start_pose(&file.bodies[number], &KeyPath::element("bodies", number))?);
    }
    let given = entry.position_deviation.is_some() || entry.rotation_deviation.is_some();
    if bodies.is_empty() || !given {
        let why = "uncertain poses are of at least one body, and have `position_deviation`, m, or \
                   `rotation_deviation`, rad, or both";
        return Err((path.clone(), Refusal::Other(why.to_owned())));
    }
    let of_axes = |axes: Option<AxesEntry>, path: KeyPath| {
        let AxesEntry(axes) = axes.unwrap_or(AxesEntry([0.0; 3]));
        axes.into_iter().try_for_each(|own| not_negative(own, &path).map(|_| ())).map(|()| axes)
    };
    Ok(Uncertain::Poses {
        bodies,
        position_deviation_m: of_axes(entry.position_deviation, path.key("position_deviation"))?,
        rotation_deviation_rad: of_axes(entry.rotation_deviation, path.key("rotation_deviation"))?,
        draw: match entry.draw {
            None | Some(DrawName::Each) => Draw::Each,
            Some(DrawName::Alike) => Draw::Alike,
        },
    })
}

/// Where a body of the file begins.
fn start_pose(entry: &BodyEntry, path: &KeyPath) -> Result<StartPose, Fault> {
    let (orientation, vector) = (entry.orientation.as_ref(), entry.rotation_vector.as_ref());
    let pose = placement::pose(entry.position.as_ref(), orientation, vector, path)?;
    let form = if orientation.is_some() { RotationForm::Quaternion } else { RotationForm::Vector };
    Ok(StartPose::new(&entry.name, pose, form))
}

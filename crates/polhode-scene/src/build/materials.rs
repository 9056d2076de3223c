//! Materials and rules for pairs of them.

use super::fault::{Fault, Faults};
use crate::document::KeyPath;
use crate::error::{Refusal, nearest};
use crate::format::{GrainEntry, MaterialEntry, NumberOr, PairEntry, StaticGrainEntry};
use glam::DVec3;
use polhode::SceneError;
use polhode::scene::{FrictionEllipse, Material, PairRule, RestitutionSpeed};
use std::collections::BTreeMap;

/// The materials of a scene by name.
pub(super) struct Materials(BTreeMap<String, Material>);

impl Materials {
    /// All that are sound, and a stand-in without friction for each of the others.
    pub(super) fn build(entries: &BTreeMap<String, MaterialEntry>, faults: &mut Faults) -> Self {
        let mut materials = BTreeMap::new();
        for (name, entry) in entries {
            let path = KeyPath::of(&["materials"]).key(name.clone());
            if name.is_empty() {
                // The empty name is the engine's for bodies without a material.
                let accepted = "a name that is not empty".to_owned();
                faults.add((path, Refusal::Type { found: "an empty name".to_owned(), accepted }));
                materials.insert(name.clone(), Material::default());
                continue;
            }
            let given = (entry.restitution, entry.restitution_yield_speed, entry.restitution_slope);
            let speed = match restitution_speed(given, &path) {
                Ok(speed) => speed,
                Err(refused) => {
                    faults.add(refused);
                    materials.insert(name.clone(), Material::default());
                    continue;
                }
            };
            let material = with_friction(name, entry)
                .and_then(|material| material.with_restitution_speed(speed))
                .and_then(|material| match &entry.static_friction {
                    Some(NumberOr::Number(static_friction)) => material.with_static_friction(*static_friction),
                    Some(NumberOr::Table(table)) => material.with_static_ellipse(at_rest(table)),
                    None => Ok(material),
                })
                .and_then(|material| {
                    let [rolling, spinning] = [entry.rolling_friction, entry.spinning_friction];
                    material.with_rotational_friction(rolling.unwrap_or(0.0), spinning.unwrap_or(0.0))
                })
                .and_then(|material| with_elasticity(material, entry))
                .map_err(|error| fault(error, &path));
            materials.insert(name.clone(), faults.note(material).unwrap_or_default());
        }
        Self(materials)
    }

    /// The material of this name, given at `path`.
    pub(super) fn get(&self, name: &str, path: &KeyPath) -> Result<Material, Fault> {
        self.0.get(name).cloned().ok_or_else(|| {
            let names: Vec<_> = self.0.keys().map(String::as_str).collect();
            let known = nearest(name, &names, "none, the scene has no materials");
            (path.clone(), Refusal::UnknownName { kind: "material", name: name.to_owned(), known })
        })
    }

    /// The rule for a pair of materials that are there.
    pub(super) fn pair_rule(&self, entry: &PairEntry, path: &KeyPath) -> Result<PairRule, Fault> {
        for (index, name) in entry.materials.0.iter().enumerate() {
            self.get(name, &path.key("materials").index(index))?;
        }
        let given = (entry.restitution, entry.restitution_yield_speed, entry.restitution_slope);
        let speed = restitution_speed(given, path)?;
        let rule = PairRule::new(entry.materials.0.clone());
        let rule = match &entry.friction {
            None => Ok(rule),
            Some(NumberOr::Number(friction)) => rule.with_friction(*friction),
            Some(NumberOr::Table(grain)) => rule.with_grain(direction(grain), kinetic(grain)),
        };
        rule.and_then(|rule| match entry.restitution {
            Some(restitution) => rule.with_restitution(restitution).and_then(|rule| rule.with_restitution_speed(speed)),
            None => Ok(rule),
        })
        .and_then(|rule| match &entry.static_friction {
            Some(NumberOr::Number(static_friction)) => rule.with_static_friction(*static_friction),
            Some(NumberOr::Table(table)) => rule.with_static_ellipse(at_rest(table)),
            None => Ok(rule),
        })
        .and_then(|rule| rule.with_rotational_friction(entry.rolling_friction, entry.spinning_friction))
        .map_err(|error| fault(error, path))
    }
}

/// A material with its kinetic friction and restitution. A grain without a direction is refused as one of length zero
/// is.
fn with_friction(name: &str, entry: &MaterialEntry) -> Result<Material, SceneError> {
    let material = Material::new(name);
    let material = match &entry.friction {
        None => material,
        Some(NumberOr::Number(friction)) => material.with_friction(*friction)?,
        Some(NumberOr::Table(grain)) => material.with_grain(direction(grain).unwrap_or_default(), kinetic(grain))?,
    };
    material.with_restitution(entry.restitution.unwrap_or(0.0))
}

/// How restitution depends on speed, from the coefficient, the yield speed and the slope given.
fn restitution_speed(
    (restitution, yield_speed, slope): (Option<f64>, Option<f64>, Option<f64>),
    path: &KeyPath,
) -> Result<RestitutionSpeed, Fault> {
    let (key, speed) = match (yield_speed, slope) {
        (None, None) => return Ok(RestitutionSpeed::Constant),
        (Some(_), Some(_)) => {
            let found = "restitution_yield_speed and restitution_slope".to_owned();
            let accepted = "one of the two: each is a law of its own".to_owned();
            return Err((path.key("restitution_slope"), Refusal::Type { found, accepted }));
        }
        (Some(limit), None) => ("restitution_yield_speed", RestitutionSpeed::Yield(limit)),
        (None, Some(slope)) => ("restitution_slope", RestitutionSpeed::Slope(slope)),
    };
    if restitution.is_none() {
        let found = format!("{key} without restitution");
        let accepted = format!("restitution, that of slow impacts, beside {key}");
        return Err((path.key(key), Refusal::Type { found, accepted }));
    }
    Ok(speed)
}

/// Poisson's ratio of a material that gives Young's modulus alone.
const POISSON_RATIO: f64 = 0.3;

/// A material with its elastic constants. A ratio without a modulus is refused.
fn with_elasticity(material: Material, entry: &MaterialEntry) -> Result<Material, SceneError> {
    match (entry.youngs_modulus_pa, entry.poisson_ratio) {
        (None, None) => Ok(material),
        (young, poisson) => material.with_elasticity(young.unwrap_or(f64::NAN), poisson.unwrap_or(POISSON_RATIO)),
    }
}

fn kinetic(grain: &GrainEntry) -> FrictionEllipse {
    FrictionEllipse { along: grain.along, across: grain.across }
}

fn at_rest(grain: &StaticGrainEntry) -> FrictionEllipse {
    FrictionEllipse { along: grain.along, across: grain.across }
}

fn direction(grain: &GrainEntry) -> Option<DVec3> {
    grain.direction.as_ref().map(|direction| DVec3::from_array(direction.0))
}

/// An error of a material's numbers, at the number.
fn fault(error: SceneError, path: &KeyPath) -> Fault {
    let key = match &error {
        SceneError::Restitution { .. } => "restitution",
        SceneError::RestitutionSpeed { quantity, .. } => quantity,
        SceneError::StaticFriction { .. } | SceneError::StaticGrain { .. } => "static_friction",
        SceneError::RotationalFriction { kind: "rolling", .. } => "rolling_friction",
        SceneError::RotationalFriction { .. } => "spinning_friction",
        SceneError::ElasticConstant { key, .. } => key,
        _ => "friction",
    };
    (path.key(key), error.into())
}

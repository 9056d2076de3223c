//! Meshes that are open, inverted, mirrored or missing. Each file is told once.

use super::super::finding::{Findings, RobotDefect};
use super::super::model::{GeomForm, Robot};
use super::super::shapes::{Meshes, is_mirrored, is_not_read};
use polhode::mesh::{DefectKind, Location, diagnose};
use std::collections::BTreeSet;

/// Whether a geometry collides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Use {
    Collides,
    Seen,
}

/// Examines all meshes.
pub(super) fn examine(robot: &Robot, meshes: &mut Meshes, findings: &mut Findings) {
    let mut told = BTreeSet::new();
    for link in &robot.links {
        let subject = format!("link `{}`", link.name);
        let colliding = link.collisions.iter().map(|geom| (geom, Use::Collides));
        for (geom, own_use) in colliding.chain(link.visuals.iter().map(|geom| (geom, Use::Seen))) {
            let GeomForm::Mesh { name, path, scale } = &geom.form else { continue };
            if !told.insert((name.clone(), scale.to_array().map(f64::to_bits))) {
                continue;
            }
            // Meshes that are only seen, in formats that are not read, say nothing of the motion.
            if own_use == Use::Seen && is_not_read(name) {
                continue;
            }
            let mesh = match meshes.read(name, path.as_deref(), *scale) {
                Ok(mesh) => mesh,
                // A missing mesh that collides has refused the robot, or is told already.
                Err(_) if own_use == Use::Collides => continue,
                Err(defect) => {
                    let (what, why) = (format!("mesh of a visual: {defect}"), "it is only seen");
                    findings.add(&geom.place, &subject, RobotDefect::Ignored { what, count: 1, why });
                    continue;
                }
            };
            if is_mirrored(*scale) {
                findings.add(&geom.place, &subject, RobotDefect::Mirrored { file: name.clone(), scale: *scale });
            }
            // The hull is what collides; what is only seen need not be a solid.
            if own_use == Use::Seen {
                continue;
            }
            let diagnosis = diagnose(&mesh);
            let Some(worst) = diagnosis.defects.iter().find(|defect| defect.kind.prevents_solid()) else { continue };
            let file = name.clone();
            let defect = match (worst.kind, worst.location) {
                (DefectKind::Inverted, Location::Component { volume, .. }) => {
                    RobotDefect::InvertedMesh { file, volume }
                }
                _ => RobotDefect::OpenMesh { file, defect: worst.to_string() },
            };
            findings.add(&geom.place, &subject, defect);
        }
    }
}

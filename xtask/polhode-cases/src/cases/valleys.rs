//! Round bodies where contacts are hard to follow: discs that slide flush down a slope into the other side of a valley,
//! and a ring that falls about a cone. The run ends, energy does not grow, and nothing sinks in.
//!
//! A body that keeps falling and sliding without friction and restitution loses energy at impacts alone, so that what
//! the integration loses besides (the ledger's part that no effect explains) is the error of the run.

use super::bodies::{bouncy, half_space};
use super::{CaseResult, Context, Run};
use crate::row::Row;
use glam::DVec3;
use polhode::contact::Shape;
use polhode::mesh::{Cone, Cylinder, Primitive, Torus};
use polhode::spatial::{Mass, Pose, Rotation, UnitVector};
use polhode::{Body, Effects, Scene};
use std::error::Error;

const CASE: &str = "round bodies in valleys";

/// Penetration that is accepted, m: the clearance of contacts of this size is 1e-9 m.
const PENETRATION_M: f64 = 1e-12;

/// Energy that may be lost or gained without a reason, J, of some 20 J.
const UNEXPLAINED_J: f64 = 1e-8;

/// Slopes of the two sides, degrees.
const SLOPES: [[f64; 2]; 3] = [[45.0, 45.0], [30.0, 60.0], [50.0, 25.0]];

/// All rows.
pub(super) fn rows(_: &Context) -> CaseResult {
    let bodies = [
        ("cone", Shape::cone(0.25, 0.6)?, Primitive::Cone(Cone::new(0.25, 0.6)?)),
        ("cylinder", Shape::cylinder(0.25, 0.4)?, Primitive::Cylinder(Cylinder::new(0.25, 0.4)?)),
    ];
    let mut rows = Vec::new();
    for (name, shape, primitive) in &bodies {
        for slopes in SLOPES {
            let start = Pose::from_translation(DVec3::new(0.1, 0.0, 2.2));
            let mut builder = Scene::builder("valley").duration_s(1.5);
            for (side, slope) in [1.0, -1.0].into_iter().zip(slopes.map(f64::to_radians)) {
                let normal = UnitVector::new(DVec3::new(side * slope.sin(), 0.0, slope.cos()))?;
                builder = builder.body(half_space(&format!("side {side}"), normal).material(bouncy(0.0)?));
            }
            let scene = builder.body(movable(name, shape, primitive, start)?).build()?;
            let [left, right] = slopes;
            measure(&format!("{name}, slopes of {left} and {right} degrees"), &scene, &mut rows);
        }
    }
    let (cone_name, cone_shape, cone) = &bodies[0];
    let turned = |turn: [f64; 3], place: [f64; 3]| Pose::new(Rotation::from_rotation_vector(turn.into()), place.into());
    let ring = Primitive::Torus(Torus::new(0.3, 0.1)?);
    let scene = Scene::builder("ring about a cone")
        .duration_s(1.5)
        .body(half_space("floor", UnitVector::Z))
        .body(movable(cone_name, cone_shape, cone, turned([-0.09, 0.42, 0.25], [0.0, 0.0, 0.7]))?)
        .body(movable("ring", &Shape::torus(0.3, 0.1)?, &ring, turned([-0.51, 0.64, -0.08], [0.091, -0.076, 1.9]))?)
        .build()?;
    measure("ring about a cone", &scene, &mut rows);
    Ok(rows)
}

fn movable(name: &str, shape: &Shape, primitive: &Primitive, pose: Pose) -> Result<Body, Box<dyn Error>> {
    let properties = primitive.solid(Mass::new(1.0)?)?;
    Ok(Body::movable(name, properties).geometry(shape.clone().into()).pose(pose).material(bouncy(0.0)?))
}

/// Runs a scene and adds its rows; one that says why when the run fails.
fn measure(name: &str, scene: &Scene, rows: &mut Vec<Row>) {
    match Run::of(scene, Effects::Planned) {
        Ok(Run { report, .. }) => {
            let gained = report.energy.final_j - report.energy.initial_j;
            let penetration = report.certificate.max_penetration_m;
            let unexplained = report.ledger.numerical.value().abs();
            rows.push(Row::at_most(CASE, &format!("{name}: energy gained, J"), 0.0, gained.max(0.0)));
            rows.push(Row::at_most(CASE, &format!("{name}: penetration, m"), PENETRATION_M, penetration));
            rows.push(Row::at_most(CASE, &format!("{name}: energy unexplained, J"), UNEXPLAINED_J, unexplained));
        }
        Err(error) => rows.push(Row::broken(CASE, &format!("{name}: runs"), error.to_string())),
    }
}

//! RC-10, a box that slides without friction off the edge of a table (thesis, Video 10).
//!
//! It slides flat until its centre of mass passes the edge, tips about the edge while it slides on, and leaves the
//! edge when the force there reaches zero. Default settings; times from the events.

use super::bodies::{GRAVITY, cuboid, fixed_cuboid};
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::spatial::Velocity;
use polhode::{BodySample, EventKind, Recorder, Scene, Simulation};
use std::error::Error;

/// Length, depth, height of the box, m.
const SIZE: DVec3 = DVec3::new(1.0, 0.5, 0.5);
/// When the centre of mass, which starts half a metre behind the edge at 1 m/s, passes it, s.
const TIPPING_S: f64 = 0.5;

/// Tipping, detachment, and the states 0.2 s after the one and at the other.
pub(super) fn rc_10(context: &Context) -> CaseResult {
    let mut record = Recorder::default();
    Simulation::new(&scene(1.0)?)?.run_observed(&mut record)?;
    let detached: Vec<f64> =
        record.events.iter().filter(|event| event.kind == EventKind::Detach).map(|event| event.t_s).collect();
    let (Some(&tipping), Some(&leaving)) = (detached.first(), detached.last()) else {
        return Err("no contact detaches".into());
    };
    let reference = &context.reference;
    let mut rows = vec![
        reference.row("RC-10", "time of tipping, s", tipping)?,
        reference.row("RC-10", "detachment after tipping, s", leaving - tipping)?,
        Row::exact("RC-10", "contacts that detach", 4, detached.len() as u64),
    ];
    let (end, _) = state_at(leaving)?;
    let at_leaving = OnEdge::of(&end);
    let velocity = end.velocity.linear;
    let measured = [
        at_leaving.past_edge,
        at_leaving.angle,
        end.pose.translation.x,
        end.pose.translation.z,
        velocity.x,
        velocity.z,
        at_leaving.angle_rate,
    ];
    rows.push(reference.row("RC-10", "at detachment: s, phi, x, z, vx, vz, phi'", measured)?);
    let (tipped, force) = state_at(TIPPING_S + 0.2)?;
    let on_edge = OnEdge::of(&tipped);
    let measured = [on_edge.past_edge, on_edge.angle, on_edge.past_edge_rate, on_edge.angle_rate, force];
    rows.push(reference.row("RC-10", "0.2 s after tipping: s, phi, s', phi', N/m", measured)?);
    Ok(rows)
}

pub(super) fn scene(duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let table = DVec3::new(4.0, 2.0, 1.0);
    let table_center = DVec3::new(-0.5 * table.x, 0.0, -0.5 * table.z);
    let start = DVec3::new(-TIPPING_S, 0.0, 0.5 * SIZE.z);
    let sliding = cuboid("box", SIZE, 1.0, start)?.velocity(Velocity::new(DVec3::X, DVec3::ZERO));
    Ok(Scene::builder("box off table")
        .body(fixed_cuboid("table", table, table_center)?)
        .body(sliding)
        .duration_s(duration_s)
        .build()?)
}

/// The box at a time, and the force of the edge on it, N per kg of the box.
fn state_at(time: f64) -> Result<(BodySample, f64), Box<dyn Error>> {
    let mut simulation = Simulation::new(&scene(time)?)?;
    let report = simulation.run()?;
    let acceleration = simulation.accelerations()?[1].linear;
    Ok((report.bodies[1].state, (acceleration + DVec3::Z * GRAVITY).length()))
}

/// A box on the edge at the origin.
#[derive(Debug)]
struct OnEdge {
    /// Distance of the centre of mass past the edge, along the face on it, m, and its rate.
    past_edge: f64,
    past_edge_rate: f64,
    /// Angle by which the box is tipped, rad, and its rate.
    angle: f64,
    angle_rate: f64,
}

impl OnEdge {
    fn of(sample: &BodySample) -> Self {
        let along = sample.pose.rotation.rotate(DVec3::X);
        // Tipping over the edge is a turn about +y, by which x dips.
        let (angle, angle_rate) = ((-along.z).atan2(along.x), sample.velocity.angular.y);
        let along_rate = sample.velocity.angular.cross(along);
        let center = sample.pose.translation;
        Self {
            past_edge: center.dot(along),
            past_edge_rate: sample.velocity.linear.dot(along) + center.dot(along_rate),
            angle,
            angle_rate,
        }
    }
}

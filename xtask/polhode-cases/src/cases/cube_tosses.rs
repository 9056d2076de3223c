//! Tosses of a cube onto a table, filmed by others, beside their simulation: first contact with experiment.
//!
//! The cube has edges of 104.8 mm; poses were recorded 148 times a second. Each toss is simulated from the state that
//! was measured at its first frame, with the mass, inertia, friction and restitution that the authors give for all of
//! them. What is told is the mean over frames and tosses of the distance of the centres, in edges, and of the
//! rotation between the attitudes, and how many tosses end on the face that was seen. A second run starts from the
//! state measured three frames later, before anything has touched: how far both runs part is what the measured state
//! is worth, below which no simulation of these data can be judged. Source: docs/REFERENCES.md, Pfrommer 2020;
//! docs/experiment.md.

use super::bodies::GRAVITY;
use super::{CaseResult, Context, Run};
use crate::row::{Row, Tolerance};
use glam::{DQuat, DVec3};
use polhode::contact::Shape;
use polhode::scene::Material;
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Effects, Executor, Scene};
use polhode_study::Threads;
use std::collections::BTreeMap;
use std::error::Error;
use std::fs;

const CASE: &str = "cube tosses";
/// Every fourth of the authors' 570 tosses: every tenth frame, and the states of two starts.
const FILE: &str = "fixtures/experiments/cube-tosses.csv";
/// Half of an edge of the cube, m.
const HALF_EDGE_M: f64 = 0.0524;
/// Between two frames, s.
const FRAME_S: f64 = 1.0 / 148.0;
/// Mass, kg.
const MASS_KG: f64 = 0.37;
/// Moment of inertia over the square of half an edge, kg.
const INERTIA_KG: f64 = 0.295_000_291_358_312_4;
/// Friction and restitution that the authors give.
const GIVEN: Surface = Surface { friction: 0.18, restitution: 0.125 };
/// Height of the table in the authors' frame, m: the median height of the cubes at rest, less half an edge.
const TABLE_M: f64 = -0.022 * HALF_EDGE_M;
/// Frames of the two starts.
const STARTS: [usize; 2] = [0, 3];
/// What docs/experiment.md tells is of so many digits: one toss that ends otherwise changes it by less.
const TOLD: f64 = 0.005;
const TOLD_DEGREES: f64 = 0.5;

/// Of cube and table.
#[derive(Debug, Clone, Copy)]
struct Surface {
    friction: f64,
    restitution: f64,
}

/// A frame of a toss.
#[derive(Debug, Clone, Copy)]
struct Frame {
    pose: Pose,
    /// At the starts.
    velocity: Option<Velocity>,
}

/// The frames of a toss by their numbers.
type Toss = BTreeMap<usize, Frame>;

/// How far two motions are apart, as the mean over their frames.
#[derive(Debug, Clone, Copy, Default)]
struct Apart {
    edges: f64,
    degrees: f64,
    /// Whether the same face is up at the end: 1 or 0.
    same_face: f64,
}

impl Apart {
    fn mean(all: &[Self]) -> Self {
        let mean = |value: fn(&Self) -> f64| all.iter().map(value).sum::<f64>() / all.len() as f64;
        Self { edges: mean(|own| own.edges), degrees: mean(|own| own.degrees), same_face: mean(|own| own.same_face) }
    }
}

pub(super) fn rows(context: &Context) -> CaseResult {
    let tosses = tosses(&fs::read_to_string(context.root.join(FILE))?)?;
    let told = |quantity: &str, reference: f64, value: f64, within: f64| {
        Row::compared(CASE, quantity, reference, value, Tolerance::Absolute(within))
    };
    let measured = of_all(&tosses, |toss| measured(toss, GIVEN))?;
    let starts = of_all(&tosses, two_starts)?;
    let mut rows = vec![
        Row::exact(CASE, "tosses", 143_u64, tosses.len() as u64),
        told("centre off the measured one, edges", 0.114, measured.edges, TOLD),
        told("attitude off the measured one, degrees", 14.9, measured.degrees, TOLD_DEGREES),
        told("share that ends on the measured face", 0.832, measured.same_face, 2.0 * TOLD),
        told("centres from two measured starts apart, edges", 0.047, starts.edges, TOLD),
        told("attitudes from two measured starts apart, degrees", 5.65, starts.degrees, TOLD_DEGREES),
        told("share of which both starts end on one face", 0.958, starts.same_face, 2.0 * TOLD),
    ];
    let others = [
        ("friction 0.15", Surface { friction: 0.15, ..GIVEN }, 0.207),
        ("friction 0.22", Surface { friction: 0.22, ..GIVEN }, 0.247),
        ("restitution 0", Surface { restitution: 0.0, ..GIVEN }, 0.123),
        ("restitution 0.3", Surface { restitution: 0.3, ..GIVEN }, 0.119),
    ];
    for (name, surface, reference) in others {
        let found = of_all(&tosses, |toss| self::measured(toss, surface))?;
        rows.push(told(&format!("{name}: centre off the measured one, edges"), reference, found.edges, TOLD));
    }
    Ok(rows)
}

/// The mean over all tosses.
fn of_all(
    tosses: &[Toss],
    compare: impl Fn(&Toss) -> Result<Apart, Box<dyn Error>> + Sync,
) -> Result<Apart, Box<dyn Error>> {
    let mut found: Vec<Result<Apart, String>> = tosses.iter().map(|_| Err("it was not run".to_owned())).collect();
    let compare = &compare;
    let tasks = tosses.iter().zip(&mut found).map(|(toss, place)| {
        let task = move || *place = compare(toss).map_err(|error| error.to_string());
        Box::new(task) as Box<dyn FnOnce() + Send>
    });
    Threads::of_machine().run(tasks.collect());
    Ok(Apart::mean(&found.into_iter().collect::<Result<Vec<_>, _>>()?))
}

/// The tosses of the file.
fn tosses(text: &str) -> Result<Vec<Toss>, Box<dyn Error>> {
    let mut tosses: BTreeMap<u32, Toss> = BTreeMap::new();
    for line in text.lines().skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let number = |at: usize| fields.get(at).ok_or("a field is missing")?.parse::<f64>().map_err(|e| e.to_string());
        let vector = |at: usize| Ok::<_, String>(DVec3::new(number(at)?, number(at + 1)?, number(at + 2)?));
        // Five digits of each part are no unit quaternion.
        let rotation = Rotation::renormalized(DQuat::from_xyzw(number(6)?, number(7)?, number(8)?, number(5)?));
        let is_start = fields.get(9).is_some_and(|field| !field.is_empty());
        // Rates are given about the axes of the cube.
        let velocity = || Ok::<_, String>(Velocity::new(vector(9)?, rotation.rotate(vector(12)?)));
        let velocity = if is_start { Some(velocity()?) } else { None };
        let frame = Frame { pose: Pose::new(rotation, vector(2)?), velocity };
        tosses.entry(fields[0].parse()?).or_default().insert(fields[1].parse()?, frame);
    }
    Ok(tosses.into_values().collect())
}

/// How far the run from the first start is off the measured frames.
fn measured(toss: &Toss, surface: Surface) -> Result<Apart, Box<dyn Error>> {
    let poses = simulated(toss, STARTS[0], surface)?;
    let pairs: Option<Vec<[Pose; 2]>> = toss.iter().map(|(&frame, own)| Some([*poses.get(frame)?, own.pose])).collect();
    Ok(apart(&pairs.ok_or("a frame lies beyond the last one")?))
}

/// How far the runs from both starts are apart.
fn two_starts(toss: &Toss) -> Result<Apart, Box<dyn Error>> {
    let [first, second] = STARTS.map(|start| simulated(toss, start, GIVEN));
    let pairs: Vec<[Pose; 2]> =
        first?.into_iter().skip(STARTS[1]).zip(second?).map(|(one, other)| [one, other]).collect();
    Ok(apart(&pairs))
}

fn apart(pairs: &[[Pose; 2]]) -> Apart {
    let of_pair = |[one, other]: &[Pose; 2]| Apart {
        edges: (one.translation - other.translation).length() / (2.0 * HALF_EDGE_M),
        degrees: one.rotation.angle_to(other.rotation).to_degrees(),
        same_face: 0.0,
    };
    let same_face = pairs.last().is_some_and(|[one, other]| face_up(one) == face_up(other));
    Apart { same_face: f64::from(u8::from(same_face)), ..Apart::mean(&pairs.iter().map(of_pair).collect::<Vec<_>>()) }
}

/// The axis of the cube that is nearest to the vertical, with its sign.
fn face_up(pose: &Pose) -> (usize, bool) {
    let up = pose.rotation.inverse_rotate(DVec3::Z).to_array();
    let most = (0..3).max_by(|&i, &j| up[i].abs().total_cmp(&up[j].abs())).unwrap_or(0);
    (most, up[most] > 0.0)
}

/// The poses of each frame from a start to the last one, by simulation.
fn simulated(toss: &Toss, start: usize, surface: Surface) -> Result<Vec<Pose>, Box<dyn Error>> {
    let last = *toss.keys().next_back().ok_or("a toss has no frames")?;
    let Frame { pose, velocity } = toss.get(&start).ok_or("a toss has no such start")?;
    let material = Material::new("both").with_friction(surface.friction)?.with_restitution(surface.restitution)?;
    let moments = Inertia::from_diagonal(DVec3::splat(INERTIA_KG * HALF_EDGE_M * HALF_EDGE_M))?;
    let properties = MassProperties::new(Mass::new(MASS_KG)?, DVec3::ZERO, moments);
    let shape = Shape::cuboid(DVec3::splat(2.0 * HALF_EDGE_M))?;
    let table = Shape::half_space(UnitVector::Z);
    let scene = Scene::builder("toss")
        .gravity(DVec3::Z * -GRAVITY)
        .duration_s((last - start) as f64 * FRAME_S)
        .output_interval_s(FRAME_S)
        .body(
            Body::movable("cube", properties)
                .geometry(shape.into())
                .pose(*pose)
                .velocity(velocity.ok_or("a start has no velocity")?)
                .material(material.clone()),
        )
        .body(
            Body::fixed("table")
                .geometry(table.into())
                .pose(Pose::from_translation(DVec3::Z * TABLE_M))
                .material(material),
        )
        .build()?;
    let run = Run::of(&scene, Effects::Planned)?;
    let poses: Vec<Pose> = run.record.samples.iter().filter_map(|sample| Some(sample.first()?.pose)).collect();
    if poses.len() == last - start + 1 { Ok(poses) } else { Err(format!("{} frames", poses.len()).into()) }
}

//! The cases of resting contact (RC-01 to RC-17) by every way that takes them: the thesis's methods of contact forces,
//! time steps, micro-collisions, springs, sequential impulses.
//!
//! Methods of forces are judged by accelerations at the start, against those of the exact solver, which has the
//! rational values as its reference. Ways without forces at the start (micro-collisions, springs) are judged by motion:
//! what stands stands, what falls or slides is where the exact motion is.

use super::bodies::{GRAVITY, ball_on_x, cuboid, half_space};
use super::diamonds::{Sides, diamond};
use super::resting_contact::{beam, unit_problem};
use super::run::Run;
use super::stacks::{overhang, staircase};
use super::ways::{Claims, FORCES, REST_DEPTH_M, TIERS, Way, compared, larger};
use super::{CaseResult, Context, table_edge};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::contact::{ConvexPolyhedron, Shape};
use polhode::response::{SolverSettings, guesses};
use polhode::scene::{ImpactLaw, Tier};
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Effects, ErrorEstimation, Scene, Simulation};
use std::error::Error;
use std::f64::consts::{FRAC_PI_3, FRAC_PI_6};

const CASE: &str = "rest by every way";

/// Forces of methods that solve, of 1 or the largest number.
const FORCES_FOUND: Claims = Claims { exact: 1e-9, pulse: 1e-9, micro: 1e-9, springs: 1e-9, fast: 1e-9, thesis: 1e-9 };
/// Motions of some tenths of a second: fixed steps err in proportion to them; springs by how far they give way.
const MOTION: Claims = Claims { exact: 1e-3, pulse: 1e-3, micro: 1e-2, springs: 1e-2, fast: 2e-2, thesis: 1e-2 };
/// How far what stands moves, m: the envelope of micro-collisions and what soft contacts sag; a fixed step falls once.
const STANDS: Claims =
    Claims { exact: 1e-9, pulse: 1e-9, micro: 1e-3, springs: REST_DEPTH_M, fast: 1e-2, thesis: 1e-3 };
/// Forces that settle in the course of a run, relative.
const SETTLED: Claims = Claims { exact: 1e-9, pulse: 1e-9, micro: 5e-2, springs: 1e-2, fast: 5e-2, thesis: 1e-6 };

/// The exact way.
const EXACT: Way = Way::Law(ImpactLaw::Reflection, polhode::response::impact::PulseExponent::Hertz);

/// What takes springs more steps than a check may take: bodies 1000 times as heavy on springs of light ones.
const MANY_STEPS: &str = "1000 times";

/// How far from its balance a stack is set, m.
const BESIDE_M: f64 = 1e-6;
/// Accelerations of the exact solver are those of the reference to this, relative: sums over a pile.
const OF_PILES: f64 = 1e-10;
/// Times of motions under error control are those of the reference to this, relative.
const OF_TIMES: f64 = 1e-9;
/// Five steps, s: forces of the thesis's methods are there from the first.
const FEW_STEPS_S: f64 = 5e-4;

/// An acceleration that is none, m/s^2.
const NONE: f64 = 1e-6;

type Found = Result<Vec<f64>, Box<dyn Error>>;

/// All rows.
pub(super) fn rows(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    equilibria(&mut rows)?;
    accelerations_at_start(&mut rows)?;
    standing(&mut rows)?;
    counterexamples(context, &mut rows)?;
    motions(&mut rows)?;
    leaving(&mut rows)?;
    forces(&mut rows)?;
    held_by_walls(context, &mut rows)?;
    Ok(rows)
}

/// Accelerations of all bodies at the start, m/s^2 and rad/s^2.
fn accelerations(way: Way, scene: Scene) -> Found {
    let all = Simulation::new(&way.at_rest(scene))?.accelerations()?;
    Ok(all.iter().flat_map(|a| [a.linear, a.angular]).flat_map(|v| v.to_array()).collect())
}

/// The same of a way that may refuse: none where there are too many contacts to guess.
fn unless_too_many(found: Found) -> Option<Found> {
    match found {
        Err(error) if error.to_string().contains("accepted for at most 20") => None,
        other => Some(other),
    }
}

/// Whether the forces of a way hold a scene: a row, where it takes the scene.
fn holds(way: Way, quantity: &str, stands: bool, scene: Scene) -> Result<Option<Row>, Box<dyn Error>> {
    let Some(found) = unless_too_many(accelerations(way, scene)) else { return Ok(None) };
    Ok(Some(Row::exact(CASE, &format!("{quantity} stands: {}", way.name()), stands, largest(&found?) < NONE)))
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most, number| larger(most, number.abs()))
}

/// RC-01 and RC-05: whether the forces of the thesis's methods let stand what stands, and fall what falls. Guesses are
/// made for up to 20 contacts: the 2-diamond, four bricks.
fn equilibria(rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    for way in FORCES {
        for m in 1..=5 {
            rows.extend(holds(way, &format!("RC-01, {m}-diamond"), m < 5, diamond(m, Sides::Collide, 1.0)?)?);
        }
        let apart = diamond(2, Sides::Ignored, 1.0)?;
        rows.extend(holds(way, "RC-01, 2-diamond without sides (video 12)", true, apart)?);
        for n in [1, 2, 3, 4] {
            for (offset, stands) in [(-BESIDE_M, true), (0.0, true), (BESIDE_M, false)] {
                let quantity = format!("RC-05, n={n}, offset {offset:e} m");
                rows.extend(holds(way, &quantity, stands, overhang(n, offset)?)?);
            }
        }
    }
    Ok(())
}

/// RC-02 to RC-04, RC-06, RC-07, RC-13: accelerations at the start, against those of the exact solver.
fn accelerations_at_start(rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    let six = accelerations(EXACT, diamond(6, Sides::Ignored, 1.0)?)?;
    let power: f64 = six.chunks(6).map(|body| -GRAVITY * body[2]).sum();
    rows.push(Row::compared(
        CASE,
        "RC-04: sum of m g.a, W/s",
        103.833_150_442_379_42,
        power,
        Tolerance::Relative(OF_PILES),
    ));
    let scenes = [
        ("RC-02, 5-diamond without sides", diamond(5, Sides::Ignored, 1.0)?),
        ("RC-03, 5-diamond", diamond(5, Sides::Collide, 1.0)?),
        ("RC-04, 6-diamond without sides", diamond(6, Sides::Ignored, 1.0)?),
        ("RC-06, staircase s=0.3, n=4", staircase(0.3, 4)?),
        ("RC-06, staircase s=0.4, n=5", staircase(0.4, 5)?),
        ("RC-07, beam on pillars", beam()?),
        ("RC-13, block on a wedge", wedge()?),
    ];
    for (name, scene) in scenes {
        let expected = accelerations(EXACT, scene.clone())?;
        for way in FORCES {
            let Some(found) = unless_too_many(accelerations(way, scene.clone())) else { continue };
            rows.push(compared(CASE, &format!("{name}: accelerations"), (way, &FORCES_FOUND), found, &expected));
        }
    }
    let found = accelerations(EXACT, wedge()?)?;
    let (wedge, block) = (DVec3::from_slice(&found[6..]), DVec3::from_slice(&found[12..]));
    let reference = [1.307_032_186_326_975_8, 6.036_923_076_923_077];
    let measured = [wedge.length(), (block - wedge).length()];
    rows.push(Row::compared(
        CASE,
        "RC-13: accelerations of the wedge, of the block on it, m/s^2",
        reference,
        measured,
        Tolerance::Relative(OF_PILES),
    ));
    Ok(())
}

/// RC-13: a block of 1 kg on a wedge of 3 kg and 30 degrees.
fn wedge() -> Result<Scene, Box<dyn Error>> {
    let (length, depth) = (2.0, 1.0);
    let height = length * FRAC_PI_6.tan();
    let corners = [(0.0, 0.0), (length, 0.0), (0.0, height)];
    let points =
        [-0.5 * depth, 0.5 * depth].into_iter().flat_map(|y| corners.map(|(x, z)| DVec3::new(x, y, z))).collect();
    let faces = vec![vec![0, 1, 2], vec![3, 5, 4], vec![0, 3, 4, 1], vec![1, 4, 5, 2], vec![2, 5, 3, 0]];
    let shape = Shape::convex(ConvexPolyhedron::from_faces(points, faces)?);
    let center = DVec3::new(length / 3.0, 0.0, height / 3.0);
    let properties = MassProperties::new(Mass::new(3.0)?, center, Inertia::from_diagonal(DVec3::ONE)?);
    let slope = Rotation::from_rotation_vector(DVec3::Y * FRAC_PI_6);
    let size = 0.2;
    let foot = DVec3::new(0.4 * length, 0.0, 0.6 * height);
    let block = cuboid("block", DVec3::splat(size), 1.0, DVec3::ZERO)?;
    Ok(Scene::builder("wedge")
        .body(half_space("floor", UnitVector::Z))
        .body(Body::movable("wedge", properties).geometry(shape.into()))
        .body(block.pose(Pose::new(slope, foot + slope.rotate(DVec3::Z * (0.5 * size)))))
        .duration_s(0.1)
        .build()?)
}

/// RC-01, RC-07, RC-15: what stands stands by the ways that hold it by motion.
fn standing(rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    /// s.
    const DURATION_S: f64 = 0.2;
    for way in TIERS.into_iter().filter(|way| *way != Way::Of(Tier::Thesis)) {
        let scenes = [
            ("RC-01, 2-diamond", diamond(2, Sides::Collide, DURATION_S)?),
            ("RC-05, overhang of 3, 1 cm inside", overhang(3, -0.01)?.with_duration(DURATION_S)?),
            ("RC-07, beam on pillars", beam()?.with_duration(DURATION_S)?),
            ("RC-15, four cubes, the top 1000 times as heavy", cubes(DURATION_S)?),
        ];
        for (name, scene) in
            scenes.into_iter().filter(|(name, _)| way != Way::Of(Tier::Penalty) || !name.contains(MANY_STEPS))
        {
            let found = Run::of(&way.at_rest(scene), Effects::Planned).map(|run| vec![run.largest_movement_m()]);
            rows.push(compared(CASE, &format!("{name}: movement, m"), (way, &STANDS), found, &[0.0]));
        }
    }
    Ok(())
}

/// RC-15: cubes of 1 kg, the top one of 1000 kg.
fn cubes(duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let mut scene = Scene::builder("cubes").duration_s(duration_s).body(half_space("floor", UnitVector::Z));
    for level in 0..4 {
        let mass = if level == 3 { 1e3 } else { 1.0 };
        let center = DVec3::Z * (f64::from(level) + 0.5);
        scene = scene.body(cuboid(&format!("cube {level}"), DVec3::ONE, mass, center)?);
    }
    Ok(scene.build()?)
}

/// RC-08 and RC-09: guesses find what the heuristic does not.
fn counterexamples(context: &Context, rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    let plate = [[1.0, 4.0, -1.5], [1.0, 0.0, 0.5], [1.0, 3.0, 1.0]];
    let beam = [[1.0, 0.5, 0.0], [1.0, 2.0, 0.0]];
    for (case, problem, forces) in
        [("RC-08", unit_problem(&beam)?, "forces, m g"), ("RC-09", unit_problem(&plate)?, "forces")]
    {
        let b = vec![-1.0; problem.len()];
        let found = guesses(&problem.delassus(), &b, &SolverSettings::default())?;
        let mut row = context.reference.row(case, forces, found.forces)?;
        (row.case, row.quantity) = (CASE.to_owned(), format!("{case}: {forces}: guesses"));
        rows.push(row);
    }
    Ok(())
}

/// RC-10 to RC-12: a box off a table, a ladder, a rod on its end, without friction: where they are after a while, as by
/// the exact tier, whose own cases have the references.
fn motions(rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    let scenes = [
        ("RC-10, box off a table, 0.85 s", table_edge::scene(0.85)?),
        ("RC-11, ladder, 0.6 s", ladder(0.6)?),
        ("RC-12, rod on its end, 0.75 s", rod(0.75)?),
        ("RC-13, block on a wedge, 0.1 s", wedge()?),
    ];
    let ends = |way: Way, scene: Scene| -> Found {
        let run = Run::of(&way.at_rest(scene), Effects::Planned)?;
        let states = run.report.bodies.iter().map(|body| body.state);
        Ok(states
            .flat_map(|state| state.pose.translation.to_array().into_iter().chain(state.velocity.linear.to_array()))
            .collect())
    };
    for (name, scene) in scenes {
        let expected = ends(EXACT, scene.clone())?;
        for way in TIERS.into_iter().chain(FORCES[..2].iter().copied()) {
            rows.push(compared(CASE, name, (way, &MOTION), ends(way, scene.clone()), &expected));
        }
    }
    let run = Run::of(&EXACT.at_rest(rod(0.9)?), Effects::Planned)?;
    let landing = run.events(polhode::EventKind::Impact).first().map_or(f64::NAN, |event| event.t_s);
    rows.push(Row::compared(
        CASE,
        "RC-12: time to hit the floor, s",
        0.811_130_469_236_935_4,
        landing,
        Tolerance::Relative(OF_TIMES),
    ));
    Ok(())
}

/// RC-11: a rod of 2 m and 1 kg against a wall, 60 degrees from the floor.
fn ladder(duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let along = DVec3::new(-FRAC_PI_3.cos(), 0.0, FRAC_PI_3.sin());
    let scene =
        Scene::builder("ladder").body(half_space("floor", UnitVector::Z)).body(half_space("wall", UnitVector::X));
    Ok(scene.body(thin_rod(2.0, along, DVec3::new(-along.x, 0.0, along.z))?).duration_s(duration_s).build()?)
}

/// RC-12: a rod of 1 m, a degree from the vertical.
fn rod(duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let tilt = 1f64.to_radians();
    let along = DVec3::new(tilt.sin(), 0.0, tilt.cos());
    let scene = Scene::builder("rod").body(half_space("floor", UnitVector::Z));
    Ok(scene.body(thin_rod(1.0, along, DVec3::Z * (0.5 * tilt.cos()))?).duration_s(duration_s).build()?)
}

/// A uniform rod of 1 kg that touches with its ends.
fn thin_rod(length: f64, along: DVec3, center: DVec3) -> Result<Body, Box<dyn Error>> {
    /// Moment about its axis, of the others: small, and no rod is without.
    const AXIAL: f64 = 1e-3;
    let moment = length * length / 12.0;
    let inertia = Inertia::from_diagonal(DVec3::new(moment, moment, AXIAL * moment))?;
    let end = DVec3::Z * (0.5 * length);
    let turn = Rotation::renormalized(glam::DQuat::from_rotation_arc(DVec3::Z, along));
    let rod = Body::movable("rod", MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, inertia));
    Ok(rod.geometry(Shape::points(vec![-end, end])?.into()).pose(Pose::new(turn, center)))
}

/// RC-11 and RC-14: velocities along the floor of what has left its support.
fn leaving(rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    // A small ball slides off a sphere: it leaves where cos = 2/3, at v^2 = 2 g R/3, and keeps v cos.
    let reach = 1.1;
    let start = 0.2f64;
    let speed = (2.0 * GRAVITY * reach * (1.0 - start.cos())).sqrt();
    let sphere = Scene::builder("off a sphere")
        .body(Body::fixed("sphere").geometry(Shape::sphere(1.0)?.into()))
        .body(
            ball_on_x("ball", 0.1, 1.0, 0.0, 0.0)?
                .pose(Pose::from_translation(DVec3::new(start.sin(), 0.0, start.cos()) * reach))
                .velocity(Velocity::new(DVec3::new(start.cos(), 0.0, -start.sin()) * speed, DVec3::ZERO)),
        )
        .duration_s(0.65)
        .build()?;
    let kept = (2.0 * GRAVITY * reach / 3.0).sqrt() * 2.0 / 3.0;
    for (name, scene, body, expected) in [
        ("RC-11, ladder: velocity that it keeps, m/s", ladder(0.6)?, "rod", 1.189_937_618_191_624_8),
        ("RC-14, ball off a sphere: velocity that it keeps, m/s", sphere, "ball", kept),
    ] {
        for way in [EXACT].into_iter().chain(TIERS) {
            let run = Run::of(&way.at_rest(scene.clone()), Effects::Planned);
            let found = run.and_then(|run| Ok(vec![run.last(body)?.velocity.linear.x]));
            rows.push(compared(CASE, name, (way, &MOTION), found, &[expected]));
        }
    }
    Ok(())
}

/// RC-07, RC-15, RC-17: sums of forces that hold bodies, after 0.1 s (springs: 0.3 s, until they have settled),
/// relative to the weight.
fn forces(rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    for way in TIERS.into_iter().chain(FORCES).chain([EXACT]) {
        // Those that are struck, or held, anew each step are there from the first; springs settle.
        let duration_s = match way {
            Way::Of(Tier::Penalty) => 0.3,
            Way::Forces(_) => FEW_STEPS_S,
            _ => 0.1,
        };
        let at_end = |scene: Scene| -> Result<Vec<polhode::ContactView>, Box<dyn Error>> {
            let mut simulation = Simulation::new(&way.at_rest(scene))?.estimating(ErrorEstimation::Off);
            simulation.advance_to(duration_s)?;
            simulation.accelerations()?;
            Ok(simulation.contacts())
        };
        let long = 2.0 * duration_s;
        let sum = at_end(beam()?.with_duration(long)?)
            .map(|all| vec![all.iter().map(|one| one.normal_force_n).sum::<f64>() / GRAVITY]);
        rows.push(compared(CASE, "RC-07, beam on pillars: sum of forces / weight", (way, &SETTLED), sum, &[1.0]));
        if way != Way::Of(Tier::Penalty) {
            let below = at_end(cubes(long)?).map(|all| {
                let load = |low: usize| -> f64 {
                    let pair = all.iter().filter(|one| one.body_a.index().min(one.body_b.index()) == low);
                    pair.map(|one| one.normal_force_n).sum::<f64>() / (1e3 * GRAVITY)
                };
                vec![load(3), load(2), load(1), load(0)]
            });
            rows.push(compared(
                CASE,
                "RC-15, cubes: forces / weight of the top",
                (way, &SETTLED),
                below,
                &[1.0, 1.001, 1.002, 1.003],
            ));
        }
        let legs = at_end(table(long)?).map(|all| {
            let weight = 100.0;
            let moment =
                |of: fn(DVec3) -> f64| all.iter().map(|one| of(one.point_m) * one.normal_force_n).sum::<f64>() / weight;
            vec![moment(|_| 1.0), moment(|p| p.x), moment(|p| p.y)]
        });
        rows.push(compared(CASE, "RC-17, table: force and moments / weight", (way, &SETTLED), legs, &[1.0, 0.2, 0.1]));
    }
    Ok(())
}

/// RC-17: a table of four legs at (+-1, +-1) m, its centre of mass at (0.2, 0.1) m, weight 100 N.
fn table(duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let mass = 100.0 / GRAVITY;
    let feet = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
    let center = DVec3::new(0.2, 0.1, 0.5);
    let properties = MassProperties::new(Mass::new(mass)?, center, Inertia::from_diagonal(DVec3::splat(mass))?);
    let table = Body::movable("table", properties).geometry(Shape::points(feet)?.into());
    Ok(Scene::builder("table").body(half_space("floor", UnitVector::Z)).body(table).duration_s(duration_s).build()?)
}

/// RC-16: forces on a ball on two equal ones that walls hold, all without friction, after 0.1 s (springs: 0.3 s). The
/// force between the lower two is free: what the wall bears beyond it is not.
fn held_by_walls(context: &Context, rows: &mut Vec<Row>) -> Result<(), Box<dyn Error>> {
    let of_one = context.reference.numbers("RC-16", "N_upper, wall - mutual, floor, W")?;
    let expected: Vec<f64> = of_one.iter().flat_map(|force| [*force; 2]).collect();
    for way in TIERS.into_iter().chain(FORCES).chain([EXACT]) {
        let duration_s = match way {
            Way::Of(Tier::Penalty) => 0.3,
            Way::Forces(_) => FEW_STEPS_S,
            _ => 0.1,
        };
        let found = balls_between_walls(2.0 * duration_s).and_then(|scene| {
            let mut simulation = Simulation::new(&way.at_rest(scene))?.estimating(ErrorEstimation::Off);
            simulation.advance_to(duration_s)?;
            simulation.accelerations()?;
            let contacts = simulation.contacts();
            let between = |a: &str, b: &str| -> Result<f64, Box<dyn Error>> {
                let of = |name: &str| simulation.body_id(name).ok_or_else(|| format!("no body {name}"));
                let (a, b) = (of(a)?, of(b)?);
                let own = contacts.iter().filter(|one| [(a, b), (b, a)].contains(&(one.body_a, one.body_b)));
                Ok(own.map(|one| one.normal_force_n).sum::<f64>() / GRAVITY)
            };
            let mutual = between("left", "right")?;
            Ok(vec![
                between("upper", "left")?,
                between("upper", "right")?,
                between("left", "left wall")? - mutual,
                between("right", "right wall")? - mutual,
                between("left", "floor")?,
                between("right", "floor")?,
            ])
        });
        rows.push(compared(CASE, "RC-16, balls between walls: forces / weight", (way, &SETTLED), found, &expected));
    }
    Ok(())
}

/// RC-16: balls of 1 m radius and 1 kg, two on the floor that touch each other and a wall each, one on both.
fn balls_between_walls(duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let ball = |name: &str, x: f64, z: f64| -> Result<Body, Box<dyn Error>> {
        Ok(ball_on_x(name, 1.0, 1.0, 0.0, 0.0)?.pose(Pose::from_translation(DVec3::new(x, 0.0, z))))
    };
    let right_wall = half_space("right wall", -UnitVector::X).pose(Pose::from_translation(DVec3::X * 2.0));
    Ok(Scene::builder("balls between walls")
        .duration_s(duration_s)
        .body(half_space("floor", UnitVector::Z))
        .body(half_space("left wall", UnitVector::X).pose(Pose::from_translation(-DVec3::X * 2.0)))
        .body(right_wall)
        .body(ball("left", -1.0, 1.0)?)
        .body(ball("right", 1.0, 1.0)?)
        .body(ball("upper", 0.0, 1.0 + 3f64.sqrt())?)
        .build()?)
}

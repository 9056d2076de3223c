//! Bodies that slide over the seams of flush surfaces.
//!
//! Nothing stands out of the plane in which fixed boxes lie side by side, so that a body that slides over them without
//! friction keeps its velocity, whatever its shape, its speed and the direction in which it crosses the seams. The same
//! holds where the boxes are parts of one body, where one of them is let into a half-space, and where they may move.
//! With friction the body moves as on one large plate. Gaps of 1e-9 m and steps of 1e-12 m do not matter to a body of a
//! tenth of a metre; a step of a hundredth of its size trips it.

use super::ways::larger;
use super::{Amount, CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::contact::{ConvexPolyhedron, Shape};
use polhode::scene::Material;
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, ErrorEstimation, Outcome, Scene, Simulation};
use std::error::Error;
use std::f64::consts::FRAC_PI_2;

const CASE: &str = "seams";

/// Relative change of the velocity that is accepted.
const KEPT: f64 = 1e-12;

/// Difference from the motion on one plate that is accepted with friction, m and m/s: the error of the steps.
const AS_ON_PLATE: f64 = 1e-9;

/// Bodies lower than this have a touch distance below the step that others do not notice, m.
const SMALL: f64 = 0.005;

/// Length, width and thickness of a tile, m.
const TILE: DVec3 = DVec3::new(0.2, 16.0, 0.1);

/// Directions in which seams are crossed, rad from their normal.
const ANGLES: [f64; 6] = [0.0, 0.1, 0.3, 0.5, 0.8, 1.0];

/// A body that slides.
struct Slider {
    name: &'static str,
    shape: Shape,
    turn: DVec3,
    /// Of its centre of mass above the plane, m.
    height: f64,
}

fn sliders() -> Result<Vec<Slider>, Box<dyn Error>> {
    let corners = (0..6).map(|k| f64::from(k) * std::f64::consts::FRAC_PI_3);
    let points: Vec<DVec3> = corners
        .flat_map(|angle| [-0.03, 0.03].map(|z| DVec3::new(0.05 * libm::cos(angle), 0.05 * libm::sin(angle), z)))
        .collect();
    let flat = |name, shape, height| Slider { name, shape, turn: DVec3::ZERO, height };
    let on_side = |name, shape, height| Slider { name, shape, turn: DVec3::X * FRAC_PI_2, height };
    Ok(vec![
        flat("ball", Shape::sphere(0.05)?, 0.05),
        flat("small ball", Shape::sphere(0.001)?, 0.001),
        flat("box", Shape::cuboid(DVec3::splat(0.1))?, 0.05),
        flat("prism", Shape::convex(ConvexPolyhedron::from_points(&points)?), 0.03),
        flat("puck", Shape::cylinder(0.05, 0.05)?, 0.025),
        flat("cone", Shape::cone(0.05, 0.08)?, 0.02),
        flat("ring", Shape::torus(0.04, 0.01)?, 0.01),
        on_side("roller", Shape::cylinder(0.05, 0.1)?, 0.05),
        on_side("capsule", Shape::capsule(0.03, 0.1)?, 0.03),
        on_side("wheel", Shape::torus(0.04, 0.01)?, 0.05),
    ])
}

impl Slider {
    /// Sliding from a place on the plane at a velocity.
    fn body(&self, place: DVec3, velocity: DVec3) -> Result<Body, Box<dyn Error>> {
        let inertia = Inertia::from_diagonal(DVec3::splat(0.4 * self.height * self.height))?;
        let pose = Pose::new(Rotation::from_rotation_vector(self.turn), place + DVec3::Z * self.height);
        Ok(Body::movable("slider", MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, inertia))
            .geometry(self.shape.clone().into())
            .pose(pose)
            .velocity(Velocity::new(velocity, DVec3::ZERO)))
    }
}

/// A row of tiles along x, the first one at the origin.
#[derive(Clone, Copy)]
struct Tiles {
    count: u32,
    gap: f64,
    step: f64,
}

impl Tiles {
    fn center(&self, k: u32) -> DVec3 {
        let k = f64::from(k);
        DVec3::new((k + 0.5) * TILE.x + k * self.gap, 0.0, k * self.step - 0.5 * TILE.z)
    }

    fn bodies(&self) -> Result<Vec<Body>, Box<dyn Error>> {
        let tile = |k: u32| -> Result<Body, Box<dyn Error>> {
            let shape = Shape::cuboid(TILE)?;
            let pose = Pose::from_translation(self.center(k));
            Ok(Body::fixed(format!("tile {k}")).geometry(shape.into()).pose(pose))
        };
        (0..self.count).map(tile).collect()
    }

    /// From the middle of the first tile to the middle of the last one, m.
    fn way(&self) -> f64 {
        f64::from(self.count - 1) * TILE.x
    }
}

/// A slider that crosses some bodies, the last body of the scene.
fn crossing(under: Vec<Body>, slider: &Slider, velocity: DVec3, way: f64) -> Result<Scene, Box<dyn Error>> {
    let across = 0.5 * way * velocity.y / velocity.x;
    let start = DVec3::new(0.5 * TILE.x, -across, 0.0);
    let mut scene = Scene::builder("seams").duration_s(way / velocity.x);
    for body in under {
        scene = scene.body(body);
    }
    Ok(scene.body(slider.body(start, velocity)?).build()?)
}

/// Every slider over six tiles, across their seams at an angle: it keeps its velocity and its attitude.
pub(crate) fn crossings() -> Result<Vec<(&'static str, Scene)>, Box<dyn Error>> {
    let laid = Tiles { count: 6, gap: 0.0, step: 0.0 };
    let crossing = |slider: Slider| Ok((slider.name, crossing(laid.bodies()?, &slider, CROSSING, laid.way())?));
    sliders()?.into_iter().map(crossing).collect()
}

/// Velocity of those sliders, m/s.
const CROSSING: DVec3 = DVec3::new(1.0, 0.3, 0.0);

/// The relative change of the velocity of a slider over some bodies; infinite where the run is degraded.
fn change(under: Vec<Body>, slider: &Slider, velocity: DVec3, way: f64) -> Result<f64, Box<dyn Error>> {
    let scene = crossing(under, slider, velocity, way)?;
    let report = Simulation::new(&scene)?.run()?;
    let end = report.bodies.last().ok_or("no body")?.state.velocity.linear;
    let is_kept = report.outcome == Outcome::Completed;
    Ok(if is_kept { (end - velocity).length() / velocity.length() } else { f64::INFINITY })
}

/// The largest change over some directions of the crossing.
fn largest(laid: Tiles, slider: &Slider, speed: f64, angles: &[f64]) -> Result<f64, Box<dyn Error>> {
    let mut most: f64 = 0.0;
    for &angle in angles {
        let velocity = DVec3::new(libm::cos(angle), libm::sin(angle), 0.0) * speed;
        most = most.max(change(laid.bodies()?, slider, velocity, laid.way())?);
    }
    Ok(most)
}

/// Gaps and steps between tiles (m): none, far below the size at which a step trips, and at it.
const GAPS_AND_STEPS: [(f64, f64); 5] = [(0.0, 0.0), (1e-12, 0.0), (1e-9, 0.0), (0.0, 1e-12), (1e-9, 1e-12)];

/// A way over the tiles.
#[derive(Clone, Copy, PartialEq)]
struct Way {
    gap: f64,
    step: f64,
    speed: f64,
}

/// Ways of the full count on which a body does not keep its velocity, m and m/s: a gap of 1e-9 m, a step of 1e-12 m, or
/// both take from it what no user sees. Each body has one row for all of its own; on every other way it has a row of
/// its own.
const KNOWN_WAYS: [(&str, &[Way]); 5] = [
    ("box", &[Way::over(1e-9, 0.0, 0.1), BEHIND_GAP[0], BEHIND_GAP[1], BEHIND_GAP[2]]),
    ("prism", &[Way::over(1e-9, 0.0, 0.1), Way::over(0.0, 1e-12, 0.1)]),
    ("puck", &[Way::over(1e-9, 0.0, 0.1), Way::over(1e-9, 0.0, 1.0), BEHIND_GAP[0], BEHIND_GAP[1], BEHIND_GAP[2]]),
    ("cone", &[Way::over(1e-9, 0.0, 0.1), BEHIND_GAP[0], BEHIND_GAP[1], BEHIND_GAP[2]]),
    ("wheel", &[Way::over(1e-9, 0.0, 1.0), Way::over(0.0, 1e-12, 1.0), BEHIND_GAP[1]]),
];
/// Over a step behind a gap, at each speed of the full count.
const BEHIND_GAP: [Way; 3] = [Way::over(1e-9, 1e-12, 0.1), Way::over(1e-9, 1e-12, 1.0), Way::over(1e-9, 1e-12, 10.0)];

impl Way {
    const fn over(gap: f64, step: f64, speed: f64) -> Self {
        Self { gap, step, speed }
    }

    fn is_known(&self, slider: &Slider) -> bool {
        KNOWN_WAYS.iter().any(|(name, ways)| *name == slider.name && ways.contains(self))
    }
}

/// Radii of balls, and steps above their touch distances, m.
const HIGH_STEPS: [(f64, f64); 5] = [(0.02, 2e-12), (0.05, 2e-12), (0.05, 1e-10), (0.05, 1e-8), (0.05, 1e-6)];

/// Relative change of the velocity that shows that a body has tripped (no unit, 1e-6 to 1e-1).
const TRIPPED: f64 = 1e-3;

/// Fixed tiles, with gaps and steps.
pub(super) fn tiles(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    let is_full = context.amount == Amount::Full;
    let tiles = if is_full { 20 } else { 3 };
    let (speeds, angles): (&[f64], &[f64]) =
        if is_full { (&[0.1, 1.0, 10.0], &ANGLES) } else { (&[1.0], &ANGLES[2..3]) };
    for slider in sliders()? {
        let mut on_known_ways: Option<f64> = None;
        for &speed in speeds {
            // A wheel on its rim falls over in the ten seconds and more that a slow one takes.
            if slider.name == "wheel" && speed < 1.0 {
                continue;
            }
            for (gap, step) in GAPS_AND_STEPS {
                if !is_full && gap > 0.0 && step > 0.0 {
                    continue;
                }
                // The step is higher than the touch distance of a ball of 1 mm: a row of its own has what it takes.
                if slider.height < SMALL && step > 0.0 {
                    continue;
                }
                let change = largest(Tiles { count: tiles, gap, step }, &slider, speed, angles);
                if let (true, true, Ok(change)) = (is_full, Way { gap, step, speed }.is_known(&slider), &change) {
                    on_known_ways = Some(on_known_ways.map_or(*change, |most| larger(most, *change)));
                    continue;
                }
                let quantity = format!("{}, step {step:e} m, gap {gap:e} m, {speed} m/s, {tiles} tiles", slider.name);
                rows.push(match change {
                    Ok(change) => Row::at_most(CASE, &quantity, KEPT, change),
                    Err(error) => Row::broken(CASE, &quantity, error.to_string()),
                });
            }
        }
        if let Some(change) = on_known_ways {
            let quantity = format!("{}: its known ways over gaps and steps, {tiles} tiles", slider.name);
            rows.push(Row::at_most(CASE, &quantity, KEPT, change));
        }
        let high = Tiles { count: 2, gap: 0.0, step: 0.02 * slider.height };
        let trips = change(high.bodies()?, &slider, DVec3::X, high.way())? > TRIPPED;
        rows.push(Row::exact(CASE, &format!("{} trips over a real step", slider.name), "yes", word(trips)));
    }
    Ok(rows)
}

/// What steps that are really there take from a ball that hits them without restitution: at each one the velocity
/// along the normal of the contact, `v sin^2 = v (1 - (1 - h/r)^2)` with the height `h` of the step and the radius `r`.
pub(super) fn steps(_: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for (radius, step) in HIGH_STEPS {
        let ball = Slider { name: "ball", shape: Shape::sphere(radius)?, turn: DVec3::ZERO, height: radius };
        let laid = Tiles { count: 2, gap: 0.0, step };
        let cosine = 1.0 - step / radius;
        let lost = change(laid.bodies()?, &ball, DVec3::X, laid.way())?;
        let quantity = format!("ball of {radius} m over a step of {step:e} m: error of the loss of velocity");
        rows.push(Row::at_most(CASE, &quantity, KEPT, (lost - (1.0 - cosine * cosine)).abs()));
    }
    Ok(rows)
}

const fn word(is_so: bool) -> &'static str {
    if is_so { "yes" } else { "no" }
}

/// Other surfaces: a box let into a half-space, parts of one body, boxes that may move.
pub(super) fn surfaces(_: &Context) -> CaseResult {
    let mut rows = Vec::new();
    let laid = Tiles { count: 3, gap: 0.0, step: 0.0 };
    let tile = Shape::cuboid(TILE)?;
    let placed = |k: u32| tile.placed(&Pose::from_translation(laid.center(k)));
    let parts: Vec<Shape> = (0..laid.count).map(placed).collect::<Result<_, _>>()?;
    let floor = || Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into());
    let below = || floor().pose(Pose::from_translation(DVec3::Z * -TILE.z));
    let brick = |k: u32| -> Result<Body, Box<dyn Error>> {
        let inertia = Inertia::from_diagonal(DVec3::new(22.0, 1.0, 22.0))?;
        Ok(Body::movable(format!("brick {k}"), MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, inertia))
            .geometry(tile.clone().into())
            .pose(Pose::from_translation(laid.center(k))))
    };
    let velocity = DVec3::new(1.0, 0.3, 0.0);
    for slider in sliders()? {
        let mut add = |what: &str, under: Vec<Body>| {
            let quantity = format!("{} over {what}", slider.name);
            rows.push(match change(under, &slider, velocity, laid.way()) {
                Ok(change) => Row::at_most(CASE, &quantity, KEPT, change),
                Err(error) => Row::broken(CASE, &quantity, error.to_string()),
            });
        };
        let mut inlaid = laid.bodies()?;
        inlaid.remove(0);
        inlaid.pop();
        inlaid.push(floor());
        add("a box in a half-space", inlaid);
        add("parts of a body", vec![Body::fixed("parts").geometry(Shape::compound(parts.clone())?.into())]);
        add("bricks that may move", vec![below(), brick(0)?, brick(1)?, brick(2)?]);
    }
    Ok(rows)
}

/// With friction: the motion is that on one plate.
pub(super) fn friction(_: &Context) -> CaseResult {
    let mut rows = Vec::new();
    let laid = Tiles { count: 4, gap: 0.0, step: 0.0 };
    let rough = Material::new("rough").with_friction(0.1)?;
    let size = DVec3::new(f64::from(laid.count) * TILE.x, TILE.y, TILE.z);
    let plate = Body::fixed("plate").geometry(Shape::cuboid(size)?.into()).pose(Pose::from_translation(DVec3::new(
        0.5 * size.x,
        0.0,
        -0.5 * size.z,
    )));
    for slider in sliders()?.into_iter().filter(|slider| slider.name != "wheel") {
        let end = |under: Vec<Body>| -> Result<[DVec3; 2], Box<dyn Error>> {
            let start = DVec3::new(0.5 * TILE.x, 0.0, 0.0);
            let body = slider.body(start, DVec3::new(1.0, 0.3, 0.0))?.material(rough.clone());
            let mut scene = Scene::builder("rough seams").duration_s(0.5);
            for body in under {
                scene = scene.body(body.material(rough.clone()));
            }
            let report = Simulation::new(&scene.body(body).build()?)?.estimating(ErrorEstimation::Off).run()?;
            let last = report.bodies.last().ok_or("no body")?.state;
            Ok([last.pose.translation, last.velocity.linear])
        };
        let quantity = format!("{} with friction, as on one plate", slider.name);
        rows.push(match (end(laid.bodies()?), end(vec![plate.clone()])) {
            (Ok(tiles), Ok(whole)) => {
                let apart = (tiles[0] - whole[0]).length().max((tiles[1] - whole[1]).length());
                Row::at_most(CASE, &quantity, AS_ON_PLATE, apart)
            }
            (Err(error), _) | (_, Err(error)) => Row::broken(CASE, &quantity, error.to_string()),
        });
    }
    Ok(rows)
}

//! The drop of a rigid box of the same size and mass, by the impact laws of the library.
//!
//! The box is one metre deep, begins a little above the floor with the speed of the drop, without gravity and friction,
//! and runs for as long as the elastic one is watched; impacts that follow in that time count for both. How far a law
//! is off is the velocity that separates the two, in the metric of kinetic energy and in units of the speed of the
//! drop: `sqrt(|dv|^2 + k^2 dw^2) / v`, with k (m) the radius of gyration.

use crate::failure::Failure;
use polhode::contact::Shape;
use polhode::mesh::solid_box;
use polhode::scene::{ImpactLaw, Material, Method};
use polhode::spatial::{DVec3, Mass, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Scene, Simulation};
use polhode_elastic::RectangleDrop;
use std::error::Error;
use std::time::Instant;

/// How high the box begins, in units of its height: the elastic one touches the floor at the start.
const START: f64 = 0.01;

/// Coefficients that are tried for the best one: from 0 to 1 by hundredths.
const TRIED: usize = 100;

/// A rebound.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rebound {
    /// Velocity along the floor, m/s.
    pub(crate) along: f64,
    /// Velocity up, m/s.
    pub(crate) up: f64,
    /// Angular velocity about y, rad/s.
    pub(crate) spin: f64,
}

impl Rebound {
    /// How far another rebound is off, in units of the speed of the drop.
    fn off(&self, other: &Self, drop: &RectangleDrop) -> f64 {
        let gyration = ((drop.width() * drop.width() + drop.height() * drop.height()) / 12.0).sqrt();
        let differences = [self.along - other.along, self.up - other.up, gyration * (self.spin - other.spin)];
        differences.iter().map(|d| d * d).sum::<f64>().sqrt() / drop.speed()
    }
}

/// What a law makes of the drop.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RigidDrop {
    /// The law.
    pub(crate) law: ImpactLaw,
    /// Its coefficient.
    pub(crate) restitution: f64,
    /// How the box leaves.
    pub(crate) rebound: Rebound,
    /// How far it is off the elastic rebound, in units of the speed of the drop.
    pub(crate) error: f64,
    /// Computing time, s.
    pub(crate) wall_s: f64,
}

/// The laws without loss, and that with the best coefficient, beside an elastic rebound that was watched for so long
/// (s).
pub(crate) fn laws(drop: &RectangleDrop, elastic: &Rebound, watched_s: f64) -> Result<Vec<RigidDrop>, Failure> {
    let run = |law, restitution| of_law(drop, elastic, watched_s, law, restitution);
    let mut found: Vec<RigidDrop> = [ImpactLaw::Propagation, ImpactLaw::Simultaneous, ImpactLaw::Reflection]
        .map(|law| run(law, 1.0))
        .into_iter()
        .collect::<Result<_, _>>()?;
    let mut best: Option<RigidDrop> = None;
    for k in 0..=TRIED {
        let tried = run(ImpactLaw::Simultaneous, k as f64 / TRIED as f64)?;
        if best.is_none_or(|best| tried.error < best.error) {
            best = Some(tried);
        }
    }
    found.extend(best);
    Ok(found)
}

/// What a law with a coefficient makes of the drop, beside an elastic rebound that was watched for so long (s).
pub(crate) fn of_law(
    drop: &RectangleDrop,
    elastic: &Rebound,
    watched_s: f64,
    law: ImpactLaw,
    restitution: f64,
) -> Result<RigidDrop, Failure> {
    let start = Instant::now();
    let rebound = rebound(drop, watched_s, law, restitution)
        .map_err(|error| Failure::Usage(format!("error: the rigid box of the same drop: {error}")))?;
    let wall_s = start.elapsed().as_secs_f64();
    Ok(RigidDrop { law, restitution, rebound, error: rebound.off(elastic, drop), wall_s })
}

fn rebound(drop: &RectangleDrop, watched_s: f64, law: ImpactLaw, restitution: f64) -> Result<Rebound, Box<dyn Error>> {
    let size = DVec3::new(drop.width(), 1.0, drop.height());
    let mass = Mass::new(drop.material().density() * size.x * size.z)?;
    let tilt = drop.tilt_rad();
    let half_height = 0.5 * (size.x * tilt.sin().abs() + size.z * tilt.cos());
    let gap = START * size.z;
    let pose = Pose::new(Rotation::from_rotation_vector(DVec3::Y * tilt), DVec3::Z * (half_height + gap));
    let material = Material::new("law").with_restitution(restitution)?;
    let body = Body::movable("rectangle", solid_box(size, mass)?)
        .geometry(Shape::cuboid(size)?.into())
        .pose(pose)
        .velocity(Velocity::new(DVec3::Z * -drop.speed(), DVec3::ZERO))
        .material(material);
    let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::new(DVec3::Z)?).into());
    let scene = Scene::builder("rigid")
        .gravity(DVec3::ZERO)
        .body(floor)
        .body(body)
        .method(Method { impact: Some(law), ..Method::default() })
        .duration_s(gap / drop.speed() + watched_s)
        .build()?;
    let mut simulation = Simulation::new(&scene)?;
    simulation.run()?;
    let body = simulation.body_id("rectangle").ok_or("there is no rectangle")?;
    let velocity = simulation.body(body).velocity;
    Ok(Rebound { along: velocity.linear.x, up: velocity.linear.z, spin: velocity.angular.y })
}

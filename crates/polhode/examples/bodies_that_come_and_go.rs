//! A stack that grows, and loses its lowest brick: the handles of the other bricks remain valid, that of the removed
//! one is refused.

use polhode::contact::Shape;
use polhode::mesh::solid_box;
use polhode::spatial::{DVec3, Mass, Pose, UnitVector};
use polhode::{Body, Scene, Simulation};

fn brick(number: usize) -> Result<Body, Box<dyn std::error::Error>> {
    Ok(Body::movable(format!("brick{number}"), solid_box(DVec3::splat(0.2), Mass::new(1.0)?)?)
        .geometry(Shape::cuboid(DVec3::splat(0.2))?.into())
        .pose(Pose::from_translation(DVec3::Z * (0.1 + 0.2 * number as f64))))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into());
    let scene = Scene::builder("stack").body(floor).body(brick(0)?).duration_s(2.0).build()?;
    let mut simulation = Simulation::new(&scene)?;
    for number in 1..4 {
        simulation.advance_to(0.1 * number as f64)?;
        simulation.add_body(brick(number)?)?;
    }
    let [lowest, highest] = ["brick0", "brick3"].map(|name| simulation.body_id(name));
    let (lowest, highest) = (lowest.ok_or("no brick")?, highest.ok_or("no brick")?);
    simulation.advance_to(0.5)?;
    simulation.remove_body(lowest)?;
    assert!(simulation.set_force(lowest, DVec3::X, DVec3::ZERO).is_err());
    simulation.advance_to(2.0)?;
    let height = simulation.body(highest).pose.translation.z;
    println!("the highest brick lies at {height} m");
    assert!((height - 0.5).abs() < 1e-12);
    Ok(())
}

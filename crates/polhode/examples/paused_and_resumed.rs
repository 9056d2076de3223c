//! A run that is paused and goes on from a snapshot, with the same bits as one that never stopped.

use polhode::contact::Shape;
use polhode::mesh::solid_box;
use polhode::spatial::{DVec3, Mass, Pose, Rotation, UnitVector};
use polhode::{Body, Scene, Simulation, Snapshot};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let size = DVec3::new(0.3, 0.2, 0.1);
    let turn = Rotation::from_rotation_vector(DVec3::new(0.3, 0.2, 0.1));
    let brick = Body::movable("brick", solid_box(size, Mass::new(2.0)?)?)
        .geometry(Shape::cuboid(size)?.into())
        .pose(Pose::new(turn, DVec3::Z * 0.5));
    let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into());
    let scene = Scene::builder("tumble").body(floor).body(brick).build()?;
    let mut simulation = Simulation::new(&scene)?;
    simulation.advance_to(0.4)?;
    let bytes = simulation.snapshot().to_bytes();
    println!("paused at {} s: {} bytes", simulation.time(), bytes.len());
    let whole = simulation.run()?;

    let mut resumed = Simulation::new(&scene)?;
    resumed.restore(&Snapshot::from_bytes(&bytes)?)?;
    let rest = resumed.run()?;
    assert_eq!(rest.bodies, whole.bodies);
    assert_eq!(rest.ledger, whole.ledger);
    Ok(())
}

//! A golden trajectory for the CI of another project: a hash of the positions and velocities of a run, which has the
//! same value on every platform.

use polhode::contact::Shape;
use polhode::mesh::solid_box;
use polhode::spatial::{DVec3, Mass, Pose, Rotation, UnitVector};
use polhode::{Body, Recorder, Scene, Simulation};

/// The FNV-1a hash of the bits of the positions and linear velocities of all samples.
fn hash(record: &Recorder) -> u64 {
    let samples = record.samples.iter().flatten();
    let numbers = samples.flat_map(|body| [body.pose.translation, body.velocity.linear]).flat_map(|v| v.to_array());
    let bytes = numbers.flat_map(|number| number.to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let size = DVec3::new(0.3, 0.2, 0.1);
    let turn = Rotation::from_rotation_vector(DVec3::new(0.3, 0.2, 0.1));
    let brick = Body::movable("brick", solid_box(size, Mass::new(2.0)?)?)
        .geometry(Shape::cuboid(size)?.into())
        .pose(Pose::new(turn, DVec3::Z));
    let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into());
    let scene = Scene::builder("tumble").body(floor).body(brick).build()?;
    let run = || -> Result<u64, Box<dyn std::error::Error>> {
        let mut record = Recorder::default();
        Simulation::new(&scene)?.run_observed(&mut record)?;
        Ok(hash(&record))
    };
    let golden = run()?;
    println!("golden {golden:016x}");
    assert_eq!(run()?, golden);
    Ok(())
}

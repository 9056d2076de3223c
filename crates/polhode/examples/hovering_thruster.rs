//! A control loop: a hundred times a second the program reads the state of a drone and sets the thrust that holds it at
//! a height.

use polhode::mesh::solid_box;
use polhode::spatial::{DVec3, Mass};
use polhode::{Body, Scene, Simulation};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let drone = Body::movable("drone", solid_box(DVec3::new(0.4, 0.4, 0.1), Mass::new(1.5)?)?);
    let scene = Scene::builder("hover").body(drone).duration_s(8.0).build()?;
    let mut simulation = Simulation::new(&scene)?;
    let drone = simulation.body_id("drone").ok_or("no drone")?;
    for tick in 1..=800 {
        let now = simulation.body(drone);
        let (height, rate) = (now.pose.translation.z, now.velocity.linear.z);
        let thrust = 1.5 * (9.81 + 4.0 * (1.0 - height) - 4.0 * rate);
        simulation.set_force(drone, DVec3::Z * thrust.max(0.0), DVec3::ZERO)?;
        simulation.advance_to(f64::from(tick) * 0.01)?;
    }
    let height = simulation.body(drone).pose.translation.z;
    println!("height {height:.6} m after {} s", simulation.time());
    assert!((height - 1.0).abs() < 1e-4);
    // The ledger books the work of the thruster as external: it explains the change of energy to rounding.
    let ledger = simulation.run()?.ledger;
    assert!(ledger.closure_relative() < 1e-12);
    Ok(())
}

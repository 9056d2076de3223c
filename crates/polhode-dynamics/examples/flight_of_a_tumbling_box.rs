//! A brick thrown up, spinning about its middle axis: it flips over and over, its middle runs along a parabola, and its
//! energy stays what it was. One evaluation for each time asked for, with no steps in between.

use polhode_dynamics::{DVec3, Flight, Inertia, Mass, MassProperties, Pose, RigidBody, Velocity, energy};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let inertia = Inertia::from_diagonal(DVec3::new(1.0, 2.0, 3.0))?;
    let brick = RigidBody::new(&MassProperties::new(Mass::new(12.0)?, DVec3::ZERO, inertia));
    let gravity = DVec3::Z * -9.81;
    let start = brick.at_velocity(Pose::IDENTITY, Velocity::new(DVec3::Z * 49.05, DVec3::new(0.01, 5.0, 0.0)));
    let flight = Flight::new(&brick, 0.0, &start, gravity);
    for t in [0.0, 2.5, 5.0, 7.5, 10.0] {
        let state = flight.state(t);
        println!(
            "{t:4} s: height {:.3} m, middle axis {:.3}",
            state.pose.translation.z,
            state.pose.rotation.rotate(DVec3::Y)
        );
        assert!((state.pose.translation.z - (49.05 * t - 0.5 * 9.81 * t * t)).abs() < 1e-13);
        let energies = [&state, &start].map(|state| energy::total_energy(&brick, state, gravity));
        assert!((energies[0] / energies[1] - 1.0).abs() < 1e-14);
    }
    Ok(())
}

//! One start and one velocity, three motions: a straight line, a screw about a fixed axis, and a flight under gravity.

use polhode_spatial::{ConstantScrew, ConstantVelocity, DVec3, Motion, Pose, SteadyFlight, Velocity};
use std::error::Error;
use std::f64::consts::PI;

fn main() -> Result<(), Box<dyn Error>> {
    // One metre from the z axis, half a turn a second about it, and upwards.
    let start = Pose::from_translation(DVec3::X);
    let velocity = Velocity::new(DVec3::new(0.0, PI, 2.0), DVec3::Z * PI);
    let straight = ConstantVelocity::new(0.0, start, velocity)?;
    let screw = ConstantScrew::new(0.0, start, velocity)?;
    let flight = SteadyFlight::new(0.0, start, velocity, DVec3::Z * -9.81)?;
    for (motion, place) in [
        (&straight as &dyn Motion, DVec3::new(1.0, PI, 2.0)),
        (&screw, DVec3::new(-1.0, 0.0, 2.0)),
        (&flight, DVec3::new(1.0, PI, 2.0 - 0.5 * 9.81)),
    ] {
        let (pose, bounds) = (motion.pose(1.0), motion.bounds(0.0, 1.0));
        println!("after 1 s at {} m, never faster than {} m/s", pose.translation, bounds.speed);
        assert!((pose.translation - place).length() < 1e-15);
        assert!((pose.rotation.rotate(DVec3::X) + DVec3::X).length() < 1e-15);
        assert!(motion.velocity(1.0).linear.length() <= bounds.speed);
    }
    Ok(())
}

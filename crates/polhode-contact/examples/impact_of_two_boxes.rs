//! Two boxes thrown at each other, one of which spins: the time of impact on their exact paths.
//!
//! Both fall with the same acceleration and approach at 4 m/s. At the time of impact the spinning cube has made an
//! eighth of a turn, so that it extends half its diagonal, `1/sqrt(2)` m, towards the other one, which extends 1/2 m.

use polhode_contact::{DVec3, ImpactSearch, Pose, Shape, SteadyFlight, Velocity, time_of_impact};
use std::error::Error;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

fn main() -> Result<(), Box<dyn Error>> {
    let (cube, gravity) = (Shape::cuboid(DVec3::ONE)?, DVec3::Z * -9.81);
    let spinning = Velocity::new(DVec3::new(3.0, 0.0, 5.0), DVec3::Z * FRAC_PI_4);
    let coming = Velocity::new(DVec3::new(-1.0, 0.0, 5.0), DVec3::ZERO);
    let apart = Pose::from_translation(DVec3::X * (4.0 + 0.5 + FRAC_1_SQRT_2));
    let a = SteadyFlight::new(0.0, Pose::IDENTITY, spinning, gravity)?;
    let b = SteadyFlight::new(0.0, apart, coming, gravity)?;
    let time = time_of_impact(&cube, &a, &cube, &b, 0.0, 10.0, &ImpactSearch::default())?;
    println!("impact at {time:?} s");
    assert!((time.ok_or("they miss each other")? - 1.0).abs() < 1e-14);
    Ok(())
}

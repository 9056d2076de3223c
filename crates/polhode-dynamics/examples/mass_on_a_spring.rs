//! A mass on a spring, integrated to a tolerance, and when it passes the middle: after a quarter of `2 pi sqrt(m/k)`.

use polhode_dynamics::field::{Anchor, Field, Spring};
use polhode_dynamics::integrator::{Method, MethodSettings, event};
use polhode_dynamics::{BodyState, DVec3, FreeMotion, Inertia, Mass, MassProperties, Pose, RigidBody};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let (mass, stiffness) = (2.0, 50.0);
    let inertia = Inertia::from_diagonal(DVec3::ONE)?;
    let bodies = [RigidBody::new(&MassProperties::new(Mass::new(mass)?, DVec3::ZERO, inertia))];
    let end = Anchor::Body { body: 0, point: DVec3::ZERO };
    let springs: [Box<dyn Field>; 1] = [Box::new(Spring::new(Anchor::World(DVec3::ZERO), end, stiffness, 0.0)?)];
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &springs);
    let mut method = Method::from_name("dop853")?.build(&MethodSettings::default());
    method.start(&motion, 0.0, &[BodyState::at_rest(Pose::from_translation(DVec3::X))]);
    method.step(&motion, 0.5)?;
    let passing = event::locate(&mut *method, &motion, 0.0, &mut |_, states| states[0].pose.translation.x)?;
    println!("passes the middle at {passing:?} s");
    let quarter = 0.5 * std::f64::consts::PI * f64::sqrt(mass / stiffness);
    assert!((passing.ok_or("it does not come back")? - quarter).abs() < 1e-11);
    Ok(())
}

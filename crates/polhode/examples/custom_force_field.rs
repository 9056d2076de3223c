//! A force field that the program defines: a trap `V = k z^2/2` in which a body swings; its energy is part of the
//! ledger.

use polhode::dynamics::field::{Account, Dependence, Field, Wrench};
use polhode::dynamics::{BodyState, RigidBody};
use polhode::mesh::solid_box;
use polhode::scene::Force;
use polhode::spatial::{DVec3, Mass, Pose};
use polhode::{Body, Scene, Simulation};
use std::sync::Arc;

#[derive(Debug)]
struct Trap {
    stiffness: f64,
}

impl Field for Trap {
    fn dependence(&self) -> Dependence {
        Dependence::Poses
    }

    fn account(&self) -> Account {
        Account::Potential
    }

    fn couples(&self) -> bool {
        false
    }

    fn add_wrenches(&self, _t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        for ((body, state), wrench) in bodies.iter().zip(states).zip(wrenches) {
            wrench.force.z -= self.stiffness * body.center_of_mass_position(state).z;
        }
    }

    fn potential_energy(&self, bodies: &[RigidBody], states: &[BodyState]) -> f64 {
        let heights = bodies.iter().zip(states).map(|(body, state)| body.center_of_mass_position(state).z);
        heights.map(|z| 0.5 * self.stiffness * z * z).sum()
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let body = Body::movable("body", solid_box(DVec3::ONE, Mass::new(1.0)?)?).pose(Pose::from_translation(DVec3::Z));
    let scene = Scene::builder("trap").gravity(DVec3::ZERO).duration_s(3.0).body(body);
    let scene = scene.force(Force::Field(Arc::new(Trap { stiffness: 4.0 }))).build()?;
    let mut simulation = Simulation::new(&scene)?;
    let report = simulation.run()?;
    let height = report.bodies[0].state.pose.translation.z;
    println!("height {height} m, numerical loss {:e} J", report.ledger.numerical.value());
    assert!((height - f64::cos(2.0 * 3.0)).abs() < 1e-9);
    Ok(())
}

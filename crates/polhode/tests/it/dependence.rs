//! A body under a force field may be left at rest or not, depending on what the field declares that it depends on.

use crate::support::{accurate, brick, floor};
use polhode::dynamics::field::{Account, Dependence, Field, Wrench};
use polhode::dynamics::{BodyState, RigidBody};
use polhode::scene::Force;
use polhode::spatial::DVec3;
use polhode::{Scene, Simulation};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

const G: f64 = 9.81;

/// An upward force on the first movable body; a program changes its strength without telling the simulation.
#[derive(Debug)]
struct Hoist {
    /// Bits of the force, N.
    pull: AtomicU64,
    says: Dependence,
}

impl Field for Hoist {
    fn dependence(&self) -> Dependence {
        self.says
    }

    fn account(&self) -> Account {
        Account::External
    }

    fn add_wrenches(&self, _t: f64, _bodies: &[RigidBody], _states: &[BodyState], wrenches: &mut [Wrench]) {
        wrenches[0].force.z += f64::from_bits(self.pull.load(Ordering::Relaxed));
    }

    fn potential_energy(&self, _bodies: &[RigidBody], _states: &[BodyState]) -> f64 {
        0.0
    }
}

/// The rise of a resting box of 1 kg half a second after a program has set a force of twice its weight.
fn height_half_a_second_after(says: Dependence) -> f64 {
    let hoist = Arc::new(Hoist { pull: AtomicU64::new(0.0_f64.to_bits()), says });
    let scene = Scene::builder("hoist")
        .method(accurate())
        .body(floor())
        .body(brick("box", DVec3::ONE, DVec3::Z * 0.5))
        .force(Force::Field(Arc::clone(&hoist) as Arc<dyn Field>))
        .build()
        .unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(0.5).unwrap();
    hoist.pull.store((2.0 * G).to_bits(), Ordering::Relaxed);
    simulation.advance_to(1.0).unwrap();
    let id = simulation.body_id("box").unwrap();
    simulation.body(id).pose.translation.z - 0.5
}

/// A field that declares a dependence on time is evaluated at every step: the box rises with g, at the latest from the
/// step after the change.
#[test]
fn field_that_depends_on_time_moves_a_resting_body_when_it_changes() {
    let height = height_half_a_second_after(Dependence::PosesAndTime);
    let longest_step_s = 0.01;
    let at_once = 0.5 * G * 0.25;
    assert!(
        height <= at_once + 1e-12 && height > 0.5 * G * (0.5 - longest_step_s) * (0.5 - longest_step_s),
        "{height}"
    );
}

/// A field that declares a dependence on poses alone promises the same force at the same poses. A body that rests under
/// it stays at rest, and a change without notice goes unseen.
#[test]
fn field_that_depends_on_poses_alone_leaves_a_resting_body_at_rest() {
    assert_eq!(height_half_a_second_after(Dependence::Poses), 0.0);
}

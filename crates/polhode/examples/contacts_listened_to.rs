//! Contacts: the present contacts with their forces, and an observer that receives every impact.

use polhode::contact::Shape;
use polhode::mesh::solid_box;
use polhode::scene::Material;
use polhode::spatial::{DVec3, Mass, Pose, UnitVector};
use polhode::{Body, BodySample, Event, EventKind, Observer, Scene, Simulation};

/// Counts impacts.
#[derive(Default)]
struct Listener {
    impacts: usize,
}

impl Observer for Listener {
    fn sample(&mut self, _t: f64, _bodies: &[BodySample]) {}

    fn event(&mut self, event: &Event) {
        if event.kind == EventKind::Impact {
            self.impacts += 1;
            println!("{:.6} s: impulse {:.3e} N s at {}", event.t_s, event.impulse, event.point);
        }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rubber = Material::new("rubber").with_restitution(0.5)?;
    let size = DVec3::new(0.3, 0.2, 0.1);
    let brick = Body::movable("brick", solid_box(size, Mass::new(2.0)?)?)
        .geometry(Shape::cuboid(size)?.into())
        .pose(Pose::from_translation(DVec3::Z * 0.25))
        .material(rubber);
    let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into());
    let scene = Scene::builder("bouncing-brick").body(floor).body(brick).duration_s(3.0).build()?;
    let mut simulation = Simulation::new(&scene)?;
    let mut listener = Listener::default();
    simulation.run_observed(&mut listener)?;
    // At rest the contacts bear the weight: only their sum is unique.
    let force: f64 = simulation.contacts().iter().map(|contact| contact.normal_force_n).sum();
    println!("{} impacts, then {} contacts bear {force:.9} N", listener.impacts, simulation.contacts().len());
    assert!((force - 2.0 * 9.81).abs() < 1e-9);
    Ok(())
}

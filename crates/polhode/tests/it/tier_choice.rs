//! The tier of a scene that names none: a wall that stands is certified at rest at the start and keeps tier `accurate`,
//! whatever it would cost to tumble; the same wall with a ball thrown at it, or with its bricks in the air, is run in
//! tier `stepped`.

use crate::support::{ball, brick, floor};
use polhode::scene::{Material, Tier};
use polhode::spatial::{DVec3, Pose};
use polhode::{Body, Scene, SceneBuilder, Simulation};

/// Columns and rows of bricks of 1 x 0.5 x 0.5 m, each on the two below it.
const COLUMNS: u32 = 8;
const ROWS: u32 = 5;

fn rough(body: Body) -> Body {
    body.material(Material::new("rough").with_friction(0.6).unwrap())
}

/// A wall without half bricks, its rows `gap` (m) apart.
fn wall(gap: f64) -> SceneBuilder {
    let scene = Scene::builder("wall").gravity(DVec3::Z * -9.81).duration_s(5.0).body(rough(floor()));
    (0..ROWS).fold(scene, |scene, row| {
        (0..COLUMNS - row).fold(scene, |scene, column| {
            let place = DVec3::new(f64::from(column) + 0.5 * f64::from(row), 0.0, 0.25 + (0.5 + gap) * f64::from(row));
            let name = format!("{row} {column}");
            scene.body(rough(brick(&name, DVec3::new(1.0, 0.5, 0.5), DVec3::ZERO).pose(Pose::from_translation(place))))
        })
    })
}

#[test]
fn a_wall_at_rest_is_accurate_and_one_that_tumbles_is_stepped() {
    let tier = |scene: SceneBuilder| {
        let plan = Simulation::new(&scene.build().unwrap()).unwrap().plan().clone();
        (plan.tier, plan.tier_reason)
    };
    let (standing, reason) = tier(wall(0.0));
    assert!(standing == Tier::Accurate && reason.contains("certified at rest"), "{reason}");
    let thrown = rough(ball("ball", 1.0, 0.2, DVec3::new(3.0, -4.0, 1.0), DVec3::Y * 10.0));
    let (struck, reason) = tier(wall(0.0).body(thrown));
    assert!(struck == Tier::Stepped && reason.contains("processor time"), "{reason}");
    let (falling, reason) = tier(wall(0.1));
    assert!(falling == Tier::Stepped, "{reason}");
}

/// What the plan chooses is what runs: the bits are those of the scene that names the tier.
#[test]
fn the_chosen_tier_runs_as_if_it_were_named() {
    let method = polhode::scene::Method { tier: Some(Tier::Stepped), ..polhode::scene::Method::default() };
    let poses = [wall(0.1), wall(0.1).method(method)].map(|scene| {
        let mut simulation = Simulation::new(&scene.build().unwrap()).unwrap();
        simulation.advance_to(0.1).unwrap();
        ["0 0", "1 3", "4 2"].map(|name| simulation.body(simulation.body_id(name).unwrap()).pose)
    });
    assert_eq!(poses[0], poses[1]);
}

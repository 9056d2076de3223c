//! The scene of a seed. Kinds go round with the seed, so that any row of seeds has all of them.

use super::build::{Build, attitude};
use super::kinds::{drives, freedoms, loops, piles, thrown, tracks, trees};
use super::model::Mechanism;
use super::placement::Placement;
use crate::random::Random;
use glam::DVec3;

/// An odd number that spreads seeds over the states of the random numbers.
const SPREAD: u64 = 0xD1B5_4A32_D192_ED03;

/// A kind of mechanism.
#[derive(Debug)]
pub struct Kind {
    /// What it is called.
    pub name: &'static str,
    /// Whether nothing happens within a piece of it: neither impacts nor stops and starts of slips or contacts.
    is_smooth: bool,
    build: fn(&mut Build),
}

const fn smooth(name: &'static str, build: fn(&mut Build)) -> Kind {
    Kind { name, is_smooth: true, build }
}

const fn eventful(name: &'static str, build: fn(&mut Build)) -> Kind {
    Kind { name, is_smooth: false, build }
}

/// All kinds.
pub const KINDS: &[Kind] = &[
    smooth("tree of joints", trees::tree),
    smooth("planar loop", loops::planar),
    smooth("parallel cranks", loops::parallel),
    smooth("spherical loop", loops::spherical),
    smooth("line-symmetric loop", loops::line_symmetric),
    smooth("slider-crank", loops::slider_crank),
    smooth("hinge-ball-ball-hinge", loops::ball_coupler),
    smooth("seven hinges", loops::seven_hinges),
    smooth("rods", loops::rods),
    smooth("gears", drives::gears),
    smooth("prescribed joint", drives::prescribed),
    smooth("on a driven body", drives::on_driven),
    smooth("winding spring", freedoms::winding),
    smooth("servo", freedoms::servo),
    smooth("springs and drag", trees::forces),
    smooth("bead on a track", tracks::bead),
    smooth("follows a track", tracks::follower),
    eventful("limits", freedoms::limits),
    eventful("rope goes taut", freedoms::rope),
    eventful("bounded motor", freedoms::bounded_motor),
    eventful("joint friction", freedoms::friction),
    eventful("loop with friction", loops::with_friction),
    eventful("loop with a limit", loops::with_limit),
    eventful("track with friction or stops", tracks::rough),
    eventful("one-sided track", tracks::one_sided),
    eventful("thrown, smooth", thrown::smooth),
    eventful("thrown, rough", thrown::rough),
    eventful("two in space", thrown::in_space),
    eventful("slides to a stop", thrown::slide),
    eventful("rolls", thrown::roll),
    eventful("belt", thrown::belt),
    eventful("on a moving floor", thrown::moving_floor),
    eventful("over seams", thrown::seams),
    eventful("mechanism lands", thrown::mechanism),
    eventful("pile at rest", piles::rest),
    eventful("pile pushed", piles::pushed),
    eventful("pile struck", piles::struck),
    eventful("pile dropped", piles::dropped),
];

/// The scene of this seed.
pub fn scene(seed: u64) -> Mechanism {
    let kind = &KINDS[(seed % KINDS.len() as u64) as usize];
    let scene = Mechanism {
        seed,
        kind: kind.name,
        is_smooth: kind.is_smooth,
        duration: if kind.is_smooth { 0.24 } else { 0.3 },
        // What happens within a piece shifts a motion by a step, which is a smaller part of a body in shorter steps.
        step: if kind.is_smooth { 0.004 } else { 0.002 },
        gravity: DVec3::new(0.0, 0.0, -9.81),
        bodies: Vec::new(),
        joints: Vec::new(),
        gears: Vec::new(),
        tracks: Vec::new(),
        forces: Vec::new(),
        materials: Vec::new(),
        apart: Vec::new(),
    };
    let mut build = Build { random: Random(seed.wrapping_add(1).wrapping_mul(SPREAD)), scene, gears: Vec::new() };
    (kind.build)(&mut build);
    let gears = std::mem::take(&mut build.gears);
    build.scene.make_consistent(&gears);
    build.scene
}

/// Another placement of a scene, by its seed: turned about any axis, moved a little, its bodies and joints in the
/// opposite order.
pub fn other_placement(seed: u64) -> Placement {
    let mut random = Random(seed.wrapping_mul(SPREAD).wrapping_add(7));
    Placement { rotation: attitude(&mut random), shift: random.vector(-0.5, 0.5), is_reversed: random.below(2) == 0 }
}

#[cfg(test)]
mod tests {
    //! Names of kinds differ, a seed gives one scene, and velocities at the start are those that joints allow.
    use super::*;

    #[test]
    fn names_differ_and_a_seed_gives_one_scene() {
        let mut names: Vec<&str> = KINDS.iter().map(|kind| kind.name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), KINDS.len());
        let text = |seed: u64| scene(seed).written(&Placement::AS_IS, "accurate", None);
        assert_eq!(text(40), text(40));
        assert_ne!(text(40), text(40 + KINDS.len() as u64));
    }

    /// The program refuses velocities that joints do not allow, as they are and placed otherwise.
    #[test]
    fn the_program_takes_a_scene_of_every_kind() {
        for seed in 0..KINDS.len() as u64 {
            for placement in [Placement::AS_IS, other_placement(seed)] {
                let text = scene(seed).written(&placement, "accurate", None);
                let loaded = polhode_scene::load_text("random.toml", &text, &[]);
                let taken = loaded.map_err(|error| error.to_string()).map(|loaded| {
                    polhode::Simulation::new(&loaded.scene).map(|_| ()).map_err(|error| error.to_string())
                });
                assert_eq!(taken, Ok(Ok(())), "seed {seed}: {}", scene(seed).kind);
            }
        }
    }
}

//! Two ropes of different restitution go taut at once: what a time step tells of their loads is all that the impact
//! gave.
//!
//! The impact law strikes each rope with its own restitution, and stops what then still approaches by a last inelastic
//! solve. Its impulses were applied and not told: the loads of the step were off Newton's law by four fifths, and the
//! run was degraded for it.

use crate::scene;
use polhode::Simulation;

const SCENE: &str = r#"
format = 1
duration = 0.3
gravity = [0.0, 0.0, -9.81]
[method]
tier = "stepped"
step = 0.002
[[bodies]]
name = "b0"
position = [0.2825715473298544, 0.16560590480333262, -0.09319981828115996]
orientation = [0.8889756880280817, -0.3783381217698459, -0.14726705311844632, -0.21188418245936327]
mass = 2.810832753927
inertia = [0.04029253325103952, 0.046027407671435525, 0.05843350865126247]
velocity = [-0.3533439392999543, 0.3516733674236527, -0.05379223613538651]
angular_velocity = [1.9868121687175528, -1.0186058524484825, 1.9335783654046081]
[[bodies]]
name = "b1"
position = [0.5975385151879969, 0.11501058552149027, -0.29537322992579373]
orientation = [0.7442015105235475, 0.32642633238359775, 0.5381449565898645, -0.2236290834349503]
mass = 2.243322587200513
inertia = [0.01520672077817618, 0.046238030817609146, 0.0456201850093957]
velocity = [-0.018760956239236393, 0.02350402380710941, -0.1178122591656135]
angular_velocity = [1.8955003887995532, 0.038870742000958636, 1.393346994624589]
[[joints]]
name = "j0"
type.rope.bodies = ["b0"]
type.rope.anchors = [[0.1543088766961974, 0.05221165555414688, -0.12560202911819046], [0.0, 0.0, 0.0]]
type.rope.length = 0.23054011911970707
type.rope.restitution = 1.0
[[joints]]
name = "j1"
type.rope.bodies = ["b1", "b0"]
type.rope.anchors = [
    [0.7084675500880608, 0.2485782126564037, -0.13021301176131056],
    [0.4173751372581147, 0.32926378373995685, -0.007118862289805322],
]
type.rope.length = 0.3967554933776487
type.rope.restitution = 0.0
"#;

#[test]
fn all_that_ropes_give_when_they_go_taut_is_told() {
    for law in ["simultaneous", "reflection", "poisson", "energetic"] {
        let scene = scene(&SCENE.replace("step = 0.002", &format!("step = 0.002\nimpact = \"{law}\"")));
        let report = Simulation::new(&scene).unwrap().run().unwrap();
        let defect = report.certificate.max_load_defect;
        assert!(report.events > 0 && defect < 1e-9, "{law}: {} events, {defect:e}", report.events);
    }
}

//! A body at the stop of a joint lands on a rough floor: one motion in time steps and in the accurate tier.
//!
//! The stop approaches by the error of a step, some 1e-6 m/s, when the landing strikes it. Where contacts have friction
//! it was reflected as what approaches: the impulse of the landing was 5 % larger, at a step of 2 ms and at 1 ms not.

use crate::scene;
use polhode::Simulation;

const SCENE: &str = r#"
format = 1
duration = 0.03
gravity = [0.0, 0.0, -9.81]
[method]
METHOD
[materials.m0]
friction = 0.11431106444264555
static_friction = 0.14860438377543922
restitution = 0.5
[[bodies]]
name = "b0"
position = [0.0, 0.0, 0.0]
orientation = [1.0, 0.0, 0.0, 0.0]
shape.half_space = { normal = [0, 0, 1] }
material = "m0"
fixed = true
[[bodies]]
name = "b1"
position = [0.0, 0.0, 0.55]
orientation = [-0.10644963776632313, 0.015952609048963454, 0.0739335773343521, -0.9914372471450198]
shape.capsule = { radius = 0.399177700538772, height = 0.21029628012576435 }
material = "m0"
mass = 2.3688711174559582
velocity = [0.0, -0.007307065154219207, -2.009762500647708]
angular_velocity = [0.29493437829467406, -0.9480655246518411, 0.10261031604693907]
[[bodies]]
name = "b2"
position = [0.5, 0.0, 0.55]
orientation = [0.6580675734923257, -0.3580492172330277, -0.2156483583550555, 0.6262935512166068]
shape.sphere = { radius = 0.366425620079071 }
material = "m0"
mass = 2.228874337820817
velocity = [0.0, 0.09595831334875697, -1.9937152357070447]
angular_velocity = [0.1373559251356884, 0.8838764648891874, 0.31045119796496584]
[[bodies]]
name = "b3"
position = [1.0, 0.0, 0.55]
orientation = [-0.5619185302193478, -0.04018926801482883, 0.8227590642347388, 0.07549775064289788]
shape.capsule = { radius = 0.20669326189885295, height = 0.15392247877734141 }
material = "m0"
mass = 1.6920144867892497
velocity = [0.0, -0.08865124819453776, -1.996522263645247]
angular_velocity = [0.037605967916287, -0.8726483531363773, -1.0488894441381458]
[[joints]]
name = "j0"
type.ball = { bodies = ["b2", "b1"], anchor = [0.25, 0.0, 0.55] }
[[joints]]
name = "j1"
type.hinge.bodies = ["b3", "b2"]
type.hinge.anchor = [0.75, 0.0, 0.55]
type.hinge.axis = [-0.04486538694615844, -0.7900471121798082, -0.6114022060726613]
type.hinge.angle = { range = [-0.21314598200409005, 0.03195850801827839], restitution = 0.0 }
[[no_contact]]
bodies = ["b1", "b2", "b3"]
"#;

/// Speed along z of the body that lands, 8 ms after it, m/s.
fn speed(method: &str) -> f64 {
    let scene = scene(&SCENE.replace("METHOD", method));
    let report = Simulation::new(&scene).unwrap().run().unwrap();
    report.bodies[1].state.velocity.linear.z
}

#[test]
fn a_stop_that_approaches_by_the_error_of_a_step_is_no_striker() {
    let right = speed("tier = \"accurate\"");
    for step in [0.002, 0.001] {
        let error = (speed(&format!("tier = \"stepped\"\nstep = {step}")) - right).abs();
        assert!(error < 1e-4, "{step}: {error:e} m/s");
    }
}

//! A planar linkage of four hinges that hits the stop of one of them rebounds: one contact is struck, so that all laws
//! of impacts agree.
//!
//! The hinges of such a loop hold three directions twice. Their velocities before the impact are rounding, by which
//! they contradict each other. No law solved the impact for that: the linkage stuck at its stop, its energy gone, and
//! the run was completed. Turned in the world, the same linkage rebounded.

use crate::scene;
use polhode::Simulation;

const SCENE: &str = r#"
format = 1
duration = 0.3
gravity = [0.0, 0.0, -9.81]
[method]
tier = "accurate"
impact = "LAW"
[[bodies]]
name = "b0"
position = [0.20184830098596923, 0.13991960344775511, -0.4204737020958875]
orientation = [0.7182819674094845, -0.650858428979601, -0.24288461084971114, -0.03822808565636725]
mass = 2.84131312894202
inertia = [0.09784745156791608, 0.07050285916982085, 0.1346084698860428]
velocity = [-0.03626979831740156, -0.011537638350275676, 0.09612077030564489]
angular_velocity = [-0.12121107558430667, 0.3661971164329488, -0.0017816271178062535]
[[bodies]]
name = "b1"
position = [-0.3617183510248729, -0.2027595760975281, -0.32936403540744663]
orientation = [-0.9936650619527309, -0.10669962047457095, 0.004836968800838265, -0.0349505275765299]
mass = 2.3397906567713647
inertia = [0.19395194247233824, 0.0865214804437074, 0.21938907293916854]
velocity = [-0.08952315171809969, -0.02873173046838477, 0.1850671549065376]
angular_velocity = [-0.004512799562092482, 0.013633854651580195, -6.633161234062105e-5]
[[bodies]]
name = "b2"
position = [-0.19480153473755618, -0.05290329837850871, 0.4417475799302355]
orientation = [0.7883094853999416, 0.5852744826235695, -0.1867115824357776, 0.03406934402832138]
mass = 0.46556595979719106
inertia = [0.08906949728321648, 0.12020536741174494, 0.055474181527470266]
velocity = [-0.024665654000917955, -0.007691464675340507, 0.09719108137467723]
angular_velocity = [-0.05415189707254102, 0.16360112689162376, -0.0007959543947614551]
[[joints]]
name = "j0"
type.hinge.bodies = ["b0"]
type.hinge.anchor = [0.46068955795918676, 0.1509239475783788, -0.3214827732961457]
type.hinge.axis = [-0.3142296928822191, 0.9493357506843042, -0.004618721015056996]
[[joints]]
name = "j1"
type.hinge.bodies = ["b1", "b0"]
type.hinge.anchor = [0.020712145974499645, 0.004061532253012656, -0.5743177579916519]
type.hinge.axis = [-0.3142296928822191, 0.9493357506843042, -0.004618721015056996]
[[joints]]
name = "j2"
type.hinge.bodies = ["b2", "b1"]
type.hinge.anchor = [-0.7018326650114699, -0.2319155583292852, 0.08031057042693061]
type.hinge.axis = [-0.3142296928822191, 0.9493357506843042, -0.004618721015056996]
[[joints]]
name = "j3"
type.hinge.bodies = ["b2"]
type.hinge.anchor = [0.34320616659705255, 0.11647978247045633, 0.5916905128390549]
type.hinge.axis = [-0.3142296928822191, 0.9493357506843042, -0.004618721015056996]
type.hinge.angle = { range = [-0.2687060412234175, 0.2991101672560743], restitution = 0.7010976291623467 }
"#;

/// Energy that the impact takes by a law, J.
fn lost(law: &str) -> f64 {
    let scene = scene(&SCENE.replace("LAW", law));
    let report = Simulation::new(&scene).unwrap().run().unwrap();
    assert!(report.warnings.is_empty(), "{law}: {:?}", report.warnings);
    report.ledger.impact.value()
}

#[test]
fn a_closed_linkage_rebounds_from_its_stop_by_every_law() {
    let right = lost("simultaneous");
    for law in ["reflection", "propagation", "poisson", "energetic"] {
        let error = (lost(law) - right).abs();
        assert!(right > 5.0 && error < 1e-9, "{law}: {error:e} J of {right} J");
    }
}

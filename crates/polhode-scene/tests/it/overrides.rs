//! Values set from outside the file.

use crate::BASE;
use polhode::BodyId;
use polhode::Scene;
use polhode::scene::{Force, ImpactLaw, Integrator};
use polhode::spatial::DVec3;
use polhode_scene::{Override, Refused, SceneFileError, load_text};

fn load_with(changes: &[&str]) -> Result<Scene, SceneFileError> {
    let overrides: Vec<_> = changes.iter().map(|text| Override::parse("--set", text).unwrap()).collect();
    load_text("test.toml", BASE, &overrides).map(|loaded| loaded.scene)
}

#[track_caller]
fn set(changes: &[&str]) -> Scene {
    load_with(changes).unwrap_or_else(|error| panic!("{error}"))
}

#[track_caller]
fn refused(change: &str) -> Box<Refused> {
    match load_with(&[change]) {
        Err(SceneFileError::Refused(refused)) => refused,
        other => panic!("{other:?}"),
    }
}

/// Any key can be set: of a table, of a body by name or number, of a material, of an element of an array; tables that
/// are missing are made; later changes win.
#[test]
fn any_key() {
    assert_eq!(set(&["duration=5"]).duration_s(), 5.0);
    assert_eq!(set(&["duration = 5e-1"]).duration_s(), 0.5);
    assert_eq!(set(&["duration=5", "duration=6"]).duration_s(), 6.0);
    assert_eq!(set(&["method.impact=propagation"]).method().impact, Some(ImpactLaw::Propagation));
    assert_eq!(set(&["method.impact=\"reflection\""]).method().impact, Some(ImpactLaw::Reflection));
    assert_eq!(set(&["method.step=0.5", "method.impact=reflection"]).method().step_s, Some(0.5));
    assert_eq!(set(&["bodies.brick.mass=2"]).bodies()[1].mass_properties().unwrap().mass(), 2.0);
    assert_eq!(set(&["bodies.1.mass=2"]).bodies()[1].mass_properties().unwrap().mass(), 2.0);
    assert_eq!(set(&["bodies.1.name=stone"]).bodies()[1].name(), "stone");
    assert_eq!(set(&["bodies.brick.position.2=7"]).bodies()[1].initial_pose().translation.z, 7.0);
    assert_eq!(
        set(&["bodies.brick.velocity=[1, 2, 3]"]).bodies()[1].initial_velocity().linear,
        DVec3::new(1.0, 2.0, 3.0)
    );
    assert_eq!(
        set(&["materials.ice.restitution=0.25"])
            .material_between(BodyId::new(0), BodyId::new(1))
            .unwrap()
            .restitution(),
        0.25
    );
    assert_eq!(
        set(&["materials.fire.restitution=0.1", "bodies.brick.material=fire"])
            .material_between(BodyId::new(0), BodyId::new(1))
            .unwrap()
            .restitution(),
        0.1
    );
    assert_eq!(set(&["name=a-name"]).name(), "a-name");
    assert_eq!(set(&["name=\"a = b\""]).name(), "a = b");
    let sphere = set(&["bodies.brick.shape={ sphere = { radius = 1 } }"]);
    assert!((sphere.bodies()[1].mass_properties().unwrap().inertia().matrix().x_axis.x - 2.4).abs() < 1e-14);
}

/// Methods, pivots and numbers of forces can be set, and forces be put to a scene that has none.
#[test]
fn methods_and_forces() {
    assert_eq!(set(&["method.integrator=cf4"]).method().integrator, Some(Integrator::Cf4));
    let spring = "forces=[{ type = { spring = { body = \"brick\", anchor = [0, 0, 0], stiffness = 1 } } }]";
    let stiffness = |scene: &Scene| match &scene.forces()[0] {
        Force::Spring { stiffness, .. } => *stiffness,
        other => panic!("{other:?}"),
    };
    assert_eq!(stiffness(&set(&[spring])), 1.0);
    assert_eq!(stiffness(&set(&[spring, "forces.0.type.spring.stiffness=7"])), 7.0);
    assert_eq!(set(&["bodies.brick.pivot=[0, 0, 9]"]).bodies()[1].pivot_point(), Some(DVec3::Z * 9.0));
}

/// What is wrong with a change is shown in the text of the change, at its own column.
#[test]
fn places() {
    let cases = [
        ("bodies.brick.mass=-2", "bodies.brick.mass", 21),
        ("method.tier=quick", "method.tier", 15),
        ("method.teir=thesis", "method.teir", 8),
        ("bodies.brick.velocity=[0, nan, 0]", "bodies.brick.velocity.1", 29),
        ("bodies.wall.mass=1", "bodies.wall.mass", 8),
        ("bodies.7.mass=1", "bodies.7.mass", 8),
        ("name.x=1", "name.x", 1),
        ("duration=1 2", "duration", 12),
        ("duration=[", "duration", 12),
        ("duration=", "duration", 12),
        ("duration=1\nname=2", "duration", 12),
        ("a..b=1", "a..b", 1),
        ("a\nb=1", "a\nb", 1),
        ("joints=[{}]", "joints.0", 11),
        ("method.integrator=rk5", "method.integrator", 21),
        ("bodies.brick.pivot=[0, 0]", "bodies.brick.pivot", 22),
        ("forces=[{ type = { drag = { law = \"linear\" } } }]", "forces.0.type.drag", 29),
        ("forces=[{ type = { mutual_gravity = { constant = -1 } } }]", "forces.0.type.mutual_gravity.constant", 52),
    ];
    for (change, key, column) in cases {
        let refused = refused(change);
        assert_eq!(refused.place.origin, "--set", "{change}: {refused}");
        assert_eq!((refused.place.key.as_str(), refused.place.column), (key, column), "{change}: {refused}");
    }
    assert!(Override::parse("--set", "duration").is_none());
    assert!(Override::parse("--set", "\"a=b\"").is_none());
}

/// An error in the file that a change does not touch is still shown in the file.
#[test]
fn the_file_keeps_its_places() {
    let text = BASE.replace("mass = 6.0", "mass = -6.0");
    let change = Override::new("--duration", "duration", "3");
    let error = load_text("test.toml", &text, &[change]).unwrap_err();
    assert_eq!(error.refused().unwrap().place.origin, "test.toml");
}

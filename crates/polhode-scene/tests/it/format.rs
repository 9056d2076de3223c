//! What is accepted, and what absent keys mean.

use crate::{BASE, scene};
use polhode::BodyId;
use polhode::scene::{
    BroadPhaseMethod, ContactMethod, DEFAULT_GRAVITY, ImpactLaw, Integrator, Orientation, Response, RotationRate, Tier,
};
use polhode::spatial::{DVec3, Rotation};
use polhode_scene::names;

/// Absent keys: gravity, pose, velocity, material, method; the name is that of the file.
#[test]
fn defaults() {
    let scene = scene("format = 1\n[[bodies]]\nname = \"a\"\nmass = 1\ninertia = [1, 1, 1]\n");
    assert_eq!(scene.name(), "test.toml");
    assert_eq!(scene.gravity(), DEFAULT_GRAVITY);
    assert_eq!((scene.duration_s(), scene.output_interval_s()), (1.0, 0.01));
    assert_eq!(scene.method(), &polhode::scene::Method::default());
    let body = &scene.bodies()[0];
    assert_eq!(body.initial_pose().translation, DVec3::ZERO);
    assert_eq!(body.initial_pose().rotation, Rotation::IDENTITY);
    assert!(body.initial_velocity().is_zero());
    assert!(body.shape().is_none());
}

/// Every knob of the method arrives.
#[test]
fn method() {
    let text = BASE.replace(
        "name = \"base\"",
        "method = { tier = \"thesis\", step = 0.001, integrator = \"rk4\", orientation = \"matrix\", \
         rotation_rate = \"angular-velocity\", impact = \"simultaneous\", contact = \"least-force\", response = \
         \"impulse\", broad_phase = \"kd-tree\", tolerance = 1e-9, max_events_per_step = 77 }",
    );
    let method = scene(&text).method().clone();
    assert_eq!(method.tier, Some(Tier::Thesis));
    assert_eq!(method.step_s, Some(0.001));
    assert_eq!(method.integrator, Some(Integrator::Rk4));
    assert_eq!(method.orientation, Some(Orientation::Matrix));
    assert_eq!(method.rotation_rate, Some(RotationRate::AngularVelocity));
    assert_eq!(method.impact, Some(ImpactLaw::Simultaneous));
    assert_eq!(method.contact, Some(ContactMethod::LeastForce));
    assert_eq!(method.response, Some(Response::Impulse));
    assert_eq!(method.broad_phase, Some(BroadPhaseMethod::KdTree));
    assert_eq!(method.tolerance, Some(1e-9));
    assert_eq!(method.max_events_per_step, Some(77));
}

/// Every word of every knob is accepted.
#[test]
fn words() {
    for (knob, words) in [
        ("impact", &["propagation", "simultaneous", "reflection", "poisson", "energetic", "pulse"][..]),
        ("contact", &["active-set"]),
        ("tier = \"thesis\"\nmethod.contact", &["least-force", "active-set", "heuristic", "guesses"]),
        ("response", &["constraint", "impulse"]),
        (
            "tier = \"thesis\"\nmethod.response",
            &["constraint", "impulse", "impulse-projection", "impulse-unconditional"],
        ),
    ] {
        for word in words {
            scene(&BASE.replace("name = \"base\"", &format!("method.{knob} = \"{word}\"")));
        }
    }
}

/// Every integrator of the engine goes by its own name, in both tiers.
#[test]
fn integrators() {
    for integrator in Integrator::ALL {
        for tier in ["thesis", "accurate"] {
            let lines = format!("method.integrator = \"{integrator}\"\nmethod.tier = \"{tier}\"");
            let scene = scene(&BASE.replace("name = \"base\"", &lines));
            assert_eq!(scene.method().integrator, Some(integrator));
            assert_eq!(names::integrator(integrator), integrator.name());
        }
    }
}

/// Coordinates of orientation and variables of rotation, of the integrator that has them; it is that of the thesis.
#[test]
fn representations() {
    use Orientation as O;
    let with = |lines: &str| scene(&BASE.replace("name = \"base\"", lines)).method().clone();
    for orientation in [
        O::Quaternion,
        O::QuaternionUnnormalized,
        O::QuaternionThreeNumbers,
        O::Matrix,
        O::MatrixUnorthogonalized,
        O::EulerAngles,
    ] {
        let line = format!("method.orientation = \"{}\"", names::orientation(orientation));
        assert_eq!(with(&format!("{line}\nmethod.integrator = \"rk4\"")).orientation, Some(orientation));
        assert_eq!(with(&format!("{line}\nmethod.tier = \"thesis\"")).orientation, Some(orientation));
    }
    for variable in [RotationRate::AngularMomentum, RotationRate::AngularVelocity] {
        let line = format!("method.rotation_rate = \"{}\"", names::rotation_rate(variable));
        assert_eq!(with(&format!("{line}\nmethod.integrator = \"rk4\"")).rotation_rate, Some(variable));
    }
}

/// Poses: `orientation` is scalar first and normalised within 1e-6, `rotation_vector` is axis times angle.
#[test]
fn poses() {
    let pose = |line: &str| {
        *scene(&BASE.replace("position = [0, 0, 10]", &format!("position = [1, 2, 3]\n{line}"))).bodies()[1]
            .initial_pose()
    };
    let half = std::f64::consts::FRAC_PI_2;
    let by_vector = pose(&format!("rotation_vector = [0, 0, {half}]"));
    let by_quaternion = pose("orientation = [0.7071068, 0, 0, 0.7071068]");
    assert_eq!(by_vector.translation, DVec3::new(1.0, 2.0, 3.0));
    assert!(by_vector.rotation.angle_to(by_quaternion.rotation) < 1e-7);
    assert!(by_quaternion.rotation.rotate(DVec3::X).distance(DVec3::Y) < 1e-7);
    let norm = by_quaternion.rotation.quaternion().length();
    assert!((norm - 1.0).abs() < 1e-15);
}

/// Materials combine by their rule: geometric mean of friction, larger restitution, unless a pair overrides it.
#[test]
fn materials() {
    let text =
        BASE.replace("fixed = true", "fixed = true\nmaterial = \"rubber\"") + "[materials.rubber]\nrestitution = 0.9\n";
    assert_eq!(scene(&text).material_between(BodyId::new(0), BodyId::new(1)).unwrap().restitution(), 0.9);
    assert_eq!(scene(BASE).material_between(BodyId::new(0), BodyId::new(1)).unwrap().restitution(), 0.5);
    let pair = format!("{text}[[pairs]]\nmaterials = [\"ice\", \"rubber\"]\nrestitution = 0.1\n");
    assert_eq!(scene(&pair).material_between(BodyId::new(0), BodyId::new(1)).unwrap().restitution(), 0.1);
    assert_eq!(scene(&pair).material_between(BodyId::new(1), BodyId::new(0)).unwrap().restitution(), 0.1);
}

/// Bodies of a `no_contact` group do not collide.
#[test]
fn no_contact() {
    assert!(scene(BASE).can_collide(BodyId::new(0), BodyId::new(1)));
    let group = format!("{BASE}[[no_contact]]\nbodies = [\"floor\", \"brick\"]\n");
    assert!(!scene(&group).can_collide(BodyId::new(0), BodyId::new(1)));
}

/// Title and description are on one line however they are broken in the file; without a title the name is it, and a
/// description of blanks is none.
#[test]
fn title_and_description() {
    let load =
        |lines: &str| polhode_scene::load_text("test.toml", &BASE.replace("name = \"base\"", lines), &[]).unwrap();
    let said = load("title = \" A base \"\ndescription = \"\"\"\nLook\n  here.\n\"\"\"");
    assert_eq!((said.title(), said.description().as_deref()), ("A base".to_owned(), Some("Look here.")));
    let silent = load("name = \"base\"\ntitle = \"\"\ndescription = \"  \"");
    assert_eq!((silent.title(), silent.description()), ("base".to_owned(), None));
}

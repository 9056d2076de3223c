//! `polhode check`: exit code 2 for a bad scene, 3 for files that cannot be read.

use crate::{FLIGHT, Place, fixture};

/// A good scene.
#[test]
fn fine() {
    let run = Place::with_scene(FLIGHT).expect(0, &["check", "scene.toml"]);
    assert_eq!(run.stdout, "scene.toml: flight: fine; bodies: 1 (0 fixed); duration: 0.5 s\n");
    Place::new().expect(0, &["check", &fixture("scenes/dzhanibekov.toml")]);
}

/// A bad scene is shown with file, line, column, key, what is accepted, and the line.
#[test]
fn bad_scene() {
    let place = Place::with_scene(&FLIGHT.replace("mass = 2.0", "mass = -2.0"));
    let run = place.expect(2, &["check", "scene.toml"]);
    let expected = [
        "error: mass must be a positive number of kilograms, found -2",
        "scene.toml:11:8",
        "11 | mass = -2.0",
        "key `bodies.\"stone, \\\"flat\\\"\".mass`",
    ];
    for part in expected {
        assert!(run.stderr.contains(part), "{part}\n{}", run.stderr);
    }
    let place = Place::with_scene(&FLIGHT.replace("mass = 2.0", "density = 2.0\nvolume = 3"));
    let run = place.expect(2, &["check", "scene.toml"]);
    assert!(run.stderr.contains("unknown key `volume`") && run.stderr.contains("accepted: `name`"), "{}", run.stderr);
}

/// Each mistake of a scene has exit code 2.
#[test]
fn mistakes() {
    let place = Place::with_scene(FLIGHT);
    for change in [
        "bodies.0.mass=nan",
        "bodies.0.mass=0",
        "bodies.0.inertia=[1, 2, 4]",
        "bodies.0.orientation=[2, 0, 0, 0]",
        "bodies.0.density=1",
        "bodies.0.material=\"gold\"",
        "bodies.0.pivot=[1, 0]",
        "joints=[{}]",
        "forces=[{}]",
        "forces=[{ type = { magnet = {} } }]",
        "forces=[{ type = { torque = { body = \"stone\", torque = [0, 0, 1] } } }]",
        "forces=[{ type = { drag = { law = \"linear\", translational = -1 } } }]",
        "method.tier=faster",
        "method.contact=interior-point",
        "method.integrator=rk5",
        "method.orientation=matrix",
        "method.rotation_rate=angular-velocity",
        "duration=inf",
        "format=2",
        "no_contact=[{ bodies = [\"a\", \"b\"] }]",
    ] {
        let run = place.expect(2, &["check", "scene.toml", "--set", change]);
        assert!(run.stderr.contains("command line (--set):1:"), "{change}\n{}", run.stderr);
    }
    for (flag, value) in
        [("--tier", "faster"), ("--tier", "quick"), ("--step", "-1"), ("--step", "x"), ("--duration", "0")]
    {
        let run = place.expect(2, &["check", "scene.toml", flag, value]);
        assert!(run.stderr.contains(&format!("command line ({flag}):1:")), "{}", run.stderr);
    }
}

/// The shipped scenes with pivots and forces are fine.
#[test]
fn loaded_scenes() {
    for name in [
        "heavy-top",
        "sleeping-top",
        "gyroscope-wheel",
        "kepler-orbit",
        "spring-pair",
        "thrown-plate-in-air",
        "satellite-thruster",
    ] {
        let run = Place::new().expect(0, &["check", &fixture(&format!("scenes/{name}.toml"))]);
        assert!(run.stdout.contains(&format!("{name}: fine")), "{}", run.stdout);
    }
}

/// A change of a force of a shipped scene is checked at its place; integrators that take no drag are refused.
#[test]
fn changed_forces() {
    let (pair, plate) = (fixture("scenes/spring-pair.toml"), fixture("scenes/thrown-plate-in-air.toml"));
    let place = Place::new();
    place.expect(0, &["check", &pair, "--set", "forces.0.type.spring.stiffness=50", "--set", "method.integrator=rk4"]);
    let run = place.expect(2, &["check", &pair, "--set", "forces.0.type.spring.stiffness=-50"]);
    assert!(run.stderr.contains("key `forces.0.type.spring.stiffness`"), "{}", run.stderr);
    let run = place.expect(2, &["check", &plate, "--set", "method.integrator=exact"]);
    assert!(run.stderr.contains("key `method.integrator`") && run.stderr.contains("drag"), "{}", run.stderr);
    let run = place.expect(2, &["check", &plate, "--set", "forces.0.type.drag.body=plat"]);
    assert!(run.stderr.contains("no body is named `plat`") && run.stderr.contains("`plate`"), "{}", run.stderr);
}

/// Bodies that overlap are found, at the body.
#[test]
fn overlap() {
    let balls = "format = 1\n[[bodies]]\nname = \"a\"\nshape.sphere.radius = 1\nmass = 1\n\
                 [[bodies]]\nname = \"b\"\nshape.sphere.radius = 1\nmass = 1\nposition = [1.5, 0, 0]\n";
    let run = Place::with_scene(balls).expect(2, &["check", "scene.toml"]);
    assert!(run.stderr.contains("overlap") && run.stderr.contains("scene.toml:6:1"), "{}", run.stderr);
}

/// Files that cannot be read: the scene, or a mesh that it names.
#[test]
fn missing_files() {
    let place = Place::with_scene(&FLIGHT.replace("inertia", "shape.mesh.file = \"missing.obj\"\ninertia"));
    place.expect(3, &["check", "missing.toml"]);
    place.expect(3, &["check", "."]);
    let run = place.expect(3, &["check", "scene.toml"]);
    assert!(run.stderr.contains("missing.obj") && run.stderr.contains("scene.toml:12:"), "{}", run.stderr);
}

/// A file of 100 MB is refused at once, and one of random bytes with its place.
#[test]
fn garbage() {
    let place = Place::new();
    std::fs::File::create(place.path("large.toml")).unwrap().set_len(100 << 20).unwrap();
    let run = place.expect(2, &["check", "large.toml"]);
    assert!(run.stderr.contains("larger than"), "{}", run.stderr);
    let bytes: Vec<u8> = (0..1_000_000_u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 13) as u8).collect();
    std::fs::write(place.path("noise.toml"), bytes).unwrap();
    place.expect(2, &["check", "noise.toml"]);
    std::fs::write(place.path("line.toml"), "x".repeat(1 << 20)).unwrap();
    let run = place.expect(2, &["check", "line.toml"]);
    assert!(run.stderr.len() < 2000, "{}", run.stderr.len());
}

/// Many pairs that overlap are told in a line each, ten at the most.
#[test]
fn overlaps_are_told_in_a_line_each() {
    let body = |k: usize| {
        format!("[[bodies]]\nname = \"b{k}\"\nshape.box.size = [1, 1, 1]\nmass = 1\nposition = [0.0{k}, 0, 0]\n")
    };
    let place = Place::with_scene(&("format = 1\n".to_owned() + &(1..=6).map(body).collect::<String>()));
    let said = place.expect(2, &["check", "scene.toml"]).stderr;
    assert!(said.starts_with("error: 15 pairs of bodies overlap at the start\n"), "{said}");
    let lines = said.lines().filter(|line| line.contains("overlap by")).count();
    assert_eq!(lines, 10, "{said}");
    assert!(said.contains("and 5 more pairs") && said.lines().all(|line| line.len() < 160), "{said}");
}

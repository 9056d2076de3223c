//! Every mistake is refused with its place, its key, and what is accepted.

use crate::{BASE, check, refused};
use polhode::{ErrorEstimation, Simulation};
use polhode_scene::{Refusal, SceneFileError, load, load_text};
use std::time::{Duration, Instant};

/// `BASE` with `brick`'s line that begins with `old` replaced.
fn brick(old: &str, new: &str) -> String {
    let (head, body) = BASE.split_once("name = \"brick\"").unwrap();
    let line = body.lines().find(|line| line.starts_with(old)).unwrap();
    format!("{head}name = \"brick\"{}", body.replace(line, new))
}

/// Numbers that no body can have are refused at their key.
#[test]
fn numbers_out_of_range() {
    let cases = [
        ("mass", "mass = 0", "bodies.brick.mass", "positive number of kilograms, found 0"),
        ("mass", "mass = -1.5", "bodies.brick.mass", "found -1.5"),
        ("mass", "mass = nan", "bodies.brick.mass", "found NaN"),
        ("mass", "mass = inf", "bodies.brick.mass", "found inf"),
        ("mass", "density = 0.0", "bodies.brick.density", "positive number of kg/m^3"),
        ("mass", "density = -inf", "bodies.brick.density", "found -inf"),
        ("shape", "shape.box.size = [1, 0, 1]", "bodies.brick.shape.box.size.1", "0 is not accepted"),
        ("shape", "shape.box.size = [1, 1, -2]", "bodies.brick.shape.box.size.2", "-2 is not accepted"),
        ("shape", "shape.box.size = [nan, 1, 1]", "bodies.brick.shape.box.size.0", "NaN is not accepted"),
        ("shape", "shape.box.size = [1e-200, 1e-200, 1e-200]", "bodies.brick.shape.box.size", "at least"),
        ("shape", "shape.sphere.radius = 0", "bodies.brick.shape.sphere.radius", "a positive, finite number"),
        ("shape", "shape.sphere.radius = inf", "bodies.brick.shape.sphere.radius", "inf is not accepted"),
        (
            "shape",
            "shape.points.positions = [[0, 0, 0], [0, nan, 0]]",
            "bodies.brick.shape.points.positions.1.1",
            "NaN",
        ),
        ("shape", "shape.points.positions = []", "bodies.brick.shape.points.positions", "at least 1"),
        ("position", "position = [0, inf, 0]", "bodies.brick.position.1", "a finite number"),
        ("position", "velocity = [nan, 0, 0]", "bodies.brick.velocity.0", "a finite number"),
        ("position", "angular_velocity = [0, 0, nan]", "bodies.brick.angular_velocity.2", "a finite number"),
        ("position", "rotation_vector = [0, 0, nan]", "bodies.brick.rotation_vector.2", "a finite number"),
        ("position", "rotation_vector = [1e200, 0, 0]", "bodies.brick.rotation_vector", "1e200"),
        ("position", "orientation = [1, 0, 0, 0.01]", "bodies.brick.orientation", "must be 1 within 1e-6"),
        ("position", "orientation = [0, 0, 0, 0]", "bodies.brick.orientation", "must be 1 within 1e-6"),
        ("position", "orientation = [nan, 0, 0, 0]", "bodies.brick.orientation", "not finite"),
        ("position", "inertia = [1, 1, 2.1]", "bodies.brick.inertia", "triangle inequality"),
        ("position", "inertia = [1, 1, 0]", "bodies.brick.inertia", "must be positive"),
        ("position", "inertia = [[1, 0.5, 0], [0, 1, 0], [0, 0, 1]]", "bodies.brick.inertia", "symmetric"),
        ("position", "inertia = [1, nan, 1]", "bodies.brick.inertia", "not finite"),
    ];
    for (old, new, key, message) in cases {
        let shown = new.split(" =").next().unwrap();
        let text = brick(old, new);
        // A shape without volume needs an inertia; what is tested comes first.
        check(&text, key, shown, message);
    }
}

/// Numbers of the scene itself.
#[test]
fn numbers_of_the_scene() {
    let cases = [
        ("duration = 0", "duration", "positive"),
        ("duration = -1", "duration", "-1 is not accepted"),
        ("duration = nan", "duration", "NaN is not accepted"),
        ("duration = 1e999", "duration", "overflowed"),
        ("gravity = [0, 0, inf]", "gravity.2", "inf is not accepted"),
        ("gravity = [0, 0]", "gravity", "an array of length 3"),
        ("gravity = [0, 0, 0, 0]", "gravity", "an array of length 3"),
        ("output.interval = 0", "output.interval", "positive"),
        ("method.step = -0.1", "method.step", "positive"),
        ("method.tolerance = 0.5", "method.tolerance", "(0, 0.1]"),
        ("method.broad_phase = \"grid\"", "method.broad_phase", "sweep-and-prune"),
        ("method.max_events_per_step = 0", "method.max_events_per_step", "at least 1"),
        ("method.max_events_per_step = -3", "method.max_events_per_step", "whole number"),
    ];
    for (line, key, message) in cases {
        let text = BASE.replace("name = \"base\"", &format!("name = \"base\"\n{line}"));
        check(&text, key, line, message);
    }
}

/// How a scene is shown is checked as all else is.
#[test]
fn looks() {
    let views = [
        ("view.camera = \"left\"", "view.camera", "unknown value `left`"),
        ("view.camera = \"left\"", "view.camera", "`front`, `side`, `top`, `iso`"),
        ("view.camera = [1, 2]", "view.camera", "an array of length 3"),
        ("view.camera = 3", "view.camera", "one of `front`"),
        ("view.camera = [0, nan, 0]", "view.camera.1", "a finite number"),
        ("view.from = [0, 0, 0]", "view.from", "no direction"),
        ("view.frame = [[0, 0, 0], [0, 0, 0]]", "view.frame", "a box without a size"),
        ("view.frame = [[0, 0, 0]]", "view.frame", "an array of length 2"),
        ("view.zoom = 2", "view.zoom", "unknown key `zoom`"),
        ("view = { camera = [1, 0, 0], look_at = [1, 0, 0] }", "view.look_at", "the place of the camera"),
        ("view = { camera = \"top\", from = [1, 0, 0] }", "view.from", "cannot both be given"),
    ];
    for (line, key, message) in views {
        let text = BASE.replace("name = \"base\"", &format!("name = \"base\"\n{line}"));
        check(&text, key, line.split(" =").next().unwrap().split('.').next().unwrap(), message);
    }
    let bodies = [
        ("colour = \"bluish\"", "bodies.brick.colour", "`#rrggbb`"),
        ("colour = \"#12\"", "bodies.brick.colour", "unknown value `#12`"),
        ("colour = \"#+12345\"", "bodies.brick.colour", "unknown value"),
        ("colour = 5", "bodies.brick.colour", "`blue`"),
        ("opacity = 1.5", "bodies.brick.opacity", "a number from 0 to 1"),
        ("opacity = nan", "bodies.brick.opacity", "a number from 0 to 1"),
        ("hidden = 1", "bodies.brick.hidden", "boolean"),
        ("label = 3", "bodies.brick.label", "string"),
    ];
    for (line, key, message) in bodies {
        check(&brick("position", line), key, line.split(" =").next().unwrap(), message);
    }
}

/// What a body must have, and what it must not have together.
#[test]
fn combinations() {
    let cases = [
        ("mass", "mass = 1\ndensity = 1", "bodies.brick.density", "density = 1", "give one of them"),
        ("mass", "", "bodies.brick", "[[bodies]]", "`mass` or `density`"),
        ("shape", "", "bodies.brick", "[[bodies]]", "a body without a shape needs `mass` and `inertia`"),
        ("shape", "shape.points.positions = [[0, 0, 0]]", "bodies.brick", "[[bodies]]", "needs `mass` and `inertia`"),
        ("position", "fixed = true", "bodies.brick.mass", "mass", "no meaning for a fixed body"),
        (
            "mass",
            "fixed = true\nvelocity = [1, 0, 0]",
            "bodies.brick.velocity",
            "velocity",
            "no meaning for a fixed body",
        ),
        (
            "mass",
            "mass = 1\ncenter_of_mass = [0, 0, 0.1]",
            "bodies.brick.center_of_mass",
            "center_of_mass",
            "a body with `center_of_mass` needs `inertia`",
        ),
        (
            "mass",
            "fixed = true\ncenter_of_mass = [0, 0, 0.1]",
            "bodies.brick.center_of_mass",
            "center_of_mass",
            "no meaning for a fixed body",
        ),
        ("mass", "fixed = true\nhollow = true", "bodies.brick.hollow", "hollow", "no meaning for a fixed body"),
        (
            "position",
            "orientation = [1, 0, 0, 0]\nrotation_vector = [0, 0, 1]",
            "bodies.brick.rotation_vector",
            "rotation_vector",
            "give one of them",
        ),
        ("shape", "shape.half_space.normal = [0, 0, 1]", "bodies.brick.shape", "half_space", "must be fixed"),
        ("material", "material = \"steel\"", "bodies.brick.material", "steel", "accepted: `ice`"),
    ];
    for (old, new, key, shown, message) in cases {
        check(&brick(old, new), key, shown, message);
    }
    let without_shape = brick("shape", "").replace("mass = 6.0", "density = 6.0\ninertia = [1, 1, 1]");
    check(&without_shape, "bodies.brick.density", "density", "no meaning for a body without a shape");
    let zero_normal = BASE.replace("[0, 0, 1]", "[0, 0, 0]");
    check(&zero_normal, "bodies.floor.shape.half_space.normal", "normal", "no direction");
}

/// Names: empty, twice, unknown.
#[test]
fn names() {
    check(&BASE.replace("\"brick\"", "\"floor\""), "bodies.floor.name", "floor", "two bodies are named `floor`");
    check(&BASE.replace("\"brick\"", "\"\""), "bodies.1.name", "name", "empty name");
    let group = format!("{BASE}\n[[no_contact]]\nbodies = [\"brick\", \"wall\"]\n");
    check(&group, "no_contact.0.bodies.1", "wall", "accepted: `floor`, `brick`");
    let alone = format!("{BASE}\n[[no_contact]]\nbodies = [\"brick\"]\n");
    check(&alone, "no_contact.0.bodies", "bodies", "two or more");
    let super_ball =
        |law: &str| BASE.replace("format = 1", &format!("format = 1\nmethod.tangential_restitution = {law}"));
    check(&super_ball("1.0"), "method.tangential_restitution", "tangential_restitution", "chatterjee-ruina");
    let law = "2.0\nmethod.restitution_law = \"chatterjee-ruina\"";
    check(&super_ball(law), "method.tangential_restitution", "2", "a number in [-1, 1]");
    let pair = format!("{BASE}\n[[pairs]]\nmaterials = [\"ice\", \"fire\"]\nrestitution = 0.1\n");
    check(&pair, "pairs.0.materials.1", "fire", "no material is named `fire`");
    let nameless = BASE.replace("materials.ice", "materials.\"\"").replace("\"ice\"", "\"\"");
    check(&nameless, "materials.\"\"", "materials", "a name that is not empty");
}

/// Materials out of range, in a material and in a pair.
#[test]
fn materials() {
    let restitution = |value: &str| BASE.replace("restitution = 0.5", &format!("restitution = {value}"));
    for value in ["-0.1", "1.1", "nan", "inf"] {
        check(&restitution(value), "materials.ice.restitution", "restitution", "a number in [0, 1] is needed");
    }
    let friction = |value: &str| BASE.replace("restitution = 0.5", &format!("friction = {value}"));
    check(&friction("-1"), "materials.ice.friction", "friction", "at least 0");
    check(&friction("nan"), "materials.ice.friction", "friction", "at least 0");
    let below = friction("0.3\nstatic_friction = 0.2");
    check(&below, "materials.ice.static_friction", "static_friction = 0.2", "at least its kinetic friction 0.3");
    for (key, value) in [("rolling_friction", "-0.1"), ("rolling_friction", "nan"), ("spinning_friction", "inf")] {
        let text = BASE.replace("restitution = 0.5", &format!("{key} = {value}"));
        check(&text, &format!("materials.ice.{key}"), key, "a finite length of at least 0 m is needed");
    }
    for value in ["inf", "nan"] {
        check(&friction(&format!("0.3\nstatic_friction = {value}")), "materials.ice.static_friction", value, "finite");
    }
    let pair = format!("{BASE}\n[[pairs]]\nmaterials = [\"ice\", \"ice\"]\nfriction = -0.02\n");
    check(&pair, "pairs.0.friction", "friction = -0.02", "at least 0");
    let thesis = friction("0.3").replace("format = 1", "format = 1\nmethod.tier = \"thesis\"");
    let thesis = thesis.replace("fixed = true", "fixed = true\nmaterial = \"ice\"");
    check(&thesis, "method.tier", "thesis", "has no friction: use tier `accurate`");
}

/// Friction along and across a grain that cannot be is refused at its key: numbers, directions, keys, and contacts of
/// which it is not clear whose grain counts.
#[test]
fn friction_along_a_grain() {
    let friction = |value: &str| BASE.replace("restitution = 0.5", &format!("friction = {value}"));
    let positive = "two finite positive numbers are needed";
    for numbers in ["along = -0.1, across = 0.5", "along = 0, across = 0.5", "along = 0.1, across = nan"] {
        let text = friction(&format!("{{ {numbers}, direction = [1, 0, 0] }}"));
        check(&text, "materials.ice.friction", "friction", positive);
    }
    let ratio = friction("{ along = 1e-5, across = 0.5, direction = [1, 0, 0] }");
    check(&ratio, "materials.ice.friction", "friction", "neither more than 1000 times the other");
    for direction in ["[0, 0, 0]", "[0, nan, 0]", "[0, inf, 1]"] {
        let text = friction(&format!("{{ along = 0.1, across = 0.5, direction = {direction} }}"));
        check(&text, "materials.ice.friction", "friction", "a finite vector that is not zero");
    }
    let without = friction("{ along = 0.1, across = 0.5 }");
    check(&without, "materials.ice.friction", "friction", "a finite vector that is not zero");
    let unknown = friction("{ along = 0.1, athwart = 0.5, direction = [1, 0, 0] }");
    check(&unknown, "materials.ice.friction.athwart", "athwart", "`across`");
    check(&friction("\"high\""), "materials.ice.friction", "high", "a number or a table");
    let ellipse = "{ along = 0.1, across = 0.5, direction = [1, 0, 0] }";
    let below = friction(&format!("{ellipse}\nstatic_friction = {{ along = 0.2, across = 0.4 }}"));
    check(&below, "materials.ice.static_friction", "static_friction", "at least its kinetic friction 0.5");
    let circle = friction("0.3\nstatic_friction = { along = 0.4, across = 0.5 }");
    check(&circle, "materials.ice.static_friction", "static_friction", "its friction has none");
    let pair = format!("{BASE}\n[[pairs]]\nmaterials = [\"ice\", \"ice\"]\nfriction = {ellipse}\n");
    check(&pair, "pairs.0.friction", "friction", "not clear whose grain");
}

/// The velocity of a surface has three finite components.
#[test]
fn surface_velocity() {
    let velocity = |value: &str| brick("position", &format!("position = [0, 0, 3]\nsurface_velocity = {value}"));
    check(&velocity("[0, nan, 0]"), "bodies.brick.surface_velocity.1", "surface_velocity", "a finite number");
    check(&velocity("[0, 1]"), "bodies.brick.surface_velocity", "surface_velocity", "array of length 3");
    check(&velocity("2"), "bodies.brick.surface_velocity", "surface_velocity", "array of length 3");
}

/// A key or value that the format does not have is named, with those that it has.
#[test]
fn unknown_keys_and_values() {
    check(&brick("mass", "weight = 1"), "bodies.brick.weight", "weight", "`mass`, `density`");
    check(&BASE.replace("format = 1", "format = 1\nspeed = 1"), "speed", "speed", "unknown key `speed`");
    check(&brick("shape", "shape.cube.size = [1, 1, 1]"), "bodies.brick.shape.cube", "cube", "`box`, `sphere`");
    check(&brick("shape", "shape.box.sizes = [1, 1, 1]"), "bodies.brick.shape.box.sizes", "sizes", "accepted: `size`");
    let tier = BASE.replace("name = \"base\"", "method.tier = \"quick\"");
    check(
        &tier,
        "method.tier",
        "quick",
        "accepted: `accurate`, `stepped`, `fast`, `penalty`, `micro-collisions`, `thesis`",
    );
    let integrator = BASE.replace("name = \"base\"", "method.integrator = \"rk5\"");
    check(&integrator, "method.integrator", "rk5", "accepted: `explicit-euler`, `semi-implicit-euler`");
    let number = BASE.replace("name = \"base\"", "method.integrator = 4");
    check(&number, "method.integrator", "4", "accepted: one of `explicit-euler`");
    let orientation = BASE.replace("name = \"base\"", "method.orientation = \"angles\"");
    check(&orientation, "method.orientation", "angles", "`euler-angles`");
    let pivot_elsewhere = BASE.replace("name = \"base\"", "output.pivot = 1");
    check(&pivot_elsewhere, "output.pivot", "pivot", "unknown key `pivot`");
}

/// What is designed but not built is refused as such, wherever it is asked for.
#[test]
fn planned_members() {
    let top = |line: &str| BASE.replace("name = \"base\"", line);
    let mut cases = Vec::new();
    let knobs = [("contact", &["interior-point"][..])];
    for (knob, values) in knobs {
        for value in values {
            cases.push((top(&format!("method.{knob} = \"{value}\"")), "method"));
        }
    }
    for (text, key) in cases {
        let refused = refused(&text);
        assert!(refused.place.key.starts_with(key), "{refused}");
        assert!(refused.to_string().contains("not yet available"), "{refused}");
        assert!(refused.to_string().contains("use "), "{refused}");
    }
}

/// Knobs that do not go together are refused at the knob.
#[test]
fn knobs_that_do_not_go_together() {
    let cases = [
        ("contact = \"least-force\"", "method.contact"),
        ("contact = \"least-force\"\nmethod.integrator = \"rk4\"", "method.contact"),
        ("contact = \"least-force\"\nmethod.tier = \"stepped\"", "method.contact"),
        ("contact = \"sequential-impulses\"", "method.contact"),
        ("contact = \"nncg\"", "method.contact"),
        ("contact = \"active-set\"\nmethod.tier = \"fast\"", "method.contact"),
        ("substeps = 8", "method.substeps"),
        ("integrator = \"rk4\"\nmethod.tier = \"fast\"", "method.integrator"),
        ("integrator = \"rk4\"\nmethod.tier = \"stepped\"", "method.integrator"),
        ("response = \"impulse\"\nmethod.tier = \"accurate\"", "method.response"),
        ("response = \"constraint\"\nmethod.tier = \"micro-collisions\"", "method.response"),
        ("collision_envelope = 0.001", "method.collision_envelope"),
        ("contact = \"heuristic\"", "method.contact"),
        ("contact = \"guesses\"\nmethod.tier = \"stepped\"", "method.contact"),
        ("propagation_order = \"depth\"", "method.propagation_order"),
        ("pulse_exponent = \"linear\"\nmethod.impact = \"poisson\"", "method.pulse_exponent"),
        ("response = \"impulse-projection\"\nmethod.tier = \"stepped\"", "method.response"),
        ("response = \"impulse-unconditional\"\nmethod.integrator = \"rk4\"", "method.response"),
        ("response = \"penalty\"\nmethod.tier = \"accurate\"", "method.response"),
        ("response = \"constraint\"\nmethod.tier = \"penalty\"", "method.response"),
        ("penalty.law = \"linear\"", "method.penalty"),
        ("penalty.law = \"linear\"\nmethod.tier = \"stepped\"", "method.penalty"),
        ("orientation = \"matrix\"", "method.orientation"),
        ("orientation = \"quaternion\"\nmethod.integrator = \"rkmk4\"", "method.orientation"),
        ("rotation_rate = \"angular-velocity\"", "method.rotation_rate"),
        (
            "tier = \"thesis\"\nmethod.integrator = \"exact\"\nmethod.rotation_rate = \"angular-momentum\"",
            "method.rotation_rate",
        ),
    ];
    for (knobs, key) in cases {
        let refused = refused(&BASE.replace("name = \"base\"", &format!("method.{knobs}")));
        assert_eq!(refused.place.key, key, "{refused}");
        assert!(refused.to_string().contains("not yet available"), "{refused}");
    }
}

/// An integrator that splits forces from motion takes no drag and no damper, and is refused where it is asked for.
#[test]
fn integrators_that_take_no_velocities() {
    let forces = [
        "type.drag = { law = \"linear\", translational = 1 }",
        "type.spring = { body = \"brick\", anchor = [0, 0, 0], stiffness = 1, damping = 1 }",
    ];
    for force in forces {
        let with = |name: &str| {
            let method = format!("method.integrator = \"{name}\"");
            format!("{}\n[[forces]]\n{force}\n", BASE.replace("name = \"base\"", &method))
        };
        for name in ["exact", "splitting-4", "moser-veselov", "implicit-midpoint"] {
            check(&with(name), "method.integrator", name, "depends on velocities");
        }
        for name in ["rk4", "cf4", "dop853", "implicit-gyroscopic"] {
            crate::scene(&with(name));
        }
    }
}

/// Values of the wrong type or length say what is needed.
#[test]
fn types() {
    check(&brick("mass", "mass = \"heavy\""), "bodies.brick.mass", "heavy", "accepted: a number");
    check(&brick("shape", "shape = \"box\""), "bodies.brick.shape", "shape", "shape.box.size");
    check(&brick("shape", "shape.box = 1"), "bodies.brick.shape.box", "shape", "accepted: a table");
    check(&brick("shape", "shape.box.size = [1, 2]"), "bodies.brick.shape.box.size", "size", "an array of length 3");
    let two = "shape.box.size = [1, 1, 1]\nshape.sphere.radius = 1";
    check(&brick("shape", two), "bodies.brick.shape", "shape", "exactly one");
    check(&brick("shape", "shape = {}"), "bodies.brick.shape", "shape", "exactly one");
    check(&brick("position", "inertia = [1, [1, 2, 3], 3]"), "bodies.brick.inertia", "inertia", "three rows");
    check(&brick("position", "inertia = [1, 2, 3, 4]"), "bodies.brick.inertia", "inertia", "three moments");
    check(&brick("position", "inertia = 3"), "bodies.brick.inertia", "inertia", "three moments");
    check(&BASE.replace("format = 1", "format = 2"), "format", "format = 2", "accepted: 1");
    check(&BASE.replace("format = 1", ""), "", "", "missing key `format`");
    check(&BASE.replace("name = \"brick\"", ""), "bodies.1", "[[bodies]]", "missing key `name`");
    check("format = 1\n[[bodies]]\nmass = 1\n", "bodies.0", "[[bodies]]", "missing key `name`");
    assert!(matches!(refused("bodies = 3\nformat = 1").cause, Refusal::Type { .. }));
}

/// Text that is not TOML is refused with its line; nesting without end is no way to overflow the stack.
#[test]
fn syntax() {
    let refused_at = |text: &str| refused(text).place;
    assert_eq!(refused_at("format = 1\nname = = 2\n").line, 2);
    assert_eq!(refused_at("format = 1\nformat = 1\n").line, 2);
    assert!(matches!(refused("{{{{").cause, Refusal::Syntax(_)));
    let deep = format!("format = 1\na = {}", "[".repeat(100_000));
    assert!(matches!(refused(&deep).cause, Refusal::Syntax(_)));
    assert_eq!(refused_at("").line, 1);
}

/// A line without end is shown in part, and its column is still the true one.
#[test]
fn long_lines() {
    let points = "[0, 0, 0], ".repeat(20_000);
    let text = format!("format = 1\n[[bodies]]\nname = \"cloud\"\nshape.points.positions = [{points}[0, 0]]\n");
    let refused = refused(&text);
    assert_eq!((refused.place.line, refused.place.column), (4, 27 + points.len()));
    assert!(refused.to_string().len() < 1000, "{refused}");
    assert!(refused.to_string().contains("[0, 0]]"), "{refused}");
}

/// Errors name characters, not bytes, as columns, and stand lines that hold any character.
#[test]
fn characters() {
    let refused = refused("format = 1\nname = \"äöü\u{1F600}\"; x");
    assert_eq!((refused.place.line, refused.place.column), (2, 14), "{refused}");
}

/// A missing mesh is a fault of input, a mesh that is none a fault of the scene; both name the key.
#[test]
fn meshes() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("garbage.obj", "v 0 0 zero\n");
    write("flat.step", "ISO-10303-21;\n");
    write("cut.stl", &format!("{:80}\u{7}\0\0\0broken", "solid"));
    write("cut.off", "OFF\n8 12 0\n0 0 0");
    write("l.obj", include_str!("../../../../fixtures/meshes/l-shape.obj"));
    let load_shape = |shape: &str| {
        write("scene.toml", &brick("shape", shape));
        load(&path).unwrap_err()
    };
    let missing = load_shape("shape.mesh.file = \"missing.obj\"");
    assert!(missing.is_input_output());
    assert!(missing.to_string().contains("bodies.brick.shape.mesh.file"), "{missing}");
    for (shape, message) in [
        ("shape.mesh.file = \"flat.obj\"", "open edges"),
        ("shape.mesh.file = \"garbage.obj\"", "line 1: 'zero' is not a number"),
        ("shape.mesh.file = \"flat.step\"", "this is no mesh file: accepted are OBJ, STL, OFF, PLY"),
        ("shape.mesh.file = \"cut.stl\"", "byte 90: the file ends after 0 of 7 triangles"),
        ("shape.mesh.file = \"cut.off\"", "line 3: the file ends after 1 of 8 vertices"),
        ("shape.convex.file = \"l.obj\"", "not convex"),
    ] {
        let error = load_shape(shape);
        assert!(!error.is_input_output());
        assert!(error.to_string().contains(message), "{error}");
        assert!(error.to_string().contains("scene.toml:"), "{error}");
    }
    // An open surface is ground, and only that.
    let ground = "format = 1\n[[bodies]]\nname = \"a\"\nfixed = true\nshape.mesh.file = \"flat.obj\"\n";
    write("scene.toml", ground);
    assert!(load(&path).is_ok());
}

/// Files that are missing, folders, too large or no text give typed errors at once.
#[test]
fn files() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    assert!(matches!(load(&path).unwrap_err(), SceneFileError::Read { .. }));
    assert!(load(folder.path()).unwrap_err().is_input_output());
    std::fs::write(&path, b"format = 1\nname = \"\xff\"\n").unwrap();
    assert!(matches!(load(&path).unwrap_err(), SceneFileError::NotText { line: 2, offset: 19, .. }));
    let file = std::fs::File::create(&path).unwrap();
    file.set_len(100 << 20).unwrap();
    let started = Instant::now();
    assert!(matches!(load(&path).unwrap_err(), SceneFileError::TooLarge { .. }));
    assert!(started.elapsed() < Duration::from_secs(5));
}

/// Errors that the engine finds later are shown at the body they are about.
#[test]
fn errors_of_the_engine() {
    let loaded = load_text("test.toml", BASE, &[]).unwrap();
    let pair = polhode::scene::OverlapAtStart {
        body_a: "floor".to_owned(),
        body_b: "brick".to_owned(),
        depth_m: 0.1,
        allowed_m: 1e-9,
    };
    let error = loaded.explain(polhode::SceneError::InitialOverlap(vec![pair]));
    assert_eq!(error.refused().unwrap().place.key, "bodies.brick");
    assert!(error.to_string().contains("overlap by 0.1 m"), "{error}");
}

/// What is wrong with a joint is said where it stands in the file, with what is accepted.
#[test]
fn joints_that_cannot_hold() {
    let hinge = |bodies: &str, axis: &str| format!("type.hinge = {{ bodies = {bodies}, anchor = [0, 0, 0]{axis} }}");
    let rough = |friction: &str| {
        hinge("[\"brick\"]", &format!(", axis = [0, 0, 1], angle = {{ friction = {{ {friction} }} }}"))
    };
    let friction = "joints.0.type.hinge.angle.friction";
    let slider = "type.slider = { bodies = [\"brick\"], anchor = [0, 0, 0], axis = [0, 0, 1], displacement = { \
                  friction = { coefficient = 0.2, radius = 0.1 } } }";
    let cases = [
        (rough("effort = 0"), friction, "above 0"),
        (rough("effort = 1, breakaway = 0.5"), friction, "at least the effort"),
        (rough("breakaway = 0.5"), friction, "missing key `effort`"),
        (rough("coefficient = 0.1"), friction, "missing key `radius`"),
        (rough("coefficient = -0.1, radius = 0.02"), friction, "at least 0"),
        (rough("effort = 1, radius = 0.02"), "joints.0.type.hinge.angle.friction.radius", "without `coefficient`"),
        (rough("coefficient = 0.1, radius = 0.02, breakaway = 2"), friction, "without `effort`"),
        (slider.to_owned(), "joints.0.type.slider.displacement.friction.radius", "no angle"),
        (hinge("[\"brik\"]", ", axis = [0, 0, 1]"), "joints.0.type.hinge.bodies.0", "brick"),
        (hinge("[]", ", axis = [0, 0, 1]"), "joints.0.type.hinge.bodies", "the names of two bodies"),
        (hinge("[\"brick\", \"brick\"]", ", axis = [0, 0, 1]"), "joints.0.type.hinge.bodies.1", "brick"),
        (hinge("[\"brick\"]", ", axis = [0, 0, 0]"), "joints.0.type.hinge.axis", "0"),
        (hinge("[\"brick\"]", ""), "joints.0.type.hinge", "missing key `axis`"),
        ("type.spring = { bodies = [\"brick\"] }".to_owned(), "joints.0.type", "ball"),
        ("type.slider = { bodies = [\"brick\"] }".to_owned(), "joints.0.type.slider", "missing key `anchor`"),
        ("type = 3".to_owned(), "joints.0.type", "a joint"),
    ];
    for (joint, key, message) in cases {
        let refused = refused(&format!("{BASE}\n[[joints]]\n{joint}\n"));
        assert!(refused.place.key.starts_with(key) && refused.to_string().contains(message), "{joint}: {refused}");
    }
}

/// What is wrong with a track, or with a joint on one, is said where it stands in the file, with what is accepted.
#[test]
fn tracks_that_cannot_be_followed() {
    let ring = "curve.circle = { center = [0, 0, 0], axis = [0, 1, 0], radius = 1 }";
    let on_ring = "type.track = { bodies = [\"brick\"], track = \"t\", anchor = [0, 0, 1]";
    let curve = |curve: &str| (format!("name = \"t\"\n{curve}"), String::new());
    let joint = |rest: &str| (format!("name = \"t\"\n{ring}"), format!("{on_ring}{rest} }}"));
    let cases = [
        (
            curve("curve.circle = { center = [0, 0, 0], axis = [0, 1, 0], radius = 0 }"),
            "tracks.0.curve.circle",
            "above 0",
        ),
        (curve("curve.line = { points = [[1, 0, 0], [1, 0, 0]] }"), "tracks.0.curve.line", "at one place"),
        (
            curve("curve.spline = { points = [[0, 0, 0], [1, 0, 0], [1, 0, 0]] }"),
            "tracks.0.curve.spline",
            "points 1 and 2",
        ),
        (
            curve("curve.path = { start = [0, 0, 0], heading = [1, 0, 0], up = [1, 0, 0], parts = [{ length = 1 }] }"),
            "tracks.0.curve.path",
            "parallel",
        ),
        (
            curve("curve.path = { start = [0, 0, 0], heading = [1, 0, 0], up = [0, 0, 1], parts = [{ radius = 1 }] }"),
            "tracks.0.curve.path.parts.0",
            "missing key `angle`",
        ),
        (
            curve(
                "curve.path = { start = [0, 0, 0], heading = [1, 0, 0], up = [0, 0, 1], parts = [{ radius = 1, length \
                 = 1 }] }",
            ),
            "tracks.0.curve.path.parts.0.radius",
            "cannot both",
        ),
        (curve("curve.spiral = { radius = 1 }"), "tracks.0.curve", "circle"),
        (curve("curve = 3"), "tracks.0.curve", "a curve"),
        (
            ("name = \"\"\ncurve.line = { points = [[0, 0, 0], [1, 0, 0]] }".to_owned(), String::new()),
            "tracks.0.name",
            "a name of its own",
        ),
        (joint(", restitution = 0.5"), "joints.0.type.track.restitution", "without a `side`"),
        (joint(", side = [0, 0, 1], springs = { stiffness = 1 }"), "joints.0.type.track.springs", "cannot both"),
        (joint(", side = [0, 0, 1], follows = \"frame\""), "joints.0.type.track.follows", "two points"),
        (joint(", up = [0, 0, 1]"), "joints.0.type.track.up", "frame"),
        (joint(", ends = \"soft\""), "joints.0.type.track.ends", "stops"),
        (joint(", springs = { stiffness = 0 }"), "joints.0", "stiffness"),
        (
            (format!("name = \"u\"\n{ring}"), format!("{on_ring} }}")),
            "joints.0.type.track.track",
            "no track is named `t`",
        ),
        (
            (format!("name = \"t\"\n{ring}"), format!("{on_ring} }}").replace("[0, 0, 1]", "[0, 0, 1.003]")),
            "joints.0",
            "off its track, 3 mm",
        ),
    ];
    for ((track, joint), key, message) in cases {
        let joint = if joint.is_empty() { joint } else { format!("[[joints]]\n{joint}\n") };
        let refused = refused(&format!("{BASE}\n[[tracks]]\n{track}\n{joint}"));
        let is_told = refused.place.key.starts_with(key) && refused.to_string().contains(message);
        assert!(is_told, "{track} {joint}: {} {refused}", refused.place.key);
    }
}

/// Restitution that depends on speed: one law at a time, with a coefficient, and none that rises with speed.
#[test]
fn restitution_by_speed() {
    let with = |lines: &str| BASE.replace("restitution = 0.5", lines);
    assert_ne!(with(""), BASE);
    for (lines, key) in [
        ("restitution = 0.5\nrestitution_slope = -0.1", "materials.ice.restitution_slope"),
        ("restitution = 0.5\nrestitution_yield_speed = 0.0", "materials.ice.restitution_yield_speed"),
        ("restitution_yield_speed = 1.0", "materials.ice.restitution_yield_speed"),
        (
            "restitution = 0.5\nrestitution_slope = 0.1\nrestitution_yield_speed = 1.0",
            "materials.ice.restitution_slope",
        ),
    ] {
        let refused = refused(&with(lines));
        assert_eq!(refused.place.key, key, "{refused}");
    }
}

/// A scene says how the error of its run is estimated; another word is refused with the three that are accepted.
#[test]
fn estimations_of_the_error() {
    for estimation in ErrorEstimation::ALL {
        let text = BASE.replace("name = \"base\"", &format!("method.error = \"{}\"", estimation.name()));
        assert_eq!(crate::scene(&text).method().error, Some(estimation));
        assert_eq!(Simulation::new(&crate::scene(&text)).unwrap().error_estimation(), estimation);
    }
    assert_eq!(Simulation::new(&crate::scene(BASE)).unwrap().error_estimation(), ErrorEstimation::Quick);
    let refused = refused(&BASE.replace("name = \"base\"", "method.error = \"best\""));
    assert_eq!(refused.place.key, "method.error");
    for part in ["best", "off", "quick", "full"] {
        assert!(refused.to_string().contains(part), "{refused}");
    }
}

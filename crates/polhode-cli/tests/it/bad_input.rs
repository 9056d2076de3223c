//! What happens to input that is wrong: exit code 2 (or 3 where files cannot be read), and words that say what is
//! wrong, at once. No panic, and nothing is lost: a file that stood under the name of an output stands there as before.
//!
//! Each case is a command and the words that its message must hold. `scene.toml` is a good scene of a stone and a
//! floor.

use crate::Place;

/// A good scene, small enough to be changed by a word.
const GOOD: &str = r#"format = 1
name = "good"
duration = 0.1

[materials.stone]
friction = 0.0

[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]
material = "stone"

[[bodies]]
name = "brick"
shape.box.size = [1, 1, 1]
mass = 2.0
position = [0, 0, 2]
material = "stone"

[[forces]]
type.spring = { body = "brick", anchor = [0, 0, 4], stiffness = 4, rest_length = 2 }
"#;

/// A scene in which one piece of text is replaced: the piece, what stands in its place, and words of the message.
type Change = (&'static str, &'static str, &'static [&'static str]);

const SCENES: &[Change] = &[
    // The document.
    ("format = 1", "", &["missing key `format`"]),
    ("format = 1", "format = 7", &["version 7", "accepted: 1"]),
    ("format = 1", "format = -1", &["format"]),
    ("format = 1", "format = \"1\"", &["is not accepted here"]),
    ("format = 1", "format = 1\nformat = 1", &["not TOML", "duplicate"]),
    ("name = \"good\"", "name = 3", &["is not accepted here", "string"]),
    ("name = \"good\"", "name = \"good", &["not TOML"]),
    ("name = \"good\"", "nmae = \"good\"", &["unknown key `nmae`", "did you mean `name`?"]),
    ("duration = 0.1", "duraton = 0.1", &["did you mean `duration`?"]),
    ("duration = 0.1", "duration = 0", &["0 is not accepted", "positive"]),
    ("duration = 0.1", "duration = -1", &["-1 is not accepted"]),
    ("duration = 0.1", "duration = nan", &["NaN is not accepted"]),
    ("duration = 0.1", "duration = inf", &["inf is not accepted"]),
    ("duration = 0.1", "duration = 1e300", &["duration = 1e300 s", "shorten the duration"]),
    ("duration = 0.1", "duration = \"long\"", &["is not accepted here", "a number"]),
    ("duration = 0.1", "duration = [0.1]", &["is not accepted here"]),
    ("duration = 0.1", "gravity = [0, 0]", &["length 2", "length 3"]),
    ("duration = 0.1", "gravity = -9.81", &["an array"]),
    ("duration = 0.1", "gravity = [0, 0, nan]", &["finite number"]),
    ("duration = 0.1", "[output]\ninterval = 0", &["key `output.interval`"]),
    ("duration = 0.1", "[output]\nintervall = 1", &["did you mean `interval`?"]),
    ("duration = 0.1", "[output]\ninterval = 1e-300", &["key `output.interval`", "1e12"]),
    ("duration = 0.1", "[start]\nseparate = -1", &["-1 is not accepted", "at least 0"]),
    ("duration = 0.1", "[start]\nseperate = 1e-6", &["did you mean `separate`?"]),
    ("duration = 0.1", "[method]\ntier = \"acurate\"", &["did you mean `accurate`?"]),
    ("duration = 0.1", "[method]\ncontact = \"interior-point\"", &["not yet available"]),
    ("duration = 0.1", "[method]\nsubsteps = 0", &["method.substeps"]),
    ("duration = 0.1", "[method]\nstep = 0", &["method.step"]),
    ("duration = 0.1", "[method]\nstep = 1e-300", &["method.step = 1e-300 s", "lengthen the step"]),
    ("duration = 0.1", "[method]\nintegrator = \"rk5\"", &["unknown value `rk5`", "did you mean `rk4`?"]),
    ("duration = 0.1", "[method]\ntolerance = -1", &["tolerance"]),
    ("duration = 0.1", "[method]\ntolerance = nan", &["tolerance"]),
    ("duration = 0.1", "[metod]\nstep = 1", &["did you mean `method`?"]),
    ("duration = 0.1", "[joints]", &["joints"]),
    ("duration = 0.1", "= 3", &["not TOML"]),
    ("duration = 0.1", "]]]]", &["not TOML"]),
    ("duration = 0.1", "\"\\u0007\" = 1", &["unknown key"]),
    // Materials.
    ("friction = 0.0", "friction = -1", &["friction of material stone is -1"]),
    ("friction = 0.0", "fricton = 0", &["did you mean `friction`?"]),
    ("friction = 0.0", "restitution = 2", &["restitution of material stone is 2"]),
    ("friction = 0.0", "restitution = nan", &["restitution"]),
    ("friction = 0.0", "friction = 1\nstatic_friction = 0.5", &["static friction"]),
    ("[materials.stone]", "[materials.\"\"]", &["an empty name"]),
    ("[materials.stone]", "[materials.stones]", &["no material is named `stone`", "did you mean `stones`?"]),
    ("[materials.stone]", "[[pairs]]\nmaterials = [\"stone\"]\n[materials.stone]", &["length"]),
    (
        "[materials.stone]",
        "[[pairs]]\nmaterials = [\"stone\", \"ston\"]\n[materials.stone]",
        &["did you mean `stone`?"],
    ),
    // Bodies.
    ("name = \"brick\"", "name = \"floor\"", &["two bodies are named `floor`"]),
    ("name = \"brick\"", "name = \"\"", &["empty name"]),
    ("name = \"brick\"", "", &["missing key `name`"]),
    ("name = \"brick\"", "name = \"brik\"", &["no body is named `brick`", "did you mean `brik`?"]),
    ("mass = 2.0", "", &["needs `mass` or `density`"]),
    ("mass = 2.0", "mass = 2.0\nfriction = 0.5", &["is a key of a material: write it below [materials.NAME]"]),
    ("mass = 2.0", "mass = 0", &["mass must be a positive number"]),
    ("mass = 2.0", "mass = -1", &["found -1"]),
    ("mass = 2.0", "mass = nan", &["found NaN"]),
    ("mass = 2.0", "mass = inf", &["found inf"]),
    ("mass = 2.0", "mass = \"2 kg\"", &["string", "a number"]),
    ("mass = 2.0", "mas = 2.0", &["did you mean `mass`?"]),
    ("mass = 2.0", "mass = 2.0\ndensity = 3", &["cannot both be given"]),
    ("mass = 2.0", "density = 0", &["density"]),
    ("mass = 2.0", "mass = 2.0\ninertia = [1, 1, 9]", &["inertia"]),
    ("mass = 2.0", "mass = 2.0\ninertia = [1, 1]", &["inertia"]),
    ("mass = 2.0", "mass = 2.0\ninertia = [-1, 1, 1]", &["inertia"]),
    ("mass = 2.0", "fixed = true\nmass = 2.0", &["`mass` has no meaning for a fixed body"]),
    ("mass = 2.0", "fixed = \"yes\"\nmass = 2.0", &["is not accepted here"]),
    ("position = [0, 0, 2]", "position = [0, 0]", &["length 2"]),
    ("position = [0, 0, 2]", "position = [0, 0, \"up\"]", &["a number"]),
    ("position = [0, 0, 2]", "position = [0, 0, nan]", &["finite"]),
    ("position = [0, 0, 2]", "position = [0, 0, 0]", &["floor and brick overlap by", "move them apart"]),
    ("position = [0, 0, 2]", "position = [0, 0, 0.4999999]", &["overlap", "--set start.separate=1.1e-7"]),
    ("position = [0, 0, 2]", "orientation = [0, 0, 0, 0]", &["orientation"]),
    ("position = [0, 0, 2]", "orientation = [2, 0, 0, 0]", &["orientation"]),
    ("position = [0, 0, 2]", "orientation = [1, 0, 0]", &["length 3"]),
    ("position = [0, 0, 2]", "orientation = [1, 0, 0, 0]\nrotation_vector = [0, 0, 1]", &["cannot both be given"]),
    ("position = [0, 0, 2]", "velocity = [0, 0, inf]", &["finite"]),
    ("position = [0, 0, 2]", "angular_velocity = [0, 0]", &["length 2"]),
    ("position = [0, 0, 2]", "velocty = [0, 0, 1]", &["did you mean `velocity`?"]),
    ("position = [0, 0, 2]", "pivot = [0]", &["length 1"]),
    ("position = [0, 0, 2]", "motion.constant.speed = 3", &["motion"]),
    // Shapes.
    ("shape.box.size = [1, 1, 1]", "shape.box.size = 1", &["an array of length 3"]),
    ("shape.box.size = [1, 1, 1]", "shape.box.size = [1, 1]", &["length 2"]),
    ("shape.box.size = [1, 1, 1]", "shape.box.size = [1, 1, 0]", &["0"]),
    ("shape.box.size = [1, 1, 1]", "shape.box.size = [1, 1, -1]", &["-1"]),
    ("shape.box.size = [1, 1, 1]", "shape.box.siez = [1, 1, 1]", &["did you mean `size`?"]),
    ("shape.box.size = [1, 1, 1]", "shape.boks.size = [1, 1, 1]", &["did you mean `box`?"]),
    ("shape.box.size = [1, 1, 1]", "shape = \"box\"", &["shape"]),
    ("shape.box.size = [1, 1, 1]", "shape = {}", &["a shape is exactly one of the kinds"]),
    (
        "shape.box.size = [1, 1, 1]",
        "shape.box.size = [1, 1, 1]\nshape.sphere.radius = 1",
        &["exactly one of the kinds"],
    ),
    ("shape.box.size = [1, 1, 1]", "shape.sphere.radius = 0", &["positive"]),
    ("shape.box.size = [1, 1, 1]", "shape.sphere.radius = nan", &["NaN"]),
    ("shape.box.size = [1, 1, 1]", "shape.torus = { major = 0.1, minor = 0.5 }", &["torus"]),
    ("shape.box.size = [1, 1, 1]", "shape.half_space.normal = [0, 0, 1]", &["half-space"]),
    ("shape.box.size = [1, 1, 1]", "shape.compound.parts = []", &["compound"]),
    ("shape.box.size = [1, 1, 1]", "shape.convex.file = \"scene.toml\"", &["no mesh file"]),
    ("normal = [0, 0, 1]", "normal = [0, 0, 0]", &["normal"]),
    // Forces.
    ("body = \"brick\", anchor", "body = \"floor\", anchor", &["a spring needs a body that moves"]),
    ("body = \"brick\", anchor", "body = \"bric\", anchor", &["did you mean `brick`?"]),
    ("stiffness = 4", "stiffness = -4", &["-4"]),
    ("stiffness = 4", "stifness = 4", &["did you mean `stiffness`?"]),
    ("stiffness = 4, ", "", &["missing key `stiffness`"]),
    ("type.spring", "type.sprng", &["did you mean `spring`?"]),
    ("type.spring", "kind.spring", &["unknown key `kind`"]),
    ("[[forces]]", "[forces]", &["is not accepted here"]),
    ("[[forces]]", "[[no_contact]]\nbodies = [\"brick\"]\n[[forces]]", &["names of two or more bodies"]),
    ("[[forces]]", "[[no_contact]]\nbodies = [\"brick\", \"flor\"]\n[[forces]]", &["did you mean `floor`?"]),
];

/// Every scene that is wrong is refused at its place by `check`, within a message of one screen.
#[test]
fn scenes_that_are_wrong() {
    let place = Place::new();
    for (piece, other, words) in SCENES {
        assert!(GOOD.contains(piece), "{piece}");
        place.write("scene.toml", &GOOD.replacen(piece, other, 1));
        let run = place.expect(2, &["check", "scene.toml"]);
        for word in *words {
            assert!(run.stderr.contains(word), "{other}: {word} is not in\n{}", run.stderr);
        }
        assert!(run.stderr.contains("--> scene.toml:") && run.stderr.len() < 3000, "{other}\n{}", run.stderr);
    }
}

/// Commands on the good scene: exit code, arguments, words of the message.
type Case = (i32, &'static [&'static str], &'static str);

const COMMANDS: &[Case] = &[
    (2, &["rum", "scene.toml"], "unrecognized subcommand 'rum'"),
    (2, &["run"], "SCENE"),
    (3, &["run", "missing.toml"], "cannot read missing.toml"),
    (3, &["run", "."], "cannot read ."),
    (2, &["run", "example:diamnd-4"], "did you mean example:diamond-4?"),
    (2, &["run", "example:"], "`polhode scenes` lists them"),
    (2, &["run", "scene.toml", "--sed", "a=1"], "--sed"),
    (2, &["run", "scene.toml", "--set", "duration"], "not of the form KEY=VALUE"),
    (2, &["run", "scene.toml", "--set", "=3"], "cannot be set"),
    (2, &["run", "scene.toml", "--set", "duration="], "cannot be set"),
    (2, &["run", "scene.toml", "--set", "bodies.brik.mass=3"], "no element `brik`"),
    (2, &["run", "scene.toml", "--set", "bodies.7.mass=3"], "no element `7`"),
    (2, &["run", "scene.toml", "--set", "bodies.brick.mas=3"], "did you mean `mass`?"),
    (2, &["run", "scene.toml", "--set", "name.x=3"], "is a single value and has no keys"),
    (2, &["run", "scene.toml", "--tier", "quick"], "unknown value `quick`"),
    (2, &["run", "scene.toml", "--step", "fast"], "is not accepted here"),
    (2, &["run", "scene.toml", "--duration", "1e300"], "shorten the duration"),
    (2, &["run", "scene.toml", "--effects", "some"], "invalid value 'some'"),
    (2, &["run", "scene.toml", "-o", "a.txt"], "unknown ending"),
    (2, &["run", "scene.toml", "-o", "scene.toml"], "an output never replaces it"),
    (2, &["run", "scene.toml", "--events", "scene.toml"], "an output never replaces it"),
    (2, &["run", "scene.toml", "--events", "-"], "only trajectories go to stdout"),
    (
        2,
        &["run", "scene.toml", "--events", "a.json"],
        "events, joints and contacts are written as CSV: name a file that ends in .csv",
    ),
    (2, &["run", "scene.toml", "-o", "-", "--json"], "both want stdout"),
    (2, &["run", "scene.toml", "-o", "-", "-o", "-"], "is named twice"),
    (2, &["run", "scene.toml", "-o", "a.csv", "-o", "./a.csv"], "is named twice"),
    (3, &["run", "scene.toml", "-o", "no/folder/a.csv"], "cannot write no/folder/a.csv"),
    (2, &["run", "scene.toml", "--plot", "energy"], "no file is named for the plots"),
    (2, &["run", "scene.toml", "--checkpoint-every", "-1"], "a positive number of seconds"),
    (2, &["run", "scene.toml", "--accuracy", "0"], "a positive number"),
    (2, &["run", "-q", "-v", "scene.toml"], "cannot be used with"),
    (3, &["resume", "missing"], "cannot read missing"),
    (2, &["resume", "scene.toml"], "is no checkpoint"),
    (2, &["cost", "scene.toml", "--target", "0"], "a positive number"),
    (1, &["cost", "scene.toml", "--vary", "method.step=-1,-2"], "none of the 2 candidates ran"),
    (2, &["cost", "scene.toml", "--csv", "scene.toml"], "an output never replaces it"),
    (2, &["cost", "scene.toml", "--samples", "0"], "--samples"),
    (2, &["mesh", "scene.toml"], "no mesh file"),
    (3, &["mesh", "missing.obj"], "cannot read missing.obj"),
    (2, &["mesh", "cube.obj", "-o", "cube.obj"], "an output never replaces it"),
    (2, &["mesh", "cube.obj", "--mass", "-1"], "mass"),
    (2, &["mesh", "cube.obj", "--density", "nan"], "density"),
    (2, &["mesh", "bad.obj"], "bad.obj"),
    (2, &["compare", "a.csv"], "<B>"),
    (3, &["compare", "missing.csv", "kept.csv"], "cannot read missing.csv"),
    (2, &["compare", "kept.csv", "kept.csv"], "kept.csv"),
    (2, &["view", "kept.csv"], "name its scene too"),
    (2, &["view", "scene.toml", "-o", "a.bmp"], "unknown ending"),
    (2, &["view", "scene.toml", "--fps", "0"], "a positive number of frames"),
    (2, &["view", "scene.toml", "--size", "big", "-o", "a.png"], "not of the form WxH"),
    (2, &["view", "scene.toml", "--still", "t=9"], "the motion is from t = 0 s to"),
    (2, &["new", "scene"], "is there already"),
    (2, &["new", "scene.toml", "--from", "diamond-4"], "is there already"),
    (2, &["new", "mine", "--from", "nothing-like-it"], "no example is named `nothing-like-it`"),
    (3, &["new", "no/folder/mine"], "cannot write"),
    (2, &["new", ".."], "this names no scene"),
    (2, &["new", "a/.."], "this names no scene"),
    (2, &["new", ""], "this names no scene"),
    (2, &["new", "mine", "--from", "example:"], "`polhode scenes` lists them"),
    (3, &["new", "scene.toml/mine"], "cannot write scene.toml/mine.toml"),
    (2, &["completions", ""], "possible values: bash"),
    (2, &["schema", "extra"], "unexpected argument 'extra'"),
    (2, &["scenes", "extra"], "unexpected argument 'extra'"),
    (2, &["plan", "-"], "missing key `format`"),
    (2, &["check", "empty.toml"], "missing key `format`"),
    (2, &["check", "bytes.toml"], "is not UTF-8"),
    (3, &["check", "scene.toml/"], "cannot read scene.toml/"),
    (2, &["check", ""], "a value is required"),
    (2, &["run", "scene.toml", "-o", ""], "a value is required"),
    (2, &["run", "scene.toml", "-o", ".csv"], "unknown ending"),
    (2, &["run", "scene.toml", "-o", "/dev/full"], "unknown ending"),
    (3, &["run", "scene.toml", "-o", "kept.csv/b.csv"], "cannot write kept.csv/b.csv"),
    (2, &["run", "scene.toml", "-o", "a.csv", "--events", "a.csv"], "is named twice"),
    (2, &["run", "scene.toml", "--duration", "-0"], "0 is not accepted"),
    (2, &["run", "scene.toml", "--accuracy", "nan"], "a positive number"),
    (2, &["run", "scene.toml", "--checkpoint", "kept.csv"], "is no checkpoint: give another file"),
    (2, &["run", "scene.toml", "--plot", "heat", "-o", "a.svg"], "`heat` names no quantity"),
    (2, &["resume", "kept.csv", "-o", "kept.csv"], "is no checkpoint"),
    (2, &["resume", "scene.toml", "--tier", "thesis"], "unexpected argument '--tier'"),
    (2, &["cost", "scene.toml", "--budget", "nan"], "a positive number"),
    (2, &["cost", "scene.toml", "--target", "nan"], "a positive number"),
    (2, &["cost", "scene.toml", "--samples", "4294967295"], "--samples"),
    (2, &["cost", "scene.toml", "--vary", "method.step="], "a key or a value is empty"),
    (2, &["cost", "scene.toml", "--html", "scene.toml"], "an output never replaces it"),
    (2, &["mesh", "empty.toml"], "no mesh file"),
    (2, &["mesh", "cube.obj", "--scale", "0"], "positive, finite factor"),
    (2, &["mesh", "cube.obj", "--monte-carlo", "0"], "at least 2 points"),
    (2, &["mesh", "cube.obj", "--repair", "--weld-tolerance", "nan"], "found NaN m"),
    (2, &["mesh", "cube.obj", "--repair", "--largest-hole", "-1"], "from 0 to 1"),
    (2, &["mesh", "cube.obj", "-o", "a.xyz"], "names its format"),
    (2, &["mesh", "cube.obj", "-o", "a.obj", "--encoding", "binary"], "no binary encoding"),
    (2, &["compare", "kept.csv", "kept.csv", "--atol", "nan"], "a tolerance is NaN"),
    (2, &["compare", "kept.csv", "kept.csv", "-o", "kept.csv"], "unknown ending"),
    (2, &["view", "scene.toml", "--camera", "nowhere", "-o", "a.png"], "not of the form X,Y,Z"),
    (2, &["view", "scene.toml", "--size", "0x0", "-o", "a.png"], "1 to 8192 pixels"),
    (2, &["view", "scene.toml", "--still", "t=1e400", "-o", "a.png"], "the motion is from t = 0 s to"),
    (2, &["view", "scene.toml", "--beside", "method.step=0", "-o", "a.html"], "0 is not accepted"),
    (2, &["view", "scene.toml", "--beside", "nonsense", "-o", "a.html"], "not of the form KEY=VALUE"),
    (2, &["completions", "tcsh"], "invalid value 'tcsh'"),
];

/// Every command that is wrong says why, and no file changes.
#[test]
fn commands_that_are_wrong() {
    let place = Place::with_scene(GOOD);
    place.write("cube.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    place.write("bad.obj", "v 0 0 zero\nf 1 2 3\n");
    place.write("kept.csv", "mine\n");
    place.write("empty.toml", "");
    std::fs::write(place.path("bytes.toml"), [0xff, 0xfe]).unwrap();
    let before = place.list();
    for (code, args, word) in COMMANDS {
        let run = place.expect(*code, args);
        assert!(run.stderr.contains(word), "{args:?}: {word} is not in\n{}", run.stderr);
    }
    assert_eq!(place.list(), before);
    assert_eq!((place.read("scene.toml").as_str(), place.read("kept.csv").as_str()), (GOOD, "mine\n"));
}

/// There are as many cases as the program promises to answer.
#[test]
fn there_are_enough_cases() {
    assert!(SCENES.len() + COMMANDS.len() >= 170, "{}", SCENES.len() + COMMANDS.len());
}

/// All errors of a scene are told at once, in the order of the file, at most twenty; what follows from another is not
/// told.
#[test]
fn all_errors_at_once() {
    let place = Place::new();
    let text = GOOD.replace("duration", "duraton").replace("mass = 2.0", "mas = 2").replace("[1, 1, 1]", "1");
    place.write(
        "scene.toml",
        &text.replace("stiffness = 4", "stiffness = -4").replace("friction = 0.0", "friction = -1"),
    );
    let run = place.expect(2, &["check", "scene.toml"]);
    let at = |word: &str| run.stderr.find(word).unwrap_or_else(|| panic!("{word} is not in\n{}", run.stderr));
    let words = ["`duraton`", "friction of material", "an array of length 3", "`mas`", "-4", "5 errors"];
    assert!(words.map(at).is_sorted_by(|a, b| a < b || *a == at("an array of length 3")), "{}", run.stderr);
    assert_eq!(run.stderr.matches("error: ").count(), 5, "{}", run.stderr);
    let many = (0..50).map(|number| format!("wrong{number} = 1")).collect::<Vec<_>>().join("\n");
    place.write("scene.toml", &format!("{many}\n{GOOD}"));
    let run = place.expect(2, &["check", "scene.toml"]);
    assert_eq!(run.stderr.matches("error: unknown key").count(), 20, "{}", run.stderr);
    assert!(run.stderr.contains("20 errors are shown; there are more"), "{}", run.stderr);
}

//! `polhode view`, and the pages that `run` writes.

use crate::{FLIGHT, Place};

/// A ball that falls onto a floor.
const DROP: &str = r#"
format = 1
name = "drop"
duration = 0.5

[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]

[[bodies]]
name = "ball"
shape.sphere.radius = 0.1
mass = 1.0
position = [0, 0, 0.5]
"#;

#[test]
fn a_page_beside_the_scene() {
    let place = Place::with_scene(DROP);
    let run = place.expect(0, &["view", "scene.toml"]);
    assert_eq!(run.stdout, "scene.html\n");
    assert_eq!(place.list(), ["scene.html", "scene.toml"]);
    let page = place.read("scene.html");
    assert!(page.contains("<title>drop</title>") && page.contains("polhode-frames-0-0"));
    assert!(page.contains("\"outcome\":\"completed\"") && page.contains("\"count\":31"));
    assert!(page.contains("\"simulated_s\":0.5") && !page.contains("wall_s"));
    // The same bytes every time, from `run` too where its samples are the same.
    place.expect(0, &["view", "scene.toml", "-o", "again.html"]);
    assert_eq!(place.read("again.html"), page);
    place.expect(0, &["view", "scene.toml", "--fps", "100", "-o", "a.html"]);
    place.expect(0, &["run", "scene.toml", "-o", "b.html", "-o", "b.csv"]);
    assert_eq!(place.read("a.html"), place.read("b.html"));
}

/// What a scene says of itself stands in its page: heading and description; two scenes are both named.
#[test]
fn a_page_with_a_description() {
    let place = Place::new();
    let told = |title: &str, words: &str| {
        DROP.replace("duration", &format!("title = \"{title}\"\ndescription = \"{words}\"\nduration"))
    };
    place.write("a.toml", &told("A ball & a floor", "It falls."));
    place.write("b.toml", &told("Another", "It falls."));
    place.expect(0, &["view", "a.toml"]);
    let page = place.read("a.html");
    assert!(page.contains("<title>A ball &amp; a floor</title>") && page.contains("\"description\":\"It falls.\""));
    place.expect(0, &["view", "a.toml", "b.toml", "-o", "both.html"]);
    let page = place.read("both.html");
    assert!(page.contains("\"title\":\"A ball & a floor | Another\""));
    assert!(page.contains("\"description\":\"It falls.\""));
}

#[test]
fn two_runs_in_one_page() {
    let place = Place::with_scene(DROP);
    place.expect(0, &["view", "scene.toml", "--beside", "method.tier=stepped", "-o", "a.html"]);
    let page = place.read("a.html");
    assert!(page.contains("polhode-frames-1-0") && page.contains("\"name\":\"method.tier=stepped\""));
    place.write("other.toml", &DROP.replace("0.5]", "0.25]"));
    place.expect(0, &["view", "scene.toml", "other.toml", "-o", "b.html"]);
    assert!(place.read("b.html").contains("\"name\":\"other\""));
}

#[test]
fn a_trajectory_with_the_shapes_of_its_scene() {
    let place = Place::with_scene(DROP);
    place.expect(0, &["run", "scene.toml", "-o", "a.csv"]);
    place.expect(0, &["view", "scene.toml", "a.csv", "-o", "a.html"]);
    let page = place.read("a.html");
    assert!(page.contains("\"contacts\":false") && page.contains("\"count\":51"));
}

/// What cannot be shown is said in words, and no page appears or is replaced.
#[test]
fn trajectories_that_are_refused() {
    let place = Place::with_scene(DROP);
    place.expect(0, &["run", "scene.toml", "-o", "a.csv"]);
    let text = place.read("a.csv");
    place.write("page.html", "what stood here");
    let lines: Vec<&str> = text.lines().collect();
    let cases = [
        (lines[..lines.len() - 1].join("\n") + "\n", "cut off: t = 0.5 s has 1 of 2 bodies; `ball` is missing"),
        (text[..text.len() - 40].to_owned(), "columns, 15 are needed"),
        (text.replace(",ball,", ",bell,"), "has no body `bell`; its bodies are `floor`, `ball`"),
        (text.replacen("ball,0.0,0.0,0.5", "ball,NaN,0.0,0.5", 1), "must be finite"),
        (lines[0].to_owned() + "\n", "it has no samples"),
        ("x\n".to_owned(), "the first line must be"),
        (format!("{text}{}\n", lines[1..].join("\n")), "does not follow the time before it"),
    ];
    for (content, message) in cases {
        place.write("bad.csv", &content);
        let run = place.expect(2, &["view", "scene.toml", "bad.csv", "-o", "page.html"]);
        assert!(run.stderr.contains(message), "{message}: {}", run.stderr);
        assert_eq!(place.read("page.html"), "what stood here");
    }
    place.expect(3, &["view", "scene.toml", "missing.csv"]);
    let alone = place.expect(2, &["view", "a.csv"]);
    assert!(alone.stderr.contains("name its scene too"), "{}", alone.stderr);
    assert_eq!(place.list(), ["a.csv", "bad.csv", "page.html", "scene.toml"]);
}

#[test]
fn mistakes() {
    let place = Place::with_scene(DROP);
    place.write("empty.toml", "format = 1\n");
    for (code, args, message) in [
        (2, &["empty.toml"][..], "no bodies"),
        (2, &["scene.toml", "-o", "a.txt"], "unknown ending"),
        (3, &["scene.toml", "-o", "missing/a.html"], "cannot write"),
        (2, &["scene.toml", "-o", "a.html", "-o", "a.html"], "named twice"),
        (2, &["scene.toml", "--fps", "0"], "positive"),
        (2, &["scene.toml", "--fps", "NaN"], "positive"),
        (2, &["scene.toml", "scene.toml", "scene.toml"], "two runs at the most"),
        (2, &["scene.toml", "a.npy"], "from a .csv file"),
        (2, &["scene.toml", "--beside", "nothing"], "KEY=VALUE"),
    ] {
        let run = place.expect(code, &[&["view"], args].concat());
        assert!(run.stderr.contains(message), "{message}: {}", run.stderr);
    }
    assert_eq!(place.list(), ["empty.toml", "scene.toml"]);
}

/// A picture of any time of a scene or a trajectory, without what comes after it.
#[test]
fn stills() {
    let place = Place::with_scene(DROP);
    let small = ["--size", "64x48"];
    let run = place.expect(0, &[&["view", "scene.toml", "--still", "t=0.25"], &small[..]].concat());
    assert_eq!(run.stdout, "scene.png\n");
    let png = |name: &str| std::fs::read(place.path(name)).unwrap();
    place.expect(0, &[&["view", "scene.toml", "--still", "0.25", "-o", "again.png"], &small[..]].concat());
    assert_eq!(png("scene.png"), png("again.png"));
    place.expect(0, &["run", "scene.toml", "-o", "a.csv"]);
    place.expect(0, &[&["view", "scene.toml", "a.csv", "--still", "t=0.25", "-o", "a.png"], &small[..]].concat());
    assert_eq!(png("scene.png"), png("a.png"));
    place.expect(0, &[&["view", "scene.toml", "--still", "t=0", "-o", "start.png"], &small[..]].concat());
    assert_ne!(png("scene.png"), png("start.png"));
    for (args, message) in [
        (&["scene.toml", "--still", "t=0.6"][..], "the motion is from t = 0 s to 0.5 s"),
        (&["scene.toml", "--still", "t=-1"], "the motion is from"),
        (&["scene.toml", "--still", "t=NaN"], "the motion is from"),
        (&["scene.toml", "a.csv", "--still", "t=0.6"], "the motion is from t = 0 s to 0.5 s"),
        (&["scene.toml", "--still", "soon"], "t=S"),
        (&["scene.toml", "--still", "t=0", "-o", "a.html"], "--still draws a picture (.png)"),
        (&["scene.toml", "scene.toml", "--still", "t=0"], "two runs are shown by a page"),
        (&["scene.toml", "--still", "t=0", "--size", "big"], "WxH"),
        (&["scene.toml", "--still", "t=0", "--size", "0x5"], "1 to 8192 pixels"),
    ] {
        let run = place.expect(2, &[&["view"], args].concat());
        assert!(run.stderr.contains(message), "{message}: {}", run.stderr);
    }
}

#[test]
fn moving_pictures_and_models() {
    let place = Place::with_scene(DROP);
    let outputs = ["-o", "a.gif", "-o", "a.apng", "-o", "a.webp", "-o", "a.glb", "-o", "a.png"];
    let view = ["view", "scene.toml", "--size", "32x24", "--duration", "0.2"];
    place.expect(0, &[&view[..], &outputs].concat());
    for (name, magic) in [
        ("a.gif", &b"GIF89a"[..]),
        ("a.apng", b"\x89PNG"),
        ("a.webp", b"RIFF"),
        ("a.glb", b"glTF"),
        ("a.png", b"\x89PNG"),
    ] {
        assert!(std::fs::read(place.path(name)).unwrap().starts_with(magic), "{name}");
    }
    place.expect(0, &["run", "scene.toml", "-o", "b.glb", "-o", "b.csv", "-o", "b.html"]);
    assert!(std::fs::read(place.path("b.glb")).unwrap().starts_with(b"glTF"));
}

/// A run that fails shows what was computed and where it stopped; the exit code is that of `run`.
#[test]
fn a_run_that_fails() {
    let place = Place::with_scene(FLIGHT);
    let changes = ["--set", "gravity=[0,0,-1e307]", "--set", "duration=40", "--set", "output.interval=0.5"];
    for command in [&["view", "scene.toml", "-o", "page.html"], &["run", "scene.toml", "-o", "page.html"]] {
        let run = place.expect(1, &[&command[..], &changes].concat());
        assert!(run.stderr.contains("error: flight:"), "{}", run.stderr);
        let page = place.read("page.html");
        assert!(page.contains("\"outcome\":\"failed: flight: ") && page.contains("polhode-frames-0-0"), "{page}");
        std::fs::remove_file(place.path("page.html")).unwrap();
    }
}

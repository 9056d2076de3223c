//! `polhode view`, and the pages that `run` writes.

use crate::{FLIGHT, Place, Run};

/// A ball that falls onto a floor.
pub(crate) const DROP: &str = r#"
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

/// The first command to try: a page of a pile that stands and one that falls, and what to do next.
#[test]
fn the_demo_is_a_page_of_two_runs_and_says_what_is_next() {
    let place = Place::new();
    let run = place.expect(0, &["demo"]);
    assert_eq!(place.list(), ["polhode-demo.html"]);
    assert!(run.stdout.starts_with("polhode-demo.html\n") && run.stdout.contains("polhode new mine"));
    let page = place.read("polhode-demo.html");
    assert!(page.contains("\"name\":\"diamond-4\"") && page.contains("\"name\":\"diamond-4-collapsing\""));
    assert!(page.contains("\"plays_at_once\":false"), "only what is opened plays by itself");
}

/// A page that is opened plays at once. Where nothing can open it, it is there all the same, and a note says so.
#[test]
fn a_page_that_nothing_opens_is_written_all_the_same() {
    let place = Place::with_scene(DROP);
    let mut view = place.command(&["view", "scene.toml", "--open"]);
    let run: Run = view.env("PATH", place.path("no-programs")).output().unwrap().into();
    assert_eq!((run.code, run.stdout.as_str()), (Some(0), "scene.html\n"), "{}", run.stderr);
    assert!(run.stderr.contains("note: nothing here opens scene.html: open it yourself"), "{}", run.stderr);
    assert!(place.read("scene.html").contains("\"plays_at_once\":true"));
}

#[test]
fn a_trajectory_with_the_shapes_of_its_scene() {
    let place = Place::with_scene(DROP);
    place.expect(0, &["run", "scene.toml", "-o", "a.csv"]);
    place.expect(0, &["view", "scene.toml", "a.csv", "-o", "a.html"]);
    let page = place.read("a.html");
    assert!(page.contains("\"contacts\":false") && page.contains("\"count\":51"));
}

/// Whatever kind of trajectory `run` writes, its page is the same; so is that of what an interrupted run has kept.
#[test]
fn every_kind_of_trajectory() {
    let place = Place::with_scene(DROP);
    place.expect(0, &["run", "scene.toml", "-o", "a.csv", "-o", "a.json", "-o", "a.npy"]);
    std::fs::copy(place.path("a.csv"), place.path("a.csv.partial")).unwrap();
    let page = |trajectory: &str| {
        place.expect(0, &["view", "scene.toml", trajectory, "-o", "page.html"]);
        place.read("page.html").replace(&format!("\"name\":\"{}\"", trajectory.rsplit_once('.').unwrap().0), "")
    };
    let expected = page("a.csv");
    for trajectory in ["a.json", "a.npy", "a.csv.partial"] {
        assert!(page(trajectory) == expected, "{trajectory}");
    }
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

/// A picture is taken from a view by name, or from any place at any place.
#[test]
fn cameras() {
    let place = Place::with_scene(DROP);
    let small = ["view", "scene.toml", "--size", "64x48", "--still", "t=0.25", "-o", "a.png"];
    let picture = |args: &[&str]| {
        place.expect(0, &[&small[..], args].concat());
        std::fs::read(place.path("a.png")).unwrap()
    };
    let mut pictures = vec![
        picture(&[]),
        picture(&["--camera", "front"]),
        picture(&["--camera", "side"]),
        picture(&["--camera", "top"]),
        picture(&["--camera", "iso"]),
        picture(&["--camera", "0,-2,0.2"]),
        picture(&["--camera", "-1,-2,0.2", "--look-at", "0,0,0.1"]),
        picture(&["--look-at", "0,0,0.1"]),
    ];
    let count = pictures.len();
    pictures.sort();
    pictures.dedup();
    assert_eq!(pictures.len(), count);
    let moving = ["view", "scene.toml", "--size", "32x24", "--duration", "0.1", "-o", "a.gif"];
    place.expect(0, &[&moving[..], &["--camera", "top"]].concat());
    for (args, message) in [
        (
            &["--camera", "above"][..],
            "not of the form X,Y,Z with finite numbers, such as --camera 3,-4,2, nor one of front",
        ),
        (&["--camera", "1,2"], "not of the form X,Y,Z"),
        (&["--camera", "1,2,inf"], "finite"),
        (&["--look-at", "ball"], "such as --look-at 3,-4,2"),
        (&["--camera", "1,2,3", "--look-at", "1,2,3"], "two different places"),
    ] {
        let run = place.expect(2, &[&small[..], args].concat());
        assert!(run.stderr.contains(message), "{message}: {}", run.stderr);
    }
    let page = place.expect(2, &["view", "scene.toml", "--camera", "top"]);
    assert!(page.stderr.contains("a camera of its own"), "{}", page.stderr);
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

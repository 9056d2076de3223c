//! Plots of `polhode run` and `polhode compare`: what is drawn, what is refused, and what a run that stops leaves.

use crate::{FLIGHT, Place};

/// A body on a spring, which Euler's method in long steps throws away.
const DIVERGING: &str = r#"
format = 1
name = "diverging"
duration = 1000.0
[method]
tier = "accurate"
integrator = "explicit-euler"
step = 1.0
[[bodies]]
name = "ball"
mass = 1.0
inertia = [1, 1, 1]
position = [1, 0, 0]
[[forces]]
type.spring.body = "ball"
type.spring.point = [0.1, 0, 0]
type.spring.anchor = [0, 0, 0]
type.spring.stiffness = 1000.0
type.spring.rest_length = 0.5
"#;

/// All plots are drawn when none are named, and those that are named in the order of the list; the same run gives the
/// same bytes, beside whatever else it writes.
#[test]
fn a_run() {
    let place = Place::with_scene(FLIGHT);
    place.expect(0, &["run", "scene.toml", "-o", "all.svg", "-o", "a.csv", "-o", "page.html", "--events", "e.csv"]);
    assert_eq!(place.list(), ["a.csv", "all.svg", "e.csv", "page.html", "scene.toml"]);
    let all = place.read("all.svg");
    let titles =
        ["flight", "energy, J", "ledger", "penetration, m", "contacts and bodies", "length of the steps, s", "time, s"];
    let places: Vec<_> =
        titles.iter().map(|title| all.find(&format!(">{title}")).unwrap_or_else(|| panic!("{title}"))).collect();
    assert!(places.is_sorted() && all.starts_with("<svg") && all.ends_with("</svg>\n"), "{places:?}");
    place.expect(0, &["run", "scene.toml", "--plot", "steps,energy", "-o", "some.svg", "-o", "again.SVG"]);
    let some = place.read("some.svg");
    assert!(
        some.contains("energy, J") && some.contains("length of the steps") && !some.contains("penetration"),
        "{some}"
    );
    assert_eq!(some, place.read("again.SVG"));
    place.expect(0, &["run", "scene.toml", "-o", "all-again.svg"]);
    assert_eq!(all, place.read("all-again.svg"));
}

/// Plots are looked at and change nothing: the trajectory has the same bytes with them and without, and a run that is
/// resumed has them from the checkpoint on.
#[test]
fn a_run_with_contact() {
    let scene = "format = 1\nname = \"drop\"\nduration = 1.0\noutput.interval = 0.0625\n\
                 [materials.m]\nrestitution = 0.4\n\
                 [[bodies]]\nname = \"floor\"\nfixed = true\nshape.half_space.normal = [0, 0, 1]\nmaterial = \"m\"\n\
                 [[bodies]]\nname = \"brick\"\nshape.box.size = [0.6, 0.4, 0.2]\nmass = 2\nposition = [0, 0, 0.8]\n\
                 rotation_vector = [0.4, 0.7, 0.1]\nmaterial = \"m\"\n";
    let place = Place::with_scene(scene);
    place.expect(0, &["run", "scene.toml", "-o", "without.csv", "--checkpoint-every", "0.6"]);
    place.expect(0, &["run", "scene.toml", "-o", "with.csv", "-o", "with.svg"]);
    assert_eq!(place.read("without.csv"), place.read("with.csv"));
    let svg = place.read("with.svg");
    for part in [">impact \u{d7} ", ">touching ", ">impact 1", "largest so far"] {
        assert!(svg.contains(part), "{part}\n{svg}");
    }
    place.expect(0, &["resume", "scene.checkpoint", "--plot", "energy,steps", "-o", "rest.svg"]);
    let rest = place.read("rest.svg");
    assert!(rest.contains(">energy, J<") && !rest.contains(">0.2<") && rest.contains(">0.8<"), "{rest}");
}

/// A run that stops with an error leaves the plots of what was computed, with where and why it stopped.
#[test]
fn a_run_that_stops() {
    let place = Place::with_scene(DIVERGING);
    let run = place.expect(1, &["run", "scene.toml", "-o", "a.svg", "-o", "a.csv"]);
    assert!(run.stderr.contains("grows without bound"), "{}", run.stderr);
    assert_eq!(place.list(), ["a.csv.partial", "a.svg", "scene.toml"]);
    let svg = place.read("a.svg");
    assert!(svg.contains(">ended at t = ") && svg.contains("grows without bound") && svg.contains("kinetic"), "{svg}");
}

/// A name that is no plot is answered with those that are; plots need a file, and a file has one name.
#[test]
fn mistakes() {
    let place = Place::with_scene(FLIGHT);
    let run = place.expect(2, &["run", "scene.toml", "--plot", "energy,speed", "-o", "a.svg"]);
    for part in ["speed", "energy", "ledger", "penetration", "contacts", "steps"] {
        assert!(run.stderr.contains(part), "{part}: {}", run.stderr);
    }
    let run = place.expect(2, &["run", "scene.toml", "--plot", "energy", "-o", "a.csv"]);
    assert!(run.stderr.contains("-o FILE.svg"), "{}", run.stderr);
    let run = place.expect(2, &["run", "scene.toml", "-o", "a.svg", "-o", "./a.svg"]);
    assert!(run.stderr.contains("named twice"), "{}", run.stderr);
    place.expect(2, &["run", "scene.toml", "-o", "a.svg", "--events", "a.svg"]);
    place.expect(3, &["run", "scene.toml", "-o", "missing/a.svg"]);
    let run = place.expect(2, &["run", "scene.toml", "-o", "a.xyz"]);
    assert!(run.stderr.contains(".svg"), "{}", run.stderr);
    assert_eq!(place.list(), ["scene.toml"]);
}

/// Two trajectories are compared over time; energies need the masses of a scene.
#[test]
fn two_trajectories() {
    let place = Place::with_scene(FLIGHT);
    place.expect(0, &["run", "scene.toml", "-o", "a.csv"]);
    place.expect(0, &["run", "scene.toml", "-o", "b.csv", "--set", "bodies.0.velocity=[3, 0, 5]"]);
    let compare = ["compare", "a.csv", "b.csv"];
    let with = |more: &[&'static str]| [&compare[..], more].concat();
    place.expect(1, &with(&["--plot", "-o", "all.svg"]));
    let all = place.read("all.svg");
    for part in ["a.csv compared with b.csv", "distance of positions, m", "0.5 m", "angle between attitudes", "1 m/s"] {
        assert!(all.contains(part), "{part}\n{all}");
    }
    assert!(!all.contains("difference of energy"));
    place.expect(1, &with(&["-o", "energy.svg", "--scene", "scene.toml", "--plot", "energy"]));
    // The speeds are 5 and sqrt(34) m/s at first: the kinetic energies of 2 kg differ by 9 J, and by as much at the
    // end.
    let energy = place.read("energy.svg");
    assert!(energy.contains("all bodies \u{2212}9 J") && !energy.contains("distance of positions"), "{energy}");
    place.expect(0, &["run", "scene.toml", "-o", "short.csv", "--duration", "0.25"]);
    place.expect(1, &["compare", "a.csv", "short.csv", "-o", "short.svg"]);
    assert!(place.read("short.svg").contains("not about the same samples"));

    let run = place.expect(2, &with(&["--plot", "energy", "-o", "x.svg"]));
    assert!(run.stderr.contains("--scene"), "{}", run.stderr);
    let run = place.expect(2, &with(&["--plot", "speed", "-o", "x.svg"]));
    assert!(run.stderr.contains("positions") && run.stderr.contains("attitudes"), "{}", run.stderr);
    place.expect(2, &with(&["--plot"]));
    place.expect(2, &with(&["-o", "x.png"]));
    place.expect(3, &with(&["-o", "missing/x.svg"]));
    assert!(!place.path("x.svg").exists());
}

/// What is shown of the penetration now is never above the largest so far.
#[test]
fn the_largest_penetration_is_not_below_that_of_now() {
    let place = Place::new();
    let args = ["run", "example:tippe-top", "--duration", "0.4", "--plot", "penetration", "-o", "a.svg"];
    place.expect(0, &args);
    let svg = place.read("a.svg");
    let number = |name: &str| -> f64 {
        let text = svg.split(&format!(">{name} ")).nth(1).unwrap().split(['<', ' ']).next().unwrap();
        text.replace('\u{2212}', "-").parse().unwrap_or_else(|error| panic!("{text}: {error}"))
    };
    assert!(number("now") <= number("largest so far"), "{} {}", number("now"), number("largest so far"));
}

//! Sweeps of scenes with uncertain values: sensitivities of a block that slides to rest against closed forms to 1e-6,
//! bands, poses of groups of bodies, the page, Parquet, and mistakes that are told before anything is computed.
//!
//! The block comes to rest at `d = v^2 / (2 mu g)`: `dd/dv = v / (mu g)`, `dd/dmu = -d / mu`, `dd/dg = -d / g`. Of a
//! product `d = a(v) b(mu)` of independent factors the indices are `S_a = Var(a) E(b)^2 / V` and
//! `T_a = Var(a) E(b^2) / V` with `V = E(a^2) E(b^2) - E(a)^2 E(b)^2`.

use super::Place;
use serde_json::Value;

fn slide(uncertain: &str) -> String {
    format!(
        r#"
format = 1
duration = 2.0
gravity = [0, 0, -9.81]
output.interval = 0.5
method.error = "off"
[materials.ice]
friction = 0.4
[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]
material = "ice"
[[bodies]]
name = "box"
mass = 2.0
shape.box.size = [0.4, 0.2, 0.1]
position = [0, 0, 0.05]
velocity = [2, 0, 0]
material = "ice"
{uncertain}
"#
    )
}

/// A ball that is thrown, which takes no time to compute: `z(T) = 1 + v T + g T^2 / 2` of `v = 3 +- 0.3`, T = 1 s.
fn fly(uncertain: &str) -> String {
    format!(
        r#"
format = 1
duration = 1.0
gravity = [0, 0, -9.81]
output.interval = 0.5
method.error = "off"
[[bodies]]
name = "box"
mass = 1.0
shape.box.size = [0.4, 0.2, 0.1]
position = [0, 0, 1]
velocity = [2, 0, 3]
[[bodies]]
name = "other"
mass = 1.0
shape.sphere.radius = 0.1
position = [0, 3, 2]
orientation = [1, 0, 0, 0]
{uncertain}
"#
    )
}

const THROW: &str = "[[uncertain]]\nkey = \"bodies.box.velocity[2]\"\nnormal.deviation = 0.3\n";
const FALL: &str = "[[uncertain]]\nkey = \"gravity[2]\"\nuniform = { low = -10, high = -9 }\n";
const HEIGHT: &str = "z=bodies.box.position[2]@end";

const FRICTION: &str = "[[uncertain]]\nkey = \"materials.ice.friction\"\nuniform = { low = 0.3, high = 0.5 }\n";
const SPEED: &str = "[[uncertain]]\nkey = \"bodies.box.velocity[0]\"\nnormal.deviation = 0.1\n";
const GRAVITY: &str = "[[uncertain]]\nkey = \"gravity[2]\"\nnormal = { mean = -9.81, deviation = 0.05 }\n";
const DISTANCE: &str = "d=bodies.box.position[0]@end";

fn swept<'a>(more: &[&'a str]) -> Vec<&'a str> {
    of_measure(DISTANCE, more)
}

fn flown<'a>(more: &[&'a str]) -> Vec<&'a str> {
    of_measure(HEIGHT, more)
}

fn of_measure<'a>(measure: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    let mut all = vec!["sweep", "scene.toml", "--seed", "1", "--measure", measure];
    all.extend(more);
    all
}

/// What the first measure hangs on, by key.
fn hangs_on<'a>(found: &'a Value, key: &str) -> &'a Value {
    let values = found["measures"][0]["hangs_on"]["values"].as_array().unwrap();
    values.iter().find(|own| own["key"] == key).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

#[test]
fn derivatives_of_a_sliding_block_are_the_closed_form() {
    let place = Place::with_scene(&slide(&format!("{FRICTION}{SPEED}{GRAVITY}")));
    let found = place.expect(0, &swept(&["--random", "2", "--sensitivities", "local", "--json"])).json();
    let (v, mu, g) = (2.0, 0.4, 9.81);
    let d = v * v / (2.0 * mu * g);
    for (key, exact) in
        [("bodies.box.velocity[0]", v / (mu * g)), ("materials.ice.friction", -d / mu), ("gravity[2]", d / g)]
    {
        let own = &hangs_on(&found, key)["derivative"];
        let (value, error) = (number(&own["value"]), number(&own["error"]));
        assert!((value / exact - 1.0).abs() < 1e-6, "{key}: {value} {exact}");
        assert!((value - exact).abs() <= 10.0 * error + 1e-9 * exact.abs(), "{key}: {value} {exact} told {error}");
    }
}

#[test]
fn indices_of_a_sliding_block_are_the_closed_form() {
    let place = Place::with_scene(&slide(&format!("{FRICTION}{SPEED}")));
    let found = place.expect(0, &swept(&["--random", "20", "--json"])).json();
    // a = v^2 of v = 2 +- 0.1, b = 1 / mu of mu from 0.3 to 0.5; the constant is left out.
    let (m, s): (f64, f64) = (2.0, 0.1);
    let (a, aa) = (m * m + s * s, m.powi(4) + 6.0 * m * m * s * s + 3.0 * s.powi(4));
    let (low, high): (f64, f64) = (0.3, 0.5);
    let (b, bb) = ((high / low).ln() / (high - low), 1.0 / (low * high));
    let (va, vb, v) = (aa - a * a, bb - b * b, aa * bb - a * a * b * b);
    for (key, first, total) in [
        ("bodies.box.velocity[0]", va * b * b / v, va * bb / v),
        ("materials.ice.friction", vb * a * a / v, vb * aa / v),
    ] {
        let own = hangs_on(&found, key);
        for (index, exact) in [("first", first), ("total", total)] {
            let (value, error) = (number(&own[index]["value"]), number(&own[index]["error"]));
            assert!((value - exact).abs() < 1e-6, "{key} {index}: {value} {exact}");
            assert!(error < 1e-4, "{key} {index}: {error}");
        }
    }
}

/// Mixed draws find the same within a few of their standard errors, and their rows resume.
#[test]
fn mixed_draws_find_the_same_and_a_cut_table_goes_on() {
    let place = Place::with_scene(&fly(&format!("{THROW}{FALL}")));
    let args = flown(&["--random", "60", "--sensitivities", "saltelli", "--json", "-o", "table.csv"]);
    let found = place.expect(0, &args).json();
    // Shares of the variances 0.3^2 and (1/2)^2 / 12 of a sum: first-order and total are the same.
    let exact = 0.09 / (0.09 + 0.25 / 12.0);
    let own = hangs_on(&found, "bodies.box.velocity[2]");
    for index in ["first", "total"] {
        let (value, error) = (number(&own[index]["value"]), number(&own[index]["error"]));
        assert!((value - exact).abs() < 4.0 * error && error < 0.4, "{index}: {value} {exact} +- {error}");
    }
    let whole = place.read("table.csv");
    assert!(whole.lines().nth(1).unwrap().starts_with("run,part,bodies.box.velocity[2],gravity[2],outcome"));
    place.write("table.csv", &whole[..whole.len() / 3]);
    assert_eq!(place.expect(0, &args).json(), found);
    assert_eq!(place.read("table.csv"), whole);
}

#[test]
fn poses_of_a_group_are_drawn_alone_or_alike() {
    let group = |draw: &str| {
        format!(
            "[[uncertain]]\nbodies = [\"box\", \"other\"]\nposition_deviation = [0.01, 0.02, 0]\n\
             rotation_deviation = [0, 0, 0.1]\n{draw}\n"
        )
    };
    for (draw, keys) in [("", 6), ("draw = \"alike\"", 3)] {
        let place = Place::with_scene(&fly(&group(draw)));
        let x = "x=bodies.box.position[0]@start";
        let y = "y=bodies.other.position[1]@start";
        let turn = "z=bodies.other.orientation[3]@start";
        let args = ["sweep", "scene.toml", "--random", "30", "--sensitivities", "off", "--measure", x, "--measure", y];
        let more = ["--measure", turn, "--duration", "0.01", "-o", "table.csv"];
        place.expect(0, &[&args[..], &more].concat());
        let table = place.read("table.csv");
        let head: Vec<&str> = table.lines().nth(1).unwrap().split(',').collect();
        assert_eq!(
            head.iter().filter(|own| own.contains(".shift[") || own.contains(".turn[")).count(),
            keys,
            "{head:?}"
        );
        let name = if keys == 6 { ["bodies.box", "bodies.other"] } else { ["uncertain.0"; 2] };
        let column = |name: &str| head.iter().position(|own| *own == name).unwrap();
        for line in table.lines().skip(3) {
            let cell = |name: &str| line.split(',').nth(column(name)).unwrap().parse::<f64>().unwrap();
            assert_eq!(cell("x"), cell(&format!("{}.shift[0]", name[0])));
            assert_eq!(cell("y"), 3.0 + cell(&format!("{}.shift[1]", name[1])));
            assert!((cell("z") - (0.5 * cell(&format!("{}.turn[2]", name[1]))).sin()).abs() < 1e-14);
        }
    }
}

/// A draw that the scene refuses is a row with its reason; a run says that it draws nothing.
#[test]
fn a_mass_below_zero_is_a_row_and_a_run_says_that_it_draws_nothing() {
    let mass = "[[uncertain]]\nkey = \"bodies.box.mass\"\nnormal = { mean = 1.0, deviation = 1.0 }\n";
    let place = Place::with_scene(&fly(mass));
    let found = place.expect(0, &flown(&["--random", "40", "--duration", "0.01", "--json"])).json();
    let outcomes = found["outcomes"].as_array().unwrap();
    let failed = outcomes.iter().find(|own| own["outcome"] == "failed").unwrap();
    let (share, error) = (number(&failed["share"]), number(&failed["standard_error"]));
    assert!((share - 0.159).abs() < 4.0 * error, "{share} {error}");
    assert!(found["first_reason"].as_str().unwrap().contains("bodies.box.mass"), "{found}");
    let run = place.expect(0, &["run", "scene.toml", "--duration", "0.01"]).stdout;
    assert!(run.contains("uncertain: 1 entry of the scene, not drawn in a run"), "{run}");
}

#[test]
fn the_page_has_the_same_bytes_when_it_is_made_again() {
    let place = Place::with_scene(&fly(THROW));
    let args = flown(&["--random", "30", "-o", "table.csv", "--report", "page.html"]);
    let text = place.expect(0, &args).stdout;
    assert!(text.contains("of them 30 draws") && text.contains("what z hangs on"), "{text}");
    let page = place.read("page.html");
    place.expect(0, &args);
    assert_eq!(place.read("page.html"), page, "from a table that is there");
    std::fs::remove_file(place.path("table.csv")).unwrap();
    place.expect(0, &[&args[..], &["--workers", "1"]].concat());
    assert_eq!(place.read("page.html"), page, "computed again by one worker");
    for told in ["polhode sweep scene.toml --seed 1", "normal(3, 0.3)", "<svg", "BLAKE2b-256", "mass = 1.0", "95 %"] {
        assert!(page.contains(told), "{told}");
    }
    assert!(!page.contains("http-equiv") && !page.contains("src="), "it needs nothing else");
}

#[test]
fn parquet_is_made_of_the_rows() {
    let place = Place::with_scene(&fly(THROW));
    let args = flown(&["--random", "5", "--sensitivities", "off", "-o", "table.parquet"]);
    place.expect(0, &args);
    let bytes = std::fs::read(place.path("table.parquet")).unwrap();
    assert!(bytes.starts_with(b"PAR1") && bytes.ends_with(b"PAR1"));
    assert_eq!(place.list(), ["scene.toml", "table.parquet", "table.parquet.csv"]);
    let length = u32::from_le_bytes(bytes[bytes.len() - 8..bytes.len() - 4].try_into().unwrap()) as usize;
    assert!(length < bytes.len() - 12);
    place.expect(0, &args);
    assert_eq!(std::fs::read(place.path("table.parquet")).unwrap(), bytes);
    let other = flown(&["--random", "5", "--sensitivities", "local", "-o", "table.parquet"]);
    assert!(place.expect(3, &other).stderr.contains("it is of another sweep"));
    place.write("mine.parquet", "mine");
    let mine = flown(&["--random", "5", "-o", "mine.parquet"]);
    assert!(place.expect(3, &mine).stderr.contains("it is no file of a sweep"));
    assert_eq!(place.read("mine.parquet"), "mine");
}

#[test]
fn mistakes_are_told() {
    let key = |rest: &str| format!("[[uncertain]]\nkey = \"bodies.box.mass\"\n{rest}\n");
    for (uncertain, told) in [
        ("[[uncertain]]\nkey = \"bodies.bxo.mass\"\nuniform = { low = 1, high = 2 }\n".to_owned(), "`bxo`"),
        ("[[uncertain]]\nkey = \"bodies.box.mas\"\nuniform = { low = 1, high = 2 }\n".to_owned(), "`mass`"),
        (key("uniform = { low = 2, high = 1 }"), "the range from 2 to 1 is empty"),
        (key("interval = { low = 1, high = 1 }"), "empty"),
        (key("normal = { mean = 1, deviation = -1 }"), "at least 0"),
        (key("normal = { mean = 1 }"), "deviation"),
        (key("gauss = { mean = 1 }"), "unknown key `gauss`"),
        (key(""), "exactly one of normal, lognormal, uniform, interval or choice"),
        (key("choice = []"), "at least one value"),
        (key("draw = \"alike\""), "`draw` has no meaning"),
        (format!("{0}{0}", key("uniform = { low = 1, high = 2 }")), "uncertain twice"),
        ("[[uncertain]]\nuniform = { low = 1, high = 2 }\n".to_owned(), "missing key"),
        ("[[uncertain]]\nkey = \"gravity[1]\"\nlognormal = { spread = 1 }\n".to_owned(), "positive"),
        ("[[uncertain]]\nkey = \"bodies.box.inertia\"\nnormal = { deviation = 1 }\n".to_owned(), "give its mean"),
        ("[[uncertain]]\nbodies = [\"bxo\"]\nposition_deviation = 1\n".to_owned(), "`bxo`"),
        ("[[uncertain]]\nbodies = [\"box\", \"box\"]\nposition_deviation = 1\n".to_owned(), "named twice"),
        ("[[uncertain]]\nbodies = [\"box\"]\n".to_owned(), "position_deviation"),
    ] {
        let place = Place::with_scene(&fly(&uncertain));
        let run = place.expect(2, &flown(&["--random", "5", "-o", "table.csv"]));
        assert!(run.stderr.contains(told), "{uncertain}: {}", run.stderr);
        assert_eq!(place.list(), ["scene.toml"], "{uncertain}");
    }
    let place = Place::with_scene(&fly(&key("interval = { low = -1, high = 2 }")));
    let run = place.expect(2, &flown(&["--random", "5", "-o", "table.csv"]));
    assert!(run.stderr.contains("bodies.box.mass reaches -1.0, which the scene refuses"), "{}", run.stderr);
    let place = Place::with_scene(&fly(THROW));
    for (rest, told) in [
        (&[][..], "--random N"),
        (&["--random", "1000000000"], "10000000"),
        (&["--random", "5", "--shard", "3/2", "-o", "t.csv"], "2/8"),
        (&["--random", "5", "--sensitivities", "all"], "saltelli"),
        (&["--random", "5", "--vary", "bodies.box.mass=1..2", "--sensitivities", "off"], "cannot be used with"),
        (&["--random", "5", "--report", "scene.toml"], "never replaces"),
    ] {
        let run = place.expect(2, &flown(rest));
        assert!(run.stderr.contains(told), "{rest:?}: {}", run.stderr);
    }
    let plain = Place::with_scene(&fly(""));
    assert!(plain.expect(2, &flown(&["--random", "5"])).stderr.contains("[[uncertain]]"));
    assert_eq!(place.list(), ["scene.toml"]);
}

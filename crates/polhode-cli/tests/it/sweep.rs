//! `polhode sweep`: its table against a closed form, the same bytes for any number of workers and shards and after a
//! kill, and mistakes that are told before anything is computed or overwritten.

use super::Place;

/// A box that slides on a floor: `x(t) = v t - mu g t^2 / 2` as long as it slides, and it comes to rest at
/// `v^2 / (2 mu g)`.
const SLIDE: &str = r#"
format = 1
name = "slide"
duration = 1.0

[materials.ice]
friction = 0.3

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
"#;

const FRICTION: &str = "materials.ice.friction";

/// Columns of a table, without its first line.
fn column(table: &str, name: &str) -> Vec<String> {
    let mut lines = table.lines().skip(1);
    let place = lines.next().unwrap().split(',').position(|own| own == name).unwrap();
    lines.map(|line| line.split(',').nth(place).unwrap().to_owned()).collect()
}

fn drawn<'a>(output: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    let mut all = vec!["-q", "sweep", "scene.toml", "--vary", "materials.ice.friction=0.1..0.8", "--random", "24"];
    all.extend(["--seed", "3", "--measure", "x=bodies.box.position[0]@end", "-o", output]);
    all.extend(more);
    all
}

#[test]
fn a_sweep_of_friction_is_the_closed_form() {
    let place = Place::with_scene(SLIDE);
    let vary = format!("{FRICTION}=0.1..0.8:8");
    let measures = ["bodies.box.position[0]@end", "v=max(box.velocity)", "energy.kinetic@start", "count(events)"];
    let mut args = vec!["sweep", "scene.toml", "--vary", &vary, "-o", "table.csv"];
    for own in measures {
        args.extend(["--measure", own]);
    }
    let text = place.expect(0, &args).stdout;
    assert!(text.starts_with("sweep of scene.toml: 8 runs, in table.csv\n  completed "), "{text}");
    let table = place.read("table.csv");
    let numbers = |name: &str| column(&table, name).iter().map(|own| own.parse().unwrap()).collect::<Vec<f64>>();
    let (friction, x) = (numbers(FRICTION), numbers("bodies.box.position[0]@end"));
    assert_eq!(friction.len(), 8);
    for (friction, x) in friction.into_iter().zip(x) {
        let (slowing, speed) = (friction * 9.81, 2.0);
        let exact = if speed > slowing { speed - 0.5 * slowing } else { speed * speed / (2.0 * slowing) };
        assert!((x - exact).abs() < 1e-12, "{friction}: {x} {exact}");
    }
    assert!(numbers("v").iter().all(|v| *v == 2.0) && numbers("energy.kinetic@start").iter().all(|own| *own == 4.0));
    assert!(column(&table, "outcome").iter().all(|outcome| outcome == "completed"));
}

/// Any number of workers and shards, and a table that was cut off anywhere.
#[test]
fn the_same_bytes_however_it_is_computed() {
    let place = Place::with_scene(SLIDE);
    place.expect(0, &drawn("one.csv", &["--workers", "1"]));
    let whole = place.read("one.csv");
    place.expect(0, &drawn("three.csv", &["--workers", "3"]));
    assert_eq!(place.read("three.csv"), whole);
    for length in [0, 7, 40, whole.len() / 2, whole.len() - 1, whole.len()] {
        place.write("cut.csv", &whole[..length]);
        place.expect(0, &drawn("cut.csv", &[]));
        assert_eq!(place.read("cut.csv"), whole, "{length}");
    }
    for shard in ["3/3", "1/3", "2/3"] {
        place.expect(0, &drawn("all.csv", &["--shard", shard]));
    }
    place.expect(0, &drawn("all.csv", &[]));
    assert_eq!(place.read("all.csv"), whole);
    let stdout = place.expect(0, &drawn("", &[])[..11]).stdout;
    assert_eq!(stdout.lines().collect::<Vec<_>>(), whole.lines().skip(1).collect::<Vec<_>>());
}

/// A sweep that is killed goes on to the same bytes.
#[test]
fn a_killed_sweep_goes_on_to_the_same_bytes() {
    let place = Place::with_scene(SLIDE);
    let many = |output| {
        let mut args = drawn(output, &[]);
        args[6] = "400";
        args
    };
    place.expect(0, &many("whole.csv"));
    let whole = place.read("whole.csv");
    let mut begun = place.command(&many("killed.csv")).spawn().unwrap();
    let lines = || std::fs::read_to_string(place.path("killed.csv")).map_or(0, |text| text.lines().count());
    while lines() < 20 && begun.try_wait().unwrap().is_none() {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    begun.kill().unwrap();
    begun.wait().unwrap();
    assert!(whole.starts_with(&place.read("killed.csv")), "whole lines, and what a kill has cut off");
    place.expect(0, &many("killed.csv"));
    assert_eq!(place.read("killed.csv"), whole);
}

/// A run that is refused or fails is a row with its reason; where all do, the exit code says so.
#[test]
fn what_fails_is_a_row() {
    let place = Place::with_scene(SLIDE);
    let vary = "bodies.box.mass=normal(1, 2)";
    let args = ["sweep", "scene.toml", "--vary", vary, "--random", "40", "--duration", "0.01", "-o", "table.csv"];
    let text = place.expect(0, &args).stdout;
    let table = place.read("table.csv");
    let outcomes = column(&table, "outcome");
    for (mass, outcome) in column(&table, "bodies.box.mass").iter().zip(&outcomes) {
        assert_eq!(outcome == "completed", mass.parse::<f64>().unwrap() > 0.0, "{mass} {outcome}");
    }
    assert!(
        outcomes.iter().any(|own| own == "failed") && text.contains("  failed  ") && text.contains("first reason:")
    );
}

#[test]
fn mistakes_are_told_and_nothing_is_overwritten() {
    let place = Place::with_scene(SLIDE);
    let vary = ["sweep", "scene.toml", "--vary"];
    for (code, rest, told) in [
        (2, &["materials.ice.frictoin=1,2"][..], "frictoin"),
        (2, &["materials.ice.friction=0.1,-1"], "friction"),
        (2, &["materials.ice.friction=0.1..0.2:0"], "0.1..0.2:0"),
        (2, &["materials.ice.friction=0.1..0.2"], "--random"),
        (2, &["materials.ice.friction=0.1..0.2", "--random", "1000000000"], "10000000"),
        (2, &["materials.ice.friction=0.1", "--measure", "bodies.bxo.position[0]"], "did you mean `box`?"),
        (2, &["materials.ice.friction=0.1", "--measure", "bodies.box.position[3]"], "[0] to [2]"),
        (2, &["materials.ice.friction=0.1", "--measure", "bodies.box.orientation"], "[0] to [3]"),
        (2, &["materials.ice.friction=0.1", "--measure", "largest(energy.kinetic)"], "accepted"),
        (2, &["materials.ice.friction=0.1", "--measure", "count(events.impcat)"], "impact"),
        (2, &["materials.ice.friction=0.1", "--shard", "9/8", "-o", "table.csv"], "2/8"),
    ] {
        let run = place.expect(code, &[&vary[..], rest].concat());
        assert!(run.stderr.contains(told), "{rest:?}: {}", run.stderr);
    }
    let one = ["sweep", "scene.toml", "-o", "table.csv", "--vary"];
    place.expect(0, &[&one[..], &["materials.ice.friction=0.1,0.2"]].concat());
    let before = place.read("table.csv");
    for other in ["materials.ice.friction=0.1,0.3", "bodies.box.mass=1,2"] {
        let run = place.expect(3, &[&one[..], &[other]].concat());
        assert!(run.stderr.contains("it is of another sweep") && run.stderr.contains("nothing was written"), "{other}");
    }
    place.write("mine.csv", "a,b\n1,2\n");
    let args = ["sweep", "scene.toml", "-o", "mine.csv", "--vary", "materials.ice.friction=0.1"];
    assert!(place.expect(3, &args).stderr.contains("it is no file of a sweep"));
    assert_eq!((place.read("table.csv"), place.read("mine.csv")), (before, "a,b\n1,2\n".to_owned()));
}

//! `polhode mesh`.

use crate::{Place, fixture};
use std::fmt::Write as _;

/// The L-shape of the thesis's section 3.2 (case MP-04) at density 1 and by mass.
#[test]
fn solid() {
    let place = Place::new();
    let file = fixture("meshes/l-shape.obj");
    let json = place.expect(0, &["mesh", &file, "--json"]).json();
    for key in [
        "volume_m3",
        "area_m2",
        "mass_kg",
        "center_of_mass_m",
        "inertia_kg_m2",
        "principal_moments_kg_m2",
        "principal_axes",
        "defects",
    ] {
        assert!(!json[key].is_null(), "{key} is missing");
    }
    assert!((json["volume_m3"].as_f64().unwrap() - 4.0).abs() < 1e-14);
    assert!((json["mass_kg"].as_f64().unwrap() - 4.0).abs() < 1e-14);
    let heavy = place.expect(0, &["mesh", &file, "--json", "--solid", "--mass", "8"]).json();
    assert_eq!(heavy["mass_kg"], 8.0);
    let hollow = place.expect(0, &["mesh", &file, "--json", "--hollow", "--density", "0.5"]).json();
    assert!((hollow["mass_kg"].as_f64().unwrap() - 9.0).abs() < 1e-13);
    let text = place.expect(0, &["mesh", &file]).stdout;
    for part in ["volume", "centre of mass", "(0.75, 1.25, 0.5) m", "no defects"] {
        assert!(text.contains(part), "{part}\n{text}");
    }
}

/// A mesh with a hole has no mass as a solid: the check fails, and the defects are printed all the same.
#[test]
fn open() {
    let place = Place::new();
    place.write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let run = place.expect(1, &["mesh", "sheet.obj", "--json"]);
    assert_eq!(run.json()["defects"][0]["kind"], "open_edge");
    assert!(run.stderr.contains("bounds no solid"), "{}", run.stderr);
    let text = place.expect(1, &["mesh", "sheet.obj"]).stdout;
    assert!(text.contains("3 open edges"), "{text}");
    place.expect(0, &["mesh", "sheet.obj", "--hollow"]);
}

/// Bad numbers and bad files.
#[test]
fn mistakes() {
    let place = Place::new();
    place.write("bad.obj", "v 0 0 zero\n");
    place.write("mesh.stl", "solid\n");
    let file = fixture("meshes/l-shape.obj");
    for args in [
        &["mesh", &file, "--mass", "-1"][..],
        &["mesh", &file, "--mass", "nan"],
        &["mesh", &file, "--density", "0"],
        &["mesh", &file, "--density", "heavy"],
        &["mesh", "bad.obj"],
        &["mesh", "mesh.stl"],
    ] {
        place.expect(2, args);
    }
    place.expect(3, &["mesh", "missing.obj"]);
}

/// What the choices of a reference point cost: nothing at home; far away (case MP-05) the origin ruins the inertia and
/// the centre of mass does not.
#[test]
fn reference_points() {
    let place = Place::new();
    let text = std::fs::read_to_string(fixture("meshes/l-shape.obj")).unwrap();
    let far: String = text
        .lines()
        .map(|line| match line.strip_prefix("v ") {
            Some(numbers) => {
                let v: Vec<f64> = numbers.split_whitespace().map(|x| x.parse().unwrap()).collect();
                format!("v {} {} {}\n", v[0] + 1e6, v[1] - 2e6, v[2] + 3e6)
            }
            None => format!("{line}\n"),
        })
        .collect();
    place.write("far.obj", &far);
    let costs = place.expect(0, &["mesh", "far.obj", "--compare-reference-points", "--json"]).json();
    let costs = costs["reference_points"].as_array().unwrap().clone();
    let errors: Vec<f64> = costs.iter().map(|cost| cost["second_moment_error"].as_f64().unwrap()).collect();
    assert!(errors[0] > 100.0 && errors[1] < 1e-13 && errors[2] < 1e-13, "{errors:?}");
    let text = place.expect(0, &["mesh", "far.obj", "--compare-reference-points", "--hollow"]).stdout;
    assert!(text.contains("average of the vertices") && text.contains("area"), "{text}");
}

/// The estimate repeats for a seed, differs for another, and states an error that its deviation bears out.
#[test]
fn monte_carlo() {
    let place = Place::new();
    let file = fixture("meshes/l-shape.obj");
    let run = |seed: &str| {
        let json = place.expect(0, &["mesh", &file, "--monte-carlo", "10000", "--seed", seed, "--json"]).json();
        let volume = &json["monte_carlo"]["volume_m3"];
        (volume["value"].as_f64().unwrap(), volume["standard_error"].as_f64().unwrap())
    };
    let (value, error) = run("7");
    assert_eq!(run("7"), (value, error));
    assert_ne!(run("8").0, value);
    assert!((value - 4.0).abs() < 5.0 * error && error < 0.05, "{value} {error}");
    let text = place.expect(0, &["mesh", &file, "--monte-carlo", "1000"]).stdout;
    assert!(text.contains("standard error") && text.contains("inertia xy"), "{text}");
    place.expect(2, &["mesh", &file, "--monte-carlo", "1"]);
    place.expect(2, &["mesh", &file, "--monte-carlo", "1000", "--hollow"]);
}

/// Moved, turned, scaled.
#[test]
fn frames() {
    let place = Place::new();
    let file = fixture("meshes/l-shape.obj");
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let centred = place.expect(0, &["mesh", &file, "--recentre", "--json"]).json();
    assert!((0..3).all(|axis| number(&centred["center_of_mass_m"][axis]).abs() < 1e-15));
    let turned = place.expect(0, &["mesh", &file, "--principal", "--json"]).json();
    for axis in 0..3 {
        let moment = number(&turned["principal_moments_kg_m2"][axis]);
        assert!((number(&turned["inertia_kg_m2"][axis][axis]) - moment).abs() < 1e-14);
        assert!((number(&centred["principal_moments_kg_m2"][axis]) - moment).abs() < 1e-14);
    }
    let scaled = place.expect(0, &["mesh", &file, "--scale", "2", "--json"]).json();
    assert!((number(&scaled["inertia_kg_m2"][0][0]) / 32.0 - 41.0 / 12.0).abs() < 1e-13);
    place.expect(2, &["mesh", &file, "--scale", "0"]);
}

/// A cube with a face missing is no solid until it is repaired; the mended mesh reads back from every format, bit by
/// bit where the format holds doubles.
#[test]
fn repaired_and_written() {
    let place = Place::new();
    let corners = "v 0 0 0.1\nv 1 0 0.1\nv 0 1 0.1\nv 1 1 0.1\nv 0 0 1.1\nv 1 0 1.1\nv 0 1 1.1\nv 1 1 1.1\n";
    let faces = "f 1 3 4 2\nf 1 2 6 5\nf 2 4 8 6\nf 4 3 7 8\nf 3 1 5 7\n";
    place.write("cup.obj", &format!("{corners}{faces}"));
    let text = place.expect(1, &["mesh", "cup.obj"]).stdout;
    assert!(text.contains("--repair offers fill_holes"), "{text}");
    assert!(place.expect(1, &["mesh", "cup.obj", "--repair"]).stdout.contains("none was needed or safe"));
    let repair = ["mesh", "cup.obj", "--repair", "--largest-hole", "1", "--json"];
    let json = place.expect(0, &repair).json();
    assert_eq!(json["repairs"]["steps"][0]["repair"], "fill_holes");
    for name in ["cube.obj", "cube.stl", "cube.off", "cube.ply"] {
        place.expect(0, &[&repair[..], &["-o", name]].concat());
        let again = place.expect(0, &["mesh", name, "--json"]).json();
        assert_eq!((&again["volume_m3"], &again["defects"]), (&json["volume_m3"], &json["defects"]), "{name}");
    }
    for mistake in [&["-o", "cube.dae"][..], &["--largest-hole", "2"], &["--encoding", "binary", "-o", "cube.off"]] {
        place.expect(2, &[&repair[..], mistake].concat());
    }
    place.expect(3, &[&repair[..], &["-o", "no-folder/cube.obj"]].concat());
    place.expect(2, &["mesh", "cup.obj", "--largest-hole", "1"]);
    assert!(!place.list().iter().any(|name| name.contains("tmp")), "{:?}", place.list());
}

/// The convex parts of the L-shape fill it exactly; few parts by V-HACD do nearly.
#[test]
fn convex_parts() {
    let place = Place::new();
    let file = fixture("meshes/l-shape.obj");
    let json = place.expect(0, &["mesh", &file, "--decompose", "--json", "-o", "part.ply"]).json();
    let parts = json["decomposition"]["parts"].as_array().unwrap();
    assert_eq!((parts.len(), &json["decomposition"]["way"]), (2, &"exact".into()));
    let volume = |name: &str| place.expect(0, &["mesh", name, "--json"]).json()["volume_m3"].as_f64().unwrap();
    assert!((volume("part-1.ply") + volume("part-2.ply") - 4.0).abs() < 1e-14);
    let json = place.expect(0, &["mesh", &file, "--approximate", "--json"]).json();
    // Two parts that fill it are better than more that nearly do.
    let found = &json["decomposition"];
    assert_eq!((found["parts"].as_array().unwrap().len(), &found["way"]), (2, &"exact".into()));
    let text = place.expect(0, &["mesh", &file, "--decompose"]).stdout;
    assert!(text.contains("convex parts, exact") && text.contains("reflex edges"), "{text}");
    place.expect(2, &["mesh", &file, "--decompose", "--approximate"]);
    place.expect(2, &["mesh", &file, "--decompose", "--hollow"]);
}

/// A cube whose faces share no vertices, as textured files have it: `split` (m) puts the faces apart, `size` (m) is its
/// edge.
fn cube_with_seams(split: f64, size: f64) -> String {
    let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2 & 1].map(|bit| size * (bit as f64 - 0.5));
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]];
    let mut text = String::new();
    for (face, corners) in faces.iter().enumerate() {
        for &k in corners {
            let [x, y, z] = corner(k).map(|coordinate| coordinate * (1.0 + split * face as f64 / size));
            writeln!(text, "v {x:?} {y:?} {z:?}").unwrap();
        }
        let first = 4 * face + 1;
        writeln!(text, "f {first} {} {} {}", first + 1, first + 2, first + 3).unwrap();
    }
    text
}

/// Vertices that are doubled at seams are told as such, with the command that merges them; it does, and so does it for
/// vertices that are nearly equal. A hole is no seam.
#[test]
fn seams_are_told_with_their_repair() {
    let place = Place::new();
    for (split, within) in [(0.0, ""), (1e-9, " --weld-tolerance 1e-8"), (1e-6, " --weld-tolerance 1e-5")] {
        place.write("part.obj", &cube_with_seams(split, 1.0));
        let command = format!("polhode mesh part.obj --repair{within} -o MENDED.obj");
        let said = place.expect(1, &["mesh", "part.obj"]).stderr;
        assert!(said.contains("doubled at seams") && said.contains(&command), "{split}: {said}");
        let scene = "format = 1\n[[bodies]]\nname = \"part\"\nshape.mesh.file = \"part.obj\"\ndensity = 1000\n";
        place.write("scene.toml", scene);
        let said = place.expect(2, &["check", "scene.toml"]).stderr;
        assert!(said.contains("doubled at seams") && said.contains(&format!("--repair{within} -o")), "{split}: {said}");
        let args: Vec<&str> = command.split(' ').skip(1).collect();
        place.expect(0, &args);
        place.expect(0, &["mesh", "MENDED.obj"]);
    }
    let open = cube_with_seams(0.0, 1.0).lines().take(25).collect::<Vec<_>>().join("\n");
    place.write("open.obj", &open);
    assert!(!place.expect(1, &["mesh", "open.obj"]).stderr.contains("seams"));
}

/// A part of 60 m and 1.7e8 kg was drawn in millimetres: it is said, with the factor, where none is given.
#[test]
fn a_part_in_millimetres_is_told() {
    let place = Place::new();
    let file = fixture("meshes/l-shape.obj");
    let large = place.expect(0, &["mesh", &file, "--scale", "20", "--density", "7800", "-o", "large.obj"]);
    assert!(!large.stderr.contains("millimetres"), "{}", large.stderr);
    let run = place.expect(0, &["mesh", "large.obj", "--density", "7800"]);
    for part in ["is the file in millimetres?", "--scale 0.001", "`scale = 0.001`", " kg", "m large"] {
        assert!(run.stderr.contains(part), "{part}: {}", run.stderr);
    }
    assert!(run.stdout.contains("size"), "{}", run.stdout);
    assert!(!place.expect(0, &["mesh", &file]).stderr.contains("millimetres"));
}

//! What is written: every digit, and whole files only.

use crate::{BASE, scene};
use polhode::spatial::{DVec3, Pose, Rotation, Velocity};
use polhode::{BodyId, BodySample, Event, EventKind, Flow, Observer, Scene};
use polhode_scene::output::{COLUMNS, NPY_WIDTH, npy_row};
use polhode_scene::{OutputError, Outputs};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Samples of two bodies with numbers that are hard to print.
fn samples() -> Vec<(f64, Vec<BodySample>)> {
    let awkward = [0.1 + 0.2, 1.0 / 3.0, -0.0, f64::MIN_POSITIVE, 5e-324, f64::MAX, 1e23, 9_007_199_254_740_991.0];
    (0..5)
        .map(|k| {
            let number = |i: usize| awkward[(k + i) % awkward.len()];
            let body = |shift: usize| BodySample {
                pose: Pose::new(
                    Rotation::from_rotation_vector(DVec3::new(0.1, 0.2, 0.3) * (k + shift) as f64),
                    DVec3::new(number(shift), number(shift + 1), number(shift + 2)),
                ),
                velocity: Velocity::new(
                    DVec3::new(number(shift + 3), number(shift + 4), number(shift + 5)),
                    DVec3::new(number(shift + 6), number(shift + 7), 0.1 * k as f64),
                ),
            };
            (0.1 * k as f64, vec![body(0), body(3)])
        })
        .collect()
}

fn write(outputs: &mut Outputs) {
    for (t, bodies) in samples() {
        outputs.sample(t, &bodies);
        assert_eq!(outputs.progress(t), Flow::Continue);
    }
}

fn run(scene: &Scene, files: &[PathBuf]) {
    let mut outputs = Outputs::create(scene, files, None).unwrap();
    write(&mut outputs);
    outputs.finish().unwrap();
}

/// Names of the files in a folder, sorted.
fn list(folder: &TempDir) -> Vec<String> {
    let mut names: Vec<_> =
        std::fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap()
}

/// CSV: the header is literal, reading gives the same bits, all bodies of a sample bear the same text in `t`.
#[test]
fn csv_keeps_every_bit() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.csv");
    run(&scene(BASE), std::slice::from_ref(&path));
    let text = read(&path);
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("t,body,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz"));
    for (t, bodies) in samples() {
        let mut times = Vec::new();
        for (body, name) in bodies.iter().zip(["floor", "brick"]) {
            let fields: Vec<_> = lines.next().unwrap().split(',').collect();
            assert_eq!(fields.len(), COLUMNS.len());
            assert_eq!(fields[1], name);
            times.push(fields[0]);
            let numbers: Vec<u64> = fields[2..].iter().map(|f| f.parse::<f64>().unwrap().to_bits()).collect();
            assert_eq!(numbers, npy_row(t, body)[1..].iter().map(|x| x.to_bits()).collect::<Vec<_>>());
        }
        assert_eq!(times[0], times[1]);
        assert_eq!(times[0].parse::<f64>().unwrap().to_bits(), t.to_bits());
    }
    assert_eq!(lines.next(), None);
}

/// Names with commas, quotes and lines' ends are quoted.
#[test]
fn csv_quotes_names() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.csv");
    run(&scene(&BASE.replace("\"brick\"", r#""a, \"b\"\nc""#)), std::slice::from_ref(&path));
    assert!(read(&path).contains("0.0,\"a, \"\"b\"\"\nc\","));
}

/// NPY: header of version 1.0 with the true shape, aligned to 64 bytes, then little-endian doubles.
#[test]
fn npy() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.npy");
    run(&scene(BASE), std::slice::from_ref(&path));
    let bytes = std::fs::read(&path).unwrap();
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
    let start = 10 + u16::from_le_bytes([bytes[8], bytes[9]]) as usize;
    assert_eq!(start % 64, 0);
    let header = std::str::from_utf8(&bytes[10..start]).unwrap();
    assert!(header.starts_with("{'descr': '<f8', 'fortran_order': False, 'shape': (5, 2, 14), }"), "{header}");
    assert!(header.ends_with('\n'));
    let data: Vec<u64> = bytes[start..].chunks(8).map(|c| u64::from_le_bytes(c.try_into().unwrap())).collect();
    let rows = samples().into_iter().flat_map(|(t, bodies)| bodies.into_iter().map(move |body| npy_row(t, &body)));
    let expected: Vec<u64> = rows.flatten().map(f64::to_bits).collect();
    assert_eq!(data, expected);
    assert_eq!(data.len(), 5 * 2 * NPY_WIDTH);
}

/// JSON: one object with names, columns and samples; numbers keep every bit.
#[test]
fn json() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.json");
    run(&scene(BASE), std::slice::from_ref(&path));
    let value: serde_json::Value = serde_json::from_str(&read(&path)).unwrap();
    assert_eq!(value["scene"], "base");
    assert_eq!(value["bodies"], serde_json::json!(["floor", "brick"]));
    assert_eq!(value["columns"], serde_json::json!(COLUMNS[2..]));
    for (k, (t, bodies)) in samples().iter().enumerate() {
        let sample = &value["samples"][k];
        assert_eq!(sample["t"].as_f64().unwrap().to_bits(), t.to_bits());
        for (i, body) in bodies.iter().enumerate() {
            let numbers: Vec<_> = sample["states"][i].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
            assert_eq!(numbers, npy_row(*t, body)[1..]);
        }
    }
}

/// Events: one row each, with the second body empty where there is none.
#[test]
fn events() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("events.csv");
    let mut outputs = Outputs::create(&scene(BASE), &[], Some(&path)).unwrap();
    let mut impact = Event::new(0.25, EventKind::Impact, BodyId::new(1));
    (impact.body_b, impact.point, impact.normal) = (Some(BodyId::new(0)), DVec3::new(1.0, 2.0, 3.0), DVec3::Z);
    (impact.impulse, impact.energy_change_j) = (0.1, -0.5);
    outputs.event(&impact);
    let mut rest = Event::new(0.25, EventKind::Rest, BodyId::new(1));
    (rest.point, rest.energy_change_j) = (impact.point, impact.energy_change_j);
    outputs.event(&rest);
    outputs.finish().unwrap();
    let expected = "t,kind,body_a,body_b,px,py,pz,nx,ny,nz,impulse,energy_change_j\n\
                    0.25,impact,brick,floor,1.0,2.0,3.0,0.0,0.0,1.0,0.1,-0.5\n\
                    0.25,rest,brick,,1.0,2.0,3.0,0.0,0.0,0.0,0.0,-0.5\n";
    assert_eq!(read(&path), expected);
}

/// What has reached the disk of samples and events at the end of a step ends at the same time: a program that is killed
/// leaves both, one as far as the other.
#[test]
fn events_reach_the_disk_with_the_samples() {
    let folder = tempfile::tempdir().unwrap();
    let (positions, events) = (folder.path().join("a.csv"), folder.path().join("events.csv"));
    let mut outputs = Outputs::create(&scene(BASE), &[positions], Some(&events)).unwrap();
    let body = samples()[0].1[0];
    // Far more than any buffer holds, and too few events to fill one.
    for k in 0..2000 {
        let t = f64::from(k);
        outputs.sample(t, &[body, body]);
        if k % 100 == 0 {
            outputs.event(&Event::new(t, EventKind::Impact, BodyId::new(1)));
        }
        outputs.progress(t);
    }
    let temporary = |begin: &str| {
        let name = list(&folder).into_iter().find(|name| name.starts_with(begin)).unwrap();
        read(&folder.path().join(name))
    };
    let time = |text: &str| text.lines().next_back().unwrap().split(',').next().unwrap().parse::<f64>().unwrap();
    let (of_samples, of_events) = (temporary(".a.csv."), temporary(".events.csv."));
    assert!(of_samples.ends_with('\n') && of_events.ends_with('\n'));
    assert!(time(&of_samples) > 1900.0, "{}", time(&of_samples));
    assert_eq!(time(&of_events), (time(&of_samples) / 100.0).floor() * 100.0);
    outputs.finish().unwrap();
}

/// Joints: one row for each sample, with the coordinates that they have, their loads and their powers. A motor of 0.5 N
/// m turns a wheel of 1 kg m^2: after a second it gives 0.25 W; the bearing bears the weight of 2 kg.
#[test]
fn joints() {
    let text = r#"
format = 1
duration = 1.0
output.interval = 1.0
[[bodies]]
name = "wheel"
shape.cylinder = { radius = 0.1, height = 0.1 }
mass = 2.0
inertia = [1, 1, 1]
[[joints]]
name = "shaft"
type.hinge = { bodies = ["wheel"], anchor = [0, 0, 0], axis = [0, 0, 1], angle = { motor = { effort = 0.5 } } }
"#;
    let loaded = polhode_scene::load_text("wheel.toml", text, &[]).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("joints.csv");
    let outputs = Outputs::create(&loaded.scene, &[], None).unwrap();
    let mut outputs = outputs.with_joints(&path, loaded.joint_names()).unwrap();
    polhode::Simulation::new(&loaded.scene).unwrap().run_observed(&mut outputs).unwrap();
    outputs.finish().unwrap();
    let written = read(&path);
    let lines: Vec<Vec<&str>> = written.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(lines[0], polhode_scene::output::JOINT_COLUMNS);
    assert_eq!(lines.len(), 3, "{written}");
    let number = |place: usize| lines[2][place].parse::<f64>().unwrap();
    assert_eq!((number(0), lines[2][1]), (1.0, "shaft"));
    assert_eq!(lines[2][4..8], [""; 4]);
    for (place, expected) in [(2, 0.25), (3, 0.5), (8, 0.0), (9, 0.0), (10, 19.62), (14, 0.25)] {
        assert!((number(place) - expected).abs() < 1e-12, "column {place}: {written}");
    }
    let wrong = Outputs::create(&loaded.scene, &[], Some(&path)).unwrap().with_joints(&path, Vec::new());
    assert!(matches!(wrong, Err(OutputError::Twice { .. })));
}

/// Until a run is finished nothing changes under a file's name, and a run that is dropped leaves no trace.
#[test]
fn files_appear_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.csv");
    std::fs::write(&path, "before").unwrap();
    let mut outputs = Outputs::create(&scene(BASE), std::slice::from_ref(&path), None).unwrap();
    write(&mut outputs);
    assert_eq!(read(&path), "before");
    drop(outputs);
    assert_eq!(list(&folder), ["a.csv"]);
    assert_eq!(read(&path), "before");
    run(&scene(BASE), std::slice::from_ref(&path));
    assert_eq!(list(&folder), ["a.csv"]);
    assert_eq!(read(&path).lines().count(), 11);
}

/// After a run that failed, what it had written is kept beside the name, complete in its kind.
#[test]
fn partial_files() {
    let folder = tempfile::tempdir().unwrap();
    let names = ["a.csv", "a.npy", "a.json"].map(|name| folder.path().join(name));
    std::fs::write(&names[0], "before").unwrap();
    let mut outputs = Outputs::create(&scene(BASE), &names, None).unwrap();
    let (t, bodies) = samples().remove(0);
    outputs.sample(t, &bodies);
    let kept = outputs.keep_partial().unwrap();
    assert_eq!(kept.len(), 3);
    assert_eq!(list(&folder), ["a.csv", "a.csv.partial", "a.json.partial", "a.npy.partial"]);
    assert_eq!(read(&names[0]), "before");
    assert_eq!(read(&kept[0]).lines().count(), 3);
    serde_json::from_str::<serde_json::Value>(&read(&kept[2])).unwrap();
    let npy = std::fs::read(&kept[1]).unwrap();
    assert!(String::from_utf8_lossy(&npy[..128]).contains("(1, 2, 14)"));
}

/// A link stays a link: what it points to is replaced.
#[cfg(unix)]
#[test]
fn links() {
    let folder = tempfile::tempdir().unwrap();
    let (target, link) = (folder.path().join("target.csv"), folder.path().join("link.csv"));
    std::fs::write(&target, "before").unwrap();
    std::os::unix::fs::symlink(&target, &link).unwrap();
    run(&scene(BASE), std::slice::from_ref(&link));
    assert!(std::fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(read(&target).starts_with("t,body"));
}

/// Files that cannot be written are known before the run.
#[test]
fn refused_outputs() {
    let folder = tempfile::tempdir().unwrap();
    let create = |name: &str| Outputs::create(&scene(BASE), &[folder.path().join(name)], None).unwrap_err();
    assert!(matches!(create("a.txt"), OutputError::Ending { .. }));
    assert!(matches!(create("a"), OutputError::Ending { .. }));
    assert!(matches!(create("a.glb"), OutputError::Ending { .. }));
    assert!(matches!(create("missing/a.csv"), OutputError::Write { .. }));
    std::fs::create_dir(folder.path().join("folder.csv")).unwrap();
    assert!(create("folder.csv").is_input_output());
    let twice = folder.path().join("a.csv");
    let error = Outputs::create(&scene(BASE), std::slice::from_ref(&twice), Some(&twice)).unwrap_err();
    assert!(matches!(error, OutputError::Twice { .. }));
    assert_eq!(list(&folder), ["folder.csv"]);
}

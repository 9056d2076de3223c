//! A trajectory read back is the one that was written, to the last bit, whatever the kind of file.

use polhode::{BodyError, BodySample, Observer, Recorder, Scene, Simulation};
use polhode_scene::{Outputs, Tolerance, TrajectoryReader, compare, load_text};

const SCENE: &str = r#"
format = 1
name = "two"
duration = 1.0
[output]
interval = 0.125
[[bodies]]
name = "a, \"b\""
mass = 2.0
inertia = [1, 2, 2.5]
velocity = [3, 0, 4]
angular_velocity = [0.5, 0.25, 0.1]
[[bodies]]
name = "c"
mass = 1.0
inertia = [1, 1, 1]
position = [0, 0, 1e6]
"#;

fn samples(scene: &Scene, path: &std::path::Path) -> Vec<(f64, Vec<BodySample>)> {
    let mut reader = TrajectoryReader::open(path, scene).unwrap();
    std::iter::from_fn(|| reader.next_sample().unwrap()).collect()
}

#[test]
fn the_same_bits_come_back() {
    let folder = tempfile::tempdir().unwrap();
    let scene = load_text("two.toml", SCENE, &[]).unwrap().scene;
    let paths = ["a.csv", "a.json", "a.npy"].map(|name| folder.path().join(name));
    let mut outputs = Outputs::create(&scene, &paths, None).unwrap();
    Simulation::new(&scene).unwrap().run_observed(&mut outputs).unwrap();
    outputs.finish().unwrap();
    let mut record = Recorder::default();
    Simulation::new(&scene).unwrap().run_observed(&mut record).unwrap();
    for path in &paths {
        let read = samples(&scene, path);
        let times: Vec<f64> = read.iter().map(|(t, _)| *t).collect();
        assert_eq!(times, record.times_s);
        for ((_, bodies), expected) in read.iter().zip(&record.samples) {
            for (body, expected) in bodies.iter().zip(expected) {
                assert_eq!(body.velocity, expected.velocity);
                assert_eq!(body.pose.translation, expected.pose.translation);
                // A quaternion is made of unit length when it is read.
                assert!(body.pose.rotation.angle_to(expected.pose.rotation) < 1e-15);
            }
        }
    }
}

/// Errors that are written are read back bit by bit, whatever the kind of file; a file without them has none, and
/// comparing two trajectories leaves them out.
#[test]
fn errors_come_back_where_they_are_written() {
    let folder = tempfile::tempdir().unwrap();
    let scene = load_text("two.toml", SCENE, &[]).unwrap().scene;
    let paths = ["a.csv", "a.json", "a.npy"].map(|name| folder.path().join(name));
    let mut outputs = Outputs::create_with_errors(&scene, &paths, None).unwrap();
    Simulation::new(&scene).unwrap().run_observed(&mut outputs).unwrap();
    outputs.finish().unwrap();
    let mut record = Recorder::default();
    Simulation::new(&scene).unwrap().run_observed(&mut record).unwrap();
    assert_eq!(record.errors.len(), record.samples.len());
    for path in &paths {
        let mut reader = TrajectoryReader::open(path, &scene).unwrap();
        for expected in &record.errors {
            assert!(reader.next_sample().unwrap().is_some());
            assert_eq!(reader.errors().unwrap(), expected, "{}", path.display());
        }
        assert!(reader.next_sample().unwrap().is_none());
    }
    let text = std::fs::read_to_string(&paths[0]).unwrap();
    assert!(text.lines().next().unwrap().ends_with(",wz,error_m,error_rad"));
    assert!(!text.contains("NaN") && !text.lines().any(|line| line.ends_with(',')), "{text}");
    let without = folder.path().join("without.csv");
    let mut outputs = Outputs::create(&scene, std::slice::from_ref(&without), None).unwrap();
    Simulation::new(&scene).unwrap().run_observed(&mut outputs).unwrap();
    outputs.finish().unwrap();
    let mut reader = TrajectoryReader::open(&without, &scene).unwrap();
    assert!(reader.next_sample().unwrap().is_some() && reader.errors().is_none());
    let comparison = compare(&paths[0], &without, Tolerance::default()).unwrap();
    assert!(comparison.agrees() && comparison.columns.iter().all(|column| !column.column.contains("error")));
}

/// A run that stops before a comparison leaves its last samples without errors: empty, null and not a number. They are
/// whole samples all the same. Errors below zero are refused.
#[test]
fn samples_whose_errors_are_not_known_are_samples() {
    let folder = tempfile::tempdir().unwrap();
    let scene = load_text("two.toml", SCENE, &[]).unwrap().scene;
    let paths = ["a.csv", "a.json", "a.npy"].map(|name| folder.path().join(name));
    let mut outputs = Outputs::create_with_errors(&scene, &paths, None).unwrap();
    let bodies = Simulation::new(&scene).unwrap().bodies();
    outputs.sample(0.0, &bodies);
    outputs.errors(0.0, Some(&[BodyError::new(1e-3, 0.0), BodyError::new(0.0, 2e-3)]));
    outputs.sample(0.5, &bodies);
    let kept = outputs.keep_partial().unwrap();
    for path in &kept {
        let mut reader = TrajectoryReader::open(path, &scene).unwrap();
        assert!(reader.next_sample().unwrap().is_some());
        assert_eq!(reader.errors().unwrap()[1].rotation_rad, 2e-3);
        assert!(reader.next_sample().unwrap().is_some() && reader.errors().is_none());
        assert!(reader.next_sample().unwrap().is_none() && reader.cut_off().is_none());
    }
    let text = std::fs::read_to_string(&kept[0]).unwrap();
    assert!(text.lines().nth(1).unwrap().ends_with(",0.001,0.0") && text.lines().nth(3).unwrap().ends_with(",,"));
    let negative = folder.path().join("negative.csv");
    std::fs::write(&negative, text.replace(",0.001,0.0", ",-0.001,0.0")).unwrap();
    let told = TrajectoryReader::open(&negative, &scene).unwrap_err().to_string();
    assert!(told.contains("negative.csv:2:") && told.contains("error_m is -0.001"), "{told}");
}

//! A trajectory read back is the one that was written, to the last bit, whatever the kind of file.

use polhode::{BodySample, Recorder, Scene, Simulation};
use polhode_scene::{Outputs, TrajectoryReader, load_text};

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

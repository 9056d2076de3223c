//! Robot files in the place of scenes: `check` is a doctor, `run` simulates, settings reach the keys of the scene that
//! the file stands for, an output never replaces a file of the robot, and a bad file is refused with its own lines.

use crate::{Place, fixture};

/// What is found in a sound file is what is ignored of it, with its first place and how often.
#[test]
fn the_doctor() {
    let place = Place::new();
    place.write("arm.urdf", &std::fs::read_to_string(fixture("robots/arm.urdf")).unwrap());
    let run = place.expect(0, &["check", "arm.urdf"]);
    assert!(run.stdout.contains("arm.urdf:56:5: ignored: robot: `effort` of <limit> (2 times): "), "{}", run.stdout);
    assert!(run.stdout.ends_with("arm.urdf: arm: fine; bodies: 3 (1 fixed); duration: 2 s\n"), "{}", run.stdout);
    let heavy = place.read("arm.urdf").replace("mass value=\"2\"", "mass value=\"2000\"");
    place.write("heavy.urdf", &heavy);
    let run = place.expect(0, &["check", "heavy.urdf"]);
    for part in
        ["heavy.urdf:17:5: warning: link `upper`: 2000 kg in a shape of", "\n  cure: check the unit of the mass"]
    {
        assert!(run.stdout.contains(part), "{}", run.stdout);
    }
}

/// A file that is refused is refused by every command, with exit code 2 and its own line; one that is not there with 3.
#[test]
fn refused() {
    let place = Place::new();
    let arm = std::fs::read_to_string(fixture("robots/arm.urdf")).unwrap();
    place.write("bad.urdf", &arm.replace("<child link=\"hand\"/>", "<child link=\"hend\"/>"));
    for command in ["check", "run", "plan"] {
        let run = place.expect(2, &[command, "bad.urdf"]);
        let expected = "bad.urdf:69:5: error: joint `wrist`: no link is named `hend`";
        assert!(run.stderr.contains(expected), "{}", run.stderr);
    }
    place.write("lies.urdf", &arm.replace("izz=\"0.028\"", "izz=\"0.28\""));
    let run = place.expect(2, &["check", "lies.urdf"]);
    assert!(run.stderr.contains("no body can have this inertia"), "{}", run.stderr);
    let run = place.expect(0, &["check", "lies.urdf", "--set", "models.0.unphysical=repair"]);
    assert!(run.stdout.contains("they are replaced by"), "{}", run.stdout);
    place.expect(3, &["check", "none.urdf"]);
    let run = place.expect(2, &["check", "lies.urdf", "--set", "models.0.base=floating"]);
    assert!(run.stderr.contains("accepted: ") && run.stderr.contains("`fixed`"), "{}", run.stderr);
}

/// A robot runs, the ledger closes, and its file is not overwritten.
#[test]
fn runs() {
    let place = Place::new();
    for name in ["arm.urdf", "leg.xml"] {
        place.write(name, &std::fs::read_to_string(fixture(&format!("robots/{name}"))).unwrap());
        let run = place.expect(0, &["run", name, "--json", "--duration", "0.3", "-o", "motion.csv"]);
        let report = run.json();
        assert!(report["ledger"]["closure_relative"].as_f64().unwrap().abs() < 1e-12, "{name}");
    }
    let run = place.expect(0, &["run", "arm.urdf", "--duration", "0.1", "--set", "models.0.configuration.elbow=0.5"]);
    assert!(run.stderr.contains("0 things are simulated otherwise and 2 are ignored"), "{}", run.stderr);
    let run = place.expect(2, &["run", "arm.urdf", "--duration", "0.1", "-o", "arm.urdf"]);
    assert!(!run.stderr.is_empty() && place.read("arm.urdf").starts_with("<?xml"), "{}", run.stderr);
}

/// `check` says what each actuator and each drive does, in numbers and units; what names nothing exits with 2 and the
/// nearest names.
#[test]
fn drives() {
    let place = Place::new();
    for name in ["arm.urdf", "servo-arm.xml"] {
        place.write(name, &std::fs::read_to_string(fixture(&format!("robots/{name}"))).unwrap());
    }
    let run = place.expect(0, &["check", "servo-arm.xml", "--set", "models.0.keyframe=raised"]);
    for part in [
        "servo-arm.xml:26:5: read: actuator `shoulder_servo`: <position> at joint `shoulder`, control -0.8: to -0.8 \
         rad, stiffness 200 N m/rad, damping 12 N m s/rad, at most 60 N m\n",
        "actuator `wrist_motor`: <motor> at joint `wrist`, control 0.02: 0.1 N m\n",
        "ignored: robot: `timestep=\"0.002\"` of <option>: ",
    ] {
        assert!(run.stdout.contains(part), "{}", run.stdout);
    }
    let driven = ["check", "arm.urdf", "--set", "models.0.drives.elbow.motor.effort=50"];
    let run = place.expect(0, &driven);
    let bounded = "joint `elbow`: driven by the scene: 50 N m, at most 30 N m (`effort` of <limit> in its file)";
    assert!(run.stdout.contains(bounded), "{}", run.stdout);
    let run = place.expect(2, &["check", "arm.urdf", "--set", "models.0.drives.elbo.motor.effort=50"]);
    assert!(run.stderr.contains("no hinge or slider is named `elbo`"), "{}", run.stderr);
    assert!(run.stderr.contains("did you mean `elbow`?"), "{}", run.stderr);
    let run = place.expect(2, &["plan", "servo-arm.xml", "--set", "models.0.controls.wrist_moto=1"]);
    assert!(run.stderr.contains("did you mean `wrist_motor`?"), "{}", run.stderr);
}

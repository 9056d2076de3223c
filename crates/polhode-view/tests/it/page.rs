//! Pages: what stands in them, how large they are, and what is refused.

use crate::chunks::unpack;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use polhode::contact::Shape;
use polhode::mesh::solid_box;
use polhode::scene::Joint;
use polhode::spatial::{DVec3, Mass, Pose, UnitVector, Velocity};
use polhode::{Body, BodyId, BodySample, Observer, Recorder, Scene, Simulation};
use polhode_view::{FrameSource, Page, ViewError};
use serde_json::Value;

/// Bricks that tumble through space.
fn tumbling(count: usize, duration_s: f64) -> Scene {
    let mut scene = Scene::builder("tumbling").duration_s(duration_s).output_interval_s(1.0 / 60.0);
    for i in 0..count {
        // Numbers that look random, the same in every run.
        let random = |k: usize| ((i * 7919 + k * 104_729 + 17) % 1009) as f64 / 504.5 - 1.0;
        let vector = |k: usize| DVec3::new(random(k), random(k + 1), random(k + 2));
        let size = DVec3::new(0.1, 0.2, 0.3);
        let brick = Body::movable(format!("brick {i}"), solid_box(size, Mass::new(1.0).unwrap()).unwrap());
        let velocity = Velocity { linear: 2.0 * vector(3), angular: 6.0 * vector(6) };
        let brick = brick.geometry(Shape::cuboid(size).unwrap().into()).velocity(velocity);
        scene = scene.body(brick.pose(Pose::from_translation(DVec3::new(2.0 * i as f64, 0.0, 0.0) + vector(0))));
    }
    scene.no_contact((0..count).map(BodyId::new)).build().unwrap()
}

/// A brick that falls onto a floor.
fn falling() -> Scene {
    let brick = Body::movable("brick", solid_box(DVec3::ONE, Mass::new(2.0).unwrap()).unwrap())
        .geometry(Shape::cuboid(DVec3::ONE).unwrap().into())
        .pose(Pose::from_translation(DVec3::Z));
    let floor = Body::fixed("floor </script>").geometry(Shape::half_space(UnitVector::Z).into());
    Scene::builder("falling").body(floor).body(brick).build().unwrap()
}

fn page_of(scene: &Scene) -> String {
    let page = Page::begin(Vec::new(), scene.name(), "").unwrap();
    let mut run = page.begin_run(scene, "run", FrameSource::Simulation).unwrap();
    Simulation::new(scene).unwrap().run_observed(&mut run).unwrap();
    String::from_utf8(run.end("completed").unwrap().finish(&Value::Null).unwrap()).unwrap()
}

fn element<'a>(page: &'a str, id: &str) -> &'a str {
    let at = page.find(&format!("<script id=\"{id}\"")).unwrap();
    let begin = at + page[at..].find('>').unwrap() + 1;
    &page[begin..begin + page[begin..].find("</script>").unwrap()]
}

/// A quantity that a page holds as numbers of 8 bytes.
fn numbers(value: &Value) -> Vec<f64> {
    let bytes = STANDARD.decode(value.as_str().unwrap()).unwrap();
    bytes.chunks_exact(8).map(|number| f64::from_le_bytes(number.try_into().unwrap())).collect()
}

#[test]
fn frames_are_those_of_the_run() {
    let scene = tumbling(5, 8.0);
    let mut recorder = Recorder::default();
    Simulation::new(&scene).unwrap().run_observed(&mut recorder).unwrap();
    let page = page_of(&scene);
    let show: Value = serde_json::from_str(element(&page, "polhode-show")).unwrap();
    let frames = &show["runs"][0]["frames"];
    assert_eq!(numbers(&frames["times"]), recorder.times_s);
    let quantum = frames["position_quantum_m"].as_f64().unwrap();
    let chunks = frames["chunks"].as_array().unwrap();
    assert!(chunks.len() > 1);
    for (number, chunk) in chunks.iter().enumerate() {
        let (first, count) = (chunk["first"].as_u64().unwrap() as usize, chunk["count"].as_u64().unwrap() as usize);
        let packed = STANDARD.decode(element(&page, &format!("polhode-frames-0-{number}"))).unwrap();
        let (channels, _) = unpack(&packed, 5, count);
        for (frame, samples) in recorder.samples[first..first + count].iter().enumerate() {
            for (body, sample) in samples.iter().enumerate() {
                let p = [0, 1, 2].map(|channel| f64::from(channels[channel][body][frame]) * quantum);
                let apart = (DVec3::from_array(p) - sample.pose.translation).abs().max_element();
                assert!(apart <= 0.5 * quantum * (1.0 + 1e-6), "{apart} {quantum}");
            }
        }
    }
}

/// Below 30 bytes a body and frame, base64 included, besides 1.2 MB for the viewer; and the same bytes every time.
#[test]
fn size() {
    let scene = tumbling(100, 4.0);
    let page = page_of(&scene);
    assert_eq!(page, page_of(&scene));
    let show: Value = serde_json::from_str(element(&page, "polhode-show")).unwrap();
    let count = show["runs"][0]["frames"]["count"].as_u64().unwrap();
    let chunks = show["runs"][0]["frames"]["chunks"].as_array().unwrap().len();
    let frames: usize = (0..chunks).map(|number| element(&page, &format!("polhode-frames-0-{number}")).len()).sum();
    let each = frames as f64 / (100 * count) as f64;
    assert!(each < 30.0, "{each} bytes a body and frame");
    assert!(page.len() - frames < 1_200_000, "{} bytes besides the frames", page.len() - frames);
}

#[test]
fn contents() {
    let page = page_of(&falling());
    // Neither a name nor the viewer can end the element that it stands in.
    let (data, viewer) = page.split_at(page.rfind("<script>\n").unwrap());
    assert_eq!(data.matches("</script").count(), data.matches("<script").count());
    assert_eq!(viewer.matches("</script").count(), 1);
    let show: Value = serde_json::from_str(element(&page, "polhode-show")).unwrap();
    let run = &show["runs"][0];
    assert_eq!(run["bodies"][0]["name"], "floor </script>");
    assert_eq!(run["bodies"][0]["half_spaces"][0]["normal"], serde_json::json!([0.0, 0.0, 1.0]));
    assert_eq!(run["frames"]["moving"], serde_json::json!([1]));
    assert_eq!(run["events"][0]["kind"], "impact");
    let impacts = run["events"].as_array().unwrap().iter().filter(|event| event["kind"] == "impact");
    assert_eq!(impacts.count(), 1, "the four corners are one event");
    let total = run["series"].as_array().unwrap().iter().find(|series| series["name"] == "total").unwrap();
    let total = numbers(&total["values"]);
    assert_eq!(total.len() as u64, run["frames"]["count"].as_u64().unwrap());
    assert!((total[0] - 2.0 * 9.81).abs() < 1e-12);
    assert_eq!(element(&page, "polhode-report"), "null");
}

/// Samples that come too often are left out, but for the last.
#[test]
fn thinning() {
    let scene = falling();
    let page = Page::begin(Vec::new(), "x", "").unwrap();
    let mut run = page.begin_run(&scene, "run", FrameSource::Simulation).unwrap().with_least_interval(0.3);
    Simulation::new(&scene).unwrap().run_observed(&mut run).unwrap();
    let page = String::from_utf8(run.end("completed").unwrap().finish(&Value::Null).unwrap()).unwrap();
    let show: Value = serde_json::from_str(element(&page, "polhode-show")).unwrap();
    let times = numbers(&show["runs"][0]["frames"]["times"]);
    assert_eq!(times.len(), 5, "{times:?}");
    assert_eq!(times.last(), Some(&1.0));
}

#[test]
fn what_is_refused() {
    let empty = Scene::builder("empty").build().unwrap();
    let begin = || Page::begin(Vec::new(), "x", "").unwrap();
    let refused = begin().begin_run(&empty, "run", FrameSource::Simulation);
    assert!(matches!(refused, Err(ViewError::NoBodies(_))));
    assert!(matches!(begin().finish(&Value::Null), Err(ViewError::NoFrames)));
    let scene = falling();
    let run = || begin().begin_run(&scene, "run", FrameSource::Trajectory).unwrap();
    assert!(matches!(run().end("completed"), Err(ViewError::NoFrames)));
    let still = Velocity { linear: DVec3::ZERO, angular: DVec3::ZERO };
    let sample = |z: f64| BodySample { pose: Pose::from_translation(DVec3::Z * z), velocity: still };
    let shown = |samples: &[BodySample]| {
        let mut run = run();
        run.sample(0.0, samples);
        run.end("completed")
    };
    assert!(shown(&[sample(0.0), sample(1.0)]).is_ok());
    assert!(matches!(shown(&[sample(0.0)]), Err(ViewError::BodyCount { found: 1, needed: 2 })));
    assert!(matches!(shown(&[sample(0.0), sample(f64::NAN)]), Err(ViewError::NotFinite { .. })));
}

/// A pendulum on a rope: the page has its hinge as a part, its rope as a link, and the points that a camera holds.
#[test]
fn joints_and_frame() {
    let brick = Body::movable("brick", solid_box(DVec3::ONE, Mass::new(2.0).unwrap()).unwrap())
        .geometry(Shape::cuboid(DVec3::ONE).unwrap().into());
    let mut scene = Scene::builder("hung");
    let a = scene.add_body(brick.clone());
    let b = scene.add_body(brick.renamed("other").pose(Pose::from_translation(DVec3::X * 3.0)));
    let scene = scene
        .joint(Joint::hinge(a, DVec3::Z, UnitVector::Y))
        .joint(Joint::rope(b, DVec3::X * 3.0, DVec3::new(3.0, 0.0, 4.0), 5.0).unwrap())
        .build()
        .unwrap();
    let show: Value = serde_json::from_str(element(&page_of(&scene), "polhode-show")).unwrap();
    let run = &show["runs"][0];
    assert_eq!(run["joints"], 2);
    assert_eq!(run["fixtures"].as_array().unwrap().len(), 1);
    assert_eq!(run["links"][0]["kind"], "rope");
    assert_eq!(run["links"][0]["length_m"], 5.0);
    let standing = run["frame"]["standing"].as_array().unwrap();
    assert!(standing.contains(&serde_json::json!([3.0, 0.0, 4.0])), "{standing:?}");
    assert!(run["frame"]["moving"].as_array().unwrap().len() > 8);
    assert_eq!(run["bodies"][0]["colour"], "#5692cc");
    assert!((show["look"]["field_of_view_rad"].as_f64().unwrap() - 0.6).abs() < 1e-12);
}

/// Page and picture have one palette: the style of a light page has the colours that pictures are drawn with.
#[test]
fn one_palette() {
    let page = page_of(&falling());
    for line in ["--stage: light-dark(#eef1f4", "--ground: light-dark(#dde2e7", "--grid: light-dark(#8e98a4"] {
        assert!(page.contains(line), "{line}");
    }
    let (_, grey) = polhode::scene::COLORS.iter().find(|(name, _)| *name == "grey").unwrap();
    let [r, g, b] = grey;
    assert!(page.contains(&format!("--fixed-body: light-dark(#{r:02x}{g:02x}{b:02x}")));
}

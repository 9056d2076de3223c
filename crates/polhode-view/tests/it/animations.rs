//! Moving pictures come back with their frames and times.

use polhode::contact::Shape;
use polhode::mesh::solid_box;
use polhode::spatial::{DVec3, Mass};
use polhode::{Body, Flow, Scene, Simulation};
use polhode_view::animation::{Pace, Watcher, write_apng, write_gif, write_webp};
use polhode_view::raster::PictureSize;
use polhode_view::{Recording, ViewError};
use std::io::Cursor;

const FRAMES: usize = 6;

fn recording() -> Recording {
    let brick = Body::movable("brick", solid_box(DVec3::ONE, Mass::new(1.0).unwrap()).unwrap())
        .geometry(Shape::cuboid(DVec3::ONE).unwrap().into());
    let scene = Scene::builder("fall").body(brick).duration_s(0.2).output_interval_s(0.04).build().unwrap();
    let mut recording = Recording::new(&scene, 0.0).unwrap();
    Simulation::new(&scene).unwrap().run_observed(&mut recording).unwrap();
    recording.end().unwrap();
    recording
}

fn size() -> PictureSize {
    PictureSize::new(64, 48).unwrap()
}

#[test]
fn gif() {
    let recording = recording();
    let mut bytes = Vec::new();
    write_gif(&Pace::new(&recording, size()).unwrap(), &mut bytes).unwrap();
    let mut decoder = gif::DecodeOptions::new().read_info(Cursor::new(&bytes)).unwrap();
    let mut delays = Vec::new();
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        assert_eq!((frame.width, frame.height), (64, 48));
        delays.push(frame.delay);
    }
    assert_eq!(delays, [4, 4, 4, 4, 4, 100]);
}

#[test]
fn apng() {
    let recording = recording();
    let pace = Pace::new(&recording, size()).unwrap();
    let mut bytes = Vec::new();
    write_apng(&pace, &mut bytes).unwrap();
    let mut reader = png::Decoder::new(Cursor::new(&bytes)).read_info().unwrap();
    assert_eq!(reader.info().animation_control().unwrap().num_frames as usize, FRAMES);
    for drawn in pace.pictures() {
        let (picture, shown_ms) = drawn.unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        assert!(pixels == picture.rgb);
        assert_eq!(u32::from(reader.info().frame_control().unwrap().delay_num), shown_ms);
    }
}

#[test]
fn webp() {
    let recording = recording();
    let pace = Pace::new(&recording, size()).unwrap();
    let mut bytes = Vec::new();
    write_webp(&pace, &mut bytes).unwrap();
    let mut again = Vec::new();
    write_webp(&pace, &mut again).unwrap();
    assert!(bytes == again);
    let mut decoder = image_webp::WebPDecoder::new(Cursor::new(&bytes)).unwrap();
    assert!(decoder.is_animated());
    assert_eq!((decoder.dimensions(), decoder.num_frames() as usize), ((64, 48), FRAMES));
    for drawn in pace.pictures() {
        let (picture, shown_ms) = drawn.unwrap();
        let mut pixels = vec![0; decoder.output_buffer_size().unwrap()];
        assert_eq!(decoder.read_frame(&mut pixels).unwrap(), shown_ms);
        assert!(pixels == picture.rgb);
    }
}

/// Whoever watches the drawing is told how far it is, and stops it where they will.
#[test]
fn drawing_stops_when_it_is_told_to() {
    let recording = recording();
    let told = |drawn| if drawn < 2 { Flow::Continue } else { Flow::Stop };
    let pace = Pace::new(&recording, size()).unwrap().watched_by(Watcher(&told));
    let written = [write_gif(&pace, Vec::new()), write_apng(&pace, Vec::new()), write_webp(&pace, Vec::new())];
    for stopped in written {
        assert!(matches!(stopped, Err(ViewError::Stopped { drawn: 2, frames: FRAMES })), "{stopped:?}");
    }
}

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
    assert_eq!((decoder.width(), decoder.height()), (64, 48));
    let (mut delays, mut cells) = (Vec::new(), 0);
    // What is left of one frame stands where the next one does not draw.
    let mut canvas = vec![0_u8; 3 * 64 * 48];
    for drawn in Pace::new(&recording, size()).unwrap().pictures() {
        let frame = decoder.read_next_frame().unwrap().unwrap();
        delays.push(frame.delay);
        cells += frame.buffer.len();
        let palette = frame.palette.as_ref().unwrap();
        for (place, number) in frame.buffer.iter().enumerate() {
            let (x, y) = (place % usize::from(frame.width), place / usize::from(frame.width));
            let at = 3 * ((usize::from(frame.top) + y) * 64 + usize::from(frame.left) + x);
            canvas[at..at + 3].copy_from_slice(&palette[3 * usize::from(*number)..][..3]);
        }
        let apart = canvas.iter().zip(&drawn.unwrap().0.rgb).map(|(a, b)| a.abs_diff(*b)).max();
        assert!(apart < Some(12), "{apart:?}");
    }
    assert!(decoder.read_next_frame().unwrap().is_none());
    assert_eq!(delays, [4, 4, 4, 4, 4, 100]);
    assert!(cells < FRAMES * 64 * 48, "only what has changed is written");
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

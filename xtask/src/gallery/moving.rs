//! The moving picture of a group, as GIF.

use super::shown::Shown;
use polhode::Observer as _;
use polhode_view::Recording;
use polhode_view::animation::{Pace, write_gif};
use polhode_view::raster::PictureSize;
use std::error::Error;

/// Width and height, pixels.
const SIZE: [u32; 2] = [320, 200];
/// Frames a second at the most, and in all about: a picture is to be small.
const FRAMES_PER_SECOND: f64 = 12.0;
const MOST_FRAMES: f64 = 60.0;

/// The run of a scene as a GIF file. A long run is shown as fast as it must be for so few frames.
///
/// # Errors
/// When it has no frame.
pub(super) fn gif(shown: &Shown) -> Result<Vec<u8>, Box<dyn Error>> {
    let (run, loaded) = (&shown.run, &shown.loaded);
    let duration_s = run.record.times_s.last().copied().unwrap_or_default();
    let interval_s = (1.0 / FRAMES_PER_SECOND).max(duration_s / MOST_FRAMES);
    let mut recording = Recording::new(&run.scene, interval_s)?.shown_as(loaded.appearance());
    for (t, bodies) in run.record.times_s.iter().zip(&run.record.samples) {
        recording.sample(*t, bodies);
    }
    recording.end()?;
    let mut bytes = Vec::new();
    write_gif(&Pace::new(&recording, PictureSize::new(SIZE[0], SIZE[1])?)?, &mut bytes)?;
    Ok(bytes)
}

//! Drawing a still, writing it as a file and reading it back.

use super::selection::Still;
use polhode::Observer as _;
use polhode_cases::Run;
use polhode_scene::LoadedScene;
use polhode_view::Recording;
use polhode_view::raster::{Picture, PictureSize};
use polhode_view::still::{still as draw_still, write_png};
use std::error::Error;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Width and height of a still, pixels.
const SIZE: [u32; 2] = [320, 200];

/// Draws a still of a run, with the path that leads there where the bodies are too small to be seen beside it.
///
/// # Errors
/// When the run has no sample within an output interval of the time.
pub(super) fn draw(still: &Still, loaded: &LoadedScene, run: &Run) -> Result<Picture, Box<dyn Error>> {
    let times = &run.record.times_s;
    let apart = |sample: &usize| (times[*sample] - still.time_s).abs();
    let nearest = (0..times.len()).min_by(|a, b| apart(a).total_cmp(&apart(b)));
    let found = nearest.filter(|sample| apart(sample) <= run.scene.output_interval_s());
    let sample = found.ok_or_else(|| format!("{}: the run has no sample at t = {} s", still.name, still.time_s))?;
    let mut recording = Recording::for_still(&run.scene)?.shown_as(loaded.appearance());
    for (t, bodies) in times[..sample].iter().zip(&run.record.samples) {
        recording.sample(*t, bodies);
    }
    recording.end_at(times[sample], &run.record.samples[sample])?;
    let last = recording.times().len().saturating_sub(1);
    Ok(draw_still(&recording, last, PictureSize::new(SIZE[0], SIZE[1])?)?)
}

/// A picture as the bytes of a PNG file.
///
/// # Errors
/// Those of the encoder.
pub(super) fn png(picture: &Picture) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut bytes = Vec::new();
    write_png(picture, &mut bytes)?;
    Ok(bytes)
}

/// Red, green and blue of every pixel of a PNG file.
///
/// # Errors
/// When there is none, or it is not one of such pixels.
pub(super) fn read_rgb(path: &Path) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path)?)).read_info()?;
    let mut bytes = vec![0; reader.output_buffer_size().ok_or("the picture is too large")?];
    let info = reader.next_frame(&mut bytes)?;
    if info.color_type != png::ColorType::Rgb || info.bit_depth != png::BitDepth::Eight {
        return Err("not red, green and blue of eight bits".into());
    }
    bytes.truncate(info.buffer_size());
    Ok(bytes)
}

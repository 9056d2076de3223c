//! GIF.

use super::pace::Pace;
use crate::error::ViewError;
use ::gif::{Encoder, EncodingError, Frame, Repeat};
use std::io::Write;

/// How coarsely colours are chosen, 1 (finest) to 30.
const COARSENESS: i32 = 10;

/// Writes a moving picture as GIF, which repeats for ever.
///
/// # Errors
/// When a picture is wider or higher than 65535, where the watcher stops it, and those of writing.
pub fn write_gif(pace: &Pace<'_>, out: impl Write) -> Result<(), ViewError> {
    let side = |pixels: u32| u16::try_from(pixels).map_err(|error| ViewError::Encoding(error.to_string()));
    let (width, height) = (side(pace.size().width())?, side(pace.size().height())?);
    let mut encoder = Encoder::new(out, width, height, &[]).map_err(gif_error)?;
    encoder.set_repeat(Repeat::Infinite).map_err(gif_error)?;
    let mut late_ms = 0;
    for drawn in pace.pictures() {
        let (picture, shown_ms) = drawn?;
        let mut frame = Frame::from_rgb_speed(width, height, &picture.rgb, COARSENESS);
        // GIF counts hundredths of a second; what rounding leaves over is made up for later.
        let due_ms = shown_ms + late_ms;
        late_ms = due_ms % 10;
        frame.delay = u16::try_from(due_ms / 10).unwrap_or(u16::MAX);
        encoder.write_frame(&frame).map_err(gif_error)?;
    }
    encoder.into_inner().map_err(gif_error)?.flush()?;
    Ok(())
}

fn gif_error(error: EncodingError) -> ViewError {
    match error {
        EncodingError::Io(error) => ViewError::Write(error),
        error => ViewError::Encoding(error.to_string()),
    }
}

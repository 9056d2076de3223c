//! Animated PNG.

use super::pace::Pace;
use crate::error::ViewError;
use crate::still::png_error;
use std::io::Write;

/// Writes a moving picture as animated PNG, which repeats for ever.
///
/// # Errors
/// When there are more frames than 2^31, where the watcher stops it, and those of writing.
pub fn write_apng(pace: &Pace<'_>, out: impl Write) -> Result<(), ViewError> {
    let count = u32::try_from(pace.count()).map_err(|error| ViewError::Encoding(error.to_string()))?;
    let mut encoder = png::Encoder::new(out, pace.size().width(), pace.size().height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    encoder.set_animated(count, 0).map_err(png_error)?;
    let mut writer = encoder.write_header().map_err(png_error)?;
    for drawn in pace.pictures() {
        let (picture, shown_ms) = drawn?;
        let shown_ms = u16::try_from(shown_ms).unwrap_or(u16::MAX);
        writer.set_frame_delay(shown_ms, 1000).map_err(png_error)?;
        writer.write_image_data(&picture.rgb).map_err(png_error)?;
    }
    writer.finish().map_err(png_error)
}

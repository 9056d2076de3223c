//! GIF. Of each frame after the first the rectangle is written in which it differs from the one before.

use super::pace::Pace;
use super::palette::Palette;
use crate::error::ViewError;
use crate::raster::Picture;
use ::gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};
use std::borrow::Cow;
use std::io::Write;
use std::ops::Range;

/// Writes a moving picture as GIF, which repeats for ever.
///
/// # Errors
/// When a picture is wider or higher than 65535, where the watcher stops it, and those of writing.
pub fn write_gif(pace: &Pace<'_>, out: impl Write) -> Result<(), ViewError> {
    let mut encoder =
        Encoder::new(out, side(pace.size().width())?, side(pace.size().height())?, &[]).map_err(gif_error)?;
    encoder.set_repeat(Repeat::Infinite).map_err(gif_error)?;
    let mut late_ms = 0;
    let mut before: Option<Picture> = None;
    for drawn in pace.pictures() {
        let (picture, shown_ms) = drawn?;
        let [across, down] = changed(before.as_ref(), &picture);
        let rgb = cut(&picture, &across, &down);
        let palette = Palette::of(&rgb);
        let numbers = rgb.chunks_exact(3).map(|color| palette.number_of([color[0], color[1], color[2]]));
        // GIF counts hundredths of a second; what rounding leaves over is made up for later.
        let due_ms = shown_ms + late_ms;
        late_ms = due_ms % 10;
        let frame = Frame {
            left: side(across.start)?,
            top: side(down.start)?,
            width: side(across.end - across.start)?,
            height: side(down.end - down.start)?,
            buffer: Cow::Owned(numbers.collect()),
            palette: Some(palette.colors),
            delay: u16::try_from(due_ms / 10).unwrap_or(u16::MAX),
            dispose: DisposalMethod::Keep,
            ..Frame::default()
        };
        encoder.write_frame(&frame).map_err(gif_error)?;
        before = Some(picture);
    }
    encoder.into_inner().map_err(gif_error)?.flush()?;
    Ok(())
}

fn side(pixels: u32) -> Result<u16, ViewError> {
    u16::try_from(pixels).map_err(|error| ViewError::Encoding(error.to_string()))
}

/// Columns and rows between which a picture differs from the one before; one pixel where it does not.
fn changed(before: Option<&Picture>, picture: &Picture) -> [Range<u32>; 2] {
    let (width, height) = (picture.size.width(), picture.size.height());
    let Some(before) = before else { return [0..width, 0..height] };
    let row = 3 * width as usize;
    let mut ranges = [[u32::MAX, 0], [u32::MAX, 0]];
    for (y, (old, new)) in before.rgb.chunks_exact(row).zip(picture.rgb.chunks_exact(row)).enumerate() {
        let differs = |(old, new): (&[u8], &[u8])| old != new;
        let mut pixels = old.chunks_exact(3).zip(new.chunks_exact(3));
        let Some(first) = pixels.clone().position(differs) else { continue };
        let last = pixels.rposition(differs).unwrap_or(first);
        for ([low, high], [first, last]) in ranges.iter_mut().zip([[first, last], [y, y]]) {
            (*low, *high) = ((*low).min(first as u32), (*high).max(last as u32));
        }
    }
    ranges.map(|[low, high]| if low <= high { low..high + 1 } else { 0..1 })
}

/// Red, green and blue of the pixels of some columns and rows.
fn cut(picture: &Picture, across: &Range<u32>, down: &Range<u32>) -> Vec<u8> {
    let row = 3 * picture.size.width() as usize;
    let part = 3 * across.start as usize..3 * across.end as usize;
    let rows = picture.rgb.chunks_exact(row).take(down.end as usize).skip(down.start as usize);
    rows.flat_map(|row| row.get(part.clone()).unwrap_or_default().iter().copied()).collect()
}

fn gif_error(error: EncodingError) -> ViewError {
    match error {
        EncodingError::Io(error) => ViewError::Write(error),
        error => ViewError::Encoding(error.to_string()),
    }
}

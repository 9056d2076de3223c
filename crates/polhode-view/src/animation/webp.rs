//! Animated WebP without loss: every frame a `VP8L` image in the container of the format.
//!
//! The container is RIFF: four letters, a length of four bytes, the content, and a zero where the length is odd. Its
//! length stands at its beginning, so that the frames are kept, packed, until the last one is there. Source:
//! docs/REFERENCES.md, WebP container.

use super::pace::Pace;
use crate::error::ViewError;
use crate::raster::Picture;
use image_webp::{ColorType, EncodingError, WebPEncoder};
use std::io::Write;

/// The bit of `VP8X` that says that there is an animation.
const ANIMATED: u8 = 0b10;
/// Of a frame: what stood before is replaced, not blended.
const REPLACES: u8 = 0b10;
/// Bytes before the image in a file of one image: `RIFF`, length, `WEBP`.
const FILE_HEADER: usize = 12;

/// Writes a moving picture as WebP, which repeats for ever.
///
/// # Errors
/// When it becomes larger than 4 GiB, where the watcher stops it, and those of writing.
pub fn write_webp(pace: &Pace<'_>, mut out: impl Write) -> Result<(), ViewError> {
    let (width, height) = (pace.size().width(), pace.size().height());
    let mut body = b"WEBP".to_vec();
    let mut extended = vec![ANIMATED, 0, 0, 0];
    extended.extend(three_bytes(width - 1));
    extended.extend(three_bytes(height - 1));
    add_chunk(&mut body, *b"VP8X", &extended)?;
    // Background (transparent), and repeat for ever.
    add_chunk(&mut body, *b"ANIM", &[0; 6])?;
    for drawn in pace.pictures() {
        let (picture, shown_ms) = drawn?;
        let mut frame = Vec::new();
        for number in [0, 0, width - 1, height - 1, shown_ms] {
            frame.extend(three_bytes(number));
        }
        frame.push(REPLACES);
        frame.extend(image_chunk(&picture)?);
        add_chunk(&mut body, *b"ANMF", &frame)?;
    }
    let length = u32::try_from(body.len()).map_err(|error| ViewError::Encoding(error.to_string()))?;
    out.write_all(b"RIFF")?;
    out.write_all(&length.to_le_bytes())?;
    out.write_all(&body)?;
    out.flush()?;
    Ok(())
}

/// The chunk `VP8L` of a picture.
fn image_chunk(picture: &Picture) -> Result<Vec<u8>, ViewError> {
    let mut file = Vec::new();
    let encoder = WebPEncoder::new(&mut file);
    encoder.encode(&picture.rgb, picture.size.width(), picture.size.height(), ColorType::Rgb8).map_err(|error| {
        match error {
            EncodingError::IoError(error) => ViewError::Write(error),
            error => ViewError::Encoding(error.to_string()),
        }
    })?;
    if file.get(FILE_HEADER..FILE_HEADER + 4) == Some(b"VP8L") {
        Ok(file.split_off(FILE_HEADER))
    } else {
        Err(ViewError::Encoding("the encoder of WebP gave something else than a VP8L image".to_owned()))
    }
}

fn add_chunk(body: &mut Vec<u8>, name: [u8; 4], content: &[u8]) -> Result<(), ViewError> {
    let length = u32::try_from(content.len()).map_err(|error| ViewError::Encoding(error.to_string()))?;
    body.extend(name);
    body.extend(length.to_le_bytes());
    body.extend(content);
    if content.len() % 2 == 1 {
        body.push(0);
    }
    Ok(())
}

/// The lowest three bytes of a number, the lowest first.
fn three_bytes(number: u32) -> [u8; 3] {
    let [a, b, c, _] = number.to_le_bytes();
    [a, b, c]
}

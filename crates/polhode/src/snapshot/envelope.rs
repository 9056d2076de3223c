//! The header before the content of a snapshot: a magic word, the version of the format, the length and a checksum.
//!
//! | bytes | holds |
//! |---|---|
//! | 8 | the magic word |
//! | 4 | the version, little-endian |
//! | 8 | the length of the content, little-endian |
//! | 8 | FNV-1a over the magic word, version, length and content |
//! | rest | the content |
//!
//! Each step of FNV-1a is a bijection of the hash, so that every change of a single byte changes the checksum.

use super::SnapshotError;
use super::hash::Fnv1a;

/// The first bytes of a snapshot; the last two of them do not occur in text.
const MAGIC: [u8; 8] = *b"polhod\x1a\x00";

/// Version of the format. Every change of the types in [`super::content`] raises it.
pub(super) const VERSION: u32 = 20;

/// Length of the header, bytes.
const HEADER: usize = 28;

/// The content with its header.
pub(super) fn wrap(content: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(HEADER + content.len());
    bytes.extend(MAGIC);
    bytes.extend(VERSION.to_le_bytes());
    bytes.extend((content.len() as u64).to_le_bytes());
    let checksum = checksum(&bytes, content);
    bytes.extend(checksum.to_le_bytes());
    bytes.extend(content);
    bytes
}

/// The content of bytes with a header.
///
/// # Errors
/// When the bytes are not a complete snapshot of this version.
pub(super) fn unwrap(bytes: &[u8]) -> Result<&[u8], SnapshotError> {
    let found = bytes.len() as u64;
    let short = SnapshotError::Length { expected: HEADER as u64, found };
    let magic = bytes.get(..MAGIC.len().min(bytes.len())).unwrap_or_default();
    if !MAGIC.starts_with(magic) {
        return Err(SnapshotError::NotASnapshot);
    }
    let Some((head, content)) = bytes.split_first_chunk::<HEADER>() else { return Err(short) };
    let (signed, checksum_bytes) = head.split_at(HEADER - size_of::<u64>());
    let version = u32::from_le_bytes([head[8], head[9], head[10], head[11]]);
    if version != VERSION {
        return Err(SnapshotError::Version { found: version, known: VERSION });
    }
    let length = signed.last_chunk().map_or(0, |length| u64::from_le_bytes(*length));
    let expected = length.saturating_add(HEADER as u64);
    if expected != found {
        return Err(SnapshotError::Length { expected, found });
    }
    if checksum(signed, content).to_le_bytes() == checksum_bytes { Ok(content) } else { Err(SnapshotError::Damaged) }
}

fn checksum(signed: &[u8], content: &[u8]) -> u64 {
    let mut hash = Fnv1a::default();
    hash.add(signed);
    hash.add(content);
    hash.value()
}

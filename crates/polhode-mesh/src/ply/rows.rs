//! The body of a PLY file, row by row: words of lines, or numbers of a byte order.

use super::header::{Element, Header, Kind, Scalar};
use crate::read_error::{Place, ReadError, ReadErrorKind};
use crate::words::FEWEST_BYTES;
use crate::words::{Word, Words};

/// Why a value could not be read.
pub(super) enum Fault {
    /// There is none, because the row or the file has ended.
    Ended(Place),
    /// It is not what it should be.
    Error(ReadError),
}

impl From<ReadError> for Fault {
    fn from(error: ReadError) -> Self {
        Self::Error(error)
    }
}

impl Fault {
    /// As an error in a row of an element; `row` rows before it are whole.
    pub(super) fn in_row(self, element: &Element<'_>, row: u64) -> ReadError {
        match self {
            Self::Ended(place) => truncated(place, element, row),
            Self::Error(error) => error,
        }
    }
}

fn truncated(place: Place, element: &Element<'_>, row: u64) -> ReadError {
    let kind = ReadErrorKind::Truncated { items: element.items(), claimed: element.count, found: row };
    ReadError { place, kind }
}

/// The values of a body in order.
pub(super) trait Rows {
    /// Where the next value is.
    fn place(&self) -> Place;
    /// The rows of an element that the rest of the file can hold.
    fn most_rows(&self, element: &Element<'_>) -> usize;
    /// Before the first value of a row.
    fn begin_row(&mut self, element: &Element<'_>, row: u64) -> Result<(), ReadError>;
    /// After the last.
    fn end_row(&mut self) -> Result<(), ReadError>;
    /// A finite number.
    fn finite(&mut self, scalar: Scalar) -> Result<f64, Fault>;
    /// A whole number of at least 0.
    fn whole(&mut self, scalar: Scalar) -> Result<u64, Fault>;
    /// Passes over a value or a list.
    fn skip(&mut self, kind: Kind) -> Result<(), Fault>;
    /// The place of what follows the last row, if anything does.
    fn trailing(&mut self) -> Option<Place>;
}

/// A body of text, every row a line.
pub(super) struct Text<'a> {
    words: Words<'a>,
    /// The first word of the row, until it is taken.
    first: Option<Word<'a>>,
}

impl<'a> Text<'a> {
    pub(super) fn new(bytes: &'a [u8], header: &Header<'_>) -> Self {
        Self { words: Words::within(bytes, header.body, header.line), first: None }
    }

    fn word(&mut self) -> Result<Word<'a>, Fault> {
        self.first.take().or_else(|| self.words.next_word()).ok_or(Fault::Ended(self.words.place()))
    }
}

impl Rows for Text<'_> {
    fn place(&self) -> Place {
        self.words.place()
    }

    fn most_rows(&self, element: &Element<'_>) -> usize {
        let most = self.words.remaining() / (FEWEST_BYTES * element.properties.len()).max(1);
        element.count.min(most as u64) as usize
    }

    fn begin_row(&mut self, element: &Element<'_>, row: u64) -> Result<(), ReadError> {
        self.first = self.words.next_statement();
        if self.first.is_none() { Err(truncated(self.place(), element, row)) } else { Ok(()) }
    }

    fn end_row(&mut self) -> Result<(), ReadError> {
        match self.first.take().or_else(|| self.words.next_word()) {
            None => Ok(()),
            Some(word) => {
                let expected = "the end of the line: a row has one value for each property";
                Err(word.error(|found| ReadErrorKind::Expected { expected, found }))
            }
        }
    }

    fn finite(&mut self, _: Scalar) -> Result<f64, Fault> {
        Ok(self.word()?.finite()?)
    }

    fn whole(&mut self, _: Scalar) -> Result<u64, Fault> {
        Ok(self.word()?.count()?)
    }

    fn skip(&mut self, kind: Kind) -> Result<(), Fault> {
        let words = match kind {
            Kind::Scalar(_) => 1,
            Kind::List { count, .. } => self.whole(count)?,
        };
        // Bounded by the words of the line.
        for _ in 0..words {
            self.word()?;
        }
        Ok(())
    }

    fn trailing(&mut self) -> Option<Place> {
        self.words.next_statement().map(|word| Place::Line(word.line))
    }
}

/// A binary body.
pub(super) struct Binary<'a> {
    bytes: &'a [u8],
    at: usize,
    is_big_endian: bool,
}

impl<'a> Binary<'a> {
    pub(super) fn little_endian(bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at, is_big_endian: false }
    }

    pub(super) fn big_endian(bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at, is_big_endian: true }
    }

    /// The next `N` bytes, as if they were little endian.
    fn take<const N: usize>(&mut self) -> Result<[u8; N], Fault> {
        let found = self.bytes.get(self.at..).and_then(|rest| rest.first_chunk::<N>());
        let mut value = *found.ok_or(Fault::Ended(Place::Byte(self.bytes.len())))?;
        self.at += N;
        if self.is_big_endian {
            value.reverse();
        }
        Ok(value)
    }

    /// A number; every type fits f64.
    fn number(&mut self, scalar: Scalar) -> Result<f64, Fault> {
        Ok(match scalar {
            Scalar::I8 => f64::from(i8::from_le_bytes(self.take()?)),
            Scalar::U8 => f64::from(u8::from_le_bytes(self.take()?)),
            Scalar::I16 => f64::from(i16::from_le_bytes(self.take()?)),
            Scalar::U16 => f64::from(u16::from_le_bytes(self.take()?)),
            Scalar::I32 => f64::from(i32::from_le_bytes(self.take()?)),
            Scalar::U32 => f64::from(u32::from_le_bytes(self.take()?)),
            Scalar::F32 => f64::from(f32::from_le_bytes(self.take()?)),
            Scalar::F64 => f64::from_le_bytes(self.take()?),
        })
    }
}

impl Rows for Binary<'_> {
    fn place(&self) -> Place {
        Place::Byte(self.at)
    }

    fn most_rows(&self, element: &Element<'_>) -> usize {
        let most = self.bytes.len().saturating_sub(self.at) / element.fewest_bytes().max(1);
        element.count.min(most as u64) as usize
    }

    fn begin_row(&mut self, _: &Element<'_>, _: u64) -> Result<(), ReadError> {
        Ok(())
    }

    fn end_row(&mut self) -> Result<(), ReadError> {
        Ok(())
    }

    fn finite(&mut self, scalar: Scalar) -> Result<f64, Fault> {
        let place = self.place();
        let number = self.number(scalar)?;
        if number.is_finite() {
            Ok(number)
        } else {
            Err(ReadError { place, kind: ReadErrorKind::NotFinite(number.to_string()) }.into())
        }
    }

    fn whole(&mut self, scalar: Scalar) -> Result<u64, Fault> {
        let place = self.place();
        let number = self.number(scalar)?;
        if number >= 0.0 {
            Ok(number as u64)
        } else {
            Err(ReadError { place, kind: ReadErrorKind::BadCount(number.to_string()) }.into())
        }
    }

    fn skip(&mut self, kind: Kind) -> Result<(), Fault> {
        let length = match kind {
            Kind::Scalar(scalar) => scalar.size() as u64,
            Kind::List { count, item } => self.whole(count)? * item.size() as u64,
        };
        if length > self.bytes.len().saturating_sub(self.at) as u64 {
            return Err(Fault::Ended(Place::Byte(self.bytes.len())));
        }
        self.at += length as usize;
        Ok(())
    }

    fn trailing(&mut self) -> Option<Place> {
        (self.at < self.bytes.len()).then_some(Place::Byte(self.at))
    }
}

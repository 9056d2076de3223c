//! The header of a PLY file: lines of ASCII up to `end_header`.
//!
//! All lines end as the first does (`\n`, `\r\n` or `\r`), which says where a binary body begins.

use crate::decimal::whole;
use crate::read_error::{Place, ReadError, ReadErrorKind, shown};
use std::collections::BTreeSet;

/// How the body is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// A type of number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    /// Of either set of names.
    fn named(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes in a binary body.
    pub(super) const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    const fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}

/// What a property holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Scalar(Scalar),
    List { count: Scalar, item: Scalar },
}

impl Kind {
    /// Fewest bytes in a binary body.
    const fn fewest_bytes(self) -> usize {
        match self {
            Self::Scalar(scalar) | Self::List { count: scalar, .. } => scalar.size(),
        }
    }
}

/// A property of every row of an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Property<'a> {
    pub(super) name: &'a [u8],
    pub(super) kind: Kind,
}

impl Property<'_> {
    /// Whether it lists the corners of a face.
    pub(super) fn is_corners(&self) -> bool {
        matches!(self.name, b"vertex_indices" | b"vertex_index")
    }
}

/// A table of the body.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Element<'a> {
    pub(super) name: &'a [u8],
    /// Number of rows.
    pub(super) count: u64,
    pub(super) properties: Vec<Property<'a>>,
    place: Place,
}

impl Element<'_> {
    /// Fewest bytes of a row in a binary body.
    pub(super) fn fewest_bytes(&self) -> usize {
        self.properties.iter().map(|property| property.kind.fewest_bytes()).sum()
    }

    /// What its rows are called in an error.
    pub(super) fn items(&self) -> String {
        format!("rows of element {}", shown(self.name))
    }

    fn has_scalar(&self, name: &[u8]) -> bool {
        self.properties.iter().any(|property| property.name == name && matches!(property.kind, Kind::Scalar(_)))
    }
}

/// A header.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Header<'a> {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element<'a>>,
    /// First byte of the body.
    pub(super) body: usize,
    /// First line of the body, from 1.
    pub(super) line: usize,
}

impl<'a> Header<'a> {
    pub(super) fn read(bytes: &'a [u8]) -> Result<Self, ReadError> {
        let mut lines = Lines::new(bytes)?;
        let mut encoding = None;
        let mut elements: Vec<Element<'a>> = Vec::new();
        // Names of all elements, and of the properties of the last.
        let (mut names, mut properties) = (BTreeSet::new(), BTreeSet::new());
        loop {
            let line = lines.next()?;
            match line.words[..] {
                [] | [b"comment" | b"obj_info", ..] => {}
                [b"format", ..] if encoding.is_some() => {
                    return Err(line.error(ReadErrorKind::Repeated("line that begins with 'format'".to_owned())));
                }
                [b"format", name, b"1.0"] => encoding = Some(line.encoding(name)?),
                [b"format", ..] => {
                    return Err(line.expected("format ascii, binary_little_endian or binary_big_endian 1.0"));
                }
                [b"element", name, count] => {
                    properties.clear();
                    elements.push(line.element(name, count, &mut names)?);
                }
                [b"property", ..] => match elements.last_mut() {
                    Some(element) => line.property(element, &mut properties)?,
                    None => return Err(line.expected("an element before its properties")),
                },
                [b"end_header"] => break,
                _ => return Err(line.expected("format, element, property, comment, obj_info or end_header")),
            }
        }
        let place = Place::Line(lines.line);
        let missing = |what| ReadError { place, kind: ReadErrorKind::Missing(what) };
        let header = Self {
            encoding: encoding.ok_or_else(|| missing("line that begins with 'format'"))?,
            elements,
            body: lines.at,
            line: lines.line + 1,
        };
        let vertex = header.element(b"vertex").ok_or_else(|| missing("element vertex"))?;
        for (axis, what) in [
            (b"x", "property x of element vertex"),
            (b"y", "property y of element vertex"),
            (b"z", "property z of element vertex"),
        ] {
            if !vertex.has_scalar(axis) {
                return Err(ReadError { place: vertex.place, kind: ReadErrorKind::Missing(what) });
            }
        }
        let face = header.element(b"face").ok_or_else(|| missing("element face"))?;
        if !face.properties.iter().any(|property| property.is_corners() && matches!(property.kind, Kind::List { .. })) {
            let kind = ReadErrorKind::Missing("property list vertex_indices of element face");
            return Err(ReadError { place: face.place, kind });
        }
        Ok(header)
    }

    /// The element of this name.
    pub(super) fn element(&self, name: &[u8]) -> Option<&Element<'a>> {
        self.elements.iter().find(|element| element.name == name)
    }
}

/// A line of the header.
struct Line<'a> {
    text: &'a [u8],
    words: Vec<&'a [u8]>,
    place: Place,
}

impl<'a> Line<'a> {
    fn error(&self, kind: ReadErrorKind) -> ReadError {
        ReadError { place: self.place, kind }
    }

    fn expected(&self, expected: &'static str) -> ReadError {
        self.error(ReadErrorKind::Expected { expected, found: shown(self.text) })
    }

    fn encoding(&self, name: &[u8]) -> Result<Encoding, ReadError> {
        match name {
            b"ascii" => Ok(Encoding::Text),
            b"binary_little_endian" => Ok(Encoding::LittleEndian),
            b"binary_big_endian" => Ok(Encoding::BigEndian),
            _ => Err(self.expected("format ascii, binary_little_endian or binary_big_endian 1.0")),
        }
    }

    fn element(
        &self,
        name: &'a [u8],
        count: &[u8],
        earlier: &mut BTreeSet<&'a [u8]>,
    ) -> Result<Element<'a>, ReadError> {
        let Some(count) = whole(count).and_then(|count| u64::try_from(count).ok()) else {
            return Err(self.error(ReadErrorKind::BadCount(shown(count))));
        };
        if !earlier.insert(name) {
            return Err(self.error(ReadErrorKind::Repeated(format!("element {}", shown(name)))));
        }
        Ok(Element { name, count, properties: Vec::new(), place: self.place })
    }

    /// Adds the property of this line to an element.
    fn property(&self, element: &mut Element<'a>, earlier: &mut BTreeSet<&'a [u8]>) -> Result<(), ReadError> {
        let accepted = "property TYPE NAME or property list TYPE TYPE NAME with char, uchar, short, ushort, int, uint, \
            float, double";
        let scalar = |name: &[u8]| Scalar::named(name).ok_or_else(|| self.expected(accepted));
        let property = match self.words[..] {
            [_, b"list", count, item, name] => {
                let kind = Kind::List { count: scalar(count)?, item: scalar(item)? };
                Property { name, kind }
            }
            [_, kind, name] => Property { name, kind: Kind::Scalar(scalar(kind)?) },
            _ => return Err(self.expected(accepted)),
        };
        if let Kind::List { count, item } = property.kind
            && !(count.is_integer() && (item.is_integer() || !property.is_corners()))
        {
            return Err(self.expected("integer types for the length of a list and for vertex indices"));
        }
        // A face has its corners once, whichever of their two names they go by.
        let has_corners = || element.properties.iter().any(Property::is_corners);
        if !earlier.insert(property.name) || (element.name == b"face" && property.is_corners() && has_corners()) {
            return Err(self.error(ReadErrorKind::Repeated(format!("property {}", shown(property.name)))));
        }
        element.properties.push(property);
        Ok(())
    }
}

/// The lines of the header.
struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    /// The line read last, from 1.
    line: usize,
    end: &'static [u8],
}

impl<'a> Lines<'a> {
    /// After the first line, which is `ply`.
    fn new(bytes: &'a [u8]) -> Result<Self, ReadError> {
        let (end, at): (&[u8], usize) = match bytes {
            [b'p', b'l', b'y', b'\r', b'\n', ..] => (b"\r\n", 5),
            [b'p', b'l', b'y', b'\n', ..] => (b"\n", 4),
            [b'p', b'l', b'y', b'\r', ..] => (b"\r", 4),
            _ => {
                let found = shown(bytes.split(|byte| matches!(byte, b'\n' | b'\r')).next().unwrap_or(bytes));
                let kind = ReadErrorKind::Expected { expected: "'ply' in a line of its own", found };
                return Err(ReadError { place: Place::Line(1), kind });
            }
        };
        Ok(Self { bytes, at, line: 1, end })
    }

    fn next(&mut self) -> Result<Line<'a>, ReadError> {
        let rest = &self.bytes[self.at..];
        self.line += 1;
        let place = Place::Line(self.line);
        let length = rest.windows(self.end.len()).position(|window| window == self.end);
        let length = length.ok_or(ReadError { place, kind: ReadErrorKind::Ended { expected: "'end_header'" } })?;
        self.at += length + self.end.len();
        let text = &rest[..length];
        let words = text.split(|byte| matches!(byte, b' ' | b'\t' | b'\r')).filter(|word| !word.is_empty()).collect();
        Ok(Line { text, words, place })
    }
}

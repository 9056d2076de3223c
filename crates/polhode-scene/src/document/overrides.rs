//! Values set from outside the file: `--set key=value`.
//!
//! A key is a dotted path as TOML writes it; an element of `bodies` or `arrays` goes by its name or its number (from
//! 0), of other arrays by its number; `position[2]` is `position.2`. A value is TOML; a bare word (`propagation`,
//! `../mesh.obj`) is taken as a string.

use super::source::Source;
use crate::error::Refusal;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

/// A value set from outside the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Override {
    /// What errors name as the place, such as `--set` on the command line.
    pub origin: String,
    /// Dotted path of the key.
    pub key: String,
    /// The value as TOML, or a bare word.
    pub value: String,
}

impl Override {
    /// Sets `key` to `value`; errors name `origin` as the place.
    pub fn new(origin: impl Into<String>, key: impl Into<String>, value: impl Into<String>) -> Self {
        Self { origin: origin.into(), key: key.into(), value: value.into() }
    }

    /// From `key=value`. `None` when there is no `=` outside quotes.
    pub fn parse(origin: impl Into<String>, text: &str) -> Option<Self> {
        let at = split_at(text)?;
        Some(Self::new(origin, text[..at].trim(), text[at + 1..].trim()))
    }

    pub(super) fn text(&self) -> String {
        format!("{}{SEPARATOR}{}", self.key, self.value)
    }
}

/// Between key and value in the text that is parsed and shown.
const SEPARATOR: &str = " = ";

/// Place of the first `=` outside quotes.
fn split_at(text: &str) -> Option<usize> {
    let mut quote = None;
    for (at, c) in text.char_indices() {
        match (quote, c) {
            (None, '=') => return Some(at),
            (None, '"' | '\'') => quote = Some(c),
            (Some(open), c) if open == c => quote = None,
            _ => {}
        }
    }
    None
}

type Fault = (Range<usize>, Refusal);

/// Sets one value in the tree. Ranges of a fault are within the source.
pub(super) fn apply<'t>(root: &mut Spanned<DeTable<'t>>, source: &'t Source) -> Result<(), Fault> {
    let text = source.text();
    let at = split_at(text).unwrap_or(text.len());
    let keys = keys(&text[..at])?;
    let value = value(text, at)?;
    let value = shifted(value, source.start());
    let mut place = Place::Table(root.get_mut());
    let Some((last, path)) = keys.split_last() else {
        return Err((0..at, Refusal::Override("the key is empty".to_owned())));
    };
    for key in path {
        place = place.enter(key, source.start())?;
    }
    place.set(last, value, source.start())
}

/// The number at a dotted key; none where it has none.
pub(super) fn number_at(root: &DeTable<'_>, key: &str) -> Option<f64> {
    let keys = keys(key).ok()?;
    let (first, rest) = keys.split_first()?;
    let mut value = root.get(first.get_ref().as_str())?.get_ref();
    for key in rest {
        value = match value {
            DeValue::Table(table) => table.get(key.get_ref().as_str())?.get_ref(),
            DeValue::Array(array) => array.get(element(array, key).ok()?)?.get_ref(),
            _ => return None,
        };
    }
    match value {
        DeValue::Float(number) => number.as_str().parse().ok(),
        DeValue::Integer(number) => i64::from_str_radix(number.as_str(), number.radix()).ok().map(|whole| whole as f64),
        _ => None,
    }
}

/// A key with numbers in brackets as a dotted path of the same length: `position[2]` is `position.2 `.
fn dotted(text: &str) -> String {
    let mut quote = None;
    let step = |c: char| match (quote, c) {
        (None, '[') => '.',
        (None, ']') => ' ',
        (None, '"' | '\'') => {
            quote = Some(c);
            c
        }
        (Some(open), c) if open == c => {
            quote = None;
            c
        }
        (_, c) => c,
    };
    text.chars().map(step).collect()
}

/// The steps of a dotted key with their ranges.
fn keys(text: &str) -> Result<Vec<Spanned<String>>, Fault> {
    let whole = 0..text.trim_end().len().max(1);
    let fault = |message: String| (whole.clone(), Refusal::Override(message));
    // Parsing it as the key of a table lets TOML decide what is quoted and what is bare.
    let line = format!("{}= {{}}", dotted(text));
    let table = DeTable::parse(&line).map_err(|error| fault(format!("not a key: {}", error.message())))?;
    let mut keys = Vec::new();
    let mut table = table.into_inner();
    while !table.is_empty() {
        let mut entries = table.into_iter();
        let (Some((key, value)), None) = (entries.next(), entries.next()) else {
            return Err(fault("more than one key".to_owned()));
        };
        keys.push(Spanned::new(key.span(), key.into_inner().into_owned()));
        table = match value.into_inner() {
            DeValue::Table(table) => table,
            _ => return Err(fault("not a key".to_owned())),
        };
    }
    Ok(keys)
}

/// The value after the `=` at `at`.
fn value(text: &str, at: usize) -> Result<Spanned<DeValue<'_>>, Fault> {
    let rest = text.get(at + 1..).unwrap_or_default();
    let word = rest.trim();
    let start = text.len() - rest.trim_start().len();
    let span = start..start + word.len();
    match DeValue::parse(word) {
        Ok(value) => Ok(shifted(value, start)),
        Err(_) if is_bare_word(word) => Ok(Spanned::new(span, DeValue::String(word.into()))),
        Err(error) => Err((span, Refusal::Override(format!("not a TOML value or a bare word: {}", error.message())))),
    }
}

/// Whether the text can only be meant as a string: one word without TOML's own signs that does not begin like a number.
fn is_bare_word(word: &str) -> bool {
    let signs = |c: char| c.is_whitespace() || c.is_control() || "\"'[]{}=#,".contains(c);
    let number = |c: char| c.is_ascii_digit() || c == '+' || c == '-';
    !word.is_empty() && !word.contains(signs) && !word.starts_with(number)
}

/// The same value with all ranges moved by `by`.
fn shifted(value: Spanned<DeValue<'_>>, by: usize) -> Spanned<DeValue<'_>> {
    let span = value.span();
    let inner = match value.into_inner() {
        DeValue::Array(array) => DeValue::Array(array.into_iter().map(|element| shifted(element, by)).collect()),
        DeValue::Table(table) => {
            DeValue::Table(table.into_iter().map(|(key, value)| (shifted_key(&key, by), shifted(value, by))).collect())
        }
        leaf => leaf,
    };
    Spanned::new(span.start + by..span.end + by, inner)
}

fn shifted_key<T: Clone>(key: &Spanned<T>, by: usize) -> Spanned<T> {
    Spanned::new(key.span().start + by..key.span().end + by, key.get_ref().clone())
}

/// A place in the tree that can be set or entered.
enum Place<'a, 't> {
    Table(&'a mut DeTable<'t>),
    Array(&'a mut DeArray<'t>),
}

impl<'t> Place<'_, 't> {
    /// Goes one step down; a table that is missing is made.
    fn enter(self, key: &Spanned<String>, start: usize) -> Result<Self, Fault> {
        let value = match self {
            Place::Table(table) => {
                if !table.contains_key(key.get_ref().as_str()) {
                    let made = Spanned::new(shifted_span(key, start), DeValue::Table(DeTable::new()));
                    table.insert(tree_key(key, start), made);
                }
                table.get_mut(key.get_ref().as_str())
            }
            Place::Array(array) => {
                let index = element(array, key)?;
                array.get_mut(index)
            }
        };
        match value.map(Spanned::get_mut) {
            Some(DeValue::Table(table)) => Ok(Place::Table(table)),
            Some(DeValue::Array(array)) => Ok(Place::Array(array)),
            _ => Err((key.span(), Refusal::Override(format!("`{}` is a single value and has no keys", key.get_ref())))),
        }
    }

    fn set(self, key: &Spanned<String>, value: Spanned<DeValue<'t>>, start: usize) -> Result<(), Fault> {
        match self {
            Place::Table(table) => {
                // Removed first, so that the new key's own range replaces the old one.
                table.remove(key.get_ref().as_str());
                table.insert(tree_key(key, start), value);
            }
            Place::Array(array) => {
                let index = element(array, key)?;
                if let Some(place) = array.get_mut(index) {
                    *place = value;
                }
            }
        }
        Ok(())
    }
}

fn shifted_span(key: &Spanned<String>, start: usize) -> Range<usize> {
    key.span().start + start..key.span().end + start
}

fn tree_key<'t>(key: &Spanned<String>, start: usize) -> Spanned<toml::de::DeString<'t>> {
    Spanned::new(shifted_span(key, start), key.get_ref().clone().into())
}

/// Number of the element that goes by this name or number.
fn element(array: &DeArray<'_>, key: &Spanned<String>) -> Result<usize, Fault> {
    let name = |element: &Spanned<DeValue<'_>>| {
        element.get_ref().get("name").and_then(|name| name.get_ref().as_str()).map(str::to_owned)
    };
    let wanted = key.get_ref();
    if let Some(index) = array.iter().position(|element| name(element).as_ref() == Some(wanted)) {
        return Ok(index);
    }
    if let Some(index) = wanted.parse::<usize>().ok().filter(|&index| index < array.len()) {
        return Ok(index);
    }
    let names: Vec<_> = array.iter().filter_map(name).collect();
    let accepted = match (names.is_empty(), array.len()) {
        (_, 0) => "there are none".to_owned(),
        (true, count) => format!("a number from 0 to {}", count - 1),
        (false, count) => format!("{} or a number from 0 to {}", crate::error::list(&names), count - 1),
    };
    Err((key.span(), Refusal::Override(format!("no element `{wanted}`; accepted: {accepted}"))))
}

//! Objects of a JSON document whose keys are read by name.
//!
//! A key that nobody asked for must be reported, and a value that is refused must be named by its path
//! (`rigid_body_problem.rigid_bodies[2].scale`): so the object remembers what was read of it and where it stands.

use super::error::ImportError;
use glam::DVec3;
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::path::Path;

/// An object of the document.
#[derive(Debug)]
pub(super) struct Table<'a> {
    file: &'a Path,
    /// Where the object stands; empty for the document itself.
    path: String,
    object: &'a Map<String, Value>,
    read: BTreeSet<&'static str>,
}

impl<'a> Table<'a> {
    /// The object that `value`, at `path`, must be.
    pub(super) fn new(file: &'a Path, path: String, value: &'a Value) -> Result<Self, ImportError> {
        match value {
            Value::Object(object) => Ok(Self { file, path, object, read: BTreeSet::new() }),
            other => Err(refused(file, &path, format!("{other} is not an object"))),
        }
    }

    /// The path of one of its keys.
    pub(super) fn key(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) }
    }

    /// That the value of `key` is not acceptable, and why.
    pub(super) fn refuse(&self, key: &str, message: impl Into<String>) -> ImportError {
        refused(self.file, &self.key(key), message.into())
    }

    /// The keys that nobody has read, in order of the alphabet.
    pub(super) fn unread(&self) -> Vec<String> {
        self.object.keys().filter(|key| !self.read.contains(key.as_str())).map(|key| self.key(key)).collect()
    }

    /// The value of a key; null counts as absent, as the suite's own reader has it.
    pub(super) fn value(&mut self, key: &'static str) -> Option<&'a Value> {
        self.read.insert(key);
        self.object.get(key).filter(|value| !value.is_null())
    }

    /// A number.
    pub(super) fn number(&mut self, key: &'static str) -> Result<Option<f64>, ImportError> {
        let Some(value) = self.value(key) else { return Ok(None) };
        value.as_f64().map(Some).ok_or_else(|| self.refuse(key, format!("{value} is not a number")))
    }

    /// A whole number.
    pub(super) fn integer(&mut self, key: &'static str) -> Result<Option<i64>, ImportError> {
        let Some(value) = self.value(key) else { return Ok(None) };
        value.as_i64().map(Some).ok_or_else(|| self.refuse(key, format!("{value} is not a whole number")))
    }

    /// Yes or no.
    pub(super) fn flag(&mut self, key: &'static str) -> Result<Option<bool>, ImportError> {
        let Some(value) = self.value(key) else { return Ok(None) };
        value.as_bool().map(Some).ok_or_else(|| self.refuse(key, format!("{value} is neither true nor false")))
    }

    /// Words.
    pub(super) fn text(&mut self, key: &'static str) -> Result<Option<&'a str>, ImportError> {
        let Some(value) = self.value(key) else { return Ok(None) };
        value.as_str().map(Some).ok_or_else(|| self.refuse(key, format!("{value} is not a string")))
    }

    /// Three numbers.
    pub(super) fn vector(&mut self, key: &'static str) -> Result<Option<DVec3>, ImportError> {
        let Some(value) = self.value(key) else { return Ok(None) };
        self.three_numbers(key, value).map(Some)
    }

    /// A list of three numbers each.
    pub(super) fn vectors(&mut self, key: &'static str) -> Result<Option<Vec<DVec3>>, ImportError> {
        let Some(value) = self.value(key) else { return Ok(None) };
        let list = value.as_array().ok_or_else(|| self.refuse(key, "not a list"))?;
        list.iter().map(|item| self.three_numbers(key, item)).collect::<Result<_, _>>().map(Some)
    }

    fn three_numbers(&self, key: &str, value: &Value) -> Result<DVec3, ImportError> {
        let numbers: Option<Vec<f64>> = value.as_array().and_then(|values| values.iter().map(Value::as_f64).collect());
        match numbers.as_deref() {
            Some(&[x, y, z]) => Ok(DVec3::new(x, y, z)),
            _ => Err(self.refuse(key, format!("{value} is not three numbers (plane scenes are not taken over)"))),
        }
    }

    /// One answer for all six directions, or six: three translations, then three rotations.
    pub(super) fn six_flags(&mut self, key: &'static str) -> Result<Option<[bool; 6]>, ImportError> {
        let Some(value) = self.value(key) else { return Ok(None) };
        if let Some(all) = value.as_bool() {
            return Ok(Some([all; 6]));
        }
        let flags: Option<Vec<bool>> = value.as_array().and_then(|values| values.iter().map(Value::as_bool).collect());
        let flags: Option<[bool; 6]> = flags.and_then(|flags| flags.try_into().ok());
        flags.map(Some).ok_or_else(|| self.refuse(key, format!("{value} is neither one nor six of true and false")))
    }

    /// An object within.
    pub(super) fn table(&mut self, key: &'static str) -> Result<Option<Self>, ImportError> {
        let Some(value) = self.value(key) else { return Ok(None) };
        Self::new(self.file, self.key(key), value).map(Some)
    }

    /// A list of objects within.
    pub(super) fn tables(&mut self, key: &'static str) -> Result<Vec<Self>, ImportError> {
        let Some(value) = self.value(key) else { return Ok(Vec::new()) };
        let list = value.as_array().ok_or_else(|| self.refuse(key, "not a list"))?;
        let path = self.key(key);
        list.iter().enumerate().map(|(index, item)| Self::new(self.file, format!("{path}[{index}]"), item)).collect()
    }
}

fn refused(file: &Path, key: &str, message: String) -> ImportError {
    ImportError::Key { path: file.to_owned(), key: key.to_owned(), message }
}

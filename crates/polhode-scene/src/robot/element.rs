//! XML as a tree of elements, each with its place. What a file includes is part of the tree.
//!
//! The library `roxmltree` parses; it is named in this module alone.

use super::finding::{RobotDefect, RobotPlace};
use roxmltree::{Document, Node, ParsingOptions};
use std::path::Path;
use std::sync::Arc;

/// Deepest nesting of elements: a chain of so many bodies is nested so, and reading it must not use up a stack of 2 MB.
pub(super) const DEEPEST: usize = 256;

/// Most elements and texts of a file: a robot has some thousands.
const MOST_NODES: u32 = 4_000_000;

/// The usual prefix of the language of macros in which robots are written for ROS.
const XACRO: &str = "xacro";
const XACRO_PREFIX: &str = "xacro:";

/// An element.
#[derive(Debug, Clone)]
pub(super) struct Element {
    /// Its name, without a prefix.
    pub(super) name: String,
    /// Whether it is one of xacro.
    is_macro: bool,
    attributes: Vec<(String, String)>,
    /// Where it begins.
    pub(super) place: RobotPlace,
    /// The elements in it, in their order.
    pub(super) children: Vec<Self>,
}

/// A defect and its place.
pub(super) type Fault = Box<(RobotPlace, RobotDefect)>;

impl Element {
    /// The root of a text.
    ///
    /// # Errors
    /// When it is no XML or nested too deep.
    pub(super) fn parse(file: &Path, text: &str) -> Result<Self, Fault> {
        let lines = Lines::of(file, text);
        // A document type is skipped by no parser; robot files have none, and entities are a way to blow up a file.
        let options = ParsingOptions { nodes_limit: MOST_NODES, ..ParsingOptions::default() };
        let document = Document::parse_with_options(text, options).map_err(|error| {
            let at = error.pos();
            let place = RobotPlace {
                file: lines.file.clone(),
                line: (at.row as usize).max(1),
                column: (at.col as usize).max(1),
            };
            if matches!(&error, roxmltree::Error::UnknownNamespace(prefix, _) if prefix == XACRO) {
                return Box::new((place, RobotDefect::Xacro(format!("<{XACRO}:..>"))));
            }
            let message = error.to_string();
            let what = message.rsplit_once(" at ").map_or(message.as_str(), |(what, _)| what);
            Box::new((place, RobotDefect::Xml(what.to_owned())))
        })?;
        lines.element(document.root_element(), 0)
    }

    /// An attribute.
    pub(super) fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(own, _)| own == name).map(|(_, value)| value.as_str())
    }

    /// All attributes, in their order.
    pub(super) fn attributes(&self) -> impl Iterator<Item = (&str, &str)> {
        self.attributes.iter().map(|(name, value)| (name.as_str(), value.as_str()))
    }

    /// Sets an attribute that it does not have.
    pub(super) fn set_default(&mut self, name: &str, value: &str) {
        if self.attribute(name).is_none() {
            self.attributes.push((name.to_owned(), value.to_owned()));
        }
    }

    /// The same element with these attributes and nothing in it.
    pub(super) fn with_attributes(&self, attributes: Vec<(String, String)>) -> Self {
        let (name, place) = (self.name.clone(), self.place.clone());
        Self { name, is_macro: self.is_macro, attributes, place, children: Vec::new() }
    }

    /// The elements of this name in it.
    pub(super) fn all<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a Self> {
        self.children.iter().filter(move |child| child.name == name)
    }

    /// What is written in xacro, the first of it with its element: an element of that language, or an attribute with an
    /// expression.
    pub(super) fn xacro(&self) -> Option<(&Self, String)> {
        let is_expression = |value: &str| value.contains("${") || value.contains("$(");
        let expression = || self.attributes.iter().find(|(_, value)| is_expression(value));
        if self.is_macro {
            return Some((self, format!("<{XACRO}:{}>", self.name)));
        }
        let own = expression().map(|(name, value)| (self, format!("{name}=\"{value}\"")));
        own.or_else(|| self.children.iter().find_map(Self::xacro))
    }

    /// The first element of this name in it.
    pub(super) fn first<'a>(&'a self, name: &'a str) -> Option<&'a Self> {
        self.all(name).next()
    }
}

/// From bytes of a text to lines and columns.
struct Lines<'a> {
    file: Arc<Path>,
    text: &'a str,
    /// Where each line begins, bytes.
    starts: Vec<usize>,
}

impl<'a> Lines<'a> {
    fn of(file: &Path, text: &'a str) -> Self {
        let starts = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        Self { file: Arc::from(file), text, starts }
    }

    fn place(&self, at: usize) -> RobotPlace {
        let line = self.starts.partition_point(|&start| start <= at).max(1);
        let start = self.starts.get(line - 1).copied().unwrap_or(0);
        let column = self.text.get(start..at).map_or(1, |before| before.chars().count() + 1);
        RobotPlace { file: self.file.clone(), line, column }
    }

    fn element(&self, node: Node<'_, '_>, depth: usize) -> Result<Element, Fault> {
        let place = self.place(node.range().start);
        if depth > DEEPEST {
            return Err(Box::new((place, RobotDefect::Depth { what: "elements", limit: DEEPEST })));
        }
        let attribute = |own: roxmltree::Attribute<'_, '_>| (own.name().to_owned(), own.value().to_owned());
        let children = node.children().filter(Node::is_element).map(|child| self.element(child, depth + 1));
        Ok(Element {
            name: node.tag_name().name().to_owned(),
            is_macro: self.text.get(node.range().start + 1..).is_some_and(|own| own.starts_with(XACRO_PREFIX)),
            attributes: node.attributes().map(attribute).collect(),
            children: children.collect::<Result<_, _>>()?,
            place,
        })
    }
}

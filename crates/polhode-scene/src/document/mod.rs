//! A scene file that knows where each of its values stands.
//!
//! A document is a set of texts: the file, and one text for each value that is set from outside it. The tree of
//! values is parsed from them with the byte range of every key and value; the ranges of later texts continue those of
//! earlier ones, so that every error, wherever it is found, can name its place and show its line. The tree borrows
//! from the texts and is parsed anew when an error is to be placed.
//!
//! | module | holds |
//! |---|---|
//! | `key_path` | [`KeyPath`]: where a value stands in the tree |
//! | `overrides` | [`Override`]: values set from outside the file |
//! | `source` | [`Sources`]: the texts, and from byte ranges to lines and columns |
//! | `repair` | what is taken out of the tree to find the next error |
//! | `tree` | from paths to ranges and back |

mod key_path;
mod overrides;
mod repair;
mod source;
mod tree;

pub(crate) use key_path::{KeyPath, Step, written as written_key};
pub use overrides::Override;
use repair::Damage;
use source::Sources;

use crate::error::{MOST_ERRORS, Place, Refusal, Refused, SceneFileError};
use crate::format::SceneFile;
use crate::format::planned::{self, Part};
use serde::Deserialize;
use std::ops::Range;
use toml::Spanned;
use toml::de::DeTable;

/// A scene file and the values set from outside it.
#[derive(Debug, Clone)]
pub(crate) struct Document {
    sources: Sources,
    /// Keys that are set from outside, with what sets them.
    set: Vec<(String, String)>,
}

impl Document {
    /// The document `text`, which errors say to come from `origin`, with `overrides` applied in their order.
    pub(crate) fn new(origin: &str, text: String, overrides: &[Override]) -> Self {
        let mut sources = Sources::new(origin, text);
        for change in overrides {
            sources.push(&change.origin, change.text());
        }
        let set = overrides.iter().map(|change| (change.key.clone(), change.origin.clone())).collect();
        Self { sources, set }
    }

    /// The text of the file.
    pub(crate) fn text(&self) -> &str {
        self.sources.texts().0.text()
    }

    /// What has set a key from outside last.
    pub(crate) fn set_by(&self, key: &str) -> Option<&str> {
        self.set.iter().rev().find(|(set, _)| set == key).map(|(_, origin)| origin.as_str())
    }

    /// The document in the types of the format, and then what `check` makes of it. When something is refused, all that
    /// is wrong is told, as far as it can be found at once.
    ///
    /// # Errors
    /// When the text is not TOML, a key or a value is unknown, missing, of the wrong type or not yet available, or
    /// `check` refuses it.
    pub(crate) fn read<T>(
        &self,
        check: impl Fn(&SceneFile) -> Result<T, Vec<(KeyPath, Refusal)>>,
    ) -> Result<(SceneFile, T), SceneFileError> {
        let mut tree = self.tree()?;
        let (mut damage, mut refused) = (Damage::default(), Vec::new());
        while refused.len() <= MOST_ERRORS {
            let (path, span, cause) = match parse(&tree) {
                Ok(file) => match check(&file) {
                    Ok(checked) if refused.is_empty() => return Ok((file, checked)),
                    Ok(_) => break,
                    Err(faults) => {
                        refused.extend(self.of_scene(&tree, &damage, faults));
                        break;
                    }
                },
                Err(fault) => *fault,
            };
            let (key, follows) = (tree::written(tree.get_ref(), &path), damage.explains(&tree, &path, &cause));
            let taken = damage.take(&mut tree, &path, &cause);
            if !follows {
                refused.push(self.located(&span, key, cause));
            }
            if !taken {
                break;
            }
        }
        Err(SceneFileError::of_all(refused))
    }

    /// The errors of a scene that the tree describes, without those that follow from others.
    fn of_scene(&self, tree: &Spanned<DeTable<'_>>, damage: &Damage, faults: Vec<(KeyPath, Refusal)>) -> Vec<Refused> {
        let own = faults.into_iter().filter(|(path, cause)| !damage.explains_later(tree, path, cause));
        own.map(|(path, cause)| {
            let span = tree::spans(tree, &path).value;
            self.located(&span, tree::written(tree.get_ref(), &path), cause)
        })
        .collect()
    }

    /// The error that `cause`, found at `path`, is.
    pub(crate) fn refuse(&self, path: &KeyPath, cause: Refusal) -> SceneFileError {
        match self.tree() {
            Ok(tree) => {
                let span = tree::spans(&tree, path).value;
                self.refused(&span, tree::written(tree.get_ref(), path), cause)
            }
            Err(error) => error,
        }
    }

    /// The errors that faults at these paths are.
    pub(crate) fn refuse_all(&self, faults: Vec<(KeyPath, Refusal)>) -> SceneFileError {
        match self.tree() {
            Ok(tree) => SceneFileError::of_all(self.of_scene(&tree, &Damage::default(), faults)),
            Err(error) => error,
        }
    }

    /// The number that a dotted key has; none where it has none.
    pub(crate) fn number(&self, key: &str) -> Option<f64> {
        overrides::number_at(self.tree().ok()?.get_ref(), key)
    }

    /// The format takes these changes besides those that are there.
    ///
    /// # Errors
    /// Why it does not.
    pub(crate) fn taken(&self, changes: &[Override]) -> Result<(), Refusal> {
        let mut other = self.clone();
        for change in changes {
            other.sources.push(&change.origin, change.text());
        }
        let (file, rest) = other.sources.texts();
        let mut tree = DeTable::parse(file.text()).map_err(|error| Refusal::Syntax(error.message().to_owned()))?;
        for change in rest {
            overrides::apply(&mut tree, change).map_err(|(_, cause)| cause)?;
        }
        parse(&tree).map(|_| ()).map_err(|fault| {
            let (_, _, cause) = *fault;
            cause
        })
    }

    /// The tree of values.
    fn tree(&self) -> Result<Spanned<DeTable<'_>>, SceneFileError> {
        let (file, rest) = self.sources.texts();
        let mut tree = DeTable::parse(file.text())
            .map_err(|error| self.syntax(error.span().unwrap_or_default(), error.message()))?;
        for change in rest {
            overrides::apply(&mut tree, change).map_err(|(span, cause)| {
                self.refused(&(span.start + change.start()..span.end + change.start()), change.key().to_owned(), cause)
            })?;
        }
        Ok(tree)
    }

    fn syntax(&self, span: Range<usize>, message: &str) -> SceneFileError {
        self.refused(&span, String::new(), Refusal::Syntax(message.to_owned()))
    }

    fn refused(&self, span: &Range<usize>, key: String, cause: Refusal) -> SceneFileError {
        SceneFileError::Refused(Box::new(self.located(span, key, cause)))
    }

    fn located(&self, span: &Range<usize>, key: String, cause: Refusal) -> Refused {
        let place: Place = self.sources.place(span, key);
        let rendered = self.sources.render(span, &place, &cause);
        Refused { place, cause, rendered, at: span.start }
    }
}

/// The tree in the types of the format; what is refused first, its path and the range to show.
fn parse(tree: &Spanned<DeTable<'_>>) -> Result<SceneFile, Box<(KeyPath, Range<usize>, Refusal)>> {
    if let Some(request) = planned::requested(tree.get_ref()) {
        let cause = Refusal::NotYetAvailable { what: request.what, instead: request.instead.to_owned() };
        let spans = tree::spans(tree, &request.path);
        let span = match request.part {
            Part::Key => spans.key,
            Part::Value => spans.value,
        };
        return Err(Box::new((request.path, span, cause)));
    }
    SceneFile::deserialize(toml::Deserializer::from(tree.clone())).map_err(|error| {
        let span = error.span().unwrap_or_default();
        let path = tree::path_at(tree, &span);
        let cause = Refusal::from_message(error.message(), &path);
        Box::new((path, span, cause))
    })
}

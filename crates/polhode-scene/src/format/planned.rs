//! Members of the format that are designed but not built yet.
//!
//! They are known by name so that a scene that asks for one is told `not yet available` and what to use instead,
//! rather than that it has made a spelling mistake. They are no members of the format's types and so absent from the
//! schema.

use crate::document::{KeyPath, Step};
use toml::de::{DeTable, DeValue};

/// A key, or some values of a key, that will come.
struct Planned {
    /// The path; `*` stands for any key or number.
    path: &'static [&'static str],
    /// The values; empty when the key itself is not available.
    values: &'static [&'static str],
    /// What can be used instead.
    instead: &'static str,
}

/// What of an entry is planned.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    /// The key.
    Key,
    /// The value.
    Value,
}

/// Something planned that a scene asks for.
pub(crate) struct Request {
    /// What of the entry is to blame.
    pub(crate) part: Part,
    /// Where.
    pub(crate) path: KeyPath,
    /// What was asked for.
    pub(crate) what: String,
    /// What can be used instead.
    pub(crate) instead: &'static str,
}

const PLANNED: &[Planned] = &[Planned {
    path: &["method", "contact"],
    values: &["interior-point"],
    instead: "active-set, with tier fast sequential-impulses or nncg, or with tier thesis least-force, heuristic or \
        guesses",
}];

/// The first planned member that a document asks for, in the order of the list.
pub(crate) fn requested(root: &DeTable<'_>) -> Option<Request> {
    PLANNED.iter().find_map(|planned| in_table(planned, planned.path, root, &KeyPath::root()))
}

fn in_table(planned: &Planned, path: &[&str], table: &DeTable<'_>, at: &KeyPath) -> Option<Request> {
    let (name, rest) = path.split_first()?;
    table.iter().filter(|(key, _)| *name == "*" || key.get_ref() == name).find_map(|(key, value)| {
        in_value(planned, rest, value.get_ref(), &at.then(Step::key(key.get_ref().to_string())))
    })
}

fn in_value(planned: &Planned, rest: &[&str], value: &DeValue<'_>, at: &KeyPath) -> Option<Request> {
    if rest.is_empty() {
        return request(planned, value, at);
    }
    match value {
        DeValue::Table(table) => in_table(planned, rest, table, at),
        DeValue::Array(array) if rest[0] == "*" => array.iter().enumerate().find_map(|(index, element)| {
            in_value(planned, &rest[1..], element.get_ref(), &at.then(Step::Index(index)))
        }),
        _ => None,
    }
}

fn request(planned: &Planned, value: &DeValue<'_>, at: &KeyPath) -> Option<Request> {
    let last = planned.path.last().copied().unwrap_or_default();
    let (part, what) = match value {
        _ if planned.values.is_empty() => (Part::Key, last.to_owned()),
        DeValue::String(text) if planned.values.contains(&text.as_ref()) => {
            (Part::Value, format!("{last} = \"{text}\""))
        }
        _ => return None,
    };
    Some(Request { part, path: at.clone(), what, instead: planned.instead })
}

#[cfg(test)]
mod tests {
    //! What a refusal of a tier names instead is every tier that there is.
    use super::*;
    use polhode::scene::Tier;

    #[test]
    fn all_tiers_are_named_instead() {
        let tier = PLANNED.iter().find(|planned| planned.path == ["method", "tier"]);
        for known in Tier::ALL {
            assert!(tier.is_none_or(|planned| planned.instead.contains(known.name())), "{}", known.name());
            assert!(tier.is_none_or(|planned| !planned.values.contains(&known.name())), "{}", known.name());
        }
    }
}

//! The step of a verification that looks at the viewer.

use super::browser::{self, Aim};
use super::bundle;
use super::node::Node;
use polhode_cases::row::Row;
use polhode_cases::{CaseResult, Context, guarded};

/// Name of the step, as of a case.
pub(crate) const NAME: &str = "viewer";

/// Checks the bundle and the pages.
pub(crate) fn check(context: &Context) -> Vec<Row> {
    guarded(NAME, || rows(context, Aim::Check))
}

/// Writes committed pictures of pages anew that are others than before.
pub(crate) fn record(context: &Context) -> Vec<Row> {
    guarded(NAME, || rows(context, Aim::Record))
}

fn rows(context: &Context, aim: Aim) -> CaseResult {
    let node = match Node::with_packages(&context.root) {
        Ok(node) => node,
        Err(reason) => return Ok(vec![Row::skipped(NAME, "bundle, and pages in a browser", &reason)]),
    };
    let mut rows = match aim {
        Aim::Check => bundle::rows(NAME, &node)?,
        Aim::Record => Vec::new(),
    };
    match node.browser() {
        Ok(browser) => rows.extend(browser::rows(NAME, context, &node, &browser, aim)?),
        Err(reason) => rows.push(Row::skipped(NAME, "pages in a browser", &reason)),
    }
    Ok(rows)
}

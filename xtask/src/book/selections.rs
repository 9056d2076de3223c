//! Commands that select cases of a verification by name: each selects some.

use super::page::Page;

/// The option, as it stands in a document.
const OPTION: &str = "--only ";

/// Every pattern of these pages that none of the names contains, and how many patterns there are.
pub(super) fn of_nothing(pages: &[Page], names: &[String]) -> (Vec<String>, usize) {
    let (mut faults, mut count) = (Vec::new(), 0);
    for page in pages {
        for (number, line) in page.text.lines().enumerate() {
            for pattern in patterns_in(line) {
                count += 1;
                let is_in = |name: &String| name.to_lowercase().contains(&pattern.to_lowercase());
                if !names.iter().any(is_in) {
                    faults.push(format!("{}:{}: no case contains \"{pattern}\"", page.path, number + 1));
                }
            }
        }
    }
    (faults, count)
}

/// What stands behind the option in a line: between quotes, or up to a space or a backtick.
fn patterns_in(line: &str) -> Vec<&str> {
    let behind = line.split(OPTION).skip(1);
    let pattern = |rest: &'_ str| -> usize { rest.find([' ', '`', '\'', ')', ',', '|']).unwrap_or(rest.len()) };
    behind
        .map(|rest| match rest.strip_prefix('"') {
            Some(quoted) => quoted.split('"').next().unwrap_or_default(),
            None => &rest[..pattern(rest)],
        })
        .collect()
}

#[cfg(test)]
mod tests {
    //! Patterns are found with and without quotes, and one that selects nothing is told with its line.
    use super::*;

    #[test]
    fn patterns_that_select_nothing() {
        let text = "Run\n`cargo xtask verify --only \"scenes of\"`, or `--only fc-` (or `--only nothing`).\n";
        let page = Page { path: "a.md".into(), text: text.into() };
        let names = ["scenes of friction".to_owned(), "FC-01".to_owned()];
        let (faults, count) = of_nothing(&[page], &names);
        assert_eq!((faults, count), (vec!["a.md:2: no case contains \"nothing\"".to_owned()], 3));
    }
}

//! Places that name, call and choose solvers, and form dense matrices.

use crate::house::count::{Count, FACADE, RESPONSE, is_in, starts_of, words};
use crate::house::rust_source::RustSource;

/// What names a solver, anywhere in a line: types and functions of `polhode-response`.
const NAMES_OF_SOLVERS: [&str; 8] = [
    "ComplementaritySolver",
    "BodySolver",
    "HeldForest",
    "LeastNorm",
    "least_norm",
    "least_forces",
    "FrictionSettings",
    "solve_in_bodies",
];
/// The others of the review's regular expression.
const MORE_NAMES: [&str; 1] = ["SlidingRow"];
/// What names a solver as a word of its own.
const DELASSUS: &str = "Delassus";

/// Methods that solve, of types of `polhode-response`.
const METHODS: [&str; 4] = ["solve", "solve_with_forest", "solve_in_bodies", "resolve"];
/// Functions that solve.
const FUNCTIONS: [&str; 13] = [
    "solve",
    "solve_complementarity",
    "solve_friction",
    "least_norm_forces",
    "least_norm_forces_beside",
    "least_norm_sliding_forces",
    "least_forces_in_cones",
    "least_force",
    "minimum_norm",
    "guesses",
    "motion_depends_on_choice",
    "strike",
    "remove",
];

/// The file that may choose: all thresholds stand there in the end.
const WAY: &str = "way.rs";

/// A number of rows, contacts or bodies from which on another solver is chosen.
struct Threshold {
    name: &'static str,
    /// The name of the file that defines it, in the facade or in `polhode-response`. Its folder does not matter.
    file: &'static str,
}

/// All of them.
const THRESHOLDS: &[Threshold] = &[
    Threshold { name: "STEP_IN_BODIES", file: "way.rs" },
    Threshold { name: "STEP_MOST_ROWS", file: "way.rs" },
    Threshold { name: "MATRIX_MOST_ROWS", file: "way.rs" },
    Threshold { name: "DISPLACEMENT_IN_BODIES", file: "way.rs" },
    Threshold { name: "REST_IN_BODIES", file: "way.rs" },
    Threshold { name: "TREES", file: "way.rs" },
    Threshold { name: "TREES_WITH_LOOPS", file: "way.rs" },
    Threshold { name: "MANY_OF_A_PAIR", file: "way.rs" },
    Threshold { name: "IMPACT_MOST_ROWS", file: "way.rs" },
    Threshold { name: "LEAST_NORM_MOST_ROWS", file: "way.rs" },
    Threshold { name: "IMPACT_IN_BODIES", file: "way.rs" },
    Threshold { name: "REDUCED_FRONT", file: "way.rs" },
    Threshold { name: "CONE_PROGRAMME_MOST_ROWS", file: "way.rs" },
];

pub(super) fn counts(sources: &[RustSource]) -> Vec<Count> {
    let facade: Vec<&RustSource> = sources.iter().filter(|source| is_in(source, FACADE)).collect();
    let (inside, outside): (Vec<&RustSource>, Vec<&RustSource>) =
        facade.iter().filter(|source| names_a_solver(source)).partition(|source| source.path().contains("/solve/"));
    let (thesis, product): (Vec<&RustSource>, Vec<&RustSource>) =
        facade.iter().partition(|source| source.path().contains("/thesis/"));
    let sum = |sources: &[&RustSource], count: fn(&RustSource) -> usize| {
        sources.iter().map(|s| count(s)).sum::<usize>() as u64
    };
    vec![
        Count {
            key: "solver_names_outside",
            check: "files of polhode that name a solver, tests and comments too, outside solve/",
            review: Some(16),
            now: outside.len() as u64,
            goal: Some(0),
        },
        Count {
            key: "solver_names_inside",
            check: "the same within solve/",
            review: Some(10),
            now: inside.len() as u64,
            goal: Some(1),
        },
        Count {
            key: "solver_calls",
            check: "calls of a solver in polhode",
            review: Some(44),
            now: sum(&facade, calls),
            goal: Some(6),
        },
        Count {
            key: "dense_matrices",
            check: "places of polhode that form a dense Delassus matrix, the tier thesis apart",
            review: Some(15),
            now: sum(&product, dense_matrices),
            goal: Some(0),
        },
        Count {
            key: "dense_matrices_thesis",
            check: "the same in the tier thesis",
            review: Some(2),
            now: sum(&thesis, dense_matrices),
            goal: Some(2),
        },
        Count {
            key: "thresholds",
            check: "sizes that choose a solver, outside of the table of way.rs",
            review: Some(12),
            now: THRESHOLDS.iter().filter(|threshold| threshold.file != WAY).count() as u64,
            goal: Some(0),
        },
    ]
}

/// The thresholds that are not where the list says.
pub(super) fn thresholds_gone(sources: &[RustSource]) -> Vec<String> {
    let stands = |threshold: &&Threshold| {
        let is_file = |source: &&RustSource| {
            let in_folder = is_in(source, FACADE) || is_in(source, RESPONSE);
            in_folder && source.path().rsplit('/').next() == Some(threshold.file)
        };
        let definition = format!("const {}: ", threshold.name);
        sources.iter().filter(is_file).any(|source| source.product_code().any(|(_, line)| line.contains(&definition)))
    };
    let gone = THRESHOLDS.iter().filter(|threshold| !stands(threshold));
    gone.map(|threshold| {
        format!(
            "{} is not defined in {} any more: take it off the list of thresholds, or say where it has gone",
            threshold.name, threshold.file
        )
    })
    .collect()
}

/// Whether any line names a solver, in code, comments or tests: the regular expression of the review's table.
fn names_a_solver(source: &RustSource) -> bool {
    source.text().iter().any(|line| {
        NAMES_OF_SOLVERS.iter().chain(&MORE_NAMES).any(|name| line.contains(name)) || words(line, DELASSUS) > 0
    })
}

/// Calls of methods and functions that solve, in a file that names `polhode_response`. A method `resolve` of the value
/// itself is its own. Fails: a method of another type with one of these names is counted where the file names the crate
/// as well.
fn calls(source: &RustSource) -> usize {
    let lines: Vec<&str> = source.product_code().map(|(_, line)| line).collect();
    if !lines.iter().any(|line| line.contains("polhode_response")) {
        return 0;
    }
    let imported = imported_functions(&lines);
    let of_line = |line: &&str| {
        let called = |name: &'static str| {
            let is_called = move |at: &usize| line[at + name.len()..].starts_with('(');
            starts_of(line, name).filter(is_called).map(|at| &line[..at])
        };
        let methods = METHODS
            .iter()
            .flat_map(|name| called(name))
            .filter(|before| before.ends_with('.') && !before.ends_with("self."));
        let functions = FUNCTIONS.iter().flat_map(|name| called(name).map(move |before| (name, before)));
        let functions = functions.filter(|(name, before)| {
            let is_bare = !before.ends_with(['.', ':']) && !before.ends_with("fn ");
            (is_bare && imported.contains(name)) || before.ends_with("polhode_response::")
        });
        methods.count() + functions.count()
    };
    lines.iter().map(of_line).sum()
}

/// The functions of the list that a `use` brings in from `polhode_response`.
fn imported_functions(lines: &[&str]) -> Vec<&'static str> {
    let code = lines.join(" ");
    let items: Vec<&str> =
        code.split("use polhode_response::").skip(1).filter_map(|rest| rest.split(';').next()).collect();
    FUNCTIONS.iter().copied().filter(|name| items.iter().any(|item| words(item, name) > 0)).collect()
}

fn dense_matrices(source: &RustSource) -> usize {
    source
        .product_code()
        .map(|(_, line)| line.matches(".delassus()").count() + line.matches("delassus_into(").count())
        .sum()
}

#[cfg(test)]
mod tests {
    //! Calls and names are counted where they stand; what only looks like them is not.
    use super::*;

    fn source(text: &str) -> RustSource {
        RustSource::new("crates/polhode/src/a.rs", text)
    }

    #[test]
    fn calls_of_solvers_are_counted() {
        let text = "use polhode_response::{\n    Law, least_force,\n};\n\
                    fn f() {\n    let a = solver.solve(b);\n    least_force(c);\n    guesses(d);\n    \
                    polhode_response::solve(e);\n    self.resolve(g);\n    Forces::solve(h);\n    solves(i);\n}\n\
                    #[cfg(test)]\nmod tests {\n    fn g() { solver.solve(b); }\n}\n";
        assert_eq!(calls(&source(text)), 3);
        assert_eq!(calls(&source("fn f() { solver.solve(b); }\n")), 0);
    }

    #[test]
    fn names_of_solvers_are_found() {
        assert!(names_a_solver(&source("//! See [`Delassus`].\n")));
        assert!(names_a_solver(&source("fn f(a: &LeastNormHold) {}\n")));
        assert!(!names_a_solver(&source("fn f(a: DelassusLike) {}\n")));
    }

    #[test]
    fn dense_matrices_of_tests_do_not_count() {
        let text = "fn f() { a.delassus(); b.delassus_into(c); }\n#[cfg(test)]\n\
            mod tests {\n    fn g() { a.delassus(); }\n}\n";
        assert_eq!(dense_matrices(&source(text)), 2);
    }

    #[test]
    fn a_threshold_that_moved_to_another_folder_is_found_and_one_that_is_gone_is_told() {
        let moved = RustSource::new("crates/polhode-response/src/new/way.rs", "const REST_IN_BODIES: usize = 100;\n");
        let gone = thresholds_gone(&[moved]);
        assert_eq!(gone.len(), THRESHOLDS.len() - 1);
        assert!(!gone.iter().any(|gone| gone.contains("REST_IN_BODIES ")));
    }
}

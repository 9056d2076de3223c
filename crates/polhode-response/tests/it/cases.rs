//! How many cases a property test runs: few by default, as many as the environment asks for otherwise.

use proptest::test_runner::Config;

/// `count` cases, or those of the variable `PROPTEST_CASES`; other variables of proptest count as well, such as
/// `PROPTEST_RNG_SEED`, which makes runs the same.
pub(crate) fn few(count: u32) -> Config {
    let config = Config { failure_persistence: None, ..Config::default() };
    if std::env::var_os("PROPTEST_CASES").is_some() { config } else { Config { cases: count, ..config } }
}

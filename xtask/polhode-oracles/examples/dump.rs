//! temporary
use polhode_oracles::random_mechanism::{generate, placement::Placement};
fn main() {
    for a in std::env::args().skip(1) {
        let seed: u64 = a.parse().unwrap();
        let text = generate::scene(seed).written(&Placement::AS_IS, "accurate", None);
        std::fs::write(format!("/tmp/o/m{seed}.toml"), text).unwrap();
    }
}

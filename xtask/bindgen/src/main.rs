//! `bindgen WASM FOLDER`: writes the page's side of a library that was compiled for `wasm32-unknown-unknown`, as a
//! script without modules, and the library without what only the tool needs. `cargo xtask playground` calls it.

use std::process::ExitCode;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [library, folder] = &arguments[..] else {
        eprintln!("usage: bindgen WASM FOLDER");
        return ExitCode::from(2);
    };
    let mut bindgen = Bindgen::new();
    bindgen.input_path(library).typescript(false).remove_name_section(true).remove_producers_section(true);
    let made = bindgen.no_modules(true).and_then(|bindgen| bindgen.generate(folder));
    match made {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error:#}");
            ExitCode::FAILURE
        }
    }
}

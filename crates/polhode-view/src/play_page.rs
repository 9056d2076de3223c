//! The playground: one HTML file with the engine in it, which runs scenes by itself.
//!
//! Layout: the head with its style, the elements, what the page begins with as JSON, and what is packed: the engine
//! (WebAssembly by LZMA), the script of its worker, further scenes, licences and the script of the page (gzip), as
//! letters of 7 bits each. The last script unpacks that of the page. Engine and scripts are built by
//! `cargo xtask playground`.

use crate::error::ViewError;
use crate::text;
use flate2::{Compression, GzBuilder};
use serde_json::json;
use std::io::{self, Write};

const VIEWER_STYLE: &str = include_str!("../viewer/viewer.css");
const STYLE: &str = include_str!("../viewer/play.css");
const ELEMENTS: &str = include_str!("../viewer/play.html");
const PAGE: &str = include_str!("../viewer/dist/play.js");
const WORKER: &str = include_str!("../viewer/dist/worker.js");
const BINDINGS: &str = include_str!("../viewer/dist/engine.js");
const LOADER: &str = include_str!("../viewer/dist/loader.js");
const LICENCES: &str = include_str!("../viewer/dist/LICENSES-ENGINE.txt");
const ENGINE: &[u8] = include_bytes!("../viewer/dist/engine.wasm.lzma");

/// What a playground begins with.
#[derive(Debug, Clone, Default)]
pub struct Given<'a> {
    /// The title of the page.
    pub title: &'a str,
    /// The text of the scene; none where the page begins with what was typed before.
    pub scene: Option<&'a str>,
    /// Files that the scene names, by these names.
    pub files: Vec<(String, Vec<u8>)>,
    /// Further scenes to choose from.
    pub examples: Vec<Example<'a>>,
    /// The hashes of the scene by the program that writes the page.
    pub native: Option<NativeHashes>,
}

/// A scene to choose from.
#[derive(Debug, Clone, Copy)]
pub struct Example<'a> {
    /// Its name.
    pub name: &'a str,
    /// What it is, in a few words.
    pub title: &'a str,
    /// Its text.
    pub text: &'a str,
}

/// The strict hashes of a run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NativeHashes {
    /// After how many steps, and the hash of then, 16 hexadecimal digits.
    pub marks: Vec<(u64, String)>,
    /// That of the whole run, or of what was computed of it.
    pub hash: String,
    /// Whether it has come to its end.
    pub ended: bool,
}

/// Writes the page.
///
/// # Errors
/// Those of writing.
pub fn write<W: Write>(out: &mut W, given: &Given<'_>) -> Result<(), ViewError> {
    let files: serde_json::Map<String, serde_json::Value> =
        given.files.iter().map(|(name, bytes)| (name.clone(), json!(text::base64(bytes)))).collect();
    let examples = given
        .examples
        .iter()
        .map(|example| json!({ "name": example.name, "title": example.title, "text": example.text }))
        .collect::<Vec<_>>();
    let native = given
        .native
        .as_ref()
        .map(|native| json!({ "marks": native.marks, "hash": native.hash, "ended": native.ended }));
    let begins = json!({
        "title": given.title,
        "text": given.scene,
        "files": files,
        "native": native,
    });
    write!(
        out,
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <link rel=\"icon\" href=\"data:,\">\n<title>{}</title>\n\
         <style>\n{VIEWER_STYLE}{STYLE}</style>\n</head>\n<body>\n{ELEMENTS}",
        text::html(given.title)
    )?;
    let begins = text::json_in_html(&begins.to_string());
    writeln!(out, "<script id=\"polhode-play\" type=\"application/json\">{begins}</script>")?;
    packed(out, "engine", ENGINE)?;
    packed(out, "worker", &gzip(&format!("{BINDINGS}\n{WORKER}"))?)?;
    packed(out, "examples", &gzip(&json!(examples).to_string())?)?;
    packed(out, "licences", &gzip(LICENCES)?)?;
    packed(out, "script", &gzip(PAGE)?)?;
    write!(out, "<script>\n{LOADER}</script>\n</body>\n</html>\n")?;
    out.flush()?;
    Ok(())
}

/// An element with packed bytes.
fn packed<W: Write>(out: &mut W, name: &str, bytes: &[u8]) -> io::Result<()> {
    writeln!(out, "<script id=\"polhode-{name}\" type=\"text/plain\">{}</script>", text::seven_bits(bytes))
}

fn gzip(text: &str) -> io::Result<Vec<u8>> {
    let mut packed = GzBuilder::new().write(Vec::new(), Compression::best());
    packed.write_all(text.as_bytes())?;
    packed.finish()
}

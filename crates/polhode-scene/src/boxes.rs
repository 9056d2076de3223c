//! A table of boxes is a scene: a pallet, a wall, a pile, on a floor at z = 0.
//!
//! It is CSV (RFC 4180) with a line of names. A box has `size_x, size_y, size_z` and its centre `x, y, z` in m, and
//! `mass` in kg; if wanted `name`, `friction` (no unit) and `yaw` (degrees about z). Boxes without a friction of their
//! own, and the floor, are of the material `boxes`, which `--set materials.boxes.friction=0.3` changes.

use crate::csv::{Fault, Records};
use crate::error::SceneFileError;
use std::fmt::Write as _;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Columns that every box has.
const NUMBERS: [&str; 7] = ["size_x", "size_y", "size_z", "x", "y", "z", "mass"];

/// Columns that it may have.
const OPTIONAL: [&str; 3] = ["name", "friction", "yaw"];

/// Whether a file is such a table, by its ending and the names of its columns: a trajectory is CSV too.
pub fn is_boxes(path: &Path) -> bool {
    let has_columns = |file: File| {
        let mut fields = Vec::new();
        let is_read = Records::new(BufReader::new(file)).read(&mut fields).unwrap_or(false);
        is_read && fields.iter().any(|name| own_name(name) == NUMBERS[0])
    };
    is_table(path) && File::open(path).is_ok_and(has_columns)
}

/// The keys of the scene of a table, as a scene file has them; `origin` is what errors call the table.
///
/// # Errors
/// When a column is missing or unknown, or a field is none.
pub fn boxes_json(origin: &Path, table: &[u8]) -> Result<serde_json::Value, SceneFileError> {
    let text = scene_of(origin, table)?;
    // What is written here is TOML.
    toml::from_str(&text).map_err(|error| SceneFileError::Boxes {
        path: origin.to_owned(),
        line: 1,
        what: error.message().to_owned(),
        accepted: accepted(),
    })
}

/// The name of a column without what surrounds it.
fn own_name(field: &str) -> &str {
    field.trim_start_matches('\u{feff}').trim()
}

/// Whether a file could be such a table, by its ending.
pub(crate) fn is_table(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"))
}

/// The scene of a table, as text.
///
/// # Errors
/// When a column is missing or unknown, or a field is none.
pub(crate) fn scene_of(path: &Path, table: &[u8]) -> Result<String, SceneFileError> {
    let refused =
        |line: u64, what: String| SceneFileError::Boxes { path: path.to_owned(), line, what, accepted: accepted() };
    let mut records = Records::new(table);
    let mut fields = Vec::new();
    let mut read = |fields: &mut Vec<String>| match records.read(fields) {
        Ok(is_read) => Ok(is_read.then(|| records.line())),
        Err(Fault::Io(source)) => Err(SceneFileError::Read { path: path.to_owned(), source }),
        Err(Fault::Content(what)) => Err(refused(records.line(), what.to_owned())),
    };
    read(&mut fields)?;
    let columns: Vec<String> = fields.iter().map(|name| own_name(name).to_owned()).collect();
    let known = |name: &&String| NUMBERS.contains(&name.as_str()) || OPTIONAL.contains(&name.as_str());
    if let Some(unknown) = columns.iter().find(|name| !known(name)) {
        return Err(refused(1, format!("unknown column `{unknown}`")));
    }
    if let Some(missing) = NUMBERS.iter().find(|name| !columns.iter().any(|own| own == *name)) {
        return Err(refused(1, format!("column `{missing}` is missing")));
    }
    let mut text = String::from(HEAD);
    let mut count = 0_u64;
    while let Some(line) = read(&mut fields)? {
        if fields.iter().all(|field| field.trim().is_empty()) {
            continue;
        }
        if fields.len() != columns.len() {
            return Err(refused(line, format!("{} fields, and {} columns", fields.len(), columns.len())));
        }
        count += 1;
        let row = Row { columns: &columns, fields: &fields, number: count };
        row.write(&mut text).map_err(|what| refused(line, what))?;
    }
    if count == 0 {
        return Err(refused(1, "there is no box".to_owned()));
    }
    Ok(text)
}

/// What is accepted, for messages.
fn accepted() -> String {
    format!("{} (m, kg), and {}", NUMBERS.join(", "), OPTIONAL.join(", "))
}

/// The scene without boxes.
const HEAD: &str = "format = 1\n\n[materials.boxes]\nfriction = 0.5\n\n[[bodies]]\nname = \"floor\"\nfixed = true\n\
     shape.half_space.normal = [0, 0, 1]\nmaterial = \"boxes\"\n";

/// A line of the table.
struct Row<'a> {
    columns: &'a [String],
    fields: &'a [String],
    /// From 1.
    number: u64,
}

impl Row<'_> {
    fn field(&self, column: &str) -> Option<&str> {
        let place = self.columns.iter().position(|own| own == column)?;
        Some(self.fields[place].trim()).filter(|field| !field.is_empty())
    }

    /// The number in a column; none in an empty field.
    fn number(&self, column: &str) -> Result<Option<f64>, String> {
        let Some(field) = self.field(column) else { return Ok(None) };
        let number = field.parse().ok().filter(|number: &f64| number.is_finite());
        number.map(Some).ok_or_else(|| format!("`{column}` is `{field}`, which is no finite number"))
    }

    fn needed<const N: usize>(&self, columns: [&str; N]) -> Result<[f64; N], String> {
        let mut numbers = [0.0; N];
        for (number, column) in numbers.iter_mut().zip(columns) {
            *number = self.number(column)?.ok_or_else(|| format!("`{column}` is empty"))?;
        }
        Ok(numbers)
    }

    /// Writes the body of the box.
    fn write(&self, text: &mut String) -> Result<(), String> {
        let [size, at] = [self.needed(["size_x", "size_y", "size_z"])?, self.needed(["x", "y", "z"])?];
        let [mass] = self.needed(["mass"])?;
        let name = self.field("name").map_or_else(|| format!("box {}", self.number), str::to_owned);
        let name = name.replace('\\', "\\\\").replace('"', "\\\"");
        let mut material = "boxes".to_owned();
        if let Some(friction) = self.number("friction")? {
            material = format!("box {}", self.number);
            let _ = write!(text, "\n[materials.\"{material}\"]\nfriction = {friction:?}\n");
        }
        let _ = write!(
            text,
            "\n[[bodies]]\nname = \"{name}\"\nshape.box.size = {size:?}\nposition = {at:?}\nmass = {mass:?}\n\
             material = \"{material}\"\n"
        );
        if let Some(yaw) = self.number("yaw")?.filter(|yaw| *yaw != 0.0) {
            let _ = writeln!(text, "rotation_vector = [0, 0, {:?}]", yaw.to_radians());
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    //! A table is the scene that its lines say, and mistakes are told with their line.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;

    const COLUMNS: &str = "size_x,size_y,size_z,x,y,z,mass,name,yaw,friction\n";

    fn scene(lines: &str) -> Result<polhode::Scene, String> {
        let text =
            scene_of(Path::new("t.csv"), format!("{COLUMNS}{lines}").as_bytes()).map_err(|own| own.to_string())?;
        crate::load_text("t", &text, &[]).map(|loaded| loaded.scene).map_err(|own| own.to_string())
    }

    #[test]
    fn boxes_are_bodies() {
        let scene = scene("1,2,3,0.1,0.2,1.5,5,\"a \"\"b\"\"\",90,\n\n1,1,1,5,5,0.5,2,,,0.7\n").unwrap();
        let names: Vec<&str> = scene.bodies().iter().map(polhode::Body::name).collect();
        assert_eq!(names, ["floor", "a \"b\"", "box 2"]);
        let id = |name: &str| scene.body_id(name).unwrap();
        assert_eq!(scene.material_between(id("floor"), id("a \"b\"")).unwrap().friction(), 0.5);
    }

    #[test]
    fn mistakes_are_told_with_their_line() {
        for (lines, told) in [
            ("1,2,3,0,0,1.5,5,a,0\n", "t.csv:2: 9 fields, and 10 columns"),
            ("1,2,3,0,0,1.5,5,a,0,\n1,x,3,0,0,1.5,5,a,0,\n", "t.csv:3: `size_y` is `x`"),
            ("1,2,3,0,0,,5,a,0,\n", "t.csv:2: `z` is empty"),
            ("1,2,3,0,0,1.5,nan,a,0,\n", "t.csv:2: `mass` is `nan`"),
            ("", "there is no box"),
            ("1,2,-3,0,0,1.5,5,a,0,\n", "size"),
        ] {
            let error = scene(lines).unwrap_err();
            assert!(error.contains(told), "{lines}: {error}");
        }
        let other = scene_of(Path::new("t.csv"), b"size_x,colour\n1,red\n").unwrap_err().to_string();
        assert!(other.contains("unknown column `colour`") && other.contains("size_z"), "{other}");
    }
}

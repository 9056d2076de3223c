//! `polhode view` on bad input: an error says which file, where, what is wrong and what to do; nothing is lost: a page
//! that stood there stays, no half of one appears, and no input is replaced.

use crate::view::DROP;
use crate::{FLIGHT, Place};

/// What stands where the page is to go.
const BEFORE: &str = "what stood here";

/// The scene, a whole trajectory of it of each kind, and a page from before.
fn place() -> Place {
    let place = Place::with_scene(DROP);
    place.expect(0, &["run", "scene.toml", "-o", "a.csv", "-o", "a.json", "-o", "a.npy"]);
    place.write("page.html", BEFORE);
    place
}

/// Shows a trajectory of this content, which is refused with these words.
#[track_caller]
fn refused(place: &Place, name: &str, content: &[u8], words: &[&str]) {
    std::fs::write(place.path(name), content).unwrap();
    let run = place.expect(2, &["view", "scene.toml", name, "-o", "page.html"]);
    for word in words {
        assert!(run.stderr.contains(word), "{word}: {}", run.stderr);
    }
    assert_eq!(run.stdout, "");
    assert_eq!(place.read("page.html"), BEFORE);
    assert_eq!(std::fs::read(place.path(name)).unwrap(), content);
    let mut expected = vec!["a.csv", "a.json", "a.npy", "page.html", "scene.toml", name];
    expected.sort_unstable();
    assert_eq!(place.list(), expected);
    std::fs::remove_file(place.path(name)).unwrap();
}

/// Shows a trajectory of this content, which is cut off: its whole samples are shown, and these words say where it
/// ends.
#[track_caller]
fn shown(place: &Place, name: &str, content: &[u8], words: &[&str]) {
    std::fs::write(place.path(name), content).unwrap();
    let run = place.expect(0, &["view", "scene.toml", name, "-o", "cut.html"]);
    for word in words.iter().chain(&["what stands before is shown"]) {
        assert!(run.stderr.contains(word), "{word}: {}", run.stderr);
    }
    std::fs::remove_file(place.path(name)).unwrap();
    std::fs::remove_file(place.path("cut.html")).unwrap();
}

/// A file of a program that was killed ends anywhere.
#[test]
fn csv_that_is_cut_off() {
    let place = place();
    let text = place.read("a.csv");
    let lines: Vec<&str> = text.lines().collect();
    let without_last = lines[..lines.len() - 1].join("\n") + "\n";
    let words = ["bad.csv:102:", "cut off", "t = 0.5 s has 1 of 2 bodies; `ball` is missing"];
    shown(&place, "bad.csv", without_last.as_bytes(), &words);
    let words = ["bad.csv:103:", "columns, 17 are needed", "the file is cut off"];
    shown(&place, "bad.csv", &text.as_bytes()[..text.len() - 40], &words);
    // Within the digits of the last number.
    let digits = text.trim_end().len() - 1;
    shown(&place, "bad.csv", &text.as_bytes()[..digits], &["bad.csv:103:", "may lack digits", "write it again"]);
    // Anywhere, also under the name of the temporary file of a killed program.
    for length in (lines[0].len() + 300..text.len()).step_by(997) {
        shown(&place, ".bad.csv.x1Y2z3.tmp", &text.as_bytes()[..length], &["cut off"]);
    }
    refused(&place, "bad.csv", lines[0].as_bytes(), &["bad.csv:1:", "it has no samples, only a first line"]);
    refused(&place, "bad.csv", (lines[0].to_owned() + "\n").as_bytes(), &["it has no samples"]);
    refused(&place, "bad.csv", b"", &["bad.csv:1:", "the file is empty", "the first line must be t,body,px"]);
}

#[test]
fn csv_of_something_else() {
    let place = place();
    let text = place.read("a.csv");
    let lines: Vec<&str> = text.lines().collect();
    for (content, words) in [
        (text.replace(",ball,", ",bell,"), &["bad.csv:3:", "has no body `bell`; its bodies are `floor`, `ball`"][..]),
        (text.replacen("ball,0.0,0.0,0.5", "ball,0.0,0.0,NaN", 1), &["bad.csv:3:", "column pz of body `ball` is NaN"]),
        (text.replacen("ball,0.0,0.0,0.5", "ball,inf,0.0,0.5", 1), &["column px of body `ball` is inf"]),
        (text.replacen("ball,0.0,0.0,0.5", "ball,0.0,O,0.5", 1), &["bad.csv:3:", "`O` in column py is not a number"]),
        (text.replacen("0.5,1.0,0.0,0.0,0.0", "0.5,0.0,0.0,0.0,0.0", 1), &["bad.csv:3:", "body `ball`", "quaternion"]),
        (text.replacen("0.0,ball", "soon,ball", 1).replacen("0.0,floor", "soon,floor", 1), &["`soon` in column t"]),
        (
            format!("{text}{}\n", lines[1..].join("\n")),
            &["bad.csv:104:", "does not follow the time before it, t = 0.5 s"],
        ),
        (text.replacen("0.0,ball", "0.0,floor", 1), &["bad.csv:3:", "`floor` stands twice"]),
        ("x\n".to_owned(), &["bad.csv:1:", "the first line must be"]),
        (text.replacen("\n0.0,floor", ",more\n0.0,floor", 1), &["bad.csv:1:", "or that and ,error_m,error_rad"]),
    ] {
        refused(&place, "bad.csv", content.as_bytes(), words);
    }
}

#[test]
fn trajectories_of_another_scene() {
    let place = place();
    place.write("flight.toml", FLIGHT);
    place.expect(0, &["run", "flight.toml", "-o", "b.csv", "-o", "b.json", "-o", "b.npy"]);
    let take = |name: &str| {
        let content = std::fs::read(place.path(name)).unwrap();
        std::fs::remove_file(place.path(name)).unwrap();
        content
    };
    let (csv, json, npy) = (take("b.csv"), take("b.json"), take("b.npy"));
    take("flight.toml");
    let no_body = ["scene `drop` has no body `stone, \"flat\"`; its bodies are", "is it another scene's?"];
    refused(&place, "b.csv", &csv, &no_body);
    refused(&place, "b.json", &json, &no_body);
    let shape = "its shape is (5, 1, 16), and the scene's is (samples, 2, 14 or 16): is it another scene's?";
    refused(&place, "b.npy", &npy, &[shape]);
}

#[test]
fn json_that_is_bad() {
    let place = place();
    let text = place.read("a.json");
    shown(&place, "bad.json", &text.as_bytes()[..text.len() / 2], &["bad.json:", "the file is cut off"]);
    shown(&place, "bad.json", text.trim_end().trim_end_matches('}').as_bytes(), &["the file is cut off"]);
    let cases: [(String, &[&str]); 8] = [
        (String::new(), &["bad.json:1:1:", "cut off"]),
        ("[]".to_owned(), &["bad.json:1:1:", "`[` where `{` must stand"]),
        (text[..text.find("\n{").unwrap()].to_owned() + "]}", &["it has no samples"]),
        (text.replace("\"ball\"", "\"bell\""), &["bad.json:4:", "has no body `bell`"]),
        (text.replace(",\"ball\"", ""), &["body `ball` of the scene is missing in `bodies`"]),
        (text.replacen("0.5,1.0", "null,1.0", 1), &["bad.json:5:", "column pz of body `ball` is NaN"]),
        (text.replacen("0.5,1.0", "1.0", 1), &["bad.json:5:", "body `ball` has 14 of 15 numbers"]),
        (text.replace("\"px\"", "\"x\""), &["`columns` must stand before `samples` and be px, py"]),
    ];
    for (content, words) in cases {
        refused(&place, "bad.json", content.as_bytes(), words);
    }
}

#[test]
fn npy_that_is_bad() {
    let place = place();
    let bytes = std::fs::read(place.path("a.npy")).unwrap();
    let changed = |from: &[u8], to: &[u8]| {
        let at = bytes.windows(from.len()).position(|window| window == from).unwrap();
        [&bytes[..at], to, &bytes[at + from.len()..]].concat()
    };
    let data = bytes.len() - 51 * 2 * 16 * 8;
    let mut nan = bytes.clone();
    nan[data + 8..data + 16].copy_from_slice(&f64::NAN.to_le_bytes());
    let mut time = bytes.clone();
    time[data..data + 8].copy_from_slice(&9.0_f64.to_le_bytes());
    let words = ["51 samples of 2 bodies take 13056 bytes, and 13055 follow", "cut off"];
    shown(&place, "bad.npy", &bytes[..bytes.len() - 1], &words);
    // The header of a killed program does not count the samples yet.
    let never_ended = changed(b"(51, 2, 16)", b"(0, 2, 16) ");
    shown(
        &place,
        ".bad.npy.x1Y2z3.tmp",
        &never_ended[..never_ended.len() - 100],
        &["how many samples follow", "cut off"],
    );
    let cases: [(Vec<u8>, &[&str]); 8] = [
        (Vec::new(), &["bad.npy, byte 0", "cut off"]),
        (bytes[..100].to_vec(), &["bad.npy, byte", "cut off"]),
        ([&bytes[..], b"x"].concat(), &["13057 follow the header"]),
        (b"not numpy at all".to_vec(), &["an NPY file begins with"]),
        (changed(b"<f8", b"<f4"), &["doubles, little-endian"]),
        (changed(b"(51, 2, 16)", b"(99999999999999999999, 2, 14)"), &["three lengths"]),
        (nan, &["bad.npy, byte 304", "column px of body `floor` is NaN"]),
        (time, &["body `ball` has t = 0.0 s in the sample of t = 9.0 s"]),
    ];
    for (content, words) in cases {
        refused(&place, "bad.npy", &content, words);
    }
}

/// Scenes without bodies, and times outside of the motion.
#[test]
fn nothing_to_show() {
    let place = place();
    place.write("empty.toml", "format = 1\n");
    place.write("nothing.toml", "");
    for (code, arguments, words) in [
        (2, &["empty.toml", "-o", "page.html"][..], "no bodies"),
        (2, &["empty.toml", "--still", "t=0", "-o", "page.png"], "no bodies"),
        (2, &["empty.toml", "a.csv", "-o", "page.html"], "no bod"),
        (2, &["nothing.toml", "-o", "page.html"], "nothing.toml:1"),
        (3, &["missing.toml", "-o", "page.html"], "cannot read missing.toml"),
        (3, &["scene.toml", "missing.csv", "-o", "page.html"], "cannot read missing.csv"),
        (2, &["a.csv", "-o", "page.html"], "name its scene too"),
        (
            2,
            &["scene.toml", "--still", "t=0.6", "-o", "page.png"],
            "--still t=0.6: the motion is from t = 0 s to 0.5 s",
        ),
        (2, &["scene.toml", "a.csv", "--still", "t=0.6", "-o", "page.png"], "the motion is from t = 0 s to 0.5 s"),
        (2, &["scene.toml", "a.npy", "--still", "t=-0.1", "-o", "page.png"], "the motion is from t = 0 s to"),
        (2, &["scene.toml", "a.json", "--still", "t=NaN", "-o", "page.png"], "the motion is from t = 0 s to 0.5 s"),
    ] {
        let run = place.expect(code, &[&["view"], arguments].concat());
        assert!(run.stderr.contains(words), "{words}: {}", run.stderr);
    }
    assert_eq!(place.read("page.html"), BEFORE);
    assert_eq!(place.list(), ["a.csv", "a.json", "a.npy", "empty.toml", "nothing.toml", "page.html", "scene.toml"]);
}

/// Places where no page can stand.
#[test]
fn pages_that_cannot_be_written() {
    let place = place();
    std::fs::create_dir(place.path("folder.html")).unwrap();
    for path in ["missing/page.html", "folder.html", "a.csv/page.html"] {
        let run = place.expect(3, &["view", "scene.toml", "-o", path]);
        assert!(run.stderr.contains(&format!("cannot write {path}")), "{}", run.stderr);
    }
    // One of two cannot be written: neither appears.
    place.expect(3, &["view", "scene.toml", "-o", "page.html", "-o", "missing/page.png"]);
    assert_eq!(place.read("page.html"), BEFORE);
    assert_eq!(place.list(), ["a.csv", "a.json", "a.npy", "folder.html", "page.html", "scene.toml"]);
}

/// An output never replaces what is read, by whatever name.
#[test]
fn outputs_that_are_inputs() {
    let place = place();
    place.write("scene.html", DROP);
    let own = place.path("scene.html");
    for arguments in
        [&["scene.html"][..], &["scene.html", "-o", "./scene.html"], &["scene.html", "-o", own.to_str().unwrap()]]
    {
        let run = place.expect(2, &[&["view"], arguments].concat());
        assert!(run.stderr.contains("an output never replaces it"), "{}", run.stderr);
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(place.path("scene.toml"), place.path("link.html")).unwrap();
        let run = place.expect(2, &["view", "scene.toml", "-o", "link.html"]);
        assert!(run.stderr.contains("an output never replaces it"), "{}", run.stderr);
    }
    assert_eq!(place.read("scene.html"), DROP);
    assert_eq!(place.read("scene.toml"), DROP);
}

//! The page of the gallery: for each scene a still, what it shows, its figures and a link to its viewer.
//!
//! One file of HTML with its style inside; stills and viewers stand beside it. It needs no network and no script.

use super::figures::figures;
use super::selection::Still;
use super::shown::ShownScenes;
use std::fmt::Write as _;

/// The style: pairs of light and dark, one column on a phone.
const STYLE: &str = include_str!("page.css");

/// What stands before the scenes.
const INTRODUCTION: &str = "<h1>Polhode: gallery of shipped scenes</h1>\n\
    <p>Every picture opens a page that plays its scene, without network. Scenes are in <code>fixtures/scenes</code>; \
    <code>polhode view SCENE</code> makes such a page of any. Energies are fractions of the largest of the \
    run; what a method gains is negative. Run times are those of the machine that built this page.</p>\n";

/// The page.
pub(super) fn text(shown: &ShownScenes) -> String {
    let mut text = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Polhode: gallery</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<header>\n{INTRODUCTION}</header>\n<main>\n\
         <h2>The videos of the thesis</h2>\n\
         <p>Where a video shows a fault, the scene that has it stands first and the scene without it second. The text \
         of the thesis names the fault of each, and bodies and numbers of some only: where it is silent the scenes \
         have their own.</p>\n"
    );
    for video in &shown.selection.videos {
        let _ = write!(text, "<section>\n<h3>Video {}: {}</h3>\n", video.number, html(&video.subject));
        if video.wrong.is_some() {
            let _ = writeln!(text, "<p><a href=\"{}.html\">Both beside each other</a></p>", video.page());
        }
        text.push_str("<div class=\"cards\">\n");
        let kinds = if video.wrong.is_some() { &["wrong", "right"][..] } else { &[""] };
        for (still, kind) in shown.selection.of_video(video).into_iter().zip(kinds) {
            text.push_str(&card(still, kind, shown));
        }
        text.push_str("</div>\n</section>\n");
    }
    for group in &shown.groups.groups {
        let _ = write!(
            text,
            "<h2>{}</h2>\n<p>{}</p>\n<p><img src=\"stills/{}\" width=\"320\" height=\"200\" loading=\"lazy\" \
             alt=\"{}\"></p>\n",
            html(&group.title),
            html(&group.about),
            group.file(),
            html(&group.moving)
        );
        for row in shown.groups.rows(group, &shown.selection, usize::MAX) {
            text.push_str("<div class=\"cards\">\n");
            for still in &row {
                text.push_str(&card(still, "", shown));
            }
            text.push_str("</div>\n");
        }
    }
    text.push_str("</main>\n</body>\n</html>\n");
    text
}

/// One scene; `kind` is wrong, right or empty.
fn card(still: &Still, kind: &str, shown: &ShownScenes) -> String {
    let Some(scene) = shown.of_still(still) else { return String::new() };
    let (name, title) = (still.scene(), html(&scene.loaded.title()));
    let mut text = format!(
        "<article class=\"{kind}\">\n<a href=\"{name}.html\"><img src=\"stills/{}\" width=\"320\" height=\"200\" \
         loading=\"lazy\" alt=\"{title} at t = {} s\"></a>\n<h4><a href=\"{name}.html\">{title}</a></h4>\n<p>{}</p>\n\
         <dl>\n",
        still.file(),
        still.time_s,
        html(&scene.loaded.description().unwrap_or_default())
    );
    let source = ("Scene", format!("{name}, at {} s", still.time_s));
    for (what, value) in std::iter::once(source).chain(figures(scene)) {
        let _ = writeln!(text, "<dt>{what}</dt><dd>{}</dd>", html(&value));
    }
    text.push_str("</dl>\n</article>\n");
    text
}

/// Text that stands for itself in HTML; words between backticks are code.
fn html(text: &str) -> String {
    let escaped = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;");
    let parts = escaped.split('`').enumerate();
    parts.map(|(number, part)| if number % 2 == 1 { format!("<code>{part}</code>") } else { part.to_owned() }).collect()
}

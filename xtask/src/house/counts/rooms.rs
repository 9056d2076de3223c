//! Loose files of the facade, and arrows between its rooms that run back up.
//!
//! A room is an entry of `crates/polhode/src`: a folder with all below it, or a loose file (`tier.rs` belongs to
//! `tier/`; the root, which says what there is, is none). There is an arrow from a file to each file of another room
//! that it imports, tests apart; a re-export is followed to the file that holds the name. The rooms are put in the
//! order that has the fewest arrows from a lower to a higher one, as far as this is found: after Eades, Lin and Smyth
//! 1993 (rooms that import nothing go to the bottom, rooms that nobody imports to the top, else the one that imports
//! most for what it is imported), then by moving one room at a time as long as fewer arrows run back up. Equal choices
//! go to the first name, so that the count is the same everywhere. At commit ae0e5111 these are 61, where the review's
//! drawing had 62.

use crate::house::count::{Count, FACADE, is_in};
use crate::house::imports::Imports;
use crate::house::rust_source::RustSource;
use std::collections::{BTreeMap, BTreeSet};

/// For every room those that it imports, each with the number of arrows between their files.
type Arrows<'a> = BTreeMap<&'a str, BTreeMap<&'a str, usize>>;

pub(super) fn counts(sources: &[RustSource]) -> Vec<Count> {
    let loose = sources.iter().filter(|source| is_in(source, FACADE) && !inner(source.path()).contains('/'));
    let imports = Imports::of(sources, FACADE);
    let arrows = between_rooms(&imports.arrows());
    vec![
        Count {
            key: "loose_files",
            check: "loose files of polhode/src",
            review: Some(48),
            now: loose.count() as u64,
            goal: Some(5),
        },
        Count {
            key: "arrows_back_up",
            check: "arrows between files of polhode/src that run back up, by rooms",
            review: Some(62),
            now: back_up(&arrows, &ordered(&arrows)) as u64,
            goal: Some(19),
        },
    ]
}

/// The path of a file of the facade inside its sources.
fn inner(path: &str) -> &str {
    path.strip_prefix(FACADE).unwrap_or(path).trim_start_matches('/')
}

/// The room of a file; none for the root.
fn room(path: &str) -> Option<&str> {
    let name = inner(path).split('/').next()?.trim_end_matches(".rs");
    (name != "lib").then_some(name)
}

fn between_rooms<'a>(files: &BTreeMap<&'a str, BTreeSet<&'a str>>) -> Arrows<'a> {
    let mut arrows = Arrows::new();
    for (from, to) in files {
        let Some(from) = room(from) else { continue };
        let from_here = arrows.entry(from).or_default();
        for to in to.iter().filter_map(|file| room(file)).filter(|to| *to != from) {
            *from_here.entry(to).or_default() += 1;
        }
    }
    arrows
}

/// The rooms from the top to the bottom.
fn ordered<'a>(arrows: &Arrows<'a>) -> Vec<&'a str> {
    let mut left: BTreeSet<&str> = arrows.keys().copied().collect();
    let (mut top, mut bottom) = (Vec::new(), Vec::new());
    while let Some(first) = left.first().copied() {
        let imports =
            |room: &str| arrows[room].iter().filter(|(to, _)| left.contains(*to)).map(|(_, n)| n).sum::<usize>();
        let users = |room: &str| left.iter().filter_map(|from| arrows[*from].get(room)).sum::<usize>();
        if let Some(&room) = left.iter().find(|room| imports(room) == 0) {
            bottom.push(room);
            left.remove(room);
        } else if let Some(&room) = left.iter().find(|room| users(room) == 0) {
            top.push(room);
            left.remove(room);
        } else {
            let surplus = |room: &str| imports(room) as i64 - users(room) as i64;
            let room =
                left.iter().copied().fold(first, |best, room| if surplus(room) > surplus(best) { room } else { best });
            top.push(room);
            left.remove(room);
        }
    }
    top.extend(bottom.into_iter().rev());
    improved(arrows, top)
}

/// The order after all moves of one room that lessen what runs back up.
fn improved<'a>(arrows: &Arrows<'_>, mut order: Vec<&'a str>) -> Vec<&'a str> {
    let rooms: BTreeSet<&str> = order.iter().copied().collect();
    let mut fewest = back_up(arrows, &order);
    loop {
        let before = fewest;
        for &room in &rooms {
            let others: Vec<&str> = order.iter().copied().filter(|other| *other != room).collect();
            for at in 0..=others.len() {
                let mut moved = others.clone();
                moved.insert(at, room);
                let count = back_up(arrows, &moved);
                if count < fewest {
                    (fewest, order) = (count, moved);
                }
            }
        }
        if fewest == before {
            return order;
        }
    }
}

/// Arrows from a room to one that stands above it.
fn back_up(arrows: &Arrows<'_>, order: &[&str]) -> usize {
    let place: BTreeMap<&str, usize> = order.iter().enumerate().map(|(place, room)| (*room, place)).collect();
    let above = |from: &str, to: &str| place.get(to).is_some_and(|to| *to < place[from]);
    let up = |from: &str, to: &BTreeMap<&str, usize>| {
        to.iter().filter(|(to, _)| above(from, to)).map(|(_, n)| n).sum::<usize>()
    };
    arrows.iter().map(|(from, to)| up(from, to)).sum()
}

#[cfg(test)]
mod tests {
    //! Rooms without circles have an order without arrows back up; a circle costs its lightest arrow.
    use super::*;

    fn fewest(arrows: &[(&'static str, &[&'static str])]) -> usize {
        let arrows: Arrows<'_> =
            arrows.iter().map(|(from, to)| (*from, to.iter().map(|to| (*to, 1)).collect())).collect();
        back_up(&arrows, &ordered(&arrows))
    }

    #[test]
    fn only_circles_run_back_up() {
        assert_eq!(fewest(&[("a", &["b", "c"]), ("b", &["c"]), ("c", &[])]), 0);
        assert_eq!(fewest(&[("a", &["b"]), ("b", &["c"]), ("c", &["a"])]), 1);
        assert_eq!(fewest(&[("a", &["b", "c"]), ("b", &["a"]), ("c", &["a"])]), 2);
    }

    #[test]
    fn rooms_are_folders_and_loose_files() {
        let rooms =
            ["lib.rs", "plan.rs", "tier.rs", "tier/list.rs", "solve/a/b.rs"].map(|file| format!("{FACADE}/{file}"));
        let found: Vec<Option<&str>> = rooms.iter().map(|path| room(path)).collect();
        assert_eq!(found, [None, Some("plan"), Some("tier"), Some("tier"), Some("solve")]);
    }
}

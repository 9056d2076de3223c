//! The arrays of a scene with another number of bodies: how cost grows with it is measured by the same scene in other
//! sizes.
//!
//! All arrays of bodies that move are scaled by one factor, each in its own way, so that what the scene is stays what
//! it is:
//!
//! | layout | what changes |
//! |---|---|
//! | `grid` | the count along its longest row |
//! | `pyramid` | its base |
//! | `wall` | length and height by the same factor |
//! | `ring` | the count, and the radius with it |
//! | `arch` | the count |
//! | `drop` | the count, and the height of the region with it |
//!
//! Numbers of bodies are whole, so that the scene has nearly as many as are asked for; how many is read from the scene
//! that comes of it.

use crate::document::Override;
use crate::format::{ArrayEntry, LayoutEntry};
use crate::load::LoadedScene;

/// Bricks in a course of a wall, and bodies in a row, at the least.
const FEWEST_IN_COURSE: f64 = 2.0;

impl LoadedScene {
    /// The changes that give the arrays of moving bodies about so many bodies together; none where the scene has no
    /// such array. `origin` is what errors name as their place.
    pub fn scaled_to(&self, bodies: u32, origin: &str) -> Option<Vec<Override>> {
        let arrays: Vec<(usize, &ArrayEntry)> =
            self.arrays().iter().enumerate().filter(|(_, array)| !array.fixed).collect();
        let present: f64 = arrays.iter().map(|(_, array)| bodies_of(&array.layout)).sum();
        let factor = f64::from(bodies) / present;
        let of = |(number, array): &(usize, &ArrayEntry)| {
            let key = |key: &str| format!("arrays.{number}.layout.{key}");
            let change = |(name, value): (&str, String)| Override::new(origin, key(name), value);
            scaled(&array.layout, factor).into_iter().map(change).collect::<Vec<_>>()
        };
        (!arrays.is_empty()).then(|| arrays.iter().flat_map(of).collect())
    }
}

fn bodies_of(layout: &LayoutEntry) -> f64 {
    match layout {
        LayoutEntry::Grid(grid) => grid.counts.0.iter().map(|&count| f64::from(count)).product(),
        LayoutEntry::Pyramid(pyramid) => 0.5 * f64::from(pyramid.base) * (f64::from(pyramid.base) + 1.0),
        LayoutEntry::Wall(wall) => f64::from(wall.length) * f64::from(wall.height),
        LayoutEntry::Ring(ring) => f64::from(ring.count),
        LayoutEntry::Arch(arch) => f64::from(arch.count),
        LayoutEntry::Drop(drop) => f64::from(drop.count),
    }
}

/// Keys below the layout with their values.
fn scaled(layout: &LayoutEntry, factor: f64) -> Vec<(&'static str, String)> {
    let whole = |value: f64, least: f64| format!("{:.0}", value.round().max(least));
    match layout {
        LayoutEntry::Grid(grid) => {
            let mut counts = grid.counts.0.map(f64::from);
            let longest = counts.into_iter().fold(0.0, f64::max);
            if let Some(count) = counts.iter_mut().find(|count| **count == longest) {
                *count *= factor;
            }
            let counts = counts.map(|count| whole(count, 1.0)).join(", ");
            vec![("grid.counts", format!("[{counts}]"))]
        }
        LayoutEntry::Pyramid(_) => {
            let bodies = bodies_of(layout) * factor;
            vec![("pyramid.base", whole(0.5 * ((1.0 + 8.0 * bodies).sqrt() - 1.0), 1.0))]
        }
        LayoutEntry::Wall(wall) => vec![
            ("wall.length", whole(f64::from(wall.length) * factor.sqrt(), FEWEST_IN_COURSE)),
            ("wall.height", whole(f64::from(wall.height) * factor.sqrt(), 1.0)),
        ],
        LayoutEntry::Ring(ring) => {
            let count = ("ring.count", whole(f64::from(ring.count) * factor, 1.0));
            let radius = ring.radius.map(|radius| ("ring.radius", format!("{:?}", radius * factor)));
            std::iter::once(count).chain(radius).collect()
        }
        LayoutEntry::Arch(arch) => vec![("arch.count", whole(f64::from(arch.count) * factor, FEWEST_IN_COURSE))],
        LayoutEntry::Drop(drop) => {
            let [x, y, z] = drop.size.0;
            let size = format!("[{x:?}, {y:?}, {:?}]", z * factor.max(1.0));
            vec![("drop.count", whole(f64::from(drop.count) * factor, 1.0)), ("drop.size", size)]
        }
    }
}

#[cfg(test)]
mod tests {
    //! Every layout comes back with about the number of bodies that is asked for, and one without arrays is told.
    #![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use crate::load_text;

    const HEAD: &str = "format = 1\nduration = 1\n";

    fn count(layout: &str, bodies: u32) -> usize {
        let text = format!(
            "{HEAD}[[arrays]]\nname = \"a\"\nmass = 1\nshape.box.size = [0.5, 0.5, 0.5]\nposition = [0, 0, 1]\n\
             layout.{layout}\n"
        );
        let loaded = load_text("a.toml", &text, &[]).unwrap();
        let changes = loaded.scaled_to(bodies, "--scale").unwrap();
        load_text("a.toml", &text, &changes).unwrap().scene.bodies().len()
    }

    #[test]
    fn every_layout_is_scaled() {
        assert_eq!(count("drop = { count = 10, size = [4, 4, 8] }", 80), 80);
        assert_eq!(count("drop = { count = 10, size = [4, 4, 8] }", 3), 3);
        assert_eq!(count("grid = { counts = [2, 3, 5], spacing = [1, 1, 1] }", 60), 60);
        assert_eq!(count("pyramid = { base = 4, spacing = [1, 1] }", 210), 210);
        let wall = count("wall = { length = 6, height = 5, spacing = [0.6, 0.5] }", 270);
        assert!((260..300).contains(&wall), "{wall}");
        let none = load_text("a.toml", HEAD, &[]).unwrap();
        assert!(none.scaled_to(10, "--scale").is_none());
    }
}

//! Where the bodies of an array stand.
//!
//! Grids, pyramids and walls: the first body stands at the position of the array, body (i, j, k) at
//! `(i s_x, j s_y, k s_z)` from it, in courses shifted by half a spacing where the layout says so. Every second course
//! of a wall begins and ends with half a brick, whose outer faces are flush with the ends of the others. A drop divides
//! its region into equal cells, as large as leave room for all bodies, and puts every body into a cell of its own: the
//! ball about its origin that holds it stays inside the cell, so that no two touch. Which cells stay empty, where in
//! its cell a body is and how it is turned are random (uniform; the rotation is a point of the unit sphere in four
//! dimensions), by [`SplitMix64`]: a seed gives the same bits everywhere.
//!
//! Body k of a ring of n is turned by `2 pi k / n` about the vertical, with its place. Stone k of an arch of n over the
//! opening `b` is a wedge of the angle `b / n` whose middle is at `(k + 1/2) b / n - b / 2` from the crown, k from 0.
//!
//! Refused: no body, more than [`MOST_BODIES`], a spacing that puts bodies at one place, a region without room.

use super::fault::{Fault, finite, not_negative, positive, vector};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::{
    ArchEntry, DropEntry, GridEntry, LayoutEntry, PyramidEntry, RingEntry, SpringersName, WallEntry, WedgeEntry,
};
use glam::DVec3;
use polhode::spatial::{Rotation, SplitMix64};
use std::f64::consts::{PI, TAU};

/// Most bodies of a scene with arrays: so many have 2^31 pairs, and a run that met them all would not end.
pub(super) const MOST_BODIES: u64 = 1 << 16;

/// How much wider the cell of a body in a drop is than the ball that holds the body, at least, relative to the ball:
/// bodies start apart by more than rounding.
const APART_RELATIVE: f64 = 1e-2;

/// Halvings of the interval in which the edge of the cells of a drop is searched for: all bits of a number.
const HALVINGS: usize = 64;

/// Lengths of the vectors of which directions are made: shorter ones have too few digits, longer ones would not be
/// uniform.
const DIRECTION_LENGTHS: std::ops::RangeInclusive<f64> = 0.1..=1.0;

/// What stands there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Piece {
    Whole,
    /// Half a brick: its length along x is half of the others'.
    Half,
    /// An end of an arch that is fixed.
    Springer,
}

/// The body of which all are copies, as far as a layout depends on it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Model {
    /// Of the ball about its origin that holds it, m; none without a shape.
    pub(super) radius: Option<f64>,
    /// The length of a box along x, m; none of another shape.
    pub(super) length: Option<f64>,
}

/// Where one body stands.
pub(super) struct Stand {
    pub(super) piece: Piece,
    /// What follows the name of the array.
    pub(super) suffix: String,
    /// From the position of the array, world, m.
    pub(super) offset: DVec3,
    /// What turns it beside its own orientation.
    pub(super) rotation: Rotation,
}

/// How many bodies a layout has.
pub(super) fn count(layout: &LayoutEntry) -> u64 {
    match layout {
        LayoutEntry::Grid(grid) => grid.counts.0.iter().fold(1, |all: u64, &count| all.saturating_mul(count.into())),
        LayoutEntry::Pyramid(pyramid) => {
            let base = u64::from(pyramid.base);
            base * (base + 1) / 2
        }
        LayoutEntry::Wall(wall) => {
            let (length, height) = (u64::from(wall.length), u64::from(wall.height));
            length * height + height / 2
        }
        LayoutEntry::Ring(ring) => ring.count.into(),
        LayoutEntry::Arch(arch) => arch.count.into(),
        LayoutEntry::Drop(drop) => drop.count.into(),
    }
}

/// The bodies of the layout at `path`.
///
/// # Errors
/// As the head of this file.
pub(super) fn stands(layout: &LayoutEntry, model: Model, path: &KeyPath) -> Result<Vec<Stand>, Fault> {
    match layout {
        LayoutEntry::Grid(grid) => self::grid(grid, &path.key("grid")),
        LayoutEntry::Pyramid(pyramid) => self::pyramid(pyramid, &path.key("pyramid")),
        LayoutEntry::Wall(wall) => self::wall(wall, model.length, &path.key("wall")),
        LayoutEntry::Ring(ring) => self::ring(ring, &path.key("ring")),
        LayoutEntry::Arch(arch) => self::arch(arch, &path.key("arch")),
        LayoutEntry::Drop(drop) => self::drop(drop, model.radius, &path.key("drop")),
    }
}

fn grid(entry: &GridEntry, path: &KeyPath) -> Result<Vec<Stand>, Fault> {
    for (axis, &count) in entry.counts.0.iter().enumerate() {
        at_least(count, 1, &path.key("counts").index(axis))?;
    }
    let spacing = vector(&entry.spacing, &path.key("spacing"))?;
    let turn = turn(entry.turn, path)?;
    for (axis, (&count, step)) in entry.counts.0.iter().zip(entry.spacing.0).enumerate() {
        if count > 1 && step == 0.0 {
            let accepted = "a spacing that is not zero where there is more than one body";
            return Err((path.key("spacing").index(axis), Refusal::Number { value: step, accepted }));
        }
    }
    let [x, y, z] = entry.counts.0;
    let mut stands = Vec::new();
    for (k, j, i) in (0..z).flat_map(|k| (0..y).flat_map(move |j| (0..x).map(move |i| (k, j, i)))) {
        let offset = DVec3::new(f64::from(i), f64::from(j), f64::from(k)) * spacing;
        stands.push(turned(format!("{}-{}-{}", i + 1, j + 1, k + 1), offset, turn));
    }
    Ok(stands)
}

fn pyramid(entry: &PyramidEntry, path: &KeyPath) -> Result<Vec<Stand>, Fault> {
    at_least(entry.base, 1, &path.key("base"))?;
    let spacing = spacing_of_courses(entry.spacing.0, path)?;
    let turn = turn(entry.turn, path)?;
    let courses = (0..entry.base).map(|course| Course {
        number: course,
        length: entry.base - course,
        shift: 0.5 * f64::from(course),
    });
    Ok(courses.flat_map(|course| course.stands(spacing, turn)).collect())
}

fn wall(entry: &WallEntry, length: Option<f64>, path: &KeyPath) -> Result<Vec<Stand>, Fault> {
    at_least(entry.length, 2, &path.key("length"))?;
    at_least(entry.height, 1, &path.key("height"))?;
    let spacing = spacing_of_courses(entry.spacing.0, path)?;
    let turn = turn(entry.turn, path)?;
    let Some(brick) = length else {
        return Err((path.clone(), Refusal::Needs { what: "a wall, which has half bricks,", needed: "`shape.box`" }));
    };
    let mut stands = Vec::new();
    for number in 0..entry.height {
        if number % 2 == 0 {
            stands.extend(Course { number, length: entry.length, shift: 0.0 }.stands(spacing, turn));
            continue;
        }
        let half = |place: u32, x: f64| {
            let offset = DVec3::new(x, 0.0, f64::from(number) * spacing[1]);
            Stand { piece: Piece::Half, ..turned(format!("{}-{place}", number + 1), offset, turn) }
        };
        // Between the two halves; their names begin with the second.
        let whole = Course { number, length: entry.length - 1, shift: 0.5 };
        stands.push(half(1, -0.25 * brick));
        stands.extend(whole.stands(spacing, turn).enumerate().map(|(place, stand)| {
            let suffix = format!("{}-{}", number + 1, place + 2);
            Stand { suffix, ..stand }
        }));
        stands.push(half(entry.length + 1, f64::from(entry.length - 1) * spacing[0] + 0.25 * brick));
    }
    Ok(stands)
}

/// Bodies side by side.
struct Course {
    /// From 0, upwards.
    number: u32,
    /// How many bodies.
    length: u32,
    /// Where the first one stands, in spacings.
    shift: f64,
}

impl Course {
    fn stands(self, [along, up]: [f64; 2], turn: Rotation) -> impl Iterator<Item = Stand> {
        let height = f64::from(self.number) * up;
        (0..self.length).map(move |i| {
            let offset = DVec3::new((self.shift + f64::from(i)) * along, 0.0, height);
            turned(format!("{}-{}", self.number + 1, i + 1), offset, turn)
        })
    }
}

fn ring(entry: &RingEntry, path: &KeyPath) -> Result<Vec<Stand>, Fault> {
    at_least(entry.count, 1, &path.key("count"))?;
    let outwards = DVec3::X * not_negative(entry.radius.unwrap_or(0.0), &path.key("radius"))?;
    let start = turn(entry.turn, path)?;
    let place = |k: u32| {
        let angle = TAU * f64::from(k) / f64::from(entry.count);
        turned((k + 1).to_string(), outwards, start * Rotation::from_rotation_vector(angle * DVec3::Z))
    };
    Ok((0..entry.count).map(place).collect())
}

fn arch(entry: &ArchEntry, path: &KeyPath) -> Result<Vec<Stand>, Fault> {
    let angle = stone_of(entry, path)?.angle;
    let turn = turn(entry.turn, path)?;
    let is_fixed = entry.springers == Some(SpringersName::Fixed);
    let last = entry.count - 1;
    let place = |k: u32| {
        let from_crown = (f64::from(k) - 0.5 * f64::from(last)) * angle;
        let rotation = turn * Rotation::from_rotation_vector(from_crown * DVec3::Y) * upright()?;
        let piece = if is_fixed && (k == 0 || k == last) { Piece::Springer } else { Piece::Whole };
        Some(Stand { piece, suffix: (k + 1).to_string(), offset: DVec3::ZERO, rotation })
    };
    Ok((0..entry.count).filter_map(place).collect())
}

/// What puts a wedge upright, at the crown of an arch: its x axis up, its z axis against y.
fn upright() -> Option<Rotation> {
    Rotation::from_wxyz([0.5, 0.5, -0.5, 0.5]).ok()
}

/// The stone of an arch at `path`.
///
/// # Errors
/// As the head of this file.
pub(super) fn stone_of(entry: &ArchEntry, path: &KeyPath) -> Result<WedgeEntry, Fault> {
    at_least(entry.count, 1, &path.key("count"))?;
    let radius = positive(entry.radius, &path.key("radius"))?;
    let thickness = positive(entry.thickness, &path.key("thickness"))?;
    let width = positive(entry.width, &path.key("width"))?;
    let refused = |key: &'static str, value: f64, accepted: &'static str| {
        Err((path.key(key), Refusal::Number { value, accepted }))
    };
    if thickness >= 2.0 * radius {
        return refused("thickness", thickness, "a thickness below twice the radius");
    }
    let opening = positive(entry.opening.unwrap_or(PI), &path.key("opening"))?;
    if opening > TAU {
        return refused("opening", opening, "an angle of at most a whole turn, 2 pi");
    }
    let angle = opening / f64::from(entry.count);
    if angle >= PI {
        return refused("count", entry.count.into(), "more stones: each takes less than half a turn");
    }
    let [inner_radius, outer_radius] = [radius - 0.5 * thickness, radius + 0.5 * thickness];
    Ok(WedgeEntry { inner_radius, outer_radius, angle, width })
}

fn drop(entry: &DropEntry, radius: Option<f64>, path: &KeyPath) -> Result<Vec<Stand>, Fault> {
    at_least(entry.count, 1, &path.key("count"))?;
    for (axis, &edge) in entry.size.0.iter().enumerate() {
        positive(edge, &path.key("size").index(axis))?;
    }
    let size = entry.size.0;
    let Some(radius) = radius.filter(|radius| radius.is_finite()) else {
        return Err((path.clone(), Refusal::Needs { what: "a drop", needed: "`shape`, of a finite size" }));
    };
    let least = 2.0 * radius * (1.0 + APART_RELATIVE);
    let wanted = f64::from(entry.count);
    let room = cells(size, least).into_iter().product::<f64>();
    if room < wanted {
        let (count, room) = (entry.count, room.max(0.0) as u64);
        return Err((path.key("count"), Refusal::NoRoom { count, room, ball_m: 2.0 * radius }));
    }
    let (mut fits, mut too_wide) = (least, size.into_iter().fold(least, f64::max) * 2.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (fits + too_wide);
        *(if cells(size, middle).into_iter().product::<f64>() >= wanted { &mut fits } else { &mut too_wide }) = middle;
    }
    let counts = cells(size, fits);
    let cell = DVec3::from_array(size) / DVec3::from_array(counts);
    let slack = cell - DVec3::splat(least);
    let mut random = SplitMix64::new(entry.seed.unwrap_or(0));
    let mut stands = Vec::new();
    // As many of the cells as there are bodies, every choice with the same chance (selection sampling).
    let [mut left, mut missing] = [counts.into_iter().product::<f64>(), wanted];
    let [x, y, z] = counts.map(|count| count as u32);
    for (k, j, i) in (0..z).flat_map(|k| (0..y).flat_map(move |j| (0..x).map(move |i| (k, j, i)))) {
        let is_chosen = random.uniform() * left < missing;
        left -= 1.0;
        if is_chosen {
            missing -= 1.0;
            let middle = (DVec3::new(f64::from(i), f64::from(j), f64::from(k)) + DVec3::splat(0.5)) * cell;
            let place = DVec3::from_array([0.0; 3].map(|_| random.uniform() - 0.5)) * slack;
            let rotation = any_rotation(&mut random);
            let suffix = (stands.len() + 1).to_string();
            stands.push(Stand { piece: Piece::Whole, suffix, offset: middle + place, rotation });
        }
    }
    Ok(stands)
}

/// How many cells of this edge there is room for along each axis.
fn cells(size: [f64; 3], edge: f64) -> [f64; 3] {
    size.map(|size| (size / edge).floor())
}

/// A rotation, all with the same chance.
fn any_rotation(random: &mut SplitMix64) -> Rotation {
    loop {
        let wxyz = [0.0; 4].map(|_| 2.0 * random.uniform() - 1.0);
        let length = wxyz.iter().map(|number| number * number).sum::<f64>().sqrt();
        if !DIRECTION_LENGTHS.contains(&length) {
            continue;
        }
        if let Ok(rotation) = Rotation::from_wxyz(wxyz.map(|number| number / length)) {
            return rotation;
        }
    }
}

fn turned(suffix: String, offset: DVec3, turn: Rotation) -> Stand {
    Stand { piece: Piece::Whole, suffix, offset: turn.rotate(offset), rotation: turn }
}

/// The rotation of a layout about the vertical.
fn turn(angle: Option<f64>, path: &KeyPath) -> Result<Rotation, Fault> {
    let Some(angle) = angle else { return Ok(Rotation::IDENTITY) };
    Ok(Rotation::from_rotation_vector(finite(angle, &path.key("turn"))? * DVec3::Z))
}

fn spacing_of_courses(spacing: [f64; 2], path: &KeyPath) -> Result<[f64; 2], Fault> {
    for (axis, step) in spacing.into_iter().enumerate() {
        positive(step, &path.key("spacing").index(axis))?;
    }
    Ok(spacing)
}

fn at_least(value: u32, least: u32, path: &KeyPath) -> Result<(), Fault> {
    if value >= least {
        return Ok(());
    }
    let accepted = if least == 1 { "a whole number of at least 1" } else { "a whole number of at least 2" };
    Err((path.clone(), Refusal::Number { value: value.into(), accepted }))
}

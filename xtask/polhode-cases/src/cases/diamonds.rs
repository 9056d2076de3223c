//! Diamonds of bricks (thesis, Videos 12 to 15): rows of 1, 2, ..., m, ..., 2, 1 bricks, each row shifted by half a
//! brick, on a floor without friction. Up to m = 4 they stand for ever; the 5-diamond falls, and symmetrically.

use super::bodies::{BRICK, GRAVITY, cuboid, half_space};
use super::run::{Run, movement_m};
use super::ways::larger;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::spatial::UnitVector;
use polhode::{Acceleration, BodyId, BodySample, Effects, ErrorEstimation, Flow, Observer, Scene, Simulation};
use std::error::Error;

/// No brick of a diamond that stands moves more, m.
const STANDS_M: f64 = 1e-9;
/// Largest penetration, relative to the longest edge of a brick.
const PENETRATION: f64 = 1e-12;
/// The falling diamond stays its own mirror image to this, m, ...
const MIRROR_ERROR_M: f64 = 1e-9;
/// ... until a brick has moved so far, m: afterwards impacts come in any order.
const FALLEN_M: f64 = 0.5;

/// Whether bricks of one row, which touch at their sides, collide with each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sides {
    Collide,
    Ignored,
}

/// A brick's place in a diamond: row from the floor and column from the left, both from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Place {
    row: usize,
    column: usize,
}

fn bricks_in_row(m: usize, row: usize) -> usize {
    if row < m { row + 1 } else { 2 * m - 1 - row }
}

fn places(m: usize) -> Vec<Place> {
    (0..2 * m - 1).flat_map(|row| (0..bricks_in_row(m, row)).map(move |column| Place { row, column })).collect()
}

/// Distance of a brick's centre from the middle, m.
fn across(m: usize, place: Place) -> f64 {
    place.column as f64 - 0.5 * (bricks_in_row(m, place.row) as f64 - 1.0)
}

/// The m-diamond; body 0 is the floor, then the bricks row by row from the floor, left to right.
pub(super) fn diamond(m: usize, sides: Sides, duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let mut builder =
        Scene::builder(format!("diamond-{m}")).body(half_space("floor", UnitVector::Z)).duration_s(duration_s);
    let places = places(m);
    for place in &places {
        let center = DVec3::new(across(m, *place), 0.0, BRICK.z * (place.row as f64 + 0.5));
        builder = builder.body(cuboid(&format!("{}.{}", place.row + 1, place.column + 1), BRICK, 1.0, center)?);
    }
    if sides == Sides::Ignored {
        for row in 0..2 * m - 1 {
            let members =
                (0..places.len()).filter(|&brick| places[brick].row == row).map(|brick| BodyId::new(brick + 1));
            builder = builder.no_contact(members);
        }
    }
    Ok(builder.build()?)
}

/// Accelerations of the 5-diamond without contact between bricks of one row.
pub(super) fn rc_02(context: &Context) -> CaseResult {
    accelerations(context, "RC-02", Sides::Ignored)
}

/// The same with bricks that touch at their sides.
pub(super) fn rc_03(context: &Context) -> CaseResult {
    accelerations(context, "RC-03", Sides::Collide)
}

fn accelerations(context: &Context, case: &str, sides: Sides) -> CaseResult {
    /// Accelerations of mirror images agree to this, m/s^2 and rad/s^2.
    const MIRROR: f64 = 1e-10;
    let m = 5;
    let scene = diamond(m, sides, 1.0)?;
    let all = Simulation::new(&scene)?.accelerations()?;
    let bricks = &all[1..];
    let mut rows = Vec::new();
    let (mut power, mut asymmetry) = (0.0, 0.0f64);
    for (place, acceleration) in places(m).into_iter().zip(bricks) {
        power -= GRAVITY * acceleration.linear.z;
        let image = plane(&bricks[mirror(m, place)]);
        let own = plane(acceleration);
        asymmetry =
            asymmetry.max((own[0] + image[0]).abs()).max((own[1] - image[1]).abs()).max((own[2] + image[2]).abs());
        let x = across(m, place);
        if x >= 0.0 {
            let quantity = format!("row {} x={x:.1}: ax, ay, alpha, m/s^2, rad/s^2", place.row + 1);
            rows.push(context.reference.row(case, &quantity, own)?);
        }
    }
    rows.push(context.reference.row(case, "sum of m g.a, W/s", power)?);
    rows.push(context.reference.row(case, "accelerations mirror symmetric to 1e-10", asymmetry <= MIRROR)?);
    let out_of_plane = bricks.iter().map(|a| a.linear.y.abs().max(a.angular.x.abs()).max(a.angular.z.abs()));
    rows.push(Row::at_most(case, "largest acceleration out of the plane", MIRROR, out_of_plane.fold(0.0, f64::max)));
    Ok(rows)
}

/// Acceleration in the plane: along x, along z, and anticlockwise seen with x to the right and z up, which is a turn
/// about -y.
fn plane(acceleration: &Acceleration) -> [f64; 3] {
    [acceleration.linear.x, acceleration.linear.z, -acceleration.angular.y]
}

/// Number of the brick that is the mirror image of another one.
fn mirror(m: usize, place: Place) -> usize {
    let before: usize = (0..place.row).map(|row| bricks_in_row(m, row)).sum();
    before + bricks_in_row(m, place.row) - 1 - place.column
}

/// The diamonds that stand, for a minute with every effect simulated; the plan, which skips what rests, changes no bit.
pub(super) fn stand(_context: &Context) -> CaseResult {
    let (case, mut rows) = ("diamonds stand", Vec::new());
    for m in 2..=4 {
        let scene = diamond(m, Sides::Collide, 60.0)?;
        let run = Run::of(&scene, Effects::All)?;
        rows.extend(standing_rows(case, &format!("{m}-diamond, 60 s"), &run));
        let planned = Run::of(&scene, Effects::Planned)?;
        let same = planned.report.bodies == run.report.bodies;
        rows.push(Row::exact(case, &format!("{m}-diamond, 60 s: planned effects end with the same bits"), true, same));
    }
    Ok(rows)
}

/// The 4-diamond for an hour; resting bricks may be skipped.
pub(super) fn stands_for_an_hour(_context: &Context) -> CaseResult {
    /// Wall time asked for, s.
    const WALL_S: f64 = 10.0;
    let case = "diamond-4 for an hour";
    let run = Run::of(&diamond(4, Sides::Collide, 3600.0)?, Effects::Planned)?;
    let mut rows = standing_rows(case, "4-diamond, 3600 s", &run);
    rows.push(Row::info(case, "wall time, s (asked: under 10)", WALL_S, run.wall_s));
    Ok(rows)
}

fn standing_rows(case: &str, name: &str, run: &Run) -> Vec<Row> {
    let penetration = run.report.certificate.max_penetration_m / BRICK.x;
    vec![
        Row::at_most(case, &format!("{name}: largest movement, m"), STANDS_M, run.largest_movement_m()),
        Row::at_most(case, &format!("{name}: penetration / brick"), PENETRATION, penetration),
    ]
}

/// The 5-diamond falls, and stays its own mirror image while it does.
pub(super) fn falls_symmetrically(_context: &Context) -> CaseResult {
    let case = "diamond-5 falls";
    let scene = diamond(5, Sides::Collide, 1.0)?;
    let mut watch = Fall { scene: &scene, start: Vec::new(), fallen: false, mirror_error_m: 0.0, out_of_plane_m: 0.0 };
    let report = Simulation::new(&scene)?.estimating(ErrorEstimation::Off).run_observed(&mut watch)?;
    Ok(vec![
        Row::exact(case, "a brick moves more than 0.5 m within 1 s", true, watch.fallen),
        Row::at_most(case, "mirror error until then, m", MIRROR_ERROR_M, watch.mirror_error_m),
        Row::at_most(case, "motion out of the plane until then, m", MIRROR_ERROR_M, watch.out_of_plane_m),
        Row::at_most(case, "penetration / brick", PENETRATION, report.certificate.max_penetration_m / BRICK.x),
    ])
}

/// Watches the 5-diamond until a brick has fallen.
#[derive(Debug)]
struct Fall<'a> {
    scene: &'a Scene,
    start: Vec<BodySample>,
    fallen: bool,
    mirror_error_m: f64,
    out_of_plane_m: f64,
}

impl Observer for Fall<'_> {
    fn sample(&mut self, _t: f64, bodies: &[BodySample]) {
        if self.start.is_empty() {
            self.start = bodies.to_vec();
        }
        if !self.fallen {
            self.mirror_error_m = self.mirror_error_m.max(mirror_error_m(5, &bodies[1..]));
            let across = bodies[1..].iter().map(|brick| brick.pose.translation.y.abs());
            self.out_of_plane_m = across.fold(self.out_of_plane_m, larger);
            self.fallen = movement_m(self.scene, &self.start, bodies) > FALLEN_M;
        }
    }

    fn progress(&mut self, _t: f64) -> Flow {
        if self.fallen { Flow::Stop } else { Flow::Continue }
    }
}

/// Largest distance between the centre of a brick and the mirror image of its partner's, m.
pub(super) fn mirror_error_m(m: usize, bricks: &[BodySample]) -> f64 {
    let errors = places(m).into_iter().zip(bricks).map(|(place, brick)| {
        let image = bricks[mirror(m, place)].pose.translation * DVec3::new(-1.0, 1.0, 1.0);
        (brick.pose.translation - image).length()
    });
    errors.fold(0.0, |worst: f64, error| if error.is_nan() { f64::INFINITY } else { worst.max(error) })
}

#[cfg(test)]
mod tests {
    //! The geometry of the diamonds: numbers of bricks, half-brick offsets, mirror images.
    use super::*;

    #[test]
    fn a_diamond_has_m_squared_bricks_and_is_symmetric() {
        for m in 1..=6 {
            let places = places(m);
            assert_eq!(places.len(), m * m);
            for (number, &place) in places.iter().enumerate() {
                let image = places[mirror(m, place)];
                assert_eq!(image.row, place.row);
                assert_eq!(across(m, image), -across(m, place));
                assert_eq!(mirror(m, image), number);
            }
        }
    }

    #[test]
    fn rows_are_shifted_by_half_a_brick() {
        for row in 0..8 {
            let left = |row| across(5, Place { row, column: 0 });
            assert_eq!((left(row + 1) - left(row)).abs(), 0.5);
        }
    }
}

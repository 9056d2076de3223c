//! Symmetric stackings: prisms of 3 to 64 sides on prisms and boxes, in and out of touch, aligned and turned; by the
//! contact crate and by parry3d's own manifolds.
//!
//! Every arrangement stands upright at the origin, a million metres away, and turned as a whole. The contact region is
//! the overlap of two polygons, found exactly; so is the separation along the normals of the two faces.

use super::feature_numbers::JudgedBody;
use super::random_pairs::prism_points;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use parry3d::query::{ContactManifold, DefaultQueryDispatcher, PersistentQueryDispatcher};
use parry3d::shape::{ConvexPolyhedron as ParryPolyhedron, Cuboid, Shape as ParryShape};
use polhode::spatial::{Pose, Rotation};
use polhode_contact::{evaluate, manifold};
use polhode_oracles::exact::overlap;
use polhode_oracles::exact::pair::{Axis, AxisOf, ExactPair, ExactSeparation, Pair};
use polhode_oracles::exact::polyhedron::Polyhedron;
use std::error::Error;

const CASE: &str = "stackings";
const SIDES: std::ops::RangeInclusive<u32> = 3..=64;
const SIZES: [f64; 6] = [1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4];
/// Beside zero, which every arrangement is tried at.
const GAPS: [f64; 20] = [
    1e-12, -1e-12, 1e-11, -1e-11, 1e-10, -1e-10, 1e-9, -1e-9, 1e-8, -1e-8, 1e-7, -1e-7, 1e-6, -1e-6, 1e-5, -1e-5, 1e-4,
    -1e-4, 1e-3, -1e-3,
];
/// A part run takes every so many of the arrangements: a prime, so that every side, size and angle has its turn.
const STRIDE: usize = 307;
/// Distance from the origin of the stacks that stand far away, m.
const FAR: DVec3 = DVec3::new(1e6, -1e6, 1e6);
/// Rotation vector of the stacks that are turned as a whole, rad.
const TILT: DVec3 = DVec3::new(0.3, -1.1, 0.7);
/// Gaps beside zero that an arrangement is tried at; the next ones are the next arrangement's.
const GAPS_EACH: usize = 3;
/// Contacts up to this separation are asked for, relative to the size.
const REACH: f64 = 0.01;
/// A normal off by more than this is wrong, rad.
const NORMAL: f64 = 1e-9;
/// Largest error of a separation, relative to the size of the larger body.
const DEPTH: f64 = 4e-15;
/// Corners of the region nearer to each other, or to the line of their neighbours, than this are one, relative to the
/// size: between the rounding of corners (1e-16) and the least that the angles and offsets make (1e-4).
const ONE_CORNER: f64 = 1e-10;
/// Component along the vertical that tells a level face from all others.
const ALMOST_LEVEL: f64 = 0.999_999;
/// A contact this near to a corner, relative to the size, stands there.
const AT_CORNER: f64 = 1e-9;
const NOT_LEVEL: &str = "a stack without level faces";
/// So many findings are described on stderr.
const DESCRIBED: u64 = 5;

/// What lies below.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Base {
    SamePrism,
    OtherPrism,
    WideBox,
    SmallBox,
}

const BASES: [Base; 4] = [Base::SamePrism, Base::OtherPrism, Base::WideBox, Base::SmallBox];

/// A body for both crates.
struct Body {
    judged: JudgedBody,
    parry: Box<dyn ParryShape>,
    half_height: f64,
}

fn prism(sides: u32, radius: f64, height: f64) -> Result<Body, Box<dyn Error>> {
    let points = prism_points(sides, radius, height);
    let parry = ParryPolyhedron::from_convex_hull(&points).ok_or("parry3d builds no hull of a prism")?;
    let judged = JudgedBody::hull(&points).ok_or("no hull of a prism")?;
    Ok(Body { judged, parry: Box::new(parry), half_height: 0.5 * height })
}

fn cuboid(size: DVec3) -> Result<Body, Box<dyn Error>> {
    let judged = JudgedBody::cuboid(size).ok_or("no box")?;
    Ok(Body { judged, parry: Box::new(Cuboid::new(0.5 * size)), half_height: 0.5 * size.z })
}

/// What one of the crates got wrong.
#[derive(Debug, Default, Clone)]
struct Tally {
    stacks: u64,
    wrong_normals: u64,
    missing: u64,
    surplus: u64,
    /// Of equal prisms, centred, exactly touching.
    touching: u64,
    touching_wrong: u64,
    depth: f64,
    described: u64,
}

impl Tally {
    fn count(&mut self, found: &Found, is_touching: bool) {
        self.stacks += 1;
        self.wrong_normals += u64::from(found.wrong_normal);
        self.missing += u64::from(found.missing > 0);
        self.surplus += u64::from(found.surplus > 0);
        self.touching += u64::from(is_touching);
        self.touching_wrong += u64::from(is_touching && found.wrong_normal);
        self.depth = self.depth.max(found.depth);
    }
}

impl Tally {
    fn add(&mut self, other: &Self) {
        self.stacks += other.stacks;
        self.wrong_normals += other.wrong_normals;
        self.missing += other.missing;
        self.surplus += other.surplus;
        self.touching += other.touching;
        self.touching_wrong += other.touching_wrong;
        self.depth = self.depth.max(other.depth);
    }
}

/// What is wrong with one manifold.
#[derive(Debug, Default)]
struct Found {
    wrong_normal: bool,
    missing: usize,
    surplus: usize,
    depth: f64,
}

/// Corners and contacts matched one to one: how many corners have none, and how many contacts no corner of their own.
fn matched(truth: &Truth, places: &[DVec3], tolerance: f64) -> (usize, usize) {
    let Truth { corners, normal, .. } = truth;
    let mut free = vec![true; corners.len()];
    let mut surplus = 0;
    for place in places {
        let level = |corner: &DVec3| (*corner - *place).reject_from_normalized(*normal).length();
        match (0..corners.len()).find(|&k| free[k] && level(&corners[k]) <= tolerance) {
            Some(k) => free[k] = false,
            None => surplus += 1,
        }
    }
    (free.iter().filter(|f| **f).count(), surplus)
}

/// Turns that are tried on a prism, rad: whole degrees and the angles at which corners coincide.
fn turns(sides: u32) -> Vec<f64> {
    let mut turns: Vec<f64> = (0..=90).map(|degrees| f64::from(degrees).to_radians()).collect();
    let step = std::f64::consts::TAU / f64::from(sides);
    turns.extend((1..=sides / 4).map(|k| f64::from(k) * step));
    turns.push(0.5 * step);
    turns
}

/// Two bodies one above the other, near the origin; the gap comes later.
struct Stack<'a> {
    upper: &'a Body,
    lower: &'a Body,
    turn: f64,
    offset: DVec3,
    size: f64,
    is_symmetric: bool,
}

/// The lowest face of the upper body and the highest of the lower one.
fn level_faces(a: &Polyhedron, b: &Polyhedron) -> Option<[usize; 2]> {
    let level = |p: &Polyhedron, z: f64| p.faces.iter().position(|f| f.normal.z * z > ALMOST_LEVEL);
    Some([level(a, -1.0)?, level(b, 1.0)?])
}

/// Where a stack stands.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Place {
    Here,
    Far,
    Turned,
}

/// What is right of a stack.
struct Truth {
    /// Corners of the contact region from the upper body's origin, in axes of the world.
    corners: Vec<DVec3>,
    /// Separations along the normals of the two faces, of which the larger counts.
    separations: Vec<ExactSeparation>,
    normal: DVec3,
}

impl Truth {
    /// How far a measured separation is off, m.
    fn error(&self, measured: f64) -> f64 {
        self.separations.iter().map(|s| s.less(measured)).fold(f64::NEG_INFINITY, f64::max).abs()
    }
}

impl Stack<'_> {
    fn poses(&self, gap: f64, place: Place) -> [Pose; 2] {
        let height = self.upper.half_height + self.lower.half_height + gap * self.size;
        let upper = Pose::new(Rotation::from_rotation_vector(DVec3::Z * self.turn), self.offset + DVec3::Z * height);
        let below = match place {
            Place::Here => Pose::IDENTITY,
            Place::Far => Pose::from_translation(FAR),
            Place::Turned => Pose::new(Rotation::from_rotation_vector(TILT), DVec3::ZERO),
        };
        [below * upper, below]
    }

    /// Corners and normal, which do not depend on the gap: it is along the normal.
    fn region(&self, poses: &[Pose; 2]) -> Option<(Vec<DVec3>, DVec3)> {
        let (a, b) = (&self.upper.judged.polyhedron, &self.lower.judged.polyhedron);
        let pair = Pair::new(a, &poses[0], b, &poses[1]);
        let corners = overlap::vertices(&pair, &ExactPair::new(&pair), level_faces(a, b)?, ONE_CORNER * self.size);
        Some((corners, poses[1].rotation.rotate(DVec3::Z)))
    }

    /// Separations along the normals of the two faces, of which the larger counts.
    fn separations(&self, poses: &[Pose; 2], place: Place) -> Option<Vec<ExactSeparation>> {
        let (a, b) = (&self.upper.judged.polyhedron, &self.lower.judged.polyhedron);
        if place != Place::Turned {
            // Exactly level faces: a sum of four heights.
            let heights =
                [poses[0].translation.z, -poses[1].translation.z, -self.upper.half_height, -self.lower.half_height];
            return Some(vec![ExactSeparation::sum(&heights)]);
        }
        let pair = Pair::new(a, &poses[0], b, &poses[1]);
        let exact = ExactPair::new(&pair);
        let [face_a, face_b] = level_faces(a, b)?;
        let axis = |of| Axis { of, normal: DVec3::ZERO, separation: 0.0, sine: 1.0 };
        let along = [AxisOf::FaceA(face_a), AxisOf::FaceB(face_b)];
        Some(along.iter().filter_map(|&of| Some(exact.best(&[axis(of)])?.1)).collect())
    }

    fn by_the_crate(&self, poses: &[Pose; 2], truth: &Truth) -> Found {
        let (a, b) = (&self.upper.judged.shape, &self.lower.judged.shape);
        let result = manifold(a, &poses[0], b, &poses[1], REACH * self.size);
        // The same contacts near the origin, where places have all their digits.
        let between = poses[1].translation - poses[0].translation;
        let near = [Pose::new(poses[0].rotation, DVec3::ZERO), Pose::new(poses[1].rotation, between)];
        let geometry = result.contacts.iter().filter_map(|c| evaluate(c.feature, a, &near[0], b, &near[1]));
        let places: Vec<DVec3> = geometry.map(|g| g.point).collect();
        let (missing, surplus) = matched(truth, &places, AT_CORNER * self.size);
        let depths = result.contacts.iter().map(|c| c.geometry.separation).chain([result.separation]);
        Found {
            wrong_normal: result.contacts.iter().any(|c| (c.geometry.normal - truth.normal).length() > NORMAL),
            missing,
            surplus: surplus + (result.contacts.len() - places.len()),
            depth: depths.map(|depth| truth.error(depth)).fold(0.0, f64::max) / a.size().max(b.size()),
        }
    }

    fn by_parry(&self, poses: &[Pose; 2], truth: &Truth) -> Result<Found, Box<dyn Error>> {
        let relative = poses[0].relative(&poses[1]);
        let reach = REACH * self.size;
        let pose = parry3d::math::Pose::from_parts(relative.translation, relative.rotation.quaternion());
        let mut manifolds: Vec<ContactManifold<(), ()>> = Vec::new();
        DefaultQueryDispatcher
            .contact_manifolds(&pose, &*self.upper.parry, &*self.lower.parry, reach, &mut manifolds, &mut None)
            .map_err(|error| error.to_string())?;
        let mut found = Found::default();
        let mut places = Vec::new();
        for manifold in &manifolds {
            let within = manifold.points.iter().filter(|p| p.dist <= reach);
            places.extend(within.map(|p| poses[0].rotation.rotate(p.local_p1)));
            found.wrong_normal |= (poses[0].rotation.rotate(manifold.local_n1) + truth.normal).length() > NORMAL;
        }
        (found.missing, found.surplus) = matched(truth, &places, AT_CORNER * self.size);
        Ok(found)
    }
}

/// Every stacking by both crates, a thread for each size.
pub(super) fn symmetric(context: &Context) -> CaseResult {
    let every = if context.amount == super::Amount::Full { 1 } else { STRIDE };
    let mut tallies = [Tally::default(), Tally::default()];
    std::thread::scope(|scope| {
        let of_size = |size| scope.spawn(move || stacks_of_size(size, every).map_err(|error| error.to_string()));
        let threads: Vec<_> = SIZES.into_iter().map(of_size).collect();
        for thread in threads {
            let found = thread.join().map_err(|_| "a panic: a bug, whatever the input was".to_owned())??;
            tallies.iter_mut().zip(&found).for_each(|(tally, more)| tally.add(more));
        }
        Ok::<(), String>(())
    })?;
    let [ours, theirs] = tallies;
    Ok(rows(&ours, &theirs))
}

/// Stackings of one size: what this crate got wrong, and what parry3d.
fn stacks_of_size(size: f64, every: usize) -> Result<[Tally; 2], Box<dyn Error>> {
    let (mut ours, mut theirs, mut number) = (Tally::default(), Tally::default(), 0_usize);
    for sides in SIDES {
        let upper = prism(sides, 0.5 * size, size)?;
        for base in BASES {
            let lower = match base {
                Base::SamePrism => prism(sides, 0.5 * size, size)?,
                Base::OtherPrism => prism(67 - sides, 0.45 * size, 0.7 * size)?,
                Base::WideBox => cuboid(DVec3::new(4.0, 3.0, 0.5) * size)?,
                Base::SmallBox => cuboid(DVec3::new(0.6, 0.6, 0.3) * size)?,
            };
            for turn in turns(sides) {
                for offset in [DVec3::ZERO, DVec3::new(0.125, -0.0625, 0.0) * size] {
                    number += 1;
                    if number % every != 0 {
                        continue;
                    }
                    let is_symmetric = base == Base::SamePrism && offset == DVec3::ZERO;
                    let stack = Stack { upper: &upper, lower: &lower, turn, offset, size, is_symmetric };
                    some_gaps(&stack, number, &mut ours, &mut theirs)?;
                }
            }
        }
    }
    Ok([ours, theirs])
}

/// One arrangement at a few gaps, here, far away and turned.
fn some_gaps(stack: &Stack<'_>, number: usize, ours: &mut Tally, theirs: &mut Tally) -> Result<(), Box<dyn Error>> {
    for place in [Place::Here, Place::Far, Place::Turned] {
        let (corners, normal) = stack.region(&stack.poses(0.0, place)).ok_or(NOT_LEVEL)?;
        let mut truth = Truth { corners, normal, separations: Vec::new() };
        // The exact separation of a turned stack is dear.
        let others = if place == Place::Turned { 1 } else { GAPS_EACH };
        for gap in (0..others).map(|k| GAPS[(number * GAPS_EACH + k) % GAPS.len()]).chain([0.0]) {
            let poses = stack.poses(gap, place);
            truth.separations = stack.separations(&poses, place).ok_or(NOT_LEVEL)?;
            let is_touching = stack.is_symmetric && gap == 0.0 && place == Place::Here;
            let found = stack.by_the_crate(&poses, &truth);
            ours.count(&found, is_touching);
            if found.wrong_normal || found.missing + found.surplus > 0 || found.depth > DEPTH {
                ours.described += 1;
                if ours.described <= DESCRIBED {
                    let (Stack { turn, offset, size, .. }, corners) = (stack, truth.corners.len());
                    eprintln!(
                        "{CASE}: size {size}, turn {turn}, offset {offset}, gap {gap}, {place:?}, {corners} corners: \
                         {found:?}"
                    );
                }
            }
            theirs.count(&stack.by_parry(&poses, &truth)?, is_touching);
        }
    }
    Ok(())
}

fn rows(ours: &Tally, theirs: &Tally) -> Vec<Row> {
    let of = |what: &str| format!("{what} (of {} stacks)", ours.stacks);
    let touching = format!("equal prisms exactly touching: wrong normals (of {})", ours.touching);
    let parry = |what: &str| format!("parry3d: {what}");
    vec![
        Row::exact(CASE, &of("wrong normals, beyond 1e-9 rad"), 0_u64, ours.wrong_normals),
        Row::info(CASE, &parry(&of("wrong normals, beyond 1e-9 rad")), 0_u64, theirs.wrong_normals),
        Row::exact(CASE, &touching, 0_u64, ours.touching_wrong),
        Row::info(CASE, &parry(&touching), 0_u64, theirs.touching_wrong),
        Row::exact(CASE, &of("with missing corners"), 0_u64, ours.missing),
        Row::info(CASE, &parry(&of("with missing corners")), 0_u64, theirs.missing),
        Row::exact(CASE, &of("with surplus or duplicate contacts"), 0_u64, ours.surplus),
        Row::info(CASE, &parry(&of("with surplus or duplicate contacts")), 0_u64, theirs.surplus),
        Row::at_most(CASE, "error of every separation, relative to the size", DEPTH, ours.depth),
    ]
}

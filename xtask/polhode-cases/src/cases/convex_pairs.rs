//! Random convex pairs against a plain search over all axes, and a sample of them against exact arithmetic.

use super::feature_numbers::{self, Numbers};
use super::random_pairs::{self, RandomPair};
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode_contact::{Contact, Manifold, manifold};
use polhode_oracles::exact::expected::{self, Expected};
use polhode_oracles::exact::feature::Feature;
use polhode_oracles::exact::pair::{Axis, ExactPair, Pair};

const CASE: &str = "convex pairs";
/// Pairs of a full run, and those of them that exact arithmetic judges.
const PAIRS: usize = 1_000_000;
const EXACT_PAIRS: usize = 10_000;
/// A normal off by more than this is wrong, rad.
const NORMAL: f64 = 1e-9;
/// Largest error of a separation, relative to the size of the larger body.
const DEPTH: f64 = 4e-15;
/// Separations in f64 that differ by less than this, relative to the scale, are the same.
const SEPARATION: f64 = 1e-11;
/// Cosine of 0.01 rad: the normals of one contact region.
const ALIKE: f64 = 0.999_95;
/// So many findings of a run are described on stderr.
const DESCRIBED: u64 = 5;

/// What a run found.
#[derive(Debug, Default)]
struct Tally {
    pairs: u64,
    /// Pairs of which a body of the crate's is not the exact hull.
    other_hulls: u64,
    wrong_normals: u64,
    missing: u64,
    surplus: u64,
    ties: u64,
    regions: u64,
    undecided: u64,
    contacts: u64,
    edges: u64,
    overlapping: u64,
    described: u64,
}

impl Tally {
    fn describe(&mut self, number: u64, what: &str) {
        self.described += 1;
        if self.described <= DESCRIBED {
            eprintln!("{CASE}: pair {number}: {what}");
        }
    }
}

/// Normals, vertices of the contact region and depths of random pairs.
#[allow(clippy::unnecessary_wraps, reason = "the table of cases takes results")]
pub(super) fn random(context: &Context) -> CaseResult {
    let mut tally = Tally::default();
    for number in 0..context.amount.of(PAIRS) as u64 {
        judge(&mut tally, number, &random_pairs::pair(number));
    }
    let (mut depth, mut depth_far, mut normals, mut skipped) = (0.0_f64, 0.0_f64, 0_u64, 0_u64);
    for number in 0..context.amount.of(EXACT_PAIRS) as u64 {
        match exact_errors(&random_pairs::pair(number)) {
            Some(found) => {
                let worst = if found.is_far { &mut depth_far } else { &mut depth };
                if found.depth > DEPTH {
                    eprintln!("{CASE}: pair {number}: separation off by {:e} sizes", found.depth);
                }
                *worst = worst.max(found.depth);
                normals += u64::from(found.wrong_normal);
            }
            None => skipped += 1,
        }
    }
    // The number of pairs is part of the name: what fails in many may pass in few.
    let named = |what: &str| format!("{what}, of {} pairs", context.amount.of(PAIRS));
    let exact = |what: &str| format!("{what}, of {} pairs in exact arithmetic", context.amount.of(EXACT_PAIRS));
    Ok(vec![
        Row::exact(CASE, &named("faces and edges that are not those of the hull"), 0_u64, tally.other_hulls),
        Row::exact(CASE, &named("wrong normals, beyond 1e-9 rad"), 0_u64, tally.wrong_normals),
        Row::exact(CASE, &named("missing contacts"), 0_u64, tally.missing),
        Row::exact(CASE, &named("surplus or duplicate contacts"), 0_u64, tally.surplus),
        Row::info(
            CASE,
            "pairs, of them overlapping",
            [tally.pairs as f64; 2],
            [tally.pairs as f64, tally.overlapping as f64],
        ),
        Row::info(CASE, "contacts, of them crossings of edges", [0.0; 2], [tally.contacts as f64, tally.edges as f64]),
        Row::info(
            CASE,
            "regions of three corners and more; pairs that may be decided in several ways; contacts that may be left \
             out",
            [0.0; 3],
            [tally.regions as f64, tally.ties as f64, tally.undecided as f64],
        ),
        Row::at_most(CASE, &exact("error of the separation, relative to the size"), DEPTH, depth),
        Row::at_most(CASE, &exact("the same a million metres away"), DEPTH, depth_far),
        Row::exact(CASE, &exact("axes that are not the best"), 0_u64, normals),
        Row::info(CASE, "pairs beyond reach, whose separation is not asked for", 0_u64, skipped),
    ])
}

/// The pair in the arithmetic of the oracle.
fn pair(random: &RandomPair) -> Pair<'_> {
    let ([a, b], [pose_a, pose_b]) = (&random.bodies, &random.poses);
    Pair::new(&a.polyhedron, pose_a, &b.polyhedron, pose_b)
}

fn found_by_the_crate(pair: &RandomPair) -> Manifold {
    manifold(&pair.bodies[0].shape, &pair.poses[0], &pair.bodies[1].shape, &pair.poses[1], pair.reach)
}

fn judge(tally: &mut Tally, number: u64, random: &RandomPair) {
    let [Some(a), Some(b)] = random.bodies.each_ref().map(|body| body.numbers.as_ref()) else {
        tally.other_hulls += 1;
        tally.describe(number, "a body that is not the hull of its points");
        return;
    };
    let found = found_by_the_crate(random);
    let pair = pair(random);
    let of = feature_numbers::axis([a, b], found.axis);
    let contacts = named(&found, [a, b]);
    let mut axes = pair.axes();
    for axis in axes.iter_mut().filter(|axis| Some(axis.of) == of && !axis.is_told()) {
        *axis = ExactPair::new(&pair).told(axis).unwrap_or(*axis);
    }
    let near = pair.equally_good(&axes);
    let Some(best) = near.first() else { return };
    tally.pairs += 1;
    tally.overlapping += u64::from(best.separation < 0.0);
    tally.contacts += found.contacts.len() as u64;
    tally.edges +=
        contacts.iter().filter(|(_, feature)| matches!(feature, Some(Feature::EdgeEdge { .. }))).count() as u64;
    if found.separation > random.reach && best.separation > random.reach {
        return;
    }
    let expected = of.map_or(Expected::WrongAxis, |of| expected::contacts(&pair, &axes, of, random.reach));
    let wrong_axis =
        matches!(expected, Expected::WrongAxis) || (found.separation - best.separation).abs() > SEPARATION * pair.scale;
    if wrong_axis || contacts.iter().any(|&(c, feature)| wrong_normal(&pair, c, feature, &near)) {
        tally.wrong_normals += 1;
        tally.describe(number, &format!("wrong normal: best {best:?}, found {found:?}"));
    }
    let (mut missing, mut surplus) = (0, 0);
    match &expected {
        Expected::WrongAxis => {}
        Expected::Tie => tally.ties += 1,
        Expected::Contacts { sure, perhaps } => {
            tally.undecided += perhaps.len() as u64;
            tally.regions += u64::from(sure.len() > 2);
            let has = |feature: &Feature| contacts.iter().any(|(_, of)| *of == Some(*feature));
            missing = sure.iter().filter(|feature| !has(feature)).count() as u64;
            let is_known = |feature: &Feature| sure.contains(feature) || perhaps.contains(feature);
            surplus = contacts.iter().filter(|(_, of)| !of.as_ref().is_some_and(is_known)).count() as u64;
        }
    }
    if found.contacts.is_empty() && best.separation < 0.0 {
        // Whatever decides: bodies that overlap touch somewhere.
        missing = missing.max(1);
    }
    tally.missing += missing;
    tally.surplus += surplus;
    if missing + surplus > 0 {
        tally.describe(number, &format!("expected {expected:?}, found {found:?}, best {best:?}"));
    }
}

/// The crate's contacts, each with the feature that the oracle knows it by.
fn named<'a>(found: &'a Manifold, numbers: [&Numbers; 2]) -> Vec<(&'a Contact, Option<Feature>)> {
    found.contacts.iter().map(|contact| (contact, feature_numbers::feature(numbers, contact.feature))).collect()
}

/// Whether a contact's normal is not that of its features, or belongs to another contact region: those of a region are
/// alike to one of the best axes, or to the normal of a face that is.
fn wrong_normal(pair: &Pair<'_>, contact: &Contact, feature: Option<Feature>, best: &[Axis]) -> bool {
    let found = contact.geometry.normal;
    let meant = match feature {
        Some(Feature::VertexFace { vertex_of: 0, face, .. }) => pair.face_normal(1, face),
        Some(Feature::VertexFace { face, .. }) => -pair.face_normal(0, face),
        Some(Feature::EdgeEdge { edge_a, edge_b }) => {
            let axis = pair.across(edge_a, edge_b);
            let exact = if axis.is_told() { None } else { ExactPair::new(pair).told(&axis) };
            exact.unwrap_or(axis).normal
        }
        None => return true,
    };
    let alike = |normal: DVec3| best.iter().any(|axis| axis.normal.dot(normal) >= ALIKE);
    let toward_a = |body: usize, sign: f64| {
        (0..pair.bodies[body].faces.len()).map(move |face| sign * pair.face_normal(body, face))
    };
    let mut faces = toward_a(0, -1.0).chain(toward_a(1, 1.0));
    let of_region = alike(found) || faces.any(|normal| normal.dot(found) >= ALIKE && alike(normal));
    (found - meant).length() > NORMAL || !of_region
}

/// Errors of a pair against exact arithmetic.
struct ExactErrors {
    /// Error of the separation relative to the size of the larger body.
    depth: f64,
    wrong_normal: bool,
    is_far: bool,
}

fn exact_errors(random: &RandomPair) -> Option<ExactErrors> {
    let pair = pair(random);
    let axes = pair.axes();
    let mut near = pair.near_best(&axes);
    // Of axes of one direction one is enough.
    near.dedup_by(|x, y| x.sine > NORMAL && x.normal == y.normal);
    let (best, separation) = ExactPair::new(&pair).best(&near)?;
    let found = found_by_the_crate(random);
    if found.separation > random.reach {
        return None;
    }
    let size = pair.bodies.map(|body| body.size).into_iter().fold(0.0, f64::max);
    // Of axes that are equally good to the clearance any may decide.
    let best = [vec![best], pair.equally_good(&axes)].concat();
    let is_right = |c: &Contact| best.iter().any(|axis| (c.geometry.normal - axis.normal).length() <= NORMAL);
    let wrong_normal =
        if found.contacts.is_empty() { separation.less(0.0) < 0.0 } else { !found.contacts.iter().any(is_right) };
    Some(ExactErrors {
        depth: separation.less(found.separation).abs() / size,
        wrong_normal,
        is_far: random.poses[0].translation.length() > size,
    })
}

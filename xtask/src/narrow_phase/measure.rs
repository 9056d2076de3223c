//! Errors and times of the two methods on pairs whose separation is known by construction.

use polhode_contact::{ConvexMethod, ConvexPolyhedron, Shape, Workspace, separation_by};
use polhode_oracles::random::Random;
use polhode_spatial::{DVec3, Pose, Rotation};
use std::error::Error;
use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

/// Gaps relative to the size of the bodies, which is about one.
pub(super) const GAPS: [f64; 8] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15, 0.0];

/// Sides of the prisms; the first is a box.
pub(super) const SIDES: [u32; 4] = [4, 8, 32, 128];

/// Pairs of every kind and gap.
const PAIRS: usize = 200;

/// Rounds of timing, of which the median is taken, and pairs of a round.
const ROUNDS: usize = 9;
const PAIRS_OF_A_ROUND: usize = 64;

/// Largest errors at one gap.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Errors {
    /// Relative to the size.
    pub(super) separation: f64,
    /// Angle, rad.
    pub(super) normal: f64,
}

/// Of every method, at every gap.
#[derive(Debug, Clone, Default)]
pub(super) struct ErrorTable(pub(super) [[Errors; GAPS.len()]; 2]);

impl ErrorTable {
    /// Of both methods at one gap.
    pub(super) fn at(&self, gap: usize) -> [Errors; 2] {
        [self.0[0][gap], self.0[1][gap]]
    }
}

/// What was measured.
#[derive(Debug, Clone, Default)]
pub(super) struct Study {
    pub(super) errors: ErrorTable,
    /// Microseconds of a call, of every method for every shape.
    pub(super) times: [[f64; SIDES.len()]; 2],
}

/// A pair with its exact answer.
struct Pair {
    pose_a: Pose,
    pose_b: Pose,
    separation: f64,
    normal: DVec3,
}

impl Study {
    /// Measures everything.
    ///
    /// # Errors
    /// When a shape cannot be made.
    pub(super) fn run() -> Result<Self, Box<dyn Error>> {
        let mut study = Self::default();
        let mut random = Random(0x5eed);
        let mut workspace = Workspace::default();
        for (s, &sides) in SIDES.iter().enumerate() {
            let points = prism_points(sides);
            let shape = Shape::convex(ConvexPolyhedron::from_points(&points)?);
            for (k, &gap) in GAPS.iter().enumerate() {
                for round in 0..PAIRS {
                    let pair = pair(&mut random, &points, gap, round);
                    for (m, method) in ConvexMethod::ALL.into_iter().enumerate() {
                        let found = separation_by(method, &mut workspace, &shape, &pair.pose_a, &shape, &pair.pose_b);
                        let found = found.ok_or("no separation")?;
                        let worst = &mut study.errors.0[m][k];
                        worst.separation =
                            worst.separation.max((found.distance - pair.separation).abs() / shape.size());
                        worst.normal = worst.normal.max((found.normal - pair.normal).length());
                    }
                }
            }
            let pairs: Vec<Pair> = (0..PAIRS_OF_A_ROUND).map(|k| pair(&mut random, &points, GAPS[0], k)).collect();
            for (m, method) in ConvexMethod::ALL.into_iter().enumerate() {
                study.times[m][s] = time(method, &mut workspace, &shape, &pairs);
            }
        }
        Ok(study)
    }
}

/// Median over the rounds of the mean time of a call, us.
fn time(method: ConvexMethod, workspace: &mut Workspace, shape: &Shape, pairs: &[Pair]) -> f64 {
    let mut times: Vec<f64> = (0..ROUNDS)
        .map(|_| {
            let start = Instant::now();
            for pair in pairs {
                black_box(separation_by(method, workspace, shape, &pair.pose_a, shape, &pair.pose_b));
            }
            start.elapsed().as_secs_f64() * 1e6 / pairs.len() as f64
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[ROUNDS / 2]
}

/// A on B: a face on a face, turned about the vertical, or a vertex over a face; then both turned about.
fn pair(random: &mut Random, points: &[DVec3], gap: f64, round: usize) -> Pair {
    let turn = if round.is_multiple_of(2) {
        Rotation::from_rotation_vector(DVec3::Z * (TAU * random.unit()))
    } else {
        Rotation::from_rotation_vector(random.vector(-1.0, 1.0) * 3.0)
    };
    let lowest = points.iter().map(|&p| turn.rotate(p)).min_by(|p, q| p.z.total_cmp(&q.z)).unwrap_or_default();
    let aside = if round.is_multiple_of(2) {
        random.vector(-1.0, 1.0) * 0.2
    } else {
        DVec3::ZERO - lowest + random.vector(-1.0, 1.0) * 0.1
    };
    let height = 0.5 - lowest.z + gap;
    let pose_a = Pose::new(turn, DVec3::new(aside.x, aside.y, height));
    let all = Pose::new(Rotation::from_rotation_vector(random.vector(-1.0, 1.0) * 3.0), DVec3::ZERO);
    Pair {
        pose_a: all * pose_a,
        pose_b: all,
        // The height has been rounded: what is left of the gap is known exactly.
        separation: (height - 0.5) + lowest.z,
        normal: all.rotation.rotate(DVec3::Z),
    }
}

/// An upright prism about the origin, one high and one wide.
fn prism_points(sides: u32) -> Vec<DVec3> {
    let ring = |z: f64| {
        (0..sides).map(move |k| {
            let angle = (f64::from(k) + 0.5) / f64::from(sides) * TAU;
            DVec3::new(0.5 * angle.cos(), 0.5 * angle.sin(), z)
        })
    };
    ring(-0.5).chain(ring(0.5)).collect()
}

//! Contact problems that the tests and the benches share, built without any geometry code.

use polhode_response::ContactProblem;
use polhode_spatial::SplitMix64;

/// m/s^2.
pub(crate) const GRAVITY: f64 = 9.81;

/// A problem with the accelerations that the rows have without contact forces.
#[derive(Debug, Clone)]
pub(crate) struct Scene {
    pub(crate) problem: ContactProblem,
    pub(crate) b: Vec<f64>,
    /// Accelerations of all bodies without contact forces.
    pub(crate) free: Vec<f64>,
    /// `M` of all bodies, one block after the other, row-major.
    pub(crate) masses: Vec<f64>,
}

/// One row: blocks of one or two bodies.
pub(crate) type Row = Vec<(usize, Vec<f64>)>;

impl Scene {
    /// From the masses (diagonal of each body), the rows and the free acceleration of every body.
    pub(crate) fn new(width: usize, diagonals: &[Vec<f64>], rows: &[Row], free: &[f64]) -> Self {
        let (mut inverse, mut masses) = (Vec::new(), Vec::new());
        for diagonal in diagonals {
            for row in 0..width {
                for column in 0..width {
                    inverse.push(if row == column { 1.0 / diagonal[row] } else { 0.0 });
                    masses.push(if row == column { diagonal[row] } else { 0.0 });
                }
            }
        }
        let mut problem = ContactProblem::new(width, inverse).expect("masses are positive");
        for row in rows {
            let entries: Vec<(usize, &[f64])> = row.iter().map(|(body, block)| (*body, &block[..])).collect();
            problem.push_row(&entries).expect("rows are finite");
        }
        let free: Vec<f64> = diagonals.iter().flat_map(|_| free.iter().copied()).collect();
        let b = problem.row_velocities(&free).expect("lengths agree");
        Self { problem, b, free, masses }
    }

    /// Accelerations of all bodies under contact forces.
    pub(crate) fn accelerations(&self, forces: &[f64]) -> Vec<f64> {
        let response = self.problem.response(forces).expect("lengths agree");
        self.free.iter().zip(response).map(|(free, change)| free + change).collect()
    }

    /// `x.M x`.
    pub(crate) fn squared(&self, x: &[f64]) -> f64 {
        let width = self.problem.width();
        let mut sum = 0.0;
        for (body, block) in self.masses.chunks_exact(width * width).enumerate() {
            for row in 0..width {
                for column in 0..width {
                    sum += x[body * width + row] * block[row * width + column] * x[body * width + column];
                }
            }
        }
        sum
    }
}

/// A generator of numbers that are the same on every machine.
#[derive(Debug, Clone)]
pub(crate) struct Noise(SplitMix64);

impl Noise {
    /// Of a seed, so that a failing case can be found again.
    pub(crate) fn new(seed: u64) -> Self {
        Self(SplitMix64::new(seed))
    }

    /// Uniform in `[0, 1)`.
    pub(crate) fn unit(&mut self) -> f64 {
        self.0.uniform()
    }

    /// Uniform in `[-1, 1)`.
    pub(crate) fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// A whole number below `limit`.
    pub(crate) fn below(&mut self, limit: usize) -> usize {
        (self.unit() * limit as f64) as usize
    }

    /// A permutation of `0..count`.
    pub(crate) fn permutation(&mut self, count: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..count).collect();
        for k in (1..count).rev() {
            order.swap(k, self.below(k + 1));
        }
        order
    }
}

/// A body of 1 kg and inertia 1/3 kg m^2 on pillars at `xs`, in a plane, width 3.
pub(crate) fn beam(xs: &[f64]) -> Scene {
    let rows: Vec<Row> = xs.iter().map(|&x| vec![(0, vec![0.0, 1.0, x])]).collect();
    Scene::new(3, &[vec![1.0, 1.0, 1.0 / 3.0]], &rows, &[0.0, -GRAVITY, 0.0])
}

/// One brick of a diamond: centre, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Brick {
    pub(crate) x: f64,
    pub(crate) level: usize,
}

/// The bricks of the m-diamond, row by row from the bottom, left to right (case RC-01).
pub(crate) fn diamond_bricks(m: usize) -> Vec<Brick> {
    let sizes: Vec<usize> = (1..=m).chain((1..m).rev()).collect();
    let row = |(level, &size): (usize, &usize)| {
        (0..size).map(move |k| Brick { x: k as f64 - (size as f64 - 1.0) / 2.0, level }).collect::<Vec<_>>()
    };
    sizes.iter().enumerate().flat_map(row).collect()
}

/// The m-diamond of bricks 1 m by 1/4 m, 1 kg, in a plane; also (upper, lower or -1 for the floor, x) of each contact.
pub(crate) fn diamond(m: usize) -> (Scene, Vec<(usize, i32, f64)>) {
    let bricks = diamond_bricks(m);
    let mut contacts = vec![(0, -1, -0.5), (0, -1, 0.5)];
    for (upper, a) in bricks.iter().enumerate() {
        for (lower, b) in bricks.iter().enumerate() {
            if a.level == b.level + 1 && (a.x - b.x).abs() < 1.0 {
                let (left, right) = (a.x.max(b.x) - 0.5, a.x.min(b.x) + 0.5);
                contacts.extend([(upper, lower as i32, left), (upper, lower as i32, right)]);
            }
        }
    }
    let row = |&(upper, lower, x): &(usize, i32, f64)| {
        let mut row: Row = vec![(upper, vec![0.0, 1.0, x - bricks[upper].x])];
        if let Ok(lower) = usize::try_from(lower) {
            row.push((lower, vec![0.0, -1.0, bricks[lower].x - x]));
        }
        row
    };
    let rows: Vec<Row> = contacts.iter().map(row).collect();
    let mass = vec![1.0, 1.0, (1.0 + 0.0625) / 12.0];
    (Scene::new(3, &vec![mass; bricks.len()], &rows, &[0.0, -GRAVITY, 0.0]), contacts)
}

/// A tower of cubes of edge 1 m in space, 4 contacts below each, with the given masses from the bottom up and each
/// cube shifted by up to `shift` m.
pub(crate) fn tower(masses: &[f64], shift: f64, noise: &mut Noise) -> Scene {
    let centres: Vec<[f64; 2]> = masses.iter().map(|_| [shift * noise.signed(), shift * noise.signed()]).collect();
    let mut rows: Vec<Row> = Vec::new();
    for (upper, a) in centres.iter().enumerate() {
        let b = if upper == 0 { *a } else { centres[upper - 1] };
        for (sx, sy) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            let corner = |axis: usize, sign: f64| {
                let near = a[axis] + 0.5 * sign;
                let far = b[axis] + 0.5 * sign;
                if sign > 0.0 { near.min(far) } else { near.max(far) }
            };
            let (x, y) = (corner(0, sx), corner(1, sy));
            // r x n for n = (0, 0, 1): (r_y, -r_x, 0).
            let mut row: Row = vec![(upper, vec![0.0, 0.0, 1.0, y - a[1], a[0] - x, 0.0])];
            if upper > 0 {
                row.push((upper - 1, vec![0.0, 0.0, -1.0, b[1] - y, x - b[0], 0.0]));
            }
            rows.push(row);
        }
    }
    let diagonal = |&mass: &f64| vec![mass, mass, mass, mass / 6.0, mass / 6.0, mass / 6.0];
    let diagonals: Vec<Vec<f64>> = masses.iter().map(diagonal).collect();
    Scene::new(6, &diagonals, &rows, &[0.0, 0.0, -GRAVITY, 0.0, 0.0, 0.0])
}

/// Bodies in space with random unit normals and arms: each has `each` contacts with the floor or with bodies before
/// it. Masses from 1 to `ratio` kg.
pub(crate) fn pile(bodies: usize, each: usize, ratio: f64, noise: &mut Noise) -> Scene {
    let mut rows: Vec<Row> = Vec::new();
    for body in 0..bodies {
        for _ in 0..each {
            let tilt = [0.4 * noise.signed(), 0.4 * noise.signed()];
            let length = (tilt[0] * tilt[0] + tilt[1] * tilt[1] + 1.0_f64).sqrt();
            let normal = [tilt[0] / length, tilt[1] / length, 1.0 / length];
            let mut block = |sign: f64, height: f64| -> Vec<f64> {
                let r = [noise.signed(), noise.signed(), height];
                let moment = [
                    r[1] * normal[2] - r[2] * normal[1],
                    r[2] * normal[0] - r[0] * normal[2],
                    r[0] * normal[1] - r[1] * normal[0],
                ];
                normal.iter().chain(&moment).map(|value| sign * value).collect()
            };
            let mut row: Row = vec![(body, block(1.0, -0.5))];
            let other = block(-1.0, 0.5);
            if body > 0 && noise.unit() < 0.8 {
                row.push((noise.below(body), other));
            }
            rows.push(row);
        }
    }
    let diagonals: Vec<Vec<f64>> = (0..bodies)
        .map(|_| {
            let mass = ratio.powf(noise.unit());
            vec![
                mass,
                mass,
                mass,
                mass * (0.1 + noise.unit()),
                mass * (0.1 + noise.unit()),
                mass * (0.1 + noise.unit()),
            ]
        })
        .collect();
    Scene::new(6, &diagonals, &rows, &[0.0, 0.0, -GRAVITY, 0.0, 0.0, 0.0])
}

/// The 4-diamond in space with touching side faces: 16 bricks 1 x 1 x 1/4 m, 136 contacts.
pub(crate) fn diamond_in_space() -> Scene {
    let bricks = diamond_bricks(4);
    let mut rows: Vec<Row> = Vec::new();
    let mut push = |a: usize, b: Option<usize>, normal: [f64; 3], point: [f64; 3]| {
        let block = |body: usize, sign: f64| -> Vec<f64> {
            let r = [point[0] - bricks[body].x, point[1], point[2] - 0.25 * bricks[body].level as f64];
            let moment = [
                r[1] * normal[2] - r[2] * normal[1],
                r[2] * normal[0] - r[0] * normal[2],
                r[0] * normal[1] - r[1] * normal[0],
            ];
            normal.iter().chain(&moment).map(|value| sign * value).collect()
        };
        let mut row: Row = vec![(a, block(a, 1.0))];
        if let Some(b) = b {
            row.push((b, block(b, -1.0)));
        }
        rows.push(row);
    };
    for (_, lower, x) in diamond(4).1.iter().take(2) {
        assert_eq!(*lower, -1);
        for y in [-0.5, 0.5] {
            push(0, None, [0.0, 0.0, 1.0], [*x, y, -0.125]);
        }
    }
    for &(upper, lower, x) in diamond(4).1.iter().skip(2) {
        let z = 0.25 * bricks[upper].level as f64 - 0.125;
        for y in [-0.5, 0.5] {
            push(upper, usize::try_from(lower).ok(), [0.0, 0.0, 1.0], [x, y, z]);
        }
    }
    for (left, a) in bricks.iter().enumerate() {
        for (right, b) in bricks.iter().enumerate() {
            if a.level == b.level && b.x == a.x + 1.0 {
                let z = 0.25 * a.level as f64;
                for (y, side) in [(-0.5, -0.125), (0.5, -0.125), (0.5, 0.125), (-0.5, 0.125)] {
                    push(right, Some(left), [1.0, 0.0, 0.0], [a.x + 0.5, y, z + side]);
                }
            }
        }
    }
    let diagonal = vec![1.0, 1.0, 1.0, 1.0625 / 12.0, 1.0625 / 12.0, 2.0 / 12.0];
    Scene::new(6, &vec![diagonal; bricks.len()], &rows, &[0.0, 0.0, -GRAVITY, 0.0, 0.0, 0.0])
}

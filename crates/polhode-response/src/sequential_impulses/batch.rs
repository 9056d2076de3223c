//! Manifolds in batches of four, side by side in memory: what the sweeps read and write.

use super::colours::{BETWEEN_MOVABLE, Colours, GROUPS, NO_COLOUR};
use super::lanes::{FOUR, Four};
use super::manifold::{ImpulseManifold, ManifoldPoint};
use polhode_spatial::DVec3;

/// Four manifolds of one colour; lanes without one are of the immovable body 0 and of no effect.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Batch {
    pub(super) a: [u32; FOUR],
    pub(super) b: [u32; FOUR],
    /// Where its points begin, and how many there are.
    pub(super) first: u32,
    pub(super) count: u32,
    pub(super) normal: [Four; 3],
    pub(super) tangent: [Four; 3],
    /// From the centre of mass of A to the centre of the patch, and from that of B to that of A.
    pub(super) arm: [Four; 3],
    pub(super) between: [Four; 3],
    pub(super) friction: Four,
    pub(super) restitution: Four,
    /// 1 where A alone is moved by impulses, -1 where B alone is, 0 where both are.
    pub(super) side: Four,
    /// `patch.rs` says what of.
    pub(super) blocks: Blocks,
}

/// What impulses do to the coordinates of a patch: `K_NN`, `K_TT` (xx, xy, xz, yy, yz, zz) and `K_TN` (rows of `T`).
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Blocks {
    pub(super) pressing: [Four; 6],
    pub(super) slipping: [Four; 6],
    pub(super) coupling: [[Four; 3]; 3],
    /// The inverse of `K_TT`, and that of the sum of the squares of the distances of the points from the centre, 1/m^2.
    pub(super) sticking: [Four; 6],
    pub(super) spread: Four,
}

/// One point of each of the four manifolds.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct PointRows {
    /// Along both tangents from the centre of the patch, m.
    pub(super) place: [Four; 2],
    /// At the start of the step, and at present, m.
    pub(super) separation: Four,
    pub(super) present: Four,
    /// `K_nn` (1/kg) and its inverse; zero for a lane without a point.
    pub(super) stiffness: Four,
    pub(super) mass: Four,
    /// What a unit along the normal here does to the rates at the points before, 1/kg.
    pub(super) with: [Four; FOUR - 1],
    /// Inverse of the largest eigenvalue of `K_tt`, kg.
    pub(super) sliding_mass: Four,
    /// Of the present substep: along normal and tangents, N s.
    pub(super) impulse: [Four; 3],
    /// Of all substeps before, N s.
    pub(super) total: [Four; 3],
    /// Rate of separation at the start of the step, m/s.
    pub(super) rate: Four,
}

/// Where a manifold has gone.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Place {
    pub(super) batch: u32,
    pub(super) lane: u32,
}

/// Batches of a step, with the buffers from which they are made.
#[derive(Debug, Clone, Default)]
pub(super) struct Batches {
    pub(super) list: Vec<Batch>,
    pub(super) points: Vec<PointRows>,
    /// How many of the batches, the first ones, have contacts between bodies that impulses move.
    pub(super) between: usize,
    /// Where each manifold of the input has gone.
    pub(super) places: Vec<Place>,
    colours: Colours,
    /// Colour and number of points of each manifold: the place in the order.
    keys: Vec<u32>,
    order: Vec<u32>,
}

impl Batches {
    /// Puts manifolds into batches. `moves` says whether impulses move a body.
    pub(super) fn fill(&mut self, bodies: usize, manifolds: &[ImpulseManifold], moves: impl Fn(u32) -> bool) {
        self.list.clear();
        self.between = 0;
        self.points.clear();
        self.places.clear();
        self.places.resize(manifolds.len(), Place::default());
        self.sort(bodies, manifolds, &moves);
        let order = std::mem::take(&mut self.order);
        let mut open = u32::MAX;
        let mut used = FOUR;
        for &number in &order {
            let manifold = &manifolds[number as usize];
            let key = self.keys[number as usize];
            let is_alone = key / FOUR as u32 == NO_COLOUR;
            if used == FOUR || key != open || is_alone {
                (open, used) = (key, 0);
                let first = self.points.len();
                self.points.resize(first + manifold.count, PointRows::default());
                self.list.push(Batch { first: first as u32, count: manifold.count as u32, ..Batch::default() });
                if key / (FOUR as u32) < BETWEEN_MOVABLE {
                    self.between = self.list.len();
                }
            }
            self.put(number as usize, manifold, used, manifold.bodies.map(&moves));
            used += 1;
        }
        self.order = order;
    }

    /// Sorts the manifolds by colour and number of points, those of one kind as they are given.
    fn sort(&mut self, bodies: usize, manifolds: &[ImpulseManifold], moves: &impl Fn(u32) -> bool) {
        self.colours.begin(bodies);
        self.keys.clear();
        let mut counts = [0_u32; GROUPS * FOUR + 1];
        for manifold in manifolds {
            let colour = self.colours.next(manifold.bodies, manifold.bodies.map(moves));
            let key = colour * FOUR as u32 + (manifold.count.clamp(1, FOUR) - 1) as u32;
            counts[key as usize + 1] += 1;
            self.keys.push(key);
        }
        for k in 1..counts.len() {
            counts[k] += counts[k - 1];
        }
        self.order.clear();
        self.order.resize(manifolds.len(), 0);
        for (number, &key) in self.keys.iter().enumerate() {
            let place = &mut counts[key as usize];
            self.order[*place as usize] = number as u32;
            *place += 1;
        }
    }

    /// Writes a manifold into a lane of the last batch.
    fn put(&mut self, number: usize, manifold: &ImpulseManifold, lane: usize, moves: [bool; 2]) {
        let last = self.list.len() - 1;
        let batch = &mut self.list[last];
        self.places[number] = Place { batch: last as u32, lane: lane as u32 };
        [batch.a[lane], batch.b[lane]] = manifold.bodies;
        put_vector(&mut batch.normal, lane, manifold.normal.to_array());
        put_vector(&mut batch.tangent, lane, manifold.tangent.to_array());
        put_vector(&mut batch.between, lane, manifold.between.to_array());
        let center = center_of(manifold);
        put_vector(&mut batch.arm, lane, center.to_array());
        let axes = [manifold.tangent, manifold.normal.cross(manifold.tangent)];
        batch.friction.0[lane] = manifold.friction;
        batch.restitution.0[lane] = manifold.restitution;
        batch.side.0[lane] = f64::from(moves[0]) - f64::from(moves[1]);
        let rows = &mut self.points[batch.first as usize..];
        for (row, point) in rows.iter_mut().zip(&manifold.points[..manifold.count]) {
            let ManifoldPoint { arm, separation, impulse } = *point;
            for (place, axis) in row.place.iter_mut().zip(axes) {
                place.0[lane] = axis.dot(arm - center);
            }
            put_vector(&mut row.impulse, lane, impulse);
            (row.separation.0[lane], row.present.0[lane]) = (separation, separation);
        }
    }
}

/// The centre of a patch: the mean of its arms, at the height of the point with the least separation.
fn center_of(manifold: &ImpulseManifold) -> DVec3 {
    let points = &manifold.points[..manifold.count];
    let Some(first) = points.first() else { return DVec3::ZERO };
    if points.len() == 1 {
        return first.arm;
    }
    let lowest = points.iter().fold(first, |low, point| if point.separation < low.separation { point } else { low });
    let mean = points.iter().map(|point| point.arm - lowest.arm).sum::<DVec3>() / points.len() as f64;
    lowest.arm + (mean - manifold.normal * manifold.normal.dot(mean))
}

fn put_vector(to: &mut [Four; 3], lane: usize, from: [f64; 3]) {
    for (four, value) in to.iter_mut().zip(from) {
        four.0[lane] = value;
    }
}

//! Limit analysis: how far a structure of bodies in contact is from moving.
//!
//! A structure can stand as long as forces within the cones of friction balance its loads (the lower bound theorem).
//! With `a_0` the accelerations of the bodies without contact forces, `J` the rows of contacts, and `m` a part of all
//! coefficients:
//!
//! ```text
//! M^-1 J^T f + a_0 + l a_1 = 0,     |f_t| <= m mu f_n   at every contact
//! ```
//!
//! - **Loads.** For `m = 1` the largest `l` for which there are such forces is one convex programme over second-order
//!   cones. Its multipliers are the velocities of the bodies in the motion that then begins (the mechanism).
//! - **Friction.** For `l = 0` the least `m` is sought: the value of the programme that minimises the part `t` of its
//!   scale by which every contact misses its cone, `|f_t| <= m mu f_n + t`, falls with `m`, and its slope is known from
//!   the multipliers; Newton's method for its zero, kept between what misses and what does not, takes a few programmes.
//!   `1 - m` is the reserve of friction, and the forces found have all of it.
//!
//! - **Collapse.** Where no forces in the cones hold it, the multipliers that show it (of Farkas' lemma) are a motion
//!   in which no contact closes and the loads do work: one that begins.
//!
//! Symbols: `f` (N), `J` (no unit), `M` (kg), `a` (m/s^2), `l`, `m`, `mu`, `t` (no unit). Sources: Heyman 1966;
//! Livesley 1978 (limit analysis as a programme); Whiting 2009 (how far a structure is from standing). Assumption:
//! forces in the cones are enough. With friction a structure that can stand may still move when something starts it, so
//! that `l` is an upper bound of what it bears when it is disturbed (Livesley 1978). Rolling and spinning friction are
//! left out, contacts that slide too. Failure: none where no forces balance the loads, or the interior point finds
//! none.

#[cfg(feature = "census")]
use crate::census::{self, Chain, Size};
use crate::dense::kernels::largest;
use crate::error::{ResponseError, check_finite, check_length};
use crate::friction::blocks::Blocks;
use crate::interior_point::ANSWER_ERROR;
use crate::interior_point::{ConeProgramme, ConeRows, least_cost};
use crate::law::Law;
use crate::problem::ContactProblem;
#[cfg(feature = "census")]
use crate::report::SolverStatus;

/// The largest load that is looked for, and the largest part of the coefficients of friction, as a multiple (no unit,
/// 1e2 to 1e6): a structure that bears more is wedged, one that needs more cannot stand.
pub const MOST_FACTOR: f64 = 1e3;

/// Two parts of friction this close to each other are one (no unit, 1e-7 to 1e-5), relative: what is missed in between
/// is then well above the tolerance of the interior point.
const SAME_PART: f64 = 1e-6;

/// Programmes for one part of friction (10 to 60).
const MOST_PROGRAMMES: usize = 60;

/// Least size of the forces on a body, as a part of the largest on any (no unit): bodies on which no force acts must
/// not divide by zero.
const LEAST_SIZE: f64 = 1e-12;

/// How far a structure is from moving.
#[derive(Debug, Clone, PartialEq)]
pub struct Limit {
    /// The load that it bears, or the part of friction that it needs (no unit).
    pub factor: f64,
    /// Generalised velocities of the bodies in the motion that begins there, in blocks of the problem's width, up to a
    /// common factor: that of the greatest is 1 m/s or 1 rad/s. Zero where nothing begins to move.
    pub mechanism: Vec<f64>,
    /// Forces of all rows that balance there, N, to the tolerance of the interior point. Contacts that bear nothing
    /// have zero.
    pub forces: Vec<f64>,
}

/// A structure under loads.
#[derive(Debug, Clone)]
pub struct Structure<'a> {
    problem: &'a ContactProblem,
    blocks: &'a Blocks,
    /// `a_0`.
    free: &'a [f64],
    /// The force of each row of the blocks that counts as one, N.
    units: Vec<f64>,
}

impl<'a> Structure<'a> {
    /// Bodies whose accelerations without contact forces are `free` (m/s^2 and rad/s^2, in blocks of the problem's
    /// width). `near` (N, of all rows) are forces of the size of those sought: they need not balance anything.
    ///
    /// # Errors
    /// When a length differs, a row does not exist, or a number is not finite.
    pub fn new(
        problem: &'a ContactProblem,
        blocks: &'a Blocks,
        free: &'a [f64],
        near: &[f64],
    ) -> Result<Self, ResponseError> {
        check_length("accelerations of bodies", problem.bodies() * problem.width(), free.len())?;
        check_finite("accelerations of bodies", free)?;
        check_length("forces", problem.len(), near.len())?;
        check_finite("forces", near)?;
        if let Some(&row) = blocks.rows().iter().find(|&&row| row >= problem.len()) {
            return Err(ResponseError::UnknownRow { row, rows: problem.len() });
        }
        let units = units_of_forces(problem, blocks, free, near);
        Ok(Self { problem, blocks, free, units })
    }

    /// The largest part of the loads `live` (accelerations that they would give, as `free`) that it bears beside its
    /// own, up to [`MOST_FACTOR`]; none where it does not bear its own.
    ///
    /// ```
    /// use polhode_response::friction::Structure;
    /// use polhode_response::{Blocks, ContactProblem, Law};
    /// // A point of 2 kg on a floor of friction 0.5 under 10 m/s^2: half its weight along the floor moves it.
    /// let mut problem = ContactProblem::new(2, vec![0.5, 0.0, 0.0, 0.5])?;
    /// problem.push_row(&[(0, &[0.0, 1.0])])?;
    /// problem.push_held_row(&[(0, &[1.0, 0.0])])?;
    /// let mut blocks = Blocks::default();
    /// blocks.push(Law::Cone { rows: 2, friction: 0.5 }, [0, 1]);
    /// let structure = Structure::new(&problem, &blocks, &[0.0, -10.0], &[20.0, 0.0])?;
    /// let limit = structure.load_limit(&[10.0, 0.0])?.ok_or("it stands")?;
    /// assert!((limit.factor - 0.5).abs() < 1e-9);
    /// assert!((limit.mechanism[0] - 1.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When `live` has another length, or a number is not finite.
    #[cfg_attr(feature = "census", track_caller)]
    pub fn load_limit(&self, live: &[f64]) -> Result<Option<Limit>, ResponseError> {
        check_length("loads", self.free.len(), live.len())?;
        check_finite("loads", live)?;
        let Some(mut programme) = self.programme(1.0, Share::OfLoad(live)) else { return Ok(None) };
        // The load is bounded, so that there is a largest one.
        let load = self.units.len();
        programme.push(ConeRows::Nonnegative(1), &[(load, -1.0)], MOST_FACTOR);
        let found = self.solved(&programme, -1.0).map(|solved| self.limit(solved.last, &solved));
        #[cfg(feature = "census")]
        self.counted("load limit", found.is_some());
        Ok(found)
    }

    /// The least part of the coefficients of friction with which it stands, above 1 where they are too small, up to
    /// [`MOST_FACTOR`]; none where friction does not hold it. The forces are those of the greatest reserve.
    ///
    /// # Errors
    /// None so far.
    #[cfg_attr(feature = "census", track_caller)]
    pub fn friction_limit(&self) -> Result<Option<Limit>, ResponseError> {
        let found = self.least_friction();
        #[cfg(feature = "census")]
        self.counted("friction limit", found.is_some());
        Ok(found)
    }

    /// The motion that begins where no forces within the cones hold it: the factor is 1, and no forces are told. None
    /// where it stands, or the interior point finds none.
    ///
    /// # Errors
    /// None so far.
    #[cfg_attr(feature = "census", track_caller)]
    pub fn collapse(&self) -> Result<Option<Limit>, ResponseError> {
        let nothing = vec![0.0; self.free.len()];
        let Some(mut programme) = self.programme(1.0, Share::OfLoad(&nothing)) else { return Ok(None) };
        let last = self.units.len();
        programme.push(ConeRows::Nonnegative(1), &[(last, -1.0)], MOST_FACTOR);
        let gradient = vec![0.0; last + 1];
        let answer = least_cost(&gradient, &programme.entries, &programme.constant, &programme.cones);
        let found = match answer {
            ConeProgramme::Infeasible { multipliers, .. } => {
                let balance: Vec<f64> =
                    multipliers[..self.free.len()].iter().zip(&programme.sizes).map(|(z, size)| z / size).collect();
                // The loads do work in the motion that begins: its sense is that in which `-z . a_0` is positive.
                let work: f64 = balance.iter().zip(self.free).map(|(z, free)| -z * free).sum();
                let balance = balance.iter().map(|z| z * work.signum()).collect();
                let solved = Solved { last: 0.0, balance, slope: 0.0, parts: vec![0.0; last] };
                Some(Limit { factor: 1.0, mechanism: self.mechanism(&solved), forces: vec![0.0; self.problem.len()] })
            }
            _ => None,
        };
        #[cfg(feature = "census")]
        self.counted("collapse", found.is_some());
        Ok(found)
    }

    /// Tells the census of a limit that was sought.
    #[cfg(feature = "census")]
    #[track_caller]
    fn counted(&self, what: &'static str, is_found: bool) {
        let size = Size { bodies: self.problem.bodies(), rows: self.problem.len(), cones: self.blocks.len() };
        let status = if is_found { SolverStatus::Solved } else { SolverStatus::Infeasible };
        census::note_single(Chain::Limit, size, what, status, 0.0);
    }

    fn least_friction(&self) -> Option<Limit> {
        let without = self.missed(0.0)?;
        if without.last <= ANSWER_ERROR {
            let mechanism = vec![0.0; self.free.len()];
            return Some(Limit { mechanism, ..self.limit(0.0, &without) });
        }
        let mut search = Search { below: (0.0, without), above: None, is_slow: false };
        for _ in 0..MOST_PROGRAMMES {
            let Some(tried) = search.next() else { break };
            if tried > MOST_FACTOR {
                return None;
            }
            let found = self.missed(tried)?;
            search.take(tried, found);
        }
        let Search { below: (_, misses), above: Some((factor, found)), .. } = search else { return None };
        Some(Limit { mechanism: self.mechanism(&misses), ..self.limit(factor, &found) })
    }

    /// What misses the cones of this part of friction.
    fn missed(&self, part: f64) -> Option<Solved> {
        let mut programme = self.programme(part, Share::OfMiss)?;
        programme.push(ConeRows::Nonnegative(1), &[(self.units.len(), 1.0)], 0.0);
        self.solved(&programme, 1.0)
    }

    /// Balance and cones; none where a contact slides.
    fn programme(&self, part: f64, share: Share<'_>) -> Option<Programme> {
        let (width, last) = (self.problem.width(), self.units.len());
        let mut lines: Vec<Vec<(usize, f64)>> = vec![Vec::new(); self.free.len()];
        let scales = self.blocks.scales();
        for (column, ((&row, unit), scale)) in self.blocks.rows().iter().zip(&self.units).zip(scales).enumerate() {
            for entry in self.problem.entries(row) {
                for (component, value) in entry.response.iter().enumerate().filter(|(_, value)| **value != 0.0) {
                    lines[entry.body * width + component].push((column, value * unit * scale));
                }
            }
        }
        let mut programme = Programme::default();
        for (number, line) in lines.iter_mut().enumerate() {
            if let Share::OfLoad(live) = share
                && live[number] != 0.0
            {
                line.push((last, live[number]));
            }
            let size = line.iter().fold(0.0, |most: f64, (_, value)| most.max(value.abs()));
            let size = if size > 0.0 { size } else { 1.0 };
            for (_, value) in line.iter_mut() {
                *value /= size;
            }
            programme.sizes.push(size);
            programme.push(ConeRows::Zero(1), line, self.free[number] / size);
        }
        let mut first = 0;
        for law in self.blocks.laws() {
            if !programme.push_cone(*law, first, part, matches!(share, Share::OfMiss).then_some(last)) {
                return None;
            }
            first += law.rows();
        }
        programme.merge();
        Some(programme)
    }

    /// The programme with this cost of the last variable.
    fn solved(&self, programme: &Programme, cost: f64) -> Option<Solved> {
        let last = self.units.len();
        let mut gradient = vec![0.0; last + 1];
        gradient[last] = cost;
        let found = least_cost(&gradient, &programme.entries, &programme.constant, &programme.cones);
        let ConeProgramme::Solved { point, multipliers, .. } = found else { return None };
        let weight = |&(row, column, friction): &(usize, usize, f64)| multipliers[row] * friction * point[column];
        let balance = multipliers[..self.free.len()].iter().zip(&programme.sizes).map(|(z, size)| z / size).collect();
        let slope = programme.frictions.iter().map(weight).sum();
        Some(Solved { last: point[last], balance, slope, parts: point[..last].to_vec() })
    }

    fn limit(&self, factor: f64, solved: &Solved) -> Limit {
        let mut forces = vec![0.0; self.problem.len()];
        let mut parts = solved.parts.clone();
        unload(&mut parts, self.blocks);
        let sizes = self.units.iter().zip(self.blocks.scales());
        for ((&row, part), (unit, scale)) in self.blocks.rows().iter().zip(&parts).zip(sizes) {
            forces[row] = part * unit * scale;
        }
        Limit { factor, mechanism: self.mechanism(solved), forces }
    }

    /// The multipliers of the balance as velocities of the bodies: balance is stated in accelerations, `M^-1` times
    /// forces.
    fn mechanism(&self, solved: &Solved) -> Vec<f64> {
        let width = self.problem.width();
        let mut velocities = Vec::with_capacity(solved.balance.len());
        for (body, own) in solved.balance.chunks_exact(width).enumerate() {
            for line in self.problem.inverse_mass(body).chunks_exact(width) {
                velocities.push(-line.iter().zip(own).map(|(entry, z)| entry * z).sum::<f64>());
            }
        }
        let most = largest(&velocities);
        if most > 0.0 {
            for velocity in &mut velocities {
                *velocity /= most;
            }
        }
        velocities
    }
}

/// What the last variable of a programme is.
#[derive(Debug, Clone, Copy)]
enum Share<'a> {
    /// The part of these loads.
    OfLoad(&'a [f64]),
    /// By how much every contact misses its cone.
    OfMiss,
}

/// A minimum.
#[derive(Debug)]
struct Solved {
    /// The last variable.
    last: f64,
    /// By how much that falls with the part of friction.
    slope: f64,
    /// Multipliers of the balance of every coordinate of every body.
    balance: Vec<f64>,
    /// Forces, in their units.
    parts: Vec<f64>,
}

/// The search for the least part of friction with which nothing misses its cone.
#[derive(Debug)]
struct Search {
    /// A part with which something does.
    below: (f64, Solved),
    /// One with which nothing does.
    above: Option<(f64, Solved)>,
    /// Whether the last step of Newton's method left more than half of the interval.
    is_slow: bool,
}

impl Search {
    /// The part to try next; none when both sides are one.
    fn next(&self) -> Option<f64> {
        let (below, misses) = &self.below;
        let newton = below + misses.last / misses.slope;
        // Where the method has come to its end from below a little more shows that it is the end.
        let further = newton.max(below * (1.0 + 0.5 * SAME_PART));
        let Some((above, _)) = &self.above else {
            // Written so that NaN does not count as inside. Friction that does not help yet may do so later, all at
            // once.
            let is_inside = further > *below && further <= MOST_FACTOR;
            return Some(if is_inside { further } else { (2.0 * below).max(1.0) });
        };
        if above - below <= SAME_PART * above {
            return None;
        }
        let nearer = further.min(above * (1.0 - 0.5 * SAME_PART));
        Some(if nearer > *below && !self.is_slow { nearer } else { 0.5 * (below + above) })
    }

    fn take(&mut self, tried: f64, found: Solved) {
        let width = |search: &Self| search.above.as_ref().map(|(above, _)| above - search.below.0);
        let before = width(self);
        if found.last <= ANSWER_ERROR {
            self.above = Some((tried, found));
        } else {
            self.below = (tried, found);
        }
        let is_slow = before.zip(width(self)).is_some_and(|(before, now)| now > 0.5 * before);
        // Every second step halves the interval, where the others do not.
        self.is_slow = is_slow && !self.is_slow;
    }
}

/// The rows of a cone programme.
#[derive(Debug, Default)]
struct Programme {
    /// Row, column and value.
    entries: Vec<(usize, usize, f64)>,
    constant: Vec<f64>,
    cones: Vec<ConeRows>,
    /// What each line of the balance was divided by.
    sizes: Vec<f64>,
    /// Row and column of the normal force of each contact with friction, and its coefficient.
    frictions: Vec<(usize, usize, f64)>,
}

impl Programme {
    /// One more row, in a cone of its own.
    fn push(&mut self, cone: ConeRows, line: &[(usize, f64)], constant: f64) {
        let row = self.constant.len();
        self.entries.extend(line.iter().map(|&(column, value)| (row, column, value)));
        self.constant.push(constant);
        self.cones.push(cone);
    }

    /// Asks a block, whose columns begin at `first`, to keep to its cone, or to miss it by the variable `missed` at the
    /// most. Whether it can: what slides has none.
    fn push_cone(&mut self, law: Law, first: usize, part: f64, missed: Option<usize>) -> bool {
        match law {
            Law::Hold { .. } => {}
            Law::Slide { .. } | Law::Resist { .. } => return false,
            Law::Cone { rows, friction } if rows > 1 && friction > 0.0 => {
                // Only a cone that may be missed, or one without friction, leaves the sign of its normal force open.
                if missed.is_some() {
                    self.push(ConeRows::Nonnegative(1), &[(first, 1.0)], 0.0);
                }
                self.frictions.push((self.constant.len(), first, friction));
                let normal = [(first, part * friction)];
                let line: Vec<(usize, f64)> = normal.into_iter().chain(missed.map(|missed| (missed, 1.0))).collect();
                self.push(ConeRows::SecondOrder(rows), &line, 0.0);
                for column in first + 1..first + rows {
                    self.entries.push((self.constant.len(), column, 1.0));
                    self.constant.push(0.0);
                }
            }
            Law::Push | Law::Cone { .. } => {
                self.push(ConeRows::Nonnegative(1), &[(first, 1.0)], 0.0);
                for column in first + 1..first + law.rows() {
                    self.push(ConeRows::Zero(1), &[(column, 1.0)], 0.0);
                }
            }
        }
        true
    }

    /// Neighbouring rows of one kind in one cone.
    fn merge(&mut self) {
        let mut merged: Vec<ConeRows> = Vec::with_capacity(self.cones.len());
        for cone in &self.cones {
            match (merged.last_mut(), *cone) {
                (Some(ConeRows::Zero(before)), ConeRows::Zero(rows))
                | (Some(ConeRows::Nonnegative(before)), ConeRows::Nonnegative(rows)) => *before += rows,
                (_, cone) => merged.push(cone),
            }
        }
        self.cones = merged;
    }
}

/// For each row of the blocks the sum of the forces on the lighter loaded of its bodies, N; where `near` has none the
/// force that gives one of them the largest acceleration of any.
fn units_of_forces(problem: &ContactProblem, blocks: &Blocks, free: &[f64], near: &[f64]) -> Vec<f64> {
    let mut loads = vec![0.0; problem.bodies()];
    for (row, force) in near.iter().enumerate() {
        for entry in problem.entries(row) {
            loads[entry.body] += force.abs();
        }
    }
    let least = LEAST_SIZE * largest(&loads);
    let acceleration = largest(free);
    let unit = |&row: &usize| {
        let on_lighter = problem.entries(row).map(|entry| loads[entry.body]).fold(f64::INFINITY, f64::min);
        if on_lighter.is_finite() && on_lighter > least {
            return on_lighter;
        }
        let response = problem.entries(row).map(|entry| largest(entry.response)).fold(0.0, f64::max);
        if response > 0.0 && acceleration > 0.0 { acceleration / response } else { 1.0 }
    };
    blocks.rows().iter().map(unit).collect()
}

/// Takes what bears nothing to the tolerance of the interior point out of forces in their units, in the order of the
/// blocks.
fn unload(parts: &mut [f64], blocks: &Blocks) {
    let mut first = 0;
    for law in blocks.laws() {
        let own = &mut parts[first..first + law.rows()];
        if matches!(law, Law::Push | Law::Cone { .. }) && own[0] <= ANSWER_ERROR {
            own.fill(0.0);
        }
        first += law.rows();
    }
}

#[cfg(test)]
mod tests {
    //! Closed forms: a body on a slope, one that slides or tips under a push, a wedge; and the motion in which each
    //! begins.
    #![expect(clippy::unwrap_used, reason = "a failed step fails the test")]
    use super::*;

    const GRAVITY: f64 = 9.81;
    const EXACT: f64 = 1e-8;
    /// Close to where friction jams a body the forces go to infinity, and the interior point is less exact.
    const JAMMED: f64 = 1e-5;

    /// A box of unit mass in a vertical plane (x, z, turn), on a floor at its two lower corners.
    struct Box2 {
        problem: ContactProblem,
        blocks: Blocks,
    }

    impl Box2 {
        fn new(width: f64, height: f64, friction: f64) -> Self {
            let inertia = (width * width + height * height) / 12.0;
            let mut problem =
                ContactProblem::new(3, vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 / inertia]).unwrap();
            let mut blocks = Blocks::default();
            for x in [-0.5 * width, 0.5 * width] {
                let first = problem.len();
                problem.push_row(&[(0, &[0.0, 1.0, x])]).unwrap();
                problem.push_held_row(&[(0, &[1.0, 0.0, 0.5 * height])]).unwrap();
                blocks.push(Law::Cone { rows: 2, friction }, [first, first + 1]);
            }
            Self { problem, blocks }
        }

        /// Under gravity on a slope of this tangent.
        fn limits(&self, tangent: f64) -> (Option<Limit>, Option<Limit>) {
            let free = [tangent * GRAVITY, -GRAVITY, 0.0];
            let structure = Structure::new(&self.problem, &self.blocks, &free, &[GRAVITY; 4]).unwrap();
            (structure.load_limit(&[GRAVITY, 0.0, 0.0]).unwrap(), structure.friction_limit().unwrap())
        }
    }

    /// A low box slides when the push is the friction, a slender one tips over its edge when it is its width over its
    /// height.
    #[test]
    fn a_box_slides_or_tips() {
        for (width, height, friction, expected) in [(2.0, 1.0, 0.5, 0.5), (1.0, 4.0, 0.5, 0.25)] {
            let limit = Box2::new(width, height, friction).limits(0.0).0.unwrap();
            assert!((limit.factor - expected).abs() < EXACT, "{}", limit.factor);
            let [x, z, turn] = limit.mechanism[..] else { panic!("three coordinates") };
            assert!(x > 0.0, "{x}");
            // About the edge at (w/2, 0): x = turn h/2 to the right (turn against the positive sense here), z = turn
            // w/2.
            if expected < friction {
                assert!((x / turn.abs() - 0.5 * height).abs() < 1e-6 && (z / turn.abs() - 0.5 * width).abs() < 1e-6);
            } else {
                assert!(turn.abs() < 1e-6, "{turn}");
            }
        }
    }

    /// On a slope of tangent 0.3 friction of 0.5 may fall to 0.6 of itself; friction of 0.2 would have to be half as
    /// large again; on the level none is needed, and where the box tips none is enough.
    #[test]
    fn friction_that_a_slope_needs() {
        let part = |box2: Box2, tangent: f64| box2.limits(tangent).1.map(|limit| limit.factor);
        assert!((part(Box2::new(1.0, 1.0, 0.5), 0.3).unwrap() - 0.6).abs() < EXACT);
        assert!((part(Box2::new(1.0, 1.0, 0.2), 0.3).unwrap() - 1.5).abs() < EXACT);
        assert_eq!(part(Box2::new(1.0, 1.0, 0.5), 0.0), Some(0.0));
        assert_eq!(part(Box2::new(1.0, 4.0, 0.5), 0.3), None);
    }

    /// A wedge of half angle `a` between two walls stands from friction `tan a` on, and no push along the floor moves
    /// it.
    #[test]
    fn a_wedge_needs_the_tangent_of_its_angle() {
        let (s, c) = (libm::sin(0.2), libm::cos(0.2));
        let mut problem = ContactProblem::new(2, vec![1.0, 0.0, 0.0, 1.0]).unwrap();
        let mut blocks = Blocks::default();
        for side in [1.0, -1.0] {
            let first = problem.len();
            problem.push_row(&[(0, &[side * c, -s])]).unwrap();
            problem.push_held_row(&[(0, &[s, side * c])]).unwrap();
            blocks.push(Law::Cone { rows: 2, friction: 0.4 }, [first, first + 1]);
        }
        let structure = Structure::new(&problem, &blocks, &[0.0, -GRAVITY], &[GRAVITY; 4]).unwrap();
        let limit = structure.friction_limit().unwrap().unwrap();
        assert!((0.4 * limit.factor / (s / c) - 1.0).abs() < JAMMED, "{}", limit.factor);
        let pushed = structure.load_limit(&[GRAVITY, 0.0]).unwrap().unwrap();
        assert!((pushed.factor - MOST_FACTOR).abs() < 1e-3, "{}", pushed.factor);
    }
}

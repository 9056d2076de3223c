//! Separation of two elements at a common normal (where it is stationary), and its first two time derivatives.
//!
//! `chi = n.F - rho_A - rho_B` with `F = x_A - x_B` between points of the two loci (`element.rs`), `rho` the radii of
//! the balls, and `x` a function of the parameters `z` of its locus (arc length on a line or circle, the height on a
//! cone's axis). At a common normal chi is stationary with respect to the normal and to all parameters: `F = (n.F) n`,
//! `n.dx/dz` constant. Hence, with `v(x)` the velocity of the material point at `x`,
//!
//! `chi' = n.(v_A(x_A) - v_B(x_B))`,
//! `chi'' = n.(a_A(x_A) - a_B(x_B)) + n'.(v_A(x_A) - v_B(x_B)) + sum_i s_i z_i' n.(w_i x t_i)`,
//!
//! `a(x)` the acceleration of the material point, `t_i = dx/dz_i`, `s_i = +1` on A and `-1` on B. The rates follow from
//! the stationarity conditions, differentiated: along two vectors `T` perpendicular to n
//!
//! `T.((n.F) n' - v_A(x_A) + v_B(x_B) - sum_i s_i t_i z_i') = 0`,  `n'.t_i + n.(w_i x t_i) + n.k_i z_i' = 0`,
//!
//! `k_i = d2x/dz_i^2` (a circle's only). The system is regular at `chi = 0` wherever the contact is not degenerate. It
//! contains a point on a surface and crossed edges (thesis 3.4, equation (18) with erratum E18) as special cases, and
//! is exact at any separation.
//!
//! If the locus of body E is a plane, the normal is the plane's: `n' = w_E x n`, whatever the other locus is. The two
//! parameters of the plane follow from the first condition, and the remaining formula has no divisor that vanishes at
//! touch:
//!
//! `chi'' = n.(a_A - a_B) + 2 n'.(v_A - v_B) - (n.F) n'.n' - s (n'.t + n.(w x t))^2 / n.k`,
//!
//! where the last term exists only for a circle on the plane (`s`, `w`, `t` and `k` are the circle's).
//!
//! The contact point is at the distance `rho_A + chi/2` from `x_A` along `-n` (or off `x_B` by `rho_B + chi/2` along
//! `n`), and moves with `x_A' = v_A(x_A) + t_A z_A'`, `n'`, `chi'` and, as chi is stationary with respect to `z_A`,
//! `rho_A' = n.t_A z_A'` (zero except on a cone).

use crate::clearance::COINCIDENCE;
use crate::narrow_phase::common_normal::branch_offset;
use crate::narrow_phase::common_normal::chosen_place::{chosen, margin};
use crate::narrow_phase::common_normal::place::Place;
use crate::narrow_phase::common_normal::places::places;
use crate::narrow_phase::feature::element::{Element, Locus};
use crate::narrow_phase::terms::tangential::ContactMotion;
use crate::{ContactGeometry, ContactKinematics, Side};
use glam::DVec3;
use polhode_spatial::Velocity;
use polhode_spatial::rounding;

/// Most unknowns of the linear system: two components of the normal's rate and up to two parameters.
const MOST: usize = 4;

/// A parameter of the point on one body's locus.
#[derive(Debug, Clone, Copy)]
struct Parameter {
    of: Side,
    /// `dx/dz`.
    along: DVec3,
    /// `d2x/dz2`, 1/m.
    bend: DVec3,
}

/// A common normal of an element of A and one of B, both relative to A's centre of mass.
#[derive(Debug)]
pub(crate) struct Stationary {
    place: Place,
    separation: f64,
    /// From A's centre of mass to the middle of the gap.
    middle: DVec3,
    margin: f64,
    /// Centre of mass of B, relative to A's.
    origin_b: DVec3,
    /// Length scale of the pair: the place tolerance over [`COINCIDENCE`], m.
    size: f64,
    /// The body whose element is a plane.
    plane_of: Option<Side>,
    parameters: [Parameter; 2],
    count: usize,
}

impl Stationary {
    /// The common normal at which two elements touch, or nearly touch. None when they have none, or when the normal is
    /// not unique (points nearer to each other than `tolerance`, m): then it has no finite rate.
    pub(crate) fn new(a: &Element<'_>, b: &Element<'_>, origin_b: DVec3, tolerance: f64) -> Option<Self> {
        let all = places(a, b);
        let place = chosen(&all, a, b)?;
        if has_no_direction(&place, a, b, tolerance) {
            return None;
        }
        let separation = place.separation(a, b);
        let mut stationary = Self {
            place,
            separation,
            middle: place.on_a - place.normal * (a.radius_at(place.on_a) + 0.5 * separation),
            margin: margin(&place, a, b).min(branch_offset::margin(&place, &all, a, b)),
            origin_b,
            size: tolerance / COINCIDENCE,
            plane_of: None,
            parameters: [Parameter { of: Side::A, along: DVec3::ZERO, bend: DVec3::ZERO }; 2],
            count: 0,
        };
        stationary.describe(Side::A, a, place.on_a);
        stationary.describe(Side::B, b, place.on_b);
        stationary.turns_steadily().then_some(stationary)
    }

    /// Lists the parameters of an element at a point of its locus.
    fn describe(&mut self, of: Side, element: &Element<'_>, place: DVec3) {
        let mut push = |along: DVec3, bend: DVec3| {
            if let Some(free) = self.parameters.get_mut(self.count) {
                *free = Parameter { of, along, bend };
                self.count += 1;
            }
        };
        match element.locus {
            Locus::Point(_) => {}
            Locus::Line(_, along) => push(along, DVec3::ZERO),
            Locus::Cone(side) => push(side.axis, DVec3::ZERO),
            Locus::Circle(circle) => {
                let out = (place - circle.center) / circle.radius;
                push(circle.axis.cross(out), -out / circle.radius);
            }
            Locus::Plane(..) => self.plane_of = Some(of),
        }
    }

    /// `origin_a` is A's centre of mass in the world.
    pub(crate) fn geometry(&self, origin_a: DVec3) -> ContactGeometry {
        ContactGeometry {
            point: origin_a + self.middle,
            normal: self.place.normal,
            separation: self.separation,
            margin: self.margin,
        }
    }

    /// Never none, because [`Self::new`] has checked that the rates exist.
    #[inline]
    pub(crate) fn kinematics(&self, origin_a: DVec3, a: &Velocity, b: &Velocity) -> Option<ContactKinematics> {
        let n = self.place.normal;
        let [arm_a, arm_b] = self.place_arms();
        let velocity = self.relative_velocity(a, b);
        let bending = match self.plane_of {
            Some(plane) => self.bending_over_plane(plane, velocity, a, b),
            None => self.bending(&self.rates(velocity, a, b)?, velocity, a, b),
        };
        let centripetal = a.angular.cross(a.angular.cross(arm_a)) - b.angular.cross(b.angular.cross(arm_b));
        Some(ContactKinematics {
            geometry: self.geometry(origin_a),
            separation_rate: n.dot(velocity),
            acceleration_bias: n.dot(centripetal) + bending,
        })
    }

    /// `v_A(x_A) - v_B(x_B)`.
    #[inline]
    fn relative_velocity(&self, a: &Velocity, b: &Velocity) -> DVec3 {
        let [arm_a, arm_b] = self.place_arms();
        (a.linear - b.linear) + (a.angular.cross(arm_a) - b.angular.cross(arm_b))
    }

    /// From the centres of mass to the points on the two loci.
    #[inline]
    fn place_arms(&self) -> [DVec3; 2] {
        [self.place.on_a, self.place.on_b - self.origin_b]
    }

    /// The rates of the contact point and of the normal. The contact point is a point `x` of one locus plus a length
    /// along the normal; its rate is the sum of the rates of `x`, of the normal and of the length. `x` is A's point, or
    /// B's when A's locus is a plane, whose parameters are not unknowns of the system.
    pub(crate) fn motion(&self, kinematics: &ContactKinematics, a: &Velocity, b: &Velocity) -> Option<ContactMotion> {
        let n = self.place.normal;
        let rates = match self.plane_of {
            Some(plane) => self.rates_over_plane(plane, a, b),
            None => self.rates(self.relative_velocity(a, b), a, b)?,
        };
        let from = if self.plane_of == Some(Side::A) { Side::B } else { Side::A };
        let [place_a, place_b] = self.place_arms();
        let (velocity, arm, on_locus, outwards) = match from {
            Side::A => (a, place_a, self.place.on_a, -1.0),
            Side::B => (b, place_b, self.place.on_b, 1.0),
        };
        let mut wandering = DVec3::ZERO;
        let mut growth = 0.5 * kinematics.separation_rate;
        for (parameter, rate) in self.parameters[..self.count].iter().zip(rates.parameters) {
            if parameter.of == from {
                wandering += parameter.along * rate;
                growth -= outwards * n.dot(parameter.along) * rate;
            }
        }
        // The contact point is `outwards` times the radius plus half the separation away from the place, along n.
        let stand_off = n.dot(self.middle - on_locus);
        let rate = velocity.angular.cross(arm) + wandering + rates.normal * stand_off + n * (outwards * growth);
        let approach = a.linear - b.linear;
        Some(ContactMotion {
            normal: n,
            normal_rate: rates.normal,
            arms: [self.middle, self.middle - self.origin_b],
            point_rates: match from {
                Side::A => [rate, rate + approach],
                Side::B => [rate - approach, rate],
            },
        })
    }

    /// The terms of `chi''` from the rates of the normal and of the parameters, m/s^2. `velocity` is
    /// `v_A(x_A) - v_B(x_B)`.
    #[inline]
    fn bending(&self, rates: &Rates, velocity: DVec3, a: &Velocity, b: &Velocity) -> f64 {
        let n = self.place.normal;
        let mut bending = rates.normal.dot(velocity);
        for (parameter, rate) in self.parameters[..self.count].iter().zip(rates.parameters) {
            let (sign, spin) = sign_and_spin(parameter, a, b);
            bending += sign * rate * n.dot(spin.cross(parameter.along));
        }
        bending
    }

    /// The same where one element is a plane, whose normal turns with its body. It is in closed form: at touch the
    /// linear system would divide the rounding error of the velocity by that of the separation.
    #[inline]
    fn bending_over_plane(&self, plane_of: Side, velocity: DVec3, a: &Velocity, b: &Velocity) -> f64 {
        let n = self.place.normal;
        let turning = self.turning_of_plane(plane_of, a, b);
        let apart = n.dot(self.place.on_a - self.place.on_b);
        let bend = |parameter: &Parameter| {
            let (sign, spin) = sign_and_spin(parameter, a, b);
            let curvature = n.dot(parameter.bend);
            let turned = turning.dot(parameter.along) + n.dot(spin.cross(parameter.along));
            // Where all points of the circle are equally near, the point is taken as fixed to the circle's body.
            if curvature == 0.0 { 0.0 } else { -sign * turned * turned / curvature }
        };
        let wandering: f64 = self.parameters[..self.count].iter().map(bend).sum();
        2.0 * turning.dot(velocity) - apart * turning.length_squared() + wandering
    }

    /// `n'` of a plane's normal.
    #[inline]
    fn turning_of_plane(&self, plane_of: Side, a: &Velocity, b: &Velocity) -> DVec3 {
        if plane_of == Side::A { a.angular } else { b.angular }.cross(self.place.normal)
    }

    /// `n'` and `z'` where one element is a plane.
    fn rates_over_plane(&self, plane_of: Side, a: &Velocity, b: &Velocity) -> Rates {
        let n = self.place.normal;
        let normal = self.turning_of_plane(plane_of, a, b);
        let mut parameters = [0.0; 2];
        for (rate, parameter) in parameters.iter_mut().zip(&self.parameters[..self.count]) {
            let (_, spin) = sign_and_spin(parameter, a, b);
            let curvature = n.dot(parameter.bend);
            // Where all points of the circle are equally near, the point is taken as fixed to the circle's body.
            if curvature != 0.0 {
                *rate = -(normal.dot(parameter.along) + n.dot(spin.cross(parameter.along))) / curvature;
            }
        }
        Rates { normal, parameters }
    }

    /// Whether the normal has a finite rate for every motion.
    fn turns_steadily(&self) -> bool {
        self.plane_of.is_some() || solve(self.system().matrix, [0.0; MOST], NORMAL_UNKNOWNS + self.count).is_some()
    }

    /// The matrix of the linear conditions for the rates.
    fn system(&self) -> System {
        let n = self.place.normal;
        let first = n.any_orthonormal_vector();
        let tangents = [first, n.cross(first)];
        let apart = n.dot(self.place.on_a - self.place.on_b);
        let parameters = &self.parameters[..self.count];
        let radius = |p: &Parameter| Some(p.bend.length().recip()).filter(|r| r.is_finite());
        let length = parameters.iter().filter_map(radius).fold(apart.abs().max(self.size), f64::max);
        let mut system = System { matrix: [[0.0; MOST]; MOST], tangents, length, units: [length; 2] };
        for row in 0..tangents.len() {
            system.matrix[row][row] = apart / length;
        }
        for (index, parameter) in parameters.iter().enumerate() {
            let sign = if parameter.of == Side::A { 1.0 } else { -1.0 };
            let (row, unit) = (NORMAL_UNKNOWNS + index, radius(parameter).unwrap_or(length));
            for (column, tangent) in tangents.iter().enumerate() {
                system.matrix[column][row] = -sign * tangent.dot(parameter.along) * (unit / length);
                system.matrix[row][column] = tangent.dot(parameter.along);
            }
            system.matrix[row][row] = unit * n.dot(parameter.bend);
            system.units[index] = unit;
        }
        system
    }

    /// `n'` and `z'`.
    fn rates(&self, velocity: DVec3, a: &Velocity, b: &Velocity) -> Option<Rates> {
        let System { matrix, tangents, length, units } = self.system();
        let mut right = [0.0; MOST];
        for (row, tangent) in tangents.iter().enumerate() {
            right[row] = tangent.dot(velocity);
        }
        for (index, parameter) in self.parameters[..self.count].iter().enumerate() {
            let (_, spin) = sign_and_spin(parameter, a, b);
            right[NORMAL_UNKNOWNS + index] = -length * self.place.normal.dot(spin.cross(parameter.along));
        }
        let solution = solve(matrix, right, NORMAL_UNKNOWNS + self.count)?;
        Some(Rates {
            normal: (tangents[0] * solution[0] + tangents[1] * solution[1]) / length,
            parameters: [solution[2] * (units[0] / length), solution[3] * (units[1] / length)],
        })
    }
}

/// The linear system of the rates. Rows and columns are scaled by lengths, so that all entries are dimensionless: those
/// of the normal by the longest length (the gap of two crossing lines is no scale for the rounding of the velocity),
/// those of an arc by its radius (a small rim may be far from the other element).
struct System {
    matrix: [[f64; MOST]; MOST],
    /// Two unit vectors perpendicular to the normal and to each other.
    tangents: [DVec3; 2],
    /// The scale of the normal's rows and columns, m.
    length: f64,
    /// The scales of the parameters, m.
    units: [f64; 2],
}

/// The first unknowns are the two components of the normal's rate.
const NORMAL_UNKNOWNS: usize = 2;

struct Rates {
    normal: DVec3,
    parameters: [f64; 2],
}

/// The sign and the angular velocity of a parameter's body.
fn sign_and_spin(parameter: &Parameter, a: &Velocity, b: &Velocity) -> (f64, DVec3) {
    if parameter.of == Side::A { (1.0, a.angular) } else { (-1.0, b.angular) }
}

/// Gaussian elimination with partial pivoting. A parameter whose pivot is zero to rounding has no effect, because all
/// points of its locus are equally near (a ball on the axis of a torus); its rate is set to zero. None when a pivot of
/// the normal is zero.
fn solve(mut matrix: [[f64; MOST]; MOST], mut right: [f64; MOST], size: usize) -> Option<[f64; MOST]> {
    let largest = matrix.iter().flatten().fold(0.0, |most: f64, entry| most.max(entry.abs()));
    for column in 0..size {
        let pivot = (column..size).max_by(|&i, &j| matrix[i][column].abs().total_cmp(&matrix[j][column].abs()))?;
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        let pivot = matrix[column][column];
        if pivot.is_nan() {
            return None;
        }
        if pivot.abs() <= rounding::HUNDREDS_OF_TERMS * largest {
            if column < NORMAL_UNKNOWNS {
                return None;
            }
            matrix[column] = [0.0; MOST];
            matrix[column][column] = 1.0;
            right[column] = 0.0;
            continue;
        }
        for row in column + 1..size {
            let factor = matrix[row][column] / pivot;
            for k in column..size {
                matrix[row][k] -= factor * matrix[column][k];
            }
            right[row] -= factor * right[column];
        }
    }
    let mut solution = [0.0; MOST];
    for row in (0..size).rev() {
        let known: f64 = (row + 1..size).map(|k| matrix[row][k] * solution[k]).sum();
        solution[row] = (right[row] - known) / matrix[row][row];
    }
    Some(solution)
}

/// Whether a point locus lies on another point, on a line or circle, or on the axis of a cone, where the normal is not
/// defined.
fn has_no_direction(place: &Place, a: &Element<'_>, b: &Element<'_>, tolerance: f64) -> bool {
    let point = |e: &Element<'_>| matches!(e.locus, Locus::Point(_));
    let curve = |e: &Element<'_>| matches!(e.locus, Locus::Line(..) | Locus::Circle(_) | Locus::Cone(_));
    let known = (point(a) && (point(b) || curve(b))) || (point(b) && curve(a));
    known && place.on_a.distance(place.on_b) <= tolerance
}

//! A body whose axes follow a track: its tangent, or its tangent and a direction at right angles to it.
//!
//! On the curve, at the arc length `s`, there are the frame `t`, `n = (m x t)/abs(m x t)` and `b = t x n`, where `m` is
//! a reference direction: the normal of its plane, or the direction that is up, across which the body then does not
//! lean. A direction `x` fixed in A stays at right angles to one of them, `y(s)`. With `w = w_A - w_B`, the velocity
//! `u` of the point of A along the curve, `y' = dy/ds` and a length `l`, which gives the row the unit of displacements,
//!
//! | what | formula |
//! |---|---|
//! | gap | `l x.y` |
//! | rate | `l ((x x y).w + (x.y') t.u)`: the row is a moment with a force along the track |
//! | bias | `l ((w x (w x x)).y - (x x y).(w_B x w) + 2 s' (w x x).y' + s'^2 x.y'' + (x.y') c_t)` |
//!
//! where `c_t` is the bias of the row along the track (`track.rs`). The tangent of A stays at right angles to `n` and
//! `b`, and for a whole frame the `n` of A to `b`. Where the curvature jumps the body would have to begin to turn at
//! once, by an infinite moment: such a curve is refused. Sources: do Carmo 1976, chapter 1; Featherstone 2008, chapter
//! 8. Assumption: the point is on the track, `d = 0`.

use super::end::EndKinematics;
use super::row::{BilateralRow, RowKind};
use super::track::Guide;
use crate::scene::LEAST_SINE;
use polhode_spatial::curve::CurvePoint;
use polhode_spatial::{DVec3, Rotation};

/// What of a body follows the track.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Followed {
    /// Reference direction, unit vector, in the frame of the curve.
    reference: DVec3,
    /// The frame of the curve at the start in the axes of A.
    tangent: DVec3,
    normal: DVec3,
    /// How many rows: two for the tangent, three for the frame.
    rows: usize,
}

/// A direction of the frame of the curve and its derivatives by the arc length (1, 1/m, 1/m^2).
#[derive(Debug, Clone, Copy)]
struct Direction {
    own: DVec3,
    first: DVec3,
    second: DVec3,
}

/// `n` and `b` at a place, with their derivatives.
fn frame(reference: DVec3, at: &CurvePoint) -> [Direction; 2] {
    let (t, k, rate) = (at.tangent, at.curvature, at.curvature_rate);
    let across = [reference.cross(t), reference.cross(k), reference.cross(rate)];
    let size = across[0].length().max(LEAST_SINE);
    let own = across[0] / size;
    let size_first = own.dot(across[1]);
    let first = (across[1] - own * size_first) / size;
    let size_second = first.dot(across[1]) + own.dot(across[2]);
    let second = (across[2] - first * (2.0 * size_first) - own * size_second) / size;
    let n = Direction { own, first, second };
    let b = Direction {
        own: t.cross(own),
        first: k.cross(own) + t.cross(first),
        second: rate.cross(own) + k.cross(first) * 2.0 + t.cross(second),
    };
    [n, b]
}

impl Followed {
    /// A body with this attitude at the start that follows the tangent, or the whole frame, of a track from a place.
    pub(crate) fn new(reference: DVec3, at: &CurvePoint, attitude: Rotation, rows: usize) -> Self {
        let [n, _] = frame(reference, at);
        let [tangent, normal] = [at.tangent, n.own].map(|own| attitude.inverse_rotate(own));
        Self { reference, tangent, normal, rows }
    }

    pub(crate) fn rows(&self) -> usize {
        self.rows
    }

    /// The rows; `length` is that of the joint, m.
    pub(crate) fn rows_at(
        &self,
        guide: &Guide,
        (a, b): (&EndKinematics, &EndKinematics),
        length: f64,
    ) -> impl Iterator<Item = BilateralRow> {
        let (place, along) = guide.place(a, b);
        let [n, across] = frame(self.reference, &place);
        let [tangent, normal] = [self.tangent, self.normal].map(|own| a.rotation.rotate(own));
        let pairs = [(tangent, n), (tangent, across), (normal, across)];
        let (rotation, w_b, w) = (guide.rotation(b), b.angular, a.angular - b.angular);
        let row = move |(x, y): (DVec3, Direction)| {
            let Direction { own, first, second } = y;
            let [y, first, second] = [own, first, second].map(|own| rotation.rotate(own));
            let (about, share) = (x.cross(y) * length, x.dot(first) * length);
            let turned = w.cross(x);
            let bias =
                w.cross(turned).dot(y) + 2.0 * along.rate * turned.dot(first) + along.rate * along.rate * x.dot(second);
            BilateralRow {
                kind: RowKind::Turning { along: along.direction * share, about },
                gap: length * x.dot(y),
                rate: about.dot(w) + share * along.rate,
                bias: length * bias - about.dot(w_b.cross(w)) + share * along.bias,
            }
        };
        pairs.into_iter().take(self.rows).map(row)
    }
}

//! Which of two points of a circle a contact names, where the distance from a line, a cone or another circle has two
//! local minima.
//!
//! A circle has one closest point to a given point, and one lowest point over a plane. It may touch a line, a cone or
//! another circle at two places. A contact must stay at its own while the bodies move. A signed length distinguishes
//! the two: the *offset* of the place from the border between two halves of the circle (`x` points of the circles, `c`
//! centres, `a` axes, `R` radii):
//!
//! | other locus | offset, m | at most one place on either side |
//! |---|---|---|
//! | line along e | `e.(x - c)` | always: seen along it, the halves of an ellipse beside its long axis |
//! | side of a cone, axis e | `e.(x - c)` | in each of many random cases (see below); not proved |
//! | circle, one branch, or both and the same | `(a_1 x (x_1 - c_1)).(x_2 - c_2)/R_2` | if they cross, seen along n |
//! | circle, both tori, both branches, the same | `n.((x_2 - c_2) x (x_1 - c_1))/max(R_1, R_2)` | likewise |
//! | circle, two different branches named | `(x_1 - c_1).(a_1 x a_2)` | if the planes of the circles cross |
//!
//! The random cases are in the test `a_circle_has_at_most_one_local_minimum_on_either_half`.
//!
//! A feature names one half of its circle, a *branch*, by `RimExit` or `RimEntry`; `Rim` names none. Circle 1 is the
//! circle whose branch is named. If both branches are named, it is the rim of a disc where the other is a torus (whose
//! axis has no outer side), and otherwise the first. Two rims that touch have opposite axes, `a_1 = -n`; their offset,
//! like that of two tori, does not depend on which is first. With two different branches it may: swapping A and B can
//! then exchange the names of the two places, which cannot be avoided for two equal tori that a half turn about the
//! normal exchanges. No length distinguishes the places of two circles in every configuration: the third line fails for
//! circles that are tilted about one centre, the fifth for coplanar ones. A contact of a torus uses the first offset
//! that distinguishes them ([`is_distinguished`]), and its [`margin`] is zero where its own or the other place crosses
//! the border.

use crate::clearance::ONE_PLACE;
use crate::narrow_phase::common_normal::place::Place;
use crate::narrow_phase::feature::branch::Branch;
use crate::narrow_phase::feature::element::{Element, Locus};

/// Offsets of a torus below this fraction of its radius count as zero: places on either side are equivalent. All places
/// of coaxial bodies have such offsets; the distances of two such places differ by `1e-14` of the radius.
const NEUTRAL: f64 = 1e-7;

/// A place without a branch name gets one when its offset exceeds this many times [`NEUTRAL`].
const LEFT_NEUTRAL: f64 = 2.0;

/// The offset of a place, and the radius of the circle that is named.
#[derive(Debug, Clone, Copy)]
struct Offset {
    value: f64,
    radius: f64,
}

impl Offset {
    /// None for loci that have one place only, or when no branch of two circles is named.
    fn of(place: &Place, a: &Element<'_>, b: &Element<'_>) -> Option<Self> {
        use Branch::Nearest;
        let (value, radius) = match (a.locus, b.locus) {
            (Locus::Circle(first), Locus::Circle(second)) => {
                let (arm_a, arm_b) = (place.on_a - first.center, place.on_b - second.center);
                let of_first = (first.axis.cross(arm_a).dot(arm_b) / second.radius, first.radius);
                let of_second = (second.axis.cross(arm_b).dot(arm_a) / first.radius, second.radius);
                match (a.branch, b.branch) {
                    (Nearest, Nearest) => return None,
                    (Nearest, _) => of_second,
                    (_, Nearest) => of_first,
                    (own, other) if own != other => (arm_a.dot(first.axis.cross(second.axis)), first.radius),
                    _ if a.is_ring() && b.is_ring() => {
                        let (shorter, longer) = (first.radius.min(second.radius), first.radius.max(second.radius));
                        (place.normal.dot(arm_b.cross(arm_a)) / longer, shorter)
                    }
                    _ if a.is_ring() => of_second,
                    _ => of_first,
                }
            }
            (Locus::Circle(circle), Locus::Line(_, along)) => (along.dot(place.on_a - circle.center), circle.radius),
            (Locus::Line(_, along), Locus::Circle(circle)) => (along.dot(place.on_b - circle.center), circle.radius),
            (Locus::Circle(circle), Locus::Cone(side)) => (side.axis.dot(place.on_a - circle.center), circle.radius),
            (Locus::Cone(side), Locus::Circle(circle)) => (side.axis.dot(place.on_b - circle.center), circle.radius),
            _ => return None,
        };
        Some(Self { value, radius })
    }

    /// Signed distance from the border into the named half, m.
    fn within(self, named: Branch) -> f64 {
        if named == Branch::Entry { -self.value } else { self.value }
    }
}

fn named(a: &Element<'_>, b: &Element<'_>) -> Branch {
    if a.branch == Branch::Nearest { b.branch } else { a.branch }
}

fn of_ring(a: &Element<'_>, b: &Element<'_>) -> bool {
    a.is_ring() || b.is_ring()
}

/// Whether a place lies on the branch that the elements name.
pub(crate) fn is_named(place: &Place, a: &Element<'_>, b: &Element<'_>) -> bool {
    let Some(offset) = Offset::of(place, a, b) else { return true };
    let neutral = if of_ring(a, b) { NEUTRAL * offset.radius } else { 0.0 };
    match named(a, b) {
        Branch::Nearest => true,
        Branch::Exit => offset.value >= -neutral,
        Branch::Entry => offset.value < neutral,
    }
}

/// Whether two places of a circle of this radius (m) are the same.
pub(crate) fn is_one_place(place: &Place, other: &Place, radius: f64) -> bool {
    place.on_a.distance(other.on_a) <= ONE_PLACE * radius
}

/// The offsets of the other places of two circles. Lines and cones have only one minimum on either side.
fn others(place: &Place, all: &[Place], a: &Element<'_>, b: &Element<'_>) -> impl Iterator<Item = Offset> {
    let circles = matches!((a.locus, b.locus), (Locus::Circle(_), Locus::Circle(_)));
    all.iter().filter(move |_| circles).filter_map(move |other| {
        let offset = Offset::of(other, a, b)?;
        (!is_one_place(place, other, offset.radius)).then_some(offset)
    })
}

/// Whether the branch names of the elements distinguish a place of a torus from all other places of the two elements.
pub(crate) fn is_distinguished(place: &Place, all: &[Place], a: &Element<'_>, b: &Element<'_>) -> bool {
    let branch = named(a, b);
    let Some(offset) = Offset::of(place, a, b).filter(|_| branch != Branch::Nearest) else {
        return branch == Branch::Nearest;
    };
    let neutral = NEUTRAL * offset.radius;
    offset.within(branch) > neutral && others(place, all, a, b).all(|other| other.within(branch) <= neutral)
}

/// How far a place of a torus may move until its branch names no longer distinguish it, m; infinite for other loci.
pub(crate) fn margin(place: &Place, all: &[Place], a: &Element<'_>, b: &Element<'_>) -> f64 {
    let Some(own) = Offset::of(place, a, b).filter(|_| of_ring(a, b)) else { return f64::INFINITY };
    let branch = named(a, b);
    if branch == Branch::Nearest {
        return LEFT_NEUTRAL * NEUTRAL * own.radius - own.value.abs();
    }
    let outside = others(place, all, a, b).map(|other| -other.within(branch)).filter(|&outside| outside > 0.0);
    outside.fold(own.within(branch), f64::min)
}

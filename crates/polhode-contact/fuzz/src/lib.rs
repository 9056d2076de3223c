//! The fuzz targets. `pair`: any two shapes at any poses have a manifold, a separation and a time of impact, or a typed
//! result that there is none; finite results follow the crate's conventions, and the memory of a pair changes no
//! result. `answers`: distance, separation, manifold, ray casts and time of impact of a pair agree with each other, and
//! with those of the swapped pair.
//!
//! With cargo-fuzz, from the folder of polhode-contact, ten minutes of each:
//!
//! ```text
//! cargo fuzz run -s none pair fuzz/corpus/pair fuzz/seeds/pair -- -max_total_time=600 -timeout=5 -rss_limit_mb=1024
//! cargo fuzz run -s none answers fuzz/corpus/answers fuzz/seeds/pair -- -max_total_time=600 -timeout=60
//! ```
//!
//! | module | holds |
//! |---|---|
//! | `answers` | the second fuzz target |
//! | `memory` | the narrow phase with the memory of a pair gives the same bits as without |
//! | `screw` | motion along a straight path with a steady spin |

mod answers;
mod memory;
mod screw;

pub use answers::check_answers;

use polhode_contact::{
    Contact, ImpactSearch, Shape, evaluate, find_impact, kinematics, kinematics_with_tangential, manifold, separation,
};
use polhode_spatial::{DQuat, DVec3, Pose, Rotation, UnitVector, Velocity};
use screw::Screw;

/// Bytes read as numbers; zeros after the end.
struct Numbers<'a>(std::slice::Iter<'a, u8>);

impl Numbers<'_> {
    fn byte(&mut self) -> u8 {
        self.0.next().copied().unwrap_or(0)
    }

    /// Mostly small multiples of a half, so that features coincide; sometimes any bits, also numbers that are not
    /// finite.
    fn number(&mut self) -> f64 {
        let kind = self.byte();
        match kind {
            0 => f64::NAN,
            1 => f64::INFINITY,
            2 => f64::NEG_INFINITY,
            3..=9 => f64::from_bits(u64::from_le_bytes(std::array::from_fn(|_| self.byte()))),
            10..=40 => f64::from(self.byte() as i8) / 37.0,
            41..=50 => f64::from(self.byte() as i8) * NEAR,
            _ => f64::from(kind as i8 / 8) * 0.5,
        }
    }

    /// From 0.1 to 3.2, or any number.
    fn length(&mut self) -> f64 {
        match self.byte() {
            0..=20 => self.number(),
            byte => 0.1 * f64::from(1 + byte % 32),
        }
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.number(), self.number(), self.number())
    }

    fn points(&mut self) -> Vec<DVec3> {
        (0..self.byte() % 16).map(|_| self.vector()).collect()
    }

    fn pose(&mut self) -> Pose {
        let rotation = match self.byte() {
            0..=60 => Rotation::IDENTITY,
            61..=200 => Rotation::from_rotation_vector(self.vector()),
            _ => Rotation::renormalized(DQuat::from_xyzw(self.number(), self.number(), self.number(), self.number())),
        };
        Pose::new(rotation, self.vector())
    }

    /// A shape of any kind, or none when its numbers are not valid. `depth` bounds the nesting of compounds.
    fn shape(&mut self, depth: u32) -> Option<Shape> {
        let shape = match self.byte() % 12 {
            0 | 1 => Shape::cuboid(DVec3::new(self.length(), self.length(), self.length())),
            2 | 3 => polhode_contact::ConvexPolyhedron::from_points(&self.points()).map(Shape::convex),
            4 => Shape::sphere(self.length()),
            5 => Ok(Shape::half_space(UnitVector::new(self.vector()).ok()?)),
            6 => Shape::points(self.points()),
            7 => Shape::capsule(self.length(), self.length()),
            8 => Shape::cylinder(self.length(), self.length()),
            9 => Shape::cone(self.length(), self.length()),
            10 => Shape::torus(self.length(), self.length()),
            _ if depth > 0 && self.byte() % 2 == 0 => {
                let parts = (0..self.byte() % 4).filter_map(|_| self.shape(depth - 1)).collect();
                Shape::compound(parts)
            }
            _ => {
                let triangles = (0..self.byte() % 8).map(|_| [(); 3].map(|()| u32::from(self.byte() % 16)));
                let triangles: Vec<[u32; 3]> = triangles.collect();
                Shape::triangle_mesh(self.points(), triangles)
            }
        };
        let shape = shape.ok()?;
        if self.byte() % 4 == 0 { shape.placed(&self.pose()).ok() } else { Some(shape) }
    }
}

/// Distances at which features begin to coincide, m.
const NEAR: f64 = 1e-12;

/// Separations and lengths that differ by less than this, relative to the largest length, count as equal; it covers the
/// rounding on slivers.
const ROUNDING: f64 = 1e-9;

/// With lengths beyond this so many digits are lost that only the absence of panics is checked.
const LARGE: f64 = 1e9;

/// Reads bytes as two shapes, poses and velocities, and checks the results of the crate.
///
/// # Panics
/// When a result violates a convention of the crate.
pub fn check(bytes: &[u8]) {
    let mut numbers = Numbers(bytes.iter());
    let (Some(a), Some(b)) = (numbers.shape(1), numbers.shape(1)) else { return };
    let (pose_a, pose_b, reach) = (numbers.pose(), numbers.pose(), numbers.number());
    let found = manifold(&a, &pose_a, &b, &pose_b, reach);
    let apart = separation(&a, &pose_a, &b, &pose_b);
    let finite = pose_a.is_finite() && pose_b.is_finite();
    assert!(finite || (found.contacts.is_empty() && found.separation.is_nan() && apart.is_nan()), "{found:?} {apart}");
    let velocities = [(); 2].map(|()| Velocity::new(numbers.vector(), numbers.vector()));
    for contact in &found.contacts {
        let again = evaluate(contact.feature, &a, &pose_a, &b, &pose_b);
        assert_eq!(again, Some(contact.geometry), "evaluated anew: {contact:?}");
        let moving = kinematics(contact.feature, &a, &pose_a, &velocities[0], &b, &pose_b, &velocities[1]);
        assert_eq!(moving.map(|k| k.geometry), Some(contact.geometry), "in motion: {contact:?}");
        let (of_a, of_b) = (&velocities[0], &velocities[1]);
        let both = kinematics_with_tangential(contact.feature, &a, &pose_a, of_a, &b, &pose_b, of_b);
        assert_eq!(both.map(|both| both.0.geometry), Some(contact.geometry), "slipping: {contact:?}");
    }
    let length = |shape: &Shape| if matches!(shape, Shape::HalfSpace(_)) { 0.0 } else { shape.radius() };
    let largest = length(&a) + length(&b) + pose_a.translation.length() + pose_b.translation.length();
    if finite && largest < LARGE {
        let tolerance = ROUNDING * (1.0 + largest);
        found.contacts.iter().for_each(|contact| check_contact(contact, reach.max(tolerance)));
        assert!(found.contacts.windows(2).all(|pair| pair[0].feature < pair[1].feature), "out of order: {found:?}");
        let swapped = separation(&b, &pose_b, &a, &pose_a);
        // For bodies apart the search may stop at different axes.
        let same = (apart - swapped).abs() <= tolerance || (apart > 0.0 && swapped > 0.0) || apart == swapped;
        assert!(same, "swapped: {apart} {swapped}");
    }
    let motions = [Screw(pose_a, velocities[0]), Screw(pose_b, velocities[1])];
    let shapes = [a, b];
    memory::check_memory(&shapes, &motions, reach);
    let settings = ImpactSearch { max_evaluations: 200, ..ImpactSearch::default() };
    if let Ok(report) = find_impact(&shapes[0], &motions[0], &shapes[1], &motions[1], 0.0, 1.0, &settings) {
        assert!(report.time.is_none_or(|t| (0.0..=1.0).contains(&t)), "{report:?}");
    }
}

/// Checks that a contact is finite, has a unit normal and is within reach.
fn check_contact(contact: &Contact, reach: f64) {
    let geometry = &contact.geometry;
    assert!(geometry.point.is_finite() && geometry.separation.is_finite(), "{contact:?}");
    assert!((geometry.normal.length() - 1.0).abs() < ROUNDING, "{contact:?}");
    assert!(geometry.separation <= reach, "beyond {reach}: {contact:?}");
}

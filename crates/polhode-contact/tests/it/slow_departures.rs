//! Pairs that touch and separate as the cube of time, as they do when a contact force has decreased to zero smoothly.
//! There is no impact, and the search says so after few evaluations, for a disc that tips over an edge and for points
//! beside a torus.

use polhode_contact::{ImpactSearch, Shape, find_impact, separation};
use polhode_spatial::{DVec3, Motion, MotionBounds, Pose, Rotation, Still, Velocity};

/// Rotation about an axis through the origin of the world, and a rise along z that grows as the cube of time.
struct Departure {
    /// Place of the centre at t = 0, m.
    center: DVec3,
    /// Constant angular velocity, rad/s.
    spin: DVec3,
    /// Third derivative of the rise, m/s^3.
    jerk: f64,
}

impl Departure {
    fn arm(&self, t: f64) -> DVec3 {
        Rotation::from_rotation_vector(self.spin * t).rotate(self.center)
    }
}

impl Motion for Departure {
    fn pose(&self, t: f64) -> Pose {
        let rise = DVec3::Z * (self.jerk * t * t * t / 6.0);
        Pose { rotation: Rotation::from_rotation_vector(self.spin * t), translation: self.arm(t) + rise }
    }

    fn velocity(&self, t: f64) -> Velocity {
        Velocity::new(self.spin.cross(self.arm(t)) + DVec3::Z * (0.5 * self.jerk * t * t), self.spin)
    }

    fn bounds(&self, _t0: f64, t1: f64) -> MotionBounds {
        let (spin, arm) = (self.spin.length(), self.center.length());
        MotionBounds {
            speed: spin * arm + 0.5 * self.jerk * t1 * t1,
            acceleration: spin * spin * arm + self.jerk * t1,
            angular_speed: spin,
            angular_acceleration: 0.0,
        }
    }
}

/// No impact in a tenth of a second, after this many evaluations.
fn evaluations(shape: &Shape, motion: &Departure, ground: &Shape) -> u32 {
    let still = Still(Pose::IDENTITY);
    let start = separation(shape, &motion.pose(0.0), ground, &still.0);
    assert!(start.abs() < 1e-14, "they touch: {start}");
    let report = find_impact(shape, motion, ground, &still, 0.0, 0.1, &ImpactSearch::default()).expect("an answer");
    assert_eq!(report.time, None, "separation {}", report.separation);
    report.evaluations
}

/// The edge of the table is the y axis: the disc's face lies across it. It turns about the edge, and hardly about
/// another axis, so that the edge is nearly parallel to the face and touches the rim.
#[test]
fn a_disc_that_tips_over_an_edge_departs() {
    let table = Shape::cuboid(DVec3::new(2.0, 2.0, 0.2)).expect("a table");
    let table = table.translated(DVec3::new(-1.0, 0.0, -0.1)).expect("a table");
    for (radius, height) in [(0.05, 0.03), (0.05, 0.3), (0.5, 0.01)] {
        let disc = Shape::cylinder(radius, height).expect("a disc");
        for (overhang, tipping, roll) in [(0.3, 3.0, 0.0), (0.1, 3.0, 1e-4), (0.0, 0.5, -1e-6), (0.6, 10.0, 1e-9)] {
            let center = DVec3::new(overhang * radius, 0.0, 0.5 * height);
            // About the x axis it turns downwards on one side by less than the rise makes up for.
            let motion = Departure { center, spin: DVec3::new(0.0, tipping, 0.0), jerk: 200.0 };
            assert!(evaluations(&disc, &motion, &table) < 2000);
            let leaning = Departure { spin: DVec3::new(roll, tipping, 0.0), ..motion };
            let still = Still(Pose::IDENTITY);
            let search = ImpactSearch::default();
            let report = find_impact(&disc, &leaning, &table, &still, 0.0, 0.1, &search).expect("an answer");
            assert!(report.evaluations < 2000, "{radius} {overhang} {roll}: {}", report.evaluations);
        }
    }
}

#[test]
fn points_depart_from_a_torus() {
    let torus = Shape::torus(0.046, 0.02).expect("a torus");
    // The second point is in the hole: the hulls of both shapes overlap.
    let points = Shape::points(vec![DVec3::ZERO, DVec3::new(-0.046, 0.0, -0.03)]).expect("points");
    for jerk in [2.0, 200.0, 20_000.0] {
        // They go round on the top of the torus.
        let motion = Departure { center: DVec3::new(0.046, 0.0, 0.02), spin: DVec3::new(0.0, 0.0, 5.0), jerk };
        let count = evaluations(&points, &motion, &torus);
        assert!(count < 2000, "{jerk}: {count}");
    }
}

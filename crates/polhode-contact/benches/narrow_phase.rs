//! Narrow phase: manifolds of boxes and prisms, re-evaluation of one contact, time of impact.

use criterion::{Criterion, criterion_group, criterion_main};
use polhode_contact::{
    ConvexPolyhedron, ImpactSearch, Manifold, Shape, Workspace, evaluate, find_impact, kinematics,
    kinematics_with_tangential, manifold, manifold_into, separation_with,
};
use polhode_spatial::{DVec3, Motion, MotionBounds, Pose, Rotation, Still, UnitVector, Velocity};
use std::hint::black_box;

fn cuboid(x: f64, y: f64, z: f64) -> Shape {
    Shape::cuboid(DVec3::new(x, y, z)).expect("positive sizes")
}

fn prism(sides: u32) -> Shape {
    let points: Vec<DVec3> = (0..2 * sides)
        .map(|k| {
            let angle = f64::from(k / 2) / f64::from(sides) * std::f64::consts::TAU;
            DVec3::new(0.5 * angle.cos(), 0.5 * angle.sin(), if k % 2 == 0 { -0.5 } else { 0.5 })
        })
        .collect();
    Shape::convex(ConvexPolyhedron::from_points(&points).expect("a prism"))
}

/// A tumbling fall from 3 m, thrown upwards at 2 m/s.
struct TumblingFall;

impl Motion for TumblingFall {
    fn pose(&self, t: f64) -> Pose {
        let turn = Rotation::from_rotation_vector(DVec3::new(3.0, -2.0, 1.0) * t);
        Pose::new(turn, DVec3::new(t, 0.0, 3.0 + 2.0 * t - 4.905 * t * t))
    }
    fn velocity(&self, t: f64) -> Velocity {
        Velocity::new(DVec3::new(1.0, 0.0, 2.0 - 9.81 * t), DVec3::new(3.0, -2.0, 1.0))
    }
    fn bounds(&self, t0: f64, t1: f64) -> MotionBounds {
        let speed = |t: f64| self.velocity(t).linear.length();
        MotionBounds {
            speed: speed(t0).max(speed(t1)),
            acceleration: 9.81,
            angular_speed: 14.0_f64.sqrt(),
            angular_acceleration: 0.0,
        }
    }
}

fn narrow_phase(criterion: &mut Criterion) {
    let (mut workspace, mut found) = (Workspace::default(), Manifold::default());
    let turned = Rotation::from_rotation_vector(DVec3::Z * 0.3);
    let above = Pose::new(turned, DVec3::new(0.1, 0.05, 0.999));
    let (cube, gon) = (cuboid(1.0, 1.0, 1.0), prism(32));
    for (name, a, b) in [("box-box", &cube, &cube), ("box-32gon", &cube, &gon), ("32gon-32gon", &gon, &gon)] {
        criterion.bench_function(&format!("manifold/{name}"), |bencher| {
            bencher.iter(|| manifold_into(&mut workspace, a, black_box(&above), b, &Pose::IDENTITY, 0.01, &mut found));
        });
        criterion.bench_function(&format!("separation/{name}"), |bencher| {
            bencher.iter(|| separation_with(&mut workspace, a, black_box(&above), b, &Pose::IDENTITY));
        });
    }
    let contacts = manifold(&cube, &above, &cube, &Pose::IDENTITY, 0.01).contacts;
    let velocity = Velocity::new(DVec3::X, DVec3::Y);
    for contact in [contacts.first(), contacts.last()].into_iter().flatten() {
        let feature = contact.feature;
        criterion.bench_function(&format!("evaluate/{feature:?}"), |bencher| {
            bencher.iter(|| evaluate(feature, &cube, black_box(&above), &cube, &Pose::IDENTITY));
        });
        criterion.bench_function(&format!("kinematics/{feature:?}"), |bencher| {
            bencher.iter(|| {
                kinematics(feature, &cube, black_box(&above), &velocity, &cube, &Pose::IDENTITY, &Velocity::ZERO)
            });
        });
        criterion.bench_function(&format!("kinematics with tangential/{feature:?}"), |bencher| {
            let still = (&cube, &Pose::IDENTITY, &Velocity::ZERO);
            bencher.iter(|| {
                kinematics_with_tangential(feature, &cube, black_box(&above), &velocity, still.0, still.1, still.2)
            });
        });
    }
}

fn impact(criterion: &mut Criterion) {
    let settings = ImpactSearch::default();
    let brick = cuboid(1.0, 0.5, 0.25);
    let floor = Shape::half_space(UnitVector::Z);
    let slab = cuboid(20.0, 20.0, 1.0);
    let below = Still(Pose::from_translation(DVec3::Z * -0.5));
    criterion.bench_function("impact/tumbling box on half-space", |bencher| {
        bencher.iter(|| {
            find_impact(&brick, &TumblingFall, &floor, &Still(Pose::IDENTITY), 0.0, black_box(2.0), &settings)
        });
    });
    criterion.bench_function("impact/tumbling box on slab", |bencher| {
        bencher.iter(|| find_impact(&brick, &TumblingFall, &slab, &below, 0.0, black_box(2.0), &settings));
    });
}

criterion_group!(benches, narrow_phase, impact);
criterion_main!(benches);

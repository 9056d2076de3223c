//! Cost of one step of every method, of one free body and of a heavy top. `cargo bench -p polhode-dynamics --bench
//! integrators`. What matters are the ratios to `rk4`; the errors that belong to them are in the work-precision test.

use criterion::{Criterion, criterion_group, criterion_main};
use glam::DVec3;
use polhode_dynamics::integrator::{
    Cf4, ExplicitEuler, ImplicitGyroscopic, ImplicitMidpoint, Integrator, MoserVeselov, MoserVeselov4, Orientation,
    Rk4, Rkmk4, RotationRate, SemiImplicitEuler, Splitting, Splitting4,
};
use polhode_dynamics::{BodyState, FreeMotion, RigidBody};
use polhode_spatial::{Inertia, Mass, MassProperties, Rotation};
use std::hint::black_box;

/// Length of the steps, s: that of the smallest error of the work-precision table.
const STEP: f64 = 1e-3;

fn methods() -> Vec<(&'static str, Box<dyn Integrator>)> {
    let rk4 = |orientation| Box::new(Rk4::new(orientation, RotationRate::AngularMomentum));
    vec![
        ("rk4", rk4(Orientation::Quaternion)),
        ("rk4 with angular velocity", Box::new(Rk4::new(Orientation::Quaternion, RotationRate::AngularVelocity))),
        ("rk4 on matrices", rk4(Orientation::Matrix)),
        ("rk4 on Euler angles", rk4(Orientation::EulerAngles)),
        ("explicit-euler", Box::new(ExplicitEuler::new())),
        ("semi-implicit-euler", Box::new(SemiImplicitEuler::new())),
        ("implicit-gyroscopic", Box::new(ImplicitGyroscopic::new())),
        ("rkmk4", Box::new(Rkmk4::new())),
        ("cf4", Box::new(Cf4::new())),
        ("splitting", Box::new(Splitting::new())),
        ("splitting-4 of Yoshida", Box::new(Splitting::of_order_4(Splitting4::Yoshida))),
        ("splitting-4", Box::new(Splitting::of_order_4(Splitting4::Suzuki))),
        ("splitting-6", Box::new(Splitting::of_order_6())),
        ("implicit-midpoint", Box::new(ImplicitMidpoint::new())),
        ("moser-veselov", Box::new(MoserVeselov::new())),
        ("moser-veselov-4", Box::new(MoserVeselov4::new())),
    ]
}

fn steps(criterion: &mut Criterion, group: &str, body: &RigidBody, gravity: DVec3) {
    // Away from the singularity of Euler angles at the identity.
    let rotation = Rotation::from_rotation_vector(DVec3::new(1.0, 0.2, -0.3));
    let mut start = BodyState { angular_momentum: rotation.rotate(DVec3::new(0.4, 1.6, 1.2)), ..BodyState::default() };
    start.pose.rotation = rotation;
    let bodies = [*body];
    let motion = FreeMotion::new(&bodies, gravity, &[]);
    let mut group = criterion.benchmark_group(group);
    for (name, mut integrator) in methods() {
        integrator.start(&motion, 0.0, &[start]);
        // Forth and back, so that the motion stays where it was started.
        let mut h = STEP;
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                h = -h;
                integrator.step(&motion, black_box(h))
            });
        });
    }
    group.finish();
}

fn integrators(criterion: &mut Criterion) {
    let Ok(inertia) = Inertia::from_diagonal(DVec3::new(1.0, 2.0, 3.0)) else { return };
    let Ok(mass) = Mass::new(1.0) else { return };
    let properties = MassProperties::new(mass, DVec3::ZERO, inertia);
    steps(criterion, "free body", &RigidBody::new(&properties), DVec3::NEG_Z);
    steps(criterion, "heavy top", &RigidBody::pivoted(&properties, DVec3::new(-0.3, 0.1, -0.5)), DVec3::NEG_Z);
}

criterion_group! {
    name = benches;
    config = Criterion::default();
    targets = integrators
}
criterion_main!(benches);

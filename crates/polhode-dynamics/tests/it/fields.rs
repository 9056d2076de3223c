//! Force fields by themselves: forces are minus the gradient of the potential, action equals reaction, dampers take
//! energy away, and what makes no sense is refused.

use crate::support::{body, cases, rotation};
use glam::DVec3;
use polhode_dynamics::field::{
    Account, Anchor, AppliedForce, AppliedTorque, Damper, Dependence, Drag, DragLaw, Field, FieldError, Frame,
    MutualGravity, PointGravity, Signal, Spring, Wrench,
};
use polhode_dynamics::{BodyState, FreeMotion, RigidBody};
use polhode_spatial::{Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use proptest::prelude::*;

fn vector(size: f64) -> impl Strategy<Value = DVec3> {
    [-size..size, -size..size, -size..size].prop_map(DVec3::from_array)
}

fn at(body: usize, point: DVec3) -> Anchor {
    Anchor::Body { body, point }
}

/// Two free bodies and one on a pivot.
fn bodies() -> [RigidBody; 3] {
    let inertia = Inertia::from_diagonal(DVec3::new(0.3, 0.4, 0.2)).unwrap();
    let properties = MassProperties::new(Mass::new(2.0).unwrap(), DVec3::new(0.1, 0.5, -0.2), inertia);
    [
        body(1.5, DVec3::new(1.0, 2.0, 2.5)),
        body(0.5, DVec3::new(0.2, 0.1, 0.2)),
        RigidBody::pivoted(&properties, DVec3::new(0.3, 0.0, 0.1)),
    ]
}

prop_compose! {
    /// States of the three bodies, far enough apart for no force to be near a singularity.
    fn states()(
        turns in [rotation(), rotation(), rotation()],
        places in [vector(0.5), vector(0.5), vector(0.5)],
        speeds in [vector(2.0), vector(2.0), vector(2.0)],
        spins in [vector(2.0), vector(2.0), vector(2.0)],
    ) -> Vec<BodyState> {
        let centers = [DVec3::ZERO, DVec3::X * 4.0, DVec3::Y * 4.0];
        let state = |(k, body): (usize, &RigidBody)| {
            body.at_velocity(Pose::new(turns[k], centers[k] + places[k]), Velocity::new(speeds[k], spins[k]))
        };
        bodies().iter().enumerate().map(state).collect()
    }
}

/// Every conservative field, joined to the bodies in every way.
fn conservative() -> Vec<Box<dyn Field>> {
    let ends = [
        (at(0, DVec3::new(0.2, 0.1, -0.3)), at(1, DVec3::new(-0.1, 0.4, 0.0))),
        (at(1, DVec3::Z * 0.2), at(2, DVec3::new(0.4, 0.0, 0.3))),
        (Anchor::World(DVec3::new(1.0, 1.0, 6.0)), at(2, DVec3::ONE * 0.3)),
    ];
    let mut fields: Vec<Box<dyn Field>> = vec![
        Box::new(PointGravity::new(40.0, DVec3::new(3.0, 3.0, -4.0)).unwrap()),
        Box::new(MutualGravity::new(7.0).unwrap()),
    ];
    for (a, b) in ends {
        fields.push(Box::new(Spring::new(a, b, 12.0, 1.3).unwrap()));
        fields.push(Box::new(Spring::new(a, b, 5.0, 0.0).unwrap()));
    }
    fields
}

/// Step of the central differences, m and rad: the cube root of the rounding, where both errors are near 1e-10.
const STEP: f64 = 1e-5;

/// `-dV/dx` and `-dV/dangle` of one body.
fn gradient(motion: &FreeMotion<'_>, states: &[BodyState], index: usize) -> (DVec3, DVec3) {
    let potential = |change: &dyn Fn(&mut Pose)| {
        let mut moved = states.to_vec();
        change(&mut moved[index].pose);
        motion.potential_energy(&moved)
    };
    let slope = |change: &dyn Fn(&mut Pose, f64)| {
        (potential(&|pose| change(pose, -STEP)) - potential(&|pose| change(pose, STEP))) / (2.0 * STEP)
    };
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    (
        DVec3::from_array(axes.map(|axis| slope(&|pose, d| pose.translation += axis * d))),
        DVec3::from_array(
            axes.map(|axis| slope(&|pose, d| pose.rotation = Rotation::from_rotation_vector(axis * d) * pose.rotation)),
        ),
    )
}

proptest! {
    #![proptest_config(cases(24))]

    /// Force and torque are minus the gradient of the potential energy, gravity included, for free and pivoted bodies.
    #[test]
    fn conservative_wrench_is_minus_the_gradient(states in states()) {
        let bodies = bodies();
        let g = DVec3::new(0.4, -0.3, -9.81);
        let fields = conservative();
        for fields in std::iter::once(&fields[..]).chain(fields.chunks(1)) {
            let motion = FreeMotion::new(&bodies, g, fields);
            let mut wrenches = vec![Wrench::default(); 3];
            motion.wrenches(0.0, &states, &mut wrenches);
            for (index, wrench) in wrenches.iter().enumerate() {
                let (force, torque) = gradient(&motion, &states, index);
                prop_assert!((wrench.torque - torque).length() < 1e-7, "{:?}: {} {}", fields, wrench.torque, torque);
                if !bodies[index].is_pivoted() {
                    let total = wrench.force + g * bodies[index].mass();
                    prop_assert!((total - force).length() < 1e-7, "{:?}: {} {}", fields, total, force);
                }
            }
            // Along the motion the potential of the fields falls by what they give.
            let power: f64 = motion.power(0.0, &states, Account::Potential);
            let weight: f64 = bodies.iter().zip(&states)
                .map(|(body, state)| body.mass() * g.dot(body.center_of_mass_velocity(state).linear)).sum();
            let rate: f64 = bodies.iter().zip(&states).zip(&wrenches).map(|((body, state), wrench)| {
                let free = (wrench.force + motion.free_acceleration(body) * body.mass()).dot(state.linear_velocity);
                free + wrench.torque.dot(body.angular_velocity(state))
            }).sum();
            prop_assert!((power + weight - rate).abs() < 1e-11 * (1.0 + rate.abs() + power.abs() + weight.abs()));
        }
    }

    /// Forces between bodies sum to nothing, and so do their moments about any point.
    #[test]
    fn action_equals_reaction(states in states()) {
        let bodies = bodies();
        let (a, b) = (at(0, DVec3::new(0.2, 0.1, -0.3)), at(2, DVec3::new(-0.1, 0.4, 0.0)));
        let fields: [Box<dyn Field>; 4] = [
            Box::new(MutualGravity::new(7.0).unwrap()),
            Box::new(Spring::new(a, b, 12.0, 1.3).unwrap()),
            Box::new(Spring::new(b, a, 12.0, 0.0).unwrap()),
            Box::new(Damper::new(a, b, 3.0).unwrap()),
        ];
        for field in &fields {
            let mut wrenches = vec![Wrench::default(); 3];
            field.add_wrenches(0.0, &bodies, &states, &mut wrenches);
            let force: DVec3 = wrenches.iter().map(|wrench| wrench.force).sum();
            let moment: DVec3 = bodies.iter().zip(&states).zip(&wrenches)
                .map(|((body, state), w)| w.torque + body.center_of_mass_position(state).cross(w.force)).sum();
            let size = wrenches.iter().fold(1.0, |m, w| f64::max(m, w.force.length()));
            prop_assert!(force.length() < 1e-14 * size && moment.length() < 1e-13 * size, "{:?}", field);
        }
    }

    /// Drag and dampers take energy; turning the law round gives the same with springs: they neither take nor give.
    #[test]
    fn damping_takes_energy(states in states()) {
        let bodies = bodies();
        let (a, b) = (at(0, DVec3::new(0.2, 0.1, -0.3)), at(2, DVec3::new(-0.1, 0.4, 0.0)));
        let fields: [Box<dyn Field>; 4] = [
            Box::new(Drag::new(0, DragLaw::Linear, 0.7, 0.2).unwrap()),
            Box::new(Drag::new(2, DragLaw::Quadratic, 0.7, 0.2).unwrap()),
            Box::new(Damper::new(a, b, 3.0).unwrap()),
            Box::new(Damper::new(b, Anchor::World(DVec3::ONE * 5.0), 3.0).unwrap()),
        ];
        for field in fields {
            prop_assert_eq!((field.account(), field.dependence()), (Account::Damping, Dependence::Velocities));
            let one = [field];
            let motion = FreeMotion::new(&bodies, DVec3::ZERO, &one);
            let power = motion.power(0.0, &states, Account::Damping);
            prop_assert!(power < 0.0, "{:?}: {}", one, power);
            prop_assert_eq!(motion.power(0.0, &states, Account::External), 0.0);
            prop_assert_eq!(motion.potential_energy(&states), 0.0);
        }
    }
}

/// Wind drives what it meets: its work is external, and a body that drifts with it feels nothing.
#[test]
fn wind_does_external_work() {
    let bodies = [body(1.0, DVec3::ONE)];
    let wind = DVec3::new(3.0, -1.0, 0.5);
    for law in [DragLaw::Linear, DragLaw::Quadratic] {
        let fields: [Box<dyn Field>; 1] = [Box::new(Drag::new(0, law, 2.0, 0.0).unwrap().in_wind(wind).unwrap())];
        let motion = FreeMotion::new(&bodies, DVec3::ZERO, &fields);
        assert_eq!(fields[0].account(), Account::External);
        let moving = |v: DVec3| [bodies[0].at_velocity(Pose::IDENTITY, Velocity::new(v, DVec3::ZERO))];
        assert!(motion.power(0.0, &moving(wind * 0.5), Account::External) > 0.0);
        let mut wrenches = [Wrench::default()];
        motion.wrenches(0.0, &moving(wind), &mut wrenches);
        assert_eq!(wrenches[0].force.length(), 0.0);
    }
}

/// A force at a point off the centre of mass: the moment about it, about the pivot of a pivoted body, and the power.
#[test]
fn applied_loads() {
    let bodies = bodies();
    let quarter = Rotation::from_rotation_vector(DVec3::Z * std::f64::consts::FRAC_PI_2);
    let states: Vec<BodyState> = bodies
        .iter()
        .map(|b| b.at_velocity(Pose::new(quarter, DVec3::ONE), Velocity::new(DVec3::X, DVec3::Z)))
        .collect();
    let wrenches = |field: Box<dyn Field>, t: f64| {
        let fields = [field];
        let mut wrenches = vec![Wrench::default(); 3];
        FreeMotion::new(&bodies, DVec3::ZERO, &fields).wrenches(t, &states, &mut wrenches);
        let power = FreeMotion::new(&bodies, DVec3::ZERO, &fields).power(t, &states, Account::External);
        (wrenches, power)
    };
    let near = |a: DVec3, b: DVec3| assert!((a - b).length() < 1e-15 * 10.0, "{a} {b}");
    // In body axes: a push along x at y = 1 of the body, which the quarter turn makes one along y at x = -1.
    let push = |index, frame| AppliedForce::new(index, DVec3::X * 3.0, frame).unwrap().at_point(DVec3::Y).unwrap();
    let (w, power) = wrenches(Box::new(push(0, Frame::Body)), 0.0);
    near(w[0].force, DVec3::Y * 3.0);
    near(w[0].torque, DVec3::Z * -3.0);
    // The velocity of the point is (1, 0, 0) + z x (-1, 0, 0) = (1, -1, 0).
    assert!((power + 3.0).abs() < 1e-14, "{power}");
    let (w, power) = wrenches(Box::new(push(0, Frame::World)), 0.0);
    near(w[0].torque, DVec3::ZERO);
    assert!((power - 3.0).abs() < 1e-14, "{power}");
    let (w, power) = wrenches(Box::new(push(2, Frame::Body)), 0.0);
    near(w[2].torque, DVec3::Z * -3.0);
    assert!((power + 3.0).abs() < 1e-14, "about the pivot: {power}");
    let (w, _) = wrenches(Box::new(AppliedForce::new(1, DVec3::Z, Frame::Body).unwrap()), 0.0);
    assert_eq!((w[1].force, w[1].torque), (DVec3::Z, DVec3::ZERO), "at the centre of mass");
    let ramp = Signal::table(vec![(0.0, 0.0), (2.0, 4.0)]).unwrap();
    let twist = AppliedTorque::new(1, DVec3::X, Frame::Body).unwrap().following(ramp);
    assert_eq!(twist.dependence(), Dependence::PosesAndTime);
    let (w, _) = wrenches(Box::new(twist), 0.5);
    near(w[1].torque, DVec3::Y);
}

#[test]
fn signals() {
    let values = |signal: &Signal, times: &[f64]| times.iter().map(|&t| signal.at(t)).collect::<Vec<_>>();
    assert_eq!(values(&Signal::constant(3.0).unwrap(), &[-1.0, 5.0]), [3.0, 3.0]);
    let wave = Signal::sinusoid(2.0, 0.25, std::f64::consts::FRAC_PI_6).unwrap();
    assert!((wave.at(0.0) - 1.0).abs() < 1e-15 && (wave.at(2.0) + 1.0).abs() < 1e-15);
    let table = Signal::table(vec![(1.0, 2.0), (3.0, 6.0), (4.0, 0.0)]).unwrap();
    assert_eq!(values(&table, &[0.0, 1.0, 2.0, 3.0, 3.5, 4.0, 9.0]), [2.0, 2.0, 4.0, 6.0, 3.0, 0.0, 0.0]);
    assert!(table.at(f64::NAN).is_finite());
    assert_eq!(Signal::polynomial(vec![1.0, -2.0, 3.0]).unwrap().at(2.0), 9.0);
    assert_eq!(Signal::polynomial(vec![]).unwrap().at(2.0), 0.0);
    assert_eq!(Signal::from_fn(|t| t * t).at(3.0), 9.0);
}

/// Each refusal names the value and what is wrong with it.
#[test]
fn nonsense_is_refused() {
    let texts = [
        PointGravity::new(-1.0, DVec3::ZERO).map(drop),
        PointGravity::new(1.0, DVec3::new(0.0, f64::NAN, 0.0)).map(drop),
        MutualGravity::new(f64::INFINITY).map(drop),
        Drag::new(0, DragLaw::Linear, -2.0, 0.0).map(drop),
        Spring::new(at(1, DVec3::ZERO), at(1, DVec3::X), 1.0, 0.0).map(drop),
        Damper::new(Anchor::World(DVec3::ZERO), Anchor::World(DVec3::X), 1.0).map(drop),
        Signal::table(vec![]).map(drop),
        Signal::table(vec![(1.0, 0.0), (1.0, 2.0)]).map(drop),
    ]
    .map(|result| result.unwrap_err().to_string());
    assert_eq!(texts[0], "the gravitational parameter of a force field must be zero or positive, found -1");
    assert_eq!(texts[1], "the position of a force field must be finite, found NaN");
    assert_eq!(texts[4], "a spring or damper must join two different bodies, or a body and the world");
    assert_eq!(texts[7], "times of a table must rise: point 1 has 1 s after 1 s");
    let is_order = matches!(
        Signal::table(vec![(1.0, 0.0), (0.0, 2.0)]),
        Err(FieldError::TableOrder { index: 1, t: 0.0, before: 1.0 })
    );
    assert!(is_order);
}

/// A field that names a body that is not there, and slices of different lengths: nothing happens, nothing panics.
#[test]
fn missing_bodies_are_left_alone() {
    let bodies = [body(1.0, DVec3::ONE)];
    let (here, there) = (at(0, DVec3::X), at(7, DVec3::Y));
    let fields: Vec<Box<dyn Field>> = vec![
        Box::new(Spring::new(here, there, 1.0, 0.0).unwrap()),
        Box::new(Damper::new(there, Anchor::World(DVec3::ZERO), 1.0).unwrap()),
        Box::new(Drag::new(7, DragLaw::Quadratic, 1.0, 1.0).unwrap()),
        Box::new(AppliedForce::new(7, DVec3::X, Frame::Body).unwrap()),
        Box::new(AppliedTorque::new(7, DVec3::X, Frame::Body).unwrap()),
    ];
    let motion = FreeMotion::new(&bodies, DVec3::ZERO, &fields);
    let mut wrenches = [Wrench::default(); 3];
    motion.wrenches(0.0, &[BodyState::default(); 2], &mut wrenches);
    assert_eq!(wrenches, [Wrench::default(); 3]);
    assert_eq!(motion.potential_energy(&[]), 0.0);
    assert_eq!(motion.power(0.0, &[], Account::Damping), 0.0);
    assert!(motion.is_loaded(0) && !motion.is_loaded(3));
}

/// Points that coincide have no line between them: a spring without rest length is smooth there, others give no force.
#[test]
fn coinciding_points_give_no_force() {
    let bodies = [body(1.0, DVec3::ONE)];
    let state = [bodies[0].at_velocity(Pose::IDENTITY, Velocity::new(DVec3::X, DVec3::ZERO))];
    let (a, b) = (at(0, DVec3::ZERO), Anchor::World(DVec3::ZERO));
    let fields: [Box<dyn Field>; 3] = [
        Box::new(Spring::new(a, b, 1.0, 0.0).unwrap()),
        Box::new(Spring::new(a, b, 1.0, 2.0).unwrap()),
        Box::new(Damper::new(a, b, 1.0).unwrap()),
    ];
    let mut wrenches = [Wrench::default()];
    FreeMotion::new(&bodies, DVec3::ZERO, &fields).wrenches(0.0, &state, &mut wrenches);
    assert_eq!(wrenches[0], Wrench::default());
}

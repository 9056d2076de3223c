//! JT-08: Andrews' squeezing mechanism, seven bodies in a plane with three closed loops, driven by a torque for 0.03 s.
//!
//! Parameters and equations: Schiehlen 1990; Hairer and Wanner 1996, section VII.7. The mechanism lies in the plane of
//! x and y; O is the origin. K1 turns about O and carries F; K2 joins F and E; K3 turns about B and ends at E, with the
//! spring from D to C; K4 joins E and G, K5 turns about A and ends at G; K6 joins E and H, K7 turns about A and ends at
//! H.

use super::{bodies_at, rows_of_energy, run, scene};
use crate::cases::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::scene::{Attachment, Force, Frame, Joint, Method, Signal, Tier};
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector};
use polhode::{Body, BodyId, BodySample, Scene, Simulation};

/// Angles at the start: beta, theta, gamma, phi, delta, omega, epsilon, rad.
const START: [f64; 7] = [
    -0.061_713_890_014_276_45,
    0.0,
    0.455_279_819_163_070_4,
    0.222_668_390_165_885_9,
    0.487_364_979_543_842_55,
    -0.222_668_390_165_885_9,
    1.230_547_444_549_821_2,
];

/// Masses (kg) and moments about the centres of mass (kg m^2) of K1 to K7.
const MATTER: [(f64, f64); 7] = [
    (0.043_25, 2.194e-6),
    (0.003_65, 4.410e-7),
    (0.023_73, 5.255e-6),
    (0.007_06, 5.667e-7),
    (0.070_50, 1.169e-5),
    (0.007_06, 5.667e-7),
    (0.054_98, 1.912e-5),
];

const A: DVec3 = DVec3::new(-0.069_34, -0.002_27, 0.0);
const B: DVec3 = DVec3::new(-0.036_35, 0.032_73, 0.0);
const C: DVec3 = DVec3::new(0.014, 0.072, 0.0);
/// Spring: N/m, and its length at rest, m.
const SPRING: (f64, f64) = (4530.0, 0.077_85);
/// Longest step and time between samples, s: the mechanism turns some revolutions in 0.03 s.
const STEP_S: f64 = 1e-3;
const INTERVAL_S: f64 = 1e-4;
/// Torque on K1, N m.
const TORQUE: f64 = 0.033;
/// Lengths of Hairer and Wanner's figure 7.1, m.
const D: f64 = 28e-3;
const DA: f64 = 115e-4;
const E: f64 = 2e-2;
const EA: f64 = 1421e-5;
const RR: f64 = 7e-3;
const RA: f64 = 92e-5;
const SA: f64 = 1874e-5;
const SB: f64 = 1043e-5;
const SC: f64 = 18e-3;
const SD: f64 = 2e-2;
const TA: f64 = 2308e-5;
const TB: f64 = 916e-5;
const U: f64 = 4e-2;
const UA: f64 = 1228e-5;
const UB: f64 = 449e-5;
const ZF: f64 = 2e-2;
const ZT: f64 = 4e-2;
const FA: f64 = 1421e-5;

/// Attitudes of the bodies about z, rad, from the seven angles.
fn attitudes([beta, theta, gamma, phi, delta, omega, epsilon]: [f64; 7]) -> [f64; 7] {
    [beta, beta + theta, gamma, phi + delta, delta, omega + epsilon, epsilon]
}

/// Centres of mass of the bodies, m.
fn centres(angles: [f64; 7]) -> [DVec3; 7] {
    let [_, _, gamma, _, delta, _, epsilon] = angles;
    let [k1, k2, _, k4, _, k6, _] = attitudes(angles);
    let (at, flat) = (|angle: f64| DVec3::new(angle.cos(), angle.sin(), 0.0), |x: f64, y: f64| DVec3::new(x, y, 0.0));
    [
        at(k1) * RA,
        at(k1) * RR - at(k2) * DA,
        B + flat(SA * gamma.sin() + SB * gamma.cos(), SB * gamma.sin() - SA * gamma.cos()),
        A + at(delta) * ZT + flat(k4.sin(), -k4.cos()) * (E - EA),
        A + flat(TA * delta.cos() - TB * delta.sin(), TA * delta.sin() + TB * delta.cos()),
        A + flat(epsilon.sin(), -epsilon.cos()) * U + at(k6) * (ZF - FA),
        A + flat(UA * epsilon.sin() - UB * epsilon.cos(), -UA * epsilon.cos() - UB * epsilon.sin()),
    ]
}

/// The mechanism at the start, at rest, without gravity.
fn squeezer(duration_s: f64) -> super::Result<Scene> {
    let [beta, theta, gamma, _, delta, _, epsilon] = START;
    let at = |angle: f64| DVec3::new(angle.cos(), angle.sin(), 0.0);
    let f = at(beta) * RR;
    let e = f - at(beta + theta) * D;
    let (g, h) = (A + at(delta) * ZT, A + DVec3::new(epsilon.sin(), -epsilon.cos(), 0.0) * U);
    let d = B + DVec3::new(SD * gamma.cos() + SC * gamma.sin(), SD * gamma.sin() - SC * gamma.cos(), 0.0);
    let method = Method { tier: Some(Tier::Accurate), step_s: Some(STEP_S), ..Method::default() };
    let mut builder = scene("squeezer").method(method).gravity(DVec3::ZERO).duration_s(duration_s);
    builder = builder.output_interval_s(INTERVAL_S);
    for (number, ((mass, moment), (centre, attitude))) in
        MATTER.into_iter().zip(centres(START).into_iter().zip(attitudes(START))).enumerate()
    {
        let inertia = Inertia::from_diagonal(DVec3::new(0.6 * moment, 0.6 * moment, moment))?;
        let properties = MassProperties::new(Mass::new(mass)?, DVec3::ZERO, inertia);
        let pose = Pose::new(Rotation::from_rotation_vector(DVec3::Z * attitude), centre);
        builder.add_body(Body::movable(format!("K{}", number + 1), properties).pose(pose));
    }
    let body = |number: usize| BodyId::new(number - 1);
    let hinge = |number: usize, place: DVec3| Joint::hinge(body(number), place, UnitVector::Z);
    for joint in [
        hinge(1, DVec3::ZERO),
        hinge(2, f).with(body(1)),
        hinge(3, B),
        hinge(5, A),
        hinge(7, A),
        hinge(3, e).with(body(2)),
        hinge(4, e).with(body(2)),
        hinge(6, e).with(body(2)),
        hinge(5, g).with(body(4)),
        hinge(7, h).with(body(6)),
    ] {
        builder = builder.joint(joint);
    }
    let rotation = Rotation::from_rotation_vector(DVec3::Z * -gamma);
    let end = Attachment::Body { body: body(3), point: rotation.rotate(d - centres(START)[2]) };
    let torque = DVec3::Z * TORQUE;
    Ok(builder
        .force(Force::Applied {
            body: body(1),
            force: DVec3::ZERO,
            torque,
            frame: Frame::World,
            point: None,
            signal: Signal::ONE,
        })
        .force(Force::Spring {
            a: end,
            b: Attachment::World(C),
            stiffness: SPRING.0,
            rest_length: SPRING.1,
            damping: 0.0,
        })
        .build()?)
}

/// The seven angles of bodies, those of full revolutions within half a revolution of what is expected.
fn angles(bodies: &[BodySample], expected: [f64; 7]) -> [f64; 7] {
    let near = |body: usize, expected: f64| {
        let along = bodies[body].pose.rotation.rotate(DVec3::X);
        expected + crate::cases::motion::least_turn(along.y.atan2(along.x) - expected)
    };
    let whole = attitudes(expected);
    let [k1, k2, k3, k4, k5, k6, k7] = std::array::from_fn(|body| near(body, whole[body]));
    [k1, k2 - k1, k3, k4 - k5, k5, k6 - k7, k7]
}

/// The mechanism against the differential equations of its index-1 form.
pub(crate) fn jt_08(context: &Context) -> CaseResult {
    let scene = squeezer(0.03)?;
    let found = Simulation::new(&scene)?.accelerations()?;
    let first = [found[0].angular.z, found[1].angular.z - found[0].angular.z];
    let mut rows = vec![context.reference.row("JT-08", "initial beta'', theta''", first)?];
    let whole = run(&scene)?;
    // Which revolution the driven body is in: it turns by less than half of one between two samples.
    let turned = super::whole_angle(&whole, |bodies| {
        let along = bodies[0].pose.rotation.rotate(DVec3::X);
        along.y.atan2(along.x)
    });
    let at = |t: f64, beta: f64| -> super::Result<[f64; 7]> {
        Ok(angles(&bodies_at(&scene, t)?, [beta, -beta, 0.1, -0.4, 0.5, 0.4, 1.05]))
    };
    let quantity = "t=0.03: beta,theta,gamma,phi,delta,omega,epsilon";
    let end = at(0.03, turned)?;
    rows.push(context.reference.row("JT-08", quantity, end)?);
    rows.push(context.reference.row("JT-08", "t=0.01", at(0.01, 2.16)?)?);
    rows.push(Row::info(
        "JT-08",
        "beta at 0.03 s, against the 11 digits of 15.810771195",
        15.810_771_195_153_691,
        end[0],
    ));
    rows.extend(rows_of_energy("JT-08", &whole.report));
    Ok(rows)
}

//! Free rotation against closed forms and reference values: cases FR-01 to FR-07 of the validation catalogue, and what
//! must hold for numbers nobody means to pass.

use crate::support::{body_rate, quaternion_error, spin};
use glam::{DMat3, DVec3};
use polhode_dynamics::FreeRotation;
use polhode_dynamics::exact_rotation::drift;
use polhode_spatial::Rotation;
use std::f64::consts::TAU;

fn assert_near(value: DVec3, reference: [f64; 3], tolerance: f64) {
    let error = (value - DVec3::from_array(reference)).abs().max_element();
    assert!(error <= tolerance, "{value} is off by {error:e}");
}

/// FR-01: a symmetric top precesses at |L|/I1 while it spins: `R = exp(L t/I1) exp(-W t e3)`, `W = (I3-I1)/I1 w3`.
#[test]
fn symmetric_top_has_its_closed_form() {
    let (body, flight) = spin(DVec3::new(2.0, 2.0, 1.0), DVec3::new(1.0, 0.0, 5.0));
    let end = flight.state(10.0);
    assert_near(body_rate(&body, &end), [0.9912028118634736, 0.13235175009777303, 5.0], 1e-12);
    let reference = [0.671044180536909, 0.2894813567784536, 0.019241316837259024, 0.6822976063065312];
    assert!(quaternion_error(end.pose.rotation, reference) < 1e-12);
    let momentum = flight.start().angular_momentum;
    assert!((momentum.length() / 2.0 - 2.692582403567252).abs() < 1e-13 * 2.7);
    for t in [0.01, 1.0, 77.7, -3.0] {
        let precession = Rotation::from_rotation_vector(momentum * (t / 2.0));
        // The body-fixed rate of w is (I1 - I3)/I1 w3 about the axis of symmetry.
        let spin = Rotation::from_rotation_vector(DVec3::Z * (0.5 * 5.0 * t));
        let error = flight.state(t).pose.rotation.angle_to(precession * spin);
        assert!(error < 5e-14 * (1.0 + t.abs() / 10.0), "t = {t}: {error:e}");
    }
}

/// FR-02: the intermediate axis flips over for ever; one call covers nine flips, and energy and |L| do not move.
#[test]
fn middle_axis_flips_on_time() {
    let (body, flight) = spin(DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.01, 2.0, 0.01));
    let end = flight.state(100.0);
    assert_near(body_rate(&body, &end), [0.011252799694530838, -1.9999933436136819, 0.010434326379235562], 1e-10);
    let reference = [0.006157426554914883, -0.5041426374441205, 6.170773042980609e-05, 0.863598450323565];
    assert!(quaternion_error(end.pose.rotation, reference) < 1e-10);
    let period = flight.rotation().period().unwrap();
    assert!((period / 21.955145879353932 - 1.0).abs() < 1e-13, "period {period}");
    assert!((0.5 * period / 10.977572939676966 - 1.0).abs() < 1e-13, "time between flips");
    let parameter = flight.rotation().parameter().unwrap();
    assert!((parameter / 0.9999500037497188 - 1.0).abs() < 1e-15, "m = {parameter}");
    for zero in [6.059041085650863, 17.03661402532783, 28.014186965004797, 38.991759904681764, 49.969332844358725] {
        // Where w2 vanishes its rate is (I3 - I1)/I2 w3 w1, about 2 / s^2 here.
        let rate = body_rate(&body, &flight.state(zero)).y;
        assert!(rate.abs() < 1e-10, "w2 = {rate:e} at {zero}");
    }
    let (energy, momentum) = (4.0002, 4.000124998046936);
    assert!((flight.start().angular_momentum.length() / momentum - 1.0).abs() < 1e-13);
    for k in 0..6000 {
        let state = flight.state(f64::from(k) / 60.0);
        assert!((body.rotational_energy(&state) / energy - 1.0).abs() < 1e-13, "energy at sample {k}");
        let in_body = body_rate(&body, &state) * DVec3::new(1.0, 2.0, 3.0);
        assert!((in_body.length() / momentum - 1.0).abs() < 1e-13, "momentum at sample {k}");
    }
}

/// FR-03: a millionth of a percent off the middle axis: the first flips come when the closed form says, and until then
/// the deviation grows at the rate of the linear theory.
#[test]
fn extreme_near_separatrix_flips_on_time() {
    let (body, flight) = spin(DVec3::new(1.0, 2.0, 3.0), DVec3::new(1e-8, 1.0, 1e-8));
    for zero in [34.84692315376199, 102.25973147238314] {
        let before = body_rate(&body, &flight.state(zero * (1.0 - 1e-10))).y;
        let after = body_rate(&body, &flight.state(zero * (1.0 + 1e-10))).y;
        assert!(before * after < 0.0, "w2 = {before:e}, {after:e} about {zero}");
    }
    let rate = flight.rotation().phase_rate().unwrap();
    assert!((rate / 0.5773502691896257 - 1.0).abs() < 1e-14, "growth rate {rate}");
}

/// FR-04: a generic body, after ten and after a thousand seconds.
#[test]
fn generic_body_after_long_time() {
    let (body, flight) = spin(DVec3::new(1.0, 2.0, 3.0), DVec3::ONE);
    let at10 = flight.state(10.0);
    assert_near(body_rate(&body, &at10), [-0.6034704230925181, -1.2789931385478723, 0.887726788215733], 1e-13);
    let reference = [0.4625454405546428, -0.31433514514460553, 0.049429631279299835, 0.8275275484844137];
    assert!(quaternion_error(at10.pose.rotation, reference) < 1e-13);
    assert!((flight.rotation().period().unwrap() / 6.422703084225693 - 1.0).abs() < 1e-14);
    let at1000 = flight.state(1000.0);
    assert_near(body_rate(&body, &at1000), [0.43762945199459075, -1.3447975545586461, 0.8546967371048612], 1e-12);
    let reference = [0.3539418781082633, -0.058004060239493456, -0.07949712833472436, 0.9300757401972494];
    assert!(quaternion_error(at1000.pose.rotation, reference) < 1e-12);
}

/// FR-05: a spinning book wobbles about its extreme axes at Euler's frequencies and leaves the middle one at its rate.
#[test]
fn book_wobbles_and_grows_at_the_known_rates() {
    let moments = DVec3::new(13.0 / 3.0, 37.0 / 12.0, 17.0 / 12.0);
    let wobble = |axis: DVec3, other: DVec3| {
        let (_, flight) = spin(moments, axis + 1e-7 * other);
        TAU / flight.rotation().period().unwrap()
    };
    // The frequency depends on the square of the deviation, 1e-14.
    assert!((wobble(DVec3::X, DVec3::Y) / 0.9135962935560564 - 1.0).abs() < 1e-12);
    assert!((wobble(DVec3::Z, DVec3::Y) / 0.6031793794762581 - 1.0).abs() < 1e-12);
    let (body, flight) = spin(moments, DVec3::Y + 1e-9 * DVec3::X + 1e-9 * DVec3::Z);
    let distance = |t: f64| body_rate(&body, &flight.state(t)).x.abs();
    // Between 14 and 21 s the growing part is 1e7 times the decaying one, and the square of what it is of the spin
    // below 1e-7.
    let growth = (distance(21.0) / distance(14.0)).ln() / 7.0;
    assert!((growth / 0.5825517280354631 - 1.0).abs() < 1e-6, "growth {growth}");
}

/// FR-06: a needle that spins a hundred times faster than it tumbles, and a plate.
#[test]
fn needle_and_plate() {
    let (body, flight) = spin(DVec3::new(1e-6, 1.0, 1.0 + 1e-6), DVec3::new(100.0, 1.0, 0.5));
    let end = flight.state(10.0);
    let rate = body_rate(&body, &end);
    let reference = DVec3::new(100.000334265087, 0.9659952747635182, -0.562896966973913);
    assert!((rate - reference).length() < 1e-9 * reference.length(), "{rate}");
    let reference = [-0.6767763113403852, -0.36582819405319383, 0.6385344484324991, -0.020428289436096533];
    assert!(quaternion_error(end.pose.rotation, reference) < 1e-9);
    let (body, flight) = spin(DVec3::new(1.0, 1.5, 2.5), DVec3::new(1.0, 2.0, 3.0));
    let end = flight.state(10.0);
    assert_near(body_rate(&body, &end), [2.2060877165516293, 0.36493422267583797, 3.1262380911606837], 1e-12);
    let reference = [-0.07079534964226614, -0.18866881973510968, -0.21572294910999942, -0.9554348246510981];
    assert!(quaternion_error(end.pose.rotation, reference) < 1e-12);
}

/// FR-07: even chained, a million drifts lose neither energy nor momentum, the quaternion stays unit, and the
/// momentum's direction in the world stays: R p = L.
#[test]
fn a_million_chained_drifts_keep_the_invariants() {
    let (moments, momentum) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, 2.0, 3.0));
    for h in [1e-3, 1e-4] {
        let mut attitude = Rotation::IDENTITY;
        let mut worst = 0.0f64;
        for _ in 0..1_000_000 {
            attitude = drift(moments, attitude, momentum, h);
            let p = attitude.inverse_rotate(momentum);
            let energy = (p.dot(p / moments) / 6.0 - 1.0).abs();
            let length = (p.length() / momentum.length() - 1.0).abs();
            worst = worst.max(energy).max(length);
        }
        println!("h = {h}: invariants within {worst:.1e}");
        assert!(worst < 1e-12, "h = {h}: invariants off by {worst:e}");
        assert!((attitude.quaternion().length() - 1.0).abs() < 1e-14);
        let matrix = attitude.to_matrix();
        let excess = (matrix.transpose() * matrix - DMat3::IDENTITY).to_cols_array();
        assert!(excess.iter().all(|x| x.abs() < 1e-14), "{excess:?}");
        let back = attitude.rotate(attitude.inverse_rotate(momentum));
        assert!(back.angle_between(momentum) < 1e-11);
        // What a chain costs against one evaluation: the energy walks at random, by 1e-16 a step and 1e-13 in all, and
        // the phase is off by that part of the thousand radians.
        let at_once = drift(moments, Rotation::IDENTITY, momentum, 1e6 * h);
        assert!(attitude.angle_to(at_once) < 1e-9, "h = {h}: {:e}", attitude.angle_to(at_once));
    }
}

/// FR-02 and FR-04 over a thousand seconds: each sample is one evaluation of the record, so that energy and momentum
/// are those of the start however many samples there are. Returns the largest relative errors of the two.
fn sampled_invariants(w0: DVec3, count: u32) -> [f64; 2] {
    let (body, flight) = spin(DVec3::new(1.0, 2.0, 3.0), w0);
    let energy = body.rotational_energy(flight.start());
    let length = flight.start().angular_momentum.length();
    let mut worst = [0.0f64; 2];
    for k in 0..=count {
        let state = flight.state(1000.0 * (f64::from(k) / f64::from(count)));
        let p = body_rate(&body, &state) * body.moments();
        let errors = [body.rotational_energy(&state) / energy - 1.0, p.length() / length - 1.0];
        worst = [0, 1].map(|k| worst[k].max(errors[k].abs()));
    }
    worst
}

#[test]
fn samples_of_a_flight_keep_energy_and_momentum() {
    // One in a hundred of the million.
    for w0 in [DVec3::ONE, DVec3::new(0.01, 2.0, 0.01)] {
        let [energy, momentum] = sampled_invariants(w0, 10_000);
        println!("{w0}: energy {energy:.1e}, momentum {momentum:.1e}");
        assert!(energy < 1e-12 && momentum < 1e-12, "{w0}: energy {energy:e}, momentum {momentum:e}");
    }
}

/// On the separatrix the momentum runs into the middle axis and stays: `w2 = tanh(lambda t)`, no flip ever.
#[test]
fn separatrix_is_a_hyperbolic_tangent() {
    // (I3-I2) I1 p3^2 = (I2-I1) I3 p1^2 holds exactly for these numbers: 2*3*1 = 1*6*1.
    let moments = DVec3::new(3.0, 4.0, 6.0);
    let momentum = DVec3::new(1.0, 0.0, 1.0);
    let rotation = FreeRotation::new(moments, Rotation::IDENTITY, momentum);
    assert_eq!(rotation.period(), Some(f64::INFINITY));
    let size = 2f64.sqrt();
    let rate = size / 4.0 * (1.0 * 2.0 / (3.0 * 6.0f64)).sqrt();
    for t in [-40.0, -3.0, -0.2, 0.0, 0.01, 0.5, 2.0, 30.0, 400.0] {
        let p = rotation.at(t).inverse_rotate(momentum);
        let expected = size * (rate * t).tanh();
        assert!((p.y - expected).abs() < 1e-14 * size, "t = {t}: {} for {expected}", p.y);
        assert!((p.x - (rate * t).cosh().recip()).abs() < 2e-14 * size, "t = {t}");
    }
}

/// Steady rotations are recognised exactly and turn at a constant rate about a fixed axis.
#[test]
fn steady_rotations_are_steady() {
    let cases = [
        (DVec3::splat(2.0), DVec3::new(1.0, -2.0, 3.0)),
        (DVec3::new(1.0, 2.0, 3.0), DVec3::Y * 4.0),
        (DVec3::new(3.0, 1.0, 3.0), DVec3::new(2.0, 0.0, 1.0)),
        (DVec3::new(2.0, 2.0, 1.0), DVec3::new(0.3, 0.4, 0.0)),
    ];
    for (moments, momentum) in cases {
        let rotation = FreeRotation::new(moments, Rotation::IDENTITY, momentum);
        assert!(rotation.is_steady());
        assert_eq!(rotation.period(), None);
        assert_eq!(rotation.angular_acceleration_bound(), 0.0);
        let w = momentum / moments;
        assert!((rotation.angular_speed_bound() / w.length() - 1.0).abs() < 1e-13);
        let expected = Rotation::from_rotation_vector(w * 7.0);
        assert!(rotation.at(7.0).angle_to(expected) < 1e-14);
    }
}

/// Anything at all may be passed: the answer is a rotation or NaN, and it comes.
#[test]
fn no_number_hangs_or_panics() {
    let odd = [0.0, -0.0, 1.0, -1.0, 1e-320, 1e-160, 1e160, 1e308, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
    for a in odd {
        for b in odd {
            for c in odd {
                for h in [0.0, -1.0, 1e-300, 1e300, f64::NAN] {
                    for (i, l) in [
                        (DVec3::new(a, b, c), DVec3::new(1.0, 2.0, 3.0)),
                        (DVec3::new(1.0, 2.0, 3.0), DVec3::new(a, b, c)),
                        (DVec3::new(a, 1.0, b), DVec3::new(c, 1.0, c)),
                    ] {
                        let rotation = FreeRotation::new(i, Rotation::IDENTITY, l);
                        let q = rotation.at(h).quaternion();
                        let unit = (q.length() - 1.0).abs() < 1e-13;
                        assert!(unit || !q.is_finite(), "{q} for {i} {l} {h}");
                        let _ =
                            (rotation.period(), rotation.angular_speed_bound(), rotation.angular_acceleration_bound());
                    }
                }
            }
        }
    }
    let still = drift(DVec3::new(1.0, 2.0, 3.0), Rotation::IDENTITY, DVec3::ZERO, 1e9);
    assert_eq!(still, Rotation::IDENTITY);
    assert!(!drift(DVec3::new(1.0, 2.0, 3.0), Rotation::IDENTITY, DVec3::splat(f64::NAN), 1.0).is_finite());
}

/// Moments and momenta at the ends of the range of doubles give what those near one do.
#[test]
fn scale_does_not_matter() {
    let (moments, momentum) = (DVec3::new(1.0, 2.0, 2.5), DVec3::new(0.4, -1.6, 1.2));
    let reference = drift(moments, Rotation::IDENTITY, momentum, 5.0);
    for (i, l) in
        [(2f64.powi(-600), 2f64.powi(-500)), (2f64.powi(700), 2f64.powi(650)), (2f64.powi(-40), 2f64.powi(200))]
    {
        let scaled = drift(moments * i, Rotation::IDENTITY, momentum * l, 5.0 * i / l);
        assert_eq!(scaled, reference);
    }
}

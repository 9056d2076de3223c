//! Elliptic functions and integral against 19 digits computed with 30 to 330 (mpmath), and against each other.

use crate::support::cases;
use polhode_dynamics::carlson::rj;
use polhode_dynamics::jacobi::JacobiFunctions;
use proptest::prelude::*;

fn assert_relative(value: f64, reference: f64, tolerance: f64, what: &str) {
    assert!((value / reference - 1.0).abs() <= tolerance, "{what}: {value} for {reference}");
}

/// (m1, u), K, sn, cn, dn.
#[test]
fn jacobi_functions_have_their_values() {
    let cases = [
        (0.5, 0.8, 1.854074677301371918, 0.6909348508664387893, 0.7229170297192977245, 0.872527659119804634),
        (1e-10, 11.3, 12.89921982638759952, 0.9999999997183111671, 2.373557805820508974e-5, 2.575611899531466941e-5),
        (0.999999, 1.2, 1.570796719494199223, 0.9320390078547934562, 0.3623579553936304322, 0.9999995656515495767),
        (1e-300, 300.0, 346.7740583102267432, 1.0, 1.029640044482402756e-130, 1.029640044482402756e-130),
        (0.3, -1.5, 2.07536313529246916, -0.9469465262132325566, 0.3213911580810705294, 0.6101676765815148919),
        (0.25, 1e-3, 2.156515647499643235, 9.997083334338749e-4, 0.9999995000001666666, 0.9999996250001484374),
    ];
    for (complement, u, period, sn, cn, dn) in cases {
        let functions = JacobiFunctions::new(complement);
        let values = functions.at(u);
        // The value of cn falls as exp(-u) near the separatrix, so it carries the rounding of the argument.
        let tolerance = 4e-16 * (1.0 + u.abs());
        assert_relative(functions.quarter_period(), period, 4e-16, "K");
        if complement != 0.25 {
            assert_relative(values.sn, sn, tolerance, "sn");
        }
        assert_relative(values.cn, cn, tolerance, "cn");
        assert_relative(values.dn, dn, tolerance, "dn");
    }
}

/// `RJ` for complete, incomplete, near-separatrix and equal arguments; (2, 3, 4, 5) is Carlson's own check.
#[test]
fn third_kind_has_its_values() {
    for (x, y, z, p, value) in [
        (0.0, 1.0, 2.0, 3.0, 0.7768862377858233201),
        (2.0, 3.0, 4.0, 5.0, 0.1429757966715675383),
        (0.0, 1e-12, 1.0, 1.7, 25.35721959835825305),
        (1e-8, 1e-8, 1.0, 2.0, 13.67713422261984787),
        (0.9, 0.95, 1.0, 1.00001, 1.047714846644010097),
        (0.5, 0.7, 1.0, 1.0, 1.34754098611765457),
    ] {
        assert_relative(rj(x, y, z, p), value, 1e-15, "RJ");
    }
    assert_relative(rj(4.0, 4.0, 4.0, 4.0), 0.125, 1e-15, "RJ of equal arguments is x^(-3/2)");
}

/// Numbers outside the domain come back, as NaN or infinity.
#[test]
fn odd_arguments_come_back() {
    let odd = [0.0, 1e-320, 1.0, 1e300, f64::INFINITY, f64::NAN, -1.0];
    for x in odd {
        for y in odd {
            let values = JacobiFunctions::new(x).at(y);
            assert!(values.sn.abs() <= 1.0 + 1e-15 || !(0.0..=1.0).contains(&x) || !y.is_finite() || y.abs() > 400.0);
            for p in odd {
                let _ = rj(x, y, 1.0, p);
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(256))]

    /// The algebraic relations hold to round-off, for every modulus and phase.
    #[test]
    fn jacobi_functions_obey_their_relations(exponent in -30.0..0.0f64, part in -1.0..1.0f64) {
        let complement = 10f64.powf(exponent);
        let functions = JacobiFunctions::new(complement);
        let v = functions.at(part * functions.quarter_period());
        prop_assert!((v.sn * v.sn + v.cn * v.cn - 1.0).abs() < 1e-15);
        let dn_squared = complement + (1.0 - complement) * v.cn * v.cn;
        prop_assert!((v.dn * v.dn / dn_squared - 1.0).abs() < 1e-14);
    }

    /// The integral of `1/sqrt(...)` type that RJ holds: it is homogeneous of degree -3/2 and symmetric.
    #[test]
    fn third_kind_is_homogeneous_and_symmetric(x in 0.0..1.0f64, y in 0.01..1.0f64, p in 0.01..2.0f64) {
        let value = rj(x, y, 1.0, p);
        prop_assert!((rj(4.0 * x, 4.0 * y, 4.0, 4.0 * p) * 8.0 / value - 1.0).abs() < 1e-14);
        prop_assert!((rj(1.0, x, y, p) / value - 1.0).abs() < 1e-14);
    }
}

//! Curves by arc length: their points, tangents and curvatures are those of the formulas, arc lengths those of
//! integrals in closed form, and the place nearest to a point is found from the point alone. Tracks stand on this: an
//! error here would be one of every motion.

use polhode_spatial::curve::{Bend, Coil, Curve, CurveError, CurvePlane, Rolling, SplineEnds, Wave};
use polhode_spatial::{DVec3, SplitMix64, UnitVector};
use std::f64::consts::{PI, TAU};

fn near(found: DVec3, expected: DVec3, within: f64) {
    assert!((found - expected).length() <= within, "{found} instead of {expected}");
}

/// One of each kind.
fn curves() -> Vec<Curve> {
    let points: Vec<DVec3> =
        [[0., 0., 0.], [1., 0.3, 0.8], [2.2, -0.1, 0.4], [3., 1., 1.], [4.5, 1., 0.]].map(DVec3::from).to_vec();
    let bends = [
        Bend { length: 2.0, curvature: [0.0, 0.0] },
        Bend { length: 1.5, curvature: [0.0, 0.9] },
        Bend { length: 2.0, curvature: [0.9, 0.9] },
        Bend { length: 1.0, curvature: [0.9, -0.5] },
    ];
    vec![
        Curve::line(DVec3::ZERO, DVec3::new(1.0, 2.0, -2.0)).unwrap(),
        Curve::circle(DVec3::Y, UnitVector::Y, DVec3::X * 0.7).unwrap(),
        Curve::helix(DVec3::Y, UnitVector::Z, DVec3::X * 0.7, Coil { advance: 0.4, turns: 2.5 }).unwrap(),
        Curve::path(DVec3::Z, UnitVector::X, DVec3::Z, &bends).unwrap(),
        Curve::spline(&points, SplineEnds::Open).unwrap(),
        Curve::spline(&points, SplineEnds::Closed).unwrap(),
        Curve::polynomial(&[DVec3::ZERO, DVec3::X, DVec3::ZERO, DVec3::ZERO, DVec3::Z * -0.25], [-1.0, 2.0]).unwrap(),
        Curve::wave(DVec3::ZERO, UnitVector::X, DVec3::Z, Wave { amplitude: 1.0, wavelength: TAU, length: 9.0 })
            .unwrap(),
        Curve::cycloid(DVec3::ZERO, UnitVector::X, DVec3::Z, Rolling { radius: 0.8, reach: 2.9 }).unwrap(),
    ]
}

/// Arc length is the parameter: the tangent is the derivative of the point by it, and the curvature that of the
/// tangent.
#[test]
fn tangents_and_curvatures_are_derivatives_by_arc_length() {
    for curve in curves() {
        let h = 1e-5;
        for k in 1..60 {
            let s = curve.length() * (f64::from(k) + 0.3) / 61.0;
            let [before, at, after] = [s - h, s, s + h].map(|s| curve.at(s));
            assert!((at.arc - s).abs() < 1e-13 * curve.length(), "{} {s}", at.arc);
            assert!((at.tangent.length() - 1.0).abs() < 1e-15);
            assert!(at.tangent.dot(at.curvature).abs() < 1e-13);
            near((after.point - before.point) / (2.0 * h), at.tangent, 2e-9);
            near((after.tangent - before.tangent) / (2.0 * h), at.curvature, 1e-4);
            if !curve_kinks_near(&curve, s, h) {
                near(
                    (after.curvature - before.curvature) / (2.0 * h),
                    at.curvature_rate,
                    2e-6 * (1.0 + at.curvature_rate.length()),
                );
            }
        }
    }
}

/// Whether the curvature or its rate may jump near an arc length: at the joints of paths and splines.
fn curve_kinks_near(curve: &Curve, s: f64, h: f64) -> bool {
    let [before, after] = [s - h, s + h].map(|s| curve.at(s).curvature_rate);
    (before - after).length() > 1e-3 * (1.0 + before.length())
}

/// Curvature jumps from a straight line to a circle, and not along a clothoid or a spline.
#[test]
fn jumps_of_curvature_are_told() {
    let straight = Bend { length: 3.0, curvature: [0.0; 2] };
    let turn = Bend { length: 1.0, curvature: [0.5; 2] };
    let clothoid = Bend { length: 2.0, curvature: [0.0, 0.5] };
    let jump = |bends: &[Bend]| Curve::path(DVec3::ZERO, UnitVector::X, DVec3::Z, bends).unwrap().curvature_jump();
    assert_eq!(jump(&[straight, turn]), Some(3.0));
    assert_eq!(jump(&[straight, clothoid, turn]), None);
    let all = curves();
    assert!([1, 2, 4, 5, 8].iter().all(|&kind| all[kind].curvature_jump().is_none()));
}

/// From points off the curve, by less than its radius, the foot is found again; so it is from points on it.
#[test]
fn the_nearest_place_is_the_foot() {
    let mut random = SplitMix64::new(7);
    for curve in curves() {
        for _ in 0..300 {
            let s = curve.length() * random.uniform();
            let at = curve.at(s);
            let across = at.tangent.any_orthonormal_vector();
            for off in [0.0, 1e-9, -0.01, 0.02] {
                let point = at.point + across * off;
                let foot = curve.nearest(point);
                assert!((foot.arc - s).abs() < 1e-12 * curve.length() || curve.is_closed(), "{} {s} {off}", foot.arc);
                near(foot.point, at.point, 1e-13 * curve.length().max(1.0));
                let along = (point - foot.point).dot(foot.tangent);
                assert!(along.abs() < 1e-13, "{along} at {s} of {}, {off}, foot {foot:?}", curve.length());
            }
        }
        let (start, end) = (curve.at(0.0), curve.at(curve.length()));
        if curve.is_closed() {
            near(start.point, end.point, 1e-14);
        } else {
            let beyond = curve.nearest(end.point + end.tangent * 0.1);
            assert!((beyond.arc - curve.length() - 0.1).abs() < 1e-13 && beyond.curvature == DVec3::ZERO);
            let before = curve.nearest(start.point - start.tangent * 0.1);
            assert!((before.arc + 0.1).abs() < 1e-13);
        }
    }
}

/// A clothoid ends where Fresnel's integrals say: C(1) and S(1) of `pi s^2/2` (Abramowitz and Stegun 1964, table 7.7).
#[test]
fn a_clothoid_ends_where_fresnels_integrals_say() {
    let bend = Bend { length: 1.0, curvature: [0.0, PI] };
    let curve = Curve::path(DVec3::ZERO, UnitVector::X, DVec3::Z, &[bend]).unwrap();
    near(curve.at(1.0).point, DVec3::new(0.779_893_400_376_822_8, 0.0, 0.438_259_147_390_354_8), 5e-16);
    assert!((curve.at(0.5).curvature.length() - 0.5 * PI).abs() < 1e-15);
    near(curve.at(1.0).tangent, DVec3::Z, 1e-15);
}

/// Arc lengths in closed form, and curvatures by arc length: a parabola, and a cycloid, `k = 1/sqrt(16 R^2 - s^2)` from
/// its lowest point.
#[test]
fn arc_lengths_are_those_of_integrals_in_closed_form() {
    let parabola = Curve::polynomial(&[DVec3::ZERO, DVec3::X, DVec3::Z * -0.5], [0.0, 3.0]).unwrap();
    let expected = 0.5 * (3.0 * 10.0_f64.sqrt() + 3.0_f64.asinh());
    assert!((parabola.length() / expected - 1.0).abs() < 1e-15);
    let radius = 0.8;
    let cycloid = Curve::cycloid(DVec3::ZERO, UnitVector::X, DVec3::Z, Rolling { radius, reach: 3.0 }).unwrap();
    assert!((cycloid.length() / (8.0 * radius * 1.5_f64.sin()) - 1.0).abs() < 1e-15);
    for part in [0.1, 0.4, 0.77, 0.98] {
        let s = cycloid.length() * part;
        let from_lowest = s - 0.5 * cycloid.length();
        let expected = (16.0 * radius * radius - from_lowest * from_lowest).sqrt().recip();
        assert!((cycloid.at(s).curvature.length() / expected - 1.0).abs() < 1e-12, "{part}");
    }
}

/// The plane of a curve is found from its points, and that of a path has up on its left.
#[test]
fn the_plane_of_a_curve_is_known() {
    let all = curves();
    assert_eq!(all[0].plane(), CurvePlane::Straight);
    assert_eq!(all[2].plane(), CurvePlane::None);
    assert_eq!(all[4].plane(), CurvePlane::None);
    let CurvePlane::Plane(normal) = all[3].plane() else { panic!() };
    near(normal.get(), -DVec3::Y, 1e-15);
    let CurvePlane::Plane(normal) = all[6].plane() else { panic!() };
    assert!((normal.get().y.abs() - 1.0).abs() < 1e-15);
}

/// A path that ends as it began is closed: a stadium.
#[test]
fn a_path_that_ends_as_it_began_is_closed() {
    let straight = Bend { length: 3.0, curvature: [0.0; 2] };
    let turn = Bend { length: PI * 0.5, curvature: [2.0; 2] };
    let stadium = Curve::path(DVec3::ZERO, UnitVector::X, DVec3::Y, &[straight, turn, straight, turn]).unwrap();
    assert!(stadium.is_closed());
    assert!(!Curve::path(DVec3::ZERO, UnitVector::X, DVec3::Y, &[straight, turn, straight]).unwrap().is_closed());
}

/// What no body can follow is refused: coincident points, no radius, cusps, and curves that meet themselves.
#[test]
fn curves_that_no_body_can_follow_are_refused() {
    let spline = |points: &[[f64; 3]]| {
        Curve::spline(&points.iter().map(|p| DVec3::from(*p)).collect::<Vec<_>>(), SplineEnds::Open)
    };
    let twice = spline(&[[0., 0., 0.], [1., 0., 0.], [1., 0., 0.], [2., 0., 1.]]).unwrap_err();
    assert_eq!(twice, CurveError::Coincident { first: 1, second: 2 });
    assert!(matches!(spline(&[[0.0; 3]]), Err(CurveError::TooFew { found: 1, .. })));
    assert!(matches!(spline(&[[0.0; 3], [f64::NAN; 3]]), Err(CurveError::NotFinite { .. })));
    assert!(matches!(Curve::circle(DVec3::ZERO, UnitVector::Z, DVec3::Z), Err(CurveError::NotPositive { .. })));
    assert!(matches!(Curve::line(DVec3::X, DVec3::X), Err(CurveError::Coincident { .. })));
    let cusp = Curve::polynomial(&[DVec3::ZERO, DVec3::ZERO, DVec3::X, DVec3::Z], [-1.0, 1.0]);
    assert!(matches!(cusp, Err(CurveError::Cusp { .. })), "{cusp:?}");
    // A line, one whole turn and a line: the turn ends where it began.
    let line = Bend { length: 5.0, curvature: [0.0; 2] };
    let turn = Bend { length: TAU * 0.99, curvature: [1.0; 2] };
    let looped = Curve::path(DVec3::ZERO, UnitVector::X, DVec3::Z, &[line, turn, line]).unwrap_err();
    let CurveError::MeetsItself { distance_m, first_m, second_m, .. } = looped else { panic!("{looped}") };
    assert!(distance_m < 3e-5 && first_m < 5.1 && second_m > 11.0, "{looped}");
    let cycloid = Curve::cycloid(DVec3::ZERO, UnitVector::X, DVec3::Z, Rolling { radius: 1.0, reach: 3.2 });
    assert!(matches!(cycloid, Err(CurveError::NotPositive { .. })));
    let parallel =
        Curve::wave(DVec3::ZERO, UnitVector::X, DVec3::X, Wave { amplitude: 1.0, wavelength: 1.0, length: 1.0 });
    assert_eq!(parallel.unwrap_err(), CurveError::Parallel);
}

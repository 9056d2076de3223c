//! Impacts with friction at one contact: the cases of the catalogue, and references of 25 digits in space.
//!
//! The rod (IM-07) and the double pendulum (IM-08) are in a plane, where the path of an impact is made of straight
//! pieces; the numbers pin every law with slip, stick and reversal. In space slip turns; the references there were
//! integrated with mpmath in the components of the slip, not in its direction as here.

use polhode_response::RestitutionLaw::{self, ChatterjeeRuina, Newton, Poisson, Stronge, Whittaker};
use polhode_response::{
    CollisionMatrix, ContactProblem, FrictionalImpact, FrictionalImpactStatus, PhaseKind, ResponseError,
    SingleFrictionalImpact,
};

/// Relative tolerance of the catalogue for IM-07 and IM-08.
const CATALOGUE: f64 = 1e-11;

fn assert_each(found: &[f64], expected: &[f64], tolerance: f64, what: &str) {
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= tolerance * b.abs(), "{what}: {found:?} {expected:?}");
    }
}

/// A body in a plane on a contact: the normal and the tangent row over its generalised velocities, and the impact
/// there.
fn planar_impact(
    inverse_mass: &[f64],
    rows: [&[f64]; 2],
    velocities: &[f64],
    [friction, restitution]: [f64; 2],
    law: RestitutionLaw,
) -> (FrictionalImpact, Vec<f64>) {
    let mut problem = ContactProblem::new(velocities.len(), inverse_mass.to_vec()).unwrap();
    for row in rows {
        problem.push_row(&[(0, row)]).unwrap();
    }
    let delassus = problem.delassus();
    let u = problem.row_velocities(velocities).unwrap();
    let collision = CollisionMatrix::planar(delassus.get(0, 0), delassus.get(0, 1), delassus.get(1, 1)).unwrap();
    let velocity_before = [u[0], u[1], 0.0];
    let impact = SingleFrictionalImpact { collision, velocity_before, friction, restitution, law };
    let outcome = impact.resolve().unwrap();
    assert_eq!(outcome.impulse[2], 0.0);
    let change = problem.response(&outcome.impulse[..2]).unwrap();
    let after = velocities.iter().zip(change).map(|(before, change)| before + change).collect();
    (outcome, after)
}

/// Coefficient of friction, law, p_t, p_n, vx', vy', w', T'/T.
const ROD: [(f64, RestitutionLaw, [f64; 6]); 16] = [
    (0.0, Whittaker, [0.0, 0.6, 0.6, -0.4, -2.545_584_412_271_571, 0.779_411_764_705_882_4]),
    (0.0, Newton, [0.0, 0.6, 0.6, -0.4, -2.545_584_412_271_571, 0.779_411_764_705_882_4]),
    (0.0, Poisson, [0.0, 0.6, 0.6, -0.4, -2.545_584_412_271_571, 0.779_411_764_705_882_4]),
    (0.0, Stronge, [0.0, 0.6, 0.6, -0.4, -2.545_584_412_271_571, 0.779_411_764_705_882_4]),
    (
        0.1,
        Whittaker,
        [
            -0.056_603_773_584_905_66,
            0.566_037_735_849_056_6,
            0.543_396_226_415_094_3,
            -0.433_962_264_150_943_4,
            -2.641_644_201_413_894_3,
            0.783_181_161_393_001_5,
        ],
    ),
    (
        0.1,
        Newton,
        [
            -0.009_118_541_033_434_65,
            0.594_528_875_379_939_3,
            0.590_881_458_966_565_3,
            -0.405_471_124_620_060_8,
            -2.561_059_089_549_817_5,
            0.779_509_585_635_974_6,
        ],
    ),
    (
        0.1,
        Poisson,
        [
            -0.011_306_990_881_458_966,
            0.572_644_376_899_696,
            0.588_693_009_118_541,
            -0.427_355_623_100_303_95,
            -2.477_495_832_247_286,
            0.765_214_034_912_289_9,
        ],
    ),
    (
        0.1,
        Stronge,
        [
            -0.010_348_351_577_464_65,
            0.582_230_769_939_639_2,
            0.589_651_648_422_535_4,
            -0.417_769_230_060_360_76,
            -2.514_100_291_285_868,
            0.771_283_249_235_010_1,
        ],
    ),
    (0.5, Whittaker, [0.1875, 0.7125, 0.7875, -0.2875, -2.227_386_360_737_624_7, 0.820_772_058_823_529_4]),
    (
        0.5,
        Newton,
        [
            0.116_883_116_883_116_88,
            0.670_129_870_129_870_1,
            0.716_883_116_883_116_9,
            -0.329_870_129_870_129_87,
            -2.347_227_185_341_319,
            0.795_484_309_426_249_8,
        ],
    ),
    (
        0.5,
        Poisson,
        [
            0.070_129_870_129_870_13,
            0.576_623_376_623_376_6,
            0.670_129_870_129_870_1,
            -0.423_376_623_376_623_35,
            -2.148_869_958_411_066_4,
            0.744_945_085_472_205_4,
        ],
    ),
    (
        0.5,
        Stronge,
        [
            0.082_589_945_683_149_95,
            0.601_543_527_729_936_2,
            0.682_589_945_683_149_9,
            -0.398_456_472_270_063_76,
            -2.201_733_581_917_992,
            0.756_371_929_941_482_1,
        ],
    ),
    (1.0, Whittaker, [0.1875, 0.7125, 0.7875, -0.2875, -2.227_386_360_737_624_7, 0.820_772_058_823_529_4]),
    (1.0, Newton, [0.1875, 0.7125, 0.7875, -0.2875, -2.227_386_360_737_624_7, 0.820_772_058_823_529_4]),
    (1.0, Poisson, [0.12, 0.6, 0.72, -0.4, -2.036_467_529_817_256_8, 0.752_941_176_470_588_2]),
    (
        1.0,
        Stronge,
        [
            0.132_051_126_462_442_58,
            0.620_085_210_770_737_6,
            0.732_051_126_462_442_5,
            -0.379_914_789_229_262_36,
            -2.070_553_262_787_376,
            0.762_867_647_058_823_5,
        ],
    ),
];

/// Case IM-07: a slender rod of 1 kg and 1 m at 45 degrees falls on its lower end at 1 m/s down and 0.6 m/s sideways.
#[test]
fn rod_on_its_lower_end() {
    let arm = 0.5 * 0.5_f64.sqrt();
    for (friction, law, expected) in ROD {
        let (inertia, before) = (1.0 / 12.0, [0.6, -1.0, 0.0]);
        let inverse = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 / inertia];
        // The contact is at (-arm, -arm) from the centre of mass.
        let rows: [&[f64]; 2] = [&[0.0, 1.0, -arm], &[1.0, 0.0, arm]];
        let (outcome, after) = planar_impact(&inverse, rows, &before, [friction, 0.5], law);
        let kinetic = |v: &[f64]| 0.5 * (v[0] * v[0] + v[1] * v[1] + inertia * v[2] * v[2]);
        let ratio = kinetic(&after) / kinetic(&before);
        let found = [outcome.impulse[1], outcome.impulse[0], after[0], after[1], after[2], ratio];
        assert_each(&found, &expected, CATALOGUE, &format!("mu = {friction}, {law:?}"));
        let change = kinetic(&after) - kinetic(&before);
        assert!((outcome.energy_change - change).abs() < 1e-15, "{} {change}", outcome.energy_change);
        assert!(!outcome.energy_rises);
    }
}

/// Restitution, coefficient of friction, law, p_t, p_n, u1', u2', T'/T.
const PENDULUM: [(f64, f64, RestitutionLaw, [f64; 5]); 16] = [
    (
        0.5,
        0.5,
        Whittaker,
        [
            -0.244_596_591_022_635_98,
            0.567_979_880_483_606_6,
            -0.334_648_929_843_562_9,
            0.363_115_364_230_321,
            1.587_494_686_929_847,
        ],
    ),
    (
        0.5,
        0.5,
        Newton,
        [
            -0.009_093_690_872_089_043,
            0.213_100_033_925_077_93,
            -0.234_374_615_266_621_26,
            0.294_523_693_343_343_44,
            0.737_153_337_988_711_5,
        ],
    ),
    (
        0.5,
        0.5,
        Poisson,
        [
            0.040_597_960_082_086_81,
            0.113_716_732_016_726_22,
            -0.197_179_706_138_185_08,
            0.219_606_684_404_329_7,
            0.545_077_986_811_593_6,
        ],
    ),
    (
        0.5,
        0.5,
        Stronge,
        [
            0.038_256_481_853_955_5,
            0.118_399_688_472_988_85,
            -0.198_932_335_971_351,
            0.223_136_785_376_607_4,
            0.553_187_985_164_453_8,
        ],
    ),
    (
        0.7,
        0.5,
        Whittaker,
        [
            0.064_439_481_476_144_85,
            0.128_878_962_952_289_7,
            -0.220_465_421_836_607_06,
            0.338_690_050_415_414_33,
            0.636_471_288_060_087,
        ],
    ),
    (
        0.7,
        0.5,
        Newton,
        [
            -0.063_010_444_622_990_12,
            0.320_933_541_426_880_1,
            -0.274_732_074_070_201_4,
            0.375_810_626_764_890_7,
            0.992_954_021_361_061_5,
        ],
    ),
    (
        0.7,
        0.5,
        Poisson,
        [
            0.033_016_844_614_305_06,
            0.128_878_962_952_289_7,
            -0.202_854_279_139_922_46,
            0.231_036_260_286_025_6,
            0.571_673_120_358_995_6,
        ],
    ),
    (
        0.7,
        0.5,
        Stronge,
        [
            0.025_206_662_760_059_336,
            0.144_499_326_660_781_16,
            -0.208_700_311_597_429_7,
            0.242_811_185_299_674_8,
            0.600_091_694_265_105_3,
        ],
    ),
    (
        0.5,
        0.7,
        Whittaker,
        [
            -0.244_596_591_022_635_98,
            0.567_979_880_483_606_6,
            -0.334_648_929_843_562_9,
            0.363_115_364_230_321,
            1.587_494_686_929_847,
        ],
    ),
    (
        0.5,
        0.7,
        Newton,
        [
            -0.244_596_591_022_635_98,
            0.567_979_880_483_606_6,
            -0.334_648_929_843_562_9,
            0.363_115_364_230_321,
            1.587_494_686_929_847,
        ],
    ),
    (
        0.5,
        0.7,
        Poisson,
        [
            0.048_988_952_264_768_13,
            0.097_037_992_933_001_9,
            -0.190_966_501_596_954_5,
            0.207_210_794_953_337_38,
            0.516_949_100_103_040_4,
        ],
    ),
    (
        0.5,
        0.7,
        Stronge,
        [
            0.045_647_289_036_475_76,
            0.102_398_369_914_336_65,
            -0.192_601_930_513_675_44,
            0.208_985_339_300_589_66,
            0.525_841_273_628_757_7,
        ],
    ),
    (
        1.0,
        0.5,
        Whittaker,
        [
            0.075_811_154_677_817_47,
            0.151_622_309_355_634_95,
            -0.241_724_025_690_125_94,
            0.433_753_000_488_722_8,
            0.805_938_675_594_099_8,
        ],
    ),
    (
        1.0,
        0.5,
        Newton,
        [
            -0.143_885_575_249_341_73,
            0.482_683_802_679_583_33,
            -0.335_268_262_275_571_66,
            0.497_741_026_897_211_56,
            1.469_142_334_523_851_5,
        ],
    ),
    (
        1.0,
        0.5,
        Poisson,
        [
            0.021_645_171_412_632_443,
            0.151_622_309_355_634_95,
            -0.211_366_138_642_528_54,
            0.248_180_624_108_569_5,
            0.613_394_345_231_803_6,
        ],
    ),
    (
        1.0,
        0.5,
        Stronge,
        [
            0.001_964_207_739_846_018_6,
            0.190_984_236_701_207_82,
            -0.226_097_620_517_509_95,
            0.277_852_387_937_914_34,
            0.690_786_294_342_759_2,
        ],
    ),
];

/// Case IM-08: the double pendulum of Kane and Levinson hits a rough floor. Newton's law of restitution raises the
/// energy, along the path and as algebra, and says so; Poisson's and Stronge's do not.
#[test]
fn double_pendulum_on_a_rough_floor() {
    let mut rises = 0;
    for (restitution, friction, law, expected) in PENDULUM {
        // Two slender rods of 1 kg and 1 m; angles from the downward vertical.
        let (q1, q2) = (20.0_f64.to_radians(), 30.0_f64.to_radians());
        let coupling = 0.5 * (q1 - q2).cos();
        let mass = [4.0 / 3.0, coupling, coupling, 1.0 / 3.0];
        let determinant = mass[0] * mass[3] - mass[1] * mass[2];
        let inverse = [mass[3] / determinant, -mass[1] / determinant, -mass[2] / determinant, mass[0] / determinant];
        // The free end is at (sin q1 + sin q2, -cos q1 - cos q2).
        let rows: [&[f64]; 2] = [&[q1.sin(), q2.sin()], &[q1.cos(), q2.cos()]];
        let before = [-0.1, -0.2];
        let (outcome, after) = planar_impact(&inverse, rows, &before, [friction, restitution], law);
        let kinetic = |v: &[f64]| 0.5 * (mass[0] * v[0] * v[0] + mass[3] * v[1] * v[1]) + coupling * v[0] * v[1];
        let ratio = kinetic(&after) / kinetic(&before);
        let found = [outcome.impulse[1], outcome.impulse[0], after[0], after[1], ratio];
        assert_each(&found, &expected, CATALOGUE, &format!("e = {restitution}, mu = {friction}, {law:?}"));
        assert_eq!(outcome.energy_rises, expected[4] > 1.0);
        rises += usize::from(outcome.energy_rises);
    }
    assert_eq!(rises, 4);
}

/// Case IM-10: a solid sphere of 1 kg and 1 m at 1 m/s down and along, e = 1: it sticks, it slips, and as a super ball
/// (Garwin) it reverses its slip.
#[test]
fn super_ball() {
    let cases = [
        (1000.0, Stronge, [5.0 / 7.0, -5.0 / 7.0]),
        (1000.0, ChatterjeeRuina { tangential_restitution: 0.0 }, [5.0 / 7.0, -5.0 / 7.0]),
        (0.1, Stronge, [4.0 / 5.0, -1.0 / 2.0]),
        (0.1, ChatterjeeRuina { tangential_restitution: 1.0 }, [4.0 / 5.0, -1.0 / 2.0]),
        (1000.0, ChatterjeeRuina { tangential_restitution: 1.0 }, [3.0 / 7.0, -10.0 / 7.0]),
    ];
    for (friction, law, expected) in cases {
        let inverse = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.5];
        // Slip is vx + w r.
        let rows: [&[f64]; 2] = [&[0.0, 1.0, 0.0], &[1.0, 0.0, 1.0]];
        let (outcome, after) = planar_impact(&inverse, rows, &[1.0, -1.0, 0.0], [friction, 1.0], law);
        assert_each(&[after[0], after[1], after[2]], &[expected[0], 1.0, expected[1]], 1e-14, &format!("{law:?}"));
        assert_each(&[outcome.impulse[0]], &[2.0], 1e-15, "normal impulse");
        let garwin = expected[1] < -1.0;
        assert!(if garwin { outcome.energy_change.abs() < 1e-15 } else { outcome.energy_change < -0.1 });
    }
}

/// An impact in space with a direction of slip that turns, and its outcome by mpmath (Stronge).
struct Reference {
    matrix: [[f64; 3]; 3],
    before: [f64; 3],
    friction: f64,
    restitution: f64,
    after: [f64; 3],
    impulse: [f64; 3],
    normal_work: f64,
    phases: &'static [PhaseKind],
}

/// Twelve times the matrix of a body of 1 kg and moments (2, 3, 4) kg m^2, arm (-1/2, 1, 2) m along normal and
/// tangents.
const TILTED: [[f64; 3]; 3] = [
    [2.583_333_333_333_333_5, 0.125, 0.333_333_333_333_333_3],
    [0.125, 3.0625, -1.0],
    [0.333_333_333_333_333_3, -1.0, 1.583_333_333_333_333_3],
];
/// 1 kg, (1, 2, 5/2) kg m^2, (-1, 2, 1) m.
const LEANING: [[f64; 3]; 3] = [[3.1, 0.8, 0.5], [0.8, 2.4, -2.0], [0.5, -2.0, 5.5]];
/// 1 kg, (1/4, 1/2, 1/2) kg m^2, (-1, 3/4, -1/2) m.
const SLENDER: [[f64; 3]; 3] = [[2.625, 1.5, -1.0], [1.5, 4.0, 1.5], [-1.0, 1.5, 5.25]];

const REFERENCES: [Reference; 5] = [
    Reference {
        matrix: TILTED,
        before: [-1.0, 0.5, 0.25],
        friction: 0.3,
        restitution: 0.5,
        after: [0.498_514_861_806_854_7, 0.288_780_515_655_573_94, 0.393_472_077_233_755_16],
        impulse: [0.601_965_448_868_332_9, -0.132_698_998_912_577_1, -0.119_925_518_716_799_74],
        normal_work: -0.150_216_871_970_348_1,
        phases: &[PhaseKind::Slip],
    },
    Reference {
        matrix: TILTED,
        before: [-1.0, 0.125, -0.5],
        friction: 0.75,
        restitution: 0.5,
        after: [0.467_078_176_875_612_7, 0.0, 0.0],
        impulse: [0.541_371_789_748_259_8, 0.003_761_945_122_702_975_4, 0.204_192_430_656_810_34],
        normal_work: -0.132_644_289_428_970_9,
        phases: &[PhaseKind::Slip, PhaseKind::Stick],
    },
    Reference {
        matrix: LEANING,
        before: [-1.0, -0.25, -0.03125],
        friction: 0.125,
        restitution: 0.75,
        after: [0.726_614_398_995_075, 0.229_056_826_283_295_9, 0.130_582_522_348_248_66],
        impulse: [0.563_369_059_046_043_6, -0.009_099_492_347_175_104, -0.025_100_180_339_840_614],
        normal_work: -0.068_849_606_841_465_88,
        phases: &[PhaseKind::Slip],
    },
    Reference {
        matrix: SLENDER,
        before: [-0.5, 1.0, -0.5],
        friction: 2.5,
        restitution: 0.5,
        after: [0.538_569_133_335_185_7, 0.0, 0.0],
        impulse: [1.106_098_897_298_498_9, -0.873_049_448_649_249_4, 0.555_366_299_099_499_6],
        normal_work: -0.282_217_340_803_537,
        phases: &[PhaseKind::Jam, PhaseKind::Stick],
    },
    Reference {
        matrix: SLENDER,
        before: [0.0, 0.5, -1.0],
        friction: 2.5,
        restitution: 0.5,
        after: [0.209_508_570_045_261_63, 0.0, 0.0],
        impulse: [0.514_275_829_218_548_1, -0.477_137_914_609_274_07, 0.424_758_609_739_516],
        normal_work: -0.042_707_520_897_480_3,
        phases: &[PhaseKind::Jam, PhaseKind::Stick],
    },
];

/// Slip that turns, that stops, that turns right round, that jams, and a jam without a collision: to 1e-13.
#[test]
fn paths_in_space() {
    for reference in REFERENCES {
        let impact = SingleFrictionalImpact {
            collision: CollisionMatrix::new(reference.matrix).unwrap(),
            velocity_before: reference.before,
            friction: reference.friction,
            restitution: reference.restitution,
            law: Stronge,
        };
        let outcome = impact.resolve().unwrap();
        let kinds: Vec<PhaseKind> = outcome.phases.iter().map(|phase| phase.kind).collect();
        println!("{kinds:?} {outcome:?}");
        assert_each(&outcome.velocity_after, &reference.after, 1e-13, "velocity");
        assert_each(&outcome.impulse, &reference.impulse, 1e-13, "impulse");
        assert_each(&[outcome.normal_work], &[reference.normal_work], 1e-13, "work");
        assert_eq!(kinds, reference.phases);
        assert_eq!(outcome.status, FrictionalImpactStatus::Separated);
    }
}

/// A body on a ball joint whose arm lies in the cone of friction: it stops where it hits, and no law makes it rebound.
/// Outside the cone it rebounds.
#[test]
fn body_on_a_pivot_wedges() {
    // Arm (h, b, 0) from the pivot to the contact along normal and tangents, moments (1, 1, 1): K = |r|^2 - r r^T.
    for (b, wedges) in [(0.25, true), (2.0, false)] {
        let r = [1.0_f64, b, 0.0];
        let square: f64 = r.iter().map(|x| x * x).sum();
        let mut matrix = [[0.0; 3]; 3];
        for i in 0..3 {
            for j in 0..3 {
                matrix[i][j] = f64::from(u8::from(i == j)) * square - r[i] * r[j];
            }
        }
        // Angular velocity 1 about the second tangent: u = w x r.
        for law in [Stronge, Poisson, Newton] {
            let impact = SingleFrictionalImpact {
                collision: CollisionMatrix::new(matrix).unwrap(),
                velocity_before: [-b, 1.0, 0.0],
                friction: 0.5,
                restitution: 0.5,
                law,
            };
            let outcome = impact.resolve().unwrap();
            if wedges {
                assert_eq!(outcome.status, FrictionalImpactStatus::Wedged);
                assert!(outcome.velocity_after.iter().all(|u| u.abs() < 1e-15), "{outcome:?}");
            } else {
                assert_eq!(outcome.status, FrictionalImpactStatus::Separated);
                assert!(outcome.velocity_after[0] > 0.1, "{outcome:?}");
            }
            assert!(outcome.energy_change < 0.0);
        }
    }
}

/// Data out of range is refused with its value; extreme data does not panic.
#[test]
fn refuses_bad_data() {
    let collision = CollisionMatrix::planar(2.5, -1.5, 2.5).unwrap();
    let law = Stronge;
    let good =
        SingleFrictionalImpact { collision, velocity_before: [-1.0, 0.5, 0.0], friction: 0.5, restitution: 0.5, law };
    for friction in [-0.1, f64::NAN, f64::INFINITY] {
        let found = SingleFrictionalImpact { friction, ..good }.resolve();
        assert!(matches!(found, Err(ResponseError::Friction { .. })));
    }
    for restitution in [-0.1, 1.1, f64::NAN] {
        let found = SingleFrictionalImpact { restitution, ..good }.resolve();
        assert!(matches!(found, Err(ResponseError::Restitution { .. })));
    }
    let law = ChatterjeeRuina { tangential_restitution: 1.5 };
    let found = SingleFrictionalImpact { law, ..good }.resolve();
    assert!(matches!(found, Err(ResponseError::TangentialRestitution { .. })));
    let found = SingleFrictionalImpact { velocity_before: [f64::NAN, 0.0, 0.0], ..good }.resolve();
    assert!(matches!(found, Err(ResponseError::NotFinite { .. })));
    for matrix in [[0.0, 0.0, 1.0], [1.0, 2.0, 1.0], [1.0, 0.0, -1.0], [f64::NAN, 0.0, 1.0]] {
        assert!(CollisionMatrix::planar(matrix[0], matrix[1], matrix[2]).is_err(), "{matrix:?}");
    }
    for scale in [1e-300, 1e-150, 1e150, 1e300] {
        for friction in [0.0, 1e-300, 1e-10, 1e10, 1e300] {
            for law in [Stronge, Poisson, Newton, Whittaker] {
                let velocity_before = [-scale, 0.5, 1e-3];
                SingleFrictionalImpact { velocity_before, friction, law, ..good }.resolve().unwrap();
            }
        }
    }
}

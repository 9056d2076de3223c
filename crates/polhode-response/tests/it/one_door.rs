//! The one entry for rows: the same bodies asked for different things, each against its closed form; and what is no
//! problem is refused, or said to be unsolved, never answered.

use polhode_response::friction::ContactStatus;
use polhode_response::solve::impact::{BlockLaw, Blow, Impact, Strikes, strike};
use polhode_response::solve::removal::{Limits, remove};
use polhode_response::{
    Answer, Ask, Blocks, ContactProblem, ImpactLaw, ImpactSettings, ImpactStatus, Law, Memory, MultipleImpactLaw,
    Question, Resistance, ResistedPart, ResponseError, RestitutionLaw, RowProblem, SolverStatus, solve,
};

/// Gravity, m/s^2.
const G: f64 = 9.81;

/// A box of this mass (kg) and inertia (kg m^2) in a plane on two feet at `x = -1, 1`, its centre of mass `high` (m)
/// above them: rows along the normals, then along the floor.
fn on_two_feet(mass: f64, inertia: f64, high: f64) -> ContactProblem {
    let inverse = vec![1.0 / mass, 0.0, 0.0, 0.0, 1.0 / mass, 0.0, 0.0, 0.0, 1.0 / inertia];
    let mut problem = ContactProblem::new(3, inverse).unwrap();
    for x in [-1.0, 1.0] {
        problem.push_row(&[(0, &[0.0, 1.0, x])]).unwrap();
    }
    for _ in 0..2 {
        problem.push_held_row(&[(0, &[1.0, 0.0, high])]).unwrap();
    }
    problem
}

/// Blocks of both feet with this friction: cones, or sliding along the floor.
fn feet(law: impl Fn() -> Law) -> Blocks {
    let mut blocks = Blocks::default();
    for foot in 0..2 {
        blocks.push(law(), [foot, 2 + foot]);
    }
    blocks
}

/// Accelerations of the box's rows and its own where gravity is tilted by `slope` (tangent).
fn tilted(problem: &ContactProblem, slope: f64) -> (Vec<f64>, Vec<f64>) {
    let free = vec![slope * G, -G, 0.0];
    (problem.row_velocities(&free).unwrap(), free)
}

fn ask(problem: &ContactProblem, blocks: &Blocks, constants: &[f64], ask: Ask<'_>) -> Result<Answer, ResponseError> {
    let known = Question { blocks: Some(blocks), constants, ..Question::default() };
    solve(&RowProblem { rows: problem, joints: 0..0, known }, ask, &mut Memory::default())
}

/// On a slope below its friction the box stays: at rest, at an instant and as a certificate, with forces in the cones
/// that carry its weight. On a steeper one it slides with `slope - mu` of gravity, and there is no certificate.
#[test]
fn a_box_on_a_slope_stays_or_slides_whatever_is_asked() {
    let problem = on_two_feet(2.0, 1.0, 0.5);
    let friction = 0.5;
    let blocks = feet(|| Law::Cone { rows: 2, friction });
    for slope in [0.0, 0.2, 0.49, 0.6, 1.0] {
        let (constants, free) = tilted(&problem, slope);
        let is_held = slope <= friction;
        let sum = |own: &[f64]| own.iter().sum::<f64>();
        let asked = [Ask::Instant, Ask::Rest { free: &free }, Ask::Present, Ask::Step];
        for of in asked {
            let found = ask(&problem, &blocks, &constants, of).unwrap();
            assert_eq!(found.report.status, SolverStatus::Solved, "{of:?}");
            let acceleration = if is_held { 0.0 } else { (slope - friction) * G };
            assert!(found.velocities[2..].iter().all(|w| (w - acceleration).abs() < 1e-9), "{slope} {of:?}: {found:?}");
            assert!((sum(&found.reactions[..2]) - 2.0 * G).abs() < 1e-9);
            let along = 2.0 * G * slope.min(friction);
            assert!((sum(&found.reactions[2..]) + along).abs() < 1e-9);
            // Of feet that are held, one may be at the limit of its cone: their parts of the load are not unique.
            let slides = found.statuses.iter().all(|own| *own == ContactStatus::Slide);
            assert_eq!(slides, !is_held, "{slope} {of:?}: {:?}", found.statuses);
        }
        let certificate = ask(&problem, &blocks, &constants, Ask::Balance { free: &free }).unwrap();
        assert_eq!(certificate.report.status == SolverStatus::Solved, is_held, "{slope}: {certificate:?}");
    }
}

/// At a stage the modes are given: both feet slide, and with the friction that their normal forces bring they hold the
/// box upright: `f_1 + f_2 = m g` and no moment. Twice the height asks for twice the difference.
#[test]
fn feet_that_slide_bear_what_their_friction_turns() {
    for high in [0.0, 0.5, 1.0] {
        let problem = on_two_feet(2.0, 1.0, high);
        let friction = 0.3;
        let blocks = feet(|| Law::Slide { friction });
        let (constants, _) = tilted(&problem, 0.0);
        let found = ask(&problem, &blocks, &constants[..2], Ask::Stage).unwrap();
        let [left, right, a, b] = found.reactions[..] else { panic!("{found:?}") };
        assert!((left + right - 2.0 * G).abs() < 1e-12);
        assert!((right - left - friction * 2.0 * G * high).abs() < 1e-12, "{high}: {left} {right}");
        assert!((a + friction * left).abs() < 1e-12 && (b + friction * right).abs() < 1e-12);
        assert!(!found.beyond_cones && found.on_bodies.is_none());
    }
}

/// A ball that rolls already is slowed by its friction of rolling: the row along which it turns comes last, and bears
/// that part of the normal force.
#[test]
fn a_rotation_that_turns_bears_its_part_of_the_normal_force() {
    let (mass, friction) = (2.0, 0.02);
    let mut problem = ContactProblem::new(2, vec![1.0 / mass, 0.0, 0.0, 1.0]).unwrap();
    problem.push_row(&[(0, &[1.0, 0.0])]).unwrap();
    problem.push_held_row(&[(0, &[0.0, 1.0])]).unwrap();
    let mut blocks = Blocks::default();
    blocks.push(Law::Cone { rows: 1, friction: 0.0 }, [0]);
    blocks.resist(ResistedPart::Rolling, Resistance { rows: 1, friction, slides: true }, [1]);
    let found = ask(&problem, &blocks, &[-G], Ask::Stage).unwrap();
    assert!((found.reactions[0] - mass * G).abs() < 1e-12);
    assert!((found.reactions[1] + friction * mass * G).abs() < 1e-12);
}

/// Flat on both feet at 1 m/s with restitution 0.5, and along the floor at 0.1 m/s: friction stops the slip, and the
/// box leaves at half its speed. Without friction it keeps its slip.
#[test]
fn a_box_that_falls_flat_leaves_at_its_restitution() {
    let problem = on_two_feet(2.0, 1.0, 0.0);
    let before = [-1.0, -1.0, 0.1, 0.1];
    let blocks = feet(|| Law::Cone { rows: 2, friction: 0.5 });
    let by = BlockLaw {
        blocks: &blocks,
        blow: Blow::Collision,
        noise_floor: 0.0,
        stand_for_several: &[],
        law: MultipleImpactLaw::default(),
        single: RestitutionLaw::default(),
        threshold: None,
    };
    let (memory, law) = (&mut Memory::default(), Strikes::Blocks(by));
    let impact = Impact { rows: &problem, before: &before, restitution: &[0.5, 0.5], law };
    let struck = strike(&impact, memory).unwrap();
    for restitution in [&[0.5][..], &[0.5; 3]] {
        let refused = strike(&Impact { restitution, ..impact }, memory);
        assert!(matches!(refused, Err(ResponseError::Length { expected: 2, .. })), "{refused:?}");
    }
    let law = Strikes::Blocks(BlockLaw { blow: Blow::Jam(&[0.0; 3]), ..by });
    let refused = strike(&Impact { law, ..impact }, memory);
    assert!(matches!(refused, Err(ResponseError::Length { expected: 4, found: 3, .. })), "{refused:?}");
    assert_eq!(struck.outcome.status, ImpactStatus::Separated);
    let after: Vec<f64> = before.iter().zip(&struck.changes).map(|(before, change)| before + change).collect();
    for (found, expected) in after.iter().zip([0.5, 0.5, 0.0, 0.0]) {
        assert!((found - expected).abs() < 1e-9, "{after:?}");
    }
    let mut smooth = ContactProblem::new(3, vec![0.5, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 1.0]).unwrap();
    for x in [-1.0, 1.0] {
        smooth.push_row(&[(0, &[0.0, 1.0, x])]).unwrap();
    }
    let law = Strikes::Rows { law: ImpactLaw::Reflection, order: None, settings: &ImpactSettings::default() };
    let impact = Impact { rows: &smooth, before: &before[..2], restitution: &[0.5, 0.5], law };
    let outcome = strike(&impact, memory).unwrap().outcome;
    assert!(outcome.velocities_after.iter().all(|u| (u - 0.5).abs() < 1e-12), "{outcome:?}");
}

/// Gaps of rows that hold are taken out by the least reactions; where that would move a body by more than is allowed,
/// only a part is, and the rest is told.
#[test]
fn gaps_are_removed_as_far_as_is_allowed() {
    let mut problem = ContactProblem::new(1, vec![0.5]).unwrap();
    for _ in 0..2 {
        problem.push_held_row(&[(0, &[1.0])]).unwrap();
    }
    let change_of = |response: &[f64]| response[0].abs();
    let with = |allowed: f64| {
        let limits = Limits { allowed, negligible: 0.0, opened: 0.0 };
        remove((&problem, 0..2), &[1e-3, 1e-3], limits, change_of).unwrap()
    };
    let whole = with(1.0);
    // Both rows ask for the same: their sum is exact, and each has its half to what the factor leaves of rows that
    // depend on each other.
    let [first, second] = whole.reactions[..] else { panic!("{whole:?}") };
    assert!(!whole.is_partial && (first + second + 2e-3).abs() < 1e-12, "{whole:?}");
    assert!((first - second).abs() < 1e-8, "the least reactions are shared: {whole:?}");
    let part = with(1e-4);
    assert!(part.is_partial && change_of(&problem.response(&part.reactions).unwrap()) <= 1e-4 * (1.0 + 1e-12));
}

/// Many boxes beside each other on two feet each: no matrix of their rows is formed. The boxes stand, with friction and
/// without, and what needs the matrix is refused.
#[test]
fn of_too_many_rows_no_matrix_is_formed() {
    let (boxes, mass) = (1500, 2.0);
    let one = [1.0 / mass, 0.0, 0.0, 0.0, 1.0 / mass, 0.0, 0.0, 0.0, 1.0];
    let rows_of = |friction: bool| {
        let mut problem = ContactProblem::new(3, one.repeat(boxes)).unwrap();
        for (body, x) in (0..boxes).flat_map(|body| [(body, -1.0), (body, 1.0)]) {
            let normal: &[(usize, &[f64])] = &[(body, &[0.0, 1.0, x])];
            let tangent: &[(usize, &[f64])] = &[(body, &[1.0, 0.0, 1.0])];
            if friction {
                problem.push_block(Law::Cone { rows: 2, friction: 0.5 }, &[normal, tangent]).unwrap();
            } else {
                problem.push_row(normal).unwrap();
                problem.push_row(normal).unwrap();
            }
        }
        problem
    };
    let memory = &mut Memory::default();
    for friction in [true, false] {
        let problem = rows_of(friction);
        let pushed = |row: usize| if !friction || row.is_multiple_of(2) { -G } else { 0.1 * G };
        let constants: Vec<f64> = (0..problem.len()).map(pushed).collect();
        let asked = RowProblem::new(&problem, &constants);
        for ask in [Ask::Instant, Ask::Displacement { accuracy: 1e-9 }] {
            let found = solve(&asked, ask, memory).unwrap();
            assert_eq!(found.report.status, SolverStatus::Solved, "{ask:?}: {:?}", found.report);
            let moved = found.velocities.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
            assert!(moved < 1e-8 * G, "{ask:?}, friction {friction}: {moved}");
        }
        for ask in [Ask::HoldAll, Ask::LeastForce] {
            let refused = solve(&asked, ask, memory);
            assert_eq!(refused, Err(ResponseError::TooManyRows { rows: 6000, limit: 4000 }), "{ask:?}");
        }
    }
}

/// Reactions that overflow are no numbers, and hold nothing.
#[test]
fn rows_whose_reactions_overflow_are_not_said_to_be_held() {
    let mut problem = ContactProblem::new(1, vec![1e-310]).unwrap();
    problem.push_held_row(&[(0, &[1.0])]).unwrap();
    for ask in [Ask::Hold, Ask::HoldAll] {
        let found = solve(&RowProblem::new(&problem, &[1e200]), ask, &mut Memory::default()).unwrap();
        assert_ne!(found.report.status, SolverStatus::Solved, "{ask:?}: {found:?}");
    }
}

/// What is no problem: numbers that are none, lists of another length, blocks of rows that do not exist, rows that
/// contradict each other. Errors name what is wrong; a contradiction is no error, and is not solved.
#[test]
fn what_is_no_problem_is_refused_or_said_to_be_unsolved() {
    let problem = on_two_feet(2.0, 1.0, 0.5);
    let blocks = feet(|| Law::Cone { rows: 2, friction: 0.5 });
    let free = [0.0; 3];
    let asked = [Ask::Instant, Ask::Present, Ask::Rest { free: &free }, Ask::Balance { free: &free }, Ask::Step];
    let asked = asked.into_iter().chain([Ask::Stage, Ask::Displacement { accuracy: 1e-9 }]);
    for of in asked {
        let nan = ask(&problem, &blocks, &[f64::NAN, 0.0, 0.0, 0.0], of);
        assert!(matches!(nan, Err(ResponseError::NotFinite { .. })), "{of:?}: {nan:?}");
        let short = ask(&problem, &blocks, &[0.0; 2], of);
        assert!(matches!(short, Err(ResponseError::Length { .. })), "{of:?}: {short:?}");
        let mut unknown = Blocks::default();
        unknown.push(Law::Push, [7]);
        let unknown = ask(&problem, &unknown, &[0.0; 4], of);
        assert!(matches!(unknown, Err(ResponseError::UnknownRow { row: 7, rows: 4 })), "{of:?}: {unknown:?}");
        let negative = feet(|| Law::Cone { rows: 2, friction: -0.5 });
        let negative = ask(&problem, &negative, &[0.0; 4], of);
        assert!(matches!(negative, Err(ResponseError::Friction { .. })), "{of:?}: {negative:?}");
        let none = ContactProblem::new(3, vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]).unwrap();
        let empty = ask(&none, &Blocks::default(), &[], of).unwrap();
        assert!(empty.reactions.is_empty(), "{of:?}: {empty:?}");
    }
    // A row without a block would be held by one method and left alone by another; so would one in two blocks.
    let mut half = Blocks::default();
    half.push(Law::Cone { rows: 2, friction: 0.5 }, [0, 2]);
    let mut twice = feet(|| Law::Cone { rows: 2, friction: 0.5 });
    twice.push(Law::Push, [0]);
    for (blocks, row, count) in [(half, 1, 0), (twice, 0, 2)] {
        let found = ask(&problem, &blocks, &[0.0; 4], Ask::Instant);
        assert_eq!(found, Err(ResponseError::BlocksOfRow { row, blocks: count }));
    }
    let beyond = RowProblem { joints: 0..9, ..RowProblem::new(&problem, &[0.0; 4]) };
    let found = solve(&beyond, Ask::Displacement { accuracy: 1e-9 }, &mut Memory::default());
    assert_eq!(found, Err(ResponseError::UnknownRow { row: 8, rows: 4 }));
    // Two rows of one body that ask for different velocities: no reactions keep both.
    let mut torn = ContactProblem::new(1, vec![1.0]).unwrap();
    for _ in 0..2 {
        torn.push_held_row(&[(0, &[1.0])]).unwrap();
    }
    let found = solve(&RowProblem::new(&torn, &[1.0, -1.0]), Ask::Instant, &mut Memory::default()).unwrap();
    assert_ne!(found.report.status, SolverStatus::Solved, "{found:?}");
}

/// Bodies that some force cannot move, as one on a rail, have no place where many contacts are solved for in the
/// velocities of bodies: the matrix of their rows answers, and nothing is refused.
#[test]
fn many_contacts_of_bodies_on_rails_are_answered_as_few_are() {
    let mut rails = ContactProblem::new(2, [0.5, 0.0, 0.0, 0.0].repeat(100)).unwrap();
    for body in 0..100 {
        rails.push_row(&[(body, &[1.0, 0.3])]).unwrap();
        rails.push_held_row(&[(body, &[0.0, 1.0])]).unwrap();
    }
    let mut blocks = Blocks::default();
    (0..100).for_each(|body| blocks.push(Law::Cone { rows: 2, friction: 0.5 }, [2 * body, 2 * body + 1]));
    let constants = [-1.0, 0.0].repeat(100);
    let mut smooth = ContactProblem::new(2, [0.5, 0.0, 0.0, 0.0].repeat(100)).unwrap();
    (0..100).for_each(|body| {
        smooth.push_row(&[(body, &[1.0, 0.3])]).unwrap();
    });
    for of in [Ask::Step, Ask::Present, Ask::Instant] {
        let found = ask(&rails, &blocks, &constants, of).unwrap();
        assert!(found.reactions.iter().step_by(2).all(|own| (own - 2.0).abs() < 1e-12), "{of:?}: {found:?}");
    }
    let asked = Ask::Displacement { accuracy: 1e-9 };
    let found = solve(&RowProblem::new(&smooth, &[-1.0; 100]), asked, &mut Memory::default()).unwrap();
    assert!(found.reactions.iter().all(|own| (own - 2.0).abs() < 1e-12), "{found:?}");
}

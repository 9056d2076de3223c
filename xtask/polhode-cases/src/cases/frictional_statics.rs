//! FC-09, FC-14, FC-15: ladders, card houses, wedges and rollers that friction holds or does not.
//!
//! A structure stands if forces within the cones of friction balance every body. Whether they exist shows in the
//! accelerations at the start, so that thresholds are found to the last bits without waiting for a fall.

use super::rough_plane::{is_in_equilibrium, rough, threshold};
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::contact::Shape;
use polhode::mesh::solid_sphere;
use polhode::scene::{Force, Frame, Material, PairRule, PrescribedMotion, Signal};
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, Scene, Simulation};
use polhode_oracles::random::Random;
use std::error::Error;

/// Tolerance of thresholds, as in the catalogue of cases.
const THRESHOLD: f64 = 1e-6;

/// Moment of inertia of a bar about itself, kg m^2.
const THIN_MOMENT: f64 = 1e-5;

/// Moment of inertia of a bar across itself, kg m^2.
const THICK_MOMENT: f64 = 7e-4;

/// A rule for two materials named after bodies.
fn pair(a: &str, b: &str, friction: f64) -> Result<PairRule, Box<dyn Error>> {
    Ok(PairRule::new([a.to_owned(), b.to_owned()]).with_friction(friction)?)
}

fn named(name: &str) -> Material {
    Material::new(name)
}

/// A half-space with this outward normal through a point, with a material of its name.
fn wall(name: &str, normal: DVec3, point: DVec3) -> Result<Body, Box<dyn Error>> {
    let shape = Shape::half_space(UnitVector::new(normal)?);
    Ok(Body::fixed(name).geometry(shape.into()).pose(Pose::from_translation(point)).material(named(name)))
}

/// A ladder of this length, 1 kg and 0.5 m of width at an angle (rad) to the floor, leaning at a wall to its left.
fn ladder(length: f64, angle: f64, floor: f64, at_wall: f64) -> Result<Scene, Box<dyn Error>> {
    // The ends of its two rails.
    let ends = [-0.5, 0.5].map(|side| [-0.5, 0.5].map(|rail| DVec3::new(side * length, 0.5 * rail, 0.0))).concat();
    let (across, width) = (length * length / 12.0, 0.0625);
    let moments = Inertia::from_diagonal(DVec3::new(width, across, across + width))?;
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, moments);
    // Turned about y by the angle, its left end rises.
    let center = DVec3::new(0.5 * length * angle.cos(), 0.0, 0.5 * length * angle.sin());
    let body = Body::movable("ladder", properties)
        .geometry(Shape::points(ends)?.into())
        .pose(Pose::new(Rotation::from_rotation_vector(DVec3::Y * angle), center))
        .material(named("ladder"));
    Ok(Scene::builder("ladder")
        .body(body)
        .body(wall("floor", DVec3::Z, DVec3::ZERO)?)
        .body(wall("wall", DVec3::X, DVec3::ZERO)?)
        .pair_rule(pair("ladder", "floor", floor)?)
        .pair_rule(pair("ladder", "wall", at_wall)?)
        .build()?)
}

/// The smallest angle to the floor at which a ladder stands, rad.
fn limit_angle(length: f64, floor: f64, at_wall: f64) -> Result<f64, Box<dyn Error>> {
    threshold(1.5, 0.1, |angle| is_in_equilibrium(&ladder(length, angle, floor, at_wall)?))
}

/// Ladders that lean at a wall with friction below and above.
pub(super) fn fc_09(context: &Context) -> CaseResult {
    /// Ladders at full count.
    const LADDERS: usize = 1000;
    let mut rows = Vec::new();
    for (floor, at_wall) in [(0.3, 0.0), (0.3, 0.4), (0.5, 0.5)] {
        let quantity = format!("mu1={floor}, mu2={at_wall}: limit angle to floor (deg)");
        let angle = limit_angle(1.0, floor, at_wall)?.to_degrees();
        rows.push(context.reference.row("FC-09", &quantity, angle)?);
    }
    let mut random = Random(9);
    let mut worst = 0.0f64;
    let count = context.amount.of(LADDERS);
    for _ in 0..count {
        let (floor, at_wall) = (random.between(0.1, 0.9), random.between(0.0, 0.9));
        let found = limit_angle(random.between(0.1, 10.0), floor, at_wall)?;
        worst = worst.max((found - ((1.0 - floor * at_wall) / (2.0 * floor)).atan()).abs());
    }
    rows.push(Row::at_most("FC-09", &format!("{count} ladders: error of the limit angle, rad"), THRESHOLD, worst));
    Ok(rows)
}

/// How the cards of a house are made.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Card {
    /// A rod with round ends, its centre of mass so placed that it stands for a card without thickness.
    Rod,
    /// A box of this thickness, m. Its lower inner edge stands on the floor, its upper inner edge touches the other.
    Box(f64),
}

/// Height of the cards, m.
const CARD_HEIGHT: f64 = 0.09;

impl Card {
    /// A card of 1 kg that leans towards the other one, which stands at +x for `side` -1.
    fn leaning(self, side: f64, lean: f64) -> Result<Body, Box<dyn Error>> {
        let mass = Mass::new(1.0)?;
        let turn = Rotation::from_rotation_vector(DVec3::Y * (-side * lean));
        let top = DVec3::Z * (CARD_HEIGHT * lean.cos());
        let half = DVec3::Z * (0.5 * CARD_HEIGHT);
        let (shape, properties, center) = match self {
            Self::Rod => {
                let radius = 0.001;
                // The moment of the weight about the lower contact is that of the push at the height of the upper one.
                let raised = DVec3::Z * (0.5 * radius / lean.cos());
                let moments = Inertia::from_diagonal(DVec3::new(THICK_MOMENT, THICK_MOMENT, THIN_MOMENT))?;
                let properties = MassProperties::new(mass, raised, moments);
                let upper = top + DVec3::new(side * radius, 0.0, radius);
                (Shape::capsule(radius, CARD_HEIGHT)?, properties, upper - turn.rotate(half))
            }
            Self::Box(thickness) => {
                let size = DVec3::new(thickness, 0.06, CARD_HEIGHT);
                let inner = DVec3::X * (-side * 0.5 * thickness);
                (Shape::cuboid(size)?, polhode::mesh::solid_box(size, mass)?, top - turn.rotate(inner + half))
            }
        };
        let body = Body::movable(if side < 0.0 { "left" } else { "right" }, properties).geometry(shape.into());
        Ok(body.pose(Pose::new(turn, center)).material(named("card")))
    }

    /// The least friction of the floor that holds two cards of 1 kg.
    fn least_friction(self, lean: f64) -> f64 {
        match self {
            Self::Rod => 0.5 * lean.tan(),
            // The weight acts at half the thickness outside of the inner face.
            Self::Box(thickness) => 0.5 * (lean.tan() - thickness / CARD_HEIGHT),
        }
    }
}

/// Two cards that lean on each other without friction between them.
fn card_house(card: Card, lean: f64, friction: f64) -> Result<Scene, Box<dyn Error>> {
    Ok(Scene::builder("card house")
        .body(card.leaning(-1.0, lean)?)
        .body(card.leaning(1.0, lean)?)
        .body(wall("floor", DVec3::Z, DVec3::ZERO)?)
        .pair_rule(pair("card", "floor", friction)?)
        .build()?)
}

/// The least friction of the floor under a card house, and the force with which its cards push each other.
pub(super) fn fc_14(context: &Context) -> CaseResult {
    let least = |card: Card, degrees: f64| {
        let lean = degrees.to_radians();
        threshold(1.0, 0.01, |friction| is_in_equilibrium(&card_house(card, lean, friction)?))
    };
    let scene = card_house(Card::Rod, 15.0f64.to_radians(), 0.5)?;
    let simulation = Simulation::new(&scene)?;
    let between = simulation.contacts().into_iter().filter(|contact| contact.body_b.index() < 2);
    let push: f64 = between.map(|contact| contact.normal_force_n).sum();
    let mut rows = vec![
        context.reference.row("FC-14", "mu_min at 15deg, 30deg", [least(Card::Rod, 15.0)?, least(Card::Rod, 30.0)?])?,
        context.reference.row("FC-14", "horizontal force / card weight at 15deg", push / super::bodies::GRAVITY)?,
    ];
    let card = Card::Box(0.002);
    for degrees in [8.0, 15.0, 20.0, 22.5, 25.0, 27.0, 29.0, 30.0, 31.0, 33.0, 35.0f64] {
        let quantity = format!("cards 2 mm thick: mu_min at {degrees}deg");
        let expected = card.least_friction(degrees.to_radians());
        rows.push(match least(card, degrees) {
            Ok(found) => Row::compared("FC-14", &quantity, expected, found, crate::row::Tolerance::Relative(THRESHOLD)),
            Err(error) => Row::broken("FC-14", &quantity, error.to_string()),
        });
    }
    Ok(rows)
}

/// Without gravity, a solid between two blocks that are pressed together by 1 N: a wedge, or a ball between plates at
/// the same angle. The faces of the blocks are inclined by `half` (rad) to the plane of symmetry.
fn squeezed(half: f64, friction: f64, is_wedge: bool) -> Result<Scene, Box<dyn Error>> {
    let mut scene = Scene::builder("squeezed").gravity(DVec3::ZERO);
    let radius = 0.2;
    let middle = if is_wedge {
        wedge(half)?
    } else {
        Body::movable("middle", solid_sphere(radius, Mass::new(1.0)?)?).geometry(Shape::sphere(radius)?.into())
    };
    scene = scene.body(middle.material(rough(friction)?));
    for (index, side) in [-1.0, 1.0].into_iter().enumerate() {
        // A plate beside the middle, turned about z by the angle of the face.
        let turn = Rotation::from_rotation_vector(DVec3::Z * (-side * half));
        let size = DVec3::new(0.1, 0.5, 0.5);
        let touching =
            if is_wedge { DVec3::X * (side * WEDGE_HALF_WIDTH) } else { turn.rotate(DVec3::X * (side * radius)) };
        let center = touching + turn.rotate(DVec3::X * (side * 0.5 * size.x));
        let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, Inertia::from_diagonal(DVec3::splat(0.1))?);
        let plate = Body::movable(if side < 0.0 { "left" } else { "right" }, properties)
            .geometry(Shape::cuboid(size)?.into())
            .pose(Pose::new(turn, center))
            .material(rough(friction)?);
        // Pressed along the line through both points of contact.
        let point = turn.inverse_rotate(touching - center);
        let press = Force::Applied {
            body: BodyId::new(index + 1),
            force: DVec3::X * -side,
            torque: DVec3::ZERO,
            frame: Frame::World,
            point: Some(point),
            signal: Signal::ONE,
        };
        scene = scene.body(plate).force(press);
    }
    Ok(scene.no_contact([1, 2].map(BodyId::new)).build()?)
}

/// Half the width of the wedge at half its height, m.
const WEDGE_HALF_WIDTH: f64 = 0.2;

/// A wedge of 1 kg that tapers towards -y, its faces at this angle (rad) to its plane of symmetry.
fn wedge(half: f64) -> Result<Body, Box<dyn Error>> {
    let (height, depth) = (0.4, 0.4);
    let widths = [-0.5, 0.5].map(|y: f64| WEDGE_HALF_WIDTH + y * height * half.tan());
    let mut points = Vec::new();
    for z in [-0.5 * depth, 0.5 * depth] {
        for (y, width) in [-0.5 * height, 0.5 * height].into_iter().zip(widths) {
            points.push(DVec3::new(-width, y, z));
            points.push(DVec3::new(width, y, z));
        }
    }
    let faces = vec![
        vec![0, 2, 3, 1],
        vec![4, 5, 7, 6],
        vec![0, 1, 5, 4],
        vec![2, 6, 7, 3],
        vec![0, 4, 6, 2],
        vec![1, 3, 7, 5],
    ];
    let shape = Shape::convex(polhode::contact::ConvexPolyhedron::from_faces(points, faces)?);
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, Inertia::from_diagonal(DVec3::splat(0.02))?);
    Ok(Body::movable("middle", properties).geometry(shape.into()))
}

/// A wedge that is driven between two walls which give way: its speed and force are steady, so that the faces bear
/// what balances the force.
fn driven_wedge(half: f64, friction: f64, force: f64) -> Result<Scene, Box<dyn Error>> {
    let retreat = 0.01;
    // Walls that retreat at this speed let the wedge in at `retreat/tan(half)`.
    let velocity = DVec3::Y * (-retreat / half.tan());
    let mut scene = Scene::builder("driven wedge").gravity(DVec3::ZERO);
    scene = scene.body(wedge(half)?.material(rough(friction)?).velocity(Velocity::new(velocity, DVec3::ZERO)));
    for side in [-1.0, 1.0] {
        let motion = PrescribedMotion::constant_velocity(Velocity::new(DVec3::X * (side * retreat), DVec3::ZERO))?;
        let inward = Rotation::from_rotation_vector(DVec3::Z * (side * -half)).rotate(DVec3::X * -side);
        let wall = Body::kinematic(if side < 0.0 { "left" } else { "right" }, motion)
            .geometry(Shape::half_space(UnitVector::new(inward)?).into())
            .pose(Pose::from_translation(DVec3::X * (side * WEDGE_HALF_WIDTH)))
            .material(rough(friction)?);
        scene = scene.body(wall);
    }
    let push = Force::Applied {
        body: BodyId::new(0),
        force: DVec3::Y * -force,
        torque: DVec3::ZERO,
        frame: Frame::World,
        point: None,
        signal: Signal::ONE,
    };
    Ok(scene.force(push).duration_s(0.1).build()?)
}

/// Wedges and rollers lock themselves where the tangent of half their angle is below the friction.
pub(super) fn fc_15(context: &Context) -> CaseResult {
    let half = 10.0f64.to_radians();
    let locks =
        |is_wedge: bool| threshold(0.5, 0.01, |friction| is_in_equilibrium(&squeezed(half, friction, is_wedge)?));
    let mut roller = context.reference.row("FC-15", "tan(10deg)", locks(false)?)?;
    "least friction that nips a ball between plates".clone_into(&mut roller.quantity);
    let mut wedge = context.reference.row("FC-15", "tan(10deg)", locks(true)?)?;
    "least friction that locks a wedge".clone_into(&mut wedge.quantity);
    let mut simulation = Simulation::new(&driven_wedge(half, 0.1, 1.0)?)?;
    simulation.advance_to(0.05)?;
    let at_left = simulation.contacts().into_iter().filter(|contact| contact.normal.x > 0.0);
    let force: f64 = at_left.map(|contact| contact.normal_force_n).sum();
    Ok(vec![
        wedge,
        roller,
        context.reference.row(
            "FC-15",
            "splits force: weightless wedge P, 2a=20deg, mu=0.1: side normal N = P/(2(sin a + mu cos a))",
            force,
        )?,
        Row::exact("FC-15", "wedge of 20 degrees locks at friction 0.17, 0.18", vec![false, true], {
            vec![is_in_equilibrium(&squeezed(half, 0.17, true)?)?, is_in_equilibrium(&squeezed(half, 0.18, true)?)?]
        }),
        Row::compared(
            "FC-15",
            "angle at which a wedge with friction 0.3 locks, rad",
            0.3f64.atan(),
            zero_of_lock(0.3)?,
            crate::row::Tolerance::Relative(THRESHOLD),
        ),
    ])
}

/// What stands by friction: ladders, card houses of two cards, wedges and balls between plates.
pub(crate) fn standing() -> Result<Vec<(String, Scene)>, Box<dyn Error>> {
    let mut all = Vec::new();
    for (floor, at_wall) in [(0.3, 0.0), (0.3, 0.4), (0.5, 0.5)] {
        let limit = f64::atan((1.0 - floor * at_wall) / (2.0 * floor));
        all.push((format!("ladder, friction {floor} and {at_wall}"), ladder(1.0, limit + 0.05, floor, at_wall)?));
    }
    for (name, card) in [("rods", Card::Rod), ("cards", Card::Box(0.002))] {
        all.push((format!("two {name} that lean"), card_house(card, 15.0f64.to_radians(), 0.5)?));
    }
    for (name, is_wedge) in [("wedge", true), ("ball", false)] {
        all.push((format!("{name} between plates"), squeezed(10.0f64.to_radians(), 0.3, is_wedge)?));
    }
    Ok(all)
}

/// The half angle (rad) above which a wedge of this friction is driven out.
fn zero_of_lock(friction: f64) -> Result<f64, Box<dyn Error>> {
    threshold(0.05, 0.6, |half| is_in_equilibrium(&squeezed(half, friction, true)?))
}

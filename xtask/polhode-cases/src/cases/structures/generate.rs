//! Random structures of 4 to 30 bricks: walls, bridges, corbels and leaning piles.
//!
//! Bricks are set so that faces and edges touch to rounding. Half of the structures have no friction.

use glam::DVec3;
use polhode::contact::Shape;
use polhode::mesh::solid_box;
use polhode::scene::Material;
use polhode::spatial::{Mass, Pose, Rotation, UnitVector};
use polhode::{Body, Scene};
use polhode_oracles::random::Random;
use polhode_oracles::statics::{Block, Friction};
use std::error::Error;

/// Length, depth, height of a brick, m.
const BRICK: DVec3 = DVec3::new(0.25, 0.12, 0.0625);

/// Density of the bricks, kg/m^3.
const DENSITY: f64 = 2000.0;

/// Edges of the block that stands for the ground in the programme, m: larger than any structure.
const GROUND: DVec3 = DVec3::new(40.0, 40.0, 2.0);

/// How many of the walls, bridges and corbels with friction stand on a slope.
const INCLINED: f64 = 0.5;

/// What is built.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Courses of bricks, with joints and gaps.
    Wall,
    /// A deck on two pillars, with loads.
    Bridge,
    /// A stack of which every course overhangs the one below, with a counterweight.
    Corbel,
    /// Bricks on a slope, in a trough, or under a plank that leans on them.
    LeaningPile,
}

/// All kinds, which take turns.
const KINDS: [Kind; 4] = [Kind::Wall, Kind::Bridge, Kind::Corbel, Kind::LeaningPile];

/// A brick, or a fixed block.
#[derive(Debug, Clone, Copy)]
struct Brick {
    center: DVec3,
    edges: DVec3,
    turn: Rotation,
    /// Times the density of bricks; none for what is fixed.
    weight: Option<f64>,
}

/// A structure on the ground z = 0, which is then inclined.
#[derive(Debug, Clone)]
pub(super) struct Structure {
    /// Coefficient between all bodies; 0 for none.
    pub friction: f64,
    /// The turn of everything with the ground.
    incline: Rotation,
    bricks: Vec<Brick>,
}

/// The structure of this number.
pub(super) fn structure(number: usize) -> Structure {
    let mut random = Random(0x5354_5255_4354 + number as u64);
    let kind = KINDS[number % KINDS.len()];
    let is_rough = (number / KINDS.len()) % 2 == 1;
    let mut site = Site { random: &mut random, bricks: Vec::new(), incline: 0.0 };
    match kind {
        Kind::Wall => site.wall(),
        Kind::Bridge => site.bridge(),
        Kind::Corbel => site.corbel(),
        Kind::LeaningPile => site.leaning_pile(is_rough),
    }
    if is_rough && kind != Kind::LeaningPile && site.random.unit() < INCLINED {
        site.incline = site.random.between(-0.4, 0.4);
    }
    let Site { bricks, incline, .. } = site;
    let friction = if is_rough { random.between(0.1, 0.9) } else { 0.0 };
    Structure { friction, incline: Rotation::from_rotation_vector(DVec3::Y * incline), bricks }
}

/// Where a structure grows.
struct Site<'a> {
    random: &'a mut Random,
    bricks: Vec<Brick>,
    /// Angle of the ground, rad.
    incline: f64,
}

impl Site<'_> {
    /// Sets a brick upright, turned about the vertical.
    fn set(&mut self, center: DVec3, edges: DVec3, yaw: f64) {
        let weight = Some(self.random.between(0.5, 2.0));
        self.bricks.push(Brick { center, edges, turn: Rotation::from_rotation_vector(DVec3::Z * yaw), weight });
    }

    /// Two to six courses; joints are open or closed, and some bricks are missing.
    fn wall(&mut self) {
        let (courses, length) = (2 + self.random.below(5), 2 + self.random.below(4));
        let joint = self.random.one_of(&[0.0, 0.0, 0.01]);
        let step = BRICK.x + joint;
        let missing = self.random.one_of(&[0.0, 0.1, 0.2]);
        for course in 0..courses {
            let shift = if course % 2 == 0 { 0.0 } else { 0.5 * step } + self.random.between(-0.1, 0.1) * BRICK.x;
            for place in 0..length - course % 2 {
                // The lowest course is whole.
                let is_there = course == 0 || self.random.unit() >= missing;
                if is_there && self.is_carried(course, shift + step * place as f64) {
                    let x = shift + step * place as f64;
                    let y = self.random.between(-0.2, 0.2) * BRICK.y;
                    self.set(DVec3::new(x, y, BRICK.z * (course as f64 + 0.5)), BRICK, 0.0);
                }
            }
        }
        while self.bricks.len() < 4 {
            let x = -2.0 * BRICK.x * (1 + self.bricks.len()) as f64;
            self.set(DVec3::new(x, 0.0, 0.5 * BRICK.z), BRICK, 0.0);
        }
    }

    /// Whether some brick of the course below is under a brick at `x` (m): none hangs in the air.
    fn is_carried(&self, course: usize, x: f64) -> bool {
        let below = BRICK.z * (course as f64 - 0.5);
        let under = |brick: &Brick| {
            (brick.center.z - below).abs() < 0.5 * BRICK.z && (brick.center.x - x).abs() < 0.95 * BRICK.x
        };
        course == 0 || self.bricks.iter().any(under)
    }

    /// Two pillars, a deck across them, and bricks on the deck.
    fn bridge(&mut self) {
        let (height, span) = (1 + self.random.below(8), self.random.between(0.7, 1.1));
        for side in [-1.0, 1.0] {
            let base = 0.5 * side * span;
            let mut x: f64 = base;
            for course in 0..height {
                // Pillars do not drift into each other.
                x = (x + self.random.between(-0.3, 0.3) * BRICK.x).clamp(base - 0.18, base + 0.18);
                let (y, yaw) = (self.random.between(-0.02, 0.02), self.random.between(-0.2, 0.2));
                self.set(DVec3::new(x, y, BRICK.z * (course as f64 + 0.5)), BRICK, yaw);
            }
        }
        let tops = [self.bricks[height - 1].center.x, self.bricks[2 * height - 1].center.x];
        let middle = 0.5 * (tops[0] + tops[1]) + self.random.between(-0.15, 0.15);
        let deck = DVec3::new((tops[1] - tops[0]).abs() + 0.2, BRICK.y, 0.04);
        let mut top = BRICK.z * height as f64;
        self.set(DVec3::new(middle, 0.0, top + 0.5 * deck.z), deck, 0.0);
        top += deck.z;
        for _ in 0..=self.random.below(4) {
            let x = middle + self.random.between(-0.6, 0.6) * deck.x;
            let free = |brick: &Brick| (brick.center.x - x).abs() > 1.01 * BRICK.x || brick.center.z < top;
            if self.bricks.iter().all(free) {
                self.set(DVec3::new(x, 0.0, top + 0.5 * BRICK.z), BRICK, 0.0);
            }
        }
        self.at_least_four();
    }

    /// One or two stacks of bricks that step towards one side, weighted at the other end.
    fn corbel(&mut self) {
        for stack in 0..=self.random.below(2) {
            let courses = 4 + self.random.below(8);
            let step = self.random.between(0.0, 0.25) * BRICK.x;
            let base = 2.0 * stack as f64;
            for course in 0..courses {
                let x = base + step * course as f64 + self.random.between(-0.05, 0.05) * BRICK.x;
                let (y, yaw) = (self.random.between(-0.01, 0.01), self.random.between(-0.1, 0.1));
                self.set(DVec3::new(x, y, BRICK.z * (course as f64 + 0.5)), BRICK, yaw);
            }
            let top = base + step * (courses - 1) as f64;
            for load in 0..self.random.below(4) {
                let x = top - self.random.between(0.1, 0.8) * BRICK.x;
                self.set(DVec3::new(x, 0.0, BRICK.z * ((courses + load) as f64 + 0.5)), BRICK, 0.0);
            }
        }
    }

    fn leaning_pile(&mut self, is_rough: bool) {
        if is_rough && self.random.unit() < 0.4 {
            return self.plank_on_a_stack();
        }
        self.incline = self.random.between(0.02, 0.6);
        let has_wall = self.random.unit() < if is_rough { 0.3 } else { 0.8 };
        let (courses, length) = (1 + self.random.below(4), 2 + self.random.below(5));
        // With a wall at the lower end bricks touch end to end.
        let gap = if has_wall { 0.0 } else { 0.02 };
        for course in 0..courses {
            for place in 0..length - course.min(length - 1) {
                let x = -(BRICK.x + gap) * (place as f64 + 0.5);
                let x = if has_wall { x } else { x + self.random.between(-0.02, 0.02) * BRICK.x };
                let y = self.random.between(-0.2, 0.2) * BRICK.y;
                self.set(DVec3::new(x, y, BRICK.z * (course as f64 + 0.5)), BRICK, 0.0);
            }
        }
        if has_wall {
            let edges =
                DVec3::new(0.2, 2.0, BRICK.z * (courses as f64 - self.random.one_of(&[0.3, 0.3, 1.2])).max(0.02));
            let center = DVec3::new(0.5 * edges.x, 0.0, 0.5 * edges.z);
            self.bricks.push(Brick { center, edges, turn: Rotation::IDENTITY, weight: None });
        }
        self.at_least_four();
    }

    /// A stack, and a plank whose lower edge stands on the ground and whose face lies on an upper edge of the stack.
    fn plank_on_a_stack(&mut self) {
        let courses = 3 + self.random.below(6);
        let mut x = 0.0;
        for course in 0..courses {
            x = self.random.between(-0.05, 0.05) * BRICK.x;
            self.set(DVec3::new(x, 0.0, BRICK.z * (course as f64 + 0.5)), BRICK, 0.0);
        }
        let lean = self.random.between(0.5, 1.3);
        let (along, up) = (DVec3::new(lean.cos(), 0.0, lean.sin()), DVec3::new(-lean.sin(), 0.0, lean.cos()));
        // The upper left edge of the stack, which the lower face of the plank lies on.
        let edge = DVec3::new(x - 0.5 * BRICK.x, 0.0, BRICK.z * courses as f64);
        let foot = edge - along * (edge.z / lean.sin());
        let edges = DVec3::new((edge - foot).length() * self.random.between(1.1, 1.9), 0.1, 0.03);
        let center = foot + along * (0.5 * edges.x) + up * (0.5 * edges.z);
        let turn = Rotation::from_rotation_vector(DVec3::Y * -lean);
        self.bricks.push(Brick { center, edges, turn, weight: Some(self.random.between(0.3, 2.0)) });
    }

    /// Adds bricks beside the structure until four can move.
    fn at_least_four(&mut self) {
        while self.bricks.iter().filter(|brick| brick.weight.is_some()).count() < 4 {
            let x = -3.0 - BRICK.x * 2.0 * self.bricks.len() as f64;
            self.set(DVec3::new(x, 0.0, 0.5 * BRICK.z), BRICK, 0.0);
        }
    }
}

impl Structure {
    /// Its blocks for the programme, the ground last.
    pub(super) fn blocks(&self) -> Vec<Block> {
        let block = |center: DVec3, edges: DVec3, turn: Rotation, mass: Option<f64>| {
            let turn = self.incline * turn;
            let axes = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| turn.rotate(axis));
            Block::cuboid(self.incline.rotate(center), edges, axes, mass)
        };
        let bricks = self.bricks.iter().map(|brick| block(brick.center, brick.edges, brick.turn, brick.mass_kg()));
        bricks.chain([block(DVec3::Z * (-0.5 * GROUND.z), GROUND, Rotation::IDENTITY, None)]).collect()
    }

    /// Friction of the programme, `part` of that of the scene.
    pub(super) fn friction(&self, part: f64) -> Friction {
        if self.friction > 0.0 { Friction::Coefficient(part * self.friction) } else { Friction::Frictionless }
    }

    /// Its scene.
    pub(super) fn scene(&self) -> Result<Scene, Box<dyn Error>> {
        let material = Material::new("brick").with_friction(self.friction)?;
        let up = UnitVector::new(self.incline.rotate(DVec3::Z))?;
        let ground = Body::fixed("ground").geometry(Shape::half_space(up).into()).material(material.clone());
        let mut scene = Scene::builder("structure").body(ground);
        for (number, brick) in self.bricks.iter().enumerate() {
            let name = format!("brick {number}");
            let body = match brick.mass_kg() {
                Some(mass) => Body::movable(name, solid_box(brick.edges, Mass::new(mass)?)?),
                None => Body::fixed(name),
            };
            let pose = Pose::new(self.incline * brick.turn, self.incline.rotate(brick.center));
            scene = scene.body(body.geometry(Shape::cuboid(brick.edges)?.into()).pose(pose).material(material.clone()));
        }
        Ok(scene.build()?)
    }
}

impl Brick {
    fn mass_kg(&self) -> Option<f64> {
        Some(DENSITY * self.weight? * self.edges.element_product())
    }
}

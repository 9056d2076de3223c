//! The drop of a scene as that of an elastic body: a box that meets a rigid floor, flat or on an edge.
//!
//! A rigid law is told by a coefficient what an impact leaves of a motion. Where a scene is the drop of a box whose
//! material has moduli, finite elements compute it (crate `polhode-elastic`, plane strain across the edge that is
//! lowest), and stand beside the impact laws with the coefficient of the scene: how long the contact lasts, its
//! impulse, and the effective restitution, which is the velocity of the centre of mass up over that down before.
//!
//! Assumes a contact that is short beside `v / g`: the elastic body has no gravity, and how much it would add is told.
//! Fails: any other scene, of which the reason is told.

use crate::elastic::rigid::{self, Rebound, RigidDrop};
use crate::failure::Failure;
use polhode::contact::{ConvexPolyhedron, HalfSpace, Shape};
use polhode::scene::{Geometry, ImpactLaw, Material};
use polhode::spatial::{DVec3, MassProperties};
use polhode::{Body, Scene};
use polhode_elastic::{DropStudy, ElasticMaterial, Extrapolated, MeshedDrops, Quantity, RectangleDrop};
use std::time::Instant;

/// Elements of the coarsest of three meshes: those of Figure 2 of the thesis.
const ELEMENTS: usize = 200;

/// What directions and sizes may be off, relative: those of a scene file are rounded.
const SAME: f64 = 1e-9;

/// Corners of a box.
const CORNERS: usize = 8;

/// A box and how it meets the floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ElasticDrop {
    /// The drop of a slice of it, one metre deep.
    pub(super) slice: RectangleDrop,
    /// Its depth, m.
    pub(super) depth_m: f64,
    /// Its mass, kg.
    pub(super) mass_kg: f64,
    /// The restitution of the scene at its speed.
    pub(super) restitution: f64,
    /// Gravity against the floor, m/s^2.
    pub(super) gravity: f64,
}

/// What a mesh gives.
#[derive(Debug, Clone, Copy)]
pub(super) struct ElasticRow {
    /// Elements.
    pub(super) elements: usize,
    /// Contact time, impulse of the slice and effective restitution.
    pub(super) values: [f64; 3],
    /// Computing time of one drop, s.
    pub(super) wall_s: f64,
}

/// The elastic body and the rigid laws on the same drop.
#[derive(Debug)]
pub(crate) struct ElasticBeside {
    /// What was dropped.
    pub(super) drop: ElasticDrop,
    /// By mesh, the coarsest first.
    pub(super) meshes: Vec<ElasticRow>,
    /// The limits of fine meshes.
    pub(super) limits: [Extrapolated; 3],
    /// The part of the energy that is left as vibration.
    pub(super) vibration: Extrapolated,
    /// The impact laws.
    pub(super) rigid: Vec<RigidDrop>,
}

/// What is compared.
pub(super) const QUANTITIES: [Quantity; 3] = [Quantity::ContactTime, Quantity::Impulse, Quantity::Restitution];

impl ElasticDrop {
    /// The drop that a scene is.
    ///
    /// # Errors
    /// Why it is none, in a line.
    pub(super) fn of(scene: &Scene) -> Result<Self, String> {
        let [floor, dropped] = floor_and_box(scene)?;
        let (normal, height) = surface(floor)?;
        let size = box_size(dropped)?;
        let pair = contact(scene, floor, dropped)?;
        let [young, poisson] = dropped.made_of().elastic_constants().ok_or_else(|| {
            format!("the material of body {} has no youngs_modulus_pa and poisson_ratio", dropped.name())
        })?;
        let gravity = -scene.gravity().dot(normal);
        let velocity = dropped.initial_velocity();
        let (down, spin) = (-velocity.linear.dot(normal), velocity.angular.length());
        let across = (velocity.linear + normal * down).length().max((scene.gravity() + normal * gravity).length());
        if across > SAME * down.abs().max(gravity.abs()) || spin > 0.0 {
            return Err("its box does not fall straight, or turns".to_owned());
        }
        let slice = Slice::of(dropped, normal, size)?;
        let gap = (dropped.initial_pose().translation.dot(normal) - height) - slice.half_height();
        let square = down * down.abs() + 2.0 * gravity * gap;
        if !(gap >= -SAME * size.length() && square > 0.0) {
            return Err("its box does not fall onto the floor".to_owned());
        }
        let mass_kg = dropped.mass_properties().map_or(f64::NAN, MassProperties::mass);
        let density = mass_kg / (size.x * size.y * size.z);
        let material = ElasticMaterial::new(young, poisson, density).map_err(|error| error.to_string())?;
        let drop = RectangleDrop::new(slice.width, slice.height, material, square.sqrt());
        let slice_drop = drop.and_then(|drop| drop.tilted(slice.tilt_rad)).map_err(|error| error.to_string())?;
        let restitution = pair.restitution_at(square.sqrt());
        Ok(Self { slice: slice_drop, depth_m: slice.depth, mass_kg, restitution, gravity })
    }

    /// Drops it on three meshes, and by every impact law.
    ///
    /// # Errors
    /// An element that folds, a body that does not leave the floor, a law that does not run.
    pub(super) fn run(self) -> Result<ElasticBeside, Failure> {
        let (mut meshes, mut rows) = (Vec::new(), Vec::new());
        for cells in DropStudy::cells(self.slice.cells(ELEMENTS))? {
            let start = Instant::now();
            let drops = MeshedDrops::of(&self.slice, cells)?;
            let wall_s = start.elapsed().as_secs_f64() / drops.reports.len().max(1) as f64;
            let values = QUANTITIES.map(|quantity| drops.mean(quantity).value);
            rows.push(ElasticRow { elements: cells.count(), values, wall_s });
            meshes.push(drops);
        }
        let study = DropStudy { meshes };
        let [time, impulse, restitution] = QUANTITIES.map(|quantity| study.limit(quantity));
        let limits = [time?, impulse?, restitution?];
        let spin = study.limit(Quantity::AngularVelocity)?.value;
        let elastic = Rebound { along: 0.0, up: study.limit(Quantity::Velocity)?.value, spin };
        let finest = study.meshes.last().and_then(|drops| drops.reports.last());
        let watched_s = finest.map_or(0.0, |report| report.steps as f64 * report.step_s);
        let law = |law| rigid::of_law(&self.slice, &elastic, watched_s, law, self.restitution);
        let rigid = ImpactLaw::ALL.into_iter().map(law).collect::<Result<_, _>>()?;
        let vibration = study.limit(Quantity::Vibration)?;
        Ok(ElasticBeside { drop: self, meshes: rows, limits, vibration, rigid })
    }
}

/// Restitution and friction of the two, which nothing but the floor's contact may act on.
fn contact(scene: &Scene, floor: &Body, dropped: &Body) -> Result<Material, String> {
    let ids = [floor, dropped].map(|body| scene.body_id(body.name()));
    let [Some(a), Some(b)] = ids else { return Err("its bodies have no names".to_owned()) };
    if !scene.can_collide(a, b) || !scene.forces().is_empty() || !scene.joints().is_empty() {
        return Err("forces, joints or a rule against contact act on its box".to_owned());
    }
    let pair = scene.material_between(a, b).map_err(|error| error.to_string())?;
    if pair.friction() > 0.0 {
        return Err(format!("its floor has friction ({}), which the elastic body has not", pair.friction()));
    }
    Ok(pair)
}

/// The slice across the edge that is lowest.
struct Slice {
    width: f64,
    height: f64,
    depth: f64,
    tilt_rad: f64,
}

impl Slice {
    fn of(body: &Body, normal: DVec3, size: DVec3) -> Result<Self, String> {
        let up = body.initial_pose().rotation.inverse_rotate(normal).abs();
        // The side that lies along the floor is the depth; of two the shorter, of equal ones the second.
        let order = |a: &usize, b: &usize| size[*a].total_cmp(&size[*b]).then(b.cmp(a));
        let Some(depth) = (0..3).filter(|axis| up[*axis] <= SAME).min_by(order) else {
            return Err("its box meets the floor on a corner, and the elastic body is a slice".to_owned());
        };
        let [a, b] = [(depth + 1) % 3, (depth + 2) % 3];
        let [wide, high] = if up[a] > up[b] { [b, a] } else { [a, b] };
        let tilt = up[wide].atan2(up[high]);
        let tilt_rad = if tilt <= SAME { 0.0 } else { tilt };
        Ok(Self { width: size[wide], height: size[high], depth: size[depth], tilt_rad })
    }

    /// From the centre to the lowest point, m.
    fn half_height(&self) -> f64 {
        0.5 * (self.width * self.tilt_rad.sin() + self.height * self.tilt_rad.cos())
    }
}

/// The floor and the one body that falls.
fn floor_and_box(scene: &Scene) -> Result<[&Body; 2], String> {
    match scene.bodies() {
        [a, b] if a.is_fixed() && !b.is_fixed() => Ok([a, b]),
        [a, b] if b.is_fixed() && !a.is_fixed() => Ok([b, a]),
        bodies => Err(format!("it is no drop of one box onto a fixed floor ({} bodies)", bodies.len())),
    }
}

/// Normal and height of the surface of a floor, in the axes of the world.
fn surface(floor: &Body) -> Result<(DVec3, f64), String> {
    let Some(Geometry::Shape(Shape::HalfSpace(space))) = floor.shape() else {
        return Err(format!("its floor {} is no half space", floor.name()));
    };
    if floor.motion().is_some() {
        return Err(format!("its floor {} moves", floor.name()));
    }
    if floor.made_of().elastic_constants().is_some() {
        return Err(format!("its floor {} has moduli, and that of the elastic body is rigid", floor.name()));
    }
    Ok(placed(space, floor))
}

fn placed(space: &HalfSpace, floor: &Body) -> (DVec3, f64) {
    let pose = floor.initial_pose();
    let normal = pose.rotation.rotate(space.normal());
    (normal, space.offset() + pose.translation.dot(normal))
}

/// The full edges of a body that is a box of one density, m.
fn box_size(body: &Body) -> Result<DVec3, String> {
    let none = || format!("its body {} is no box of one density", body.name());
    let Some(Geometry::Shape(Shape::Convex(polyhedron))) = body.shape() else { return Err(none()) };
    let half = cuboid(polyhedron).ok_or_else(none)?;
    let mass = body.mass_properties().ok_or_else(none)?;
    let squares = half * half;
    let moments = DVec3::new(squares.y + squares.z, squares.z + squares.x, squares.x + squares.y) / 3.0;
    let inertia = mass.inertia().matrix() / mass.mass();
    let scale = SAME * moments.max_element();
    let is_even = (0..3).all(|row| {
        (0..3).all(|column| {
            let wanted = if row == column { moments[row] } else { 0.0 };
            (inertia.col(column)[row] - wanted).abs() <= scale
        })
    });
    let is_centred = mass.center_of_mass().length() <= SAME * half.length();
    if is_even && is_centred { Ok(2.0 * half) } else { Err(none()) }
}

/// Half of the edges of a polyhedron that is a box about its origin.
fn cuboid(polyhedron: &ConvexPolyhedron) -> Option<DVec3> {
    let vertices = polyhedron.vertices();
    let half = vertices.iter().fold(DVec3::ZERO, |half: DVec3, vertex| half.max(vertex.abs()));
    let is_corner = |vertex: &DVec3| (vertex.abs() - half).abs().max_element() <= SAME * half.max_element();
    (vertices.len() == CORNERS && vertices.iter().all(is_corner)).then_some(half)
}

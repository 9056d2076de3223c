//! Mass properties of curved bodies: closed forms, meshes that tend to them, a void, Monte Carlo estimates.

use super::mesh_program::report;
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::mesh::{
    Bounds, Capsule, Cone, Cylinder, Ellipsoid, HalfBall, MonteCarlo, Primitive, Refinement, SolidMesh, Sphere, Torus,
    TriangleMesh, hollow_mass_properties, hollow_sphere, solid_mass_properties, solid_sphere,
};
use polhode::spatial::{Density, Mass, MassProperties};
use std::error::Error;

fn along(body: &MassProperties) -> f64 {
    body.inertia().matrix().z_axis.z
}

fn across(body: &MassProperties) -> f64 {
    body.inertia().matrix().x_axis.x
}

/// Inscribed icospheres tend to the sphere with order 2; nothing claims that a coarse one is a sphere.
pub(super) fn mp_07(context: &Context) -> CaseResult {
    let (mass, density) = (Mass::new(1.0)?, Density::new(1.0)?);
    let ball = solid_sphere(1.0, density)?;
    let (solid_moment, hollow_moment) = (along(&solid_sphere(1.0, mass)?), along(&hollow_sphere(1.0, mass)?));
    let [mut volumes, mut solids, mut hollows] = [[0.0; 7]; 3];
    let [mut program_volumes, mut program_solids, mut program_hollows] = [[0.0; 7]; 3];
    for level in 0..7 {
        let mesh = Sphere::new(1.0)?.mesh(Refinement::new(level as u32)?)?;
        volumes[level] = mesh.volume_integrals().volume / ball.mass();
        solids[level] = along(&solid_mass_properties(&mesh, mass)?) / solid_moment;
        hollows[level] = along(&hollow_mass_properties(mesh.mesh(), mass)?) / hollow_moment;
        let reported = report(context, "MP-07", mesh.mesh(), &["--mass", "1"])?;
        program_volumes[level] = reported.number("volume_m3")? / ball.mass();
        program_solids[level] = reported.six("inertia_kg_m2")?[2] / solid_moment;
        let hollow = report(context, "MP-07", mesh.mesh(), &["--mass", "1", "--hollow"])?;
        program_hollows[level] = hollow.six("inertia_kg_m2")?[2] / hollow_moment;
    }
    let mut rows = Vec::new();
    for (quantity, library, program) in [
        ("volume / that of the ball, levels 0 to 6", volumes, program_volumes),
        ("solid: moment / that of the ball, levels 0 to 6", solids, program_solids),
        ("hollow: moment / that of the sphere, levels 0 to 6", hollows, program_hollows),
    ] {
        rows.push(context.reference.row("MP-07", quantity, library)?);
        let mut row = context.reference.row("MP-07", quantity, program)?;
        row.quantity.push_str(" (program)");
        rows.push(row);
    }
    let ratio = (1.0 - volumes[5]) / (1.0 - volumes[6]);
    rows.push(context.reference.row("MP-07", "error of the volume, level 5 / level 6", ratio)?);
    Ok(rows)
}

/// A torus: closed form, and meshes of 16 by 8 and 64 by 32 quadrilaterals.
pub(super) fn mp_08(context: &Context) -> CaseResult {
    let (torus, mass, density) = (Torus::new(1.0, 0.25)?, Mass::new(1.0)?, Density::new(1.0)?);
    let row = |quantity: &str, measured: f64| context.reference.row("MP-08", quantity, measured);
    let (solid, hollow) = (torus.solid(mass)?, torus.hollow(mass)?);
    let mut rows = vec![
        row("solid: volume, m^3", torus.solid(density)?.mass())?,
        row("solid: moment along / mass, m^2", along(&solid))?,
        row("solid: moment across / mass, m^2", across(&solid))?,
        row("hollow: area, m^2", torus.hollow(density)?.mass())?,
        row("hollow: moment along / mass, m^2", along(&hollow))?,
        row("hollow: moment across / mass, m^2", across(&hollow))?,
    ];
    for (level, quantity) in
        [(0, "mesh of 16 by 8: volume, moment along / mass"), (2, "mesh of 64 by 32: volume, moment along / mass")]
    {
        let mesh = torus.mesh(Refinement::new(level)?)?;
        let measured = [mesh.volume_integrals().volume, along(&solid_mass_properties(&mesh, mass)?)];
        rows.push(context.reference.row("MP-08", quantity, measured)?);
        let reported = report(context, "MP-08", mesh.mesh(), &["--mass", "1"])?;
        let measured = [reported.number("volume_m3")?, reported.six("inertia_kg_m2")?[2]];
        let mut row = context.reference.row("MP-08", quantity, measured)?;
        row.quantity.push_str(" (program)");
        rows.push(row);
    }
    Ok(rows)
}

/// A ball with a spherical void: by subtraction of closed forms; by a mesh whose inner surface faces the void, whose
/// moment falls short of the exact one as that of the sphere's mesh does (case MP-07, level 3).
pub(super) fn mp_09(context: &Context) -> CaseResult {
    const CASE: &str = "MP-09";
    /// Moment of the icosphere of level 3 by that of the ball, and its tolerance: those of MP-07.
    const LEVEL_3: (f64, f64) = (0.99425746807762, 1e-12);
    let density = Density::new(1.0)?;
    let (outer, inner) = (solid_sphere(1.0, density)?, solid_sphere(0.5, density)?);
    let exact = (along(&outer) - along(&inner)) / (outer.mass() - inner.mass());
    let shell = Sphere::new(1.0)?.mesh(Refinement::new(3)?)?.into_mesh();
    let hollow = joined(&shell, &shell.scaled(0.5)?.flipped())?;
    let reported = report(context, CASE, &hollow, &["--mass", "1"])?;
    let body = solid_mass_properties(&SolidMesh::new(hollow)?, Mass::new(1.0)?)?;
    let tolerance = Tolerance::Relative(LEVEL_3.1);
    let ratio = "mesh with a void, level 3: moment / mass, by the exact one";
    let program = format!("{ratio} (program)");
    Ok(vec![
        context.reference.row(CASE, "moment / mass, m^2", exact)?,
        Row::compared(CASE, ratio, LEVEL_3.0, along(&body) / exact, tolerance),
        Row::compared(CASE, &program, LEVEL_3.0, reported.six("inertia_kg_m2")?[2] / exact, tolerance),
    ])
}

fn joined(a: &TriangleMesh, b: &TriangleMesh) -> Result<TriangleMesh, Box<dyn Error>> {
    let first = a.vertices().len() as u32;
    let vertices = a.vertices().iter().chain(b.vertices()).copied().collect();
    let moved = b.triangles().iter().map(|triangle| triangle.map(|index| index + first));
    Ok(TriangleMesh::new(vertices, a.triangles().iter().copied().chain(moved).collect())?)
}

/// The scatter of Monte Carlo estimates in the unit ball, and the standard error that each states.
pub(super) fn mp_10(context: &Context) -> CaseResult {
    /// Estimates, so many that their scatter is known to 2 %.
    const RUNS: u64 = 2000;
    /// Points of each.
    const POINTS: u64 = 2000;
    let ball = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE };
    let (mass, exact) = (Mass::new(1.0)?, along(&solid_sphere(1.0, Mass::new(1.0)?)?));
    let (mut scatter, mut stated) = (0.0, 0.0);
    for seed in 0..RUNS {
        let estimate = MonteCarlo::new(POINTS, seed)?.estimate_region(ball, |p| p.length_squared() < 1.0, mass)?;
        let (xx, inside) = (estimate.inertia[0], estimate.inside as f64);
        scatter += (xx.value - exact) * (xx.value - exact) * inside / RUNS as f64;
        stated += xx.standard_error * xx.standard_error * inside / RUNS as f64;
    }
    let (scatter, stated) = (scatter.sqrt(), stated.sqrt());
    let mut rows = Vec::new();
    for (how, error) in [("scatter", scatter), ("stated", stated)] {
        let mut both = [
            context.reference.row("MP-10", "standard error of xx / mass times sqrt(N), m^2", error)?,
            context.reference.row("MP-10", "standard error of xx at N = 1e6, relative", error / 1000.0 / exact)?,
        ];
        for row in &mut both {
            row.quantity = format!("{} ({how})", row.quantity);
        }
        rows.extend(both);
    }
    Ok(rows)
}

/// Cone and half-ball in closed form.
pub(super) fn mp_11(context: &Context) -> CaseResult {
    let mass = Mass::new(1.0)?;
    let (cone, half) = (Cone::new(1.0, 1.0)?.solid(mass)?, HalfBall::new(1.0)?);
    let (solid, dome) = (half.solid(mass)?, half.dome(mass)?);
    // Heights of the origin above base and flat face: those of the coarsest meshes, which touch them.
    let lowest = |primitive: Primitive| -> Result<f64, Box<dyn Error>> {
        Ok(primitive.mesh(Refinement::COARSEST)?.mesh().bounds().min.z)
    };
    let (base, face) = (lowest(Primitive::Cone(Cone::new(1.0, 1.0)?))?, lowest(Primitive::HalfBall(half))?);
    let reference = &context.reference;
    Ok(vec![
        reference.row("MP-11", "cone: centre of mass above the base, m", cone.center_of_mass().z - base)?,
        reference.row("MP-11", "cone: moments along across / mass, m^2", [along(&cone), across(&cone)])?,
        reference.row("MP-11", "half-ball: centre of mass above the flat face, m", solid.center_of_mass().z - face)?,
        reference.row("MP-11", "half-ball: moment across / mass, m^2", across(&solid))?,
        reference.row(
            "MP-11",
            "dome: centre of mass above its rim, moment across / mass",
            [dome.center_of_mass().z - face, across(&dome)],
        )?,
    ])
}

/// The thesis's warning about meshes of curved surfaces, with its order: errors of the inertia fall by 4 when edges are
/// halved, solid and hollow, for every primitive.
pub(super) fn orders(_context: &Context) -> CaseResult {
    /// Levels 4 and 5 are that far from the limit.
    const TOLERANCE: f64 = 1e-2;
    let density = Density::new(1.0)?;
    let mut rows = Vec::new();
    for primitive in [
        Primitive::Sphere(Sphere::new(0.7)?),
        Primitive::Ellipsoid(Ellipsoid::new(DVec3::new(0.5, 1.0, 1.7))?),
        Primitive::Cylinder(Cylinder::new(0.6, 1.9)?),
        Primitive::Cone(Cone::new(0.8, 1.3)?),
        Primitive::Capsule(Capsule::new(0.4, 1.1)?),
        Primitive::Torus(Torus::new(1.2, 0.35)?),
        Primitive::HalfBall(HalfBall::new(1.4)?),
    ] {
        let (solid, hollow) = (along(&primitive.solid(density)?), along(&primitive.hollow(density)?));
        let errors = |level: u32| -> Result<[f64; 2], Box<dyn Error>> {
            let mesh = primitive.mesh(Refinement::new(level)?)?;
            let shell = hollow_mass_properties(mesh.mesh(), density)?;
            Ok([1.0 - along(&solid_mass_properties(&mesh, density)?) / solid, 1.0 - along(&shell) / hollow])
        };
        let (first, coarse, fine) = (errors(0)?, errors(4)?, errors(5)?);
        for (filling, k) in [("solid", 0), ("hollow", 1)] {
            let name = format!("{} ({filling})", primitive.name());
            let ratio = format!("{name}: error of the inertia, level 4 / level 5");
            let case = "meshes of primitives";
            rows.push(Row::compared(case, &ratio, 4.0, coarse[k] / fine[k], Tolerance::Relative(TOLERANCE)));
            rows.push(Row::info(case, &format!("{name}: inertia missing at level 0, of the whole"), "", first[k]));
        }
    }
    Ok(rows)
}

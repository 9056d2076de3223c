//! Masses, centres of mass and inertias of links against their shapes.
//!
//! A link is held against its shapes evenly filled: its density must be that of some material, its centre of mass near
//! its shapes, and its principal moments within a factor of those of the filling. All this finds units and frames that
//! are mistaken, by factors of thousands; a real part is neither even nor without cavities, and shapes for collisions
//! are coarse.

use super::super::finding::{Findings, RobotDefect};
use super::super::model::{Geom, GeomForm, Link};
use super::super::shapes::{self, Meshes};
use super::super::weld::Matter;
use glam::DVec3;
use polhode::contact::{Shape, aabb_of};
use polhode::mesh::{
    Capsule, ConvexHull, Cuboid, Cylinder, Ellipsoid, Primitive, SolidMesh, Sphere, solid_mass_properties,
};
use polhode::spatial::{Density, MassProperties, Pose, PrincipalAxes};

/// Densities of parts of robots, kg/m^3: foam in a thin shell, and tungsten. Below and above a unit is mistaken.
const DENSITIES: [f64; 2] = [10.0, 20_000.0];

/// Ratio of a principal moment to that of the shape evenly filled beyond which it is told (no unit, 3 to 100): a motor
/// at the end of a hollow arm gives a factor of a few.
const MOMENT_RATIO: f64 = 20.0;

/// How far outside the box around its shapes a centre of mass may be, relative to the diagonal of the box (no unit,
/// 0.05 to 1).
const OUTSIDE: f64 = 0.25;

/// Geometries filled with a density of one, and the lowest and highest corner of the box around them, m.
struct Filled {
    matter: Matter,
    low: DVec3,
    high: DVec3,
}

/// Examines a link that has mass and shapes.
pub(super) fn examine(link: &Link, meshes: &mut Meshes, findings: &mut Findings) {
    let Some(own) = link.inertial.as_ref().filter(|own| own.mass > 0.0) else { return };
    let geoms = if link.collisions.is_empty() { &link.visuals } else { &link.collisions };
    let Some(Filled { matter: shape, low, high }) = filled(geoms, meshes) else { return };
    let subject = format!("link `{}`", link.name);
    let (volume, size) = (shape.mass, (high - low).length());
    let density = own.mass / volume;
    if !(DENSITIES[0]..=DENSITIES[1]).contains(&density) {
        findings.add(&own.place, &subject, RobotDefect::Density { mass: own.mass, volume, density });
    }
    let center = own.frame.translation;
    let distance = (center - center.clamp(low, high)).length();
    if distance > OUTSIDE * size {
        findings.add(&own.place, &subject, RobotDefect::CenterOutside { distance, size });
    }
    let found = PrincipalAxes::of(&own.inertia).moments();
    let expected = PrincipalAxes::of(&(shape.inertia * density)).moments();
    let ratios = [found.x / expected.x, found.y / expected.y, found.z / expected.z];
    let worst =
        ratios.into_iter().fold(1.0, |worst: f64, ratio| if spread(ratio) > spread(worst) { ratio } else { worst });
    if spread(worst) > MOMENT_RATIO {
        findings.add(&own.place, &subject, RobotDefect::InertiaAgainstShape { found, expected, ratio: worst });
    }
}

/// A ratio or its inverse, whichever is more than one.
fn spread(ratio: f64) -> f64 {
    ratio.max(1.0 / ratio)
}

/// Geometries filled; none when they have no volume, or one cannot be read.
fn filled(geoms: &[Geom], meshes: &mut Meshes) -> Option<Filled> {
    let mut sum: Option<Matter> = None;
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for geom in geoms {
        let part = Matter::of_properties(&of_geom(&geom.form, meshes)?.in_frame(&geom.pose));
        sum = Some(sum.map_or(part, |sum| sum.plus(part)));
        let around = around(&geom.form, &geom.pose, meshes)?;
        (low, high) = (low.min(around.0), high.max(around.1));
    }
    sum.map(|matter| Filled { matter, low, high })
}

/// Lowest and highest corner of the box around a geometry.
fn around(form: &GeomForm, pose: &Pose, meshes: &mut Meshes) -> Option<(DVec3, DVec3)> {
    let shape = match form {
        // An ellipsoid lies in the box of its semi-axes.
        GeomForm::Ellipsoid { semi_axes } => Shape::cuboid(*semi_axes * 2.0).ok()?,
        other => shapes::own_shape(other, meshes).ok()?,
    };
    let around = aabb_of(&shape, pose).ok()?;
    Some((around.min(), around.max()))
}

/// A geometry filled with a density of one, in its own frame: a mesh that is no solid by its hull.
fn of_geom(form: &GeomForm, meshes: &mut Meshes) -> Option<MassProperties> {
    let one = Density::new(1.0).ok()?;
    let primitive = match form {
        GeomForm::Plane => return None,
        GeomForm::Box { size } => Primitive::Box(Cuboid::new(*size).ok()?),
        GeomForm::Sphere { radius } => Primitive::Sphere(Sphere::new(*radius).ok()?),
        GeomForm::Cylinder { radius, height } => Primitive::Cylinder(Cylinder::new(*radius, *height).ok()?),
        GeomForm::Capsule { radius, height } => Primitive::Capsule(Capsule::new(*radius, *height).ok()?),
        GeomForm::Ellipsoid { semi_axes } => Primitive::Ellipsoid(Ellipsoid::new(*semi_axes).ok()?),
        GeomForm::Mesh { name, path, scale } => {
            let mesh = meshes.read(name, path.as_deref(), *scale).ok()?;
            let of_hull = || Some(ConvexHull::of(mesh.vertices()).ok()?.into_solid().into_solid());
            let solid = SolidMesh::new(mesh.clone()).ok().or_else(of_hull)?;
            return solid_mass_properties(&solid, one).ok();
        }
    };
    primitive.solid(one).ok()
}

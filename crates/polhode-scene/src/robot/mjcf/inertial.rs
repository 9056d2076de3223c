//! Mass properties of a body: given, or from its geometries evenly filled.

use super::super::element::Element;
use super::super::finding::RobotDefect;
use super::super::model::{GeomForm, Inertial};
use super::super::reading::Reading;
use super::super::shapes::Meshes;
use super::super::weld::Matter;
use super::compiler::{Compiler, InertiaFromGeom};
use super::frame;
use super::geom::{Amount, BodyGeom};
use glam::{DMat3, DVec3};
use polhode::mesh::{
    Amount as Fill, Capsule, Cuboid, Cylinder, Ellipsoid, MeshError, Primitive, PrimitiveError, SolidMesh, Sphere,
    hollow_mass_properties, solid_mass_properties,
};
use polhode::spatial::{Density, Mass, MassProperties, Pose};

/// The mass properties of a body; none when it has no mass.
pub(super) fn read(
    element: &Element,
    geoms: &[BodyGeom],
    (compiler, meshes): (&Compiler, &mut Meshes),
    subject: &str,
    reading: &mut Reading,
) -> Option<Inertial> {
    let given = element.first("inertial").filter(|_| compiler.inertia_from_geom != InertiaFromGeom::Always);
    if let Some(own) = given {
        let given = self::given(own, compiler, subject, reading);
        reading.has_guess |= given.is_none();
        return given;
    }
    if compiler.inertia_from_geom == InertiaFromGeom::Never {
        return None;
    }
    let [first, last] = compiler.inertia_groups;
    let mut sum: Option<Matter> = None;
    for own in geoms.iter().filter(|own| (first..=last).contains(&own.group)) {
        match of_geom(own, meshes) {
            Ok(Some(part)) => sum = Some(sum.map_or(part, |sum| sum.plus(part))),
            Ok(None) => {}
            Err(defect) => {
                reading.findings.add(&own.geom.place, subject, defect);
                reading.has_guess = true;
            }
        }
    }
    sum.map(|Matter { mass, center, inertia }| Inertial {
        place: element.place.clone(),
        mass,
        frame: Pose::from_translation(center),
        inertia,
    })
}

/// `<inertial>`.
fn given(own: &Element, compiler: &Compiler, subject: &str, reading: &mut Reading) -> Option<Inertial> {
    let frame = frame::pose(own, compiler, subject, reading);
    let mass = reading.needed(own, "mass", subject)?;
    let full = reading.numbers(own, "fullinertia", 6..=6, subject);
    let inertia = if let Some(m) = full {
        DMat3::from_cols(DVec3::new(m[0], m[3], m[4]), DVec3::new(m[3], m[1], m[5]), DVec3::new(m[4], m[5], m[2]))
    } else {
        if own.attribute("diaginertia").is_none() {
            reading.refuse(own, subject, RobotDefect::MissingAttribute("diaginertia"));
        }
        DMat3::from_diagonal(reading.vector(own, "diaginertia", subject)?)
    };
    Some(Inertial { place: own.place.clone(), mass, frame, inertia })
}

/// The mass of a geometry in the frame of its body; none of one that has none.
fn of_geom(own: &BodyGeom, meshes: &mut Meshes) -> Result<Option<Matter>, RobotDefect> {
    let fill = match own.amount {
        Amount::Mass(0.0) | Amount::Density(0.0) => return Ok(None),
        Amount::Mass(mass) => Fill::from(Mass::new(mass)?),
        Amount::Density(density) => Fill::from(Density::new(density)?),
    };
    let primitive = match &own.geom.form {
        GeomForm::Plane => return Ok(None),
        GeomForm::Box { size } => Cuboid::new(*size).map(Primitive::Box),
        GeomForm::Sphere { radius } => Sphere::new(*radius).map(Primitive::Sphere),
        GeomForm::Cylinder { radius, height } => Cylinder::new(*radius, *height).map(Primitive::Cylinder),
        GeomForm::Capsule { radius, height } => Capsule::new(*radius, *height).map(Primitive::Capsule),
        GeomForm::Ellipsoid { semi_axes } => Ellipsoid::new(*semi_axes).map(Primitive::Ellipsoid),
        GeomForm::Mesh { name, path, scale } => {
            let mesh = meshes.read(name, path.as_deref(), *scale)?;
            let refused = |source: MeshError| RobotDefect::Mesh { file: name.clone(), source };
            let filled = if own.is_shell {
                hollow_mass_properties(&mesh, fill).map_err(refused)?
            } else {
                let solid =
                    SolidMesh::new(mesh).map_err(|source| RobotDefect::MassOfMesh { file: name.clone(), source })?;
                solid_mass_properties(&solid, fill).map_err(refused)?
            };
            return Ok(Some(Matter::of_properties(&filled.in_frame(&own.geom.pose))));
        }
    };
    let primitive = primitive.map_err(of_primitive)?;
    let filled: Result<MassProperties, PrimitiveError> =
        if own.is_shell { primitive.hollow(fill) } else { primitive.solid(fill) };
    Ok(Some(Matter::of_properties(&filled.map_err(of_primitive)?.in_frame(&own.geom.pose))))
}

fn of_primitive(error: PrimitiveError) -> RobotDefect {
    match error {
        PrimitiveError::MassProperties(error) => error.into(),
        error => RobotDefect::Primitive(error),
    }
}

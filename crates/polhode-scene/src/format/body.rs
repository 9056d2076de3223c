//! Bodies and their shapes.

use super::exactly::{Exactly, Vector};
use super::{ColorEntry, MotionEntry};
use schemars::JsonSchema;
use serde::de::{self, Deserialize, Deserializer, SeqAccess, Visitor};

/// A body.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BodyEntry {
    /// Name, unique in the scene.
    pub name: String,
    /// Immovable, of infinite mass.
    #[serde(default)]
    pub fixed: bool,
    /// Shape; a body without one flies through everything.
    pub shape: Option<ShapeEntry>,
    /// Mass, kg; or density.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mass: Option<f64>,
    /// Density, kg/m^3, or kg/m^2 of the surface when hollow; or mass.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub density: Option<f64>,
    /// Inertia about the centre of mass in the body's own axes, kg m^2; from the shape when absent.
    pub inertia: Option<InertiaEntry>,
    /// Centre of mass in the body's own frame, m, with `inertia` about it; from the shape when absent.
    pub center_of_mass: Option<Vector>,
    /// The mass is spread evenly over the surface of the shape instead of its volume.
    #[serde(default)]
    pub hollow: bool,
    /// Position of the body's own origin, m.
    pub position: Option<Vector>,
    /// Orientation as a unit quaternion [w, x, y, z]; or rotation_vector.
    pub orientation: Option<Exactly<f64, 4>>,
    /// Orientation as axis times angle, rad; or orientation.
    pub rotation_vector: Option<Vector>,
    /// Motion that is prescribed, whatever acts on the body; then without mass, velocities and pivot.
    pub motion: Option<MotionEntry>,
    /// A point of the world, m, that is held fixed in the body, which then only turns about it.
    pub pivot: Option<Vector>,
    /// Velocity of the centre of mass, world, m/s; of a body with a pivot that of its rotation, or absent.
    pub velocity: Option<Vector>,
    /// Angular velocity, world, rad/s.
    pub angular_velocity: Option<Vector>,
    /// Velocity of its surface over its shape, in the body's own frame, m/s: a belt. The shape does not move; at a
    /// contact the part in the tangent plane counts, and only friction feels it.
    pub surface_velocity: Option<Vector>,
    /// Name of a material; without one friction and restitution are 0.
    pub material: Option<String>,
    /// Colour in pictures and pages, a name or `#rrggbb`; one of the palette when absent.
    pub colour: Option<ColorEntry>,
    /// Words that stand beside it in pictures and pages.
    pub label: Option<String>,
    /// It is not shown.
    #[serde(default)]
    pub hidden: bool,
    /// How much of it is seen: 1 when absent, 0 nothing.
    #[schemars(range(min = 0, max = 1))]
    pub opacity: Option<f64>,
}

/// A shape in the body's own frame.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ShapeEntry {
    /// A box about the origin.
    Box(BoxEntry),
    /// A ball about the origin.
    Sphere(SphereEntry),
    /// Everything below a plane through the origin; fixed and kinematic bodies only.
    HalfSpace(HalfSpaceEntry),
    /// Points that touch by themselves: corners without faces. Mass and inertia must be given; the centre of mass is
    /// the origin.
    Points(PointsEntry),
    /// A cylinder about the z axis, its centre at the origin.
    Cylinder(RadiusHeightEntry),
    /// A cone about the z axis, its apex towards +z, its origin a quarter of its height above the base.
    Cone(RadiusHeightEntry),
    /// A capsule about the z axis, its centre at the origin; its height is without the caps.
    Capsule(RadiusHeightEntry),
    /// A ring about the z axis, its centre at the origin.
    Torus(TorusEntry),
    /// What lies over a polygon, along the z axis, half of its height on either side of the xy plane.
    Prism(PrismEntry),
    /// A stone of an arch: what lies between two circles about the z axis and two planes through it, with plane faces,
    /// its middle towards +x. Its origin is on that axis.
    Wedge(WedgeEntry),
    /// Parts that are fixed to each other.
    Compound(CompoundEntry),
    /// A convex solid from a mesh file.
    Convex(FileEntry),
    /// A mesh file: of a closed solid of any form, or, for a fixed or kinematic body, of a surface too.
    Mesh(MeshEntry),
}

impl ShapeEntry {
    /// Adds the names of its mesh files.
    pub(crate) fn add_files<'a>(&'a self, files: &mut Vec<&'a str>) {
        match self {
            Self::Convex(entry) => files.push(&entry.file),
            Self::Mesh(entry) => files.push(&entry.file),
            Self::Compound(entry) => entry.parts.iter().for_each(|part| part.shape.add_files(files)),
            _ => {}
        }
    }
}

/// A box.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoxEntry {
    /// Full edges along x, y, z, m.
    pub size: Vector,
}

/// A ball.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SphereEntry {
    /// Radius, m.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
}

/// A half-space.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HalfSpaceEntry {
    /// Outward normal of any length.
    pub normal: Vector,
}

/// Points.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointsEntry {
    /// Positions, m.
    #[schemars(length(min = 1))]
    pub positions: Vec<Vector>,
}

/// A cylinder, a cone or a capsule.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RadiusHeightEntry {
    /// Radius, m.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Height, m.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub height: f64,
}

/// A ring.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TorusEntry {
    /// Radius of the circle in the middle of the tube, m.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub major: f64,
    /// Radius of the tube, m; less than the other.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub minor: f64,
}

/// A prism.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PrismEntry {
    /// Corners [x, y] in their order around the polygon, m; it may be not convex, and must not touch itself.
    #[schemars(length(min = 3))]
    pub polygon: Vec<Exactly<f64, 2>>,
    /// Height along z, m.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub height: f64,
}

/// A wedge.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WedgeEntry {
    /// Distance of the inner corners from the axis, m.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub inner_radius: f64,
    /// Distance of the outer corners from the axis, m; more than the other.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub outer_radius: f64,
    /// Angle between the end faces, rad; below pi.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub angle: f64,
    /// Width along z, m.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub width: f64,
}

/// Several parts.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompoundEntry {
    /// The parts; mass is spread evenly over all of them, twice where two overlap.
    #[schemars(length(min = 1))]
    pub parts: Vec<PartEntry>,
}

/// A part of a compound.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartEntry {
    /// Shape, about the part's own origin.
    pub shape: ShapeEntry,
    /// Position of the part's origin in the body, m.
    pub position: Option<Vector>,
    /// Orientation in the body as a unit quaternion [w, x, y, z]; or rotation_vector.
    pub orientation: Option<Exactly<f64, 4>>,
    /// Orientation in the body as axis times angle, rad; or orientation.
    pub rotation_vector: Option<Vector>,
}

/// A mesh in a file.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FileEntry {
    /// OBJ, STL, OFF or PLY file, relative to the scene file; lengths in m.
    pub file: String,
    /// What the coordinates of the file are multiplied by to give metres; 1 when absent.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub scale: Option<f64>,
}

/// A mesh of a solid or a surface in a file.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshEntry {
    /// OBJ, STL, OFF or PLY file, relative to the scene file; lengths in m.
    pub file: String,
    /// What the coordinates of the file are multiplied by to give metres; 1 when absent.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub scale: Option<f64>,
    /// Few convex parts that nearly fill the solid, for collisions; exact parts when absent.
    pub approximate: Option<ApproximateEntry>,
}

/// What approximate convex parts of a mesh may cost.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ApproximateEntry {
    /// Most convex parts, 1 to 4096; 256 when absent. They are found by halving, so that there may be up to twice as
    /// many.
    #[schemars(range(min = 1, max = 4096))]
    pub parts: Option<u32>,
    /// Largest difference of the volume of the parts from that of the solid, relative to it; not limited when absent.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub error: Option<f64>,
}

/// Inertia about the centre of mass, in the body's own axes.
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged)]
pub enum InertiaEntry {
    /// [Ixx, Iyy, Izz], kg m^2.
    Diagonal(Vector),
    /// The symmetric 3x3 matrix, kg m^2.
    Matrix(Exactly<Vector, 3>),
}

/// One element of `inertia`: a number of the diagonal or a row of the matrix.
enum InertiaElement {
    Moment(f64),
    Row(Vector),
}

// Derived untagged enums lose the place and the reason of an error; this visitor keeps both.
impl<'de> Deserialize<'de> for InertiaEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Elements;
        impl<'de> Visitor<'de> for Elements {
            type Value = InertiaEntry;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("three moments [Ixx, Iyy, Izz] or a matrix of three rows of three numbers")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut elements: A) -> Result<InertiaEntry, A::Error> {
                let mut moments = Vec::new();
                let mut rows = Vec::new();
                while let Some(element) = elements.next_element()? {
                    match element {
                        InertiaElement::Moment(moment) => moments.push(moment),
                        InertiaElement::Row(row) => rows.push(row),
                    }
                    if moments.len() + rows.len() > 3 {
                        break;
                    }
                }
                let found = moments.len() + rows.len();
                match (moments.as_slice(), rows.as_slice()) {
                    (&[x, y, z], []) => Ok(InertiaEntry::Diagonal(Exactly([x, y, z]))),
                    ([], [x, y, z]) => Ok(InertiaEntry::Matrix(Exactly([x.clone(), y.clone(), z.clone()]))),
                    _ => Err(de::Error::invalid_length(found, &self)),
                }
            }
        }
        deserializer.deserialize_seq(Elements)
    }
}

impl<'de> Deserialize<'de> for InertiaElement {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Element;
        impl<'de> Visitor<'de> for Element {
            type Value = InertiaElement;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number or a row of three numbers")
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<InertiaElement, E> {
                Ok(InertiaElement::Moment(value))
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<InertiaElement, E> {
                Ok(InertiaElement::Moment(value as f64))
            }

            fn visit_u64<E: de::Error>(self, value: u64) -> Result<InertiaElement, E> {
                Ok(InertiaElement::Moment(value as f64))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, row: A) -> Result<InertiaElement, A::Error> {
                Vector::deserialize(de::value::SeqAccessDeserializer::new(row)).map(InertiaElement::Row)
            }
        }
        deserializer.deserialize_any(Element)
    }
}

//! Arrays: many equal bodies in a layout.

use super::body::{BodyEntry, InertiaEntry, ShapeEntry};
use super::exactly::{Exactly, Vector};
use super::view::ColorEntry;
use schemars::JsonSchema;
use serde::Deserialize;

/// Kinds of layout, for messages.
pub(crate) const LAYOUTS: &str = "grid, pyramid, wall, ring, arch or drop";

/// Many equal bodies: the keys of a body, and where each of them stands.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ArrayEntry {
    /// What the names of its bodies begin with: NAME-1, NAME-2, ..., or NAME-1-1 and so on.
    pub name: String,
    /// Where its bodies stand.
    pub layout: LayoutEntry,
    /// Immovable, of infinite mass.
    #[serde(default)]
    pub fixed: bool,
    /// Shape; bodies without one fly through everything.
    pub shape: Option<ShapeEntry>,
    /// Mass of each body, kg; or density.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mass: Option<f64>,
    /// Density, kg/m^3, or kg/m^2 of the surface when hollow; or mass.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub density: Option<f64>,
    /// Inertia of each body about its centre of mass in its own axes, kg m^2; from the shape when absent.
    pub inertia: Option<InertiaEntry>,
    /// Centre of mass in the frame of each body, m, with `inertia` about it; from the shape when absent.
    pub center_of_mass: Option<Vector>,
    /// The mass is spread evenly over the surface of the shape instead of its volume.
    #[serde(default)]
    pub hollow: bool,
    /// Position of the first body's origin, or the lowest corner of the region of a drop, m.
    pub position: Option<Vector>,
    /// Orientation of each body as a unit quaternion [w, x, y, z]; or rotation_vector.
    pub orientation: Option<Exactly<f64, 4>>,
    /// Orientation of each body as axis times angle, rad; or orientation.
    pub rotation_vector: Option<Vector>,
    /// Velocity of each centre of mass, world, m/s.
    pub velocity: Option<Vector>,
    /// Angular velocity of each body, world, rad/s.
    pub angular_velocity: Option<Vector>,
    /// Velocity of the surface of each body over its shape, in the body's own frame, m/s.
    pub surface_velocity: Option<Vector>,
    /// Name of a material; without one friction and restitution are 0.
    pub material: Option<String>,
    /// Colour of all of them in pictures and pages, a name or `#rrggbb`; those of the palette when absent.
    pub colour: Option<ColorEntry>,
    /// They are not shown.
    #[serde(default)]
    pub hidden: bool,
    /// How much of them is seen: 1 when absent, 0 nothing.
    #[schemars(range(min = 0, max = 1))]
    pub opacity: Option<f64>,
}

impl ArrayEntry {
    /// The body that all of them are copies of: named as the array, at its position.
    pub(crate) fn body(&self) -> BodyEntry {
        BodyEntry {
            name: self.name.clone(),
            fixed: self.fixed,
            shape: self.shape.clone(),
            mass: self.mass,
            density: self.density,
            inertia: self.inertia.clone(),
            center_of_mass: self.center_of_mass.clone(),
            hollow: self.hollow,
            position: self.position.clone(),
            orientation: self.orientation.clone(),
            rotation_vector: self.rotation_vector.clone(),
            motion: None,
            pivot: None,
            velocity: self.velocity.clone(),
            angular_velocity: self.angular_velocity.clone(),
            surface_velocity: self.surface_velocity.clone(),
            material: self.material.clone(),
            colour: self.colour,
            label: None,
            hidden: self.hidden,
            opacity: self.opacity,
        }
    }
}

/// Where the bodies of an array stand. Layouts extend from the array's `position` along +x, +y and +z; a ring and an
/// arch stand about it.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LayoutEntry {
    /// Rows, columns and layers.
    Grid(GridEntry),
    /// Courses along x, each with one body fewer than the one below it and half a spacing farther, up to a single one.
    Pyramid(PyramidEntry),
    /// Courses of boxes along x in running bond: every second one begins and ends with half a brick.
    Wall(WallEntry),
    /// Around a vertical axis.
    Ring(RingEntry),
    /// An arch of equal stones, which it makes itself.
    Arch(ArchEntry),
    /// Apart from each other in a region, at random places and in random orientations.
    Drop(DropEntry),
}

/// Rows, columns and layers.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GridEntry {
    /// How many along x, y and z, each at least 1.
    pub counts: Exactly<u32, 3>,
    /// From one body to the next along x, y and z, m.
    pub spacing: Vector,
    /// Angle about the vertical through `position` by which the array is turned, rad; 0 when absent.
    pub turn: Option<f64>,
}

/// A flat pyramid.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PyramidEntry {
    /// How many bodies stand in the lowest course, at least 1: base (base + 1) / 2 in all.
    #[schemars(range(min = 1))]
    pub base: u32,
    /// From one body to the next in a course, and from one course to the next, m.
    pub spacing: Exactly<f64, 2>,
    /// Angle about the vertical through `position` by which the array is turned, rad; 0 when absent.
    pub turn: Option<f64>,
}

/// A wall.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WallEntry {
    /// How many bricks lie in the lowest course, at least 2.
    #[schemars(range(min = 2))]
    pub length: u32,
    /// How many courses there are, at least 1.
    #[schemars(range(min = 1))]
    pub height: u32,
    /// From one brick to the next in a course, and from one course to the next, m.
    pub spacing: Exactly<f64, 2>,
    /// Angle about the vertical through `position` by which the array is turned, rad; 0 when absent.
    pub turn: Option<f64>,
}

/// Bodies around the vertical axis through `position`, the first at +x, the others anticlockwise seen from above, each
/// turned with its place.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RingEntry {
    /// How many bodies.
    #[schemars(range(min = 1))]
    pub count: u32,
    /// From the axis to the origin of each body, m; 0 when absent, as for wedges, whose origin is on their axis.
    #[schemars(extend("minimum" = 0))]
    pub radius: Option<f64>,
    /// Angle about the vertical through `position` by which the array is turned, rad; 0 when absent.
    pub turn: Option<f64>,
}

/// An arch in the plane of x and z, with radial joints and `position` as its centre: stones from -x to +x, each a
/// wedge.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ArchEntry {
    /// How many stones; each takes less than half a turn.
    #[schemars(range(min = 1))]
    pub count: u32,
    /// Radius in the middle of the thickness, m.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Thickness, m; less than twice the radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub thickness: f64,
    /// Width of the stones along y, m.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub width: f64,
    /// Angle from one end to the other, rad, at most a whole turn; half a turn when absent.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub opening: Option<f64>,
    /// Whether the first and the last stone are fixed; they are loose when absent.
    pub springers: Option<SpringersName>,
    /// Angle about the vertical through `position` by which the array is turned, rad; 0 when absent.
    pub turn: Option<f64>,
}

/// The first and the last stone of an arch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SpringersName {
    /// As the other stones.
    Loose,
    /// Immovable.
    Fixed,
}

/// Bodies at random places, apart from each other.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DropEntry {
    /// How many bodies.
    #[schemars(range(min = 1))]
    pub count: u32,
    /// Edges of the region that holds them at the start, along x, y and z, m.
    pub size: Vector,
    /// Another seed is another arrangement; 0 when absent.
    pub seed: Option<u64>,
}

//! Mass, centre of mass and inertia of a body.

use crate::inertia::point_inertia;
use crate::{Handedness, Inertia, InertiaError, Pose, PrincipalAxes};
use glam::DVec3;
use thiserror::Error;

/// A positive, finite mass, kg.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Mass(f64);

/// A positive, finite density: kg/m^3 of a solid, kg/m^2 of a shell.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Density(f64);

/// Why a number or a set of them is no mass property.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum MassPropertiesError {
    /// The mass is not a positive number.
    #[error("mass must be a positive number of kilograms, found {0}")]
    Mass(f64),
    /// The density is not a positive number.
    #[error("density must be a positive number of kg/m^3 (kg/m^2 for a hollow body), found {0}")]
    Density(f64),
    /// The centre of mass is not finite.
    #[error("centre of mass has a component that is not finite")]
    CenterOfMass,
    /// The inertia is not valid.
    #[error(transparent)]
    Inertia(#[from] InertiaError),
}

impl Mass {
    /// A mass in kg.
    ///
    /// # Errors
    /// When it is not positive and finite.
    pub fn new(kilograms: f64) -> Result<Self, MassPropertiesError> {
        if kilograms > 0.0 && kilograms.is_finite() {
            Ok(Self(kilograms))
        } else {
            Err(MassPropertiesError::Mass(kilograms))
        }
    }

    /// In kg.
    pub const fn get(self) -> f64 {
        self.0
    }
}

impl Density {
    /// A density in kg/m^3 (solid) or kg/m^2 (shell).
    ///
    /// # Errors
    /// When it is not positive and finite.
    pub fn new(value: f64) -> Result<Self, MassPropertiesError> {
        if value > 0.0 && value.is_finite() { Ok(Self(value)) } else { Err(MassPropertiesError::Density(value)) }
    }

    /// In kg/m^3 or kg/m^2.
    pub const fn get(self) -> f64 {
        self.0
    }
}

/// Mass properties of a body B: mass, centre of mass in the body frame, inertia about it in body axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassProperties {
    mass: Mass,
    center_of_mass: DVec3,
    inertia: Inertia,
}

impl MassProperties {
    /// From mass, centre of mass `p_BBcm` (m) and inertia `I_BBcm_B`, each valid by its type.
    pub const fn new(mass: Mass, center_of_mass: DVec3, inertia: Inertia) -> Self {
        Self { mass, center_of_mass, inertia }
    }

    /// Mass, kg.
    pub const fn mass(&self) -> f64 {
        self.mass.get()
    }

    /// `p_BBcm`, m.
    pub const fn center_of_mass(&self) -> DVec3 {
        self.center_of_mass
    }

    /// `I_BBcm_B`, kg m^2.
    pub const fn inertia(&self) -> &Inertia {
        &self.inertia
    }

    /// Principal moments and axes about the centre of mass.
    pub fn principal_axes(&self) -> PrincipalAxes {
        self.inertia.principal_axes()
    }

    /// The same body seen from frame A, given `X_AB`.
    pub fn in_frame(&self, pose: &Pose) -> Self {
        Self {
            mass: self.mass,
            center_of_mass: pose.transform_point(self.center_of_mass),
            inertia: self.inertia.rotated(pose.rotation),
        }
    }

    /// Those of the image in a mirror in the plane x = 0 of the body's frame.
    pub fn mirrored(&self) -> Self {
        let center_of_mass = Handedness::Mirrored.vector(self.center_of_mass);
        Self { mass: self.mass, center_of_mass, inertia: self.inertia.mirrored() }
    }

    /// The rigid union of two bodies given in the same frame.
    ///
    /// # Errors
    /// When the sum of the masses overflows.
    pub fn combined(&self, other: &Self) -> Result<Self, MassPropertiesError> {
        let (m1, m2) = (self.mass(), other.mass());
        let mass = Mass::new(m1 + m2)?;
        // About the joint centre of mass the two shifts add up to the reduced mass at their distance: no cancellation.
        let arm = other.center_of_mass - self.center_of_mass;
        let reduced = m1 * (m2 / mass.get());
        let inertia = self.inertia.matrix() + other.inertia.matrix() + point_inertia(reduced, arm);
        Ok(Self {
            mass,
            center_of_mass: self.center_of_mass + arm * (m2 / mass.get()),
            inertia: Inertia::new(inertia)?,
        })
    }
}

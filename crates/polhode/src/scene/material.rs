//! Materials, and the friction and restitution of a pair of them.

use super::SceneError;
use super::grain::{FrictionEllipse, GivenFriction, Grain, GrainOf};
use super::restitution::{Restitution, RestitutionSpeed};
use polhode_spatial::DVec3;

/// Friction and restitution of a material, or of a pair of them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Material {
    name: String,
    friction: FrictionEllipse,
    static_friction: FrictionEllipse,
    grain: Option<Grain>,
    restitution: Restitution,
    rolling_friction: f64,
    spinning_friction: f64,
    /// Young's modulus, Pa, and Poisson's ratio; none for a rigid material.
    elastic: Option<[f64; 2]>,
}

impl Material {
    /// A material of this name without friction and restitution. The empty name is that of a body without a material.
    ///
    /// ```
    /// use polhode::scene::Material;
    /// let rubber = Material::new("rubber").with_friction(0.8)?.with_restitution(0.6)?;
    /// assert_eq!((rubber.friction(), rubber.static_friction(), rubber.restitution()), (0.8, 0.8, 0.6));
    /// # Ok::<(), polhode::SceneError>(())
    /// ```
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), ..Self::default() }
    }

    /// The same material with this coefficient of friction, kinetic and static, in all directions.
    ///
    /// # Errors
    /// When it is negative or not finite.
    pub fn with_friction(self, friction: f64) -> Result<Self, SceneError> {
        check_friction(&self.name, friction)?;
        let friction = FrictionEllipse::circle(friction);
        Ok(Self { friction, static_friction: friction, grain: None, ..self })
    }

    /// The same material with this coefficient of restitution.
    ///
    /// # Errors
    /// When it is outside [0, 1].
    pub fn with_restitution(self, restitution: f64) -> Result<Self, SceneError> {
        check_restitution(&self.name, restitution)?;
        Ok(Self { restitution: Restitution::constant(restitution), ..self })
    }

    /// The same material, whose restitution falls with speed: its coefficient is that of slow impacts then.
    ///
    /// # Errors
    /// When the yield speed is not positive, or the slope would let restitution rise with speed.
    pub fn with_restitution_speed(self, speed: RestitutionSpeed) -> Result<Self, SceneError> {
        let restitution = self.restitution.with_speed(&self.name, speed)?;
        Ok(Self { restitution, ..self })
    }

    /// The same material with a grain: `direction`, of any length, in the frame of each body that is made of it, and
    /// the coefficients of friction along and across it. They are both static and kinetic. Where the grain stands on
    /// end, along the normal of a contact, every direction of slip is across it.
    ///
    /// # Errors
    /// When a coefficient is not finite and positive, one is more than 1000 times the other, or the direction is zero
    /// or not finite.
    pub fn with_grain(self, direction: DVec3, friction: FrictionEllipse) -> Result<Self, SceneError> {
        friction.check(&self.name)?;
        let grain = Some(Grain::new(&self.name, direction)?);
        Ok(Self { friction, static_friction: friction, grain, ..self })
    }

    /// The same material with a coefficient of static friction of its own.
    ///
    /// # Errors
    /// When it is not finite, or below the coefficient of kinetic friction.
    pub fn with_static_friction(self, static_friction: f64) -> Result<Self, SceneError> {
        check_static_friction(&self.name, static_friction, self.friction.largest())?;
        Ok(Self { static_friction: FrictionEllipse::circle(static_friction), ..self })
    }

    /// The same material, which has a grain, with coefficients of static friction along and across it.
    ///
    /// # Errors
    /// When it has no grain, or a coefficient is not finite or below that of kinetic friction in its direction.
    pub fn with_static_ellipse(self, static_friction: FrictionEllipse) -> Result<Self, SceneError> {
        if self.grain.is_none() {
            return Err(SceneError::StaticGrain { material: self.name });
        }
        check_static_friction(&self.name, static_friction.along, self.friction.along)?;
        check_static_friction(&self.name, static_friction.across, self.friction.across)?;
        static_friction.check(&self.name)?;
        Ok(Self { static_friction, ..self })
    }

    /// The same material with friction of rolling and of spinning, m: a contact resists them by moments of up to these
    /// lengths times its normal force.
    ///
    /// # Errors
    /// When one is negative or not finite.
    pub fn with_rotational_friction(self, rolling: f64, spinning: f64) -> Result<Self, SceneError> {
        check_rotational_friction(&self.name, "rolling", rolling)?;
        check_rotational_friction(&self.name, "spinning", spinning)?;
        Ok(Self { rolling_friction: rolling, spinning_friction: spinning, ..self })
    }

    /// The same material with Young's modulus (Pa) and Poisson's ratio, for springs after Hertz; without them a
    /// material is rigid.
    ///
    /// # Errors
    /// When the modulus is not positive and finite, or the ratio is outside [0, 0.5].
    pub fn with_elasticity(self, youngs_modulus_pa: f64, poisson_ratio: f64) -> Result<Self, SceneError> {
        let refused = |key, value, accepted| {
            Err(SceneError::ElasticConstant { material: self.name.clone(), key, value, accepted })
        };
        if !(youngs_modulus_pa.is_finite() && youngs_modulus_pa > 0.0) {
            return refused("youngs_modulus_pa", youngs_modulus_pa, "a positive, finite number");
        }
        if !(0.0..=0.5).contains(&poisson_ratio) {
            return refused("poisson_ratio", poisson_ratio, "a number in [0, 0.5]");
        }
        Ok(Self { elastic: Some([youngs_modulus_pa, poisson_ratio]), ..self })
    }

    /// Young's modulus (Pa) and Poisson's ratio; none for a rigid material.
    pub fn elastic_constants(&self) -> Option<[f64; 2]> {
        self.elastic
    }

    /// The same material of mirrored bodies.
    pub(super) fn mirrored(self) -> Self {
        Self { grain: self.grain.map(Grain::mirrored), ..self }
    }

    /// The material's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Coefficient of kinetic friction: a contact that slips bears a tangential force of this times its normal force.
    /// With a grain: along it.
    pub fn friction(&self) -> f64 {
        self.friction.along
    }

    /// Coefficient of static friction: a contact that sticks bears a tangential force of at most this times its normal
    /// force. With a grain: along it.
    pub fn static_friction(&self) -> f64 {
        self.static_friction.along
    }

    /// Coefficients of kinetic friction along and across the grain; without a grain both are the same.
    pub fn friction_ellipse(&self) -> FrictionEllipse {
        self.friction
    }

    /// Coefficients of static friction along and across the grain; without a grain both are the same.
    pub fn static_ellipse(&self) -> FrictionEllipse {
        self.static_friction
    }

    /// The direction of the grain in the frame of the body, a unit vector; none without a grain. Of a pair of
    /// materials: in the frame of the body whose grain it is.
    pub fn grain_direction(&self) -> Option<DVec3> {
        self.grain.map(|grain| grain.direction)
    }

    /// The grain, and of a pair of materials whose it is.
    pub(crate) fn grain(&self) -> Option<Grain> {
        self.grain
    }

    /// Whether friction is the same in all directions.
    pub(super) fn is_isotropic(&self) -> bool {
        self.friction.along == self.friction.across && self.static_friction.along == self.static_friction.across
    }

    /// Friction of rolling, m: the moment about an axis in the tangent plane is at most this times the normal force.
    pub fn rolling_friction(&self) -> f64 {
        self.rolling_friction
    }

    /// Friction of spinning, m: the moment about the normal is at most this times the normal force.
    pub fn spinning_friction(&self) -> f64 {
        self.spinning_friction
    }

    /// Coefficient of restitution; where it depends on speed, that of slow impacts, the largest.
    pub fn restitution(&self) -> f64 {
        self.restitution.slow()
    }

    /// Coefficient of restitution at a speed of approach, m/s.
    pub fn restitution_at(&self, speed: f64) -> f64 {
        self.restitution.at(speed)
    }

    /// Restitution with all its numbers.
    pub(super) fn restitution_numbers(&self) -> [f64; 6] {
        self.restitution.numbers()
    }

    /// The default rule for two materials: friction of all kinds is the geometric mean, restitution the larger of the
    /// two.
    pub fn combined(&self, other: &Self) -> Self {
        Self {
            name: String::new(),
            friction: self.friction.combined(other.friction),
            static_friction: self.static_friction.combined(other.static_friction),
            grain: Grain::of_pair(self.grain, other.grain),
            restitution: self.restitution.combined(other.restitution),
            rolling_friction: (self.rolling_friction * other.rolling_friction).sqrt(),
            spinning_friction: (self.spinning_friction * other.spinning_friction).sqrt(),
            elastic: None,
        }
    }
}

/// Friction and restitution of a pair of materials, where they differ from the default rule.
#[derive(Debug, Clone, PartialEq)]
pub struct PairRule {
    materials: [String; 2],
    friction: Option<GivenFriction>,
    static_friction: Option<FrictionEllipse>,
    restitution: Option<Restitution>,
    rolling_friction: Option<f64>,
    spinning_friction: Option<f64>,
}

impl PairRule {
    /// A rule for the materials of these names, in either order. What it is not given follows the default rule.
    pub fn new(materials: [String; 2]) -> Self {
        Self {
            materials,
            friction: None,
            static_friction: None,
            restitution: None,
            rolling_friction: None,
            spinning_friction: None,
        }
    }

    /// The same rule with this coefficient of friction, kinetic and static.
    ///
    /// # Errors
    /// As [`Material::with_friction`].
    pub fn with_friction(self, friction: f64) -> Result<Self, SceneError> {
        check_friction(&self.name(), friction)?;
        let static_friction = Some(FrictionEllipse::circle(friction));
        Ok(Self { friction: Some(GivenFriction::Circle(friction)), static_friction, ..self })
    }

    /// The same rule with this coefficient of restitution.
    ///
    /// # Errors
    /// As [`Material::with_restitution`].
    pub fn with_restitution(self, restitution: f64) -> Result<Self, SceneError> {
        check_restitution(&self.name(), restitution)?;
        Ok(Self { restitution: Some(Restitution::constant(restitution)), ..self })
    }

    /// The same rule, whose restitution falls with speed. Nothing where the rule has no coefficient.
    ///
    /// # Errors
    /// As [`Material::with_restitution_speed`].
    pub fn with_restitution_speed(self, speed: RestitutionSpeed) -> Result<Self, SceneError> {
        let name = self.name();
        let restitution = self.restitution.map(|of| of.with_speed(&name, speed)).transpose()?;
        Ok(Self { restitution, ..self })
    }

    /// The same rule with coefficients of friction along and across a grain, both static and kinetic. `direction` is in
    /// the frame of the bodies of the first of the two materials; without it the grain is that of whichever of them has
    /// one.
    ///
    /// # Errors
    /// As [`Material::with_grain`], and when the rule is about one material with itself and gives a direction: it would
    /// not be clear whose grain it is.
    pub fn with_grain(self, direction: Option<DVec3>, friction: FrictionEllipse) -> Result<Self, SceneError> {
        let name = self.name();
        friction.check(&name)?;
        let direction = direction.map(|direction| Grain::new(&name, direction)).transpose()?;
        if direction.is_some() && self.materials[0] == self.materials[1] {
            return Err(SceneError::TwoGrains { materials: self.materials });
        }
        let given = GivenFriction::Ellipse(friction, direction.map(|grain| grain.direction));
        Ok(Self { friction: Some(given), static_friction: Some(friction), ..self })
    }

    /// The same rule with a coefficient of static friction of its own.
    ///
    /// # Errors
    /// When it is not finite, or below the coefficient of kinetic friction of the rule.
    pub fn with_static_friction(self, static_friction: f64) -> Result<Self, SceneError> {
        let kinetic = self.friction.map_or(0.0, |friction| friction.ellipse().largest());
        check_static_friction(&self.name(), static_friction, kinetic)?;
        Ok(Self { static_friction: Some(FrictionEllipse::circle(static_friction)), ..self })
    }

    /// The same rule with coefficients of static friction along and across the grain that the rule or one of the
    /// materials gives.
    ///
    /// # Errors
    /// As [`Material::with_static_ellipse`], and when the rule gives friction without a grain.
    pub fn with_static_ellipse(self, static_friction: FrictionEllipse) -> Result<Self, SceneError> {
        let name = self.name();
        let kinetic = match self.friction {
            Some(GivenFriction::Circle(_)) => return Err(SceneError::StaticGrain { material: name }),
            Some(GivenFriction::Ellipse(ellipse, _)) => ellipse,
            None => FrictionEllipse::default(),
        };
        check_static_friction(&name, static_friction.along, kinetic.along)?;
        check_static_friction(&name, static_friction.across, kinetic.across)?;
        static_friction.check(&name)?;
        Ok(Self { static_friction: Some(static_friction), ..self })
    }

    /// The same rule for mirrored bodies.
    pub(super) fn mirrored(self) -> Self {
        Self { friction: self.friction.map(GivenFriction::mirrored), ..self }
    }

    /// Both names, for messages.
    fn name(&self) -> String {
        self.materials.join(" on ")
    }

    /// Whether it gives friction along and across a grain.
    pub(super) fn has_grain(&self) -> bool {
        matches!(self.friction, Some(GivenFriction::Ellipse(..)))
    }

    /// The same rule with friction of rolling and of spinning, m; `None` keeps the default rule.
    ///
    /// # Errors
    /// As [`Material::with_rotational_friction`].
    pub fn with_rotational_friction(self, rolling: Option<f64>, spinning: Option<f64>) -> Result<Self, SceneError> {
        let name = self.materials.join(" on ");
        rolling.map_or(Ok(()), |rolling| check_rotational_friction(&name, "rolling", rolling))?;
        spinning.map_or(Ok(()), |spinning| check_rotational_friction(&name, "spinning", spinning))?;
        Ok(Self { rolling_friction: rolling, spinning_friction: spinning, ..self })
    }

    /// Overrides `combined` when the rule is about these two materials.
    pub(super) fn apply(&self, a: &Material, b: &Material, combined: &mut Material) {
        let [first, second] = &self.materials;
        if (first == &a.name && second == &b.name) || (first == &b.name && second == &a.name) {
            match self.friction {
                None | Some(GivenFriction::Ellipse(_, None)) => {}
                Some(GivenFriction::Circle(_)) => combined.grain = None,
                Some(GivenFriction::Ellipse(_, Some(direction))) => {
                    let of = if first == &a.name { GrainOf::First } else { GrainOf::Second };
                    combined.grain = Some(Grain { direction, of });
                }
            }
            combined.friction = self.friction.map_or(combined.friction, GivenFriction::ellipse);
            // A rule for static friction alone may be below the kinetic friction of the two materials.
            let static_friction = self.static_friction.unwrap_or(combined.static_friction);
            combined.static_friction = static_friction.including(combined.friction);
            combined.restitution = self.restitution.unwrap_or(combined.restitution);
            combined.rolling_friction = self.rolling_friction.unwrap_or(combined.rolling_friction);
            combined.spinning_friction = self.spinning_friction.unwrap_or(combined.spinning_friction);
        }
    }
}

fn check_friction(material: &str, friction: f64) -> Result<(), SceneError> {
    if friction.is_finite() && friction >= 0.0 {
        Ok(())
    } else {
        Err(SceneError::Friction { material: material.to_owned(), value: friction })
    }
}

fn check_static_friction(material: &str, static_friction: f64, friction: f64) -> Result<(), SceneError> {
    if static_friction.is_finite() && static_friction >= friction {
        Ok(())
    } else {
        Err(SceneError::StaticFriction { material: material.to_owned(), value: static_friction, kinetic: friction })
    }
}

fn check_rotational_friction(material: &str, kind: &'static str, length: f64) -> Result<(), SceneError> {
    if length.is_finite() && length >= 0.0 {
        Ok(())
    } else {
        Err(SceneError::RotationalFriction { material: material.to_owned(), kind, value: length })
    }
}

fn check_restitution(material: &str, restitution: f64) -> Result<(), SceneError> {
    if (0.0..=1.0).contains(&restitution) {
        Ok(())
    } else {
        Err(SceneError::Restitution { material: material.to_owned(), value: restitution })
    }
}

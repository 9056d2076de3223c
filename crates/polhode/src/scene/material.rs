//! Materials, and the friction and restitution of a pair of them.

use super::SceneError;

/// Friction and restitution of a material, or of a pair of them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Material {
    name: String,
    friction: f64,
    static_friction: f64,
    restitution: f64,
    rolling_friction: f64,
    spinning_friction: f64,
}

impl Material {
    /// A material of this name, with one coefficient for static and kinetic friction. The empty name is that of a body
    /// without a material: friction 0, restitution 0.
    ///
    /// # Errors
    /// When friction is negative or restitution outside [0, 1], or one is not finite.
    pub fn new(name: impl Into<String>, friction: f64, restitution: f64) -> Result<Self, SceneError> {
        let name = name.into();
        check_friction(&name, friction)?;
        check_restitution(&name, restitution)?;
        Ok(Self { name, friction, static_friction: friction, restitution, ..Self::default() })
    }

    /// The same material with a coefficient of static friction of its own.
    ///
    /// # Errors
    /// When it is not finite, or below the coefficient of kinetic friction.
    pub fn with_static_friction(self, static_friction: f64) -> Result<Self, SceneError> {
        check_static_friction(&self.name, static_friction, self.friction)?;
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

    /// The material's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Coefficient of kinetic friction: a contact that slips bears a tangential force of this times its normal force.
    pub fn friction(&self) -> f64 {
        self.friction
    }

    /// Coefficient of static friction: a contact that sticks bears a tangential force of at most this times its normal
    /// force.
    pub fn static_friction(&self) -> f64 {
        self.static_friction
    }

    /// Friction of rolling, m: the moment about an axis in the tangent plane is at most this times the normal force.
    pub fn rolling_friction(&self) -> f64 {
        self.rolling_friction
    }

    /// Friction of spinning, m: the moment about the normal is at most this times the normal force.
    pub fn spinning_friction(&self) -> f64 {
        self.spinning_friction
    }

    /// Coefficient of restitution.
    pub fn restitution(&self) -> f64 {
        self.restitution
    }

    /// The default rule for two materials: friction of all kinds is the geometric mean, restitution the larger of the
    /// two.
    pub fn combined(&self, other: &Self) -> Self {
        Self {
            name: String::new(),
            friction: (self.friction * other.friction).sqrt(),
            static_friction: (self.static_friction * other.static_friction).sqrt(),
            restitution: self.restitution.max(other.restitution),
            rolling_friction: (self.rolling_friction * other.rolling_friction).sqrt(),
            spinning_friction: (self.spinning_friction * other.spinning_friction).sqrt(),
        }
    }
}

/// Friction and restitution of a pair of materials, where they differ from the default rule.
#[derive(Debug, Clone, PartialEq)]
pub struct PairRule {
    materials: [String; 2],
    friction: Option<f64>,
    static_friction: Option<f64>,
    restitution: Option<f64>,
    rolling_friction: Option<f64>,
    spinning_friction: Option<f64>,
}

impl PairRule {
    /// A rule for the materials of these names, in either order; `None` keeps the default rule. Friction is both static
    /// and kinetic.
    ///
    /// # Errors
    /// As [`Material::new`].
    pub fn new(materials: [String; 2], friction: Option<f64>, restitution: Option<f64>) -> Result<Self, SceneError> {
        let name = materials.join(" on ");
        friction.map_or(Ok(()), |f| check_friction(&name, f))?;
        restitution.map_or(Ok(()), |e| check_restitution(&name, e))?;
        let (rolling_friction, spinning_friction) = (None, None);
        Ok(Self { materials, friction, static_friction: friction, restitution, rolling_friction, spinning_friction })
    }

    /// The same rule with a coefficient of static friction of its own.
    ///
    /// # Errors
    /// When it is not finite, or below the coefficient of kinetic friction of the rule.
    pub fn with_static_friction(self, static_friction: f64) -> Result<Self, SceneError> {
        check_static_friction(&self.materials.join(" on "), static_friction, self.friction.unwrap_or(0.0))?;
        Ok(Self { static_friction: Some(static_friction), ..self })
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
            combined.friction = self.friction.unwrap_or(combined.friction);
            // A rule for static friction alone may be below the kinetic friction of the two materials.
            let static_friction = self.static_friction.unwrap_or(combined.static_friction);
            combined.static_friction = static_friction.max(combined.friction);
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

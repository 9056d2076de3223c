//! Materials, and the friction and restitution of a pair of them.

use super::SceneError;

/// Friction and restitution of a material, or of a pair of them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Material {
    name: String,
    friction: f64,
    restitution: f64,
}

impl Material {
    /// A material of this name. The empty name is that of a body without a material: friction 0, restitution 0.
    ///
    /// # Errors
    /// When friction is negative or restitution outside [0, 1], or one is not finite; friction above zero is not yet
    /// available.
    pub fn new(name: impl Into<String>, friction: f64, restitution: f64) -> Result<Self, SceneError> {
        let name = name.into();
        check_friction(&name, friction)?;
        check_restitution(&name, restitution)?;
        Ok(Self { name, friction, restitution })
    }

    /// The material's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Coefficient of Coulomb friction.
    pub fn friction(&self) -> f64 {
        self.friction
    }

    /// Coefficient of restitution.
    pub fn restitution(&self) -> f64 {
        self.restitution
    }

    /// The default rule for two materials: friction is the geometric mean, restitution the larger of the two.
    pub fn combined(&self, other: &Self) -> Self {
        Self {
            name: String::new(),
            friction: (self.friction * other.friction).sqrt(),
            restitution: self.restitution.max(other.restitution),
        }
    }
}

/// Friction and restitution of a pair of materials, where they differ from the default rule.
#[derive(Debug, Clone, PartialEq)]
pub struct PairRule {
    materials: [String; 2],
    friction: Option<f64>,
    restitution: Option<f64>,
}

impl PairRule {
    /// A rule for the materials of these names, in either order; `None` keeps the default rule.
    ///
    /// # Errors
    /// As [`Material::new`].
    pub fn new(materials: [String; 2], friction: Option<f64>, restitution: Option<f64>) -> Result<Self, SceneError> {
        let name = materials.join(" on ");
        friction.map_or(Ok(()), |f| check_friction(&name, f))?;
        restitution.map_or(Ok(()), |e| check_restitution(&name, e))?;
        Ok(Self { materials, friction, restitution })
    }

    /// Overrides `combined` when the rule is about these two materials.
    pub(super) fn apply(&self, a: &Material, b: &Material, combined: &mut Material) {
        let [first, second] = &self.materials;
        if (first == &a.name && second == &b.name) || (first == &b.name && second == &a.name) {
            combined.friction = self.friction.unwrap_or(combined.friction);
            combined.restitution = self.restitution.unwrap_or(combined.restitution);
        }
    }
}

fn check_friction(material: &str, friction: f64) -> Result<(), SceneError> {
    if !(friction.is_finite() && friction >= 0.0) {
        return Err(SceneError::Friction { material: material.to_owned(), value: friction });
    }
    if friction > 0.0 {
        return Err(SceneError::NotYetAvailable {
            what: format!("friction (material {material}: {friction})"),
            instead: "friction = 0".to_owned(),
        });
    }
    Ok(())
}

fn check_restitution(material: &str, restitution: f64) -> Result<(), SceneError> {
    if (0.0..=1.0).contains(&restitution) {
        Ok(())
    } else {
        Err(SceneError::Restitution { material: material.to_owned(), value: restitution })
    }
}

//! Builds a scene and holds it against its tier: whether the tier has what the scene describes.
//!
//! A scene knows no tier: `crate::scene` checks what each part needs, `constraint/at_start.rs` what joints need at the
//! start. The order of the checks here decides which error is told first.

use super::facts::{IntegratorChoice, TierFeature};
use crate::scene::{Freedom, ImpactLaw, Integrator, Joint, Response, Scene, SceneBuilder, SceneError, Tier};

impl SceneBuilder {
    /// The scene.
    ///
    /// # Errors
    /// When a number is out of range, a name is empty or used twice, a body that does not exist is named, or the scene
    /// asks for something that is not yet available. Bodies that overlap are found later, by
    /// [`Simulation::new`](crate::Simulation::new).
    pub fn build(self) -> Result<Scene, SceneError> {
        let mut scene = self.parts();
        scene.check_numbers()?;
        scene.method.validate()?;
        scene.check_counts()?;
        scene.check_parts()?;
        scene.place_on_tracks()?;
        // Bodies at rest that agree with their motions stay so: the rounding of a rate is no motion.
        if scene.check_ties().is_err() {
            scene.find_start_velocities();
        }
        scene.check_joints()?;
        scene.check_ties()?;
        scene.check_joint_method()?;
        scene.check_coordinates()?;
        scene.check_grains()?;
        scene.check_motions()?;
        scene.check_surfaces()?;
        scene.check_springs_in(scene.method.named_tier().unwrap_or_default())?;
        Ok(scene)
    }
}

impl Scene {
    /// Checks the method, the motions, and that the numbers of samples and steps are bounded.
    ///
    /// # Errors
    /// As [`SceneBuilder::build`].
    pub(crate) fn check_times(&self) -> Result<(), SceneError> {
        self.method.validate()?;
        self.check_joint_method()?;
        self.check_motions()?;
        self.check_ties()?;
        self.check_counts()
    }

    /// Checks that the scene suits its method: a run beside a run by another method.
    ///
    /// # Errors
    /// As [`SceneBuilder::build`].
    pub(crate) fn check_method(&self) -> Result<(), SceneError> {
        self.check_times()?;
        self.check_coordinates()?;
        self.check_surfaces()?;
        self.check_springs_in(self.method.named_tier().unwrap_or_default())
    }

    /// Checks that the tier has the materials, which a program has changed.
    ///
    /// # Errors
    /// As [`SceneBuilder::build`].
    pub(crate) fn check_materials(&self) -> Result<(), SceneError> {
        self.check_grains()?;
        self.check_surfaces()?;
        self.check_springs_in(self.method.named_tier().unwrap_or_default())
    }

    /// Takes a joint that a program adds to a simulation by this tier, between bodies as they are then. Returns it at
    /// its place: of a track on it.
    ///
    /// # Errors
    /// As [`SceneBuilder::build`], but that its bodies may move as it does not allow: it stops them.
    pub(crate) fn take_joint(&mut self, joint: &Joint, tier: Tier) -> Result<Joint, SceneError> {
        let number = self.joints.len();
        self.check_joint(number, joint)?;
        let placed = self.placed_on_track(number, joint)?;
        self.joints.push(placed);
        self.check_joints_in(tier)?;
        self.check_coordinates()?;
        self.check_motions()?;
        self.check_springs_in(tier)?;
        Ok(placed)
    }

    /// Checks that the tier has the friction and the effects of surfaces.
    ///
    /// # Errors
    /// When it does not.
    fn check_surfaces(&self) -> Result<(), SceneError> {
        let tier = self.method.named_tier().unwrap_or_default().facts();
        if !tier.takes(TierFeature::Friction) && self.colliding().have_friction() {
            let instead = Tier::names_with(TierFeature::Friction);
            return Err(SceneError::FrictionInTier { tier: tier.name, instead });
        }
        if self.method.impact == Some(ImpactLaw::Pulse) && self.colliding().largest_rotational_friction > 0.0 {
            let what = "impact = \"pulse\" where contacts resist rolling or spinning".to_owned();
            let instead = "rolling_friction = 0 and spinning_friction = 0, or impact = \"energetic\", \"poisson\" or \
                \"reflection\""
                .to_owned();
            return Err(SceneError::NotYetAvailable { what, instead });
        }
        if let (false, Some(effect)) = (tier.takes(TierFeature::SurfaceEffects), self.surface_effect())
            && tier.takes(TierFeature::Friction)
        {
            let instead = format!("tier {}", Tier::names_with(TierFeature::SurfaceEffects));
            return Err(SceneError::NotYetAvailable {
                what: format!("{effect} with tier = \"{}\"", tier.name),
                instead,
            });
        }
        Ok(())
    }

    /// Checks that springs can do what the scene asks where the tier has them.
    fn check_springs_in(&self, tier: Tier) -> Result<(), SceneError> {
        if tier.facts().own_response == Some(Response::Penalty) { self.check_springs() } else { Ok(()) }
    }

    /// Checks that the method solves for joints.
    ///
    /// # Errors
    /// When its tier or its integrator does not.
    fn check_joint_method(&self) -> Result<(), SceneError> {
        if self.joints.is_empty() { Ok(()) } else { self.check_joints_in(self.method.named_tier().unwrap_or_default()) }
    }

    /// Checks that a tier solves for joints.
    fn check_joints_in(&self, tier: Tier) -> Result<(), SceneError> {
        let tier = tier.facts();
        match self.method.integrator {
            _ if !tier.takes(TierFeature::Joints) => {
                let instead = Tier::names_with(TierFeature::Joints);
                Err(SceneError::JointsInTier { tier: tier.name, instead })
            }
            _ if !tier.takes(TierFeature::AllOfJoints) => self.check_plain_joints(tier.name),
            None | Some(Integrator::Dop853 | Integrator::Rk4) => Ok(()),
            // A tier with an integrator of its own refuses all others.
            Some(_) if matches!(tier.integrator_choice, IntegratorChoice::Tier { .. }) => Ok(()),
            Some(integrator) => Err(SceneError::JointsWithIntegrator { integrator: integrator.name() }),
        }
    }

    /// Checks that joints have nothing beside what they hold, and limits of their coordinates.
    ///
    /// # Errors
    /// With the first joint that has.
    fn check_plain_joints(&self, tier: &str) -> Result<(), SceneError> {
        let instead = || {
            let tiers = Tier::names_with(TierFeature::AllOfJoints);
            format!(
                "joints without it (they hold, and their coordinates have limits without restitution), or tier {tiers}"
            )
        };
        let refuse = |what: String| Err(SceneError::NotYetAvailable { what, instead: instead() });
        if !self.gears.is_empty() || !self.coordinate_motions.is_empty() {
            return refuse(format!("a gear or a prescribed motion of a joint with tier = \"{tier}\""));
        }
        for (number, joint) in self.joints.iter().enumerate() {
            let has = |of: &dyn Fn(&Freedom) -> bool| {
                joint
                    .kind()
                    .coordinates()
                    .iter()
                    .filter_map(|&coordinate| joint.freedom(coordinate))
                    .any(|own| of(&own))
            };
            let found = [
                (joint.kind().is_on_track(), "a track"),
                (joint.bodies().any(|body| self.bodies[body].motion().is_some()), "a kinematic member"),
                (joint.strength().is_some(), "a strength"),
                (has(&|own| own.has_forces()), "a spring, damper or motor"),
                (has(&|own| own.friction().is_some()), "friction"),
                (has(&|own| own.limits().is_some_and(|limits| limits.restitution() > 0.0)), "a limit that bounces"),
            ];
            if let Some((_, what)) = found.into_iter().find(|(is_there, _)| *is_there) {
                return refuse(format!("joint {number} with {what} in tier = \"{tier}\""));
            }
        }
        Ok(())
    }
}

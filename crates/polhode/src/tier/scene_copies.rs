//! Builds a scene set otherwise, where what its method describes depends neither on the axes nor on the order of the
//! bodies.

use crate::scene::{CopyError, ImpactLaw, ListOrder, PropagationOrder, Scene, SceneCopy};

impl SceneCopy {
    /// The scene set otherwise.
    ///
    /// # Errors
    /// When a part of it cannot be, or what it describes depends on the axes or the order.
    pub fn of(&self, scene: &Scene) -> Result<Scene, CopyError> {
        self.check_impacts(scene)?;
        Ok(self.parts_of(scene)?.build()?)
    }

    /// Checks that impacts do the same in other axes and in another order of the bodies.
    fn check_impacts(&self, scene: &Scene) -> Result<(), CopyError> {
        let method = scene.method();
        let law = method.impact.unwrap_or(method.named_tier().unwrap_or_default().facts().impact);
        match method.propagation_order.unwrap_or_default() {
            _ if law != ImpactLaw::Propagation || !scene.any_may_collide() => Ok(()),
            PropagationOrder::Random { .. } => Err(CopyError::StruckAtRandom),
            PropagationOrder::Key | PropagationOrder::Depth if self.order() == ListOrder::Reversed => {
                Err(CopyError::StruckByNumber)
            }
            PropagationOrder::Key | PropagationOrder::Depth => Ok(()),
        }
    }
}

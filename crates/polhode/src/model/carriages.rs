//! Carriages: kinematic bodies without a shape whose displacements along x are the prescribed motions of joint
//! coordinates.
//!
//! They follow the bodies of the scene, nobody sees them, and they count as removed but for their motion. A carriage is
//! a body so that all that holds for kinematic bodies holds for prescribed coordinates: states at every stage,
//! accelerations, the work on others, the times at which a motion is not smooth, whether it stands still
//! (`prescribed.rs`).

use super::body::ModelBody;
use crate::model::pivot_form::PivotForm;
use crate::scene::{Body, Scene, SceneError};

/// Adds the carriages of a scene to it. Returns their bodies for the model.
///
/// # Errors
/// Those of a body.
pub(super) fn add_carriages(scene: &mut Scene) -> Result<Vec<ModelBody>, SceneError> {
    let mut added = Vec::with_capacity(scene.coordinate_motions.len());
    for number in 0..scene.coordinate_motions.len() {
        let (end, motion) = &scene.coordinate_motions[number];
        let name = format!("prescribed motion of joint {}", end.joint.index());
        let body = Body::kinematic(name, motion.along_x().clone());
        let mut carriage = ModelBody::new(&body, PivotForm::jointed(&body), || false)?;
        carriage.removed = true;
        scene.bodies.push(body);
        added.push(carriage);
    }
    Ok(added)
}

//! The cone problems of the groups of a run: what their solvers keep from step to step, and the forces of the last
//! step, from which the next one starts.
//!
//! The forces of the last step are part of the state of a run (`last_forces.rs`); what the solvers keep changes no bit
//! (`polhode_response::solve::step`).

use super::last_forces::LastForces;
use crate::rows::assembly::Assembly;
use crate::solve::cone_violation::{CONE_LIMIT, ConeViolation};
use polhode_response::solve::step::{StepMemory, StepProblem, StepRows};
use polhode_response::{Question, ResponseError, WarmStart};

/// Reactions whose violation of Coulomb's law is beyond this part of its limit are solved for to rounding (no unit,
/// 0.01 to 1).
const SHARE_OF_CONE_LIMIT: f64 = 0.1;

/// Whether reactions are to be found to rounding because of their violation of Coulomb's law.
pub(super) fn is_off(violation: Option<ConeViolation>) -> bool {
    violation.is_some_and(|found| found.value > SHARE_OF_CONE_LIMIT * CONE_LIMIT)
}

/// The solvers of the groups of a run, and the forces that they start from.
#[derive(Debug, Clone, Default)]
pub(super) struct ConeSolvers {
    memory: StepMemory,
    pub(super) last: LastForces,
}

impl ConeSolvers {
    /// Those of heaps.
    pub(super) fn of_heaps() -> Self {
        Self { memory: StepMemory::of_heaps(), last: LastForces::default() }
    }

    /// Forgets the answers that problems would start from.
    pub(super) fn forget(&mut self) {
        self.last = LastForces::default();
        self.memory.forget();
    }

    /// The problem of the rows of an assembly, the first of which are these contacts, in a step of `h` (s).
    ///
    /// # Errors
    /// When rows that need their matrix are too many for it.
    pub(super) fn problem<'a>(
        &'a mut self,
        assembly: &'a Assembly,
        constants: &'a [f64],
        known: &'a KnownOfGroup,
        h: f64,
    ) -> Result<StepProblem<'a>, ResponseError> {
        let KnownOfGroup { contacts, ref carried, noise_floor } = *known;
        let problem = assembly.with(Question { constants, start: Some(carried), noise_floor, ..Question::default() });
        let rows = StepRows { problem, contacts, group: assembly.bodies().first().copied() };
        let Self { memory, last } = self;
        memory.problem(rows, || last.start(assembly, contacts, h))
    }
}

/// What is known of the rows of a group before they are solved.
#[derive(Debug)]
pub(super) struct KnownOfGroup {
    /// How many contacts.
    pub(super) contacts: usize,
    /// Those that bore an impulse in the last step.
    pub(super) carried: WarmStart,
    /// The error of rates by rounding, m/s.
    pub(super) noise_floor: f64,
}

#[cfg(test)]
mod tests {
    //! With the matrix of all rows and in the velocities of bodies: the same motion of one pile, some of whose cubes
    //! move.
    #![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use crate::collision::contact_set;
    use crate::collision::{contact_kinematics, friction};
    use crate::model::Model;
    use crate::model::pivot_form::PivotRows;
    use crate::rows::assembly::TangentRow;
    use crate::rows::friction_blocks::push_contact;
    use crate::scene::Material;
    use crate::scene::{Body, Geometry, Scene};
    use polhode_contact::Shape;
    use polhode_dynamics::BodyState;
    use polhode_mesh::solid_box;
    use polhode_response::solve::way::is_in_bodies;
    use polhode_response::{Blocks, SolverStatus};
    use polhode_spatial::{DVec3, Mass, Pose, UnitVector, Velocity};

    /// Ten cubes in a pyramid that fall for a step under gravity; those above slide along.
    fn pile() -> (Model, Vec<BodyState>) {
        let material = Material::new("rough").with_friction(0.5).unwrap();
        let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into());
        let mut scene = Scene::builder("pile").body(floor.material(material.clone()));
        for (row, column) in (0..4).flat_map(|row| (0..4 - row).map(move |column| (row, column))) {
            let place = DVec3::new((f64::from(column) + 0.5 * f64::from(row)) * 1.1, 0.0, f64::from(row) + 0.5);
            let shape = Geometry::Shape(Shape::cuboid(DVec3::ONE).unwrap());
            let fall = DVec3::new(0.05 * f64::from(row * column), 0.02 * f64::from(row), -9.81 / 60.0);
            let cube =
                Body::movable(format!("{row} {column}"), solid_box(DVec3::ONE, Mass::new(1.0).unwrap()).unwrap());
            let cube = cube.geometry(shape).pose(Pose::from_translation(place));
            scene = scene.body(cube.velocity(Velocity::new(fall, DVec3::ZERO)).material(material.clone()));
        }
        Model::new(&scene.build().unwrap(), PivotRows::default()).unwrap()
    }

    #[test]
    fn rows_and_bodies_give_one_motion() {
        let (model, states) = pile();
        let bodies: Vec<usize> = (1..states.len()).collect();
        let pairs = (0..states.len()).flat_map(|a| (a + 1..states.len()).map(move |b| (a, b)));
        let touches: Vec<_> =
            pairs.flat_map(|(a, b)| contact_set::contacts_of_pair(&model, &states, a, b, 1e-9)).collect();
        let geometries = touches.iter().map(|touch| (touch.id, touch.kinematics.geometry));
        let mut assembly = Assembly::new(&model, &states, &bodies, geometries).unwrap();
        let mut constants: Vec<f64> = touches.iter().map(|touch| touch.kinematics.separation_rate).collect();
        let mut blocks = Blocks::default();
        for (normal, touch) in touches.iter().enumerate() {
            let terms = contact_kinematics::tangential_kinematics(&model, &states, touch.id).unwrap();
            let ellipse = friction::friction_at(&model, &states, touch.id, terms.basis).unwrap().at_rest;
            let first = assembly.problem.len();
            let row = |tangent| TangentRow::new(touch.id, &touch.kinematics.geometry, &terms, tangent);
            assembly.push_tangents(&states, terms.basis.map(row).into_iter()).unwrap();
            constants.extend(terms.basis.map(|tangent| tangent.dot(terms.slip_velocity)));
            push_contact(&mut blocks, ellipse, normal, first..assembly.problem.len());
        }
        assert!(is_in_bodies(&assembly.problem, touches.len()), "{} contacts", touches.len());
        let known = KnownOfGroup { contacts: touches.len(), carried: WarmStart::default(), noise_floor: 0.0 };
        let mut solvers = ConeSolvers::default();
        let mut problem = solvers.problem(&assembly, &constants, &known, 1.0 / 60.0).unwrap();
        assert!(problem.is_started_from());
        let in_bodies = problem.solve(&blocks, |_| false).unwrap();
        assert!(problem.factorisations() > 0 && in_bodies.report.residual < 1e-11, "{:?}", in_bodies.report);
        // A group of nobody is solved with the matrix of all rows.
        let question = Question { constants: &constants, start: Some(&known.carried), ..Question::default() };
        let few = StepRows { problem: assembly.with(question), contacts: touches.len(), group: None };
        let mut memory = StepMemory::default();
        let mut problem = memory.problem(few, || None).unwrap();
        assert!(!problem.is_started_from());
        let for_rows = problem.solve(&blocks, |_| false).unwrap();
        assert_eq!(for_rows.report.status, SolverStatus::Solved);
        let motions = [&in_bodies, &for_rows].map(|solved| assembly.problem.response(&solved.reactions).unwrap());
        for (a, b) in motions[0].iter().zip(&motions[1]) {
            assert!((a - b).abs() < 1e-9, "{a} in bodies, {b} with the matrix");
        }
    }
}

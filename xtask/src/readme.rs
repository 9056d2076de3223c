//! The example of the README is compiled and run as a test, and must stand in the README as it is here.

#[cfg(test)]
mod tests {
    //! The README's example works and says what it says here.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

    use std::path::Path;

    #[rustfmt::skip]
    fn example() -> Result<(), Box<dyn std::error::Error>> {
        // README begins
        use polhode::contact::Shape;
        use polhode::mesh::solid_box;
        use polhode::spatial::{DVec3, Mass, Pose, UnitVector};
        use polhode::{Body, Effects, Outcome, Recorder, Scene, Simulation};

        let size = DVec3::new(1.0, 0.5, 0.25);
        let brick = Body::movable("brick", solid_box(size, Mass::new(2.0)?)?)
            .geometry(Shape::cuboid(size)?.into())
            .pose(Pose::from_translation(DVec3::Z * 1.0));
        let floor = Body::fixed("floor").geometry(Shape::half_space(UnitVector::Z).into());
        let scene = Scene::builder("drop").body(floor).body(brick).duration_s(1.0).build()?;

        let mut record = Recorder::default();
        let report = Simulation::new(&scene, Effects::Planned)?.run(&mut record)?;
        assert!((report.bodies[1].1.pose.translation.z - 0.125).abs() < 1e-15);
        assert_eq!(report.outcome, Outcome::Completed);
        assert!(report.ledger.numerical.value().abs() < 1e-12 * report.ledger.scale_j);
        // README ends
        Ok(())
    }

    #[test]
    fn the_example_runs() {
        example().unwrap();
    }

    #[test]
    fn the_example_stands_in_the_readme() {
        let readme = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().join("README.md");
        let readme = std::fs::read_to_string(readme).unwrap();
        let block = readme.split("```rust\n").nth(1).unwrap().split("```").next().unwrap();
        let own = include_str!("readme.rs").split("// README begins\n").nth(1).unwrap();
        let own: String = own.split("        // README ends").next().unwrap().lines().map(unindented).collect();
        assert_eq!(block, own);
    }

    fn unindented(line: &str) -> String {
        format!("{}\n", line.strip_prefix("        ").unwrap_or(line))
    }
}

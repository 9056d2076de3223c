//! Bodies on a pivot.

use crate::{BASE, check, scene};
use polhode::spatial::DVec3;

/// `BASE` with lines put to the brick, whose centre of mass is at (0, 0, 10).
fn brick(lines: &str) -> String {
    BASE.replace("position = [0, 0, 10]", &format!("position = [0, 0, 10]\n{lines}"))
}

/// The pivot arrives; a velocity that is that of the rotation, to the digits that a file may hold, is as good as none.
#[test]
fn accepted() {
    let body = |lines: &str| scene(&brick(lines)).bodies()[1].clone();
    let spinning = "pivot = [0, 1, 8]\nangular_velocity = [3, 1, 0.5]";
    // w x (0, -1, 2) = (1 * 2 + 0.5, -3 * 2, -3)
    for velocity in
        ["", "velocity = [2.5, -6, -3]", "velocity = [2.500000001, -6, -3]", "velocity = [2.5, -6.0000000001, -3]"]
    {
        let body = body(&format!("{spinning}\n{velocity}"));
        assert_eq!(body.pivot_point(), Some(DVec3::new(0.0, 1.0, 8.0)));
        assert_eq!(body.initial_velocity().angular, DVec3::new(3.0, 1.0, 0.5));
    }
    body("pivot = [0, 0, 8]");
    body("pivot = [0, 0, 8]\nvelocity = [0, 0, 0]");
    // The pivot is the centre of mass, or lies on the axis of rotation.
    body("pivot = [0, 0, 10]\nvelocity = [0, 0, 0]\nangular_velocity = [1, 2, 3]");
    body("pivot = [0, 0, 8]\nvelocity = [0, 0, 0]\nangular_velocity = [0, 0, 3]");
    assert_eq!(scene(BASE).bodies()[1].pivot_point(), None);
}

/// A velocity of zero is that of the rotation when the centre of mass is on the axis, however the numbers round.
#[test]
fn leaning_spin_with_zero_velocity() {
    scene(&BASE.replace(
        "position = [0, 0, 10]",
        "position = [0.1, 0.7, 0.3]\npivot = [0, 0, 0]\nvelocity = [0, 0, 0]\nangular_velocity = [0.3, 2.1, 0.9]",
    ));
}

/// A velocity that would carry the pivot away is refused with the one that is needed: zero too, and one at rest.
#[test]
fn velocities_that_move_the_pivot() {
    let spinning = "pivot = [0, 1, 8]\nangular_velocity = [3, 1, 0.5]";
    for velocity in ["[0, 0, 0]", "[2.5, -6, 3]", "[2.50000002, -6, -3]"] {
        let line = format!("velocity = {velocity}");
        check(&brick(&format!("{spinning}\n{line}")), "bodies.brick.velocity", &line, "[2.5, -6.0, -3.0]");
    }
    let resting = "pivot = [0, 0, 8]\nvelocity = [0, 0, 1e-12]";
    check(&brick(resting), "bodies.brick.velocity", "velocity", "leave the velocity out");
}

/// A fixed body does not turn; a pivot is a point.
#[test]
fn refused() {
    let fixed = BASE.replace("fixed = true", "fixed = true\npivot = [0, 0, 0]");
    check(&fixed, "bodies.floor.pivot", "pivot", "`pivot` has no meaning for a fixed body");
    check(&brick("pivot = [0, nan, 0]"), "bodies.brick.pivot.1", "pivot", "a finite number");
    check(&brick("pivot = [0, 0]"), "bodies.brick.pivot", "pivot", "an array of length 3");
    check(&brick("pivot = true"), "bodies.brick.pivot", "pivot", "an array of length 3");
}

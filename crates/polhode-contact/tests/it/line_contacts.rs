//! An edge that lies along a face touches it on a line, whose two ends are contacts.

use crate::support::{cuboid, yaw};
use polhode_contact::{Manifold, manifold};
use polhode_spatial::{DVec3, Pose, Rotation};

/// A long box on its edge, turned by `turn` about the vertical and tilted by `tilt`, on a table whose border it extends
/// beyond; the line of contact runs from the box's end at x = -1 to the border at x = 1.
fn leaning_over_the_border(tilt: f64, turn: f64) -> Manifold {
    let (beam, table) = (cuboid(4.0, 0.5, 0.5), cuboid(2.0, 8.0, 1.0));
    let on_edge = Rotation::from_rotation_vector(DVec3::X * std::f64::consts::FRAC_PI_4);
    let rotation = yaw(turn) * Rotation::from_rotation_vector(DVec3::Y * tilt) * on_edge;
    let lowest = DVec3::new(0.0, -0.25, -0.25);
    let edge = rotation.rotate(lowest);
    let pose = Pose::new(rotation, DVec3::new(1.0, 0.0, 0.5) - edge);
    manifold(&beam, &pose, &table, &Pose::IDENTITY, 1e-2)
}

/// However little the edge is tilted, to whichever side, both ends of the line are contacts: the one at the end of the
/// box and the one at the border of the table.
#[test]
fn an_edge_tilted_by_less_than_anything_visible_keeps_both_ends() {
    for turn in [0.0, 0.3, -0.7] {
        for tilt in [0.0, 1e-15, 1e-13, 1e-12, 1e-11, 1e-10, 1e-8, 1e-6, 1e-4, 1e-3] {
            for tilt in [tilt, -tilt] {
                let found = leaning_over_the_border(tilt, turn);
                assert_eq!(found.contacts.len(), 2, "{turn} {tilt:e}: {found:?}");
                for contact in &found.contacts {
                    assert!(contact.geometry.normal.z > 0.999_99);
                    assert!(contact.geometry.separation.abs() <= 3.0 * tilt.abs() + 1e-15, "{tilt:e}: {contact:?}");
                }
            }
        }
    }
}

//! Spheres, clouds of points and half-spaces: closed forms.

use crate::support::{Random, at, ball, cuboid, floor};
use polhode_contact::{ContactFeature, SeparatingAxis, Shape, Side, SurfaceFeature, manifold, separation};
use polhode_spatial::{DVec3, Pose};

/// A sphere around a box: over a face, an edge and a vertex the nearest feature, the distance and the normal are known.
#[test]
fn sphere_around_a_box() {
    let cube = cuboid(2.0, 2.0, 2.0);
    let cases = [
        (DVec3::new(0.3, 0.2, 2.0), SurfaceFeature::Face(5), 1.0, DVec3::Z),
        (DVec3::new(0.3, 4.0, 5.0), SurfaceFeature::Edge(0), 5.0, DVec3::new(0.0, 0.6, 0.8)),
        (DVec3::new(3.0, 2.0, 3.0), SurfaceFeature::Vertex(7), 3.0, DVec3::new(2.0, 1.0, 2.0) / 3.0),
        (DVec3::new(0.2, 0.9, 0.1), SurfaceFeature::Face(3), -0.1, DVec3::Y),
    ];
    for (place, feature, distance, normal) in cases {
        let sphere = ball(0.25);
        let result = manifold(&sphere, &Pose::from_translation(place), &cube, &Pose::IDENTITY, 10.0);
        assert_eq!(result.contacts.len(), 1);
        let contact = result.contacts[0];
        let ContactFeature::Smooth { center_of: Side::A, center: 0, against } = contact.feature else {
            panic!("{contact:?}")
        };
        // The numbers of edges depend on the construction; only their kind is checked here.
        assert_eq!(std::mem::discriminant(&against), std::mem::discriminant(&feature), "{contact:?}");
        if !matches!(feature, SurfaceFeature::Edge(_)) {
            assert_eq!(against, feature);
        }
        assert!((contact.geometry.separation - (distance - 0.25)).abs() < 1e-15);
        assert!((contact.geometry.normal - normal).length() < 1e-15);
        assert!(contact.geometry.margin > 0.0);
        assert!((result.separation - contact.geometry.separation).abs() < 1e-15);
        assert_eq!(result.axis, SeparatingAxis::Nearest);
    }
}

/// Two spheres, and a sphere on a floor.
#[test]
fn spheres() {
    let result = manifold(&ball(1.0), &at(0.0, 3.0, 4.0), &ball(2.0), &Pose::IDENTITY, 10.0);
    let contact = result.contacts[0];
    assert_eq!((contact.feature, result.contacts.len()), (ContactFeature::SphereSphere, 1));
    assert!((contact.geometry.separation - 2.0).abs() < 1e-15);
    assert!((contact.geometry.point - DVec3::new(0.0, 1.8, 2.4)).length() < 1e-15);
    let floor = floor();
    let rest = manifold(&floor, &Pose::IDENTITY, &ball(0.5), &at(7.0, 8.0, 0.5), 1e-9);
    assert_eq!((rest.separation, rest.contacts[0].geometry.normal), (0.0, DVec3::NEG_Z));
    // Concentric: no normal, so no contact, and no panic.
    assert!(manifold(&ball(1.0), &Pose::IDENTITY, &ball(1.0), &Pose::IDENTITY, 1.0).contacts.is_empty());
}

/// Each point of a cloud is a contact of its own: inside a box by its nearest face, outside by its nearest feature.
#[test]
fn clouds() {
    let cloud = Shape::points(vec![
        DVec3::new(0.0, 0.0, 0.95),
        DVec3::new(0.5, 0.0, 1.05),
        DVec3::new(1.03, 0.0, 1.04),
        DVec3::new(5.0, 5.0, 5.0),
    ])
    .expect("points");
    let cube = cuboid(2.0, 2.0, 2.0);
    let result = manifold(&cloud, &Pose::IDENTITY, &cube, &Pose::IDENTITY, 0.1);
    let found: Vec<f64> = result.contacts.iter().map(|c| c.geometry.separation).collect();
    assert_eq!(found.len(), 3);
    assert!(found.iter().zip([-0.05, 0.05, 0.05]).all(|(f, e)| (f - e).abs() < 1e-15), "{found:?}");
    assert!((result.separation + 0.05).abs() < 1e-15);
    assert_eq!(separation(&cloud, &Pose::IDENTITY, &cloud, &Pose::IDENTITY), f64::INFINITY);
    let near = manifold(&ball(1.0), &Pose::IDENTITY, &cloud, &Pose::IDENTITY, 0.1);
    assert_eq!(near.contacts.len(), 1);
}

/// The distance of a sphere from a box is that of the box's nearest point, found by clamping.
#[test]
fn against_clamping() {
    let mut random = Random(8);
    let half = DVec3::new(0.7, 0.4, 0.9);
    let block = cuboid(1.4, 0.8, 1.8);
    for _ in 0..5000 {
        let place = random.vector() * 2.0;
        let clamped = place.clamp(-half, half);
        let turn = random.rotation();
        let found = separation(
            &ball(0.1),
            &Pose::new(random.rotation(), turn.rotate(place) + DVec3::ONE),
            &block,
            &Pose::new(turn, DVec3::ONE),
        );
        let outside = (place - clamped).length();
        let inside = (place.abs() - half).max_element();
        let expected = if outside > 0.0 { outside } else { inside } - 0.1;
        assert!((found - expected).abs() < 1e-14, "{found} {expected}");
    }
}

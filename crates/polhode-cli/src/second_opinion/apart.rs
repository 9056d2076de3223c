//! How far the bodies of two runs of one scene are apart.

use polhode::{Body, Geometry, Recorder, Scene};

/// How far a body of one run is from the same body of the other, at the sample at which that is most.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BodyApart {
    pub(super) name: String,
    /// Distance of the body's origins, m.
    pub(super) distance_m: f64,
    /// Angle between the attitudes, rad.
    pub(super) rotation_rad: f64,
    /// The larger of the distance as a part of the body's size, and of the angle (no unit).
    pub(super) of_size: f64,
    /// When, s.
    pub(super) t_s: f64,
}

/// The time up to which both runs have the same samples (s), and the bodies that forces move, the farthest first.
pub(super) fn compare(scene: &Scene, own: &Recorder, other: &Recorder) -> (Option<f64>, Vec<BodyApart>) {
    let same = own.times_s.iter().zip(&other.times_s).take_while(|(a, b)| a == b).count();
    let moved = scene.bodies().iter().enumerate().filter(|(_, body)| !body.is_fixed());
    let mut bodies: Vec<BodyApart> = moved
        .filter_map(|(number, body)| {
            let size = size(body);
            let at = |sample: usize| {
                let [a, b] = [own, other].map(|run| run.samples[sample].get(number).map(|body| body.pose));
                let (a, b) = a.zip(b)?;
                let distance_m = a.translation.distance(b.translation);
                let rotation_rad = a.rotation.angle_to(b.rotation);
                let of_size = larger(distance_m / size, rotation_rad);
                Some(BodyApart {
                    name: body.name().to_owned(),
                    distance_m,
                    rotation_rad,
                    of_size,
                    t_s: own.times_s[sample],
                })
            };
            let farther = |most: BodyApart, next: BodyApart| if is_beyond(&next, &most) { next } else { most };
            (0..same).filter_map(at).reduce(farther)
        })
        .collect();
    bodies.sort_by(|a, b| b.of_size.total_cmp(&a.of_size));
    (same.checked_sub(1).map(|last| own.times_s[last]), bodies)
}

/// Whether one is farther than the other; what is no number is the farthest.
fn is_beyond(one: &BodyApart, other: &BodyApart) -> bool {
    one.of_size > other.of_size || (one.of_size.is_nan() && !other.of_size.is_nan())
}

/// The larger of two; NaN when one is.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// Size of a body, m: that of its shape; of a point and of a body without a shape twice the largest radius of gyration.
fn size(body: &Body) -> f64 {
    let of_shape = match body.shape() {
        Some(Geometry::Shape(shape)) => shape.size(),
        Some(Geometry::Mesh(mesh)) => mesh.mesh().bounds().diagonal(),
        None => 0.0,
    };
    match body.mass_properties() {
        Some(properties) if of_shape == 0.0 => {
            2.0 * (properties.principal_axes().moments().z / properties.mass()).sqrt()
        }
        _ => of_shape,
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

    use super::*;
    use polhode::BodySample;
    use polhode::mesh::solid_box;
    use polhode::spatial::{DVec3, Mass, Pose, Rotation, Velocity};

    /// The largest difference of each body is told with its time, of its size; fixed bodies and later samples of one
    /// run alone do not count.
    #[test]
    fn largest_difference_of_each_body() {
        let cube = solid_box(DVec3::ONE, Mass::new(6.0).unwrap()).unwrap();
        let scene = Scene::builder("two")
            .body(Body::fixed("ground"))
            .body(Body::movable("near", cube))
            .body(Body::movable("far", cube))
            .build()
            .unwrap();
        let run = |far: [f64; 2], turned: f64, times_s: &[f64]| {
            let at = |x: f64, angle: f64| BodySample {
                pose: Pose::new(Rotation::from_rotation_vector(DVec3::Z * angle), DVec3::X * x),
                velocity: Velocity::ZERO,
            };
            let row = |far: f64| vec![at(0.0, 0.0), at(0.0, turned), at(far, 0.0)];
            Recorder { times_s: times_s.to_vec(), samples: far.map(row).to_vec(), ..Recorder::default() }
        };
        let (until, bodies) = compare(&scene, &run([0.0; 2], 0.0, &[0.0, 1.0]), &run([0.5, 0.25], 0.1, &[0.0, 1.0]));
        assert_eq!(until, Some(1.0));
        assert_eq!(bodies.iter().map(|body| body.name.as_str()).collect::<Vec<_>>(), ["far", "near"]);
        // The radius of gyration of a cube of 1 m is sqrt(1/6) m.
        assert!((bodies[0].of_size - 0.25 * 6.0_f64.sqrt()).abs() < 1e-12 && bodies[0].t_s == 0.0);
        assert!((bodies[1].rotation_rad - 0.1).abs() < 1e-12 && (bodies[1].of_size - 0.1).abs() < 1e-12);
        let (until, bodies) = compare(&scene, &run([0.0; 2], 0.0, &[0.0, 1.0]), &run([0.0, 9.0], 0.0, &[0.0, 0.5]));
        assert_eq!((until, bodies[0].of_size), (Some(0.0), 0.0));
    }
}

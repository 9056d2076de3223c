//! Normal and tangential terms of 149 contacts against rates computed to 40 digits by another program in another
//! language, by finite differences of contact points that it finds from the surfaces themselves
//! (fixtures/reference/contact_kinematics explains how): apart, overlapping, and touching to the rounding of the poses.

use crate::support::{cuboid, floor};
use polhode_contact::{
    ContactFeature, ContactKinematics, Shape, Side, SurfaceFeature, TangentialKinematics, evaluate,
    kinematics_with_tangential,
};
use polhode_spatial::{DVec3, Pose, Rotation, Velocity};

const CASES: &str = include_str!("../../../../fixtures/reference/contact_kinematics/contacts.csv");

/// A contact of the file and one of the crate are the same when point and normal agree within this, m.
const SAME_PLACE: f64 = 1e-9;

/// Largest error of the terms relative to the size of their summands: a hundred roundings, three times the error for a
/// side almost parallel to a cone's, whose contact point moves along it at 300 m/s.
const LARGEST_ERROR: f64 = 2e-14;

/// A body of the file in motion.
struct Moving {
    pose: Pose,
    velocity: Velocity,
    acceleration: DVec3,
    angular_acceleration: DVec3,
}

/// The reference values for a contact.
struct Outcome {
    normal: DVec3,
    point: DVec3,
    separation: f64,
    separation_rate: f64,
    separation_acceleration: f64,
    slip: DVec3,
    slip_rate: DVec3,
    point_velocity: DVec3,
    normal_rate: DVec3,
}

/// Numbers one after the other.
struct Numbers<'a>(std::str::Split<'a, char>);

impl Numbers<'_> {
    fn one(&mut self) -> f64 {
        self.0.next().expect("a number").parse().expect("a number")
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.one(), self.one(), self.one())
    }

    fn moving(&mut self) -> Moving {
        let wxyz = [self.one(), self.one(), self.one(), self.one()];
        let length = wxyz.iter().map(|x| x * x).sum::<f64>().sqrt();
        let rotation = Rotation::from_wxyz(wxyz.map(|x| x / length)).expect("a rotation");
        let pose = Pose::new(rotation, self.vector());
        let (linear, acceleration) = (self.vector(), self.vector());
        let (first, second) = (self.vector(), self.vector());
        let velocity = Velocity::new(linear, first + second);
        Moving { pose, velocity, acceleration, angular_acceleration: first.cross(second) }
    }

    fn outcome(&mut self) -> Outcome {
        Outcome {
            normal: self.vector(),
            point: self.vector(),
            separation: self.one(),
            separation_rate: self.one(),
            separation_acceleration: self.one(),
            slip: self.vector(),
            slip_rate: self.vector(),
            point_velocity: self.vector(),
            normal_rate: self.vector(),
        }
    }
}

/// The shape for a surface of the file, and the features that this surface may be.
fn surface(name: &str) -> (Shape, Vec<SurfaceFeature>) {
    use SurfaceFeature::{Cap, Edge, Face, Rim, RimEntry, RimExit, Side as Lateral, Sphere, Vertex};
    let (shape, kind) = name.split_once('-').unwrap_or((name, ""));
    let shape = match shape {
        "sphere" => Shape::sphere(0.2),
        "half" => Ok(floor()),
        "box" => Ok(cuboid(0.5, 0.4, 0.3)),
        "point" => Shape::points(vec![DVec3::new(0.3, 0.2, 0.1)]),
        "capsule" => Shape::capsule(0.1, 0.6),
        "cylinder" => Shape::cylinder(0.3, 0.5),
        "cone" => Shape::cone(0.3, 0.5),
        _ => Shape::torus(0.3, 0.1),
    };
    let features = match kind {
        "space" => vec![Face(0)],
        "face" => (0..6).map(Face).collect(),
        "edge" => (0..12).map(Edge).collect(),
        "vertex" => (0..8).map(Vertex).collect(),
        "apex" => vec![Vertex(0)],
        "side" => vec![Lateral(0)],
        "cap" => vec![Cap(0), Cap(1)],
        "rim" => [0, 1].into_iter().flat_map(|k| [Rim(k), RimExit(k), RimEntry(k)]).collect(),
        _ if name.starts_with("torus") => vec![Rim(0), RimExit(0), RimEntry(0)],
        _ if name == "point" => vec![Vertex(0)],
        _ => vec![Sphere],
    };
    (shape.expect("a shape"), features)
}

/// All names that a contact of two features may have.
fn names(a: SurfaceFeature, b: SurfaceFeature) -> Vec<ContactFeature> {
    use SurfaceFeature::{Cap, Edge, Face, Sphere, Vertex};
    let mut names = vec![ContactFeature::Elements { a, b }];
    match (a, b) {
        (Sphere, Sphere) => names.push(ContactFeature::SphereSphere),
        (Edge(edge_a), Edge(edge_b)) => names.push(ContactFeature::EdgeEdge { edge_a, edge_b }),
        (Vertex(vertex), Face(face)) => {
            names.push(ContactFeature::VertexFace { vertex_of: Side::A, vertex, face });
        }
        (Face(face), Vertex(vertex)) => {
            names.push(ContactFeature::VertexFace { vertex_of: Side::B, vertex, face });
        }
        _ => {}
    }
    let center = |part: SurfaceFeature| match part {
        Sphere => Some(0),
        Cap(k) | Vertex(k) => Some(k),
        _ => None,
    };
    let smooth = |center_of, center, against| ContactFeature::Smooth { center_of, center, against };
    names.extend(center(a).map(|k| smooth(Side::A, k, b)));
    names.extend(center(b).map(|k| smooth(Side::B, k, a)));
    names
}

/// Compares the crate's terms of a contact with the file.
fn check(
    name: &str,
    (a, b): (&Moving, &Moving),
    (normal_terms, terms): (ContactKinematics, TangentialKinematics),
    truth: &Outcome,
) -> f64 {
    let (p, n) = (normal_terms.geometry.point, normal_terms.geometry.normal);
    let given = |body: &Moving| body.acceleration + body.angular_acceleration.cross(p - body.pose.translation);
    let relative = given(a) - given(b);
    let TangentialKinematics { slip_velocity, acceleration_bias, point_velocity, normal_rate, .. } = terms;
    let slip_rate = relative - n * n.dot(relative) + acceleration_bias;
    let chi_rates = [normal_terms.separation_rate, n.dot(relative) + normal_terms.acceleration_bias];
    // Terms of the derivative are products of rates: of spins, of the point's velocity and of the normal's.
    let rate = 1.0 + truth.point_velocity.length() + truth.normal_rate.length();
    let errors = [
        ("normal", (n - truth.normal).length() / rate),
        ("point", (p - truth.point).length() / rate),
        ("separation", (normal_terms.geometry.separation - truth.separation).abs()),
        ("rate of the separation", (chi_rates[0] - truth.separation_rate).abs() / rate),
        ("acceleration of the separation", (chi_rates[1] - truth.separation_acceleration).abs() / (rate * rate)),
        ("slip", (slip_velocity - truth.slip).length() / rate),
        ("velocity of the point", (point_velocity - truth.point_velocity).length() / (rate * rate)),
        ("rate of the normal", (normal_rate - truth.normal_rate).length() / (rate * rate)),
        ("derivative of the slip", (slip_rate - truth.slip_rate).length() / (rate * rate)),
    ];
    for (what, error) in errors {
        assert!(error <= LARGEST_ERROR, "{name}: {what} off by {error:e} (rates {rate:.1})");
    }
    errors.iter().map(|(_, error)| *error).fold(0.0, f64::max)
}

/// Every pair of surfaces, by every name that its contact may have.
#[test]
fn every_pair_of_surfaces_to_rounding() {
    let (mut contacts, mut checked, mut worst) = (0, 0, 0.0_f64);
    for line in CASES.lines().filter(|line| !line.starts_with('#')) {
        let mut fields = line.split(',');
        let (name_a, name_b) = (fields.next().expect("a surface"), fields.next().expect("a surface"));
        let mut numbers = Numbers(fields);
        let (a, b, truth) = (numbers.moving(), numbers.moving(), numbers.outcome());
        let ((shape_a, parts_a), (shape_b, parts_b)) = (surface(name_a), surface(name_b));
        let name = format!("{name_a} on {name_b} at {:.2}", truth.separation);
        let mut found = 0;
        let pairs = parts_a.iter().flat_map(|&p| parts_b.iter().map(move |&q| (p, q)));
        for feature in pairs.flat_map(|(p, q)| names(p, q)) {
            let Some(geometry) = evaluate(feature, &shape_a, &a.pose, &shape_b, &b.pose) else { continue };
            if geometry.point.distance(truth.point) > SAME_PLACE || geometry.normal.distance(truth.normal) > SAME_PLACE
            {
                continue;
            }
            let terms =
                kinematics_with_tangential(feature, &shape_a, &a.pose, &a.velocity, &shape_b, &b.pose, &b.velocity);
            let terms = terms.expect("a contact that can be evaluated has rates");
            assert_eq!(terms.0.geometry, geometry);
            worst = worst.max(check(&name, (&a, &b), terms, &truth));
            found += 1;
        }
        assert!(found > 0, "{name}: the crate has no contact there");
        (contacts, checked) = (contacts + 1, checked + found);
    }
    assert!(contacts == 149 && checked >= contacts, "{contacts} {checked}");
    println!("{contacts} contacts, {checked} names, worst {worst:.1e}");
}

//! Ridges that bend, as on the inner side of a ring of straight pieces: a body in a bend touches both pieces, and two
//! bends that touch have four crossings. No edge or vertex of a single part has a valid normal there.

use crate::support::{Random, at, hull};
use polhode_contact::{Manifold, Shape, manifold};
use polhode_mesh::SolidMesh;
use polhode_mesh::primitives::{Refinement, Torus};
use polhode_spatial::{DVec3, Pose, Rotation};

/// Largest separation of a touch, m.
const REACH: f64 = 1e-11;

/// Radius of the ring's centre circle and of its tube, m.
const RING: [f64; 2] = [0.3, 0.05];

/// Slope of the two pieces of the innermost ridge at a bend: half of a sixteenth of a turn, rad.
const SLOPE: f64 = std::f64::consts::PI / 16.0;

fn ring_mesh() -> SolidMesh {
    let torus = Torus::new(RING[0], RING[1]).expect("a torus");
    torus.mesh(Refinement::COARSEST).expect("a mesh")
}

/// A ring about z, in parts and as a surface, with a bend of its innermost ridge at the bottom (-y).
fn rings() -> [(Shape, &'static str); 2] {
    let solid = ring_mesh();
    let surface = Shape::triangle_mesh(solid.mesh().vertices().to_vec(), solid.mesh().triangles().to_vec());
    [(Shape::solid(&solid).expect("parts"), "parts"), (surface.expect("a surface"), "surface")]
}

/// A bar along z with its sharp edge, through the origin, downwards.
fn bar() -> Shape {
    let outline = [[0.0, 0.0], [0.03, 0.1], [-0.03, 0.1]];
    let points = [-0.2, 0.2].map(|z| outline.map(|[x, y]| DVec3::new(x, y, z)));
    hull(points.as_flattened())
}

/// Asserts that the contacts have exactly these unit normals, from the lower to the upper body, in any order. `towards`
/// is 1 when the upper body is A and -1 when it is B.
fn assert_normals(found: &Manifold, towards: f64, normals: &[DVec3], what: &str) {
    let contacts = &found.contacts;
    assert_eq!(contacts.len(), normals.len(), "{what}: {contacts:#?}");
    for normal in normals {
        let alike = |c: &&polhode_contact::Contact| c.geometry.normal.distance(*normal * towards) < 1e-9;
        assert_eq!(contacts.iter().filter(alike).count(), 1, "{what}, {normal}: {contacts:#?}");
    }
    for contact in contacts {
        assert!(contact.geometry.margin > -REACH && contact.geometry.separation.abs() < REACH, "{what}: {contact:#?}");
    }
}

/// Asserts the same for both orders of a pair and for poses moved and rotated together.
fn assert_everywhere(lower: &Shape, upper: &Shape, pose: Pose, normals: &[DVec3], what: &str) {
    let mut random = Random(11);
    for turn in 0..10 {
        let whole = if turn == 0 { Pose::IDENTITY } else { random.pose(1.0) };
        let placed = whole * pose;
        let turned: Vec<_> = normals.iter().map(|normal| whole.rotation.rotate(*normal)).collect();
        let what = format!("{what}, turn {turn}");
        assert_normals(&manifold(lower, &whole, upper, &placed, REACH), -1.0, &turned, &what);
        assert_normals(&manifold(upper, &placed, lower, &whole, REACH), 1.0, &turned, &what);
    }
}

#[test]
fn a_bar_in_a_bend_touches_both_pieces_of_the_ridge() {
    let (sine, cosine) = libm::sincos(SLOPE);
    let normals = [DVec3::new(sine, cosine, 0.0), DVec3::new(-sine, cosine, 0.0)];
    for (ring, what) in &rings() {
        for height in [0.0, 1e-13, -1e-13] {
            let pose = at(0.0, RING[1] - RING[0] + height, 0.0);
            assert_everywhere(ring, &bar(), pose, &normals, &format!("{what}, {height} m above"));
        }
    }
}

#[test]
fn two_bends_that_touch_have_four_crossings() {
    let upper = Shape::solid(&ring_mesh()).expect("parts");
    // One ring hangs in the other: its uppermost inner bend rests on the lowest inner bend of the other.
    let turn = Rotation::from_rotation_vector(DVec3::Y * std::f64::consts::FRAC_PI_2);
    let pose = Pose::new(turn, DVec3::Y * (2.0 * (RING[1] - RING[0])));
    let (sine, cosine) = libm::sincos(SLOPE);
    let along = |sign: f64| DVec3::new(cosine, sign * sine, 0.0);
    let across = |sign: f64| DVec3::new(0.0, sign * sine, cosine);
    let signs = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
    // The hanging ring has its tube above the other's: it is the upper body.
    let normals = signs.map(|(x, z)| across(z).cross(along(x)).normalize());
    for (ring, what) in &rings() {
        assert_everywhere(ring, &upper, pose, &normals, what);
    }
}

#[test]
fn a_bar_beside_a_bend_touches_one_piece() {
    let (sine, cosine) = libm::sincos(SLOPE);
    for (ring, what) in &rings() {
        let aside = 0.01;
        let pose = at(aside * cosine, RING[1] - RING[0] + aside * sine, 0.0);
        assert_everywhere(ring, &bar(), pose, &[DVec3::new(-sine, cosine, 0.0)], what);
    }
}

//! Mass properties from what a body gives, against closed forms.

use crate::scene;
use polhode::Geometry;
use polhode::mesh::{Encoding, MeshFormat, format};
use polhode::spatial::{DMat3, DVec3, MassProperties};
use polhode_scene::load;

/// Mass properties of a body with these lines.
fn properties(lines: &str) -> MassProperties {
    *scene(&format!("format = 1\n[[bodies]]\nname = \"a\"\n{lines}\n")).bodies()[0].mass_properties().unwrap()
}

fn moments(properties: &MassProperties) -> DVec3 {
    let m = properties.inertia().matrix();
    DVec3::new(m.x_axis.x, m.y_axis.y, m.z_axis.z)
}

#[track_caller]
fn close(a: DVec3, b: DVec3) {
    assert!((a - b).abs().max_element() <= 1e-14 * b.abs().max_element(), "{a} {b}");
}

/// A box of 1 x 2 x 3 m: `m (b^2 + c^2) / 12` and its like (case MP-01), from mass and from density.
#[test]
fn boxes() {
    let expected = DVec3::new(6.5, 5.0, 2.5);
    close(moments(&properties("shape.box.size = [1, 2, 3]\nmass = 6")), expected);
    let dense = properties("shape.box.size = [1, 2, 3]\ndensity = 2");
    assert_eq!(dense.mass(), 12.0);
    close(moments(&dense), 2.0 * expected);
    // Hollow: three pairs of plates; of a unit cube of mass 6, `m a^2 5 / 18` about every axis.
    close(moments(&properties("shape.box.size = [1, 1, 1]\nmass = 6\nhollow = true")), DVec3::splat(5.0 / 3.0));
    assert_eq!(properties("shape.box.size = [1, 1, 1]\ndensity = 2\nhollow = true").mass(), 12.0);
}

/// A ball: `2/5 m r^2`, hollow `2/3 m r^2`.
#[test]
fn balls() {
    close(moments(&properties("shape.sphere.radius = 2\nmass = 5")), DVec3::splat(8.0));
    close(moments(&properties("shape.sphere.radius = 2\nmass = 3\nhollow = true")), DVec3::splat(8.0));
}

/// A loaded die: its centre of mass is where the file says, its inertia is about that point and is not moved.
#[test]
fn loaded_die() {
    let die =
        properties("shape.box.size = [1, 1, 1]\nmass = 6\ncenter_of_mass = [0.1, 0, -0.2]\ninertia = [1, 2, 2.5]");
    assert_eq!((die.mass(), die.center_of_mass()), (6.0, DVec3::new(0.1, 0.0, -0.2)));
    close(moments(&die), DVec3::new(1.0, 2.0, 2.5));
}

/// Bodies of revolution about z: a cylinder `m r^2/2` and `m (3 r^2 + h^2)/12`, a cone `3/10 m r^2` and
/// `3/80 m (4 r^2 + h^2)`, a capsule of mass 1 and a torus `m (R^2 + 3/4 a^2)`; the origin is the centre of mass.
#[test]
fn bodies_of_revolution() {
    let cylinder = properties("shape.cylinder = { radius = 2, height = 6 }\nmass = 12");
    close(moments(&cylinder), DVec3::new(48.0, 48.0, 24.0));
    let cone = properties("shape.cone = { radius = 2, height = 4 }\nmass = 10");
    close(moments(&cone), DVec3::new(12.0, 12.0, 12.0));
    let torus = properties("shape.torus = { major = 2, minor = 1 }\nmass = 4");
    close(moments(&torus), DVec3::new(10.5, 10.5, 19.0));
    let capsule = properties("shape.capsule = { radius = 1, height = 3 }\ndensity = 3");
    assert!((capsule.mass() - 13.0 * std::f64::consts::PI).abs() < 1e-13);
    for properties in [cylinder, cone, torus, capsule] {
        assert!(properties.center_of_mass().length() < 1e-15);
    }
}

/// A compound of two halves is the whole, wherever the halves are turned to and whether mass or density is given; its
/// centre of mass is where its parts put it, and points add nothing.
#[test]
fn compounds() {
    let halves = "shape.compound.parts = [\
        { shape.box.size = [1, 2, 1.5], position = [0, 0, 0.75] },\
        { shape.box.size = [2, 1, 1.5], position = [0, 0, 2.25], rotation_vector = [0, 0, 1.5707963267948966] },\
        { shape.points.positions = [[0, 0, 0]] }]\n";
    for amount in ["mass = 6", "density = 1"] {
        let whole = properties(&format!("{halves}{amount}"));
        assert!((whole.mass() - 6.0).abs() < 1e-14);
        close(whole.center_of_mass(), DVec3::Z * 1.5);
        close(moments(&whole), DVec3::new(6.5, 5.0, 2.5));
    }
}

/// A given inertia replaces that of the shape; as a matrix it may have products.
#[test]
fn given_inertia() {
    let diagonal = properties("shape.box.size = [1, 2, 3]\ndensity = 2\ninertia = [3, 4, 5]");
    assert_eq!((diagonal.mass(), moments(&diagonal)), (12.0, DVec3::new(3.0, 4.0, 5.0)));
    let matrix = properties("mass = 2\ninertia = [[3, 0.5, 0], [0.5, 4, 0], [0, 0, 5]]");
    let expected = DMat3::from_cols_array(&[3.0, 0.5, 0.0, 0.5, 4.0, 0.0, 0.0, 0.0, 5.0]);
    assert_eq!(matrix.inertia().matrix(), expected);
    let points = properties("shape.points.positions = [[1, 0, 0], [2, 0, 0]]\nmass = 2\ninertia = [1, 1, 1]");
    assert_eq!(points.center_of_mass(), DVec3::ZERO);
}

/// The exact inertia of a ball put in for that of its mesh, as the thesis advises for curved bodies (3.2): the mesh of
/// an icosahedron falls short by a third, and mass, centre and shape stay those that are asked for.
#[test]
fn given_inertia_of_a_mesh() {
    let folder = tempfile::tempdir().unwrap();
    let ball = polhode::mesh::Sphere::new(2.0).unwrap().mesh(polhode::mesh::Refinement::new(0).unwrap()).unwrap();
    let bytes = format::write(ball.mesh(), MeshFormat::Obj, Encoding::Text).unwrap();
    std::fs::write(folder.path().join("ball.obj"), bytes).unwrap();
    let load = |lines: &str| {
        let path = folder.path().join("scene.toml");
        let text = format!("format = 1\n[[bodies]]\nname = \"a\"\nshape.convex.file = \"ball.obj\"\n{lines}\n");
        std::fs::write(&path, text).unwrap();
        *load(&path).unwrap_or_else(|error| panic!("{error}")).bodies()[0].mass_properties().unwrap()
    };
    let coarse = moments(&load("mass = 5")) / 8.0;
    assert!(
        (coarse - DVec3::splat(coarse.x)).abs().max_element() < 1e-14 && (0.6..0.75).contains(&coarse.x),
        "{coarse}"
    );
    let exact = load("mass = 5\ninertia = [8, 8, 8]");
    assert_eq!((exact.mass(), moments(&exact)), (5.0, DVec3::splat(8.0)));
    assert!(exact.center_of_mass().length() < 1e-15);
}

/// The L-shape (case MP-04) from its file, found beside the scene: exact mass and centre of mass; not convex, so it
/// is kept as a mesh until it is known whether it may meet anything.
#[test]
fn meshes() {
    let folder = tempfile::tempdir().unwrap();
    let meshes = folder.path().join("meshes");
    std::fs::create_dir(&meshes).unwrap();
    std::fs::write(meshes.join("l.obj"), include_str!("../../../../fixtures/meshes/l-shape.obj")).unwrap();
    let tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    std::fs::write(meshes.join("t.obj"), tetrahedron).unwrap();
    let load = |shape: &str| {
        let path = folder.path().join("scene.toml");
        let text = format!("format = 1\n[[bodies]]\nname = \"a\"\n{shape}\ndensity = 1\n");
        std::fs::write(&path, text).unwrap();
        load(&path).unwrap_or_else(|error| panic!("{error}")).bodies()[0].clone()
    };
    let l = load("shape.mesh.file = \"meshes/l.obj\"");
    let properties = l.mass_properties().unwrap();
    assert!((properties.mass() - 4.0).abs() < 1e-14);
    close(properties.center_of_mass(), DVec3::new(0.75, 1.25, 0.5));
    close(moments(properties), DVec3::new(41.0 / 12.0, 17.0 / 12.0, 25.0 / 6.0));
    assert!(matches!(l.shape(), Some(Geometry::Mesh(_))));
    for shape in ["mesh", "convex"] {
        let body = load(&format!("shape.{shape}.file = \"meshes/t.obj\""));
        assert!((body.mass_properties().unwrap().mass() - 1.0 / 6.0).abs() < 1e-15);
        assert!(matches!(body.shape(), Some(Geometry::Shape(_))), "{shape}");
    }
    // Twice as large in every direction.
    let scaled = load("shape.mesh = { file = \"meshes/l.obj\", scale = 2 }");
    assert!((scaled.mass_properties().unwrap().mass() - 32.0).abs() < 1e-13);
    // The same in every format, by the ending of its name or by its content.
    let mesh = format::read_any(tetrahedron.as_bytes()).unwrap();
    for (name, format, encoding) in [
        ("t.STL", MeshFormat::Stl, Encoding::Binary),
        ("t.off", MeshFormat::Off, Encoding::Text),
        ("t.ply", MeshFormat::Ply, Encoding::Binary),
        ("t", MeshFormat::Stl, Encoding::Text),
        ("t.mesh", MeshFormat::Ply, Encoding::Text),
    ] {
        std::fs::write(meshes.join(name), format::write(&mesh, format, encoding).unwrap()).unwrap();
        let body = load(&format!("shape.mesh.file = \"meshes/{name}\""));
        assert_eq!(body.mass_properties(), load("shape.mesh.file = \"meshes/t.obj\"").mass_properties(), "{name}");
    }
    // Hollow: the area of the tetrahedron, 3/2 + sqrt(3)/2.
    let hollow = load("hollow = true\nshape.convex.file = \"meshes/t.obj\"");
    let area = 1.5 + 0.5 * 3.0_f64.sqrt();
    assert!((hollow.mass_properties().unwrap().mass() - area).abs() < 1e-14);
}

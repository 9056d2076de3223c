//! Pictures: silhouettes, what hides what, light and shadow, and the same bytes every time.

use polhode::contact::Shape;
use polhode::mesh::{solid_box, solid_sphere};
use polhode::scene::{Appearance, BodyLook, Force};
use polhode::spatial::{DVec3, Mass, Pose, UnitVector, Velocity};
use polhode::{Body, BodyId, BodySample, Scene, Simulation};
use polhode_view::Recording;
use polhode_view::camera::{Camera, PRESETS, Standpoint, Viewpoint};
use polhode_view::extent::{Extent, box_corners};
use polhode_view::overlay::Overlay;
use polhode_view::raster::{Marks, Picture, PictureSize};
use polhode_view::still::{frame_from, still, still_with, write_png};
use std::f64::consts::PI;

const RADIUS: f64 = 0.5;

fn ball(name: &str, place: DVec3) -> Body {
    Body::movable(name, solid_sphere(RADIUS, Mass::new(1.0).unwrap()).unwrap())
        .geometry(Shape::sphere(RADIUS).unwrap().into())
        .pose(Pose::from_translation(place))
}

/// A scene at its start.
fn recording(bodies: Vec<Body>) -> Recording {
    let still = Velocity { linear: DVec3::ZERO, angular: DVec3::ZERO };
    let samples: Vec<BodySample> =
        bodies.iter().map(|body| BodySample { pose: *body.initial_pose(), velocity: still }).collect();
    let scene = bodies.into_iter().fold(Scene::builder("still"), polhode::SceneBuilder::body).build().unwrap();
    Recording::of_instant(&scene, 0.0, &samples).unwrap()
}

const BOUNDS: [DVec3; 2] = [DVec3::splat(-1.0), DVec3::ONE];

/// What a camera holds that holds the box.
fn of_box() -> Extent {
    Extent::of(box_corners(BOUNDS))
}

fn size() -> PictureSize {
    PictureSize::new(480, 360).unwrap()
}

fn pixel(picture: &Picture, x: u32, y: u32) -> [u8; 3] {
    let at = 3 * (y * picture.size.width() + x) as usize;
    picture.rgb[at..at + 3].try_into().unwrap()
}

fn brightness(rgb: [u8; 3]) -> u32 {
    rgb.iter().map(|&channel| u32::from(channel)).sum()
}

/// Whether red, green or blue is the strongest.
fn strongest(rgb: [u8; 3]) -> usize {
    (0..3).max_by_key(|&i| rgb[i]).unwrap()
}

/// The outline of a ball is a circle of radius `f r / sqrt(d^2 - r^2)`.
#[test]
fn silhouette_of_a_ball() {
    let from = DVec3::new(0.3, -1.0, 0.4);
    let camera = Camera::at_box(BOUNDS, from, size().aspect());
    let with = frame_from(&recording(vec![ball("ball", DVec3::ZERO)]), 0, camera, BOUNDS, size());
    let without = frame_from(&recording(vec![Body::fixed("nothing")]), 0, camera, BOUNDS, size());
    let differs = |x: u32, y: u32| pixel(&with, x, y) != pixel(&without, x, y);
    let (width, height) = (size().width(), size().height());
    let all = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let area = all.filter(|&(x, y)| differs(x, y)).count() as f64;
    let focal = 0.5 * f64::from(height) / (0.5 * camera.field_of_view_rad).tan();
    let distance = camera.eye.length();
    let radius = focal * RADIUS / (distance * distance - RADIUS * RADIUS).sqrt();
    let expected = PI * radius * radius;
    // Pixels that are covered in part count whole: half a pixel along the outline.
    assert!(radius > 50.0 && (area - expected - PI * radius).abs() < 0.01 * expected, "{area} {expected}");
    // The camera looks at the middle of what it holds as it is seen, which is not the middle of the box.
    let seen = camera.seen(DVec3::ZERO);
    let middle = [240.0 + focal * seen.x / seen.z, 180.0 - focal * seen.y / seen.z];
    for (x, y) in [(radius - 2.0, 0.0), (0.0, radius - 2.0), (1.0 - radius, 0.0), (0.0, 1.0 - radius)] {
        let at = |beyond: f64| {
            let out = beyond / radius;
            ((middle[0] + x * (1.0 + out)) as u32, (middle[1] + y * (1.0 + out)) as u32)
        };
        let (inside, outside) = (at(0.0), at(5.0));
        assert!(differs(inside.0, inside.1) && !differs(outside.0, outside.1), "{x} {y}");
    }
}

/// Seen from the front, the ball in front hides the one behind it, whichever is drawn first.
#[test]
fn what_is_nearer_hides_what_is_farther() {
    let camera = Camera::at_box(BOUNDS, -DVec3::Y, size().aspect());
    let (near, far) = (DVec3::new(0.0, -0.6, 0.0), DVec3::new(0.0, 0.6, 0.0));
    let picture = |places: [DVec3; 2]| {
        let bodies = vec![ball("blue", places[0]), ball("orange", places[1])];
        frame_from(&recording(bodies), 0, camera, BOUNDS, size())
    };
    // Away from the lines on the balls.
    assert_eq!(strongest(pixel(&picture([near, far]), 255, 165)), 2);
    assert_eq!(strongest(pixel(&picture([far, near]), 255, 165)), 0);
}

/// The lamp stands above: the top is brighter than the bottom, and the ball throws a shadow on the ground.
#[test]
fn light_and_shadow() {
    let ground = || {
        let plane = Shape::half_space(UnitVector::Z);
        Body::fixed("ground").geometry(plane.into()).pose(Pose::from_translation(-DVec3::Z * RADIUS))
    };
    let camera = Camera::at_box(BOUNDS, DVec3::new(0.0, -1.0, 0.6), size().aspect());
    let with = frame_from(&recording(vec![ground(), ball("ball", DVec3::ZERO)]), 0, camera, BOUNDS, size());
    let without = frame_from(&recording(vec![ground()]), 0, camera, BOUNDS, size());
    assert!(brightness(pixel(&with, 230, 150)) > brightness(pixel(&with, 230, 215)) + 60);
    // The shadow falls away from the lamp, which is to the left and in front.
    let seen = |place: DVec3| {
        let seen = camera.seen(place);
        let focal = 180.0 / (0.5 * camera.field_of_view_rad).tan();
        ((240.0 + focal * seen.x / seen.z) as u32, (180.0 - focal * seen.y / seen.z) as u32)
    };
    let shadow = seen(DVec3::new(0.35, 0.45, -RADIUS));
    let (dark, bright) = (pixel(&with, shadow.0, shadow.1), pixel(&without, shadow.0, shadow.1));
    assert!(2 * brightness(dark) < 3 * brightness(bright) && brightness(dark) + 80 < brightness(bright), "{dark:?}");
    let lit = seen(DVec3::new(-0.9, -0.6, -RADIUS));
    assert_eq!(pixel(&with, lit.0, lit.1), pixel(&without, lit.0, lit.1));
}

/// A camera inside of what it looks at draws what is ahead of it.
#[test]
fn what_is_behind_the_camera_is_cut_off() {
    let size_m = DVec3::splat(4.0);
    let room = Body::movable("room", solid_box(size_m, Mass::new(1.0).unwrap()).unwrap())
        .geometry(Shape::cuboid(size_m).unwrap().into());
    let camera = Camera { eye: DVec3::ZERO, ..Camera::for_box(BOUNDS, size().aspect()) };
    let picture = frame_from(&recording(vec![room]), 0, camera, BOUNDS, size());
    assert!(picture.rgb.chunks_exact(3).all(|rgb| strongest(rgb.try_into().unwrap()) == 2));
}

#[test]
fn the_same_bytes_every_time() {
    let png = || {
        let picture = still(&recording(vec![ball("a", DVec3::ZERO), ball("b", DVec3::X)]), 0, size()).unwrap();
        let mut bytes = Vec::new();
        write_png(&picture, &mut bytes).unwrap();
        bytes
    };
    let first = png();
    assert_eq!(first, png());
    assert_eq!(first[..8], *b"\x89PNG\r\n\x1a\n");
}

#[test]
fn sizes() {
    assert!(PictureSize::new(0, 5).is_err() && PictureSize::new(5, 8193).is_err());
    // One pixel, and a body of no size far away.
    let dot = recording(vec![ball("ball", DVec3::new(1e9, -1e9, 1e9))]);
    assert_eq!(still(&dot, 0, PictureSize::new(1, 1).unwrap()).unwrap().rgb.len(), 3);
}

/// Where a place is in a picture of that size.
fn at(camera: &Camera, place: DVec3) -> [u32; 2] {
    let (width, height) = (f64::from(size().width()), f64::from(size().height()));
    let (seen, focal) = (camera.seen(place), camera.focal_length_px(height));
    [0.5 * width + focal * seen.x / seen.z, 0.5 * height - focal * seen.y / seen.z].map(|pixel| pixel as u32)
}

/// A camera at a place looks at a place: that is in the middle, and what lies to its right is on the right.
#[test]
fn a_camera_that_is_put_somewhere() {
    let (eye, target) = (DVec3::new(3.0, -4.0, 2.0), DVec3::new(0.5, 0.5, 0.25));
    let viewpoint = Viewpoint { standpoint: Some(Standpoint::Eye(eye)), target: Some(target) };
    let camera = viewpoint.camera(&of_box(), size().aspect()).unwrap();
    assert_eq!(at(&camera, target), [240, 180]);
    let right = (target - eye).cross(DVec3::Z).normalize();
    assert!(at(&camera, target + 0.1 * right)[0] > 245 && at(&camera, target + 0.1 * DVec3::Z)[1] < 175);
    // Without a target it looks at the middle of the box; from a direction it sees all of the box.
    let viewpoint = Viewpoint { target: None, ..viewpoint };
    assert_eq!(at(&viewpoint.camera(&of_box(), size().aspect()).unwrap(), DVec3::ZERO), [240, 180]);
    for (name, from) in PRESETS {
        let viewpoint = Viewpoint { standpoint: Some(Standpoint::Direction(from)), target: None };
        let camera = viewpoint.camera(&of_box(), size().aspect()).unwrap();
        for corner in 0..8 {
            let corner = DVec3::from_array([0, 1, 2].map(|axis| BOUNDS[corner >> axis & 1][axis]));
            let [x, y] = at(&camera, corner);
            assert!((1..480).contains(&x) && (1..360).contains(&y), "{name}: {corner} at {x} {y}");
        }
    }
    // The viewpoint that is taken when none is asked for is that of every other still, to the last bit.
    assert_eq!(Viewpoint::default().camera(&of_box(), 1.5).unwrap(), Camera::for_box(BOUNDS, 1.5));
    for (eye, target) in [(target, target), (DVec3::NAN, target), (DVec3::INFINITY, target)] {
        let viewpoint = Viewpoint { standpoint: Some(Standpoint::Eye(eye)), target: Some(target) };
        assert!(viewpoint.camera(&of_box(), 1.0).is_err());
    }
}

/// A ball of 2 m on an orbit of 7000 km: a mark stands where it is, its path behind it, the centre of attraction in the
/// picture; none of it in a picture in which it is large.
#[test]
fn a_body_that_is_lost_on_its_path() {
    let mu = 3.986e14;
    let (radius, speed) = (7.0e6, (3.986e14_f64 / 7.0e6).sqrt());
    let satellite =
        ball("satellite", DVec3::X * radius).velocity(Velocity { linear: DVec3::Y * speed, angular: DVec3::ZERO });
    let scene = Scene::builder("orbit")
        .gravity(DVec3::ZERO)
        .body(satellite)
        .force(Force::PointGravity { center: DVec3::ZERO, mu })
        .duration_s(3000.0)
        .output_interval_s(10.0)
        .build()
        .unwrap();
    let mut recording = Recording::for_still(&scene).unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to_observed(2000.0, &mut recording).unwrap();
    recording.end_at(2000.0, &simulation.bodies()).unwrap();
    assert_eq!(recording.times().last(), Some(&2000.0));
    let last = recording.times().len() - 1;
    let camera = recording.framing_at(last).camera(&Viewpoint::default(), size().aspect()).unwrap();
    let picture = still(&recording, last, size()).unwrap();
    let place = recording.moving_poses(last)[0].translation;
    let seen = |place: DVec3| {
        let [x, y] = at(&camera, place);
        pixel(&picture, x, y)
    };
    // Blue is the satellite, dark its path, and grey the centre.
    let sky = pixel(&picture, 2, 2);
    assert!(strongest(seen(place)) == 2 && brightness(seen(place)) + 100 < brightness(sky));
    assert!(brightness(seen(recording.moving_poses(last / 2)[0].translation)) + 100 < brightness(sky));
    let [r, g, b] = seen(DVec3::ZERO);
    assert!(r == g && g == b && brightness([r, g, b]) + 50 < brightness(sky), "{r} {g} {b}");
    // At the start it fills the picture, and nothing is marked.
    let near = recording.framing_at(0).bounds();
    assert!((near[1] - near[0]).length() < 4.0 * RADIUS);
    let camera = Camera::for_box(near, size().aspect());
    assert_eq!(Marks::of_frame(&recording, 0, &camera, size().height()), Marks::default());
}

/// Two points 10 m apart are seen, although the balls about them are smaller than a pixel; of thousands of bodies none
/// is marked.
#[test]
fn points_and_crowds() {
    let cloud = |name: &str| {
        let points = vec![DVec3::ZERO, DVec3::X * 1e-3, DVec3::Y * 1e-3, DVec3::Z * 1e-3];
        Body::movable(name, solid_sphere(0.1, Mass::new(1.0).unwrap()).unwrap())
            .geometry(Shape::points(points).unwrap().into())
    };
    let two = recording(vec![cloud("a"), cloud("b").pose(Pose::from_translation(DVec3::X * 10.0))]);
    let camera = Camera::for_box(two.framing_at(0).bounds(), size().aspect());
    let marks = Marks::of_frame(&two, 0, &camera, size().height());
    assert_eq!((marks.discs.len(), marks.paths.len()), (2, 2));
    // Close to the first, with the second behind the camera: each point has a mark of its own.
    let close = Camera::at_box([DVec3::splat(-4e-3), DVec3::splat(4e-3)], DVec3::new(1.0, -1.0, 1.0), size().aspect());
    let marks = Marks::of_frame(&two, 0, &close, size().height());
    assert_eq!((marks.discs.len(), marks.paths.len()), (4, 0));
    let many = (0..100).map(|i| ball(&format!("ball {i}"), DVec3::X * 1000.0 * f64::from(i))).collect();
    let many = recording(many);
    let camera = Camera::for_box(many.framing_at(0).bounds(), size().aspect());
    assert_eq!(Marks::of_frame(&many, 0, &camera, size().height()), Marks::default());
}

/// Where all points that a camera is to hold are on a picture of width 3 and height 2: left, right, down and up, from
/// -1 to 1.
fn rims(camera: &Camera, points: impl Iterator<Item = DVec3>) -> [f64; 4] {
    let slope = (0.5 * camera.field_of_view_rad).tan();
    let mut rims = [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY];
    for point in points {
        let seen = camera.seen(point);
        let (x, y) = (seen.x / (1.5 * slope * seen.z), seen.y / (slope * seen.z));
        rims = [rims[0].min(x), rims[1].max(x), rims[2].min(y), rims[3].max(y)];
    }
    rims
}

/// A camera stands as near as it can: what it is to hold reaches the same distance from the rims on both sides, and in
/// one of the two ways as far as the margin.
#[test]
fn a_camera_stands_as_near_as_it_can() {
    for (low, high) in [([-1.0; 3], [1.0; 3]), ([0.0, 5.0, -3.0], [9.0, 6.0, -2.5]), ([0.0; 3], [0.1, 0.1, 8.0])] {
        let corners = [DVec3::from_array(low), DVec3::from_array(high)];
        let extent = Extent::of(box_corners(corners));
        for from in [DVec3::new(0.55, -1.0, 0.42), -DVec3::Y, DVec3::new(0.0, -0.001, 1.0)] {
            let camera = Camera::holding(&extent, from, None, 1.5);
            let [left, right, down, up] = rims(&camera, box_corners(corners));
            assert!((left + right).abs() < 1e-9 || (down + up).abs() < 1e-9, "{left} {right} {down} {up}");
            let reach = right.max(-left).max(up).max(-down);
            assert!((reach - 1.0 / 1.2).abs() < 1e-9, "{reach}");
        }
    }
}

/// A body whose origin lies far from its shape fills the picture as one whose origin is in its middle.
#[test]
fn a_shape_far_from_its_origin_fills_the_picture() {
    let place = DVec3::new(40.0, 30.0, 20.0);
    let corners: Vec<DVec3> = box_corners([place, place + DVec3::ONE]).collect();
    let far = polhode::contact::ConvexPolyhedron::from_points(&corners).unwrap();
    let body = Body::movable("far", solid_box(DVec3::ONE, Mass::new(1.0).unwrap()).unwrap())
        .geometry(Shape::convex(far).into());
    let picture = still(&recording(vec![body]), 0, size()).unwrap();
    let sky = pixel(&picture, 2, 2);
    let covered = picture.rgb.chunks_exact(3).filter(|rgb| rgb != &sky).count();
    assert!(4 * covered > picture.rgb.len() / 3, "{covered}");
}

/// Pegs and a bin are held beside a small body that moves, a floor of boards is not.
#[test]
fn what_stands_is_held_too() {
    let small = |name: &str, place: DVec3| {
        Body::fixed(name).geometry(Shape::sphere(0.1).unwrap().into()).pose(Pose::from_translation(place))
    };
    let slab = |name: &str, size: DVec3| {
        Body::fixed(name).geometry(Shape::cuboid(size).unwrap().into()).pose(Pose::from_translation(-5.0 * DVec3::Z))
    };
    let mover = Body::movable("mover", solid_sphere(0.1, Mass::new(1.0).unwrap()).unwrap())
        .geometry(Shape::sphere(0.1).unwrap().into());
    let bodies = vec![
        mover,
        small("peg", DVec3::X),
        small("other peg", -DVec3::X),
        slab("bin", DVec3::new(4.0, 1.0, 0.1)),
        slab("floor", DVec3::new(400.0, 400.0, 0.1)),
    ];
    let [low, high] = recording(bodies).framing_at(0).bounds();
    assert!((low - DVec3::new(-2.0, -0.5, -5.05)).length() < 1e-9, "{low}");
    assert!((high.x - 2.0).abs() < 1e-9 && (high.z - 0.1).abs() < 1e-9, "{high}");
}

/// Bricks in a vertical plane are seen from the front, bricks that are turned out of it are not.
#[test]
fn what_moves_in_a_plane_is_seen_square_on() {
    let brick = |name: &str, x: f64, y: f64| {
        let size = DVec3::new(1.0, 0.5, 0.25);
        Body::movable(name, solid_box(size, Mass::new(1.0).unwrap()).unwrap())
            .geometry(Shape::cuboid(size).unwrap().into())
            .pose(Pose::from_translation(DVec3::new(x, y, 1.0)))
    };
    let from = |bodies: Vec<Body>| recording(bodies).shown().usual_from;
    let front = PRESETS[0].1;
    assert_eq!(from(vec![brick("a", 0.0, 0.0), brick("b", 2.0, 0.0)]), front);
    assert_eq!(from(vec![brick("a", 0.0, 0.0), brick("b", 0.0, 2.0)]), PRESETS[1].1);
    // One brick falls in two planes at once, three do not lie in one.
    let usual = from(vec![brick("a", 0.0, 0.0)]);
    assert_ne!(usual, front);
    assert_eq!(from(vec![brick("a", 0.0, 0.0), brick("b", 2.0, 0.0), brick("c", 0.0, 2.0)]), usual);
    let spun = brick("b", 2.0, 0.0).velocity(Velocity { linear: DVec3::ZERO, angular: DVec3::Z });
    assert_eq!(from(vec![brick("a", 0.0, 0.0), spun]), usual);
}

/// A scene says from where it is seen, what the picture holds, and how bodies look: what is hidden is not drawn, and
/// what is seen through lets its background through.
#[test]
fn a_scene_says_how_it_looks() {
    let recorded = || recording(vec![ball("ball", DVec3::ZERO)]);
    let look = |color: Option<[u8; 3]>, opacity: f64| {
        let mut appearance = Appearance { standpoint: Some(Standpoint::Direction(-DVec3::Y)), ..Appearance::default() };
        appearance.bodies.insert(BodyId::new(0), BodyLook { color, label: None, opacity });
        still(&recorded().shown_as(&appearance), 0, size()).unwrap()
    };
    // Beside the lines on the ball.
    let middle = |picture: &Picture| pixel(picture, 260, 140);
    let [red, hidden, glass] =
        [look(Some([200, 0, 0]), 1.0), look(None, 0.0), look(Some([200, 0, 0]), 0.5)].map(|p| middle(&p));
    assert_eq!(strongest(red), 0);
    assert_eq!(hidden, pixel(&look(None, 0.0), 2, 2));
    assert!(
        brightness(red) < brightness(glass) && brightness(glass) < brightness(hidden),
        "{red:?} {glass:?} {hidden:?}"
    );
    let frame = [DVec3::splat(-10.0), DVec3::splat(10.0)];
    let framed = recorded().shown_as(&Appearance { frame: Some(frame), ..Appearance::default() });
    assert_eq!(framed.framing_at(0).bounds(), frame);
}

/// An arrow of a velocity stands over the ball, and a legend says what it means.
#[test]
fn overlays_are_drawn() {
    let scene = Scene::builder("flight")
        .body(ball("ball", DVec3::ZERO).velocity(Velocity { linear: DVec3::X, angular: DVec3::ZERO }))
        .build()
        .unwrap();
    let samples: Vec<BodySample> = scene
        .bodies()
        .iter()
        .map(|body| BodySample { pose: *body.initial_pose(), velocity: *body.initial_velocity() })
        .collect();
    let recording = Recording::of_instant(&scene, 0.0, &samples).unwrap();
    let picture = |overlays: &[Overlay]| still_with(&recording, 0, &Viewpoint::default(), size(), overlays).unwrap();
    let (with, without) = (picture(&[Overlay::Velocities]), picture(&[]));
    let differ = |x: std::ops::Range<u32>, y: std::ops::Range<u32>| {
        x.flat_map(|x| y.clone().map(move |y| (x, y)))
            .filter(|&(x, y)| pixel(&with, x, y) != pixel(&without, x, y))
            .count()
    };
    assert!(differ(240..330, 150..210) > 50 && differ(0..200, 0..40) > 500);
    assert_eq!(picture(&[]), without);
    assert!(Overlay::ALL.iter().all(|(name, overlay)| Overlay::named(name) == Some(*overlay)));
}

/// The camera of pages stands in the same place (viewer/test/framing.test.mjs).
#[test]
fn a_camera_stands_where_that_of_a_page_does() {
    let eye = Camera::for_box(BOUNDS, 1.5).eye;
    let page = DVec3::new(2.383938639594104, -4.631333833463414, 1.660965278914695);
    assert!(eye.distance(page) < 1e-9, "{eye}");
}

//! Forces: what is accepted, what absent keys mean, and what is refused.

use crate::{BASE, check, refused, scene};
use polhode::BodyId;
use polhode::dynamics::field::point_gravity::GRAVITATION;
use polhode::scene::{Attachment, DragLaw, Force, Frame, Signal};
use polhode::spatial::DVec3;
use polhode_scene::Refusal;
use std::fmt::Write as _;

/// `BASE` and one force.
fn with(force: &str) -> String {
    format!("{BASE}\n[[forces]]\n{force}\n")
}

/// The forces that an entry makes.
fn forces(force: &str) -> Vec<Force> {
    scene(&with(force)).forces().to_vec()
}

/// The one force that an entry makes.
fn force(text: &str) -> Force {
    let forces = forces(text);
    assert_eq!(forces.len(), 1);
    forces[0].clone()
}

/// The signal of a torque.
fn signal(text: &str) -> Signal {
    match force(&format!("type.torque = {{ body = \"brick\", torque = [0, 0, 1], signal = {text} }}")) {
        Force::Applied { signal, .. } => signal,
        other => panic!("{other:?}"),
    }
}

/// A scene without the key has no forces; neither has one with an empty list.
#[test]
fn none() {
    assert!(scene(BASE).forces().is_empty());
    assert!(scene(&BASE.replace("name = \"base\"", "forces = []")).forces().is_empty());
}

/// Attraction by a point and between bodies, with nature's constant when none is given.
#[test]
fn gravity() {
    let point = force("type.point_gravity = { center = [1, 2, 3], mu = 4 }");
    assert!(
        matches!(point, Force::PointGravity { center, mu } if center == DVec3::new(1.0, 2.0, 3.0) && mu == 4.0),
        "{point:?}"
    );
    let origin = force("type.point_gravity.mu = 0.5");
    assert!(matches!(origin, Force::PointGravity { center: DVec3::ZERO, mu: 0.5 }), "{origin:?}");
    let mutual = force("type.mutual_gravity = {}");
    assert!(matches!(mutual, Force::MutualGravity { constant: GRAVITATION }), "{mutual:?}");
    let scaled = force("type.mutual_gravity.constant = 1");
    assert!(matches!(scaled, Force::MutualGravity { constant: 1.0 }), "{scaled:?}");
}

/// A force acts at the centre of mass along the axes of the world, unless said otherwise; a torque has no force.
#[test]
fn applied() {
    match force("type.force = { body = \"brick\", force = [1, 2, 3] }") {
        Force::Applied { body, force, torque, frame, point, signal } if body == BodyId::new(1) => {
            assert_eq!((force, torque, point), (DVec3::new(1.0, 2.0, 3.0), DVec3::ZERO, None));
            assert_eq!((frame, signal.at(7.0)), (Frame::World, 1.0));
        }
        other => panic!("{other:?}"),
    }
    match force("type.force = { body = \"brick\", force = [1, 2, 3], frame = \"body\", point = [0, 0, 1], signal = 2 }")
    {
        Force::Applied { body, frame, point, signal, .. } if body == BodyId::new(1) => {
            assert_eq!((frame, point, signal.at(7.0)), (Frame::Body, Some(DVec3::Z), 2.0));
        }
        other => panic!("{other:?}"),
    }
    match force("type.torque = { body = \"brick\", torque = [1, 2, 3], frame = \"world\" }") {
        Force::Applied { body, force, torque, frame, point, .. } if body == BodyId::new(1) => {
            assert_eq!((force, torque), (DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0)));
            assert_eq!((frame, point), (Frame::World, None));
        }
        other => panic!("{other:?}"),
    }
}

/// Every kind of signal, at times where its value is known.
#[test]
fn signals() {
    assert_eq!((signal("3").at(0.0), signal("-0.5").at(9.0)), (3.0, -0.5));
    assert!(signal("3").is_constant());
    let sinusoid = signal("{ sinusoid = { amplitude = 2, frequency_hz = 0.25, phase = 0 } }");
    assert!((sinusoid.at(1.0) - 2.0).abs() < 1e-15);
    let cosine = signal("{ sinusoid = { frequency_hz = 1, phase = 1.5707963267948966 } }");
    assert!((cosine.at(0.0) - 1.0).abs() < 1e-15);
    let table = signal("{ table = [[0, 1], [2, 5.0]] }");
    assert_eq!([-1.0, 0.5, 2.0, 9.0].map(|t| table.at(t)), [1.0, 2.0, 5.0, 5.0]);
    assert_eq!(signal("{ polynomial = [1, 2, 3] }").at(2.0), 17.0);
}

/// Drag on a body, on a list of them, and on all that move when none is named.
#[test]
fn drag() {
    let second = "[[bodies]]\nname = \"tile\"\nmass = 1\ninertia = [1, 1, 1]\n";
    let dragged = |keys: &str| {
        let text =
            format!("{BASE}\n{second}\n[[forces]]\ntype.drag = {{ law = \"linear\", rotational = 1, {keys} }}\n");
        let number = |force: &Force| match force {
            Force::Drag { body, .. } => body.index(),
            other => panic!("{other:?}"),
        };
        scene(&text).forces().iter().map(number).collect::<Vec<_>>()
    };
    assert_eq!(dragged("body = \"tile\""), [2]);
    assert_eq!(dragged("bodies = [\"tile\", \"brick\"]"), [2, 1]);
    assert_eq!(dragged("wind = [0, 0, 0]"), [1, 2]);
    match force("type.drag = { law = \"quadratic\", translational = 0.1, wind = [1, 0, 0] }") {
        Force::Drag { body, law, translational, rotational, wind } if body == BodyId::new(1) => {
            assert_eq!((law, translational, rotational, wind), (DragLaw::Quadratic, 0.1, 0.0, DVec3::X));
        }
        other => panic!("{other:?}"),
    }
}

/// Springs between bodies and to the world; the length at rest is that at the start, in the turned frames of the
/// bodies, when it is not given.
#[test]
fn springs() {
    match force("type.spring = { body = \"brick\", anchor = [0, 0, 4], stiffness = 5 }") {
        Force::Spring { a, b, stiffness, rest_length, damping } => {
            assert_eq!(a, Attachment::Body { body: BodyId::new(1), point: DVec3::ZERO });
            assert_eq!(b, Attachment::World(DVec3::Z * 4.0));
            assert_eq!((stiffness, rest_length, damping), (5.0, 6.0, 0.0));
        }
        other => panic!("{other:?}"),
    }
    let between = "type.spring = { bodies = [\"floor\", \"brick\"], points = [[0, 1, 0], [0, 0, 1]], stiffness = 5, \
                   damping = 2 }";
    let turned = with(between).replace("position = [0, 0, 10]", "position = [0, 0, 10]\norientation = [0, 1, 0, 0]");
    match &scene(&turned).forces()[0] {
        Force::Spring { a, b, rest_length, damping, .. } => {
            assert_eq!(*a, Attachment::Body { body: BodyId::new(0), point: DVec3::Y });
            assert_eq!(*b, Attachment::Body { body: BodyId::new(1), point: DVec3::Z });
            // The brick stands on its head: its point is at (0, 0, 9).
            assert!((rest_length - f64::sqrt(82.0)).abs() < 1e-14, "{rest_length}");
            assert_eq!(*damping, 2.0);
        }
        other => panic!("{other:?}"),
    }
    let given = force("type.spring = { body = \"brick\", anchor = [0, 0, 4], stiffness = 0, rest_length = 0 }");
    assert!(matches!(given, Force::Spring { rest_length: 0.0, .. }), "{given:?}");
}

/// Numbers out of range are refused where they stand.
#[test]
fn numbers_out_of_range() {
    let torque = |signal: &str| format!("type.torque = {{ body = \"brick\", torque = [0, 0, 1], signal = {signal} }}");
    let cases = [
        ("type.point_gravity = { mu = -1 }", "point_gravity.mu", "-1 is not accepted"),
        ("type.point_gravity = { mu = nan }", "point_gravity.mu", "at least 0"),
        ("type.point_gravity = { mu = 1, center = [0, inf, 0] }", "point_gravity.center.1", "a finite number"),
        ("type.mutual_gravity = { constant = inf }", "mutual_gravity.constant", "at least 0"),
        ("type.force = { body = \"brick\", force = [nan, 0, 0] }", "force.force.0", "a finite number"),
        ("type.force = { body = \"brick\", force = [1, 0, 0], point = [0, 0, nan] }", "force.point.2", "finite"),
        ("type.torque = { body = \"brick\", torque = [0, inf, 0] }", "torque.torque.1", "a finite number"),
        ("type.drag = { law = \"linear\", translational = -0.1 }", "drag.translational", "at least 0"),
        ("type.drag = { law = \"linear\", rotational = nan }", "drag.rotational", "at least 0"),
        ("type.drag = { law = \"linear\", rotational = 1, wind = [0, 0, nan] }", "drag.wind.2", "finite"),
        ("type.spring = { body = \"brick\", anchor = [0, 0, 0], stiffness = -1 }", "spring.stiffness", "at least 0"),
        ("type.spring = { body = \"brick\", anchor = [0, nan, 0], stiffness = 1 }", "spring.anchor.1", "finite"),
        (
            "type.spring = { body = \"brick\", anchor = [0, 0, 0], stiffness = 1, rest_length = -2 }",
            "spring.rest_length",
            "at least 0",
        ),
        (
            "type.spring = { body = \"brick\", anchor = [0, 0, 0], stiffness = 1, damping = -inf }",
            "spring.damping",
            "at least 0",
        ),
        ("type.spring = { body = \"brick\", anchor = [1e200, 0, 0], stiffness = 1 }", "spring", "inf is not accepted"),
        (&torque("nan"), "torque.signal", "a finite number"),
        (&torque("{ sinusoid = { frequency_hz = inf } }"), "torque.signal.sinusoid.frequency_hz", "a finite number"),
        (&torque("{ table = [] }"), "torque.signal.table", "at least one point"),
        (&torque("{ table = [[0, 1], [0, 2]] }"), "torque.signal.table.1.0", "times of a table must rise"),
        (&torque("{ table = [[0, 1], [1, nan]] }"), "torque.signal.table.1.1", "a finite number"),
        (&torque("{ polynomial = [] }"), "torque.signal.polynomial", "one or more coefficients"),
        (&torque("{ polynomial = [0, nan] }"), "torque.signal.polynomial.1", "a finite number"),
    ];
    for (line, key, message) in cases {
        check(&with(line), &format!("forces.0.type.{key}"), line, message);
    }
}

/// What must be there, what must not be there together, and what a fixed body cannot have.
#[test]
fn combinations() {
    let cases = [
        ("type.drag = { law = \"linear\" }", "drag", "drag needs `translational` or `rotational`"),
        ("type.drag = { translational = 1 }", "drag", "missing key `law`"),
        (
            "type.drag = { law = \"linear\", rotational = 1, body = \"brick\", bodies = [\"brick\"] }",
            "drag.bodies",
            "give one of them",
        ),
        ("type.drag = { law = \"linear\", rotational = 1, bodies = [] }", "drag.bodies", "one or more bodies"),
        (
            "type.drag = { law = \"linear\", rotational = 1, bodies = [\"brick\", \"brick\"] }",
            "drag.bodies.1",
            "body `brick` is named twice",
        ),
        (
            "type.drag = { law = \"linear\", rotational = 1, body = \"floor\" }",
            "drag.body",
            "`drag` has no meaning for a fixed body",
        ),
        (
            "type.force = { body = \"floor\", force = [1, 0, 0] }",
            "force.body",
            "`force` has no meaning for a fixed body",
        ),
        ("type.torque = { body = \"floor\", torque = [1, 0, 0] }", "torque.body", "no meaning for a fixed body"),
        ("type.torque = { body = \"brick\" }", "torque", "missing key `torque`"),
        ("type.spring = { stiffness = 1 }", "spring", "a spring needs `bodies`, or `body` and `anchor`"),
        ("type.spring = { body = \"brick\", stiffness = 1 }", "spring", "needs `anchor`"),
        ("type.spring = { body = \"brick\", anchor = [0, 0, 0] }", "spring", "missing key `stiffness`"),
        (
            "type.spring = { body = \"floor\", anchor = [0, 0, 0], stiffness = 1 }",
            "spring.body",
            "a spring needs a body that moves",
        ),
        (
            "type.spring = { bodies = [\"brick\", \"brick\"], stiffness = 1 }",
            "spring.bodies",
            "must join two different bodies",
        ),
        (
            "type.spring = { bodies = [\"brick\", \"floor\"], body = \"brick\", stiffness = 1 }",
            "spring.body",
            "give one of them",
        ),
        (
            "type.spring = { bodies = [\"brick\", \"floor\"], anchor = [0, 0, 0], stiffness = 1 }",
            "spring.anchor",
            "`anchor` has no meaning for a spring between two bodies",
        ),
        (
            "type.spring = { bodies = [\"brick\", \"floor\"], point = [0, 0, 0], stiffness = 1 }",
            "spring.point",
            "`point` has no meaning",
        ),
        (
            "type.spring = { body = \"brick\", anchor = [0, 0, 0], points = [[0, 0, 0], [0, 0, 0]], stiffness = 1 }",
            "spring.points",
            "`points` has no meaning for a spring between a body and the world",
        ),
        ("type.spring = { bodies = [\"brick\"], stiffness = 1 }", "spring.bodies", "an array of length 2"),
    ];
    for (line, key, message) in cases {
        check(&with(line), &format!("forces.0.type.{key}"), line, message);
    }
    let second_floor = with("type.spring = { bodies = [\"floor\", \"wall\"], stiffness = 1 }")
        + "[[bodies]]\nname = \"wall\"\nfixed = true\n";
    check(&second_floor, "forces.0.type.spring.bodies", "stiffness", "a spring needs a body that moves");
}

/// Kinds, keys and words that do not exist are named with those that do.
#[test]
fn unknown_keys_and_values() {
    let signal = |signal: &str| format!("type.torque = {{ body = \"brick\", torque = [0, 0, 1], signal = {signal} }}");
    let cases = [
        ("type.magnet = { body = \"brick\" }", "type.magnet", "accepted: `point_gravity`, `mutual_gravity`"),
        ("type.spring = { spring = 1 }", "type.spring.spring", "`stiffness`, `rest_length`"),
        ("kind = \"drag\"", "kind", "accepted: `type`"),
        ("", "", "missing key `type`"),
        ("type = \"drag\"", "type", "a force with its keys"),
        ("type = {}", "type", "point_gravity, mutual_gravity, force, torque, drag or spring"),
        ("type = { mutual_gravity = {}, point_gravity = { mu = 1 } }", "type", "exactly one of the kinds"),
        ("type.drag = 3", "type.drag", "accepted: a table"),
        ("type.drag = { law = \"cubic\", rotational = 1 }", "type.drag.law", "`linear` or `quadratic`"),
        (
            "type.force = { body = \"brick\", force = [0, 0, 1], frame = \"local\" }",
            "type.force.frame",
            "`world` or `body`",
        ),
        ("type.force = { body = \"brick\", force = 3 }", "type.force.force", "an array of length 3"),
        (&signal("\"loud\""), "type.torque.signal", "a number or a table with exactly one of `sinusoid`"),
        (&signal("{}"), "type.torque.signal", "exactly one of `sinusoid`, `table`, `polynomial`"),
        (&signal("{ polynomial = [1], table = [[0, 1]] }"), "type.torque.signal", "exactly one of"),
        (&signal("{ square = 1 }"), "type.torque.signal.square", "`sinusoid`, `table`, `polynomial`"),
        (&signal("{ sinusoid = { frequency = 1 } }"), "type.torque.signal.sinusoid.frequency", "`frequency_hz`"),
        (&signal("{ sinusoid = {} }"), "type.torque.signal.sinusoid", "missing key `frequency_hz`"),
        (&signal("{ table = [[0, 1, 2]] }"), "type.torque.signal.table.0", "an array of length 2"),
        (&signal("{ table = [0, 1] }"), "type.torque.signal.table.0", "an array of length 2"),
        (&signal("{ polynomial = 1 }"), "type.torque.signal.polynomial", "an array"),
    ];
    for (line, key, message) in cases {
        let key = if key.is_empty() { "forces.0".to_owned() } else { format!("forces.0.{key}") };
        check(&with(line), &key, if line.is_empty() { "[[forces]]" } else { line }, message);
    }
    assert!(matches!(refused(&with("type = {}")).cause, Refusal::ForceKinds));
    assert!(matches!(refused(&BASE.replace("name = \"base\"", "forces = 3")).cause, Refusal::Type { .. }));
}

/// A body that is not there is named with those that are, the most similar names first.
#[test]
fn unknown_bodies() {
    for (line, key) in [
        ("type.force = { body = \"bric\", force = [0, 0, 1] }", "force.body"),
        ("type.torque = { body = \"bric\", torque = [0, 0, 1] }", "torque.body"),
        ("type.drag = { body = \"bric\", law = \"linear\", rotational = 1 }", "drag.body"),
        ("type.drag = { bodies = [\"brick\", \"bric\"], law = \"linear\", rotational = 1 }", "drag.bodies.1"),
        ("type.spring = { bodies = [\"floor\", \"bric\"], stiffness = 1 }", "spring.bodies.1"),
        ("type.spring = { body = \"bric\", anchor = [0, 0, 0], stiffness = 1 }", "spring.body"),
    ] {
        check(&with(line), &format!("forces.0.type.{key}"), line, "no body is named `bric`");
        check(&with(line), &format!("forces.0.type.{key}"), line, "accepted: `brick`, `floor`");
    }
    let mut many = String::new();
    for number in 0..50 {
        let _ = write!(many, "[[bodies]]\nname = \"stone-{number}\"\nmass = 1\ninertia = [1, 1, 1]\n");
    }
    let rendered = refused(&(with("type.torque = { body = \"brik\", torque = [0, 0, 1] }") + &many)).to_string();
    assert!(rendered.contains("accepted: `brick`, `floor`, ") && rendered.contains("and 32 more"), "{rendered}");
}

/// Drag on every body, given ever again, is refused before it fills the memory.
#[test]
fn too_many_forces() {
    let mut text = "format = 1\n".to_owned();
    for number in 0..2_000 {
        let _ = write!(text, "[[bodies]]\nname = \"{number}\"\nmass = 1\ninertia = [1, 1, 1]\n");
    }
    text += &"[[forces]]\ntype.drag = { law = \"linear\", rotational = 1 }\n".repeat(501);
    check(&text, "forces.500", "[[forces]]", "more than 1000000 forces");
}

//! Figures: the same bytes for the same data, well-formed, without numbers that are none, and with labels that can be
//! read.
//!
//! Texts are held against each other with the width of a common font (Arial), narrower than what the layout keeps free.

use polhode::mesh::solid_sphere;
use polhode::spatial::{DVec3, Mass, Pose, Velocity};
use polhode::{Body, BodyError, BodySample, Observer, Scene, Simulation};
use polhode_view::plot::cost_chart::{CostCurve, CostPoint, Level, OtherUnits, Rank, Target};
use polhode_view::plot::cost_panels::{CostPanel, CostPanels, PanelBand, PanelCurve, PanelPoint};
use polhode_view::plot::dot_chart::{Cell, Dot, Row};
use polhode_view::plot::time_chart::{AxisKind, Course, EventRow, Line, OVER_TIME, Panel, Reach, Stop};
use polhode_view::plot::{ComparePlot, ComparePlots, CostChart, DotChart, Ink, RunPlot, RunPlots, TimeChart, Trace};
use proptest::prelude::*;

/// A text of a figure.
struct Written {
    text: String,
    from: [f64; 2],
    to: [f64; 2],
}

impl Written {
    fn overlaps(&self, other: &Self) -> bool {
        (0..2).all(|axis| self.from[axis] < other.to[axis] && other.from[axis] < self.to[axis])
    }
}

/// The value of an attribute of an element.
fn attribute<'a>(element: &'a str, name: &str) -> Option<&'a str> {
    let begin = element.find(&format!(" {name}=\""))? + name.len() + 3;
    element[begin..].split('"').next()
}

/// The texts of a figure that read from left to right.
fn texts(svg: &str) -> Vec<Written> {
    let lines = svg.lines().filter(|line| line.starts_with("<text") && !line.contains("rotate("));
    lines
        .map(|line| {
            let number = |name: &str| attribute(line, name).unwrap().parse::<f64>().unwrap();
            let (x, foot, size) = (number("x"), number("y"), number("font-size"));
            let inner = line.split_once('>').unwrap().1;
            let mut text = String::new();
            let mut is_markup = false;
            for letter in inner.chars() {
                match letter {
                    '<' => is_markup = true,
                    '>' => is_markup = false,
                    _ if !is_markup => text.push(letter),
                    _ => {}
                }
            }
            // Mean width of Arial's letters and digits.
            let width = 0.5 * size * text.replace("&lt;", "<").chars().count() as f64;
            let from = match attribute(line, "text-anchor") {
                Some("middle") => x - 0.5 * width,
                Some("end") => x - width,
                _ => x,
            };
            Written { text, from: [from, foot - 0.72 * size], to: [from + width, foot] }
        })
        .collect()
}

/// Checks that every element that is opened is closed, in order, and that attributes have quotes.
fn check_well_formed(svg: &str) {
    let mut open: Vec<&str> = Vec::new();
    for part in svg.split('<').skip(1) {
        let (tag, text) = part.split_once('>').expect("a tag that ends");
        assert!(!text.contains('"') || open.contains(&"style") || !text.contains('<'), "{part}");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name), "{svg}");
        } else {
            assert_eq!(tag.matches('"').count() % 2, 0, "{tag}");
            let name = tag.split([' ', '/']).next().unwrap();
            if !tag.ends_with('/') {
                open.push(name);
            }
        }
        for entity in text.split('&').skip(1) {
            assert!(["amp;", "lt;", "gt;", "quot;"].iter().any(|known| entity.starts_with(known)), "{text}");
        }
    }
    assert!(open.is_empty() && svg.starts_with("<svg xmlns=") && svg.ends_with("</svg>\n"), "{open:?}");
}

/// Checks that no attribute holds what is not a number.
fn check_numbers(svg: &str) {
    for line in svg.lines().filter(|line| !line.starts_with("<text") && !line.starts_with("<title")) {
        let lower = line.to_lowercase();
        assert!(!lower.contains("nan") && !lower.contains("inf"), "{line}");
    }
    for line in svg.lines().filter(|line| line.starts_with("<text")) {
        let begin = line.split('>').next().unwrap().to_lowercase();
        assert!(!begin.contains("nan") && !begin.contains("inf\""), "{line}");
    }
}

fn check(svg: &str) {
    check_well_formed(svg);
    check_numbers(svg);
    let all = texts(svg);
    for (number, text) in all.iter().enumerate() {
        let other = all[..number].iter().find(|other| other.overlaps(text));
        assert!(other.is_none(), "`{}` is over `{}`", text.text, other.map_or("", |other| &other.text));
    }
}

fn panel(axis: AxisKind, lines: Vec<Line>) -> Panel {
    Panel { title: "energy, J".to_owned(), note: "magnitudes".to_owned(), axis, lines, bands: Vec::new() }
}

fn line(name: &str, samples: &[[f64; 2]]) -> Line {
    Line { label: name.to_owned(), ink: Ink::Blue, course: Course::Straight, trace: Trace::of(samples.iter().copied()) }
}

fn chart(panels: Vec<Panel>) -> TimeChart {
    let event = |label: &str, times_s: &[f64]| EventRow {
        label: label.to_owned(),
        ink: Ink::Vermilion,
        reach: Reach::Panels,
        times_s: times_s.to_vec(),
    };
    TimeChart {
        title: "a <scene> & \"more\"".to_owned(),
        subtitle: "tier accurate".to_owned(),
        along: OVER_TIME.to_owned(),
        events: vec![event("impact", &[0.5, 1.0]), event("rest", &[])],
        panels,
        stop: Some(Stop { t_s: 1.5, reason: "a force grows without bound".to_owned() }),
    }
}

const KINDS: [AxisKind; 3] = [AxisKind::Linear, AxisKind::Count, AxisKind::Logarithmic];

/// Nothing, one sample, equal samples, zeros, what is not finite, huge and tiny numbers: every figure is a figure.
#[test]
fn data_of_any_kind_gives_a_figure() {
    let (nan, inf) = (f64::NAN, f64::INFINITY);
    let all: [&[[f64; 2]]; 9] = [
        &[],
        &[[0.0, 3.0]],
        &[[0.0, 5.0], [1.0, 5.0], [2.0, 5.0]],
        &[[0.0, 0.0], [1.0, -0.0]],
        &[[0.0, nan], [1.0, inf], [2.0, -inf]],
        &[[0.0, 1.0], [0.5, nan], [1.0, 2.0], [1.5, inf], [2.0, 3.0]],
        &[[0.0, 1e300], [1.0, -1e300], [2.0, f64::MAX]],
        &[[0.0, 5e-324], [1.0, 1e-300]],
        &[[nan, 1.0], [inf, 2.0]],
    ];
    for samples in all {
        let lines = || vec![line("one", samples), line("two", &[])];
        let panels: Vec<Panel> = KINDS.into_iter().map(|axis| panel(axis, lines())).collect();
        check(&chart(panels).svg());
    }
    check(&TimeChart { stop: None, events: Vec::new(), ..chart(Vec::new()) }.svg());
}

/// The same data gives the same bytes, on every machine: the figure is pinned by its checksum, which a change of what
/// figures look like changes too.
#[test]
fn the_same_data_gives_the_same_bytes() {
    let samples: Vec<[f64; 2]> = (0..50).map(|i| [0.1 * f64::from(i), f64::from(i * i % 17)]).collect();
    let time = || chart(vec![panel(AxisKind::Linear, vec![line("a", &samples)]), panel(AxisKind::Logarithmic, vec![])]);
    let cost = || cost_chart(&[(-1.0, -3.0), (0.0, -6.0), (1.0, -9.0)], 1e-6);
    assert_eq!((time().svg(), cost().svg()), (time().svg(), cost().svg()));
    let sums = [time().svg(), cost().svg()].map(|svg| checksum(&svg));
    assert_eq!(sums, [12292525228974542214, 15528153611663249815], "the figures have changed");
}

/// FNV-1a, 64 bits.
fn checksum(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |sum, byte| (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// A figure of three methods for each of these decades of cost and error.
fn cost_chart(ends: &[(f64, f64)], target: f64) -> CostChart {
    const NAMES: [&str; 8] = [
        "rk4",
        "explicit-euler",
        "exact-adaptive",
        "splitting-6",
        "cf4",
        "moser-veselov-4",
        "a long name & more",
        "dop853",
    ];
    let curves = ends.iter().enumerate().map(|(number, &(cost, error))| {
        let point = |shift: f64| {
            let cost = libm::exp10(cost - shift);
            CostPoint {
                cost,
                spread: [0.9 * cost, 1.1 * cost],
                error: libm::exp10(error + 2.0 * shift),
                estimated: Some(3.0 * libm::exp10(error + 2.0 * shift)),
                on_front: number == 0,
                rank: if number == 0 && shift == 0.0 { Rank::Cheapest } else { Rank::Plain },
            }
        };
        let name = format!("{}{}", NAMES[number % NAMES.len()], if number < NAMES.len() { "" } else { " again" });
        CostCurve { name, points: vec![point(1.0), point(0.5), point(0.0)] }
    });
    CostChart {
        title: "a scene: error against cost".to_owned(),
        subtitle: "10 s simulated".to_owned(),
        cost: "time, relative to rk4 step 0.1".to_owned(),
        error: "error".to_owned(),
        units: OtherUnits { microseconds: Some(120.0), millimetres: Some(850.0), degrees: Some(57.3) },
        floor: 1e-13,
        levels: vec![Level { error: 3e-2, text: "difference of law: propagation".to_owned() }],
        curves: curves.collect(),
        target: Some(Target { error: target, text: "rk4 step 0.1".to_owned() }),
    }
}

/// A study in which nothing ran, one of one point, and one of points that are none.
#[test]
fn a_study_of_any_kind_gives_a_figure() {
    check(&cost_chart(&[], 1e-6).svg());
    check(&cost_chart(&[(0.0, -6.0)], 1e-6).svg());
    let nan = f64::NAN;
    let mut broken = cost_chart(&[(nan, -6.0), (400.0, -6.0), (0.0, 5.0)], 1e-20);
    broken.floor = nan;
    broken.units = OtherUnits { microseconds: Some(nan), millimetres: Some(0.0), degrees: Some(f64::INFINITY) };
    check(&broken.svg());
    let cells = |dots: &[(&str, f64)], best: Option<usize>| Cell {
        dots: dots.iter().map(|&(method, value)| Dot { method: method.to_owned(), value }).collect(),
        best,
        text: "rk4 and 2 ties".to_owned(),
    };
    let row = |cells: Vec<Cell>| Row { name: "scene".to_owned(), note: "1 s".to_owned(), cells };
    let dots = |rows: Vec<Row>| DotChart {
        title: "title".to_owned(),
        subtitle: "subtitle".to_owned(),
        across: "us".to_owned(),
        columns: vec!["error 1e-3".to_owned(), "error 1e-6".to_owned()],
        rows,
    };
    check(&dots(Vec::new()).svg());
    let all = vec![
        row(vec![cells(&[("rk4", 1.0), ("cf4", 3.0)], Some(0)), Cell::default()]),
        row(vec![cells(&[("rk4", nan)], Some(0)), cells(&[("exact", 1e-5)], Some(7))]),
    ];
    check(&dots(all).svg());
}

/// Panels of nothing, of points that are none, of errors beyond any answer; one method highlighted.
#[test]
fn panels_of_any_kind_give_a_figure() {
    let curve = |name: &str, points: &[[f64; 2]]| {
        let point = |&[seconds, error]: &[f64; 2]| PanelPoint { seconds, error, estimated: Some(2.0 * error) };
        PanelCurve { name: name.to_owned(), points: points.iter().map(point).collect() }
    };
    let band = Some(PanelBand { errors: [1e-2, 1e-2], text: "laws differ".to_owned() });
    let panel = |curves: Vec<PanelCurve>| CostPanel { title: "A box & a floor".to_owned(), curves, band: band.clone() };
    let figure = |panels: Vec<CostPanel>, highlighted: &[&str]| {
        let highlighted = highlighted.iter().map(|name| (*name).to_owned()).collect();
        let text = |text: &str| text.to_owned();
        CostPanels {
            title: text("title"),
            subtitle: text("how"),
            across: text("s"),
            up: text("error"),
            panels,
            highlighted,
        }
        .svg()
    };
    check(&figure(Vec::new(), &[]));
    check(&figure(vec![panel(Vec::new())], &["fast"]));
    let nan = f64::NAN;
    let odd = panel(vec![curve("fast", &[[nan, 1.0], [1.0, nan], [0.0, 0.0]]), curve("none", &[])]);
    check(&figure(vec![odd.clone()], &[]));
    let all = || {
        vec![panel(vec![curve("accurate", &[[1e-3, 1e-15]]), curve("fast", &[[1e-3, 1e5], [1e-1, 1e-2]])]), odd.clone()]
    };
    check(&figure(all(), &[]));
    let highlighted = figure(all(), &["fast"]);
    check(&highlighted);
    assert!(
        highlighted.contains(">fast<") && highlighted.contains(">accurate<") && highlighted.contains(">real time<")
    );
}

/// Nothing but the error of the reference and a target, below it or at the upper edge: both levels and their names are
/// within the frame.
#[test]
fn levels_are_in_the_frame_without_any_curve() {
    check(&cost_chart(&[], 1.4e-14).svg());
    check(&cost_chart(&[], 0.4).svg());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Whatever the last values of the lines, their labels can be read.
    #[test]
    fn labels_of_lines_do_not_overlap(
        ends in prop::collection::vec(
            prop_oneof![-1e3..1e3_f64, prop::sample::select(vec![0.0, 1.0, 1e-12, 1e200])],
            1..14,
        ),
        kind in prop::sample::select(KINDS.to_vec()),
    ) {
        let lines = ends.iter().enumerate().map(|(i, &end)| line(&format!("body {i} {end:.1e} \
            m"), &[[0.0, 0.0], [2.0, end]]));
        check(&chart(vec![panel(kind, lines.collect()), panel(AxisKind::Linear, Vec::new())]).svg());
    }

    /// Wherever curves end, their labels can be read.
    #[test]
    fn labels_of_curves_do_not_overlap(
        ends in prop::collection::vec((-4.0..3.0_f64, -14.0..1.0_f64), 0..18),
        target in -14.0..0.0_f64,
    ) {
        check(&cost_chart(&ends, libm::exp10(target)).svg());
    }
}

/// A ball that falls for a second: energies, steps and the end are in the figure, and it has the same bytes every time.
#[test]
fn a_run() {
    let ball = Body::movable("ball", solid_sphere(0.1, Mass::new(2.0).unwrap()).unwrap());
    let scene =
        Scene::builder("fall").body(ball.pose(Pose::from_translation(DVec3::Z))).duration_s(1.0).build().unwrap();
    let draw = |asked: &[RunPlot], stopped: Option<&str>| {
        let mut plots = RunPlots::new(&scene, 0.0, asked);
        assert_eq!(plots.wants_frames(), asked != [RunPlot::Steps]);
        Simulation::new(&scene).unwrap().run_observed(&mut plots).unwrap();
        plots.svg("tier accurate", stopped)
    };
    let all = draw(&RunPlot::ALL, None);
    check(&all);
    for part in
        ["energy, J", "kinetic", "total 19.62 J", "numerical", "penetration, m", "length of the steps, s", "time, s"]
    {
        assert!(all.contains(part), "{part}");
    }
    assert_eq!(all, draw(&RunPlot::ALL, None));
    let some = draw(&[RunPlot::Energy, RunPlot::Energy], Some("it was interrupted"));
    assert!(some.contains("ended at t = 1 s: it was interrupted") && !some.contains("penetration"), "{some}");
    check(&draw(&[RunPlot::Steps], None));
    let without_joints = draw(&[RunPlot::Energy, RunPlot::JointRates], None);
    check(&without_joints);
    assert!(without_joints.contains("joints: none"), "{without_joints}");
}

/// Two motions that differ by a millimetre and half a milliradian in a second: so the figure says, and the energies are
/// those of the scene's masses.
#[test]
fn two_trajectories() {
    let ball = Body::movable("ball", solid_sphere(0.1, Mass::new(2.0).unwrap()).unwrap());
    let scene = Scene::builder("fall").body(ball).duration_s(1.0).build().unwrap();
    let sample = |x: f64, angle: f64, speed: f64| BodySample {
        pose: Pose::new(polhode::spatial::Rotation::from_rotation_vector(DVec3::X * angle), DVec3::X * x),
        velocity: Velocity { linear: DVec3::Y * speed, angular: DVec3::ZERO },
    };
    let mut plots = ComparePlots::new(&ComparePlot::ALL, Some(&scene));
    for t_s in [0.0, 1.0, 2.0] {
        plots.push(t_s, "ball", [&sample(0.0, 0.0, 1.0), &sample(1e-3 * t_s, 6e-4 * t_s, 1.0 + t_s)], None);
        plots.push(t_s, "floor", [&sample(0.0, 0.0, 0.0), &sample(0.0, 0.0, 0.0)], None);
    }
    let svg = plots.svg(["a.csv", "b.csv"], Some("the second ends"));
    check(&svg);
    for part in [
        "a.csv compared with b.csv",
        "ball 0.002 m<",
        "ball 0.0012 rad",
        "ball 2 m/s<",
        "\u{2212}8 J",
        "ended at t = 2 s",
    ] {
        assert!(svg.contains(part), "{part}\n{svg}");
    }
    assert!(!svg.contains("floor"), "what does not differ has no line");
    check(&ComparePlots::new(&ComparePlot::ALL, None).svg(["a", "b"], None));
}

/// Estimated errors are a band around the distance of positions and the angle between attitudes: one band for each
/// curve of those two, none for velocities, and none where errors are not known.
#[test]
fn errors_are_bands_around_curves() {
    let at = |x: f64| BodySample { pose: Pose::from_translation(DVec3::X * x), velocity: Velocity::ZERO };
    let drawn = |errors: Option<[BodyError; 2]>| {
        let mut plots = ComparePlots::new(&ComparePlot::ALL, None);
        for t_s in [0.0, 1.0, 2.0] {
            plots.push(t_s, "ball", [&at(0.0), &at(1e-3 * t_s)], errors);
        }
        let svg = plots.svg(["a.csv", "b.csv"], None);
        check(&svg);
        svg
    };
    let areas = |svg: &str| svg.lines().filter(|line| line.contains("Z\"") && line.contains("opacity")).count();
    let known = drawn(Some([BodyError::new(1e-4, 0.0), BodyError::new(2e-4, 0.0)]));
    assert_eq!(areas(&known), 1, "{known}");
    assert!(known.contains("estimated errors of both"));
    let unknown = drawn(None);
    assert_eq!(areas(&unknown), 0);
    assert!(!unknown.contains("estimated errors"));
}

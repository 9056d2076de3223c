//! The table and the figure of what was measured.

use super::measured::Measured;
use super::scenes::Scene;
use polhode::Certificate;
use polhode_view::plot::dot_chart::{Cell, Dot, DotChart, Row};

/// What is shown for nothing on a logarithmic axis.
const NOTHING: f64 = 1e-17;

/// All that was measured of one scene.
pub(crate) struct Compared {
    pub(crate) scene: Scene,
    pub(crate) ours: Measured,
    pub(crate) own: Certificate,
    /// Rapier with its defaults, without sleep, and without sleep and with Coulomb friction at each point.
    pub(crate) defaults: Measured,
    pub(crate) awake: Measured,
    pub(crate) judged: Measured,
}

impl Compared {
    /// A row of the table, in Markdown.
    pub(crate) fn row(&self) -> String {
        let Self { scene, ours, own, defaults, awake, judged } = self;
        let times = |of: &Measured| format!("{} / {}", number(of.milliseconds(0.5)), number(of.milliseconds(0.99)));
        let ratio = |part: f64, other: &Measured| number(ours.milliseconds(part) / other.milliseconds(part));
        let drift = |of: &Measured| if scene.stands { number(of.drift) } else { "-".to_owned() };
        let residual = |of: &Measured| format!("{} / {}", number(of.residual(0.5)), number(of.residual(1.0)));
        let [middle, many] = [0.5, 0.99].map(|part| ours.factorisations(part));
        [
            format!("| {}, {} bodies", scene.name, scene.members.len()),
            format!("{} of {}", ours.times.len(), scene.steps),
            format!("{} ms; {}", number(ours.start * 1e3), times(ours)),
            format!("{}; {}", times(defaults), times(awake)),
            format!(
                "{} / {}; {} / {}",
                ratio(0.5, defaults),
                ratio(0.99, defaults),
                ratio(0.5, awake),
                ratio(0.99, awake)
            ),
            format!("{}; {}", number(ours.penetration), number(judged.penetration)),
            format!("{}; {}", drift(ours), drift(judged)),
            format!("{}; {}", residual(ours), residual(judged)),
            format!("{middle} / {many}; {} |", number(own.max_residual)),
        ]
        .join(" | ")
    }

    fn cells(&self) -> Row {
        let cell = |ours: f64, peer: f64| {
            let dot = |method: &str, value: f64| Dot { method: method.to_owned(), value: value.max(NOTHING) };
            Cell { dots: vec![dot("polhode, stepped", ours), dot("rapier3d-f64", peer)], ..Cell::default() }
        };
        let seconds = |part: f64| cell(self.ours.milliseconds(part) * 1e-3, self.defaults.milliseconds(part) * 1e-3);
        Row {
            name: self.scene.name.to_owned(),
            note: format!("{} bodies", self.scene.members.len()),
            cells: vec![
                seconds(0.5),
                seconds(0.99),
                cell(self.ours.penetration, self.judged.penetration),
                cell(self.ours.residual(0.5), self.judged.residual(0.5)),
            ],
        }
    }
}

/// The head of the table.
pub(crate) const HEAD: &str = "| scene | steps | polhode: start; a step, ms, median / 99 % | rapier, ms: defaults; \
    nothing sleeps | ratio: to defaults; to awake | penetration, m: polhode; rapier | drift, m | residual, median / \
    largest: polhode; rapier | factorisations a step, median / 99 %; own largest residual |\n\
    |---|---|---|---|---|---|---|---|---|";

/// The figure.
pub(crate) fn figure(compared: &[Compared]) -> String {
    DotChart {
        title: "Heaps, walls and towers".to_owned(),
        subtitle: "one process, one thread, the same states; nothing is shown as 1e-17".to_owned(),
        across: "smaller is better, on all axes".to_owned(),
        columns: ["median step, s", "99 % step, s", "penetration, m", "residual"].map(str::to_owned).to_vec(),
        rows: compared.iter().map(Compared::cells).collect(),
    }
    .svg()
}

fn number(value: f64) -> String {
    if value == 0.0 || (0.01..1e4).contains(&value) {
        let digits = if value >= 100.0 {
            0
        } else if value >= 1.0 {
            1
        } else {
            3
        };
        return format!("{value:.digits$}");
    }
    format!("{value:.1e}")
}

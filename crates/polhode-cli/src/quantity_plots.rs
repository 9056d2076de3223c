//! Plots of single quantities of a run, by name: over time, or against another quantity.

use crate::failure::Failure;
use polhode::{BodySample, ContactSample, Energy, JointSample, Observer};
use polhode_scene::{LoadedScene, Quantity};
use polhode_view::plot::time_chart::OVER_TIME;
use polhode_view::plot::{CurvePanel, Curves, RunPlot};

/// What of a plot is a curve: its place, and the quantity.
struct Drawn {
    panel: usize,
    curve: usize,
    quantity: Quantity,
}

/// The quantities that are plotted, and their curves so far.
pub(crate) struct QuantityPlots {
    drawn: Vec<Drawn>,
    against: Option<Quantity>,
    curves: Curves,
    /// The sample that is being told: its time (s), what is along the axis, and the values.
    now: Option<f64>,
    along: f64,
    values: Vec<f64>,
}

/// What is asked for: panels of a run, and quantities.
pub(crate) struct Wanted {
    pub(crate) panels: Vec<RunPlot>,
    pub(crate) quantities: QuantityPlots,
}

impl Wanted {
    /// From words of `--plot` and `--against`.
    ///
    /// # Errors
    /// When one is no plot and no quantity of the scene, or panels are asked for against a quantity.
    pub(crate) fn of(words: &[String], against: Option<&str>, loaded: &LoadedScene) -> Result<Self, Failure> {
        let known = || RunPlot::ALL.into_iter().chain(RunPlot::OF_JOINTS);
        let (mut panels, mut quantities): (Vec<RunPlot>, Vec<Quantity>) = (Vec::new(), Vec::new());
        for word in words {
            if let Some(plot) = known().find(|plot| plot.name() == word) {
                panels.push(plot);
            } else {
                let quantity = loaded.quantity(word).map_err(|error| {
                    let near = known().find(|plot| polhode_scene::is_slip_of(word, plot.name()));
                    let meant = near.map_or_else(String::new, |plot| format!("did you mean `{}`? ", plot.name()));
                    let names: Vec<&str> = known().map(RunPlot::name).collect();
                    Failure::Usage(
                        format!("error: --plot {error}; or all of {}: {meant}", names.join(", "))
                            .trim_end_matches([':', ' '])
                            .to_owned(),
                    )
                })?;
                if !quantities.contains(&quantity) {
                    quantities.push(quantity);
                }
            }
        }
        let against = against.map(|word| one_number(word, loaded)).transpose()?;
        match (&against, panels.first(), quantities.first()) {
            (Some(_), Some(plot), _) => {
                let what = format!("error: --against: `{}` is plotted over time; name single quantities", plot.name());
                Err(Failure::Usage(what))
            }
            (Some(_), None, None) => {
                let what = "error: --against: what is plotted against it? --plot QUANTITY, as torque:NAME";
                Err(Failure::Usage(what.to_owned()))
            }
            _ => Ok(Self { panels, quantities: QuantityPlots::new(quantities, against, loaded) }),
        }
    }
}

/// A quantity that is one number.
fn one_number(word: &str, loaded: &LoadedScene) -> Result<Quantity, Failure> {
    let quantity = loaded.quantity(word).map_err(|error| Failure::Usage(format!("error: --against {error}")))?;
    if quantity.component.is_none() && quantity.size() > 0 {
        let what = format!("error: --against {word}: a vector has no place along an axis; a component, as {word}[0]");
        return Err(Failure::Usage(what));
    }
    Ok(quantity)
}

/// A name with its unit, where it has one.
fn with_unit(quantity: &Quantity) -> String {
    match quantity.unit() {
        "" => quantity.name(),
        unit => format!("{}, {unit}", quantity.name()),
    }
}

impl QuantityPlots {
    fn new(quantities: Vec<Quantity>, against: Option<Quantity>, loaded: &LoadedScene) -> Self {
        let (mut drawn, mut panels) = (Vec::new(), Vec::new());
        for (panel, quantity) in quantities.into_iter().enumerate() {
            let curves = quantity.curves();
            let names = curves.iter().map(|(name, _)| name.clone()).collect();
            panels.push(CurvePanel::new(quantity.name(), quantity.unit(), names));
            let of = |(curve, (_, quantity)): (usize, (String, Quantity))| Drawn { panel, curve, quantity };
            drawn.extend(curves.into_iter().enumerate().map(of));
        }
        let along = against.as_ref().map_or_else(|| OVER_TIME.to_owned(), with_unit);
        let curves = Curves::new(loaded.scene.name().to_owned(), along, panels);
        let values = vec![f64::NAN; drawn.len()];
        Self { drawn, against, curves, now: None, along: f64::NAN, values }
    }

    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.drawn.is_empty()
    }

    /// Whether they are against a quantity.
    pub(crate) fn is_against(&self) -> bool {
        self.against.is_some()
    }

    /// The curves of all samples that were told.
    pub(crate) fn finished(&mut self) -> &Curves {
        self.end_sample();
        &self.curves
    }

    fn quantities(&self) -> impl Iterator<Item = &Quantity> {
        self.drawn.iter().map(|own| &own.quantity).chain(&self.against)
    }

    /// Takes the values that a part of a sample has.
    fn take(&mut self, value: impl Fn(&Quantity) -> Option<f64>) {
        for (own, kept) in self.drawn.iter().zip(&mut self.values) {
            *kept = value(&own.quantity).unwrap_or(*kept);
        }
        self.along = self.against.as_ref().and_then(value).unwrap_or(self.along);
    }

    fn end_sample(&mut self) {
        let Some(t_s) = self.now.take() else { return };
        let along = if self.against.is_some() { self.along } else { t_s };
        for (own, value) in self.drawn.iter().zip(&self.values) {
            if let Some(panel) = self.curves.panel(own.panel) {
                panel.push(own.curve, [along, *value]);
            }
        }
        self.values.fill(f64::NAN);
        self.along = f64::NAN;
    }
}

impl Observer for QuantityPlots {
    fn sample(&mut self, t_s: f64, bodies: &[BodySample]) {
        self.end_sample();
        self.now = Some(t_s);
        self.take(|own| own.of_bodies(bodies));
    }

    fn wants_joints(&self) -> bool {
        self.quantities().any(Quantity::is_of_joints)
    }

    fn joints(&mut self, _t_s: f64, joints: &[JointSample]) {
        self.take(|own| own.of_joints(joints));
    }

    fn wants_contacts(&self) -> bool {
        self.quantities().any(Quantity::is_of_contacts)
    }

    fn contacts(&mut self, _t_s: f64, contacts: &[ContactSample]) {
        let views: Vec<_> = contacts.iter().map(|own| own.view).collect();
        self.take(|own| own.of_contacts(&views));
    }

    fn wants_energies(&self) -> bool {
        self.quantities().any(Quantity::is_of_energy)
    }

    fn energy(&mut self, _t_s: f64, energy: &Energy) {
        self.take(|own| own.of_energy(energy));
    }
}

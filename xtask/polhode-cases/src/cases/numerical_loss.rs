//! The ledger's statement of accuracy: what the integrator itself loses in smooth scenes that conserve energy.

use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use polhode::Effects;
use polhode::scene::{Integrator, Method};
use std::error::Error;

const CASE: &str = "numerical loss";
/// What the default method may lose, relative to the largest energy of the run.
const LOSS: f64 = 1e-12;

/// Shipped scenes whose energy is constant and whose motion is smooth.
const SCENES: [&str; 3] = ["dzhanibekov", "heavy-top", "kepler-orbit"];

/// Loss of the default method, and for information that of all others.
pub(super) fn conservative_scenes(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for name in SCENES {
        let run = context.shipped.run(name)?;
        let quantity = format!("{name}: D_numerical of the default method, relative");
        rows.push(Row::at_most(CASE, &quantity, LOSS, loss(&run)));
        for integrator in Integrator::ALL {
            let quantity = format!("{name}: D_numerical of {integrator}, relative");
            let method = Method { integrator: Some(integrator), ..run.scene.method().clone() };
            rows.push(match with_method(&run, method) {
                Ok(loss) => Row::info(CASE, &quantity, 0.0, loss),
                Err(error) => Row::info(CASE, &quantity, 0.0, error.to_string()),
            });
        }
    }
    Ok(rows)
}

fn with_method(run: &Run, method: Method) -> Result<f64, Box<dyn Error>> {
    Ok(loss(&Run::of(&run.scene.clone().with_method(method), Effects::Planned)?))
}

/// Energy that the integrator lost, relative to the largest of the run.
fn loss(run: &Run) -> f64 {
    run.report.ledger.numerical.value() / run.report.ledger.scale_j
}

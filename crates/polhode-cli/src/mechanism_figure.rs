//! The figure of the motion that begins: of `polhode stands --picture`, and in the pages of runs that begin with bodies
//! at rest.

use crate::text::stands::what_begins;
use polhode::{BodyId, Scene, Simulation};
use polhode_scene::LoadedScene;
use polhode_study::stands::{Mechanism, mechanism_at_push};
use polhode_view::plot::{HingeMark, MechanismPlot};

/// Most contacts of which a report or a page says how far they are from moving: some tenths of a second.
pub(crate) const MOST_CONTACTS: usize = 500;

/// The figure of a mechanism in the scene as it begins, as SVG; of none where nothing begins to move.
pub(crate) fn of(scene: &Scene, mechanism: Option<&Mechanism>, title: &str) -> String {
    let subtitle =
        mechanism.map_or_else(|| "nothing begins to move".to_owned(), |mechanism| what_begins(scene, mechanism));
    let (bodies, hinges) = match mechanism {
        Some(mechanism) => (&mechanism.bodies[..], &mechanism.hinges[..]),
        None => (&[][..], &[][..]),
    };
    let marks: Vec<HingeMark> = hinges
        .iter()
        .map(|hinge| {
            let moves = |body: &BodyId| bodies.iter().any(|own| own.body == *body);
            let body = hinge.bodies.into_iter().find(moves).unwrap_or(hinge.bodies[0]);
            HingeMark { body, place: hinge.middle_m() }
        })
        .collect();
    MechanismPlot { title, subtitle: &subtitle, scene, bodies, hinges: &marks }.svg()
}

/// A figure, and what it shows in a line.
pub(crate) struct Captioned {
    pub(crate) caption: String,
    pub(crate) svg: String,
}

/// What begins at the least push, of a simulation that has not begun; none where nothing rests, contacts are too many
/// for it to be found at once, or it cannot be found.
pub(crate) fn at_start(loaded: &LoadedScene, simulation: &Simulation) -> Option<Captioned> {
    let contacts = simulation.contacts();
    if contacts.is_empty() || contacts.len() > MOST_CONTACTS || simulation.time() > 0.0 {
        return None;
    }
    let mechanism = mechanism_at_push(&loaded.scene, &simulation.stability().ok()?, &contacts)?;
    let svg = of(&loaded.scene, Some(&mechanism), "What would move first");
    Some(Captioned { caption: what_begins(&loaded.scene, &mechanism), svg })
}

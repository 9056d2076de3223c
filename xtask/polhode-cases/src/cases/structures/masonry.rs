//! Structures that are built to stand: arches of equal stones and houses of cards.

use super::built::Built;
use glam::DVec3;
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};

/// Depth of an arch of mean radius 1 m, m.
const DEPTH: f64 = 0.2;

/// Density of stones and cards, kg/m^3.
const DENSITY: f64 = 2000.0;

/// A semicircular arch of mean radius 1 m and this thickness (m), of equal stones with radial joints.
pub(super) fn arch(stones: u32, thickness: f64, friction: f64) -> Result<Built, Box<dyn Error>> {
    let (inner, outer) = (1.0 - 0.5 * thickness, 1.0 + 0.5 * thickness);
    let radial = |angle: f64| DVec3::new(libm::sin(angle), 0.0, libm::cos(angle));
    let mut built = Built::on_the_ground(friction)?;
    for stone in 0..stones {
        let joint = |k: u32| PI * f64::from(k) / f64::from(stones) - FRAC_PI_2;
        let (from, to) = (radial(joint(stone)), radial(joint(stone + 1)));
        let profile = [from * inner, from * outer, to * outer, to * inner];
        built.prism(&format!("stone {stone}"), profile, DEPTH, DENSITY)?;
    }
    Ok(built)
}

/// Length, depth and thickness of a card, m.
const CARD: DVec3 = DVec3::new(0.09, 0.06, 0.002);

/// Distance between the apexes of one storey, m: a little more than the length of the cards that lie on them.
const SPAN: f64 = 0.0905;

/// A house of cards: every storey has one tent of two cards less than the one below, and stands on cards that lie from
/// apex to apex. The cards lean by this angle (rad) from the vertical.
pub(super) fn card_house(storeys: u32, lean: f64, friction: f64) -> Result<Built, Box<dyn Error>> {
    let (sine, cosine) = (libm::sin(lean), libm::cos(lean));
    let mut built = Built::on_the_ground(friction)?;
    // The upper outer edges of a tent are this much above its upper inner ones, which meet.
    let apex = CARD.x * cosine;
    let storey_height = apex + CARD.z * sine + CARD.z;
    for storey in 0..storeys {
        let tents = storeys - storey;
        let base = storey_height * f64::from(storey);
        let place = |tent: u32| SPAN * (f64::from(tent) - 0.5 * f64::from(tents - 1));
        for tent in 0..tents {
            for side in [-1.0, 1.0] {
                // Upwards along the card, and away from the other one.
                let (up, out) = (DVec3::new(-side * sine, 0.0, cosine), DVec3::new(side * cosine, 0.0, sine));
                let meet = DVec3::new(place(tent), 0.0, base + apex);
                let foot = meet - up * CARD.x;
                let name = format!("card {storey} {tent} {}", if side < 0.0 { "left" } else { "right" });
                built.prism(&name, [foot, foot + out * CARD.z, meet + out * CARD.z, meet], CARD.y, DENSITY)?;
            }
        }
        for card in 1..tents {
            let middle = 0.5 * (place(card - 1) + place(card));
            let (low, high) = (base + storey_height - CARD.z, base + storey_height);
            let corner = |x: f64, z: f64| DVec3::new(middle + x * CARD.x, 0.0, z);
            let profile = [corner(-0.5, low), corner(0.5, low), corner(0.5, high), corner(-0.5, high)];
            built.prism(&format!("card {storey} {card} lying"), profile, CARD.y, DENSITY)?;
        }
    }
    Ok(built)
}

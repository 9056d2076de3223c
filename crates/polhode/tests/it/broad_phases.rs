//! The broad phase changes no result: every one gives the same bits, in all tiers, while bricks fall, hit and rest.

use crate::support::{Sides, diamond, run_even_degraded};
use polhode::scene::{BroadPhaseMethod, Method, Tier};
use polhode::{Effects, Outcome};

#[test]
fn every_broad_phase_gives_the_same_bits() {
    for tier in [Tier::Accurate, Tier::Thesis, Tier::Stepped] {
        let with = |broad_phase| {
            let method = Method { tier: Some(tier), broad_phase: Some(broad_phase), ..Method::default() };
            let scene = diamond(5, Sides::Touch).method(method).duration_s(0.2).output_interval_s(0.05);
            let (report, record) = run_even_degraded(&scene.build().unwrap(), Effects::Planned);
            // The tier `thesis` gains more energy here than a run may, whatever the broad phase.
            assert_eq!(report.outcome == Outcome::Degraded, tier == Tier::Thesis, "{tier:?}: {:?}", report.warnings);
            assert_eq!(report.plan.broad_phase, broad_phase);
            (record.samples, record.events, report.ledger, report.certificate)
        };
        let expected = with(BroadPhaseMethod::default());
        for broad_phase in BroadPhaseMethod::ALL {
            assert!(with(broad_phase) == expected, "{broad_phase}, {tier:?}");
        }
    }
}

//! All cases in the order in which they run.

use super::case::{Case, Company};
use super::{
    accuracy_choice, arches, chung_ooi, convergence, convex_pairs, crowds, cube_tosses, curved_bodies, decomposition,
    diamonds, effects, elastic_body, error_estimates, exact_drift, falling_shapes, fast_tier, free_rotation,
    friction_effects, friction_invariances, friction_scenes, frictional_impacts, frictional_statics, heaps, heavy_tops,
    impact_chains, impact_laws, impacts, impacts_every_way, invariances, joints, ledger, long_runs, mass_properties,
    numerical_loss, one_dependency, orders_in_contact, peers, pi_machine, polhode_times, published_rotations,
    random_scenes, random_solids, reductions, rest_every_way, resting_contact, rigid_ipc, rocking_and_toppling,
    rolling_disc, seams, sliding, sliding_and_spinning, sliding_height, slipping_and_rolling, slopes, snapshots, speed,
    spinning_scenes, stability, stackings, stacks, stacks_on_slopes, stiffness_limit, structures, table_edge,
    thesis_forces, thesis_tier, tiers_agree, tunnelling, units, valleys, videos, walls,
};

/// Cases that build.
const BUILD: &[&str] = &["one dependency"];

/// Cases that show what something takes.
const ALONE: &[&str] = &["peers", "speed"];

/// Whether other steps may run beside a case.
pub fn company(name: &str) -> Company {
    if ALONE.contains(&name) {
        Company::Alone
    } else if BUILD.contains(&name) {
        Company::Build
    } else {
        Company::Beside
    }
}

/// One case of each kind, for `--quick`; none of them builds anything.
pub const QUICK: &[&str] = &[
    "MP-10",
    "meshes of primitives",
    "random solids",
    "convex pairs",
    "tunnelling",
    "FR-01",
    "FR-03",
    "exact drift: samples",
    "NESC-2",
    "HT-01",
    "JT-11",
    "IM-01",
    "IM-02",
    "IM-06",
    "IM-08",
    "elastic body",
    "RC-02",
    "RC-05",
    "RC-07",
    "RC-10",
    "falling shapes",
    "diamond-4 for an hour",
    "ledger",
    "energy at e = 1",
    "numerical loss",
    "reductions",
    "CD-03",
    "snapshots",
];

/// All cases, the quick ones first.
pub const ALL: &[Case] = &[
    Case { name: "MP-01", rows: mass_properties::mp_01 },
    Case { name: "MP-02", rows: mass_properties::mp_02 },
    Case { name: "MP-03", rows: mass_properties::mp_03 },
    Case { name: "MP-04", rows: mass_properties::mp_04 },
    Case { name: "MP-05", rows: mass_properties::mp_05 },
    Case { name: "MP-06", rows: mass_properties::mp_06 },
    Case { name: "MP-07", rows: curved_bodies::mp_07 },
    Case { name: "MP-08", rows: curved_bodies::mp_08 },
    Case { name: "MP-09", rows: curved_bodies::mp_09 },
    Case { name: "MP-10", rows: curved_bodies::mp_10 },
    Case { name: "MP-11", rows: curved_bodies::mp_11 },
    Case { name: "MP-12", rows: mass_properties::mp_12 },
    Case { name: "meshes of primitives", rows: curved_bodies::orders },
    Case { name: "mesh decomposition", rows: decomposition::convex_parts },
    Case { name: "moved meshes", rows: random_solids::moved },
    Case { name: "random solids", rows: random_solids::laws },
    Case { name: "convex pairs", rows: convex_pairs::random },
    Case { name: "stackings", rows: stackings::symmetric },
    Case { name: "tunnelling", rows: tunnelling::shots },
    Case { name: "FR-01", rows: free_rotation::fr_01 },
    Case { name: "FR-02", rows: free_rotation::fr_02 },
    Case { name: "FR-03", rows: polhode_times::fr_03 },
    Case { name: "FR-04", rows: free_rotation::fr_04 },
    Case { name: "FR-05", rows: polhode_times::fr_05 },
    Case { name: "FR-06", rows: free_rotation::fr_06 },
    Case { name: "FR-07", rows: free_rotation::fr_07 },
    Case { name: "exact drift: hard cases", rows: exact_drift::hard_cases },
    Case { name: "exact drift: samples", rows: exact_drift::samples },
    Case { name: "NESC-2", rows: published_rotations::tumbling_brick },
    Case { name: "OSRF-boxes", rows: published_rotations::osrf_boxes },
    Case { name: "Orekit", rows: published_rotations::orekit },
    Case { name: "Basilisk", rows: published_rotations::basilisk },
    Case { name: "Bruels-top", rows: published_rotations::bruels_top },
    Case { name: "HT-01", rows: heavy_tops::ht_01 },
    Case { name: "HT-02", rows: heavy_tops::ht_02 },
    Case { name: "HT-03", rows: heavy_tops::ht_03 },
    Case { name: "HT-04", rows: heavy_tops::ht_04 },
    Case { name: "HT-05", rows: heavy_tops::ht_05 },
    Case { name: "JT-01", rows: joints::jt_01 },
    Case { name: "JT-02", rows: joints::jt_02 },
    Case { name: "JT-03", rows: joints::jt_03 },
    Case { name: "JT-04", rows: joints::jt_04 },
    Case { name: "JT-05", rows: joints::jt_05 },
    Case { name: "JT-06", rows: joints::jt_06 },
    Case { name: "JT-07", rows: joints::jt_07 },
    Case { name: "JT-08", rows: joints::jt_08 },
    Case { name: "JT-09", rows: joints::jt_09 },
    Case { name: "JT-11", rows: joints::jt_11 },
    Case { name: "IFToMM A05", rows: joints::iftomm_a05 },
    Case { name: "four-bar linkage", rows: joints::linkage },
    Case { name: "joints of shipped scenes", rows: joints::drift },
    Case { name: "chain with a heavy end", rows: joints::heavy_end },
    Case { name: "convergence", rows: convergence::orders },
    Case { name: "work-precision", rows: convergence::work_precision },
    Case { name: "peers", rows: peers::free_rotation },
    Case { name: "CO-1", rows: chung_ooi::balls_head_on },
    Case { name: "CO-2", rows: chung_ooi::ball_on_a_rigid_plane },
    Case { name: "CO-3", rows: chung_ooi::restitution },
    Case { name: "CO-4", rows: chung_ooi::oblique_at_one_speed },
    Case { name: "CO-5", rows: chung_ooi::oblique_at_one_normal_speed },
    Case { name: "CO-6", rows: chung_ooi::spin_on_a_plane },
    Case { name: "CO-7", rows: chung_ooi::balls_that_spin_against_each_other },
    Case { name: "CO-8", rows: chung_ooi::unequal_balls },
    Case { name: "IM-01", rows: impacts::im_01 },
    Case { name: "IM-02", rows: impact_chains::im_02 },
    Case { name: "IM-03", rows: impact_chains::im_03 },
    Case { name: "IM-04", rows: impact_chains::im_04 },
    Case { name: "impact laws", rows: impact_laws::rows },
    Case { name: "impacts by every way", rows: impacts_every_way::rows },
    Case { name: "IM-05", rows: impacts::im_05 },
    Case { name: "IM-06", rows: pi_machine::im_06 },
    Case { name: "IM-07", rows: frictional_impacts::im_07 },
    Case { name: "IM-08", rows: frictional_impacts::im_08 },
    Case { name: "IM-09", rows: frictional_impacts::im_09 },
    Case { name: "IM-10", rows: frictional_impacts::im_10 },
    Case { name: "IM-12", rows: impacts::im_12 },
    Case { name: "IM-13", rows: impacts::im_13 },
    Case { name: "IM-14", rows: impacts::im_14 },
    Case { name: "frictional impacts", rows: frictional_impacts::energy },
    Case { name: "elastic body", rows: elastic_body::rows },
    Case { name: "RC-02", rows: diamonds::rc_02 },
    Case { name: "RC-03", rows: diamonds::rc_03 },
    Case { name: "RC-05", rows: stacks::rc_05 },
    Case { name: "RC-06", rows: stacks::rc_06 },
    Case { name: "RC-07", rows: resting_contact::rc_07 },
    Case { name: "RC-08", rows: resting_contact::rc_08 },
    Case { name: "RC-09", rows: resting_contact::rc_09 },
    Case { name: "RC-10", rows: table_edge::rc_10 },
    Case { name: "rest by every way", rows: rest_every_way::rows },
    Case { name: "seams", rows: seams::tiles },
    Case { name: "seams: steps", rows: seams::steps },
    Case { name: "seams of other surfaces", rows: seams::surfaces },
    Case { name: "seams with friction", rows: seams::friction },
    Case { name: "FC-01", rows: slopes::fc_01 },
    Case { name: "FC-02", rows: slopes::fc_02 },
    Case { name: "FC-03", rows: sliding::fc_03 },
    Case { name: "FC-04", rows: sliding::fc_04 },
    Case { name: "FC-05", rows: sliding_and_spinning::fc_05 },
    Case { name: "FC-06", rows: sliding_and_spinning::fc_06 },
    Case { name: "FC-07", rows: slipping_and_rolling::fc_07 },
    Case { name: "FC-08", rows: slipping_and_rolling::fc_08 },
    Case { name: "FC-09", rows: frictional_statics::fc_09 },
    Case { name: "FC-10", rows: slipping_and_rolling::fc_10 },
    Case { name: "FC-11", rows: slipping_and_rolling::fc_11 },
    Case { name: "FC-12", rows: rocking_and_toppling::fc_12 },
    Case { name: "FC-13", rows: arches::fc_13 },
    Case { name: "FC-14", rows: frictional_statics::fc_14 },
    Case { name: "FC-15", rows: frictional_statics::fc_15 },
    Case { name: "FC-16", rows: rolling_disc::fc_16 },
    Case { name: "FC-17", rows: rolling_disc::fc_17 },
    Case { name: "FC-18", rows: rocking_and_toppling::fc_18 },
    Case { name: "FC-19", rows: slipping_and_rolling::fc_19 },
    Case { name: "FC-20", rows: sliding::fc_20 },
    Case { name: "FC-21", rows: slopes::fc_21 },
    Case { name: "stacks on slopes", rows: stacks_on_slopes::rows },
    Case { name: "structures: random", rows: structures::random },
    Case { name: "structures: margins", rows: structures::margins },
    Case { name: "stability", rows: stability::rows },
    Case { name: "heaps", rows: heaps::rows },
    Case { name: "error estimates", rows: error_estimates::rows },
    Case { name: "accuracy asked and reached", rows: accuracy_choice::rows },
    Case { name: "structures: arches", rows: structures::arches },
    Case { name: "structures: card houses", rows: structures::card_houses },
    Case { name: "random slopes", rows: slopes::random_slopes },
    Case { name: "slope of 26.565 degrees", rows: slopes::rigid_ipc_slope },
    Case { name: "ten hours on a slope", rows: slopes::ten_hours_on_a_slope },
    Case { name: "friction elsewhere", rows: friction_invariances::settings },
    Case { name: "scenes of friction", rows: friction_scenes::rows },
    Case { name: "scenes of spinning", rows: spinning_scenes::rows },
    Case { name: "walls", rows: walls::rows },
    Case { name: "effects of friction", rows: friction_effects::rows },
    Case { name: "SimBenchmark rolling", rows: slipping_and_rolling::simbenchmark_rolling },
    Case { name: "falling shapes", rows: falling_shapes::times },
    Case { name: "resting shapes", rows: falling_shapes::rest },
    Case { name: "round bodies in valleys", rows: valleys::rows },
    Case { name: "least-force bound", rows: resting_contact::least_force_bound },
    Case { name: "diamonds stand", rows: diamonds::stand },
    Case { name: "diamond-4 for an hour", rows: diamonds::stands_for_an_hour },
    Case { name: "diamond-5 falls", rows: diamonds::falls_symmetrically },
    Case { name: "tier fast", rows: fast_tier::closed_forms },
    Case { name: "orders in contact", rows: orders_in_contact::rows },
    Case { name: "stiffness limit", rows: stiffness_limit::rows },
    Case { name: "sliding does not float", rows: sliding_height::rows },
    Case { name: "tier thesis", rows: thesis_tier::diamonds },
    Case { name: "videos", rows: videos::rows },
    Case { name: "cube tosses", rows: cube_tosses::rows },
    Case { name: "thesis forces", rows: thesis_forces::rows },
    Case { name: "ledger", rows: ledger::shipped_scenes },
    Case { name: "energy at e = 1", rows: ledger::elastic_scenes },
    Case { name: "one dependency", rows: one_dependency::examples },
    Case { name: "numerical loss", rows: numerical_loss::conservative_scenes },
    Case { name: "reductions", rows: reductions::found_where_they_are },
    Case { name: "CD-02", rows: invariances::cd_02 },
    Case { name: "CD-03", rows: invariances::cd_03 },
    Case { name: "CD-04", rows: invariances::cd_04 },
    Case { name: "CD-05", rows: long_runs::cd_05 },
    Case { name: "CD-06", rows: invariances::cd_06 },
    Case { name: "Rigid IPC scenes", rows: rigid_ipc::own },
    Case { name: "Rigid IPC incline", rows: rigid_ipc::incline },
    Case { name: "Rigid IPC suite", rows: rigid_ipc::suite },
    Case { name: "effects", rows: effects::planned_equals_all },
    Case { name: "other units", rows: units::shipped },
    Case { name: "crowds: output intervals", rows: crowds::intervals },
    Case { name: "crowds: samples", rows: crowds::samples },
    Case { name: "crowds: estimated error", rows: crowds::estimates },
    Case { name: "crowds: friction far away", rows: crowds::far_friction },
    Case { name: "tiers agree", rows: tiers_agree::rows },
    Case { name: "random scenes", rows: random_scenes::scenes },
    Case { name: "snapshots", rows: snapshots::continued_runs },
    Case { name: "speed", rows: speed::diamond_4 },
    Case { name: "memory", rows: speed::peak_memory },
];

#[cfg(test)]
mod tests {
    //! `--only` selects by name, so names differ.
    use super::*;

    #[test]
    fn names_differ() {
        let mut names: Vec<&str> = ALL.iter().map(|case| case.name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), ALL.len());
    }

    #[test]
    fn lists_name_cases() {
        for name in ALONE.iter().chain(BUILD).chain(QUICK) {
            assert!(ALL.iter().any(|case| case.name == *name), "{name}");
        }
        assert!(QUICK.iter().all(|name| company(name) == Company::Beside));
    }
}

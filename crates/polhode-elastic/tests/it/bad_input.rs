//! Bad input: every number that is none, every size and ratio out of its range, folded elements and steps beyond the
//! limit are refused with an error that holds the value and the limit; nothing panics.

use crate::rubber;
use polhode_elastic::{
    Cells, DVec2, ElasticBody, ElasticError, ElasticMaterial, ElasticRun, Floor, Guide, NodeStates, QuadMesh,
    RectangleDrop,
};

const NOT_POSITIVE: [f64; 5] = [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

#[test]
fn a_material_has_positive_moduli() {
    for bad in NOT_POSITIVE {
        assert!(matches!(ElasticMaterial::new(bad, 0.3, 1.0), Err(ElasticError::NotPositive { .. })), "{bad}");
        assert!(matches!(ElasticMaterial::new(1.0, 0.3, bad), Err(ElasticError::NotPositive { .. })), "{bad}");
    }
    for bad in [-1.0, 0.5, 0.7, -2.0, f64::NAN, f64::INFINITY] {
        let error = ElasticMaterial::new(1.0, bad, 1.0).unwrap_err();
        assert!(matches!(error, ElasticError::Poisson { .. }), "{bad}");
        assert!(error.to_string().contains("between -1 and 0.5"));
    }
    assert!(ElasticMaterial::new(1e308, 0.499, 1e-308).is_err());
}

#[test]
fn a_rectangle_has_positive_sizes_and_a_drop_a_speed() {
    for bad in NOT_POSITIVE {
        assert!(RectangleDrop::new(bad, 1.0, rubber(), 1.0).is_err(), "{bad}");
        assert!(RectangleDrop::new(1.0, bad, rubber(), 1.0).is_err(), "{bad}");
        assert!(RectangleDrop::new(1.0, 1.0, rubber(), bad).is_err(), "{bad}");
        assert!(RectangleDrop::new(1.0, 1.0, rubber(), 1.0).unwrap().step_s(bad).is_err(), "{bad}");
        assert!(QuadMesh::rectangle(bad, 1.0, Cells { columns: 1, rows: 1 }).is_err(), "{bad}");
    }
    assert!(matches!(RectangleDrop::new(1.0, 60.0, rubber(), 1.0), Err(ElasticError::Slender { .. })));
    assert!(matches!(RectangleDrop::new(1e300, 1e-300, rubber(), 1.0), Err(ElasticError::Slender { .. })));
    for speed in [1e-200, 1e200] {
        let drop = RectangleDrop::new(1.0, 1.0, rubber(), speed).unwrap();
        assert!(drop.run(drop.cells(4)).is_err(), "{speed}");
    }
    for cells in [Cells { columns: 0, rows: 3 }, Cells { columns: 1_000, rows: 1_000 }] {
        assert!(matches!(QuadMesh::rectangle(1.0, 1.0, cells), Err(ElasticError::Elements { .. })));
    }
    assert!(QuadMesh::rectangle(1.0, 1.0, Cells { columns: usize::MAX, rows: usize::MAX }).is_err());
    assert_eq!(Cells::near(2.0, 1.0, 200), Cells { columns: 20, rows: 10 });
    assert_eq!(Cells::near(1.0, 1e-9, 1).count(), 1);
    let drop = RectangleDrop::new(1.0, 1.0, rubber(), 1.0).unwrap();
    assert!(matches!(drop.run(drop.cells(0)), Err(ElasticError::Elements { value: 0, .. })));
}

#[test]
fn a_tilt_is_within_a_right_angle_and_none_when_confined() {
    let drop = RectangleDrop::new(1.0, 1.0, rubber(), 1.0).unwrap();
    for bad in [f64::NAN, f64::INFINITY, 2.0, -1.6] {
        assert!(drop.tilted(bad).is_err(), "{bad}");
    }
    assert!(matches!(drop.tilted(0.1).unwrap().confined(), Err(ElasticError::TiltedAndConfined { .. })));
    assert!(matches!(drop.confined().unwrap().tilted(0.1), Err(ElasticError::TiltedAndConfined { .. })));
}

#[test]
fn folded_elements_are_refused() {
    let nodes = |last: [f64; 2]| [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], last].map(DVec2::from_array).to_vec();
    assert!(QuadMesh::new(nodes([0.0, 1.0]), &[[0, 1, 2, 3]]).is_ok());
    // Clockwise; with a reflex corner; with three corners in a line; crossing itself.
    assert!(matches!(QuadMesh::new(nodes([0.0, 1.0]), &[[0, 3, 2, 1]]), Err(ElasticError::Folded { element: 0, .. })));
    assert!(matches!(QuadMesh::new(nodes([0.9, 0.2]), &[[0, 1, 2, 3]]), Err(ElasticError::Folded { .. })));
    assert!(matches!(QuadMesh::new(nodes([0.5, 0.5]), &[[0, 1, 2, 3]]), Err(ElasticError::Folded { .. })));
    assert!(matches!(QuadMesh::new(nodes([0.0, 1.0]), &[[0, 1, 3, 2]]), Err(ElasticError::Folded { .. })));
    assert!(matches!(QuadMesh::new(nodes([0.0, 1.0]), &[[0, 1, 2, 4]]), Err(ElasticError::NoSuchNode { node: 4, .. })));
    assert!(matches!(QuadMesh::new(nodes([0.0, f64::NAN]), &[[0, 1, 2, 3]]), Err(ElasticError::NotFinite { .. })));
    assert!(matches!(QuadMesh::new(nodes([0.0, 1.0]), &[]), Err(ElasticError::Elements { value: 0, .. })));
}

#[test]
fn a_step_beyond_the_limit_is_refused_with_the_limit() {
    let drop = RectangleDrop::new(2.0, 1.0, rubber(), 1.0).unwrap();
    let limit = drop.start(drop.cells(200)).unwrap().body().longest_step_s();
    assert!(drop.step_s(limit).unwrap().start(drop.cells(200)).is_ok());
    let error = drop.step_s(1.001 * limit).unwrap().run(drop.cells(200)).unwrap_err();
    assert!(matches!(error, ElasticError::StepBeyondLimit { limit_s, .. } if limit_s == limit), "{error}");
}

#[test]
fn a_drop_that_folds_elements_says_which_and_when() {
    // As fast as its own waves.
    let drop = RectangleDrop::new(2.0, 1.0, rubber(), 40.0).unwrap();
    let error = drop.run(drop.cells(200)).unwrap_err();
    assert!(matches!(error, ElasticError::Folds { .. } | ElasticError::Diverged { .. }), "{error}");
    assert!(error.to_string().contains("lower"), "{error}");
}

#[test]
fn states_are_those_of_the_nodes_and_above_the_floor() {
    let mesh = QuadMesh::rectangle(1.0, 1.0, Cells { columns: 2, rows: 2 }).unwrap();
    let body = ElasticBody::new(mesh, rubber(), Guide::Free);
    let step_s = 0.5 * body.longest_step_s();
    let states = NodeStates::moving(&body, DVec2::ZERO);
    let run = |floor: Option<Floor>, states: NodeStates| ElasticRun::new(body.clone(), floor, states, step_s);
    assert!(run(None, states.clone()).is_ok());
    let high = Floor { normal: DVec2::Y, offset: 0.1 };
    assert!(matches!(run(Some(high), states.clone()), Err(ElasticError::BelowFloor { .. })));
    let nowhere = Floor { normal: DVec2::NAN, offset: 0.0 };
    assert!(run(Some(nowhere), states.clone()).is_err());
    let mut short = states.clone();
    short.velocities.pop();
    assert!(matches!(run(None, short), Err(ElasticError::Length { given: 8, nodes: 9, .. })));
    let mut lost = states.clone();
    lost.displacements[3] = DVec2::NAN;
    assert!(matches!(run(None, lost), Err(ElasticError::NotFinite { .. })));
    let mut folded = states;
    folded.displacements[4] = DVec2::new(5.0, 5.0);
    assert!(matches!(run(None, folded), Err(ElasticError::Folds { .. })));
    assert!(body.stresses(&[]).is_err());
}

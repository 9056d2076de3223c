//! The examples of docs/scene-format.md are true.

use crate::scene;
use polhode::dynamics::field::Dependence;
use polhode::scene::Integrator;

const TEXT: &str = include_str!("../../../../docs/scene-format.md");

/// Every block of TOML loads, after `format = 1` and what the block needs has been put around it.
#[test]
fn examples_load() {
    let blocks: Vec<_> = TEXT.split("```toml\n").skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
    assert!(blocks.len() >= 5, "{} blocks", blocks.len());
    for block in blocks {
        let whole = if block.contains("format = 1") { block.to_owned() } else { format!("format = 1\n{block}") };
        scene(&whole);
    }
}

/// Every integrator is described with its order and the forces that it takes, as the engine has them.
#[test]
fn integrators_are_described() {
    for integrator in Integrator::ALL {
        let row = TEXT.lines().find(|line| line.starts_with(&format!("| `{integrator}`"))).unwrap();
        let cells: Vec<_> = row.split('|').map(str::trim).collect();
        let takes = if integrator.takes(Dependence::Velocities) { "yes" } else { "no" };
        assert_eq!(cells[3], takes, "{row}");
        let order = cells[2].strip_prefix("exact without forces, else ").unwrap_or(cells[2]).split([' ', ',']).next();
        assert_eq!(order, Some(integrator.order().to_string().as_str()), "{row}");
    }
}

/// Every key of the schema is described.
#[test]
fn every_key_is_described() {
    let schema = polhode_scene::schema();
    let mut tables = vec![&schema];
    tables.extend(schema["$defs"].as_object().unwrap().values());
    for table in tables {
        for key in table["properties"].as_object().into_iter().flat_map(|properties| properties.keys()) {
            assert!(TEXT.contains(&format!("`{key}`")), "{key} is not described");
        }
    }
}

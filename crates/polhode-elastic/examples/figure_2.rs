//! The rectangle of the thesis's Figure 2: what it bounces with, mesh by mesh and in the limit.

use polhode_elastic::{DropStudy, ElasticError, ElasticMaterial, Quantity, RectangleDrop};

fn main() -> Result<(), ElasticError> {
    let rubber = ElasticMaterial::new(1e6, 0.3, 1000.0)?;
    let drop = RectangleDrop::new(2.0, 1.0, rubber, 1.0)?;
    let study = DropStudy::of(&drop, drop.cells(50))?;
    for drops in &study.meshes {
        println!("{} elements: restitution {}", drops.cells.count(), drops.mean(Quantity::Restitution).value);
    }
    let limit = study.limit(Quantity::Restitution)?;
    println!("in the limit {} +- {}", limit.value, limit.error);
    Ok(())
}

//! What polhode-elastic promises: the statics and waves of elastic matter, conservation, the closed form of the
//! confined bar, errors for bad input, and the same bits everywhere.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

mod bad_input;
mod conservation;
mod drops;
mod patches;
mod vibrations;
mod waves;

use polhode_elastic::ElasticMaterial;

/// Soft rubber that keeps none of its volume to itself.
fn rubber() -> ElasticMaterial {
    ElasticMaterial::new(1e6, 0.3, 1000.0).unwrap()
}

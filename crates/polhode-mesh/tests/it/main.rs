//! What polhode-mesh promises: exact mass properties, a diagnosis that is right, readers that never fail silently.

#![allow(
    clippy::unwrap_used,
    clippy::unreadable_literal,
    reason = "a test that cannot go on fails; reference values are copied digit by digit"
)]

mod bad_files;
mod convex_hull;
mod convexity;
mod decomposition;
mod diagnosis;
mod estimates;
mod exact_values;
mod formats;
mod invariance;
mod obj;
mod obj_errors;
mod point_location;
mod polygons;
mod primitives;
mod real_meshes;
mod repair;
mod shapes;

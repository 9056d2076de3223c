//! Two shapes without parts.

pub mod convex_method;

//! Convex parts of a solid.

use crate::failure::Failure;
use crate::mesh_args::MeshStudyArgs;
use crate::text::{Table, number};
use polhode::contact::{ApproximateDecomposition, ApproximateSettings, approximate_decomposition};
use polhode::mesh::{ConvexSolid, Decomposition, DecompositionSettings, SolidMesh, TriangleMesh, convex_decomposition};
use serde_json::{Value, json};

/// The parts, and how they were found.
pub(super) enum Parts {
    /// Along planes: the parts fill the solid.
    Exact(Decomposition),
    /// By V-HACD: the parts cover it nearly.
    Approximate(ApproximateDecomposition),
}

impl Parts {
    /// Those asked for, if any.
    pub(super) fn of(args: &MeshStudyArgs, mesh: &TriangleMesh) -> Result<Option<Self>, Failure> {
        if !args.decompose && !args.approximate {
            return Ok(None);
        }
        let solid = SolidMesh::new(mesh.clone())?;
        let failed = |error: &dyn std::fmt::Display| Failure::Check(format!("error: {error}"));
        Ok(Some(if args.approximate {
            let settings = ApproximateSettings::default();
            let approximate = approximate_decomposition(&solid, settings).map_err(|error| failed(&error))?;
            // Parts that fill the solid are better than as many or more that do not; more are not looked for.
            let max_parts = approximate.parts.len().max(1);
            let settings = DecompositionSettings { max_parts, ..DecompositionSettings::default() };
            match convex_decomposition(&solid, settings) {
                Ok(exact) if exact.unresolved == 0 && exact.parts.len() <= approximate.parts.len() => {
                    Self::Exact(exact)
                }
                _ => Self::Approximate(approximate),
            }
        } else {
            let settings = DecompositionSettings::default();
            Self::Exact(convex_decomposition(&solid, settings).map_err(|error| failed(&error))?)
        }))
    }

    fn solids(&self) -> &[ConvexSolid] {
        match self {
            Self::Exact(found) => &found.parts,
            Self::Approximate(found) => &found.parts,
        }
    }

    /// Their meshes.
    pub(super) fn meshes(&self) -> impl Iterator<Item = &TriangleMesh> {
        self.solids().iter().map(ConvexSolid::mesh)
    }

    /// Name of the way, volume of the parts together, its relative error, and what else is known: name and count.
    fn facts(&self) -> (&'static str, [f64; 2], Vec<(&'static str, usize)>) {
        match self {
            Self::Exact(found) => (
                "exact",
                [found.volume, found.volume_error],
                vec![
                    ("reflex_edges", found.reflex_edges),
                    ("cuts", found.cuts),
                    ("flat_parts", found.flat_parts),
                    ("unresolved", found.unresolved),
                ],
            ),
            Self::Approximate(found) => {
                ("approximate", [found.volume, found.volume_error], vec![("flat_parts", found.flat_parts)])
            }
        }
    }

    /// As JSON.
    pub(super) fn to_json(&self) -> Value {
        let (way, [volume_m3, volume_error], counts) = self.facts();
        let part = |solid: &ConvexSolid| {
            json!({
                "vertices": solid.mesh().vertices().len(),
                "triangles": solid.mesh().triangles().len(),
                "volume_m3": solid.volume_integrals().volume,
            })
        };
        let mut value = json!({
            "way": way,
            "volume_m3": volume_m3,
            "volume_error": volume_error,
            "parts": self.solids().iter().map(part).collect::<Vec<_>>(),
        });
        for (name, count) in counts {
            value[name] = count.into();
        }
        value
    }

    /// For people.
    pub(super) fn text(&self) -> String {
        let (way, [volume, error], counts) = self.facts();
        let mut table = Table::default();
        table.row(["parts", &self.solids().len().to_string()]);
        table.row(["volume of all", &format!("{} m^3", number(volume))]);
        table.row(["its error, relative", &number(error)]);
        for (name, count) in &counts {
            table.row([&name.replace('_', " "), &count.to_string()]);
        }
        let mut page = format!("\nconvex parts, {way}\n{}", table.print());
        match self {
            Self::Exact(found) if found.unresolved > 0 => page.push_str(
                "note: pieces that no plane could part are replaced by their hulls: the surface crosses itself\n",
            ),
            Self::Exact(_) => {
                page.push_str("note: a surface that crosses itself is not looked for; its parts would overlap\n");
            }
            Self::Approximate(_) => {
                page.push_str("note: how much the parts overlap is not measured; voids are filled\n");
            }
        }
        page
    }
}

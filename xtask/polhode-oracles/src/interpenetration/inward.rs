//! The ways on which the corners of a solid go inwards: all triangles at a corner recede as much as they can together.
//!
//! For unit normals `n_i` of the triangles at a corner it is the unit vector `d` with the largest `min (-n_i . d)`,
//! which points to the place of the convex hull of the `-n_i` that is nearest to the origin; Gilbert's iteration
//! (docs/REFERENCES.md, Gilbert 1966) comes near to it, and near is enough: any direction proves what it parts. Where
//! no direction leads below all triangles, the corner stays.

use glam::DVec3;

/// Steps of the iteration, which comes near as one over their number.
const STEPS: usize = 300;

/// A direction along which a triangle recedes by less than this part of the way is none.
const LEAST: f64 = 1e-3;

/// For each vertex of a closed surface that is turned outward; zero where there is none.
pub(super) fn directions(vertices: &[DVec3], triangles: &[[usize; 3]]) -> Vec<DVec3> {
    let mut normals: Vec<Vec<DVec3>> = vec![Vec::new(); vertices.len()];
    for &[a, b, c] in triangles {
        let inward = (vertices[c] - vertices[a]).cross(vertices[b] - vertices[a]);
        if let Some(inward) = inward.try_normalize() {
            for v in [a, b, c] {
                normals[v].push(inward);
            }
        }
    }
    normals.iter().map(|normals| direction(normals)).collect()
}

fn direction(inward: &[DVec3]) -> DVec3 {
    let Some(mut nearest) = inward.first().copied() else { return DVec3::ZERO };
    for _ in 0..STEPS {
        let along = |n: &&DVec3| nearest.dot(**n);
        let Some(&least) = inward.iter().min_by(|m, n| along(m).total_cmp(&along(n))) else { break };
        let step = least - nearest;
        let part = -nearest.dot(step) / step.length_squared();
        if part.is_nan() || part <= 0.0 {
            break;
        }
        nearest += part.min(1.0) * step;
    }
    let direction = nearest.normalize_or_zero();
    if inward.iter().all(|n| n.dot(direction) > LEAST) { direction } else { DVec3::ZERO }
}

#[cfg(test)]
mod tests {
    //! Corners of a cube and of an edge, and one that cannot recede.
    use super::*;

    #[test]
    fn a_corner_of_a_cube_goes_along_its_diagonal() {
        let found = direction(&[DVec3::X, DVec3::Y, DVec3::Z, DVec3::Z]);
        assert!(found.distance(DVec3::ONE.normalize()) < 1e-2, "{found}");
        assert_eq!(direction(&[DVec3::Y, DVec3::Y]), DVec3::Y);
        assert_eq!(direction(&[DVec3::X, DVec3::NEG_X]), DVec3::ZERO);
    }
}

//! The number of pairs of bodies that may collide, their largest restitution and friction, and whether friction of each
//! has one grain at most, without a loop over all pairs.
//!
//! Bodies form a class when they have the same material and the same `no_contact` groups and are all fixed or all
//! movable. The number of pairs of two materials is the product of the numbers of their bodies, less the pairs of two
//! bodies that no force moves, less the pairs that share a group.

use super::grain::{Grain, GrainOf};
use super::{Material, PairRule, Scene, SceneError};
use std::collections::{BTreeMap, BTreeSet};

/// The pairs of bodies that may collide.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct CollidingPairs {
    /// How many there are.
    pub(crate) count: usize,
    /// Largest coefficient of restitution of a pair; zero if there is no pair.
    pub(crate) largest_restitution: f64,
    /// Largest coefficient of static friction of a pair; zero if there is no pair.
    pub(crate) largest_friction: f64,
    /// Largest friction of rolling or spinning of a pair, m; zero if there is no pair.
    pub(crate) largest_rotational_friction: f64,
}

/// What decides whether a body with a shape may collide with another one, and with which restitution.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Class {
    material: usize,
    is_fixed: bool,
    groups: Vec<usize>,
}

impl CollidingPairs {
    /// Whether a pair has friction of any kind.
    pub(crate) fn have_friction(&self) -> bool {
        self.largest_friction > 0.0 || self.largest_rotational_friction > 0.0
    }
}

impl Scene {
    /// For every two materials of which bodies may collide: two such bodies, and
    /// how many pairs of them there are. Takes `O(n log n)` for n bodies of a few materials.
    fn counted_material_pairs(&self) -> Vec<((usize, usize), usize)> {
        let mut materials: BTreeMap<(&str, [u64; 17]), (usize, usize)> = BTreeMap::new();
        let mut groups_of: Vec<Vec<usize>> = vec![Vec::new(); self.bodies.len()];
        for (group, members) in self.no_contact.iter().enumerate() {
            for &body in members {
                let known = groups_of.get_mut(body).filter(|groups| groups.last() != Some(&group));
                if let Some(groups) = known {
                    groups.push(group);
                }
            }
        }
        let mut classes: BTreeMap<Class, usize> = BTreeMap::new();
        let mut material_of: BTreeMap<usize, usize> = BTreeMap::new();
        let joined = self.joined_pairs(&groups_of);
        for (body, groups) in
            groups_of.into_iter().enumerate().filter(|&(body, _)| self.bodies[body].geometry.is_some())
        {
            let own = &self.bodies[body].material;
            let number = materials.len();
            let key = (own.name(), numbers_of(own).map(f64::to_bits));
            let (material, _) = *materials.entry(key).or_insert((number, body));
            material_of.insert(body, material);
            let class = Class { material, is_fixed: self.bodies[body].is_fixed(), groups };
            *classes.entry(class).or_default() += 1;
        }
        let mut examples: Vec<(usize, usize)> = materials.into_values().collect();
        examples.sort_unstable();
        let classes: Vec<(Class, usize)> = classes.into_iter().collect();
        let mut allowed = all_pairs(&classes, examples.len());
        for (pair, excluded) in pairs_in_groups(&classes) {
            if let Some(allowed) = allowed.get_mut(&pair) {
                *allowed -= excluded;
            }
        }
        for (a, b) in joined {
            let Some((&x, &y)) = material_of.get(&a).zip(material_of.get(&b)) else { continue };
            if let Some(allowed) = allowed.get_mut(&(x.min(y), x.max(y))) {
                *allowed = allowed.saturating_sub(1);
            }
        }
        let allowed = allowed.into_iter().filter(|&(_, count)| count > 0);
        allowed.map(|((x, y), count)| ((examples[x].1, examples[y].1), count)).collect()
    }

    /// The pairs of bodies that joints alone keep from colliding, each once.
    fn joined_pairs(&self, groups_of: &[Vec<usize>]) -> BTreeSet<(usize, usize)> {
        let pairs = self.joints.iter().filter_map(|joint| {
            let (a, b) = (joint.body().index(), joint.other()?.index());
            Some((a.min(b), a.max(b)))
        });
        // One at least of the bodies of a joint moves.
        let share_no_group = |&(a, b): &(usize, usize)| !groups_of[a].iter().any(|group| groups_of[b].contains(group));
        pairs.filter(share_no_group).collect()
    }

    /// Two bodies of every two materials of which bodies may collide.
    pub(super) fn material_pairs(&self) -> Vec<(usize, usize)> {
        self.counted_material_pairs().into_iter().map(|(pair, _)| pair).collect()
    }

    /// Checks that every contact has one grain at most.
    ///
    /// # Errors
    /// When two materials that may meet both have a grain, or a rule for them asks for one that neither has.
    pub(crate) fn check_grains(&self) -> Result<(), SceneError> {
        let names = |a: usize, b: usize| [a, b].map(|body| self.bodies[body].material.name().to_owned());
        for (a, b) in self.material_pairs() {
            let material = self.pair_material(a, b);
            match material.grain() {
                Some(Grain { of: GrainOf::Both, .. }) => return Err(SceneError::TwoGrains { materials: names(a, b) }),
                None if !material.is_isotropic() => return Err(SceneError::NoGrain { materials: names(a, b) }),
                _ => {}
            }
        }
        Ok(())
    }

    /// What surfaces of bodies that may collide do besides friction with one coefficient; none where they do no more.
    pub(crate) fn surface_effect(&self) -> Option<&'static str> {
        if self.has_grain() {
            return Some("friction along a grain");
        }
        if self.colliding().largest_rotational_friction > 0.0 {
            return Some("friction of rolling or spinning");
        }
        if self.has_moving_surfaces() {
            return Some("a surface that moves");
        }
        let has_static = |(a, b): (usize, usize)| {
            let material = self.pair_material(a, b);
            material.static_friction() > material.friction()
        };
        self.material_pairs().into_iter().any(has_static).then_some("static friction above kinetic")
    }

    /// Whether friction of two bodies that may collide depends on the direction.
    pub(crate) fn has_grain(&self) -> bool {
        let has_grain = |material: &Material| material.grain().is_some();
        let is_used =
            self.bodies.iter().any(|body| has_grain(&body.material)) || self.pair_rules.iter().any(PairRule::has_grain);
        is_used && self.material_pairs().into_iter().any(|(a, b)| has_grain(&self.pair_material(a, b)))
    }

    /// Counts the pairs of bodies that may collide, in `O(n log n)` for n bodies of a few materials.
    pub(crate) fn colliding(&self) -> CollidingPairs {
        let mut found = CollidingPairs::default();
        for ((a, b), count) in self.counted_material_pairs() {
            found.count += count;
            let material = self.pair_material(a, b);
            found.largest_restitution = found.largest_restitution.max(material.restitution());
            found.largest_friction = found.largest_friction.max(material.static_ellipse().largest());
            let rotational = material.rolling_friction().max(material.spinning_friction());
            found.largest_rotational_friction = found.largest_rotational_friction.max(rotational);
        }
        found
    }
}

/// All numbers of a material.
fn numbers_of(material: &Material) -> [f64; 17] {
    let (kinetic, at_rest) = (material.friction_ellipse(), material.static_ellipse());
    // A direction has length one: zero stands for none.
    let grain = material.grain_direction().unwrap_or_default();
    let [slow, limit, slope, slow_2, limit_2, slope_2] = material.restitution_numbers();
    let [young, poisson] = material.elastic_constants().unwrap_or_default();
    [
        slow,
        limit,
        slope,
        slow_2,
        limit_2,
        slope_2,
        kinetic.along,
        kinetic.across,
        at_rest.along,
        at_rest.across,
        material.rolling_friction(),
        material.spinning_friction(),
        grain.x,
        grain.y,
        grain.z,
        young,
        poisson,
    ]
}

/// For every two materials (the smaller index first) the number of pairs of which forces move at least one body.
fn all_pairs(classes: &[(Class, usize)], materials: usize) -> BTreeMap<(usize, usize), usize> {
    let (mut all, mut fixed) = (vec![0; materials], vec![0; materials]);
    for (class, count) in classes {
        all[class.material] += count;
        fixed[class.material] += if class.is_fixed { *count } else { 0 };
    }
    let mut pairs = BTreeMap::new();
    for x in 0..materials {
        pairs.insert((x, x), among(all[x]) - among(fixed[x]));
        for y in x + 1..materials {
            pairs.insert((x, y), all[x] * all[y] - fixed[x] * fixed[y]);
        }
    }
    pairs
}

/// Pairs that share a group and of which forces move at least one body: the materials of each two classes, and how many
/// pairs they have.
fn pairs_in_groups(classes: &[(Class, usize)]) -> Vec<((usize, usize), usize)> {
    let mut members: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (number, (class, _)) in classes.iter().enumerate() {
        for &group in &class.groups {
            members.entry(group).or_default().push(number);
        }
    }
    let sharing: BTreeSet<(usize, usize)> = members
        .values()
        .flat_map(|members| members.iter().enumerate().flat_map(|(k, &i)| members[k..].iter().map(move |&j| (i, j))))
        .collect();
    let excluded = |(i, j): (usize, usize)| {
        let ((one, count), (other, others)) = (&classes[i], &classes[j]);
        let materials = (one.material.min(other.material), one.material.max(other.material));
        let pairs = if i == j { among(*count) } else { count * others };
        (!(one.is_fixed && other.is_fixed)).then_some((materials, pairs))
    };
    sharing.into_iter().filter_map(excluded).collect()
}

/// Number of pairs of `count` bodies.
const fn among(count: usize) -> usize {
    count * count.saturating_sub(1) / 2
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
mod tests {
    use crate::identity::body_id::BodyId;
    use crate::scene::{Body, Scene};
    use crate::scene::{Material, PairRule};
    use polhode_contact::Shape;
    use polhode_mesh::primitives::solid_box;
    use polhode_spatial::{DVec3, Mass, SplitMix64};

    /// For scenes of all kinds of bodies, materials, rules and groups, the count and the restitution are those of a
    /// loop over all pairs.
    #[test]
    fn counts_are_those_of_a_loop_over_all_pairs() {
        let mut numbers = SplitMix64::new(7);
        let mut random = |below: usize| numbers.bits() as usize % below;
        for _ in 0..200 {
            let count = 1 + random(12);
            let mut builder = Scene::builder("pairs");
            for body in 0..count {
                let name = format!("b{body}");
                let properties = solid_box(DVec3::ONE, Mass::new(1.0).unwrap()).unwrap();
                let own = if random(3) == 0 { Body::fixed(name) } else { Body::movable(name, properties) };
                let kind = random(3);
                let material = Material::new(format!("m{kind}")).with_restitution(0.25 * kind as f64).unwrap();
                let own = own.material(material);
                let shape = Shape::cuboid(DVec3::ONE).unwrap();
                builder = builder.body(if random(5) == 0 { own } else { own.geometry(shape.into()) });
            }
            for _ in 0..random(4) {
                let members: Vec<_> = (0..random(5)).map(|_| BodyId::new(random(count))).collect();
                builder = builder.no_contact(members);
            }
            let rule = PairRule::new(["m1".to_owned(), "m2".to_owned()]).with_restitution(0.9).unwrap();
            let scene = builder.pair_rule(rule).build().unwrap();
            let pairs = (0..count).flat_map(|a| (a + 1..count).map(move |b| (a, b)));
            let pairs: Vec<_> = pairs.filter(|&(a, b)| scene.may_collide(a, b)).collect();
            let restitution = |&(a, b): &(usize, usize)| scene.pair_material(a, b).restitution();
            let found = scene.colliding();
            assert_eq!(found.count, pairs.len());
            assert_eq!(found.largest_restitution, pairs.iter().map(restitution).fold(0.0, f64::max));
            assert_eq!(scene.any_may_collide(), !pairs.is_empty());
        }
    }
}

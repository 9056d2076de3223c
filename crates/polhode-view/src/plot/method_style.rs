//! How methods are drawn: one ink for a family, one marker for each of its members.

use super::ink::Ink;
use super::marker::Marker;

/// How the curve of a method is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Style {
    /// The ink of its family.
    pub ink: Ink,
    /// Its marker.
    pub marker: Marker,
}

/// Methods that are alike.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Family {
    /// What they are.
    pub name: &'static str,
    /// Their ink.
    pub ink: Ink,
    /// Their names in scene files.
    pub members: &'static [&'static str],
}

/// The families of integrators, and the tiers, of which each is one.
pub const FAMILIES: [Family; 11] = [
    Family {
        name: "Euler",
        ink: Ink::Grey,
        members: &["explicit-euler", "semi-implicit-euler", "implicit-gyroscopic"],
    },
    Family { name: "Runge-Kutta", ink: Ink::Blue, members: &["rk4", "rkmk4", "cf4", "dop853"] },
    Family { name: "splitting", ink: Ink::Vermilion, members: &["splitting", "splitting-4", "splitting-6"] },
    Family {
        name: "variational",
        ink: Ink::Purple,
        members: &["moser-veselov", "moser-veselov-4", "implicit-midpoint"],
    },
    Family { name: "exact rotation", ink: Ink::Green, members: &["exact", "exact-strang", "exact-adaptive"] },
    Family { name: "tier accurate", ink: Ink::Green, members: &["accurate"] },
    Family { name: "tier stepped", ink: Ink::Vermilion, members: &["stepped"] },
    Family { name: "tier thesis", ink: Ink::Blue, members: &["thesis"] },
    Family { name: "tier fast", ink: Ink::Gold, members: &["fast"] },
    Family { name: "tier penalty", ink: Ink::Purple, members: &["penalty"] },
    Family { name: "tier micro-collisions", ink: Ink::Grey, members: &["micro-collisions"] },
];

/// The family of a method, or of settings in words of which one names it.
pub fn family(name: &str) -> Option<&'static Family> {
    let words = || name.split_whitespace();
    FAMILIES.iter().find(|family| words().any(|word| family.members.contains(&word)))
}

/// Styles of the methods of one figure. A name that is no method's is a family of its own; members of a family
/// that differ in other settings take the markers that are left.
pub fn styles(names: &[&str]) -> Vec<Style> {
    let mut styles: Vec<Style> = Vec::with_capacity(names.len());
    let mut others = Ink::CURVES.into_iter().filter(|ink| !names.iter().any(|name| ink_of(name) == Some(*ink))).cycle();
    for (number, name) in names.iter().enumerate() {
        let known = family(name);
        let ink = known.map(|family| family.ink).or_else(|| others.next()).unwrap_or_else(|| Ink::of_curve(number));
        let own = known.and_then(|family| family.members.iter().position(|member| member == name));
        let is_taken = |marker: Marker| {
            let fixed = names.iter().any(|other| fixed(other) == Some((ink, marker)));
            fixed || styles.contains(&Style { ink, marker })
        };
        let free = || Marker::ALL.into_iter().find(|marker| !is_taken(*marker));
        let marker = own.map(|member| Marker::ALL[member % Marker::ALL.len()]).or_else(free);
        styles.push(Style { ink, marker: marker.unwrap_or(Marker::ALL[number % Marker::ALL.len()]) });
    }
    styles
}

fn ink_of(name: &str) -> Option<Ink> {
    family(name).map(|family| family.ink)
}

/// The ink and the marker that a method always has.
fn fixed(name: &str) -> Option<(Ink, Marker)> {
    let family = family(name)?;
    let member = family.members.iter().position(|member| *member == name)?;
    Some((family.ink, Marker::ALL[member % Marker::ALL.len()]))
}

#[cfg(test)]
mod tests {
    //! Every method has a family, and no two curves look the same.
    use super::*;
    use polhode::scene::{Integrator, Tier};

    #[test]
    fn every_integrator_and_every_tier_has_a_style_of_its_own() {
        let names: Vec<&str> = Integrator::ALL.into_iter().map(Integrator::name).collect();
        assert!(names.iter().all(|name| family(name).is_some()), "{names:?}");
        assert_distinct(&names);
        let tiers: Vec<&str> = Tier::ALL.into_iter().map(Tier::name).collect();
        assert!(tiers.iter().all(|name| family(name).is_some()), "{tiers:?}");
        assert_distinct(&tiers);
    }

    #[test]
    fn settings_of_one_method_share_its_ink() {
        let names = ["rk4 matrix", "rk4", "rk4 quaternion", "steel", "ice", "cf4"];
        let all = styles(&names);
        assert_eq!([all[0].ink, all[2].ink, all[5].ink], [Ink::Blue; 3]);
        assert_eq!(all[1].marker, Marker::Disc);
        assert!(all[3].ink != Ink::Blue && all[3].ink != all[4].ink);
        assert_distinct(&names);
    }

    fn assert_distinct(names: &[&str]) {
        let all = styles(names);
        for (number, style) in all.iter().enumerate() {
            assert!(!all[..number].contains(style), "{} looks like another of {names:?}", names[number]);
        }
    }
}

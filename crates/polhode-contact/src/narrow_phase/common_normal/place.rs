//! A common normal of two elements, with its point on each of them.

use crate::narrow_phase::feature::element::Element;
use glam::DVec3;

/// A common normal of two elements.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    /// Unit vector from B to A; for two curves without a ball its sign is arbitrary.
    pub(crate) normal: DVec3,
    /// Points of the two loci, m.
    pub(crate) on_a: DVec3,
    pub(crate) on_b: DVec3,
}

impl Place {
    /// Signed separation, m.
    pub(crate) fn separation(&self, a: &Element<'_>, b: &Element<'_>) -> f64 {
        self.normal.dot(self.on_a - self.on_b) - a.radius_at(self.on_a) - b.radius_at(self.on_b)
    }

    pub(crate) fn reversed(self) -> Self {
        Self { normal: -self.normal, ..self }
    }

    pub(crate) fn swapped(self) -> Self {
        Self { normal: -self.normal, on_a: self.on_b, on_b: self.on_a }
    }
}

/// At most [`Places::MOST`] common normals.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Places {
    items: [Place; Self::MOST],
    count: usize,
}

impl Places {
    /// As many as `minima.rs` reports; other pairs of elements have at most two.
    pub(super) const MOST: usize = 8;

    pub(crate) const fn none() -> Self {
        let empty = Place { normal: DVec3::ZERO, on_a: DVec3::ZERO, on_b: DVec3::ZERO };
        Self { items: [empty; Self::MOST], count: 0 }
    }

    /// Adds a common normal; one that is not finite or zero is ignored.
    pub(crate) fn push(&mut self, place: Place) {
        if self.count < Self::MOST && place.normal.is_finite() && place.normal != DVec3::ZERO {
            self.items[self.count] = place;
            self.count += 1;
        }
    }

    pub(crate) fn one(place: Option<Place>) -> Self {
        let mut places = Self::none();
        if let Some(place) = place {
            places.push(place);
        }
        places
    }

    pub(crate) fn swapped(mut self) -> Self {
        self.items[..self.count].iter_mut().for_each(|place| *place = place.swapped());
        self
    }
}

impl std::ops::Deref for Places {
    type Target = [Place];
    fn deref(&self) -> &[Place] {
        &self.items[..self.count]
    }
}

//! Labels under each other, each as near as can be to what it names, none over another.
//!
//! The places are those of least sum of squared distances under the condition that neighbours are a row apart: isotonic
//! regression by pooling (Barlow et al. 1972), exact and in one pass.

/// Labels that share a stretch without gaps.
struct Pool {
    /// Sum of the places that its labels want the first of them to have.
    sum: f64,
    count: usize,
}

impl Pool {
    fn first(&self) -> f64 {
        self.sum / self.count as f64
    }
}

/// Places of the middles of labels of height `row` that want to be at `wanted`, within `low` to `high`; in the order of
/// `wanted`. Labels that want the same place keep their order. Where there is no room for all, they go on beyond
/// `high`. What is not a number wants to be at `high`.
pub fn label_rows(wanted: &[f64], row: f64, [low, high]: [f64; 2]) -> Vec<f64> {
    let clean = |place: f64| if place.is_nan() { high } else { place.clamp(low, high.max(low)) };
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|&a, &b| clean(wanted[a]).total_cmp(&clean(wanted[b])));
    let mut pools: Vec<Pool> = Vec::new();
    for (before, &label) in order.iter().enumerate() {
        // Measured from the place that it would have if all labels before it stood without gaps.
        let mut pool = Pool { sum: clean(wanted[label]) - row * before as f64, count: 1 };
        while let Some(last) = pools.last() {
            if last.first() < pool.first() {
                break;
            }
            pool = Pool { sum: last.sum + pool.sum, count: last.count + pool.count };
            pools.pop();
        }
        pools.push(pool);
    }
    let latest = high - 0.5 * row - row * wanted.len().saturating_sub(1) as f64;
    let earliest = low + 0.5 * row;
    let mut places = vec![0.0; wanted.len()];
    let mut number = 0;
    for pool in pools {
        let first = pool.first().min(latest).max(earliest);
        for _ in 0..pool.count {
            places[order[number]] = first + row * number as f64;
            number += 1;
        }
    }
    places
}

#[cfg(test)]
mod tests {
    //! Labels do not overlap, stay within the bounds if these suffice, and are not moved without need.
    use super::*;
    use proptest::prelude::*;

    /// Rounding of sums of a few hundred pixels.
    const ROUNDING: f64 = 1e-9;

    #[test]
    fn labels_that_are_apart_are_not_moved() {
        assert_eq!(label_rows(&[50.0, 20.0], 10.0, [0.0, 100.0]), [50.0, 20.0]);
        assert_eq!(label_rows(&[], 10.0, [0.0, 100.0]), [] as [f64; 0]);
    }

    #[test]
    fn labels_of_one_place_are_around_it() {
        assert_eq!(label_rows(&[50.0, 50.0, 50.0], 10.0, [0.0, 100.0]), [40.0, 50.0, 60.0]);
        assert_eq!(label_rows(&[0.0, 0.0], 10.0, [0.0, 100.0]), [5.0, 15.0]);
        assert_eq!(label_rows(&[100.0, 100.0], 10.0, [0.0, 100.0]), [85.0, 95.0]);
    }

    proptest! {
        #[test]
        fn none_overlap(
            wanted in prop::collection::vec(prop_oneof![
                9 => -50.0..450.0_f64,
                1 => prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, 0.0, 200.0]),
            ], 0..40),
            row in 1.0..20.0_f64,
        ) {
            let mut places = label_rows(&wanted, row, [0.0, 400.0]);
            prop_assert_eq!(places.len(), wanted.len());
            places.sort_by(f64::total_cmp);
            for pair in places.windows(2) {
                prop_assert!(pair[1] - pair[0] >= row - ROUNDING, "{:?}", places);
            }
            if row * wanted.len() as f64 <= 400.0 {
                prop_assert!(places.iter().all(|place| (-ROUNDING..=400.0 + ROUNDING).contains(place)), "{:?}", places);
            }
        }
    }
}

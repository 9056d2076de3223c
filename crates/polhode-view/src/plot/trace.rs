//! A quantity over time, kept in bounded memory.
//!
//! Values that follow each other share a bucket, which keeps the first, the least, the greatest and the last of them.
//! When there are too many buckets, neighbours are joined. So a curve of a million samples is drawn with every peak
//! that it has, from some thousand places; one of fewer samples than `MOST_BUCKETS` is kept whole.

/// Buckets at the most: more than a figure has pixels across.
const MOST_BUCKETS: usize = 1024;

/// A value at a time, s.
pub type Sample = [f64; 2];

/// Values that follow each other.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Bucket {
    first: Sample,
    least: Sample,
    greatest: Sample,
    last: Sample,
}

/// A quantity over time.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    buckets: Vec<Bucket>,
    /// Samples in a full bucket.
    share: usize,
    /// Samples in the last bucket.
    filled: usize,
}

impl Default for Trace {
    fn default() -> Self {
        Self { buckets: Vec::new(), share: 1, filled: 0 }
    }
}

impl Trace {
    /// Of samples.
    pub fn of(samples: impl IntoIterator<Item = Sample>) -> Self {
        let mut trace = Self::default();
        for [t_s, value] in samples {
            trace.push(t_s, value);
        }
        trace
    }

    /// Of samples in their order, all of them, whatever their times.
    pub fn whole(samples: impl IntoIterator<Item = Sample>) -> Self {
        let bucket = |sample| Bucket { first: sample, least: sample, greatest: sample, last: sample };
        let buckets: Vec<Bucket> = samples.into_iter().map(bucket).collect();
        Self { filled: usize::from(!buckets.is_empty()), buckets, share: 1 }
    }

    /// Adds a value at a time (s) after the one before.
    pub fn push(&mut self, t_s: f64, value: f64) {
        let sample = [t_s, value];
        let single = Bucket { first: sample, least: sample, greatest: sample, last: sample };
        match self.buckets.last_mut() {
            Some(bucket) if self.filled < self.share => {
                *bucket = bucket.joined(single);
                self.filled += 1;
            }
            _ => {
                if self.buckets.len() >= MOST_BUCKETS {
                    self.halve();
                }
                self.buckets.push(single);
                self.filled = 1;
            }
        }
    }

    fn halve(&mut self) {
        let joined = |pair: &[Bucket]| pair[1..].iter().fold(pair[0], |a, b| a.joined(*b));
        self.buckets = self.buckets.chunks(2).map(joined).collect();
        self.share *= 2;
    }

    /// The samples that are kept, in order of time.
    pub fn samples(&self) -> impl Iterator<Item = Sample> + Clone + '_ {
        self.buckets.iter().flat_map(|bucket| {
            let inner = if bucket.least[0] <= bucket.greatest[0] {
                [bucket.least, bucket.greatest]
            } else {
                [bucket.greatest, bucket.least]
            };
            let all = [bucket.first, inner[0], inner[1], bucket.last];
            (0..4).filter(move |&i| i == 0 || !is_same(all[i], all[i - 1])).map(move |i| all[i])
        })
    }

    /// The values that are kept.
    pub fn values(&self) -> impl Iterator<Item = f64> + Clone + '_ {
        self.samples().map(|[_, value]| value)
    }

    /// The last value that is finite, with its time (s).
    pub fn last(&self) -> Option<Sample> {
        self.samples().filter(|sample| sample.iter().all(|number| number.is_finite())).last()
    }

    /// Whether it has a value that is not zero.
    pub fn is_anything(&self) -> bool {
        self.values().any(|value| value != 0.0)
    }
}

/// A path through a plane in bounded memory: one quantity against another one. Points that follow each other share a
/// bucket, which keeps the first, the last and the outermost ones in all four directions, in their order.
#[derive(Debug, Clone, PartialEq)]
pub struct PathTrace {
    buckets: Vec<PathBucket>,
    share: usize,
    filled: usize,
    /// Points so far.
    count: u64,
}

/// Points of a path that are kept of a bucket: the first, the leftmost, the rightmost, the lowest, the highest and the
/// last, with their numbers.
type PathBucket = [(u64, Sample); 6];

impl Default for PathTrace {
    fn default() -> Self {
        Self { buckets: Vec::new(), share: 1, filled: 0, count: 0 }
    }
}

impl PathTrace {
    /// Adds a point.
    pub fn push(&mut self, along: f64, value: f64) {
        let point = (self.count, [along, value]);
        self.count += 1;
        match self.buckets.last_mut() {
            Some(bucket) if self.filled < self.share => {
                *bucket = joined_paths(*bucket, [point; 6]);
                self.filled += 1;
            }
            _ => {
                if self.buckets.len() >= MOST_BUCKETS {
                    let joined = |pair: &[PathBucket]| pair[1..].iter().fold(pair[0], |a, b| joined_paths(a, *b));
                    self.buckets = self.buckets.chunks(2).map(joined).collect();
                    self.share *= 2;
                }
                self.buckets.push([point; 6]);
                self.filled = 1;
            }
        }
    }

    /// The points that are kept, in their order.
    pub fn samples(&self) -> impl Iterator<Item = Sample> + '_ {
        self.buckets.iter().flat_map(|bucket| {
            let mut points = *bucket;
            points.sort_by_key(|(number, _)| *number);
            let is_new = move |place: &usize| *place == 0 || points[*place].0 != points[*place - 1].0;
            (0..points.len()).filter(is_new).map(move |place| points[place].1)
        })
    }

    /// The last point whose numbers are finite.
    pub fn last(&self) -> Option<Sample> {
        self.samples().filter(|sample| sample.iter().all(|number| number.is_finite())).last()
    }

    /// Whether it has a value that is not zero.
    pub fn is_anything(&self) -> bool {
        self.samples().any(|[_, value]| value != 0.0)
    }
}

/// The points that are kept of two buckets.
fn joined_paths(a: PathBucket, b: PathBucket) -> PathBucket {
    let outer = |place: usize, axis: usize, sign: f64| {
        let (own, other) = (a[place].1[axis], b[place].1[axis]);
        // A comparison with what is not a number is false.
        if sign * other > sign * own || own.is_nan() { b[place] } else { a[place] }
    };
    [a[0], outer(1, 0, -1.0), outer(2, 0, 1.0), outer(3, 1, -1.0), outer(4, 1, 1.0), b[5]]
}

impl Bucket {
    fn joined(self, later: Self) -> Self {
        // A comparison with what is not a number is false, so that it stays where it is met first.
        let least = if later.least[1] < self.least[1] || self.least[1].is_nan() { later.least } else { self.least };
        let greatest = if later.greatest[1] > self.greatest[1] || self.greatest[1].is_nan() {
            later.greatest
        } else {
            self.greatest
        };
        Self { first: self.first, least, greatest, last: later.last }
    }
}

fn is_same(a: Sample, b: Sample) -> bool {
    a.map(f64::to_bits) == b.map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    //! Peaks are kept, memory is bounded, and short curves are whole.
    use super::*;

    #[test]
    fn a_short_curve_is_whole() {
        let samples: Vec<Sample> = (0..1000).map(|i| [f64::from(i), f64::from(i % 7)]).collect();
        let trace = Trace::of(samples.iter().copied());
        assert_eq!(trace.samples().collect::<Vec<_>>(), samples);
        assert_eq!(trace.last(), Some([999.0, 5.0]));
        assert_eq!(Trace::default().last(), None);
    }

    #[test]
    fn a_long_curve_keeps_its_peaks_its_ends_and_its_order() {
        let value = |i: u32| if i == 123_457 { 9.0 } else { f64::from(i % 3) };
        let trace = Trace::of((0..300_000).map(|i| [f64::from(i), value(i)]));
        let kept: Vec<Sample> = trace.samples().collect();
        assert!(kept.len() <= 4 * MOST_BUCKETS && kept.contains(&[123_457.0, 9.0]), "{}", kept.len());
        assert_eq!((kept[0], kept[kept.len() - 1]), ([0.0, 0.0], [299_999.0, value(299_999)]));
        assert!(kept.windows(2).all(|pair| pair[0][0] <= pair[1][0]));
    }

    #[test]
    fn a_long_path_keeps_its_order_and_its_outermost_points() {
        let mut path = PathTrace::default();
        for step in 0..200_000 {
            let angle = f64::from(step) * 1e-3;
            path.push(libm::cos(angle), if step == 77_777 { 5.0 } else { libm::sin(angle) });
        }
        let kept: Vec<Sample> = path.samples().collect();
        assert!(kept.len() <= 6 * MOST_BUCKETS && kept.iter().any(|point| point[1] == 5.0), "{}", kept.len());
        let steps = kept.windows(2).map(|pair| (pair[1][0] - pair[0][0]).abs());
        assert!(steps.fold(0.0, f64::max) < 0.3);
        assert_eq!(path.last(), kept.last().copied());
    }

    #[test]
    fn what_is_not_a_number_hides_no_peak() {
        let value = |i: u32| if i.is_multiple_of(2) { f64::NAN } else { f64::from(i) };
        let trace = Trace::of((0..10_000).map(|i| [f64::from(i), value(i)]));
        let greatest = trace.values().filter(|value| value.is_finite()).fold(0.0, f64::max);
        assert_eq!((greatest, trace.last()), (9999.0, Some([9999.0, 9999.0])));
    }
}

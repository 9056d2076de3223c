//! A zero of a function between two points where it has opposite signs.

/// Rounds after which bisection alone has used up all digits of a double, with room for Newton's steps between.
const ROUNDS: usize = 200;

/// The point in `[low, high]` where `function` (its value and its derivative) reaches zero from below: Newton's method,
/// halving the interval where that leaves it or is slow. The function is negative at `low` and not negative at `high`.
pub(super) fn rising_zero(function: impl Fn(f64) -> (f64, f64), mut low: f64, mut high: f64) -> f64 {
    let mut x = 0.5 * (low + high);
    let mut last_width = high - low;
    for _ in 0..ROUNDS {
        let (value, slope) = function(x);
        if value < 0.0 {
            low = x;
        } else {
            high = x;
        }
        let newton = x - value / slope;
        let width = high - low;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if next == x || width == 0.0 {
            return x;
        }
        // Newton's step from one side alone leaves the other end where it is: halve now and then.
        x = if width > 0.75 * last_width && (next - x).abs() > 0.25 * width { 0.5 * (low + high) } else { next };
        last_width = width;
        if x <= low || x >= high {
            return x;
        }
    }
    x
}

//! Decimal numbers from bytes, to the nearest f64.
//!
//! A number of at most 19 digits whose digits make an integer `m <= 2^53` and whose power of ten is at most 22 is
//! `m 10^e` or `m / 10^-e`: both operands are exact, so the one rounding is the nearest (docs/REFERENCES.md, Clinger
//! 1990). That is nearly every coordinate of nearly every file. The rest goes to the standard library, which is right
//! for all; the grammar is the standard library's (`1.`, `.5`, `+1e-3`, `nan`, `inf`).

/// Largest power of ten that is an f64 exactly.
const EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// The number that `text` is, if it is one; NaN and infinities are numbers here.
#[inline]
pub(crate) fn parse(text: &[u8]) -> Option<f64> {
    quick(text).or_else(|| std::str::from_utf8(text).ok()?.parse().ok())
}

/// The number, when it is of the common form.
#[inline]
fn quick(text: &[u8]) -> Option<f64> {
    let (is_negative, digits) = signed(text);
    let mut mantissa: u64 = 0;
    let mut count = 0;
    let mut at = 0;
    let mut after_point = 0;
    let mut point = None;
    while let Some(&byte) = digits.get(at) {
        let digit = byte.wrapping_sub(b'0');
        if digit < 10 {
            // Leading zeros count too, so that nothing overflows.
            mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(digit));
            count += 1;
        } else if byte == b'.' && point.is_none() {
            point = Some(count);
        } else {
            break;
        }
        at += 1;
    }
    if count == 0 || count > u64::MAX.ilog10() as usize || mantissa > 1 << f64::MANTISSA_DIGITS {
        return None;
    }
    if let Some(point) = point {
        after_point = count - point;
    }
    let exponent = match digits.get(at) {
        None => 0,
        Some(b'e' | b'E') => whole(&digits[at + 1..]).filter(|exponent| exponent.unsigned_abs() < 1 << 10)?,
        Some(_) => return None,
    } - after_point as i64;
    let power = *EXACT_POWERS.get(exponent.unsigned_abs() as usize)?;
    let magnitude = if exponent < 0 { mantissa as f64 / power } else { mantissa as f64 * power };
    Some(if is_negative { -magnitude } else { magnitude })
}

/// A whole number with at most a sign; none beyond i64.
#[inline]
pub(crate) fn whole(text: &[u8]) -> Option<i64> {
    let (is_negative, digits) = signed(text);
    if digits.is_empty() {
        return None;
    }
    let mut number: i64 = 0;
    for &byte in digits {
        let digit = byte.wrapping_sub(b'0');
        if digit > 9 {
            return None;
        }
        // Counted downwards, because there is one negative number more.
        number = number.checked_mul(10)?.checked_sub(i64::from(digit))?;
    }
    if is_negative { Some(number) } else { number.checked_neg() }
}

/// Whether there is a minus, and what follows the sign.
fn signed(text: &[u8]) -> (bool, &[u8]) {
    match text {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        _ => (false, text),
    }
}

#[cfg(test)]
mod tests {
    //! The same bits as the standard library, for every form.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use proptest::prelude::*;

    fn standard(text: &str) -> Option<u64> {
        text.parse::<f64>().ok().map(f64::to_bits)
    }

    #[test]
    fn forms() {
        for text in [
            "0",
            "-0",
            "+0.0",
            "1.",
            ".5",
            "-.5",
            ".",
            "",
            "-",
            "+",
            "e5",
            "1e",
            "1e+",
            "1e5",
            "1E-5",
            "1e+22",
            "1e23",
            "1e-22",
            "1e-23",
            "9007199254740993",
            "9007199254740992",
            "9007199254740993e3",
            "0.1",
            "1.5.2",
            "1e5.0",
            "1_0",
            " 1",
            "0000000000000000000000001",
            "1e400",
            "1e-400",
            "nan",
            "inf",
            "-infinity",
            "123456789.12345679",
            "1e99999999999999999999",
            "18446744073709551616",
            "18446744073709551626.5",
            "1e-9223372036854775808",
            "0x10",
            "--1",
            "+-1",
        ] {
            assert_eq!(parse(text.as_bytes()).map(f64::to_bits), standard(text), "{text}");
        }
        assert_eq!(parse(b"1\xFF"), None);
    }

    proptest! {
        #[test]
        fn any_number(number in any::<f64>(), digits in 0usize..20) {
            let short = [format!("{number}"), format!("{number:e}")];
            let of_digits = [format!("{number:.digits$}"), format!("{number:.digits$e}")];
            for text in short.into_iter().chain(of_digits) {
                let found = parse(text.as_bytes()).unwrap();
                prop_assert!(found.to_bits() == standard(&text).unwrap() || found.is_nan(), "{}", text);
            }
        }

        #[test]
        fn any_text(text in "[-+0-9.eE]{0,24}") {
            prop_assert_eq!(parse(text.as_bytes()).map(f64::to_bits), standard(&text));
        }
    }
}

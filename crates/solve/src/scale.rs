//! Powers of two that bring numbers near 1: exact, so that data of 10³⁰⁸ or 10⁻³⁰⁸ lose nothing.

/// The exponent `e` with `2^e ≤ max |a| < 2^(e+1)`, within the range of normal numbers; 0 for all zeros.
pub(crate) fn exponent<'a>(array: impl IntoIterator<Item = &'a f64>) -> i32 {
    let largest = array.into_iter().fold(0.0f64, |max, a| max.max(a.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return 0;
    }
    (((largest.to_bits() >> 52) & 0x7ff) as i32 - 1023).max(-1022)
}

/// `a · 2^e`, without overflow on the way.
pub(crate) fn by_power(a: f64, e: i32) -> f64 {
    if e == 0 {
        return a;
    }
    // Four steps of at most 2^±1022 reach from the least subnormal to the largest number and beyond.
    let mut rest = e;
    let mut scaled = a;
    for _ in 0..4 {
        let step = rest.clamp(-1022, 1022);
        scaled *= f64::from_bits(((1023 + step) as u64) << 52);
        rest -= step;
    }
    scaled
}

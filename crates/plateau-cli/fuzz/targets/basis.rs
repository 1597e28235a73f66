//! Any family at any point: refused, or a partition of unity with finite derivatives.

#![no_main]

use arbitrary::Arbitrary;
use bases::{Aht, At, Basis, BasisError, Bernstein, Gt};
use libfuzzer_sys::fuzz_target;

/// A number: any at all, or a share of an interval.
#[derive(Debug, Clone, Copy, Arbitrary)]
enum Number {
    Any(f64),
    Share(u32),
    Tiny(u8),
}

impl Number {
    fn within(self, start: f64, end: f64) -> f64 {
        match self {
            Self::Any(number) => number,
            Self::Share(share) => start + (end - start) * (f64::from(share) / f64::from(u32::MAX)),
            Self::Tiny(power) => start + (end - start) * 2f64.powi(-i32::from(power)),
        }
    }
}

#[derive(Debug, Arbitrary)]
enum Family {
    Bernstein(u16),
    Gt(u16, Number, Number),
    Aht(Number),
    At(Number),
}

#[derive(Debug, Arbitrary)]
struct Input {
    family: Family,
    at: Number,
    cut: Option<Number>,
}

impl Family {
    fn basis(&self) -> Result<Box<dyn Basis>, BasisError> {
        Ok(match *self {
            Self::Bernstein(degree) => Box::new(Bernstein::new(degree.into())?),
            Self::Gt(degree, p, q) => Box::new(Gt::new(degree.into(), [p, q].map(|n| n.within(0.0, 4.0)))?),
            Self::Aht(span) => Box::new(Aht::new(span.within(0.0, Aht::SUPREMUM))?),
            Self::At(span) => Box::new(At::new(span.within(0.0, At::SUPREMUM))?),
        })
    }
}

fn check(basis: &dyn Basis, t: f64) {
    let (start, end) = basis.domain();
    assert!(start < end);
    let table = basis.evaluate(t, 2);
    if !(start..=end).contains(&t) {
        return;
    }
    let n = basis.count() as f64;
    assert!(table.as_slice().iter().all(|x| x.is_finite()), "{basis:?} at {t}: {table:?}");
    let sum: f64 = table.row(0).iter().sum();
    assert!((sum - 1.0).abs() <= 1e-15 * (n + 16.0), "{basis:?} at {t}: the sum is {sum}");
    // Derivatives sum to nothing, up to rounding of their size on the interval (or, below that, of denormal numbers): at one
    // point all of them may vanish.
    let size = |r: usize| {
        let at = |k: u8| start + (end - start) * (f64::from(k) / 4.0);
        let sizes = (0..=4).map(|k| basis.evaluate(at(k), 2).row(r).iter().map(|x| x.abs()).sum());
        sizes.fold(table.row(r).iter().map(|x| x.abs()).sum(), f64::max)
    };
    for r in 1..=2 {
        let (sum, size) = (table.row(r).iter().sum::<f64>(), size(r));
        assert!(
            sum.abs() <= 1e-12 * size + f64::MIN_POSITIVE,
            "{basis:?} at {t}: derivatives {r} sum to {sum} of {size}"
        );
    }
}

fuzz_target!(|input: Input| {
    let Ok(basis) = input.family.basis() else { return };
    let (start, end) = basis.domain();
    let t = input.at.within(start, end);
    check(basis.as_ref(), t);
    if let Some(cut) = input.cut
        && let Ok(sides) = basis.subdivide(cut.within(start, end))
    {
        check(sides.left.as_ref(), t);
        check(sides.right.as_ref(), t);
    }
});

//! Axes: where ticks stand and what they say.

use super::svg::{Anchor, Font, GRID, INK, Svg};
use plateau::Notation;

/// Most decades a logarithmic axis can span.
const DECADES: i32 = 640;

/// An axis from data to pixels.
pub(super) struct Axis {
    low: f64,
    high: f64,
    logarithmic: bool,
    /// Pixels of both ends.
    pub(super) pixels: [f64; 2],
    /// Values of the ticks with their labels.
    pub(super) ticks: Vec<(f64, String)>,
}

impl Axis {
    /// Over `[low, high]`, widened if that is a point. Both finite.
    pub(super) fn linear(low: f64, high: f64, pixels: [f64; 2], wanted: usize) -> Self {
        let size = low.abs().max(high.abs());
        let (low, high) = if high - low > 1e-13 * size {
            (low, high)
        } else {
            let pad = if size > 0.0 { 0.05 * size } else { 1.0 };
            (low - pad, high + pad)
        };
        Self { low, high, logarithmic: false, pixels, ticks: ticks(low, high, wanted) }
    }

    /// Over the decades that hold `[low, high]`, 0 < low ≤ high.
    pub(super) fn logarithmic(low: f64, high: f64, pixels: [f64; 2], wanted: usize) -> Self {
        let first = libm::floor(libm::log10(low)) as i32;
        let last = (libm::ceil(libm::log10(high)) as i32).max(first + 1);
        let step = (1..DECADES).find(|step| (last - first) / step < wanted as i32).unwrap_or(DECADES);
        let ticks = (first..=last)
            .filter(|decade| decade.rem_euclid(step) == 0)
            .map(|decade| (f64::from(decade), Notation::power_of_ten(decade)))
            .collect();
        Self { low: f64::from(first), high: f64::from(last), logarithmic: true, pixels, ticks }
    }

    /// The pixel of a value.
    pub(super) fn at(&self, value: f64) -> f64 {
        self.place(if self.logarithmic { libm::log10(value) } else { value })
    }

    fn place(&self, x: f64) -> f64 {
        // Halves keep differences of the largest numbers finite.
        let share = (0.5 * x - 0.5 * self.low) / (0.5 * self.high - 0.5 * self.low);
        self.pixels[0] + share * (self.pixels[1] - self.pixels[0])
    }

    /// The pixels of the ticks with their labels.
    fn marks(&self) -> impl Iterator<Item = (f64, &str)> {
        self.ticks.iter().map(|(x, label)| (self.place(*x), label.as_str()))
    }
}

/// Draws the frame of a panel with grid, ticks and labels: x below, y at the left.
pub(super) fn frame(svg: &mut Svg, x: &Axis, y: &Axis, x_label: &str, y_label: &str) {
    let ([left, right], [bottom, top]) = (x.pixels, y.pixels);
    for (at, label) in x.marks() {
        svg.line([at, bottom], [at, top], GRID, 1.0);
        svg.line([at, bottom], [at, bottom + 4.0], INK, 1.0);
        svg.text([at, bottom + 17.0], Anchor::Middle, Font::SMALL, label);
    }
    let mut widest = 0;
    for (at, label) in y.marks() {
        svg.line([left, at], [right, at], GRID, 1.0);
        svg.line([left - 4.0, at], [left, at], INK, 1.0);
        svg.text([left - 7.0, at + 4.0], Anchor::End, Font::SMALL, label);
        widest = widest.max(label.chars().count());
    }
    svg.line([left, bottom], [right, bottom], INK, 1.0);
    svg.line([left, bottom], [left, top], INK, 1.0);
    svg.text([0.5 * (left + right), bottom + 35.0], Anchor::Middle, Font::LABEL, x_label);
    let beside = left - 17.0 - 6.3 * widest as f64;
    svg.turned_text([beside, 0.5 * (top + bottom)], Anchor::Middle, Font::LABEL, y_label, -90.0);
}

/// Round numbers within `[low, high]`, about `wanted` of them, with labels of equal precision.
pub(super) fn ticks(low: f64, high: f64, wanted: usize) -> Vec<(f64, String)> {
    let width = 0.5 * high - 0.5 * low;
    let rough = width / wanted.max(1) as f64 * 2.0;
    if !(rough.is_finite() && rough > 0.0) {
        return vec![(low, Notation::Digits(4).of(low))];
    }
    let decade = libm::floor(libm::log10(rough)) as i32;
    let unit = libm::exp10(f64::from(decade));
    let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|k| k * unit).find(|s| *s >= 0.999 * rough);
    let step = step.unwrap_or(rough);
    let (first, last) = (libm::ceil(low / step - 1e-9), libm::floor(high / step + 1e-9));
    let count = (last - first) as usize;
    let size = low.abs().max(high.abs());
    let plain = (-9..5).contains(&decade) && size < 1e6;
    (0..=count.min(40))
        .map(|k| {
            let multiple = first + k as f64;
            let value = multiple * step;
            let decimals = usize::try_from(-libm::floor(libm::log10(step) + 1e-9) as i32).unwrap_or(0);
            let label = if multiple == 0.0 {
                "0".to_owned()
            } else if plain {
                format!("{value:.decimals$}")
            } else {
                Notation::Digits(4).of(value)
            };
            (value, label.replace('-', "−"))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(low: f64, high: f64) -> Vec<String> {
        ticks(low, high, 5).into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn ticks_are_round_numbers() {
        assert_eq!(labels(0.0, 1.0), ["0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(-7.0, 11.0), ["−5", "0", "5", "10"]);
        assert_eq!(labels(37.4395, 37.4411), ["37.4395", "37.4400", "37.4405", "37.4410"]);
        assert_eq!(labels(0.0, 5e9)[1], "1·10⁹");
    }

    #[test]
    fn ticks_lie_within_and_are_few_for_any_range() {
        for (low, high) in
            [(0.0, 1e-300), (-1e150, 1e150), (1e15, 1e15 + 4.0), (-3e-9, 1e12), (f64::MIN, f64::MAX)]
        {
            let ticks = ticks(low, high, 6);
            assert!(!ticks.is_empty() && ticks.len() < 15, "{low} {high}: {}", ticks.len());
            assert!(ticks.iter().all(|(x, _)| x.is_finite()), "{low} {high}");
        }
    }

    #[test]
    fn logarithmic_axes_hold_their_range() {
        let axis = Axis::logarithmic(3e-12, 0.4, [0.0, 100.0], 6);
        assert!(axis.at(3e-12) >= 0.0 && axis.at(0.4) <= 100.0 && axis.ticks.len() <= 7);
    }
}

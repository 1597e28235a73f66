//! Perceptually even colour scales: straight lines at constant speed in Oklab (Ottosson's matrices).

/// Lightness and the two opponent colours.
type Oklab = [f64; 3];

/// Where there is no value.
pub(crate) const NONE: [u8; 3] = [150, 150, 150];

const WHITE: Oklab = [0.972, 0.0, 0.0];
const BLUE: Oklab = [0.450, -0.0365, -0.1480];
const RED: Oklab = [0.450, 0.1393, 0.0620];

const SEQUENCE: [Oklab; 3] = [[0.972, 0.0, 0.0], [0.700, -0.085, -0.020], [0.428, -0.030, -0.105]];

/// Blue for −1, white for 0, red for 1; ±t are equally light and equally far from white. Beyond ±1 the ends.
pub(crate) fn diverging(t: f64) -> [u8; 3] {
    let end = if t < 0.0 { BLUE } else { RED };
    srgb(between(WHITE, end, t.abs().min(1.0)))
}

/// From white for 0 over teal to dark blue for 1; beyond, the ends.
pub(crate) fn sequential(t: f64) -> [u8; 3] {
    let t = 2.0 * t.clamp(0.0, 1.0);
    let piece = if t < 1.0 { 0 } else { 1 };
    srgb(between(SEQUENCE[piece], SEQUENCE[piece + 1], t - piece as f64))
}

/// Share of the values that the colours cover; a few near singular points would wash out all the others.
const COVERED: f64 = 0.98;

/// The |value| at which the colours are full: all but the largest 2 % lie within. None if that is no more than `rounding`.
pub(crate) fn full_scale(values: impl Iterator<Item = f64>, rounding: f64) -> Option<f64> {
    let mut sizes: Vec<f64> = values.map(f64::abs).filter(|x| x.is_finite()).collect();
    let place = ((sizes.len() as f64 * COVERED) as usize).min(sizes.len().checked_sub(1)?);
    let (_, full, _) = sizes.select_nth_unstable_by(place, f64::total_cmp);
    (*full > rounding).then_some(*full)
}

/// A colour as `#rrggbb`.
pub(crate) fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// The colour in less light, `light` in 0..=1.
pub(crate) fn lit(colour: [u8; 3], light: f64) -> [u8; 3] {
    colour.map(|c| (f64::from(c) * light).round() as u8)
}

fn between(a: Oklab, b: Oklab, t: f64) -> Oklab {
    std::array::from_fn(|k| a[k] + t * (b[k] - a[k]))
}

fn srgb([l, a, b]: Oklab) -> [u8; 3] {
    linear([l, a, b]).map(|x| {
        let gamma = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * libm::pow(x, 1.0 / 2.4) - 0.055 };
        (255.0 * gamma.clamp(0.0, 1.0)).round() as u8
    })
}

fn linear([l, a, b]: Oklab) -> [f64; 3] {
    let cube = |x: f64| x * x * x;
    let long = cube(l + 0.396_337_777_4 * a + 0.215_803_757_3 * b);
    let medium = cube(l - 0.105_561_345_8 * a - 0.063_854_172_8 * b);
    let short = cube(l - 0.089_484_177_5 * a - 1.291_485_548_0 * b);
    [
        4.076_741_662_1 * long - 3.307_711_591_3 * medium + 0.230_969_929_2 * short,
        -1.268_438_004_6 * long + 2.609_757_401_1 * medium - 0.341_319_396_5 * short,
        -0.004_196_086_3 * long - 0.703_418_614_7 * medium + 1.707_614_701_0 * short,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn distance(a: Oklab, b: Oklab) -> f64 {
        (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
    }

    #[test]
    fn both_signs_are_equally_far_from_white_and_equally_light() {
        assert_eq!(BLUE[0], RED[0]);
        assert!((distance(WHITE, BLUE) - distance(WHITE, RED)).abs() < 1e-4);
        assert_eq!(diverging(0.0), diverging(-0.0));
        let grey = diverging(0.0);
        assert!(
            grey[0].abs_diff(grey[1]) <= 1 && grey[1].abs_diff(grey[2]) <= 1 && grey[0] > 240,
            "{grey:?}"
        );
        assert_eq!((diverging(-5.0), diverging(5.0)), (diverging(-1.0), diverging(1.0)));
        assert!(diverging(-1.0)[2] > 2 * diverging(-1.0)[0] && diverging(1.0)[0] > 2 * diverging(1.0)[2]);
    }

    #[test]
    fn every_colour_exists_on_a_screen() {
        let inside = |lab| {
            let rgb = linear(lab);
            assert!(rgb.iter().all(|x| (-0.002..=1.002).contains(x)), "{lab:?} {rgb:?}");
        };
        for k in 0..=100 {
            let t = f64::from(k) / 100.0;
            inside(between(WHITE, BLUE, t));
            inside(between(WHITE, RED, t));
            inside(between(SEQUENCE[0], SEQUENCE[1], t));
            inside(between(SEQUENCE[1], SEQUENCE[2], t));
        }
    }

    #[test]
    fn both_legs_of_the_sequence_are_equally_long() {
        let legs = [0, 1].map(|k| distance(SEQUENCE[k], SEQUENCE[k + 1]));
        assert!((legs[0] - legs[1]).abs() < 0.01, "{legs:?}");
    }
}

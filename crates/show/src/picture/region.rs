//! The shapes for which GT functions are nonnegative.

use plateau::{MethodError, ShapedFamily, nonnegative_shapes};

use super::axis::{Axis, frame};
use super::svg::{Anchor, FAINT, Font, INK, LINES, Svg, path};

/// Width and height of the picture.
const SIZE: [f64; 2] = [640.0, 560.0];
/// Where the frame lies: left and right, bottom and top.
const FRAME: [[f64; 2]; 2] = [[62.0, 502.0], [500.0, 60.0]];
/// The box that the papers search.
const PAPERS: [f64; 2] = [0.5, 3.5];

/// Degrees whose regions are told apart well in one picture.
pub const REGION_DEGREES: [u16; 5] = [2, 3, 4, 6, 10];

/// The regions of shapes (θ1, θ2) in which all GT functions of these degrees are nonnegative, as one SVG; beside them the square of shapes that is admitted and
/// the box of the papers.
///
/// ```
/// let picture = show::nonnegativity_region(&[2, 3])?;
/// assert!(picture.starts_with("<svg") && picture.contains("degree 3"));
/// # Ok::<(), plateau::MethodError>(())
/// ```
///
/// # Errors
/// [`MethodError::Basis`] for degrees below 2 or above 20.
pub fn nonnegativity_region(degrees: &[usize]) -> Result<String, MethodError> {
    let regions = degrees.iter().map(|&n| nonnegative_shapes(n)).collect::<Result<Vec<_>, _>>()?;
    let all = || regions.iter().flatten().flatten().copied();
    let low = libm::floor(all().fold(0.0, f64::min) - 0.3);
    let high = libm::ceil(all().fold(4.0, f64::max) + 0.3);
    let [left_right, bottom_top] = FRAME;
    let (x, y) = (Axis::linear(low, high, left_right, 8), Axis::linear(low, high, bottom_top, 8));
    let mut svg = Svg::new(SIZE[0], SIZE[1], "Shapes for which the GT functions are nonnegative");
    let caption = "Within its line no function of the degree is negative anywhere on [0, 1].";
    svg.heading([left_right[0], 0.0], "Where the GT functions are nonnegative", 60, caption);
    frame(&mut svg, &x, &y, "θ₁", "θ₂");
    let at = |[a, b]: [f64; 2]| [x.at(a), y.at(b)];
    let square = |[from, to]: [f64; 2]| path([[from, from], [to, from], [to, to], [from, to]].map(at), true);
    let (least, most) = ShapedFamily::Gt.range();
    let d = square([least, most]);
    svg.element(format_args!(r##"path d="{d}" fill="#eef1f5" stroke="none""##));
    let d = square(PAPERS);
    svg.element(format_args!(
        r#"path d="{d}" fill="none" stroke="{FAINT}" stroke-width="1" stroke-dasharray="5 4""#
    ));
    let key = left_right[1] + 16.0;
    for (k, (region, degree)) in regions.iter().zip(degrees).enumerate() {
        let colour = LINES[k % LINES.len()];
        let d = path(region.iter().copied().map(at), true);
        svg.element(format_args!(
            r#"path d="{d}" fill="none" stroke="{colour}" stroke-width="1.8" stroke-linejoin="round""#
        ));
        let line = bottom_top[1] + 14.0 + 22.0 * k as f64;
        svg.line([key, line], [key + 22.0, line], colour, 2.0);
        svg.text([key + 28.0, line + 4.0], Anchor::Start, Font::SMALL, &format!("degree {degree}"));
    }
    let label = Font { colour: INK, ..Font::SMALL };
    let [left, top] = at([PAPERS[0], PAPERS[1]]);
    svg.text([left + 5.0, top + 14.0], Anchor::Start, label, "box of the paper");
    let [left, top] = at([least, most]);
    svg.text([left + 5.0, top + 14.0], Anchor::Start, label, "admitted here");
    Ok(svg.finish())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_degree_has_its_line_and_its_name() {
        let svg = nonnegativity_region(&[2, 3, 7]).unwrap();
        assert_eq!(svg.matches("stroke-linejoin").count(), 3);
        for name in ["degree 2<", "degree 3<", "degree 7<"] {
            assert_eq!(svg.matches(name).count(), 1, "{name}");
        }
        assert!(!svg.contains("NaN"));
        assert!(nonnegativity_region(&[1]).is_err() && nonnegativity_region(&[21]).is_err());
    }
}

//! The functions of a basis.

use plateau::{CurveBasis, MethodError};

use super::axis::{Axis, frame};
use super::panels::arrange;
use super::svg::{Anchor, FAINT, Font, LINES, Svg, path};

/// Width and height of a panel with its labels.
const PANEL: [f64; 2] = [430.0, 330.0];
/// Panels in a row.
const IN_A_ROW: usize = 3;
/// Intervals in which a function is drawn.
const STEPS: usize = 240;
/// Least distance of a label from the frame's corners and of two labels from each other.
const APART: f64 = 15.0;

/// The functions of bases of degree `degree` (5 of AHT and AT) over their domains as one SVG, a panel for each basis, all between 0 and 1.
///
/// ```
/// let aht = plateau::CurveBasis::aht(6.0)?;
/// let picture = show::basis_functions(&[aht], 5)?;
/// assert!(picture.starts_with("<svg") && picture.contains("AHT, span 6"));
/// # Ok::<(), plateau::MethodError>(())
/// ```
///
/// # Errors
/// [`MethodError::Basis`] for a degree that a basis does not have.
pub fn basis_functions(bases: &[CurveBasis], degree: usize) -> Result<String, MethodError> {
    let [columns, rows] = arrange(bases.len(), IN_A_ROW);
    let title = "Basis functions over their parameter";
    let mut svg = Svg::new(PANEL[0] * columns as f64, PANEL[1] * rows as f64, title);
    for (k, basis) in bases.iter().enumerate() {
        let corner = [PANEL[0] * (k % columns) as f64, PANEL[1] * (k / columns) as f64];
        panel(&mut svg, corner, basis, degree)?;
    }
    Ok(svg.finish())
}

fn panel(svg: &mut Svg, [left, top]: [f64; 2], basis: &CurveBasis, degree: usize) -> Result<(), MethodError> {
    let functions = basis.functions(degree)?;
    let (start, end) = functions.domain();
    let t = |k: usize| if k == STEPS { end } else { start + (end - start) * (k as f64 / STEPS as f64) };
    let tables: Vec<_> = (0..=STEPS).map(|k| functions.evaluate(t(k), 0)).collect();
    let x = Axis::linear(start, end, [left + 58.0, left + PANEL[0] - 16.0], 5);
    let y = Axis::linear(0.0, 1.0, [top + PANEL[1] - 52.0, top + 46.0], 5);
    svg.text([left + 58.0, top + 28.0], Anchor::Start, Font::TITLE, &basis.described(degree));
    frame(svg, &x, &y, "parameter t", "value");
    let mut labels: Vec<[f64; 2]> = Vec::new();
    for i in 0..functions.count() {
        let colour = LINES[i % LINES.len()];
        let curve: Vec<[f64; 2]> = (0..=STEPS).map(|k| [x.at(t(k)), y.at(tables[k].row(0)[i])]).collect();
        let d = path(curve.iter().copied(), false);
        svg.element(format_args!(
            r#"path d="{d}" fill="none" stroke="{colour}" stroke-width="1.8" stroke-linejoin="round""#
        ));
        let peak = curve.iter().copied().reduce(|best, next| if next[1] < best[1] { next } else { best });
        let Some([px, py]) = peak else { continue };
        let at = [px.clamp(x.pixels[0] + APART, x.pixels[1] - APART), py.max(y.pixels[1] + APART) - 5.0];
        // Of many functions those that find room are named.
        if labels.iter().all(|other| (other[0] - at[0]).hypot(other[1] - at[1]) >= APART) {
            let font = Font { colour, ..Font::LABEL };
            svg.text(at, Anchor::Middle, font, &format!("b{}", subscript(i)));
            labels.push(at);
        }
    }
    if labels.len() < functions.count() {
        let all = format!("b{} to b{}, from left to right", subscript(0), subscript(functions.count() - 1));
        let font = Font { colour: FAINT, ..Font::SMALL };
        svg.text([left + PANEL[0] - 16.0, top + 28.0], Anchor::End, font, &all);
    }
    Ok(())
}

/// A number in subscript digits.
fn subscript(n: usize) -> String {
    n.to_string().chars().filter_map(|digit| char::from_u32('₀' as u32 + digit.to_digit(10)?)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panel_has_a_curve_and_a_name_for_each_function() {
        let bases = [
            CurveBasis::BERNSTEIN,
            CurveBasis::gt([0.5, 3.5]).unwrap(),
            CurveBasis::aht(std::f64::consts::TAU).unwrap(),
            CurveBasis::at(3.0).unwrap(),
        ];
        for basis in bases {
            let svg = basis_functions(&[basis], 5).unwrap();
            assert_eq!(svg.matches("<path").count(), 6, "{basis:?}");
            for name in ["b₀", "b₁", "b₂", "b₃", "b₄", "b₅"] {
                assert_eq!(svg.matches(&format!(">{name}<")).count(), 1, "{basis:?} {name}");
            }
            assert!(!svg.contains("NaN"));
        }
        let all = basis_functions(&bases, 5).unwrap();
        assert_eq!(all.matches("<path").count(), 24);
        assert!(basis_functions(&[CurveBasis::gt([1.0, 1.0]).unwrap()], 1).is_err());
    }
}

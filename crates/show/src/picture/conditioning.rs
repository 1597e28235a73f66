//! Condition numbers of extremals over the shapes of the GT family.

use std::fmt::Write;

use base64::prelude::{BASE64_STANDARD, Engine};
use plateau::{Conditioning, Functional, MethodError, Notation, ShapedFamily};

use super::axis::{Axis, frame};
use super::map::image;
use super::svg::{Anchor, FAINT, Font, INK, LINES, Length, Svg, path};
use crate::colour;

/// Steps of a map in each direction.
const STEPS: usize = 32;
/// Pixels of a map in each direction.
const PIXELS: usize = 96;
/// Side of a panel.
const SIDE: f64 = 300.0;
/// Left and top of the panels.
const LEFTS: [f64; 3] = [62.0, 442.0, 842.0];
const TOP: f64 = 62.0;
/// Height and width of the picture.
const SIZE: [f64; 2] = [1170.0, 440.0];
/// Shapes in each direction of the box that is searched for the least and the largest condition.
const LATTICE: usize = 5;
/// The box that the papers search.
const PAPERS: [f64; 2] = [0.5, 3.5];
/// The ends of the maps: near (0, 0) functions of degree 2 are dependent, which shows at all degrees.
const ENDS: [f64; 2] = [0.05, 4.0];
/// Highest degree of the last panel.
const HIGHEST: usize = 8;

/// A map: its values at the corners of a lattice, `values[i][j]` at (i, j).
struct Map {
    values: Vec<Vec<f64>>,
}

/// The condition number of the matrix A(α) of extremals of an energy over GT nets of a degree with fixed border, as one SVG: over two slices of the shapes, and how it grows
/// with the degree.
///
/// ```
/// let picture = show::conditioning(plateau::Functional::Dirichlet, 3)?;
/// assert!(picture.starts_with("<svg") && picture.contains("degree 3"));
/// # Ok::<(), plateau::MethodError>(())
/// ```
///
/// # Errors
/// [`MethodError::Energy`] for degrees below 2, [`MethodError::Solve`] where eigenvalues are not found.
pub fn conditioning(functional: Functional, degree: usize) -> Result<String, MethodError> {
    let of = |degree| Conditioning::new(functional, ShapedFamily::Gt, degree);
    let conditioning = of(degree)?;
    let condition = |shape: [f64; 4]| conditioning.condition(&shape);
    let slices = [map(|s, t| condition([s, s, t, t]))?, map(|s, t| condition([s, t, s, t]))?];
    let extremes = extremes(&conditioning)?;
    let mut svg = Svg::new(SIZE[0], SIZE[1], "Condition of the extremals over the shapes of the GT basis");
    let name = functional.name();
    let range = [0, 1].map(|end| {
        let values = slices.iter().flat_map(|map| map.values.iter().flatten());
        values.copied().fold([f64::INFINITY, 0.0][end], [f64::min, f64::max][end])
    });
    let titles = [
        (format!("κ, {name}, degree {degree}"), "α₁ = α₂", "β₁ = β₂"),
        ("κ where u and v have one shape".to_owned(), "α₁ = β₁", "α₂ = β₂"),
    ];
    for (k, (slice, (title, x, y))) in slices.iter().zip(&titles).enumerate() {
        svg.heading([LEFTS[k] - 20.0, 0.0], title, 46, "dashed: the box of the paper");
        draw(&mut svg, slice, range, LEFTS[k], [x, y], k);
    }
    by_degree(&mut svg, &of, degree.max(HIGHEST.min(degree + 5)))?;
    let [least, largest] =
        extremes.map(|(value, shape)| format!("{} at ({})", Notation::Digits(4).of(value), listed(shape)));
    let figures =
        format!("Of 5⁴ shapes of the box [0.5, 3.5]⁴ the least κ is {least}, the largest {largest}.");
    svg.text([LEFTS[0] - 20.0, SIZE[1] - 12.0], Anchor::Start, Font::LABEL, &figures);
    Ok(svg.finish())
}

fn at(k: usize) -> f64 {
    ENDS[0] + (ENDS[1] - ENDS[0]) * k as f64 / STEPS as f64
}

fn map(condition: impl Fn(f64, f64) -> Result<f64, MethodError>) -> Result<Map, MethodError> {
    let row = |i: usize| (0..=STEPS).map(|j| condition(at(i), at(j))).collect::<Result<Vec<_>, _>>();
    Ok(Map { values: (0..=STEPS).map(row).collect::<Result<Vec<_>, _>>()? })
}

/// The least and the largest condition on a lattice of the papers' box, with their shapes.
fn extremes(conditioning: &Conditioning) -> Result<[(f64, [f64; 4]); 2], MethodError> {
    let place = |k: usize| PAPERS[0] + (PAPERS[1] - PAPERS[0]) * k as f64 / (LATTICE - 1) as f64;
    let (mut least, mut largest) = ((f64::INFINITY, [0.0; 4]), (0.0, [0.0; 4]));
    for k in 0..LATTICE.pow(4) {
        let shape = [0, 1, 2, 3].map(|axis| place(k / LATTICE.pow(axis) % LATTICE));
        let condition = conditioning.condition(&shape)?;
        if condition < least.0 {
            least = (condition, shape);
        }
        if condition > largest.0 {
            largest = (condition, shape);
        }
    }
    Ok([least, largest])
}

fn listed(shape: [f64; 4]) -> String {
    shape.map(|x| x.to_string()).join(", ")
}

fn draw(
    svg: &mut Svg,
    map: &Map,
    [low, high]: [f64; 2],
    left: f64,
    [x_label, y_label]: [&str; 2],
    panel: usize,
) {
    let x = Axis::linear(ENDS[0], ENDS[1], [left, left + SIDE], 4);
    let y = Axis::linear(ENDS[0], ENDS[1], [TOP + SIDE, TOP], 4);
    frame(svg, &x, &y, x_label, y_label);
    let share = |value: f64| libm::log(value / low) / libm::log(high / low);
    let pixels = BASE64_STANDARD.encode(raster(map, &share));
    let [px, py, side] = [left, TOP, SIDE].map(Length);
    svg.element(format_args!(
        r#"image x="{px}" y="{py}" width="{side}" height="{side}" preserveAspectRatio="none" xlink:href="data:image/png;base64,{pixels}""#
    ));
    let [from, to] = PAPERS;
    let square = [[from, from], [to, from], [to, to], [from, to]].map(|[a, b]| [x.at(a), y.at(b)]);
    let d = path(square, true);
    svg.element(format_args!(
        r#"path d="{d}" fill="none" stroke="{INK}" stroke-width="0.8" stroke-dasharray="5 4""#
    ));
    svg.clip(&format!("slice-{panel}"), [left, TOP, left + SIDE, TOP + SIDE]);
    for level in levels(low, high) {
        let (d, label) = level_curve(map, level, &x, &y);
        svg.element(format_args!(r#"path d="{d}" fill="none" stroke="{INK}" stroke-width="0.8""#));
        if let Some([lx, ly]) = label {
            let text = Notation::Digits(4).of(level);
            let wide = 6.6 * text.chars().count() as f64 + 4.0;
            let [bx, by, w] = [lx - 0.5 * wide, ly - 7.0, wide].map(Length);
            svg.element(format_args!(
                r##"rect x="{bx}" y="{by}" width="{w}" height="14" rx="2" fill="#ffffff" fill-opacity="0.85""##
            ));
            svg.text([lx, ly + 4.0], Anchor::Middle, Font { colour: INK, ..Font::SMALL }, &text);
        }
    }
    let outline =
        path([[left, TOP], [left + SIDE, TOP], [left + SIDE, TOP + SIDE], [left, TOP + SIDE]], true);
    svg.element(format_args!(r#"path d="{outline}" fill="none" stroke="{INK}" stroke-width="1""#));
}

/// About eight round numbers within a range.
fn levels(low: f64, high: f64) -> Vec<f64> {
    let decades = libm::floor(libm::log10(low)) as i32..=libm::ceil(libm::log10(high)) as i32;
    let of = |digits: &[f64]| -> Vec<f64> {
        let all =
            decades.clone().flat_map(|decade| digits.iter().map(move |d| d * libm::exp10(f64::from(decade))));
        all.filter(|level| (1.02 * low..0.98 * high).contains(level)).collect()
    };
    let sets: [&[f64]; 4] =
        [&[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0], &[1.0, 2.0, 3.0, 5.0], &[1.0, 2.0, 5.0], &[1.0]];
    sets.into_iter().map(of).find(|levels| levels.len() <= 9).unwrap_or_default()
}

/// The map as a small PNG, white where the condition is least.
fn raster(map: &Map, share: &dyn Fn(f64) -> f64) -> Vec<u8> {
    let palette: Vec<u8> =
        (0..=255u8).flat_map(|k| colour::sequential(0.85 * f64::from(k) / 255.0)).collect();
    let place = |k: usize| {
        let t = (k as f64 + 0.5) / PIXELS as f64 * STEPS as f64;
        let cell = (t as usize).min(STEPS - 1);
        (cell, t - cell as f64)
    };
    let mut pixels = Vec::with_capacity(PIXELS * PIXELS);
    for row in (0..PIXELS).rev() {
        for column in 0..PIXELS {
            let ((i, s), (j, t)) = (place(column), place(row));
            let value = |i: usize, j: usize| share(map.values[i][j]);
            let along = |i: usize| value(i, j) + t * (value(i, j + 1) - value(i, j));
            let mixed = along(i) + s * (along(i + 1) - along(i));
            pixels.push((255.0 * mixed.clamp(0.0, 1.0)).round() as u8);
        }
    }
    image(PIXELS, &pixels, palette).expect("pixels for each place, and memory takes all bytes")
}

/// Where the linear interpolant on triangles has a value, and where its name may stand: where it crosses the diagonal, or anywhere.
fn level_curve(map: &Map, level: f64, x: &Axis, y: &Axis) -> (String, Option<[f64; 2]>) {
    let (mut d, mut label, mut nearest) = (String::new(), None, f64::INFINITY);
    for i in 0..STEPS {
        for j in 0..STEPS {
            for far in [[i + 1, j], [i, j + 1]] {
                let corners = [[i, j], far, [i + 1, j + 1]];
                let mut ends = Vec::with_capacity(2);
                for (from, to) in [(0, 1), (1, 2), (2, 0)] {
                    let [p, q] = [corners[from], corners[to]];
                    let value = |[i, j]: [usize; 2]| libm::log(map.values[i][j] / level);
                    let (f, g) = (value(p), value(q));
                    if (f < 0.0) != (g < 0.0) {
                        let t = f / (f - g);
                        let mix = |k: usize| at(p[k]) + t * (at(q[k]) - at(p[k]));
                        ends.push([mix(0), mix(1)]);
                    }
                }
                let [from, to] = ends[..] else { continue };
                let [from, to] = [from, to].map(|[s, t]| [x.at(s), y.at(t)]);
                let _ = write!(d, "{}", path([from, to], false));
                let off = (from[0] - x.pixels[0] - (y.pixels[0] - from[1])).abs();
                let inside = from[0] - x.pixels[0] > 14.0 && x.pixels[1] - from[0] > 14.0;
                if inside && off < nearest {
                    (nearest, label) = (off, Some(from));
                }
            }
        }
    }
    (d, label)
}

/// The condition along θ1 = θ2 in both directions, a curve for each degree.
fn by_degree(
    svg: &mut Svg,
    of: &dyn Fn(usize) -> Result<Conditioning, MethodError>,
    highest: usize,
) -> Result<(), MethodError> {
    let highest = highest.min(Conditioning::MAX_DEGREE);
    let mut curves = Vec::new();
    for degree in 3..=highest {
        let conditioning = of(degree)?;
        let values =
            (0..=STEPS).map(|k| conditioning.condition(&[at(k); 4])).collect::<Result<Vec<_>, _>>()?;
        curves.push((degree, values));
    }
    let all = || curves.iter().flat_map(|(_, values)| values).copied().filter(|x| x.is_finite());
    let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(1.0, f64::max));
    let left = LEFTS[2];
    let x = Axis::linear(ENDS[0], ENDS[1], [left, left + SIDE - 40.0], 4);
    let y = Axis::logarithmic(low, high, [TOP + SIDE, TOP], 9);
    svg.heading([left - 20.0, 0.0], "κ by degree, one shape in both directions", 46, "α₁ = α₂ = β₁ = β₂");
    frame(svg, &x, &y, "θ", "κ");
    for (k, (degree, values)) in curves.iter().enumerate() {
        let colour = LINES[k % LINES.len()];
        let d = path(values.iter().enumerate().map(|(k, value)| [x.at(at(k)), y.at(*value)]), false);
        svg.element(format_args!(r#"path d="{d}" fill="none" stroke="{colour}" stroke-width="1.8""#));
        if let Some(last) = values.last() {
            let font = Font { colour, ..Font::SMALL };
            svg.text([x.pixels[1] + 5.0, y.at(*last) + 4.0], Anchor::Start, font, &format!("n = {degree}"));
        }
    }
    let [from, to] = PAPERS.map(|end| x.at(end));
    for edge in [from, to] {
        svg.line([edge, TOP], [edge, TOP + SIDE], FAINT, 0.6);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_have_level_curves_with_names_and_a_curve_for_each_degree() {
        let svg = conditioning(Functional::Dirichlet, 3).unwrap();
        assert!(
            svg.contains(
                "least κ is 8.248 at (3.5, 3.5, 3.5, 3.5), the largest 45.91 at (0.5, 0.5, 0.5, 0.5)."
            ),
            "figures"
        );
        for name in ["n = 3", "n = 8", ">20<", ">30<"] {
            assert!(svg.contains(name), "{name}");
        }
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
        assert!(conditioning(Functional::Bending, 1).is_err());
    }
}

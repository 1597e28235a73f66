//! The geometric construction of the net of a helicoid over a trapezium (AT Figures 4 to 7).

use std::f64::consts::{PI, TAU};

use surfaces::{Patch, PlaneConstruction, Point, SpiralEnd, SurfaceError, TrapeziumHelicoid};

use super::svg::{Anchor, FAINT, Font, GRID, INK, LINES, Length, Svg, path};

/// Width and height of a panel, and of its heading.
const PANEL: [f64; 2] = [400.0, 400.0];
const HEAD: f64 = 48.0;
/// Space around what is drawn in a panel.
const MARGIN: f64 = 34.0;
/// Intervals in which a curve is drawn.
const STEPS: usize = 120;

/// Span, γ and β of the construction that AT Figure 6 draws.
pub const AT_FIGURE_6: (f64, [f64; 2], [f64; 2]) = (1.25 * PI, [TAU, 2.0 * TAU], [1.0, 1.0]);

/// The construction of AT Theorems 1 to 3 as one SVG: the derivatives at an end of a side, the control polygons of both sides in the plane,
/// and the net lifted from it.
///
/// ```
/// assert!(show::construction(3.9, [6.2, 12.5], [1.0, 0.5])?.contains("Theorem 2"));
/// # Ok::<(), surfaces::SurfaceError>(())
/// ```
///
/// # Errors
/// As [`TrapeziumHelicoid::new`]; [`SurfaceError::Basis`] for a span that one patch does not hold.
pub fn construction(span: f64, gamma: [f64; 2], beta: [f64; 2]) -> Result<String, SurfaceError> {
    let helicoid = TrapeziumHelicoid::new(span, gamma, beta)?;
    let sides = helicoid.construction()?;
    let net = helicoid.constructed_net()?;
    let title = "The geometric construction of the control net of a helicoid over a trapezium";
    let mut svg = Svg::new(3.0 * PANEL[0], PANEL[1] + HEAD, title);
    derivatives(&mut svg, &sides[0].ends[1]);
    polygons(&mut svg, &helicoid, &sides);
    lifted(&mut svg, &helicoid, &sides, net.points());
    Ok(svg.finish())
}

/// A panel with equal scales on both axes, y upwards.
struct Panel {
    scale: f64,
    middle: [f64; 2],
    centre: [f64; 2],
}

impl Panel {
    /// The k-th panel, which shows all of `points`.
    fn new(k: usize, points: &[[f64; 2]]) -> Self {
        let bound =
            |d: usize, pick: fn(f64, f64) -> f64, from: f64| points.iter().map(|p| p[d]).fold(from, pick);
        let low = [0, 1].map(|d| bound(d, f64::min, f64::INFINITY));
        let high = [0, 1].map(|d| bound(d, f64::max, f64::NEG_INFINITY));
        let room = |d: usize| (PANEL[d] - 2.0 * MARGIN) / (high[d] - low[d]).max(f64::MIN_POSITIVE);
        Self {
            scale: room(0).min(room(1)),
            middle: [0, 1].map(|d| 0.5 * (low[d] + high[d])),
            centre: [PANEL[0] * (k as f64 + 0.5), HEAD + 0.5 * PANEL[1]],
        }
    }

    fn at(&self, p: [f64; 2]) -> [f64; 2] {
        [
            self.centre[0] + self.scale * (p[0] - self.middle[0]),
            self.centre[1] - self.scale * (p[1] - self.middle[1]),
        ]
    }

    fn heading(k: usize, svg: &mut Svg, title: &str, caption: &str) {
        let x = PANEL[0] * k as f64 + 20.0;
        svg.text([x, 22.0], Anchor::Start, Font::TITLE, title);
        svg.text([x, 39.0], Anchor::Start, Font::SMALL, caption);
    }

    fn segment(&self, svg: &mut Svg, a: [f64; 2], b: [f64; 2], colour: &str, width: f64) {
        svg.line(self.at(a), self.at(b), colour, width);
    }

    fn line(&self, svg: &mut Svg, points: &[[f64; 2]], colour: &str, width: f64) {
        let d = path(points.iter().map(|&p| self.at(p)), false);
        svg.element(format_args!(
            r#"path d="{d}" fill="none" stroke="{colour}" stroke-width="{width}" stroke-linejoin="round""#
        ));
    }

    /// A dot with a name beside it, away from `from`.
    fn named(&self, svg: &mut Svg, p: [f64; 2], from: [f64; 2], name: &str, colour: &'static str) {
        let [x, y] = self.at(p);
        let [dx, dy] = [x - self.at(from)[0], y - self.at(from)[1]];
        let reach = dx.hypot(dy).max(1e-9);
        let (cx, cy) = (Length(x), Length(y));
        svg.element(format_args!(r#"circle cx="{cx}" cy="{cy}" r="3" fill="{colour}""#));
        let font = Font { colour, ..Font::LABEL };
        svg.text([x + 13.0 * dx / reach, y + 13.0 * dy / reach + 4.0], Anchor::Middle, font, name);
    }
}

fn flat(p: Point) -> [f64; 2] {
    [p.x, p.y]
}

/// Theorem 1 at one end of a spiral.
fn derivatives(svg: &mut Svg, end: &SpiralEnd) {
    let SpiralEnd { point, o1, p1, o2, p2 } = *end;
    let [o, p, o1, p1, o2, p2] = [Point::ZERO, point, o1, p1, o2, p2].map(flat);
    let panel = Panel::new(0, &[o, p, o1, p1, o2, p2]);
    Panel::heading(0, svg, "Theorem 1", "PP₁ is the first derivative at P, OP₂ the second");
    for (a, b) in [(o2, p), (p, o1), (o1, p1), (o2, p2)] {
        panel.segment(svg, a, b, FAINT, 1.2);
    }
    panel.segment(svg, p, p1, LINES[0], 2.0);
    panel.segment(svg, o, p2, LINES[1], 2.0);
    let middle = panel.middle;
    for (q, name, colour) in [
        (o, "O", INK),
        (p, "P", INK),
        (o1, "O₁", FAINT),
        (p1, "P₁", LINES[0]),
        (o2, "O₂", FAINT),
        (p2, "P₂", LINES[1]),
    ] {
        panel.named(svg, q, middle, name, colour);
    }
}

/// The sides of the helicoid seen from above, at v from 0 to its end.
fn curves(helicoid: &TrapeziumHelicoid, span: f64) -> [Vec<Point>; 2] {
    [0.0, 1.0].map(|u| (0..=STEPS).map(|k| helicoid.point(u, span * k as f64 / STEPS as f64)).collect())
}

fn span(helicoid: &TrapeziumHelicoid) -> f64 {
    match helicoid.domain() {
        surfaces::Domain::Rectangle { v: (_, end), .. } => end,
        surfaces::Domain::Triangle => 0.0,
    }
}

/// Theorem 2 for both sides.
fn polygons(svg: &mut Svg, helicoid: &TrapeziumHelicoid, sides: &[PlaneConstruction; 2]) {
    let curves = curves(helicoid, span(helicoid));
    let mut all: Vec<[f64; 2]> = curves.iter().flatten().map(|&p| flat(p)).collect();
    all.extend(sides.iter().flat_map(|side| side.points.iter().chain(&side.on_tangents)).map(|&p| flat(p)));
    let panel = Panel::new(1, &all);
    Panel::heading(1, svg, "Theorem 2", "control polygons in the plane; squares on the tangents");
    for v in [0, STEPS] {
        panel.segment(svg, flat(curves[0][v]), flat(curves[1][v]), GRID, 2.0);
    }
    for ((side, curve), &colour) in sides.iter().zip(&curves).zip(&LINES[1..]) {
        panel.line(svg, &curve.iter().map(|&p| flat(p)).collect::<Vec<_>>(), colour, 2.0);
        let q = side.points.map(flat);
        panel.line(svg, &q, FAINT, 1.0);
        for (t, (from, to)) in side.on_tangents.iter().zip([(q[1], q[2]), (q[4], q[3])]) {
            let t = flat(*t);
            panel.line(svg, &[from, t, to], LINES[0], 1.0);
            let [x, y] = panel.at(t).map(|c| Length(c - 2.5));
            svg.element(format_args!(
                r##"rect x="{x}" y="{y}" width="5" height="5" fill="#ffffff" stroke="{}""##,
                LINES[0]
            ));
        }
        for (k, &point) in q.iter().enumerate() {
            panel.named(svg, point, panel.middle, ["Q₀", "Q₁", "Q₂", "Q₃", "Q₄", "Q₅"][k], colour);
        }
    }
}

/// Theorem 3: the net above the plane.
fn lifted(svg: &mut Svg, helicoid: &TrapeziumHelicoid, sides: &[PlaneConstruction; 2], net: &[Point]) {
    // Seen from the front, the right and above; heights are drawn three times as large as they are, for a helicoid is flat.
    let rise = 3.0;
    let seen = |p: Point| [0.94 * p.x - 0.34 * p.y, 0.12 * p.x + 0.33 * p.y + 0.94 * rise * p.z];
    let curves = curves(helicoid, span(helicoid));
    let mut all: Vec<[f64; 2]> = curves.iter().flatten().chain(net).map(|&p| seen(p)).collect();
    all.extend(sides.iter().flat_map(|side| side.points).map(seen));
    let panel = Panel::new(2, &all);
    Panel::heading(2, svg, "Theorem 3", "points lifted to their heights, drawn three times as high");
    for k in (0..=STEPS).step_by(STEPS / 24) {
        panel.segment(svg, seen(curves[0][k]), seen(curves[1][k]), GRID, 1.0);
    }
    for ((side, row), (curve, &colour)) in sides.iter().zip(net.chunks(6)).zip(curves.iter().zip(&LINES[1..]))
    {
        panel.line(svg, &curve.iter().map(|&p| seen(p)).collect::<Vec<_>>(), colour, 1.2);
        panel.line(svg, &side.points.map(seen), FAINT, 0.8);
        panel.line(svg, &row.iter().map(|&p| seen(p)).collect::<Vec<_>>(), INK, 1.2);
        for (&q, &p) in side.points.iter().zip(row) {
            panel.segment(svg, seen(q), seen(p), LINES[0], 0.8);
            let [x, y] = panel.at(seen(p)).map(Length);
            svg.element(format_args!(r#"circle cx="{x}" cy="{y}" r="3" fill="{colour}""#));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_of_the_construction_is_drawn() {
        let svg = construction(3.9, [6.2, 12.5], [1.0, 0.5]).unwrap();
        for name in ["O", "P", "O₁", "P₁", "O₂", "P₂"] {
            assert_eq!(svg.matches(&format!(">{name}<")).count(), 1, "{name}");
        }
        for name in ["Q₀", "Q₁", "Q₂", "Q₃", "Q₄", "Q₅"] {
            assert_eq!(svg.matches(&format!(">{name}<")).count(), 2, "{name}");
        }
        assert!(!svg.contains("NaN"));
        assert!(construction(20.0, [1.0, 2.0], [0.0, 0.0]).is_err());
    }
}

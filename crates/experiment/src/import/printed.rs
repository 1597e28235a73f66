//! Experiments in words of the language.

use std::fmt::Write;

use exchange::{Assembly, AssemblyOptions, Form, LengthUnit, Shape, Side, Walk};
use plateau::Fill;
use surfaces::{EllipseArc, Point};

use super::ImportOptions;

/// The title, notes as comments, and the heading of the boundary.
pub(super) fn head(title: &str, notes: &[String]) -> String {
    let mut text = format!("title = {}\n", quoted(title));
    for note in notes {
        let _ = writeln!(text, "# {}", note.replace(char::is_control, " "));
    }
    text += "\n[boundary]\n";
    text
}

/// A boundary of loops or faces over curves, and what fills it.
pub(super) fn assembly(
    title: &str,
    assembly: &Assembly,
    options: &ImportOptions,
    fill: &Fill,
    notes: &[String],
) -> String {
    let tolerance = options.rim_tolerance(assembly);
    let mut text = head(title, notes);
    match &assembly.form {
        Form::Loops(loops) => {
            let loops: Vec<String> = loops.iter().map(|walks| names(assembly, walks)).collect();
            let _ = writeln!(text, "loops = [{}]", loops.join(", "));
        }
        Form::Faces(_) => text.truncate(text.len() - "\n[boundary]\n".len()),
    }
    for side in &assembly.sides {
        let _ = write!(text, "\n[[curve]]\nname = {}\n", quoted(&side.name));
        if let Some(ends) = side.ends {
            let [from, to] = ends.map(|vertex| quoted(&assembly.vertex_name(vertex)));
            let _ = writeln!(text, "ends = [{from}, {to}]");
        }
        let _ = writeln!(text, "{}", curve(side, tolerance, assembly.corner_angle));
    }
    if let Form::Faces(faces) = &assembly.form {
        for walks in faces {
            let corners = walks.iter().filter_map(|walk| {
                let ends = assembly.sides[walk.side].ends?;
                Some(quoted(&assembly.vertex_name(ends[usize::from(!walk.forward)])))
            });
            let _ = write!(text, "\n[[face]]\nvertices = [{}]\n", corners.collect::<Vec<_>>().join(", "));
        }
    }
    text + &method(fill)
}

/// The method that fills; of its keys those whose values are not the usual ones.
fn method(fill: &Fill) -> String {
    let mut text = String::from("\n[[method]]\nname = \"least area\"\nenergy = \"area\"\n");
    let _ = writeln!(text, "tolerance = {:?}", fill.tolerance());
    if let Some(degree) = fill.degree() {
        let _ = writeln!(text, "degree = {degree}");
    }
    if fill.layers() > 0 {
        let _ = writeln!(text, "layers = {}", fill.layers());
    }
    if let Some(accuracy) = fill.accuracy() {
        let _ = writeln!(text, "accuracy = {accuracy:?}");
    }
    if let Some(tolerance) = fill.rim_tolerance() {
        let _ = writeln!(text, "rim-tolerance = {tolerance:?}");
    }
    if fill.bound() {
        let _ = writeln!(text, "bound = true");
    }
    text
}

/// What the numbers are, where that is known.
pub(super) fn output(unit: Option<LengthUnit>) -> String {
    match unit {
        Some(unit) => format!("\n[output]\nstep-unit = {}\n", quoted(unit.name())),
        None => String::new(),
    }
}

fn names(assembly: &Assembly, walks: &[Walk]) -> String {
    let name = |walk: &Walk| {
        quoted(&format!("{}{}", if walk.forward { "" } else { "-" }, assembly.sides[walk.side].name))
    };
    format!("[{}]", walks.iter().map(name).collect::<Vec<_>>().join(", "))
}

/// The line of a curve that says what it is.
fn curve(side: &Side, tolerance: f64, corner_angle: f64) -> String {
    if let Some(control) = side.control_points() {
        return format!("points = {}", points(control));
    }
    match &side.shape {
        Shape::Polyline(samples) => {
            let usual = corner_angle == AssemblyOptions::CORNER_ANGLE;
            let corners = if usual { String::new() } else { format!(", corner-angle = {corner_angle:?}") };
            format!("through = {{ points = {}, tolerance = {tolerance:?}{corners} }}", points(samples))
        }
        Shape::Spline(_) => spline(&side.shape),
        Shape::Arc(arc) => circle(arc).unwrap_or_else(|| spline(&side.shape)),
    }
}

/// A full circle by its center, normal and radius.
fn circle(arc: &EllipseArc) -> Option<String> {
    let [a, b] = arc.radii();
    if !arc.is_closed() || (a - b).abs() > 1e-12 * a {
        return None;
    }
    let [from, to] = arc.angles();
    let normal = arc.axes()[0].cross(arc.axes()[1]) * if to > from { 1.0 } else { -1.0 };
    Some(format!(
        "circle = {{ center = {}, normal = {}, radius = {a:?} }}",
        point(arc.center()),
        point(normal)
    ))
}

/// A spline; arcs are rational ones.
fn spline(shape: &Shape) -> String {
    let Some(spline) = shape.as_spline() else { return String::new() };
    let numbers = |numbers: &[f64]| numbers.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(", ");
    let mut text = format!(
        "spline = {{ degree = {}, knots = [{}], points = {}",
        spline.degree(),
        numbers(spline.knots()),
        points(spline.points())
    );
    if let Some(weights) = spline.weights() {
        let _ = write!(text, ", weights = [{}]", numbers(weights));
    }
    text + " }"
}

/// A list of points at full precision.
pub(super) fn points(points: &[Point]) -> String {
    format!("[{}]", points.iter().map(|p| point(*p)).collect::<Vec<_>>().join(", "))
}

fn point(p: Point) -> String {
    format!("[{:?}, {:?}, {:?}]", p.x, p.y, p.z)
}

/// A basic string of TOML.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => quoted.push(' '),
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

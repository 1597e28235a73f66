//! Comma-separated values: one line per sample of curves.

use std::io::{self, Write};

use plateau::{CurveResult, CurveSample};

/// Parameter, point, derivatives and curvature with all their digits; the curvature is empty where there is none. Lines of several
/// curves, which differ in their shape, begin with that.
pub fn write_curves(curves: &[CurveResult], out: &mut dyn Write) -> io::Result<()> {
    let Some(first) = curves.first() else { return Ok(()) };
    let axes = &["x", "y", "z"][..first.dimension()];
    let mut header = match curves.len() {
        1 => Vec::new(),
        _several => vec!["theta1".to_owned(), "theta2".to_owned()],
    };
    header.push("t".to_owned());
    for prefix in ["", "d1_", "d2_"] {
        header.extend(axes.iter().map(|axis| format!("{prefix}{axis}")));
    }
    header.push("curvature".into());
    writeln!(out, "{}", header.join(","))?;
    curves.iter().try_for_each(|curve| lines(curve, curves.len() > 1, out))
}

fn lines(curve: &CurveResult, with_shape: bool, out: &mut dyn Write) -> io::Result<()> {
    let shape = match curve.curve().basis().shape() {
        Some([first, second]) if with_shape => format!("{first:?},{second:?},"),
        Some(_) | None => String::new(),
    };
    for CurveSample { t, jet, curvature, .. } in curve.samples() {
        write!(out, "{shape}{t:?}")?;
        for p in [jet.point, jet.d1, jet.d2] {
            for x in curve.coordinates(p) {
                write!(out, ",{x:?}")?;
            }
        }
        writeln!(out, ",{}", curvature.map_or(String::new(), |k| format!("{k:?}")))?;
    }
    Ok(())
}

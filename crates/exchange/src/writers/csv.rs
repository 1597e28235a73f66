//! Comma-separated values: one line per sample of a curve.

use std::io::{self, Write};

use plateau::CurveResult;

/// Parameter, point, derivatives and curvature with all their digits; the curvature is empty where there is none.
pub fn write_curve(curve: &CurveResult, out: &mut dyn Write) -> io::Result<()> {
    let axes = &["x", "y", "z"][..curve.dimension];
    let mut header = vec!["t".to_owned()];
    for prefix in ["", "d1_", "d2_"] {
        header.extend(axes.iter().map(|axis| format!("{prefix}{axis}")));
    }
    header.push("curvature".into());
    writeln!(out, "{}", header.join(","))?;
    for ((t, jet), curvature) in curve.t.iter().zip(&curve.jets).zip(&curve.curvature) {
        write!(out, "{t:?}")?;
        for p in [jet.point, jet.d1, jet.d2] {
            for x in curve.coordinates(p) {
                write!(out, ",{x:?}")?;
            }
        }
        writeln!(out, ",{}", curvature.map_or(String::new(), |k| format!("{k:?}")))?;
    }
    Ok(())
}

//! The figures of one film, a line each.

use plateau::{AreaEnd, Film, Notation, Warning, Way, counted};

use crate::table::{NOT_ESTIMATED, is_too_costly};

/// What the curves of files were before they were filled.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RimSource {
    /// Whether some are points that a smooth curve was laid through.
    pub sampled: bool,
    /// How many ends were welded.
    pub welded: usize,
    /// How far the farthest of them was moved.
    pub moved: f64,
}

/// What a film is, as names and values: the area with all of its error, how far it is from the least, how it was cut, what its rim is.
///
/// `estimate` says, in the words of whoever asks, what has the least area estimated where that was too costly.
#[must_use]
pub fn film_figures(film: &Film, rim: RimSource, estimate: &str) -> Vec<(&'static str, String)> {
    let mut rows = vec![("area", area(film))];
    rows.extend(least_area(film, estimate).map(|text| ("least area", text)));
    if let Some(bound) = &film.bound {
        let text = format!("≥ {}, proved of {}", figure(bound.value), bound.competitors.name());
        rows.push(("least area", text));
    }
    if let Some(discs) = film.one_by_one {
        rows.push(("one by one", format!("{} with each loop spanned by itself", figure(discs))));
    }
    rows.push(("faces", faces(film)));
    if let Some(kink) = film.seams.kink {
        let degrees = |angle| Notation::Degrees(2).of(angle);
        // Across curves that hold the surface it bends as it must.
        let held = if film.way == Way::Faces { ", where no given curve holds the edge" } else { "" };
        let text = format!("at most {}°, root mean square {}°{held}", degrees(kink.max), degrees(kink.rms));
        rows.push(("kink", text));
    }
    rows.push(("Jacobian ratio", format!("{:.2}", film.seams.jacobian_ratio)));
    rows.push(("rim", met(film, rim)));
    if rim.welded > 0 {
        let moved = Notation::Short(2).of(rim.moved);
        rows.push(("welded", format!("{}, moved by at most {moved}", counted(rim.welded, "end"))));
    }
    if let Some(found) = film.extremal.as_ref().filter(|found| found.end != AreaEnd::Stationary) {
        rows.push(("end", found.end.to_string()));
    }
    rows.extend(film.warnings.iter().map(|warning| {
        let is_note = matches!(warning, Warning::LayerSet { .. });
        (if is_note { "note" } else { "warning" }, warning.to_string())
    }));
    rows
}

/// The area with all of its error: that of the integral, and what it can cost that the rim is not quite the curves.
fn area(film: &Film) -> String {
    let area = film.figures.area;
    let order = |x| Notation::Short(2).of(x);
    let total = format!("{} ± {}", figure(area.value), order(area.error + film.rim.area));
    if film.rim.area == 0.0 {
        return total;
    }
    format!(
        "{total}: {} of the integral, and up to about {} because the rim is not quite the curves",
        order(area.error),
        order(film.rim.area)
    )
}

/// What is estimated of the least area over the rim, or why nothing is.
fn least_area(film: &Film, estimate: &str) -> Option<String> {
    if let Some(estimate) = film.estimate {
        return Some(format!("about {} less (estimated)", Notation::Order.of(estimate)));
    }
    is_too_costly(film.extremal.as_ref()?, &film.warnings).then(|| format!("{NOT_ESTIMATED}; {estimate}"))
}

fn faces(film: &Film) -> String {
    let (faces, degree) = (film.complex().faces().len(), film.complex().degree());
    let layers = match film.layers {
        0 => String::new(),
        1 => ", a layer of smaller ones around corners".to_owned(),
        layers => format!(", {layers} layers of smaller ones around corners"),
    };
    format!("{faces} of degree {degree}: {}{layers}", cut(film.way))
}

/// How the rim meets the curves.
fn met(film: &Film, rim: RimSource) -> String {
    match film.rim.largest {
        largest if largest > 0.0 => format!("within {} of the curves", Notation::Short(2).of(largest)),
        _ if rim.sampled => "exact in the points given, a smooth curve between them".into(),
        _ => "exact".into(),
    }
}

/// How a boundary was cut, in words.
fn cut(way: Way) -> &'static str {
    match way {
        Way::Grid => "a grid over four sides",
        Way::Midpoint => "a quadrilateral at every corner, around the middle",
        Way::Ring => "a ring along the rim, and its inside",
        Way::TurnedRing => "a ring along the rim, and its inside turned by half a side",
        Way::Annulus => "a band between the loops",
        Way::Faces => "each face of the graph by itself",
        Way::Parts => "four-sided parts, each by itself",
    }
}

/// Twelve significant digits.
fn figure(x: f64) -> String {
    Notation::Significant(12).of(x)
}

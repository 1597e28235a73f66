//! How near a rim is fitted to samples, beside how near the area is to the least.

use exchange::{Shape, Side};
use plateau::{Fill, Film, Notation};

use super::Filling;

/// The degree of fits where none is asked for: that of patches.
const USUAL: usize = 6;

/// Powers of ten by which the tolerance is lowered in looking for a fit that is near enough.
const DECADES: i32 = 10;

impl Filling {
    /// What to ask for where the surface is wanted to a share of its area and the fit of its rim can cost more: an accuracy is met over the
    /// rim as it was fitted, which it does not make nearer to the curves. None where nothing is left to ask for.
    pub fn advice(&self, fill: &Fill, film: &Film) -> Option<String> {
        let (accuracy, area) = (fill.accuracy()?, film.figures.area.value);
        if film.rim.area <= accuracy * area {
            return None;
        }
        let degree = fill.degree().unwrap_or(USUAL);
        let advice = match self.nearer(degree, accuracy * area) {
            Some(tolerance) => format!("`--tolerance {tolerance}` fits it near enough"),
            None if self.rim_source().sampled => format!(
                "no smooth curves in pieces of degree {degree} come so near to the samples; more samples do, or a higher --degree"
            ),
            None => "a higher --degree meets it nearer".into(),
        };
        Some(format!(
            "--accuracy {accuracy:e} speaks of the surface over the rim as it was fitted; that the rim is not quite the curves can cost \
             {} of the area: {advice}",
            Notation::Order.of(film.rim.area / area)
        ))
    }

    /// A tolerance in few digits, within which the fits of all sides cost no more than `wanted`, and are smooth.
    fn nearer(&self, degree: usize, wanted: f64) -> Option<String> {
        let from = self.options().rim_tolerance(self.assembly());
        (1..=DECADES).map(|k| format!("{:.0e}", from * libm::exp10(-f64::from(k)))).find(|text| {
            let cost = |tolerance: f64| -> Option<f64> {
                self.assembly().sides.iter().map(|side| self.cost(side, degree, tolerance)).sum()
            };
            text.parse().ok().and_then(cost).is_some_and(|cost| cost <= wanted)
        })
    }

    /// What the fit of a side can cost; none if its samples are joined by segments.
    fn cost(&self, side: &Side, degree: usize, tolerance: f64) -> Option<f64> {
        let assembly = self.assembly();
        let curve = side.curve(tolerance, assembly.corner_angle).ok()?;
        let fit = curve.fit(degree, tolerance.min(Fill::RIM_TOLERANCE * assembly.size)).ok()?;
        match &side.shape {
            Shape::Polyline(points) if points.len() > 2 && fit.pieces().len() + 1 >= points.len() => None,
            Shape::Polyline(_) | Shape::Spline(_) | Shape::Arc(_) => Some(fit.deviation().area),
        }
    }
}

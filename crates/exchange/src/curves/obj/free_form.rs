//! Free-form curves of OBJ files.

use surfaces::{Point, SplineCurve};

use crate::curves::{CurveFileError, limits, trim};

/// Families of free-form curves.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Family {
    Bezier,
    BSpline,
}

/// A free-form curve without its points.
pub(super) struct FreeForm {
    pub(super) family: Family,
    pub(super) is_rational: bool,
    pub(super) degree: usize,
    pub(super) ends: [f64; 2],
    pub(super) parameters: Vec<f64>,
}

impl FreeForm {
    /// The curve of these points.
    pub(super) fn spline(
        &self,
        points: Vec<Point>,
        weights: Option<Vec<f64>>,
    ) -> Result<SplineCurve, String> {
        let knots = match self.family {
            Family::BSpline => self.parameters.clone(),
            Family::Bezier => self.bezier_knots(points.len())?,
        };
        let spline =
            SplineCurve::new(self.degree, knots, points, weights).map_err(|error| error.to_string())?;
        trim::cut(&spline, self.ends[0], self.ends[1])
    }

    /// Knots of Bézier pieces: the parameters between them, each as often as the degree says.
    fn bezier_knots(&self, count: usize) -> Result<Vec<f64>, String> {
        let n = self.degree;
        if n == 0 || n > SplineCurve::MAX_DEGREE || count <= n || !(count - 1).is_multiple_of(n) {
            return Err(format!(
                "{count} points, and Bézier pieces of degree {n} have a multiple of it and one more"
            ));
        }
        let pieces = (count - 1) / n;
        let ends: Vec<f64> = match self.parameters.len() {
            0 => {
                let [a, b] = self.ends;
                (0..=pieces).map(|k| a + (b - a) * k as f64 / pieces as f64).collect()
            }
            given if given == pieces + 1 => self.parameters.clone(),
            given => {
                return Err(format!(
                    "{given} parameters for {pieces} Bézier pieces: it takes {}",
                    pieces + 1
                ));
            }
        };
        let inner = ends.iter().flat_map(|t| std::iter::repeat_n(*t, n));
        Ok(std::iter::once(ends[0]).chain(inner).chain([ends[pieces]]).collect())
    }
}

/// The family that a statement names, and whether it is rational.
pub(super) fn family(words: &[&str], line: usize) -> Result<(Family, bool), CurveFileError> {
    let (is_rational, word) = match words {
        ["rat", word, ..] => (true, *word),
        [word, ..] => (false, *word),
        [] => (false, ""),
    };
    match word {
        "bezier" => Ok((Family::Bezier, is_rational)),
        "bspline" => Ok((Family::BSpline, is_rational)),
        _ => Err(CurveFileError::at(
            line,
            format!(
                "curves of the kind {:?} are not read; `bezier` and `bspline` are, each with `rat` or without",
                limits::name(word)
            ),
        )),
    }
}

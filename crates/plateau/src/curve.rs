//! A curve sampled with its derivatives and its curvature.

use bases::{GaussLegendre, Matrix};
use surfaces::{CurveJet, Point};

use crate::{CurveBasis, MethodError, Warning};

/// One planar or space curve with control points, and the parameters at which it is sampled.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    basis: CurveBasis,
    points: Vec<Point>,
    is_planar: bool,
    samples: Vec<f64>,
}

impl Curve {
    /// The curve of `points` in `basis`: at least 2 (Bernstein), at least 3 (GT), exactly 6 (AHT, AT); sampled at `samples` of the
    /// [`domain`](CurveBasis::domain).
    ///
    /// # Errors
    /// [`MethodError::Surface`], [`MethodError::Basis`] for points or a basis that make no curve, [`MethodError::Sample`] for a sample
    /// outside.
    pub fn new(basis: CurveBasis, points: Vec<Point>, samples: Vec<f64>) -> Result<Self, MethodError> {
        surfaces::Curve::new(basis.functions(points.len().saturating_sub(1))?, points.clone())?;
        Self { basis, points, is_planar: false, samples: Vec::new() }.sampled_at(samples)
    }

    /// In the plane z = 0: its curvature has a sign, its points have two coordinates.
    ///
    /// # Errors
    /// [`MethodError::NotPlanar`] unless every point has z = 0.
    pub fn planar(self) -> Result<Self, MethodError> {
        match self.points.iter().position(|p| p.z != 0.0) {
            Some(index) => Err(MethodError::NotPlanar { index }),
            None => Ok(Self { is_planar: true, ..self }),
        }
    }

    /// The same curve at other samples.
    ///
    /// # Errors
    /// [`MethodError::Sample`] for one outside of the domain.
    pub fn sampled_at(self, samples: Vec<f64>) -> Result<Self, MethodError> {
        let [start, end] = self.basis.domain();
        match samples.iter().find(|t| !(start..=end).contains(*t)) {
            Some(&t) => Err(MethodError::Sample { t, start, end }),
            None => Ok(Self { samples, ..self }),
        }
    }

    /// The basis of the control points.
    #[must_use]
    pub fn basis(&self) -> CurveBasis {
        self.basis
    }

    /// The control points.
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Coordinates of a point: 2 of planar curves, else 3.
    #[must_use]
    pub fn dimension(&self) -> usize {
        if self.is_planar { 2 } else { 3 }
    }

    /// The parameters of the samples.
    #[must_use]
    pub fn samples(&self) -> &[f64] {
        &self.samples
    }
}

/// A curve that was sampled.
#[derive(Debug)]
pub struct CurveResult {
    name: String,
    samples: Vec<CurveSample>,
    length: [f64; 2],
    curve: Curve,
}

/// A sample of a curve.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct CurveSample {
    /// Its parameter.
    pub t: f64,
    /// Values (row 0), first (row 1) and second derivatives (row 2) of the functions of the basis.
    pub basis: Matrix,
    /// Point and derivatives.
    pub jet: CurveJet,
    /// Signed curvature of planar curves, curvature of space curves, 1/length; none where the tangent vanishes to within rounding.
    pub curvature: Option<f64>,
}

/// Samples a curve.
///
/// # Errors
/// [`MethodError::Overflow`] for derivatives beyond double precision.
pub fn sample(plan: &Curve) -> Result<CurveResult, MethodError> {
    let degree = plan.points.len() - 1;
    let basis = plan.basis.functions(degree)?;
    let curve = surfaces::Curve::new(basis.clone(), plan.points.clone())?;
    let mut samples = Vec::with_capacity(plan.samples.len());
    for &t in &plan.samples {
        let (table, jet) = (basis.evaluate(t, 2), curve.jet(t));
        let finite = (0..3).all(|r| table.row(r).iter().all(|x| x.is_finite()))
            && [jet.point, jet.d1, jet.d2].iter().all(|p| p.is_finite());
        if !finite {
            return Err(MethodError::Overflow { t });
        }
        let curvature = curvature(&jet, curve.points(), table.row(1), plan.dimension());
        let curvature = curvature.filter(|k| k.is_finite());
        samples.push(CurveSample { t, basis: table, jet, curvature });
    }
    Ok(CurveResult {
        name: plan.basis.described(degree),
        samples,
        length: length(&curve)?,
        curve: plan.clone(),
    })
}

/// The curvature, unless the tangent is nothing but rounding.
fn curvature(jet: &CurveJet, points: &[Point], derivatives: &[f64], dimension: usize) -> Option<f64> {
    let summands: f64 = points.iter().zip(derivatives).map(|(p, f)| p.norm() * f.abs()).sum();
    if jet.d1.norm() <= 16.0 * f64::EPSILON * summands {
        return None;
    }
    if dimension == 2 { jet.signed_curvature() } else { jet.curvature() }
}

/// `∫ ‖c'‖` by Gauss rules of 16, 32, … points until a doubling moves it by no more than 1e-13 of its value, at most 512
/// points; and by how much the last doubling moved it.
fn length(curve: &surfaces::Curve) -> Result<[f64; 2], MethodError> {
    let (start, end) = curve.basis().domain();
    let by_rule = |points: usize| -> Result<f64, MethodError> {
        let rule = GaussLegendre::new(points)?.on(start, end);
        Ok(rule.iter().map(|(t, w)| w * curve.jet(t).d1.norm()).sum())
    };
    let (mut points, mut last) = (16, by_rule(16)?);
    loop {
        points *= 2;
        let value = by_rule(points)?;
        if !value.is_finite() {
            return Err(MethodError::Overflow { t: start });
        }
        let error = (value - last).abs() + 16.0 * f64::EPSILON * value;
        if error <= 1e-13 * value || points >= 512 {
            return Ok([value, error]);
        }
        last = value;
    }
}

impl CurveResult {
    /// The basis in words: `GT, degree 3, θ = (1, 2)`.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its samples, in the order in which they were asked for.
    #[must_use]
    pub fn samples(&self) -> &[CurveSample] {
        &self.samples
    }

    /// Coordinates of a point: 2 or 3.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.curve.dimension()
    }

    /// Length of the curve, and the error believed.
    #[must_use]
    pub fn length(&self) -> [f64; 2] {
        self.length
    }

    /// The curve that was sampled.
    #[must_use]
    pub fn curve(&self) -> &Curve {
        &self.curve
    }

    /// The sample of largest |curvature|, the first of equals, and its curvature. None if no sample has a curvature.
    #[must_use]
    pub fn sharpest(&self) -> Option<(&CurveSample, f64)> {
        let known = self.samples.iter().filter_map(|sample| Some((sample, sample.curvature?)));
        known.reduce(|best, next| if next.1.abs() > best.1.abs() { next } else { best })
    }

    /// The coordinates the curve has.
    #[must_use]
    pub fn coordinates(&self, p: Point) -> Vec<f64> {
        let mut all = Vec::from(<[f64; 3]>::from(p));
        all.truncate(self.dimension());
        all
    }

    /// What a reader must know.
    pub fn warnings(&self) -> Vec<Warning> {
        let mut warnings = Vec::new();
        let singular: Vec<f64> =
            self.samples.iter().filter(|sample| sample.curvature.is_none()).map(|sample| sample.t).collect();
        if !singular.is_empty() {
            warnings.push(Warning::CurveSingular { at: singular });
        }
        let basis = self.curve.basis;
        let [_, span] = basis.domain();
        if let Some(bound) = basis.family().spans().map(|spans| spans.end)
            && span > 0.95 * bound
        {
            warnings.push(Warning::CurveNearBound { span, bound, basis: basis.family().title() });
        }
        let [length, error] = self.length;
        if error > 1e-9 * length {
            warnings.push(Warning::LengthUnsettled { length, error });
        }
        warnings
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sampled(basis: CurveBasis, points: &[[f64; 2]], samples: usize) -> Result<CurveResult, MethodError> {
        let [start, end] = basis.domain();
        let at = |k: usize| start + (end - start) * (k as f64 / (samples - 1) as f64);
        let points = points.iter().map(|&[x, y]| Point::new(x, y, 0.0)).collect();
        sample(&Curve::new(basis, points, (0..samples).map(at).collect())?.planar()?)
    }

    #[test]
    fn what_is_no_curve_is_refused() {
        let points = |z: f64| vec![Point::ZERO, Point::new(1.0, 0.0, z), Point::new(2.0, 1.0, 0.0)];
        let curve = |samples: &[f64]| Curve::new(CurveBasis::BERNSTEIN, points(0.5), samples.to_vec());
        assert!(matches!(curve(&[0.0, 1.5]), Err(MethodError::Sample { t: 1.5, .. })));
        assert!(matches!(curve(&[f64::NAN]), Err(MethodError::Sample { .. })));
        assert!(matches!(curve(&[1.0]).unwrap().planar(), Err(MethodError::NotPlanar { index: 1 })));
        assert!(Curve::new(CurveBasis::aht(1.0).unwrap(), points(0.0), vec![]).is_err());
        assert!(Curve::new(CurveBasis::BERNSTEIN, vec![], vec![]).is_err());
    }

    #[test]
    fn a_cusp_has_no_curvature_and_the_other_samples_keep_theirs() {
        // (1 − 2t)² and (1 − 2t)³: the cusp is at t = 1/2, far from the origin.
        let third = 1_000.333_333_333_333_4;
        let points = [[1001.0, 101.0], [third, 99.0], [third, 101.0], [1001.0, 99.0]];
        let result = sampled(CurveBasis::BERNSTEIN, &points, 5).unwrap();
        let samples = result.samples();
        assert!(samples[1].curvature.is_some() && samples[3].curvature.is_some());
        assert_eq!(samples[2].curvature, None, "{:?}", samples[2].jet.d1);
    }

    #[test]
    fn a_point_is_no_curve_but_no_panic() {
        let result = sampled(CurveBasis::BERNSTEIN, &[[1.0, 2.0]; 2], 2).unwrap();
        assert!(result.sharpest().is_none() && result.length()[0] == 0.0);
    }

    #[test]
    fn derivatives_beyond_double_precision_are_an_error() {
        let points = [[0.0, 0.0], [1e150, 0.0], [0.0, 1e150], [0.0, 0.0], [1.0, 1.0], [2.0, 2.0]];
        let found = sampled(CurveBasis::at(1e-100).unwrap(), &points, 3);
        assert!(matches!(found, Err(MethodError::Overflow { .. })));
    }

    #[test]
    fn a_circle_has_its_length_and_curvature() {
        let control = std::f64::consts::FRAC_PI_4;
        let (far, high) = (0.378_861_061_722_595_66, 1.273_239_544_735_162_7);
        let points = [[1.0, 0.0], [1.0, control], [far, high], [-far, high], [-1.0, control], [-1.0, 0.0]];
        let result = sampled(CurveBasis::at(std::f64::consts::PI).unwrap(), &points, 21).unwrap();
        assert!((result.length()[0] - std::f64::consts::PI).abs() < 1e-14);
        assert!(result.samples().iter().all(|sample| (sample.curvature.unwrap() - 1.0).abs() < 1e-13));
    }
}

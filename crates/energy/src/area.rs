//! The area of a patch, `∫ √(EG − F²)`.

use bases::GaussLegendre;
use surfaces::{Domain, Jet, Patch, Point, TensorPatch};

use crate::EnergyError;

/// An integral over a patch with what is known of its accuracy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Integral {
    /// The value.
    pub value: f64,
    /// A bound of the error: how far the last doubling of the rule moved the value, plus rounding. While the integral has
    /// not settled, twice the largest of all such moves, each weighed down by 4 for every doubling since: on kinks the
    /// moves fall at that rate, but not evenly, and a single small one means nothing.
    ///
    /// It holds for densities that the smaller rules see: a feature between an end of the domain and the first node,
    /// less than a hundredth of it, is not seen by rules of 8 and 16 points.
    pub error: f64,
    /// Points of the last rule in each direction.
    pub points: usize,
    /// Whether the error fell below the tolerance asked for before the largest rule was reached.
    pub settled: bool,
}

/// Relative change of the area at which the rule is no longer doubled.
pub const AREA_TOLERANCE: f64 = 1e-12;

/// Relative rounding of a density, or of what is squared in one.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

// Smaller rules agree by chance too easily.
const FIRST_RULE: usize = 8;
const LARGEST_RULE: usize = 512;

/// Most terms summed for one rule (points times [`Patch::terms`]): about half a second. A triangular patch of degree 60 is
/// integrated by at most 128² points.
const MOST_TERMS: usize = 1 << 25;

/// The area of a patch by Gauss rules of 8², 16², … points until a doubling moves it by no more than 1e-12 of its
/// value, at most 512² points, and fewer for triangular patches of degree 13 or more (128² at degree 60). Unit: length².
///
/// Smooth immersed patches settle at 16 or 32 points with an error far below the bound, near rounding; folds, where
/// EG − F² touches zero, converge slowly and are then reported as not settled, with the error that remains.
///
/// # Errors
/// [`EnergyError::Basis`] never in fact: all rules used are offered.
pub fn area(patch: &dyn Patch) -> Result<Integral, EnergyError> {
    let [area] = integrate(patch, AREA_TOLERANCE, [0.0], |jet| [jet.area_density()])?;
    Ok(area)
}

/// The integrals of K densities of the jet over the domain of the patch, in one pass, by the same doubling until
/// every one has settled to `tolerance` relative to its value or to its `floor`, whichever is larger.
///
/// The floor says what counts as zero for an integral that may vanish, such as the Laplacian defect of a harmonic
/// patch: a number of the size of what cancels in it. Give 0 for integrals that cannot vanish.
///
/// # Errors
/// [`EnergyError::Basis`] never in fact: all rules used are offered.
pub fn integrate<const K: usize>(
    patch: &dyn Patch,
    tolerance: f64,
    floors: [f64; K],
    densities: impl Fn(&Jet) -> [f64; K],
) -> Result<[Integral; K], EnergyError> {
    let mut points = FIRST_RULE;
    let mut last = by_rule(patch, points, &densities)?;
    let mut moves = [0.0f64; K];
    loop {
        points *= 2;
        let values = by_rule(patch, points, &densities)?;
        let integrals: [Integral; K] = std::array::from_fn(|k| {
            let value = values[k];
            let moved = (value - last[k]).abs();
            // Of the value, and of the square whose parts, of the size of the floor, cancel: (√v + δ)² − v.
            let delta = ROUNDING * floors[k].sqrt();
            let rounding = ROUNDING * value.abs() + delta * (2.0 * value.abs().sqrt() + delta);
            moves[k] = moved.max(0.25 * moves[k]);
            let settled = moved + rounding <= tolerance * value.abs().max(floors[k]);
            // Settled: the last rule is far better than the move to it. Not settled: moves that fall by 4 leave a third of the last one,
            // and twice is for their unevenness.
            let error = if settled { moved } else { 2.0 * moves[k] } + rounding;
            Integral { value, error, points, settled }
        });
        let done = integrals.iter().all(|i| i.settled || !i.value.is_finite());
        if done || points >= LARGEST_RULE || (2 * points).pow(2) * patch.terms() > MOST_TERMS {
            return Ok(integrals);
        }
        last = values;
    }
}

/// `Σ w · density` over the product rule of `points`² points; over a triangle, the rule of the square collapsed onto it.
fn by_rule<const K: usize>(
    patch: &dyn Patch,
    points: usize,
    densities: &impl Fn(&Jet) -> [f64; K],
) -> Result<[f64; K], EnergyError> {
    let unit = GaussLegendre::new(points)?;
    let mut sums = [0.0; K];
    // Line by line: sums of equal lengths, whatever the domain, round less than one long sum.
    let mut add = |w: f64, line: [f64; K]| (0..K).for_each(|k| sums[k] += w * line[k]);
    let line = |jets: &mut dyn Iterator<Item = (f64, Jet)>| {
        let mut line = [0.0; K];
        for (w, jet) in jets {
            let density = densities(&jet);
            (0..K).for_each(|k| line[k] += w * density[k]);
        }
        line
    };
    match patch.domain() {
        Domain::Rectangle { u, v } => {
            let (rule_u, rule_v) = (unit.clone().on(u.0, u.1), unit.on(v.0, v.1));
            let us: Vec<f64> = rule_u.iter().map(|(t, _)| t).collect();
            let vs: Vec<f64> = rule_v.iter().map(|(t, _)| t).collect();
            for (a, row) in patch.jets(&us, &vs).chunks_exact(points).enumerate() {
                add(
                    rule_u.weight(a),
                    line(&mut row.iter().enumerate().map(|(b, jet)| (rule_v.weight(b), *jet))),
                );
            }
        }
        Domain::Triangle => {
            // (s, (1 − s) t): the side s = 1 of the square is shrunk to a point, and the Jacobian is 1 − s.
            for (s, ws) in unit.iter() {
                let jets = &mut unit.iter().map(|(t, wt)| (wt, patch.jet(s, (1.0 - s) * t)));
                add(ws * (1.0 - s), line(jets));
            }
        }
    }
    Ok(sums)
}

/// The area of a tensor patch and its gradient with respect to the coordinates of the net, in the layout of
/// `Net::coordinates`, both by the rule that settled the area.
///
/// `d√(EG−F²) = [(G x_u − F x_v) · dx_u + (E x_v − F x_u) · dx_v] / √(EG−F²)`. Where the patch is singular the density
/// has no gradient and that point contributes none.
///
/// # Errors
/// As [`area()`].
pub fn area_with_gradient(patch: &TensorPatch) -> Result<(Integral, Vec<f64>), EnergyError> {
    let integral = area(patch)?;
    let (rows, cols) = (patch.net().rows(), patch.net().cols());
    let Domain::Rectangle { u, v } = patch.domain() else {
        unreachable!("tensor patches live on rectangles")
    };
    // The gradient is that of the sum which gave the area, not of the exact area: descent then sees one function.
    let unit = GaussLegendre::new(integral.points)?;
    let (rule_u, rule_v) = (unit.clone().on(u.0, u.1), unit.on(v.0, v.1));
    let us: Vec<f64> = rule_u.iter().map(|(t, _)| t).collect();
    let vs: Vec<f64> = rule_v.iter().map(|(t, _)| t).collect();
    let jets = patch.jets(&us, &vs);
    let mut gradient = vec![Point::ZERO; rows * cols];
    for product in patch.products() {
        let g_tables: Vec<_> = vs.iter().map(|&v| product.v.evaluate(v, 1)).collect();
        for (a, &u) in us.iter().enumerate() {
            let f = product.u.evaluate(u, 1);
            let mut along_u = vec![Point::ZERO; cols];
            let mut along_v = vec![Point::ZERO; cols];
            for (b, g) in g_tables.iter().enumerate() {
                let jet = &jets[a * vs.len() + b];
                let (form, density) = (jet.first_form(), jet.area_density());
                if density == 0.0 {
                    continue;
                }
                // What dx_u and dx_v are to be multiplied with. Sums over v first, once a line, then over the rows: O(q² n + q m n).
                let w = rule_u.weight(a) * rule_v.weight(b) / density;
                let du = (jet.u * form.g - jet.v * form.f) * w;
                let dv = (jet.v * form.e - jet.u * form.f) * w;
                for j in 0..cols {
                    along_u[j] += du * g[(0, j)];
                    along_v[j] += dv * g[(1, j)];
                }
            }
            for i in 0..rows {
                for j in 0..cols {
                    gradient[i * cols + j] += along_u[j] * f[(1, i)] + along_v[j] * f[(0, i)];
                }
            }
        }
    }
    Ok((integral, gradient.into_iter().flat_map(<[f64; 3]>::from).collect()))
}

/// The derivative of the area of `patch` when it moves along `direction`, a patch over the same rectangle, by the rule of
/// `points`² points: d/dε of the area of `patch + ε direction` at 0.
///
/// With the derivative of the families by a parameter for `direction` this is the partial derivative of the area by that
/// parameter, the net held. Where the patch is singular that point contributes nothing.
///
/// # Errors
/// [`EnergyError::Basis`] for a rule that is not offered.
pub fn area_derivative(
    patch: &TensorPatch,
    direction: &TensorPatch,
    points: usize,
) -> Result<f64, EnergyError> {
    let [u, v] = patch.rectangle();
    let unit = GaussLegendre::new(points)?;
    let (rule_u, rule_v) = (unit.clone().on(u.0, u.1), unit.on(v.0, v.1));
    let us: Vec<f64> = rule_u.iter().map(|(t, _)| t).collect();
    let vs: Vec<f64> = rule_v.iter().map(|(t, _)| t).collect();
    let (jets, moves) = (patch.jets(&us, &vs), direction.jets(&us, &vs));
    let mut sum = 0.0;
    for (k, (jet, along)) in jets.iter().zip(&moves).enumerate() {
        let (form, density) = (jet.first_form(), jet.area_density());
        if density > 0.0 {
            let by_u = (jet.u * form.g - jet.v * form.f).dot(along.u);
            let by_v = (jet.v * form.e - jet.u * form.f).dot(along.v);
            sum += rule_u.weight(k / points) * rule_v.weight(k % points) * (by_u + by_v) / density;
        }
    }
    Ok(sum)
}

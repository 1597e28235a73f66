//! The truth about the boundary of a tensor patch: how far its curves lie from the Bernstein curves of the net, and the
//! least Dirichlet energy that those curves admit.

use std::sync::Arc;

use bases::{Basis, Bernstein, Lobatto, Matrix, Stacked};
use solve::{Samples, Separable};
use surfaces::{Patch, Point, Product, TensorPatch};

use crate::MethodError;

/// What a comparison of energies needs to know of the boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundaryFigures {
    /// The largest distance, at equal parameters, between a boundary curve of the patch and the Bernstein curve of the
    /// same control points; length.
    pub deviation: f64,
    /// The Dirichlet energy of the harmonic surface over the patch's own boundary curves: no chart with these curves has
    /// less; length².
    pub harmonic_bound: f64,
    /// The error believed of the bound: what the last doubling of the number of functions changed, and rounding.
    pub harmonic_bound_error: f64,
}

/// Relative change at which the bound counts as converged.
const BOUND_TOLERANCE: f64 = 1e-9;
const FIRST_BUBBLES: usize = 16;
const MOST_BUBBLES: usize = 128;

impl BoundaryFigures {
    /// The figures of a patch over the unit square.
    ///
    /// # Errors
    /// Those of the families and of the separable solver.
    pub fn of(patch: &TensorPatch) -> Result<Self, MethodError> {
        let deviation = deviation(patch)?;
        let mut bubbles = FIRST_BUBBLES;
        let mut last = bound_with(patch, bubbles)?;
        loop {
            bubbles *= 2;
            let bound = bound_with(patch, bubbles)?;
            let error = (last - bound).abs() + 1e-13 * bound.abs();
            if error <= BOUND_TOLERANCE * bound.abs() || bubbles >= MOST_BUBBLES {
                return Ok(Self { deviation, harmonic_bound: bound, harmonic_bound_error: error });
            }
            last = bound;
        }
    }
}

/// `min D(E + w)` over w in the span of bubbles ψ_i(u) ψ_j(v), where E is the transfinite Coons patch of the four boundary
/// curves. Decreases to the harmonic minimum as the bubbles grow; for smooth curves with corners, like N⁻⁸.
fn bound_with(patch: &TensorPatch, bubbles: usize) -> Result<f64, MethodError> {
    let u = Direction::new(patch.products().iter().map(|p| &p.u), bubbles)?;
    let v = Direction::new(patch.products().iter().map(|p| &p.v), bubbles)?;
    let net = patch.net();
    let mut x = vec![0.0; 3 * u.count * v.count];
    let mut add = |i: usize, j: usize, p: Point| {
        let at = 3 * (i * v.count + j);
        x[at] += p.x;
        x[at + 1] += p.y;
        x[at + 2] += p.z;
    };
    let [u_ends, v_ends] = patch.rectangle().map(|(start, end)| [start, end]);
    for (s, Product { u: f, v: g }) in patch.products().iter().enumerate() {
        for end in 0..2 {
            let (f_end, g_end) = (f.evaluate(u_ends[end], 0), g.evaluate(v_ends[end], 0));
            for i in 0..net.rows() {
                for j in 0..net.cols() {
                    // ℓ_end(u) times the curve at that end of u, and the same in v.
                    add(end, v.functions[s] + j, net.point(i, j) * f_end[(0, i)]);
                    add(u.functions[s] + i, end, net.point(i, j) * g_end[(0, j)]);
                }
            }
        }
    }
    for a in 0..2 {
        for b in 0..2 {
            add(a, b, -patch.point(u_ends[a], v_ends[b]));
        }
    }
    let separable = Separable::new(&u.samples, &v.samples, &u.bubbles, &v.bubbles)?;
    Ok(separable.solve(&x)?.energy)
}

/// The functions of one direction, sampled: two linear ones, those of every product, and the bubbles.
struct Direction {
    samples: Samples,
    count: usize,
    /// Where the functions of each product begin.
    functions: Vec<usize>,
    bubbles: Vec<usize>,
}

impl Direction {
    fn new<'a>(
        families: impl Iterator<Item = &'a Arc<dyn Basis>>,
        bubbles: usize,
    ) -> Result<Self, MethodError> {
        let mut parts: Vec<Arc<dyn Basis>> = vec![Arc::new(Bernstein::new(1)?)];
        let (mut count, mut functions) = (2, Vec::new());
        for family in families {
            functions.push(count);
            count += family.count();
            parts.push(family.clone());
        }
        parts.push(Arc::new(Lobatto::new(bubbles, (0.0, 1.0))?));
        let free = (count..count + bubbles).collect();
        count += bubbles;
        let family = Stacked::new(parts, Matrix::identity(count))?;
        let samples = bases::Samples::new(&family, bases::Samples::points_for(count), 1)?;
        let samples = Samples {
            points: samples.nodes().len(),
            functions: count,
            weights: samples.weights().to_vec(),
            values: samples.order(0).as_slice().to_vec(),
            derivatives: samples.order(1).as_slice().to_vec(),
        };
        Ok(Self { samples, count, functions, bubbles: free })
    }
}

/// The largest distance between the boundary curves of the patch and the Bernstein curves of its net.
fn deviation(patch: &TensorPatch) -> Result<f64, MethodError> {
    const SAMPLES: usize = 128;
    let bernstein = TensorPatch::bernstein(patch.net().clone())?;
    let [(u0, u1), (v0, v1)] = patch.rectangle();
    let mut largest = 0.0f64;
    for side in 0..4 {
        let distance = |t: f64| {
            let (u, v, s, r) = match side {
                0 => (u0, v0 + t * (v1 - v0), 0.0, t),
                1 => (u1, v0 + t * (v1 - v0), 1.0, t),
                2 => (u0 + t * (u1 - u0), v0, t, 0.0),
                _ => (u0 + t * (u1 - u0), v1, t, 1.0),
            };
            patch.point(u, v).distance(bernstein.point(s, r))
        };
        let at = |k: usize| k as f64 / SAMPLES as f64;
        let best =
            (0..=SAMPLES).map(|k| (distance(at(k)), k)).fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a });
        largest = largest.max(best.0).max(refine(
            &distance,
            at(best.1.saturating_sub(1)),
            at((best.1 + 1).min(SAMPLES)),
        ));
    }
    Ok(largest)
}

/// The largest value of a function with one maximum on `[low, high]`, by golden sections.
fn refine(f: &impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let mut best = 0.0f64;
    for _ in 0..40 {
        let (a, b) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
        let (fa, fb) = (f(a), f(b));
        best = best.max(fa).max(fb);
        if fa > fb { high = b } else { low = a }
    }
    best
}

//! The second variation of the area under normal displacements.

use surfaces::{Jet, Patch};

use super::assembly::{Assembly, Unknowns};
use super::descent::Descent;
use super::rules::Known;
use super::space::Space;
use crate::MethodError;
use solve::{SolveError, smallest_eigenpair};

/// Steps of Lanczos' method at most.
const LANCZOS: usize = 80;

/// Evenness (least over mean of the area densities) below which curvature at the points of a rule is rounding.
const EVEN: f64 = 1e-7;

/// Multiples of this are spread evenly modulo 1.
const GOLDEN: f64 = 0.618_033_988_749_895;

/// The smallest second variation with the displacement along the normals that has it: a number a node, 0 where none may move.
#[derive(Debug, Clone)]
pub(super) struct Variation {
    pub(super) smallest: f64,
    pub(super) displacement: Vec<f64>,
}

impl<S: Space> Descent<'_, '_, S> {
    /// The smallest value of `∫ (|∇f|² + 2 K f²) dA / ∫ |∇f|² dA`; none if no node is free, or where the surface is singular
    /// or nearly, so that its curvature is rounding. Where three cells meet no f is the same on all of them but 0: such lines are held. A one-sided
    /// surface has no normal that f could go along.
    pub(super) fn variation(&mut self, here: &Known) -> Result<Option<Variation>, MethodError> {
        let space = self.rules.space;
        let topology = &space.topology().with_joints_held();
        let scalar = Unknowns::scalar(topology)?;
        if scalar.count() == 0 || topology.flipped.is_none() {
            return Ok(None);
        }
        let (cell, tangents) = self.rough(here)?;
        let assembly = Assembly { topology, cell: cell.as_ref() };
        let (_, ratio) = assembly.measure(&tangents);
        if ratio.is_nan() || ratio <= EVEN {
            return Ok(None);
        }
        let parameters = cell.parameters();
        let mut curvatures = Vec::with_capacity(topology.cells.len());
        for (k, patch) in space.patches(&here.x)?.iter().enumerate() {
            let mut factors = Vec::with_capacity(parameters.len());
            for (jet, w) in jets(patch.as_ref(), &parameters).iter().zip(cell.weights()) {
                let Some(curvature) = curvature(jet) else { return Ok(None) };
                factors.push(2.0 * w * curvature * jet.area_density());
            }
            curvatures.push(cell.mass(&topology.free(k), &factors));
        }
        let metrics = assembly.metrics(&tangents)?;
        let factor = match scalar.condensation().factor(&metrics) {
            Ok(factor) => factor,
            Err(SolveError::NotPositiveDefinite { .. }) => return Ok(None),
            Err(error) => return Err(error.into()),
        };
        let cells: Vec<Vec<usize>> = (0..topology.cells.len()).map(|k| scalar.indices(topology, k)).collect();
        let product = |matrices: &mut dyn Iterator<Item = &[f64]>, vector: &[f64]| {
            let mut out = vec![0.0; vector.len()];
            for (matrix, indices) in matrices.zip(&cells) {
                let local: Vec<f64> = indices.iter().map(|&k| vector[k]).collect();
                for (row, &k) in matrix.chunks_exact(indices.len().max(1)).zip(indices) {
                    out[k] += row.iter().zip(&local).map(|(a, x)| a * x).sum::<f64>();
                }
            }
            out
        };
        let apply = |f: &[f64]| {
            Ok([
                product(&mut curvatures.iter().map(|m| m.as_slice()), f),
                product(&mut metrics.iter().map(Vec::as_slice), f),
            ])
        };
        let invert = |mut f: Vec<f64>| factor.solve(1, &mut f).map(|()| f);
        // Without any symmetry, so that none of the displacements is missed.
        let start: Vec<f64> = (0..scalar.count()).map(|k| 1.0 + (k as f64 * GOLDEN).fract()).collect();
        let found = smallest_eigenpair(&start, LANCZOS, apply, invert)?;
        Ok(found.map(|pair| {
            let mut displacement = vec![0.0; topology.fixed.len()];
            let free = displacement.iter_mut().zip(&topology.fixed).filter(|(_, fixed)| !**fixed);
            free.zip(pair.vector).for_each(|((f, _), value)| *f = value);
            Variation { smallest: 1.0 + pair.value, displacement }
        }))
    }
}

/// The jets of a patch at the points of a rule.
fn jets(patch: &dyn Patch, parameters: &[[f64; 2]]) -> Vec<Jet> {
    let lines = (parameters.len() as f64).sqrt() as usize;
    let grid = |k: usize| {
        parameters[k][0] == parameters[k / lines * lines][0] && parameters[k][1] == parameters[k % lines][1]
    };
    if lines * lines == parameters.len() && (0..parameters.len()).all(grid) {
        let us: Vec<f64> = parameters.iter().step_by(lines).map(|[u, _]| *u).collect();
        let vs: Vec<f64> = parameters[..lines].iter().map(|[_, v]| *v).collect();
        return patch.jets(&us, &vs);
    }
    parameters.iter().map(|&[u, v]| patch.jet(u, v)).collect()
}

/// The Gauss curvature, 0 where what bends the surface is rounding of its second derivatives.
fn curvature(jet: &Jet) -> Option<f64> {
    let form = jet.second_form()?;
    let size = jet.uu.norm().max(jet.uv.norm()).max(jet.vv.norm());
    let density = jet.area_density();
    // The normal is known to ε |x_u||x_v|/√(EG − F²).
    let rounding = 64.0 * f64::EPSILON * size * (1.0 + jet.u.norm() * jet.v.norm() / density);
    if form.l.abs().max(form.m.abs()).max(form.n.abs()) <= rounding {
        return Some(0.0);
    }
    jet.gauss_curvature()
}

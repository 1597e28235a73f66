//! The area of a surface of cells and its derivatives by a rule, and the systems of its Newton steps.

use bases::Matrix;
use energy::{Cell, EnergyError, Freedom};
use solve::{Condensation, SolveError};
use surfaces::Point;

use super::space::Topology;
use crate::MethodError;

/// The tangents (x_u, x_v) of every cell at the points of a rule.
pub(super) type Tangents = Vec<Vec<[Point; 2]>>;

/// Points summed before their sum is added to that of others.
const LINE: usize = 32;

/// The cells of a surface at one rule.
#[derive(Clone, Copy)]
pub(super) struct Assembly<'a> {
    pub(super) topology: &'a Topology,
    pub(super) cell: &'a dyn Cell,
}

impl Assembly<'_> {
    pub(super) fn tangents(&self, x: &[Point]) -> Tangents {
        (0..self.topology.cells.len()).map(|k| self.cell.tangents(&self.topology.of_cell(k, x))).collect()
    }

    pub(super) fn area_of(&self, tangents: &Tangents) -> f64 {
        tangents.iter().map(|tangents| self.cell.area(tangents)).sum()
    }

    /// The derivative of the area by every node; 0 at fixed ones.
    pub(super) fn gradient(&self, tangents: &Tangents) -> Result<Vec<Point>, EnergyError> {
        let mut sums = vec![Point::ZERO; self.topology.fixed.len()];
        for (k, tangents) in tangents.iter().enumerate() {
            self.topology.add(k, &self.cell.area_gradient(tangents)?, &mut sums);
        }
        Ok(sums)
    }

    /// `∫ ∇x · ∇ψ` in the metric of the form (a, b, c), the same at all points.
    pub(super) fn pull(&self, tangents: &Tangents, [a, b, c]: [f64; 3]) -> Vec<Point> {
        let mut sums = vec![Point::ZERO; self.topology.fixed.len()];
        for (k, tangents) in tangents.iter().enumerate() {
            let pairs: Vec<[Point; 2]> = tangents
                .iter()
                .zip(self.cell.weights())
                .map(|(&[x_u, x_v], &w)| [(x_u * a + x_v * b) * w, (x_u * b + x_v * c) * w])
                .collect();
            self.topology.add(k, &self.cell.adjoint(&pairs), &mut sums);
        }
        sums
    }

    /// The area, and the least over the mean of its densities.
    pub(super) fn measure(&self, tangents: &Tangents) -> (f64, f64) {
        let (mut least, mut area, mut weight) = (f64::INFINITY, 0.0, 0.0);
        let weights = self.cell.weights();
        let of_cell: f64 = weights.iter().sum();
        for tangents in tangents {
            let mut of_lines = 0.0;
            // By lines of a few points, so that rounding grows like the root of their number at most.
            for (line, weights) in tangents.chunks(LINE).zip(weights.chunks(LINE)) {
                let mut sum = 0.0;
                for ([x_u, x_v], w) in line.iter().zip(weights) {
                    let density = x_u.cross(*x_v).norm();
                    least = least.min(density);
                    sum += w * density;
                }
                of_lines += sum;
            }
            area += of_lines;
            weight += of_cell;
        }
        // The mean is area / weight: the quotient has no unit, nor does it depend on the interval of the parameters.
        (area, if area > 0.0 { least * weight / area } else { 0.0 })
    }

    /// `dᵀ K d` in the metric of the surface with these tangents.
    pub(super) fn metric_square(&self, tangents: &Tangents, d: &[Point]) -> Result<f64, EnergyError> {
        let mut sum = 0.0;
        for (moved, tangents) in self.tangents(d).iter().zip(tangents) {
            for ([d_u, d_v], [a, b, c]) in moved.iter().zip(self.cell.metric_forms(tangents)?) {
                sum += a * d_u.dot(*d_u) + 2.0 * b * d_u.dot(*d_v) + c * d_v.dot(*d_v);
            }
        }
        Ok(sum)
    }

    /// The Dirichlet products of the free nodes of every cell in the metric of the surface.
    pub(super) fn metrics(&self, tangents: &Tangents) -> Result<Vec<Vec<f64>>, EnergyError> {
        let of = |(k, tangents): (usize, &Vec<[Point; 2]>)| {
            Ok(self.cell.metric(&self.topology.free(k), tangents)?.as_slice().to_vec())
        };
        tangents.iter().enumerate().map(of).collect()
    }

    /// The same for the form (a, b, c) at all points: one matrix a cell.
    pub(super) fn stiffnesses(&self, form: [f64; 3]) -> Vec<Vec<f64>> {
        let forms: Vec<[f64; 3]> = self.cell.weights().iter().map(|w| form.map(|a| w * a)).collect();
        let of = |k| self.cell.stiffness(&self.topology.free(k), &forms).as_slice().to_vec();
        (0..self.topology.cells.len()).map(of).collect()
    }
}

/// The unknowns of the nodes of a surface.
pub(super) struct Unknowns {
    /// How every node may move.
    freedoms: Vec<Freedom>,
    /// The first unknown of every node.
    first: Vec<usize>,
    condensation: Condensation,
}

impl Unknowns {
    pub(super) fn new(topology: &Topology, freedoms: Vec<Freedom>) -> Result<Self, SolveError> {
        let (mut first, mut count) = (Vec::with_capacity(freedoms.len()), 0);
        for freedom in &freedoms {
            first.push(count);
            count += freedom.directions().len();
        }
        // Nodes of the skeleton come first, hence their unknowns, too.
        let skeleton = first.get(topology.skeleton).copied().unwrap_or(count);
        let of_node = |&node: &usize| first[node]..first[node] + freedoms[node].directions().len();
        let cells: Vec<Vec<usize>> =
            topology.cells.iter().map(|cell| cell.iter().flat_map(of_node).collect()).collect();
        let condensation = Condensation::new(count, skeleton, &cells)?;
        Ok(Self { freedoms, first, condensation })
    }

    /// Three unknowns for every free node.
    pub(super) fn all(topology: &Topology) -> Result<Self, SolveError> {
        let freedom = |fixed: &bool| if *fixed { Freedom::Fixed } else { Freedom::Free };
        Self::new(topology, topology.fixed.iter().map(freedom).collect())
    }

    /// One unknown for every free node, whatever its direction: those of a function.
    pub(super) fn scalar(topology: &Topology) -> Result<Self, SolveError> {
        let along = Freedom::Along(Point::new(1.0, 0.0, 0.0));
        let freedom = |fixed: &bool| if *fixed { Freedom::Fixed } else { along };
        Self::new(topology, topology.fixed.iter().map(freedom).collect())
    }

    pub(super) fn count(&self) -> usize {
        self.condensation.unknowns()
    }

    pub(super) fn condensation(&self) -> &Condensation {
        &self.condensation
    }

    /// The unknowns of a cell, node after node.
    pub(super) fn indices(&self, topology: &Topology, cell: usize) -> Vec<usize> {
        let of = |&node: &usize| self.first[node]..self.first[node] + self.freedoms[node].directions().len();
        topology.cells[cell].iter().flat_map(of).collect()
    }

    /// How the nodes of a cell may move.
    pub(super) fn of_cell(&self, topology: &Topology, cell: usize) -> Vec<Freedom> {
        topology.cells[cell].iter().map(|&node| self.freedoms[node]).collect()
    }

    /// The parts of vectors at the nodes along the unknowns.
    pub(super) fn gather(&self, vectors: &[Point]) -> Vec<f64> {
        let parts = self.freedoms.iter().zip(vectors);
        parts.flat_map(|(freedom, v)| freedom.directions().iter().map(|d| d.dot(*v))).collect()
    }

    /// The displacements of the nodes.
    pub(super) fn scatter(&self, unknowns: &[f64]) -> Vec<Point> {
        let of = |(freedom, &first): (&Freedom, &usize)| {
            let parts = freedom.directions().iter().zip(&unknowns[first.min(unknowns.len())..]);
            parts.fold(Point::ZERO, |sum, (&d, &c)| sum + d * c)
        };
        self.freedoms.iter().zip(&self.first).map(of).collect()
    }

    /// The Hessian of every cell in these unknowns, written over those of other surfaces.
    pub(super) fn hessians(
        &self,
        assembly: &Assembly<'_>,
        tangents: &Tangents,
        hessians: &mut Vec<Matrix>,
    ) -> Result<(), EnergyError> {
        hessians.resize(tangents.len(), Matrix::zeros(0, 0));
        for (k, (tangents, hessian)) in tangents.iter().zip(hessians).enumerate() {
            assembly.cell.hessian_into(&self.of_cell(assembly.topology, k), tangents, hessian)?;
        }
        Ok(())
    }

    /// `H + λK` of every cell, given the Hessians and λ with the metrics over the free nodes, written over other matrices.
    pub(super) fn shifted(
        &self,
        topology: &Topology,
        hessians: &[Matrix],
        (factor, metrics): (f64, &[Vec<f64>]),
        shifted: &mut Vec<Vec<f64>>,
    ) {
        shifted.resize(hessians.len(), Vec::new());
        for (shifted, hessian) in shifted.iter_mut().zip(hessians) {
            shifted.clear();
            shifted.extend_from_slice(hessian.as_slice());
        }
        if factor > 0.0 {
            self.add_metrics(topology, factor, metrics, shifted);
        }
    }

    /// Adds `factor` times the Dirichlet product of displacements, the metrics over the free nodes of each cell, to matrices
    /// in these unknowns.
    pub(super) fn add_metrics(
        &self,
        topology: &Topology,
        factor: f64,
        metrics: &[Vec<f64>],
        matrices: &mut [Vec<f64>],
    ) {
        for (cell, (metric, matrix)) in metrics.iter().zip(matrices).enumerate() {
            let moving: Vec<Freedom> =
                self.of_cell(topology, cell).into_iter().filter(|f| *f != Freedom::Fixed).collect();
            let nodes = moving.len();
            let size: usize = moving.iter().map(|freedom| freedom.directions().len()).sum();
            if moving.iter().all(|freedom| *freedom == Freedom::Free) {
                // The same entry for each coordinate.
                for (row, line) in matrix.chunks_exact_mut(size.max(1)).enumerate() {
                    let entries = metric[row / 3 * nodes..][..nodes].iter();
                    line[row % 3..]
                        .iter_mut()
                        .step_by(3)
                        .zip(entries)
                        .for_each(|(out, k)| *out += factor * k);
                }
                continue;
            }
            let mut row = 0;
            for (k, first) in moving.iter().enumerate() {
                for d in first.directions() {
                    let mut column = 0;
                    for (l, second) in moving.iter().enumerate() {
                        // (d ψ, e χ) = (d · e) (ψ, χ): K acts on each coordinate by itself.
                        let entry = factor * metric[k * nodes + l];
                        for e in second.directions() {
                            matrix[row * size + column] += entry * d.dot(*e);
                            column += 1;
                        }
                    }
                    row += 1;
                }
            }
        }
    }
}

/// Solves a scalar system for the three coordinates of vectors at the nodes.
pub(super) fn solve_vectors(
    scalar: &Unknowns,
    matrices: &[Vec<f64>],
    vectors: &[Point],
) -> Result<Vec<Point>, MethodError> {
    let factor = scalar.condensation.factor(matrices)?;
    let moving = || scalar.freedoms.iter().zip(vectors).filter(|(freedom, _)| **freedom != Freedom::Fixed);
    let mut rhs: Vec<f64> = moving().flat_map(|(_, &v)| <[f64; 3]>::from(v)).collect();
    factor.solve(3, &mut rhs)?;
    let mut solved = rhs.chunks_exact(3).map(|c| Point::new(c[0], c[1], c[2]));
    let of = |freedom: &Freedom| match freedom {
        Freedom::Fixed => Point::ZERO,
        Freedom::Along(_) | Freedom::Free => solved.next().unwrap_or(Point::ZERO),
    };
    Ok(scalar.freedoms.iter().map(of).collect())
}

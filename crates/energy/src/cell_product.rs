//! Cells of products of functions of one variable, by sum factorisation.

use std::borrow::Cow;
use std::sync::OnceLock;

use bases::{Basis, GaussLegendre, Matrix};
use surfaces::Point;

use crate::area_hessian::Density;
use crate::cell::{Cell, Freedom, numbered};
use crate::cell_contraction::{Fields, Pairs, Range, Samples};
use crate::cell_evaluation::Evaluation;
use crate::product::{add_product, mirror, mirrored};
use crate::{EnergyError, SampledCell};

/// A cell whose functions are `f_i(u) g_j(v)`, node (i, j) at `i · columns + j`, at a product rule.
///
/// With m × n nodes and q² points a Hessian costs O(q m² n²): sums over v are formed once for every line of constant u,
/// where summing over all points would cost O(q² m² n²).
#[derive(Debug, Clone)]
pub struct ProductCell {
    u: Line,
    v: Line,
    weights: Vec<f64>,
    evaluation: Evaluation,
    /// Products of pairs of functions over the window that was asked for first.
    pairs: OnceLock<Pairs>,
}

/// The functions of one variable at points: points × functions.
#[derive(Debug, Clone)]
struct Line {
    nodes: Vec<f64>,
    values: Matrix,
    slopes: Matrix,
}

impl Line {
    fn new(family: &dyn Basis, nodes: Vec<f64>) -> Self {
        let count = family.count();
        let mut table = vec![0.0; 2 * count];
        let (mut values, mut slopes) = (Matrix::zeros(nodes.len(), count), Matrix::zeros(nodes.len(), count));
        for (p, &t) in nodes.iter().enumerate() {
            family.evaluate_into(t, 1, &mut table);
            values.row_mut(p).copy_from_slice(&table[..count]);
            slopes.row_mut(p).copy_from_slice(&table[count..]);
        }
        Self { nodes, values, slopes }
    }

    fn samples(&self) -> Samples<'_> {
        Samples { values: &self.values, slopes: &self.slopes }
    }

    fn points(&self) -> usize {
        self.nodes.len()
    }

    fn functions(&self) -> usize {
        self.values.cols()
    }
}

impl ProductCell {
    /// The products of `u` and `v` at the Gauss rule of `points`² points.
    ///
    /// # Errors
    /// [`EnergyError::Basis`] for a rule that is not offered.
    pub fn new(u: &dyn Basis, v: &dyn Basis, points: usize) -> Result<Self, EnergyError> {
        let unit = GaussLegendre::new(points)?;
        let rule = |family: &dyn Basis| {
            let (start, end) = family.domain();
            let rule = unit.clone().on(start, end);
            rule.iter().unzip::<f64, f64, Vec<f64>, Vec<f64>>()
        };
        let ((us, wu), (vs, wv)) = (rule(u), rule(v));
        let weights = wu.iter().flat_map(|a| wv.iter().map(move |b| a * b)).collect();
        Ok(Self::over(Line::new(u, us), Line::new(v, vs), weights))
    }

    /// The products of `u` and `v` at the grid of parameters `us` × `vs`, all weights 1: no rule, but a place to look at
    /// the surface.
    pub fn at(u: &dyn Basis, v: &dyn Basis, us: &[f64], vs: &[f64]) -> Self {
        let weights = vec![1.0; us.len() * vs.len()];
        Self::over(Line::new(u, us.to_vec()), Line::new(v, vs.to_vec()), weights)
    }

    fn over(u: Line, v: Line, weights: Vec<f64>) -> Self {
        Self {
            evaluation: Evaluation::new([u.samples(), v.samples()]),
            pairs: OnceLock::new(),
            u,
            v,
            weights,
        }
    }

    /// `x` at the points.
    pub(crate) fn place(&self, x: &[Point]) -> Vec<Point> {
        // With values for derivatives, both tangents are the point itself.
        let values = self.samples().map(|of| Samples { values: of.values, slopes: of.values });
        let places = Evaluation::new(values).tangents(x);
        places.into_iter().map(|[place, _]| place).collect()
    }

    /// The parameters of the rule in u and in v.
    pub fn grid(&self) -> [&[f64]; 2] {
        [&self.u.nodes, &self.v.nodes]
    }

    /// The smallest ranges of rows and columns that hold all nodes wanted.
    fn window(&self, wanted: impl Fn(usize) -> bool) -> [Range; 2] {
        // Fixed nodes are mostly those of the rim: without their rows and columns the sums are as small as the unknowns.
        let columns = self.v.functions();
        let of = |place: &dyn Fn(usize) -> usize| {
            let places = || (0..self.nodes()).filter(|&node| wanted(node)).map(place);
            places().min().unwrap_or(0)..places().max().map_or(0, |last| last + 1)
        };
        [of(&|node| node / columns), of(&|node| node % columns)]
    }

    fn samples(&self) -> [Samples<'_>; 2] {
        [self.u.samples(), self.v.samples()]
    }
}

/// Products `f_i g_k` at the points: columns (i, k), k ≤ i.
fn products(left: &Matrix, right: &Matrix, range: &Range) -> Matrix {
    let columns: Vec<(usize, usize)> =
        range.clone().flat_map(|i| (range.start..=i).map(move |k| (i, k))).collect();
    Matrix::from_fn(left.rows(), columns.len(), |p, c| left[(p, columns[c].0)] * right[(p, columns[c].1)])
}

/// Place of (i, k), k ≤ i, among the halved pairs.
fn place(i: usize, k: usize) -> usize {
    let (i, k) = (i.max(k), i.min(k));
    i * (i + 1) / 2 + k
}

/// Symmetric components (α, β) of a 3 × 3 block in the order in which they are summed.
const SYMMETRIC: [[usize; 3]; 3] = [[0, 1, 2], [1, 3, 4], [2, 4, 5]];
const ENTRIES: [(usize, usize); 6] = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];

impl Cell for ProductCell {
    fn nodes(&self) -> usize {
        self.u.functions() * self.v.functions()
    }

    fn weights(&self) -> &[f64] {
        &self.weights
    }

    fn parameters(&self) -> Vec<[f64; 2]> {
        self.u.nodes.iter().flat_map(|&u| self.v.nodes.iter().map(move |&v| [u, v])).collect()
    }

    fn tangents(&self, x: &[Point]) -> Vec<[Point; 2]> {
        self.evaluation.tangents(x)
    }

    fn adjoint(&self, pairs: &[[Point; 2]]) -> Vec<Point> {
        self.evaluation.adjoint(pairs)
    }

    fn stiffness(&self, wanted: &[bool], forms: &[[f64; 3]]) -> Matrix {
        let window = self.window(|node| wanted[node]);
        let index = numbered(wanted.iter().map(|w| usize::from(*w)));
        let mut matrix = Matrix::zeros(index.1, index.1);
        let field = |k: usize| forms.iter().map(|form| form[k]).collect::<Vec<f64>>();
        // One component: the form (a, b, c) at a point weighs ∂u∂u, ∂u∂v + ∂v∂u and ∂v∂v.
        let fields = Fields { symmetric: 1, full: 1, uu: field(0), vv: field(2), uv: field(1) };
        let (columns, width) = (self.v.functions(), window[1].len());
        let node = |i: usize, j: usize| (window[0].start + i) * columns + window[1].start + j;
        self.pairs(&window).contract(&fields, |i, k, sums| {
            for l in (0..width).filter(|&l| wanted[node(k, l)]) {
                let row = matrix.row_mut(index.0[node(k, l)]);
                // For i = k the sums hold (j, l) and (l, j): only j ≥ l is wanted. For i > k every j.
                for j in (if k < i { 0 } else { l }..width).filter(|&j| wanted[node(i, j)]) {
                    row[index.0[node(i, j)]] = sums.symmetric(0, l)[j] + sums.full(0, l)[j];
                }
            }
        });
        mirrored(matrix)
    }

    fn mass(&self, wanted: &[bool], factors: &[f64]) -> Matrix {
        let window = self.window(|node| wanted[node]);
        let index = numbered(wanted.iter().map(|w| usize::from(*w)));
        let (g, f) = (&self.v.values, &self.u.values);
        let (of_u, of_v) = (products(f, f, &window[0]), products(g, g, &window[1]));
        // Points of v × points of u: products sum over the rows of both factors.
        let by_v = Matrix::from_fn(self.v.points(), self.u.points(), |b, a| factors[a * self.v.points() + b]);
        let mut lines = Matrix::zeros(self.u.points(), of_v.cols());
        add_product(&mut lines, &by_v, &of_v);
        let mut sums = Matrix::zeros(of_u.cols(), of_v.cols());
        add_product(&mut sums, &of_u, &lines);
        let columns = self.v.functions();
        let mut matrix = Matrix::zeros(index.1, index.1);
        let nodes: Vec<usize> = (0..self.nodes()).filter(|&node| wanted[node]).collect();
        for &p in &nodes {
            for &q in &nodes {
                let at = |node: usize| (node / columns - window[0].start, node % columns - window[1].start);
                let ((i, j), (k, l)) = (at(p), at(q));
                matrix[(index.0[p], index.0[q])] = sums[(place(i, k), place(j, l))];
            }
        }
        matrix
    }

    fn hessian_into(
        &self,
        freedoms: &[Freedom],
        tangents: &[[Point; 2]],
        matrix: &mut Matrix,
    ) -> Result<(), EnergyError> {
        let window = self.window(|node| freedoms[node] != Freedom::Fixed);
        let (index, size) = numbered(freedoms.iter().map(|freedom| freedom.directions().len()));
        let fields = self.hessian_fields(tangents)?;
        // Not cleared: every entry of the upper triangle is set once, then mirrored.
        if (matrix.rows(), matrix.cols()) != (size, size) {
            *matrix = Matrix::zeros(size, size);
        }
        let (columns, width) = (self.v.functions(), window[1].len());
        let node = |i: usize, j: usize| (window[0].start + i) * columns + window[1].start + j;
        // Rows of nodes that move in all three directions have their entries side by side: they are filled without asking each node.
        let is_free = |i: usize| (0..width).all(|j| freedoms[node(i, j)] == Freedom::Free);
        let free: Vec<bool> = (0..window[0].len()).map(is_free).collect();
        self.pairs(&window).contract(&fields, |i, k, sums| {
            for l in 0..width {
                // (k, l) gives the rows and (i, j) ≥ (k, l), in the order of the nodes, the columns: the upper triangle.
                let from = if k < i { 0 } else { l };
                let first = index[node(k, l)];
                if free[i] && free[k] {
                    for b in 0..3 {
                        let start = index[node(i, from)];
                        let row = &mut matrix.row_mut(first + b)[start..];
                        for a in 0..3 {
                            let (same, mixed) = (sums.symmetric(SYMMETRIC[a][b], l), sums.full(3 * a + b, l));
                            let entries = same.iter().zip(mixed).skip(from);
                            // The unknowns of a node follow one another: coordinate a of node j at 3 j + a.
                            row.iter_mut()
                                .skip(a)
                                .step_by(3)
                                .zip(entries)
                                .for_each(|(out, (s, f))| *out = s + f);
                        }
                    }
                    continue;
                }
                let rows = freedoms[node(k, l)].directions();
                for j in from..width {
                    let columns = freedoms[node(i, j)].directions();
                    if rows.is_empty() || columns.is_empty() {
                        continue;
                    }
                    let entry = |a: usize, b: usize| {
                        sums.symmetric(SYMMETRIC[a][b], l)[j] + sums.full(3 * a + b, l)[j]
                    };
                    let block = std::array::from_fn(|a| std::array::from_fn(|b| entry(a, b)));
                    project(matrix, [first, index[node(i, j)]], &block, rows, columns);
                }
            }
        });
        mirror(matrix);
        Ok(())
    }
}

impl ProductCell {
    /// The products of pairs of functions over a window.
    fn pairs(&self, window: &[Range; 2]) -> Cow<'_, Pairs> {
        // Hessians ask for the same window step after step: it is tabulated once. Another window is rare and pays for itself.
        let first = self.pairs.get_or_init(|| Pairs::new(self.samples(), window.clone()));
        match first.window() == window {
            true => Cow::Borrowed(first),
            false => Cow::Owned(Pairs::new(self.samples(), window.clone())),
        }
    }

    /// The second derivatives of the area density by the tangents, weighted.
    fn hessian_fields(&self, tangents: &[[Point; 2]]) -> Result<Fields, EnergyError> {
        let (lines, q) = (self.u.points(), self.v.points());
        let mut fields = Fields::zeros(6, 9, lines, q);
        for (p, (&[x_u, x_v], &w)) in tangents.iter().zip(&self.weights).enumerate() {
            let density = Density::new(x_u, x_v).ok_or_else(|| self.singular(p))?;
            let (a, b, h) = (p / q, p % q, &density.hessian);
            for (c, (alpha, beta)) in ENTRIES.into_iter().enumerate() {
                let at = (6 * a + c) * q + b;
                fields.uu[at] = w * h[alpha][beta];
                fields.vv[at] = w * h[3 + alpha][3 + beta];
            }
            for c in 0..9 {
                fields.uv[(9 * a + c) * q + b] = w * h[c / 3][3 + c % 3];
            }
        }
        Ok(fields)
    }
}

/// Writes `eᵀ blockᵀ d` for the directions d of one node (columns of `matrix`) and e of another (rows).
fn project(matrix: &mut Matrix, at: [usize; 2], block: &[[f64; 3]; 3], rows: &[Point], columns: &[Point]) {
    if rows.len() == 3 && columns.len() == 3 {
        for b in 0..3 {
            for a in 0..3 {
                matrix[(at[0] + b, at[1] + a)] = block[a][b];
            }
        }
        return;
    }
    let lines = block.map(|line| Point::new(line[0], line[1], line[2]));
    for (q, e) in rows.iter().enumerate() {
        let image = Point::new(lines[0].dot(*e), lines[1].dot(*e), lines[2].dot(*e));
        for (p, d) in columns.iter().enumerate() {
            matrix[(at[0] + q, at[1] + p)] = d.dot(image);
        }
    }
}

impl ProductCell {
    /// The same cell by its samples.
    ///
    /// # Errors
    /// [`EnergyError::Shape`] never in fact.
    pub fn sampled(&self) -> Result<SampledCell, EnergyError> {
        let (q, n) = (self.v.points(), self.v.functions());
        let table = |f: &Matrix, g: &Matrix| {
            Matrix::from_fn(self.weights.len(), self.nodes(), |p, k| f[(p / q, k / n)] * g[(p % q, k % n)])
        };
        let (u, v) = (&self.u, &self.v);
        let derivatives = [table(&u.slopes, &v.values), table(&u.values, &v.slopes)];
        SampledCell::new(self.parameters(), self.weights.clone(), table(&u.values, &v.values), derivatives)
    }
}

//! Cells of products of functions of one variable, by sum factorisation.

use bases::{Basis, GaussLegendre, Matrix};
use pulp::{Arch, WithSimd};
use surfaces::Point;

use crate::area_hessian::Density;
use crate::cell::{Cell, Freedom};
use crate::product::{add_product, mirrored};
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
}

/// The functions of one variable at points: points × functions.
#[derive(Debug, Clone)]
struct Line {
    nodes: Vec<f64>,
    values: Matrix,
    slopes: Matrix,
    /// The same, functions × points.
    values_by_function: Vec<f64>,
    slopes_by_function: Vec<f64>,
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
        let [values_by_function, slopes_by_function] =
            [&values, &slopes].map(|table| table.transpose().as_slice().to_vec());
        Self { nodes, values, slopes, values_by_function, slopes_by_function }
    }

    fn points(&self) -> usize {
        self.nodes.len()
    }

    fn functions(&self) -> usize {
        self.values.cols()
    }
}

/// A range of functions of one variable.
type Range = std::ops::Range<usize>;

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
        Ok(Self { u: Line::new(u, us), v: Line::new(v, vs), weights })
    }

    /// The products of `u` and `v` at the grid of parameters `us` × `vs`, all weights 1: no rule, but a place to look at
    /// the surface.
    pub fn at(u: &dyn Basis, v: &dyn Basis, us: &[f64], vs: &[f64]) -> Self {
        let weights = vec![1.0; us.len() * vs.len()];
        Self { u: Line::new(u, us.to_vec()), v: Line::new(v, vs.to_vec()), weights }
    }

    /// The parameters of the rule in u and in v.
    pub fn grid(&self) -> [&[f64]; 2] {
        [&self.u.nodes, &self.v.nodes]
    }

    /// The smallest ranges of rows and columns that hold all nodes wanted.
    fn window(&self, wanted: impl Fn(usize) -> bool) -> [Range; 2] {
        let columns = self.v.functions();
        let of = |place: &dyn Fn(usize) -> usize| {
            let places = || (0..self.nodes()).filter(|&node| wanted(node)).map(place);
            places().min().unwrap_or(0)..places().max().map_or(0, |last| last + 1)
        };
        [of(&|node| node / columns), of(&|node| node % columns)]
    }

    /// `Σ_b h_b(a, c) g_j^(r) g_l^(s)` for lines a and components c: row a, column (c, jl).
    fn along_v(&self, components: usize, fields: &[f64], pairs: &Matrix) -> Matrix {
        let (lines, q) = (self.u.points(), self.v.points());
        let columns = lines * components;
        let left = Matrix::from_fn(q, columns, |b, at| {
            let (a, c) = (at / components, at % components);
            fields[(a * q + b) * components + c]
        });
        let mut sum = Matrix::zeros(columns, pairs.cols());
        add_product(&mut sum, &left, pairs);
        let (width, data) = (components * pairs.cols(), sum.as_slice());
        Matrix::from_fn(lines, width, |a, k| data[a * width + k])
    }
}

/// Products `f_i^(r) f_k^(s)` at the points: columns (i, k), all of them or those with k ≤ i.
fn pairs(left: &Matrix, right: &Matrix, range: &Range, halved: bool) -> Matrix {
    let columns: Vec<(usize, usize)> = range
        .clone()
        .flat_map(|i| (range.start..if halved { i + 1 } else { range.end }).map(move |k| (i, k)))
        .collect();
    Matrix::from_fn(left.rows(), columns.len(), |p, c| left[(p, columns[c].0)] * right[(p, columns[c].1)])
}

/// Place of (i, k), k ≤ i, among the halved pairs.
fn place(i: usize, k: usize) -> usize {
    let (i, k) = (i.max(k), i.min(k));
    i * (i + 1) / 2 + k
}

/// The forms of a product cell over a window, for one row i of it: `Σ_p` of uu, vv and uv fields with components.
struct Row<'a> {
    rows: usize,
    columns: usize,
    /// Rows k ≤ i; columns (component, jl halved).
    uu: &'a Matrix,
    vv: &'a Matrix,
    /// `Σ f_i' g_j f_k g_l'` and `Σ f_i g_j' f_k' g_l` with the transposed components: columns (component, jl).
    uv: &'a Matrix,
    vu: &'a Matrix,
}

impl Row<'_> {
    fn halved(&self, matrix: &Matrix, k: usize, component: usize, j: usize, l: usize) -> f64 {
        matrix[(k, component * self.columns * (self.columns + 1) / 2 + place(j, l))]
    }

    fn mixed(&self, k: usize, components: [usize; 2], j: usize, l: usize) -> f64 {
        let n = self.columns;
        self.uv[(k, (components[0] * n + j) * n + l)] + self.vu[(k, (components[1] * n + l) * n + j)]
    }
}

/// Symmetric components (α, β) of a 3 × 3 block in the order in which they are summed.
const SYMMETRIC: [[usize; 3]; 3] = [[0, 1, 2], [1, 3, 4], [2, 4, 5]];
const ENTRIES: [(usize, usize); 6] = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];

impl ProductCell {
    /// Sums the fields over the window and shows the result row by row of nodes: `uu` and `vv` hold `symmetric`
    /// components a point, `uv` `full`.
    fn contract(
        &self,
        [rows, columns]: &[Range; 2],
        [uu, vv, uv]: [&[f64]; 3],
        symmetric: usize,
        full: usize,
        mut show: impl FnMut(usize, &Row<'_>),
    ) {
        let (m, n) = (rows.len(), columns.len());
        let (g, dg) = (&self.v.values, &self.v.slopes);
        let by_uu = self.along_v(symmetric, uu, &pairs(g, g, columns, true));
        let by_vv = self.along_v(symmetric, vv, &pairs(dg, dg, columns, true));
        let by_uv = self.along_v(full, uv, &pairs(g, dg, columns, false));
        let (f, df) = (&self.u.values, &self.u.slopes);
        let table = |left: &Matrix, right: &Matrix, i: usize| {
            let i = rows.start + i;
            Matrix::from_fn(left.rows(), i + 1 - rows.start, |p, k| left[(p, i)] * right[(p, rows.start + k)])
        };
        let sum = |table: Matrix, fields: &Matrix| {
            let mut sum = Matrix::zeros(table.cols(), fields.cols());
            add_product(&mut sum, &table, fields);
            sum
        };
        for i in 0..m {
            show(
                i,
                &Row {
                    rows: m,
                    columns: n,
                    uu: &sum(table(df, df, i), &by_uu),
                    vv: &sum(table(f, f, i), &by_vv),
                    uv: &sum(table(df, f, i), &by_uv),
                    vu: &sum(table(f, df, i), &by_uv),
                },
            );
        }
    }
}

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
        Arch::new().dispatch(Tangents { cell: self, x })
    }

    fn adjoint(&self, pairs: &[[Point; 2]]) -> Vec<Point> {
        Arch::new().dispatch(Adjoint { cell: self, pairs })
    }

    fn stiffness(&self, wanted: &[bool], forms: &[[f64; 3]]) -> Matrix {
        let window = self.window(|node| wanted[node]);
        let index = numbered(wanted.iter().map(|w| usize::from(*w)));
        let mut matrix = Matrix::zeros(index.1, index.1);
        let field = |k: usize| forms.iter().map(|form| form[k]).collect::<Vec<f64>>();
        let (columns, width) = (self.v.functions(), window[1].len());
        let node = |i: usize, j: usize| (window[0].start + i) * columns + window[1].start + j;
        self.contract(&window, [&field(0), &field(2), &field(1)], 1, 1, |i, row| {
            for j in (0..width).filter(|&j| wanted[node(i, j)]) {
                let at = index.0[node(i, j)];
                for k in 0..=i {
                    for l in (0..width).filter(|&l| wanted[node(k, l)] && (k < i || l <= j)) {
                        let entry = row.halved(row.uu, k, 0, j, l)
                            + row.halved(row.vv, k, 0, j, l)
                            + row.mixed(k, [0, 0], j, l);
                        matrix[(index.0[node(k, l)], at)] = entry;
                    }
                }
            }
        });
        mirrored(matrix)
    }

    fn mass(&self, wanted: &[bool], factors: &[f64]) -> Matrix {
        let window = self.window(|node| wanted[node]);
        let index = numbered(wanted.iter().map(|w| usize::from(*w)));
        let (g, f) = (&self.v.values, &self.u.values);
        let lines = self.along_v(1, factors, &pairs(g, g, &window[1], true));
        let mut sums = Matrix::zeros(window[0].len() * (window[0].len() + 1) / 2, lines.cols());
        add_product(&mut sums, &pairs(f, f, &window[0], true), &lines);
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

    fn hessian(&self, freedoms: &[Freedom], tangents: &[[Point; 2]]) -> Result<Matrix, EnergyError> {
        let window = self.window(|node| freedoms[node] != Freedom::Fixed);
        let (index, size) = numbered(freedoms.iter().map(|freedom| freedom.directions().len()));
        let (mut uu, mut vv, mut uv) = (Vec::new(), Vec::new(), Vec::new());
        for (p, (&[x_u, x_v], &w)) in tangents.iter().zip(&self.weights).enumerate() {
            let density = Density::new(x_u, x_v).ok_or_else(|| self.singular(p))?;
            let h = &density.hessian;
            uu.extend(ENTRIES.map(|(a, b)| w * h[a][b]));
            vv.extend(ENTRIES.map(|(a, b)| w * h[3 + a][3 + b]));
            uv.extend((0..9).map(|k| w * h[k / 3][3 + k % 3]));
        }
        let mut matrix = Matrix::zeros(size, size);
        let (columns, width) = (self.v.functions(), window[1].len());
        let node = |i: usize, j: usize| (window[0].start + i) * columns + window[1].start + j;
        self.contract(&window, [&uu, &vv, &uv], 6, 9, |i, row| {
            debug_assert!(i < row.rows);
            for j in 0..width {
                let first = freedoms[node(i, j)].directions();
                if first.is_empty() {
                    continue;
                }
                for k in 0..=i {
                    for l in 0..if k < i { width } else { j + 1 } {
                        let second = freedoms[node(k, l)].directions();
                        if second.is_empty() {
                            continue;
                        }
                        let block: [[f64; 3]; 3] = std::array::from_fn(|a| {
                            std::array::from_fn(|b| {
                                let c = SYMMETRIC[a][b];
                                row.halved(row.uu, k, c, j, l)
                                    + row.halved(row.vv, k, c, j, l)
                                    + row.mixed(k, [3 * a + b, 3 * b + a], j, l)
                            })
                        });
                        let at = [index[node(k, l)], index[node(i, j)]];
                        project(&mut matrix, at, &block, second, first);
                    }
                }
            }
        });
        Ok(mirrored(matrix))
    }
}

/// [`Cell::tangents`], coordinate by coordinate, so that all points of a line are summed at once.
struct Tangents<'a> {
    cell: &'a ProductCell,
    x: &'a [Point],
}

impl WithSimd for Tangents<'_> {
    type Output = Vec<[Point; 2]>;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> Self::Output {
        let (u, v) = (&self.cell.u, &self.cell.v);
        let (q, n) = (v.points(), v.functions());
        let columns: Vec<f64> = self.x.iter().flat_map(|&p| <[f64; 3]>::from(p)).collect();
        let mut tangents = Vec::with_capacity(u.points() * q);
        let mut along = [vec![0.0; 3 * n], vec![0.0; 3 * n]];
        let mut line = [0; 6].map(|_| vec![0.0; q]);
        for a in 0..u.points() {
            along.iter_mut().for_each(|along| along.fill(0.0));
            for (i, row) in columns.chunks_exact(3 * n).enumerate() {
                for (along, f) in along.iter_mut().zip([u.slopes[(a, i)], u.values[(a, i)]]) {
                    along.iter_mut().zip(row).for_each(|(sum, x)| *sum += f * x);
                }
            }
            for (part, functions) in [&v.values_by_function, &v.slopes_by_function].into_iter().enumerate() {
                for c in 0..3 {
                    let sums = &mut line[3 * part + c];
                    sums.fill(0.0);
                    for (j, functions) in functions.chunks_exact(q).enumerate() {
                        let x = along[part][3 * j + c];
                        sums.iter_mut().zip(functions).for_each(|(sum, g)| *sum += x * g);
                    }
                }
            }
            let at = |b: usize, part: usize| {
                Point::new(line[3 * part][b], line[3 * part + 1][b], line[3 * part + 2][b])
            };
            tangents.extend((0..q).map(|b| [at(b, 0), at(b, 1)]));
        }
        tangents
    }
}

/// [`Cell::adjoint`], likewise.
struct Adjoint<'a> {
    cell: &'a ProductCell,
    pairs: &'a [[Point; 2]],
}

impl WithSimd for Adjoint<'_> {
    type Output = Vec<Point>;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> Self::Output {
        let (u, v) = (&self.cell.u, &self.cell.v);
        let (q, n) = (v.points(), v.functions());
        let mut sums = vec![0.0; 3 * u.functions() * n];
        // Coordinate after coordinate, n numbers each.
        let mut along = [vec![0.0; 3 * n], vec![0.0; 3 * n]];
        for (a, line) in self.pairs.chunks_exact(q).enumerate() {
            along.iter_mut().for_each(|along| along.fill(0.0));
            for (b, pair) in line.iter().enumerate() {
                for ((along, x), functions) in
                    along.iter_mut().zip(pair).zip([v.values.row(b), v.slopes.row(b)])
                {
                    for (along, x) in along.chunks_exact_mut(n).zip(<[f64; 3]>::from(*x)) {
                        along.iter_mut().zip(functions).for_each(|(sum, g)| *sum += x * g);
                    }
                }
            }
            for (i, row) in sums.chunks_exact_mut(3 * n).enumerate() {
                let (f, df) = (u.values[(a, i)], u.slopes[(a, i)]);
                let both = along[0].iter().zip(&along[1]);
                row.iter_mut().zip(both).for_each(|(sum, (by_u, by_v))| *sum += df * by_u + f * by_v);
            }
        }
        let point = |row: &[f64], j: usize| Point::new(row[j], row[n + j], row[2 * n + j]);
        sums.chunks_exact(3 * n).flat_map(|row| (0..n).map(move |j| point(row, j))).collect()
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

/// The first unknown of every node, and how many there are.
pub(crate) fn numbered(counts: impl Iterator<Item = usize>) -> (Vec<usize>, usize) {
    let (mut first, mut size) = (Vec::new(), 0);
    for count in counts {
        first.push(size);
        size += count;
    }
    (first, size)
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

//! Calibrations: lower bounds of the area of every surface with a given rim.

use bases::{Basis, Bernstein, GaussLegendre, Matrix};
use surfaces::{Complex, Point};

use crate::EnergyError;

/// A plane with a right-handed frame of orthonormal axes; graphs rise along the third.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// A point of the plane.
    pub origin: Point,
    /// Two axes in the plane and its normal.
    pub axes: [Point; 3],
}

impl Plane {
    /// The plane through `origin` with the given normal; none if that is the zero vector.
    pub fn with_normal(origin: Point, normal: Point) -> Option<Self> {
        let normal = normal.unit()?;
        let [x, y, z] = <[f64; 3]>::from(normal).map(f64::abs);
        // The axis farthest from the normal: their cross product is never short.
        let least = if x <= y && x <= z {
            Point::new(1.0, 0.0, 0.0)
        } else if y <= z {
            Point::new(0.0, 1.0, 0.0)
        } else {
            Point::new(0.0, 0.0, 1.0)
        };
        let first = least.cross(normal).unit()?;
        Some(Self { origin, axes: [first, normal.cross(first), normal] })
    }

    /// The coordinates of a point in the frame.
    pub fn coordinates(&self, point: Point) -> [f64; 3] {
        self.axes.map(|axis| axis.dot(point - self.origin))
    }
}

/// The lower bound of a calibration as a function of its potential ψ: `∮ z dψ + ∫_Ω √(1 − |∇ψ|²) dx dy`, where the surface is the graph
/// of z over the region Ω of a plane. For every ψ with |∇ψ| ≤ 1 it is at most the area of every graph over Ω with the same rim:
/// (−ψ_y, ψ_x, √(1 − |∇ψ|²)) has length 1 and no divergence. It is concave in ψ; its maximum over all ψ is the least area.
///
/// ψ is a polynomial of degree (d, d) on each face of the complex, in the planar map (x, y) of the surface, continuous across edges:
/// one coefficient for each control point of the complex raised to degree d.
#[derive(Debug, Clone)]
pub struct Calibration {
    nodes: Vec<Vec<usize>>,
    unknowns: usize,
    rim: Vec<f64>,
    faces: Vec<FaceSamples>,
}

/// What one face knows at the points of the rule.
#[derive(Debug, Clone)]
struct FaceSamples {
    /// Weights times the Jacobian of the planar map.
    weights: Vec<f64>,
    /// `∂B_k/∂x` and `∂B_k/∂y`: points × functions.
    slopes: [Matrix; 2],
    /// ∇z / √(1 + |∇z|²).
    flux: Vec<[f64; 2]>,
}

impl Calibration {
    /// For potentials of degree `degree`, at least that of the complex, by a rule of `points`² points a face. None if the planar map
    /// turns over or is singular at a point of the rule: then the surface is no graph over the plane.
    ///
    /// # Errors
    /// [`EnergyError::Complex`] and [`EnergyError::Basis`] for a degree that is not offered.
    pub fn new(
        complex: &Complex,
        plane: &Plane,
        degree: usize,
        points: usize,
    ) -> Result<Option<Self>, EnergyError> {
        let raised = complex.with_degree(degree).map_err(EnergyError::from)?;
        let places: Vec<[f64; 3]> = raised.points().iter().map(|&p| plane.coordinates(p)).collect();
        let tables = Tables::new(degree, points)?;
        let mut faces = Vec::with_capacity(raised.faces().len());
        for face in raised.faces() {
            let net: Vec<[f64; 3]> = face.nodes().iter().map(|&k| places[k]).collect();
            match tables.samples(&net) {
                Some(samples) => faces.push(samples),
                None => return Ok(None),
            }
        }
        let nodes = raised.faces().iter().map(|face| face.nodes().to_vec()).collect();
        // ∫_Ω (z_x ψ_y − z_y ψ_x) = ∮ z dψ by Green's theorem: what is linear in ψ needs the rim alone, and no rule.
        let rim = rim_functional(&raised, &places, degree);
        Ok(Some(Self { nodes, unknowns: places.len(), rim, faces }))
    }

    /// Number of coefficients of ψ. The value does not change when a constant is added to ψ: one of them may be held at 0.
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }

    /// The bound at ψ by the rule; none where |∇ψ| ≥ 1 at one of its points.
    pub fn value(&self, psi: &[f64]) -> Option<f64> {
        let mut sum = self.rim.iter().zip(psi).map(|(b, psi)| b * psi).sum::<f64>();
        for (face, nodes) in self.faces.iter().zip(&self.nodes) {
            let local: Vec<f64> = nodes.iter().map(|&k| psi[k]).collect();
            for (q, weight) in face.weights.iter().enumerate() {
                let [x, y] = face.gradient(q, &local);
                let left = 1.0 - x * x - y * y;
                // √ needs |∇ψ| < 1 strictly: at 1 the Hessian is infinite, and beyond it there is no calibration.
                if left.is_nan() || left <= 0.0 {
                    return None;
                }
                sum += weight * left.sqrt();
            }
        }
        Some(sum)
    }

    /// The gradient at ψ and the negative Hessian, N × N, symmetric and positive semidefinite with the constants as its kernel. At a ψ that
    /// has a value.
    pub fn derivatives(&self, psi: &[f64]) -> (Vec<f64>, Matrix) {
        let mut gradient = self.rim.clone();
        let mut hessian = Matrix::zeros(self.unknowns, self.unknowns);
        for (face, nodes) in self.faces.iter().zip(&self.nodes) {
            let local: Vec<f64> = nodes.iter().map(|&k| psi[k]).collect();
            let mut rows = Vec::with_capacity(2 * face.weights.len());
            for (q, weight) in face.weights.iter().enumerate() {
                let [x, y] = face.gradient(q, &local);
                let root = (1.0 - x * x - y * y).sqrt();
                let [by_x, by_y] = face.slopes.each_ref().map(|slopes| slopes.row(q));
                for (k, &node) in nodes.iter().enumerate() {
                    gradient[node] -= weight / root * (x * by_x[k] + y * by_y[k]);
                }
                // I/s + σσᵀ/s³ = LLᵀ with L = (I + (1/s − 1) σσᵀ/|σ|²)/√s, σ = ∇ψ: its lengths are 1/√s across σ and s^(−3/2) along it.
                let length = (x * x + y * y).sqrt();
                let [cx, cy] = if length > 0.0 { [x / length, y / length] } else { [1.0, 0.0] };
                let (across, along) = ((weight / root).sqrt(), (weight / root.powi(3)).sqrt());
                rows.push(by_x.iter().zip(by_y).map(|(a, b)| along * (cx * a + cy * b)).collect::<Vec<_>>());
                rows.push(by_x.iter().zip(by_y).map(|(a, b)| across * (cx * b - cy * a)).collect());
            }
            add_gram(&rows, nodes, &mut hessian);
        }
        (gradient, hessian)
    }

    /// The normal equations of the potential whose turned gradient (ψ_y, −ψ_x) is closest to `∇z/√(1 + |∇z|²)`, the flux of a minimal
    /// graph: the matrix, N × N, symmetric and positive semidefinite with the constants as its kernel, and the right-hand side.
    pub fn fit(&self) -> (Matrix, Vec<f64>) {
        let (mut matrix, mut rhs) = (Matrix::zeros(self.unknowns, self.unknowns), vec![0.0; self.unknowns]);
        for (face, nodes) in self.faces.iter().zip(&self.nodes) {
            let mut rows = Vec::with_capacity(2 * face.weights.len());
            for (q, weight) in face.weights.iter().enumerate() {
                let [by_x, by_y] = face.slopes.each_ref().map(|slopes| slopes.row(q));
                let [zx, zy] = face.flux[q];
                for (k, &node) in nodes.iter().enumerate() {
                    rhs[node] += weight * (zx * by_y[k] - zy * by_x[k]);
                }
                rows.extend(
                    [by_x, by_y].map(|row| row.iter().map(|s| weight.sqrt() * s).collect::<Vec<_>>()),
                );
            }
            add_gram(&rows, nodes, &mut matrix);
        }
        (matrix, rhs)
    }
}

impl FaceSamples {
    /// ∇ψ at a point of the rule.
    fn gradient(&self, q: usize, psi: &[f64]) -> [f64; 2] {
        self.slopes.each_ref().map(|slopes| slopes.row(q).iter().zip(psi).map(|(s, psi)| s * psi).sum())
    }
}

/// Adds `rowsᵀ rows` at the nodes of a face.
fn add_gram(rows: &[Vec<f64>], nodes: &[usize], matrix: &mut Matrix) {
    let n = nodes.len();
    let mut gram = vec![0.0; n * n];
    for row in rows {
        for (i, a) in row.iter().enumerate() {
            for (sum, b) in gram[i * n..(i + 1) * n].iter_mut().zip(row) {
                *sum += a * b;
            }
        }
    }
    for (i, &row) in nodes.iter().enumerate() {
        for (j, &col) in nodes.iter().enumerate() {
            matrix[(row, col)] += gram[i * n + j];
        }
    }
}

/// The derivatives of the Bernstein polynomials of a degree at the points of a Gauss rule, in two variables.
struct Tables {
    weights: Vec<f64>,
    slopes: [Matrix; 2],
}

impl Tables {
    fn new(degree: usize, points: usize) -> Result<Self, EnergyError> {
        let (basis, rule) = (Bernstein::new(degree)?, GaussLegendre::new(points)?.on(0.0, 1.0));
        let at: Vec<Matrix> = (0..points).map(|k| basis.evaluate(rule.node(k), 1)).collect();
        let n = degree + 1;
        let table = |du: usize, dv: usize| {
            Matrix::from_fn(points * points, n * n, |q, k| {
                at[q / points][(du, k / n)] * at[q % points][(dv, k % n)]
            })
        };
        let weights =
            (0..points * points).map(|q| rule.weight(q / points) * rule.weight(q % points)).collect();
        Ok(Self { weights, slopes: [table(1, 0), table(0, 1)] })
    }

    /// None where the planar map is singular or turned over.
    fn samples(&self, net: &[[f64; 3]]) -> Option<FaceSamples> {
        let (points, functions) = (self.weights.len(), net.len());
        let mut samples = FaceSamples {
            weights: Vec::with_capacity(points),
            slopes: [Matrix::zeros(points, functions), Matrix::zeros(points, functions)],
            flux: Vec::with_capacity(points),
        };
        for q in 0..points {
            let [by_u, by_v] = self.slopes.each_ref().map(|slopes| slopes.row(q));
            let sum = |row: &[f64], c: usize| row.iter().zip(net).map(|(s, p)| s * p[c]).sum::<f64>();
            let ([xu, yu, zu], [xv, yv, zv]) =
                ([0, 1, 2].map(|c| sum(by_u, c)), [0, 1, 2].map(|c| sum(by_v, c)));
            let jacobian = xu * yv - xv * yu;
            // At the points of the rule only: `certify` proves it everywhere.
            if jacobian.is_nan() || jacobian <= 0.0 {
                return None;
            }
            // The gradient over the plane by the inverse of the Jacobian matrix: Cramer's rule.
            let planar = |fu: f64, fv: f64| [(fu * yv - fv * yu) / jacobian, (fv * xu - fu * xv) / jacobian];
            for k in 0..functions {
                let [x, y] = planar(by_u[k], by_v[k]);
                (samples.slopes[0][(q, k)], samples.slopes[1][(q, k)]) = (x, y);
            }
            let [zx, zy] = planar(zu, zv);
            let stretch = (1.0 + zx * zx + zy * zy).sqrt();
            samples.flux.push([zx / stretch, zy / stretch]);
            // Weights with the Jacobian: sums over the rule are integrals over Ω, not over the parameters.
            samples.weights.push(self.weights[q] * jacobian);
        }
        Some(samples)
    }
}

/// The coefficients of `∮ z dψ`, counterclockwise, in those of ψ: for each edge of one face `∫ z ψ' dt` along it.
fn rim_functional(complex: &Complex, places: &[[f64; 3]], degree: usize) -> Vec<f64> {
    let mut rim = vec![0.0; places.len()];
    let pairing = derivative_pairing(degree);
    for (number, edge) in complex.edges().iter().enumerate() {
        // Inner edges belong to two faces, run through twice in opposite directions: they cancel, ψ and z being continuous.
        let [only] = edge.uses() else { continue };
        let mut nodes = complex.edge_nodes(number);
        // The rim is run through with the face on the left.
        if only.reversed == only.side.runs_round() {
            nodes.reverse();
        }
        for (i, &z) in nodes.iter().enumerate() {
            for (j, &psi) in nodes.iter().enumerate() {
                rim[psi] += places[z][2] * pairing[(i, j)];
            }
        }
    }
    rim
}

/// `∫ B_i B_j' dt` over [0, 1], (n + 1) × (n + 1).
fn derivative_pairing(n: usize) -> Matrix {
    // B_j' = n (B_{j−1,n−1} − B_{j,n−1}), and ∫ B_{i,n} B_{k,n−1} = C(n,i) C(n−1,k) / (C(2n−1,i+k) 2n).
    // By logarithms: the binomials themselves overflow at high degrees, though their quotient is at most 1.
    let log = |n: usize, k: usize| -> f64 { (1..=k).map(|i| ((n - k + i) as f64 / i as f64).ln()).sum() };
    let product =
        |i: usize, k: usize| (log(n, i) + log(n - 1, k) - log(2 * n - 1, i + k)).exp() / (2 * n) as f64;
    Matrix::from_fn(n + 1, n + 1, |i, j| {
        let rising = if j > 0 { product(i, j - 1) } else { 0.0 };
        let falling = if j < n { product(i, j) } else { 0.0 };
        n as f64 * (rising - falling)
    })
}

//! The displacements of a net that leave its border in place, in functions orthonormal for the Dirichlet product.

use bases::{Matrix, Samples};
use energy::{EnergyError, NormalVariation, ProductArea, SampledArea, TangentSamples};
use solve::{eigen_symmetric, orthonormalise};
use surfaces::{Jet, Patch, Point, SurfaceError, TensorPatch, TriangleBasis, TriangleNet, TrianglePatch};

use crate::MethodError;

/// The displacements `Σ_k c_k ψ_k` of patches of one kind and degree, with `∫ ∇ψ_k · ∇ψ_l = δ_kl` over the parameters.
///
/// In these functions the Hessian of the area has eigenvalues of at most about 1 at any degree, where in the control points
/// its condition grows like 4ⁿ.
pub(super) trait Space {
    /// The patches displaced.
    type Patch;

    /// The area around `patch`, by the rule of `points`² points.
    fn area(&self, patch: &Self::Patch, points: usize) -> Result<Area, MethodError>;

    /// `patch` displaced.
    fn moved(&self, patch: &Self::Patch, c: &[f64]) -> Result<Self::Patch, MethodError>;

    /// The second variation of the area of `patch` under normal displacements by the ψ_k, by the rule of `area`.
    fn variation(&self, patch: &Self::Patch, area: &Area) -> Result<NormalVariation, MethodError>;
}

/// The area as a function of displacements.
pub(super) enum Area {
    /// Over products of functions of one variable.
    Product(Box<ProductArea>),
    /// Over any functions.
    Sampled(SampledArea),
}

impl Area {
    pub(super) fn unknowns(&self) -> usize {
        match self {
            Self::Product(area) => area.unknowns(),
            Self::Sampled(area) => area.unknowns(),
        }
    }

    pub(super) fn value_and_gradient(&self, c: &[f64], gradient: &mut [f64]) -> Result<f64, EnergyError> {
        match self {
            Self::Product(area) => area.value_and_gradient(c, gradient),
            Self::Sampled(area) => area.value_and_gradient(c, gradient),
        }
    }

    pub(super) fn hessian(&self, c: &[f64], hessian: &mut [f64]) -> Result<(), EnergyError> {
        match self {
            Self::Product(area) => area.hessian(c, hessian),
            Self::Sampled(area) => area.hessian(c, hessian),
        }
    }

    pub(super) fn dirichlet_projection(&self) -> Vec<f64> {
        match self {
            Self::Product(area) => area.dirichlet_projection(),
            Self::Sampled(area) => area.dirichlet_projection(),
        }
    }
}

/// Patches of one product of families: `ψ_ij = f_i(u) g_j(v) / √(λ_i + μ_j)` with f and g orthonormal, f' and g'
/// orthogonal of square lengths λ and μ.
pub(super) struct Product {
    map_u: Matrix,
    map_v: Matrix,
    scale: Vec<f64>,
}

impl Product {
    pub(super) fn new(patch: &TensorPatch) -> Result<Self, MethodError> {
        let product = &patch.products()[0];
        let (map_u, lambda) =
            diagonal(&Samples::new(product.u.as_ref(), Samples::points_for(product.u.count()), 1)?)?;
        let (map_v, mu) =
            diagonal(&Samples::new(product.v.as_ref(), Samples::points_for(product.v.count()), 1)?)?;
        let scale = lambda.iter().flat_map(|l| mu.iter().map(move |m| 1.0 / (l + m).sqrt())).collect();
        Ok(Self { map_u, map_v, scale })
    }
}

impl Space for Product {
    type Patch = TensorPatch;

    fn area(&self, patch: &TensorPatch, points: usize) -> Result<Area, MethodError> {
        let area = ProductArea::new(patch, &self.map_u, &self.map_v, &self.scale, points)?;
        Ok(Area::Product(Box::new(area)))
    }

    fn moved(&self, patch: &TensorPatch, c: &[f64]) -> Result<TensorPatch, MethodError> {
        let (n, columns) = (self.map_v.cols(), self.map_v.rows());
        let coefficients = Matrix::from_fn(self.map_u.cols(), 3 * n, |i, at| {
            c[3 * (i * n + at / 3) + at % 3] * self.scale[i * n + at / 3]
        });
        let along_u = self.map_u.times(&coefficients);
        let points = |i: usize, j: usize| {
            (0..n).fold(Point::ZERO, |sum, l| {
                let at = &along_u.row(i)[3 * l..3 * l + 3];
                sum + Point::new(at[0], at[1], at[2]) * self.map_v[(j, l)]
            })
        };
        let change: Vec<Point> = (0..self.map_u.rows())
            .flat_map(|i| (0..columns).map(move |j| (i, j)))
            .map(|(i, j)| points(i, j))
            .collect();
        let net = patch.net();
        let coordinates = displaced(net.coordinates(), net.fixed(), &change);
        Ok(patch.with_net(net.with_coordinates(&coordinates)?)?)
    }

    fn variation(&self, patch: &TensorPatch, area: &Area) -> Result<NormalVariation, MethodError> {
        let mut variation = NormalVariation::zero(self.scale.len());
        if let Area::Product(area) = area {
            let (samples, values) = area.samples()?;
            let [us, vs] = area.nodes();
            variation.add(&samples, &values, &patch.jets(us, vs))?;
        }
        Ok(variation)
    }
}

/// The map from the functions of a family that vanish at both ends to combinations that are orthonormal with orthogonal
/// derivatives, and the square lengths of these.
fn diagonal(samples: &Samples) -> Result<(Matrix, Vec<f64>), MethodError> {
    let functions = samples.order(0).cols() - 2;
    let weighted = |order: usize| {
        let (all, weights) = (samples.order(order), samples.weights());
        Matrix::from_fn(weights.len(), functions, |p, k| weights[p].sqrt() * all[(p, k + 1)])
    };
    let map = orthonormal(&weighted(0))?;
    let slopes = weighted(1).times(&map);
    let gram = slopes.transpose().times(&slopes);
    let eigen = eigen_symmetric(functions, gram.as_slice())?;
    let vectors = Matrix::from_fn(functions, functions, |i, j| eigen.vectors[i * functions + j]);
    Ok((map.times(&vectors), eigen.values))
}

/// The map that makes the columns orthonormal.
fn orthonormal(samples: &Matrix) -> Result<Matrix, MethodError> {
    let (rows, cols) = (samples.rows(), samples.cols());
    let map = orthonormalise(rows, cols, samples.as_slice())?;
    Ok(Matrix::from_fn(cols, cols, |i, j| map[i * cols + j]))
}

/// Tensor patches of any number of products, such as TB–Coons.
pub(super) struct Sums {
    map: Matrix,
}

impl Sums {
    pub(super) fn new(patch: &TensorPatch, points: usize) -> Result<Self, MethodError> {
        let free = free(patch.net().fixed());
        let batches = TangentSamples::of_tensor(patch, points)?.map(|batch| batch.selected(&free));
        Ok(Self { map: dirichlet_orthonormal(batches)? })
    }
}

impl Space for Sums {
    type Patch = TensorPatch;

    fn area(&self, patch: &TensorPatch, points: usize) -> Result<Area, MethodError> {
        let net = patch.net();
        sampled(TangentSamples::of_tensor(patch, points)?, net.points(), net.fixed(), &self.map)
    }

    fn moved(&self, patch: &TensorPatch, c: &[f64]) -> Result<TensorPatch, MethodError> {
        let net = patch.net();
        let coordinates = displaced(net.coordinates(), net.fixed(), &combined(&self.map, c));
        Ok(patch.with_net(net.with_coordinates(&coordinates)?)?)
    }

    fn variation(&self, patch: &TensorPatch, area: &Area) -> Result<NormalVariation, MethodError> {
        let (cols, free) = (patch.net().cols(), free(patch.net().fixed()));
        let value = |u: f64, v: f64| {
            let mut all = vec![0.0; free.len()];
            for product in patch.products() {
                let (f, g) = (product.u.evaluate(u, 0), product.v.evaluate(v, 0));
                all.iter_mut().enumerate().for_each(|(k, sum)| *sum += f[(0, k / cols)] * g[(0, k % cols)]);
            }
            all
        };
        variation(area, &free, &self.map, value, |u, v| patch.jet(u, v))
    }
}

/// Triangular patches.
pub(super) struct Triangle {
    map: Matrix,
}

impl Triangle {
    pub(super) fn new(net: &TriangleNet, points: usize) -> Result<Self, MethodError> {
        let free = free(net.fixed());
        let batches = TangentSamples::of_triangle(net.degree(), points)?.map(|batch| batch.selected(&free));
        Ok(Self { map: dirichlet_orthonormal(batches)? })
    }
}

impl Space for Triangle {
    type Patch = TrianglePatch;

    fn area(&self, patch: &TrianglePatch, points: usize) -> Result<Area, MethodError> {
        let net = patch.net();
        sampled(TangentSamples::of_triangle(net.degree(), points)?, net.points(), net.fixed(), &self.map)
    }

    fn moved(&self, patch: &TrianglePatch, c: &[f64]) -> Result<TrianglePatch, MethodError> {
        let net = patch.net();
        let coordinates = displaced(net.coordinates(), net.fixed(), &combined(&self.map, c));
        Ok(TrianglePatch::new(net.with_coordinates(&coordinates)?)?)
    }

    fn variation(&self, patch: &TrianglePatch, area: &Area) -> Result<NormalVariation, MethodError> {
        let degree = patch.net().degree();
        let basis = TriangleBasis::new(degree).map_err(SurfaceError::from)?;
        let value = |u: f64, v: f64| {
            let mut all = vec![0.0; basis.count()];
            basis.evaluate_into(u, v, 0, &mut all);
            all
        };
        variation(area, &free(patch.net().fixed()), &self.map, value, |u, v| patch.jet(u, v))
    }
}

fn free(fixed: &[bool]) -> Vec<bool> {
    fixed.iter().map(|fixed| !fixed).collect()
}

/// The map from sampled functions to combinations orthonormal for the Dirichlet product.
fn dirichlet_orthonormal(batches: impl Iterator<Item = TangentSamples>) -> Result<Matrix, MethodError> {
    let (mut slopes, mut functions) = (Vec::new(), 0);
    for batch in batches {
        functions = batch.functions();
        for (p, weight) in batch.weights().iter().enumerate() {
            let row = batch.u().row(p).iter().chain(batch.v().row(p));
            slopes.extend(row.map(|slope| weight.sqrt() * slope));
        }
    }
    let rows = slopes.len() / functions.max(1);
    orthonormal(&Matrix::from_fn(rows, functions, |i, j| slopes[i * functions + j]))
}

fn sampled(
    batches: impl Iterator<Item = TangentSamples>,
    net: &[Point],
    fixed: &[bool],
    map: &Matrix,
) -> Result<Area, MethodError> {
    let free = free(fixed);
    let batches = batches.map(|batch| Ok((batch.selected(&free).combined(map)?, batch.tangents(net))));
    Ok(Area::Sampled(SampledArea::new(batches.collect::<Result<_, EnergyError>>()?)?))
}

fn variation(
    area: &Area,
    free: &[bool],
    map: &Matrix,
    values: impl Fn(f64, f64) -> Vec<f64>,
    jet: impl Fn(f64, f64) -> Jet,
) -> Result<NormalVariation, MethodError> {
    let kept: Vec<usize> = (0..free.len()).filter(|&k| free[k]).collect();
    let mut variation = NormalVariation::zero(map.cols());
    let Area::Sampled(area) = area else { return Ok(variation) };
    for batch in area.samples() {
        let tables: Vec<Vec<f64>> = batch.parameters().iter().map(|&[u, v]| values(u, v)).collect();
        let values = Matrix::from_fn(batch.points(), kept.len(), |p, k| tables[p][kept[k]]).times(map);
        let jets: Vec<Jet> = batch.parameters().iter().map(|&[u, v]| jet(u, v)).collect();
        variation.add(batch, &values, &jets)?;
    }
    Ok(variation)
}

/// `Σ_l map[k, l] c_l` for every function k of the net.
fn combined(map: &Matrix, c: &[f64]) -> Vec<Point> {
    let sum = |row: &[f64]| {
        row.iter()
            .zip(c.chunks_exact(3))
            .fold(Point::ZERO, |sum, (m, c)| sum + Point::new(c[0], c[1], c[2]) * *m)
    };
    (0..map.rows()).map(|k| sum(map.row(k))).collect()
}

/// The coordinates of a net with its free points moved.
fn displaced(mut coordinates: Vec<f64>, fixed: &[bool], change: &[Point]) -> Vec<f64> {
    let free = coordinates.chunks_exact_mut(3).zip(fixed).filter(|(_, fixed)| !**fixed);
    for ((point, _), change) in free.zip(change) {
        point.iter_mut().zip(<[f64; 3]>::from(*change)).for_each(|(x, d)| *x += d);
    }
    coordinates
}

//! Tensor patches: one product of families, or a sum of products.

use std::sync::Arc;

use bases::{Basis, Bernstein, GaussLegendre, Matrix};
use energy::{Cell, EnergyError, ProductCell, SampledCell};
use surfaces::{Net, Patch, Point, Product, TensorPatch, discrete_coons};

use super::family::{Family, displaced, inverse, net_nodes, of_nets};
use super::space::{Frame, Space, Topology, of_values};
use crate::MethodError;

/// The net of the discrete Coons patch of a border, in the frame of the border.
pub(super) fn coons(patch: &TensorPatch) -> Result<(Frame, Net), MethodError> {
    let net = patch.net();
    let [u0, u1, v0, v1] = net.boundary();
    // The border decides the frame: inner points must not change any digit.
    let border = u0.iter().chain(&u1).chain(&v0).chain(&v1).copied();
    let frame = Frame::of(border);
    let enter = |points: &[Point]| points.iter().map(|&p| frame.enter(p)).collect::<Vec<_>>();
    Ok((frame, discrete_coons(&enter(&u0), &enter(&u1), &enter(&v0), &enter(&v1))?))
}

/// Which points of a net lie inside.
pub(super) fn inside(net: &Net) -> Vec<bool> {
    let (rows, columns) = (net.rows(), net.cols());
    let inner = |k: usize, count: usize| k > 0 && k + 1 < count;
    (0..rows * columns).map(|k| inner(k / columns, rows) && inner(k % columns, columns)).collect()
}

/// The patch on the net `inner` inside, in the frame, with the border of `patch`.
pub(super) fn with_inner(
    patch: &TensorPatch,
    frame: &Frame,
    inner: &[Point],
) -> Result<TensorPatch, MethodError> {
    let net = patch.net();
    let mut coordinates = net.coordinates();
    for (k, _) in inside(net).into_iter().enumerate().filter(|(_, inside)| *inside) {
        coordinates[3 * k..3 * k + 3].copy_from_slice(&<[f64; 3]>::from(frame.leave(inner[k])));
    }
    Ok(patch.with_net(net.with_coordinates(&coordinates)?)?)
}

/// Patches of one product of families.
pub(super) struct Separated {
    patch: TensorPatch,
    frame: Frame,
    u: Family,
    v: Family,
    base: Vec<Point>,
    base_nodes: Vec<Point>,
    topology: Topology,
}

impl Separated {
    pub(super) fn new(patch: &TensorPatch, product: &Product) -> Result<Self, MethodError> {
        let (frame, net) = coons(patch)?;
        // Cardinal functions of polynomials are known; those of any other family come by an inverse, with its rounding.
        let family = |family: &Arc<dyn Basis>| match bernstein(family.as_ref())? {
            Some(bernstein) => Family::bernstein(&bernstein),
            None => Family::general(family),
        };
        let (u, v) = (family(&product.u)?, family(&product.v)?);
        let base = net.points().to_vec();
        let base_nodes = net_nodes([&u, &v], &base);
        let fixed = inside(&net).into_iter().map(|inside| !inside).collect();
        Ok(Self { patch: patch.clone(), frame, u, v, base, base_nodes, topology: Topology::single(fixed) })
    }
}

/// The Bernstein polynomials, if a family is theirs: `Basis` does not say, its values do.
fn bernstein(family: &dyn Basis) -> Result<Option<Bernstein>, MethodError> {
    let bernstein = Bernstein::new(family.count() - 1)?;
    let is_alike = |t: &f64| family.evaluate(*t, 1) == bernstein.evaluate(*t, 1);
    Ok((family.domain() == (0.0, 1.0) && [0.12, 0.37, 0.81].iter().all(is_alike)).then_some(bernstein))
}

/// Whether a patch is one of Bernstein polynomials.
pub(super) fn is_polynomial(patch: &TensorPatch) -> Result<bool, MethodError> {
    let [product] = patch.products() else { return Ok(false) };
    Ok(bernstein(product.u.as_ref())?.is_some() && bernstein(product.v.as_ref())?.is_some())
}

impl Space for Separated {
    type Surface = TensorPatch;

    fn topology(&self) -> &Topology {
        &self.topology
    }

    fn frame(&self) -> &Frame {
        &self.frame
    }

    fn degree(&self) -> usize {
        self.u.count().max(self.v.count()) - 1
    }

    fn cell(&self, points: usize) -> Result<Box<dyn Cell>, MethodError> {
        Ok(Box::new(ProductCell::new(self.u.nodal.as_ref(), self.v.nodal.as_ref(), points)?))
    }

    fn at_nodes(&self) -> Result<Box<dyn Cell>, MethodError> {
        let (u, v) = (&self.u, &self.v);
        Ok(Box::new(ProductCell::at(u.nodal.as_ref(), v.nodal.as_ref(), &u.nodes, &v.nodes)))
    }

    fn nodes(&self, surface: &TensorPatch) -> Result<Vec<Point>, MethodError> {
        let net: Vec<Point> = surface.net().points().iter().map(|&p| self.frame.enter(p)).collect();
        Ok(net_nodes([&self.u, &self.v], &net))
    }

    fn surface(&self, x: &[Point]) -> Result<TensorPatch, MethodError> {
        // Displacements from the base are converted, not points: the border keeps its last bit.
        let inner = displaced([&self.u, &self.v], &self.base, &self.base_nodes, x);
        with_inner(&self.patch, &self.frame, &inner)
    }

    fn coefficients(&self, f: &[f64]) -> Result<Vec<f64>, MethodError> {
        let zero = vec![Point::ZERO; f.len()];
        Ok(of_values(f, |x| displaced([&self.u, &self.v], &zero, &zero, x), &self.topology.fixed))
    }

    fn control(&self) -> Result<Option<Matrix>, MethodError> {
        Ok(Some(of_nets(&self.u.coefficients()?, &self.v.coefficients()?)))
    }

    fn patches(&self, x: &[Point]) -> Result<Vec<Box<dyn Patch>>, MethodError> {
        let product = Product { u: self.u.nodal.clone(), v: self.v.nodal.clone() };
        let net = Net::new(self.u.count(), self.v.count(), x.to_vec())?;
        Ok(vec![Box::new(TensorPatch::new(vec![product], net)?)])
    }

    fn start(&self) -> (Vec<Point>, Option<[f64; 3]>) {
        (self.base_nodes.clone(), None)
    }
}

/// Patches of any number of products, such as TB–Coons: the cardinal functions are those of the whole net.
pub(super) struct Sums {
    patch: TensorPatch,
    frame: Frame,
    u: Vec<f64>,
    v: Vec<f64>,
    /// Values at the nodes from the net, and back: (nodes)².
    values: Matrix,
    back: Matrix,
    base: Vec<Point>,
    topology: Topology,
}

impl Sums {
    pub(super) fn new(patch: &TensorPatch) -> Result<Self, MethodError> {
        let (frame, net) = coons(patch)?;
        let (m, n) = net.degrees();
        let [(u0, u1), (v0, v1)] = patch.rectangle();
        let nodes = |degree: usize, start: f64, end: f64| -> Result<Vec<f64>, MethodError> {
            Ok(bases::Nodal::new(degree)?.nodes().iter().map(|t| start + (end - start) * t).collect())
        };
        let (u, v) = (nodes(m, u0, u1)?, nodes(n, v0, v1)?);
        // Cardinal functions by the inverse of the values at the nodes: with several products they do not separate.
        let [values, _, _] = sampled(patch, &u, &v);
        let back = inverse(&values)?;
        let fixed = inside(&net).into_iter().map(|inside| !inside).collect();
        let base = net.points().to_vec();
        Ok(Self { patch: patch.clone(), frame, u, v, values, back, base, topology: Topology::single(fixed) })
    }

    fn tables(&self, us: &[f64], vs: &[f64]) -> [Matrix; 3] {
        sampled(&self.patch, us, vs).map(|table| table.times(&self.back))
    }
}

/// Values and derivatives by u and by v of the functions of a net on a grid: points × functions.
fn sampled(patch: &TensorPatch, us: &[f64], vs: &[f64]) -> [Matrix; 3] {
    let (rows, columns) = (patch.net().rows(), patch.net().cols());
    let mut tables = [0; 3].map(|_| Matrix::zeros(us.len() * vs.len(), rows * columns));
    for product in patch.products() {
        let of_v: Vec<Matrix> = vs.iter().map(|&v| product.v.evaluate(v, 1)).collect();
        for (a, &u) in us.iter().enumerate() {
            let f = product.u.evaluate(u, 1);
            for (b, g) in of_v.iter().enumerate() {
                for (table, [r, s]) in tables.iter_mut().zip([[0, 0], [1, 0], [0, 1]]) {
                    let row = table.row_mut(a * vs.len() + b);
                    for (out, &f) in row.chunks_exact_mut(columns).zip(f.row(r)) {
                        out.iter_mut().zip(g.row(s)).for_each(|(out, g)| *out += f * g);
                    }
                }
            }
        }
    }
    tables
}

/// `matrix · points`.
pub(super) fn times(matrix: &Matrix, points: &[Point]) -> Vec<Point> {
    (0..matrix.rows())
        .map(|k| matrix.row(k).iter().zip(points).fold(Point::ZERO, |sum, (&a, &p)| sum + p * a))
        .collect()
}

impl Space for Sums {
    type Surface = TensorPatch;

    fn topology(&self) -> &Topology {
        &self.topology
    }

    fn frame(&self) -> &Frame {
        &self.frame
    }

    fn degree(&self) -> usize {
        self.u.len().max(self.v.len()) - 1
    }

    fn cell(&self, points: usize) -> Result<Box<dyn Cell>, MethodError> {
        let unit = GaussLegendre::new(points)?;
        let [(u0, u1), (v0, v1)] = self.patch.rectangle();
        let (us, wu): (Vec<f64>, Vec<f64>) = unit.clone().on(u0, u1).iter().unzip();
        let (vs, wv): (Vec<f64>, Vec<f64>) = unit.on(v0, v1).iter().unzip();
        let parameters = us.iter().flat_map(|&u| vs.iter().map(move |&v| [u, v])).collect();
        let weights = wu.iter().flat_map(|a| wv.iter().map(move |b| a * b)).collect();
        let [values, by_u, by_v] = self.tables(&us, &vs);
        Ok(Box::new(SampledCell::new(parameters, weights, values, [by_u, by_v])?))
    }

    fn at_nodes(&self) -> Result<Box<dyn Cell>, MethodError> {
        let [values, by_u, by_v] = self.tables(&self.u, &self.v);
        let parameters: Vec<[f64; 2]> =
            self.u.iter().flat_map(|&u| self.v.iter().map(move |&v| [u, v])).collect();
        let weights = vec![1.0; parameters.len()];
        let cell: Result<SampledCell, EnergyError> =
            SampledCell::new(parameters, weights, values, [by_u, by_v]);
        Ok(Box::new(cell?))
    }

    fn nodes(&self, surface: &TensorPatch) -> Result<Vec<Point>, MethodError> {
        let net: Vec<Point> = surface.net().points().iter().map(|&p| self.frame.enter(p)).collect();
        Ok(times(&self.values, &net))
    }

    fn surface(&self, x: &[Point]) -> Result<TensorPatch, MethodError> {
        // The inverse moves border points by rounding: only the inner ones are taken.
        with_inner(&self.patch, &self.frame, &times(&self.back, x))
    }

    fn coefficients(&self, f: &[f64]) -> Result<Vec<f64>, MethodError> {
        Ok(of_values(f, |x| times(&self.back, x), &self.topology.fixed))
    }

    fn control(&self) -> Result<Option<Matrix>, MethodError> {
        Ok(Some(self.back.clone()))
    }

    fn patches(&self, x: &[Point]) -> Result<Vec<Box<dyn Patch>>, MethodError> {
        let net = self.patch.net();
        let net = Net::new(net.rows(), net.cols(), times(&self.back, x))?;
        Ok(vec![Box::new(self.patch.with_net(net)?)])
    }

    fn start(&self) -> (Vec<Point>, Option<[f64; 3]>) {
        (times(&self.values, &self.base), None)
    }
}

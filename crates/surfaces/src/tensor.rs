//! Patches with separated variables.

use std::sync::Arc;

use bases::{Aht, At, Basis, BasisError, Bernstein, Gt, Matrix};

use crate::{Domain, Jet, Net, Patch, Point, SurfaceError};

/// One product of families: function (i, j) of a patch is the sum over its products of `f_i(u) g_j(v)`.
#[derive(Debug, Clone)]
pub struct Product {
    /// The family in u, one function per row of the net.
    pub u: Arc<dyn Basis>,
    /// The family in v, one function per column of the net.
    pub v: Arc<dyn Basis>,
}

/// The patch `S(u, v) = Σ_ij P_ij Σ_s f^s_i(u) g^s_j(v)` on a control net.
///
/// With one product it is the tensor product patch of two bases (GT (3.2)); blends such as TB–Coons are sums of
/// a few products on the same net. Linear in the net, so every quadratic energy of it is a quadratic form
/// of the net.
///
/// ```
/// use surfaces::{Net, Patch, Point, TensorPatch};
/// let corner = |x, y, z| Point::new(x, y, z);
/// let net = Net::new(2, 2, vec![corner(0., 0., 0.), corner(0., 1., 0.), corner(1., 0., 0.), corner(1., 1., 1.)])?;
/// let saddle = TensorPatch::bernstein(net)?;
/// assert_eq!(saddle.point(0.5, 0.5), corner(0.5, 0.5, 0.25));
/// # Ok::<(), surfaces::SurfaceError>(())
/// ```
#[derive(Debug, Clone)]
pub struct TensorPatch {
    products: Vec<Product>,
    net: Net,
}

impl TensorPatch {
    /// The patch of `products` on `net`.
    ///
    /// # Errors
    /// [`SurfaceError::NoProduct`] without any product; [`SurfaceError::Size`] if a family does not have as many
    /// functions as the net has rows (u) or columns (v).
    pub fn new(products: Vec<Product>, net: Net) -> Result<Self, SurfaceError> {
        if products.is_empty() {
            return Err(SurfaceError::NoProduct);
        }
        for product in &products {
            let (rows, cols) = (product.u.count(), product.v.count());
            if (rows, cols) != (net.rows(), net.cols()) {
                return Err(SurfaceError::Size { rows, cols, found: net.points().len() });
            }
        }
        Ok(Self { products, net })
    }

    /// The Bernstein–Bézier patch of a net.
    ///
    /// # Errors
    /// [`SurfaceError::Basis`] for a degree that is not offered.
    pub fn bernstein(net: Net) -> Result<Self, SurfaceError> {
        let (m, n) = net.degrees();
        let product = Product { u: Arc::new(Bernstein::new(m)?), v: Arc::new(Bernstein::new(n)?) };
        Self::new(vec![product], net)
    }

    /// The GT–Bézier patch of a net with shape (α1, α2, β1, β2) (GT (3.2)).
    ///
    /// # Errors
    /// [`SurfaceError::Basis`] for a degree below 2 or a shape outside [0, 4].
    pub fn gt(net: Net, [a1, a2, b1, b2]: [f64; 4]) -> Result<Self, SurfaceError> {
        let (m, n) = net.degrees();
        let product = Product { u: Arc::new(Gt::new(m, [a1, a2])?), v: Arc::new(Gt::new(n, [b1, b2])?) };
        Self::new(vec![product], net)
    }

    /// The patch of a net in the functions of order 6 of AHT over `[0, spans[0]] × [0, spans[1]]`; a direction with two points is
    /// linear over [0, 1], whatever its span.
    ///
    /// # Errors
    /// [`SurfaceError::Basis`] for a span that [`Aht::new`] refuses; [`SurfaceError::Size`] if a direction has neither 2 nor 6 points.
    pub fn aht(net: Net, spans: [f64; 2]) -> Result<Self, SurfaceError> {
        Self::order_six(net, spans, |span| Ok(Arc::new(Aht::new(span)?)))
    }

    /// As [`Self::aht`], in the functions of AT.
    ///
    /// # Errors
    /// As [`Self::aht`], for [`At::new`].
    pub fn at(net: Net, spans: [f64; 2]) -> Result<Self, SurfaceError> {
        Self::order_six(net, spans, |span| Ok(Arc::new(At::new(span)?)))
    }

    fn order_six(
        net: Net,
        spans: [f64; 2],
        family: fn(f64) -> Result<Arc<dyn Basis>, BasisError>,
    ) -> Result<Self, SurfaceError> {
        let direction = |count: usize, span: f64| -> Result<Arc<dyn Basis>, BasisError> {
            if count == 2 { Ok(Arc::new(Bernstein::new(1)?)) } else { family(span) }
        };
        let [u, v] = [direction(net.rows(), spans[0])?, direction(net.cols(), spans[1])?];
        Self::new(vec![Product { u, v }], net)
    }

    /// The control net.
    pub fn net(&self) -> &Net {
        &self.net
    }

    /// The products of families.
    pub fn products(&self) -> &[Product] {
        &self.products
    }

    /// The ranges of u and v.
    pub fn rectangle(&self) -> [(f64, f64); 2] {
        [self.products[0].u.domain(), self.products[0].v.domain()]
    }

    /// The patch of the same families on another net.
    ///
    /// # Errors
    /// [`SurfaceError::Size`] if the net has another size.
    pub fn with_net(&self, net: Net) -> Result<Self, SurfaceError> {
        Self::new(self.products.clone(), net)
    }
}

impl Patch for TensorPatch {
    fn domain(&self) -> Domain {
        let [u, v] = self.rectangle();
        Domain::Rectangle { u, v }
    }

    fn jet(&self, u: f64, v: f64) -> Jet {
        self.jets(&[u], &[v])[0]
    }

    fn jets(&self, us: &[f64], vs: &[f64]) -> Vec<Jet> {
        let mut jets = vec![Jet::default(); us.len() * vs.len()];
        let mut curves = vec![Point::ZERO; 3 * self.net.cols()];
        for product in &self.products {
            let v_tables: Vec<Matrix> = vs.iter().map(|&v| product.v.evaluate(v, 2)).collect();
            for (a, &u) in us.iter().enumerate() {
                self.contract(product.u.evaluate(u, 2).as_slice(), &mut curves);
                for (b, g) in v_tables.iter().enumerate() {
                    add_jet(&mut jets[a * vs.len() + b], &curves, g.as_slice());
                }
            }
        }
        jets
    }

    fn point(&self, u: f64, v: f64) -> Point {
        self.points_at(&[[u, v]])[0]
    }

    fn points_at(&self, parameters: &[[f64; 2]]) -> Vec<Point> {
        let (rows, cols) = (self.net.rows(), self.net.cols());
        let mut points = vec![Point::ZERO; parameters.len()];
        let (mut f, mut g) = (vec![0.0; rows], vec![0.0; cols]);
        let mut curve = vec![Point::ZERO; cols];
        for product in &self.products {
            for (point, &[u, v]) in points.iter_mut().zip(parameters) {
                product.u.evaluate_into(u, 0, &mut f);
                product.v.evaluate_into(v, 0, &mut g);
                self.contract(&f, &mut curve);
                for (&p, &g) in curve.iter().zip(&g) {
                    *point += p * g;
                }
            }
        }
        points
    }

    fn jets_at(&self, parameters: &[[f64; 2]]) -> Vec<Jet> {
        let (rows, cols) = (self.net.rows(), self.net.cols());
        let mut jets = vec![Jet::default(); parameters.len()];
        let (mut f, mut g) = (vec![0.0; 3 * rows], vec![0.0; 3 * cols]);
        let mut curves = vec![Point::ZERO; 3 * cols];
        for product in &self.products {
            for (jet, &[u, v]) in jets.iter_mut().zip(parameters) {
                product.u.evaluate_into(u, 2, &mut f);
                product.v.evaluate_into(v, 2, &mut g);
                self.contract(&f, &mut curves);
                add_jet(jet, &curves, &g);
            }
        }
        jets
    }
}

impl TensorPatch {
    /// The net contracted in u: for each order of derivatives in `f` one curve in v, `Σ_i f_i^{(r)} P_ij`.
    fn contract(&self, f: &[f64], curves: &mut [Point]) {
        let (rows, cols) = (self.net.rows(), self.net.cols());
        curves.fill(Point::ZERO);
        for (curve, f) in curves.chunks_exact_mut(cols).zip(f.chunks_exact(rows)) {
            for (row, &f) in self.net.points().chunks_exact(cols).zip(f) {
                for (sum, &p) in curve.iter_mut().zip(row) {
                    *sum += p * f;
                }
            }
        }
    }
}

/// Adds one product at one point: `curves` are those of the orders 0, 1, 2 in u, `g` the functions in v and their derivatives.
fn add_jet(jet: &mut Jet, curves: &[Point], g: &[f64]) {
    let cols = curves.len() / 3;
    let ([c0, c1, c2], [g0, g1, g2]) =
        ([0, 1, 2].map(|r| &curves[r * cols..][..cols]), [0, 1, 2].map(|r| &g[r * cols..][..cols]));
    for j in 0..cols {
        jet.point += c0[j] * g0[j];
        jet.u += c1[j] * g0[j];
        jet.v += c0[j] * g1[j];
        jet.uu += c2[j] * g0[j];
        jet.uv += c1[j] * g1[j];
        jet.vv += c0[j] * g2[j];
    }
}

//! TB–Coons blends (GT §7).

use std::sync::Arc;

use bases::{Basis, Bernstein, Gt, Matrix, Stacked};

use crate::{Net, Product, SurfaceError, TensorPatch};

/// The two linear blending functions placed at the ends of a family of n + 1: ℓ₀ = 1 − t, ℓ_n = t, 0 between.
///
/// # Errors
/// [`SurfaceError::Basis`] never in fact: degree 1 is always offered.
pub fn end_blend(degree: usize) -> Result<Stacked, SurfaceError> {
    let map = Matrix::from_fn(degree + 1, 2, |i, j| if i == j * degree { 1.0 } else { 0.0 });
    Ok(Stacked::new(vec![Arc::new(Bernstein::new(1)?)], map)?)
}

/// `B_i − ℓ_i`: Bernstein functions of degree `degree` less the [`end_blend`]; all vanish at both ends.
///
/// # Errors
/// [`SurfaceError::Basis`] for a degree that is not offered.
pub fn bernstein_less_blend(degree: usize) -> Result<Stacked, SurfaceError> {
    let n = degree + 1;
    let map = Matrix::from_fn(n, n + 2, |i, j| match j.checked_sub(n) {
        None => f64::from(u8::from(i == j)),
        Some(end) => -f64::from(u8::from(i == end * degree)),
    });
    Ok(Stacked::new(vec![Arc::new(Bernstein::new(degree)?), Arc::new(Bernstein::new(1)?)], map)?)
}

/// The three surfaces of which the TB–Coons patch `S = R₁ + R₂ − T` of a net is made (GT (7.6), (7.7), (7.10), corrected), on the same net:
/// `R₁ = Σ Q_ij B_i(u) G_j(v)`, `R₂ = Σ Q_ij G_i(u) B_j(v)`, and T, the bilinear Coons patch of the four GT boundary curves.
///
/// ```
/// use surfaces::{Net, Patch, Point, tb_coons, tb_coons_parts};
/// let points = (0..16).map(|k| Point::new(f64::from(k / 4), f64::from(k % 4), f64::from(k * k % 7))).collect();
/// let (net, shape) = (Net::new(4, 4, points)?, [0.5, 1.0, 2.0, 3.5]);
/// let [r1, r2, t] = tb_coons_parts(net.clone(), shape)?.map(|part| part.point(0.3, 0.8));
/// assert!((r1 + r2 - t).distance(tb_coons(net, shape)?.point(0.3, 0.8)) < 1e-14);
/// # Ok::<(), surfaces::SurfaceError>(())
/// ```
///
/// # Errors
/// As [`tb_coons`].
pub fn tb_coons_parts(net: Net, [a1, a2, b1, b2]: [f64; 4]) -> Result<[TensorPatch; 3], SurfaceError> {
    let (m, n) = net.degrees();
    let gt_u: Arc<dyn Basis> = Arc::new(Gt::new(m, [a1, a2])?);
    let gt_v: Arc<dyn Basis> = Arc::new(Gt::new(n, [b1, b2])?);
    let [ends_u, ends_v] =
        [m, n].map(|degree| end_blend(degree).map(|ends| Arc::new(ends) as Arc<dyn Basis>));
    let (ends_u, ends_v) = (ends_u?, ends_v?);
    let minus = Matrix::from_fn(n + 1, 2, |i, j| if i == j * n { -1.0 } else { 0.0 });
    let minus_ends = Arc::new(Stacked::new(vec![Arc::new(Bernstein::new(1)?)], minus)?);
    let one = |u, v| TensorPatch::new(vec![Product { u, v }], net.clone());
    let r1 = one(Arc::new(Bernstein::new(m)?), Arc::clone(&gt_v))?;
    let r2 = one(Arc::clone(&gt_u), Arc::new(Bernstein::new(n)?))?;
    let products = vec![
        Product { u: Arc::clone(&ends_u), v: gt_v },
        Product { u: gt_u, v: ends_v },
        Product { u: ends_u, v: minus_ends },
    ];
    Ok([r1, r2, TensorPatch::new(products, net)?])
}

/// The TB–Coons patch `S = R₁ + R₂ − T` of a net with shape (α1, α2, β1, β2) (GT (7.6)–(7.11), corrected).
///
/// With ℓ the linear blending functions of the ends, T = Σ Q_ij (ℓ_i G_j + G_i ℓ_j − ℓ_i ℓ_j), so that
/// `S = Σ Q_ij [(B_i − ℓ_i)(u) G_j(v) + G_i(u) (B_j − ℓ_j)(v) + ℓ_i(u) ℓ_j(v)]`: three products on one net. Its boundary
/// curves are the Bernstein curves of the net for every shape.
///
/// # Errors
/// [`SurfaceError::Basis`] for a degree below 2 or a shape outside [0, 4].
pub fn tb_coons(net: Net, [a1, a2, b1, b2]: [f64; 4]) -> Result<TensorPatch, SurfaceError> {
    let (m, n) = net.degrees();
    let gt_u: Arc<dyn Basis> = Arc::new(Gt::new(m, [a1, a2])?);
    let gt_v: Arc<dyn Basis> = Arc::new(Gt::new(n, [b1, b2])?);
    let products = vec![
        Product { u: Arc::new(bernstein_less_blend(m)?), v: gt_v },
        Product { u: gt_u, v: Arc::new(bernstein_less_blend(n)?) },
        Product { u: Arc::new(end_blend(m)?), v: Arc::new(end_blend(n)?) },
    ];
    TensorPatch::new(products, net)
}

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

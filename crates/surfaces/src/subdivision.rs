//! Subdivision of curves and tensor patches: the de Casteljau-like algorithm of every family that has one.

use std::sync::Arc;

use bases::Matrix;

use crate::{Curve, Net, Pieces, Point, Product, SurfaceError, TensorPatch};

impl Curve {
    /// Most halvings of [`Self::refined`].
    pub const MAX_LEVELS: u32 = 16;

    /// The two pieces left and right of `t`; they share the point at `t` bit for bit. A piece's own parameter starts at 0
    /// (AHT and AT keep its speed, Bernstein rescales it to [0, 1]).
    ///
    /// # Errors
    /// [`SurfaceError::Basis`] for a family that cannot be subdivided and for `t` not inside the domain.
    pub fn subdivide(&self, t: f64) -> Result<[Self; 2], SurfaceError> {
        let cut = self.basis().subdivide(t)?;
        Ok([
            Self::new(cut.left, mapped(&cut.left_map, self.points()))?,
            Self::new(cut.right, mapped(&cut.right_map, self.points()))?,
        ])
    }

    /// The 2^`levels` pieces of repeated halving. Their polygons, one after the other, converge to the curve: each
    /// halving divides the distance by about 4.
    ///
    /// # Errors
    /// [`SurfaceError::Levels`] above [`Self::MAX_LEVELS`]; as for [`Self::subdivide`].
    pub fn refined(&self, levels: u32) -> Result<Vec<Self>, SurfaceError> {
        if levels > Self::MAX_LEVELS {
            return Err(SurfaceError::Levels { levels, max: Self::MAX_LEVELS });
        }
        let mut pieces = vec![self.clone()];
        for _ in 0..levels {
            let halves = pieces.iter().map(|piece| {
                let (start, end) = piece.basis().domain();
                piece.subdivide(start + 0.5 * (end - start))
            });
            pieces = halves.collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect();
        }
        Ok(pieces)
    }
}

impl TensorPatch {
    /// The two patches on either side of the parameter line u = `t`, as [`Curve::subdivide`]; all points of their nets are
    /// fixed. They share the net's row on the line bit for bit.
    ///
    /// # Errors
    /// [`SurfaceError::SeveralProducts`] for a blend, whose products would need different nets;
    /// [`SurfaceError::Basis`] for a family that cannot be subdivided and for `t` not inside the domain.
    pub fn subdivide_u(&self, t: f64) -> Result<[Self; 2], SurfaceError> {
        let product = self.single_product()?;
        let cut = product.u.subdivide(t)?;
        let side = |u, map: &Matrix| {
            let (rows, cols) = (self.net().rows(), self.net().cols());
            let columns: Vec<Vec<Point>> = (0..cols)
                .map(|j| {
                    let column: Vec<Point> = (0..rows).map(|i| self.net().point(i, j)).collect();
                    mapped(map, &column)
                })
                .collect();
            let points = (0..rows).flat_map(|i| columns.iter().map(move |column| column[i])).collect();
            Self::new(vec![Product { u, v: Arc::clone(&product.v) }], Net::new(rows, cols, points)?)
        };
        Ok([side(cut.left, &cut.left_map)?, side(cut.right, &cut.right_map)?])
    }

    /// The two patches on either side of the parameter line v = `t`, as [`Self::subdivide_u`].
    ///
    /// # Errors
    /// As for [`Self::subdivide_u`].
    pub fn subdivide_v(&self, t: f64) -> Result<[Self; 2], SurfaceError> {
        let product = self.single_product()?;
        let cut = product.v.subdivide(t)?;
        let side = |v, map: &Matrix| {
            let cols = self.net().cols();
            let points = self.net().points().chunks_exact(cols).flat_map(|row| mapped(map, row)).collect();
            let net = Net::new(self.net().rows(), cols, points)?;
            Self::new(vec![Product { u: Arc::clone(&product.u), v }], net)
        };
        Ok([side(cut.left, &cut.left_map)?, side(cut.right, &cut.right_map)?])
    }

    /// The patch cut along parameter lines: those of u at `cuts[0]`, of v at `cuts[1]`, each list ascending inside the domain. For the
    /// families that keep their speed where they are cut, AHT and AT; other directions admit no cut. Without any it is one piece.
    ///
    /// # Errors
    /// As for [`Self::subdivide_u`]; [`SurfaceError::Interval`] where a family that was cut does not keep its speed.
    pub fn cut(&self, cuts: [&[f64]; 2]) -> Result<Pieces, SurfaceError> {
        let along = |patch: &Self,
                     cuts: &[f64],
                     start: f64,
                     cut: fn(&Self, f64) -> Result<[Self; 2], SurfaceError>| {
            let (mut parts, mut rest, mut begin) = (Vec::new(), patch.clone(), start);
            for &at in cuts {
                let [part, after] = cut(&rest, at - begin)?;
                parts.push(part);
                (rest, begin) = (after, at);
            }
            parts.push(rest);
            Ok::<_, SurfaceError>(parts)
        };
        let [u, v] = self.rectangle();
        let mut patches = Vec::new();
        for strip in along(self, cuts[0], u.0, Self::subdivide_u)? {
            patches.extend(along(&strip, cuts[1], v.0, Self::subdivide_v)?);
        }
        let all = |(start, end): (f64, f64), inner: &[f64]| {
            std::iter::once(start).chain(inner.iter().copied()).chain(std::iter::once(end)).collect()
        };
        Pieces::from_patches(all(u, cuts[0]), all(v, cuts[1]), patches)
    }

    fn single_product(&self) -> Result<&Product, SurfaceError> {
        match self.products() {
            [product] => Ok(product),
            products => Err(SurfaceError::SeveralProducts { found: products.len() }),
        }
    }
}

/// `map · points`.
fn mapped(map: &Matrix, points: &[Point]) -> Vec<Point> {
    let combine = |i: usize| {
        let mut sum = Point::ZERO;
        for (&w, &p) in map.row(i).iter().zip(points) {
            sum += p * w;
        }
        sum
    };
    (0..map.rows()).map(combine).collect()
}

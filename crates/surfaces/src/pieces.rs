use std::ops::Range;

use crate::{Domain, Jet, Net, Patch, Point, SurfaceError, TensorPatch};

/// A surface cut along parameter lines into a grid of patches that meet exactly.
///
/// As a [`Patch`] it is the whole surface over the whole rectangle: a [`Mesh`](crate::Mesh) of it is one watertight mesh.
/// Each patch keeps its own parameters, shifted to start where its families do.
#[derive(Debug, Clone)]
pub struct Pieces {
    /// The parameters of the cuts in u and the two ends, ascending.
    u: Vec<f64>,
    v: Vec<f64>,
    /// Row by row, with u.
    patches: Vec<TensorPatch>,
}

impl Pieces {
    /// Most pieces in one direction.
    pub const MAX_PIECES: usize = 10_000;

    /// The surface whose piece (i, j) over `[u_i, u_{i+1}] × [v_j, v_{j+1}]` is `piece(i, j)`.
    pub(crate) fn new(
        u: Vec<f64>,
        v: Vec<f64>,
        piece: impl Fn(usize, usize) -> Result<TensorPatch, SurfaceError>,
    ) -> Result<Self, SurfaceError> {
        let grid = (0..u.len() - 1).flat_map(|i| (0..v.len() - 1).map(move |j| (i, j)));
        let patches = grid.map(|(i, j)| piece(i, j)).collect::<Result<_, _>>()?;
        Ok(Self { u, v, patches })
    }

    /// The surface made of given patches, all in v of the first in u first, with cuts at `u` and `v`, both ends included.
    /// That they meet is not checked.
    ///
    /// # Errors
    /// [`SurfaceError::Interval`] for cuts that do not ascend, or an interval as long as no domain of its patch to within
    /// rounding; [`SurfaceError::Size`] if there are not as many patches as intervals; [`SurfaceError::TooManyPieces`]
    /// beyond [`Self::MAX_PIECES`] in a direction.
    pub fn from_patches(u: Vec<f64>, v: Vec<f64>, patches: Vec<TensorPatch>) -> Result<Self, SurfaceError> {
        for (name, cuts) in [("u", &u), ("v", &v)] {
            let (start, end) = (cuts.first().copied(), cuts.last().copied());
            let (start, end) = (start.unwrap_or(f64::NAN), end.unwrap_or(f64::NAN));
            let ascending = cuts.len() > 1 && cuts.windows(2).all(|ends| ends[0] < ends[1]);
            if !(ascending && (end - start).is_finite()) {
                return Err(SurfaceError::Interval { name, start, end });
            }
            if cuts.len() > Self::MAX_PIECES + 1 {
                return Err(SurfaceError::TooManyPieces { name, span: end - start, max: Self::MAX_PIECES });
            }
        }
        let (rows, cols) = (u.len() - 1, v.len() - 1);
        if patches.len() != rows * cols {
            return Err(SurfaceError::Size { rows, cols, found: patches.len() });
        }
        for (k, patch) in patches.iter().enumerate() {
            let ends = [&u[k / cols..][..2], &v[k % cols..][..2]];
            for (name, (ends, (from, to))) in
                ["u", "v"].into_iter().zip(ends.into_iter().zip(patch.rectangle()))
            {
                let scale = ends[0].abs().max(ends[1].abs()).max(to - from);
                if ((ends[1] - ends[0]) - (to - from)).abs() > 8.0 * f64::EPSILON * scale {
                    return Err(SurfaceError::Interval { name, start: ends[0], end: ends[1] });
                }
            }
        }
        Ok(Self { u, v, patches })
    }

    /// Number of pieces in u and in v.
    pub fn shape(&self) -> [usize; 2] {
        [self.u.len() - 1, self.v.len() - 1]
    }

    /// The parameters of the cuts in u and in v, both ends included.
    pub fn cuts(&self) -> [&[f64]; 2] {
        [&self.u, &self.v]
    }

    /// The patches, all pieces in v of the first in u first.
    pub fn patches(&self) -> &[TensorPatch] {
        &self.patches
    }

    /// The surface of the same families whose nets are `p · self + q · other`, point by point.
    pub(crate) fn combined(&self, p: f64, other: &Self, q: f64) -> Result<Self, SurfaceError> {
        let combine = |(a, b): (&TensorPatch, &TensorPatch)| a.with_net(combined(a.net(), p, b.net(), q)?);
        let patches = self.patches.iter().zip(&other.patches).map(combine).collect::<Result<_, _>>()?;
        Ok(Self { u: self.u.clone(), v: self.v.clone(), patches })
    }
}

/// The net `p A + q B`.
fn combined(a: &Net, p: f64, b: &Net, q: f64) -> Result<Net, SurfaceError> {
    let points: Vec<Point> = a.points().iter().zip(b.points()).map(|(&a, &b)| a * p + b * q).collect();
    Net::new(a.rows(), a.cols(), points)
}

impl Patch for Pieces {
    fn domain(&self) -> Domain {
        let ends = |cuts: &[f64]| (cuts[0], cuts[cuts.len() - 1]);
        Domain::Rectangle { u: ends(&self.u), v: ends(&self.v) }
    }

    fn jet(&self, u: f64, v: f64) -> Jet {
        self.jets(&[u], &[v])[0]
    }

    fn jets(&self, us: &[f64], vs: &[f64]) -> Vec<Jet> {
        let mut jets = vec![Jet::default(); us.len() * vs.len()];
        for (i, u_run) in runs(&self.u, us) {
            for (j, v_run) in runs(&self.v, vs) {
                let patch = &self.patches[i * (self.v.len() - 1) + j];
                let Domain::Rectangle { u: (u0, _), v: (v0, _) } = patch.domain() else { continue };
                let local_u: Vec<f64> = us[u_run.clone()].iter().map(|u| u0 + (u - self.u[i])).collect();
                let local_v: Vec<f64> = vs[v_run.clone()].iter().map(|v| v0 + (v - self.v[j])).collect();
                let part = patch.jets(&local_u, &local_v);
                for (a, row) in u_run.clone().zip(part.chunks_exact(local_v.len())) {
                    jets[a * vs.len()..][v_run.clone()].copy_from_slice(row);
                }
            }
        }
        jets
    }
}

/// Runs of consecutive parameters that lie in one piece, as (piece, places); a cut belongs to the piece after it.
fn runs(cuts: &[f64], parameters: &[f64]) -> Vec<(usize, Range<usize>)> {
    let last = cuts.len() - 2;
    let piece = |t: f64| cuts.partition_point(|cut| *cut <= t).saturating_sub(1).min(last);
    let mut runs: Vec<(usize, Range<usize>)> = Vec::new();
    for (place, &t) in parameters.iter().enumerate() {
        match runs.last_mut() {
            Some((current, run)) if *current == piece(t) => run.end = place + 1,
            _ => runs.push((piece(t), place..place + 1)),
        }
    }
    runs
}

/// `[start, end]` as it is up to the length `whole`, and cut into the least number of equal pieces of at most `largest`
/// beyond; both ends included.
pub(crate) fn equal_cuts(
    name: &'static str,
    (start, end): (f64, f64),
    whole: f64,
    largest: f64,
) -> Result<Vec<f64>, SurfaceError> {
    let span = end - start;
    if !(span > 0.0 && span.is_finite()) {
        return Err(SurfaceError::Interval { name, start, end });
    }
    let count = if span <= whole { 1.0 } else { (span / largest).ceil() };
    if count > Pieces::MAX_PIECES as f64 {
        return Err(SurfaceError::TooManyPieces { name, span, max: Pieces::MAX_PIECES });
    }
    let count = count as usize;
    let mut cuts: Vec<f64> = (0..count).map(|k| start + span * (k as f64 / count as f64)).collect();
    cuts.push(end);
    Ok(cuts)
}

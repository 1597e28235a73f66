//! The figures a patch is judged by.

use energy::{EnergyError, Functional, Integral, area, integrate};
use surfaces::{Jet, Mesh, Patch};

/// Energies, area and curvature of a patch, each computed by quadrature from the patch itself, whatever made it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Figures {
    /// Dirichlet energy ½∫(E + G), length².
    pub dirichlet: Integral,
    /// Area ∫√(EG − F²), length².
    pub area: Integral,
    /// ∫‖x_uu + x_vv‖², length².
    pub laplacian_defect: Integral,
    /// ∫‖x_uu‖² + 2‖x_uv‖² + ‖x_vv‖², length².
    pub bending: Integral,
    /// The quadratic energy that was minimised, where it is none of those above, length².
    pub minimised: Option<(Functional, Integral)>,
    /// (D − A)/A: 0 exactly for conformal charts. None for a patch without area.
    pub conformality_gap: Option<f64>,
    /// Largest |H| at the vertices of the mesh, 1/length. None for a patch without area, or if it is singular at all of them.
    pub mean_curvature_max: Option<f64>,
    /// Root mean square of H over the area, 1/length. None for a patch without area, or if it does not exist.
    pub mean_curvature_rms: Option<f64>,
    /// ∫H² dA, of which that is made; without unit. None for a patch without area.
    pub mean_curvature_square: Option<Integral>,
}

/// Relative accuracy asked of the energies.
const TOLERANCE: f64 = 1e-12;

/// An area below this share of (coordinates and tangents) × tangents is rounding.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Likewise of the distance at which a boundary was given: its coordinates were rounded there, but no sum was made of them.
const ROUNDING_OF_INPUT: f64 = 4.0 * f64::EPSILON;

impl Figures {
    /// The figures of `patch`; `mesh` is a mesh of the same patch.
    ///
    /// # Errors
    /// As [`energy::integrate`].
    pub fn of(patch: &dyn Patch, mesh: &Mesh) -> Result<Self, EnergyError> {
        Self::of_all(&[patch], mesh)
    }

    /// The figures of a surface of several patches: energies and areas are summed over them, each over its own parameters.
    /// `mesh` is a mesh of all.
    ///
    /// # Errors
    /// As [`energy::integrate`].
    pub fn of_all(patches: &[&dyn Patch], mesh: &Mesh) -> Result<Self, EnergyError> {
        Self::of_moved(patches, mesh, 0.0)
    }

    /// As [`Self::of_all`], of patches whose boundary was given `distance` away from where they lie, and rounded to the coordinates
    /// there: an area that such rounding makes is none.
    pub(crate) fn of_moved(patches: &[&dyn Patch], mesh: &Mesh, distance: f64) -> Result<Self, EnergyError> {
        let [area] = summed(patches, |patch| Ok([area(patch)?]))?;
        let [dirichlet] =
            summed(patches, |patch| integrate(patch, TOLERANCE, [0.0], |jet| [jet.dirichlet_density()]))?;
        let scale = dirichlet.value;
        let second = |jet: &Jet| {
            let laplacian = jet.laplacian();
            [laplacian.dot(laplacian), jet.uu.dot(jet.uu) + 2.0 * jet.uv.dot(jet.uv) + jet.vv.dot(jet.vv)]
        };
        let [laplacian_defect, bending] =
            summed(patches, |patch| integrate(patch, TOLERANCE, [scale; 2], second))?;
        // What is no more than the rounding of the tangents is no area, and no curvature comes of it.
        let reach = mesh.points.iter().map(|p| p.norm()).fold(0.0, f64::max);
        let size = reach.max((2.0 * dirichlet.value).sqrt());
        let rounding = (ROUNDING * size).max(ROUNDING_OF_INPUT * distance);
        let has_area = area.value > rounding * dirichlet.value.sqrt();
        // ∫H² has no unit: measured against 1. It may diverge at singular points; then it stays unsettled.
        let willmore = |jet: &Jet| [jet.mean_curvature().map_or(0.0, |h| h * h * jet.area_density())];
        let square = match has_area {
            true => Some(summed(patches, |patch| integrate(patch, 1e-6, [1.0], willmore))?[0]),
            false => None,
        };
        let rms = square.filter(|s| s.settled).map(|s| (s.value / area.value).sqrt());
        let largest = mesh.mean_curvature.iter().flatten().map(|h| h.abs()).reduce(f64::max);
        Ok(Self {
            dirichlet,
            area,
            laplacian_defect,
            bending,
            minimised: None,
            conformality_gap: has_area.then(|| (dirichlet.value - area.value) / area.value),
            mean_curvature_max: largest.filter(|h| has_area && h.is_finite()),
            mean_curvature_rms: rms.filter(|rms| rms.is_finite()),
            mean_curvature_square: square,
        })
    }

    /// A quadratic energy, if it is known.
    #[must_use]
    pub fn quadratic(&self, functional: Functional) -> Option<Integral> {
        let of_every_surface = [
            (Functional::Dirichlet, self.dirichlet),
            (Functional::Laplacian, self.laplacian_defect),
            (Functional::Bending, self.bending),
        ];
        let mut known = of_every_surface.into_iter().chain(self.minimised);
        known.find(|(known, _)| *known == functional).map(|(_, value)| value)
    }

    /// These figures of `patches` with a quadratic energy that they minimise.
    ///
    /// # Errors
    /// As [`energy::integrate`].
    pub(crate) fn with_minimised(
        mut self,
        functional: Functional,
        patches: &[&dyn Patch],
    ) -> Result<Self, EnergyError> {
        if self.quadratic(functional).is_none() {
            let scale = self.dirichlet.value;
            let density = |jet: &Jet| [functional.density(jet)];
            let [value] = summed(patches, |patch| integrate(patch, TOLERANCE, [scale], density))?;
            self.minimised = Some((functional, value));
        }
        Ok(self)
    }
}

/// K integrals over several patches, their errors added; settled if all are.
fn summed<const K: usize>(
    patches: &[&dyn Patch],
    of: impl Fn(&dyn Patch) -> Result<[Integral; K], EnergyError>,
) -> Result<[Integral; K], EnergyError> {
    let mut sums = [Integral { value: 0.0, error: 0.0, points: 0, settled: true }; K];
    for &patch in patches {
        for (sum, part) in sums.iter_mut().zip(of(patch)?) {
            sum.value += part.value;
            sum.error += part.error;
            sum.points = sum.points.max(part.points);
            sum.settled &= part.settled;
        }
    }
    Ok(sums)
}

//! What least areas cost, told before they are begun.

use crate::{Displacement, Energy, Family, Filling, Method, Search, SearchMode, memory};

/// What the least areas of one method take, by counting.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Cost {
    /// Least areas that are found: one, or one for every shape that is tried.
    pub least_areas: u64,
    /// Seconds for all of them on one core of 2020, within a factor of three or so. Runs of a search share the cores.
    pub seconds: f64,
    /// Whether that is the most: of nets of high degree higher displacements are tried only where lower ones do not do.
    pub is_most: bool,
    /// Bytes of the largest arrays at once.
    pub bytes: usize,
}

/// Newton steps to a least area by a tolerance of 1e-10 from all its starts, in the mean over frames.
const STEPS: f64 = 40.0;

/// Those from a surface of nearly least area.
const NEAR_STEPS: f64 = 8.0;

/// Multiplications and additions a second, as far as these loops reach them.
const SPEED: f64 = 4e9;

/// Seconds of a step that no array takes.
const CALLS: f64 = 2e-5;

/// Patches that a layer at four corners makes of one.
const PATCHES: f64 = 12.0;

/// Shapes that a descent tries, in the mean.
const DESCENT: u64 = 15;

impl Method {
    /// What this method costs over a net of these degrees before it is raised; none if it finds no least area. `search` counts
    /// if the shape is searched.
    #[must_use]
    pub fn cost(&self, degrees: (usize, usize), search: &Search) -> Option<Cost> {
        if self.minimised() != Some(Energy::Area) {
            return None;
        }
        let least_areas = self.search_mode().map_or(1, |mode| search.shapes(mode).saturating_add(1));
        let (m, n) = (degrees.0 + self.raise(), degrees.1 + self.raise());
        let patches = if self.family() == Family::Complex { PATCHES } else { 1.0 };
        let is_displaced = self.family() == Family::Bernstein && m.max(n) > Displacement::WHOLE;
        let each = if is_displaced {
            of_displacements(m, n)
        } else {
            STEPS * (CALLS + patches * operations(self.filling(), m as f64, n as f64) / SPEED)
        };
        Some(Cost {
            least_areas,
            seconds: least_areas as f64 * each,
            is_most: is_displaced,
            bytes: match is_displaced {
                true => memory::of_displacement(Displacement::largest((m, n))),
                false => memory::of_method(self, degrees),
            },
        })
    }
}

/// Seconds for all displacements that are tried for a net of high degree.
fn of_displacements(m: usize, n: usize) -> f64 {
    let line = 1.5 * m.max(n) as f64 + 4.0;
    let of = |(k, degree): (usize, usize)| {
        let (m, n) = (m.min(degree) as f64, n.min(degree) as f64);
        // Each but the first begins near its end.
        let steps = if k == 0 { STEPS } else { NEAR_STEPS };
        steps * (CALLS + of_products(line, m, n) / SPEED)
    };
    Displacement::tried(m.max(n)).enumerate().map(of).sum()
}

impl Search {
    /// How many shapes a search tries, about.
    #[must_use]
    pub fn shapes(&self, mode: SearchMode) -> u64 {
        let runs = self.runs() as u64;
        let swarm =
            (self.particles() as u64).saturating_mul(self.iterations() as u64 + 1).saturating_mul(runs);
        match mode {
            SearchMode::Pso => swarm,
            SearchMode::Polish => DESCENT * runs,
            SearchMode::PsoPolish => swarm.saturating_add(DESCENT * runs),
        }
    }
}

/// Multiplications and additions of one Newton step: the Hessian over a rule of about the degree and a half, and its factorisation.
fn operations(filling: &Filling, m: f64, n: f64) -> f64 {
    let line = 1.5 * m.max(n) + 4.0;
    let cube = |unknowns: f64| unknowns.powi(3) / 3.0;
    match filling {
        // Sums over all points for all pairs of unknowns.
        Filling::Tensor { functions, .. } if functions.is_blend() => {
            let unknowns = 3.0 * (m - 1.0).max(0.0) * (n - 1.0).max(0.0);
            2.0 * (line * unknowns).powi(2) + cube(unknowns)
        }
        Filling::Tensor { .. } => of_products(line, m, n),
        Filling::Triangle(_) => {
            let unknowns = 1.5 * (n - 1.0).max(0.0) * (n - 2.0).max(0.0);
            let line = 0.75 * n + 6.0;
            6.0 * (line * unknowns).powi(2) + cube(unknowns)
        }
    }
}

/// The same for products of functions of degrees m and n: sums over v for every line of constant u, then over u.
fn of_products(line: f64, m: f64, n: f64) -> f64 {
    let free = (m - 1.0).max(0.0) * (n - 1.0).max(0.0);
    30.0 * (line * n).powi(2) + 24.0 * line * (m * n).powi(2) + (3.0 * free).powi(3) / 3.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use surfaces::ShapedFamily;

    use crate::{FixedShape, Functions, SolverChoice, TensorInterior};

    const LEAST: TensorInterior = TensorInterior::LeastArea { tolerance: 1e-10, bound: false, layers: 0 };

    fn method(functions: Functions, raise: usize) -> Method {
        Method::tensor("a", functions, LEAST).and_then(|method| method.raised(raise)).expect("a method")
    }

    #[test]
    fn a_swarm_costs_hundreds_of_times_what_descents_do_and_no_search_nothing() {
        let of = |functions| method(functions, 0).cost((3, 3), &Search::default()).expect("a least area");
        let searched =
            |mode| Functions::Searched { family: ShapedFamily::Gt, mode, energy: Energy::Area.into() };
        let fixed = FixedShape::new(ShapedFamily::Gt, vec![1.0; 4]).expect("a shape");
        let one = of(Functions::Shaped(fixed));
        let [polish, swarm] = [SearchMode::Polish, SearchMode::Pso].map(|mode| of(searched(mode)));
        assert_eq!([one.least_areas, polish.least_areas, swarm.least_areas], [1, 151, 50_501]);
        assert!(swarm.seconds > 300.0 * polish.seconds && polish.seconds > 100.0 * one.seconds);
        let dirichlet =
            TensorInterior::Extremal { energy: energy::Functional::Dirichlet, solver: SolverChoice::Auto };
        let other = Method::tensor("a", Functions::Bernstein, dirichlet).expect("a method");
        assert_eq!(other.cost((3, 3), &Search::default()), None);
    }

    #[test]
    fn time_and_memory_grow_with_the_degree() {
        let of = |raise| {
            method(Functions::Bernstein, raise).cost((2, 2), &Search::default()).expect("a least area")
        };
        // From degree 17 on by displacements, the whole net from 33 on no longer among them.
        for raise in (0..14).chain(15..30).chain(31..62) {
            let (lower, higher) = (of(raise), of(raise + 1));
            assert!(lower.seconds < higher.seconds && lower.bytes <= higher.bytes, "{lower:?} {higher:?}");
            assert_eq!([lower, higher].map(|cost| cost.is_most), [raise > 14; 2], "{raise}");
        }
        assert!(of(30).seconds > 100.0 * of(8).seconds);
        assert!(of(62).seconds < 120.0 && of(62).bytes < 1 << 30, "{:?}", of(62));
    }
}

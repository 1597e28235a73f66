//! Layers of smaller patches around corners.

use std::collections::HashSet;

use energy::EnergyError;

use super::options::Fill;
use super::solution::Solution;
use crate::corners::graded;
use crate::{AreaEnd, AreaExtremal, MethodError, Progress, Seams, least_area_complex_near, odd_corners};

impl Fill {
    /// The surface with one layer more around its odd corners; as it is where there is none, or the layer does not lower the area, or it was
    /// no stable minimum before.
    pub(super) fn layered(
        &self,
        solution: Solution,
        progress: &dyn Progress,
    ) -> Result<Solution, MethodError> {
        let corners = odd_corners(&solution.complex);
        let is_minimum = |found: &AreaExtremal| {
            found.end == AreaEnd::Stationary && found.second_variation.is_none_or(|least| least >= 0.0)
        };
        let is_coarse = |found: &&AreaExtremal| is_minimum(found) && !corners.is_empty();
        let Some(coarse) = solution.extremal.as_ref().filter(is_coarse) else {
            return Ok(solution);
        };
        // What cannot be made, or is singular, costs nothing that was found.
        let Ok(fine) = graded(&solution.complex, &corners) else { return Ok(solution) };
        let (complex, found) = match least_area_complex_near(&fine, self.tolerance, progress) {
            Err(MethodError::Energy(EnergyError::Singular { .. })) => return Ok(solution),
            found => found?,
        };
        let seams = Seams::of(&complex)?;
        if found.area.value >= coarse.area.value || seams.folds() && !solution.seams.folds() {
            return Ok(solution);
        }
        let names = more_names(&solution.names, complex.vertices());
        Ok(Solution { complex, names, layers: solution.layers + 1, extremal: Some(found), seams, ..solution })
    }
}

/// These names and new ones `#1`, `#2`, … that none of them is, `count` in all.
fn more_names(names: &[String], count: usize) -> Vec<String> {
    let taken: HashSet<&String> = names.iter().collect();
    let new = (1..).map(|k| format!("#{k}")).filter(|name| !taken.contains(name));
    names.iter().cloned().chain(new).take(count).collect()
}

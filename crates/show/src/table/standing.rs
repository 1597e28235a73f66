//! Which of several surfaces over the same boundary has the least area, and how far the others lie above it.

use plateau::{Done, Notation};

/// How a surface stands among those over the same boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Standing {
    /// None has less area, beyond the errors of the areas.
    Best,
    /// Its area lies above the least by this share of the least.
    Above(f64),
    /// Its boundary curves are not those of the others: its area cannot be compared.
    Apart,
    /// There is nothing to compare: no surface, no area, a closed form, or no other surface.
    Alone,
}

impl Standing {
    /// As a table says it.
    pub(crate) fn in_words(self) -> String {
        match self {
            Self::Best => "least".into(),
            Self::Above(share) => format!("+{}", Notation::Percent(3).of(share)),
            Self::Apart => "moved".into(),
            Self::Alone => String::new(),
        }
    }
}

/// Boundary curves that moved by this much beside the root of the Dirichlet energy have not moved.
pub(crate) const UNMOVED: f64 = 1e-12;

/// The standing of every row; a row that failed is none.
pub(crate) fn standings(rows: &[Option<&Done>]) -> Vec<Standing> {
    let least = rows.iter().flatten().filter(|done| keeps_boundary(done)).map(|done| done.figures.area);
    let compared = least.clone().count();
    let least = least.min_by(|a, b| a.value.total_cmp(&b.value));
    let standing = |done: &Option<&Done>| match (done, least) {
        (Some(done), _) if done.boundary.is_some() && !keeps_boundary(done) && has_area(done) => {
            Standing::Apart
        }
        (Some(done), Some(least)) if compared > 1 && keeps_boundary(done) => {
            let (area, above) = (done.figures.area, done.figures.area.value - least.value);
            let is_least = above <= area.error + least.error + 1e-12 * least.value;
            if is_least { Standing::Best } else { Standing::Above(above / least.value) }
        }
        _ => Standing::Alone,
    };
    rows.iter().map(standing).collect()
}

/// Whether it is a surface whose area may be compared: with an area, over the boundary that was asked for.
fn keeps_boundary(done: &Done) -> bool {
    let size = done.figures.dirichlet.value.sqrt();
    let moved = done.boundary.is_some_and(|boundary| boundary.deviation > UNMOVED * size);
    has_area(done) && done.closed_form.is_none() && !moved
}

fn has_area(done: &Done) -> bool {
    done.figures.conformality_gap.is_some() && done.figures.area.value > 0.0
}

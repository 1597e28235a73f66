use std::collections::BTreeMap;

use plateau::{Done, Energy, Functional, Quantity};
use serde::{Deserialize, Serialize};

/// The energies that a method minimised, beside those of every surface: each by its key, with its error by `…_error`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(from = "BTreeMap<String, serde_json::Value>")]
pub(super) struct Minimised(BTreeMap<String, f64>);

/// The keys of figures that not every surface has.
fn keys() -> impl Iterator<Item = Quantity> {
    let of_every_surface = |quantity: &Quantity| {
        matches!(quantity, Quantity::Dirichlet | Quantity::LaplacianDefect | Quantity::Bending)
    };
    let quadratic = Functional::ALL.into_iter().map(|energy| Quantity::of_energy(Energy::Quadratic(energy)));
    quadratic.filter(move |quantity| !of_every_surface(quantity))
}

fn error_of(key: &str) -> String {
    format!("{key}_error")
}

impl Minimised {
    pub(super) fn of(done: &Done) -> Self {
        let mut entries = BTreeMap::new();
        for quantity in keys() {
            let Some(figure) = quantity.of(done) else { continue };
            let both =
                [(quantity.key().to_owned(), Some(figure.value)), (error_of(quantity.key()), figure.error)];
            let finite = both.into_iter().filter_map(|(key, value)| Some((key, value?)));
            entries.extend(finite.filter(|(_, value)| value.is_finite()));
        }
        Self(entries)
    }
}

impl From<BTreeMap<String, serde_json::Value>> for Minimised {
    /// Of all keys of an entry, those of such energies.
    fn from(entry: BTreeMap<String, serde_json::Value>) -> Self {
        let is_known = |key: &str| keys().any(|q| key == q.key() || key == error_of(q.key()));
        let known = entry.into_iter().filter(|(key, _)| is_known(key));
        Self(known.filter_map(|(key, value)| Some((key, value.as_f64()?))).collect())
    }
}

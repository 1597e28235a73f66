//! "Did you mean …?"

use strsim::osa_distance;

/// Longest word that is compared; a longer one resembles no key.
const LONGEST: usize = 48;

/// The candidate that `word` most likely misspells, if any comes near: the optimal string alignment
/// distance may be a third of the longer word, or 1 for words of two or three letters, or one of the two begins or ends the
/// other; ties go to the earlier candidate.
pub(crate) fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if word.is_empty() || word.len() > LONGEST {
        return None;
    }
    let word = word.to_lowercase().replace('_', "-");
    candidates
        .into_iter()
        .filter_map(|candidate| {
            let distance = osa_distance(&word, candidate);
            let longer = word.chars().count().max(candidate.chars().count());
            let near = 3 * distance <= longer || (distance == 1 && longer > 1);
            let part =
                word.chars().count() >= 3 && (candidate.starts_with(&word) || candidate.ends_with(&word));
            let whole = candidate.chars().count() >= 3 && word.starts_with(candidate);
            (near || part || whole).then_some((distance, candidate))
        })
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// At most 60 characters of a text that comes from the file.
pub(crate) fn shorten(text: &str) -> String {
    match text.char_indices().nth(60) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_near_words_are_proposed() {
        let keys = ["energy", "search", "search-energy", "basis", "u0", "u1"];
        assert_eq!(nearest("Energy", keys), Some("energy"));
        assert_eq!(nearest("search_energy", keys), Some("search-energy"));
        assert_eq!(nearest("engery", keys), Some("energy"));
        assert_eq!(nearest("coons", ["tensor", "tb-coons"]), Some("tb-coons"));
        assert_eq!(nearest("Dirichlet energy", ["area", "dirichlet"]), Some("dirichlet"));
        assert_eq!(nearest("colour", keys), None);
        assert_eq!(nearest("u2", keys), Some("u0"));
        assert_eq!(nearest("x", keys), None);
        assert_eq!(nearest("", keys), None);
        assert_eq!(nearest(&"e".repeat(10_000), keys), None);
    }
}

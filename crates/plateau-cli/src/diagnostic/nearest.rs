//! "Did you mean …?"

/// Longest word that is compared; a longer one resembles no key.
const LONGEST: usize = 48;

/// The candidate that `word` most likely misspells, if any comes near: the optimal string alignment
/// distance may be a third of the longer word, or 1 for words of two or three letters, or one of the two begins or ends the
/// other; ties go to the earlier candidate.
pub(crate) fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if word.is_empty() || word.len() > LONGEST {
        return None;
    }
    let word: Vec<char> = word.to_lowercase().replace('_', "-").chars().collect();
    candidates
        .into_iter()
        .filter_map(|candidate| {
            let letters: Vec<char> = candidate.chars().collect();
            let distance = alignment_distance(&word, &letters);
            let longer = word.len().max(letters.len());
            let near = 3 * distance <= longer || (distance == 1 && longer > 1);
            let part = word.len() >= 3 && (letters.starts_with(&word) || letters.ends_with(&word));
            let whole = letters.len() >= 3 && word.starts_with(&letters);
            (near || part || whole).then_some((distance, candidate))
        })
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// Least number of insertions, deletions, replacements and exchanges of neighbours.
fn alignment_distance(a: &[char], b: &[char]) -> usize {
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        rows[i][0] = i;
    }
    for j in 0..=b.len() {
        rows[0][j] = j;
    }
    for i in 1..=a.len() {
        for j in 1..=b.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut least = replaced.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = least;
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distance_counts_edits() {
        let distance = |a: &str, b: &str| {
            alignment_distance(&a.chars().collect::<Vec<_>>(), &b.chars().collect::<Vec<_>>())
        };
        assert_eq!(distance("", "abc"), 3);
        assert_eq!(distance("energy", "energy"), 0);
        assert_eq!(distance("enrgy", "energy"), 1);
        assert_eq!(distance("enegry", "energy"), 1);
        assert_eq!(distance("mask", "basis"), 3);
    }

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

//! Names of methods as names of files.

use std::collections::{HashMap, HashSet};

use crate::folder::{caseless, is_device};

/// Most bytes of a method's name in that of a file: file systems take 255, extension and number included.
const LONGEST: usize = 200;

/// Names of files: lower case, words joined by dashes, made distinct by a number where needed; taken by every system, and
/// distinct on disks that do not tell capitals apart.
pub(crate) fn file_names<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let (mut taken, mut numbers) = (HashSet::new(), HashMap::new());
    let mut distinct = |name: &str| {
        let plain = plain(name);
        let mut file = plain.clone();
        // Numbers go on where they stopped: thousands of equal names are no trouble.
        let number = numbers.entry(caseless(&plain)).or_insert(1_usize);
        while !taken.insert(caseless(&file)) {
            *number += 1;
            file = format!("{plain}-{number}");
        }
        file
    };
    names.map(&mut distinct).collect()
}

fn plain(name: &str) -> String {
    let words: Vec<String> = name
        .split(|c: char| !c.is_alphanumeric())
        .filter(|word| !word.is_empty())
        .map(str::to_lowercase)
        .collect();
    let mut plain: String = words.join("-").chars().take(80).collect();
    plain.truncate(plain.floor_char_boundary(LONGEST));
    match plain.as_str() {
        "" => "method".into(),
        device if is_device(device) => format!("method-{device}"),
        _ => plain,
    }
}

#[cfg(test)]
mod tests {
    use super::file_names;

    #[test]
    fn file_names_are_plain_and_distinct() {
        let names = ["GT Dirichlet + PSO", "../../etc", "GT (Dirichlet) PSO", "∂∂", "…"];
        assert_eq!(
            file_names(names.into_iter()),
            ["gt-dirichlet-pso", "etc", "gt-dirichlet-pso-2", "method", "method-2"]
        );
        // A number may be taken by a name.
        assert_eq!(file_names(["a 2", "a", "a", "a"].into_iter()), ["a-2", "a", "a-3", "a-4"]);
    }

    #[test]
    fn file_names_are_taken_by_every_system() {
        let names = ["con", "CON", "AUX", "nul.", "com¹", "com 1", "straße", "STRASSE", "ς", "Σ"];
        let files = [
            "method-con",
            "method-con-2",
            "method-aux",
            "method-nul",
            "method-com¹",
            "com-1",
            "straße",
            "strasse-2",
            "ς",
            "σ-2",
        ];
        assert_eq!(file_names(names.into_iter()), files);
    }

    #[test]
    fn thousands_of_equal_names_are_told_apart() {
        let names = file_names(std::iter::repeat_n("m", 100_000));
        assert_eq!((names[0].as_str(), names[99_999].as_str()), ("m", "m-100000"));
    }

    #[test]
    fn file_names_are_short_enough_for_file_systems() {
        for letter in ["a", "é", "語", "𝒜", "İ"] {
            let long = letter.repeat(300);
            let names = file_names([long.as_str(), long.as_str()].into_iter());
            assert!(names.iter().all(|name| (80..=220).contains(&name.len())), "{names:?}");
            assert_ne!(names[0], names[1]);
        }
    }
}

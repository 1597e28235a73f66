//! The folder of an experiment: where it lies and what the files in it are called.

use std::path::{Path, PathBuf};

use exchange::Format;
use experiment::Plan;
use show::PICTURES;

/// The record of an experiment.
pub const RESULT_FILE: &str = "result.json";
/// The page of an experiment.
pub const REPORT_FILE: &str = "report.html";
/// The samples of a curve.
pub(crate) const CURVE_FILE: &str = "curve.csv";
/// A deformation of helicoids.
pub(crate) const DEFORMATION_FILE: &str = "deformation.glb";

/// The folder of the results of `plan` below `out`: called like the experiment file, without its extension, but for what
/// some systems do not take in a name.
///
/// ```
/// use experiment::{Plan, Template};
/// use record::folder;
///
/// let text = Template::Tensor.text();
/// let of = |file: &str| Plan::parse(file, text).map(|plan| folder(&plan, "out".as_ref()));
/// assert_eq!(of("my frames/saddle.toml")?, std::path::Path::new("out/saddle"));
/// assert_eq!(of("con.toml")?, std::path::Path::new("out/experiment-con"));
/// # Ok::<(), experiment::Refusal>(())
/// ```
pub fn folder(plan: &Plan, out: &Path) -> PathBuf {
    folder_of(&plan.stem, out)
}

/// The folder below `out` of whatever has this name, as [`folder`] calls that of an experiment by its stem.
pub fn folder_of(stem: &str, out: &Path) -> PathBuf {
    out.join(folder_name(stem))
}

/// A name by which folders are compared: equal where a disk that does not tell capitals apart sees one folder.
pub fn folder_key(stem: &str) -> String {
    caseless(&folder_name(stem))
}

/// The file of a method's surface; `name` is its name among [`file_names`](crate::file_name::file_names).
pub(crate) fn surface_file(name: &str, format: Format) -> String {
    format!("{name}.{}", format.ending())
}

pub(crate) fn picture_file(name: &str) -> String {
    format!("{name}.svg")
}

/// Whether files of experiments, not of methods, have this name.
pub(crate) fn is_file_of_experiment(file: &str) -> bool {
    [REPORT_FILE, CURVE_FILE, DEFORMATION_FILE].contains(&file)
        || PICTURES.iter().any(|picture| file == picture_file(picture))
}

/// A stem as a name that every system takes.
pub(crate) fn folder_name(stem: &str) -> String {
    let taken = |c: char| !c.is_control() && !r#"<>:"/\|?*"#.contains(c);
    let name: String = stem.chars().map(|c| if taken(c) { c } else { '-' }).collect();
    // Windows drops these from the end of a name without a word.
    let name = name.trim_end_matches(['.', ' ']);
    if name.is_empty() || is_device(name) {
        format!("experiment-{name}").trim_end_matches('-').into()
    } else {
        name.into()
    }
}

/// Whether Windows takes a name for that of a device, with any extension and in any folder.
pub(crate) fn is_device(name: &str) -> bool {
    let name = name.split('.').next().unwrap_or_default().trim_end().to_uppercase();
    let numbered = |device| {
        let number = name.strip_prefix(device).map(|rest| rest.chars().collect::<Vec<_>>());
        matches!(number.as_deref(), Some(['0'..='9' | '¹' | '²' | '³']))
    };
    ["CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"].contains(&name.as_str())
        || numbered("COM")
        || numbered("LPT")
}

/// A name without the differences of capitals and small letters, as far as any file system goes: `ß` is `SS` to some.
pub(crate) fn caseless(name: &str) -> String {
    name.to_uppercase().to_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_folders_are_taken_by_every_system() {
        for (stem, name) in [
            ("saddle", "saddle"),
            ("Über 5.1", "Über 5.1"),
            ("con", "experiment-con"),
            ("AUX.v2", "experiment-AUX.v2"),
            ("com1", "experiment-com1"),
            ("Lpt²", "experiment-Lpt²"),
            ("com10", "com10"),
            ("console", "console"),
            ("a. .", "a"),
            (". .", "experiment"),
            ("a:b?", "a-b-"),
            ("a\u{1b}[2J", "a-[2J"),
        ] {
            assert_eq!(folder_name(stem), name);
        }
    }

    #[test]
    fn names_of_one_folder_have_one_key() {
        for (a, b) in [("A", "a"), ("STRASSE", "straße"), ("Σς", "σσ"), ("ſ", "S"), ("ﬁ", "FI")] {
            assert_eq!(caseless(a), caseless(b));
        }
        assert_ne!(caseless("é"), caseless("e"));
    }
}

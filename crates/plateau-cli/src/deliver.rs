//! The folder of a finished experiment.

use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::export::{Subject, exporter};
use crate::result::ResultFile;
use crate::run::Finished;
use crate::{Plan, atomic};

/// A result that could not be kept.
#[derive(Debug, Error)]
#[error("{}: {source}", path.display())]
pub struct DeliverError {
    /// The file that could not be written.
    pub path: PathBuf,
    /// Why.
    pub source: io::Error,
}

/// Writes `out/<stem>/result.json` and the files the plan asks for, each whole or not at all; `result.json` last, so that
/// a folder that has it is complete. Returns the folder.
///
/// # Errors
/// [`DeliverError`] names the file; what was there before is untouched.
pub fn deliver(plan: &Plan, finished: &Finished, out: &Path) -> Result<PathBuf, DeliverError> {
    let folder = out.join(&plan.stem);
    let write = |name: &str, fill: &dyn Fn(&mut dyn io::Write) -> io::Result<()>| {
        let path = folder.join(name);
        atomic::write(&path, fill).map_err(|source| DeliverError { path, source })
    };
    let names = file_names(finished.methods.iter().map(|method| method.name.as_str()));
    for (method, file) in finished.methods.iter().zip(&names) {
        let Ok(done) = &method.outcome else { continue };
        for &format in &plan.output.formats {
            if let Some(exporter) = exporter(format) {
                let subject = Subject { name: &method.name, mesh: &done.mesh };
                write(&format!("{file}.{}", format.name()), &|out| exporter.write(&subject, out))?;
            }
        }
    }
    write("result.json", &|out| {
        out.write_all(ResultFile::new(finished).to_json().map_err(io::Error::other)?.as_bytes())
    })?;
    Ok(folder)
}

/// Names of methods as names of files: lower case, words joined by dashes, made distinct by a number where needed.
fn file_names<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut files: Vec<String> = Vec::new();
    for name in names {
        let words: Vec<String> = name
            .split(|c: char| !c.is_alphanumeric())
            .filter(|word| !word.is_empty())
            .map(str::to_lowercase)
            .collect();
        let mut base: String = words.join("-").chars().take(80).collect();
        if base.is_empty() {
            base = "method".into();
        }
        let mut file = base.clone();
        let mut number = 2;
        while files.contains(&file) {
            file = format!("{base}-{number}");
            number += 1;
        }
        files.push(file);
    }
    files
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
    }
}

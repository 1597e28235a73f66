//! The experiment files that were named.

use std::collections::HashMap;
use std::io;
use std::path::{Path, PathBuf};

use experiment::{Refusal, Source};
use record::{folder_key, folder_of};

use crate::failure::Failure;
use crate::terminal::{say, tell};

/// Every file, or every refusal on stderr.
pub(crate) fn read_sources(files: &[PathBuf]) -> Result<Vec<Source>, Failure> {
    let mut sources = Vec::new();
    for file in files {
        match read_source(file) {
            Ok(source) => sources.push(source),
            Err(refusal) => tell(&refusal),
        }
    }
    if sources.len() == files.len() { Ok(sources) } else { Err(Failure::Input) }
}

/// A file as an experiment or a sweep; `-` is stdin, whose results go to the folder `stdin`.
pub(crate) fn read_source(file: &Path) -> Result<Source, Refusal> {
    if file == Path::new("-") {
        Source::read_from("stdin", &mut io::stdin().lock())
    } else {
        Source::read(file)
    }
}

/// Two files whose results would lie in the same folder are bad usage.
pub(crate) fn distinct_stems(sources: &[Source], out: &Path) -> Result<(), Failure> {
    let mut first: HashMap<String, &Source> = HashMap::new();
    for source in sources {
        if let Some(other) = first.insert(folder_key(&source.stem()), source) {
            let [mine, theirs] = [source, other].map(|source| folder_of(&source.stem(), out));
            let but = if mine == theirs { "" } else { ", where a disk does not tell capitals apart" };
            say(&format!(
                "error: {} and {} would both write to {}{but}: rename one, or run them with different --out",
                other.file(),
                source.file(),
                theirs.display()
            ));
            return Err(Failure::Input);
        }
    }
    Ok(())
}

//! What stands twice in a file.

use plateau::counted;

use crate::CurveFile;

/// Links that stand again, by the curve that has them first and the one that repeats them.
pub(super) struct Copies<'a> {
    file: &'a CurveFile,
    /// How many links each curve has.
    links: Vec<usize>,
    pairs: Vec<([usize; 2], usize)>,
}

impl<'a> Copies<'a> {
    /// Most pairs of curves that are named.
    const NAMED: usize = 3;

    /// `links` are the curves of all links.
    pub(super) fn new(links: impl Iterator<Item = usize>, file: &'a CurveFile) -> Self {
        let mut counts = vec![0; file.curves.len()];
        links.for_each(|curve| counts[curve] += 1);
        Self { file, links: counts, pairs: Vec::new() }
    }

    pub(super) fn add(&mut self, first: usize, copy: usize) {
        match self.pairs.last_mut() {
            Some((pair, count)) if *pair == [first, copy] => *count += 1,
            _ => self.pairs.push(([first, copy], 1)),
        }
    }

    /// A sentence, if there are any.
    pub(super) fn said(&self) -> Option<String> {
        let name = |curve: usize| {
            let read = &self.file.curves[curve];
            if read.name.is_empty() {
                format!("the curve of line {}", read.line)
            } else {
                format!("{} (line {})", read.name, read.line)
            }
        };
        let pair = |&([first, copy], count): &([usize; 2], usize)| match (first == copy, count) {
            (true, _) => format!("{} of {}", counted(count, "segment"), name(first)),
            (false, count) if count == self.links[copy] => format!("{} is {} again", name(copy), name(first)),
            (false, count) => {
                let segments = counted(count, "segment");
                format!("{segments} of {} in {}", name(first), name(copy))
            }
        };
        let pairs: Vec<String> = self.pairs.iter().take(Self::NAMED).map(pair).collect();
        let rest = match self.pairs.len().saturating_sub(Self::NAMED) {
            0 => String::new(),
            rest => format!("; and {rest} more"),
        };
        (!pairs.is_empty()).then(|| format!("given twice, counted once: {}{rest}", pairs.join("; ")))
    }
}

//! The numbers of the papers beside ours.

use serde::Serialize;

use experiment::{Finished, Options, Plan, Published, run};
use plateau::MethodResult;
use plateau::Progress;
use show::{Cells, Column, grid};

/// The experiments behind the published tables, in the order they are printed: the files of `fixtures/` that hold
/// `published` entries, so that an installed program needs no checkout.
const FILES: [(&str, &str); 6] = [
    ("gt-5.1.toml", include_str!("../fixtures/gt-5.1.toml")),
    ("gt-5.2.toml", include_str!("../fixtures/gt-5.2.toml")),
    ("tri-enneper-n3.toml", include_str!("../fixtures/tri-enneper-n3.toml")),
    ("tri-ni1-n3.toml", include_str!("../fixtures/tri-ni1-n3.toml")),
    ("tri-ni2-n3.toml", include_str!("../fixtures/tri-ni2-n3.toml")),
    ("tri-ni2-n10.toml", include_str!("../fixtures/tri-ni2-n10.toml")),
];

/// The version of the record's layout; the number after the slash changes only if a program reading it would break.
pub const REPRODUCTION_SCHEMA: &str = "plateau-reproduction/1";

/// Every published number beside ours, and what the experiments expect besides.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reproduction {
    schema: &'static str,
    /// One entry per published number, in the order of the files.
    pub entries: Vec<Reproduced>,
    /// How many numbers the experiments expect of themselves.
    pub expected: usize,
    /// The expected numbers that were missed and the methods that failed, one sentence each.
    pub faults: Vec<String>,
}

/// One published number beside ours.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reproduced {
    /// Name of the experiment file.
    pub file: String,
    /// Title of the experiment.
    pub title: String,
    /// Name of the method.
    pub method: String,
    /// Where the number is printed: `GT Table 1`.
    pub source: String,
    /// What the number is called there.
    pub heading: String,
    /// Which of our figures it is, named as in experiment files.
    pub quantity: String,
    /// The printed number with all its digits.
    pub printed: String,
    /// Ours; none if the method failed or has no such figure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ours: Option<f64>,
    /// How the two compare.
    #[serde(flatten)]
    pub verdict: Verdict,
}

/// How a published number compares with ours.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(tag = "verdict", rename_all = "kebab-case")]
pub enum Verdict {
    /// Ours rounds to the printed number.
    Agrees,
    /// It does not, and the experiment says why.
    Misprint {
        /// Why the printed number is wrong.
        reason: String,
    },
    /// It does not, and nobody knows why; or there is no number of ours.
    Missed,
}

/// Runs every experiment behind a published table.
///
/// ```no_run
/// let reproduction = record::reproduce(experiment::Options::default(), &());
/// print!("{}", reproduction.table());
/// assert!(reproduction.is_sound());
/// ```
pub fn reproduce(options: Options, progress: &dyn Progress) -> Reproduction {
    let mut reproduction =
        Reproduction { schema: REPRODUCTION_SCHEMA, entries: Vec::new(), expected: 0, faults: Vec::new() };
    for (file, text) in FILES {
        let finished = Plan::parse(file, text)
            .map_err(|refusal| refusal.to_string())
            .and_then(|plan| run(&plan, options, progress).map_err(|error| error.to_string()));
        match finished {
            Ok(finished) => reproduction.add(file, &finished),
            Err(fault) => reproduction.faults.push(format!("{file}: {fault}")),
        }
    }
    reproduction
}

impl Reproduction {
    /// Whether every expected number was met, no method failed, and every printed number agrees or is a known misprint.
    pub fn is_sound(&self) -> bool {
        self.faults.is_empty() && self.entries.iter().all(|entry| entry.verdict != Verdict::Missed)
    }

    fn add(&mut self, file: &str, finished: &Finished) {
        let results = &finished.results;
        for (method, wanted) in results.methods().iter().zip(&finished.wanted) {
            let entry = |published: &Published| entry(file, results.title(), method, published);
            self.entries.extend(wanted.published.iter().map(entry));
        }
        self.expected += finished.expected();
        self.faults.extend(results.failures().map(|(method, error)| format!("{file}: {method}: {error}")));
        self.faults.extend(finished.missed().iter().map(|miss| {
            let ours = miss.ours.map_or("there is no such figure".into(), |ours| format!("found {ours}"));
            let (method, expected) = (&miss.method, &miss.expected);
            let (line, quantity, text) = (expected.line, expected.quantity, &expected.text);
            format!("{file}:{line}: {method}: {quantity} = {text} expected, {ours}")
        }));
    }

    /// The record as indented JSON with a final line break.
    ///
    /// # Errors
    /// Never in fact: every part of the record has a JSON form.
    pub fn to_json(&self) -> serde_json::Result<String> {
        let mut text = serde_json::to_string_pretty(self)?;
        text.push('\n');
        Ok(text)
    }

    /// The table as text: a paragraph per experiment, a row per printed number, then the counts and the faults.
    pub fn table(&self) -> String {
        let rows: Vec<Vec<String>> = self.entries.iter().map(cells).collect();
        let (lines, _) = grid(&Cells::new(columns(), rows), usize::MAX);
        let mut lines = lines.lines();
        let mut text = String::new();
        for line in lines.by_ref().take(2) {
            text += &format!("{line}\n");
        }
        let mut title = "";
        for (entry, line) in self.entries.iter().zip(lines) {
            if entry.title != title {
                title = &entry.title;
                text += &format!("\n{title}\n");
            }
            text += line;
            if let Verdict::Misprint { reason } = &entry.verdict {
                text += &format!(": {reason}");
            }
            text += "\n";
        }
        text + &self.summary()
    }

    fn summary(&self) -> String {
        let count = |wanted: fn(&Verdict) -> bool| self.entries.iter().filter(|e| wanted(&e.verdict)).count();
        let agree = count(|verdict| *verdict == Verdict::Agrees);
        let misprints = count(|verdict| matches!(verdict, Verdict::Misprint { .. }));
        let missed = count(|verdict| *verdict == Verdict::Missed);
        let printed = self.entries.len();
        let mut text = format!(
            "\n{printed} printed numbers: {agree} agree, {misprints} are misprints, {missed} missed\n"
        );
        let met = self.expected.saturating_sub(self.faults.len());
        match self.faults.as_slice() {
            [] => text += &format!("{met} further expected numbers: all met\n"),
            faults => {
                text += &format!(
                    "of {} further expected numbers, or of the methods behind them:\n",
                    self.expected
                );
                for fault in faults {
                    text += &format!("MISSED {fault}\n");
                }
            }
        }
        text
    }
}

fn entry(file: &str, title: &str, method: &MethodResult, published: &Published) -> Reproduced {
    let ours = method.figure(published.quantity);
    let verdict = match (ours, &published.reason) {
        (Some(ours), _) if published.agrees_with(ours) => Verdict::Agrees,
        (Some(_), Some(reason)) => Verdict::Misprint { reason: reason.clone() },
        _ => Verdict::Missed,
    };
    let quantity = published.quantity.to_string();
    Reproduced {
        file: file.into(),
        title: title.into(),
        method: method.name.clone(),
        source: published.source.clone(),
        heading: published.heading.clone().unwrap_or_else(|| quantity.clone()),
        quantity,
        printed: published.text.clone(),
        ours,
        verdict,
    }
}

fn columns() -> Vec<Column> {
    vec![
        Column::words("  method", ""),
        Column::words("printed in", ""),
        Column::words("headed", ""),
        Column::words("which is", ""),
        Column::number("printed", ""),
        Column::number("ours", ""),
        Column::words("verdict", ""),
    ]
}

fn cells(entry: &Reproduced) -> Vec<String> {
    vec![
        format!("  {}", entry.method),
        entry.source.clone(),
        entry.heading.clone(),
        entry.quantity.clone(),
        entry.printed.clone(),
        entry.ours.map_or("none".into(), |ours| to_digits_of(&entry.printed, ours)),
        match &entry.verdict {
            Verdict::Agrees => "agrees".into(),
            Verdict::Misprint { .. } => "misprint".into(),
            Verdict::Missed => "MISSED".into(),
        },
    ]
}

/// `ours` with as many decimals as `printed` has; with an exponent where `printed` has one.
fn to_digits_of(printed: &str, ours: f64) -> String {
    let (mantissa, exponent) = match printed.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (printed, None),
    };
    let decimals = mantissa.split_once('.').map_or(0, |(_, digits)| digits.len());
    match exponent {
        Some(_) => format!("{ours:.decimals$e}"),
        None => format!("{ours:.decimals$}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn finish(text: &str) -> Finished {
        run(&Plan::parse("saddle.toml", text).unwrap(), Options::default(), &()).unwrap()
    }

    fn reproduced(published: &str) -> Reproduction {
        let finished = finish(&format!(
            r#"
            title = "A flat square"
            [boundary]
            u0 = [[0, 0, 0], [0, 1, 0], [0, 2, 0]]
            u1 = [[2, 0, 0], [2, 1, 0], [2, 2, 0]]
            v0 = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]
            v1 = [[0, 2, 0], [1, 2, 0], [2, 2, 0]]
            [[method]]
            name = "Dirichlet"
            energy = "dirichlet"
            {published}
            "#
        ));
        let mut reproduction = Reproduction {
            schema: REPRODUCTION_SCHEMA,
            entries: Vec::new(),
            expected: 0,
            faults: Vec::new(),
        };
        reproduction.add("square.toml", &finished);
        reproduction
    }

    #[test]
    fn a_printed_number_agrees_is_a_misprint_or_is_missed() {
        let published = |rest: &str| format!("published = {{ source = \"S\", quantity = \"area\", {rest} }}");
        let agrees = reproduced(&published("printed = 4.000"));
        assert_eq!(agrees.entries[0].verdict, Verdict::Agrees);
        assert!(agrees.is_sound());
        let misprint = reproduced(&published("printed = 4.001, reason = \"a slip\""));
        assert_eq!(misprint.entries[0].verdict, Verdict::Misprint { reason: "a slip".into() });
        assert!(misprint.is_sound() && misprint.table().contains("4.001   4.000   misprint: a slip"));
        let missed = reproduced(&published("printed = 4.001"));
        assert_eq!(missed.entries[0].verdict, Verdict::Missed);
        assert!(!missed.is_sound() && missed.table().contains("MISSED"));
        assert!(missed.to_json().unwrap().contains("\"verdict\": \"missed\""));
    }

    #[test]
    fn a_missed_expectation_is_a_fault_with_its_line() {
        let missed = reproduced("expect = { area = 4.5, dirichlet = 4.0 }");
        assert_eq!(missed.expected, 2);
        assert_eq!(missed.faults.len(), 1);
        assert!(missed.faults[0].starts_with("square.toml:11: Dirichlet: area = 4.5 expected, found 4"));
        assert!(!missed.is_sound() && missed.table().contains("MISSED square.toml:11"));
    }

    #[test]
    fn ours_is_shown_to_the_digits_of_the_printed_number() {
        assert_eq!(to_digits_of("38.0000", 38.353_846_2), "38.3538");
        assert_eq!(to_digits_of("0.99685", 0.996_856_1), "0.99686");
        assert_eq!(to_digits_of("38", 37.6), "38");
        assert_eq!(to_digits_of("1.50e-3", 0.001_234_5), "1.23e-3");
    }
}

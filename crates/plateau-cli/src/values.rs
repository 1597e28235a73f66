//! The values of arguments, each as it is typed.

use clap::ValueEnum;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use exchange::Format;
use experiment::Template;
use plateau::{Fill, Functional};

/// Two numbers with a comma between them.
pub(crate) fn pair(text: &str) -> Result<[f64; 2], String> {
    let number = |text: &str| text.trim().parse::<f64>().map_err(|_| format!("{text:?} is not a number"));
    match text.split_once(',') {
        Some((first, second)) => Ok([number(first)?, number(second)?]),
        None => Err("two numbers are needed, as in 1,2".to_owned()),
    }
}

/// A time that is no more than a year.
pub(crate) fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(seconds) if (0.0..=3.2e7).contains(&seconds) => Ok(seconds),
        _ => Err("give seconds, from 0 to 3.2e7".to_owned()),
    }
}

/// A share of the area.
pub(crate) fn accuracy(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(share) if Fill::ACCURACIES.contains(&share) => Ok(share),
        Ok(share) => {
            let (least, most) = (Fill::ACCURACIES.start(), Fill::ACCURACIES.end());
            Err(format!("{share} is not from {least:e} to {most:e}: 1e-8 is a hundred millionth of the area"))
        }
        Err(_) => Err("this is not a number; 1e-8 is a hundred millionth of the area".to_owned()),
    }
}

/// A share of something: above 0, at most 1.
pub(crate) fn share(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(share) if share > 0.0 && share <= 1.0 => Ok(share),
        Ok(share) => Err(format!("{share} is not above 0 and at most 1: 1e-6 is a millionth of the size")),
        Err(_) => Err("this is not a number; 1e-6 is a millionth of the size".to_owned()),
    }
}

/// One of a table of names, as help and completion list them.
pub(crate) fn one_of<T: Clone + Send + Sync + 'static>(
    table: impl IntoIterator<Item = (&'static str, T)>,
) -> impl TypedValueParser<Value = T> {
    let table: Vec<(&'static str, T)> = table.into_iter().collect();
    let names: Vec<&'static str> = table.iter().map(|(name, _)| *name).collect();
    PossibleValuesParser::new(names).try_map(move |word| {
        let found = table.iter().find(|(name, _)| *name == word);
        // Clap has refused all other words.
        found.map(|(_, meaning)| meaning.clone()).ok_or("this is none of the names")
    })
}

/// A quadratic energy by its name.
pub(crate) fn energy() -> impl TypedValueParser<Value = Functional> {
    one_of(Functional::ALL.map(|energy| (energy.name(), energy)))
}

/// A file format by its name.
pub(crate) fn format() -> impl TypedValueParser<Value = Format> {
    one_of(Format::ALL.map(|format| (format.name(), format)))
}

/// Which instructions the search may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Arithmetic {
    /// The fastest this processor has
    Auto,
    /// None beyond the baseline
    Portable,
    /// Fused multiply-add; an error where the processor lacks it
    Fma,
}

impl From<Arithmetic> for plateau::Arithmetic {
    fn from(choice: Arithmetic) -> Self {
        match choice {
            Arithmetic::Auto => Self::Auto,
            Arithmetic::Portable => Self::Portable,
            Arithmetic::Fma => Self::Fma,
        }
    }
}

/// A template's name; `patch` is another word for `tensor`.
pub(crate) fn template() -> impl TypedValueParser<Value = Template> {
    let values = Template::ALL.map(|template| {
        let value = PossibleValue::new(template.name()).help(template.summary());
        if template == Template::Tensor { value.alias("patch") } else { value }
    });
    PossibleValuesParser::new(values).try_map(|word| {
        let named = Template::ALL.into_iter().find(|template| template.name() == word);
        named.or((word == "patch").then_some(Template::Tensor)).ok_or("this is none of the names")
    })
}

//! The values of arguments, each as it is typed.

use clap::ValueEnum;
use clap::builder::PossibleValue;
use experiment::Template;

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
        Ok(share) if (1e-12..=1e-2).contains(&share) => Ok(share),
        Ok(share) => {
            Err(format!("{share} is not from 1e-12 to 1e-2: 1e-8 is a hundred millionth of the area"))
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

/// A family of functions of one variable.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum FamilyName {
    Bernstein,
    Gt,
    Aht,
    At,
}

/// A quadratic energy by its name.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EnergyName(pub(crate) plateau::Functional);

impl ValueEnum for EnergyName {
    fn value_variants<'a>() -> &'a [Self] {
        static ENERGIES: [EnergyName; plateau::Functional::ALL.len()] = {
            let mut energies = [EnergyName(plateau::Functional::ALL[0]); plateau::Functional::ALL.len()];
            let mut k = 0;
            while k < energies.len() {
                energies[k] = EnergyName(plateau::Functional::ALL[k]);
                k += 1;
            }
            energies
        };
        &ENERGIES
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.0.name()))
    }
}

/// A file format by its name.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FileFormat(pub(crate) exchange::Format);

impl ValueEnum for FileFormat {
    fn value_variants<'a>() -> &'a [Self] {
        static FORMATS: [FileFormat; exchange::Format::ALL.len()] = {
            let mut formats = [FileFormat(exchange::Format::ALL[0]); exchange::Format::ALL.len()];
            let mut k = 0;
            while k < formats.len() {
                formats[k] = FileFormat(exchange::Format::ALL[k]);
                k += 1;
            }
            formats
        };
        &FORMATS
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.0.name()))
    }
}

/// A unit of length by its name.
#[derive(Clone, Copy, Debug)]
pub(crate) struct UnitName(pub(crate) exchange::LengthUnit);

impl ValueEnum for UnitName {
    fn value_variants<'a>() -> &'a [Self] {
        static UNITS: [UnitName; exchange::LengthUnit::NAMED.len()] = {
            let mut units = [UnitName(exchange::LengthUnit::Millimetre); exchange::LengthUnit::NAMED.len()];
            let mut k = 0;
            while k < units.len() {
                units[k] = UnitName(exchange::LengthUnit::NAMED[k].1);
                k += 1;
            }
            units
        };
        &UNITS
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (name, _) = exchange::LengthUnit::NAMED.into_iter().find(|(_, unit)| *unit == self.0)?;
        Some(PossibleValue::new(name))
    }
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
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kind(pub(crate) Template);

impl ValueEnum for Kind {
    fn value_variants<'a>() -> &'a [Self] {
        static KINDS: [Kind; Template::ALL.len()] = {
            let mut kinds = [Kind(Template::Tensor); Template::ALL.len()];
            let mut k = 0;
            while k < kinds.len() {
                kinds[k] = Kind(Template::ALL[k]);
                k += 1;
            }
            kinds
        };
        &KINDS
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let value = PossibleValue::new(self.0.name()).help(self.0.summary());
        Some(if self.0 == Template::Tensor { value.alias("patch") } else { value })
    }
}

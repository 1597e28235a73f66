//! Units of length: files state them, and are written in them.

/// What the numbers of a file are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LengthUnit {
    /// Millimetres, for which CAD programs take numbers of no unit.
    #[default]
    Millimetre,
    /// Centimetres.
    Centimetre,
    /// Metres.
    Metre,
    /// Inches of 25.4 mm.
    Inch,
    /// Feet of 304.8 mm.
    Foot,
    /// Micrometres.
    Micrometre,
    /// Decimetres.
    Decimetre,
    /// Kilometres.
    Kilometre,
    /// Yards of 3 feet.
    Yard,
    /// Feet of surveys in the United States, 1200/3937 m.
    SurveyFoot,
}

/// A unit with its name, many of it in words, and its millimetres.
type Row = (&'static str, LengthUnit, &'static str, f64);

/// Every unit.
const ROWS: [Row; 10] = [
    ("mm", LengthUnit::Millimetre, "millimetres", 1.0),
    ("cm", LengthUnit::Centimetre, "centimetres", 10.0),
    ("m", LengthUnit::Metre, "metres", 1000.0),
    ("inch", LengthUnit::Inch, "inches", 25.4),
    ("ft", LengthUnit::Foot, "feet", 304.8),
    ("um", LengthUnit::Micrometre, "micrometres", 1e-3),
    ("dm", LengthUnit::Decimetre, "decimetres", 100.0),
    ("km", LengthUnit::Kilometre, "kilometres", 1e6),
    ("yd", LengthUnit::Yard, "yards", 914.4),
    ("us-ft", LengthUnit::SurveyFoot, "US survey feet", 1_200_000.0 / 3937.0),
];

/// Other words for them, in lower case.
const WORDS: [(&str, LengthUnit); 24] = [
    ("millimeter", LengthUnit::Millimetre),
    ("millimeters", LengthUnit::Millimetre),
    ("millimetre", LengthUnit::Millimetre),
    ("centimeter", LengthUnit::Centimetre),
    ("centimeters", LengthUnit::Centimetre),
    ("centimetre", LengthUnit::Centimetre),
    ("meter", LengthUnit::Metre),
    ("meters", LengthUnit::Metre),
    ("metre", LengthUnit::Metre),
    ("in", LengthUnit::Inch),
    ("\"", LengthUnit::Inch),
    ("foot", LengthUnit::Foot),
    ("'", LengthUnit::Foot),
    ("micron", LengthUnit::Micrometre),
    ("microns", LengthUnit::Micrometre),
    ("micrometer", LengthUnit::Micrometre),
    ("micrometers", LengthUnit::Micrometre),
    ("µm", LengthUnit::Micrometre),
    ("decimeters", LengthUnit::Decimetre),
    ("kilometer", LengthUnit::Kilometre),
    ("kilometers", LengthUnit::Kilometre),
    ("yard", LengthUnit::Yard),
    ("ussft", LengthUnit::SurveyFoot),
    ("sft", LengthUnit::SurveyFoot),
];

impl LengthUnit {
    /// Every unit with the name it is asked for by.
    pub const NAMED: [(&'static str, Self); ROWS.len()] = {
        let mut named = [("", Self::Millimetre); ROWS.len()];
        let mut k = 0;
        while k < ROWS.len() {
            named[k] = (ROWS[k].0, ROWS[k].1);
            k += 1;
        }
        named
    };

    fn row(self) -> &'static Row {
        // Every unit has a row: a test says so.
        ROWS.iter().find(|row| row.1 == self).unwrap_or(&ROWS[0])
    }

    /// Many of it, in words.
    #[must_use]
    pub fn plural(self) -> &'static str {
        self.row().2
    }

    /// The name it is asked for by.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.row().0
    }

    /// How many millimetres it has.
    #[must_use]
    pub fn millimetres(self) -> f64 {
        self.row().3
    }

    /// How many metres it has.
    #[must_use]
    pub fn metres(self) -> f64 {
        self.millimetres() / 1000.0
    }

    /// The unit of so many millimetres, to a millionth of it where inches and feet are meant, exact where they are told apart.
    pub(crate) fn of_millimetres(millimetres: f64) -> Option<Self> {
        let off = |row: &&Row| (row.3 / millimetres - 1.0).abs();
        let nearest = ROWS.iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
        // The foot of surveys is 2e-6 longer than the other.
        (off(&nearest) < 5e-7).then_some(nearest.1)
    }

    /// What a word of a file means: `mm`, `Millimeters`, `inch`.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        let word = word.trim().to_lowercase();
        let rows = ROWS.iter().find(|row| row.0 == word || row.2.to_lowercase() == word).map(|row| row.1);
        rows.or_else(|| WORDS.iter().find(|(other, _)| *other == word).map(|(_, unit)| *unit))
    }
}

/// What comments of a file say of the unit of its numbers.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Commented {
    /// Said of units: `Units: mm`, `File units = meters`.
    stated: Option<LengthUnit>,
    /// Named and nothing else, or at the end of `… in mm`.
    named: Option<LengthUnit>,
}

impl Commented {
    /// Takes a comment in; the first that states a unit counts, and before those that only name one.
    pub(crate) fn hear(&mut self, comment: &str) {
        let comment = comment.to_lowercase();
        let mut words = comment
            .split(|c: char| c.is_whitespace() || "=:,;.[]()#".contains(c))
            .filter(|word| !word.is_empty());
        if let Some((_, rest)) = comment.split_once("unit") {
            let rest = rest.split(|c: char| c.is_whitespace() || "=:,;[]()".contains(c));
            let stated = rest
                .filter(|word| !["", "s", "are", "is", "in"].contains(word))
                .map(LengthUnit::of_word)
                .next();
            self.stated = self.stated.or(stated.flatten());
        } else if let Some(last) = words.next_back() {
            let before = words.next_back();
            // By itself a word may mean something else: the loop of a yard, point m.
            let is_plain = before.is_none() && !["m", "in", "foot", "yard", "'", "\""].contains(&last);
            let named = LengthUnit::of_word(last).filter(|_| is_plain || before == Some("in"));
            self.named = self.named.or(named);
        }
    }

    /// The unit, if a comment says one.
    pub(crate) fn unit(self) -> Option<LengthUnit> {
        self.stated.or(self.named)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_unit_has_a_row_of_its_own() {
        let all = [
            LengthUnit::Millimetre,
            LengthUnit::Centimetre,
            LengthUnit::Metre,
            LengthUnit::Inch,
            LengthUnit::Foot,
            LengthUnit::Micrometre,
            LengthUnit::Decimetre,
            LengthUnit::Kilometre,
            LengthUnit::Yard,
            LengthUnit::SurveyFoot,
        ];
        assert_eq!(LengthUnit::NAMED.map(|(_, unit)| unit), all);
        for unit in all {
            assert_eq!(LengthUnit::of_word(unit.name()), Some(unit));
            assert_eq!(LengthUnit::of_word(&unit.plural().to_uppercase()), Some(unit));
            assert_eq!(LengthUnit::of_millimetres(unit.millimetres()), Some(unit));
        }
        assert_eq!(LengthUnit::of_millimetres(304.800_609_6), Some(LengthUnit::SurveyFoot));
        assert_eq!((LengthUnit::of_millimetres(2.0), LengthUnit::of_word("miles")), (None, None));
    }
}

//! The instances of an ISO 10303-21 file: `#12 = NAME(…);`, found first, parsed when asked for.

use std::collections::HashMap;

use crate::curves::CurveFileError;
use crate::curves::limits::{self, MOST_RECORDS};

/// Deepest nesting of lists.
const DEEPEST: usize = 32;

/// A parameter of an instance.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value {
    /// `#12`
    Reference(u64),
    /// `1.5E0`
    Number(f64),
    /// `'text'`
    Text(String),
    /// `.T.`
    Word(String),
    /// `$`, `*`
    Absent,
    /// `(…)`
    List(Vec<Value>),
    /// `NAME(…)`
    Typed(String, Vec<Value>),
}

impl Value {
    /// The instance it refers to, if it is a reference.
    pub(super) fn reference(&self) -> Option<u64> {
        if let Self::Reference(id) = self { Some(*id) } else { None }
    }

    /// The number it is, if it is one.
    pub(super) fn number(&self) -> Option<f64> {
        if let Self::Number(x) = self { Some(*x) } else { None }
    }
}

/// An entity of an instance: a simple instance has one, a complex one several.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Entity {
    pub(super) name: String,
    pub(super) values: Vec<Value>,
}

/// Where an instance stands.
#[derive(Debug, Clone, Copy)]
struct Place {
    start: usize,
    end: usize,
    line: usize,
}

/// The instances of a file by their numbers.
pub(super) struct Part21<'a> {
    text: &'a str,
    places: HashMap<u64, Place>,
    /// Numbers in the order of the file.
    order: Vec<u64>,
}

impl<'a> Part21<'a> {
    /// Finds the instances; names the one inside which a file breaks off.
    pub(super) fn new(text: &'a str) -> Result<Self, CurveFileError> {
        let bytes = text.as_bytes();
        let mut file = Self { text, places: HashMap::new(), order: Vec::new() };
        let mut line = 1;
        // Where a statement began, in bytes and lines; statements end with semicolons outside texts and comments.
        let mut begun: Option<(usize, usize)> = None;
        let mut at = 0;
        while at < bytes.len() {
            match bytes[at] {
                b'\n' => line += 1,
                b'\'' => {
                    let opened = line;
                    at += 1;
                    while at < bytes.len() && bytes[at] != b'\'' {
                        line += usize::from(bytes[at] == b'\n');
                        at += 1;
                    }
                    if at >= bytes.len() {
                        return Err(CurveFileError::at(
                            opened,
                            "the text that begins here has no end: a quote is missing, or the file is cut short",
                        ));
                    }
                }
                b'/' if bytes.get(at + 1) == Some(&b'*') => {
                    let length = text.get(at..).and_then(|rest| rest.find("*/")).unwrap_or(bytes.len() - at);
                    line += bytes[at..at + length].iter().filter(|byte| **byte == b'\n').count();
                    at += length + 1;
                }
                b';' => {
                    if let Some((start, line)) = begun.take() {
                        file.keep(start, at, line)?;
                    }
                }
                byte if byte.is_ascii_whitespace() => {}
                _ => {
                    begun.get_or_insert((at, line));
                }
            }
            at += 1;
        }
        if let Some((start, line)) = begun
            && bytes[start] == b'#'
        {
            return Err(CurveFileError::at(
                line,
                "the file breaks off inside the instance that begins here: it is cut short; export it again",
            ));
        }
        Ok(file)
    }

    fn keep(&mut self, start: usize, end: usize, line: usize) -> Result<(), CurveFileError> {
        let Some(statement) = self.text.get(start..end).and_then(|text| text.strip_prefix('#')) else {
            return Ok(());
        };
        let Some((id, body)) = statement.split_once('=') else {
            return Err(CurveFileError::at(line, "an instance is written `#12 = NAME(…);`; here is no `=`"));
        };
        let id: u64 = id
            .trim()
            .parse()
            .map_err(|_| CurveFileError::at(line, "an instance begins with its number, as in `#12 = …`"))?;
        let mut counter = self.order.len();
        limits::count(&mut counter, 1, MOST_RECORDS, "instances", line)?;
        let place = Place { start: end - body.len(), end, line };
        if let Some(before) = self.places.insert(id, place) {
            return Err(CurveFileError::at(
                line,
                format!("#{id} is here a second time; it stands in line {} already", before.line),
            ));
        }
        self.order.push(id);
        Ok(())
    }

    /// The numbers of instances whose first entity has one of the names, or of complex ones that hold it, in the order of the
    /// file; found without parsing.
    pub(super) fn named<'b>(&'b self, names: &'b [&str]) -> impl Iterator<Item = u64> + 'b {
        self.order.iter().copied().filter(move |id| {
            let body = self.body(*id);
            match body.strip_prefix('(') {
                Some(inside) => names.iter().any(|name| {
                    inside.match_indices(name).any(|(at, _)| {
                        let is_start = !inside[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
                        is_start && inside[at + name.len()..].trim_start().starts_with('(')
                    })
                }),
                None => {
                    let word = body.split('(').next().unwrap_or("").trim();
                    names.iter().any(|name| word.eq_ignore_ascii_case(name))
                }
            }
        })
    }

    fn body(&self, id: u64) -> &'a str {
        self.places.get(&id).and_then(|place| self.text.get(place.start..place.end)).unwrap_or("").trim()
    }

    /// Line on which an instance begins; 0 for none.
    pub(super) fn line(&self, id: u64) -> usize {
        self.places.get(&id).map_or(0, |place| place.line)
    }

    /// The entities of an instance.
    pub(super) fn get(&self, id: u64) -> Result<Vec<Entity>, CurveFileError> {
        let Some(place) = self.places.get(&id) else {
            return Err(CurveFileError::File(format!(
                "#{id} is referred to and stands nowhere in the file: it is cut short or damaged"
            )));
        };
        let mut parser = Parser { text: self.body(id), at: 0 };
        parser.instance().map_err(|why| CurveFileError::at(place.line, format!("#{id}: {why}")))
    }
}

struct Parser<'a> {
    text: &'a str,
    at: usize,
}

impl Parser<'_> {
    fn instance(&mut self) -> Result<Vec<Entity>, String> {
        let mut entities = Vec::new();
        if self.next_is('(') {
            while !self.next_is(')') {
                entities.push(self.entity()?);
            }
        } else {
            entities.push(self.entity()?);
        }
        Ok(entities)
    }

    fn entity(&mut self) -> Result<Entity, String> {
        let name = self.word().to_ascii_uppercase();
        if name.is_empty() {
            return Err("the name of an entity was expected".into());
        }
        if !self.next_is('(') {
            return Err(format!("{} has no parameters in parentheses", limits::name(&name)));
        }
        Ok(Entity { name, values: self.list(0)? })
    }

    /// Values up to the closing parenthesis.
    fn list(&mut self, depth: usize) -> Result<Vec<Value>, String> {
        if depth > DEEPEST {
            return Err("lists are nested too deeply".into());
        }
        let mut values = Vec::new();
        if self.next_is(')') {
            return Ok(values);
        }
        loop {
            values.push(self.value(depth)?);
            if self.next_is(')') {
                return Ok(values);
            }
            if !self.next_is(',') {
                return Err("a comma or a closing parenthesis is missing".into());
            }
        }
    }

    fn value(&mut self, depth: usize) -> Result<Value, String> {
        self.blanks();
        let rest = &self.text[self.at..];
        match rest.bytes().next() {
            Some(b'(') => {
                self.at += 1;
                Ok(Value::List(self.list(depth + 1)?))
            }
            Some(b'$' | b'*') => {
                self.at += 1;
                Ok(Value::Absent)
            }
            Some(b'#') => {
                self.at += 1;
                let digits = self.taken(|c| c.is_ascii_digit());
                digits.parse().map(Value::Reference).map_err(|_| "a number is missing behind `#`".into())
            }
            Some(b'\'') => self.quoted(),
            Some(b'.') if rest[1..].starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') => {
                self.at += 1;
                let word = self.word().to_ascii_uppercase();
                if self.next_is('.') {
                    Ok(Value::Word(word))
                } else {
                    Err(format!("the word .{} is not closed by a point", limits::name(&word)))
                }
            }
            Some(b'"') => {
                self.at += 1;
                self.taken(|c| c != '"');
                self.at = (self.at + 1).min(self.text.len());
                Ok(Value::Absent)
            }
            Some(byte) if byte.is_ascii_alphabetic() => {
                let name = self.word().to_ascii_uppercase();
                if !self.next_is('(') {
                    return Err(format!("{} has no parameters in parentheses", limits::name(&name)));
                }
                Ok(Value::Typed(name, self.list(depth + 1)?))
            }
            _ => {
                let number = self.taken(|c| c.is_ascii_alphanumeric() || matches!(c, '+' | '-' | '.'));
                number.parse::<f64>().ok().filter(|x| x.is_finite()).map(Value::Number).ok_or_else(|| {
                    format!("{:?} is no value", limits::name(&rest.chars().take(20).collect::<String>()))
                })
            }
        }
    }

    fn quoted(&mut self) -> Result<Value, String> {
        let mut text = String::new();
        self.at += 1;
        loop {
            text.push_str(self.taken(|c| c != '\''));
            if self.at >= self.text.len() {
                return Err("a text has no end".into());
            }
            self.at += 1;
            // Two quotes are one inside a text.
            if !self.text[self.at..].starts_with('\'') {
                return Ok(Value::Text(text));
            }
            text.push('\'');
            self.at += 1;
        }
    }

    fn word(&mut self) -> &str {
        self.blanks();
        // A name of a user begins with an exclamation mark.
        if self.text[self.at..].starts_with('!') {
            self.at += 1;
        }
        self.taken(|c| c.is_ascii_alphanumeric() || c == '_')
    }

    fn taken(&mut self, belongs: impl Fn(char) -> bool) -> &str {
        let start = self.at;
        let rest = &self.text[start..];
        self.at += rest.find(|c| !belongs(c)).unwrap_or(rest.len());
        &self.text[start..self.at]
    }

    /// Passes over blanks and comments.
    fn blanks(&mut self) {
        loop {
            let rest = &self.text[self.at..];
            let trimmed = rest.trim_start();
            self.at += rest.len() - trimmed.len();
            if !trimmed.starts_with("/*") {
                return;
            }
            self.at += trimmed.find("*/").map_or(trimmed.len(), |end| end + 2);
        }
    }

    fn next_is(&mut self, c: char) -> bool {
        self.blanks();
        let is_next = self.text[self.at..].starts_with(c);
        self.at += usize::from(is_next) * c.len_utf8();
        is_next
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instances_are_found_and_parsed() {
        let text = "ISO-10303-21;\nDATA;\n#1=A('it''s; /* no comment */',(1.,-2.E-1),.T.,$,*,#2,LENGTH(3.));\n/* #9=B(); */\n#2 = ( B(1)\n C() ) ;";
        let file = Part21::new(text).unwrap();
        let one = &file.get(1).unwrap()[0];
        assert_eq!(one.values[0], Value::Text("it's; /* no comment */".into()));
        assert_eq!(one.values[1], Value::List(vec![Value::Number(1.0), Value::Number(-0.2)]));
        assert_eq!(
            one.values[2..6],
            [Value::Word("T".into()), Value::Absent, Value::Absent, Value::Reference(2)]
        );
        assert_eq!(one.values[6], Value::Typed("LENGTH".into(), vec![Value::Number(3.0)]));
        assert_eq!((file.get(2).unwrap().len(), file.line(2)), (2, 5));
        assert_eq!((file.named(&["C"]).collect::<Vec<_>>(), file.named(&["A"]).count()), (vec![2], 1));
        assert!(file.get(9).unwrap_err().to_string().contains("#9"));
    }

    #[test]
    fn broken_instances_have_a_line() {
        for (text, line) in
            [("#1=A(1.);\n#2=A(1.", 2), ("\n#1=A('x);", 2), ("#1=A(1.);\n\n#1=A(2.);", 3), ("#1 A(1.);", 1)]
        {
            let Err(CurveFileError::Line { line: found, .. }) = Part21::new(text).map(|_| ()) else {
                panic!("{text}")
            };
            assert_eq!(found, line, "{text}");
        }
        for text in
            ["#1=A(1.;", "#1=A(1 2);", "#1=;", "#1=A;", "#1=A(#);", "#1=A(.T);", "#1=A(1e999);", "#1=(A(1);"]
        {
            let file = Part21::new(text).unwrap();
            assert!(matches!(file.get(1), Err(CurveFileError::Line { line: 1, .. })), "{text}");
        }
        let deep = format!("#1=A({});", "(".repeat(100));
        assert!(Part21::new(&deep).unwrap().get(1).is_err());
    }
}

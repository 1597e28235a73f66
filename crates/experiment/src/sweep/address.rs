//! Where in a document a value stands: `method.*.raise`, `boundary.u0.1.2`.

use std::fmt;
use std::ops::Range;

use toml::de::{DeTable, DeValue};

use crate::diagnostic::{nearest, shorten};
use crate::text::Value;

/// The way to a value, from the outermost table on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Address(Vec<Step>);

#[derive(Clone, Debug, PartialEq, Eq)]
enum Step {
    /// Every entry.
    All,
    /// A key; in a list of tables the one of this name, or else, if it is not in quotes, the place from 0.
    Named { name: String, quoted: bool },
}

/// Why an address leads nowhere, and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Lost {
    pub(super) why: String,
    pub(super) remedy: String,
}

impl Address {
    /// The steps between the dots; quotes hold a name together.
    pub(super) fn parse(text: &str) -> Result<Self, Lost> {
        let mut steps = Vec::new();
        let mut rest = text.trim();
        loop {
            let (name, quoted, after) = match rest.chars().next() {
                Some(quote @ ('"' | '\'')) => {
                    let inner = &rest[1..];
                    let end = inner.find(quote).ok_or_else(|| malformed("a quotation mark is not closed"))?;
                    (&inner[..end], true, inner[end + 1..].trim_start())
                }
                _ => {
                    let end = rest.find('.').unwrap_or(rest.len());
                    (rest[..end].trim(), false, &rest[end..])
                }
            };
            if name.is_empty() && !quoted {
                return Err(malformed("a name is missing between its dots"));
            }
            steps.push(match name {
                "*" if !quoted => Step::All,
                _ => Step::Named { name: name.to_owned(), quoted },
            });
            match after.strip_prefix('.') {
                Some(more) => rest = more.trim_start(),
                None if after.is_empty() => return Ok(Self(steps)),
                None => return Err(malformed("a dot is missing behind a quotation mark")),
            }
        }
    }

    /// The name of the outermost table it leads into, if it names one.
    pub(super) fn outermost(&self) -> Option<&str> {
        match self.0.first() {
            Some(Step::Named { name, .. }) => Some(name),
            Some(Step::All) | None => None,
        }
    }

    /// The places of all values it leads to, at least one.
    pub(super) fn resolve(&self, document: &DeTable<'_>, text: &str) -> Result<Vec<Range<usize>>, Lost> {
        let mut found = Vec::new();
        let lost = self.follow(0, Node::Table(document), text, &mut found);
        if found.is_empty() { Err(lost.unwrap_or_else(|| self.lost(0, &[]))) } else { Ok(found) }
    }

    /// Follows the steps from `at` on; where that leads nowhere, why.
    fn follow(&self, at: usize, node: Node<'_>, text: &str, found: &mut Vec<Range<usize>>) -> Option<Lost> {
        let step = self.0.get(at)?;
        let next: Vec<&Value<'_>> = match (node, step) {
            (Node::Table(table), Step::All) => table.values().collect(),
            (Node::List(list), Step::All) => list.iter().collect(),
            (Node::Table(table), Step::Named { name, .. }) => table.get(name.as_str()).into_iter().collect(),
            (Node::List(list), Step::Named { name, quoted }) => {
                let named = list.iter().filter(|element| name_of(element) == Some(name.as_str()));
                let named: Vec<&Value<'_>> = named.collect();
                let place = name.parse::<usize>().ok().filter(|_| !quoted && named.is_empty());
                place.map_or(named, |place| list.get(place).into_iter().collect())
            }
        };
        if next.is_empty() {
            return Some(self.lost(at, &node.names()));
        }
        let mut lost = None;
        for value in next {
            if at + 1 < self.0.len() {
                let inner = match value.get_ref() {
                    DeValue::Table(table) => self.follow(at + 1, Node::Table(table), text, found),
                    DeValue::Array(list) => self.follow(at + 1, Node::List(list), text, found),
                    DeValue::String(_)
                    | DeValue::Integer(_)
                    | DeValue::Float(_)
                    | DeValue::Boolean(_)
                    | DeValue::Datetime(_) => Some(self.lost(at + 1, &[])),
                };
                lost = lost.or(inner);
            } else if is_headed(value, text) {
                let why = format!("`{self}` is a table with a header of its own");
                lost = lost.or(Some(Lost {
                    why,
                    remedy: "name a key in it: an axis replaces single values".to_owned(),
                }));
            } else {
                found.push(value.span());
            }
        }
        lost
    }

    /// Nothing is there at a step.
    fn lost(&self, at: usize, names: &[&str]) -> Lost {
        let (way, step) = (Self(self.0[..at].to_vec()), &self.0[at]);
        let within = if at == 0 { "the file".to_owned() } else { format!("`{way}`") };
        let why = match step {
            Step::All => format!("{within} holds nothing"),
            Step::Named { name, .. } => format!("{within} holds no `{}`", shorten(name)),
        };
        let near = match step {
            Step::Named { name, .. } => nearest(name, names.iter().copied()),
            Step::All => None,
        };
        let last = at + 1 == self.0.len();
        let remedy = match near {
            Some(near) => format!("did you mean `{near}`?"),
            None if last => {
                "an axis replaces what stands in the file: write the key there, with any value".to_owned()
            }
            None if names.is_empty() => {
                "name a key that stands in the file, from its outermost table on".to_owned()
            }
            None => format!("it holds: {}", names.iter().take(20).copied().collect::<Vec<_>>().join(", ")),
        };
        Lost { why, remedy }
    }
}

fn malformed(why: &str) -> Lost {
    Lost {
        why: why.to_owned(),
        remedy: "write tables and keys with dots between them, names with dots or blanks in quotes: 'method.\"Least area\".raise'"
            .to_owned(),
    }
}

/// What can be stepped into.
#[derive(Clone, Copy)]
enum Node<'d> {
    Table(&'d DeTable<'d>),
    List(&'d [Value<'d>]),
}

impl<'d> Node<'d> {
    /// What its entries are called.
    fn names(self) -> Vec<&'d str> {
        match self {
            Self::Table(table) => table.keys().map(|key| key.get_ref().as_ref()).collect(),
            Self::List(list) => list.iter().filter_map(name_of).collect(),
        }
    }
}

/// The name that a table in a list has.
fn name_of<'d>(element: &'d Value<'d>) -> Option<&'d str> {
    element.get_ref().as_table()?.get("name")?.get_ref().as_str()
}

/// Whether a value is a table, or a list of tables, that headers or dotted keys make: it has no text of its own.
fn is_headed(value: &Value<'_>, text: &str) -> bool {
    let begins = |with: char, value: &Value<'_>| text[value.span()].starts_with(with);
    match value.get_ref() {
        DeValue::Table(_) => !begins('{', value),
        DeValue::Array(list) => {
            list.iter().any(|element| element.get_ref().is_table() && !begins('{', element))
                || !begins('[', value)
        }
        DeValue::String(_)
        | DeValue::Integer(_)
        | DeValue::Float(_)
        | DeValue::Boolean(_)
        | DeValue::Datetime(_) => false,
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, step) in self.0.iter().enumerate() {
            let dot = if k > 0 { "." } else { "" };
            match step {
                Step::All => write!(f, "{dot}*")?,
                Step::Named { name, quoted: true } => write!(f, "{dot}\"{}\"", shorten(name))?,
                Step::Named { name, quoted: false } => write!(f, "{dot}{}", shorten(name))?,
            }
        }
        Ok(())
    }
}

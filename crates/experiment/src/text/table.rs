//! Tables of the document.

use std::ops::Range;

use serde_spanned::Spanned;
use toml::de::DeTable;

use super::faults::Faults;
use super::given::Given;
use super::head::Head;
use super::inner::{Inner, OneOrSeveral, Several};
use super::key::{Entry, Key, Section};
use super::kind::Kind;
use super::place::Place;
use super::value::Value;
use crate::diagnostic::{Diagnostic, Fault, nearest, shorten};

/// A table of the document that is being read. Each of its keys is taken once.
#[derive(Clone)]
pub(crate) struct Table<'t> {
    faults: &'t Faults<'t>,
    section: &'static Section,
    /// Nothing, where a table that may be left out is.
    entries: Option<&'t DeTable<'t>>,
    /// `method.expect`.
    path: String,
    /// As the file heads it: `[method.expect]`; empty for the file itself.
    header: String,
    /// As messages call it, if not by its header: `method "GT"`.
    called: String,
    span: Range<usize>,
    /// Some key of it is unknown: then one that seems missing may be meant.
    has_strays: bool,
}

impl<'t> Table<'t> {
    /// The file as a table.
    pub(crate) fn root(
        faults: &'t Faults<'t>,
        section: &'static Section,
        document: &'t Spanned<DeTable<'t>>,
    ) -> Self {
        let entries = Some(document.get_ref());
        let mut table = Self {
            faults,
            section,
            entries,
            path: String::new(),
            header: String::new(),
            called: String::new(),
            span: 0..0,
            has_strays: false,
        };
        table.has_strays = table.report_strays();
        table
    }

    /// A table that is the value of a key, or an element of its list.
    pub(super) fn within(
        &self,
        key: &Head,
        section: &'static Section,
        found: Option<(&'t DeTable<'t>, Range<usize>)>,
        listed: bool,
    ) -> Self {
        let dot = if self.path.is_empty() { "" } else { "." };
        let path = format!("{}{dot}{}", self.path, key.name);
        let header = if listed { format!("[[{path}]]") } else { format!("[{path}]") };
        let (entries, span) =
            found.map_or((None, self.span.clone()), |(entries, span)| (Some(entries), span));
        let called = header.clone();
        let mut table =
            Self { faults: self.faults, section, entries, path, header, called, span, has_strays: false };
        table.has_strays = table.report_strays();
        table
    }

    /// The value of a key that is being read, as a table, if it is one.
    pub(crate) fn of_value(
        place: &Place<'t>,
        value: &'t Value<'t>,
        section: &'static Section,
    ) -> Option<Self> {
        let entries = value.get_ref().as_table()?;
        let (faults, name) = (place.faults, place.name());
        let path = format!("{}.{}", place.header.trim_matches(['[', ']']), place.key.name);
        let header = format!("[{path}]");
        let mut table = Self {
            faults,
            section,
            entries: Some(entries),
            path,
            header,
            called: name,
            span: value.span(),
            has_strays: false,
        };
        table.has_strays = table.report_strays();
        Some(table)
    }

    /// The same, by another name in messages.
    pub(crate) fn called(self, name: String) -> Self {
        Self { called: name, ..self }
    }

    pub(crate) fn faults(&self) -> &'t Faults<'t> {
        self.faults
    }

    /// Where it begins.
    pub(crate) fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// As messages call it.
    pub(crate) fn name(&self) -> &str {
        if self.called.is_empty() { "the experiment" } else { &self.called }
    }

    /// Whether some key of it is unknown.
    pub(crate) fn has_strays(&self) -> bool {
        self.has_strays
    }

    /// The keys that it has, with their places.
    pub(crate) fn present(&self) -> impl Iterator<Item = (&'static Head, Range<usize>)> {
        self.section.keys.iter().filter_map(|key| Some((key.head(), self.place(&[key.head().name])?)))
    }

    /// The place of a value inside, if there is one, whether it is sound or not.
    pub(crate) fn place(&self, path: &[&str]) -> Option<Range<usize>> {
        let (last, tables) = path.split_last()?;
        let inner =
            tables.iter().try_fold(self.entries?, |table, key| table.get(*key)?.get_ref().as_table())?;
        inner.get(*last).map(Spanned::span)
    }

    /// Reports every key that the section does not have.
    fn report_strays(&self) -> bool {
        let mut strays = false;
        let present = |name: &str| self.entries.is_some_and(|entries| entries.contains_key(name));
        for key in self.entries.into_iter().flat_map(|entries| entries.keys()) {
            if self.section.names().any(|name| name == key.get_ref()) {
                continue;
            }
            strays = true;
            let absent = self.section.names().filter(|name| !present(name));
            // A key that is there already is hardly meant once more.
            let meant =
                nearest(key.get_ref(), absent).or_else(|| nearest(key.get_ref(), self.section.names()));
            self.faults.report(self.stray(&shorten(key.get_ref()), key.span(), meant));
        }
        strays
    }

    fn stray(&self, key: &str, span: Range<usize>, meant: Option<&str>) -> Diagnostic {
        let keys = self.section.names().collect::<Vec<_>>().join(", ");
        let (what, label, help) = match self.header.as_str() {
            "" => (
                format!("an experiment has no table or key `{key}`"),
                "unknown table or key",
                format!("an experiment may hold: {keys}"),
            ),
            header => (
                format!("{header} has no key `{key}`"),
                "unknown key",
                format!("the keys of {header} are: {keys}"),
            ),
        };
        let diagnostic = Diagnostic::at(Fault::UnknownKey, span, what, label);
        match meant {
            Some(meant) => diagnostic.help(format!("did you mean `{meant}`?")),
            None => diagnostic,
        }
        .help(help)
    }

    fn value(&self, name: &str) -> Option<&'t Value<'t>> {
        self.entries.and_then(|entries| entries.get(name))
    }

    fn at<'p>(&'p self, key: &'p dyn Entry) -> Place<'p> {
        Place {
            faults: self.faults,
            header: &self.header,
            called: &self.called,
            key: key.head(),
            form: key.form(),
        }
    }

    fn read<K: Kind>(&self, key: &Key<K>, value: &Value<'_>) -> Option<K::Value> {
        key.kind.read(&self.at(key), value)
    }

    /// What it holds under a key.
    pub(crate) fn take<K: Kind>(&self, key: &Key<K>) -> Given<K::Value> {
        match self.value(key.head().name) {
            Some(value) => match self.read(key, value) {
                Some(sound) => Given::Sound(Spanned::new(value.span(), sound)),
                None => Given::Faulty,
            },
            None if self.has_strays => Given::Faulty,
            None => Given::Absent,
        }
    }

    /// The value of a key or, if it is left out, its default.
    pub(crate) fn take_or_default<K: Kind>(&self, key: &Key<K>) -> Option<K::Value> {
        match self.take(key).known()? {
            Some(value) => Some(value.into_inner()),
            None => key.default(|value| self.read(key, value)),
        }
    }

    /// What was taken or, if it was left out, the default of its key.
    pub(crate) fn or_default<K: Kind<Value: Clone>>(
        &self,
        key: &Key<K>,
        taken: &Given<K::Value>,
    ) -> Option<K::Value> {
        match taken {
            Given::Absent => key.default(|value| self.read(key, value)),
            Given::Faulty => None,
            Given::Sound(value) => Some(value.get_ref().clone()),
        }
    }

    /// The value of a key that must be there.
    pub(crate) fn require<K: Kind>(&self, key: &Key<K>) -> Option<Spanned<K::Value>> {
        let given = self.take(key);
        if given.is_absent() {
            self.missing(key.head().name, &key.head().remedy());
        }
        given.sound()
    }

    /// Reports a key that is needed; not if an unknown one may be meant for it.
    pub(crate) fn missing(&self, key: &str, help: &str) {
        if !self.has_strays {
            let message = format!("{} lacks `{key}`", self.name());
            let label = format!("`{key}` is needed here");
            self.faults.report(Diagnostic::at(Fault::Missing, self.span(), message, label).help(help));
        }
    }

    fn wrong_type(&self, key: &dyn Entry, value: &Value<'_>) {
        let place = self.at(key);
        place.wrong_type(value, &key.form().expected());
    }

    /// The table under a key.
    pub(crate) fn inner(&self, key: &Key<Inner>) -> Given<Table<'t>> {
        match self.value(key.head().name) {
            None if self.has_strays => Given::Faulty,
            None => Given::Absent,
            Some(value) => {
                let Some(entries) = value.get_ref().as_table() else {
                    self.wrong_type(key, value);
                    return Given::Faulty;
                };
                let table = self.within(key.head(), key.kind.0, Some((entries, value.span())), false);
                Given::Sound(Spanned::new(value.span(), table))
            }
        }
    }

    /// The table under a key, or one without any keys if it is left out: all of its keys have defaults.
    pub(crate) fn inner_or_empty(&self, key: &Key<Inner>) -> Option<Table<'t>> {
        match self.inner(key).known()? {
            Some(table) => Some(table.into_inner()),
            None => Some(self.within(key.head(), key.kind.0, None, false)),
        }
    }

    /// The table under a key that must be there.
    pub(crate) fn require_inner(&self, key: &Key<Inner>) -> Option<Table<'t>> {
        let given = self.inner(key);
        if given.is_absent() {
            self.missing(key.head().name, &key.head().remedy());
        }
        given.sound().map(Spanned::into_inner)
    }

    /// The tables under a key that may be repeated.
    pub(crate) fn several(&self, key: &Key<Several>) -> Given<Vec<Table<'t>>> {
        match self.value(key.head().name) {
            None if self.has_strays => Given::Faulty,
            None => Given::Absent,
            Some(value) => match self.elements(key.head(), key.kind.0, value) {
                Some(tables) => Given::Sound(Spanned::new(value.span(), tables)),
                None => {
                    self.wrong_type(key, value);
                    Given::Faulty
                }
            },
        }
    }

    /// The table, or the tables, under a key.
    pub(crate) fn one_or_several(&self, key: &Key<OneOrSeveral>) -> Given<Tables<'t>> {
        let OneOrSeveral { one, several } = key.kind;
        match self.value(key.head().name) {
            None if self.has_strays => Given::Faulty,
            None => Given::Absent,
            Some(value) => {
                let tables = match value.get_ref().as_table() {
                    Some(entries) => {
                        Some(Tables::One(self.within(key.head(), one, Some((entries, value.span())), false)))
                    }
                    None => self.elements(key.head(), several, value).map(Tables::Several),
                };
                match tables {
                    Some(tables) => Given::Sound(Spanned::new(value.span(), tables)),
                    None => {
                        self.wrong_type(key, value);
                        Given::Faulty
                    }
                }
            }
        }
    }

    /// A list that holds nothing but tables.
    fn elements(
        &self,
        key: &Head,
        section: &'static Section,
        value: &'t Value<'t>,
    ) -> Option<Vec<Table<'t>>> {
        let list = value.get_ref().as_array()?;
        if list.iter().any(|element| !element.get_ref().is_table()) {
            return None;
        }
        let open = |element: &'t Value<'t>| {
            let found = element.get_ref().as_table().map(|entries| (entries, element.span()));
            self.within(key, section, found, true)
        };
        Some(list.iter().map(open).collect())
    }
}

/// The value of a key that takes tables: one, or several.
pub(crate) enum Tables<'t> {
    One(Table<'t>),
    Several(Vec<Table<'t>>),
}

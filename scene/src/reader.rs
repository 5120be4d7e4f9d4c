//! Fields of a TOML table, with their places and ranges.

use std::cell::RefCell;
use std::ops::RangeInclusive;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::{Fault, shortened};

/// A table from which fields are taken; what nobody took is an error.
pub(crate) struct Table<'t, 'i> {
    /// What the table is called in messages: `material.gold`.
    name: String,
    offset: usize,
    entries: &'t DeTable<'i>,
    known: RefCell<Vec<&'static str>>,
}

/// A value and where it stands.
pub(crate) struct Value<'t, 'i> {
    pub(crate) offset: usize,
    /// `table.field`, for messages.
    pub(crate) name: String,
    value: &'t DeValue<'i>,
}

impl<'t, 'i> Table<'t, 'i> {
    pub(crate) fn new(name: &str, table: &'t Spanned<DeTable<'i>>) -> Self {
        Self::at(name, table.span().start, table.get_ref())
    }

    fn at(name: &str, offset: usize, entries: &'t DeTable<'i>) -> Self {
        Self {
            name: name.to_owned(),
            offset,
            entries,
            known: RefCell::default(),
        }
    }

    pub(crate) fn fault(&self, message: impl AsRef<str>) -> Fault {
        Fault::new(
            self.offset,
            format!("{}{}", self.prefix(), message.as_ref()),
        )
    }

    fn prefix(&self) -> String {
        if self.name.is_empty() {
            String::new()
        } else {
            format!("{}: ", self.name)
        }
    }

    fn path(&self, field: &str) -> String {
        let field = shortened(field);
        if self.name.is_empty() {
            field.into_owned()
        } else {
            format!("{}.{field}", self.name)
        }
    }

    pub(crate) fn optional(&self, field: &'static str) -> Option<Value<'t, 'i>> {
        self.known.borrow_mut().push(field);
        let (_, value) = self
            .entries
            .iter()
            .find(|(key, _)| key.get_ref() == field)?;
        Some(Value {
            offset: value.span().start,
            name: self.path(field),
            value: value.get_ref(),
        })
    }

    pub(crate) fn required(&self, field: &'static str) -> Result<Value<'t, 'i>, Fault> {
        self.optional(field).ok_or_else(|| self.missing(field))
    }

    /// A field that is not there, or not under that name.
    fn missing(&self, field: &str) -> Fault {
        let misspelt = self.entries.iter().find(|(key, _)| {
            let name: &str = key.get_ref();
            is_near(name, field) && !self.known.borrow().contains(&name)
        });
        match misspelt {
            Some((key, _)) => Fault::new(
                key.span().start,
                format!(
                    "{}unknown field `{}`; did you mean `{field}`?",
                    self.prefix(),
                    shortened(key.get_ref())
                ),
            ),
            None => self.fault(format!("the field `{field}` is missing")),
        }
    }

    /// The sub-tables with their names, for tables whose keys are free.
    pub(crate) fn members(&self) -> Result<Vec<(String, Table<'t, 'i>)>, Fault> {
        self.entries
            .iter()
            .map(|(key, value)| {
                let name: &str = key.get_ref();
                let member = Value {
                    offset: key.span().start,
                    name: self.path(name),
                    value: value.get_ref(),
                };
                Ok((name.to_owned(), member.table()?))
            })
            .collect()
    }

    /// The values with their names, for tables whose keys are free.
    pub(crate) fn values(&self) -> Vec<(String, Value<'t, 'i>)> {
        self.entries
            .iter()
            .map(|(key, value)| {
                let name: &str = key.get_ref();
                let value = Value {
                    offset: value.span().start,
                    name: self.path(name),
                    value: value.get_ref(),
                };
                (name.to_owned(), value)
            })
            .collect()
    }

    /// Complains of fields that no call asked for.
    pub(crate) fn finish(&self) -> Result<(), Fault> {
        let known = self.known.borrow();
        for (key, _) in self.entries {
            let field: &str = key.get_ref();
            if known.contains(&field) {
                continue;
            }
            let nearest = known
                .iter()
                .filter(|known| is_near(field, known))
                .min_by_key(|known| strsim::damerau_levenshtein(known, field));
            let hint = match nearest {
                Some(nearest) => format!("did you mean `{nearest}`?"),
                None => format!("accepted are {}", list(&known)),
            };
            return Err(Fault::new(
                key.span().start,
                format!(
                    "{}unknown field `{}`; {hint}",
                    self.prefix(),
                    shortened(field)
                ),
            ));
        }
        Ok(())
    }
}

/// Whether `written` may be a slip for `name`.
fn is_near(written: &str, name: &str) -> bool {
    // The distance takes time and room for each pair of letters.
    written.len() <= 40 && strsim::damerau_levenshtein(written, name) <= 2
}

/// Greatest number of names in a message.
const LISTED: usize = 24;

/// `a, b and c`, or the first of them and how many more.
pub(crate) fn list(names: &[&str]) -> String {
    match names {
        [] => "none".to_owned(),
        [first @ .., _] if names.len() > LISTED => {
            let first: Vec<_> = first[..LISTED / 4]
                .iter()
                .map(|name| format!("`{}`", shortened(name)))
                .collect();
            let more = names.len() - first.len();
            format!("{} and {more} more", first.join(", "))
        }
        [only] => format!("`{}`", shortened(only)),
        [head @ .., last] => {
            let head: Vec<_> = head
                .iter()
                .map(|name| format!("`{}`", shortened(name)))
                .collect();
            format!("{} and `{}`", head.join(", "), shortened(last))
        }
    }
}

impl<'t, 'i> Value<'t, 'i> {
    pub(crate) fn fault(&self, accepted: impl AsRef<str>) -> Fault {
        let message = format!(
            "{} = {}: must be {}",
            self.name,
            self.describe(),
            accepted.as_ref()
        );
        Fault::new(self.offset, message)
    }

    fn describe(&self) -> String {
        match self.value {
            DeValue::String(text) => format!("{:?}", shortened(text)),
            DeValue::Integer(number) => shortened(&number.to_string()).into_owned(),
            DeValue::Float(number) => shortened(&number.to_string()).into_owned(),
            DeValue::Boolean(value) => value.to_string(),
            DeValue::Datetime(value) => value.to_string(),
            DeValue::Array(entries) => format!("an array of {}", entries.len()),
            DeValue::Table(_) => "a table".to_owned(),
        }
    }

    pub(crate) fn table(&self) -> Result<Table<'t, 'i>, Fault> {
        match self.value {
            DeValue::Table(table) => Ok(Table::at(&self.name, self.offset, table)),
            _ => Err(self.fault("a table")),
        }
    }

    /// The tables of `[[name]]`.
    pub(crate) fn tables(&self) -> Result<Vec<Table<'t, 'i>>, Fault> {
        let DeValue::Array(entries) = self.value else {
            return Err(self.fault(format!("tables, written [[{}]]", self.name)));
        };
        entries
            .iter()
            .enumerate()
            .map(|(index, entry)| {
                let entry = Value {
                    offset: entry.span().start,
                    name: format!("{}[{}]", self.name, index + 1),
                    value: entry.get_ref(),
                };
                entry.table()
            })
            .collect()
    }

    /// Whether it is this string.
    pub(crate) fn is(&self, text: &str) -> bool {
        matches!(self.value, DeValue::String(given) if given.as_ref() == text)
    }

    pub(crate) fn string(&self) -> Result<&'t str, Fault> {
        match self.value {
            DeValue::String(text) => Ok(text),
            _ => Err(self.fault("a string")),
        }
    }

    pub(crate) fn boolean(&self) -> Result<bool, Fault> {
        match self.value {
            DeValue::Boolean(value) => Ok(*value),
            _ => Err(self.fault("true or false")),
        }
    }

    /// A finite number in a range.
    pub(crate) fn number(&self, range: RangeInclusive<f64>) -> Result<f64, Fault> {
        let number = match self.value {
            DeValue::Integer(number) if number.radix() == 10 => number.as_str().parse().ok(),
            DeValue::Float(number) => number.as_str().parse().ok(),
            _ => None,
        };
        match number {
            Some(number) if range.contains(&number) => Ok(number),
            _ => Err(self.fault(format!(
                "a number from {} to {}",
                range.start(),
                range.end()
            ))),
        }
    }

    /// A whole number in a range.
    pub(crate) fn whole(&self, range: RangeInclusive<u32>) -> Result<u32, Fault> {
        let number = match self.value {
            DeValue::Integer(number) => u32::from_str_radix(number.as_str(), number.radix()).ok(),
            _ => None,
        };
        number
            .filter(|number| range.contains(number))
            .ok_or_else(|| {
                self.fault(format!(
                    "a whole number from {} to {}",
                    range.start(),
                    range.end()
                ))
            })
    }

    fn entries(&self) -> Option<Vec<Value<'t, 'i>>> {
        let DeValue::Array(entries) = self.value else {
            return None;
        };
        let value = |(index, entry): (usize, &'t Spanned<DeValue<'i>>)| Value {
            offset: entry.span().start,
            name: format!("{}[{}]", self.name, index + 1),
            value: entry.get_ref(),
        };
        Some(entries.iter().enumerate().map(value).collect())
    }

    /// Three finite numbers, each in a range.
    pub(crate) fn triple(&self, range: RangeInclusive<f64>) -> Result<[f64; 3], Fault> {
        match self.entries().as_deref() {
            Some([a, b, c]) => Ok([
                a.number(range.clone())?,
                b.number(range.clone())?,
                c.number(range)?,
            ]),
            _ => Err(self.fault("three numbers")),
        }
    }

    /// Pairs of a distance from 0 to 2 and a number from 0 to 1e6.
    pub(crate) fn pairs(&self) -> Result<Vec<[f64; 2]>, Fault> {
        let entries = self
            .entries()
            .ok_or_else(|| self.fault("pairs of numbers"))?;
        let pair = |entry: &Self| match entry.entries().as_deref() {
            Some([m, value]) => Ok([m.number(0.0..=2.0)?, value.number(0.0..=1e6)?]),
            _ => Err(entry.fault("two numbers")),
        };
        entries.iter().map(pair).collect()
    }

    /// A colour: one number for all channels, or three.
    pub(crate) fn colour(&self, range: RangeInclusive<f64>) -> Result<Colour, Fault> {
        match self.value {
            DeValue::Array(_) => Ok(Colour::Rgb(self.triple(range)?)),
            _ => Ok(Colour::Grey(self.number(range)?)),
        }
    }
}

/// A number for all channels, or three.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Colour {
    /// The same in each channel.
    Grey(f64),
    /// Red, green and blue.
    Rgb([f64; 3]),
}

impl Colour {
    /// Red, green and blue.
    #[must_use]
    pub fn rgb(self) -> [f64; 3] {
        match self {
            Self::Grey(value) => [value; 3],
            Self::Rgb(rgb) => rgb,
        }
    }

    /// Whether it was given as three numbers.
    #[must_use]
    pub fn is_rgb(self) -> bool {
        matches!(self, Self::Rgb(_))
    }
}

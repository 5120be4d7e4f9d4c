//! What is wrong with a file, and where.

use std::borrow::Cow;
use std::fmt;

/// A mistake in a scene or material file, with the place where it stands.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub struct SceneError {
    /// File name, or what stands in for it.
    pub source_name: String,
    /// Line and column, both from 1; `None` where the file itself is the
    /// trouble.
    pub place: Option<(usize, usize)>,
    /// What is wrong, with field, value and what is accepted.
    pub message: String,
}

impl fmt::Display for SceneError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.place {
            Some((line, column)) => {
                write!(
                    formatter,
                    "{}:{line}:{column}: {}",
                    self.source_name, self.message
                )
            }
            None => write!(formatter, "{}: {}", self.source_name, self.message),
        }
    }
}

/// A message at a byte of the text, before the file is known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Fault {
    pub(crate) offset: usize,
    pub(crate) message: String,
}

impl Fault {
    pub(crate) fn new(offset: usize, message: impl Into<String>) -> Self {
        Self {
            offset,
            message: message.into(),
        }
    }

    /// With more of what is accepted.
    pub(crate) fn or(mut self, more: &str) -> Self {
        self.message.push_str(more);
        self
    }

    pub(crate) fn within(self, source_name: &str, text: &str) -> SceneError {
        let mut offset = self.offset.min(text.len());
        while !text.is_char_boundary(offset) {
            offset -= 1;
        }
        let before = &text[..offset];
        let line = before.matches('\n').count() + 1;
        let column = before
            .rsplit('\n')
            .next()
            .map_or(0, |rest| rest.chars().count())
            + 1;
        SceneError {
            source_name: source_name.to_owned(),
            place: Some((line, column)),
            message: one_line(&self.message),
        }
    }
}

/// Greatest number of characters of a name or a value in a message.
const SHOWN: usize = 60;

/// A name or a value, cut to what a person reads.
pub(crate) fn shortened(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(SHOWN) {
        None => Cow::Borrowed(text),
        Some((end, _)) => Cow::Owned(format!("{}…", &text[..end])),
    }
}

/// The text with what would end its line, or ring a bell, escaped.
fn one_line(text: &str) -> String {
    let mut line = String::with_capacity(text.len());
    for character in text.chars() {
        if character.is_control() {
            line.extend(character.escape_default());
        } else {
            line.push(character);
        }
    }
    line
}

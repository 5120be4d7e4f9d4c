//! The application on a host: with a slow line, a panel that keeps what it is
//! shown, and failures.

mod last_words;
mod overlap;
mod panel;
mod support;

//! How fast this host renders, beside what one would otherwise take.

pub mod plain;

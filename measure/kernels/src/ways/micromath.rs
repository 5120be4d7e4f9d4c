//! Single precision, with micromath's functions: all else is as in [`super::f32`].

pub use super::f32::*;

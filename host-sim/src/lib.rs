//! The host simulator as a library: what the command `microbrdf` is made of.

pub mod advice;
pub mod arithmetic;
pub mod bench;
pub mod budget;
pub mod chart;
pub mod cli;
pub mod commands;
mod directions;
pub mod drawing;
pub mod energy;
pub mod exit;
pub mod measure;
pub mod picture;
mod progress;
pub mod reference_picture;
pub mod render;

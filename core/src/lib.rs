//! Physically plausible reflectance models for microcontrollers, in f32 and
//! fixed point.
#![no_std]

pub mod shade;
pub mod table;

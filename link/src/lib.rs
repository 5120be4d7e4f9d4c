//! The wire format between a shading microcontroller and its receiver.
#![no_std]

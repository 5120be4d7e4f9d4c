//! Scene files that mean no good: refused with a place and status 2, within a
//! second of a core and 500 MB, and nothing is written.
#![cfg(unix)]

mod bench;
mod meshes;
mod scenes;

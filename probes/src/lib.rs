//! What every probe shares: inputs that the compiler can't know, and a panic
//! handler that can't be linked.
//!
//! A probe is a program for a microcontroller that calls the core with
//! arbitrary input. The handler calls a function that nothing defines, so a
//! probe links only if the optimiser has proven that no panic is reachable.
//! `must_fail` has one, and must not link: the proof can fail. (Under an
//! immediate abort there would be no handler, and the proof none.)
#![cfg_attr(target_os = "none", no_std)]

mod fixed_point;
#[cfg(target_os = "none")]
mod handler;
mod pixel;

use core::hint::black_box;

use microbrdf::arithmetic::Arithmetic;
use microbrdf::brdf::Brdf;
use microbrdf::geometry::{Direction, ShadingFrame, World};
use microbrdf::sampling::{Sample, Sampling};

/// Evaluates a model in every way, at directions of any bits.
#[inline(never)]
pub fn evaluate<A: Arithmetic>(model: &impl Brdf<A>, components: [A::Component; 9], gain: A::Gain) {
    let [nx, ny, nz, lx, ly, lz, vx, vy, vz] = black_box(components);
    let (n, l, v) = (
        Direction::new(nx, ny, nz),
        Direction::new(lx, ly, lz),
        Direction::new(vx, vy, vz),
    );
    let frame = ShadingFrame::new(l, v);
    let world = World::new(n, l, v);
    let gain = microbrdf::Rgb::grey(black_box(gain));
    black_box((model.brdf(&frame), model.brdf(&world)));
    black_box((model.reflect(&frame), model.reflect(&world)));
    black_box((model.share(&frame), model.share(&world)));
    black_box(A::linear(model.shade(&gain, &world)).srgb8());
    black_box(A::linear(model.shade(&gain, &frame)).rgb565());
}

/// Draws from a sampler, at directions of any bits.
#[inline(never)]
pub fn draw<A: Sampling>(
    sampler: &impl Sample<A>,
    components: [A::Component; 6],
    random: [A::Uniform; 2],
) {
    let [lx, ly, lz, vx, vy, vz] = black_box(components);
    let (l, v) = (Direction::new(lx, ly, lz), Direction::new(vx, vy, vz));
    black_box(sampler.sample(&v, black_box(random)));
    black_box(sampler.pdf(&l, &v));
}

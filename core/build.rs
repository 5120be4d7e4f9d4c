//! Tells the source which instructions its target has. Both ways to do a step
//! give the same bits: it is a matter of cycles alone.

use std::env;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(long_multiply)");
    println!("cargo::rustc-check-cfg=cfg(count_zeros)");
    println!("cargo::rustc-check-cfg=cfg(saturates)");
    let target = env::var("TARGET").unwrap_or_default();
    let small_arm = target.starts_with("thumbv6m") || target.starts_with("thumbv8m.base");
    let risc_v = target.starts_with("riscv");
    if !small_arm {
        println!("cargo::rustc-cfg=long_multiply");
    }
    if target.starts_with("thumb") && !small_arm {
        println!("cargo::rustc-cfg=saturates");
    }
    // RISC-V counts zeros with its extension Zbb alone.
    let features = env::var("CARGO_CFG_TARGET_FEATURE").unwrap_or_default();
    if !small_arm && (!risc_v || features.split(',').any(|feature| feature == "zbb")) {
        println!("cargo::rustc-cfg=count_zeros");
    }
}

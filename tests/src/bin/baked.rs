//! Writes `tests/baked`, the Rust of [`SCENES`].

use microbrdf_tests::baked::{ARITHMETICS, SCENES, source};

fn main() -> std::io::Result<()> {
    let folder = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/baked"));
    std::fs::create_dir_all(folder)?;
    for (name, text) in SCENES {
        for arithmetic in ARITHMETICS {
            let file = folder.join(format!("{name}-{}.rs", arithmetic.name()));
            std::fs::write(file, source(name, text, arithmetic))?;
        }
    }
    Ok(())
}

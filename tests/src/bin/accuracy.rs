//! Writes `docs/accuracy.md`, `docs/dither.md`,
//! `docs/energy.md` and `docs/highlights.md`.

fn main() -> std::io::Result<()> {
    let folder = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../docs"));
    std::fs::write(
        folder.join("accuracy.md"),
        microbrdf_tests::document::accuracy(),
    )?;
    std::fs::write(
        folder.join("dither.md"),
        microbrdf_tests::dither::document(),
    )?;
    std::fs::write(
        folder.join("energy.md"),
        microbrdf_tests::energy::document(),
    )?;
    std::fs::write(
        folder.join("highlights.md"),
        microbrdf_tests::flicker::document(),
    )
}

//! Writes `docs/accuracy.md` and `docs/energy.md`.

fn main() -> std::io::Result<()> {
    let folder = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../docs"));
    std::fs::write(
        folder.join("accuracy.md"),
        microbrdf_tests::document::accuracy(),
    )?;
    std::fs::write(
        folder.join("energy.md"),
        microbrdf_tests::energy::document(),
    )
}

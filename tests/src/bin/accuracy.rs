//! Writes `docs/accuracy.md`.

fn main() -> std::io::Result<()> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/accuracy.md");
    std::fs::write(path, microbrdf_tests::document::accuracy())
}

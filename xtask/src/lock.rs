//! Files that one process at a time may hold: steps of the tests run beside each other.

use std::fs::{self, File};
use std::path::Path;

use crate::failure::{During, Outcome};

/// Waits until nobody else holds this file, and holds it until the value goes.
#[expect(
    clippy::incompatible_msrv,
    reason = "clippy.toml has the version that the core promises; this crate's is newer"
)]
pub fn hold(path: &Path) -> Outcome<File> {
    let what = || format!("locking {}", path.display());
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).during(what)?;
    }
    let file = File::create(path).during(what)?;
    file.lock().during(what)?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::hold;
    use std::fs::{self, File};

    #[test]
    fn what_is_held_is_not_free() {
        let path = std::env::temp_dir().join(format!("xtask-lock-{}", std::process::id()));
        let held = hold(&path).unwrap();
        let other = File::open(&path).unwrap();
        assert!(other.try_lock().is_err());
        drop(held);
        assert!(other.try_lock().is_ok());
        fs::remove_file(path).unwrap();
    }
}

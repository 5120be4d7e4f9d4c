//! Files that a person names.

use std::path::Path;

use crate::error::{Fault, SceneError};

/// Greatest size of a scene or material file.
const GREATEST_SIZE: u64 = 1 << 20;

/// Reads a text file.
///
/// # Errors
/// The file is missing, is no readable file, is larger than 1 MiB or is not
/// UTF-8.
pub fn read(path: &Path) -> Result<String, SceneError> {
    read_at_most(path, GREATEST_SIZE)
}

/// Reads a text file of at most so many bytes.
pub(crate) fn read_at_most(path: &Path, greatest_size: u64) -> Result<String, SceneError> {
    let fault = |message: String| SceneError {
        source_name: path.display().to_string(),
        place: None,
        message,
    };
    let size = std::fs::metadata(path).map_err(|error| fault(format!("can't be read: {error}")))?;
    if !size.is_file() {
        return Err(fault("is not a file".to_owned()));
    }
    if size.len() > greatest_size {
        return Err(fault(format!(
            "has {} bytes: must be at most {greatest_size}",
            size.len()
        )));
    }
    let bytes = std::fs::read(path).map_err(|error| fault(format!("can't be read: {error}")))?;
    String::from_utf8(bytes).map_err(|error| {
        let end = error.utf8_error().valid_up_to();
        let before = String::from_utf8_lossy(&error.as_bytes()[..end]);
        Fault::new(end, format!("is not UTF-8 text from byte {end} on"))
            .within(&path.display().to_string(), &before)
    })
}

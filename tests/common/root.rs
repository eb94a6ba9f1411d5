//! Where the project's files are.

use std::path::PathBuf;

/// The project's folder as cargo names it when it runs the tests. What the compiler saw would be
/// another checkout's folder where two of them share their target folder.
pub(crate) fn root() -> PathBuf {
    std::env::var_os("CARGO_MANIFEST_DIR")
        .map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from)
}

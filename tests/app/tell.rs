//! The command line told something, as the tests of its rooms do it.

use std::ffi::OsString;

use serde_json::Value;
use spectral_explorer::cli::{self, Outcome};

/// What the command line makes of some words: exit code, output, errors.
pub(crate) fn tell(args: &[&str]) -> (u8, String, String) {
    let words = std::iter::once(&cli::PROGRAM).chain(args);
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let outcome = cli::run(words.map(OsString::from), None, &mut out, &mut err);
    let Outcome::Done(code) = outcome else {
        panic!("{args:?}: opened a window");
    };
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (code, text(out), text(err))
}

/// The JSON that a command prints.
pub(crate) fn json(args: &[&str]) -> Value {
    let (code, out, err) = tell(args);
    assert_eq!(code, 0, "{args:?}: {err}");
    serde_json::from_str(&out).expect("JSON")
}

/// One line on `err`, nothing on `out`, and the exit code.
pub(crate) fn refusal(args: &[&str]) -> (String, u8) {
    let (code, out, err) = tell(args);
    assert_ne!(code, 0, "{args:?}: {out}");
    assert_eq!(
        (out.as_str(), err.lines().count()),
        ("", 1),
        "{args:?}: {err}"
    );
    (err, code)
}

//! How much memory a file may take: what is packed small must not unfold without bounds.

/// Memory that any file may take: 16 MiB.
const FLOOR: usize = 16 << 20;

/// Memory that each byte of a file may take besides.
const TIMES: usize = 20;

/// Most bytes of memory that a file of some bytes may take: 16 MiB and 20 times its size.
pub fn of(file_bytes: usize) -> usize {
    FLOOR.saturating_add(file_bytes.saturating_mul(TIMES))
}

/// The limit in words, for refusals.
pub const WORDS: &str = "at most 16 MiB of memory and 20 times the file's size";

/// A size in the unit that suits it.
pub fn in_words(bytes: usize) -> String {
    match bytes {
        0..=9_999 => format!("{bytes} bytes"),
        10_000..=9_999_999 => format!("{} KiB", bytes >> 10),
        _ => format!("{} MiB", bytes >> 20),
    }
}

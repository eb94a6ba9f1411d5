//! Limits on the memory of a file: small packed data must not unfold without bounds, and honest
//! data may be packed as small as it will.

/// Memory that any file may take, however small it is: 512 MiB. What is read band by band or row by
/// row keeps to it too.
pub(crate) const CEILING: usize = 512 << 20;

/// Memory that each byte of a file may take where that is more: of a large table in words.
const TIMES: usize = 20;

/// Most bytes of memory that a file of some bytes may take: 512 MiB, or 20 times its size.
pub(crate) fn of(file_bytes: usize) -> usize {
    CEILING.max(file_bytes.saturating_mul(TIMES))
}

/// Most bytes of memory for what is written out in a text beside its numbers: records, keys,
/// elements and repetitions, of which an honest file has few. 16 MiB, and 20 times its size.
pub(crate) fn of_text(file_bytes: usize) -> usize {
    file_bytes.saturating_mul(TIMES).saturating_add(16 << 20)
}

/// The limits in words, for refusals.
pub(crate) const WORDS: &str = later!("at most 512 MiB of memory, or 20 times the file's size");
/// The same of [`of_text`].
pub(crate) const TEXT_WORDS: &str = later!("at most 16 MiB of memory and 20 times the file's size");

/// A size in the unit that suits it.
pub(crate) fn in_words(bytes: usize) -> String {
    match bytes {
        0..=9_999 => tr!("{n} bytes" | "{n} bytes" % bytes),
        10_000..=9_999_999 => format!("{} KiB", bytes >> 10),
        _ => format!("{} MiB", bytes >> 20),
    }
}

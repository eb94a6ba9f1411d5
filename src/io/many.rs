//! Counts in words: "1 number", "7 numbers"; and capitals.

/// A count and what is counted.
pub fn many(count: usize, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}

/// A count of a model's numbers.
pub fn numbers(count: usize) -> String {
    tr!("{n} number" | "{n} numbers" % count)
}

/// Words with a large first letter.
pub(crate) fn capitalised(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).collect()
}

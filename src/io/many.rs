//! Counts in words: "1 number", "7 numbers".

/// A count and what is counted.
pub fn many(count: usize, one: &str, several: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { several })
}

/// A count of a model's numbers.
pub fn numbers(count: usize) -> String {
    many(count, "number", "numbers")
}

//! Names in the order in which people count: f1, f2, f10.

/// A piece of a name: its numbers stand in their own order.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Piece {
    /// Digits, without leading zeros: longer ones are larger.
    Number(usize, String),
    /// Other letters.
    Word(String),
}

/// What a name is sorted by; the name itself at the end, so that no two names are equal.
pub(super) fn natural(name: &str) -> (Vec<Piece>, String) {
    let mut pieces = Vec::new();
    let mut rest = name;
    while let Some(first) = rest.chars().next() {
        let is_number = first.is_ascii_digit();
        let end = rest
            .find(|c: char| c.is_ascii_digit() != is_number)
            .unwrap_or(rest.len());
        let (piece, after) = rest.split_at(end);
        rest = after;
        pieces.push(if is_number {
            let digits = piece.trim_start_matches('0');
            Piece::Number(digits.len(), digits.to_owned())
        } else {
            Piece::Word(piece.to_owned())
        });
    }
    (pieces, name.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_names_are_counted() {
        let mut names = ["f10", "f2", "f1", "f01", "g", "f2b3", "f2b20", ""];
        names.sort_by_cached_key(|name| natural(name));
        assert_eq!(names, ["", "f01", "f1", "f2", "f2b3", "f2b20", "f10", "g"]);
    }
}

//! One figure as a table shows it.

/// A figure with what a person needs to read it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its key in JSON and in tables; R1 to R15 are `r1` to `r15`.
    pub key: &'static str,
    /// Its name on screen.
    pub title: &'static str,
    /// Unit, empty for pure numbers.
    pub unit: &'static str,
    /// Digits behind the point that are shown.
    pub digits: usize,
    /// By which standard and on which data, a sentence.
    pub method: &'static str,
    /// The number, or why there is none.
    pub value: Result<f64, String>,
    /// What the number means in plain words; empty where there is nothing to add.
    pub reading: String,
}

impl Row {
    /// The value as shown: digits and unit, or a dash.
    pub fn shown(&self) -> String {
        match self.value {
            Ok(value) if self.unit.is_empty() => figure_words(value, self.digits),
            Ok(value) => format!("{} {}", figure_words(value, self.digits), self.unit),
            Err(_) => "–".to_owned(),
        }
    }
}

/// A number with digits behind the point and no minus before a zero.
pub fn figure_words(value: f64, digits: usize) -> String {
    let words = format!("{value:.digits$}");
    match words.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| matches!(c, '0' | '.')) => rest.to_owned(),
        _ => words,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_zero_has_no_sign() {
        assert_eq!(figure_words(-0.000_01, 4), "0.0000");
        assert_eq!(figure_words(-0.000_06, 4), "-0.0001");
        assert_eq!(figure_words(-0.4, 0), "0");
        assert_eq!(figure_words(583.46, 1), "583.5");
    }
}

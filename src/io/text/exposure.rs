//! The exposure that a text states.

/// Words before an exposure, and its units in ms.
const EXPOSURES: [&str; 5] = [
    "integration time",
    "integrationtime",
    "exposure",
    "i-time",
    "int. time",
];
const TIMES: [(&str, f64); 9] = [
    ("usec", 1e-3),
    ("us", 1e-3),
    ("\u{b5}s", 1e-3),
    ("\u{3bc}s", 1e-3),
    ("msec", 1.0),
    ("ms", 1.0),
    ("sec", 1e3),
    ("seconds", 1e3),
    ("s", 1e3),
];

/// The exposure that a file states, ms: a line such as `Integration Time (usec): 30000` or
/// `# exposure: 30 ms`; `None` without a unit, which may be any.
pub fn exposure_ms(text: &str) -> Option<f64> {
    let line = |line: &str| {
        let line = line.to_lowercase();
        let start = EXPOSURES
            .iter()
            .find_map(|word| Some(line.find(word)? + word.len()))?;
        let rest = &line[start..];
        let mut words = rest.split(|c: char| !(c.is_alphanumeric() || "+-.".contains(c)));
        let (mut number, mut unit) = (None, None);
        for word in words.by_ref().filter(|word| !word.is_empty()) {
            // The unit may stand right behind the number: 30ms.
            let digits = word.trim_end_matches(|c: char| c.is_alphabetic());
            let end = &word[digits.len()..];
            let value = word.parse::<f64>().ok().or_else(|| digits.parse().ok());
            number = number.or(value);
            let named = |word: &str| TIMES.iter().find(|(name, _)| *name == word);
            unit = unit.or(named(word).or_else(|| named(end)).map(|(_, ms)| *ms));
        }
        let found = number? * unit?;
        (found > 0.0 && found.is_finite()).then_some(found)
    };
    text.lines().take(MOST_HEAD).find_map(line)
}

/// Lines of a file's head in which an exposure is looked for.
const MOST_HEAD: usize = 200;

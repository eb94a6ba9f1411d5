//! Formulas over inputs: `A - B`, `(A - C) / (B - C)`, `0.5*A + B`, `-log10(A / B)`.
//!
//! Letters are the inputs in their order; only `+ - * / ( )`, numbers and `-log10`.

use std::fmt;

use super::quantity::Operation;

/// Deepest nesting.
const DEEPEST: usize = 16;

/// A formula over inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula(pub(super) Tree);

/// A part of a formula.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Tree {
    Input(usize),
    Number(f64),
    Of(Operation, Box<Tree>, Box<Tree>),
    /// `-log10` of a part.
    Absorbance(Box<Tree>),
}

/// Why a text is no formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FormulaError {
    pub found: String,
    pub expected: &'static str,
}

impl fmt::Display for FormulaError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { found, expected } = self;
        f.write_str(&tr!("found {found}, expected {expected}", found, expected))
    }
}

impl std::error::Error for FormulaError {}

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Input(usize),
    Number(f64),
    Log,
    Sign(char),
}

impl Formula {
    /// The formula in a text.
    ///
    /// # Errors
    /// [`FormulaError`] with what was found and what was expected.
    pub fn parse(text: &str) -> Result<Self, FormulaError> {
        let mut parser = Parser {
            tokens: tokens(text)?,
            at: 0,
        };
        let tree = parser.sum(0)?;
        match parser.tokens.get(parser.at) {
            None => Ok(Self(tree)),
            Some(token) => Err(FormulaError {
                found: token.words(),
                expected: said!("+, -, *, / or the end of the formula"),
            }),
        }
    }

    /// Number of inputs needed: one more than the place of the last letter.
    pub fn inputs(&self) -> usize {
        self.letters()
            .into_iter()
            .map(|index| index + 1)
            .max()
            .unwrap_or(0)
    }

    /// The inputs that it names, each once, in their order.
    pub fn letters(&self) -> Vec<usize> {
        fn add(tree: &Tree, found: &mut Vec<usize>) {
            match tree {
                Tree::Input(index) => found.push(*index),
                Tree::Number(_) => {}
                Tree::Of(_, a, b) => {
                    add(a, found);
                    add(b, found);
                }
                Tree::Absorbance(a) => add(a, found),
            }
        }
        let mut found = Vec::new();
        add(&self.0, &mut found);
        found.sort_unstable();
        found.dedup();
        found
    }
}

impl Formula {
    /// The inputs that stand in a divisor.
    pub fn divisors(&self) -> Vec<usize> {
        fn add(tree: &Tree, found: &mut Vec<usize>) {
            match tree {
                Tree::Input(_) | Tree::Number(_) => {}
                Tree::Of(operation, a, b) => {
                    add(a, found);
                    add(b, found);
                    if *operation == Operation::Divide {
                        found.extend(Formula((**b).clone()).letters());
                    }
                }
                Tree::Absorbance(a) => add(a, found),
            }
        }
        let mut found = Vec::new();
        add(&self.0, &mut found);
        found.sort_unstable();
        found.dedup();
        found
    }

    /// The factors of the inputs where the formula is a weighted sum of them; `None` for any other.
    pub fn factors(&self) -> Option<Vec<f64>> {
        /// A number, or factors of the inputs.
        enum Part {
            Number(f64),
            Sum(Vec<f64>),
        }
        fn of(tree: &Tree, inputs: usize) -> Option<Part> {
            let scaled = |sum: Vec<f64>, by: f64| Part::Sum(sum.iter().map(|v| v * by).collect());
            Some(match tree {
                Tree::Number(value) => Part::Number(*value),
                Tree::Input(index) => {
                    let own = (0..inputs).map(|i| f64::from(u8::from(i == *index)));
                    Part::Sum(own.collect())
                }
                Tree::Absorbance(_) => return None,
                Tree::Of(operation, a, b) => match (operation, of(a, inputs)?, of(b, inputs)?) {
                    (Operation::Add, Part::Sum(a), Part::Sum(b)) => {
                        Part::Sum(a.iter().zip(b).map(|(a, b)| a + b).collect())
                    }
                    (Operation::Subtract, Part::Sum(a), Part::Sum(b)) => {
                        Part::Sum(a.iter().zip(b).map(|(a, b)| a - b).collect())
                    }
                    (Operation::Multiply, Part::Sum(sum), Part::Number(by))
                    | (Operation::Multiply, Part::Number(by), Part::Sum(sum)) => scaled(sum, by),
                    (Operation::Divide, Part::Sum(sum), Part::Number(by)) => {
                        scaled(sum, by.recip())
                    }
                    _ => return None,
                },
            })
        }
        match of(&self.0, self.inputs())? {
            Part::Sum(factors) => factors.iter().all(|f| f.is_finite()).then_some(factors),
            Part::Number(_) => None,
        }
    }

    /// True if a word continues the text of a formula: the text is not at its end yet, or the word
    /// begins with a sign. `A`, `-` and `B` are three words of one formula; `/lamp.csv` is not one.
    pub fn goes_on(text: &str, word: &str) -> bool {
        let Ok(tokens) = tokens(word) else {
            return false;
        };
        let is_sign = matches!(tokens.first(), Some(Token::Sign(sign)) if *sign != '(');
        is_sign || !tokens.is_empty() && Self::parse(text).is_err()
    }
}

impl Token {
    fn words(&self) -> String {
        match self {
            Self::Input(index) => super::letter(*index).to_string(),
            Self::Number(value) => value.to_string(),
            Self::Log => "log10".to_owned(),
            Self::Sign(sign) => sign.to_string(),
        }
    }
}

fn tokens(text: &str) -> Result<Vec<Token>, FormulaError> {
    let mut tokens = Vec::new();
    let mut rest = text.trim_start();
    while let Some(letter) = rest.chars().next() {
        let (token, length) = match letter {
            '+' | '-' | '*' | '/' | '(' | ')' => (Token::Sign(letter), 1),
            '0'..='9' | '.' => number(rest)?,
            _ => {
                let end = rest.find(|c: char| !c.is_ascii_alphanumeric());
                let word = &rest[..end.unwrap_or(rest.len())];
                match word.as_bytes() {
                    b"log10" => (Token::Log, word.len()),
                    [one @ b'A'..=b'Z'] => (Token::Input(usize::from(one - b'A')), 1),
                    _ => {
                        let found = if word.is_empty() {
                            letter.to_string()
                        } else {
                            word.to_owned()
                        };
                        return Err(FormulaError {
                            found,
                            expected: said!(
                                "a letter of an input (A, B, ...), a number, + - * / ( ) or -log10"
                            ),
                        });
                    }
                }
            }
        };
        tokens.push(token);
        rest = rest[length..].trim_start();
    }
    Ok(tokens)
}

/// A number with its exponent: `0.5`, `1e-3`.
fn number(rest: &str) -> Result<(Token, usize), FormulaError> {
    let bytes = rest.as_bytes();
    let digits = |from: usize| {
        let more = bytes[from..].iter();
        from + more
            .take_while(|b| b.is_ascii_digit() || **b == b'.')
            .count()
    };
    let mut end = digits(0);
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let signed = end + 1 + usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        if digits(signed) > signed {
            end = digits(signed);
        }
    }
    match rest[..end].parse::<f64>() {
        Ok(value) if value.is_finite() => Ok((Token::Number(value), end)),
        _ => Err(FormulaError {
            found: rest[..end].to_owned(),
            expected: said!("a number"),
        }),
    }
}

struct Parser {
    tokens: Vec<Token>,
    at: usize,
}

impl Parser {
    fn takes(&mut self, signs: [char; 2]) -> Option<char> {
        match self.tokens.get(self.at) {
            Some(Token::Sign(sign)) if signs.contains(sign) => {
                self.at += 1;
                Some(*sign)
            }
            _ => None,
        }
    }

    fn sum(&mut self, depth: usize) -> Result<Tree, FormulaError> {
        self.row(depth, ['+', '-'], Self::product)
    }

    fn product(&mut self, depth: usize) -> Result<Tree, FormulaError> {
        self.row(depth, ['*', '/'], Self::part)
    }

    /// Parts with signs of one rank between them, from left to right.
    fn row(
        &mut self,
        depth: usize,
        signs: [char; 2],
        part: fn(&mut Self, usize) -> Result<Tree, FormulaError>,
    ) -> Result<Tree, FormulaError> {
        let mut tree = part(self, depth)?;
        while let Some(sign) = self.takes(signs) {
            let operation = match sign {
                '+' => Operation::Add,
                '-' => Operation::Subtract,
                '*' => Operation::Multiply,
                _ => Operation::Divide,
            };
            tree = Tree::Of(operation, Box::new(tree), Box::new(part(self, depth)?));
        }
        Ok(tree)
    }

    fn part(&mut self, depth: usize) -> Result<Tree, FormulaError> {
        if depth > DEEPEST {
            return Err(FormulaError {
                found: tr!(
                    "more than {most} brackets within each other",
                    most = DEEPEST
                ),
                expected: said!("fewer"),
            });
        }
        let token = self.tokens.get(self.at).cloned();
        self.at += 1;
        match token {
            Some(Token::Input(index)) => Ok(Tree::Input(index)),
            Some(Token::Number(value)) => Ok(Tree::Number(value)),
            Some(Token::Sign('(')) => self.bracket(depth + 1),
            Some(Token::Sign('-')) if self.tokens.get(self.at) == Some(&Token::Log) => {
                self.at += 1;
                if self.takes(['(', '(']).is_none() {
                    return Err(self.unexpected(said!("( behind -log10")));
                }
                Ok(Tree::Absorbance(Box::new(self.bracket(depth + 1)?)))
            }
            Some(Token::Sign('-')) => {
                let part = self.part(depth + 1)?;
                let minus = Box::new(Tree::Number(-1.0));
                Ok(Tree::Of(Operation::Multiply, minus, Box::new(part)))
            }
            _ => {
                self.at -= 1;
                Err(self.unexpected(said!("a letter of an input, a number, ( or -log10(")))
            }
        }
    }

    /// Parses the rest of a bracket after its opening, with the closing one.
    fn bracket(&mut self, depth: usize) -> Result<Tree, FormulaError> {
        let inside = self.sum(depth)?;
        match self.takes([')', ')']) {
            Some(_) => Ok(inside),
            None => Err(self.unexpected(")")),
        }
    }

    fn unexpected(&self, expected: &'static str) -> FormulaError {
        let found = self.tokens.get(self.at);
        FormulaError {
            found: found.map_or_else(|| said!("the end of the formula").to_owned(), Token::words),
            expected,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn why(text: &str) -> String {
        Formula::parse(text).expect_err(text).to_string()
    }

    #[test]
    fn a_formula_binds_as_in_school() {
        use Operation::{Add, Divide, Multiply, Subtract};
        let input = |index| Box::new(Tree::Input(index));
        let of = |op, a, b| Tree::Of(op, a, b);
        let parse = |text: &str| Formula::parse(text).expect(text).0;
        let half = of(Multiply, Box::new(Tree::Number(0.5)), input(0));
        assert_eq!(parse("0.5*A + B"), of(Add, Box::new(half), input(1)));
        let dark = |index| Box::new(of(Subtract, input(index), input(2)));
        assert_eq!(parse("(A-C)/(B - C)"), of(Divide, dark(0), dark(1)));
        let ratio = Box::new(of(Divide, input(0), input(1)));
        assert_eq!(parse("-log10(A / B)"), Tree::Absorbance(ratio));
        // From the left.
        let first = Box::new(of(Subtract, input(0), input(1)));
        assert_eq!(parse("A - B - C"), of(Subtract, first, input(2)));
        assert_eq!(parse("1e-3"), Tree::Number(1e-3));
        assert_eq!(
            Formula::parse("A*C").expect("two letters").letters(),
            [0, 2]
        );
        assert_eq!(Formula::parse("A*C").expect("two letters").inputs(), 3);
    }

    #[test]
    fn words_of_a_formula_end_where_files_begin() {
        assert!(Formula::goes_on("A", "-"));
        assert!(Formula::goes_on("A -", "B"));
        assert!(Formula::goes_on("(A - C)", "/ (B"));
        assert!(!Formula::goes_on("A - B", "C"));
        assert!(!Formula::goes_on("A - B", "lamp.csv"));
        assert!(!Formula::goes_on("A", "/lamp.csv"));
        assert_eq!(
            Formula::parse("A / (B - C)").expect("three").divisors(),
            [1, 2]
        );
        assert!(Formula::parse("A * B").expect("two").divisors().is_empty());
    }

    #[test]
    fn what_is_no_formula_is_refused_with_what_was_expected() {
        assert_eq!(
            why("A -"),
            "found the end of the formula, expected a letter of an input, a number, ( or -log10("
        );
        assert_eq!(why("(A"), "found the end of the formula, expected )");
        assert_eq!(
            why("A B"),
            "found B, expected +, -, *, / or the end of the formula"
        );
        assert!(why("sin(A)").starts_with("found sin, expected a letter"));
        assert!(why("log10(A)").starts_with("found log10"));
        assert!(why("1.2.3*A").starts_with("found 1.2.3, expected a number"));
        let deep = format!("{}A{}", "(".repeat(40), ")".repeat(40));
        assert!(why(&deep).contains("more than 16"));
        let deep = format!("{}A", "-".repeat(4000));
        assert!(why(&deep).contains("more than 16"));
    }
}

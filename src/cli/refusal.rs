//! Why nothing came of it: one line and an exit code.

use std::{
    error::Error as _,
    fmt::Display,
    io::{self, ErrorKind as Io, Write},
};

use clap::error::{ContextKind, ContextValue, ErrorKind};

use super::words;
use crate::io::quoted;

/// A command that was not carried out.
#[derive(Debug)]
pub(super) enum Refusal {
    /// The arguments make no sense.
    Usage(String),
    /// An input cannot be read, or a file cannot be written.
    File(String),
    /// What should have been printed could not be.
    Output(io::Error),
}

impl Refusal {
    /// The refusal of arguments, for an error that says why.
    pub(super) fn usage(why: impl Display) -> Self {
        Self::Usage(why.to_string())
    }

    /// The refusal of a file, for an error that says why.
    pub(super) fn file(why: impl Display) -> Self {
        Self::File(why.to_string())
    }

    /// Says so in one line and gives the exit code: 2 for arguments, 1 for files; a reader that
    /// went away (`| head`) has all it wanted and is no error.
    pub(super) fn tell(self, err: &mut dyn Write) -> u8 {
        let code = match &self {
            Self::Usage(_) => 2,
            Self::File(_) => 1,
            Self::Output(error) if error.kind() == Io::BrokenPipe => return 0,
            Self::Output(_) => 1,
        };
        super::remark(err, &self.into_words());
        code
    }

    /// What was found and what was expected.
    pub(super) fn into_words(self) -> String {
        match self {
            Self::Usage(text) | Self::File(text) => text,
            Self::Output(error) => {
                format!("the output: found {}, expected to write it", error.kind())
            }
        }
    }
}

/// Text without line ends and other marks that would break a line.
pub(super) fn in_one_line(text: &str) -> String {
    let breaks = |c: char| c.is_control() || matches!(c, '\u{2028}' | '\u{2029}');
    with_short_numbers(&text.trim().replace(breaks, " "))
}

/// Most digits of a number that is told as it is.
const MOST_DIGITS: usize = 30;

/// Numbers of hundreds of digits as powers of ten.
fn with_short_numbers(text: &str) -> String {
    let mut short = String::new();
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let (before, number) = rest.split_at(start);
        let end = number.find(|c: char| !c.is_ascii_digit() && c != '.');
        let (number, behind) = number.split_at(end.unwrap_or(number.len()));
        short += before;
        match number.parse::<f64>() {
            Ok(value) if number.len() > MOST_DIGITS && !before.ends_with(is_word) => {
                short += &format!("{value:e}");
            }
            _ => short += number,
        }
        rest = behind;
    }
    short + rest
}

/// A sign of a name, in which digits are no number.
fn is_word(sign: char) -> bool {
    sign.is_alphanumeric() || "_-/.".contains(sign)
}

/// What clap has to say: help and version are text to print, everything else a refusal.
///
/// # Errors
/// [`Refusal::Usage`] with the offending word and what was expected.
pub(super) fn of_clap(error: &clap::Error) -> Result<String, Refusal> {
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            Ok(error.render().to_string())
        }
        ErrorKind::DisplayVersion => Ok(format!(
            "{} {}\n",
            super::PROGRAM,
            env!("CARGO_PKG_VERSION")
        )),
        _ => Err(Refusal::Usage(in_words(error))),
    }
}

fn in_words(error: &clap::Error) -> String {
    let context = |kind| error.get(kind).map(words_of).unwrap_or_default();
    let option = context(ContextKind::InvalidArg);
    // "--order <N>" is called "--order".
    let name = option.split(" <").next().unwrap_or_default().to_owned();
    let value = context(ContextKind::InvalidValue);
    match error.kind() {
        ErrorKind::ValueValidation => match error.source() {
            Some(why) => format!("{name}: {why}"),
            None => format!("{name}: found {}, expected another value", quoted(&value)),
        },
        ErrorKind::InvalidValue if value.is_empty() => {
            format!("{name}: found no value, expected {option} (see --help)")
        }
        // "[ACT]" is called "ACT".
        ErrorKind::InvalidValue => {
            let known = context(ContextKind::ValidValue);
            let known = words::listed(&known.split(", ").collect::<Vec<_>>());
            let name = name.trim_matches(['[', ']', '<', '>']);
            format!("{name}: {}", words::refused(&value, known))
        }
        ErrorKind::TooManyValues => format!("{name}: found {}, expected no value", quoted(&value)),
        ErrorKind::UnknownArgument => {
            let close = context(ContextKind::SuggestedArg);
            let hint = if !option.starts_with('-') {
                "no further word (quote a name that has blanks)".to_owned()
            } else if close.is_empty() {
                "a known option (see --help)".to_owned()
            } else {
                format!("{close} or another known option (see --help)")
            };
            format!("found {}, expected {hint}", quoted(&option))
        }
        ErrorKind::InvalidSubcommand => {
            let word = context(ContextKind::InvalidSubcommand);
            format!("found {}, expected a command (see --help)", quoted(&word))
        }
        ErrorKind::MissingRequiredArgument => {
            let missing = option.replace(['<', '>'], "");
            let missing: Vec<&str> = missing.split(", ").collect();
            let expected = match missing.len() {
                1 => "one",
                2 => "both",
                _ => "all of them",
            };
            let missing = missing.join(" and no ");
            format!("found no {missing}, expected {expected} (see --help)")
        }
        ErrorKind::ArgumentConflict => {
            let other = context(ContextKind::PriorArg);
            if other.is_empty() || other == option {
                format!("{name}: found twice, expected once")
            } else {
                format!("found {option} together with {other}, expected one of them")
            }
        }
        ErrorKind::InvalidUtf8 => "found a word that is no Unicode, expected text".to_owned(),
        _ => first_line(error),
    }
}

fn words_of(value: &ContextValue) -> String {
    match value {
        ContextValue::Strings(all) => all.join(", "),
        other => other.to_string(),
    }
}

fn first_line(error: &clap::Error) -> String {
    let text = error.render().to_string();
    let line = text.lines().next().unwrap_or_default();
    line.trim_start_matches("error: ").to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_of_hundreds_of_digits_is_told_in_few() {
        let huge = format!("found {} nm, expected 380 to 780.5", f64::MAX);
        let told = in_one_line(&huge);
        assert_eq!(
            told,
            "found 1.7976931348623157e308 nm, expected 380 to 780.5"
        );
        // The digits of a name are no number.
        let name = format!("lamp_{}.csv: found a\nbreak", "7".repeat(40));
        assert_eq!(in_one_line(&name), name.replace('\n', " "));
    }
}

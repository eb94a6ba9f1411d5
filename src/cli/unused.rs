//! Options that were given and change nothing: one table says which, and why.
//!
//! What depends on an input and not on the command line alone is said where that is known.

use std::collections::BTreeSet;

use clap::{Arg, ArgMatches, CommandFactory, parser::ValueSource};

use super::{arguments::Arguments, inputs::Inputs};

/// Options that some commands do not use.
struct Rule {
    /// The commands.
    of: &'static [&'static str],
    /// Where all of these were given,
    with: &'static [&'static str],
    /// and none of these.
    without: &'static [&'static str],
    /// The options.
    options: &'static [&'static [&'static str]],
    /// Why they change nothing.
    why: &'static str,
}

const ALWAYS: Rule = Rule {
    of: &[],
    with: &[],
    without: &[],
    options: &[],
    why: "",
};

/// How lines are found.
const LINES: &[&str] = &["--threshold", "--max-width", "--wide-lines", "--dips"];
/// How the smooth part is fitted.
const FIT: &[&str] = &[
    "--order",
    "--basis",
    "--colour-exact",
    "--plain",
    "--as-in-paper",
];
/// The rest of the model's options.
const OTHERS: &[&str] = &["--no-spikes", "--range", "--observer", "--sampling"];
/// Which spectrum of an input, and what shines on it.
const PICK: &[&str] = &["--spectrum", "--kind", "--light", "--pixel", "--region"];
/// Why it changes nothing where there are curves alone.
const NO_COLOUR: &str = "no colour is told here";
/// Why an observer changes nothing where no model's colour is made exact for it.
const STANDARD_OBSERVER: &str = "every figure has the observer of its standard";
/// Why an option means nothing to commands that go through all ways of modelling.
const CHANGES_NOTHING: &str = "it changes nothing here";

const RULES: &[Rule] = &[
    Rule {
        of: &[
            "report", "light", "product", "prism", "rainbow", "gem", "plot",
        ],
        with: &["--no-spikes"],
        options: &[LINES],
        why: "--no-spikes looks for no lines",
        ..ALWAYS
    },
    Rule {
        of: &["prism", "rainbow", "gem"],
        without: &["--as-modelled"],
        options: &[FIT],
        why: "the light goes through as measured; --as-modelled sends its model",
        ..ALWAYS
    },
    Rule {
        of: &["light"],
        with: &["--against"],
        without: &["--json"],
        options: &[FIT, LINES, OTHERS],
        why: "lights are compared as measured; with --json their models stand beside them",
    },
    Rule {
        of: &["light", "prism", "rainbow", "gem", "plot"],
        options: &[&["--sampling"]],
        why: "nothing is multiplied here",
        ..ALWAYS
    },
    Rule {
        of: &["plot"],
        with: &["--plain"],
        without: &["--sheet"],
        options: &[&["--observer"]],
        why: NO_COLOUR,
    },
    Rule {
        of: &["plot"],
        with: &["--as-in-paper"],
        without: &["--sheet", "--colour-exact"],
        options: &[&["--observer"]],
        why: NO_COLOUR,
    },
    Rule {
        of: &["recover", "picture", "fit", "decode", "gem"],
        without: &["--out"],
        options: &[&["--force"]],
        why: "nothing is written to a file",
        ..ALWAYS
    },
    Rule {
        of: &["follow"],
        without: &["--record", "--tracks"],
        options: &[&["--force"]],
        why: "nothing is written to a file",
        ..ALWAYS
    },
    Rule {
        of: &["product"],
        with: &["--check"],
        options: &[&["--sampling", "--observer"]],
        why: "--check compares spectra and no colours",
        ..ALWAYS
    },
    Rule {
        of: &["light"],
        with: &["--plain"],
        options: &[&["--observer"]],
        why: STANDARD_OBSERVER,
        ..ALWAYS
    },
    Rule {
        of: &["light"],
        with: &["--as-in-paper"],
        without: &["--colour-exact"],
        options: &[&["--observer"]],
        why: STANDARD_OBSERVER,
    },
    Rule {
        of: &["sweep", "auction", "race"],
        options: &[&["--no-spikes", "--wide-lines", "--sampling"]],
        why: CHANGES_NOTHING,
        ..ALWAYS
    },
    Rule {
        of: &["sweep"],
        without: &["--json"],
        options: &[&["--basis", "--colour-exact", "--plain", "--as-in-paper"]],
        why: "the table has every basis and every fit (with --json the map of thresholds has this \
              one)",
        ..ALWAYS
    },
    Rule {
        of: &["auction"],
        options: &[&["--order"]],
        why: CHANGES_NOTHING,
        ..ALWAYS
    },
    Rule {
        of: &["race"],
        options: &[FIT],
        why: CHANGES_NOTHING,
        ..ALWAYS
    },
    Rule {
        of: &["prism"],
        without: &["--json"],
        options: &[FIT],
        why: "where a line lands does not depend on it",
        ..ALWAYS
    },
    Rule {
        of: &["prism"],
        options: &[&["--observer"]],
        why: NO_COLOUR,
        ..ALWAYS
    },
    Rule {
        of: &["rainbow"],
        with: &["INPUT"],
        options: &[FIT, &["--observer"]],
        why: "where a line's bows stand does not depend on it",
        ..ALWAYS
    },
    Rule {
        of: &["rainbow"],
        without: &["INPUT"],
        options: &[FIT, LINES, OTHERS],
        why: "found no INPUT",
        ..ALWAYS
    },
    Rule {
        of: &["gem"],
        with: &["--wavelength"],
        options: &[FIT, LINES, OTHERS],
        why: "--wavelength is no light to model",
        ..ALWAYS
    },
    Rule {
        of: &["gem"],
        without: &["--json"],
        options: &[&["--blocks"]],
        why: "only the JSON tells of blocks",
        ..ALWAYS
    },
    Rule {
        of: &["plot"],
        with: &["--sheet"],
        options: &[&["--size", "--theme"]],
        why: "a sheet is a white page of A4",
        ..ALWAYS
    },
    Rule {
        of: &["mix"],
        without: &["--target", "--front"],
        options: &[&["--favour", "--floor"]],
        why: "found no --target to solve for",
        ..ALWAYS
    },
    Rule {
        of: &["render"],
        with: &["--lesson"],
        options: &[&["INPUT", "--page", "--against"], PICK, FIT, LINES, OTHERS],
        why: "a lesson brings its own light and page",
        ..ALWAYS
    },
];

/// Options that were given and are not used, each with why: the first rule that says so.
pub(super) fn of(matches: &ArgMatches) -> Vec<(&'static str, &'static str)> {
    let Some((command, words)) = given(matches) else {
        return Vec::new();
    };
    let has = |word: &&str| words.contains(*word);
    let holds = |rule: &&Rule| {
        rule.of.contains(&&*command) && rule.with.iter().all(&has) && !rule.without.iter().any(&has)
    };
    let mut unused: Vec<(&str, &str)> = Vec::new();
    for rule in RULES.iter().filter(holds) {
        for word in rule
            .options
            .iter()
            .copied()
            .flatten()
            .filter(|word| has(word))
        {
            if !unused.iter().any(|(other, _)| other == word) {
                unused.push((word, rule.why));
            }
        }
    }
    unused
}

/// Says so.
pub(super) fn say(unused: &[(&str, &str)], inputs: &mut Inputs) {
    for (word, why) in unused {
        inputs.note(format!("{word} is not used: {why}"));
    }
}

/// The command, and what stood on the command line: options, and the names of words without one.
fn given(matches: &ArgMatches) -> Option<(String, BTreeSet<String>)> {
    let (command, matches) = matches.subcommand()?;
    let all = Arguments::command();
    let known = all.find_subcommand(command)?.get_arguments();
    let words = known
        .filter(|known| {
            matches.value_source(known.get_id().as_str()) == Some(ValueSource::CommandLine)
        })
        .filter_map(word_of);
    Some((command.to_owned(), words.collect()))
}

/// An option as it is written, or the name of a word without one.
fn word_of(known: &Arg) -> Option<String> {
    match known.get_long() {
        Some(long) => Some(format!("--{long}")),
        None => known.get_value_names()?.first().map(ToString::to_string),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_rule_is_about_commands_and_options_that_exist() {
        let all = Arguments::command();
        for rule in RULES {
            for name in rule.of {
                let command = all
                    .find_subcommand(name)
                    .unwrap_or_else(|| panic!("{name}"));
                let known: Vec<String> = command.get_arguments().filter_map(word_of).collect();
                let options = rule.options.iter().copied().flatten();
                for word in options.chain(rule.with).chain(rule.without) {
                    assert!(known.iter().any(|known| known == word), "{name} {word}");
                }
            }
        }
    }
}

//! The sentences that pages about products, dark lines, images and the paper begin with: what was
//! found, with its figures.

use super::{
    Lit,
    charts::products::{
        absorption::{DipRow, looks},
        narrow::{Behind, Figures, Filter},
        resampling::Bench,
    },
    numbers::{delta_e, hundredths, or_dash, percent, two_digits},
    opened::ImageEntry,
    picture::WALL_KEY,
    product_report::Told,
    state::App,
    studies::paper::{Row, Verdict},
    ticks::short,
    verdicts::Seen,
};
use crate::{
    languages::{fixed, translated},
    spectrum::Sampling,
    study::products::Passage,
};

/// How many dark lines were found, and how many of them have a name.
pub fn dark_lines(app: &App, dips: &[DipRow]) -> String {
    let name = app.document().subject_entry().name();
    let settings = app.document().settings;
    if !looks(settings) {
        return said!("Switch on \"Look for dark lines\", or choose an example.").to_owned();
    }
    if !app.derived().has_errors() {
        return tr!(
            "{name} is zero over the whole range: there is nothing to miss.",
            name
        );
    }
    let least = short(settings.threshold_percent);
    match dips.len() {
        0 => tr!(
            "{name} has no dark line that takes {least} % of its power or more.",
            name,
            least
        ),
        count => match (count, dips.iter().filter(|dip| dip.name.is_some()).count()) {
            (1, 0) => tr!(
                "The model keeps 1 dark line of {name}, without a name.",
                name
            ),
            (1, _) => tr!("The model keeps 1 dark line of {name}, with a name.", name),
            (_, 0) => tr!(
                "The model keeps {count} dark lines of {name}, none of them named.",
                count,
                name
            ),
            (_, named) if named == count => tr!(
                "The model keeps {count} dark lines of {name}, all of them named.",
                count,
                name
            ),
            (_, named) => tr!(
                "The model keeps {count} dark lines of {name}, {named} of them named.",
                count,
                name,
                named
            ),
        },
    }
}

/// How much of the light passes a chain, and how much of the second one; of one light alone how
/// well one sees what the model is off by, where that is asked.
pub fn chain(
    light: &str,
    told: &Told,
    second: Option<(&str, &Passage)>,
    judges_model: bool,
) -> String {
    let total = told.passage.total();
    let (step, steps) = match told.names.as_slice() {
        [] => return tr!("Put glass or a surface behind {light}: add a step.", light),
        [one] => (Some(one), 1),
        more => (None, more.len()),
    };
    let share = |passage: &Passage| passage.total().transmission[0];
    if let (Some(first), Some((name, other))) = (share(&told.passage), second)
        && let Some(other) = share(other)
    {
        let [first, other] = [first, other].map(percent);
        return match step {
            Some(step) => tr!(
                "{first} % of {light} and {other} % of {name} are left after {step}.",
                first,
                light,
                other,
                name,
                step
            ),
            None => tr!(
                "{first} % of {light} and {other} % of {name} are left after {steps} steps.",
                first,
                light,
                other,
                name,
                steps
            ),
        };
    }
    let passes = total.transmission[0].map_or_else(
        || tr!("{light} is not seen on this range", light),
        |share| {
            let share = percent(share);
            match step {
                Some(step) => tr!(
                    "{share} % of {light} is left after {step}",
                    share,
                    light,
                    step
                ),
                None => tr!(
                    "{share} % of {light} is left after {steps} steps",
                    share,
                    light,
                    steps
                ),
            }
        },
    );
    match total.colours.delta_e_2000.filter(|_| judges_model) {
        Some(off) => tr!(
            "{passes}. The model's colour is off by ΔE₀₀ {off}: {seen}.",
            passes,
            off = hundredths(off),
            seen = Seen::of(off).seen()
        ),
        None => format!("{passes}."),
    }
}

/// What three representations of equal size are off by behind a filter.
pub fn narrow(behind: &Behind, figures: &Figures, filter: &Filter) -> String {
    if !behind.has_colour() {
        return said!("There is no visible light in this range: nothing to see behind a filter.")
            .to_owned();
    }
    let off = |error: f64| match error {
        error if error < 0.01 => delta_e(error),
        error => two_digits(error),
    };
    let [composite, series, samples] = figures.ways.map(|way| or_dash(way.delta_e_2000, off));
    match filter {
        Filter::Gaussian {
            centre_nm,
            width_nm,
        } => tr!(
            "Behind a filter at {centre} nm, {width} nm wide, {n} number as waves and lines are \
             off by ΔE₀₀ {composite}, as waves alone by {series}, as plain samples by {samples}."
                | "Behind a filter at {centre} nm, {width} nm wide, {n} numbers as waves and lines \
                   are off by ΔE₀₀ {composite}, as waves alone by {series}, as plain samples by \
                   {samples}."
                    % behind.numbers(),
            centre = short(*centre_nm),
            width = short(*width_nm),
            composite,
            series,
            samples
        ),
        Filter::Real(entry) => tr!(
            "Behind {filter}, {n} number as waves and lines are off by ΔE₀₀ {composite}, as waves \
             alone by {series}, as plain samples by {samples}."
                | "Behind {filter}, {n} numbers as waves and lines are off by ΔE₀₀ {composite}, as \
                   waves alone by {series}, as plain samples by {samples}."
                    % behind.numbers(),
            filter = entry.name(),
            composite,
            series,
            samples
        ),
    }
}

/// How many surfaces change from one light to the other, and which one most.
pub fn two_lights([first, second]: [&str; 2], lit: Option<&[Lit]>) -> String {
    let Some(lit) = lit else {
        return said!(
            "One of the lights is not seen on this range, so there is no colour to compare."
        )
        .to_owned();
    };
    let most = lit
        .iter()
        .max_by(|a, b| a.delta_e_2000.total_cmp(&b.delta_e_2000));
    let Some(most) = most else {
        return said!("There are no surfaces to compare.").to_owned();
    };
    let seen = |lit: &&Lit| Seen::of(lit.delta_e_2000) >= Seen::Visible;
    let changed = lit.iter().filter(seen).count();
    let (all, most, off) = (lit.len(), &most.name, fixed(most.delta_e_2000, 1));
    match changed {
        0 => tr!(
            "From {first} to {second}, none of {all} surfaces changes visibly, \"{most}\" most \
             (ΔE₀₀ {off}).",
            first,
            second,
            all,
            most,
            off
        ),
        changed if changed == all => tr!(
            "From {first} to {second}, all {all} surfaces change visibly, \"{most}\" most \
             (ΔE₀₀ {off}).",
            first,
            second,
            all,
            most,
            off
        ),
        changed => tr!(
            "From {first} to {second}, {n} of {all} surfaces changes visibly, \"{most}\" most \
             (ΔE₀₀ {off})."
                | "From {first} to {second}, {n} of {all} surfaces change visibly, \"{most}\" most \
                   (ΔE₀₀ {off})."
                    % changed,
            first,
            second,
            all,
            most,
            off
        ),
    }
}

/// A pair that is one colour under a light, and how it parts under another.
pub fn metamers([first, second]: [&str; 2], names: &[String; 2], delta_e_2000: [f64; 2]) -> String {
    let [one, other] = names;
    let [alike, apart] = delta_e_2000;
    let how = |delta| Seen::of(delta).of_two();
    tr!(
        "Under {first}, {one} and {other} {look} (ΔE₀₀ {off}); under {second} they {look_there} \
         ({off_there}).",
        first,
        one,
        other,
        look = how(alike),
        off = fixed(alike, 1),
        second,
        look_there = how(apart),
        off_there = fixed(apart, 1)
    )
}

/// What forming a product on the paper's points adds, beside twice the numbers.
pub fn resampling(bench: &Bench) -> String {
    let of = |sampling: Sampling| {
        let mut ways = bench.resampled.ways.iter();
        let way = ways.find(|way| way.sampling == sampling)?;
        way.step.added
    };
    let (light, factor) = (&bench.light, &bench.factor);
    match (of(Sampling::Paper), of(Sampling::Double)) {
        (Some(paper), Some(double)) => tr!(
            "{light} times {factor}: the paper's points add ΔE₀₀ {paper}, points for twice the \
             numbers {double}.",
            light,
            factor,
            paper = delta_e(paper),
            double = delta_e(double)
        ),
        _ => tr!(
            "{light} times {factor} is not seen on this range: there is no colour.",
            light,
            factor
        ),
    }
}

/// How many of the paper's claims hold.
pub fn paper(subject: &str, rows: &[Row]) -> String {
    let count = |verdict: Verdict| rows.iter().filter(|row| row.verdict == verdict).count();
    let (holds, only, fails, open) = (
        count(Verdict::Holds),
        count(Verdict::OnlyIf),
        count(Verdict::Fails),
        count(Verdict::Open),
    );
    let mut parts = vec![tr!(
        "{n} of the paper's {all} claims holds" | "{n} of the paper's {all} claims hold" % holds,
        all = rows.len()
    )];
    if only > 0 {
        parts.push(tr!(
            "{n} holds only under a condition" | "{n} hold only under a condition" % only
        ));
    }
    if fails > 0 {
        parts.push(tr!("{n} does not hold" | "{n} do not hold" % fails));
    }
    if open > 0 {
        parts.push(tr!(
            "{n} cannot be measured here" | "{n} cannot be measured here" % open
        ));
    }
    tr!(
        "On {subject}, {findings}.",
        subject,
        findings = parts.join(", ")
    )
}

/// What the pixels chosen of an image are.
pub fn image(entry: &ImageEntry, pixels: usize) -> String {
    let cube = &entry.image.cube;
    let chosen = match pixels {
        1 => said!("That of one pixel is shown.").to_owned(),
        all if all == cube.width() * cube.height() => {
            said!("Click one, or drag over some, to see theirs.").to_owned()
        }
        count => tr!("The mean of {count} pixels is shown.", count),
    };
    tr!(
        "{image}: each of its pixels is a spectrum of {n} band. {chosen}"
            | "{image}: each of its pixels is a spectrum of {n} bands. {chosen}" % cube.nm().len(),
        image = match entry.key == WALL_KEY {
            true => translated(&entry.image.name),
            false => &*entry.image.name,
        },
        chosen
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{
        Command, assert_says,
        charts::products::{absorption::dip_rows, chain::ChainSheet},
        products::ModelledLight,
        showing,
        studies::paper::{Claims, truth_table},
    };

    #[test]
    fn dark_lines_are_counted_only_when_they_are_looked_for() {
        let mut app = showing("solar_astm_g173/ASTM G173-03 global tilt AM1.5G");
        assert!(dark_lines(&app, &dip_rows(&app)).starts_with("Switch on"));
        let mut settings = app.document().settings;
        settings.dips = true;
        settings.threshold_percent = 0.1;
        app.apply(Command::Edit(settings));
        let dips = dip_rows(&app);
        assert!(dips.len() > 1);
        let count = format!("{} dark lines", dips.len());
        assert_says(&dark_lines(&app, &dips), &count);
    }

    #[test]
    fn a_chain_says_what_passes_and_whether_the_model_is_seen() {
        let app = App::new();
        let light = ModelledLight::of(&app);
        let chain = &app.document().products.chain;
        assert!(!chain.is_empty());
        let words = super::chain("FL2", &Told::of(&app, &light, chain), None, true);
        assert_says(&words, "% of FL2 is left after");
        assert_says(&words, ": hard to see.");
        let none = super::chain("FL2", &Told::of(&app, &light, &[]), None, true);
        assert_eq!(none, "Put glass or a surface behind FL2: add a step.");
    }

    #[test]
    fn of_two_lights_a_chain_says_how_much_of_each_is_left() {
        let mut app = App::new();
        let lamp = app.entry("cie_illuminants/CIE A").expect("shipped");
        app.apply(Command::Compare(Some(lamp)));
        let sheet = ChainSheet::of(&app);
        let second = sheet.second.as_ref().expect("a second light");
        let words = super::chain("FL2", &sheet.told, Some(("CIE A", second)), true);
        // What the page shows of a light by itself is what it shows of it as the second one.
        let alone = ChainSheet::of(&showing("cie_illuminants/CIE A"));
        let left = |passage: &Passage| percent(passage.total().transmission[0]);
        assert_eq!(left(second), left(&alone.told.passage));
        assert_says(&words, &format!(" and {} % of CIE A", left(second)));
        assert_ne!(left(second), left(&sheet.told.passage));
    }

    #[test]
    fn a_filter_over_a_line_tells_the_composite_ahead_of_the_others() {
        let app = App::new();
        let behind = Behind::of(&app);
        let filter = Filter::Gaussian {
            centre_nm: 546.0,
            width_nm: 10.0,
        };
        let words = narrow(&behind, &behind.figures(&filter), &filter);
        assert!(
            words.starts_with("Behind a filter at 546 nm, 10 nm wide, 23 numbers as waves and"),
            "{words}"
        );
    }

    #[test]
    fn the_claims_that_are_counted_are_all_claims() {
        let claims = Claims::of(&App::new());
        let rows = truth_table(&claims);
        let words = paper(&claims.subject, &rows);
        assert!(words.starts_with("On FL2, "), "{words}");
        let counted: usize = words
            .replace("of the paper's 6", "")
            .split_whitespace()
            .filter_map(|word| word.parse::<usize>().ok())
            .sum();
        assert_eq!(counted, rows.len(), "{words}");
    }
}

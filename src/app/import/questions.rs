//! What was decided about a file, with the other answers.

use super::{Flip, first_rows::MOST_COLUMNS};
use crate::{
    app::{measured::is_sigma_of, opened::Opened, readings::lost_its_sigma},
    io::{
        AxisDecision, Choices, Counted, Decision, Decisions, Delimiter, Guessed, MOST_UNDERSTOOD,
        OpenQuestion, Origin, TableFound, WavelengthUnit, envi,
    },
    languages::{said, with_sign},
    spectrum::{Kind, NamedSpectrum},
};

/// A decision with its other answers.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// What is decided.
    pub what: &'static str,
    /// What it means, in a sentence.
    pub meaning: &'static str,
    /// The answers; one is chosen, but where the file is of a kind that is not offered.
    pub answers: Vec<Answer>,
    /// What spoke for the chosen one.
    pub because: String,
    /// Whether a person should look.
    pub doubtful: bool,
    /// Whether it applies: what does not keeps its place, so that nothing moves when it does.
    pub applies: bool,
}

impl Question {
    /// One that applies and is not doubtful.
    fn new(
        what: &'static str,
        meaning: &'static str,
        answers: Vec<Answer>,
        because: String,
    ) -> Self {
        Self {
            what,
            meaning,
            answers,
            because,
            doubtful: false,
            applies: true,
        }
    }

    /// The same, which a person should perhaps look at.
    fn doubtful(self, doubtful: bool) -> Self {
        Self { doubtful, ..self }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    pub words: String,
    /// What takes the file there.
    pub flip: Flip,
    /// Whether the file was read so.
    pub chosen: bool,
}

/// What tells whether two spectra of a file were understood alike.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Alike {
    pub kind: Kind,
    pub guessed: bool,
    pub by_hand: bool,
    pub doubtful: bool,
}

/// How each spectrum of a file was understood, or each of its images.
pub(super) fn alike(opened: &Opened) -> Vec<Alike> {
    let Choices {
        each, each_image, ..
    } = &opened.choices;
    if !opened.images.is_empty() {
        let images = opened.images.iter().zip(&opened.images_understood);
        return images
            .enumerate()
            .map(|(at, (image, understood))| Alike {
                kind: image.kind,
                guessed: understood.kind.is_guess(),
                by_hand: each_image.contains_key(&at),
                doubtful: understood.is_doubtful(),
            })
            .collect();
    }
    let spectra = opened.spectra.iter().enumerate();
    let mut all: Vec<Alike> = spectra
        .map(|(at, spectrum)| Alike {
            kind: spectrum.kind,
            guessed: false,
            by_hand: each.contains_key(&at),
            doubtful: false,
        })
        .collect();
    for guess in &opened.guesses {
        if let Some(one) = all.get_mut(guess.spectrum) {
            one.guessed |= guess.what == Guessed::Kind;
            one.doubtful |= guess.is_doubtful();
        }
    }
    all
}

/// The questions about a file, or about the spectrum or image at a place of it.
pub(super) fn all(opened: &Opened, alike: Option<&Alike>, at: usize) -> Vec<Question> {
    let all = if !opened.images.is_empty() {
        &opened.images_understood
    } else {
        &opened.understood
    };
    // The questions of one file are the same whatever is asked about.
    let understood = all
        .get(at)
        .or(all.first().filter(|_| at >= MOST_UNDERSTOOD));
    let mut questions = Vec::new();
    if let Some(one) = alike {
        questions.push(kind_question(one, all.get(at), opened, at));
        questions.push(counted_question(
            understood.and_then(|u| u.counted.as_ref()),
            opened.format,
        ));
    }
    match understood.and_then(|u| u.axis.as_ref()) {
        Some(axis @ AxisDecision::Unit(unit)) => {
            let question = Question::new(
                said!("Wavelengths in"),
                said!("The unit of the wavelength axis."),
                answers(WavelengthUnit::ALL, unit.value, Flip::Wavelengths, |unit| {
                    unit.word().to_owned()
                }),
                why(unit),
            );
            questions.push(question.doubtful(axis.is_doubtful()));
        }
        Some(AxisDecision::Laser(laser)) => questions.push(laser_question(laser)),
        None => {}
    }
    if opened.photons {
        questions.push(photon_question(&opened.choices));
    }
    questions.extend(sigma_question(opened));
    if let Some(table) = &opened.table {
        questions.extend(table_questions(table, &opened.choices));
    }
    questions
}

/// What becomes of photon counts.
fn photon_question(choices: &Choices) -> Question {
    let words = |keep| {
        if keep {
            said!("as they are")
        } else {
            said!("turned into power")
        }
        .to_owned()
    };
    Question::new(
        said!("Photons are"),
        said!(
            "Colours and errors are of power: a photon of half the wavelength carries twice as \
             much of it."
        ),
        answers(
            [false, true],
            choices.keep_photons,
            Flip::KeepPhotons,
            words,
        ),
        by_hand_or(choices.keep_photons, said!("the unit counts photons")),
    )
}

/// What a column of deviations of another program is; none where the file has no such column.
fn sigma_question(opened: &Opened) -> Option<Question> {
    let mut pairs = opened.spectra.windows(2);
    let is_foreign = |pair: &[NamedSpectrum]| {
        let [of, beside] = pair else { return false };
        is_sigma_of(&beside.name, &of.name) == Some(false)
    };
    let is_asked = opened.choices.take_sigma
        || opened.spectra.iter().any(lost_its_sigma)
        || pairs.any(is_foreign);
    if !is_asked {
        return None;
    }
    let words = |takes| {
        match takes {
            true => said!("the noise of the one before it"),
            false => said!("no noise"),
        }
        .to_owned()
    };
    let takes = opened.choices.take_sigma;
    Some(Question::new(
        said!("The sd column is"),
        said!(
            "A column called sd, std, sigma, u or error may be the standard deviation of the one \
             before it: the uncertainty of every figure follows from it."
        ),
        answers([false, true], takes, Flip::TakeSigma, words),
        by_hand_or(takes, said!("its title may mean either")),
    ))
}

/// Kinds that are offered.
const KINDS: [Kind; 5] = [
    Kind::Light,
    Kind::Reflectance,
    Kind::Transmittance,
    Kind::Absorbance,
    Kind::Other,
];

fn kind_question(
    one: &Alike,
    understood: Option<&Decisions>,
    opened: &Opened,
    at: usize,
) -> Question {
    let mut guesses = opened.guesses.iter();
    let guess = guesses.find(|guess| guess.what == Guessed::Kind && guess.spectrum == at);
    let because = match (understood, guess) {
        (Some(understood), _) => why(&understood.kind),
        (None, Some(guess)) => guess.because.clone(),
        (None, None) if opened.choices.kind_of(at).is_some() => by_hand(),
        (None, None) => said!("stated by the file").to_owned(),
    };
    let doubtful = match understood {
        Some(understood) => understood.kind.is_doubtful(),
        None => guess.is_some_and(OpenQuestion::is_doubtful),
    };
    let mut kinds = KINDS.to_vec();
    if !kinds.contains(&one.kind) {
        kinds.push(one.kind);
    }
    Question::new(
        said!("Values are"),
        said!(
            "The kind of the values: a light is drawn as a light, a reflectance or transmittance \
             is looked at under one."
        ),
        answers(kinds, one.kind, Flip::Kind, |kind| {
            said(kind.word()).to_owned()
        }),
        because,
    )
    .doubtful(doubtful)
}

fn counted_question(told: Option<&Decision<Counted>>, format: &str) -> Question {
    let is = told.map(|told| told.value);
    let is_stored_large = |counted| is == Some(counted) || format == envi::FORMAT.name;
    let offered = [
        Counted::Percent,
        Counted::Fraction,
        Counted::TenThousandths,
        Counted::SixteenBits,
        Counted::EightBits,
        Counted::Otherwise,
    ]
    .into_iter()
    .filter(|counted| match counted {
        Counted::Percent | Counted::Fraction => true,
        Counted::TenThousandths | Counted::SixteenBits => is_stored_large(*counted),
        Counted::EightBits | Counted::Otherwise => is == Some(*counted),
    });
    Question {
        what: said!("Counted in"),
        meaning: said!(
            "The value, 100, 1 or 10 000, that reflects (or transmits) all of the light; \
                  fractions are taken as they are."
        ),
        answers: offered
            .map(|counted| Answer {
                words: said(counted.word()).to_owned(),
                flip: Flip::Counted(counted),
                chosen: is == Some(counted),
            })
            .collect(),
        because: told.map_or_else(
            || said!("asked of reflectances and transmittances").to_owned(),
            why,
        ),
        doubtful: told.is_some_and(Decision::is_doubtful),
        applies: told.is_some(),
    }
}

/// Lasers of Raman spectrometers that are sold, nm.
const LASERS_NM: [f64; 7] = [405.0, 488.0, 514.5, 532.0, 633.0, 785.0, 1064.0];

fn laser_question(told: &Decision<f64>) -> Question {
    let mut lasers = LASERS_NM.to_vec();
    if !lasers.contains(&told.value) {
        lasers.push(told.value);
        lasers.sort_by(f64::total_cmp);
    }
    Question::new(
        said!("Shifts from"),
        said!("The laser, in nm, from whose line the Raman shifts count."),
        answers(lasers, told.value, Flip::Laser, |nm| {
            format!("{} nm", with_sign(nm.to_string()))
        }),
        why(told),
    )
    .doubtful(told.is_doubtful())
}

/// What spoke for a decision that a person took.
fn by_hand() -> String {
    Decision::chosen(()).reason
}

fn by_hand_or(is_chosen: bool, otherwise: &str) -> String {
    if is_chosen {
        by_hand()
    } else {
        otherwise.to_owned()
    }
}

fn why<T>(decision: &Decision<T>) -> String {
    let reason = &decision.reason;
    match decision.origin {
        Origin::Stated => tr!("stated by the file: {reason}", reason),
        Origin::Chosen | Origin::Evident | Origin::Likely => reason.clone(),
    }
}

fn answers<T: Copy + PartialEq>(
    all: impl IntoIterator<Item = T>,
    chosen: T,
    flip: impl Fn(T) -> Flip,
    words: impl Fn(T) -> String,
) -> Vec<Answer> {
    let answer = |one: T| Answer {
        words: words(one),
        flip: flip(one),
        chosen: one == chosen,
    };
    all.into_iter().map(answer).collect()
}

fn table_questions(table: &TableFound, choices: &Choices) -> Vec<Question> {
    let is_chosen = choices.dialect.is_some();
    let mut questions = Vec::new();
    if let Some(axis) = table.axis_column {
        let columns = (0..table.width).filter(|c| *c < MOST_COLUMNS || *c == axis);
        questions.push(Question::new(
            said!("Wavelength column"),
            said!("The column of the wavelengths."),
            answers(columns, axis, Flip::AxisColumn, |c| (c + 1).to_string()),
            by_hand_or(
                choices.axis_column.is_some(),
                said!("it rises or falls throughout"),
            ),
        ));
    }
    let delimiter = |delimiter| {
        match delimiter {
            Delimiter::Tab => "TAB",
            Delimiter::Semicolon => said!("semicolon ;"),
            Delimiter::Comma => said!("comma ,"),
            Delimiter::Space => said!("blanks"),
            Delimiter::Cell => said!("edges of cells"),
        }
        .to_owned()
    };
    let mark = |comma| {
        if comma {
            said!("decimal comma")
        } else {
            said!("decimal point")
        }
        .to_owned()
    };
    let dialect = &table.dialect;
    questions.extend([
        Question::new(
            said!("Cells between"),
            said!("The sign between two cells of a row."),
            answers(
                Delimiter::ALL,
                dialect.delimiter,
                Flip::Delimiter,
                delimiter,
            ),
            by_hand_or(is_chosen, said!("it makes the most even table")),
        ),
        Question::new(
            said!("Decimal mark"),
            said!("The sign before the decimals of a number."),
            answers(
                [false, true],
                dialect.decimal_comma,
                Flip::DecimalComma,
                mark,
            ),
            by_hand_or(is_chosen, said!("it makes the most numbers")),
        ),
    ]);
    questions
}

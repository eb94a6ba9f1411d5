//! The kind of values, determined from titles, header lines, the file's name, last the values.
//!
//! Titles of columns count most, then lines that state what is on the y axis, then the rest of
//! the header, then the file's name. Whatever is not stated is a guess, and the reading says so.

use crate::io::error::shortened;
use crate::io::reading::decision::Decision;
use crate::io::text::NumberedLines;
use crate::io::text::words::holds_one;
use crate::spectrum::Kind;

/// Words for what repeated measurements differ by.
const SPREAD: &str = "variance;standard deviation;std dev;std. dev;stddev";

/// True if a text names the spread of repeated measurements, not the measured quantity.
pub(crate) fn is_spread(text: &str) -> bool {
    let text = text.to_lowercase();
    holds_one(&text, SPREAD)
}

/// Words for how strongly each of the eye's receptors sees a wavelength: they end alike, and so do
/// "tropic" and "spectroscopic".
const RECEPTORS: &str = "|opic|;|aopic|;cone-opic;coneopic;|melanopic;|rhodopic;|cyanopic;|photopic;|scotopic;\
     |mesopic;|chloropic;|erythropic";

/// Words in a title or a header line, lower case, and the kind they tell, strongest first; a bar
/// asks for the edge of a word ([`crate::io::text::words::holds`]).
static WORDS: [(Kind, &str); 8] = [
    (Kind::Other, SPREAD),
    (Kind::Weighting, RECEPTORS),
    (
        Kind::Weighting,
        "|xbar;|ybar;|zbar;|x_bar;|y_bar;|z_bar;|x-bar;|y-bar;|z-bar;colour-matching;\
         color-matching;colour matching;color matching;|cmf;luminous efficiency;|v(lambda;|v(l);\
         |v(λ;action spectr;cone fundamental;spectral sensitivity;responsivity;\
         quantum efficiency;detection efficiency;collection efficiency;photon-to-current;\
         photon to current;|ipce|;|pde|",
    ),
    (
        Kind::Absorbance,
        "absorban;optical density;extinktion;吸光;흡광;оптическая плотность;поглощен",
    ),
    (
        Kind::Other,
        "refractive;optical constants;extinction coeff;tabulated n;epsilon;absorptivity;\
         absorptance;absorption (%);absorption [%];|k/s|",
    ),
    (
        Kind::Reflectance,
        "reflect;|%r|;|%refl;|%rs|;|%rp|;|r%;|r (%);|r [%];albedo;reflexion;réflect;réflex;\
         riflett;remission;reflekt;reflet;|sci|;|sce|;反射;반사;отраж;відбит;odraz;odbic;yansıma;\
         ανακλασ;ανάκλασ",
    ),
    (
        Kind::Transmittance,
        "transmit;transmis;|%t|;|%trans;|%ts|;|%tp|;|t%;|t (%);|t [%];trasmitt;透射;透过;透過;穿透;투과;\
         пропускан;propustn;przepuszcz;geçirgen;διαπερατ",
    ),
    (
        Kind::Light,
        "irrad;radiance;radiant;w/m;w/(m;w/(c;w m-2;wm-2;w*m-2;bestrahlungsst;strahldichte;\
         strahlungs;éclairement;w/nm;w/cm;/nm;emission;spectral power;power distribution;photon;\
         quanta;µmol;μmol;umol;|ppfd;intensi;辐;輻;放射;光谱强度;излуч;облуч;интенсивн;counts;\
         dark subtracted",
    ),
];

/// Words in a file's name only: too weak for a line of text.
const NAME_WORDS: [(Kind, &str); 5] = [
    (
        Kind::Weighting,
        "^cmf$;^cmfs$;^xyz$;^vlambda$;^vl$;^opic$;^action$;^ciexyz;^linss;^sbrgb;^sensitiv",
    ),
    (
        Kind::Reflectance,
        "^refl$;^reflect;^macbeth;^colorchecker;^colourchecker;^munsell",
    ),
    (Kind::Transmittance, "^filter$;^filters$;^transm"),
    (Kind::Absorbance, "^absorb"),
    (
        Kind::Light,
        "^lamp$;^lamps$;^led$;^leds$;^light$;^lights$;^daylight$;^sunlight$;^skylight$;^moonlight$;\
         ^spd$;^irrad;^radian;^illum;^stdillum;^emission;^halogen",
    ),
];

/// Words at the end of a file's name: `Au.k`, `SiO2_n`.
const LAST_OF_NAME: &str = "^eta$;^k$;^n$";

/// The words of a text, lower case: letters, apart from figures and from the next word's capital.
fn words_of(text: &str) -> Vec<String> {
    let letters: Vec<char> = text.chars().collect();
    let mut words = vec![String::new()];
    for (at, letter) in letters.iter().enumerate() {
        let is_lower = |at: usize| letters.get(at).is_some_and(|c| c.is_lowercase());
        let starts = letter.is_uppercase()
            && (at > 0 && is_lower(at - 1)
                || is_lower(at + 1) && letters[at.saturating_sub(1)].is_uppercase());
        if starts || !letter.is_alphabetic() {
            words.push(String::new());
        }
        if let Some(word) = words.last_mut().filter(|_| letter.is_alphabetic()) {
            word.extend(letter.to_lowercase());
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

/// The kinds that the words of a file's name tell, in their order.
fn kinds_of_name(name: &str) -> Vec<Kind> {
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
    let mut words = words_of(stem);
    let of_stem = words.len();
    // An ending `.spd` is that of reflectances and indices too.
    if !ending.eq_ignore_ascii_case("spd") {
        words.extend(words_of(ending));
    }
    let mut kinds: Vec<Kind> = Vec::new();
    for (at, word) in words.iter().enumerate() {
        let before = || {
            let stem = stem.to_lowercase();
            stem.strip_suffix(word.as_str())
                .unwrap_or_default()
                .to_owned()
        };
        let is_last = at > 0 && at + 1 == of_stem && holds_one(word, LAST_OF_NAME);
        // "4000K" counts kelvin.
        if is_last && !before().ends_with(|c: char| c.is_ascii_digit()) {
            kinds.push(Kind::Other);
            continue;
        }
        let known = NAME_WORDS.iter().find(|(_, words)| holds_one(word, words));
        kinds.extend(known.map(|(kind, _)| *kind));
    }
    if holds_one(&name.to_lowercase(), RECEPTORS) {
        kinds.push(Kind::Weighting);
    }
    if kinds.is_empty() && ending.eq_ignore_ascii_case("spd") {
        kinds.push(Kind::Light);
    }
    kinds
}

/// The kind that a title tells by its words or its one letter (`R`, `T`, `%R`, `n`, `k`).
pub(crate) fn kind_of_title(title: &str) -> Option<Kind> {
    let title = title.trim().to_lowercase();
    if let Some(kind) = kind_of_logarithm(&title) {
        return Some(kind);
    }
    // Beside R and T, in per cent, it is what stays in the sample.
    if holds_one(&title, "^a (%)$;^a [%]$;^a(%)$;^a[%]$;^a%$;^%a$;^a %$") {
        return Some(Kind::Other);
    }
    let stem = title.split(['(', '[', ' ', '_', '.']).next().unwrap_or("");
    // "Rfr" and "Tpc" are the R packages' fractions and per cent.
    kind_of_words(&title).or(match stem {
        "r" | "refl" | "rho" | "rfr" | "rpc" => Some(Kind::Reflectance),
        "t" | "trans" | "tau" | "tfr" | "tpc" => Some(Kind::Transmittance),
        "abs" | "od" => Some(Kind::Absorbance),
        "n" | "k" | "eta" => Some(Kind::Other),
        "qe" => Some(Kind::Weighting),
        "spd" | "power" | "energy" | "irr" | "irrad" | "rad" | "dn" => Some(Kind::Light),
        _ if title.contains("response") => Some(Kind::Weighting),
        _ => None,
    })
}

/// The kind of what a title (lower case) says is no plain measure: decibels, logarithms, and what a
/// surface takes away.
fn kind_of_logarithm(title: &str) -> Option<Kind> {
    const INVERSE: &str = "^log(1/;^log10(1/;^log1/;^-log";
    const LOGS: &str = "|log10|;|log(;|log |;|ln(;|db|;|dbm|";
    const RESTS: &str = "|1-r|;|1-t|;|100-r|;|100-t|;|100-%r|;|100-%t|";
    let bare: String = title.chars().filter(|c| !c.is_whitespace()).collect();
    if holds_one(&bare, INVERSE) {
        Some(Kind::Absorbance)
    } else if holds_one(&bare, RESTS) || holds_one(title, LOGS) {
        Some(Kind::Other)
    } else {
        None
    }
}

pub(crate) fn kind_of_words(line: &str) -> Option<Kind> {
    let line = line.to_lowercase();
    let found = WORDS.iter().find(|(_, words)| holds_one(&line, words));
    found.map(|(kind, _)| *kind)
}

/// The kind that a file's name suggests, by whole words: of several the last, which is what the
/// others tell more of ("filtered lamp", "lamp filter").
pub(crate) fn kind_of_name(name: &str) -> Option<Kind> {
    kinds_of_name(name).last().copied()
}

/// True if the words in a file's name all mean one kind.
pub(crate) fn is_plain_name(name: &str) -> bool {
    let mut kinds = kinds_of_name(name);
    kinds.dedup();
    kinds.len() == 1
}

/// True if a header line states the quantity on the y axis ("Y Units: Reflectance (percent)").
pub(crate) fn states_values(line: &str) -> bool {
    const STARTS: &str = "^y unit;^yunit;^y-unit;^unit;^measurement;^quantity;^technique";
    holds_one(&line.trim().to_lowercase(), STARTS)
}

/// True if a line titles columns of several kinds: it implies nothing about one without a kind. Nor
/// does one that titles weightings beside something else: weightings multiply a light.
pub(super) fn titles_several(line: &str) -> bool {
    let cells = || line.split([';', '\t', ',']).map(str::trim);
    let mut kinds = cells().filter_map(kind_of_words);
    let first = kinds.next();
    let others = || {
        cells()
            .skip(1)
            .any(|cell| !cell.is_empty() && kind_of_words(cell).is_none())
    };
    kinds.any(|kind| Some(kind) != first) || first == Some(Kind::Weighting) && others()
}

fn titles_weighting(cell: &str) -> bool {
    kind_of_words(cell) == Some(Kind::Weighting)
}

/// The kind of a table's values, as stated by the lines above it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct FromHeader {
    /// The kind in this program's own files, under "kind:".
    pub own: Option<Kind>,
    /// The kind that a line tells, and the line.
    telling: Option<(Kind, String)>,
    /// True if there are columns of weightings beside others: the file's name may be theirs.
    beside_weightings: bool,
    /// True if a spectrometer reports that it saw no white panel.
    no_white: bool,
}

impl FromHeader {
    /// Looks through the lines, the nearest to the table first.
    pub(crate) fn of(header: &NumberedLines) -> Self {
        let lines = || header.iter().rev().map(|(_, line)| *line);
        let own = lines().find_map(|line| {
            let word = line.strip_prefix("kind:")?.trim();
            Kind::ALL.into_iter().find(|kind| kind.word() == word)
        });
        let telling = lines()
            .filter(|line| states_values(line))
            .chain(lines().filter(|line| !titles_several(line)))
            .find_map(|line| kind_of_words(line).map(|kind| (kind, short(line))));
        Self {
            own,
            telling,
            beside_weightings: lines().any(|line| {
                titles_several(line) && line.split([';', '\t', ',']).any(titles_weighting)
            }),
            no_white: lines().any(|line| line.contains("not compared to a white reference")),
        }
    }
}

pub(crate) fn kind(title: &str, header: &FromHeader, file: &str, values: &[f64]) -> Decision<Kind> {
    if let Some(kind) = header.own {
        return Decision::stated(kind, said!("the header"));
    }
    if let Some(kind) = kind_of_title(title) {
        let reason = tr!("the column's title \"{title}\"", title = short(title));
        return Decision::stated(kind, reason);
    }
    let guess = |kind, because: &str| Decision::guessed(kind, false, because);
    if holds_one(&title.to_lowercase(), "|%tr|;|%t/r|") {
        let title = short(title);
        let because = tr!(
            "the column's title \"{title}\"; it may be a reflectance",
            title
        );
        return guess(Kind::Transmittance, &because);
    }
    if let Some((kind, line)) = &header.telling {
        return Decision::stated(*kind, tr!("the header line \"{line}\"", line));
    }
    let of_name = kind_of_name(file);
    let is_theirs = header.beside_weightings && of_name == Some(Kind::Weighting);
    if let Some(kind) = of_name.filter(|_| !is_theirs) {
        return Decision::guessed(kind, is_plain_name(file), said!("the file's name"));
    }
    // ASD's spectrometers are mostly held over leaves and soils, beside a white panel.
    let mut sorted: Vec<f64> = Vec::new();
    if title.to_lowercase().trim_end().ends_with(".asd") && !header.no_white {
        sorted.extend(values);
        sorted.sort_by(f64::total_cmp);
    }
    let middle = sorted.get(sorted.len() / 2);
    if middle.is_some_and(|middle| (0.01..=1.5).contains(middle)) {
        return guess(Kind::Reflectance, said!("an ASD's values of about 0..1"));
    }
    if values.iter().all(|v| (-0.05..=1.2).contains(v)) {
        guess(
            Kind::Light,
            said!(
                "nothing states it; all values lie in 0..1, so it may be a reflectance or a \
                 transmittance"
            ),
        )
    } else {
        guess(Kind::Light, said!("nothing states it"))
    }
}

/// The same where values are per cent: what nothing says to be a light is none then, unless its
/// title calls it a relative one or a lamp.
pub(crate) fn no_light_in_percent(
    found: Decision<Kind>,
    is_percent: bool,
    title: &str,
) -> Decision<Kind> {
    let is_relative = holds_one(&title.to_lowercase(), "|rel;|norm");
    let is_lamp = kind_of_name(title) == Some(Kind::Light);
    if !is_percent || !found.is_doubtful() || found.value != Kind::Light || is_relative || is_lamp {
        return found;
    }
    let because = said!("no light is counted in per cent; it may be a transmittance");
    Decision::guessed(Kind::Reflectance, false, because)
}

fn short(text: &str) -> String {
    shortened(text.trim(), 40)
}

//! One word of the command line to a value, or what was found and what was expected.

use std::{
    ffi::OsString,
    fmt::Display,
    net::{Ipv4Addr, SocketAddr},
    ops::RangeInclusive,
    path::{Path, PathBuf},
    str::FromStr,
};

use clap::builder::{OsStringValueParser, TypedValueParser};

use crate::{
    app::{
        chart::Theme,
        own_observers::observer_of_file,
        pages::{Page, SPENDABLE, knob::Knob},
    },
    color::Observer,
    io::{Delimiter, MOST_COLUMNS, WavelengthUnit, quoted},
    languages::Language,
    optics::BuiltinMaterial,
    spectrum::{Band, BandError, Basis, Kind, LONGEST_NM, MOST_STEPS, Rect, SHORTEST_NM, Sampling},
    streams::Pace,
    study::Goal,
};

/// Smallest and largest pictures, px: below, no window has room for its panels; above, a picture
/// takes hundreds of MB while it is made.
pub(super) const SIZES: [[u32; 2]; 2] = [[320, 240], [7680, 4320]];

/// What was found, and what was expected.
pub(super) fn refused(word: &str, expected: impl Display) -> String {
    format!("found {}, expected {expected}", quoted(word))
}

/// `--listen`: a port, or an address with its port.
pub(super) fn address(word: &str) -> Result<SocketAddr, String> {
    let port = word.strip_prefix("localhost").unwrap_or(word);
    let port = port.strip_prefix(':').unwrap_or(port).parse().ok();
    let on_loopback = port.map(|port: u16| SocketAddr::from((Ipv4Addr::LOCALHOST, port)));
    let address = on_loopback.or_else(|| word.parse().ok());
    address.ok_or_else(|| {
        refused(
            word,
            "a port, or an address with one such as 127.0.0.1:5000",
        )
    })
}

/// `--replay`: times its own speed, or step by step.
pub(super) fn pace(word: &str) -> Result<Pace, String> {
    const SPEEDS: RangeInclusive<f64> = 1e-3..=1e6;
    let speed = word.parse().ok().filter(|speed| SPEEDS.contains(speed));
    match (word, speed) {
        ("step", _) => Ok(Pace::Stepped),
        (_, Some(speed)) => Ok(Pace::Times(speed)),
        _ => Err(refused(word, "step or a speed from 0.001 to 1000000")),
    }
}

/// A whole number in a range.
pub(super) fn whole<T: Copy + Display + FromStr + PartialOrd>(
    word: &str,
    range: &RangeInclusive<T>,
) -> Result<T, String> {
    let value = word.parse().ok();
    value.filter(|value| range.contains(value)).ok_or_else(|| {
        let (least, most) = (range.start(), range.end());
        refused(word, format_args!("a whole number from {least} to {most}"))
    })
}

/// `--numbers`.
pub(super) fn numbers(word: &str) -> Result<usize, String> {
    whole(word.trim(), &SPENDABLE)
}

/// `--goal`: a plain goal, or weights such as `patches=2,filters=1`.
pub(super) fn goal(word: &str) -> Result<Goal, String> {
    mixed_goal(word).ok_or_else(|| {
        let expected = "own, patches, spectrum or filters, or weights such as patches=2,filters=1";
        refused(word, expected)
    })
}

fn mixed_goal(word: &str) -> Option<Goal> {
    let plain = |word: &str| {
        Goal::PLAIN
            .iter()
            .position(|(known, _)| *known == word.trim())
    };
    if let Some(place) = plain(word) {
        return Some(Goal::PLAIN[place].1);
    }
    let mut weights = [None; 4];
    for part in word.split(',') {
        let (name, weight) = part.split_once('=')?;
        let place = plain(name)?;
        let weight: f64 = weight.trim().parse().ok()?;
        // A weight that is given twice says two things.
        if !(0.0..=1e6).contains(&weight) || weights[place].is_some() {
            return None;
        }
        weights[place] = Some(weight);
    }
    let [own, patches, spectrum, filters] = weights.map(|weight| weight.unwrap_or(0.0));
    (own + patches + spectrum + filters > 0.0).then_some(Goal {
        own,
        patches,
        spectrum,
        filters,
    })
}

/// `--page`.
pub(super) fn page(word: &str) -> Result<Page, String> {
    let all: Vec<Page> = Page::all().collect();
    Page::of_word(word).map_or_else(|| one_of(word, &all, Page::word), Ok)
}

/// What `--page` is about.
pub(super) fn help_on_pages() -> String {
    let all: Vec<&str> = Page::all().map(Page::word).collect();
    let words = listed(&all);
    format!("The page: {words}; names of earlier versions are known")
}

/// Names in a row: a, b or c.
pub(super) fn listed(names: &[&str]) -> String {
    let (last, others) = names.split_last().unwrap_or((&"nothing", &[]));
    format!("{} or {last}", others.join(", "))
}

/// A whole number that a knob reaches.
pub(super) fn count_of<T>(knob: &Knob<T>, word: &str) -> Result<usize, String> {
    let range = knob.reach.range();
    whole(word, &(*range.start() as usize..=*range.end() as usize))
}

/// A number that a knob reaches.
pub(super) fn value_of<T>(knob: &Knob<T>, word: &str) -> Result<f64, String> {
    number(word, &knob.reach.range(), knob.unit.trim())
}

/// A number in a range.
pub(super) fn number(word: &str, range: &RangeInclusive<f64>, unit: &str) -> Result<f64, String> {
    // NaN is in no range.
    word.parse()
        .ok()
        .filter(|value| range.contains(value))
        .ok_or_else(|| {
            let (least, most) = (range.start(), range.end());
            refused(
                word,
                format_args!("a number from {least} to {most} ({unit})"),
            )
        })
}

/// `--pixel`.
pub(super) fn pixel(word: &str) -> Result<Rect, String> {
    match numbers_with_commas(word).as_deref() {
        Some([x, y]) => Ok(Rect::pixel(*x, *y)),
        _ => Err(refused(word, "X,Y: a column and a row, counted from 0")),
    }
}

/// `--region`.
pub(super) fn region(word: &str) -> Result<Rect, String> {
    match numbers_with_commas(word).as_deref() {
        Some([x, y, width, height]) if *width > 0 && *height > 0 => Ok(Rect {
            x: *x,
            y: *y,
            width: *width,
            height: *height,
        }),
        _ => Err(refused(
            word,
            "X,Y,W,H: first column and row, counted from 0, then width and height, at least 1",
        )),
    }
}

/// Numbers with commas between them; `None` where one is none.
pub(super) fn numbers_with_commas<T: FromStr>(word: &str) -> Option<Vec<T>> {
    word.split(',')
        .map(|part| part.trim().parse().ok())
        .collect()
}

/// `--range`.
pub(super) fn range(word: &str) -> Result<Band, String> {
    let bounds = || {
        let (min, max) = word.split_once(':')?;
        Some((min.trim().parse().ok()?, max.trim().parse().ok()?))
    };
    let Some((min_nm, max_nm)) = bounds() else {
        return Err(refused(word, "MIN:MAX in nm, such as 380:780"));
    };
    Band::new(min_nm, max_nm).map_err(|why| match why {
        BandError::NotWhole { .. } => refused(word, "MIN:MAX in whole nm, not negative"),
        BandError::TooShort { .. } => refused(
            word,
            format_args!("MIN:MAX at least {SHORTEST_NM} nm apart"),
        ),
        BandError::TooLong { .. } => refused(
            word,
            format_args!("MIN:MAX at most {MOST_STEPS} nm apart and up to {LONGEST_NM} nm"),
        ),
    })
}

/// Help of `--material`; `body` is what is made of it.
pub(super) fn material_help(body: &str) -> String {
    let words = BuiltinMaterial::ALL.map(BuiltinMaterial::word).join(", ");
    format!("{body}: {words}, two numbers n_d,V_d or a file of refractiveindex.info (.yml)")
}

/// Help of `--basis`.
pub(super) fn basis_help() -> String {
    let words = listed(&Basis::ALL.map(Basis::word));
    format!("Functions of the smooth part: {words} [default: cosine]")
}

/// `--basis`.
pub(super) fn basis(word: &str) -> Result<Basis, String> {
    one_of(word, &Basis::ALL, Basis::word)
}

/// Words that `--observer` takes.
fn observer_words() -> String {
    let shipped: Vec<&str> = Observer::shipped().map(Observer::word).collect();
    shipped.join(", ")
}

/// Help of `--observer`.
pub(super) fn observer_help() -> String {
    format!(
        "Colour-matching functions: {}, or a file of three functions of wavelength: x, y, z or a \
         camera's red, green, blue [default: 1931]",
        observer_words()
    )
}

/// `--observer`: the word of a shipped one, or a file of three functions.
pub(super) fn observer(word: &str) -> Result<Observer, String> {
    if let Some(shipped) = Observer::from_word(word) {
        return Ok(shipped);
    }
    let path = Path::new(word);
    if path.is_file() {
        return observer_of_file(path);
    }
    let shipped = observer_words();
    let expected = format!("{shipped} or a file of three functions of wavelength");
    Err(refused(word, expected))
}

/// `--sampling`.
pub(super) fn sampling(word: &str) -> Result<Sampling, String> {
    one_of(word, &Sampling::ALL, Sampling::word)
}

/// `--wavelength-unit`: a unit by its sign, as a keyboard has it too.
pub(super) fn wavelength_unit(word: &str) -> Result<WavelengthUnit, String> {
    let sign = match word {
        "A" | "angstrom" => "Å",
        "µm" => "um",
        "cm-1" => "1/cm",
        other => other,
    };
    one_of(sign, &WavelengthUnit::ALL, WavelengthUnit::word)
}

/// `--column`, from 1.
pub(super) fn column(word: &str) -> Result<usize, String> {
    whole(word, &(1..=MOST_COLUMNS))
}

/// `--delimiter`.
pub(super) fn delimiter(word: &str) -> Result<Delimiter, String> {
    one_of(word, &Delimiter::ALL, Delimiter::word)
}

/// `--kind` of an input: what the program can take.
pub(super) fn usable_kind(word: &str) -> Result<Kind, String> {
    let usable = [Kind::Light, Kind::Reflectance, Kind::Transmittance];
    one_of(word, &usable, Kind::word)
}

/// `--kind` of what multiplies a light.
pub(super) fn factor_kind(word: &str) -> Result<Kind, String> {
    one_of(word, &[Kind::Reflectance, Kind::Transmittance], Kind::word)
}

/// `--kind` of a list.
pub(super) fn any_kind(word: &str) -> Result<Kind, String> {
    one_of(word, &Kind::ALL, Kind::word)
}

/// What `convert` writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// Wavelengths and values.
    Spectrum,
    /// The model: coefficients and spikes.
    Composite,
}

/// `--as`.
pub(super) fn form(word: &str) -> Result<Form, String> {
    one_of(
        word,
        &[Form::Composite, Form::Spectrum],
        |form| match form {
            Form::Composite => "composite",
            Form::Spectrum => "spectrum",
        },
    )
}

/// `--theme`.
pub(super) fn theme(word: &str) -> Result<Theme, String> {
    one_of(word, &[Theme::Dark, Theme::Light], |theme| match theme {
        Theme::Dark => "dark",
        Theme::Light => "light",
    })
}

/// `--language`.
pub(super) fn language(code: &str) -> Result<Language, String> {
    one_of(code, &Language::ALL, Language::code)
}

/// One of some values by its word.
pub(super) fn one_of<T: Copy>(
    word: &str,
    all: &[T],
    name: fn(T) -> &'static str,
) -> Result<T, String> {
    let found = all.iter().copied().find(|value| name(*value) == word);
    found.ok_or_else(|| {
        let names: Vec<&str> = all.iter().map(|value| name(*value)).collect();
        refused(word, listed(&names))
    })
}

/// `--size`.
pub(super) fn size(word: &str) -> Result<[u32; 2], String> {
    let [least, most] = SIZES;
    let both = || {
        let (width, height) = word.split_once(['x', 'X', '×'])?;
        Some([width.parse().ok()?, height.parse().ok()?])
    };
    both()
        .filter(|size| (0..2).all(|i| (least[i]..=most[i]).contains(&size[i])))
        .ok_or_else(|| {
            let ([w, h], [wide, high]) = (least, most);
            refused(
                word,
                format_args!("WIDTHxHEIGHT from {w}x{h} to {wide}x{high}"),
            )
        })
}

/// `--out` of a file that ends in one of some ways.
pub(super) fn path_in(known: &'static [&'static str]) -> impl TypedValueParser<Value = PathBuf> {
    OsStringValueParser::new().try_map(move |path| with_extension(path, known))
}

/// `--out` of a plot, or of a sheet instead of it.
pub(super) fn plot_path() -> impl TypedValueParser<Value = PathBuf> {
    OsStringValueParser::new().try_map(|path| {
        with_extension(path, &["svg", "png", "pdf"]).map_err(|why| {
            let (found, _) = why.rsplit_once("a file").unwrap_or((&why, ""));
            format!("{found}a file that ends in .svg or .png, with --sheet in .svg or .pdf")
        })
    })
}

/// A path that ends in one of some ways.
pub(super) fn with_extension(path: OsString, known: &[&str]) -> Result<PathBuf, String> {
    let path = PathBuf::from(path);
    if known.contains(&extension(&path).as_str()) {
        return Ok(path);
    }
    let known: Vec<String> = known.iter().map(|e| format!(".{e}")).collect();
    let expected = format!("a file that ends in {}", known.join(" or "));
    Err(refused(&path.to_string_lossy(), expected))
}

/// The extension of a path in lower case; empty when it has none.
pub(super) fn extension(path: &Path) -> String {
    let extension = path.extension().unwrap_or_default();
    extension.to_string_lossy().to_lowercase()
}

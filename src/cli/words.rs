//! One word of the command line to a value, or what was found and what was expected.

use std::{
    ffi::OsString,
    fmt::Display,
    ops::RangeInclusive,
    path::{Path, PathBuf},
    str::FromStr,
};

use clap::builder::{OsStringValueParser, TypedValueParser};

use crate::{
    app::{
        chart::Theme,
        pages::{Page, SPENDABLE},
        settings::{ORDERS, THRESHOLDS_PERCENT, WIDTHS_NM},
    },
    color::{Observer, Srgb},
    design::{
        recover::Method,
        solve::{Against, Favour},
    },
    io::error::quoted,
    optics::{self, View},
    pictures::ReferenceKind,
    spectrum::{
        Band, Basis, Kind, Rect, Sampling,
        band::{BandError, LONGEST_NM, MOST_STEPS, SHORTEST_NM},
    },
    study::Goal,
};

/// Smallest and largest pictures, px: below, no window has room for its panels; above, a picture
/// takes hundreds of MB while it is made.
pub const SIZES: [[u32; 2]; 2] = [[320, 240], [7680, 4320]];

fn refused(word: &str, expected: impl Display) -> String {
    format!("found {}, expected {expected}", quoted(word))
}

/// `--order`.
pub fn order(word: &str) -> Result<usize, String> {
    let (least, most) = (ORDERS.start(), ORDERS.end());
    word.parse()
        .ok()
        .filter(|order| ORDERS.contains(order))
        .ok_or_else(|| refused(word, format_args!("a whole number from {least} to {most}")))
}

/// `--numbers`.
pub fn numbers(word: &str) -> Result<usize, String> {
    let (least, most) = (SPENDABLE.start(), SPENDABLE.end());
    let word = word.trim();
    word.parse()
        .ok()
        .filter(|numbers| SPENDABLE.contains(numbers))
        .ok_or_else(|| refused(word, format_args!("a whole number from {least} to {most}")))
}

/// `--goal`: a plain goal, or weights such as `patches=2,filters=1`.
pub fn goal(word: &str) -> Result<Goal, String> {
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
pub fn page(word: &str) -> Result<Page, String> {
    let all: Vec<Page> = Page::all().collect();
    Page::of_word(word).map_or_else(|| one_of(word, &all, Page::word), Ok)
}

/// `--threshold`.
pub fn threshold(word: &str) -> Result<f64, String> {
    number(word, &THRESHOLDS_PERCENT, "percent")
}

/// `--max-width`.
pub fn max_width(word: &str) -> Result<f64, String> {
    number(word, &WIDTHS_NM, "nm")
}

fn number(word: &str, range: &RangeInclusive<f64>, unit: &str) -> Result<f64, String> {
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

/// Any number that is finite.
pub fn finite(word: &str) -> Result<f64, String> {
    let value: Option<f64> = word.trim().parse().ok();
    value
        .filter(|value| value.is_finite())
        .ok_or_else(|| refused(word, "a number"))
}

fn whole<T: Copy + Display + FromStr + PartialOrd>(
    word: &str,
    range: &RangeInclusive<T>,
) -> Result<T, String> {
    let value = word.trim().parse().ok();
    value.filter(|value| range.contains(value)).ok_or_else(|| {
        let (least, most) = (range.start(), range.end());
        refused(word, format_args!("a whole number from {least} to {most}"))
    })
}

/// `--size` of a traced picture.
pub fn side(word: &str) -> Result<usize, String> {
    whole(word, &optics::SIZES)
}

/// `--rays`.
pub fn rays(word: &str) -> Result<u32, String> {
    whole(word, &optics::RAYS)
}

/// `--seed`.
pub fn seed(word: &str) -> Result<u64, String> {
    whole(word, &(0..=u64::MAX))
}

/// A count whose limits are told where it is used.
pub fn whole_number(word: &str) -> Result<usize, String> {
    let number = word.trim().parse().ok();
    number.ok_or_else(|| refused(word, "a whole number"))
}

/// `--colour`.
pub fn colour(word: &str) -> Result<Srgb, String> {
    word.parse().map_err(|_| refused(word, "#rrggbb"))
}

/// `--method`.
pub fn method(word: &str) -> Result<Method, String> {
    one_of(word, &Method::ALL, Method::word)
}

/// `--favour`.
pub fn favour(word: &str) -> Result<Favour, String> {
    one_of(word, &Favour::ALL, Favour::word)
}

/// `--front`.
pub fn against(word: &str) -> Result<Against, String> {
    word.parse().map_err(|_| refused(word, "rf,ler or ra,ler"))
}

/// `--lines` of a front.
pub fn free_lines(word: &str) -> Result<usize, String> {
    match word.trim() {
        "3" => Ok(3),
        "4" => Ok(4),
        _ => Err(refused(word, "3 or 4")),
    }
}

/// `--bound`.
pub fn bound(word: &str) -> Result<f64, String> {
    number(word, &(0.01..=20.0), "CIEDE2000")
}

/// `--reference` of a picture.
pub fn reference(word: &str) -> Result<ReferenceKind, String> {
    let all = [
        ReferenceKind::One,
        ReferenceKind::Light,
        ReferenceKind::Mean,
    ];
    one_of(word, &all, reference_word)
}

/// `--reference` of a table.
pub fn fit_reference(word: &str) -> Result<ReferenceKind, String> {
    one_of(
        word,
        &[ReferenceKind::One, ReferenceKind::Mean],
        reference_word,
    )
}

fn reference_word(kind: ReferenceKind) -> &'static str {
    match kind {
        ReferenceKind::One => "one",
        ReferenceKind::Light => "light",
        ReferenceKind::Mean => "mean",
    }
}

/// Which lines of a picture have a number of their own.
#[derive(Clone, Debug, PartialEq)]
pub enum Lines {
    /// Those that are found.
    Auto,
    /// None.
    None,
    /// Those at these places, nm.
    At(Vec<f64>),
}

/// `--lines` of a picture.
pub fn lines(word: &str) -> Result<Lines, String> {
    match word {
        "auto" => Ok(Lines::Auto),
        "none" => Ok(Lines::None),
        _ => {
            let places: Option<Vec<f64>> = word.split(',').map(|n| finite(n).ok()).collect();
            let expected = "auto, none or places in nm with commas";
            places.map(Lines::At).ok_or_else(|| refused(word, expected))
        }
    }
}

/// `--lines` of a table: whether there are any.
pub fn fit_lines(word: &str) -> Result<bool, String> {
    one_of(
        word,
        &[true, false],
        |auto| if auto { "auto" } else { "none" },
    )
}

/// `--blocks`.
pub fn blocks(word: &str) -> Result<usize, String> {
    whole(word, &(1..=*optics::SIZES.end()))
}

/// `--stops`.
pub fn stops(word: &str) -> Result<f64, String> {
    number(word, &(-20.0..=20.0), "stops")
}

/// Three numbers: a place.
pub fn place(word: &str) -> Result<[f64; 3], String> {
    let numbers: Option<Vec<f64>> = word.split(',').map(|n| finite(n).ok()).collect();
    numbers
        .and_then(|numbers| numbers.try_into().ok())
        .ok_or_else(|| refused(word, "X,Y,Z: three numbers"))
}

/// `--view`.
pub fn view(word: &str) -> Result<View, String> {
    match word {
        "A" | "a" => Ok(View::A),
        _ => Err(refused(word, "A (or --from X,Y,Z)")),
    }
}

/// `--pixel`.
pub fn pixel(word: &str) -> Result<Rect, String> {
    match whole_numbers(word).as_deref() {
        Some([x, y]) => Ok(Rect::pixel(*x, *y)),
        _ => Err(refused(word, "X,Y: a column and a row, counted from 0")),
    }
}

/// `--region`.
pub fn region(word: &str) -> Result<Rect, String> {
    match whole_numbers(word).as_deref() {
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

fn whole_numbers(word: &str) -> Option<Vec<usize>> {
    word.split(',')
        .map(|part| part.trim().parse().ok())
        .collect()
}

/// `--range`.
pub fn range(word: &str) -> Result<Band, String> {
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

/// `--basis`.
pub fn basis(word: &str) -> Result<Basis, String> {
    one_of(word, &Basis::ALL, Basis::word)
}

/// `--observer`.
pub fn observer(word: &str) -> Result<Observer, String> {
    one_of(word, &Observer::ALL, Observer::word)
}

/// `--sampling`.
pub fn sampling(word: &str) -> Result<Sampling, String> {
    one_of(word, &Sampling::ALL, Sampling::word)
}

/// `--kind` of an input: what the program can take.
pub fn usable_kind(word: &str) -> Result<Kind, String> {
    let usable = [Kind::Light, Kind::Reflectance, Kind::Transmittance];
    one_of(word, &usable, Kind::word)
}

/// `--kind` of what multiplies a light.
pub fn factor_kind(word: &str) -> Result<Kind, String> {
    one_of(word, &[Kind::Reflectance, Kind::Transmittance], Kind::word)
}

/// `--kind` of a list.
pub fn any_kind(word: &str) -> Result<Kind, String> {
    one_of(word, &Kind::ALL, Kind::word)
}

/// What `convert` writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Wavelengths and values.
    Spectrum,
    /// The model: coefficients and spikes.
    Composite,
}

/// `--as`.
pub fn form(word: &str) -> Result<Form, String> {
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
pub fn theme(word: &str) -> Result<Theme, String> {
    one_of(word, &[Theme::Dark, Theme::Light], |theme| match theme {
        Theme::Dark => "dark",
        Theme::Light => "light",
    })
}

fn one_of<T: Copy>(word: &str, all: &[T], name: fn(T) -> &'static str) -> Result<T, String> {
    let found = all.iter().copied().find(|value| name(*value) == word);
    found.ok_or_else(|| {
        let names: Vec<&str> = all.iter().map(|value| name(*value)).collect();
        let (last, others) = names.split_last().unwrap_or((&"nothing", &[]));
        refused(word, format_args!("{} or {last}", others.join(", ")))
    })
}

/// `--size`.
pub fn size(word: &str) -> Result<[u32; 2], String> {
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

/// `--out` of a picture of the window.
pub fn png_path() -> impl TypedValueParser<Value = PathBuf> {
    OsStringValueParser::new().try_map(|path| with_extension(path, &["png"]))
}

/// `--out` of a traced picture.
pub fn traced_path() -> impl TypedValueParser<Value = PathBuf> {
    OsStringValueParser::new().try_map(|path| with_extension(path, &["png", "exr"]))
}

/// `--out` of a spectral picture.
pub fn exr_path() -> impl TypedValueParser<Value = PathBuf> {
    OsStringValueParser::new().try_map(|path| with_extension(path, &["exr"]))
}

/// `--out` of numbers.
pub fn numbers_path() -> impl TypedValueParser<Value = PathBuf> {
    OsStringValueParser::new().try_map(|path| with_extension(path, &["csv", "json"]))
}

/// `--out` of a plot.
pub fn picture_path() -> impl TypedValueParser<Value = PathBuf> {
    OsStringValueParser::new().try_map(|path| with_extension(path, &["svg", "png"]))
}

fn with_extension(path: OsString, known: &[&str]) -> Result<PathBuf, String> {
    let path = PathBuf::from(path);
    if known.contains(&extension(&path).as_str()) {
        return Ok(path);
    }
    let known: Vec<String> = known.iter().map(|e| format!(".{e}")).collect();
    let expected = format!("a file that ends in {}", known.join(" or "));
    Err(refused(&path.to_string_lossy(), expected))
}

/// The extension of a path in lower case; empty when it has none.
pub fn extension(path: &Path) -> String {
    let extension = path.extension().unwrap_or_default();
    extension.to_string_lossy().to_lowercase()
}

//! The options that several commands share.

use std::ffi::OsString;

use clap::Args;

use super::words;
use crate::{
    app::{
        Settings,
        open::named::{Several, Wanted},
    },
    color::Observer,
    io::{Choices, Delimiter, WavelengthUnit},
    spectrum::{Band, Basis, Kind, Rect, Sampling},
};

/// How the tables of a file are read, where that was guessed wrong.
#[derive(Args, Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct FileOptions {
    /// Unit of a file's wavelength axis: nm, um, A, 1/cm, eV, pm, meV, THz, GHz or m [default: as
    /// the file says].
    #[arg(long, value_name = "UNIT", value_parser = words::wavelength_unit)]
    pub wavelength_unit: Option<WavelengthUnit>,
    /// Column of the wavelengths in a table, from 1 [default: the one that looks like it].
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true, value_parser = words::column)]
    pub column: Option<usize>,
    /// Sign between the cells of a table: tab, semicolon, comma or space [default: what makes the
    /// most even table].
    #[arg(long, value_name = "DELIMITER", value_parser = words::delimiter)]
    pub delimiter: Option<Delimiter>,
}

impl FileOptions {
    /// The options that were given.
    pub(super) fn given(self) -> impl Iterator<Item = &'static str> {
        let Self {
            wavelength_unit,
            column,
            delimiter,
        } = self;
        let all = [
            ("--wavelength-unit", wavelength_unit.is_some()),
            ("--column", column.is_some()),
            ("--delimiter", delimiter.is_some()),
        ];
        all.into_iter().filter(|given| given.1).map(|given| given.0)
    }

    /// The decisions about files that these options are.
    pub(super) fn choices(self) -> Choices {
        Choices {
            wavelengths: self.wavelength_unit,
            axis_column: self.column.map(|column| column - 1),
            delimiter: self.delimiter,
            ..Choices::default()
        }
    }
}

/// Which spectrum is meant, what it is and what shines on it.
#[derive(Args, Clone, Debug, Default)]
pub(super) struct PickOptions {
    /// The spectrum of a file with several, by name or number from 1 [default: the first; of an
    /// image the mean of its pixels].
    #[arg(long, value_name = "NAME|INDEX")]
    pub spectrum: Option<String>,
    /// Kind of the values: light, reflectance or transmittance [default: as the file says].
    #[arg(long, value_name = "KIND", value_parser = words::usable_kind)]
    pub kind: Option<Kind>,
    /// The light on a reflectance or transmittance, a file or a preset [default: CIE D65].
    #[arg(long, value_name = "NAME")]
    pub light: Option<OsString>,
    /// The pixel of a spectral image: its column and row, from 0 [default: the mean of all pixels,
    /// unless --spectrum names one].
    #[arg(long, value_name = "X,Y", value_parser = words::pixel, conflicts_with = "region")]
    pub pixel: Option<Rect>,
    /// The part of a spectral image: first column and row, from 0, width and height; its mean.
    #[arg(long, value_name = "X,Y,W,H", value_parser = words::region)]
    pub region: Option<Rect>,
    #[command(flatten)]
    pub files: FileOptions,
}

impl PickOptions {
    /// Which pixels of an image, if the command line says so.
    pub(super) fn pixels(&self) -> Option<Rect> {
        self.pixel.or(self.region)
    }

    /// The first option that was given and is about the spectra of an input; with `light` also what
    /// shines on them.
    pub(super) fn about_input(&self, light: bool) -> Option<&'static str> {
        let all = [
            ("--spectrum", self.spectrum.is_some()),
            ("--kind", self.kind.is_some()),
            ("--light", light && self.light.is_some()),
            ("--pixel", self.pixel.is_some()),
            ("--region", self.region.is_some()),
        ];
        all.into_iter().find(|given| given.1).map(|given| given.0)
    }

    /// What is meant by an input with these options.
    pub(super) fn wanted(&self) -> Wanted<'_> {
        Wanted {
            spectrum: self.spectrum.as_deref(),
            pixels: self.pixels(),
            choices: Choices {
                kind: self.kind,
                ..Choices::default()
            },
            several: Several::default(),
        }
    }
}

/// The model's knobs; what is not given keeps its default.
#[derive(Args, Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct ModelOptions {
    /// Order of the smooth part, 0 to 100: it takes 2N + 1 numbers [default: 7].
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = |word: &str| words::count_of(&Settings::ORDER, word))]
    pub order: Option<usize>,
    /// Least share of the power that a line must hold to be kept, 0.01 to 50 % [default: 0.5].
    #[arg(long, value_name = "PERCENT", allow_hyphen_values = true,
        value_parser = |word: &str| words::value_of(&Settings::THRESHOLD, word))]
    pub threshold: Option<f64>,
    /// How much stricter the threshold is, 0 to 100 % [default: 0].
    #[arg(long, value_name = "PERCENT", allow_hyphen_values = true,
        value_parser = |word: &str| words::value_of(&Settings::STRICTNESS, word))]
    pub strictness: Option<f64>,
    /// Widest line, full width at half maximum, 1 to 50 nm [default: 10].
    #[arg(long, value_name = "NM", allow_hyphen_values = true,
        value_parser = |word: &str| words::value_of(&Settings::WIDTH, word))]
    pub max_width: Option<f64>,
    #[arg(long, value_name = "BASIS", value_parser = words::basis, help = words::basis_help())]
    pub basis: Option<Basis>,
    /// Keep X, Y and Z of the model exact: the default, except with --as-in-paper.
    #[arg(long)]
    pub colour_exact: bool,
    /// Fit by plain least squares.
    #[arg(long, conflicts_with = "colour_exact")]
    pub plain: bool,
    /// The paper's series: Fourier and plain, unless --basis or --colour-exact says otherwise.
    #[arg(long)]
    pub as_in_paper: bool,
    /// Keep no lines: the waves draw everything.
    #[arg(long)]
    pub no_spikes: bool,
    /// Keep each line as wide as it is; without it lines have no width.
    #[arg(long)]
    pub wide_lines: bool,
    /// Look for absorption lines too.
    #[arg(long)]
    pub dips: bool,
    /// Range of the model in whole nm, at least 20 nm [default: 380:780].
    #[arg(long, value_name = "MIN:MAX", allow_hyphen_values = true, value_parser = words::range)]
    pub range: Option<Band>,
    #[arg(long, value_name = "OBSERVER", value_parser = words::observer,
        help = words::observer_help())]
    pub observer: Option<Observer>,
    /// Way of forming products with reflectances: paper, 3n, 4n, double, convolution or exact; 3n
    /// takes 3N+1 points, for an odd order N 3N+2 [default: exact].
    #[arg(long, value_name = "POINTS", value_parser = words::sampling)]
    pub sampling: Option<Sampling>,
}

impl ModelOptions {
    /// Whether any of them was given.
    pub(super) fn is_given(&self) -> bool {
        *self != Self::default()
    }

    /// Takes an option back that is not used, so that it changes nothing indeed; words that are no
    /// option of the model are left alone.
    pub(super) fn forget(&mut self, option: &str) {
        match option {
            "--order" => self.order = None,
            "--threshold" => self.threshold = None,
            "--strictness" => self.strictness = None,
            "--max-width" => self.max_width = None,
            "--basis" => self.basis = None,
            "--colour-exact" => self.colour_exact = false,
            "--plain" => self.plain = false,
            "--as-in-paper" => self.as_in_paper = false,
            "--no-spikes" => self.no_spikes = false,
            "--wide-lines" => self.wide_lines = false,
            "--dips" => self.dips = false,
            "--range" => self.range = None,
            "--observer" => self.observer = None,
            "--sampling" => self.sampling = None,
            _ => {}
        }
    }

    /// These options over the program's own settings, which the window starts with too.
    pub(super) fn settings(self) -> Settings {
        self.over(Settings::default())
    }

    /// These options over other settings.
    pub(super) fn over(self, settings: Settings) -> Settings {
        let Self {
            order,
            threshold,
            max_width,
            strictness,
            basis,
            colour_exact,
            plain,
            as_in_paper,
            no_spikes,
            wide_lines,
            dips,
            range,
            observer,
            sampling,
        } = self;
        let settings = match as_in_paper {
            true => settings.as_in_paper(),
            false => settings,
        };
        Settings {
            basis: basis.unwrap_or(settings.basis),
            order: order.unwrap_or(settings.order),
            spikes: settings.spikes && !no_spikes,
            wide_lines: settings.wide_lines || wide_lines,
            threshold_percent: threshold.unwrap_or(settings.threshold_percent),
            strictness_percent: strictness.unwrap_or(settings.strictness_percent),
            max_width_nm: max_width.unwrap_or(settings.max_width_nm),
            dips: settings.dips || dips,
            detector: settings.detector,
            gradient_percent: settings.gradient_percent,
            colour_exact: settings.colour_exact && !plain || colour_exact,
            band: range.unwrap_or(settings.band),
            observer: observer.unwrap_or(settings.observer),
            sampling: sampling.unwrap_or(settings.sampling),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::App;

    #[test]
    fn no_options_are_what_the_window_starts_with_and_the_papers_series_is_one_option() {
        let none = ModelOptions::default();
        assert!(!none.is_given());
        let fresh = App::new().document().settings;
        assert_eq!(none.settings(), fresh);
        let paper = ModelOptions {
            as_in_paper: true,
            ..none
        };
        assert_eq!(paper.settings(), Settings::plain());
        let exact = ModelOptions {
            colour_exact: true,
            basis: Some(Basis::Cosine),
            ..paper
        };
        assert_eq!(exact.settings(), fresh);
    }
}

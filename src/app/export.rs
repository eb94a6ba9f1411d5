//! What can be taken out of the program, each with units, scale, provenance and version.

use super::{
    cells::{self, Table, cell, comments},
    chart::Theme,
    charts::{order::curve_chart, spectrum::spectrum_chart},
    derived::{OF_CURVE, OrderPoint, PatchPair},
    line_names::LineName,
    measured::{has_doubt, lost_of_measurement, measurement_as},
    settings::Detector,
    sheet,
    state::App,
    workspace,
};
use crate::{
    io::{
        Column, Columns, CompositeFile, Provenance, composite_json, composite_line, encode, losses,
        many::many,
    },
    languages::{Language, in_language, said},
    measurements::Measurement,
    spectrum::{ModelSpike, NamedSpectrum, Sampled},
};

/// A text that can be saved or copied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Export {
    /// The composite as JSON, bit-exact.
    CompositeJson,
    /// The composite in one line, to paste into a message.
    CompositeLine,
    /// Measured, model, smooth part, spikes and residual on the 1 nm grid.
    Csv,
    /// The reconstruction as pairs for pbrt and Mitsuba.
    Spd,
    /// The measured spectrum as IES TM-27.
    Spdx,
    /// The measured spectrum as Argyll `.sp`.
    ArgyllSp,
    /// The measured spectrum as our JSON.
    SpectrumJson,
    /// The patches' colours and errors.
    PatchesCsv,
    SpikesCsv,
    /// The error against the order.
    CurveCsv,
    PlotSvg,
    /// The error against the order as SVG.
    CurveSvg,
    /// One page about the light as SVG.
    SheetSvg,
    /// Everything, to open again.
    Project,
}

impl Export {
    /// Everything that the menu offers to save as text, in its order.
    pub const ALL: [Self; 14] = [
        Self::CompositeJson,
        Self::CompositeLine,
        Self::Csv,
        Self::Spd,
        Self::Spdx,
        Self::ArgyllSp,
        Self::SpectrumJson,
        Self::PatchesCsv,
        Self::SpikesCsv,
        Self::CurveCsv,
        Self::PlotSvg,
        Self::CurveSvg,
        Self::SheetSvg,
        Self::Project,
    ];

    /// What the menu calls it, what stands behind the spectrum's name in its file's, and the
    /// extension of that.
    fn row(self) -> [&'static str; 3] {
        match self {
            Self::CompositeJson => [later!("Composite (JSON)"), "-composite", "json"],
            Self::CompositeLine => [later!("Composite (one line)"), "-composite", "txt"],
            Self::Csv => [later!("Spectrum and model (CSV)"), "-model", "csv"],
            Self::Spd => [later!("Reconstruction (.spd)"), "-reconstruction", "spd"],
            Self::Spdx => [later!("Measured spectrum (.spdx)"), "", "spdx"],
            Self::ArgyllSp => [later!("Measured spectrum (Argyll .sp)"), "", "sp"],
            Self::SpectrumJson => [later!("Measured spectrum (JSON)"), "", "json"],
            Self::PatchesCsv => [later!("Surfaces (CSV)"), "-patches", "csv"],
            Self::SpikesCsv => [later!("Lines (CSV)"), "-spikes", "csv"],
            Self::CurveCsv => [
                later!("Error against waves (CSV)"),
                "-error-against-order",
                "csv",
            ],
            Self::PlotSvg => [later!("Plot (SVG)"), "", "svg"],
            Self::CurveSvg => [
                later!("Error against waves (SVG)"),
                "-error-against-order",
                "svg",
            ],
            Self::SheetSvg => [later!("Sheet about the light (SVG)"), "-sheet", "svg"],
            Self::Project => [later!("Project"), "-project", "json"],
        }
    }

    /// What the menu calls it.
    pub fn title(self) -> &'static str {
        said(self.row()[0])
    }

    /// The extension of its file.
    pub fn extension(self) -> &'static str {
        self.row()[2]
    }

    /// A name for the file: the spectrum's, with what the file holds.
    pub fn suggested_name(self, app: &App) -> String {
        let [_, part, extension] = self.row();
        format!("{}{part}.{extension}", file_stem(app))
    }

    /// What its format does not keep, a sentence each.
    pub fn losses(self, app: &App) -> Vec<String> {
        match self {
            Self::Spdx | Self::ArgyllSp => {
                let mut all = losses(self.extension(), &scaled_subject(app));
                let measured = scaled_measurement(app);
                all.extend(measured.and_then(|of| lost_of_measurement(self.extension(), &of)));
                all
            }
            _ => Vec::new(),
        }
    }

    /// The text itself. `theme` only matters for pictures, which speak as the window does; programs
    /// read English.
    ///
    /// # Errors
    /// One line when the result holds a number that the format cannot.
    pub fn text(self, app: &App, theme: Theme) -> Result<String, String> {
        let make = || self.made(app, theme);
        match self {
            Self::PlotSvg | Self::CurveSvg | Self::SheetSvg => make(),
            _ => in_language(Language::English, make),
        }
    }

    fn made(self, app: &App, theme: Theme) -> Result<String, String> {
        let (document, derived) = (app.document(), app.derived());
        match self {
            Self::CompositeJson => composite_json(&composite_file(app)).map_err(|e| e.to_string()),
            Self::CompositeLine => Ok(composite_line(&derived.model) + "\n"),
            Self::Csv => {
                let scaled = scaled_subject(app);
                encode("csv", &scaled, &columns(app), &provenance(app)).map(cells::as_chosen)
            }
            Self::Spd => {
                let model = reconstruction(app)?;
                encode("spd", &model, &Columns::measured(&model), &provenance(app))
            }
            Self::Spdx | Self::ArgyllSp | Self::SpectrumJson => {
                let scaled = scaled_subject(app);
                let columns = Columns::measured(&scaled);
                let doubted = scaled_measurement(app)
                    .and_then(|of| measurement_as(self.extension(), &of, &scaled.source));
                doubted.unwrap_or_else(|| {
                    encode(self.extension(), &scaled, &columns, &provenance(app))
                })
            }
            Self::PatchesCsv => Ok(patches_table(app).csv()),
            Self::SpikesCsv => Ok(spikes_table(app).csv()),
            Self::CurveCsv => Ok(curve_table(app).csv()),
            Self::PlotSvg => Ok(spectrum_chart(app).to_svg(1000, 640, theme)),
            Self::CurveSvg => Ok(curve_chart(app).to_svg(1000, 560, theme)),
            Self::SheetSvg => Ok(sheet::to_svg(app)),
            Self::Project => workspace::to_json(document, None),
        }
    }
}

/// The spectrum's name as a file name: letters, digits, `-`, `_` and `.` only.
pub fn file_stem(app: &App) -> String {
    stem_of(app.document().subject_entry().name(), "spectrum")
}

/// A text as a file name: letters, digits, `-`, `_` and `.` only; `otherwise` when none is left.
pub fn stem_of(text: &str, otherwise: &str) -> String {
    let sign = |c: char| {
        if c.is_alphanumeric() || ['-', '_', '.'].contains(&c) {
            c
        } else {
            '-'
        }
    };
    let name: String = text.chars().map(sign).collect();
    let words: Vec<&str> = name.split('-').filter(|word| !word.is_empty()).collect();
    let name = words.join("-");
    let name = name.trim_matches(['-', '.']);
    if name.is_empty() {
        otherwise.to_owned()
    } else {
        name.to_owned()
    }
}

/// The model as it stands, in the file's own unit whatever the scale.
pub fn composite_file(app: &App) -> CompositeFile {
    let spectrum = &app.document().subject_entry().spectrum;
    CompositeFile {
        composite: app.derived().model.clone(),
        unit: spectrum.unit.clone(),
        source: spectrum.source.clone(),
        name: spectrum.name.clone(),
        kind: spectrum.kind,
    }
}

/// What every export says about itself.
pub fn provenance(app: &App) -> Provenance {
    let document = app.document();
    let settings = document.settings;
    Provenance {
        program: format!("Spectral Explorer {}", env!("CARGO_PKG_VERSION")),
        source: document.subject_entry().spectrum.source.clone(),
        scale_words: document.scale.words().to_owned(),
        settings: format!(
            "{} order {}, {}{}{}{}, {}-{} nm, {}",
            settings.basis.word(),
            settings.effective_order(),
            many(app.derived().model.lines().len(), "line", "lines"),
            match (settings.spikes, settings.detector) {
                (false, _) => String::new(),
                (true, Detector::Energy) => format!(
                    " (threshold {} %, width {} nm{})",
                    settings.threshold_percent,
                    settings.max_width_nm,
                    if settings.dips { ", dips too" } else { "" }
                ),
                (true, Detector::Gradient) => format!(
                    " (by gradient, {} % per nm, width {} nm)",
                    settings.gradient_percent, settings.max_width_nm
                ),
            },
            if document.subject_edits().is_empty() {
                ""
            } else {
                ", edited by hand"
            },
            if settings.colour_exact {
                ", colour-exact"
            } else {
                ""
            },
            settings.band.min_nm(),
            settings.band.max_nm(),
            settings.observer.title(),
        ),
    }
}

/// The subject with the scale in force.
fn scaled_subject(app: &App) -> NamedSpectrum {
    let spectrum = &app.document().subject_entry().spectrum;
    NamedSpectrum {
        samples: spectrum.samples.scaled(app.scale_factor()),
        unit: app.unit().to_owned(),
        ..spectrum.clone()
    }
}

/// The subject with its doubt, with the scale in force; `None` where no doubt is known.
fn scaled_measurement(app: &App) -> Option<Measurement> {
    let of = app.document().subject_entry().measured.as_deref()?;
    let by = app.scale_factor();
    let scaled = |sigma: &Vec<f64>| sigma.iter().map(|s| by * s).collect();
    has_doubt(of).then(|| Measurement {
        unit: app.unit().to_owned(),
        samples: of.samples.scaled(by),
        sigma: of.sigma.as_ref().map(scaled),
        ..of.clone()
    })
}

/// The model as a spectrum on the 1 nm grid, spikes split over their neighbouring nm, with the
/// scale in force.
fn reconstruction(app: &App) -> Result<NamedSpectrum, String> {
    let derived = app.derived();
    let samples = Sampled::even(derived.band.min_nm(), 1.0, derived.model_values())
        .map_err(|e| e.to_string())?
        .scaled(app.scale_factor());
    let subject = scaled_subject(app);
    Ok(NamedSpectrum {
        name: format!("{} (composite model)", subject.name),
        samples,
        ..subject
    })
}

fn columns(app: &App) -> Columns {
    let derived = app.derived();
    let factor = app.scale_factor();
    let column = |title: &str, values: &[f64]| Column {
        title: title.to_owned(),
        values: values.iter().map(|v| v * factor).collect(),
    };
    let model = derived.model_values();
    let spikes = model.iter().zip(&derived.smooth).map(|(m, s)| m - s);
    Columns {
        nm: derived.band.grid().collect(),
        columns: vec![
            column("measured", &derived.measured),
            column("model", &model),
            column("smooth", &derived.smooth),
            column("spikes", &spikes.collect::<Vec<_>>()),
            column("residual", &derived.residual),
        ],
    }
}

/// Comment lines that begin every table.
pub(super) fn table_head(app: &App) -> String {
    comments(&provenance(app), &app.document().subject_entry().spectrum)
}

/// The patches as a table: names, CIEDE2000, XYZ (Y of the light 100) and screen colours.
fn patches_table(app: &App) -> Table {
    let mut columns = cells::Columns::<&PatchPair>::default()
        .with("patch", |p| cell(p.name.as_str()))
        .with("delta_e_2000", |p| cell(p.delta_e_2000));
    for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
        columns.push(format!("exact_{axis}"), move |p| {
            cell(p.exact.to_array()[i])
        });
    }
    for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
        columns.push(format!("model_{axis}"), move |p| {
            cell(p.model.to_array()[i])
        });
    }
    columns.push("exact_srgb", |p| cell(p.exact_swatch.hex()));
    columns.push("model_srgb", |p| cell(p.model_swatch.hex()));
    let patches = app.derived().patches.as_ref();
    let patches = patches.map(|p| &p.items[..]).unwrap_or_default();
    Table::new(table_head(app), columns, patches)
}

/// The spikes as a table, weights with the scale in force.
fn spikes_table(app: &App) -> Table {
    let derived = app.derived();
    let factor = app.scale_factor();
    let columns = cells::Columns::<(&ModelSpike, &LineName)>::default()
        .with("at_nm", |(s, _)| cell(s.spike.at_nm))
        .with("weight", |(s, _)| cell(s.spike.weight * factor))
        .with("share_of_power", |(s, _)| {
            cell(derived.parts.share(s.spike.weight))
        })
        .with("width_nm", |(s, _)| cell(s.width_nm))
        .with("line", |(_, name)| cell(name.safe.as_deref()))
        .with("by_hand", |(s, _)| cell(s.hand.is_some()));
    let rows = derived.parts.spikes.iter().zip(app.spike_names());
    Table::new(table_head(app), columns, rows)
}

/// The whole order curve as a table.
fn curve_table(app: &App) -> Table {
    let mut columns = cells::Columns::<&OrderPoint>::default()
        .with("order", |p| cell(p.order))
        .with("numbers", |p| cell(p.numbers));
    for measure in OF_CURVE {
        let figure = move |p: &&OrderPoint| cell(p.figures[measure]);
        columns.push(measure.figure().key, figure);
    }
    Table::new(table_head(app), columns, &app.derived().curve)
}

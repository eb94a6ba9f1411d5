//! Surfaces ranked by how well they explain a spectrum: the search, and its table.

use std::sync::Arc;

use crate::{
    app::{
        cells::{Columns, Table, cell, column},
        entry::Entry,
        memo::ByAddress,
        numbers::hundredths,
        studies::{Question, surfaces},
    },
    color::{Adaptation, Observer, Swatch, xyz_of_parts},
    languages::said,
    spectrum::{Band, Composite},
    study::{
        Progress,
        products::{Checker, Reflection, Sameness, measured_check},
    },
};

/// What the ranking of surfaces is asked of.
#[derive(Clone, Debug, PartialEq)]
pub struct RankAsk {
    /// The light and what came from the surface, as measured.
    pub measured: [ByAddress<Entry>; 2],
    /// The same in the model's numbers.
    pub models: Arc<[Composite; 2]>,
    /// What the two models leave out themselves, as [`Sameness::of`] takes it.
    pub left_out: f64,
    /// The range.
    pub band: Band,
    /// Whose colour-matching functions, for the swatches.
    pub observer: Observer,
    /// The group that is searched; `None` for all shipped reflectances.
    pub group: Option<String>,
}

/// A surface and how well it explains the outgoing spectrum.
#[derive(Clone, Debug, PartialEq)]
pub struct Ranked {
    /// What finds it again: `group/name`.
    pub key: String,
    pub name: String,
    /// Its colour under the light.
    pub swatch: Swatch,
    /// The check in the model's numbers.
    pub model: Option<Reflection>,
    pub verdict: Sameness,
    /// The check on measured curves.
    pub measured: Option<Reflection>,
}

impl Question for RankAsk {
    type Answer = Vec<Ranked>;

    /// Every surface, the smallest residual of the model first; `None` when one of the spectra is
    /// dark or it was cancelled.
    fn answer(&self, progress: &Progress) -> Option<Vec<Ranked>> {
        let band = self.band;
        let surfaces = surfaces(self.group.as_deref(), band);
        progress.expect(surfaces.len());
        let [light, outgoing] = &*self.models;
        let checker = Checker::new(light, outgoing);
        let [light, outgoing] = [0, 1].map(|i| self.measured[i].0.on_band(band));
        let seen = self.observer.table().on_band(band);
        let weigh = |values: &[f64]| xyz_of_parts(band, values, &[], &seen);
        let white = weigh(&light);
        let mut ranked = Vec::with_capacity(surfaces.len());
        for surface in surfaces {
            if progress.is_cancelled() {
                return None;
            }
            let lit: Vec<f64> = light
                .iter()
                .zip(&surface.values)
                .map(|(l, r)| l * r)
                .collect();
            let measured = measured_check(band, &light, &surface.values, &outgoing);
            let model = checker.against(&surface.values).map(|c| c.reflection);
            ranked.push(Ranked {
                swatch: Swatch::of_patch(weigh(&lit), white, Adaptation::None),
                verdict: Sameness::of(model, self.left_out),
                model,
                measured: measured.map(|c| c.reflection),
                key: surface.key,
                name: surface.name,
            });
            progress.step();
        }
        if ranked.iter().all(|r| r.model.is_none()) {
            return None;
        }
        // A light turned negative explains nothing.
        let residual = |r: &Ranked| match r.model {
            Some(model) if model.factor > 0.0 => model.residual,
            _ => f64::INFINITY,
        };
        ranked.sort_by(|a, b| residual(a).total_cmp(&residual(b)));
        Some(ranked)
    }
}

/// The ranking as a table.
pub fn ranking(names: &[String; 3], ranked: &[Ranked]) -> Table {
    type Row<'a> = &'a Ranked;
    let found = |key: &'static str, of: fn(&Ranked) -> Option<f64>| {
        column(key, move |r: &Row<'_>| cell(of(r)).shown(hundredths(of(r))))
    };
    let columns = Columns::<Row<'_>>::default()
        .with("surface", |r: &Row<'_>| {
            cell(r.key.as_str()).shown(r.name.as_str())
        })
        .titled(
            said!("surface"),
            said!("Click a row to take it as the surface S2."),
        )
        .and(found("residual model", |r| Some(r.model?.residual)))
        .titled(
            said!("residual"),
            tr!(
                "In the model's numbers. {meaning}",
                meaning = said(RESIDUAL_MEANS)
            ),
        )
        .and(found("factor model", |r| Some(r.model?.factor)))
        .with("verdict", |r| cell(r.verdict.words()))
        .and(found("residual measured", |r| Some(r.measured?.residual)))
        .titled(
            said!("measured"),
            tr!(
                "Of the measured curves. {meaning}",
                meaning = said(RESIDUAL_MEANS)
            ),
        )
        .and(found("factor measured", |r| Some(r.measured?.factor)))
        .with("", |r| {
            cell(format!("{} {}", r.verdict.sign(), said(r.verdict.told())))
        })
        .titled(said!("verdict"), said!("The model's verdict."));
    let comments = format!("# {} as {} off each surface\n", names[2], names[0]);
    Table::new(comments, columns, ranked)
}

/// The meaning of a residual.
pub const RESIDUAL_MEANS: &str = later!(
    "Root mean square of the rest beside the best multiple, over that \
                                  of the outgoing spectrum, both behind a 10 nm blur; 0 is a \
                                  perfect match."
);

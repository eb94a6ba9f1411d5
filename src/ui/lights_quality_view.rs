//! How good many lights are: a table over the page, sorted by the figure that is clicked.

use eframe::egui;
use egui::{Context, Key, Modifiers, Ui, vec2};

use super::{
    kit::{Column, Row, Table, headline, pressed},
    pages::progress,
    theme::{Theme, Wake},
};
use crate::app::{
    App, ByAddress, Memo,
    studies::{
        LightsQualityAsk, Studies,
        lights_quality::{LightQuality, csv, sentence},
    },
};

/// What a hand asked for.
pub(super) enum Wish {
    /// The light of this key is to be shown.
    Show(String),
    Say(String),
}

/// The window, open where lights were asked about.
#[derive(Default)]
pub(super) struct LightsQualityView {
    keys: Vec<String>,
    /// The column by which rows are sorted.
    by: usize,
    asked: Memo<(u64, Vec<String>), LightsQualityAsk>,
    shown: Memo<(ByAddress<Vec<LightQuality>>, usize), Shown>,
}

/// The sentence, the rows, and each row's light.
type Shown = (String, Vec<Row>, Vec<usize>);

/// The column of Rf.
const RF: usize = 2;

impl LightsQualityView {
    /// Opens it on the lights of these keys.
    pub(super) fn open(&mut self, keys: Vec<String>) {
        self.keys = keys;
        self.by = RF;
    }

    /// Draws the window if it is open.
    pub(super) fn window(
        &mut self,
        context: &Context,
        (app, studies, wake): (&App, &mut Studies, &Wake),
        theme: Theme,
        keys_are_free: bool,
    ) -> Option<Wish> {
        if self.keys.is_empty() {
            return None;
        }
        let (mut open, mut wish) = (true, None);
        let room = context.content_rect().size();
        let size = vec2(760.0, 0.7 * room.y).min(room - vec2(40.0, 80.0));
        egui::Window::new(said!("Quality of these lights"))
            .open(&mut open)
            .collapsible(false)
            .default_pos(((room - size) / 2.0).to_pos2())
            .default_size(size)
            .min_size(vec2(420.0, 200.0))
            .show(context, |ui| {
                wish = self.content(ui, (app, studies, wake), theme);
            });
        let escaped =
            keys_are_free && context.input_mut(|i| i.consume_key(Modifiers::NONE, Key::Escape));
        if !open || escaped {
            self.keys.clear();
        }
        wish
    }

    fn content(
        &mut self,
        ui: &mut Ui,
        (app, studies, wake): (&App, &mut Studies, &Wake),
        theme: Theme,
    ) -> Option<Wish> {
        let key = (app.revision(), self.keys.clone());
        let make = |(_, keys): &(u64, Vec<String>)| LightsQualityAsk::of(app, keys);
        let ask = self.asked.get(key, make);
        let job = studies.of::<LightsQualityAsk>();
        job.put(ask, wake);
        progress(ui, job, said!("Light quality"));
        let found = job.result()?.clone();
        let key = (ByAddress(found.clone()), self.by);
        let (said, rows, order) = &*self.shown.get(key, |(found, by)| {
            let order = sorted(&found.0, *by);
            let rows = order.iter().map(|place| row(&found.0[*place])).collect();
            (sentence(&found.0), rows, order)
        });
        headline(ui, theme, said.as_str());
        let mut wish = None;
        if pressed(
            ui,
            said!("Copy as CSV"),
            said!("Every light with its figures."),
        ) {
            ui.ctx().copy_text(csv(&found));
            wish = Some(Wish::Say(
                said!("Copied as CSV: quality of these lights.").to_owned(),
            ));
        }
        ui.add_space(4.0);
        let mut columns = [
            Column::words(said!("Light"), said!("Click a light to show it."), 3.0),
            Column::words(said!("White"), said!("Colour temperature and tint."), 2.4),
            Column::numbers("Rf", said!("Colour fidelity of TM-30, 100 at best."), 0.8),
            Column::numbers(
                "Ra",
                said!("Colour rendering of CIE 13.3, 100 at best."),
                0.8,
            ),
            Column::numbers("R9", said!("Rendering of a strong red, 100 at best."), 0.8),
            Column::numbers("lm/W", said!("Lumens per watt of radiation."), 0.8),
        ];
        columns[self.by].decides = true;
        let table = Table {
            titles: false,
            ..Table::new(&columns, theme)
        };
        let sorted_by = table.sorting_head(ui);
        let id = "quality of many lights";
        let clicked = table.scrolled(ui, id, f32::INFINITY, rows, &mut |_, _, _| {});
        let clicked = clicked.and_then(|row| found.get(*order.get(row)?));
        self.by = sorted_by.unwrap_or(self.by);
        clicked.map(|light| Wish::Show(light.key.clone())).or(wish)
    }
}

/// The places of lights by a column: names by the alphabet, whites from warm to cool, figures from
/// the highest.
fn sorted(all: &[LightQuality], by: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..all.len()).collect();
    let figure = |light: &LightQuality| match by {
        1 => light.kelvin.map(|kelvin| -kelvin),
        2 => light.rf,
        3 => light.ra,
        4 => light.r9,
        _ => light.efficacy,
    };
    let height = |place: &usize| figure(&all[*place]).unwrap_or(f64::NEG_INFINITY);
    match by {
        0 => order.sort_by_key(|place| all[*place].name.to_lowercase()),
        _ => order.sort_by(|a, b| height(b).total_cmp(&height(a))),
    }
    order
}

fn row(light: &LightQuality) -> Row {
    let number = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |v| format!("{v:.0}"));
    Row::of(vec![
        light.name.clone(),
        light.white.clone().unwrap_or_else(|| "–".to_owned()),
        number(light.rf),
        number(light.ra),
        number(light.r9),
        number(light.efficacy),
    ])
}

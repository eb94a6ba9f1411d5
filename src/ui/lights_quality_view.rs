//! How good many lights are: a table over the page, the best first.

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
    shown: Memo<ByAddress<Vec<LightQuality>>, (String, Vec<Row>)>,
}

impl LightsQualityView {
    /// Opens it on the lights of these keys.
    pub(super) fn open(&mut self, keys: Vec<String>) {
        self.keys = keys;
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
        egui::Window::new("Quality of these lights")
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
        let ask = LightsQualityAsk::of(app.document(), &self.keys);
        let job = studies.of::<LightsQualityAsk>();
        job.put(&ask, wake);
        progress(ui, job, "Light quality");
        let found = job.result()?.clone();
        let (said, rows) = &*self.shown.get(ByAddress(found.clone()), |found| {
            (sentence(&found.0), found.0.iter().map(row).collect())
        });
        headline(ui, theme, said.as_str());
        let mut wish = None;
        if pressed(ui, "Copy as CSV", "Every light with its figures.") {
            ui.ctx().copy_text(csv(&found));
            wish = Some(Wish::Say(
                "Copied as CSV: quality of these lights.".to_owned(),
            ));
        }
        ui.add_space(4.0);
        let columns = [
            Column::words("Light", "Click to show it.", 3.0),
            Column::words("White", "Colour temperature and tint.", 2.4),
            Column::numbers("Rf", "Colour fidelity of TM-30, 100 at best.", 0.8),
            Column::numbers("Ra", "Colour rendering of CIE 13.3, 100 at best.", 0.8),
            Column::numbers("R9", "Rendering of a strong red, 100 at best.", 0.8),
            Column::numbers("lm/W", "Lumens per watt of radiation.", 0.8),
        ];
        let table = Table::new(&columns, theme);
        let id = "quality of many lights";
        let clicked = table.scrolled(ui, id, f32::INFINITY, rows, &mut |_, _, _| {});
        let clicked = clicked.and_then(|row| found.get(row));
        clicked.map(|light| Wish::Show(light.key.clone())).or(wish)
    }
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

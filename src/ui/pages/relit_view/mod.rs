//! The page "In few numbers, relit": a spectral picture by every band beside the same picture in
//! few numbers a pixel, under any light.

mod canvas;
mod controls;
mod kept;
mod side;

use eframe::egui;
use egui::{RichText, TextureHandle, Ui, vec2};

use super::{PageContext, PageWish, progress};
use crate::{
    app::{
        ByAddress, Memo,
        chart::{Chart, Rgb},
        pages::Look,
        relit::{
            Fit, FitAsk, LookAsk, Looked, PeersAsk, RelitShown, Rows, TurnAsk, Turned,
            difference_colours, headline, peer_rows, relit_shown, speed_line, trust_line,
        },
        studies::Stage,
    },
    languages::{fixed, said},
    pictures::{FixedSettings, Verdict},
    ui::{kit, swatch},
};

pub use controls::names;

/// From this width on the charts stand beside the picture, points.
const WIDE: f32 = 700.0;

/// Pictures on the graphics card: every band, few numbers, the map.
struct Textures {
    of: ByAddress<Turned>,
    handles: [TextureHandle; 3],
}

#[derive(Default)]
pub struct RelitView {
    textures: Option<Textures>,
    pointed: Option<[usize; 2]>,
    pixel: Memo<(ByAddress<Fit>, [usize; 2]), Chart>,
    error: Memo<(ByAddress<Looked>, usize), Chart>,
    off: Memo<ByAddress<Turned>, Chart>,
}

impl RelitView {
    /// Draws the page.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let memory = (&context.pages.relit, &context.pages.image);
        let shown = relit_shown(context.studies, context.app, memory, context.wake);
        self.head(ui, context, &shown);
        let presents = context.theme.presents;
        ui.horizontal_wrapped(|ui| {
            if !presents {
                controls::subject(ui, context);
            }
            controls::light(ui, context);
        });
        let wish = &mut context.pages.relit.wish;
        if shown.trouble.is_some()
            && *wish != FixedSettings::default()
            && ui.button(said(names::LEAVE)).clicked()
        {
            *wish = FixedSettings::default();
        }
        let Some(looked) = shown.looked.clone() else {
            return waiting(ui, context);
        };
        if !presents {
            self.numbers(ui, context, (&shown, &looked.0));
        }
        ui.add_space(2.0);
        if context.pages.relit.look == Look::Others && !presents {
            return others(ui, context, &shown);
        }
        let Some((fit, turned)) = shown.turned.clone() else {
            return waiting(ui, context);
        };
        self.upload(ui, &turned);
        let room = ui.available_size();
        let scale = context.theme.scale;
        if presents || room.x < WIDE * scale {
            return self.picture(ui, context, (&fit.0, &turned.0), room);
        }
        let gap = 2.0 * ui.spacing().item_spacing.x;
        let [width, height] = looked.0.size().map(|side| side as f32);
        // The picture as high as there is room; the charts have the rest.
        let high = (room.y - self.below(ui, context)) * width / height;
        let least = (0.3 * room.x).max(250.0 * scale);
        let left = high.min(room.x - gap - least).max(0.3 * room.x);
        let beside = room.x - gap - left;
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            let left = vec2(left, room.y);
            ui.allocate_ui(left, |ui| {
                ui.vertical(|ui| self.picture(ui, context, (&fit.0, &turned.0), left));
            });
            // Lines below the picture may have taken a little of it.
            let right = vec2(beside.min(ui.available_width()), room.y);
            ui.allocate_ui(right, |ui| {
                ui.vertical(|ui| self.side(ui, context, &shown, right));
            });
        });
    }

    /// How many numbers, what stands large, and saving.
    fn numbers(
        &self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        (shown, looked): (&RelitShown, &Looked),
    ) {
        ui.horizontal_wrapped(|ui| {
            let fit = shown.turned.as_ref().map(|(fit, _)| fit);
            controls::numbers(ui, context, looked, fit);
            if let Some(wish) = controls::save(ui, shown) {
                context.wishes.push(PageWish::FewNumbers(wish));
            }
        });
    }

    /// The result in a sentence, or why there is none.
    fn head(&self, ui: &mut Ui, context: &PageContext<'_>, shown: &RelitShown) {
        let words = match (&shown.trouble, &shown.turned) {
            (Some(why), _) => why.clone(),
            (None, Some((fit, turned))) => {
                // A class is not told of files.
                let stored = shown.stored.as_ref().map(|stored| &*stored.0);
                let stored = stored.filter(|_| !context.theme.presents);
                headline(&fit.0, &turned.0, stored)
            }
            (None, None) => {
                said!("A spectral picture in few numbers a pixel, under any light.").to_owned()
            }
        };
        kit::headline(ui, context.theme, words);
    }

    /// The textures, made anew when the picture was turned.
    fn upload(&mut self, ui: &Ui, turned: &ByAddress<Turned>) {
        if self
            .textures
            .as_ref()
            .is_some_and(|held| held.of == *turned)
        {
            return;
        }
        let [exact, few] = &turned.0.sides;
        let load = |name: &str, pixels: &[Rgb]| {
            let image = swatch::image([exact.width, exact.height], pixels);
            ui.ctx().load_texture(name, image, swatch::SQUARES)
        };
        self.textures = Some(Textures {
            of: turned.clone(),
            handles: [
                load("every band", &exact.pixels),
                load("few numbers", &few.pixels),
                load("difference", &difference_colours(&turned.0)),
            ],
        });
    }

    /// Height of what stands below the picture, points.
    fn below(&self, ui: &Ui, context: &PageContext<'_>) -> f32 {
        let gap = ui.spacing().item_spacing.y;
        let lines = 2.0 * (ui.spacing().interact_size.y + gap);
        match context.pages.relit.look {
            Look::Difference => lines + canvas::SCALE_HEIGHT * context.theme.scale + gap,
            Look::Picture | Look::Others => lines,
        }
    }

    /// The picture or the map, and two lines about it.
    fn picture(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        (fit, turned): (&Fit, &Turned),
        room: egui::Vec2,
    ) {
        let Some(textures) = &self.textures else {
            return;
        };
        let [exact, few, map] = textures.handles.each_ref().map(|handle| handle.id());
        let is_map = context.pages.relit.look == Look::Difference;
        let (both, one) = ([exact, few], [map]);
        let looked = &fit.looked.0;
        let theme = context.theme;
        let size = vec2(room.x, (room.y - self.below(ui, context)).max(60.0));
        let [bands, numbers] =
            [looked.bands().len(), fit.operator.numbers()].map(crate::io::many::numbers);
        let name = tr!(
            "{picture} under {light}, {bands} a pixel left, {numbers} right",
            picture = looked.name,
            light = turned.light,
            bands,
            numbers
        );
        let pixel = self.chosen(context, looked, turned);
        let drawn = canvas::Drawn {
            name: &name,
            pixels: looked.size(),
            textures: if is_map { &one } else { &both },
            labels: [
                &tr!("every band: {bands}", bands),
                &tr!("{numbers} a pixel", numbers),
            ],
            marked: Some(pixel),
        };
        let memory = &mut context.pages.relit;
        let touched = canvas::show(ui, size, &drawn, &mut memory.split, theme);
        if touched.clicked.is_some() {
            memory.pixel = touched.clicked;
            ui.ctx().request_repaint();
        }
        self.pointed = touched.pointed;
        if is_map {
            let [width, height] = looked.size().map(|side| side as f32);
            let drawn = width * (size.x / width).min(size.y / height);
            canvas::scale(ui, drawn, theme);
        }
        kit::line(ui, |ui| self.pointed_words(ui, looked, turned, pixel));
        kit::line(ui, |ui| {
            let words = trust_line(turned);
            let is_good = turned
                .trust
                .as_ref()
                .is_some_and(|trust| trust.verdict == Verdict::Good);
            if !is_good {
                ui.colored_label(theme.warning, "▲");
            }
            let label = ui.add(egui::Label::new(RichText::new(&words).weak()).truncate());
            label.on_hover_text(format!("{words} {}", turned.sides[0].words()));
        });
    }

    /// The pixel whose spectrum is shown: the chosen one, or the worst.
    fn chosen(&self, context: &PageContext<'_>, looked: &Looked, turned: &Turned) -> [usize; 2] {
        let [width, height] = looked.size();
        let worst = [turned.worst % width, turned.worst / width];
        let chosen = context.pages.relit.pixel;
        chosen
            .filter(|[x, y]| *x < width && *y < height)
            .unwrap_or(worst)
    }

    /// What is under the pointer, or else the marked pixel.
    fn pointed_words(&self, ui: &mut Ui, looked: &Looked, turned: &Turned, marked: [usize; 2]) {
        let [width, height] = looked.size();
        let pointed = self.pointed.filter(|[x, y]| *x < width && *y < height);
        let [x, y] = pointed.unwrap_or(marked);
        let off = turned.off[y * width + x];
        let step = looked.step;
        let off = if off.is_finite() {
            format!("ΔE₀₀ {}", fixed(f64::from(off), 2))
        } else {
            said!("not measured").to_owned()
        };
        let mut words = match pointed.is_some() {
            true => tr!(
                "Here (column {column}, row {row}): {difference}.",
                column = x * step,
                row = y * step,
                difference = off
            ),
            false => tr!(
                "In the ring (column {column}, row {row}): {difference}.",
                column = x * step,
                row = y * step,
                difference = off
            ),
        };
        if step > 1 {
            words += &tr!(
                " Drawn and measured: one pixel in {count}, across and down.",
                count = step
            );
        }
        for said in &looked.said {
            words += &format!(" {said}");
        }
        ui.add(egui::Label::new(RichText::new(&words).weak()).truncate())
            .on_hover_text(&words);
    }
}

/// How far the picture is.
fn waiting(ui: &mut Ui, context: &mut PageContext<'_>) {
    let studies = &mut *context.studies;
    progress(ui, studies.of::<LookAsk>(), said!("The picture"));
    progress(ui, studies.of::<FitAsk>(), said!("The fit"));
    progress(ui, studies.of::<TurnAsk>(), said!("The light"));
}

/// Other ways of keeping the same picture in as many numbers.
fn others(ui: &mut Ui, context: &mut PageContext<'_>, shown: &RelitShown) {
    let job = context.studies.of::<PeersAsk>();
    let Some(peers) = &shown.peers else {
        return progress(ui, job, said!("The comparison"));
    };
    if job.stage() != Stage::Done {
        progress(ui, job, said!("The comparison"));
    }
    let (rows, words) = peer_rows(&peers.0);
    ui.add(egui::Label::new(words).wrap());
    if let Some((fit, turned)) = &shown.turned {
        let words = RichText::new(speed_line(&fit.0, &turned.0)).weak();
        ui.add(egui::Label::new(words).wrap());
    }
    ui.add_space(4.0);
    peers_table(ui, context, rows);
}

fn peers_table(ui: &mut Ui, context: &PageContext<'_>, rows: Rows) {
    let columns = [
        kit::Column::words(said!("way"), said!("The way of keeping the picture."), 3.0),
        kit::Column::numbers(said!("numbers"), said!("Numbers a pixel."), 1.0),
        kit::Column::numbers(
            said!("bytes"),
            said!("Of the file, or of half numbers before packing."),
            1.2,
        ),
        kit::Column::numbers(
            said!("own ΔE₀₀"),
            said!("Own colour: 95 % of the pixels are within."),
            1.1,
        ),
        kit::Column::numbers(said!("lights ΔE₀₀"), said!("Mean under six lights."), 1.2),
        kit::Column::numbers(
            "95 %",
            said!("Under six lights: 95 % of the pixels are within."),
            0.9,
        ),
        kit::Column::numbers(said!("rms %"), said!("Of the spectra, relative."), 0.9),
        kit::Column::words(said!("remark"), "", 3.0),
    ];
    let row = |cells: Vec<String>| kit::Row {
        note: cells.last().cloned().unwrap_or_default(),
        ..kit::Row::of(cells)
    };
    let rows: Vec<kit::Row> = rows.into_iter().map(row).collect();
    kit::scrolled(ui, "other ways", |ui| {
        kit::table(ui, &columns, &rows, None, false, context.theme);
    });
}

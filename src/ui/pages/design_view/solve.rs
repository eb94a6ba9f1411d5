//! The page "Solve": the faders for a colour that is wished for, and the front of free lines.

use crate::ui::kit::{drag_value, slide};
use eframe::egui;
use egui::{Ui, vec2};

use super::{DesignView, large_swatch, set};
use crate::{
    app::{
        charts::design::front_chart,
        design::{
            Desk,
            front::{front_ask, on_desk, sentence},
            wish::Solved,
        },
        pages::MixWish,
    },
    design::solve::{Against, Care, FREE_LINES, Objective},
    languages::fixed,
    ui::{
        kit::{
            Choice, Chooser, Column, Form, GROUP, Row, column, form, headline, lights, number,
            scrolled, table, warning,
        },
        pages::{PageContext, progress},
        swatch,
    },
};

/// From this width on the diagram stands beside the wish, points.
const WIDE: f32 = 720.0;

/// What each figure is to be favoured for, in plain words.
fn favour_words(favour: Objective) -> (&'static str, &'static str) {
    match favour {
        Objective::Ler => (
            said!("most light for the power"),
            said!("Greatest luminous efficacy of radiation."),
        ),
        Objective::Rf => (
            said!("highest Rf found"),
            said!(
                "Fidelity index of TM-30, a mean over 99 surfaces: the highest of several searches."
            ),
        ),
        Objective::Ra => (
            said!("highest Ra found"),
            said!(
                "Colour rendering index of CIE 13.3, a mean over 8 test colours: the highest of \
                 several searches."
            ),
        ),
        Objective::Melanopic => (
            said!("greatest melanopic DER"),
            said!(
                "Greatest melanopic daylight efficacy ratio of CIE S 026 that these channels reach \
                 in this colour: most melanopic light for the lux. Above floors of Ra or Rf: the \
                 greatest of several searches."
            ),
        ),
        Objective::Fewest => (
            said!("fewest channels"),
            said!(
                "As few channels as will do, and among those the most light for the power. Where \
                 there are too many sets of channels to look through, the weakest are left out one \
                 by one."
            ),
        ),
    }
}

impl DesignView {
    /// Channels mixed to a light that is wished for.
    pub(crate) fn solve(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        self.refresh(context.app);
        let Some(desk) = self.desk.held().cloned() else {
            return;
        };
        // While something is dragged a first answer at once; that of several searches when it is let
        // go.
        let care = match ui.input(|input| input.pointer.any_down()) {
            true => Care::Quick,
            false => Care::Full,
        };
        let wish = &context.pages.solve;
        let solved = self.solved.get(context.app, wish, &desk, care).clone();
        let words = match &solved {
            Ok(solved) => &solved.sentence,
            Err(why) => why,
        };
        let now = desk.swatch().rgb8;
        let then = solved.as_ref().map_or(now, |solved| solved.swatch.rgb8);
        // The figures of the mixture are small type; its verdict is what was asked.
        let (verdict, figures) = words.split_once(". ").unwrap_or((words, ""));
        headline(
            ui,
            context.theme,
            format!("{}.", verdict.trim_end_matches('.')),
        );
        ui.add_space(GROUP);
        let both = [now, then].map(swatch::colour);
        let pair = |ui: &mut Ui, context: &PageContext<'_>| {
            now_and_solved(ui, context, both, figures);
        };
        let before = context.pages.solve.clone();
        let target = solved.as_ref().ok().map(|solved| solved.target_uv);
        let mut sets = false;
        let room = ui.available_size();
        let scale = context.theme.scale;
        if context.theme.presents || room.x >= WIDE * scale {
            let presents = context.theme.presents;
            let width = match presents {
                true => 0.53 * room.x,
                false => (0.40 * room.x).clamp(330.0 * scale, 520.0 * scale),
            };
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = GROUP;
                column(ui, vec2(width, room.y), |ui| {
                    ui.spacing_mut().item_spacing.x = 6.0;
                    scrolled(ui, "wish", |ui| {
                        pair(ui, context);
                        sets = wish_and_faders(ui, context, &desk, &solved);
                    });
                });
                ui.vertical(|ui| {
                    ui.spacing_mut().item_spacing.x = 6.0;
                    let width = ui.available_width();
                    let share = if presents { 1.0 } else { 0.52 };
                    let size = vec2(width, (share * room.y).floor());
                    let mut shown = self.diagram(ui, context, target, size);
                    context.ask_for_chart(shown.wish.take());
                    if !presents {
                        let rest = ui.available_height();
                        front(ui, context, &desk, rest);
                    }
                });
            });
        } else {
            scrolled(ui, "solve", |ui| {
                let width = ui.available_width();
                pair(ui, context);
                sets = wish_and_faders(ui, context, &desk, &solved);
                let mut shown = self.diagram(ui, context, target, vec2(width, 0.5 * room.y));
                context.ask_for_chart(shown.wish.take());
                front(ui, context, &desk, 0.5 * room.y);
            });
        }
        // A wish that is moved takes the faders along: in the next frame, which solves for it.
        if (sets || self.follows)
            && let Some(mix) = self.solved.follow(&desk.mix)
        {
            set(context, mix);
        }
        self.follows &= care == Care::Quick;
        if !before.asks_as(&context.pages.solve) {
            self.follows = true;
            ui.ctx().request_repaint();
        }
    }
}

/// The faders' colour now and as solved for, with the figures of the latter.
fn now_and_solved(ui: &mut Ui, context: &PageContext<'_>, both: [egui::Color32; 2], figures: &str) {
    let meaning = said!("Each as bright as the screen can show it.");
    let words = [said!("the faders now"), said!("as solved for")];
    large_swatch(ui, context, both, (said!("Now and solved"), meaning), words);
    ui.add(egui::Label::new(egui::RichText::new(figures).small()).wrap());
    ui.add_space(GROUP);
}

/// The wish, and the faders as they are solved for; whether they are to be set so. Before a class
/// the wish alone.
fn wish_and_faders(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    desk: &Desk,
    solved: &Result<Solved, String>,
) -> bool {
    form(ui, "wish", |form| {
        colour(form, context);
        favour(form, context);
        if !context.theme.presents {
            floors(form, context);
        }
    });
    ui.add_space(GROUP);
    let mut sets = false;
    if let Ok(solved) = solved {
        let is_there = solved.mix == desk.mix;
        ui.horizontal(|ui| {
            let button = ui
                .add_enabled(!is_there, egui::Button::new(said!("Set the faders")))
                .on_hover_text(said!("Moves the faders to the solution: one step of undo."))
                .on_disabled_hover_text(said!("The faders stand so."));
            sets = button.clicked();
            if !solved.reached {
                warning(ui, context.theme, said!("as near as the channels come"));
            }
        });
        if !context.theme.presents {
            ui.add_space(4.0);
            faders(ui, context, desk, solved);
        }
    }
    sets
}

/// The colour: a temperature, or that of a light.
fn colour(form: &mut Form<'_>, context: &mut PageContext<'_>) {
    form.row((said!("Colour of"), ""), |ui, _| whose_colour(ui, context));
    let wish = &mut context.pages.solve;
    if wish.light.is_some() {
        form.rest(|ui| {
            ui.checkbox(
                &mut wish.alike,
                said!("and its spectrum, as nearly as can be"),
            )
            .on_hover_text(said!(
                "Comes near to that light at every wavelength, in the least squares; its colour is \
                 met exactly all the same."
            ))
        });
        return;
    }
    if let Some(xy) = &mut wish.xy {
        for (value, title) in xy.iter_mut().zip(["x", "y"]) {
            form.row((title, ""), |ui, _| {
                let field = drag_value(value)
                    .range(0.0..=1.0)
                    .speed(0.0005)
                    .fixed_decimals(4);
                number(ui, field, title)
                    .on_hover_text(said!("CIE 1931 chromaticity: drag, or click to type."))
            });
        }
        return;
    }
    let of = slide(&mut wish.kelvin, MixWish::KELVIN.reach.range())
        .logarithmic(true)
        .fixed_decimals(0)
        .suffix(" K");
    let meaning = said!("Correlated colour temperature: 2700 K is a warm lamp, 6500 K daylight.");
    form.slider((said!("Temperature"), meaning), of);
    let of = slide(&mut wish.duv, MixWish::DUV.reach.range()).fixed_decimals(4);
    let meaning = said!("Distance from the blackbodies (Duv): above 0 greenish, below 0 pinkish.");
    form.slider((said!("Tint"), meaning), of);
}

/// Whether the colour is that of a temperature, of coordinates or of a light.
fn whose_colour(ui: &mut Ui, context: &mut PageContext<'_>) {
    let light = &context.pages.solve.light;
    let is_xy = light.is_none() && context.pages.solve.xy.is_some();
    let is_kelvin = light.is_none() && !is_xy;
    if ui
        .selectable_label(is_kelvin, said!("a temperature"))
        .clicked()
    {
        context.pages.solve.light = None;
        context.pages.solve.xy = None;
    }
    let by_xy = ui
        .selectable_label(is_xy, "x, y")
        .on_hover_text(said!("CIE 1931 chromaticity coordinates."));
    if by_xy.clicked() && !is_xy {
        let wish = context.pages.solve.clone();
        context.pages.solve = wish.by_xy(context.app.document());
    }
    let light = &context.pages.solve.light;
    let says = light.as_deref().map_or(said!("a light").to_owned(), |key| {
        context.app.document().name_of(key)
    });
    let chosen = Chooser {
        name: said!("Light whose colour is the target"),
        meaning: said!("The mixture is to have the colour of this light."),
        says: &says,
        offers: lights,
        width: 90.0 * context.theme.scale,
    }
    .show(ui, context.app);
    if let Some(chosen) = chosen {
        context.pages.solve.light = Some(chosen.key.clone());
        context.pages.solve.xy = None;
    }
}

fn favour(form: &mut Form<'_>, context: &mut PageContext<'_>) {
    let wish = &mut context.pages.solve;
    if wish.light.is_some() && wish.alike {
        return;
    }
    let meaning = said!("The figure that is best among the mixtures of exactly that colour.");
    form.row((said!("Best at"), meaning), |ui, _| {
        let choice = Choice {
            name: said!("Figure to favour"),
            meaning,
            width: 190.0 * context.theme.scale,
        };
        choice.pick(ui, &mut wish.favour, Objective::ALL, favour_words);
    });
}

/// What the mixture must not fall below.
fn floors(form: &mut Form<'_>, context: &mut PageContext<'_>) {
    let floors = &mut context.pages.solve.floors;
    let mut floor = |value: &mut Option<f64>, title: &str, usual: f64, most: f64| {
        form.row((said!("Not below"), ""), |ui, _| {
            let mut on = value.is_some();
            let digits = if most < 10.0 { 2 } else { 0 };
            if ui.checkbox(&mut on, title).changed() {
                *value = on.then_some(usual);
            }
            if let Some(value) = value {
                let field = drag_value(value)
                    .range(0.0..=most)
                    .speed(most / 200.0)
                    .fixed_decimals(digits);
                number(ui, field, &tr!("Floor of {figure}", figure = title));
            }
        });
    };
    floor(&mut floors.rf, "Rf", 80.0, 100.0);
    floor(&mut floors.ra, "Ra", 80.0, 100.0);
    floor(&mut floors.ler, "lm/W", 300.0, 683.0);
    floor(&mut floors.melanopic, said!("melanopic"), 0.5, 2.0);
}

/// The faders that were solved for.
fn faders(ui: &mut Ui, context: &mut PageContext<'_>, desk: &Desk, solved: &Solved) {
    let columns = [
        Column::words(
            said!("channel"),
            said!("As it stands on the page Mix."),
            2.0,
        ),
        Column::numbers(
            said!("now"),
            said!("Its fader, per cent of its full power."),
            1.0,
        ),
        Column::numbers(
            said!("solved"),
            said!("Its fader as it was solved for."),
            1.0,
        ),
        Column::words("", said!("Solving moves it, or not."), 1.0),
    ];
    let rows: Vec<Row> = desk
        .mix
        .channels
        .iter()
        .zip(&solved.mix.channels)
        .map(|(now, then)| {
            let state = match (desk.mix.is_heard(now), now.lock) {
                (false, _) => said!("silent"),
                (true, true) => said!("locked"),
                (true, false) => "",
            };
            let cells = [
                now.title(&|key| context.app.document().name_of(key)),
                format!("{} %", fixed(now.level, 1)),
                format!("{} %", fixed(then.level, 1)),
                state.to_owned(),
            ];
            Row {
                name: cells[..3].join(", "),
                cells: cells.to_vec(),
                ..Row::default()
            }
        })
        .collect();
    table(ui, &columns, &rows, None, false, context.theme);
}

/// The best that lines at free places were found to reach; a click takes the lines of a point.
fn front(ui: &mut Ui, context: &mut PageContext<'_>, desk: &Desk, height: f32) {
    let top = ui.cursor().top();
    let wish = &mut context.pages.solve;
    ui.horizontal_wrapped(|ui| {
        ui.label(said!("The best found with"));
        for lines in FREE_LINES {
            ui.selectable_value(&mut wish.lines, lines, lines.to_string())
                .on_hover_text(said!(
                    "Lines at the best places that a search finds, not those of the desk."
                ));
        }
        ui.label(said!("lines by"));
        for (against, title) in [(Against::Rf, "Rf"), (Against::Ra, "Ra")] {
            ui.selectable_value(&mut wish.against, against, title)
                .on_hover_text(said!("The figure that efficacy is traded for."));
        }
    });
    let ask = front_ask(&context.pages.solve, context.app.document());
    let job = context.studies.job();
    // While a slider is dragged the front would never be done.
    if let Some(ask) = ask.filter(|_| !ui.input(|input| input.pointer.any_down())) {
        job.put(&ask, context.wake);
    }
    progress(ui, job, said!("The front"));
    let Some((ask, found)) = job
        .answer()
        .map(|(ask, found)| (ask.clone(), found.clone()))
    else {
        return;
    };
    let points = match &*found {
        Ok(points) => points,
        Err(why) => {
            ui.weak(why);
            return;
        }
    };
    ui.add(egui::Label::new(sentence(points, &ask)).wrap());
    let chart = front_chart(points, ask.against, desk);
    let left = height - (ui.cursor().top() - top);
    let size = vec2(ui.available_width(), left.max(150.0));
    let shown = context.chart(ui, &chart, "front", size);
    let clicked = shown.clicked.filter(|hit| hit.series == 0);
    if let Some(point) = clicked.and_then(|hit| points.get(hit.point)) {
        set(context, on_desk(point));
    }
}

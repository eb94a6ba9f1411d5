//! The verdict: both colours side by side, a word before figures, how few numbers, and the error
//! against the order.

use eframe::egui;
use egui::{Align, Align2, Button, Label, Layout, Rect, RichText, Sense, Ui, vec2};

use super::{
    curve_view,
    kit::{named, named_choice, pressed_small, small_warnings},
    steps_view::{TO_AN_INSTRUMENT, TO_THE_EYE, scale, through_a_prism},
    swatch,
    theme::Theme,
};
use crate::study::Measure;
use crate::{
    app::{
        App, Command,
        answers::{Worst, judged, judged_on, verdict, verdict_alone, white_words},
        behind_slit::BehindSlit,
        numbers::two_digits,
        readings::COUNTS,
        verdicts::Seen,
        workspace::Preferences,
    },
    languages::{said, with_sign},
};

/// What of the column is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Side {
    #[default]
    Verdict,
    /// Every figure.
    Figures,
    /// Every knob.
    Settings,
}

/// The button that has a composite analysed.
pub const ANALYSE: &str = later!("Analyse it anew");

/// Height of the swatch without the ground around it, points.
pub(super) const SWATCH: f32 = 96.0;

/// Draws the column, which has a height in sight, points.
pub fn show(
    ui: &mut Ui,
    app: &App,
    preferences: &mut Preferences,
    theme: Theme,
    height: f32,
    commands: &mut Vec<Command>,
) {
    let top = ui.cursor().top();
    match judged(app) {
        Err(why) => drop(ui.add(Label::new(said(why)).wrap())),
        Ok(_) => {
            split(ui, app, theme, SWATCH * theme.scale, true);
            through_a_prism(ui, app, theme);
        }
    }
    ui.add_space(4.0);
    headline(ui, app, theme);
    rule(ui);
    answers(ui, app, theme);
    rule(ui);
    numbers(ui, app, theme);
    warnings(ui, app, theme, commands);
    rule(ui);
    // By where it stands in the column: a curve must not grow by what was scrolled.
    let left = height - (ui.cursor().top() - top) - 4.0;
    let room = left.clamp(150.0, 300.0);
    curve_view::show(ui, app, preferences, theme, room, commands);
}

/// Height of the buttons below the column, points.
pub const FOOT: f32 = 40.0;

/// The way to every figure and every knob.
pub fn foot(ui: &mut Ui, theme: Theme, side: &mut Side) {
    ui.columns(2, |columns| {
        for (ui, (words, to, meaning)) in columns.iter_mut().zip([
            (
                said!("All figures"),
                Side::Figures,
                said!("XYZ, chromaticity, errors, every line."),
            ),
            (
                said!("Settings"),
                Side::Settings,
                said!("Every knob of the model."),
            ),
        ]) {
            let size = vec2(ui.available_width(), 28.0 * theme.scale);
            if ui
                .add_sized(size, Button::new(words))
                .on_hover_text(meaning)
                .clicked()
            {
                *side = to;
            }
        }
    });
}

fn rule(ui: &mut Ui) {
    ui.add_space(6.0);
    let rect = ui.available_rect_before_wrap();
    let stroke = ui.visuals().widgets.noninteractive.bg_stroke;
    ui.painter().hline(rect.x_range(), rect.top(), stroke);
    ui.add_space(8.0);
}

/// Both colours on a ground of their own, told apart by two ticks.
pub(super) fn split(ui: &mut Ui, app: &App, theme: Theme, height: f32, says: bool) {
    let colour = &app.derived().colour;
    let (Ok(_), Some(exact), Some(model)) = (judged(app), colour.exact, colour.model) else {
        return;
    };
    let name = tr!(
        "Colour: measured {measured}, model {model}",
        measured = exact.swatch.hex(),
        model = model.swatch.hex()
    );
    let size = vec2(ui.available_width(), height + 16.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    named(&response, egui::Role::Button, &name);
    let painter = ui.painter();
    painter.rect_filled(rect, 4.0, theme.swatch_ground);
    let inner = rect.shrink(8.0);
    let [left, right] = [exact, model].map(|c| swatch::colour(c.swatch.rgb8));
    swatch::paint_split(ui, inner, left, right);
    swatch::ticks(ui, inner, 8.0 * theme.scale);
    swatch::menu(&response, [exact, model].map(|c| c.swatch.rgb8));
    if response.clicked() {
        let text = format!("{} {}", exact.swatch.hex(), model.swatch.hex());
        ui.ctx().copy_text(text);
    }
    let off_screen = !(exact.swatch.in_gamut && model.swatch.in_gamut);
    let [measured, by_model] = [exact, model].map(|colour| colour.swatch.hex());
    let mapping = crate::io::many::capitalised(said(exact.swatch.mapping.words()));
    response.on_hover_text(match off_screen {
        true => tr!(
            "Left as measured {measured}, right by the model {by_model}. {mapping}. It lies \
             outside the screen's colours. Click to copy both.",
            measured,
            by_model,
            mapping
        ),
        false => tr!(
            "Left as measured {measured}, right by the model {by_model}. {mapping}. Click to copy \
             both.",
            measured,
            by_model,
            mapping
        ),
    });
    if !says {
        return;
    }
    ui.horizontal(|ui| {
        let small = |words: &str| RichText::new(words.to_owned()).small().color(theme.faint);
        ui.label(small(said!("measured")));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.label(small(said!("model")));
            let middle = if app.document().is_about_light() {
                said!("as seen beside daylight").to_owned()
            } else {
                tr!("under {light}", light = app.document().light.name())
            };
            let words = Label::new(small(&middle)).truncate();
            if ui.available_width() > 90.0 * theme.scale {
                ui.with_layout(
                    Layout::centered_and_justified(egui::Direction::LeftToRight),
                    |ui| ui.add(words),
                );
            }
        });
    });
}

/// An error in the two digits that it is good for.
pub(super) fn figure(delta: f64) -> String {
    match delta {
        d if d < 0.01 => with_sign("< 0.01".to_owned()),
        d => two_digits(d),
    }
}

fn headline(ui: &mut Ui, app: &App, theme: Theme) {
    let worst = judged(app).ok();
    if let Some(worst) = &worst {
        let seen = Seen::of(worst.delta_e_2000);
        let size = if theme.scale > 1.0 { 18.0 } else { 20.0 };
        let words = RichText::new(verdict_alone(app, seen))
            .size(size * theme.scale)
            .color(ui.visuals().strong_text_color());
        ui.add(Label::new(words).wrap())
            .on_hover_text(verdict(app, seen));
        scale(ui, said(TO_THE_EYE), seen, Seen::meaning, theme);
        eye_caption(ui, app, worst, theme);
    }
    if let Some(behind) = BehindSlit::of(app) {
        ui.add_space(2.0);
        let meaning = Seen::meaning_behind_slit;
        scale(ui, said(TO_AN_INSTRUMENT), behind.step, meaning, theme);
        let words = tr!(
            "{share} % off behind a slit of 10 nm",
            share = behind.percent()
        );
        ui.label(RichText::new(words).small())
            .on_hover_text(Measure::RmsBlurred.figure().meaning());
    }
    if let Some(surfaces) = app.surfaces().filter(|_| worst.is_some()) {
        let words = RichText::new(surfaces.brief()).small();
        ui.add(Label::new(words.color(theme.faint)).wrap())
            .on_hover_text(tr!(
                "{sentence} All tables of surfaces that ship and were measured, under the light \
                 and under the model.",
                sentence = surfaces.sentence()
            ));
    }
}

/// How many surfaces are looked at.
fn surfaces(app: &App) -> Option<usize> {
    Some(app.derived().patches.as_ref()?.items.len())
}

fn eye_caption(ui: &mut Ui, app: &App, worst: &Worst, theme: Theme) {
    let at = match (&worst.patch, surfaces(app)) {
        (None, _) => said!("of its own colour").to_owned(),
        (Some(patch), Some(count)) => {
            tr!("at worst of {count} ({surface})", count, surface = patch)
        }
        (Some(patch), None) => tr!("at worst ({surface})", surface = patch),
    };
    // Where there are no patches it is said already.
    let own = app.derived().colour.delta_e_2000;
    let own = own.filter(|_| worst.patch.is_some());
    let row = vec2(ui.available_width(), ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(row, Layout::right_to_left(Align::Center), |ui| {
        if let Some(own) = own {
            let words = tr!("the light itself {difference}", difference = figure(own));
            ui.label(RichText::new(words).small().color(theme.faint));
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let words = format!("ΔE₀₀ {} {at}", figure(worst.delta_e_2000));
            ui.add(Label::new(RichText::new(words).small()).truncate())
                .on_hover_text(said!(
                    "CIEDE2000, the CIE's measure of how different two colours look."
                ));
        });
    });
}

/// How far light is moved, and what white it is.
fn answers(ui: &mut Ui, app: &App, theme: Theme) {
    let derived = app.derived();
    let mut row = |question: &str, answer: String, meaning: &str| {
        ui.horizontal(|ui| {
            ui.label(RichText::new(question).color(theme.faint));
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                ui.label(RichText::new(answer).color(ui.visuals().strong_text_color()))
                    .on_hover_text(meaning);
            });
        });
    };
    let figure = |measure: Measure| Some((measure.figure(), derived.figures[measure]?));
    let has_colour = judged(app).is_ok();
    let moved = match has_colour && app.document().is_about_light() {
        true => said!("Light moved along the spectrum"),
        false => said!("Moved along the spectrum"),
    };
    if let Some((figure, value)) = figure(Measure::Displacement) {
        let words = format!("{}{}", two_digits(figure.shown(value)), figure.unit.tail);
        row(moved, words, figure.meaning());
    }
    if !derived.has_errors() {
        let nothing = said!("nothing to compare").to_owned();
        row(said!("The spectrum"), nothing, derived.why_no_errors());
    }
    if let Some(white) = white_words(app).filter(|_| has_colour) {
        row(
            said!("White"),
            white,
            said!(
                "Correlated colour temperature of the light from 360 to 830 nm, after Ohno, and \
                 which way it leaves the line of blackbodies (Duv)."
            ),
        );
    }
}

/// Numbers of the model, and points of the table in its range that they stand for.
pub(super) fn counts(app: &App) -> (usize, usize) {
    let derived = app.derived();
    (derived.numbers(), app.table_points())
}

fn numbers(ui: &mut Ui, app: &App, theme: Theme) {
    let (count, instead) = counts(app);
    let model = &app.derived().model;
    let (smooth, lines) = (model.smooth().coefficients.len(), model.lines().len());
    ui.horizontal(|ui| {
        let large = RichText::new(count.to_string())
            .size(28.0 * theme.scale)
            .color(ui.visuals().strong_text_color());
        ui.label(large);
        ui.vertical(|ui| {
            ui.spacing_mut().item_spacing.y = 1.0;
            ui.label(match instead {
                0 => said!("numbers").to_owned(),
                _ => tr!("numbers instead of {count}", count = instead),
            });
            let lines = match lines {
                0 => said!("no lines").to_owned(),
                n => tr!(
                    "2 for one line" | "{numbers} for {n} lines" % n,
                    numbers = 2 * n
                ),
            };
            let smooth = tr!("{n} for the smooth part" | "{n} for the smooth part" % smooth);
            let mut words = format!("{smooth}, {lines}");
            if model.has_widths() {
                words += ", ";
                words += said!("1 for widths");
            }
            ui.label(RichText::new(words).small().color(theme.faint))
                .on_hover_text(said!(
                    "N waves take 2N + 1 numbers; a line takes two, place and weight."
                ));
        });
    });
}

/// What must be said about the model, and the way to another one for a composite as it is.
fn warnings(ui: &mut Ui, app: &App, theme: Theme, commands: &mut Vec<Command>) {
    small_warnings(ui, theme, &app.derived().warnings);
    let meaning =
        said!("Takes the composite apart like a measured spectrum, with the knobs of before.");
    if app.document().as_given().is_some() && pressed_small(ui, said(ANALYSE), meaning) {
        commands.push(Command::Analyse);
    }
}

/// The line that stands for the column where the model is no part of the page; clicked, it opens
/// the column.
pub fn line(ui: &mut Ui, app: &App) -> bool {
    let words = judged(app).map_or_else(
        |why| match why {
            COUNTS => said!("of counts, not light").to_owned(),
            _ => said!("no colour").to_owned(),
        },
        |worst| {
            let seen = Seen::of(worst.delta_e_2000).seen();
            let difference = figure(worst.delta_e_2000);
            match surfaces(app) {
                Some(count) => tr!(
                    "ΔE₀₀ {difference} at worst of {count}: {seen}",
                    difference,
                    count,
                    seen
                ),
                None => tr!("ΔE₀₀ {difference} at worst: {seen}", difference, seen),
            }
        },
    );
    let text = tr!(
        "Model: {n} numbers, {verdict}" | "Model: {n} numbers, {verdict}" % app.derived().numbers(),
        verdict = words
    );
    ui.add(
        Button::new(RichText::new(text).small())
            .frame(false)
            .truncate(),
    )
    .on_hover_text(tr!(
        "Opens the model's verdict and its knobs beside the page. Judged {surfaces}.",
        surfaces = judged_on(app)
    ))
    .clicked()
}

/// The edge that the column folds to; whether it was clicked.
pub fn edge(ui: &mut Ui, is_open: bool) -> bool {
    let rect = ui.available_rect_before_wrap();
    let response = ui.allocate_rect(rect, Sense::click());
    let words = said!("Verdict, figures, settings");
    named_choice(&response, egui::Role::Button, is_open, words);
    let ink = if response.hovered() || response.has_focus() {
        ui.visuals().strong_text_color()
    } else {
        ui.visuals().text_color()
    };
    let painter = ui.painter();
    let arrow = if is_open { "▶" } else { "◀" };
    let font = egui::TextStyle::Small.resolve(ui.style());
    let top = Rect::from_min_size(rect.min, vec2(rect.width(), 40.0));
    painter.text(
        top.center(),
        Align2::CENTER_CENTER,
        arrow,
        font.clone(),
        ink,
    );
    let galley = painter.layout_no_wrap(words.to_owned(), font, ink);
    let at = egui::pos2(rect.center().x + galley.size().y / 2.0, top.bottom() + 4.0);
    let turned =
        egui::epaint::TextShape::new(at, galley, ink).with_angle(std::f32::consts::FRAC_PI_2);
    painter.add(turned);
    response.clicked()
}

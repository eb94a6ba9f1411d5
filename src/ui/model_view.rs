//! The model's knobs.

mod spikes;

use crate::ui::kit::{drag_value, slide};
use std::cell::RefCell;

use eframe::egui;
use egui::{SliderClamping, Ui};

use self::spikes::spike_rows;
use super::{
    kit::{Choice, number, pressed_small},
    theme::section,
};
use crate::{
    app::{
        App, Command, Scale, Settings, Subject, WEIGHT_FACTORS, own_observers::observers,
        pages::knob::Knob, range_words,
    },
    io::{many::capitalised, quoted},
    languages::{fixed, said, with_sign},
    spectrum::{Band, Basis, LONGEST_NM, MOST_STEPS, SHORTEST_NM, Sampling},
};

/// The slider's own reach; more can be typed.
const SLIDER_ORDERS: std::ops::RangeInclusive<usize> = 0..=40;

/// Names of controls, shared with the tests that move them.
pub mod names {
    /// The order slider.
    pub const ORDER: &str = later!("Waves (order N)");
    /// The spike threshold slider.
    pub const THRESHOLD: &str = later!("Threshold");
    /// The widest line.
    pub const WIDTH: &str = later!("Widest line");
    /// The colour-exact switch.
    pub const COLOUR_EXACT: &str = later!("Colour-exact");
    /// The spikes switch.
    pub const SPIKES: &str = later!("Keep lines");
    /// The absorption switch.
    pub const DIPS: &str = later!("Dark lines too");
}

/// Draws the knobs; what changed is pushed as one command. Gives what is to be said about it.
pub fn controls(ui: &mut Ui, app: &App, commands: &mut Vec<Command>) -> Option<String> {
    section(ui, said!("Model"));
    subject_switch(ui, app, commands);
    let before = app.document().settings;
    let mut settings = before;
    let mut said = None;
    basis_row(ui, &mut settings);
    egui::Grid::new("model knobs")
        .num_columns(2)
        .spacing([8.0, 4.0])
        .show(ui, |ui| {
            order_row(ui, &mut settings);
            spike_rows(ui, &mut settings);
            said = range_row(ui, app, &mut settings);
            observer_row(ui, app, &mut settings);
            products_row(ui, &mut settings);
            scale_row(ui, app, commands);
            weight_factor_row(ui, app, commands);
        });
    if settings != before {
        commands.push(Command::Edit(settings));
    }
    said
}

fn subject_switch(ui: &mut Ui, app: &App, commands: &mut Vec<Command>) {
    let document = app.document();
    let Some(factor) = &document.factor else {
        return;
    };
    ui.columns(2, |columns| {
        for (ui, (subject, name)) in columns.iter_mut().zip([
            (Subject::Light, document.light.name()),
            (Subject::Factor, factor.name()),
        ]) {
            let chosen = document.is_about_light() == (subject == Subject::Light);
            let size = egui::vec2(ui.available_width(), ui.spacing().interact_size.y);
            let button = egui::Button::selectable(chosen, name)
                .truncate()
                .min_size(size);
            let meaning = said!("Models the light, or the surface that is chosen.");
            if ui.add(button).on_hover_text(meaning).clicked() {
                commands.push(Command::About(subject));
            }
        }
    });
}

fn basis_row(ui: &mut Ui, settings: &mut Settings) {
    ui.horizontal(|ui| {
        for basis in Basis::ALL {
            ui.selectable_value(&mut settings.basis, basis, capitalised(said(basis.name())))
                .on_hover_text(crate::languages::said(basis.meaning()));
        }
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.checkbox(&mut settings.colour_exact, said(names::COLOUR_EXACT))
                .on_hover_text(said!(
                    "The model keeps X, Y and Z of the spectrum exactly. It costs no numbers and \
                     needs one wave or more."
                ));
        });
    });
}

fn order_row(ui: &mut Ui, settings: &mut Settings) {
    let label = ui.label(said(names::ORDER));
    ui.add(
        slide(&mut settings.order, SLIDER_ORDERS)
            .clamping(SliderClamping::Never)
            .integer(),
    )
    .labelled_by(label.id)
    .on_hover_text(tr!(
        "Waves of the smooth part: order N of its series, {range} (the slider ends at 40; type \
         more). The left and right arrow keys change it too.",
        range = reach_words(&Settings::ORDER)
    ));
    *settings = settings.clamped();
    ui.end_row();
}

/// "0 to 100".
fn reach_words<T>(knob: &Knob<T>) -> String {
    let range = knob.reach.range();
    let [least, most] = [range.start(), range.end()].map(|end| with_sign(end.to_string()));
    tr!("{least} to {most}", least, most)
}

/// Gives what is to be said: another range is taken than the one asked for.
fn range_row(ui: &mut Ui, app: &App, settings: &mut Settings) -> Option<String> {
    let mut said = None;
    ui.label(said!("Range"));
    ui.horizontal(|ui| {
        let ends = <[f64; 2]>::from(settings.band);
        let (shortest, most) = (f64::from(SHORTEST_NM), f64::from(MOST_STEPS));
        let [mut min, mut max] = ends;
        let typed = [RefCell::default(), RefCell::default()];
        let low_range = (max - most).max(0.0)..=max - shortest;
        let low = edge(&mut min, &typed[0]).range(low_range);
        let low = number(ui, low, said!("Range from"))
            .on_hover_text(said!("First wavelength of the model, whole nm."));
        ui.label(said!("to"));
        let high_range = min + shortest..=(min + most).min(f64::from(LONGEST_NM));
        let high = edge(&mut max, &typed[1]).range(high_range);
        let high = number(ui, high, said!("Range to")).on_hover_text(said!(
            "Last wavelength of the model, whole nm; at least 20 nm more."
        ));
        if (low.changed() || high.changed())
            && let Ok(band) = Band::new(min.round(), max.round())
        {
            settings.band = band;
        }
        for (end, typed) in typed.into_iter().enumerate() {
            if let Some(text) = typed.into_inner() {
                said = typed_words(&text, ends, end, settings.band);
            }
        }
        let meaning = said!("Back to the range 380 to 780 nm.");
        if settings.band != Band::VISIBLE && pressed_small(ui, "380-780", meaning) {
            settings.band = Band::VISIBLE;
        }
        if let Some((table, band)) = table_beyond(app, settings.band)
            && ui
                .small_button(said!("table's"))
                .on_hover_text(tr!(
                    "The range of the spectrum's own table, {first_nm} to {last_nm} nm.",
                    first_nm = fixed(table[0], 0),
                    last_nm = fixed(table[1], 0)
                ))
                .clicked()
        {
            settings.band = band;
            said = range_words(table, band);
        }
    });
    ui.end_row();
    said
}

/// What is said of a text that was typed as one end of a range.
fn typed_words(text: &str, ends: [f64; 2], end: usize, taken: Band) -> Option<String> {
    let Some(nm) = wavelength(text) else {
        let [min_nm, max_nm] = <[f64; 2]>::from(taken).map(|nm| with_sign(nm.to_string()));
        return Some(tr!(
            "The model's range: expected whole nm, found {found}; {min_nm} to {max_nm} nm stays.",
            found = quoted(text),
            min_nm,
            max_nm
        ));
    };
    let mut asked = ends;
    asked[end] = nm;
    range_words(asked, taken)
}

/// A typed number, blanks and the unit aside; `None` for what is none.
fn wavelength(text: &str) -> Option<f64> {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let text = text.trim_end_matches("nm").replace('−', "-");
    text.parse().ok().filter(|nm: &f64| nm.is_finite())
}

fn observer_row(ui: &mut Ui, app: &App, settings: &mut Settings) {
    ui.label(said!("Observer"));
    let choice = Choice {
        name: said!("Observer"),
        meaning: said!(
            "The colour-matching functions that make X, Y and Z. A file of three sensitivities, \
             such as a camera's, is listed here once it is open."
        ),
        width: ui.spacing().combo_width,
    };
    // Only while the list is open: an opened file is a table to be read off.
    let all = std::iter::once_with(|| observers(app)).flatten();
    choice.pick(ui, &mut settings.observer, all, |o| (o.title(), ""));
    ui.end_row();
}

/// The ends of the subject's table and the range nearest to them, when hardly any of the table
/// lies in the range of the model.
fn table_beyond(app: &App, band: Band) -> Option<([f64; 2], Band)> {
    let samples = &app.document().subject_entry().spectrum.samples;
    let (first, last) = (samples.first_nm(), samples.last_nm());
    let common = last.min(band.max_nm()) - first.max(band.min_nm());
    let table = [first.ceil(), last.floor()];
    if common > 0.25 * (last - first) || table[1] - table[0] < f64::from(SHORTEST_NM) {
        return None;
    }
    Some((table, Band::nearest(table)?)).filter(|(_, nearest)| *nearest != band)
}

/// A wavelength to drag or type, whole nm. What is half typed is no wavelength yet; what was typed
/// is left in `typed`.
fn edge<'a>(nm: &'a mut f64, typed: &'a RefCell<Option<String>>) -> egui::DragValue<'a> {
    drag_value(nm)
        .speed(1.0)
        .fixed_decimals(0)
        .suffix(" nm")
        .update_while_editing(false)
        .custom_parser(|text| {
            *typed.borrow_mut() = Some(text.to_owned());
            wavelength(text)
        })
}

fn products_row(ui: &mut Ui, settings: &mut Settings) {
    ui.label(said!("Products"));
    let choice = Choice {
        name: said!("Products by"),
        meaning: sampling_words(settings.sampling).1,
        width: ui.spacing().combo_width + 34.0,
    };
    choice.pick(ui, &mut settings.sampling, Sampling::ALL, sampling_words);
    ui.end_row();
}

/// What values on screen are counted in.
fn scale_row(ui: &mut Ui, app: &App, commands: &mut Vec<Command>) {
    let scale = app.document().scale;
    ui.label(said!("Scale"));
    let choice = Choice {
        name: said!("Scale"),
        meaning: scale.meaning(),
        width: ui.spacing().combo_width + 34.0,
    };
    choice.show(ui, scale.words(), |ui| {
        for other in Scale::ALL {
            let response = ui.selectable_label(scale == other, other.words());
            if response.on_hover_text(other.meaning()).clicked() {
                commands.push(Command::Scale(other));
            }
        }
    });
    ui.end_row();
}

/// The paper's lamps only: how the weights of its Table 4 are read.
fn weight_factor_row(ui: &mut Ui, app: &App, commands: &mut Vec<Command>) {
    let document = app.document();
    if !document.light.is_of_the_paper() {
        return;
    }
    let label = ui.label(said!("Weight factor"));
    let mut factor = document.weight_factor;
    let changed = ui
        .add(
            drag_value(&mut factor)
                .speed(1.0)
                .range(WEIGHT_FACTORS)
                .suffix(" nm"),
        )
        .labelled_by(label.id)
        .on_hover_text(said!(
            "The weights of the paper's Table 4 times this are unit x nm; the paper does not say."
        ))
        .changed();
    if changed {
        commands.push(Command::WeightFactor(factor));
    }
    ui.end_row();
}

/// How products of light and reflectance are formed, in words.
pub(super) fn sampling_words(sampling: Sampling) -> (&'static str, &'static str) {
    match sampling {
        Sampling::Paper => (
            said!("paper's points"),
            said!("Products on as many points as there are numbers: waves above N fold back."),
        ),
        Sampling::ThreeN => (
            said!("3N + 1 points"),
            said!(
                "Waves up to N of the product are exact (Fourier); for an odd N it is one point \
                 more. The reflectance is modelled too."
            ),
        ),
        Sampling::FourN => (
            said!("4N + 1 points"),
            said!("Every wave of one product is exact (Fourier). The reflectance is modelled too."),
        ),
        Sampling::Double => (
            said!("twice the numbers"),
            said!("Products on twice as many points as there are numbers."),
        ),
        Sampling::Convolution => (
            said!("convolution"),
            said!("The coefficients convolved and cut back to N waves: all above is lost."),
        ),
        Sampling::Exact => (
            said!("exact, 1 nm"),
            said!("Products on the 1 nm grid with the reflectance as measured."),
        ),
    }
}

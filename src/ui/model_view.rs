//! The model's knobs, and under them the whole error-against-order curve.

use eframe::egui;
use egui::{Slider, SliderClamping, Ui};
use egui_plot::{HLine, Line, Plot, PlotPoints, Points, VLine};

use super::{
    axes,
    theme::{Theme, ink, section},
};
use crate::{
    app::{
        App, Command, Settings, Subject,
        document::WEIGHT_FACTORS,
        settings::{Detector, GRADIENTS_PERCENT, ORDERS, THRESHOLDS_PERCENT, WIDTHS_NM},
        ticks,
        workspace::{CurveQuantity, Preferences},
    },
    color::Observer,
    spectrum::{
        Band, Basis, Sampling,
        band::{LONGEST_NM, MOST_STEPS, SHORTEST_NM},
    },
};

/// The slider's own reach; more can be typed.
const SLIDER_ORDERS: std::ops::RangeInclusive<usize> = 0..=40;
const SLIDER_THRESHOLDS: std::ops::RangeInclusive<f64> = 0.1..=5.0;
const SLIDER_WIDTHS_NM: std::ops::RangeInclusive<f64> = 2.0..=20.0;

/// Names of controls, shared with the tests that move them.
pub mod names {
    /// The order slider.
    pub const ORDER: &str = "Order N";
    /// The spike threshold slider.
    pub const THRESHOLD: &str = "Threshold";
    /// The widest line.
    pub const WIDTH: &str = "Widest line";
    /// The colour-exact switch.
    pub const COLOUR_EXACT: &str = "Colour-exact";
    /// The spikes switch.
    pub const SPIKES: &str = "Spikes";
    /// The absorption switch.
    pub const DIPS: &str = "Dips too";
}

/// Draws the knobs; what changed is pushed as one command.
pub fn controls(ui: &mut Ui, app: &App, commands: &mut Vec<Command>) {
    section(ui, "Model");
    subject_switch(ui, app, commands);
    let before = app.document().settings;
    let mut settings = before;
    basis_row(ui, &mut settings);
    egui::Grid::new("model knobs")
        .num_columns(2)
        .spacing([8.0, 4.0])
        .show(ui, |ui| {
            order_row(ui, &mut settings);
            spike_rows(ui, &mut settings);
            range_row(ui, app, &mut settings);
            observer_row(ui, &mut settings);
            products_row(ui, &mut settings);
            weight_factor_row(ui, app, commands);
        });
    if settings != before {
        commands.push(Command::Edit(settings));
    }
}

/// The count of numbers, and the curve; clicking it goes to that order.
pub fn curve(
    ui: &mut Ui,
    app: &App,
    preferences: &mut Preferences,
    theme: Theme,
    commands: &mut Vec<Command>,
) {
    let derived = app.derived();
    let smooth = derived.model.smooth.coefficients.len();
    let spikes = derived.model.spikes.len();
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.label("Numbers used");
        ui.strong(derived.numbers().to_string());
        ui.weak(format!(
            "= {smooth} smooth + {} for {spikes} {}",
            2 * spikes,
            if spikes == 1 { "spike" } else { "spikes" }
        ));
    })
    .response
    .on_hover_text("An order N takes 2N + 1 numbers; a spike takes two, its place and its weight.");
    quantity_row(ui, app, preferences);
    plot(ui, app, preferences.curve, theme, commands);
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
            if ui
                .add(button)
                .on_hover_text("What the model is of: the light, or the selected reflectance.")
                .clicked()
            {
                commands.push(Command::About(subject));
            }
        }
    });
}

fn basis_row(ui: &mut Ui, settings: &mut Settings) {
    ui.horizontal(|ui| {
        for (basis, name, meaning) in [
            (
                Basis::Fourier,
                "Fourier",
                "The paper's periodic series: 2N + 1 numbers. It rings where the two ends of the \
                 range differ.",
            ),
            (
                Basis::Cosine,
                "Cosine",
                "Half-range cosines: the same 2N + 1 numbers, no jump at the ends.",
            ),
        ] {
            if ui
                .selectable_label(settings.basis == basis, name)
                .on_hover_text(meaning)
                .clicked()
            {
                settings.basis = basis;
            }
        }
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.checkbox(&mut settings.colour_exact, names::COLOUR_EXACT)
                .on_hover_text(
                    "Least squares under the condition that X, Y and Z of the spectrum itself are \
                     exact. It costs no numbers and needs N of 1 or more.",
                );
        });
    });
}

fn order_row(ui: &mut Ui, settings: &mut Settings) {
    let label = ui.label(names::ORDER);
    ui.add(
        Slider::new(&mut settings.order, SLIDER_ORDERS)
            .clamping(SliderClamping::Never)
            .integer(),
    )
    .labelled_by(label.id)
    .on_hover_text(format!(
        "Order of the series, {} to {} (the slider ends at 40; type more). Left and right arrow \
         keys change it too.",
        ORDERS.start(),
        ORDERS.end()
    ));
    settings.order = settings.order.clamp(*ORDERS.start(), *ORDERS.end());
    ui.end_row();
}

fn spike_rows(ui: &mut Ui, settings: &mut Settings) {
    ui.checkbox(&mut settings.spikes, names::SPIKES)
        .on_hover_text("Take lines out of the spectrum and keep each as a place and a weight.");
    ui.horizontal(|ui| {
        ui.add_enabled_ui(settings.spikes, |ui| {
            let chosen = match settings.detector {
                Detector::Energy => "by energy",
                Detector::Gradient => "by gradient",
            };
            let combo = egui::ComboBox::from_id_salt("detector")
                .selected_text(chosen)
                .width(ui.spacing().combo_width)
                .show_ui(ui, |ui| {
                    ui.selectable_value(&mut settings.detector, Detector::Energy, "by energy")
                        .on_hover_text(
                            "Prominent, narrow peaks whose energy is above the threshold.",
                        );
                    ui.selectable_value(&mut settings.detector, Detector::Gradient, "by gradient")
                        .on_hover_text("The paper's way: steep on both sides.");
                });
            named(&combo.response, egui::Role::ComboBox, "Spike detector");
            combo
                .response
                .on_hover_text("How lines are told from the smooth part.");
            ui.add_enabled(
                settings.detector == Detector::Energy,
                egui::Checkbox::new(&mut settings.dips, names::DIPS),
            )
            .on_disabled_hover_text("The gradient detector only looks for lines that stand up.")
            .on_hover_text(
                "Look for absorption lines as well; they become spikes of negative weight.",
            );
        });
    });
    ui.end_row();

    let enabled = settings.spikes;
    if settings.detector == Detector::Gradient {
        let label = ui.add_enabled(enabled, egui::Label::new("Slope"));
        ui.add_enabled(
            enabled,
            Slider::new(&mut settings.gradient_percent, GRADIENTS_PERCENT)
                .logarithmic(true)
                .custom_formatter(|v, _| ticks::short(v))
                .suffix(" %/nm"),
        )
        .labelled_by(label.id)
        .on_hover_text("Least slope of a line's flanks, percent of the largest value per nm.");
    } else {
        let label = ui.add_enabled(enabled, egui::Label::new(names::THRESHOLD));
        ui.add_enabled(
            enabled,
            Slider::new(&mut settings.threshold_percent, SLIDER_THRESHOLDS)
                .logarithmic(true)
                .clamping(SliderClamping::Never)
                .custom_formatter(|v, _| ticks::short(v))
                .suffix(" %"),
        )
        .labelled_by(label.id)
        .on_hover_text(format!(
            "Least share of the total power that a spike must carry, percent. {} to {} can be \
             typed.",
            THRESHOLDS_PERCENT.start(),
            THRESHOLDS_PERCENT.end()
        ));
    }
    ui.end_row();

    let label = ui.add_enabled(enabled, egui::Label::new(names::WIDTH));
    ui.add_enabled(
        enabled,
        Slider::new(&mut settings.max_width_nm, SLIDER_WIDTHS_NM)
            .clamping(SliderClamping::Never)
            .custom_formatter(|v, _| ticks::short(v))
            .suffix(" nm"),
    )
    .labelled_by(label.id)
    .on_hover_text(format!(
        "Full width at half maximum of the widest line that may become a spike, nm. {} to {} can \
         be typed.",
        WIDTHS_NM.start(),
        WIDTHS_NM.end()
    ));
    ui.end_row();
}

fn range_row(ui: &mut Ui, app: &App, settings: &mut Settings) {
    let label = ui.label("Range");
    ui.horizontal(|ui| {
        let (mut min, mut max) = (settings.band.min_nm(), settings.band.max_nm());
        let (shortest, most) = (f64::from(SHORTEST_NM), f64::from(MOST_STEPS));
        let low_range = (max - most).max(0.0)..=max - shortest;
        let low = ui
            .add(edge(&mut min).range(low_range))
            .labelled_by(label.id)
            .on_hover_text("First wavelength of the model, whole nm.");
        named(&low, egui::Role::SpinButton, "Range from");
        ui.label("to");
        let high_range = min + shortest..=(min + most).min(f64::from(LONGEST_NM));
        let high = ui
            .add(edge(&mut max).range(high_range))
            .on_hover_text("Last wavelength of the model, whole nm; at least 20 nm more.");
        named(&high, egui::Role::SpinButton, "Range to");
        if (low.changed() || high.changed())
            && let Ok(band) = Band::new(min.round(), max.round())
        {
            settings.band = band;
        }
        if settings.band != Band::VISIBLE
            && ui
                .small_button("380-780")
                .on_hover_text("Back to the range 380 to 780 nm.")
                .clicked()
        {
            settings.band = Band::VISIBLE;
        }
        if let Some(table) = table_beyond(app, settings.band)
            && ui
                .small_button("table's")
                .on_hover_text(format!(
                    "The range of the spectrum's own table, {} to {} nm.",
                    table.min_nm(),
                    table.max_nm()
                ))
                .clicked()
        {
            settings.band = table;
        }
    });
    ui.end_row();
}

fn observer_row(ui: &mut Ui, settings: &mut Settings) {
    ui.label("Observer");
    let combo = egui::ComboBox::from_id_salt("observer")
        .selected_text(settings.observer.title())
        .width(ui.spacing().combo_width)
        .show_ui(ui, |ui| {
            for observer in Observer::ALL {
                ui.selectable_value(&mut settings.observer, observer, observer.title());
            }
        });
    named(&combo.response, egui::Role::ComboBox, "Observer");
    combo
        .response
        .on_hover_text("Whose colour-matching functions make X, Y and Z.");
    ui.end_row();
}

/// The range of the subject's table, when hardly any of it lies in the range of the model.
fn table_beyond(app: &App, band: Band) -> Option<Band> {
    let samples = &app.document().subject_entry().spectrum.samples;
    let (first, last) = (samples.first_nm(), samples.last_nm());
    let common = last.min(band.max_nm()) - first.max(band.min_nm());
    if common > 0.25 * (last - first) {
        return None;
    }
    Band::new(first.ceil(), last.floor()).ok()
}

/// A wavelength to drag or type, whole nm.
fn edge(nm: &mut f64) -> egui::DragValue<'_> {
    egui::DragValue::new(nm)
        .speed(1.0)
        .fixed_decimals(0)
        .suffix(" nm")
}

/// Gives a response a name for screen readers.
fn named(response: &egui::Response, role: egui::Role, name: &str) {
    response.widget_info(|| egui::WidgetInfo::labeled(role, true, name));
}

fn products_row(ui: &mut Ui, settings: &mut Settings) {
    ui.label("Products");
    let (words, meaning) = sampling_words(settings.sampling);
    let combo = egui::ComboBox::from_id_salt("sampling")
        .selected_text(words)
        .width(ui.spacing().combo_width + 34.0)
        .show_ui(ui, |ui| {
            for sampling in Sampling::ALL {
                let (words, meaning) = sampling_words(sampling);
                ui.selectable_value(&mut settings.sampling, sampling, words)
                    .on_hover_text(meaning);
            }
        });
    named(&combo.response, egui::Role::ComboBox, "Products by");
    combo.response.on_hover_text(meaning);
    ui.end_row();
}

/// The paper's lamps only: how the weights of its Table 4 are read.
fn weight_factor_row(ui: &mut Ui, app: &App, commands: &mut Vec<Command>) {
    let document = app.document();
    if !document.light.is_of_the_paper() {
        return;
    }
    let label = ui.label("Weight factor");
    let mut factor = document.weight_factor;
    let changed = ui
        .add(
            egui::DragValue::new(&mut factor)
                .speed(1.0)
                .range(WEIGHT_FACTORS)
                .suffix(" nm"),
        )
        .labelled_by(label.id)
        .on_hover_text(
            "The weights of the paper's Table 4 times this are unit x nm. 300 nm reads them as \
             contributions to the mean over the range; the paper does not say.",
        )
        .changed();
    if changed {
        commands.push(Command::WeightFactor(factor));
    }
    ui.end_row();
}

/// How products of light and reflectance are formed, in words.
fn sampling_words(sampling: Sampling) -> (&'static str, &'static str) {
    match sampling {
        Sampling::Paper => (
            "paper's points",
            "Products on as many points as there are numbers, as the paper does: orders above N \
             fold back. The reflectance is modelled too.",
        ),
        Sampling::ThreeN => (
            "3N + 1 points",
            "Orders up to N of the product are exact (Fourier). The reflectance is modelled too.",
        ),
        Sampling::FourN => (
            "4N + 1 points",
            "Every order of one product is exact (Fourier). The reflectance is modelled too.",
        ),
        Sampling::Double => (
            "twice the numbers",
            "Products on twice as many points as there are numbers. The reflectance is modelled \
             too.",
        ),
        Sampling::Exact => (
            "exact, 1 nm",
            "Products on the 1 nm grid with the reflectance as measured; spikes weigh it where \
             they stand.",
        ),
    }
}

fn quantity_words(quantity: CurveQuantity) -> (&'static str, &'static str) {
    match quantity {
        CurveQuantity::Own => ("own colour ΔE", "CIEDE2000 of the spectrum's own colour."),
        CurveQuantity::Patches => (
            "patches' mean ΔE",
            "Mean CIEDE2000 of the patches under the light, products at 1 nm.",
        ),
        CurveQuantity::PatchesWorst => (
            "worst patch ΔE",
            "Largest CIEDE2000 of the patches under the light, products at 1 nm.",
        ),
        CurveQuantity::Rms => (
            "rms at 1 nm",
            "Root mean square of model minus measured over that of the spectrum.",
        ),
        CurveQuantity::RmsBlurred => (
            "rms behind 10 nm",
            "The same after a Gaussian blur of 10 nm full width.",
        ),
    }
}

const QUANTITIES: [CurveQuantity; 5] = [
    CurveQuantity::Own,
    CurveQuantity::Patches,
    CurveQuantity::PatchesWorst,
    CurveQuantity::Rms,
    CurveQuantity::RmsBlurred,
];

/// The chosen quantity where it exists: a reflectance has no patches.
fn shown(app: &App, chosen: CurveQuantity) -> CurveQuantity {
    let of_patches = matches!(chosen, CurveQuantity::Patches | CurveQuantity::PatchesWorst);
    if of_patches && app.derived().patches.is_none() {
        CurveQuantity::Own
    } else {
        chosen
    }
}

fn quantity_row(ui: &mut Ui, app: &App, preferences: &mut Preferences) {
    let now = shown(app, preferences.curve);
    ui.horizontal(|ui| {
        ui.label("Error against order");
        let combo = egui::ComboBox::from_id_salt("curve quantity")
            .selected_text(quantity_words(now).0)
            .width(ui.available_width() - 8.0)
            .show_ui(ui, |ui| {
                for quantity in QUANTITIES {
                    if shown(app, quantity) == quantity {
                        let (name, meaning) = quantity_words(quantity);
                        ui.selectable_value(&mut preferences.curve, quantity, name)
                            .on_hover_text(meaning);
                    }
                }
            });
        named(
            &combo.response,
            egui::Role::ComboBox,
            "What the curve shows",
        );
        combo.response.on_hover_text(quantity_words(now).1);
    });
}

/// Errors below this are drawn at it: the axis is logarithmic.
const FLOOR: f64 = 1e-4;

/// A just noticeable colour difference, about; the line drawn for orientation.
const NOTICEABLE: f64 = 1.0;

fn plot(ui: &mut Ui, app: &App, chosen: CurveQuantity, theme: Theme, commands: &mut Vec<Command>) {
    let quantity = shown(app, chosen);
    let derived = app.derived();
    let order = derived.model.smooth.order();
    let points: Vec<[f64; 2]> = derived
        .curve
        .iter()
        .filter_map(|p| {
            let value = match quantity {
                CurveQuantity::Own => p.own,
                CurveQuantity::Patches => p.patches_mean,
                CurveQuantity::PatchesWorst => p.patches_max,
                CurveQuantity::Rms => p.relative_rms,
                CurveQuantity::RmsBlurred => p.relative_rms_10nm,
            }?;
            Some([p.order as f64, value.max(FLOOR).log10()])
        })
        .collect();
    let height = 96.0 * theme.scale;
    if points.is_empty() {
        ui.allocate_ui(egui::vec2(ui.available_width(), height), |ui| {
            ui.weak("There is no colour to compare in this range.");
        });
        return;
    }
    let is_colour = !matches!(quantity, CurveQuantity::Rms | CurveQuantity::RmsBlurred);
    let highest = points.last().map_or(1.0, |p| p[0]);
    let lowest_log = points.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
    let highest_log = points
        .iter()
        .map(|p| p[1])
        .fold(f64::NEG_INFINITY, f64::max);
    let words = move |log: f64| {
        if is_colour {
            ticks::short(10_f64.powf(log))
        } else {
            format!("{} %", ticks::short(100.0 * 10_f64.powf(log)))
        }
    };
    let now = points.iter().find(|p| p[0] as usize == order).copied();
    let line = theme.line;
    let inks = theme.inks;
    let plot = Plot::new("error against order")
        .height(height)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_axis_zoom_drag(false)
        .show_crosshair(false)
        .set_margin_fraction(egui::vec2(0.02, 0.08))
        .include_x(0.0)
        .include_x(highest)
        .include_y((lowest_log - 0.1).floor().max(FLOOR.log10()))
        .include_y(highest_log.ceil())
        .x_grid_spacer(axes::marks(8))
        .y_grid_spacer(axes::decades(3))
        .label_formatter(|_| None);
    let response =
        axes::dress(plot, theme, 34.0 * theme.scale, ticks::short, words).show(ui, |plot| {
            if is_colour {
                plot.hline(
                    HLine::new("", NOTICEABLE.log10())
                        .color(theme.faint.gamma_multiply(0.6))
                        .width(1.0),
                );
            }
            plot.vline(VLine::new("", order as f64).color(theme.faint).width(1.0));
            plot.line(
                Line::new("error", PlotPoints::from(points.clone()))
                    .color(ink(inks.smooth))
                    .width(line),
            );
            plot.points(
                Points::new("orders", PlotPoints::from(points.clone()))
                    .color(ink(inks.smooth))
                    .radius(1.8 * theme.scale),
            );
            if let Some(now) = now {
                plot.points(
                    Points::new("now", PlotPoints::from(vec![now]))
                        .color(ink(inks.spikes))
                        .radius(4.5 * theme.scale),
                );
            }
            plot.pointer_coordinate()
        });
    named(
        &response.response,
        egui::Role::Image,
        "Error against order; click to go to an order",
    );
    let pointed = response
        .inner
        .filter(|_| response.response.hovered())
        .map(|at| (at.x.round().clamp(0.0, highest)) as usize);
    if let Some(pointed) = pointed
        && response.response.clicked()
        && pointed != order
    {
        commands.push(Command::Edit(Settings {
            order: pointed,
            ..app.document().settings
        }));
    }
    let read = pointed.unwrap_or(order);
    if let (Some(point), Some(numbers)) = (
        points.iter().find(|p| p[0] as usize == read),
        derived.curve.get(read).map(|p| p.numbers),
    ) {
        response.response.on_hover_text_at_pointer(format!(
            "N = {read}: {} ({numbers} numbers). Click to go there.",
            words(point[1])
        ));
    }
}

//! Neutral surroundings for colour: greys without a tint, one accent, two themes, a size for
//! presenting.

use std::sync::Arc;

use eframe::egui;
use egui::{
    Color32, Context, CornerRadius, FontFamily, FontId, Stroke, TextStyle, Vec2,
    epaint::text::{FontInsert, FontPriority, InsertFontFamily},
    style::NumberFormatter,
};

pub use crate::app::studies::Wake;
use crate::app::{
    chart::{self, Ink},
    sheet::FONT,
    verdicts::Seen,
    workspace::Preferences,
};
use crate::languages::with_sign;

/// From this size of the window on type grows with it, points, and how much at most.
const LARGE: Vec2 = Vec2::new(1920.0, 1080.0);
pub(super) const MOST_GROWN: f32 = 1.4;

/// By how much type is larger in a window of a size: a wide one that is low has no room for it.
pub fn grown(size: Vec2) -> f32 {
    (size / LARGE).min_elem().clamp(1.0, MOST_GROWN)
}

/// How much larger type and how much thicker lines are while presenting.
const PRESENT_TYPE: f32 = 2.0;
const PRESENT_LINES: f32 = 2.0;

/// The looks that views ask for beside egui's own style.
#[derive(Clone, Copy, Debug)]
pub struct Theme {
    /// Dark surroundings.
    pub dark: bool,
    /// Thickness of curves, points.
    pub line: f32,
    /// Ground of plots.
    pub ground: Color32,
    /// Text that explains, not shouts.
    pub faint: Color32,
    /// The mark of something that needs attention (never by colour alone).
    pub warning: Color32,
    /// Around every swatch and patch; never equal to a grey patch.
    pub swatch_ground: Color32,
    /// Fill of what one holds: a slider's track.
    pub accent: Color32,
    /// Tracks of sliders.
    pub track: Color32,
    /// "Hard to see" in charts.
    pub zone: [u8; 3],
    /// Multiplier of fixed sizes, in large windows and while presenting.
    pub scale: f32,
    /// The page is presented to a class.
    pub presents: bool,
}

/// How a difference is seen, as a colour: always beside its word.
pub fn of_seen(seen: Seen, dark: bool) -> Color32 {
    let [r, g, b] = match (seen, dark) {
        (Seen::Hardly, true) => [72, 184, 154],
        (Seen::SideBySide, true) => [230, 180, 34],
        (Seen::Visible, true) => [232, 131, 58],
        (Seen::Large, true) => [224, 96, 94],
        (Seen::Hardly, false) => [12, 109, 84],
        (Seen::SideBySide, false) => [138, 101, 0],
        (Seen::Visible, false) => [168, 72, 12],
        (Seen::Large, false) => [168, 34, 34],
    };
    Color32::from_rgb(r, g, b)
}

/// A colour by the ground that it stands on.
fn either(dark: bool) -> impl Fn([u8; 3], [u8; 3]) -> Color32 {
    move |on_dark, on_light| ink(if dark { on_dark } else { on_light })
}

impl Theme {
    /// The theme of the preferences.
    pub fn of(preferences: &Preferences) -> Self {
        let dark = preferences.dark;
        let either = either(dark);
        let presented = |factor| if preferences.presents() { factor } else { 1.0 };
        Self {
            dark,
            line: 1.6 * presented(PRESENT_LINES).max(preferences.grown),
            ground: grey(if dark { 18 } else { 255 }),
            faint: faint(dark),
            swatch_ground: swatch_ground(dark),
            accent: either([78, 161, 224], [27, 111, 174]),
            track: grey(if dark { 88 } else { 178 }),
            zone: if dark { [23, 48, 41] } else { [220, 239, 232] },
            warning: either([240, 190, 90], [140, 80, 0]),
            scale: presented(PRESENT_TYPE).max(preferences.grown),
            presents: preferences.presents(),
        }
    }

    /// The theme of charts in these looks.
    pub fn of_charts(self) -> chart::Theme {
        match self.dark {
            true => chart::Theme::Dark,
            false => chart::Theme::Light,
        }
    }

    /// The colour of an ink of charts.
    pub fn ink(self, role: Ink) -> Color32 {
        ink(role.of(self.of_charts()))
    }
}

/// Text that explains, not shouts.
const fn faint(dark: bool) -> Color32 {
    grey(if dark { 162 } else { 90 })
}

/// Around every swatch; never equal to a grey patch.
pub const fn swatch_ground(dark: bool) -> Color32 {
    grey(if dark { 68 } else { 180 })
}

/// Fill and words of a card's main button.
pub fn main_colours(dark: bool) -> (Color32, Color32) {
    let either = either(dark);
    (
        either([78, 161, 224], [27, 111, 174]),
        either([16; 3], [255; 3]),
    )
}

/// A neutral grey.
pub const fn grey(level: u8) -> Color32 {
    Color32::from_rgb(level, level, level)
}

/// An ink as an egui colour.
pub fn ink([r, g, b]: [u8; 3]) -> Color32 {
    Color32::from_rgb(r, g, b)
}

/// Fonts that have every sign the program writes; call once per context.
pub fn install_fonts(context: &Context) {
    // egui's own font lacks primes, subscripts and arrows; DejaVu stands behind it.
    let family = |family| InsertFontFamily {
        family,
        priority: FontPriority::Lowest,
    };
    context.add_font(FontInsert::new(
        "DejaVu Sans",
        egui::FontData::from_static(FONT),
        vec![
            family(FontFamily::Proportional),
            family(FontFamily::Monospace),
        ],
    ));
}

/// Sets colours and sizes for the preferences.
pub fn apply(context: &Context, preferences: &Preferences) {
    let theme = Theme::of(preferences);
    context.set_theme(if theme.dark {
        egui::Theme::Dark
    } else {
        egui::Theme::Light
    });
    context.all_styles_mut(|style| {
        let size = |points: f32| points * theme.scale;
        style.text_styles = [
            (TextStyle::Small, FontId::proportional(size(12.0))),
            (TextStyle::Body, FontId::proportional(size(14.0))),
            (TextStyle::Button, FontId::proportional(size(14.0))),
            (TextStyle::Heading, FontId::proportional(size(16.0))),
            (TextStyle::Monospace, FontId::monospace(size(12.5))),
        ]
        .into();
        style.number_formatter = NumberFormatter::new(|number, decimals| {
            with_sign(egui::emath::format_with_decimals_in_range(number, decimals))
        });
        style.spacing.item_spacing = Vec2::new(6.0, 4.0);
        style.spacing.button_padding = Vec2::new(7.0, 2.0);
        style.spacing.interact_size.y = size(20.0);
        style.spacing.slider_width = size(128.0);
        style.spacing.combo_width = size(96.0);
        style.interaction.tooltip_delay = 0.35;
        style.interaction.interact_radius = 5.0;
        // A name beside a slider takes no finger from it, and a page is moved by its words.
        style.interaction.selectable_labels = preferences.touch != Some(true);
        if preferences.touch == Some(true) {
            for_fingers(style);
        }
        colours(&mut style.visuals, theme.dark);
    });
}

/// The least side of a target for a finger, points.
pub const FINGER: f32 = 36.0;

/// How far from a target a finger still meets it where no other is nearer, points.
pub const NEAR_FINGER: f32 = 12.0;

/// Targets that fingers meet: around every one there is room of [`NEAR_FINGER`], so that pages keep
/// their order.
fn for_fingers(style: &mut egui::Style) {
    style.spacing.scroll.bar_width = 14.0;
    style.interaction.interact_radius = NEAR_FINGER;
}

/// The least height of rows that stand on one another and are chosen from, points: they have no
/// room around them.
pub fn least_row(ui: &egui::Ui) -> f32 {
    let has_fingers = ui.style().interaction.interact_radius >= NEAR_FINGER;
    if has_fingers { FINGER } else { 0.0 }
}

/// Greys of both themes, from the ground up.
fn colours(visuals: &mut egui::Visuals, dark: bool) {
    *visuals = if dark {
        egui::Visuals::dark()
    } else {
        egui::Visuals::light()
    };
    let either = either(dark);
    // (panel, plot ground, faint stripe, text, strong text, control, hovered, active, outline)
    let [
        panel,
        ground,
        faint,
        text,
        strong,
        control,
        hovered,
        active,
        outline,
    ] = if dark {
        [33, 18, 38, 208, 244, 51, 66, 82, 56]
    } else {
        [242, 255, 232, 48, 16, 222, 208, 194, 205]
    };
    visuals.panel_fill = grey(panel);
    visuals.window_fill = grey(panel);
    visuals.extreme_bg_color = grey(ground);
    visuals.faint_bg_color = grey(faint);
    visuals.window_stroke = Stroke::new(1.0, grey(outline));
    visuals.selection.bg_fill = either([31, 71, 99], [195, 222, 242]);
    visuals.selection.stroke = Stroke::new(1.0, either([255; 3], [11, 43, 68]));
    visuals.weak_text_color = Some(self::faint(dark));
    visuals.slider_trailing_fill = true;
    visuals.hyperlink_color = either([120, 190, 235], [0, 90, 150]);
    let radius = CornerRadius::same(4);
    let widgets = &mut visuals.widgets;
    for (state, fill, words) in [
        (&mut widgets.noninteractive, panel, text),
        (&mut widgets.inactive, control, text),
        (&mut widgets.hovered, hovered, strong),
        (&mut widgets.active, active, strong),
        (&mut widgets.open, hovered, strong),
    ] {
        state.bg_fill = grey(fill);
        state.weak_bg_fill = grey(fill);
        state.fg_stroke = Stroke::new(1.0, grey(words));
        state.corner_radius = radius;
        state.expansion = 0.0;
    }
    widgets.noninteractive.bg_stroke = Stroke::new(1.0, grey(outline));
    widgets.inactive.bg_stroke = Stroke::NONE;
    let focus = either([110, 180, 225], [0, 100, 160]);
    widgets.hovered.bg_stroke = Stroke::new(1.0, grey(active));
    widgets.active.bg_stroke = Stroke::new(1.0, focus);
}

/// A heading of a panel's section.
pub fn section(ui: &mut egui::Ui, title: &str) {
    ui.add_space(2.0);
    ui.label(egui::RichText::new(title).heading());
}

/// What wakes the window from another thread.
pub fn waker(context: &Context) -> Wake {
    let context = context.clone();
    Arc::new(move || context.request_repaint())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::{Srgb, srgb::xyz_from_linear};

    /// Contrast of two colours as WCAG 2 defines it.
    fn contrast(a: Color32, b: Color32) -> f64 {
        let luminance = |colour: Color32| {
            let [r, g, b, _] = colour.to_array();
            xyz_from_linear(Srgb([r, g, b]).to_linear()).y + 0.05
        };
        let (a, b) = (luminance(a), luminance(b));
        a.max(b) / a.min(b)
    }

    #[test]
    fn all_text_stands_out_from_what_it_stands_on() {
        // WCAG 2, level AA, for text of usual size.
        const LEAST: f64 = 4.5;
        assert!((contrast(grey(0), grey(255)) - 21.0).abs() < 1e-9);
        for dark in [true, false] {
            let preferences = Preferences {
                dark,
                ..Preferences::default()
            };
            let theme = Theme::of(&preferences);
            let mut visuals = egui::Visuals::dark();
            colours(&mut visuals, dark);
            let widgets = &visuals.widgets;
            let grounds = [
                visuals.panel_fill,
                visuals.extreme_bg_color,
                visuals.faint_bg_color,
            ];
            let words = [
                visuals.text_color(),
                visuals.strong_text_color(),
                visuals.weak_text_color(),
                visuals.hyperlink_color,
                theme.faint,
                theme.warning,
                theme.ink(Ink::Second),
            ];
            let mut pairs: Vec<(Color32, Color32)> = Vec::new();
            pairs.extend(grounds.iter().flat_map(|g| words.iter().map(|w| (*w, *g))));
            for state in [
                &widgets.noninteractive,
                &widgets.inactive,
                &widgets.hovered,
                &widgets.active,
                &widgets.open,
            ] {
                pairs.push((state.fg_stroke.color, state.bg_fill));
            }
            pairs.push((visuals.selection.stroke.color, visuals.selection.bg_fill));
            pairs.push(main_colours(dark));
            // The word of a step on its fill.
            let ink = grey(if dark { 18 } else { 255 });
            pairs.extend(Seen::ALL.map(|seen| (ink, of_seen(seen, dark))));
            // The word alone, and the words of charts, in the window and on paper.
            pairs.extend(Seen::ALL.map(|seen| (of_seen(seen, dark), visuals.panel_fill)));
            let palette = chart::Palette::of(theme.of_charts());
            let [paper, ground] = [palette.paper, palette.ground].map(super::ink);
            for words in [palette.text, palette.faint].map(super::ink) {
                pairs.extend([paper, ground, visuals.panel_fill].map(|on| (words, on)));
            }
            for (a, b) in pairs {
                let found = contrast(a, b);
                assert!(found >= LEAST, "dark {dark}: {a:?} on {b:?} has {found:.2}");
            }
        }
    }
}

//! A spectrum in a list: its swatch, its name, what it is, and its small curve.

use std::{collections::HashMap, sync::Arc};

use eframe::egui;
use egui::{Align2, Color32, FontId, Id, Rect, Shape, Stroke, Ui, Vec2, pos2};

use super::{swatch, theme::swatch_ground};
use crate::{
    app::{Entry, Library, about::About, tint::kelvin_words},
    color::{
        Adaptation, Observer, Swatch, Xyz,
        xyz::{xyz_from_light, xyz_from_reflectance},
    },
    spectrum::{Kind, Outside},
};

/// A row's swatch and curve, made once.
struct Art {
    colour: Color32,
    /// Heights 0-1 over 380-780 nm.
    curve: Vec<f32>,
    /// What it is, in a few words.
    what: String,
}

/// Points of a row's small curve.
const CURVE_POINTS: usize = 36;
/// Places between two of them at which it is looked for lines.
const STEPS_BETWEEN: usize = 10;

/// Rows whose swatches and curves are kept.
const MOST_KEPT: usize = 4096;

/// Every row's, by key, with the entry it was made of: after an undo another file may have the key.
type Arts = HashMap<String, (Arc<Entry>, Arc<Art>)>;

impl Art {
    /// Made once for an entry and kept as long as the window.
    fn kept(ui: &Ui, entry: &Arc<Entry>) -> Arc<Self> {
        let is_it = |(made_of, _): &&(Arc<Entry>, Arc<Self>)| Arc::ptr_eq(made_of, entry);
        let id = Id::unique("swatches and curves of spectra");
        let kept = ui.data_mut(|data| {
            let arts = data.get_temp_mut_or_default::<Arts>(id);
            Some(arts.get(&entry.key).filter(is_it)?.1.clone())
        });
        kept.unwrap_or_else(|| {
            let art = Arc::new(Self::of(entry));
            ui.data_mut(|data| {
                let arts = data.get_temp_mut_or_default::<Arts>(id);
                if arts.len() >= MOST_KEPT {
                    // Spectra that were taken out long ago are among them.
                    arts.clear();
                }
                arts.insert(entry.key.clone(), (entry.clone(), art.clone()));
            });
            art
        })
    }

    fn of(entry: &Entry) -> Self {
        let samples = &entry.spectrum.samples;
        let outside = entry.kind().outside();
        // The highest of what stands between two points, so that no line falls through.
        let step = 400.0 / (CURVE_POINTS - 1) as f64;
        let highest_near = |i: usize| {
            let nm = (0..=STEPS_BETWEEN).map(|k| {
                let part = k as f64 / STEPS_BETWEEN as f64 - 0.5;
                380.0 + step * (i as f64 + part)
            });
            nm.map(|nm| samples.at(nm, outside))
                .fold(f64::NEG_INFINITY, f64::max)
        };
        let values: Vec<f64> = (0..CURVE_POINTS).map(highest_near).collect();
        let top = values.iter().copied().fold(0.0, f64::max);
        let swatch = match entry.kind() {
            Kind::Light => {
                xyz_from_light(samples, Outside::Zero, Observer::CIE_1931).map(Swatch::of_light)
            }
            Kind::Reflectance | Kind::Transmittance => {
                let light = Library::bundled()
                    .find("cie_illuminants/CIE D65")
                    .ok()
                    .and_then(|p| p.spectrum());
                light.and_then(|light| {
                    let white: Xyz =
                        xyz_from_light(&light.samples, Outside::Zero, Observer::CIE_1931)?;
                    let xyz = xyz_from_reflectance(samples, &light.samples, Observer::CIE_1931)?;
                    Some(Swatch::of_patch(xyz, white, Adaptation::None))
                })
            }
            Kind::Absorbance | Kind::Weighting | Kind::Lines | Kind::Other => None,
        };
        let about = About::of(entry);
        let kelvin = about.kelvin.map(kelvin_words);
        let words = Some(about.what).filter(|what| !what.is_empty());
        let scans = entry.measured.as_ref().and_then(|of| of.scans);
        let scans = scans
            .filter(|n| *n > 1)
            .map(|n| tr!("{count} scans", count = n));
        let what: Vec<String> = words.into_iter().chain(kelvin).chain(scans).collect();
        Self {
            what: what.join(", "),
            colour: swatch.map_or(Color32::from_gray(110), |s| swatch::colour(s.rgb8)),
            curve: values
                .iter()
                .map(|v| {
                    if top > 0.0 {
                        (v / top).clamp(0.0, 1.0) as f32
                    } else {
                        0.0
                    }
                })
                .collect(),
        }
    }
}

/// How an entry is painted into its row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Painted {
    /// Room before the swatch, points.
    pub indent: f32,
    /// Letters at the beginning and the end of its name that all its neighbours have too.
    pub common: [usize; 2],
    /// The colour of its curve in the plot, where it is laid over.
    pub marked: Option<Color32>,
    pub ink: Color32,
    pub faint: Color32,
    /// Multiplier of fixed sizes.
    pub scale: f32,
}

impl Painted {
    /// Paints an entry's row.
    pub(super) fn show(self, ui: &Ui, rect: Rect, entry: &Arc<Entry>) {
        let art = Art::kept(ui, entry);
        let side = rect.height() - 12.0;
        let field = Rect::from_min_size(
            pos2(
                rect.left() + 4.0 + self.indent,
                rect.center().y - side / 2.0,
            ),
            Vec2::splat(side),
        );
        let ground = swatch_ground(ui.visuals().dark_mode);
        ui.painter().rect_filled(field.expand(3.0), 3.0, ground);
        ui.painter().rect_filled(field, 2.0, art.colour);
        let curve_width = (0.24 * rect.width()).clamp(30.0, 64.0);
        let curve = Rect::from_min_max(
            pos2(rect.right() - curve_width - 4.0, rect.top() + 7.0),
            pos2(rect.right() - 4.0, rect.bottom() - 7.0),
        );
        let thick = if self.scale > 1.0 { 1.6 } else { 1.0 };
        let stroke = Stroke::new(thick, self.ink.gamma_multiply(0.75));
        draw_curve(ui, curve, &art.curve, stroke);
        let mut name_right = curve.left() - 4.0;
        if let Some(colour) = self.marked {
            let mark = pos2(name_right - 5.0, rect.center().y);
            let stroke = Stroke::new(2.0, colour);
            ui.painter().circle_stroke(mark, 4.0, stroke);
            name_right -= 14.0;
        }
        let name_rect = Rect::from_min_max(
            pos2(field.right() + 10.0, rect.top()),
            pos2(name_right, rect.bottom()),
        );
        let font = egui::TextStyle::Body.resolve(ui.style());
        let small = egui::TextStyle::Small.resolve(ui.style());
        let name = elided(ui, &row_name(entry), self.common, &font, name_rect.width());
        let painter = ui
            .painter()
            .with_clip_rect(name_rect.intersect(ui.clip_rect()));
        let middle = rect.center().y;
        let lift = if art.what.is_empty() {
            0.0
        } else {
            8.0 * self.scale
        };
        let at = pos2(name_rect.left(), middle - lift);
        painter.text(at, Align2::LEFT_CENTER, name, font, self.ink);
        let what = elided(ui, &art.what, [0; 2], &small, name_rect.width());
        let below = pos2(name_rect.left(), middle + 9.0 * self.scale);
        painter.text(below, Align2::LEFT_CENTER, what, small, self.faint);
    }
}

/// The name in the list: the CIE's 5 nm tables have the names of its 1 nm tables.
pub(super) fn row_name(entry: &Entry) -> String {
    let is_coarse = entry
        .key
        .split_once('/')
        .is_some_and(|(group, _)| group.ends_with("_5nm") && group.starts_with("cie_"));
    if is_coarse {
        format!("{}, 5 nm", entry.name())
    } else {
        entry.name().to_owned()
    }
}

/// Draws a small curve: heights 0-1 from the left to the right of a field.
pub(super) fn draw_curve(ui: &Ui, rect: Rect, heights: &[f32], stroke: Stroke) {
    let step = rect.width() / (heights.len().max(2) - 1) as f32;
    let points: Vec<_> = heights
        .iter()
        .enumerate()
        .map(|(i, h)| {
            pos2(
                rect.left() + i as f32 * step,
                rect.bottom() - h * rect.height(),
            )
        })
        .collect();
    ui.painter().add(Shape::line(points, stroke));
}

/// A name cut to a width, with an ellipsis in its middle: what tells names apart is often at the
/// end. Of letters that the names of a file have in common `[at the beginning, at the end]` only
/// what there is room for is left.
pub(super) fn elided(
    ui: &Ui,
    text: &str,
    [head, tail]: [usize; 2],
    font: &FontId,
    width: f32,
) -> String {
    let fits = |text: &str| {
        let galley = ui
            .painter()
            .layout_no_wrap(text.to_owned(), font.clone(), Color32::WHITE);
        galley.size().x <= width
    };
    if fits(text) {
        return text.to_owned();
    }
    let mut letters: Vec<char> = text.chars().collect();
    if head + tail > 0 && head + tail < letters.len() {
        let own = &letters[head..letters.len() - tail];
        let dots = |count: usize| if count > 0 { "…" } else { "" };
        let own: String = own.iter().collect();
        let own = format!("{}{own}{}", dots(head), dots(tail));
        if fits(&own) {
            return own;
        }
        letters = own.chars().collect();
    }
    let cut = |kept: usize| -> String {
        let (head, tail) = (kept.div_ceil(2), kept / 2);
        letters[..head]
            .iter()
            .chain(['…'].iter())
            .chain(&letters[letters.len() - tail..])
            .collect()
    };
    let (mut good, mut too_many) = (0, letters.len());
    while too_many - good > 1 {
        let middle = usize::midpoint(good, too_many);
        if fits(&cut(middle)) {
            good = middle;
        } else {
            too_many = middle;
        }
    }
    cut(good)
}

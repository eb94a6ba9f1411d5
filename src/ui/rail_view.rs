//! The rail: the places of the window, named after what a person asks.

use eframe::egui;
use egui::{Align2, Color32, Painter, Pos2, Rect, Sense, Stroke, Ui, pos2, vec2};

use super::{kit::named_choice, theme::Theme};
use crate::app::{pages::Place, workspace::Preferences};

/// Width of the rail with words and without, points.
pub(super) const WIDTHS: [f32; 2] = [80.0, 56.0];

/// Height of an entry with its word and without, points.
const HEIGHTS: [f32; 2] = [64.0, 48.0];

/// Draws the rail and changes the page.
pub(super) fn show(ui: &mut Ui, preferences: &mut Preferences, has_words: bool, theme: Theme) {
    ui.spacing_mut().item_spacing.y = 4.0;
    ui.add_space(4.0);
    for (number, place) in Place::ALL.into_iter().enumerate() {
        let is_here = preferences.page.place() == place;
        let height = HEIGHTS[usize::from(!has_words)];
        let size = vec2(ui.available_width(), height);
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        named_choice(&response, egui::Role::Button, is_here, place.title());
        let visuals = ui.visuals();
        let field = rect.shrink2(vec2(6.0, 2.0));
        let ink = if is_here {
            ui.painter()
                .rect_filled(field, 4.0, visuals.selection.bg_fill);
            let mark = Rect::from_min_size(rect.min, vec2(3.0, rect.height()));
            ui.painter().rect_filled(mark, 0.0, theme.accent);
            visuals.selection.stroke.color
        } else if response.hovered() || response.has_focus() {
            let fill = visuals.widgets.hovered.bg_fill;
            ui.painter().rect_filled(field, 4.0, fill);
            visuals.strong_text_color()
        } else {
            visuals.text_color()
        };
        let middle = if has_words {
            pos2(rect.center().x, rect.top() + 25.0)
        } else {
            rect.center()
        };
        icon(ui.painter(), place, middle, ink);
        if has_words {
            let mut font = egui::TextStyle::Small.resolve(ui.style());
            let title = place.title().to_owned();
            let wide = ui.painter().layout_no_wrap(title, font.clone(), ink);
            // A longer word than there is room for is smaller.
            font.size *= ((rect.width() - 4.0) / wide.size().x.max(1.0)).min(1.0);
            let at = pos2(rect.center().x, rect.bottom() - 14.0);
            ui.painter()
                .text(at, Align2::CENTER_CENTER, place.title(), font, ink);
        }
        if response.clicked() && !is_here {
            preferences.go_to(place);
        }
        let words = tr!(
            "{place}: {question} (Ctrl+{number})",
            place = place.title(),
            question = place.asks(),
            number = number + 1
        );
        response.on_hover_text(words);
    }
}

/// A place as a few lines in a field of 24 points.
fn icon(painter: &Painter, place: Place, middle: Pos2, ink: Color32) {
    let stroke = Stroke::new(1.75, ink);
    let line = |points: &[[f32; 2]]| {
        let points = points.iter().map(|[x, y]| middle + vec2(*x, *y)).collect();
        painter.add(egui::Shape::line(points, stroke));
    };
    let frame = |x: f32, y: f32| line(&[[-x, -y], [x, -y], [x, y], [-x, y], [-x, -y]]);
    match place {
        Place::Learn => {
            for side in [-1.0, 1.0] {
                line(&[[0.0, -6.0], [side * 5.0, -8.0], [side * 9.0, -7.0]]);
                line(&[
                    [side * 9.0, -7.0],
                    [side * 9.0, 6.0],
                    [side * 5.0, 5.0],
                    [0.0, 8.0],
                ]);
            }
            line(&[[0.0, -6.0], [0.0, 8.0]]);
        }
        Place::Look => line(&[
            [-9.0, 8.0],
            [-5.0, 6.0],
            [-3.0, -9.0],
            [-1.0, 5.0],
            [2.0, 3.0],
            [4.0, -4.0],
            [6.0, 6.0],
            [9.0, 8.0],
        ]),
        Place::Through => {
            line(&[[-10.0, 0.0], [-4.0, 0.0]]);
            line(&[[4.0, 0.0], [10.0, 0.0]]);
            frame(3.0, 9.0);
        }
        Place::Quality => {
            // A lamp.
            painter.circle_stroke(middle - vec2(0.0, 2.5), 6.5, stroke);
            line(&[[-3.0, 6.0], [3.0, 6.0]]);
            line(&[[-2.0, 9.0], [2.0, 9.0]]);
        }
        Place::Design => {
            // Three faders.
            for (x, y) in [(-7.0, 3.0), (0.0, -4.0), (7.0, 1.0)] {
                line(&[[x, -9.0], [x, 9.0]]);
                line(&[[x - 3.0, y], [x + 3.0, y]]);
            }
        }
        Place::Numbers => {
            for at in [-3.0, 3.0] {
                line(&[[at + 2.0, -9.0], [at - 2.0, 9.0]]);
                line(&[[-9.0, at], [9.0, at]]);
            }
        }
        Place::Picture => {
            frame(10.0, 8.0);
            line(&[
                [-10.0, 5.0],
                [-3.0, -2.0],
                [3.0, 4.0],
                [6.0, 1.0],
                [10.0, 5.0],
            ]);
            painter.circle_stroke(middle + vec2(5.0, -3.5), 1.8, stroke);
        }
    }
}

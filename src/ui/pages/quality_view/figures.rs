//! The page "Figures": the light's verdict, surfaces, twelve figures in large type, all in a table.

use eframe::egui;
use egui::{
    Align, CollapsingHeader, Color32, Label, Layout, Rect, RichText, Sense, TextStyle, Ui, pos2,
    vec2,
};

use crate::{
    app::{
        CLIENTS_TABLES, GROUPS, IN_GROUP, QualityShown, Tile, Told, chart::Ink,
        quality_report::Row, verdicts::Seen,
    },
    languages::{said, with_colon},
    ui::{
        kit::{Column, Row as TableRow, bounded, cut_words, drawing, headline, scrolled, table},
        lit_field::{self, Field, from_references},
        pages::PageContext,
        theme::{Theme, of_seen},
    },
};

/// From this width on the groups of figures stand side by side, points.
const GROUPS_BESIDE: f32 = 620.0;
/// Least width of a surface with its name, points.
const LEAST_FIELD: f32 = 84.0;
/// Height of a surface's colours: least and largest, points.
const COLOURS: [f32; 2] = [56.0, 220.0];
/// From this height on the table of all figures is open, points.
const HIGH: f32 = 760.0;
/// Height of a bar, points.
const BAR: f32 = 8.0;

/// What the fold over all figures is called.
pub(super) const ALL: &str = later!("All figures");

/// Draws the page.
pub(super) fn show(ui: &mut Ui, context: &mut PageContext<'_>, shown: &QualityShown) {
    let theme = context.theme;
    headline(ui, theme, &shown.sentence);
    for words in &shown.more {
        ui.add(Label::new(RichText::new(words).color(theme.faint)).wrap());
    }
    ui.add_space(8.0);
    let room = ui.available_size();
    scrolled(ui, "quality", |ui| {
        surfaces(ui, theme, shown, room.y);
        ui.add_space(12.0);
        if shown.sides.len() > 1 {
            legend(ui, theme, shown);
        }
        groups(ui, theme, shown);
        ui.add_space(12.0);
        let words = RichText::new(format!("{} ({})", said(ALL), shown.rows.len())).strong();
        CollapsingHeader::new(words)
            .id_salt(ALL)
            .default_open(room.y >= HIGH * theme.scale)
            .show(ui, |ui| all_figures(ui, theme, shown));
    });
}

/// The surfaces that a client asks for, large.
fn surfaces(ui: &mut Ui, theme: Theme, shown: &QualityShown, height: f32) {
    let board = &shown.surfaces;
    if board.is_empty() {
        return;
    }
    let names = shown.sides.iter().map(|side| side.name.as_str());
    let lights = lit_field::referenced(board, names);
    ui.add(
        Label::new(
            RichText::new(lit_field::caption(&lights))
                .small()
                .color(theme.faint),
        )
        .wrap(),
    );
    ui.add_space(2.0);
    let room = ui.available_width();
    let fits = ((room + lit_field::GAP) / (LEAST_FIELD * theme.scale + lit_field::GAP)) as usize;
    // All in a row, in two or in four.
    let in_row = match fits {
        8.. => 8,
        4..8 => 4,
        _ => 2,
    };
    let width = lit_field::width(room, in_row);
    let colours = bounded(0.2 * height, COLOURS[0], COLOURS[1] * theme.scale);
    let size = lit_field::size(ui, width, colours);
    for first in (0..board.len()).step_by(in_row) {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = lit_field::GAP;
            let sources = CLIENTS_TABLES.iter().enumerate();
            for (i, source) in sources.skip(first).take(in_row) {
                let lit: Vec<_> = board.surface(i).collect();
                let field = Field {
                    said: from_references(&lit, &lights),
                    lit,
                    lights_up: false,
                    source,
                };
                field.show(ui, size, theme);
            }
        });
    }
}

/// Which bar is whose.
fn legend(ui: &mut Ui, theme: Theme, shown: &QualityShown) {
    ui.horizontal_wrapped(|ui| {
        for (side, ink) in shown.sides.iter().zip(inks(ui, theme)) {
            let size = vec2(12.0, 12.0) * theme.scale;
            let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
            ui.painter().rect_filled(rect, 2.0, ink);
            ui.label(&side.name);
            ui.add_space(8.0);
        }
    });
    ui.add_space(4.0);
}

/// The inks of both lights.
fn inks(ui: &Ui, theme: Theme) -> [Color32; 2] {
    [ui.visuals().strong_text_color(), theme.ink(Ink::Second)]
}

fn groups(ui: &mut Ui, theme: Theme, shown: &QualityShown) {
    let gap = 24.0;
    let beside = ui.available_width() >= GROUPS_BESIDE * theme.scale;
    let count = if beside { GROUPS.len() } else { 1 };
    let width = (ui.available_width() - gap * (count - 1) as f32) / count as f32;
    let groups: Vec<_> = GROUPS.iter().zip(shown.tiles.chunks(IN_GROUP)).collect();
    for row in groups.chunks(count) {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            for (title, tiles) in row {
                ui.allocate_ui_with_layout(vec2(width, 0.0), Layout::top_down(Align::Min), |ui| {
                    ui.set_width(width);
                    ui.label(RichText::new(said(title)).strong());
                    ui.add_space(2.0);
                    for tile in *tiles {
                        self::tile(ui, theme, tile, shown);
                    }
                });
            }
        });
    }
}

/// A figure with its bar and its word.
fn tile(ui: &mut Ui, theme: Theme, tile: &Tile, shown: &QualityShown) {
    let small = ui.text_style_height(&TextStyle::Small);
    let large = 20.0 * theme.scale;
    let line = large + 4.0;
    let rows = tile.sides.len() as f32;
    let words = if tile.sides.len() > 1 {
        0.0
    } else {
        small + 2.0
    };
    let size = vec2(
        ui.available_width(),
        small + 2.0 + rows * line + words + 10.0,
    );
    let (rect, response) = drawing(ui, size, Sense::hover(), &read_out(tile, shown));
    if ui.is_rect_visible(rect) {
        let rule = ui.visuals().widgets.noninteractive.bg_stroke;
        ui.painter().hline(rect.x_range(), rect.top(), rule);
        let top = rect.top() + 3.0;
        let font = TextStyle::Small.resolve(ui.style());
        let title = cut_words(
            ui,
            tile.title,
            font.clone(),
            theme.faint,
            0.56 * rect.width(),
        );
        ui.painter()
            .galley(pos2(rect.left(), top), title, theme.faint);
        let doubt = match &tile.sides[..] {
            [told] if !told.half.is_empty() => format!("{} {}", said(tile.figure), told.half),
            _ => said(tile.figure).to_owned(),
        };
        let figure = cut_words(ui, &doubt, font.clone(), theme.faint, 0.42 * rect.width());
        let at = pos2(rect.right() - figure.size().x, top);
        ui.painter().galley(at, figure, theme.faint);
        for (i, told) in tile.sides.iter().enumerate() {
            let top = top + small + 2.0 + i as f32 * line;
            let row = Rect::from_min_size(pos2(rect.left(), top), vec2(rect.width(), line));
            side(ui, theme, (tile, told, i), row);
        }
        if let [told] = &tile.sides[..] {
            let ink = ui.visuals().text_color();
            let words = cut_words(ui, &told.word, font, ink, rect.width());
            let at = pos2(rect.left(), top + small + 2.0 + line);
            ui.painter().galley(at, words, ink);
        }
    }
    let words = tile.sides.iter().zip(&shown.sides);
    let words =
        words.map(|(told, side)| with_colon(&side.name, format!("{}, {}", told.told(), told.word)));
    let words: Vec<String> = words.collect();
    response.on_hover_text(format!("{}\n{}", tile.why, words.join("\n")));
}

/// A light's number and bar, and whether it is the better one.
fn side(ui: &Ui, theme: Theme, (tile, told, place): (&Tile, &Told, usize), row: Rect) {
    let painter = ui.painter();
    let many = tile.sides.len() > 1;
    let wins = tile.better == Some(place);
    let strong = ui.visuals().strong_text_color();
    let ink = match many && !wins && tile.better.is_some() {
        true => ui.visuals().text_color(),
        false => strong,
    };
    let number = if many { 16.0 } else { 20.0 } * theme.scale;
    let mut font = TextStyle::Body.resolve(ui.style());
    // Known to many digits it stays whole.
    font.size = if told.shown.len() > 6 {
        0.8 * number
    } else {
        number
    };
    let taken = 76.0 * theme.scale;
    let words = cut_words(ui, &told.shown, font, ink, taken - 6.0);
    let at = pos2(row.left(), row.center().y - words.size().y / 2.0);
    painter.galley(at, words, ink);
    let right = if many { 50.0 * theme.scale } else { 0.0 };
    let bar = Rect::from_min_max(
        pos2(row.left() + taken, row.center().y - BAR * theme.scale / 2.0),
        pos2(
            row.right() - right,
            row.center().y + BAR * theme.scale / 2.0,
        ),
    );
    if bar.width() > 4.0 {
        let own = inks(ui, theme)[place.min(1)];
        let graded = told
            .grade
            .map(|grade| of_seen(Seen::ALL[grade.min(3)], theme.dark));
        let fill = if many {
            own
        } else {
            graded.unwrap_or(theme.accent)
        };
        self::bar(ui, theme, (tile, told), bar, fill);
    }
    if wins {
        let small = TextStyle::Small.resolve(ui.style());
        let at = pos2(row.right(), row.center().y);
        let good = of_seen(Seen::Hardly, theme.dark);
        painter.text(at, egui::Align2::RIGHT_CENTER, said!("better"), small, good);
    }
}

fn bar(ui: &Ui, theme: Theme, (tile, told): (&Tile, &Told), rect: Rect, fill: Color32) {
    let painter = ui.painter();
    painter.rect_filled(rect, 3.0, theme.track.gamma_multiply(0.55));
    let [low, high] = tile.ends;
    let x = |value: f64| {
        let share = ((value - low) / (high - low)).clamp(0.0, 1.0);
        rect.left() + share as f32 * rect.width()
    };
    let from = x(tile.from);
    if tile.from > low {
        let middle = from - 0.5..=from + 0.5;
        let tick = Rect::from_x_y_ranges(middle, rect.y_range().expand(3.0));
        painter.rect_filled(tick, 0.0, theme.faint);
    }
    if let Ok(value) = told.value {
        // A value at the bar's beginning is seen as well.
        let to = x(value);
        let (left, right) = (from.min(to), from.max(to).max(from.min(to) + 2.0));
        let filled = Rect::from_x_y_ranges(left..=right, rect.y_range());
        painter.rect_filled(filled, 3.0, fill);
    }
}

/// A figure read out.
fn read_out(tile: &Tile, shown: &QualityShown) -> String {
    let each = tile.sides.iter().zip(&shown.sides);
    let each = each.enumerate().map(|(i, (told, side))| {
        let words = format!(
            "{} {} {}, {}",
            side.name,
            told.told(),
            said(tile.figure),
            told.word
        );
        match tile.better == Some(i) {
            true => tr!("{words}, better", words),
            false => words,
        }
    });
    let each: Vec<String> = each.collect();
    with_colon(tile.title, each.join("; "))
}

/// Every figure in a table.
fn all_figures(ui: &mut Ui, theme: Theme, shown: &QualityShown) {
    let first = said!("Point at a row for the standard that it follows.");
    let whole = said!("Of the whole table as it was measured.");
    let [one, other, meaning] = match (&shown.sides[..], shown.second()) {
        ([first, ..], Some(second)) => [first.name.as_str(), second, whole],
        _ => [
            said!("measured"),
            said!("model"),
            said!("Of the smooth part and the lines together."),
        ],
    };
    let columns = [
        Column::words(said!("figure"), first, 2.2),
        Column::numbers(one, whole, 1.2),
        Column::numbers(other, meaning, 1.2),
        Column::words(
            said!("what it says"),
            said!("Of the first light as measured."),
            4.0,
        ),
    ];
    let rows: Vec<TableRow> = shown.rows.iter().map(figure_row).collect();
    table(ui, &columns, &rows, None, false, theme);
    ui.add_space(6.0);
    for note in &shown.sheet.measured.notes {
        ui.small(note);
    }
}

/// A row of the table of figures: of the light as measured, and what stands beside it.
fn figure_row(of: &[Row; 2]) -> TableRow {
    let first = &of[0];
    let why = |row: &Row| row.value.clone().err().unwrap_or_default();
    let reading = match &first.value {
        Ok(_) => first.reading.clone(),
        Err(why) => why.clone(),
    };
    let title = std::iter::once(first.figure.title().to_owned());
    TableRow {
        name: format!("{}: {}", first.figure.title(), first.shown()),
        cells: title
            .chain(of.iter().map(Row::shown))
            .chain([reading.clone()])
            .collect(),
        note: first.figure.meaning().to_owned(),
        tips: std::iter::once(String::new())
            .chain(of.iter().map(why))
            .chain([reading])
            .collect(),
        ..TableRow::default()
    }
}
